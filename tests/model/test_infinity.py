"""Points at infinity: directions through every stage, held against 80 digits and the limit."""

import math
from typing import Any

import numpy as np
import pytest

from app.model.chain import FiveTiles
from app.model.infinity import homogeneous, trace_at_infinity
from app.model.projection import (
    LARGEST,
    Camera,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
    Vector,
)
from app.model.refusal import Refusal
from app.precision.levels import trace_homogeneous
from app.scenes.phenomena.vanishing_points import PHENOMENON, vanishing
from tests.oracles.exact import Exact, dot, mp, vector

CAMERA = Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0))
FAR_AWAY = Camera((1e9 + 6.0, 5.0, -1e9), (1e9, 2.2, -1e9 - 9.0))
CENTRAL: list[Lens] = [
    Perspective(45.0, 1.0, 30.0),
    Perspective(45.0, 1.0, math.inf),
    Perspective(1e-3, 1e-6, 1e6),
    Frustum(-1.0, 3.0, -0.5, 2.0, 2.0, 2.000001),
]


def true_image(projection: Projection, direction: Vector) -> tuple[list[Any], Any, Any]:
    """Pixel, z of an OpenGL cube and w of a direction, from lecture 000 (4): n x/w on near."""
    oracle = Exact(projection)
    x, y, z = (dot(row, vector(direction)) for row in oracle.frame)
    lens, w = projection.lens, -z
    left, right, bottom, top = oracle.window()
    near, far = mp.mpf(lens.near), mp.mpf(lens.far)
    on_near = near * x / w, near * y / w
    ndc = [
        (2 * place - low - high) / (high - low)
        for place, low, high in zip(on_near, (left, bottom), (right, top), strict=True)
    ]
    pixel = [(1 + ndc[0]) * oracle.width / 2, (1 - ndc[1]) * oracle.height / 2]
    # -(f + n)/(f - n) z / w, whose limit for far = inf is 1.
    return pixel, mp.mpf(1) if mp.isinf(far) else (far + near) / (far - near), w


@pytest.mark.parametrize("lens", CENTRAL)
@pytest.mark.parametrize("camera", [CAMERA, FAR_AWAY])
def test_l13_a_vanishing_point_has_every_digit(lens: Lens, camera: Camera) -> None:
    """The eye is not subtracted from a direction: at 1e9 from the origin it costs no digit."""
    projection = Projection(camera, lens)
    for direction in ((0.0, 0.0, -1.0), (-0.3, 1e-9, -1e-3), (-1e100, -3e99, -2e100)):
        found = trace_at_infinity(projection, direction)
        pixel, z, w = true_image(projection, direction)
        assert found.in_front and found.world.tolist() == [*direction, 0.0]
        assert found.view[3] == 0.0 and float(w) == found.clip[3] == -found.view[2]
        assert found.image.tolist() == list(map(float, pixel))
        assert found.ndc[2] == float(z) and found.depth == float((z + 1) / 2)
        assert bool(found.outside[1]) == (lens.far != math.inf) and not found.outside[0]


def test_l13_it_is_the_phenomenon_s_vanishing_point() -> None:
    for point, axis in zip(vanishing(PHENOMENON.start), np.eye(3), strict=True):
        x, y, z = (point.sign * axis).tolist()
        found = trace_at_infinity(PHENOMENON.start, (x, y, z))
        assert found.clip == pytest.approx(point.clip, abs=1e-15)
        assert (found.clip[3] == 0.0) == (point.pixel is None)
        if point.pixel is not None:
            assert found.image == pytest.approx(point.pixel, rel=1e-14)


def test_l13_parallel_to_the_image_w_is_exactly_0() -> None:
    """(eye - target) . d = 6*3 + 2.75*0 - 9*2 = 0, though n itself is irrational."""
    projection = Projection(Camera((6.0, 5.0, 9.0), (0.0, 2.25, 0.0)), CENTRAL[0])
    found = trace_at_infinity(projection, (3.0, 0.0, -2.0))
    assert found.clip[3] == 0.0 and not found.in_front and np.isnan(found.image).all()
    assert found.clip[0] > 0.0


