"""The world in its fixed views, with dimensions, and with hidden layers."""

import itertools
import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor2D

from app.document.view import FIXED, LAYERS
from app.drawings import WORDS
from app.drawings.image import ImageDrawing
from app.drawings.label import LabelActor
from app.drawings.stage import StageDrawing
from app.drawings.style import LIGHT
from app.drawings.world import WorldDrawing
from app.drawings.world_state import half_of
from app.lecture.typed_matrix import with_cell
from app.model.limits import vector
from app.model.projection import Array, Camera, Frustum, Orthographic, Projection
from app.picking.handles import TARGET, dragged
from app.picking.picking import Probe
from app.scenes.scene import BUILT_IN, load
from app.scenes.shapes import GRID_RGB
from tests.support.drawings import (
    MakeScreen,
    OffScreen,
    Pixels,
    boxes_of,
    colours_of,
    drawn,
    illustrated,
    overlapping,
    texts_of,
    to_bytes,
)
from tests.support.letter_f import AFAR

SIZE_PX = 580, 640
START = AFAR


def with_lens(**values: Any) -> Projection:
    return replace(START, lens=START.lens.replaced(**values))


def made(screen: OffScreen, projection: Projection = START, name: str = "letter-f") -> WorldDrawing:
    drawing = WorldDrawing(screen, load(name), WORDS, LIGHT, live=True)
    drawing.show_names(None)
    drawing.show_projection(projection)
    drawing.reset_view()
    return drawing


def pixel_of(drawing: WorldDrawing, points: Any) -> Array:
    """Column and row, (n, 2), where a probe would be marked."""
    return drawing.sight.seen(np.asarray(points, dtype=np.float64))


def at(projection: Projection, u: float, v: float, distance: float) -> Array:
    """A world point by its place in the camera's frame."""
    camera = projection.camera
    return np.asarray(np.array(camera.eye) + np.array((u, v, -distance)) @ camera.frame)


# --------------------------------------------------------------------------- where it stands


@pytest.mark.parametrize(
    ("view", "right", "up"),
    [
        ("side", (0, 0, 1), (0, 1, 0)),
        ("top", (0, 0, 1), (-1, 0, 0)),
        ("axis", (1, 0, 0), (0, 1, 0)),
    ],
)
def test_a_flat_view_is_the_cameras_frame_to_scale(
    off_screen: MakeScreen, view: str, right: Any, up: Any
) -> None:
    """Parallel: equal vectors in the world are equal on the screen, at any distance.

    Right and up of the screen are in u, v and distance: from the side the eye is left of near.
    """
    drawing = made(off_screen(*SIZE_PX))
    drawing.show_fixed(view)
    assert drawing.fixed == view
    dice = np.random.default_rng(3)
    places = dice.uniform((-5.0, -4.0, 1.0), (5.0, 4.0, 18.0), (20, 3))
    spots = pixel_of(drawing, [at(START, *place) for place in places])
    along, upwards = places @ np.array(right), places @ np.array(up)
    scale = (spots[1, 0] - spots[0, 0]) / (along[1] - along[0])
    assert scale > 5.0
    assert spots[:, 0] - spots[0, 0] == pytest.approx(scale * (along - along[0]), abs=1e-6)
    assert spots[0, 1] - spots[:, 1] == pytest.approx(scale * (upwards - upwards[0]), abs=1e-6)


def test_the_planes_light_their_pixels_from_the_side(off_screen: MakeScreen) -> None:
    """Near and far stand upright at 4 and 18 from the eye, as high as n tan and f tan say."""
    screen = off_screen(*SIZE_PX)
    drawing = made(screen)
    drawing.show_fixed("side")
    drawing.show_layers(frozenset({"labels", "handles", "grid", "camera", "near-picture"}))
    image = screen.pixels()
    ((eye_x, _),) = pixel_of(drawing, [START.camera.eye])
    found = {}
    for name in ("near", "far"):
        rows, columns = np.nonzero(drawn(image, to_bytes(getattr(LIGHT, name))))
        assert np.ptp(columns) <= 3  # a line of 3 px, and nothing beside it
        found[name] = columns.mean() + 0.5 - eye_x, np.ptp(rows) + 1.0
    assert found["near"][0] / found["far"][0] == pytest.approx(4.0 / 18.0, rel=0.01)
    px = found["far"][0] / 18.0
    for name, distance in (("near", 4.0), ("far", 18.0)):
        height = 2.0 * distance * math.tan(math.radians(22.5)) * px
        assert found[name][1] == pytest.approx(height, abs=4.0)


