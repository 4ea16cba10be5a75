"""A lesson over the model: the documents of its steps, and what is said to answers."""

import math
import random
from pathlib import Path
from typing import Any

import pytest

from app.document.document import Document
from app.document.files import write
from app.document.settings import set_values
from app.lessons import transition
from app.lessons.contents import contained, file_of
from app.lessons.course import Course, idea_named, ideas
from app.lessons.lesson import parse_lesson, read
from app.lessons.practice import existing, practised, topics
from app.lessons.record import Attempt, Record, due, standings
from app.lessons.strokes import read_strokes
from app.model.refusal import Refusal
from app.scenes.scene import load
from tests.support.lessons import lesson_of
from tests.support.unreachable import unreachable

TOP = "---\ntitle: T\nletters: 001\n---\n"
STEPS = lesson_of(
    "scene=letter-f\nlens.fov_y_deg=60\nview.large=ndc",
    "lens.near=2\nview.stage=pyramid\nview.probes=1,2,3",
    "",
    "scene=posts",
    "scene=letter-f",
).replace("letters: own", "letters: 001")


def course(text: str, path: Path = Path("lesson.md")) -> Course:
    return Course(parse_lesson(TOP + text, path))


def of_steps() -> Course:
    return Course(parse_lesson(STEPS, Path("lesson.md")))


def asked(text: str) -> tuple[Any, Any]:
    """The only block that a step asks, and the step."""
    here = course(text).at(0)
    (block,) = here.step.asked
    return block, here


def said(text: str, place: int = 0, path: Path = Path("lesson.md")) -> str:
    with pytest.raises(Refusal) as caught:
        course(text, path).shown(place)
    return str(caught.value)


def test_a_step_goes_on_from_the_one_before_and_a_scene_begins_anew() -> None:
    of = of_steps()
    last = of.shown(2)  # before the others were ever asked for
    start = load("letter-f").start
    assert (
        last.document.projection
        == set_values(Document("letter-f", start), ["lens.fov_y_deg=60", "lens.near=2"]).projection
    )
    assert of.shown(4).document.projection == start
    assert of.shown(3).document.scene == "posts"
    views = [of.shown(place).view for place in range(5)]
    assert {name for view in views for name in view} == {
        "large", "stage", "probes", "pinned", "letters",
    }  # fmt: skip
    assert [view["large"] for view in views] == ["ndc", "ndc", "ndc", "", ""]
    assert [view["stage"] for view in views] == [4.0, 2.0, 2.0, 4.0, 4.0]
    assert [len(view["probes"]) for view in views] == [0, 1, 1, 0, 0]
    assert {view["letters"] for view in views} == {"001"}


def test_the_same_step_is_the_same_in_whatever_order_steps_are_asked_for() -> None:
    orders = random.Random(1)
    whole = [of_steps().shown(place) for place in range(5)]
    for _ in range(20):
        of, order = of_steps(), [*range(5)] * 2
        orders.shuffle(order)
        for place in order:
            assert of.shown(place) == whole[place]


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ("lens.near=2\nlens.nera=2", "line 8, lens.nera is not known"),
        ("lens.near=2\nlens.far=1", "line 7, lens.near = 2: must be less"),
        ("lens.near=-1", "line 7, lens.near = -1: must be"),
        ("scene=moon", "line 7"),
        ("lens.near=1\n```\n---\n# B\n```state\nlens.far=x", "line 12, lens"),
        ("scene=house.obj", "line 7"),
        ("document: none.json", "line 7 cannot be read"),
    ],
)
def test_an_impossible_state_is_refused_with_its_line(values: str, expected: str) -> None:
    assert expected in said(f"# A\n```state\n{values}\n```\n", values.count("---"))


