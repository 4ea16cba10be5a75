"""The phenomena about rasterising: the pixels that reach the screen."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import pyvista as pv
from matplotlib.path import Path
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import vtkStringOutputWindow

from app.drawings import WORDS, rasterising
from app.drawings.image import ImageDrawing
from app.drawings.picture_frame import UNFRAMED
from app.drawings.rasterising import REFUSED, TOO_FINE, counted_wrong_share, subdivided
from app.drawings.stage import StageDrawing
from app.drawings.style import LIGHT, rgb
from app.drawings.world import WorldDrawing
from app.model.depth import FORMATS, DepthBuffer
from app.model.projection import (
    DEPTH_RANGES,
    Array,
    Camera,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.scenes.phenomena import depth_buffer, interpolation, popping
from app.scenes.phenomena.illustration import Illustration, Phenomenon
from app.scenes.phenomena.words import Reading
from app.scenes.scene import Scene, load
from tests.support.drawings import OffScreen, heard, rendered

Pixels = NDArray[np.uint8]
SIZE = (480, 270)
RAMP = np.array([(-5.0, 0, 4), (5, 0, 4), (5, 6, -44), (-5, 6, -44)])
PHENOMENA = {p.name: p for p in (m.PHENOMENON for m in (depth_buffer, interpolation, popping))}


class Picture:
    """An unframed image drawing off screen."""

    def __init__(self, name: str, scene: Scene | None = None) -> None:
        self.phenomenon = PHENOMENA[name]
        self.scene = scene or load(name)
        self.plotter = OffScreen(*SIZE)
        self.window = self.plotter.render_window
        self.window.SetMultiSamples(0)
        self.drawing = ImageDrawing(self.plotter, self.scene, WORDS, LIGHT, options=UNFRAMED)
        self.projection, self.illustration = self.phenomenon.start, Illustration(())

    def show(self, projection: Projection | None = None, **settings: Any) -> Picture:
        """Take these over; draws nothing."""
        self.projection = replace(projection or self.phenomenon.start, image_size=SIZE)
        checked = self.phenomenon.checked(settings)
        self.illustration = self.phenomenon.show(self.projection, checked, self.scene.subject)
        # Texts and dots would cover what is looked at here.
        bare = replace(
            self.illustration, image=replace(self.illustration.image, lines=(), dots=(), texts=())
        )
        self.drawing.show_projection(self.projection, bare)
        return self

    def pixels(self) -> Pixels:
        """Render once; (height, width, 3), the first row on top."""
        return rendered(self.window)

    @property
    def actors(self) -> list[Any]:
        """All actors of the picture."""
        return [actor for each in self.window.GetRenderers() for actor in each.GetActors()]


@pytest.fixture
def said() -> Iterator[vtkStringOutputWindow]:
    """VTK's messages: none, unless the test reads them."""
    with heard() as window:
        yield window
    assert window.GetOutput() == ""


@pytest.fixture
def make(said: vtkStringOutputWindow) -> Iterator[Any]:
    made: list[Picture] = []

    def one(name: str, scene: Scene | None = None) -> Picture:
        made.append(Picture(name, scene))
        return made[-1]

    yield one
    for picture in made:
        picture.drawing.remove()
        picture.plotter.close()


@pytest.fixture
def plotter(said: vtkStringOutputWindow) -> Iterator[Any]:
    made = OffScreen(*SIZE)
    made.render_window.SetMultiSamples(0)
    yield made
    made.close()


def looking(random: np.random.Generator, near: float, far: float) -> Projection:
    """A camera in front of the ramp or the board and above it."""
    eye = (random.uniform(-5, 5), random.uniform(3, 8), random.uniform(9, 15))
    target = (random.uniform(-2, 2), random.uniform(0, 2), random.uniform(-9, -1))
    lens = Perspective(random.uniform(35, 65), near, far)
    return Projection(Camera(eye, target, (0.0, 1.0, 0.0)), lens, SIZE)


# --------------------------------------------------------------------------- depth


