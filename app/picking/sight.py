"""How a pane looks at the world, and where the ray of a pixel meets planes and lines there.

Whatever a pane does to the scene, a world point becomes a pixel by one projective 4x4 and a divide.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from app.model.projection import Array, Projection, Vector


def heading(along: ArrayLike, point: Array) -> Array:
    """The way (3,) of a point on a rail ``(start + t along) / (1 + t w)``; w is a fourth part."""
    way, w = np.split(np.asarray(along), [3])
    return np.asarray(way - w.sum() * point)


class Sight(NamedTuple):
    """How a pane looks at the world.

    - `eye` (3,): world point that is subtracted first, so that no digits are lost far from the
      origin.
    - `rows` (4, 4): applied to ``(p - eye, 1)`` they give x w and y w in pixels from the pane's top
      left, order times w, and w. The order is smaller in front.
    - `limits` (k, 4): half-spaces ``limit @ (p - eye, 1) >= 0`` that bound the drawing.
    """

    eye: Array
    rows: Array
    limits: Array

    @classmethod
    def of(cls, projection: Projection) -> "Sight":
        """The sight of the image itself, between near and far."""
        clip, axes = projection.passage.stated_in
        rows = projection.image_from_ndc @ clip
        rows[2], limits = projection.passage.order
        return cls(np.array(projection.camera.eye), rows @ axes, limits @ axes)

    def scaled(self, pixels_from_pixels: ArrayLike) -> "Sight":
        """The sight in other pixels, by an affine (3, 3) matrix of x, y, 1."""
        rows = self.rows.copy()
        rows[[0, 1, 3]] = np.asarray(pixels_from_pixels) @ self.rows[[0, 1, 3]]
        return self._replace(rows=rows)

    def of_object(self, projection: Projection, origin: Vector) -> "Sight":
        """The same sight, for points of the object: ``rows (p - origin, 1)``."""
        if projection.placement.is_identity:
            return self
        local = projection.placement.local_from(origin, tuple(self.eye.tolist()))
        return Sight(np.array(origin), self.rows @ local, self.limits @ local)

    def seen(self, points_world: ArrayLike) -> Array:
        """Pixels (n, 2) of points; NaN at or behind the eye plane."""
        offsets = np.asarray(points_world, dtype=np.float64) - self.eye
        x, y, _, w = self.rows[:, :3] @ offsets.T + self.rows[:, 3:]
        w = np.where(w > 0.0, w, np.nan)
        return np.stack([x / w, y / w], axis=1)

    def seen_at_infinity(self, direction: Vector) -> Array:
        """Pixel (2,) of a point at infinity; NaN if it has no image."""
        x, y, _, w = self.rows[:, :3] @ direction
        return np.array([x / w, y / w]) if w > 0.0 else np.full(2, np.nan)

    # -- the ray of a pixel

    def meets(self, pixel: tuple[float, float], normal: Array, point: Array) -> Array:
        """Point (3,) where the ray of a pixel meets a plane; NaN if it does not."""
        x, y, _, w = self.rows
        across, down = x - pixel[0] * w, y - pixel[1] * w
        system = np.stack([across[:3], down[:3], normal])
        known = np.array([-across[3], -down[3], normal @ (point - self.eye)])
        try:
            offset = np.linalg.solve(system, known)
        except np.linalg.LinAlgError:  # the pane sees the plane edge-on
            return np.full(3, np.nan)
        met: Array = self.eye + offset
        return met if w[:3] @ offset + w[3] > 0.0 else np.full(3, np.nan)

    def per_px(self, point: Array, along: Array) -> float:
        """Distance along a direction that moves a point by one pixel; infinite if it stays."""
        one, _, way = self._line(point, along)
        length = math.hypot(*way)
        return float(one[2]) ** 2 / length if length > 0.0 else math.inf

    def way_px(self, point: Array, along: Array) -> tuple[float, float]:
        """The direction on the screen in which a point goes: right and down, of any length."""
        return self._line(point, along)[2]

    def slide(self, start: Array, along: Array, pixel: tuple[float, float]) -> tuple[float, float]:
        """t of the point ``start + t along`` whose image is nearest, and its change per pixel.

        t is infinite if the pixel is at the line's vanishing point or beyond it, and NaN for a line
        that is seen end-on; then the change is infinite.
        """
        one, two, way = self._line(start, along)
        length = math.hypot(*way)
        if not length > 0.0:
            return math.nan, math.inf
        (x0, y0, w0), (x1, y1, w1) = one.tolist(), two.tolist()
        right, down = way[0] / length, way[1] / length
        # Intersect the line with its perpendicular through the pixel.
        offset = right * pixel[0] + down * pixel[1]
        slope = right * x1 + down * y1 - offset * w1
        t = -(right * x0 + down * y0 - offset * w0) / slope if slope else math.inf
        w = w0 + t * w1
        if not w > 0.0 or math.isinf(t):
            return math.copysign(math.inf, w1), math.inf
        return t, w * w / length

    def _line(self, start: Array, along: Array) -> tuple[Array, Array, tuple[float, float]]:
        """The image of a line ``start + t along``; with a fourth part, that part of t divides it.

        Both as homogeneous pixels (3,), and the pixel's derivative by t, times w squared.
        """
        rows = self.rows[[0, 1, 3]]
        one, two = rows[:, :3] @ (start - self.eye) + rows[:, 3], rows[:, :3] @ along[:3]
        two = two + along[3:].sum() * (rows[:, 3] - rows[:, :3] @ self.eye)
        return one, two, (two[0] * one[2] - one[0] * two[2], two[1] * one[2] - one[1] * two[2])
