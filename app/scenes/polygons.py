"""Divide polygons into triangles that cover them exactly, in any plane, also around holes.

A polygon whose triangles about one of its corners all turn the same way is their fan. All other
polygons are swept from left to right (Hertel and Mehlhorn, *Fast Triangulation of Simple Polygons*,
1983), in a time proportional to n log n. The sweep counts the turns of the outline around each
place. So an edge that runs there and back cancels, such as the bridge to a hole, and corners may
touch edges.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from functools import cmp_to_key
from itertools import pairwise
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from app.scenes.mesh import Floats, Ints

_FIRSTS = 8
"""Corners of each polygon that are tried as the centre of a fan, for all polygons at once."""
_GRIDS = 2.0**50, 2.0**21
"""Steps of a grid along a swept polygon, for float64 and float32: its cross products are exact."""
_ROUNDING = 1e-15
"""Part of a polygon's area by which a triangle of its fan may turn backwards."""
_TOUCHES = 2
"""Steps between an edge and a corner that touches it."""

_Places: TypeAlias = list[tuple[int, int]]


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
    areas: Floats = np.add.reduceat(_crossed(away, away[following(offsets)]), offsets[:-1])
    return areas


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
    found = np.ones(len(quads), dtype=bool)
    for i in range(4):
        found &= ~_is_backward(sides[:, i - 1], sides[:, i], areas)
    return found


def _is_backward(one: Floats, other: Floats, areas: Floats) -> NDArray[np.bool_]:
    """Whether triangles with two sides each turn against the polygons with these areas."""
    turns = _crossed(one, other)
    squares = (areas * areas).sum(axis=1)
    found = (turns * areas).sum(axis=1) < -_ROUNDING * squares
    return np.asarray(found | ((squares == 0.0) & turns.any(axis=1)))


def divided(
    points: Floats, offsets: Ints, corners: Ints, tell: Callable[[], None]
) -> tuple[Ints, Ints]:
    """Return triangles (k, 3) of polygons as indices of points, and the polygon of each.

    A polygon that crosses itself becomes the fan about its first corner. `tell` is called before
    each polygon that takes long.
    """
    counts, areas = np.diff(offsets), area_vectors(points, offsets, corners)
    waiting = np.arange(len(counts))
    triangles, owners = [], []
    for first in range(min(_FIRSTS, int(counts.max()))):
        fans, owner = _fans(offsets, waiting, first)
        a, b, c = (points[corners[fans[:, i]]] for i in range(3))
        is_fan = np.ones(len(counts), dtype=bool)
        is_fan[owner[_is_backward(b - a, c - a, areas[owner])]] = False
        triangles.append(corners[fans[is_fan[owner]]])
        owners.append(owner[is_fan[owner]])
        waiting = waiting[~is_fan[waiting]]
    for polygon in waiting.tolist():
        tell()
        places = corners[offsets[polygon] : offsets[polygon + 1]]
        triangles.append(places[_swept(points[places], areas[polygon])])
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


# --------------------------------------------------------------------------- the sweep


def _swept(points: Floats, area: Floats) -> Ints:
    """Return triangles (k, 3) of a polygon (n, 3) as numbers of its corners."""
    away = points - points[0]
    turns = _crossed(away, np.roll(away, -1, axis=0))
    largest = turns[(turns**2).sum(axis=1).argmax()]
    if area @ area < _ROUNDING * (largest @ largest):  # the sum of its parts is lost in rounding
        area = largest
    axis = int(np.abs(area).argmax())
    flat = points[:, [(axis + 1) % 3, (axis + 2) % 3]][:, :: 1 if area[axis] > 0.0 else -1]
    flat = flat - flat.min(axis=0)
    for steps in _GRIDS if len(points) > 4 else ():
        grid = np.rint(flat * (steps / flat.max())).astype(np.int64).tolist()
        corner = {(x, y): i for i, (x, y) in enumerate(grid)}
        places = sorted(corner)
        number = {place: i for i, place in enumerate(places)}
        triangles = _sweep(places, [number[x, y] for x, y in grid])
        if triangles is not None:  # a polygon that encloses nothing keeps a triangle without area
            corners = np.array([corner[place] for place in places])
            found: Ints = corners[np.array(triangles or [(0, 0, len(corners) - 1)])]
            return found
    return _fans(np.array([0, len(points)]), np.zeros(1, dtype=np.int64), 0)[0]


