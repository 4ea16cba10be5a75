"""Numbers of lessons that no picture can show: each is refused with its line, most when it is read.

And texts that are too long for anybody to have written them, before they cost time.
"""

from pathlib import Path

import pytest

from app.lessons import marking
from app.lessons.blocks.answer import Answer
from app.lessons.blocks.exercise import MOST_VALUES
from app.lessons.blocks.working import working
from app.lessons.checking import CheckReport
from app.lessons.course import Course
from app.lessons.lesson import Lesson, parse_lesson
from app.lessons.lines import LONGEST_LINE
from app.lessons.quantities import Condition
from app.model.formula import parse
from app.model.refusal import Refusal
from tests.lessons.test_quantities import known, value

NINES = "9" * 350
DIGITS = "9" * 5000
"""More than Python reads."""


def read(block: str, lines: str) -> Lesson:
    text = f"---\ntitle: T\n---\n# A {{#a}}\n```{block}\n{lines}\n```\n"
    return parse_lesson(text, Path("l.md"))


def check(block: str, lines: str) -> str:
    """Return what a check complains of; its first line is number 6."""
    report = CheckReport()
    report.take(read(block, lines))
    return "\n".join(map(str, report.wrong))


@pytest.mark.parametrize(
    ("block", "lines", "line", "said"),
    [
        ("answer", "Q?\nvalue: infinity", 7, "too large; the limit is 1e+100"),
        ("answer", "Q?\nvalue: near + 1\nwrong x: -infinity", 8, "too large"),
        ("answer", "Q?\nvalue: infinity - infinity", 7, "has no value"),
        ("answer", "Q?\nvalue: 0*infinity + near", 7, "has no value"),
        ("answer", "Q?\nvalue: world_from_object(infinity - infinity, 0)", 7, "has no value"),
        ("answer", f"Q?\nvalue: {NINES}", 7, "too large"),
        ("answer", f"Q?\nvalue: near*{NINES}", 7, "too large"),
        ("answer", "Q?\nvalue: 10^98*1000", 7, "too large"),
        ("answer", "Q?\nvalue: near + 1/0", 7, "divides by zero"),
        ("answer", "Q?\nvalue: near + asin(2)", 7, "not defined for its argument"),
        ("answer", "Q?\nmatrix: 1, infinity", 7, "too large"),
        ("answer", "Q?\nclick: image\nat: 1, infinity", 8, "too large"),
        ("answer", "Q?\n- [x] 1 := infinity\n- [ ] 2", 7, "too large"),
        ("task", "Q.\nuntil: near < infinity - infinity", 7, "has no value"),
        ("task", f"Q.\nuntil: near < {NINES}", 7, "too large"),
        ("exercise e", f"vary a: 1, {NINES}\nQ?\nvalue: a", 6, "too large"),
        ("exercise e", f"vary a: {NINES}..{NINES}9\nQ?\nvalue: a", 6, "too large"),
        ("exercise e", "vary a: 10^100, 1\nQ {=a^100}?\nvalue: a", 7, "too large"),
        ("exercise e", "vary a: 1, sqrt(0 - 1)\nQ?\nvalue: a", 6, "not defined"),
        ("exercise e", "vary a: 1..9\nQ?\nvalue: infinity", 8, "too large"),
        ("note", f"minutes: {NINES}", 6, "must be a number from 0 to 1000"),
        ("note", "minutes: 1_0", 6, "must be a number from 0 to 1000"),
    ],
)
def test_a_number_without_a_size_is_refused_when_it_is_read(
    block: str, lines: str, line: int, said: str
) -> None:
    with pytest.raises(Refusal) as caught:
        read(block, lines)
    assert said in str(caught.value) and f"line {line}" in str(caught.value)


@pytest.mark.parametrize(
    ("lines", "line"),
    [
        ("vary a: 1..900\nQ?\nvalue: near/(a - 37)", 8),
        ("vary a: 1..900\nvary b: 1..3\nQ?\nvalue: near/(a - 37)", 9),
        ("vary a: 1..900\nQ {=1/(a - 37)}?\nvalue: a", 7),
        ("vary a: 1..900\nQ?\nvalue: sqrt((a - 37)^2 - 1)", 8),
        ("vary a: 1..900\nQ?\nmatrix: a, 1/(a - 37)", 8),
        ("vary a: 1..900\nQ.\nuntil: near = 1/(a - 37)", 8),
    ],
)
def test_one_variant_without_a_value_is_found(lines: str, line: int) -> None:
    found = check("exercise e", lines)
    assert f"line {line}, " in found and "with a = 37" in found, found
    condition = "vary a: 1..900\nwhere: a != 37"
    assert "a = 37" not in check("exercise e", lines.replace("vary a: 1..900", condition))


def test_two_numbers_that_have_no_value_together_are_found() -> None:
    assert "divides by zero, with a = " in check(
        "exercise e", "vary a: 1..9\nvary b: 1..9\nQ?\nvalue: near/(a - b)"
    )


