"""Project points through a typed matrix: apply its cells after subtracting the eye."""

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from app.arithmetic.double_double import DoubleDouble
from app.model.chain import WorldPoints
from app.model.limits import BEYOND, LARGEST, Array, Vector
from app.model.pipeline import HalfSpaces, Pipeline, Trace, checked_pixels, checked_points
from app.model.refusal import REFUSALS, Refusal
from app.model.tables import rounded

RAY_REACH = 10.0  # length of a drawn ray to infinity, in units of the target's distance


class TypedCells:
    """Projects points through a `FreeMatrix`; `EyeFirst` documents the methods."""

    view_error = 0.0
    w_of_z = 0.0, 1.0

    def __init__(self, pipeline: Pipeline) -> None:
        self._of = pipeline

    # -- matrices

    @property
    def eye_from_clip(self) -> tuple[Array, ...]:
        return (rounded(self._of.eye_from_clip),)

    @property
    def stated_in(self) -> tuple[Array, Array]:
        return self._of.clip_from_eye, np.eye(4)

    @property
    def frustum_sign(self) -> int:
        try:
            x, y, z, w = self._of.eye_from_clip[3]
        except Refusal:
            return 0
        ends = [w + z * Fraction(z_ndc) for z_ndc in self._of.depth_range]
        reach = abs(x) + abs(y)
        return (min(ends) > reach) - (max(ends) < -reach)

    @property
    def least_w(self) -> float:
        if self.frustum_sign <= 0:
            return 0.0
        # Un-projected, the cube's corner (x, y, z, 1) has the inverse of the point's own w.
        x, y, z, w = self._of.eye_from_clip[3]
        most = max(w + z * Fraction(z_ndc) for z_ndc in self._of.depth_range) + abs(x) + abs(y)
        return float(1 / most)

    # -- points

    def trace(self, world: Array, rest: Array | None = None) -> Trace:
        of, clip_from_eye = self._of, self._of.clip_from_eye
        offsets = world - of.camera.eye
        if rest is not None:
            offsets += rest
        view_from_eye = rounded(of.exact_from_eye[0])
        view = offsets @ view_from_eye[:3, :3].T + view_from_eye[:3, 3]
        if tuple(view_from_eye[3]) != (0.0, 0.0, 0.0, 1.0):
            view /= (offsets @ view_from_eye[3, :3] + view_from_eye[3, 3])[..., None]
            view[~np.isfinite(view).all(axis=-1)] = np.nan
        clip = offsets @ clip_from_eye[:, :3].T + clip_from_eye[:, 3]
        x, y, _, w = np.moveaxis(clip, -1, 0)
        ndc = clip[..., :3] / w[..., None]
        width, height = of.image_size
        image = np.stack(
            [(ndc[..., 0] + 1.0) * (width / 2.0), (1.0 - ndc[..., 1]) * (height / 2.0)], axis=-1
        )
        depth = np.asarray((ndc[..., 2] + 1.0) / 2.0 if of.depth == "opengl" else ndc[..., 2])
        in_front = (w > 0.0) & np.isfinite(ndc).all(axis=-1) & np.isfinite(image).all(axis=-1)
        for array in (ndc, image, depth):
            array[~in_front] = np.nan
        sides = [x < -w, x > w, y < -w, y > w]
        outside = np.stack([*self.beyond(view, np.moveaxis(clip, -1, 0)), *sides], axis=-1)
        return Trace(world, view, clip, ndc, image, depth, in_front, outside)

    def view_of(self, offsets: Any) -> Any:
        matrix = rounded(self._of.exact_from_eye[0]).astype(offsets.dtype)
        view = matrix[:, :3] @ offsets + matrix[:, 3:]
        return view[:3] / view[3]

    def beyond(self, view: Any, clip: Any) -> tuple[Any, Any]:
        _, _, z, w = clip
        z_near, z_far = self._of.depth_range
        sign = math.copysign(1.0, z_far - z_near)
        return sign * z < sign * z_near * w, sign * z > sign * z_far * w

    def world_from_image(self, points: Array) -> Array:
        z_near, z_far = self._of.depth_range
        low, high = min(z_near, z_far), max(z_near, z_far)
        width, height = self._of.image_size
        ndc = np.stack(
            [
                2.0 * (points[..., 0] / width) - 1.0,
                1.0 - 2.0 * (points[..., 1] / height),
                low + (high - low) * points[..., 2],
                np.ones(points.shape[:-1]),
            ],
            axis=-1,
        )
        offsets = ndc @ rounded(self._of.eye_from_clip).T
        with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
            world = offsets[..., :3] / offsets[..., 3:] + self._of.camera.eye
        nowhere = ~(np.abs(world).max(axis=-1) < BEYOND)
        if nowhere.any():
            raise Refusal("depth", float(points[..., 2][nowhere][0]), REFUSALS["no-point"])
        return np.asarray(world)

    def coordinates(self, points: WorldPoints, one: int) -> tuple[Sequence[DoubleDouble], Array]:
        offset = points.offset(one * np.array(self._of.camera.eye))
        return [DoubleDouble(*parts) for parts in zip(*offset, strict=True)], points.lost

    def exact_coordinates(self, point: Sequence[Any], one: int) -> tuple[Any, ...]:
        pairs = zip(point, self._of.camera.eye, strict=True)
        return tuple(part - Fraction(eye) * one for part, eye in pairs)

    def clipped(self, x: Any, y: Any, z: Any, weight: int = 1) -> list[Any]:
        view, clip = (
            [x * row[0] + y * row[1] + z * row[2] + row[3] * weight for row in matrix]
            for matrix in self._of.exact_from_eye
        )
        if self._of.exact_from_eye[0][3] != [0, 0, 0, 1]:
            view = [part / view[3] for part in view]
        x_clip, y_clip, z_clip, w = clip
        z_near, z_far = map(int, self._of.depth_range)
        sign = 1 if z_far > z_near else -1
        from_near, to_far = (z_clip - w * z_near) * sign, (w * z_far - z_clip) * sign
        inside = (from_near, to_far, x_clip + w, w - x_clip, y_clip + w, w - y_clip)
        return [*view[:3], *clip, *inside]

    @property
    def depth_terms(self) -> tuple[Array, Array]:
        row, clip = self._of.image_from_ndc[2, 2:], self._of.clip_from_eye
        return row @ clip[2:], row @ np.abs(clip)[2:]

    # -- lines, and what is drawn

    def line(
        self, pixel: tuple[float, float] | None, point: Vector | None, at: Array
    ) -> Array | None:
        """As `EyeFirst.line`, but `at` are shares of the way from near to far."""
        if pixel is None:
            with np.errstate(all="ignore"):
                trace = self.trace(checked_points(point or ()))
            if not trace.in_front:
                return None
            pixel = float(trace.image[0]), float(trace.image[1])
        ends = np.array(
            [self._of.image_from_ndc @ (0.0, 0.0, z, 1.0) for z in self._of.depth_range]
        )
        ends[:, :2] = pixel
        if not self.frustum_sign:
            return self._line_in_front(ends, at)
        try:
            start, end = self.world_from_image(checked_pixels(ends[:, :3]))
        except Refusal:  # a pixel beside the picture may meet infinity
            return None
        return np.asarray(start + at[:, None] * (end - start))

    def _line_in_front(self, ends: Array, shares: Array) -> Array | None:
        """The part of a line in front of the eye plane, if it may reach infinity.

        An un-projected point has the inverse of its own w, which is 0 where the line passes
        infinity; the other coordinates give the direction there.
        """
        try:
            (unprojected,) = self.eye_from_clip
        except Refusal:  # no inverse
            return None
        ndc = np.linalg.solve(self._of.image_from_ndc, ends.T)
        near, far = (unprojected @ ndc).T
        if near[3] <= 0.0:
            near, far = far, near
        if near[3] <= 0.0:
            return None
        start = near[:3] / near[3]
        if far[3] > 0.0:
            along = far[:3] / far[3] - start
        else:
            along = near[:3] * -far[3] + far[:3] * near[3]
            along *= RAY_REACH * self._of.camera.distance / np.linalg.norm(along)
        line: Array = self._of.camera.eye + start + shares[:, None] * along
        return line if np.abs(line).max() <= LARGEST else None

    def dragged(
        self, trace: Trace, shift_px: tuple[float, float], *, along_ray: bool
    ) -> Array | None:
        (x_px, y_px), depth, (right_px, down_px) = trace.image, float(trace.depth), shift_px
        if along_ray:
            away = -1.0 if self._of.depth == "reversed" else 1.0
            depth -= away * down_px / self._of.image_size[1]
        else:
            x_px, y_px = x_px + right_px, y_px + down_px
        try:
            return self.world_from_image(checked_pixels((x_px, y_px, depth)))
        except Refusal:  # no inverse, beyond the depth range, or at infinity
            return None

    @property
    def order(self) -> tuple[Array, Array]:
        clip = self._of.clip_from_eye
        z_near, z_far = self._of.depth_range
        sign = math.copysign(1.0, z_far - z_near)
        planes = np.array([clip[2] - z_near * clip[3], z_far * clip[3] - clip[2]])
        return sign * (self._of.image_from_ndc @ clip)[2], sign * planes

    def half_spaces(self, least_w: float) -> HalfSpaces:
        depth = ((0.0, 0.0, 1.0, 1.0), 0.0), ((0.0, 0.0, -1.0, 1.0), 0.0)
        return [*depth, ((0.0, 0.0, 0.0, 1.0), -least_w)]

    def nearer(self, share: float, length: float, least: float) -> tuple[float, float]:
        return 0.0, -least  # a typed matrix has no eye: the same step of depth for all points
