"""Number formats of cheap hardware, imitated bit for bit in float64 arrays.

A format rounds to the nearest of its numbers, and to the even one half-way (IEEE 754-2019, 4.3.1).
One operation in a format is the float64 operation, rounded: for up to 24 digits the second rounding
changes nothing (Figueroa, "When is double rounding innocuous?", 1995), and the products of 16.16
numbers that stay in range are exact in float64. There is no infinity: a result that is out of range
is NaN, and so is all that is computed from it. Arrays of rationals are divided to the nearest
float64; they are not reduced to lowest terms, because the chain of operations of a point is short.

==========  ======  ======================  =====================================================
format      digits  step near 0             source
==========  ======  ======================  =====================================================
float64     53      2^-1074                 IEEE 754-2019, table 3.5: binary64
float32     24      2^-149                  binary32
float16     11      2^-24                   binary16
bfloat16    8       2^-133                  Intel, "BFLOAT16: Hardware Numerics Definition" (2018)
16.16       31      2^-16, everywhere       two's complement with 16 bits behind the point
==========  ======  ======================  =====================================================
"""

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from app.arithmetic.double_double import Array

_NATIVE = {"float64": np.float64, "float32": np.float32, "float16": np.float16}
"""The formats to which numpy rounds, once, as IEEE 754 demands."""


@dataclass(frozen=True)
class Format:
    """Numbers of limited size with a limited number of digits."""

    name: str
    bits: int  # stored bits of one number
    digits: int | None  # significant bits of a number of ordinary size; None for fixed point
    step: float  # distance of neighbours near 0, and for fixed point everywhere; a power of 2
    largest: float

    @property
    def unit(self) -> float:
        """Bound of the relative error of rounding; 0 for fixed point (Higham, 2.2)."""
        return 0.0 if self.digits is None else 2.0**-self.digits

    def rounded(self, values: ArrayLike) -> Array:
        """The nearest numbers of the format; NaN where they are out of range."""
        given = np.asarray(values, dtype=np.float64)
        with np.errstate(all="ignore"):
            if self.digits is None:
                nearest = np.rint(given / self.step) * self.step
            elif self.name in _NATIVE:
                nearest = given.astype(_NATIVE[self.name]).astype(np.float64, copy=False)
            else:
                nearest = _with_digits(given, self.digits)
                tiny = np.abs(given) < self.step * 2.0 ** (self.digits - 1)
                if tiny.any():  # subnormal numbers are fixed point
                    nearest = np.where(tiny, np.rint(given / self.step) * self.step, nearest)
            good = np.abs(nearest) <= self.largest
        return nearest if good.all() else np.where(good, nearest, np.nan)

    def lost(self, sizes: ArrayLike) -> Array:
        """Bounds of the rounding errors of numbers of these sizes."""
        return np.asarray(self.unit * np.abs(sizes) + self.step / 2.0)


def _with_digits(values: Array, digits: int) -> Array:
    """Round to significant bits, half-way to even: a carry into the exponent is right, too."""
    cut = np.uint64(53 - digits)
    one = np.uint64(1)
    bits = values.view(np.uint64) if values.flags.c_contiguous else values.copy().view(np.uint64)
    odd = (bits >> cut) & one
    bits = bits + ((one << (cut - one)) - one + odd)
    bits &= ~((one << cut) - one)
    return np.asarray(bits.view(np.float64))


class Grid(NamedTuple):
    """The places that quantised vertices of a box can have.

    Every axis has the same step, the box's longest side over ``2^bits - 1``, as in Draco
    (`AttributeQuantizationTransform`) and gltfpack. glTF's KHR_mesh_quantization stores the counts
    as normalised integers and puts lower corner and step into the node's matrix.
    """

    bits: int  # of one coordinate
    lower: Array  # the box's lower corner, (3,)
    step: float

    @classmethod
    def of_box(cls, box: ArrayLike, bits: int) -> "Grid":
        """The grid over a box, (2, 3): lower and upper corner."""
        lower, upper = np.asarray(box, dtype=np.float64)
        side = float((upper - lower).max())
        return cls(bits, lower, (side or 1.0) / (2.0**bits - 1.0))

    def rounded(self, values: ArrayLike) -> Array:
        """The nearest places of points (..., 3); NaN for a coordinate outside the box."""
        count = np.rint((np.asarray(values, dtype=np.float64) - self.lower) / self.step)
        good = (count >= 0.0) & (count < 2.0**self.bits)
        return np.where(good, self.lower + self.step * count, np.nan)


FORMATS: dict[str, Format] = {  # the formats that can compute, and store vertices
    form.name: form
    for form in (
        Format("float64", 64, 53, 2.0**-1074, float(np.finfo(np.float64).max)),
        Format("float32", 32, 24, 2.0**-149, (2.0 - 2.0**-23) * 2.0**127),
        Format("float16", 16, 11, 2.0**-24, 65504.0),
        Format("bfloat16", 16, 8, 2.0**-133, (2.0 - 2.0**-7) * 2.0**127),
        Format("fixed 16.16", 32, None, 2.0**-16, 2.0**15 - 2.0**-16),
    )
}

QUANTISED: dict[str, int] = {f"{bits} bits": bits for bits in range(8, 17)}
"""The further formats of vertices: bits of a coordinate over the box of the mesh."""

SNAPS: dict[str, float] = {"none": 0.0, "whole px": 1.0, "1/4 px": 0.25, "1/16 px": 0.0625}
"""The steps of screen positions. OpenGL demands at least 1/16 px (GL_SUBPIXEL_BITS is 4)."""

