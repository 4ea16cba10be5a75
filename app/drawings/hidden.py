"""Hidden surfaces and painting order: which parts of faces are visible (of lines: `occlusion`).

Everything is in pixels and depth, where planes stay planes for every lens. Faces are ordered by
what two of them have in common. A face that passes through another one is split there. Lines lie
on all faces: a part behind a translucent face has the colour that it has through that face.
"""

import heapq
import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, islice
from typing import Any, TypeAlias

import numpy as np

from app.drawings.occlusion import BORDER_PX, SAME_DEPTH, Occlusion, Points, ScreenCell, cut
from app.model.refusal import REFUSALS, Refusal

_LEAST_PX2 = 0.01  # of what two faces have in common, or of a face
_IN_PLANE = 1e-7  # of NDC
_MOST_PARTS = 400  # of a translucent face
_MOST_RINGS = 100  # that are broken
_ROUNDS = 12  # in which faces that pass through others are split
MOST_SPLITS = 200  # more than as many as there are faces
MOST_CROSSINGS, MOST_CUTS = 50_000, 1_500_000  # of faces, and of parts of tangled ones
_GRID_PX, _MOST_SQUARES, _AT_ONCE = 64.0, 16, 50_000


def _measure(face: ScreenCell) -> bool:
    """Set a face's plane and box; False if it is seen from its edge."""
    points: list[list[float]] = face.points.tolist()
    count = len(points)
    x, y, z = (sum(point[axis] for point in points) / count for axis in range(3))
    across = along = up = 0.0
    for (p, q, r), (s, t, u) in zip(points, [*points[1:], points[0]], strict=True):
        p, q, r, s, t, u = p - x, q - y, r - z, s - x, t - y, u - z
        across, along, up = across + q * u - r * t, along + r * s - p * u, up + p * t - q * s
    if abs(up) < 2.0 * _LEAST_PX2:
        return False
    if up < 0.0:
        points.reverse()
        face.points = face.points[::-1]
    a, b = -across / up, -along / up
    face.plane = a, b, z - a * x - b * y
    lows, highs = zip(*((min(side), max(side)) for side in zip(*points, strict=True)), strict=True)
    face.low, face.high = lows, highs
    face.flat = [(point[0], point[1]) for point in points]
    return True


def _joined(faces: list[ScreenCell]) -> list[ScreenCell]:
    """Join neighbours of one colour that lie in a plane, as long as they stay convex."""
    at_edge: dict[object, ScreenCell] = {}
    gone: set[int] = set()
    waiting = [*reversed(faces)]
    whole: dict[int, ScreenCell] = {}
    while waiting:
        face = waiting.pop()
        corners = [(round(x, 3), round(y, 3)) for x, y in face.flat]
        kind = face.place[0], face.colour, face.opacity
        for i, begin in enumerate(corners):
            end = corners[(i + 1) % len(corners)]
            other = at_edge.get((kind, end, begin))
            if other is None or id(other) in gone:
                continue
            joined = _union(face, i, other, end)
            if joined is not None:
                gone.add(id(other))
                whole.pop(id(other))
                waiting.append(joined)
                break
        else:
            whole[id(face)] = face
            at_edge |= {
                (kind, begin, corners[(i + 1) % len(corners)]): face
                for i, begin in enumerate(corners)
            }
    return sorted(whole.values(), key=lambda each: each.place)


