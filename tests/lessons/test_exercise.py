"""Exercises: numbers drawn by a seed, and the question that they make."""

import math
from fractions import Fraction

import pytest

from app.document.settings import set_values
from app.lessons.blocks.exercise import Exercise, written_number
from app.lessons.blocks.task import Task
from app.lessons.blocks.working import working
from app.lessons.course import AtStep
from app.model.formula import parse
from app.model.refusal import Refusal
from tests.support import lessons
from tests.support.exercises import WIDE

HALVED = f"{WIDE}why: Its half is {{=fov/2}}°.\n"
SET = """vary q: 30..120 step 2
state: lens.fov_y_deg=20
Make the picture {=q}° wide.
until: fov_x = q
"""


BY_IDEA = """right: lens.fov_y_deg={=2*atan(9/16*tan(q/2))}
wrong fov-xy: fov = q
wrong mine: fov_x < 10
  says: That is narrow.
why: It is ${~q/7}$ or ${~q}$.
"""


def exercise(body: str, test: str = "") -> tuple[Exercise, AtStep]:
    here = lessons.asked_at(body, test, "exercise")
    asked = here.asked["mine"]
    assert isinstance(asked, Exercise)
    return asked, here


def faults(body: str, test: str = "") -> str:
    return lessons.faults(body, test, "exercise")


def test_a_seed_gives_the_same_numbers_everywhere_and_another_one_others() -> None:
    asked, here = exercise(HALVED)
    one = asked.variant(here, 1)
    assert one.numbers == {"fov": 30, "a": 2} == asked.variant(here, 1).numbers
    assert len({tuple(asked.variant(here, seed).numbers.values()) for seed in range(1, 201)}) > 60


def test_state_text_and_formulas_use_the_numbers() -> None:
    asked, here = exercise(HALVED)
    for seed in range(1, 30):
        variant = asked.variant(here, seed)
        fov, a = (float(variant.numbers[name]) for name in ("fov", "a"))
        lens = variant.here.document.projection.lens
        assert lens.fov_y_deg == fov
        width, height = variant.here.document.projection.image_size
        assert (width, height) == (720 * a, 720)
        wide = math.degrees(2 * math.atan(a * math.tan(math.radians(fov / 2))))
        assert wide < 150
        mark = variant.question.mark  # type: ignore[union-attr]
        assert mark(variant.here, f"{wide:.4g}").right
        assert mark(variant.here, f"{a * fov:.4g}").idea == "angle-linear"
        assert f"{fov:g}° high and {written_number(variant.numbers['a'])} times" in (
            variant.question.text
        )
        assert variant.question.why == f"Its half is {fov / 2:g}°."


def test_the_exercises_own_lines_continue_on_indented_ones() -> None:
    body = HALVED.replace("; image.width", ";\n  image.width").replace(", 1.5,", ",\n  1.5,")
    (asked, here), (before, there) = exercise(body), exercise(HALVED)
    for seed in range(1, 9):
        one, other = asked.variant(here, seed), before.variant(there, seed)
        assert one.here.document == other.here.document
        assert one.question.text == other.question.text


def test_a_task_of_an_exercise_is_done_in_the_window() -> None:
    asked, here = exercise(SET)
    variant = asked.variant(here, 5)
    assert isinstance(variant.question, Task)
    q = float(variant.numbers["q"])
    own = variant.here.document
    assert own.projection.lens.fov_y_deg == 20.0
    width, height = own.projection.image_size
    fov = math.degrees(2 * math.atan(math.tan(math.radians(q / 2)) * height / width))
    assert not variant.question.is_done(variant.here, own)
    assert asked.verdict(here, f"5 lens.fov_y_deg={fov}", 1) == "done"
    assert asked.verdict(here, f"6 lens.fov_y_deg={fov}", 1) == "open"


