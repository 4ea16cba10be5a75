"""Off-axis window: the two halves join, and the window stays in the world."""

import math
import random
from dataclasses import replace

import numpy as np
import pytest

from app.model.projection import Camera, Perspective, Projection
from app.picking.handles import slid_grip
from app.picking.sight import Sight
from app.scenes.phenomena.off_axis_window import (
    PHENOMENON,
    halves,
    join_error_px,
    largest_difference_px,
)
from tests.oracles.exact import Exact, mp
from tests.oracles.illustrations import (
    random_projection,
    reading,
    readings,
    showing,
    subject_of,
    value,
)

SUBJECT = subject_of(PHENOMENON)


shown = showing(PHENOMENON, SUBJECT)


def moved(projection: Projection, before: float, after: float) -> Projection:
    shifts = [PHENOMENON.checked({"shift": shift}) for shift in (before, after)]
    return PHENOMENON.follow(projection, *shifts)


def test_the_halves_join_exactly_for_fifty_random_windows() -> None:
    dice = random.Random(6)
    for _ in range(50):
        seen = random_projection(dice, PHENOMENON.start)
        seen = moved(seen, 0.0, dice.uniform(-5.0, 5.0)) if dice.random() < 0.7 else seen
        left, right = halves(seen)
        assert join_error_px((left, right)) == 0.0
        assert left.window[1] == right.window[0]
        assert left.window[2:] == right.window[2:] == seen.window[2:]
        assert (left.window[0], right.window[1]) == (seen.window[0], seen.window[1])
        assert left.image_size[0] + right.image_size[0] == seen.image_size[0]
        said = readings(shown(seen))
        assert said["error of the join"] == 0.0
        assert said["{l}, {r} of the left screen"] == left.window[:2]
        assert said["{l}, {r} of the right screen"] == right.window[:2]
        assert said["{b}, {t}"] == seen.window[2:]


def test_halves_that_do_not_join_are_found_out() -> None:
    left, right = halves(PHENOMENON.start)
    # 0.001 of a window 1.6 wide is shown on 640 pixels: a gap of 0.4 px at its edge.
    lens = right.lens.replaced(left=right.lens.left + 0.001)
    pair = left, replace(right, lens=lens)
    assert join_error_px(pair) == pytest.approx(0.001 / 1.599 * 640, rel=1e-9)
    difference = largest_difference_px(PHENOMENON.start, pair, SUBJECT.points)
    assert difference is not None and difference > 0.25


def test_a_point_of_the_join_is_on_both_edges() -> None:
    """With 80 digits, of points made from the definition of the plane in view space."""
    dice = random.Random(7)
    for _ in range(50):
        seen = moved(random_projection(dice, PHENOMENON.start), 0.0, dice.uniform(-3.0, 3.0))
        left, right = halves(seen)
        exact_left, exact_right = Exact(left), Exact(right)
        u, v, n = exact_left.frame
        w, y = mp.mpf(dice.uniform(1.0, 30.0)), mp.mpf(dice.uniform(-2.0, 2.0))
        x = mp.mpf(left.window[1]) * w / mp.mpf(seen.lens.near)
        point = [
            float(mp.mpf(e) + x * u[i] + y * v[i] - w * n[i]) for i, e in enumerate(seen.camera.eye)
        ]
        # The point's own rounding is all that is left: some 1e-15 of 30 units, on 2000 pixels.
        assert float(exact_left(point).image[0]) == pytest.approx(left.image_size[0], abs=1e-9)
        assert float(exact_right(point).image[0]) == pytest.approx(0.0, abs=1e-9)


def test_the_wall_shows_what_one_picture_shows() -> None:
    dice = random.Random(8)
    measured = 0
    for _ in range(50):
        seen = random_projection(dice, PHENOMENON.start)
        difference = largest_difference_px(seen, halves(seen), SUBJECT.points)
        if difference is not None and difference < math.inf:
            measured += 1
            assert difference < 1e-8
    assert measured > 30


