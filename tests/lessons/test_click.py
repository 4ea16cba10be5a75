"""Answers that are a place in a picture: their format, and what counts as near."""

from functools import partial

import pytest

from app.lessons.blocks.click import Click
from app.lessons.course import AtStep
from tests.support import lessons

STATE = "scene=letter-f\nimage.width=800\nimage.height=400\nlens.near=2\n"
# The middle of the picture is at (400, 200). A small pane shows it 400 px wide: half as large, so a
# click that is 20 pixels of the image away is 10 px away on the screen.
IMAGE = """Where is the middle?
click: image
at: width/2, height/2
within: 12
wrong near-far: 0, 0
  says: That is the upper left.
wrong angle-linear: max(1, width), height
why: Half of both.
"""


faults = partial(lessons.faults, state=STATE)


def question(body: str, test: str = "", kind: str = "answer") -> tuple[Click, AtStep]:
    here = lessons.asked_at(body, test, kind, state=STATE)
    return here.asked["mine"], here  # type: ignore[return-value]


def test_a_click_counts_up_to_its_distance_in_pixels() -> None:
    asked, here = question(IMAGE)
    assert asked.answer(here) == (400.0, 200.0)
    for place, word in (
        ("400 200", "right"), ("423 200", "right"), ("400 176,5", "right"), ("425 200", "wrong"),
        ("417 217", "wrong"), ("10 10", "near-far"), ("799 399", "angle-linear"),
    ):  # fmt: skip
        assert asked.mark(here, place).word == word, place
    assert asked.mark(here, "400 200").says == "Half of both."
    assert asked.solution(here) == (
        "- $x_{\\mathrm{win}} = \\frac{\\mathrm{width}}{2}$ $= \\frac{800}{2}$ $= 400$\n"
        "- $y_{\\mathrm{win}} = \\frac{\\mathrm{height}}{2}$ $= \\frac{400}{2}$ $= 200$"
    )
    assert asked.answer_text(here, "{:g}".format) == "(400, 200)"
    assert asked.printed(["0,5", "200"]) == "(0,5; 200)", "a decimal comma parts no numbers"


def test_the_distance_is_that_of_the_window_if_there_is_one() -> None:
    """With a pane that shows the image three times as large, only 4 pixels of it count."""
    asked, here = question(IMAGE)
    for x, is_right in ((404, True), (404.1, False)):
        away = asked.verdict_at(here, lambda place, x=x: 3.0 * abs(place[0] - x))  # type: ignore[misc]
        assert away.right == is_right


def test_places_in_world_and_cube_have_three_coordinates() -> None:
    cube = "Where?\nclick: ndc\nat: 1, -1, 1/2\nwrong near-far: 1, -1, -1/2\n"
    samples = "mine: 1 -1 0.6 -> right\nmine: 1 -1 0.63 -> wrong\nmine: 1 -1 -.5 -> near-far"
    assert faults(cube, samples) == ""
    world = "Where?\nclick: world\nat: eye_x, eye_y, eye_z\n"
    asked, here = question(world)
    eye = here.document.projection.camera.eye
    assert asked.mark(here, " ".join(map(str, eye))).right
    assert asked.mark(here, "0 0 0").word == "wrong"


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("click: image", "click: film", "line 13 = 'film': must be one of world, ndc, image"),
        ("at: width/2, height/2\n", "", "line 13 needs “at: FORMULA, FORMULA”"),
        ("at: width/2, height/2", "at: width/2", "line 14 = 'width/2': must have 2 coordinates"),
        ("within: 12", "within: 1000", "must be a number from 2 to 100"),
        ("width/2, height/2", "width/2, -1", "line 14 has the place (400, -1), which is not in"),
        ("wrong near-far: 0, 0", "wrong near-far: 400, 240", "line 16 is wrong, but its formula"),
        ("wrong near-far: 0, 0", "wrong near-far: 780, 380", "from the wrong value of line 16"),
        ("wrong near-far: 0, 0", "wrong near-far: 0", "must have 2 coordinates"),
        ("at: width/2", "at: widht/2", "unknown name, widht"),
    ],
)
def test_a_faulty_question_is_refused_with_its_line(old: str, new: str, said: str) -> None:
    assert old in IMAGE and faults(IMAGE) == ""
    assert said in faults(IMAGE.replace(old, new))


def test_a_sample_has_the_coordinates_of_the_click() -> None:
    assert faults(IMAGE, "mine: 400 210 -> right\nmine: 0 5 -> near-far") == ""
    assert "must be 2 coordinates, separated by spaces" in faults(IMAGE, "mine: 400 -> right")


def test_an_exercise_uses_no_variant_whose_places_are_too_close() -> None:
    body = (
        "vary x: 0..790 step 10\nWhere is x = {=x}?\nclick: image\nat: x, 200\n"
        "wrong near-far: 800 - x, 200\n"
    )
    asked, here = question(body, kind="exercise")
    for seed in range(1, 60):
        variant = asked.variant(here, seed)  # type: ignore[attr-defined]
        x = float(variant.numbers["x"])
        assert abs(800 - 2 * x) / 2 >= 24, "twice 12 px, in a pane that shows it half as large"
    assert faults(body, "", "exercise") == ""
