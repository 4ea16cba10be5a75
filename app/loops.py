"""The loop that numpy would run in eight passes over the points, compiled by numba into one.

Importing this room compiles it, or loads what was compiled before: some tenths of a second, and so
it is imported by the first call that needs it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any, TypeVar, cast

import numpy as np
from numba import njit, types
from numpy.typing import NDArray

_Array = NDArray[np.float64]
_Loop = TypeVar("_Loop", bound=Callable[..., object])
_GIVEN = types.Array(types.float64, 2, "C", readonly=True)
_WRITTEN = types.Array(types.float64, 2, "C")


def _compiled(signature: Any) -> Callable[[_Loop], _Loop]:
    """Compile for a signature, and keep what is compiled where there is a folder to keep it in."""

    def compiled(function: _Loop) -> _Loop:
        # A product and a sum may be rounded once, where the processor can: closer, and no slower.
        compiler = partial(njit, signature, error_model="numpy", fastmath={"contract"})
        try:
            return cast(_Loop, compiler(cache=True)(function))
        except Exception:  # no folder may be written to, the disk is full, a file in it is damaged
            return cast(_Loop, compiler()(function))

    return compiled


@_compiled(types.boolean(_GIVEN, _GIVEN, types.float64, _GIVEN, _WRITTEN))
def project_rows(eye: _Array, matrix: _Array, factor: float, points: _Array, out: _Array) -> bool:
    """Project points with one matrix and one division, eye first.

    Parameters
    ----------
    eye : (3, 1) float64 array
        Is subtracted from the points; C-contiguous, as the other arrays are.
    matrix : (4, 4) float64 array
        From what is left of them, and 1, to the numerators of the three rows, and w.
    factor : float
        By which the third row is multiplied at the end.
    points : (3, n) float64 array
        World coordinates.
    out : (3, n) float64 array
        Is written to; NaN where w <= 0.

    Returns
    -------
    bool
        Whether each point is behind the eye plane or has a picture of finite numbers.
    """
    # By name, or they would be read again for each point: it might have been written over them.
    eye_x, eye_y, eye_z = eye[0, 0], eye[1, 0], eye[2, 0]
    x_x, x_y, x_z, x_1 = matrix[0, 0], matrix[0, 1], matrix[0, 2], matrix[0, 3]
    y_x, y_y, y_z, y_1 = matrix[1, 0], matrix[1, 1], matrix[1, 2], matrix[1, 3]
    z_x, z_y, z_z, z_1 = matrix[2, 0], matrix[2, 1], matrix[2, 2], matrix[2, 3]
    w_x, w_y, w_z, w_1 = matrix[3, 0], matrix[3, 1], matrix[3, 2], matrix[3, 3]
    well = True
    for i in range(points.shape[1]):
        x, y, z = points[0, i] - eye_x, points[1, i] - eye_y, points[2, i] - eye_z
        w = w_x * x + w_y * y + w_z * z + w_1
        over_w = 1.0 / w if w > 0.0 else math.nan
        right = (x_x * x + x_y * y + x_z * z + x_1) * over_w
        down = (y_x * x + y_y * y + y_z * z + y_1) * over_w
        depth = (z_x * x + z_y * y + z_z * z + z_1) * over_w * factor
        out[0, i], out[1, i], out[2, i] = right, down, depth
        # No branch but a choice, so that the processor takes several points at a time.
        well &= ((w <= 0.0) & (w > -math.inf)) | (abs(right + down + depth) < math.inf)
    return well
