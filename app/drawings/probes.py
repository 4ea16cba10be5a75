"""The marks of the probes, the same in all three panes.

A probe is a disc with a rim, and its number beside it. The lecturer's pointer has no number, and a
ring that can be seen from the back row. Both are always in front, where the pane shows the point,
computed in float64. The projector, the line that one pixel's points share, is drawn in the scene:
from the eye in the world, parallel to z in the NDC cube. A disc is hollow if the point is outside
the view volume. A point without a picture (w <= 0) has no disc: a mirrored one would be a lie.
"""

import math
from abc import abstractmethod
from collections.abc import Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkRenderingCore import vtkActor2D

from app.document.naming import PROBE_LETTER
from app.drawings.actors import Space, actor_2d, lift_lines, line_actor
from app.drawings.label_placement import Ground
from app.drawings.labels import PROBE
from app.drawings.layer import Layer, PaneState
from app.drawings.prop_group import PropGroup
from app.drawings.style import rgb
from app.model.infinity import trace_at_infinity
from app.model.projection import Array, Projection, Trace, Vector
from app.picking.picking import Hit, Lines, PickSurface, Probe, pick, projector, stops
from app.picking.sight import Sight
from app.scenes.poly_mesh import PolyMesh
from app.scenes.scene import Scene

if TYPE_CHECKING:
    from app.drawings.picture_frame import ImageState
    from app.drawings.stage_box import StageState
    from app.drawings.world_state import WorldState

_RIM_EM, _FILL_EM, _CROSSING_EM = 0.44, 0.32, 0.24  # radii
_RING_EM = ((0.72, 1.1), (0.8, 1.02))  # inner and outer radii: of its edges, and between them
_TRIED = 40  # vertices: of a million each takes a millisecond or two


class ProbeMark(NamedTuple):
    """The mark of a probe in one pane; pixels from its top left."""

    number: int  # written beside it, unless it is 0
    spot_px: Array | None  # of the disc; None or NaN for nowhere
    solid: bool = True  # whether the point is inside the view volume
    line: Array | None = None  # (2, 3): the projector, in the actors' coordinates
    crossing_px: Array | None = None  # where the projector meets the near plane


class Probes(Layer):
    """The marks of the state's probes in one pane, which knows where each is (`marks`)."""

    needs = "probes"

    def __init__(self, state: PaneState) -> None:
        self._state = state
        self._slots: list[_Slot] = []
        self._spots: list[tuple[int, float, float]] = []
        self._lines: list[Array] = []  # of the projectors, (2, 3)

    @abstractmethod
    def marks(self) -> Sequence[ProbeMark]: ...

    def settle(self) -> None:
        state = self._state
        marks = self.marks() if state.probes else ()
        if not (marks or self._slots):
            return
        while len(self._slots) < len(marks):
            self._slots.append(_Slot(state.canvas, state.renderer))
        for i, slot in enumerate(self._slots):
            slot.show(marks[i] if i < len(marks) else None, state.size_px)
        spots = [(mark.number, _place(mark.spot_px, state.size_px[1])) for mark in marks]
        self._spots = [(number, *spot) for number, spot in spots if spot is not None]
        self._lines = [mark.line for mark in marks if mark.line is not None]

    def want(self, ground: Ground) -> None:
        """Keep labels off the discs, and ask for a place for each number."""
        board, named = self._state.board, self._state.names.wanted or ()
        for number, x, y in self._spots:
            ground.keep([(x, y)], _RIM_EM * board.em)
            if number:
                key = "probe", number
                letter = chr(ord("A") + number - 1)
                text = letter if f"{PROBE_LETTER}{letter}" in named else str(number)
                board.label(key, "", self._state.style.accent).set_text(text)
                board.want_beside(key, (x, y, 1.0), PROBE)

    def ink(self, ground: Ground) -> None:
        if self._lines:
            spots = self._state.spots(np.concatenate(self._lines))
            ground.ink_lines(spots.reshape(-1, 2, 2))

    def _traced(self, projection: Projection) -> list[tuple[Probe, Trace | None]]:
        """Each probe with its point through all stages; None for a ray."""
        probes = self._state.probes
        traces = iter(_traced(projection, tuple(p.point for p in probes if p.point is not None)))
        return [
            (
                probe,
                _traced_at_infinity(projection, probe.direction)
                if probe.direction is not None
                else None if probe.point is None else next(traces),
            )
            for probe in probes
        ]  # fmt: skip


