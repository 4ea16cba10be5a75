"""Picking agrees with a ray tracer in world space, without homogeneous coordinates."""

import itertools
import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.drawings.probes import pick_in, sort_ahead
from app.model.projection import (
    DEPTH_RANGES,
    Array,
    Camera,
    FreeMatrix,
    Lens,
    Perspective,
    Projection,
)
from app.picking import picking
from app.picking.picking import Hit, Lines, PickSurface, Probe, dragged, pick, projector, stops
from app.picking.sight import Sight
from app.scenes.scene import Scene, load
from tests.support.lenses import LENSES, free_matrix

CAMERA = Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0))
NO_FACES = PickSurface(np.empty((0, 3), np.float32), np.empty((0, 3), np.int32))
NO_LINES = Lines(np.empty((0, 2, 3)))


ALL_LENSES = {**LENSES, "matrix": free_matrix()}


def triangles_of(scene: Scene) -> Array:
    """World coordinates of the corners, (m, 3, 3)."""
    assert scene.surface is not None
    mesh = scene.surface.triangulate()
    triangles: Array = mesh.points[mesh.regular_faces].astype(np.float64) + scene.origin
    return triangles


def surface_of(scene: Scene) -> PickSurface:
    assert scene.surface is not None
    mesh = scene.surface.triangulate()
    return PickSurface(np.asarray(mesh.points), mesh.regular_faces, scene.origin)


def lines_of(scene: Scene) -> Array:
    """World coordinates of the ends, (m, 2, 3)."""
    assert scene.lines is not None
    ends: Array = scene.lines.points.reshape(-1, 2, 3).astype(np.float64) + scene.origin
    return ends


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


@pytest.mark.parametrize(
    ("lens", "depth"), list(zip(LENSES.values(), itertools.cycle(DEPTH_RANGES))), ids=LENSES
)
def test_the_surface_under_a_pixel_agrees_with_the_model(lens: Lens, depth: str) -> None:
    scene = load("letter-f")
    projection = Projection(CAMERA, lens, (1280, 720), depth)  # type: ignore[arg-type]
    surface, triangles = surface_of(scene), triangles_of(scene)
    random = np.random.default_rng(1)
    image = projection.trace(triangles.reshape(-1, 3)).image
    low, high = image.min(axis=0), image.max(axis=0)
    found = 0
    for pixel in random.uniform(np.maximum(low, 0), np.minimum(high, (1280, 720)), (200, 2)):
        x, y = pixel.tolist()
        hit = surface.pick(Sight.of(projection), (x, y), 0.0)
        expected = first_hit(projection, triangles, (x, y))
        assert (hit is None) == (expected is None), (x, y)
        if hit is not None and expected is not None:
            found += 1
            assert math.dist(projection.trace(hit.point).image, (x, y)) <= 0.5
            assert math.dist(hit.point, expected) <= 1e-5 * scene.size
    assert found > 6


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_a_vertex_within_six_pixels_comes_first_unless_it_is_hidden(lens: Lens) -> None:
    """A square with a vertex in front, and one exactly behind its middle."""
    projection = Projection(Camera((0.0, 0.0, 9.0), (0.0, 0.0, 0.0)), lens, (1280, 720))
    points = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], np.float32)
    behind = points * 0.5 + np.float32([0.0, 0.0, -1.0])
    hidden = PickSurface(
        np.concatenate([points, behind]), np.array([(0, 1, 2), (0, 2, 3), (4, 5, 6)])
    )
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
    camera = Camera((0.0, 1.0, 0.0), (0.0, 1.0, -1.0))
    projection = Projection(camera, Perspective(90.0, 0.1, 500.0))
    floor = np.array([(0, 0, -300), (-900, 0, 300), (900, 0, 300)], np.float32)
    surface = PickSurface(floor, np.array([(0, 1, 2)]))
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


def test_surfaces_outside_near_and_far_are_not_picked() -> None:
    square = np.array([(-1, -1, 0), (1, -1, 0), (0, 1, 0)], np.float32)
    layers = np.concatenate([square + np.float32([0, 0, z]) for z in (4.5, 0.0, -9.0)])
    surface = PickSurface(layers, np.arange(9).reshape(3, 3))
    camera = Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0))
    seen = Projection(camera, Perspective(45.0, 1.0, 30.0))
    middle = seen.image_size[0] / 2.0, seen.image_size[1] / 2.0
    for near, far, z in ((0.1, 30.0, 4.5), (1.0, 30.0, 0.0), (6.0, 30.0, -9.0)):
        lens = Perspective(45.0, near, far)
        hit = surface.pick(Sight.of(replace(seen, lens=lens)), middle)
        assert hit is not None and hit.point[2] == pytest.approx(z, abs=1e-12)
    lens = Perspective(45.0, 6.0, 10.0)
    assert surface.pick(Sight.of(replace(seen, lens=lens)), middle) is None


