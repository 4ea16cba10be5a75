"""The drift of a turned camera, against products in rationals and sines in 80 digits."""

import random
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from itertools import islice
from typing import Any

import numpy as np
import pytest

from app.model.projection import Array, Orthographic, Projection
from app.precision.drift import AXIS, BLOCK, drifted, errors_px, exact_turn, orthonormal, rounds_of
from app.scenes.scene import load
from tests.fuzz.drift import unit_axis
from tests.oracles.exact import Exact, mp
from tests.oracles.illustrations import random_projection

NUMBERS = ("float16", "float32", "float64")
DIGITS = {"float16": 11, "float32": 24, "float64": 53}
WAYS = ("products", "renormalised", "fast", "sines")


def turn(degrees: int, axis: Any = AXIS) -> Any:
    """Rodrigues' formula in 80 digits."""
    a = mp.matrix([mp.mpf(part.numerator) / part.denominator for part in axis])
    across = mp.matrix([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])
    angle = mp.radians(degrees)
    return mp.eye(3) + mp.sin(angle) * across + (1 - mp.cos(angle)) * across * across


def nearest(value: Any, digits: int) -> Fraction:
    """The nearest number of some binary digits, half-way to even, of ordinary size."""
    exact = Fraction(*value) if isinstance(value, tuple) else Fraction(value)
    if not exact:
        return exact
    size = abs(exact).numerator.bit_length() - abs(exact).denominator.bit_length()
    size += abs(exact) >= Fraction(2) ** size
    step = Fraction(2) ** max(size - digits, -24 if digits == 11 else -1000)
    return round(exact / step) * step


def by_hand(numbers: str, frames: int) -> list[list[Fraction]]:
    """Products of turns, every operation rounded, with rationals for numbers."""
    digits, exact = DIGITS[numbers], turn(1)

    def rounded(value: Fraction) -> Fraction:
        return nearest(value, digits)

    def fraction(cell: Any) -> Fraction:
        return Fraction(int(mp.nint(cell * 2**250)), 2**250)

    step = [[rounded(fraction(exact[i, j])) for j in range(3)] for i in range(3)]
    axes = [[Fraction(i == j) for j in range(3)] for i in range(3)]
    for _ in range(frames):
        axes = [
            [
                rounded(
                    rounded(rounded(row[0] * axes[0][j]) + rounded(row[1] * axes[1][j]))
                    + rounded(row[2] * axes[2][j])
                )
                for j in range(3)
            ]
            for row in step
        ]
    return axes


@pytest.mark.parametrize("numbers", NUMBERS)
def test_products_are_those_of_rationals_rounded_at_every_operation(numbers: str) -> None:
    off, _ = drifted(numbers, "products", 1)
    expected = np.array(by_hand(numbers, 360), dtype=np.float64) - np.eye(3)
    assert (off == expected).all()


@pytest.mark.parametrize("degrees", [1, BLOCK, 90, 180])
def test_an_exact_turn_has_100_bits(degrees: int) -> None:
    hi, lo = exact_turn(degrees)
    with mp.workdps(60):
        for i in range(3):
            for j in range(3):
                whole = mp.mpf(float(hi[i, j])) + mp.mpf(float(lo[i, j]))
                assert abs(whole - turn(degrees)[i, j]) < mp.mpf(2) ** -105


@pytest.mark.parametrize("numbers", NUMBERS)
def test_a_fast_inverse_root_is_within_a_fifth_of_a_per_cent(numbers: str) -> None:
    lengths = np.geomspace(0.05, 20.0, 999).astype(numbers)
    axes = np.zeros((3, 3, 999), dtype=numbers)
    axes[0, 0], axes[1, 1], axes[2, 2] = lengths, 1.0, lengths
    fast, exact = (orthonormal(axes, is_fast).astype(np.float64) for is_fast in (True, False))
    least = 0.996 if numbers == "float16" else 0.9982
    assert (fast[2, 2] >= least).all() and (fast[2, 2] <= 1.003).all()
    assert fast[2, 2].min() < 0.9984  # one Newton step leaves 0.175 %
    assert exact[2, 2] == pytest.approx(1.0, abs=3 * float(np.finfo(numbers).eps))


def test_renormalised_axes_are_orthonormal_and_have_drifted_all_the_same() -> None:
    for numbers in ("float32", "float64"):
        unit = float(np.finfo(numbers).eps)
        off, _ = drifted(numbers, "renormalised", 20)
        axes = np.eye(3) + off
        assert axes @ axes.T == pytest.approx(np.eye(3), abs=6 * unit)
        assert np.abs(off).max() > 4 * unit


def test_the_drift_of_a_fast_root_grows_by_as_much_in_each_round() -> None:
    sizes = [float(np.linalg.norm(drifted("float32", "fast", n)[0])) for n in (1, 10, 20)]
    assert sizes[1] == pytest.approx(10 * sizes[0], rel=0.12)
    assert sizes[2] == pytest.approx(20 * sizes[0], rel=0.12)


