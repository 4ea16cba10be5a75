"""Dragging the camera by its handles in the world, and by the picture."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, QRectF, Qt, QTimer
from PySide6.QtGui import QAction, QHelpEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog, QLabel, QMenu, QStyle, QStyleOptionSlider

from app.drawings import WORDS
from app.drawings.image import ImageDrawing
from app.drawings.style import LIGHT
from app.drawings.world import WorldDrawing
from app.model.projection import (
    Camera,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.picking.handles import EYE, TARGET, Handle, moved_by
from app.scenes.phenomena.words import Reading
from app.scenes.scene import load
from tests.support.drawings import OffScreen
from tests.support.window import (
    LEFT,
    MakeWindow,
    activate,
    edit,
    move_mouse,
    pixels,
    point_of,
    settle,
    show_scene,
)
from widgets.panes.canvas import ZOOM_PER_WHEEL_STEP
from widgets.panes.pane import named_on
from widgets.window.main_window import MainWindow

NONE = Qt.KeyboardModifier.NoModifier
MIDDLE = Qt.MouseButton.MiddleButton
SHIFT = Qt.KeyboardModifier.ShiftModifier
LENSES: dict[str, Lens] = {
    "perspective": Perspective(45.0, 1.0, 16.0),
    "frustum": Frustum(-0.6, 0.9, -0.4, 0.5, 1.0, 16.0),
    "orthographic": Orthographic(-4.0, 4.0, -2.5, 2.5, 2.0, 16.0),
    "oblique": Oblique(-4.0, 4.0, -2.5, 2.5, 5.0, 16.0, alpha_deg=80.0, beta_deg=80.0),
}


def model(window: MainWindow) -> Projection:
    return window.store.document.projection


def world(window: MainWindow) -> WorldDrawing:
    drawing = window.panes["world"].drawing
    assert isinstance(drawing, WorldDrawing)
    return drawing


def marks(window: MainWindow) -> dict[Handle, tuple[float, float]]:
    """The handles in the world pane, and their pixels."""
    drawing: Any = world(window)
    return dict(drawing.handles.shown)


def mark(window: MainWindow, name: str) -> tuple[Handle, tuple[float, float]]:
    """The first handle of a name; no side of the window, which can go one way only."""
    handles = marks(window).items()
    return next(
        (handle, spot)
        for handle, spot in handles
        if handle.name == name and not (name == "corner" and 0.0 in handle.at)
    )


def moved_names(window: MainWindow, handle: Handle) -> list[str]:
    """What a handle of a plane moves; of another one nothing."""
    return [each.name for each in moved_by(model(window), handle)] if handle.face else []


def tip(window: MainWindow, name: str = "world") -> str:
    return window.panes[name].canvas.toolTip()


def move(window: MainWindow, name: str, to: QPoint, key: Any = NONE, button: Any = LEFT) -> None:
    move_mouse(window.panes[name].canvas, to, button, key)
    settle()


def press(window: MainWindow, name: str, at: QPoint, key: Any = NONE) -> None:
    QTest.mousePress(window.panes[name].canvas, LEFT, key, pos=at)


def release(window: MainWindow, name: str, at: QPoint, key: Any = NONE) -> None:
    QTest.mouseRelease(window.panes[name].canvas, LEFT, key, pos=at)
    settle()


def drag(
    window: MainWindow, name: str, at: QPoint, *ways: tuple[int, int], key: Any = NONE
) -> None:
    """Press at a place, move by each of these ways from there, and release at the last."""
    press(window, name, at, key)
    for way in ways:
        move(window, name, at + QPoint(*way), key)
    release(window, name, at + QPoint(*ways[-1]), key)


def view(window: MainWindow) -> tuple[float, ...]:
    camera = window.panes["world"].hand.camera
    return (*camera.GetPosition(), *camera.GetFocalPoint())


def wheel(window: MainWindow, steps: float, name: str = "image", *, wait: bool = True) -> None:
    canvas = window.panes[name].canvas
    place = QPointF(canvas.rect().center())
    event = QWheelEvent(
        place, canvas.mapToGlobal(place), QPoint(), QPoint(0, round(120 * steps)),
        Qt.MouseButton.NoButton, NONE, Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    QApplication.sendEvent(canvas, event)
    if wait:
        settle()


def along(window: MainWindow, handle: Handle, **fields: float) -> tuple[int, int]:
    """The way of a handle, in pixels, when fields of the lens change."""
    drawing, now = world(window), model(window)
    drawing.hold(handle)
    before = marks(window)[handle]
    drawing.show_projection(replace(now, lens=replace(now.lens, **fields)))  # type: ignore[arg-type]
    after = marks(window)[handle]
    drawing.show_projection(now)
    drawing.hold(None)
    return round(after[0] - before[0]), round(after[1] - before[1])


@pytest.fixture
def window(window: MainWindow) -> MainWindow:
    """With the world pane alone, in which the near face is large."""
    window.store.set_projection(replace(model(window), lens=LENSES["perspective"]))
    window.slots.make_large("world")
    window.slots.reset_views()
    window.panes["image"].show()
    settle()
    return window


# -- the world pane


def test_a_handle_follows_the_mouse_and_the_view_stays(window: MainWindow) -> None:
    for lens in LENSES.values():
        window.store.set_projection(replace(model(window), lens=lens))
        window.panes["world"].reset_view()
        settle()
        is_first = lens is LENSES["perspective"]  # the camera is no part of a lens
        for name in ("eye", "target", "near", "far", "corner") if is_first else ("near", "corner"):
            drag_a_handle(window, lens, name)


def drag_a_handle(window: MainWindow, lens: Lens, name: str) -> None:
    """Drag a handle a little, and undo that."""
    start, place = model(window), view(window)
    window.store.mark_saved()
    handle, spot = mark(window, name)
    way = (14, 10)
    if name == "near":
        way = along(window, handle, near=lens.near + 3.0)
    elif name == "far":
        way = along(window, handle, far=lens.far - 5.0)
    elif name == "corner" and lens.kind == "perspective":
        way = along(window, handle, fov_y_deg=60.0)
    assert max(map(abs, way)) >= 10
    press(window, "world", point_of(spot))
    half = way[0] // 2, way[1] // 2
    move(window, "world", point_of(spot) + QPoint(*half))
    move(window, "world", point_of(spot) + QPoint(*way))
    assert view(window) == place
    x, y = marks(window)[handle]
    assert math.dist((x, y), (spot[0] + way[0], spot[1] + way[1])) <= 1.0  # whole pixels off rail
    end = model(window)
    release(window, "world", point_of(spot) + QPoint(*way))
    assert model(window) == end != start
    assert (end.camera == start.camera) == (name not in ("eye", "target"))
    assert (end.lens == start.lens) == (name in ("eye", "target"))
    assert window.controls.rows["distance"].value() == pytest.approx(end.camera.distance)
    if name in ("near", "far"):
        row: Any = window.controls.rows[name]
        assert row.value() == getattr(end.lens, name)
    window.store.undo()  # one step, however many moves
    assert model(window) == start and not window.store.modified


@pytest.mark.parametrize("name", ["world", "image"])
def test_wheel_and_other_buttons_do_not_disturb_a_drag(window: MainWindow, name: str) -> None:
    if name == "world":
        _, spot = mark(window, "eye")
        at = point_of(spot)
    else:
        left, top, *_ = picture(window).picture_rectangle_px
        at = QPoint(left + 20, top + 20)
    right, both = Qt.MouseButton.RightButton, LEFT | Qt.MouseButton.RightButton
    canvas, place = window.panes[name].canvas, view(window)
    start = model(window)
    press(window, name, at)
    move(window, name, at + QPoint(20, 10))
    dragged = model(window)
    wheel(window, 2.0, name)
    QTest.mousePress(canvas, right, NONE, pos=at + QPoint(20, 10))
    assert model(window) == dragged
    move(window, name, at + QPoint(30, 30), button=both)
    QTest.mouseRelease(canvas, right, NONE, pos=at + QPoint(30, 30))
    move(window, name, at + QPoint(20, 10))
    assert model(window) == dragged != start
    release(window, name, at + QPoint(20, 10))
    assert name == "image" or view(window) == place  # to bring back an eye that has left the view
    window.store.undo()
    assert model(window) == start
    place = view(window)
    wheel(window, 2.0, name)  # the hand has let go
    assert (model(window), view(window)) != (start, place)


def test_the_eye_goes_up_and_down_with_shift(window: MainWindow) -> None:
    start, place = model(window).camera, view(window)
    _, spot = mark(window, "eye")
    drag(window, "world", point_of(spot), (9, -20), (18, -40), key=SHIFT)
    eye = model(window).camera.eye
    assert (eye[0], eye[2]) == (start.eye[0], start.eye[2]) and eye[1] > start.eye[1] + 0.1
    assert model(window).camera.target == start.target
    assert view(window)[:3] != place[:3] or window.panes["world"].view is None


def test_a_drag_beside_the_handles_still_turns_the_view(window: MainWindow) -> None:
    start, place = model(window), view(window)
    x, y = mark(window, "far")[1]
    empty = point_of((x, y - 40.0))
    assert world(window).handles.at((x, y - 40.0)) is None
    drag(window, "world", empty, (20, 5), (40, 10))
    assert view(window) != place and model(window) == start and not window.store.in_gesture


def test_hovering_says_what_a_drag_does_and_costs_one_repaint(window: MainWindow) -> None:
    canvas = window.panes["world"].canvas
    handle, spot = mark(window, "near")
    before, plain = pixels(window, "world"), tip(window)
    assert "\n" not in plain and len(plain) < 60
    counts = []
    observer = canvas.render_window.AddObserver("EndEvent", lambda *_: counts.append(1))
    for way in ((0, 0), (1, 0), (1, 1), (0, 0)):
        move(window, "world", point_of(spot) + QPoint(*way), button=Qt.MouseButton.NoButton)
    assert len(counts) == 1 and world(window).handles.held == handle
    assert "near plane" in tip(window) and "Near = 1" in tip(window)
    assert window.panes["world"].note.text() == "", "the tooltip has no second copy"
    assert canvas.cursor().shape() == Qt.CursorShape.BitmapCursor
    pointed = pixels(window, "world")
    changed = np.argwhere((pointed != before).any(axis=2))
    # The mark; and, as everywhere, the plane that it belongs to.
    assert (np.abs(changed - (spot[1], spot[0])).max(axis=1) < 16.0).sum() > 20
    counts.clear()
    away = point_of((before.shape[1] - 3.0, 3.0))  # beside the far plane
    for _ in range(2):
        move(window, "world", away, button=Qt.MouseButton.NoButton)
    assert len(counts) == 1 and world(window).handles.held is None
    assert tip(window) == plain
    assert canvas.cursor().shape() == Qt.CursorShape.OpenHandCursor
    assert (pixels(window, "world") == before).all()
    move(window, "world", point_of(spot), button=Qt.MouseButton.NoButton)
    QApplication.sendEvent(canvas, QEvent(QEvent.Type.Leave))
    assert world(window).handles.held is None
    canvas.render_window.RemoveObserver(observer)


def test_under_a_still_mouse_what_lies_there_now_is_lit(window: MainWindow, qtbot: Any) -> None:
    (near, spot), before = mark(window, "near"), model(window)
    move(window, "world", point_of(spot), button=Qt.MouseButton.NoButton)
    edit(window)
    qtbot.waitUntil(lambda: world(window).handles.held != near)
    window.store.undo()
    assert model(window) == before
    qtbot.waitUntil(lambda: world(window).handles.held == near)
    wheel(window, -10.0, "world")
    qtbot.waitUntil(lambda: world(window).handles.held != near)
    wheel(window, 10.0, "world")
    qtbot.waitUntil(lambda: world(window).handles.held == near)


def test_a_button_that_is_held_hovers_over_nothing(window: MainWindow, qtbot: Any) -> None:
    pane = window.panes["world"]
    spot, (timer,) = point_of(mark(window, "near")[1]), pane.hand.findChildren(QTimer)
    move(window, "world", spot, button=Qt.MouseButton.NoButton)
    pane.canvas.drawn.emit()
    assert timer.isActive(), "it hovers again when the picture rests"
    qtbot.waitUntil(lambda: not timer.isActive())
    press(window, "world", spot)
    pane.canvas.drawn.emit()
    assert not timer.isActive()
    release(window, "world", spot)
    pane.canvas.drawn.emit()
    assert timer.isActive()


def test_a_tooltip_hides_no_name(window: MainWindow, qtbot: Any) -> None:
    canvas = window.panes["world"].canvas
    for name in ("near", "far"):
        drawing = world(window)
        left, right, bottom, top = drawing.board.label(name).box_px
        at = QPoint(round((left + right) / 2.0), round(canvas.height() - (bottom + top) / 2.0))
        for place in (at, at - QPoint(0, 20)):  # on it, and above it
            QApplication.sendEvent(
                canvas, QHelpEvent(QEvent.Type.ToolTip, place, canvas.mapToGlobal(place))
            )
            (shown,) = (w for w in QApplication.topLevelWidgets() if w.inherits("QTipLabel"))
            qtbot.waitUntil(shown.isVisible)
            box = QRect(canvas.mapFromGlobal(shown.pos()), shown.size()).toRectF()
            boxes, _ = named_on(canvas, window.panes["world"])
            assert not [each for each in boxes if each.intersects(box)], (name, box)
            shown.close()


def held_line(window: MainWindow) -> QLabel:
    """The line beside what is dragged."""
    return window.manipulation.line


def gap(window: MainWindow, spot: tuple[float, float]) -> float:
    """How far the line is from a place in the world pane."""
    box = held_line(window).geometry()
    assert window.panes["world"].canvas.rect().contains(box)
    x, y = spot
    return math.hypot(
        max(box.left() - x, 0.0, x - box.right()), max(box.top() - y, 0.0, y - box.bottom())
    )


def test_the_value_stands_beside_what_is_dragged(window: MainWindow) -> None:
    _, spot = mark(window, "eye")
    at, line = point_of(spot), held_line(window)
    move(window, "world", at, button=Qt.MouseButton.NoButton)
    assert "Eye = (" in tip(window) and not line.isVisible()
    press(window, "world", at)
    for way in ((-12, 0), (-60, 30), (-200, 0)):
        move(window, "world", at + QPoint(*way))
        assert line.isVisible() and line.text().startswith("Eye = (")
        assert 4.0 < gap(window, mark(window, "eye")[1]) < 40.0
    release(window, "world", at + QPoint(-200, 0))
    assert not line.isVisible()


def test_after_a_drag_only_what_the_pointer_would_take_is_lit(window: MainWindow) -> None:
    canvas, (near, spot) = window.panes["world"].canvas, mark(window, "near")
    for way, lit in (((40, 0), near), ((-60, 400), None)):  # along its way, and across
        end = spot[0] + way[0] + 0.5, spot[1] + way[1] + 0.5
        drag(window, "world", point_of(spot), (way[0] // 2, 0), way)
        would = world(window).handles.at(end)
        assert (would and would.handle) == lit == world(window).handles.held
        is_arrow = canvas.cursor().shape() == Qt.CursorShape.BitmapCursor
        assert is_arrow == (lit is not None)
        window.store.undo()


@pytest.mark.parametrize("name", ["near", "left"])
def test_a_value_that_is_written_at_the_thing_is_not_written_twice(
    window: MainWindow, name: str
) -> None:
    if name == "left":
        show_scene(window, "off-axis-window")
    side = next(handle for handle in marks(window) if moved_names(window, handle) == [name])
    at, label = point_of(marks(window)[side]), {"left": "l"}.get(name, name)
    move(window, "world", at, button=Qt.MouseButton.NoButton)
    press(window, "world", at)
    for way in ((-4, 0), (-8, 2), (-12, 4)):
        move(window, "world", at + QPoint(*way))
        is_written = world(window).board.writes_value(label)
        assert is_written is not held_line(window).isVisible()
    assert is_written
    world(window).board.label(label).shorten(True)
    assert not world(window).board.writes_value(label)
    release(window, "world", at + QPoint(-12, 4))


def hidden_names(window: MainWindow) -> list[QRectF]:
    """The names in the world pane on which the line lies."""
    boxes, _ = named_on(window.panes["world"].canvas, window.panes["world"])
    names = boxes[: len(boxes) - len(world(window).board.points)]
    return [box for box in names if box.intersects(held_line(window).geometry().toRectF())]


def test_the_line_hides_no_name(window: MainWindow) -> None:
    window.slots.go_back()
    for scene, setting in POINTS:
        show_scene(window, scene)
        settle()
        at = point_of(grip(window, setting)[1])
        press(window, "world", at)
        for way in ((14, -9), (20, 5), (-14, 9)):
            move(window, "world", at + QPoint(*way))
            assert held_line(window).isVisible() and not hidden_names(window), (scene, setting)
        release(window, "world", at + QPoint(-14, 9))
        window.store.undo()
    show_scene(window, "letter-f")
    settle()
    handle, spot = mark(window, "far")
    before = along(window, handle, far=model(window).lens.near + 0.01)
    press(window, "world", point_of(spot))
    move(window, "world", point_of(spot) + 2 * QPoint(*before))
    assert "must" in held_line(window).text() and not hidden_names(window)
    release(window, "world", point_of(spot) + 2 * QPoint(*before))


@pytest.mark.parametrize("change", ["scene", "style"])
def test_the_text_about_a_handle_disappears_with_its_drawing(
    window: MainWindow, change: str
) -> None:
    pane, plain = window.panes["world"], tip(window)
    move(window, "world", point_of(mark(window, "eye")[1]), button=Qt.MouseButton.NoButton)
    assert tip(window) != plain
    if change == "scene":
        window.guide.choose("cube")
    else:
        window.look.set_presenting(True)
    assert world(window).handles.held is None
    assert tip(window) == plain and not held_line(window).isVisible()
    assert pane.canvas.cursor().shape() == Qt.CursorShape.OpenHandCursor


def test_every_handle_is_named_for_every_lens(window: MainWindow) -> None:
    texts = set()
    for lens in LENSES.values():
        window.store.set_projection(replace(model(window), lens=lens))
        window.panes["world"].reset_view()
        settle()
        for spot in marks(window).values():
            move(window, "world", point_of(spot), button=Qt.MouseButton.NoButton)
            texts.add(tip(window))
        QApplication.sendEvent(window.panes["world"].canvas, QEvent(QEvent.Type.Leave))
    said = " | ".join(texts)
    for part in ("Eye = (5, 4.5, 8)", "Target = (0, 2.2, 0)", "Near = 5", "Far = 16",
                 "Field of view = 45", "Left = −0.6", "Top = 2.5"):  # fmt: skip
        assert part in said, part
    assert all("Drag" in text and "=" in text for text in texts)


def test_near_past_far_stops_before_it_until_the_drag_ends(window: MainWindow) -> None:
    bar = held_line(window)
    handle, spot = mark(window, "near")
    size = window.panes["world"].canvas.size()
    far = along(window, handle, near=15.9)
    press(window, "world", point_of(spot))
    move(window, "world", point_of(spot) + QPoint(far[0] // 2, far[1] // 2))
    good = model(window)
    assert good.lens.near > 1.0 and not bar.isVisible(), "the plane says it itself"
    past = QPoint(round(1.3 * far[0]), round(1.3 * far[1]))
    move(window, "world", point_of(spot) + past)
    assert good.lens.near < 15.0 < model(window).lens.near < 16.0, "it stops at the bound"
    assert bar.text().startswith("Near = ") and bar.text().endswith(
        "must be less than far, which is 16."
    )
    assert bar.isVisible() and gap(window, marks(window)[handle]) < 40.0
    assert bar.height() < 2 * bar.fontMetrics().height(), "one line"
    assert bar.isVisible() and window.panes["world"].canvas.size() == size  # nothing was pushed
    move(window, "world", point_of(spot) + QPoint(far[0] // 3, far[1] // 3))
    assert not bar.isVisible() and model(window).lens.near < good.lens.near
    move(window, "world", point_of(spot) + past)
    assert "must" in bar.text()
    held = model(window)
    release(window, "world", point_of(spot) + past)
    assert not bar.isVisible() and model(window) == held


def test_escape_cancels_a_drag(window: MainWindow) -> None:
    """Also while the keyboard is in a field."""
    window.slots.go_back()  # a pane that is alone is left by Esc before a probe is
    window.probe_panel.follow(point=(0.0, 0.5, 0.5))
    field: Any = window.controls.rows["near"].field  # type: ignore[attr-defined]
    activate(window)
    field.setFocus()
    settle()
    start = model(window)
    window.store.undo()
    before = model(window)
    window.store.redo()
    window.store.mark_saved()
    _, spot = mark(window, "target")
    press(window, "world", point_of(spot))
    move(window, "world", point_of(spot) + QPoint(30, 12))
    assert model(window) != start
    move(window, "world", point_of(spot), button=Qt.MouseButton.NoButton)  # late, from before
    assert world(window).handles.held == TARGET
    assert QApplication.focusWidget() is field
    QTest.keyClick(field, Qt.Key.Key_Escape)
    assert model(window) == start
    move(window, "world", point_of(spot) + QPoint(50, 30))  # the drag is over
    assert model(window) == start
    release(window, "world", point_of(spot) + QPoint(50, 30))
    assert model(window) == start and not window.store.modified
    assert len(window.probe_panel.probes) == 1
    QTest.keyClick(field, Qt.Key.Key_Escape)  # is the probe's again
    assert window.probe_panel.probes == ()
    window.store.undo()
    assert model(window) == before != start, "it was no step"


def test_another_lens_ends_the_drag(window: MainWindow) -> None:
    _, spot = mark(window, "corner")
    press(window, "world", point_of(spot))
    move(window, "world", point_of(spot) + QPoint(8, 8))
    window.store.set_projection(replace(model(window), lens=LENSES["orthographic"]))
    move(window, "world", point_of(spot) + QPoint(20, 20))
    assert model(window).lens == LENSES["orthographic"]
    release(window, "world", point_of(spot) + QPoint(20, 20))
    assert not window.store.in_gesture


@pytest.mark.parametrize("kind", [QDialog, QMenu])
def test_a_button_that_is_released_over_a_dialog_or_a_menu_ends_the_drag(
    window: MainWindow, kind: Any
) -> None:
    activate(window)
    canvas, slider = window.panes["world"].canvas, window.controls.rows["near"].slider
    _, spot = mark(window, "corner")
    handle = QStyleOptionSlider()
    slider.initStyleOption(handle)
    part = QStyle.ComplexControl.CC_Slider, handle, QStyle.SubControl.SC_SliderHandle, slider
    thumb = slider.style().subControlRect(*part).center()
    for widget, place in ((canvas, point_of(spot)), (slider, thumb)):
        widget.setFocus()
        QTest.mousePress(widget, LEFT, NONE, place)
        move_mouse(widget, place + QPoint(8, 8))
        move_mouse(widget, place + QPoint(16, 8))
        assert window.store.in_gesture
        over = kind(window)
        over.addAction(QAction("an item", over))
        over.open() if kind is QDialog else over.popup(window.pos())
        activate(over) if kind is QDialog else settle()
        over.close()  # where the button was released
        activate(window)
        move_mouse(widget, place + QPoint(30, 30), Qt.MouseButton.NoButton)
        is_by_menu = kind is QMenu and widget is canvas  # then the next press ends it
        assert window.store.in_gesture == is_by_menu and not slider.isSliderDown()
        before = model(window)
        QTest.mousePress(canvas, LEFT, NONE, QPoint(9, 9))
        move_mouse(canvas, QPoint(90, 30))
        QTest.mouseRelease(canvas, LEFT, NONE, QPoint(90, 30))
        assert model(window) == before and not window.store.in_gesture


def test_a_drag_while_the_animation_plays_moves_its_own_field_only(window: MainWindow) -> None:
    handle, spot = mark(window, "near")
    way = along(window, handle, near=4.0)
    press(window, "world", point_of(spot))
    move(window, "world", point_of(spot) + QPoint(way[0] // 2, way[1] // 2))
    elsewhere = Camera((-6.0, 5.0, 9.0), (0.0, 2.2, 0.0))
    window.store.set_projection(replace(model(window), camera=elsewhere))
    move(window, "world", point_of(spot) + QPoint(*way))
    assert model(window).camera == elsewhere and model(window).lens.near > 2.0
    release(window, "world", point_of(spot) + QPoint(*way))


# -- the marks


def test_a_step_adds_and_removes_nothing_and_a_figure_has_no_marks() -> None:
    scene, counts = load("letter-f"), []
    for live in (False, True):
        plotter = OffScreen(400, 400)
        drawing = WorldDrawing(plotter, scene, WORDS, LIGHT, live=live)
        drawing.show_names(None)
        props = plotter.renderer.GetViewProps()
        first = props.GetNumberOfItems()
        for near in (1e-6, 0.5, 2.0, 9.0):
            drawing.show_projection(replace(scene.start, lens=Perspective(50.0, near, 1e6)))
            drawing.hold(EYE)
        assert props.GetNumberOfItems() == first
        counts.append(first)
        assert (drawing.handles.held is not None) == live
        spot = drawing.sight.seen([scene.start.camera.eye])[0].tolist()
        taken = drawing.handles.at(tuple(spot))
        assert (taken is not None and taken.handle == EYE) == live
        drawing.remove()
        plotter.close()
    assert counts[1] == counts[0] + 1


def at_rest(window: MainWindow) -> set[str]:
    """The handles whose grips are drawn."""
    handles: Any = world(window).handles
    return {handle.setting or handle.name for handle in handles.drawn}


def test_the_grips_at_rest_are_those_of_the_scene_s_controls(
    make_scene: Callable[[str], MainWindow],
) -> None:
    for scene, names in {
        "letter-f": {"eye", "target", "near", "far"},
        "similar-triangles": {"point", "distance", "eye"},
        "affine-depth": {"start", "end", "near", "far"},
        "off-axis-window": {"shift", "corner"},
        "planar-shadow": {"light", "height"},
    }.items():
        window = make_scene(scene)
        assert at_rest(window) == names, scene
        assert len(world(window).handles.drawn) <= 4


def test_the_marks_of_a_moved_view_are_where_the_view_shows_them(window: MainWindow) -> None:
    before, canvas = marks(window), window.panes["world"].canvas
    QTest.mousePress(canvas, MIDDLE, NONE, pos=QPoint(300, 300))  # on the far plane, it turns
    for way in ((20, 5), (60, 10)):
        move(window, "world", QPoint(300, 300) + QPoint(*way), button=MIDDLE)
    QTest.mouseRelease(canvas, MIDDLE, NONE, pos=QPoint(360, 310))
    after = marks(window)
    assert EYE in before and EYE in after and before[EYE] != after[EYE]
    renderer = window.panes["world"].canvas.renderer
    eye = np.array(model(window).camera.eye) - load("letter-f").origin
    renderer.SetWorldPoint(*eye, 1.0)
    renderer.WorldToDisplay()
    x, y, _ = renderer.GetDisplayPoint()
    height = window.panes["world"].canvas.render_window.GetSize()[1]
    assert after[EYE] == pytest.approx((x, height - y), abs=1e-3)


# -- the image pane


def picture(window: MainWindow) -> Any:
    return window.panes["image"].drawing


def target_px(window: MainWindow) -> np.ndarray:
    """The pixel of the first target in the image pane."""
    left, top, width, height = picture(window).picture_rectangle_px
    x, y = model(window).trace(load("letter-f").start.camera.target).image
    return np.array([left + x * width / 1280, top + y * height / 720])


def test_the_picture_is_dragged_with_what_is_as_far_as_the_target(window: MainWindow) -> None:
    for lens in LENSES.values():
        window.store.set_projection(replace(model(window), lens=lens))
        window.store.mark_saved()
        settle()
        start, before = model(window), target_px(window)
        left, top, width, height = picture(window).picture_rectangle_px
        middle = QPoint(left + width // 3, top + height // 4)
        assert window.probe_panel.probes == ()
        drag(window, "image", middle, (12, 9), (-31, 17))
        assert target_px(window) - before == pytest.approx([-31.0, 17.0], abs=0.5)
        assert model(window).camera.frame == pytest.approx(start.camera.frame, abs=1e-12)
        assert model(window).lens == start.lens and window.probe_panel.probes == ()
        window.store.undo()
        assert model(window) == start and not window.store.modified


def test_a_drag_beside_the_picture_and_one_on_a_probe_leave_the_camera(
    make_window: MakeWindow,
) -> None:
    window = make_window()
    settle()
    window.probe_panel.follow(point=(1.5, 5.0, 0.5))
    settle()
    start = model(window)
    drag(window, "image", QPoint(3, 3), (15, 10), (40, 30))
    assert model(window) == start
    left, top, width, height = picture(window).picture_rectangle_px
    x, y = model(window).trace((1.5, 5.0, 0.5)).image
    drag(window, "image", point_of((left + x * width / 1280, top + y * height / 720)), (20, 12))
    assert model(window) == start
    assert window.probe_panel.probes[0].point != (1.5, 5.0, 0.5)


def test_the_wheel_dollies_and_a_burst_is_one_step(window: MainWindow, qtbot: Any) -> None:
    start = model(window)
    with qtbot.waitSignal(window.manipulation.gesture_finished):
        for steps in (1, 1, 0.5):
            wheel(window, steps)
        assert window.store.in_gesture
    end = model(window).camera
    distance = start.camera.distance
    assert end.distance == pytest.approx(distance * ZOOM_PER_WHEEL_STEP**-2.5)
    assert end.target == start.camera.target
    assert end.frame == pytest.approx(start.camera.frame, abs=1e-12)
    window.store.undo()
    assert model(window) == start
    wheel(window, -1.0)
    assert model(window).camera.distance == pytest.approx(distance * ZOOM_PER_WHEEL_STEP)


def test_the_wheel_stops_before_the_target_and_says_so(window: MainWindow, qtbot: Any) -> None:
    near = Camera((1.0 + 2.0**-52, 2.0, 3.0), (1.0, 2.0, 3.0))
    window.store.set_projection(replace(model(window), camera=near))
    bar = held_line(window)
    with qtbot.waitSignal(window.manipulation.gesture_finished):
        wheel(window, 20.0, wait=False)  # half a second later it goes
        assert model(window).camera == near
        assert bar.text() == (
            "Eye = (1, 2, 3): must differ from the target, or the camera looks nowhere."
        )
    assert not bar.isVisible()


def test_the_end_of_a_wheel_burst_after_the_window_has_closed_does_nothing(
    make_window: MakeWindow, qtbot: Any
) -> None:
    window = make_window()
    with qtbot.waitSignal(window.manipulation.gesture_finished):
        wheel(window, 1.0, wait=False)
        window.store.mark_saved()
        window.close()


# -- points of a scene's settings


@pytest.fixture
def make_scene(window: MainWindow) -> Callable[[str], MainWindow]:
    window.slots.go_back()
    return partial(show_scene, window)


def grip(window: MainWindow, setting: str) -> tuple[Handle, tuple[float, float]]:
    return next((h, spot) for h, spot in marks(window).items() if h.setting == setting)


POINTS = [
    ("similar-triangles", "point"), ("eye-plane", "start"), ("eye-plane", "end"),
    ("affine-depth", "start"), ("planar-shadow", "light"),
]  # fmt: skip


def test_a_point_of_the_scene_follows_the_mouse_in_one_step(
    make_scene: Callable[[str], MainWindow],
) -> None:
    for scene, setting in POINTS:
        window = make_scene(scene)
        settle()  # or the panel may still grow by a line of its text
        before, seen_before = window.store.document, view(window)
        steps = len(list(window.store.documents))
        _, spot = grip(window, setting)
        drag(window, "world", point_of(spot), (6, 0), (14, -9))
        assert window.store.document.settings[setting] != before.settings[setting]
        now = grip(window, setting)[1]
        assert np.subtract(now, spot) == pytest.approx((14, -9), abs=1.0), setting
        assert model(window) == before.projection and view(window) == seen_before
        assert len(list(window.store.documents)) == steps + 1
        window.store.undo()
        assert window.store.document == before


def test_a_plane_seen_edge_on_is_dragged_along_its_rail(
    make_scene: Callable[[str], MainWindow],
) -> None:
    window = make_scene("similar-triangles")
    settle()
    assert window.panes["world"].drawing.fixed == "side"  # type: ignore[union-attr]
    before, (_, spot) = window.store.document, grip(window, "distance")
    eye = next(at for handle, at in marks(window).items() if handle.name == "eye")
    rail = np.subtract(spot, eye)
    drag(window, "world", point_of(spot), (6, 0), (30, -12))
    way = np.subtract(grip(window, "distance")[1], spot)
    # To the place of the rail that is nearest to the mouse; the distance is in proportion.
    assert way == pytest.approx(rail * (rail @ (30, -12)) / (rail @ rail), abs=1.0)
    now = window.store.document.settings["distance"]
    grown = 1.0 + np.hypot(*way) / np.hypot(*rail)
    assert now / before.settings["distance"] == pytest.approx(grown, rel=0.02)
    window.store.undo()
    assert window.store.document == before


def test_the_panes_stand_still_during_a_drag_although_the_readout_grows(
    make_scene: Callable[[str], MainWindow],
) -> None:
    window = make_scene("eye-plane")
    settle()
    pane, card = window.panes["world"], window.controls.card
    size = pane.size()
    at = point_of(grip(window, "start")[1])
    press(window, "world", at)
    move(window, "world", at + QPoint(30, 0))
    before = card.height()
    card.warning.show_text("Such a long warning that there is no room for it. " * 5)
    card.readout.show_readings([Reading("a number", (-1.23456e-12, -6.54321e-12), "px")] * 9)
    settle()
    assert card.height() > before and pane.size() == size
    release(window, "world", at)


def test_the_sun_is_held_by_its_direction(make_scene: Callable[[str], MainWindow]) -> None:
    window = make_scene("planar-shadow")
    window.store.set_settings({"kind": "sun", "light": (-1.0, 2.0, 1.0)})
    settle()
    _, spot = grip(window, "light")
    at = point_of(spot)
    drag(window, "world", at, (-20, 0))
    turned = np.array(window.store.document.settings["light"])
    assert np.subtract(grip(window, "light")[1], spot)[0] < -5.0
    window.store.undo()
    settle()
    press(window, "world", at)
    move(window, "world", at + QPoint(9, 9))
    assert tuple(window.store.document.settings["light"]) != (-1.0, 2.0, 1.0)
    QTest.keyClick(window, Qt.Key.Key_Escape)
    assert window.store.document.settings["light"] == (-1.0, 2.0, 1.0)
    release(window, "world", at)
    assert not np.allclose(turned / np.linalg.norm(turned), np.array([-1, 2, 1]) / math.sqrt(6.0))


def test_a_point_that_is_dragged_beyond_the_horizon_of_the_cube_is_at_infinity(
    make_scene: Callable[[str], MainWindow],
) -> None:
    window = make_scene("similar-triangles")
    drawing: Any = window.panes["ndc"].drawing
    spots = {handle.setting: spot for handle, spot in drawing.handles.shown}
    at = point_of(spots["point"])
    press(window, "ndc", at)
    for way in (200, 700):
        move(window, "ndc", at + QPoint(way, 0))
    bar = held_line(window)
    assert bar.text() == "Point P = ∞: must be three finite numbers x, y, z."
    release(window, "ndc", at)


@pytest.mark.parametrize(
    ("scene", "name"),
    [("field-of-view", "distance"), ("off-axis-window", "eye"), ("focus", "focus")],
)
def test_escape_puts_back_what_follows_a_value_to_its_last_digit(
    make_scene: Callable[[str], MainWindow], scene: str, name: str
) -> None:
    window = make_scene(scene)
    spot = next(at for each, at in marks(window).items() if name in (each.name, each.setting))
    before, at, steps = window.store.document, point_of(spot), len(list(window.store.documents))
    press(window, "world", at)
    for way in (20, 60, 200):
        move(window, "world", at + QPoint(way, 0))
    assert window.store.document != before
    QTest.keyClick(window, Qt.Key.Key_Escape)
    release(window, "world", at)
    assert window.store.document == before and len(list(window.store.documents)) == steps


def test_a_refusal_is_about_what_is_dragged(make_scene: Callable[[str], MainWindow]) -> None:
    for scene, name, said in (
        ("off-axis-window", "left", "Left = "),
        ("camera-obscura", "distance", "Film distance d = "),
    ):
        window = make_scene(scene)
        spots = marks(window).items()
        spot = next(
            at for each, at in spots if name in (each.setting, *moved_names(window, each)[:1])
        )
        at, texts = point_of(spot), set[str]()
        press(window, "world", at)
        for way in ((300, 0), (0, 300), (-300, 0), (0, -300), (-500, 500), (700, 0)):
            move(window, "world", at + QPoint(*way))
            texts |= {held_line(window).text()} if held_line(window).isVisible() else set()
        release(window, "world", at)
        assert [each for each in texts if "must be less than" in each], texts
        assert not [each for each in texts if not each.startswith(said)], texts


def test_a_light_that_is_dragged_under_the_plane_is_refused_over_the_pane(
    make_scene: Callable[[str], MainWindow],
) -> None:
    window = make_scene("planar-shadow")
    _, spot = grip(window, "light")
    at = point_of(spot)
    press(window, "world", at)
    move(window, "world", at + QPoint(0, 20))
    last = window.store.document.settings["light"]
    assert last[1] < 9.0
    move(window, "world", at + QPoint(0, 600))
    bar = held_line(window)
    assert bar.isVisible() and bar.text().endswith("must lie above the plane y = 0")
    assert bar.text().startswith("Light L = ")
    assert 0.0 < window.store.document.settings["light"][1] < last[1], "it stops at the bound"
    move(window, "world", at + QPoint(0, 10))
    assert bar.isVisible() and "must" not in bar.text()
    release(window, "world", at + QPoint(0, 10))


@pytest.mark.parametrize("name", ["world", "image"])
def test_another_scene_ends_the_drag(window: MainWindow, name: str) -> None:
    """The new scene keeps its camera, and undo restores the dragged state."""
    at = point_of(mark(window, "target")[1])
    if name == "image":
        drawing = window.panes["image"].drawing
        assert isinstance(drawing, ImageDrawing)
        left, top, width, height = drawing.picture_rectangle_px
        at = QPoint(left + width // 2, top + height // 2)
    press(window, name, at)
    for way in (20, 40):
        move(window, name, at + QPoint(way, 5))
    dragged = model(window)
    assert window.store.in_gesture
    window.guide.choose("cube")
    start = model(window)
    for way in (60, 80):
        move(window, name, at + QPoint(way, 5))
    release(window, name, at + QPoint(80, 5))
    assert model(window) == start and not window.store.in_gesture
    window.store.undo()
    assert (window.store.document.scene, model(window)) == ("letter-f", dragged)
