"""A value of a document, as every place that reads, shows, finds or changes it knows it.

`app.model.parameters` lists those of camera, lens, image and object. A scene lists its settings in
its phenomenon. Their texts are in content files: Markdown with a heading for each parameter,
setting or kind of projection::

    ## Near {#near}
    The tooltip.
    - also: n plane zNear
    - value: label of this choice | its explanation

lupdate reads no Markdown: `tests/texts.py` makes a source for it.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache, cached_property
from pathlib import Path
from typing import Any, Literal, NamedTuple, TypeAlias

from app.model.limits import Vector, check_name, finite, finite_vector, is_number, within
from app.model.refusal import REFUSALS, Refusal

Value: TypeAlias = float | bool | str | Vector
Part: TypeAlias = Literal["lens", "camera", "image_size", "depth", "placement"]
Read: TypeAlias = Callable[[Any], Any]  # returns a value of a `Projection`
Write: TypeAlias = Callable[[Any, Any], Any]  # returns the `Projection` with another value

CLOSE = 1e-7  # relative to a number, or its slider's length: a nearer number is the chosen one
PARTS: dict[str, Part] = {
    "lens": "lens", "camera": "camera", "image": "image_size", "": "depth", "object": "placement",
}  # fmt: skip
"""The field of `Projection` that a section of the document is in."""


class Computed(NamedTuple):
    """Numbers that the model computes together from a part of a projection and does not keep."""

    source: Read  # returns the part of a projection that the numbers are computed from
    compute: Read  # returns a named tuple of the numbers of a projection
    apply: Write  # returns a projection with other numbers


@dataclass(frozen=True)
class Parameter:
    """One value of a document. All texts are marked for translation.

    The type of a setting's default says what it is: a bool is a switch, a str one of `choices`, a
    tuple a point or a direction of the world, a float a number with a slider.
    """

    name: str
    default: Value | None = None  # None if the scene's camera and lens have it
    low: float = -math.inf
    high: float = math.inf  # bounds of a number, included. Camera and lens check their own.
    span: tuple[float, float] | None = None
    """The range of the slider within the bounds; all of it if not given."""
    unit: str = ""
    logarithmic: bool = False
    whole: bool = False  # of a number: its slider is logarithmic; it is an integer
    per_second: float = 0.0  # how fast a number moves while it is played; 0 if it cannot be played
    only_with: tuple[str, Value] | None = None
    """The name of another setting, and the only value of it with which this one has an effect."""
    title: str = ""
    tip: str = ""
    """Its name and its tooltip. A content file has them, and `choices`, `tips`, `row`, `also`
    and `drag` (`app.model.parameter`)."""
    choices: tuple[tuple[str, str], ...] = ()  # the values of a choice and their texts
    section: str = "settings"  # its path in the document is ``SECTION.NAME``
    step: float = 0.0  # of the slider's arrow keys; 0 for about a 500th of its range
    tips: tuple[str, ...] = ()  # the explanation of each choice, if there are any
    row: str = ""  # the name of its row, if that is not its title
    said: str = ""  # its unit in words, if they are its own
    other: str = ""  # what a choice shows when it is none of its choices
    buttons: bool = False  # whether the choices stand side by side
    also: str = ""  # other names, by which the finder finds it
    letter: str = ""
    """In the formulas of the matrices; `app.lecture.letters` has the letter of each lecture."""
    formula: str = ""
    """In the formulas of lessons; ``_x``, ``_y`` and ``_z`` follow for a vector's components."""
    place: str = ""  # the part of the dock with its row; empty if it has none
    needs: str = ""  # property or field of the lenses that have it; by default that of its name
    changes: tuple[str, ...] = ()  # the document's fields that it changes, if it is none itself
    shows: tuple[str, ...] | None = None
    """What it highlights (`app.lecture.highlight`), if that has another name."""
    makes: tuple[str, ...] = ()  # other things computed from it; their highlight marks its row too
    handle: str = ""
    drag: str = ""  # the handle of the world pane that changes it, and what a drag of it does
    vector: bool = False  # whether it has three components
    computed: Computed | None = None  # the numbers of which it is one
    read: Read | None = None
    write: Write | None = None  # read and change it in a `Projection`, if it is no field there

    @property
    def path(self) -> str:
        return f"{self.section}.{self.name}" if self.section else self.name

    @property
    def part(self) -> Part:
        """The field of `Projection` that it belongs to."""
        return PARTS[self.section]

    @property
    def fields(self) -> tuple[str, ...]:
        return self.changes or (self.name,)

    @property
    def highlights(self) -> frozenset[str]:
        return frozenset((self.name,) if self.shows is None else self.shows)

    # -- in a projection

    def value(self, projection: Any) -> Any:
        if self.read is not None:
            return self.read(projection)
        if self.computed is not None:
            return getattr(self.computed.compute(projection), self.name)
        return getattr(getattr(projection, self.part), self.name)

    def put(self, projection: Any, value: Any) -> Any:
        """Return the projection with another value, or raise a `Refusal`."""
        if self.write is not None:
            return self.write(projection, value)
        if self.computed is not None:
            numbers = self.computed.compute(projection)._replace(**{self.name: value})
            return self.computed.apply(projection, numbers)
        whole: Any = getattr(projection, self.part)
        return replace(projection, **{self.part: replace(whole, **{self.name: value})})

    def component(self, axis: int) -> "Parameter":
        """Return one component of a vector as a number: ``eye_x``."""

        def write(projection: Any, value: Any) -> Any:
            components = list(self.value(projection))
            components[axis] = value
            return self.put(projection, tuple(components))

        return replace(
            self,
            name=f"{self.name}_{'xyz'[axis]}",
            vector=False,
            changes=self.fields,
            shows=tuple(self.highlights),
            read=lambda projection: float(self.value(projection)[axis]),
            write=write,
        )

    # -- of a setting

    def checked(self, value: Any) -> Value:
        """The value in the setting's type; a `Refusal` for another kind, or out of bounds."""
        if isinstance(self.default, bool):
            if not isinstance(value, bool):
                raise Refusal(self.path, value, REFUSALS["yes-or-no"])
            return value
        if isinstance(self.default, str):
            check_name(self.path, value, [name for name, _ in self.choices])
            return str(value)
        if isinstance(self.default, tuple):
            return finite_vector(self.path, value)
        number = within(self.path, finite(self.path, value), self.low, self.high)
        if self.whole and not number.is_integer():
            raise Refusal(self.path, number, REFUSALS["whole"])
        return number

    def can_be(self, value: Value | None) -> bool:
        try:
            self.checked(value)
        except Refusal:
            return False
        return True

    def rounded(self, value: float, chosen: float) -> float | None:
        """An implied number, or the chosen one if they differ by rounding errors alone."""
        if not math.isfinite(value):
            return None
        low, high = self.span or (self.low, self.high)
        slack = CLOSE * (high - low) if math.isfinite(high - low) else 0.0
        if math.isclose(value, chosen, rel_tol=CLOSE, abs_tol=slack):
            return chosen
        return float(f"{value:.12g}")


