"""Matrices as displayed equations of LaTeX whose lines are not wider than a text.

The widths of TeX's letters are estimated, rather too large: nobody needs TeX to write an equation.
"""

import itertools
import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from app.lecture.copying import EVERY_DIGIT, latex_called, latex_name, latex_number
from app.lecture.equation import latex_cell
from app.lecture.letters import Letters
from app.lecture.notation import WrittenMatrix

TEXT_WIDTH_PT = 345.0  # of a line in LaTeX's classes, in 10 points
_SIZES = {"": (1.0, 1.0), r"\small": (0.93, 0.95), r"\footnotesize": (0.86, 0.92)}
"""What a line keeps of its width, and what one with fractions or names does. TeX's smaller letters
are wider in proportion, the gaps between columns stay, and no index is smaller than 5 points."""
_SMALLEST = r"\footnotesize"
_NAMES = "pckqdrwyzABCDEFGHKLNQ"  # letters for cells that are named and given below
_EQUAL_PT, _INDENT_PT, _FURTHER_PT = 13.4, 10.0, 20.0
_COLUMN_PT, _BRACKETS_PT, _FRACTION_PT = 10.0, 18.0, 2.4
_ALIGNED_PT = 10.0  # of aligned, after its lines
_READABLE = 1.16  # of a text's width: a wider product of formulas is left to its factors
_LETTER_PT, _CAPITAL_PT, _SCRIPT = 5.6, 9.5, 0.72
_PT = {
    **dict.fromkeys("0123456789", 5.1), **dict.fromkeys("+-", 12.3), **dict.fromkeys("()", 3.9),
    "/": 7.2,
    **dict.fromkeys(".,|", 2.8), " ": 1.5, "=": _EQUAL_PT, r"\cdot": 7.3, r"\,": 1.7,
    **dict.fromkeys((r"\leftarrow", r"\to"), 15.6),
    **dict.fromkeys((r"\vec", r"\text", r"\mathrm"), 0.0), r"\left": 4.4, r"\right": 4.4,
    **dict.fromkeys((r"\tan", r"\sin", r"\cos", r"\cot"), 18.0),
}  # fmt: skip
_TOKEN = re.compile(r"\\[a-zA-Z]+|\\.|.", re.DOTALL)


class _ProductPart(NamedTuple):
    """A part of a product, and its width in points of a font of 10 points."""

    tex: str
    width: float
    cells: Sequence[Sequence[str]] = ()


