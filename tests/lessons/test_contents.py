"""The lessons and talks that come with the program: all of them right, every key reckoned anew."""

import math
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from mpmath import mp

from app.document.settings import pictured, set_values
from app.document.view import View
from app.drawings.side_by_side import BARE_EM, cells
from app.drawings.style import TITLE_EM
from app.lessons.blocks.block import Here
from app.lessons.blocks.exercise import Exercise
from app.lessons.blocks.matrix import MatrixQuestion
from app.lessons.blocks.order import OrderQuestion
from app.lessons.blocks.question import MarkedQuestion, Question
from app.lessons.blocks.task import Task
from app.lessons.checking import CheckReport
from app.lessons.contents import CONTENT, contained
from app.lessons.course import Course
from app.lessons.lesson import is_lesson, read
from app.lessons.practice import PlacedExercise, exercises_of
from app.scenes.scene import load
from tests.fuzz.variants import faults_of
from tests.support.commands import run_here
from tests.support.lessons import LESSON

mp.dps = 40
Key = tuple[str, str, str]
KEYS: dict[Key, Callable[..., Any]] = {}
for _path in sorted(Path(__file__).parent.glob("keys_*.py")):
    KEYS |= import_module(f"tests.lessons.{_path.stem}").KEYS
SEEDS = range(1, 9)
"""The variants of an exercise that are reckoned anew."""


pytestmark = pytest.mark.usefixtures("few_seeds")


class Reckoned(NamedTuple):
    """A value of a lesson, and the numbers of the exercise that it belongs to.

    `agrees` says whether the value is what a key returns: a number, or the numbers of a matrix row
    after row, or of a place. The key ``done`` of an exercise that sets the model returns values
    that do the task, ``lens.near=2 lens.far=9``; its other keys return values that do not.
    """

    key: Key
    numbers: dict[str, mp.mpf]
    agrees: Callable[[Any], bool]


def reckoned(course: Course) -> Iterator[Reckoned]:
    """Every value of a lesson that is right, or wrong with a named idea."""
    for place, step in enumerate(course.lesson.steps):
        here = course.at(place)
        for part in step.asked:
            at = course.lesson.path.stem, f"{step.name}/{part.name}"
            if isinstance(part, Exercise):
                for seed in SEEDS:
                    variant = part.variant(here, seed)
                    numbers = {
                        name: mp.mpf(value.numerator) / value.denominator
                        for name, value in variant.numbers.items()
                    }
                    yield from _values_of(at, variant.question, variant.here, numbers)
            elif isinstance(part, Question):
                yield from _values_of(at, part, here, {})


def _values_of(
    at: tuple[str, str], part: Question | Task, here: Here, numbers: dict[str, mp.mpf]
) -> Iterator[Reckoned]:
    if isinstance(part, Task):

        def does(name: str, text: str) -> bool:
            return part.is_done(here, set_values(here.document, text.split())) == (name == "done")

        tried = [name for *place, name in KEYS if tuple(place) == at]
        for name in {"done", *tried}:
            yield Reckoned((*at, name), numbers, partial(does, name))
        return
    formulas = {str(place): each.formulas for place, each in enumerate(part.replies, 1)}
    if not any(reply.right for reply in part.replies):  # not choices
        formulas = {reply.idea: reply.formulas for reply in part.replies}
        formulas["right"] = part.key[0]
    for name, several in formulas.items():
        if several:
            values = part.values(here, several, part.line)
            yield Reckoned((*at, name), numbers, partial(_are_close, values))


def _are_close(values: tuple[float, ...], truth: Any) -> bool:
    several = truth if isinstance(truth, tuple) else (truth,)
    return len(values) == len(several) and all(
        math.isclose(value, float(each), rel_tol=1e-9, abs_tol=1e-12)
        for value, each in zip(values, several, strict=True)
    )


def test_every_key_agrees_with_the_lectures_formula_in_40_digits() -> None:
    """None is missing, and none is left over."""
    found = [each for path in contained() for each in reckoned(Course(read(path)))]
    assert sorted({each.key for each in found} - set(KEYS)) == []
    assert sorted(set(KEYS) - {each.key for each in found}) == []
    for key, numbers, agrees in found:
        truth = KEYS[key](**numbers)
        assert agrees(truth), (key, numbers, truth)
    assert len(found) >= 100