class WorldProbes(Probes):
    _state: "WorldState"

    def marks(self) -> list[ProbeMark]:
        projection, origin = self._state.projection, self._state.origin
        sight, (near, far) = self._state.sight, self._state.planes_drawn
        has_near = projection.frustum_sign != 0
        marks = []
        for probe, trace in self._traced(projection):
            line = projector(projection, probe, (near, far, min(0.0, near)))
            if probe.point is None or trace is None:
                if line is None:  # under a free matrix that has no inverse, or it is all behind
                    marks.append(ProbeMark(probe.number, None))
                    continue
                crossing = sight.seen(line[:1])[0]
                if trace is None:
                    marks.append(ProbeMark(probe.number, crossing, True, line[:2] - origin))
                else:  # from the eye to where all lines that run so are seen: on the near plane
                    inside, ends = not trace.outside.any(), line[[2, 1]] - origin
                    marks.append(ProbeMark(probe.number, crossing, inside, ends, crossing))
                continue
            point = np.array(probe.point)
            start = np.array(projection.camera.eye) if line is None else line[2]
            crossing = sight.seen(line[:1])[0] if line is not None and has_near else None
            spot = sight.seen([point])[0]
            way: Array | None = np.stack([start, point]) - origin
            if line is None and not projection.lens.central:  # there is no eye to start from
                way = None
            marks.append(ProbeMark(probe.number, spot, not trace.outside.any(), way, crossing))
        return marks

    def inside(self) -> dict[str, Array]:
        state = self._state
        return {
            str(probe.number): state.framed(np.array([probe.point]) - state.origin)
            for probe in state.probes
            if probe.point is not None
        }


class StageProbes(Probes):
    _state: "StageState"

    def marks(self) -> list[ProbeMark]:
        projection, sight = self._state.seen_projection, self._state.sight
        display_from_ndc = self._state.display_from_ndc
        if not display_from_ndc.any():
            return []
        marks = []
        for probe, trace in self._traced(projection):
            z = projection.depth_range
            spot, solid = None, True
            if trace is None:
                assert probe.pixel is not None
                width, height = projection.image_size
                x, y = 2.0 * probe.pixel[0] / width - 1.0, 1.0 - 2.0 * probe.pixel[1] / height
            else:
                if not trace.in_front:
                    marks.append(ProbeMark(probe.number, None))
                    continue
                x, y, z_point = trace.ndc.tolist()
                solid = not trace.outside.any()
                if probe.direction is not None:
                    spot = sight.seen_at_infinity(probe.direction)
                elif probe.point is not None:
                    spot = sight.seen([probe.point])[0]
                z = min(*z, z_point), max(*z, z_point)
            ends = np.array([(x, y, end, 1.0) for end in z]) @ display_from_ndc.T
            # Between two stops a line may reach infinity, as only a free matrix makes it.
            line = ends[:, :3] / ends[:, 3:] if (ends[:, 3] > 0.0).all() else None
            marks.append(ProbeMark(probe.number, spot, solid, line))
        return marks


class ImageProbes(Probes):
    _state: "ImageState"

    def marks(self) -> list[ProbeMark]:
        marks: list[ProbeMark] = []
        if self._state.eyes is not None:  # they have two places then
            return marks
        for probe, trace in self._traced(self._state.projection):
            if trace is None:
                pixel, solid = np.array(probe.pixel), True
            else:
                pixel, solid = trace.image, not trace.outside.any()
            marks.append(ProbeMark(probe.number, self._state.scale @ pixel, solid))
        return marks


