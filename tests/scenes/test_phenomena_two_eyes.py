"""Two eyes: parallax against 80 digits and VTK's stereo camera, and the screen plane."""

import math
import random
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from vtkmodules.vtkRenderingCore import vtkCamera

from app.model.projection import Array, Camera, Perspective, Projection
from app.model.refusal import Refusal
from app.scenes.phenomena.picture import section
from app.scenes.phenomena.two_eyes import PHENOMENON, eyes_of
from tests.oracles.exact import Exact, mp
from tests.oracles.illustrations import random_projection, reading, showing, subject_of, value, why

START = PHENOMENON.start
SUBJECT = subject_of(PHENOMENON)
shown = showing(PHENOMENON, SUBJECT)
ACROSS, DOWN, LARGEST = "horizontal parallax of P", "vertical parallax of P", "largest"
CAMERAS = "off-axis", "toed-in"


def eyes(projection: Projection = START, **settings: Any) -> tuple[Projection, Projection]:
    pair = eyes_of(projection, PHENOMENON.checked(settings))
    return pair.left, pair.right


def pixels(points: Array, projection: Projection = START, **settings: Any) -> Array:
    """In both eyes' whole pictures, (2, n, 2)."""
    return np.array([eye.trace(points).image for eye in eyes(projection, **settings)])


def tangents(
    x: float, y: float, w: float, h: float, distance: float, t: float
) -> list[tuple[float, float]]:
    """The formulas of the module's text, for the left and the right eye."""
    found = []
    for side in (-1.0, 1.0):
        below = w - side * t * (x - side * h)
        across = x - side * (h / distance) * (distance - w)
        found.append((across / below, y * math.hypot(1.0, t) / below))
    return found


def by_hand(projection: Projection, point: Array, h: float, toed_in: bool) -> list[list[Any]]:
    """Pixels for both eyes in 80 digits: move the point into each eye's own frame, and divide.

    Off axis, the window in the screen plane stays where it is; toed in, it turns with the eye.
    """
    x, y, z = (mp.mpf(part) for part in Exact(projection)(point.tolist()).view)
    h, d = mp.mpf(h), mp.mpf(projection.camera.distance)
    left, right, bottom, top = (
        side / mp.mpf(projection.lens.near) for side in Exact(projection).window()
    )
    pixels = []
    for side in (-1, 1):
        if toed_in:
            turn = -side * mp.atan(h / d)  # the left eye turns right
            ahead, beside = -z, x - side * h
            ahead, beside = (
                ahead * mp.cos(turn) + beside * mp.sin(turn),
                beside * mp.cos(turn) - ahead * mp.sin(turn),
            )
            slope_x, slope_y = beside / ahead, y / ahead
        else:
            on_screen = side * h + (x - side * h) * d / -z  # where the projector meets the plane
            slope_x, slope_y = on_screen / d, y / -z
        width, height = projection.image_size
        across = (slope_x - left) / (right - left) * width
        pixels.append([across, (top - slope_y) / (top - bottom) * height])
    return pixels


@pytest.mark.parametrize("cameras", CAMERAS)
def test_pixels_and_parallaxes_are_those_of_80_digits_and_of_the_formula(cameras: str) -> None:
    dice, compared = random.Random(48), 0
    for _ in range(60):
        seen = random_projection(dice, START).with_eye()
        s = dice.uniform(0.0, 2.0)
        point = np.array([dice.uniform(-2, 2), dice.uniform(0, 4), dice.uniform(-3, 3)])
        how = {"cameras": cameras, "separation": s}
        if not all(eye.trace(point).in_front for eye in eyes(seen, **how)):
            continue
        drawn = pixels(point, seen, **how)
        if np.abs(drawn).max() > 1e5:
            continue
        compared += 1
        exact = by_hand(seen, point, s / 2.0, cameras == "toed-in")
        assert np.allclose(drawn, np.array(exact, dtype=float), rtol=1e-10, atol=1e-7)
        x, y, z = seen.trace(point).view.tolist()
        d, (left, right, bottom, top) = seen.camera.distance, seen.window
        t = s / 2.0 / d if cameras == "toed-in" else 0.0
        scale = seen.lens.near / np.array([right - left, bottom - top]) * seen.image_size
        formula = np.array(tangents(x, y, -z, s / 2.0, d, t))
        apart = (formula[1] - formula[0]) * scale
        here = shown(seen, **how, point=tuple(point.tolist()))
        assert value(here, ACROSS) == pytest.approx(apart[0], abs=1e-6)
        assert value(here, DOWN) == pytest.approx(apart[1], abs=1e-6)
        closed = -s * (1.0 / -z - 1.0 / d), 0.0  # the module's last two lines
        if t:
            below = (-z + t * (x + s / 2.0)) * (-z - t * (x - s / 2.0))
            closed = apart[0] / scale[0], 2.0 * t * x * y * math.hypot(1.0, t) / below
        assert apart == pytest.approx(np.array(closed) * scale, abs=1e-6)
    assert compared > 30


