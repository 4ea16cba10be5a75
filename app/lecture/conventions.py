"""Our matrices in the conventions of other programs, and the frustum's planes in world space."""

import math
import operator
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from app.arithmetic.rationals import Rationals, product
from app.model.clipping import boundaries
from app.model.limits import DEPTH_RANGES, PLANES, Array, DepthRange
from app.model.projection import Projection


class Convention(NamedTuple):
    """How another program's spaces differ from ours: factors, 1 or -1, of x, y, z and w.

    A reversed depth range stays reversed. `rows` tells whether its vectors are rows.
    """

    world: tuple[int, ...]
    view: tuple[int, ...]
    clip: tuple[int, ...]
    depth: DepthRange
    rows: bool


_SAME, _Y, _Z, _YZ = (1, 1, 1, 1), (1, -1, 1, 1), (1, 1, -1, 1), (1, -1, -1, 1)
CONVENTIONS = {
    "opengl": Convention(_SAME, _SAME, _SAME, "opengl", False),
    "direct3d": Convention(_Z, _Z, _SAME, "direct3d", True),
    "vulkan": Convention(_SAME, _SAME, _Y, "direct3d", False),
    "unity": Convention(_Z, _SAME, _SAME, "opengl", False),
    "opencv": Convention(_SAME, _YZ, _SAME, "opengl", False),
}


def in_convention(projection: Projection, name: str, *, rows: bool) -> dict[str, Array]:
    """Return the matrices of the camera and the lens as another program writes them.

    OpenCV's lens is K, (3, 3), and its camera R and t, (3, 4). Raises a `Refusal` for OpenCV, if
    the projectors do not meet in the eye.
    """
    other = CONVENTIONS[name]
    if set(DEPTH_RANGES[projection.depth]) != set(DEPTH_RANGES[other.depth]):
        projection = projection.with_depth(other.depth)
    view_stage, clip_stage = projection.stages[1], projection.direct_stages[0]
    view = _signed(view_stage.exact, other.view, other.world)
    clip = _signed(clip_stage.exact, other.clip, other.view)
    if name == "opencv":
        fx, fy, cx, cy = map(Fraction, projection.intrinsics)
        zero, one = Fraction(0), Fraction(1)
        names, clip = ("camera_from_world", "image_from_camera"), [[fx, zero, cx], [zero, fy, cy]]
        view, clip = view[:3], [*clip, [zero, zero, one]]
    else:
        names = view_stage.name, clip_stage.name
    whole = f"{names[1].partition('_')[0]}_from_world"
    matrices = {names[0]: view, names[1]: clip, whole: product(clip, view)}
    arrays = {name: np.array(matrix, dtype=np.float64) for name, matrix in matrices.items()}
    return {name: array.T if rows else array for name, array in arrays.items()}


def _signed(matrix: Rationals, after: Sequence[int], before: Sequence[int]) -> Rationals:
    return [
        [sign * part for part in map(operator.mul, row, before)]
        for sign, row in zip(after, matrix, strict=True)
    ]


def world_planes(projection: Projection) -> dict[str, list[float] | None]:
    """Return a, b, c, d of the view volume's six planes, with ``ax + by + cz + d >= 0`` inside.

    The normal a, b, c has length 1 and points inwards. A plane at infinity is None.
    """
    coefficients = np.array(projection.direct_stages[1].exact).T
    rows = boundaries(coefficients, projection.depth).T.tolist()
    planes: dict[str, list[float] | None] = {}
    for name, row in zip(PLANES, rows, strict=True):
        length = math.hypot(*map(float, row[:3]))
        planes[name] = [float(part) / length + 0.0 for part in row] if length else None
    return planes