@lru_cache(maxsize=2)  # of one step: with the depth range at hand, and with the one the cube has
def _traced(projection: Projection, points: tuple[Vector, ...]) -> tuple[Trace, ...]:
    """Points through all stages, all at once for all panes."""
    rows = zip(*projection.trace(points), strict=True) if points else ()
    return tuple(Trace(*row) for row in rows)


_traced_at_infinity = lru_cache(maxsize=16)(trace_at_infinity)  # six probes, likewise


class _Slot:
    def __init__(self, canvas: PropGroup, renderer: Any) -> None:
        self._style = canvas.style
        style, em = canvas.style, canvas.style.font_size
        self._space = Space()
        self._line = line_actor(
            [(0, 0, 0), (0, 0, 1)], [(0, 1)], style.accent, 1.5 * style.line_width
        )
        lift_lines(self._line, 4)
        self._space.add(self._line)
        self._rim = _disc(_RIM_EM * em, style.ink)
        self._fill = _disc(_FILL_EM * em, style.accent)
        self._crossing = (
            _disc(_CROSSING_EM * em, style.ink, 4),
            _disc(0.66 * _CROSSING_EM * em, style.near, 4),
        )
        self._ring = tuple(
            _disc(outer * em, colour, 48, inner * em)
            for (inner, outer), colour in zip(_RING_EM, (style.ink, style.accent), strict=True)
        )
        canvas.add(
            self._line, *self._crossing, *self._ring, self._rim, self._fill,
            renderer=renderer,
        )  # fmt: skip

    def show(self, mark: ProbeMark | None, size_px: tuple[int, int]) -> None:
        height_px = size_px[1]
        line = None if mark is None else mark.line
        self._line.SetVisibility(line is not None)
        if line is not None:
            matrix = np.zeros((4, 4))
            matrix[:3, 2], matrix[:3, 3], matrix[3, 3] = line[1] - line[0], line[0], 1.0
            self._space.set(matrix)
        spot = _place(None if mark is None else mark.spot_px, height_px)
        for actor in (self._rim, self._fill):
            actor.SetVisibility(spot is not None)
        is_named = mark is not None and mark.number > 0
        for actor in self._ring:
            actor.SetVisibility(spot is not None and not is_named)
        if mark is not None and spot is not None:
            for disc in (self._rim, self._fill, *self._ring):
                disc.SetPosition(*spot)
            colour = self._style.accent if mark.solid else self._style.background
            self._fill.GetProperty().SetColor(*rgb(colour))
        crossing = _place(None if mark is None else mark.crossing_px, height_px)
        for actor in self._crossing:
            actor.SetVisibility(crossing is not None)
            if crossing is not None:
                actor.SetPosition(*crossing)


def _place(spot_px: Array | None, height_px: int) -> tuple[float, float] | None:
    """Convert a spot to pixels from the bottom left; None if it is far off the screen."""
    if spot_px is None or not np.isfinite(spot_px).all() or np.abs(spot_px).max() > 1e5:
        return None
    x, y = spot_px.tolist()
    return x, height_px - y


def _disc(radius_px: float, colour: str, corners: int = 24, hole_px: float = 0.0) -> vtkActor2D:
    turns, here = 2.0 * math.pi * np.arange(corners) / corners, np.arange(corners)
    ring = np.column_stack([np.cos(turns), np.sin(turns), 0.0 * turns])
    after = np.roll(here, -1)
    quads = np.stack([here, after, corners + after, corners + here], axis=1)
    faces = quads if hole_px else here[None]
    points = np.concatenate([radius_px * ring, hole_px * ring] if hole_px else [radius_px * ring])
    actor = actor_2d(PolyMesh.of(points, faces=faces))
    actor.GetPositionCoordinate().SetCoordinateSystemToViewport()
    actor.GetProperty().SetColor(*rgb(colour))
    return actor


_sorted: WeakKeyDictionary[Scene, tuple[Future[PickSurface], Lines]] = WeakKeyDictionary()
_NO_FACES = PickSurface(np.empty((0, 3), np.float32), np.empty((0, 3), np.int32))
_sorting = ThreadPoolExecutor(1, "sorting")


