"""The keyboard cursor in the panes: it moves, picks, drags and is read aloud."""

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QWidget

from app.model.projection import Camera, FreeMatrix, Orthographic, Perspective, Projection, Vector
from app.scenes.scene import load
from tests.support.window import MakeWindow, activate, rgb_of, settle
from widgets.panes.canvas import CANVASES, ZOOM_PER_WHEEL_STEP
from widgets.window.main_window import MainWindow

KEY = Qt.Key
NONE, SHIFT = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier
CTRL = Qt.KeyboardModifier.ControlModifier


def press(key: Qt.Key, modifier: Any = NONE, times: int = 1) -> None:
    """Press a key in the widget with the focus."""
    for _ in range(times):
        focus = QApplication.focusWidget()
        assert focus is not None
        QTest.keyClick(focus, key, modifier)
    settle()


def go_to(window: MainWindow, name: str) -> QWidget:
    """Go to a pane as by Tab."""
    canvas = window.panes[name].canvas
    canvas.setFocus(Qt.FocusReason.TabFocusReason)
    settle()
    return canvas


def said(window: MainWindow, name: str = "world") -> str:
    """The text beside the cursor, with all digits."""
    if not window.menus.all_digits.isChecked():
        window.menus.all_digits.trigger()
    label = window.panes[name].canvas.findChild(QLabel, "cursorLabel")
    assert isinstance(label, QLabel)
    text = window.cursors[name].text
    assert label.isVisible() == bool(text) and (not text or label.text() == text)
    return text


def ring(window: MainWindow, name: str = "world") -> tuple[float, float] | None:
    """The cursor's place in device pixels from the pane's top left; None if it is hidden."""
    canvas = window.panes[name].canvas
    widget = canvas.findChild(QWidget, "cursorRing")
    assert widget is not None
    if not widget.isVisible():
        return None
    centre = widget.geometry().center()
    return centre.x() * canvas.pixel_ratio, centre.y() * canvas.pixel_ratio


def go_to_handle(window: MainWindow, words: str) -> None:
    """Go to the handle whose text begins with these words."""
    for _ in range(12):
        press(KEY.Key_PageDown, SHIFT)
        if said(window).startswith(words):
            return
    raise AssertionError(f"no handle says {words}")


def model(window: MainWindow) -> Projection:
    return window.store.document.projection


def seen(window: MainWindow, name: str, point: Vector) -> tuple[float, float]:
    """The pixel of a point in a pane."""
    x, y = window.panes[name].drawing.sight.seen([point])[0].tolist()
    return x, y


def vertex(text: str) -> tuple[float, ...]:
    """The coordinates in a text."""
    return tuple(map(float, text.partition("(")[2].rstrip(")").split(",")))


def walk(window: MainWindow, name: str, key: Qt.Key = KEY.Key_PageDown) -> list[tuple[float, ...]]:
    """All vertices that a key visits until it returns to the first."""
    found: list[tuple[float, ...]] = []
    while True:
        press(key)
        at = vertex(said(window, name))
        if found and at == found[0]:
            return found
        found.append(at)
        assert len(found) < 300


@pytest.fixture(params=sorted(CANVASES))
def either(request: pytest.FixtureRequest, make_window: MakeWindow) -> Iterator[MainWindow]:
    """A window with canvases of either kind, which has the keyboard."""
    window = make_window(canvas=request.param)
    activate(window)
    settle()
    yield window
    request.node.funcargs.clear()  # pytest's hold on it, before survivors are sought


@pytest.fixture
def window(window: MainWindow) -> MainWindow:
    """With the keyboard."""
    activate(window)
    return window


