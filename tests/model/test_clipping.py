"""Clipping: what is left, by which plane, in exact rationals; and lecture 004's own way."""

import math
from fractions import Fraction
from itertools import product

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from app.model.clipping import (
    EYE_Z,
    LARGEST_CLIP,
    NOT_CUT,
    clip_polygon,
    clip_segments,
    cut_at_eye,
    naive_ndc,
)
from app.model.projection import DEPTH_RANGES, PLANES, Array, Camera, Perspective, Projection
from app.model.refusal import Refusal
from tests.support.lenses import LENSES
from tests.support.samples import pairwise

EPS = float(np.finfo(np.float64).eps)
Rational = tuple[Fraction, ...]

# --------------------------------------------------------------------------- the rational oracle


def rational(point: Array | tuple[float, ...]) -> Rational:
    return tuple(Fraction(float(part)) for part in point)


def room(point: Rational, plane: str, depth: str) -> Fraction:
    """How far inside a plane a point is, written out from -w <= x, y <= w and the range of z."""
    x, y, z, w = point
    if plane == "near":
        return {"opengl": z + w, "direct3d": z, "reversed": w - z}[depth]
    if plane == "far":
        return {"opengl": w - z, "direct3d": w - z, "reversed": z}[depth]
    return {"left": x + w, "right": w - x, "bottom": y + w, "top": w - y}[plane]


def between(start: Rational, end: Rational, t: Fraction) -> Rational:
    return tuple(a + (b - a) * t for a, b in zip(start, end, strict=True))


def visible_interval(
    start: Rational, end: Rational, depth: str, planes: tuple[str, ...] = PLANES
) -> tuple[Fraction, Fraction] | None:
    """The t of a segment at which every plane's room is at least 0."""
    low, high = Fraction(0), Fraction(1)
    for plane in planes:
        a, b = room(start, plane, depth), room(end, plane, depth)
        if a < 0 and b < 0:
            return None
        if a < 0:
            low = max(low, a / (a - b))
        elif b < 0:
            high = min(high, a / (a - b))
    return (low, high) if low <= high else None


DEPTHS = st.sampled_from(sorted(DEPTH_RANGES))
SMALL = st.integers(-6, 6).map(float)  # many points on planes, edges and corners
WIDE = st.one_of(
    st.floats(-3.0, 3.0),
    st.builds(
        lambda sign, mantissa, exponent: sign * mantissa * 10.0**exponent,
        st.sampled_from((-1.0, 1.0)),
        st.floats(1.0, 10.0),
        st.integers(-300, 305),
    ),
    st.just(0.0),
)
MODERATE = st.one_of(st.floats(-4.0, 4.0, width=32), st.floats(-1e6, 1e6), SMALL)


def points_of(numbers: st.SearchStrategy[float]) -> st.SearchStrategy[Array]:
    return st.tuples(numbers, numbers, numbers, numbers).filter(any).map(np.array)


def opposite(start: Array, end: Array) -> bool:
    """Whether the ends are one point of space, or float64 cannot tell that they are not."""
    scaled = start / np.abs(start).max() + end / np.abs(end).max()
    return bool((np.abs(scaled) <= 1e-9).all())


# --------------------------------------------------------------------------- segments


