"""The arithmetic precisions against an oracle of hundreds of digits, and their predicted errors."""

import itertools
import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.arithmetic import double_double as dd
from app.model.chain import FiveTiles
from app.model.eye_first import EyeFirst
from app.model.infinity import trace_at_infinity
from app.model.limits import SMALLEST, SMALLEST_FIELD, SMALLEST_WINDOW, DepthRange
from app.model.projection import (
    DEPTH_RANGES,
    LARGEST,
    LENSES,
    PLANES,
    Array,
    Camera,
    FreeMatrix,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
    Trace,
    Vector,
)
from app.model.refusal import Refusal
from app.model.typed_cells import TypedCells
from app.precision.levels import (
    DRAWING_TOLERANCE_PX,
    PRECISIONS,
    READING_TOLERANCE_DEPTH,
    READING_TOLERANCE_PX,
    Precision,
    drawing_bounds_px,
    precision_for_reading,
    predict,
    trace,
    trace_homogeneous,
)
from app.scenes.scene import BUILT_IN, load
from tests.oracles import exact
from tests.support import lenses as samples
from tests.support.bounds import drawing_bound_px
from tests.support.lenses import ONE_OF_EACH, SLANTED, at_distance, free_matrix, in_world, made
from tests.support.reference import Reference
from tests.support.samples import pairwise

HD = (1920, 1080)
# With coordinates up to 1e100 and windows down to 1e-205, what is left of a true zero must still
# be below the smallest float64.
DIGITS = 700
NOTHING = exact.mp.mpf(10) ** -330


# --------------------------------------------------------------------------- the truth


def truth(projection: Projection, points: Array, digits: int = DIGITS) -> list[list[Any]]:
    """View 3, clip 4, NDC 3, image 2, depth of each point; None where there is no picture."""
    with exact.mp.workdps(digits):
        oracle = exact.Exact(projection)
        rows = []
        for point in points.tolist():
            answer = oracle(point)
            clip = [value * answer.w for value in answer.ndc] + [answer.w]
            pixels = [*answer.ndc, *answer.image, answer.depth]
            rows.append([*answer.view, *clip, *(pixels if answer.w > 0 else [None] * 6)])
    return rows


def numbers(traced: Trace) -> Array:
    """The same numbers of a trace, (n, 13)."""
    return np.column_stack([traced.view, traced.clip, traced.ndc, traced.image, traced.depth])


def worst_ulp(projection: Projection, points: Array) -> float:
    """Largest error of the exact level in units of the last place of the true value."""
    traced = trace(projection, points, "exact")
    worst = 0.0
    with exact.mp.workdps(DIGITS):
        for row, true_row in zip(numbers(traced), truth(projection, points), strict=True):
            for value, true in zip(row.tolist(), true_row, strict=True):
                if true is None:
                    assert math.isnan(value)
                elif abs(true) < NOTHING:
                    assert value == 0.0, (projection, value)
                else:
                    worst = max(worst, float(abs(value - true) / np.spacing(abs(float(true)))))
    return worst


def check_outside(projection: Projection, points: Array) -> None:
    """Hold `Trace.outside` against its definition at hundreds of digits."""
    lens = projection.lens
    outside = trace(projection, points, "exact").outside
    with exact.mp.workdps(DIGITS):
        for found, row in zip(outside, truth(projection, points), strict=True):
            x, y, w, distance = row[3], row[4], row[6], -row[2]
            beyond = (distance - lens.near, lens.far - distance, x + w, w - x, y + w, w - y)
            assert found.tolist() == [value < -NOTHING for value in beyond]


# --------------------------------------------------------------------------- cameras and points


def points_in_view(projection: Projection, rng: np.random.Generator, count: int) -> Array:
    """Points spread over the view volume; where float64 has no such points, those beside them."""
    lens = projection.lens
    if lens.parallel:
        distance = rng.uniform(lens.near, lens.far, count)
    else:
        far = min(lens.far, 1e6 * lens.near)
        distance = lens.near * (far / lens.near) ** rng.random(count)
    points_view = at_distance(projection, distance, *rng.random((2, count)))
    return in_world(projection.camera, np.column_stack(points_view))


def seen(projection: Projection, points: Array) -> Array:
    return points[~trace(projection, points, "exact").outside.any(axis=1)]


def camera_at(rng: np.random.Generator, offset: float, up_angle: float = 1.0) -> Camera:
    """A camera of an everyday size, some way from the origin in a random direction."""
    centre = offset * rng.normal(size=3) / math.sqrt(3.0)
    eye = centre + rng.normal(size=3) * 5.0
    target = eye + rng.normal(size=3) * 4.0
    view = target - eye
    across = np.cross(view, rng.normal(size=3))
    up = view / np.linalg.norm(view) * math.cos(up_angle)
    up += across / np.linalg.norm(across) * math.sin(up_angle)
    return Camera(*(tuple(part.tolist()) for part in (eye, target, up)))


