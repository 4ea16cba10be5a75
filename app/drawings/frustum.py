"""The model's frustum in the world pane: the NDC cube's own edges and faces under the inverse.

The cube has the reversed depth range, whatever the model's own is. There 1/w of the far face is
1/far itself. In [-1, 1] it is a difference of two numbers of the size of 1/near, of which float32
keeps nothing once far/near reaches 1e6.

Distances along the line of sight are drawn to scale from `DrawnDepths.low` to `DrawnDepths.high`.
Planes beyond are drawn at the limit, behind a visible break, with their true distances written
there::

    eye <------ near ============== / / - - far 1e+06
    0           1                   break   high
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings import actors
from app.drawings.actors import PropGroup, Space, applied
from app.drawings.camera import CameraPose
from app.drawings.names import QUIET, Names
from app.drawings.pane_view import PaneView
from app.drawings.pointing import FACES, FAR_FACE, NEAR_FACE, Emphasis, outline
from app.lecture.highlight import SIDES, WINDOW
from app.model.projection import Array, Lens, Projection

CUBE = actors.CUBE_CORNERS * (1.0, 1.0, -0.5) + (0.0, 0.0, 0.5)
"""The corners of the reversed range's cube: near face at z = 1, far face at z = 0."""

_BEYOND = 1.5  # how far the frustum is drawn, relative to the depth of the objects
_BREAK = 0.8  # of the reach: where a break begins
_STROKES_AT = 0.38  # of a broken edge
_FADE_FROM, _FADED = (
    0.6,
    0.15,
)  # share of the pane under a plane; share of the tint if that is all of it
_STEEPEST = 1e16  # edge of a frustum, sideways per distance: a plane, and its square is finite
WIDEST = 1e35
"""Edge of a box: larger than any scene, and a float32."""
_NAMED_BY = {"near": ("near", *WINDOW), "far": ("far",)}
"""The planes, and the names for which they are not drawn quietly."""
_VOLUME = ("near", "far", "fov")
"""What the edges of the volume belong to."""

# The eye is where the cube's z axis meets infinity: a pyramid with its apex at the origin and its
# base at z = 1 becomes the eye's pyramid to the near face when z and w change places.
_CUBE_FROM_PYRAMID = np.eye(4)[[0, 1, 3, 2]]


class DrawnDepths(NamedTuple):
    """The distances from the eye plane that are drawn to scale; world units."""

    low: float  # the limits; low is negative, behind the eye, for a parallel lens
    high: float
    near: float  # where the planes are drawn, low <= near < far <= high
    far: float
    near_break: (
        tuple[float, float] | None
    )  # where edges are broken, if a plane is not at its own distance
    far_break: tuple[float, float] | None

    @property
    def body(self) -> tuple[float, float]:
        start, end = self.near, self.far
        if self.near_break is not None and self.near_break[0] >= start:
            start = self.near_break[1]
        if self.far_break is not None and self.far_break[1] <= end:
            end = self.far_break[0]
        return start, end