LEAKS = {
    "l01-camera-frame": ("v-y", 42), "l02-columns": ("x", 301), "l15-clipping": ("cut", 1657),
    "l18-interpolation": ("depth", 371),
}  # fmt: skip
"""Seeds for which a wrong idea has once counted as right."""


def test_no_wrong_idea_counts_as_right() -> None:
    """``python3 -m tests.fuzz variants`` draws many more seeds."""
    for path in contained():
        name, leak = LEAKS.get(path.stem, ("", 0))
        for found in exercises_of(Course(read(path))):
            for seed in {1, leak if found.exercise.name == name else 1}:
                variant = found.exercise.variant(found.here, seed)
                assert [*faults_of(variant)] == [], (path.stem, found.exercise.name, seed)


def test_there_is_a_lesson_for_each_topic_and_a_talk_for_each_lecture() -> None:
    lessons = [read(path) for path in contained()]
    topics = [lesson.topics for lesson in lessons if not lesson.is_talk and lesson.topics]
    assert len(set(topics)) == len(topics) and ("L27",) in topics
    assert {(f"L{number}",) for number in range(1, 26)} <= set(topics)
    talks = [lesson.lecture for lesson in lessons if lesson.is_talk]
    assert talks == ["000", "001", "002", "003", "004"]
    for lesson in lessons:
        assert lesson.language == "en"
        if lesson.is_talk:
            assert lesson.minutes > 0.0
            assert lesson.letters == lesson.lecture
            continue
        asked = [part for step in lesson.steps for part in step.asked]
        predictions = [part for part in asked if part.holds]
        if lesson.topics:  # the tour is six tasks
            assert predictions, lesson.path
            assert len(asked) > len(predictions), lesson.path


@pytest.mark.parametrize("path", contained(), ids=lambda path: path.stem)
def test_the_check_of_a_lesson_is_clean(path: Path) -> None:
    report = CheckReport()
    report.read(path)
    one = r"(1 lesson, 0 talks|0 lessons, 1 talk), \d+ checks?, 0 wrong"
    assert re.fullmatch(one, str(report)), (report.wrong, report.warnings)


def test_the_list_of_lessons_names_them_all() -> None:
    done = run_here("lesson", "list")
    assert done.returncode == 0 and done.stdout.startswith("lesson L1 ")
    assert len(done.stdout.splitlines()) == len(contained())


def test_every_task_has_a_sample_that_does_it_and_one_that_does_not() -> None:
    for path in contained():
        for step in read(path).steps:
            tried = {(sample.block, sample.verdict) for sample in step.samples}
            tasks = [part.name for part in step.asked if isinstance(part, Task)]
            wanted = {(name, verdict) for name in tasks for verdict in ("done", "open")}
            assert wanted <= tried, (path.name, step.name)


def test_no_unit_is_an_english_word() -> None:
    """A unit is shown as it stands in the file, in every language."""
    for path in contained():
        units = set(re.findall("(?m)^unit: (.+)", path.read_text("utf-8")))
        assert units <= {"°", "%", "×", "px", "mm", "cm", "m", "km"}, path.name


def test_every_right_answer_is_right_as_a_student_types_it() -> None:
    """With four digits and a comma; a window is needed for one lesson of each kind only."""
    marked = 0
    for path in contained():
        course = Course(read(path))
        for place, step in enumerate(course.lesson.steps):
            for part in step.asked:
                asked, here = part, course.at(place)
                if isinstance(part, Exercise):
                    asked, here = (variant := part.variant(here, 2)).question, variant.here
                if isinstance(asked, MarkedQuestion):
                    if isinstance(asked, OrderQuestion):
                        assert asked.mark(here, asked.right_sample(here)).right
                        continue
                    values = asked.values(here, *asked.key)
                    width = asked.columns if isinstance(asked, MatrixQuestion) else len(values)
                    typed = [f"{value:.4g}".replace(".", ",") for value in values]
                    rows = [typed[at : at + width] for at in range(0, len(typed), width)]
                    between = " | " if isinstance(asked, MatrixQuestion) else " "
                    answer = "; ".join(between.join(row) for row in rows)
                    assert asked.mark(here, answer).right, (path.name, step.name, answer)
                    marked += 1
    assert marked > 50


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
    report = CheckReport()
    report.read(path)
    assert [said in str(error) for error in report.wrong] == ([True] if said else []), report.wrong


