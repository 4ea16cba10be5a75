"""Read numbers as students write them, and decide whether they are right.

The exact value counts however short it is (1/2, 0.5, √3/2, -1, 0). A decimal number that is not
exact needs three significant digits and may be one unit off in its last digit, upwards or
downwards: students read values off the screen and round by hand. Any other way to write a number
counts as three digits. The comparison is in rationals.
"""

from __future__ import annotations

import math
import re
import unicodedata
from fractions import Fraction
from typing import NamedTuple

from app.lessons.quantities import FUNCTIONS, RATIONAL
from app.model.formula import parse
from app.model.limits import LARGEST
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal

DIGITS = 3
"""Significant digits required of an inexact number."""
_EXACT = Fraction(1, 10**9)
"""Relative difference up to which a number is the exact value, which was computed in float64."""
_LARGEST_EXPONENT = round(math.log10(LARGEST))
_LONGEST = 60

EMPTY = QT_TRANSLATE_NOOP("Refusal", "must be a number; nothing is typed yet")
NO_NUMBER = QT_TRANSLATE_NOOP(
    "Refusal", "must be a number like 0.5, 1/2, √3/2 or 2e-3; {0} cannot be read as part of one"
)
UNFINISHED = QT_TRANSLATE_NOOP("Refusal", "must be a number; something is missing after {0}")
NO_LETTER = QT_TRANSLATE_NOOP("Refusal", "must be a number; {0} is neither a number nor a unit")
OVER_ZERO = QT_TRANSLATE_NOOP("Refusal", "must be a number: nothing can be divided by 0")
NOT_DEFINED = QT_TRANSLATE_NOOP("Refusal", "must be a number: a function has no value there")
TOO_LARGE = QT_TRANSLATE_NOOP(
    "Refusal", "must be a number whose power of ten is between -{0} and {0}"
)
OTHER_UNIT = QT_TRANSLATE_NOOP("Refusal", "must be in {0}")
NO_UNIT = QT_TRANSLATE_NOOP("Refusal", "must be a number without {0}")
AMBIGUOUS = QT_TRANSLATE_NOOP(
    "Refusal", "must be a number; {0} may be {1} or {2}: write the brackets"
)
TOO_LONG = QT_TRANSLATE_NOOP("Refusal", "must be a number of at most {0} characters")

SIGN = QT_TRANSLATE_NOOP("Refusal", "The size is right, but the sign is wrong.")
SIGN_AND_SIZE = QT_TRANSLATE_NOOP("Refusal", "The sign is wrong, and so is the size.")
TENS = QT_TRANSLATE_NOOP("Refusal", "The digits are right, but the power of ten is wrong.")
TURNED = QT_TRANSLATE_NOOP("Refusal", "This is 1 divided by the right number.")
RADIANS = QT_TRANSLATE_NOOP(
    "Refusal", "It is off by the factor 180/π: degrees and radians are mixed up."
)
LARGE = QT_TRANSLATE_NOOP("Refusal", "It is too large, by a factor of about {0}.")
SMALL = QT_TRANSLATE_NOOP("Refusal", "It is too small, by a factor of about {0}.")
NEARLY = QT_TRANSLATE_NOOP("Refusal", "It is close, but not exact enough.")