def test_the_vertex_with_the_cursor_is_among_the_stops_of_any_crowd() -> None:
    """The stops are some 200 of 250 000 vertices; this vertex is a stop only because of `at`."""
    side = np.linspace(-1.0, 1.0, 500, dtype=np.float32)
    points = np.stack([*np.meshgrid(side, side), np.zeros((500, 500), np.float32)], -1)
    points = points.reshape(-1, 3)
    projection = Projection(Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0)), Perspective(45.0, 1.0, 30.0))
    sight, whole = Sight.of(projection), (0.0, 0.0, 1280.0, 720.0)
    usual = {stop.number for stop in stops(points, (0.0, 0.0, 0.0), sight, whole)}
    at = next(number for number in range(125_000, 250_000) if number not in usual)
    found = stops(points, (0.0, 0.0, 0.0), sight, whole, at=at)
    (there,) = (stop for stop in found if stop.number == at)
    assert there.spot == pytest.approx(projection.trace(points[[at]]).image[0], abs=1e-6)
    assert len(found) <= len(usual) + 1 and found == sorted(found)


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
    surface = PickSurface(points, triangles, (1e6, 0.0, -1e6))
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


def test_a_dense_flat_mesh_is_picked() -> None:
    """A mesh without an extent along one axis has no cells along it."""
    count = 400
    across, down = np.meshgrid(*2 * [np.linspace(-1.0, 1.0, count, dtype=np.float32)])
    corner = np.arange(count * count).reshape(count, count)
    a, b, c = (part.ravel() for part in (corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:]))
    points = np.stack([across, down, np.full_like(across, 0.25)], -1).reshape(-1, 3)
    surface = PickSurface(points, np.stack([a, b, c], 1))
    projection = Projection(Camera((0.0, 0.0, 3.0), (0.0, 0.0, 0.0)), image_size=(1280, 720))
    hit = surface.pick(Sight.of(projection), tuple(projection.trace((0.3, 0.2, 0.25)).image))
    assert hit is not None and hit.point == pytest.approx((0.3, 0.2, 0.25), abs=0.01)


def test_an_empty_scene_has_nothing_to_pick() -> None:
    sight = Sight.of(load("letter-f").start)
    assert NO_FACES.pick(sight, (640.0, 360.0)) is None
    assert pick(NO_FACES, NO_LINES, sight, (640.0, 360.0)) is None


# -- lines


def nearest_on(projection: Projection, line: Array, pixel: tuple[float, float]) -> Array | None:
    """The place of a line nearest to a pixel, by ever finer samples of its trace."""
    low, high, best = 0.0, 1.0, None
    for count in (4001, *9 * [101]):
        parts = np.linspace(low, high, count)
        trace = projection.trace(line[0] + parts[:, None] * (line[1] - line[0]))
        drawn = trace.in_front & ~trace.outside[:, :2].any(axis=1)  # of near and far
        away = np.where(drawn, np.hypot(*(trace.image - pixel).T), np.inf)
        first = int(np.nanargmin(away))
        if not np.isfinite(away[first]):
            return None
        best = line[0] + parts[first] * (line[1] - line[0])
        step = parts[1] - parts[0]
        low, high = max(0.0, parts[first] - 2 * step), min(1.0, parts[first] + 2 * step)
    return best


@pytest.mark.parametrize("lens", ALL_LENSES.values(), ids=ALL_LENSES)
def test_the_place_of_a_line_nearest_to_a_click_agrees_with_the_model(lens: Lens) -> None:
    """Click beside lines through the whole scene, many of which also run behind the eye."""
    random = np.random.default_rng(5)
    size, ends, between = 20.0, 0, 0
    for number in range(80):
        camera = Camera(tuple(random.normal(0.0, 6.0, 3)), tuple(random.normal(0.0, 1.0, 3)))
        projection = Projection(camera, lens, (1280, 720))
        line = random.normal(0.0, size / 4.0, (2, 3))
        line[1] *= random.choice([0.2, 1.0, 40.0])
        parts = random.uniform(0.0, 1.0, 200)
        parts[0] *= number % 8 != 0  # beside an end
        trace = projection.trace(line[0] + parts[:, None] * (line[1] - line[0]))
        seen = np.flatnonzero(~trace.outside.any(axis=1))
        if not len(seen):
            continue
        x, y = trace.image[seen[0]] + random.uniform(-1.9, 1.9, 2)
        expected = nearest_on(projection, line, (x, y))
        hit = pick(NO_FACES, Lines([line]), Sight.of(projection), (x, y))
        assert hit is not None and expected is not None
        away = [math.dist(projection.trace(end).image, (x, y)) for end in line]
        if hit.point in (tuple(line[0]), tuple(line[1])):
            ends += 1
            assert math.dist(projection.trace(hit.point).image, (x, y)) <= 6.0
            continue
        between += 1
        # An end that is near enough comes first, but only if it is in front of near.
        in_range = ~projection.trace(line).outside[:, :2].any(axis=1)
        assert not (in_range & (np.array(away) <= 6.0)).any()
        image = projection.trace(hit.point).image
        assert math.dist(image, projection.trace(expected).image) <= 1e-3
        assert math.dist(hit.point, expected) <= 1e-5 * size
    assert between >= 20 and ends >= 1, (between, ends)


