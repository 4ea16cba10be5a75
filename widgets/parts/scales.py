"""Slider scales: the mapping between a slider's positions and values."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import NamedTuple

PER_DECADE = 2000  # positions of a `Log` from 1 to 10
_PARTS = ((2.0, 500), (4.0, 200), (math.inf, 100))
"""A mantissa below the first number is rounded to a multiple of the inverse of the second."""


class Stops(NamedTuple):
    """The numbers of positions by which an arrow key, a page key and a wheel notch move a slider.

    Without Shift a drag stops at multiples of `coarse`.
    """

    key: int
    page: int
    notch: int
    coarse: int


@dataclass(frozen=True)
class Scale(ABC):
    """The values of a slider from `low` to `high`."""

    low: float
    high: float
    infinite = False  # whether an extra position at the top stands for infinity

    @property
    @abstractmethod
    def stops(self) -> Stops:
        """Where keys, the wheel and a drag stop."""

    @property
    @abstractmethod
    def last(self) -> int:
        """The top position; the bottom is 0."""

    @abstractmethod
    def value_at(self, position: int) -> float:
        """Return the value of a slider position."""

    def position_of(self, value: float) -> int:
        """Return the nearest position; values beyond an end give that end."""
        top = self.last - self.infinite
        if value <= self.low:
            return 0
        if value >= self.high:
            return self.last if math.isinf(value) else top
        return min(max(self._nearest(value), 0), top)

    @abstractmethod
    def _nearest(self, value: float) -> int:
        """Return the nearest position of a value between the ends."""


@dataclass(frozen=True)
class Linear(Scale):
    """Even steps with short decimal values; the ends are rounded to multiples of the step.

    An arrow key makes a `step`, preferably 1, 2 or 5 times a power of ten. A drag with Shift
    reaches the `parts` of a step.
    """

    step: float
    parts: int = 10

    @classmethod
    def about(cls, centre: float, reach: float) -> "Linear":
        """Go from ``centre - reach`` to ``centre + reach`` in 200 to 500 steps."""
        rough = 2.0 * reach / 500.0
        power = 10.0 ** math.floor(math.log10(rough))
        step = next(m * power for m in (1.0, 2.0, 5.0, 10.0) if m * power >= rough)
        return cls(centre - reach, centre + reach, float(f"{step:.1g}"))

    @property
    def stops(self) -> Stops:
        return Stops(self.parts, 10 * self.parts, self.parts, self.parts)

    @cached_property
    def _step(self) -> Fraction:
        return Fraction(repr(self.step))

    @cached_property
    def _first(self) -> int:
        return round(Fraction(self.low) / self._step)

    @cached_property
    def last(self) -> int:
        return (round(Fraction(self.high) / self._step) - self._first) * self.parts

    def value_at(self, position: int) -> float:
        return float((self._first + Fraction(position, self.parts)) * self._step)

    def _nearest(self, value: float) -> int:
        return round((value / self.step - self._first) * self.parts)


@dataclass(frozen=True)
class Log(Scale):
    """Logarithmic steps with positions closer than a pixel; powers of ten are among the values.

    The values have three digits, the smaller ones a fourth that is even or 5. `low` is above 0.
    """

    infinite: bool = False
    stops = Stops(40, 400, 10, 1)

    @cached_property
    def _first(self) -> float:
        return math.log10(self.low) * PER_DECADE

    @cached_property
    def last(self) -> int:
        return math.ceil(math.log10(self.high) * PER_DECADE - self._first) + self.infinite

    def value_at(self, position: int) -> float:
        if position > self.last - self.infinite:
            return math.inf
        exact = 10.0 ** ((self._first + position) / PER_DECADE)
        mantissa, _, power = f"{exact:.9e}".partition("e")
        parts = next(parts for limit, parts in _PARTS if float(mantissa) < limit)
        short = float(f"{round(float(mantissa) * parts) / parts:.3f}e{power}")
        return min(max(short, self.low), self.high)

    def _nearest(self, value: float) -> int:
        return round(math.log10(value) * PER_DECADE - self._first)


@dataclass(frozen=True)
class Doubling(Scale):
    """Whole numbers in nearly logarithmic steps: 1, 2, 3, 4, 6, 8, 12, 16, and so on."""

    stops = Stops(1, 2, 1, 1)  # a page key doubles the value

    @cached_property
    def _values(self) -> list[float]:
        powers = [2.0**n for n in range(math.ceil(math.log2(self.high)) + 1)]
        values = sorted({*powers, *(1.5 * power for power in powers[1:]), self.low, self.high})
        return [value for value in values if self.low <= value <= self.high]

    @property
    def last(self) -> int:
        return len(self._values) - 1

    def value_at(self, position: int) -> float:
        return self._values[position]

    def _nearest(self, value: float) -> int:
        return min(range(len(self._values)), key=lambda at: abs(self._values[at] - value))
