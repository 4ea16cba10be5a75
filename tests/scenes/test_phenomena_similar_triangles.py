"""Similar triangles: x_p, y_p, scale and sign against the formula, and what cannot be cut."""

import math
import random
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.model.projection import Camera, Frustum, Perspective, Projection
from app.model.refusal import Refusal
from app.scenes.phenomena.illustration import Subject
from app.scenes.phenomena.similar_triangles import PHENOMENON, onto_plane
from tests.oracles.exact import Exact, mp
from tests.oracles.illustrations import assert_sound, readings, showing

START = PHENOMENON.start
CORNERS = np.array([(x, y, z) for x in (-1.5, 1.5) for y in (0.0, 5.0) for z in (-0.5, 0.5)])
SUBJECT = Subject((-1.5, 0.0, -0.5), (1.5, 5.0, 0.5), CORNERS)


show = showing(PHENOMENON, SUBJECT)


def random_projection(random: np.random.Generator) -> Projection:
    eye = random.normal(size=3) * 10.0
    target = random.normal(size=3)
    lens: Any = Perspective(
        float(random.uniform(5, 170)), float(10.0 ** random.uniform(-3, 2)), 1e4
    )
    if random.random() < 0.3:
        lens = Frustum(-0.3, 0.8, -0.5, 0.1, 0.5, math.inf)
    return Projection(Camera(tuple(eye), tuple(target)), lens, (640, 480))


def test_image_scale_and_sign_are_those_of_the_formula() -> None:
    """x_p = d x / w, y_p = d y / w, and the same from the matrix with -1/d, in 80 digits."""
    random = np.random.default_rng(21)
    checked = 0
    while checked < 50:
        projection = random_projection(random)
        place = random.normal(size=3) * 4.0
        distance = float(random.choice([-1.0, 1.0]) * 10.0 ** random.uniform(-2, 3))
        illustration = show(projection, distance=distance, point=tuple(place))
        said = readings(illustration)
        x, y, z = Exact(projection)(place).view
        if z >= 0:
            assert said["x_p = d·x / −z"] is None and said["scale d / −z"] is None
            assert illustration.readings[2].note is not None
            continue
        checked += 1
        w = -z
        assert said["−z"] == pytest.approx(float(w), rel=1e-12)
        for label, expected in (
            ("x_p = d·x / −z", distance * x / w),
            ("y_p = d·y / −z", distance * y / w),
            ("scale d / −z", distance / w),
        ):
            assert said[label] == pytest.approx(float(expected), rel=1e-11, abs=1e-11)
            assert math.copysign(1.0, said[label]) == mp.sign(expected)
        upright = said["the image on the plane"] == "upright"
        assert upright == (distance > 0.0)
        # The copy puts the point there too: d along the axis, x_p and y_p across it.
        moved = onto_plane(projection, distance) @ [*place, 1.0]
        hit = Exact(projection)(moved[:3] / moved[3]).view
        size = abs(distance) + abs(said["x_p = d·x / −z"]) + abs(said["y_p = d·y / −z"])
        for found, expected in zip(
            hit, (said["x_p = d·x / −z"], said["y_p = d·y / −z"], -distance), strict=True
        ):
            assert abs(float(found) - expected) < 1e-9 * (size + 30.0)


@pytest.mark.parametrize("distance", [4.0, 9.5, 20.0, -3.0])
def test_marked_points_lie_on_the_plane_and_on_their_projectors(distance: float) -> None:
    illustration = show(distance=distance)
    camera = START.camera
    at = {text.text[0] + text.text[-1]: np.asarray(text.point) for text in illustration.world.texts}
    place, hit = at["PP"], at["P'"]
    eye = np.array(camera.eye)
    assert camera.frame[2] @ (eye - hit) == pytest.approx(distance)
    assert np.linalg.norm(np.cross(hit - eye, place - eye)) < 1e-9 * np.linalg.norm(place - eye)
    plane = illustration.world.faces[0].points
    assert np.allclose((eye - plane) @ camera.frame[2], distance)
    # The plane's border is the window of the lens, d/near times as large.
    left, right, _, _ = START.window
    width = np.linalg.norm(plane[1] - plane[0])
    assert width == pytest.approx((right - left) / START.lens.near * abs(distance))
    # The two triangles share the eye and two directions: that is what makes them similar.
    large, small = (face.points for face in illustration.world.faces[1:])
    sides = [np.linalg.norm(t - np.roll(t, -1, axis=0), axis=1) for t in (large, small)]
    assert np.ptp(sides[1] / sides[0]) < 1e-12
    scale = readings(illustration)["scale d / −z"]
    assert (sides[1] / sides[0])[0] == pytest.approx(abs(scale))
    # The chosen point is marked in the other panes where the model has it.
    trace = START.trace(place)
    assert illustration.image.dots[0].point.tolist() == trace.image.tolist()
    assert illustration.ndc.dots[0].point.tolist() == trace.ndc.tolist()


