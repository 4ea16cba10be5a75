"""The first minute: the card over the window, with scenes, lessons and files."""

from pathlib import Path

import pytest
from PySide6.QtCore import QSize, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QCheckBox, QToolButton

from app.document.document import Document
from app.document.files import write
from app.lessons.contents import CONTENT, contained
from app.lessons.lesson import head_of, read
from app.lessons.player import Progress
from app.scenes.scene import BUILT_IN, load
from tests.pictures import MOST_DIFFERENT, different, draw_tile
from tests.support.layout import cut, overlapping
from tests.support.window import MakeWindow, activate, click, settle
from widgets.window import start_card
from widgets.window.main_window import MainWindow
from widgets.window.settings import Settings
from widgets.window.start_card import TILES, StartCard, tile_path


def opened(window: MainWindow) -> StartCard:
    """The card over a window."""
    window.menus.start_card.trigger()
    settle()
    card = window.cover
    assert card is not None and card.isVisible()
    return card


def button(card: StartCard, text: str) -> QToolButton:
    return next(b for b in card.findChildren(QToolButton) if text in (b.text(), b.accessibleName()))


def is_gone(window: MainWindow) -> bool:
    settle()
    return window.cover is None and not any(
        card.isVisible() for card in window.findChildren(StartCard)
    )


def test_it_has_every_scene_as_a_picture(window: MainWindow) -> None:
    card = opened(window)
    assert list(card.tiles) == list(BUILT_IN)
    for ratio in (1.0, 2.0):
        pictures = [t.icon().pixmap(QSize(144, 81), ratio).toImage() for t in card.tiles.values()]
        assert {(p.width(), p.height()) for p in pictures} == {(144 * ratio, 81 * ratio)}
        assert len({bytes(picture.constBits()) for picture in pictures}) == len(BUILT_IN)
    for size in ((1280, 720), (1366, 768)):
        window.resize(*size)
        settle()
        assert card.geometry() == window.rect()
        assert cut(card) == [] and overlapping(card) == []
        widths = [tile.sizeHint().width() for tile in card.tiles.values()]
        assert max(widths) < 1.3 * 144, "a long title has two lines"


@pytest.mark.parametrize("dark", [False, True])
def test_the_pictures_are_what_the_program_draws(dark: bool, tmp_path: Path) -> None:
    known = {tile_path(name, dark=each) for name in BUILT_IN for each in (False, True)}
    assert set(TILES.glob("*.png")) == known
    for name in BUILT_IN[dark::2]:  # one that changes does so in both palettes
        drawn, shipped = tmp_path / "drawn.png", tile_path(name, dark=dark)
        draw_tile(name, drawn, dark=dark)
        assert different(shipped, drawn) <= MOST_DIFFERENT, f"tests.pictures --tiles {name}"


def test_a_dark_window_has_dark_pictures(window: MainWindow) -> None:
    corners = []
    for theme in ("light", "dark"):
        window.look.set_theme(theme)
        tile = opened(window).tiles["letter-f"]
        corners.append(tile.icon().pixmap(144, 81).toImage().pixelColor(2, 2).lightness())
    assert corners[0] > 200 and corners[1] < 50


@pytest.mark.undrawn
def test_a_click_on_a_scene_opens_it(window: MainWindow) -> None:
    card = opened(window)
    click(card.tiles["depth-buffer"])
    assert is_gone(window) and window.store.document.scene == "depth-buffer"
    assert window.slots.large == "image"


@pytest.mark.undrawn
def test_one_click_or_escape_closes_it(window: MainWindow) -> None:
    before = window.store.document
    for act in (
        lambda _card: QTest.keyClick(window, Qt.Key.Key_Escape),
        lambda card: click(card, (3, card.height() - 3)),  # beside it
        lambda card: click(button(card, "Close")),
    ):
        act(opened(window))
        assert is_gone(window) and window.store.document == before


@pytest.mark.undrawn
def test_recent_files_are_there_and_open(make_window: MakeWindow, tmp_path: Path) -> None:
    path, lesson = tmp_path / "document with a rather long name.json", tmp_path / "l1.md"
    write(Document("cube", load("cube").start), path)
    lesson.write_text("---\ntitle: How wide?\n---\n# One {#one}\n", encoding="utf-8")
    settings = Settings(None)
    talk = CONTENT / "talk-000.md"
    paths = [path, lesson, talk, *(tmp_path / f"{i}.md" for i in range(9))]
    settings.recent = [str(each) for each in paths]
    window = make_window(settings=settings)
    card = opened(window)
    assert [button(card, name).text() for name in ("l1.md", "0.md")] == ["How wide?", "0.md"]
    title = head_of(talk).title
    found = button(card, talk.name)
    assert found.text().split() == title.split() and "\n" in found.text()
    assert found.toolTip() == f"{title} – {talk}"
    found = button(card, path.name)
    assert found.toolTip() == str(path) and found.text().replace("\n", " ") == path.name
    assert not [b for b in card.findChildren(QToolButton) if b.text() == "8.md"]
    click(found)
    assert is_gone(window) and window.store.document.scene == "cube"


@pytest.mark.undrawn
def test_the_switch_is_kept(make_window: MakeWindow, own_home: Path) -> None:
    card = opened(make_window(settings=Settings(own_home / "own.ini")))
    (always,) = card.findChildren(QCheckBox)
    assert always.isChecked()
    always.click()
    assert not Settings(own_home / "own.ini").start_card


@pytest.mark.undrawn
def test_a_scene_without_a_picture_is_there_by_its_name(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(start_card, "TILES", tmp_path)
    card = opened(window)
    click(card.tiles["cube"])
    assert window.store.document.scene == "cube"


@pytest.mark.undrawn
def test_lessons_talks_and_the_tour_open_from_it(window: MainWindow) -> None:
    kept = Progress(step="", answers={}, done=2, of=7)
    window.settings.keep_progress("l03-field-of-view", kept)
    window.settings.keep_progress("l04-view-volumes", Progress(done=6, of=6))
    card = opened(window)
    heads = [read(path) for path in contained() if path.stem.startswith("l")]
    for text, count in (("Lessons", len(heads)), ("Talks", 5)):
        menu = button(card, text).menu()
        menu.aboutToShow.emit()
        assert len(menu.actions()) == count
    lessons = button(card, "Lessons").menu().actions()
    assert [action.text().partition("\t")[0] for action in lessons] == [
        " ".join((*head.topics[:1], head.title)) for head in heads
    ]
    marks = [action.text().partition("\t")[2] for action in lessons]
    assert marks == ["", "", "2/7", "done", *[""] * (len(heads) - 4)]
    lessons[4].trigger()
    assert is_gone(window) and window.lessons.lesson == heads[4]
    QTest.mouseClick(button(opened(window), "Two-minute tour"), Qt.MouseButton.LeftButton)
    assert is_gone(window)
    assert window.lessons.lesson is not None and len(window.lessons.lesson.steps) == 6


@pytest.mark.undrawn
def test_tab_goes_round_the_card_and_not_under_it(window: MainWindow) -> None:
    activate(window)
    card = opened(window)
    for key in (Qt.Key.Key_Backtab, *(Qt.Key.Key_Tab,) * (len(card.findChildren(QToolButton)) + 2)):
        QTest.keyClick(QApplication.focusWidget(), key)
        assert card.isAncestorOf(QApplication.focusWidget())
