"""What a phenomenon draws over a pane: lines, faces, dots, letters, and the scene once more.

============  ============================================  =====================================
what          how it is drawn                               a change writes
============  ============================================  =====================================
lines, faces  among the scene, a little in front of what    points and colours of one mesh for
              they lie on                                   each width, one for the faces
dots, texts   before everything else, of constant size      the same; pixels of the texts
copies        the scene's own meshes under a further 4x4    16 numbers
============  ============================================  =====================================

Actors are made when an exhibit has more to show than any before it, and never taken out: a slider
step shows, hides and moves. Marks reach the GPU relative to the scene's origin, subtracted in
float64, and cut to a box that float32 can hold; a copy's matrix is moved there likewise::

    local_from_local = world_to_origin . world_from_world . origin_to_world

A translucent copy is drawn twice: first its depths alone, then the faces that are in front, so
that the far side of a thing does not shine through the near one. Where the matrix is singular
(a shadow) all faces lie at one depth and none is in front: it is mixed with the background
beforehand.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
import pyvista as pv
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings.actors import (
    Canvas,
    Detail,
    Label,
    Space,
    lift_lines,
    put_in_front,
    scene_actors,
    unlit_actor,
)
from app.drawings.labels import Layout, Spot
from app.drawings.style import Style, rgb
from app.model.clipping import LARGEST_CLIP, clip_polygon, clip_segments
from app.model.projection import Array
from app.scenes.phenomena.illustration import Copy, Dot, Face, Line, Marks, Text
from app.scenes.scene import Scene

DOT = 5.0
"""Diameter of an ordinary dot, in widths of a line."""
COPY_LIFT, COPY_LINES_LIFT = 0.5, 1.5
"""How far copies come forward, as a multiple of what the scene's own lines do: a shadow hides the
ground and not the grid that is drawn on it."""

_LINE_STEPS, _FACE_STEPS = 3, 0.7  # of `lift_lines`
_FLAT_LINES = -5e-5  # of the depth range, before faces, where all marks are in one plane
_DEPTH_ALONE = 1.0 / 512.0  # an opacity that colours nothing in 8 bits, and is not 0
_SPREAD, _GOLDEN = 120, 0.7548776662466927  # points over the subject; 1/plastic number
_MOST_FACES = 20_000  # of a subject that texts get out of the way of
_SINGULAR = 1e-12  # ratio of the singular values of a matrix that flattens
# Right and up of a text from its point, in half texts, best first.
_GAPS = 3
_BESIDE = ((1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (0.0, 1.0), (0.0, -1.0))


class Placing(NamedTuple):
    """From the coordinates of marks to those of the pane's actors: ``scale * point + shift``.

    Attributes
    ----------
    scale, shift : (3,) array
    limit : float
        Half the side of the box, about the actors' origin, that marks are cut to.
    """

    scale: Array
    shift: Array
    limit: float

    def placed(self, points: Array) -> Array:
        """Points (n, 3), or (n, 2) in a plane, as actors have them, (n, 3)."""
        if points.shape[1] == 2:
            points = np.column_stack([points, np.zeros(len(points))])
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is dropped
            placed: Array = self.scale * points + self.shift
        return placed


class MarksDrawing:
    """An exhibit in one pane.

    Parameters
    ----------
    canvas : Canvas
    scene : Scene
        What copies are copies of.
    style : Style
    words : mapping
        Texts that there is a word for are written with it: of another language.
    renderer : vtkRenderer, optional
        Where to draw; the pane's own if not given.
    clip : iterable of vtkPlane
        As for `scene_actors`; cuts copies.
    over : bool
        Whether marks lie in one plane before everything else.
    lifts_copies : bool
        Whether copies are brought forward here, and not by the matrices of `place_copies`.
    """

    def __init__(
        self,
        canvas: Canvas,
        scene: Scene,
        style: Style,
        words: Mapping[str, str],
        *,
        renderer: Any = None,
        clip: Iterable[vtkPlane] = (),
        over: bool = False,
        lifts_copies: bool = False,
    ) -> None:
        self._canvas, self._scene, self._style, self._renderer = canvas, scene, style, renderer
        self._words = words
        self._clip, self._over, self._lifts_copies = tuple(clip), over, lifts_copies
        self._lines: list[_Batch] = []
        self._dots: list[_Batch] = []
        self._faces: dict[bool, _Batch] = {}
        self._labels: list[Label] = []
        self._best: dict[Label, Sequence[int]] = {}
        self._copies: list[_CopyActors] = []
        self._colours: dict[tuple[str, int], NDArray[np.uint8]] = {}
        self._texts: list[str] = []
        self._text_points = self._dot_points = np.empty((0, 3))
        self._shown: list[tuple[Copy, _CopyActors, Array]] = []
        self.points = np.empty((0, 3))
        """What is marked, in the coordinates of the pane's actors, (n, 3)."""

    # -- marks

    def show(self, marks: Marks, placing: Placing) -> None:
        """Draw these marks, and no others; the texts wait for `place_texts`.

        Parameters
        ----------
        marks : Marks
            A point that is not finite, or too far away for what it belongs to, is left out.
        placing : Placing
        """
        drawn = [self._show_lines(marks.lines, placing), *self._show_faces(marks.faces, placing)]
        drawn.append(self._show_dots(marks.dots, placing))
        self._show_texts(marks.texts, placing)
        self.points = np.concatenate(drawn)

    def _show_lines(self, lines: Sequence[Line], placing: Placing) -> Array:
        lines = [line for line in lines if len(line.points) > 1]
        if not lines:
            for batch in self._lines:
                batch.hide()
            return np.empty((0, 3))
        counts = np.array([len(line.points) for line in lines])
        points = placing.placed(np.concatenate([line.points for line in lines]))
        if self._over:
            points[:, 2] += _FLAT_LINES
        starts = np.ones(len(points), dtype=np.bool_)
        starts[np.cumsum(counts) - 1] = False
        first = np.flatnonzero(starts)
        segments = points[np.stack([first, first + 1], axis=1)]
        widths = np.repeat([line.width for line in lines], counts - 1)
        colours = np.repeat([self._rgba(line.colour) for line in lines], counts - 1, axis=0)
        if not np.abs(points).max() <= placing.limit:  # also NaN
            segments, kept = _cut_segments(segments, placing.limit)
            widths, colours = widths[kept], colours[kept]
        # Wide lines get their direction from a difference that a driver must not find to be 0.
        long = (segments[:, 0] != segments[:, 1]).any(axis=1)
        if not long.all():
            segments, widths, colours = segments[long], widths[long], colours[long]
        distinct = sorted(set(widths.tolist()))
        while len(self._lines) < len(distinct):
            self._lines.append(self._batch("Lines"))
        for i, batch in enumerate(self._lines):
            if i < len(distinct):
                which = widths == distinct[i]
                batch.actor.GetProperty().SetLineWidth(distinct[i] * self._style.line_width)
                batch.show(segments[which], np.repeat(colours[which], 2, axis=0))
            else:
                batch.hide()
        return segments.reshape(-1, 3)

    def _show_faces(self, faces: Sequence[Face], placing: Placing) -> list[Array]:
        faces = [face for face in faces if len(face.points) > 2 and face.opacity > 0.0]
        shown: dict[bool, tuple[list[Array], list[NDArray[np.uint8]]]]
        shown = {True: ([], []), False: ([], [])}
        if faces:
            counts = [len(face.points) for face in faces]
            placed = placing.placed(np.concatenate([face.points for face in faces]))
            whole = bool(_within(placed, placing.limit).all())
            ends = np.cumsum(counts).tolist()
            for face, count, end in zip(faces, counts, ends, strict=True):
                points = placed[end - count : end]
                if not whole:
                    points = _cut_polygon(points, placing.limit)
                if len(points) > 2:
                    corners, colours = shown[face.opacity >= 1.0]
                    corners.append(points)
                    colours.append(self._rgba(face.colour, min(face.opacity, 1.0)))
        drawn = []
        for opaque, (corners, colours) in shown.items():
            if corners:
                if opaque not in self._faces:
                    self._faces[opaque] = self._batch("Polys", opaque=opaque)
                drawn += corners
                sizes = [len(points) for points in corners]
                self._faces[opaque].show(
                    np.concatenate(corners), np.repeat(colours, sizes, axis=0), sizes
                )
            elif opaque in self._faces:
                self._faces[opaque].hide()
        return drawn

    def _show_dots(self, dots: Sequence[Dot], placing: Placing) -> Array:
        points = _placed_each(dots, placing)
        near = _within(points, placing.limit)
        sizes = np.where(near, [dot.size for dot in dots], np.nan) if dots else np.empty(0)
        colours = [self._rgba(dot.colour) for dot in dots]
        distinct = sorted(set(sizes[near].tolist()), reverse=True)  # small ones on large ones
        while len(self._dots) < len(distinct):
            self._dots.append(self._batch("Verts"))
        for i, batch in enumerate(self._dots):
            if i < len(distinct):
                which = np.flatnonzero(sizes == distinct[i])
                size = distinct[i] * DOT * self._style.line_width
                batch.actor.GetProperty().SetPointSize(size)
                batch.show(points[which][:, None], np.array([colours[j] for j in which]))
            else:
                batch.hide()
        self._dot_points = points[near]
        return self._dot_points

    def _show_texts(self, texts: Sequence[Text], placing: Placing) -> None:
        points = _placed_each(texts, placing)
        near = np.flatnonzero(_within(points, placing.limit)).tolist()
        words = [self._words.get(texts[i].text, texts[i].text) for i in near]
        self._text_points, self._texts = points[near], words
        style = self._style
        while len(self._labels) < len(near):
            label = self._canvas.label(
                "", renderer=self._renderer, plate=style.ink, in_pixels=True, bold=True
            )
            self._labels.append(label)
        for label, i, word in zip(self._labels, near, words, strict=False):
            label.set_plate(self._named(texts[i].colour or "background"))
            label.set_text(word)
        for label in self._labels[len(near) :]:
            label.set_visible(False)

    def place_texts(
        self,
        layout: Layout,
        seen: Callable[[Array], Sequence[Spot]],
        subject: Array | None = None,
    ) -> None:
        """Put each text beside its point, where it hides no dot and no other label.

        Parameters
        ----------
        layout : Layout
            Of the renderer, where other labels have their places already.
        seen : callable
            From points of the pane's actors, (n, 3), to where they are in the renderer.
        subject : (n, 2) array, optional
            Where `spread_over` of the scene is seen: what texts rather do not hide. If it is not
            given, they stay on the sides that were best then, so that a drag makes none jump.
        """
        if not self._texts:
            return
        count = len(self._texts)
        spots = seen(np.concatenate([self._text_points, self._dot_points]))
        layout.keep_free([spot for spot in spots[count:] if spot[2] > 0.0])
        for label, text, spot in zip(self._labels, self._texts, spots, strict=False):
            label.set_size(layout.em)
            if subject is not None:
                self._best[label] = layout.least_hiding(text, spot, _BESIDE, _GAPS, subject)
            best = self._best.get(label, ())
            if layout.place(label, text, [spot], _BESIDE, gaps=_GAPS, best=best):
                label.set_visible(True)

    # -- copies

    def show_copies(self, copies: Sequence[Copy]) -> None:
        """Draw these copies, and no others; they wait for `place_copies`."""
        while len(self._copies) < len(copies):
            self._copies.append(_CopyActors())
        self._shown = []
        origin = np.array(self._scene.origin)
        made = False
        for actors, copy in zip(self._copies, copies, strict=False):
            matrix = np.array(copy.world_from_world, dtype=np.float64)
            visible = bool(np.isfinite(matrix).all() and matrix.any() and copy.opacity > 0.0)
            if visible:
                matrix[:, 3] += matrix[:, :3] @ origin
                matrix[:3] -= np.outer(origin, matrix[3])
                made = self._build(actors, copy) or made
                self._shown.append((copy, actors, matrix))
            self._dress(actors, copy if visible else None, matrix)
        for actors in self._copies[len(copies) :]:
            self._dress(actors, None, np.eye(4))
        if made:
            self._bring_depths_last()

    def place_copies(self, pane_from_local: Callable[[float], Array]) -> None:
        """Set the copies' matrices.

        Parameters
        ----------
        pane_from_local : callable
            The scene's own matrix in this pane, (4, 4), for a multiple of how far its lines come
            forward.
        """
        for _, actors, local_from_local in self._shown:
            actors.faces_space.set_projective(pane_from_local(COPY_LIFT) @ local_from_local)
            if actors.lines is not None:
                matrix = pane_from_local(COPY_LINES_LIFT) @ local_from_local
                actors.lines_space.set_projective(matrix)

    @property
    def copied_faces(self) -> list[tuple[vtkActor, Space]]:
        """The faces of all copies there ever were, and what they stand under."""
        return [
            (copy.surface, copy.faces_space) for copy in self._copies if copy.surface is not None
        ]

    def copied(self, faces: Array, lines: Array) -> Array:
        """Where the copies have these points of the scene, (n, 4) homogeneous, scene-local.

        Parameters
        ----------
        faces, lines : (n, 3) arrays
            About the scene's faces, and about its lines; only the copies of lines have these.
        """
        parts = [np.empty((0, 4))]
        for copy, _, matrix in self._shown:
            for points in (faces, lines)[: 1 + copy.lines]:
                parts.append(np.column_stack([points, np.ones(len(points))]) @ matrix.T)
        return np.concatenate(parts)

    def show_detail(self, fewer: Scene | None) -> None:
        """Draw copies of a scene with fewer triangles, or of all that there are for None."""
        for copy in self._copies:
            for detail in copy.details:
                detail.show(fewer)

    def _build(self, actors: _CopyActors, copy: Copy) -> bool:
        """Make what a copy needs and has not got; whether that was anything."""
        translucent = copy.opacity < 1.0
        has_lines = actors.lines is not None or not copy.lines
        if actors.made and has_lines and (actors.depths is not None or not translucent):
            return False
        if not actors.made:
            actors.surface, _ = self._scene_actors(actors)
            actors.made = True
        if translucent and actors.depths is None:
            actors.depths, _ = self._scene_actors(actors)
            if actors.depths is not None:
                actors.depths.GetProperty().SetOpacity(_DEPTH_ALONE)
                actors.depths.ForceOpaqueOn()
        if not has_lines:
            _, actors.lines = self._scene_actors(actors, faces=False)
        return True

    def _scene_actors(
        self, actors: _CopyActors, *, faces: bool = True
    ) -> tuple[vtkActor | None, vtkActor | None]:
        surface, lines = scene_actors(self._scene, self._style, self._clip)
        actor, space, lift = (
            (surface, actors.faces_space, COPY_LIFT)
            if faces
            else (lines, actors.lines_space, COPY_LINES_LIFT)
        )
        if faces:
            actors.details.append(Detail(surface))
        if actor is not None:
            space.add(actor)
            if self._lifts_copies:
                lift_lines(actor, lift)
            self._canvas.add(actor, renderer=self._renderer)
        return surface, lines

    def _dress(self, actors: _CopyActors, copy: Copy | None, matrix: Array) -> None:
        """Show a copy's actors in its colour, or none of them."""
        translucent = copy is not None and copy.opacity < 1.0
        flattened = False
        if translucent:
            values = np.linalg.svd(matrix / np.abs(matrix).max(), compute_uv=False)
            flattened = bool(values[-1] <= _SINGULAR * values[0])
        for actor, visible in (
            (actors.surface, copy is not None),
            (actors.depths, translucent and not flattened),
            (actors.lines, copy is not None and copy.lines),
        ):
            if actor is None:
                continue
            actor.SetVisibility(visible)
            if not visible or copy is None:
                continue
            actor.GetMapper().SetScalarVisibility(not copy.colour)
            opacity = copy.opacity
            if copy.colour:
                colour = np.array(rgb(self._named(copy.colour)))
                if flattened:
                    behind = np.array(rgb(self._style.background))
                    colour, opacity = opacity * colour + (1.0 - opacity) * behind, 1.0
                actor.GetProperty().SetColor(*colour)
            if actor is not actors.depths:
                actor.GetProperty().SetOpacity(opacity)

    def _bring_depths_last(self) -> None:
        """What is opaque and drawn after a translucent copy's depths would be hidden by it."""
        depths = [copy.depths for copy in self._copies if copy.depths is not None]
        if depths:
            self._canvas.bring_last(*depths)

    # -- shared

    def _named(self, colour: str) -> str:
        """``"#rrggbb"`` for the name of one of the style's colours."""
        return colour if colour.startswith("#") else str(getattr(self._style, colour))

    def _rgba(self, colour: str, opacity: float = 1.0) -> NDArray[np.uint8]:
        key = colour, round(255.0 * opacity)
        found = self._colours.get(key)
        if found is None:
            parts = [round(255.0 * part) for part in rgb(self._named(colour))]
            found = self._colours[key] = np.array([*parts, key[1]], dtype=np.uint8)
        return found

    def _batch(self, kind: Literal["Lines", "Polys", "Verts"], *, opaque: bool = True) -> _Batch:
        batch = _Batch(kind)
        if opaque:
            batch.actor.ForceOpaqueOn()
        else:
            batch.actor.ForceTranslucentOn()
        if kind == "Verts":
            batch.actor.GetProperty().RenderPointsAsSpheresOn()
            put_in_front(batch.actor)
        elif not self._over:
            lift_lines(batch.actor, _LINE_STEPS if kind == "Lines" else _FACE_STEPS)
        self._canvas.add(batch.actor, renderer=self._renderer)
        self._bring_depths_last()
        return batch