@pytest.mark.parametrize(
    ("before", "after", "said"),
    [
        ("value: 1", "value: 1 + 1", "gets “"),
        ("- [x]", "- [ ]", "just one of them right"),
        (":= ", ":= 1 + ", "says another number than"),
        ("wrong look-n", "wrong nobody", "names an unknown wrong idea"),
        ("until: ", "until: 1 > 0 \nuntil: 2 < 1\nuntil: ", "gets “open” instead of “done”"),
        ("lens.near=", "lens.naer=", "lens.naer is not known"),
        ("$", "$\\nosuch ", "has a formula that cannot be typeset: Unknown symbol"),
        ("$", f"${'{' * 60}x{'}' * 60} ", "typeset: has more than 12 levels of braces"),
        ("$", "$\u0663$ ", "typeset: Unknown symbol: \u0663"),
        ("$", f"${'x^{' * 60}x{'}' * 60} ", "typeset: has more than 12 levels of braces"),
        ("$", "$\\hspace{99999} ", "is less than 0 or more than 400 letters wide"),
        ("$", "$\\hspace{-999} ", "is less than 0 or more than 400 letters wide"),
        ("```answer", "```anwser", "has an unknown kind of block, anwser"),
    ],
)
def test_a_planted_mistake_is_found_with_file_and_line(
    tmp_path: Path, before: str, after: str, said: str
) -> None:
    assert before in LESSON
    complaints = checked(tmp_path / "wrong.md", LESSON.replace(before, after, 1))
    assert any(said in each for each in complaints), complaints
    assert all(each.startswith("line ") for each in complaints)


def checked(path: Path, text: str) -> list[str]:
    """What is wrong with a lesson, after its path."""
    path.write_text(text if text.startswith("---") else ONE + text, encoding="utf-8")
    done = run_here("lesson", "check", path)
    assert done.returncode == 1
    said = done.stdout.splitlines()
    warnings = [line for line in said if "is tried by no sample" in line]
    said = [line for line in said if line not in warnings]
    assert f", {len(said) - 2} wrong" in said[-2]
    nothing = "0 overlaps, 0 crowded, 0 empty, 0 hidden, 0 cut of 0 steps"
    assert said[-1] == nothing, "a wrong file is not drawn"
    return [line.removeprefix(f"{path}: ") for line in said[:-2]]


@pytest.mark.parametrize(
    ("plain", "practice", "said"),
    [
        (7, 4, []),
        (8, 4, ["is step 8 of a lesson; the limit is 7"]),
        (7, 5, ["is step 5 with an exercise; the limit of a lesson is 4"]),
    ],
)
def test_practice_does_not_count_as_steps_of_a_lesson(
    tmp_path: Path, plain: int, practice: int, said: list[str]
) -> None:
    exercise = "```exercise\nvary k: 1..100\nHow far?\nvalue: 2*k\n```\n"
    texts = ["Words.\n"] * plain + [exercise] * practice
    steps = "".join(f"---\n# S {{#s{place}}}\n{text}" for place, text in enumerate(texts))
    path = tmp_path / "long.md"
    path.write_text(f"---\ntitle: T\n{steps}", encoding="utf-8")
    report = CheckReport()
    report.read(path)
    assert len(report.wrong) == len(said)
    assert all(each in str(error) for each, error in zip(said, report.wrong, strict=True))


