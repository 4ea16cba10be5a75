"""Vanishing points: against the limit of far points with 80 digits, and what is at infinity."""

import math
import random
from dataclasses import replace

import numpy as np
import pytest

from app.model.projection import Camera, Orbit, Perspective, Projection
from app.picking.handles import slid_grip
from app.picking.sight import Sight
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.vanishing_points import PHENOMENON, horizon, line_in_rectangle, vanishing
from app.scenes.shapes import box_corners
from tests.oracles.exact import Exact, mp
from tests.oracles.illustrations import random_projection, reading, showing, subject_of, why

SUBJECT = subject_of(PHENOMENON)
AXES = ("x", "y", "z")


shown = showing(PHENOMENON, SUBJECT)


def turned(points: str, projection: Projection = PHENOMENON.start) -> Projection:
    before = PHENOMENON.checked({"points": "free"})
    return PHENOMENON.follow(projection, before, PHENOMENON.checked({"points": points}))


def pixel(illustration: Illustration, label: str) -> tuple[float, float]:
    found = reading(illustration, label).value
    assert isinstance(found, tuple) and len(found) == 2, label
    return found[0], found[1]


def exact_vanishing(projection: Projection, axis: int) -> list[float]:
    """Where a point on an edge's line goes that is 1e40 away, with 80 digits."""
    exact = Exact(projection)
    direction = [row[axis] for row in exact.frame]
    left, right, bottom, top = exact.window()
    near = mp.mpf(projection.lens.near)
    at = [part * mp.mpf(10) ** 40 + mp.mpf("0.37") for part in direction]
    x, y = (near * part / -at[2] for part in at[:2])
    return [
        float(exact.width * (x - left) / (right - left)),
        float(exact.height * (top - y) / (top - bottom)),
    ]


def test_vanishing_points_are_the_limits_of_fifty_random_pictures() -> None:
    dice = random.Random(11)
    perspectives = 0
    for _ in range(50):
        seen = random_projection(dice, PHENOMENON.start)
        illustration = shown(seen)
        kind = reading(illustration, "kind of projection").value
        if seen.lens.parallel:
            assert kind == "parallel projection"
            assert all(reading(illustration, f"edges along {axis}").value is None for axis in AXES)
            continue
        perspectives += 1
        assert kind == "3-point perspective"
        for index, axis in enumerate(AXES):
            expected = exact_vanishing(seen, index)
            size = max(1.0, *map(abs, expected))
            found = pixel(illustration, f"edges along {axis}")
            # What n . D keeps of the frame's digits, which is little for the far ones.
            assert found == pytest.approx(expected, abs=1e-12 * size * size)
    assert perspectives > 10


@pytest.mark.parametrize(("points", "finite"), [("1", "z"), ("2", "xz"), ("3", "xyz")])
@pytest.mark.parametrize("target", [(0.0, 1.3, 0.0), (0.1, 1.1, -7.3), (12345.6, 0.7, 1e-3)])
def test_the_presets_have_as_many_as_they_say(
    points: str, finite: str, target: tuple[float, float, float]
) -> None:
    camera = Camera.from_orbit(target, Orbit(-77.0, 21.0, 6.3))
    seen = turned(points, replace(PHENOMENON.start, camera=camera))
    illustration = shown(seen)
    assert reading(illustration, "kind of projection").value == f"{points}-point perspective"
    for axis in AXES:
        found = reading(illustration, f"edges along {axis}")
        assert (found.value is not None) == (axis in finite)
        if found.value is None:
            assert found.note is not None
            angle_deg = {"x": "0", "y": "90"}[axis]
            said = found.note.sentence()
            assert said.startswith(f"V_{axis} is at infinity") and f" {angle_deg}°" in said
    assert seen.camera.target == target
    assert seen.camera.distance == pytest.approx(6.3, rel=1e-12)


def test_a_parallel_lens_becomes_perspective_and_free_turns_nothing() -> None:
    assert turned("1", PHENOMENON.start.with_lens("oblique")).lens.kind == "perspective"
    assert turned("free") == PHENOMENON.start


