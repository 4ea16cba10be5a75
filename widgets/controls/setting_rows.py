"""The row of a setting, its slider's scale, and the motion that animates its number."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import partial
from typing import Any

from PySide6.QtCore import QObject, Signal

from app.scenes.phenomena.settings import Setting
from widgets.parts.buttons import tool_button
from widgets.parts.clock import Clock, Playing
from widgets.parts.fields import CheckRow, ChoiceRow, Option, Row
from widgets.parts.messages import limits_text, of_phenomena
from widgets.parts.number_rows import NumberRow, VectorRow
from widgets.parts.scales import Doubling, Linear, Log, Scale


def make_row(setting: Setting, none: str = "") -> Row:
    """Make the row for a setting's type, with its default.

    `none` is the text of a choice row whose value is not one of its choices.
    """
    name, tip = of_phenomena(setting.label), of_phenomena(setting.tip)
    tip = tip if tip.endswith(".") else f"{tip}."
    row: Row
    if isinstance(setting.default, bool):
        row = CheckRow(name, tip)
    elif isinstance(setting.default, str):
        choices = [Option(key, of_phenomena(text)) for key, text in setting.choices]
        row = ChoiceRow(name, tip, choices, none=none)
    elif isinstance(setting.default, tuple):
        row = VectorRow(name, tip)
    else:
        number = NumberRow(name, tip, scale_of(setting), of_phenomena(setting.unit))
        number.limits = partial(limits_text, setting.low, setting.high)
        number.accepts = setting.can_be
        row = number
    default: Any = setting.default
    row.setValue(default)
    row.setDefault(default)
    return row


def ends_of(setting: Setting) -> tuple[float, float]:
    """Return the ends of a number's slider."""
    low, high = setting.span or (setting.low, setting.high)
    default = setting.default
    assert isinstance(default, float | int)
    reach = 10.0 * max(1.0, abs(default))  # if there are no bounds
    return max(low, default - reach) if math.isinf(low) else low, (
        min(high, default + reach) if math.isinf(high) else high
    )


def scale_of(setting: Setting) -> Scale:
    """Return a slider's scale whose values are all within the bounds."""
    low, high = ends_of(setting)
    if setting.logarithmic and setting.whole:
        return Doubling(low, high)
    if setting.logarithmic and high >= 2.0 * low:
        return Log(low, high)
    step = 1.0 if setting.whole else Linear.about((low + high) / 2.0, (high - low) / 2.0).step
    fraction = Fraction(repr(step))
    first, last = math.ceil(Fraction(low) / fraction), math.floor(Fraction(high) / fraction)
    parts = 1 if setting.whole else Linear.parts
    return Linear(float(first * fraction), float(last * fraction), step, parts)


class SettingMotion(QObject, Playing):
    """Moves a number back and forth between the ends of its slider.

    The setting's `per_second` is in its unit, or in powers of ten if it is logarithmic. If
    something else changes the number meanwhile, the motion continues from there.
    """

    stepped = Signal(float)
    """The next value, once per frame."""
    started = Signal()
    paused = Signal()

    def __init__(self, setting: Setting, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._setting = setting
        self._low, self._high = map(self._place, ends_of(setting))
        self.speed = setting.per_second
        self._at = self._low
        self._shown: float | None = None
        self._clock = Clock(self)
        self._clock.ticked.connect(self.advance)
        self.button = tool_button(act=self.toggle)
        self._show_state()

    def play(self) -> None:
        if not self.playing:
            self._clock.start()
            self._show_state()
            self.started.emit()

    def pause(self) -> None:
        if self.playing:
            self._clock.stop()
            self._show_state()
            self.paused.emit()

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
            f"{{0}}: {of_phenomena(self._setting.label)}",
            self.tr("Move it back and forth between the ends of its slider"),
            self.tr("Pause it here; playing continues from here"),
        )