@pytest.mark.parametrize(
    "projection",
    [
        START,
        with_lens(near=1e-3, far=math.inf),
        replace(START, lens=Frustum(-0.5, 2.0, -1.0, 0.5, 2.0, 18.0)),
    ],
)
def test_from_the_eye_the_window_is_the_image(
    off_screen: MakeScreen, projection: Projection
) -> None:
    """A point at a share of the image's width and height is there between the near corners."""
    screen = off_screen(*SIZE_PX)
    drawing = made(screen, projection)
    drawing.show_fixed("eye")
    screen.pixels()
    left, right, bottom, top = projection.window
    near = projection.lens.near
    low, high = pixel_of(
        drawing, [at(projection, left, bottom, near), at(projection, right, top, near)]
    )
    assert ((low > 0) & (low < SIZE_PX) & (high > 0) & (high < SIZE_PX)).all()
    points = np.array([(0.0, 2.2, 0.0), (1.5, 5.0, 0.5), (-1.5, 0.0, 0.5)])
    shares = (pixel_of(drawing, points) - (low[0], high[1])) / (high[0] - low[0], low[1] - high[1])
    assert shares == pytest.approx(projection.trace(points).image / projection.image_size, abs=1e-6)


def test_from_the_eye_no_handle_lies_under_the_title(off_screen: MakeScreen) -> None:
    """The title's buttons are two letters high; a handle reaches half a letter from its middle."""
    drawing = made(off_screen(443, 269), load("clipping").start, "clipping")
    drawing.show_fixed("eye")
    assert min(y for _, (_, y) in drawing.handles.shown) >= 2.5 * LIGHT.font_size


def test_a_fixed_view_goes_with_the_camera(off_screen: MakeScreen) -> None:
    """An orbit moves the object, and leaves eye and planes in place; no actor is added."""
    screen = off_screen(*SIZE_PX)
    drawing = made(screen)
    for view in FIXED:
        drawing.show_fixed(view)
        screen.pixels()
        count = len(list(screen.renderer.GetViewProps()))
        places = [at(START, 0.0, 0.0, d) for d in (4.0, 18.0)]
        before, thing = pixel_of(drawing, places), pixel_of(drawing, [(1.5, 5.0, 0.5)])
        for azimuth in (10.0, 120.0, 250.0):
            orbit = START.camera.orbit._replace(azimuth_deg=azimuth)
            turned = replace(START, camera=Camera.from_orbit(START.camera.target, orbit))
            drawing.show_projection(turned)
            places = [at(turned, 0.0, 0.0, d) for d in (4.0, 18.0)]
            assert pixel_of(drawing, places) == pytest.approx(before, abs=1e-6)
            assert np.abs(pixel_of(drawing, [(1.5, 5.0, 0.5)]) - thing).max() > 3.0
        assert len(list(screen.renderer.GetViewProps())) == count
        drawing.show_projection(START)


def test_a_turn_makes_the_free_view_of_it_and_a_shift_does_not(off_screen: MakeScreen) -> None:
    screen = off_screen(*SIZE_PX)
    drawing = made(screen)
    free = screen.pixels()
    camera = screen.renderer.GetActiveCamera()
    for view in FIXED:
        drawing.show_fixed(view)
        assert drawing.view is None
        flat = view != "eye"
        if flat:
            camera.SetParallelScale(0.5 * camera.GetParallelScale())
            drawing.reset_clipping_range()
            assert drawing.fixed == view and not drawing.refit()
            spot = pixel_of(drawing, [START.camera.target])
            screen.window.SetSize(500, 500)
            screen.pixels()
            screen.window.SetSize(*SIZE_PX)
            screen.pixels()
            assert pixel_of(drawing, [START.camera.target]) == pytest.approx(spot)
        camera.Azimuth(12.0)
        drawing.reset_clipping_range()
        assert drawing.fixed == "" and drawing.view is not None
        assert not camera.GetParallelProjection()
        assert camera.GetViewUp() == (0.0, 1.0, 0.0)
        away = np.array(camera.GetDirectionOfProjection())
        assert abs(away[1]) < 0.99  # what turns about the world's vertical does not look along it
        assert not texts_of(screen).keys() & LENGTHS
        assert colours_of(screen.pixels()) > 5
        drawing.reset_view()
        assert (screen.pixels() == free).all()


@pytest.mark.parametrize("fixed", ["side", "top"])
def test_a_fixed_view_of_one_point_has_a_size(off_screen: Any, fixed: str) -> None:
    """P is too far away to be in view, and the other marks are all in the eye."""
    scene = load("similar-triangles")
    assert scene.phenomenon is not None
    settings = scene.phenomenon.checked({"distance": 1e-300, "point": (1e99, 0.5, 0.5)})
    shown = scene.phenomenon.illustration(scene.start, settings, scene.subject)
    drawing = WorldDrawing(off_screen(*SIZE_PX), scene, WORDS, LIGHT, live=True)
    drawing.show_projection(scene.start, shown)
    drawing.show_fixed(fixed)
    drawing.reset_view()
    assert np.isfinite(pixel_of(drawing, [scene.start.camera.eye])).all()


# --------------------------------------------------------------------------- what is written


