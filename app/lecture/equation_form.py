"""How the matrices of an equation are set: their cells' texts, and the least sizes in em."""

from collections.abc import Iterator
from typing import NamedTuple

from app.languages import with_comma
from app.lecture.equation import Equation, Term, latex_cell
from app.lecture.typesetting import line_of

DIGITS, FEWER_DIGITS = 4, 3  # of the numbers of one matrix, and of a product
PAD_EM, GAP_EM, BRACKET_EM, APART_EM = 0.45, 0.35, 0.3, 1.5
ROW_EM = 0.4
"""Gaps beside a cell, between matrices, inside a bracket, and between matrices that are no product;
and between rows."""


class MatrixLayout(NamedTuple):
    term: Term
    cells: tuple[tuple[str, ...], ...]
    widths: tuple[float, ...]
    heights: tuple[float, ...]

    @property
    def width(self) -> float:
        return sum(self.widths) + 2.0 * BRACKET_EM

    @property
    def lead(self) -> str:
        """What stands before a matrix alone."""
        return f"${self.term.name} =$"


def laid_out(equation: Equation) -> Iterator[MatrixLayout]:
    """Lay out the matrices of an equation, in formulas or in numbers."""
    digits = (FEWER_DIGITS if equation.factors else DIGITS) if equation.is_in_numbers else 0
    for term in equation.terms:
        matrix = term.matrix
        cells = tuple(
            tuple(
                _number(value, digits) if digits else f"${latex_cell(text, term.letters)}$"
                for value, text in zip(*row, strict=True)
            )
            for row in zip(matrix.values, matrix.formulas, strict=True)
        )
        widths = [max(map(width_em, column)) + 2.0 * PAD_EM for column in zip(*cells, strict=True)]
        boxes = [[line_of(cell, formula=1.0).box for cell in row] for row in cells]
        heights = [max(high - low for _, low, _, high in row) + ROW_EM for row in boxes]
        yield MatrixLayout(term, cells, tuple(widths), tuple(heights))


def width_em(text: str) -> float:
    return line_of(text, formula=1.0).width


def _number(value: float, digits: int) -> str:
    mantissa, _, exponent = with_comma(f"{value:.{digits}g}".replace("-", "−")).partition("e")
    return f"{mantissa}·10^{exponent.lstrip('+')}" if exponent else mantissa
