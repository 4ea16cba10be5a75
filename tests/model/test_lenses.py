"""A lens is its table: the closed form is the product of the factors, and what float64 makes of it.

The product is compared in letters, which is a proof for every lens there can be, and in rationals
through `Projection`, which is how the tables are used.
"""

import math
from fractions import Fraction
from functools import reduce
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.arithmetic.rationals import product
from app.lecture.algebra import SYMBOLS, Letters, Ratio, number
from app.model.lenses import frustum, oblique, orthographic, perspective
from app.model.lenses.lens import LensTable
from app.model.projection import (
    DEPTH_RANGES,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.model.tables import Table, evaluated, matrix
from tests.oracles.exact import Exact, mp

TABLES = {
    "perspective": perspective.TABLE,
    "perspective-inf": perspective.TABLE_AT_INFINITY,
    "frustum": frustum.TABLE,
    "frustum-inf": frustum.TABLE_AT_INFINITY,
    "orthographic": orthographic.TABLE,
    "oblique": oblique.TABLE,
}
IDENTITY = matrix("1  0  0  0\n0  1  0  0\n0  0  1  0\n0  0  0  1")


def in_letters(table: Table) -> list[list[Ratio]]:
    return evaluated(table, Letters(), SYMBOLS)


def same(one: list[list[Ratio]], other: list[list[Ratio]]) -> bool:
    rows = zip(one, other, strict=True)
    return not any(a - b for row in rows for a, b in zip(*row, strict=True))


@pytest.mark.parametrize("name", TABLES)
def test_the_closed_form_is_the_product_of_the_factors(name: str) -> None:
    table: LensTable = TABLES[name]
    whole = in_letters(IDENTITY)
    for step in table.steps:
        of_step = in_letters(IDENTITY)
        for _, factor in step.factors:
            of_step = product(of_step, in_letters(factor))
        whole = product(of_step, whole)
    assert same(whole, in_letters(table.clip_from_view))


@pytest.mark.parametrize("name", TABLES)
def test_the_way_back_is_the_inverse(name: str) -> None:
    table: LensTable = TABLES[name]
    assert table.view_from_clip is not None
    there, back = in_letters(table.clip_from_view), in_letters(table.view_from_clip)
    assert same(product(back, there), in_letters(IDENTITY))


@pytest.mark.parametrize(
    ("table", "z", "wanted"),
    [
        (  # OpenGL's glFrustum and glOrtho, from their manual pages
            frustum.TABLE,
            (-1, 1),
            """
            2*n/(r - l)  0            (r + l)/(r - l)   0
            0            2*n/(t - b)  (t + b)/(t - b)   0
            0            0            -(f + n)/(f - n)  -2*f*n/(f - n)
            0            0            -1                0
            """,
        ),
        (
            orthographic.TABLE,
            (-1, 1),
            """
            2/(r - l)  0          0           -(r + l)/(r - l)
            0          2/(t - b)  0           -(t + b)/(t - b)
            0          0          -2/(f - n)  -(f + n)/(f - n)
            0          0          0           1
            """,
        ),
        (  # D3DXMatrixPerspectiveFovRH, transposed
            perspective.TABLE,
            (0, 1),
            """
            cot(fov/2)/aspect  0           0          0
            0                  cot(fov/2)  0          0
            0                  0           f/(n - f)  n*f/(n - f)
            0                  0           -1         0
            """,
        ),
    ],
)
def test_the_textbooks_matrices_are_recognised(
    table: LensTable, z: tuple[int, int], wanted: str
) -> None:
    depth = Letters(z_n=number(z[0]), z_f=number(z[1]))
    assert same(evaluated(table.clip_from_view, depth, SYMBOLS), in_letters(matrix(wanted)))


# --------------------------------------------------------------------------- lenses with numbers

sides = st.tuples(st.floats(-9, 8.5), st.floats(0.25, 9)).map(lambda s: (s[0], s[0] + s[1]))
keeps = st.sampled_from(["stretch", "x", "y"])
angles = st.floats(1, 179)


@st.composite
def lenses(draw: Any) -> Lens:
    kind = draw(st.sampled_from([Perspective, Frustum, Orthographic, Oblique]))
    near = draw(st.floats(1e-3, 1e3))
    far = near * (1 + draw(st.floats(1e-3, 1e5)))
    if kind in (Perspective, Frustum) and draw(st.booleans()):
        far = math.inf
    if kind is Perspective:
        return Perspective(draw(st.floats(0.1, 179.9)), near, far)
    window = (*draw(sides), *draw(sides), near, far)
    if kind is Oblique:
        return Oblique(*window, draw(keeps), draw(angles), draw(angles))
    made: Lens = kind(*window, draw(keeps))
    return made


@settings(deadline=None)
@given(lenses(), st.sampled_from(list(DEPTH_RANGES)), st.integers(1, 4000), st.integers(1, 4000))
def test_in_rationals_too_and_float64_is_close(
    lens: Lens, depth: Any, width: int, height: int
) -> None:
    projection = Projection(lens=lens, image_size=(width, height), depth=depth)
    z_near, z_far = map(Fraction, projection.depth_range)
    letters = {**lens.exact_letters(Fraction(width, height)), "z_n": z_near, "z_f": z_far}
    exact = evaluated(lens.table.clip_from_view, letters)
    assert exact == projection.exact_clip_from_view
    assert exact == reduce(product, (stage.exact for stage in reversed(projection.lens_stages)))
    table = lens.table.view_from_clip
    assert table is not None
    identity = [[Fraction(i == j) for j in range(4)] for i in range(4)]
    assert product(evaluated(table, letters), exact) == identity
    sizes = np.array([[float(abs(cell)) for cell in row] for row in exact])
    if not isinstance(lens, Perspective | Frustum):  # sums that may cancel
        sizes[:2, 3] += 1.0 + sizes[:2, 2] * abs(lens.near)  # type: ignore[union-attr]
        sizes[2, 3] += 1.0
    off = np.abs(projection.clip_from_view - projection.direct_stages[0].matrix)
    assert (off <= 4.0 * 2.0**-52 * sizes).all()


@pytest.mark.parametrize("fov_y_deg", [1e-90, 1e-9, 45.0, 90.00000001, 120.0, 180.0 - 2.0**-45])
@pytest.mark.parametrize("size", [(1280, 720), (1, 16384), (16384, 1)])
def test_the_window_of_a_field_of_view_has_75_digits(
    fov_y_deg: float, size: tuple[int, int]
) -> None:
    """top = near tan(fov/2), right = top times width over height (lecture 003), by mpmath."""
    for near in (1e-205, 0.3, 1e99):
        projection = Projection(lens=Perspective(fov_y_deg, near, 2.0 * near), image_size=size)
        with mp.workdps(100):
            true = Exact(projection).window()
            found = projection.lens.exact_window(Fraction(*size))
            for side, expected in zip(found, true, strict=True):
                assert abs(mp.mpf(side.numerator) / side.denominator / expected - 1) < 1e-75
        right, top = float(Fraction(*size) * Fraction(float(true[3]))), float(true[3])
        assert projection.window == (-right, right, -top, top), "as a frustum that keeps its height"
