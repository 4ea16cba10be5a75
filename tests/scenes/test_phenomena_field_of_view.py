"""Field of view: the readout against tangents taken with 80 digits, and what the ride holds."""

import math
import random
from dataclasses import replace

import numpy as np
import pytest

from app.model.projection import Camera, Perspective, Projection
from app.scenes.phenomena.field_of_view import PHENOMENON, preset_view
from tests.oracles.exact import Exact, dot, minus, mp, vector
from tests.oracles.illustrations import random_projection, reading, showing, subject_of, value, why

SUBJECT = subject_of(PHENOMENON)
PRESETS = ("wide", "tele", "eye", "monitor", "phone")


shown = showing(PHENOMENON, SUBJECT)


def followed(projection: Projection, **settings: object) -> Projection:
    after = PHENOMENON.checked(settings)
    return PHENOMENON.follow(projection, PHENOMENON.checked({}), after)


def half_tan(fov_deg: float) -> mp.mpf:
    return mp.tan(mp.mpf(fov_deg) * mp.pi / 360)


def test_readings_are_the_formulas_for_fifty_random_rides() -> None:
    dice = random.Random(1)
    for _ in range(50):
        aspect_size = (dice.randint(300, 2000), dice.randint(300, 2000))
        base = Projection(PHENOMENON.start.camera, Perspective(40.0, 0.1, 1e4), aspect_size)
        seen = followed(
            base,
            preset=dice.choice(PRESETS[1:]),
            distance=dice.uniform(0.9, 8.0),
            enlarged=dice.random() < 0.5,
        )
        illustration = shown(seen)
        lens = seen.lens
        assert isinstance(lens, Perspective)
        exact = Exact(seen)
        n, eye = exact.frame[2], vector(seen.camera.eye)
        distance = dot(n, minus(eye, vector(seen.camera.target)))
        height = mp.mpf(SUBJECT.upper[1]) - mp.mpf(SUBJECT.lower[1])
        low, high = SUBJECT.lower, SUBJECT.upper
        bar_at = 0.55 * math.hypot(high[0] - low[0], high[2] - low[2])
        aspect = mp.mpf(aspect_size[0]) / aspect_size[1]
        up = half_tan(lens.fov_y_deg)
        depths = [dot(n, minus(eye, vector(p))) for p in np.unique(SUBJECT.points, axis=0)]
        expected = {
            "distance d": distance,
            "vertical": lens.fov_y_deg,
            "horizontal": 2 * mp.atan(aspect * up) * 180 / mp.pi,
            # The film's half-diagonal over the half-diagonal at distance 1.
            "focal length": mp.sqrt(36**2 + 24**2) / 2 / (up * mp.sqrt(1 + aspect**2)),
            "subject's height": height / (2 * distance * up) * aspect_size[1],
            "foreshortening": max(depths) / min(depths),
        }
        for label, formula in expected.items():
            if min(depths) <= 0 and label == "foreshortening":
                assert reading(illustration, label).value is None
                continue
            if label == "subject's height" and aspect * distance * up < bar_at:
                assert (
                    reading(illustration, label).value is None
                )  # the picture is too narrow for it
                continue
            assert value(illustration, label) == pytest.approx(float(formula), rel=1e-11), label


@pytest.mark.parametrize("preset", PRESETS)
def test_every_preset_and_every_ride_keeps_the_size(preset: str) -> None:
    size = value(shown(PHENOMENON.start), "subject's height")
    before = PHENOMENON.checked({"preset": preset})
    lens = replace(PHENOMENON.start.lens, far=1e4)  # to be seen at the end of every ride
    start = replace(PHENOMENON.start, lens=lens)
    seen = PHENOMENON.follow(start, PHENOMENON.checked({}), before)
    assert value(shown(seen), "subject's height") == pytest.approx(size, rel=1e-12)
    for factor in (0.5, 1.7, 6.0):
        after = PHENOMENON.checked({"preset": preset, "distance": factor})
        ridden = PHENOMENON.follow(seen, before, after)
        assert value(shown(ridden), "subject's height") == pytest.approx(size, rel=1e-12)
        assert ridden.camera.distance == pytest.approx(factor * seen.camera.distance, rel=1e-12)
        assert ridden.camera.target == seen.camera.target
        assert np.allclose(ridden.camera.frame, seen.camera.frame, atol=1e-12)


def test_l20_the_lectures_numbers() -> None:
    """One unit is 10 cm: 30 cm are 3, 360 cm are 36; across 120, 30 and 5 degrees."""
    wide = preset_view("wide", 16 / 9)
    assert wide.distance == 3.0
    # Diagonal of the film 43.27 mm; half of it over 29 mm is 0.7460, of which the height's share
    # is 9/sqrt(16^2 + 9^2) = 0.4903: the tangent is 0.36573.
    assert math.tan(math.radians(wide.fov_y_deg / 2)) == pytest.approx(0.36573, abs=1e-5)
    own = preset_view("tele", 16 / 9, enlarged=False)
    assert own.distance == 36.0
    assert math.tan(math.radians(own.fov_y_deg / 2)) == pytest.approx(0.36573 * 29 / 105, abs=1e-5)
    enlarged = preset_view("tele", 16 / 9)
    assert enlarged.distance == 36.0
    assert math.tan(math.radians(enlarged.fov_y_deg / 2)) == pytest.approx(0.36573 / 12, abs=1e-6)
    for name, across_deg in (("eye", 120.0), ("monitor", 30.0), ("phone", 5.0)):
        view = preset_view(name, 16 / 9)
        up = math.tan(math.radians(view.fov_y_deg / 2))
        assert up * 16 / 9 == pytest.approx(math.tan(math.radians(across_deg / 2)), rel=1e-12)
        assert view.distance == pytest.approx(3 * 0.36573 / up, rel=1e-4)


