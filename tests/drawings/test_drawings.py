"""The pixels that the image and the NDC drawings paint."""

import gc
import math
import weakref
from contextlib import closing
from dataclasses import replace
from itertools import cycle, product
from typing import Any

import numpy as np
import pytest
import pyvista as pv
from numpy.typing import NDArray
from PySide6.QtWidgets import QWidget
from vtkmodules.vtkRenderingCore import vtkCamera

from app.drawings import WORDS
from app.drawings.image import ImageDrawing
from app.drawings.label import LabelActor
from app.drawings.off_screen import OffScreen as DrawnOffScreen
from app.drawings.off_screen import pixels_of
from app.drawings.picture_frame import UNFRAMED
from app.drawings.stage import StageDrawing
from app.drawings.style import DARK, LIGHT, Style, contrast, rgb
from app.drawings.world import WorldDrawing
from app.lecture import typed_matrix
from app.lecture.stages import NDC, VIEW
from app.lecture.typed_matrix import with_cell
from app.model.projection import (
    DEPTH_RANGES,
    LENSES,
    Camera,
    Frustum,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
    Trace,
)
from app.precision.levels import DRAWING_TOLERANCE_PX
from app.scenes.poly_mesh import PolyMesh
from app.scenes.scene import BUILT_IN, Scene, load
from tests.support.cameras import random_projections
from tests.support.drawings import (
    MakeScreen,
    OffScreen,
    drawn,
    scene_of,
    shown,
    texts_of,
    to_bytes,
)

KINDS = [WorldDrawing, StageDrawing, ImageDrawing]


def without_lines(scene: Scene) -> Scene:
    return replace(scene, lines=None)


# --------------------------------------------------------------------------- the picture


SIZE = (640, 360)


def drawn_vertices(screen: OffScreen, tolerance_px: float) -> tuple[ImageDrawing, Any]:
    """The letter F's vertices as 3-px points, each of a colour that nothing else has."""
    letter = load("letter-f")
    assert letter.surface is not None
    points = np.unique(letter.surface.points, axis=0).astype(float)
    vertices = pv.PolyData(points)  # vertex i is (i, 0, 200)
    vertices.cell_data["rgb"] = np.array([(i, 0, 200) for i in range(len(points))], np.uint8)
    # As the scene's lines, they go the way that everything goes: user matrix, identity camera.
    scene = replace(letter, surface=None, lines=vertices)
    drawing = ImageDrawing(screen, scene, WORDS, LIGHT, tolerance_px, options=UNFRAMED)
    for renderer in screen.window.GetRenderers():
        for actor in renderer.GetActors():
            actor.GetProperty().SetPointSize(3.0)
    return drawing, points


def check_lit(image: Any, trace: Trace, unsure: Any = False) -> tuple[int, float]:
    """How many vertices are seen whole where the model says, and the largest error in px.

    The pane is twice as large as the image, so that snapping points to whole pixels costs only a
    quarter of an image pixel.
    """
    rows, columns = np.nonzero(drawn(image[..., 1:], (0, 200)))
    lit_by = image[rows, columns, 0]
    beyond, sure = trace.outside[:, :2].any(axis=1) | ~trace.in_front, np.logical_not(unsure)
    assert not np.isin(lit_by, np.flatnonzero(beyond & sure)).any()
    whole = (trace.image > 2.0) & (trace.image < np.array(SIZE) - 2.0)
    found, worst = 0, 0.0
    for i in np.flatnonzero(whole.all(axis=1) & ~beyond & sure):
        x, y = trace.image[i]
        assert image[int(2 * y), int(2 * x)].tolist() != to_bytes(LIGHT.background)
        lit = lit_by == i
        if lit.sum() == 9:  # not covered in part by a vertex before it
            off_x = (columns[lit].mean() + 0.5) / 2.0 - x
            off_y = (rows[lit].mean() + 0.5) / 2.0 - y
            found, worst = found + 1, max(worst, abs(off_x), abs(off_y))
    return found, worst


def test_a_vertex_lights_the_pixel_that_the_model_says(off_screen: MakeScreen) -> None:
    """Every vertex of the letter F from 40 random cameras, and more for lenses that see few."""
    screen = off_screen(1280, 720)
    drawing, points = drawn_vertices(screen, DRAWING_TOLERANCE_PX)
    checked = dict.fromkeys(LENSES, 0)
    for number, projection in enumerate(random_projections(1600, seed=20, size=SIZE)):
        trace = projection.trace(points)
        sees_few = (~trace.outside.any(axis=1)).sum() < 8
        if number >= 40 and (checked[projection.lens.kind] > 50 or sees_few):
            continue
        drawing.show_projection(projection)
        found, worst = check_lit(screen.pixels(), trace)
        checked[projection.lens.kind] += found
        assert worst <= 0.26, projection
    assert min(checked.values()) > 50, checked


