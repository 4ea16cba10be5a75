"""Tables: the steps of a projection as matrices of formulas, and the steps that all lenses share.

A step's matrix is stated once, on the page ``content/matrices.md`` as the lectures write it, and
evaluated in rationals (the numbers shown), in letters (the formulas shown) and in float64.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

from app.arithmetic.rationals import Rationals, eliminate
from app.model.formula import EXACT, Arithmetic, Formula, parse
from app.model.limits import Array, read_only
from app.model.parameter import read_sections
from app.model.refusal import QT_TRANSLATE_NOOP, REFUSALS, Refusal

_PAGE = read_sections(Path(__file__).with_name("content") / "matrices.md")

Table: TypeAlias = tuple[tuple[Formula, ...], ...]  # a (4, 4) matrix of formulas


def matrix(text: str, **parts: str) -> Table:
    """A matrix of formulas, one row a line, with two or more spaces between the formulas.

    `parts` are formulas that replace letters.
    """
    terms = {letter: parse(formula) for letter, formula in parts.items()}
    rows = tuple(
        tuple(parse(cell.strip()).where(terms) for cell in line.strip().split("  ") if cell.strip())
        for line in text.strip().splitlines()
    )
    assert [len(row) for row in rows] == [4, 4, 4, 4], text
    return rows


def rows_of(name: str) -> str:
    """The rows of a matrix on the page, below this heading."""
    return "\n".join(line for line in _PAGE[name].text if line.startswith(" "))


def matrix_of(name: str, **parts: str) -> Table:
    """The matrix on the page below this heading; `parts` as of `matrix`."""
    return matrix(rows_of(name), **parts)


def formulas_of(name: str) -> dict[str, str]:
    """The formulas that the page lists below this heading."""
    return _PAGE[name].named


def evaluated(table: Table, known: Mapping[str, Any], arithmetic: Arithmetic = EXACT) -> list[Any]:
    """The values of a table, row by row; `known` as in `Formula.value`."""
    numbers = iter([cell.evaluate(known, arithmetic) for row in table for cell in row])
    return list(map(list, zip(*[numbers] * 4, strict=True)))


def rounded(matrix: Rationals) -> Array:
    """A matrix of rationals in float64, every number rounded once."""
    return read_only([[float(part) for part in row] for row in matrix])


def inverse(field: str, matrix: Rationals) -> Rationals:
    """The inverse of a matrix of rationals, or a `Refusal` that names the field."""
    rank, _, inverted = eliminate(matrix)
    if inverted is None:
        raise Refusal(
            field, tuple(map(tuple, rounded(matrix).tolist())), REFUSALS["invertible"], rank
        )
    return inverted


class PipelineStep(NamedTuple):
    """One step of the pipeline as the lectures write it; compare `app.model.pipeline.Stage`.

    The step is the product of the named `factors`, in order; without factors it is the identity.
    The `note` is marked for translation.
    """

    name: str
    factors: tuple[tuple[str, Table], ...] = ()
    note: str = ""


NO_M_PP = QT_TRANSLATE_NOOP("Stage", "a parallel lens has no M_pp: this is the identity")
SCALED_BY_NEAR = QT_TRANSLATE_NOOP(
    "Stage", "far is infinite: the canonical pyramid is scaled by near, which is at z = -1"
)


def _step(name: str, of: str, *factors: str) -> PipelineStep:
    return PipelineStep(name, tuple((each, matrix_of(f"{of} {each}")) for each in factors))


TO_PYRAMID = "canonical_perspective_from_view"
"""The name of the first step of a lens whose projectors meet in the eye."""

DEPTH_RANGE = _step("depth_range_from_canonical_parallel", "depth range", "translation", "scale")
VIEWPORT = _step("image_from_ndc", "viewport", "scale", "translation")
