"""Lenses that see from an eye, between near and far: points go through them in closed form.

Eye first: what comes in are view coordinates, and the distance from the eye plane is kept apart
from what is divided by it. What differs between a `Central` and a `Parallel` lens is how the
picture grows with the distance, and how the depth does.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Any, ClassVar, cast

import numpy as np

from app.arithmetic import double_double as dd
from app.arithmetic.double_double import DoubleDouble
from app.arithmetic.rationals import Rationals
from app.model.formula import FLOAT64
from app.model.lenses.lens import (
    Angles,
    Axis,
    ExactLens,
    HalfSpaces,
    Intrinsics,
    Lens,
    LensTable,
    Seen,
    Setup,
    Trace,
    Window,
    check_planes,
)
from app.model.lenses.solving import ends
from app.model.limits import (
    BEYOND,
    CUBE_FACE,
    LARGEST,
    NO_POINT,
    SMALLEST,
    Array,
    Keep,
    Vector,
    read_only,
)
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from app.model.tables import evaluated

FULL_FRAME_DIAGONAL_MM = math.hypot(36.0, 24.0)
COTS = ("cot(alpha)", "cot(beta)")
"""The letters of what leans."""

_NOTHING, _ONE = Fraction(0), Fraction(1)
_CHUNK = 16384  # larger blocks wake OpenBLAS's second thread, which fights a software renderer


@dataclass(frozen=True)
class ClosedForm(Lens):
    """A lens with an eye plane, from which near, far and all depths are measured."""

    def cut(self, window: Window, near: float, far: float) -> Lens:
        near, far = self.checked_planes(near, far)
        return self.but(near=near, far=far)

    @classmethod
    def checked_planes(cls, near: Any, far: Any) -> tuple[float, float]:
        return check_planes(near, far, parallel=cls.parallel)

    # -- its matrices

    def stated_in(self, setup: Setup) -> tuple[Array, Array]:
        return setup.clip_from_view, setup.view_rotation

    def clip_from_eye(self, setup: Setup) -> Array:
        return read_only(setup.clip_from_view @ setup.view_rotation)

    def eye_from_clip(self, setup: Setup) -> tuple[Array, ...]:
        return setup.view_rotation.T, setup.view_from_clip

    def view_from_clip(self, setup: Setup, letters: Mapping[str, float]) -> Array:
        table = self.table.view_from_clip
        assert table is not None
        return read_only(evaluated(table, letters, FLOAT64))

    def corners_world(self, setup: Setup) -> Array:
        # Through the reversed range: there 1/w of the far face is 1/far itself, where [-1, 1]
        # makes it a difference of two numbers of the size of 1/near.
        cube = [(x, y, z, 1.0) for z in (1.0, 0.0) for x, y in CUBE_FACE]
        corners = np.array(cube) @ setup.with_depth("reversed").view_from_clip.T
        finite = corners[:, 3] != 0.0
        corners[finite] /= corners[finite, 3:]
        directions = corners[:, :3] @ setup.camera.frame
        directions[finite] += setup.camera.eye
        return read_only(np.column_stack([directions, corners[:, 3]]))

    def exact(self, letters: Mapping[str, Fraction]) -> ExactLens:
        zero = Fraction(0)
        upright = {**letters, **dict.fromkeys(COTS, zero)}
        x, y, *_ = evaluated(self.table.clip_from_view, upright)
        cot_alpha, cot_beta = (letters.get(cot, zero) for cot in COTS)
        return ExactLens(
            (x[0], y[1]),
            self._shift(x, y),
            (cot_alpha, cot_beta),
            Fraction(self.near),
            letters.get("f"),
        )

    def _shift(self, x: Sequence[Fraction], y: Sequence[Fraction]) -> tuple[Fraction, Fraction]:
        """`ExactLens.shift` from the rows of its matrix."""
        raise NotImplementedError

    # -- points, eye first

    def trace(self, setup: Setup, world: Array) -> Trace:
        flat = world.reshape(-1, 3)
        count = len(flat)
        # In one piece: the system hands out a large one many times as fast as several.
        numbers = np.empty(13 * count)
        view, clip, ndc, image = (
            numbers[first * count : last * count].reshape(count, last - first)
            for first, last in ((0, 3), (3, 7), (7, 10), (10, 12))
        )
        in_front, outside = np.empty(count, dtype=bool), np.empty((count, 6), dtype=bool)
        traced = Trace(flat, view, clip, ndc, image, numbers[12 * count :], in_front, outside)
        for start in range(0, count, _CHUNK):
            self._trace_block(setup, Trace._make(part[start : start + _CHUNK] for part in traced))
        shape = world.shape[:-1]
        return Trace._make(part.reshape(shape + part.shape[1:]) for part in traced)

    def _trace_block(self, setup: Setup, traced: Trace) -> None:
        """Fill in what follows from the world coordinates, row by row: so numpy is fast."""
        rows, rest = setup.view(traced.world)
        x, y, z = rows
        distance = -z
        (x_clip, y_clip), w, (x_ndc, y_ndc) = self._pictured(setup, x, y, z)
        numerator, depth = self._depth_over_w(distance, rest, reverse=setup.depth == "reversed")
        opengl = setup.depth == "opengl"
        z_clip = 2.0 * numerator - w if opengl else numerator
        z_ndc = 2.0 * depth - 1.0 if opengl else depth
        width, height = setup.image_size
        right, down = (x_ndc + 1.0) * (width / 2.0), (1.0 - y_ndc) * (height / 2.0)
        for array, columns in (
            (traced.view, rows),
            (traced.clip, (x_clip, y_clip, z_clip, w)),
            (traced.ndc, (x_ndc, y_ndc, z_ndc)),
            (traced.image, (right, down)),
        ):
            for i, column in enumerate(columns):
                array[:, i] = column
        traced.depth[...] = depth
        in_front = np.greater(w, 0.0, out=traced.in_front)
        for row in (right, down, z_ndc):  # pixels are finite only where x and y of the cube are
            in_front &= np.isfinite(row)
        if not in_front.all():
            for array in (traced.ndc, traced.image, traced.depth):
                array[~in_front] = np.nan
        beyond, minus_w = traced.outside.T, -w
        np.less(distance, self.near, out=beyond[0])
        np.greater(distance, self.far, out=beyond[1])
        for i, row in ((2, x_clip), (4, y_clip)):
            np.less(row, minus_w, out=beyond[i])
            np.greater(row, w, out=beyond[i + 1])

    def _pictured(
        self, setup: Setup, x: Array, y: Array, z: Array
    ) -> tuple[tuple[Array, Array], Array, tuple[Array, Array]]:
        """x and y of clip space, w, and x and y of the cube."""
        raise NotImplementedError

    def _depth_over_w(self, distance: Array, rest: Array, *, reverse: bool) -> tuple[Array, Array]:
        """The depth times w, and the depth; `rest` is what rounding cut off z, -distance."""
        raise NotImplementedError

    def world_from_image(self, setup: Setup, points: Array) -> Array:
        depth = points[..., 2]
        # From 0 at the near plane to 1 at the far one, and what is left of it, without a
        # difference where the format has its digits.
        gone, left_over = (
            (1.0 - depth, depth) if setup.depth == "reversed" else (depth, 1.0 - depth)
        )
        with np.errstate(divide="ignore", over="ignore"):
            distance = self.distance(gone, left_over)
        width, height = setup.image_size
        x_axis, y_axis = setup.axes
        x = x_axis.middle + x_axis.extent * ((points[..., 0] - width / 2.0) / width)
        y = y_axis.middle - y_axis.extent * ((points[..., 1] - height / 2.0) / height)
        with np.errstate(over="ignore", invalid="ignore"):
            x, y = self.outwards(x, y, distance)
        nowhere = ~(np.abs(x) + np.abs(y) + np.abs(distance) < BEYOND)
        if nowhere.any():
            raise Refusal("depth", float(depth[nowhere][0]), NO_POINT)
        # With twice the digits, so that there and back together stay within 1e-15 of w.
        view = [DoubleDouble(part, np.zeros_like(part)) for part in (x, y, -distance)]
        world = np.empty_like(points)
        for column, eye in enumerate(setup.camera.eye):
            total = DoubleDouble(np.asarray(eye), np.zeros(()))
            for axis, part in zip(setup.frame_double_double, view, strict=True):
                total = dd.add(total, dd.multiply(axis[column], part))
            world[..., column] = total.hi
        return world

    def line(
        self, setup: Setup, pixel: tuple[float, float] | None, point: Vector | None, at: Array
    ) -> Array | None:
        # Where (x w - x_px w) = (y w - y_px w) = 0 at the distance -n (q - e): three equations.
        frame, eye = setup.camera.frame, np.array(setup.camera.eye)
        rows = setup.image_from_ndc @ setup.clip_from_view @ setup.view_rotation
        if pixel is None:
            x, y, _, w = rows[:, :3] @ (np.array(point) - eye) + rows[:, 3]
            pixel = x / w, y / w
        across, down = (row - at_px * rows[3] for row, at_px in zip(rows[:2], pixel, strict=True))
        system = np.array([across[:3], down[:3], -frame[2]])
        fixed = np.full(len(at), -across[3]), np.full(len(at), -down[3]), at
        points: Array = eye + np.linalg.solve(system, np.array(fixed)).T
        return points

    def dragged(
        self, setup: Setup, trace: Trace, shift_px: tuple[float, float], *, along_ray: bool
    ) -> Array | None:
        (x_px, y_px), (right_px, down_px) = trace.image.tolist(), shift_px
        distance = -float(trace.view[2])
        if along_ray:
            _, _, bottom, top = setup.window
            distance = self._nearer_by(distance, top - bottom, down_px, setup.image_size[1])
            if not -LARGEST < distance < LARGEST:
                return None
            line = self.line(setup, None, tuple(trace.world.tolist()), np.array([distance]))
        else:
            at_px = x_px + right_px, y_px + down_px
            line = self.line(setup, at_px, None, np.array([distance]))
        return None if line is None else line[0]

    def _nearer_by(self, distance: float, height: float, down_px: float, height_px: int) -> float:
        """A distance less by what a hand has moved, in the picture's height."""
        raise NotImplementedError

    # -- points in other arithmetics

    def clipped(self, setup: Setup, x: Any, y: Any, z: Any) -> list[Any]:
        n, reverse, distance = setup.exact_lens, setup.depth == "reversed", -z
        one = distance * 0 + 1
        from_near, to_far = distance - n.near, one if n.far is None else -distance + n.far
        x_clip, y_clip, w = self._clipped(n, x, y, distance, one)
        if n.far is None:
            numerator = one * n.near if reverse else from_near
        else:
            scale = self._depth_scale(n.near, n.far, reverse=reverse)
            numerator = (to_far if reverse else from_near) * scale
        z_clip = numerator * 2 - w if setup.depth == "opengl" else numerator
        inside = from_near, to_far, x_clip + w, -x_clip + w, y_clip + w, -y_clip + w
        return [x, y, -distance, x_clip, y_clip, z_clip, w, *inside]

    def _clipped(self, n: ExactLens, x: Any, y: Any, distance: Any, one: Any) -> tuple[Any, ...]:
        """x, y and w of clip space, in any arithmetic."""
        raise NotImplementedError

    def _depth_scale(self, near: Any, far: Any, *, reverse: bool) -> Any:
        """What the distance from a plane is multiplied by to give the depth times w."""
        raise NotImplementedError

    def coordinates(self, setup: Setup, points: Array) -> tuple[Sequence[DoubleDouble], Array]:
        size = np.abs(points - setup.camera.eye).sum(axis=1)
        return setup.view_double_double(points), 3.0 * dd.RELATIVE_ERROR * size + dd.UNDERFLOW

    def exact_coordinates(self, setup: Setup, point: Sequence[float]) -> tuple[Fraction, ...]:
        return setup.camera.exact_view((point[0], point[1], point[2]))

    def view_of(self, setup: Setup, offsets: Any) -> Any:
        return offsets @ setup.view_rotation.astype(offsets.dtype)[:3, :3].T

    def beyond(self, setup: Setup, view: Any, clip: Any) -> tuple[Any, Any]:
        number, distance = view.dtype.type, -view[:, 2]
        return distance < number(self.near), distance > number(self.far)

    # -- what its roundings cost

    def view_error(self, setup: Setup) -> float:
        return setup.view_error

    def depth_terms(self, setup: Setup) -> tuple[Array, Array]:
        # A difference of distances, which are rounded once: by its own size.
        return np.array(self._depth_row(reverse=setup.depth == "reversed")), np.zeros(4)

    def _depth_row(self, *, reverse: bool) -> tuple[float, float, float, float]:
        """The depth times w from view coordinates, as `trace` has it."""
        raise NotImplementedError

    # -- for what is drawn and pointed at

    def order(self, setup: Setup) -> tuple[Array, Array]:
        # Without the digits that the depth loses far away: -1/w, or the distance. Of a row c z + d
        # that makes w, (-d z + c)/(c z + d) only falls with z.
        c, d = setup.clip_from_view[3, 2:]
        limits = [(0.0, 0.0, -1.0, -self.near)]
        if self.far != math.inf:
            limits.append((0.0, 0.0, 1.0, self.far))
        return np.array((0.0, 0.0, 0.0 - d, c)), np.array(limits)


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
        self, setup: Setup, x: Array, y: Array, z: Array
    ) -> tuple[tuple[Array, Array], Array, tuple[Array, Array]]:
        w, near, (x_axis, y_axis) = -z, self.near, setup.axes
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
        return _NOTHING, _NOTHING, _ONE, _NOTHING

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