def _union(
    one: ScreenCell, edge: int, other: ScreenCell, begin: tuple[float, float]
) -> ScreenCell | None:
    """Join two faces at an edge; None if they are not in a plane, or not convex together."""
    a, b, c = one.plane
    if any(abs(a * x + b * y + c - z) > _IN_PLANE for x, y, z in other.points.tolist()):
        return None
    mine = np.roll(one.points, -edge - 1, axis=0).tolist()
    corners = [(round(x, 3), round(y, 3)) for x, y in other.flat]
    theirs = np.roll(other.points, -corners.index(begin) - 1, axis=0).tolist()
    # From the edge's end round the one face to its begin, and on round the other.
    points = [*mine, *theirs[1:-1]]
    kept = []
    for i, (x, y, z) in enumerate(points):
        (p, q, _), (s, t, _) = points[i - 1], points[(i + 1) % len(points)]
        turn = (x - p) * (t - y) - (y - q) * (s - x)
        if turn < -_LEAST_PX2:
            return None
        if turn > _LEAST_PX2:
            kept.append((x, y, z))
    joined = replace(one, points=np.array(kept), place=min(one.place, other.place), flat=[])
    return joined if len(kept) > 2 and _measure(joined) else None


def common(one: ScreenCell, other: ScreenCell) -> Points:
    """Return the intersection of two convex faces on the screen."""
    part, around = one.flat, other.flat
    for i, begin in enumerate(around):
        part = _half(part, begin, around[(i + 1) % len(around)])
        if len(part) < 3:
            return []
    return part if _area(part) > _LEAST_PX2 else []


def _area(part: Points) -> float:
    around = zip(part, [*part[1:], part[0]], strict=True)
    return abs(sum(p * s - q * r for (p, q), (r, s) in around)) / 2.0


def _apart(one: ScreenCell, other: ScreenCell, part: Points) -> tuple[float, float]:
    """The least and the largest of how much farther one face is than another."""
    a, b, c = (p - q for p, q in zip(one.plane, other.plane, strict=True))
    away = [a * x + b * y + c for x, y in part]
    return min(away), max(away)


def _pairs(faces: Sequence[ScreenCell], fresh: Any) -> Iterator[tuple[int, int]]:
    """Yield the pairs of faces that may have something in common, one of them at least `fresh`.

    A grid finds those whose boxes overlap; then a line between two faces may separate them.
    """
    low = np.array([face.low[:2] for face in faces])
    high = np.array([face.high[:2] for face in faces])
    first = np.floor(low / _GRID_PX).astype(np.int64)
    last = np.floor(high / _GRID_PX).astype(np.int64)
    spans = (last - first + 1).prod(axis=1)
    wide = np.flatnonzero(spans > _MOST_SQUARES)
    blocks = [np.empty((0, 2), dtype=np.int64)]
    rank = np.full(len(faces), -1)
    rank[wide] = np.arange(len(wide))
    for i in wide.tolist():  # with all that are not wide, and with the wide ones after it
        meet = (low < high[i]).all(axis=1) & (high > low[i]).all(axis=1)
        meet &= (rank < 0) | (rank > rank[i])
        others = np.flatnonzero(meet)
        blocks.append(np.stack([np.full(len(others), i), others], axis=1))
    squares: dict[tuple[int, int], list[int]] = {}
    for i in np.flatnonzero(spans <= _MOST_SQUARES).tolist():
        (x, y), (to_x, to_y) = first[i].tolist(), last[i].tolist()
        for square in ((a, b) for a in range(x, to_x + 1) for b in range(y, to_y + 1)):
            squares.setdefault(square, []).append(i)
    for square, members in squares.items():
        here = np.array(members)
        meet = (low[here][:, None] < high[here]).all(axis=2)
        meet &= meet.T
        # Each pair counts in one square: that of the lower left corner of what they have in common.
        corner = np.maximum(first[here][:, None], first[here])
        meet &= (corner == square).all(axis=2)
        ones, others = np.nonzero(np.triu(meet, 1))
        blocks.append(np.stack([here[ones], here[others]], axis=1))
    pairs = np.concatenate(blocks)
    pairs = pairs[fresh[pairs].any(axis=1)]
    for begin in range(0, len(pairs), _AT_ONCE):
        some = pairs[begin : begin + _AT_ONCE]
        yield from some[~_separated(faces, some)].tolist()


