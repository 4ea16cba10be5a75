"""The image pane: exactly the picture, as large as the pane allows, and its pixel axes.

The scene stands under ``clip_from_world`` alone: this pane's camera is the identity. Where float32
cannot hold that matrix, the vertices are clip coordinates already (`precision`). The picture does
not depend on the depth range, and is drawn with OpenGL's, which the depth buffer takes.
"""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.drawings import AXES
from app.drawings.actors import identity_camera, make_pale
from app.drawings.blurring import Blurring
from app.drawings.drawing import Drawing, Rectangle
from app.drawings.handles import HandleMarks
from app.drawings.label_placement import Ground
from app.drawings.layer import Layer, Layers
from app.drawings.marks import MarksDrawing
from app.drawings.moved_vertices import MovedVertices
from app.drawings.picture_frame import FRAMED, ImageState, PictureFrame, PictureOptions
from app.drawings.precision import ModelActors, least_tolerance
from app.drawings.probes import ImageProbes
from app.drawings.prop_group import PropGroup
from app.drawings.rasterising import Rasteriser
from app.drawings.style import Style, rgb
from app.model.projection import Array, Projection
from app.model.refusal import Refusal
from app.precision.levels import DRAWING_TOLERANCE_PX, Precision
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.marks import Rendering
from app.scenes.phenomena.words import Phrase
from app.scenes.scene import RASTERISED, Scene


