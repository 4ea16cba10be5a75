"""Lenses whose projectors meet in the eye: w is the distance, and the divide is real."""

import math
from abc import abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import ClassVar

import numpy as np

from app.arithmetic import double_double as dd
from app.arithmetic.rationals import Rationals
from app.model.lenses.answers import Angles, Axes, Axis, Intrinsics, Window
from app.model.lenses.lens import EyeLens, Lens, Seen
from app.model.lenses.solving import ends
from app.model.limits import SMALLEST, Array, Keep
from app.model.refusal import QT_TRANSLATE_NOOP

FULL_FRAME_DIAGONAL_MM = math.hypot(36.0, 24.0)


@dataclass(frozen=True)
class Central(EyeLens):
    """A lens whose projectors meet in the eye: nearer objects look larger."""

    central: ClassVar[bool] = True
    far_may_be_infinite: ClassVar[bool] = True
    shape: ClassVar[str] = QT_TRANSLATE_NOOP("phenomena", "truncated pyramid")
    # View 1, cotangent 4, aspect and its quotient, x/w, product; w 1.
    roundings: ClassVar[tuple[float, float, float, float]] = (8.0, 8.0, 8.0, 1.0)

    def angles(self, aspect: Fraction) -> Angles | None:
        sides = self.window(aspect)
        left, right, bottom, top = (math.atan2(side, self.near) for side in sides)
        diagonal = math.hypot(sides[1] - sides[0], sides[3] - sides[2])
        focal_mm = FULL_FRAME_DIAGONAL_MM * (self.near / diagonal)
        return Angles(math.degrees(right - left), math.degrees(top - bottom), focal_mm)

    def intrinsics(self, image_size: tuple[int, int]) -> Intrinsics:
        width, height = image_size
        exact = self.exact_window(Fraction(*image_size))
        x_axis, y_axis = Axis.between(*exact[:2]), Axis.between(*exact[2:])
        values = (
            width * self.near / x_axis.extent,
            height * self.near / y_axis.extent,
            (width - 1) / 2.0 - width / 2.0 * x_axis.skew,
            (height - 1) / 2.0 + height / 2.0 * y_axis.skew,
        )
        # 240, not 239.99999999999997.
        return Intrinsics(*(float(f"{value:.15g}") for value in values))

    def stretch(self, window: Window) -> float:
        left, right, bottom, top = window
        across, up = max(abs(left), abs(right)), max(abs(bottom), abs(top))
        half_width, half_height = (right - left) / 2.0, (top - bottom) / 2.0
        slant = math.hypot(across, up, self.near) / self.near
        return slant * max((self.near + across) / half_width, (self.near + up) / half_height)

    # -- points

    def pictured(
        self, axes: Axes, aspect: float, x: Array, y: Array, distance: Array
    ) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        w, near, (x_axis, y_axis) = distance, self.near, axes()
        ndc = x_axis.across(near * (x / w)), y_axis.across(near * (y / w))
        # Where w is 0 there is no quotient, but still a point in clip space.
        x_clip = 2.0 * near / x_axis.extent * x - x_axis.skew * w
        y_clip = 2.0 * near / y_axis.extent * y - y_axis.skew * w
        return (x_clip, y_clip), ndc

    @cached_property
    def _near_ratio(self) -> tuple[float, float]:
        """``n/(f - n)`` of a finite lens, rounded once, and its rounding error."""
        near, far = Fraction(self.near), Fraction(self.far)
        return dd.from_exact(near / (far - near))

    def depth_over_w(self, distance: Array, rest: Array, *, reverse: bool) -> tuple[Array, Array]:
        near, far, w = self.near, self.far, distance
        if reverse and far != math.inf:
            # What the difference, the ratio and w were rounded by is added to the product:
            # three roundings in all, 3.4e-16 of w that depth implies.
            ratio, ratio_rest = self._near_ratio
            gap = far - w
            product = ratio * gap
            tail = ratio_rest * gap + ratio * (((far - gap) - w) + rest)
            return product + tail, (product + (tail + product * (rest / w))) / w
        if reverse:
            numerator = near + 0.0 * w
        else:
            # Between planes that nearly touch, the depth consists only of the rounding errors.
            from_plane = (distance - near) - rest
            scale = 1.0 if far == math.inf else self.depth_scale(near, far, reverse=False)
            numerator = scale * from_plane
        return numerator, numerator / w

    def nearer_by(self, distance: float, height: float, down_px: float, height_px: int) -> float:
        with np.errstate(over="ignore", under="ignore"):
            nearer = distance * float(np.exp2(-4.0 * down_px / height_px))
        return nearer if nearer > 0.0 else math.inf  # it never reaches the eye

    # -- as another lens

    def dollied(self, window: Window, factor: float) -> Lens:
        left, right, bottom, top = (side / factor for side in window)
        keep: Keep = getattr(self, "keep", "y")
        return self.with_window((left, right, bottom, top), self.near, self.far, keep)

    @classmethod
    def showing(cls, seen: Seen) -> Lens:
        """Keep the window on the near plane; from a parallel lens, keep the one at the target."""
        lens, distance = seen.lens, seen.distance
        near, far = lens.near, lens.far
        if near < SMALLEST:
            near = (min(distance, far) if far > 0.0 else distance) / 1000.0
        if far <= near:  # the volume is behind the eye; the new one must contain the target
            far = 2.0 * distance
        window = seen.window
        if not lens.central:
            left, right, bottom, top = lens.window_at(window, distance)
            k = near / distance
            window = k * left, k * right, k * bottom, k * top
        return cls.with_window(window, near, far, getattr(lens, "keep", "y"))

    @classmethod
    @abstractmethod
    def with_window(cls, window: Window, near: float, far: float, keep: Keep) -> Lens:
        """Return the lens with this window on its near plane, or with as much of it as possible."""

    @classmethod
    def solutions_for(
        cls, cells: Rationals, near: float, far: float, in_hand: Lens
    ) -> Iterator[Lens]:
        if in_hand.kind == cls.kind:
            yield in_hand.replaced(near=near, far=far)
        yield cls.solved(cells, near, far)

    @classmethod
    def solved(cls, cells: Rationals, near: float, far: float) -> Lens:
        """Return the lens with these rows of x and y."""
        (x_scale, _, x_skew, _), (_, y_scale, y_skew, _) = cells[:2]
        unit = Fraction(near)
        window = *ends(x_scale, x_skew, unit), *ends(y_scale, y_skew, unit)
        return cls.with_window(window, near, far, "stretch")

    def least_terms(self, row: Sequence[Fraction], number: int) -> tuple[Fraction, ...]:
        nothing, one = Fraction(0), Fraction(1)
        return nothing, nothing, one, nothing