@given(
    start=st.one_of(points_of(SMALL), points_of(WIDE)),
    end=st.one_of(points_of(SMALL), points_of(WIDE)),
    depth=DEPTHS,
)
@example(np.array([-2.0, 0, 0, 1]), np.array([0.0, 2, 0, 1]), "opengl")  # through an edge
@example(np.array([0.0, 1, 0, 1]), np.array([0.0, 0, 0, -1e16]), "direct3d")  # leaves at 0
@example(np.array([-3.0, -1, 1, 1]), np.array([1.0, 1, -1, -1]), "opengl")
def test_what_is_visible_agrees_with_rationals(start: Array, end: Array, depth: str) -> None:
    """The verdict is exact, the parameters keep 4 ulp from whichever end they are near."""
    assume(not opposite(start, end))
    got = clip_segments(start, end, depth)
    exact = visible_interval(rational(start), rational(end), depth)
    assert got.visible == (exact is not None)
    beyond = [all(room(rational(p), plane, depth) < 0 for p in (start, end)) for plane in PLANES]
    assert got.outside.tolist() == beyond
    if exact is None:
        assert np.isnan(got.t).all() and np.isnan(got.points_clip).all()
        assert ((got.planes != NOT_CUT) == (not any(beyond))).all()
        return
    for number, true in zip(got.t, exact, strict=True):
        assert abs(Fraction(float(number)) - true) <= 4 * EPS * true + Fraction(5e-324)
    for end_index, t in enumerate(exact):
        plane = got.planes[end_index]
        if plane == NOT_CUT:
            assert t == (0, 1)[end_index]
            assert np.array_equal(got.points_clip[end_index], (start, end)[end_index])
        else:  # the plane that cut is the one met there, up to the rounding of a tie
            a, b = (room(rational(p), PLANES[plane], depth) for p in (start, end))
            assert abs(a / (a - b) - t) <= 8 * EPS
            assert (a < 0) == (end_index == 0)


@given(
    place=st.tuples(*[st.floats(-1.0, 1.0)] * 3),
    exponent=st.integers(-300, 300),
    end=st.one_of(points_of(WIDE), points_of(MODERATE)),
    depth=DEPTHS,
)
def test_a_cut_end_lies_on_its_plane_and_on_the_segment(
    place: tuple[float, ...], exponent: int, end: Array, depth: str
) -> None:
    """From inside: on its plane to the last bit, on the segment within 8 ulp of the larger end."""
    x, y, z = place
    w = 10.0**exponent
    start = np.array([x, y, z if depth == "opengl" else abs(z), 1.0]) * w
    assume(not opposite(start, end))
    got = clip_segments(start, end, depth)
    assert got.visible
    for point, plane, t in zip(got.points_clip, got.planes, got.t, strict=True):
        if plane == NOT_CUT:
            continue
        assert room(rational(point), PLANES[plane], depth) == 0
        true = between(rational(start), rational(end), Fraction(float(t)))
        size = max(abs(x) for x in (*rational(start), *rational(end)))
        assert max(abs(a - b) for a, b in zip(rational(point), true, strict=True)) <= (
            8 * EPS * size
        )


@given(
    start=st.one_of(points_of(SMALL), points_of(WIDE)),
    end=st.one_of(points_of(SMALL), points_of(WIDE)),
    depth=DEPTHS,
)
def test_a_segment_and_its_reverse_are_cut_at_the_same_points(
    start: Array, end: Array, depth: str
) -> None:
    assume(not opposite(start, end))
    one, other = clip_segments(start, end, depth), clip_segments(end, start, depth)
    assert one.visible == other.visible
    assert np.array_equal(one.points_clip, other.points_clip[::-1], equal_nan=True)
    assert one.planes.tolist() == other.planes[::-1].tolist()
    assert one.outside.tolist() == other.outside.tolist()


@given(start=points_of(MODERATE), end=points_of(MODERATE), depth=DEPTHS, data=st.data())
def test_only_the_planes_asked_for_cut(
    start: Array, end: Array, depth: str, data: st.DataObject
) -> None:
    assume(not opposite(start, end))
    planes = tuple(data.draw(st.lists(st.sampled_from(PLANES), unique=True)))
    got = clip_segments(start, end, depth, planes)
    exact = visible_interval(rational(start), rational(end), depth, planes)
    assert got.visible == (exact is not None)
    assert {PLANES[i] for i in got.planes if i != NOT_CUT} <= set(planes)
    if exact is not None:
        assert got.t.tolist() == pytest.approx([float(t) for t in exact], rel=1e-15)


def test_many_segments_are_cut_as_each_alone() -> None:
    rng = np.random.default_rng(7)
    starts = rng.normal(size=(40, 5, 4)) * 2.0
    ends = rng.normal(size=(40, 5, 4)) * 2.0
    many = clip_segments(starts, ends, "reversed")
    assert many.t.shape == (40, 5, 2) and many.outside.shape == (40, 5, 6)
    for index in np.ndindex(40, 5):
        one = clip_segments(starts[index], ends[index], "reversed")
        for whole, part in zip(many, one, strict=True):
            assert np.array_equal(whole[index], part, equal_nan=True)
    fan = clip_segments(starts[0, 0], ends)  # one start for all
    assert np.array_equal(fan.visible[3], clip_segments(starts[0, 0], ends[3]).visible)
    assert clip_segments(np.empty((0, 4)), np.empty((0, 4))).points_clip.shape == (0, 2, 4)


