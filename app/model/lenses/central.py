"""Lenses whose projectors meet in the eye: w is the distance, and the divide is real."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from app.arithmetic import double_double as dd
from app.arithmetic.rationals import Rationals
from app.model.lenses.closed_form import FULL_FRAME_DIAGONAL_MM, ClosedForm
from app.model.lenses.lens import Lens, LensTable, Seen
from app.model.lenses.setup import Angles, Axis, ExactLens, HalfSpaces, Intrinsics, Setup, Window
from app.model.lenses.solving import ends
from app.model.limits import SMALLEST, Array, Keep, Vector
from app.model.refusal import QT_TRANSLATE_NOOP


@dataclass(frozen=True)
class Central(ClosedForm):
    """A lens whose projectors meet in the eye: pictures are larger the nearer things are."""

    central: ClassVar[bool] = True
    far_may_be_infinite: ClassVar[bool] = True
    shape: ClassVar[str] = QT_TRANSLATE_NOOP("phenomena", "truncated pyramid")
    # View 1, cotangent 4, aspect and its quotient, x/w, product; w 1.
    roundings: ClassVar[tuple[float, float, float, float]] = (8.0, 8.0, 8.0, 1.0)

    def table_to(self, far: float) -> LensTable:
        if far == math.inf:
            return self.but(far=far).table
        return self.table.otherwise.get("far", self.table)

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
        return Intrinsics(
            width * self.near / x_axis.extent,
            height * self.near / y_axis.extent,
            (width - 1) / 2.0 - width / 2.0 * x_axis.skew,
            (height - 1) / 2.0 + height / 2.0 * y_axis.skew,
        )

    def slopes(self, aspect: Fraction) -> Window:
        left, right, bottom, top = (side / self.near for side in self.window(aspect))
        return left, right, bottom, top

    def section(self, aspect: Fraction) -> Fraction:
        left, right, bottom, top = map(Fraction, self.window(aspect))
        return (right - left) * (top - bottom) / Fraction(self.near) ** 2

    def volume(self, section: Fraction) -> Fraction:
        near, far = Fraction(self.near), Fraction(self.far)
        return section * (far - near) * (far * far + far * near + near * near) / 3

    def ridden(self, window: Window, factor: float) -> Lens:
        left, right, bottom, top = (side / factor for side in window)
        keep: Keep = getattr(self, "keep", "y")
        return self.with_window((left, right, bottom, top), self.near, self.far, keep)

    # -- the canonical volumes

    @property
    def canonical_unit(self) -> float:
        return self.near if self.far == math.inf else self.far

    @property
    def _ratio(self) -> float:
        """z of the near plane in the canonical pyramid, mirrored: near/far, 1 for far = inf."""
        return 1.0 if self.far == math.inf else self.near / self.far

    @property
    def canonical_from_box(self) -> Array:
        # near/far M_pp^-1, without the difference of 1 and near/far.
        near, far, ratio = self.near, self.far, self._ratio
        matrix = np.diag([ratio, ratio, 0.0, 0.0])
        if far == math.inf:
            matrix[2:, 2:] = (0.0, -1.0), (1.0, 0.0)
        else:
            matrix[2:, 2:] = (0.0, -ratio), ((far - near) / far, ratio)
        return matrix

    def edges(self, at: Callable[[float], Array]) -> tuple[Array, Array]:
        # The far corners, or the near ones of an infinite frustum, are rays times a length.
        near, far, rays = self.near, self.far, at(-1.0)
        along = rays * ((far - near) / far if far < math.inf else math.inf)
        along[np.isnan(along)] = 0.0  # 0 times infinity, on an axis
        return rays * self._ratio, along

    # -- distances and depths

    def w(self, distance: Any) -> Any:
        return distance

    def depth(self, distance: Array, *, reverse: bool) -> Array:
        near, far = self.near, self.far
        if far == math.inf:
            with np.errstate(invalid="ignore"):
                standard = np.where(distance == math.inf, 1.0, (distance - near) / distance)
            return np.asarray(near / distance if reverse else standard)
        from_plane = far - distance if reverse else distance - near
        scale = self._depth_scale(near, far, reverse=reverse)
        return np.asarray(np.minimum(scale * (from_plane / distance), 1.0))  # 1 + 1 ulp at the end

    def distance(self, gone: Any, left_over: Any) -> Any:
        return self.near / (left_over + self.near / self.far * gone)

    def gap(self, distance: Array, step: Array) -> Array:
        near, far = self.near, self.far
        with np.errstate(invalid="ignore", divide="ignore"):
            x = distance / near * step * (1.0 if far == math.inf else (far - near) / far)
            return np.where(x < 1.0, distance * (x / (1.0 - x)), np.inf)

    @property
    def depth_slope(self) -> float:
        return (
            self.near if self.far == math.inf else self.near * (self.far / (self.far - self.near))
        )

    @property
    def eye_room(self) -> float:
        return self.near

    @cached_property
    def _near_ratio(self) -> tuple[float, float]:
        """``n/(f - n)`` of a finite lens, rounded once, and the rest."""
        near, far = Fraction(self.near), Fraction(self.far)
        return dd.from_exact(near / (far - near))

    # -- points

    def _pictured(
        self, setup: Setup, x: Array, y: Array, distance: Array
    ) -> tuple[tuple[Array, Array], Array, tuple[Array, Array]]:
        w, near, (x_axis, y_axis) = distance, self.near, setup.axes
        ndc = x_axis.across(near * (x / w)), y_axis.across(near * (y / w))
        # Where w is 0 there is no quotient, but still a point in clip space.
        x_clip = 2.0 * near / x_axis.extent * x - x_axis.skew * w
        y_clip = 2.0 * near / y_axis.extent * y - y_axis.skew * w
        return (x_clip, y_clip), w, ndc

    def _depth_over_w(self, distance: Array, rest: Array, *, reverse: bool) -> tuple[Array, Array]:
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
            # Between planes that nearly touch, all that the depth has left is what was cut off.
            from_plane = (distance - near) - rest
            scale = 1.0 if far == math.inf else self._depth_scale(near, far, reverse=False)
            numerator = scale * from_plane
        return numerator, numerator / w

    def _shift(self, x: Sequence[Fraction], y: Sequence[Fraction]) -> tuple[Fraction, Fraction]:
        return -x[2], -y[2]

    def _clipped(self, n: ExactLens, x: Any, y: Any, distance: Any, one: Any) -> tuple[Any, ...]:
        x_clip, y_clip = (
            value * scale + distance * shift
            for value, scale, shift in zip((x, y), n.scale, n.shift, strict=True)
        )
        return x_clip, y_clip, distance

    def _depth_scale(self, near: Any, far: Any, *, reverse: bool) -> Any:
        return (near if reverse else far) / (far - near)

    def enlarged(self, distance: Any) -> Any:
        return distance / self.near

    def outwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        k = self.enlarged(distance)
        return x * k, y * k

    def inwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        return x / distance * self.near, y / distance * self.near

    def line(
        self, setup: Setup, pixel: tuple[float, float] | None, point: Vector | None, at: Array
    ) -> Array | None:
        if point is None:
            return super().line(setup, pixel, point, at)
        eye = np.array(setup.camera.eye)
        offset = np.array(point) - eye
        away = -float(setup.camera.frame[2] @ offset)
        return eye + at[:, None] * (offset / away) if away > 0.0 else None

    def _nearer_by(self, distance: float, height: float, down_px: float, height_px: int) -> float:
        with np.errstate(over="ignore", under="ignore"):
            nearer = distance * float(np.exp2(-4.0 * down_px / height_px))
        return nearer if nearer > 0.0 else math.inf  # it never reaches the eye

    def along(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        return x / distance, y / distance

    def rays(self, on_near: Array) -> tuple[Array, Array]:
        return np.zeros_like(on_near), on_near / self.near

    # -- as another lens

    @classmethod
    def showing(cls, seen: Seen) -> Lens:
        """With the same window on the near plane, or of a parallel lens the one at the target."""
        lens, distance = seen.lens, seen.distance
        near, far = lens.near, lens.far
        if near < SMALLEST:
            near = (min(distance, far) if far > 0.0 else distance) / 1000.0
        if far <= near:  # the volume is behind the eye; the target shall be in the new one
            far = 2.0 * distance
        window = seen.window
        if not lens.central:
            left, right, bottom, top = lens.window_at(window, distance)
            k = near / distance
            window = k * left, k * right, k * bottom, k * top
        return cls.with_window(window, near, far, getattr(lens, "keep", "y"))

    @classmethod
    def having(cls, cells: Rationals, near: float, far: float, in_hand: Lens) -> Iterator[Lens]:
        if in_hand.kind == cls.kind:
            yield in_hand.but(near=near, far=far)
        yield cls.solved(cells, near, far)

    @classmethod
    def solved(cls, cells: Rationals, near: float, far: float) -> Lens:
        """The lens with these rows of x and y."""
        (x_scale, _, x_skew, _), (_, y_scale, y_skew, _) = cells[:2]
        unit = Fraction(near)
        window = *ends(x_scale, x_skew, unit), *ends(y_scale, y_skew, unit)
        return cls.with_window(window, near, far, "stretch")

    def least_terms(self, row: Sequence[Fraction], number: int) -> tuple[Fraction, ...]:
        nothing, one = Fraction(0), Fraction(1)
        return nothing, nothing, one, nothing

    @classmethod
    def with_window(cls, window: Window, near: float, far: float, keep: Keep) -> Lens:
        """The lens with this window on its near plane, or as much of it as it can have."""
        raise NotImplementedError

    # -- its matrices

    def least_w(self, setup: Setup) -> float:
        return self.near

    def between(
        self, setup: Setup, rows: tuple[Array, Array], window: Window, near: float, far: float
    ) -> tuple[Array, Array]:
        clip_from_view, view_from_clip = setup.clip_from_view.copy(), setup.view_from_clip.copy()
        clip_from_view[2] = rows[0]
        view_from_clip[3] = rows[1][1]
        return clip_from_view, view_from_clip

    # -- what its roundings cost

    def stretch(self, window: Window) -> float:
        left, right, bottom, top = window
        across, up = max(abs(left), abs(right)), max(abs(bottom), abs(top))
        half_width, half_height = (right - left) / 2.0, (top - bottom) / 2.0
        slant = math.hypot(across, up, self.near) / self.near
        return slant * max((self.near + across) / half_width, (self.near + up) / half_height)

    def _depth_row(self, *, reverse: bool) -> tuple[float, float, float, float]:
        near, far = self.near, self.far
        if far == math.inf:
            return (0.0, 0.0, 0.0, near) if reverse else (0.0, 0.0, -1.0, -near)
        per_unit = (near if reverse else -far) / (far - near)
        return 0.0, 0.0, per_unit, per_unit * (far if reverse else near)

    # -- for what is drawn and pointed at

    def half_spaces(self, least_w: float) -> HalfSpaces:
        # By w itself: z and w have not enough digits left to compare if far/near is large.
        found: HalfSpaces = [((0.0, 0.0, 0.0, 1.0), -self.near)]
        if self.far != math.inf:
            found.append(((0.0, 0.0, 0.0, -1.0), self.far))
        return found

    def w_of_z(self, a: float, b: float) -> tuple[float, float]:
        return -1.0 / a, b / a

    def nearer(
        self, a: float, b: float, share: float, length: float, least: float
    ) -> tuple[float, float]:
        # z_clip = a z + b with -z = w, so that b / (1 - share) for b is the depth at w (1 - share).
        return b * share, 0.0

    def side(self, edge: float, axis: int) -> tuple[float, float]:
        return edge / self.near, 0.0
