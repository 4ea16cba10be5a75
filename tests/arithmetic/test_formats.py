"""Number formats and reciprocals against bit patterns, numpy's own types, and rationals."""

import struct
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.arithmetic.formats import FORMATS, TABLE, TABLE_ERROR, Format, Grid, reciprocal

ANY = st.floats(allow_nan=False, allow_infinity=False) | st.floats(-70000.0, 70000.0, width=32)
EVERY = pytest.mark.parametrize("name", FORMATS)
NAMES = st.sampled_from(list(FORMATS))


def all_numbers(name: str) -> np.ndarray:
    """All finite numbers of a format of 16 bits, from their bit patterns."""
    patterns = np.arange(2**16, dtype=np.uint32)
    if name == "float16":
        numbers = patterns.astype(np.uint16).view(np.float16).astype(np.float64)
    else:
        with np.errstate(invalid="ignore"):
            numbers = (patterns << 16).view(np.float32).astype(np.float64)
    return numbers[np.isfinite(numbers)]


def nearest(form: Format, value: float) -> float:
    """The definition: the nearest multiple of the step of the number's size, half-way to even."""
    exact, step = Fraction(value), Fraction(form.step)
    if form.digits is not None and value:
        size = abs(exact)
        while size >= step * 2**form.digits:
            step *= 2
    found = round(exact / step) * step
    return float(found) if abs(found) <= Fraction(form.largest) else np.nan


@given(NAMES, ANY)
def test_rounding_is_to_the_nearest_number_of_the_format(name: str, value: float) -> None:
    form = FORMATS[name]
    (found,) = form.rounded([value])
    assert np.array_equal(found, nearest(form, value), equal_nan=True)
    assert np.isnan(found) or abs(found - value) <= form.lost(found)


@pytest.mark.parametrize("name", ["float16", "bfloat16"])
def test_every_number_is_kept_and_every_middle_goes_to_the_even_one(name: str) -> None:
    form, numbers = FORMATS[name], all_numbers(name)
    assert np.array_equal(form.rounded(numbers), numbers)
    assert numbers.max() == form.largest
    ordered = np.unique(numbers)
    assert np.diff(ordered).min() == form.step
    middles = (ordered[1:] + ordered[:-1]) / 2.0
    below, above = ordered[:-1], ordered[1:]

    def is_even(number: float) -> bool:
        pattern = struct.pack(">e" if name == "float16" else ">f", number)
        return pattern[1] % 2 == 0  # the last byte that the format has

    even = [b if is_even(b) else a for b, a in zip(below, above, strict=True)]
    assert np.array_equal(form.rounded(middles), even)
    assert np.array_equal(form.rounded(np.nextafter(middles, np.inf)), above)
    assert np.array_equal(form.rounded(np.nextafter(middles, -np.inf)), below)


@EVERY
def test_what_is_out_of_range_is_no_number(name: str) -> None:
    form = FORMATS[name]
    rounded = form.rounded([form.largest, -form.largest, np.inf, -np.inf, np.nan])
    assert rounded[:2].tolist() == [form.largest, -form.largest]
    assert np.isnan(rounded[2:]).all()
    if name != "float64":
        last = form.largest * form.unit / (1.0 - form.unit) if form.digits else form.step
        middle = form.largest + last / 2.0  # of the largest number and the one that is missing
        assert np.isnan(form.rounded([middle, -middle])).all()
        assert form.rounded([np.nextafter(middle, 0.0)]) == form.largest


def test_a_grid_has_both_corners_and_nothing_outside() -> None:
    box = np.array([(-1.0, 2.0, 0.0), (3.0, 4.0, 1.0)])
    grid = Grid.of_box(box, 8)
    assert grid.step == 4.0 / 255.0
    corners = grid.rounded([box[0], (3.0, 2.0, 0.0)])
    assert np.allclose(corners, [box[0], (3.0, 2.0, 0.0)], rtol=0, atol=1e-15)
    outside = grid.rounded([(-1.01, 2.0, 0.0), (3.01, 2.0, 0.0)])
    assert np.isnan(outside[:, 0]).all() and not np.isnan(outside[:, 1:]).any()
    points = np.random.default_rng(2).uniform(box[0], box[1], (5000, 3))
    found = grid.rounded(points)
    assert (np.abs(found - points) <= grid.step / 2.0 + 1e-15).all()
    assert np.abs(found - points).max() > 0.499 * grid.step
    assert np.allclose(grid.rounded(found), found, rtol=0, atol=1e-15)


def test_a_box_without_extent_keeps_its_point() -> None:
    point = (0.1, -7.0, 3.0)
    assert Grid.of_box([point, point], 12).rounded([point]).tolist() == [list(point)]


def test_the_table_is_known_entry_by_entry() -> None:
    assert len(TABLE) == 256
    assert TABLE[0] == 511.0 / 512.0 and TABLE[-1] == 0.5 + 0.0
    assert ((TABLE * 512.0) % 1.0 == 0.0).all()
    worst = max(
        abs(Fraction(entry) * (1 + Fraction(i + end, 256)) - 1)
        for i, entry in enumerate(TABLE.tolist())
        for end in (0, 1)
    )
    assert Fraction(TABLE_ERROR) == worst and 2.0**-8.5 < TABLE_ERROR < 2.0**-8.4


@EVERY
@pytest.mark.parametrize("steps", [0, 1, 2])
def test_reciprocals_are_within_their_bounds(name: str, steps: int) -> None:
    form, rng = FORMATS[name], np.random.default_rng(3)
    divisors = form.rounded(2.0 ** rng.uniform(-7.0, 10.0, 300))
    found, bounds = reciprocal(divisors, form, steps)
    for r, w, bound in zip(found.tolist(), divisors.tolist(), bounds.tolist(), strict=True):
        assert abs(Fraction(r) * Fraction(w) - 1) <= Fraction(bound)
    assert np.array_equal(found, form.rounded(found))


def test_each_operation_of_a_newton_step_is_rounded() -> None:
    form = FORMATS["float16"]
    divisors = form.rounded(np.random.default_rng(5).uniform(0.5, 8.0, 200))
    guesses, found = (reciprocal(divisors, form, steps)[0].tolist() for steps in (0, 1))
    for w, guess, r in zip(divisors.tolist(), guesses, found, strict=True):
        rest = nearest(form, 2.0 - nearest(form, w * guess))
        assert r == nearest(form, guess * rest)


def test_each_newton_step_squares_the_error() -> None:
    w = np.random.default_rng(4).uniform(1.0, 2.0, 10_000)
    errors = [np.abs(reciprocal(w, FORMATS["float64"], n)[0] * w - 1.0).max() for n in range(3)]
    assert errors[1] == pytest.approx(errors[0] ** 2, rel=1e-6)
    assert errors[2] == pytest.approx(errors[1] ** 2, rel=1e-4)


def test_no_reciprocal_of_what_is_not_above_0() -> None:
    found, _ = reciprocal(np.array([0.0, -1.0, np.nan]), FORMATS["float32"], 1)
    assert np.isnan(found).all()
