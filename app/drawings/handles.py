"""The marks of the handles of a live pane, and what is under the pointer; figures have none.

One actor holds all marks: round grips with a ring in the background's colour. A step writes one
small array of pixels. The highlighted grip is larger as well as in the accent's colour: colour is
never alone.
"""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk

from app.drawings.actors import ScreenCells
from app.drawings.camera import CameraDrawing
from app.drawings.drawing import Handles, Taken
from app.drawings.label_placement import Ground
from app.drawings.labels import DOT_EM
from app.drawings.layer import Layer, PaneState
from app.drawings.pointing import FACES
from app.drawings.probes import order_at
from app.drawings.style import rgb
from app.drawings.world_axes import WorldAxes
from app.drawings.world_state import WorldState
from app.lecture.highlight import CORNERS, ENDS, SIDES, WINDOW, Highlight
from app.model.parameters import FAR, NEAR, PARAMETERS, UP
from app.model.projection import Array
from app.picking.handles import (
    CORNER,
    EYE,
    FAR_CORNERS,
    NEAR_CORNERS,
    NEAR_SIDES,
    PLANES,
    TARGET,
    Handle,
    Spot,
    moved_by,
    nearest,
    place,
    shown,
)
from app.picking.picking import Lines

APART_EM = 0.95  # least distance of a plane's grip from the others, if there is room
POINT_EM, EDGE_EM = 0.65, 0.42  # greatest distance at which a point and an edge are taken

_RADIUS_EM, _RING_EM = 0.34, 0.1
_LAYERS = 2  # ring and fill
_POINTS = 24  # of each outline
_POINTED_OUT = 1.4  # times as large
_MOST = 24  # eye, target, up, near, far, sides, corners, five of the object, two of a scene's
_MOST_AT_REST = 4
_AWAY_PX = -1e4
_NO_WORLD = frozenset({EYE.name, TARGET.name, UP.handle, *ENDS, CORNER})
_OF_ANY_SCENE = "camera.eye", "camera.target", "lens.near", "lens.far"
"""What is moved in a scene without controls of its own."""
_NAMED = dict(zip((*NEAR_CORNERS, *FAR_CORNERS, *NEAR_SIDES), (*CORNERS, *SIDES), strict=True))