def spread_over(scene: Scene) -> Array:
    """Points all over a scene's faces, evenly by area, (`_SPREAD`, 3) scene-local; or none."""
    if scene.surface is None or scene.surface.n_cells > _MOST_FACES:
        return np.empty((0, 3))
    mesh = scene.surface.triangulate()
    corners = np.asarray(mesh.points, dtype=np.float64)[mesh.regular_faces]
    sides = corners[:, 1:] - corners[:, :1]
    ends = np.cumsum(np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1))
    if not ends[-1] > 0.0:
        return np.empty((0, 3))
    at, u = (np.arange(_SPREAD) + 0.5) / _SPREAD, np.arange(_SPREAD) * _GOLDEN % 1.0
    v = np.arange(_SPREAD) * _GOLDEN**2 % 1.0
    u, v = np.where(u + v > 1.0, 1.0 - u, u), np.where(u + v > 1.0, 1.0 - v, v)
    which = np.minimum(np.searchsorted(ends, at * ends[-1]), len(ends) - 1)
    one, other = sides[which, 0], sides[which, 1]
    spread: Array = corners[which, 0] + u[:, None] * one + v[:, None] * other
    return spread


class _CopyActors:
    """What one copy is drawn with, each part made when it is first needed."""

    def __init__(self) -> None:
        self.made = False
        self.surface: vtkActor | None = None
        self.depths: vtkActor | None = None
        self.lines: vtkActor | None = None
        self.faces_space, self.lines_space = Space(), Space()
        self.details: list[Detail] = []


