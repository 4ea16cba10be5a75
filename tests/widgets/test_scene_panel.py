"""The explanation panel and its diagrams."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication, QFileDialog, QScrollArea
from pytestqt.qtbot import QtBot

from app.document.files import extract, read
from app.drawings.style import LIGHT
from app.scenes.phenomena.illustration import Illustration, Subject
from tests.support.phenomenon import EVERYTHING
from tests.support.window import show_scene
from widgets.panels.scene_panel import ScenePanel
from widgets.parts import palette
from widgets.parts.diagram import DiagramView
from widgets.window.main_window import MainWindow

SUBJECT = Subject((0.0, 0.0, 0.0), (1.0, 1.0, 1.0), np.zeros((1, 3)))
SHOWN = EVERYTHING.show(EVERYTHING.start, EVERYTHING.checked({}), SUBJECT)


@pytest.fixture
def panel(qtbot: QtBot) -> ScenePanel:
    made = ScenePanel()
    qtbot.addWidget(made)
    made.show_scene("A setting of every kind", EVERYTHING)
    made.resize(1340, 260)
    made.show()
    qtbot.waitExposed(made)
    return made


def visible(panel: ScenePanel) -> int:
    return sum(view.isVisible() for view in panel.diagrams)


def test_it_explains_the_scene_and_names_the_lectures(panel: ScenePanel) -> None:
    assert panel.title.text() == "A setting of every kind"
    assert panel.explanation.text() == EVERYTHING.words.explanation
    assert panel.lectures.text() == "Lectures: 001, 002"


def test_there_are_as_many_diagrams_as_the_illustration_has(panel: ScenePanel) -> None:
    panel.show_illustration(SHOWN)
    assert visible(panel) == 1 and panel.diagrams[0].accessibleName() == "Line"
    panel.show_illustration(Illustration((), diagrams=SHOWN.diagrams * 3))
    assert visible(panel) == 3
    panel.show_illustration(Illustration(()))
    assert visible(panel) == 0


def test_a_folded_panel_draws_nothing_and_is_up_to_date_when_it_opens(
    panel: ScenePanel, qtbot: QtBot
) -> None:
    panel.show_illustration(SHOWN)
    panel.hide()
    panel.show_illustration(Illustration((), diagrams=SHOWN.diagrams * 2))
    assert len(panel.diagrams) == 1
    panel.show()
    qtbot.waitExposed(panel)
    assert visible(panel) == 2


def test_it_gives_way_to_the_panes(panel: ScenePanel, qapp: QApplication) -> None:
    """In a window of 1366 x 768, with any number of diagrams."""
    panel.show_illustration(Illustration((), diagrams=SHOWN.diagrams * 4))
    try:
        for screen_px, width in ((768.0, 1340), (0.0, 1070)):
            palette.apply(qapp, dark=False, screen_px=screen_px)
            qapp.processEvents()
            assert panel.minimumSizeHint().width() <= width
    finally:
        palette.apply(qapp, dark=False, screen_px=0.0)
    assert panel.minimumSizeHint().height() <= 100
    areas = panel.findChildren(QScrollArea)
    assert len(areas) == 2
    assert all(area.horizontalScrollBar().maximum() == 0 for area in areas)


# -- pictures of diagrams


@pytest.mark.undrawn
def test_a_diagram_goes_to_the_clipboard_and_into_a_file_with_the_document(
    window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    show_scene(window, "eye-plane")
    window.controls.card.explanation.click()
    window.look.set_theme("dark")
    circle = window.scene_panel.diagrams[3]
    copy, export = circle.actions()
    assert circle.contextMenuPolicy() == Qt.ContextMenuPolicy.ActionsContextMenu
    copy.trigger()
    data = QGuiApplication.clipboard().mimeData()
    assert extract(bytes(data.data("image/png").data())) is not None
    image = data.imageData()
    assert (image.width(), image.height()) == (1440, 1080)
    colours = {image.pixelColor(x, y).name() for x in range(0, 1440, 3) for y in range(0, 1080, 3)}
    assert image.pixelColor(0, 0).name() == LIGHT.background  # for print, in any theme
    assert {LIGHT.u, LIGHT.accent} <= colours
    path = tmp_path / "circle"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    export.trigger()
    assert read(tmp_path / "circle.png") == window.store.document
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "a" / "b"), ""))
    export.trigger()
    assert "cannot be written" in window.messages.text


def test_where_there_is_no_diagram_none_is_copied(qtbot: QtBot) -> None:
    view = DiagramView()
    qtbot.addWidget(view)
    assert not any(action.isEnabled() for action in view.actions())
