"""What a lens is used with, and the values in which it answers."""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple, Protocol, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.arithmetic.double_double import DoubleDouble
from app.arithmetic.rationals import Rationals
from app.model.camera import Camera
from app.model.limits import Array, DepthRange

Window: TypeAlias = tuple[float, float, float, float]
"""Left, right, bottom, top, in world units."""


class Axis(NamedTuple):
    """One side of the picture: its middle and its extent, on the near plane."""

    middle: float
    extent: float

    @classmethod
    def between(cls, low: Fraction, high: Fraction) -> Axis:
        """Of a window's two sides, without its rounding."""
        return cls(float((low + high) / 2), float(high - low))

    @property
    def skew(self) -> float:
        """How far the middle is from 0, in halves of the extent: ``(r + l)/(r - l)``."""
        return self.middle / (self.extent / 2.0)

    def across(self, value: Array) -> Array:
        """From -1 at the low end to 1 at the high one; the difference is rounded where small."""
        across: Array = (value - self.middle) / (self.extent / 2.0)
        return across


class ExactLens(NamedTuple):
    """A lens in rationals, irrational numbers to `double_double.BITS` bits.

    Attributes
    ----------
    scale, shift : (Fraction, Fraction)
        ``x_clip = scale x + shift w``, x that of the picture on the near plane times w.
    shear : (Fraction, Fraction)
        ``cot(alpha), cot(beta)`` of an oblique lens.
    near : Fraction
    far : Fraction or None
        None at infinity.
    """

    scale: tuple[Fraction, Fraction]
    shift: tuple[Fraction, Fraction]
    shear: tuple[Fraction, Fraction]
    near: Fraction
    far: Fraction | None


class Intrinsics(NamedTuple):
    """A perspective camera as photogrammetry and OpenCV write it, all in pixels.

    Attributes
    ----------
    fx, fy : float
        Focal length in pixel widths and in pixel heights.
    cx, cy : float
        Principal point, counted from the *centre* of the first pixel as OpenCV does: an image
        640 wide with the axis in its middle has ``cx = 319.5``, which is 320 in our pixels.

    Notes
    -----
    ``K = [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]`` maps x right, y down, z forward to pixels
    (Hartley and Zisserman, Multiple View Geometry, 6.1).
    """

    fx: float
    fy: float
    cx: float
    cy: float


class Angles(NamedTuple):
    """How much a lens sees.

    Attributes
    ----------
    fov_x_deg, fov_y_deg : float
    focal_mm : float
        Focal length of the 36 x 24 mm camera with the same diagonal field of view.
    """

    fov_x_deg: float
    fov_y_deg: float
    focal_mm: float


class Trace(NamedTuple):
    """Points followed through every stage; ``...`` is the shape of the points without the 3.

    Attributes
    ----------
    world, view : (..., 3) float64
    clip : (..., 4) float64
        Homogeneous, before the divide; w is the distance from the eye plane (1 for a parallel
        lens).
    ndc : (..., 3) float64
        After the divide; NaN where w <= 0: a point behind the eye has no picture. Nor has one so
        close to the eye plane that its picture is beyond float64's 1e308.
    image : (..., 2) float64
        Pixels, origin top-left; NaN where `ndc` is.
    depth : (...) float64
        What a depth buffer in [0, 1] would hold before quantising; NaN where `ndc` is.
    in_front : (...) bool
        Where there is a picture: w > 0.
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


class Setup(Protocol):
    """What a lens is used with, and asked about: a `Projection`, which documents all of it."""

    @property
    def camera(self) -> Camera: ...
    @property
    def image_size(self) -> tuple[int, int]: ...
    @property
    def aspect(self) -> float: ...
    @property
    def depth(self) -> DepthRange: ...
    @property
    def depth_range(self) -> tuple[float, float]: ...
    @property
    def window(self) -> Window: ...
    @property
    def axes(self) -> tuple[Axis, Axis]: ...
    @property
    def view_error(self) -> float: ...
    @property
    def view_rotation(self) -> Array: ...
    @property
    def clip_from_view(self) -> Array: ...
    @property
    def view_from_clip(self) -> Array: ...
    @property
    def clip_from_eye(self) -> Array: ...
    @property
    def image_from_ndc(self) -> Array: ...
    @property
    def exact_lens(self) -> ExactLens: ...
    @property
    def exact_from_eye(self) -> tuple[Rationals, Rationals]: ...
    @property
    def eye_from_clip(self) -> Rationals: ...

    def with_depth(self, depth: DepthRange) -> Setup: ...
    def view(self, world: Array, rest: Array | None = None) -> tuple[Array, Array]: ...
    def trace(self, points: ArrayLike) -> Trace: ...
    def world_from_image(self, points_image: ArrayLike) -> Array: ...
    def view_double_double(
        self, points_world: Array, rest: Array | None = None
    ) -> tuple[DoubleDouble, ...]: ...


HalfSpaces: TypeAlias = list[tuple[tuple[float, float, float, float], float]]
"""Normals and offsets: what is inside has ``normal . (x, y, z, w) + offset >= 0`` for all."""