class HandleMarks(Handles, Layer):
    """The grips of a scene's settings; those of the world have more.

    Drawn are the one that is `held`, under the pointer or with the keyboard's focus, those of the
    controls at rest, and those that are `called`; in a picture that names everything all are.
    """

    _without = _NO_WORLD

    def __init__(self, state: PaneState) -> None:
        self._state, self._style, phenomenon = state, state.style, state.scene.phenomenon
        self._controls: tuple[str, ...] = _OF_ANY_SCENE
        if phenomenon is not None:
            self._controls = *(each.path for each in phenomenon.settings), *phenomenon.controls
        self._paths = self._controls
        self.held = None
        self.called = frozenset[str]()
        self.shown = []
        self.drawn = dict[Handle, Spot]()
        """The handles that are marked, each with its place in the renderer."""
        self._at_rest: tuple[Sequence[Handle], frozenset[Handle]] = (), frozenset()
        self._last: tuple[Spot, Taken | None] | None = None
        """The pixel that was asked for last, and what is there."""
        self._drawn_edges: tuple[list[Handle], Lines] | None = None
        """The handles of the edges, each with its line; None until they are asked for."""
        self._drawn_faces: list[tuple[Handle, Array, Array, Array]] | None = None
        """Of each face its handle, corners, normal, and the way in from each edge; as above."""
        sizes = _RADIUS_EM + np.array([_RING_EM, 0.0])
        turns = 2.0 * math.pi * np.arange(_POINTS) / _POINTS
        unit = np.column_stack([np.cos(turns), np.sin(turns)])
        self._outline: Array = state.style.font_size * sizes[:, None, None] * unit
        # Ring, fill, ring, ...: the later ones lie on top.
        self._cells = ScreenCells(_MOST * _LAYERS, _POINTS)
        self._places = self._cells.px.reshape(_MOST, _LAYERS, _POINTS, 3)
        self._colours = np.zeros((_MOST, _LAYERS, 3), dtype=np.uint8)
        self._scalars = numpy_to_vtk(self._colours.reshape(-1, 3))  # type: ignore[no-untyped-call]
        self._cells.mesh.GetCellData().SetScalars(self._scalars)
        state.canvas.add(self._cells.actor, renderer=state.renderer, layer="handles")

    def call(self, names: frozenset[str]) -> None:
        self.called = names
        self._mark_others()

    def rest(self, paths: tuple[str, ...] | None) -> None:
        self._paths = self._controls if paths is None else paths
        self._at_rest = (), frozenset()
        self._mark_others()

    def hold(self, handle: Handle | None) -> None:
        self.held = handle
        self._mark_others()

    def _mark_others(self) -> None:
        self._state.wake()  # labels keep off them
        self.settle()

    def settle(self) -> None:
        """Find the visible handles, and mark them."""
        self._last = self._drawn_edges = self._drawn_faces = None
        self._mark([] if "handles" in self._state.canvas.hidden else self._visible())

    def _visible(self, *reaches: float) -> list[tuple[Handle, Spot]]:
        state = self._state
        points = {name: grip.point for name, grip in state.grips.items()}
        return shown(
            state.projection, self.planes_drawn, state.sight, state.canvas.window.GetSize(),
            APART_EM * state.em, self.held, points, self._without, *reaches,
        )  # fmt: skip

    def want(self, ground: Ground) -> None:
        """Keep labels off the marks that are drawn."""
        ground.keep(self.drawn.values(), DOT_EM * self._state.em)

    def _in_renderer(self, *spots: Spot) -> list[Spot]:
        (left, top), height = self._state.corner_px, self._state.size_px[1]
        return [(x - left, height - (y - top)) for x, y in spots]

    def _mark(self, handles: list[tuple[Handle, Spot]]) -> None:
        self.shown = handles[:_MOST]
        listed = [handle for handle, _ in self.shown]
        if listed != self._at_rest[0]:
            self._at_rest = listed, self._resting(listed)
        every, wanted = self._state.names.wanted is None, {self.held, *self._at_rest[1]}
        drawn = {
            handle: spot
            for handle, spot in self.shown
            if every or handle in wanted or {handle.name, handle.setting} & self.called
        }
        self.drawn = dict(zip(drawn, self._in_renderer(*drawn.values()), strict=True))
        self._places[..., :2] = _AWAY_PX
        ring = _bytes(self._style.background)
        for i, (handle, spot) in enumerate(self.drawn.items()):
            if not math.isfinite(sum(spot)):
                continue
            out = handle == self.held
            larger = _POINTED_OUT if out else 1.0
            self._places[i, ..., :2] = larger * self._outline + spot
            fill = _bytes(self._style.accent) if out else self._colour(handle)
            self._colours[i] = ring, fill
        self._cells.changed()
        self._scalars.Modified()

    def _resting(self, handles: Sequence[Handle]) -> frozenset[Handle]:
        """The handles of the controls, one for each and few in all."""
        resting: dict[Handle, None] = {}
        for section, _, name in (path.partition(".") for path in self._paths):
            fields = set(PARAMETERS[name].fields) if name in PARAMETERS else set[str]()
            for handle in handles:
                moved = {each.name for each in moved_by(self._state.projection, handle)}
                if handle.setting == name if section == "settings" else moved & fields:
                    resting[handle] = None
                    break
        return frozenset(list(resting)[:_MOST_AT_REST])

    def _colour(self, handle: Handle) -> tuple[int, ...]:
        style, name = self._style, handle.name
        if name == "grip":
            colour = self._state.grips[handle.setting].colour
            return _bytes(colour if colour.startswith("#") else getattr(style, colour))
        if name == CORNER:
            has_angle = self._state.projection.lens.fov_y_deg is not None
            return _bytes(style.frustum if has_angle else style.near)
        name = {"x": "u", "y": "v", "z": "n"}.get(handle.setting, name)
        return _bytes(getattr(style, name, style.ink))

    # -- what is under the pointer

    def at(self, pixel: Spot) -> Taken | None:
        if self._last is None or self._last[0] != pixel:
            self._last = pixel, self._at(pixel)
        return self._last[1]

    def _at(self, pixel: Spot) -> Taken | None:
        if self.held is not None and dict(self.shown).get(self.held) == pixel:  # by the keyboard
            return self._taken(self.held)
        handle = nearest(self.shown, pixel, POINT_EM * self._state.em)
        if handle is not None:
            return self._taken(handle)
        if "handles" in self._state.canvas.hidden:
            return None
        return self._edge_at(pixel) or self._label_at(pixel) or self._face_at(pixel)

    def _taken(self, handle: Handle, point: Array | None = None) -> Taken:
        """What is taken by a point of the world, or else by the handle's grip."""
        grip = self._state.grips.get(handle.setting)
        if point is None and grip is not None:
            point = np.array(grip.point)
        elif point is None:
            point = place(self._state.projection, handle, self.planes_drawn)
        return Taken(handle, point, self._about(handle))

    def _about(self, handle: Handle) -> Highlight:
        kind = {"grip": "settings.", "object": "object_"}.get(handle.name)
        name = _NAMED.get(handle, handle.name) if kind is None else kind + handle.setting
        return frozenset((name,))

    def _label_at(self, pixel: Spot) -> Taken | None:
        name = self._state.board.name_at(*self._in_renderer(pixel)[0])
        name = WINDOW.get(name, name)
        for setting, grip in self._state.grips.items():
            if name and name == grip.name:
                return self._taken(Handle("grip", setting=setting))
        handles = [handle for handle, _ in self.shown if handle.name != "grip"]
        exact = [handle for handle in handles if name in self._about(handle)]
        # A lens with an angle has no sides, but corners that move them.
        beside = [each for each in handles if name in SIDES and name in _NAMED.get(each, "")]
        return next((self._taken(handle) for handle in (*exact, *beside)), None)

    def _edge_at(self, pixel: Spot) -> Taken | None:
        state = self._state
        if self._drawn_edges is None:
            edges = self._edges()
            ends = np.reshape([each for _, each in edges], (-1, 2, 3))
            self._drawn_edges = [handle for handle, _ in edges], Lines(ends)
        handles, lines = self._drawn_edges
        for *_, spot, hit, number in lines.near(state.sight, pixel, 0.0, EDGE_EM * state.em):
            if not self._is_hidden(spot, hit.order):
                return self._taken(handles[number], np.array(hit.point))
        return None

    def _face_at(self, pixel: Spot) -> Taken | None:
        """The foremost face at a pixel."""
        sight, first = self._state.sight, math.inf
        taken = None
        if self._drawn_faces is None:
            self._drawn_faces = []
            for handle, corners in self._faces():
                across = np.roll(corners, -1, axis=0) - corners
                normal = np.cross(across[0], across[1])
                self._drawn_faces.append((handle, corners, normal, np.cross(normal, across)))
        for handle, corners, normal, inward in self._drawn_faces:
            point = sight.meets(pixel, normal, corners[0])
            order, w = sight.rows[2:] @ np.append(point - sight.eye, 1.0)
            if w > 0.0 and order / w < first:  # never for NaN
                sides = ((point - corners) * inward).sum(axis=1)
                if (sides >= 0.0).all() or (sides <= 0.0).all():
                    first, taken = order / w, self._taken(handle, point)
        return None if taken is None or self._is_hidden(pixel, first) else taken

    def _is_hidden(self, pixel: Spot, order: float) -> bool:
        """Whether a face of the scene is before what has this order."""
        state = self._state
        first = order_at(state.scene, state.projection, state.sight, pixel)
        return first < order - 1e-6 * abs(order)

    def _edges(self) -> list[tuple[Handle, Array]]:
        """The edges that can be dragged, (2, 3) each, in the world."""
        outlines = [
            (Handle("grip", setting=name), np.stack([grip.face, np.roll(grip.face, -1, axis=0)], 1))
            for name, grip in self._state.grips.items()
        ]
        return [(handle, ends) for handle, outline in outlines for ends in outline]

    def _faces(self) -> list[tuple[Handle, Array]]:
        """The faces that can be dragged, (k, 3) each, in the world."""
        planes = [(n, grip.face) for n, grip in self._state.grips.items() if len(grip.face) > 2]
        return [(Handle("grip", setting=name), face) for name, face in planes]


