"""The panels under the panes: folded, one open at a time."""

import itertools
from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractScrollArea,
    QApplication,
    QComboBox,
    QLabel,
    QScrollArea,
    QToolButton,
)
from pytestqt.qtbot import QtBot

from app.document.document import Document
from app.document.view import View
from app.model.projection import Perspective
from app.scenes.scene import load
from tests.support.window import activate, click, drag, settle, show_scene
from widgets.parts.panel import EVERYTHING, Changed, Panel, ShownData
from widgets.window.drawer import REST_MS, Panels
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
    names = [each for each in window.panels.names.findChildren(QToolButton) if each.isVisible()]

    def places() -> list[QPoint]:
        settle()
        return [name.mapTo(window, QPoint()) for name in names]

    for size in [(1280, 720), (1920, 1080)]:
        window.resize(*size)
        before, panes = places(), [pane.geometry() for pane in window.panes.values()]
        assert len(before) == len(window.panels.all) - 1, "the letter F has no explanation"
        assert before[0].y() > size[1] - 60, "at the bottom"
        found = set()
        for name in names:
            click(name)
            assert places() == before and window.size().toTuple() == size
            found.add(window.panels.height())
        assert max(found) == size[1] // 3
        click(names[-1])
        assert places() == before and not window.panels.isVisible()
        assert [pane.geometry() for pane in window.panes.values()] == panes


def test_an_open_panel_has_its_part_of_a_window_that_grows(window: MainWindow) -> None:
    window.resize(1366, 768)
    window.panels.open(window.measure_panel)
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
    window.panels.open(window.kinds_panel)
    settle()
    for away, taller in ((90, -90), (-40, 40), (-400, 50)):
        before = window.panels.height()
        drag(window.drawer, 1, QPoint(0, away))
        chosen = window.panels.height()
        assert chosen == before + taller, "never more than a third"
        for panel in (*window.panels.all, None, window.measure_panel, window.kinds_panel):
            window.panels.open(panel)
            settle()
            grown = panel in (window.measure_panel, window.kinds_panel)
            assert panel is None or window.panels.height() == chosen or not grown
            assert window.panels.height() <= chosen


def head(window: MainWindow, panel: Panel) -> QToolButton:
    """The name of a panel, which opens it."""
    heads = window.panels.names.findChildren(QToolButton)
    return heads[window.panels.all.index(panel)]


def test_a_panel_without_content_is_not_offered(window: MainWindow) -> None:
    show_scene(window, "clipping")
    click(head(window, window.scene_panel))
    assert window.panels.open_panel is window.scene_panel
    show_scene(window, "letter-f")
    assert window.panels.open_panel is None and not head(window, window.scene_panel).isVisible()
    window.store.open(Document("letter-f", load("letter-f").start, view=View(panel="scene")))
    settle()
    assert window.panels.open_panel is None
    show_scene(window, "clipping")
    assert head(window, window.scene_panel).isVisible()


def test_a_panel_is_as_high_as_its_content(window: MainWindow) -> None:
    window.resize(1366, 768)
    of_scenes = itertools.product(["letter-f", "similar-triangles", "clipping"], window.panels.all)
    for scene, panel in of_scenes:
        grown = {window.kinds_panel, window.measure_panel}
        if scene == "clipping":
            grown.add(window.scene_panel)
        window.panels.open(None)
        if window.store.document.scene != scene:
            show_scene(window, scene)
        if not head(window, panel).isVisible():
            continue
        click(head(window, panel))
        settle()
        high = window.panels.height()
        assert (high == 256) == (panel in grown), panel
        area = panel.parentWidget().parentWidget()
        assert isinstance(area, QScrollArea) and not area.verticalScrollBar().isVisible()
        texts = [*panel.findChildren(QAbstractScrollArea), *panel.findChildren(QLabel)]
        seen = [each for each in texts if each.isVisible() and each.height() > 10]
        bottom = max(each.mapTo(panel, each.rect().bottomLeft()).y() for each in seen)
        assert bottom > high - 40, f"{type(panel).__name__} has {high - bottom} px free"


def test_an_open_panel_grows_with_its_content_and_does_not_jump(
    window: MainWindow, qtbot: QtBot
) -> None:
    window.resize(1366, 768)
    window.panels.open(window.probe_panel)
    settle()
    low = window.panels.height()
    assert low < 100
    window.probe_panel.follow(point=(0.0, 1.0, 0.0))
    qtbot.waitUntil(lambda: window.panels.height() > low + 100)
    window.panels.open(window.frame_panel)
    settle()
    high = window.panels.height()
    for step in range(1, 7):
        window.frame_panel.go_to(step)
        QTest.qWait(REST_MS + 20)
        assert window.panels.height() == high


def test_a_panel_that_a_click_closes_leaves_the_focus_at_its_name(window: MainWindow) -> None:
    """It went to the choice of lenses, where an arrow key changes the model."""
    activate(window)
    for panel, following in ((window.matrices, None), (window.matrices, window.probe_panel)):
        window.panels.open(panel)
        panel.findChild(QComboBox).setFocus()
        clicked = head(window, following or panel)
        click(clicked)
        assert window.panels.open_panel is following
        assert QApplication.focusWidget() is clicked
    window.panels.open(window.matrices)
    window.matrices.findChild(QComboBox).setFocus()
    window.panels.open(None)
    assert QApplication.focusWidget() is head(window, window.matrices), "also if a lesson closes it"
