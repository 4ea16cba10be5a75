"""The values of a phenomenon's settings, beside camera and lens."""

import numbers
from collections.abc import Mapping
from typing import TypeAlias

from app.model.parameter import Value
from app.model.projection import Vector

Settings: TypeAlias = Mapping[str, Value]
"""The checked value of every setting of a phenomenon, by its name."""
ImpliedSettings: TypeAlias = Mapping[str, Value | None]
"""The values that camera and lens imply; None where no value gives the present state."""


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
