"""An equation of matrices for a slide: one matrix by its name, or a product and its result.

::

    "frustum"            M = [...]
    "M_z M_pp M_persp"   [...] [...] [...] = [...]
    "plane, d-plane"     [...] , [...]           beside each other, no product
    "view numbers"       the same matrix in numbers

A word is one of `USUAL`, a lecture's own name of a matrix or a factor (``M_persp``, ``R``), or a
name that `python -m app matrices` prints. The chosen lecture's names come first. All matrices have
the letters and signs of one lecture; else their product would not be the product of what is shown.
"""

import itertools
import re
from collections.abc import Mapping, Sequence
from functools import lru_cache, reduce
from typing import Any, NamedTuple

import numpy as np

from app.arithmetic.rationals import product
from app.lecture.algebra import Ratio, ratio
from app.lecture.copying import latex_called
from app.lecture.letters import LETTERS, Letters, latex_formula
from app.lecture.notation import Formulas, WrittenMatrix, matrices, names_of
from app.model.chain import FROM_OBJECT
from app.model.formula import LONGEST, parse
from app.model.projection import Projection
from app.model.refusal import REFUSALS, Refusal

USUAL = {
    "object": FROM_OBJECT,
    "view": "view_from_world",
    "frustum": "clip_from_view",
    "projection": "clip_from_view",
    "viewport": "image_from_ndc",
}
_PLANE = "distance"  # the setting of the scenes that project onto a plane at this distance
ONTO_PLANE: dict[str, tuple[str, Formulas]] = {
    "plane": (
        "A",
        (("1", "0", "0", "0"), ("0", "1", "0", "0"), ("0", "0", "1", "0"), ("0", "0", "-1/d", "0")),
    ),
    "d-plane": (
        r"d\,A",
        (("d", "0", "0", "0"), ("0", "d", "0", "0"), ("0", "0", "d", "0"), ("0", "0", "-1", "0")),
    ),
}
"""The projection onto a plane at the distance d, and the same times d: names and cells."""
NUMBERS = "numbers"  # the last word of an equation whose cells are numbers
MOST_FACTORS = 4


class Term(NamedTuple):
    """A matrix of an equation; `name` is TeX, or empty; `letters` are those of its formulas."""

    matrix: WrittenMatrix
    letters: Letters
    name: str = ""


class Equation(NamedTuple):
    """A product and its result; one matrix, which has no `factors`; or several without result."""

    factors: tuple[Term, ...]
    result: Term | None
    is_in_numbers: bool

    @property
    def terms(self) -> tuple[Term, ...]:
        """The matrices from left to right."""
        return self.factors if self.result is None else (*self.factors, self.result)


def equation_of(
    projection: Projection,
    letters: Letters,
    text: str,
    settings: Mapping[str, object] | None = None,
) -> Equation:
    """Return the equation that a text asks for; a `Refusal` names what this lens lacks.

    `settings` are those of the scene.
    """
    words = text.replace(",", " ").split()
    is_in_numbers = words[-1:] == [NUMBERS]
    words = words[:-1] if is_in_numbers else words
    if not 1 <= len(words) <= MOST_FACTORS:
        raise Refusal("equation", text, REFUSALS["some-matrices"], MOST_FACTORS, ", ".join(USUAL))
    distance: Any = (settings or {}).get(_PLANE)
    planes = ONTO_PLANE if isinstance(distance, float) and distance else {}
    term_of = _terms_of(projection, letters, [word for word in words if word not in planes])
    lecture = next((term.letters for term in term_of.values()), letters)
    term_of |= {word: _onto_plane(word, distance, lecture) for word in planes}
    missing = [word for word in words if word not in term_of]
    if missing:
        raise Refusal("equation", text, REFUSALS["no-matrix"], ", ".join(USUAL), repr(missing[0]))
    terms = [term_of[word] for word in words]
    if len(terms) == 1:
        return Equation((), terms[0]._replace(name=terms[0].name or "M"), is_in_numbers)
    result = None
    if "," not in text:
        result = _own_result(projection, terms) or _result(terms, text, is_in_numbers)
    return Equation(tuple(terms), result, is_in_numbers)


def _onto_plane(word: str, distance: float, letters: Letters) -> Term:
    name, formulas = ONTO_PLANE[word]
    values = {"0": 0.0, "1": 1.0, "-1": -1.0, "d": distance, "-1/d": -1.0 / distance}
    numbers = tuple(tuple(values[cell] for cell in row) for row in formulas)
    path = (f"settings.{_PLANE}",)
    fields = tuple(tuple(path if "d" in cell else () for cell in row) for row in formulas)
    return Term(WrittenMatrix(word, numbers, formulas, fields), letters, name)