def _separated(faces: Sequence[ScreenCell], pairs: Any) -> Any:
    """Whether an edge of one of two faces separates them, for each pair; (n, 2) to (n,)."""
    most = 4
    used, places = np.unique(pairs, return_inverse=True)
    corners = np.zeros((len(used), most, 2))
    small = np.zeros(len(used), dtype=np.bool_)
    for row, i in enumerate(used.tolist()):
        flat = faces[i].flat
        small[row] = len(flat) <= most
        corners[row] = [*flat[:most], *[flat[-1]] * (most - len(flat))]
    places = places.reshape(-1, 2)
    apart = np.zeros(len(pairs), dtype=np.bool_)
    both = small[places].all(axis=1)
    for one, other in ((0, 1), (1, 0)):
        mine, others = corners[places[:, one]], corners[places[:, other]]
        edges = np.roll(mine, -1, axis=1) - mine
        lengths = np.hypot(edges[..., 0], edges[..., 1])
        away = others[:, None] - mine[:, :, None]
        inside = edges[..., 0, None] * away[..., 1] - edges[..., 1, None] * away[..., 0]
        apart |= ((inside.max(axis=2) < BORDER_PX * lengths) & (lengths > 0.0)).any(axis=1)
    return apart & both


_Relation: TypeAlias = tuple[int, int, float, float]
"""Two faces with something in common, and how much farther the first is: least and most."""


def in_order(
    faces: Iterable[ScreenCell], watch: Callable[[], None] = lambda: None
) -> list[ScreenCell]:
    """Return faces from the back to the front; without those that are seen from their edges.

    Faces that pass through others are split, and so is one of each ring in which every face is
    before the next. Where that takes too many splits, which are as many at least as faces that
    cross, they become tangled. `watch` is called now and then, and may raise an exception.
    """
    faces = _joined([face for face in faces if _measure(face)])
    most_faces = 2 * len(faces) + MOST_SPLITS
    relations = list[_Relation]()
    fresh = np.ones(len(faces), dtype=np.bool_)
    for left in reversed(range(_ROUNDS)):
        crossing: dict[int, list[int]] = {}
        count = len(faces)
        for i, j, least, most in _related(faces, fresh, watch):
            relations.append((i, j, least, most))
            is_opaque = faces[i].is_opaque
            if least < -SAME_DEPTH and most > SAME_DEPTH and (is_opaque or faces[j].is_opaque):
                first, last = (i, j) if is_opaque else (j, i)
                crossing.setdefault(first, []).append(last)
                count += 1
                if count > MOST_CROSSINGS + most_faces:
                    raise Refusal.in_document(REFUSALS["tangled"], field="scene")
        if count > most_faces:
            tangled = {*crossing}.union(*crossing.values())
            for i in tangled:
                faces[i].is_tangled = True
            relations = [each for each in relations if not tangled.intersection(each[:2])]
            break
        fresh = _split_some(faces, crossing) if left else np.zeros(0, dtype=np.bool_)
        if not fresh.any():
            break
        relations = [each for each in relations if not (fresh[each[0]] or fresh[each[1]])]
    order, ring = _sorted(faces, relations)
    for _ in range(_MOST_RINGS):
        if not ring:
            break
        tries = (_split_some(faces, {i: ring}) for i in ring)
        fresh = next(filter(np.any, tries), fresh[:0])
        if not fresh.any():
            break
        relations = [each for each in relations if not (fresh[each[0]] or fresh[each[1]])]
        relations += _related(faces, fresh, watch)
        order, ring = _sorted(faces, relations)
    return order


def _related(
    faces: Sequence[ScreenCell], fresh: Any, watch: Callable[[], None]
) -> Iterator[_Relation]:
    """Yield how the faces lie to each other that have something in common, and one is `fresh`."""
    for i, j in _pairs(faces, fresh) if len(faces) else ():
        watch()
        part = common(faces[i], faces[j])
        if part:
            yield (i, j, *_apart(faces[i], faces[j], part))