@pytest.mark.parametrize("name", [each for each in BUILT_IN if "image" not in load(each).pale])
def test_a_face_has_the_same_colour_in_all_panes(name: str, off_screen: MakeScreen) -> None:
    scene = without_lines(load(name))
    assert scene.surface is not None
    colours = {tuple(c) for c in scene.surface.cell_data["rgb"].tolist()}
    pictures = []
    for kind in (ImageDrawing, StageDrawing):
        screen = off_screen(500, 400)
        drawing = kind(screen, scene, WORDS, LIGHT)
        drawing.show_names(None)
        drawing.show_projection(scene.start)
        if kind is StageDrawing:  # where the same faces are seen as in the picture
            drawing.show_view(Camera((0.0, 0.0, 1.8), (0.0, 0.0, 0.0)))
        pictures.append(screen.pixels())
    large = [colour for colour in colours if drawn(pictures[0], colour).sum() > 100]
    assert len(large) >= min(2, len(colours))
    if "ndc" not in scene.pale:
        assert all(drawn(pictures[1], colour).any() for colour in large)
    # Nothing in between: neither light nor interpolation mixes colours inside the picture.
    screen = off_screen(*scene.start.image_size)
    drawing = ImageDrawing(screen, scene, WORDS, LIGHT, options=UNFRAMED)
    drawing.show_projection(scene.start)
    codes = np.unique(screen.pixels().astype(int) @ (65536, 256, 1))
    found = {(code >> 16, code >> 8 & 255, code & 255) for code in codes.tolist()}
    assert found <= colours | {tuple(to_bytes(LIGHT.background))}


def test_a_polygon_is_one_colour_whatever_triangles_it_is_made_of(off_screen: MakeScreen) -> None:
    """A fan of hexagons round shared vertices; concave ones too."""
    angles = np.linspace(0.0, 2.0 * np.pi, 7)[:-1]
    ring = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(6)])
    points = np.vstack([ring, [(0.0, 0.0, 0.0)], 2.0 * ring])
    faces = [(0, 1, 2, 3, 4, 6), (4, 5, 0, 6), (0, 7, 8, 1), (1, 8, 9, 2)]
    colours = [(200, 30, 30), (30, 200, 30), (30, 30, 200), (200, 200, 30)]
    scene = scene_of(points, faces, colours)
    projection = Projection(
        Camera((0, 0, 5), (0, 0, 0)), Orthographic(-2, 2, -2, 2, 1, 9), (200, 200)
    )
    screen = off_screen(200, 200)
    image = shown(screen, scene, projection)
    inside = {0: (-0.4, 0.2, 0), 1: (0.3, -0.4, 0), 2: (1.2, 0.7, 0), 3: (0.1, 1.3, 0)}
    for face, point in inside.items():
        x, y = projection.trace(point).image
        assert image[int(y), int(x)].tolist() == list(colours[face])
    allowed = [*colours, to_bytes(LIGHT.background)]
    assert sum(drawn(image, colour).sum() for colour in allowed) == 200 * 200


def test_what_is_in_front_stays_in_front_in_every_depth_range(off_screen: MakeScreen) -> None:
    square = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], dtype=float)
    along = np.array([0.0, 0.0, 1.0])
    near, far = (10, 200, 30), (200, 10, 30)
    scene = scene_of(
        np.vstack([square - along, square + along]), [(0, 1, 2, 3), (4, 5, 6, 7)], [far, near]
    )
    for kind in (ImageDrawing, StageDrawing):
        for depth in DEPTH_RANGES:
            screen = off_screen(300, 300)
            drawing = kind(screen, scene, WORDS, LIGHT)
            for lens in (
                Perspective(60, 1, 30),
                Frustum(-0.8, 0.4, -0.5, 0.6, 1, 30),
                Orthographic(-3, 3, -3, 3, 1, 30),
                Oblique(-4, 2, -3, 3, 1, 30, alpha_deg=80, beta_deg=95),
            ):
                drawing.show_projection(
                    Projection(Camera((0, 0, 5), (0, 0, 0)), lens, (300, 300), depth)
                )
                image = screen.pixels()
                assert drawn(image, near).sum() > 1000
                hidden_share = drawn(image, far).sum() / drawn(image, near).sum()
                # The NDC pane looks from the side and sees some of it, the picture none, but for
                # what an oblique lens shifts: 2 cot(80) of 2 across, 2 cot(95) of 2 up.
                if kind is StageDrawing:
                    assert hidden_share < 0.95
                elif lens.kind == "oblique":
                    assert hidden_share == pytest.approx(1.0 - 0.8237 * 0.9125, abs=0.02)
                else:
                    assert hidden_share == 0.0


