"""The shared projection model: camera, lens, image, and every matrix between them.

Conventions, stated once for the whole program:

=================  ==========================================================================
vectors, matrices  column vectors, ``p_out = M @ p_in``; batches are rows ``(..., 3)``; float64
names              ``target_from_source``; points carry their space (``points_world``)
world, view        right-handed, y up; the camera looks along -z of view space
camera frame       ``n = (eye - target)/|.|``, ``u = up x n / |.|``, ``v = n x u``
clip, NDC          OpenGL cube ``[-1, 1]^3``, near -> -1, far -> +1 (``opengl``);
                   ``direct3d`` maps near..far to ``[0, 1]``, ``reversed`` to ``[1, 0]``
image              origin top-left, x right, y down, pixels; the first pixel's centre is at 0.5
angles, lengths    degrees at every boundary (``_deg``), world units
=================  ==========================================================================

Points are projected *eye first*: the eye is subtracted before anything else, then the rotation,
then the closed form of the lens. A concatenated matrix loses the digits that the eye and the
point have in common (5e-5 px at 1e9 from the origin, against 3e-13 px here); it is still made,
because it is what a GPU is given and what the lectures write.

The letters u, v, n, the look-at and the view matrix are those of lecture 004 (Horvat); the
perspective matrix is equation (13) of lecture 000.
"""

from __future__ import annotations

import math
import numbers
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any, ClassVar, Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

Vector: TypeAlias = tuple[float, float, float]
Array: TypeAlias = NDArray[np.float64]
DepthRange: TypeAlias = Literal["opengl", "direct3d", "reversed"]
Keep: TypeAlias = Literal["stretch", "x", "y"]

DEPTH_RANGES: dict[str, tuple[float, float]] = {
    "opengl": (-1.0, 1.0),
    "direct3d": (0.0, 1.0),
    "reversed": (1.0, 0.0),
}
"""NDC z of the near and of the far plane."""

PLANES = ("near", "far", "left", "right", "bottom", "top")
"""The six planes of the view volume, in the order of `Trace.outside`."""

LARGEST = 1e100
"""Largest coordinate or distance; with `SMALLEST`, no matrix overflows float64 (2e205 * 1e100)."""
SMALLEST = 1e-205
"""Smallest near distance, and smallest extent of a window or a depth range."""
LARGEST_IMAGE_PX = 16384
"""Largest image side, the texture limit that every current OpenGL driver offers."""
SMALLEST_UP_ANGLE = 1e-15
"""Least angle in radians between up and the view direction.

Coordinates typed in decimal are off by up to half an ulp, so that nearer to parallel than this
the frame would be made of their rounding errors.
"""

_SHOWN = 100
_FULL_FRAME_DIAGONAL_MM = math.hypot(36.0, 24.0)
_CHUNK = 16384  # larger blocks wake OpenBLAS's second thread, which fights a software renderer


class ProjectionError(ValueError):
    """A value that no projection can have.

    Parameters
    ----------
    field : str
        Name of the refused parameter, as in the document (``"near"``, ``"up"``).
    value : object
        The value that was refused.
    bound : str
        What the value must be, with ``{0}``, ``{1}`` for the limits, so that it can be
        translated before they are filled in. One of `BOUNDS`.
    *limits : object
        The limits themselves.
    """

    def __init__(self, field: str, value: object, bound: str, *limits: object) -> None:
        self.field, self.value, self.bound, self.limits = field, value, bound, limits
        super().__init__(f"{field} = {format_value(value)}: {bound.format(*limits)}.")


FINITE_NUMBER = "must be a finite number"
ABOVE = "must be greater than {0}"
AT_LEAST = "must be at least {0}"
AT_MOST = "must be at most {0}"
BETWEEN = "must lie between {0} and {1}, both excluded"
NEAR_BEFORE_FAR = "must be less than far, which is {0}"
LEFT_BEFORE_RIGHT = "must be less than right, which is {0}"
BOTTOM_BEFORE_TOP = "must be less than top, which is {0}"
THREE_NUMBERS = "must be three finite numbers x, y, z"
NOT_THE_EYE = "must differ from the eye, or the camera looks nowhere"
NOT_ZERO = "must not be the zero vector"
NOT_PARALLEL = "must not be parallel to the view direction"
WHOLE_PIXELS = "must be a whole number of pixels from 1 to {0}"
ONE_OF = "must be one of {0}"
DISTINCT = "is too close to {0} for float64 to tell apart"
BOUNDS = (
    FINITE_NUMBER, ABOVE, AT_LEAST, AT_MOST, BETWEEN, NEAR_BEFORE_FAR, LEFT_BEFORE_RIGHT,
    BOTTOM_BEFORE_TOP, THREE_NUMBERS, NOT_THE_EYE, NOT_ZERO, NOT_PARALLEL, WHOLE_PIXELS, ONE_OF,
    DISTINCT,
)  # fmt: skip
"""Every sentence a `ProjectionError` can end with, for translators."""