def test_why_nothing_is_compared() -> None:
    """The subject is in front of the eye, but beside the picture."""
    beside = moved(PHENOMENON.start, 0.0, 30.0)
    beside = replace(beside, lens=PHENOMENON.start.lens)
    assert beside.trace(SUBJECT.points).in_front.all()
    found = reading(shown(beside), "wall against")
    assert found.value is None and found.note is not None
    assert "in the picture" in found.note.sentence()
    assert "in front" not in found.note.sentence()


def test_the_window_stays_while_the_eye_moves() -> None:
    """Points of the target's plane keep their pixels, others do not; n stays."""
    dice = random.Random(9)
    for _ in range(50):
        seen = random_projection(dice, PHENOMENON.start).with_lens("frustum")
        camera = seen.camera
        offsets = np.array([[dice.uniform(-1, 1), dice.uniform(-1, 1), 0.0] for _ in range(5)])
        plane = np.array(camera.target) + offsets @ camera.frame
        shift = dice.uniform(-2.0, 2.0)
        after = moved(seen, 0.5, 0.5 + shift)
        assert np.allclose(after.trace(plane).image, seen.trace(plane).image, atol=1e-7)
        assert np.allclose(after.camera.frame, camera.frame, atol=1e-12)
        assert np.allclose(
            np.subtract(after.camera.eye, camera.eye), shift * camera.frame[0], atol=1e-12
        )
        behind = plane - camera.frame[2]
        ratio = camera.distance / (camera.distance + 1.0)
        drawn = after.trace(behind).image[:, 0] - seen.trace(behind).image[:, 0]
        # A point 1 behind the window moves with the eye by 1 - d/(d + 1) of its way.
        width = seen.window[1] - seen.window[0]
        px = seen.image_size[0] / (width * camera.distance / seen.lens.near)
        assert np.allclose(drawn, shift * (1.0 - ratio) * px, atol=1e-7)
        assert np.allclose(moved(after, 0.5 + shift, 0.5).window, seen.window, atol=1e-12)


def test_the_eye_is_dragged_across_its_window() -> None:
    """In the picture of a camera behind it that looks along the axis: 2 units to the right."""
    (grip,), behind = shown(shift=1.5).grips, Camera((1.5, 2.4, 18.0), (1.5, 2.4, 0.0))
    seen = Sight.of(replace(PHENOMENON.start, camera=behind, lens=Perspective(90.0, 1.0, 40.0)))
    width, height = PHENOMENON.start.image_size
    goal = (width + height * 2.0 / 10.0) / 2.0, height / 2.0
    assert grip.along is not None and grip.point.tolist() == [1.5, 2.4, 8.0]
    assert slid_grip(grip.base, grip.along, 1.5, grip.point, seen, goal) == pytest.approx(3.5)


def test_off_the_axis_by_hand() -> None:
    """The start's window on the near plane is -5.5/8 to 2.5/8: (r + l)/(r - l) = -3/8."""
    opposite = moved(PHENOMENON.start, 1.5, 0.0)
    for seen, expected in ((PHENOMENON.start, -0.375), (opposite, 0.0)):
        assert value(shown(seen), "off the axis") == pytest.approx(expected, abs=1e-15)
    assert opposite.camera.eye == (0.0, 2.4, 8.0)


def test_one_screen_and_a_picture_one_pixel_wide_have_no_join() -> None:
    one = shown(PHENOMENON.start, screens="1")
    assert readings(one)["{l}, {r} of the window"] == PHENOMENON.start.window[:2]
    assert not one.ndc.lines
    narrow = shown(replace(PHENOMENON.start, image_size=(1, 100)))
    assert narrow.warning is not None
    for illustration in (one, narrow):
        assert readings(illustration)["error of the join"] is None