HALF = math.tan(math.radians(22.5))


DIMENSIONS: dict[str, set[str]] = {
    "side": {"d", "fov/2", "f tan(fov/2)"},
    "top": {"d", "fov_x/2", "f tan(fov_x/2)"},
    "axis": {"f tan(fov/2)", "f tan(fov_x/2)"},
    "eye": set(),
    "": set(),
}
LENGTHS = set[str]().union(*DIMENSIONS.values())


@pytest.mark.parametrize("view", DIMENSIONS)
def test_the_dimensions_are_those_of_the_lecture(off_screen: MakeScreen, view: str) -> None:
    screen = off_screen(*SIZE_PX)
    drawing = made(screen)
    for name in (*FIXED, view):  # whatever was shown before
        drawing.show_fixed(name)
    screen.pixels()
    boxes = boxes_of(screen)
    assert boxes.keys() & LENGTHS == DIMENSIONS[view]
    assert {"near n = 4", "far f = 18"} <= boxes.keys()
    assert overlapping(boxes) == []
    for text, (left, bottom, right, top) in boxes.items():
        assert left >= 0 and bottom >= 0 and right <= SIZE_PX[0] and top <= SIZE_PX[1], text


@pytest.mark.parametrize(
    ("view", "size_px", "em", "has_all"),
    [
        ("side", (640, 640), 17.0, True),
        ("top", (640, 640), 33.0, True),  # 8 points, in print
        ("axis", (640, 640), 33.0, True),
        ("side", (640, 640), 50.0, False),
        ("top", (600, 250), 21.0, False),
        ("axis", (600, 250), 21.0, False),
        ("side", (900, 500), 67.0, False),
        ("top", (500, 900), 20.0, True),
        ("side", (380, 230), 17.0, False),  # a small slot while presenting
        ("axis", (380, 230), 17.0, False),
    ],
)
def test_large_letters_leave_the_drawing_in_the_pane_and_cover_nothing(
    off_screen: MakeScreen, view: str, size_px: tuple[int, int], em: float, has_all: bool
) -> None:
    screen = off_screen(*size_px)
    drawing = WorldDrawing(screen, load("letter-f"), WORDS, replace(LIGHT, font_size=em), live=True)
    drawing.show_names(None)
    drawing.show_fixed(view)
    screen.pixels()
    boxes = boxes_of(screen)
    assert DIMENSIONS[view] <= boxes.keys() or not has_all
    spots = pixel_of(drawing, drawing.state.volume.corners)
    assert (spots >= 0.0).all() and (spots <= size_px).all()
    assert overlapping(boxes) == []
    for left, bottom, right, top in boxes.values():
        assert left >= 0.0 and bottom >= 0.0 and right <= size_px[0] and top <= size_px[1]
    assert view == "axis" or "d" in boxes or not has_all
    if "d" in boxes:  # right beside its line, or on it
        (eye_x, _), (end_x, _) = pixel_of(drawing, [START.camera.eye, START.camera.target])
        left, _, right, _ = boxes["d"]
        assert left - end_x < 3.0 * em and eye_x - right < 3.0 * em


def dimension_lines(prop: Any) -> list[list[tuple[float, float]]]:
    """The ends of each line of an actor with many lines."""
    mapper = prop.GetMapper() if isinstance(prop, vtkActor2D) else None  # none before it is seen
    data = None if mapper is None else mapper.GetInput()
    if not isinstance(data, vtkPolyData) or data.GetNumberOfLines() < 20:
        return []
    ends = [data.GetPoint(i)[:2] for i in range(data.GetNumberOfPoints())]
    return [ends[i : i + 2] for i in range(0, len(ends), 2)]


@pytest.mark.parametrize("view", ["side", "top"])
@pytest.mark.parametrize("fov_y_deg", [1.0, 170.0])
def test_a_very_wide_and_a_very_narrow_frustum_are_measured_below_what_is_seen(
    off_screen: MakeScreen, view: str, fov_y_deg: float
) -> None:
    """The rows are in the pane, below the object, and their lengths are to scale."""
    screen = off_screen(*SIZE_PX)
    drawing = made(screen, with_lens(fov_y_deg=fov_y_deg))
    drawing.show_fixed(view)
    screen.pixels()
    boxes = boxes_of(screen)
    letter = list(itertools.product((-1.5, 1.5), (0.0, 5.0), (-0.5, 0.5)))
    objects = SIZE_PX[1] - pixel_of(drawing, letter)[:, 1].max()
    actor, *_ = (prop for prop in screen.renderer.GetViewProps() if dimension_lines(prop))
    level = [line for line in dimension_lines(actor) if line[0][1] == line[1][1] > 0.0]
    (eye, _), (end, _) = pixel_of(drawing, [START.camera.eye, START.camera.target])
    left, bottom, right, top = boxes["d"]
    assert left >= 0.0 and bottom >= 0.0 and right <= SIZE_PX[0] and top <= objects
    ends = [x for line in level if bottom < line[0][1] < top for x, _ in line]
    assert (min(ends), max(ends)) == pytest.approx((eye, end), abs=0.5)


