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

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from app.drawings.actors import fitting, lift_lines, make_pale
from app.drawings.drawing import Drawing, light_of_labels
from app.drawings.frame import BODY_BOX
from app.drawings.handles import HandleMarks
from app.drawings.label_placement import Ground
from app.drawings.layer import FacesLayer, Layer, Layers
from app.drawings.marks import MarksDrawing
from app.drawings.pane_view import Pose
from app.drawings.precision import ModelActors, least_tolerance
from app.drawings.probes import StageProbes
from app.drawings.prop_group import PropGroup
from app.drawings.stage_box import BODY, StageBox, StageState, volume_ends
from app.drawings.stage_view import AXES_LENGTH, StageView
from app.drawings.style import Style
from app.lecture.highlight import AXES, ENDS
from app.lecture.stages import CANONICAL_PERSPECTIVE, NDC, RADIUS, VIEW
from app.model.parameters import FAR
from app.model.projection import Array, Projection
from app.precision.levels import DRAWING_TOLERANCE_PX, Precision
from app.scenes.phenomena.illustration import Illustration
from app.scenes.scene import Scene


class SceneAtStage(FacesLayer):
    """The scene under the stage's matrix, cut by the planes of the view volume."""

    _state: StageState

    def __init__(self, state: StageState, tolerance_px: float) -> None:
        scene, style = state.scene, state.style
        self.model = ModelActors(scene, style, least_tolerance(scene, tolerance_px), state.planes)
        drawn = self.model.actors
        if state.pane in scene.pale:
            make_pale(drawn, style)
        for drawing in (drawn.dots, drawn.lines, drawn.ground):
            if drawing is not None:
                lift_lines(drawing)
        state.canvas.add(*drawn)
        super().__init__(state, drawn, "projected")

    def show_detail(self, fewer: Scene | None) -> None:
        self.model.show_detail(fewer)

    def show(self) -> None:
        state = self._state
        if state.position == NDC:  # only the volume's content is shown, as precisely as it needs
            to_display = state.display_from_ndc
            matrices = [to_display @ m for m in self.model.show_projection(state.seen_projection)]
        else:
            display_from_local = state.morph.display_from_local(state.position)
            of_object = display_from_local @ self.model.show_placed(state.projection.placement)
            matrices = [of_object, of_object, of_object, display_from_local]
        self.actors.place(matrices)
        if self._changes:
            super().show()

    def ink(self, ground: Ground) -> None:
        state = self._state
        shown = state.own.pane_from_display @ state.display_from_object
        rows = np.stack([shown[0], state.size_px[1] * shown[3] - shown[1], shown[3]])
        state.silhouette.ink_under(ground, rows, state.volume_seen())


