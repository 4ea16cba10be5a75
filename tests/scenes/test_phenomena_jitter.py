"""Jitter: paths of vertices far from the origin, against rationals and pixels done by hand."""

import math
import random
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from app.model.projection import Camera, Perspective
from app.model.refusal import Refusal
from app.scenes.phenomena.jitter import FRAMES, PHENOMENON, STEP, differences, paths_of
from tests.fuzz.jitter import ratios_of
from tests.oracles.illustrations import reading, showing, subject_of, value
from tests.precision.test_drift import nearest

START = PHENOMENON.start
show = showing(PHENOMENON, subject_of(PHENOMENON))
WAYS = ("world", "relative", "two")


def single(value: Fraction | float) -> Fraction:
    """The nearest float32."""
    return nearest(Fraction(value), 24)


def by_hand(way: str, point: float, eye: float, place: float) -> Fraction:
    """One coordinate of a vertex less the eye, in rationals."""
    p, e = Fraction(point + place), Fraction(eye + place)
    if way == "world":
        return single(single(p) - single(e))
    if way == "relative":
        return single(single(point) - single(float(e) - place))
    low = single(p - single(p)), single(e - single(e))
    return single(single(single(p) - single(e)) + single(low[0] - low[1]))


@pytest.mark.parametrize("way", WAYS)
def test_differences_are_those_of_rationals_and_their_bounds_hold(way: str) -> None:
    dice = random.Random(49)
    for _ in range(400):
        place = 10.0 ** dice.uniform(0.0, 9.0)
        point, eye = dice.uniform(-5.0, 5.0), dice.uniform(-15.0, 15.0)
        near, bound = differences(way, np.array([point]), np.array([eye]), np.array([place]))
        assert near[0] == float(by_hand(way, point, eye, place))
        assert abs(Fraction(float(near[0])) - (Fraction(point) - Fraction(eye))) <= float(bound)


def test_the_path_is_that_of_a_camera_that_moves_by_a_millimetre_in_each_frame() -> None:
    vertex = np.array([[0.5, 2.0, 1.0]])
    paths = paths_of(START, vertex, "relative", 5e4)
    u = START.camera.frame[0]
    for frame in (0, 1, FRAMES):
        moved = Camera(
            tuple(START.camera.eye + frame * STEP * u),
            tuple(START.camera.target + frame * STEP * u),
            START.camera.up,
        )
        seen = replace(START, camera=moved)
        assert paths.true[0, frame] == pytest.approx(seen.trace(vertex[0]).image, abs=1e-9)
    assert paths.drawn == pytest.approx(paths.true, abs=5e-4)


def test_far_out_the_eye_jumps_by_the_step_of_float32() -> None:
    """One Earth radius away, x is 3 822 600: its float32 are 1/4 apart, and the eye jumps once."""
    vertex = np.array([[0.5, 2.0, 1.0]])
    place = 6.371e6 * np.array([0.6, 0.64, 0.48])
    eyes = np.array([[[x, 4.5, 9.0]] for x in np.linspace(4.3, 4.6, 50)])
    near, _ = differences("world", vertex, eyes, place)
    assert sorted(set(np.diff(near[:, 0, 0]).tolist())) == [-0.25, 0.0]
    paths = paths_of(START, vertex, "world", 6.371e6)
    jumps = np.linalg.norm(np.diff(paths.drawn[0], axis=0), axis=1)
    assert (jumps > 0.0).sum() == 1


def test_a_jump_is_wrong_by_no_more_than_the_bounds_of_its_frames() -> None:
    assert (ratios_of(random.Random(1), 2000)[0] >= 1.0).all()


def test_the_readings_of_50_kilometres_by_hand() -> None:
    """x is near 30 000 m, where float32 are 1/512 m apart."""
    shown = show()
    eye, target = np.array(START.camera.eye), np.array(START.camera.target)
    points = subject_of(PHENOMENON).points
    n = (eye - target) / np.linalg.norm(eye - target)
    depth = ((eye - points) @ n).min()
    per_metre = 540.0 / math.tan(math.radians(20.0)) / depth
    assert value(shown, "smooth jump") == pytest.approx(0.001 * per_metre, rel=1e-3)
    jump = value(shown, "largest jump")
    assert 0.001 * per_metre < jump < 1.5 * per_metre / 512.0
    assert value(shown, "stands still") > 25.0
    assert value(shown, "measured") <= value(shown, "predicted") < 25.0 * value(shown, "measured")
    mended = show(way="two")
    assert value(mended, "largest jump") == pytest.approx(0.001 * per_metre, rel=2e-3)
    assert value(mended, "stands still") == 0.0


def test_the_path_is_enlarged_as_it_says_and_ends_at_the_frame() -> None:
    for settings in ({}, {"way": "two"}, {"distance": 6.371e6}, {"frame": 7.0}):
        shown: Any = show(**settings)
        times = value(shown, "enlarged")
        true, drawn = (line.points for line in shown.image.lines)
        assert len(drawn) == 1 + settings.get("frame", FRAMES)
        assert len(true) == FRAMES + 1
        per_frame = -value(shown, "smooth jump")
        assert np.diff(true[:, 0]) == pytest.approx(times * per_frame, rel=1e-3)
        assert np.abs(np.diff(drawn[:, 0])).max() <= 1.001 * times * value(shown, "largest jump")
        assert np.diff(drawn[:, 1]) == pytest.approx(0.8 * 1080 / FRAMES)


@pytest.mark.parametrize(
    ("name", "number"), [("distance", 0.0), ("distance", 2e9), ("frame", -1.0), ("frame", 25.0)]
)
def test_what_cannot_be_is_refused_with_field_value_and_bound(name: str, number: float) -> None:
    with pytest.raises(Refusal) as caught:
        PHENOMENON.checked({name: number})
    assert str(caught.value).startswith(f"settings.{name} = {number:.10g}: must be ")


def test_without_a_vertex_in_the_picture_it_says_so() -> None:
    away = replace(START, camera=Camera(START.camera.target, START.camera.eye))
    warning = show(away).warning
    assert warning is not None and "no vertex" in warning.sentence()
    near = replace(START, lens=Perspective(40.0, 1e-6, 100.0))
    assert reading(show(near, distance=1e9), "predicted").note is not None