def test_a_lesson_lives_in_a_folder_with_its_meshes_and_documents(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    mesh = tmp_path / "parts" / "tent.obj"
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n", encoding="utf-8")
    path = tmp_path / "lesson.md"
    of = course("# A\n```state\nscene=parts/tent.obj\nlens.fov_y_deg=50\n```\n", path)
    assert of.shown(0).document.scene == str(mesh)
    write(set_values(Document(), ["lens.near=3", "view.stage=box"]), tmp_path / "own.json")
    of = course("# A\n```state\ndocument: own.json\nlens.far=50\n```\n", path)
    lens = of.shown(0).document.projection.lens
    assert (lens.near, lens.far, of.shown(0).view["stage"]) == (3.0, 50.0, 3.0)
    # Neither a link nor a document leads out of the folder.
    outside = tmp_path.parent / f"{tmp_path.name}-outside.obj"
    outside.write_text(mesh.read_text(encoding="utf-8"), encoding="utf-8")
    (tmp_path / "link.obj").symlink_to(outside)
    assert "line 7 = 'link.obj': must be a file beside" in said(
        "# A\n```state\nscene=link.obj\n```\n", path=path
    )
    write(Document(str(outside), load(str(outside)).start), tmp_path / "far.json")
    assert "must be a file beside" in said("# A\n```state\ndocument: far.json\n```\n", path=path)


def test_a_wrong_value_is_told_by_its_idea_with_the_state_that_shows_it() -> None:
    question, here = asked("""# A
```state
scene=letter-f
lens.fov_y_deg=60
```
```answer
How wide?
value: 2*atan(aspect*tan(fov/2))
unit: °
wrong angle-linear: aspect*fov
wrong own: fov
  says: Mine.
  state: lens.fov_y_deg=30
why: So it is.
```
""")
    right = question.mark(here, "91,5°")
    assert (right.right, right.says) == (True, "So it is.")
    assert question.answer(here) == pytest.approx(91.4928445, abs=1e-6)
    wrong, idea = question.mark(here, "106.7"), idea_named("angle-linear")
    assert idea is not None and not wrong.right
    assert (wrong.idea, wrong.says, wrong.state) == ("angle-linear", idea.says, idea.state)
    own = question.mark(here, "60")
    assert (own.idea, own.says, own.state.projection.lens.fov_y_deg) == ("own", "Mine.", 30.0)
    assert question.mark(here, "91").too_short
    other = question.mark(here, "17")
    assert not other.right and not other.says and "too small" in str(other.remark)


def test_a_task_is_done_when_the_window_fulfils_its_conditions() -> None:
    task, here = asked("""# A
```state
scene=letter-f
```
```task
Twice as far, wider, in the cube.
until: distance = 2*was_distance
until: view.large = ndc
```
""")
    own = here.document
    eye = [2.0 * e - t for e, t in zip(own.projection.camera.eye, (0.0, 2.2, 0.0), strict=True)]
    now = set_values(own, [f"camera.eye={','.join(map(repr, eye))}", "view.large=ndc"])
    assert not task.is_done(here, own)
    assert task.is_done(here, now)
    assert not task.is_done(here, now, own.view)


def test_a_predictions_formulas_are_over_the_state_that_it_shows() -> None:
    question, here = asked("""# A
```state
scene=letter-f
lens.near=2
```
```predict
Which near?
- [x] 3 := near
- [ ] 2 := was_near
show: lens.near=3
check: near = 1.5*was_near
```
""")
    assert [question.values(here, each.formulas, 1) for each in question.replies] == [
        (3.0,),
        (2.0,),
    ]


def test_a_reply_in_its_own_words_has_its_own_title_and_never_the_state_of_an_idea() -> None:
    question, here = asked("""# A
```state
scene=letter-f
```
```answer
How wide?
value: 3
wrong angle-linear: 4
  says: Mine.
wrong fov-xy: 5
  title: My own words.
  says: Look at 30°.
  state: lens.fov_y_deg=30
```
""")
    known = idea_named("angle-linear")
    assert known is not None
    plain, own = question.mark(here, "4"), question.mark(here, "5")
    assert (plain.title, plain.says, plain.state) == (known.title, "Mine.", None)
    assert (own.title, own.says) == ("My own words", "Look at 30°.")
    assert own.state.projection.lens.fov_y_deg == 30.0
    assert question.response_to(here, "fov-xy") == own


def test_the_state_of_a_reply_has_all_digits_of_an_exercises_numbers() -> None:
    question, here = asked("""# A
```state
scene=letter-f
```
```exercise
vary a: 4/3, 7/3
How wide is {=a}?
value: a
wrong twice: 2*a
  says: Look.
  state: lens.fov_y_deg={=10*a}
```
""")
    variant = question.variant(here, 1)
    (wrong,) = variant.question.replies
    shown = wrong.verdict(variant.here).state
    assert shown is not None
    assert shown.projection.lens.fov_y_deg == float(10 * variant.numbers["a"])


def test_each_wrong_answer_of_a_lesson_has_a_state_and_says_what_to_look_at() -> None:
    """In the scene of its question, except where that cannot show it."""
    elsewhere = set()
    for path in contained():
        if path.stem.startswith("l"):
            of = Course(read(path))
            for place, step in enumerate(of.lesson.steps):
                for part in step.asked:
                    question, here = part.variant(of.at(place), 1)[2:]
                    for reply in getattr(question, "replies", ()):
                        if not reply.right:
                            where = f"{path.stem}, {step.name}/{part.name}: {reply.idea}"
                            assert reply.state is not None, where
                            assert "ook at" in reply.says or "ook from" in reply.says, where
                            if here.shown_by(reply.state).scene != here.document.scene:
                                elsewhere.add(f"{path.stem[:3]} {step.name}")
    assert elsewhere == {"l12 where", "l13 compute", "l16 ends", "l21 practise-2"}


def test_every_idea_that_the_program_knows_has_two_sentences_and_a_state() -> None:
    names = [step.name for step in ideas().lesson.steps]
    assert len(names) >= 36
    for name in names:
        idea = idea_named(name)
        assert idea is not None
        assert 12 <= len(idea.says.split()) <= 90, name
    assert idea_named("none-such") is None


def test_a_model_moves_from_state_to_state_and_ends_where_it_should() -> None:
    there = "camera.eye=6,5,9"
    start = set_values(Document(), ["lens.near=1", "lens.far=100", there])
    end = set_values(Document(), ["lens.near=4", "camera.eye=-6,5,-9"])
    assert transition.can_move(start, end)
    middle = transition.between(start, end, 0.5)
    assert middle is not None
    assert middle.projection.lens.near == pytest.approx(2.0)
    eyes = [transition.between(start, end, part / 10) for part in range(11)]
    for at in eyes:
        assert at is not None
        away = math.dist(at.projection.camera.eye, at.projection.camera.target)
        assert away == pytest.approx(start.projection.camera.distance, rel=0.05)
    assert not transition.can_move(start, start)
    other = set_values(Document(), ["lens.kind=orthographic"])
    assert not transition.can_move(start, other)


def test_a_mistyped_view_is_said_at_its_own_step_and_spoils_no_other() -> None:
    of = course("# A\n```state\nlens.near=1\n```\n---\n# B\n```state\nview.lerge=ndc\n```\n")
    assert of.shown(0).view == {"letters": "001"}
    with pytest.raises(Refusal, match=r"line 12, view\.lerge is not known"):
        of.shown(1)


def test_a_wrong_value_of_a_comparison_is_said_at_its_line() -> None:
    of = course(
        "# A\n```state\nscene=letter-f\nview.compare=near 0: lens.near=0|lens.near=3\n```\n"
    )
    with pytest.raises(Refusal, match=r"line 8, lens\.near = 0: must be greater than 0"):
        of.shown(0)


def test_a_lesson_or_talk_of_the_program_is_found_by_its_name(tmp_path: Path) -> None:
    for name, file in (
        ("001", "talk-001.md"), ("talk-001", "talk-001.md"), ("talk-001.md", "talk-001.md"),
        ("L5", "l05-similar-triangles.md"), ("l24", "l24-focus.md"), ("tour", "tour.md"),
    ):  # fmt: skip
        own = Path(file_of(name))
        assert own.name == file and own.exists(), name
    assert file_of("L99") == "L99" and file_of("x/001") == "x/001"
    own = tmp_path / "001"
    own.write_text("mine", encoding="utf-8")
    assert file_of(str(own)) == str(own)


def test_a_lesson_that_cannot_be_looked_for_is_not_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its record comes back all the same, when its folder is open again."""
    for name in unreachable(tmp_path, ".md", monkeypatch):
        record = Record(tmp_path / "record.jsonl")
        record.add(Attempt(1, name, "one/wide", 1, "60", "wrong"))
        known = standings(record.read())
        assert not existing(due(known)) and due(known)
        assert practised(lesson for lesson, _ in known) == dict(topics())
        assert Record(Path(name)).read() == [] and read_strokes(Path(name)) == {}
