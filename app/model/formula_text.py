"""Formulas as text in one line, with stacked fractions, and in LaTeX, in a lecture's symbols."""

import re
from collections.abc import Mapping

from app.model.formula import (
    ARROW,
    BASE,
    FACTOR,
    IN_PRODUCT,
    IN_SUM,
    Call,
    Formula,
    FormulaWriter,
    Negative,
)

OPEN, OVER, CLOSE = "{", "\u2044", "}"
"""Delimiters of the parts of a stacked fraction; no formula contains them."""


def stacked_fraction(above: str, below: str) -> str:
    """The text of a stacked fraction: ``{2n\u2044r − l}``."""
    return f"{OPEN}{above}{OVER}{below}{CLOSE}"


class _Plain(FormulaWriter):
    """Writes one line for a reader."""

    minus, minus_between, plus, space, degree = "−", " − ", " + ", "\u2009", "°"
    times = "·"

    def call(self, name: str, inside: list[str], outer: int) -> str:
        if name == "dot":
            return self.bracketed(self.times.join(inside), outer > IN_PRODUCT)
        return super().call(name, inside, outer)

    def product(self, left: str, right: str) -> str:
        is_number = left[-1].isdigit() and not set("_^") & set(left)
        between = "" if is_number else self.space
        return f"{left}{self.times if right[0].isdigit() else between}{right}"


class _Stacked(_Plain):
    """Writes stacked fractions; those inside a fraction or a function stay on one line."""

    def __init__(self, symbols: Mapping[str, str]) -> None:
        super().__init__(symbols)
        self._in_line = _Plain(symbols)

    def write(self, formula: Formula, outer: int = 0) -> str:
        writer = self._in_line.write if isinstance(formula, Call) else super().write
        return writer(formula, outer)

    def quotient(self, above: Formula, below: Formula, outer: int) -> str:
        minus = ""
        if isinstance(above, Negative):
            above, minus = above.operand, self.minus
        text = f"{minus}{self.fraction(above, below)}"
        return self.bracketed(text, outer == BASE or (bool(minus) and outer > IN_SUM))

    def fraction(self, above: Formula, below: Formula) -> str:
        return stacked_fraction(self._in_line.write(above), self._in_line.write(below))


_IN_LATEX = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "abs": "operatorname{abs}"}
_LATEX_WORD = re.compile(r"\\(mathrm\{|[a-z]+(\{abs\})?\\left\()")
_LATEX_NUMBER = re.compile(r"(\\left)?\(-?[0-9]|\\frac")
"""After a number it needs a sign of multiplication: 2(-3) and 2 1/3 are something else."""
GREEK = dict(zip("\u03b1β\u03b3δεθλμπρ\u03c3φω", (  # noqa: RUF001
    "alpha", "beta", "gamma", "delta", "epsilon", "theta", "lambda", "mu", "pi", "rho", "sigma",
    "phi", "omega",
), strict=True))  # fmt: skip
"""The letters of panes and figures, and what TeX calls them."""
_IN_TEX = {letter: f"\\{name}" for letter, name in GREEK.items()} | {"φ": r"\varphi"}
_IN_TEX |= {name: f"\\{name}" for name in ("alpha", "beta", "theta", "psi")}  # in lessons' formulas


class _Latex(_Stacked):
    minus, minus_between, plus, space = "-", " - ", " + ", r" \, "
    degree = r"^{\circ}"
    times = r" \cdot "

    def symbol(self, name: str) -> str:
        if name.endswith(ARROW):
            return rf"\vec{{{name.removesuffix(ARROW)}}}"
        head, _, below = name.partition("_")
        head = _IN_TEX.get(head, head if len(head) == 1 else rf"\mathrm{{{head}}}")
        if not below:
            return head
        if len(below) > 1 and not below.isdigit():
            below = rf"\mathrm{{{below}}}"
        return f"{head}_{{{below}}}"

    def call(self, name: str, inside: list[str], outer: int) -> str:
        if name == "dot":
            return super().call(name, inside, outer)
        if name == "sqrt":
            return rf"\sqrt{{{', '.join(inside)}}}"
        return rf"\{_IN_LATEX.get(name, name)}\left({', '.join(inside)}\right)"

    def product(self, left: str, right: str) -> str:
        if left[-1].isdigit() and _LATEX_NUMBER.match(right):
            return f"{left}{self.times}{right}"
        is_word = _LATEX_WORD.match(right) is not None
        return f"{left}{self.space}{right}" if is_word else super().product(left, right)

    def power(self, base: str, exponent: int, outer: int) -> str:
        return self.bracketed(f"{base}^{{{exponent}}}", outer > FACTOR)

    def write(self, formula: Formula, outer: int = 0) -> str:
        return _Plain.write(self, formula, outer)

    def fraction(self, above: Formula, below: Formula) -> str:
        return rf"\frac{{{self.write(above)}}}{{{self.write(below)}}}"

    def brackets(self, text: str) -> str:
        return rf"\left({text}\right)" if "\\frac" in text else f"({text})"


def written(formula: Formula, symbols: Mapping[str, str]) -> str:
    """A formula for a reader, in one line: ``2n/(r − l)``.

    `symbols` replace letters: ``_`` precedes a subscript, and `ARROW` follows a vector's letter.
    """
    return _Plain(symbols).write(formula)


def stacked(formula: Formula, symbols: Mapping[str, str]) -> str:
    """A formula for a reader with stacked fractions; `symbols` as in `written`."""
    return _Stacked(symbols).write(formula)


def latex(formula: Formula, symbols: Mapping[str, str]) -> str:
    """A formula in LaTeX, ``\\frac{2 n}{r - l}``; `symbols` as in `written`."""
    return _Latex(symbols).write(formula)
