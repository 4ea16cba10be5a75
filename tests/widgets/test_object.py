"""L2 in the window: the object's own transform in dock, panes and panel."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel

from app.document.document import Document
from app.document.files import write
from app.drawings.frame import axes_reach
from app.model.projection import ObjectTransform
from app.scenes.scene import load
from tests.support.controls import enter, number
from tests.support.window import move_mouse, pixels, settle, show_scene
from widgets.window.main_window import MainWindow


def spots(window: MainWindow, *points: Any) -> list[tuple[float, float]]:
    """Return the pixels of points in the world pane, for a scene at the origin."""
    pane = window.panes["world"].drawing.own.pane
    return [(x, pane.size_px[1] - y) for x, y, _ in pane.seen(np.array(points))]


KEYS = [f"{vector}_{x}" for vector in ("translate", "rotate_deg", "scale") for x in "xyz"]


def test_l2_every_number_of_the_object_is_a_row_and_moves_all_panes(window: MainWindow) -> None:
    section = window.controls.sections["object"]
    section.set_open(True)
    settle()
    for key in KEYS:
        row = number(window.controls, key)
        assert row.isVisible() and row.tip
        before = {name: pixels(window, name) for name in window.panes}
        row.edited.emit(row.value() + 0.75 if "rotate" not in key else 35.0)
        settle()
        for name, picture in before.items():
            assert (pixels(window, name) != picture).any(), (key, name)
    placement = window.store.document.projection.placement
    assert placement == ObjectTransform((0.75,) * 3, (35.0,) * 3, (1.75,) * 3)
    for _ in KEYS:
        window.store.undo()
    assert window.store.document.projection.placement.is_identity
    assert number(window.controls, "scale_x").value() == 1.0


@pytest.mark.undrawn
def test_l2_the_orders_are_a_choice(window: MainWindow) -> None:
    window.controls.rows["rotate_deg_y"].edited.emit(90.0)  # type: ignore[attr-defined]
    window.controls.rows["translate_x"].edited.emit(2.0)  # type: ignore[attr-defined]
    places = []
    for order in ("trs", "rts"):
        window.controls.rows["order"].edited.emit(order)  # type: ignore[attr-defined]
        places.append(window.store.document.projection.placement.matrix[:3, 3].tolist())
    assert places == [[2.0, 0.0, 0.0], [0.0, 0.0, -2.0]]


def test_l2_a_column_highlights_its_axis_and_an_axis_its_column(window: MainWindow) -> None:
    window.controls.rows["rotate_deg_y"].edited.emit(30.0)  # type: ignore[attr-defined]
    settle()
    drawing = window.panes["world"].drawing
    way = axes_reach(load("letter-f").size) * np.array(
        [math.cos(math.radians(30.0)), 0.0, -math.sin(math.radians(30.0))]
    )
    ((x, y),) = spots(window, 0.6 * way)
    assert "object_x" in drawing.highlight_at(x, y)
    before = pixels(window, "world")
    assert drawing.show_highlight(frozenset({"object_x"}))
    window.panes["world"].canvas.redraw()
    settle()
    around = np.s_[round(y) - 4 : round(y) + 5, round(x) - 4 : round(x) + 5]
    assert (pixels(window, "world") != before)[around].any(), "the axis, not only its letter"


@pytest.mark.undrawn
def test_objects_of_a_phenomenon_are_fixed_and_a_text_says_so(window: MainWindow) -> None:
    section = window.controls.sections["object"]
    section.set_open(True)
    show_scene(window, "eye-plane")
    said = [w.text() for w in section.findChildren(QLabel) if w.isVisible() and "fixed" in w.text()]
    assert len(said) == 1 and not number(window.controls, "translate_x").isVisible()
    show_scene(window, "cube")
    assert number(window.controls, "translate_x").isVisible()
    assert not [w for w in section.findChildren(QLabel) if w.isVisible() and "fixed" in w.text()]


@pytest.mark.undrawn
def test_a_wrong_scale_is_refused_and_the_last_good_one_stays(window: MainWindow) -> None:
    window.controls.sections["object"].set_open(True)
    row = number(window.controls, "scale_x")
    for typed in ("nan", "1e308", "2e30"):
        enter(row, typed)
        settle()
        assert row.error and window.store.document.projection.placement.is_identity, typed


@pytest.mark.undrawn
def test_l2_a_prepared_document_comes_back(window: MainWindow, tmp_path: Path) -> None:
    placement = ObjectTransform((1.0, 0.0, -2.0), (0.0, 30.0, 0.0), (1.0, 2.0, 1.0), "rts")
    document = Document("cube", replace(load("cube").start, placement=placement))
    path = tmp_path / "moved.json"
    write(document, path)
    window.controls.sections["object"].set_open(True)
    window.files.open(path)
    settle()
    assert window.store.document.projection.placement == placement
    assert number(window.controls, "rotate_deg_y").value() == 30.0


def test_a_vertex_is_picked_where_it_is_seen(window: MainWindow) -> None:
    """The keyboard goes to the moved vertices."""
    from app.drawings.probes import next_vertex, pick_in, vertex_of

    window.controls.rows["translate_x"].edited.emit(2.0)  # type: ignore[attr-defined]
    window.controls.rows["rotate_deg_y"].edited.emit(40.0)  # type: ignore[attr-defined]
    settle()
    scene, projection = window.shown.scene, window.store.document.projection
    sight = window.panes["image"].drawing.sight
    rectangle = window.panes["image"].drawing.picture_rectangle_px
    number_at = next_vertex(scene, projection, sight, rectangle, 1.0, None, forwards=True)
    assert number_at is not None
    place = vertex_of(scene, projection, number_at)
    ((x, y),) = sight.seen([place]).tolist()
    hit = pick_in(scene, projection, sight, (x, y))
    assert hit is not None and hit.vertex == number_at and hit.point == pytest.approx(place)
    # The ground stays where it was.
    ((x, y),) = sight.seen([(-4.0, 0.0, 0.0)]).tolist()
    ground = pick_in(scene, projection, sight, (x, y))
    assert ground is not None and ground.point == pytest.approx((-4.0, 0.0, 0.0), abs=1e-5)


@pytest.mark.undrawn
def test_l2_a_probe_is_read_in_the_objects_coordinates_too(window: MainWindow) -> None:
    window.panels.open(window.probe_panel)
    window.probe_panel.follow(point=(2.0, 1.0, 0.0))
    window.controls.rows["translate_x"].edited.emit(2.0)  # type: ignore[attr-defined]
    window.controls.rows["rotate_deg_y"].edited.emit(90.0)  # type: ignore[attr-defined]
    settle()

    def line(row: int) -> list[str]:
        model = window.probe_panel.table.model()
        return [str(model.index(row, 1 + part).data()) for part in range(4)]

    assert line(0) == ["0", "1", "0", "1"] and line(1) == ["2", "1", "0", "1"]
    window.controls.rows["scale_y"].edited.emit(0.0)  # type: ignore[attr-defined]
    settle()
    assert "flattened" in line(0)[0] and line(1)[0] == "2"


def test_l2_axes_and_handles_are_there_before_anything_is_moved(window: MainWindow) -> None:
    """They are visible while the numbers are unfolded, and not in the first picture."""
    drawing, section = window.panes["world"].drawing, window.controls.sections["object"]

    def held() -> dict[str, tuple[float, float]]:
        shown = window.panes["world"].drawing.handles.shown
        return {each.setting: at for each, at in dict(shown).items() if each.name == "object"}

    first = pixels(window, "world")
    assert not held() and not drawing.handles.has_object
    section.set_open(True)
    settle()
    assert {"origin", "x", "y", "z"} <= {*held()}
    assert (pixels(window, "world") != first).any()
    section.set_open(False)
    settle()
    assert not held() and np.array_equal(pixels(window, "world"), first)
    section.set_open(True)
    settle()
    # x, y and z as far from the origin as they are drawn, at the identity.
    tips = axes_reach(load("letter-f").size) * np.eye(3)
    places = spots(window, *tips, np.zeros(3))
    for name, place in zip(("x", "y", "z", "origin"), places, strict=True):
        assert held()[name] == pytest.approx(place, abs=0.5)
    x, y = (round(part) for part in held()["origin"])
    canvas, at, none = window.panes["world"].canvas, QPoint(x, y), Qt.MouseButton.NoButton
    move_mouse(canvas, at, none)
    settle()
    assert "Translation" in canvas.toolTip()
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=at)
    move_mouse(canvas, at + QPoint(30, 0))
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=at + QPoint(30, 0))
    settle()
    assert not window.store.document.projection.placement.is_identity
    window.store.undo()
    section.set_open(False)
    move_mouse(canvas, QPoint(2, 2), none)
    settle()
    assert not held()
    window.look.rebuild()
    section.set_open(True)
    settle()
    assert held()
    show_scene(window, "eye-plane")  # whose objects are fixed
    assert not held() and not window.panes["world"].drawing.handles.has_object
    show_scene(window, "cube")
    assert held()
