"""Back from the picture: every way against 80 digits, its bound, and numpy's own float32."""

import itertools
import random
from dataclasses import replace

import numpy as np
import pytest

from app.model.projection import Array, Camera, Perspective, Projection, Vector
from app.model.refusal import Refusal
from app.precision.unprojecting import (
    THERE,
    WAYS,
    check_pixel,
    exact_points,
    float32_pixels,
    followed,
    kept_matrices,
    off_there,
)
from tests.fuzz import bounds
from tests.oracles.exact import Exact, mp
from tests.oracles.illustrations import random_projection
from tests.oracles.unprojected import unprojected

START = Projection(
    Camera((5.0, 4.5, 8.0), (0.0, 2.2, 0.0)), Perspective(60.0, 0.1, 1000.0), (1920, 1080)
)
ORIGINS = ((0.0, 0.0, 0.0), (57740.0, 57739.5, 57743.0), (-1e6, 3.0, 1e3))


def some_pixels(dice: random.Random, projection: Projection, count: int) -> Array:
    image = [[dice.uniform(0, side) for side in projection.image_size] for _ in range(count)]
    depth = [dice.choice((dice.random(), 1 - 10 ** dice.uniform(-5, 0))) for _ in range(count)]
    return float32_pixels(np.array(image), np.array(depth))


def offs(projection: Projection, pixels: Array, answers: Array, origin: Vector) -> Array:
    """The errors (n, 3) of points (n, 3) that are measured from the origin, against 80 digits."""
    errors = []
    for pixel, answer in zip(pixels.tolist(), answers.tolist(), strict=True):
        true = unprojected(projection, pixel)
        eye = zip(true, projection.camera.eye, origin, strict=True)
        places = [part + mp.mpf(e) - mp.mpf(o) for part, e, o in eye]
        errors.append([float(mp.mpf(a) - b) for a, b in zip(answer, places, strict=True)])
    return np.array(errors)


def test_no_bound_is_below_the_error_of_any_way_lens_and_depth_range() -> None:
    dice, ratios = random.Random(49), []
    for seed in range(40):
        projection = random_projection(dice, START)
        if seed % 4 == 1:
            projection = replace(projection, lens=projection.lens.replaced(far=30.0))
            projection = projection.with_lens(dice.choice(("frustum", "orthographic", "oblique")))
        projection = projection.with_depth(dice.choice(("opengl", "direct3d", "reversed")))
        pixels, origin = some_pixels(dice, projection, 4), dice.choice(ORIGINS)
        for way, form in itertools.product(WAYS, ("float32", "float64")):
            value, bound = followed(projection, pixels, way, form, origin)
            error = np.abs(offs(projection, pixels, value.T, origin)).T
            assert (error <= bound).all(), (seed, way, form)
            both = np.linalg.norm(bound, axis=0) / np.maximum(np.linalg.norm(error, axis=0), 1e-300)
            ratios += both.tolist()
    assert 1.0 <= np.median(ratios) < 25.0


def test_the_rationals_are_the_points_of_80_digits() -> None:
    dice = random.Random(7)
    for _ in range(10):
        projection = random_projection(dice, START)
        pixels = some_pixels(dice, projection, 3)
        points = exact_points(projection, pixels, ORIGINS[1])
        answers = np.array([[mp.mpf(p.numerator) / p.denominator for p in q] for q in points])
        away = np.linalg.norm(projection.world_from_image(pixels) - projection.camera.eye, axis=1)
        assert (
            np.abs(offs(projection, pixels, answers, ORIGINS[1])).max(axis=1) < 1e-25 * away
        ).all()


def test_one_product_is_numpy_s_float32_term_by_term() -> None:
    pixels = some_pixels(random.Random(1), START, 50)
    value, _ = followed(START, pixels, "inverse", "float32", ORIGINS[1])
    single = np.float32
    (to_ndc, _), (inverse, _) = (
        each[0] for each in kept_matrices(START, "inverse", ORIGINS[1], "float32")
    )
    x, y, d = pixels.T.astype(single)
    ndc = [
        x * single(to_ndc[0, 0]) - single(1),
        y * single(to_ndc[1, 1]) + single(1),
        d + d - single(1),
    ]
    m = inverse.astype(single)
    rows = [((r[0] * ndc[0] + r[1] * ndc[1]) + r[2] * ndc[2]) + r[3] for r in m]
    assert np.array_equal(value, np.array([row / rows[3] for row in rows[:3]]))
    # The cells are those of the inverse at 80 digits, rounded once.
    eye = np.array(START.camera.eye) - ORIGINS[1]
    near, top = 0.1, 0.1 * mp.tan(mp.pi / 6)
    u, v, n = Exact(START).frame
    for row in range(3):
        across = [u[row] * top * 16 / 9 / near, v[row] * top / near]
        over_w = [
            (1 / mp.mpf(1000.0) - 1 / mp.mpf(near)) / 2,
            (1 / mp.mpf(1000.0) + 1 / mp.mpf(near)) / 2,
        ]
        cells = [*across, float(eye[row]) * over_w[0], float(eye[row]) * over_w[1] - n[row]]
        assert inverse[row] == pytest.approx([float(cell) for cell in cells], rel=1e-6)


