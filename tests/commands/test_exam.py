"""``lesson print``: tests on paper for some variants, and their key."""

import math
import re
import signal
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QRectF
from PySide6.QtGui import QImage, QPainter

from app.commands import exam as command
from app.lessons.blocks.click import Click
from app.lessons.blocks.question import Question
from app.lessons.course import Course
from app.lessons.lesson import parse_lesson
from app.lessons.practice import exercises_of, topics
from app.model.refusal import Refusal
from tests.support.commands import one_sentence, run_here
from tests.support.exercises import WIDE
from tests.support.pdf import pages_of, printed
from widgets.program import exam as on_paper
from widgets.program import paper
from widgets.program.exam import Numbered, exam, key, paged

LESSON = (
    """---
title: Angles and places
---
# One {#one}
```state
scene=letter-f
```
Angles go from bottom to top.
```exercise wide
"""
    + WIDE
    + """why: By tangents.
hide: world
```
```exercise cells
vary s: 1.5..6 step 0.5
vary t: 12..19
Scale by {=s} and {=t}.
matrix: s, 0; 0, t
```
```exercise place
vary x: 0..800 step 10
vary y: 50..350 step 10
where: abs(x - 400) > 100
state: image.width=800; image.height=400
Where is the pixel?
click: image
at: x, y
wrong y-up: 800 - x, y
```
```exercise pick
vary d: 1..30
Which is twice {=d}?
- [ ] {=d + 1} {order}
- [x] {=2*d + 100}
- [ ] {=3*d + 2}
```
```exercise set
vary q: 30..120 step 2
state: lens.fov_y_deg=20
Make the picture {=q} degrees wide.
until: fov_x = q
```
"""
)


@pytest.fixture
def lesson(tmp_path: Path) -> Path:
    path = tmp_path / "small.md"
    path.write_text(LESSON, encoding="utf-8")
    return path


def exercises(seed: int, text: str = LESSON) -> list[Numbered]:
    """The exercises of a variant that can be solved on paper."""
    every = exercises_of(Course(parse_lesson(text, Path("l.md"))))
    return [
        Numbered("About it", each, each.with_numbers(seed))
        for each in every
        if each.exercise.is_on_paper
    ]


def said_in(pdf: Path) -> str:
    return " ".join(" ".join(printed(pdf.read_bytes())).split())


def test_a_test_has_the_questions_of_its_variant_and_the_key_their_answers(
    qapp: Any, lesson: Path, tmp_path: Path
) -> None:
    out = tmp_path / "tests"
    arguments = ("lesson", "print", "--topics", lesson, "--seeds", "7:8", "--out", out, "--key")
    done = run_here(*arguments)
    assert (done.returncode, done.stderr) == (0, "")
    names = ["test-small-07.pdf", "test-small-08.pdf", "key-small.pdf"]
    left_out, *written = done.stdout.splitlines()
    assert left_out == ("Left out, because it is done in the window: small, One.")
    counts = ["1 of 2", "2 of 2", "key"]
    assert written == [
        f"{count}: {out / name} written" for count, name in zip(counts, names, strict=True)
    ]
    key = said_in(out / names[2])
    for seed, name in ((7, names[0]), (8, names[1])):
        pdf = (out / name).read_bytes()
        box = re.search(rb"/MediaBox\s*\[\s*0 0 ([\d.]+) ([\d.]+)\s*\]", pdf)
        assert box is not None
        assert [round(float(side)) for side in box.groups()] == [595, 842]  # A4
        said, count = said_in(out / name), pages_of(pdf)
        assert said.count(f"small, variant {seed}") == count, "on every page"
        assert all(f"{number} / {count}" in said for number in range(1, count + 1))
        assert "Name" in said and "Date" in said
        assert "Angles go from bottom to top." in said and "go from bottom" not in key
        wide, cells, place, pick = exercises(seed)
        s, t = (f"{float(value):g}" for value in cells.variant.numbers.values())
        assert f"{s} 0 0 {t}" in key, "a matrix, its numbers as text within the page"
        fov, a = (float(value) for value in wide.variant.numbers.values())
        x, y, d = (
            float(each.variant.numbers[name])
            for each, name in ((place, "x"), (place, "y"), (pick, "d"))
        )
        angle = math.degrees(2.0 * math.atan(a * math.tan(math.radians(fov / 2.0))))
        assert f"The picture is {fov:g}° high" in said and f"twice {d:g}?" in said
        assert f"{2 * d + 100:g}" in said  # a choice, but nothing says which
        linear, mirrored = f"Twice the angle is twice the width: {a * fov:.4g}°", f"({800 - x:g}, "
        for answer in (f"{angle:.4g}", "✓", "By tangents.", f"({x:g}, {y:g})", linear, mirrored):
            assert answer in key and answer not in said, answer
        assert f"B {2 * d + 100:g} ✓" in key and f"{3 * d + 2:g} " not in key
    assert "until" not in key and "degrees wide" not in key

    before = (out / names[0]).read_bytes()
    done = run_here(*arguments[:-1])
    assert done.stdout.splitlines()[1] == f"1 of 2: {out / names[0]} overwritten"
    again = (out / names[0]).read_bytes()
    assert printed(again) == printed(before) and len(again) == len(before)