_EXPLAINED = " | "
_OWN = ("row", "said", "other", "also", "drag")
"""Items that are no choices, but texts of the parameter with the same name."""


@dataclass
class ContentSection:
    """What stands below one heading: lines of text, and the items of a list."""

    text: list[str]
    items: list[str]

    @cached_property
    def named(self) -> dict[str, str]:
        return dict(item.split(": ", 1) for item in self.items)


def sections_of(text: str) -> dict[str, ContentSection]:
    """Return the sections of a content file's text by their headings."""
    sections: dict[str, ContentSection] = {}
    for line in filter(None, text.splitlines()):
        if line.startswith("#"):
            section = sections.setdefault(line.lstrip("# "), ContentSection([], []))
        elif line.startswith("- "):
            section.items.append(line[2:])
        else:
            section.text.append(line)
    return sections


def section_of(name: str, sections: Mapping[str, ContentSection]) -> tuple[str, ContentSection]:
    """Return the heading of a thing, and what stands below it; a `KeyError` if it has none."""
    ending = f" {{#{name}}}"
    heading = next((each for each in sections if each.endswith(ending)), None)
    if heading is None:
        raise KeyError(f"The page of {next(iter(sections), 'texts')} has no heading with{ending}.")
    return heading.removesuffix(ending), sections[heading]


def worded(parameter: Parameter, sections: Mapping[str, ContentSection]) -> Parameter:
    title, section = section_of(parameter.name, sections)
    items = section.named
    own: dict[str, Any] = {name: items[name] for name in _OWN if name in items}
    choices = {n: text.partition(_EXPLAINED) for n, text in items.items() if n not in own}
    return replace(
        parameter,
        title=title,
        tip=section.text[0],
        choices=tuple((name, text) for name, (text, _, _) in choices.items()),
        tips=tuple(tip for _, _, tip in choices.values()),
        **own,
    )


def read_content(path: Path) -> str:
    return path.read_text(encoding="utf-8")


def read_sections(path: Path) -> dict[str, ContentSection]:
    return sections_of(read_content(path))


@cache
def _sections() -> dict[str, ContentSection]:
    return read_sections(Path(__file__).with_name("content") / "parameters.md")


def stated(name: str, **columns: Any) -> Parameter:
    """Return a parameter of the model with its texts."""
    return worded(Parameter(name, **columns), _sections())


def texts_of(parameter: Parameter) -> set[str]:
    labels = (text for _, text in parameter.choices)
    own = (getattr(parameter, name) for name in ("title", "tip", *_OWN))
    return {text for text in (*own, *labels, *parameter.tips) if text}


Settings: TypeAlias = Mapping[str, Value]  # checked values of a phenomenon's settings, by name
ImpliedSettings: TypeAlias = Mapping[str, Value | None]
"""The values that camera and lens imply; None where no value gives the present state."""


def number(settings: ImpliedSettings, name: str) -> float:
    value = settings[name]
    if not is_number(value):
        raise TypeError(name)
    return float(value)


def point(settings: Settings, name: str) -> Vector:
    """The value of a setting that is a point or a direction."""
    value = settings[name]
    if not isinstance(value, tuple):
        raise TypeError(name)
    return value