def test_rounds_that_are_asked_for_one_by_one_are_those_asked_for_at_once() -> None:
    at_once = [*islice(rounds_of("float32", "fast", (exact_turn(1), exact_turn(BLOCK))), 7)]
    for rounds in (2, 1, 3, 7):
        off, bound = drifted("float32", "fast", rounds)
        assert (off == at_once[rounds - 1][0]).all() and bound == at_once[rounds - 1][1]


def test_a_lesson_may_be_checked_beside_the_window() -> None:
    """Both ask for rounds that none has asked for before."""
    with ThreadPoolExecutor(4) as threads:
        asked = [threads.submit(drifted, "float32", "fast", rounds) for rounds in (44, 43, 42, 41)]
        offs = [each.result()[0] for each in asked]
    for rounds, off in zip((44, 43, 42, 41), offs, strict=True):
        assert (off == drifted("float32", "fast", rounds)[0]).all()


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("numbers", NUMBERS)
def test_the_bound_of_the_axes_is_not_below_their_error(numbers: str, way: str) -> None:
    for rounds in (1, 2, 7, 30):
        off, bound = drifted(numbers, way, rounds)
        if np.isfinite(off).all():
            assert 0.0 < np.linalg.norm(off) <= bound, rounds


@pytest.mark.parametrize("numbers", NUMBERS)
def test_the_bound_of_sines_allows_four_units_of_each_and_hardly_more(
    monkeypatch: pytest.MonkeyPatch, numbers: str
) -> None:
    """On any machine: the largest error of the worst sines is over half of what is left for it."""
    unit, sines = float(np.finfo(numbers).eps) / 2.0, (np.cos, np.sin)
    largest = 0.0
    for signs in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        for name, exact, sign in zip(("cos", "sin"), sines, signs, strict=True):

            def off_by_four(angles: Array, exact: Any = exact, sign: int = sign) -> Array:
                given = np.asarray(exact(angles.astype(np.float64)) + 4 * sign * unit)
                return given.astype(angles.dtype)

            monkeypatch.setattr(np, name, off_by_four)
        for rounds in (1, 9, 29, 113, 161):
            off, bound = drifted(numbers, "sines", rounds)
            error = float(np.linalg.norm(off))
            assert error <= bound
            angle = Fraction(
                float(np.dtype(numbers).type(360 * rounds) * np.dtype(numbers).type(np.pi / 180.0))
            )
            with mp.workdps(60):
                missed = float(
                    abs(mp.mpf(angle.numerator) / angle.denominator - 2 * mp.pi * rounds)
                )
            largest = max(largest, (error - 1.4143 * missed) / (bound - 1.4143 * missed))
    assert largest > 0.49


def test_pixels_are_those_of_the_drifted_axes_in_80_digits() -> None:
    dice = random.Random(49)
    compared = 0
    for _ in range(60):
        seen = random_projection(dice, load("letter-f").start)
        points = np.array([[dice.uniform(-2, 2) for _ in range(3)] for _ in range(5)])
        points = points[seen.trace(points).in_front]
        off = 1e-3 * np.array([[dice.uniform(-1, 1) for _ in range(3)] for _ in range(3)])
        px, bounds = errors_px(seen, points, off, float(np.linalg.norm(off)))
        for point, error, most in zip(points.tolist(), px, bounds, strict=True):
            true = exact_error(seen, point, off)
            assert error == pytest.approx(true, rel=1e-9, abs=1e-9 * float(np.abs(true).max()))
            assert np.hypot(*error) <= most
            compared += 1
    assert compared > 150


def exact_error(seen: Projection, point: list[float], off: Any) -> Any:
    exact = Exact(seen)
    q = mp.matrix(list(exact(point).view))
    moved = q + mp.matrix(off.tolist()) * q
    matrix = mp.matrix(seen.clip_from_view.tolist())
    sides = [mp.mpf(side) / 2 for side in seen.image_size]
    pixels = []
    for place in (q, moved):
        clip = matrix * mp.matrix([*place, 1])
        pixels.append([clip[0] / clip[3] * sides[0], -clip[1] / clip[3] * sides[1]])
    return np.array([float(b - a) for a, b in zip(*pixels, strict=True)])


def test_a_point_behind_the_drifted_eye_has_no_error_and_no_bound() -> None:
    seen = load("letter-f").start
    off = np.diag([0.0, 0.0, -2.0])
    px, bounds = errors_px(seen, np.zeros((1, 3)), off, 2.0)
    assert np.isnan(px).all() and np.isinf(bounds).all()
    flat = Orthographic(-1.0, 1.0, -1.0, 1.0, -1.0, 30.0)
    px, bounds = errors_px(seen.with_lens(flat.kind), np.zeros((1, 3)), off, 2.0)
    assert np.isfinite(px).all() and np.isfinite(bounds).all()


def test_random_axes_are_of_length_1() -> None:
    dice = random.Random(1)
    for _ in range(20):
        assert sum(part * part for part in unit_axis(dice)) == 1