def _terms_of(projection: Projection, letters: Letters, words: Sequence[str]) -> dict[str, Term]:
    """Return the matrices of words in the letters of one lecture, the chosen one if it has all.

    Words of several lectures are the matrices of the first lecture that has them, whatever it calls
    them. A word that no lecture has is missing.
    """
    lectures = (letters, *(each for each in LETTERS if each != letters))
    called = dict[str, tuple[str, str]]()
    for lecture in lectures:
        named = _named(projection, lecture, words)
        if len(named) == len(set(words)):
            return _terms(projection, lecture, named)
        called = named | called
    for lecture in lectures:
        if {key for key, _ in called.values()} <= _by_key(projection, lecture).keys():
            return _terms(projection, lecture, called)
    raise Refusal("equation", " ".join(words), REFUSALS["of-one-lecture"])


def _terms(
    projection: Projection, letters: Letters, called: Mapping[str, tuple[str, str]]
) -> dict[str, Term]:
    by_key = _by_key(projection, letters)
    return {word: Term(by_key[key], letters, name) for word, (key, name) in called.items()}


def _named(
    projection: Projection, letters: Letters, words: Sequence[str]
) -> dict[str, tuple[str, str]]:
    """Return the keys of those words that a lecture has, and the names of their matrices."""
    names, symbols = names_of(projection, letters), dict[str, tuple[str, str]]()
    for word, key in itertools.product(words, _by_key(projection, letters)):
        called = names.get(key, "")
        own = (key, key.partition("/")[2])
        if word in (called, called.removesuffix(" I")) or USUAL.get(word, word) in own:
            symbols.setdefault(word, (key, latex_called(called)))
    return symbols


@lru_cache(maxsize=len(LETTERS))
def _by_key(projection: Projection, letters: Letters) -> Mapping[str, WrittenMatrix]:
    """Return the matrices by their names, and their factors by ``matrix/factor``."""
    by_key = dict[str, WrittenMatrix]()
    for matrix in matrices(projection, letters):
        by_key[matrix.name] = matrix
        by_key |= {f"{matrix.name}/{factor.name}": factor for factor in matrix.factors}
    return by_key


def _own_result(projection: Projection, terms: Sequence[Term]) -> Term | None:
    """Return the program's own matrix for a product, if it has one."""
    letters, factors = terms[0].letters, [term.matrix for term in terms]
    by_key = _by_key(projection, letters)
    for matrix in by_key.values():
        if factors in ([by_key[name] for name in matrix.product], [*matrix.factors]):
            return Term(matrix, letters)
    return None


def _result(terms: Sequence[Term], text: str, is_in_numbers: bool) -> Term:
    """Return a product: each cell as one quotient, or as a letter that stands for its number."""
    whole = reduce(_multiplied, (term.matrix for term in terms))
    if is_in_numbers:
        return Term(whole, terms[0].letters)
    cells = reduce(product, map(_cells, terms))
    formulas = tuple(tuple(cell.text for cell in row) for row in cells)
    if max(len(cell) for row in formulas for cell in row) > LONGEST:
        raise Refusal("equation", text, REFUSALS["shorter"], LONGEST, NUMBERS)
    return Term(whole._replace(formulas=formulas), terms[0].letters)


def _multiplied(left: WrittenMatrix, right: WrittenMatrix) -> WrittenMatrix:
    """Return a product in numbers; all that changes a cell of a sum changes the sum."""
    cells = [[k for k in range(4) if "0" not in (left.formulas[i][k], right.formulas[k][j])]
             for i in range(4) for j in range(4)]  # fmt: skip
    formulas = [f"m_{n // 4 + 1}{n % 4 + 1}" if terms else "0" for n, terms in enumerate(cells)]
    fields = [
        tuple(dict.fromkeys(
            name for k in terms for name in left.fields[n // 4][k] + right.fields[k][n % 4]
        ))
        for n, terms in enumerate(cells)
    ]  # fmt: skip
    numbers = (np.array(left.values) @ np.array(right.values) + 0.0).ravel().tolist()
    return WrittenMatrix("product", *map(_in_rows, (numbers, formulas, fields)))


def _in_rows(cells: Sequence[Any]) -> Any:
    return tuple(tuple(cells[start : start + 4]) for start in range(0, 16, 4))


def _cells(term: Term) -> list[list[Ratio]]:
    return [[ratio(parse(cell)) for cell in row] for row in term.matrix.formulas]


_HALF = re.compile(r"\\left\(\\frac\{((?:[^{}]|\{[^{}]*\})*)\}\{(\w+)\}\\right\)")


def latex_cell(formula: str, letters: Letters) -> str:
    """Write a cell's formula in TeX: a fraction is large, and a minus stands before it.

    A fraction inside a function is on the line, or its letters would be tiny.
    """
    tex = _HALF.sub(r"(\1/\2)", latex_formula(formula, letters))
    if re.match(r"-?\\frac", tex):
        tex = tex.replace("\\frac", "\\dfrac", 1)
    match = re.fullmatch(r"\\dfrac\{-((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}(\{.*\})", tex)
    if match is None or re.search("[+-]", re.sub(r"\([^()]*\)|\{[^{}]*\}", "", match[1])):
        return tex
    return rf"-\dfrac{{{match[1]}}}{match[2]}"