def test_l15_each_plane_cuts_where_its_name_says() -> None:
    """A ray from the cube's centre to beyond each face, for every range of z."""
    for depth, (z_near, z_far) in DEPTH_RANGES.items():
        centre = np.array([0.0, 0.0, (z_near + z_far) / 2.0, 1.0])
        for index, plane in enumerate(PLANES):
            direction = np.zeros(4)
            axis = (2, 2, 0, 0, 1, 1)[index]
            face = (z_near, z_far, -1.0, 1.0, -1.0, 1.0)[index]
            direction[axis] = face - centre[axis]
            got = clip_segments(centre, centre + 4.0 * direction, depth)
            assert got.planes.tolist() == [NOT_CUT, index]
            assert got.t.tolist() == [0.0, 0.25]
            beyond = clip_segments(centre + 2.0 * direction, centre + 3.0 * direction, depth)
            assert not beyond.visible
            assert np.flatnonzero(beyond.outside).tolist() == [index], plane


# --------------------------------------------------------------------------- lenses, w <= 0

CAMERA = Camera((3.0, 2.0, 5.0), (0.0, 0.0, 0.0))


@pytest.mark.parametrize(("name", "depth"), pairwise(product(LENSES, DEPTH_RANGES))[:12])
def test_the_visible_part_is_what_the_trace_calls_inside(name: str, depth: str) -> None:
    """Points of random world segments, many through the eye plane, against `Trace.outside`."""
    lens = LENSES[name]
    projection = Projection(CAMERA, lens, (800, 600), depth)
    rng = np.random.default_rng(11)
    starts, ends = rng.uniform(-9.0, 9.0, (2, 300, 3))
    first, last = projection.trace(starts), projection.trace(ends)
    got = clip_segments(first.clip, last.clip, depth)
    share = np.linspace(0.0, 1.0, 41)[:, None]
    for start, end, visible, (t0, t1) in zip(starts, ends, got.visible, got.t, strict=True):
        trace = projection.trace(start + share * (end - start))
        inside = ~trace.outside.any(axis=-1)
        expected = (share[:, 0] >= t0) & (share[:, 0] <= t1) & visible
        near_a_cut = np.abs(share - (t0, t1)).min(axis=-1) < 1e-9
        assert (inside == expected)[~near_a_cut].all()
    crossing = (first.clip[:, 3] > 0.0) != (last.clip[:, 3] > 0.0)
    assert crossing.any() == lens.central
    assert (got.points_clip[got.visible][..., 3] > 0.0).all()
    assert got.visible[crossing].any() or lens.parallel


def test_with_an_infinite_far_plane_nothing_is_cut_by_far() -> None:
    """The horizon itself lies on the far plane, which is inside."""
    for depth in DEPTH_RANGES:
        lens = Projection(
            Camera((0, 0, 0), (0, 0, -1)), Perspective(60.0, 0.5, math.inf), depth=depth
        )  # type: ignore[arg-type]
        start = lens.clip_from_world @ (0.0, 0.0, -1.0, 1.0)
        got = clip_segments(start, lens.clip_from_world @ (0.0, 0.0, -1.0, 0.0), depth)
        assert got.planes.tolist() == [NOT_CUT, NOT_CUT]


def test_planes_without_a_pair_may_leave_what_lies_behind_the_eye() -> None:
    """Far alone does not cut what is behind the eye: it is nearer than far."""
    got = clip_segments((0.0, 0.0, 0.5, 1.0), (0.0, 0.0, -2.0, -1.0), planes=("far",))
    assert got.visible and got.points_clip[1, 3] == -1.0
    pair = clip_segments((0.0, 0.0, 0.5, 1.0), (0.0, 0.0, -2.0, -1.0), planes=("left", "right"))
    assert pair.points_clip[1, 3] == 0.0 or pair.points_clip[1, 3] > 0.0


