"""The camera: eye, target, up, its frame, and its place on an orbit; calibrated cameras.

The letters u, v, n and the look-at are those of lecture 004 (Horvat). K of a calibrated camera maps
x right, y down, z forward to pixels that are counted from the centre of the first one, as
`Intrinsics` describes.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from app.arithmetic import double_double as dd
from app.arithmetic.double_double import DoubleDouble
from app.model import limits
from app.model.lenses.answers import Intrinsics
from app.model.limits import Array, Vector
from app.model.refusal import REFUSALS, Refusal

Whole: TypeAlias = tuple[int, int, int]


def _whole(*vectors: Vector) -> list[Whole]:
    """Write float64 vectors exactly, as whole multiples of one common unit."""
    ratios = [[part.as_integer_ratio() for part in vector] for vector in vectors]
    unit = max(below for vector in ratios for _, below in vector)  # they are all powers of two
    return [
        tuple(above * (unit // below) for above, below in vector)  # type: ignore[misc]
        for vector in ratios
    ]


def _dot(a: Whole, b: Whole) -> int:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Whole, b: Whole) -> Whole:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _unit(exact: Whole) -> tuple[Fraction, ...]:
    """Normalise an exact vector; each component has `double_double.BITS` bits."""
    square = _dot(exact, exact)
    unit = []
    for part in exact:
        shift = dd.BITS + square.bit_length() // 2 - part.bit_length() + 1
        size = math.isqrt((part * part << 2 * shift) // square)
        unit.append(Fraction(size if part >= 0 else -size, 1 << shift))
    return tuple(unit)


class Orbit(NamedTuple):
    """The camera's position relative to its target."""

    azimuth_deg: float  # angle about the world's y axis; 0 puts the eye at +z, 90 at +x
    elevation_deg: float  # angle above the target's horizon, from -90 to 90
    distance: float
    roll_deg: float = 0.0  # turn about the view direction, clockwise as the photographer sees it