def test_what_a_hand_moves_out_of_the_pane_has_no_letters_there(off_screen: MakeScreen) -> None:
    screen = off_screen(*SIZE_PX)
    drawing = made(screen)
    drawing.show_fixed("side")
    camera = screen.renderer.GetActiveCamera()
    camera.SetParallelScale(0.7 * camera.GetParallelScale())
    for move in (camera.SetPosition, camera.SetFocalPoint):
        before = camera.GetPosition() if move == camera.SetPosition else camera.GetFocalPoint()
        move(*(np.array(before) + 5.0 * START.camera.frame[2] - 3.0 * START.camera.frame[1]))
    drawing.reset_clipping_range()
    screen.pixels()
    assert drawing.fixed == "side"
    spots = pixel_of(drawing, drawing.state.volume.corners)
    assert (spots[4:, 0] > SIZE_PX[0]).all() and (spots[:4, 0] < SIZE_PX[0]).all()
    written = texts_of(screen).keys()
    assert "near n = 4" in written and "f tan(fov/2)" not in written


@pytest.mark.parametrize(
    ("name", "written"),
    [("similar-triangles", ("d", "−z")), ("focus", ("s", "d")), ("planar-shadow", ("d",))],
)
def test_a_scenes_distances_stand_in_rows_of_their_own(
    off_screen: MakeScreen, name: str, written: tuple[str, ...]
) -> None:
    """One below the other, the shortest on top; no other label is among them."""
    screen, scene = off_screen(*SIZE_PX), load(name)
    drawing = WorldDrawing(screen, scene, WORDS, LIGHT, live=True)
    drawing.show_names(None)
    drawing.show_projection(scene.start, illustrated(scene))
    drawing.show_fixed("side")
    screen.pixels()
    labels = [
        (prop.label().text, prop.label().box_px)
        for prop in screen.renderer.GetViewProps()
        if isinstance(prop, LabelActor) and prop.GetVisibility()
    ]
    labels.sort(key=lambda label: -label[1][2])  # from the top
    assert tuple(text for text, _ in labels[-len(written) :]) == written
    for (_, (_, _, low, _)), (_, (_, _, _, top)) in itertools.pairwise(labels[-len(written) - 1 :]):
        assert low >= top


def test_rows_of_lengths_take_room_only_below_what_they_measure(off_screen: MakeScreen) -> None:
    """The F reaches farther down than the rows, behind them."""
    screen, scene = off_screen(1366, 594), load("similar-triangles")
    drawing = WorldDrawing(screen, scene, WORDS, LIGHT.enlarged(1.7), live=True)
    drawing.show_names(frozenset({"y", "y_p", "d", "-z", "eye", "P", "P'"}))
    drawing.show_projection(scene.start, illustrated(scene))
    drawing.show_fixed("side")
    screen.pixels()
    spots = dict(drawing.board.points)
    assert spots["P"][0] - spots["eye"][0] > 0.55 * 1366
    foot = np.array(drawing.state.seen(drawing.state.objects))[:, 1].min()
    row = drawing.board.label(("length", "-z")).box_px
    assert 0.0 < foot < row[2] and not drawing.cut()


@pytest.mark.parametrize("view", ["side", "top"])
def test_no_text_lies_on_a_plane(off_screen: MakeScreen, view: str) -> None:
    """From the side a plane is a line; dimensions and the planes' own names stay off it."""
    screen = off_screen(*SIZE_PX)
    drawing = made(screen)
    for near, far in ((5.0, 18.0), (2.0, 14.0), (6.0, 40.0)):
        drawing.show_projection(with_lens(near=near, far=far))
        drawing.show_fixed("")
        drawing.show_fixed(view)
        screen.pixels()
        window = np.array(drawing.state.volume.corners)
        spots = pixel_of(drawing, window)
        for face in (spots[:4], spots[4:]):
            x, low, high = face[:, 0].mean(), face[:, 1].min(), face[:, 1].max()
            for text, (left, bottom, right, top) in boxes_of(screen).items():
                beside = right <= x or x <= left
                above = SIZE_PX[1] - top >= high or SIZE_PX[1] - bottom <= low
                of_it = text in LENGTHS or "=" in text
                assert not of_it or beside or above, (text, near, far)


@pytest.mark.parametrize("view", ["side", "top"])
def test_nears_name_lies_on_no_line_of_a_length(off_screen: MakeScreen, view: str) -> None:
    screen = off_screen(*SIZE_PX)
    drawing = made(screen)
    drawing.show_fixed(view)
    screen.pixels()
    lines = [line for prop in screen.renderer.GetViewProps() for line in dimension_lines(prop)]
    part = np.linspace(0.0, 1.0, 200)[:, None]
    points = np.vstack([start + part * np.subtract(end, start) for start, end in lines])
    left, low, right, high = boxes_of(screen)["near n = 4"]
    assert not ((points > (left, low)) & (points < (right, high))).all(axis=1).any()