RANGES = [
    name
    for name, _ in next(s.choices for s in depth_buffer.PHENOMENON.settings if s.name == "range")
]


def depth_settings(random: np.random.Generator) -> tuple[Projection, Mapping[str, Any]]:
    """Gaps of a tenth to twice what the buffer can tell apart at the target."""
    kind = str(random.choice(list(FORMATS)))
    near = 10.0 ** random.uniform(-3, 0) * (1e-4 if kind == "fixed32" else 1.0)
    projection = looking(random, near, 10.0 ** random.uniform(2, 4))
    if random.uniform() < 0.15:
        projection = projection.with_lens("orthographic")
    kinds = ("standard", "reversed") if projection.lens.parallel else RANGES
    settings = {"format": kind, "range": str(random.choice(kinds)), "gap": 1.0}
    buffer = depth_buffer.buffer_of(projection, settings)
    assert isinstance(buffer, DepthBuffer)
    step = min(float(buffer.gap(projection.camera.distance)), 2.0)
    settings["gap"] = min(max(step * 10.0 ** random.uniform(-1.0, 0.3), 1e-9), 2.5)
    return replace(projection, depth=str(random.choice(list(DEPTH_RANGES)))), settings  # type: ignore[arg-type]


def counted(
    plotter: Any, projection: Projection, settings: Mapping[str, Any]
) -> tuple[Reading, float]:
    """The predicted share of wrong pixels, and the counted one in percent."""
    scene = load("depth-buffer")
    reading = depth_buffer.PHENOMENON.show(projection, settings, scene.subject).readings[0]
    buffer = depth_buffer.buffer_of(projection, settings)
    assert isinstance(reading.value, float) and isinstance(buffer, DepthBuffer)
    behind = depth_buffer.moved_behind(projection, float(settings["gap"]))
    share = counted_wrong_share(plotter, scene, projection, buffer, behind)
    assert share is not None
    return reading, 100.0 * share


def test_the_predicted_share_of_wrong_pixels_is_the_counted_one(plotter: Any) -> None:
    """50 settings that float32 can draw, every format and range among them; within 5 points."""
    random = np.random.default_rng(50)
    subject, show = load("depth-buffer").subject, depth_buffer.PHENOMENON.show
    seen, between = set(), 0
    while len(seen) < 50:
        projection, settings = depth_settings(random)
        if show(projection, settings, subject).readings[0].note is not None:
            continue  # too fine, or not in the picture
        reading, share = counted(plotter, projection, settings)
        seen.add((len(seen), settings["format"], settings["range"]))
        between += 5.0 < reading.value < 95.0
        assert share == pytest.approx(reading.value, abs=5.0), (projection, settings)
    assert {name for _, name, _ in seen} == set(FORMATS)
    assert {name for _, _, name in seen} == set(RANGES)
    assert between >= 20, "shares of 0 and 1 prove little"


@pytest.mark.parametrize("kind", ["fixed8", "fixed16", "float16"])
@pytest.mark.parametrize("gap", [1e-9, 5e-6, 1e-4])
def test_a_gap_that_no_buffer_tells_is_counted_too(plotter: Any, kind: str, gap: float) -> None:
    """The count knows which surface is in front, although its own picture has 24 bits only."""
    settings = {"format": kind, "range": "standard", "gap": gap}
    reading, share = counted(plotter, load("depth-buffer").start, settings)
    assert reading.note is None and reading.value >= 99.0
    assert share == pytest.approx(reading.value, abs=1.0)