def test_a_state_in_which_a_value_is_infinite_is_found() -> None:
    state = "```state\nlens.far=inf\n```\n"
    answer = "```answer\nQ?\nvalue: far\n```\n"
    lesson = parse_lesson(f"---\ntitle: T\n---\n# A\n{state}{answer}", Path("l.md"))
    report = CheckReport()
    report.take(lesson)
    (error,) = report.wrong
    assert "line 10, formula = 'far': has a value that is too large" in str(error)
    part = lesson.steps[0].asked[0]
    assert isinstance(part, Answer)
    with pytest.raises(Refusal, match="too large"):  # and no OverflowError
        part.mark(Course(lesson).at(0), "5")


def test_a_number_that_is_infinite_has_no_worked_solution() -> None:
    assert working(parse("near + 1/far"), known("lens.far=inf")) is None
    assert working(parse("near + 1/far"), known()) is not None


def test_a_condition_may_speak_of_infinity() -> None:
    of = known("lens.far=inf")
    assert Condition.read("far = infinity").holds(of)
    assert Condition.read("far > 2*near").holds(of)
    assert not Condition.read("far = infinity").holds(known())


def test_a_cell_without_a_place_does_not_exist() -> None:
    for place in ("far", "-far", "0*far", "0.5", "10^90"):
        with pytest.raises(Refusal, match="asks for a part that world_from"):
            value(f"world_from_object({place}, 0)", known("lens.far=inf"))


def test_a_number_that_is_nearly_0_is_0() -> None:
    assert known().value(parse("1/10^98/1000")) == 0.0
    assert known().value(parse("1/10^98/10")) == 1e-99


@pytest.mark.parametrize("sample", ["e: {} -> right", "e: 1 {} -> right", "p: {} -> right"])
def test_a_sample_of_many_digits_is_refused_with_its_line(sample: str) -> None:
    blocks = (
        "```exercise e\nvary a: 1..50\nQ?\nvalue: a\n```\n"
        "```predict p\nQ?\n- [x] 1\n- [ ] 2\n  says: No.\n```\n"
    )
    for digits, said in ((DIGITS, "line 17 has "), (DIGITS[:3900], "line 17")):
        text = f"---\ntitle: T\n---\n# A\n{blocks}```test\n{sample.format(digits)}\n```\n"
        report = CheckReport()
        try:
            report.take(parse_lesson(text, Path("l.md")))
        except Refusal as error:
            report.wrong.append(error)
        assert [said in str(error) for error in report.wrong] == [True], report.wrong


def test_a_number_in_a_choice_may_have_a_comma_and_any_length() -> None:
    for written, is_right in (
        ("106,7° wide", True), ("106.7°", True), ("in 9 steps to −106,67", False), ("106,8", False),
        ("107", True), (f"{DIGITS[:100]} or 107", True), ("1/0", False), ("320/3", True),
    ):  # fmt: skip
        found = check("answer", f"Q?\n- [x] {written} := 320/3\n- [ ] None\n  says: No.")
        assert ("line 7" in found and "says another number" in found) is not is_right, found
        assert is_right or found.count("\n") == 0


def test_the_remark_on_a_number_of_any_size_is_one_sentence() -> None:
    for typed in ("1e100", "-1e-100", "1/10^99", "8/10^50/10^40", "2e-100"):
        for right in (1e100, -1e-100, 3.0):
            number = marking.read(typed)
            if not marking.equals(number, right):
                assert str(marking.remark(number, right)).endswith("."), typed
    for typed in ("1e101", "1e-101", "1e-99/10^99", "1/10^98/1000", "10^98*1000", "9e99*9e99"):
        with pytest.raises(Refusal, match=r"answer = .*: must be a number"):
            marking.read(typed)


# --------------------------------------------------------------------------- size


def test_a_line_that_nobody_wrote_is_refused_before_it_is_read() -> None:
    for text in ("[" * 5000, " " * 5000, "`" * 5000):
        with pytest.raises(Refusal, match=f"line 6 has 5000 .* is {LONGEST_LINE}"):
            read("answer", f"{text}\nvalue: 1")


def test_indented_lines_cannot_go_on_for_ever() -> None:
    more = "\n".join(["  and more"] * 500)
    for block, lines in (
        ("answer", f"Q?\nvalue: 1\nwhy: So.\n{more}"),
        ("answer", f"Q?\nvalue: 1\nwrong x: 2\n  says: No.\n{more}"),
        ("exercise e", f"vary a: 1, 2\n{more}\nQ?\nvalue: a"),
    ):
        with pytest.raises(Refusal, match=r"line \d{3} has .* with the indented lines below"):
            read(block, lines)


def test_a_list_has_a_bound_as_a_range_has() -> None:
    values = ",".join("1" * (MOST_VALUES + 1))
    with pytest.raises(Refusal, match="line 6 has 1001 values; the limit is 1000"):
        read("exercise e", f"vary a: {values}\nQ?\nvalue: a")


@pytest.mark.parametrize("text", ["3..5 step 1/2", "3 .. 5   step 0.5", "3..5\tstep\t.5"])
def test_a_range_is_read_with_any_blanks(text: str) -> None:
    (part,) = read("exercise e", f"vary a: {text}\nQ?\nvalue: a").steps[0].asked
    assert [float(each) for each in part.varied[0].values] == [3, 3.5, 4, 4.5, 5]  # type: ignore[attr-defined]
