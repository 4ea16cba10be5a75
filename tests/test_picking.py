"""What is under a pixel, against a ray tracer that knows nothing of homogeneous corners."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from app.drawings.probes import surface_of
from app.picking import Probe, Sight, Surface, dragged, projector
from app.projection import (
    Array,
    Camera,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.scene import load

LENSES: dict[str, Lens] = {
    "perspective": Perspective(45.0, 1.0, 30.0),
    "infinite": Perspective(60.0, 0.5, math.inf),
    "frustum": Frustum(-0.6, 0.9, -0.4, 0.5, 1.0, 40.0),
    "orthographic": Orthographic(-4.0, 4.0, -3.0, 3.0, -5.0, 40.0),
    "oblique": Oblique(-5.0, 5.0, -3.0, 3.0, 8.0, 40.0, alpha_deg=60.0, beta_deg=50.0),
}
CAMERA = Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0))


def first_hit(projection: Projection, triangles: Array, pixel: tuple[float, float]) -> Array | None:
    """Moller and Trumbore's intersection, in the world, along the un-projected pixel."""
    near = 0.0 if projection.depth != "reversed" else 1.0
    start, further = projection.world_from_image([(*pixel, near), (*pixel, 0.5)])
    along = (further - start) / np.linalg.norm(further - start)
    a, b, c = triangles.transpose(1, 0, 2)
    across = np.cross(along, c - a)
    area = np.einsum("ij,ij->i", b - a, across)
    with np.errstate(divide="ignore", invalid="ignore"):
        s = np.einsum("ij,ij->i", start - a, across) / area
        around = np.cross(start - a, b - a)
        t = around @ along / area
        far = np.einsum("ij,ij->i", c - a, around) / area
    hit = (s >= 0.0) & (t >= 0.0) & (s + t <= 1.0) & (far >= 0.0)
    if not hit.any():
        return None
    point: Array = start + far[hit].min() * along
    return point if not projection.trace(point).outside[1] else None


@pytest.mark.parametrize("depth", ["opengl", "direct3d", "reversed"])
@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_the_surface_under_a_pixel_is_the_model_s(lens: Lens, depth: str) -> None:
    scene = load("letter-f")
    projection = Projection(CAMERA, lens, (1280, 720), depth)  # type: ignore[arg-type]
    surface, mesh = surface_of(scene), scene.surface
    assert mesh is not None
    triangles = mesh.triangulate().points[mesh.triangulate().regular_faces] + scene.origin
    random = np.random.default_rng(1)
    image = projection.trace(triangles.reshape(-1, 3)).image
    low, high = image.min(axis=0), image.max(axis=0)
    found = 0
    for pixel in random.uniform(np.maximum(low, 0), np.minimum(high, (1280, 720)), (500, 2)):
        x, y = pixel.tolist()
        hit, expected = surface.pick(Sight.of(projection), (x, y), 0.0), None
        expected = first_hit(projection, triangles, (x, y))
        assert (hit is None) == (expected is None), (x, y)
        if hit is not None and expected is not None:
            found += 1
            assert math.dist(projection.trace(hit.point).image, (x, y)) <= 0.5
            assert math.dist(hit.point, expected) <= 1e-5 * scene.size
    assert found > 15


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_a_vertex_within_six_pixels_comes_first_unless_it_is_hidden(lens: Lens) -> None:
    """A square with a vertex in front, and one exactly behind its middle."""
    projection = Projection(Camera((0.0, 0.0, 9.0), (0.0, 0.0, 0.0)), lens, (1280, 720))
    points = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], np.float32)
    behind = points * 0.5 + np.float32([0.0, 0.0, -1.0])
    hidden = Surface(np.concatenate([points, behind]), np.array([(0, 1, 2), (0, 2, 3), (4, 5, 6)]))
    sight = Sight.of(projection)
    x, y = projection.trace(points[2]).image.tolist()
    hit = hidden.pick(sight, (x + 3.0, y - 4.0))
    assert hit is not None and hit.vertex == 2 and hit.point == (1.0, 1.0, 0.0)
    assert hidden.pick(sight, (x + 5.0, y - 5.0)) is None
    x, y = projection.trace(behind[2]).image.tolist()
    hit = hidden.pick(sight, (x + 1.0, y - 1.0))
    assert hit is not None and hit.vertex is None and abs(hit.point[2]) < 1e-12


def test_a_triangle_that_crosses_the_eye_plane_is_hit_in_front_only() -> None:
    """A floor from far behind the eye to far in front of it."""
    projection = Projection(
        Camera((0.0, 1.0, 0.0), (0.0, 1.0, -1.0)), Perspective(90.0, 0.1, 500.0)
    )
    floor = np.array([(0, 0, -300), (-900, 0, 300), (900, 0, 300)], np.float32)
    surface = Surface(floor, np.array([(0, 1, 2)]))
    sight = Sight.of(projection)
    width, height = projection.image_size
    # 45 degrees below the horizon is the picture's lower edge, where the floor is 1 away.
    hit = surface.pick(sight, (width / 2.0, float(height)))
    assert hit is not None and hit.point == pytest.approx((0.0, 0.0, -1.0), abs=1e-12)
    above = width / 2.0, 0.0
    assert surface.pick(sight, above) is None  # nor mirrored there,
    assert surface.pick(sight._replace(limits=np.empty((0, 4))), above) is None  # near plane or not
    lens = Perspective(90.0, 2.0, 500.0)  # cuts away what is 1 away
    assert surface.pick(Sight.of(replace(projection, lens=lens)), (width / 2.0, height)) is None