@pytest.mark.parametrize(
    ("kind", "near", "far", "stored", "gap"),
    [
        ("orthographic", 1.0, 5e3, "fixed8", 1e-4),
        ("orthographic", -5e3, 5e3, "fixed16", 1e-4),
        ("orthographic", -1e5, 1e3, "float16", 1e-4),
        ("orthographic", -1e7, 1e7, "fixed16", 0.1),
        ("oblique", 1.0, 1e6, "fixed16", 0.1),
        ("orthographic", -1e5, 1e4, "fixed8", 100.0),
        ("oblique", 1.0, 1e4, "fixed24", 1e-4),
        ("orthographic", 1.0, 2e4, "fixed24", 1e-4),
    ],
)
def test_what_a_parallel_lens_shows_is_counted_however_far_its_planes_are_apart(
    plotter: Any, kind: str, near: float, far: float, stored: str, gap: float
) -> None:
    """A float32 of all depths from near to far could not separate the ramp's two surfaces."""
    projection = load("depth-buffer").start.with_lens(kind)
    projection = replace(projection, lens=replace(projection.lens, near=near, far=far))
    settings = {"format": stored, "range": "reversed", "gap": gap}
    reading, share = counted(plotter, projection, settings)
    if stored == "fixed24":  # the codes are as fine as the float32 that they are made of
        assert reading.note is not None and share > 50.0
    else:
        assert reading.note is None
        assert share == pytest.approx(reading.value, abs=5.0)


def test_the_image_pane_shows_the_stripes_that_are_counted(plotter: Any, make: Any) -> None:
    picture = make("depth-buffer").show()
    pixels = picture.pixels().astype(int)
    fine = picture.show(format="fixed24").pixels().astype(int)
    (_, back), (front, _) = (
        ((each == rgb_).all(axis=-1) for rgb_ in ((230, 159, 0), (0, 114, 178)))
        for each in (pixels, fine)
    )
    behind = picture.illustration.copies[0].world_from_world[:3, 3]
    outline = picture.projection.trace(RAMP + behind).image
    rows, columns = np.nonzero(front)
    both = np.zeros_like(front)
    both[rows, columns] = Path(outline).contains_points(np.stack([columns, rows], axis=1) + 0.5)
    assert both.sum() > 0.3 * front.sum()
    share = back[both].mean()
    assert 100.0 * share == pytest.approx(picture.illustration.readings[0].value, abs=5.0)
    assert not back[~both & front].any(), "beside the hidden surface nothing is wrong"
    again = picture.show().pixels()
    assert (again == pixels).all(), "another format leaves nothing behind"
    assert picture.drawing.problem is None


def test_a_picture_is_the_same_whatever_was_shown_before(make: Any) -> None:
    """Copies use the phenomenon's depth buffer, even if they are created after a first picture."""
    fresh, used = make("depth-buffer"), make("depth-buffer")
    used.drawing.show_projection(replace(used.phenomenon.start, image_size=SIZE))
    assert (used.show().pixels() == fresh.show().pixels()).all()


def test_without_a_depth_buffer_that_lens_can_have_nothing_is_rounded(make: Any) -> None:
    picture = make("depth-buffer")
    start = picture.phenomenon.start
    endless = replace(start, lens=Perspective(45.0, 1.0, math.inf))
    plain = picture.show(endless, range="standard", format="fixed24").pixels()
    refused = picture.show(endless, range="logarithmic", format="fixed8").pixels()
    assert picture.illustration.warning is not None and picture.illustration.rendering is None
    assert (plain == refused).all()


# --------------------------------------------------------------------------- texture