def test_what_an_exercise_hides_is_not_drawn() -> None:
    wide, cells, place, _pick = exercises(1)
    assert (wide.panes, cells.panes, place.panes) == (["ndc"], ["world"], ["image"])
    hidden = LESSON.replace("hide: world", "hide: world, ndc, image")
    assert exercises(1, hidden)[0].panes == []


OF_THE_WINDOW = re.compile(
    r"\b(click|drag|dock|pane|panel|slider|press|button|probe|window's|typed?)\b|\*\*(World|Image|NDC)",
    re.IGNORECASE,
)


def test_paper_speaks_of_nothing_that_is_in_the_window() -> None:
    said = []
    for found in (each for course in topics().values() for each in exercises_of(course)):
        if found.exercise.is_on_paper:
            question = found.exercise.variant(found.here, 1).question
            assert isinstance(question, Question)
            said += [part.text for part in found.words] + [question.posed(), question.why]
    assert len(said) > 100
    assert [text for text in said if OF_THE_WINDOW.search(text)] == []


def test_a_figure_in_which_the_answer_could_be_measured_is_a_sketch(qapp: Any) -> None:
    wide, _, place, _ = exercises(5)
    assert not wide.is_sketch and wide.drawn == wide.variant.here.document
    one, other = (exercises(n, LESSON.replace("hide: world", "hide: scale"))[0] for n in (5, 6))
    assert one.variant.here.document != other.variant.here.document
    assert one.drawn == other.drawn == Course(parse_lesson(LESSON, Path("l.md"))).shown(0).document
    assert one.panes == ["world"] and not place.is_sketch
    said = [printed(exam("Angles", 5, [each], lambda: None)) for each in (one, wide)]
    assert ["A sketch, not to scale." in runs for runs in said] == [True, False]


MEASURED = {
    "l03-field-of-view": ("alpha", "e"),  # half of the angle, and its cotangent, from above
    "l04-view-volumes": ("h",),  # D to h, from the side
    "l05-similar-triangles": ("y-p", "product"),  # y to y_p and w to d
    "l10-parallel-lens": ("height",),  # y' in the picture itself
    "l15-clipping": ("cut",),  # the share of the edge that is inside
    "l19-planar-shadow": ("shadow",),  # it lies on the squares of the ground
    "l21-camera-obscura": ("height",),  # h to h'
}
"""Exercises whose answer is a length, an angle or a share in their own picture."""