class WorldHandles(HandleMarks):
    """The handles of camera, lens, object and settings in the world."""

    _state: WorldState

    def __init__(self, state: WorldState, axes: WorldAxes, camera: CameraDrawing) -> None:
        super().__init__(state)
        self._axes, self._camera = axes, camera
        self._has_sides = any(f"lens.{side}" in self._controls for side in SIDES)
        """Whether the scene draws the window's sides, though perhaps not its frustum."""
        self._own = [name for name in ENDS if f"lens.{name}" in self._controls]

    def _visible(self, *reaches: float) -> list[tuple[Handle, Spot]]:
        state, axes = self._state, self._axes.of_object
        self.planes_drawn, self.has_object = state.planes_drawn, axes is not None
        self._without = state.unseen
        if "frustum" in state.canvas.hidden:
            self._without |= {*ENDS} if self._has_sides else {*ENDS, CORNER}
        arrows = {} if state.step is None else dict(zip(*self._camera.arrows, strict=True))
        up = arrows.get(UP.name, np.zeros(3))
        return super()._visible(0.0 if axes is None else axes.reach, float(np.linalg.norm(up)))

    @property
    def _planes(self) -> dict[str, Handle]:
        """The handles of near and far that are drawn, if their planes are."""
        state = self._state
        if state.corners_seen is None or state.projection.lens.planes is None:
            return {}
        drawn = {handle.name: handle for handle, _ in self.shown}
        every = {name: drawn.get(name, PLANES[name][0]) for name in ENDS}
        return {name: handle for name, handle in every.items() if name not in self._without}

    def _edges(self) -> list[tuple[Handle, Array]]:
        state, planes, axes = self._state, self._planes, self._axes.of_object
        eye, corners, edges = state.standing.eye, state.volume.corners, super()._edges()
        local: list[tuple[Handle, Any]] = []
        lens = state.projection.lens
        for i, j in ((0, 1), (1, 2), (2, 3), (3, 0)):
            if lens.planes is not None and lens.fov_y_deg is None and CORNER not in self._without:
                local.append((NEAR_SIDES[i], corners[[i, j]]))
            elif planes:
                local.append((planes[NEAR.name], corners[[i, j]]))
            if planes:
                local.append((planes[FAR.name], corners[[i + 4, j + 4]]))
        arrows = dict(zip(*self._camera.arrows, strict=True))
        for handle, _ in self.shown:
            if handle.name == UP.handle:
                local.append((handle, [eye, eye + arrows[UP.name]]))
            elif axes is not None and handle.setting in ("x", "y", "z"):
                local.append((handle, [axes.origin, axes.ends["xyz".index(handle.setting)]]))
        return [*edges, *((handle, np.array(ends) + state.origin) for handle, ends in local)]

    def _faces(self) -> list[tuple[Handle, Array]]:
        """Those of the scene's own planes, unless the pane looks along the view direction."""
        state, faces = self._state, super()._faces()
        if state.own.fixed or state.own.sees_from_eye:
            return faces
        named = [(self._planes[name], FACES[name]) for name in self._own if name in self._planes]
        corners = state.volume.corners + state.origin
        return faces + [(handle, corners[list(face)]) for handle, face in named]


def _bytes(colour: str) -> tuple[int, ...]:
    return tuple(round(255 * part) for part in rgb(colour))
