"""Dots and lines of a file, in pixels and in figures without pixels."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.drawings import WORDS
from app.drawings.describing import describe
from app.drawings.image import ImageDrawing
from app.drawings.picture_frame import UNFRAMED
from app.drawings.probes import next_vertex, pick_in, vertex_of
from app.drawings.stage import StageDrawing
from app.drawings.style import LIGHT
from app.drawings.vectors import Area, Disc, LineShape, Shape, shapes_of
from app.drawings.world import WorldDrawing
from app.model.chain import FiveTiles
from app.model.projection import Array, Camera, Perspective, Projection
from app.model.refusal import Refusal
from app.precision.quality import Quality
from app.scenes.fewer_triangles import reduced
from app.scenes.scene import Scene, load
from app.scenes.shapes import DRAWN_RGB
from tests.support.drawings import MakeScreen, figure_of

BLUE = tuple(level / 255.0 for level in DRAWN_RGB)
CAMERA = Projection(Camera((0.5, 0.25, 4.0), (0.0, 0.0, 0.0)), Perspective(50.0, 1.0, 6.0))


def cloud(path: Path, points: Array) -> Scene:
    path.write_text(
        "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist()), encoding="utf-8"
    )
    return load(str(path))


def discs(found: list[Shape]) -> Array:
    """Centres of the discs, (n, 2), sorted."""
    return np.array(sorted(shape.centre for shape in found if isinstance(shape, Disc)))


def blue_strokes(found: list[Shape]) -> list[Array]:
    return [np.array(s.points) for s in found if isinstance(s, LineShape) and s.colour == BLUE]


def test_no_dot_stands_out_of_the_frame_of_its_picture(scattered: tuple[Scene, Array]) -> None:
    """A dot at the frame is cut by it, as it is in pixels."""
    scene, large = replace(scattered[0], dot_widths=20.0), {"text_pt": 4.0, "palette": "print"}
    _, found = figure_of(scene, CAMERA, ["world", "image"], (600, 300), **large).shapes()
    areas, paper = [shape for shape in found if isinstance(shape, Area)], (1.0, 1.0, 1.0)
    rings = [np.array(ring) for area in areas for ring in area.rings]
    grounds = [np.array(area.rings[0]) for area in areas if area.colour == paper]
    picture = min(grounds, key=lambda ring: np.ptp(ring[:, 1]))
    left, low = picture.min(axis=0), picture.max(axis=0)
    parts = [ring for ring in rings if len(ring) > 12]
    assert len(parts) > 3, "of dots at the frame"
    assert all((ring >= left - 1e-6).all() and (ring <= low + 1e-6).all() for ring in parts)
    for dot in (each for each in found if isinstance(each, Disc) and each.centre[0] > left[0]):
        assert (np.abs(dot.centre - (left + low) / 2.0) + dot.radius <= (low - left) / 2.0).all()


def _on_near(points: Array) -> Array:
    """Where the rays of points (n, 3) meet the near plane of `CAMERA`."""
    eye, depths = np.array(CAMERA.camera.eye), -CAMERA.trace(points).view[:, 2:]
    met: Array = eye + (points - eye) * CAMERA.lens.near / depths
    return met


@pytest.fixture
def scattered(tmp_path: Path) -> tuple[Scene, Array]:
    """A cloud around the camera, of which a part is behind the eye, and its points."""
    points = np.random.default_rng(1).uniform(-8.0, 8.0, (400, 3)).round(3)
    return cloud(tmp_path / "cloud.obj", points), points


def test_the_dots_of_a_figure_are_the_traced_points_inside_the_volume(
    scattered: tuple[Scene, Array],
) -> None:
    scene, points = scattered
    for projection in (
        CAMERA,
        replace(CAMERA, placement=FiveTiles((0.5, 0.0, -1.0), (0.0, 30.0, 0.0)).chain),
    ):
        trace = projection.trace(points, "object")
        inside = trace.image[~trace.outside.any(axis=1)]
        assert 5 < len(inside) < 100 and (trace.clip[:, 3] < 0.0).any()
        _, found = figure_of(scene, projection, ["image"], size=projection.image_size).shapes()
        assert np.abs(discs(found) - np.array(sorted(inside.tolist()))).max() < 1e-9


def test_the_dots_of_the_world_and_of_the_cube_are_where_their_panes_see_them(
    scattered: tuple[Scene, Array], off_screen: MakeScreen
) -> None:
    scene, points = scattered
    is_inside = ~CAMERA.trace(points).outside.any(axis=1)
    screen = off_screen(600, 400)
    stage = StageDrawing(screen, scene, WORDS, LIGHT)
    stage.show_projection(CAMERA)
    screen.render_window.Render()
    drawn = discs(shapes_of(screen.render_window, 1))
    expected = stage.sight.seen(points[is_inside])
    assert np.abs(drawn - np.array(sorted(expected.tolist()))).max() < 1e-6
    stage.remove()
    screen = off_screen(600, 400)
    world = WorldDrawing(screen, scene, WORDS, LIGHT)
    world.show_layers(frozenset({"camera"}))  # it would hide some dots
    world.show_projection(CAMERA)
    screen.render_window.Render()
    drawn = discs(shapes_of(screen.render_window, 1))
    seen = world.sight.seen(points)
    seen = seen[((seen >= 0.0) & (seen <= (600, 400))).all(axis=1)]
    away = np.linalg.norm(drawn[:, None] - seen, axis=2)
    assert away.min(axis=0).max() < 1e-3, "every point that the pane sees has its dot"
    left = drawn[away.min(axis=1) > 1e-3]
    assert len(drawn) == len(seen) + is_inside.sum(), "and on the near plane is a picture of each"
    sights = world.sight.seen(_on_near(points[is_inside]))
    assert np.abs(left - np.array(sorted(sights.tolist()))).max() < 0.5


def test_dots_have_their_pixels_and_none_comes_from_behind_the_eye(
    tmp_path: Path, off_screen: MakeScreen
) -> None:
    points = np.array([(0, 0, 0), (0.5, 0.25, 0), (-0.5, 0.5, 1), (0.25, 0.75, 7), (1, -1, 9)])
    scene = cloud(tmp_path / "m.obj", points)
    screen = off_screen(1280, 720)
    drawing = ImageDrawing(screen, scene, WORDS, LIGHT, options=UNFRAMED)
    drawing.show_layers(frozenset({"grid"}))
    drawing.show_projection(CAMERA)
    is_drawn = (np.abs(screen.pixels()[..., :3].astype(int) - DRAWN_RGB) < 3).all(axis=2)
    rows, columns = np.nonzero(is_drawn)
    trace = CAMERA.trace(points)
    away = np.hypot(
        columns[:, None] + 0.5 - trace.image[:3, 0], rows[:, None] + 0.5 - trace.image[:3, 1]
    )
    assert (away.min(axis=1) < 4.0).all(), "nothing else is drawn"
    for i in range(3):
        of_dot = away.argmin(axis=1) == i
        middle = columns[of_dot].mean() + 0.5, rows[of_dot].mean() + 0.5
        assert math.dist(middle, trace.image[i]) < 0.6 and 15 < of_dot.sum() < 40


@pytest.mark.parametrize("ends", [((0, 0, 1), (0.25, 1, 7)), ((-0.25, 1, 9), (0.5, -0.5, 0))])
def test_a_line_through_the_near_plane_ends_at_the_image_of_their_point(
    ends: tuple[tuple[float, ...], tuple[float, ...]], tmp_path: Path, off_screen: MakeScreen
) -> None:
    one, other = np.array(ends, dtype=np.float64)
    rows = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in (one.tolist(), other.tolist()))
    (tmp_path / "line.obj").write_text(rows + "l 1 2\n", encoding="utf-8")
    scene = load(str(tmp_path / "line.obj"))
    depths = -CAMERA.trace(np.array([one, other])).view[:, 2]
    assert depths.min() < 0.0 < CAMERA.lens.near < depths.max()
    met = one + (CAMERA.lens.near - depths[0]) / (depths[1] - depths[0]) * (other - one)
    inner = one if depths[0] > 0.0 else other
    expected = CAMERA.trace(np.array([met, inner])).image
    _, found = figure_of(scene, CAMERA, ["image"], size=CAMERA.image_size).shapes()
    (stroke,) = blue_strokes(found)
    assert np.abs(np.sort(stroke, axis=0) - np.sort(expected, axis=0)).max() < 1e-6
    screen = off_screen(600, 400)
    stage = StageDrawing(screen, scene, WORDS, LIGHT)
    stage.show_projection(CAMERA)
    screen.render_window.Render()
    (stroke,) = blue_strokes(shapes_of(screen.render_window, 1))
    in_cube = stage.sight.seen(np.array([met, inner]))
    assert np.abs(np.sort(stroke, axis=0) - np.sort(in_cube, axis=0)).max() < 1e-3


def test_a_face_hides_dots_and_lines_behind_it(tmp_path: Path) -> None:
    text = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 -1\nv 0.5 0 1\nv -3 0 -1\nv 0 0 0\n"
    (tmp_path / "m.obj").write_text(text + "f 1 2 3 4\nl 5 7\np 5 6 7 1 8\n", encoding="utf-8")
    scene = load(str(tmp_path / "m.obj"))
    projection = replace(CAMERA, camera=Camera((0, 0, 4), (0, 0, 0)), lens=Perspective(60, 1, 9))
    _, found = figure_of(scene, projection, ["image"], size=projection.image_size).shapes()
    places = projection.trace(np.array([(0.5, 0, 1), (-3, 0, -1), (-1, -1, 0), (0, 0, 0)])).image
    assert np.abs(discs(found) - np.array(sorted(places.tolist()))).max() < 1e-9
    (stroke,) = blue_strokes(found)
    # From (-3, 0, -1) to where the side of the square at x = -1 begins to hide it.
    expected = projection.trace(np.array([(-3, 0, -1), (-1, 0, 0)])).image
    assert np.abs(np.sort(stroke[:, 0]) - np.sort(expected[:, 0])).max() < 0.05
    _, found = figure_of(
        scene, projection, ["image"], size=projection.image_size, hidden="dashed"
    ).shapes()
    assert any(s.dash and s.colour == BLUE for s in found if isinstance(s, LineShape))


@pytest.mark.parametrize("near", [1.0, 0.01])
def test_a_dot_is_as_near_as_its_point(near: float, tmp_path: Path, off_screen: MakeScreen) -> None:
    text = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0.25 0 -0.25\nv -0.25 0 0\nv 0 0.25 0.25\n"
    (tmp_path / "m.obj").write_text(text + "f 1 2 3 4\np 5 6 7\n", encoding="utf-8")
    scene = load(str(tmp_path / "m.obj"))
    lens = Perspective(50, near, 9)
    projection = replace(CAMERA, camera=Camera((0, 0, 4), (0, 0, 0)), lens=lens)
    screen = off_screen(1280, 720)
    drawing = ImageDrawing(screen, scene, WORDS, LIGHT, options=UNFRAMED)
    drawing.show_projection(projection)
    pixels = screen.pixels()
    places = projection.trace(np.array([(0.25, 0, -0.25), (-0.25, 0, 0), (0, 0.25, 0.25)])).image
    colours = [tuple(pixels[int(y), int(x), :3].tolist()) for x, y in places.tolist()]
    assert [colour == DRAWN_RGB for colour in colours] == [False, True, True]


def test_a_probe_and_the_keyboard_find_dots_and_ends_of_lines(
    tmp_path: Path, off_screen: MakeScreen
) -> None:
    text = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 -1\nv 0.5 0 1\n"
    (tmp_path / "m.obj").write_text(text + "l 1 2\np 3 6 5\n", encoding="utf-8")
    scene = load(str(tmp_path / "m.obj"))
    drawing = ImageDrawing(off_screen(1280, 720), scene, WORDS, LIGHT, options=UNFRAMED)
    drawing.show_projection(CAMERA)
    sight, room = drawing.sight, drawing.picture_rectangle_px
    found: list[tuple[float, ...]] = []
    at: int | None = None
    for _ in range(5):
        at = next_vertex(scene, CAMERA, sight, room, 1.0, at, forwards=True)
        assert at is not None
        found.append(vertex_of(scene, CAMERA, at))
    points = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (0, 0, -1), (0.5, 0, 1)]
    assert sorted(found) == sorted(points)
    for point in points:
        x, y = CAMERA.trace(np.array([point])).image[0].tolist()
        hit = pick_in(scene, CAMERA, sight, (x + 2.0, y - 1.0))
        assert hit is not None and hit.point == point
    (x, y), _ = CAMERA.trace(np.array([(0.25, -1.0, 0.0), (0, 0, 0)])).image.tolist()
    hit = pick_in(scene, CAMERA, sight, (x, y))
    assert hit is not None and np.allclose(hit.point, (0.25, -1.0, 0.0))


def test_a_cloud_that_float32_cannot_draw_is_drawn_in_float64(
    tmp_path: Path, off_screen: MakeScreen
) -> None:
    points = np.array([(0, 0, 0), (1e-4, 5e-5, 0), (-1e-4, 5e-5, 1e-4), (1, 1, 1), (-1, -1, -1)])
    scene = cloud(tmp_path / "m.obj", points)
    narrow = Perspective(fov_y_deg=0.003, near=1.0, far=6.0)
    projection = Projection(Camera((0.5, 0.25, 4.0), (0, 0, 0)), narrow)
    screen = off_screen(1280, 720)
    drawing = ImageDrawing(screen, scene, WORDS, LIGHT, options=UNFRAMED)
    drawing.show_layers(frozenset({"grid"}))
    drawing.show_projection(projection)
    assert drawing.precision == "float64"
    screen.render_window.Render()
    drawn = discs(shapes_of(screen.render_window, 1))
    expected = projection.trace(points[:3]).image
    assert np.abs(drawn - np.array(sorted(expected.tolist()))).max() < 1e-3


def test_the_depth_buffer_of_the_document_decides_between_dots(
    tmp_path: Path, off_screen: MakeScreen
) -> None:
    text = "v 0 0 0 1 0 0\nv 0 0 -0.1 0 1 0\nv 2 0 0 0 0 1\n"
    (tmp_path / "m.obj").write_text(text, encoding="utf-8")
    scene = load(str(tmp_path / "m.obj"))
    projection = replace(
        CAMERA, camera=Camera((0, 0, 4), (0, 0, 0)), lens=Perspective(50, 0.001, 9)
    )
    colours = []
    for quality in (Quality(), Quality(depth_format="fixed16")):
        screen = off_screen(640, 360)
        options = UNFRAMED._replace(quality=quality)
        drawing = ImageDrawing(screen, scene, WORDS, LIGHT, options=options)
        drawing.show_layers(frozenset({"grid"}))
        drawing.show_projection(projection)
        colours.append(screen.pixels()[180, 320, :3].tolist())
        drawing.remove()
    # In 16 bits both are at the same depth, and the second is drawn over the first.
    assert colours == [[255, 0, 0], [0, 255, 0]]


def test_fewer_dots_are_drawn_in_every_precision_and_all_again(
    tmp_path: Path, off_screen: MakeScreen
) -> None:
    points = np.random.default_rng(3).uniform(-1.0, 1.0, (2_000, 3)).round(3)
    scene = cloud(tmp_path / "m.obj", points)
    fewer = reduced(scene, 0.05)
    for tolerance_px, precision in ((1.0, "float32"), (0.0, "float64")):
        screen = off_screen(640, 360)
        drawing = ImageDrawing(screen, scene, WORDS, LIGHT, tolerance_px, options=UNFRAMED)
        counts = []
        for shown in (None, fewer, None):
            drawing.show_detail(shown)
            drawing.show_projection(CAMERA)
            assert drawing.precision == precision
            screen.render_window.Render()
            counts.append(len(discs(shapes_of(screen.render_window, 1))))
        drawing.remove()
        assert counts == [2_000, 100, 2_000]


def test_a_cloud_is_counted_described_and_bounded_in_figures(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from app.document.document import Document
    from app.drawings import vectors

    (tmp_path / "m.obj").write_text(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nl 1 2 3\np 4\n", encoding="utf-8"
    )
    scene = load(str(tmp_path / "m.obj"))
    document = Document(str(tmp_path / "m.obj"), scene.start)
    about = describe(document, scene)
    assert about.general[0] == "The file is drawn with triangles: 0, lines: 2, points: 1."
    assert about.cut == ("All of the scene's objects lie inside the view volume.",)
    x, y, z = scene.start.camera.target
    away = replace(scene.start, camera=Camera(scene.start.camera.eye, (x + 99.0, y, z)))
    assert describe(replace(document, projection=away), scene).cut != about.cut
    monkeypatch.setattr(vectors, "MOST_CELLS", 20)
    with pytest.raises(Refusal, match="faces, lines and points in a pane; the limit"):
        figure_of(scene, scene.start, panes=["image"]).save(str(tmp_path / "m.svg"))


def test_dots_and_lines_are_black_in_print(tmp_path: Path) -> None:
    text = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nl 1 2\np 3\n"
    (tmp_path / "m.obj").write_text(text, encoding="utf-8")
    scene = load(str(tmp_path / "m.obj"))
    _, found = figure_of(scene, scene.start, ["image"], palette="print").shapes()
    assert {s.colour for s in found if isinstance(s, Disc)} == {(0.0, 0.0, 1.0)}
    assert (0.0, 0.0, 0.0) in {s.colour for s in found if isinstance(s, LineShape)}
    cloud(tmp_path / "m.obj", np.eye(3))
    _, found = figure_of(
        load(str(tmp_path / "m.obj")), scene.start, ["image"], palette="print"
    ).shapes()
    assert {s.colour for s in found if isinstance(s, Disc)} == {(0.0, 0.0, 0.0)}
