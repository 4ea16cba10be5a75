"""Answers that are a matrix or a vector: their format, their marks cell by cell, their solution."""

from functools import partial

import pytest

from app.lessons.blocks.exercise import Exercise
from app.lessons.blocks.matrix import MatrixQuestion
from app.lessons.course import AtStep
from app.model.refusal import Refusal
from tests.support import lessons

STATE = "scene=letter-f\nlens.near=2\nlens.far=10\n"
# With n = 2, f = 10, l = -1, r = 3, b = -2, t = 2 the lecture's matrix is, by hand:
#   2n/(r-l) = 1    0         (r+l)/(r-l) = 1/2       0
#   0               2n/(t-b) = 1   0                   0
#   0               0         -(f+n)/(f-n) = -3/2     -2fn/(f-n) = -5
#   0               0         -1                       0
FRUSTUM = """The matrix?
matrix: 2*near/(3 - -1), 0, (3 + -1)/(3 - -1), 0;
  0, 2*near/max(1, 4), 0, 0;
  0, 0, -(far+near)/(far-near), -2*far*near/(far-near); 0, 0, -1, 0
wrong angle-linear: 1, 0, 1/2, 0; 0, 1, 0, 0; 0, 0, -1/5, 0; 0, 0, -1, 0
why: As in the lecture.
"""
RIGHT = "1|0|0.5|0;0|1|0|0;0|0|-3/2|-5;0|0|-1|0"
VECTOR = "Where?\nmatrix: 1; -2; 30.25\n"


faults = partial(lessons.faults, state=STATE)


def question(body: str, test: str = "", kind: str = "answer") -> tuple[MatrixQuestion, AtStep]:
    here = lessons.asked_at(body, test, kind, state=STATE)
    return here.asked["mine"], here  # type: ignore[return-value]


def said(body: str, typed: str) -> str:
    asked, here = question(body)
    verdict = asked.mark(here, typed)
    return str(verdict.remark or verdict.word)


def test_a_matrix_is_marked_cell_by_cell() -> None:
    asked, here = question(FRUSTUM)
    assert asked.answer(here) == (1, 0, 0.5, 0, 0, 1, 0, 0, 0, 0, -1.5, -5, 0, 0, -1, 0)
    right = asked.mark(here, RIGHT)
    assert right.right and all(right.cells) and right.says == "As in the lecture."
    wrong = asked.mark(here, RIGHT.replace("-5", "5").replace("-1|0", "1|0"))
    assert [place for place, is_right in enumerate(wrong.cells) if not is_right] == [11, 14]
    assert str(wrong.remark) == "The marked numbers have the wrong sign."
    idea = asked.mark(here, "1|0|1/2|0;0|1|0|0;0|0|-0,2|0;0|0|-1|0")
    assert (idea.right, idea.idea, idea.cells.count(False)) == (False, "angle-linear", 2)


@pytest.mark.parametrize(
    ("typed", "remark"),
    [
        ("1|0|0|0;0|1|0|0;.5|0|-1.5|-1;0|0|-5|0", "rows and columns are exchanged"),
        ("1|0|.5|0;0|1|0|0;0|0|-1|0;0|0|-1.5|-5", "rows 3 and 4 are exchanged"),
        (".5|0|1|0;0|1|0|0;-1.5|0|0|-5;-1|0|0|0", "columns 1 and 3 are exchanged"),
        ("-1|0|-.5|0;0|-1|0|0;0|0|1.5|5;0|0|1|0", "All signs are turned round."),
        ("1|0|.5|0;0|1|0|0;0|0|-1.5|-9;0|0|-1|0", "Only the number in row 3, column 4 is wrong"),
        ("1|0|.5|0;0|1|0|0;0|0|-2|-9;0|0|-1|0", "Only row 3 is wrong"),
        ("1|0|.5|0;0|1|0|0;0|0|-2|-5;0|0|-9|0", "Only column 3 is wrong"),
        ("7|0|.5|0;0|7|0|0;0|0|-2|-9;0|0|-1|0", "12 of 16 numbers are right"),
    ],
)  # fmt: skip
def test_a_mixed_up_matrix_is_recognised(typed: str, remark: str) -> None:
    assert remark in said(FRUSTUM, typed)


@pytest.mark.parametrize(
    ("typed", "remark"),
    [
        ("1; -2; 30,25", "right"),
        ("-2; 1; 30.25", "rows 1 and 2 are exchanged"),
        ("-1; 2; -30.3", "All signs are turned round."),
        ("1; 2; 30.2", "The marked numbers have the wrong sign."),
        ("1; 7; 30.2", "Only row 2 is wrong."),
        ("3; 7; 30.2", "1 of 3 numbers are right"),
        ("3; 7; 8", "None of the numbers is right."),
    ],
)
def test_a_vector_is_marked_too(typed: str, remark: str) -> None:
    assert remark in said(VECTOR, typed)


