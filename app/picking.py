"""What is under a pixel, in float64 and without a GPU: a vertex, or a point of the surface.

Whatever a pane does to the scene, from a world point p to a pixel it is one projective 4x4 and a
divide (a `Sight`). Nothing is divided until it is known to be in front: that a triangle holds the
pixel is told by its homogeneous corners (Olano and Greer, Triangle Scan Conversion using 2D
Homogeneous Coordinates, 1997), so that one that crosses the eye plane needs no clipping, and the
same three numbers are the hit's barycentric coordinates in the world.

The triangles are sorted into cells of a grid once per scene. Each pick asks a handful of linear
functions for every cell's box, and only the triangles of the cells that may hold the pixel are
looked at.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.projection import LARGEST, Array, FreeMatrix, Projection, ProjectionError, Vector

VERTEX_WITHIN_PX = 6.0
"""A vertex that is seen so close to the pixel is what was meant, not the face beside it."""

_CELLS = 32  # along each axis at most: their numbers fit 16 bits, which numpy sorts by radix
_PER_CELL = 100.0  # triangles, about, of a surface that fills the cells along a plane
_TRIED = 16  # vertices: where more are hidden, the mesh is denser than the pixels
_LOOKED_AT = 8_000  # triangles; where more are within the margin, a smaller one has vertices enough
_LEAST_PX = 0.02  # margin
_SAME_DEPTH = 1e-9  # relative: faces that meet in a vertex do not hide it


class Sight(NamedTuple):
    """How a pane looks at the world.

    Attributes
    ----------
    eye : (3,) array
        World point that is subtracted first, so that nothing is lost far from the origin.
    rows : (4, 4) array
        Of ``(p - eye, 1)``: x w and y w in pixels from the pane's top left, an order that is
        smaller for what is in front, times w, and w.
    limits : (k, 4) array
        Half-spaces ``limit @ (p - eye, 1) >= 0`` outside of which nothing is drawn.
    """

    eye: Array
    rows: Array
    limits: Array

    @classmethod
    def of(cls, projection: Projection) -> Sight:
        """The model's own: pixels of the image, between near and far."""
        camera, lens = projection.camera, projection.lens
        if isinstance(lens, FreeMatrix):  # the planes and the order are those of the cube
            clip = projection.clip_from_eye
            z_near, z_far = projection.depth_range
            sign = math.copysign(1.0, z_far - z_near)
            rows = projection.image_from_ndc @ clip
            rows[2] *= sign
            planes = np.array([clip[2] - z_near * clip[3], z_far * clip[3] - clip[2]])
            return cls(np.array(camera.eye), rows, sign * planes)
        rows = projection.image_from_ndc @ projection.clip_from_view
        # Their order without the digits that the depth loses far away: -1/w, or the distance.
        rows[2] = (0.0, 0.0, -1.0, 0.0) if lens.parallel else (0.0, 0.0, 0.0, -1.0)
        limits = [(0.0, 0.0, -1.0, -lens.near)]
        if lens.far != np.inf:
            limits.append((0.0, 0.0, 1.0, lens.far))
        rotation = projection.view_rotation
        return cls(np.array(camera.eye), rows @ rotation, np.array(limits) @ rotation)

    def scaled(self, pixels_from_pixels: ArrayLike) -> Sight:
        """Seen in other pixels, by an affine (3, 3) matrix of x, y, 1."""
        rows = self.rows.copy()
        rows[[0, 1, 3]] = np.asarray(pixels_from_pixels) @ self.rows[[0, 1, 3]]
        return self._replace(rows=rows)

    def seen(self, points_world: ArrayLike) -> Array:
        """Pixels x, y of points, (n, 2); NaN for those at or behind the eye plane."""
        offsets = np.asarray(points_world, dtype=np.float64) - self.eye
        x, y, _, w = self.rows[:, :3] @ offsets.T + self.rows[:, 3:]
        w = np.where(w > 0.0, w, np.nan)
        return np.stack([x / w, y / w], axis=1)


class Hit(NamedTuple):
    """What was found.

    Attributes
    ----------
    point : Vector
        World coordinates.
    vertex : int or None
        Which point of the surface it is, if it is one.
    """

    point: Vector
    vertex: int | None


