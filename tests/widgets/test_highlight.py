"""Linked highlight: a thing under the mouse is highlighted everywhere."""

import math
from dataclasses import asdict, replace
from itertools import product
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from app.document.view import EVERYTHING
from app.lecture.highlight import CORNERS, NOTHING, OBJECT_AXES, corner_at, made_of
from app.lecture.notation import letters_in, matrices
from app.lecture.stages import VIEW, WORLD
from app.model.projection import DEPTH_RANGES, LENSES, Camera, Perspective, Projection
from app.scenes.scene import load
from tests.support.drawings import lit_at
from tests.support.frustum import corners_world
from tests.support.samples import pairwise
from tests.support.window import (
    Highlighted,
    activate,
    counted_repaints,
    pixels,
    rgb_of,
    settle,
    show_scene,
)
from widgets.panels.matrix_view import MatrixView
from widgets.parts.panel import Highlighter
from widgets.window.main_window import MainWindow

START = load("letter-f").start
PLANES = {"near", "far", "left", "right", "bottom", "top"}


def hover(window: MainWindow, widget: QWidget, place: QPoint | None = None) -> None:
    """Move the mouse as the window system does, with enter and leave, without a button."""
    if place is None:
        place = widget.rect().center()
    QTest.mouseMove(window.windowHandle(), widget.mapTo(window, place))
    settle()


def point_at(window: MainWindow, name: str, x_px: float, y_px: float) -> None:
    """Hover a pixel of a pane's canvas."""
    hover(window, window.panes[name].canvas, QPoint(math.floor(x_px), math.floor(y_px)))


def leave(window: MainWindow) -> None:
    hover(window, window.menuBar(), QPoint(window.menuBar().width() - 2, 2))


def pictures(window: MainWindow) -> dict[str, np.ndarray]:
    return {name: pixels(window, name) for name in window.panes}


def changed(before: dict[str, np.ndarray], after: dict[str, np.ndarray]) -> set[str]:
    return {name for name in before if not np.array_equal(before[name], after[name])}


def marked(window: MainWindow) -> set[str]:
    """The visible rows that are marked."""
    rows = window.controls.rows.items()
    return {name for name, row in rows if row.is_marked and row.isVisibleTo(window)}


@pytest.fixture
def window(window: MainWindow) -> MainWindow:
    """With the mouse on nothing."""
    activate(window)
    leave(window)
    return window


@pytest.fixture
def highlighted(window: MainWindow) -> Highlighted:
    return Highlighted(window)


# -- words


def test_a_corner_has_its_planes_for_a_name() -> None:
    assert len(CORNERS) == len(set(CORNERS)) == 8
    for name in CORNERS:
        assert len(made_of(frozenset((name,))) & PLANES) == 3
    assert corner_at("left", "top") == {"near_left_top", "far_left_top"}
    assert made_of(frozenset(("u",))) == {"u"}


def test_the_latest_counts_and_the_one_before_comes_back(qtbot: Any) -> None:
    highlighted, seen = Highlighter(), []
    highlighted.changed.connect(seen.append)
    near, far = frozenset(("near",)), frozenset(("far",))
    highlighted.mark("keyboard", far)
    highlighted.mark("mouse", near)
    highlighted.mark("mouse", near)
    highlighted.mark("other", NOTHING)
    highlighted.mark("mouse", NOTHING)
    highlighted.mark("keyboard", NOTHING)
    assert seen == [far, near, far, NOTHING]


def test_a_cell_speaks_of_its_letters() -> None:
    stages = {matrix.name: matrix for matrix in matrices(START)}
    view, clip = stages["view_from_world"], stages["clip_from_view"]
    assert letters_in(view, 0, 0) == {"u"} and letters_in(view, 2, 3) == {"n", "eye"}
    assert letters_in(view, 3, 3) == NOTHING
    assert {"near", "far"} <= letters_in(clip, 2, 2) and "fov" in letters_in(clip, 1, 1)
    assert letters_in(clip, 3, 2) == NOTHING
    assert {"u", "fov", "image"} <= letters_in(stages["clip_from_world"], 0, 0)