class SceneInPicture(Layer):
    """The scene under the model's own matrix, rasterised as the phenomenon or the quality asks.

    The faces of a phenomenon's copies are among its `marks`.
    """

    def __init__(self, state: ImageState, marks: MarksDrawing, tolerance_px: float) -> None:
        scene, self._style = state.scene, state.style
        self._state, self._marks, self._quality = state, marks, state.options.quality
        self._tolerance_px = least_tolerance(scene, tolerance_px)
        self.model = ModelActors(scene, state.style, self._tolerance_px)
        if state.pane in scene.pale:
            make_pale(self.model.actors, state.style)
        state.canvas.add(*self.model.actors, renderer=state.renderer)
        self._moved = MovedVertices(scene, "projected", self.model.surface)
        self._rasteriser: Rasteriser | None = None
        self._rasterised = scene.requires & RASTERISED
        if self._quality.has_depth:
            self._rasterised |= {"depth"}
        self.refused_depth: Refusal | None = None
        """Why the picture does not have the depth buffer that was chosen."""
        self.blurring: Blurring | None = None

    @property
    def _rendering(self) -> Rendering:
        illustration = self._state.illustration
        rendering = None if illustration is None else illustration.rendering
        return rendering or Rendering()

    def show_grid(self, shown: bool) -> None:
        self.model.show_grid(shown)
        if self.blurring is not None:
            self.blurring.model.show_grid(shown)
            self.blurring.restart()

    def show_detail(self, fewer: Scene | None) -> None:
        self.model.show_detail(fewer)
        if self.blurring is not None:
            self.blurring.model.show_detail(fewer)
            self.blurring.restart()

    def show(self) -> None:
        state, seen = self._state, self._state.seen_projection
        self.model.show_picture(seen)
        # Until there are marks, copies of a phenomenon's faces are still to come.
        if state.scene.phenomenon is None or not self._marks.is_empty:
            self._rasterise(seen)
            illustration = state.illustration
            if state.scene.requires:
                self._moved.show(None if illustration is None else illustration.vertices)

    def _rasterise(self, seen: Projection) -> None:
        state = self._state
        if not self._rasterised or not (placed := self.model.actors.placed):
            return
        if self._rasteriser is None:
            first, *others = placed
            self._rasteriser = Rasteriser(
                state.scene,
                self._style,
                self._rasterised,
                lambda actor: state.canvas.add(actor, renderer=state.renderer),
                first,
                [*self._marks.copied_faces, *others],
            )
        rendering = self._rendering
        self.refused_depth = None
        if self._quality.has_depth and rendering.buffer is None:
            try:
                rendering = replace(rendering, buffer=self._quality.depth_buffer(state.projection))
            except Refusal as error:
                self.refused_depth = error
        self._rasteriser.show(rendering, seen)

    @property
    def problem(self) -> Phrase | None:
        return None if self._rasteriser is None else self._rasteriser.problem

    def ink(self, ground: Ground) -> None:
        state, half, eyes = self._state, self._state.half, self._state.eyes
        shown = [(state.projection, 0.0)]
        if eyes is not None:
            shown = list(zip((eyes.left, eyes.right), eyes.shares, strict=True))
        for projection, share in shown:
            clip = projection.clip_from_local(state.scene.origin, "object")
            x = clip[0] + (1.0 + 2.0 * share) * clip[3]
            rows = np.stack([half[0] * x, half[1] * (clip[1] + clip[3]), clip[3]])
            state.silhouette.ink_under(ground, rows)

    # -- a lens with an opening, and two eyes

    def begin_blurring(self) -> None:
        """Begin another picture of an opening or of two eyes, if this is one, for `refine`."""
        state, rendering, blurring = self._state, self._rendering, self.blurring
        through = rendering.aperture or rendering.eyes
        finer = state.options.finer
        if blurring is None:
            if through is None:
                return
            state.canvas.can_rest = False  # its pictures have a window of their own
            style = self._style.enlarged(1.0 / finer)
            self.blurring = blurring = Blurring(state.scene, style, self._tolerance_px)
            if "grid" in state.canvas.hidden:
                blurring.model.show_grid(False)
            state.canvas.add(blurring.actor, renderer=state.renderer)
        width, height = state.size_px
        size = max(1, width // finer), max(1, height // finer)
        blurring.begin(state.projection, through, size)
        self._choose_picture(blurring)

    def refine(self, *, whole: bool) -> None:
        if self.blurring is not None:
            transparent = self._state.renderer.GetBackgroundAlpha() == 0.0
            self.blurring.refine(transparent=transparent, whole=whole)
            self._choose_picture(self.blurring)

    def _choose_picture(self, blurring: Blurring) -> None:
        for actor in self.model.actors:
            actor.SetVisibility(not blurring.actor.GetVisibility())


class ImageDrawing(Drawing):
    """The picture that the model's camera takes.

    `tolerance_px` is the error up to which the GPU's own float32 may draw.
    """

    pane = "image"
    refines = True
    state: ImageState

    def __init__(
        self,
        screen: Any,
        scene: Scene,
        words: Mapping[str, str],
        style: Style,
        tolerance_px: float = DRAWING_TOLERANCE_PX,
        options: PictureOptions = FRAMED,
        *,
        live: bool = False,
    ) -> None:
        canvas, self._picture = PropGroup(screen, style, self._layout), vtkRenderer()
        self.state = state = ImageState(canvas, scene, words, self._picture)
        state.options = options
        self.names, self.board = state.names, state.board
        self._hidden: frozenset[str] = frozenset()
        self._add_picture(style)
        self._marks = marks = MarksDrawing(state, over=True)
        self._scene = SceneInPicture(state, marks, tolerance_px)
        layers: list[Layer] = [ImageProbes(state), marks, self._scene]
        self._own_camera = canvas.renderer.GetActiveCamera()
        canvas.renderer.SetActiveCamera(identity_camera())
        self._frame: PictureFrame | None = None
        if options.framed:
            canvas.renderer.SetBackground(*rgb(style.margin))
            self._frame = PictureFrame(state)
            self.show_layers(frozenset())
            layers.append(self._frame)
        if live:
            self.handles = HandleMarks(state)
            layers.append(self.handles)
        self.layers = Layers(state, *layers)

    def _add_picture(self, style: Style) -> None:
        picture = self._picture
        self.state.canvas.make_ready(picture)
        picture.SetActiveCamera(identity_camera())
        picture.SetBackground(*rgb(style.background))
        picture.SetLayer(1)
        picture.PreserveColorBufferOff()  # a layer above the first is transparent otherwise
        picture.InteractiveOff()
        self.state.canvas.window.SetNumberOfLayers(2)
        self.state.canvas.window.AddRenderer(picture)

    def remove(self) -> None:
        if self._scene.blurring is not None:
            self._scene.blurring.close()
        canvas = self.state.canvas
        canvas.remove()
        canvas.window.RemoveRenderer(self._picture)
        canvas.renderer.SetActiveCamera(self._own_camera)

    def show_names(self, names: frozenset[str] | None) -> None:
        if names != self.names.wanted:
            self.names.wanted = names
            self.show_layers(self._hidden)
            self._show_named()

    def _show_named(self) -> None:
        self.layers.show_names()
        self.layers.place_labels()

    @property
    def precision(self) -> Precision:
        return self._scene.model.precision

    def show_projection(
        self, projection: Projection, illustration: Illustration | None = None
    ) -> None:
        state, before = self.state, self.state.projection
        state.projection, state.illustration = projection, illustration
        if projection.image_size != before.image_size:
            state.canvas.relayout()
        self.layers.show()
        self._scene.begin_blurring()
        if illustration is not None and state.eyes is not None:  # the marks of P move at once, too
            self.refine()
        if state.probes or not self._marks.is_empty:
            self.layers.settle()
            self.layers.place_labels()

    def show_layers(self, hidden: frozenset[str]) -> None:
        canvas, self._hidden = self.state.canvas, hidden
        if "pixels" not in self.names:
            hidden |= {AXES}
        if ("grid" in hidden) != ("grid" in canvas.hidden):
            self._scene.show_grid("grid" not in hidden)
        if self._frame is not None and (AXES in hidden) != (AXES in canvas.hidden):
            self._frame.show_axes(AXES not in hidden)
            canvas.relayout()
        canvas.show_layers(hidden)

    @property
    def refused_depth(self) -> Refusal | None:
        return self._scene.refused_depth

    @property
    def problem(self) -> Phrase | None:
        return self._scene.problem

    @property
    def is_coarse(self) -> bool:
        return self._scene.blurring is not None and self._scene.blurring.is_coarse

    def refine(self, *, whole: bool = False) -> None:
        self._scene.refine(whole=whole)

    # -- where the picture is

    def rectangle_in(self, pane_width_px: int, pane_height_px: int) -> Rectangle:
        return self.state.rectangle_in(pane_width_px, pane_height_px)

    def spots_of(self, places: Array) -> Array:
        return np.asarray(places * np.diag(self.state.scale) + self.state.rectangle[:2])

    def image_pixel(self, x_px: float, y_px: float) -> tuple[float, float] | None:
        left, top, width, height = self.state.rectangle
        x, y = x_px - left, y_px - top
        if not (0.0 <= x <= width and 0.0 <= y <= height) or self.state.eyes is not None:
            return None
        scale = self.state.scale
        return float(x / scale[0, 0]), float(y / scale[1, 1])

    def image_shift(self, right_px: float, down_px: float) -> tuple[float, float]:
        (wide_px, high_px), (width, height) = self.state.size_px, self.state.projection.image_size
        return right_px * width / wide_px, down_px * height / high_px

    def _layout(self, pane_width_px: int, pane_height_px: int) -> None:
        left, top, width, height = self.rectangle_in(pane_width_px, pane_height_px)
        self._picture.SetViewport(
            left / pane_width_px,
            (pane_height_px - top - height) / pane_height_px,
            (left + width) / pane_width_px,
            (pane_height_px - top) / pane_height_px,
        )
        self._scene.begin_blurring()
        self.layers.settle()
        self.layers.place_labels(afresh=True)
        if self._frame is not None:
            self._frame.lay_out(pane_width_px, pane_height_px)