@dataclass(frozen=True)
class Camera:
    """The position and orientation of the camera.

    Raises a `Refusal` for a coordinate that is not finite or larger than `LARGEST`, for
    ``eye = target`` and ``up = 0``, and for up within `SMALLEST_UP_ANGLE` of the view direction.

    - `eye`, `target`, `up`: world coordinates of the centre of projection and of the point looked
      at, and the direction that is vertical in the picture (any length, not parallel to the view).
    """

    eye: Vector = (6.0, 5.0, 9.0)
    target: Vector = (0.0, 2.2, 0.0)
    up: Vector = (0.0, 1.0, 0.0)

    def __post_init__(self) -> None:
        for field in ("eye", "target", "up"):
            object.__setattr__(self, field, limits.finite_vector(field, getattr(self, field)))
        if self.eye == self.target:
            raise Refusal("target", self.target, REFUSALS["not-the-eye"])
        if self.up == (0.0, 0.0, 0.0):
            raise Refusal("up", self.up, REFUSALS["not-zero"])
        backward, right = self._exact_axes
        up = _whole(self.up)[0]
        sin_squared = Fraction(_dot(right, right), _dot(backward, backward) * _dot(up, up))
        if sin_squared < Fraction(limits.SMALLEST_UP_ANGLE) ** 2:
            raise Refusal("up", self.up, REFUSALS["not-parallel"])

    @cached_property
    def _exact_axes(self) -> tuple[Whole, Whole]:
        """``N = eye - target`` and ``U = up x N`` of lecture 004, without any rounding.

        With up 1e-12 rad from the view direction the cross product cancels 12 of float64's 16
        digits; whole numbers lose none.
        """
        eye, target = _whole(self.eye, self.target)
        backward = (eye[0] - target[0], eye[1] - target[1], eye[2] - target[2])
        return backward, _cross(_whole(self.up)[0], backward)

    @cached_property
    def frame(self) -> Array:
        """Rows u, v, n of the camera's right-handed orthonormal frame (lecture 004), (3, 3)."""
        return limits.read_only([list(map(float, axis)) for axis in self.exact_frame])

    @cached_property
    def exact_frame(self) -> tuple[tuple[Fraction, ...], ...]:
        """`frame` to `double_double.BITS` bits, rows u, v, n."""
        backward, right = self._exact_axes
        return tuple(map(_unit, (right, _cross(backward, right), backward)))

    @cached_property
    def frame_parts(self) -> tuple[Array, Array]:
        """`frame` as multiples of 2^-25, and the rest; (3, 3) each."""
        large = np.round(self.frame * 2.0**25) / 2.0**25
        small = [
            [float(exact - Fraction(part)) for exact, part in zip(*rows, strict=True)]
            for rows in zip(self.exact_frame, large.tolist(), strict=True)
        ]
        return limits.read_only(large), limits.read_only(small)

    @cached_property
    def frame_double_double(self) -> list[list[DoubleDouble]]:
        return [
            [DoubleDouble(*map(np.asarray, dd.from_exact(part))) for part in axis]
            for axis in self.exact_frame
        ]

    @property
    def exact_origin(self) -> tuple[Fraction, Fraction, Fraction]:
        """View coordinates of the world's origin to `double_double.BITS` bits, with exact zeros."""
        return self.exact_along([-Fraction(part) for part in self.eye])

    def exact_along(self, offset: Sequence[Any]) -> tuple[Any, Any, Any]:
        """The components of an offset or a direction along u, v and n, like `exact_origin`.

        They are in the exact numbers of the offset.
        """
        backward, right = self._exact_axes
        x, y, z = (
            sum((c * o for c, o in zip(axis, offset, strict=True)), Fraction(0)) / length
            for axis, length in zip(
                (right, _cross(backward, right), backward), self._exact_lengths, strict=True
            )
        )
        return x, y, z

    @cached_property
    def _exact_lengths(self) -> tuple[Fraction, Fraction, Fraction]:
        """Lengths of U, V = N x U and N, to `double_double.BITS` bits.

        A rational ratio of them is exact, so that a point on a plane of the view volume, where
        coordinates cancel, is found there.
        """
        backward, right = self._exact_axes
        n_squared, u_squared = _dot(backward, backward), _dot(right, right)
        n_length = dd.root(Fraction(n_squared))
        product = math.isqrt(n_squared * u_squared)
        if product * product == n_squared * u_squared:
            return n_length * Fraction(product, n_squared), Fraction(product), n_length
        u_length = dd.root(Fraction(u_squared))
        return u_length, u_length * n_length, n_length

    @cached_property
    def distance(self) -> float:
        """Distance from the eye to the target, in world units."""
        return math.dist(self.eye, self.target)

    @classmethod
    def from_orbit(cls, target: Vector, orbit: Orbit) -> "Camera":
        """Place the camera on an orbit about a target.

        Raises a `Refusal` for ``distance <= 0``, an elevation outside -90..90, numbers that are not
        finite, and a distance too small for float64 to tell the eye from the target.
        """
        target = limits.finite_vector("target", target)
        azimuth_deg, elevation_deg, distance, roll_deg = (
            limits.finite(field, value) for field, value in zip(Orbit._fields, orbit, strict=True)
        )
        limits.positive("distance", distance)
        limits.within("elevation_deg", elevation_deg, -90, 90)
        right, upward, backward = _orbit_axes(azimuth_deg, elevation_deg)
        offset = [distance * b for b in backward]
        eye = tuple(t + o for t, o in zip(target, offset, strict=True))
        if math.dist([e - t for e, t in zip(eye, target, strict=True)], offset) > 1e-6 * distance:
            raise Refusal("distance", distance, REFUSALS["distinct"], 0)
        if roll_deg == 0.0 and abs(elevation_deg) < 89.9999:
            up: tuple[float, ...] = (0.0, 1.0, 0.0)
        else:
            cos_roll, sin_roll = limits.cos_sin_deg(roll_deg)
            up = tuple(cos_roll * v + sin_roll * u for u, v in zip(right, upward, strict=True))
        return cls(eye, target, up)  # type: ignore[arg-type]

    @cached_property
    def orbit(self) -> Orbit:
        """The camera's azimuth, elevation, distance and roll about its target."""
        _, upward, backward = self.frame
        horizontal = math.hypot(backward[0], backward[2])
        elevation_deg = math.degrees(math.atan2(backward[1], horizontal))
        if horizontal > 1e-9:
            azimuth_deg = math.degrees(math.atan2(backward[0], backward[2]))
        else:  # straight above or below: only the picture's vertical gives the azimuth
            toward = -math.copysign(1.0, backward[1])
            azimuth_deg = math.degrees(math.atan2(toward * upward[0], toward * upward[2]))
        level_right, level_upward, _ = _orbit_axes(azimuth_deg, elevation_deg)
        roll_deg = math.degrees(
            math.atan2(float(np.dot(upward, level_right)), float(np.dot(upward, level_upward)))
        )
        if abs(roll_deg) < 1e-9:  # rounding errors of the frame of a level camera
            roll_deg = 0.0
        return Orbit(azimuth_deg, elevation_deg, self.distance, roll_deg)


