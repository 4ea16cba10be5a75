"""The first minute: the card over the window, and the three things to try."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QToolButton

from app.document.document import Document, write
from app.model.projection import Perspective
from app.scenes.scene import BUILT_IN, load
from tests import PATIENCE_MS
from tests.support.layout import cut, overlapping
from tests.support.window import MakeWindow, seen, settle
from widgets.window import start_card
from widgets.window.main_window import MainWindow
from widgets.window.settings import Settings
from widgets.window.start_card import StartCard


def opened(window: MainWindow) -> StartCard:
    """The card over a window."""
    window.menus.start_card.trigger()
    settle()
    card = window.start_card
    assert card is not None and card.isVisible()
    return card


def button(card: StartCard, text: str) -> QToolButton:
    return next(b for b in card.findChildren(QToolButton) if text in (b.text(), b.accessibleName()))


def is_gone(window: MainWindow) -> bool:
    settle()
    return window.start_card is None and not any(
        card.isVisible() for card in window.findChildren(StartCard)
    )


def is_drawn(tile: QToolButton) -> bool:
    """Whether it has its picture, not only room for it."""
    return tile.icon().pixmap(144, 81).toImage().pixelColor(2, 2).alpha() == 255


def test_it_has_every_scene_as_a_picture(window: MainWindow, qtbot: Any) -> None:
    card = opened(window)
    assert list(card.tiles) == list(BUILT_IN)
    settle()
    before = [tile.geometry() for tile in card.tiles.values()]
    qtbot.waitUntil(
        lambda: all(is_drawn(tile) for tile in card.tiles.values()), timeout=PATIENCE_MS
    )
    assert [tile.geometry() for tile in card.tiles.values()] == before, "none moves"
    pictures = [tile.icon().pixmap(144, 81).toImage() for tile in card.tiles.values()]
    assert len({bytes(picture.constBits()) for picture in pictures}) == len(BUILT_IN)
    for size in ((1280, 720), (1366, 768)):
        window.resize(*size)
        settle()
        assert card.geometry() == window.rect()
        assert cut(card) == [] and overlapping(card) == []


def test_a_click_on_a_scene_opens_it(window: MainWindow) -> None:
    card = opened(window)
    QTest.mouseClick(card.tiles["depth-buffer"], Qt.MouseButton.LeftButton)
    assert is_gone(window) and window.store.document.scene == "depth-buffer"
    assert window.slots.large == "image"


@pytest.mark.parametrize("way", ["escape", "beside", "cross"])
def test_one_click_or_escape_sends_it_away(window: MainWindow, way: str) -> None:
    before = window.store.document
    card = opened(window)
    if way == "escape":
        QTest.keyClick(window, Qt.Key.Key_Escape)
    elif way == "beside":
        QTest.mouseClick(card, Qt.MouseButton.LeftButton, pos=QPoint(3, card.height() - 3))
    else:
        QTest.mouseClick(button(card, "Close"), Qt.MouseButton.LeftButton)
    assert is_gone(window) and window.store.document == before


def test_recent_files_are_there_and_open(make_window: MakeWindow, tmp_path: Path) -> None:
    path = tmp_path / "lesson with a rather long name that has no room.json"
    write(Document("cube", load("cube").start), path)
    settings = Settings(None)
    settings.recent = [str(path), *(str(tmp_path / f"{i}.json") for i in range(9))]
    window = make_window(settings=settings)
    card = opened(window)
    found = button(card, path.name)
    assert found.toolTip() == str(path) and path.name not in found.text()
    assert not [b for b in card.findChildren(QToolButton) if b.text() == "8.json"]
    QTest.mouseClick(found, Qt.MouseButton.LeftButton)
    assert is_gone(window) and window.store.document.scene == "cube"


def test_the_switch_is_kept(make_window: MakeWindow, own_home: Path) -> None:
    settings = Settings(own_home / "own.ini")
    assert settings.start_card
    window = make_window(settings=settings)
    card = opened(window)
    (always,) = card.findChildren(QCheckBox)
    assert always.isChecked()
    always.click()
    assert not Settings(own_home / "own.ini").start_card


def test_a_scene_that_cannot_be_drawn_is_there_by_its_name(
    window: MainWindow, qtbot: Any, monkeypatch: pytest.MonkeyPatch, caplog: Any
) -> None:
    whole = load

    def broken(name: str) -> Any:
        if name == "cube":
            raise RuntimeError("no picture of it")
        return whole(name)

    monkeypatch.setattr(start_card, "load", broken)
    card = opened(window)
    last = card.tiles[BUILT_IN[-1]]
    qtbot.waitUntil(lambda: is_drawn(last), timeout=PATIENCE_MS)
    assert not is_drawn(card.tiles["cube"]) and "cube cannot be drawn" in caplog.text
    QTest.mouseClick(card.tiles["cube"], Qt.MouseButton.LeftButton)
    assert window.store.document.scene == "cube"


def test_the_three_things_tick_themselves_off_and_go(
    window: MainWindow, qtbot: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(start_card, "SEEN_DONE_MS", 0)
    steps = window.first_steps
    opened(window)
    QTest.keyClick(window, Qt.Key.Key_Escape)
    settle()
    assert steps.isVisible() and window.rect().contains(steps.geometry())
    done = lambda: [step.isChecked() for step in steps.steps.values()]  # noqa: E731
    assert done() == [False] * 3
    lens = window.store.document.projection.lens
    window.store.set_projection(seen(window, lens=Perspective(50.0, lens.near, lens.far)))
    assert done() == [False] * 3, "only another near ticks"
    window.store.set_projection(seen(window, lens=Perspective(50.0, 2.0, lens.far)))
    assert done() == [True, False, False]
    QTest.keyClick(window.panes["world"].canvas, Qt.Key.Key_Left)
    assert done() == [True, True, False]
    QTest.mouseDClick(window.panes["ndc"].header, Qt.MouseButton.LeftButton, pos=QPoint(5, 5))
    assert done() == [True, True, True]
    qtbot.waitUntil(lambda: not steps.isVisible(), timeout=PATIENCE_MS)
