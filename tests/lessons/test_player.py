"""Lessons, tests, reviews and talks as they are played, without a window."""

import math
import re
import time
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from app.document.document import Document
from app.document.settings import set_values
from app.document.view import AS_EVER
from app.lessons.blocks.block import REVEALED
from app.lessons.blocks.task import DONE
from app.lessons.contents import CONTENT, contained
from app.lessons.course import Course
from app.lessons.lesson import parse_lesson, read
from app.lessons.marking import digits_shown
from app.lessons.player import PlayedBlock, Player, Progress
from app.lessons.practice import Sheet, SheetItem, exercises_of, marked
from app.lessons.record import Attempt, Record, standings
from app.model.projection import Camera
from app.model.refusal import Refusal
from tests.support.exercises import WIDE
from tests.support.lessons import LESSON

EXERCISES = f"""---
title: Practise
---
# Widths {{#widths}}
```state
scene=letter-f
```
```exercise wide
{WIDE}hint: Take the tangent.
hide: numbers
```
```exercise set
vary wanted: 0.5..4 step 0.1
Set near to {{=wanted}}.
until: near = wanted
wrong look-n: near > 10
```
"""
TALK = """---
title: A talk
---
# One {#one}
```note
minutes: 2
```
---
# A vote {#two}
```predict wide
How wide is it?
- [ ] 106.7° {angle-linear}
- [x] 91.5°
show: lens.near=2
why: The tangents are in proportion.
```
```answer half
Half?
value: 1/2
```
```note
minutes: 1.5
```
---
# The cube {#three}
```state
view.large=ndc
```
"""


TURNED = {"world": Camera((1.0, 2.0, 3.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0))}


def course_of(text: str) -> Course:
    return Course(parse_lesson(text, Path("a.md")))


def player_at(place: int, text: str = LESSON, answers: Mapping[str, str] | None = None) -> Player:
    """A player with the page of a step, which logs its attempts in `attempts`."""
    player = Player(course_of(text), place)
    player.progress = Progress(answers=answers or {})
    return begun(player)


def begun(player: Player) -> Player:
    attempts: list[Attempt] = []
    player.log = attempts.append
    player.begin_page()
    shown(player)
    return player


def shown(player: Player) -> list[str]:
    """The texts of the parts that the step shows next."""
    return [part.text.partition("\n")[0] for part, _ in player.unfold()]


def logged(player: Player) -> list[tuple[str, str, str, int]]:
    """What was typed, with its verdict, the idea behind it, and the hints read before."""
    attempts: list[Attempt] = player.log.__self__  # type: ignore[attr-defined]
    return [(each.typed, each.verdict, each.idea, each.hints) for each in attempts]


def changed(block: PlayedBlock, *values: str) -> Document:
    return set_values(block.here.document, values)


# --------------------------------------------------------------------------- answers


def test_a_step_goes_on_once_its_prediction_is_made() -> None:
    player = Player(course_of(LESSON))
    player.begin_page()
    assert shown(player)[1:] == ["60°, 16:9. How wide?"] and shown(player) == []
    (block,) = player.blocks
    assert player.held is block
    verdict = block.submit("1")
    assert verdict.idea == "angle-linear" and not block.is_open, "there is one try"
    assert player.held is None and shown(player) == ["What comes of it."]
    assert player.progress.answers == {"angle/wide": "1"}


@pytest.mark.parametrize("clock", [-86_400.5, 0.0, 2.0**34 + 1.0, 4e10])
def test_an_answer_is_kept_also_if_the_clock_is_far_off(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, clock: float
) -> None:
    """Before 1970, at its first second, after 2514, and after 3000."""
    monkeypatch.setattr(time, "time", lambda: clock)
    kept, player = Record(tmp_path / "record.jsonl"), player_at(0, LESSON)
    player.log = kept.add
    player.blocks[0].submit("1")
    (attempt,) = kept.read()
    assert attempt.typed == "1" and kept.problem is None
    assert standings([attempt])[attempt.key].outcome == ""


def test_what_was_begun_is_there_when_its_step_is_shown_again() -> None:
    player = player_at(0, EXERCISES)

    def again(typed: str = "") -> PlayedBlock:
        player.blocks[0].keep_draft(typed)
        player.begin_page()
        shown(player)
        return player.blocks[0]

    player.blocks[0].draw(7)
    assert again().seed == 7, "the variant that was chosen"
    assert player.blocks[0].give_hint()
    wide = again("1,5")
    assert (wide.seed, wide.hints_read, wide.typed, wide.is_open) == (7, 1, "1,5", True)
    right = wide.question.answer(wide.here)  # type: ignore[attr-defined]
    assert wide.submit(f"{right:.6g}").right and logged(player)[-1][3] == 1, "a hint was read"
    assert not again("1,5").is_open and not player.blocks[0].typed
    player.blocks[0].draw(8)
    assert again().seed == 7 and not player.blocks[0].is_open, "nothing was begun"
    player.blocks[0].draw(8)
    wide = again("2")
    assert (wide.seed, wide.typed, wide.is_open) == (8, "2", True)
    player.forget()
    assert not again("3").typed and player.blocks[0].variant is None


