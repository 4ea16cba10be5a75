"""A pane as shapes instead of pixels: the visible parts of what its actors draw.

The shapes are read from a pane that has been drawn::

    actors --> cells in clip coordinates of the pane's camera, float64
           --> cut by near, far and frame, before the divide
           --> (x, y, depth) on the screen, where planes stay planes for every lens
           --> what is seen of them (`app.drawings.hidden`), as shapes

Where shaders make the picture, its pixels are one shape.
"""

import math
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import pairwise
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkActor, vtkActor2D

from app.document.lengths import PX_PER
from app.drawings.actors import PAPER, FlatActor
from app.drawings.hidden import in_order, visible
from app.drawings.label import LabelActor, LabelText, SceneLabel
from app.drawings.occlusion import Colour, Occlusion, Points, ScreenCell, cut
from app.drawings.off_screen import Pixels, pixels_of
from app.drawings.style import hexadecimal, rgb
from app.lecture.typesetting import piece_of
from app.model.projection import Array
from app.model.refusal import REFUSALS, Refusal
from app.scenes.shapes import GRID_AXIS_RGB, GRID_RGB

MOST_DOTS = 5_000  # most dots of a cloud that are circles; pixels show a larger one
MOST_CELLS = 50_000  # most cells of a figure: viewers become slow above this

_WIDTHS = [mm * PX_PER["mm"] for mm in (0.13, 0.18, 0.25, 0.35, 0.5, 0.7, 1.0, 1.4, 2.0)]
"""The widths of ISO 128 in pixels, each half of the one after the next."""
_WIDE = _WIDTHS[2]  # beside lines that are hidden, which are half as wide
_GROUND = [tuple(level / 255.0 for level in rgb) for rgb in (GRID_RGB, GRID_AXIS_RGB)]

_PALE = 0.7  # of each of its parts: a colour on which a halo need not be white

_FRAME = np.array(  # near, far, left, right, bottom and top of clip space; positive inside
    [(0, 0, 1, 1), (0, 0, -1, 1), (1, 0, 0, 1), (-1, 0, 0, 1), (0, 1, 0, 1), (0, -1, 0, 1)],
    dtype=np.float64,
)
_CIRCLE = np.exp(np.arange(48) * math.tau * 1j / 48.0).view(np.float64).reshape(-1, 2)


class Area(NamedTuple):
    """Filled polygons; in pixels from the figure's left and top, as all shapes."""

    rings: list[Points]
    colour: Colour
    opacity: float


class LineShape(NamedTuple):
    points: Points
    colour: Colour
    opacity: float
    width: float
    dash: tuple[float, float] | None = None  # length of a dash and of a gap in pixels


class Disc(NamedTuple):
    centre: tuple[float, float]
    radius: float
    colour: Colour
    opacity: float


class TextShape(NamedTuple):
    """A label: where its baseline begins, and its letters' em."""

    written: LabelText
    place: tuple[float, float]
    em: float


class PixelShape(NamedTuple):
    """Pixels, where only shaders know what is drawn: (h, w, 4), and left, top, width, height.

    Those of a cloud lie over the faces and lines.
    """

    pixels: Pixels
    place: tuple[float, float, float, float]
    is_cloud: bool = False


Shape: TypeAlias = Area | LineShape | Disc | TextShape | PixelShape
_Cells: TypeAlias = tuple[list[ScreenCell], list[ScreenCell], list[ScreenCell]]


def moved(shape: Shape, right: float, down: float, larger: float = 1.0) -> Shape:
    """Move a shape after its places are scaled; letters, dots and the widths of lines are not."""

    def at(points: Points) -> Points:
        return [(larger * x + right, larger * y + down) for x, y in points]

    if isinstance(shape, Area):
        return shape._replace(rings=[*map(at, shape.rings)])
    if isinstance(shape, LineShape):
        return shape._replace(points=at(shape.points))
    if isinstance(shape, Disc):
        return shape._replace(centre=at([shape.centre])[0])
    if isinstance(shape, TextShape):
        return shape._replace(place=at([shape.place])[0])
    (place,), (wide, high) = at([shape.place[:2]]), shape.place[2:]
    return shape._replace(place=(*place, larger * wide, larger * high))


