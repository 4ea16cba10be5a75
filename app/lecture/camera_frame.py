"""How eye, target and up determine u, v, n, and how accurately (lecture 004; 001 and 003).

    n = (eye - target)/|eye - target|    u = up x n/|up x n|    v = n x u

The length of up x n is |up| times the sine of the angle between up and the view direction. A small
sideways error in up turns u and v by that error divided by the sine. The turn has no bound as up
approaches the view direction.
"""

import math
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from app.arithmetic import double_double as dd
from app.model.limits import cos_sin_deg, finite
from app.model.projection import Camera, Vector

STEPS = ("eye", "look", "up", "n", "u", "v", "view")
"""The steps: the camera's three vectors, the three axes, the view matrix."""


class UpAndView(NamedTuple):
    """The angle between up and the view direction, and its consequences."""

    angle_deg: float  # 0 to 180
    cross: Vector  # up x n; `length` is its length
    length: float
    magnified: float  # the factor by which an error in the direction of up grows in u and v: 1/sine


@lru_cache(maxsize=8)
def up_and_view(camera: Camera) -> UpAndView:
    """Return the relation of the camera's up and view direction; each number is rounded once."""
    a, b, c = camera.exact_frame[2]
    x, y, z = map(Fraction, camera.up)
    cross = (y * c - z * b, z * a - x * c, x * b - y * a)
    length = dd.root(sum((part * part for part in cross), Fraction(0)))
    up_length = dd.root(x * x + y * y + z * z)
    sine, cosine = float(length / up_length), float(-(x * a + y * b + z * c) / up_length)
    angle_deg = math.degrees(math.atan2(sine, cosine))
    components = float(cross[0]), float(cross[1]), float(cross[2])
    return UpAndView(angle_deg, components, float(length), 1.0 / sine)


def view_matrix(camera: Camera) -> tuple[tuple[float, ...], ...]:
    """Return `view_from_world` as `Projection.stages` has it, without the other stages."""
    moved = camera.exact_origin
    rows = [(*map(float, axis), float(part))
            for axis, part in zip(camera.exact_frame, moved, strict=True)]  # fmt: skip
    return (*rows, (0.0, 0.0, 0.0, 1.0))


def turned_up(camera: Camera, angle_deg: float) -> Camera:
    """Return the camera with up at another angle to the view direction, in up's present plane.

    u, v and n do not change, only how accurately up determines them. Raises a `Refusal` if up is
    then parallel to the view direction, or not a finite number.
    """
    _, v, n = camera.frame
    cosine, sine = cos_sin_deg(finite("up", angle_deg))
    up = sine * v - cosine * n
    return replace(camera, up=tuple((up + 0.0).tolist()))


def most_turned_deg(off_deg: float, error_deg: float) -> float:
    """Return the largest turn of u and v, in degrees, by an error in the direction of up.

    Up is 0 to 90 degrees off the line of sight, and the error is less than 90. On a
    sphere, the line of sight is the pole and up is a point. From the pole, the error's circle about
    that point spans ``asin(sin(error)/sin(angle))`` to both sides, and all directions if the pole
    is inside.
    """
    if off_deg < error_deg:
        return 180.0
    ratio = math.sin(math.radians(error_deg)) / math.sin(math.radians(off_deg))
    return math.degrees(math.asin(min(1.0, ratio)))


def nudged_up(camera: Camera, angle_deg: float) -> Camera:
    """Return the camera with an error in up, which is turned towards u."""
    cosine, sine = cos_sin_deg(angle_deg)
    up = np.array(camera.up)
    nudged = cosine * up + sine * math.hypot(*camera.up) * camera.frame[0]
    return replace(camera, up=tuple(nudged.tolist()))
