"""Labels as they are printed: words upright, letters of formulas in italics.

A label is written as formulas are elsewhere: ``y_p`` has a subscript, `ARROW` follows
the letter of a vector, ``'`` is a prime. A word of several letters is upright. What stands between
dollar signs is TeX. matplotlib sets the letters in STIX, and Agg draws them into a texture.
"""

from __future__ import annotations

import importlib.util
import math
import pathlib
import re
import weakref
from functools import cache, lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper2D, vtkTexture, vtkTexturedActor2D

from app.drawings.style import Style, rgb
from app.lessons.text import outline
from app.model.formula import ARROW
from app.model.projection import Array

Pixels = NDArray[np.uint8]

LARGER = 1.3
"""Size of a label that is only a letter, relative to a word."""
_AMONG_WORDS = 1.12
"""Size of a letter beside words: STIX looks smaller than DejaVu Sans."""
HALO_EM = 0.14
HALO_OPACITY = 0.8
"""The tint of a plane shows through."""
UNDER_EM = 0.2
_LOWERED = re.compile("[₀-₉]+")
_LEVEL = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_FUNCTIONS = frozenset(("tan", "sin", "cos", "log"))
_SIZE = 100.0
_PARTS = 4  # of a pixel, to which a piece is placed
_GREEK = dict(zip("αβγδεθλμπρσφω", (
    "alpha", "beta", "gamma", "delta", "epsilon", "theta", "lambda", "mu", "pi", "rho", "sigma",
    "phi", "omega",
), strict=True))  # fmt: skip
_TOKEN = re.compile(
    r"\$(?P<tex>[^$]+)\$"
    rf"|(?P<letter>(?<![^\W_])[A-Za-z\u0391-\u03c9](?![^\W\d_]){ARROW}?|[^\W\d_]+(?=_))"
    r"(?P<sub>(?:_(?:\{[^}]*\}|[^\W_]+))?)(?P<prime>['\u2032]*)"
    r"|(?P<word>[^\W\d_]{2,})"
    r"|(?P<sign>.)",
    re.DOTALL,
)


class LabelPiece(NamedTuple):
    vertices: Array  # (n, 2), in em from its place on the line
    codes: NDArray[Any]
    width: float

    @property
    def box(self) -> tuple[float, float, float, float]:
        (left, low), (right, high) = self.vertices.min(axis=0), self.vertices.max(axis=0)
        return float(left), float(low), float(right), float(high)


class LabelLayout(NamedTuple):
    """A label that is set in one line, in words' em; `box` is where there is ink, y upwards."""

    pieces: tuple[tuple[str, bool, float, float], ...]  # each with its size and its left end
    box: tuple[float, float, float, float]  # left, low, right, high


def pieces_of(text: str) -> list[tuple[str, bool]]:
    """Split a label into words and formulas, each with whether it is TeX."""
    pieces: list[tuple[str, bool]] = []
    for token in _TOKEN.finditer(
        _LOWERED.sub(lambda match: "_" + match[0].translate(_LEVEL), text)
    ):
        if token["tex"]:
            pieces.append((token["tex"], True))
        elif token["letter"]:
            pieces.append((_tex(token["letter"], token["sub"]) + token["prime"], True))
        elif token["word"] in _FUNCTIONS:
            pieces.append((rf"\{token['word']} ", True))
        elif token["word"] == "fov":  # as in fov_x
            pieces.append((_tex("fov", ""), True))
        else:
            pieces.append((token["word"] or token["sign"], False))
    return pieces


def _tex(letter: str, sub: str) -> str:
    name = letter.removesuffix(ARROW)
    base = (
        rf"\mathrm{{{name}}}" if len(name) > 1 else rf"\{_GREEK[name]} " if name in _GREEK else name
    )
    if name != letter:
        base = rf"\vec{{{base}}}"
    below = sub[1:].strip("{}")
    if len(below) > 1 and not below.isdigit():
        below = rf"\mathrm{{{below}}}"
    return f"{base}_{{{below}}}" if below else base


@lru_cache(maxsize=256)
def laid(text: str, plain: bool = False) -> LabelLayout:
    """Set a label in one line. TeX that cannot be drawn is shown as it is typed."""
    pieces = [(text, False)] if plain else [_drawable(*piece) for piece in pieces_of(text)]
    has_words = any(len(piece) > 1 and not is_tex for piece, is_tex in pieces)
    larger = 1.0 if plain else _AMONG_WORDS if has_words else LARGER
    placed, boxes, x = [], [], 0.0
    for piece, is_tex in pieces:
        size = 1.0 if len(piece) > 1 and not is_tex else larger
        drawn = piece_of(piece, is_tex)
        placed.append((piece, is_tex, size, x))
        if len(drawn.vertices):
            left, low, right, high = (size * side for side in drawn.box)
            boxes.append((x + left, low, x + right, high))
        x += drawn.width * size
    lefts, lows, rights, highs = zip(*boxes or [(0.0, 0.0, 0.0, 0.0)], strict=True)
    return LabelLayout(tuple(placed), (min(lefts), min(lows), max(rights), max(highs)))


