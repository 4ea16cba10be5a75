"""The panels under the panes: folded, one open at a time."""

from __future__ import annotations

from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QLabel, QToolButton
from pytestqt.qtbot import QtBot

from app.document.document import Document
from app.model.projection import Perspective
from app.scenes.scene import load
from tests.support.window import click, drag, settle
from widgets.parts.panel import EVERYTHING, Changed, Panel, ShownData
from widgets.window.drawer import Panels
from widgets.window.main_window import MainWindow

pytestmark = pytest.mark.undrawn


class Toy(Panel):
    """Notes what it is told, and whether it was to be seen then."""

    def __init__(self) -> None:
        super().__init__()
        self.heard: list[tuple[ShownData, Changed, bool]] = []

    def take(self, shown: ShownData, changed: Changed) -> None:
        self.heard.append((shown, changed, self.isVisible()))


def test_a_folded_panel_hears_of_nothing_until_it_is_opened(qtbot: QtBot) -> None:
    panels, first, second = Panels(), Toy(), Toy()
    panels.add("One", first, "")
    panels.add("Two", second, "")
    qtbot.addWidget(panels)
    document, scene = Document("cube"), load("cube")

    def tell(document: Document) -> ShownData:
        shown = ShownData(document, scene, None)
        panels.keep(shown)
        panels.notify()
        return shown

    start = tell(document)
    panels.open(first)
    qtbot.waitExposed(panels)
    assert first.heard == [(start, EVERYTHING, False)], "before it appears"
    tell(document)
    assert len(first.heard) == 1, "nothing has changed"
    document = replace(
        document, projection=replace(document.projection, lens=Perspective(near=0.5))
    )
    near = tell(document)
    assert first.heard[1:] == [(near, frozenset({"lens"}), True)]
    panels.open(None)
    tell(replace(document, quality=replace(document.quality, detail=0.5)))
    document = replace(document, projection=replace(document.projection, image_size=(640, 480)))
    last = tell(document)
    assert len(first.heard) == 2 and not second.heard
    panels.open(first)
    assert first.heard[2:] == [(last, frozenset({"image_size"}), False)], "what has gone back, has"
    panels.open(second)
    assert second.heard == [(last, EVERYTHING, False)]


def test_one_panel_is_open_at_a_time(qtbot: QtBot) -> None:
    panels = Panels()
    first, second = QLabel("first"), QLabel("second")
    panels.add("One", first, "the first")
    panels.add("Two", second, "the second")
    for each in (panels, panels.names):
        qtbot.addWidget(each)
    panels.names.show()
    one, two = panels.names.findChildren(QToolButton)
    assert [one.text(), two.text(), one.toolTip()] == ["One", "Two", "the first"]
    assert panels.open_panel is None
    assert not first.isVisible() and not second.isVisible()
    with qtbot.waitSignal(panels.opened):
        qtbot.mouseClick(two, Qt.MouseButton.LeftButton)
    assert panels.open_panel is second and second.isVisible() and not first.isVisible()
    assert two.isChecked() and not one.isChecked()
    qtbot.mouseClick(one, Qt.MouseButton.LeftButton)
    assert panels.open_panel is first and not second.isVisible() and not two.isChecked()
    qtbot.mouseClick(one, Qt.MouseButton.LeftButton)
    assert panels.open_panel is None and not first.isVisible() and not one.isChecked()
    for key in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
        qtbot.keyClick(one, key)
        assert (panels.open_panel is first) == one.isChecked() == (key != Qt.Key.Key_Enter)


def test_the_names_stand_still_and_a_panel_has_at_most_a_third(window: MainWindow) -> None:
    names = window.panels.names.findChildren(QToolButton)

    def places() -> list[QPoint]:
        settle()
        return [name.mapTo(window, QPoint()) for name in names]

    for size in [(1280, 720), (1920, 1080)]:
        window.resize(*size)
        before, panes = places(), [pane.geometry() for pane in window.panes.values()]
        assert len(before) == len(window.panels.all)
        assert before[0].y() > size[1] - 60, "at the bottom"
        found = set()
        for name in names:
            click(name)
            assert places() == before and window.size().toTuple() == size
            found.add(window.panels.height())
        assert found == {size[1] // 3}
        click(names[-1])
        assert places() == before and not window.panels.isVisible()
        assert [pane.geometry() for pane in window.panes.values()] == panes


def test_an_open_panel_has_its_part_of_a_window_that_grows(window: MainWindow) -> None:
    window.resize(1366, 768)
    window.panels.open(window.matrices)
    settle()
    assert window.panels.height() == 768 // 3
    window.resize(1920, 1050)
    settle()
    assert window.panels.height() == 1050 // 3
    drag(window.drawer, 1, QPoint(0, 100))
    assert window.panels.height() == 250
    window.resize(1920, 1049)  # by a hair, as when it is moved from screen to screen
    window.resize(1920, 1060)
    settle()
    assert window.panels.height() == pytest.approx(250 / 1050 * 1060, abs=1.0)


def test_a_dragged_height_stays(window: MainWindow) -> None:
    window.panels.open(window.matrices)
    settle()
    for away, taller in ((90, -90), (-40, 40), (-400, 50)):
        before = window.panels.height()
        drag(window.drawer, 1, QPoint(0, away))
        chosen = window.panels.height()
        assert chosen == before + taller, "never more than a third"
        for panel in (*window.panels.all, None, window.matrices):
            window.panels.open(panel)
            settle()
            assert panel is None or window.panels.height() == chosen
