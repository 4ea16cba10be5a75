"""What is under a pixel, in float64 and without a GPU: a vertex, a point of a line or the surface.

Whatever a pane does to the scene, from a world point p to a pixel it is one projective 4x4 and a
divide (a `Sight`). Nothing is divided until it is known to be in front: that a triangle holds the
pixel is told by its homogeneous corners (Olano and Greer, Triangle Scan Conversion using 2D
Homogeneous Coordinates, 1997), so that one that crosses the eye plane needs no clipping, and the
same three numbers are the hit's barycentric coordinates in the world.

The triangles are sorted into cells of a grid once per scene. Each pick asks a handful of linear
functions for every cell's box, and only the triangles of the cells that may hold the pixel are
looked at. The lines are few: they are cut, as homogeneous as the triangles, to a small square round
the pixel, and what is left of them has a picture.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.model.infinity import trace_at_infinity
from app.model.limits import Row
from app.model.projection import LARGEST, Array, Projection, Vector

VERTEX_WITHIN_PX = 6.0
"""A vertex that is seen so close to the pixel is what was meant, not the face beside it."""
LINE_WITHIN_PX = 3.0
"""A line that is seen so close to the pixel is what was meant, not the face under it."""
_COVERS_PX = 0.25
"""Half as wide as a line is drawn: what is behind it there is not seen."""

_BLOCK = 16_384  # triangles: what is made of so many stays in the processor's cache
_CELLS = 32  # along each axis at most: their numbers fit 16 bits, which numpy sorts by radix
_PER_CELL = 100.0  # triangles, about, of a surface that fills the cells along a plane
_TRIED = 16  # vertices: where more are hidden, the mesh is denser than the pixels
_LOOKED_AT = 8_000  # triangles; where more are within the margin, a smaller one has vertices enough
_LEAST_PX = 0.02  # margin
_END_ON_PX = 1e-6  # a line that is seen shorter is a point
_STOPS = 200  # of which each is at hand after some seconds of a key that is held
_SPREAD = 32_768  # vertices
_ROW = 4  # of the least squares
_SAME_DEPTH = 1e-9  # relative: faces that meet in a vertex do not hide it
_ON_FACE = 1e-6  # relative: a line on a face, each rounded to float32 by itself


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
        clip, axes = projection.passage.stated_in
        rows = projection.image_from_ndc @ clip
        rows[2], limits = projection.passage.order
        return cls(np.array(projection.camera.eye), rows @ axes, limits @ axes)

    def scaled(self, pixels_from_pixels: ArrayLike) -> Sight:
        """Seen in other pixels, by an affine (3, 3) matrix of x, y, 1."""
        rows = self.rows.copy()
        rows[[0, 1, 3]] = np.asarray(pixels_from_pixels) @ self.rows[[0, 1, 3]]
        return self._replace(rows=rows)

    def of_object(self, projection: Projection, origin: Vector) -> Sight:
        """The same sight, for points of the object: ``rows (p - origin, 1)``."""
        if projection.placement.is_identity:
            return self
        local = projection.placement.local_from(origin, tuple(self.eye.tolist()))
        return Sight(np.array(origin), self.rows @ local, self.limits @ local)

    def seen(self, points_world: ArrayLike) -> Array:
        """Pixels x, y of points, (n, 2); NaN for those at or behind the eye plane."""
        offsets = np.asarray(points_world, dtype=np.float64) - self.eye
        x, y, _, w = self.rows[:, :3] @ offsets.T + self.rows[:, 3:]
        w = np.where(w > 0.0, w, np.nan)
        return np.stack([x / w, y / w], axis=1)

    def seen_at_infinity(self, direction: Vector) -> Array:
        """Pixel x, y of a point at infinity, (2,); NaN where it has none."""
        x, y, _, w = self.rows[:, :3] @ direction
        return np.array([x / w, y / w]) if w > 0.0 else np.full(2, np.nan)


class Hit(NamedTuple):
    """What was found.

    Attributes
    ----------
    point : Vector
        World coordinates.
    vertex : int or None
        Which point of the surface it is, if it is one.
    order : float
        Smaller for what is in front.
    plane : (3,) array or None
        The order ``plane @ (x, y, 1)`` of the plane of a face at all pixels, if it is on one.
    """

    point: Vector
    vertex: int | None
    order: float
    plane: Array | None = None


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
    direction : Vector, optional
        The point at infinity that it is, if it is neither: w = 0.
    """

    number: int
    point: Vector | None = None
    pixel: tuple[float, float] | None = None
    direction: Vector | None = None

    @classmethod
    def of(cls, number: int, row: Row) -> Probe:
        """Of homogeneous coordinates, as `app.model.infinity.homogeneous` gives them."""
        x, y, z, w = row
        return cls(number, direction=(x, y, z)) if w == 0.0 else cls(number, (x, y, z))

    @property
    def row(self) -> Row | None:
        """Its homogeneous coordinates; None for a pixel's ray."""
        if self.direction is not None:
            return (*self.direction, 0.0)
        return None if self.point is None else (*self.point, 1.0)


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
    without an inverse. Of a line through infinity it is the part in front of the eye plane, from
    its end as far as it is drawn.
    """
    at, pixel = np.asarray(distances, dtype=np.float64), probe.pixel
    if probe.direction is not None:  # all its lines meet in one pixel
        trace = trace_at_infinity(projection, probe.direction)
        if not trace.in_front:
            return None
        pixel = float(trace.image[0]), float(trace.image[1])
    return projection.passage.line(pixel, probe.point, at)


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
    moved = projection.passage.dragged(trace, shift_px, along_ray=along_ray)
    return None if moved is None or not np.abs(moved).max() <= LARGEST else _vector(moved)


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
        self._points, self._triangles = np.asarray(points), np.asarray(triangles)
        self._origin = np.array(origin, dtype=np.float64)
        # A million vertices: column by column, which takes a fifth of the time of row by row.
        columns = [points[:, axis].copy() for axis in range(3)]
        cells = int(np.clip(np.sqrt(len(triangles) / _PER_CELL), 1, _CELLS))
        numbers = np.zeros(len(points), np.uint16)
        for column in columns if len(points) else ():
            low, high = column.min(), column.max()
            width = max(float(high) - float(low), 1e-36)  # else no float32 holds the scale
            scale = column.dtype.type(cells * 0.999 / width)
            numbers = numbers * np.uint16(cells) + ((column - low) * scale).astype(np.uint16)
        count = len(triangles)
        blocks = [slice(at, at + _BLOCK) for at in range(0, count, _BLOCK)]
        of_triangle = np.empty(count, np.uint16)
        for block in blocks:
            of_triangle[block] = numbers.take(triangles[block, 0])
        self._order = np.argsort(of_triangle, kind="stable")
        cell = of_triangle.take(self._order)
        is_first = np.ones(count, dtype=bool)
        np.not_equal(cell[1:], cell[:-1], out=is_first[1:])
        self._starts = np.flatnonzero(is_first)
        self._ends = np.append(self._starts[1:], count)
        lowest, highest = np.empty((2, len(self._starts), 3))
        least, most, in_order = np.empty((3, count), points.dtype)
        for axis, column in enumerate(columns if count else ()):
            for block in blocks:
                a, b, c = (column.take(corner) for corner in triangles[block].T)
                np.minimum(np.minimum(a, b), c, out=least[block])
                np.maximum(np.maximum(a, b), c, out=most[block])
            for sides, choose, of_all in (
                (lowest, np.minimum, least),
                (highest, np.maximum, most),
            ):
                np.take(of_all, self._order, out=in_order, mode="clip")  # which needs no copy
                sides[:, axis] = choose.reduceat(in_order, self._starts)
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
        seen = _mapped(corners, sight.rows[:, :3].T) + sight.rows[:, 3]
        vertex = self._vertex(sight, pixel, vertex_px, triangles, corners, seen)
        if vertex is not None:
            number, order = vertex
            return Hit(_vector(self._points[number] + self._origin), number, order)
        found = _cast(sight, pixel, corners, seen)
        if found is None:
            return None
        # Not by way of the eye, which may be far away: from the corners.
        which, weights, order = found
        point = weights @ self._points[triangles[which]].astype(np.float64)
        plane = np.linalg.lstsq(seen[which][:, [0, 1, 3]], seen[which][:, 2])[0]
        return Hit(_vector(point + self._origin), None, order, plane)

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
        triangles = self._triangles[
            np.concatenate(
                [self._order[start:end] for start, end in zip(starts, ends, strict=True)]
            )
        ]
        values = _mapped(self._points[triangles] + offset, normals) + tests[:, 3]
        a, b, c = values[:, 0], values[:, 1], values[:, 2]
        most = np.maximum(np.maximum(a, b), c)
        return margin_px, triangles[(most >= 0.0).all(axis=1)]

    def _vertex(
        self,
        sight: Sight,
        pixel: tuple[float, float],
        within_px: float,
        triangles: NDArray[Any],
        corners: Array,
        seen: Array,
    ) -> tuple[int, float] | None:
        """The nearest vertex that no face hides, and its order."""
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
                return int(numbers[i]), float(order[i])
        return None

    def hides(self, sight: Sight, stop: Stop) -> bool:
        """Whether a face lies in front of one of the surface's vertices."""
        face = self.pick(sight, stop.spot, 0.0)
        return face is not None and _in_front(face.order, stop.order)


