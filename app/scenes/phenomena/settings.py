"""The settings of a phenomenon, beside camera and lens."""

from __future__ import annotations

import math
import numbers
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

from app.model.limits import finite, finite_vector, within
from app.model.projection import ONE_OF, Vector
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal

Value: TypeAlias = float | bool | str | Vector
Settings: TypeAlias = Mapping[str, Value]
"""The checked value of every `Setting` of a phenomenon, by its name."""
ImpliedSettings: TypeAlias = Mapping[str, Value | None]
"""The values that camera and lens imply; None where no value gives the present state."""

CLOSE = 1e-7
"""Relative to a number, or to its slider's length: a nearer number is the one that was chosen."""

WHOLE = QT_TRANSLATE_NOOP("Refusal", "must be a whole number")
YES_OR_NO = QT_TRANSLATE_NOOP("Refusal", "must be true or false")


@dataclass(frozen=True)
class Setting:
    """One thing that can be changed about a phenomenon, beside camera and lens.

    The type of its default says what it is: a bool is a switch, a str one of `choices`, a tuple a
    point or a direction of the world, a float a number with a slider.

    Attributes
    ----------
    name : str
        In the document, ``settings.NAME``.
    default : float, bool, str or tuple of 3 floats
    low, high : float
        Bounds of a number, included.
    span : (float, float), optional
        The range of the slider within the bounds; all of it if not given.
    unit : str
    logarithmic, whole : bool
        Of a number: its slider is logarithmic; it is an integer.
    per_second : float
        How fast a number moves while it is played; 0 if it cannot be played.
    only_with : (str, value), optional
        The name of another setting, and the only value of it with which this one has an effect.
    label, tip : str
        Translatable; like `choices`, they come from the content file (`PhenomenonWords.worded`).
    choices : tuple of (str, str)
        The values of a choice and their translatable labels.
    """

    name: str
    default: Value
    low: float = -math.inf
    high: float = math.inf
    span: tuple[float, float] | None = None
    unit: str = ""
    logarithmic: bool = False
    whole: bool = False
    per_second: float = 0.0
    only_with: tuple[str, Value] | None = None
    label: str = ""
    tip: str = ""
    choices: tuple[tuple[str, str], ...] = ()

    @property
    def path(self) -> str:
        return f"settings.{self.name}"

    def checked(self, value: Any) -> Value:
        """The value in the setting's type; a `Refusal` for another kind, or out of bounds."""
        if isinstance(self.default, bool):
            if not isinstance(value, bool):
                raise Refusal(self.path, value, YES_OR_NO)
            return value
        if isinstance(self.default, str):
            known = [name for name, _ in self.choices]
            if value not in known:
                raise Refusal(self.path, value, ONE_OF, ", ".join(known))
            return str(value)
        if isinstance(self.default, tuple):
            return finite_vector(self.path, value)
        number = within(self.path, finite(self.path, value), self.low, self.high)
        if self.whole and not number.is_integer():
            raise Refusal(self.path, number, WHOLE)
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


def number(settings: ImpliedSettings, name: str) -> float:
    """The value of a setting that is a number."""
    value = settings[name]
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise TypeError(name)
    return float(value)


def point(settings: Settings, name: str) -> Vector:
    """The value of a setting that is a point or a direction."""
    value = settings[name]
    if not isinstance(value, tuple):
        raise TypeError(name)
    return value