# --------------------------------------------------------------------------- degenerate segments


def test_a_segment_that_is_a_point_or_lies_in_a_plane() -> None:
    inside = clip_segments((0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 0.0, 1.0))
    assert inside.visible and inside.t.tolist() == [0.0, 1.0]
    assert inside.planes.tolist() == [NOT_CUT, NOT_CUT]
    beyond = clip_segments((0.0, 3.0, 0.0, 1.0), (0.0, 3.0, 0.0, 1.0))
    assert [PLANES[i] for i in np.flatnonzero(beyond.outside)] == ["top"]
    got = clip_segments((1.0, -3.0, 0.0, 1.0), (1.0, 1.0, 0.0, 1.0))
    assert got.visible and got.t.tolist() == [0.5, 1.0]
    assert PLANES[got.planes[0]] == "bottom"


def test_a_segment_that_touches_a_corner_is_one_point() -> None:
    """x + y = 2 in the plane z = w meets the cube in (1, 1, 1) alone, at t = 1/3."""
    got = clip_segments((0.0, 2.0, 1.0, 1.0), (3.0, -1.0, 1.0, 1.0))
    assert got.visible and got.t.tolist() == pytest.approx([1 / 3, 1 / 3], rel=1e-15)
    past = clip_segments((0.0, 2.0 + 4.0 * EPS, 1.0, 1.0), (3.0, -1.0, 1.0, 1.0))
    assert not past.visible and not past.outside.any()
    assert {PLANES[i] for i in past.planes} == {"top", "right"}


@pytest.mark.parametrize(
    ("start", "end", "field"),
    [
        ((math.nan, 0, 0, 1), (0, 0, 0, 1), "starts_clip"),
        ((0, 0, 0, 1), (0, math.inf, 0, 1), "ends_clip"),
        ((0, 0, 0, 1), (0, 0, 2 * LARGEST_CLIP, 1), "ends_clip"),
        ((0, 0, 0, 0), (0, 0, 0, 1), "starts_clip"),
        ((0, 0, 0, 1), (0, 0, 1), "ends_clip"),
        ((1, 2, 3, 4), (-3, -6, -9, -12), "ends_clip"),
        ((0.1, 0.2, 0.3, 0.7), (-0.1, -0.2, -0.3, -0.7), "ends_clip"),
    ],
)
def test_an_impossible_end_is_named(start: object, end: object, field: str) -> None:
    with pytest.raises(Refusal) as error:
        clip_segments(start, end)  # type: ignore[arg-type]
    assert error.value.field == field


def test_an_unknown_plane_or_depth_range_is_named() -> None:
    point = (0.0, 0.0, 0.0, 1.0)
    with pytest.raises(Refusal, match=r"planes = 'front': must be one of near, far"):
        clip_segments(point, point, planes=("front",))
    with pytest.raises(Refusal, match=r"depth = 'vulkan': must be one of opengl"):
        clip_segments(point, point, "vulkan")
    with pytest.raises(Refusal, match="depth"):
        clip_polygon([point, point, point], depth=None)  # type: ignore[arg-type]


# --------------------------------------------------------------------------- polygons


def regular(n: int, tilt: Array, shift: Array) -> Array:
    """A convex polygon in a plane of clip space's affine part, homogeneous by `tilt`."""
    angle = 2.0 * np.pi * np.arange(n) / n
    flat = np.column_stack([np.cos(angle), np.sin(angle), np.ones(n)])
    return np.round(flat @ tilt + shift, 6)


def inside_planes(points: Array, depth: str, slack: float) -> bool:
    return all(
        room(rational(p), plane, depth) >= -Fraction(slack) for p in points for plane in PLANES
    )