@pytest.mark.parametrize("name", ["letter-f", "planar-shadow", "similar-triangles"])
def test_along_the_axis_no_measure_is_written_over_the_picture(
    off_screen: MakeScreen, name: str
) -> None:
    screen, start = off_screen(*SIZE_PX), load(name).start
    drawing = made(screen, start, name)
    drawing.show_fixed("axis")
    screen.pixels()
    spots = pixel_of(drawing, drawing.state.volume.corners)
    (near_left, near_top), (near_right, near_bottom) = spots[:4].min(axis=0), spots[:4].max(axis=0)
    (far_left, far_top), (far_right, far_bottom) = spots[4:].min(axis=0), spots[4:].max(axis=0)
    for text, (left, bottom, right, top) in boxes_of(screen).items():
        upper, lower = SIZE_PX[1] - top, SIZE_PX[1] - bottom
        aside = (
            right <= near_left or near_right <= left or lower <= near_top or near_bottom <= upper
        )
        assert aside or not text.startswith("near"), text
        if text in LENGTHS or text.startswith("far"):
            assert right <= far_left or far_right <= left or lower <= far_top or far_bottom <= upper


def test_half_a_window_by_hand() -> None:
    assert half_of(START, 1) == pytest.approx((22.5, True))
    assert half_of(with_lens(far=math.inf), 1) == pytest.approx((22.5, True))
    wide = half_of(START, 0)
    assert wide is not None
    assert wide.angle_deg == pytest.approx(math.degrees(math.atan(HALF * 16.0 / 9.0)))
    aside = replace(START, lens=Frustum(-1.0, 3.0, -1.0, 1.0, 2.0, 10.0))
    assert half_of(aside, 0) == (None, True)
    assert half_of(aside, 1) == pytest.approx((math.degrees(math.atan(0.5)), True))
    parallel = replace(START, lens=Orthographic(-3.0, 3.0, -2.0, 2.0, 1.0, 9.0))
    assert half_of(parallel, 1) == (None, False)
    assert half_of(with_cell(START, "clip_from_view", 0, 1, 0.5), 1) is None


def test_dimensions_follow_the_camera_and_reach_the_screen(off_screen: MakeScreen) -> None:
    """The line in ink ends below the eye and the target, and leaves a gap for its letter."""
    screen = off_screen(*SIZE_PX)
    drawing = made(screen)
    drawing.show_fixed("side")
    for distance in (5.0, 8.0, 11.0):
        orbit = START.camera.orbit._replace(distance=distance)
        camera = Camera.from_orbit(START.camera.target, orbit)
        drawing.show_projection(replace(START, camera=camera))
        drawing.refit()
        image = screen.pixels()
        (eye, target) = pixel_of(drawing, [camera.eye, camera.target])
        left, bottom, right, top = boxes_of(screen)["d"]
        row = SIZE_PX[1] - (bottom + top) / 2.0
        inked = drawn(image, to_bytes(LIGHT.ink))[int(row) - 3 : int(row) + 4].any(axis=0)
        columns = np.flatnonzero(inked)
        ends = columns.min(), columns.max()
        assert ends == pytest.approx((eye[0], target[0]), abs=1.5)
        assert not inked[int(left) - 4 : int(left)].any()
        assert not inked[int(right) + 1 : int(right) + 4].any()


def test_no_line_of_the_view_before_remains(off_screen: MakeScreen) -> None:
    """From the side there are more lines than along the axis."""
    screen = off_screen(*SIZE_PX)
    drawing = made(screen)
    drawing.show_fixed("axis")
    afresh = screen.pixels()
    drawing.show_fixed("side")
    assert (screen.pixels() != afresh).any()
    drawing.show_fixed("axis")
    assert (screen.pixels() == afresh).all()


SENTENCES = {
    "parallel": "A parallel lens has no angle: it is equally wide at every distance.",
    "eye": "A parallel lens has no eye: this is the view along its axis.",
    "typed": "A free matrix has no near, no far and no angle.",
    "aside": "This window is off-axis: the axis does not halve its angle.",
}


