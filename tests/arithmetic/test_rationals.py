"""Matrices of rationals: the inverse, also where cells are zero."""

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from app.arithmetic.rationals import eliminate, product

cells = st.sampled_from([Fraction(0), Fraction(0), Fraction(1), Fraction(-2), Fraction(3, 7)])
matrices = st.lists(st.lists(cells, min_size=4, max_size=4), min_size=4, max_size=4)


@given(matrices)
def test_the_inverse_times_the_matrix_is_the_identity(matrix: list[list[Fraction]]) -> None:
    rank, determinant, inverse = eliminate(matrix)
    assert (inverse is None) == (determinant == 0) == (rank < 4)
    if inverse is not None:
        assert product(inverse, matrix) == [[Fraction(i == j) for j in range(4)] for i in range(4)]