def test_a_task_names_the_wrong_idea_behind_what_was_done() -> None:
    asked, here = exercise(SET + BY_IDEA)
    variant = asked.variant(here, 5)
    q, task = float(variant.numbers["q"]), variant.question
    assert isinstance(task, Task) and task.why == rf"It is $\approx {q / 7:.4g}$ or $= {q:g}$."
    for fov, word in ((q, "fov-xy"), (q - 5, "open"), (2, "mine")):
        assert asked.verdict(here, f"5 lens.fov_y_deg={fov}", 1) == word
    assert task.right is not None
    assert task.is_done(variant.here, variant.here.shown_by(task.right))
    samples = f"mine: 5 lens.fov_y_deg={q} -> fov-xy"
    assert faults(SET + BY_IDEA, samples) == (
        "l.md: line 12 = 'fov_x < 10': is the verdict of no sample in a “test”."
    )
    assert faults(SET + BY_IDEA, f"{samples}\nmine: 5 lens.fov_y_deg=2 -> mine") == ""
    assert "does not fulfil the task" in faults(SET + BY_IDEA.replace("9/16", "9/15"), samples)
    assert "finds no numbers that suit" in faults(SET + BY_IDEA.replace("fov_x < 10", "fov_x > 10"))
    assert "has no “says:” of its own" in faults(SET + BY_IDEA.replace("  says", "hint"), samples)


COUNT = """vary b: 8..40
How many codes has a number of 10 bits, and {=b} more?
count: 2^10 - 1 + b
wrong one-more: 2^10 + b
  says: The first code is 0.
"""


def test_a_count_is_exact_and_whole() -> None:
    asked, here = exercise(COUNT)
    variant = asked.variant(here, 1)
    right = 1023 + int(variant.numbers["b"])
    for typed, word in (
        (f"{right}", "right"), (f"{right + 1}", "one-more"), (f"{right - 1}", "wrong"),
        (f"{right}.0", "right"), (f"{right // 10}e1", "wrong"), ("1000", "wrong"),
        (f"2^10 - 1 + {right - 1023}", "right"), (f"{right}.5", "no number"),
    ):  # fmt: skip
        assert asked.verdict(here, f"1 {typed}", 1) == word, typed
    with pytest.raises(Refusal, match="must be a whole number: the question asks for a count"):
        variant.question.mark(variant.here, f"{right}.5")  # type: ignore[union-attr]
    assert "counts something, but its value is" in faults(COUNT.replace("2^10 - 1", "2^10/7"))
    far = COUNT.replace("2^10", "2^40")
    asked, here = exercise(far)
    assert (
        asked.verdict(here, f"1 {2**40 + int(asked.variant(here, 1).numbers['b'])}", 1)
        == "one-more"
    )
    # Without the word it is a number to three digits, so that the idea could not be told apart.
    assert "finds no numbers that suit" in faults(COUNT.replace("count:", "value:"))


SHORT = """vary k: 1..40
Which part of {=k}?
value: 0.0412
wrong order: 0.0305
wrong mirror: 0.0395
"""


def test_a_wrong_number_with_too_few_digits_is_still_that_of_its_idea() -> None:
    in_matrix = SHORT.replace("value: 0", "matrix: 1, 0").replace(": 0.03", ": 1, 0.03")
    for body, cell in ((SHORT, ""), (in_matrix, "1 | ")):
        asked, here = exercise(body)
        variant = asked.variant(here, 1)
        for typed, word, too_short in (
            ("0.03", "order", False), ("0.031", "order", False), ("0.0305", "order", False),
            ("0.04", "wrong", False), ("0.0395", "mirror", False), ("0.041", "wrong", True),
            ("0.02", "wrong", False),
        ):  # fmt: skip
            verdict = variant.question.mark(variant.here, cell + typed)  # type: ignore[union-attr]
            assert (verdict.word, verdict.too_short) == (word, too_short), typed


def test_a_wrong_number_that_can_be_set_is_shown_beside_the_models() -> None:
    asked, here = exercise(f"{WIDE}number: fov_x\n")
    shown = 0
    for seed in range(1, 60):
        variant = asked.variant(here, seed)
        fov, a = (float(variant.numbers[name]) for name in ("fov", "a"))
        verdict = variant.question.mark(variant.here, f"{a * fov:.5g}")  # type: ignore[union-attr]
        assert verdict.idea == "angle-linear"
        assert (verdict.beside is None) is (a * fov >= 180)
        if verdict.beside is not None:
            shown += 1
            own = variant.here.document
            assert verdict.beside.projection == own.projection, (
                "the model's picture is the live one"
            )
            yours, model = verdict.beside.view.compare
            assert (yours.name, model.name, model.live) == ("your idea", "the model", True)
            known = here.quantities(set_values(own, yours.changes))
            assert known["fov_x"] == pytest.approx(a * fov) and known["aspect"] == a
    assert 20 < shown < 59
    assert variant.question.mark(variant.here, "1").beside is None  # type: ignore[union-attr]


