"""Picking in float64 without a GPU: the vertex, point of a line, or point of a face at a pixel.

Whatever a pane does to the scene, a world point becomes a pixel by one projective 4x4 and a divide
(a `Sight`). Nothing is divided before it is known to be in front. Homogeneous corners decide
whether a triangle contains the pixel (Olano and Greer, Triangle Scan Conversion using 2D
Homogeneous Coordinates, 1997). A triangle that crosses the eye plane therefore needs no clipping,
and the same three numbers are the barycentric coordinates of the hit in the world.

The triangles are sorted into the cells of a grid once per scene. Each pick evaluates a few linear
functions on every cell's box and looks only at the triangles of the cells that may contain the
pixel. The lines are few: they are clipped in homogeneous coordinates to a small square round the
pixel.
"""

import math
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.model.infinity import trace_at_infinity
from app.model.limits import Row, vector
from app.model.projection import LARGEST, Array, Chain, Projection, Vector
from app.picking.sight import Sight

VERTEX_WITHIN_PX = 6.0  # a visible vertex so near the pixel is preferred to the face beside it
LINE_WITHIN_PX = 3.0  # a visible line so near the pixel is preferred to the face under it
_COVERS_PX = 0.25  # half the drawn width of a line, which hides the points behind it
CHUNK = 128  # lines that follow one another in a file, and are near one another

_BLOCK = 16_384  # triangles: arrays of this size stay in the processor's cache
_CELLS = 32  # along each axis at most: cell numbers then fit 16 bits, which numpy sorts by radix
_PER_CELL = 100.0  # triangles, roughly, for a surface that fills the cells along a plane
_TRIED = 16  # vertices: if more are hidden, the mesh is denser than the pixels
_LOOKED_AT = 8_000  # triangles: if more are within the margin, a smaller margin has enough vertices
_LEAST_PX = 0.02  # margin
_END_ON_PX = 1e-6  # a shorter line on the screen counts as a point
_STOPS = 200  # a held key reaches each of them within seconds
_SPREAD = 32_768  # vertices
_ROW = 4  # height of a row of stops, in the smallest squares
_SAME_DEPTH = 1e-9  # relative: faces that meet in a vertex do not hide it
_ON_FACE = 1e-6  # relative: a line on a face, each rounded to float32


class Hit(NamedTuple):
    """A picked world point; `vertex` is its index in the surface, if it is a vertex.

    A smaller `order` is in front. For a point on a face, ``plane @ (x, y, 1)`` is the order of the
    face's plane at any pixel.
    """

    point: Vector
    vertex: int | None
    order: float
    plane: Array | None = None


@dataclass(frozen=True)
class Probe:
    """A point that is followed through every stage, the ray of a pixel, or a point at infinity.

    It has a world point, a pixel of the image, or a direction (w = 0). The panes show its number.
    """

    number: int
    point: Vector | None = None
    pixel: tuple[float, float] | None = None
    direction: Vector | None = None

    @classmethod
    def of(cls, number: int, row: Row) -> "Probe":
        """The probe at homogeneous coordinates from `app.model.infinity.homogeneous`."""
        x, y, z, w = row
        return cls(number, direction=(x, y, z)) if w == 0.0 else cls(number, (x, y, z))

    @property
    def row(self) -> Row | None:
        """Homogeneous coordinates; None for a pixel's ray."""
        if self.direction is not None:
            return (*self.direction, 0.0)
        return None if self.point is None else (*self.point, 1.0)


def carried(probe: Probe, start: Chain, end: Chain) -> Probe:
    """A probe of the object moved from one chain to another; unchanged if it has no such place."""
    if probe.row is None or start.rank < 3:
        return probe
    *place, w = start.object_from_world(probe.row)
    x, y, z = map(float, end.exactly(place, int(w)))
    return Probe.of(probe.number, (x, y, z, w))