ONE = "---\ntitle: T\n---\n# One\n"
WRONG = [
    ("\nWords with $x$,\nmore,\nand $\\nosuch$.\n"
     "```predict\nWhy $\\frac{1$?\n- [x] a\n- [ ] $a_$ {order}\n```\n",
     [r"line 8 = '\\nosuch': WHY Unknown symbol: \nosuch, found '\'.",
      r"line 10 = '\\frac{1': WHY Expected \frac{num}{den}, found '{'.",
      "line 12 = 'a_': WHY Expected something else, found end of text."]),
    # What is said to an answer.
    ("```note\n\nminutes: 2\nSay\n$\\nosuch$.\n```\n"
     "```predict\nWhy?\n- [x] a\n- [ ] b\n  says: No $\\never$.\n"
     "why: So $\\nowhere$.\nhint: Do.\nhint: $\\nohint$\n```\n"
     "```task\nNear.\nuntil: near = 2\ndone: $\\nodone$\n```\n",
     [r"line 9 = '\\nosuch'", r"line 16 = '\\nowhere'", r"line 18 = '\\nohint'",
      r"line 15 = '\\never'", r"line 23 = '\\nodone'"]),
    # Formulas of questions, each complained about once.
    ("```predict\nWhy?\n- [x] a\n- [ ] b {order}\ncheck: near > 99\ncheck: neer = 2\n```\n"
     "```answer\nHow far?\nunit: m\nvalue: 2*neer\n```\n"
     "```answer\nHow oblique?\nunit: °\nvalue: alpha\n```\n"
     "```answer\nHow near?\nvalue: near\nwrong half: alpha/2\n  says: No.\n```\n"
     "```test\nanswer-2: 2 -> right\nanswer-3: 7 -> wrong\n```\n",
     ["line 9 = 'near > 99': does not hold.", "line 10, check = 'neer'",
      "line 15, formula = 'neer'", "line 20 has no value in this state", "line 25 has no"]),
    # Choices and wrong values that cannot be told apart, or need no answer.
    ("```answer\nQ?\nvalue: 2\nwrong a: 2.001\n  says: No.\nwrong b: 3\n  says: No.\n"
     "wrong c: 3\n  says: No.\n```\n```task\nDo.\nuntil: near > 0\n```\n"
     "```predict\nQ?\n- [x] a\n- [ ] b {order}\n```\n```test\npredict: 3 -> right\n```\n",
     ["line 8 is wrong, but its formula gives the right value, 2", "line 12 cannot be told from the"
      " wrong value of line 10, 3", "line 15 is done before the student does anything.",
      "line 25 = '3': must be the number of a choice, from 1 to 2"]),
    ("```state\ndocument: none.json\n```\n", ["line 6 cannot be read: FOLDER/none.json does not"]),
    # All steps of a file.
    ('---\ntitle: "Quoted"\n---\n# One\n```state\nscene=letter-f\n```\n'
     "```task\nDo.\nuntil: near = 3\n```\n```answer\nQ?\nvalue: 2\nwrong angle-liner: 3\n```\n"
     "```test\ntask: near=3 -> done\n```\n"
     "---\n# Two\n```anser\n```\n---\n# Three\n```state\nscene=moon\n```\n",
     ["line 22 has an unknown kind of block, anser; the nearest is answer",
      "line 15 = 'angle-liner': names an unknown wrong idea (the nearest is angle-linear)",
      "line 18, near is not known; the nearest name is lens.near.",
      "line 27 cannot be shown: There is no scene “moon”, only "]),
    # Signs that would be shown as they are typed.
    ("Costs \\$5, `$`, $x$.\nWith $y\n```answer\nSee [this](http://a.b) or [1]?\nvalue: 2\n"
     "why: ![F](f.png), <https://a.b> $x\n```\n",
     ["line 6 = 'With $y': begins a formula with $ that no other $ on its line ends.",
      "line 8 = '[this](http://a.b)': has a picture or a link, which a lesson shows",
      "line 10 = '![F](f.png), <https://a.b> $x': begins a formula",
      "line 10 = '![F](f.png)': has a picture or a link"]),
    (f"word {'word ' * 151}\n```note\n{'word ' * 151}\n```\n",
     ["line 4 has 152 words in its step; the limit is 150", "line 6 has a note of 151 words; the"]),
]  # fmt: skip


@pytest.mark.parametrize(("text", "said"), WRONG)
def test_everything_wrong_is_said_at_once_with_its_own_line(
    tmp_path: Path, text: str, said: list[str]
) -> None:
    why = "has a formula that cannot be typeset:"
    wanted = [each.replace("WHY", why).replace("FOLDER", str(tmp_path)) for each in said]
    found = checked(tmp_path / "wrong.md", text)
    assert [each[: len(start)] for each, start in zip(found, wanted, strict=True)] == wanted


def test_a_missing_file_is_refused_and_the_others_are_checked(tmp_path: Path) -> None:
    (tmp_path / "one.md").write_text(ONE, encoding="utf-8")
    done = run_here("lesson", "check", tmp_path / "none.md", tmp_path / "one.md")
    assert done.returncode == 1
    assert done.stdout.splitlines()[0] == f"{tmp_path / 'none.md'} does not exist."
    assert done.stdout.splitlines()[-2].startswith("1 lesson, 0 talks, ")
    assert done.stdout.splitlines()[-1].endswith(" of 1 step")