class _Edge:
    """An edge that the sweep has reached, and the place above it.

    Attributes
    ----------
    end : int
        Number of the point where it ends, on the right.
    change : int
        By how much `winding` there is larger than below the edge.
    winding : int
        The turns of the outline around the place; it is outside if they are 0.
    front : list of int
        Points of the place, upwards, to the right of which no triangle has been made.
    foremost : int
        Position of the rightmost point of the front.
    """

    __slots__ = ("along", "change", "end", "foremost", "front", "touch", "up", "winding", "x", "y")

    def __init__(self, flat: _Places, start: int, end: int, change: int, winding: int) -> None:
        self.end, self.change, self.winding = end, change, winding
        self.front, self.foremost = [start], 0
        (self.x, self.y), (end_x, end_y) = flat[start], flat[end]
        self.along, self.up = end_x - self.x, end_y - self.y
        self.touch = _TOUCHES * (self.along + abs(self.up))

    def side(self, point: tuple[int, int]) -> int:
        """Above 0 for a point above the edge, below 0 for one below, 0 if it touches the edge."""
        turn = self.along * (point[1] - self.y) - self.up * (point[0] - self.x)
        return turn if abs(turn) > self.touch else 0


def _sweep(flat: _Places, outline: list[int]) -> list[tuple[int, int, int]] | None:
    """Return the triangles inside an outline, or None if it crosses itself between its points.

    Parameters
    ----------
    flat : list of tuples of 2 ints
        Points, from left to right.
    outline : list of int
        Numbers of the points, in the order of the outline.
    """
    changes: defaultdict[int, defaultdict[int, int]] = defaultdict(lambda: defaultdict(int))
    for one, other in pairwise([*outline, outline[0]]):
        changes[min(one, other)][max(one, other)] += (one < other) - (one > other)
    triangles: list[tuple[int, int, int]] = []
    arriving: defaultdict[int, int] = defaultdict(int)
    reached: list[_Edge] = []  # upwards

    def turn(a: int, b: int, c: int) -> int:
        (x, y), (bx, by), (cx, cy) = flat[a], flat[b], flat[c]
        return (bx - x) * (cy - y) - (by - y) * (cx - x)

    for point, place in enumerate(flat):
        first, last = 0, len(reached)
        while first < last:
            middle = (first + last) // 2
            if reached[middle].side(place) > 0:
                first = middle + 1
            else:
                last = middle
        while last < len(reached) and reached[last].side(place) == 0:
            last += 1
        met = reached[first:last]
        for edge in met:
            arriving[edge.end] -= 1
            if edge.end != point:  # the point touches the edge
                changes[point][edge.end] += edge.change
        leaving = _leaving(point, flat, changes, turn)
        is_disordered = (first and reached[first - 1].side(place) <= 0) or (
            last < len(reached) and reached[last].side(place) >= 0
        )
        if is_disordered or arriving[point]:
            return None
        if not met and not leaving:
            continue

        below = reached[first - 1] if first else _Edge(flat, 0, 0, 0, 0)
        lower: list[int] = []
        upper: list[int] = []
        if met:
            lower, upper = below.front, met[-1].front
        elif below.winding:
            at = below.foremost
            lower, upper = below.front[: at + 1], below.front[at:]
        winding = met[-1].winding if met else below.winding
        if below.winding:
            while len(lower) > 1 and turn(lower[-2], point, lower[-1]) > 0:
                triangles.append((lower[-2], point, lower.pop()))
            lower.append(point)
        for edge in met[:-1]:
            if edge.winding:
                triangles += [(one, point, next_one) for one, next_one in pairwise(edge.front)]
        if winding:
            while len(upper) > 1 and turn(upper[0], point, upper[1]) > 0:
                triangles.append((upper.pop(0), point, upper[0]))
            upper.insert(0, point)

        edges, around = [], below.winding
        for end, change in leaving:
            around += change
            arriving[end] += 1
            edges.append(_Edge(flat, point, end, change, around))
        if around != winding:
            return None
        reached[first:last] = edges
        if edges:
            below.front, below.foremost = lower, len(lower) - 1
            edges[-1].front, edges[-1].foremost = upper, 0
        elif winding:
            below.front, below.foremost = lower + upper[1:], len(lower) - 1
    return triangles


def _leaving(
    point: int,
    flat: _Places,
    changes: defaultdict[int, defaultdict[int, int]],
    turn: Callable[[int, int, int], int],
) -> list[tuple[int, int]]:
    """Return the ends and changes of the edges that leave a point, upwards."""

    def upwards(one: int, other: int) -> int:
        return -turn(point, one, other)

    leaving = changes.pop(point, defaultdict(int))
    while True:
        ends = [end for end, change in leaving.items() if change]
        ends.sort(key=cmp_to_key(upwards))
        for one, other in pairwise(ends):
            near, far = min(one, other), max(one, other)
            if _Edge(flat, point, far, 0, 0).side(flat[near]) == 0:
                # They overlap: the longer edge goes on where the shorter one ends.
                changes[near][far] += leaving[far]
                leaving[near] += leaving.pop(far)
                break
        else:
            return [(end, leaving[end]) for end in ends]