def figures(rng: np.random.Generator) -> Iterator[tuple[str, Projection]]:
    """Every row of the figures, for every lens that has it."""
    depths = list(DEPTH_RANGES)

    def with_depths(name: str, camera: Camera, lens: Lens, size: tuple[int, int] = HD) -> Any:
        for depth in depths:
            yield f"{name} {lens.kind} {depth}", Projection(camera, lens, size, depth)

    def lenses(near: float, far: float) -> list[Lens]:
        found: list[Lens] = [
            Perspective(45.0, near, far),
            Frustum(-0.3 * near, 0.9 * near, 0.1 * near, 0.7 * near, near, far, "x"),
        ]
        if far != math.inf:
            box = (-3.3, 5.1, -1.2, 4.4, near, far)
            found += [Orthographic(*box), Oblique(*box, alpha_deg=63.4, beta_deg=116.5)]
        return found

    for offset in (0.0, 1e3, 1e6, 1e9):
        for lens in lenses(0.1, 100.0):
            yield from with_depths(f"offset {offset:g}", camera_at(rng, offset), lens)
    for ratio in (1e1, 1e3, 1e6, 1e9, 1e12, math.inf):
        for lens in lenses(0.1, 0.1 * ratio):
            yield from with_depths(f"far/near {ratio:g}", camera_at(rng, 10.0), lens)
    for power in range(-12, 0, 3):
        for lens in lenses(1.0, 1.0 + 10.0**power):
            yield from with_depths(f"near ~ far {power}", camera_at(rng, 0.0), lens)
    for fov_y_deg in (1e-4, 1.0, 90.0, 179.0, 179.99):
        lens = Perspective(fov_y_deg, 0.1, 100.0)
        yield from with_depths(f"fov {fov_y_deg:g}", camera_at(rng, 10.0), lens)
    for power in range(-12, -2, 3):
        camera = camera_at(rng, 0.0, up_angle=10.0**power)
        for lens in lenses(0.1, 100.0):
            yield from with_depths(f"up {power}", camera, lens)
    for size in ((1, 16384), (16384, 1)):
        for lens in lenses(0.1, 100.0):
            yield from with_depths(f"aspect {size}", camera_at(rng, 10.0), lens, size)
    for narrow in (1e-6, 1e6):  # as glFrustum and glOrtho can have it
        lens = Frustum(-0.3 * narrow, 0.4 * narrow, -0.1, 0.3, 0.1, 100.0)
        yield from with_depths(f"window {narrow:g}", camera_at(rng, 10.0), lens)
        box = Orthographic(-3.0 * narrow, 4.0 * narrow, -1.0, 3.0, 0.1, 100.0)
        yield from with_depths(f"window {narrow:g}", camera_at(rng, 10.0), box)
    for angle_deg in (6e-5, 179.9999):
        lens = Oblique(-4.0, 4.0, -3.0, 3.0, alpha_deg=angle_deg, beta_deg=77.0)
        yield from with_depths(f"shear {angle_deg:g}", camera_at(rng, 10.0), lens)


def wild(rng: np.random.Generator) -> Projection:
    """A random document of any size that the model takes."""

    def power(low: float, high: float) -> float:
        return float(10.0 ** rng.uniform(low, high))

    while True:
        try:
            size = power(-90, 90)
            eye = rng.normal(size=3) * size * power(0, 9)
            target = eye + rng.normal(size=3) * size * power(-6, 2)
            camera = Camera(*(tuple(p.tolist()) for p in (eye, target, rng.normal(size=3))))
            near = size * power(-9, 2)
            far = near * (1.0 + power(-15, 15))
            half = power(-9, 9) * size
            window = (-half * power(-3, 0), half, -half, half * power(-3, 3))
            kind = str(rng.choice([*LENSES]))
            if LENSES[kind].central:
                far = rng.choice([far, math.inf])
            elif rng.random() < 0.3:
                near = -near
            own = {"keep": str(rng.choice(["stretch", "x", "y"]))}
            own["fov_y_deg"] = rng.choice([power(-9, 2), 180.0 - power(-9, 2)])
            own["alpha_deg"], own["beta_deg"] = rng.uniform(1.0, 179.0, 2).tolist()
            lens = made(kind, window, near, far, **own)
            size_px = (int(rng.integers(1, 16385)), int(rng.integers(1, 16385)))
            return Projection(camera, lens, size_px, str(rng.choice([*DEPTH_RANGES])))
        except Refusal:
            continue


# --------------------------------------------------------------------------- the exact level


def test_exact_is_rounded_once_over_all_the_figures() -> None:
    rng = np.random.default_rng(1)
    for name, projection in figures(rng):
        points = points_in_view(projection, rng, 4)
        assert worst_ulp(projection, points) <= 0.5001, name
        check_outside(projection, points)


def test_exact_is_rounded_once_in_wild_documents() -> None:
    rng = np.random.default_rng(2)
    for _ in range(150):
        projection = wild(rng)
        points = points_in_view(projection, rng, 3)
        points = points[(np.abs(points) <= LARGEST).all(axis=1)]
        assert worst_ulp(projection, points) <= 0.5001, projection
        check_outside(projection, points)


@pytest.mark.parametrize("depth", DEPTH_RANGES)
def test_exact_is_rounded_once_where_double_double_overflows(
    depth: DepthRange, monkeypatch: pytest.MonkeyPatch
) -> None:
    needed = count_rationals(monkeypatch)
    lenses = [
        Perspective(SMALLEST_FIELD, SMALLEST, 1.0),
        Perspective(60.0, 1e-205, LARGEST),
        Frustum(-1e-206, 1e-207, -1e-205, 1e-208, SMALLEST, math.inf),
        Orthographic(-SMALLEST_WINDOW, SMALLEST_WINDOW, -1.0, 1e100, -1e100, 1e100),
        Oblique(-1e-194, 1e-194, -1.0, 1e100, 1.0, 1e100, alpha_deg=6e-5, beta_deg=91.0),
    ]
    camera = Camera((1e100, -3e99, 7e98), (-1e100, 2e95, -1e99), (0.3, 1.0, -0.2))
    points = np.array([[0.0, 0.0, 0.0], [-1e100, 1e100, 1e-100], [9e99, -2.7e99, 1.0]])
    for lens in lenses:
        projection = Projection(camera, lens, HD, depth)
        seen_at_all = trace(projection, points, "exact").in_front
        # A picture beyond float64's 1e308 is none; the other numbers are right all the same.
        rows = numbers(trace(projection, points, "exact"))
        with exact.mp.workdps(DIGITS):
            true_rows = truth(projection, points)
            for row, true_row, has in zip(rows, true_rows, seen_at_all, strict=True):
                columns = zip(row[: 13 if has else 7].tolist(), true_row, strict=False)
                for value, true in columns:
                    assert abs(value - true) <= 0.5001 * np.spacing(abs(float(true)))
                beyond = max(map(abs, true_row[7:12])) > exact.mp.mpf(2) ** 1024
                assert bool(has) is not beyond
    assert needed() > 0


def count_rationals(monkeypatch: pytest.MonkeyPatch) -> Callable[[], int]:
    """Count the points for which double-double does not tell how to round."""
    calls = []
    for passage in (EyeFirst, TypedCells):
        exactly = passage.exact_coordinates

        def counted(of: Any, point: Any, one: int, exactly: Any = exactly) -> Any:
            calls.extend(point[0].above)
            return exactly(of, point, one)

        monkeypatch.setattr(passage, "exact_coordinates", counted)
    return lambda: len(calls)