def test_what_is_nearer_than_near_or_beyond_far_is_not_seen() -> None:
    square = np.array([(-1, -1, 0), (1, -1, 0), (0, 1, 0)], np.float32)
    layers = np.concatenate([square + np.float32([0, 0, z]) for z in (4.5, 0.0, -9.0)])
    surface = Surface(layers, np.arange(9).reshape(3, 3))
    camera = Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0))
    seen = Projection(camera, Perspective(45.0, 1.0, 30.0))
    middle = seen.image_size[0] / 2.0, seen.image_size[1] / 2.0
    for near, far, z in ((0.1, 30.0, 4.5), (1.0, 30.0, 0.0), (6.0, 30.0, -9.0)):
        lens = Perspective(45.0, near, far)
        hit = surface.pick(Sight.of(replace(seen, lens=lens)), middle)
        assert hit is not None and hit.point[2] == z
    lens = Perspective(45.0, 6.0, 10.0)
    assert surface.pick(Sight.of(replace(seen, lens=lens)), middle) is None


def test_a_mesh_denser_than_the_pixels_is_picked_from_any_distance() -> None:
    """A wavy sheet of 125 000 triangles, filling the picture and shrunk to a few pixels."""
    count = 251
    x, y = np.meshgrid(*2 * [np.linspace(-1.0, 1.0, count)])
    points = np.stack([x, y, 0.1 * np.sin(5 * x) * np.cos(4 * y)], -1).reshape(-1, 3)
    points = points.astype(np.float32)
    corner = np.arange(count * count).reshape(count, count)
    a, b, c, d = (part.ravel() for part in (
        corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1])
    )  # fmt: skip
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    surface = Surface(points, triangles, (1e6, 0.0, -1e6))
    random = np.random.default_rng(2)
    for distance in (2.0, 9.0, 400.0):
        camera = Camera((1e6 + 0.3 * distance, 0.1, distance - 1e6), (1e6, 0.0, -1e6))
        projection = Projection(camera, Perspective(45.0, 0.5, 1e4), (1280, 720))
        for point in random.uniform(-0.6, 0.6, (20, 2)):
            place = (1e6 + point[0], point[1], -1e6)
            pixel = projection.trace(place).image.tolist()
            hit = surface.pick(Sight.of(projection), (pixel[0], pixel[1]))
            assert hit is not None
            off = math.dist(projection.trace(hit.point).image, pixel)
            assert off <= 6.0 and (hit.vertex is not None or off <= 1e-6)


def test_nothing_is_found_in_nothing() -> None:
    surface = Surface(np.empty((0, 3), np.float32), np.empty((0, 3), np.int32))
    projection = load("letter-f").start
    assert surface.pick(Sight.of(projection), (640.0, 360.0)) is None


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_a_projector_is_one_pixel(lens: Lens) -> None:
    projection = Projection(CAMERA, lens, (1280, 720))
    point = (1.0, 2.0, 0.5)
    through = projection.trace(point)
    for probe in (
        Probe(1, point),
        Probe(2, pixel=(float(through.image[0]), float(through.image[1]))),
    ):
        line = projector(projection, probe, [1.5, 8.0, float(-through.view[2])])
        assert line is not None
        trace = projection.trace(line)
        assert trace.image == pytest.approx(np.tile(through.image, (3, 1)), abs=1e-9)
        assert -trace.view[:2, 2] == pytest.approx([1.5, 8.0], rel=1e-12)
        assert line[2] == pytest.approx(point, abs=1e-12)


def test_a_point_behind_the_eye_has_no_projector() -> None:
    projection = Projection(CAMERA, LENSES["perspective"], (1280, 720))
    assert projector(projection, Probe(1, (12.0, 8.0, 18.0)), [1.0]) is None
    assert projector(projection, Probe(1, CAMERA.eye), [1.0]) is None


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_a_dragged_point_stays_in_its_plane_or_on_its_ray(lens: Lens) -> None:
    projection = Projection(CAMERA, lens, (1280, 720))
    point = (1.0, 2.0, 0.5)
    before = projection.trace(point)
    moved = dragged(projection, point, (31.0, -17.0), along_ray=False)
    assert moved is not None
    after = projection.trace(moved)
    assert after.image - before.image == pytest.approx([31.0, -17.0], abs=1e-9)
    assert after.view[2] == pytest.approx(before.view[2], rel=1e-12)
    moved = dragged(projection, point, (5.0, -90.0), along_ray=True)
    assert moved is not None
    after = projection.trace(moved)
    assert after.image == pytest.approx(before.image, abs=1e-9)
    # 90 px up: 90/180 of a doubling of the distance, or as far as 90 px are wide.
    far = -before.view[2]
    farther = far * math.sqrt(2.0) if not lens.parallel else far + 6.0 * 90.0 / 720.0
    assert -after.view[2] == pytest.approx(farther, rel=1e-12)
    for down in (-1e9, 1e9):
        moved = dragged(projection, point, (0.0, down), along_ray=True)
        assert moved is None if not lens.parallel else moved is not None


def test_a_point_without_a_picture_cannot_be_dragged() -> None:
    projection = Projection(CAMERA, LENSES["perspective"], (1280, 720))
    assert dragged(projection, (12.0, 8.0, 18.0), (3.0, 0.0), along_ray=False) is None
