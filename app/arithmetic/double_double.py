"""Arithmetic with more digits than float64 has: double-double arrays, and exact scalars.

A double-double is an unevaluated sum ``hi + lo`` of two float64 with ``|lo| <= ulp(hi)/2``: about
106 bits. The error-free transformations are those of Dekker, "A floating-point technique for
extending the available precision" (1971), and Knuth, TAOCP 2, 4.2.2; the relative errors of the
operations are below 2^-102 (Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic
building blocks of double-word arithmetic", 2017). Scalars are Python's own rationals: exact, or
rounded to `BITS` bits where a root or an angle makes them irrational.

The caller prevents overflow and underflow: products of operands must stay between 1e-290 and 1e290
for the low parts to exist.
"""

import math
from fractions import Fraction
from functools import cache, lru_cache
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]

BITS = 256  # significant bits of an irrational scalar
RELATIVE_ERROR = 2.0**-100  # bound of the relative error of each operation on double-doubles

UNDERFLOW = 1e-300  # upper bound of the loss of a product near the smallest float64

_SPLITTER = 2.0**27 + 1.0


class DoubleDouble(NamedTuple):
    """An unevaluated sum of two float64 arrays of one shape (or of shapes that broadcast)."""

    hi: Array
    lo: Array


def from_exact(value: Fraction) -> tuple[float, float]:
    """The two float64 whose sum is nearest to an exact number."""
    hi = float(value)
    return hi, float(value - Fraction(hi))


# --------------------------------------------------------------------------- arrays


def two_sum(a: Array | float, b: Array | float) -> DoubleDouble:
    """``a + b`` without any error (Knuth)."""
    total = np.asarray(a + b)
    part = total - a
    return DoubleDouble(total, (a - (total - part)) + (b - part))


def _fast_two_sum(a: Array, b: Array) -> DoubleDouble:
    """``a + b`` without any error where ``|a| >= |b|`` (Dekker)."""
    total = a + b
    return DoubleDouble(total, b - (total - a))


def _split(a: Array | float) -> tuple[Array, Array]:
    scaled = _SPLITTER * np.asarray(a)
    high = scaled - (scaled - a)
    return high, a - high


def two_product(a: Array | float, b: Array | float) -> DoubleDouble:
    """``a b`` without any error (Dekker; numpy has no fused multiply-add)."""
    product = np.asarray(a * b)
    a_high, a_low = _split(a)
    b_high, b_low = _split(b)
    error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low
    return DoubleDouble(product, error)


def add(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble:
    """``a + b``, accurate also where the two cancel."""
    s_hi, s_lo = two_sum(a.hi, b.hi)
    t_hi, t_lo = two_sum(a.lo, b.lo)
    hi, lo = _fast_two_sum(s_hi, s_lo + t_hi)
    return _fast_two_sum(hi, lo + t_lo)


def subtract(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble:
    return add(a, DoubleDouble(-b.hi, -b.lo))


def multiply(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble:
    hi, lo = two_product(a.hi, b.hi)
    return _fast_two_sum(hi, lo + (a.hi * b.lo + a.lo * b.hi))


def divide(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble:
    quotient = a.hi / b.hi
    whole = DoubleDouble(quotient, np.zeros_like(quotient))
    rest = subtract(a, multiply(b, whole))
    return _fast_two_sum(quotient, (rest.hi + rest.lo) / b.hi)


# --------------------------------------------------------------------------- scalars


def root(value: Fraction) -> Fraction:
    """The square root of a rational that is not negative, to `BITS` bits."""
    if value == 0:
        return Fraction(0)
    # As many bits below the point as make the integer's root BITS long, whatever its size.
    size = value.numerator.bit_length() - value.denominator.bit_length()
    shift = BITS + 1 - size // 2
    scaled = value * Fraction(4) ** shift
    return Fraction(math.isqrt(scaled.numerator // scaled.denominator)) / Fraction(2) ** shift


def cut(value: Fraction) -> Fraction:
    """The number cut to `BITS` bits, so that rationals do not grow without end."""
    if value == 0:
        return value
    above, below = value.numerator, value.denominator
    shift = BITS - (above.bit_length() - below.bit_length())
    if shift < 0:
        return Fraction(above // (below << -shift) << -shift)
    return Fraction((above << shift) // below, 1 << shift)


@cache
def _pi() -> Fraction:
    """Pi to more than `BITS` bits: Machin's ``16 atan(1/5) - 4 atan(1/239)``."""
    one = 1 << (BITS + 64)

    def arctangent_of_inverse(n: int) -> int:
        power, total, k = one // n, 0, 1
        while power:
            total += power // k if k % 4 == 1 else -(power // k)
            power //= n * n
            k += 2
        return total

    return Fraction(4 * (4 * arctangent_of_inverse(5) - arctangent_of_inverse(239)), one)


def _cosine_and_ratio(x: Fraction) -> tuple[Fraction, Fraction]:
    """``cos(x)`` and ``sin(x)/x`` of at most pi/4, to more than `BITS` bits: Taylor's series.

    Integers count units of ``1 / one``: rationals would take ten times as long.
    """
    one = 1 << (BITS + 64)
    square = one * x.numerator**2 // x.denominator**2
    term = cos = over_x = one
    k, sign = 0, 1
    while term:
        k, sign = k + 2, -sign
        term = term * square // (one * (k - 1) * k)
        cos += sign * term
        over_x += sign * (term // (k + 1))
    return Fraction(cos, one), Fraction(over_x, one)


@lru_cache(maxsize=64)
def cotangent_deg(angle_deg: Fraction) -> Fraction:
    """The cotangent of an angle strictly between 0 and 180 degrees, to about `BITS` bits.

    It is computed from the exact distance to 0, 90 or 180 degrees, whichever is nearest.
    """
    if angle_deg > 90:
        return -cotangent_deg(180 - angle_deg)
    small = min(angle_deg, 90 - angle_deg)
    x = cut(small * _pi() / 180)
    cos, over_x = _cosine_and_ratio(x)
    tangent = cut(x * over_x / cos)
    return tangent if small != angle_deg else cut(1 / tangent)


def cos_sin_deg(angle_deg: Fraction) -> tuple[Fraction, Fraction]:
    """Cosine and sine of any angle, to about `BITS` bits; exact at the multiples of 90 degrees."""
    quarter = round(angle_deg / 90)
    x = cut((angle_deg - 90 * quarter) * _pi() / 180)
    cos, over_x = _cosine_and_ratio(x)
    cos, sin = cut(cos), cut(x * over_x)
    return ((cos, sin), (-sin, cos), (-cos, -sin), (sin, -cos))[quarter % 4]