def test_a_warning_is_said_and_nothing_is_wrong(tmp_path: Path) -> None:
    path = tmp_path / "l.md"
    path.write_text(f"{ONE}```answer\nHow near?\nvalue: 2*near\n```\n", encoding="utf-8")
    done = run_here("lesson", "check", path)
    warning, summary, drawn = done.stdout.splitlines()
    assert warning.startswith(f"{path}: line ") and "no sample “answer: ... -> right”" in warning
    assert summary.endswith("0 wrong, 1 warning") and drawn.endswith("of 1 step")
    assert done.returncode == 0


def test_only_lessons_are_among_the_lessons() -> None:
    assert all(is_lesson(path.name) for path in CONTENT.iterdir())
    report = CheckReport()
    report.take(read(CONTENT / "ideas.md"))
    assert report.wrong == []


def exercise(lesson: str, step: str, name: str) -> PlacedExercise:
    (path,) = CONTENT.glob(f"{lesson}-*.md")
    found = (e for e in exercises_of(Course(read(path))) if e.key[1] == f"{step}/{name}")
    return next(found)


def test_every_seed_of_the_rarest_exercise_has_numbers() -> None:
    tilted = exercise("l01", "practise-4", "tilted")
    for seed in (782, 1589, 1997, 3022, 3067, 3503):
        assert tilted.with_numbers(seed).numbers


def test_l10_points_at_two_depths_are_at_two_depths() -> None:
    height, depths = exercise("l10", "practise-2", "height"), set()
    for seed in range(1, 40):
        variant = height.with_numbers(seed)
        state = next(each.state for each in variant.question.replies if each.idea == "ortho-div")
        one, other = variant.here.shown_by(state).view.probes
        assert one.point[1] == other.point[1] and one.point[2] != other.point[2]
        depths.add(variant.numbers["d"])
    assert depths == set(range(2, 13))


def test_l23_so_many_trees_are_drawn_between_the_fronts_of_the_pairs() -> None:
    count = exercise("l23", "practise-3", "count")
    for seed in range(1, 9):
        variant = count.with_numbers(seed)
        first = variant.numbers["d"] + 3 * variant.numbers["k"] - 6
        for far, is_done in (
            (first - 2, False),
            (first - 1, True),
            (first + 4, True),
            (first + 5, False),
        ):
            tried = set_values(variant.here.document, [f"lens.far={float(far)}"])
            assert variant.question.is_done(variant.here, tried) == is_done


def test_l24_the_posts_that_the_text_names_are_outlined() -> None:
    (path,) = CONTENT.glob("l24-*.md")
    course = Course(read(path))
    here = course.at(0)
    asked = here.step.asked[0]
    scene, document = load("focus"), here.shown_by(asked.show)
    lines = scene.illustration(document.projection, document.settings).image.lines
    assert "those at 5 m and 6 m are outlined" in asked.why and len(lines) == 4 * 2


WIDE = {"eyes"}
"""Steps whose pictures show an angle across: with another shape they would show another angle."""


@pytest.mark.parametrize("size", [(1366, 768), (1920, 1080)])
def test_compared_images_fill_the_slide_of_a_talk(size: tuple[int, int]) -> None:
    """By the shapes of the images, below a header of 16 % of the screen."""
    width, height, em = size[0], round(0.84 * size[1]), 0.03 * size[1]
    compared = 0
    for course in (Course(read(path)) for path in sorted(CONTENT.glob("talk-*.md"))):
        for place, step in enumerate(course.lesson.steps):
            shown = course.shown(place)
            pictures = shown.view.get("compare", ())
            if not pictures or shown.view.get("slide") != ("image",) or step.name in WIDE:
                continue
            document = replace(shown.document, view=replace(View(), compare=pictures))
            aspects = [pictured(document, each).projection.aspect for each in pictures]
            cell = cells(width, height, aspects, em)
            high = [min(h - (2 * BARE_EM + TITLE_EM) * em, (w - 2 * BARE_EM * em) / a)
                    for (_, _, w, h), a in zip(cell, aspects, strict=True)]  # fmt: skip
            filled = sum(a * h * h for a, h in zip(aspects, high, strict=True)) / (width * height)
            assert filled > 0.72, (course.lesson.path.stem, step.name, filled)
            compared += 1
    assert compared > 5
