"""Double-double arithmetic and the exact scalars, against rationals and mpmath."""

import math
from collections.abc import Callable
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from app.arithmetic import double_double as dd
from app.arithmetic.double_double import DoubleDouble

mp = mpmath.mp.clone()
mp.dps = 120
QUICK = settings(max_examples=300)

#: Where products and their low parts neither overflow nor vanish.
NUMBERS = st.one_of(
    st.floats(1e-60, 1e60), st.floats(-1e60, -1e-60), st.floats(0.5, 2.0), st.floats(-2.0, -0.5)
)


@st.composite
def doubles(draw: st.DrawFn) -> DoubleDouble:
    """An unevaluated sum as the operations leave it."""
    hi = draw(NUMBERS)
    lo = draw(st.sampled_from([0.0, 1.0, -1.0]) | st.floats(-1.0, 1.0)) * math.ulp(hi) / 2.0
    return DoubleDouble(np.asarray(hi + lo), np.asarray(lo - ((hi + lo) - hi)))


def exactly(value: DoubleDouble) -> Fraction:
    return Fraction(float(value.hi)) + Fraction(float(value.lo))


@given(NUMBERS, NUMBERS)
@example(1.0, 2.0**-80)
@example(1e60, -1e60)
@QUICK
def test_sums_and_products_of_two_are_exact(a: float, b: float) -> None:
    assert exactly(dd.two_sum(a, b)) == Fraction(a) + Fraction(b)
    assert exactly(dd.two_product(a, b)) == Fraction(a) * Fraction(b)


OPERATIONS: dict[str, tuple[Callable[..., DoubleDouble], Callable[..., Fraction]]] = {
    "add": (dd.add, lambda a, b: a + b),
    "subtract": (dd.subtract, lambda a, b: a - b),
    "multiply": (dd.multiply, lambda a, b: a * b),
    "divide": (dd.divide, lambda a, b: a / b),
}


@pytest.mark.parametrize(("operation", "exact"), OPERATIONS.values(), ids=OPERATIONS)
@given(a=doubles(), b=doubles())
@QUICK
def test_operations_keep_what_they_promise(
    operation: Callable[..., DoubleDouble],
    exact: Callable[[Fraction, Fraction], Fraction],
    a: DoubleDouble,
    b: DoubleDouble,
) -> None:
    found, expected = operation(a, b), exact(exactly(a), exactly(b))
    assert abs(exactly(found) - expected) <= Fraction(dd.RELATIVE_ERROR) * abs(expected)
    # The parts do not overlap: hi is the sum rounded.
    assert float(found.hi) == float(found.hi + found.lo)


def test_arrays_are_their_elements_and_broadcast() -> None:
    rng = np.random.default_rng(1)
    a = DoubleDouble(rng.normal(size=50), rng.normal(size=50) * 1e-17)
    b = DoubleDouble(np.asarray(1.7), np.asarray(1e-17))
    for operation, exact in OPERATIONS.values():
        found = operation(a, b)
        assert found.hi.shape == found.lo.shape == (50,)
        for hi, lo, got_hi, got_lo in zip(*a, *found, strict=True):
            expected = exact(exactly(DoubleDouble(hi, lo)), exactly(b))
            error = abs(exactly(DoubleDouble(got_hi, got_lo)) - expected)
            assert error <= Fraction(dd.RELATIVE_ERROR) * abs(expected)


FRACTIONS = st.builds(
    lambda top, below, power: Fraction(top, below) * Fraction(2) ** power,
    st.integers(1, 10**40),
    st.integers(1, 10**40),
    st.integers(-700, 700),
)


@given(FRACTIONS, st.booleans())
@QUICK
def test_two_numbers_are_nearest_to_an_exact_one(value: Fraction, negative: bool) -> None:
    value = -value if negative else value
    hi, lo = dd.from_exact(value)
    assert hi == float(value)
    assert abs(value - Fraction(hi) - Fraction(lo)) <= abs(value) * Fraction(1, 2**106)


@given(FRACTIONS)
@example(Fraction(2))
@example(Fraction(1, 3))
@QUICK
def test_root_has_its_bits(value: Fraction) -> None:
    found = dd.root(value)
    low, high = (found * (1 + sign * Fraction(1, 2 ** (dd.BITS - 1))) for sign in (-1, 1))
    assert low**2 < value < high**2


def test_root_of_a_square_is_exact() -> None:
    assert dd.root(Fraction(0)) == 0
    for whole in (1, 2, 3, 10**20):
        assert dd.root(Fraction(whole**2)) == whole
        assert dd.root(Fraction(1, 4 ** whole.bit_length())) == Fraction(1, 2 ** whole.bit_length())


@given(FRACTIONS, st.booleans())
@QUICK
def test_cut_has_its_bits_and_no_more(value: Fraction, negative: bool) -> None:
    value = -value if negative else value
    found = dd.cut(value)
    assert abs(found - value) <= abs(value) * Fraction(1, 2 ** (dd.BITS - 1))
    odd = found.numerator // (found.numerator & -found.numerator)
    assert abs(odd).bit_length() <= dd.BITS + 2
    assert dd.cut(Fraction(0)) == 0


@given(st.floats(1e-100, 180.0, exclude_max=True))
@example(45.0)
@example(90.0)
@example(135.0)
@example(math.nextafter(90.0, 91.0))
@example(math.nextafter(180.0, 0.0))
@example(1e-100)
@QUICK
def test_cotangent_against_mpmath(angle_deg: float) -> None:
    found = dd.cotangent_deg(Fraction(angle_deg))
    expected = mp.cot(mp.mpf(angle_deg) * mp.pi / 180)
    if angle_deg == 90.0:
        assert found == 0
        return
    ratio = mp.mpf(found.numerator) / mp.mpf(found.denominator) / expected
    assert abs(ratio - 1) < mp.mpf(2) ** -240


def test_cotangents_known_by_heart() -> None:
    assert dd.cotangent_deg(Fraction(90)) == 0
    for angle_deg, expected in ((45, 1.0), (135, -1.0), (30, math.sqrt(3.0))):
        assert float(dd.cotangent_deg(Fraction(angle_deg))) == pytest.approx(expected, rel=1e-15)