def test_every_control_has_its_letters() -> None:
    """Whatever the lens, some cell depends on near and far, and all depend on known fields."""
    known = {*"uvn", *PLANES, "eye", "fov", "image", "depth", "keep", "alpha_deg", "beta_deg"}
    known |= {*OBJECT_AXES, "translate", "rotate_deg", "scale"}
    for kind, depth, rows in pairwise(product(LENSES, DEPTH_RANGES, (False, True))):
        spoken: set[str] = set()
        projection = replace(START.with_lens(kind), depth=depth)
        of_lens = set().union(*projection.lens.table.fields.values())
        for matrix in matrices(projection, rows=rows, running=True):
            for i, j in product(range(4), range(4)):
                spoken |= letters_in(matrix, i, j)
        assert {"u", "v", "n", "eye", "near", "far"} <= spoken <= known | of_lens, kind


# -- from a control to the panes


def test_a_hovered_row_is_seen_in_every_pane_that_has_it(
    window: MainWindow, highlighted: Highlighted
) -> None:
    before = pictures(window)
    with counted_repaints(window) as counts:
        hover(window, window.controls.rows["near"])
        assert highlighted.now == {"near"}
        assert counts == {"world": 1, "ndc": 1, "image": 0}
        hover(window, window.controls.rows["near"], QPoint(4, 4))  # still on it
        assert counts == {"world": 1, "ndc": 1, "image": 0}
        assert marked(window) == {"near"}
        leave(window)
        assert counts == {"world": 2, "ndc": 2, "image": 0}
    assert marked(window) == set()
    assert changed(before, pictures(window)) == set()
    hover(window, window.controls.rows["near"])
    assert changed(before, pictures(window)) == {"world", "ndc"}


def test_rows_show_what_they_are_about(window: MainWindow) -> None:
    coordinates = {f"{part}_{axis}" for part in ("eye", "target", "up") for axis in "xyz"}
    for row, panes, rows in [
        ("far", {"world", "ndc"}, {"far"}),
        ("fov_y_deg", {"world", "image"}, {"fov_x_deg", "focal_length_mm", "fx", "fy", "e"}),
        ("window_right", {"world", "ndc", "image"}, {"fov_x_deg", "fx", "focal_length_mm", "e"}),
        ("azimuth_deg", {"world"}, {"azimuth_deg", "elevation_deg", "distance"}),
        ("roll_deg", {"world", "ndc", "image"}, {"azimuth_deg", "elevation_deg", *coordinates}),
    ]:
        for section in window.controls.sections.values():
            section.set_open(section.isAncestorOf(window.controls.rows["fov_x_deg"]))
        if row == "roll_deg":
            window.controls.sections["more_camera"].set_open(True)
        settle()
        leave(window)
        before = pictures(window)
        window.controls.ensureWidgetVisible(window.controls.rows[row])
        hover(window, window.controls.rows[row])
        assert changed(before, pictures(window)) == panes
        assert marked(window) == rows | {row}


@pytest.mark.undrawn
def test_the_keyboard_in_a_row_counts_too(window: MainWindow, highlighted: Highlighted) -> None:
    near, far = window.controls.rows["near"], window.controls.rows["far"]
    near.field.setFocus(Qt.FocusReason.TabFocusReason)
    settle()
    assert highlighted.now == {"near"}
    QTest.keyClick(near.field, Qt.Key.Key_Tab)
    QTest.keyClick(near.slider, Qt.Key.Key_Tab)
    QTest.keyClick(far.field, Qt.Key.Key_Tab)
    settle()
    assert far.slider.hasFocus() and highlighted.now == {"far"}
    hover(window, window.controls.rows["fov_y_deg"])
    assert highlighted.now == {"fov"}
    leave(window)
    assert highlighted.now == {"far"}
    far.slider.clearFocus()
    settle()
    assert highlighted.now == NOTHING


