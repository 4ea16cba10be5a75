"""Equations of slides: the matrices that a text names, their product, and what a lens lacks."""

import numpy as np
import pytest

from app.lecture.equation import equation_of, latex_cell
from app.lecture.letters import Letters
from app.model.projection import Orthographic, Perspective, Projection
from app.model.refusal import Refusal

SEEN = Projection(lens=Perspective(50.0, 2.0, 9.0))


def test_one_matrix_has_the_lectures_name() -> None:
    found = equation_of(SEEN, "003", "frustum")
    assert not found.factors and found.result is not None
    assert found.result.name == r"M_{\mathrm{projection}}"
    np.testing.assert_array_equal(found.result.matrix.values, SEEN.clip_from_view)
    assert equation_of(SEEN, "own", "view").terms[0].name == "M"


@pytest.mark.parametrize(
    ("letters", "text"), [("001", "M_z M_pp M_persp"), ("004", "R P"), ("own", "frustum view")]
)
def test_the_result_is_the_product_of_the_factors(letters: Letters, text: str) -> None:
    found = equation_of(SEEN, letters, text)
    assert len(found.factors) == len(text.split())
    product = np.eye(4)
    for term in found.factors:
        product = product @ np.array(term.matrix.values)
    assert found.result is not None
    np.testing.assert_allclose(found.result.matrix.values, product, rtol=1e-12, atol=1e-12)


def test_the_formulas_of_a_product_are_reduced() -> None:
    found = equation_of(SEEN, "001", "M_z M_pp M_persp")
    assert found.result is not None
    cells = found.result.matrix.formulas
    assert latex_cell(cells[2][2], "001") == r"-\dfrac{f + n}{f \, (f - n)}"
    assert latex_cell(cells[2][3], "001") == r"-\dfrac{2n}{f - n}"
    assert latex_cell(cells[3][2], "001") == r"-\dfrac{1}{f}"
    near = [
        (i, j) for i in range(4) for j in range(4) if "near" in found.result.matrix.fields[i][j]
    ]
    assert near == [(2, 2), (2, 3)]


def test_numbers_are_asked_for_by_a_word() -> None:
    assert equation_of(SEEN, "own", "view numbers").is_in_numbers
    assert not equation_of(SEEN, "own", "view").is_in_numbers


@pytest.mark.parametrize("text", ["", "numbers", "view view view view view"])
def test_no_and_too_many_matrices_are_refused(text: str) -> None:
    with pytest.raises(Refusal, match=r"must name 1 to 4 matrices, such as [^;]+$"):
        equation_of(SEEN, "own", text)


def test_an_unknown_matrix_is_refused_by_its_name() -> None:
    with pytest.raises(Refusal, match="this lens has no matrix 'frus'"):
        equation_of(SEEN, "own", "view frus")


def test_a_lens_without_the_matrix_is_named() -> None:
    flat = Projection(lens=Orthographic(-1.0, 1.0, -1.0, 1.0, 1.0, 9.0))
    with pytest.raises(Refusal, match="this lens has no matrix 'M_persp'"):
        equation_of(flat, "001", "M_persp")


def test_matrices_beside_each_other_have_no_result() -> None:
    found = equation_of(SEEN, "000", "plane, d-plane", {"distance": 4.0})
    assert found.result is None and [term.name for term in found.terms] == ["A", r"d\,A"]
    first, second = (np.array(term.matrix.values) for term in found.terms)
    np.testing.assert_allclose(second, 4.0 * first)
    assert first[3, 2] == -0.25
    with pytest.raises(Refusal, match="has no matrix 'plane'"):
        equation_of(SEEN, "000", "plane")
