"""Cracks: gaps and their bound against rationals, and a common grid that closes them."""

import math
from dataclasses import replace
from fractions import Fraction

import mpmath
import numpy as np
import pytest

from app.measure.cracks import measure
from app.model.projection import Array, Camera, Projection
from app.model.refusal import Refusal
from app.scenes.phenomena.cracks import PHENOMENON, SEAM, SIZES
from tests.oracles.illustrations import showing, subject_of, value

START = PHENOMENON.start
AT_FIVE = replace(START, camera=Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0)))
shown = showing(PHENOMENON, subject_of(PHENOMENON))


def test_the_boxes_are_as_wide_as_the_page_says() -> None:
    settings = PHENOMENON.checked({})
    assert (settings["left"], settings["right"]) == SIZES


def nearest(value: float, lower: float, step: Fraction) -> Fraction:
    """The place of a grid that is nearest to a coordinate."""
    return Fraction(lower) + step * round((Fraction(value) - Fraction(lower)) / step)


def gaps_by_hand(bits: int, distance: float) -> list[mpmath.mpf]:
    """In rationals: both copies of each vertex of the seam, and their distance in px."""
    lowers = float(SEAM[:, 0].max()) - SIZES[0], float(SEAM[:, 0].min())
    steps = [Fraction(size) / (2**bits - 1) for size in SIZES]
    gaps = []
    with mpmath.workdps(30):
        per_unit = 1080 / (2 * mpmath.mpf(distance) * mpmath.tan(mpmath.pi / 6))
        for x, y, _ in SEAM.tolist():
            off = [nearest(x, low, step) for low, step in zip(lowers, steps, strict=True)]
            up = [nearest(y, float(SEAM[0, 1]), step) for step in steps]
            across, along = (float(one - other) for one, other in (off, up))
            gaps.append(per_unit * mpmath.hypot(across, along))
    return gaps


@pytest.mark.parametrize("bits, told", [(8, 6.74), (12, 0.4199), (16, 0.02624)])
def test_the_gaps_are_those_of_rationals_and_below_the_bound(bits: int, told: float) -> None:
    illustration = shown(AT_FIVE, bits=str(bits))
    gaps = gaps_by_hand(bits, 5.0)
    (diagram,) = illustration.diagrams
    assert diagram.curves[0].points[:, 1] == pytest.approx(np.array(gaps, float), abs=1e-6)
    assert value(illustration, "measured") == pytest.approx(float(max(gaps)), abs=1e-6)
    a, b = (size / (2**bits - 1) for size in SIZES)
    bound = math.sqrt(2) * (a + b) / 2 * 1080 / (10 * math.tan(math.pi / 6))
    assert value(illustration, "predicted") == pytest.approx(bound, rel=1e-6)
    assert bound == pytest.approx(told, rel=1e-3) and float(max(gaps)) < bound


def test_a_common_grid_closes_the_seam_and_moves_vertices_farther() -> None:
    own, common = shown(), shown(grid="common")
    assert value(common, "measured") == value(common, "predicted") == 0.0
    assert value(common, "moves") > 2.0 * value(own, "moves")


def seam_of(illustration_of: Projection, **settings: object) -> Array:
    vertices = shown(illustration_of, **settings).vertices
    assert vertices is not None and (vertices.stored == vertices.projected).all()
    return vertices.stored[:-4].reshape(2, 2, -1, 3)[:, 1]


def test_the_picture_has_both_copies_of_each_vertex() -> None:
    left, right = seam_of(START)
    step = 10.0 / 255.0
    assert np.abs(left - SEAM).max() <= step / 2.0 + 1e-12
    assert np.abs(right - SEAM).max() <= 3.0 / 255.0 / 2.0 + 1e-12
    gaps = np.hypot(*(START.trace(left).image - START.trace(right).image).T)
    assert gaps.max() == pytest.approx(value(shown(), "measured"))


def test_bad_input_is_said_in_one_sentence() -> None:
    inside = replace(START, camera=Camera((0.0, 0.0, 0.0), (0.0, 0.0, -1.0)))
    behind = replace(START, camera=Camera((0.0, 0.0, -2.0), (0.0, 0.0, -3.0)))
    for projection in (inside, behind):
        warning = shown(projection).warning
        assert warning is not None and "the eye lies in the seam" in warning.sentence()
    for name, size in (("left", 0.0), ("right", 0.0), ("left", 1e9), ("right", math.nan)):
        with pytest.raises(Refusal, match=rf"settings\.{name} = "):
            PHENOMENON.checked({name: size})


def test_the_trade_measures_what_the_scene_shows() -> None:
    """At the target, 5 units away, as the seam is in the scene."""
    choices = {
        (c.use["settings.bits"], c.use["settings.grid"]): c for c in measure(AT_FIVE).choices
    }
    assert len(choices) == 6
    for (bits, grid), choice in choices.items():
        illustration = shown(AT_FIVE, bits=bits, grid=grid)
        assert choice.error == pytest.approx(value(illustration, "measured"), abs=1e-9)
        assert choice.predicted == pytest.approx(value(illustration, "predicted"), rel=1e-8)
        assert choice.error is not None and choice.predicted is not None
        assert choice.error <= choice.predicted
        assert choice.cost == value(illustration, "bytes")