class _Batch:
    """Cells that change together, each point in a colour of its own, under one actor."""

    def __init__(self, kind: Literal["Lines", "Polys", "Verts"]) -> None:
        self._kind = kind
        self._mesh = pv.PolyData()
        self._sizes: list[int] = []
        self._points: NDArray[np.float32] = np.empty((0, 3), np.float32)
        self._rgba: NDArray[np.uint8] = np.empty((0, 4), np.uint8)
        self.actor = unlit_actor(self._mesh)
        mapper = self.actor.GetMapper()
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("rgba")
        mapper.SetColorModeToDirectScalars()
        mapper.ScalarVisibilityOn()
        self.actor.SetVisibility(False)

    def hide(self) -> None:
        """Draw nothing."""
        self.actor.SetVisibility(False)

    def show(
        self, points: Array, rgba: NDArray[np.uint8], sizes: Sequence[int] | None = None
    ) -> None:
        """Draw these cells, and no others.

        Parameters
        ----------
        points : (m, k, 3) array, or (n, 3) if `sizes` are given
        rgba : (n, 4) uint8 array
            Of each point.
        sizes : sequence of int, optional
            How many points each cell has.
        """
        cells = [points.shape[1]] * len(points) if sizes is None else list(sizes)
        if cells != self._sizes:
            self._resize(cells)
        self._points[:] = points.reshape(-1, 3)
        self._rgba[:] = rgba
        self._mesh.GetPoints().GetData().Modified()
        self._mesh.GetPoints().Modified()
        self._mesh.GetPointData().GetArray("rgba").Modified()
        self._mesh.Modified()
        self.actor.SetVisibility(True)

    def _resize(self, sizes: list[int]) -> None:
        self._sizes = sizes
        ends = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
        count = int(ends[-1])
        self._points = np.empty((count, 3), dtype=np.float32)
        self._rgba = np.empty((count, 4), dtype=np.uint8)
        points, cells = vtkPoints(), vtkCellArray()
        points.SetData(numpy_to_vtk(self._points))  # type: ignore[no-untyped-call]
        colours = numpy_to_vtk(self._rgba)  # type: ignore[no-untyped-call]
        colours.SetName("rgba")
        corners = numpy_to_vtk(np.arange(count, dtype=np.int64), deep=True)  # type: ignore[no-untyped-call]
        cells.SetData(numpy_to_vtk(ends, deep=True), corners)  # type: ignore[no-untyped-call]
        self._mesh.SetPoints(points)
        self._mesh.GetPointData().AddArray(colours)
        getattr(self._mesh, f"Set{self._kind}")(cells)