def board_coordinates(
    picture: Picture, projection: Projection, parts: int, affine: bool
) -> tuple[Array, NDArray[np.bool_]]:
    """s and t of every pixel's centre, by barycentric weights on the screen; NaN beside it.

    The triangles are those of the mesh itself, each side cut in `parts`. Second: pixels whose
    triangle's border is too near to say which of two triangles has them.
    """
    surface = picture.scene.surface
    assert surface is not None
    mesh = subdivided(surface.triangulate(), parts)
    corners = np.asarray(mesh.points, dtype=float)[mesh.regular_faces]
    trace = projection.trace(corners)
    width, height = SIZE
    all_x, all_y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    found = np.full((height, width, 2), np.nan)
    unsure = np.zeros((height, width), bool)
    for place, image, w in zip(corners, trace.image, -trace.view[..., 2], strict=True):
        edges = np.stack([image[(i + 1) % 3] - image[i] for i in range(3)])
        area = edges[0, 0] * edges[1, 1] - edges[0, 1] * edges[1, 0]
        if abs(area) < 1e-9:
            continue
        low, high = np.clip(image.min(axis=0) - 2, 0, SIZE), np.clip(image.max(axis=0) + 2, 0, SIZE)
        box = slice(int(low[1]), int(high[1])), slice(int(low[0]), int(high[0]))
        x, y = all_x[box], all_y[box]
        away = [
            (edges[i, 0] * (y - image[i, 1]) - edges[i, 1] * (x - image[i, 0])) for i in range(3)
        ]
        b = np.stack([away[1], away[2], away[0]], axis=-1) / area
        distance = np.stack([d / np.hypot(*e) for d, e in zip(away, edges, strict=True)], axis=-1)
        unsure[box] |= (np.abs(distance).min(axis=-1) < 0.75) & (b > -0.2).all(axis=-1)
        inside = (b >= 0.0).all(axis=-1)
        weights = b if affine else b / w
        weights /= weights.sum(axis=-1, keepdims=True)
        st = (place[:, [0, 2]] + 5.0) / 10.0
        found[box][inside] = (weights @ st)[inside]
    return found, unsure


def test_coordinates_on_the_screen_are_those_of_the_formula(make: Any) -> None:
    """50 settings: red and green of each pixel are the barycentric weights, within 1.5 steps."""
    random = np.random.default_rng(18)
    picture = make("interpolation")
    compared = 0
    for number in range(50):
        projection = looking(random, 0.5, 100.0)
        parts, affine = int(random.choice([1, 2, 3, 8])), number % 3 != 0
        picture.show(
            projection,
            pattern="coordinates",
            subdivision=parts,
            interpolation="affine" if affine else "correct",
        )
        pixels = picture.pixels()
        expected, unsure = board_coordinates(picture, projection, parts, affine)
        sure = np.isfinite(expected).all(axis=-1) & ~unsure
        off = np.abs(pixels[sure][:, :2] - 255.0 * expected[sure])
        assert off.max() <= 1.5, (number, projection, parts, affine)
        compared += int(sure.sum())
    assert compared > 200_000


def test_the_largest_error_is_the_one_in_the_picture(make: Any) -> None:
    """50 settings: affine minus correct, pixel by pixel, reaches the formula and not more."""
    random = np.random.default_rng(81)
    picture = make("interpolation")
    reached = []
    while len(reached) < 50:
        # Wholly in the picture, so that the place of the largest error is.
        projection = looking(random, 0.5, 100.0)
        projection = replace(projection, lens=Perspective(75.0, 0.5, 100.0))
        parts = int(random.choice([1, 1, 2, 4]))
        if projection.trace(picture.scene.surface.points).outside.any():
            continue
        settings = {"pattern": "coordinates", "subdivision": parts}
        affine = picture.show(projection, **settings).pixels().astype(float)
        texels = picture.illustration.readings[0].value
        correct = picture.show(projection, interpolation="correct", **settings).pixels()
        board = (affine[..., 2] == 0) & (correct[..., 2] == 0)
        off = (affine - correct)[board][:, :2] / 255.0 * interpolation.TEXELS
        largest = float(np.hypot(off[:, 0], off[:, 1]).max())
        assert largest <= texels + 1.5, (projection, parts)
        reached.append(largest / texels if texels > 20.0 else 1.0)
    assert np.mean(reached) > 0.95 and min(reached) > 0.85


@pytest.mark.parametrize("kind", [WorldDrawing, StageDrawing])
def test_the_other_panes_show_the_texture_as_it_is(said: Any, kind: Any) -> None:
    plotter = OffScreen(*SIZE)
    plotter.render_window.SetMultiSamples(0)
    scene = load("interpolation")
    drawing = kind(plotter, scene, WORDS, LIGHT)
    drawing.show_projection(scene.start)
    shown = []
    for choice in (None, "affine", "correct"):
        if choice is not None:
            settings = interpolation.PHENOMENON.checked({"interpolation": choice})
            illustration = interpolation.PHENOMENON.show(scene.start, settings, scene.subject)
            drawing.show_projection(scene.start, Illustration((), rendering=illustration.rendering))
        shown.append(rendered(plotter.render_window).astype(int))
    plain, affine, correct = shown
    darker = (plain - affine).max(axis=-1) > 60
    assert darker.mean() > 0.003, "there are checks"
    assert (affine == correct).all()
    drawing.remove()
    plotter.close()


