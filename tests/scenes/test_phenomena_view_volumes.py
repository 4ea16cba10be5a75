"""View volumes: against sections summed with 80 digits, and test points against half-spaces."""

import math
import random
from dataclasses import replace

import numpy as np
import pytest

from app.model.projection import Frustum, Perspective, Projection
from app.scenes.phenomena.view_volumes import PHENOMENON, POINTS, cone_of, held, volume
from tests.oracles.exact import Exact, mp
from tests.oracles.illustrations import random_projection, reading, showing, subject_of, why

SUBJECT = subject_of(PHENOMENON)


shown = showing(PHENOMENON, SUBJECT)


def section_area(projection: Projection, w: mp.mpf, cone: bool) -> mp.mpf:
    """Area of the volume's section at a distance from the eye plane, from the definitions."""
    left, right, bottom, top = Exact(projection).window()
    grown = 1 if projection.lens.parallel else w / mp.mpf(projection.lens.near)
    width, height = (right - left) * grown, (top - bottom) * grown
    return mp.pi * (min(width, height) / 2) ** 2 if cone else width * height


def test_volumes_are_the_sections_integrals_for_fifty_random_lenses() -> None:
    dice = random.Random(3)
    for _ in range(50):
        seen = random_projection(dice, PHENOMENON.start)
        seen = seen.between(dice.uniform(0.5, 3.0), dice.uniform(5.0, 20.0))
        cone = not seen.lens.parallel and dice.random() < 0.5
        near, far = mp.mpf(seen.lens.near), mp.mpf(seen.lens.far)
        # Simpson's rule is exact for sections that grow with the square of w.
        sections = [section_area(seen, w, cone) for w in (near, (near + far) / 2, far)]
        expected = (far - near) / 6 * (sections[0] + 4 * sections[1] + sections[2])
        found = volume(seen, cone)
        assert found is not None and found == pytest.approx(float(expected), rel=1e-13)


def test_l4_volumes_by_hand() -> None:
    """Near 3, far 13, 45 degrees up and across: base 1 at distance 1 is (2 tan 22.5)^2."""
    seen = Projection(PHENOMENON.start.camera, Frustum(-3.0, 3.0, -3.0, 3.0, 3.0, 13.0))
    # A pyramid with slopes 1: side 6 at 3, 26 at 13; 4 (13^3 - 3^3)/3 = 4 * 2170/3.
    assert volume(seen, False) == pytest.approx(8680 / 3, rel=1e-15)
    assert volume(seen, True) == pytest.approx(math.pi * 2170 / 3, rel=1e-15)
    box = replace(seen, lens=seen.with_lens("orthographic").lens)
    # with_lens keeps the target's plane, 8 away: 16 by 16 by 10.
    assert volume(box, False) == pytest.approx(2560.0, rel=1e-14)
    assert volume(seen.with_lens("oblique"), False) == pytest.approx(2560.0, rel=1e-12)


def exactly_inside(projection: Projection, point: tuple[float, ...], cone: bool) -> bool | None:
    """By 80 digits; None for a point so near the surface that float64 may differ."""
    answer = Exact(projection)(point)
    lens = projection.lens
    w = -answer.view[2]
    gaps = [w - mp.mpf(lens.near), mp.mpf(lens.far) - w]
    if cone:
        middle_x, middle_y, radius = (mp.mpf(part) for part in cone_of(projection))
        x, y = answer.view[0] - middle_x * w, answer.view[1] - middle_y * w
        gaps.append(radius * w - mp.sqrt(x * x + y * y))
    else:
        gaps += [1 - abs(part) for part in answer.ndc[:2]]
        gaps.append(answer.w)
    if min(abs(gap) for gap in gaps) < 1e-9:
        return None
    return all(gap > 0 for gap in gaps)


def test_points_inside_are_those_of_the_definition_for_fifty_random_lenses() -> None:
    dice = random.Random(4)
    counts = set()
    for _ in range(50):
        seen = random_projection(dice, PHENOMENON.start)
        cone = not seen.lens.parallel and dice.random() < 0.5
        inside = held(seen, cone)
        for name, here in zip(POINTS, inside, strict=True):
            expected = exactly_inside(seen, POINTS[name], cone)
            assert expected is None or bool(here) == expected, (name, seen)
        illustration = shown(seen, volume="cone" if cone else "pyramid")
        names = [name for name, here in zip(POINTS, inside, strict=True) if here]
        assert reading(illustration, "test points inside").value == len(names)
        assert reading(illustration, "these are").value == (", ".join(names) or "none")
        counts.add(len(names))
    assert len(counts) > 3