# --------------------------------------------------------------------------- cutting


def _placed_each(marks: Sequence[Dot | Text], placing: Placing) -> Array:
    """Where the points of dots or texts are, (n, 3)."""
    if not marks:
        return np.empty((0, 3))
    return placing.placed(np.array([mark.point for mark in marks], dtype=np.float64))


def _within(points: Array, limit: float) -> NDArray[np.bool_]:
    """Which points (..., 3) are in the box."""
    return np.asarray((np.abs(points) <= limit).all(axis=-1))  # NaN is not


def _in_box(points: Array, limit: float) -> Array:
    """Points as clip coordinates of the box, whose planes are those of the NDC cube."""
    return np.concatenate([points / limit, np.ones((*points.shape[:-1], 1))], axis=-1)


def _cut_segments(segments: Array, limit: float) -> tuple[Array, NDArray[np.intp]]:
    """What is inside the box of segments (m, 2, 3), and of which each is left."""
    kept = _within(segments, limit).all(axis=1)
    crossing = ~kept & _within(segments, LARGEST_CLIP * min(limit, 1.0)).all(axis=1)
    clip = _in_box(segments[crossing], limit)
    cut = clip_segments(clip[:, 0], clip[:, 1])
    ends = cut.points_clip[cut.visible]
    owners = np.flatnonzero(crossing)[cut.visible]
    left = np.concatenate([segments[kept], ends[..., :3] / ends[..., 3:] * limit])
    return left, np.concatenate([np.flatnonzero(kept), owners])


def _cut_polygon(points: Array, limit: float) -> Array:
    """What is inside the box of a polygon (k, 3); nothing of one that is not finite."""
    if _within(points, limit).all():
        return points
    if not _within(points, LARGEST_CLIP * min(limit, 1.0)).all():
        return np.empty((0, 3))
    inside = clip_polygon(_in_box(points, limit)).points_clip
    left: Array = inside[:, :3] / inside[:, 3:] * limit
    return left