def test_an_answer_is_marked_recorded_and_kept_once_it_is_right() -> None:
    player = player_at(2)
    wide, half, which = player.blocks
    with pytest.raises(Refusal, match="number"):
        wide.submit("wide")
    assert wide.submit("98").too_short and wide.submit("77").remark is not None
    assert wide.give_hint() == "Take the tangent." and wide.hints == ("Of half the angle.",)
    assert wide.submit("120").idea == "angle-linear" and wide.is_open
    assert wide.give_hint() and not wide.give_hint() and wide.hints_read == 2
    assert wide.submit("98,2°\n").right and not wide.is_open, "a cell of a spreadsheet"
    half.reveal_answer()
    assert not which.submit("2").right and which.is_open and which.submit("1").right
    assert logged(player) == [
        ("77", "wrong", "", 0), ("120", "wrong", "angle-linear", 1), ("98,2°", "right", "", 2),
        ("", "shown", "", 0), ("2", "wrong", "", 0), ("1", "right", "", 0),
    ], "what costs no try is no answer"  # fmt: skip
    assert player.progress.answers == {
        "numbers/wide": "98,2°\n", "numbers/half": REVEALED, "numbers/which": "1"
    }  # fmt: skip


def test_a_window_marks_a_place_and_the_record_has_where_it_was() -> None:
    text = LESSON.replace("value: 1/2", "click: image\nat: width/2, height/2")
    player = player_at(2, text)
    _, place, _ = player.blocks
    click = place.question
    right = click.verdict_at(place.here, lambda _: 3.0)  # type: ignore[attr-defined]
    assert place.submit("640 360", right, "641 362").right
    assert logged(player) == [("641 362", "right", "", 0)] and place.answer == "640 360"


def test_a_hint_is_that_of_the_question_with_the_cursor_or_of_a_task() -> None:
    player = player_at(2)
    wide, half, which = player.blocks
    assert player.hinting(None) is wide and player.hinting(half) is half
    assert player.hinting(which) is None, "it has none"
    half.submit("1/2")
    assert player.hinting(half) is wide
    last = "```answer last\nLast?\nvalue: 2\nhint: One and one.\n```"
    text = LESSON.replace("until: view.large = ndc\n```", f"until: view.large = ndc\n```\n{last}")
    near, cube, question = (player := player_at(1, text)).blocks
    assert player.hinting(question) is question and player.hinting(None) is near
    question.give_hint()
    assert player.hinting(question) is near is player.hinting(cube), "no cursor can be in a task"
    near.give_hint()
    assert player.hinting(cube) is None


def test_kept_answers_come_back_unless_the_lesson_has_changed() -> None:
    kept = {"numbers/wide": "98,2", "numbers/half": REVEALED, "numbers/which": "2"}
    wide, half, which = player_at(2, answers=kept).blocks
    assert (wide.answer, half.answer, which.answer) == ("98,2", REVEALED, "2")
    for text in (LESSON.replace("value: 2*atan", "value: 3*atan"), LESSON.replace("°", "px")):
        assert player_at(2, text, kept).blocks[0].is_open is (text.find("3*atan") > 0)
    assert player_at(2, answers={"numbers/which": "7"}).blocks[2].is_open
    (block,) = player_at(0, answers={"angle/wide": "1"}).blocks
    assert not block.holds
    for damaged in (REVEALED, "", "x", "0", "4"):
        assert player_at(0, answers={"angle/wide": damaged}).held is not None


# --------------------------------------------------------------------------- tasks


def test_a_task_is_done_however_it_is_solved() -> None:
    near, cube = (player := player_at(1)).blocks
    own = near.here.document
    assert not near.look(own)
    assert not near.look(changed(near, "lens.near=6")) and near.is_open
    assert near.look(changed(near, "lens.near=1.5")) and near.answer == DONE
    assert not near.look(changed(near, "lens.near=1.2")), "it is done once"
    assert cube.look(replace(own, view=replace(own.view, large="ndc")))
    assert logged(player) == [("lens.near=1.5", "right", "", 0), ("view.large=ndc", "right", "", 0)]


