"""Matrices whose numbers were rounded: to float32, or to the digits that a program prints."""

import math
from collections.abc import Iterable
from decimal import Decimal
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from app.model.limits import Array
from app.model.projection import Camera, Projection

_NOISE = 2.0**-20  # error of a computation in float32, 16 roundings: a look-at makes up to 11
_FROM_MEANT = 1.75
"""Most distance of a rounded rotation from the nearest one, in units: it was 1.6 in 40 000."""


class Rounding(NamedTuple):
    """How numbers were rounded: their significant digits, and their decimals."""

    digits: int
    decimals: int

    @property
    def is_float32(self) -> bool:
        return 7 <= self.digits <= 9

    @property
    def of_rotation(self) -> float:
        """Most rounding of a rotation's cell, whose largest are between 0.5 and 1."""
        places = self.digits if self.digits >= 4 else self.decimals
        return 10.0**-places / 2.0 + (_NOISE if self.is_float32 else 0.0)

    def of(self, number: float) -> float:
        """Most rounding of a number, if programs printed digits or decimals."""
        size = abs(number)
        if not size:
            return 10.0**-self.decimals / 2.0
        printed = 10.0 ** (math.floor(math.log10(size)) - self.digits + 1) / 2.0
        noise = _NOISE * size if self.is_float32 else 0.0
        return max(printed, 10.0**-self.decimals / 2.0) + noise


def rounding_of(numbers: Iterable[float]) -> Rounding | None:
    """Return how numbers were rounded, or None if they have one or two digits or all of float64."""
    nonzero = [number for number in numbers if number]
    parts = [Decimal(repr(number)).normalize().as_tuple() for number in nonzero]
    digits = max((len(part.digits) for part in parts), default=0)
    decimals = max((-int(part.exponent) for part in parts), default=0)
    if digits > 9:
        with np.errstate(over="ignore"):
            if any(float(np.float32(number)) != number for number in nonzero):
                return Rounding(digits, decimals) if digits < 15 else None
        digits = 9
    elif digits < 3 and not (digits > 1 and decimals >= 4):  # as in 1.0000 0.0012
        return None
    return Rounding(digits, decimals)


class NearRotation(NamedTuple):
    """The rotation nearest to rounded rows, by the polar decomposition."""

    rows: Array
    rounding: Rounding
    apart: float  # largest deviation of the given rows from length 1 and right angles


def nearest_rotation(rows: Array) -> NearRotation | None:
    """Return the rotation or reflection of which these rows, (3, 3), are a rounding, or None."""
    rounding = rounding_of(rows.ravel().tolist())
    if rounding is None:
        return None
    left, _, right = np.linalg.svd(rows)
    nearest = left @ right
    if np.abs(rows - nearest).max() > _FROM_MEANT * rounding.of_rotation:
        return None
    return NearRotation(nearest, rounding, float(np.abs(rows @ rows.T - np.eye(3)).max()))


def moved_px(view_from_world: Array, camera: Camera, projection: Projection) -> float:
    """Return a bound on how far the camera moves the picture of a typed view matrix, in pixels.

    It holds for all points in the view volume; infinite if the lens has none, or no bound exists.

    With ``A`` and ``t`` of the typed matrix and ``R`` and ``e`` of the camera, a point moves by
    ``(A - R)(p - e) + (A e + t)`` in view space. In units of its distance from the eye that is at
    most ``eta = |A - R| + |A e + t|/near``. A unit vector with the angle c to the axis that moves
    by eta moves in the picture at distance 1 by at most ``eta/(cos c (cos c - eta))``.
    """
    lens, aspect = projection.lens, Fraction(*projection.image_size)
    if lens.planes is None:
        return math.inf
    frame = np.array([[float(part) for part in axis] for axis in camera.exact_frame])
    linear, shift = view_from_world[:3, :3], view_from_world[:3, 3]
    turned = float(np.linalg.norm(linear - frame))
    moved = float(np.linalg.norm(linear @ np.array(camera.eye) + shift))
    near, far = lens.planes
    sides = np.array(lens.slopes(aspect) if lens.central else projection.window)
    px = float(max(np.array(projection.image_size) / (sides[1::2] - sides[::2])))
    across = np.abs(sides.reshape(2, 2)).max(axis=1)
    if lens.central:
        away = turned + moved / near
        cos = 1.0 / math.hypot(*across, 1.0)
        return px * away / (cos * (cos - away)) if away < cos else math.inf
    reach = math.hypot(*(across + np.abs(lens.shear) * (far - near)), max(abs(near), abs(far)))
    return px * (turned * reach + moved) * math.hypot(1.0, *lens.shear)