def vtk_pixel(camera: vtkCamera, point: Array) -> list[float]:
    width, height = START.image_size
    matrix = camera.GetCompositeProjectionTransformMatrix(width / height, -1.0, 1.0)
    x, y, _, w = matrix.MultiplyPoint((*point.tolist(), 1.0))
    return [(x / w + 1.0) * width / 2.0, (1.0 - y / w) * height / 2.0]


def test_vtk_s_own_stereo_camera_and_two_turned_ones_see_the_same() -> None:
    points = SUBJECT.points[::7]
    off_axis, toed_in = (pixels(points, cameras=cameras) for cameras in CAMERAS)
    low_left, low_right, up_right, _ = section(START, 8.0)
    for eye, side in enumerate((-0.4, 0.4)):
        screen = vtkCamera()
        screen.UseOffAxisProjectionOn()
        screen.SetScreenBottomLeft(*low_left)
        screen.SetScreenBottomRight(*low_right)
        screen.SetScreenTopRight(*up_right)
        screen.SetEyePosition((0.0, 1.8, 8.0))
        screen.SetEyeSeparation(0.8)
        screen.SetLeftEye(side < 0.0)
        turned = vtkCamera()
        turned.SetPosition(side, 1.8, 8.0)
        turned.SetViewAngle(45.0)
        for camera in (screen, turned):
            camera.SetFocalPoint(0.0, 1.8, 0.0)
            camera.SetClippingRange(4.0, 14.0)
        screen.SetPosition(0.0, 1.8, 8.0)
        for camera, ours in ((screen, off_axis), (turned, toed_in)):
            theirs = [vtk_pixel(camera, point) for point in points]
            assert np.allclose(ours[eye], theirs, atol=1e-8)


def test_the_start_by_hand() -> None:
    """P is 1 to the right, 1 down and 5 away; a unit at distance 1 has 360 cot 22.5° pixels."""
    px = 360.0 / math.tan(math.radians(22.5))
    off_axis, toed_in = (shown(cameras=cameras) for cameras in CAMERAS)
    assert value(off_axis, ACROSS) == pytest.approx(px * 0.8 * (1 / 8 - 1 / 5))
    assert value(off_axis, DOWN) == value(off_axis, LARGEST) == 0.0
    t = 0.4 / 8
    below = (5 + t * 1.4) * (5 - t * 0.6)
    assert value(toed_in, DOWN) == pytest.approx(px * 2 * t * math.hypot(1, t) / below)
    half_high = 8 * math.tan(math.radians(22.5))
    wide = 16 / 9 * half_high
    corner = 2 * t * math.hypot(1, t) * wide * half_high
    corner /= (8 + t * (wide + 0.4)) * (8 - t * (wide - 0.4))
    assert value(toed_in, LARGEST) == pytest.approx(px * corner)
    assert value(toed_in, "turns in") == pytest.approx(math.degrees(math.atan(0.05)))
    assert reading(off_axis, "P appears").value == "before the screen"


def test_what_lies_in_the_screen_plane_does_not_move_and_the_rest_does() -> None:
    """Off axis; toed in, even points of the screen plane move beside its middle."""
    front = np.array([(-1.5, 0.0, 0.0), (0.9, 4.0, 0.0)])
    left, right = pixels(front)
    assert left == pytest.approx(right, abs=1e-10)
    left, right = pixels(front, cameras="toed-in")
    assert (np.abs(left - right).max(axis=1) > 0.5).all()
    moved = PHENOMENON.follow(START, {"screen": 8.0}, PHENOMENON.checked({"screen": 5.0}))
    in_it = shown(moved)
    assert value(in_it, ACROSS) == 0.0
    assert reading(in_it, "P appears").value == "in the screen"
    behind = shown(moved, point=(1.7, 3.4, -4.0))
    assert value(behind, ACROSS) > 30.0
    assert reading(behind, "P appears").value == "behind the screen"