@dataclass(frozen=True)
class Probe:
    """A point that is followed through every stage, or the ray of a pixel.

    Parameters
    ----------
    number : int
        By which it is marked in the panes.
    point : Vector, optional
        World coordinates.
    pixel : (float, float), optional
        The image's pixel whose ray it is, if it is no point.
    """

    number: int
    point: Vector | None = None
    pixel: tuple[float, float] | None = None


def projector(projection: Projection, probe: Probe, distances: ArrayLike) -> Array | None:
    """Points of the line along which a probe is projected.

    Parameters
    ----------
    projection : Projection
    probe : Probe
    distances : (k,) array_like
        From the eye plane, along the line of sight.

    Returns
    -------
    (k, 3) array or None
        World coordinates; None for a point that has no picture, being at or behind the eye plane.

    Notes
    -----
    The points q of a pixel's ray are where ``(x w - x_px w) = (y w - y_px w) = 0`` at the distance
    ``-n (q - e)``: three linear equations for any lens. A free matrix has no eye: its line is that
    of the cube between near and far, un-projected, and `distances` are shares of the way; None
    without an inverse.
    """
    camera = projection.camera
    if isinstance(projection.lens, FreeMatrix):
        return _line_of_cube(projection, probe, distances)
    depths = np.asarray(distances, dtype=np.float64)
    eye = np.array(camera.eye)
    if probe.point is not None and not projection.lens.parallel:
        offset = np.array(probe.point) - eye
        away = -float(camera.frame[2] @ offset)
        return eye + depths[:, None] * (offset / away) if away > 0.0 else None
    sight = Sight.of(projection)
    x_px, y_px = probe.pixel or sight.seen(np.array([probe.point]))[0]
    x, y, _, w = sight.rows
    across, down = x - x_px * w, y - y_px * w
    system = np.array([across[:3], down[:3], -camera.frame[2]])
    fixed = np.full(len(depths), -across[3]), np.full(len(depths), -down[3]), depths
    points: Array = eye + np.linalg.solve(system, np.array(fixed)).T
    return points


def _line_of_cube(projection: Projection, probe: Probe, shares: ArrayLike) -> Array | None:
    """From 0 on the near face to 1 on the far one, on the line that a probe has in the cube."""
    if not projection.frustum_sign:
        return None
    pixel = probe.pixel
    if pixel is None:
        trace = projection.trace(probe.point or ())
        if not trace.in_front:
            return None
        pixel = float(trace.image[0]), float(trace.image[1])
    z_near, z_far = projection.depth_range
    ends = np.array([projection.image_from_ndc @ (0.0, 0.0, z, 1.0) for z in (z_near, z_far)])
    ends[:, :2] = pixel
    try:
        start, end = projection.world_from_image(ends[:, :3])
    except ProjectionError:  # a pixel beside the picture may meet infinity
        return None
    line: Array = start + np.asarray(shares, dtype=np.float64)[:, None] * (end - start)
    return line


def dragged(
    projection: Projection, point: Vector, shift_px: tuple[float, float], *, along_ray: bool
) -> Vector | None:
    """Where a point goes when its picture is dragged.

    Parameters
    ----------
    projection : Projection
    point : Vector
        World coordinates.
    shift_px : (float, float)
        Right and down, in the image's pixels.
    along_ray : bool
        Leave the picture where it is and move the point away (up) or nearer (down): by as much as
        a pixel is wide for a parallel lens, in proportion to the distance for the others, so that
        it never reaches the eye. Otherwise it stays in its plane parallel to the image.

    Returns
    -------
    Vector or None
        None for a point without a picture, and for one that would be too far away for one.

    Notes
    -----
    Under a free matrix a point keeps its depth in the buffer instead of its plane, and moves along
    its ray by shares of the depth range.
    """
    trace = projection.trace(point)
    if not trace.in_front:
        return None
    right_px, down_px = shift_px
    if isinstance(projection.lens, FreeMatrix):
        x_px, y_px, depth = float(trace.image[0]), float(trace.image[1]), float(trace.depth)
        if along_ray:
            away = -1.0 if projection.depth == "reversed" else 1.0
            depth -= away * down_px / projection.image_size[1]
        else:
            x_px, y_px = x_px + right_px, y_px + down_px
        try:
            return _vector(projection.world_from_image((x_px, y_px, depth)))
        except ProjectionError:  # no inverse, beyond the depth range, or at infinity
            return None
    distance = -float(trace.view[2])
    held = Probe(0, point)
    if not along_ray:
        x_px, y_px = trace.image.tolist()
        held = Probe(0, pixel=(x_px + right_px, y_px + down_px))
    elif projection.lens.parallel:
        _, _, bottom, top = projection.window
        distance -= (top - bottom) * down_px / projection.image_size[1]
    else:
        with np.errstate(over="ignore", under="ignore"):
            distance *= float(np.exp2(-4.0 * down_px / projection.image_size[1]))
        if not 0.0 < distance < LARGEST:
            return None
    line = projector(projection, held, [distance])
    return None if line is None or not np.abs(line).max() <= LARGEST else _vector(line[0])