@dataclass(frozen=True)
class Parallel(ClosedForm):
    """A lens whose projectors are parallel: pictures are as large wherever things are."""

    parallel: ClassVar[bool] = True
    shape: ClassVar[str] = QT_TRANSLATE_NOOP("phenomena", "box")
    # View and near - w, cotangent 4, product, sum, and middle, extent, quotient; w is 1.
    roundings: ClassVar[tuple[float, float, float, float]] = (12.0, 12.0, 12.0, 0.0)

    def table_to(self, far: float) -> LensTable:
        return self.table

    def section(self, aspect: Fraction) -> Fraction:
        left, right, bottom, top = map(Fraction, self.window(aspect))
        return (right - left) * (top - bottom)

    def volume(self, section: Fraction) -> Fraction:
        return section * (Fraction(self.far) - Fraction(self.near))

    # -- the canonical volumes

    @property
    def canonical_unit(self) -> float:
        return 1.0

    @property
    def canonical_from_box(self) -> Array:
        return np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -1], [0, 0, 0, 1]])

    def edges(self, at: Callable[[float], Array]) -> tuple[Array, Array]:
        first = at(0.0)
        return first, at(-1.0) - first

    # -- distances and depths

    def w(self, distance: Any) -> Any:
        return 1.0

    def depth(self, distance: Array, *, reverse: bool) -> Array:
        from_plane = self.far - distance if reverse else distance - self.near
        return np.asarray(from_plane / (self.far - self.near))

    def distance(self, gone: Any, left_over: Any) -> Any:
        return self.near * left_over + self.far * gone

    def gap(self, distance: Array, step: Array) -> Array:
        return step * (self.far - self.near)

    @property
    def even_extent(self) -> float:
        return self.far - self.near

    # -- points

    def _pictured(
        self, setup: Setup, x: Array, y: Array, z: Array
    ) -> tuple[tuple[Array, Array], Array, tuple[Array, Array]]:
        cot_alpha, cot_beta = self.shear
        before = self.near + z
        x_axis, y_axis = setup.axes
        ndc = x_axis.across(x + cot_alpha * before), y_axis.across(y + cot_beta * before)
        return ndc, np.ones_like(z), ndc

    def _depth_over_w(self, distance: Array, rest: Array, *, reverse: bool) -> tuple[Array, Array]:
        near, far = self.near, self.far
        # Between planes that nearly touch, all that the depth has left is what was cut off.
        from_plane = (far - distance) + rest if reverse else (distance - near) - rest
        depth = from_plane / (far - near)
        return depth, depth

    def _shift(self, x: Sequence[Fraction], y: Sequence[Fraction]) -> tuple[Fraction, Fraction]:
        return x[3], y[3]

    def _clipped(self, n: ExactLens, x: Any, y: Any, distance: Any, one: Any) -> tuple[Any, ...]:
        from_near = distance - n.near
        x_clip, y_clip = (
            (value - from_near * cot) * scale + shift
            for value, cot, scale, shift in zip((x, y), n.shear, n.scale, n.shift, strict=True)
        )
        return x_clip, y_clip, one

    def _depth_scale(self, near: Any, far: Any, *, reverse: bool) -> Any:
        return 1 / (far - near)

    def enlarged(self, distance: Any) -> Any:
        return 1.0

    def outwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        cot_alpha, cot_beta = self.shear
        return x + cot_alpha * (distance - self.near), y + cot_beta * (distance - self.near)

    def inwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        cot_alpha, cot_beta = self.shear
        return x - cot_alpha * (distance - self.near), y - cot_beta * (distance - self.near)

    def _nearer_by(self, distance: float, height: float, down_px: float, height_px: int) -> float:
        return distance - height * down_px / height_px

    def along(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        return self.shear

    def rays(self, on_near: Array) -> tuple[Array, Array]:
        shear = np.array(self.shear)
        return on_near - shear * self.near, np.broadcast_to(shear, on_near.shape)

    # -- as another lens

    @classmethod
    def showing(cls, seen: Seen) -> Lens:
        """With the same window in the plane of the target."""
        lens, distance = seen.lens, seen.distance
        far = max(4.0 * distance, 2.0 * lens.near) if lens.far == math.inf else lens.far
        window = lens.window_at(seen.window, distance)
        return cls.with_window_at(distance, window, lens.near, far, getattr(lens, "keep", "y"))

    @classmethod
    def having(cls, cells: Rationals, near: float, far: float, in_hand: Lens) -> Iterator[Lens]:
        leaning, cots = cls._leaning(cells, in_hand)
        if in_hand.kind == cls.kind:
            yield in_hand.but(near=near, far=far, **leaning)
        sides: list[float] = []
        for i, (row, cot) in enumerate(zip(cells[:2], cots, strict=True)):
            sides += ends(row[i], row[i] * cot * Fraction(near) - row[3], Fraction(1))
        yield cast(Any, cls)(*sides, near, far, **leaning)

    @classmethod
    def _leaning(
        cls, cells: Rationals, in_hand: Lens
    ) -> tuple[dict[str, float], Sequence[Fraction]]:
        """The fields by which projectors lean, and their `shear` in rationals."""
        return {}, (Fraction(0), Fraction(0))

    def least_terms(self, row: Sequence[Fraction], number: int) -> tuple[Fraction, ...]:
        if number > 1:
            return _NOTHING, _NOTHING, _ONE, _ONE
        shift = max(_ONE, abs(row[2] * Fraction(self.near)))
        return _NOTHING, _NOTHING, abs(row[number]), shift

    @classmethod
    def with_window_at(
        cls, distance: float, window: Window, near: float, far: float, keep: Keep
    ) -> Lens:
        """The lens with this window at a distance."""
        lens = cast(Any, cls)(*window, near, far, keep)
        left, right, bottom, top = window
        x, y = (cot * (distance - near) for cot in lens.shear)
        moved = {"left": left - x, "right": right - x, "bottom": bottom - y, "top": top - y}
        return cast(Lens, replace(lens, **moved))

    # -- its matrices

    def least_w(self, setup: Setup) -> float:
        return 1.0

    def between(
        self, setup: Setup, rows: tuple[Array, Array], window: Window, near: float, far: float
    ) -> tuple[Array, Array]:
        clip_from_view, view_from_clip = setup.clip_from_view.copy(), setup.view_from_clip.copy()
        clip_from_view[2] = rows[0]
        view_from_clip[2:] = rows[1]
        left, right, bottom, top = window
        for row, (low, high) in enumerate(((left, right), (bottom, top))):
            cot = self.shear[row]
            view_from_clip[row, 2] = -cot * (far - near)
            view_from_clip[row, 3] = (low + high) / 2.0 + cot * (far - self.near)
        return clip_from_view, view_from_clip

    # -- what its roundings cost

    def stretch(self, window: Window) -> float:
        left, right, bottom, top = window
        across, up = max(abs(left), abs(right)), max(abs(bottom), abs(top))
        half_width, half_height = (right - left) / 2.0, (top - bottom) / 2.0
        depth = max(abs(self.near), abs(self.far))
        shear_x, shear_y = (abs(cot) for cot in self.shear)
        extent = self.far - self.near
        distance = math.hypot(across + shear_x * extent, up + shear_y * extent, depth)
        return distance * max((1.0 + shear_x) / half_width, (1.0 + shear_y) / half_height)

    def cell_sizes(self, cells: Array) -> Array:
        sizes = np.abs(cells)
        sizes[:2, 3] += 2.0 * sizes[:2, 2] * abs(self.near)
        return sizes

    def _depth_row(self, *, reverse: bool) -> tuple[float, float, float, float]:
        per_unit = 1.0 / (self.far - self.near)
        if not reverse:
            per_unit = -per_unit
        return 0.0, 0.0, per_unit, per_unit * (self.far if reverse else self.near)

    # -- for what is drawn and pointed at

    def half_spaces(self, least_w: float) -> HalfSpaces:
        return [((0.0, 0.0, 1.0, 0.0), 1.0), ((0.0, 0.0, -1.0, 0.0), 1.0)]

    def nearer(
        self, a: float, b: float, share: float, length: float, least: float
    ) -> tuple[float, float]:
        return a * length, 0.0

    def side(self, edge: float, axis: int) -> tuple[float, float]:
        cot = self.shear[axis]
        return cot, cot * self.near - edge