def test_the_number_of_an_answer_is_one_that_can_be_set() -> None:
    for name, said in (
        ("near", "must be a number of the model that can be set, and the answer; it is"),
        ("aspect", "must be a number of the model that can be set"),
        ("fow_x", "unknown name, fow_x; the nearest is fov_x"),
    ):
        found = faults(f"{WIDE}number: {name}\n")
        assert said in found and "line " in found, found
    assert faults(f"{WIDE}number: fov_x\n") == ""


def test_numbers_do_not_suit_where_a_wrong_idea_is_right() -> None:
    # With a = 1 the wrong value is the right one, for every angle.
    asked, here = exercise(HALVED.replace("vary a: 4/3,", "vary a: 1, 4/3,"))
    assert all(asked.variant(here, seed).numbers["a"] != 1 for seed in range(1, 100))
    only = HALVED.replace("vary a: 4/3, 16/9, 2, 1.5, 5/2", "vary a: 1")
    with pytest.raises(Refusal, match="finds no numbers that suit, for seed 1"):
        exercise(only)[0].variant(here, 1)


def test_samples_begin_with_their_seed() -> None:
    assert faults(HALVED, "mine: 1 56.4 -> right\nmine: 1 60 -> angle-linear") == ""
    asked, here = exercise(HALVED)
    fov, a = asked.variant(here, 2).numbers.values()
    said = f"gets “wrong” instead of “right”; this variant has fov = {fov}, a = {float(a):g}"
    assert said in faults(HALVED, "mine: 2 56.4 -> right")
    assert "must begin with a seed" in faults(HALVED, "mine: 112.6 -> right")
    assert "must begin with a seed" in faults(HALVED, "mine: 10000 1 -> right")


def test_the_solution_has_letters_then_numbers_then_the_value() -> None:
    asked, here = exercise(HALVED)
    variant = asked.variant(here, 3)
    assert variant.question.solution(variant.here) == (  # type: ignore[union-attr]
        r"$2 \, \arctan\left(a \, \tan\left(\frac{\mathrm{fov}}{2}\right)\right)$ "
        r"$\approx 2 \, \arctan\left(1.333 \, \tan\left(\frac{70^{\circ}}{2}\right)\right)$ "
        r"$\approx 86.07^{\circ}$"
    )


def test_the_solution_has_whole_numbers_with_all_their_digits() -> None:
    asked, here = exercise("vary m: 16777215 .. 16777240\nHow many over three?\nvalue: m/3\n")
    variant = asked.variant(here, 1)
    (m,) = map(int, variant.numbers.values())
    solution = variant.question.solution(variant.here)  # type: ignore[union-attr]
    assert rf"\frac{{{m}}}{{3}}" in solution


def test_a_solution_is_typeset_for_a_reader() -> None:
    _, here = exercise(HALVED)
    known = here.varied(None, {"x": -3.0, "a": 30.0, "w": 3.0, "tiny": 2.5e-7}).quantities()
    for text, tex in (
        ("sin(90 - a)", r"\sin\left(90^{\circ} - a\right)"
                        r" = \sin\left(90^{\circ} - 30^{\circ}\right) \approx 0.866"),
        ("tan(2*a)*w", r"\tan\left(2a\right) \, w = \tan\left(2 \cdot 30^{\circ}\right) \cdot 3"
                       r" \approx 5.196"),
        ("2 + cos(-60)*x", r"2 + \cos\left(-60^{\circ}\right) \, x"
                           r" = 2 + \cos\left(-60^{\circ}\right) \, (-3) = 0.5"),
        ("w/4*(x - 1/w)", r"\frac{w}{4} \, \left(x - \frac{1}{w}\right)"
                          r" = \frac{3}{4} \, \left(-3 - \frac{1}{3}\right) = -2.5"),
        ("w*x", r"w \, x = 3 \cdot (-3) = -9"), ("tiny", r"tiny = 0.00000025 = 2.5 \cdot 10^{-7}"),
        ("world_from_object(0, 2) + w", "m_{13} + w = 0 + 3 = 3"),
    ):  # fmt: skip
        way = working(parse(text), known)
        assert way is not None
        assert " ".join(way.sides()).replace(r"\mathrm{tiny}", "tiny") == tex
    assert way.sides("x'", "cm") == ["x' = m_{13} + w", "= 0 + 3", r"= 3\ \mathrm{cm}"]
    for text, sides in (("w", ["w", "= 3"]), ("4", ["w = 4"])):
        way = working(parse(text), known)
        assert way is not None and way.sides("w") == sides
    for text in ("was_near + w", "view_z(2) + w", "reading_sharp_to"):
        assert working(parse(text), known) is None
    named, here = exercise("vary near: 1..9 step 0.3\nHow far?\nvalue: z' = near/7\n")
    variant = named.variant(here, 1)
    solution = variant.question.solution(variant.here)  # type: ignore[union-attr]
    assert solution.startswith(r"$z' = \frac{\mathrm{near}}{7}$ $= ")