def test_the_wrong_idea_of_a_task_is_named_once() -> None:
    near, _ = (player := player_at(1)).blocks
    near.look(changed(near, "lens.near=6"))
    assert near.name_idea() is None
    for value in (11, 12):
        near.look(changed(near, f"lens.near={value}", "view.large=image"))
        verdict = near.name_idea()
        assert (verdict is not None and verdict.idea == "look-n") is (value == 11)
    assert logged(player) == [("lens.near=11", "wrong", "look-n", 0)], "the view does not matter"
    near.reveal_answer()
    assert near.name_idea() is None and near.answer == REVEALED
    near, _ = player_at(1, answers={"hand/near": REVEALED}).blocks
    near.look(changed(near, "lens.near=11"))
    assert near.name_idea() is None, "it is answered"


def test_a_wrong_idea_is_named_again_with_other_numbers() -> None:
    _, task = (player := player_at(0, EXERCISES)).blocks
    for seed in (1, 2):
        task.draw(seed)
        for _ in range(2):
            task.look(changed(task, "lens.near=11"))
            task.name_idea()
    assert logged(player) == 2 * [("lens.near=11", "wrong", "look-n", 0)]


def test_a_state_that_the_lesson_shows_is_not_the_students_work() -> None:
    player = player_at(1)
    aside, look = changed(player.blocks[0], "lens.near=0.4"), AS_EVER
    assert player.is_own_work(aside, look)
    player.show_aside(aside)
    assert not player.is_own_work(aside, look) and not player.is_own_work(aside, look)
    assert player.is_own_work(aside, replace(look, large="ndc")), "the view was changed"
    assert player.is_own_work(aside, look)
    player.show_aside(aside)
    assert player.is_own_work(changed(player.blocks[0], "lens.near=0.3"), look)


@pytest.mark.parametrize(
    ("condition", "handles"),
    [
        ("near < was_near", {"near"}), ("distance = 3*was_distance", {"eye"}),
        ("(right + left)/(right - left) = 0.5", {"corner"}), ("settings_light_y > 5", {"light"}),
        ("settings_distance < eye_z", {"distance", "eye"}), ("lens.kind = oblique", set()),
        ("abs(ndc_x) < far", {"far"}),
    ],
)  # fmt: skip
def test_a_task_needs_the_handles_of_what_it_names(condition: str, handles: set[str]) -> None:
    text = LESSON.replace("near < was_near", condition)
    assert course_of(text).lesson.steps[1].asked[0].handles == handles


# --------------------------------------------------------------------------- exercises


def test_an_exercise_is_answered_with_the_numbers_of_a_seed() -> None:
    wide, task = (player := player_at(0, EXERCISES)).blocks
    assert wide.is_open and wide.seed == 0 and not wide.hints and not wide.hides
    wide.draw(1)
    assert wide.seed == 1 and wide.hints == ("Take the tangent.",) and wide.hides == {"numbers"}
    right = right_of(wide)
    wide.give_hint()
    assert wide.submit(right).right and not wide.hides
    wide.draw(2)
    assert wide.is_open and wide.hides and wide.hints_read == 0 and right_of(wide) != right
    wide.reveal_answer()
    task.draw(3)
    (wanted,) = task.variant.numbers.values()  # type: ignore[union-attr]
    assert task.look(changed(task, f"lens.near={float(wanted)}"))
    assert player.progress.answers == {"widths/wide": f"2 {REVEALED}", "widths/set": f"3 {DONE}"}
    assert logged(player)[:2] == [(right, "right", "", 1), ("", "shown", "", 0)]


def right_of(block: PlayedBlock) -> str:
    """The right answer to a question of a number, as a student types it."""
    (value,) = block.question.values(block.here, *block.question.key)  # type: ignore[attr-defined]
    return f"{value:.{digits_shown(value, 4)}g}"


@pytest.mark.parametrize("kept", ["7 told", "x told", "7", ""])
def test_an_exercise_comes_back_with_its_numbers(kept: str) -> None:
    wide, _ = player_at(0, EXERCISES, {"widths/wide": kept}).blocks
    assert (wide.seed, wide.answer) == ((7, REVEALED) if kept == "7 told" else (wide.seed, ""))


def sheet_of(*, is_test: bool) -> Sheet:
    every = enumerate(exercises_of(course_of(EXERCISES)), 4)
    items = [SheetItem(each, each.with_numbers(seed)) for seed, each in every]
    return Sheet("test L1 7" if is_test else "", "Some", items, is_test=is_test)


