"""The tree of planar projections: mouse, keyboard, highlight and words."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QEnterEvent, QFontMetrics
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.lecture.kinds import KINDS, kind_of, path
from app.model.projection import Camera, Orbit
from tests.support.window import activate, settle, show_scene
from widgets.window.main_window import MainWindow

pytestmark = pytest.mark.undrawn


def lit(window: MainWindow) -> list[str]:
    return [name for name, node in window.kinds_panel.nodes.items() if node.isChecked()]


def point_at(window: MainWindow, name: str) -> str:
    """The text about a node while the mouse is on it."""
    node, panel = window.kinds_panel.nodes[name], window.kinds_panel
    place = QPointF(3.0, 3.0)
    QApplication.sendEvent(node, QEnterEvent(place, place, place))
    said = panel.condition.text()
    QApplication.sendEvent(node, QEvent(QEvent.Type.Leave))
    return said


def test_l12_a_click_sets_camera_and_lens_as_one_step_and_lights_the_node(
    window: MainWindow,
) -> None:
    panel, store = window.kinds_panel, window.store
    window.panels.open(panel)
    assert lit(window) == ["3-point"]
    before = store.document
    for name, node in panel.nodes.items():
        if name in {kind.parent for kind in KINDS.values()}:
            continue
        QTest.mouseClick(node, Qt.MouseButton.LeftButton)
        assert lit(window) == [name] == [kind_of(store.document.projection)]
        assert all(panel.nodes[above].font_of().bold() for above in path(name))  # type: ignore
        QTest.mouseClick(node, Qt.MouseButton.LeftButton)
        assert lit(window) == [name], "a second click is silent"
        if name != "3-point":
            store.undo()
        assert store.document == before and lit(window) == ["3-point"]


def test_l12_it_follows_the_hand_on_the_camera(window: MainWindow) -> None:
    window.panels.open(window.kinds_panel)
    window.kinds_panel.nodes["isometric"].click()
    assert (
        "0.8165 long along x, 0.8165 along y, 0.8165 along z" in window.kinds_panel.condition.text()
    )
    projection = window.store.document.projection
    camera = Camera.from_orbit(projection.camera.target, Orbit(45.0, 20.0, 8.0))
    window.store.set_projection(replace(projection, camera=camera))
    assert lit(window) == ["dimetric"]
    window.store.set_projection(projection.with_lens("matrix"))
    assert lit(window) == []
    assert window.kinds_panel.condition.text().startswith("A free matrix belongs to no kind")


def test_l12_a_node_says_its_condition_and_why_a_scene_cannot_show_it(window: MainWindow) -> None:
    show_scene(window, "vanishing-points")
    window.panels.open(window.kinds_panel)
    settle()
    before = window.kinds_panel.condition.text()
    assert before.startswith("2-point: one axis is parallel to the image plane")
    assert point_at(window, "cabinet") == (
        "cabinet: two axes are parallel to the image plane, the third is drawn at half its length."
        " A unit would be drawn 1 long along x, 1 along y, 0.5 along z. This scene: with a parallel"
        " lens parallel edges stay parallel in the image."
    )
    assert "This scene" not in point_at(window, "1-point")
    assert window.kinds_panel.condition.text() == before


def test_l12_every_node_is_reached_and_set_by_the_keyboard(window: MainWindow) -> None:
    activate(window)
    panel = window.kinds_panel
    window.panels.open(panel)
    settle()
    panel.nodes["planar"].setFocus()
    been = []
    for _ in KINDS:
        focus = QApplication.focusWidget()
        been.append(next(name for name, node in panel.nodes.items() if node is focus))
        assert panel.condition.text().startswith(focus.accessibleName() + ": ")
        QTest.keyClick(focus, Qt.Key.Key_Tab)
    assert been == list(KINDS)
    panel.nodes["top"].setFocus()
    QTest.keyClick(panel.nodes["top"], Qt.Key.Key_Return)
    assert lit(window) == ["top"]
    assert "the picture is of this kind now" in panel.nodes["top"].accessibleDescription()


def test_l12_no_name_is_cut_and_no_node_covers_another(window: MainWindow) -> None:
    window.panels.open(window.kinds_panel)
    for size, presenting in (((1280, 720), False), ((1366, 768), True)):
        window.look.set_presenting(presenting)
        window.resize(*size)
        settle()
        nodes = list(window.kinds_panel.nodes.values())
        for i, node in enumerate(nodes):
            font = node.font_of()  # type: ignore[attr-defined]
            font.setBold(True)
            assert QFontMetrics(font).horizontalAdvance(node.text()) <= node.width() - 4, (
                node.text()
            )
            assert not any(node.geometry().intersects(other.geometry()) for other in nodes[:i])