def test_no_answer_can_be_measured_on_paper() -> None:
    """Of places, which are marked in the figure itself, only the construction is asked."""
    for course in topics().values():
        for found in (each for each in exercises_of(course) if each.exercise.is_on_paper):
            each = Numbered("", found, found.with_numbers(1))
            is_measured = found.exercise.name in MEASURED.get(course.name, ())
            assert each.is_sketch == is_measured, found.key
            assert not (is_measured and isinstance(each.variant.question, Click)), found.key


def drawn(block: paper.PageBlock) -> np.ndarray[Any, Any]:
    """The pixels of a block, 2 for each point, as numbers from 0 to 255."""
    image = QImage(round(2 * block.wide), round(2 * block.height), QImage.Format.Format_Grayscale8)
    image.fill(255)
    painter = QPainter(image)
    painter.scale(2.0, 2.0)
    try:
        block.paint(painter, QRectF(0.0, 0.0, block.wide, block.height))
    finally:
        painter.end()
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    return rows[:, : image.width()].astype(float)


def test_the_key_marks_the_place_in_the_picture(qapp: Any) -> None:
    place = exercises(3)[2].variant
    x, y = (float(place.numbers[name]) for name in "xy")
    document = place.here.document
    plain = drawn(paper.figure(document, 400.0, 200.0, ["image"]))
    marked = drawn(paper.figure(document, 400.0, 200.0, ["image"], paper.MarkedPlace((x, y), 0.03)))
    rows, columns = np.nonzero(np.abs(marked - plain) > 100)
    height, width = plain.shape
    assert width == 2 * height == 400
    middle = (columns.min() + columns.max() + 1) / 2, (rows.min() + rows.max() + 1) / 2
    assert middle == pytest.approx((x / 800 * width, y / 400 * height), abs=1.0)
    assert columns.max() - columns.min() == pytest.approx(2 * 0.03 * width, abs=5.0)
    for edge in ((800.0, 400.0), (0.0, 0.0)):
        drawn(paper.figure(document, 401.0, 199.7, ["image"], paper.MarkedPlace(edge, 0.03)))
    with pytest.raises(Refusal, match="is not in the picture that is printed"):
        drawn(
            paper.figure(document, 400.0, 200.0, ["image"], paper.MarkedPlace((-50.0, 10.0), 0.03))
        )


@pytest.mark.parametrize("count", [1, 3, 4, 7, 12])
def test_pages_are_about_equally_full_and_no_exercise_is_split(qapp: Any, count: int) -> None:
    several = (exercises(1) * 3)[:count]
    head, height = paper.PageBlock(60.0, lambda *_: None), 745.0
    pages = paged(several, head, 490.0, height)
    assert sum(map(len, pages)) == count
    used = [sum(part.height + paper.BETWEEN_STEPS_PT for part in page) for page in pages]
    used[0] += head.height
    assert max(used) <= height + paper.BETWEEN_STEPS_PT
    highest = max(part.height for page in pages for part in page)
    # A page that is emptier by more than an exercise would take one of its neighbour's.
    assert max(used) - min(used) <= highest + head.height + paper.BETWEEN_STEPS_PT
    assert len(pages) == 1 or sum(used) > 0.6 * height * (len(pages) - 1)


def test_fractions_on_paper_have_letters_of_full_size(qapp: Any) -> None:
    small, large = (
        paper.text(rf"As $\{name}{{d}}{{n}}$", 400.0, 10.0) for name in ("frac", "dfrac")
    )
    assert small.height == large.height > paper.text("As", 400.0, 10.0).height


def test_an_exercise_that_fills_more_than_a_page_is_refused(qapp: Any) -> None:
    long = exercises(1, LESSON.replace("Which is", "Which\n" * 4000 + "is"))
    with pytest.raises(Refusal, match=r"line \d+ is too long for one page"):
        paged(long, paper.PageBlock(60.0, lambda *_: None), 490.0, 745.0)