def test_subdivided_triangles_are_the_same_surface() -> None:
    points = np.array([(0.1, 0, 0), (3.3, 0.2, 1), (0, 2.7, 0.1), (4.1, 3.9, -0.7)])
    mesh = pv.PolyData.from_regular_faces(points, np.array([[0, 1, 2], [2, 1, 3]]))
    mesh.point_data["rgb"] = np.array([[0, 0, 0]] * 2 + [[200, 0, 0], [0, 200, 0]], np.uint8)
    for parts in (1, 2, 7, 64):
        cut = subdivided(mesh, parts)
        assert cut.n_cells == 2 * parts**2
        assert pv.wrap(cut).area == pytest.approx(mesh.area, rel=1e-5)
        colours, counts = np.unique(
            cut.point_data["rgb"][cut.regular_faces[:, 2]], axis=0, return_counts=True
        )
        assert colours.tolist() == [[0, 200, 0], [200, 0, 0]] and counts.tolist() == [parts**2] * 2
        distinct = np.unique(np.asarray(cut.points), axis=0)
        assert len(distinct) == (parts + 1) ** 2, "neighbours share what is on their common side"


def test_too_many_triangles_are_named(make: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rasterising, "MOST_TRIANGLES", 50)
    picture = make("interpolation").show(subdivision=6)
    assert picture.drawing.problem.template == TOO_FINE
    assert picture.drawing.problem.values == ("2", "6", "5")
    drawn = picture.pixels()
    assert (drawn == picture.show(subdivision=5).pixels()).all()
    assert picture.drawing.problem is None


# --------------------------------------------------------------------------- fog and levels


def without_trees(picture: Picture) -> None:
    """Draw the scene's own faces instead of levels of detail."""
    rendering = replace(picture.illustration.rendering, levels=())
    picture.drawing.show_projection(picture.projection, Illustration((), rendering=rendering))


