"""The types that lenses return: windows, axes, angles, intrinsics, exact numbers."""

from collections.abc import Callable
from fractions import Fraction
from typing import NamedTuple, TypeAlias

from app.model.limits import Array

Window: TypeAlias = tuple[float, float, float, float]  # left, right, bottom, top, in world units
ExactWindow: TypeAlias = tuple[Fraction, Fraction, Fraction, Fraction]


class Axis(NamedTuple):
    """One side of the picture on the near plane."""

    middle: float
    extent: float

    @classmethod
    def between(cls, low: Fraction, high: Fraction) -> "Axis":
        """From the two sides of a window before they are rounded."""
        return cls(float((low + high) / 2), float(high - low))

    @property
    def skew(self) -> float:
        """Distance of the middle from 0 in units of half the extent: ``(r + l)/(r - l)``."""
        return self.middle / (self.extent / 2.0)

    def across(self, value: Array) -> Array:
        """Map the low end to -1 and the high end to 1; subtracting first loses little."""
        across: Array = (value - self.middle) / (self.extent / 2.0)
        return across


Axes: TypeAlias = Callable[[], tuple[Axis, Axis]]
"""Computes the picture's x and y range on the near plane, on demand."""


class ExactLens(NamedTuple):
    """A lens in rationals; irrational numbers have `double_double.BITS` bits."""

    scale: tuple[Fraction, Fraction]
    shift: tuple[Fraction, Fraction]
    """``x_clip = scale x + shift w``, where x is measured on the near plane, times w."""
    shear: tuple[Fraction, Fraction]  # ``cot(alpha), cot(beta)`` of an oblique lens
    near: Fraction
    far: Fraction | None  # None for infinity


class Intrinsics(NamedTuple):
    """A perspective camera as photogrammetry and OpenCV write it, in pixels.

    ``K = [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]`` maps x right, y down, z forward to pixels
    (Hartley and Zisserman, Multiple View Geometry, 6.1). Like OpenCV's, the principal point
    ``cx, cy`` is counted from the *centre* of the first pixel: 319.5 is the middle of 640 pixels,
    which is 320 in our image coordinates.
    """

    fx: float
    fy: float
    cx: float
    cy: float


class Angles(NamedTuple):
    """Fields of view, and the focal length of the 36 x 24 mm camera with the same diagonal one."""

    fov_x_deg: float
    fov_y_deg: float
    focal_mm: float
