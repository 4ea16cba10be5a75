"""A pane as shapes instead of pixels: what its actors show, with what is hidden taken away.

The shapes are read from a pane that has been drawn::

    actors --> cells in clip coordinates of the pane's camera, float64
           --> cut by near, far and frame, before the divide
           --> (x, y, depth) on the screen, where planes stay planes for every lens
           --> faces from the back to the front; lines where no face hides them

Faces are ordered by what two of them have in common on the screen. A face that passes through
another one is split there. Lines lie on all faces: a part behind a translucent face has the colour
that it has through that face. Where shaders make the picture, its pixels are one shape.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations, pairwise
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkActor, vtkActor2D

from app.drawings.actors import PAPER, FlatActor
from app.drawings.label import Label, LabelActor, Written
from app.drawings.off_screen import Pixels, pixels_of
from app.model.projection import Array
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal

MOST_CELLS = 50_000
"""More cells than this make a file that no program opens gladly."""
TOO_MANY = QT_TRANSLATE_NOOP(
    "Refusal", "has {0} faces and lines in a pane; the limit of a figure without pixels is {1}: "
    "write it as .png"
)  # fmt: skip

_FRAME = np.array(
    [(0, 0, 1, 1), (0, 0, -1, 1), (1, 0, 0, 1), (-1, 0, 0, 1), (0, 1, 0, 1), (0, -1, 0, 1)],
    dtype=np.float64,
)
"""Near, far, left, right, bottom and top of clip space; positive inside."""
_OPAQUE = 0.995
_LEAST_PX2 = 0.01  # of what two faces have in common, or of a face
_IN_PLANE = 1e-7  # of NDC
_SAME_DEPTH = 1e-9  # of NDC; a line that lies in a face is drawn
_BORDER_PX = 1e-3
_MOST_PARTS = 400  # of a translucent face
_MOST_RINGS = 100  # that are broken
_ROUNDS = 12  # in which faces that pass through others are split
_GRID_PX, _MOST_SQUARES, _AT_ONCE = 64.0, 16, 50_000

Colour: TypeAlias = tuple[float, float, float]
"""Red, green and blue, 0 to 1."""
Points: TypeAlias = list[tuple[float, float]]


class Area(NamedTuple):
    """Filled polygons; in pixels from the figure's left and top, as all shapes."""

    rings: list[Points]
    colour: Colour
    opacity: float


class Stroke(NamedTuple):
    """A line of a width in pixels."""

    points: Points
    colour: Colour
    opacity: float
    width: float


class Disc(NamedTuple):
    centre: tuple[float, float]
    radius: float
    colour: Colour
    opacity: float


class Text(NamedTuple):
    """A label: where its line of writing begins, and its letters' em."""

    written: Written
    place: tuple[float, float]
    em: float


class Picture(NamedTuple):
    """Pixels, where only shaders know what is drawn: (h, w, 4), and left, top, width, height."""

    pixels: Pixels
    place: tuple[float, float, float, float]


Shape: TypeAlias = Area | Stroke | Disc | Text | Picture


def moved(shape: Shape, right: float, down: float) -> Shape:
    """Return a shape elsewhere."""
    if isinstance(shape, Area):
        rings = [[(x + right, y + down) for x, y in ring] for ring in shape.rings]
        return shape._replace(rings=rings)
    if isinstance(shape, Stroke):
        return shape._replace(points=[(x + right, y + down) for x, y in shape.points])
    if isinstance(shape, Disc):
        return shape._replace(centre=(shape.centre[0] + right, shape.centre[1] + down))
    left, top = shape.place[:2]
    if isinstance(shape, Text):
        return shape._replace(place=(left + right, top + down))
    return shape._replace(place=(left + right, top + down, *shape.place[2:]))


def within(shapes: Iterable[Shape], left: float, right: float) -> Iterator[Shape]:
    """Yield what is between two columns of a figure."""
    for shape in shapes:
        if isinstance(shape, Area):
            rings = [_between(ring, left, right, True) for ring in shape.rings]
            if any(rings):
                yield shape._replace(rings=[ring for ring in rings if ring])
        elif isinstance(shape, Stroke):
            points = _between(shape.points, left, right, False)
            if len(points) > 1:
                yield shape._replace(points=points)
        elif isinstance(shape, Picture):
            x, y, wide, high = shape.place
            per_px = shape.pixels.shape[1] / wide
            first, last = (
                round(per_px * (min(max(side, x), x + wide) - x)) for side in (left, right)
            )
            if first < last:
                place = x + first / per_px, y, (last - first) / per_px, high
                yield Picture(shape.pixels[:, first:last], place)
        else:
            middle = shape.place[0] if isinstance(shape, Text) else shape.centre[0]
            if left <= middle <= right:
                yield shape