class FrustumDrawing:
    """The frustum, broken where it is too deep to be drawn to scale.

    Attributes
    ----------
    space, apex_space : Space
        From the cube's corners to scene-local coordinates; of the pyramid from the eye to near.
    outlines : mapping from str to vtkActor
        Edges of ``"near"`` and ``"far"``; `apex` are the lines from the eye to near.
    dimmable : tuple of vtkActor
        All but the planes' tints, which `tint` sets.
    corners : (8, 3) array
        As drawn, scene-local.
    reach : Reach or None
        None under a typed matrix, which may have no frustum at all (`seen`).
    """

    def __init__(self, canvas: PropGroup, size: float) -> None:
        self._canvas, self._size = canvas, size
        style, self._em = canvas.style, canvas.style.font_size
        self.reach: DrawnDepths | None = None
        width = style.line_width
        self.space, self._body_space, self.apex_space = Space(), Space(), Space()

        near_tint, far_tint = style.tints
        far_face = actors.face_actor(CUBE, [FAR_FACE], style.far, far_tint)
        walls = actors.face_actor(CUBE, [FACES[side] for side in SIDES], style.frustum, 0.05)
        near_face = actors.face_actor(CUBE, [NEAR_FACE], style.near, near_tint)
        near_line = outline(NEAR_FACE, CUBE, style, dashed=False)
        far_line = outline(FAR_FACE, CUBE, style, dashed=True)
        self._volume = far_face, walls, near_face, near_line, far_line
        self.space.add(*self._volume)
        self.outlines = {"near": near_line, "far": far_line}
        self.tints = {"near": (near_face, near_tint), "far": (far_face, far_tint)}
        self._quiet: frozenset[str] = frozenset()
        edges = [(i, i + 4) for i in range(4)]
        self._body = actors.line_actor(CUBE, edges, style.frustum, width)
        self._body_space.add(self._body)
        apex = [(0.0, 0.0, 0.0), *CUBE[:4]]
        self.apex = actors.line_actor(
            apex, [(0, i) for i in range(1, 5)], style.frustum, width / 2.0
        )
        self.apex_space.add(self.apex)
        self.breaks: dict[str, list[tuple[Space, vtkActor]]] = {"near": [], "far": []}
        self._break_ends: dict[str, Array] = {}
        for broken_edges in self.breaks.values():
            for _ in range(4):
                edge = actors.line_actor(*_broken_edge(), style.frustum, width)
                broken_edges.append((Space(), edge))
                broken_edges[-1][0].add(edge)
        broken = [edge for edges in self.breaks.values() for _, edge in edges]
        lines = near_line, far_line, self._body, self.apex, *broken
        self.dimmable = *lines, walls
        canvas.add(*lines, far_face, walls, near_face, layer="frustum")

    def show(self, projection: Projection, standing: CameraPose, held_depth: float = 0.0) -> None:
        """Take over the model's volume; `held_depth` is the depth of a scene's own grips."""
        self._extent = standing.extent
        self.reach = self._reach_of(projection.lens, standing, held_depth)
        if self.reach is None:
            self._show_whole(projection, standing)
        else:
            self._show_broken(projection, standing, self.reach)

    def _show_whole(self, projection: Projection, standing: CameraPose) -> None:
        """Draw the cube under the inverse of a free matrix; nothing if it has none."""
        self.seen = projection.frustum_sign != 0
        for actor in (*self._volume, self._body):
            self._canvas.set_visible(actor, self.seen)
        self._canvas.set_visible(self.apex, False)
        for name in self.breaks:
            self._break(name, None)
        self.corners = np.tile(standing.eye, (8, 1))
        if self.seen:
            reversed_range = projection.with_depth("reversed")
            local_from_cube = reversed_range.world_from_clip_at(standing.origin)
            frustum = normalised(projection.frustum_sign * local_from_cube)
            self.corners = np.clip(applied(frustum, CUBE), -WIDEST, WIDEST)
            self.space.set(frustum)
            self._body_space.set(frustum)

    def _show_broken(
        self, projection: Projection, standing: CameraPose, reach: DrawnDepths
    ) -> None:
        """Draw a lens' frustum, with breaks where a plane is not drawn at its own distance."""
        lens, local_from_view = projection.lens, standing.local_from_view
        self.seen = True
        for actor in self._volume:
            self._canvas.set_visible(actor, True)
        view_from_cube = matrices_between(projection, reach.near, reach.far)[1]
        frustum = normalised(local_from_view @ view_from_cube)
        self.corners = applied(frustum, CUBE)
        self.space.set(frustum)
        start, end = reach.body
        self._canvas.set_visible(self._body, start < end)
        if start < end:
            self._body_space.set(frustum @ _cube_from_part(view_from_cube, start, end))
        for name, broken in (("near", reach.near_break), ("far", reach.far_break)):
            ends = None
            if broken is not None:
                ends = applied(frustum @ _cube_from_part(view_from_cube, *broken), CUBE)
            self._break(name, ends)
        self._canvas.set_visible(self.apex, lens.central)
        if lens.central:
            base = frustum
            if reach.near_break is not None:
                _, view_from_cube = matrices_between(projection, *reach.near_break)
                base = normalised(local_from_view @ view_from_cube)
            self.apex_space.set(base @ _CUBE_FROM_PYRAMID)

    def _break(self, name: str, ends: Array | None) -> None:
        """Break the edges before a plane between these corners, (8, 3); None for no break."""
        for _, edge in self.breaks[name]:
            self._canvas.set_visible(edge, ends is not None)
        self._break_ends.pop(name, None)
        if ends is not None:
            self._break_ends[name] = ends

    def _reach_of(self, lens: Lens, standing: CameraPose, held_depth: float) -> DrawnDepths | None:
        if lens.planes is None:
            return None
        size, extent = self._size, standing.extent
        nearby_target = min(standing.camera.distance, 2.0 * extent)
        high = _BEYOND * max(standing.objects_depth, held_depth, nearby_target, 0.5 * size)
        near, far = lens.planes
        if lens.central:
            low = 0.0
            near = max(near, 1e-12 * high)  # nobody sees the difference; float32 does
        else:
            low = -0.5 * _BEYOND * extent
        near_break = far_break = None
        if near > _BREAK * high:
            near, near_break = _BREAK * high, (_BREAK**2 * high, _BREAK * high)
        elif near < low:
            near, near_break = low, (low, _BREAK * low)
        if far > high:
            far, far_break = high, (_BREAK * high, high)
        elif far < _BREAK * low:
            far, far_break = _BREAK * low, (_BREAK * low, _BREAK**2 * low)
        far = max(far, near + 1e-9 * (high - low))
        return DrawnDepths(low, high, near, far, near_break, far_break)

    def tint(self, pane: PaneView, light: float) -> None:
        """Tint the planes, less where they would flood the pane; `light` is at most 1."""
        parts = pane.parts_covered(self.corners, _FADE_FROM)
        for (name, (tint, opacity)), part in zip(self.tints.items(), parts, strict=True):
            flood = (part - _FADE_FROM) / (1.0 - _FADE_FROM)
            quiet = 1.0 - QUIET if name in self._quiet else 1.0
            tint.GetProperty().SetOpacity(
                light * quiet * opacity * (1.0 - (1.0 - _FADED) * max(0.0, flood))
            )

    def show_names(self, names: Names) -> None:
        """Tint the planes that are not named more palely, from the next `tint` on."""
        self._quiet = frozenset(
            name for name in self.tints if not any(each in names for each in _NAMED_BY[name])
        )

    def make_emphasis(self, emphasis: Emphasis) -> None:
        emphasis.volume(self.space, CUBE)
        for name, line in self.outlines.items():
            emphasis.line(line, name, of=_NAMED_BY[name])
        emphasis.line(self.apex, "fov", of=_VOLUME)
        broken = [edge for edges in self.breaks.values() for _, edge in edges]
        for line in (self._body, *broken):
            emphasis.line(line, of=_VOLUME)

    def turn_breaks(self, pane: PaneView) -> None:
        """Turn the strokes of each broken edge into the plane of the screen."""
        em = self._em
        for name, ends in self._break_ends.items():
            starts, along = ends[:4], ends[4:] - ends[:4]
            x, y, depth = pane.axes @ (starts + _STROKES_AT * along - pane.eye).T
            depth = np.maximum(np.abs(depth), 1e-9 * self._extent)
            unit = pane.unit(depth)
            away_per = 2.0 * pane.slope / (pane.size_px[1] * unit)  # shrinking of what recedes
            right, up, away = pane.axes @ along.T
            right, up = right - x * away * away_per, up - y * away * away_per
            length = np.hypot(right, up)
            turned = length > 1e-3 * unit
            right = np.where(turned, right / np.where(turned, length, 1.0), 1.0)
            up = np.where(turned, up / np.where(turned, length, 1.0), 0.0)
            size = unit * em * np.clip(length / (2.5 * em * unit), 0.65, 1.0)
            on = np.stack([right, up], axis=1) @ pane.axes[:2] * size[:, None]
            across = np.stack([-up, right], axis=1) @ pane.axes[:2] * size[:, None]
            matrices = np.zeros((4, 4, 4))
            matrices[:, :3] = np.stack([along, across, on, starts], axis=2)
            matrices[:, 3, 3] = 1.0
            for (space, _), matrix in zip(self.breaks[name], matrices, strict=True):
                space.set(matrix)