@pytest.mark.parametrize(
    ("projection", "view", "sentence"),
    [
        (START.with_lens("orthographic"), "side", "parallel"),
        (START.with_lens("oblique"), "top", "parallel"),
        (START.with_lens("orthographic"), "eye", "eye"),
        (with_cell(START, "clip_from_view", 0, 1, 0.5), "axis", "typed"),
        (replace(START, lens=Frustum(-1.0, 3.0, -1.0, 1.0, 2.0, 10.0)), "top", "aside"),
        (replace(START, lens=Frustum(-1.0, 3.0, -1.0, 1.0, 2.0, 10.0)), "side", ""),
        (START, "side", ""),
    ],
)
def test_one_sentence_says_what_a_lens_does_not_have(
    off_screen: MakeScreen, projection: Projection, view: str, sentence: str
) -> None:
    screen = off_screen(*SIZE_PX)
    drawing = made(screen)
    drawing.show_fixed(view)
    drawing.show_projection(projection)
    drawing.refit()
    screen.pixels()
    lines = sorted(texts_of(screen).items(), key=lambda line: -line[1].box_px[2])
    said = [text for text, label in lines if label.box_px[0] == 0.5 * LIGHT.font_size]
    assert " ".join(said) == SENTENCES.get(sentence, "")
    has_angle = any("fov" in text for text in texts_of(screen))
    assert has_angle == (view == "side" and not sentence)


@pytest.mark.parametrize("view", FIXED)
def test_extremes_are_drawn_from_every_view(off_screen: MakeScreen, view: str) -> None:
    """VTK does not warn, no number is NaN, and the eye stays in the pane."""
    screen = off_screen(300, 340)
    orthographic = START.with_lens("orthographic")
    typed = START
    for row, column, value in ((3, 2, -0.5), (3, 3, 1.0), (0, 0, 0.01)):
        typed = with_cell(typed, "clip_from_view", row, column, value)
    extremes = (
        with_lens(far=math.inf),
        with_lens(near=1e-6, far=1.0),
        with_lens(near=1e-205, far=math.inf),
        with_lens(fov_y_deg=179.99),
        with_lens(fov_y_deg=1e-4),
        replace(orthographic, lens=orthographic.lens.replaced(near=-1e12, far=1e12)),
        replace(
            orthographic,
            lens=orthographic.lens.replaced(left=-1e9, right=1e9, bottom=-1e9, top=1e9),
        ),
        START.with_lens("oblique"),
        typed,
        with_cell(START, "clip_from_view", 3, 2, 0.0),
        replace(START, camera=Camera((0.0, 30.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, -1.0))),
        replace(START, camera=Camera((6e11, 5e11, 9e11), (0.0, 2.2, 0.0))),
    )
    for projection in extremes[[*FIXED].index(view) % 2 :: 2]:
        drawing = made(screen, projection)
        drawing.show_fixed(view)
        image = screen.pixels()
        assert colours_of(image) > 3
        if view != "eye":
            (spot,) = pixel_of(drawing, [projection.camera.eye])
            assert ((spot > 0) & (spot < (300, 340))).all(), projection
        assert not any("nan" in text for text in texts_of(screen))
        drawing.show_projection(START)
        drawing.refit()
        drawing.refit()  # a label may follow where another one has made room
        assert not drawing.refit()
        drawing.remove()


def test_a_point_is_dragged_in_a_flat_view(off_screen: MakeScreen) -> None:
    """From the side the target follows the hand along n and v."""
    drawing = made(off_screen(*SIZE_PX))
    drawing.show_fixed("side")
    x, y = dict(drawing.handles.shown)[TARGET]
    drawn, grabbed = drawing.handles.planes_drawn, np.array(START.camera.target)
    change = dragged(START, TARGET, grabbed, drawn, drawing.sight, (x + 30.0, y - 20.0))
    target = np.array(change["target"])
    (spot,) = pixel_of(drawing, [target])
    assert spot == pytest.approx((x + 30.0, y - 20.0), abs=0.2)
    moved = START.camera.frame @ (target - START.camera.target)
    assert moved[0] == pytest.approx(0.0, abs=0.01)


# --------------------------------------------------------------------------- layers


def seen_of(screen: OffScreen, drawing: Any, layer: str) -> bool:
    """Whether anything of a layer is on the screen, by a colour that only the layer has."""
    image: Pixels = screen.pixels()
    if layer == "labels":
        return bool(texts_of(screen))
    if layer == "grid":
        return bool(drawn(image, GRID_RGB).any())
    if layer == "frustum":
        return bool(drawn(image, to_bytes(LIGHT.far)).sum() > 50)
    if layer == "handles":
        return bool(drawing.handles.shown)
    if layer == "camera":
        return bool(drawn(image, to_bytes(LIGHT.v)).sum() > 20)
    column, row = pixel_of(drawing, [at(START, *(0.3 * p for p in (0.0, 0.0)), 4.0)])[0].astype(int)
    around = image[row - 25 : row + 26, column - 20 : column + 21].reshape(-1, 3)
    return bool((around == (86, 180, 233)).all(axis=1).any())  # a face of the letter's


