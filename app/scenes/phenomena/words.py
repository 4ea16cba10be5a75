"""What a phenomenon says beside the panes: readings, diagrams, and the words of its content file.

The file is Markdown in the manner of a lesson. Every text stands on one line::

    # Title of the scene
    The explanation.

    ## Shown
    - start: the eye | its target | perspective 40 1 12, fields of the lens
    - names: P eye

    ## Settings
    - its_name: 2 low=0 high=9 span=0,4 whole, fields of a `Parameter` after the default

    ## Try
    - A question, or something to do.

    ## Label of a setting {#its_name}
    Its tooltip.
    - value: label of this choice

    ## Compare: name
    - label of a picture: settings.preset=wide lens.near=1

    ## Words
    - name: a label or a sentence that the phenomenon's code shows

The window translates these texts in the context "phenomena". lupdate reads no Markdown:
`tests/texts.py` makes a source for it.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from app.model.parameter import ContentSection, Parameter, read_sections, sections_of, worded
from app.model.projection import Array, Projection


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

    - `value`: a str is a translatable word. None means that there is no value, and `note` says why.
    - `counted`: the value is counted later in the pixels of the picture, and None until then.
      `note` says why, if there turns out to be nothing to count.
    """

    label: str  # translatable, with letters as in the lectures
    value: float | tuple[float, ...] | str | None
    unit: str = ""  # ``"px"``, ``"°"``, ``"%"``, ``"×"``, or empty for world units
    note: Phrase | None = None
    counted: bool = False
    about: tuple[str, ...] = ()  # the names of `app.lecture.highlight` that it is highlighted with
    cell: int | None = None  # of a matrix, the only cell that is highlighted, counted row by row

    @classmethod
    def or_why(
        cls,
        label: str,
        value: float | tuple[float, ...] | str | None,
        unit: str = "",
        why: Phrase | None = None,
    ) -> "Reading":
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


def value_of(text: str) -> Any:
    """A number, yes or no, several of them with commas between, or the text itself."""
    if "," in text:
        return tuple(map(value_of, text.split(",")))
    try:
        return float(text)
    except ValueError:
        return {"yes": True, "no": False}.get(text, text)


CONTENT = Path(__file__).with_name("content")
_COMPARE = "Compare: "


@dataclass(frozen=True)
class Comparison:
    """Pictures of a phenomenon that belong side by side: ``view.compare=NAME``.

    From left to right, the pictures are a translatable label and assignments as in ``--set``:
    ``"settings.preset=wide"``. In all else they follow the document. The document is one of them,
    or the last one if it matches none.
    """

    name: str
    pictures: tuple[tuple[str, tuple[str, ...]], ...]


class PhenomenonWords:
    """The words of one phenomenon, from the file ``NAME.md`` or from a text."""

    def __init__(self, name: str, text: str | None = None) -> None:
        self.name, self._given = name, text

    @cached_property
    def _sections(self) -> dict[str, ContentSection]:
        if self._given is not None:
            return sections_of(self._given)
        return read_sections(CONTENT / f"{self.name}.md")

    @cached_property
    def _named(self) -> dict[str, str]:
        return self._sections["Words"].named

    def __getitem__(self, key: str) -> str:
        return self._named[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._named)

    def phrase(self, key: str, *values: str | float) -> Phrase:
        """A sentence, and the values to fill in."""
        return Phrase(self[key], values)

    def of_parallel(self, projection: Projection) -> Phrase | None:
        """The sentence "parallel" for a lens whose projectors do not meet in an eye."""
        return None if projection.lens.central else self.phrase("parallel")

    @property
    def title(self) -> str:
        return next(iter(self._sections))

    @property
    def explanation(self) -> str:
        return self._sections[self.title].text[0]

    @property
    def shown(self) -> dict[str, str]:
        """Some fields of its `Phenomenon`: what it shows, and from where."""
        return self._sections["Shown"].named

    @property
    def tries(self) -> tuple[str, ...]:
        return tuple(self._sections["Try"].items)

    @cached_property
    def settings(self) -> dict[str, Parameter]:
        """Its settings by their names, each with its title, its tooltip and its choices."""
        stated = self._sections["Settings"].named
        return {name: self._setting(name, *text.split()) for name, text in stated.items()}

    def _setting(self, name: str, default: str, *columns: str) -> Parameter:
        pairs = (each.partition("=") for each in columns)
        fields = {field: value_of(text or "yes") for field, _, text in pairs}
        setting = worded(Parameter(name, default, **fields), self._sections)
        return setting if setting.choices else replace(setting, default=value_of(default))

    @cached_property
    def comparisons(self) -> tuple[Comparison, ...]:
        return tuple(
            Comparison(
                heading.removeprefix(_COMPARE),
                tuple((label, tuple(values.split())) for label, values in section.named.items()),
            )
            for heading, section in self._sections.items()
            if heading.startswith(_COMPARE)
        )

    @property
    def texts(self) -> set[str]:
        """Every text that can be translated."""
        texts = {self.title, *self.tries}
        for heading, section in self._sections.items():
            texts.update(section.text)
            if heading.startswith(_COMPARE):
                texts.update(section.named)
            elif heading not in ("Try", "Shown", "Settings"):
                texts.update(section.named.values())
            if heading.endswith("}"):
                texts.add(heading.rpartition(" {#")[0])
        return texts


@dataclass(frozen=True, eq=False)
class Curve:
    """A curve: points (n, 2) in the diagram's units, NaN where it is broken.

    `keys` are what its points report when they are clicked; empty if they cannot be chosen. `dash`
    are lengths of dashes and gaps in widths of the line.
    """

    points: Array
    colour: str = "ink"
    label: str = ""
    width: float = 1.0
    closed: bool = False
    dots: bool = False
    keys: tuple[str, ...] = ()
    dash: tuple[float, ...] = ()


@dataclass(frozen=True, eq=False)
class Spot:
    """A point of a diagram, in its units, with a name.

    - `faded`, `marked`, `broken`, `hollow`: drawn paler, because another one is better; drawn as
      the present choice; drawn as a cross, because something ends here; drawn as a circle, because
      it is only a reference.
    """

    x: float
    y: float
    name: str = ""  # written beside it, where there is room; it is in `tip` too
    key: str = ""  # reported when it is clicked; empty if it cannot be chosen
    tip: str = ""
    colour: str = "ink"
    faded: bool = False
    marked: bool = False
    broken: bool = False
    hollow: bool = False


@dataclass(frozen=True, eq=False)
class Diagram:
    """A small picture or chart beside the panes.

    - `title`, `x_label`, `y_label`: translatable; an empty label for none.
    - `left`, `right`, `bottom`, `top`: its window; if `bottom` is greater than `top`, y runs down,
      as in an image.
    - `equal`: whether both axes have the same scale, as in a picture. A picture without axis labels
      has no numbers either.
    - `x_ticks`, `y_ticks` (n,): where lines are drawn across, such as the codes of a depth buffer.
    - `spots`: drawn over the curves; the first ones get the better places for their names.
    """

    title: str
    curves: tuple[Curve, ...]
    left: float
    right: float
    bottom: float
    top: float
    x_label: str = ""
    y_label: str = ""
    x_log: bool = False
    y_log: bool = False
    equal: bool = False
    x_ticks: Array | None = None
    y_ticks: Array | None = None
    spots: tuple[Spot, ...] = ()


def broken(segments: Array) -> Array:
    """Segments (k, 2, 2) as the points of one curve that is broken after each of them."""
    gaps = np.full((len(segments), 1, 2), np.nan)
    return np.concatenate([segments, gaps], axis=1).reshape(-1, 2)
