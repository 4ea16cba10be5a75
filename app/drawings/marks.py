"""A phenomenon's marks over a pane: lines, faces, dots, texts, and copies of the scene.

============  ============================================  =====================================
what          how it is drawn                               a change writes
============  ============================================  =====================================
lines, faces  in the scene, a little in front of what       points and colours of one mesh for
              they lie on                                   each width, one for the faces
dots, texts   before everything else, of constant size      the same; pixels of the texts
copies        the scene's own faces under a further 4x4     16 numbers
============  ============================================  =====================================

Actors are created when an illustration needs more than any earlier one, and never removed: a slider
step shows, hides and moves. Marks reach the GPU relative to the scene's origin, subtracted in
float64, and cut to a box that float32 can hold; a copy's matrix is moved there likewise::

    local_from_local = world_to_origin . world_from_world . origin_to_world
"""

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings import actors
from app.drawings.label_placement import MARGIN_EM, Ground, on
from app.drawings.labels import DOT_EM, SCENE
from app.drawings.layer import NO_POINTS, Layer, PaneState, Placing, together
from app.drawings.style import QUIET, QUIET_WIDTH, mixed, rgb
from app.lecture.highlight import NOTHING, Highlight
from app.model.clipping import LARGEST_CLIP, clip_polygon, clip_segments
from app.model.parameters import NEAR
from app.model.projection import Array
from app.scenes.phenomena.marks import Copy, Dot, Face, Marks, Polyline, Text
from app.scenes.poly_mesh import PolyMesh, cells_from
from app.scenes.scene import Scene

DOT = 3.75  # diameter of an ordinary dot, in widths of a line
COPY_LIFT = 0.5
"""How far copies come forward, as a multiple of what the scene's own lines do: a shadow hides the
ground and not the grid that is drawn on it."""

_FRAMED = 5.0  # of the scene's size: of all marks, those farther away are not framed
_LINE_STEPS, _FACE_STEPS = 3, 0.7  # of `lift_lines`
_FLAT_LINES = -5e-5  # of the depth range, before faces, where all marks are in one plane
_WIDER = 2.4  # a line that is highlighted
_NEAR_WIDER = 1.6  # on paper