def test_what_reaches_behind_the_eye_is_not_culled_by_its_bounds(off_screen: MakeScreen) -> None:
    """A strip whose ends, divided by w, are both right of the picture, and its middle in it.

    In view coordinates (x, w) it runs from (2, 1) to (-3, -1); x/w is 2 and 3 at its ends, and
    at 0.35 of its length it is at (0.25, 0.3).
    """
    length = math.sqrt(29.0)
    right, forward = np.array([[-5.0, 0.0, -2.0], [-2.0, 0.0, 5.0]]) / length
    eye = -2.0 * right - forward
    strip = [(0.0, -0.1, 0.0), (length, -0.1, 0.0), (length, 0.1, 0.0), (0.0, 0.1, 0.0)]
    scene = scene_of(strip, [(0, 1, 2, 3)], [(200, 30, 30)])
    projection = Projection(
        Camera(tuple(eye), tuple(eye + forward)), Perspective(90, 0.01, 100), (200, 200)
    )
    screen = off_screen(200, 200)
    image = shown(screen, scene, projection)
    x, y = projection.trace((0.35 * length, 0.0, 0.0)).image
    assert image[int(y), int(x)].tolist() == [200, 30, 30]


# --------------------------------------------------------------------------- the NDC pane


def test_ndc_clips_the_scene_at_the_cube(off_screen: MakeScreen) -> None:
    """A scene that surrounds everything stays inside the cube's silhouette."""
    red = (201, 33, 32)
    big = 40.0 * np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], dtype=float)
    tilted = big[:, [0, 2, 1]] + [0.0, -0.5, 0.0]
    scene = scene_of(np.vstack([big, tilted]), [(0, 1, 2, 3), (4, 5, 6, 7)], [red, red])
    lenses = (
        Perspective(50, 1, 10),
        Frustum(-0.1, 0.8, -0.5, 0.3, 1, 10),
        Orthographic(-2, 2, -2, 2, 1, 10),
        Oblique(-2, 2, -2, 2, 1, 10),
    )
    for number, depth in enumerate(DEPTH_RANGES):
        for lens in lenses[number % 2 :: 2]:
            screen = off_screen(400, 400)
            drawing = StageDrawing(screen, scene, WORDS, LIGHT)
            drawing.show_names(None)
            drawing.show_projection(Projection(Camera((0, 2, 5), (0, 0, 0)), lens, depth=depth))
            image = screen.pixels()
            z_half = (max(DEPTH_RANGES[depth]) - min(DEPTH_RANGES[depth])) / 2.0
            corners = [
                display_px(screen, (x, y, z))
                for x in (-1, 1)
                for y in (-1, 1)
                for z in (-z_half, z_half)
            ]
            scene_px = np.argwhere(drawn(image, red))[:, ::-1] + 0.5
            assert len(scene_px) > 3000
            assert distance_outside(np.array(corners), scene_px) <= 1.0


def display_px(screen: OffScreen, point: tuple[float, float, float]) -> tuple[float, float]:
    """Where VTK's own camera shows a point of the pane's world, in pixels from the top left."""
    renderer = screen.renderer
    renderer.SetWorldPoint(*point, 1.0)
    renderer.WorldToDisplay()
    x, y, _ = renderer.GetDisplayPoint()
    return x, screen.window.GetSize()[1] - y


def distance_outside(corners: NDArray[np.float64], points: NDArray[np.float64]) -> float:
    """How far the points reach out of the corners' convex hull, by its widths in 360 directions."""
    angles = np.linspace(0.0, 2.0 * np.pi, 360, endpoint=False)
    directions = np.column_stack([np.cos(angles), np.sin(angles)])
    return float(((points @ directions.T).max(axis=0) - (corners @ directions.T).max(axis=0)).max())