@pytest.mark.undrawn
def test_a_click_leaves_no_highlight_behind(window: MainWindow, highlighted: Highlighted) -> None:
    near = window.controls.rows["near"]
    hover(window, near)
    QTest.mouseClick(near.field, Qt.MouseButton.LeftButton)
    leave(window)
    assert near.field.hasFocus() and highlighted.now == NOTHING


# -- from the panes


def test_the_world_knows_what_is_under_the_mouse(
    window: MainWindow, highlighted: Highlighted
) -> None:
    """With the pane's own sight, which is tested against VTK's camera."""
    window.menus.name_everything.trigger()
    projection = window.store.document.projection
    window.slots.make_large("world")
    window.store.set_view(names=EVERYTHING)  # the target is drawn only if it is named
    settle()
    drawing = window.panes["world"].drawing
    assert drawing is not None
    corners = corners_world(projection)[:, :3]
    camera = projection.camera

    def at(point: Any) -> frozenset[str]:
        ((x_px, y_px),) = drawing.sight.seen([point])
        point_at(window, "world", x_px, y_px)
        return highlighted.now

    assert at(camera.eye) == {"eye"}
    assert at(camera.target) == {"target"}
    assert at(corners[0]) == {"near_left_bottom"} or at(corners[3]) == {"near_left_top"}
    assert at((corners[0] + corners[3]) / 2.0) == {"near"}
    far = (
        drawing.state.volume.corners[4:] + load("letter-f").origin
    )  # where the break lets it be drawn
    assert at(far[1]) == {"far_right_bottom"}
    assert at((far[2] + far[3]) / 2.0) == {"far"}
    # What would be dragged: the field of view, by its corner.
    assert not at(0.5 * corners[0] + 0.5 * far[0]), "an edge from near to far moves nothing"
    lines = {f"near_{side}_top" for side in ("left", "right")}  # one may lie over the other
    assert at(0.4 * np.array(camera.eye) + 0.6 * corners[3]) < lines
    assert len(at(0.25 * far.sum(axis=0))) <= 1  # a face that can be dragged, or none
    assert made_of(highlighted.now) <= PLANES


def test_a_label_can_be_pointed_at(window: MainWindow, highlighted: Highlighted) -> None:
    for text in ["near", "far"]:
        drawing: Any = window.panes["world"].drawing
        label = drawing.board.label(text)
        canvas = window.panes["world"].canvas
        left, right, bottom, top = label.box_px
        y_px = canvas.height() - (bottom + top) / 2
        seen = []
        for x_px in np.linspace(left + 1.0, right - 1.0, 9).tolist():  # an edge may lie over it
            point_at(window, "world", x_px, y_px)
            seen.append((highlighted.now, text in marked(window)))
        assert (frozenset((text,)), True) in seen


def test_what_stands_still_in_cube_and_image_does_not_light_up(
    window: MainWindow, highlighted: Highlighted
) -> None:
    """Near is always the cube's front, and the window always the image's border."""
    projection = window.store.document.projection
    for name in ("ndc", "image"):
        drawing: Any = window.panes[name].drawing
        spots = drawing.sight.seen(corners_world(projection)[:, :3])
        for x_px, y_px in (spots[0], spots[:2].mean(axis=0), spots[:4].mean(axis=0)):
            point_at(window, name, x_px, y_px)
            assert highlighted.now == NOTHING, name


def test_the_cameras_axes_are_highlighted_at_the_strip_before_and_after_they_move(
    window: MainWindow,
) -> None:
    for stop in (WORLD, VIEW):
        window.strip.go_to(float(stop))
        settle()
        before = pixels(window, "ndc")
        window.highlighter.mark("test", frozenset(("u",)))
        settle()
        assert not np.array_equal(before, pixels(window, "ndc"))
        window.highlighter.mark("test", NOTHING)
        settle()
        assert np.array_equal(before, pixels(window, "ndc"))


