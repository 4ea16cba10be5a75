"""The health line: silent in everyday cameras, and naming each risk with its figure."""

import math
from dataclasses import replace
from itertools import product

import numpy as np
import pytest

from app.model.depth import DepthBuffer
from app.model.projection import Camera, FreeMatrix, Lens, Orthographic, Perspective, Projection
from app.model.refusal import HEALTH
from app.precision import risks as health
from app.precision.levels import DRAWING_TOLERANCE_PX, Precision, predict
from app.precision.risks import Risk, risks
from app.scenes.scene import BUILT_IN, load
from tests.support.bounds import drawing_bound_px
from tests.support.marked import marked

EVERYDAY = Projection(Camera(), Perspective(45.0, 1.0, 30.0))


def drawn_in(bound_px: float) -> Precision:
    """The cheaper of the two precisions that can be drawn, if what it can lose is not seen."""
    return "float32" if bound_px <= DRAWING_TOLERANCE_PX else "float64"


def found(projection: Projection, size: float = 5.0) -> dict[str, tuple[str, ...]]:
    """The risks' figures by template, with letter F's vertices."""
    scene = load("letter-f")
    predictions = predict(projection, scene.sample, scene.origin)
    half = size / math.sqrt(12.0)  # of a cube of this diagonal round the target
    lower, upper = ((sign * half, 2.2 + sign * half, sign * half) for sign in (-1.0, 1.0))
    drawing_px = drawing_bound_px(projection, scene.boxes.together, scene.origin)
    told = risks(projection, lower, upper, drawn_in(drawing_px), drawing_px, predictions)
    assert {risk.template for risk in told} <= marked(health, context="Health")
    return {risk.template: risk.figures for risk in told}


@pytest.mark.parametrize("name", BUILT_IN)
def test_a_scene_as_it_opens_is_healthy(name: str) -> None:
    scene = load(name)
    predictions = predict(scene.start, scene.sample, scene.origin)
    drawing_px = drawing_bound_px(scene.start, scene.boxes.together, scene.origin)
    told = scene.lower, scene.upper, drawn_in(drawing_px), drawing_px, predictions
    assert risks(scene.start, *told) == []


def test_the_gap_at_the_target_is_that_of_a_24_bit_buffer() -> None:
    # distance^2 / (near 2^24), Akeley and Su: 124.84 / (1e-5 x 16777216) = 0.744
    told = found(replace(EVERYDAY, lens=Perspective(45.0, 1e-5, math.inf)))
    distance = EVERYDAY.camera.distance
    gap = distance**2 / (1e-5 * 2**24)
    assert float(told[HEALTH["wide-gap"]][0]) == pytest.approx(
        gap, rel=0.15
    )  # it adds a code's width
    assert HEALTH["no-gap"] in found(replace(EVERYDAY, lens=Perspective(45.0, 1e-9, math.inf)))


def test_the_gap_is_rounded_up_for_a_smaller_one_is_not_sure() -> None:
    for near in (1.3e-5, 1e-5, 0.7e-5, 0.3e-5):
        lens = Perspective(45.0, near, math.inf)
        told = found(replace(EVERYDAY, lens=lens))[HEALTH["wide-gap"]][0]
        gap = float(DepthBuffer("fixed24", lens=lens).gap(EVERYDAY.camera.distance))
        assert gap <= float(told) < 1.1 * gap and len(told) <= 4


@pytest.mark.parametrize("lens", [Perspective(45.0, 12.5, 30.0), Perspective(45.0, 1e-6, 10.5)])
def test_no_gap_is_reported_for_a_target_outside_the_planes(lens: Lens) -> None:
    told = found(replace(EVERYDAY, lens=lens))
    assert not {HEALTH["wide-gap"], HEALTH["no-gap"], HEALTH["no-picture"]} & set(told)


@pytest.mark.parametrize(
    ("plane", "projection"),
    [
        ("near", replace(EVERYDAY, lens=Perspective(45.0, 20.0, 30.0))),
        ("far", replace(EVERYDAY, lens=Perspective(45.0, 1.0, 5.0))),
        ("near", replace(EVERYDAY, camera=Camera((6, 5, 9), (12, 7.8, 18)))),
        ("right", replace(EVERYDAY, lens=Orthographic(-40, -30, -4, 4))),
        ("bottom", replace(EVERYDAY, lens=Orthographic(-4, 4, 40, 44))),
    ],
)
def test_an_empty_picture_says_why(plane: str, projection: Projection) -> None:
    assert found(projection) == {HEALTH["no-picture"]: (plane,)}


