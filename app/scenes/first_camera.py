"""The first camera of a scene: it sees the whole mesh, with numbers of few digits."""

import math
from collections.abc import Callable, Sequence

import numpy as np

from app.model.limits import vector
from app.model.projection import Camera, Perspective, Projection, Vector
from app.scenes.shapes import box_corners

FRAMED_FROM = (0.6, 0.45, 0.9)  # direction from a box to the eye of `frame_camera`; any length
_FOV_DEG = 38.0


def frame_camera(lower: Sequence[float], upper: Sequence[float]) -> Projection:
    """Place a camera so that a box (world bounds, not a point) is in view with room around it.

    Near and far are close round the box, so that the whole frustum can be seen beside it.
    """
    size = math.dist(lower, upper)
    # Rounded to a thousandth of the size, for the number fields.
    decimals = 3 - math.floor(math.log10(size))
    target = rounded(centre_of(lower, upper), decimals)
    toward_eye = vector(np.array(FRAMED_FROM) / math.hypot(*FRAMED_FROM))
    u, v, n = Camera(toward_eye, (0.0, 0.0, 0.0)).frame

    aspect = Projection().aspect
    tan_y = math.tan(math.radians(_FOV_DEG / 2.0))
    margin = 0.8  # of the half picture that the box may fill
    corners = box_corners(lower, upper) - target
    radius = float(np.linalg.norm(corners / size, axis=1).max()) * size
    for_width = corners @ n + abs(corners @ u) / (margin * tan_y * aspect)
    for_height = corners @ n + abs(corners @ v) / (margin * tan_y)
    distance = max(float(for_width.max()), float(for_height.max()), 1.25 * radius)
    eye = vector(target + distance * np.array(toward_eye))
    camera = Camera(rounded(eye, decimals), target)
    near = _two_digits(camera.distance - 1.05 * radius, math.floor)
    far = _two_digits(camera.distance + 1.05 * radius, math.ceil)
    return Projection(camera, Perspective(_FOV_DEG, near, far))


def centre_of(lower: Sequence[float], upper: Sequence[float]) -> Vector:
    x, y, z = (low + (high - low) / 2.0 for low, high in zip(lower, upper, strict=True))
    return x, y, z


def rounded(point: Sequence[float], decimals: int) -> Vector:
    x, y, z = (round(part, decimals) + 0.0 for part in point)  # + 0.0: no minus zero
    return x, y, z


def _two_digits(value: float, rounding: Callable[[float], int]) -> float:
    exponent = math.floor(math.log10(value)) - 1
    return float(f"{rounding(value / 10.0**exponent)}e{exponent}")