def _drawable(piece: str, is_tex: bool) -> tuple[str, bool]:
    try:
        if is_tex:
            outline(piece)
    except ValueError:
        return f"${piece}$", False
    return piece, is_tex


def is_set_in_words(piece: str) -> bool:
    """Whether a piece that is no formula is set in the font of words."""
    return any(map(str.isalpha, piece)) or not _signs("STIXGeneral").issuperset(piece)


@lru_cache(maxsize=1024)
def piece_of(text: str, is_tex: bool) -> LabelPiece:
    if is_tex:
        drawn = outline(text)
        return LabelPiece(drawn.vertices, drawn.codes, drawn.width)
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextToPath

    reader: Any = TextToPath()
    name = "DejaVuSans" if is_set_in_words(text) else "STIXGeneral"
    text = "".join(sign if sign in _signs(name) else "\ufffd" for sign in text)
    font: Any = FontProperties(fname=font_file(name), size=_SIZE)
    width, _, _ = reader.get_text_width_height_descent(text, font, ismath=False)
    vertices, codes = reader.get_text_path(font, text, ismath=False)
    points = np.reshape(np.asarray(vertices, dtype=np.float64), (-1, 2)) / _SIZE
    return LabelPiece(points, np.asarray(codes, dtype=np.uint8), width / _SIZE)


def drawn(
    text: str, em: float, colour: str, halo: str, underlined: bool = False, plain: bool = False
) -> Pixels:
    """Draw a label with a halo round its letters.

    Parameters
    ----------
    em : float
        The height of a word's em in pixels.
    colour, halo : str
        As ``"#rrggbb"``.

    Returns
    -------
    (h, w, 4) array of uint8
        Red, green, blue and opacity, from the top; the halo's `rim` on every side.
    """
    label, rim = laid(text, plain), rim_px(em)
    left, low, right, high = (side * em for side in label.box)
    under = max(2, round(UNDER_EM * em)) if underlined else 0
    width, height = math.ceil(right - left) + 2 * rim, math.ceil(high - low) + 2 * rim + under
    line = height - rim - under + math.floor(low)  # the row below which letters descend
    ink, around = np.zeros((2, height + 2, width + 2), dtype=np.uint8)
    for piece, is_tex, size, x in label.pieces:
        place = round((x * em - left) * _PARTS)
        letters, halos, to_right, up = _tile(piece, is_tex, size * em, HALO_EM * em, place % _PARTS)
        top, first = line - up, place // _PARTS + rim + to_right
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
def _tile(
    piece: str, is_tex: bool, em: float, halo_px: float, shift: int
) -> tuple[Pixels, Pixels, int, int]:
    """Draw a piece that begins `shift` parts of a pixel to the right of a whole one.

    Returns the coverage of the letters and of their halo, from the top, how far its first column
    is from that pixel, and its first row above the line.
    """
    from matplotlib.backends.backend_agg import RendererAgg
    from matplotlib.path import Path
    from matplotlib.transforms import Affine2D

    drawn = piece_of(piece, is_tex)
    if not len(drawn.vertices):
        empty = np.zeros((0, 0), dtype=np.uint8)
        return empty, empty, 0, 0
    left, low, right, high = (side * em for side in drawn.box)
    rim, part = math.ceil(halo_px) + 1, shift / _PARTS
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
        pen.set_foreground("white")
        pen.set_linewidth(pen_px)
        renderer.draw_path(pen, path, placed, (1.0, 1.0, 1.0))
        coverages.append(np.array(renderer.buffer_rgba())[..., 3])
    letters, halo = coverages
    return letters, halo, first, height + below


def rim_px(em: float) -> int:
    """The width of a label's halo in whole pixels."""
    return math.ceil(HALO_EM * em)


def size_px(text: str, em: float, plain: bool = False) -> tuple[int, int]:
    """Return the width and the height of a label's letters, without its halo."""
    left, low, right, high = laid(text, plain).box
    return math.ceil((right - left) * em), math.ceil((high - low) * em)