def matrices_between(projection: Projection, near: float, far: float) -> tuple[Array, Array]:
    """`Projection.matrices_between`, with an inverse that float32 can draw."""
    clip_from_view, view_from_clip = projection.matrices_between(near, far)
    widest = _STEEPEST if projection.lens.central else WIDEST
    view_from_clip[:2] = np.clip(view_from_clip[:2], -widest, widest)
    return clip_from_view, view_from_clip


def _cube_from_part(view_from_cube: Array, near: float, far: float) -> Array:
    """Return the matrix from the cube of a part of a view volume to that of the whole, (4, 4).

    The distance from the eye plane is ``-(A z + B) / (C z + D)`` with the rows (A, B) and (C, D) of
    `view_from_cube` that make z and w; solved for z at both distances.
    """
    (a, b), (c, d) = view_from_cube[2:, 2:].tolist()
    at_near, at_far = (-(b + distance * d) / (a + distance * c) for distance in (near, far))
    matrix = np.identity(4)
    matrix[2, 2], matrix[2, 3] = at_near - at_far, at_far
    return matrix


def normalised(matrix: Array) -> Array:
    """The same projective matrix with entries that float32 can hold."""
    result: Array = matrix / np.abs(matrix).max()
    return result


def _broken_edge() -> tuple[Array, list[tuple[int, ...]]]:
    """An edge with two strokes across, and dashed from there: ``--- / / - - -``.

    Returns points (n, 3), along the edge from 0 to 1 and in ems of the screen across and along it,
    and the lines between them.
    """
    at, gap, half, slant = _STROKES_AT, 0.21, 0.5, 0.17
    strokes = [((at, -half, z - slant), (at, half, z + slant)) for z in (-gap, gap)]
    dashes = [((at, 0.0, gap), (0.56, 0.0, 0.0))]
    dashes += [((a, 0.0, 0.0), (b, 0.0, 0.0)) for a, b in ((0.68, 0.8), (0.9, 1.0))]
    pieces = [((0.0, 0.0, 0.0), (at, 0.0, -gap)), *strokes, *dashes]
    points = np.array([end for piece in pieces for end in piece])
    return points, [(i, i + 1) for i in range(0, len(points), 2)]