def projector(projection: Projection, probe: Probe, distances: ArrayLike) -> Array | None:
    """World points (k, 3) of a probe's projector at distances (k,) from the eye plane.

    None for a point at or behind the eye plane, which has no image.

    The points q of a pixel's ray satisfy ``(x w - x_px w) = (y w - y_px w) = 0`` at the distance
    ``-n (q - e)``: three linear equations for any lens. A free matrix has no eye. Its line is the
    un-projected line of the cube between near and far, `distances` are shares of the way, and the
    result is None if the matrix has no inverse. For a line through infinity only the part in front
    of the eye plane is returned.
    """
    at, pixel = np.asarray(distances, dtype=np.float64), probe.pixel
    if probe.direction is not None:  # all lines in this direction meet in one pixel
        trace = trace_at_infinity(projection, probe.direction)
        if not trace.in_front:
            return None
        pixel = float(trace.image[0]), float(trace.image[1])
    return projection.passage.line(pixel, probe.point, at)


def dragged(
    projection: Projection, point: Vector, shift_px: tuple[float, float], *, along_ray: bool
) -> Vector | None:
    """Return the new position of a world point when its image is dragged by (right, down) pixels.

    None if the point has no image, or would lie too far away to have one. The point stays in its
    plane parallel to the image. With `along_ray` its image stays in place instead, and the point
    moves away (drag up) or nearer (drag down): by the width of a pixel for a parallel lens, in
    proportion to the distance for others, so that it never reaches the eye.

    Under a free matrix a point keeps its depth in the buffer instead of its plane, and moves along
    its ray by shares of the depth range.
    """
    trace = projection.trace(point)
    if not trace.in_front:
        return None
    moved = projection.passage.dragged(trace, shift_px, along_ray=along_ray)
    return None if moved is None or not np.abs(moved).max() <= LARGEST else vector(moved)


class PickSurface:
    """Triangles (m, 3) of points (n, 3), sorted into grid cells for picking.

    The points are relative to the world point `origin`, and are not copied.
    """

    def __init__(
        self, points: NDArray[Any], triangles: NDArray[Any], origin: Vector = (0.0, 0.0, 0.0)
    ) -> None:
        self._points, self._triangles = np.asarray(points), np.asarray(triangles)
        self._origin = np.array(origin, dtype=np.float64)
        # Column by column takes a fifth of the time of row by row for a million vertices.
        columns = [points[:, axis].copy() for axis in range(3)]
        cells = int(np.clip(np.sqrt(len(triangles) / _PER_CELL), 1, _CELLS))
        numbers = np.zeros(len(points), np.uint16)
        for column in columns if len(points) else ():
            low, high = column.min(), column.max()
            width = max(float(high) - float(low), 1e-36)  # a float32 cannot hold a larger scale
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
            for sides, choose, of_all in ((lowest, np.minimum, least), (highest, np.maximum, most)):
                np.take(of_all, self._order, out=in_order, mode="clip")  # "clip" avoids a copy
                sides[:, axis] = choose.reduceat(in_order, self._starts)
        self._middles, self._halves = (lowest + highest) / 2.0, (highest - lowest) / 2.0

    def pick(
        self, sight: Sight, pixel: tuple[float, float], vertex_px: float = VERTEX_WITHIN_PX
    ) -> Hit | None:
        """The vertex or face visible at a pixel, or None.

        A vertex that is not hidden and lies within `vertex_px` is preferred to a face.
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
            return Hit(vector(self._points[number] + self._origin), number, order)
        cast = _cast(sight, pixel, corners, seen)
        if cast is None:
            return None
        # Computed from the corners, not by way of the eye, which may be far away.
        which, weights, order = cast
        point = weights @ self._points[triangles[which]].astype(np.float64)
        plane = np.linalg.lstsq(seen[which][:, [0, 1, 3]], seen[which][:, 2])[0]
        return Hit(vector(point + self._origin), None, order, plane)

    def _near(
        self, sight: Sight, pixel: tuple[float, float], margin_px: float
    ) -> tuple[float, NDArray[Any]]:
        """The margin that was used, and the triangles (k, 3) that may lie within it."""
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
        """The nearest vertex that no face hides, with its order."""
        numbers, at = np.unique(triangles, return_index=True)
        x, y, order, w = seen.reshape(-1, 4)[at].T
        drawn = corners.reshape(-1, 3)[at] @ sight.limits[:, :3].T + sight.limits[:, 3]
        with np.errstate(divide="ignore", invalid="ignore"):
            x, y, order = x / w, y / w, order / w
        away = np.hypot(x - pixel[0], y - pixel[1])
        usable = np.flatnonzero((w > 0.0) & (drawn >= 0.0).all(axis=1) & (away <= within_px))
        for i in usable[np.argsort(away[usable], kind="stable")][:_TRIED]:
            cast = _cast(sight, (x[i], y[i]), corners, seen)
            if cast is None or order[i] <= cast[2] + _SAME_DEPTH * abs(cast[2]):
                return int(numbers[i]), float(order[i])
        return None

    def hides(self, sight: Sight, stop: "Stop") -> bool:
        """Whether a face hides one of the surface's vertices."""
        face = self.pick(sight, stop.spot, 0.0)
        return face is not None and _in_front(face.order, stop.order)