@pytest.mark.parametrize("lens", ALL_LENSES.values(), ids=ALL_LENSES)
def test_the_grid_is_picked_where_no_face_is_in_front(lens: Lens) -> None:
    scene = load("letter-f")
    triangles, lines = triangles_of(scene), lines_of(scene)
    grid = lines[(lines[:, :, 1] == 0.0).all(axis=1)]
    random = np.random.default_rng(6)
    around = [(0.0, 0.0)] + [(7 * math.cos(a), 7 * math.sin(a)) for a in np.arange(0.0, 6.2, 1.0)]
    clear = hidden = 0
    for _ in range(200):
        if clear >= 12 and hidden >= 2:
            break
        eye = random.uniform((-9.0, -4.0, 4.0), (9.0, 8.0, 12.0))
        target = random.uniform((-4.0, -2.0, -2.0), (4.0, 5.0, 2.0))
        projection = Projection(Camera(tuple(eye), tuple(target)), lens, (1280, 720))
        sight = Sight.of(projection)
        for line in grid[random.integers(0, len(grid), 40)]:
            place = line[0] + random.uniform(0.0, 1.0) * (line[1] - line[0])
            trace = projection.trace(place)
            if trace.outside.any():
                continue
            x, y = trace.image.tolist()
            in_front = set()
            for dx, dy in around:
                face = first_hit(projection, triangles, (x + dx, y + dy))
                in_front.add(face is not None and projection.trace(face).depth < trace.depth - 1e-6)
                if len(in_front) == 2:
                    break
            hit = pick_in(scene, scene.start, sight, (x, y))
            assert hit is not None
            if not any(in_front):
                clear += 1
                assert any(distance_from(hit.point, other) <= 1e-6 for other in lines)
                assert math.dist(projection.trace(hit.point).image, (x, y)) <= 6.0
            elif all(in_front):
                hidden += 1
                assert projection.trace(hit.point).depth < trace.depth - 1e-6
    assert clear >= 12 and hidden >= 2, (clear, hidden)


def distance_from(point: Any, line: Array) -> float:
    along = line[1] - line[0]
    part = float(np.clip((point - line[0]) @ along / (along @ along), 0.0, 1.0))
    return math.dist(point, line[0] + part * along)


def seen_along_z(points: Any) -> tuple[Projection, Array]:
    projection = Projection(Camera((0.0, 0.0, 9.0), (0.0, 0.0, 0.0)), image_size=(1280, 720))
    return projection, projection.trace(points).image


def square(z: float) -> PickSurface:
    points = np.array([(-1, -1, z), (1, -1, z), (1, 1, z), (-1, 1, z)], np.float32)
    return PickSurface(points, np.array([(0, 1, 2), (0, 2, 3)]))


def test_a_face_wins_over_a_line_behind_it_and_no_other() -> None:
    line = Lines([[(-3.0, 0.1, 0.0), (3.0, 0.1, 0.0)]])
    projection, ((x, y),) = seen_along_z([(0.2, 0.1, 0.0)])
    sight, pixel = Sight.of(projection), (float(x), float(y) + 2.0)

    def picked(z: float) -> Hit:
        hit = pick(square(z), line, sight, pixel)
        assert hit is not None
        return hit

    assert picked(1.0).point[2] == pytest.approx(1.0)  # in front of the line
    for z in (-1.0, 0.0):  # behind it, and under it
        assert picked(z).point == pytest.approx((0.2, 0.1, 0.0), abs=1e-12)