@pytest.fixture
def heard(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The announcements to a screen reader."""
    texts: list[str] = []
    listening = SimpleNamespace(updateAccessibility=lambda event: texts.append(event.message()))
    monkeypatch.setattr("widgets.panes.cursor.QtGui.QAccessible", listening)
    return texts


def test_a_lesson_without_the_mouse(window: MainWindow, heard: list[str]) -> None:
    """Drag near, undo it, follow a vertex, read its probe, drag the eye."""
    start = model(window)
    unvisited = {pane.canvas for pane in window.panes.values()}
    for _ in range(200):  # Tab comes to every pane
        if unvisited or QApplication.focusWidget() is not window.panes["world"].canvas:
            press(KEY.Key_Tab)
            unvisited.discard(QApplication.focusWidget())
    assert not unvisited and said(window) == "" and ring(window) is None
    go_to_handle(window, "Near = ")
    assert heard[-1] == said(window) == f"Near = {start.lens.near:g}"
    at = ring(window)
    assert at is not None
    press(KEY.Key_Return)
    press(KEY.Key_Right, SHIFT, times=3)
    press(KEY.Key_Down)
    near = model(window).lens.near
    assert near != start.lens.near and model(window).camera == start.camera
    assert heard[-1] == said(window) == f"Near = {near:g}"
    moved = ring(window)
    assert moved is not None and math.dist(moved, at) > 5.0
    press(KEY.Key_Return)
    assert not window.store.in_gesture and model(window).lens.near == near
    press(KEY.Key_Z, CTRL)
    assert model(window) == start and not window.store.can_undo  # one step
    assert said(window) == f"Near = {start.lens.near:g}" and ring(window) == at

    press(KEY.Key_PageDown)
    place = vertex(said(window))
    press(KEY.Key_Space)
    (probe,) = window.probe_panel.probes
    assert probe.point == pytest.approx(place, abs=1e-6)
    window.panels.open(window.probe_panel)
    table = window.probe_panel.table.model()
    cells = [
        str(table.index(row, column).data())
        for row in range(table.rowCount())
        for column in range(table.columnCount())
    ]
    assert {f"{part:g}" for part in place} <= set(cells)

    go_to(window, "world")
    go_to_handle(window, "Eye = ")
    press(KEY.Key_Enter, Qt.KeyboardModifier.KeypadModifier)
    press(KEY.Key_Left, times=6)
    press(KEY.Key_Return)
    eye = model(window).camera.eye
    assert eye != start.camera.eye and model(window).lens == start.lens
    assert vertex(said(window)) == pytest.approx(eye, rel=1e-5)
    press(KEY.Key_Z, CTRL)
    assert model(window) == start


# -- where it goes


def in_front_of_all(eye: np.ndarray, vertices: np.ndarray, faces: np.ndarray) -> list[bool]:
    """Which vertices are visible from the eye: each face against each line of sight."""
    free = []
    a, b, c = faces[:, 0], faces[:, 1], faces[:, 2]
    for point in vertices:
        way = np.broadcast_to(eye - point, a.shape)
        with np.errstate(all="ignore"):
            systems = np.stack([b - a, c - a, -way], axis=2)
            flat = np.abs(np.linalg.det(systems)) < 1e-12
            systems[flat] = np.eye(3)
            u, v, t = np.linalg.solve(systems, (point - a)[..., None])[..., 0].T
        hit = ~flat & (u >= -1e-9) & (v >= -1e-9) & (u + v <= 1 + 1e-9) & (t > 1e-6)
        free.append(not hit.any())
    return free


def test_the_cursor_visits_every_visible_vertex_in_both_directions(window: MainWindow) -> None:
    for name in ["world", "ndc", "image"]:
        scene = load("letter-f")
        camera = Camera((6.0, 6.5, 9.0), (0.0, 2.2, 0.0))  # in no face's plane
        lens = Perspective(45.0, 4.0, 18.0)  # the whole letter is between near and far
        window.store.set_projection(replace(model(window), camera=camera, lens=lens))
        go_to(window, name)
        found = walk(window, name)
        assert len(set(found)) == len(found)
        if name == "image":
            surface = scene.surface.triangulate()
            points = np.asarray(surface.points, dtype=np.float64) + scene.origin
            faces = points[surface.regular_faces]
            free = in_front_of_all(np.array(model(window).camera.eye), points, faces)
            drawn = [window.panes[name].drawing.image_pixel(*seen(window, name, p)) for p in points]
            expected = {
                tuple(np.round(point, 5))
                for point, is_free, pixel in zip(points, free, drawn, strict=True)
                if is_free and pixel is not None
            }
            assert {tuple(np.round(point, 5)) for point in found} == expected
        assert walk(window, name, KEY.Key_PageUp) == found[::-1]


def test_handles_always_come_in_the_same_order(window: MainWindow) -> None:
    go_to(window, "world")
    there, back = [], []
    for texts, key in ((there, KEY.Key_PageDown), (back, KEY.Key_PageUp)):
        for _ in range(9):
            press(key, SHIFT)
            texts.append(said(window).partition(" = ")[0])
    assert there[:4] == ["Eye", "Target", "Near", "Far"]
    assert there[:8] == back[7::-1] or there == [*back[:0:-1], there[-1]]
    assert set(there[4:]) & {"Field of view"}


def test_the_cursor_continues_where_the_focus_left(window: MainWindow) -> None:
    go_to(window, "image")
    first, second, third = walk(window, "image")[:3]
    press(KEY.Key_PageDown)
    press(KEY.Key_Tab)
    assert said(window, "image") == "" and ring(window, "image") is None
    go_to(window, "image")
    press(KEY.Key_PageDown)
    assert vertex(said(window, "image")) == third
    press(KEY.Key_Escape)  # forgotten
    press(KEY.Key_PageDown)
    assert vertex(said(window, "image")) == first != second


def test_the_cursor_moves_with_its_vertex(window: MainWindow) -> None:
    places: dict[str, Vector] = {}
    for name in window.panes:
        go_to(window, name)
        press(KEY.Key_PageDown, times=5)
        point = window.shown.scene.origin
        number = vertex(said(window, name))
        surface = window.shown.scene.surface
        assert surface is not None
        points = np.asarray(surface.points, np.float64) + point
        nearest = points[np.abs(points - number).max(axis=1).argmin()].tolist()
        places[name] = tuple(nearest)
        before = ring(window, name)
        camera = replace(model(window).camera, eye=(5.0, 6.0, 10.0))
        window.store.set_projection(replace(model(window), camera=camera))
        settle()
        after = ring(window, name)
        assert after is not None
        assert after == pytest.approx(seen(window, name, places[name]), abs=1.0), name
        window.store.undo()
        settle()
        back = ring(window, name)
        assert back == pytest.approx(seen(window, name, places[name]), abs=1.0)
        # The world stays framed as the change has framed it: nothing is cut.
        assert back == before or name == "world"
        if name == "world":  # whose own view is turned
            press(KEY.Key_Left)
            turned = ring(window, name)
            assert turned not in (None, back)
            assert turned == pytest.approx(seen(window, name, places[name]), abs=1.0)


def test_an_invisible_vertex_hides_the_cursor(window: MainWindow) -> None:
    go_to(window, "image")
    press(KEY.Key_PageDown)
    start, place = model(window), ring(window, "image")
    turned = replace(start.camera, target=(12.0, 8.0, 18.0))
    window.store.set_projection(replace(start, camera=turned))
    settle()
    assert ring(window, "image") is None
    assert said(window, "image").startswith("Vertex (")
    press(KEY.Key_Space)
    press(KEY.Key_Return)
    assert window.probe_panel.probes == () and not window.store.in_gesture
    press(KEY.Key_PageDown)
    assert said(window, "image") == "No other vertex is visible"
    window.store.undo()
    settle()
    press(KEY.Key_PageDown)
    assert ring(window, "image") not in (None, place)


# -- drags


def hold(window: MainWindow, words: str, modifier: Any = NONE) -> None:
    go_to(window, "world")
    go_to_handle(window, words)
    press(KEY.Key_Return, modifier)
    assert window.store.in_gesture


def test_escape_puts_back_the_drag_then_goes_then_removes_the_probe(window: MainWindow) -> None:
    start = model(window)
    go_to(window, "world")
    press(KEY.Key_PageDown)
    press(KEY.Key_Space)
    hold(window, "Target = ")
    press(KEY.Key_Up, SHIFT, times=2)
    assert model(window) != start
    press(KEY.Key_Escape)
    assert model(window) == start and not window.store.in_gesture
    assert said(window).startswith("Target = ") and len(window.probe_panel.probes) == 1
    view = window.panes["world"].hand.camera.GetPosition()
    press(KEY.Key_Up)  # which turns the view again
    assert model(window) == start and window.panes["world"].hand.camera.GetPosition() != view
    press(KEY.Key_Escape)
    assert said(window) == "" and len(window.probe_panel.probes) == 1
    press(KEY.Key_Escape)
    assert window.probe_panel.probes == ()


def test_a_drag_goes_by_pixels_and_the_view_stands_still(window: MainWindow) -> None:
    hold(window, "Target = ")
    at, view = ring(window), window.panes["world"].hand.camera.GetPosition()
    assert at is not None
    press(KEY.Key_Right, times=3)
    press(KEY.Key_Down, SHIFT)
    for key in (KEY.Key_Plus, KEY.Key_Home, KEY.Key_PageDown, KEY.Key_Space):
        press(key)
    now = ring(window)
    assert now is not None and np.subtract(now, at) == pytest.approx((3.0, 10.0), abs=1.0)
    assert window.panes["world"].hand.camera.GetPosition() == view
    assert window.probe_panel.probes == () and window.store.in_gesture


def test_a_refused_drag_stops_at_the_bound_and_turns_back_at_once(
    window: MainWindow, heard: list[str]
) -> None:
    hold(window, "Near = ")
    press(KEY.Key_Left, SHIFT, times=80)
    far = model(window).lens.far
    assert f"must be less than far, which is {far:g}" in said(window) == heard[-1]
    assert not window.manipulation.line.isVisible()
    stopped = model(window).lens.near
    assert 0.9 * far < stopped < far
    press(KEY.Key_Right, SHIFT)
    assert model(window).lens.near < stopped and said(window).startswith("Near = ")
    press(KEY.Key_Escape)


def test_shift_and_enter_drag_up_and_down(window: MainWindow) -> None:
    start = model(window).camera.eye
    hold(window, "Eye = ", SHIFT)
    press(KEY.Key_Up, SHIFT, times=2)
    press(KEY.Key_Right, times=4)
    eye = model(window).camera.eye
    assert (eye[0], eye[2]) == (start[0], start[2]) and eye[1] > start[1]


def test_undo_takes_back_what_is_being_dragged_as_one_step(window: MainWindow) -> None:
    start = model(window)
    hold(window, "Target = ")
    press(KEY.Key_Left, times=4)
    dragged = model(window)
    press(KEY.Key_Z, CTRL)
    assert model(window) == start and not window.store.in_gesture
    assert not window.store.can_undo and said(window).startswith("Target = (0, 2.2, 0")
    window.store.redo()
    assert model(window) == dragged != start


def to_another_scene(window: MainWindow) -> None:
    window.guide.choose("cube")


def to_another_lens(window: MainWindow) -> None:
    lens = Orthographic(-4.0, 4.0, -2.5, 2.5, 2.0, 16.0)
    window.store.set_projection(replace(model(window), lens=lens))


def to_a_free_matrix(window: MainWindow) -> None:
    lens = FreeMatrix(tuple(map(tuple, model(window).clip_from_view.tolist())))
    window.store.set_projection(replace(model(window), lens=lens))


def to_another_pane(window: MainWindow) -> None:
    press(KEY.Key_Tab)


def to_a_floating_pane(window: MainWindow) -> None:
    window.slots.toggle_float("world")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (to_another_scene, "Near = "), (to_another_lens, "Eye = "), (to_a_free_matrix, "Near = "),
        (to_another_pane, "Eye = "), (to_a_floating_pane, "Near = "),
    ],
)  # fmt: skip
def test_the_cursor_releases_a_handle_that_disappears(
    window: MainWindow, change: Callable[[MainWindow], None], words: str
) -> None:
    hold(window, words)
    press(KEY.Key_Left, SHIFT, times=2)
    change(window)
    settle()
    assert not window.store.in_gesture
    after = window.store.document
    canvas = window.panes["world"].canvas
    canvas.setFocus(Qt.FocusReason.TabFocusReason)
    for key in (KEY.Key_Left, KEY.Key_Return, KEY.Key_Return, KEY.Key_Escape):
        QTest.keyClick(canvas, key)
    settle()
    assert replace(window.store.document, view=after.view) == after
    assert not window.store.in_gesture
    window.store.undo()
    assert window.store.document.projection != after.projection


def test_the_mouse_takes_over_from_the_keyboard(window: MainWindow) -> None:
    hold(window, "Target = ")
    press(KEY.Key_Left, times=4)
    dragged = model(window)
    canvas = window.panes["world"].canvas
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=canvas.rect().bottomLeft())
    assert not window.store.in_gesture
    press(KEY.Key_Left)
    assert model(window) == dragged
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=canvas.rect().bottomLeft())


def test_the_cursor_says_that_there_is_no_handle(window: MainWindow, heard: list[str]) -> None:
    clip, view = (
        tuple(map(tuple, matrix.tolist()))
        for matrix in (model(window).clip_from_view, model(window).view_from_world)
    )
    lens = FreeMatrix(clip, view)
    window.store.set_projection(replace(model(window), lens=lens))
    settle()
    go_to(window, "world")
    press(KEY.Key_PageDown, SHIFT)
    assert heard[-1] == said(window) == "There is nothing else to drag"
    assert ring(window) is None
    press(KEY.Key_PageDown)
    assert said(window).startswith("Vertex (") and ring(window) is not None
    go_to(window, "ndc")
    press(KEY.Key_PageUp, SHIFT)
    assert said(window, "ndc") == "There is nothing else to drag"
    press(KEY.Key_PageDown)
    press(KEY.Key_Return)
    assert said(window, "ndc") == "There is nothing to drag here"
    assert not window.store.in_gesture


def test_the_cursor_says_that_no_vertex_is_visible(window: MainWindow) -> None:
    camera = Camera((0.0, 2.0, 50.0), (0.0, 2.0, 90.0))
    window.store.set_projection(replace(model(window), camera=camera))
    settle()
    for name in ("ndc", "image"):
        go_to(window, name)
        press(KEY.Key_PageDown)
        assert said(window, name) == "No other vertex is visible" and ring(window, name) is None
        press(KEY.Key_Space)
        assert window.probe_panel.probes == ()


def test_the_cursor_works_in_a_floating_pane(window: MainWindow) -> None:
    window.slots.toggle_float("world")
    pane = window.panes["world"]
    pane.activateWindow()
    assert QTest.qWaitForWindowActive(pane)
    pane.canvas.setFocus(Qt.FocusReason.TabFocusReason)
    start = model(window)
    go_to_handle(window, "Near = ")
    press(KEY.Key_Return)
    press(KEY.Key_Right, SHIFT, times=2)
    assert model(window) != start
    press(KEY.Key_Escape)
    assert model(window) == start and said(window) == f"Near = {start.lens.near:g}"


# -- the image pane


def pixel(window: MainWindow, point: Vector) -> tuple[float, float]:
    """The image's pixel of a point."""
    x, y = model(window).trace(point).image.tolist()
    return x, y


def test_a_probe_is_dragged_in_the_image(either: MainWindow) -> None:
    window = either
    canvas: Any = go_to(window, "image")
    press(KEY.Key_PageDown, times=3)
    press(KEY.Key_Space)
    place = window.probe_panel.probes[0].point
    assert place is not None
    start, document = pixel(window, place), window.store.document
    press(KEY.Key_Return)
    press(KEY.Key_Right, times=4)
    press(KEY.Key_Up, SHIFT)
    moved = window.probe_panel.probes[0].point
    assert moved is not None
    way = np.subtract(pixel(window, moved), start)
    rectangle = window.panes["image"].drawing.picture_rectangle_px
    per_px = np.divide(model(window).image_size, (rectangle.width, rectangle.height))
    assert way == pytest.approx((4.0, -10.0) * per_px * canvas.pixel_ratio, abs=1e-6)
    assert said(window, "image").startswith("Point 1 (")
    assert ring(window, "image") == pytest.approx(seen(window, "image", moved), abs=1.0)
    press(KEY.Key_Return)
    press(KEY.Key_PageDown)  # away from it, and back
    press(KEY.Key_PageDown, SHIFT)
    assert said(window, "image").startswith("Point 1 (")
    press(KEY.Key_Return, SHIFT)  # along its ray
    press(KEY.Key_Up, SHIFT, times=3)
    farther = window.probe_panel.probes[0].point
    assert farther is not None
    assert pixel(window, farther) == pytest.approx(pixel(window, moved), abs=1e-6)
    assert math.dist(farther, moved) > 1e-3
    press(KEY.Key_Escape)
    assert window.probe_panel.probes[0].point == moved
    assert window.store.document.projection == document.projection


def test_the_picture_is_dragged_from_a_vertex_that_has_no_probe(window: MainWindow) -> None:
    start = model(window)
    go_to(window, "image")
    press(KEY.Key_PageDown)
    at = ring(window, "image")
    assert at is not None
    press(KEY.Key_Return)
    press(KEY.Key_Left, SHIFT, times=3)
    now = ring(window, "image")
    assert now is not None and now[0] < at[0] - 20.0
    assert model(window).camera.frame == pytest.approx(start.camera.frame, abs=1e-12)
    assert model(window).camera != start.camera
    press(KEY.Key_Return)
    press(KEY.Key_Z, CTRL)
    assert model(window) == start and not window.store.can_undo


def test_arrows_move_the_camera_in_its_plane_and_plus_goes_nearer(
    window: MainWindow, qtbot: Any
) -> None:
    start = model(window)
    assert isinstance(start.lens, Perspective)
    go_to(window, "image")
    target = start.camera.target
    before = seen(window, "image", target)
    with qtbot.waitSignal(window.manipulation.gesture_finished):
        press(KEY.Key_Right, times=2)
        press(KEY.Key_Up)
        assert np.subtract(seen(window, "image", target), before) == pytest.approx(
            np.multiply((50.0, -25.0), window.panes["image"].canvas.pixel_ratio), abs=0.5
        )
        press(KEY.Key_Plus)
        press(KEY.Key_Minus)
        press(KEY.Key_Equal)
        ratio = model(window).camera.distance / start.camera.distance
        assert ratio == pytest.approx(1.0 / ZOOM_PER_WHEEL_STEP)
        assert model(window).camera.frame == pytest.approx(start.camera.frame, abs=1e-12)
    press(KEY.Key_Z, CTRL)
    assert model(window) == start and not window.store.can_undo


# -- how it is seen


@pytest.mark.parametrize("theme", ["light", "dark"])
def test_the_ring_stands_out_from_bright_and_dark(window: MainWindow, theme: str) -> None:
    window.look.set_theme(theme)
    canvas: Any = go_to(window, "world")
    settle()
    before = rgb_of(canvas.grab().toImage()).astype(int)
    press(KEY.Key_PageDown)
    after = rgb_of(canvas.grab().toImage()).astype(int)
    widget = canvas.findChild(QWidget, "cursorRing")
    area, ratio = widget.geometry().intersected(canvas.rect()), canvas.devicePixelRatioF()
    rows = slice(round(area.top() * ratio), round(area.bottom() * ratio) + 1)
    columns = slice(round(area.left() * ratio), round(area.right() * ratio) + 1)
    cut = after[rows, columns]
    changed = (before[rows, columns] != cut).any(axis=2)
    brightness = cut.mean(axis=2)
    assert (changed & (brightness > 200)).sum() > 30
    assert (changed & (brightness < 70)).sum() > 30


def test_label_and_ring_lie_in_the_pane_and_do_not_overlap(window: MainWindow) -> None:
    for name, pane in window.panes.items():
        go_to(window, name)
        label, circle = (pane.canvas.findChild(QWidget, f"cursor{w}") for w in ("Label", "Ring"))
        assert label is not None and circle is not None
        for _ in range(20):
            press(KEY.Key_PageDown)
            assert pane.canvas.rect().contains(label.geometry())
            assert not label.geometry().intersects(circle.geometry())


def test_the_pointer_follows_the_cursor(window: MainWindow) -> None:
    window.probing.set_pointing(True)
    go_to(window, "image")
    press(KEY.Key_PageDown)
    for pane in window.panes.values():
        (probe,) = pane.probes
        assert probe.number == 0
        assert probe.point == pytest.approx(vertex(said(window, "image")), abs=1e-5)
    press(KEY.Key_Escape)
    assert all(not pane.probes for pane in window.panes.values())


def test_its_keys_are_no_shortcuts_and_are_named(window: MainWindow) -> None:
    taken = {
        action.shortcut().toString()
        for widget in (window, *window.panes.values())
        for action in widget.actions()
    }
    for key in ("PgDown", "PgUp", "Shift+PgDown", "Shift+PgUp", "Space", "Return", "Enter", "Left"):
        assert key not in taken
    for pane in window.panes.values():
        heard_of = pane.canvas.accessibleDescription()
        for word in ("Page Down", "Shift", "Space", "Enter", "Escape", "Arrow"):
            assert word in heard_of