@pytest.mark.parametrize("depth", DEPTH_RANGES)
def test_exact_is_rounded_once_at_the_eye_plane(
    depth: DepthRange, monkeypatch: pytest.MonkeyPatch
) -> None:
    """w is what is left when all digits of the distance cancel, of either sign."""
    needed, rng = count_rationals(monkeypatch), np.random.default_rng(5)
    for lens in (ONE_OF_EACH["perspective"], ONE_OF_EACH["frustum"], samples.LENSES["infinite"]):
        projection = Projection(SLANTED, lens, HD, depth)
        across = np.column_stack([rng.uniform(-3.0, 3.0, (12, 2)), np.zeros(12)])
        points = in_world(SLANTED, across)
        found = trace(projection, points, "exact").clip[:, 3]
        assert (np.abs(found) < 1e-14).all() and (found > 0.0).any() and (found < 0.0).any()
        assert worst_ulp(projection, points) <= 0.5001
        check_outside(projection, points)
    assert needed() >= 36


@pytest.mark.parametrize("space", ["world", "object"])
@pytest.mark.parametrize("depth", DEPTH_RANGES)
def test_many_directions_are_as_one_by_one(depth: DepthRange, space: Any) -> None:
    """All of one's numbers are rationals, rounded once; those of many are double-doubles."""
    rng = np.random.default_rng(6)
    rows = rng.normal(size=(40, 3)).tolist() + np.eye(3).tolist() + (-np.eye(3)).tolist()
    turned = FiveTiles((7.0, -3.0, 1e9), (10.0, 90.0, 0.0), (2.0, 1.0, 0.5)).chain
    view = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, -5), (0, 0.1, 0, 1))
    typed = FreeMatrix(free_matrix().clip_from_view, view)
    for lens in (*samples.LENSES.values(), free_matrix(), typed):
        projection = Projection(SLANTED, lens, HD, depth, turned)
        found = trace_homogeneous(projection, [[*row, 0.0] for row in rows], space=space)
        for i, row in enumerate(rows):
            world = turned.exactly(row, 0) if space == "object" else row
            alone = trace_at_infinity(projection, world)
            for part, true in zip(found[1:], alone[1:], strict=True):
                np.testing.assert_array_equal(part[i], true)


@pytest.mark.parametrize("lens", ONE_OF_EACH.values(), ids=ONE_OF_EACH)
def test_everyday_points_are_certain_in_double_double(
    lens: Lens, monkeypatch: pytest.MonkeyPatch
) -> None:
    needed = count_rationals(monkeypatch)
    rng = np.random.default_rng(3)
    projection = Projection(SLANTED, lens, HD)
    points = points_in_view(projection, rng, 20_000)
    traced = trace(projection, points, "exact")
    assert needed() <= 2
    # In blocks as one by one.
    alone = [trace(projection, point, "exact") for point in points[8185:8200]]
    assert np.array_equal(traced.image[8185:8200], [one.image for one in alone])


def test_near_next_to_far_is_certain_in_rationals_only(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(4)
    projection = Projection(camera_at(rng, 0.0), Perspective(45.0, 1.0, 1.0 + 1e-12), HD)
    points = points_in_view(projection, rng, 50)
    assert worst_ulp(projection, points) <= 0.5001
    needed = count_rationals(monkeypatch)
    trace(projection, points, "exact")
    assert needed() == 50


AXES = [
    Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    Camera((7.0, -3.0, 11.0), (3.0, 5.0, -1.0), (0.3, 1.0, -0.2)),
    Camera((1e9 + 7.0, -3e5, 11.0), (1e9 + 3.0, 5.0 - 3e5, -1.0), (0.3, 1.0, -0.2)),
]


@pytest.mark.parametrize("depth", DEPTH_RANGES)
@pytest.mark.parametrize("camera", AXES, ids=["straight", "slanted", "far away"])
def test_points_on_the_axis_are_zero_and_in_the_very_middle(
    camera: Camera, depth: DepthRange
) -> None:
    eye, target = np.array(camera.eye), np.array(camera.target)
    points = np.array([eye + k * (target - eye) for k in (-1.0, 0.25, 0.5, 1.0, 2.0, 64.0)])
    box = (-3.0, 3.0, -2.0, 2.0, 0.5, 99.0)
    for lens in (Perspective(37.0, 0.5, 99.0), Frustum(*box), Orthographic(*box)):
        projection = Projection(camera, lens, (1366, 767), depth)
        traced = trace(projection, points, "exact")
        assert not traced.view[:, :2].any() and not traced.clip[:, :2].any()
        seen_points = points[traced.in_front]
        assert len(seen_points) >= 5
        middle = trace(projection, seen_points, "exact")
        assert not middle.ndc[:, :2].any()
        assert np.array_equal(middle.image, np.full((len(seen_points), 2), (683.0, 383.5)))
        assert worst_ulp(projection, points) <= 0.5001


@pytest.mark.parametrize("depth", DEPTH_RANGES)
def test_points_exactly_on_a_plane_are_not_outside_and_their_neighbours_are(
    depth: DepthRange,
) -> None:
    camera = Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0))
    box = (-0.375, 0.625, -0.25, 0.125)
    on_planes = np.array([
        # the middle of each face: near, far, left, right, bottom, top
        (0.125, -0.0625, 4.5), (0.125, -0.0625, -3.0), (-0.375, 0.0, 4.5), (0.625, 0.0, 4.5),
        (0.0, -0.25, 4.5), (0.0, 0.125, 4.5),
    ])  # fmt: skip
    outward = np.array([(0, 0, 1), (0, 0, -1), (-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0)])
    beside = on_planes + outward * 1e-15
    beside[1] = (0.125, -0.0625, np.nextafter(-3.0, -9.0))
    for lens in (Frustum(*box, 0.5, 8.0), Orthographic(*box, 0.5, 8.0)):
        projection = Projection(camera, lens, (640, 480), depth)
        traced = trace(projection, on_planes, "exact")
        assert not traced.outside.any()
        ends = {"opengl": (-1.0, 1.0), "direct3d": (0.0, 1.0), "reversed": (1.0, 0.0)}[depth]
        assert traced.ndc[:2, 2].tolist() == list(ends)
        assert traced.ndc[2:4, 0].tolist() == [-1.0, 1.0] == traced.ndc[4:, 1].tolist()
        assert traced.image[2:4, 0].tolist() == [0.0, 640.0]
        assert traced.image[4:, 1].tolist() == [480.0, 0.0]
        assert worst_ulp(projection, on_planes) <= 0.5001
        outside = trace(projection, beside, "exact").outside
        # 1e-15 nearer is outside of near only; the others are at the near plane or beside it.
        assert outside[np.arange(6), np.arange(6)].tolist() == (beside != on_planes).any(1).tolist()
        assert outside[1:].sum(axis=0).tolist()[1:] == [1] * 5
        check_outside(projection, beside)


