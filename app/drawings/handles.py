"""The marks of the handles of a live pane; figures have none.

One actor holds all marks: a disc for a point, a diamond for a plane, a square for a corner. Each
has a rim, and a ring in the background's colour around it. A step writes one small array of pixels.
The highlighted mark is larger as well as in the accent's colour: colour is never alone.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk

from app.drawings.actors import ScreenCells
from app.drawings.drawing import Handles
from app.drawings.label_placement import Ground
from app.drawings.labels import DOT_EM
from app.drawings.layer import Layer
from app.drawings.style import rgb
from app.drawings.world_axes import WorldAxes
from app.drawings.world_state import WorldState
from app.lecture.highlight import ENDS
from app.picking.handles import Handle, Spot, shown

APART_EM = 0.95
"""Least distance of two marks; they may overlap a little, as few are drawn at a time."""

_SHAPES = {
    "eye": (16, 0.52),
    "target": (16, 0.52),
    **dict.fromkeys(ENDS, (4, 0.68)),
    "grip": (16, 0.52),
    "origin": (16, 0.52),
    "turn": (16, 0.42),
    **dict.fromkeys("xyz", (4, 0.6)),
}
_CORNER = 4, 0.72  # corners of the mark, and its radius in em
_RIM_EM = _RING_EM = 0.12
_LAYERS = 3  # ring, rim and fill
_POINTS = 16  # of each outline
_POINTED_OUT = 1.4  # times as large
_MOST = 15  # eye, target, near, far, four corners, five of the object, or two of a scene's
_AWAY_PX = -1e4


class HandleMarks(Handles, Layer):
    """The marks of the handles of a live pane.

    Only the mark that is `held`, under the pointer or with the keyboard's focus, is drawn, and
    those that are `called`; in a picture that names everything all are.
    """

    def __init__(self, state: WorldState, axes: WorldAxes) -> None:
        self._state, self._axes = state, axes
        self.held = None
        self.called = frozenset[str]()
        self.shown = []
        style = state.style
        fills = dict.fromkeys(("eye", "corner", "grip", "turn"), style.background)
        fills |= {name: getattr(style, name) for name in ("target", *ENDS)}
        fills |= {"origin": style.ink, "x": style.u, "y": style.v, "z": style.n}
        self._fills = {name: _bytes(colour) for name, colour in fills.items()}
        self._accent, self._ink = _bytes(style.accent), _bytes(style.ink)
        self._ring = _bytes(style.background)
        em = style.font_size
        self._outlines = {
            (name, out): em * _outline(*_SHAPES.get(name, _CORNER), _POINTED_OUT if out else 1.0)
            for name in fills
            for out in (False, True)
        }
        # Ring, rim, fill, ring, ...: the later ones lie on top.
        self._cells = ScreenCells(_MOST * _LAYERS, _POINTS)
        self._places = self._cells.px.reshape(_MOST, _LAYERS, _POINTS, 3)
        self._colours = np.zeros((_MOST, _LAYERS, 3), dtype=np.uint8)
        self._scalars = numpy_to_vtk(self._colours.reshape(-1, 3))  # type: ignore[no-untyped-call]
        self._cells.mesh.GetCellData().SetScalars(self._scalars)
        state.canvas.add(self._cells.actor, layer="handles")

    def call(self, names: frozenset[str]) -> None:
        self.called = names
        self.follow()

    def follow(self) -> None:
        """Find the visible handles, and mark them."""
        state, axes = self._state, self._axes.of_object
        size_px, self.planes_drawn = state.size_px, state.planes_drawn
        self.has_object = axes is not None
        handles: Sequence[tuple[Handle, Spot]] = ()
        if "handles" not in state.canvas.hidden:
            handles = shown(
                state.projection, self.planes_drawn, state.sight, size_px, APART_EM * state.em,
                self.held, state.grips, state.unseen, 0.0 if axes is None else axes.reach,
            )  # fmt: skip
        self._mark(handles, size_px[1])

    def want(self, ground: Ground) -> None:
        """Keep labels off the marks that are drawn."""
        height_px = self._state.size_px[1]
        for handle, (x, y) in self.shown:
            if self._state.names.all or handle == self.held:
                ground.keep([(x, height_px - y)], DOT_EM * self._state.em)

    def _mark(self, handles: Sequence[tuple[Handle, Spot]], height_px: int) -> None:
        draws_all = self._state.names.all
        self.shown = list(handles)[:_MOST]
        self._places[len(self.shown) :, ..., :2] = _AWAY_PX
        for i, (handle, (x, y)) in enumerate(self.shown):
            out = handle == self.held
            is_drawn = out or draws_all or bool({handle.name, handle.setting} & self.called)
            if not (math.isfinite(x) and math.isfinite(y) and is_drawn):
                x, y = _AWAY_PX, _AWAY_PX
            kind = handle.setting if handle.name == "object" else handle.name
            self._places[i, ..., :2] = self._outlines[kind, out] + (x, height_px - y)
            fill = self._accent if out else self._fills[kind]
            self._colours[i] = self._ring, self._ink, fill
        self._cells.changed()
        self._scalars.Modified()


def _outline(corners: int, radius: float, factor: float) -> NDArray[np.float32]:
    """The outlines of a mark's ring, rim and fill in em, as regular polygons: (3, 16, 2)."""
    standing = corners == 4 and radius == _CORNER[1]  # the square on its side, not on its corner
    turns = np.repeat(np.arange(corners), _POINTS // corners) / corners + 0.125 * standing
    angles = 2.0 * math.pi * turns
    unit = np.column_stack([np.cos(angles), np.sin(angles)])
    sizes = factor * radius + np.array([_RING_EM, 0.0, -_RIM_EM])
    outlines: NDArray[np.float32] = (sizes[:, None, None] * unit).astype(np.float32)
    return outlines


def _bytes(colour: str) -> tuple[int, ...]:
    return tuple(round(255 * part) for part in rgb(colour))