def test_a_test_is_handed_in_and_marked_at_its_end() -> None:
    player = begun(Player(sheet_of(is_test=True)))
    (wide,) = player.blocks
    assert player.is_test and not wide.hints and wide.seed == 4 and wide.hides
    with pytest.raises(Refusal):
        wide.submit("what")
    assert wide.submit("\t1\n").word == "wrong" and not wide.is_open and wide.hides
    again = Player(player.course)
    again.progress = player.progress
    assert begun(again).blocks[0].answer == "1", "it is gone on with"
    player.turn_to(1)
    player.begin_page()
    shown(player)
    (task,) = player.blocks
    (wanted,) = task.variant.numbers.values()  # type: ignore[union-attr]
    assert not task.look(changed(task, f"lens.near={float(wanted)}")) and task.is_open
    assert player.left == [1]
    task.hand_in(task.changes)
    assert player.left == [] and logged(player)[1][1] == "right"
    marks = marked(sheet_of(is_test=True), player.progress.answers)
    assert [mark.word for mark in marks] == ["wrong", "right"]


def test_an_answer_for_other_numbers_does_not_count_in_a_test() -> None:
    player = Player(sheet_of(is_test=True))
    player.progress = Progress(answers={"1/wide": "9 60"})
    assert begun(player).blocks[0].is_open and player.blocks[0].seed == 4


def test_a_review_asks_with_its_numbers_and_gives_hints() -> None:
    player = begun(Player(sheet_of(is_test=False)))
    (wide,) = player.blocks
    assert wide.seed == 4 and wide.hints and not player.is_test
    assert wide.submit(right_of(wide)).right


# --------------------------------------------------------------------------- the way through


def test_what_is_left_to_do_is_known_and_can_be_begun_again() -> None:
    player = player_at(0)
    saved: list[Progress] = []
    player.keep = saved.append
    assert player.left == [0, 1, 2, 3] and not player.is_last
    player.blocks[0].submit("2")
    assert (saved[-1].done, saved[-1].of) == (1, 4)
    player.turn_to(3)
    assert player.is_last and player.blocks == []
    player.progress = replace(player.progress, step="last")
    player.finish()
    assert player.left == [1, 2] and saved[-1].step == "" and saved[-1].done == 2
    before = player.forget()
    assert before.answers and saved[-1].answers == {} == player.progress.answers


@pytest.mark.parametrize("path", [p for p in contained() if not p.stem.startswith("talk")])
def test_every_lesson_can_be_played_to_its_end(path: Path) -> None:
    """By the right answers, which the tests of contents compare with the lectures."""
    if path == CONTENT / "tour.md":
        return  # its tasks are done with the window
    player = Player(Course(read(path)))
    for place in range(len(player.lesson.steps)):
        player.turn_to(place)
        begun(player)
        for block in player.blocks:  # which grow
            solve(player, block)
            assert not block.is_open, f"{player.step.name}/{block.block.name}"
            shown(player)
        assert player.held is None
        player.leave_step()
    assert player.left == []


def solve(player: Player, block: PlayedBlock) -> None:
    """Answer a question with its right answer, or a task by the sample that does it."""
    samples = [each for each in player.step.samples if each.block == block.block.name]
    done = next((each.text for each in samples if each.verdict == "done"), "")
    if block.block.varies:
        seed, _, done = done.partition(" ")
        block.draw(int(seed or "2"))
    if block.question.pane:
        right = block.question.answer(block.here)  # type: ignore[attr-defined]
        verdict = block.question.verdict_at(  # type: ignore[attr-defined]
            block.here, lambda place: math.dist(place, right)
        )
        block.submit(" ".join(f"{each:.6g}" for each in right), verdict)
    elif block.question.has_field:
        block.submit(block.question.right_sample(block.here))
    else:
        block.look(changed(block, *re.split(r"\s+(?=[\w.]+=)", done)))


# --------------------------------------------------------------------------- a class


def said(player: Player) -> str:
    return player.said(lambda question, here: question.answer_text(here, lambda n: f"{n:g}"))


def test_a_class_is_asked_and_told_and_the_step_comes_back_as_it_was_left() -> None:
    player = Player(course_of(TALK), 1)
    assert said(player) == "" and player.unrevealed == 4
    assert player.reveal() and said(player).startswith("How wide is it?") and "A" in said(player)
    assert player.revealed_state is None
    assert player.reveal() and "106.7" not in said(player) and "**✓**" in said(player)
    assert said(player).endswith("in proportion.") and player.revealed_state is not None
    state = player.revealed_state
    assert player.reveal() and said(player) == "Half?" and player.revealed_state is state
    assert player.reveal() and "0.5" in said(player) and player.revealed_state is state
    assert not player.reveal() and player.unrevealed == 0
    player.turn_to(2)
    assert player.revealed == 0 and not player.reveal()
    player.turn_to(1)
    assert said(player) == "" and player.revealed_state is None
    player.reach_again()
    assert player.revealed == 4 and player.revealed_state is state


