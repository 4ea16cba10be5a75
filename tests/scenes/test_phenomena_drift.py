"""Drift: what is drawn and read, against turns in rationals and pixels done by hand."""

import math
from dataclasses import replace

import numpy as np
import pytest

from app.model.projection import Camera, Perspective
from app.model.refusal import Refusal
from app.precision.drift import drifted
from app.scenes.phenomena.drift import PHENOMENON
from app.scenes.scene import load
from tests.oracles.illustrations import reading, showing, subject_of, value, why
from tests.precision.test_drift import by_hand
from tests.support.drawings import figure_of

START = PHENOMENON.start
SUBJECT = subject_of(PHENOMENON)
show = showing(PHENOMENON, SUBJECT)


def test_half_floats_drift_by_what_rationals_by_hand_say() -> None:
    axes = np.array(by_hand("float16", 360), dtype=np.float64)
    shown = show(rounds=1, numbers="float16", way="products")
    lengths = np.abs(np.sqrt((axes * axes).sum(axis=1)) - 1.0)
    assert value(shown, "too long") == pytest.approx(100.0 * lengths.max(), rel=1e-9)
    turned = [math.degrees(math.acos(axes[i, i] / np.linalg.norm(axes[i]))) for i in range(3)]
    assert value(shown, "leans") == pytest.approx(max(turned), rel=1e-6)
    eye, frame = np.array(START.camera.eye), START.camera.frame
    q = (SUBJECT.points - eye) @ frame.T
    per_unit = START.image_size[1] / 2.0 / math.tan(math.radians(20.0))
    pixels = [per_unit * each[:, :2] / each[:, 2:] for each in (q, q @ axes.T)]
    largest = np.linalg.norm(pixels[1] - pixels[0], axis=1).max()
    assert value(shown, "measured") == pytest.approx(largest, rel=1e-9)


@pytest.mark.parametrize("way", ["products", "renormalised", "fast", "sines"])
@pytest.mark.parametrize("numbers", ["float16", "float32", "float64"])
def test_no_error_is_larger_than_its_bound(numbers: str, way: str) -> None:
    for rounds in (1, 3, 10):
        shown = show(rounds=rounds, numbers=numbers, way=way)
        predicted = reading(shown, "predicted").value
        if predicted is None:
            assert "behind the camera" in why(shown, "predicted")
        else:
            assert value(shown, "measured") <= float(predicted)  # type: ignore[arg-type]


def test_the_drifted_picture_and_frame_are_enlarged_as_they_say() -> None:
    for numbers, way in (("float32", "products"), ("float32", "fast"), ("float16", "products")):
        shown = show(rounds=1, numbers=numbers, way=way)
        times, off = value(shown, "enlarged"), drifted(numbers, way, 1)[0]
        axes = np.eye(3) + times * off
        tips = {dot.name: dot.point for dot in shown.world.dots}
        eye, frame = np.array(START.camera.eye), START.camera.frame
        for name, way_of in zip(("u'", "v'", "n'"), axes @ frame, strict=True):
            assert (tips[name] - eye) / (0.3 * START.camera.distance) == pytest.approx(way_of)
        (copy,) = shown.copies
        points = SUBJECT.points
        moved = np.column_stack([points, np.ones(len(points))]) @ copy.world_from_world.T
        clip = moved @ START.clip_from_world.T
        middle = 1.0 + float(np.trace(off)) / 3.0
        q = (
            (points - eye)
            @ frame.T
            @ (np.eye(3) + times * (off / middle - (1 - 1 / middle) * np.eye(3))).T
        )
        expected = np.column_stack([q, np.ones(len(q))]) @ START.clip_from_view.T
        assert clip[:, :2] / clip[:, 3:] == pytest.approx(expected[:, :2] / expected[:, 3:])
        depth = clip[:, 2] / clip[:, 3]
        assert (depth < -0.95).all() and (depth >= -1.0).all()  # before its ghost
        (arrow,) = shown.image.lines
        largest = np.linalg.norm(arrow.points[1] - arrow.points[0])
        assert largest == pytest.approx(times * value(shown, "measured"), rel=0.15)
        assert 30.0 < largest < 120.0


def test_renormalising_mends_the_lengths_and_not_the_direction() -> None:
    alone, mended = (show(rounds=1, way=way) for way in ("products", "renormalised"))
    assert value(mended, "too long") < 1e-5 * value(alone, "too long")
    assert value(mended, "leans") > 0.1 * value(alone, "leans")


def test_the_start_shows_a_drift_that_is_seen_without_enlarging() -> None:
    shown = show()
    assert value(shown, "enlarged") == 1.0 and 40.0 < value(shown, "measured") < 108.0
    assert PHENOMENON.names == ("u'", "v'", "n'", "axis", "drift")
    assert {text.name for text in shown.world.texts} == {"u'", "v'", "n'", "axis"}
    assert [text.text for text in shown.image.texts] == ["57 px"]


def test_the_ghost_is_pale_and_the_drifted_letter_is_not() -> None:
    picture = figure_of(load("drift"), START, ("image",), (640, 360)).pixels()
    colours = {tuple(rgb) for rgb in picture[..., :3].reshape(-1, 3).tolist()}
    assert (86, 180, 233) in colours  # the letter's front
    assert any(200 <= red <= 220 and blue > 240 for red, _, blue in colours)  # the ghost's


@pytest.mark.parametrize("rounds", [0, 1e9, 1.5])
def test_rounds_that_cannot_be_are_refused_with_field_value_and_bound(rounds: float) -> None:
    with pytest.raises(Refusal) as caught:
        PHENOMENON.checked({"rounds": rounds})
    assert str(caught.value).startswith(f"settings.rounds = {rounds:.10g}: must be ")


def test_what_has_no_number_says_so() -> None:
    away = replace(START, camera=Camera(START.camera.target, START.camera.eye))
    shown = show(away)
    assert shown.warning is not None and "no vertex" in shown.warning.sentence()
    near = replace(START, lens=Perspective(175.0, 0.01, 100.0))
    assert "behind the camera" in why(show(near, rounds=100), "predicted")