def _between(points: Points, left: float, right: float, closed: bool) -> Points:
    count = len(points)
    part = np.column_stack([np.array(points), np.zeros(count), np.ones(count)])
    for plane in ((1.0, 0.0, 0.0, -left), (-1.0, 0.0, 0.0, right)):
        if len(part):
            part = _cut(part, np.array(plane), closed)
    return [(x, y) for x, y in part[:, :2].tolist()]


@dataclass
class _Cell:
    """A polygon, polyline or point on the screen: (n, 3), pixels from left and bottom, depth."""

    points: Array
    colour: Colour
    opacity: float
    place: tuple[int, int]
    """The places of its actor and of itself there: what is drawn later covers what is as near."""
    width: float = 0.0
    plane: tuple[float, float, float] = (0.0, 0.0, 0.0)
    low: tuple[float, float, float] = (0.0, 0.0, 0.0)
    high: tuple[float, float, float] = (0.0, 0.0, 0.0)
    flat: list[tuple[float, float]] = field(default_factory=list)

    @property
    def is_opaque(self) -> bool:
        return self.opacity >= _OPAQUE


def shapes_of(window: Any, finer: int) -> list[Shape]:
    """Return the shapes of a window that has been drawn, `finer` times as large as the figure.

    Raises
    ------
    Refusal
        If there are too many of them.
    """
    height = window.GetSize()[1]
    found: list[Shape] = []
    for renderer in sorted(window.GetRenderers(), key=lambda each: each.GetLayer()):
        if renderer.GetDraw():
            found += _Pane(renderer, height, finer).shapes(window)
    return found


