"""Matrices as displayed equations of LaTeX whose lines are not wider than a text.

The widths of TeX's letters are estimated, rather too large: nobody needs TeX to write an equation.
"""

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from app.lecture.copying import EVERY_DIGIT, latex_called, latex_name, latex_number
from app.lecture.equation import latex_cell
from app.lecture.letters import Letters
from app.lecture.notation import WrittenMatrix

TEXT_WIDTH_PT = 345.0  # of a line in LaTeX's classes, in 10 points
_SIZES = {
    "": (1.0, 1.0), r"\small": (0.93, 0.95), r"\footnotesize": (0.86, 0.92),
    r"\scriptsize": (0.81, 0.9), r"\tiny": (0.7, 0.87),
}  # fmt: skip
"""What a line keeps of its width, and what one with fractions or names does. TeX's smaller letters
are wider in proportion, the gaps between columns stay, and no index is smaller than 5 points."""
_SMALLEST = r"\tiny"
_EQUAL_PT, _INDENT_PT, _FURTHER_PT = 13.4, 10.0, 20.0
_COLUMN_PT, _BRACKETS_PT, _FRACTION_PT = 10.0, 18.0, 2.4
_READABLE = 1.16  # of a text's width: a wider product of formulas is left to its factors
_LETTER_PT, _CAPITAL_PT, _SCRIPT = 5.6, 9.5, 0.72
_PT = {
    **dict.fromkeys("0123456789/", 5.1), **dict.fromkeys("+-", 12.3), **dict.fromkeys("()", 3.9),
    **dict.fromkeys(".,|", 2.8), " ": 1.5, "=": _EQUAL_PT, r"\cdot": 7.3, r"\,": 1.7,
    **dict.fromkeys((r"\leftarrow", r"\to"), 15.6),
    **dict.fromkeys((r"\left", r"\right", r"\vec", r"\text", r"\mathrm"), 0.0),
    **dict.fromkeys((r"\tan", r"\sin", r"\cos", r"\cot"), 18.0),
}  # fmt: skip
_TOKEN = re.compile(r"\\[a-zA-Z]+|\\.|.", re.DOTALL)


class _ProductPart(NamedTuple):
    """A part of a product, and its width in points of a font of 10 points."""

    tex: str
    width: float


def displayed(
    matrix: WrittenMatrix,
    letters: Letters,
    symbols: bool = False,
    numbers: bool = True,
    digits: int = EVERY_DIGIT,
    text_pt: float = TEXT_WIDTH_PT,
) -> str:
    """Write a matrix as an equation (amsmath): its product, its factors, and the matrix.

    The factors and the matrix have formulas (`symbols`), `numbers` of so many `digits`, or both
    after each other. Letters are smaller where a line would be wider than the text; a comment says
    where the smallest ones are perhaps too wide.
    """
    name, *chain = (latex_called(matrix.called) or latex_name(matrix.name)).split(" = ")
    if not matrix.called:
        chain = [*map(latex_called, matrix.chain)]
    sides = [[_ProductPart(each, _width(each)) for each in chain]] if chain else []
    for wanted, formulas in ((symbols, True), (numbers, False)):
        for product in (matrix.factors, (matrix,)) if wanted else ():
            side = [_pmatrix(each, letters, formulas, digits) for each in product]
            is_product = formulas and bool(sides) and product is not matrix.factors
            is_left = is_product and side[0].width > _READABLE * text_pt
            if side and side not in sides and not is_left:
                sides.append(side)
    widest = max(part.width for side in sides for part in side)
    is_beside = _width(name) + _EQUAL_PT + max(widest, _INDENT_PT) <= text_pt
    begin = _width(name) if is_beside else _INDENT_PT

    def room(side: Sequence[_ProductPart], size: str) -> float:
        has_indices = any(r"\frac" in part.tex or r"\text" in part.tex for part in side)
        return text_pt / _SIZES[size][has_indices] - begin

    def fits(size: str) -> bool:
        return all(
            (_FURTHER_PT if number else _EQUAL_PT) + part.width <= room(side, size)
            for side in sides
            for number, part in enumerate(side)
        )

    size = next(filter(fits, _SIZES), _SMALLEST)
    lines = [line for side in sides for line in _lines(side, room(side, size))]
    first = f"{name} " if is_beside else f"&{name} \\\\\n"
    indent = "&" if is_beside else r"&\quad "
    body = first + " \\\\\n".join(indent + line for line in lines)
    equation = f"\\[\n\\begin{{aligned}}\n{body}\n\\end{{aligned}}\n\\]"
    if not fits(size):
        equation = f"% perhaps wider than {text_pt:.0f} pt\n{equation}"
    return f"{{{size}\n{equation}}}\n" if size else f"{equation}\n"


def _lines(side: Sequence[_ProductPart], room: float) -> Iterator[str]:
    """Yield the lines of a product, as many parts in each as there is room for."""
    line, width = "= ", _EQUAL_PT
    for number, part in enumerate(side):
        if number and width + part.width > room:
            yield line.rstrip()
            line, width = r"\qquad ", _FURTHER_PT
        line += f"{part.tex} "
        width += part.width
    yield line.rstrip()


def _pmatrix(matrix: WrittenMatrix, letters: Letters, formulas: bool, digits: int) -> _ProductPart:
    if formulas:
        cells = [[_small(latex_cell(cell, letters)) for cell in row] for row in matrix.formulas]
    else:
        cells = [[latex_number(value, digits) for value in row] for row in matrix.values]
    rows = [" & ".join(row) for row in cells]
    # Fractions that are above one another would touch.
    ends = [r" \\[2pt]" if "frac" in row else r" \\" for row in rows[:-1]] + [""]
    body = "\n".join(row + end for row, end in zip(rows, ends, strict=True))
    width = sum(max(map(_width, column)) + _COLUMN_PT for column in zip(*cells, strict=True))
    tex = f"\\begin{{pmatrix}}\n{body}\n\\end{{pmatrix}}"
    return _ProductPart(tex, width + _BRACKETS_PT - _COLUMN_PT)


def _small(tex: str) -> str:
    return tex.replace(r"\dfrac", r"\frac")


def _width(tex: str) -> float:
    return _of_group(iter(_TOKEN.findall(tex)))


def _of_group(tokens: Iterator[str]) -> float:
    """The width of the text before the next closing brace."""
    width = 0.0
    for token in tokens:
        if token == "}":
            break
        width += _of(token, tokens)
    return width


def _of(token: str, tokens: Iterator[str]) -> float:
    if token == "{":
        return _of_group(tokens)
    if token in ("_", "^"):
        return _SCRIPT * _of(next(tokens), tokens)
    if token == r"\frac":
        return _SCRIPT * max(_of(next(tokens), tokens) for _ in range(2)) + _FRACTION_PT
    return _PT.get(token, _CAPITAL_PT if token.isupper() or token in "mw" else _LETTER_PT)