def test_a_talk_is_late_from_the_first_whole_minute() -> None:
    player = Player(course_of(TALK))
    planned, late = [], []
    for place in range(3):
        player.turn_to(place)
        planned.append(player.planned)
        late.append([player.minutes_late(seconds) for seconds in (0, 179, 180, 270, 900)])
    assert planned == [(0.0, 2.0), (2.0, 1.5), (3.5, 0.0)]
    assert late == [[0, 0, 1, 2, 13], [0, 0, 0, 1, 11], [0, 0, 0, 1, 11]]


# --------------------------------------------------------------------------- the window's state


def test_a_step_knows_whether_the_window_still_shows_it() -> None:
    player = Player(course_of(TALK), 2)
    document, view = player.shown_at(2)
    look = player.view_of(player.shown_at(2), AS_EVER, other_scene=False)
    assert view == {"large": "ndc"} and not player.is_away(document, look)
    assert player.is_away(set_values(document, ["lens.near=1"]), look)
    assert player.is_away(document, replace(look, large="image"))
    assert not player.is_away(document, replace(look, layers=frozenset())), "no step sets it"
    leading = Player(course_of(TALK.replace("=ndc", "=world")), 2)
    assert not leading.is_away(document, AS_EVER), "the scene's own large pane has no name"
    for scene, fixed, other in (("letter-f", "", "side"), ("similar-triangles", "side", "")):
        text = TALK.replace("view.large=ndc", f"scene={scene}\nview.fixed={fixed}")
        seen_so = Player(course_of(text), 2)
        own = seen_so.shown_at(2).document
        assert not seen_so.is_away(own, AS_EVER), "the scene's own side has no name"
        assert seen_so.is_away(own, replace(AS_EVER, fixed=other))
    hiding = "```answer one\nOne?\nvalue: 1\nhide: numbers\n```"
    asks = player_at(2, TALK.replace("view.large=ndc\n```", f"view.panel=frame\n```\n{hiding}"))
    closed, opened = (replace(AS_EVER, panel=panel) for panel in ("", "frame"))
    assert not asks.is_away(document, closed), "the question keeps the panel closed"
    asks.blocks[0].submit("1")
    assert asks.is_away(document, closed) and not asks.is_away(document, opened)
    turned = replace(look, panes=TURNED)
    assert player.is_away(document, turned)
    seen = player.view_of(player.shown_at(2), turned, other_scene=False)
    assert seen.panes == {}, "a step is seen from its own side"
    posed = set_values(document, ["lens.near=1"])
    player.posed = posed
    assert player.shown_at(2).document == posed and player.shown_at(1).document != posed
    player.turn_to(1)
    assert player.posed is None


def test_a_state_beside_the_step_gives_its_view_back() -> None:
    player = Player(course_of(TALK), 2)
    step = player.shown_at(2)
    look = player.view_of(step, replace(AS_EVER, controls=("near",)), other_scene=False)
    beside = set_values(step.document, ["view.controls=lens.far", "view.large=image"])
    there = player.view_beside(beside, look, other_scene=False)
    assert (there.controls, there.large) == (("lens.far",), "image")
    assert player.is_away(step.document, there)
    assert player.is_away(step.document, replace(there, large="ndc")), "no step sets the controls"
    back = player.view_of(step, there, other_scene=False)
    assert (back.controls, back.large) == (("near",), "ndc")
    there = replace(player.view_beside(beside, look, other_scene=False), controls=("eye",))
    assert player.view_of(step, there, other_scene=False).controls == ("eye",), "chosen by hand"
    assert player.view_of(step, look, other_scene=True).controls == ()
    turned = replace(look, panes=TURNED)
    assert player.view_beside(beside, turned, other_scene=False).panes == TURNED
    assert player.view_beside(beside, turned, other_scene=True).panes == {}
    first = player.view_beside(beside, look, other_scene=False)
    other = set_values(step.document, ["view.controls=lens.near"])
    second = player.read_again(player.course, 2)
    there = second.view_beside(other, first, other_scene=False)
    assert there.controls == ("lens.near",)
    back = second.view_of(step, there, other_scene=False)
    assert back.controls == ("near",), "as before the first of two states, in the changed file, too"