def format_value(value: object) -> str:
    """Write a value as a person would type it: ``1``, ``0.1``, ``inf``, ``(0, 1, 0)``."""
    if isinstance(value, (tuple, list)):
        return _cut("(" + ", ".join(format_value(part) for part in value[:_SHOWN]) + ")")
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        return _cut(" ".join(repr(value).split()))
    try:
        number = float(value)
    except OverflowError:
        whole: Any = value
        return f"{'-' if whole < 0 else ''}1e{int(math.log10(abs(whole)))}"
    return str(int(number)) if number.is_integer() and abs(number) < 1e15 else repr(number)


def _cut(text: str) -> str:
    """As much of a text as a sentence can hold."""
    return text if len(text) <= _SHOWN else text[: _SHOWN - 3] + "..."


# --------------------------------------------------------------------------- checks, exact vectors

_FACE = ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))


def _set(frozen: object, **values: object) -> None:
    """Store checked values in a frozen dataclass while it is being made."""
    for name, value in values.items():
        object.__setattr__(frozen, name, value)


def _real(field: str, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise ProjectionError(field, value, FINITE_NUMBER)
    try:
        return float(value)
    except OverflowError:  # an int of more than 308 digits
        large: Any = value
        bound, limit = (AT_MOST, LARGEST) if large > 0 else (AT_LEAST, -LARGEST)
        raise ProjectionError(field, value, bound, limit) from None


def _finite(field: str, value: Any) -> float:
    number = _real(field, value)
    if not math.isfinite(number):
        raise ProjectionError(field, number, FINITE_NUMBER)
    if abs(number) > LARGEST:
        bound, limit = (AT_MOST, LARGEST) if number > 0 else (AT_LEAST, -LARGEST)
        raise ProjectionError(field, number, bound, limit)
    return number


def _vector(field: str, value: Any) -> Vector:
    try:
        parts = tuple(value)
        if isinstance(value, (str, bytes)) or len(parts) != 3:
            raise TypeError
    except TypeError:
        raise ProjectionError(field, value, THREE_NUMBERS) from None
    for part in parts:
        if isinstance(part, bool) or not isinstance(part, numbers.Real):
            raise ProjectionError(field, value, THREE_NUMBERS)
        if not math.isfinite(_real(field, part)):
            raise ProjectionError(field, parts, THREE_NUMBERS)
    x, y, z = (_finite(field, part) for part in parts)
    return x, y, z


def _exact(vector: Vector) -> tuple[Fraction, ...]:
    return tuple(map(Fraction, vector))


def _dot(a: tuple[Fraction, ...], b: tuple[Fraction, ...]) -> Fraction:
    return sum((p * q for p, q in zip(a, b, strict=True)), Fraction(0))


def _cross(a: tuple[Fraction, ...], b: tuple[Fraction, ...]) -> tuple[Fraction, ...]:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def _unit(exact: tuple[Fraction, ...]) -> Vector:
    """The direction of an exact vector, each component within 2 ulp whatever its length."""
    largest = max(map(abs, exact))
    x, y, z = (float(part / largest) for part in exact)
    length = math.hypot(x, y, z)
    return x / length, y / length, z / length


def _cos_sin_deg(angle_deg: float) -> tuple[float, float]:
    """Cosine and sine of an angle in degrees, exact at the multiples of 90."""
    angle_deg = math.remainder(angle_deg, 360.0)  # exact, and the quarter below too, then
    quarter = round(angle_deg / 90.0)
    rest = math.radians(math.remainder(angle_deg, 90.0))
    cos, sin = math.cos(rest), math.sin(rest)
    return ((cos, sin), (-sin, cos), (-cos, -sin), (sin, -cos))[quarter % 4]


def _translation(offset: ArrayLike) -> Array:
    matrix = np.eye(4)
    matrix[:3, 3] = offset
    return _read_only(matrix)


def _read_only(values: ArrayLike) -> Array:
    array = np.array(values, dtype=np.float64)
    array.setflags(write=False)
    return array


# --------------------------------------------------------------------------- camera


class Orbit(NamedTuple):
    """The camera's place as seen from its target.

    Attributes
    ----------
    azimuth_deg : float
        Angle round the world's y axis; 0 puts the eye on the +z side, 90 on the +x side.
    elevation_deg : float
        Angle above the target's horizon, from -90 to 90.
    distance : float
        From target to eye, in world units.
    roll_deg : float
        Turn about the view direction, clockwise as the photographer sees the camera.
    """

    azimuth_deg: float
    elevation_deg: float
    distance: float
    roll_deg: float = 0.0


@dataclass(frozen=True)
class Camera:
    """Where the camera stands and what it looks at.

    Parameters
    ----------
    eye, target, up : sequence of 3 floats
        World coordinates of the centre of projection and of the point looked at, and the
        direction that shall be vertical in the picture (any length, not parallel to the view).

    Raises
    ------
    ProjectionError
        For a coordinate that is not finite or larger than `LARGEST`, ``eye = target``,
        ``up = 0``, or up within `SMALLEST_UP_ANGLE` of the view direction.
    """

    eye: Vector = (6.0, 5.0, 9.0)
    target: Vector = (0.0, 2.2, 0.0)
    up: Vector = (0.0, 1.0, 0.0)

    def __post_init__(self) -> None:
        for field in ("eye", "target", "up"):
            object.__setattr__(self, field, _vector(field, getattr(self, field)))
        if self.eye == self.target:
            raise ProjectionError("target", self.target, NOT_THE_EYE)
        if self.up == (0.0, 0.0, 0.0):
            raise ProjectionError("up", self.up, NOT_ZERO)
        backward, right = self._exact_axes
        sin_squared = _dot(right, right) / (
            _dot(backward, backward) * _dot(_exact(self.up), _exact(self.up))
        )
        if sin_squared < Fraction(SMALLEST_UP_ANGLE) ** 2:
            raise ProjectionError("up", self.up, NOT_PARALLEL)

    @cached_property
    def _exact_axes(self) -> tuple[tuple[Fraction, ...], tuple[Fraction, ...]]:
        """``N = eye - target`` and ``U = up x N`` of lecture 004, without any rounding.

        With up 1e-12 rad from the view direction the cross product cancels 12 of float64's 16
        digits; in rationals it cancels none, and rounding once at the end is all that is lost.
        """
        backward = tuple(
            e - t for e, t in zip(_exact(self.eye), _exact(self.target), strict=True)
        )
        return backward, _cross(_exact(self.up), backward)

    @cached_property
    def frame(self) -> Array:
        """Rows u, v, n of the camera's right-handed orthonormal frame (lecture 004), (3, 3)."""
        backward, right = self._exact_axes
        upward = _cross(backward, right)
        return _read_only([_unit(right), _unit(upward), _unit(backward)])

    @property
    def distance(self) -> float:
        """Distance from the eye to the target, in world units."""
        return math.dist(self.eye, self.target)

    @classmethod
    def from_orbit(cls, target: Vector, orbit: Orbit) -> Camera:
        """Place the camera about a target.

        Parameters
        ----------
        target : Vector
            World coordinates of the point looked at.
        orbit : Orbit
            Angles in degrees and distance in world units.

        Raises
        ------
        ProjectionError
            For ``distance <= 0``, an elevation outside -90..90 or numbers that are not finite.
        """
        target = _vector("target", target)
        azimuth_deg, elevation_deg, distance, roll_deg = (
            _finite(field, value) for field, value in zip(Orbit._fields, orbit, strict=True)
        )
        if distance <= 0.0:
            raise ProjectionError("distance", distance, ABOVE, 0)
        if abs(elevation_deg) > 90.0:
            bound, limit = (AT_MOST, 90) if elevation_deg > 0 else (AT_LEAST, -90)
            raise ProjectionError("elevation_deg", elevation_deg, bound, limit)
        right, upward, backward = _orbit_axes(azimuth_deg, elevation_deg)
        eye = tuple(t + distance * b for t, b in zip(target, backward, strict=True))
        if eye == target:
            raise ProjectionError("distance", distance, DISTINCT, 0)
        if roll_deg == 0.0 and abs(elevation_deg) < 89.9999:
            up: tuple[float, ...] = (0.0, 1.0, 0.0)
        else:
            cos_roll, sin_roll = _cos_sin_deg(roll_deg)
            up = tuple(cos_roll * v + sin_roll * u for u, v in zip(right, upward, strict=True))
        return cls(eye, target, up)  # type: ignore[arg-type]

    @cached_property
    def orbit(self) -> Orbit:
        """The same camera as azimuth, elevation, distance and roll about its target."""
        _, upward, backward = self.frame
        horizontal = math.hypot(backward[0], backward[2])
        elevation_deg = math.degrees(math.atan2(backward[1], horizontal))
        if horizontal > 1e-9:
            azimuth_deg = math.degrees(math.atan2(backward[0], backward[2]))
        else:  # straight above or below: the picture's vertical is all that tells the azimuth
            toward = -math.copysign(1.0, backward[1])
            azimuth_deg = math.degrees(math.atan2(toward * upward[0], toward * upward[2]))
        level_right, level_upward, _ = _orbit_axes(azimuth_deg, elevation_deg)
        roll_deg = math.degrees(
            math.atan2(float(np.dot(upward, level_right)), float(np.dot(upward, level_upward)))
        )
        if abs(roll_deg) < 1e-9:  # what the frame's rounding leaves of a level camera
            roll_deg = 0.0
        return Orbit(azimuth_deg, elevation_deg, self.distance, roll_deg)


def _orbit_axes(azimuth_deg: float, elevation_deg: float) -> tuple[Vector, Vector, Vector]:
    """u, v, n of a camera without roll at these angles."""
    cos_a, sin_a = _cos_sin_deg(azimuth_deg)
    cos_e, sin_e = _cos_sin_deg(elevation_deg)
    right = (cos_a, 0.0, -sin_a)
    upward = (-sin_e * sin_a, cos_e, -sin_e * cos_a)
    return right, upward, (cos_e * sin_a, sin_e, cos_e * cos_a)


# --------------------------------------------------------------------------- lenses


@dataclass(frozen=True)
class Perspective:
    """The symmetric perspective lens (gluPerspective); the aspect is the image's.

    Parameters
    ----------
    fov_y_deg : float
        Vertical field of view in degrees, anywhere in the open interval (0, 180).
    near, far : float
        Distances of the clipping planes from the eye, ``0 < near < far``; far may be ``inf``.
    """

    kind: ClassVar[str] = "perspective"

    fov_y_deg: float = 45.0
    near: float = 1.0
    far: float = 30.0

    def __post_init__(self) -> None:
        fov_y_deg = _finite("fov_y_deg", self.fov_y_deg)
        if not 0.0 < fov_y_deg < 180.0:
            raise ProjectionError("fov_y_deg", fov_y_deg, BETWEEN, 0, 180)
        if fov_y_deg < 1e-100:  # its half-angle's cotangent must leave room for the aspect
            raise ProjectionError("fov_y_deg", fov_y_deg, AT_LEAST, 1e-100)
        near = _finite("near", self.near)
        if near <= 0.0:
            raise ProjectionError("near", near, ABOVE, 0)
        if near < SMALLEST:
            raise ProjectionError("near", near, AT_LEAST, SMALLEST)
        far = _real("far", self.far)
        if far != math.inf:
            far = _finite("far", far)
        if near >= far:
            raise ProjectionError("near", near, NEAR_BEFORE_FAR, format_value(far))
        _set(self, fov_y_deg=fov_y_deg, near=near, far=far)

    @property
    def cot_half_fov_y(self) -> float:
        """``cot(fov_y/2)``, the picture's half-height in units of its distance, inverted.

        Above 90 degrees it is taken as the tangent of the complement: ``180 - fov`` is exact
        there, and the result stays within 2 ulp up to 180.
        """
        if self.fov_y_deg > 90.0:
            return math.tan(math.radians(180.0 - self.fov_y_deg) / 2.0)
        return 1.0 / math.tan(math.radians(self.fov_y_deg) / 2.0)

    def window(self, aspect: float) -> tuple[float, float, float, float]:
        """Left, right, bottom, top of the picture on the near plane, in world units."""
        top = self.near / self.cot_half_fov_y
        return -aspect * top, aspect * top, -top, top


@dataclass(frozen=True)
class Orthographic:
    """The orthographic lens (glOrtho).

    Parameters
    ----------
    left, right, bottom, top : float
        The picture's window in view space, ``left < right``, ``bottom < top``.
    near, far : float
        Distances of the clipping planes from the eye plane, ``near < far``; near may be
        negative (behind the eye), far must be finite.
    keep : {"stretch", "x", "y"}
        How the window follows the image's aspect: not at all, or by adjusting the y range
        (``"x"`` is kept, lecture 000's variant X) or the x range (``"y"``, variant Y).
    """

    kind: ClassVar[str] = "orthographic"

    left: float = -4.0
    right: float = 4.0
    bottom: float = -4.0
    top: float = 4.0
    near: float = 1.0
    far: float = 30.0
    keep: Keep = "stretch"

    def __post_init__(self) -> None:
        names = ("left", "right", "bottom", "top", "near", "far")
        left, right, bottom, top, near, far = (_finite(n, getattr(self, n)) for n in names)
        for name, low, high, bound in (
            ("left", left, right, LEFT_BEFORE_RIGHT),
            ("bottom", bottom, top, BOTTOM_BEFORE_TOP),
            ("near", near, far, NEAR_BEFORE_FAR),
        ):
            if low >= high:
                raise ProjectionError(name, low, bound, format_value(high))
            if high - low < SMALLEST:
                raise ProjectionError(name, low, DISTINCT, format_value(high))
        if self.keep not in ("stretch", "x", "y"):
            raise ProjectionError("keep", self.keep, ONE_OF, "stretch, x, y")
        _set(self, left=left, right=right, bottom=bottom, top=top, near=near, far=far)

    def window(self, aspect: float) -> tuple[float, float, float, float]:
        """Left, right, bottom, top of the picture after `keep`, in world units.

        Lecture 000, PerspektivnaProjekcijaX and Y, with the slip in Y's last line corrected.
        """
        left, right, bottom, top = self.left, self.right, self.bottom, self.top
        if self.keep == "x":
            k = ((right - left) / aspect - (top - bottom)) / 2.0
            bottom, top = bottom - k, top + k
        elif self.keep == "y":
            k = (aspect * (top - bottom) - (right - left)) / 2.0
            left, right = left - k, right + k
        return left, right, bottom, top


Lens: TypeAlias = Perspective | Orthographic
LENSES: dict[str, type[Perspective | Orthographic]] = {
    lens.kind: lens for lens in (Perspective, Orthographic)
}


# --------------------------------------------------------------------------- projection


class Stage(NamedTuple):
    """One step of the pipeline: its name, its matrix, and the factors the matrix is made of."""

    name: str
    matrix: Array
    factors: tuple[tuple[str, Array], ...]


class Trace(NamedTuple):
    """Points followed through every stage; ``...`` is the shape of the points without the 3.

    Attributes
    ----------
    world, view : (..., 3) float64
    clip : (..., 4) float64
        Homogeneous, before the divide; w is the distance from the eye plane (1 for a parallel
        lens).
    ndc : (..., 3) float64
        After the divide; NaN where w <= 0: a point behind the eye has no picture.
    image : (..., 2) float64
        Pixels, origin top-left; NaN where w <= 0.
    depth : (...) float64
        What a depth buffer in [0, 1] would hold before quantising; NaN where w <= 0.
    in_front : (...) bool
        Where w > 0.
    outside : (..., 6) bool
        Which of `PLANES` the point lies beyond.
    """

    world: Array
    view: Array
    clip: Array
    ndc: Array
    image: Array
    depth: Array
    in_front: NDArray[np.bool_]
    outside: NDArray[np.bool_]


@dataclass(frozen=True)
class Projection:
    """A camera, a lens, an image and a depth range: everything a picture depends on.

    A value that exists is a value that works; edits are made with `dataclasses.replace`.

    Parameters
    ----------
    camera : Camera
    lens : Perspective or Orthographic
    image_size : (int, int)
        Width and height in pixels.
    depth : {"opengl", "direct3d", "reversed"}
        The NDC range of z.

    Raises
    ------
    ProjectionError
        For an image side outside 1..`LARGEST_IMAGE_PX` or an unknown depth range.
    """

    camera: Camera = Camera()
    lens: Lens = Perspective()
    image_size: tuple[int, int] = (1280, 720)
    depth: DepthRange = "opengl"

    def __post_init__(self) -> None:
        try:
            size = tuple(self.image_size)
            if len(size) != 2:
                raise TypeError
        except TypeError:
            raise ProjectionError(
                "image", self.image_size, WHOLE_PIXELS, LARGEST_IMAGE_PX
            ) from None
        for name, side in zip(("width", "height"), size, strict=True):
            whole = isinstance(side, numbers.Integral) and not isinstance(side, bool)
            if not whole or not 1 <= side <= LARGEST_IMAGE_PX:
                raise ProjectionError(name, side, WHOLE_PIXELS, LARGEST_IMAGE_PX)
        if not isinstance(self.depth, str) or self.depth not in DEPTH_RANGES:
            raise ProjectionError("depth", self.depth, ONE_OF, ", ".join(DEPTH_RANGES))
        _set(self, image_size=(int(size[0]), int(size[1])))
        if isinstance(self.lens, Orthographic):
            left, right, bottom, top = self.window
            for name, low, high in (("left", left, right), ("bottom", bottom, top)):
                if high - low < SMALLEST:  # `keep` shrank it to nothing, far from the axis
                    raise ProjectionError(name, low, DISTINCT, format_value(high))

    # -- plain figures

    @property
    def aspect(self) -> float:
        """The image's width over its height."""
        return self.image_size[0] / self.image_size[1]

    @property
    def depth_range(self) -> tuple[float, float]:
        """NDC z of the near and of the far plane."""
        return DEPTH_RANGES[self.depth]

    @property
    def window(self) -> tuple[float, float, float, float]:
        """Left, right, bottom, top of the picture on the near plane, in world units."""
        return self.lens.window(self.aspect)

    # -- matrices

    @cached_property
    def view_rotation(self) -> Array:
        """Factor R of the view matrix: rows u, v, n (lecture 004), (4, 4)."""
        matrix = np.eye(4)
        matrix[:3, :3] = self.camera.frame
        return _read_only(matrix)

    @cached_property
    def view_translation(self) -> Array:
        """Factor P of the view matrix: the eye moves to the origin (lecture 004), (4, 4)."""
        return _translation(-np.array(self.camera.eye))

    @cached_property
    def view_from_world(self) -> Array:
        """The view matrix R P of lecture 004, (4, 4)."""
        return _read_only(self.view_rotation @ self.view_translation)

    @cached_property
    def clip_from_view(self) -> Array:
        """The lens' matrix, (4, 4): lecture 000 (13) or glOrtho, for the chosen depth range."""
        left, right, bottom, top = self.window
        near, far = self.lens.near, self.lens.far
        a, b = self._depth_row
        matrix = np.zeros((4, 4))
        if isinstance(self.lens, Perspective):
            matrix[1, 1] = self.lens.cot_half_fov_y
            matrix[0, 0] = matrix[1, 1] / self.aspect
            matrix[2, 2:] = a, b
            matrix[3, 2] = -1.0
        else:
            matrix[0, 0], matrix[0, 3] = 2.0 / (right - left), -(right + left) / (right - left)
            matrix[1, 1], matrix[1, 3] = 2.0 / (top - bottom), -(top + bottom) / (top - bottom)
            z_near, z_far = self.depth_range
            matrix[2, 2] = (z_near - z_far) / (far - near)
            matrix[2, 3] = (z_near * far - z_far * near) / (far - near)
            matrix[3, 3] = 1.0
        return _read_only(matrix)

    @property
    def _depth_row(self) -> tuple[float, float]:
        """A and B of ``z_clip = A z_view + B`` for a perspective lens (lecture 000, before (12)).

        Both planes' conditions give ``A = -(z_far f - z_near n)/(f - n)`` and
        ``B = (z_near - z_far) n f/(f - n)``; with far = inf they have the limits below.
        """
        near, far = self.lens.near, self.lens.far
        z_near, z_far = self.depth_range
        if far == math.inf:
            return -z_far, (z_near - z_far) * near
        a = -(z_far * far - z_near * near) / (far - near)
        return a, (z_near - z_far) * near * (far / (far - near))

    @cached_property
    def view_from_clip(self) -> Array:
        """The inverse of `clip_from_view` in closed form, (4, 4); also for far = inf."""
        left, right, bottom, top = self.window
        near, far = self.lens.near, self.lens.far
        z_near, z_far = self.depth_range
        matrix = np.zeros((4, 4))
        if isinstance(self.lens, Perspective):
            matrix[0, 0] = self.aspect / self.lens.cot_half_fov_y
            matrix[1, 1] = 1.0 / self.lens.cot_half_fov_y
            matrix[2, 3] = -1.0
            # 1/w is affine in z_ndc: 1/near on the near face, 1/far on the far one.
            step = (1.0 if far == math.inf else (far - near) / far) / near
            matrix[3, 2] = step / (z_near - z_far)
            if z_far == 0.0:
                matrix[3, 3] = 1.0 / far
            else:
                matrix[3, 3] = (z_near / far - z_far / near) / (z_near - z_far)
        else:
            matrix[0, 0], matrix[0, 3] = (right - left) / 2.0, (right + left) / 2.0
            matrix[1, 1], matrix[1, 3] = (top - bottom) / 2.0, (top + bottom) / 2.0
            matrix[2, 2] = (far - near) / (z_near - z_far)
            matrix[2, 3] = -(z_near * far - z_far * near) / (z_near - z_far)
            matrix[3, 3] = 1.0
        return _read_only(matrix)

    @cached_property
    def clip_from_world(self) -> Array:
        """`clip_from_view` times `view_from_world`, (4, 4)."""
        return _read_only(self.clip_from_view @ self.view_from_world)

    @cached_property
    def world_from_clip(self) -> Array:
        """The inverse of `clip_from_world`, (4, 4): it un-projects the NDC cube to the frustum."""
        return self.world_from_clip_at((0.0, 0.0, 0.0))

    def clip_from_world_at(self, origin: ArrayLike) -> Array:
        """`clip_from_world` for points given relative to `origin`.

        Parameters
        ----------
        origin : (3,) array_like
            World point that the given points are measured from. It meets the eye in float64
            before anything is multiplied, so that a scene at 1e9 loses no digit.

        Returns
        -------
        (4, 4) float64 array
        """
        shift = _translation(np.asarray(origin, dtype=np.float64) - self.camera.eye)
        return _read_only(self.clip_from_view @ self.view_rotation @ shift)

    def world_from_clip_at(self, origin: ArrayLike) -> Array:
        """The inverse of `clip_from_world_at`, (4, 4)."""
        shift = _translation(self.camera.eye - np.asarray(origin, dtype=np.float64))
        return _read_only(shift @ self.view_rotation.T @ self.view_from_clip)

    @cached_property
    def image_from_ndc(self) -> Array:
        """The viewport matrix (lecture 002), (4, 4): x, y to pixels, z to depth in [0, 1]."""
        width, height = self.image_size
        z_low = min(self.depth_range)
        matrix = np.diag([width / 2.0, -height / 2.0, 1.0 / (1.0 - z_low), 1.0])
        matrix[:3, 3] = width / 2.0, height / 2.0, -z_low / (1.0 - z_low)
        return _read_only(matrix)

    @property
    def stages(self) -> tuple[Stage, ...]:
        """The pipeline's matrices in order; between clip and NDC comes the divide by w."""
        return (
            Stage(
                "view_from_world",
                self.view_from_world,
                (("rotation", self.view_rotation), ("translation", self.view_translation)),
            ),
            Stage("clip_from_view", self.clip_from_view, ()),
            Stage("image_from_ndc", self.image_from_ndc, ()),
        )

    @cached_property
    def frustum_corners_world(self) -> Array:
        """The cube's eight corners un-projected, homogeneous, (8, 4).

        Left-bottom, right-bottom, right-top, left-top of the near face, then of the far face;
        w is 1, or 0 for the far corners of an infinite frustum, which are directions
        (lecture 002: points at infinity).
        """
        # Through the reversed range: there 1/w of the far face is 1/far itself, where [-1, 1]
        # makes it a difference of two numbers of the size of 1/near.
        cube = [(x, y, z, 1.0) for z in (1.0, 0.0) for x, y in _FACE]
        corners = np.array(cube) @ replace(self, depth="reversed").view_from_clip.T
        finite = corners[:, 3] != 0.0
        corners[finite] /= corners[finite, 3:]
        directions = corners[:, :3] @ self.camera.frame
        directions[finite] += self.camera.eye
        return _read_only(np.column_stack([directions, corners[:, 3]]))

    # -- points

    def trace(self, points_world: ArrayLike) -> Trace:
        """Follow points through every stage, eye first and in closed form.

        Parameters
        ----------
        points_world : (..., 3) array_like
            World coordinates.

        Returns
        -------
        Trace

        Raises
        ------
        ProjectionError
            If a coordinate is not a finite number.

        Notes
        -----
        Depth is ``f/(f - n) * ((w - n)/w)``, not ``A + B/w``: the difference ``w - n`` keeps
        1.3e-16 where the sum of two large numbers keeps 6e-5 (near close to far).
        """
        try:
            given = np.asarray(points_world)
        except ValueError:  # rows of different lengths
            raise ProjectionError("points", points_world, THREE_NUMBERS) from None
        if given.dtype.kind not in "iuf" or given.shape[-1:] != (3,):
            raise ProjectionError("points", points_world, THREE_NUMBERS)
        world = given.astype(np.float64)
        wrong = ~np.isfinite(world).all(axis=-1) | (np.abs(world) > LARGEST).any(axis=-1)
        if wrong.any():
            raise ProjectionError("points", tuple(world[wrong][0].tolist()), THREE_NUMBERS)
        view = self._view(world)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
            return self._trace_view(world, view)

    def _view(self, world: Array) -> Array:
        flat = world.reshape(-1, 3)
        view = np.empty_like(flat)
        rotation_t = self.camera.frame.T
        for start in range(0, len(flat), _CHUNK):
            block = slice(start, start + _CHUNK)
            np.matmul(flat[block] - self.camera.eye, rotation_t, out=view[block])
        return view.reshape(world.shape)

    def _trace_view(self, world: Array, view: Array) -> Trace:
        near, far = self.lens.near, self.lens.far
        x, y, distance = view[..., 0], view[..., 1], -view[..., 2]
        if isinstance(self.lens, Perspective):
            w = distance
            scale_y = self.lens.cot_half_fov_y
            x_clip, y_clip = scale_y / self.aspect * x, scale_y * y
            x_ndc, y_ndc = scale_y / self.aspect * (x / w), scale_y * (y / w)
            if self.depth == "reversed":
                ratio = near / (far - near) if far != math.inf else 0.0
                numerator = near + 0.0 * w if far == math.inf else ratio * (far - w)
            else:
                numerator = (1.0 if far == math.inf else far / (far - near)) * (w - near)
            depth = np.asarray(numerator / w)
        else:
            left, right, bottom, top = self.window
            w = np.ones_like(distance)
            x_clip = ((x - left) - (right - x)) / (right - left)
            y_clip = ((y - bottom) - (top - y)) / (top - bottom)
            x_ndc, y_ndc = x_clip, y_clip
            from_plane = far - distance if self.depth == "reversed" else distance - near
            numerator = depth = np.asarray(from_plane / (far - near))
        opengl = self.depth == "opengl"
        z_clip = 2.0 * numerator - w if opengl else numerator
        clip = np.stack([x_clip, y_clip, z_clip, w], axis=-1)
        ndc = np.stack([x_ndc, y_ndc, 2.0 * depth - 1.0 if opengl else depth], axis=-1)
        width, height = self.image_size
        image = np.stack(
            [(x_ndc + 1.0) * (width / 2.0), (1.0 - y_ndc) * (height / 2.0)], axis=-1
        )
        in_front = (w > 0.0) & np.isfinite(ndc).all(axis=-1) & np.isfinite(image).all(axis=-1)
        for array in (ndc, image, depth):
            array[~in_front] = np.nan
        outside = np.stack(
            [distance < near, distance > far, x_clip < -w, x_clip > w, y_clip < -w, y_clip > w],
            axis=-1,
        )
        return Trace(world, view, clip, ndc, image, depth, in_front, outside)

    # -- the same picture with another lens

    def with_lens(self, kind: str) -> Projection:
        """Change the kind of lens, keeping what lies at the target the same size.

        Parameters
        ----------
        kind : {"perspective", "orthographic"}

        Raises
        ------
        ProjectionError
            For another kind.
        """
        lens, distance = self.lens, self.camera.distance
        if kind == lens.kind:
            return self
        if isinstance(lens, Perspective) and kind == "orthographic":
            half = distance / lens.cot_half_fov_y
            far = lens.far if lens.far != math.inf else max(4.0 * distance, 2.0 * lens.near)
            box = (-self.aspect * half, self.aspect * half, -half, half)
            return replace(self, lens=Orthographic(*box, lens.near, far, "y"))
        if isinstance(lens, Orthographic) and kind == "perspective":
            _, _, bottom, top = self.window
            fov_y_deg = 2.0 * math.degrees(math.atan2((top - bottom) / 2.0, distance))
            near = lens.near if lens.near > 0.0 else min(distance, abs(lens.far)) / 1000.0
            far = lens.far if lens.far > near else 2.0 * near
            return replace(self, lens=Perspective(fov_y_deg, near, far))
        raise ProjectionError("kind", kind, ONE_OF, ", ".join(LENSES))


# --------------------------------------------------------------------------- field of view


def fov_x_from_fov_y(fov_y_deg: float, aspect: float) -> float:
    """Horizontal field of view of a symmetric lens, degrees.

    ``tan(fov_x/2) = aspect tan(fov_y/2)``; for the converse give ``1/aspect``.
    """
    complement_deg = (180.0 - fov_y_deg) / 2.0
    sin_half = math.sin(math.radians(fov_y_deg / 2.0))
    cos_half = math.sin(math.radians(complement_deg))
    return math.degrees(2.0 * math.atan2(aspect * sin_half, cos_half))


def focal_length_35mm(fov_y_deg: float, aspect: float) -> float:
    """Focal length in mm of the 36 x 24 mm camera with the same diagonal field of view.

    The diagonal is what the 35-mm equivalent compares (CIPA DCG-001), since images need not
    have the proportions of the film.
    """
    half_diagonal = math.hypot(aspect, 1.0)  # of a picture of half-height 1
    return _FULL_FRAME_DIAGONAL_MM / 2.0 * Perspective(fov_y_deg).cot_half_fov_y / half_diagonal


def fov_y_from_focal_length_35mm(focal_length_mm: float, aspect: float) -> float:
    """Vertical field of view in degrees, the converse of `focal_length_35mm`.

    Raises
    ------
    ProjectionError
        If the focal length is not a finite number above 0.
    """
    focal_length_mm = _finite("focal_length_mm", focal_length_mm)
    if focal_length_mm <= 0.0:
        raise ProjectionError("focal_length_mm", focal_length_mm, ABOVE, 0)
    half_height = _FULL_FRAME_DIAGONAL_MM / 2.0 / math.hypot(aspect, 1.0)
    return math.degrees(2.0 * math.atan2(half_height, focal_length_mm))