class MarksDrawing(Layer):
    """An illustration in one pane, which says where its coordinates are drawn (`PaneState`).

    `clip` are planes that cut copies. With `over`, marks lie in one plane before everything else.
    With `lifts_copies`, copies are brought forward here, and not by their matrices.
    """

    needs = "illustration"
    is_empty = True  # whether there has been no illustration yet

    def __init__(
        self,
        state: PaneState,
        *,
        clip: Iterable[vtkPlane] = (),
        over: bool = False,
        lifts_copies: bool = False,
    ) -> None:
        self._state, self._canvas, self._style = state, state.canvas, state.style
        self._clip, self._over, self._lifts_copies = tuple(clip), over, lifts_copies
        self._lines: list[_Batch] = []
        self._dots: list[_Batch] = []
        self._faces: _Batch | None = None
        self._board, self._names = state.board, state.names
        self._texts: list[tuple[tuple[str, str, int], Text]] = []
        """Each text, and its key on the board."""
        self._copies: list[_CopyActors] = []
        self._colours: dict[tuple[str, int, bool], NDArray[np.uint8]] = {}
        self._text_points = self._dot_points = self._away_points = NO_POINTS
        self._segments = NO_POINTS
        self._shown: list[tuple[_CopyActors, Array]] = []
        self._now: tuple[Marks, Placing] | None = None
        self._highlighted = NOTHING
        self._points = NO_POINTS
        self._named_in_view: dict[str, Array] = {}

    # -- marks

    def show(self) -> None:
        """Draw the marks of the illustration, and no others.

        Points that are not finite, or too far away, are dropped.
        """
        state, illustration = self._state, self._state.marked
        if illustration is None:
            if self._now is not None:
                self._show(Marks(), Placing(np.ones(3), np.zeros(3), 1.0))
                self._show_copies(())
            return
        self._show(getattr(illustration, state.pane), state.placing())
        self._show_copies([copy for copy in illustration.copies if state.pane in copy.panes])
        self.settle()

    def _show(self, marks: Marks, placing: Placing) -> None:
        self._now, self.is_empty = (marks, placing), False
        drawn = [self._show_lines(marks.lines, placing), *self._show_faces(marks.faces, placing)]
        drawn.append(self._show_dots(marks.dots, placing))
        self._show_texts(self._named_texts, placing)
        self._points = np.concatenate(drawn)
        self._named_in_view = self._named_points(marks, placing)

    def _named_points(self, marks: Marks, placing: Placing) -> dict[str, Array]:
        wanted, named = self._names.wanted or (), list[tuple[str, Any]]()
        named += [(line.name, line.points) for line in marks.lines if line.name in wanted]
        named += [(face.name, face.points) for face in marks.faces if face.name in wanted]
        named += [(dot.name, [dot.point]) for dot in marks.dots if dot.name in wanted]
        named += [(text.name, [text.point]) for text in marks.texts if text.name in wanted]
        joined = together((name, np.asarray(points)) for name, points in named)
        placed = ((name, placing.placed(points)) for name, points in joined.items())
        return {name: points[_within(points, placing.limit)] for name, points in placed}

    @property
    def _named_texts(self) -> Sequence[Text]:
        if self._now is None:
            return ()
        texts, names = self._now[0].texts, self._names
        return [t for t in texts if t.name in names or names.pointed.intersection(t.about)]

    def show_names(self) -> None:
        if self._now is not None:
            self._show(*self._now)

    def _quiet(self, mark: Polyline | Face | Dot) -> bool:
        return mark.name != "" and mark.name not in self._names

    def show_highlight(self, highlighted: Highlight) -> bool:
        before, self._highlighted = self._highlighted, highlighted
        if self._now is None:
            return False
        marks, placing = self._now
        abouts = [line.about for line in marks.lines] + [text.about for text in marks.texts]
        names = frozenset[str]().union(*abouts)
        if before & names == highlighted & names:
            return False
        self._show_lines(marks.lines, placing)
        self._underline_texts()
        return True

    def _underline_texts(self) -> None:
        for key, text in self._texts:
            self._board.label(key).set_underlined(bool(self._highlighted.intersection(text.about)))

    def _show_lines(self, lines: Sequence[Polyline], placing: Placing) -> Array:
        lines = [line for line in lines if len(line.points) > 1]
        if not lines:
            for batch in self._lines:
                batch.hide()
            self._segments = NO_POINTS
            return self._segments
        counts = np.array([len(line.points) for line in lines])
        points = placing.placed(np.concatenate([line.points for line in lines]))
        if self._over:
            points[:, 2] += _FLAT_LINES
        starts = np.ones(len(points), dtype=np.bool_)
        starts[np.cumsum(counts) - 1] = False
        first = np.flatnonzero(starts)
        segments = points[np.stack([first, first + 1], axis=1)]
        lit = [bool(self._highlighted.intersection(line.about)) for line in lines]
        quiet = [self._quiet(line) and not on for line, on in zip(lines, lit, strict=True)]
        wide = np.where(lit, _WIDER, np.where(quiet, QUIET_WIDTH, 1.0))
        if self._style.on_paper:  # near differs from far in grey, too
            wide = np.where([line.colour == NEAR.name for line in lines], _NEAR_WIDER * wide, wide)
        widths = np.repeat([line.width for line in lines] * wide, counts - 1)
        each = zip(lines, quiet, strict=True)
        rgba = [self._rgba(line.colour, quiet=is_quiet) for line, is_quiet in each]
        colours = np.repeat(rgba, counts - 1, axis=0)
        if not np.abs(points).max() <= placing.limit:  # also NaN
            segments, kept = _cut_segments(segments, placing.limit)
            widths, colours = widths[kept], colours[kept]
        # VTK computes a wide line's direction from this difference, which must not be 0.
        long = (segments[:, 0] != segments[:, 1]).any(axis=1)
        if not long.all():
            segments, widths, colours = segments[long], widths[long], colours[long]
        for batch, width, which in self._batches(self._lines, "Lines", widths):
            batch.actor.GetProperty().SetLineWidth(width * self._style.line_width)
            batch.show(segments[which], np.repeat(colours[which], 2, axis=0))
        self._segments = segments.reshape(-1, 3)
        return self._segments

    def _show_faces(self, faces: Sequence[Face], placing: Placing) -> list[Array]:
        corners: list[Array] = []
        colours: list[NDArray[np.uint8]] = []
        if faces:
            counts = [len(face.points) for face in faces]
            placed = placing.placed(np.concatenate([face.points for face in faces]))
            whole = bool(_within(placed, placing.limit).all())
            for face, points in zip(faces, np.split(placed, np.cumsum(counts)[:-1]), strict=True):
                if not whole:
                    points = _cut_polygon(points, placing.limit)
                if len(points) > 2:
                    corners.append(points)
                    opacity = face.opacity * (1.0 - QUIET if self._quiet(face) else 1.0)
                    colours.append(self._rgba(face.colour, opacity))
        if corners:
            if self._faces is None:
                self._faces = self._batch("Polys")
            sizes = [len(points) for points in corners]
            self._faces.show(np.concatenate(corners), np.repeat(colours, sizes, axis=0), sizes)
        elif self._faces is not None:
            self._faces.hide()
        return corners

    def _show_dots(self, dots: Sequence[Dot], placing: Placing) -> Array:
        points = _placed_each(dots, placing)
        near = _within(points, placing.limit)
        sizes = np.where(near, [dot.size for dot in dots], np.nan) if dots else np.empty(0)
        colours = [self._rgba(dot.colour, quiet=self._quiet(dot)) for dot in dots]
        for batch, size, which in self._batches(self._dots, "Verts", sizes):
            batch.actor.GetProperty().SetPointSize(size * DOT * self._style.line_width)
            batch.show(points[which][:, None], np.array([colours[j] for j in which]))
        self._dot_points = points[near]
        return self._dot_points

    def _show_texts(self, texts: Sequence[Text], placing: Placing) -> None:
        points = _placed_each(texts, placing)
        near = np.flatnonzero(_within(points, placing.limit)).tolist()
        self._text_points = points[near]
        away = [texts[i] if texts[i].away_from is None else _away(texts[i]) for i in near]
        self._away_points = _placed_each(away, placing)
        self._texts, seen = [], Counter[str]()
        for text in (texts[i] for i in near):
            key = "text", text.name, seen[text.name]
            seen[text.name] += 1
            label = self._board.label(key)
            label.set_colour(self._named(text.colour or "ink"))
            label.set_text(self._state.words.get(text.text, text.text))
            self._texts.append((key, text))
        self._underline_texts()

    def want(self, ground: Ground) -> None:
        """Ask for a place for each text, except those whose names are written already."""
        count, board = len(self._text_points), self._board
        if not count + len(self._dot_points):
            return
        points = np.concatenate([self._text_points, self._away_points, self._dot_points])
        spots = self._state.seen(points)
        ground.keep([spot for spot in spots[2 * count :] if spot[2] > 0.0], DOT_EM * board.em)
        written = self._state.written
        for place, (key, text) in enumerate(self._texts):
            if key[1] in written:
                continue
            spot, away = spots[place], spots[count + place]
            if text.is_title:
                (x, y, _), high = spot, board.label(key).size_px[1]
                below = partial(on, (x, y - high / 2.0 - 1.1 * MARGIN_EM * board.em))
                board.want(key, [(x, y)], below, SCENE + place / 100.0)
                continue
            way = spot[0] - away[0], spot[1] - away[1]
            board.want_beside(key, spot, SCENE + place / 100.0, way if any(way) else None)

    def ink(self, ground: Ground) -> None:
        if len(self._segments):
            ground.ink_lines(self._state.spots(self._segments).reshape(-1, 2, 2))
        if self._shown:
            state, triangles = self._state, self._state.silhouette.triangles
            shown = np.eye(4) if state.pane == "world" else state.copies_from_local(0.0)
            x, y, z, w = shown @ self._copied(triangles.reshape(-1, 3)).T
            w = np.where(w > 0.0, w, np.nan)
            spots = state.spots(np.column_stack([x / w, y / w, z / w]))
            state.silhouette.ink(ground, spots.reshape(-1, *triangles.shape[1:2], 2))

    def reach(self) -> Array:
        """The marked points and the copies of the objects, of those that are not too far away."""
        if self._now is None or not self._shown:
            return self._points
        x, y, z, w = self._copied(self._state.objects).T
        w = np.where(w > 0.0, w, np.nan)  # behind a plane that goes to infinity: not drawn
        with np.errstate(over="ignore"):
            copied = np.column_stack([x / w, y / w, z / w])
        return np.concatenate([self._points, copied[_within(copied, self._now[1].limit)]])

    def inside(self) -> dict[str, Array]:
        """The points of the marks that the picture was told to name; without a list, of all."""
        state = self._state
        if self._names.wanted is None:
            points = self.reach()
            away = np.linalg.norm(points - state.objects.mean(axis=0), axis=1)
            return {"marks": points[away <= _FRAMED * state.scene.size]}
        return {name: state.framed(points) for name, points in self._named_in_view.items()}

    # -- copies

    def _show_copies(self, copies: Sequence[Copy]) -> None:
        """Draw these copies, and no others; `settle` places them."""
        while len(self._copies) < len(copies):
            self._copies.append(_CopyActors())
        self._shown = []
        origin = self._state.origin
        for copied, copy in zip(self._copies, copies, strict=False):
            matrix = np.array(copy.world_from_world, dtype=np.float64)
            visible = bool(np.isfinite(matrix).all() and matrix.any())
            if visible:
                matrix[:, 3] += matrix[:, :3] @ origin
                matrix[:3] -= np.outer(origin, matrix[3])
                self._build(copied)
                self._shown.append((copied, matrix))
            self._dress(copied, copy if visible else None)
        for copied in self._copies[len(copies) :]:
            self._dress(copied, None)

    def settle(self) -> None:
        if self._shown:
            pane_from_local = self._state.copies_from_local(COPY_LIFT)
            for copied, local_from_local in self._shown:
                copied.space.set_projective(pane_from_local @ local_from_local)

    @property
    def copied_faces(self) -> list[tuple[vtkActor, actors.Space]]:
        """The faces of all copies so far, each with its `Space`."""
        return [(copy.surface, copy.space) for copy in self._copies if copy.surface is not None]

    def _copied(self, points: Array) -> Array:
        """Return the copies of points (n, 3) of the scene's faces, (m, 4), scene-local."""
        homogeneous = np.column_stack([points, np.ones(len(points))])
        return np.concatenate(
            [np.empty((0, 4)), *(homogeneous @ matrix.T for _, matrix in self._shown)]
        )

    def show_detail(self, fewer: Scene | None) -> None:
        for copy in self._copies:
            if copy.detail is not None:
                copy.detail.show(fewer)

    def _build(self, copied: "_CopyActors") -> None:
        if copied.detail is not None:
            return
        copied.surface = actors.SceneActors(self._state.scene, self._style, self._clip).surface
        copied.detail = actors.Detail(copied.surface)
        if copied.surface is not None:
            copied.space.add(copied.surface)
            if self._lifts_copies:
                actors.lift_lines(copied.surface, COPY_LIFT)
            self._canvas.add(copied.surface, renderer=self._state.renderer)

    def _dress(self, copied: "_CopyActors", copy: Copy | None) -> None:
        if copied.surface is None:
            return
        copied.surface.SetVisibility(copy is not None)
        if copy is not None:
            copied.surface.GetMapper().SetScalarVisibility(not copy.colour)
            if copy.colour:
                copied.surface.GetProperty().SetColor(*rgb(self._named(copy.colour)))

    # -- shared

    def _named(self, colour: str) -> str:
        return colour if colour.startswith("#") else str(getattr(self._style, colour))

    def _rgba(self, colour: str, opacity: float = 1.0, *, quiet: bool = False) -> NDArray[np.uint8]:
        key = colour, round(255.0 * opacity), quiet
        rgba = self._colours.get(key)
        if rgba is None:
            shown = self._named(colour)
            if quiet:
                shown = mixed(shown, self._style.background, QUIET)
            parts = [round(255.0 * part) for part in rgb(shown)]
            rgba = self._colours[key] = np.array([*parts, key[1]], dtype=np.uint8)
        return rgba

    def _batches(
        self, batches: "list[_Batch]", kind: Literal["Lines", "Verts"], sizes: Array
    ) -> "list[tuple[_Batch, float, NDArray[np.intp]]]":
        """A batch for each size, and whose size it is; small dots come on large ones."""
        distinct = sorted(set(sizes[~np.isnan(sizes)].tolist()), reverse=kind == "Verts")
        batches += [self._batch(kind) for _ in range(len(distinct) - len(batches))]
        for batch in batches[len(distinct) :]:
            batch.hide()
        pairs = zip(batches, distinct, strict=False)
        return [(batch, size, np.flatnonzero(sizes == size)) for batch, size in pairs]

    def _batch(self, kind: Literal["Lines", "Polys", "Verts"]) -> "_Batch":
        batch = _Batch(kind)
        if kind == "Polys":
            batch.actor.ForceTranslucentOn()
        else:
            batch.actor.ForceOpaqueOn()
        if kind == "Verts":
            batch.actor.GetProperty().RenderPointsAsSpheresOn()
            actors.put_in_front(batch.actor)
        elif not self._over:
            actors.lift_lines(batch.actor, _LINE_STEPS if kind == "Lines" else _FACE_STEPS)
        self._canvas.add(batch.actor, renderer=self._state.renderer)
        return batch