def _split_some(faces: list[ScreenCell], by: Mapping[int, Sequence[int]]) -> Any:
    """Split each of some faces by the first of others whose plane does; return which are new."""
    changed, added = list[int](), list[ScreenCell]()
    for i, others in by.items():
        splits = (_split(faces[i], faces[j]) for j in others)
        pieces = next((pieces for pieces in splits if len(pieces) == 2), None)
        if pieces is not None:
            faces[i] = pieces[0]
            changed.append(i)
            added.append(pieces[1])
    faces += added
    fresh = np.zeros(len(faces), dtype=np.bool_)
    fresh[[*changed, *range(len(faces) - len(added), len(faces))]] = True
    return fresh


def _sorted(
    faces: Sequence[ScreenCell], relations: Iterable[_Relation]
) -> tuple[list[ScreenCell], list[int]]:
    """Return faces from the back to the front, and a ring of them if there is one.

    In a ring each face must come before the next, and the order is a guess. Two translucent faces
    are blended in the order of drawing, as are two opaque ones of the same depth; but in a ring
    that order is given up first.
    """
    after: list[list[tuple[int, bool]]] = [[] for _ in faces]
    before: list[list[int]] = [[] for _ in faces]
    waits: list[list[int]] = [[0, 0] for _ in faces]
    for i, j, least, most in relations:
        one, other = faces[i], faces[j]
        both = not (one.is_opaque or other.is_opaque)
        is_soft = both or max(abs(least), abs(most)) < SAME_DEPTH
        is_before = one.place < other.place if is_soft else least + most > 0.0
        first, last = (i, j) if is_before else (j, i)
        after[first].append((last, is_soft))
        waits[last][is_soft] += 1
        if not is_soft:
            before[last].append(first)
    order, ring, is_done = list[ScreenCell](), list[int](), [False] * len(faces)
    ready = [(-_middle(face), i) for i, face in enumerate(faces) if waits[i] == [0, 0]]
    heapq.heapify(ready)
    while len(order) < len(faces):
        if ready:
            _, i = heapq.heappop(ready)
        else:
            rest = (i for i, done in enumerate(is_done) if not done)
            hard, _, i = min((waits[i][False], -_middle(faces[i]), i) for i in rest)
            if hard and not ring:
                ring = _ring(i, before, is_done)
        if is_done[i]:
            continue
        is_done[i] = True
        order.append(faces[i])
        for j, is_soft in after[i]:
            waits[j][is_soft] -= 1
            if waits[j] == [0, 0] and not is_done[j]:
                heapq.heappush(ready, (-_middle(faces[j]), j))
    return order, ring


def _ring(start: int, before: Sequence[Sequence[int]], is_done: Sequence[bool]) -> list[int]:
    """Return a ring of faces that are not done, each before the one that precedes it here."""
    path, at = list[int](), start
    while at not in path:
        path.append(at)
        at = next(each for each in before[at] if not is_done[each])
    return path[path.index(at) :]


def visible(
    faces: list[ScreenCell], watch: Callable[[], None] = lambda: None
) -> Iterator[tuple[ScreenCell, list[Points]]]:
    """Yield faces from the back to the front, with what of them has to be drawn.

    Translucent faces are blended in the order of drawing. Where an opaque one between two of them
    asks for the other order, they follow at the end, without what opaque faces hide of them. So do
    tangled faces, and all translucent ones after them.
    """
    place = {id(face): number for number, face in enumerate(faces)}
    late = [face for face in faces if not face.is_opaque]
    opaque = [face for face in faces if face.is_opaque]
    tangled = [face for face in opaque if face.is_tangled]
    if not tangled:
        wrong = [
            max(one.place, other.place)
            for one, other in combinations(late, 2)
            if (one.place < other.place) != (place[id(one)] < place[id(other)])
            and common(one, other)
        ]
        late = [face for face in late if wrong and face.place >= min(wrong)]
    # What is large hides most: the less is left, the less is cut by those that follow.
    before = Occlusion(sorted(opaque, key=lambda each: -_area(each.flat)))
    ends, work = list[tuple[ScreenCell, list[Points]]](), iter(range(MOST_CUTS))
    for face in [*tangled, *sorted(late, key=lambda each: each.place)]:
        watch()
        ends.append((face, _without(face, before.before(face.points), work)))
        if tangled and next(work, None) is None:
            raise Refusal.in_document(REFUSALS["tangled"], field="scene")
    if any(len(rings) > _MOST_PARTS for _, rings in ends) and not tangled:
        ends = []
    taken = {id(face) for face, _ in ends}
    yield from ((face, [face.flat]) for face in faces if id(face) not in taken)
    yield from ((face, rings) for face, rings in ends if rings)