def test_the_join_is_marked_where_the_pixels_part() -> None:
    seen = replace(PHENOMENON.start, image_size=(1281, 720))
    illustration = shown(seen)
    left, _ = halves(seen)
    assert left.image_size[0] == 640
    (join,) = [line for line in illustration.image.lines if line.colour == "accent"]
    assert (join.points[:, 0] == 640.0).all()
    (face,) = illustration.ndc.faces
    assert face.points[:, 0] == pytest.approx(2 * 640 / 1281 - 1)
    # In the world it lies on the window's plane, and is seen where the image has it.
    (join,) = [line for line in illustration.world.lines if line.colour == "accent"]
    assert seen.trace(join.points).image[:, 0] == pytest.approx(640.0, abs=1e-9)


def sides(projection: Projection) -> dict[str, list[float]]:
    """The middle of each side of the near rectangle, where the pane writes its number."""
    lines = shown(projection).world.lines
    return {
        line.about[0]: line.points.mean(axis=0).round(9).tolist() for line in lines if line.about
    }


AT_START = {
    "left": [-0.7, 2.4, 4.8],
    "right": [2.5, 2.4, 4.8],
    "bottom": [0.9, 1.5, 4.8],
    "top": [0.9, 3.3, 4.8],
}
"""By hand: a window 8 by 4.5, 8 before the eye at (1.5, 2.4, 8), its middle 1.5 to the left; at
0.4 of the distance it is 0.4 times as large."""


def test_l6_the_near_rectangle_has_the_four_numbers_of_glfrustum() -> None:
    assert sides(PHENOMENON.start) == AT_START
    # Those that the pane writes there are those of the lecture's matrix: 2n/(r - l) and
    # (r + l)/(r - l) (003).
    assert PHENOMENON.start.window == (-2.2, 1.0, -0.9, 0.9)
    matrix = PHENOMENON.start.clip_from_view
    assert matrix[0, 0] == pytest.approx(2 * 3.2 / (1.0 + 2.2))
    assert matrix[0, 2] == pytest.approx((1.0 - 2.2) / (1.0 + 2.2))
    assert matrix[1, 1] == pytest.approx(2 * 3.2 / 1.8) and matrix[1, 2] == 0.0


@pytest.mark.parametrize(
    ("name", "number", "step", "along"),
    [
        ("left", -0.75, (1.45, 0.0, 0.0), ("bottom", "top")),
        ("right", 2.25, (1.25, 0.0, 0.0), ("bottom", "top")),
        ("bottom", -2.125, (0.0, -1.225, 0.0), ("left", "right")),
        ("top", 2.125, (0.0, 1.225, 0.0), ("left", "right")),
        ("near", 2.0, (0.0, 0.0, 1.2), ()),  # all four
        ("far", 30.0, (0.0, 0.0, 0.0), ()),
    ],
)
def test_l6_each_of_the_six_moves_its_own_edge(
    name: str, number: float, step: tuple[float, ...], along: tuple[str, ...]
) -> None:
    """A side goes alone, and the middles of the two beside it half as far."""
    lens = replace(PHENOMENON.start.lens, keep="stretch", **{name: number})
    now = sides(replace(PHENOMENON.start, lens=lens))
    for side, place in AT_START.items():
        part = 1.0 if side == name or not along else 0.5 if side in along else 0.0
        expected = [at + part * way for at, way in zip(place, step, strict=True)]
        assert now[side] == pytest.approx(expected)


def test_l6_each_side_has_a_line_of_its_own_to_highlight() -> None:
    lines = {line.about: line.points for line in shown(PHENOMENON.start).world.lines if line.about}
    assert sorted(lines) == [("bottom",), ("left",), ("right",), ("top",)]
    assert np.ptp(lines["left",], axis=0) == pytest.approx([0.0, 1.8, 0.0])
    assert lines["left",][:, 0] == pytest.approx(-0.7)
    assert np.ptp(lines["top",], axis=0) == pytest.approx([3.2, 0.0, 0.0])
    assert lines["top",][:, 1] == pytest.approx(3.3)