def sort_ahead(scene: Scene) -> None:
    """Start to sort the scene's faces and dots for picking: a million vertices take 0.1 s."""
    if scene in _sorted:
        return
    mesh = scene.surface
    points, of_faces = scene.own_points, 0
    triangles: NDArray[Any] = np.empty((0, 3), np.int32)
    if mesh is not None:
        of_faces = mesh.n_points
        if not mesh.is_all_triangles:  # VTK holds the GIL, so that a thread would not help
            mesh = mesh.triangulate()
        triangles = mesh.regular_faces
    if of_faces < len(points):  # a dot is a triangle that hides nothing
        dots = np.arange(of_faces, len(points), dtype=triangles.dtype)
        triangles = np.concatenate([triangles, np.repeat(dots[:, None], 3, axis=1)])
    surface = _sorting.submit(PickSurface, points, triangles, scene.origin)
    _sorted[scene] = surface, _lines_of(scene)


def pick_in(
    scene: Scene,
    projection: Projection,
    sight: Sight,
    pixel: tuple[float, float],
    pixel_ratio: float = 1.0,
) -> Hit | None:
    """Return what of a scene is seen at a pixel; see `picking.pick`."""
    sort_ahead(scene)
    surface, lines = _sorted[scene]
    placement = projection.placement
    if placement.is_identity:
        return pick(surface.result(), lines, sight, pixel, pixel_ratio)
    objects, ground = (_lines_of(part) for part in scene.apart)
    behind = pick(_NO_FACES, ground, sight, pixel, pixel_ratio)
    placed = sight.of_object(projection, scene.origin)
    hit = pick(surface.result(), objects, placed, pixel, pixel_ratio)
    if hit is None or (behind is not None and behind.order < hit.order and hit.vertex is None):
        return behind
    ((x, y, z),) = placement.placed(np.array([hit.point])).world.tolist()
    return hit._replace(point=(x, y, z))


def order_at(
    scene: Scene, projection: Projection, sight: Sight, pixel: tuple[float, float]
) -> float:
    """The order of the foremost face at a pixel; infinity beside them all."""
    sort_ahead(scene)
    placed = sight.of_object(projection, scene.origin)
    hit = _sorted[scene][0].result().pick(placed, pixel, 0.0)
    return math.inf if hit is None else hit.order


def _lines_of(scene: Scene) -> Lines:
    lines = scene.lines
    ends = np.empty((0, 2, 3)) if lines is None else lines.points.reshape(-1, 2, 3)
    return Lines(ends, scene.origin)


def next_vertex(
    scene: Scene,
    projection: Projection,
    sight: Sight,
    rectangle_px: tuple[float, float, float, float],
    pixel_ratio: float,
    at: int | None,
    *,
    forwards: bool,
) -> int | None:
    """Return the next visible vertex of a scene's objects, or the one before.

    `rectangle_px` is the part of the pane with the scene: left, top, width and height. After a
    vertex `at` that is out of view, and after None, comes the first one. None if no other vertex is
    visible. Where very many in a row are hidden, the result is one of them, and a key that is held
    goes on.
    """
    sort_ahead(scene)
    surface = _sorted[scene][0].result()
    sight = sight.of_object(projection, scene.origin)
    order = stops(scene.own_points, scene.origin, sight, rectangle_px, pixel_ratio, at)
    if not forwards:
        order.reverse()
    here = next((i for i, stop in enumerate(order) if stop.number == at), -1)
    others = order[here + 1 :] + order[: max(here, 0)]
    tried = others[:_TRIED]
    fallback = tried[-1].number if len(tried) < len(others) else None
    return next((stop.number for stop in tried if not surface.hides(sight, stop)), fallback)


def vertex_of(scene: Scene, projection: Projection, number: int) -> Vector:
    """Return a vertex of a scene in the world, with the same bits as when it is picked."""
    point = np.array([scene.own_points[number] + np.array(scene.origin)], dtype=np.float64)
    ((x, y, z),) = projection.placement.placed(point).world.tolist()
    return x, y, z