def test_the_far_photograph_is_flatter_at_the_same_size() -> None:
    near, far = shown(PHENOMENON.start), shown(followed(PHENOMENON.start, preset="tele"))
    assert value(near, "foreshortening") > 1.5 > 1.1 > value(far, "foreshortening")
    own = shown(followed(PHENOMENON.start, preset="tele", enlarged=False))
    # 105/29 of the size at 12 times the distance.
    ratio = value(own, "subject's height") / value(near, "subject's height")
    assert ratio == pytest.approx(105 / 29 / 12, rel=1e-12)
    assert value(own, "focal length") == pytest.approx(105.0, rel=1e-12)
    assert value(own, "foreshortening") == value(far, "foreshortening")


def test_a_ride_keeps_the_size_with_every_lens() -> None:
    dice = random.Random(2)
    measured = 0
    for _ in range(50):
        seen = random_projection(dice, PHENOMENON.start)
        ridden = followed(seen, distance=dice.uniform(0.3, 5.0))
        before, after = (reading(shown(p), "subject's height").value for p in (seen, ridden))
        if before is None or after is None:  # out of the picture, before or after
            continue
        assert after == pytest.approx(before, rel=1e-9)
        assert ridden.lens.kind == seen.lens.kind
        measured += 1
    assert measured >= 20


def test_the_height_is_that_of_the_targets_plane_and_only_of_what_is_seen() -> None:
    """The label names the plane, because nearer parts of the subject are drawn larger."""
    illustration = shown(PHENOMENON.start)
    found = reading(illustration, "subject's height")
    assert "target" in found.label
    drawn = PHENOMENON.start.trace(SUBJECT.points).image[:, 1]
    assert float(np.ptp(drawn)) > 1.05 * value(illustration, "subject's height")
    bar = [line for line in illustration.image.lines if line.colour == "accent"]
    assert len(bar) == 3
    camera = PHENOMENON.start.camera
    back = tuple(2 * e - t for e, t in zip(camera.eye, camera.target, strict=True))
    x, y, z = camera.target
    beside = (x, y + 30.0, z)
    for seen, words in (
        # Looking away, and looking at another place, with the subject below the picture.
        (Camera(camera.eye, back, camera.up), "nothing of the subject"),
        (Camera(tuple(np.add(camera.eye, (0, 30, 0)).tolist()), beside), "nothing of the subject"),
    ):
        hidden = shown(Projection(seen, PHENOMENON.start.lens, PHENOMENON.start.image_size))
        found = reading(hidden, "subject's height")
        assert found.value is None and found.note is not None
        assert words in found.note.sentence()
        assert not [line for line in hidden.image.lines if line.colour == "accent"]
        assert not any("px" in text.text for text in hidden.image.texts)
    # The subject is there, but before the target's plane, which is beyond far.
    cut = Projection(camera, Perspective(40.0, 0.1, camera.distance - 0.1), (1280, 720))
    assert "plane through the target" in why(shown(cut), "subject's height")


def test_foreshortening_is_the_ratio_of_the_two_squares_or_there_is_none() -> None:
    round_the_eye = Camera((0.0, 0.9, 0.0), (0.0, 0.9, -3.0))
    assert "behind" in why(shown(replace(PHENOMENON.start, camera=round_the_eye)), "foreshortening")
    assert value(shown(PHENOMENON.start.with_lens("orthographic")), "foreshortening") == 1.0
    illustration = shown(PHENOMENON.start)
    heights = {}
    for colour in ("near", "far"):
        points = np.concatenate(
            [line.points for line in illustration.image.lines if line.colour == colour]
        )
        heights[colour] = np.ptp(points[:, 1])
    ratio = heights["near"] / heights["far"]
    assert ratio == pytest.approx(value(illustration, "foreshortening"), rel=1e-9)


def test_an_enlarged_photograph_says_that_it_is_one() -> None:
    """By hand: 29 mm from 3 and an equal size from 36 are 29 * 36/3 = 348 mm: 3.314 times 105."""
    note = {}
    for enlarged in (True, False):
        after = PHENOMENON.checked({"preset": "tele", "enlarged": enlarged})
        seen = PHENOMENON.follow(PHENOMENON.start, PHENOMENON.checked({}), after)
        note[enlarged] = reading(shown(seen, preset="tele", enlarged=enlarged), "focal length").note
    assert note[False] is None and note[True].values == pytest.approx((348 / 105,), rel=1e-3)