@pytest.mark.parametrize(
    ("eye", "up"),
    [
        ((1.0, 0.0, 1.0), (0.0, 1.0, 0.0)),
        ((1.0, 0.0, 1.0), (0.0, 3.0, 0.0)),  # |U| and |N| are then 3 sqrt(2) and sqrt(2)
        ((1.0, 4.0, 1.0), (0.0, 1.0, 0.0)),  # and here sqrt(2) and 3 sqrt(2)
        ((1.0, 4.0, 1.0), (0.0, 0.7, 0.0)),
    ],
)
def test_points_on_a_slanted_plane_are_found_there(eye: Vector, up: Vector) -> None:
    """Where both sides of ``x = w`` are the same irrational number."""
    backward, right = np.array(eye), np.cross((0.0, 1.0, 0.0), eye)
    ratio = math.sqrt(backward @ backward / (right @ right))  # x = w: (U . o) ratio = -N . o
    assert ratio == round(ratio)
    steps = np.array(np.meshgrid(*[np.arange(-9.0, 10.0)] * 3)).reshape(3, -1).T
    on_plane = steps[steps @ (right * ratio + backward) == 0.0]
    in_front = on_plane[on_plane @ backward < 0.0]
    points = in_front + eye
    camera = Camera(eye, (0.0, 0.0, 0.0), up)
    projection = Projection(camera, Perspective(90.0, 0.5, 99.0), (64, 64))
    traced = trace(projection, points, "exact")
    assert len(points) > 50
    assert not traced.outside[:, PLANES.index("right")].any()
    assert (traced.image[:, 0] == 64.0).all() and (traced.ndc[:, 0] == 1.0).all()


@pytest.mark.parametrize("depth", DEPTH_RANGES)
def test_in_the_eye_plane_and_behind_there_are_clip_coordinates_and_no_picture(
    depth: DepthRange,
) -> None:
    camera = Camera((7.0, -3.0, 11.0), (3.0, 5.0, -1.0), (0.3, 1.0, -0.2))
    along = np.array(camera.target) - camera.eye  # (-4, 8, -12)
    across = np.array([(2.0, 1.0, 0.0), (0.0, 3.0, 2.0), (-3.0, 0.0, 1.0), (0.0, 0.0, 0.0)])
    in_plane = across + camera.eye
    for lens in (Perspective(37.0, 0.5, 99.0), Frustum(-0.1, 0.7, 0.2, 0.9, 0.7, math.inf)):
        projection = Projection(camera, lens, HD, depth)
        traced = trace(projection, in_plane, "exact")
        assert traced.clip[:, 3].tolist() == [0.0] * 4 == traced.view[:, 2].tolist()
        assert not traced.in_front.any() and traced.outside[:, 0].all()
        for gone in (traced.ndc, traced.image, traced.depth):
            assert np.isnan(gone).all()
        # Clip coordinates are affine: those of the middle of a point behind and one in front.
        with exact.mp.workdps(DIGITS):
            ends = [truth(projection, in_plane + side * along) for side in (1.0, -1.0)]
            for found, front, behind in zip(traced.clip.tolist(), *ends, strict=True):
                assert behind[7:] == [None] * 6
                for value, a, b in zip(found, front[3:7], behind[3:7], strict=True):
                    true = (a + b) / 2
                    size = 0.0 if abs(true) < NOTHING else 0.5001 * np.spacing(abs(float(true)))
                    assert abs(value - true) <= size
        assert worst_ulp(projection, in_plane - along) <= 0.5001  # behind: view and clip
        assert not trace(projection, in_plane - along, "exact").in_front.any()


def test_a_field_of_view_of_90_degrees_has_a_cotangent_of_exactly_1() -> None:
    assert dd.cotangent_deg(Fraction(45)) == 1 == -dd.cotangent_deg(Fraction(135))


def test_every_level_keeps_the_shape_of_the_points_and_takes_none() -> None:
    points = np.arange(24.0).reshape(2, 4, 3)
    for level in PRECISIONS:
        traced = trace(Projection(), points, level)
        assert traced.clip.shape == (2, 4, 4) and traced.outside.shape == (2, 4, 6)
        assert traced.depth.shape == (2, 4) and traced.image.dtype == np.float64
        assert trace(Projection(), np.empty((0, 3)), level).image.shape == (0, 2)
        assert trace(Projection(), (1.0, 2.0, 3.0), level).ndc.shape == (3,)


def test_an_unknown_level_and_invalid_points_are_refused() -> None:
    with pytest.raises(Refusal, match="precision = 'float16': must be one of float32, float64"):
        trace(Projection(), [(0.0, 0.0, 0.0)], "float16")  # type: ignore[arg-type]
    for level in PRECISIONS:
        with pytest.raises(Refusal, match=r"points\[0\] = .*: must have finite real numbers only"):
            trace(Projection(), [(0.0, math.nan, 0.0)], level)


# --------------------------------------------------------------------------- the float32 level


@pytest.mark.parametrize(
    ("kind", "depth"), pairwise(itertools.product(ONE_OF_EACH, DEPTH_RANGES))[::2]
)
def test_float32_is_what_a_gpu_does_step_by_step(kind: str, depth: DepthRange) -> None:
    single = np.float32
    rng = np.random.default_rng(6)
    projection = Projection(camera_at(rng, 1e6), ONE_OF_EACH[kind], (1366, 767), depth)
    origin = beside(rng, projection)
    points = points_in_view(projection, rng, 50)
    traced = trace(projection, points, "float32", origin)
    matrix = projection.clip_from_local(origin)
    one = single(1.0)
    for i, point in enumerate(points):
        # The vertex that is uploaded, and the uniform matrix, in 24 bits each.
        x, y, z = (single(p - o) for p, o in zip(point.tolist(), origin, strict=True))
        clip = []
        for row in matrix.tolist():
            a, b, c, d = map(single, row)
            clip.append(((a * x + b * y) + c * z) + d)
        ndc = [part / clip[3] for part in clip[:3]]
        image = [(ndc[0] + one) * single(683.0), (one - ndc[1]) * single(383.5)]
        window_z = single(0.5) * ndc[2] + single(0.5) if depth == "opengl" else ndc[2]
        assert traced.clip[i].tolist() == [float(part) for part in clip]
        assert traced.ndc[i].tolist() == [float(part) for part in ndc]
        assert traced.image[i].tolist() == [float(part) for part in image]
        assert traced.depth[i] == float(window_z)
    exactly = trace(projection, points, "exact")
    size = np.abs(exactly.view).sum(axis=1, keepdims=True)
    assert (np.abs(traced.view - exactly.view) <= 6.0 * 2.0**-24 * size).all()
    assert not np.array_equal(traced.view, exactly.view)