def _orbit_axes(azimuth_deg: float, elevation_deg: float) -> tuple[Vector, Vector, Vector]:
    """u, v, n of a camera without roll at these angles."""
    cos_a, sin_a = limits.cos_sin_deg(azimuth_deg)
    cos_e, sin_e = limits.cos_sin_deg(elevation_deg)
    right = (cos_a, 0.0, -sin_a)
    upward = (-sin_e * sin_a, cos_e, -sin_e * cos_a)
    return right, upward, (cos_e * sin_a, sin_e, cos_e * cos_a)


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
        k = [[limits.finite(f"K[{i}, {j}]", given[i][j]) for j in range(3)] for i in range(3)]
        (fx, skew, cx), (below, fy, cy), (*last, scale) = k
        if cx == cy == 0.0 != scale and any(last):
            raise Refusal("K", k, REFUSALS["camera-transposed"])
        if below or any(last) or not scale:
            raise Refusal("K", k, REFUSALS["not-k"])
        if skew:
            raise Refusal("K[0, 1]", skew, REFUSALS["skewed"])
        given = [part / scale for part in (fx, fy, cx, cy)]
    elif shape != (4,):
        raise Refusal("intrinsics", given, REFUSALS["not-k"])
    parts = zip(Intrinsics._fields, given, strict=True)
    fx, fy, cx, cy = intrinsics = Intrinsics(*(limits.finite(name, value) for name, value in parts))
    width, height = image_size
    for name, value, bound in (("fx", fx, REFUSALS["x-left"]), ("fy", fy, REFUSALS["y-up"])):
        if value < 0.0:
            raise Refusal(name, value, bound, -value)
        limits.positive(name, value)
    in_first_pixel = 0.0 <= cx <= 1.0 and 0.0 <= cy <= 1.0
    if in_first_pixel and max(fx, fy) <= _MOST_NORMALISED and min(image_size) >= _FEW_PX:
        raise Refusal("fx", fx, REFUSALS["normalised"], width, height)
    for name, value, side, centre in (("fx", fx, width, cx), ("fy", fy, height, cy)):
        least = (abs(centre) + side + 1.0) * limits.SMALLEST_FIELD
        limits.within(name, value, least, side / (2.0 * limits.SMALLEST_OPENING))
    return intrinsics


# --------------------------------------------------------------------------- poses


def rotation_from_vector(vector: Sequence[float]) -> Array:
    """Return the rotation about a vector by its length in radians, (3, 3): OpenCV's Rodrigues."""
    angle = math.hypot(*(limits.finite("rvec", part) for part in vector))
    half = math.sin(angle / 2.0) / angle if angle > 0.0 else 0.5
    return rotation_from_quaternion([math.cos(angle / 2.0), *(half * part for part in vector)])


def rotation_from_quaternion(wxyz: Sequence[float]) -> Array:
    """Return the rotation of a quaternion of any length but 0, Hamilton's convention, (3, 3)."""
    length = math.hypot(*(limits.finite("quaternion", part) for part in wxyz))
    if length == 0.0:
        raise Refusal("quaternion", tuple(wxyz), REFUSALS["not-zero"])
    w, x, y, z = (part / length for part in wxyz)
    return np.array(
        [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ]
    )


@np.errstate(over="ignore", invalid="ignore")
def world_from_opencv(rotation: Array, translation: Array) -> Array:
    """Return the columns right, up, backward and eye of a pose ``x_camera = R x + t``, (3, 4).

    The camera's axes are OpenCV's and COLMAP's: x right, y down, z forward.
    """
    return np.column_stack([rotation.T * (1.0, -1.0, -1.0), -rotation.T @ translation])


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
        raise Refusal("P", cells.tolist(), REFUSALS["at-infinity"])
    q, upper = np.linalg.qr(m[::-1].T)
    signs = np.sign(np.diag(upper))[::-1]
    k, rotation = upper.T[::-1, ::-1] * signs, signs[:, None] * q.T[::-1]
    sign = float(np.sign(np.linalg.det(rotation)))
    scale = sign * float(k[2, 2])
    k = k / k[2, 2]
    translation = limits.read_only(np.linalg.solve(k, cells[:, 3] / size / scale))
    return TakenApart(scale * size, k, sign * rotation, translation)
