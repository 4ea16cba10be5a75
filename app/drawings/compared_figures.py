"""Pictures that are compared in a pane: beside each other, or divided, with their differences."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, starmap

import numpy as np

from app.document.compare import DifferenceWriter, names_in
from app.document.settings import name_of, pictured
from app.drawings.drawing import Drawing
from app.drawings.label import SceneLabel
from app.drawings.label import drawn as drawn_label
from app.drawings.off_screen import Pixels
from app.drawings.one_pane import Ends, PanePicture
from app.drawings.side_by_side import BARE_EM, places_of, room_for
from app.drawings.style import Style, rgb
from app.drawings.vectors import Area, LineShape, Shape, TextShape, moved, within
from app.lecture.typesetting import line_of
from app.model.parameters import TITLES
from app.scenes.phenomena.words import figure
from app.scenes.scene import Scene

LINE_EM = 1.5
_MOST_WORDS = 0.25  # of a figure's height, for a caption


@dataclass(frozen=True, eq=False)
class Compared:
    """Several pictures that a pane shows: side by side, or as strips of one picture."""

    pictures: list[PanePicture]  # each has its name as its caption
    places: list[tuple[int, int, int, int]]
    """Left, top, width and height of each, if they are side by side."""
    dividers: tuple[float, ...]
    live: int
    size: tuple[int, int]
    low: int  # where the pictures end, and the caption begins
    lines: list[str]
    """Of the caption."""

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
        style = self._style
        drawn = [picture.pixels_and_ends(seen) for picture in self.pictures]
        if not self.dividers:
            parts = [pixels for pixels, _ in drawn]
            if self._is_titled:
                named = zip(parts, self.pictures, strict=True)
                parts = [_titled(part, picture.caption, style) for part, picture in named]
            whole = self._empty(parts[0])
            for part, (left, top, wide, high) in zip(parts, self.places, strict=True):
                whole[top : top + high, left : left + wide] = part
            return self._with_caption(whole)
        edges = self._edges(drawn[self.live][1])
        whole = self._empty(drawn[0][0])
        for (pixels, _), strip in zip(drawn, starmap(slice, pairwise(edges)), strict=True):
            whole[: self.low, strip] = pixels[:, strip]
        half = max(1, round(style.line_width / 2.0))
        for x in edges[1:-1]:
            divider = whole[: self.low, max(0, x - half) : x + half]
            divider[..., :3] = np.array(rgb(style.ink)) * 255.0
            divider[..., 3:] = 255
        return self._with_caption(whole)

    def _empty(self, part: Pixels) -> Pixels:
        """As much of a picture's background as all is large."""
        whole = np.empty((self.size[1], self.size[0], part.shape[2]), np.uint8)
        whole[:] = part[0, 0]
        return whole

    def _with_caption(self, whole: Pixels) -> Pixels:
        _write(whole[self.low :], self.lines, self._style)
        return whole

    def shapes(self, hidden: str, watch: Callable[[], None]) -> list[Shape]:
        (width, height), style, shapes = self.size, self._style, list[Shape]()
        line_px = _line_px(style)
        drawn = [picture.shapes_and_ends(hidden, watch) for picture in self.pictures]
        if self.dividers:
            edges = self._edges(drawn[self.live][1])
            for (part, _), (left, right) in zip(drawn, pairwise(edges), strict=True):
                shapes += within(part, left, right)
            for x in edges[1:-1]:
                ends = [(float(x), 0.0), (float(x), float(self.low))]
                shapes.append(LineShape(ends, rgb(style.ink), 1.0, style.line_width))
        for (part, _), picture, (left, top, wide, _) in zip(
            drawn, self.pictures, self.places, strict=False
        ):
            if self._is_titled:
                part.append(_line_of_text(picture.caption, wide / 2.0, line_px / 2.0, style))
            shapes += (moved(shape, left, top) for shape in part)
        ground = next((each for each in shapes if isinstance(each, Area)), None)
        if ground is not None and ground.colour == rgb(style.background):  # beside the pictures
            corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
            shapes.insert(0, ground._replace(rings=[corners]))
        for number, text in enumerate(self.lines):
            y = self.low + (number + 0.5) * line_px
            shapes.append(_line_of_text(text, width / 2.0, y, style))
        return shapes


def compared_in(whole: PanePicture, scene: Scene, caption: str = "") -> Compared:
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
    lines = _lines_of(caption, whole.size, style)
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
        if whole.pane == "image":
            places, height = room_for(places, aspects, style.font_size)
        shown = [
            replace(picture, size=(wide, high), framed=True, bare=True)
            for picture, (_, _, wide, high) in zip(shown, places, strict=True)
        ]
    return Compared(shown, places, dividers if is_divided else (), live, whole.size, height, lines)


def _line_of_text(text: str, x: float, y: float, style: Style) -> TextShape:
    """A line of words round a point."""
    written = SceneLabel(text, style, plain=True).written
    left, low = written.place
    return TextShape(written, (x + left, y - low), written.em)


def _titled(pixels: Pixels, text: str, style: Style) -> Pixels:
    """A picture with its name at the top, where a pane has its title."""
    lines = _lines_of(text, (pixels.shape[1], pixels.shape[0]), style)
    titled = pixels.copy()
    _write(titled[: _line_px(style) * len(lines)], lines, style)
    return titled


def _line_px(style: Style) -> int:
    return round(LINE_EM * style.font_size)


def _lines_of(text: str, size: tuple[int, int], style: Style) -> list[str]:
    """Break a text into lines, at most a quarter of a height; the rest is dropped."""
    room = size[0] / style.font_size - 2.0 * BARE_EM
    lines: list[str] = []
    for word in text.split():
        if lines and line_of(f"{lines[-1]} {word}", True).width <= room:
            lines[-1] += f" {word}"
        else:
            lines.append(word)
    return lines[: int(_MOST_WORDS * size[1] / _line_px(style))]


def _write(band: Pixels, lines: Sequence[str], style: Style) -> None:
    """Write lines of words into the middle of a picture's rows."""
    for place, text in enumerate(lines):
        ink = drawn_label(text, style.font_size, style.tone(""), style.background, plain=True)
        ink = ink[:, : band.shape[1]]
        top = round((place + 0.5) * _line_px(style) - ink.shape[0] / 2.0)
        left = (band.shape[1] - ink.shape[1]) // 2
        ink = ink[max(0, -top) : len(band) - top]
        part = band[max(0, top) :][: len(ink), left : left + ink.shape[1]]
        opacity = ink[..., 3:] / 255.0
        part[:] = np.round(part + opacity * (ink[..., : part.shape[2]] - part.astype(float)))
        part[..., 3:] = np.maximum(part[..., 3:], ink[..., 3:])
