"""The world pane: its matrices, and the pixels that reach the screen."""

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import pyvista as pv
from numpy.typing import NDArray
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkRenderingCore import vtkCamera

from app.drawings import WORDS
from app.drawings.dimensions import Dimensions
from app.drawings.frustum import view_from_cube
from app.drawings.label_placement import Ground
from app.drawings.near_picture import SLAB, flatten, flatten_free
from app.drawings.style import DARK, LIGHT, Style
from app.drawings.world import WorldDrawing
from app.drawings.world_state import view_matrices
from app.lecture.typed_matrix import with_cell
from app.model.lenses.oblique import OBLIQUE_PRESETS
from app.model.projection import (
    PLANES,
    Array,
    Camera,
    Chain,
    FreeMatrix,
    Frustum,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.picking.handles import EYE
from app.scenes.scene import Scene, load
from tests.support.cameras import random_projections
from tests.support.drawings import (
    MakeScreen,
    OffScreen,
    boxes_of,
    colours_of,
    drawn,
    heard,
    overlapping,
    rendered,
    shown,
    texts_of,
    to_bytes,
)
from tests.support.frustum import corners_world
from tests.support.letter_f import AFAR, letter_f

Pixels = NDArray[np.uint8]
CUBE = np.array([(x, y, z) for z in (1, 0) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
START = AFAR


class View:
    """A world drawing in an off-screen window that it finds empty and leaves empty."""

    def __init__(
        self, plotter: Any, scene: Scene, width: int = 500, height: int = 560, style: Style = LIGHT
    ) -> None:
        self.plotter = plotter
        self.window = plotter.render_window
        self.window.SetSize(width, height)
        self.camera = vtkCamera()
        plotter.renderer.SetActiveCamera(self.camera)
        self.drawing = WorldDrawing(plotter, scene, WORDS, style)
        self.drawing.show_names(None)
        self.scene = scene

    def pixels(self) -> Pixels:
        return rendered(self.window)

    def pixel_of(self, points_world: Any) -> Array:
        """Column and row, (..., 2), by VTK's own camera; to be called after a rendering."""
        width, height = self.window.GetSize()
        matrix = to_array(self.camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1))
        ndc = applied(matrix, np.asarray(points_world) - self.scene.origin)
        return (ndc[..., :2] * (0.5, -0.5) + 0.5) * (width, height)

    def stand(self, eye: Any, target: Any, angle_deg: float = 50.0) -> None:
        """Move the pane's own camera, as a user might."""
        self.camera.SetPosition(*eye)
        self.camera.SetFocalPoint(*target)
        self.camera.SetViewAngle(angle_deg)
        self.drawing.reset_clipping_range()

    def hide_labels(self) -> None:
        for label in texts_of(self.plotter).values():
            label.set_opacity(0.0)


MakeView = Callable[..., View]


@pytest.fixture(scope="module")
def plotter() -> Iterator[Any]:
    plotter = OffScreen(500, 560)
    plotter.render_window.SetMultiSamples(0)
    plotter.render_window.Render()
    yield plotter
    plotter.close()


@pytest.fixture
def make_view(plotter: Any) -> Iterator[MakeView]:
    """Make world panes, one after the other; VTK must have had nothing to say."""
    made: list[View] = []

    def make(scene: Scene | str = "letter-f", *args: Any, **options: Any) -> View:
        if made:
            made.pop().drawing.remove()
        if isinstance(scene, str):
            scene = letter_f() if scene == "letter-f" else load(scene)
        made.append(View(plotter, scene, *args, **options))
        return made[-1]

    with heard() as said:
        yield make
        for view in made:
            view.drawing.remove()
    assert said.GetOutput() == ""


def to_array(matrix: vtkMatrix4x4) -> Array:
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def applied(matrix: Array, points: Any) -> Array:
    clip = np.asarray(points) @ matrix[:, :3].T + matrix[:, 3]
    return np.asarray(clip[..., :3] / clip[..., 3:])


def with_lens(**values: Any) -> Projection:
    return replace(START, lens=replace(START.lens, **values))


def orthographic(**values: Any) -> Projection:
    projection = START.with_lens("orthographic")
    return replace(projection, lens=replace(projection.lens, **values))


def frustum(**values: Any) -> Projection:
    return replace(START, lens=Frustum(**values))


def oblique(preset: str = "cabinet-63.4", **values: Any) -> Projection:
    alpha_deg, beta_deg = OBLIQUE_PRESETS[preset]
    lens = Oblique(alpha_deg=alpha_deg, beta_deg=beta_deg, **values)
    return replace(START, lens=lens)


# --------------------------------------------------------------------------- matrices


def test_the_frustum_is_the_unprojected_cube(make_view: MakeView) -> None:
    """Planes at their own distances are at the model's own corners, to 1e-12."""
    drawing = make_view().drawing
    whole = cut = 0
    for projection in random_projections(120):
        drawing.show_projection(projection)
        matrix = to_array(drawing.frustum.space.matrix)
        reach = drawing.state.volume.depths
        if reach.near_break is not None:
            continue
        if reach.far_break is not None:  # what is drawn is the frustum of a nearer far plane
            assert projection.lens.far > reach.high == reach.far
            projection = projection.between(projection.lens.near, reach.far)
            cut += 1
        else:
            whole += 1
        expected = corners_world(projection)[:, :3]
        size = np.abs(expected - projection.camera.eye).max() + np.abs(expected).max()
        assert np.abs(applied(matrix, CUBE) - expected).max() < 1e-12 * size, projection
        assert np.abs(matrix).max() <= 1.0  # or float32 overflows
    assert whole > 20 and cut > 20


def test_the_eye_lines_run_from_the_eye_to_the_near_corners(make_view: MakeView) -> None:
    view = make_view()
    for projection in random_projections(20):
        view.drawing.show_projection(projection)
        assert view.drawing.frustum.apex.GetVisibility() == (not projection.lens.parallel)
        if projection.lens.parallel:
            continue
        matrix = to_array(view.drawing.frustum.apex_space.matrix)
        ends = applied(matrix, np.array([(0.0, 0.0, 0.0), *CUBE[:4]]))
        expected = [projection.camera.eye, *corners_world(projection)[:4, :3]]
        assert np.allclose(ends, expected, rtol=0, atol=1e-9)


def test_a_part_of_the_view_volume_is_what_the_model_says() -> None:
    random = np.random.default_rng(6)
    for projection in random_projections(60, seed=7):
        near = max(projection.lens.near, 0.01) * random.uniform(0.5, 3.0)
        far = near + 10.0 ** random.uniform(-1.0, 3.0)
        part = replace(projection.between(near, far), depth="reversed")
        clip_from_view = projection.matrices_between(near, far)[0]
        view_from_clip = view_from_cube(projection, near, far)
        for found, expected in (
            (applied(view_from_clip, CUBE), applied(part.view_from_clip, CUBE)),
            (clip_from_view, part.clip_from_view),
            (applied(clip_from_view, applied(view_from_clip, CUBE)), CUBE),
        ):
            assert np.abs(found - expected).max() < 1e-9 * np.abs(expected).max(), projection


@pytest.mark.parametrize("parallel", [True, False])
def test_a_flattened_picture_is_where_its_corners_are_seen_and_in_order(parallel: bool) -> None:
    """Each point is on the pane's line of sight to its place on the near face, nearest on top."""
    random = np.random.default_rng(1)
    checked = 0
    for projection in random_projections(200, seed=2):
        lens, camera = projection.lens, projection.camera
        points = random.uniform((-2.0, 0.0, -2.0), (2.0, 5.0, 2.0), (60, 3))
        depths = (np.array(camera.eye) - points) @ camera.frame[2]
        trace = projection.trace(points)
        inside = ~trace.outside.any(axis=-1)
        if inside.sum() < 2:
            continue
        checked += 1
        on_face = np.column_stack([trace.ndc[inside, :2], np.ones(inside.sum())])
        world_from_clip = projection.with_depth("reversed").world_from_clip_at(np.zeros(3))
        face = applied(world_from_clip, on_face)
        thick = SLAB * (10.0 if lens.parallel else lens.near)
        pane_eye = random.uniform(20.0, 40.0, 3) * random.choice([-1.0, 1.0], 3)
        sight = pane_eye - face
        toward = thick * np.array([*pane_eye, 1.0]) / np.linalg.norm(sight[0])
        if parallel:
            sight = np.tile(pane_eye / np.linalg.norm(pane_eye), (len(face), 1))
            toward = thick * np.array([*sight[0], 0.0])
        view, corners = view_matrices(camera, np.zeros(3))[0], applied(world_from_clip, CUBE[:4])
        film = flatten(projection, view, (depths.min(), depths.max()), corners, 10.0, toward)
        moved = applied(film.surface, points[inside]) - face
        parts = (moved * sight).sum(axis=1) / (sight * sight).sum(axis=1)
        rounding = 1e-9 * (1.0 + np.abs(face).max())
        assert np.abs(moved - parts[:, None] * sight).max() < rounding, "no pixel moves"
        lengths = parts * np.linalg.norm(sight[0])
        assert lengths.min() >= -rounding and lengths.max() <= 1.02 * thick + rounding
        order = np.argsort(depths[inside])
        assert (np.diff(lengths[order]) <= rounding).all()
        spread = (np.ptp(lengths) / thick) / (np.ptp(depths[inside]) / np.ptp(depths))
        assert spread > 0.005  # the thickness is spent on the scene, not on near to far
        lifted = applied(film.lines, points[inside]) - face
        assert ((lifted * sight).sum(axis=1) > (moved * sight).sum(axis=1)).all()
    assert checked > 40


def test_the_windows_planes_cut_what_the_model_says_is_outside() -> None:
    """Also for points behind the eye, whose flattened w is negative: VTK multiplies first."""
    random = np.random.default_rng(3)
    behind = 0
    for projection in random_projections(60, seed=4):
        points = random.uniform(-40.0, 40.0, (200, 3))
        depths = (np.array(projection.camera.eye) - points) @ projection.camera.frame[2]
        near, far = projection.lens.near, projection.lens.far
        if not (depths.max() > near and depths.min() < far):
            continue
        bounds = depths.min(), depths.max()
        view = view_matrices(projection.camera, np.zeros(3))[0]
        world_from_clip = projection.with_depth("reversed").world_from_clip_at(np.zeros(3))
        corners = applied(world_from_clip, CUBE[:4])
        toward = 0.05 * np.array([*random.uniform(-1.0, 1.0, 3), 0.0])
        film = flatten(projection, view, bounds, corners, 10.0, toward)
        flat = points @ film.surface[:, :3].T + film.surface[:, 3]
        cut = ((flat @ film.planes.T) < 0.0).any(axis=1)
        outside = projection.trace(points).outside
        thin = np.abs(np.stack([depths - near, depths - far])).min(axis=0) < 0.05
        assert (cut == outside.any(axis=1))[~thin].all(), projection
        behind += int((flat[:, 3] < 0.0).sum())
        for plane, name in zip((0, 1, 2, 3), PLANES[2:], strict=True):
            in_front = ~thin & (depths > 0.0)
            alone = (flat @ film.planes[plane] < 0.0) == outside[:, PLANES.index(name)]
            assert alone[in_front].all(), name
    assert behind > 1000


# --------------------------------------------------------------------------- the break


@pytest.mark.parametrize(
    ("projection", "broken", "labels"),
    [
        (with_lens(near=2.0, far=15.0), set(), {"near n = 2", "far f = 15"}),
        (with_lens(far=1e6), {"far"}, {"near n = 4", "far f = 1e+06"}),
        (with_lens(far=math.inf), {"far"}, {"near n = 4", "far f = ∞"}),
        (with_lens(near=1e-6, far=math.inf), {"far"}, {"near n = 1e−06", "far f = ∞"}),
        (with_lens(near=2000.0, far=30000.0), {"near", "far"}, {"near n = 2000", "far f = 30000"}),
        (orthographic(near=-2.0, far=16.0), set(), {"near n = −2", "far f = 16"}),
        (orthographic(near=-1e9, far=1e9), {"near", "far"}, {"near n = −1e+09", "far f = 1e+09"}),
        (orthographic(near=-300.0, far=-200.0), {"near", "far"}, {"near n = −300", "far f = −200"}),
        (orthographic(near=500.0, far=600.0), {"near", "far"}, {"near n = 500", "far f = 600"}),
    ],
)
def test_a_plane_beyond_the_reach_is_broken_and_says_its_distance(
    make_view: MakeView, projection: Projection, broken: set[str], labels: set[str]
) -> None:
    view = make_view()
    view.drawing.show_projection(projection)
    view.drawing.reset_view()
    assert broken_planes(view) == broken
    assert labels <= set(texts_of(view.plotter))
    corners = applied(to_array(view.drawing.frustum.space.matrix), CUBE)
    away = np.linalg.norm(corners - view.scene.centre, axis=1)
    assert away.max() < 10.0 * view.scene.size
    drawn_to = view.drawing.state.volume.depths
    assert drawn_to is not None
    near = (drawn_to.near_break or (0.0, drawn_to.near))[1]
    far = (drawn_to.far_break or (drawn_to.far,))[0]
    assert drawn_to.body == (near, far), "the edges end where the break begins"


@pytest.mark.parametrize("azimuth", [-100.0, -60.0, 0.0, 35.0, 80.0, 125.0])
@pytest.mark.parametrize("style", [LIGHT, DARK])
def test_the_break_reads_from_everywhere(make_view: MakeView, style: Style, azimuth: float) -> None:
    """Each edge has two separate strokes in the frustum's colour."""
    view = make_view("letter-f", 700, 700, style)
    view.drawing.show_projection(with_lens(far=1e6))
    view.drawing.reset_view()
    view.camera.Azimuth(azimuth)
    view.drawing.reset_clipping_range()
    view.hide_labels()
    for actor in view.plotter.renderer.GetActors():
        if all(actor is not edge for _, edge in view.drawing.frustum.breaks["far"]):
            actor.VisibilityOff()
    image = view.pixels()
    painted = drawn(image, to_bytes(style.frustum))
    seen = 0
    for space, edge in view.drawing.frustum.breaks["far"]:
        lines = np.array(edge.GetMapper().GetInput().GetPoints().GetData()).reshape(-1, 2, 3)
        spots = view.pixel_of(applied(to_array(space.matrix), lines))
        middle = spots[1:3].mean(axis=(0, 1))
        if not ((middle > 20) & (middle < 680)).all():
            continue
        seen += 1
        first, second = spots[1], spots[2]
        assert 7.5 < np.linalg.norm(first[1] - first[0]) < 18.8
        gap = np.linalg.norm(second - first, axis=1)
        assert ((gap > 2.9) & (gap < 10.0)).all()
        for stroke in (first, second):
            for part in (0.1, 0.9):
                column, row = np.floor(stroke[0] + part * (stroke[1] - stroke[0])).astype(int)
                assert painted[row - 1 : row + 2, column - 1 : column + 2].any()
        column, row = np.floor(middle).astype(int)
        along = np.linalg.norm(spots[0, 1] - spots[0, 0])
        assert along < 10.0 or not painted[row, column]
    assert seen >= 2


def broken_planes(view: View) -> set[str]:
    return {
        name
        for name, edges in view.drawing.frustum.breaks.items()
        if all(edge.GetVisibility() for _, edge in edges)
    }


def test_the_reach_is_continuous_and_the_pane_stands_still(make_view: MakeView) -> None:
    """While a control is dragged nothing jumps: neither the cut nor the pane's camera."""
    view = make_view()
    before = (*view.camera.GetPosition(), *view.camera.GetFocalPoint(), view.camera.GetViewAngle())
    last: Array | None = None
    for step in range(400):
        angle = 2.0 * math.pi * step / 400.0
        eye = (14.0 * math.sin(angle), 5.0, 9.0 * math.cos(angle))
        near = 10.0 ** (step / 40.0 - 4.0)
        lens = Perspective(45.0, near, 2e7)
        view.drawing.show_projection(Projection(Camera(eye, (0.0, 2.0, 0.0)), lens))
        reach = view.drawing.state.volume.depths
        now = np.array([reach.high, min(reach.near, 100.0), reach.far])
        if last is not None:
            assert (np.abs(now - last) < 0.07 * np.abs(last) + 0.05).all(), step
        last = now
    after = (*view.camera.GetPosition(), *view.camera.GetFocalPoint(), view.camera.GetViewAngle())
    assert after == before


# --------------------------------------------------------------------------- pixels


def colour_at(image: Pixels, pixel: Array) -> list[int]:
    column, row = np.floor(pixel).astype(int)
    return [int(part) for part in image[row, column]]


def test_an_object_of_one_point_is_drawn_from_very_far(make_view: MakeView) -> None:
    """Nothing overflows, which would be a warning."""
    camera = Camera((0.0, 0.0, 1e90), (0.0, 0.0, 0.0))
    one_point = Chain.read("scale 0,0,0")
    view = make_view()
    view.drawing.show_projection(replace(START, camera=camera, placement=one_point))
    view.drawing.reset_view()
    assert view.pixels().any()


@pytest.mark.parametrize("style", [LIGHT, DARK])
def test_markers_light_their_pixels(make_view: MakeView, style: Any) -> None:
    """Eye and target are visible from every direction, also through the letter F."""
    view = make_view(style=style)
    for azimuth in (0.0, 35.0, 180.0, 250.0):
        view.drawing.reset_view()
        view.camera.Azimuth(azimuth)
        view.drawing.reset_clipping_range()
        for eye in ((6.0, 5.0, 9.0), (1.0, 3.0, 8.0)):
            view.drawing.show_projection(replace(START, camera=Camera(eye, (0.0, 2.5, 0.0))))
            image = view.pixels()
            for point, colour in ((eye, style.eye), ((0.0, 2.5, 0.0), style.target)):
                assert colour_at(image, view.pixel_of(point)) == to_bytes(colour), azimuth


def test_axes_are_seen_before_the_body(make_view: MakeView) -> None:
    """Each axis is visible from the eye to its letter, although the camera is solid."""
    view = make_view("letter-f", 1280, 720)
    view.hide_labels()
    frame, eye = START.camera.frame, np.array(START.camera.eye)
    for azimuth in (0.0, 40.0, 130.0, 320.0):
        view.drawing.reset_view()
        view.camera.Azimuth(azimuth)
        view.drawing.reset_clipping_range()
        image = view.pixels()
        for name, axis, length in zip("uvn", frame, (2.0, 2.0, 2.6), strict=True):
            for part in (0.4, 0.7, 0.9):
                tip = eye + part * length * view.drawing.camera.body_size * axis
                column, row = np.floor(view.pixel_of(tip)).astype(int)
                around = image[row - 1 : row + 2, column - 1 : column + 2]
                painted = drawn(around, to_bytes(getattr(LIGHT, name)))
                near_eye = np.abs(view.pixel_of(tip) - view.pixel_of(eye)).max() < 9.0
                assert painted.any() or near_eye, (azimuth, name, part)


@pytest.mark.parametrize("side", ["eye's side", "other side"])
@pytest.mark.parametrize(
    "projection",
    [
        with_lens(near=3.0, fov_y_deg=38.0),
        replace(with_lens(near=3.0, far=math.inf), depth="direct3d"),
        replace(orthographic(near=3.0, left=-4.0, right=4.0, bottom=-4, top=4), depth="reversed"),
        replace(START, lens=Frustum(-1.9, 0.7, -1.2, 0.8, 3.0, math.inf, "x"), depth="direct3d"),
        oblique(near=7.0, left=-4.0, right=5.0, bottom=-1.0, top=6.0),
        replace(
            oblique("cavalier-30", near=7.0, left=-1.5, right=10.5, bottom=0.0, top=5.0, keep="x"),
            depth="reversed",
        ),
    ],
)
def test_the_picture_on_the_near_plane_is_the_image(
    make_view: MakeView, off_screen: MakeScreen, projection: Projection, side: str
) -> None:
    """The colours of the image pane, seen obliquely and from both sides."""
    scene = replace(load("letter-f"), lines=None)
    view = make_view(scene, 700, 600)
    view.drawing.show_projection(projection)
    width, height = projection.image_size
    random = np.random.default_rng(5)
    pixels = random.uniform((0.25 * width, 0.1 * height), (0.75 * width, 0.9 * height), (250, 2))
    left, right, bottom, top = projection.window
    x = left + (right - left) * pixels[:, 0] / width
    y = top - (top - bottom) * pixels[:, 1] / height
    in_view = np.column_stack([x, y, np.full(len(x), -projection.lens.near)])
    points = np.array(projection.camera.eye) + in_view @ projection.camera.frame
    screen = off_screen(width, height)
    picture = shown(screen, scene, projection)
    # Slanted rays cross the slab slantwise: up to its thickness, 13 px here, beside the plane.
    far = 20 if projection.lens.kind == "oblique" else 9
    camera, near = projection.camera, projection.lens.near
    centre = points.mean(axis=0)
    u, v, n = camera.frame
    toward = 1.0 if side == "eye's side" else -1.0
    size = projection.window[3] * 2.0
    view.stand(
        centre + (toward * n + 0.35 * u + 0.25 * v) * min(0.8 * size, 0.8 * near), centre, 90
    )
    view.hide_labels()
    if projection.lens.kind == "oblique":  # the box, the scene and the target are in the way
        for actor in view.plotter.renderer.GetActors():
            actor.SetVisibility(actor in view.drawing.picture.actors)
    image = view.pixels()
    spots = view.pixel_of(points)
    hits = 0
    for spot, (column, row) in zip(spots, pixels.astype(int), strict=True):
        colour = picture[row, column].tolist()
        beside = picture[
            [row, row, row - far, row + far], [column - far, column + far, column, column]
        ]
        settled = (beside == colour).all() and colour != to_bytes(LIGHT.background)
        if not settled or not ((spot > 2) & (spot < (698, 598))).all():
            continue
        hits += 1
        assert colour_at(image, spot) == colour, spot
    assert hits > 25


@pytest.mark.parametrize("eye", [(0.3, 2.0, 7.0), (0.6, 4.0, 3.2)])
def test_nothing_of_the_picture_is_outside_its_window(
    make_view: MakeView, eye: tuple[float, float, float]
) -> None:
    """Seen from between near plane and scene, the only F is the one on the plane."""
    scene = load("letter-f")
    view = make_view(scene, 500, 500)
    lens = Perspective(18.0, 2.0, 30.0)
    projection = Projection(Camera(eye, (0.0, 2.2, 0.0)), lens, (400, 400))
    view.drawing.show_projection(projection)
    u, _, n = projection.camera.frame
    middle = np.array(eye) - lens.near * n
    view.stand(middle - 0.5 * n + 0.1 * u, middle, 100.0)
    view.hide_labels()
    for actor in view.plotter.renderer.GetActors():  # the scene stands beside and behind
        if actor not in view.drawing.picture.actors:
            actor.VisibilityOff()
    painted = (view.pixels() != np.array(to_bytes(LIGHT.background))).any(axis=-1)
    corners = view.pixel_of(corners_world(projection)[:4, :3])
    rows, columns = np.nonzero(painted)
    spots = np.stack([columns + 0.5, rows + 0.5], axis=1)
    edges = np.roll(corners, -1, axis=0) - corners
    across = np.stack(
        [edge[0] * (spots[:, 1] - at[1]) - edge[1] * (spots[:, 0] - at[0])
         for edge, at in zip(edges, corners, strict=True)]
    ) / np.linalg.norm(edges, axis=1)[:, None]  # fmt: skip
    turned = np.sign(np.median(across))
    assert (turned * across > -5.0).all()  # the slab's thickness from so near, and a line's
    assert len(rows) > 2000


CROWDED = [
    START,
    with_lens(fov_y_deg=5.0),
    with_lens(fov_y_deg=63.0),
    with_lens(near=4.0),
    with_lens(near=1e-6, far=math.inf),
    with_lens(near=2000.0, far=30000.0),
    with_lens(near=1.0, far=1.0 + 1e-12),
    orthographic(near=-5),
    replace(START, camera=Camera((6e11, 5e11, 9e11), (0.0, 2.2, 0.0))),
    replace(START, camera=Camera((0.0, 14.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, -1.0))),
]


def from_box(point: Array, box: tuple[float, float, float, float]) -> float:
    return float(np.linalg.norm(np.clip(point, box[:2], box[2:]) - point))


@pytest.mark.parametrize("size", [(412, 670), (1280, 720)])
@pytest.mark.parametrize("projection", CROWDED)
def test_a_planes_label_is_in_the_pane_and_at_its_own_plane(
    make_view: MakeView, projection: Projection, size: tuple[int, int]
) -> None:
    """It is nearer to its own plane than to the other one, where a reader would misread it."""
    view = make_view("letter-f", *size)
    view.drawing.show_projection(projection)
    view.drawing.reset_view()
    view.pixels()
    boxes = {text.split()[0]: box for text, box in boxes_of(view.plotter).items()}
    assert {"eye", "target"} <= boxes.keys() and {"near", "far"} & boxes.keys()
    assert overlapping(boxes) == []
    for left, bottom, right, top in boxes.values():
        assert left >= 0 and bottom >= 0 and right <= size[0] and top <= size[1]
    corners = applied(to_array(view.drawing.frustum.space.matrix), CUBE)
    spots = view.pixel_of(corners) * (1, -1) + (0, size[1])
    parts = np.linspace(0.0, 1.0, 41)[:, None, None]
    for name, face in (("near", spots[:4]), ("far", spots[4:])):
        if name in boxes:
            edges = (face + parts * (np.roll(face, -1, axis=0) - face)).reshape(-1, 2)
            apart = min(from_box(spot, boxes[name]) for spot in edges)
            inside = any(
                from_box(np.array(spot[:2]), boxes[name]) == 0.0
                for spot in view.drawing.own.pane.covered(corners[4 * (name == "far") :][:4])
            )
            assert apart < 6.0 * LIGHT.font_size or inside, name


def history() -> Iterator[Projection]:
    """A drag of the near plane and the camera, to and fro."""
    for step in (*range(60), *range(60, 20, -1)):
        orbit = START.camera.orbit._replace(azimuth_deg=4.0 * step)
        camera = Camera.from_orbit(START.camera.target, orbit)
        yield replace(with_lens(near=0.5 * 1.05**step), camera=camera)


def test_no_label_lies_on_the_picture_on_the_near_plane(make_view: MakeView) -> None:
    view = make_view(load("letter-f"), 1366, 598, LIGHT.enlarged(26.0 / LIGHT.font_size))
    shown = with_lens(near=6.0, far=14.0)
    view.drawing.show_names(frozenset({"near", "far", "l", "r", "b", "t"}))
    view.drawing.show_projection(shown)
    view.drawing.reset_view()
    view.pixels()
    vertices = np.asarray(view.scene.surface.points) + view.scene.origin
    x, y, _, w = shown.clip_from_world @ np.column_stack([vertices, np.ones(len(vertices))]).T
    left_low, right_low, _, left_top = corners_world(shown)[:4, :3]
    across, up = (x / w + 1.0) / 2.0, (y / w + 1.0) / 2.0
    pictured = left_low + np.outer(across, right_low - left_low) + np.outer(up, left_top - left_low)
    column, row = view.pixel_of(pictured).T
    boxes = boxes_of(view.plotter)
    assert len(boxes) == 6
    for text, (left, low, right, top) in boxes.items():
        on_it = (left < column) & (column < right) & (low < 598 - row) & (598 - row < top)
        assert not on_it.any(), text


def test_labels_stay_on_their_sides_while_something_moves(make_view: MakeView) -> None:
    """They change sides less often than when each step is laid out afresh."""
    view = make_view("letter-f", 430, 620)
    far = 3.0 * LIGHT.font_size  # farther than anything is moved by a step
    changes = {True: 0, False: 0}
    for afresh in changes:
        view.drawing.show_projection(START)
        view.stand((14.0, 9.0, 20.0), (2.0, 2.0, 4.0))
        before: dict[str, Any] = {}
        for projection in history():
            view.drawing.show_projection(projection)
            if afresh:
                view.drawing.layers.place_labels(afresh=True)
            boxes = boxes_of(view.plotter)
            now = {text.split()[0]: np.array(box) for text, box in boxes.items()}
            changes[afresh] += sum(
                bool(np.abs(now[name] - before[name]).max() > far) for name in now.keys() & before
            )
            before = now
            assert overlapping(boxes) == [], projection
    assert 0 < changes[False] <= 0.7 * changes[True]


def test_at_rest_nothing_depends_on_what_was_before(make_view: MakeView) -> None:
    """When a gesture ends, all is as in a new drawing, once the labels that move have faded."""
    eye, target = np.array((14.0, 9.0, 20.0)), np.array((2.0, 2.0, 4.0))
    projections, expected = list(history())[8::8], []
    for projection in projections:
        view = make_view("letter-f", 430, 620)
        view.drawing.show_names(frozenset({"eye", "near", "far"}))
        view.drawing.show_projection(projection)
        view.stand(eye, target)
        assert not view.drawing.refit()
        expected.append(view.pixels())
    view = make_view("letter-f", 430, 620)
    view.drawing.show_names(frozenset({"eye", "near", "far"}))
    view.stand(eye, target)
    board, moved = view.drawing.board, 0
    board.is_patient = True
    for projection in history():
        view.drawing.show_projection(projection)
        board.pass_time(0.5)
        if projection not in projections:
            continue
        before = boxes_of(view.plotter)
        view.drawing.refit()
        assert boxes_of(view.plotter) == before, "it fades, and never jumps"
        board.pass_time(0.5)
        moved += boxes_of(view.plotter) != before
        assert not view.drawing.refit() and not board.is_restless, "it rests"
        assert (view.pixels() == expected[projections.index(projection)]).all()
    assert moved


@pytest.mark.parametrize("style", [LIGHT, DARK])
def test_a_plane_that_covers_the_pane_does_not_flood_it(make_view: MakeView, style: Style) -> None:
    """Its tint fades, its label stays; a plane that is seen whole keeps its tint."""
    view = make_view("letter-f", 412, 670, style)
    view.drawing.show_projection(with_lens(fov_y_deg=179.0))
    view.drawing.reset_view()
    image = view.pixels().astype(int)
    colour = np.array([np.median(image[..., channel]) for channel in range(3)])
    off = np.abs(colour - to_bytes(style.background)).max()
    assert 2 < off < 30
    assert {"near n = 4", "far f = 18"} <= set(texts_of(view.plotter))
    boxes = boxes_of(view.plotter)
    for name in ("near n = 4", "far f = 18"):
        left, bottom, right, top = boxes[name]
        assert left >= 0 and bottom >= 0 and right <= 412 and top <= 670
    view.drawing.show_projection(with_lens(near=8.0, far=15.0))
    view.drawing.reset_view()
    assert [tint.GetProperty().GetOpacity() for tint, _ in view.drawing.frustum.tints.values()] == [
        0.3,
        0.16,
    ]


def test_what_a_plane_covers_of_the_pane_is_what_is_painted(make_view: MakeView) -> None:
    view = make_view("letter-f", 400, 300)
    checked = 0
    places = (np.array([*np.ndindex(9, 9)]) + 0.5) / 9.0  # the middles of 81 parts of the pane
    for projection in random_projections(40, seed=9):
        view.drawing.show_projection(projection)
        view.drawing.reset_view()
        view.hide_labels()
        pane = view.drawing.own.pane
        turned_away = pane._replace(axes=pane.axes * [[-1.0], [1.0], [-1.0]])
        for corners in np.split(view.drawing.state.volume.corners, 2):
            assert turned_away.covered(corners) == []
        for tint, corners in zip(
            view.drawing.frustum.tints.values(),
            np.split(view.drawing.state.volume.corners, 2),
            strict=True,
        ):
            for actor in view.plotter.renderer.GetActors():
                actor.SetVisibility(actor is tint[0])
            tint[0].GetProperty().SetOpacity(1.0)
            painted = (view.pixels() != to_bytes(LIGHT.background)).any(axis=-1)
            covered = {(round(x), round(y)) for x, y, _ in pane.covered(corners)}
            for x, y in places * (400, 300):
                column, row = int(x), int(300 - y)
                around = painted[max(0, row - 2) : row + 3, max(0, column - 2) : column + 3]
                if around.all() or not around.any():
                    assert around.all() == ((round(x), round(y)) in covered), projection
                    checked += int(around.all())
    assert checked > 60


def test_what_is_covered_does_not_depend_on_the_unit(make_view: MakeView) -> None:
    view = make_view("letter-f", 400, 300)
    view.drawing.show_projection(with_lens(fov_y_deg=170.0))
    pane, corners = view.drawing.own.pane, view.drawing.state.volume.corners[4:]
    near = np.array(pane.covered(corners))
    far = np.array(pane._replace(eye=pane.eye * 1e99).covered(corners * 1e99))
    assert len(near) > 3
    assert far == pytest.approx(near * (1.0, 1.0, 1e99), rel=1e-9)


# --------------------------------------------------------------------------- behaviour


def test_the_scene_and_its_picture_share_their_points(make_view: MakeView) -> None:
    """Otherwise a large mesh would be on the GPU twice."""
    view = make_view()
    inputs = [a.GetMapper().GetInput() for a in view.drawing.picture.actors]
    others = [
        a.GetMapper().GetInput()
        for a in view.plotter.renderer.GetActors()
        if a not in view.drawing.picture.actors
    ]
    assert [mesh.GetNumberOfCells() > 0 for mesh in inputs] == [True, True, False]
    for mesh in inputs:
        assert any(mesh is other for other in others)


@pytest.mark.parametrize("size", [(500, 560), (1280, 720), (300, 400)])
@pytest.mark.parametrize("scene", ["letter-f", "cube", "posts"])
def test_the_view_has_everything_in_it_from_beside(
    make_view: MakeView, scene: str, size: tuple[int, int]
) -> None:
    view = make_view(scene, *size)
    view.pixels()
    start = view.scene.start
    corners = applied(to_array(view.drawing.frustum.space.matrix), CUBE)
    points = np.array([start.camera.eye, start.camera.target, view.scene.centre, *corners])
    spots = view.pixel_of(points)
    assert ((spots > 0) & (spots < size)).all()
    assert np.ptp(spots, axis=0).max() > 0.5 * min(size)  # and as large as it can be
    # Seen side by side, not one behind the other.
    assert np.linalg.norm(spots[0] - spots[2]) > 0.2 * min(size)


def test_a_resized_pane_fits_again_unless_its_view_was_moved(make_view: MakeView) -> None:
    view = make_view("letter-f", 500, 560)
    view.pixels()
    first = view.camera.GetPosition()
    view.window.SetSize(900, 300)
    view.pixels()
    assert view.camera.GetPosition() != first
    spots = view.pixel_of(applied(to_array(view.drawing.frustum.space.matrix), CUBE))
    assert ((spots > 0) & (spots < (900, 300))).all()
    view.camera.Azimuth(20.0)
    view.drawing.reset_clipping_range()
    moved = view.camera.GetPosition()
    view.window.SetSize(500, 500)
    view.pixels()
    assert view.camera.GetPosition() == moved


FAR_AWAY = replace(START, camera=Camera((6e11, 5e11, 9e11), (0.0, 2.2, 0.0)))


def toward(camera: vtkCamera) -> Array:
    return np.array(camera.GetDirectionOfProjection())


@pytest.mark.parametrize(
    "projection",
    [
        with_lens(fov_y_deg=63.0),
        with_lens(fov_y_deg=100.0),
        orthographic(near=-5.0, bottom=-12.0, top=12.0),
        replace(START, camera=Camera((0.0, 14.0, 30.0), (0.0, 0.0, 0.0))),
        FAR_AWAY,
    ],
)
def test_refit_brings_back_what_has_left_the_picture(
    make_view: MakeView, projection: Projection
) -> None:
    """The whole frustum, as large as possible, in the former direction of view."""
    view = make_view("letter-f", 412, 670)
    view.pixels()
    before, direction = view.camera.GetPosition(), toward(view.camera)
    view.drawing.show_projection(projection)
    assert view.camera.GetPosition() == before
    assert view.drawing.refit() and view.drawing.view is None
    assert np.allclose(toward(view.camera), direction, atol=1e-9)
    view.pixels()
    corners = applied(to_array(view.drawing.frustum.space.matrix), CUBE)
    points = [projection.camera.eye, projection.camera.target, view.scene.centre, *corners]
    spots = view.pixel_of(np.array(points))
    assert ((spots > 0) & (spots < (412, 670))).all()
    assert (np.ptp(spots, axis=0) / (412, 670)).max() > 0.5
    placed = view.camera.GetPosition()
    assert not view.drawing.refit() and view.camera.GetPosition() == placed
    view.window.SetSize(670, 412)  # what was fitted is fitted into another size, too
    view.pixels()
    spots = view.pixel_of(np.array(points))
    assert ((spots > 0) & (spots < (670, 412))).all()


def test_refit_leaves_alone_what_is_in_the_picture_or_was_moved(make_view: MakeView) -> None:
    view = make_view()
    view.pixels()
    place = view.camera.GetPosition()
    for projection in (START, with_lens(fov_y_deg=30.0), with_lens(near=5.0)):
        view.drawing.show_projection(projection)
        view.drawing.refit()  # may put a label elsewhere, once
        assert not view.drawing.refit() and view.camera.GetPosition() == place
    view.camera.Azimuth(20.0)
    view.drawing.reset_clipping_range()
    place = view.camera.GetPosition()
    view.drawing.show_projection(with_lens(fov_y_deg=100.0))
    view.drawing.refit()
    assert not view.drawing.refit() and view.camera.GetPosition() == place


def test_a_name_that_appears_while_something_is_held_moves_no_view() -> None:
    scene, window = load("vanishing-points"), OffScreen(420, 300)
    drawing = WorldDrawing(window, scene, WORDS, LIGHT, live=True)
    start, camera = scene.start, window.renderer.GetActiveCamera()
    away = replace(start, camera=replace(start.camera, eye=(5.338, 1.981, 4.334)))
    places = []
    for held, projection in ((None, start), (EYE, start), (EYE, away)):
        drawing.hold(held)
        drawing.show_projection(projection, scene.illustration(projection, {}))
        window.render_window.Render()
        places.append(camera.GetPosition())
    assert len(set(places)) == 1
    drawing.remove()
    window.close()


@pytest.mark.parametrize("fixed", ["", "side"])
def test_an_edit_that_is_undone_leaves_the_view_where_it_was(
    make_view: MakeView, fixed: str
) -> None:
    view = make_view()
    view.drawing.show_fixed(fixed)
    view.pixels()
    states, stood = [START, *(with_lens(fov_y_deg=fov) for fov in (30.0, 100.0, 140.0))], []
    for projection in states:
        view.drawing.show_projection(projection)
        view.drawing.refit()
        stood.append(view.camera.GetPosition())
    assert stood[0] == stood[1] != stood[2] != stood[3]
    for projection, place in list(zip(states, stood, strict=True))[::-1]:
        view.drawing.show_projection(projection)
        view.drawing.refit()
        assert view.camera.GetPosition() == place and view.drawing.view is None
    view.camera.Azimuth(20.0)
    view.drawing.reset_clipping_range()
    moved = view.camera.GetPosition()
    for projection in states:
        view.drawing.show_projection(projection)
        view.drawing.refit()
        assert fixed or view.camera.GetPosition() == moved


def test_a_frustum_too_wide_to_be_framed_does_not_make_the_scene_tiny(make_view: MakeView) -> None:
    view = make_view("letter-f", 412, 670)
    tall = []
    for projection in (START, with_lens(fov_y_deg=179.0), replace(START, image_size=(4000, 100))):
        view.drawing.show_projection(projection)
        view.drawing.reset_view()
        view.pixels()
        spots = view.pixel_of(np.array([(0.0, 0.0, 0.0), (0.0, 5.0, 0.0)]))
        tall.append(np.ptp(spots[:, 1]))
    assert min(tall) > 0.5 * tall[0] > 20.0


@pytest.mark.parametrize(
    "projection",
    [
        with_lens(fov_y_deg=1e-4),
        with_lens(fov_y_deg=179.99),
        with_lens(near=1e-9, far=math.inf),
        with_lens(near=1e-205, far=math.inf),
        with_lens(near=1.0, far=1.0 + 1e-12),
        with_lens(near=1e9, far=1e12),
        orthographic(near=-1e12, far=1e12),
        orthographic(left=-1e-6, right=1e-6),
        orthographic(left=-1e9, right=1e9, bottom=-1e9, top=1e9),
        orthographic(left=0.0, right=1e90, bottom=-1e80, top=0.0),
        frustum(near=1e-89),
        frustum(left=-1e-90, right=1e-90),
        frustum(left=1e5, right=1e5 + 1.0, far=math.inf),
        frustum(left=-1e9, right=1e9, bottom=-1e-9, top=1e9),
        frustum(left=-1e80, bottom=1e20, top=1e30),
        oblique(near=-1e12, far=1e12),
        oblique(left=-1e-190, right=1e-190),
        replace(START, lens=Oblique(alpha_deg=1e-4, beta_deg=179.9999)),
        replace(START, camera=Camera((0.0, 30.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, -1.0))),
        replace(START, camera=Camera((0.0, 2.2, 0.3), (0.0, 2.2, 0.0), (1.0, 1.0, 0.0))),
        replace(START, camera=Camera((6.0, 5.0, 9.0), (12.0, 8.0, 18.0))),
        replace(START, camera=Camera((1e7, 5.0, 9.0), (0.0, 2.2, 0.0))),
        replace(START, camera=Camera((6.0, 5.0, 9.0), (0.0, -1e12, 0.0))),
    ],
)
def test_extremes_draw_the_scene_and_the_camera(
    make_view: MakeView, projection: Projection
) -> None:
    view = make_view("letter-f", 300, 340)
    view.drawing.show_projection(projection)
    first = view.pixels()
    view.drawing.reset_view()
    second = view.pixels()
    for space in (view.drawing.frustum.space, view.drawing.picture.space):
        matrix = to_array(space.matrix)
        assert np.isfinite(matrix.astype(np.float32)).all()
    on_the_gpu = to_array(view.drawing.frustum.space.matrix).astype(np.float32)
    with np.errstate(divide="raise", invalid="raise"):
        drawn = applied(on_the_gpu, CUBE.astype(np.float32))
    assert np.isfinite(drawn).all()
    for image in (first, second):
        assert colours_of(image) > 5
    eye = view.pixel_of(projection.camera.eye)
    assert ((eye > 0) & (eye < (300, 340))).all()
    assert colour_at(second, eye) == to_bytes(LIGHT.eye)


def test_a_flat_scene_in_the_eye_plane(make_view: MakeView) -> None:
    """It has no depth to spread over the slab."""
    mesh = pv.PolyData(
        np.array([(-1.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]), faces=[3, 0, 1, 2]
    )
    mesh.cell_data["rgb"] = np.array([(200, 0, 0)], dtype=np.uint8)
    start = Projection(Camera((0.0, 0.0, 0.0), (0.0, 0.0, -1.0)), Orthographic(near=-1.0, far=1.0))
    scene = replace(
        load("letter-f"),
        surface=mesh,
        lines=None,
        lower=(-1.0, 0.0, 0.0),
        upper=(1.0, 1.0, 0.0),
        start=start,
    )
    view = make_view(scene)
    assert drawn(view.pixels(), (200, 0, 0)).sum() > 100


# --------------------------------------------------------------------------- free matrices


@pytest.mark.parametrize("depth", ["opengl", "direct3d", "reversed"])
@pytest.mark.parametrize(
    ("name", "row", "column", "value"),
    [
        ("clip_from_view", 0, 1, 0.5), ("clip_from_view", 3, 3, 4.0),
        ("clip_from_view", 0, 0, -1.0), ("view_from_world", 0, 0, -1.0),
    ],
)  # fmt: skip
def test_the_volume_of_a_free_matrix_is_the_cube_unprojected(
    make_view: MakeView, name: str, row: int, column: int, value: float, depth: Any
) -> None:
    view = make_view()
    free = with_cell(START.with_depth(depth), name, row, column, value)
    assert isinstance(free.lens, FreeMatrix)
    view.drawing.show_projection(free)
    assert {"near", "far"} <= set(texts_of(view.plotter))
    drawing = view.drawing
    corners = drawing.state.volume.corners + view.scene.origin
    assert np.allclose(corners, corners_world(free)[:, :3], rtol=1e-9, atol=1e-9)
    clip = applied(free.clip_from_world, corners)
    z_near, z_far = free.depth_range
    assert np.allclose(np.abs(clip[:, :2]), 1.0, atol=1e-6)
    assert np.allclose(clip[:4, 2], z_near, atol=1e-6)
    assert np.allclose(clip[4:, 2], z_far, atol=1e-6)
    drawing.reset_view()
    with_volume = view.pixels()
    assert (np.abs(with_volume.astype(int) - to_bytes(LIGHT.far)).sum(axis=2) < 30).any()
    # And back to a lens: as if it had never been.
    drawing.show_projection(START)
    drawing.reset_view()
    again = view.pixels()
    fresh = make_view()
    assert np.array_equal(again, fresh.pixels())


@pytest.mark.parametrize(
    ("row", "column", "value"), [(0, 0, 0.0), (2, 2, 0.0), (3, 2, 0.0), (3, 2, -2.0)]
)
def test_without_an_inverse_there_is_no_frustum(
    make_view: MakeView, row: int, column: int, value: float
) -> None:
    view = make_view()
    free = with_cell(START, "clip_from_view", row, column, value)
    assert free.frustum_sign == 0
    view.drawing.show_projection(free)
    view.drawing.reset_view()
    assert not {"near", "far", "near n = 1", "far f = 30"} & set(texts_of(view.plotter))
    picture = view.pixels()
    for colour in (LIGHT.near, LIGHT.far):
        assert not (np.abs(picture.astype(int) - to_bytes(colour)).sum(axis=2) < 12).any()


def test_the_picture_of_a_free_matrix_lies_on_its_near_face() -> None:
    free = with_cell(START, "clip_from_view", 0, 1, 0.5)
    origin = np.zeros(3)
    points = np.array([[0.5, 2.0, 0.5], [-1.0, 1.0, -0.5], [1.0, 3.0, 0.0]])
    clip = free.with_depth("reversed").clip_from_world
    on_face = np.column_stack([applied(clip, points)[:, :2], np.ones(3)])
    face = applied(free.with_depth("reversed").world_from_clip_at(origin), on_face)
    for eye in (np.array([12.0, 9.0, 20.0]), np.array([-4.0, 2.0, -9.0])):
        toward = SLAB * np.array([*eye, 1.0]) / np.linalg.norm(eye - face[0])
        moved, sight = (
            applied(flatten_free(free, origin, toward).surface, points) - face,
            eye - face,
        )
        assert np.allclose(np.cross(moved, sight), 0.0, atol=1e-9)
        assert ((moved * sight).sum(axis=1) > 0.0).all()
        assert np.linalg.norm(moved, axis=1).max() < 1.5 * SLAB


@pytest.mark.parametrize("times", [1.0, 3.0])
def test_lines_on_faces_are_lifted_along_their_rays(make_view: MakeView, times: float) -> None:
    view = make_view()
    view.stand((3.0, 2.0, 7.0), (0.0, 1.0, 0.0))
    own = view.drawing.own
    own.look()
    eye, points = np.array((3.0, 2.0, 7.0)), np.random.default_rng(3).uniform(-4, 4, (20, 3))
    lifted = applied(own.pane.lifted(times), points)
    np.testing.assert_allclose(lifted, points + times * 2e-3 * (eye - points), atol=1e-12)


@pytest.mark.parametrize("origin", [(0.0, 0.0, 0.0), (1e6, -3.0, 7.0)])
def test_a_view_that_was_turned_stays_while_the_frame_is_built(
    make_view: MakeView, origin: tuple[float, float, float]
) -> None:
    drawing = make_view(replace(load("letter-f"), origin=origin)).drawing
    eye, target = (tuple(np.add(origin, point)) for point in ((3.0, 4.0, 20.0), (0.0, 1.0, 0.0)))
    turned = Camera(eye, target)
    drawing.own.show(turned)
    assert drawing.own.view == turned
    drawing.show_step(2)
    assert drawing.own.view == turned
    drawing.show_step(None)
    assert drawing.own.view == turned


def test_a_label_waits_before_it_leaves_a_place_that_is_not_free(make_view: MakeView) -> None:
    board = make_view().drawing.board
    label = board.label("own", "own")

    def offset(x: float, *, afresh: bool = False, at_rest: bool = False) -> tuple[float, float]:
        """Where the label of a point stands from it, beside a mark in the middle."""
        ground = Ground((0.0, 0.0, 600.0, 400.0), board.em)
        ground.keep([(300.0, 200.0)], 20.0)
        board.want_beside("own", (x, 200.0, 1.0), 0.0)
        board.settle(ground, afresh=afresh, at_rest=at_rest)
        left, _, low, _ = label.box_px
        return round(left - x, 6), round(low - 200.0, 6)

    def light() -> float:
        return float(label.actor.GetProperty().GetOpacity())

    first = offset(200.0, afresh=True)
    assert offset(268.0) != first, "a figure has no time"
    board.is_patient = True
    for soft in (True, False):
        assert offset(200.0, afresh=True) == first
        assert offset(268.0) == first and board.is_restless
        assert not board.pass_time(0.25)
        assert offset(200.0) == first and not board.is_restless, "free again"
        assert offset(268.0) == first
        assert not board.pass_time(0.25, is_soft=soft)
        assert board.pass_time(0.06, is_soft=soft)
        lights = []
        for _ in range(4 if soft else 0):
            is_first = abs(label.box_px[0] - 268.0 - first[0]) < 1e-6
            assert board.is_restless and is_first == (len(lights) < 2)
            board.pass_time(0.03, is_soft=True)
            lights.append(round(light(), 6))
        assert lights == ([0.5, 0.0, 0.5, 1.0] if soft else [])
        assert not board.is_restless and light() == 1.0 and offset(268.0) != first
    moved = offset(268.0)
    assert offset(200.0) == moved and not board.is_restless
    assert offset(200.0, at_rest=True) == moved and board.is_restless, "a hand that lets go"
    for _ in range(4):
        board.pass_time(0.03, is_soft=True)
    assert offset(200.0) == first and light() == 1.0 and not board.is_restless
    assert offset(200.0, afresh=True) == first and light() == 1.0 and not board.is_restless
    assert offset(232.0) == offset(268.0) == first
    assert offset(268.0, at_rest=True) == first and board.is_restless
    assert offset(232.0) == offset(200.0) == first
    assert offset(200.0, at_rest=True) == first and not board.is_restless, "another rest, back"
    board.pass_time(1.0)
    assert offset(200.0, at_rest=True) == first and light() == 1.0
    assert offset(268.0) == first and offset(268.0, at_rest=True) != first, "a single change"
    assert not board.is_restless and light() == 1.0
    assert offset(200.0, afresh=True) == offset(232.0) == offset(268.0) == first
    assert offset(268.0, at_rest=True) == offset(290.0) == offset(308.0) == first
    assert offset(308.0, at_rest=True) == first and board.is_restless, "bound for elsewhere"
    for _ in range(4):
        board.pass_time(0.03, is_soft=True)
    there = offset(308.0)
    assert there != first and there == offset(308.0, afresh=True)


def test_lengths_that_were_never_wanted_are_no_ink(make_view: MakeView) -> None:
    """A label that fades may be placed anew after a fixed view has opened without labels."""
    drawing = make_view().drawing
    drawing.show_layers(frozenset({"labels"}))
    drawing.show_fixed("side")
    ground = Ground((0.0, 0.0, 600.0, 400.0), drawing.board.em)
    lengths = Dimensions(drawing.state)
    lengths.ink(ground)
    lengths.want(ground)
    lengths.ink(ground)


@pytest.mark.parametrize("distance", [1e17, 1e40, 1e150])
def test_there_is_no_way_from_where_rounding_puts_the_eye_on_the_focus(
    make_view: MakeView, distance: float
) -> None:
    drawing = make_view().drawing
    goal = drawing.own.pose
    drawing.begin_glide(goal._replace(focus=distance * np.array([1.0, 0.3, 0.1])))
    for part in (0.0, 0.5, 0.999, 1.0):
        drawing.glide(part)
        assert np.isfinite(drawing.own.pane.axes).all()
    assert drawing.own.pose.is_near(goal)