def test_float32_beyond_its_range_is_infinite_and_never_chosen() -> None:
    """Warnings are errors here, so that this says too that there is none."""
    camera = Camera((1e40, 0.0, 0.0), (0.0, 0.0, 0.0))
    projection = Projection(camera, Perspective(45.0, 1e39, 1e41), HD)
    points = np.array([[0.0, 1e38, 2e38], [-1e39, 0.0, 3e38]])
    traced = trace(projection, points, "float32")
    assert np.isnan(traced.image).all() and not traced.in_front.any()
    predictions = predict(projection, points)
    assert predictions is not None
    assert predictions["float32"] == (math.inf, math.inf)
    assert predictions["float64"].px < 1e-11
    assert precision_for_reading(predictions) == "float64"
    assert drawing_bound_px(projection, corners(points)) == math.inf


def test_float32_below_its_range_is_never_chosen() -> None:
    camera = Camera((3e-43, 4e-43, 5e-43), (0.0, 0.0, 0.0))
    projection = Projection(camera, Perspective(45.0, 1e-43, 1e-41), HD)
    points = points_in_view(projection, np.random.default_rng(15), 20)
    predictions = predict(projection, points)
    assert predictions is not None
    assert predictions["float32"].px > 1.0 and predictions["float64"].px < 1e-11
    assert drawing_bound_px(projection, corners(points)) > 1.0
    # The same scene 1e43 times as large has the error that 24 bits leave.
    camera = Camera((3.0, 4.0, 5.0), (0.0, 0.0, 0.0))
    projection = Projection(camera, Perspective(45.0, 1.0, 100.0), HD)
    assert drawing_bound_px(projection, corners(points * 1e43)) < 0.1


# --------------------------------------------------------------------------- predictions


def measured(
    projection: Projection, points: Array, origin: Vector, digits: int = 120
) -> dict[Precision, tuple[float, float]]:
    """Each level's largest error in pixels and in depth; infinite where a number is gone."""
    true_rows, found = truth(projection, points, digits), {}
    for level in PRECISIONS:
        traced = trace(projection, points, level, origin)
        rows = np.column_stack([traced.image, traced.depth])
        px = depth = math.inf if np.isnan(rows).any() else 0.0
        with exact.mp.workdps(digits):
            for (x, y, z), true in zip(rows.tolist(), true_rows, strict=True):
                px = max(px, float(abs(x - true[10])), float(abs(y - true[11])))
                depth = max(depth, float(abs(z - true[12])))
        found[level] = px, depth
    return found


def check_predictions(
    name: str, projection: Projection, points: Array, origin: Vector = (0.0, 0.0, 0.0)
) -> list[float]:
    """Never below what is measured; by how much above."""
    predictions = predict(projection, points, origin)
    assert predictions is not None
    ratios = []
    for level, errors in measured(projection, points, origin).items():
        for predicted, error in zip(predictions[level], errors, strict=True):
            assert error <= predicted, (name, level, error, predicted)
            if 0.0 < error < math.inf:
                ratios.append(predicted / error)
    return ratios


def test_predictions_over_the_figures_hold() -> None:
    rng = np.random.default_rng(7)
    ratios = []
    for name, projection in figures(rng):
        points = seen(projection, points_in_view(projection, rng, 15))
        if len(points):
            ratios += check_predictions(name, projection, points)
    assert len(ratios) > 500 and np.median(ratios) < 20.0 and np.quantile(ratios, 0.95) < 100.0


def test_float64_keeps_the_bound_of_the_readme() -> None:
    """By a level of more digits: the worst of 11.7 million points was 6.2e-13."""
    rng = np.random.default_rng(19)
    worst, count = 0.0, 0
    for name, projection in figures(rng):
        group = name.split()[0]
        if group in ("offset", "far/near", "fov", "up") and projection.lens.kind != "oblique":
            points = points_in_view(projection, rng, 400)
            traced = projection.trace(points)
            answers = np.column_stack([traced.image, traced.depth])
            points, answers = (part[~traced.outside.any(axis=1)] for part in (points, answers))
            if len(points):
                errors = Reference.of(projection, points).errors(answers)
                worst, count = max(worst, float(errors[:, :2].max())), count + len(points)
    assert count > 30_000 and 3e-13 < worst < 1e-12


def any_projection(rng: np.random.Generator) -> Projection:
    """A projection of about everyday size."""
    near = 10.0 ** rng.uniform(-4.0, 0.5)
    far = near * (1.0 + 10.0 ** rng.uniform(-3.0, 6.0))
    middle, half = rng.normal(size=2), 10.0 ** rng.uniform(-1.0, 1.0, 2)
    window = np.ravel([middle - half, middle + half], order="F")
    kind = str(rng.choice([*LENSES]))
    if LENSES[kind].central:
        far, window = rng.choice([far, far, math.inf]), near * window
    else:
        far, window = near + 10.0 ** rng.uniform(-2.0, 3.0), 4.0 * window
    alpha_deg, beta_deg = rng.uniform(20.0, 160.0, 2).tolist()
    angles = {"fov_y_deg": rng.uniform(1.0, 170.0), "alpha_deg": alpha_deg, "beta_deg": beta_deg}
    lens = made(kind, window.tolist(), near, far, **angles)
    camera = camera_at(rng, float(rng.choice([0.0, 10.0, 1e4, 1e7, 1e9])))
    return Projection(camera, lens, HD, str(rng.choice([*DEPTH_RANGES])))


def beside(rng: np.random.Generator, projection: Projection) -> Vector:
    """An origin of a scene in front of the camera."""
    x, y, z = (np.array(projection.camera.target) + rng.normal(size=3)).tolist()
    return x, y, z


