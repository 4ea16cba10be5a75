"""Matrices for papers: lines that fit, with the digits, letters and factors that were asked for."""

import re

import pytest

from app.lecture.letters import LETTERS, Letters
from app.lecture.notation import WrittenMatrix, matrices
from app.lecture.paper import TEXT_WIDTH_PT, displayed
from app.model.chain import FiveTiles
from app.model.projection import Oblique, Perspective, Projection


def one(name: str, letters: Letters = "own", projection: Projection | None = None) -> WrittenMatrix:
    shown = matrices(projection or Projection(lens=Perspective(45.0, 4.0, 18.0)), letters)
    return next(matrix for matrix in shown if matrix.name == name)


def test_factors_and_their_product_are_two_lines_of_one_equation() -> None:
    assert (
        displayed(one("image_from_ndc"), "own", digits=3)
        == r"""\[
\begin{aligned}
M_{\text{image}\leftarrow\text{ndc}} &= \begin{pmatrix}
640 & 0 & 0 & 0 \\
0 & -360 & 0 & 0 \\
0 & 0 & 0.5 & 0 \\
0 & 0 & 0 & 1
\end{pmatrix} \begin{pmatrix}
1 & 0 & 0 & 1 \\
0 & 1 & 0 & -1 \\
0 & 0 & 1 & 1 \\
0 & 0 & 0 & 1
\end{pmatrix} \\
&= \begin{pmatrix}
640 & 0 & 0 & 640 \\
0 & -360 & 0 & 360 \\
0 & 0 & 0.5 & 0.5 \\
0 & 0 & 0 & 1
\end{pmatrix}
\end{aligned}
\]
"""
    )


def test_symbols_are_those_of_the_lecture_and_numbers_follow_them() -> None:
    both = displayed(one("clip_from_view", "003"), "003", symbols=True, digits=4)
    assert both.startswith("\\[\n\\begin{aligned}\n" r"M_{\mathrm{projection}} &= ")
    first, second = re.findall(r"begin\{pmatrix\}\n(.*?)\\end", both, re.DOTALL)
    assert first.splitlines()[2] == r"0 & 0 & -\frac{f + n}{f - n} & -\frac{2f \, n}{f - n} \\[2pt]"
    assert second.splitlines()[2] == r"0 & 0 & -1.571 & -10.29 \\"
    alone = displayed(one("clip_from_view", "003"), "003", symbols=True, numbers=False)
    assert alone.count("pmatrix") == 2 and "10.2" not in alone
    for letters in LETTERS:  # a fraction in a fraction has letters of 5 points
        tex = displayed(one("clip_from_view", letters), letters, symbols=True, numbers=False)
        assert all(cell.count(r"\frac") < 2 for cell in re.split(r"&|\\\\", tex)), tex


@pytest.mark.parametrize(
    ("digits", "near"), [(1, r"-1 \cdot 10^{1}"), (2, "-10"), (5, "-10.286"), (17, "-10.28571")]
)
def test_a_number_has_as_many_digits_as_asked(digits: int, near: str) -> None:
    assert re.search(
        rf"(?m)(& |textstyle ){re.escape(near)}",
        displayed(one("clip_from_view"), "own", digits=digits),
    )


def test_products_are_named_and_what_is_too_wide_is_left_to_its_factors() -> None:
    moved = FiveTiles((1.0, 2.0, 3.0), (10.0, 20.0, 30.0), (1.0, 2.0, 3.0), "rts").chain
    projection = Projection(lens=Perspective(45.0, 4.0, 18.0), placement=moved)
    factors = displayed(
        one("world_from_object", projection=projection), "own", symbols=True, numbers=False
    )
    assert factors.count(r"\begin{pmatrix}") == 5 and "&= " in factors
    named = displayed(one("clip_from_world"), "own")
    assert (
        r"M_{\text{canonical perspective}\leftarrow\text{view}}" in named
        and "= M_{\\text{" in named
    )


def test_a_column_has_shorter_lines_and_names_what_it_cannot_hold() -> None:
    """The widest cells of a matrix have names, and are given below it; no letter is tiny."""
    on_one_line = r"\end{pmatrix} \begin{pmatrix}"
    assert on_one_line in displayed(one("image_from_ndc"), "own", digits=3)
    assert on_one_line not in displayed(one("image_from_ndc"), "own", digits=3, text_pt=239.0)
    oblique = Projection(lens=Oblique(-3.7, 3.7, -2.1, 2.1, 4.0, 18.0, alpha_deg=45.0))
    matrix = one("clip_from_view", "000", oblique)
    assert "%" not in displayed(matrix, "000", symbols=True, numbers=False)
    narrow = displayed(matrix, "000", symbols=True, numbers=False, text_pt=239.0)
    assert narrow.startswith("{\\footnotesize\n\\[\n\\begin{aligned}\nP &= ")
    assert "& p_{14} \\\\[2pt]" in narrow and "\np_{14} &= \\textstyle -\\frac{x_" in narrow


@pytest.mark.parametrize("letters", LETTERS)
def test_long_numbers_have_small_letters_and_short_lines(letters: Letters) -> None:
    """Digits of CMR 8 are 4.25 points wide each; the figures of TeX's own fonts are all alike."""
    lens = Oblique(-3.7, 3.7, -2.1, 2.1, 1e-99, 18.0, alpha_deg=45.0, beta_deg=63.4)
    for matrix in matrices(Projection(lens=lens), letters):
        equation = displayed(matrix, letters, digits=17)
        digit_pt = 4.25 if equation.startswith("{\\f") else 4.6 if "{\\s" in equation else 5.0
        for body in re.findall(r"begin\{pmatrix\}\n(.*?)\n\\end", equation, re.DOTALL):
            columns = zip(*(row.strip("\\ ").split(" & ") for row in body.split("\n")), strict=True)
            digits = sum(max(len(re.sub(r"\D", "", cell)) for cell in column) for column in columns)
            assert digit_pt * digits + 3 * 10.0 <= TEXT_WIDTH_PT