def _without(face: ScreenCell, others: Iterable[ScreenCell], work: Iterator[int]) -> list[Points]:
    """Return the parts of a face that no opaque face hides, convex, while there is `work`."""
    rings = [face.flat]
    for other in others:
        part = common(face, other) if rings else []
        if not part:
            continue
        least, most = _apart(face, other, part)
        if max(abs(least), abs(most)) < SAME_DEPTH:
            is_before = other.place > face.place
        else:
            is_before = least + most > 0.0
        hole = other.flat
        if least < -SAME_DEPTH and most > SAME_DEPTH:
            a, b, c = (p - q for p, q in zip(face.plane, other.plane, strict=True))
            length = math.hypot(a, b)
            x, y = -c * a / length**2, -c * b / length**2
            hole = _half(hole, (x, y), (x + b / length, y - a / length))
        elif not is_before:
            continue
        if sum(1 for _ in islice(work, len(rings))) < len(rings):
            break
        rings = [part for ring in rings for part in _outside(ring, hole)]
    return rings


def _outside(ring: Points, hole: Points) -> list[Points]:
    """Return the parts of a convex polygon outside of another one; all of it if they are apart."""
    parts, inside = list[Points](), ring
    for begin, end in zip(hole, [*hole[1:], hole[0]], strict=True):
        outside = _half(inside, end, begin)
        inside = _half(inside, begin, end)
        if len(inside) < 3:
            return [ring]
        if len(outside) > 2 and _area(outside) > _LEAST_PX2:
            parts.append(outside)
    return parts


def _half(part: Points, begin: tuple[float, float], end: tuple[float, float]) -> Points:
    """Return the part of a convex polygon on the left of a line."""
    (x, y), (to_x, to_y) = begin, end
    dx, dy = to_x - x, to_y - y
    sides = [dx * (q - y) - dy * (p - x) for p, q in part]
    if min(sides) >= 0.0:
        return part
    if max(sides) <= 0.0:
        return []
    kept = []
    for j, here in enumerate(sides):
        k = (j + 1) % len(sides)
        there = sides[k]
        if here >= 0.0:
            kept.append(part[j])
        if (here >= 0.0) != (there >= 0.0):
            t = here / (here - there)
            (p, q), (r, s) = part[j], part[k]
            kept.append((p + t * (r - p), q + t * (s - q)))
    return kept


def _middle(face: ScreenCell) -> float:
    return (face.low[2] + face.high[2]) / 2.0


def _split(face: ScreenCell, other: ScreenCell) -> list[ScreenCell]:
    a, b, c = (p - q for p, q in zip(face.plane, other.plane, strict=True))
    points = np.column_stack([face.points, np.ones(len(face.points))])
    if np.abs(points @ (a, b, 0.0, c)).max() < SAME_DEPTH:
        return [face]
    pieces = []
    for side in (1.0, -1.0):
        part = cut(points, side * np.array([a, b, 0.0, c]), True)
        if len(part) >= 3:
            piece = replace(face, points=part[:, :3], flat=[])
            if _measure(piece):
                piece.plane = face.plane
                pieces.append(piece)
    return pieces