PROJECTIVE = (
    (1.3, 0.1, 0.2, 0.4),
    (0.0, 1.9, -0.1, 0.3),
    (0.1, 0.2, -1.2, -2.0),
    (0.1, 0, -1, 0.2),
)
TYPED = ((0.8, 0.1, -0.5, 1.0), (-0.2, 0.9, 0.3, -2.0), (0.5, -0.1, 0.8, -9.0), (0, 0, 0.01, 1.0))
CLOUDED: dict[str, Lens] = {
    "perspective": Perspective(45.0, 1.0, 30.0),
    "infinite": Perspective(100.0, 0.01, math.inf),
    "frustum": Frustum(-0.3, 0.9, 0.2, 0.7, 1.0, 1000.0),
    "orthographic": Orthographic(-4.0, 4.0, -3.0, 3.0, 1.0, 1e6),
    "oblique": Oblique(-9.0, 7.0, -3.0, 5.0, -2.0, 1e6, alpha_deg=63.4, beta_deg=116.5),
    "matrix": FreeMatrix(PROJECTIVE),
    "both matrices": FreeMatrix(PROJECTIVE, TYPED),
}


def outliers(projection: Projection) -> dict[str, Array]:
    """Points that a sample would miss, and the worst that they can be."""
    view = {
        "far to the side": [(3e6, 0.0, -9.0), (-8e3, 2e9, -11.0)],
        "deepest": [(0.3, 0.2, -9e5), (2.0, 1.0, -999.9)],
        "beyond all": [(1e3, -3e4, -1e12)],
        "nearest the eye plane": [(0.7, 0.3, -1e-5), (-2.0, 5.0, -1e-12), (0.1, 3e3, -1e-9)],
        "nearest the eye": [(1e-8, 2e-8, -1e-8), (0.0, 1e-12, -3e-7)],
        "huge": [(3e29, 4e28, -1e30), (1e90, 1e90, -1e90), (0.0, 1e60, -1e20)],
        "behind": [(0.3, 0.2, 1e-9), (1e6, 1.0, 4.0), (0.0, 0.0, 0.0)],
    }
    found = {kind: in_world(projection.camera, np.array(points)) for kind, points in view.items()}
    if not isinstance(projection.lens, FreeMatrix):
        found["in the volume"] = points_in_view(projection, np.random.default_rng(20), 30)
    return found


def largest(errors: Array) -> tuple[float, float]:
    """Of x and y, and of the depth; infinite where an answer is missing."""
    there = np.where(np.isnan(errors), math.inf, errors)
    return float(there[:, :2].max()), float(there[:, 2].max())


@pytest.mark.parametrize(
    ("name", "depth", "far_away"), pairwise(itertools.product(CLOUDED, DEPTH_RANGES, (False, True)))
)
def test_no_point_of_a_cloud_is_off_by_more_than_predicted(
    name: str, depth: DepthRange, far_away: bool
) -> None:
    lens = CLOUDED[name]
    rng = np.random.default_rng(17)
    camera = camera_at(rng, 1e7) if far_away else SLANTED
    projection = Projection(camera, lens, HD, depth)
    origin: Vector = tuple(np.round(camera.target).tolist()) if far_away else (0.0, 0.0, 0.0)
    count = 100_000 if depth == "opengl" else 5_000
    points, kinds = camera.target + rng.normal(size=(count, 3)), np.zeros(count, dtype=int)
    kind_of = {kind: number for number, kind in enumerate(outliers(projection), start=1)}
    for kind, some in outliers(projection).items():
        where = rng.integers(0, len(points), len(some))
        points = np.insert(points, where, some, axis=0)
        kinds = np.insert(kinds, where, kind_of[kind])
    has_picture = projection.trace(points).in_front
    reference = Reference.of(projection, points)
    parts = [np.isin(kinds, (0, number)) for number in (*kind_of.values(), -1)]
    parts.append(np.ones(len(points), dtype=bool))
    parts += [np.arange(len(points)) == i for i in np.flatnonzero(kinds)]
    predictions = [predict(projection, points[part], origin) for part in parts]
    for part, prediction in zip(parts, predictions, strict=True):
        assert (prediction is None) is not (part & has_picture).any()
    tried = set(rng.integers(0, len(points), 15).tolist())
    for level in PRECISIONS:
        answers = reference.numbers
        if level != "exact":
            traced = trace(projection, points, level, origin)
            answers = np.column_stack([traced.image, traced.depth])
        errors = reference.errors(answers)
        for part, prediction in zip(parts, predictions, strict=True):
            if prediction is not None:
                px, off = largest(errors[part & has_picture])
                bound = prediction[level]
                assert px <= bound.px and off <= bound.depth, (level, points[part][:3], px, bound)
        tried.update(np.argsort(np.nan_to_num(errors[:, :2].max(axis=1)))[-5:].tolist())
    # And by the oracle, which shares nothing with us: the worst, and some.
    for i in tried:
        alone = predict(projection, points[i : i + 1], origin)
        if alone is not None:
            for level, (px, off) in measured(projection, points[i : i + 1], origin, 200).items():
                assert px <= alone[level].px and off <= alone[level].depth
    cloud = predictions[len(kind_of)]
    assert cloud is not None and np.isfinite(list(cloud.values())).all()


@given(
    st.sampled_from(list(CLOUDED)),
    st.sampled_from(list(DEPTH_RANGES)),
    st.sampled_from([0.0, 1.0, 1e4, 1e9]),
    st.lists(st.tuples(*[st.floats(-1.0, 1.0)] * 3, st.floats(-9.0, 9.0)), min_size=1, max_size=5),
)
def test_no_points_anywhere_are_off_by_more_than_predicted(
    name: str, depth: DepthRange, away: float, places: list[tuple[float, float, float, float]]
) -> None:
    eye = np.array([6.0, 5.0, 9.0]) * (1.0 + away)
    camera = Camera(tuple(eye.tolist()), tuple((eye - [6.0, 2.8, 9.1]).tolist()), (0.3, 1.0, -0.2))
    projection = Projection(camera, CLOUDED[name], HD, depth)
    points = np.array([eye + 10.0**power * np.array(place) for *place, power in places])
    origin: Vector = tuple(np.round(eye).tolist())
    points = points[projection.trace(points).in_front]
    together = predict(projection, points, origin)
    assert (together is None) is (len(points) == 0)
    if together is None:
        return
    alone: list[Any] = [predict(projection, point[None], origin) for point in points]
    for level, bound in together.items():
        assert not np.isnan(bound).any()
        # A bound of points is the largest of theirs.
        np.testing.assert_allclose(bound, np.max([a[level] for a in alone], axis=0), rtol=1e-6)
    for point, bounds in zip(points, alone, strict=True):
        for level, (px, off) in measured(projection, point[None], origin, 200).items():
            bound = bounds[level]
            assert px <= bound.px and off <= bound.depth, (level, point, px, off, bound)


