"""What a phenomenon says: numbers with their units, and sentences."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from app.model.projection import Projection


@dataclass(frozen=True)
class Phrase:
    """A sentence with values in it, to be translated before they are filled in.

    Attributes
    ----------
    template : str
        Marked with ``QT_TRANSLATE_NOOP("phenomena", ...)``; ``{0}``, ``{1}`` for the values.
    values : tuple of str or float
    """

    template: str
    values: tuple[str | float, ...] = ()

    def sentence(
        self,
        translate: Callable[[str], str] = str,
        write: Callable[[float], str] = lambda value: figure(value, 4),
    ) -> str:
        """The sentence in another language, with its numbers as they are written there."""
        values = (value if isinstance(value, str) else write(value) for value in self.values)
        return translate(self.template).format(*values)


@dataclass(frozen=True)
class Reading:
    """One line of the readout.

    Attributes
    ----------
    label : str
        Translatable; letters as in the lectures.
    value : float, tuple of floats, str or None
        A str is a translatable word; None if there is none, and `note` says why.
    unit : str
        ``"px"``, ``"°"``, ``"%"``, ``"×"``, or empty for world units.
    note : Phrase, optional
    about : tuple of str
        What it speaks of, by the names of `app.lecture.highlight`: it stands out with that.
    cell : int, optional
        Of a matrix, which of its cells, counted row by row, speaks of that; without it all do.
    counted : bool
        Whether the value is not computed but counted in the picture's pixels, by somebody who can
        draw; until then it is None. `note` says why, if there turns out to be nothing to count.
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
        value: float | tuple[float, ...] | None,
        unit: str = "",
        why: Phrase | None = None,
    ) -> Reading:
        """A line with a note only where there is no value: why there is none."""
        return cls(label, value, unit, why if value is None else None)


def of_parallel(projection: Projection, template: str) -> Phrase | None:
    """What is to be said of a lens whose projectors do not meet in an eye, if it is one."""
    return None if projection.lens.central else Phrase(template)


def figure(value: float, digits: int) -> str:
    """A number for a mark or a sentence, with the minus of the readouts."""
    return f"{value + 0.0:.{digits}g}".replace("-", "−")