@pytest.mark.parametrize("depth", DEPTH_RANGES)
def test_ndc_shows_the_near_face_to_the_reader_and_x_to_the_right(
    depth: Any, off_screen: MakeScreen
) -> None:
    """From the front the cube looks like the picture, neither mirrored nor turned.

    The words are hidden: they lie on the cube, which fills the pane here.
    """
    scene = without_lines(load("letter-f"))
    projection = replace(scene.start, depth=depth, image_size=(400, 400))
    front = off_screen(400, 400)
    drawing = StageDrawing(front, scene, WORDS, LIGHT)
    drawing.show_names(None)
    drawing.show_projection(projection)
    drawing.show_layers(frozenset({"labels"}))
    camera = front.renderer.GetActiveCamera()
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetPosition(0.0, 0.0, 10.0)
    camera.SetParallelScale(1.0)
    drawing.reset_clipping_range()
    ndc = front.pixels()
    screen = off_screen(400, 400)
    image = shown(screen, scene, projection)
    assert scene.surface is not None
    compared = 0
    for colour in np.unique(scene.surface.cell_data["rgb"], axis=0):
        mine, other = drawn(ndc, colour), drawn(image, colour)
        if other.sum() > 500:
            # The cube's own axes cover a little of it, and have a little of its colour.
            assert (mine != other).sum() <= 0.03 * other.sum() + 100
            compared += 1
    assert compared >= 2


@pytest.mark.parametrize("depth", DEPTH_RANGES)
def test_ndc_writes_the_ends_of_its_depth_range(depth: Any, off_screen: MakeScreen) -> None:
    scene = load("cube")
    screen = off_screen(300, 300)
    drawing = StageDrawing(screen, scene, WORDS, LIGHT)
    drawing.show_names(None)
    drawing.show_projection(replace(scene.start, depth=depth))
    screen.pixels()
    texts = [
        prop.label().text
        for prop in screen.renderer.GetViewProps()
        if isinstance(prop, LabelActor) and prop.GetVisibility()
    ]
    signs = {-1.0: "−1", 0.0: "0", 1.0: "+1"}
    near, far = (signs[z] for z in DEPTH_RANGES[depth])
    everything = [f"near {near}", f"far {far}", "x", "y", "z", "−1", "1", "−1", "1"]
    assert sorted(filter(None, texts)) == sorted(everything)


@pytest.mark.parametrize("size", [(300, 400), (500, 560), (1280, 720), (900, 300), (200, 900)])
@pytest.mark.parametrize("style", [LIGHT, DARK.enlarged(1.5)], ids=["light", "projector"])
def test_ndc_is_wholly_in_view_at_any_pane_size(
    size: tuple[int, int], style: Style, off_screen: MakeScreen
) -> None:
    """Nothing touches the pane's border, even if the pane is resized later."""
    scene = without_lines(load("cube"))
    screen = off_screen(640, 480)
    drawing = StageDrawing(screen, scene, WORDS, style)
    drawing.show_names(None)
    drawing.show_projection(scene.start)
    screen.pixels()
    screen.window.SetSize(*size)
    empty = drawn(screen.pixels(), to_bytes(style.background))
    assert empty[0].all() and empty[-1].all() and empty[:, 0].all() and empty[:, -1].all()
    rows, columns = (np.flatnonzero(~empty.all(axis=axis)) for axis in (1, 0))
    filled = max((columns[-1] - columns[0]) / size[0], (rows[-1] - rows[0]) / size[1])
    assert filled > 0.55


def test_a_hidden_frustum_is_hidden_up_to_the_view(off_screen: MakeScreen) -> None:
    screen, scene = off_screen(600, 400), load("letter-f")
    drawing = StageDrawing(screen, scene, WORDS, LIGHT)
    drawing.show_names(frozenset({"near"}))
    drawing.show_projection(scene.start)
    for position, is_hidden in ((VIEW, True), (0.0, True), (NDC, False)):
        drawing.show_layers(frozenset())
        drawing.show_stage(position)
        screen.pixels()
        assert drawing.box.near.is_visible and drawing.state.display_from_box.any()
        drawing.show_layers(frozenset({"frustum"}))
        screen.pixels()
        assert drawing.box.near.is_visible != is_hidden
        assert drawing.state.display_from_box.any() != is_hidden


# --------------------------------------------------------------------------- the image pane


