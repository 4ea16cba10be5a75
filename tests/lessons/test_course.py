"""A lesson over the model: the documents of its steps, and what is said to answers."""

from __future__ import annotations

import math
import random
from pathlib import Path

import pytest

from app.document.document import Document
from app.document.files import write
from app.document.settings import set_values
from app.lessons import transition
from app.lessons.course import Course, idea_named, ideas
from app.lessons.lesson import Question, Task, parse_lesson
from app.model.refusal import Refusal
from app.scenes.scene import load

TOP = "---\ntitle: T\nletters: 001\n---\n"
STEPS = """# One {#one}
```state
scene=letter-f
lens.fov_y_deg=60
view.large=ndc
```
---
# Two {#two}
```state
lens.near=2
view.stage=pyramid
view.probes=1,2,3
```
---
# Three {#three}
Nothing new.

---
# Four {#four}
```state
scene=posts
```
---
# Five {#five}
```state
scene=letter-f
```
"""


def course(text: str, path: Path = Path("lesson.md")) -> Course:
    return Course(parse_lesson(TOP + text, path))


def said(text: str, place: int = 0, path: Path = Path("lesson.md")) -> str:
    with pytest.raises(Refusal) as caught:
        course(text, path).shown(place)
    return str(caught.value)


def test_a_step_goes_on_from_the_one_before_and_a_scene_begins_anew() -> None:
    of = course(STEPS)
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
    whole = [course(STEPS).shown(place) for place in range(5)]
    for _ in range(20):
        of, order = course(STEPS), [*range(5)] * 2
        orders.shuffle(order)
        for place in order:
            assert of.shown(place) == whole[place]


@pytest.mark.parametrize(
    ("text", "place", "expected"),
    [
        ("# A\n```state\nlens.near=2\nlens.nera=2\n```\n", 0, "line 8, lens.nera is not known"),
        ("# A\n```state\nlens.near=2\nlens.far=1\n```\n", 0, "line 7, lens.near = 2: must be less"),
        ("# A\n```state\nlens.near=-1\n```\n", 0, "line 7, lens.near = -1: must be"),
        ("# A\n```state\nscene=moon\n```\n", 0, "line 7"),
        (
            "# A\n```state\nlens.near=1\n```\n---\n# B\n```state\nlens.far=x\n```\n",
            1,
            "line 12, lens",
        ),
        ("# A\n```state\nscene=house.obj\n```\n", 0, "line 7"),
        ("# A\n```state\ndocument: none.json\n```\n", 0, "line 7 cannot be read"),
    ],
)
def test_a_state_that_cannot_be_is_said_with_its_line(text: str, place: int, expected: str) -> None:
    assert expected in said(text, place)


def test_a_lesson_lives_in_a_folder_with_its_meshes_and_documents(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    mesh = tmp_path / "parts" / "tent.obj"
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n")
    path = tmp_path / "lesson.md"
    of = course("# A\n```state\nscene=parts/tent.obj\nlens.fov_y_deg=50\n```\n", path)
    assert of.shown(0).document.scene == str(mesh)
    write(set_values(Document(), ["lens.near=3", "view.stage=box"]), tmp_path / "own.json")
    of = course("# A\n```state\ndocument: own.json\nlens.far=50\n```\n", path)
    lens = of.shown(0).document.projection.lens
    assert (lens.near, lens.far, of.shown(0).view["stage"]) == (3.0, 50.0, 3.0)
    # Neither a link nor a document leads out of the folder.
    outside = tmp_path.parent / f"{tmp_path.name}-outside.obj"
    outside.write_text(mesh.read_text())
    (tmp_path / "link.obj").symlink_to(outside)
    assert "line 7 = 'link.obj': must be a file beside" in said(
        "# A\n```state\nscene=link.obj\n```\n", path=path
    )
    write(Document(str(outside), load(str(outside)).start), tmp_path / "far.json")
    assert "must be a file beside" in said("# A\n```state\ndocument: far.json\n```\n", path=path)


def test_a_wrong_value_is_told_by_its_idea_with_the_state_that_shows_it() -> None:
    of = course("""# A
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
    (question,) = of.lesson.steps[0].asked
    assert isinstance(question, Question)
    right = of.mark(0, question, "91,5°")
    assert (right.right, right.says) == (True, "So it is.")
    assert right.value == pytest.approx(91.4928445, abs=1e-6)
    wrong = of.mark(0, question, "106.7")
    idea = idea_named("angle-linear")
    assert idea is not None
    assert (wrong.right, wrong.idea, wrong.says, wrong.state) == (
        False, "angle-linear", idea.says, idea.state,
    )  # fmt: skip
    own = of.mark(0, question, "60")
    assert (own.idea, own.says) == ("own", "Mine.")
    assert own.state is not None
    assert own.state.projection.lens.fov_y_deg == 30.0  # type: ignore[attr-defined]
    assert of.mark(0, question, "91").too_short
    assert of.mark(0, question, "17") == of.mark(0, question, "18")
    assert not of.mark(0, question, "17").right


def test_a_task_is_done_by_the_window_as_it_stands() -> None:
    of = course("""# A
```state
scene=letter-f
```
```task
Twice as far, wider, in the cube.
until: distance = 2*was_distance
until: view.large = ndc
```
""")
    (task,) = of.lesson.steps[0].asked
    assert isinstance(task, Task)
    own = of.shown(0).document
    eye = [2.0 * e - t for e, t in zip(own.projection.camera.eye, (0.0, 2.2, 0.0), strict=True)]
    now = set_values(own, [f"camera.eye={','.join(map(repr, eye))}", "view.large=ndc"])
    assert not of.is_done(0, task, own)
    assert of.is_done(0, task, now)
    assert not of.is_done(0, task, now, own.view)


def test_a_predictions_formulas_are_of_the_state_that_it_shows() -> None:
    of = course("""# A
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
    (question,) = of.lesson.steps[0].asked
    assert isinstance(question, Question)
    right, wrong = question.choices
    assert right.formula is not None
    assert wrong.formula is not None
    assert of.value(0, question, right.formula, 1) == 3.0
    assert of.value(0, question, wrong.formula, 1) == 2.0


def test_every_idea_that_the_program_knows_has_two_sentences_and_a_state() -> None:
    names = [step.name for step in ideas().lesson.steps]
    assert len(names) >= 36
    for name in names:
        idea = idea_named(name)
        assert idea is not None
        assert 12 <= len(idea.says.split()) <= 90, name
    assert idea_named("none-such") is None


def test_a_model_moves_from_state_to_state_and_ends_where_it_should() -> None:
    start = set_values(Document(), ["lens.near=1", "lens.far=100"])
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
