"""The command ``talk``: every step drawn, what is wrong said with its line, and A4 pages."""

import re
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.commands.composed import Composed, states_of, taken
from app.drawings.figure import PANE_PX
from app.lecture.notation import matrices
from app.lessons.blocks.question import RIGHT
from app.lessons.course import Course
from app.lessons.lesson import read
from app.model.refusal import REFUSALS, Refusal
from tests.support.commands import bare_machine, one_sentence, refused, run, run_here
from tests.support.html import Read
from tests.support.pdf import content_of, pages_of, printed
from widgets.parts.messages import read_text
from widgets.program.handout import paged
from widgets.program.handout_content import EquationTables, StepFigure, contents

pytestmark = pytest.mark.usefixtures("display")
"""A check measures texts; it would otherwise begin Qt on the platform without a screen."""

TALK = """---
title: From <b> to $x$
letters: 001
---
# One {#one}
Words with $\\frac{1}{2}$ and `<script>alert(1)</script>`.

```state
scene=letter-f
```
```note
minutes: 1
Say hello.
```
---
# Two {#two}
```state
lens.near=2
view.large=ndc
```
```predict p
Which?
- [x] this
- [ ] that {none}
  says: No.
show: lens.near=3
why: So it is.
```
```note
minutes: 2.5
The notes.
```
"""


@pytest.fixture
def talk(tmp_path: Path) -> Path:
    path = tmp_path / "small.md"
    path.write_text(TALK, encoding="utf-8")
    return path


def test_every_step_is_drawn_without_a_display(talk: Path) -> None:
    done = run("talk", talk, "--check", DISPLAY=None, WAYLAND_DISPLAY=None)
    assert done.stderr == ""
    *faults, drawn, composed = done.stdout.splitlines()
    assert drawn == "small.md: 2 steps drawn, 0 wrong"
    assert re.fullmatch(
        r"\d overlaps, \d crowded, \d empty, \d hidden, \d cut of 2 steps", composed
    )
    assert done.returncode == (1 if faults else 0)


def test_a_text_that_a_class_would_see_cut_is_told_to_its_author(talk: Path) -> None:
    long = "Words " * 80
    text = TALK.replace("Words with", f"{long}with")
    talk.write_text(text.replace("{#two}\n", f"{{#two}}\nA.\n\n{long}\n\n"), encoding="utf-8")
    done = run_here("talk", talk, "--check")
    assert done.stderr == "" and done.returncode == 1
    cut = f"{talk}: line 5, step 1 (one): the text is longer or higher than the two lines"
    assert cut in done.stdout and "step 2 (two): the text" not in done.stdout
    assert done.stdout.endswith("part of the text is only in the speaker's notes: 2 (two)\n")


@pytest.mark.parametrize(
    ("old", "new", "said", "last"),
    [
        ("lens.near=2\n", "lens.near=99\n", r"line 18.*near", "1 step drawn, 1 wrong"),
        ("show: lens.near=3", "show: lens.near=99", r"line 26.*near", "1 step drawn, 1 wrong"),
        ("\\frac{1}", "\\frac{1", r"line 6 = .*: has a formula", "2 steps drawn, 1 wrong"),
        ("# Two {#two}", "# Two {#one}", r"line 16", "0 steps drawn, 1 wrong"),
        ("scene=letter-f", "scene=nowhere", r"line 9.*nowhere", "0 steps drawn, 1 wrong"),
    ],
)
def test_a_mistake_is_reported_with_its_line(
    talk: Path, old: str, new: str, said: str, last: str
) -> None:
    assert TALK.count(old) == 1
    talk.write_text(TALK.replace(old, new), encoding="utf-8")
    done = run_here("talk", talk, "--check")
    lines = [line for line in done.stdout.splitlines() if ", step " not in line][:-1]
    assert done.returncode == 1
    assert re.search(f"small.md.*{said}", lines[0]), lines
    assert lines[-1] == f"small.md: {last}"
    assert len(lines) == int(last.split()[-2]) + 1