@pytest.mark.parametrize(
    "image_size", [(1280, 720), (720, 1280), (500, 500), (16384, 64), (64, 16384), (3, 2)]
)
@pytest.mark.parametrize("pane", [(500, 560), (301, 400), (1280, 720)])
def test_the_picture_lies_exactly_in_its_rectangle(
    image_size: tuple[int, int], pane: tuple[int, int], off_screen: MakeScreen
) -> None:
    red = (201, 33, 32)
    wall = [(-9e3, -9e3, -5), (9e3, -9e3, -5), (9e3, 9e3, -5), (-9e3, 9e3, -5)]
    scene = scene_of(wall, [(0, 1, 2, 3)], [red])
    screen = off_screen(640, 480)
    drawing = ImageDrawing(screen, scene, WORDS, LIGHT)
    drawing.show_names(None)
    screen.pixels()
    screen.window.SetSize(*pane)
    projection = Projection(Camera((0, 0, 0), (0, 0, -1)), Perspective(60, 1, 30), (123, 45))
    drawing.show_projection(projection)
    screen.pixels()  # another size of pane and of image, so that the next rendering finds news
    drawing.show_projection(replace(projection, image_size=image_size))
    image = screen.pixels()
    left, top, width, height = drawing.picture_rectangle_px
    picture = drawn(image, red)
    expected = np.zeros(picture.shape, dtype=bool)
    expected[top : top + height, left : left + width] = True
    assert (picture == expected).all()
    aspect = image_size[0] / image_size[1]
    assert width == pytest.approx(height * aspect, abs=0.5 * max(1.0, aspect) + 1e-9) or (
        1 in (width, height)
    )
    # And what is pointed at beside it is no pixel of the image.
    inside, middle = (left + 0.5, top + 0.5), (left + width / 2, top + height / 2)
    assert drawing.image_pixel(*inside) is not None
    for x, y in ((left - 1, middle[1]), (left + width + 1, middle[1])):
        assert drawing.image_pixel(x, y) is None
    for x, y in ((middle[0], top - 1), (middle[0], top + height + 1)):
        assert drawing.image_pixel(x, y) is None
    # As large as the margins allow: one more em on both sides would not fit.
    em = LIGHT.font_size
    assert width > pane[0] - 9 * em or height > pane[1] - 9 * em
    assert (image[0, 0] == to_bytes(LIGHT.margin)).all()


def test_the_frame_touches_the_picture_and_its_axes_are_coloured(off_screen: MakeScreen) -> None:
    scene = without_lines(load("cube"))
    screen = off_screen(500, 400)
    drawing = ImageDrawing(screen, scene, WORDS, LIGHT)
    drawing.show_names(None)
    drawing.show_projection(scene.start)
    image = screen.pixels()
    left, top, width, height = drawing.picture_rectangle_px
    middle_x, middle_y = left + width // 2, top + height // 2
    assert image[top - 1, middle_x].tolist() == to_bytes(LIGHT.u)
    assert image[middle_y, left - 1].tolist() == to_bytes(LIGHT.v)
    assert image[top + height, middle_x].tolist() == to_bytes(LIGHT.ink)
    assert image[middle_y, left + width].tolist() == to_bytes(LIGHT.ink)
    assert image[top - 1, left - 1].tolist() == to_bytes(LIGHT.ink)
    for row, column in ((top, left), (top + height - 1, left + width - 1)):
        assert image[row, column].tolist() == to_bytes(LIGHT.background)
    assert sorted(texts_of(screen)) == ["0, 0", "1280", "720", "x", "y"]


def test_edges_are_not_eaten_by_faces_nor_seen_through_them(off_screen: MakeScreen) -> None:
    """Front edges of the cube are ink all along and the back ones hidden, even at extreme near."""
    corners = np.array([(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], dtype=float)
    faces = [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)]
    front, back = (0, 0, 0), (250, 0, 250)
    lines = pv.PolyData(corners, lines=[2, 5, 7, 2, 6, 7, 2, 3, 7, 2, 0, 1, 2, 0, 2, 2, 0, 4])
    lines.cell_data["rgb"] = np.array([front] * 3 + [back] * 3, dtype=np.uint8)
    scene = replace(scene_of(corners, faces, [(120, 160, 200)] * 6), lines=lines)
    camera = Camera((4, 3, 5), (0, 0, 0))
    size = (400, 300)
    lenses = (
        Perspective(45, 1, 30),
        Perspective(45, 1e-3, math.inf),
        Frustum(-0.7, 0.3, -0.4, 0.5, 1, 30),
        Frustum(-7e-4, 3e-4, -4e-4, 5e-4, 1e-3, math.inf),
        Orthographic(-3, 3, -3, 3, 1, 30),
        Oblique(-4, 3, -3, 4, 4, 12, alpha_deg=95, beta_deg=80),
    )
    screen = off_screen(*size)
    drawing = ImageDrawing(screen, scene, WORDS, LIGHT, options=UNFRAMED)
    for lens in lenses:
        projection = Projection(camera, lens, size)
        drawing.show_projection(projection)
        image = screen.pixels()
        for end in (5, 6, 3):
            along = corners[7] + np.linspace(0.02, 0.98, 200)[:, None] * (corners[end] - corners[7])
            x, y = projection.trace(along).image.T.astype(int)
            for column, row in zip(x, y, strict=True):
                beside = image[row - 1 : row + 2, column - 1 : column + 2]
                assert drawn(beside, front).any(), (lens, column, row)
        # At the silhouette a back edge's end may show.
        seen = np.argwhere(drawn(image, back))[:, ::-1] + 0.5
        ends = projection.trace(corners[[1, 2, 4]]).image
        away = np.linalg.norm(seen[:, None] - ends, axis=2).min(axis=1)
        assert away.max(initial=0.0) < 4.0, lens


