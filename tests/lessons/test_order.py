"""Answers that are a chain of tiles: how they are read, mixed, marked, shown and printed."""

import re

import numpy as np
import pytest

from app.lessons.blocks.order import OrderQuestion
from app.lessons.contents import contained
from app.lessons.course import AtStep, Course
from app.lessons.lesson import read
from app.lessons.practice import exercises_of
from app.model.chain import Chain
from app.model.refusal import Refusal
from tests.support import lessons

ORDER = "order object: translate 3,0,0; rotate z 90; scale 2,1,1"
RIGHT = "translate 3,0,0; rotate z 90; scale 2,1,1"


def shown(state: str) -> str:
    return f"scene=letter-f\n{state}\n"


def question(
    body: str, test: str = "", kind: str = "answer", state: str = "lens.near=1"
) -> tuple[OrderQuestion, AtStep]:
    here = lessons.asked_at(f"Which?\n{body}\n", test, kind, state=shown(state))
    variant = here.asked["mine"].variant(here, 1)
    assert isinstance(variant.question, OrderQuestion) and isinstance(variant.here, AtStep)
    return variant.question, variant.here


def faults(body: str, test: str = "", kind: str = "answer", state: str = "lens.near=1") -> str:
    return lessons.faults(f"Which?\n{body}\n", test, kind, state=shown(state))


def test_the_tiles_are_mixed_and_the_object_stands_where_the_product_puts_it() -> None:
    asked, here = question(ORDER)
    assert sorted(asked.tiles) == sorted(RIGHT.split("; ")) and "; ".join(asked.tiles) != RIGHT
    placement = here.document.projection.placement
    assert [tile.kind for tile in placement.tiles] == ["matrix"], "the tiles are not told"
    assert np.allclose(placement.matrix, Chain.read(RIGHT).matrix, atol=1e-12)
    assert ": rotation about z 90°\n" in asked.posed(), "in words, with a letter to write"


@pytest.mark.parametrize(
    ("typed", "word"),
    [
        (RIGHT, "right"),
        ("translate 3,0,0; rotate z 90.001; scale 2,1,1", "right"),
        ("off mirror x; translate 3,0,0; rotate z 90; scale 2,1,1", "right"),
        ("translate 3,0,0; scale 1,2,1; rotate z 90", "right"),  # another way to the same product
        ("rotate z 90; translate 3,0,0; scale 2,1,1", "turn-moves"),
        ("translate 3,0,0; scale 2,1,1; rotate z 90", "scale-turned"),
        ("translate 3,0,0; rotate z -90; scale 2,1,1", "turn-sign"),
        ("translate -3,0,0; rotate z 90; scale 2,1,1", "move-sign"),
        ("translate 3,0,0; off rotate z 90; scale 2,1,1", "left-out"),
        ("scale 2,1,1; rotate z 90; translate 3,0,0", "order"),
        ("translate 3,0,0; rotate z 57; scale 2,1,7", "wrong"),
    ],
)
def test_a_chain_is_marked_by_what_it_does(typed: str, word: str) -> None:
    asked, here = question(ORDER)
    verdict = asked.mark(here, typed)
    assert verdict.word == word
    if not verdict.right:
        assert verdict.remark is not None and str(verdict.remark).endswith(".")
        assert verdict.state is not None and verdict.beside is not None
        given = verdict.state.projection.placement.matrix
        assert np.allclose(given, Chain.read(typed).matrix, atol=1e-9)
        assert [picture.live for picture in verdict.beside.view.compare] == [False, True]
        assert bool(verdict.title) == (word != "wrong")


def test_what_cannot_be_read_costs_no_try_and_a_flat_object_has_no_picture() -> None:
    asked, here = question(ORDER)
    for typed in ("translate 3,0,0; rotate z", "translate 3,0,0; fly 3", "rotate z nan"):
        with pytest.raises(Refusal) as refusal:
            asked.mark(here, typed)
        assert refusal.value.field == "answer"
    flat = asked.mark(here, "translate 3,0,0; rotate z 90; scale 0,1,1")
    assert flat.word == "wrong" and flat.beside is None


@pytest.mark.parametrize(
    ("order", "typed", "word"),
    [
        ("order view: rotation; translation", "translation; rotation", "view-order"),
        ("order projection: projection", "projection^-1", "undone"),
        ("order: viewport; divide; projection", "divide; viewport; projection", "viewport-first"),
        ("order: divide; projection; view", "divide; xyz/w; projection; view", "divide-twice"),
    ],
)
def test_the_pipeline_is_a_chain_too(order: str, typed: str, word: str) -> None:
    asked, here = question(order)
    assert asked.mark(here, asked.chain).right
    verdict = asked.mark(here, typed)
    assert verdict.word == word
    before = here.document.projection
    if asked.product:
        assert verdict.state is not None and verdict.state.projection != before
    else:
        assert verdict.beside is None