def within(shapes: Iterable[Shape], left: float, right: float) -> Iterator[Shape]:
    """Yield the parts of a shape between two columns of a figure."""
    for shape in shapes:
        if isinstance(shape, Area):
            rings = [_between(ring, left, right, True) for ring in shape.rings]
            if any(rings):
                yield shape._replace(rings=[ring for ring in rings if ring])
        elif isinstance(shape, LineShape):
            points = _between(shape.points, left, right, False)
            if len(points) > 1:
                yield shape._replace(points=points)
        elif isinstance(shape, PixelShape):
            x, y, wide, high = shape.place
            per_px = shape.pixels.shape[1] / wide
            first, last = (
                round(per_px * (min(max(side, x), x + wide) - x)) for side in (left, right)
            )
            if first < last:
                place = x + first / per_px, y, (last - first) / per_px, high
                yield shape._replace(pixels=shape.pixels[:, first:last], place=place)
        else:
            middle = shape.place[0] if isinstance(shape, TextShape) else shape.centre[0]
            if left <= middle <= right:
                yield shape


def box_of(shapes: Iterable[Shape], background: str) -> tuple[float, float, float, float] | None:
    """Return left, top, right and bottom of the shapes that are seen; None if there are none."""
    corners = list[tuple[float, float]]()
    empty = rgb(background) if background else None
    for shape in shapes:
        if isinstance(shape, Area):
            if shape.colour != empty:
                corners += (point for ring in shape.rings for point in ring)
        elif isinstance(shape, LineShape):
            corners += _padded(shape.points, shape.width / 2.0)
        elif isinstance(shape, Disc):
            corners += _padded([shape.centre], shape.radius)
        elif isinstance(shape, TextShape):
            corners += _around(shape)
        else:
            left, top, wide, high = shape.place
            corners += (left, top), (left + wide, top + high)
    if not corners:
        return None
    xs, ys = zip(*corners, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def tinted(shapes: Iterable[Shape], background: str) -> Iterator[Shape]:
    """Yield shapes; the halo of a label on a pale tint has its colour: it would be a white spot."""
    areas = list[tuple[Points, Area]]()
    for shape in shapes:
        if isinstance(shape, Area):
            ends = np.concatenate([np.array(ring) for ring in shape.rings])
            areas.append(([ends.min(axis=0).tolist(), ends.max(axis=0).tolist()], shape))
        elif isinstance(shape, TextShape):
            corners = np.array([*_around(shape)]).reshape(-1, 2)
            low, high = corners.min(axis=0), corners.max(axis=0)
            spots = [(low + part * (high - low)).tolist() for part in (0.3, 0.5, 0.7)]
            tints = Counter(_behind(areas, x, y, background) for x, y in spots)
            ((tint, _),) = tints.most_common(1)
            if min(rgb(tint)) >= _PALE:
                shape = shape._replace(written=shape.written._replace(halo=tint))
        yield shape


def _behind(areas: Sequence[tuple[Points, Area]], x: float, y: float, background: str) -> str:
    """The colour of the areas at a point, one over the other."""
    seen = np.array(rgb(background))
    for ((left, top), (right, low)), area in areas:
        if left < x < right and top < y < low:
            rings = [np.array(ring) @ (1.0, 1.0j) - complex(x, y) for ring in area.rings]
            turned = (float(np.angle(np.roll(ring, -1) / ring).sum()) for ring in rings)
            if sum(round(angle / math.tau) for angle in turned) % 2:
                seen += area.opacity * (np.array(area.colour) - seen)
    return hexadecimal(seen.tolist())


def _padded(points: Points, half: float) -> Iterator[tuple[float, float]]:
    for x, y in points:
        yield from ((x - half, y - half), (x + half, y + half))


def _around(text: TextShape) -> Iterator[tuple[float, float]]:
    """Yield the corners of the letters' boxes."""
    (x, y), turn = text.place, text.written.turn
    cos, sin = math.cos(turn), math.sin(turn)
    for piece, is_tex, size, at in text.written.pieces:
        drawn = piece_of(piece, is_tex)
        if not len(drawn.vertices):
            continue
        left, low, right, high = drawn.box
        for along, up in ((left, low), (right, low), (left, high), (right, high)):
            along, up = text.em * (at + size * along), text.em * size * up
            yield x + cos * along - sin * up, y - sin * along - cos * up


def _between(points: Points, left: float, right: float, closed: bool) -> Points:
    count = len(points)
    part = np.column_stack([np.array(points), np.zeros(count), np.ones(count)])
    for plane in ((1.0, 0.0, 0.0, -left), (-1.0, 0.0, 0.0, right)):
        if len(part):
            part = cut(part, np.array(plane), closed)
    return [(x, y) for x, y in part[:, :2].tolist()]


def shapes_of(
    window: Any,
    finer: int,
    hidden: str = "none",
    grey: Colour = (0.6, 0.6, 0.6),
    watch: Callable[[], None] = lambda: None,
) -> list[Shape]:
    """Return the shapes of a window that has been drawn, `finer` times as large as the figure.

    What faces hide of lines is left out, dashed, or in `grey`, as `hidden` says (one of "none",
    "dashed" and "grey"). `watch` is called now and then, and may raise an exception. Raises a
    `Refusal` if there are too many of them.
    """
    height = window.GetSize()[1]
    panes = [
        _VectorPane(each, height, finer, hidden, grey, watch)
        for each in sorted(window.GetRenderers(), key=lambda each: each.GetLayer())
        if each.GetDraw() and all(each.GetSize())
    ]
    # Backgrounds first: what a layer draws lies beside the layers above it, as a frame does.
    shapes: list[Shape] = [area for pane in panes for area in pane.background()]
    drawn = [shape for pane in panes for shape in pane.shapes(window)]
    # Pixels next: the frame of an image lies over their edges.
    return shapes + sorted(
        drawn, key=lambda shape: not isinstance(shape, PixelShape) or shape.is_cloud
    )


def refuse_too_many(window: Any) -> None:
    """Raise the `Refusal` of `shapes_of` that is certain before a window is drawn."""
    for renderer in window.GetRenderers():
        _, actors = _shown_in(renderer)
        if not any(map(_is_shaded, actors)):
            _refuse_too_many(actors)


def _refuse_too_many(actors: Iterable[Any]) -> None:
    inputs = (actor.GetMapper().GetInput() for actor in actors if not _is_cloud(actor))
    count = sum(each.GetNumberOfCells() for each in inputs)
    if count > MOST_CELLS:
        raise Refusal.in_document(REFUSALS["too-many"], count, MOST_CELLS, field="scene")


def _shown_in(renderer: Any) -> tuple[list[Any], list[Any]]:
    """The visible props of a renderer, and those of them that have a depth."""
    props = [prop for prop in renderer.GetViewProps() if prop.GetVisibility()]
    return props, [prop for prop in props if isinstance(prop, vtkActor)]


class _VectorPane:
    """One renderer: its camera, and its rectangle in the window."""

    def __init__(
        self,
        renderer: Any,
        height: int,
        finer: int,
        hidden: str,
        grey: Colour,
        watch: Callable[[], None],
    ) -> None:
        self._renderer, self._height, self._finer = renderer, height, finer
        self._watch, self._hidden, self._grey = watch, hidden, grey
        self._left, self._low = renderer.GetOrigin()
        self._wide, self._high = renderer.GetSize()
        camera, aspect = renderer.GetActiveCamera(), renderer.GetTiledAspectRatio()
        self._clip = _array(camera.GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0))

    def background(self) -> Iterator[Shape]:
        renderer = self._renderer
        if renderer.GetBackgroundAlpha() > 0.0 and not renderer.GetPreserveColorBuffer():
            low, high = (self._left, self._low), (self._left + self._wide, self._low + self._high)
            corners = [low, (high[0], low[1]), high, (low[0], high[1])]
            yield Area([self._placed(corners)], renderer.GetBackground(), 1.0)

    def shapes(self, window: Any) -> Iterator[Shape]:
        props, actors = _shown_in(self._renderer)
        if any(_is_shaded(actor) for actor in actors):
            yield from self._picture(window, props)
            actors = [actor for actor in actors if _is_in_front(actor)]
        _refuse_too_many(actors)
        cells: _Cells = [], [], []
        clouds = list(filter(_is_cloud, actors))
        for place, actor in enumerate(actors):
            if actor not in clouds:
                self._read(actor, place, cells)
        faces, lines, points = cells
        yield from self._arranged(faces, lines, points)
        if clouds:
            yield from self._cloud(window, clouds)
        for prop in props:
            if isinstance(prop, LabelActor):
                label = prop.label()
                if label is not None:
                    yield self._text(label)
            elif isinstance(prop, vtkActor2D):
                yield from self._flat(prop)

    def _picture(self, window: Any, props: Sequence[Any]) -> Iterator[PixelShape]:
        """The pixels of all that has a depth; the rest is hidden meanwhile."""
        others = [p for p in props if isinstance(p, vtkActor2D) or _is_in_front(p)]
        for prop in others:
            prop.SetVisibility(False)
        part = self._blocks(window)
        for prop in others:
            prop.SetVisibility(True)
        drawn, alpha = part.mean(axis=(1, 3)), self._renderer.GetBackgroundAlpha()
        ground = np.rint(255.0 * np.array([*self._renderer.GetBackground(), alpha]))
        is_seen = (np.rint(drawn) != ground).any(axis=2)
        if alpha == 0.0:  # colours are multiplied by theirs
            drawn[..., :3] *= 255.0 / np.maximum(drawn[..., 3:], 1.0)
        pixels = np.minimum(np.rint(drawn), 255.0).astype(np.uint8)[..., : 3 + (alpha == 0.0)]
        yield from self._seen_part(pixels, is_seen, is_cloud=False)

    def _blocks(self, window: Any) -> Array:
        """Draw the window; return its pixels as (rows, finer, columns, finer, 4)."""
        window.Render()
        pixels, top = pixels_of(window), self._height - self._low - self._high
        part = pixels[top : top + self._high, self._left : self._left + self._wide]
        wide, high = (max(1, side // self._finer) for side in (self._wide, self._high))
        blocks = part[: high * self._finer, : wide * self._finer].astype(np.float64)
        return blocks.reshape(high, self._finer, wide, self._finer, -1)

    def _cloud(self, window: Any, clouds: Sequence[Any]) -> Iterator[PixelShape]:
        """The pixels that are others without the clouds: what is seen of these."""
        drawn = self._blocks(window)[..., :3]
        for cloud in clouds:
            cloud.SetVisibility(False)
        seen = (drawn != self._blocks(window)[..., :3]).any(axis=-1, keepdims=True)
        for cloud in clouds:
            cloud.SetVisibility(True)
        share = seen.mean(axis=(1, 3))
        colours = (drawn * seen).mean(axis=(1, 3)) / np.maximum(share, 1e-9)
        pixels = np.rint(np.concatenate([colours, 255.0 * share], axis=2)).astype(np.uint8)
        yield from self._seen_part(pixels, share.any(axis=2), is_cloud=True)

    def _seen_part(self, pixels: Pixels, is_seen: Array, *, is_cloud: bool) -> Iterator[PixelShape]:
        rows, columns = (np.flatnonzero(is_seen.any(axis=axis)) for axis in (1, 0))
        if len(rows):
            (top, low), (left, right) = ((each[0], each[-1] + 1) for each in (rows, columns))
            x, y = self._left / self._finer, (self._height - self._low - self._high) / self._finer
            place = x + left, y + top, float(right - left), float(low - top)
            yield PixelShape(pixels[top:low, left:right], place, is_cloud)

    def _placed(self, points: Iterable[Sequence[float]]) -> Points:
        """Pixels of the window, from the bottom, as pixels of the figure, from the top."""
        return [(p[0] / self._finer, (self._height - p[1]) / self._finer) for p in points]

    # -- reading

    def _read(self, actor: Any, place: int, cells: _Cells) -> None:
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
        depth, lift, paper, is_drawing = None, 0.0, None, False
        if isinstance(actor, FlatActor):
            depth, lift, paper, is_drawing = actor.depth, actor.lift, actor.paper, actor.is_drawing
        clip = world @ self._clip.T
        clip[:, 2] -= lift * clip[:, 3]
        if depth is not None:
            clip[:, 2] = depth * clip[:, 3]
        # Everything is cut before the divide, by planes of the pane's world and by its frame.
        both = np.column_stack([clip, world])
        sides = np.vstack([np.pad(_FRAME, ((0, 0), (0, 4))), np.pad(limits, ((0, 0), (4, 0)))])
        outside = both @ sides.T < 0.0
        with np.errstate(divide="ignore", invalid="ignore"):
            seen = self._on_screen(clip)
        number = 0
        faces, lines, dots = cells
        arrays = mesh.GetVerts(), mesh.GetLines(), mesh.GetPolys()
        for kind, array in zip((dots, lines, faces), arrays, strict=True):
            for cell in _cells(array):
                colour, opacity = properties.GetColor(), properties.GetOpacity()
                is_thin = is_drawing
                if rgba is not None:
                    own = (rgba[number if by_cell else cell[-1]] / 255.0).tolist()
                    colour, opacity = tuple(own[:3]), opacity * (own[3] if len(own) > 3 else 1.0)
                    is_thin |= colour in _GROUND
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
                                part = cut(part, side, kind is faces)
                        points = self._on_screen(part[part[:, 3] > 0.0, :4])
                    if len(points) >= (3 if kind is faces else 2 if kind is lines else 1):
                        kind.append(
                            ScreenCell(points, colour, opacity, (place, number), width, is_thin)
                        )

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
        width = self._width(properties.GetLineWidth())
        low = np.array([self._left, self._low])
        high = low + np.array([self._wide, self._high])
        for is_face, array in ((False, mesh.GetLines()), (True, mesh.GetPolys())):
            for part in (points[cell] for cell in _cells(array)):
                if ((part < low).all(axis=0) | (part > high).all(axis=0)).any():
                    continue  # kept outside until it is needed
                placed = self._placed(part.tolist())
                if is_face:
                    yield Area([placed], colour, opacity)
                else:
                    yield LineShape(placed, colour, opacity, width)

    def _text(self, label: SceneLabel) -> TextShape:
        written = label.written
        x, y = written.place
        ((x, y),) = self._placed([(self._left + x, self._low + y)])
        return TextShape(written, (x, y), written.em / self._finer)

    # -- what hides what

    def _arranged(
        self, faces: list[ScreenCell], lines: list[ScreenCell], points: list[ScreenCell]
    ) -> Iterator[Shape]:
        faces = in_order(faces, self._watch)
        for face, rings in visible(faces, self._watch):
            yield Area([self._placed(ring) for ring in rings], face.colour, face.opacity)
        hiding = Occlusion(faces)
        if self._hidden != "none":
            yield from self._behind(hiding, lines)
        strokes = list[ScreenCell]()
        for line in lines:
            self._watch()
            strokes += hiding.seen(line)
        # Of lines in the same place, the one that is lifted most is seen.
        strokes.sort(key=lambda each: (not each.is_thin, -float(each.points[:, 2].sum())))
        for stroke in strokes:
            width = self._width(stroke.width, 0.0 if stroke.is_thin else _WIDE)
            yield LineShape(
                self._placed(stroke.points.tolist()), stroke.colour, stroke.opacity, width
            )
        for point in points:
            if not hiding.hides(point):
                yield self._disc(point)

    def _disc(self, point: ScreenCell) -> Disc | Area:
        """A dot; at the border of a picture in its pane, the part of it that lies inside."""
        radius, high = point.width / 2.0, np.array([self._wide, self._high])
        at = point.points[0, :2] - (self._left, self._low)
        is_whole = high[1] == self._height or ((at >= radius) & (at <= high - radius)).all()
        if is_whole:
            (centre,) = self._placed(point.points[:1].tolist())
            return Disc(centre, radius / self._finer, point.colour, point.opacity)
        ring = np.column_stack([at + radius * _CIRCLE, np.ones(len(_CIRCLE))])
        for side in ((1, 0, 0), (0, 1, 0), (-1, 0, self._wide), (0, -1, self._high)):
            ring = cut(ring, np.array(side), True)
        ring = ring[:, :2] + (self._left, self._low)
        return Area([self._placed(ring.tolist())], point.colour, point.opacity)

    def _behind(self, hiding: Occlusion, lines: list[ScreenCell]) -> Iterator[LineShape]:
        """The hidden parts of lines, except a ground's, which would cover the objects."""
        for line in lines:
            self._watch()
            for part in () if line.is_thin else hiding.behind(line):
                points = self._placed(part.points.tolist())
                if self._hidden == "grey":
                    yield LineShape(points, self._grey, line.opacity, _WIDTHS[0])
                    continue
                # ISO 128: a narrow line is half as wide, a dash 12 of its widths and a gap 3.
                narrow = _WIDTHS[_WIDTHS.index(self._width(line.width, _WIDE)) - 2]
                dash = 12.0 * narrow, 3.0 * narrow
                yield LineShape(points, line.colour, line.opacity, narrow, dash)

    def _width(self, width: float, least: float = 0.0) -> float:
        """A line's width in pixels of the figure; beside dashed lines, the nearest of ISO 128."""
        width /= self._finer
        if self._hidden != "dashed":
            return width
        return min(_WIDTHS, key=lambda each: abs(each - max(width, least)))


def _is_shaded(actor: Any) -> bool:
    return actor.GetTexture() is not None or (isinstance(actor, FlatActor) and actor.is_shaded)


def _is_cloud(actor: Any) -> bool:
    return bool(actor.GetMapper().GetInput().GetNumberOfVerts() > MOST_DOTS)


def _is_in_front(prop: Any) -> bool:
    return isinstance(prop, FlatActor) and prop.depth is not None and prop.depth < 0.0


def _array(matrix: Any) -> Array:
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def _plane(plane: Any) -> Array:
    normal = np.array(plane.GetNormal())
    return np.array([*normal, -normal @ np.array(plane.GetOrigin())])


def _cells(array: Any) -> list[Any]:
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