def test_the_cone_is_inscribed() -> None:
    lens = PHENOMENON.start.lens
    assert isinstance(lens, Perspective)
    x, y, radius = cone_of(PHENOMENON.start)
    assert (x, y) == (0.0, 0.0)
    assert radius == pytest.approx(math.tan(math.radians(lens.fov_y_deg / 2)), rel=1e-15)
    upright = replace(PHENOMENON.start, image_size=(720, 1280))
    assert cone_of(upright)[2] == pytest.approx(radius * 720 / 1280, rel=1e-15)
    dice = random.Random(5)
    for _ in range(20):
        seen = random_projection(dice, PHENOMENON.start).with_lens("frustum")
        illustration = shown(seen, volume="cone")
        for line in illustration.ndc.lines:
            assert np.abs(line.points).max() <= 1.0 + 1e-12
        # It touches the shorter sides of the picture, and the marks in the world are the same.
        (ellipse,) = illustration.image.lines
        width, height = seen.image_size
        spans = np.ptp(ellipse.points, axis=0) / (width, height)
        assert spans.max() == pytest.approx(1.0, abs=1e-12)
        near_circle = illustration.world.lines[0].points
        image = seen.trace(near_circle + 1e-12 * (near_circle - seen.camera.eye)).image
        assert np.allclose(image, ellipse.points, atol=1e-6)


def test_each_volume_holds_points_of_its_own() -> None:
    sets = {}
    for name in ("pyramid", "box", "oblique", "cone"):
        after = PHENOMENON.checked({"volume": name})
        seen = PHENOMENON.follow(PHENOMENON.start, PHENOMENON.checked({}), after)
        sets[name] = reading(shown(seen, volume=name), "these are").value
    assert sets == {
        "pyramid": "A, C, D, E",
        "box": "A, B, D, E",
        "oblique": "A, B, D, E",
        "cone": "A, E",
    }


def test_the_picture_of_the_targets_plane_stays() -> None:
    seen = PHENOMENON.start
    plane = np.array([(x, y, 0.0) for x in (-2.0, 0.0, 3.0) for y in (1.0, 3.0, 4.5)])
    image = seen.trace(plane).image
    before = PHENOMENON.checked({})
    for name in ("box", "oblique", "pyramid", "cone", "box", "cone"):
        after = PHENOMENON.checked({"volume": name})
        seen, before = PHENOMENON.follow(seen, before, after), after
        assert np.allclose(seen.trace(plane).image, image, atol=1e-9)
        shape = reading(shown(seen, volume=name), "view volume").value
        words = {"pyramid": "pyramid", "box": "box", "oblique": "oblique box", "cone": "cone"}
        assert isinstance(shape, str) and shape.endswith(words[name])


def test_a_missing_volume_is_explained() -> None:
    endless = replace(PHENOMENON.start, lens=Perspective(40.0, 3.0, math.inf))
    assert "infinite" in why(shown(endless), "its volume")
    large = replace(PHENOMENON.start, lens=Perspective(179.9999, 1.0, 1e100))
    found = reading(shown(large), "its volume")
    # 4 aspect tan^2 (1e300)/3 with tan = 1/8.7e-7: 3.1e312.
    assert found.value is None and found.note is not None and "float64" in found.note.sentence()
    boxed = PHENOMENON.start.with_lens("orthographic")
    assert shown(boxed, volume="cone").warning is not None
    assert shown(boxed, volume="box").warning is None


def test_the_cone_says_that_no_lens_draws_it() -> None:
    """A test point between cone and pyramid is still drawn."""
    noted = {
        kind: reading(shown(PHENOMENON.start, volume=kind), "view volume").note is not None
        for kind in ("pyramid", "cone")
    }
    assert noted == {"pyramid": False, "cone": True}
    between = held(PHENOMENON.start, False) & ~held(PHENOMENON.start, True)
    trace = PHENOMENON.start.trace(list(POINTS.values()))
    assert between.any() and not trace.outside[between].any()