def test_a_picture_beyond_float32_is_reported_without_a_figure() -> None:
    told = found(replace(EVERYDAY, lens=Perspective(1e-80, 1.0, 30.0)))
    assert HEALTH["no-float32"] in told and HEALTH["rough-drawing"] not in told


def test_a_parallel_lens_has_one_gap_everywhere() -> None:
    # 4e6 / 2^24 = 0.238 between codes; as wide again to be sure.
    told = found(replace(EVERYDAY, lens=Orthographic(-4, 4, -4, 4, 1.0, 4e6)))
    assert 0.23 < float(told[HEALTH["wide-gap"]][0]) < 0.49


def test_the_effects_of_vtks_own_camera_are_reported() -> None:
    assert found(replace(EVERYDAY, lens=Perspective(179.5)))[HEALTH["vtk-clamps"]] == ("179",)
    assert found(replace(EVERYDAY, lens=Perspective(1e-9)))[HEALTH["vtk-clamps"]] == ("1e-08",)
    assert HEALTH["vtk-clamps"] not in found(replace(EVERYDAY, lens=Perspective(179.0)))
    near = replace(EVERYDAY, lens=Perspective(45.0, 1e-6, math.inf))
    assert found(near, size=6.0)[HEALTH["vtk-drops"]] == ("6e+06",)
    assert HEALTH["vtk-drops"] not in found(near, size=0.9)


def test_lost_digits_are_counted() -> None:
    # Near and far 1e-9 apart: off the axis the depth keeps 5 decimals or so in float64.
    narrow = Projection(Camera((0.1, 0.3, 11.0)), Perspective(45.0, 9.0, 9.0 * (1 + 1e-9)))
    told = found(narrow)
    scene = load("letter-f")
    errors = predict(narrow, scene.sample, scene.origin)["float64"]
    for decimals, error in zip(told[HEALTH["few-digits"]], errors, strict=True):
        assert 0.05 * 10 ** -int(decimals) < error <= 0.5 * 10 ** -int(decimals)
    assert 4 <= int(told[HEALTH["few-digits"]][1]) <= 6


def test_the_loss_of_float32_is_reported_for_the_whole_picture() -> None:
    far_away = Camera((12345678.9 + 6.0, 5.0, 9.0), (12345678.9, 2.2, 0.0))
    projection = replace(EVERYDAY, camera=far_away)
    lower, upper = (12345678.9 - 2.0, 0.0, -1.0), (12345678.9 + 2.0, 5.0, 1.0)
    corners = np.array(list(product(*zip(lower, upper, strict=True))))
    drawing_px = drawing_bound_px(projection, corners)
    rough = risks(projection, lower, upper, "float64", drawing_px, None)
    (risk,) = rough
    assert risk.template == HEALTH["rough-drawing"] and 1.0 < drawing_px < 1e4
    assert drawing_px <= float(risk.figures[0]) < 1.1 * drawing_px
    assert risk.figures[0].isdecimal() and risk.figures[0].endswith("00")  # two digits, no power
    assert risks(projection, lower, upper, "float32", drawing_px, None) == []


@pytest.mark.parametrize(
    ("rows", "why"),
    [
        (((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, -1, 0)), HEALTH["no-inverse"]),
        (
            ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1e60, 1e-70), (0, 0, -1e-70, 0)),
            HEALTH["large-inverse"],
        ),
        (((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, -1, -2), (0.5, 0, -1, 0)), HEALTH["reaches-infinity"]),
    ],
)
def test_the_reason_for_a_missing_frustum_is_reported(
    rows: tuple[tuple[float, float, float, float], ...], why: str
) -> None:
    told = found(replace(EVERYDAY, lens=FreeMatrix(rows)))  # type: ignore[arg-type]
    reasons = {HEALTH["no-inverse"], HEALTH["large-inverse"], HEALTH["reaches-infinity"]} & set(
        told
    )
    assert reasons == {why}


def test_a_risk_is_a_sentence() -> None:
    assert str(Risk(HEALTH["vtk-clamps"], ("179",))) == (
        "VTK's own camera would clamp the field of view to 179°."
    )
    for template in marked(health, context="Health"):
        assert str(Risk(template, ("1", "2"))).count("{") == 0