@given(
    n=st.integers(3, 7),
    seed=st.integers(0, 2**32 - 1),
    depth=DEPTHS,
    spread=st.sampled_from((0.5, 1.5, 4.0)),
)
def test_a_clipped_polygon(n: int, seed: int, depth: str, spread: float) -> None:
    """Every corner inside and in the polygon's own plane; nothing that is visible is lost."""
    rng = np.random.default_rng(seed)
    polygon = regular(n, rng.normal(size=(3, 4)) * spread, np.array([0, 0, 0, 1.0]))
    got = clip_polygon(polygon, depth)
    assert len(got.edges) == len(got.points_clip)
    assert inside_planes(got.points_clip, depth, 1e-13)
    for i, plane in enumerate(got.edges):
        if plane is not None:  # both ends of an edge that a plane made lie in it
            for point in (got.points_clip[i], got.points_clip[(i + 1) % len(got.edges)]):
                error = abs(room(rational(point), plane, depth))
                assert error <= 4 * EPS * np.abs(polygon).max()
    # Membership by an independent way: the corner's coordinates in the polygon's own 3-space.
    basis = np.linalg.lstsq(polygon.T, got.points_clip.T, rcond=None)
    assert np.allclose(polygon.T @ basis[0], got.points_clip.T, atol=1e-11)
    # Random convex combinations of the corners: visible ones lie in the result, and only they.
    weights = rng.dirichlet(np.ones(n), size=30)
    for point in weights @ polygon:
        rooms = [float(room(rational(point), plane, depth)) for plane in PLANES]
        if min(map(abs, rooms)) < 1e-9:
            continue
        assert in_cone(point, got.points_clip) == (min(rooms) > 0)


def in_cone(point: Array, corners: Array) -> bool:
    """Whether a point is a positive combination of a convex polygon's corners (a fan of them)."""
    for i in range(1, len(corners) - 1):
        triangle = corners[[0, i, i + 1]]
        weights, _, rank, _ = np.linalg.lstsq(triangle.T, point, rcond=None)
        if rank == 3 and (weights >= -1e-7 * np.abs(weights).max()).all():
            return True
    return False


def square(low: float, high: float, z: float = 0.0) -> list[tuple[float, ...]]:
    return [(low, low, z, 1), (high, low, z, 1), (high, high, z, 1), (low, high, z, 1)]


FACE = [(1.0, -1.0, -1.0, 1.0), (1.0, 1.0, -1.0, 1.0), (1.0, 1.0, 1.0, 1.0), (1.0, -1.0, 1.0, 1.0)]
DIAMOND = [(0.0, 0.0, 0.0, 1.0), (1.0, -0.5, 0.0, 1.0), (2.0, 0.0, 0.0, 1.0), (1.0, 0.5, 0.0, 1.0)]


@pytest.mark.parametrize(
    ("polygon", "left", "edges"),
    [
        (square(0, 2), square(0, 1), (None, "right", "top", None)),  # over a corner
        (FACE, FACE, (None,) * 4),  # in a plane
        # Its diagonal lies on x = w: cutting there makes no new corner.
        (DIAMOND, [DIAMOND[0], DIAMOND[1], DIAMOND[3]], (None, "right", None)),
        ([(1.0, -0.5, 0, 1), (2.0, 0, 0, 1), (1.0, 0.5, 0, 1)], [], ()),  # it only touches a side
        ([(1.0, 1.0, 0, 1), (2.0, 1.5, 0, 1), (1.5, 2.0, 0, 1)], [], ()),  # or a corner
    ],
)
def test_polygons_cut_by_hand(polygon: object, left: object, edges: tuple[str | None, ...]) -> None:
    got = clip_polygon(polygon)  # type: ignore[arg-type]
    assert np.array_equal(got.points_clip, np.reshape(left, (-1, 4)))
    assert got.edges == edges


@given(seed=st.integers(0, 2**32 - 1), depth=DEPTHS)
def test_neighbours_are_cut_at_the_same_points(seed: int, depth: str) -> None:
    """Two triangles on one edge: no crack, bit for bit, and as the edge clipped alone."""
    rng = np.random.default_rng(seed)
    a, b, c, d = rng.uniform(-3, 3, (4, 4))
    left = {tuple(p) for p in clip_polygon([a, b, c], depth).points_clip.tolist()}
    right = {tuple(p) for p in clip_polygon([b, a, d], depth).points_clip.tolist()}
    edge = clip_segments(a, b, depth)
    on_edge = [p for p in edge.points_clip.tolist() if edge.visible]
    for point in on_edge:
        near = [p for p in left if np.allclose(p, point, rtol=0, atol=1e-12)]
        assert near and all(p in right for p in near)


