"""Read numbers as students write them, and decide whether they are right.

The exact value counts however short it is (1/2, 0.5, √3/2, -1, 0). A decimal number that is not
exact needs three significant digits and may be one unit off in its last digit, upwards or
downwards: students read values off the screen and round by hand. An expression with a decimal
number in it counts as three digits; one of whole numbers, such as 8/2^12, is not rounded and has
to be exact. The comparison is in rationals.
"""

import math
import re
import unicodedata
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

from app.lessons.quantities import FUNCTIONS, RATIONAL
from app.model.formula import Arithmetic, Call, Formula, Letter, Number, Product, Quotient, parse
from app.model.limits import LARGEST
from app.model.refusal import REFUSALS, Refusal, format_value

DIGITS = 3  # significant digits required of an inexact number
EXACT = Fraction(1, 10**9)
"""Relative difference up to which a number is the exact value, which was computed in float64."""
_ZERO = 1e-12  # a computed value below this is 0
_LARGEST_EXPONENT = round(math.log10(LARGEST))
_LONGEST, _LONGEST_SHOWN = 60, 17


_DECIMAL = r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)"
_LITERAL = re.compile(rf"([-+]?)({_DECIMAL})(?:(?:e|[*x×]10\^)([-+]?[0-9]+))?")
_MIXED = re.compile(r"(-?)([0-9]+) +([0-9]+)/([0-9]+)")
_SAME = str.maketrans(
    {
        **dict.fromkeys("·∙\u22c5", "*"), **dict.fromkeys("÷\u2044\u2215", "/"), "\u2236": ":",
        **dict.fromkeys("º˚∘ᵒ", "°"), **dict.fromkeys("\u2019\u02bc`\u00b4\u066c", "'"),
        "\u066b": ".", "−": "-",
    }
)  # fmt: skip
"""Signs on keyboards, and the signs that they look like."""
_RAISED = re.compile("[⁺⁻⁰¹²³⁴-⁹]+")
_NO_POWER = re.compile("([*x×] *10)?(?<![⁺⁻¹²³⁴-⁹])⁰(?![⁰¹²³⁴-⁹])")
"""A raised 0 that stands for the sign of degrees, unless it is a power of ten."""
_FRACTION = re.compile("(?<![0-9])([0-9]*) ?([¼-¾⅐-⅞])")
_HEAD = re.compile(  # text before a number: a name, and a sign that the number is rounded
    r"(?:[^\W\d][\w₀-₉]*['\u2032]* *:?(?=[=≈~]))?"
    r"(?:[=≈~≅≃\u223c ]|(?:ca|cca|circa|approx(?:imately)?|about|roughly|around|"
    r"oko|око|otprilike|отприлике|približno|приближно|umbes)\b\.?)*"
)
_GROUPED = re.compile(  # a number whose thousands are certain to be separated
    r"(?<![0-9.,])(?:[0-9]{1,3}([ '_])[0-9]{3}(?:\1[0-9]{3})*|[1-9][0-9]{0,2}"
    r"(?:(?:,[0-9]{3}){2,}|,[0-9]{3}(?=\.[0-9])|(?:\.[0-9]{3}){2,}|\.[0-9]{3}(?=,[0-9])))(?![0-9])"
)
_MAYBE_GROUPED = re.compile(r"[-+]?[1-9][0-9]{0,2}\.[0-9]{3}")
_PLACE = re.compile(r"\([^(),]*,[^(),]*\)")  # two numbers rather than one with a comma
_RATIO = re.compile(r"(?<=[0-9]) *: *(?=[0-9])")
_NAMES = (  # other names of functions
    (re.compile(r"(?<![a-z])(arc|a)?tg(?![a-z])"), r"\1tan"),
    (re.compile(r"(?<![a-z])co?tg(?![a-z])"), "cot"),
    (re.compile(r"(?<![a-z])(sin|cos|tan) *\^ *(?:-1(?![0-9])|\( *-1 *\))"), r"a\1"),
)
_REWRITTEN = (  # spellings of people, and the same in the language of formulas
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
_ROOT = re.compile(rf"\^ *(?:\( *([-+]? *{_DECIMAL}(?: */ *{_DECIMAL})?) *\)|(-?[0-9]*\.[0-9]+))")
"""A power that is no whole number."""
_BASE = re.compile(r"(?:(?<![0-9.])[0-9.]+|(?<![a-z])[a-z]+)$")

_OF_AN_ANGLE = r"(?<![a-z])(?:sin|cos|tan|cot)"
_BARE = re.compile(
    rf"({_OF_AN_ANGLE}|(?<![a-z])a(?:rc)?(?:sin|cos|tan)) *"
    rf"([-+]? *(?:{_DECIMAL}(?:e[-+]?[0-9]+)?|pi(?![a-z])|π))"
)
"""A function without brackets and its number; what may follow it and belong to it or not."""
_DEGREES = re.compile(r" *(?:°|deg(?:rees?)?(?![a-z]))")
_RADIANS = re.compile(r" *rad(?:ians?)?(?![a-z])")
_MAY_BELONG = re.compile(
    rf" *(?!(?:[*/] *)?-? *(?:a|arc)?(?:sin|cos|tan|cot))"
    rf"([*/^] *-? *|)({_DECIMAL}(?:/{_DECIMAL})?|pi|π|\([^()]*\)|sqrt|√)"
)
_TWO_READINGS = (
    # 1/2√3: over 2, or over 2√3
    (re.compile(
        rf"((?<![\w.])[\w.]+|\([^()]*\)) ?/ ?({_DECIMAL}) ?"
        r"((?:√|sqrt|pi|π|\(|a?(?:sin|cos|tan|cot))[^-+*/]*)"
     ), ("({0}/{1})*{2}", "{0}/({1}*{2})")),
    # 3^1/2: a half, or the root
    (re.compile(r"((?<!\w)\w+|\([^()]*\)) ?\^ ?1 ?/ ?([0-9]+)"), ("{0}^(1/{1})", "{0}/{1}")),
    # 1.5(3): a product, or a decimal number without end
    (re.compile(r"(?<![0-9])([0-9]*\.[0-9]+)\(([0-9]+)\)"), ("{0}*{1}", "{0}{1}{1}...")),
    # 2·10-3: a difference, or a power whose sign is lost
    (re.compile(rf"(?<![0-9.])({_DECIMAL} ?[*x×] ?10) ?-([0-9]+)"), ("{0}^-{1}", "({0})-{1}")),
)  # fmt: skip
"""Expressions that mean one thing by the rules, and often another one to who writes them."""

_NUMBER, _ANGLE, _UNIT = "number", "angle", "units"
_UNITS, UNITS = dict[str, tuple[str, Fraction]](), list[str]()
"""What each unit measures, and how much of it one is; and the units that a question may have."""
_PAGE = Path(__file__).with_name("units.md").read_text("utf-8")
for _kind, _size, _own, _typed in re.findall("(?m)^- (.+) (.+?): (.+); (.+)", _PAGE):
    UNITS += _own.split(", ")
    _UNITS |= dict.fromkeys(f"{_own}, {_typed}".split(", "), (_kind, Fraction(_size)))


class TypedNumber(NamedTuple):
    """A typed number; `unit` is the value of one in its last digit, 0 if it is not rounded."""

    value: Fraction
    digits: int
    unit: Fraction

    def times(self, factor: Fraction) -> "TypedNumber":
        """Return the number and its last digit, both multiplied."""
        return TypedNumber(self.value * factor, self.digits, self.unit * abs(factor))


def read(text: str, unit: str = "", near: float = 0.0) -> TypedNumber:
    """Read a number as people write it: ``0,5``, ``1 1/2``, ``-√3/2``, ``pi/6``, ``1.17·10⁻²``.

    A unit of the same kind as `unit`, one of `UNITS`, may follow, and is converted. A comma is a
    decimal point; where the number is one like `near`, 1000 or larger, ``1,280`` is refused. A
    `Refusal` of ``answer`` names the part that cannot be read, or the unit that is expected.
    """
    if len(text) > _LONGEST:
        raise Refusal("answer", text, REFUSALS["marking-too-long"], _LONGEST)
    plain, factor, is_angle = _without_unit(text, _with_brackets(text, _in_one_line(text)), unit)
    plain, end = plain.rstrip("."), len(plain)
    is_endless = end - len(plain) > 1
    if not plain:
        raise Refusal("answer", text.strip() or ..., REFUSALS["marking-empty"])
    match = _LITERAL.fullmatch(re.sub(" *([-+*x×^]) *", r"\1", plain))
    if match is None:
        value, is_rounded, gives_angle = _value(text, plain)
        if is_angle and gives_angle:
            factor = 1 / _UNITS[unit.lower()][1]
        last = _third_digit(value) if is_rounded else Fraction(0)
        return TypedNumber(value, DIGITS, last).times(factor)
    if _MAYBE_GROUPED.fullmatch(plain) and abs(near) >= 1000.0:
        raise Refusal(
            "answer", text, REFUSALS["ambiguous"], plain, f"{plain}0", plain.replace(".", "")
        )
    power = int((match[3] or "0")[:6])
    if abs(power) > _LARGEST_EXPONENT:
        raise Refusal("answer", text, REFUSALS["too-large"], _LARGEST_EXPONENT)
    _, _, places = match[2].partition(".")
    value = Fraction(match[1] + match[2]) * Fraction(10) ** power
    digits = len(match[2].replace(".", "").lstrip("0"))
    if is_endless and digits < DIGITS:
        raise Refusal("answer", text, REFUSALS["not-so-far"], DIGITS)
    typed = TypedNumber(value, digits, Fraction(10) ** (power - len(places)))
    return _bounded(text, typed).times(factor)


def _in_one_line(text: str) -> str:
    """Return the text in lower case with plain signs, spaces, fractions and decimal points."""
    text = _NO_POWER.sub(lambda zero: f"{zero[1]}^0" if zero[1] else "°", text.translate(_SAME))
    text = _RAISED.sub(lambda raised: f"^{''.join(map(_plain, raised[0]))}", text)
    text = " ".join("".join(map(_plain, text)).split())
    text = re.sub("[–—](?![0-9])|(?<![0-9])[–—]", "-", text)  # between digits it may mean “to”
    text = _HEAD.sub("", text, count=1)
    text = re.sub(r"(?<![.,;])[.,;]$", "", text)
    text = _GROUPED.sub(lambda group: re.sub("[ '_.,]", "", group[0]), text)
    text = _FRACTION.sub(_vulgar, text)
    text = _RATIO.sub("/", text)
    if not _PLACE.fullmatch(text):
        text = re.sub(r"(?<![0-9]),(?=[0-9])|(?<=[0-9]),(?=[0-9]|\b|$)", ".", text)
    for pattern, name in _NAMES:
        text = pattern.sub(name, text)
    return re.sub(r"^([-+]?)10 *\^", r"\g<1>1*10^", text)


def _plain(letter: str) -> str:
    """Return a letter, a digit of any script or a sign in its plain form."""
    if letter.isdecimal():
        return str(unicodedata.decimal(letter))
    if letter in "₀₁₂₃₄₅₆₇₈₉–—" or _FRACTION.fullmatch(letter):
        return letter
    like = {"Pd": "-", "Cf": ""}.get(unicodedata.category(letter))
    if like is None:
        like = unicodedata.normalize("NFKC", letter).translate(_SAME).lower()
    return like


def _vulgar(match: re.Match[str]) -> str:
    """Write a fraction of one letter, and the whole number before it, in brackets."""
    part = unicodedata.normalize("NFKC", match[2]).translate(_SAME)
    return f"({match[1]}+{part})" if match[1] else f"({part})"


def _with_brackets(text: str, plain: str) -> str:
    """Write the brackets of functions of one number, and drop the degrees of their angles."""
    parts, at = list[str](), 0
    while match := _BARE.search(plain, at):
        name, number = match.groups()
        degrees = _DEGREES.match(plain, match.end()) if not name.startswith("a") else None
        end = degrees.end() if degrees else match.end()
        more = _MAY_BELONG.match(plain, end)
        if more is not None:
            inside, rest = f"{number}{plain[match.end() : end].strip()}", more[0]
            readings = f"{name}({inside}){rest}", f"{name}({inside}{rest})"
            raise Refusal(
                "answer", text, REFUSALS["ambiguous"], plain[match.start() : more.end()], *readings
            )
        parts.append(f"{plain[at : match.start()]}{name}({number})")
        at = end
    plain = "".join(parts) + plain[at:]
    for match in reversed([*re.finditer(rf"{_OF_AN_ANGLE} *\(", plain)]):
        end = _closing(plain, match.end())
        inside = plain[match.end() : end]
        angle = _RADIANS.sub("", _DEGREES.sub("", inside))
        if _DEGREES.search(inside) and re.search("pi|π|rad", inside):
            raise Refusal("answer", text, REFUSALS["two-angles"], f"{match[0]}{inside})")
        if _RADIANS.search(inside):
            angle = f"({angle})*180/pi"
        plain = plain[: match.end()] + angle + plain[end:]
    return plain


def _closing(text: str, at: int) -> int:
    """Return where the bracket closes that is open at a place, or the text's end."""
    depth = 1
    for place in range(at, len(text)):
        depth += (text[place] == "(") - (text[place] == ")")
        if not depth:
            return place
    return len(text)


def _without_unit(text: str, plain: str, unit: str) -> tuple[str, Fraction, bool]:
    """Take the unit off the end; return the rest, its factor, and whether an angle is asked."""
    kind, size = _UNITS[unit.lower()] if unit else (_NUMBER, Fraction(1))
    for name in sorted(_UNITS, key=len, reverse=True):
        rest = plain.removesuffix(name).rstrip()
        if rest == plain or (name.isalpha() and rest[-1:].isalpha() and not rest.endswith("pi")):
            continue
        typed_kind, typed_size = _UNITS[name]
        same = typed_kind == kind or (not unit and typed_kind == _UNIT)
        if rest and not same:
            raise Refusal(
                "answer",
                text,
                *((REFUSALS["other-unit"], unit) if unit else (REFUSALS["no-unit"], name)),
            )
        return rest, typed_size / size if same else Fraction(1), kind == _ANGLE
    return plain, Fraction(1), kind == _ANGLE


def _value(text: str, plain: str) -> tuple[Fraction, bool, bool]:
    """Return an expression's value, whether it has a decimal number, and whether it is an angle.

    It has no letters but pi.
    """
    mixed = _MIXED.fullmatch(plain)
    if mixed and int(mixed[3]) < int(mixed[4]):
        part = Fraction(int(mixed[3]), int(mixed[4]))
        return (-1 if mixed[1] else 1) * (int(mixed[2]) + part), False, False
    for pattern, readings in _TWO_READINGS:
        if match := pattern.search(plain):
            possible = (reading.format(*match.groups()) for reading in readings)
            raise Refusal("answer", text, REFUSALS["ambiguous"], match[0], *possible)
    for pattern, written in _REWRITTEN:
        plain = pattern.sub(written, plain)
    plain = _with_roots(plain)
    try:
        formula = parse(re.sub(r"^\+(?![-+])", "", plain))
    except Refusal as error:
        at = int(str(error.limits[-1])) - 1
        for word in re.findall(r"[^\W\d_]{2,}", plain[:at]):
            if word not in (*FUNCTIONS, "pi", "pow"):
                raise Refusal("answer", text, REFUSALS["no-letter"], word) from error
        rest = (
            (REFUSALS["no-number"], plain[at:]) if plain[at:] else (REFUSALS["unfinished"], plain)
        )
        raise Refusal("answer", text, *rest) from error
    for letter in formula.letters:
        if letter != "pi":
            raise Refusal("answer", text, REFUSALS["no-letter"], letter)
    try:
        value: Fraction = _in_degrees(text, formula).value(_KNOWN, _TYPED)
    except KeyError as error:
        raise Refusal("answer", text, REFUSALS["no-letter"], str(error.args[0])) from error
    except ZeroDivisionError as error:
        raise Refusal("answer", text, REFUSALS["over-zero"]) from error
    except OverflowError as error:
        raise Refusal("answer", text, REFUSALS["too-large"], _LARGEST_EXPONENT) from error
    except (ValueError, TypeError) as error:
        if isinstance(error, Refusal) and error.field == "answer":
            raise
        raise Refusal("answer", text, REFUSALS["not-defined"]) from error
    value = _bounded(text, TypedNumber(value, DIGITS, Fraction(0))).value
    return value, "." in plain, is_angle(formula)


def _with_roots(plain: str) -> str:
    """Write powers that are no whole numbers, ``3^(1/2)`` and ``2^0.5``, as a function."""
    while match := _ROOT.search(plain):
        before = plain[: match.start()].rstrip()
        base = _BASE.search(before)
        if base is not None:
            at = base.start()
        elif before.endswith(")"):
            opens = (at for at in range(len(before)) if before[at] == "(")
            at = next((at for at in opens if _closing(before, at + 1) == len(before) - 1), 0)
            at = len(before[:at].rstrip("acinopqrst"))
        else:
            break
        power = match[1] or match[2]
        plain = f"{before[:at]}pow({before[at:]},{power}){plain[match.end() :]}"
    return plain


def _in_degrees(text: str, formula: Formula) -> Formula:
    """Return a formula whose angles with a pi in them, which are in radians, are in degrees."""
    parts = [_in_degrees(text, part) for part in formula.parts]
    if isinstance(formula, Call) and formula.name in OF_ANGLES and "pi" in formula.letters:
        if any(isinstance(part, Call) and part.name in _TO_ANGLES for part in formula):
            raise Refusal("answer", text, REFUSALS["two-angles"], formula.text)
        one, twice = (abs(parts[0].value({"pi": times * _KNOWN["pi"]}, _TYPED)) for times in (1, 2))
        if twice > one:  # not of 180/pi
            half_turn = Quotient(Number(Fraction(180)), Letter("pi"))
            parts[0] = Product(parts[0], half_turn)
    return formula.with_parts(parts)


def is_angle(formula: Formula) -> bool:
    """Whether the value is an angle, as far as its functions say so."""
    if isinstance(formula, Call):
        return formula.name in _TO_ANGLES
    return any(map(is_angle, formula.parts))


def _typed_function(name: str, arguments: Sequence[Fraction]) -> Fraction:
    if name == "pow":
        return Fraction(math.pow(*map(float, arguments)))
    value: Fraction = RATIONAL.call(name, arguments)
    return value


_TYPED = Arithmetic(Fraction, _typed_function)
_KNOWN = {"pi": Fraction(math.pi)}
OF_ANGLES, _TO_ANGLES = ("sin", "cos", "tan", "cot"), ("asin", "acos", "atan")


def _bounded(text: str, typed: TypedNumber) -> TypedNumber:
    """Return the number if the value of a formula may be so large, or so near to 0."""
    most = Fraction(10) ** _LARGEST_EXPONENT
    if typed.value and not 1 / most <= abs(typed.value) <= most:
        raise Refusal("answer", text, REFUSALS["too-large"], _LARGEST_EXPONENT)
    return typed


def _third_digit(value: Fraction) -> Fraction:
    """Return the value of one in the third significant digit."""
    if not float(value):
        return Fraction(0)
    return Fraction(10) ** (math.floor(math.log10(abs(float(value)))) - DIGITS + 1)


def equals(typed: TypedNumber, value: float) -> bool:
    """Whether a typed number counts as a finite value."""
    exact = Fraction(value)
    away, noise = abs(typed.value - exact), EXACT * abs(exact)
    if away <= noise or (not typed.value and abs(value) < _ZERO):
        return True
    return typed.digits >= DIGITS and away <= typed.unit + noise


def are_alike(one: float, other: float) -> bool:
    """Whether a number of three digits would count as both values."""
    low, high = sorted((abs(one), abs(other)))
    if high < _ZERO:
        return True
    if one * other <= 0.0:
        return False
    units = [_third_digit(Fraction(low)), _third_digit(Fraction(high))]
    for unit in (*units, 10 * units[1]):  # that of 10.0 also counts for 9.95
        # From the value down or up to one in the third digit.
        least = math.ceil(Fraction(high) * (1 - EXACT) / unit - 1)
        most = math.floor(Fraction(low) * (1 + EXACT) / unit + 1)
        if max(least, 10 ** (DIGITS - 1)) <= most:
            return True
    return False


def digits_shown(value: float, least: int) -> int:
    """Return how many digits a value is shown with, so that it counts if it is typed as shown."""
    if value.is_integer() or not math.isfinite(value):  # perhaps a count
        return 10
    for count in range(least, _LONGEST_SHOWN):
        text = f"{abs(value):.{count - 1}e}"
        digits = text.partition("e")[0].replace(".", "").rstrip("0")
        if len(digits) >= DIGITS or math.isclose(float(text), abs(value), rel_tol=EXACT):
            return count
    return _LONGEST_SHOWN


def is_too_short(typed: TypedNumber, value: float) -> bool:
    """Whether it is the value rounded to too few digits, but more than one."""
    return typed.digits > 1 and is_rounded(typed, value)


def is_rounded(typed: TypedNumber, value: float) -> bool:
    """Whether it is the value rounded to too few digits, and still within a twentieth of it."""
    exact = Fraction(value)
    away = abs(typed.value - exact)
    is_near = 2 * away <= typed.unit + EXACT * abs(exact) and 20 * away <= abs(exact)
    return 0 < typed.digits < DIGITS and is_near


def remark(typed: TypedNumber, value: float) -> Refusal | None:
    """Say how a wrong number differs from the value, if something true can be said."""
    if not typed.value or not value:
        return None
    ratio = typed.value / Fraction(value)
    if equals(typed.times(Fraction(-1)), value):
        return Refusal.saying(REFUSALS["sign"])
    if ratio < 0:
        return Refusal.saying(REFUSALS["sign-and-size"])
    power = round(math.log10(ratio))
    if power and equals(typed.times(1 / Fraction(10) ** power), value):
        return Refusal.saying(REFUSALS["tens"])
    degrees = Fraction(math.degrees(1.0))
    if any(equals(typed.times(factor), value) for factor in (degrees, 1 / degrees)):
        return Refusal.saying(REFUSALS["radians"])
    if abs(typed.value * Fraction(value) - 1) <= Fraction(2, 10**DIGITS):
        return Refusal.saying(REFUSALS["turned"])
    away = float(max(ratio, 1 / ratio))
    if away < 1.05:
        return Refusal.saying(REFUSALS["nearly"])
    factor = format_value(float(f"{away:.2g}"))
    return Refusal.saying(REFUSALS["large"] if ratio > 1 else REFUSALS["small"], factor)
