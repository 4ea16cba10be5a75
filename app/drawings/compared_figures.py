"""Pictures that are compared in a pane: beside each other, or divided, with their differences."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise, starmap
from typing import NamedTuple, TypeVar

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from app.document.compare import DifferenceWriter, in_words, names_in
from app.document.document import Document
from app.document.field_names import FIELDS
from app.document.settings import name_of, pictured
from app.drawings.label import SceneLabel
from app.drawings.off_screen import Pixels
from app.drawings.one_pane import illustration_of
from app.drawings.side_by_side import BARE_EM, places_of
from app.drawings.style import Style, rgb
from app.drawings.vectors import Area, LineShape, Shape, TextShape, moved, within
from app.lecture.typesetting import font_file
from app.model.projection import Array, Projection
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.readout import figure
from app.scenes.scene import Scene

LINE_EM = 1.5
_MOST_WORDS = 0.25  # of a figure's height, for the differences in words


class Compared(NamedTuple):
    """How a pane shows several pictures: each with its projection, illustration and name."""

    pane: str
    shown: list[tuple[Projection, Illustration | None, str]]
    places: list[tuple[int, int, int, int]]
    """Left, top, width and height of each, if they are side by side."""
    dividers: tuple[float, ...]
    live: int
    size: tuple[int, int]
    """Without the lines of words below."""
    framed: bool
    lines: list[str]


def compared_in(
    pane: str,
    document: Document,
    scene: Scene,
    size: tuple[int, int],
    framed: bool,
    style: Style,
    words: Mapping[str, str],
) -> Compared:
    pictures, dividers = document.view.compare, document.view.dividers
    phenomenon = scene.phenomenon
    settings = () if phenomenon is None else phenomenon.settings
    written = DifferenceWriter(
        lambda name: words.get(FIELDS.get(name, name), FIELDS.get(name, name)),
        lambda text: words.get(text, text),
        figure,
    )
    given = [name_of(document, picture) for picture in pictures]
    states = [pictured(document, picture).state for picture in pictures]
    names = names_in([words.get(name, name) for name in given], states, settings, written)
    shown = [
        (of.projection, illustration_of(scene, of.projection, of.settings), name)
        for name, of in zip(names, states, strict=True)
    ]
    aspects = [projection.aspect for projection, _, _ in shown]
    is_divided = bool(dividers) and len(set(aspects)) == 1 and pane == "image"
    # A divided picture without a frame has no names.
    lines = list[str]()
    if framed or not is_divided:
        differing = in_words(pictures, states, settings, written)
        lines = _lines_of(", ".join(differing), size, style)
    width, height = size[0], size[1] - _line_px(style) * len(lines)
    places = [] if is_divided else places_of(pane, width, height, aspects, style.font_size)
    live = next((place for place, picture in enumerate(pictures) if picture.live), 0)
    return Compared(
        pane, shown, [*places], dividers if is_divided else (), live, (width, height), framed, lines
    )


def compared_pixels(
    compared: Compared, draw: Callable[..., tuple[Pixels, tuple[float, float]]], style: Style
) -> Pixels:
    """The document's picture and those it is compared with, divided or side by side.

    `draw` returns a pane's pixels, and where its picture begins and ends in them.
    """
    (width, height), shown = compared.size, compared.shown
    ink = _in_words(compared.lines, width, style)
    if not compared.dividers:
        drawn = [
            draw(*each, (wide, high), framed=True, caption=name, bare=True)[0]
            for (*each, name), (_, _, wide, high) in zip(shown, compared.places, strict=True)
        ]
        if compared.pane == "world":
            named = zip(drawn, shown, strict=True)
            drawn = [_titled(part, name, style) for part, (_, _, name) in named]
        whole = np.empty((height, width, drawn[0].shape[2]), np.uint8)
        whole[:] = drawn[0][0, 0]  # beside the pictures
        for part, (left, top, wide, high) in zip(drawn, compared.places, strict=True):
            whole[top : top + high, left : left + wide] = part
        return _with_words(whole, ink, style)
    layers = _layers(compared, draw)
    edges = _edges(compared, layers[compared.live][1])
    whole = layers[0][0].copy()
    for (pixels, _), strip in zip(layers, starmap(slice, pairwise(edges)), strict=True):
        whole[:, strip] = pixels[:, strip]
    half = max(1, round(style.line_width / 2.0))
    for x in edges[1:-1]:
        whole[:, max(0, x - half) : x + half, :3] = np.array(rgb(style.ink)) * 255.0
        whole[:, max(0, x - half) : x + half, 3:] = 255
    return _with_words(whole, ink, style)


_Drawn = TypeVar("_Drawn")


def _layers(
    compared: Compared, draw: Callable[..., tuple[_Drawn, tuple[float, float]]]
) -> list[tuple[_Drawn, tuple[float, float]]]:
    """The whole pictures of which a divided one shows strips."""
    middles = [sum(ends) / 2.0 for ends in pairwise((0.0, *compared.dividers, 1.0))]
    return [
        draw(*each, compared.size, framed=compared.framed, caption=name, middle=middle)
        for (*each, name), middle in zip(compared.shown, middles, strict=True)
    ]


def _edges(compared: Compared, ends: tuple[float, float]) -> list[int]:
    begin, end = ends
    inner = (round(begin + part * (end - begin)) for part in compared.dividers)
    return [0, *inner, compared.size[0]]


def compared_shapes(
    compared: Compared,
    draw: Callable[..., tuple[list[Shape], tuple[float, float]]],
    style: Style,
) -> list[Shape]:
    (width, height), drawn = compared.size, list[Shape]()
    line_px = _line_px(style)
    if compared.dividers:
        layers = _layers(compared, draw)
        edges = _edges(compared, layers[compared.live][1])
        for (part, _), (left, right) in zip(layers, pairwise(edges), strict=True):
            drawn += within(part, left, right)
        for x in edges[1:-1]:
            ends = [(float(x), 0.0), (float(x), float(height))]
            drawn.append(LineShape(ends, rgb(style.ink), 1.0, style.line_width))
    for (*each, name), (left, top, wide, high) in zip(
        compared.shown, compared.places, strict=False
    ):
        part = draw(*each, (wide, high), framed=True, caption=name, bare=True)[0]
        if compared.pane == "world":
            part.append(_line_of_text(name, wide / 2.0, line_px / 2.0, style))
        drawn += (moved(shape, left, top) for shape in part)
    ground = next((each for each in drawn if isinstance(each, Area)), None)
    if ground is not None and ground.colour == rgb(style.background):  # beside the pictures
        low = height + line_px * len(compared.lines)
        corners = [(0.0, 0.0), (float(width), 0.0), (float(width), low), (0.0, low)]
        drawn.insert(0, ground._replace(rings=[corners]))
    for number, text in enumerate(compared.lines):
        drawn.append(_line_of_text(text, width / 2.0, height + (number + 0.5) * line_px, style))
    return drawn


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
    ink: Array = np.asarray(band, dtype=np.float64).reshape(-1, width) / 255.0
    return ink