@pytest.mark.parametrize("depth", ["opengl", "direct3d", "reversed"])
def test_far_from_the_origin_the_ray_is_a_thousand_times_better(depth: str) -> None:
    """The numbers of the issue: parts of the distance, for the letter F some 10 away, near 0.1."""
    projection = START.with_depth(depth)  # type: ignore[arg-type]
    trace = projection.trace(
        np.random.default_rng(2).uniform((-1.5, 0, -0.5), (1.5, 5, 0.5), (64, 3))
    )
    pixels = float32_pixels(trace.image, trace.depth)
    away = np.linalg.norm(trace.world - projection.camera.eye, axis=1)

    def worst(way: str, origin: float) -> float:
        start = tuple((np.array(projection.camera.eye) + origin / 3**0.5).tolist())
        value, _ = followed(projection, pixels, way, "float32", start)
        error = np.linalg.norm(offs(projection, pixels, value.T, start), axis=1)
        return float((error / away).max())

    # Reversed, 1/w is a sum of 1/far and a small number, and no difference near 0.
    low, high = (5e-4, 5e-3) if depth == "reversed" else (0.02, 0.5)
    assert low < worst("inverse", 1e5) < high and low < 100 * worst("inverse", 1e3) < high
    for way in ("ray", "inverses"):
        assert 2e-5 < worst(way, 1e5) < 4e-4 and worst(way, 1e3) < 2e-5
    near = [worst(way, 1.0) for way in WAYS]
    assert max(near) < 3.0 * min(near)


def test_one_matrix_or_two_to_the_picture_hardly_differ() -> None:
    points = np.random.default_rng(3).uniform((-1.5, 0, -0.5), (1.5, 5, 0.5), (40, 3))
    origin = tuple((np.array(START.camera.eye) + 1e5 / 3**0.5).tolist())
    one, two = (
        max(
            off_there(START, point, START.trace(point).ndc, way, "float32", origin)
            for point in points
        )
        for way in THERE
    )
    assert 0.1 < two < 2.0 and 0.5 < one / two < 2.0
    trace = START.trace(points[0])
    value, _ = followed(START, points[:1] - origin, "one", "float64", origin)
    assert value[:, 0] == pytest.approx(trace.ndc, abs=1e-9)


@pytest.mark.parametrize(
    ("pixel", "said"),
    [
        ((1921.0, 5.0, 0.5), "x = 1921: must be at most 1920."),
        ((-1.0, 5.0, 0.5), "x = -1: must be at least 0."),
        ((5.0, 1080.5, 0.5), "y = 1080.5: must be at most 1080."),
        ((5.0, 5.0, 1.5), "depth = 1.5: must be at most 1."),
        ((5.0, 5.0, -0.5), "depth = -0.5: must be at least 0."),
        ((5.0, 5.0, 1.0), "depth = 1: is at infinity, so it is a direction and not a point."),
    ],
)
def test_what_has_no_point_is_refused_in_one_sentence(
    pixel: tuple[float, float, float], said: str
) -> None:
    endless = replace(START, lens=Perspective(60.0, 0.1, float("inf")))
    with pytest.raises(Refusal) as caught:
        check_pixel(endless, pixel)
    assert str(caught.value) == said
    reversed_ = endless.with_depth("reversed")
    check_pixel(reversed_, (5.0, 5.0, 1.0))
    with pytest.raises(Refusal, match="depth = 0: is at infinity"):
        exact_points(reversed_, np.array([(5.0, 5.0, 0.0)]), ORIGINS[0])


def test_the_bounds_of_random_cases_hold() -> None:
    ratios = bounds.ratios_of("unprojection", 49, 2_000)
    assert min(ratios.values(), key=np.min).min() >= 1.0
    assert all(np.median(each) < 25.0 for each in ratios.values())