class Surface:
    """Triangles in the order in which they can be found.

    Parameters
    ----------
    points : (n, 3) array
        Relative to `origin`; not copied.
    triangles : (m, 3) int array
        Indices of the corners.
    origin : Vector
        World point that the points are relative to.
    """

    def __init__(
        self, points: NDArray[Any], triangles: NDArray[Any], origin: Vector = (0.0, 0.0, 0.0)
    ) -> None:
        self._points = points
        self._origin = np.array(origin, dtype=np.float64)
        low, high = np.zeros(3), np.zeros(3)
        if len(points):
            low, high = (
                side.astype(np.float64) for side in (points.min(axis=0), points.max(axis=0))
            )
        cells = int(np.clip(np.sqrt(len(triangles) / _PER_CELL), 1, _CELLS))
        scale = cells * 0.999 / np.maximum(high - low, np.finfo(np.float32).tiny)
        first = ((points - low) * scale).astype(np.uint16)
        numbers = (first[:, 0] * cells + first[:, 1]) * cells + first[:, 2]
        of_triangle = numbers[triangles[:, 0]]
        order = np.argsort(of_triangle, kind="stable")
        self._triangles = triangles.astype(np.int32)[order]
        a, b, c = self._triangles.T.copy()
        self._starts = np.flatnonzero(np.diff(of_triangle[order], prepend=-1))
        self._ends = np.append(self._starts[1:], len(triangles))
        lowest, highest = np.empty((2, len(self._starts), 3))
        if len(self._starts):
            for axis in range(3):
                part = points[:, axis].copy()
                corners = part[a], part[b], part[c]
                least = np.minimum(np.minimum(corners[0], corners[1]), corners[2])
                most = np.maximum(np.maximum(corners[0], corners[1]), corners[2])
                lowest[:, axis] = np.minimum.reduceat(least, self._starts)
                highest[:, axis] = np.maximum.reduceat(most, self._starts)
        self._middles, self._halves = (lowest + highest) / 2.0, (highest - lowest) / 2.0

    def pick(
        self, sight: Sight, pixel: tuple[float, float], vertex_px: float = VERTEX_WITHIN_PX
    ) -> Hit | None:
        """What is seen at a pixel.

        Parameters
        ----------
        sight : Sight
        pixel : (float, float)
        vertex_px : float
            A vertex that is not hidden and within this distance comes before the surface.

        Returns
        -------
        Hit or None
            None where neither is under the pixel.
        """
        offset = self._origin - sight.eye
        vertex_px, triangles = self._near(sight, pixel, vertex_px)
        if not len(triangles):
            return None
        corners = self._points[triangles].astype(np.float64) + offset
        seen = corners @ sight.rows[:, :3].T + sight.rows[:, 3]
        vertex = self._vertex(sight, pixel, vertex_px, triangles, corners, seen)
        if vertex is not None:
            return Hit(_vector(self._points[vertex] + self._origin), vertex)
        found = _cast(sight, pixel, corners, seen)
        if found is None:
            return None
        # Not by way of the eye, which may be far away: from the corners.
        which, weights, _ = found
        point = weights @ self._points[triangles[which]].astype(np.float64)
        return Hit(_vector(point + self._origin), None)

    def _near(
        self, sight: Sight, pixel: tuple[float, float], margin_px: float
    ) -> tuple[float, NDArray[Any]]:
        """The triangles that may be within a margin of the pixel, (k, 3), and that margin."""
        offset = self._origin - sight.eye
        middles = self._middles + offset
        while True:
            tests = _tests(sight, pixel, margin_px)
            normals = tests[:, :3].T
            most = middles @ normals + tests[:, 3] + self._halves @ np.abs(normals)
            cells = np.flatnonzero((most >= 0.0).all(axis=1))
            starts, ends = self._starts[cells], self._ends[cells]
            if int((ends - starts).sum()) <= _LOOKED_AT or margin_px <= _LEAST_PX:
                break
            margin_px /= 4.0
        if not len(cells):
            return margin_px, self._triangles[:0]
        triangles = np.concatenate(
            [self._triangles[start:end] for start, end in zip(starts, ends, strict=True)]
        )
        values = (self._points[triangles] + offset) @ normals + tests[:, 3]
        return margin_px, triangles[(values.max(axis=1) >= 0.0).all(axis=1)]

    def _vertex(
        self,
        sight: Sight,
        pixel: tuple[float, float],
        within_px: float,
        triangles: NDArray[Any],
        corners: Array,
        seen: Array,
    ) -> int | None:
        """The nearest vertex that no face hides."""
        numbers, at = np.unique(triangles, return_index=True)
        x, y, order, w = seen.reshape(-1, 4)[at].T
        drawn = corners.reshape(-1, 3)[at] @ sight.limits[:, :3].T + sight.limits[:, 3]
        with np.errstate(divide="ignore", invalid="ignore"):
            x, y, order = x / w, y / w, order / w
        away = np.hypot(x - pixel[0], y - pixel[1])
        usable = np.flatnonzero((w > 0.0) & (drawn >= 0.0).all(axis=1) & (away <= within_px))
        for i in usable[np.argsort(away[usable], kind="stable")][:_TRIED]:
            found = _cast(sight, (x[i], y[i]), corners, seen)
            if found is None or order[i] <= found[2] + _SAME_DEPTH * abs(found[2]):
                return int(numbers[i])
        return None


