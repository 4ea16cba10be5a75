"""Labels as they are printed: words upright, letters of formulas in italics.

A label is written as formulas are elsewhere (`app.lecture.typesetting`), and Agg draws it into a
texture.
"""

import math
import re
import weakref
from dataclasses import replace
from functools import lru_cache
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper2D, vtkTexture, vtkTexturedActor2D

from app.drawings.style import Style, rgb
from app.languages import with_comma
from app.lecture.typesetting import Outline, as_shipped, line_of, piece_of

Pixels = NDArray[np.uint8]

Tile: TypeAlias = tuple[Pixels, Pixels, int, int]
"""The coverage of a piece's letters and of their halo, from the top; how far its first column is
from the pixel where it begins, and its first row above the line."""

TILES: dict[str, Tile] = {}  # the tiles that have been drawn, at most `MOST_TILES`
MOST_TILES = 600
HALO_EM = 0.14
HALO_OPACITY = 0.8  # the tint of a plane shows through
UNDER_EM = 0.2
FILLED, FILLED_EM, FILLED_AT = " .,", 0.6, (0.1, 0.9)  # pieces with a halo round two lines, too
_SHORT = re.compile(r"(?:[^=]* )?([^ =]+) = [^=]+")
PARTS = 4  # of a pixel, to which a piece is placed


