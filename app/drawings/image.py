"""The image pane: exactly the picture, as large as the pane allows, and its pixel axes.

The scene stands under ``clip_from_world`` alone: this pane's camera is the identity. Where float32
cannot hold that matrix, the vertices are clip coordinates already (`precision`). The picture does
not depend on the depth range, and is drawn with OpenGL's, which the depth buffer takes.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.document.naming import named_in
from app.drawings import AXES
from app.drawings.actors import PropGroup, Space, face_actor, identity_camera, lifted, line_actor
from app.drawings.blurring import Blurring
from app.drawings.drawing import Drawing, Rectangle, light_of_labels
from app.drawings.label_placement import Ground
from app.drawings.labels import Board, room
from app.drawings.marks import MarksDrawing, Placing
from app.drawings.moved_vertices import MovedVertices
from app.drawings.names import Names
from app.drawings.pointing import Emphasis, Segment, Spot, pointed_at
from app.drawings.precision import ModelActors, least_tolerance
from app.drawings.probes import Probes
from app.drawings.rasterising import Rasteriser
from app.drawings.side_by_side import BARE_EM
from app.drawings.silhouette import Silhouette
from app.drawings.style import TITLE_EM, Style, rgb
from app.lecture.highlight import SIDES, Highlight, corner_at
from app.model.projection import Array, Projection
from app.model.refusal import Refusal
from app.picking.picking import Probe
from app.picking.sight import Sight
from app.precision.levels import DRAWING_TOLERANCE_PX, Precision
from app.precision.quality import AUTOMATIC, Quality
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.marks import Rendering
from app.scenes.phenomena.readout import Phrase
from app.scenes.scene import RASTERISED, Scene

_SQUARE = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0))
_MARKS_DEPTH = -0.9999  # just behind near
_FARTHEST_MARK = 1e3  # of half a picture: where lines toward infinity end
_EM_OF_DIGIT = 0.64  # width of a digit of the labels' font


class ImageDrawing(Drawing):
    """The picture that the model's camera takes.

    `tolerance_px` is the error up to which the GPU's own float32 may draw. The depth buffer is that
    of `quality`, unless the scene is about a buffer itself. Without `framed`, the picture has no
    frame, no axes and no margins. A framed picture can have a `caption` above it, at `middle` of
    its width. It has its axes if they are named. `finer` is how many pixels of the window, along
    each side, become one in the end.
    """

    pane = "image"

    def __init__(
        self,
        screen: Any,
        scene: Scene,
        words: Mapping[str, str],
        style: Style,
        tolerance_px: float = DRAWING_TOLERANCE_PX,
        quality: Quality = AUTOMATIC,
        *,
        framed: bool = True,
        caption: str = "",
        middle: float = 0.5,
        finer: int = 1,
    ) -> None:
        self._scene = scene
        self._tolerance_px = least_tolerance(scene, tolerance_px)
        self._model = ModelActors(scene, style, self._tolerance_px)
        self._moved = MovedVertices(scene, "projected", self._model.surface)
        self._blurring: Blurring | None = None
        self._finer = finer
        self._style, self._words = style, words
        self._framed = framed
        self._canvas = PropGroup(screen, style, self._layout)
        self._image_size = scene.start.image_size
        self._picture = vtkRenderer()
        self._projection = scene.start
        self._hidden: frozenset[str] = frozenset()
        self.names = Names(named_in(self.pane, scene))
        self._add_picture()
        self.board = Board(self._canvas, self._picture)
        self._probes = Probes(self._canvas, self.board, self._picture)
        self._marks: MarksDrawing | None = None
        self._silhouette = Silhouette(scene, style.font_size)
        self._rasteriser: Rasteriser | None = None
        self._rendering = Rendering()
        self._quality = quality
        self._rasterised = scene.requires & RASTERISED
        if quality.has_depth:
            self._rasterised |= {"depth"}
        self._refused_depth: Refusal | None = None
        self._own_camera = self._canvas.renderer.GetActiveCamera()
        self._canvas.renderer.SetActiveCamera(identity_camera())
        self._emphasis = Emphasis(self._canvas)
        if framed:
            self._canvas.renderer.SetBackground(*rgb(style.margin))
            self._add_axes(words)
            self.show_layers(frozenset())
            self._add_sides()
            self._caption: Any = None
            self._middle = middle
            if caption:
                self._caption = self._canvas.label(caption, anchor=(0, -1))

    def show_highlight(self, highlighted: Highlight) -> bool:
        before, self.names.pointed = self.names.pointed, highlighted
        of_scene = self._marks is not None and self._marks.show_highlight(highlighted)
        if before != highlighted and self._marks is not None and not self.names.all:
            self._marks.show_names()
            self._place_texts()
        return self._emphasis.show(highlighted) or of_scene

    def show_names(self, names: frozenset[str] | None) -> None:
        if names == self.names.wanted:
            return
        self.names.wanted = names
        self.show_layers(self._hidden)
        if self._marks is not None:
            self._marks.show_names()
            self._place_texts()

    def highlight_at(self, x_px: float, y_px: float) -> Highlight:
        names = self._emphasis.label_at(x_px, y_px)
        if names:
            return names
        left, top, width, height = self.picture_rectangle_px
        right, bottom = float(left + width), float(top + height)
        corners: list[Spot] = [
            (left, bottom, 0.0), (right, bottom, 0.0), (right, top, 0.0), (left, top, 0.0),
        ]  # fmt: skip
        points = [(_at_corner(i), corner) for i, corner in enumerate(corners)]
        segments: list[Segment] = [
            (frozenset((side,)), corners[i], corners[(i + 1) % 4]) for i, side in enumerate(SIDES)
        ]
        return pointed_at((x_px, y_px), self._style.font_size, points, segments)

    @property
    def picture_rectangle_px(self) -> Rectangle:
        return self.rectangle_in(*self._canvas.window.GetSize())

    @property
    def precision(self) -> Precision:
        return self._model.precision

    def show_projection(
        self, projection: Projection, illustration: Illustration | None = None
    ) -> None:
        if projection.image_size != self._image_size:
            self._image_size = projection.image_size
            self._canvas.relayout()
        self._projection = projection
        seen = self._seen
        surface, *lines = self._model.show_projection(seen)
        matrices = surface, *(lifted(matrix, seen, self._scene) for matrix in lines)
        for space, matrix in zip(self._model.actors.spaces, matrices, strict=True):
            space.set_projective(matrix)
        self._show_illustration(illustration)
        self._begin_blurring()
        if self._probes.probes:
            self._place_probes()
            self._place_texts()

    def show_layers(self, hidden: frozenset[str]) -> None:
        self._hidden = hidden
        if "pixels" not in self.names:
            hidden |= {AXES}
        if ("grid" in hidden) != ("grid" in self._canvas.hidden):
            self._model.show_grid("grid" not in hidden)
            if self._blurring is not None:
                self._blurring.model.show_grid("grid" not in hidden)
                self._blurring.restart()
        if self._framed and (AXES in hidden) != (AXES in self._canvas.hidden):
            for label in self._axis_labels:
                label.set_visible(AXES not in hidden)
            self._canvas.relayout()
        self._canvas.show_layers(hidden)

    def show_detail(self, fewer: Scene | None) -> None:
        self._model.show_detail(fewer)
        if self._blurring is not None:
            self._blurring.model.show_detail(fewer)
            self._blurring.restart()
        if self._marks is not None:
            self._marks.show_detail(fewer)

    def show_probes(self, probes: Sequence[Probe]) -> None:
        self._probes.probes = probes
        self._place_probes()
        self._place_texts()

    @property
    def _seen(self) -> Projection:
        """The projection with OpenGL's depth range; the picture is the same."""
        return self._projection.with_depth("opengl")

    def _show_illustration(self, illustration: Illustration | None) -> None:
        shown = illustration or Illustration(())
        self._rendering = shown.rendering or Rendering()
        if self._marks is None:
            if illustration is None:
                if self._scene.phenomenon is None:  # else copies of its faces are still to come
                    self._rasterise()
                return
            self._marks = MarksDrawing(
                self._canvas,
                self._scene,
                self._words,
                renderer=self._picture,
                over=True,
                names=self.names,
                board=self.board,
            )
        width, height = self._image_size
        placing = Placing(
            np.array([2.0 / width, -2.0 / height, 0.0]),
            np.array([-1.0, 1.0, _MARKS_DEPTH]),
            _FARTHEST_MARK,
        )
        self._marks.show(shown.image, placing)
        copies = [copy for copy in shown.copies if "image" in copy.panes]
        self._marks.show_copies(copies)
        if copies:
            seen, scene = self._seen, self._scene
            clip = seen.clip_from_world_at(scene.origin)
            nearer = lifted(clip, seen, scene) - clip
            self._marks.place_copies(lambda times: clip + times * nearer)
        self._rasterise()
        self._moved.show(shown.vertices)
        self._place_texts()

    @property
    def refused_depth(self) -> Refusal | None:
        return self._refused_depth

    @property
    def problem(self) -> Phrase | None:
        return None if self._rasteriser is None else self._rasteriser.problem

    def _rasterise(self) -> None:
        placed, requires = self._model.actors.placed, self._rasterised
        if not requires or not placed:
            return
        if self._rasteriser is None:
            copies = [] if self._marks is None else self._marks.copied_faces
            first, *others = placed
            self._rasteriser = Rasteriser(
                self._scene,
                self._style,
                requires,
                lambda actor: self._canvas.add(actor, renderer=self._picture),
                first,
                [*copies, *others],
            )
        rendering = self._rendering
        self._refused_depth = None
        if self._quality.has_depth and rendering.buffer is None:
            try:
                buffer = self._quality.depth_buffer(self._projection)
                rendering = replace(rendering, buffer=buffer)
            except Refusal as error:
                self._refused_depth = error
        self._rasteriser.show(rendering, self._seen)

    # -- a lens with an opening

    def _begin_blurring(self) -> None:
        """Begin another blurred picture, if this one has an opening; it is sharp until `refine`."""
        aperture, blurring = self._rendering.aperture, self._blurring
        if blurring is None:
            if aperture is None:
                return
            style = self._style.enlarged(1.0 / self._finer)
            self._blurring = blurring = Blurring(self._scene, style, self._tolerance_px)
            if "grid" in self._canvas.hidden:
                blurring.model.show_grid(False)
            self._canvas.add(blurring.actor, renderer=self._picture)
        _, _, width, height = self.picture_rectangle_px
        size = max(1, width // self._finer), max(1, height // self._finer)
        blurring.begin(self._projection, aperture, size)
        self._choose_picture(blurring)

    def _choose_picture(self, blurring: Blurring) -> None:
        for actor in self._model.actors:
            actor.SetVisibility(not blurring.actor.GetVisibility())

    @property
    def is_coarse(self) -> bool:
        return self._blurring is not None and self._blurring.is_coarse

    def refine(self, *, whole: bool = False) -> None:
        if self._blurring is not None:
            transparent = self._picture.GetBackgroundAlpha() == 0.0
            self._blurring.refine(transparent=transparent, whole=whole)
            self._choose_picture(self._blurring)

    def _place_texts(self, *, afresh: bool = False) -> bool:
        """Place the texts; return whether one has changed its place."""
        if not self._canvas.labels_light:
            return False
        rectangle = self.picture_rectangle_px
        half = np.array([rectangle.width, rectangle.height]) / 2.0

        def seen(points: Array) -> list[Spot]:
            spots = (points[:, :2] + 1.0) * half
            return [(x, y, 1.0) for x, y in spots.tolist()]

        marks = self._marks

        def ink(ground: Ground) -> None:
            clip = self._projection.clip_from_local(self._scene.origin, "object")
            with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
                corners = self._silhouette.triangles @ clip[:, :3].T + clip[:, 3]
                w = np.where(corners[..., 3:] > 0.0, corners[..., 3:], np.nan)
                self._silhouette.ink(ground, (corners[..., :2] / w + 1.0) * half)
            if marks is not None:
                marks.ink(ground, seen)

        em = self._style.font_size
        ground = Ground(room(rectangle.width, rectangle.height, em), em, ink)
        self._probes.want(ground)
        if marks is not None:
            marks.want_texts(ground, seen)
        return self.board.settle(ground, afresh=afresh)

    def reset_view(self) -> None:
        self._place_texts(afresh=True)

    def refit(self) -> bool:
        return self._place_texts(afresh=True)

    @property
    def sight(self) -> Sight:
        left, top, *_ = rectangle = self.picture_rectangle_px
        scaled = self._scaled(rectangle)
        scaled[:2, 2] = left, top
        return Sight.of(self._projection).scaled(scaled)

    def spots_of(self, places: Array) -> Array:
        rectangle = self.picture_rectangle_px
        scale = np.diag(self._scaled(rectangle))[:2]
        return places * scale + (rectangle.left, rectangle.top)

    def image_pixel(self, x_px: float, y_px: float) -> tuple[float, float] | None:
        left, top, width, height = rectangle = self.picture_rectangle_px
        x, y = x_px - left, y_px - top
        if not (0.0 <= x <= width and 0.0 <= y <= height):
            return None
        scale = self._scaled(rectangle)
        return float(x / scale[0, 0]), float(y / scale[1, 1])

    def glide(self, part: float) -> None:
        self._canvas.fade_labels(light_of_labels(part))
        self._place_texts(afresh=part == 1.0)

    def image_shift(self, right_px: float, down_px: float) -> tuple[float, float]:
        rectangle = self.picture_rectangle_px
        width, height = self._image_size
        return right_px * width / rectangle.width, down_px * height / rectangle.height

    def _scaled(self, rectangle: Rectangle) -> NDArray[np.float64]:
        """From the image's pixels to the pane's, from the picture's top left."""
        width, height = self._image_size
        return np.diag([rectangle.width / width, rectangle.height / height, 1.0])

    def _place_probes(self) -> None:
        rectangle = self.picture_rectangle_px
        marks = self._probes.in_image(self._projection, self._scaled(rectangle))
        self._probes.show(marks, (rectangle.width, rectangle.height))

    def remove(self) -> None:
        if self._blurring is not None:
            self._blurring.close()
        self._canvas.remove()
        self._canvas.window.RemoveRenderer(self._picture)
        self._canvas.window.SetNumberOfLayers(self._layers)
        self._canvas.renderer.SetActiveCamera(self._own_camera)

    # -- made once

    def _add_picture(self) -> None:
        picture = self._picture
        self._canvas.make_ready(picture)
        picture.SetActiveCamera(identity_camera())
        picture.SetBackground(*rgb(self._style.background))
        picture.SetLayer(1)
        picture.PreserveColorBufferOff()  # a layer above the first is transparent otherwise
        picture.InteractiveOff()
        self._layers = self._canvas.window.GetNumberOfLayers()
        self._canvas.window.SetNumberOfLayers(max(2, self._layers))
        self._canvas.window.AddRenderer(picture)
        self._canvas.add(*self._model.actors, renderer=picture)

    def _add_axes(self, words: Mapping[str, str]) -> None:
        style = self._style
        self._spaces: dict[str, Space] = {}
        # A line: thin faces before the picture are lost where a program draws shapes coarsely.
        self._frame = line_actor(_SQUARE, [(0, 1, 2, 3, 0)], style.ink, 1.0)
        self._spaces["frame"] = Space()
        self._spaces["frame"].add(self._frame)
        self._canvas.add(self._frame)
        for name, colour, points in (
            ("x axis", style.u, _SQUARE),
            ("y axis", style.v, _SQUARE),
            ("origin", style.ink, _SQUARE),
            ("x head", style.u, ((0.0, -1.0, 0.0), (2.0, 0.0, 0.0), (0.0, 1.0, 0.0))),
            ("y head", style.v, ((-1.0, 0.0, 0.0), (0.0, 2.0, 0.0), (1.0, 0.0, 0.0))),
        ):
            self._add_face(name, colour, points, AXES)
        label = self._canvas.label
        self._zero = label("0, 0", anchor=(-1, -1))
        self._width_label = label("", anchor=(1, -1))
        self._height_label = label("", anchor=(-1, 1))
        self._x_label = label(words["x"], anchor=(-1, 1), colour=style.u)
        self._y_label = label(words["y"], anchor=(1, 1), colour=style.v)
        self._axis_labels = (
            self._zero, self._width_label, self._height_label, self._x_label, self._y_label
        )  # fmt: skip

    def _add_sides(self) -> None:
        """Bars and squares over the frame for a highlighted side or corner."""
        accent, hidden = self._style.accent, self._emphasis.hidden
        for side in SIDES:
            names = (side, "fov") if side in ("top", "bottom") else (side,)
            hidden(self._add_face(side, accent), *names)
        for i in range(4):
            hidden(self._add_face(f"corner {i}", accent), *_at_corner(i))
        for name, label in (("u", self._x_label), ("v", self._y_label)):
            hidden(self._add_face(name, getattr(self._style, name)), name)
            self._emphasis.label(label, name)

    def _add_face(
        self,
        name: str,
        colour: str,
        points: Sequence[tuple[float, float, float]] = _SQUARE,
        layer: str = "",
    ) -> Any:
        actor = face_actor(points, [range(len(points))], colour)
        self._spaces[name] = Space()
        self._spaces[name].add(actor)
        self._canvas.add(actor, layer=layer)
        return actor

    # -- changed when the pane's or the image's size changes

    def rectangle_in(self, pane_width_px: int, pane_height_px: int) -> Rectangle:
        left, top, right, bottom = self._margins_px if self._framed else (0, 0, 0, 0)
        room_x = max(1, pane_width_px - left - right)
        room_y = max(1, pane_height_px - top - bottom)
        width, height = self._image_size
        scale = min(room_x / width, room_y / height)
        fit_x = min(room_x, max(1, round(width * scale)))
        fit_y = min(room_y, max(1, round(height * scale)))
        return Rectangle(left + (room_x - fit_x) // 2, top + (room_y - fit_y) // 2, fit_x, fit_y)

    @property
    def _margins_px(self) -> tuple[int, int, int, int]:
        """Left, top, right, bottom: room for the numbers, the arrow heads and their letters."""
        em = self._style.font_size
        if AXES in self._canvas.hidden:
            side = round(BARE_EM * em)
            return side, round((BARE_EM + TITLE_EM) * em), side, side
        above = 1.7 + TITLE_EM
        return round(2.2 * em), round(above * em), round(1.8 * em), round(2.0 * em)

    def _layout(self, pane_width_px: int, pane_height_px: int) -> None:
        left, top, width, height = self.rectangle_in(pane_width_px, pane_height_px)
        right, bottom = left + width, top + height
        self._picture.SetViewport(
            left / pane_width_px,
            (pane_height_px - bottom) / pane_height_px,
            right / pane_width_px,
            (pane_height_px - top) / pane_height_px,
        )
        self._begin_blurring()
        self._place_probes()
        self._place_texts(afresh=True)
        if not self._framed:
            return
        em = self._style.font_size
        thin, thick = (max(1, round(k * self._style.line_width)) for k in (0.5, 1.0))
        tip, head, wide = round(0.6 * em), 0.3 * em, 3 * thick
        self._frame.GetProperty().SetLineWidth(thin)
        places: dict[str, tuple[float, float, float, float]] = {
            "frame": (left - thin / 2.0, top - thin / 2.0, width + thin, height + thin),
            "x axis": (left - thick, top - thick, width + thick + tip, thick),
            "y axis": (left - thick, top - thick, thick, height + thick + tip),
            "origin": (left - 2 * thick, top - 2 * thick, 2 * thick, 2 * thick),
            "x head": (right + tip, top - thick / 2.0, head, head),
            "y head": (left - thick / 2.0, bottom + tip, head, head),
            "left": (left - wide, top - wide, wide, height + 2 * wide),
            "right": (right, top - wide, wide, height + 2 * wide),
            "top": (left - wide, top - wide, width + 2 * wide, wide),
            "bottom": (left - wide, bottom, width + 2 * wide, wide),
            "u": (left - thick, top - wide, width + thick + tip, wide),
            "v": (left - wide, top - thick, wide, height + thick + tip),
        }
        corners = (left, bottom), (right, bottom), (right, top), (left, top)
        for i, (at_x, at_y) in enumerate(corners):
            places[f"corner {i}"] = at_x - 2 * wide, at_y - 2 * wide, 4 * wide, 4 * wide
        for name, (x, y, across, down) in places.items():
            # Unit lengths to pixels, 0 to a pixel from the pane's top left.
            matrix = np.diag([2.0 * across / pane_width_px, -2.0 * down / pane_height_px, 1.0, 1.0])
            matrix[:2, 3] = 2.0 * x / pane_width_px - 1.0, 1.0 - 2.0 * y / pane_height_px
            self._spaces[name].set(matrix)

        def move(label: Any, x: float, y: float) -> None:
            label.set_position(x, pane_height_px - y)

        gap = 0.35 * em
        self._width_label.set_text(str(self._image_size[0]))
        self._height_label.set_text(str(self._image_size[1]))
        # Above and below the picture, which keeps the width of the pane.
        zero, above = left - 1.6 * em, top - thick - gap
        least = zero + (len("0, 0") + len(str(self._image_size[0]))) * _EM_OF_DIGIT * em
        width_end = max(right - gap, least)
        move(self._zero, zero, above)
        if self._caption is not None:
            bare = AXES in self._canvas.hidden
            higher = above if bare else above - 1.3 * em
            move(self._caption, left + self._middle * width, higher)
        move(self._width_label, width_end, above)
        # Below its axis, as y is beside its own: above it is the title row with its buttons.
        move(self._x_label, right + thin, top + head + gap)
        move(self._height_label, left + head + gap, bottom + thin + gap)
        move(self._y_label, left - head - gap, bottom + thin + gap)


def _at_corner(i: int) -> Highlight:
    """The corners of the view volume that are seen in a corner of the picture."""
    return corner_at(SIDES[i - 1], SIDES[i])