# --------------------------------------------------------------------------- what a step may do


@pytest.mark.parametrize("kind", KINDS)
def test_a_step_sets_matrices_and_nothing_else(kind: Any, off_screen: MakeScreen) -> None:
    scene, screen = load("letter-f"), off_screen(300, 300)
    drawing = kind(screen, scene, WORDS, LIGHT)
    drawing.show_projection(scene.start)
    screen.pixels()
    renders: list[str] = []
    for event in ("RenderEvent", "StartEvent"):
        screen.window.AddObserver(event, lambda _window, event: renders.append(event))
    renderers, camera = screen.window.GetRenderers(), screen.renderer.GetActiveCamera()

    def state() -> list[Any]:
        actors = [actor for renderer in renderers for actor in renderer.GetActors()]
        return [
            [id(prop) for renderer in renderers for prop in renderer.GetViewProps()],
            [id(actor.GetUserMatrix()) for actor in actors],
            [actor.GetMapper().GetMTime() for actor in actors],
            [actor.GetMapper().GetInput().GetMTime() for actor in actors],
            # The world fades the tints of the planes.
            [kind is not WorldDrawing and actor.GetProperty().GetMTime() for actor in actors],
            [camera.GetPosition(), camera.GetFocalPoint(), camera.GetViewUp()],
        ]

    before = state()
    matrices = [actor.GetUserMatrix() for each in renderers for actor in each.GetActors()]
    times = [matrix.GetMTime() for matrix in matrices]
    for step in range(20):
        eye = (6.0 + 0.1 * step, 5.0, 9.0)
        drawing.show_projection(replace(scene.start, camera=replace(scene.start.camera, eye=eye)))
    for projection in random_projections(50 if kind is WorldDrawing else 0, seed=6):
        drawing.show_projection(projection)
    assert renders == []
    assert state() == before
    assert [matrix.GetMTime() for matrix in matrices] != times


@pytest.mark.parametrize("kind", KINDS)
def test_a_removed_drawing_leaves_nothing_behind(kind: Any, off_screen: MakeScreen) -> None:
    scene, screen = load("letter-f"), off_screen(300, 300)
    found = screen.window.GetRenderers().GetNumberOfItems()
    pictures, alive = [], []
    for _ in range(2):
        screen.renderer.SetActiveCamera(vtkCamera())
        drawing = kind(screen, scene, WORDS, LIGHT)
        drawing.show_projection(scene.start)
        pictures.append(screen.pixels())
        drawing.remove()
        alive.append(weakref.ref(drawing))
        assert screen.window.GetRenderers().GetNumberOfItems() == found
        assert screen.renderer.GetViewProps().GetNumberOfItems() == 0
        assert not screen.window.HasObserver("StartEvent")
    assert (pictures[0] == pictures[1]).all()
    del drawing
    gc.collect()
    assert [each() for each in alive] == [None, None]


@pytest.mark.parametrize("kind", [StageDrawing, ImageDrawing])
@pytest.mark.parametrize("dpi", [72, 144])
def test_words_have_their_size_whatever_dots_per_inch_the_window_claims(
    kind: Any, dpi: int, off_screen: MakeScreen
) -> None:
    scene = load("cube")
    pictures = []
    for claimed in (72, dpi):
        screen = off_screen(300, 300)
        drawing = kind(screen, scene, WORDS, LIGHT.enlarged(2.0))
        drawing.show_projection(scene.start)
        screen.window.SetDPI(claimed)
        pictures.append(screen.pixels())
    assert (pictures[0] == pictures[1]).all()


