"""Calibrated cameras: what their numbers must be, and what is said of those of other conventions.

K maps x right, y down, z forward to pixels that are counted from the centre of the first one, as
`Intrinsics` describes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

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
FOUR_OR_K = QT_TRANSLATE_NOOP(
    "Refusal", "must be fx, fy, cx, cy, or the three rows of three numbers of a camera matrix K"
)
TRANSPOSED = QT_TRANSLATE_NOOP(
    "Refusal", "is a transposed K, with cx and cy in the last row: swap rows and columns"
)
LAST_ROW = QT_TRANSLATE_NOOP("Refusal", "must have the last row 0, 0, 1, or a multiple of it")
ZERO_BELOW = QT_TRANSLATE_NOOP("Refusal", "must be 0: below its diagonal, K has only zeros")
SKEWED = QT_TRANSLATE_NOOP(
    "Refusal", "is a skew of the pixels, which must be 0: the window of a lens is a rectangle"
)
AT_INFINITY = QT_TRANSLATE_NOOP(
    "Refusal",
    "must have a left 3 x 3 block with an inverse: the camera is at infinity, as a parallel one is",
)
MOST_SKEW_PX = 0.5
"""Most that a picture may move when the skew of a rounded P is left out."""
SINGULAR = 1e-12
_MOST_NORMALISED = 4.0  # a focal length in widths: a field of view of 14 degrees
_FEW_PX = 16


def intrinsics_of(given: Any) -> Intrinsics:
    """Return fx, fy, cx, cy from these four numbers or from K, (3, 3), whose scale is free.

    Raises
    ------
    Refusal
        For anything else: a K that is transposed or has skew is named as such.
    """
    try:
        shape = np.shape(given)
    except ValueError:  # rows of different lengths
        shape = ()
    if shape == (4,):
        parts = zip(Intrinsics._fields, given, strict=True)
        return Intrinsics(*(finite(name, value) for name, value in parts))
    if shape != (3, 3):
        raise Refusal("intrinsics", given, FOUR_OR_K)
    rows = [[finite(f"K[{i}, {j}]", given[i][j]) for j in range(3)] for i in range(3)]
    if rows[0][2] == rows[1][2] == 0.0 and rows[2][2] != 0.0 and any(rows[2][:2]):
        raise Refusal("K", rows, TRANSPOSED)
    if any(rows[2][:2]) or rows[2][2] == 0.0:
        raise Refusal("K", rows, LAST_ROW)
    (fx, skew, cx), (below, fy, cy) = ([cell / rows[2][2] for cell in row] for row in rows[:2])
    if below != 0.0:
        raise Refusal("K[1, 0]", below, ZERO_BELOW)
    if skew != 0.0:
        raise Refusal("K[0, 1]", skew, SKEWED)
    return Intrinsics(fx, fy, cx, cy)


def checked_intrinsics(given: ArrayLike, image_size: tuple[int, int]) -> Intrinsics:
    """Return fx, fy, cx, cy of a possible lens for an image of this size, or a `Refusal`."""
    fx, fy, cx, cy = found = intrinsics_of(given)
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
    return found


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


# --------------------------------------------------------------------------- a 3x4 matrix


class TakenApart(NamedTuple):
    """``P = scale K [R | t]`` in OpenCV's axes.

    P is the same camera at every scale and sign. Here K has a positive diagonal and the last cell
    1, R is a rotation, and the sign of `scale` is that of P's left determinant.
    """

    scale: float
    k: Array
    rotation: Array
    translation: Array


def taken_apart(p: ArrayLike) -> TakenApart:
    """Take a camera matrix P apart, (3, 4): RQ, by Gram and Schmidt from the last row up.

    Raises
    ------
    Refusal
        For a singular left 3x3 block, as a parallel projection has.
    """
    cells = np.asarray(p, dtype=np.float64)
    size = float(np.abs(cells).max())
    m = cells[:, :3] / size if size else cells[:, :3]
    rows = np.linalg.norm(m, axis=1)
    determinant = float(np.linalg.det(m))
    if abs(determinant) <= SINGULAR * float(rows.prod()):
        raise Refusal("P", cells.tolist(), AT_INFINITY)
    scale = math.copysign(float(rows[2]), determinant)
    m = m / scale
    k, rotation = np.eye(3), np.zeros((3, 3))
    rotation[2] = m[2]
    for i in (1, 0):
        rest = m[i].copy()
        for j in range(i + 1, 3):
            k[i, j] = m[i] @ rotation[j]
            rest -= k[i, j] * rotation[j]
        k[i, i] = np.linalg.norm(rest)
        rotation[i] = rest / k[i, i]
    translation = np.linalg.solve(k, cells[:, 3] / size / scale)
    return TakenApart(scale * size, k, rotation, read_only(translation))


def straightened(found: TakenApart, image_size: tuple[int, int]) -> tuple[Array, float]:
    """Return K without skew, and by how many pixels that moves the picture at most.

    Raises a `Refusal` if it is more than `MOST_SKEW_PX`, which no rounding of P explains.
    """
    k = found.k.copy()
    reach = max(abs(k[1, 2] + 0.5), abs(image_size[1] - 0.5 - k[1, 2])) / k[1, 1]
    moved = abs(float(k[0, 1])) * float(reach)
    if moved > MOST_SKEW_PX:
        raise Refusal("K[0, 1]", float(k[0, 1]), SKEWED)
    k[0, 1] = 0.0
    return k, moved