class Stop(NamedTuple):
    """A vertex that can be gone to.

    Attributes
    ----------
    row : int
        Of the pane, from above: stops are read row by row, from left to right.
    spot : (float, float)
        Where it is seen, in pixels from the pane's top left.
    number : int
        Which vertex it is.
    order : float
        Smaller for what is in front.
    """

    row: int
    spot: tuple[float, float]
    number: int
    order: float


def stops(
    points: NDArray[Any],
    origin: Vector,
    sight: Sight,
    rectangle_px: tuple[float, float, float, float],
    pixel_ratio: float = 1.0,
    at: int | None = None,
) -> list[Stop]:
    """The vertices in a part of a pane, hidden or not, in the order in which one reads.

    Where there are more than `_STOPS`, those in front stand for the others: one in each square,
    which are so large that no more are left. A million vertices take one pass over the points and
    a sort of `_SPREAD` of them, spread evenly over those in view.

    Parameters
    ----------
    points : (n, 3) array
        Relative to `origin`.
    origin : Vector
    sight : Sight
    rectangle_px : (float, float, float, float)
        Left, top, width and height.
    pixel_ratio : float
        How many pixels one of `VERTEX_WITHIN_PX` is.
    at : int, optional
        A vertex that is one of them wherever it is in view.
    """
    left, top, width, height = rectangle_px
    x, y, _, w = sight.rows
    sides = np.array([x - left * w, (left + width) * w - x, y - top * w, (top + height) * w - y, w])
    tests = np.concatenate([sides, sight.limits])
    offset = np.array(origin) - sight.eye
    constants = (tests[:, :3] @ offset + tests[:, 3])[:, None]
    inside = [np.empty(0, np.intp)]
    for first in range(0, len(points), _BLOCK):
        values = tests[:, :3] @ points[first : first + _BLOCK].T.astype(np.float64) + constants
        inside.append(first + np.flatnonzero((values >= 0.0).all(axis=0) & (values[4] > 0.0)))
    in_view = np.concatenate(inside)
    numbers = in_view[:: max(1, -(-len(in_view) // _SPREAD))]
    if at is not None and at in in_view:
        numbers = np.union1d(numbers, [at])
    offsets = points[numbers].astype(np.float64) + offset
    x, y, order, w = sight.rows[:, :3] @ offsets.T + sight.rows[:, 3:]
    x, y, order = x / w, y / w, order / w
    side = VERTEX_WITHIN_PX * pixel_ratio
    row_px = _ROW * side
    kept = np.argsort(-order, kind="stable")
    while len(kept) > _STOPS:
        squares = ((y[kept] - top) // side).astype(np.int64) << 32
        squares += ((x[kept] - left) // side).astype(np.int64)
        # What comes later is in front, so that of each square the last is kept.
        _, last = np.unique(squares[::-1], return_index=True)
        kept = kept[np.sort(len(kept) - 1 - last)]
        row_px = max(row_px, side)
        side *= 2.0
    kept = np.union1d(kept, np.flatnonzero(numbers == (-1 if at is None else at)))
    rows = ((y[kept] - top) // row_px).astype(np.int64)
    spots = zip(x[kept].tolist(), y[kept].tolist(), strict=True)
    of_each = rows.tolist(), spots, numbers[kept].tolist(), order[kept].tolist()
    return sorted(Stop(*each) for each in zip(*of_each, strict=True))


class Lines:
    """Straight lines, each from a point to a point.

    Parameters
    ----------
    ends : (m, 2, 3) array
        Relative to `origin`.
    origin : Vector
        World point that the ends are relative to.
    """

    def __init__(self, ends: ArrayLike, origin: Vector = (0.0, 0.0, 0.0)) -> None:
        self._ends = np.asarray(ends, dtype=np.float64)
        self._origin = np.array(origin, dtype=np.float64)

    def near(
        self, sight: Sight, pixel: tuple[float, float], end_px: float, line_px: float
    ) -> list[tuple[bool, tuple[float, float], Hit]]:
        """What of the lines is near a pixel, whatever may hide it.

        Parameters
        ----------
        sight : Sight
        pixel : (float, float)
        end_px, line_px : float
            How near an end has to be, and any other place.

        Returns
        -------
        list of (bool, (float, float), Hit)
            Whether it is an end, where it is seen, and what it is: ends first, then the place of
            each line that is nearest to the pixel; the nearest first.
        """
        local = self._ends + (self._origin - sight.eye)
        tests = _tests(sight, pixel, max(end_px, line_px))
        values = local @ tests[:, :3].T + tests[:, 3]
        which = np.flatnonzero((values.max(axis=1) >= 0.0).all(axis=1))
        at_start, at_end = values[which, 0], values[which, 1]
        # A part of the way at which a test becomes 0: the line is cut there.
        with np.errstate(divide="ignore", invalid="ignore"):
            cut = at_start / (at_start - at_end)
        parts = np.stack(
            [
                np.where(at_start < 0.0, cut, 0.0).max(axis=1, initial=0.0),
                np.where(at_end < 0.0, cut, 1.0).min(axis=1, initial=1.0),
            ],
            axis=1,
        )
        seen = local[which] @ sight.rows[:, :3].T + sight.rows[:, 3]
        cuts = seen[:, :1] + parts[:, :, None] * (seen[:, 1:] - seen[:, :1])
        whole = (parts[:, 0] <= parts[:, 1]) & (cuts[:, :, 3] > 0.0).all(axis=1)
        which, parts, seen, cuts = which[whole], parts[whole], seen[whole], cuts[whole]

        w = cuts[:, :, 3]
        spots, orders = cuts[:, :, :2] / w[:, :, None], cuts[:, :, 2] / w
        along = spots[:, 1] - spots[:, 0]
        square = (along**2).sum(axis=1)
        # What is seen end-on is seen at its front.
        share = np.where(orders[:, 0] <= orders[:, 1], 0.0, 1.0)
        to_pixel = ((np.array(pixel) - spots[:, 0]) * along).sum(axis=1)
        np.divide(to_pixel, square, out=share, where=square > _END_ON_PX**2)
        share = np.clip(share, 0.0, 1.0)
        # A share of the picture is another of the line: that of the ends' weights there, over w.
        share = share * w[:, 0] / (share * w[:, 0] + (1.0 - share) * w[:, 1])
        nearest = parts[:, 0] + share * (parts[:, 1] - parts[:, 0])

        found = []
        for part, within_px in ((0.0, end_px), (1.0, end_px), (nearest, line_px)):
            is_end = part is not nearest
            there = np.broadcast_to(part, len(which))
            x, y, order, w = seen[:, 0].T + there * (seen[:, 1] - seen[:, 0]).T
            inside = (parts[:, 0] <= there) & (there <= parts[:, 1])
            w = np.where(inside, w, np.nan)
            away = np.hypot(x / w - pixel[0], y / w - pixel[1])
            for i in np.flatnonzero(away <= within_px):
                start, end = self._ends[which[i]]
                # The ends themselves, to the last bit.
                point = end if there[i] == 1.0 else start + there[i] * (end - start)
                hit = Hit(_vector(point + self._origin), None, float(order[i] / w[i]))
                spot = float(x[i] / w[i]), float(y[i] / w[i])
                found.append((not is_end, float(away[i]), hit.order, is_end, spot, hit))
        found.sort(key=lambda place: place[:3])
        return [place[3:] for place in found]


def pick(
    surface: Surface,
    lines: Lines,
    sight: Sight,
    pixel: tuple[float, float],
    pixel_ratio: float = 1.0,
) -> Hit | None:
    """What is seen at a pixel: a vertex or an end of a line, a place of a line, or of a face.

    Parameters
    ----------
    surface : Surface
    lines : Lines
    sight : Sight
    pixel : (float, float)
    pixel_ratio : float
        How many pixels one of `VERTEX_WITHIN_PX` and `LINE_WITHIN_PX` is.

    Returns
    -------
    Hit or None
        Of a line only what no face is in front of, where it is and under the pixel; a vertex comes
        before whatever else is near, unless a line runs in front of the vertex itself.
    """
    vertex_px, line_px = VERTEX_WITHIN_PX * pixel_ratio, LINE_WITHIN_PX * pixel_ratio
    hit = surface.pick(sight, pixel, vertex_px)
    at_vertex, is_covered = pixel, False
    if hit is not None and hit.vertex is not None:
        x, y = sight.seen([hit.point])[0].tolist()
        at_vertex = x, y
        # There: an edge that ends in the vertex and runs to the eye is in front beside it only.
        over = lines.near(sight, at_vertex, 0.0, _COVERS_PX * pixel_ratio)
        is_covered = any(_in_front(place.order, hit.order) for _, _, place in over)
    for is_end, spot, place in lines.near(sight, pixel, vertex_px, line_px)[:_TRIED]:
        if hit is not None and hit.vertex is not None:
            nearer = math.dist(spot, pixel) < math.dist(at_vertex, pixel)
            covers = is_covered and _in_front(place.order, hit.order)
            if not (nearer if is_end else covers):
                continue
        elif hit is not None and _in_front(_order_at(hit, spot), place.order):
            continue
        hiding = surface.pick(sight, spot, 0.0)
        if hiding is None or not _in_front(hiding.order, place.order):
            return place
    return hit


def _order_at(face: Hit, pixel: tuple[float, float]) -> float:
    assert face.plane is not None
    return float(face.plane @ (*pixel, 1.0))


def _in_front(order: float, other: float) -> bool:
    return order < other - _ON_FACE * (abs(order) + abs(other))


def _mapped(corners: Array, columns: Array) -> Array:
    """All corners (k, 3, 3) times a (3, m) matrix: at once, not triangle by triangle."""
    product: Array = (corners.reshape(-1, 3) @ columns).reshape(len(corners), 3, -1)
    return product


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