def test_turning_a_pane_picks_nothing(window: MainWindow) -> None:
    pane, handle = window.panes["world"], window.windowHandle()
    hover(window, pane.canvas)
    asked: list[QPointF] = []
    pane.hand.hovered.connect(asked.append)
    centre = pane.canvas.mapTo(window, pane.canvas.rect().center())
    QTest.mousePress(handle, Qt.MouseButton.MiddleButton, pos=centre)
    for step in range(1, 5):
        QTest.mouseMove(handle, centre + QPoint(20 * step, 0))
    settle()
    while_down = list(asked)
    QTest.mouseRelease(handle, Qt.MouseButton.MiddleButton, pos=centre)
    assert while_down == [] and pane.view is not None  # it has been turned
    hover(window, pane.canvas, pane.canvas.rect().bottomLeft() + QPoint(20, -20))
    assert len(asked) > len(while_down)


# -- matrices, probes


def test_a_cell_marks_the_rows_that_it_depends_on(
    window: MainWindow, highlighted: Highlighted
) -> None:
    window.panels.open(window.matrices)
    settle()
    before = pictures(window)
    view = window.matrices.views["view_from_world"]
    assert isinstance(view, MatrixView)
    hover(window, view, view.cell_rect(2, 0).center().toPoint())
    assert highlighted.now == {"n"}
    assert marked(window) == {"azimuth_deg", "elevation_deg"}
    assert changed(before, pictures(window)) == {"world", "ndc"}
    assert view.is_marked(2, 1) and not view.is_marked(0, 0) and not view.is_marked(3, 3)
    clip = window.matrices.views["clip_from_world"]
    assert clip.is_marked(3, 0)  # w is the distance along n
    window.controls.sections["more_camera"].set_open(True)
    assert {"eye_x", "eye_y", "target_z"} <= marked(window) and "up_y" not in marked(window)
    leave(window)
    assert marked(window) == set() and changed(before, pictures(window)) == set()


@pytest.mark.undrawn
def test_a_row_is_repainted_when_marked_and_unmarked(window: MainWindow) -> None:
    row, painted = window.controls.rows["near"], []

    class Watch(QObject):
        def eventFilter(self, watched: QObject, event: QEvent) -> bool:
            if event.type() == QEvent.Type.Paint and watched is row:
                painted.append(row.is_marked)
            return False

    watch = Watch()
    row.installEventFilter(watch)
    for names in (frozenset(("near",)), NOTHING):
        window.highlighter.mark("test", names)
        settle()
    assert painted == [True, False]


@pytest.mark.undrawn
def test_a_cell_under_the_cursor_counts_and_marks_reach_the_screen(
    window: MainWindow, highlighted: Highlighted
) -> None:
    window.panels.open(window.matrices)
    settle()
    view = window.matrices.views["view_from_world"]
    other = window.matrices.views["clip_from_world"]
    before = other.grab().toImage()
    view.setFocus(Qt.FocusReason.TabFocusReason)
    settle()
    assert highlighted.now == {"u"} and other.grab().toImage() != before
    QTest.keyClick(view, Qt.Key.Key_Down)
    assert highlighted.now == {"v"}
    view.clearFocus()
    settle()
    assert highlighted.now == NOTHING and other.grab().toImage() == before


@pytest.mark.undrawn
def test_the_words_of_a_probe_that_is_outside(
    window: MainWindow, highlighted: Highlighted, qtbot: QtBot
) -> None:
    window.panels.open(window.probe_panel)
    settle()
    camera = window.store.document.projection.camera
    eye, n = np.array(camera.eye), camera.frame[2]
    window.probe_panel.follow(point=tuple(eye - 0.5 * n))  # nearer than near
    settle()
    qtbot.waitUntil(lambda: not window.panels.rest.isActive())  # the panel grows with its table
    settle()
    table = window.probe_panel.table
    model = table.model()
    inside = model.index(model.rowCount() - 1, 1)
    assert model.data(inside, Qt.ItemDataRole.BackgroundRole) is None
    table.scrollTo(inside)
    hover(window, table.viewport(), table.visualRect(inside).center())
    assert highlighted.now == {"near"} and marked(window) == {"near"}
    assert model.data(inside, Qt.ItemDataRole.BackgroundRole) is not None
    hover(window, table.viewport(), table.visualRect(model.index(model.rowCount() - 2, 1)).center())
    assert highlighted.now == NOTHING
    window.highlighter.mark("test", frozenset(("near_left_top",)))
    assert model.data(inside, Qt.ItemDataRole.BackgroundRole) is not None
    window.highlighter.mark("test", frozenset(("far",)))
    assert model.data(inside, Qt.ItemDataRole.BackgroundRole) is None


