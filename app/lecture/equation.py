"""An equation of matrices for a slide: one matrix by its name, or a product and its result.

::

    "frustum"            M = [...]
    "M_z M_pp M_persp"   [...] [...] [...] = [...]
    "plane, d-plane"     [...] , [...]           beside each other, no product
    "view numbers"       the same matrix in numbers

A word is one of `USUAL`, a lecture's own name of a matrix or a factor (``M_persp``, ``R``), or a
name that `python -m app matrices` prints. The chosen lecture's names come first.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from app.arithmetic.rationals import product
from app.lecture.algebra import Ratio, ratio
from app.lecture.dependence import reach, state_of
from app.lecture.notation import (
    LETTERS,
    Formulas,
    Letters,
    Matrix,
    latex_called,
    latex_formula,
    matrices,
    names_of,
)
from app.model.formula import parse
from app.model.object_transform import FROM_OBJECT
from app.model.projection import Projection
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal

USUAL = {
    "object": FROM_OBJECT,
    "view": "view_from_world",
    "frustum": "clip_from_view",
    "projection": "clip_from_view",
    "viewport": "image_from_ndc",
}
_PLANE = "distance"
"""The setting of the scenes that project onto a plane at this distance."""
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
NUMBERS = "numbers"
"""The last word of an equation whose cells are numbers."""
MOST_FACTORS = 4
SOME_MATRICES = QT_TRANSLATE_NOOP(
    "Refusal", "must name 1 to {0} matrices, such as {1}; this lens has no matrix {2}"
)


class Term(NamedTuple):
    """A matrix of an equation; `name` is TeX, or empty; `letters` are those of its formulas."""

    matrix: Matrix
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
        raise _refused(text, text)
    distance = (settings or {}).get(_PLANE)
    keys, terms = [], []
    for word in words:
        if word in ONTO_PLANE and isinstance(distance, float) and distance:
            found = word, _onto_plane(word, distance, letters)
        else:
            first = next(_found(projection, letters, word), None)
            if first is None:
                raise _refused(text, word)
            found = first
        keys.append(found[0])
        terms.append(found[1])
    if len(terms) == 1:
        name = terms[0].name or "M"
        return Equation((), terms[0]._replace(name=name), is_in_numbers)
    result = None if "," in text else _result(projection, keys, terms)
    return Equation(tuple(terms), result, is_in_numbers)


def _onto_plane(word: str, distance: float, letters: Letters) -> Term:
    name, formulas = ONTO_PLANE[word]
    values = {"0": 0.0, "1": 1.0, "-1": -1.0, "d": distance, "-1/d": -1.0 / distance}
    numbers = tuple(tuple(values[cell] for cell in row) for row in formulas)
    path = (f"settings.{_PLANE}",)
    fields = tuple(tuple(path if "d" in cell else () for cell in row) for row in formulas)
    return Term(Matrix(word, numbers, formulas, fields), letters, name)


def _refused(text: str, word: str) -> Refusal:
    return Refusal("equation", text, SOME_MATRICES, MOST_FACTORS, ", ".join(USUAL), repr(word))


def _found(projection: Projection, letters: Letters, word: str) -> Iterator[tuple[str, Term]]:
    """Yield the matrices of a name, each with its key, those of the chosen lecture first."""
    lectures = (letters, *(each for each in LETTERS if each != letters))
    for lecture in lectures:
        names = names_of(projection, lecture)
        by_key = dict(_by_key(projection, lecture))
        wanted = USUAL.get(word, word)
        for key, matrix in by_key.items():
            called = names.get(key, "")
            if word == called or wanted in (key, key.partition("/")[2]):
                yield key, Term(matrix, lecture, latex_called(called))


def _by_key(projection: Projection, letters: Letters) -> Iterator[tuple[str, Matrix]]:
    for matrix in matrices(projection, letters):
        yield matrix.name, matrix
        for factor in matrix.factors:
            yield f"{matrix.name}/{factor.name}", factor


def _result(projection: Projection, keys: list[str], terms: list[Term]) -> Term:
    """Return the program's own matrix for a product, or the product."""
    letters = terms[0].letters
    for matrix in matrices(projection, letters):
        of_factors = [f"{matrix.name}/{factor.name}" for factor in matrix.factors]
        if keys in (list(matrix.product), of_factors):
            return Term(matrix, letters)
    values = np.array(terms[0].matrix.values)
    cells = _cells(terms[0])
    for right in terms[1:]:
        values = values @ np.array(right.matrix.values)
        cells = product(cells, _cells(right))
    formulas = tuple(tuple(cell.text for cell in row) for row in cells)
    state = state_of(projection)
    fields = tuple(tuple(reach(cell, state).fields for cell in row) for row in formulas)
    rows = tuple(map(tuple, (values + 0.0).tolist()))
    return Term(Matrix("product", rows, formulas, fields), letters)


def _cells(term: Term) -> list[list[Ratio]]:
    return [[ratio(parse(cell)) for cell in row] for row in term.matrix.formulas]


def latex_cell(formula: str, letters: Letters) -> str:
    """Write a cell's formula in TeX: a fraction is large, and a minus stands before it."""
    tex = latex_formula(formula, letters)
    if re.match(r"-?\\frac", tex):
        tex = tex.replace("\\frac", "\\dfrac", 1)
    found = re.fullmatch(r"\\dfrac\{-((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}(\{.*\})", tex)
    if found is None or re.search("[+-]", re.sub(r"\([^()]*\)|\{[^{}]*\}", "", found[1])):
        return tex
    return rf"-\dfrac{{{found[1]}}}{found[2]}"
