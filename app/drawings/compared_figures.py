"""Pictures that are compared in a pane: beside each other, or divided, with their differences."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise, starmap

import numpy as np

from app.document.compare import DifferenceWriter, names_in
from app.document.settings import name_of, pictured
from app.drawings.drawing import Drawing
from app.drawings.label import SceneLabel, rim_px
from app.drawings.label import drawn as drawn_label
from app.drawings.off_screen import Pixels
from app.drawings.one_pane import Ends, PanePicture
from app.drawings.side_by_side import line_px, places_of
from app.drawings.style import Style, rgb
from app.drawings.vectors import Area, LineShape, Shape, TextShape, moved, within
from app.lecture.typesetting import line_of
from app.model.parameters import TITLES
from app.scenes.phenomena.words import figure
from app.scenes.scene import Scene

_HALF_CAPITAL = 0.36  # half the height of a capital, in em


@dataclass(frozen=True, eq=False)
class Compared:
    """Several pictures that a pane shows: side by side, or as strips of one picture."""

    pictures: list[PanePicture]  # each has its name as its caption
    places: list[tuple[int, int, int, int]]  # left, top, width, height of each, if side by side
    dividers: tuple[float, ...]
    live: int
    size: tuple[int, int]

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
                parts = [titled(part, picture.caption, style) for part, picture in named]
            whole = np.empty((self.size[1], self.size[0], parts[0].shape[2]), np.uint8)
            whole[:] = parts[0][0, 0]  # beside the pictures
            for part, (left, top, wide, high) in zip(parts, self.places, strict=True):
                whole[top : top + high, left : left + wide] = part
            return whole
        edges = self._edges(drawn[self.live][1])
        whole = drawn[0][0].copy()
        for (pixels, _), strip in zip(drawn, starmap(slice, pairwise(edges)), strict=True):
            whole[:, strip] = pixels[:, strip]
        half = max(1, round(style.line_width / 2.0))
        for x in edges[1:-1]:
            divider = whole[:, max(0, x - half) : x + half]
            divider[..., :3] = np.array(rgb(style.ink)) * 255.0
            divider[..., 3:] = 255
        return whole

    def shapes(self, hidden: str, watch: Callable[[], None]) -> list[Shape]:
        (width, height), style, shapes = self.size, self._style, list[Shape]()
        line = line_px(style)
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
                part.append(line_of_text(picture.caption, wide / 2.0, line / 2.0, style))
            shapes += (moved(shape, left, top) for shape in part)
        ground = next((each for each in shapes if isinstance(each, Area)), None)
        if ground is not None and ground.colour == rgb(style.background):  # beside the pictures
            corners = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
            shapes.insert(0, ground._replace(rings=[corners]))
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
    width, height = whole.size
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
            replace(picture, middle=middle) for picture, middle in zip(shown, middles, strict=True)
        ]
    else:
        places = places_of(whole.pane, width, height, aspects, style.font_size)
        shown = [
            replace(picture, size=(wide, high), framed=True, bare=True)
            for picture, (_, _, wide, high) in zip(shown, places, strict=True)
        ]
    return Compared(shown, places, dividers if is_divided else (), live, whole.size)


def line_of_text(text: str, x: float, y: float, style: Style, anchor: int = 0) -> TextShape:
    """A name round a point, or a line of words and letters from there on to the right."""
    written = SceneLabel(text, style, plain=not anchor, anchor=(anchor, 0)).written
    place = x + written.place[0], y + _HALF_CAPITAL * written.em
    return TextShape(written, place, written.em)


def titled(pixels: Pixels, text: str, style: Style, *, centred: bool = True) -> Pixels:
    """A picture with a name at its top, where a pane has its title, or a line of words."""
    how = {"plain": centred, "one_size": style.one_size}
    name = drawn_label(text, style.font_size, style.tone(""), style.background, **how)
    above = line_of(text, **how).box[3] - _HALF_CAPITAL  # all names stand on one line
    top = max(0, round(line_px(style) / 2.0 - above * style.font_size) - rim_px(style.font_size))
    whole, name = pixels.copy(), name[: len(pixels) - top, : pixels.shape[1]]
    left = (pixels.shape[1] - name.shape[1]) // 2 if centred else round(style.font_size / 2.0)
    part = whole[top : top + len(name), left : left + name.shape[1]]
    part[:] = np.round(part + name[..., 3:] / 255.0 * (name[..., : part.shape[2]] - part * 1.0))
    part[..., 3:] = np.maximum(part[..., 3:], name[..., 3:])
    return whole