_DECIMAL = r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)"
_LITERAL = re.compile(rf"([-+]?)({_DECIMAL})(?:(?:e|[*x×]10\^)([-+]?[0-9]+))?")
_MIXED = re.compile(r"(-?)([0-9]+) +([0-9]+)/([0-9]+)")
_THOUSANDS = re.compile(r"(?<![0-9.,])[0-9]{1,3}(?: [0-9]{3})+(?![0-9])")
_RAISED = re.compile("[⁺⁻⁰¹²³⁴-⁹]+")
_RATIO = re.compile(r"(?<=[0-9]) *: *(?=[0-9])")
_SAME = str.maketrans({"−": "-", "·": "*", "∙": "*", "\u22c5": "*", "\u2044": "/", "\u2215": "/"})
_DEGREE = str.maketrans("º˚", "°°")
"""Signs on keyboards that look like the one of degrees."""
_REWRITTEN = (
    (re.compile(r"(?<![a-z])arc(?=sin|cos|tan)"), "a"),
    (re.compile(rf"(?:√|sqrt) *({_DECIMAL})"), r"sqrt(\1)"),
    (re.compile("√"), "sqrt"),
    (re.compile("π"), "pi"),
    (re.compile(r"[×x](?= *10\^)"), "*"),
    (re.compile("×"), "*"),
    (re.compile(r"\*\*"), "^"),
    (re.compile(r"°(?= *\))"), ""),
    (re.compile(r"\^ *(?:\( *([-+]?[0-9]+) *\)|\+([0-9]+))"), r"^\1\2"),
    (re.compile(rf"({_DECIMAL})e([-+]?[0-9]+)"), r"(\1*10^\2)"),
    (re.compile(r"\^\+"), "^"),
    (re.compile(r"(?<=[0-9)]) *(?=[a-z(])"), "*"),
)
"""What people write, and the same in the language of formulas."""

_OF_ANGLES = r"(?<![a-z])(?:sin|cos|tan|cot)"
_BARE = re.compile(
    rf"({_OF_ANGLES}|(?<![a-z])a(?:rc)?(?:sin|cos|tan)) *([-+]? *{_DECIMAL}(?:e[-+]?[0-9]+)?)"
)
"""A function without brackets and its number; what may follow it and belong to it or not."""
_DEGREES = re.compile(r" *(?:°|deg(?:rees?)?(?![a-z]))")
_MAY_BELONG = re.compile(
    rf" *(?!(?:[*/] *)?-? *(?:a|arc)?(?:sin|cos|tan|cot))"
    rf"([*/^] *-? *|)({_DECIMAL}(?:/{_DECIMAL})?|pi|π|\([^()]*\)|sqrt|√)"
)

_NUMBER, _ANGLE, _LENGTH, _UNIT, _PIXEL = "number", "angle", "length", "units", "px"
_UNITS: dict[str, tuple[str, Fraction]] = {
    **dict.fromkeys(("×", "x"), (_NUMBER, Fraction(1))), "%": (_NUMBER, Fraction(1, 100)),
    **dict.fromkeys(("°", "deg", "degree", "degrees"), (_ANGLE, Fraction(1))),
    **dict.fromkeys(("rad", "radian", "radians"), (_ANGLE, Fraction(math.degrees(1.0)))),
    **dict.fromkeys(("unit", "units"), (_UNIT, Fraction(1))),
    **dict.fromkeys(("px", "pixel", "pixels"), (_PIXEL, Fraction(1))),
    "km": (_LENGTH, Fraction(1000)), "m": (_LENGTH, Fraction(1)),
    "cm": (_LENGTH, Fraction(1, 100)), "mm": (_LENGTH, Fraction(1, 1000)),
}  # fmt: skip
"""What each unit measures, and how much of it one is."""
UNITS = tuple(_UNITS)
"""The units that are converted, as they are typed."""


class Typed(NamedTuple):
    """A typed number; `unit` is the value of one in its last digit."""

    value: Fraction
    digits: int
    unit: Fraction

    def times(self, factor: Fraction) -> Typed:
        """Return the number and its last digit, both multiplied."""
        return Typed(self.value * factor, self.digits, self.unit * abs(factor))


def read(text: str, unit: str = "") -> Typed:
    """Read a number as people write it: ``0,5``, ``1 1/2``, ``-√3/2``, ``pi/6``, ``1.17·10⁻²``.

    A unit of the same kind as `unit`, one of `UNITS`, may follow, and is converted. A comma is a
    decimal point.

    Raises
    ------
    Refusal
        Of ``answer``; it names the part that cannot be read, or the unit that is expected.
    """
    if len(text) > _LONGEST:
        raise Refusal("answer", text, TOO_LONG, _LONGEST)
    plain, factor = _without_unit(text, _with_brackets(text, _in_one_line(text)), unit)
    if not plain:
        raise Refusal.in_document(EMPTY, field="answer", value=text.strip() or ...)
    found = _LITERAL.fullmatch(re.sub(" *([-+*x×^]) *", r"\1", plain))
    if found is None:
        value = _value(text, plain)
        return Typed(value, DIGITS, _third_digit(value)).times(factor)
    power = int((found[3] or "0")[:6])
    if abs(power) > _LARGEST_EXPONENT:
        raise Refusal("answer", text, TOO_LARGE, _LARGEST_EXPONENT)
    _, _, places = found[2].partition(".")
    value = Fraction(found[1] + found[2]) * Fraction(10) ** power
    digits = len(found[2].replace(".", "").lstrip("0"))
    return _bounded(text, Typed(value, digits, Fraction(10) ** (power - len(places)))).times(factor)


