"""Calibrated cameras: check their numbers, and convert those of other conventions.

K maps x right, y down, z forward to pixels that are counted from the centre of the first one, as
`Intrinsics` describes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from app.model.lenses.answers import Intrinsics
from app.model.limits import (
    NOT_ZERO,
    SMALLEST_FIELD,
    SMALLEST_OPENING,
    Array,
    finite,
    positive,
    read_only,
    within,
)
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal

X_LEFT = QT_TRANSLATE_NOOP(
    "Refusal",
    "must be greater than 0; below 0 the image's x points left: take fx = {0} and cx = W - 1 - cx",
)
Y_UP = QT_TRANSLATE_NOOP(
    "Refusal",
    "must be greater than 0; below 0 the image's y points up: take fy = {0} and cy = H - 1 - cy",
)
NORMALISED = QT_TRANSLATE_NOOP(
    "Refusal",
    "must be in pixels, but the four numbers are in widths and heights of the image: multiply fx"
    " and cx by {0}, fy and cy by {1}, then subtract 0.5 from cx and cy",
)
NOT_K = QT_TRANSLATE_NOOP(
    "Refusal", "must be fx, fy, cx, cy, or K: three rows fx, 0, cx and 0, fy, cy and 0, 0, 1"
)
TRANSPOSED = QT_TRANSLATE_NOOP(
    "Refusal", "is a transposed K, with cx and cy in the last row: swap rows and columns"
)
SKEWED = QT_TRANSLATE_NOOP(
    "Refusal", "is a skew of the pixels, which must be 0: the window of a lens is a rectangle"
)
AT_INFINITY = QT_TRANSLATE_NOOP(
    "Refusal",
    "must have a left 3 x 3 block with an inverse: the camera is at infinity, as a parallel one is",
)
SINGULAR = 1e-12
_MOST_NORMALISED = 4.0  # a focal length in widths: a field of view of 14 degrees
_FEW_PX = 16


def checked_intrinsics(given: Any, image_size: tuple[int, int]) -> Intrinsics:
    """Return fx, fy, cx, cy of a possible lens for an image of this size, or a `Refusal`.

    They are given as such, or as K, (3, 3), whose scale is free.
    """
    try:
        shape = np.shape(given)
    except ValueError:  # rows of different lengths
        shape = ()
    if shape == (3, 3):
        k = [[finite(f"K[{i}, {j}]", given[i][j]) for j in range(3)] for i in range(3)]
        (fx, skew, cx), (below, fy, cy), (*last, scale) = k
        if cx == cy == 0.0 != scale and any(last):
            raise Refusal("K", k, TRANSPOSED)
        if below or any(last) or not scale:
            raise Refusal("K", k, NOT_K)
        if skew:
            raise Refusal("K[0, 1]", skew, SKEWED)
        given = [part / scale for part in (fx, fy, cx, cy)]
    elif shape != (4,):
        raise Refusal("intrinsics", given, NOT_K)
    parts = zip(Intrinsics._fields, given, strict=True)
    fx, fy, cx, cy = intrinsics = Intrinsics(*(finite(name, value) for name, value in parts))
    width, height = image_size
    for name, value, bound in (("fx", fx, X_LEFT), ("fy", fy, Y_UP)):
        if value < 0.0:
            raise Refusal(name, value, bound, -value)
        positive(name, value)
    in_first_pixel = 0.0 <= cx <= 1.0 and 0.0 <= cy <= 1.0
    if in_first_pixel and max(fx, fy) <= _MOST_NORMALISED and min(image_size) >= _FEW_PX:
        raise Refusal("fx", fx, NORMALISED, width, height)
    for name, value, side, centre in (("fx", fx, width, cx), ("fy", fy, height, cy)):
        least = (abs(centre) + side + 1.0) * SMALLEST_FIELD
        within(name, value, least, side / (2.0 * SMALLEST_OPENING))
    return intrinsics


# --------------------------------------------------------------------------- poses


def rotation_from_vector(vector: Sequence[float]) -> Array:
    """Return the rotation about a vector by its length in radians, (3, 3): OpenCV's Rodrigues."""
    angle = math.hypot(*vector)
    half = math.sin(angle / 2.0) / angle if angle > 0.0 else 0.5
    return rotation_from_quaternion([math.cos(angle / 2.0), *(half * part for part in vector)])


def rotation_from_quaternion(wxyz: Sequence[float]) -> Array:
    """Return the rotation of a quaternion of any length but 0, Hamilton's convention, (3, 3)."""
    length = math.hypot(*wxyz)
    if length == 0.0:
        raise Refusal("quaternion", tuple(wxyz), NOT_ZERO)
    w, x, y, z = (part / length for part in wxyz)
    return np.array(
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ]
    )


def world_from_opencv(rotation: Array, translation: Array) -> Array:
    """Return the columns right, up, backward and eye of a pose ``x_camera = R x + t``, (3, 4).

    The camera's axes are OpenCV's and COLMAP's: x right, y down, z forward.
    """
    axes = rotation.T * (1.0, -1.0, -1.0)
    return np.column_stack([axes, -rotation.T @ translation])


class TakenApart(NamedTuple):
    """``P = scale K [R | t]``: K has a positive diagonal and ends in 1, and R is a rotation."""

    scale: float
    k: Array
    rotation: Array
    translation: Array


def taken_apart(p: Any) -> TakenApart:
    """Decompose a camera matrix, (3, 4); a `Refusal` if its left 3x3 block is singular."""
    cells = np.array(p, dtype=np.float64)
    size = float(np.abs(cells).max()) or 1.0
    m = cells[:, :3] / size
    if abs(np.linalg.det(m)) <= SINGULAR * np.linalg.norm(m, axis=1).prod():
        raise Refusal("P", cells.tolist(), AT_INFINITY)
    q, upper = np.linalg.qr(m[::-1].T)
    signs = np.sign(np.diag(upper))[::-1]
    k, rotation = upper.T[::-1, ::-1] * signs, signs[:, None] * q.T[::-1]
    sign = float(np.sign(np.linalg.det(rotation)))
    scale = sign * float(k[2, 2])
    k = k / k[2, 2]
    translation = read_only(np.linalg.solve(k, cells[:, 3] / size / scale))
    return TakenApart(scale * size, k, sign * rotation, translation)
