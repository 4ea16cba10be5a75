"""Equations are true as they are printed: what stands beside the sign of equality multiplies."""

import re
from dataclasses import replace
from functools import reduce
from itertools import product
from typing import Any

import numpy as np
import pytest

from app.lecture.equation import MOST_FACTORS, Equation, equation_of, latex_cell
from app.lecture.letters import LETTERS, Letters, latex_formula
from app.lecture.notation import matrices, steps_of_a_point
from app.lecture.paper import TEXT_WIDTH_PT, displayed
from app.model.chain import Chain, FiveTiles, lettered_kinds
from app.model.projection import Projection
from app.model.refusal import Refusal
from tests.lecture.test_notation import DEPTHS, letter_values, one, projection_of
from tests.support.lenses import LENSES, ONE_OF_EACH, free_matrix
from tests.support.printed import sides, value
from tests.support.samples import pairwise

PLACES = {
    "chain": Chain.read("rotate z 20; translate 1,2,3; shear xy 0.5; translate 0.5,0,1; mirror y"),
    "long": Chain.read("rotate 1,2,2 40; rotate x 3; scale 1,2,3; rotate 2,1,2 9; scale 3,2,1"),
    "typed": Chain.read("matrix 1,2,0,3 0,1,0.5,4 0,0,2,5 0,0,0,1; off mirror x; rotate z 30"),
    "": FiveTiles().chain,
    "trs": FiveTiles((1.0, 2.0, 3.0), (10.0, 20.0, 30.0), (1.0, 2.0, 3.0)).chain,
    "rts": FiveTiles((1.0, 2.0, 3.0), (10.0, 20.0, 30.0), (1.0, 2.0, 3.0), "rts").chain,
}
SAMPLE = pairwise(product((*LENSES, "matrix"), DEPTHS, LETTERS, (False, True), PLACES))


def shown(lens: str, depth: Any = "opengl", place: str = "") -> Projection:
    projection = projection_of("perspective" if lens == "matrix" else lens, depth)
    projection = replace(projection, placement=PLACES[place])
    return replace(projection, lens=free_matrix()) if lens == "matrix" else projection


def tex_values(projection: Projection, letters: Letters, rows: bool = False) -> dict[str, Any]:
    """The values of a lecture's letters, by their TeX."""
    values, chain = letter_values(projection, letters), projection.placement
    clip = one(matrices(projection, letters, rows=rows), "clip_from_view").values
    values |= {f"p_{i}{j}": clip[i - 1][j - 1] for i in range(1, 5) for j in range(1, 5)}
    whole = chain.matrix.T if rows else chain.matrix
    values |= {f"o_{i}{j}": whole[i - 1][j - 1] for i in range(1, 5) for j in range(1, 5)}
    for kind, tile in zip(lettered_kinds(chain.kinds), chain.on, strict=True):
        numbers = np.array(tile.numbers)
        if tile.kind == "rotate":
            numbers[:3] /= np.linalg.norm(numbers[:3])
        numbers[-1:] = np.radians(numbers[-1:]) if "rotate" in tile.kind else numbers[-1:]
        if rows and tile.kind == "matrix":
            numbers = numbers.reshape(4, 4).T.ravel()
            values |= {f"{kind.letters[0][:-2]}4{j}": numbers[11 + j] for j in (1, 2, 3)}
        values |= dict(zip(kind.letters, numbers, strict=False))
    return {
        latex_formula(name, letters): np.array(part)
        for name, part in values.items()
        if not callable(part)
    }


def assert_equal(parts: list[Any]) -> None:
    for part in parts:
        size = np.abs(parts[-1]).max()
        np.testing.assert_allclose(part, parts[-1], rtol=1e-12, atol=1e-13 * size)


@pytest.mark.parametrize(("lens", "depth", "letters", "rows", "place"), SAMPLE)
def test_matrices_in_latex(lens: str, depth: str, letters: Letters, rows: bool, place: str) -> None:
    """Each equation, and a product of names by the matrices that were printed under them."""
    projection = shown(lens, depth, place)
    values = tex_values(projection, letters, rows)
    for is_in_letters in (True, False):
        named, checked = dict[str, Any](), 0
        for matrix, width_pt in product(
            matrices(projection, letters, rows=rows, running=True), (TEXT_WIDTH_PT, 239.0)
        ):
            tex = displayed(
                matrix, letters, symbols=is_in_letters, numbers=not is_in_letters, text_pt=width_pt
            )
            assert r"\tiny" not in tex
            body = re.sub(r"(?m)^%.*|\\\w+\{aligned\}|\\\w*size|\\small", "", tex)
            (body,) = re.findall(r"\\\[(.*)\\\]", body, re.DOTALL)
            cells = re.findall(r"&?(\w_\{\d\d\}) &?= \\textstyle (.*?)(?: \\\\)?\n", body)
            given = {name: value(cell, values) for name, cell in cells}
            for name in given.keys() & values.keys():  # p_ij is no other cell
                assert given[name] == pytest.approx(values[name], rel=1e-12, abs=1e-13)
            body = re.sub(r"(?: \\\\)?\n&?\w_\{\d\d\} &?= \\textstyle .*", "", body)
            parts = sides(body, {**values, **given}, named)
            assert_equal(parts)
            checked += len(parts) > 2
        assert checked >= (2 if letters in ("000", "002", "003") or lens == "matrix" else 4)