@pytest.mark.parametrize("command", [("talk", "--check"), ("lesson", "check")])
def test_a_missing_file_is_named_where_nothing_can_be_drawn(
    command: tuple[str, ...], tmp_path: Path
) -> None:
    with bare_machine():
        done = run_here(*command, tmp_path / "none.md")
    assert (done.returncode, done.stderr) == (1, "")
    assert done.stdout.startswith(f"{tmp_path / 'none.md'} does not exist.\n")


def test_the_next_step_is_drawn_after_one_that_cannot_be(talk: Path) -> None:
    sizes: list[tuple[int, int]] = []

    def draw(_document: Any, _pane: str, size: tuple[int, int], _em: float) -> list[Any]:
        sizes.append(size)
        if len(sizes) == 1:
            raise Refusal("near", 2.0, REFUSALS["not-zero"])
        return []

    composed, course = Composed(), Course(read(talk))
    (refused,) = taken(composed, course, draw, ())
    assert str(refused).startswith(f"{talk}: line 8, near = 2: ")
    assert composed.steps == 2 and len(sizes) == 3  # two states of the second step
    sizes.clear()
    assert taken(composed, course, draw, [refused]) == [], "the check has told it"


def test_the_states_of_replies_are_drawn(talk: Path) -> None:
    reply = "- [ ] At {0}\n  says: Look at near.\n  state: lens.near={0}\n"
    question = f"- [x] At 2 := near\n{reply.format(3)}{reply.format(4)}show: lens.near=2\n"
    state = "```state\nscene=letter-f\n```\n"
    talk.write_text(
        f"---\ntitle: T\n---\n# One\n{state}```predict near\nWhere?\n{question}```\n",
        encoding="utf-8",
    )
    nears = [each.projection.lens.near for each in states_of(Course(read(talk)), 0)]
    assert nears == [5.0, 2.0, 3.0, 4.0]


def handout_of(talk: Path, text: str) -> bytes:
    """The pages of a talk, printed in this process."""
    talk.write_text(text, encoding="utf-8")
    out = talk.with_name("out.pdf")
    done = run_here("talk", talk, "--handout", out)
    assert (done.returncode, done.stderr) == (0, "")
    return out.read_bytes()


