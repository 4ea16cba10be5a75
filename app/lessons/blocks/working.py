"""Worked solutions: a formula in letters, with its numbers put in, and its value, as TeX."""

import math
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

from app.lessons.marking import OF_ANGLES, digits_shown, is_angle
from app.lessons.quantities import FUNCTIONS, Quantities
from app.model.formula import Call, Degrees, Formula, Letter, Negative, Number, Product, Quotient
from app.model.formula_text import latex

_HIDDEN = ("reading", "was", "quality")  # such names are the program's, and no reader knows them
_UNITS = {"°": r"^{\circ}", "%": r"\,\%", "×": r"\times", "x": r"\times"}


class Working(NamedTuple):
    """A formula for a reader: in letters, with numbers, and its value."""

    letters: Formula
    numbers: Formula
    value: float
    is_exact: bool  # whether none of the numbers is rounded

    def sides(self, name: str = "", unit: str = "") -> list[str]:
        """Return what is equal, each with its sign except the first; `name` is TeX of the left."""
        value, is_whole = written_value(self.value)
        unit = unit or ("°" if is_angle(self.letters) else "")
        value += _UNITS.get(unit, rf"\ \mathrm{{{unit}}}" if unit else "")
        letters, numbers = latex(self.letters, {}), latex(self.numbers, {})
        about = "=" if self.is_exact else r"\approx"
        if name:
            letters = f"{name} = {letters}" if letters != name else name
            numbers = "" if letters.endswith(f"= {numbers}") else numbers
            value = "" if letters.endswith(f"= {value}") else value
        sides = [(letters, ""), (numbers, about), (value, about if is_whole else r"\approx")]
        signs = {text: sign for text, sign in reversed(sides) if text}  # the first of equal ones
        texts = dict.fromkeys(text for text, _ in sides if text)
        return [f"{signs[text]} {text}" if place else text for place, text in enumerate(texts)]


def working(formula: Formula, known: Quantities) -> Working | None:
    """Return the way to a formula's value; None if no reader knows a name, or its number."""
    cells = dict[str, Formula]()
    numbers, is_exact = dict[str, Formula](), True
    for part in formula:
        if isinstance(part, Letter) and part.name not in ("pi", "infinity"):
            head, _, rest = part.name.partition("_")
            if head in _HIDDEN or rest.count("_") > (head == "settings"):
                return None
            if head == "settings":
                cells[part.text] = Letter(rest)
        elif isinstance(part, Call) and part.name not in FUNCTIONS:
            cell = _cell(part)
            if cell is None:
                return None
            cells[part.text] = cell
        else:
            continue
        value = known.value(part, infinite=True)
        if math.isinf(value):
            return None
        digits = 10 if value.is_integer() else 4  # a count is no rounded number
        number = Fraction(f"{value:.{digits}g}")
        is_exact = is_exact and math.isclose(number, value, rel_tol=1e-9)
        figure = Number(abs(number))
        numbers[part.text] = figure if number >= 0 else Negative(figure)
    letters = _in_degrees(formula, cells, False)
    return Working(letters, _in_degrees(formula, numbers, False), known.value(formula), is_exact)


def in_list(workings: Iterable[Sequence[str]]) -> str:
    """Write several equations as a list in Markdown: centred ones would not begin alike."""
    return "\n".join(f"- {in_markdown(sides)}" for sides in workings)


def in_markdown(sides: Iterable[str]) -> str:
    """Write the sides of an equation as formulas between which a line may break."""
    return " ".join(f"${side}$" for side in sides)


def has_names(formula: Formula) -> bool:
    return any(name not in ("pi", "infinity") for name in formula.letters) or any(
        isinstance(part, Call) and part.name not in FUNCTIONS for part in formula
    )


def has_way(formula: Formula) -> bool:
    """Whether a formula has names, and is more than one of them."""
    is_name = isinstance(formula, Call) and formula.name not in FUNCTIONS
    return bool(formula.parts) and not is_name and has_names(formula)


def written_value(value: float) -> tuple[str, bool]:
    """Return a value to four digits as TeX, and whether that is all of it."""
    if abs(value) < 1e-12:
        return "0", True
    text = f"{value:.{digits_shown(value, 4)}g}"
    is_whole = math.isclose(float(text), value, rel_tol=1e-9)
    digits, _, power = text.partition("e")
    return (rf"{digits} \cdot 10^{{{int(power)}}}" if power else digits), is_whole


def _cell(call: Call) -> Letter | None:
    """Return the letter of a matrix's cell, which counts from 1: ``m_12``."""
    places = [part.number for part in call.parts if isinstance(part, Number)]
    if "_from_" not in call.name or len(places) != 2:
        return None
    return Letter(f"m_{places[0] + 1}{places[1] + 1}")


def _in_degrees(formula: Formula, terms: Mapping[str, Formula], is_angle: bool) -> Formula:
    """Replace terms, and write the numbers of angles, which stand in sin or tan, with degrees."""
    inner = terms.get(formula.text, formula)
    if inner is not formula or not formula.parts:
        return _degrees(inner) if is_angle else inner
    if isinstance(formula, Call):
        inside = formula.name in OF_ANGLES
        return formula.with_parts(_in_degrees(part, terms, inside) for part in formula.parts)
    parts = formula.parts
    angles = [is_angle] * len(parts)
    if is_angle and isinstance(formula, Product | Quotient):  # one factor is the angle
        second = isinstance(formula, Product) and not has_names(parts[0]) and has_names(parts[1])
        angles = [not second, second]
    return formula.with_parts(
        _in_degrees(part, terms, each) for part, each in zip(parts, angles, strict=True)
    )


def _degrees(number: Formula) -> Formula:
    if isinstance(number, Negative):
        return Negative(_degrees(number.operand))
    return Degrees(number.number) if isinstance(number, Number) else number
