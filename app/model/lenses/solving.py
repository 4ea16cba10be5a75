"""Solve for the fields of a lens: find the shortest decimals that give the typed cells.

If you type the matrix of ``near = 1`` you get 1, not 0.9999999999999999.
"""

import math
from collections.abc import Callable
from fractions import Fraction

from app.arithmetic.double_double import cotangent_deg

ROUNDING = 2.0**-49  # tolerance of a cell relative to the largest term of its sum: 8 roundings
OF_ITSELF = 2.0**-20  # tolerance relative to the cell itself: a typed 1e-20 does not count as 0
DIGITS = 17  # digits that suffice for every float64
MEANT = 12  # digits up to which a decimal may differ from a cell by a rounding; 1 in 500 matches so


def same(a: Fraction, b: Fraction, size: Fraction) -> bool:
    """Whether two numbers differ only by the rounding of terms of this size."""
    apart = abs(a - b)
    return apart <= Fraction(ROUNDING) * size and apart <= Fraction(OF_ITSELF) * abs(b)


def shortest(
    cells: Callable[..., tuple[float, ...]],
    solved: tuple[Fraction, ...],
    wanted: tuple[float, ...],
    sizes: tuple[float, ...],
) -> tuple[float, ...]:
    """The decimals with the fewest digits that give the `wanted` cells, or the solution itself.

    `cells` computes the rounded cells from the fields, `solved` are the exact fields, and `sizes`
    the least sizes of the terms of each cell.
    """
    floats = tuple(map(float, solved))
    for digits in range(1, DIGITS):
        rounded = tuple(float(f"{number:.{digits - 1}e}") for number in floats)
        try:
            near_enough = [
                abs(a - b) <= min(ROUNDING / 2.0 * max(size, abs(b)), OF_ITSELF * abs(b))
                if digits <= MEANT
                else a == b
                for a, b, size in zip(cells(*rounded), wanted, sizes, strict=True)
            ]
            if all(near_enough):
                return rounded
        except (ZeroDivisionError, ValueError, OverflowError):  # two ends round to the same decimal
            continue
    return floats


def angle_deg(cot: Fraction, size: float, times: int = 1) -> float:
    """The angle in degrees, `times` one between 0 and 180, from the cotangent of that one.

    `size` is the least size of the cotangent's terms. A step of Newton's method mends the rounding
    of atan2, which the cotangent of a wide angle shows.
    """
    part = Fraction(math.degrees(math.atan2(1.0, float(cot))))
    part += Fraction(math.degrees((cotangent_deg(part) - cot) / (1 + cot * cot)))

    def cell(angle: float) -> tuple[float, ...]:
        return (float(cotangent_deg(Fraction(angle) / times)),)

    return shortest(cell, (times * part,), (float(cot),), (size,))[0]


def ends(scale: Fraction, skew: Fraction, unit: Fraction) -> tuple[float, float]:
    """The ends of a window, from ``2 unit/(high - low)`` and ``(high + low)/(high - low)``."""

    def cells(low: float, high: float) -> tuple[float, ...]:
        extent = Fraction(high) - Fraction(low)
        return float(2 * unit / extent), float((Fraction(high) + Fraction(low)) / extent)

    solved = (skew - 1) * unit / scale, (skew + 1) * unit / scale
    low, high = shortest(cells, solved, (float(scale), float(skew)), (0.0, 1.0))
    return low, high
