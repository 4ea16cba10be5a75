"""How u, v, n come out of eye, target and up, and how well (lecture 004; 001 and 003).

    n = (eye - target)/|eye - target|    u = up x n/|up x n|    v = n x u

The length of up x n is |up| times the sine of the angle between up and the view direction. A small
error in up, across, turns u and v by that error divided by the sine: without bound as up nears
the view direction, and then no u can be told from another.
"""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from app.arithmetic import double_double as dd
from app.model.limits import cos_sin_deg
from app.model.projection import Camera, Vector

STEPS = ("eye", "look", "up", "n", "u", "v", "view")
"""What is built in each step: the camera's three vectors, the three axes, the view matrix."""


class UpAndView(NamedTuple):
    """How up stands to the view direction.

    Attributes
    ----------
    angle_deg : float
        Between them, 0 to 180.
    cross : Vector
        up x n.
    length : float
        Of up x n.
    magnified : float
        By how much an error in the direction of up is larger in u and v: 1/sine.
    """

    angle_deg: float
    cross: Vector
    length: float
    magnified: float


@lru_cache(maxsize=8)
def up_and_view(camera: Camera) -> UpAndView:
    """How the camera's up stands to its view direction, each number rounded once."""
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
    """`view_from_world`: the rotation's rows u, v, n, and -R e; each number rounded once.

    As the first of `Projection.stages`, without computing the others.
    """
    moved = camera.exact_view((0.0, 0.0, 0.0))
    rows = [(*map(float, axis), float(part))
            for axis, part in zip(camera.exact_frame, moved, strict=True)]  # fmt: skip
    return (*rows, (0.0, 0.0, 0.0, 1.0))


def turned_up(camera: Camera, angle_deg: float) -> Camera:
    """The same camera with up at another angle to the view direction, in the plane it is in.

    u, v and n stay as they are: what changes is how well up determines them.

    Parameters
    ----------
    camera : Camera
    angle_deg : float
        0 is along the view direction.

    Raises
    ------
    Refusal
        If up is then parallel to the view direction, or not a finite number.
    """
    _, v, n = camera.frame
    cosine, sine = cos_sin_deg(angle_deg)
    up = sine * v - cosine * n
    return replace(camera, up=tuple((up + 0.0).tolist()))


def most_turned_deg(off_deg: float, error_deg: float) -> float:
    """How far an error in up can turn u and v, in degrees, whichever way it points.

    The line of sight and up are the pole and a point of a sphere: the error's circle about that
    point is seen from the pole under ``asin(sin(error)/sin(angle))`` to both sides, and from all
    of them if the pole is inside.

    Parameters
    ----------
    off_deg : float
        Between up and the line of sight, 0 to 90.
    error_deg : float
        Of up's direction, less than 90.
    """
    if off_deg < error_deg:
        return 180.0
    ratio = math.sin(math.radians(error_deg)) / math.sin(math.radians(off_deg))
    return math.degrees(math.asin(min(1.0, ratio)))


def nudged_up(camera: Camera, angle_deg: float) -> Camera:
    """The same camera with an error in up: turned across, towards u."""
    cosine, sine = cos_sin_deg(angle_deg)
    up = np.array(camera.up)
    nudged = cosine * up + sine * math.hypot(*camera.up) * camera.frame[0]
    return replace(camera, up=tuple(nudged.tolist()))