def test_a_click_on_a_face_ignores_a_line_beside_and_behind_it() -> None:
    projection, ((x, y), (edge, _)) = seen_along_z([(1.07, 0.0, -4.0), (1.0, 0.0, -3.5)])
    assert x - 2.5 < edge < x - 1.0
    line, sight = Lines([[(1.07, -3.0, -4.0), (1.07, 3.0, -4.0)]]), Sight.of(projection)
    hit = pick(square(-3.5), line, sight, (float(edge) - 0.4, float(y)))
    assert hit is not None and hit.point[2] == pytest.approx(-3.5)
    hit = pick(square(-3.5), line, sight, (float(x), float(y)))
    assert hit is not None and hit.point == pytest.approx((1.07, 0.0, -4.0), abs=1e-12)


def test_a_line_that_is_hidden_where_it_is_nearest_is_not_picked_beside_the_face() -> None:
    projection, ((x, y), (edge, _)) = seen_along_z([(1.093, 0.0, -1.0), (1.0, 0.0, 0.0)])
    assert edge - 2.0 < x < edge - 1.0
    line, sight = Lines([[(1.093, -3.0, -1.0), (1.093, 3.0, -1.0)]]), Sight.of(projection)
    pixel = float(edge) + 0.4, float(y)
    assert pick(square(0.0), line, sight, pixel) is None
    assert pick(NO_FACES, line, sight, pixel) is not None


def test_an_edge_of_a_face_that_leans_away_is_on_it() -> None:
    """Click just inside the farther edge of a floor, where the floor is nearer."""
    corners = np.array([(-4, 0, -4), (4, 0, -4), (4, 0, 4), (-4, 0, 4)], np.float32)
    floor = PickSurface(corners, np.array([(0, 1, 2), (0, 2, 3)]))
    projection = Projection(Camera((0.0, 3.0, 9.0), (0.0, 0.0, 0.0)), image_size=(1280, 720))
    x, y = projection.trace((0.3, 0.0, -4.0)).image.tolist()
    edge = Lines([[(-4.0, 0.0, -4.0), (4.0, 0.0, -4.0)]])
    hit = pick(floor, edge, Sight.of(projection), (x, y + 2.0))
    assert hit is not None and hit.point == pytest.approx((0.3, 0.0, -4.0), abs=1e-12)


def test_ends_come_before_lines_and_vertices_before_what_is_beside_or_behind_them() -> None:
    projection, ((x, y),) = seen_along_z([(1.0, 1.0, 0.0)])
    sight = Sight.of(projection)
    line = Lines([[(1.0, 1.0, 0.0), (9.0, 1.0, 0.0)]])
    hit = pick(NO_FACES, line, sight, (float(x) + 5.0, float(y)))
    assert hit is not None and hit.point == (1.0, 1.0, 0.0)
    hit = pick(NO_FACES, line, sight, (float(x) + 7.0, float(y)))
    assert hit is not None and hit.point[0] > 1.0
    assert pick(NO_FACES, line, sight, (float(x) + 7.0, float(y) + 3.5)) is None
    # A vertex of a face; the line is behind it, and then in front.
    for z, vertex in ((-0.5, 2), (0.5, None)):
        w = 9.0 - z
        line = Lines([[(-5.0, w / 9.0, z), (5.0, w / 9.0, z)]])
        hit = pick(square(0.0), line, sight, (float(x) + 2.0, float(y)))
        assert hit is not None and hit.vertex == vertex


def test_a_line_that_is_seen_end_on_is_picked_at_its_front() -> None:
    projection, ((x, y),) = seen_along_z([(0.0, 0.0, 0.0)])
    sight = Sight.of(replace(projection, lens=Perspective(45.0, 2.0, 30.0)))
    for end, picked in ((-5.0, -5.0), (-50.0, 7.0)):  # the visible end, and near
        line = Lines([[(0.0, 0.0, end), (0.0, 0.0, 50.0)]])  # passes through the eye
        hit = pick(NO_FACES, line, sight, (float(x), float(y)))
        assert hit is not None and hit.point == pytest.approx((0.0, 0.0, picked), abs=1e-9)


def test_a_scene_is_sorted_before_it_is_clicked() -> None:
    """Sorting ahead, also twice, does not change the pick."""
    scene = load("cube")
    sort_ahead(scene)
    sort_ahead(scene)
    x, y = scene.start.trace((0.5, 1.0, 0.5)).image.tolist()
    hit = pick_in(scene, scene.start, Sight.of(scene.start), (x, y))
    assert hit is not None and hit.point == pytest.approx((0.5, 1.0, 0.5))


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
def test_a_projector_is_one_pixel(lens: Lens) -> None:
    projection = Projection(CAMERA, lens, (1280, 720))
    point = (1.0, 2.0, 0.5)
    through = projection.trace(point)
    x, y = through.image.tolist()
    for probe in (Probe(1, point), Probe(2, pixel=(x, y))):
        line = projector(projection, probe, [1.5, 8.0, float(-through.view[2])])
        assert line is not None
        trace = projection.trace(line)
        assert trace.image == pytest.approx(np.tile(through.image, (3, 1)), abs=1e-9)
        assert -trace.view[:2, 2] == pytest.approx([1.5, 8.0], rel=1e-12)
        assert line[2] == pytest.approx(point, abs=1e-12)