class StageDrawing(Drawing):
    """The scene and the view volume at a stage.

    `words` holds those written here: ``near``, ``far``, ``x``, ``y``, ``z``, ``u``, ``v``, ``n``.
    `tolerance_px` is the error up to which the GPU's own float32 may draw.
    """

    pane = "ndc"
    state: StageState
    own: StageView

    def __init__(
        self,
        screen: Any,
        scene: Scene,
        words: Mapping[str, str],
        style: Style,
        tolerance_px: float = DRAWING_TOLERANCE_PX,
        *,
        live: bool = False,
    ) -> None:
        self.state = state = StageState(PropGroup(screen, style, self._layout), scene, words)
        self.names, self.board, self.own = state.names, state.board, state.own
        self._scene = SceneAtStage(state, tolerance_px)
        self.box = StageBox(state)
        self._marks = MarksDrawing(state, clip=state.planes, lifts_copies=True)
        # The scene stands in the box.
        layers: list[Layer] = [StageProbes(state), self.box, self._scene, self._marks]
        if live:
            self.handles = HandleMarks(state)
            layers.append(self.handles)
        self.layers = Layers(state, *layers)
        with self.layers.placing_once():
            self._show()
            self.reset_view()

    @property
    def precision(self) -> Precision:
        return self._scene.model.precision

    # -- the model, and where it is on the strip

    def show_projection(
        self, projection: Projection, illustration: Illustration | None = None
    ) -> None:
        state, before = self.state, self.state.projection
        reshaped = projection.image_size != before.image_size
        reshaped |= projection.lens.central != before.lens.central
        state.take(projection, illustration)
        if state.is_gliding:
            return
        self._show()
        # Before the cube the display is scaled to the volume, which may be another one now.
        if (reshaped or state.position < CANONICAL_PERSPECTIVE) and not self.own.was_moved:
            self.reset_view()

    def show_layers(self, hidden: frozenset[str]) -> None:
        changed = hidden ^ self.state.canvas.hidden
        if "grid" in changed:
            self._scene.model.show_grid("grid" not in hidden)
        self.state.canvas.show_layers(hidden)
        if "frustum" in changed and self.state.position <= VIEW:
            self._show_named()
            self._layout(*self.state.size_px)

    def show_stage(self, position: float) -> None:
        state = self.state
        if position == state.position:
            return
        was_moved, state.position = self.own.was_moved, position
        if state.is_gliding:
            return
        self._show()
        if not was_moved:
            self.reset_view()

    def _show(self) -> None:
        """Set the matrices, planes and words of the position on the strip."""
        before, emphasis = self.box.placed, self.state.emphasis
        self.layers.show()
        if self.box.placed != before:
            emphasis.show_names(self.names)
            emphasis.show(self.names.pointed)
        if self.box.placed != before or self.state.probes or not self._marks.is_empty:
            self.layers.settle()
            self.layers.place_labels()

    def spots_of(self, places: Array) -> Array:
        shown = self.own.pane_from_display @ self.state.display_from_ndc
        x, y, _, w = shown[:, :3] @ places.T + shown[:, 3:]
        return np.stack([x, y], axis=1) / np.where(w > 0.0, w, np.nan)[:, None]

    # -- the pane's own camera

    def reset_view(self) -> None:
        self._look()
        self.reset_clipping_range()

    def _look(self) -> None:
        """Place the camera."""
        around, state = self.around, self.state
        if around is None:
            self.own.reset(state.position, state.projection, self._framed)
        else:
            origin = state.morph.origin_at
            self.own.reset(state.position, state.projection, lambda k: around + origin(k), origin)

    @property
    def around(self) -> Array | None:
        """What has its room all the way to the view, (n, 3): from the world's origin.

        None unless x, y and z are named: then the origin stands still in the pane.
        """
        if self.state.position > VIEW or not all(map(self.names.wants, "xyz")):
            return None
        framed, origin = self._framed, self.state.morph.origin_at
        return np.concatenate([framed(k / 2) - origin(k / 2) for k in range(3)])

    def _framed(self, stop: float) -> Array:
        """What has to be in view at a position up to the view's stop, (n, 3): display space.

        These are the objects, the probes, the camera, the named axes and the near plane. Far
        belongs to them if it is named; else it may leave the pane, as the grid does.
        """
        state, origin, morph = self.state, self.state.origin, self.state.morph
        objects = state.projection.placement.placed(state.scene.objects_box).world - origin
        probes = [probe.point for probe in state.probes if probe.point is not None]
        local = np.vstack([objects, np.array([state.projection.camera.eye, *probes]) - origin])
        shown = np.column_stack([local, np.ones(len(local))]) @ morph.display_from_local(stop).T
        points = shown[:, :3] / np.where(shown[:, 3:] > 0.0, shown[:, 3:], np.nan)
        if state.has_volume(stop):
            ends = ENDS if self.names.wants(FAR.name) else ENDS[:1]
            volume = volume_ends(fitting(morph.display_from_box(stop)), ends)
            points = np.concatenate([points, volume])
        points = points[np.isfinite(points).all(axis=1)]
        # What is outside the ball that the display is scaled to is not worth its room.
        points /= np.maximum(1.0, np.linalg.norm(points, axis=1, keepdims=True) / RADIUS)
        start, axes = morph.axes_at(stop)
        if morph.projection.has_camera:
            body = start / max(1.0, math.hypot(*start) / RADIUS) + BODY * BODY_BOX @ axes
            points = np.concatenate([points, body])
        named = [axis for name, axis in zip(AXES, axes, strict=True) if self.names.wants(name)]
        points = np.concatenate([points, *(start + AXES_LENGTH * axis[None] for axis in named)])
        if stop < VIEW and all(map(self.names.wants, "xyz")):
            points = np.concatenate([points, morph.origin_at(stop) + AXES_LENGTH * np.eye(3)])
        return points

    def reset_clipping_range(self, *, afresh: bool = True) -> None:
        self.own.fit_range()
        self.layers.settle()
        self.layers.place_labels(afresh=afresh)

    def begin_glide(self, start: Pose) -> None:
        super().begin_glide(start)
        self.state.is_gliding = True

    def glide(self, part: float) -> None:
        state = self.state
        self._show()
        state.is_gliding = False
        if self.own.is_turned:
            self.own.go_to_goal()
        else:
            self._look()
        if part < 1.0:
            self.own.glide(part)
        else:
            self.own.is_turned = False
        state.canvas.fade_labels(light_of_labels(part))
        self.reset_clipping_range()
        state.is_gliding = part < 1.0

    def _layout(self, _width_px: int, _height_px: int) -> None:
        if not (self.own.was_moved or self.own.is_turned):  # keep all of it in view
            self.reset_view()
        else:
            self.reset_clipping_range()

    # -- names

    def show_names(self, names: frozenset[str] | None) -> None:
        if names != self.names.wanted:
            was_moved, self.names.wanted = self.own.was_moved, names
            self._show_named()
            if self.state.position < CANONICAL_PERSPECTIVE and not was_moved:
                self.reset_view()

    def _show_named(self) -> None:
        self.box.placed = None
        self._show()
