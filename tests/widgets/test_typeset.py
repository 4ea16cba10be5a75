"""Typeset formulas: the places of their parts, their pixels, and their plain text."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPointF
from PySide6.QtGui import QFont, QFontMetricsF, QPalette
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.model.formula import ARROW
from app.model.formula_text import OVER, stacked_fraction
from tests.support.window import rgb_of
from widgets.parts.typeset import Typeset, TypesetLabel, in_line, matrix, typeset


@pytest.fixture
def font(qapp: QApplication) -> QFont:
    return qapp.font()


def places(formula: Typeset) -> dict[str, tuple[float, float]]:
    """Return the place of each text of a formula: to the right, and below the line."""
    return {text: (x, y) for x, y, text, _ in formula.runs}


def test_a_numerator_stands_above_its_denominator_with_a_line_between(font: QFont) -> None:
    formula = typeset(f"a + {stacked_fraction('2n', 'r − l')} b", font)
    at, (rule,) = places(formula), formula.rules
    assert at["2n"][1] < rule.y1() == rule.y2() < 0.0 < at["r − l"][1]
    assert at["a + "][0] < rule.x1() <= at["r − l"][0] < at[" b"][0]
    middles = [
        at[text][0] + QFontMetricsF(font).horizontalAdvance(text) / 2 for text, font in
        ((text, font) for _, _, text, font in formula.runs if text in ("2n", "r − l"))
    ]  # fmt: skip
    assert middles[0] == pytest.approx(middles[1]) == (rule.x1() + rule.x2()) / 2
    assert rule.length() > QFontMetricsF(formula.runs[2][3]).horizontalAdvance("r − l")
    line = typeset("a + b", font)
    assert formula.ascent > line.ascent and formula.descent > line.descent


def test_a_formula_is_as_wide_and_high_as_what_is_drawn_of_it(font: QFont) -> None:
    for text in ("2.5", f"n{ARROW} e_x", stacked_fraction("n_x", "f"), matrix([["1", "−2"]] * 3),
                 f"x = {stacked_fraction('1', '2')}\nR^T"):  # fmt: skip
        formula = typeset(text, font)
        for x, y, run, its_font in formula.runs:
            metrics = QFontMetricsF(its_font)
            assert 0.0 <= x <= x + metrics.horizontalAdvance(run) <= formula.width + 1e-6
            drawn = metrics.tightBoundingRect(run).translated(x, y)
            assert drawn.top() >= -formula.ascent - 1.0 and drawn.bottom() <= formula.descent + 1.0
        for rule in formula.rules:
            assert 0.0 <= min(rule.x1(), rule.x2()) <= max(rule.x1(), rule.x2()) <= formula.width
            assert (
                -formula.ascent
                <= min(rule.y1(), rule.y2())
                <= max(rule.y1(), rule.y2())
                <= formula.descent
            )


def test_subscripts_stand_lower_powers_higher_and_vectors_are_bold(font: QFont) -> None:
    at = places(typeset(f"u_x + R^T · look{ARROW}2n{ARROW}", font))
    assert at["x"][1] > 0.0 > at["T"][1] and at["u"][1] == 0.0
    bold = [text for _, _, text, its in typeset(f"look{ARROW}2n{ARROW}", font).runs if its.bold()]
    assert bold == ["look", "n"]


def test_a_matrix_stands_right_aligned_between_two_brackets(font: QFont) -> None:
    formula = typeset(f"M = {matrix([['1', '−22'], ['333', '4']])}", font)
    metrics = QFontMetricsF(font)
    ends = {text: x + metrics.horizontalAdvance(text) for text, (x, _) in places(formula).items()}
    assert ends["1"] == pytest.approx(ends["333"]) and ends["−22"] == pytest.approx(ends["4"])
    at = places(formula)
    assert at["1"][1] == at["−22"][1] < at["333"][1] == at["4"][1]
    upright = [rule for rule in formula.rules if rule.x1() == rule.x2()]
    left, right = sorted(rule.x1() for rule in upright)
    assert at["M = "][0] < left < at["333"][0] and ends["4"] < right
    for rule in upright:
        assert rule.length() > 1.9 * metrics.height()
        feet = [r for r in formula.rules if r not in upright and rule.x1() in (r.x1(), r.x2())]
        assert len(feet) == 2


@pytest.mark.parametrize("text", ["{2n", f"{{2n{OVER}r", "[1&2;3&4", f"{{2n{OVER}", "[1&2;3&4 5"])
def test_what_is_not_closed_is_refused(font: QFont, text: str) -> None:
    with pytest.raises(ValueError, match=r" at \d"):
        typeset(text, font)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (stacked_fraction("W", "2"), "W/2"),
        (stacked_fraction("z + 1", "2"), "(z + 1)/2"),
        (stacked_fraction("2n", "r − l"), "2n/(r − l)"),
        (stacked_fraction("1", "a\u2009f"), "1/(a\u2009f)"),
        (stacked_fraction(f"e{ARROW} − t{ARROW}", f"|e{ARROW} − t{ARROW}|"), "(e − t)/|e − t|"),
        (stacked_fraction("1", "|a| − |b|"), "1/(|a| − |b|)"),
        (matrix([["1", "2"], ["3", "4"]]), "1\t2\n3\t4"),
    ],
)
def test_a_formula_is_read_in_one_line(text: str, line: str) -> None:
    assert in_line(text) == line


@pytest.fixture
def label(qtbot: QtBot) -> TypesetLabel:
    label = TypesetLabel()
    qtbot.addWidget(label)
    label.show()
    qtbot.waitExposed(label)
    return label


def inked(label: TypesetLabel) -> Any:
    grey = rgb_of(label.grab().toImage()).mean(axis=2)
    return np.abs(grey - grey[0, -1]) > 60


def test_a_formula_that_has_less_room_is_drawn_smaller_and_whole(label: TypesetLabel) -> None:
    label.shrinks = True
    label.set_formula(matrix([["−0.123456789"] * 4] * 4))
    full = label.sizeHint()
    assert label.minimumSizeHint().width() < full.width() / 2
    for width in (full.width(), full.width() // 2):
        label.resize(width, full.height())
        columns = inked(label).any(axis=0).nonzero()[0]
        assert columns.min() <= 4 and columns.max() >= width - 5  # both brackets


@pytest.mark.parametrize("colour", ["#000000", "#ffffff"])
def test_a_formula_has_the_colour_of_text(label: TypesetLabel, colour: str) -> None:
    palette = label.palette()
    palette.setColor(QPalette.ColorRole.WindowText, colour)
    palette.setColor(QPalette.ColorRole.Window, "#808080")
    label.setPalette(palette)
    label.setAutoFillBackground(True)
    label.set_formula(matrix([["1", "2"], ["3", "4"]]))
    label.resize(label.sizeHint())
    drawn = rgb_of(label.grab().toImage()).astype(int) - 128
    assert abs(drawn).max() > 100
    assert (drawn.max() > 100) == (colour == "#ffffff")


def test_a_matrix_says_where_its_cells_are(font: QFont) -> None:
    """Cells are in rows, do not overlap, and enclose their texts."""
    laid_out = typeset("S = [1&−0.25&3;44&5&666]", font)
    texts = [run for run in laid_out.runs if run[2] != "S = "]
    assert [text for _, _, text, _ in texts] == ["1", "−0.25", "3", "44", "5", "666"]
    assert len(laid_out.cells) == 6
    for cell, (x, base, _, _) in zip(laid_out.cells, texts, strict=True):
        assert cell.contains(QPointF(x + 1.0, base - 2.0))
    for one, other in combinations(laid_out.cells, 2):
        assert not one.intersects(other)
    assert typeset("1/3", font).cells == ()