def test_a_number_has_any_letter_of_a_lecture() -> None:
    asked, here = exercise(
        "vary D: 3..12\nvary θ_v: 20..100 step 5\nHalf of {=θ_v}°, at {=D}?\nvalue: D*tan(θ_v/2)\n"
    )
    variant = asked.variant(here, 1)
    solution = variant.question.solution(variant.here)  # type: ignore[union-attr]
    assert solution.startswith(r"$D \, \tan\left(\frac{\theta_{v}}{2}\right)$ ")


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("vary fov: 20..100 step 5\nvary a: 4/3, 16/9, 2, 1.5, 5/2\n", "", "needs “vary NAME"),
        ("20..100 step 5", "100..20", "must be a range like 20..100 step 5"),
        ("20..100 step 5", "20..100 step 0", "must be a range"),
        ("20..100 step 5", "20..100 step 1/50", "has 4001 values; the limit is 1000"),
        ("20..100 step 5", "twenty", "unknown name, twenty"),
        ("20..100 step 5", "1/0", "divides by zero"),
        ("vary a:", "vary fov:", "varies fov twice"),
        ("{=720*a}", "{=720*b}", "unknown name, b; the nearest is fov, a"),
        ("lens.fov_y_deg={=fov}", "lens.fov_y_deg={=9*fov+1000}", "finds no numbers that suit"),
        ("20..100 step 5", "20..30 step 10", "has too few variants, about 10; it needs at"),
        ("where: fov_x < 150", "where: fov_x", "must be a condition"),
        ("value: 2*atan(a*tan(fov/2))", "value: 2*atan(a*tan(fow/2))", "unknown name, fow"),
        ("where: fov_x", "wher: fov_x", "must be one of vary, where, state, hide, a colon"),
        ("state: lens", "stat: lens", "must be one of vary, where, state, hide, a colon"),
        ("value: 2", "hid: numbers\nvalue: 2", "must be one of vary, where, state, hide, a colon"),
        ("{=fov}° high", "{=fov° high", "= '{=fov° high and {=a} times"),
        ("How wide is its angle?", "How wide, by {=a", "needs “{=FORMULA}”"),
    ],
)
def test_a_faulty_exercise_is_refused_with_its_line(old: str, new: str, said: str) -> None:
    assert old in HALVED
    found = faults(HALVED.replace(old, new))
    assert said in found and "line " in found


def test_numbers_are_written_for_a_reader() -> None:
    for value, text in (
        (Fraction(1, 2), "0.5"), (Fraction(4, 3), "4/3"), (Fraction(-7), "-7"),
        (Fraction(math.pi), "3.142"), (Fraction(24, 13), "1.846"), (Fraction(1, 8), "0.125"),
        (Fraction(20, 7), "2.857"), (Fraction(16, 9), "16/9"),
    ):  # fmt: skip
        assert written_number(value) == text


FILM = """vary d: 2..6 step 0.1
state: scene=camera-obscura; settings.distance={=d}
The arrow is 5 high and 9 away, the film {=d} behind the hole. How high is the picture?
value: 5*d/9
"""


def test_an_answer_that_the_scene_shows_must_be_hidden() -> None:
    assert exercise(FILM)[0].hides == frozenset()
    assert "line 5 has an answer that the scene shows as “film in front”" in faults(FILM)
    assert faults(FILM + "hide: numbers\n") == ""
    assert faults(FILM.replace("5*d/9", "5*d/8")) == ""
    assert exercise(FILM + "hide: world, numbers\n")[0].hides == {"world", "numbers"}
    assert "line 10 = 'film': must be one of numbers, lens, scale, world, ndc, image" in faults(
        FILM + "hide: film\n"
    )