def test_a_point_behind_the_eye_has_no_projector_and_cannot_be_dragged() -> None:
    projection = Projection(CAMERA, LENSES["perspective"], (1280, 720))
    for point in ((12.0, 8.0, 18.0), CAMERA.eye):
        assert projector(projection, Probe(1, point), [1.0]) is None
    assert dragged(projection, (12.0, 8.0, 18.0), (3.0, 0.0), along_ray=False) is None


def test_a_point_beside_the_eye_has_no_projector() -> None:
    """Its direction from the eye has numbers beyond float64."""
    projection = Projection(Camera((0.0, 0.0, 1e-300), (0.0, 0.0, 0.0)), LENSES["perspective"])
    for point in ((1e99, 0.0, 0.0), (-1e99, 1e99, 0.0)):
        assert projector(projection, Probe(1, point), [1.0, 1e100]) is None


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
    far, (_, _, bottom, top) = -before.view[2], projection.window
    farther = far * math.sqrt(2.0) if not lens.parallel else far + (top - bottom) * 90.0 / 720.0
    assert -after.view[2] == pytest.approx(farther, rel=1e-12)
    for down in (-1e9, 1e9):
        moved = dragged(projection, point, (0.0, down), along_ray=True)
        assert moved is None if not lens.parallel else moved is not None


@pytest.mark.parametrize("depth", ["opengl", "direct3d", "reversed"])
def test_a_ray_is_drawn_where_it_is_in_front_though_the_volume_reaches_infinity(depth: str) -> None:
    rows = (1.2, 0.1, 0.3, 0.0), (0.0, 1.5, 0.1, 0.2), (0.0, 0.0, -1.1, -2.2), (0.1, 0.0, -1.0, 0.3)
    projection = Projection(CAMERA, FreeMatrix(rows), (1280, 720), depth)  # type: ignore[arg-type]
    assert projection.frustum_sign == 0
    low, high = sorted(projection.depth_range)
    endless = 0
    for pixel in ((1200.0, 30.0), (640.0, 360.0), (20.0, 700.0), (20.0, 30.0), (1279.0, 719.0)):
        line = projector(projection, Probe(1, pixel=pixel), [0.0, 0.25, 1.0])
        assert line is not None
        trace = projection.trace(line)
        assert trace.in_front.all()
        assert (low - 1e-9 <= trace.ndc[:, 2]).all() and (trace.ndc[:, 2] <= high + 1e-9).all()
        assert trace.image == pytest.approx(np.tile(pixel, (3, 1)), abs=1e-6)
        at_end = [min(abs(z - low), abs(z - high)) < 1e-9 for z in trace.ndc[[0, 2], 2]]
        assert at_end[0]
        if not at_end[1]:
            endless += 1
            assert math.dist(line[0], line[2]) == pytest.approx(10.0 * CAMERA.distance)
        again = projector(projection, Probe(2, tuple(line[1].tolist())), [0.0, 1.0])
        assert again is not None and again == pytest.approx(line[[0, 2]], rel=1e-6, abs=1e-6)
    assert 0 < endless < 5, endless
    rows = (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, -1, 0)
    singular = replace(projection, lens=FreeMatrix(rows))
    assert projector(singular, Probe(1, pixel=(640.0, 360.0)), [0.0, 1.0]) is None


def test_the_lines_of_a_large_drawing_are_found_as_one_by_one(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    random = np.random.default_rng(4)
    ends = random.uniform(-4.0, 4.0, (700, 1, 3)) + random.uniform(-0.5, 0.5, (700, 2, 3))
    projection = Projection(Camera((1.0, 2.0, 5.0), (0.0, 0.0, 0.0)))
    sight = Sight.of(projection)
    pixels = random.uniform((0.0, 0.0), (1280.0, 720.0), (200, 2)).tolist()
    found = []
    for size in (1, 64, 1000):
        monkeypatch.setattr(picking, "CHUNK", size)
        lines = Lines(ends, (0.0, 0.5, 0.0))
        found.append([lines.near(sight, (x, y), 8.0, 4.0) for x, y in pixels])
    assert found[0] == found[1] == found[2] and sum(map(len, found[0])) > 40