def test_the_rounding_of_eye_and_target_decides_which_points_are_at_infinity() -> None:
    """One ulp of the eye's height is rounding; a thousandth of a degree is not."""
    eye_y = math.nextafter(2.2, 3.0)
    level = replace(PHENOMENON.start, camera=Camera((3.0, eye_y, 8.0), (0.0, 2.2, 0.0)))
    assert vanishing(level)[1].clip[3] == 0.0
    # Far from the origin an ulp is more: 2.3e-10 of the 5 between eye and target.
    eye_y = math.nextafter(1234567.1, 2e6)
    far_off = Camera((7e5, eye_y, 1e5), (7e5 + 3.0, 1234567.1, 1e5 - 4.0))
    assert vanishing(replace(PHENOMENON.start, camera=far_off))[1].clip[3] == 0.0
    tilted = replace(PHENOMENON.start, camera=Camera((3.0, 2.2 + 1.5e-4, 8.0), (0.0, 2.2, 0.0)))
    found = vanishing(tilted)[1]
    assert found.pixel is not None
    # Down by cot of 1.5e-4/8.544 rad: 514.13 px * 56 960 = 2.93e7 px.
    slope = 1.5e-4 / math.hypot(3.0, 8.0)
    k = 360 / math.tan(math.radians(35))
    assert found.pixel[1] == pytest.approx(360 + k / slope, rel=1e-8)
    # However short the way to the target, one direction is not across it.
    ulp = math.ulp(1.0)
    short = Camera((1.0 + ulp, 1.0 + ulp, 1.0 + ulp), (1.0, 1.0, 1.0))
    points = vanishing(replace(PHENOMENON.start, camera=short))
    assert sum(point.clip[3] > 0.0 for point in points) == 3
    # The same ulp, on a target a million times nearer, is an angle that was meant.
    near = replace(
        PHENOMENON.start,
        camera=Camera((1e-9, 1e-9, 1e-9), (0.0, 0.0, 0.0)),
        lens=Perspective(70.0, 1e-12, 1.0),
    )
    assert vanishing(near)[1].pixel is not None


def test_the_running_point_goes_to_the_vanishing_point() -> None:
    dice = random.Random(12)
    converged = 0
    for _ in range(50):
        seen = random_projection(dice, PHENOMENON.start)
        if seen.lens.parallel:
            continue
        axis = dice.choice(AXES)
        gaps = []
        for t in (0.9, 0.99, 0.999, 0.9999, 1.0):
            illustration = shown(seen, edge=axis, t=t)
            found = reading(illustration, "image of P")
            if found.value is None:
                gaps.append(math.inf)
                continue
            rest = reading(illustration, "from P to V").value
            assert isinstance(rest, float)
            expected = math.dist(
                pixel(illustration, "image of P"), pixel(illustration, f"along {axis}")
            )
            assert rest == pytest.approx(expected, abs=1e-9)
            gaps.append(rest)
            assert reading(illustration, "w of P").value == pytest.approx(1.0 - t, abs=1e-15)
        x, y = pixel(illustration, f"along {axis}")
        assert gaps[-1] <= 1e-12 * math.hypot(x, y)  # at t = 1 it is there
        if gaps[0] < math.inf and gaps[2] > 1e-6:
            converged += 1
            # In the end the gap goes with w = 1 - t.
            assert gaps[2] / gaps[3] == pytest.approx(10.0, rel=0.2)
    assert converged > 10


@pytest.mark.parametrize("axis", AXES)
def test_at_infinity_the_running_point_is_at_its_vanishing_point_to_the_last_bit(
    axis: str,
) -> None:
    target = PHENOMENON.start.camera.target
    for azimuth_deg in range(-170, 171, 7):
        camera = Camera.from_orbit(target, Orbit(azimuth_deg, 10.0, 6.0))
        illustration = shown(replace(PHENOMENON.start, camera=camera), edge=axis, t=1.0)
        assert pixel(illustration, "image of P") == pixel(illustration, f"along {axis}")
        assert reading(illustration, "from P to V").value == 0.0


def test_the_running_point_has_the_pixel_of_its_world_point() -> None:
    """While it is in front; from infinity on it comes from behind, and goes on beyond V."""
    seen = turned("2")
    for t in (0.0, 0.3, 0.7, 0.95):
        illustration = shown(seen, t=t)
        (dot,) = [d for d in illustration.world.dots if d.colour == "accent"]
        assert seen.trace(dot.point).image == pytest.approx(
            pixel(illustration, "image of P"), abs=1e-9
        )
    vanishing_x = pixel(shown(seen), "along z")[0]
    before, after = (pixel(shown(seen, t=t), "image of P")[0] for t in (0.9, 1.05))
    assert before < vanishing_x < after
    # t = 1.5: P = C - 3 s D, six units towards the viewer from a corner that is 5 away.
    illustration = shown(seen, t=1.5)
    (dot,) = [d for d in illustration.world.dots if d.colour == "accent"]
    trace = seen.trace(dot.point)
    assert not trace.in_front
    mirrored = trace.clip[:2] / trace.clip[3]
    expected = ((mirrored[0] + 1) * 640, (1 - mirrored[1]) * 360)
    assert pixel(illustration, "image of P") == pytest.approx(expected, rel=1e-9)


