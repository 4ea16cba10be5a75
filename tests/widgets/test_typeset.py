"""Typeset formulas: the places of their parts, their pixels, and their plain text."""

from dataclasses import replace
from itertools import combinations
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QFont, QFontMetricsF, QPainterPath, QPalette
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.lecture.typesetting import Outline, outline
from app.model.formula import ARROW
from app.model.formula_text import stacked_fraction
from tests.support.window import rgb_of
from widgets.parts import typeset as typesetting
from widgets.parts.typeset import TypesetLabel, in_line, matrix, outlines_of, typeset


@pytest.fixture
def font(qapp: QApplication) -> QFont:
    return qapp.font()


def test_a_numerator_stands_above_its_denominator_with_a_line_between(font: QFont) -> None:
    formula = typeset(f"a + {stacked_fraction('2n', 'r − l')} b", font)
    (rule,), line = formula.rules, typeset("a + b", font)
    between = QRectF(rule.x1(), 0.0, rule.length(), 100.0)
    above, below = (
        formula.letters.intersected(path).boundingRect()
        for path in (rect_path(between.translated(0.0, rule.y1() - 100.0)),
                     rect_path(between.translated(0.0, rule.y1())))
    )  # fmt: skip
    assert above.bottom() < rule.y1() == rule.y2() < 0.0 and rule.y1() < below.top()
    assert above.center().x() == pytest.approx(rule.center().x(), abs=1.5)
    assert below.center().x() == pytest.approx(rule.center().x(), abs=1.5)
    assert rule.length() > below.width() > above.width() > 0.0
    assert formula.ascent > line.ascent and formula.descent > line.descent


def rect_path(rect: QRectF) -> QPainterPath:
    path = QPainterPath()
    path.addRect(rect)
    return path


def test_a_formula_is_as_wide_and_high_as_what_is_drawn_of_it(font: QFont) -> None:
    for text in ("2.5", f"n{ARROW} e_x", stacked_fraction("n_x", "f"), matrix([["1", "−2"]] * 3),
                 f"x = {stacked_fraction('1', '2')}\nR^T"):  # fmt: skip
        formula = typeset(text, font)
        inks = [formula.letters.boundingRect()]
        for x, y, run, its_font in formula.runs:
            inks.append(QFontMetricsF(its_font).tightBoundingRect(run).translated(x, y))
        inks += [QRectF(rule.p1(), rule.p2()).normalized() for rule in formula.rules]
        whole = QRectF(0.0, -formula.ascent, formula.width, formula.height)
        for ink in inks:
            assert ink.isEmpty() or whole.adjusted(-1.0, -1.0, 2.0, 1.0).contains(ink), text


def test_subscripts_stand_lower_powers_higher_and_vectors_have_an_arrow(font: QFont) -> None:
    plain, low, high, vector = (
        typeset(text, font).letters.boundingRect() for text in ("u", "u_x", "u^T", f"u{ARROW}")
    )
    assert low.bottom() > plain.bottom() + 1.0 and low.top() == pytest.approx(plain.top(), abs=0.5)
    assert high.top() < plain.top() - 1.0 and high.bottom() == pytest.approx(plain.bottom(), 0.1)
    assert vector.top() < plain.top() - 1.0 and vector.width() < 1.5 * plain.width()


def test_numbers_have_the_font_of_the_text(font: QFont) -> None:
    for text in ("−2.5", "(6, 5, 9)", "−2.5·10⁻⁷", "(1.5e-07, 2e+300)", "∞", matrix([["1", "2"]])):
        formula = typeset(text, font)
        assert formula.runs and formula.letters.isEmpty()
    for formula in (typeset("2n = f", font), typeset("0", font, is_formula=True)):
        assert not formula.runs and not formula.letters.isEmpty()
    formula = typeset("e = (6, 5, 9)", font)
    ((x, _, text, _),) = formula.runs
    assert text == "(6, 5, 9)" and formula.letters.boundingRect().right() < x


def test_a_matrix_stands_right_aligned_between_two_brackets(font: QFont) -> None:
    formula = typeset(f"M = {matrix([['1', '−22'], ['333', '4']])}", font)
    metrics = QFontMetricsF(font)
    at = {text: (x, y) for x, y, text, _ in formula.runs}
    ends = {text: x + metrics.horizontalAdvance(text) for text, (x, _) in at.items()}
    assert ends["1"] == pytest.approx(ends["333"]) and ends["−22"] == pytest.approx(ends["4"])
    assert at["1"][1] == at["−22"][1] < at["333"][1] == at["4"][1]
    upright = [rule for rule in formula.rules if rule.x1() == rule.x2()]
    left, right = sorted(rule.x1() for rule in upright)
    assert formula.letters.boundingRect().right() < left < at["333"][0] and ends["4"] < right
    for rule in upright:
        assert rule.length() > 1.9 * metrics.height()
        feet = [r for r in formula.rules if r not in upright and rule.x1() in (r.x1(), r.x2())]
        assert len(feet) == 2


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
    texts = laid_out.runs
    assert [text for _, _, text, _ in texts] == ["1", "−0.25", "3", "44", "5", "666"]
    assert len(laid_out.cells) == 6
    for cell, (x, base, _, _) in zip(laid_out.cells, texts, strict=True):
        assert cell.contains(QPointF(x + 1.0, base - 2.0))
    for one, other in combinations(laid_out.cells, 2):
        assert not one.intersects(other)
    assert typeset("1/3", font).cells == ()


def test_each_point_of_a_formula_is_read_once_for_all_its_letters(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    tex = r"\frac{a + b}{c} = x_1"
    whole, read = outline(tex), list[int]()

    class Points(np.ndarray[Any, Any]):
        def tolist(self) -> Any:
            read.append(len(self))
            return super().tolist()

    counted: Outline = replace(whole, vertices=whole.vertices.view(Points))
    monkeypatch.setattr(typesetting, "piece_of", lambda _piece, _is_tex: counted)
    parts = outlines_of.__wrapped__(tex, True)
    assert [name for name, _ in parts if name] == ["a", "b", "c", "x_1"]
    assert 0 < sum(read) <= len(whole.vertices)