def test_a_point_on_the_axis_has_its_image_on_the_axis_to_the_last_bit() -> None:
    """The target, from cameras whose frames are no decimal numbers."""
    dice = random.Random(4)
    for _ in range(100):
        eye, target = (tuple(round(dice.uniform(-9, 9), 1) for _ in range(3)) for _ in range(2))
        found = readings(show(replace(START, camera=Camera(eye, target)), point=target))
        assert found["x_p = d·x / −z"] == found["y_p = d·y / −z"] == 0.0


def test_a_point_outside_the_view_volume_is_marked_in_the_world_only() -> None:
    """P is 9.6 before the eye plane: beyond a far plane at 8; and beside the picture."""
    short = show(replace(START, lens=Perspective(40.0, 1.0, 8.0)))
    aside = show(point=(20.0, 5.0, 0.5))
    for illustration in (short, aside):
        assert illustration.ndc.dots == illustration.image.dots == illustration.image.texts == ()
        assert illustration.world.dots and readings(illustration)["scale d / −z"] is not None


def test_both_triangles_have_their_right_angles_on_the_axis_and_share_the_eye() -> None:
    for distance in (4.0, -3.0):
        illustration = show(distance=distance)
        eye, n = np.array(START.camera.eye), START.camera.frame[2]
        large, small = (face.points for face in illustration.world.faces if len(face.points) == 3)
        for corners, other in ((large, small), (small, large)):
            np.testing.assert_allclose(corners[0], eye)
            along, across = corners[1] - eye, corners[2] - corners[1]
            assert along @ across == pytest.approx(0.0, abs=1e-9)
            # Similar: the same angle at the eye, on the same side of it or on the other.
            others = other[1] - eye, other[2] - other[1]
            sizes = [np.linalg.norm(part) for part in (along, across, *others)]
            assert sizes[0] * sizes[3] == pytest.approx(sizes[1] * sizes[2])
        assert -(small[1] - eye) @ n == pytest.approx(distance)
        marks = [line.points for line in illustration.world.lines if len(line.points) == 3]
        for mark, corners in zip(marks, (large, small), strict=True):
            one, corner, other_end = mark - corners[1]
            np.testing.assert_allclose(corner, one + other_end, atol=1e-9)
            assert one @ other_end == pytest.approx(0.0, abs=1e-9)
            assert one @ (eye - corners[1]) > 0.0 < other_end @ (corners[2] - corners[1])


def test_no_projector_but_that_of_p_is_drawn() -> None:
    illustration = show(distance=4.0)
    (through,) = (line.points for line in illustration.world.lines if line.colour == "ink"
                  and len(line.points) == 2)  # fmt: skip
    point = next(t.point for t in illustration.world.texts if t.name == "P")
    np.testing.assert_allclose(through, [START.camera.eye, point])


def test_a_point_behind_the_eye_has_no_image_and_says_why() -> None:
    behind = tuple(2.0 * np.array(START.camera.eye) - START.camera.target)
    beside = tuple(np.array(START.camera.eye) + START.camera.frame[0])
    for place in (behind, beside, START.camera.eye):
        for distance in (4.0, -3.0):
            illustration = show(distance=distance, point=place)
            said = illustration.readings[2:5]  # what the projector gives
            if place != beside or said[0].value is None:  # beside it is a rounding's breadth
                assert [reading.value for reading in said] == [None] * 3
                assert all(r.note is not None and "behind" in r.note.sentence() for r in said)
                assert not illustration.image.dots and not illustration.world.dots
            assert_sound(PHENOMENON, illustration, START)