def _in_one_line(text: str) -> str:
    """Return the text in lower case with plain signs, spaces, fractions and decimal points."""
    text = _RAISED.sub(lambda raised: "^" + unicodedata.normalize("NFKC", raised[0]), text)
    letters = list(text.translate(_DEGREE).lstrip("=≈~ "))
    for at, part in enumerate(letters):
        if unicodedata.decomposition(part).startswith("<fraction>"):  # ½, of its own: 1½, √½
            letters[at] = f"({part})" if letters[at - 1 : at] == ["√"] else f" {part}"
    text = "".join(letters)
    text = unicodedata.normalize("NFKC", text).translate(_SAME).lower()
    text = "".join("-" if unicodedata.category(part) == "Pd" else part for part in text)
    text = _THOUSANDS.sub(lambda group: group[0].replace(" ", ""), " ".join(text.split()))
    text = _RATIO.sub("/", text)
    text = re.sub(r"(?<![0-9]),(?=[0-9])|(?<=[0-9]),(?=[0-9]|\b|$)", ".", text)
    return re.sub(r"^([-+]?)10 *\^", r"\g<1>1*10^", text)


def _with_brackets(text: str, plain: str) -> str:
    """Write the brackets of functions of one number, and drop the degrees of their angles."""
    parts, at = list[str](), 0
    while found := _BARE.search(plain, at):
        name, number = found.groups()
        degrees = _DEGREES.match(plain, found.end()) if not name.startswith("a") else None
        end = degrees.end() if degrees else found.end()
        more = _MAY_BELONG.match(plain, end)
        if more is not None:
            inside, rest = f"{number}{plain[found.end() : end].strip()}", more[0]
            ways = f"{name}({inside}){rest}", f"{name}({inside}{rest})"
            raise Refusal("answer", text, AMBIGUOUS, plain[found.start() : more.end()], *ways)
        parts.append(f"{plain[at : found.start()]}{name}({number})")
        at = end
    plain = "".join(parts) + plain[at:]
    for found in reversed([*re.finditer(rf"{_OF_ANGLES} *\(", plain)]):
        end = _closing(plain, found.end())
        plain = plain[: found.end()] + _DEGREES.sub("", plain[found.end() : end]) + plain[end:]
    return plain


def _closing(text: str, at: int) -> int:
    """Return where the bracket closes that is open at a place, or the text's end."""
    depth = 1
    for place in range(at, len(text)):
        depth += (text[place] == "(") - (text[place] == ")")
        if not depth:
            return place
    return len(text)


def _without_unit(text: str, plain: str, unit: str) -> tuple[str, Fraction]:
    """Take the unit off the end; return the rest, and by what it is to be multiplied."""
    kind, size = _UNITS[unit.lower()] if unit else (_NUMBER, Fraction(1))
    for name in sorted(UNITS, key=len, reverse=True):
        rest = plain.removesuffix(name).rstrip()
        if rest == plain or (name.isalpha() and rest[-1:].isalpha() and not rest.endswith("pi")):
            continue
        typed_kind, typed_size = _UNITS[name]
        same = typed_kind == kind or (not unit and typed_kind == _UNIT)
        if rest and not same:
            raise Refusal("answer", text, *((OTHER_UNIT, unit) if unit else (NO_UNIT, name)))
        return rest, typed_size / size if same else Fraction(1)
    return plain, Fraction(1)