@pytest.mark.parametrize("layer", LAYERS)
def test_a_layer_is_switched_off_and_on_again(off_screen: MakeScreen, layer: str) -> None:
    """It stays hidden through steps, breaks and fixed views; shown again, nothing has changed."""
    screen = off_screen(*SIZE_PX)
    drawing = made(screen)
    others = frozenset({"labels", "handles"}) - {layer}
    drawing.show_layers(others)
    before = screen.pixels()
    assert seen_of(screen, drawing, layer)
    drawing.show_layers(others | {layer})
    assert not seen_of(screen, drawing, layer)
    for projection in (with_lens(near=2.0, far=math.inf), START.with_lens("orthographic"), START):
        drawing.show_projection(projection)
        drawing.refit()
        assert not seen_of(screen, drawing, layer), projection.lens
    drawing.show_fixed("eye")
    drawing.show_fixed("")
    assert not seen_of(screen, drawing, layer)
    drawing.show_layers(others)
    assert seen_of(screen, drawing, layer)
    assert (screen.pixels() == before).all()


@pytest.mark.parametrize(
    ("layer", "names"),
    [("camera", {"eye", "target", "u⃗", "v⃗", "n⃗"}), ("frustum", {"near n = 4", "far f = 18"})],
)
@pytest.mark.parametrize("view", ["", "side"])
def test_names_and_handles_go_with_what_they_are_of(
    off_screen: MakeScreen, layer: str, names: set[str], view: str
) -> None:
    screen = off_screen(*SIZE_PX)
    drawing = made(screen)
    drawing.show_fixed(view)
    screen.pixels()
    before, handles = texts_of(screen).keys(), list(drawing.handles.shown)
    assert names <= before
    held = {handle.name for handle, _ in handles if handle.name in ("eye", "target")}
    gone = held if layer == "camera" else {"near", "far", "corner"}
    drawing.show_layers(frozenset({layer}))
    screen.pixels()
    assert not names & texts_of(screen).keys()
    assert {handle.name for handle, _ in drawing.handles.shown} == (
        {handle.name for handle, _ in handles} - gone
    )
    drawing.hold(TARGET if layer == "camera" else handles[-1][0])  # a hand that was on it
    assert not {handle.name for handle, _ in drawing.handles.shown} & gone
    drawing.hold(None)
    drawing.show_layers(frozenset())
    screen.pixels()
    assert texts_of(screen).keys() == before and list(drawing.handles.shown) == handles


def test_no_handle_can_be_held_that_is_not_seen(off_screen: MakeScreen) -> None:
    drawing = made(off_screen(*SIZE_PX))
    (handle, spot), *_ = drawing.handles.shown
    taken = drawing.handles.at(spot)
    assert taken is not None and taken.handle == handle
    drawing.show_layers(frozenset({"handles"}))
    assert drawing.handles.at(spot) is None
    drawing.show_projection(with_lens(near=3.0))
    assert drawing.handles.at(spot) is None


@pytest.mark.parametrize("tolerance_px", [math.inf, 1e-4])
@pytest.mark.parametrize("kind", [StageDrawing, ImageDrawing])
def test_labels_and_grid_are_switched_in_the_other_panes(
    off_screen: MakeScreen, kind: Any, tolerance_px: float
) -> None:
    """Also with vertices projected in float64, and in a scene whose only lines are the grid."""
    for name in ("letter-f", "interpolation"):
        screen = off_screen(*SIZE_PX)
        start = load(name).start
        drawing = kind(screen, load(name), WORDS, LIGHT, tolerance_px)
        drawing.show_names(None)
        drawing.show_projection(start)
        before = screen.pixels()
        assert texts_of(screen) and drawn(before, GRID_RGB).any()
        drawing.show_layers(frozenset({"labels", "grid"}))
        drawing.show_projection(start)
        without = screen.pixels()
        assert not texts_of(screen) and not drawn(without, GRID_RGB).any()
        assert colours_of(without) > 3
        drawing.show_layers(frozenset())
        drawing.show_projection(start)
        assert (screen.pixels() == before).all()
        drawing.remove()


@pytest.mark.parametrize("name", BUILT_IN)
def test_no_line_of_a_scene_has_a_grids_colour_but_the_grid(name: str) -> None:
    """The lines in the grid's colour all lie at one height."""
    scene = load(name)
    lines = scene.lines
    assert lines is not None
    rgb = np.asarray(lines.cell_data["rgb"])
    grid = (rgb == GRID_RGB).all(axis=1) | (rgb == (105, 105, 105)).all(axis=1)
    heights = lines.points.reshape(-1, 2, 3)[grid, :, 1]
    assert len(heights) and np.ptp(heights) == 0.0


