"""Divide polygons into triangles that cover them exactly, in any plane, also around holes.

A polygon whose triangles about one of its corners all turn the same way is their fan. All others
are divided by mapbox-earcut.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from app.scenes.mesh import Floats, Ints

_FIRSTS = 8  # corners of each polygon tried as the centre of a fan, for all polygons at once
_STARTS = 8  # corners from which ears are tried: rounded touches spoil some
_RIGHT = 1e-9  # part of its area by which a divided polygon may differ
_ROUNDING = 1e-15  # part of a polygon's area by which a triangle of its fan may turn backwards
_LEAST_WITH_HOLE = 8  # corners of a triangle with a triangular hole and its bridge
_TRIED = 7  # corners of a ring that decide whether it lies in an outline: one may lie on it


def following(offsets: Ints) -> Ints:
    """Return for every corner of the faces the place of the next corner of the same face."""
    following = np.arange(1, offsets[-1] + 1)
    following[offsets[1:] - 1] = offsets[:-1]
    return following


def area_vectors(points: Floats, offsets: Ints, corners: Ints) -> Floats:
    """Return twice the areas of polygons as vectors (m, 3) along their normals.

    The area vectors of the triangles of a fan add up to that of the polygon, even a concave one.
    """
    counts = np.diff(offsets)
    if (counts == 3).all():  # the fan has one triangle
        a, b, c = (points[corners[i::3]] for i in range(3))
        return _crossed(b - a, c - a)
    away = points[corners] - np.repeat(points[corners[offsets[:-1]]], counts, axis=0)
    return np.asarray(np.add.reduceat(_crossed(away, away[following(offsets)]), offsets[:-1]))


def _crossed(one: Floats, other: Floats) -> Floats:
    """Return cross products (n, 3): by columns, in a third of the time of `numpy.cross`."""
    product = np.empty((3, len(one))).T
    for x, y, z in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        product[:, x] = one[:, y] * other[:, z] - one[:, z] * other[:, y]
    return product


def are_convex(quads: Floats) -> NDArray[np.bool_]:
    """Whether faces of four corners (m, 4, 3) turn to the same side at each of them."""
    sides = np.roll(quads, -1, axis=1) - quads
    areas = _crossed(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])
    convex = np.ones(len(quads), dtype=bool)
    for i in range(4):
        convex &= ~_is_backward(sides[:, i - 1], sides[:, i], areas)
    return convex


def _is_backward(one: Floats, other: Floats, areas: Floats) -> NDArray[np.bool_]:
    """Whether triangles with two sides each turn against the polygons with these areas."""
    turns = _crossed(one, other)
    squares = (areas * areas).sum(axis=1)
    is_backward = (turns * areas).sum(axis=1) < -_ROUNDING * squares
    return np.asarray(is_backward | ((squares == 0.0) & turns.any(axis=1)))


def divided(
    points: Floats, offsets: Ints, corners: Ints, tell: Callable[[int], None]
) -> tuple[Ints, Ints]:
    """Return triangles (k, 3) of polygons as indices of points, and the polygon of each.

    A polygon that crosses itself becomes its ears or the fan about its first corner, whichever is
    closer to its area; one whose parts cancel, the fan. `tell` is called with each polygon that
    takes long, before it is divided.
    """
    counts, areas = np.diff(offsets), area_vectors(points, offsets, corners)
    waiting, returning = np.arange(len(counts)), _returning(points[corners], counts)
    triangles, owners = [], []
    for first in range(min(_FIRSTS, int(counts.max()))):
        fans, owner = _fans(offsets, waiting, first)
        a, b, c = (points[corners[fans[:, i]]] for i in range(3))
        is_fan = np.ones(len(counts), dtype=bool)
        is_fan[returning] = False
        is_fan[owner[_is_backward(b - a, c - a, areas[owner])]] = False
        triangles.append(corners[fans[is_fan[owner]]])
        owners.append(owner[is_fan[owner]])
        waiting = waiting[~is_fan[waiting]]
    for polygon in waiting.tolist():
        tell(polygon)
        places = corners[offsets[polygon] : offsets[polygon + 1]]
        triangles.append(places[_cut(points[places], areas[polygon])])
        owners.append(np.full(len(triangles[-1]), polygon))
    return np.concatenate(triangles), np.concatenate(owners)


def _fans(offsets: Ints, which: Ints, first: int) -> tuple[Ints, Ints]:
    """Return the triangles (k, 3) of some polygons about one corner, and the polygon of each."""
    sizes = np.diff(offsets)[which]
    counts = sizes - 2
    owner = np.repeat(which, counts)
    step = 1 + np.arange(len(owner)) - np.repeat(np.cumsum(counts) - counts, counts)
    around = first + np.stack([0 * step, step, step + 1], axis=1)
    return offsets[owner][:, None] + around % np.repeat(sizes, counts)[:, None], owner


def _returning(corners: Floats, counts: Ints) -> Ints:
    """Return the polygons that come back to a place (n, 3) after others, as around a hole."""
    owner = np.repeat(np.arange(len(counts)), counts)
    at = np.flatnonzero(counts[owner] >= _LEAST_WITH_HOLE)
    order = at[np.lexsort((at, *corners[at].T, owner[at]))]
    one, other = order[:-1], order[1:]
    is_same = (owner[one] == owner[other]) & (corners[one] == corners[other]).all(axis=1)
    away = (other - one)[is_same]
    polygon = owner[one[is_same]]
    return np.asarray(polygon[(away > 1) & (away < counts[polygon] - 1)])


def _cut(points: Floats, area: Floats) -> Ints:
    """Return triangles (k, 3) of a polygon (n, 3) as numbers of its corners."""
    away = points - points[0]
    turns = _crossed(away, np.roll(away, -1, axis=0))
    largest = turns[(turns**2).sum(axis=1).argmax()]
    if area @ area < _ROUNDING * (largest @ largest):  # the sum of its parts is lost in rounding
        area = largest
    axis = int(np.abs(area).argmax())
    flat = away[:, [(axis + 1) % 3, (axis + 2) % 3]][:, :: 1 if area[axis] > 0.0 else -1]
    flat = flat / np.abs(flat).max()
    count, (_, holes) = len(flat), _parted(flat)
    enclosed = _shoelace(flat) - 2.0 * sum(max(_shoelace(flat[hole]), 0.0) for hole in holes)
    best = fan = _fans(np.array([0, count]), np.zeros(1, dtype=np.int64), 0)[0]
    least = _wrong(flat[best], enclosed)
    for start in range(0, count, -(-count // _STARTS)):
        ears = (_ears(np.roll(flat, -start, axis=0)) + start) % count
        wrong = _wrong(flat[ears], enclosed)
        if wrong < least:
            best, least = ears, wrong
        if least <= _RIGHT * enclosed:
            break
    if len(best):
        return best
    # a bow tie, whose halves cancel, is its fan; a polygon of edges there and back has no surface
    return fan if _rings(flat) else np.array([[0, 0, count - 1]])


def _ears(flat: Floats) -> Ints:
    """Divide a counter-clockwise outline (n, 2) into triangles with mapbox-earcut."""
    from mapbox_earcut import triangulate_float64  # few meshes need it

    outlines, holes = _parted(flat)
    ears = [np.empty(0, dtype=np.int64)]
    for number, outline in enumerate(outlines):
        parts = [outline] if number else [outline, *holes]
        places = np.concatenate(parts)
        ends = np.cumsum([len(part) for part in parts]).astype(np.uint32)
        ears.append(places[triangulate_float64(np.ascontiguousarray(flat[places]), ends)])
    return np.concatenate(ears).reshape(-1, 3)


def _parted(flat: Floats) -> tuple[list[Ints], list[Ints]]:
    """Return the outlines of a polygon (n, 2), the largest first, and its holes.

    A hole turns the other way round, or lies in the largest outline.
    """
    rings = [(_shoelace(flat[ring]), ring) for ring in _rings(flat)]
    least = _ROUNDING * abs(sum(size for size, _ in rings))
    holes = [ring for size, ring in rings if size < -least]
    outlines = [ring for size, ring in sorted(rings, key=lambda each: -each[0]) if size > least]
    around, others = outlines[:1], list[Ints]()
    for ring in outlines[1:]:
        (holes if _is_inside(flat[ring], flat[around[0]]) else others).append(ring)
    return [*around, *others], holes


def _is_inside(ring: Floats, outline: Floats) -> bool:
    """Whether most of some corners of a ring (k, 2) lie in an outline (n, 2)."""
    ring = ring[:: -(-len(ring) // _TRIED)]
    (x, y), (next_x, next_y) = outline.T, np.roll(outline, -1, axis=0).T
    rise = np.where(next_y == y, 1.0, next_y - y)
    inside = 0
    for at_x, at_y in ring.tolist():
        crosses = ((y > at_y) != (next_y > at_y)) & (at_x < x + (at_y - y) * (next_x - x) / rise)
        inside += int(crosses.sum()) % 2
    return 2 * inside > len(ring)


def _shoelace(ring: Floats) -> float:
    """Return twice the signed area of a ring (n, 2)."""
    x, y = (ring - ring[0]).T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1))


def _wrong(triangles: Floats, enclosed: float) -> float:
    """Return by how much twice the area of triangles (k, 3, 2) differs from that of the outline."""
    (x, y), (other_x, other_y) = ((triangles[:, i] - triangles[:, 0]).T for i in (1, 2))
    return abs(float(np.abs(x * other_y - y * other_x).sum()) - enclosed)


def _rings(flat: Floats) -> list[Ints]:
    """Split an outline (n, 2) where it returns to a place: so bridges to holes vanish."""
    rings: list[list[int]] = []
    way: list[int] = []
    position: dict[tuple[float, float], int] = {}
    corners = [(x, y) for x, y in flat.tolist()]
    for number, place in enumerate(corners):
        if place in position:
            at = position[place]
            rings.append(way[at:])
            for each in way[at:]:
                del position[corners[each]]
            del way[at:]
        position[place] = len(way)
        way.append(number)
    return [np.array(ring) for ring in (*rings, way) if len(ring) > 2]
