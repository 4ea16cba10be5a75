"""The row of a parameter, its slider's scale, and the motion that animates its number."""

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple

from PySide6.QtCore import QCoreApplication, QObject, Signal

from app.model.lenses import Lens
from app.model.parameter import Computed, Parameter, Part
from app.model.parameters import KIND, lenses_with, tidy
from app.model.projection import LARGEST, LENSES, FreeMatrix, Projection
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal, shown_limits
from widgets.parts.clock import Clock, Playing
from widgets.parts.fields import CheckRow, ChoiceRow, Option, Row
from widgets.parts.layouts import tool_button
from widgets.parts.messages import limits_text, of_phenomena, parameter_text, seen_from, translated
from widgets.parts.number_rows import NumberRow, VectorRow
from widgets.parts.scales import Doubling, Linear, Log, Scale
from widgets.parts.section import Rows

UNITS = {  # the units of the model's parameters, and each in words
    "°": ("°", QT_TRANSLATE_NOOP("Field", "degrees")),
    "units": (QT_TRANSLATE_NOOP("Field", "units"), QT_TRANSLATE_NOOP("Field", "world units")),
    "mm": (QT_TRANSLATE_NOOP("Field", "mm"), QT_TRANSLATE_NOOP("Field", "millimetres")),
    "px": (QT_TRANSLATE_NOOP("Field", "px"), QT_TRANSLATE_NOOP("Field", "pixels")),
    "×": (QT_TRANSLATE_NOOP("Field", "×"), QT_TRANSLATE_NOOP("Field", "times")),
}


class TypedMemory:
    """Keeps typed numbers that the model does not keep.

    Computed from the model, they would contain rounding errors, and some would be lost: the
    azimuth of a camera straight above its target, the direction of depth that recedes by 0.
    """

    def __init__(self, computed: Computed) -> None:
        self._computed = computed
        self._typed: tuple[Any, Any] = (None, None)
        self._latest: tuple[Any, Any] = (None, None)

    def numbers(self, projection: Projection) -> Any:
        """Return the numbers; typed ones keep all their digits."""
        now = self._computed.source(projection)
        for source, numbers in (self._typed, self._latest):
            if source == now:
                return numbers
        computed = self._computed.compute(projection)
        self._latest = now, type(computed)(*map(tidy, computed))
        return self._latest[1]

    def through(self, parameter: Parameter) -> Parameter:
        """Return the parameter of one of the numbers, which is read and changed through this."""
        return replace(
            parameter,
            read=lambda projection: float(getattr(self.numbers(projection), parameter.name)),
            write=lambda projection, value: self._computed.apply(
                projection, self._with(parameter, projection, value)
            ),
        )

    def keep(
        self, parameter: Parameter, before: Projection, value: float, after: Projection
    ) -> None:
        """Keep a number that was typed, and the others as they were."""
        self._typed = self._computed.source(after), self._with(parameter, before, value)

    def _with(self, parameter: Parameter, projection: Projection, value: float) -> Any:
        return self.numbers(projection)._replace(**{parameter.name: value})


class Binding(NamedTuple):
    """A row of the dock, and the value of the model that it shows.

    Rows that show one value in several ways (fov and focal length, orbit and vectors) are several
    bindings.
    """

    row: Row
    rows: Rows  # the part of the dock with the row
    parameter: Parameter
    part: Part  # the field of `Projection` that has the value; only a change there removes an error
    field: str  # the model's name of the value, of a component that of its vector
    memory: TypedMemory | None  # keeps an accepted edit
    lenses: tuple[str, ...]  # kinds of lens that have this value; empty if it depends on no lens

    def belongs_to(self, lens: Lens) -> bool:
        return not self.lenses or lens.kind in self.lenses

    def accepts(self, projection: Projection, value: float) -> bool:
        """Whether the lens has this value and the model takes it."""
        if not self.belongs_to(projection.lens):
            return False
        try:
            self.parameter.put(projection, value)
        except Refusal:
            return False
        return True

    def limit(self, projection: Projection, value: float) -> Refusal | None:
        """Return the model's limit that an infinite value exceeds, if there is one."""
        if not self.belongs_to(projection.lens):
            return None
        probe = math.copysign(LARGEST, value)
        try:
            self.parameter.put(projection, probe)
        except Refusal as error:
            seen = seen_from(self.field, self.row.name, probe, error)
            if seen.field == self.field and seen.value == probe:
                return Refusal(seen.field, value, seen.bound, *seen.limits)
        return None

    def limits(self, projection: Projection) -> str:
        """State the model's limits for a number in this row."""
        clauses = []
        for value in (-math.inf, math.inf):
            error = self.limit(projection, value)
            if error is not None:
                clauses.append(translated(error.bound).format(*shown_limits(error.limits, value)))
        return "; ".join(dict.fromkeys(clauses))


def bindings_of(parameter: Parameter, rows: Rows, memory: TypedMemory | None) -> Iterator[Binding]:
    """Make the row of a parameter of the model, or those of its components."""
    title = parameter_text(parameter, parameter.row or parameter.title or parameter.name)
    parts = [(title, parameter if memory is None else memory.through(parameter))]
    if parameter.vector:
        named = QCoreApplication.translate("Field", "{0} {1}")
        parts = [
            (named.format(title, letter), parameter.component(axis))
            for axis, letter in enumerate("xyz")
        ]
    for title, part in parts:
        row = make_row(part, title)
        yield Binding(row, rows, part, part.part, parameter.name, memory, lenses_with(parameter))