@pytest.mark.parametrize(
    "polygon",
    [
        [(0, 0, 0, 1), (1, 0, 0, 1)],
        (0, 0, 0, 1),
        [(0, 0, 0, 1), (1, 0, 0, 1), (0, math.nan, 0, 1)],
        [(0, 0, 0, 1), (1, 0, 0, 1), (-1, 0, 0, -1)],
    ],
)
def test_an_impossible_polygon_is_named(polygon: object) -> None:
    with pytest.raises(Refusal) as error:
        clip_polygon(polygon)  # type: ignore[arg-type]
    assert error.value.field == "points_clip"


# --------------------------------------------------------------------------- lecture 004


def test_l16_004_four_cases() -> None:
    """1 both in front, 2 both behind, 3 from behind to the front, 4 from the front to behind."""
    front, back = (1.0, 2.0, -3.0), (5.0, 0.0, 1.0)
    got = cut_at_eye([front, back, back, front], [front, back, front, back])
    assert got.case.tolist() == [1, 2, 3, 4]
    assert got.points_view[0].tolist() == [list(front), list(front)]
    assert np.isnan(got.points_view[1]).all()
    assert got.points_view[2, 1].tolist() == list(front)
    assert got.points_view[3, 0].tolist() == list(front)
    assert got.points_view[2, 0].tolist() == got.points_view[3, 1].tolist()


def test_l16_004_the_point_of_the_cut() -> None:
    """(0, 0, 1) to (4, 2, -3): t = (1 + 0.01)/(1 + 3) = 0.2525, x = 1.01, y = 0.505."""
    got = cut_at_eye((0.0, 0.0, 1.0), (4.0, 2.0, -3.0))
    assert got.case == 3
    assert got.points_view[0].tolist() == pytest.approx([1.01, 0.505, -0.01], rel=1e-15)
    assert got.points_view[0, 2] == EYE_Z == -0.01


def test_lecture_004_on_the_cut_itself_is_in_front() -> None:
    on = (1.0, 1.0, EYE_Z)
    assert cut_at_eye(on, (0.0, 0.0, 2.0)).case == 4
    assert cut_at_eye(on, (0.0, 0.0, 2.0)).points_view[1].tolist() == list(on)
    assert cut_at_eye(on, on).case == 1
    huge = cut_at_eye((1e300, 0.0, 1e300), (0.0, 0.0, -1e300))
    assert huge.points_view[0].tolist() == [5e299, 0.0, EYE_Z]


def test_l16_004_cut_draws_what_clipping_draws() -> None:
    """With near = 0.01 the lecture's plane is the near plane: the same ends on the picture."""
    lens = Projection(Camera((0, 0, 0), (0, 0, -1)), Perspective(60.0, 0.01, 40.0))
    rng = np.random.default_rng(3)
    starts, ends = rng.uniform(-2, 2, (2, 200, 3))
    eye = cut_at_eye(starts, ends)
    drawn = eye.case != 2
    clip = clip_segments(lens.trace(starts).clip, lens.trace(ends).clip, planes=("near",))
    assert clip.visible.tolist() == drawn.tolist()
    ndc = lens.trace(eye.points_view[drawn]).ndc
    assert np.allclose(ndc, naive_ndc(clip.points_clip[drawn]), rtol=1e-9, atol=1e-9)


def test_the_naive_divide_mirrors_what_lies_behind() -> None:
    """(1, 2) at 4 behind the eye is drawn where (-1, -2) at 4 ahead belongs."""
    lens = Projection(Camera((0, 0, 0), (0, 0, -1)), Perspective(60.0, 0.5, 40.0))
    behind, ahead = lens.trace([[1.0, 2.0, 4.0], [-1.0, -2.0, -4.0]]).clip
    assert naive_ndc(behind)[:2].tolist() == naive_ndc(ahead)[:2].tolist()
    assert np.isnan(naive_ndc([[1.0, 0.0, 0.0, 0.0], [1e300, 0.0, 0.0, 1e-300]])).all()