def _tests(sight: Sight, pixel: tuple[float, float], margin_px: float) -> Array:
    """Functions of ``(p - eye, 1)``, (k, 4), that are at least 0 for what is drawn at a pixel.

    They are linear: where one is negative at all corners of a box or a triangle, it is so inside,
    whether or not the eye plane runs through it.
    """
    x, y, _, w = sight.rows
    (left, top), (right, bottom) = (
        (pixel[0] + sign * margin_px, pixel[1] + sign * margin_px) for sign in (-1.0, 1.0)
    )
    sides = np.array([x - left * w, right * w - x, y - top * w, bottom * w - y, w])
    return np.concatenate([sides, sight.limits])


def _cast(
    sight: Sight, pixel: tuple[float, float], corners: Array, seen: Array
) -> tuple[int, Array, float] | None:
    """The frontmost of these triangles at a pixel: which, its corners' weights, and its order."""
    across = seen[:, :, 0] - pixel[0] * seen[:, :, 3]
    down = seen[:, :, 1] - pixel[1] * seen[:, :, 3]
    after, before = [1, 2, 0], [2, 0, 1]
    weights = across[:, after] * down[:, before] - across[:, before] * down[:, after]
    inside = np.flatnonzero((weights >= 0.0).all(axis=1) | (weights <= 0.0).all(axis=1))
    total = weights[inside].sum(axis=1, keepdims=True)
    inside, total = inside[total[:, 0] != 0.0], total[total[:, 0] != 0.0]
    weights = weights[inside] / total
    order, w = (np.einsum("ij,ij->i", weights, seen[inside, :, row]) for row in (2, 3))
    points = np.einsum("ij,ijk->ik", weights, corners[inside])
    drawn = (points @ sight.limits[:, :3].T + sight.limits[:, 3] >= 0.0).all(axis=1) & (w > 0.0)
    if not drawn.any():
        return None
    order = np.where(drawn, order / np.where(drawn, w, 1.0), np.inf)
    first = int(order.argmin())
    return int(inside[first]), weights[first], float(order[first])


def _vector(point: Array) -> Vector:
    x, y, z = point.tolist()
    return x, y, z
