"""The pane that shows a stage of the pipeline: NDC, or another position of the stage strip.

==================  =========================================================================
what                under which 4x4
==================  =========================================================================
the scene           the stage's matrix, clipped by the planes of the view volume
the view volume     the stage's matrix of a box: at NDC the cube, or half of it
==================  =========================================================================

The matrices are those of `app.lecture.stages`. The NDC pane, as it opens and in a figure, is the
strip at its NDC stop. NDC is left-handed (z grows away from the reader) and is shown with z
mirrored: the near face looks at the reader, x runs right, and the cube's front is the picture. The
reversed range needs no mirror. The cube is centred where the pane's camera looks.

A step of a slider or of the strip sets matrices and nothing else. The surroundings of the scene
depend at NDC on the depth range alone, and wait for it to change.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPlane

from app.document.naming import named_in
from app.drawings.actors import PropGroup, fitting, lift_lines, make_pale
from app.drawings.drawing import Drawing, Rectangle, light_of_labels
from app.drawings.frustum import CUBE
from app.drawings.label_placement import Ground
from app.drawings.labels import Board, room
from app.drawings.marks import MarksDrawing, Placing
from app.drawings.moved_vertices import MovedVertices
from app.drawings.names import Names
from app.drawings.pane_view import Pose
from app.drawings.pointing import Emphasis, Segment, Spot, pointed_at, volume_edges
from app.drawings.precision import ModelActors, least_tolerance
from app.drawings.probes import ProbeMark, Probes
from app.drawings.rasterising import textured
from app.drawings.silhouette import Silhouette
from app.drawings.stage_box import StageBox, volume_ends
from app.drawings.stage_view import AXES_LENGTH, StageView
from app.drawings.style import TITLE_EM, Style
from app.lecture.highlight import AXES, CORNERS, NOTHING, Highlight
from app.lecture.stages import CANONICAL_PERSPECTIVE, NDC, RADIUS, VIEW, WORLD, Morph, morph_of
from app.model.projection import Array, Camera, Projection
from app.picking.picking import Probe
from app.picking.sight import Sight
from app.precision.levels import DRAWING_TOLERANCE_PX, Precision
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.marks import Marks
from app.scenes.scene import Scene

_FARTHEST_MARK = 1e3  # where lines toward infinity end
_BOX_FROM_NDC = np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, -0.5, 0.5], [0, 0, 0, 1]])


class StageDrawing(Drawing):
    """The scene and the view volume at a stage.

    `words` holds those written here: ``near``, ``far``, ``x``, ``y``, ``z``, ``u``, ``v``, ``n``.
    `tolerance_px` is the error up to which the GPU's own float32 may draw.
    """

    pane = "ndc"

    def __init__(
        self,
        screen: Any,
        scene: Scene,
        words: Mapping[str, str],
        style: Style,
        tolerance_px: float = DRAWING_TOLERANCE_PX,
    ) -> None:
        self._scene, self._words, self._style = scene, words, style
        self._canvas = PropGroup(screen, style, self._layout)
        self.own = StageView(self._canvas, scene.start.camera, scene.cube_side)
        self._position = float(NDC)
        self._placed: tuple[float, object] | None = None
        """The position of the box on the strip, and the projection or depth range it depends on."""
        # Left, right, bottom, top, far, near of the view volume, normals inwards.
        self._planes = [vtkPlane() for _ in range(6)]
        self._model = ModelActors(scene, style, least_tolerance(scene, tolerance_px), self._planes)
        if self.pane in scene.pale:
            make_pale(self._model.actors, style)
        drawn = self._model.actors
        for drawing in (drawn.dots, drawn.lines, drawn.ground):
            if drawing is not None:
                lift_lines(drawing)
        self._canvas.add(*drawn)
        self.names = Names(named_in(self.pane, scene))
        self.board = Board(self._canvas)
        self._silhouette = Silhouette(scene, style.font_size)
        self.box = StageBox(self._canvas, words, self.names, self.board)
        self._emphasis = Emphasis(self._canvas)
        self.box.make_emphasis(self._emphasis)
        self._probes = Probes(self._canvas, self.board)
        self._marks: MarksDrawing | None = None
        self._rasterisers = textured(scene, self._canvas, (drawn.surface, drawn.spaces[0]))
        self._moved = MovedVertices(scene, "projected", drawn.surface)
        self._illustration: Illustration | None = None
        self._is_gliding = False
        """Whether `glide` will show and place everything, once for each frame."""
        self._take(scene.start)
        self.reset_view()

    @property
    def precision(self) -> Precision:
        return self._model.precision

    # -- the model, and where it is on the strip

    def show_projection(
        self, projection: Projection, illustration: Illustration | None = None
    ) -> None:
        before = self._projection
        reshaped = projection.image_size != before.image_size
        reshaped |= projection.lens.has_pyramid != before.lens.has_pyramid
        self._illustration = illustration
        self._take(projection)
        self._rasterise()
        if self._is_gliding:
            return
        self._show_marks()
        # Before the cube the display is scaled to the volume, which may be another one now.
        if (reshaped or self._position < CANONICAL_PERSPECTIVE) and not self.own.was_moved:
            self.reset_view()

    def _take(self, projection: Projection) -> None:
        self._projection = projection
        self._made: Morph | None = None
        if not self._is_gliding:
            self._show_moment()

    @property
    def _morph(self) -> Morph:
        """Created on demand: most steps at the NDC stop do not need it."""
        if self._made is None:
            scene = self._scene
            corners = scene.reach(self._projection.placement)
            self._made = morph_of(self._projection, scene.origin, corners)
        return self._made

    def show_layers(self, hidden: frozenset[str]) -> None:
        if ("grid" in hidden) != ("grid" in self._canvas.hidden):
            self._model.show_grid("grid" not in hidden)
        self._canvas.show_layers(hidden)

    def show_detail(self, fewer: Scene | None) -> None:
        self._model.show_detail(fewer)
        if self._marks is not None:
            self._marks.show_detail(fewer)

    def show_stage(self, position: float) -> None:
        if position == self._position:
            return
        was_moved = self.own.was_moved
        self._position = position
        if self._is_gliding:
            return
        self._show_moment()
        self._show_marks()
        if not was_moved:
            self.reset_view()

    def _show_moment(self) -> None:
        """Set the matrices, planes and words of the position on the strip."""
        position, projection = self._position, self._projection
        at_ndc = position == NDC
        placed = position, projection.depth if at_ndc else projection
        if placed != self._placed:
            self._placed, morph = placed, self._morph
            self.box.show(morph, position)
            planes = morph.planes_display(position).tolist()
            for plane, (*normal, offset) in zip(self._planes, planes, strict=True):
                plane.SetNormal(*normal)
                plane.SetOrigin(*(-offset * part for part in normal))
            self._emphasis.show_names(self.names)
            self._show_highlighted()
            self._place_texts()
        if at_ndc:  # only the volume's content is shown, in the precision that it needs
            to_display = self._display_from_ndc
            matrices = [to_display @ m for m in self._model.show_projection(self._seen)]
        else:
            display_from_local = self._morph.display_from_local(position)
            of_object = display_from_local @ self._model.show_placed(projection.placement)
            matrices = [of_object, of_object, of_object, display_from_local]
        for space, matrix in zip(self._model.actors.spaces, matrices, strict=True):
            space.set_projective(matrix)
        if self._probes.probes:
            self._place_probes()
            self._place_texts()

    @property
    def _seen(self) -> Projection:
        """The projection with OpenGL's depth range; the displayed cube differs in depth only."""
        return self._projection.with_depth("opengl")

    @property
    def _display_from_ndc(self) -> Array:
        """From OpenGL's cube; 0 without a volume, so that nothing can be pointed at."""
        display: Array = self.box.display_from_box @ _BOX_FROM_NDC
        return display

    @property
    def _display_from_object(self) -> Array:
        origin, seen = self._scene.origin, self._seen
        if self._position == NDC:
            return self._display_from_ndc @ seen.clip_from_local(origin, "object")
        placed = seen.placement.local_from(origin, origin)
        return self._morph.display_from_local(self._position) @ placed

    # -- a phenomenon, probes

    def _rasterise(self) -> None:
        illustration = self._illustration
        if illustration is not None and illustration.rendering is not None:
            for rasteriser in self._rasterisers:
                rasteriser.show(illustration.rendering, self._seen)
        self._moved.show(None if illustration is None else illustration.vertices)

    def _show_marks(self) -> None:
        if self._marks is None:
            if self._illustration is None:
                return
            self._marks = MarksDrawing(
                self._canvas, self._scene, self._words, clip=self._planes, lifts_copies=True,
                names=self.names, board=self.board,
            )  # fmt: skip
        marks, illustration = self._marks, self._illustration
        if illustration is None or self._position != NDC:
            marks.show(Marks(), Placing(np.ones(3), np.zeros(3), 1.0))
            marks.show_copies(())
            return
        shown = self._morph.display_from_stage(NDC)
        marks.show(illustration.ndc, Placing(np.diag(shown)[:3], shown[:3, 3], _FARTHEST_MARK))
        copies = [copy for copy in illustration.copies if "ndc" in copy.panes]
        marks.show_copies(copies)
        if copies:
            clip_from_local = self._seen.clip_from_world_at(self._scene.origin)
            display_from_local = self._display_from_ndc @ clip_from_local
            marks.place_copies(lambda _: display_from_local)
        self._place_texts()

    def _place_texts(self, *, afresh: bool = False) -> bool:
        """Place the labels; return whether one has changed its place."""
        if self._is_gliding or not self._canvas.labels_light:
            return False
        width_px, height_px = self.own.size_px
        rows, em = self.own.pane_from_display, self._style.font_size

        def seen(points: Array) -> list[Spot]:
            x, y = rows[:2, :3] @ points.T + rows[:2, 3:]
            return [(a, height_px - b, 1.0) for a, b in zip(x.tolist(), y.tolist(), strict=True)]

        def ink(ground: Ground) -> None:
            self.box.ink(ground, seen)
            faces = self._silhouette.triangles
            shown = rows @ self._display_from_object
            with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
                x, y, _, w = np.moveaxis(faces @ shown[:, :3].T + shown[:, 3], -1, 0)
                spots = (
                    np.stack([x, height_px * w - y], axis=-1)
                    / np.where(w > 0.0, w, np.nan)[..., None]
                )
            self._silhouette.ink(ground, spots)
            if self._marks is not None:
                self._marks.ink(ground, seen)

        ground = Ground(room(width_px, height_px - TITLE_EM * em, em), em, ink)
        self._probes.want(ground)
        self.box.want_words(ground, seen)
        if self._marks is not None:
            self._marks.want_texts(ground, seen)
        return self.board.settle(ground, afresh=afresh)

    def refit(self) -> bool:
        return self._place_texts(afresh=True)

    def show_probes(self, probes: Sequence[Probe]) -> None:
        self._probes.probes = probes
        self._place_probes()
        self._place_texts()

    def _place_probes(self) -> None:
        marks: Sequence[ProbeMark] = ()
        if self._display_from_ndc.any():
            marks = self._probes.in_ndc(self._seen, self._display_from_ndc, self.sight)
        self._probes.show(marks, self._canvas.window.GetSize())

    @property
    def picture_rectangle_px(self) -> Rectangle:
        return Rectangle(0, 0, *self.own.size_px)

    def spots_of(self, places: Array) -> Array:
        shown = self.own.pane_from_display @ self._display_from_ndc
        x, y, _, w = shown[:, :3] @ places.T + shown[:, 3:]
        return np.stack([x, y], axis=1) / np.where(w > 0.0, w, np.nan)[:, None]

    @property
    def sight(self) -> Sight:
        projection = self._seen
        clip = projection.clip_from_eye
        limits = np.concatenate([clip[3] - clip[:3], clip[3] + clip[:3]])
        rows = self.own.pane_from_display @ self._display_from_ndc @ clip
        return Sight(np.array(projection.camera.eye), rows, limits)

    # -- the pane's own camera

    def reset_view(self) -> None:
        self.own.reset(self._position, self._projection, self._framed)
        self.reset_clipping_range()

    def _framed(self, stop: int) -> Array:
        """What has to be in view at the stop of the world or of the view, (n, 3): display space.

        These are the objects, the eye, the named axes and the near plane. Far belongs to them if it
        is named; else it may leave the pane, as the grid does.
        """
        morph, origin = self._morph, np.array(self._scene.origin)
        objects = self._projection.placement.placed(self._scene.objects_box).world - origin
        local = np.vstack([objects, np.array(self._projection.camera.eye) - origin])
        shown = np.column_stack([local, np.ones(len(local))]) @ morph.display_from_local(stop).T
        points = shown[:, :3] / np.where(shown[:, 3:] > 0.0, shown[:, 3:], np.nan)
        if morph.has_volume(stop):
            ends = ("near", "far") if self.names.wants("far") else ("near",)
            volume = volume_ends(fitting(morph.display_from_box(stop)), ends)
            points = np.concatenate([points, volume])
        points = points[np.isfinite(points).all(axis=1)]
        # What is outside the ball that the display is scaled to is not worth its room.
        points /= np.maximum(1.0, np.linalg.norm(points, axis=1, keepdims=True) / RADIUS)
        if all(map(self.names.wants, "uvn" if stop == VIEW else "xyz")):
            start, axes = morph.axes_at(stop)
            points = np.concatenate([points, start + AXES_LENGTH * axes])
        return points

    def reset_clipping_range(self) -> None:
        self.own.fit_range()
        self._place_probes()
        self._place_texts(afresh=True)

    @property
    def view(self) -> Camera | None:
        return self.own.view

    @property
    def pose(self) -> Pose:
        return self.own.pose

    def begin_glide(self, start: Pose) -> None:
        self.own.begin_glide(start)
        self._is_gliding = True

    def glide(self, part: float) -> None:
        self._show_moment()
        self._show_marks()
        self._is_gliding = False
        if self.own.is_turned:
            self.own.go_to_goal()
        else:
            self.own.reset(self._position, self._projection, self._framed)
        if part < 1.0:
            self.own.glide(part)
        else:
            self.own.is_turned = False
        self._canvas.fade_labels(light_of_labels(part))
        self.reset_clipping_range()
        self._is_gliding = part < 1.0

    def show_view(self, view: Camera) -> None:
        self.own.show(view)
        self.reset_clipping_range()

    def _layout(self, _width_px: int, _height_px: int) -> None:
        if not (self.own.was_moved or self.own.is_turned):  # keep all of it in view
            self.reset_view()
        else:
            self.reset_clipping_range()

    def remove(self) -> None:
        self._canvas.remove()

    # -- pointing

    def show_highlight(self, highlighted: Highlight) -> bool:
        before, self.names.pointed = self.names.pointed, highlighted
        of_scene = self._marks is not None and self._marks.show_highlight(highlighted)
        is_new = self._show_highlighted() or of_scene
        if before != highlighted and not self.names.all:
            self._name_anew()
        return is_new

    def show_names(self, names: frozenset[str] | None) -> None:
        if names != self.names.wanted:
            was_moved, self.names.wanted = self.own.was_moved, names
            self._name_anew()
            if self._position < CANONICAL_PERSPECTIVE and not was_moved:
                self.reset_view()

    def _name_anew(self) -> None:
        self._placed = None
        self._show_moment()
        if self._marks is not None:
            self._marks.show_names()
            self._place_texts()

    def _show_highlighted(self) -> bool:
        return self._emphasis.show(self.names.pointed - self._strangers)

    @property
    def _strangers(self) -> frozenset[str]:
        """At the world's stop the axes are x, y and z of the world, not the camera's."""
        return frozenset(AXES) if self.box.stop == WORLD else NOTHING

    def highlight_at(self, x_px: float, y_px: float) -> Highlight:
        names = self._emphasis.label_at(x_px, y_px)
        if not names:
            pane = self.own.pane_from_display
            corners = _spots(CUBE, pane @ self.box.display_from_box)
            points = [(frozenset((name,)), at) for name, at in zip(CORNERS, corners, strict=True)]
            # Of two equally near lines the first counts: an axis is drawn over the edge it is on.
            segments: list[Segment] = []
            for name, ends in zip(AXES, self.box.axes[:, 1:], strict=True):
                start, tip = _spots(ends, pane)
                segments.append((frozenset((name,)), start, tip))
            segments += volume_edges(corners)
            names = pointed_at((x_px, y_px), self._style.font_size, points, segments, corners)
        return names - self._strangers


def _spots(points: Array, pane: Array) -> list[Spot]:
    """Pixels and depth of points (n, 3) in the pane; NaN for points at infinity or beyond."""
    homogeneous = points @ pane[:, :3].T + pane[:, 3]
    w = homogeneous[:, 3:]
    spots = homogeneous[:, :3] / np.where(w > 0.0, w, np.nan)
    return list(map(tuple, spots.tolist()))
