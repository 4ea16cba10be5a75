"""What stands round the picture: its border, its pixel axes with their numbers, and its caption."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from app.drawings import AXES
from app.drawings.actors import Space, face_actor, lifted, line_actor
from app.drawings.drawing import Rectangle
from app.drawings.label_placement import room
from app.drawings.layer import Layer, PaneState, Placing
from app.drawings.side_by_side import BARE_EM
from app.drawings.style import TITLE_EM
from app.lecture.highlight import SIDES, corner_at
from app.lecture.typesetting import line_of
from app.model.projection import Array
from app.picking.sight import Sight
from app.precision.quality import AUTOMATIC, Quality
from app.scenes.phenomena.marks import Eyes

_SQUARE = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0))
_MARKS_DEPTH = -0.9999  # just behind near
_FARTHEST_MARK = 1e3  # of half a picture: where lines toward infinity end
_EM_OF_DIGIT = 0.64  # width of a digit of the labels' font


class PictureOptions(NamedTuple):
    """How a picture is shown.

    Without a frame it has no axes and no margins either. In a frame it has its axes if they are
    named, and perhaps a caption, which stands at `middle` of the picture's width. `finer` is how
    many pixels of the window, along each side, become one in the end. `quality` has the depth
    buffer, unless the scene is about a buffer itself.
    """

    framed: bool = True
    caption: str = ""
    middle: float = 0.5
    finer: int = 1
    quality: Quality = AUTOMATIC


FRAMED, UNFRAMED = PictureOptions(), PictureOptions(framed=False)


class ImageState(PaneState):
    """What the layers of the image pane share: where the picture is in the pane."""

    pane = "image"
    options = FRAMED

    def rectangle_in(self, pane_width_px: int, pane_height_px: int) -> Rectangle:
        left, top, right, bottom = self._margins_px if self.options.framed else (0, 0, 0, 0)
        room_x = max(1, pane_width_px - left - right)
        room_y = max(1, pane_height_px - top - bottom)
        width, height = self.projection.image_size
        scale = min(room_x / width, room_y / height)
        fit_x = min(room_x, max(1, round(width * scale)))
        fit_y = min(room_y, max(1, round(height * scale)))
        return Rectangle(left + (room_x - fit_x) // 2, top + (room_y - fit_y) // 2, fit_x, fit_y)

    @property
    def _margins_px(self) -> tuple[int, int, int, int]:
        """Left, top, right, bottom: room for the numbers, the arrow heads and their letters."""
        em = self.em
        if AXES in self.canvas.hidden:
            side = round(BARE_EM * em)
            return side, round((BARE_EM + TITLE_EM) * em), side, side
        return round(2.2 * em), round((1.7 + TITLE_EM) * em), round(1.8 * em), round(2.0 * em)

    @property
    def eyes(self) -> Eyes | None:
        """The two eyes whose pictures are shown instead of the camera's."""
        rendering = None if self.illustration is None else self.illustration.rendering
        return None if rendering is None else rendering.eyes

    @property
    def rectangle(self) -> Rectangle:
        """Where the picture is in the pane."""
        return self.rectangle_in(*self.canvas.window.GetSize())

    @property
    def size_px(self) -> tuple[int, int]:
        return self.rectangle[2:]

    @property
    def corner_px(self) -> tuple[int, int]:
        return self.rectangle[:2]

    @property
    def room(self) -> tuple[float, float, float, float]:
        return room(*self.size_px, self.em)

    @property
    def half(self) -> Array:
        """Half of the picture's width and height in the pane."""
        return np.array(self.size_px) / 2.0

    @property
    def scale(self) -> Array:
        """From the image's pixels to the pane's, from the picture's top left, (2, 2)."""
        return np.diag(np.array(self.size_px) / self.projection.image_size)

    def spots(self, points: Array) -> Array:
        return (points[:, :2] + 1.0) * self.half

    def placing(self) -> Placing:
        width, height = self.projection.image_size
        scale, shift = (2.0 / width, -2.0 / height, 0.0), (-1.0, 1.0, _MARKS_DEPTH)
        return Placing(np.array(scale), np.array(shift), _FARTHEST_MARK)

    def copies_from_local(self, times: float) -> Array:
        seen, scene = self.seen_projection, self.scene
        clip = seen.clip_from_local(scene.origin)
        return clip + times * (lifted(clip, seen, scene) - clip)

    @property
    def sight(self) -> Sight:
        scaled = np.eye(3)
        scaled[:2, :2], scaled[:2, 2] = self.scale, self.rectangle[:2]
        return Sight.of(self.projection).scaled(scaled)


class PictureFrame(Layer):
    _state: ImageState

    def __init__(self, state: ImageState) -> None:
        self._state, self._canvas, self._style = state, state.canvas, state.style
        self._add_axes(state.words)
        self.show_axes(AXES not in state.canvas.hidden)
        self._add_sides()
        self._caption: Any = None
        if state.options.caption:
            self._caption = self._canvas.label(state.options.caption, anchor=(0, -1))

    def show_axes(self, shown: bool) -> None:
        for label in self._axis_labels:
            label.set_visible(shown)

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
        self._x_label = label(words.get("{pixel_x}", "x"), anchor=(-1, 1), colour=style.u)
        self._y_label = label(words.get("{pixel_y}", "y"), anchor=(1, 1), colour=style.v)
        self._axis_labels = (
            self._zero, self._width_label, self._height_label, self._x_label, self._y_label
        )  # fmt: skip

    def _add_sides(self) -> None:
        """Bars and squares over the frame for a highlighted side or corner."""
        accent, hidden = self._style.accent, self._state.emphasis.hidden
        for side in SIDES:
            names = (side, "fov") if side in ("top", "bottom") else (side,)
            hidden(self._add_face(side, accent), *names)
        for i in range(4):
            hidden(self._add_face(f"corner {i}", accent), *corner_at(SIDES[i - 1], SIDES[i]))
        for name, label in (("u", self._x_label), ("v", self._y_label)):
            hidden(self._add_face(name, getattr(self._style, name)), name)
            self._state.emphasis.label(label, name)

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

    def lay_out(self, pane_width_px: int, pane_height_px: int) -> None:
        left, top, width, height = self._state.rectangle_in(pane_width_px, pane_height_px)
        right, bottom = left + width, top + height
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
        self._width_label.set_text(str(self._state.projection.image_size[0]))
        self._height_label.set_text(str(self._state.projection.image_size[1]))
        # Above and below the picture, which keeps the width of the pane.
        zero, above = left - 1.6 * em, top - thick - gap
        digits = len("0, 0") + len(str(self._state.projection.image_size[0]))
        least = zero + digits * _EM_OF_DIGIT * em
        width_end = max(right - gap, least)
        move(self._zero, zero, above)
        if self._caption is not None:
            bare = AXES in self._canvas.hidden
            line = line_of(self._caption.text, one_size=self._style.one_size)
            higher = above - line.box[1] * em - (0.0 if bare else 1.3 * em)  # all on one line
            move(self._caption, left + self._state.options.middle * width, higher)
        move(self._width_label, width_end, above)
        # Below its axis, as y is beside its own: above it is the title row with its buttons.
        move(self._x_label, right + thin, top + head + gap)
        move(self._height_label, left + head + gap, bottom + thin + gap)
        move(self._y_label, left - head - gap, bottom + thin + gap)