def test_a_direction_at_infinity_takes_its_point_there() -> None:
    assert "infinity" in why(shown(turned("1"), edge="x", t=1.0), "image of P")


def test_all_horizontal_directions_vanish_on_the_horizon() -> None:
    dice = random.Random(13)
    checked = 0
    for _ in range(50):
        seen = random_projection(dice, PHENOMENON.start)
        line = horizon(seen)
        if seen.lens.parallel:
            assert line is None
            continue
        assert line is not None
        a, b, c = line
        for index in (0, 2):
            x, y = exact_vanishing(seen, index)
            assert a * x + b * y == pytest.approx(c, abs=1e-9 * max(1.0, abs(x), abs(y)))
        checked += 1
        held = line_in_rectangle(line, (0.0, 0.0), seen.image_size)
        assert held is None or np.allclose(held @ [a, b], c, atol=1e-6)
    assert checked > 10
    down = Camera((0.0, 20.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, -1.0))
    assert horizon(replace(PHENOMENON.start, camera=down)) is None


def test_guide_lines_go_through_their_vanishing_point() -> None:
    opposite = Camera.from_orbit((0.0, 1.3, 0.0), Orbit(-140.0, -20.0, 6.0))
    for seen in (
        *(turned(points) for points in ("1", "2", "3")),
        replace(PHENOMENON.start, camera=opposite),
    ):
        illustration = shown(seen)
        corners = seen.trace(box_corners(SUBJECT.lower, SUBJECT.upper))
        for axis, colour in zip(AXES, ("u", "v", "n"), strict=True):
            guides = [line.points for line in illustration.image.lines if line.colour == colour]
            if reading(illustration, f"along {axis}").value is None:
                assert not guides
                continue
            assert len(guides) >= 2
            at = np.array(pixel(illustration, f"along {axis}"))
            for start, end in guides:
                along, rest = end - start, at - start
                across = along[0] * rest[1] - along[1] * rest[0]
                assert abs(across) <= 1e-8 * np.hypot(*along) * max(1.0, np.hypot(*rest))
                # They extend the edges: from the end that is farther from the viewer.
                index = np.abs(corners.image - start).sum(axis=1).argmin()
                assert corners.image[index] == pytest.approx(start, abs=1e-6)
                other = index ^ (1 << AXES.index(axis))
                assert corners.view[index, 2] < corners.view[other, 2]


def test_rays_from_the_eye_meet_the_near_plane_at_the_vanishing_points() -> None:
    seen = turned("3")
    illustration = shown(seen)
    names = {text.text: text.point for text in illustration.world.texts}
    for axis in AXES:
        trace = seen.trace(names[f"V_{axis}"])
        assert trace.view[2] == pytest.approx(-seen.lens.near, abs=1e-12)
        assert trace.image == pytest.approx(pixel(illustration, f"along {axis}"), abs=1e-8)
        index = AXES.index(axis)
        ray = np.delete(names[f"V_{axis}"] - np.array(seen.camera.eye), index)
        assert np.abs(ray).max() == 0.0  # parallel to the axis


def test_the_diagram_shows_vanishing_points_beside_the_frame() -> None:
    illustration = shown(turned("3"))
    (diagram,) = illustration.diagrams
    _, below = pixel(illustration, "along y")
    assert below > 720  # not in the picture
    assert diagram.bottom > below and diagram.top < 0 and diagram.left < 0
    assert {curve.label for curve in diagram.curves} >= {"V_x", "V_y", "V_z", "horizon"}


def test_p_is_dragged_along_its_edge_to_infinity_and_beyond() -> None:
    """To the places where its picture is for other t, which other tests prove."""
    (grip,), sight, reached = shown(t=0.6).grips, Sight.of(PHENOMENON.start), []
    assert grip.along is not None
    for t in (0.1, 0.3, 0.6, 0.9, 1.0, 1.05):
        dots = [dot for dot in shown(t=t).image.dots if dot.name == "P"]
        for dot in dots:
            goal = dot.point[0], dot.point[1]
            moved = slid_grip(grip.base, grip.along, 0.6, grip.point, sight, goal)
            assert moved == pytest.approx(t, abs=1e-3)
            reached.append(t)
    assert len(reached) >= 5 and 1.0 in reached
    assert np.isnan(shown(t=1.0).grips[0].point).all()
