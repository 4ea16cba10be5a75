"""Pictures that are compared in a pane: beside each other, or divided, with their differences."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, starmap

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from app.document.compare import DifferenceWriter, in_words, names_in
from app.document.settings import name_of, pictured
from app.drawings.drawing import Drawing
from app.drawings.label import SceneLabel
from app.drawings.off_screen import Pixels
from app.drawings.one_pane import Ends, PanePicture
from app.drawings.side_by_side import BARE_EM, places_of
from app.drawings.style import Style, rgb
from app.drawings.vectors import Area, LineShape, Shape, TextShape, moved, within
from app.lecture.typesetting import font_file
from app.model.parameters import TITLES
from app.model.projection import Array
from app.scenes.phenomena.words import figure
from app.scenes.scene import Scene

LINE_EM = 1.5
_MOST_WORDS = 0.25  # of a figure's height, for the differences in words


@dataclass(frozen=True, eq=False)
class Compared:
    """Several pictures that a pane shows: side by side, or as strips of one picture."""

    pictures: list[PanePicture]  # each has its name as its caption
    places: list[tuple[int, int, int, int]]
    """Left, top, width and height of each, if they are side by side."""
    dividers: tuple[float, ...]
    live: int
    size: tuple[int, int]  # without the lines of words below
    lines: list[str]

    @property
    def _style(self) -> Style:
        return self.pictures[0].style

    @property
    def _is_titled(self) -> bool:
        """Whether the names are written here; images write theirs themselves."""
        return self.pictures[0].pane == "world"

    def _edges(self, ends: Ends) -> list[int]:
        """Return where the strips of a divided picture begin and end."""
        begin, end = ends
        inner = (round(begin + part * (end - begin)) for part in self.dividers)
        return [0, *inner, self.size[0]]

    def pixels(self, seen: Callable[[Drawing, int], object] | None = None) -> Pixels:
        (width, height), style = self.size, self._style
        ink = _in_words(self.lines, width, style)
        drawn = [picture.pixels_and_ends(seen) for picture in self.pictures]
        if not self.dividers:
            parts = [pixels for pixels, _ in drawn]
            if self._is_titled:
                named = zip(parts, self.pictures, strict=True)
                parts = [_titled(part, picture.caption, style) for part, picture in named]
            whole = np.empty((height, width, parts[0].shape[2]), np.uint8)
            whole[:] = parts[0][0, 0]  # beside the pictures
            for part, (left, top, wide, high) in zip(parts, self.places, strict=True):
                whole[top : top + high, left : left + wide] = part
            return _with_words(whole, ink, style)
        edges = self._edges(drawn[self.live][1])
        whole = drawn[0][0].copy()
        for (pixels, _), strip in zip(drawn, starmap(slice, pairwise(edges)), strict=True):
            whole[:, strip] = pixels[:, strip]
        half = max(1, round(style.line_width / 2.0))
        for x in edges[1:-1]:
            whole[:, max(0, x - half) : x + half, :3] = np.array(rgb(style.ink)) * 255.0
            whole[:, max(0, x - half) : x + half, 3:] = 255
        return _with_words(whole, ink, style)

    def shapes(self, hidden: str, watch: Callable[[], None]) -> list[Shape]:
        (width, height), style, shapes = self.size, self._style, list[Shape]()
        line_px = _line_px(style)
        drawn = [picture.shapes_and_ends(hidden, watch) for picture in self.pictures]
        if self.dividers:
            edges = self._edges(drawn[self.live][1])
            for (part, _), (left, right) in zip(drawn, pairwise(edges), strict=True):
                shapes += within(part, left, right)
            for x in edges[1:-1]:
                ends = [(float(x), 0.0), (float(x), float(height))]
                shapes.append(LineShape(ends, rgb(style.ink), 1.0, style.line_width))
        for (part, _), picture, (left, top, wide, _) in zip(
            drawn, self.pictures, self.places, strict=False
        ):
            if self._is_titled:
                part.append(_line_of_text(picture.caption, wide / 2.0, line_px / 2.0, style))
            shapes += (moved(shape, left, top) for shape in part)
        ground = next((each for each in shapes if isinstance(each, Area)), None)
        if ground is not None and ground.colour == rgb(style.background):  # beside the pictures
            low = height + line_px * len(self.lines)
            corners = [(0.0, 0.0), (float(width), 0.0), (float(width), low), (0.0, low)]
            shapes.insert(0, ground._replace(rings=[corners]))
        for number, text in enumerate(self.lines):
            y = height + (number + 0.5) * line_px
            shapes.append(_line_of_text(text, width / 2.0, y, style))
        return shapes


def compared_in(whole: PanePicture, scene: Scene) -> Compared:
    """Return the pictures that are compared in a pane, which is as large as `whole`.

    The scene is the document's own one.
    """
    document, style, words = whole.document, whole.style, whole.words
    pictures, dividers = document.view.compare, document.view.dividers
    settings = () if scene.phenomenon is None else scene.phenomenon.settings
    written = DifferenceWriter(
        lambda name: words.get(TITLES.get(name, name), TITLES.get(name, name)),
        lambda text: words.get(text, text),
        figure,
    )
    given = [name_of(document, picture) for picture in pictures]
    states = [pictured(document, picture).state for picture in pictures]
    names = names_in([words.get(name, name) for name in given], states, settings, written)
    aspects = [state.projection.aspect for state in states]
    is_divided = bool(dividers) and len(set(aspects)) == 1 and whole.pane == "image"
    # A divided picture without a frame has no names.
    lines = list[str]()
    if whole.framed or not is_divided:
        differing = in_words(pictures, states, settings, written)
        lines = _lines_of(", ".join(differing), whole.size, style)
    width, height = whole.size[0], whole.size[1] - _line_px(style) * len(lines)
    shown = [
        replace(
            whole,
            document=replace(document, projection=state.projection, settings=state.settings),
            illustration=scene.illustration(state.projection, state.settings),
            caption=name,
        )
        for name, state in zip(names, states, strict=True)
    ]
    live = next((place for place, picture in enumerate(pictures) if picture.live), 0)
    places = list[tuple[int, int, int, int]]()
    if is_divided:
        middles = [sum(ends) / 2.0 for ends in pairwise((0.0, *dividers, 1.0))]
        shown = [
            replace(picture, size=(width, height), middle=middle)
            for picture, middle in zip(shown, middles, strict=True)
        ]
    else:
        places = places_of(whole.pane, width, height, aspects, style.font_size)
        shown = [
            replace(picture, size=(wide, high), framed=True, bare=True)
            for picture, (_, _, wide, high) in zip(shown, places, strict=True)
        ]
    return Compared(shown, places, dividers if is_divided else (), live, (width, height), lines)


def _line_of_text(text: str, x: float, y: float, style: Style) -> TextShape:
    """A line of words round a point."""
    written = SceneLabel(text, style, plain=True).written
    left, low = written.place
    return TextShape(written, (x + left, y - low), written.em)


def _titled(pixels: Pixels, text: str, style: Style) -> Pixels:
    """A picture with its name at the top, where a pane has its title."""
    height, width, _ = pixels.shape
    ink = _in_words(_lines_of(text, (width, height), style), width, style)
    return np.concatenate([_inked(pixels[: len(ink)], ink, style), pixels[len(ink) :]])


def _with_words(pixels: Pixels, ink: Array, style: Style) -> Pixels:
    """A picture with a band of text below it, on the same background."""
    return np.concatenate([pixels, _inked(pixels[0, 0], ink, style)])


def _inked(pixels: Pixels, ink: Array, style: Style) -> Pixels:
    colour = np.array([*(255.0 * part for part in rgb(style.ink)), 255.0])[: pixels.shape[-1]]
    return np.round(pixels + ink[..., None] * (colour - pixels)).astype(np.uint8)


def _line_px(style: Style) -> int:
    return round(LINE_EM * style.font_size)


def _font(style: Style) -> ImageFont.FreeTypeFont:
    # Pillow's other layout needs a system library, so that figures would differ between machines.
    basic = ImageFont.Layout.BASIC
    return ImageFont.truetype(font_file("DejaVuSans"), style.font_size, layout_engine=basic)


def _lines_of(text: str, size: tuple[int, int], style: Style) -> list[str]:
    """Break a text into lines, at most a quarter of a height; the rest is dropped."""
    width, height = size
    font = _font(style)
    room = width - 2.0 * BARE_EM * style.font_size
    lines: list[str] = []
    for word in text.split():
        if lines and font.getlength(f"{lines[-1]} {word}") <= room:
            lines[-1] += f" {word}"
        else:
            lines.append(word)
    return lines[: int(_MOST_WORDS * height / _line_px(style))]


def _in_words(lines: Sequence[str], width: int, style: Style) -> Array:
    """Lines of text as ink from 0 to 1, (n, width)."""
    font = _font(style)
    line_px = _line_px(style)
    band = Image.new("L", (width, line_px * len(lines)))
    for place, line in enumerate(lines):
        middle = width / 2.0, (place + 0.5) * line_px
        ImageDraw.Draw(band).text(middle, line, fill=255, font=font, anchor="mm")
    return np.asarray(np.asarray(band, dtype=np.float64).reshape(-1, width) / 255.0)