@pytest.mark.parametrize("kind", ["perspective", "frustum"])
def test_a_corner_marks_the_rows_that_its_drag_changes(
    window: MainWindow, highlighted: Highlighted, kind: str
) -> None:
    window.store.set_projection(START.with_lens(kind))
    settle()
    drawing, canvas = window.panes["world"].drawing, window.panes["world"].canvas
    marks = drawing.handles.shown  # type: ignore[union-attr]
    x_px, y_px = next(s for h, s in marks if h.name == "corner" and 0.0 not in h.at)
    before = window.store.document.projection
    point_at(window, "world", x_px / canvas.pixel_ratio, y_px / canvas.pixel_ratio)
    assert highlighted.now < set(CORNERS)
    rows = marked(window)
    start = QPoint(math.floor(x_px), math.floor(y_px))
    QTest.mousePress(canvas, Qt.MouseButton.LeftButton, pos=start)
    QTest.mouseMove(canvas, start + QPoint(20, -30))
    QTest.mouseRelease(canvas, Qt.MouseButton.LeftButton, pos=start + QPoint(20, -30))
    settle()
    after = window.store.document.projection
    was, is_now = asdict(before.lens), asdict(after.lens)
    edited = {name for name in was if was[name] != is_now[name]}
    assert after == replace(before, lens=after.lens) and edited and edited <= rows


# -- what it costs


def test_a_step_with_highlight_costs_what_it_costs_without(window: MainWindow) -> None:
    hover(window, window.controls.rows["near"])
    settle()
    props = {name: list(pane.canvas.renderer.GetViewProps()) for name, pane in window.panes.items()}
    with counted_repaints(window) as counts:
        for step in range(3):
            lens = Perspective(46.0 + step, 1.0, 30.0)
            window.store.set_projection(replace(window.store.document.projection, lens=lens))
            settle()
        assert counts == {"world": 3, "ndc": 3, "image": 3}
        leave(window)
    for name, pane in window.panes.items():
        assert list(pane.canvas.renderer.GetViewProps()) == props[name]