@pytest.mark.parametrize("kind", ["perspective", "orthographic"])
@pytest.mark.parametrize("fog", ["linear", "exponential"])
def test_fog_leaves_the_contrast_of_its_formula(make: Any, fog: str, kind: str) -> None:
    """A wall that faces the camera, at 20 distances."""
    scene = load("far-plane-popping")
    wall = pv.PolyData(
        np.array([(-90.0, -90, 0), (90, -90, 0), (90, 90, 0), (-90, 90, 0)]), faces=[4, 0, 1, 2, 3]
    )
    wall.cell_data["rgb"] = np.array([[90, 90, 90]], dtype=np.uint8)
    picture = make("far-plane-popping", replace(scene, surface=wall, lines=None))
    background = 255.0 * np.array(rgb(LIGHT.background))
    for w in np.linspace(2.0, 95.0, 20):
        at = Projection(Camera((0.0, 0.0, w), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)))
        at = replace(at, lens=Perspective(40.0, 1.0, 100.0)).with_lens(kind)
        picture.show(at, fog=fog, fog_start=10.0, fog_end=80.0, fog_density=0.03)
        without_trees(picture)
        pixel = picture.pixels()[SIZE[1] // 2, SIZE[0] // 2]
        part = math.exp(-0.03 * w) if fog == "exponential" else min(1.0, max(0.0, (80 - w) / 70))
        assert pixel == pytest.approx(background * (1.0 - part) + 90.0 * part, abs=1.0), w
    if kind == "orthographic":  # whose near plane may lie behind the eye, where fog has not begun
        behind = replace(at, camera=Camera((0.0, 0.0, -50.0), (0.0, 0.0, -90.0)))
        behind = replace(behind, lens=replace(behind.lens, near=-100.0))
        picture.show(behind, fog=fog, fog_start=10.0, fog_end=80.0, fog_density=0.03)
        without_trees(picture)
        assert picture.pixels()[SIZE[1] // 2, SIZE[0] // 2] == pytest.approx(90.0, abs=1.0)


def tree_scene(level: int) -> Scene:
    """All trees at one level of detail, as an ordinary scene without requirements."""
    scene = load("far-plane-popping")
    trees = popping.PHENOMENON
    shown = trees.show(scene.start, trees.checked({}), scene.subject)
    quads, rgb_ = shown.rendering.levels[level].faces  # type: ignore[union-attr]
    points = quads.reshape(-1, 3)
    first = 4 * np.arange(len(quads))[:, None]
    mesh = pv.PolyData.from_regular_faces(points, first + np.arange(4))
    mesh.cell_data["rgb"] = rgb_
    return replace(scene, surface=mesh, phenomenon=None, requires=frozenset())


@pytest.mark.parametrize(
    ("settings", "level"),
    [
        ({"detail": False}, 0),
        ({"detail": True, "detail_1": 900.0, "detail_2": 901.0}, 0),
        ({"detail": True, "detail_1": 0.0, "detail_2": 900.0}, 1),
        ({"detail": True, "detail_1": 0.0, "detail_2": 0.001}, 2),
    ],
)
def test_each_level_is_drawn_where_it_is_due(
    make: Any, plotter: Any, settings: Mapping[str, Any], level: int
) -> None:
    picture = make("far-plane-popping").show(**settings)
    plain = ImageDrawing(plotter, tree_scene(level), WORDS, LIGHT, options=UNFRAMED)
    plain.show_projection(replace(picture.phenomenon.start, image_size=SIZE))
    expected = rendered(plotter.render_window)
    drawn = picture.pixels()
    trees = (drawn[..., 1] > 1.3 * drawn[..., 0]).sum()
    assert trees > 5000
    assert (drawn != expected).any(axis=-1).mean() < 2e-3
    plain.remove()


def test_a_tree_changes_its_level_at_the_distance_set(make: Any) -> None:
    """The nearest trees are 10 away: a thousandth of that to either side of the limit."""
    picture = make("far-plane-popping")
    n = picture.phenomenon.start.camera.frame[2]
    w = float(n @ (np.array(picture.phenomenon.start.camera.eye) - popping.places()[0]))
    simple = picture.show(detail=True, detail_1=w * 0.999, detail_2=900.0).pixels()
    full = picture.show(detail=True, detail_1=w * 1.001, detail_2=900.0).pixels()
    same = picture.show(detail=True, detail_1=w * 1.002, detail_2=900.0).pixels()
    left = slice(0, SIZE[0] // 4)  # where the nearest tree of the left row is
    assert (simple != full)[:, left].any(axis=-1).mean() > 0.01
    assert (same == full).all()


# --------------------------------------------------------------------------- what a step costs


@pytest.mark.parametrize(
    ("name", "one", "other"),
    [
        ("depth-buffer", {}, {"format": "float16", "range": "logarithmic", "gap": 0.01}),
        ("interpolation", {}, {"interpolation": "correct", "subdivision": 8, "pattern": "checks"}),
        ("far-plane-popping", {}, {"fog": "linear", "detail": True, "detail_1": 12.0}),
    ],
)
def test_a_step_builds_no_shader_and_adds_no_actor(
    make: Any, name: str, one: Mapping[str, Any], other: Mapping[str, Any]
) -> None:
    picture = make(name).show(**one)
    first = picture.pixels()
    actors = picture.actors

    def built() -> list[tuple[int, ...]]:
        shaders = [actor.GetShaderProperty() for actor in actors]
        return [
            (
                shader.GetShaderMTime(),
                shader.GetFragmentCustomUniforms().GetUniformListMTime(),
                shader.GetVertexCustomUniforms().GetUniformListMTime(),
            )
            for shader in shaders
        ]

    before = built()
    second = picture.show(**other).pixels()
    assert (first != second).any()
    assert picture.actors == actors and built() == before
    assert (picture.show(**one).pixels() == first).all()


# --------------------------------------------------------------------------- refused


@pytest.mark.parametrize(
    ("name", "part"),
    [
        ("depth-buffer", "_DEPTH"),
        ("interpolation", "_CHECKS"),
        ("far-plane-popping", "_FOG"),
        ("far-plane-popping", "_LEVEL"),
    ],
)
def test_an_opengl_that_refuses_the_shader_is_named(
    make: Any, monkeypatch: pytest.MonkeyPatch, name: str, part: str
) -> None:
    """The first rendering finds out; the next one draws the ordinary picture."""
    monkeypatch.setattr(rasterising, part, "this is no GLSL;")
    picture = make(name).show()
    assert picture.drawing.problem is None
    with heard() as said:
        picture.pixels()
    assert "this is no GLSL" in said.GetOutput()
    assert picture.drawing.problem.template == REFUSED
    refused = picture.show().pixels()
    ordinary = make(name, replace(picture.scene, phenomenon=None, requires=frozenset()))
    ordinary.drawing.show_projection(replace(picture.phenomenon.start, image_size=SIZE))
    plain = ordinary.pixels()
    scene_rgb = np.unique(picture.scene.surface.cell_data["rgb"], axis=0)
    shown = [(picture_ == scene_rgb[0]).all(axis=-1) for picture_ in (plain, refused)]
    assert shown[0].sum() > 100 and (shown[0] == shown[1]).mean() > 0.99


def test_a_refusal_leaves_the_count_out(plotter: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rasterising, "_DEPTH", "this is no GLSL;")
    scene = load("depth-buffer")
    behind = depth_buffer.moved_behind(scene.start, 0.1)

    with heard() as said:
        counted = counted_wrong_share(plotter, scene, scene.start, DepthBuffer(), behind)
    assert "this is no GLSL" in said.GetOutput()
    assert counted is None


# --------------------------------------------------------------------------- any camera


LENSES: list[Lens] = [
    Perspective(45.0, 1e-205, 1e100),
    Perspective(1e-6, 1.0, math.inf),
    Perspective(179.99, 1e-3, math.inf),
    Perspective(60.0, 50.0, 50.000001),
    Orthographic(-1e50, 1e50, -1e50, 1e50, -1e100, 1e100),
    Orthographic(-1e-3, 1e-3, -1e-3, 1e-3, -1.0, 1.0),
    Oblique(-8.0, 8.0, -5.0, 5.0, 0.0, 60.0, "stretch", 45.0, 60.0),
]
CAMERAS = [
    Camera((3.0, 6.0, 13.0), (0.0, 2.0, -10.0), (0.0, 1.0, 0.0)),
    Camera((0.0, 0.0, 0.0), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0)),
    Camera((0.0, -3.0, 4.0), (0.0, 5.0, 4.0), (0.0, 0.0, 1.0)),
    Camera((1e100, 0.0, 1.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    Camera((5.0, 0.0, 5.0), (5.0, 1e-9, 5.0), (1.0, 0.0, 0.0)),
    Camera((0.0, 3.0, -60.0), (0.0, 0.0, -120.0), (0.0, 1.0, 0.0)),
]


@pytest.mark.parametrize("phenomenon", PHENOMENA.values(), ids=PHENOMENA)
def test_extreme_cameras_and_lenses_are_drawn_without_a_word(
    phenomenon: Phenomenon, make: Any
) -> None:
    """VTK says nothing; `tests/scenes` looks at the numbers."""
    picture = make(phenomenon.name)
    for number, (camera, lens) in enumerate(itertools.product(CAMERAS, LENSES)):
        depth = list(DEPTH_RANGES)[number % 3]
        chosen = {
            setting.name: setting.choices[number % len(setting.choices)][0]
            for setting in phenomenon.settings
            if setting.choices
        }
        picture.show(Projection(camera, lens, SIZE, depth), **chosen)
        picture.window.Render()
