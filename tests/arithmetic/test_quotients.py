"""Arrays of rationals against `Fraction`, one by one."""

import math
from fractions import Fraction
from typing import Any

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from app.arithmetic.formats import Quotients
from app.arithmetic.rationals import nearest

FLOATS = st.floats(allow_nan=False, allow_infinity=False)
ROWS = st.lists(st.tuples(FLOATS, FLOATS), min_size=1, max_size=5)
SCALARS = st.fractions().filter(bool)


def exact(values: list[Any]) -> list[float]:
    return [nearest(value) if value is not None else math.nan for value in values]


@given(ROWS, SCALARS)
def test_every_number_is_rounded_once(rows: list[tuple[float, float]], scalar: Fraction) -> None:
    a, b = ([Fraction(row[i]) for row in rows] for i in (0, 1))
    p, q = (Quotients.of(np.array(row)) for row in zip(*rows, strict=True))
    pairs = [*zip(a, b, strict=True)]
    for found, true in (
        (p, a),
        (-p, [-x for x in a]),
        (p * q - scalar, [x * y - scalar for x, y in pairs]),
        (scalar + p / scalar, [scalar + x / scalar for x in a]),
        (sum([3 * p, q], scalar), [3 * x + y + scalar for x, y in pairs]),
        ((p / q + 1) * scalar, [(x / y + 1) * scalar if y else None for x, y in pairs]),
    ):
        np.testing.assert_array_equal(found.floats(), exact(true))
        signs = [value is not None and value < 0 for value in true]
        assert found.is_negative().tolist() == signs


def test_no_numbers_are_no_numbers() -> None:
    assert (Quotients.of(np.array([])) + 1).floats().shape == (0,)
