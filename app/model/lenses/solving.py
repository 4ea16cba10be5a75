"""Fields from cells: the decimals of the fewest digits that have the numbers that were typed.

Who types the matrix of ``near = 1`` gets 1, not 0.9999999999999999.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

ROUNDING = 2.0**-49
"""What a cell may differ, of the largest number that it is a sum of: 8 roundings."""
OF_ITSELF = 2.0**-20
"""What a cell may differ of itself, though it be tiny: 1e-20 typed is not taken for 0."""
DIGITS = 17
"""Of a decimal that is every float64."""
MEANT = 12
"""Digits of a decimal that is taken though a cell is a rounding off: chance hits one in 500."""


def same(a: Fraction, b: Fraction, size: Fraction) -> bool:
    """Whether two numbers differ by rounding only, of numbers of this size."""
    apart = abs(a - b)
    return apart <= Fraction(ROUNDING) * size and apart <= Fraction(OF_ITSELF) * abs(b)


def shortest(
    cells: Callable[..., tuple[float, ...]],
    solved: tuple[Fraction, ...],
    wanted: tuple[float, ...],
    sizes: tuple[float, ...],
) -> tuple[float, ...]:
    """The decimals of the fewest digits that have these cells; the solution itself if none do.

    Parameters
    ----------
    cells : callable
        The cells, rounded, from the fields.
    solved : tuple of Fraction
        The fields.
    wanted : tuple of float
        The cells as typed.
    sizes : tuple of float
        Of the least number that each cell is a sum of.
    """
    floats = tuple(map(float, solved))
    for digits in range(1, DIGITS):
        rounded = tuple(float(f"{number:.{digits - 1}e}") for number in floats)
        try:
            near_enough = [
                abs(a - b) <= ROUNDING / 2.0 * max(size, abs(b)) if digits <= MEANT else a == b
                for a, b, size in zip(cells(*rounded), wanted, sizes, strict=True)
            ]
            if all(near_enough):
                return rounded
        except (ZeroDivisionError, ValueError, OverflowError):  # two that so few digits make one
            continue
    return floats


def ends(scale: Fraction, skew: Fraction, unit: Fraction) -> tuple[float, float]:
    """Low and high end of a window.

    From ``2 unit/(high - low)`` and ``(high + low)/(high - low)``.
    """

    def cells(low: float, high: float) -> tuple[float, ...]:
        extent = Fraction(high) - Fraction(low)
        return float(2 * unit / extent), float((Fraction(high) + Fraction(low)) / extent)

    solved = (skew - 1) * unit / scale, (skew + 1) * unit / scale
    low, high = shortest(cells, solved, (float(scale), float(skew)), (0.0, 1.0))
    return low, high