def assert_true(found: Equation, projection: Projection) -> None:
    """Multiply the matrices of a slide in formulas, as they are written, and in numbers."""
    printed = []
    for term in found.terms:
        values = tex_values(projection, term.letters)
        printed.append(np.array(
            [[value(latex_cell(cell, term.letters), values) for cell in row]
             for row in term.matrix.formulas]
        ))  # fmt: skip
    assert len({term.letters for term in found.terms}) == 1
    assert_equal([np.linalg.multi_dot(printed[:-1]), printed[-1]])
    numbers = [np.array(term.matrix.values) for term in found.terms]
    assert_equal([np.linalg.multi_dot(numbers[:-1]), numbers[-1], printed[-1]])


@pytest.mark.parametrize("lens", ("infinite", *ONE_OF_EACH))
@pytest.mark.parametrize("letters", LETTERS)
def test_slides_of_equations(lens: str, letters: Letters) -> None:
    """The products that are printed elsewhere, and words of two lectures."""
    projection = shown(lens)
    products = [each for each in matrices(projection, letters) if each.product or each.factors]
    texts = {each.called.split(" = ")[-1] for each in products}
    texts |= {" ".join(each.product) for each in products}
    texts |= {"frustum view", "frustum frustum", "M P", "R P", "M_z clip_from_view"}
    for text in sorted(text for text in texts if 2 <= len(text.split()) <= MOST_FACTORS):
        found = equation_of(projection, letters, text)
        assert_true(found, projection)
        numbers = equation_of(projection, letters, f"{text} numbers").result
        assert numbers is not None and found.result is not None
        assert numbers.matrix.values == found.result.matrix.values


@pytest.mark.parametrize("letters", LETTERS)
@pytest.mark.parametrize("lens", ("infinite", *ONE_OF_EACH))
def test_the_chain_of_a_point(lens: str, letters: Letters) -> None:
    """The Probe panel's `clip` of p_view, and w, in the numbers that the command prints."""
    projection = shown(lens)
    named = {f"{name}": np.array(matrix.values) for matrix in matrices(projection, letters)
             for name in [matrix.called.split(" = ")[0]] if name}  # fmt: skip
    steps = steps_of_a_point(projection, letters)
    view = np.array([1.0, -2.0, -7.0, 1.0])
    letter = dict(zip("nf", map(np.array, projection.lens.planes or ()), strict=False))
    names = steps["clip"].removesuffix(" p_view")
    clip = one(matrices(projection, letters), "clip_from_view").values @ view
    if all(name in named or name in letter for name in names.split(" ")):
        chain = [{**letter, **named}[name] for name in names.split(" ")]
        np.testing.assert_allclose(reduce(np.dot, [*chain, view]), clip, rtol=1e-13, atol=1e-13)
    else:
        assert names == "P"
    assert clip[3] == {"\u2212z_view": 7.0, "z_view": -7.0, "1": 1.0}[steps["w"]]


def test_a_long_product_is_shown_in_numbers() -> None:
    """Lecture 003's whole chain of an object that was turned has no formulas for a slide."""
    projection = shown("frustum", place="trs")
    chain = "M_projection M_W\u2192E M_O\u2192W"
    with pytest.raises(Refusal, match="at most 400 characters, or end in numbers"):
        equation_of(projection, "003", chain)
    found = equation_of(projection, "003", f"{chain} numbers")
    parts = [np.array(term.matrix.values) for term in found.terms]
    assert_equal([np.linalg.multi_dot(parts[:-1]), parts[-1]])
    assert found.result is not None
    assert {"rotate_deg", "near", "eye"} <= set(found.result.matrix.fields[2][0])


def test_matrices_of_two_lectures_are_refused_if_none_has_both() -> None:
    with pytest.raises(Refusal, match="must name matrices that one lecture has together"):
        equation_of(shown("oblique"), "own", "H M_z")
