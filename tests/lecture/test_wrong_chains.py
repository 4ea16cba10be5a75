"""Wrong chains: each mistake is recognised by what it does, and none in a chain that is right."""

import random
from dataclasses import replace
from itertools import permutations

import pytest
from mpmath import mp

from app.lecture.wrong_chains import (
    MISTAKES,
    Factors,
    difference,
    effect,
    factors_of,
    mistake,
    same,
)
from app.lessons.course import idea_named
from app.model.projection import Camera, Perspective, Projection

INSTANCES = 50
KINDS = {
    "turn-moves": "TRS", "scale-moves": "TSR", "mirror-moves": "TMR", "scale-turned": "TRS",
    "mirror-turned": "TRM", "shear-turned": "TRH", "turns-swapped": "TRQ", "turn-sign": "TRS",
    "move-sign": "TRS", "scale-inverse": "TRS", "degrees": "TRS", "wrong-axis": "TRS",
    "left-out": "TRSQ", "inverse-kept": "TRS", "undone": "TRS", "transposed": "TRS",
    "order": "TRSQ", "row-move": "TRS",
}  # fmt: skip
"""Chains of the object in which a mistake can be made: a letter for each tile."""
OF_PIPELINE = {
    "view-order": "R; P", "axes-columns": "R; P", "model-view": "view; {T}; {R}",
    "projection-first": "projection; view; {T}", "inverse": "projection; view; {T}",
    "z-first": "M_z; M_pp; M_persp", "box-first": "M_z; M_pp; M_persp",
    **dict.fromkeys(
        ("viewport-first", "divide-twice", "no-divide"), "viewport; divide; projection"
    ),
}  # fmt: skip
LETTERS = {"view-order": "004", "axes-columns": "004", "z-first": "001", "box-first": "001"}


def tile(letter: str, chance: random.Random) -> str:
    def number(low: float, high: float) -> str:
        return f"{chance.choice((-1, 1)) * chance.uniform(low, high):.3f}"

    factors = ",".join(f"{chance.uniform(1.2, 3.0):.3f}" for _ in "xyz")
    return {
        "T": f"translate {','.join(number(0.7, 4.0) for _ in 'xyz')}",
        "R": f"rotate {chance.choice('xyz')} {number(15, 75)}",
        "Q": f"rotate 1,2,{number(2, 3)} {number(15, 75)}",
        "S": f"scale {factors}",
        "H": f"shear {chance.choice(('xy', 'yz', 'zx'))} {number(0.4, 2.0)}",
        "M": f"mirror {chance.choice('xyz')}",
    }[letter]


def instance(name: str, seed: int) -> Factors:
    """A right chain in which a mistake can be made, with numbers of its own."""
    chance = random.Random(f"{name} {seed}")
    eye = tuple(chance.uniform(1.0, 6.0) for _ in "xyz")
    lens = Perspective(chance.uniform(30, 100), chance.uniform(0.3, 2.0), chance.uniform(8.0, 40.0))
    at = replace(Projection(), camera=Camera(eye, (-1.0, 0.5, -2.0)), lens=lens)
    if name in KINDS:
        text = "; ".join(tile(letter, chance) for letter in KINDS[name])
    else:
        text = OF_PIPELINE[name].format(T=tile("T", chance), R=tile("R", chance))
    return factors_of(text, at, LETTERS.get(name, "own"))


def test_the_catalogue_has_an_idea_for_each_mistake() -> None:
    assert len(MISTAKES) >= 24
    assert {*KINDS, *OF_PIPELINE} == {*MISTAKES}
    assert [name for name in MISTAKES if idea_named(name) is None] == []


@pytest.mark.parametrize("name", MISTAKES)
def test_a_mistake_is_recognised_in_fifty_random_chains(name: str) -> None:
    for seed in range(INSTANCES):
        right = instance(name, seed)
        wrongs = [
            wrong for wrong in MISTAKES[name](right) if not same(effect(wrong), effect(right))
        ]
        assert wrongs, (name, [each.text for each in right])
        for wrong in wrongs:
            named = mistake(right, wrong)
            assert named == name or _twins(named, name), ([each.text for each in wrong], named)
            assert str(difference(right, wrong)).endswith(".")


def _twins(named: str | None, name: str) -> bool:
    """Whether two mistakes are the same wrong chain: a tile moved past two others."""
    pairs = {"turn-moves", "scale-moves", "mirror-moves", "scale-turned", "mirror-turned",
             "shear-turned", "turns-swapped"}  # fmt: skip
    return {named, name} <= pairs


def test_no_right_chain_is_taken_for_a_wrong_one() -> None:
    """Orders of random chains with a second move: those are right whose product is the same."""
    rights = 0
    for name in KINDS:
        for seed in range(2):
            more = factors_of("translate 1,2,3", Projection(), "own")
            whole = (*instance(name, seed), *more)
            wanted = product(whole)
            for order in [*permutations(whole)][:24]:
                away = max(abs(a - b) for a, b in zip(product(order), wanted, strict=True))
                is_right = mistake(whole, order) is None
                assert is_right == (away < 1e-9) or 1e-9 < away < 0.05
                rights += is_right
    assert rights > 30, rights


def product(chain: Factors) -> list[mp.mpf]:
    """Return the product in 15 digits of another library."""
    whole = mp.eye(4)
    for factor in chain:
        assert factor.matrix is not None
        whole = whole * mp.matrix(factor.matrix.tolist())
    return [*whole]


@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        ("translate 3,0,0; rotate z 90", "rotate z 90; translate 3,0,0",
         "It swings about the origin, and ends 4.243 units away from its place."),
        ("translate 3,0,0; scale 2,1,1", "scale 2,1,1; translate 3,0,0",
         "The origin ends at (6, 0, 0) instead of (3, 0, 0)."),
        ("rotate z 90; scale 2,1,1", "scale 2,1,1; rotate z 90",
         "The x axis becomes (0, 1, 0) instead of (0, 2, 0)."),
        ("projection; view", "view; projection", "The w of a point becomes 3.2 instead of 12.2."),
        ("viewport; divide; projection", "divide; viewport; projection",
         "A point ends at (236.2, 157.5) instead of (483.8, 405)."),
    ],
)  # fmt: skip
def test_one_sentence_says_what_differs(right: str, wrong: str, said: str) -> None:
    lens = Perspective(90.0, 1.0, 9.0)
    at = Projection(Camera((0.0, 0.0, 9.0), (0.0, 0.0, 0.0)), lens, (720, 720))
    one, other = (factors_of(text, at, "own") for text in (right, wrong))
    assert str(difference(one, other)) == said


def test_a_flat_scale_has_a_mistake_too() -> None:
    right = factors_of("translate 3,0,0; scale 0,1,1", Projection(), "own")
    assert mistake(right, right[::-1]) == "scale-moves"
