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

import math
from functools import partial
from itertools import pairwise
from operator import add

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings import actors
from app.drawings.actors import Space, applied
from app.drawings.label import SceneLabel
from app.drawings.label_placement import NOWHERE, SQUARE_EM, Ground, flanking
from app.drawings.labels import DOT_EM, SIDE, want_plane, written_distance
from app.drawings.layer import Layer
from app.drawings.pointing import FACES, FAR_FACE, NEAR_FACE, outline
from app.drawings.style import QUIET
from app.drawings.world_state import WIDEST, CameraPose, DrawnDepths, DrawnVolume, WorldState
from app.lecture.highlight import ENDS, SIDES, WINDOW
from app.model.parameters import FAR, NEAR
from app.model.projection import Array, Lens, Projection
from app.scenes.phenomena.words import digits_apart

CUBE = actors.CUBE_CORNERS * (1.0, 1.0, -0.5) + (0.0, 0.0, 0.5)
"""The corners of the reversed range's cube: near face at z = 1, far face at z = 0."""

_BEYOND = 1.5  # how far the frustum is drawn, relative to the depth of the objects
_BREAK = 0.8  # of the reach: where a break begins
_STROKES_AT = 0.38  # of a broken edge
# Share of the pane under a plane; share of the tint if that is all of it.
_FADE_FROM, _FADED = 0.6, 0.15
_STEEPEST = 1e16  # edge of a frustum, sideways per distance: a plane, and its square is finite
_NAMED_BY = {NEAR.name: (NEAR.name, *WINDOW), FAR.name: (FAR.name,)}
"""The planes, and the names for which they are not drawn quietly."""
_VOLUME = (*ENDS, "fov")  # what the edges of the volume belong to
_EDGES = [pair for line in actors.CUBE_EDGES for pair in pairwise(line)]
_ON_SIDE = np.array([0.5, 0.3, 0.7, -0.05, 1.05])  # where on a window's side its name may stand
_ONE_OVER_THE_OTHER = {"side": frozenset("lr"), "top": frozenset("bt")}
"""Sides of the window that cover each other in a flat view, all along it: named only if asked for.
"""
_HELD_NEAR = 5.0  # of the scene's size: farther grips do not make the frustum deeper

# The eye is where the cube's z axis meets infinity: a pyramid with its apex at the origin and its
# base at z = 1 becomes the eye's pyramid to the near face when z and w change places.
_CUBE_FROM_PYRAMID = np.eye(4)[[0, 1, 3, 2]]


