"""The lessons and talks that come with the program: all of them right, every key reckoned anew."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path

import pytest
from mpmath import mp

from app.lessons.checking import Report
from app.lessons.course import CONTENT, Course, contained
from app.lessons.lesson import Question, Task, is_lesson, read
from tests.support.commands import run_here

mp.dps = 40
Key = tuple[str, str, str]
KEYS: dict[Key, Callable[[], object]] = {}
for _path in sorted(Path(__file__).parent.glob("keys_*.py")):
    KEYS |= import_module(f"tests.lessons.{_path.stem}").KEYS


def keys_of(course: Course) -> Iterator[tuple[Key, float]]:
    """Every number of a lesson that is right, or wrong in a way that has a name."""
    stem = course.lesson.path.stem
    for place, step in enumerate(course.lesson.steps):
        for part in step.asked:
            if not isinstance(part, Question):
                continue
            where = stem, f"{step.name}/{part.name}"
            if part.value is not None:
                yield (*where, "right"), course.value(place, part, part.value, part.line)
            for wrong in part.wrong:
                value = course.value(place, part, wrong.formula, wrong.line)
                yield (*where, wrong.idea), value
            for number, choice in enumerate(part.choices, 1):
                if choice.formula is not None:
                    value = course.value(place, part, choice.formula, choice.line)
                    yield (*where, str(number)), value


def test_every_key_agrees_with_the_lectures_formula_in_40_digits() -> None:
    """None is missing, and none is left over."""
    found: dict[Key, float] = {}
    for path in contained():
        found |= dict(keys_of(Course(read(path))))
    assert sorted(set(found) - set(KEYS)) == []
    assert sorted(set(KEYS) - set(found)) == []
    for key, value in found.items():
        truth = mp.mpf(KEYS[key]())  # type: ignore[arg-type]
        assert math.isclose(value, float(truth), rel_tol=1e-9, abs_tol=1e-12), (key, value, truth)
    assert len(found) >= 100


def test_there_is_a_lesson_for_each_topic_and_a_talk_for_each_lecture() -> None:
    lessons = [read(path) for path in contained()]
    topics = [lesson.topics for lesson in lessons if not lesson.is_talk and lesson.topics]
    assert sorted(topics) == sorted((f"L{number}",) for number in range(1, 25))
    talks = [lesson.lecture for lesson in lessons if lesson.is_talk]
    assert talks == ["000", "001", "002", "003", "004"]
    for lesson in lessons:
        assert lesson.language == "en"
        names = [step.name for step in lesson.steps]
        assert len(set(names)) == len(names)
        if lesson.is_talk:
            assert lesson.minutes > 0.0
            assert lesson.letters == lesson.lecture
            continue
        assert 3 <= len(lesson.steps) <= 7, lesson.path
        asked = [part for step in lesson.steps for part in step.asked]
        predictions = [p for p in asked if isinstance(p, Question) and p.predicts]
        if lesson.topics:  # the tour is six tasks
            assert predictions, lesson.path
            assert len(asked) > len(predictions), lesson.path


def test_lesson_check_is_clean_and_says_what_it_has_tried() -> None:
    done = run_here("lesson", "check")
    last = done.stdout.splitlines()[-1]
    assert (done.returncode, done.stdout) == (0, last + "\n")
    assert last.startswith("25 lessons, 5 talks, ")
    assert last.endswith(" checks, 0 wrong")


def test_every_task_has_a_sample_that_does_it_and_one_that_does_not() -> None:
    for path in contained():
        for step in read(path).steps:
            tried = {(sample.block, sample.verdict) for sample in step.samples}
            tasks = [part.name for part in step.asked if isinstance(part, Task)]
            wanted = {(name, verdict) for name in tasks for verdict in ("done", "open")}
            assert wanted <= tried, (path.name, step.name)


@pytest.mark.parametrize(
    ("sample", "said"),
    [
        ("view.panes=world -> done", ""),
        ("view.panes=image,world lens.near=2 -> done", ""),
        ("view.panes=image -> open", ""),
        ("lens.near=2 view.panes= -> open", ""),
        ("view.panes=ndc -> done", "gets “open” instead of “done”"),
        ("view.panes=word -> done", "line 16, view.panes = 'word': must be one of world, ndc"),
        ("lens.near=0 view.panes=world -> done", "line 16, lens.near"),
    ],
)
def test_a_sample_can_have_the_panes_turned_by_hand(tmp_path: Path, sample: str, said: str) -> None:
    path = tmp_path / "turn.md"
    text = (
        "---\ntitle: Turn\n---\n# One {#one}\nText.\n```state\nscene=letter-f\n```\n\n"
        "```task turn\nTurn the world.\nuntil: turned = 1\n```\n"
    )
    path.write_text(f"{text}\n```test\nturn: {sample}\n```\n", encoding="utf-8")
    report = Report()
    report.read(path)
    assert [said in str(error) for error in report.wrong] == ([True] if said else []), report.wrong


def test_lesson_list_names_them_all() -> None:
    done = run_here("lesson", "list")
    assert done.returncode == 0
    assert len(done.stdout.splitlines()) == len(contained()) == 30


@pytest.mark.parametrize(
    ("before", "after", "said"),
    [
        ("value: ", "value: 1 + ", "gets “"),
        ("- [x]", "- [ ]", "just one of them right"),
        (":= ", ":= 1 + ", "says another number than its formula"),
        ("wrong ", "wrong nobody-", "names a wrong idea that the program does not know"),
        ("until: ", "until: 1 > 0 \nuntil: 2 < 1\nuntil: ", "gets “open” instead of “done”"),
        ("lens.near=", "lens.naer=", "lens.naer is not known"),
        ("$", "$\\nosuch ", "has a formula that cannot be written: Unknown symbol"),
        ("$", f"${'{' * 60}x{'}' * 60} ", "written: has more than 12 levels of braces"),
        ("$", "$\u0663$ ", "written: Unknown symbol: \u0663"),
        ("$", f"${'x^{' * 60}x{'}' * 60} ", "written: has more than 12 levels of braces"),
        ("$", "$\\hspace{99999} ", "is less than 0 or more than 400 letters wide"),
        ("$", "$\\hspace{-999} ", "is less than 0 or more than 400 letters wide"),
        ("```answer", "```anwser", "has a block that there is not, anwser"),
    ],
)
def test_a_planted_mistake_is_found_with_file_and_line(
    tmp_path: Path, before: str, after: str, said: str
) -> None:
    """Each in whichever of the lessons has the place for it."""
    text = next(
        text
        for path in contained()
        if before in (text := path.read_text(encoding="utf-8")) and "```test" in text
    )
    line = text[: text.index(before)].count("\n") + 1
    (tmp_path / "wrong.md").write_text(text.replace(before, after, 1), encoding="utf-8")
    done = run_here("lesson", "check", tmp_path / "wrong.md")
    assert done.returncode == 1
    complaints = done.stdout.splitlines()[:-1]
    assert any(said in each for each in complaints), complaints
    assert all(each.startswith(f"{tmp_path / 'wrong.md'}: line ") for each in complaints)
    assert line
    assert not done.stdout.endswith(" 0 wrong\n")


def test_a_formula_that_cannot_be_written_is_said_with_its_own_line(tmp_path: Path) -> None:
    path = tmp_path / "wrong.md"
    path.write_text(
        "---\ntitle: T\n---\n# One\n\nWords with $x$,\nmore,\nand $\\nosuch$.\n"
        "```predict\nWhy $\\frac{1$?\n- [x] a\n- [ ] $a_$\n```\n",
        encoding="utf-8",
    )
    said = run_here("lesson", "check", path).stdout.splitlines()
    why = "has a formula that cannot be written:"
    assert [line.removeprefix(f"{path}: ") for line in said[:-1]] == [
        f"line 8 = '\\\\nosuch': {why} Unknown symbol: \\nosuch, found '\\'.",
        f"line 10 = '\\\\frac{{1': {why} Expected \\frac{{num}}{{den}}, found '{{'.",
        f"line 12 = 'a_': {why} Expected something else, found end of text.",
    ]


def places_said(path: Path, text: str) -> list[str]:
    """Where something is wrong with a lesson, in the order that it is said."""
    path.write_text("---\ntitle: T\n---\n# One\n" + text, encoding="utf-8")
    said = run_here("lesson", "check", path).stdout.splitlines()
    found = [line.removeprefix(f"{path}: ") for line in said[:-1]]
    return [re.split(": | has no | does ", line, maxsplit=1)[0] for line in found]


def test_what_is_said_to_an_answer_has_the_line_of_its_formula(tmp_path: Path) -> None:
    text = (
        "```note\n\nminutes: 2\nSay\n$\\nosuch$.\n```\n"
        "```predict\nWhy?\n- [x] a\n- [ ] b\n  says: No $\\never$.\n"
        "why: So $\\nowhere$.\nhint: Do.\nhint: $\\nohint$\n```\n"
        "```task\nNear.\nuntil: near = 2\ndone: $\\nodone$\n```\n"
    )
    assert places_said(tmp_path / "wrong.md", text) == [
        "line 9 = '\\\\nosuch'",
        "line 16 = '\\\\nowhere'",
        "line 18 = '\\\\nohint'",
        "line 15 = '\\\\never'",
        "line 23 = '\\\\nodone'",
    ]


def test_a_formula_of_a_question_is_said_once_with_its_own_line(tmp_path: Path) -> None:
    text = (
        "```predict\nWhy?\n- [x] a\n- [ ] b\ncheck: near > 99\ncheck: neer = 2\n```\n"
        "```answer\nHow far?\nunit: m\nvalue: 2*neer\n```\n"
        "```answer\nHow oblique?\nunit: °\nvalue: alpha\n```\n"
        "```answer\nHow near?\nvalue: near\nwrong half: alpha/2\n  says: No.\n```\n"
        "```test\nanswer-2: 2 -> right\nanswer-3: 7 -> wrong\n```\n"
    )
    assert places_said(tmp_path / "wrong.md", text) == [
        "line 9 = 'near > 99'",
        "line 10, check = 'neer'",
        "line 15, formula = 'neer'",
        "line 20",
        "line 25",
    ]


def test_a_document_that_is_not_there_is_said_in_one_sentence(tmp_path: Path) -> None:
    (tmp_path / "wrong.md").write_text(
        "---\ntitle: T\n---\n# One\n```state\ndocument: none.json\n```\n"
    )
    said = run_here("lesson", "check", tmp_path / "wrong.md").stdout.splitlines()[0]
    assert said.endswith("none.json does not exist.")


def test_a_file_that_is_none_is_said_and_the_others_are_checked(tmp_path: Path) -> None:
    done = run_here("lesson", "check", tmp_path / "none.md", contained()[0])
    assert done.returncode == 1
    assert done.stdout.splitlines()[0] == f"{tmp_path / 'none.md'} does not exist."
    assert done.stdout.splitlines()[-1].startswith("1 lesson, 0 talks, ")


def test_only_lessons_are_among_the_lessons() -> None:
    assert all(is_lesson(path.name) for path in CONTENT.iterdir())
    report = Report()
    report.take(read(CONTENT / "ideas.md"))
    assert report.wrong == []


def test_all_that_is_wrong_with_a_file_is_said_at_once(tmp_path: Path) -> None:
    path = tmp_path / "wrong.md"
    path.write_text(
        '---\ntitle: "Quoted"\n---\n# One\n```state\nscene=letter-f\n```\n'
        "```task\nDo.\nuntil: near = 3\n```\n"
        "```answer\nQ?\nvalue: 2\nwrong angle-liner: 3\n```\n"
        "```test\ntask: near=3 -> done\n```\n"
        "---\n# Two\n```anser\n```\n---\n# Three\n```state\nscene=moon\n```\n",
        encoding="utf-8",
    )
    done = run_here("lesson", "check", path)
    said = [line.removeprefix(f"{path}: ") for line in done.stdout.splitlines()]
    assert said[0].startswith("line 22 has a block that there is not, anser; the nearest is answer")
    assert said[1].startswith("line 15 = 'angle-liner': names a wrong idea")
    assert "the nearest is angle-linear" in said[1]
    assert said[2] == "line 18, near is not known; the nearest name is lens.near."
    assert said[3].startswith("line 27 cannot be shown: There is no scene “moon”, only ")
    assert said[4:] == ["1 lesson, 0 talks, 3 checks, 4 wrong"]
    assert run_here("lesson", "list", contained()[0]).stdout.startswith("lesson L1 ")