class Stop(NamedTuple):
    """A vertex, by its number, that the keyboard can go to: row by row, from left to right.

    Rows count from above, `spot` is the pixel from the pane's top left, and a smaller `order` is in
    front.
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
    """The vertices in a part of a pane, hidden or not, in reading order.

    If there are more than `_STOPS`, only the frontmost vertex of each square is kept; the squares
    grow until few enough are left. A million vertices take one pass over the points and a sort of
    `_SPREAD` of them, spread evenly over those in view.

    The points (n, 3) are relative to `origin`. The rectangle is left, top, width and height;
    `pixel_ratio` is the number of device pixels per pixel of `VERTEX_WITHIN_PX`. The vertex `at` is
    always kept while it is in view.
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
        # Vertices are sorted from back to front, so the last one of each square is kept.
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
    """Line segments for picking; their ends (m, 2, 3) are relative to the world point `origin`."""

    def __init__(self, ends: ArrayLike, origin: Vector = (0.0, 0.0, 0.0)) -> None:
        self._ends = ends = np.asarray(ends, dtype=np.float64)
        self._origin = np.array(origin, dtype=np.float64)
        self._chunk = np.arange(len(ends)) // CHUNK
        starts = np.arange(0, len(ends), CHUNK)
        low = high = np.empty((0, 3))
        if len(ends):
            low = np.minimum.reduceat(ends.min(axis=1), starts)
            high = np.maximum.reduceat(ends.max(axis=1), starts)
        self._middles, self._halves = (low + high) / 2.0, (high - low) / 2.0

    def near(
        self, sight: Sight, pixel: tuple[float, float], end_px: float, line_px: float
    ) -> list[tuple[bool, tuple[float, float], Hit, int]]:
        """Points of the lines near a pixel, hidden or not.

        For each: whether it is an end, its pixel, the point, and the number of its line.

        Ends are at most `end_px` away, other points `line_px`. Ends come first, then the nearest
        point of each line; both by distance.
        """
        offset = self._origin - sight.eye
        tests = _tests(sight, pixel, max(end_px, line_px))
        most = (self._middles + offset) @ tests[:, :3].T + tests[:, 3]
        most += self._halves @ np.abs(tests[:, :3]).T
        numbers = np.flatnonzero(np.all(most >= 0.0, axis=1)[self._chunk])
        ends = self._ends[numbers]
        local = ends + offset
        values = local @ tests[:, :3].T + tests[:, 3]
        which = np.flatnonzero((values.max(axis=1) >= 0.0).all(axis=1))
        if not len(which):  # the pointer is mostly near no line
            return []
        at_start, at_end = values[which, 0], values[which, 1]
        # The share of the way at which a test becomes 0: the line is clipped there.
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
        # Of a line that is seen end-on, take the front end.
        share = np.where(orders[:, 0] <= orders[:, 1], 0.0, 1.0)
        to_pixel = ((np.array(pixel) - spots[:, 0]) * along).sum(axis=1)
        np.divide(to_pixel, square, out=share, where=square > _END_ON_PX**2)
        share = np.clip(share, 0.0, 1.0)
        # Convert the share on the screen to the share on the line (perspective-correct).
        share = share * w[:, 0] / (share * w[:, 0] + (1.0 - share) * w[:, 1])
        nearest = parts[:, 0] + share * (parts[:, 1] - parts[:, 0])

        hits = []
        for part, within_px in ((0.0, end_px), (1.0, end_px), (nearest, line_px)):
            is_end = part is not nearest
            there = np.broadcast_to(part, len(which))
            x, y, order, w = seen[:, 0].T + there * (seen[:, 1] - seen[:, 0]).T
            inside = (parts[:, 0] <= there) & (there <= parts[:, 1])
            w = np.where(inside, w, np.nan)
            away = np.hypot(x / w - pixel[0], y / w - pixel[1])
            for i in np.flatnonzero(away <= within_px):
                start, end = ends[which[i]]
                # Return the ends exactly.
                point = end if there[i] == 1.0 else start + there[i] * (end - start)
                hit = Hit(vector(point + self._origin), None, float(order[i] / w[i]))
                spot = float(x[i] / w[i]), float(y[i] / w[i])
                number = int(numbers[which[i]])
                hits.append((not is_end, float(away[i]), hit.order, is_end, spot, hit, number))
        hits.sort(key=lambda place: place[:3])
        return [place[3:] for place in hits]