def _value(text: str, plain: str) -> Fraction:
    """Return the value of an expression without letters but pi."""
    mixed = _MIXED.fullmatch(plain)
    if mixed and int(mixed[3]) < int(mixed[4]):
        part = Fraction(int(mixed[3]), int(mixed[4]))
        return (-1 if mixed[1] else 1) * (int(mixed[2]) + part)
    for pattern, written in _REWRITTEN:
        plain = pattern.sub(written, plain)
    try:
        found = parse(plain.removeprefix("+"))
    except Refusal as error:
        at = int(str(error.limits[-1])) - 1
        for word in re.findall(r"[^\W\d_]{2,}", plain[:at]):
            if word not in FUNCTIONS and word != "pi":
                raise Refusal("answer", text, NO_LETTER, word) from error
        rest = (NO_NUMBER, plain[at:]) if plain[at:] else (UNFINISHED, plain)
        raise Refusal("answer", text, *rest) from error
    for letter in found.letters:
        if letter != "pi":
            raise Refusal("answer", text, NO_LETTER, letter)
    try:
        value: Fraction = found.value({"pi": Fraction(math.pi)}, RATIONAL)
    except KeyError as error:
        raise Refusal("answer", text, NO_LETTER, str(error.args[0])) from error
    except ZeroDivisionError as error:
        raise Refusal("answer", text, OVER_ZERO) from error
    except OverflowError as error:
        raise Refusal("answer", text, TOO_LARGE, _LARGEST_EXPONENT) from error
    except (ValueError, TypeError) as error:
        raise Refusal("answer", text, NOT_DEFINED) from error
    return _bounded(text, Typed(value, DIGITS, Fraction(0))).value


def _bounded(text: str, typed: Typed) -> Typed:
    """Return the number if the value of a formula may be so large, or so near to 0."""
    most = Fraction(10) ** _LARGEST_EXPONENT
    if typed.value and not 1 / most <= abs(typed.value) <= most:
        raise Refusal("answer", text, TOO_LARGE, _LARGEST_EXPONENT)
    return typed


def _third_digit(value: Fraction) -> Fraction:
    """Return the value of one in the third significant digit."""
    if not float(value):
        return Fraction(0)
    return Fraction(10) ** (math.floor(math.log10(abs(float(value)))) - DIGITS + 1)


def equals(typed: Typed, value: float) -> bool:
    """Whether a typed number counts as a finite value."""
    exact = Fraction(value)
    away, noise = abs(typed.value - exact), _EXACT * abs(exact)
    if away <= noise or (not typed.value and abs(value) < 1e-12):
        return True
    return typed.digits >= DIGITS and away <= typed.unit + noise


def is_too_short(typed: Typed, value: float) -> bool:
    """Whether it is the value rounded to too few digits, but more than one."""
    exact = Fraction(value)
    away = abs(typed.value - exact)
    return 1 < typed.digits < DIGITS and 2 * away <= typed.unit + _EXACT * abs(exact)


def remark(typed: Typed, value: float) -> Refusal | None:
    """Say how a wrong number differs from the value, if something true can be said."""
    if not typed.value or not value:
        return None
    ratio = typed.value / Fraction(value)
    if equals(typed.times(Fraction(-1)), value):
        return Refusal.saying(SIGN)
    if ratio < 0:
        return Refusal.saying(SIGN_AND_SIZE)
    power = round(math.log10(ratio))
    if power and equals(typed.times(1 / Fraction(10) ** power), value):
        return Refusal.saying(TENS)
    degrees = Fraction(math.degrees(1.0))
    if any(equals(typed.times(factor), value) for factor in (degrees, 1 / degrees)):
        return Refusal.saying(RADIANS)
    if abs(typed.value * Fraction(value) - 1) <= Fraction(2, 10**DIGITS):
        return Refusal.saying(TURNED)
    away = float(max(ratio, 1 / ratio))
    if away < 1.05:
        return Refusal.saying(NEARLY)
    return Refusal.saying(LARGE if ratio > 1 else SMALL, f"{away:.2g}")