def test_l13_behind_the_eye_there_is_no_picture_but_of_the_opposite() -> None:
    projection = Projection(CAMERA, CENTRAL[0])
    found = trace_at_infinity(projection, (0.0, 0.0, 1.0))
    assert not found.in_front and found.clip[3] < 0.0 and np.isnan(found.ndc).all()
    opposite = trace_at_infinity(projection, (0.0, 0.0, -1.0))
    assert opposite.in_front and (opposite.clip == -found.clip).all()


@pytest.mark.parametrize("lens", [Orthographic(), Oblique(alpha_deg=60.0)])
def test_l13_a_parallel_lens_leaves_directions_at_infinity(lens: Lens) -> None:
    projection = Projection(CAMERA, lens)
    found = trace_at_infinity(projection, (1.0, 2.0, 3.0))
    assert found.clip[3] == 0.0 and not found.in_front
    ends = projection.trace([(5.0, 5.0, 5.0), (6.0, 7.0, 8.0)]).clip
    assert found.clip == pytest.approx(ends[1] - ends[0], abs=1e-14)


def test_l13_another_w_divides_once() -> None:
    assert homogeneous(1.0, 2.0, 3.0, -3.0) == (1.0 / -3.0, 2.0 / -3.0, -1.0, 1.0)
    assert homogeneous(1, 0, 0, -0.0) == (1.0, 0.0, 0.0, 0.0)
    assert homogeneous(1, 2, 3, 1) == (1.0, 2.0, 3.0, 1.0)


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ((0.0, -0.0, 0.0, 0.0), "w = 0: must not be 0 if x, y and z are 0"),
        ((1.0, 2.0, 3.0, math.nan), "w = nan: must be a finite number"),
        ((1.0, math.inf, 3.0, 0.0), "y = inf: must be a finite number"),
        ((1e308, 0.0, 0.0, 0.0), f"x = 1e+308: must be at most {LARGEST}"),
        ((1e100, 0.0, 0.0, 1e-250), "x/w = inf: must be a finite number"),
        ((0.0, 0.0, 1.0, 1e-150), f"z/w = 1e+150: must be at most {LARGEST}"),
    ],
)
def test_l13_what_is_no_point_is_refused(row: tuple[float, ...], said: str) -> None:
    with pytest.raises(Refusal) as error:
        homogeneous(*row)
    assert str(error.value).startswith(said)


@pytest.mark.parametrize("precision", ["float32", "float64", "exact"])
def test_l13_points_and_directions_go_together(precision: Any) -> None:
    projection = Projection(CAMERA, CENTRAL[0])
    rows = [(1.0, 2.0, 3.0, 1.0), (0.0, 0.0, -1.0, 0.0), (0.0, 1.0, 0.0, 1.0)]
    found = trace_homogeneous(projection, rows, precision)
    assert found.world.tolist() == [list(row) for row in rows]
    assert found.view[:, 3].tolist() == [1.0, 0.0, 1.0]
    assert found.image[1].tolist() == trace_at_infinity(projection, (0.0, 0.0, -1.0)).image.tolist()
    assert found.image[::2] == pytest.approx(
        projection.trace([(1.0, 2.0, 3.0), (0.0, 1.0, 0.0)]).image, rel=1e-5
    )


def test_l13_a_direction_of_the_object_is_turned_and_scaled_but_not_moved() -> None:
    """Turned by 90 degrees about y, x of the object runs along -z; twice as long, however long."""
    placement = FiveTiles((7.0, -3.0, 1e9), (0.0, 90.0, 0.0), (2.0, 1.0, 1.0)).chain
    projection = Projection(CAMERA, CENTRAL[0], placement=placement)
    for size in (1.0, LARGEST):
        found = trace_homogeneous(projection, [(size, 0.0, 0.0, 0.0)], space="object")
        assert found.world[0] == pytest.approx([0.0, 0.0, -2.0 * size, 0.0], abs=1e-30 * size)
        seen = trace_at_infinity(projection, (0.0, 0.0, -1.0)).image
        assert found.image[0] == pytest.approx(seen, rel=1e-15)