def pick(
    surface: PickSurface,
    lines: Lines,
    sight: Sight,
    pixel: tuple[float, float],
    pixel_ratio: float = 1.0,
) -> Hit | None:
    """The vertex, end of a line, point of a line or point of a face visible at a pixel, or None.

    A point of a line counts only if no face hides it, at its own pixel and at the given one. A
    vertex is preferred to everything else nearby, unless a line runs in front of the vertex itself.
    `pixel_ratio` is the number of device pixels per pixel of `VERTEX_WITHIN_PX` and
    `LINE_WITHIN_PX`.
    """
    vertex_px, line_px = VERTEX_WITHIN_PX * pixel_ratio, LINE_WITHIN_PX * pixel_ratio
    hit = surface.pick(sight, pixel, vertex_px)
    at_vertex, is_covered = pixel, False
    if hit is not None and hit.vertex is not None:
        x, y = sight.seen([hit.point])[0].tolist()
        at_vertex = x, y
        # Test at the vertex: an edge from the vertex to the eye is in front of it only beside it.
        over = lines.near(sight, at_vertex, 0.0, _COVERS_PX * pixel_ratio)
        is_covered = any(_in_front(place.order, hit.order) for *_, place, _ in over)
    for is_end, spot, place, _ in lines.near(sight, pixel, vertex_px, line_px)[:_TRIED]:
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
    """All corners (k, 3, 3) times a (3, m) matrix, in one product."""
    return np.asarray((corners.reshape(-1, 3) @ columns).reshape(len(corners), 3, -1))


def _tests(sight: Sight, pixel: tuple[float, float], margin_px: float) -> Array:
    """Linear functions (k, 4) of ``(p - eye, 1)`` that are at least 0 for points near a pixel.

    A function that is negative at all corners of a box or a triangle is negative inside it, whether
    or not the eye plane runs through it.
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
    """Index, barycentric weights and order of the frontmost triangle at a pixel."""
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