class FrustumDrawing(Layer):
    """The frustum, broken where it is too deep to be drawn to scale.

    - `space`, `apex_space`: from the cube's corners to scene-local coordinates; of the pyramid from
      the eye to near.
    - `outlines`: edges of near and far, by name; `apex` are the lines from the eye to near.
    - `dimmable`: all but the planes' tints, which `tint` sets.
    """

    def __init__(self, state: WorldState) -> None:
        self._state, self._canvas = state, state.canvas
        style = state.style
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
        self.outlines = {NEAR.name: near_line, FAR.name: far_line}
        self.tints = {NEAR.name: (near_face, near_tint), FAR.name: (far_face, far_tint)}
        self._quiet: frozenset[str] = frozenset()
        edges = [(i, i + 4) for i in range(4)]
        self._body = actors.line_actor(CUBE, edges, style.frustum, width)
        self._body_space.add(self._body)
        apex = [(0.0, 0.0, 0.0), *CUBE[:4]]
        self.apex = actors.line_actor(
            apex, [(0, i) for i in range(1, 5)], style.frustum, width / 2.0
        )
        self.apex_space.add(self.apex)
        self.breaks: dict[str, list[tuple[Space, vtkActor]]] = {end: [] for end in ENDS}
        self._break_ends: dict[str, Array] = {}  # of the edges before a plane that are broken
        for broken_edges in self.breaks.values():
            for _ in range(4):
                edge = actors.line_actor(*_broken_edge(), style.frustum, width)
                broken_edges.append((Space(), edge))
                broken_edges[-1][0].add(edge)
        broken = [edge for edges in self.breaks.values() for _, edge in edges]
        lines = near_line, far_line, self._body, self.apex, *broken
        self.dimmable = *lines, walls
        self._parts = *lines, far_face, walls, near_face
        self._shown: tuple[vtkActor, ...] = ()
        self._canvas.add(*self._parts, layer="frustum")
        self._make_emphasis(broken)

    def _make_emphasis(self, broken: list[vtkActor]) -> None:
        state, emphasis = self._state, self._state.emphasis
        emphasis.volume(self.space, CUBE)
        for name, line in self.outlines.items():
            emphasis.line(line, name, of=_NAMED_BY[name])
        emphasis.line(self.apex, "fov", of=_VOLUME)
        for line in (self._body, *broken):
            emphasis.line(line, of=_VOLUME)
        self._measured = dict[str, str]()  # what stands before a plane's distance
        self._labels = dict[str, SceneLabel]()  # of the planes
        for name in ENDS:
            letter = state.words.get(f"{{{name}_distance}}", name)
            self._measured[name] = f"{state.words[name]} {letter} = "
            label = state.board.label(name, state.words[name], getattr(state.style, name))
            emphasis.label(label, name)
            self._labels[name] = label
        for letter, side in WINDOW.items():
            emphasis.label(state.board.label(letter, "", state.style.near), side)

    def show(self) -> None:
        state = self._state
        depths = self._depths_of(state.projection.lens, state.standing)
        self._break_ends = {}
        if depths is None:
            state.volume = self._show_whole(state.projection, state.standing)
        else:
            state.volume = self._show_broken(state.projection, state.standing, depths)

    def _show_whole(self, projection: Projection, standing: CameraPose) -> DrawnVolume:
        """Draw the cube under the inverse of a free matrix; nothing if it has none."""
        exists, corners = projection.frustum_sign != 0, np.tile(standing.eye, (8, 1))
        self._show_parts(*((*self._volume, self._body) if exists else ()))
        if exists:
            reversed_range = projection.with_depth("reversed")
            local_from_cube = reversed_range.world_from_clip_at(self._state.origin)
            frustum = normalised(projection.frustum_sign * local_from_cube)
            corners = np.clip(applied(frustum, CUBE), -WIDEST, WIDEST)
            self.space.set(frustum)
            self._body_space.set(frustum)
        return DrawnVolume(corners, None, exists)

    def _show_broken(
        self, projection: Projection, standing: CameraPose, reach: DrawnDepths
    ) -> DrawnVolume:
        """Draw a lens' frustum, with breaks where a plane is not drawn at its own distance."""
        lens, local_from_view = projection.lens, standing.local_from_view
        parts = [*self._volume]
        whole = view_from_cube(projection, reach.near, reach.far)
        frustum = normalised(local_from_view @ whole)
        start, end = reach.body
        if start < end:
            parts.append(self._body)
            self._body_space.set(frustum @ _cube_from_part(whole, start, end))
        self.space.set(frustum)
        for name, broken in zip(ENDS, (reach.near_break, reach.far_break), strict=True):
            if broken is not None:
                cut = frustum @ _cube_from_part(whole, *broken)
                self._break_ends[name] = applied(cut, CUBE)
                parts += [edge for _, edge in self.breaks[name]]
        if lens.central:
            parts.append(self.apex)
            base = frustum
            if reach.near_break is not None:
                base = normalised(local_from_view @ view_from_cube(projection, *reach.near_break))
            self.apex_space.set(base @ _CUBE_FROM_PYRAMID)
        self._show_parts(*parts)
        return DrawnVolume(applied(frustum, CUBE), reach, exists=True)

    def _show_parts(self, *parts: vtkActor) -> None:
        """Show these actors, and no others."""
        if parts != self._shown:
            self._shown = parts
            others = [part for part in self._parts if part not in parts]
            self._canvas.set_visible(True, *parts)
            self._canvas.set_visible(False, *others)

    def _depths_of(self, lens: Lens, standing: CameraPose) -> DrawnDepths | None:
        if lens.planes is None:
            return None
        size, extent = self._state.scene.size, standing.extent
        nearby_target = min(standing.camera.distance, 2.0 * extent)
        deepest = max(standing.objects_depth, self._held_depth(standing))
        high = _BEYOND * max(deepest, nearby_target, 0.5 * size)
        near, far = lens.planes
        if lens.central:
            low = 0.0
            near = max(near, 1e-12 * high)  # nobody sees the difference; float32 does
        else:
            low = -0.5 * _BEYOND * extent
        near_break = far_break = start = end = None
        if near > _BREAK * high:
            near, near_break = _BREAK * high, (_BREAK**2 * high, _BREAK * high)
        elif near < low:
            near, near_break, start = low, (low, _BREAK * low), _BREAK * low
        if far > high:
            far, far_break, end = high, (_BREAK * high, high), _BREAK * high
        elif far < _BREAK * low:
            far, far_break = _BREAK * low, (_BREAK * low, _BREAK**2 * low)
        far = max(far, near + 1e-9 * (high - low))
        body = start or near, end or far
        return DrawnDepths(low, high, near, far, near_break, far_break, body)

    def _held_depth(self, standing: CameraPose) -> float:
        """The largest depth of a scene's grips, of those near the scene; 0 without any."""
        shown = self._state.illustration
        offsets = [grip.point - standing.camera.eye for grip in (shown.grips if shown else ())]
        largest = _HELD_NEAR * self._state.scene.size
        near = [offset for offset in offsets if math.hypot(*offset) <= largest]
        return max((-float(offset @ standing.camera.frame[2]) for offset in near), default=0.0)

    def show_names(self) -> None:
        """Tint the planes that are not named more palely, from the next `settle` on."""
        names = self._state.names
        self._quiet = frozenset(
            name for name in self.tints if not any(each in names for each in _NAMED_BY[name])
        )

    def settle(self) -> None:
        """Tint the planes, less where they would flood the pane, and turn the breaks."""
        state, pane = self._state, self._state.own.pane
        # From the eye the planes cover all of the picture, and one another.
        light = 0.0 if state.own.sees_from_eye else state.light
        parts = pane.parts_covered(state.volume.corners, _FADE_FROM)
        for (name, (tint, opacity)), part in zip(self.tints.items(), parts, strict=True):
            flood = (part - _FADE_FROM) / (1.0 - _FADE_FROM)
            quiet = 1.0 - QUIET if name in self._quiet else 1.0
            tint.GetProperty().SetOpacity(
                light * quiet * opacity * (1.0 - (1.0 - _FADED) * max(0.0, flood))
            )
        self._turn_breaks()

    def _turn_breaks(self) -> None:
        """Turn the strokes of each broken edge into the plane of the screen."""
        pane, em = self._state.own.pane, self._state.em
        for name, ends in self._break_ends.items():
            starts, along = ends[:4], ends[4:] - ends[:4]
            x, y, depth = pane.axes @ (starts + _STROKES_AT * along - pane.eye).T
            depth = np.maximum(np.abs(depth), 1e-9 * self._state.standing.extent)
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

    # -- names, ink, pointing and framing

    def want(self, ground: Ground) -> None:
        """Ask for places of the window's sides, and of the planes with their distances."""
        state, planes = self._state, self._state.projection.lens.planes
        corners, written = state.corners_seen, state.written
        named = state.named_points(*ENDS, *SIDES, *WINDOW)
        if state.volume.exists and planes is not None:
            self._want_sides(named, written)
        if corners is None:
            return
        texts = state.words
        if planes is not None:
            digits = digits_apart(*planes)
            distances = [written_distance(plane, digits) for plane in planes]
            texts = dict(zip(ENDS, map(add, self._measured.values(), distances), strict=True))
        for name, label in self._labels.items():
            if name in named:
                label.set_text(texts[name])
        body = state.own.pane.seen(corners)
        for name, face in zip(ENDS, (slice(4), slice(4, 8)), strict=True):
            if name in named:
                covered = partial(state.own.pane.covered, corners[face])
                want_plane(state.board, ground, name, body[face], body, covered)

    def _want_sides(self, names: set[str], written: frozenset[str]) -> None:
        """Ask for a place beside each named side of the window, unless lengths write its name."""
        state, board, near = self._state, self._state.board, self._state.volume.corners[:4]
        window = state.projection.window
        if state.names.wanted is None:
            written |= _ONE_OVER_THE_OTHER.get(state.own.fixed, frozenset())
        named = [
            letter not in written and not names.isdisjoint((letter, side))
            for letter, side in WINDOW.items()
        ]
        if not any(named):
            return
        corners = np.roll(near, -1, axis=0)
        sides = near[:, None] + _ON_SIDE[:, None] * (corners - near)[:, None]
        middle, *spots = state.seen(np.vstack([near.mean(axis=0), sides.reshape(-1, 3)]))
        digits = [digits_apart(*pair) for pair in (window[:2], window[2:]) for _ in pair]
        for (letter, side), is_named, value, many in zip(
            WINDOW.items(), named, window, digits, strict=True
        ):
            if not is_named:
                continue
            word = state.words.get(f"{{{letter}}}", letter)
            asked = getattr(state.projection.lens, side, value)  # proportions may change it
            both = dict.fromkeys(written_distance(each, many) for each in (asked, value))
            text = f"{word} = {' → '.join(both)}"
            plain = f"fitted_{letter}"
            fitted = state.words.get(f"{{{plain}}}", plain)
            if fitted != plain and len(both) > 1:  # lecture 000 has letters for both
                k = written_distance(value - asked if letter in "rt" else asked - value, many)
                text = text.replace(" → ", f", k = {k}, {fitted} = ")
            board.label(letter).set_text(text)
            first = SIDES.index(side) * len(_ON_SIDE)
            beside = spots[first : first + len(_ON_SIDE)]
            marks = [(x, y) for x, y, depth in beside if depth > 0.0 and math.isfinite(x + y)]
            out = beside[0][0] - middle[0], beside[0][1] - middle[1]
            size, rim = board.label(letter).size_px, DOT_EM * state.em
            places = partial(flanking, marks, out, em=state.em, rim=rim)
            if marks:
                board.want(letter, marks, partial(places, size), SIDE, places)
            else:
                board.want(letter, marks, lambda: NOWHERE, SIDE)

    def ink(self, ground: Ground) -> None:
        corners, own = self._state.corners_seen, self._state.own
        if corners is not None:
            edges = own.pane.spots(corners[_EDGES])
            if self.apex.GetVisibility():
                eyes = np.broadcast_to(self._state.standing.eye, (4, 3))
                ground.ink_lines(own.pane.spots(np.stack([eyes, corners[:4]], axis=1)))
            # In a flat view a plane is one upright line: letters keep a square away from it.
            aside = SQUARE_EM * self._state.em if own.fixed in ("side", "top") else 0.0
            for shift in {-aside, 0.0, aside}:
                ground.ink_lines(edges + np.array([shift, 0.0]))

    def reach(self) -> Array:
        return self._state.volume.corners

    def inside(self) -> dict[str, Array]:
        """The whole frustum if near or far is named, else the named sides of the window."""
        state, corners = self._state, self._state.volume.corners
        has_planes = state.volume.exists and state.projection.lens.planes is not None
        if not has_planes or "frustum" in state.hidden:
            return {}
        asked = (*ENDS, "height", "width") if state.own.fixed else ENDS
        if any(map(state.names.wants, asked)):
            return {NEAR.name: corners[:4], FAR.name: corners[4:]}
        return {
            side[0]: corners[[i, (i + 1) % 4]]
            for i, side in enumerate(SIDES)
            if state.names.wants(side[0])
        }


def view_from_cube(projection: Projection, near: float, far: float) -> Array:
    """The inverse of `Projection.matrices_between`, (4, 4), as far as float32 can draw it."""
    matrix = projection.matrices_between(near, far)[1]
    widest = _STEEPEST if projection.lens.central else WIDEST
    matrix[:2] = np.clip(matrix[:2], -widest, widest)
    return matrix


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
    return np.asarray(matrix / np.abs(matrix).max())


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