def test_the_handout_has_every_step_with_figures(talk: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.pdf"
    out.write_text("of before", encoding="utf-8")
    done = run("talk", talk, "--handout", out, DISPLAY=None, WAYLAND_DISPLAY=None)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    pdf = out.read_bytes()
    assert pdf.startswith(b"%PDF-") and pdf.rstrip().endswith(b"%%EOF")
    box = re.search(rb"/MediaBox\s*\[\s*0 0 ([\d.]+) ([\d.]+)\s*\]", pdf)
    assert box is not None
    assert [round(float(side)) for side in box.groups()] == [595, 842]  # A4
    images = re.findall(rb"/Subtype\s*/Image\b", pdf)
    assert len(images) == 3  # each step's, and the state that the prediction shows
    assert pages_of(pdf) == 1


PANELS = """---
title: Panels
letters: 002
---
# None {#none}
```state
scene=letter-f
```
---
# Matrices {#matrices}
```state
view.panel=matrices
```
```predict p
Which?
- [x] this
- [ ] that
show: lens.near=3
why: So it is.
```
---
# Still open {#still}
```state
view.stage=pyramid
```
---
# Others {#others}
```state
lens.near=2
```
"""


def test_the_handout_has_the_matrices_where_their_panel_opens_or_they_change(
    qapp: Any, talk: Path
) -> None:
    pdf = handout_of(talk, PANELS)
    course = Course(read(talk))
    question = course.lesson.steps[1].asked[0]
    assert question.show is not None
    here = course.at(1)
    states = [here.document, here.shown_by(question.show), course.at(3).document]
    runs = Counter(printed(pdf))
    runs.subtract(map(str, range(1, pages_of(pdf) + 1)))  # at the pages' feet
    cells = Counter(
        read_text(value)
        for state in states
        for each in matrices(state.projection, "002")
        for row in each.values
        for value in row
    )
    assert len(cells) > 30
    assert {text: runs[text] for text in cells} == dict(cells)
    assert runs["image ← NDC"] == runs["view ← world = V"] == 3
    assert runs["with lecture 002's signs: w = z, and"] == 3


@pytest.mark.parametrize(
    ("letters", "equation"),
    [
        ("001", "M_z M_pp M_persp"), ("001", "f M_z M_pp M_persp"), ("004", "R P"),
        ("own", "frustum view"), ("002", "P_persp V"), ("003", "M_projection M_W→E M_O→W"),
    ],
)  # fmt: skip
def test_an_equation_of_the_handout_is_true(talk: Path, letters: str, equation: str) -> None:
    """What stands above the result is what stands above the factors, and they multiply to it."""
    state = f"view.letters={letters}\nview.slide=equation\nview.equation={equation} numbers"
    talk.write_text(
        f"---\ntitle: One\n---\n# One {{#one}}\n```state\nscene=letter-f\n{state}\n```\n",
        encoding="utf-8",
    )
    (tables,) = (part.tables for part in contents(Course(read(talk)), 0, False)
                 if isinstance(part, EquationTables))  # fmt: skip
    names = [table.partition(" =\n")[0] for table in tables]
    numbers = [
        np.reshape([*map(float, re.findall(r"(?<=\| )[^\s|]+", table.replace("−", "-")))], (4, 4))
        for table in tables
    ]
    factors = re.sub(r"[$() ·]", "", "".join(names[:-1]))
    assert re.sub(r"[$() ·]", "", names[-1]) == factors != ""
    size = np.prod([np.abs(each).max() for each in numbers[:-1]])
    assert np.allclose(np.linalg.multi_dot(numbers[:-1]), numbers[-1], rtol=0.0, atol=2e-3 * size)
    assert np.abs(numbers[-1]).max() > 0.02 * size


DRAWN = """---
title: Practise
---
# One {#one}
```state
scene=letter-f
```
```exercise pick
vary n: 3..40
What is twice {=n}?
- [x] {=2*n} := 2*n
- [ ] {=n*n} := n*n {order}
```
```exercise place
vary n: 1..30
Where are {=n} %?
click: image
at: n/100*width, height/2
```
"""


def test_the_handout_of_a_lesson_has_choices_and_answers_of_exercises(talk: Path) -> None:
    talk.write_text(DRAWN, encoding="utf-8")
    course = Course(read(talk))
    pick, place = (course.at(0).variant(part, 1) for part in course.lesson.steps[0].asked)
    n, m = (int(each.numbers["n"]) for each in (pick, place))
    told, posed = ("\n".join(each for each in contents(course, 0, answers) if isinstance(each, str))
                   for answers in (True, False))  # fmt: skip
    assert f"What is twice {n}?  \n**A** {2 * n}{RIGHT}  \n**B** {n * n}" in told
    assert f"What is twice {n}?  \n**A** {2 * n}  \n**B** {n * n}" in posed
    assert f"Where are {m} %?\n\n**({m / 100 * 1280:g}, 360)**" in told
    assert f"Where are {m} %?" in posed and "360" not in posed


WIDE = """```exercise {name}
vary f: 20..100 step 1
state: lens.fov_y_deg={{=f}}
The picture is {{=f}}° high. What is half of it?
value: f/2
unit: °
{hide}
```
"""


@pytest.mark.parametrize("answers", [True, False])
def test_an_exercise_of_a_handout_has_the_picture_with_its_own_numbers(
    talk: Path, answers: bool
) -> None:
    """Unless it must not be seen, or could be measured on paper."""
    hidden = {
        "shown": "",
        "numbers": "hide: numbers",
        "scale": "hide: scale",
        "pane": "hide: image",
    }
    exercises = "".join(WIDE.format(name=name, hide=hide) for name, hide in hidden.items())
    talk.write_text(DRAWN[: DRAWN.index("```exercise")] + exercises, encoding="utf-8")
    course = Course(read(talk))
    angles = [
        each.document.projection.lens.fov_y_deg
        for each in contents(course, 0, answers)
        if isinstance(each, StepFigure)
    ]
    shown, numbers, *_ = (course.at(0).variant(each, 1) for each in course.lesson.steps[0].asked)
    own = course.shown(0).document.projection.lens.fov_y_deg
    assert angles == [own, shown.numbers["f"], numbers.numbers["f"]]


def test_a_long_title_ends_before_the_number_of_the_page(talk: Path) -> None:
    long = " ".join(30 * ["Projections"])
    runs = printed(handout_of(talk, TALK.replace("From <b> to $x$", long)))
    assert any(run.startswith("Projections Proj") and run.endswith("…") for run in runs)


def test_the_handout_has_the_numbers_of_the_scene_where_it_is_explained(
    qapp: Any, talk: Path
) -> None:
    text = PANELS.partition("---\n# Matrices")[0]
    text = text.replace("scene=letter-f", "scene=planar-shadow\nview.panel=scene")
    text += "---\n# Away {#away}\n```state\nscene=depth-buffer\nview.panel=scene\n```\n"
    text += "---\n# Letters {#f}\n```state\nscene=letter-f\nview.panel=scene\n```\n"
    runs = printed(handout_of(talk, text))
    at = runs.index("vertex P")
    assert runs[at + 1] == "(1.5, 5, 0.5)"
    assert "Of 36 vertices." in runs
    shadow = runs.index("S")  # a matrix, typeset
    assert runs[shadow + 1 : shadow + 6] == ["9", "4", "0", "0", "0"]
    assert runs[runs.index("distance of the target, w") + 1] == "23.84"
    assert "–" not in runs  # nobody has counted anything


def test_students_get_neither_answers_nor_notes_but_lines_to_write_on(
    qapp: Any, talk: Path
) -> None:
    value = "2*atan(aspect*tan(45/2))\nunit: °"  # 2 atan(16/9 tan 22.5°)
    question = f"```answer\nHow wide?\nvalue: {value}\nwhy: By tangents.\n```\n"
    talk.write_text(TALK + question, encoding="utf-8")
    out = talk.with_name("out.pdf")
    said = {}
    for readers in ("teacher", "students"):
        done = run_here("talk", talk, "--handout", out, "--for", readers)
        assert (done.returncode, done.stderr) == (0, "")
        said[readers] = " ".join(" ".join(printed(out.read_bytes())).split())
        strokes = re.findall(rb" m\n[\d.]+ [\d.]+ l\nS\n", content_of(out.read_bytes()))
        assert (len(strokes) > 10) == (readers == "students"), strokes
    for text in ("Say hello.", "The notes.", "2.5 min.", "✓", "So it is.",
                 "72.73° ✓ By tangents."):  # fmt: skip
        assert text in said["teacher"] and text not in said["students"], text
    for text in ("1. One", "Words with", "Which?", "this", "that", "How wide?"):
        assert text in said["teacher"] and text in said["students"], text


def test_the_handout_is_also_a_page_for_phones(talk: Path) -> None:
    question = "```answer\nHow wide?\nvalue: 2*3\nwhy: By doubling.\n```\n"
    talk.write_text(TALK + question, encoding="utf-8")
    out = talk.with_name("out.html")
    for readers, figures, rooms in (("teacher", 3, 0), ("students", 2, 2)):
        done = run_here("talk", talk, "--handout", out, "--for", readers)
        assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
        text = out.read_text("utf-8")
        read = Read(text)
        assert read.open == [] and len(read.ids) == len(set(read.ids))
        tags = Counter(tag for tag, _ in read.given)
        assert (tags["figure"], tags["textarea"], tags["section"]) == (figures, rooms, 2)
        assert tags["script"] == tags["b"] == 0
        assert re.findall("https?:|url\\((?!data:font)|@import| style=", text) == []
        sizes = re.findall(r'<figure><svg viewBox="0 0 (\S+) (\S+)"', text)
        assert min(float(height) for _, height in sizes) < 0.95 * PANE_PX, "nothing is left out"
        names = [given.get("aria-label") for tag, given in read.given if tag == "svg"]
        assert "1 over 2" in names and "x" in names
        said = " ".join(" ".join(data for _, data in read.texts).split())
        for each in ("Say hello.", "The notes.", "2.5 min.", "✓", "So it is.", "By doubling."):
            assert (each in said) == (readers == "teacher"), each
        for each in ("1. One", "Words with", "<script>alert(1)</script>", "Which?", "How wide?"):
            assert each in said, each
        # What is true of a state may be the answer.
        asked = names.index("Cube: the scene in normalized device coordinates.") if rooms else 0
        assert (asked > 0) == (readers == "students")
    before = out.read_bytes()
    run_here("talk", talk, "--handout", out, "--for", "students")
    assert out.read_bytes() == before


LONG = "---\ntitle: Long\n---\n" + "---\n".join(
    f"# Step {{#s{number}}}\n{'words ' * (20 * number)}\n```state\nscene=letter-f\n```\n"
    f"```note\n{'note ' * (12 * number)}\n```\n"
    for number in range(1, 8)
)


@pytest.mark.parametrize("answers", [True, False])
def test_no_page_of_a_handout_is_half_blank(qapp: Any, talk: Path, answers: bool) -> None:
    talk.write_text(LONG, encoding="utf-8")
    course = Course(read(talk))
    pages = paged(course, 490.0, 745.0, answers)
    assert sum(len(page.pieces) for page in pages) >= 2 + 7 * 2
    for page in pages:
        end = max(piece.y + piece.height for piece in page.pieces)
        assert end <= 745.0 + 1e-6 and page.blank == pytest.approx(1.0 - end / 745.0)
        assert page.blank < 0.5
        assert not page.pieces[-1].block.kept, "a title is not alone at the end of a page"


NUMBERED = "---\ntitle: Matrices\n---\n" + "---\n".join(
    f"# Step {{#s{number}}}\nWords.\n```state\nscene=letter-f\nlens.near={number}\n{shown}\n```\n"
    for number, shown in enumerate(
        4 * ("view.slide=equation,world\nview.equation=frustum", "view.panel=matrices"), 1
    )
)


ASKED = "---\ntitle: Asked\n---\n" + "---\n".join(
    f"# Step {{#s{number}}}\n{'words ' * (30 * number)}\n```state\nscene=letter-f\n```\n"
    f"```predict ask\nQuestion {number}?\n- [x] Yes\n- [ ] No\nshow: lens.near={number}\n```\n"
    for number in range(1, 8)
)


@pytest.mark.parametrize(("text", "answers"), [(NUMBERED, True), (NUMBERED, False), (ASKED, False)])
def test_a_matrix_or_a_question_is_on_the_page_of_its_figure(
    qapp: Any, talk: Path, text: str, answers: bool
) -> None:
    talk.write_text(text, encoding="utf-8")
    pages = paged(Course(read(talk)), 490.0, 745.0, answers)
    assert len(pages) > 2
    for page in pages:
        assert page.pieces[0].block.kept, "it begins with a title"
        assert not page.pieces[-1].block.kept


def test_a_handout_is_written_whole_or_not_at_all(qapp: Any, talk: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.pdf"
    out.write_bytes(b"of before")
    talk.write_text(TALK.replace("show: lens.near=3", "show: lens.near=99"), encoding="utf-8")
    assert "small.md: line 26" in one_sentence(run_here("talk", talk, "--handout", out), 2)
    assert out.read_bytes() == b"of before"
    talk.unlink()
    assert "small.md does not exist" in refused("talk", talk, "--handout", out)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.pdf"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((), "needs --check or --handout OUT.pdf"),
        (("--handout", "out.png"), "must end in .pdf or .html."),
        (("--handout", "/nowhere/out.pdf"), "there is no folder /nowhere"),
        (("--handouts", "out.pdf"), "the nearest is --handout"),
        (
            ("--handout", "out.pdf", "--for", "all"),
            "--for = 'all': must be one of teacher, students",
        ),
        (("--check", "--for", "students"), "--for: needs --handout OUT.pdf."),
    ],
)
def test_a_wrong_command_line_is_refused(talk: Path, arguments: tuple[str, ...], said: str) -> None:
    assert said in refused("talk", talk, *arguments)


def test_the_command_that_opens_a_talk_can_be_pasted(tmp_path: Path) -> None:
    path = tmp_path / "my talk.md"
    typed = f'"{path}"' if sys.platform == "win32" else f"'{path}'"
    assert f" {typed} opens the talk." in refused("talk", path)