def test_a_hidden_pane_is_told_when_it_appears(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = pictures(window)
    window.slots.arrange("pictures", "image", "image")
    settle()
    told: list[object] = []
    drawing = window.panes["world"].drawing
    real = drawing.show_highlight  # type: ignore[union-attr]
    monkeypatch.setattr(drawing, "show_highlight", lambda a: (told.append(a), real(a))[1])
    window.highlighter.mark("test", frozenset({"near"}))
    settle()
    assert told == []
    window.slots.arrange("pictures", "world")
    settle()
    assert told and changed(before, pictures(window)) >= {"world"}


@pytest.mark.undrawn
def test_a_copied_picture_is_never_highlighted(
    window: MainWindow, highlighted: Highlighted
) -> None:
    window.pictures.copy()
    settle()  # its message takes room
    before = QApplication.clipboard().image()
    hover(window, window.controls.rows["near"])
    assert highlighted.now == {"near"}
    window.pictures.copy()
    assert QApplication.clipboard().image() == before and not before.isNull()


def test_extreme_cameras_and_lenses_can_be_hovered(window: MainWindow) -> None:
    for projection in (
        Projection(Camera((6e11, 5e11, 9e11), (0.0, 2.2, 0.0))),
        Projection(START.camera, Perspective(179.9, 1e-9, math.inf)),
        START.with_lens("oblique"),
    ):
        window.store.set_projection(projection)
        settle()
        for name, pane in window.panes.items():
            width, height = pane.canvas.width(), pane.canvas.height()
            for x, y in product(range(5, width, 60), range(5, height, 60)):
                highlighted = lit_at(pane.drawing, x, y)  # type: ignore[union-attr]
                known = {*PLANES, *CORNERS, *"uvn", "eye", "target", "fov"}
                assert made_of(highlighted) <= known, name


# -- a scene's own settings, numbers and marks


def test_l5_the_matrix_lights_up_with_d_and_the_plane_with_the_matrix(
    window: MainWindow, highlighted: Highlighted
) -> None:
    window.guide.choose("similar-triangles")
    settle()
    card, before = window.controls.card, pictures(window)
    matrix = card.readout.lines[0][1]
    lit = [value for _, value, _ in card.readout.lines if value.is_marked]
    assert not lit and "-0.25" in matrix.exact
    plain = rgb_of(matrix.grab().toImage())
    hover(window, card.rows["distance"].name_label)
    assert highlighted.now == {"settings.distance"}
    assert matrix.is_marked and not card.readout.lines[3][1].is_marked
    # Of the matrix the one cell: row 4, column 3.
    lit_px = np.argwhere((plain != rgb_of(matrix.grab().toImage())).any(axis=2))
    rows, columns = (np.array((matrix.height(), matrix.width())) / 4.0).tolist()
    assert len(lit_px) and lit_px[:, 0].min() > 2.8 * rows and lit_px[:, 1].min() > 2.0 * columns
    assert "world" in changed(before, pictures(window))
    hover(window, matrix)
    assert highlighted.now == {"settings.distance"} and card.rows["distance"].is_marked
    hover(window, card.readout.lines[3][1])
    assert highlighted.now == {"y_p"} and not card.rows["distance"].is_marked
    leave(window)
    assert not changed(before, pictures(window)) and not matrix.is_marked


@pytest.mark.undrawn
def test_l15_the_plane_of_a_step_lights_the_rows_that_it_is_made_of(
    window: MainWindow, highlighted: Highlighted
) -> None:
    """Left keeps w + x >= 0: rows 1 and 4 of the clip matrices are highlighted."""
    show_scene(window, "clipping")
    window.panels.open(window.matrices)
    card = window.controls.card

    def rows() -> set[int]:
        settle()
        lit = set()
        for name, view in window.matrices.views.items():
            whole = {row for row in range(4) if all(view.is_marked(row, j) for j in range(4))}
            lit |= whole if name in ("clip_from_view", "clip_from_world") else set()
            assert name in ("clip_from_view", "clip_from_world") or not whole, name
        return lit

    for step, (plane, expected) in enumerate(
        (("near", {2, 3}), ("far", {2, 3}), ("left", {0, 3}), ("right", {0, 3}),
         ("bottom", {1, 3}), ("top", {1, 3})), 1,
    ):  # fmt: skip
        card.rows["step"].edited.emit(float(step))
        assert rows() == expected and plane in highlighted.now
    window.highlighter.mark("hand", frozenset(("fov",)))
    assert rows() == set()
    window.highlighter.mark("hand", NOTHING)
    assert rows() == {1, 3}
    window.store.set_projection(window.store.document.projection.with_lens("orthographic"))
    assert {1, 3} <= rows(), "the other lens' matrices are marked as well"
    window.store.undo()
    window.matrices.vectors.setCurrentIndex(1)
    settle()
    view = window.matrices.views["clip_from_view"]
    assert all(view.is_marked(i, 3) for i in range(4)) and not view.is_marked(0, 0)
    card.rows["step"].edited.emit(0.0)
    assert rows() == set() and highlighted.now == NOTHING
    card.rows["step"].edited.emit(2.0)
    show_scene(window, "view-volumes")  # whose rows are others
    assert highlighted.now == NOTHING
    show_scene(window, "clipping")
    show_scene(window, "letter-f")
    assert highlighted.now == NOTHING