@pytest.mark.parametrize("away", [0.0, 1e9])
@pytest.mark.parametrize("fov_y_deg", [1e-3, 45.0])
def test_off_axis_no_point_is_higher_for_one_eye(away: float, fov_y_deg: float) -> None:
    """By rounding too, with many pixels and far from the origin."""
    dice = random.Random(6)
    for _ in range(30):
        eye, target = ([away + dice.uniform(-9, 9) for _ in range(3)] for _ in range(2))
        camera = Camera((eye[0], eye[1], eye[2]), (target[0], target[1], target[2]))
        ahead = 2.0 * np.array(target) - eye + camera.frame[0]
        seen = Projection(camera, Perspective(fov_y_deg, 0.1, 1e9), (16384, 16384))
        found = shown(seen, point=tuple(ahead.tolist()))
        assert value(found, DOWN) == value(found, LARGEST) == 0.0
        assert abs(value(found, ACROSS)) > 0.0


def test_the_screen_plane_is_the_target_s_and_moves_nothing_else() -> None:
    moved = PHENOMENON.follow(START, {"screen": 8.0}, PHENOMENON.checked({"screen": 5.5}))
    assert moved == replace(START, camera=Camera((0.0, 1.8, 8.0), (0.0, 1.8, 2.5)))
    assert PHENOMENON.implied(moved, PHENOMENON.checked({})) == {"screen": 5.5}
    assert np.allclose(moved.trace(SUBJECT.points).image, START.trace(SUBJECT.points).image)


def test_off_axis_eyes_share_one_window_in_the_screen_plane() -> None:
    for eye in eyes():
        assert np.allclose(section(eye, 8.0), section(START, 8.0))
    # glFrustum's l and r of the left eye: half the separation to the right, at n/D of its size.
    left, right, bottom, top = START.window
    expected = (left + 0.2, right + 0.2, bottom, top)
    assert eyes()[0].window == pytest.approx(expected)


def test_what_is_impossible_is_refused_in_one_sentence() -> None:
    with pytest.raises(Refusal) as caught:
        PHENOMENON.changed(START, PHENOMENON.checked({}), {"screen": 3.0})
    said = "settings.screen = 3: must not be before the near plane (4)."
    assert str(caught.value) == said
    with pytest.raises(Refusal) as caught:
        PHENOMENON.checked({"separation": -0.1})
    assert str(caught.value).startswith("settings.separation = -0.1: ")
    later = replace(START, lens=Perspective(45.0, 9.0, 14.0))  # the near plane moves past it
    warning = shown(later).warning
    assert warning is not None and "before the near plane" in warning.sentence()


def test_a_point_beside_the_eyes_has_no_parallax() -> None:
    beside = shown(point=(0.0, 1.8, 8.0))
    assert "not in front" in why(beside, ACROSS) and "not in front" in why(beside, DOWN)
    assert not beside.image.dots
    assert shown(separation=0.0).image.dots[0].point == pytest.approx(
        shown(separation=1e-12).image.dots[0].point
    )


@pytest.mark.parametrize("pictures", ["beside", "crossed", "red-cyan"])
def test_p_is_marked_where_each_eye_s_picture_lies(pictures: str) -> None:
    left, right = pixels(np.array((1.0, 0.8, 3.0)))
    moves = {"beside": (-320, 320), "crossed": (320, -320), "red-cyan": (0, 0)}[pictures]
    dots = shown(pictures=pictures).image.dots
    for dot, place, move in zip(dots, (left, right), moves, strict=True):
        assert dot.point == pytest.approx(place + np.array([move, 0.0]))


@pytest.mark.parametrize("cameras", CAMERAS)
def test_the_projectors_of_p_meet_in_p_and_cut_their_eyes_windows(cameras: str) -> None:
    illustration, pair = shown(cameras=cameras), eyes(cameras=cameras)
    hits = {dot.name: dot.point for dot in illustration.world.dots if dot.name.startswith("P_")}
    for eye, hit in zip(pair, (hits["P_l"], hits["P_r"]), strict=True):
        assert eye.trace(hit).image == pytest.approx(eye.trace((1.0, 0.8, 3.0)).image)
        assert -eye.trace(hit).view[2] == pytest.approx(eye.camera.distance)