@pytest.mark.parametrize(
    ("name", "view", "written"),
    [
        ("similar-triangles", "side", {"y", "y_p"}),
        ("similar-triangles", "top", {"x", "x_p"}),
        # The film 4 from the hole, d of the scene and not the target's, and the arrow 9, its z.
        ("camera-obscura", "side", {"d", "z"}),
        ("camera-obscura", "top", {"d", "z"}),
    ],
)
def test_l5_l21_both_triangles_are_measured_in_the_flat_views(
    off_screen: MakeScreen, name: str, view: str, written: set[str]
) -> None:
    screen, scene = off_screen(*SIZE_PX), load(name)
    drawing = WorldDrawing(screen, scene, WORDS, LIGHT)
    drawing.show_names(None)
    drawing.show_projection(scene.start, illustrated(scene))
    drawing.show_fixed(view)
    screen.pixels()
    kinds = {text.partition(" ")[0] for text in written} | {"x", "y", "x_p", "y_p"}
    assert {text for text in texts_of(screen) if text.partition(" ")[0] in kinds} == written


def test_the_window_stands_over_the_interval_that_it_becomes(off_screen: MakeScreen) -> None:
    """From l to r, and from -1 to 1, one below the other; a probe stands on both lines."""
    screen = off_screen(960, 455)
    lens = START.with_lens("frustum").lens.replaced(left=-1.0, right=3.0, far=12.0, keep="stretch")
    projection = replace(START, lens=lens)
    drawing = made(screen, projection)
    drawing.show_names(frozenset({"l", "r", "interval"}))
    drawing.show_fixed("axis")
    straight_ahead = at(projection, 0.0, 0.5, 8.0)
    drawing.show_probes([Probe(1, point=tuple(straight_ahead.tolist()))])
    screen.pixels()
    boxes = boxes_of(screen)
    assert {"l = −1", "r = 3", "−1", "1", "−0.5"} <= boxes.keys()
    window = pixel_of(drawing, drawing.state.volume.corners[:4])[:, 0]
    left, right = float(window.min()), float(window.max())
    middle = {text: (box[0] + box[2]) / 2.0 for text, box in boxes.items()}
    assert middle["l = −1"] <= left < middle["−0.5"] < right <= middle["r = 3"]
    # Straight ahead is x = 0, a quarter of the way from -1 to 3: -0.5 in the cube.
    assert middle["−0.5"] == pytest.approx(left + 0.25 * (right - left), abs=2.0)
    assert boxes["−1"][3] < boxes["l = −1"][1]
    drawing.show_names(frozenset({"near", "l", "r", "interval"}))
    drawing.reset_view()
    screen.pixels()
    drawn = np.vstack([drawing.state.objects, drawing.state.volume.corners])
    assert boxes_of(screen)["l = −1"][3] < 455.0 - pixel_of(drawing, drawn)[:, 1].max()
    drawing.show_names(frozenset({"l", "r"}))
    screen.pixels()
    assert {"l = −1", "r = 3"} <= boxes_of(screen).keys() and "−0.5" not in boxes_of(screen)


def test_the_distance_at_which_half_the_picture_is_one(off_screen: MakeScreen) -> None:
    """Lecture 003: e = cot(β/2), here cot 30°; the other way of the triangle is 1."""
    screen = off_screen(960, 600)
    projection = with_lens(fov_y_deg=60.0)
    drawing = made(screen, projection)
    drawing.show_names(frozenset({"e", "eye"}))
    drawing.show_fixed("side")
    screen.pixels()
    boxes = boxes_of(screen)
    points = [at(projection, 0.0, v, 3.0**0.5 * part) for v, part in ((0.0, 0.0), (0.0, 1.0))]
    points.append(at(projection, 0.0, 0.5, 3.0**0.5))
    eye, foot, half = pixel_of(drawing, np.array(points))
    assert sum(boxes["e"][::2]) / 2.0 == pytest.approx((eye[0] + foot[0]) / 2.0, abs=2.0)
    assert sum(boxes["1"][1::2]) / 2.0 == pytest.approx(600.0 - half[1], abs=2.0)
    assert boxes["1"][0] - half[0] < 20.0
    drawing.show_names(None)
    screen.pixels()
    assert "1" not in boxes_of(screen)


@pytest.mark.parametrize(("behind", "foremost"), [(4.0, "near"), (-90.0, "far")])
def test_of_two_planes_at_a_pixel_the_foremost_is_taken(
    off_screen: MakeScreen, behind: float, foremost: str
) -> None:
    drawing = made(off_screen(*SIZE_PX))
    u, v, n = START.camera.frame
    eye = np.array(START.camera.eye) + behind * n + 0.5 * u + 0.5 * v
    drawing.show_view(Camera(vector(eye), START.camera.target))
    corners = drawing.state.volume.corners[:4] + drawing.state.origin
    shares = [(0.3, 0.3), (0.3, 0.7), (0.7, 0.3), (0.7, 0.7)]
    sides = corners[1] - corners[0], corners[3] - corners[0]
    spots = drawing.sight.seen([corners[0] + x * sides[0] + y * sides[1] for x, y in shares])
    taken = [drawing.handles.at(tuple(spot)) for spot in spots.tolist()]
    assert [each and each.handle.name for each in taken] == [foremost] * 4