def moved(scene: Scene, scale: float, origin: tuple[float, float, float]) -> Scene:
    """The same scene and camera, scaled and then carried to `origin`."""

    def carry(point: tuple[float, float, float]) -> tuple[float, float, float]:
        x, y, z = (o + scale * p for o, p in zip(origin, point, strict=True))
        return x, y, z

    meshes = []
    for mesh in (scene.surface, scene.lines):
        assert mesh is not None
        copy = PolyMesh.sharing(mesh)
        copy.points = copy.points * scale
        meshes.append(copy)
    camera, lens = scene.start.camera, scene.start.lens
    start = replace(
        scene.start,
        camera=Camera(carry(camera.eye), carry(camera.target), camera.up),
        lens=replace(lens, near=lens.near * scale, far=lens.far * scale),
    )
    return replace(
        scene,
        origin=origin,
        surface=meshes[0],
        lines=meshes[1],
        lower=carry(scene.lower),
        upper=carry(scene.upper),
        start=start,
    )


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("scale", "origin"), [(1.0, (1e8, -1e8, 1e8)), (1e-6, (0.0, 0.0, 0.0)), (1e9, (0.0, 0.0, 0.0))]
)
def test_scenes_far_away_tiny_or_huge_look_the_same(
    off_screen: MakeScreen, kind: Any, scale: float, origin: tuple[float, float, float]
) -> None:
    """The scene's origin meets the eye in float64; float32 would leave steps of 8 at 1e8."""
    images = []
    for scene in (load("letter-f"), moved(load("letter-f"), scale, origin)):
        screen = off_screen(400, 300)
        drawing = kind(screen, scene, WORDS, LIGHT)
        drawing.show_layers(frozenset({"labels"}))  # their distances differ
        drawing.show_projection(scene.start)
        drawing.reset_view()
        images.append(screen.pixels())
    assert (images[0] != images[1]).any(axis=-1).mean() < 0.002


def test_extreme_projections_draw_without_a_word(off_screen: MakeScreen) -> None:
    """NumPy and VTK must not warn; pytest and `off_screen` see to that."""
    scene = load("letter-f")
    cameras = (
        scene.start.camera,
        Camera((0, 2.2, 0), (0, 0, 5)),
        Camera((-1.0, 0.5, 0.0), (-1.0, 0.5, -1.0)),
        Camera((1e9, 1e9, 1e9), (0, 0, 0)),
    )
    lenses = (
        Perspective(45, 1e-6, math.inf),
        Perspective(179.99, 1e-6, 1e9),
        Perspective(1e-6, 1, 30),
        Perspective(45, 1e-205, 1e100),
        Perspective(45, 1, 1 + 1e-12),
        Frustum(1e-7, 1e9, -1e9, -1e-7, 1e-7, math.inf),
        Frustum(-0.7, 0.7, -0.4, 0.4, 1e-89, 30.0),
        Frustum(-1e-90, 1e-90, 1.0, 2.0, 1.0, 2.0),
        Orthographic(-1e-9, 1e-9, -1e9, 1e9, -1e9, 1e9),
        Oblique(-1e-9, 1e-9, -1e9, 1e9, -1e9, 1e9, alpha_deg=1e-4, beta_deg=179.9999),
    )
    for kind in (StageDrawing, ImageDrawing):
        screen = off_screen(120, 90)
        drawing = kind(screen, scene, WORDS, LIGHT)
        for (camera, lens), depth in zip(product(cameras, lenses), cycle(DEPTH_RANGES)):
            drawing.show_projection(Projection(camera, lens, (16384, 1), depth))
            drawing.reset_clipping_range()
            screen.pixels()


def test_a_scene_with_nothing_in_it_is_an_empty_pane(off_screen: MakeScreen) -> None:
    scene = replace(load("cube"), surface=None, lines=None)
    screen = off_screen(200, 100)
    drawing = ImageDrawing(screen, scene, WORDS, LIGHT, options=UNFRAMED)
    drawing.show_projection(scene.start)
    assert (screen.pixels() == to_bytes(LIGHT.background)).all()
    StageDrawing(off_screen(200, 100), scene, WORDS, LIGHT).show_projection(scene.start)


# --------------------------------------------------------------------------- in a window


