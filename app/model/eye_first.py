"""Project points through a lens with an eye plane, in closed form.

The eye is subtracted first. The formulas start from view coordinates; the division by the distance
from the eye plane comes last. `app.model.typed_cells` has the same methods for a typed matrix.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, cast

import numpy as np

from app.arithmetic import double_double as dd
from app.arithmetic.double_double import DoubleDouble
from app.model.chain import WorldPoints
from app.model.lenses.lens import EyeLens
from app.model.limits import BEYOND, LARGEST, Array, Vector
from app.model.pipeline import HalfSpaces, Pipeline, Trace, empty_trace
from app.model.refusal import REFUSALS, Refusal

_CHUNK = 16384  # larger blocks start a second OpenBLAS thread, which slows a software renderer
_LARGE_STRETCH = 2.0**24  # `Pipeline.stretch` up to which dot products of 75 bits suffice
_ABOVE_OFFSETS = 2.0**27  # adding and subtracting it leaves the upper 27 bits of the offsets


class EyeFirst:
    """Projects points through a `Central` or a `Parallel` lens."""

    frustum_sign = 1  # see `Projection.frustum_sign`

    def __init__(self, pipeline: Pipeline) -> None:
        self._of, self._lens = pipeline, cast(EyeLens, pipeline.lens)
        self._reverse = pipeline.depth == "reversed"

    # -- matrices

    @property
    def eye_from_clip(self) -> tuple[Array, ...]:
        """The inverse of `Pipeline.clip_from_eye` as factors, or a `Refusal` if there is none."""
        return self._of.view_rotation.T, self._of.view_from_clip

    @property
    def stated_in(self) -> tuple[Array, Array]:
        """Clip from the lens's own axes, and these axes from the eye, (4, 4) each."""
        return self._of.clip_from_view, self._of.view_rotation

    @property
    def least_w(self) -> float:
        """A lower bound of w in the view volume."""
        return float(self._lens.w(self._lens.near))

    @property
    def w_of_z(self) -> tuple[float, float]:
        """Factor and constant of w as a function of clip z; factor 0 after the divide."""
        (a, b), (c, d) = self._of.clip_from_view[2:, 2:]
        return c / a + 0.0, d - c * b / a

    # -- points in float64

    def view(self, world: Array, rest: Array | None = None) -> tuple[Array, Array]:
        """View coordinates (3, n) of points (n, 3), rounded once, and z's rounding error, (n,).

        `rest` is the rounding error of the points themselves.

        Ozaki, Ogita, Oishi, Rump, "Error-free transformations of matrix multiplication" (2012):
        offsets and frame are cut in two, so that the products and sums of the large parts are
        whole numbers of a unit, less than 2^53 of them: no order of summing rounds them. The rest
        has 2^-25 of the size, and its rounding 2^-75.
        """
        exact = WorldPoints(world, rest, np.zeros(0)).offset(self._of.camera.eye)
        if not self._of.stretch <= _LARGE_STRETCH:
            parts = self._view_double_double(exact)
            return np.stack([part.hi for part in parts]), parts[2].lo
        large, small = self._of.camera.frame_parts
        offset, left_over = exact
        unit = np.abs(offset)
        unit = unit[0] + unit[1] + unit[2]
        unit *= _ABOVE_OFFSETS
        high = offset + unit
        high -= unit
        whole = large @ high
        left_over += np.subtract(offset, high, out=high)
        left_over = large @ left_over
        left_over += small @ offset
        view = whole + left_over
        return view, left_over[2] - (view[2] - whole[2])

    def _view_double_double(self, offset: DoubleDouble) -> tuple[DoubleDouble, ...]:
        """View coordinates x, y, z of offsets from the eye, (3, n), with twice float64's digits.

        Their errors are below ``3 double_double.RELATIVE_ERROR`` of the distance from the eye.
        """
        offsets = [DoubleDouble(*parts) for parts in zip(*offset, strict=True)]
        products = (map(dd.multiply, axis, offsets) for axis in self._of.camera.frame_double_double)
        return tuple(dd.add(dd.add(x, y), z) for x, y, z in products)

    def trace(self, world: Array, rest: Array | None = None) -> Trace:
        """See `Projection.trace`; `rest` is the points' error of rounding to float64."""
        flat = world.reshape(-1, 3)
        left_over = None if rest is None else rest.reshape(-1, 3)
        traced = empty_trace(flat)
        for start in range(0, len(flat), _CHUNK):
            block = slice(start, start + _CHUNK)
            self._trace_block(
                Trace._make(part[block] for part in traced),
                None if left_over is None else left_over[block],
            )
        return Trace._make(part.reshape(world.shape[:-1] + part.shape[1:]) for part in traced)

    def _trace_block(self, traced: Trace, cut_off: Array | None) -> None:
        """Compute everything that follows from `world`, row by row, which is fast in numpy."""
        of, lens = self._of, self._lens
        rows, rest = self.view(traced.world, cut_off)
        x, y, z = rows
        distance = -z
        w = lens.w(distance)
        (x_clip, y_clip), (x_ndc, y_ndc) = lens.pictured(lambda: of.axes, of.aspect, x, y, distance)
        numerator, depth = lens.depth_over_w(distance, rest, reverse=self._reverse)
        opengl = of.depth == "opengl"
        z_clip = 2.0 * numerator - w if opengl else numerator
        z_ndc = 2.0 * depth - 1.0 if opengl else depth
        width, height = of.image_size
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
        for row in (right, down, z_ndc):  # pixels are finite only where NDC x and y are
            in_front &= np.isfinite(row)
        if not in_front.all():
            for array in (traced.ndc, traced.image, traced.depth):
                array[~in_front] = np.nan
        beyond = traced.outside.T
        np.less(distance, lens.near, out=beyond[0])
        np.greater(distance, lens.far, out=beyond[1])
        np.greater(x_clip, w, out=beyond[3])
        np.greater(y_clip, w, out=beyond[5])
        minus_w = np.negative(w)
        np.less(x_clip, minus_w, out=beyond[2])
        np.less(y_clip, minus_w, out=beyond[4])

    def view_of(self, offsets: Any) -> Any:
        """View coordinates of offsets from the eye, (3, n), in the offsets' precision."""
        return self._of.view_rotation.astype(offsets.dtype)[:3, :3] @ offsets

    def beyond(self, view: Any, clip: Any) -> tuple[Any, Any]:
        """Whether points, (3, n) and (4, n), lie before the near plane and beyond the far plane."""
        number, distance = view.dtype.type, -view[2]
        return distance < number(self._lens.near), distance > number(self._lens.far)

    def world_from_image(self, points: Array) -> Array:
        of, depth = self._of, points[..., 2]
        # The shares of the way from near and to far, without a difference that would lose digits.
        gone, left_over = (1.0 - depth, depth) if self._reverse else (depth, 1.0 - depth)
        with np.errstate(divide="ignore", over="ignore"):
            distance = self._lens.distance(gone, left_over)
        width, height = of.image_size
        x_axis, y_axis = of.axes
        x = x_axis.middle + x_axis.extent * ((points[..., 0] - width / 2.0) / width)
        y = y_axis.middle - y_axis.extent * ((points[..., 1] - height / 2.0) / height)
        with np.errstate(over="ignore", invalid="ignore"):
            x, y = self._lens.outwards(x, y, distance)
        nowhere = ~(np.abs(x) + np.abs(y) + np.abs(distance) < BEYOND)
        if nowhere.any():
            raise Refusal("depth", float(depth[nowhere][0]), REFUSALS["no-point"])
        # With twice the digits, so that a round trip stays within 1e-15 of w.
        view = [DoubleDouble(part, np.zeros_like(part)) for part in (x, y, -distance)]
        world = np.empty_like(points)
        for column, eye in enumerate(of.camera.eye):
            total = DoubleDouble(np.asarray(eye), np.zeros(()))
            for axis, part in zip(of.camera.frame_double_double, view, strict=True):
                total = dd.add(total, dd.multiply(axis[column], part))
            world[..., column] = total.hi
        return world

    # -- points in other arithmetics

    def coordinates(self, points: WorldPoints, one: int) -> tuple[Sequence[DoubleDouble], Array]:
        """The arguments of `clipped` for points (n, 3), with twice the digits, and their errors.

        `one` is w: 0 for directions, from which the eye is not subtracted.
        """
        offset = points.offset(one * np.array(self._of.camera.eye))
        size = np.abs(offset.hi).sum(axis=0)
        error = 3.0 * dd.RELATIVE_ERROR * size + points.lost + dd.UNDERFLOW
        return self._view_double_double(offset), error

    def exact_coordinates(self, point: Sequence[Any], one: int) -> tuple[Any, ...]:
        """The arguments of `clipped` in exact numbers, for the same in the world."""
        pairs = zip(point, self._of.camera.eye, strict=True)
        return self._of.camera.exact_along([part - Fraction(eye) * one for part, eye in pairs])

    def clipped(self, x: Any, y: Any, z: Any, weight: int = 1) -> list[Any]:
        """View and clip coordinates, and the signed distances inside `PLANES`, 3 + 4 + 6.

        The result is in the arithmetic of the arguments, `coordinates` or `exact_coordinates`.
        `weight` is w: 0 for directions.
        """
        n, distance = self._of.exact_lens, -z
        one = distance * 0 + weight
        from_near = distance - n.near * weight
        to_far = one if n.far is None else -distance + n.far * weight
        if self._lens.central:
            w = distance
            x_clip, y_clip = (
                value * scale + w * shift
                for value, scale, shift in zip((x, y), n.scale, n.shift, strict=True)
            )
        else:
            w = one
            x_clip, y_clip = (
                (value - from_near * cot) * scale + shift * weight
                for value, cot, scale, shift in zip((x, y), n.shear, n.scale, n.shift, strict=True)
            )
        if n.far is None:
            numerator = one * n.near if self._reverse else from_near
        else:
            scale = self._lens.depth_scale(n.near, n.far, reverse=self._reverse)
            numerator = (to_far if self._reverse else from_near) * scale
        z_clip = numerator * 2 - w if self._of.depth == "opengl" else numerator
        inside = from_near, to_far, x_clip + w, -x_clip + w, y_clip + w, -y_clip + w
        return [x, y, -distance, x_clip, y_clip, z_clip, w, *inside]

    # -- error bounds

    @property
    def view_error(self) -> float:
        """Error of `trace`'s view coordinates before their final rounding.

        Relative to the sum of the sizes of the offset from the eye; z includes its rounding error.
        """
        return 2.0**-74 if self._of.stretch <= _LARGE_STRETCH else 2.0**-96

    @property
    def depth_terms(self) -> tuple[Array, Array]:
        """The row of depth times w in the axes of `stated_in`, and its terms' sizes, (4,) each."""
        lens, reverse, near, far = self._lens, self._reverse, self._lens.near, self._lens.far
        if far == np.inf:
            row = (0.0, near) if reverse else (-1.0, -near)
        else:
            per_unit = lens.depth_scale(near, far, reverse=reverse) * (1.0 if reverse else -1.0)
            row = per_unit, per_unit * (far if reverse else near)
        # A difference of distances, rounded once: its error is relative to itself.
        return np.array((0.0, 0.0, *row)), np.zeros(4)

    # -- lines, and what is drawn

    def line(
        self, pixel: tuple[float, float] | None, point: Vector | None, at: Array
    ) -> Array | None:
        """Points (k, 3) on the projector of a pixel or of a world point; None if there is none.

        `at` are distances from the eye plane, (k,).
        """
        of, frame, eye = self._of, self._of.camera.frame, np.array(self._of.camera.eye)
        if point is not None and self._lens.central:
            offset = np.array(point) - eye
            away = -float(frame[2] @ offset)
            if away <= 0.0:
                return None
            with np.errstate(over="ignore", invalid="ignore"):
                line = eye + at[:, None] * (offset / away)
            return line if np.isfinite(line).all() else None  # beside the eye
        # Where (x w - x_px w) = (y w - y_px w) = 0 at the distance -n (q - e): three equations.
        rows = of.image_from_ndc @ of.clip_from_view @ of.view_rotation
        if pixel is None:
            x, y, _, w = rows[:, :3] @ (np.array(point) - eye) + rows[:, 3]
            pixel = x / w, y / w
        across, down = (row - at_px * rows[3] for row, at_px in zip(rows[:2], pixel, strict=True))
        system = np.array([across[:3], down[:3], -frame[2]])
        fixed = np.full(len(at), -across[3]), np.full(len(at), -down[3]), at
        return np.asarray(eye + np.linalg.solve(system, np.array(fixed)).T)

    def dragged(
        self, trace: Trace, shift_px: tuple[float, float], *, along_ray: bool
    ) -> Array | None:
        """The point whose picture was dragged there; see `app.picking.picking.dragged`."""
        (x_px, y_px), (right_px, down_px) = trace.image.tolist(), shift_px
        distance = -float(trace.view[2])
        if along_ray:
            _, _, bottom, top = self._of.window
            distance = self._lens.nearer_by(distance, top - bottom, down_px, self._of.image_size[1])
            if not -LARGEST < distance < LARGEST:
                return None
            line = self.line(None, tuple(trace.world.tolist()), np.array([distance]))
        else:
            line = self.line((x_px + right_px, y_px + down_px), None, np.array([distance]))
        return None if line is None else line[0]

    @property
    def order(self) -> tuple[Array, Array]:
        """The depth order of points and the limits of the depth, in the axes of `stated_in`.

        The order, (4,), gives a number times w that is smaller in front. The limits, (k, 4), are
        half-spaces between near and far: ``limit . (x, y, z, 1) >= 0`` inside.
        """
        # The depth loses digits far away, so use -1/w, or the distance. If the row c z + d makes w,
        # (-d z + c)/(c z + d) only decreases with z.
        c, d = self._of.clip_from_view[3, 2:]
        limits = [(0.0, 0.0, -1.0, -self._lens.near)]
        if self._lens.far != np.inf:
            limits.append((0.0, 0.0, 1.0, self._lens.far))
        return np.array((0.0, 0.0, 0.0 - d, c)), np.array(limits)

    def half_spaces(self, least_w: float) -> HalfSpaces:
        """Half-spaces of OpenGL's clip space: between near and far, and w positive."""
        if not self._lens.central:
            return [((0.0, 0.0, 1.0, 0.0), 1.0), ((0.0, 0.0, -1.0, 0.0), 1.0)]
        # Compare w itself: if far/near is large, z and w have too few digits left.
        planes: HalfSpaces = [((0.0, 0.0, 0.0, 1.0), -self._lens.near)]
        if self._lens.far != np.inf:
            planes.append(((0.0, 0.0, 0.0, -1.0), self._lens.far))
        return planes

    def nearer(self, share: float, length: float, least: float) -> tuple[float, float]:
        """Change of clip z when things come nearer: a constant, and a factor of w.

        The change is a `share` of the distance, a `length` if the lens has no eye, and the `least`
        part of the depth range for a typed matrix.
        """
        a, b = self._of.clip_from_view[2, 2:]
        # z_clip = a z + b with -z = w, so that b / (1 - share) for b is the depth at w (1 - share).
        return (b * share if self._lens.central else a * length), 0.0