def make_row(parameter: Parameter, title: str = "", none: str = "") -> Row:
    """Make the row for a parameter's type, with a setting's default.

    `none` is the text of a choice row whose value is not one of its choices.
    """
    text = partial(parameter_text, parameter)
    title, tip = title or text(parameter.title), text(parameter.tip)
    default: Any = parameter.default
    tip = tip if tip.endswith(".") else f"{tip}."
    row: Row
    if isinstance(default, bool):
        row = CheckRow(title, tip)
    elif isinstance(default, tuple):
        row = VectorRow(title, tip)
    elif options := options_of(parameter):
        row = ChoiceRow(
            title, tip, options, buttons=parameter.buttons, none=none or text(parameter.other)
        )
    elif default is None:
        unit, said = UNITS.get(parameter.unit, ("", ""))
        said = parameter.said or said
        row = NumberRow(title, tip, scale_of(parameter), text(unit), text(said))
    else:
        row = number = NumberRow(title, tip, scale_of(parameter), text(parameter.unit))
        number.limits = partial(limits_text, parameter.low, parameter.high)
        number.accepts = parameter.can_be
    if isinstance(row, NumberRow):
        row.slider.setObjectName(parameter.name)  # near and far have their planes' colours
    if default is not None:
        row.setValue(default)
        row.setDefault(default)
    return row


def options_of(parameter: Parameter) -> list[Option]:
    """Return the choices of a parameter; those of the kind are the lenses."""
    if parameter.path == KIND.path:
        return [
            Option(lens.kind, translated(lens.title, "Lens"), translated(lens.tip, "Lens"))
            for lens in (*LENSES.values(), FreeMatrix)
        ]
    tips = parameter.tips or ("",) * len(parameter.choices)
    return [
        Option(key, parameter_text(parameter, label), parameter_text(parameter, tip))
        for (key, label), tip in zip(parameter.choices, tips, strict=True)
    ]


def ends_of(parameter: Parameter) -> tuple[float, float]:
    """Return the ends of a number's slider."""
    low, high = parameter.span or (parameter.low, parameter.high)
    if parameter.default is None:
        return parameter.span or (1.0, 10.0)  # until a scene sets them
    assert isinstance(parameter.default, float | int)
    reach = 10.0 * max(1.0, abs(parameter.default))  # if there are no bounds
    return max(low, parameter.default - reach) if math.isinf(low) else low, (
        min(high, parameter.default + reach) if math.isinf(high) else high
    )


def scale_of(parameter: Parameter) -> Scale:
    """Return a slider's scale whose values are all within the bounds."""
    low, high = ends_of(parameter)
    if parameter.logarithmic and parameter.whole:
        return Doubling(low, high)
    if parameter.logarithmic and high >= 2.0 * low:
        return Log(low, high)
    if parameter.step:
        return Linear(low, high, parameter.step)
    step = 1.0 if parameter.whole else Linear.about((low + high) / 2.0, (high - low) / 2.0).step
    fraction = Fraction(repr(step))
    first, last = math.ceil(Fraction(low) / fraction), math.floor(Fraction(high) / fraction)
    parts = 1 if parameter.whole else Linear.parts
    return Linear(float(first * fraction), float(last * fraction), step, parts)


class SettingMotion(Playing, QObject):
    """Moves a number back and forth between the ends of its slider.

    The setting's `per_second` is in its unit, or in powers of ten if it is logarithmic. If
    something else changes the number meanwhile, the motion continues from there.
    """

    stepped = Signal(float)  # the next value, once per frame

    def __init__(self, setting: Parameter, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._setting = setting
        self._low, self._high = map(self._place, ends_of(setting))
        self.speed = setting.per_second
        self._at = self._low
        self._shown: float | None = None
        self._clock = Clock(self, self.advance)
        self.button = tool_button(act=self.toggle)
        self._show_state()

    def play(self) -> None:
        if not self.playing:
            self._set_playing(True)

    def show_value(self, value: float) -> None:
        """Store the number; if it differs from the last frame's, continue from it."""
        if value != self._shown:
            self._shown, self._at = value, self._place(value)

    def advance(self, seconds: float) -> None:
        """Advance by some seconds and emit the number, unless paused."""
        if not self.playing:
            return
        if (self._at >= self._high and self.speed > 0.0) or (
            self._at <= self._low and self.speed < 0.0
        ):
            self.speed = -self.speed
        inside = self._low <= self._at <= self._high
        self._at += self.speed * seconds
        if inside:  # both ends are shown, for a frame
            self._at = min(max(self._at, self._low), self._high)
        value = 10.0**self._at if self._setting.logarithmic else self._at
        value = float(round(value)) if self._setting.whole else float(f"{value:.7g}")
        if value != self._shown:
            self._shown = value
            self.stepped.emit(value)

    def _place(self, value: float) -> float:
        return math.log10(value) if self._setting.logarithmic else value

    def _show_state(self) -> None:
        self._name_button(
            f"{{0}}: {of_phenomena(self._setting.title)}",
            self.tr("Move it back and forth between the ends of its slider"),
            self.tr("Pause it here; playing continues from here"),
        )
