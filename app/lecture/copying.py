"""Matrices as text to copy: aligned columns, a Python statement, a displayed equation of LaTeX."""

import re

from app.lecture.letters import Letters, latex_formula, written
from app.lecture.notation import WrittenMatrix
from app.model.formula import ARROW
from app.model.refusal import format_value

EVERY_DIGIT = 17  # as many significant digits tell every number of float64 from its neighbours


def as_text(matrix: WrittenMatrix, letters: Letters = "own", *, formulas: bool = False) -> str:
    """Write the matrix as aligned columns of numbers or formulas under its name."""
    cells = (
        [[written(cell, letters) for cell in row] for row in matrix.formulas]
        if formulas
        else [[format_value(value) for value in row] for row in matrix.values]
    )
    widths = [max(map(_places, column)) for column in zip(*cells, strict=True)]
    lines = [_title(matrix)]
    for row in cells:
        padded = (" " * (w - _places(cell)) + cell for cell, w in zip(row, widths, strict=True))
        lines.append("  ".join(["", *padded]))
    return "\n".join(lines) + "\n"


def _places(text: str) -> int:
    """Return the width of a text in letters; an arrow stands above a letter."""
    return len(text) - text.count(ARROW)


def as_numpy(matrix: WrittenMatrix) -> str:
    """Write the matrix as a Python statement, with ``np`` for NumPy."""
    rows = ",\n".join(f"    [{', '.join(map(repr, row))}]" for row in matrix.values)
    called = f"  # {matrix.called}" if matrix.called else ""
    return f"{matrix.name} = np.array([{called}\n{rows},\n])\n"


def as_latex(matrix: WrittenMatrix, letters: Letters, *, formulas: bool = False) -> str:
    """Write the matrix as a displayed equation with a pmatrix (amsmath)."""
    cells = (
        [[latex_formula(cell, letters) for cell in row] for row in matrix.formulas]
        if formulas
        else [[latex_number(value) for value in row] for row in matrix.values]
    )
    body = " \\\\\n".join(" & ".join(row) for row in cells)
    name = latex_called(matrix.called) or latex_name(matrix.name)
    return f"\\[\n{name} = \\begin{{pmatrix}}\n{body}\n\\end{{pmatrix}}\n\\]\n"


def latex_called(called: str) -> str:
    """Write a lecture's name of a matrix in LaTeX: ``P_{\\mathrm{obl}} = P_{\\mathrm{ort}} H``."""
    if "_from_" in called:
        return latex_name(called)
    called = re.sub(r"(?<!\S)[A-Za-z]{2,}(?![^\s_])", r"\\mathrm{\g<0>}", called)
    return re.sub(r"_(\S+)", r"_{\\mathrm{\1}}", called).replace("\u2192", r"\to ")


def _title(matrix: WrittenMatrix) -> str:
    if matrix.called:
        return f"{matrix.name} = {matrix.called}"
    names = matrix.product or tuple(factor.name for factor in matrix.factors)
    return f"{matrix.name} = {' '.join(names)}" if names else matrix.name


def latex_name(name: str) -> str:
    """Write ``M`` with the spaces of a matrix, or the name of a factor, as its index."""
    target, between, source = (part.replace("_", " ") for part in name.partition("_from_"))
    if not between:
        return rf"M_{{\text{{{target}}}}}"
    return rf"M_{{\text{{{target}}}\leftarrow\text{{{source}}}}}"


def latex_number(value: float, digits: int = EVERY_DIGIT) -> str:
    """Write a number with so many digits, and its exponent as a power of ten."""
    text = format_value(value) if digits == EVERY_DIGIT else f"{value:.{digits}g}"
    mantissa, e, exponent = text.partition("e")
    return rf"{mantissa} \cdot 10^{{{int(exponent)}}}" if e else mantissa
