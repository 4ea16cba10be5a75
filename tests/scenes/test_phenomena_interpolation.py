"""Interpolation's readings, against maxima that are searched for."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import mpmath
import numpy as np
import pytest

from app.model.projection import Array, Camera, Perspective, Projection
from app.scenes.phenomena.illustration import Illustration, OwnMesh, Subject
from app.scenes.phenomena.interpolation import (
    PHENOMENON,
    TEXELS,
    edge_error,
    largest_errors,
    planar_texture,
)

BOARD = np.array([(-5.0, 0, 5), (5, 0, 5), (5, 0, -5), (-5, 0, -5)])
SUBJECT = Subject((-5.0, 0.0, -5.0), (5.0, 0.0, 5.0), BOARD[[3, 0, 2, 1]])
TRIANGLES = np.array([BOARD[[0, 1, 3]], BOARD[[1, 2, 3]]])
BOARD_TEXTURE = planar_texture(SUBJECT)


def shown(projection: Projection, subject: Subject = SUBJECT, **settings: object) -> Illustration:
    return PHENOMENON.show(projection, PHENOMENON.checked(settings), subject)


def random_projection(random: np.random.Generator) -> Projection:
    eye = (random.uniform(-5, 5), random.uniform(1, 8), random.uniform(8, 15))
    target = (random.uniform(-2, 2), random.uniform(-1, 1), random.uniform(-4, 2))
    lens = Perspective(random.uniform(30, 80), 0.2, 100.0)
    return Projection(Camera(eye, target, (0.0, 1.0, 0.0)), lens, (1280, 720))


def test_the_error_of_an_edge_is_the_largest_difference() -> None:
    """The formula against a search for the maximum, at 40 digits."""
    with mpmath.workdps(40):
        for k in (0.02, 0.5, 1.0001, 2.0, 3.7, 40.0, 1e6):
            ratio = mpmath.mpf(k)

            def off(sigma: mpmath.mpf, ratio: mpmath.mpf = ratio) -> mpmath.mpf:
                return sigma - sigma / ((1 - sigma) * ratio + sigma)

            root = mpmath.sqrt(ratio)
            at = root / (root + 1)
            largest = abs(off(at))
            for step in np.linspace(0.0, 1.0, 2001).tolist():
                assert abs(off(mpmath.mpf(step))) <= largest * (1 + mpmath.mpf(10) ** -30)
            assert float(edge_error(np.array(k))) == pytest.approx(float(largest), rel=1e-10)


def own(triangles: Array, more: bool = False) -> Subject:
    """A mesh of the user's; its first edge is its longest, as a scene hands it out."""
    points = triangles.reshape(-1, 3)
    low, high = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    edges = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2, 3)
    edges = edges[np.argsort(-np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1))]
    return Subject(tuple(low), tuple(high), points, OwnMesh(edges, len(edges), triangles, more))


def parts_of(triangle: Array, parts: int) -> Iterator[Array]:
    """The small triangles that a triangle is cut into."""
    a, b, c = triangle
    ab, ac = (b - a) / parts, (c - a) / parts
    for i in range(parts):
        for j in range(parts - i):
            corner = a + i * ab + j * ac
            yield np.array([corner, corner + ab, corner + ac])
            if i + j < parts - 1:
                yield np.array([corner + ab, corner + ab + ac, corner + ac])


def searched(
    projection: Projection, triangles: Array, texture: Array, parts: int, dice: np.random.Generator
) -> tuple[float, float]:
    """The largest errors, in texels and px, over points of all triangles and along all edges."""
    texels = px = 0.0
    line = np.linspace(0.0, 1.0, 801)
    edges = [np.zeros((801, 3)) for _ in range(3)]
    for i, edge in enumerate(edges):
        edge[:, i], edge[:, (i + 1) % 3] = line, 1.0 - line
    weights = np.concatenate([dice.dirichlet((0.6, 0.6, 0.6), 400), *edges])
    for corners in (small for each in triangles for small in parts_of(each, parts)):
        trace = projection.trace(corners)
        w = -trace.view[:, 2]
        correct = weights / w / (weights / w).sum(axis=1, keepdims=True)
        st: Array = (weights - correct) @ (corners @ texture[:, :3].T)
        texels = max(texels, float(np.hypot(*st.T).max()) * TEXELS)
        placed = weights * w / (weights * w).sum(axis=1, keepdims=True)
        px = max(px, float(np.hypot(*((weights - placed) @ trace.image).T).max()))
    return texels, px


