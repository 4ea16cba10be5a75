"""The readout of a phenomenon: numbers with their units, and sentences."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Phrase:
    """A sentence with values in it; ``{0}``, ``{1}`` in the translatable template."""

    template: str
    values: tuple[str | float, ...] = ()

    def sentence(
        self,
        translate: Callable[[str], str] = str,
        write: Callable[[float], str] = lambda value: figure(value),
    ) -> str:
        """Translate the template, then fill in the values; `write` formats the numbers."""
        values = (value if isinstance(value, str) else write(value) for value in self.values)
        return translate(self.template).format(*values)


@dataclass(frozen=True)
class Reading:
    """One line of the readout.

    - `label`: translatable, with letters as in the lectures.
    - `value`: a str is a translatable word. None means that there is no value, and `note` says why.
    - `unit`: ``"px"``, ``"°"``, ``"%"``, ``"×"``, or empty for world units.
    - `counted`: the value is counted later in the pixels of the picture, and None until then.
      `note` says why, if there turns out to be nothing to count.
    - `about`: the names of `app.lecture.highlight` that it is highlighted with.
    - `cell`: of a matrix, the only cell that is highlighted, counted row by row.
    """

    label: str
    value: float | tuple[float, ...] | str | None
    unit: str = ""
    note: Phrase | None = None
    counted: bool = False
    about: tuple[str, ...] = ()
    cell: int | None = None

    @classmethod
    def or_why(
        cls,
        label: str,
        value: float | tuple[float, ...] | str | None,
        unit: str = "",
        why: Phrase | None = None,
    ) -> Reading:
        """A line with a note only if it has no value, or none that is finite."""
        if isinstance(value, float) and not math.isfinite(value):
            value = None
        return cls(label, value, unit, why if value is None else None)


FEW, EVERY_DIGIT = 4, 17


def digits_apart(*numbers: float, least: int = FEW) -> int:
    """The fewest digits, at least so many, with which different numbers look different."""
    different = {number + 0.0 for number in numbers if number == number}
    for digits in range(least, EVERY_DIGIT):
        if len({f"{number:.{digits}g}" for number in different}) == len(different):
            return digits
    return EVERY_DIGIT


def figure(value: float, digits: int = FEW) -> str:
    """A number for a mark or a sentence, with the minus sign of the readouts."""
    return f"{value + 0.0:.{digits}g}".replace("-", "−")
