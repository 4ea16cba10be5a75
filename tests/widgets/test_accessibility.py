"""The window for a screen reader, and the keyboard's way through it."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import groupby
from types import SimpleNamespace
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible, QAccessibleAnnouncementEvent, QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractScrollArea,
    QApplication,
    QLabel,
    QScrollArea,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from app.bootstrap import ROOT
from tests.support.keys import clashes
from tests.support.window import MakeWindow, activate, settle, show_scene
from widgets.parts.diagram import DiagramView
from widgets.window.export_dialog import ExportDialog
from widgets.window.main_window import MainWindow
from widgets.window.practice import SelfTestDialog
from widgets.window.speaker import SpeakerWindow, TalkClock
from widgets.window.talk_writing import TitleDialog

SAID = QAccessible.Text
LABEL = QAccessible.RelationFlag.Label


def said(widget: QWidget, what: QAccessible.Text = SAID.Name) -> str:
    """Return what a screen reader reads of a widget."""
    return QAccessible.queryAccessibleInterface(widget).text(what)


def panels(window: Any) -> Iterator[QWidget]:
    """Open one panel after the other."""
    for panel in (
        window.matrices,
        window.frame_panel,
        window.kinds_panel,
        window.probe_panel,
        window.scene_panel,
        window.measure_panel,
    ):
        window.panels.open(panel)
        yield panel


def mnemonics(actions: Iterable[QAction]) -> Iterator[list[str]]:
    """Yield the letters for Alt of a menu, then those of each menu below it."""
    yield [letter for action in actions for letter in re.findall("&([^&])", action.text().lower())]
    for action in actions:
        if action.menu() is not None:
            yield from mnemonics(action.menu().actions())


@pytest.mark.undrawn
def test_a_screen_reader_hears_what_is_shown(window: MainWindow) -> None:
    show_scene(window, "depth-buffer")
    window.panels.open(window.matrices)
    window.matrices.explanation.setText("a sentence")
    for _ in panels(window):
        for label in window.findChildren(QLabel):
            if label.isVisible() and label.text() and "<" not in label.text():
                heard = said(label) + said(label, SAID.Description)
                assert label.text().rstrip("…") in heard, label.text()
    heard = said(window.frame_panel.numbers)
    assert "=" in heard and "<" not in heard  # without its markup
    said_of_panes = [said(b) for p in window.panes.values() for b in p.findChildren(QToolButton)]
    assert len(said_of_panes) == len(set(said_of_panes))
    assert "World: Enlarge; click again for the whole window" in said_of_panes
    box = QAccessible.queryAccessibleInterface(window.menus.scene_box)
    assert "Scene" in [label.text(SAID.Name) for label, _ in box.relations(LABEL)]
    letters = list(mnemonics(window.menuBar().actions()))
    assert len(letters) > 5 and all(len(menu) == len(set(menu)) for menu in letters), letters
    window.status.quality.setText("quality: 50 %")
    for button in (window.status.precision, window.status.quality):
        assert said(button) == button.text()


@pytest.mark.undrawn
def test_a_screen_reader_hears_what_each_pane_shows_unless_it_is_the_answer(
    window: MainWindow, qtbot: QtBot
) -> None:
    canvas, projection = window.panes["world"].canvas, window.store.document.projection
    assert said(canvas, SAID.Description).startswith("Arrow keys turn")
    QAccessible.setActive(True)
    try:
        window.store.set_projection(replace(projection, lens=replace(projection.lens, near=2.5)))
        qtbot.waitUntil(lambda: "near 2.5, far 12.5." in said(canvas, SAID.Description))
        heard = said(canvas, SAID.Description)
        assert heard.startswith("World: the scene from a free viewpoint. The eye is at (5, 4.5, 8)")
        assert "Home resets." in heard and heard.count("World:") == 1
        window.lesson_card.page.hidden.emit(frozenset({"numbers", "image"}))
        heard = said(canvas, SAID.Description)
        assert heard.startswith("World: the scene from a free viewpoint. Arrow keys")
        assert said(window.panes["image"].canvas, SAID.Description).startswith("Arrow keys move")
        window.lesson_card.page.hidden.emit(frozenset())
        assert "near 2.5" in said(window.panes["image"].canvas, SAID.Description)
    finally:
        QAccessible.setActive(False)


@pytest.mark.undrawn
def test_no_key_of_a_dialog_means_two_things(window: MainWindow) -> None:
    """`tests.support.opened.close` looks at the window itself, in the state of every test."""
    panes = {name: pane.accessibleName() for name, pane in window.panes.items()}
    window.practice.show_overview()
    window.menus.start_card.trigger()
    for dialog in (
        window,
        window.practice.overview,
        ExportDialog(panes, window.pictures.figure(), window),
        SelfTestDialog({"L1": ("One", 3)}, 1, window),
        TitleDialog("Add a step", "Depth", True, window),
        SpeakerWindow(window.settings, window, TalkClock()),
    ):
        dialog.show()
        settle()
        assert not clashes(dialog), dialog
        dialog.close()


@pytest.mark.undrawn
def test_a_message_is_announced_and_esc_closes_it(
    make_window: MakeWindow, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    heard: list[str] = []
    monkeypatch.setattr(
        "widgets.parts.messages.QAccessible",
        SimpleNamespace(updateAccessibility=lambda event: heard.append(event.message())),
    )
    window = make_window()
    activate(window)
    window.probe_panel.follow(point=(0.0, 0.0, 0.0))
    field, escape = window.controls.rows["near"].field, Qt.Key.Key_Escape
    field.setFocus()
    messages = window.messages
    for sentence in ("An offer.", "A refusal.", "A refusal."):
        messages.show_message(sentence, *[("Take it", lambda: None)][: sentence == "An offer."])
    assert heard == ["An offer.", "A refusal."]
    QTest.keyClicks(field, "x")
    QTest.keyClick(field, escape)
    assert messages.text == "A refusal.", "the text being typed was meant"
    QTest.keyClick(field, escape)
    assert messages.text == "An offer." and len(window.probe_panel.probes) == 1
    QTest.keyClick(field, escape)
    assert messages.text == "An offer." and not window.probe_panel.probes
    messages.choices[0].setFocus()
    QTest.keyClick(messages.choices[0], escape)
    assert messages.text == ""
    QAccessible.updateAccessibility(QAccessibleAnnouncementEvent(messages, "as it is in earnest"))


def stops(window: Any) -> list[QWidget]:
    """Return where Tab stops, once round the window."""
    been: list[QWidget] = []
    while (focus := QApplication.focusWidget()) not in been:
        assert focus is not None and len(been) < 200
        been.append(focus)
        QTest.keyClick(focus, Qt.Key.Key_Tab)
    return been


@pytest.mark.undrawn
def test_tab_goes_as_one_sees_and_is_seen(window: MainWindow, qtbot: QtBot) -> None:
    show_scene(window, "depth-buffer")
    window.resize(1366, 768)
    activate(window)
    name = next(
        name for name in window.panels.names.findChildren(QToolButton) if said(name) == "Precision"
    )
    for panel in panels(window):
        QApplication.processEvents()
        name.setFocus()
        order = stops(window)
        inside = [panel.isAncestorOf(widget) for widget in order]
        assert [is_in for is_in, _ in groupby(inside)].count(True) == 1, panel.accessibleName()
        for widget in order:
            assert said(widget), widget
            if isinstance(widget, QScrollArea):
                bars = widget.horizontalScrollBar(), widget.verticalScrollBar()
                assert any(bar.maximum() for bar in bars), said(widget)
            row = widget.parentWidget()
            styled = row is not None and row.objectName() in ("drawerNames", "stages", "fixedViews")
            if styled or isinstance(widget, (QAbstractScrollArea, DiagramView)):
                widget.setFocus()
                seen = widget.grab().toImage()
                widget.clearFocus()
                assert widget.grab().toImage() != seen, said(widget)
        order[1].setFocus()
        QTest.keyClick(order[1], Qt.Key.Key_Backtab)
        assert QApplication.focusWidget() is name


@pytest.mark.undrawn
def test_every_stop_of_the_overview_has_a_name(window: MainWindow) -> None:
    window.practice.show_overview()
    activate(window.practice.overview)
    assert all(map(said, stops(window.practice.overview)))


def test_no_layout_is_walked_by_its_items() -> None:
    """An item is not a QObject: PySide would take what lies at its address later, and crash."""
    for path in (ROOT / "widgets").rglob("*.py"):
        assert ".itemAt(" not in path.read_text(encoding="utf-8"), path.name