def test_the_answer_the_mistakes_and_the_way_are_told() -> None:
    asked, here = question(ORDER)
    answer = asked.answer_text(here, str)
    assert answer == "translation (3, 0, 0) · rotation about z 90° · scale (2, 1, 1)"
    letters = dict(re.findall("- (.): (.*)", asked.posed()))
    told = asked.with_answer(answer)
    assert all(f"{letter}: {title}" in told for letter, title in letters.items())
    assert asked.shape == (1, 3)
    mistakes = dict(asked.mistakes(here, str))
    wrong = [letters[each] for each in mistakes["First the move, then the turn"].split(" · ")]
    assert wrong[:2] == ["rotation about z 90°", "translation (3, 0, 0)"]
    way = asked.solution(here).split("\n")  # (1, 0, 0) -> (2, 0, 0) -> (0, 2, 0) -> (3, 2, 0)
    assert [line.rpartition("$(")[2] for line in way] == [
        "1, 0, 0)$", "2, 0, 0)$", "0, 2, 0)$", "3, 2, 0)$"
    ]  # fmt: skip
    asked, here = question("order: viewport; divide; projection")
    assert "inf" not in asked.solution(here), "the point is in front of the eye"


def test_the_key_has_each_right_order_and_a_sheet_leaves_room_for_numbers() -> None:
    asked, here = question(
        "order: divide; translate 1,2,0; scale 2,2,2\ntiles: rotate z 0; divide; scale 2,2,2"
        "; translate 1,2,0"
    )
    orders = asked.answer_text(here, str).split(" = ")
    move, scale = "translation (1, 2, 0)", "scale (2, 2, 2)"
    assert {*orders} == {
        f"division by w · {move} · {scale}", f"{move} · division by w · {scale}",
        f"{move} · {scale} · division by w",
    }  # fmt: skip
    assert re.search("- .: rotation about z\n", asked.posed() + "\n"), "the student types 0"
    assert r"$M_{\mathrm{pp}}$" in question("order projection: M_z; M_pp; M_persp")[0].posed()


@pytest.mark.parametrize(
    ("body", "state", "said"),
    [
        ("order object: translate 1,0,0; translate 2,0,0", "lens.near=1", "same in every order"),
        ("order sky: rotate z 1; mirror x", "lens.near=1", "object, view, projection"),
        ("order view: rotate z 1; translate 1,0,0", "lens.near=1", "another view_from_world"),
        ("order object: rotate z; mirror x", "lens.near=1", "numbers after rotate z, 1 in all"),
        ("order: M_qq; view", "lens.near=1", "no matrix 'M_qq'"),
        (
            "order: view; divide\ntiles: veiw; view; divide",
            "",
            "line 11, answer = 'veiw': must name",
        ),
        ("order: view; xyz/w\ntiles: view; divide", "", "line 11 needs xyz/w among its tiles"),
        ("order: mirror x; mirror x; view\ntiles: mirror x; view", "", "needs mirror x among"),
        ("order view: rotation; translation\nvalue: 3", "lens.near=1", "keep one of"),
        (f"order: {'; '.join(['rotate z 1', 'rotate x 1'] * 4)}", "", "at most 6 tiles, but has 8"),
        (
            f"order: view; divide\ntiles: {'; '.join(['divide'] * 11)}",
            "",
            "at most 10 tiles, but has 11",
        ),
    ],
)
def test_a_wrong_order_of_an_author_is_refused(body: str, state: str, said: str) -> None:
    assert said in faults(body, "", "answer", state)


def test_samples_name_the_wrong_order() -> None:
    test = "mine: {} -> right\nmine: rotate z 90; translate 3,0,0; scale 2,1,1 -> turn-moves"
    state = f"object.chain={RIGHT}"
    assert faults(ORDER, test.format(RIGHT), "answer", state) == ""
    said = faults(ORDER, test.format("mirror x"), "answer", state)
    assert "right" in said


def test_an_exercise_draws_its_tiles() -> None:
    body = "vary m: 1..30\norder object: translate {=m},0,0; rotate z {=m/3}"
    sample = "mine: 1 {} -> right"
    first = question(body, "", "exercise")[0]
    assert faults(body, sample.format(first.chain), "exercise") == ""
    assert question(body, "", "exercise")[0].chain == first.chain


def test_the_variants_of_the_exercises_of_four_lessons_have_the_product() -> None:
    """Their object, view or lens; and the tiles as they are mixed are not right."""
    counted = dict[str, int]()
    for path in contained():
        for placed in exercises_of(Course(read(path))):
            if not isinstance(placed.exercise.first, OrderQuestion):  # type: ignore[attr-defined]
                continue
            topic = placed.course.lesson.topics[0]
            counted[topic] = counted.get(topic, 0) + 1
            for seed in range(5, 101, 5):
                variant = placed.with_numbers(seed)  # whose values are checked as it is made
                asked, here = variant.question, variant.here
                assert isinstance(asked, OrderQuestion)
                assert asked.mark(here, asked.chain).right
                assert not asked.mark(here, "; ".join(asked.tiles)).right
    assert sorted(counted) == ["L1", "L13", "L2", "L9"] and min(counted.values()) >= 3
