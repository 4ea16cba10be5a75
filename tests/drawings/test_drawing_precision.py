"""Pictures at the extremes, where float32 cannot draw them, against 80 digits pixel by pixel."""

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista as pv
from numpy.typing import NDArray

from app.drawings import WORDS
from app.drawings import precision as precisions
from app.drawings.image import ImageDrawing
from app.drawings.picture_frame import UNFRAMED
from app.drawings.stage import StageDrawing
from app.drawings.style import LIGHT
from app.model.projection import (
    DEPTH_RANGES,
    Camera,
    Frustum,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.precision.levels import DRAWING_TOLERANCE_PX
from app.scenes.scene import Scene, load
from app.scenes.shapes import EDGE_RGB
from tests.oracles.exact import dot as exact_dot
from tests.oracles.exact import frame, minus, mp, vector
from tests.support.bounds import drawing_bound_px
from tests.support.drawings import MakeScreen, OffScreen, drawn, scene_of, to_bytes
from tests.support.lenses import at_distance

Mask = NDArray[np.bool_]
SIZE = (640, 360)
RED = (200, 30, 30)


def triangle_at(
    projection: Projection,
    corners: Sequence[tuple[float, float, float]],
    origin: Any,
    kind: Any = np.float32,
) -> NDArray[np.floating]:
    """Scene-local vertices that are seen at (x_ndc, y_ndc) from a distance, rounded to `kind`."""
    camera, points = projection.camera, []
    for x_ndc, y_ndc, distance in corners:
        parts = (x_ndc + 1.0) / 2.0, (y_ndc + 1.0) / 2.0
        offset = np.array(at_distance(projection, distance, *parts)) @ camera.frame
        points.append((np.array(camera.eye) - origin) + offset)
    return np.array(points).astype(kind)


def expected(
    projection: Projection, points: Any, size: tuple[int, int], band_px: float
) -> tuple[Mask, Mask]:
    """Pixels that a convex polygon must light and must not light, at 80 digits.

    Pixels whose centres are within the band round the outline are in neither.
    """
    camera, lens = projection.camera, projection.lens
    rows = frame(camera.eye, camera.target, camera.up)
    corners = []
    for point in points:
        offset = minus(vector(point), vector(camera.eye))
        x, y, z = (exact_dot(row, offset) for row in rows)
        corners.append([x, y, -z])
    limits = [(1, mp.mpf(lens.near))]
    if lens.far != math.inf:
        limits.append((-1, -mp.mpf(lens.far)))
    for sign, limit in limits:
        inside = [sign * corner[2] - limit for corner in corners]
        left = []
        for i, (corner, value) in enumerate(zip(corners, inside, strict=True)):
            before, value_before = corners[i - 1], inside[i - 1]
            if (value >= 0) != (value_before >= 0):
                t = value_before / (value_before - value)
                left.append([b + t * (c - b) for b, c in zip(before, corner, strict=True)])
            if value >= 0:
                left.append(corner)
        corners = left
    width, height = size
    columns, lines = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    if len(corners) < 3:
        nowhere = np.zeros(columns.shape, dtype=bool)
        return nowhere, ~nowhere
    window_left, right, bottom, top = map(mp.mpf, projection.window)
    image = []
    for x, y, distance in corners:
        if lens.parallel:
            x += mp.mpf(projection.lens.shear[0]) * (mp.mpf(lens.near) - distance)
            y += mp.mpf(projection.lens.shear[1]) * (mp.mpf(lens.near) - distance)
        else:
            x, y = (part * mp.mpf(lens.near) / distance for part in (x, y))
        image.append(
            (width * (x - window_left) / (right - window_left), height * (top - y) / (top - bottom))
        )
    middle = [sum(part) / len(image) for part in zip(*image, strict=True)]
    nearest = np.full(columns.shape, np.inf)
    for i, (x, y) in enumerate(image):
        x_before, y_before = image[i - 1]
        a, b = y - y_before, x_before - x
        length = mp.sqrt(a * a + b * b)
        if length == 0:
            continue
        c = -(a * x + b * y)
        sign = 1 if a * middle[0] + b * middle[1] + c > 0 else -1
        a, b, c = (float(sign * part / length) for part in (a, b, c))
        nearest = np.minimum(nearest, a * columns + b * lines + c)
    return nearest > band_px, nearest < -band_px


def scene_at(points: Any, origin: Any, colours: Any = (RED,)) -> Scene:
    """A scene with one triangle for every three points."""
    faces = np.arange(len(points)).reshape(-1, 3).tolist()
    scene = scene_of(points, faces, colours, tuple(origin))
    assert scene.surface is not None
    assert (scene.surface.points.astype(np.float32) == scene.surface.points).all()
    return scene


def mistakes(
    screen: OffScreen, projection: Projection, points: Any, origin: Any, **options: float
) -> tuple[str, int, int]:
    """Draw a triangle: the precision used, wrong pixels, and pixels that must be lit."""
    tolerance_px = options.get("tolerance_px", 0.0)
    scene = scene_at(points, origin)
    drawing = ImageDrawing(screen, scene, WORDS, LIGHT, tolerance_px, options=UNFRAMED)
    drawing.show_projection(projection)
    lit = drawn(screen.pixels(), RED)
    drawing.remove()
    world = points.astype(float) + np.array(origin, dtype=float)
    band_px = options.get("band_px", 0.02)
    must, must_not = expected(projection, world, projection.image_size, band_px)
    wrong = int((must & ~lit).sum() + (must_not & lit).sum())
    return drawing.precision, wrong, int(must.sum())


FAR_AWAY = (1e7, -2e7, 3e7)
INSIDE = ((-0.7, -0.6), (0.8, -0.3), (0.1, 0.8))
ACROSS = ((-40.0, -31.0), (60.0, 40.3), (-0.8, 0.7))  # two corners 15 pictures away and more


def camera_from(eye: Any, direction: Any) -> Camera:
    eye = np.array(eye, dtype=float)
    return Camera(tuple(eye), tuple(eye + direction))


LETTER_EYE, LETTER = (6, 5, 9), Camera((6, 5, 9), (0, 2.2, 0))
EXTREMES: dict[str, tuple[Projection, Any, tuple[float, float, float]]] = {
    name: (Projection(camera, lens, SIZE), origin, distances)
    for name, camera, lens, origin, distances in (
        (
            "eye near a vertex",
            camera_from(LETTER_EYE, (-6, -3, -9)),
            Perspective(60, 1e-6, 100),
            (0, 0, 0),
            (1e-5, 10.0, 4e-6),
        ),
        (
            "eye near a vertex, far from the origin",
            camera_from(np.add(FAR_AWAY, LETTER_EYE), (-6, -3, -9)),
            Perspective(60, 1e-6, 100),
            FAR_AWAY,
            (1e-5, 10.0, 4e-6),
        ),
        ("narrow", LETTER, Perspective(1e-4, 1, 30), (3, -1, 2), (11.0, 12.0, 11.5)),
        (
            "wide",
            Camera((0.3, 0.4, 9), (0, 0.2, 0)),
            Perspective(179.9, 1e-6, 30),
            (0, 0, 0),
            (1e-5, 2e-5, 2e-5),
        ),
        (
            "off axis",
            LETTER,
            Frustum(0.5, 0.500002, -0.3, -0.299999, 1, 30),
            (3, -1, 2),
            (11.0, 12.0, 11.5),
        ),
        (
            "parallel, eye far away",
            Camera((1e7, 2e7, 3e7), (0, 2.2, 0)),
            Orthographic(-4e-5, 4e-5, -3e-5, 3e-5, 1, 1e8),
            (3, -1, 2),
            (37416573.0, 37416574.0, 37416573.0),
        ),
        (
            "oblique, small window",
            LETTER,
            Oblique(-4e-6, 4e-6, -4e-6, 4e-6, 1, 30, alpha_deg=50, beta_deg=70),
            (3, -1, 2),
            (11.0, 12.0, 11.5),
        ),
    )
}


@pytest.mark.parametrize("name", ["narrow", "off axis", "oblique, small window"])
def test_the_picture_has_the_digits_of_the_file(
    name: str, tmp_path: Path, off_screen: MakeScreen
) -> None:
    """Float32 would move these vertices by many pixels: the mesh is a million pictures large."""
    projection, _, distances = EXTREMES[name]
    places = [(*corner, d) for corner, d in zip(INSIDE, distances, strict=True)]
    points = triangle_at(projection, places, (0, 0, 0), np.float64) + 1e-9
    large = np.array([(-9, 2, -9), (9, 2, -9), (0, 3, -9)])
    mesh = tmp_path / "mesh.obj"
    lines = [f"v {x!r} {y!r} {z!r}\n" for x, y, z in np.concatenate([points, large]).tolist()]
    mesh.write_text("".join([*lines, "f 1 2 3\nf 4 5 6\n"]), encoding="utf-8")
    scene = load(str(mesh))
    assert scene.surface is not None
    screen = off_screen(*SIZE)
    drawing = ImageDrawing(screen, scene, WORDS, LIGHT, DRAWING_TOLERANCE_PX, options=UNFRAMED)
    drawing.show_projection(projection)
    assert drawing.precision == "float64"
    lit = drawn(screen.pixels(), scene.surface.cell_data["rgb"][0])
    of_edges = drawn(screen.pixels(), EDGE_RGB)
    must, must_not = expected(projection, points, SIZE, 0.02)
    assert must.sum() > 2000 and must_not.sum() > 2000
    assert int((must & ~lit & ~of_edges).sum() + (must_not & lit).sum()) == 0


@pytest.mark.parametrize("corners", [INSIDE, ACROSS], ids=["inside", "across"])
@pytest.mark.parametrize("name", EXTREMES)
def test_the_picture_is_right_where_float32_is_not(
    name: str, corners: Any, off_screen: MakeScreen
) -> None:
    projection, origin, distances = EXTREMES[name]
    places = [(*corner, d) for corner, d in zip(corners, distances, strict=True)]
    points = triangle_at(projection, places, origin)
    screen, wrong = off_screen(*SIZE), {}
    for tolerance_px, band_px in ((math.inf, 1.0), (DRAWING_TOLERANCE_PX, 0.02)):
        precision, wrong[precision], lit = mistakes(
            screen, projection, points, origin, tolerance_px=tolerance_px, band_px=band_px
        )
        assert 2000 < lit < SIZE[0] * SIZE[1] - 2000
    assert wrong["float64"] == 0
    assert wrong["float32"] > 20, "not an extreme"


def test_the_cube_is_right_where_float32_is_not(off_screen: MakeScreen) -> None:
    """Looked at from the front, the NDC pane shows the picture, stretched to a square."""
    size = (400, 400)
    names = "eye near a vertex", "narrow", "wide", "off axis", "oblique, small window"
    for number, name in enumerate(names):
        for depth in [*DEPTH_RANGES][number % 2 :: 2]:
            projection, origin, distances = EXTREMES[name]
            projection = replace(projection, depth=depth)  # type: ignore[arg-type]
            places = [(*corner, d) for corner, d in zip(INSIDE, distances, strict=True)]
            points = triangle_at(projection, places, origin)
            world = points.astype(float) + np.array(origin, dtype=float)
            wrong = {}
            for tolerance_px in (math.inf, DRAWING_TOLERANCE_PX):
                screen = off_screen(*size)
                scene = scene_at(points, origin)
                drawing = StageDrawing(screen, scene, WORDS, LIGHT, tolerance_px)
                drawing.show_projection(projection)
                camera = screen.renderer.GetActiveCamera()
                camera.SetFocalPoint(0.0, 0.0, 0.0)
                camera.SetPosition(0.0, 0.0, 10.0)
                camera.SetParallelScale(1.0)
                drawing.reset_clipping_range()
                lit = drawn(screen.pixels(), RED)
                must, must_not = expected(projection, world, size, 0.5)
                # The axes of the cube lie before it here and there.
                wrong[drawing.precision] = (must & ~lit).sum() / must.sum() + (must_not & lit).sum()
            assert wrong["float64"] < 0.025, (name, depth)
            assert wrong["float32"] > 5, (name, depth)


# --------------------------------------------------------------------------- cutting


def random_triangle(random: np.random.Generator, number: int) -> tuple[Projection, Any]:
    """A camera inside the box of a triangle's corners, which is often partly behind the eye."""
    near = 10.0 ** random.uniform(-6, 0)
    if number % 6 == 5:  # hardly any depth
        near, far = 2.0, 2.0 * (1.0 + 10.0 ** random.uniform(-7, -3))
    else:
        far = math.inf if number % 2 else near * 10.0 ** random.uniform(0.3, 8)
    x, y = random.uniform(0.2, 3.0, 2)
    camera = Camera(*(tuple(random.normal(size=3)) for _ in range(3)))
    lens: Any
    kind = number % 4
    if kind == 0:
        lens = Perspective(random.uniform(1.0, 179.0), near, far)
    elif kind == 1:
        lens = Frustum(-0.3 * near * x, near * x, -near * y, 0.4 * near * y, near, far)
    else:
        box = (-x, 1.3 * x, -y, 0.7 * y, random.uniform(-5.0, 0.0), random.uniform(0.1, 5.0))
        lens = Orthographic(*box) if kind == 2 else Oblique(*box, "stretch", 70.0, 50.0)
    points = random.normal(size=(3, 3)) * 10.0 ** random.uniform(-1, 2, size=(3, 1))
    return Projection(camera, lens, (160, 120)), points.astype(np.float32).astype(float)


def test_triangles_are_cut_where_the_model_says(off_screen: MakeScreen) -> None:
    """Every lens, across the eye plane, near, far and the sides in any combination."""
    random = np.random.default_rng(7)
    seen, behind = 0, 0
    screen = off_screen(160, 120)
    for number in range(160):
        projection, points = random_triangle(random, number)
        precision, wrong, lit = mistakes(screen, projection, points, (0, 0, 0))
        assert precision == "float64" or not lit  # what is not seen costs nothing
        assert wrong == 0, (number, projection, points)
        seen += bool(lit)
        behind += bool(lit and (projection.trace(points).clip[:, 3] < 0.0).any())
    assert seen > 40 and behind > 6, (seen, behind)


@pytest.mark.parametrize("thickness", [1e-5, 3e-6])
def test_a_thin_slab_is_cut_where_the_model_says(thickness: float, off_screen: MakeScreen) -> None:
    """Near and far hardly differ: their planes cross the picture, a third of it apart."""
    near = 12.0
    projection = Projection(
        Camera((6, 5, 9), (0, 2.2, 0)), Perspective(45, near, near + thickness), SIZE
    )
    places = [(x, y, near + (0.5 + x) * thickness) for x, y in INSIDE]
    origin = np.array(projection.camera.eye) - near * projection.camera.frame[2]
    origin = origin.astype(np.float32).astype(float)
    points = triangle_at(projection, places, origin)
    screen, wrong = off_screen(*SIZE), {}
    for tolerance_px in (math.inf, 0.0):
        precision, wrong[precision], lit = mistakes(
            screen, projection, points, origin, tolerance_px=tolerance_px
        )
        assert 2000 < lit < SIZE[0] * SIZE[1] - 2000
    assert wrong["float64"] == 0
    assert wrong["float32"] > 20


def test_lines_are_cut_where_the_model_says(off_screen: MakeScreen) -> None:
    """One line passes close to the eye, one is 1e6 pictures long across it."""
    random = np.random.default_rng(3)
    screen = off_screen(200, 150)
    cases = [
        (Perspective(60, 1e-4, 100.0), (0.001, -0.0005), 20.0),
        (Perspective(1e-4, 1, 30), (1e-7, 2e-7), 0.0),
        (Orthographic(-1e-6, 1e-6, -1e-6, 1e-6, -30, 30), (2e-7, 1e-7), 5.0),
    ]
    for lens, (x, y), behind in cases:
        camera = Camera((0.3, 0.2, 0.1), tuple(random.normal(size=3)))
        projection = Projection(camera, lens, (200, 150))
        ends_view = np.array([(x + 0.5, y - 0.4, behind), (x - 0.5, y + 0.4, -20.0)])
        if behind == 20.0:  # beside the eye, and straight away from it
            ends_view[:, :2] = x, y
        ends = (ends_view @ camera.frame + camera.eye).astype(np.float32).astype(float)
        lines = pv.PolyData(ends, lines=[2, 0, 1])
        lines.cell_data["rgb"] = np.array([RED], dtype=np.uint8)
        scene = replace(load("cube"), surface=None, lines=lines)
        drawing = ImageDrawing(screen, scene, WORDS, LIGHT, options=UNFRAMED)
        drawing.show_projection(projection)
        assert drawing.precision == "float64"
        lit = drawn(screen.pixels(), RED)
        drawing.remove()
        # A ribbon of 4 pixels about the line, made in view space from where it is seen.
        part = np.sort(np.concatenate([np.linspace(0, 1, 20001), 0.5 + np.logspace(-9, -1, 4000)]))
        along = ends[0] + part[:, None] * (ends[1] - ends[0])
        trace = projection.trace(along)
        shown = trace.image[~trace.outside.any(axis=1)]
        assert len(shown) > 5
        rows, columns = np.nonzero(lit)
        assert len(rows) > 20
        for px in shown:
            assert np.hypot(columns + 0.5 - px[0], rows + 0.5 - px[1]).min() < 1.2, (lens, px)
        start, end = shown[0], shown[-1]
        way = (end - start) / np.hypot(*(end - start))
        aside = (columns + 0.5 - start[0]) * way[1] - (rows + 0.5 - start[1]) * way[0]
        assert np.abs(aside).max() < 1.5, lens


def test_what_is_before_far_is_drawn_however_near_the_near_plane(off_screen: MakeScreen) -> None:
    """Float32 rounds all these depths to far's own; without care 6 of the 150 would vanish."""
    random = np.random.default_rng(5)
    screen = off_screen(120, 90)
    for number in range(150):
        near = 10.0 ** random.uniform(-9, -2)
        far = math.inf if number % 4 == 0 else random.uniform(1.0, 50.0)
        reach = min(far, 50.0)
        distances = reach * (1.0 - 10.0 ** random.uniform(-6, -0.3, 3))
        camera = Camera((0, 0, 0), (0.1, 0.2, -1))
        projection = Projection(camera, Perspective(60, near, far), (120, 90))
        places = [(*corner, d) for corner, d in zip(INSIDE, distances, strict=True)]
        points = triangle_at(projection, places, (0, 0, 0))
        _, wrong, lit = mistakes(screen, projection, points, (0, 0, 0))
        assert lit and not wrong, projection


@pytest.mark.parametrize("extent_over_near", [1e7, 1e10, 1e14])
def test_what_is_near_is_drawn_however_large_the_scene(
    extent_over_near: float, off_screen: MakeScreen
) -> None:
    """VTK's own shift and scale would drop it from 1e7 on."""
    near = 20.0 / extent_over_near
    projection = Projection(
        Camera((0, 0, 0), (0.3, -0.2, -1)), Perspective(70, near, math.inf), SIZE
    )
    places = [
        (*corner, d) for corner, d in zip(INSIDE, (3.0 * near, 20.0, 1.5 * near), strict=True)
    ]
    points = triangle_at(projection, places, (0, 0, 0))
    _, wrong, lit = mistakes(off_screen(*SIZE), projection, points, (0, 0, 0))
    assert lit > 2000 and wrong == 0


# --------------------------------------------------------------------------- both precisions


def everyday() -> list[tuple[str, Projection]]:
    """Cameras as lectures use them, which float32 draws."""
    letter = load("letter-f").start
    return [
        ("letter-f", replace(letter, lens=Perspective(60, 2, 30))),
        ("letter-f", replace(letter, lens=Frustum(-0.8, 0.7, -0.5, 0.5, 1, 30))),
        ("letter-f", replace(letter, lens=Orthographic(-5, 5, -3, 3, 1, 30))),
        ("letter-f", replace(letter, lens=Oblique(-6, 4, -3, 3, 1, 30))),
        ("cube", load("cube").start),
        ("cube", replace(load("cube").start, depth="reversed")),
        ("letter-f", replace(letter, lens=Perspective(45, 0.1, 30))),
        # The eye stands among what crosses its plane, and over a ground that does.
        *((name, load(name).start) for name in ("eye-plane", "focus", "posts")),
        # And between two bars of the letter, within the box round all of it.
        ("eye-plane", replace(load("eye-plane").start, camera=Camera((1, 2.4, 0.3), (0, 2.4, 0)))),
    ]


@pytest.mark.parametrize("kind", [ImageDrawing, StageDrawing])
def test_an_everyday_step_does_nothing_per_vertex(
    kind: Any, off_screen: MakeScreen, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[str] = []
    trace = Projection.trace

    def traced(*args: Any) -> Any:
        calls.append("trace")
        return trace(*args)

    monkeypatch.setattr(Projection, "trace", traced)
    screen = off_screen(200, 150)
    for name, projection in everyday():
        screen.clear()
        scene = load(name)
        drawing = kind(screen, scene, WORDS, LIGHT)
        for step in range(5):
            eye = tuple(part + 0.01 * step for part in projection.camera.eye)
            camera = replace(projection.camera, eye=eye)
            drawing.show_projection(replace(projection, camera=camera))
            assert drawing.precision == "float32"
    assert calls == []
    drawing.show_projection(replace(projection, lens=Perspective(1e-3, 1, 30)))
    assert drawing.precision == "float64"
    assert calls == ["trace"] * 2  # faces and lines


@pytest.mark.parametrize("kind", [ImageDrawing, StageDrawing])
def test_both_precisions_draw_the_same_everyday_picture(kind: Any, off_screen: MakeScreen) -> None:
    """Some cameras are inside the scene, where faces, grid and colours are cut."""
    letter = load("letter-f").start
    inside = Camera((1.2, 1.5, 2.5), (0.0, 2.0, 0.0))
    within = [
        ("letter-f", replace(letter, camera=inside, lens=Perspective(100, 0.05, 40))),
        ("letter-f", replace(letter, camera=inside, lens=Perspective(30, 2.2, 3.0))),
        ("posts", replace(load("posts").start, lens=Perspective(20, 1, math.inf))),
    ]
    screen = off_screen(500, 400)
    for name, projection in [*everyday(), *within]:
        scene, pictures, used = load(name), [], []
        for tolerance_px in (math.inf, 1e-4):
            screen.clear()
            drawing = kind(screen, scene, WORDS, LIGHT, tolerance_px)
            drawing.show_projection(projection)
            pictures.append(screen.pixels())
            used.append(drawing.precision)
        assert used == ["float32", "float64"]
        empty = np.array(to_bytes(LIGHT.background))
        assert (pictures[0] != empty).any(axis=-1).sum() > 5000
        assert (pictures[0] != pictures[1]).any(axis=-1).sum() <= 125, (name, projection)


def meshes(screen: OffScreen) -> dict[Any, Any]:
    """The mesh that each actor of a drawing shows."""
    actors = (actor for each in screen.window.GetRenderers() for actor in each.GetActors())
    return {actor: actor.GetMapper().GetInput() for actor in actors}


@pytest.mark.parametrize("kind", [ImageDrawing, StageDrawing])
def test_there_and_back_is_the_picture_of_a_fresh_drawing(
    kind: Any, off_screen: MakeScreen
) -> None:
    """Another drawing of the same scene, which shares its mesh, does not change."""
    scene = load("letter-f")
    near = replace(scene.start, lens=Perspective(60, 2, 30))
    narrow = replace(scene.start, lens=Perspective(0.01, 1, 30))
    within = Camera((0.3, 1.5, 0.4), (0, 2, 0))
    across = replace(scene.start, camera=within, lens=Perspective(90, 1e-5))
    screens = [off_screen(300, 200) for _ in range(3)]
    drawing, beside = (kind(s, scene, WORDS, LIGHT) for s in screens[:2])
    beside.show_projection(near)
    other = screens[1].pixels()
    own = meshes(screens[0])
    times = [mesh.GetMTime() for mesh in own.values()]
    pictures, used = {}, []
    for name, projection in (
        ("near", near), ("narrow", narrow), ("across", across), ("near", near), ("across", across),
        ("narrow", narrow), ("near", near),
    ):  # fmt: skip
        drawing.show_projection(projection)
        used.append(drawing.precision)
        picture = screens[0].pixels()
        assert (pictures.setdefault(name, picture) == picture).all()
    assert used == ["float32", "float64", "float64", "float32", "float64", "float64", "float32"]
    assert meshes(screens[0]) == own
    assert [mesh.GetMTime() for mesh in own.values()] == times
    fresh = kind(screens[2], scene, WORDS, LIGHT)
    for name, projection in (("near", near), ("across", across)):
        fresh.show_projection(projection)
        assert (screens[2].pixels() == pictures[name]).all()
    assert (screens[1].pixels() == other).all()


def projected(screen: OffScreen, own: dict[Any, Any]) -> list[str]:
    """Which of a drawing's own meshes are replaced by projected ones."""
    shown = meshes(screen)
    return [
        "faces" if mesh.GetNumberOfPolys() else "lines"
        for actor, mesh in own.items()
        if shown[actor] is not mesh
    ]


def test_faces_and_lines_choose_for_themselves(off_screen: MakeScreen) -> None:
    """Float32 can draw the trees of this avenue, but not the lines of its ground."""
    scene = load("far-plane-popping")
    faces_px, lines_px = (
        drawing_bound_px(scene.start, boxes, scene.origin)
        for boxes in (scene.boxes.faces, scene.boxes.lines)
    )
    assert faces_px < lines_px
    pictures = []
    for tolerance_px, those in (
        (lines_px, []), ((faces_px + lines_px) / 2.0, ["lines"]),
        (faces_px / 2.0, ["faces", "lines"]),
    ):  # fmt: skip
        screen = off_screen(500, 400)
        drawing = ImageDrawing(screen, scene, WORDS, LIGHT, tolerance_px)
        own = meshes(screen)
        drawing.show_projection(scene.start)
        assert projected(screen, own) == those
        assert drawing.precision == ("float64" if those else "float32")
        pictures.append(screen.pixels())
    for picture in pictures[1:]:
        assert (picture != pictures[0]).any(axis=-1).sum() <= 100


def test_what_is_not_drawn_is_not_projected(off_screen: MakeScreen) -> None:
    """In the image, levels of detail replace the faces."""
    scene = load("far-plane-popping")
    assert scene.phenomenon is not None
    screen = off_screen(200, 150)
    drawing = ImageDrawing(screen, scene, WORDS, LIGHT, 0.0)
    own = meshes(screen)
    for near, those in ((1.0, ["faces", "lines"]), (0.9, ["lines"]), (0.8, ["lines"])):
        projection = replace(scene.start, lens=replace(scene.start.lens, near=near))
        shown = scene.phenomenon.illustration(
            projection, scene.phenomenon.checked({}), scene.subject
        )
        drawing.show_projection(projection, shown)
        assert projected(screen, own) == those and drawing.precision == "float64"


@pytest.mark.parametrize("fov_y_deg", [45.0, 8.0, 0.5])
def test_what_float64_leaves_out_at_a_glance_is_not_seen(
    fov_y_deg: float, off_screen: MakeScreen, monkeypatch: pytest.MonkeyPatch
) -> None:
    """From outside a bumpy ball, from its middle and close to it, the pixels are the same."""
    sphere = pv.Sphere(theta_resolution=60, phi_resolution=60)
    points = sphere.points * (2.0 + 0.1 * np.sin(9.0 * sphere.points)).astype(np.float32)
    faces = sphere.regular_faces
    colours = np.random.default_rng(3).integers(30, 230, (len(faces), 3))
    ball = scene_of(points, faces.tolist(), colours.tolist(), (0.0, 0.0, 0.0))
    traced: list[int] = []
    trace = Projection.trace

    def counted(projection: Projection, points: Any, space: Any = "world") -> Any:
        traced.append(len(points))
        return trace(projection, points, space)

    for eye in ((3.0, 2.0, 4.0), (0.1, 0.0, 0.0), (1.12, 0.1, 0.0)):
        projection = Projection(
            Camera(eye, (0.0, 0.3, 0.1)), Perspective(fov_y_deg, 1e-3, 8.0), SIZE
        )
        pictures, counts = [], []
        for many in (10**9, 1_000):
            monkeypatch.setattr(precisions, "MANY_CELLS", many)
            screen = off_screen(*SIZE)
            drawing = ImageDrawing(screen, replace(ball), WORDS, LIGHT, 0.0, options=UNFRAMED)
            with monkeypatch.context() as patch:
                patch.setattr(Projection, "trace", counted)
                drawing.show_projection(projection)
            counts.append(sum(traced))
            traced.clear()
            pictures.append(screen.pixels())
        assert (pictures[0] == pictures[1]).all()
        assert (pictures[0] != to_bytes(LIGHT.background)).any(axis=-1).sum() > 2000
        whole, kept = counts
        assert kept < {45.0: 0.9, 8.0: 0.3, 0.5: 0.1}[fov_y_deg] * whole or eye[0] == 3.0
