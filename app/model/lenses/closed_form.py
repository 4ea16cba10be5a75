"""Lenses that see from an eye, between near and far: points go through them in closed form.

Eye first: what comes in are view coordinates, and the distance from the eye plane is kept apart
from what is divided by it. What differs between a `Central` and a `Parallel` lens is how the
picture grows with the distance, and how the depth does.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from app.arithmetic import double_double as dd
from app.arithmetic.double_double import DoubleDouble
from app.model.formula import FLOAT64
from app.model.lenses.lens import Lens, check_planes
from app.model.lenses.setup import ExactLens, Setup, Trace, Window
from app.model.limits import BEYOND, LARGEST, NO_POINT, Array, Vector, read_only
from app.model.object_transform import Placed
from app.model.refusal import Refusal
from app.model.tables import evaluated

FULL_FRAME_DIAGONAL_MM = math.hypot(36.0, 24.0)
COTS = ("cot(alpha)", "cot(beta)")
"""The letters of what leans."""

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

    def trace(self, setup: Setup, world: Array, rest: Array | None = None) -> Trace:
        flat = world.reshape(-1, 3)
        left_over = None if rest is None else rest.reshape(-1, 3)
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
            block = slice(start, start + _CHUNK)
            self._trace_block(
                setup,
                Trace._make(part[block] for part in traced),
                None if left_over is None else left_over[block],
            )
        shape = world.shape[:-1]
        return Trace._make(part.reshape(shape + part.shape[1:]) for part in traced)

    def _trace_block(self, setup: Setup, traced: Trace, cut_off: Array | None) -> None:
        """Fill in what follows from the world coordinates, row by row: so numpy is fast."""
        rows, rest = setup.view(traced.world, cut_off)
        x, y, z = rows
        distance = -z
        (x_clip, y_clip), w, (x_ndc, y_ndc) = self._pictured(setup, x, y, distance)
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
        beyond = traced.outside.T
        np.less(distance, self.near, out=beyond[0])
        np.greater(distance, self.far, out=beyond[1])
        np.greater(x_clip, w, out=beyond[3])
        np.greater(y_clip, w, out=beyond[5])
        minus_w = np.negative(w, out=w)  # in its place: nobody asks for w any more
        np.less(x_clip, minus_w, out=beyond[2])
        np.less(y_clip, minus_w, out=beyond[4])

    def _pictured(
        self, setup: Setup, x: Array, y: Array, distance: Array
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
            for axis, part in zip(setup.camera.frame_double_double, view, strict=True):
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

    def coordinates(self, setup: Setup, points: Placed) -> tuple[Sequence[DoubleDouble], Array]:
        size = np.abs(points.offset(setup.camera.eye).hi).sum(axis=0)
        view = setup.view_double_double(points.world, points.rest)
        return view, 3.0 * dd.RELATIVE_ERROR * size + points.lost + dd.UNDERFLOW

    def exact_coordinates(
        self, setup: Setup, point: Sequence[float | Fraction]
    ) -> tuple[Fraction, ...]:
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