class LabelText(NamedTuple):
    """A label as text: its pieces as of `LabelLayout`, and where its line of writing begins.

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
    anchor: int = 0
    """The part that keeps its place in another font: -1 left end, 0 middle, 1 right end."""


class LabelActor(vtkTexturedActor2D):
    """The actor of a label, by which a window's labels are found."""

    label: weakref.ref[SceneLabel]


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
    ) -> None:
        self.em = style.font_size
        self._style, self._anchor, self._plain = style, anchor, plain
        self._visible = self._shown = True
        self._underlined = False
        self._opacity = self._light = 1.0
        self._place = 0.0, 0.0, 0.0
        self._text, self._tone = text, style.tone(colour)
        self.size_px = size_px(text, self.em, plain)
        """Width and height of the letters, without the halo."""
        self._drawn: tuple[str, str, bool] | None = None
        self._size = (0, 0)
        self._image, self._texture = vtkImageData(), vtkTexture()
        self._texture.SetInputData(self._image)
        self._texture.SetColorModeToDirectScalars()
        self._corners = vtkPoints()
        self._corners.SetNumberOfPoints(4)
        quad, cells = vtkPolyData(), vtkCellArray()
        cells.InsertNextCell(4, (0, 1, 2, 3))
        quad.SetPoints(self._corners)
        quad.SetPolys(cells)
        on_image = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], dtype=np.float32)
        quad.GetPointData().SetTCoords(numpy_to_vtk(on_image, deep=1))  # type: ignore[no-untyped-call]
        mapper = vtkPolyDataMapper2D()
        mapper.SetInputData(quad)
        self.actor = LabelActor()
        self.actor.label = weakref.ref(self)
        self.actor.SetMapper(mapper)
        self.actor.SetTexture(self._texture)
        self._show()

    @property
    def text(self) -> str:
        return self._text

    @property
    def is_visible(self) -> bool:
        """The last value of `set_visible`."""
        return self._visible

    def set_text(self, text: str) -> None:
        """Write another text; the same one costs nothing."""
        if text != self._text:
            self._text = text
            self.size_px = size_px(text, self.em, self._plain)
            self._show()

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
        self._set("_visible", visible)

    def set_shown(self, shown: bool) -> None:
        """Switch the label off, whatever `set_visible` says, or on again."""
        self._set("_shown", shown)

    def set_underlined(self, underlined: bool) -> None:
        """Underline the label while what it names is highlighted."""
        self._set("_underlined", underlined)

    def _set(self, name: str, value: object) -> None:
        if getattr(self, name) != value:
            setattr(self, name, value)
            self._show()

    def _show(self) -> None:
        seen = self._visible and self._shown and bool(self._text)
        self.actor.SetVisibility(seen)
        if not seen:
            return
        wanted = self._text, self._tone, self._underlined
        if wanted != self._drawn:
            self._drawn = wanted
            halo = self._style.background
            pixels = drawn(self._text, self.em, self._tone, halo, self._underlined, self._plain)
            height, width = pixels.shape[:2]
            self._size = width, height
            rows = np.ascontiguousarray(pixels[::-1]).reshape(-1, 4)
            self._image.SetDimensions(width, height, 1)
            self._image.GetPointData().SetScalars(numpy_to_vtk(rows, deep=1))  # type: ignore[no-untyped-call]
        (x, y, turn), (width, height) = self._place, self._size
        self._texture.SetInterpolate(bool(turn))
        (wide, high), rim, (to_right, to_top) = self.size_px, rim_px(self.em), self._anchor
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
        label = laid(self._text, self._plain)
        left, low, _, _ = label.box
        (x, y, turn), (to_right, to_top) = self._place, self._anchor
        (wide, high), (cos, sin) = self.size_px, (math.cos(turn), math.sin(turn))
        along = -(to_right + 1) / 2.0 * wide - left * self.em
        up = -(to_top + 1) / 2.0 * high - low * self.em
        place = x + cos * along - sin * up, y + sin * along + cos * up
        widths = tuple(piece_of(piece, is_tex).width for piece, is_tex, *_ in label.pieces)
        return LabelText(
            self._text, label.pieces, widths, place, turn, self.em, self._tone,
            self._style.background, self._opacity * self._light, self._underlined, to_right,
        )  # fmt: skip

    @property
    def box_px(self) -> tuple[float, float, float, float]:
        """Left, right, bottom and top of the letters, from the renderer's left and bottom."""
        (x, y, turn), (wide, high), (to_right, to_top) = self._place, self.size_px, self._anchor
        cos, sin = abs(math.cos(turn)), abs(math.sin(turn))
        wide, high = cos * wide + sin * high, sin * wide + cos * high  # type: ignore[assignment]
        left, low = x - (to_right + 1) / 2.0 * wide, y - (to_top + 1) / 2.0 * high
        return left, left + wide, low, low + high

    def covers(self, x_px: float, y_px: float) -> bool:
        """Return whether the label is visible at a pixel from the renderer's left and bottom."""
        left, right, bottom, top = self.box_px
        inside = left <= x_px <= right and bottom <= y_px <= top
        return inside and bool(self.actor.GetVisibility())


@cache
def _signs(font: str) -> frozenset[str]:
    """The characters that a font can show."""
    from matplotlib.font_manager import get_font

    return frozenset(map(chr, get_font(font_file(font)).get_charmap()))


@cache
def font_file(name: str) -> str:
    """Return the path of a font that comes with matplotlib, a dependency of pyvista.

    VTK's built-in font has no Cyrillic, and a system font would make figures differ between
    machines.
    """
    spec = importlib.util.find_spec("matplotlib")
    if spec is None or not spec.submodule_search_locations:
        raise ImportError("matplotlib, which brings the labels' fonts, is not installed")
    folder = pathlib.Path(spec.submodule_search_locations[0]) / "mpl-data" / "fonts" / "ttf"
    return str(folder / f"{name}.ttf")