def drawn(
    text: str, em: float, colour: str, halo: str, underlined: bool = False, **how: bool
) -> Pixels:
    """Draw a label with a halo round its letters: (h, w, 4) uint8 with opacity, from the top.

    `em` is the height of a word's em in pixels; the halo's `rim` is on every side.
    """
    label, rim = line_of(text, **how), rim_px(em)
    left, low, right, high = (side * em for side in label.box)
    under = max(2, round(UNDER_EM * em)) if underlined else 0
    width, height = math.ceil(right - left) + 2 * rim, math.ceil(high - low) + 2 * rim + under
    line = height - rim - under + math.floor(low)  # the row below which letters descend
    ink, around = np.zeros((2, height + 2, width + 2), dtype=np.uint8)
    for piece, is_tex, size, x in label.pieces:
        place = round((x * em - left) * PARTS)
        letters, halos, to_right, up = tile(piece, is_tex, size * em, HALO_EM * em, place % PARTS)
        top, first = line - up, place // PARTS + rim + to_right
        for whole, part in ((ink, letters), (around, halos)):
            part = part[max(-top, 0) :, max(-first, 0) :]
            room = whole[max(top, 0) :, max(first, 0) :][: part.shape[0], : part.shape[1]]
            part = part[: room.shape[0], : room.shape[1]]
            np.maximum(room, part, out=room)
    if underlined:
        ink[height - rim - under // 2 : height - rim, rim : width - rim] = 255
    over = ink[:height, :width] / np.float32(255.0)
    behind = around[:height, :width] / np.float32(255.0 / HALO_OPACITY) * (1.0 - over)
    opacity = over + behind
    pixels = np.empty((height, width, 4), dtype=np.uint8)
    share = over / np.maximum(opacity, 1e-6)
    for channel, (of_ink, of_halo) in enumerate(zip(rgb(colour), rgb(halo), strict=True)):
        pixels[..., channel] = np.rint(255.0 * (of_halo + (of_ink - of_halo) * share))
    pixels[..., 3] = np.rint(255.0 * opacity)
    return pixels


@lru_cache(maxsize=2048)
def tile(piece: str, is_tex: bool, em: float, halo_px: float, shift: int) -> Tile:
    """Draw a piece that begins `shift` parts of a pixel to the right of a whole one."""
    key = f"{em!r} {halo_px!r} {shift} {int(is_tex)} {piece}"
    made = TILES[key] if key in TILES else _drawn_tile(piece, is_tex, em, halo_px, shift)
    if len(TILES) < MOST_TILES:
        TILES[key] = made
    return made


@as_shipped()
def _drawn_tile(piece: str, is_tex: bool, em: float, halo_px: float, shift: int) -> Tile:
    from matplotlib.backends.backend_agg import RendererAgg
    from matplotlib.path import Path
    from matplotlib.transforms import Affine2D

    drawn = surrounded(piece, is_tex)
    if not len(drawn.vertices):
        empty = np.zeros((0, 0), dtype=np.uint8)
        return empty, empty, 0, 0
    left, low, right, high = (side * em for side in drawn.box)
    rim, part = math.ceil(halo_px) + 1, shift / PARTS
    first, below = math.floor(left) - rim, math.floor(low) - rim
    width = math.ceil(right + part) + rim - first
    height = math.ceil(high) + rim - below
    path: Any = Path(drawn.vertices, drawn.codes)
    placed: Any = Affine2D().scale(em).translate(part - first, -below)
    coverages = []
    make: Any = RendererAgg
    for pen_px in (0.0, 2.0 * halo_px):
        renderer = make(width, height, 72)
        pen = renderer.new_gc()
        pen.set_joinstyle("round")
        pen.set_capstyle("round")
        pen.set_foreground("white")
        pen.set_linewidth(pen_px)
        renderer.draw_path(pen, path, placed, (1.0, 1.0, 1.0))
        coverages.append(np.array(renderer.buffer_rgba())[..., 3])
    letters, halo = coverages
    return letters, halo, first, height + below


def surrounded(piece: str, is_tex: bool) -> Outline:
    """Return what a halo surrounds: a piece, and two lines in a space or above a point.

    So no line shows between words, nor as a second point above that of a number.
    """
    drawn = piece_of(piece, is_tex)
    if piece not in FILLED:
        return drawn
    lines = [(drawn.width * x, y) for x in FILLED_AT for y in (0.0, FILLED_EM)]
    codes = np.append(drawn.codes, np.array([1, 2, 1, 2], dtype=np.uint8))
    return replace(drawn, vertices=np.vstack([drawn.vertices, lines]), codes=codes)


def rim_px(em: float) -> int:
    """The width of a label's halo in whole pixels."""
    return math.ceil(HALO_EM * em)


def size_px(text: str, em: float, **how: bool) -> tuple[int, int]:
    """Return the width and the height of a label's letters, without its halo."""
    left, low, right, high = line_of(text, **how).box
    return math.ceil((right - left) * em), math.ceil((high - low) * em)


class LabelText(NamedTuple):
    """A label as text: its pieces as of `LineLayout`, and where its baseline begins.

    `place` is in pixels, counted from the renderer's left and bottom; `turn` is in radians.
    """

    text: str
    pieces: tuple[tuple[str, bool, float, float], ...]
    widths: tuple[float, ...]
    place: tuple[float, float]
    turn: float
    em: float
    colour: str
    halo: str
    opacity: float
    underlined: bool
    anchor: int = 0  # what keeps its place in another font: -1 left end, 0 middle, 1 right end


_QUAD = vtkCellArray()
_QUAD.InsertNextCell(4, (0, 1, 2, 3))
_ON_IMAGE: Any = numpy_to_vtk(  # type: ignore[no-untyped-call]
    np.array([(0, 0), (1, 0), (1, 1), (0, 1)], dtype=np.float32), deep=True
)


class LabelActor(vtkTexturedActor2D):
    """The actor of a label, by which a window's labels are found."""

    label: "weakref.ref[SceneLabel]"


class SceneLabel:
    """A text at a pixel of a renderer, of constant size, in the dark tone of a colour.

    `anchor` says which part of the letters is at the position: -1 left, 0 centre, 1 right; -1
    bottom, 0 middle, 1 top. A `plain` text is a sentence or a stranger's, and has no formulas.
    """

    def __init__(
        self,
        text: str,
        style: Style,
        *,
        colour: str = "",
        anchor: tuple[int, int] = (0, 0),
        plain: bool = False,
        visible: bool = True,
    ) -> None:
        self.em = style.font_size
        self._how = {"plain": plain, "one_size": style.one_size}
        self._style, self._anchor = style, anchor
        self.is_visible, self._shown, self._is_short = visible, True, False
        self._underlined = False
        self._opacity = self._light = 1.0
        self._place = 0.0, 0.0, 0.0
        self._tone = style.tone(colour)
        self._given = text
        self._write(with_comma(text))
        self._drawn: tuple[str, str, bool] | None = None
        self._size = (0, 0)
        self.actor = LabelActor()
        self.actor.label = weakref.ref(self)
        self._show()

    def _make_quad(self) -> None:
        """Make what the actor draws, when it is first seen: most labels are not."""
        self._image, self._texture = vtkImageData(), vtkTexture()
        self._texture.SetInputData(self._image)
        self._texture.SetColorModeToDirectScalars()
        self._corners = vtkPoints()
        self._corners.SetNumberOfPoints(4)
        quad = vtkPolyData()
        quad.SetPoints(self._corners)
        quad.SetPolys(_QUAD)
        quad.GetPointData().SetTCoords(_ON_IMAGE)
        mapper = vtkPolyDataMapper2D()
        mapper.SetInputData(quad)
        self.actor.SetMapper(mapper)
        self.actor.SetTexture(self._texture)

    @property
    def _shown_px(self) -> tuple[int, int]:
        return self.letter_px if self._is_short else self.size_px

    def set_text(self, text: str) -> None:
        """Write another text; the same one costs nothing."""
        if text != self._given:
            self._given = text
            self._write(with_comma(text))
            self._show()

    def _write(self, text: str) -> None:
        valued = None if self._how["plain"] else _SHORT.fullmatch(text)
        self._text = text
        self._letter = text if valued is None else valued[1]  # of a text such as ``near n = 4``
        self.size_px = size_px(text, self.em, **self._how)
        """Width and height of the letters without halo, of the whole text."""
        self.letter_px = size_px(self._letter, self.em, **self._how)

    def shorten(self, short: bool) -> None:
        """Show only the letter of a text such as ``near n = 4``."""
        self._set("_is_short", short)

    def set_colour(self, colour: str) -> None:
        self._set("_tone", self._style.tone(colour))

    def set_opacity(self, opacity: float) -> None:
        self._opacity = opacity
        self.actor.GetProperty().SetOpacity(self._light * opacity)

    def fade(self, light: float) -> None:
        """Show a part of the label's opacity, 0 to 1."""
        self._light = light
        self.set_opacity(self._opacity)

    def set_position(self, x_px: float, y_px: float, turn: float = 0.0) -> None:
        """Move to a pixel, counted from the renderer's left and bottom; turn, in radians."""
        self._set("_place", (x_px, y_px, turn))

    def set_visible(self, visible: bool) -> None:
        self._set("is_visible", visible)

    def set_shown(self, shown: bool) -> None:
        """Switch the label off, whatever `set_visible` says, or on again."""
        self._set("_shown", shown)

    def set_underlined(self, underlined: bool) -> None:
        """Underline the label while what it names is highlighted; not on paper."""
        self._set("_underlined", underlined and not self._style.on_paper)

    def _set(self, name: str, value: object) -> None:
        if getattr(self, name) != value:
            setattr(self, name, value)
            self._show()

    def _show(self) -> None:
        self.text = self._letter if self._is_short else self._text
        """What is shown: the whole text, or only its letter."""
        seen = self.is_visible and self._shown and bool(self.text)
        self.actor.SetVisibility(seen)
        if not seen:
            return
        if self._drawn is None:
            self._make_quad()
        wanted = self.text, self._tone, self._underlined
        if wanted != self._drawn:
            self._drawn = wanted
            halo = self._style.background
            pixels = drawn(self.text, self.em, self._tone, halo, self._underlined, **self._how)
            height, width = pixels.shape[:2]
            self._size = width, height
            rows = np.ascontiguousarray(pixels[::-1]).reshape(-1, 4)
            self._image.SetDimensions(width, height, 1)
            self._image.GetPointData().SetScalars(numpy_to_vtk(rows, deep=1))  # type: ignore[no-untyped-call]
        (x, y, turn), (width, height) = self._place, self._size
        self._texture.SetInterpolate(bool(turn))
        (wide, high), rim, (to_right, to_top) = self._shown_px, rim_px(self.em), self._anchor
        below = height - high - rim  # with the underline
        left, low = -(to_right + 1) / 2.0 * wide - rim, -(to_top + 1) / 2.0 * high - below
        cos, sin = math.cos(turn), math.sin(turn)
        if not turn:  # on whole pixels, as it was drawn
            x, y, left, low = round(x + left), round(y + low), 0.0, 0.0
        self.actor.SetPosition(x, y)
        for i, (right, up) in enumerate(
            ((left, low), (left + width, low), (left + width, low + height), (left, low + height))
        ):
            self._corners.SetPoint(i, cos * right - sin * up, sin * right + cos * up, 0.0)
        self._corners.Modified()

    @property
    def written(self) -> LabelText:
        label = line_of(self.text, **self._how)
        left, low, _, _ = label.box
        (x, y, turn), (to_right, to_top) = self._place, self._anchor
        (wide, high), (cos, sin) = self._shown_px, (math.cos(turn), math.sin(turn))
        along = -(to_right + 1) / 2.0 * wide - left * self.em
        up = -(to_top + 1) / 2.0 * high - low * self.em
        place = x + cos * along - sin * up, y + sin * along + cos * up
        widths = tuple(piece_of(piece, is_tex).width for piece, is_tex, *_ in label.pieces)
        return LabelText(
            self.text, label.pieces, widths, place, turn, self.em, self._tone,
            self._style.background, self._opacity * self._light, self._underlined, to_right,
        )  # fmt: skip

    @property
    def box_px(self) -> tuple[float, float, float, float]:
        """Left, right, bottom and top of the letters, from the renderer's left and bottom."""
        (x, y, turn), (wide, high), (to_right, to_top) = self._place, self._shown_px, self._anchor
        cos, sin = abs(math.cos(turn)), abs(math.sin(turn))
        wide, high = cos * wide + sin * high, sin * wide + cos * high  # type: ignore[assignment]
        left, low = x - (to_right + 1) / 2.0 * wide, y - (to_top + 1) / 2.0 * high
        return left, left + wide, low, low + high

    def covers(self, x_px: float, y_px: float) -> bool:
        """Return whether the label, with its underline, is visible at a pixel of the renderer."""
        (left, right, bottom, top), rim = self.box_px, (UNDER_EM + HALO_EM) * self.em
        inside = left - rim <= x_px <= right + rim and bottom - rim <= y_px <= top + rim
        return inside and bool(self.actor.GetVisibility())