def test_a_cell_with_too_few_digits_is_not_wrong_yet() -> None:
    asked, here = question("Where?\nmatrix: 1; 30.25\n")
    assert asked.mark(here, "1; 30").too_short
    assert not asked.mark(here, "2; 30").too_short
    with pytest.raises(Refusal, match="wide is neither a number"):
        asked.mark(here, "1; wide")


def test_the_solution_has_letters_then_numbers_then_values() -> None:
    asked, here = question("Where?\nmatrix: 2*near, atan(far/2); -1, max(1, 2)\n")
    solution = asked.solution(here)
    assert solution == (
        "- $m_{11} = 2 \\, \\mathrm{near}$ $= 2 \\cdot 2$ $= 4$\n"
        "- $m_{12} = \\arctan\\left(\\frac{\\mathrm{far}}{2}\\right)$"
        " $= \\arctan\\left(\\frac{10}{2}\\right)$ $\\approx 78.69^{\\circ}$"
    )
    part, here = question("Where?\nmatrix: near, 1\nfirst: 3, 4\n")
    assert part.solution(here) == "- $m_{34} = \\mathrm{near}$ $= 2$"
    with pytest.raises(Refusal, match="must be a row and a column"):
        question("Where?\nmatrix: near, 1\nfirst: 3\n")
    assert question(VECTOR)[0].solution(here) == ""
    assert asked.printed(["1", "2", "-1", "2"]) == "1, 2; -1, 2"
    assert asked.printed(["0,5", "2", "-1", "2"]) == "0,5 | 2; -1 | 2"
    assert "| 30.25 |" in asked.with_answer(question(VECTOR)[0].answer_text(here, "{:g}".format))


def test_samples_have_cells_and_rows() -> None:
    samples = f"mine: {RIGHT} -> right\nmine: {RIGHT.replace('-5', '5')} -> wrong"
    assert faults(FRUSTUM, samples) == ""
    assert "gets “wrong”" in faults(VECTOR, "mine: 1; 2; 3 -> right")
    assert "gets “no number”" in faults(VECTOR, "mine: 1; ; 3 -> right")
    assert "must have 3 × 1 cells: “;” separates rows" in faults(VECTOR, "mine: 1; 2 -> wrong")


@pytest.mark.parametrize(
    ("body", "complaint"),
    [
        ("Q?\nmatrix: 1, 2; 3", "must have 1 to 4 rows"),
        ("Q?\nmatrix: 1, 2, 3, 4, 5", "must have 1 to 4 rows"),
        ("Q?\nmatrix: 1", "at least two cells"),
        ("Q?\nmatrix: 1, 2;", "must have 1 to 4 rows"),
        ("Q?\nmatrix: 1, 2; 3, )", "line 12, matrix = ')': needs a number"),
        ("Q?\nmatrix: 1, 2\nvalue: 3", "line 13 gives the answer in a second way"),
        ("Q?\nmatrix: 1, 2\nwrong idea: 1; 2", "has 2 × 1 cells; the answer has 1 × 2"),
        ("Q?\nmatrix: 1, 2\nwrong up-v: 1, 2", "line 13 is wrong, but its formula gives"),
        ("Q?\nmatrix: 1, 2\nwrong order: 1, 3\nwrong up-v: 1, 3", "wrong value of line 13"),
        ("Q?\nmatrix: 1, nearr", "unknown name, nearr"),
        ("Q?", "needs “value:”, “count:”, “matrix:”, “click:”, “order:”, or"),
    ],
)  # fmt: skip
def test_a_faulty_matrix_is_refused_with_its_line(body: str, complaint: str) -> None:
    found = faults(body + "\n")
    assert complaint in found and "line " in found


def test_an_exercise_may_ask_for_a_matrix() -> None:
    body = (
        "vary s: 2..30\nvary t: 2..9\nScale by {=s}, then by {=t}.\nmatrix: s*t, 0; 0, t\n"
        "wrong order: s*s, 0; 0, t\n"
    )
    asked, here = question(body, kind="exercise")
    assert isinstance(asked, Exercise)
    for seed in range(1, 40):
        variant = asked.variant(here, seed)
        s, t = (float(variant.numbers[name]) for name in "st")
        assert s != t, "where the wrong idea would give the right matrix"
        assert isinstance(variant.question, MatrixQuestion)
        assert variant.question.mark(variant.here, f"{s * t}|0;0|{t}").right
        assert asked.verdict(here, f"{seed} {s * s}|0;0|{t}", 1) == "order"