def test_a_wide_line_that_ends_beside_the_eye_is_drawn_in_a_pane(display: Any, qtbot: Any) -> None:
    """Qt's core profile has no wide lines; VTK's own divide by the w of a line's ends."""
    from pyvistaqt import QtInteractor

    points = np.array([(0.4, -0.4, 0.0), (0.4, -0.4, -10.0)])
    lines = pv.PolyData(points, lines=[2, 0, 1])
    lines.cell_data["rgb"] = np.array([(200, 0, 0)], dtype=np.uint8)
    scene = replace(load("cube"), surface=None, lines=lines)
    canvas = QtInteractor(auto_update=False, multi_samples=0)
    qtbot.addWidget(canvas, before_close_func=lambda widget: widget.close())
    canvas.resize(200, 200)
    drawing = ImageDrawing(canvas, scene, WORDS, LIGHT.enlarged(3.0), options=UNFRAMED)
    red = []
    for z in (0.0, 1e-3):  # the line's end exactly in the eye's plane, and beside it
        camera = Camera((0, 0, z), (0, 0, -1))
        drawing.show_projection(Projection(camera, Perspective(90, 0.1, 20), (200, 200)))
        with qtbot.waitExposed(canvas):
            canvas.show()
        QWidget.update(canvas)
        picture = canvas.grab().toImage()
        red.append(
            sum(
                picture.pixelColor(x, y).getRgb()[:3] == (200, 0, 0)
                for x in range(200)
                for y in range(200)
            )
        )
    drawing.remove()
    assert red[1] > 300  # sqrt(2) * 96 px long, 4.5 px wide
    assert abs(red[0] - red[1]) <= 20


# --------------------------------------------------------------------------- colours


@pytest.mark.parametrize("style", [LIGHT, DARK], ids=["light", "dark"])
def test_words_can_be_read_and_lines_be_seen(style: Style) -> None:
    for background in (style.background, style.margin):
        for text in (style.ink, style.muted):
            assert contrast(text, background) >= 4.5
    concepts = {
        name: getattr(style, name)
        for name in ("near", "far", "u", "v", "n", "eye", "target", "frustum", "accent")
    }
    assert len(set(concepts.values())) == len(concepts)  # one colour per concept
    for colour in concepts.values():
        assert contrast(style.text_on(colour), colour) >= 4.5
        assert contrast(colour, style.background) >= 3.0
    parts = zip(rgb(style.background), rgb(style.muted), strict=True)
    tinted = "".join(f"{round(255 * (0.8 * below + 0.2 * tint)):02x}" for below, tint in parts)
    for ground in (style.background, f"#{tinted}"):
        assert contrast(style.shadow, ground) >= 3.0


def test_contrast_is_that_of_the_standard() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.005)  # WCAG's known example
    assert contrast("#0072b2", "#0072b2") == 1.0


def test_a_projector_makes_words_and_lines_larger_and_keeps_the_colours() -> None:
    large = LIGHT.enlarged(1.5)
    assert (large.font_size, large.line_width) == (1.5 * LIGHT.font_size, 1.5 * LIGHT.line_width)
    assert replace(large, font_size=LIGHT.font_size, line_width=LIGHT.line_width) == LIGHT


@pytest.mark.parametrize("tolerance_px", [100.0, 1e-4])  # float32 draws, and float64
def test_a_vertex_under_a_free_matrix_lights_its_pixel(
    off_screen: MakeScreen, tolerance_px: float
) -> None:
    screen = off_screen(1280, 720)
    drawing, points = drawn_vertices(screen, tolerance_px)
    random = np.random.default_rng(21)
    checked, precisions, letter = 0, set(), load("letter-f")
    for number in range(24):
        start = replace(letter.start, image_size=SIZE).with_depth(list(DEPTH_RANGES)[number % 3])
        name = ("clip_from_view", "view_from_world")[number % 4 == 3]
        row, column = random.integers(4, size=2)
        value = typed_matrix.shown(start, name)[row][column] + random.uniform(-0.2, 0.2)
        projection = with_cell(start, name, int(row), int(column), value)
        drawing.show_projection(projection)
        precisions.add(drawing.precision)
        trace = projection.trace(points)
        deep = np.abs(trace.depth - 0.5) > 0.499  # the lift of lines takes them over the edge
        found, worst = check_lit(screen.pixels(), trace, deep)
        checked += found
        assert worst <= 0.26, projection
    assert checked > 80
    assert precisions == {"float32"} if tolerance_px > 1.0 else "float64" in precisions


# --------------------------------------------------------------------------- smooth pictures


@pytest.mark.parametrize("name", ["letter-f", "posts"])
def test_our_fxaa_draws_what_vtks_own_does(name: str) -> None:
    pictures = []
    for fxaa, quick in ((False, False), (True, False), (True, True)):
        with closing(DrawnOffScreen(410, 330)) as screen:
            if quick:
                screen.quicken_fxaa()
            drawing = WorldDrawing(screen, load(name), WORDS, LIGHT)
            screen.renderer.SetUseFXAA(fxaa)
            screen.render_window.Render()
            pictures.append(pixels_of(screen.render_window).astype(int))
            drawing.remove()
    rough, vtks, ours = pictures
    assert (np.abs(vtks - rough).max(axis=2) > 8).sum() > 500
    assert np.abs(ours - vtks).max() == 1, "rounded otherwise: they are two shaders"