@pytest.mark.parametrize(("count", "most"), [(10, 60.0), (100, 25.0)])
def test_predictions_of_scattered_points_are_as_tight_as_the_readme_says(
    count: int, most: float
) -> None:
    rng, ratios = np.random.default_rng(32), []
    starts = [load(name).start for name in BUILT_IN]
    for start in (start.with_depth(depth) for start in starts for depth in DEPTH_RANGES):
        lens = start.lens.replaced(near=1.01 * start.lens.near)
        projection = replace(start, lens=lens)
        points = seen(projection, points_in_view(projection, rng, count))
        ratios += check_predictions(start.lens.kind, projection, points, (0.0, 0.0, 0.0))
    assert np.quantile(ratios, 0.95) <= most


DRAWN_IN_FLOAT64 = {"far-plane-popping"}


def test_predictions_of_the_readmes_documents_are_as_tight_as_it_says() -> None:
    ratios = []
    letter_f, posts = load("letter-f"), load("posts")
    seen_from = replace(letter_f.start, camera=replace(letter_f.start.camera, eye=(3.0, 2.0, 4.0)))
    documents = [(load(name), load(name).start) for name in BUILT_IN]
    documents += [(letter_f, seen_from), (letter_f, letter_f.start.with_lens("oblique"))]
    documents += [(letter_f, replace(letter_f.start, lens=Perspective(45.0, 1.0, math.inf)))]
    far = posts.start.lens.far
    documents += [
        (posts, replace(posts.start, lens=Perspective(45.0, near, far)))
        for near in np.geomspace(1e-3, 10.0, 5).tolist()
    ]
    # A round near leaves errors of 0 now and then, which no bound is a multiple of.
    unround = [(scene, replace(at, lens=at.lens.replaced(near=1.01 * at.lens.near)))
               for scene, at in documents]  # fmt: skip
    of_ratios = [start.with_depth(depth) for _, start in unround for depth in DEPTH_RANGES]
    for scene, start in [*unround, *documents]:
        for depth in DEPTH_RANGES:
            projection = start.with_depth(depth)
            points = scene.vertices[projection.trace(scene.vertices).in_front]
            reference = Reference.of(projection, points)
            predictions = predict(projection, scene.vertices, scene.origin)
            assert predictions is not None and precision_for_reading(predictions) == "float64"
            for level in PRECISIONS:
                traced = trace(projection, points, level, scene.origin)
                errors = largest(reference.errors(np.column_stack([traced.image, traced.depth])))
                pairs = list(zip(predictions[level], errors, strict=True))
                # What the reference does not know is added to the error: 2^-16 of an ulp.
                assert all(error <= bound * (1.0 + 2.0**-14) for bound, error in pairs)
                ratios += [bound / error for bound, error in pairs if projection in of_ratios]
    assert np.median(ratios) <= 15.0 and np.quantile(ratios, 0.95) <= 60.0
    drawn = {
        name
        for name in BUILT_IN
        if drawing_bound_px(load(name).start, load(name).boxes.together, load(name).origin)
        > DRAWING_TOLERANCE_PX
    }
    assert drawn == DRAWN_IN_FLOAT64


def test_points_without_a_picture_have_no_prediction() -> None:
    projection = Projection(Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0)))
    assert predict(projection, [(0.0, 1.0, 5.0), (0.0, 1.0, 6.0)]) is None
    assert predict(projection, np.empty((0, 3))) is None
    # Those that have none do not count beside others that have.
    alone = predict(projection, [(0.1, 0.2, 0.3)])
    assert predict(projection, [(0.1, 0.2, 0.3), (0.0, 1.0, 5.0), (1.0, 1.0, 7.0)]) == alone
    assert precision_for_reading(None) == "float64"


# --------------------------------------------------------------------------- the choice


def test_numbers_are_read_from_float64_by_everyday_cameras() -> None:
    rng = np.random.default_rng(10)
    for lens in ONE_OF_EACH.values():
        for offset in (0.0, 1e3, 1e6, 1e9):
            projection = Projection(camera_at(rng, offset), lens, HD)
            points = points_in_view(projection, rng, 50)
            assert precision_for_reading(predict(projection, points)) == "float64"


def test_numbers_are_exact_where_near_is_next_to_far() -> None:
    rng = np.random.default_rng(11)
    projection = Projection(SLANTED, Perspective(45.0, 1.0, 1.0 + 1e-13), HD)
    predictions = predict(projection, points_in_view(projection, rng, 20))
    assert predictions is not None
    assert predictions["float64"].px < READING_TOLERANCE_PX
    assert predictions["float64"].depth > 10.0 * READING_TOLERANCE_DEPTH
    assert predictions["exact"].depth <= 2.0**-53 * 1.001
    assert precision_for_reading(predictions) == "exact"


def test_numbers_are_exact_where_a_window_is_far_off_the_axis() -> None:
    rng = np.random.default_rng(12)
    projection = Projection(SLANTED, Frustum(1e4, 1e4 + 1e-3, 2e4, 2e4 + 1e-3, 1.0, 1.5), HD)
    predictions = predict(projection, points_in_view(projection, rng, 200))
    assert predictions is not None
    assert predictions["float64"].px > 10.0 * READING_TOLERANCE_PX
    assert predictions["float64"].depth < READING_TOLERANCE_DEPTH
    assert predictions["exact"].px < READING_TOLERANCE_PX
    assert precision_for_reading(predictions) == "exact"


def corners(points: Array) -> Array:
    low, high = points.min(axis=0), points.max(axis=0)
    ends = np.array(np.meshgrid([0.0, 1.0], [0.0, 1.0], [0.0, 1.0])).reshape(3, -1).T
    return low + (high - low) * ends