RECIPROCALS: dict[str, int | None] = {
    "exact": None, "table": 0, "table, 1 Newton step": 1, "table, 2 Newton steps": 2,
}  # fmt: skip
"""Newton steps after the table; None for a division that is rounded once."""

# --------------------------------------------------------------------------- reciprocals

_INDEX_BITS = 8
_STARTS = 1.0 + np.arange(2.0**_INDEX_BITS) / 2.0**_INDEX_BITS
_ENDS = _STARTS + 2.0**-_INDEX_BITS
TABLE: Array = np.rint(2.0 ** (_INDEX_BITS + 1) * 2.0 / (_STARTS + _ENDS)) / 2.0 ** (
    _INDEX_BITS + 1
)
"""Reciprocals of the middles of 256 parts of [1, 2): 8 bits in, 8 behind the leading one out.

The table is the one of Das Sarma and Matula, "Measuring the accuracy of ROM reciprocal tables"
(1994), which they prove to be the best.
"""
TABLE_ERROR = float(np.maximum(np.abs(TABLE * _STARTS - 1.0), np.abs(TABLE * _ENDS - 1.0)).max())
"""Bound of the table's relative error: it is largest at an end of a part; 2^-8.4."""


def reciprocal(divisors: Array, numbers: Format, steps: int) -> tuple[Array, Array]:
    """Approximate ``1/w`` in a format from the table, and bound the relative errors.

    The divisors w are above 0; the answer to others is NaN. Each Newton step ``r (2 - w r)``
    squares the relative error e of r (Markstein, "Computation of elementary functions on the IBM
    RISC System/6000 processor", 1990).

    With roundings d_i below u, and s half a step near 0:
    ``w r' - 1 = (1 + e)(1 - e - (1 + e) d_1 - s)(1 + d_2)(1 + d_3) - 1 + w s``.
    """
    fraction, exponent = np.frexp(np.where(divisors > 0.0, divisors, np.nan))
    known = np.isfinite(fraction)
    part = np.where(known, fraction * 2.0 ** (_INDEX_BITS + 1) - 2.0**_INDEX_BITS, 0.0)
    guess = np.ldexp(TABLE[part.astype(np.intp)], 1 - exponent)
    unit, half = numbers.unit, numbers.step / 2.0
    inverse = numbers.rounded(np.where(known, guess, np.nan))
    error: Array = (1.0 + TABLE_ERROR) * (1.0 + unit) - 1.0 + divisors * half
    for _ in range(steps):
        product = numbers.rounded(divisors * inverse)
        inverse = numbers.rounded(inverse * numbers.rounded(2.0 - product))
        left = error**2 + (1.0 + error) * ((1.0 + error) * unit + half)
        error = (1.0 + left) * (1.0 + unit) ** 2 - 1.0 + divisors * half
    return inverse, error


_MANTISSA = 53


class Quotients:
    """An array ``above / below`` that computes like a number, also with scalar rationals.

    `above` (n,) holds ints, `below` is one for all or (n,). A quotient by 0 is NaN as a float.
    """

    __slots__ = ("above", "below")
    __array_ufunc__ = None

    def __init__(self, above: Any, below: Any) -> None:
        self.above, self.below = above, below

    @classmethod
    def of(cls, values: Array) -> "Quotients":
        """The exact values of finite float64, (n,)."""
        mantissas, exponents = np.frexp(values)
        exponents = exponents - _MANTISSA
        least = int(exponents.min(initial=0, where=values != 0.0))
        whole = (mantissas * 2.0**_MANTISSA).astype(np.int64).astype(object)
        shifts = np.where(values != 0.0, exponents - least, 0).astype(object)
        return cls(whole << shifts, 1 << -least)

    def _on_common_base(self, other: Any) -> tuple[Any, Any, Any]:
        """Return both numerators over a common denominator, and that denominator."""
        above, below = _parts(other)
        if below is self.below:
            return self.above, above, below
        if isinstance(below, int) and isinstance(self.below, int):
            common = math.lcm(below, self.below)
            return self.above * (common // self.below), above * (common // below), common
        return self.above * below, above * self.below, below * self.below

    def __neg__(self) -> "Quotients":
        return Quotients(-self.above, self.below)

    def __add__(self, other: Any) -> "Quotients":
        mine, its, below = self._on_common_base(other)
        return Quotients(mine + its, below)

    def __sub__(self, other: Any) -> "Quotients":
        return self.__add__(-other)

    def __mul__(self, other: Any) -> "Quotients":
        above, below = _parts(other)
        return Quotients(self.above * above, self.below * below)

    def __truediv__(self, other: Any) -> "Quotients":
        above, below = _parts(other)
        return Quotients(self.above * below, self.below * above)

    __radd__, __rmul__ = __add__, __mul__

    def is_negative(self) -> Any:
        """Whether each quotient is below 0, (n,)."""
        is_one = isinstance(self.below, int)  # no product, which is long
        signed = self.above * (int(self.below > 0) * 2 - 1) if is_one else self.above * self.below
        return np.asarray(signed < 0, dtype=bool)

    def floats(self) -> Array:
        """The nearest float64, (n,): infinite beyond the largest one."""
        return np.asarray(_nearest(self.above, self.below).astype(np.float64))


def _parts(number: Any) -> tuple[Any, Any]:
    if isinstance(number, Quotients):
        return number.above, number.below
    return Fraction(number).as_integer_ratio()


def _quotient(above: int, below: int) -> float:
    try:
        return above / below  # Python rounds it correctly
    except OverflowError:
        return math.inf if (above > 0) == (below > 0) else -math.inf
    except ZeroDivisionError:
        return math.nan


_nearest: Any = np.frompyfunc(_quotient, 2, 1)