def test_the_largest_errors_are_those_that_a_search_finds() -> None:
    """Of the board and of meshes: neither larger inside a triangle nor missed on an edge."""
    random = np.random.default_rng(23)
    meshes = 0
    for number in range(60):
        projection, parts = random_projection(random), (1, 2, 3, 5)[number // 2 % 4]
        triangles, subject = TRIANGLES, SUBJECT
        if number % 2:
            triangles = random.uniform((-4.0, -1.0, -5.0), (4.0, 2.0, 5.0), (3, 3, 3))
            subject = own(triangles)
        if projection.trace(triangles).outside[..., 0].any():
            continue
        meshes += number % 2
        texture = planar_texture(subject)
        found = largest_errors(projection, triangles, texture, parts)
        assert found is not None
        most = searched(projection, triangles, texture, parts, random)
        assert all(most[i] <= found[i] * (1.0 + 1e-9) for i in range(2))
        assert most == pytest.approx(found, rel=1e-4)
        readings = shown(projection, subject, subdivision=parts).readings
        assert (readings[0].value, readings[1].value) == found
    assert meshes > 10


def test_half_way_on_the_screen_is_less_in_the_world() -> None:
    """1/(k + 1) of the edge, k = w_b/w_a: the place that is drawn half-way between the ends."""
    random = np.random.default_rng(9)
    marked = 0
    for _ in range(50):
        projection = random_projection(random)
        illustration = shown(projection)
        ends = projection.trace(BOARD[[0, 3]])
        part = float(illustration.readings[2].value) / 100.0  # type: ignore[arg-type]
        place = BOARD[0] + part * (BOARD[3] - BOARD[0])
        assert projection.trace(place).image == pytest.approx(ends.image.mean(axis=0), abs=1e-8)
        world = illustration.world.dots
        assert world[1].point == pytest.approx(place)
        assert world[0].point == pytest.approx((BOARD[0] + BOARD[3]) / 2.0)
        halves = projection.trace(np.array([world[0].point, place]))
        expected = halves.image[~halves.outside.any(axis=1)]
        drawn = [dot.point for dot in illustration.image.dots]
        assert np.ravel(drawn) == pytest.approx(np.ravel(expected))
        marked += len(drawn)
    assert 50 < marked < 100


def test_points_outside_the_view_volume_are_not_marked_in_the_picture() -> None:
    start = PHENOMENON.start
    near_by = shown(replace(start, lens=replace(start.lens, far=5.0))).image
    assert near_by.lines == near_by.dots == near_by.texts == ()
    half = shown(replace(start, lens=replace(start.lens, far=10.0))).image
    assert len(half.lines) == 1 and len(half.dots) == len(half.texts) == 1
    ends = shown(start).image.lines[0].points
    assert 0.1 < np.ptp(half.lines[0].points[:, 1]) / np.ptp(ends[:, 1]) < 0.9


def test_twice_as_many_parts_leave_a_quarter_in_the_limit_and_more_before() -> None:
    """As the explanation says, of both readings."""
    assert "more than a quarter" in PHENOMENON.words.explanation and "in the limit" in (
        PHENOMENON.words.explanation
    )
    errors = [
        largest_errors(PHENOMENON.start, TRIANGLES, BOARD_TEXTURE, parts)
        for parts in (1, 2, 4, 8, 16, 32, 64)
    ]
    left = np.array([np.divide(after, before) for before, after in pairwise(errors)])  # type: ignore[arg-type]
    assert (left > 0.25).all() and (np.diff(left, axis=0) < 0.0).all()
    assert left[0].min() > 0.3 and left[-1].max() < 0.262


def test_triangles_that_near_cuts_have_no_error() -> None:
    above = Camera((0.0, 1.0, 3.0), (0.0, 0.5, -4.0), (0.0, 1.0, 0.0))
    for subject, name in ((SUBJECT, "the board"), (own(TRIANGLES), "the mesh")):
        illustration = shown(replace(PHENOMENON.start, camera=above), subject)
        assert illustration.warning is not None and not illustration.image.dots
        assert illustration.warning.template.startswith(name)
        assert all(reading.value is None and reading.note for reading in illustration.readings)
        assert illustration.rendering is not None and illustration.rendering.texture is not None


def test_a_mesh_has_its_texture_over_its_two_largest_extents() -> None:
    tall = Subject((1.0, 2.0, 3.0), (2.0, 12.0, 8.0), np.zeros((3, 3)))
    matrix = planar_texture(tall)
    low, high = np.array([*tall.lower, 1.0]), np.array([*tall.upper, 1.0])
    assert (matrix @ low).tolist() == pytest.approx([0.0, 0.0])
    assert (matrix @ high).tolist() == pytest.approx([1.0, 1.0])
    assert not matrix[:, 0].any(), "x is the smallest extent"
    needle = planar_texture(Subject((0.0, 0.0, 0.0), (0.0, 4.0, 0.0), np.zeros((2, 3))))
    assert np.isfinite(needle).all()


def test_the_longest_edge_of_a_mesh_is_marked() -> None:
    random = np.random.default_rng(31)
    for _ in range(20):
        projection = random_projection(random)
        subject = own(random.uniform((-4.0, -1.0, -5.0), (4.0, 2.0, 5.0), (3, 3, 3)))
        assert subject.mesh is not None
        longest = subject.mesh.edges[0]
        if projection.trace(longest).outside[:, 0].any():
            continue
        longest = longest[np.argsort(projection.trace(longest).clip[:, 3])]  # from the nearer end
        illustration = shown(projection, subject)
        said, part = illustration.readings[0].note, illustration.readings[2].value
        assert isinstance(part, float)
        half = longest[0] + part / 100.0 * (longest[1] - longest[0])
        ends = projection.trace(longest).image
        assert projection.trace(half).image == pytest.approx(ends.mean(axis=0), abs=1e-8)
        assert illustration.world.dots[1].point == pytest.approx(half, abs=1e-9)
        if not projection.trace(subject.points).outside[:, 0].any():
            assert said is not None and "two largest extents" in said.template and not said.values


def test_a_large_mesh_examines_as_many_triangles_as_it_says() -> None:
    random = np.random.default_rng(5)
    triangles = random.uniform((-4.0, -1.0, -5.0), (4.0, 2.0, 5.0), (1000, 3, 3))
    for parts, count in ((1, 1000), (4, 250), (64, 15)):
        readings = shown(PHENOMENON.start, own(triangles, True), subdivision=parts).readings
        first = shown(PHENOMENON.start, own(triangles[:count]), subdivision=parts).readings
        assert readings[0].note is not None and readings[0].note.values == (str(count),)
        assert readings[1].value == first[1].value


def test_l18_one_over_w_and_the_depth_are_straight_along_the_edge() -> None:
    """By hand: w from 2.5 to 12.5, n = 1, f = 25.

    003: 1/w at t = 1/2 is (1/2.5 + 1/12.5)/2 = 0.24, and were w linear there, 1/7.5. 000, (12):
    z' = 26/24 - 50/24/w, which is 0.25, 14/24 and 22/24 at t = 0, 1/2 and 1.
    """
    projection = Projection(Camera((0.0, 3.0, 7.5), (0.0, 3.0, 0.0)), Perspective(60.0, 1.0, 25.0))
    inverse, depth = shown(projection).diagrams
    for diagram, curve, expected in (
        (inverse, 0, (0.4, 0.24, 0.08)),
        (inverse, 1, (0.4, 1 / 7.5, 0.08)),
        (depth, 0, (0.25, 14 / 24, 22 / 24)),
    ):
        points = diagram.curves[curve].points
        assert points[[0, 16, 32]] == pytest.approx(
            np.column_stack([(0.0, 0.5, 1.0), expected]), abs=1e-12
        )
        assert (diagram.left, diagram.right) == (0.0, 1.0)
        assert (diagram.bottom <= points[:, 1]).all() and (points[:, 1] <= diagram.top).all()
    assert [(spot.x, spot.y) for spot in (*inverse.spots, *depth.spots)] == [
        (0.5, pytest.approx(0.24)),
        (0.5, pytest.approx(14 / 24)),
    ]


def test_l18_they_are_straight_from_anywhere_and_only_for_a_lens_with_an_eye() -> None:
    for depth, eye in (
        ("opengl", (1.5, 4.0, 10.0)), ("direct3d", (9.0, 2.0, 6.5)), ("reversed", (-3.0, 7.0, 8.0))
    ):  # fmt: skip
        seen = replace(PHENOMENON.start, camera=Camera(eye, (0.0, 0.0, 0.5))).with_depth(depth)
        diagrams = shown(seen).diagrams
        assert len(diagrams) == 2
        for diagram in diagrams:
            y = diagram.curves[0].points[:, 1]
            assert abs(np.diff(y, 2)).max() < 1e-13 and abs(y[-1] - y[0]) > 0.01
    assert not shown(PHENOMENON.start.with_lens("orthographic")).diagrams


def test_the_depths_of_the_lecture_stand_at_the_ends_and_at_half_of_the_screen() -> None:
    """003: 1/z_3 = (1/z_1 + 1/z_2)/2."""
    start = PHENOMENON.start
    places = {text.name: text.point for text in shown(start).world.texts}
    z_1, z_2, z_3 = (float(start.trace(places[f"z_{i}"]).view[2]) for i in (1, 2, 3))
    assert z_2 < z_3 < z_1 < 0.0 and 1 / z_3 == pytest.approx((1 / z_1 + 1 / z_2) / 2)