def test_no_point_of_a_box_is_drawn_worse_than_its_bound() -> None:
    rng = np.random.default_rng(13)
    ratios = []
    while len(ratios) < 150:
        projection = any_projection(rng)
        cloud = points_in_view(projection, rng, 2)
        if rng.random() < 0.5:
            cloud = cloud[0] + rng.uniform(-1.0, 1.0, (2, 3)) * 10.0 ** rng.uniform(-3, 3, 3)
        box = corners(cloud)
        low, high = box.min(axis=0), box.max(axis=0)
        origin = tuple(((low + high) / 2.0 + rng.normal(size=3) * rng.choice([0.0, 1.0])).tolist())
        inside = np.clip(points_in_view(projection, rng, 1000), low, high)
        points = np.concatenate([rng.uniform(low, high, (1000, 3)), box, inside])
        points = seen(projection, points)
        if not len(points):
            continue
        exactly = trace(projection, points, "exact").image
        error = np.abs(trace(projection, points, "float32", origin).image - exactly).max()
        bound = drawing_bound_px(projection, box, origin)
        assert error <= bound, projection
        ratios.append(bound / error)
    assert np.median(ratios) < 20.0 and np.quantile(ratios, 0.97) < 1000.0


def test_a_box_beside_the_eye_is_bounded_where_it_enters_the_view() -> None:
    """Its nearest corner is beside the eye, where w is near's 0.001 and nothing is seen of it."""
    camera = Camera((0.0, 0.0, 0.0), (0.0, 0.0, -1.0))
    projection = Projection(camera, Perspective(45.0, 0.001, 100.0), HD)
    box = corners(np.array([(5.0, -1.0, -20.0), (6.0, 1.0, 3.0)]))
    points = seen(projection, np.random.default_rng(16).uniform(box[0], box[-1], (5000, 3)))
    exactly = trace(projection, points, "exact").image
    error = np.abs(trace(projection, points, "float32").image - exactly).max()
    assert error <= drawing_bound_px(projection, box) < 30.0 * error
    for away in [(0.0, 0.0, 20.0), (0.0, 90.0, 0.0), (-900.0, 0.0, 0.0)]:
        unseen = box + np.array(away)
        assert drawing_bound_px(projection, unseen) == 0.0


@pytest.mark.parametrize("name", ["letter-f", "eye-plane", "focus", "far-plane-popping"])
def test_no_point_of_an_edge_is_drawn_worse_than_the_bound_of_its_boxes(name: str) -> None:
    """Also of an edge that goes behind the eye: the GPU interpolates between its ends."""
    scene = load(name)
    origin = np.array(scene.origin)
    assert scene.surface is not None and scene.lines is not None
    random = np.random.default_rng(17)
    triangles = scene.surface.triangulate()
    sides = triangles.regular_faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    edges = (triangles.points[sides], scene.lines.points.reshape(-1, 2, 3))
    kinds, crossing, boxed = 0, 0, 0
    for _ in range(40):
        lower, upper = np.array(scene.lower), np.array(scene.upper)
        eye = random.uniform(lower - 1.0, upper + 1.0)
        camera = Camera(tuple(eye), tuple(random.uniform(lower, upper)))
        near = 10.0 ** random.uniform(-2, 0)
        projection = Projection(camera, Perspective(random.uniform(20, 90), near, 500.0), HD)
        for local, boxes in zip(edges, (scene.boxes.faces, scene.boxes.lines), strict=True):
            chosen = local[random.integers(len(local), size=400)].astype(float)
            bound = drawing_bound_px(projection, boxes, scene.origin)
            boxed += bound < drawing_bound_px(projection, scene.corners, scene.origin)
            matrix = projection.clip_from_local(scene.origin).astype(np.float32)
            homogeneous = np.concatenate([chosen, np.ones((*chosen.shape[:2], 1))], axis=2)
            ends = (homogeneous.astype(np.float32) @ matrix.T).astype(float)
            part = random.uniform(size=(len(chosen), 30, 1))
            clip = ends[:, :1] + part * (ends[:, 1:] - ends[:, :1])
            true = projection.trace(origin + chosen[:, :1] + part * (chosen[:, 1:] - chosen[:, :1]))
            within = ~true.outside.any(axis=2)
            if not within.any():
                continue
            ndc = clip[within][:, :2] / clip[within][:, 3:]
            width, height = HD
            image = (ndc * (1.0, -1.0) + 1.0) * (width / 2.0, height / 2.0)
            assert np.abs(image - true.image[within]).max() <= bound, projection
            kinds += 1
            crossing += int((ends[within.any(axis=1)][..., 3] < 0.0).any(axis=1).sum())
    assert kinds > 40 and crossing > 100 and boxed > 20


def test_each_box_has_its_own_bound() -> None:
    rng = np.random.default_rng(18)
    projection = Projection(Camera((0.5, 1.0, 2.0), (0.0, 0.0, 0.0)), Perspective(60, 0.1, 40), HD)
    boxes = np.array([corners(rng.normal(size=(2, 3)) * 3.0) for _ in range(60)])
    bounds = drawing_bounds_px(projection, [(boxes[:20], "world"), (boxes[20:], "object")])
    assert bounds == pytest.approx([drawing_bound_px(projection, box) for box in boxes])
    assert 0.0 in bounds and max(bounds) == drawing_bound_px(projection, boxes) > 0.0
    assert drawing_bounds_px(projection, [(np.empty((0, 8, 3)), "world")]) == []


# --------------------------------------------------------------------------- nothing is lost


def test_where_float64_has_a_number_every_other_level_has_a_prediction() -> None:
    """Warnings are errors: no overflow is loud, and no number silently gone."""
    rng = np.random.default_rng(14)
    for _ in range(400):
        projection = wild(rng)
        points = points_in_view(projection, rng, 3)
        anywhere = rng.normal(size=(2, 3)) * 10.0 ** rng.uniform(-100.0, 99.0, (2, 1))
        camera = projection.camera
        points = np.concatenate([points, anywhere, [camera.eye, camera.target]])
        points = points[(np.abs(points) <= LARGEST).all(axis=1)]
        plain, exactly = (trace(projection, points, level) for level in ("float64", "exact"))
        assert np.array_equal(plain.in_front, exactly.in_front), projection
        for name in ("view", "clip"):
            assert np.isfinite(getattr(exactly, name)).all(), projection
        seen_points = exactly.in_front
        for name in ("ndc", "image", "depth"):
            finite = np.isfinite(getattr(exactly, name)).reshape(len(points), -1)
            assert np.array_equal(finite, np.broadcast_to(seen_points[:, None], finite.shape))
        predictions = predict(projection, points)
        assert (predictions is None) is not seen_points.any()
        if predictions is not None:
            errors = np.array(list(predictions.values()))
            assert not np.isnan(errors).any() and np.isfinite(errors[1:]).all(), projection
