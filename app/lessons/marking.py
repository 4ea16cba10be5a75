"""Read numbers as students write them, and decide whether they are right.

The exact value counts however short it is (1/2, 0.5, -1, 0). Any other number needs three
significant digits and may be off by one in the last: students read values off the screen and round
by hand. A fraction counts as a number of three digits.
"""

from __future__ import annotations

import itertools
import math
import re
from fractions import Fraction
from typing import NamedTuple

from app.model.refusal import QT_TRANSLATE_NOOP, Refusal

DIGITS = 3
"""Significant digits required of an inexact number."""
_EXACT = 1e-9
"""Relative difference up to which a number is the exact value, which was computed in float64."""
_LARGEST_EXPONENT = 300
_LONGEST = 60

EMPTY = QT_TRANSLATE_NOOP("Refusal", "must be a number; nothing is typed yet")
NO_NUMBER = QT_TRANSLATE_NOOP(
    "Refusal", "must be a number like 0.5, 0,5, 1/2, -3 or 2e-3, and not {0}"
)
OVER_ZERO = QT_TRANSLATE_NOOP("Refusal", "must be a number: nothing can be divided by 0")
TOO_LARGE = QT_TRANSLATE_NOOP(
    "Refusal", "must be a number whose power of ten is between -{0} and {0}"
)
OTHER_UNIT = QT_TRANSLATE_NOOP("Refusal", "must be in {0}")
NO_UNIT = QT_TRANSLATE_NOOP("Refusal", "must be a number without {0}")
TOO_LONG = QT_TRANSLATE_NOOP("Refusal", "must be a number of at most {0} characters")

_DECIMAL = r"[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+"
_NUMBER = re.compile(
    rf"(?P<minus>[-+]?)(?P<number>{_DECIMAL})(?:(?:e|·10\^|\*10\^|x10\^)(?P<power>[-+]?[0-9]+))?"
    rf"(?:/(?P<under>-?(?:{_DECIMAL})))?",
    re.IGNORECASE,
)
_UNITS = (
    ("°", "degrees", "degree", "deg"), ("units", "unit"), ("px", "pixels", "pixel"),
    ("%",), ("×",), ("mm",), ("m",),
)  # fmt: skip
"""The spellings in a row are one unit."""
_OF_ANY = "units", "unit", "×"
"""What may follow a number without a unit."""


class Typed(NamedTuple):
    """A typed number; `unit` is the value of one in its last digit."""

    value: Fraction
    digits: int
    unit: Fraction


def read(text: str, unit: str = "") -> Typed:
    """Read a number with a decimal comma or point, and perhaps its unit."""
    if len(text) > _LONGEST:
        raise Refusal("answer", text, TOO_LONG, _LONGEST)
    plain = "".join(text.split()).replace("−", "-").replace("\u2044", "/")
    own = next((row for row in _UNITS if unit in row), (unit,) if unit else _OF_ANY)
    for ending in sorted((*own, *itertools.chain(*_UNITS)), key=len, reverse=True):
        if plain.lower().endswith(ending.lower()):
            plain = plain[: -len(ending)]
            if plain and ending not in own:
                raise Refusal("answer", text, *((OTHER_UNIT, unit) if unit else (NO_UNIT, ending)))
            break
    if not plain:
        raise Refusal("answer", text, EMPTY)
    found = _NUMBER.fullmatch(plain)
    if found is None:
        raise Refusal("answer", text, NO_NUMBER, text.strip() or plain)
    power = int((found["power"] or "0")[:6])
    if abs(power) > _LARGEST_EXPONENT:
        raise Refusal("answer", text, TOO_LARGE, _LARGEST_EXPONENT)
    written = found["number"].replace(",", ".")
    places = len(written.partition(".")[2])
    scale = Fraction(10) ** power
    value = Fraction(written if written != "." else "0") * scale
    if found["minus"] == "-":
        value = -value
    if abs(value) > Fraction(10) ** _LARGEST_EXPONENT:
        raise Refusal("answer", text, TOO_LARGE, _LARGEST_EXPONENT)
    if found["under"]:
        under = Fraction(found["under"].replace(",", "."))
        if not under:
            raise Refusal("answer", text, OVER_ZERO)
        value /= under
        return Typed(value, DIGITS, _unit_of(value))
    digits = written.replace(".", "").lstrip("0")
    return Typed(value, len(digits), scale / 10**places)


def _unit_of(value: Fraction) -> Fraction:
    """Return the value of one in the third significant digit."""
    if not value:
        return Fraction(0)
    return Fraction(10) ** (math.floor(math.log10(abs(float(value)))) - DIGITS + 1)


def equals(typed: Typed, value: float) -> bool:
    """Whether a typed number counts as a finite value."""
    away = abs(typed.value - Fraction(value))
    if away <= Fraction(_EXACT) * abs(Fraction(value)) or (not typed.value and abs(value) < 1e-12):
        return True
    return typed.digits >= DIGITS and away <= typed.unit


def is_too_short(typed: Typed, value: float) -> bool:
    """Whether it is the value rounded to too few digits, but more than one."""
    away = abs(typed.value - Fraction(value))
    return 1 < typed.digits < DIGITS and 2 * away <= typed.unit
