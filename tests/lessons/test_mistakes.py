"""The mistakes that teachers make in a lesson's file: each is found, with its line."""

from pathlib import Path

import pytest

from app.lessons.checking import CheckReport
from tests.support.mistakes import LESSON, MISTAKES

pytestmark = pytest.mark.usefixtures("few_seeds")


def faults(path: Path, text: str) -> list[str]:
    path.write_text(text, encoding="utf-8")
    report = CheckReport()
    report.read(path)
    return [str(error) for error in report.wrong]


def test_the_lesson_is_right_before_it_is_changed(tmp_path: Path) -> None:
    assert faults(tmp_path / "l.md", LESSON) == []
    assert len(MISTAKES) >= 33


@pytest.mark.parametrize("kind", MISTAKES)
def test_a_mistake_is_found(tmp_path: Path, kind: str) -> None:
    old, new, said = MISTAKES[kind]
    assert LESSON.count(old), kind
    found = faults(tmp_path / "l.md", LESSON.replace(old, new, 1))
    assert any(said in each and "line" in each for each in found), found


def test_all_mistakes_of_a_file_are_said_at_once(tmp_path: Path) -> None:
    """Also several of a step, some of which make it unreadable; each once."""
    text = LESSON
    kinds = (
        "no right choice", "a condition without a sign", "an unknown unit", "a ragged matrix",
        "an unclosed dollar", "something unknown to hide", "a link",
    )  # fmt: skip
    for kind in kinds:
        old, new, _ = MISTAKES[kind]
        text = text.replace(old, new, 1)
    found = faults(tmp_path / "l.md", f"{text}\n---\n# Two {{#one}}\n```tsak\n```\n")
    for kind in kinds:
        if kind != "a link":  # in a block that cannot be read
            assert sum(MISTAKES[kind][2] in each for each in found) == 1, (kind, found)
    assert any("unknown kind of block, tsak" in each for each in found)
    assert len(found) == len(kinds) + 1 and "repeats the name" in found[6], found


def test_all_mistakes_of_a_block_are_said_at_once(tmp_path: Path) -> None:
    """Each once, and nothing that only follows from the line that has one."""
    text = LESSON
    for old, new in (
        ("where: f < 90", "where: f 90"),
        ("wrong angle-linear: a*f", "wrong angle-linear: a*"),
        ("unit: °\nwrong angle-linear: a", "unit: grad\nwrong angle-linear: a"),
        ("hide: numbers", "hide: everything"),
        ("value: 2*atan(2*", "value: 2*atan(2*("),
        ("hint: Take the tangent.", "hnt: Take the tangent."),
    ):
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    found = faults(tmp_path / "l.md", text)
    numbers = [int(each.split("line ")[1].split(",")[0].split(" ")[0]) for each in found]
    assert sorted(numbers) == [29, 34, 49, 53, 54, 55], found


def test_nothing_is_said_that_only_follows_from_a_mistake(tmp_path: Path) -> None:
    """Neither the names of a number that has no range, nor what is missing without a line."""
    for old, new in (
        ("vary f: 20..100 step 1", "vary f: 20..100 step"),
        ("value: 2*atan(2*tan(60/2))", "value: 2*atan("),
        ("- [x] 91.5° := fov_x", "- [x] 91.5° := fov_x("),
    ):
        assert LESSON.count(old) == 1, old
        found = faults(tmp_path / "l.md", LESSON.replace(old, new))
        assert len(found) == 1, found


def test_an_answer_without_a_right_sample_is_a_warning(tmp_path: Path) -> None:
    """Nobody else knows whether the formula of its value is the right one."""
    path, tried = tmp_path / "l.md", "angle: 98.2 -> right\n"
    for text, lines in ((LESSON, [52]), (LESSON.replace(tried, ""), [29, 52])):
        path.write_text(text, encoding="utf-8")
        report = CheckReport()
        report.read(path)
        assert [each.field for each in report.warnings] == [f"line {line}" for line in lines]
    said = "line 29 is tried by no sample “angle: ... -> right”, so a wrong value"
    assert f"{path}: {said}" in str(report.warnings[0])
    assert str(report) == "1 lesson, 0 talks, 16 checks, 0 wrong, 2 warnings"