class _CopyActors:
    """The actors of one copy, created on first use."""

    def __init__(self) -> None:
        self.surface: vtkActor | None = None
        self.space = actors.Space()
        self.detail: actors.Detail | None = None


class _Batch:
    """Cells that change together, each point in a colour of its own, under one actor."""

    def __init__(self, kind: Literal["Lines", "Polys", "Verts"]) -> None:
        self._kind = kind
        self._mesh = PolyMesh()
        self._sizes: list[int] = []
        self._points: NDArray[np.float32] = np.empty((0, 3), np.float32)
        self._rgba: NDArray[np.uint8] = np.empty((0, 4), np.uint8)
        self.actor = actors.unlit_actor(self._mesh)
        actors.colour_by_points(self.actor, "rgba")
        self.actor.SetVisibility(False)

    def hide(self) -> None:
        self.actor.SetVisibility(False)

    def show(
        self, points: Array, rgba: NDArray[np.uint8], sizes: Sequence[int] | None = None
    ) -> None:
        """Draw these cells, and no others.

        `points` are (m, k, 3), or (n, 3) with the `sizes` of the cells; `rgba`, (n, 4), colours
        each.
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
        self._mesh.points, self._mesh.point_data["rgba"] = self._points, self._rgba
        getattr(self._mesh, f"Set{self._kind}")(cells_from(ends, np.arange(count)))


def _away(text: Text) -> Text:
    assert text.away_from is not None
    return replace(text, point=text.away_from)


# --------------------------------------------------------------------------- cutting


def _placed_each(marks: Sequence[Dot | Text], placing: Placing) -> Array:
    if not marks:
        return np.empty((0, 3))
    return placing.placed(np.array([mark.point for mark in marks], dtype=np.float64))


def _within(points: Array, limit: float) -> NDArray[np.bool_]:
    return np.asarray((np.abs(points) <= limit).all(axis=-1))  # NaN is not


def _in_box(points: Array, limit: float) -> Array:
    """Points as clip coordinates of the box, whose planes are those of the NDC cube."""
    return np.concatenate([points / limit, np.ones((*points.shape[:-1], 1))], axis=-1)


def _cut_segments(segments: Array, limit: float) -> tuple[Array, NDArray[np.intp]]:
    """The parts of segments (m, 2, 3) inside the box, and the segment of each."""
    kept = _within(segments, limit).all(axis=1)
    crossing = ~kept & _within(segments, LARGEST_CLIP * min(limit, 1.0)).all(axis=1)
    clip = _in_box(segments[crossing], limit)
    cut = clip_segments(clip[:, 0], clip[:, 1])
    ends = cut.points_clip[cut.visible]
    owners = np.flatnonzero(crossing)[cut.visible]
    left = np.concatenate([segments[kept], ends[..., :3] / ends[..., 3:] * limit])
    return left, np.concatenate([np.flatnonzero(kept), owners])


def _cut_polygon(points: Array, limit: float) -> Array:
    """The part of a polygon (k, 3) inside the box; nothing of one that is not finite."""
    if _within(points, limit).all():
        return points
    if not _within(points, LARGEST_CLIP * min(limit, 1.0)).all():
        return np.empty((0, 3))
    inside = clip_polygon(_in_box(points, limit)).points_clip
    return np.asarray(inside[:, :3] / inside[:, 3:] * limit)