def test_after_ctrl_c_there_is_no_half_file(
    qapp: Any, lesson: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write = command.write_bytes_atomically

    def write_and_cancel(path: str, content: bytes) -> None:
        write(path, content)
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(command, "write_bytes_atomically", write_and_cancel)
    out = tmp_path / "tests"
    done = run_here("lesson", "print", "--topics", lesson, "--seeds", "1:3", "--out", out, "--key")
    assert done.returncode == 130 and "Traceback" not in done.stderr
    assert [path.name for path in out.iterdir()] == ["test-small-01.pdf"]


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"--topics": "L99"}, "--topics = 'L99': must be topics from L1 to L27, or files"),
        ({"--topics": "L3,L3"}, "--topics = 'L3,L3': names L3 twice."),
        ({"--topics": "001"}, "--topics = 'talk-001': has no exercise that can be solved on paper"),
        ({"--topics": ""}, "lesson print needs --topics."),
        ({"--seeds": "5:1"}, "--seeds = '5:1': must be FIRST:LAST, such as 1:30, from 1 to 9999."),
        ({"--seeds": "0:3"}, "--seeds = '0:3': must be FIRST:LAST"),
        ({"--seeds": "1:100000"}, "--seeds = '1:100000': must be FIRST:LAST"),
        ({"--seeds": "1-3"}, "--seeds = '1-3': must be FIRST:LAST"),
        ({"--seeds": "1:9999"}, "--seeds = '1:9999': has 9999 variants; the limit is 500."),
        ({"--out": "/nowhere/tests"}, "--out = '/nowhere/tests': cannot be made a folder: No such"),
        ({"--out": "README.md"}, "--out = 'README.md': cannot be made a folder: File exists."),
        ({"--out": ""}, "lesson print needs --out."),
        ({"--key": "x.md"}, "lesson print takes no FILE such as 'x.md': use --topics."),
    ],
)
def test_bad_options_are_refused(lesson: Path, changes: dict[str, str], said: str) -> None:
    options = {"--topics": str(lesson), "--seeds": "1:2", "--out": str(lesson.parent / "t")}
    given = {name: value for name, value in (options | changes).items() if value}
    words = [word for pair in given.items() for word in pair]
    assert said in one_sentence(run_here("lesson", "print", *words), 2)
    assert [path.name for path in lesson.parent.rglob("*.pdf")] == []


def test_a_fault_of_a_lesson_is_said_with_its_file(lesson: Path, tmp_path: Path) -> None:
    text = lesson.read_text("utf-8")
    lesson.write_text(text.replace("scene=letter-f", "scene=letter-f\nlens.near=-3", 1), "utf-8")
    words = "lesson", "print", "--topics", lesson, "--seeds", "1", "--out", tmp_path / "t"
    done = run_here(*words)
    said = done.stderr
    assert done.returncode == 2 and said.count("\n") == 1
    assert said.startswith(f"{lesson}: line ") and "lens.near = -3: must be greater" in said


def test_options_of_print_belong_to_print() -> None:
    said = one_sentence(run_here("lesson", "list", "--seeds", "1:3"), 2)
    assert said == "--seeds: is an option of lesson print, not of lesson list.\n"


def test_a_state_without_a_picture_to_draw_is_a_whole_exercise(qapp: Any) -> None:
    """A question whose pictures are all hidden has room to write instead."""
    hidden = LESSON.replace("hide: world", "hide: world, ndc, image")
    ((part, *_), *_rest) = paged(
        exercises(1, hidden)[:1], paper.PageBlock(0.0, lambda *_: None), 490.0, 745.0
    )
    assert part.height < 200.0


def test_a_test_speaks_the_language_from_its_title_on(monkeypatch: pytest.MonkeyPatch) -> None:
    class Installed(Exception):
        pass

    def installed() -> None:
        raise Installed

    monkeypatch.setattr(on_paper, "off_screen_application", installed)
    monkeypatch.setattr(on_paper, "QCoreApplication", None)
    with pytest.raises(Installed):
        exam("L3", 1, [], lambda: None)
    with pytest.raises(Installed):
        key("L3", [(1, [])], "", lambda: None)