def test_a_plane_through_the_eye_is_refused() -> None:
    for zero in (0.0, -0.0, 0):
        with pytest.raises(Refusal) as caught:
            PHENOMENON.checked({"distance": zero})
        assert str(caught.value) == (
            "settings.distance = 0: must not be 0: the plane would go through the eye, where"
            " nothing is cut."
        )


@pytest.mark.parametrize(
    ("distance", "last_row", "product", "image"),
    [
        (4.0, (0.0, 0.0, -0.25, 0.0), (2.0, 3.0, -6.0, 1.5), (4 / 3, 2.0)),
        (-3.0, (0.0, 0.0, 1 / 3, 0.0), (2.0, 3.0, -6.0, -2.0), (-1.0, -1.5)),
    ],
)
def test_l5_the_matrix_with_one_over_d_is_the_lectures(
    distance: float, last_row: Any, product: Any, image: Any
) -> None:
    """000, (2) and 004: by hand, (2, 3, -6) becomes (2, 3, -6, -z/d), and that over its last."""
    projection = Projection(Camera((0, 0, 0), (0, 0, -1)), Perspective(60, 1, 30))
    illustration = show(projection, distance=distance, point=(2.0, 3.0, -6.0))
    said = readings(illustration)
    rows = np.reshape(said["projection, with −1/d"], (4, 4))
    assert rows[:3].tolist() == np.eye(4)[:3].tolist()
    assert rows[3] == pytest.approx(last_row, rel=1e-15)
    assert said["of P: (x, y, z, −z/d)"] == pytest.approx(product)
    assert (said["x_p = d·x / −z"], said["y_p = d·y / −z"]) == pytest.approx(image)
    assert [part / product[3] for part in product[:2]] == pytest.approx(image)
    turned = "upright" if distance > 0.0 else "upside down and left for right"
    assert said["the image on the plane"] == turned


def test_l5_from_the_side_both_triangles_have_their_lengths() -> None:
    """Of (2, 3, -6) at d = 4: y_p : d = y : w is 2 : 4 = 3 : 6; from above 4/3 : 4 = 2 : 6."""
    projection = Projection(Camera((0, 0, 0), (0, 0, -1)), Perspective(60, 1, 30))
    illustration = show(projection, distance=4.0, point=(2.0, 3.0, -6.0))
    assert dict(illustration.measured) == {"d": 4.0, "-z": 6.0}
    found = {
        each.name: (each.view, each.value, each.start.tolist(), each.end.tolist())
        for each in illustration.lengths
    }
    assert found == {
        "y": ("side", 3.0, [0.0, 0.0, -6.0], [0.0, 3.0, -6.0]),
        "y_p": ("side", 2.0, [0.0, 0.0, -4.0], [0.0, 2.0, -4.0]),
        "x": ("top", 2.0, [0.0, 0.0, -6.0], [2.0, 0.0, -6.0]),
        "x_p": ("top", pytest.approx(4 / 3), [0.0, 0.0, -4.0], [pytest.approx(4 / 3), 0.0, -4.0]),
    }


def test_l5_numbers_and_lines_about_d_are_highlighted_together() -> None:
    illustration = show()
    about = {reading.label: set(reading.about) for reading in illustration.readings}
    assert about["projection, with −1/d"] == {"settings.distance"} <= about["scale d / −z"]
    lit = [line for line in illustration.world.lines if "settings.distance" in line.about]
    eye = np.array(START.camera.eye)
    lengths = sorted(len(line.points) for line in lit)
    assert lengths == [2, 5]  # the axis from the eye to the plane, and the plane's border
    axis = next(line.points for line in lit if len(line.points) == 2)
    assert np.linalg.norm(axis - eye, axis=1) == pytest.approx([4.0, 0.0])
    assert illustration.measured[0] == ("d", 4.0)