def displayed(
    matrix: WrittenMatrix,
    letters: Letters,
    symbols: bool = False,
    numbers: bool = True,
    digits: int = EVERY_DIGIT,
    text_pt: float = TEXT_WIDTH_PT,
    clip: str = "",
) -> str:
    """Write a matrix as an equation (amsmath): its product, its factors, and the matrix.

    The factors and the matrix have formulas (`symbols`), `numbers` of so many `digits`, or both
    after each other. Letters are smaller where a line would be wider than the text. The widest
    cells of a matrix that is still too wide have names, and are given below it; a comment says
    where one of them is perhaps too wide. `clip` is the name in LaTeX of the matrix whose cells
    are p_ij.
    """
    name, *chain = (latex_called(matrix.called) or latex_name(matrix.name)).split(" = ")
    if not chain and " " not in matrix.called:
        chain = [*map(latex_called, matrix.chain)]
    sides = [[_ProductPart(each, _width(each)) for each in chain]] if chain else []
    for wanted, formulas in ((symbols, True), (numbers, False)):
        for product in (matrix.factors, (matrix,)) if wanted else ():
            if formulas and not all(each.formulas for each in product):
                continue  # a result that is too long for formulas
            side = [_pmatrix(_cells_of(each, letters, formulas, digits)) for each in product]
            is_product = formulas and bool(sides) and product is not matrix.factors
            is_left = is_product and side[0].width > _READABLE * text_pt
            if side and side not in sides and not is_left:
                sides.append(side)
    free_pt = text_pt - _ALIGNED_PT
    widest = max(part.width for side in sides for part in side)
    is_beside = _width(name) + _EQUAL_PT + max(widest, _INDENT_PT) <= free_pt
    is_beside |= _width(name) <= 2.0 * _INDENT_PT
    begin = _width(name) if is_beside else _INDENT_PT

    def room(parts: Sequence[_ProductPart], size: str) -> float:
        has_indices = any(r"\frac" in part.tex or r"\text" in part.tex for part in parts)
        return free_pt / _SIZES[size][has_indices] - begin

    def fits(size: str) -> bool:
        return all(
            (_FURTHER_PT if number else _EQUAL_PT) + part.width <= room(side, size)
            for side in sides
            for number, part in enumerate(side)
        )

    size, below = next(filter(fits, _SIZES), _SMALLEST), list[_ProductPart]()
    if clip and any("p_{" in part.tex for side in sides for part in side):
        below.append(_ProductPart(f"(p_{{ij}}) &= {clip}", 0.0))
    for side in sides:
        for number, part in enumerate(side):
            most = room(side, size) - (_FURTHER_PT if number else _EQUAL_PT)
            if part.cells and part.width > most:
                used = "".join(each.tex for each in itertools.chain(*sides, below))
                is_clip = matrix.name == "clip_from_view"
                letter = next(each for each in _NAMES[not is_clip :] if f"{each}_{{" not in used)
                side[number], named = _with_names(part, letter, most)
                below += named
    lines = [line for side in sides for line in _lines(side, room(side, size))]
    given = [each.tex if is_beside else f"&{each.tex.replace('&', '', 1)}" for each in below]
    first = f"{name} " if is_beside else f"&{name} \\\\\n"
    indent = "&" if is_beside else r"&\quad "
    body = first + " \\\\\n".join([*(indent + line for line in lines), *given])
    equation = f"\\[\n\\begin{{aligned}}\n{body}\n\\end{{aligned}}\n\\]"
    if any(each.width > room([each], size) for each in below):
        equation = f"% perhaps wider than {text_pt:.0f} pt\n{equation}"
    return f"{{{size}\n{equation}}}\n" if size else f"{equation}\n"


def _with_names(
    part: _ProductPart, letter: str, most: float
) -> tuple[_ProductPart, list[_ProductPart]]:
    """Name the widest cells of a matrix until it is narrow enough; return it and what they are."""
    cells, given = [list(row) for row in part.cells], dict[tuple[int, int], _ProductPart]()
    while part.width > most:
        widths = {(i, j): _width(cells[i][j]) for i in range(4) for j in range(4)}
        (i, j) = max(widths.keys() - given.keys(), key=lambda place: (widths[place], place))
        name, tex = f"{letter}_{{{i + 1}{j + 1}}}", cells[i][j]
        given[i, j] = _ProductPart(
            f"{name} &= \\textstyle {tex}", _width(name) + _EQUAL_PT + _width(tex)
        )
        cells[i][j] = name
        part = _pmatrix(cells)
        if len(given) == 16:
            break
    return part, [given[place] for place in sorted(given)]


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


def _cells_of(
    matrix: WrittenMatrix, letters: Letters, formulas: bool, digits: int
) -> list[list[str]]:
    if formulas:
        return [[_small(latex_cell(cell, letters)) for cell in row] for row in matrix.formulas]
    return [[latex_number(value, digits) for value in row] for row in matrix.values]


def _pmatrix(cells: Sequence[Sequence[str]]) -> _ProductPart:
    rows = [" & ".join(row) for row in cells]
    # Fractions that are above one another would touch.
    ends = [r" \\[2pt]" if "frac" in row else r" \\" for row in rows[:-1]] + [""]
    body = "\n".join(row + end for row, end in zip(rows, ends, strict=True))
    width = sum(max(map(_width, column)) + _COLUMN_PT for column in zip(*cells, strict=True))
    tex = f"\\begin{{pmatrix}}\n{body}\n\\end{{pmatrix}}"
    return _ProductPart(tex, width + _BRACKETS_PT - _COLUMN_PT, cells)


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