class _Pane:
    """One renderer: its camera, and its rectangle in the window."""

    def __init__(self, renderer: Any, height: int, finer: int) -> None:
        self._renderer, self._height, self._finer = renderer, height, finer
        self._left, self._low = renderer.GetOrigin()
        self._wide, self._high = renderer.GetSize()
        camera, aspect = renderer.GetActiveCamera(), renderer.GetTiledAspectRatio()
        matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0)
        self._clip = _array(matrix)

    def shapes(self, window: Any) -> Iterator[Shape]:
        if not (self._wide and self._high):
            return
        renderer = self._renderer
        if renderer.GetBackgroundAlpha() > 0.0 and not renderer.GetPreserveColorBuffer():
            low, high = (self._left, self._low), (self._left + self._wide, self._low + self._high)
            corners = [low, (high[0], low[1]), high, (low[0], high[1])]
            yield Area([self._placed(corners)], renderer.GetBackground(), 1.0)
        props = [prop for prop in renderer.GetViewProps() if prop.GetVisibility()]
        actors = [prop for prop in props if isinstance(prop, vtkActor)]
        if any(_is_shaded(actor) for actor in actors):
            yield self._picture(window, props)
            actors = [actor for actor in actors if _is_in_front(actor)]
        cells: tuple[list[_Cell], list[_Cell], list[_Cell]] = [], [], []
        all_cells = sum(actor.GetMapper().GetInput().GetNumberOfCells() for actor in actors)
        if all_cells > MOST_CELLS:
            raise Refusal.in_document(TOO_MANY, all_cells, MOST_CELLS, field="scene")
        for place, actor in enumerate(actors):
            self._read(actor, place, cells)
        faces, lines, points = cells
        yield from self._arranged(faces, lines, points)
        for prop in props:
            if isinstance(prop, LabelActor):
                label = prop.label()
                if label is not None:
                    yield self._text(label)
            elif isinstance(prop, vtkActor2D):
                yield from self._flat(prop)

    def _picture(self, window: Any, props: Sequence[Any]) -> Picture:
        """The pixels of all that has a depth; the rest is hidden meanwhile."""
        others = [p for p in props if isinstance(p, vtkActor2D) or _is_in_front(p)]
        for prop in others:
            prop.SetVisibility(False)
        window.Render()
        pixels = pixels_of(window)
        for prop in others:
            prop.SetVisibility(True)
        top = self._height - self._low - self._high
        part = pixels[top : top + self._high, self._left : self._left + self._wide]
        wide, high = (max(1, side // self._finer) for side in (self._wide, self._high))
        blocks = part[: high * self._finer, : wide * self._finer].astype(np.float64)
        blocks = blocks.reshape(high, self._finer, wide, self._finer, -1).mean(axis=(1, 3))
        part = np.rint(blocks).astype(np.uint8)[..., :3]
        place = [side / self._finer for side in (self._left, top, self._wide, self._high)]
        return Picture(part, (place[0], place[1], place[2], place[3]))

    def _placed(self, points: Iterable[Sequence[float]]) -> Points:
        """Pixels of the window, from the bottom, as pixels of the figure, from the top."""
        return [(p[0] / self._finer, (self._height - p[1]) / self._finer) for p in points]

    # -- reading

    def _read(
        self, actor: Any, place: int, cells: tuple[list[_Cell], list[_Cell], list[_Cell]]
    ) -> None:
        mapper = actor.GetMapper()
        mesh = mapper.GetInput()
        if mesh.GetNumberOfPoints() == 0:
            return
        points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(np.float64)  # type: ignore[no-untyped-call]
        world = np.column_stack([points, np.ones(len(points))]) @ _array(actor.GetMatrix()).T
        planes = mapper.GetClippingPlanes()
        count = 0 if planes is None else planes.GetNumberOfItems()
        limits = np.array([_plane(planes.GetItem(i)) for i in range(count)]).reshape(-1, 4)
        properties = actor.GetProperty()
        by_cell, rgba = _colours(mapper, mesh)
        depth, lift, paper = None, 0.0, None
        if isinstance(actor, FlatActor):
            depth, lift, paper = actor.depth, actor.lift, actor.paper
        clip = world @ self._clip.T
        clip[:, 2] -= lift * clip[:, 3]
        if depth is not None:
            clip[:, 2] = depth * clip[:, 3]
        # Everything is cut before the divide, by planes of the pane's world and by its frame.
        both = np.column_stack([clip, world])
        sides = np.vstack(
            [
                np.column_stack([_FRAME, np.zeros_like(_FRAME)]),
                np.column_stack([0.0 * limits, limits]),
            ]
        )
        outside = both @ sides.T < 0.0
        with np.errstate(divide="ignore", invalid="ignore"):
            seen = self._on_screen(clip)
        number = 0
        faces, lines, dots = cells
        for kind, array in (
            (dots, mesh.GetVerts()),
            (lines, mesh.GetLines()),
            (faces, mesh.GetPolys()),
        ):
            for cell in _cells(array):
                colour, opacity = properties.GetColor(), properties.GetOpacity()
                if rgba is not None:
                    own = (rgba[number if by_cell else cell[-1]] / 255.0).tolist()
                    colour, opacity = tuple(own[:3]), opacity * (own[3] if len(own) > 3 else 1.0)
                number += 1
                if paper is not None:
                    r, g, b = (c + PAPER * (p - c) for c, p in zip(colour, paper, strict=True))
                    colour = (r, g, b)
                width = properties.GetLineWidth() if kind is lines else properties.GetPointSize()
                # A polyline may leave the frame and come back: each part is cut by itself.
                is_whole = kind is not lines or not outside[cell].any()
                for piece in [cell] if is_whole else map(list, pairwise(cell)):
                    off = outside[piece]
                    if off.all(axis=0).any():
                        continue
                    points = seen[piece]
                    if off.any():
                        part = both[piece]
                        for side in sides[off.any(axis=0)]:
                            if len(part):
                                part = _cut(part, side, kind is faces)
                        points = self._on_screen(part[part[:, 3] > 0.0, :4])
                    if len(points) >= (3 if kind is faces else 2 if kind is lines else 1):
                        kind.append(_Cell(points, colour, opacity, (place, number), width))

    def _on_screen(self, clip: Array) -> Array:
        """Clip coordinates, (n, 4), as pixels from left and bottom, and depth, (n, 3)."""
        x, y, z = (clip[:, :3] / clip[:, 3:]).T
        px = self._left + (x + 1.0) / 2.0 * self._wide, self._low + (y + 1.0) / 2.0 * self._high
        return np.stack([*px, z], axis=1)

    def _flat(self, actor: Any) -> Iterator[Shape]:
        """The cells of an actor in the plane of the screen."""
        mesh = actor.GetMapper().GetInput()
        if mesh is None or mesh.GetNumberOfPoints() == 0:
            return
        points = vtk_to_numpy(mesh.GetPoints().GetData())[:, :2].astype(np.float64)  # type: ignore[no-untyped-call]
        x, y = actor.GetPositionCoordinate().GetComputedDoubleViewportValue(self._renderer)
        points += self._left + x, self._low + y
        properties = actor.GetProperty()
        colour, opacity = properties.GetColor(), properties.GetOpacity()
        width = properties.GetLineWidth() / self._finer
        for cell in _cells(mesh.GetLines()):
            yield Stroke(self._placed(points[cell].tolist()), colour, opacity, width)
        for cell in _cells(mesh.GetPolys()):
            yield Area([self._placed(points[cell].tolist())], colour, opacity)

    def _text(self, label: Label) -> Text:
        written = label.written
        x, y = written.place
        ((x, y),) = self._placed([(self._left + x, self._low + y)])
        return Text(written, (x, y), written.em / self._finer)

    # -- what hides what

    def _arranged(
        self, faces: list[_Cell], lines: list[_Cell], points: list[_Cell]
    ) -> Iterator[Shape]:
        faces = _ordered(_joined([face for face in faces if _measure(face)]))
        for face, rings in _visible(faces):
            yield Area([self._placed(ring) for ring in rings], face.colour, face.opacity)
        hiding = _Hiding(faces)
        strokes = [piece for line in lines for piece in hiding.seen(line)]
        # Of lines in the same place, the one that is lifted most is seen.
        strokes.sort(key=lambda each: -float(each.points[:, 2].sum()))
        for stroke in strokes:
            width = stroke.width / self._finer
            yield Stroke(self._placed(stroke.points.tolist()), stroke.colour, stroke.opacity, width)
        for point in points:
            if not hiding.hides(point):
                (centre,) = self._placed(point.points[:1].tolist())
                yield Disc(centre, point.width / 2.0 / self._finer, point.colour, point.opacity)


def _is_shaded(actor: Any) -> bool:
    return actor.GetTexture() is not None or (isinstance(actor, FlatActor) and actor.is_shaded)


def _is_in_front(prop: Any) -> bool:
    return isinstance(prop, FlatActor) and prop.depth is not None and prop.depth < 0.0


def _array(matrix: Any) -> Array:
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def _plane(plane: Any) -> Array:
    normal = np.array(plane.GetNormal())
    return np.array([*normal, -normal @ np.array(plane.GetOrigin())])


def _cells(array: Any) -> list[Any]:
    """The indices of the points of each cell."""
    if array is None or array.GetNumberOfCells() == 0:
        return []
    ends = vtk_to_numpy(array.GetOffsetsArray())  # type: ignore[no-untyped-call]
    indices = vtk_to_numpy(array.GetConnectivityArray())  # type: ignore[no-untyped-call]
    return np.split(indices, ends[1:-1])


def _colours(mapper: Any, mesh: Any) -> tuple[bool, Any]:
    """Whether cells have colours, not points; and the colours, (n, 3 or 4) uint8, if any."""
    if not mapper.GetScalarVisibility():
        return False, None
    by_cell = mapper.GetScalarMode() == 4  # VTK_SCALAR_MODE_USE_CELL_FIELD_DATA
    data = mesh.GetCellData() if by_cell else mesh.GetPointData()
    array = data.GetArray(mapper.GetArrayName())
    return by_cell, None if array is None else vtk_to_numpy(array)  # type: ignore[no-untyped-call]


def _cut(points: Array, plane: Array, closed: bool) -> Array:
    """Return the part of a polygon or a polyline on the positive side of a plane; (n, 4)."""
    sides = points @ plane
    if (sides >= 0.0).all():
        return points
    found, count = [], len(points)
    for i in range(count if closed else count - 1):
        j = (i + 1) % count
        if sides[i] >= 0.0:
            found.append(points[i])
        if (sides[i] >= 0.0) != (sides[j] >= 0.0):
            found.append(points[i] + sides[i] / (sides[i] - sides[j]) * (points[j] - points[i]))
    if not closed and sides[-1] >= 0.0:
        found.append(points[-1])
    return np.array(found) if found else np.empty((0, points.shape[1]))


# --------------------------------------------------------------------------- faces


def _measure(face: _Cell) -> bool:
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


def _joined(faces: list[_Cell]) -> list[_Cell]:
    """Join neighbours of one colour that lie in a plane, as long as they stay convex."""
    at_edge: dict[object, _Cell] = {}
    gone: set[int] = set()
    waiting = [*reversed(faces)]
    whole: dict[int, _Cell] = {}
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


def _union(one: _Cell, edge: int, other: _Cell, begin: tuple[float, float]) -> _Cell | None:
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


def _common(one: _Cell, other: _Cell) -> Points:
    """What two convex faces have in common on the screen."""
    part, around = one.flat, other.flat
    for i, begin in enumerate(around):
        part = _half(part, begin, around[(i + 1) % len(around)])
        if len(part) < 3:
            return []
    twice = sum(p * s - q * r for (p, q), (r, s) in zip(part, [*part[1:], part[0]], strict=True))
    return part if abs(twice) > 2.0 * _LEAST_PX2 else []


def _apart(one: _Cell, other: _Cell, part: Points) -> tuple[float, float]:
    """The least and the largest of how much farther one face is than another."""
    a, b, c = (p - q for p, q in zip(one.plane, other.plane, strict=True))
    away = [a * x + b * y + c for x, y in part]
    return min(away), max(away)


def _pairs(faces: Sequence[_Cell], fresh: Any) -> Iterator[tuple[int, int]]:
    """Yield the pairs of faces that may have something in common, one of them at least `fresh`.

    A grid finds those whose boxes overlap; then a line between two faces may separate them.
    """
    low = np.array([face.low[:2] for face in faces])
    high = np.array([face.high[:2] for face in faces])
    first = np.floor(low / _GRID_PX).astype(np.int64)
    last = np.floor(high / _GRID_PX).astype(np.int64)
    spans = (last - first + 1).prod(axis=1)
    wide = np.flatnonzero(spans > _MOST_SQUARES)
    found = [np.empty((0, 2), dtype=np.int64)]
    rank = np.full(len(faces), -1)
    rank[wide] = np.arange(len(wide))
    for i in wide.tolist():  # with all that are not wide, and with the wide ones after it
        meet = (low < high[i]).all(axis=1) & (high > low[i]).all(axis=1)
        meet &= (rank < 0) | (rank > rank[i])
        others = np.flatnonzero(meet)
        found.append(np.stack([np.full(len(others), i), others], axis=1))
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
        found.append(np.stack([here[ones], here[others]], axis=1))
    pairs = np.concatenate(found)
    pairs = pairs[fresh[pairs].any(axis=1)]
    for begin in range(0, len(pairs), _AT_ONCE):
        some = pairs[begin : begin + _AT_ONCE]
        yield from some[~_separated(faces, some)].tolist()


def _separated(faces: Sequence[_Cell], pairs: Any) -> Any:
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
        apart |= ((inside.max(axis=2) < _BORDER_PX * lengths) & (lengths > 0.0)).any(axis=1)
    return apart & both


_Relation: TypeAlias = tuple[int, int, float, float]
"""Two faces with something in common, and how much farther the first is: least and most."""


def _ordered(faces: list[_Cell]) -> list[_Cell]:
    """Return faces from the back to the front.

    Faces that pass through others are split, and so is one of each ring in which every face is
    before the next.
    """
    faces, relations = [*faces], list[_Relation]()
    fresh = np.ones(len(faces), dtype=np.bool_)
    for left in reversed(range(_ROUNDS)):
        found = list(_related(faces, fresh))
        relations += found
        crossing: dict[int, list[int]] = {}
        for i, j, least, most in found:
            is_opaque = faces[i].is_opaque
            if least < -_SAME_DEPTH and most > _SAME_DEPTH and (is_opaque or faces[j].is_opaque):
                first, last = (i, j) if is_opaque else (j, i)
                crossing.setdefault(first, []).append(last)
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
        relations += _related(faces, fresh)
        order, ring = _sorted(faces, relations)
    return order


def _related(faces: Sequence[_Cell], fresh: Any) -> Iterator[_Relation]:
    """Yield how the faces lie to each other that have something in common, and one is `fresh`."""
    for i, j in _pairs(faces, fresh) if len(faces) else ():
        part = _common(faces[i], faces[j])
        if part:
            yield (i, j, *_apart(faces[i], faces[j], part))


def _split_some(faces: list[_Cell], by: Mapping[int, Sequence[int]]) -> Any:
    """Split each of some faces by the first of others whose plane does; return which are new."""
    changed, added = list[int](), list[_Cell]()
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
    faces: Sequence[_Cell], relations: Iterable[_Relation]
) -> tuple[list[_Cell], list[int]]:
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
        is_soft = both or max(abs(least), abs(most)) < _SAME_DEPTH
        is_before = one.place < other.place if is_soft else least + most > 0.0
        first, last = (i, j) if is_before else (j, i)
        after[first].append((last, is_soft))
        waits[last][is_soft] += 1
        if not is_soft:
            before[last].append(first)
    order, ring, is_done = list[_Cell](), list[int](), [False] * len(faces)
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


def _visible(faces: list[_Cell]) -> Iterator[tuple[_Cell, list[Points]]]:
    """Yield faces from the back to the front, with what of them has to be drawn.

    Translucent faces are blended in the order of drawing. Where an opaque one between two of them
    asks for the other order, they follow at the end, without what opaque faces hide of them.
    """
    place = {id(face): number for number, face in enumerate(faces)}
    late = [face for face in faces if not face.is_opaque]
    wrong = [
        max(one.place, other.place)
        for one, other in combinations(late, 2)
        if (one.place < other.place) != (place[id(one)] < place[id(other)]) and _common(one, other)
    ]
    opaque = [face for face in faces if face.is_opaque]
    late = [face for face in late if wrong and face.place >= min(wrong)]
    ends = [(face, _without(face, opaque)) for face in sorted(late, key=lambda each: each.place)]
    if any(len(rings) > _MOST_PARTS for _, rings in ends):
        ends, late = [], []
    taken = {id(face) for face in late}
    yield from ((face, [face.flat]) for face in faces if id(face) not in taken)
    yield from ends


def _without(face: _Cell, others: Iterable[_Cell]) -> list[Points]:
    """What opaque faces before a face leave of it, as convex polygons."""
    rings = [face.flat]
    for other in others:
        part = _common(face, other)
        if not part:
            continue
        least, most = _apart(face, other, part)
        if least + most <= 0.0:  # the other one is behind
            continue
        left = []
        for ring in rings:
            inside = ring
            for i, begin in enumerate(other.flat):
                end = other.flat[(i + 1) % len(other.flat)]
                outside = _half(inside, end, begin)
                inside = _half(inside, begin, end)
                if len(outside) > 2:
                    left.append(outside)
                if len(inside) < 3:
                    break
        rings = left
        if len(rings) > _MOST_PARTS:
            break
    return rings


def _half(part: Points, begin: tuple[float, float], end: tuple[float, float]) -> Points:
    """What of a convex polygon is on the left of a line."""
    (x, y), (to_x, to_y) = begin, end
    dx, dy = to_x - x, to_y - y
    sides = [dx * (q - y) - dy * (p - x) for p, q in part]
    if min(sides) >= 0.0:
        return part
    if max(sides) <= 0.0:
        return []
    found = []
    for j, here in enumerate(sides):
        k = (j + 1) % len(sides)
        there = sides[k]
        if here >= 0.0:
            found.append(part[j])
        if (here >= 0.0) != (there >= 0.0):
            t = here / (here - there)
            (p, q), (r, s) = part[j], part[k]
            found.append((p + t * (r - p), q + t * (s - q)))
    return found


def _middle(face: _Cell) -> float:
    return (face.low[2] + face.high[2]) / 2.0


def _split(face: _Cell, other: _Cell) -> list[_Cell]:
    """Split a face by another one's plane."""
    a, b, c = (p - q for p, q in zip(face.plane, other.plane, strict=True))
    points = np.column_stack([face.points, np.ones(len(face.points))])
    if np.abs(points @ (a, b, 0.0, c)).max() < _SAME_DEPTH:
        return [face]
    pieces = []
    for side in (1.0, -1.0):
        part = _cut(points, side * np.array([a, b, 0.0, c]), True)
        if len(part) >= 3:
            piece = replace(face, points=part[:, :3], flat=[])
            if _measure(piece):
                piece.plane = face.plane
                pieces.append(piece)
    return pieces


# --------------------------------------------------------------------------- lines


class _Hiding:
    """What faces hide of lines and points, and through which ones they are seen."""

    def __init__(self, faces: Sequence[_Cell]) -> None:
        self._faces = faces
        self._low = np.array([face.low for face in faces]).reshape(-1, 3)
        self._high = np.array([face.high for face in faces]).reshape(-1, 3)

    def _before(self, points: Array) -> list[_Cell]:
        """The faces whose boxes reach before a box."""
        low, high = points.min(axis=0), points.max(axis=0)
        meet = (self._low[:, :2] <= high[:2]).all(axis=1) & (self._high[:, :2] >= low[:2]).all(
            axis=1
        )
        meet &= self._low[:, 2] < high[2]
        return [self._faces[i] for i in np.flatnonzero(meet).tolist()]

    def hides(self, point: _Cell) -> bool:
        ends = np.concatenate([point.points[:1]] * 2)
        return any(face.is_opaque and _covered(face, *ends.tolist()) for face in self._before(ends))

    def seen(self, line: _Cell) -> Iterator[_Cell]:
        """Yield the parts of a polyline that are seen, in the colours in which they are seen."""
        for begin, end in zip(line.points[:-1], line.points[1:], strict=True):
            tints, hidden = list[tuple[float, float, _Cell]](), list[tuple[float, float]]()
            for face in sorted(self._before(np.stack([begin, end])), key=lambda each: each.place):
                part = _covered(face, begin.tolist(), end.tolist())
                if part is not None and face.is_opaque:
                    hidden.append(part)
                elif part is not None:
                    tints.append((*part, face))
            for first, last in _rest(hidden):
                marks = sorted(
                    {first, last, *(t for tint in tints for t in tint[:2] if first < t < last)}
                )
                for low, high in pairwise(marks):
                    colour = line.colour
                    for start, stop, face in tints:
                        if start <= low and high <= stop:
                            r, g, b = (
                                c + face.opacity * (f - c)
                                for c, f in zip(colour, face.colour, strict=True)
                            )
                            colour = (r, g, b)
                    ends = np.stack([begin + low * (end - begin), begin + high * (end - begin)])
                    yield replace(line, points=ends, colour=colour)


def _covered(
    face: _Cell, begin: Sequence[float], end: Sequence[float]
) -> tuple[float, float] | None:
    """Return from where to where a segment runs behind a face, from 0 to 1; None if nowhere."""
    first, last = 0.0, 1.0
    corners = face.flat
    limits = []
    for i, (x, y) in enumerate(corners):
        to_x, to_y = corners[(i + 1) % len(corners)]
        dx, dy = to_x - x, to_y - y
        border = _BORDER_PX * (abs(dx) + abs(dy))
        limits.append(
            (
                dx * (begin[1] - y) - dy * (begin[0] - x) - border,
                dx * (end[1] - y) - dy * (end[0] - x) - border,
            )
        )
    a, b, c = face.plane
    limits.append(
        (
            begin[2] - a * begin[0] - b * begin[1] - c - _SAME_DEPTH,
            end[2] - a * end[0] - b * end[1] - c - _SAME_DEPTH,
        )
    )
    for here, there in limits:
        if here <= 0.0 and there <= 0.0:
            return None
        if here < 0.0:
            first = max(first, here / (here - there))
        elif there < 0.0:
            last = min(last, here / (here - there))
        if last < first:
            return None
    return first, last


def _rest(hidden: Sequence[tuple[float, float]]) -> Iterator[tuple[float, float]]:
    """Yield what intervals leave of that from 0 to 1."""
    at = 0.0
    for first, last in sorted(hidden):
        if first > at + 1e-9:
            yield at, first
        at = max(at, last)
    if at < 1.0 - 1e-9:
        yield at, 1.0
