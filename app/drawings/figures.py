"""Off-screen pictures of the panes, for papers and slides, without a window or a display.

The panes' own drawings draw a figure in a window of its own, which makes it independent of a
screen's size and scale. It is drawn several times as large as asked for and averaged: every driver
does that alike, while multisampling differs from driver to driver.
"""

from __future__ import annotations

import io
import math
import os
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from itertools import pairwise, starmap
from typing import Any, NamedTuple, TypeVar

import numpy as np
from PIL import Image, ImageDraw, ImageFont, PngImagePlugin

from app.document.codec import FORMAT
from app.document.compare import Written, in_words, names_in
from app.document.document import Document
from app.document.field_names import FIELDS
from app.document.files import write_bytes_atomically
from app.document.lengths import DPI, PX_PER, Size, whole_pixels
from app.document.naming import named_in, seen_from
from app.document.settings import name_of, pictured
from app.document.view import AS_EVER, PANES, View
from app.drawings import AXES, WORDS, Words
from app.drawings.describing import Description
from app.drawings.drawing import Drawing
from app.drawings.image import ImageDrawing
from app.drawings.label import Label, font_file
from app.drawings.off_screen import Pixels, off_screen, pixels_of
from app.drawings.pdf import pdf
from app.drawings.shades import printed
from app.drawings.side_by_side import BARE_EM, panes_in, places_of
from app.drawings.stage import StageDrawing
from app.drawings.style import LIGHT, Style, mixed, rgb
from app.drawings.svg import svg
from app.drawings.vectors import (
    TOO_MANY,
    Area,
    Shape,
    Stroke,
    Text,
    box_of,
    moved,
    shapes_of,
    within,
)
from app.drawings.world import WorldDrawing
from app.model.projection import LARGEST_IMAGE_PX, Array, Projection
from app.model.refusal import QT_TRANSLATE_NOOP, Cancelled, Refusal, format_value
from app.precision.levels import DRAWING_TOLERANCE_PX
from app.precision.quality import AUTOMATIC, Quality
from app.scenes.fewer_triangles import reduced
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.readout import figure
from app.scenes.scene import Scene

LARGEST_PX = LARGEST_IMAGE_PX
"""Largest side of a figure."""
PANE_PX = 640
"""Default side of a pane."""
SMALLEST_PANE_PX = 32
"""Smallest side of a pane with labels."""
USUAL_TEXT = 25 / PANE_PX
"""Of the shorter side of a pane: the height of an em where nobody asks for another. In three panes
of `PANE_PX`, across a page, that is 6 points, which can be read there and on a slide (13 pixels, as
in the window, would be 3); other figures look alike."""
CROP_PX = 2.0 * PX_PER["mm"]
"""Margin of a figure that is cropped."""
_LEAST_TEXT_PX, _LARGEST_TEXT = 1.0, 0.25  # the latter relative to the shorter side

_DRAWINGS: dict[str, type[WorldDrawing] | type[StageDrawing] | type[ImageDrawing]] = {
    "world": WorldDrawing,
    "ndc": StageDrawing,
    "image": ImageDrawing,
}
_LARGEST_DRAWN_PX = 8192  # largest side before averaging; every driver can draw it
_MOST_DRAWN_PX = 40_000_000  # of one pane before averaging: about 0.5 GB with depth and copies

NO_PANES = QT_TRANSLATE_NOOP("Refusal", "panes = {0}: must name at least one of {1}.")
UNKNOWN_PANE = QT_TRANSLATE_NOOP("Refusal", "pane = {0}: must be one of {1}.")
SCALE = QT_TRANSLATE_NOOP("Refusal", "scale = {0}: must be greater than 0 and at most {1}.")
WIDTH = QT_TRANSLATE_NOOP(
    "Refusal", "width = {0}: must be a whole number of pixels from {1} to {2}."
)
HEIGHT = QT_TRANSLATE_NOOP(
    "Refusal", "height = {0}: must be a whole number of pixels from {1} to {2}."
)
SCALED_WIDTH = QT_TRANSLATE_NOOP(
    "Refusal", "width = {0} times scale {3}: must be from {1} to {2} pixels."
)
SCALED_HEIGHT = QT_TRANSLATE_NOOP(
    "Refusal", "height = {0} times scale {3}: must be from {1} to {2} pixels."
)
LENGTH_WIDE = QT_TRANSLATE_NOOP("Refusal", "width = {0} {3}: must be from {1} to {2} {3}.")
LENGTH_HIGH = QT_TRANSLATE_NOOP("Refusal", "height = {0} {3}: must be from {1} to {2} {3}.")
TEXT = QT_TRANSLATE_NOOP(
    "Refusal", "text size = {0}: must be from {1} to {2} points in panes of this size."
)
TOO_MANY_FOR = QT_TRANSLATE_NOOP(
    "Refusal",
    "has {0} faces and lines in a pane; the limit of a figure without pixels is {1}: write {2}",
)
LINE_EM = 1.5
_TOLD_S, _SLOWING_S = 0.05, 5.0
_GREY = 0.55  # of the background in the colour of hidden lines
_MOST_WORDS = 0.25  # of a figure's height, for the differences in words
_SIDES = (WIDTH, SCALED_WIDTH, LENGTH_WIDE), (HEIGHT, SCALED_HEIGHT, LENGTH_HIGH)


def render(
    scene: Scene,
    projection: Projection,
    panes: Sequence[str] = PANES,
    size: Size | tuple[int, int] | None = None,
    scale: float = 1.0,
    transparent: bool = False,
    style: Style = LIGHT,
    words: Mapping[str, str] = WORDS,
    view: View = AS_EVER,
    progress: Callable[[float], bool] | None = None,
    settings: Mapping[str, Any] | None = None,
    quality: Quality = AUTOMATIC,
    text_pt: float | None = None,
    seen: Callable[[Drawing, int], object] | None = None,
    column: bool = False,
    crop: bool = False,
) -> Pixels:
    """Draw one pane, or several side by side, and return (height, width, 3 or 4) uint8 pixels.

    The first row is the top one; colours are not multiplied by alpha.

    Parameters
    ----------
    panes : sequence of {"world", "ndc", "image"}
        From left to right, as wide as `panes_in` says. The image alone is drawn without its frame.
    size : Size or (int, int), optional
        By default `PANE_PX` squares, or the image's own size for the image alone.
    scale : float, optional
        Multiplies the size with all lines and letters: the same figure, finer.
    words : mapping, optional
        The words in the drawings; by default English with the view's letters.
    progress : callable, optional
        Called before each pane with the fraction done; drawing stops when it returns False.
    settings : mapping, optional
        Of the scene's phenomenon, by name; the others have their defaults.
    quality : Quality, optional
        Its smoothing does not matter: a figure is always averaged.
    text_pt : float, optional
        Height of an em in points, of which 72 are `DPI` pixels; by default `USUAL_TEXT`.
    seen : callable, optional
        Called with the drawing of each pane and how many of its pixels are one of the figure's.
    column : bool, optional
        Draw the panes below each other.
    crop : bool, optional
        Leave out what is empty around the content, but for a margin of `CROP_PX`.

    Raises
    ------
    Refusal
        For an unknown pane, a size, a scale or a setting that is not possible.
    Cancelled
        When `progress` returned False.

    Notes
    -----
    Beside live Qt panes, release Qt's current OpenGL context first (``doneCurrent``). Otherwise VTK
    may use Qt's context for its own.
    """
    places = _places(projection, panes, size, scale, column, view)
    style = _styled(style, projection, panes, size, text_pt, column).enlarged(scale)
    if words is WORDS:
        words = Words(view.letters)
    illustration = _illustration(scene, projection, settings)
    scene = printed(reduced(scene, quality.detail), style)
    parts: list[Pixels] = []
    for pane, (_, _, *sides) in zip(panes, places, strict=True):
        if progress is not None and not progress(len(parts) / len(panes)):
            raise Cancelled
        draw = partial(
            _render_pane,
            pane,
            scene,
            transparent=transparent,
            style=style,
            words=words,
            view=view,
            quality=quality,
            seen=seen,
        )
        size_px, framed = (sides[0], sides[1]), len(panes) > 1
        if pane == view.compares_in and view.compare:
            document = Document(scene.name, projection, view=view, settings=settings or {})
            compared = _compared_in(pane, document, scene, size_px, framed, style, words)
            parts.append(_compared(compared, draw, style))
        else:
            parts.append(draw(projection, illustration, size_px, framed=framed)[0])
    whole = parts[0] if len(parts) == 1 else np.concatenate(parts, axis=0 if column else 1)
    return _cropped(whole, style, round(CROP_PX * scale)) if crop else whole


def _places(
    projection: Projection,
    panes: Sequence[str],
    size: Size | tuple[int, int] | None,
    scale: float,
    column: bool,
    view: View,
) -> list[tuple[int, int, int, int]]:
    size_px = checked_size(projection.image_size, panes, size, scale, column)
    # Beside an image several worlds that are compared would be small.
    aspect = None if view.compare else projection.aspect
    return panes_in(size_px, [aspect if p == "image" else None for p in panes], column)


def _cropped(whole: Pixels, style: Style, margin: int) -> Pixels:
    """The part of a picture that is not empty, and a margin of it."""
    empty = np.round(255.0 * np.array(rgb(style.background)))
    ink = whole[..., 3] > 0 if whole.shape[2] > 3 else (whole != empty).any(axis=2)
    sides = []
    for axis in (1, 0):
        found = np.flatnonzero(ink.any(axis=axis))
        if not len(found):
            return whole
        sides.append(slice(max(0, int(found[0]) - margin), int(found[-1]) + 1 + margin))
    return np.ascontiguousarray(whole[sides[0], sides[1]])


def _styled(
    style: Style,
    projection: Projection,
    panes: Sequence[str],
    size: Size | tuple[int, int] | None,
    text_pt: float | None,
    column: bool,
) -> Style:
    text_pt = checked_text(projection.image_size, panes, size, text_pt, column)
    return replace(style, margin=style.background, font_size=text_pt * DPI / 72.0)


def _illustration(
    scene: Scene, projection: Projection, settings: Mapping[str, Any] | None
) -> Illustration | None:
    if scene.phenomenon is None:
        return None
    chosen = scene.phenomenon.checked(settings or {})
    return scene.phenomenon.illustration(projection, chosen, scene.subject)


def shapes(
    scene: Scene,
    projection: Projection,
    panes: Sequence[str] = PANES,
    size: Size | tuple[int, int] | None = None,
    transparent: bool = False,
    style: Style = LIGHT,
    words: Mapping[str, str] = WORDS,
    view: View = AS_EVER,
    progress: Callable[[float], bool] | None = None,
    settings: Mapping[str, Any] | None = None,
    quality: Quality = AUTOMATIC,
    text_pt: float | None = None,
    column: bool = False,
    crop: bool = False,
    hidden: str = "none",
) -> tuple[tuple[float, float], list[Shape]]:
    """Return a figure's size in pixels and its shapes, from the back to the front.

    The size is exactly the one asked for; what lies beyond is for the writer to cut off.

    The parameters are those of `render`, and one of `HIDDEN`. A `Refusal` also for too many shapes.
    """
    places = _places(projection, panes, size, 1.0, column, view)
    style = _styled(style, projection, panes, size, text_pt, column)
    if words is WORDS:
        words = Words(view.letters)
    illustration = _illustration(scene, projection, settings)
    scene = printed(reduced(scene, quality.detail), style)
    draw = partial(
        _shapes_of_pane, scene=scene, transparent=transparent, style=style, words=words, view=view,
        quality=quality, hidden=hidden,
    )  # fmt: skip
    found: list[Shape] = []
    for number, (pane, (left, top, *sides)) in enumerate(zip(panes, places, strict=True)):
        draw = partial(draw, watch=_watched(progress, number, len(panes)))
        size_px, framed = (sides[0], sides[1]), len(panes) > 1
        if pane == view.compares_in and view.compare:
            document = Document(scene.name, projection, view=view, settings=settings or {})
            compared = _compared_in(pane, document, scene, size_px, framed, style, words)
            part = _compared_shapes(compared, partial(draw, pane), style)
        else:
            part = draw(pane, projection, illustration, size_px, framed=framed)[0]
        found += (moved(shape, left, top) for shape in part)
    width, height = Size(*(size or _own_size(projection.image_size, panes, column))).px
    box = box_of(found, style.background) if crop else None
    if box is not None:
        x, y = (max(0.0, side - CROP_PX) for side in box[:2])
        width, height = min(width, box[2] + CROP_PX) - x, min(height, box[3] + CROP_PX) - y
        found = [moved(shape, -x, -y) for shape in found]
    if not transparent:  # or a seam would show between panes on a page of another colour
        page = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
        found.insert(0, Area([page], rgb(style.background), 1.0))
    return (width, height), found


def _watched(progress: Callable[[float], bool] | None, number: int, of: int) -> Callable[[], None]:
    """Return what tells the progress in a pane, whose end nobody knows, every twentieth second."""
    begin = told = time.monotonic()

    def watch() -> None:
        nonlocal told
        now = time.monotonic()
        if progress is not None and now - told > _TOLD_S:
            told = now
            part = 1.0 - math.exp((begin - now) / _SLOWING_S)
            if not progress((number + part) / of):
                raise Cancelled

    if progress is not None and not progress(number / of):
        raise Cancelled
    return watch


def write_shapes(
    path: str,
    scene: Scene,
    projection: Projection,
    about: Description | None = None,
    **options: Any,
) -> None:
    """Write a figure as SVG or PDF, whole or not at all; `options` are those of `shapes`.

    `about` says what it shows to those who do not see it.
    """
    try:
        size, found = shapes(scene, projection, **options)
    except Refusal as error:
        if error.bound != TOO_MANY:
            raise
        png = os.path.splitext(os.path.basename(path))[0] + ".png"
        raise Refusal.in_document(TOO_MANY_FOR, *error.limits, png, field=error.field) from error
    write = pdf if path.lower().endswith(".pdf") else svg
    said = (scene.title, "") if about is None else (about.title, about.text)
    write_bytes_atomically(path, write(found, size, *said))


def write_png(
    path: str | os.PathLike[str],
    pixels: Pixels,
    document_json: str | None = None,
    scale: float = 1.0,
) -> None:
    """Write a figure, whole or not at all.

    Dropped on the window, the file brings `document_json` back. `scale` sets its dots per inch.
    """
    write_bytes_atomically(path, png_bytes(pixels, document_json, scale))


def png_bytes(pixels: Pixels, document_json: str | None = None, scale: float = 1.0) -> bytes:
    """Return the file that `write_png` writes, for a clipboard."""
    buffer = io.BytesIO()
    dpi = max(1.0, DPI * scale)
    info = PngImagePlugin.PngInfo()
    if document_json is not None:
        info.add_itxt(FORMAT, document_json)
    Image.fromarray(pixels).save(buffer, "PNG", dpi=(dpi, dpi), pnginfo=info)
    return buffer.getvalue()


def usual_text_pt(
    image_size: tuple[int, int],
    panes: Sequence[str],
    size: Size | tuple[int, int] | None,
    column: bool = False,
) -> float:
    shorter = _shorter_px(image_size, panes, size, column)
    return max(_LEAST_TEXT_PX, USUAL_TEXT * shorter) * 72.0 / DPI


def checked_text(
    image_size: tuple[int, int],
    panes: Sequence[str],
    size: Size | tuple[int, int] | None,
    text_pt: float | None,
    column: bool = False,
) -> float:
    """Return the height of an em in points, for `render`'s parameters; refuse an impossible one."""
    if text_pt is None:
        return usual_text_pt(image_size, panes, size, column)
    least = _LEAST_TEXT_PX * 72.0 / DPI
    most = _LARGEST_TEXT * _shorter_px(image_size, panes, size, column) * 72.0 / DPI
    if not least <= text_pt <= most:  # NaN fails too
        raise Refusal.saying(TEXT, format_value(text_pt), f"{least:.3g}", f"{most:.3g}")
    return text_pt


def _shorter_px(
    image_size: tuple[int, int],
    panes: Sequence[str],
    size: Size | tuple[int, int] | None,
    column: bool,
) -> float:
    width, height = Size(*(size or _own_size(image_size, panes, column))).px
    return min(width, height / len(panes)) if column else min(width / len(panes), height)


def _own_size(
    image_size: tuple[int, int], panes: Sequence[str], column: bool = False
) -> tuple[int, int]:
    if tuple(panes) == ("image",):
        return image_size
    sides = PANE_PX * len(panes), PANE_PX
    return sides[::-1] if column else sides


def checked_size(
    image_size: tuple[int, int],
    panes: Sequence[str],
    size: Size | tuple[int, int] | None,
    scale: float,
    column: bool = False,
) -> tuple[int, int]:
    """Return the figure's width and height in pixels for `render`; refuse an impossible size."""
    if isinstance(panes, str) or not panes:
        raise Refusal.saying(NO_PANES, repr(panes), ", ".join(PANES))
    for pane in panes:
        if pane not in _DRAWINGS:
            raise Refusal.saying(UNKNOWN_PANE, repr(pane), ", ".join(PANES))
    lone_image = tuple(panes) == ("image",)
    size = Size(*(size or _own_size(image_size, panes, column)))
    if not 0.0 < scale <= LARGEST_PX:  # NaN fails too
        raise Refusal.saying(SCALE, f"{scale:g}", LARGEST_PX)
    per_px = PX_PER[size.unit]
    for templates, side, is_divided in zip(_SIDES, size[:2], (not column, column), strict=True):
        smallest = 1 if lone_image else SMALLEST_PANE_PX * (len(panes) if is_divided else 1)
        # Also for NaN; and an integer of 400 digits cannot be multiplied by the scale.
        if side <= sys.float_info.max and smallest <= side * per_px * scale <= LARGEST_PX:
            continue
        limits: tuple[object, object, object] = smallest, LARGEST_PX, f"{scale:g}"
        template = templates[0 if scale == 1.0 else 1]
        if size.unit != "px":
            template = templates[2]
            least, most = (bound / per_px / scale for bound in (smallest, LARGEST_PX))
            limits = f"{least:.3g}", f"{most:.4g}", size.unit
        raise Refusal.saying(template, format_value(side), *limits)
    width, height = size.px
    return whole_pixels((width * scale, height * scale))


class _Compared(NamedTuple):
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


def _compared_in(
    pane: str,
    document: Document,
    scene: Scene,
    size: tuple[int, int],
    framed: bool,
    style: Style,
    words: Mapping[str, str],
) -> _Compared:
    pictures, dividers = document.view.compare, document.view.dividers
    phenomenon = scene.phenomenon
    settings = () if phenomenon is None else phenomenon.settings
    written = Written(
        lambda name: words.get(FIELDS.get(name, name), FIELDS.get(name, name)),
        lambda text: words.get(text, text),
        lambda value: figure(value, 4),
    )
    given = [name_of(document, picture) for picture in pictures]
    states = [pictured(document, picture).state for picture in pictures]
    names = names_in([words.get(name, name) for name in given], states, settings, written)
    shown = [
        (of.projection, _illustration(scene, of.projection, of.settings), name)
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
    return _Compared(
        pane, shown, [*places], dividers if is_divided else (), live, (width, height), framed, lines
    )


def _compared(
    compared: _Compared, draw: Callable[..., tuple[Pixels, tuple[float, float]]], style: Style
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
    compared: _Compared, draw: Callable[..., tuple[_Drawn, tuple[float, float]]]
) -> list[tuple[_Drawn, tuple[float, float]]]:
    """The whole pictures of which a divided one shows strips."""
    middles = [sum(ends) / 2.0 for ends in pairwise((0.0, *compared.dividers, 1.0))]
    return [
        draw(*each, compared.size, framed=compared.framed, caption=name, middle=middle)
        for (*each, name), middle in zip(compared.shown, middles, strict=True)
    ]


def _edges(compared: _Compared, ends: tuple[float, float]) -> list[int]:
    begin, end = ends
    inner = (round(begin + part * (end - begin)) for part in compared.dividers)
    return [0, *inner, compared.size[0]]


def _compared_shapes(
    compared: _Compared,
    draw: Callable[..., tuple[list[Shape], tuple[float, float]]],
    style: Style,
) -> list[Shape]:
    """The shapes of `_compared`."""
    (width, height), found = compared.size, list[Shape]()
    line_px = _line_px(style)
    if compared.dividers:
        layers = _layers(compared, draw)
        edges = _edges(compared, layers[compared.live][1])
        for (part, _), (left, right) in zip(layers, pairwise(edges), strict=True):
            found += within(part, left, right)
        for x in edges[1:-1]:
            ends = [(float(x), 0.0), (float(x), float(height))]
            found.append(Stroke(ends, rgb(style.ink), 1.0, style.line_width))
    for (*each, name), (left, top, wide, high) in zip(
        compared.shown, compared.places, strict=False
    ):
        part = draw(*each, (wide, high), framed=True, caption=name, bare=True)[0]
        if compared.pane == "world":
            part.append(_line_of_text(name, wide / 2.0, line_px / 2.0, style))
        found += (moved(shape, left, top) for shape in part)
    ground = next((each for each in found if isinstance(each, Area)), None)
    if ground is not None and ground.colour == rgb(style.background):  # beside the pictures
        low = height + line_px * len(compared.lines)
        corners = [(0.0, 0.0), (float(width), 0.0), (float(width), low), (0.0, low)]
        found.insert(0, ground._replace(rings=[corners]))
    for number, text in enumerate(compared.lines):
        found.append(_line_of_text(text, width / 2.0, height + (number + 0.5) * line_px, style))
    return found


def _line_of_text(text: str, x: float, y: float, style: Style) -> Text:
    """A line of words round a point."""
    label = Label(text, style, plain=True)
    written = label.written
    left, low = written.place
    return Text(written, (x + left, y - low), written.em)


def _titled(pixels: Pixels, text: str, style: Style) -> Pixels:
    """A picture with its name at the top, where a pane has its title."""
    height, width, _ = pixels.shape
    ink = _in_words(_lines_of(text, (width, height), style), width, style)
    below = len(ink)
    colour = np.array([*(255.0 * part for part in rgb(style.ink)), 255.0])[: pixels.shape[2]]
    head = pixels[:below].astype(float)
    head += ink[..., None] * (colour - head)
    return np.concatenate([np.round(head).astype(np.uint8), pixels[below:]])


def _with_words(pixels: Pixels, ink: Array, style: Style) -> Pixels:
    """A picture with a band of text below it, on the same background."""
    if not len(ink):
        return pixels
    beside = pixels[0, 0].astype(float)
    colour = np.array([*(255.0 * part for part in rgb(style.ink)), 255.0])[: len(beside)]
    words = np.round(beside + ink[..., None] * (colour - beside)).astype(np.uint8)
    return np.concatenate([pixels, words])


def _line_px(style: Style) -> int:
    return round(LINE_EM * style.font_size)


def _lines_of(text: str, size: tuple[int, int], style: Style) -> list[str]:
    """Break a text into lines, at most a quarter of a height; the rest is dropped."""
    width, height = size
    font = ImageFont.truetype(font_file("DejaVuSans"), style.font_size)
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
    font = ImageFont.truetype(font_file("DejaVuSans"), style.font_size)
    line_px = _line_px(style)
    band = Image.new("L", (width, line_px * len(lines)))
    for place, line in enumerate(lines):
        middle = width / 2.0, (place + 0.5) * line_px
        ImageDraw.Draw(band).text(middle, line, fill=255, font=font, anchor="mm")
    ink: Array = np.asarray(band, dtype=np.float64).reshape(-1, width) / 255.0
    return ink


def _render_pane(
    pane: str,
    scene: Scene,
    projection: Projection,
    illustration: Illustration | None,
    size: tuple[int, int],
    *,
    transparent: bool,
    style: Style,
    words: Mapping[str, str],
    framed: bool,
    view: View,
    quality: Quality,
    caption: str = "",
    middle: float = 0.5,
    bare: bool = False,
    seen: Callable[[Drawing, int], object] | None = None,
) -> tuple[Pixels, tuple[float, float]]:
    """A pane's pixels, and where its picture begins and ends in them."""
    factor = _oversampling(size)
    with drawn_pane(
        pane, scene, projection, illustration, size, style=style, words=words, framed=framed,
        view=view, quality=quality, caption=caption, middle=middle, bare=bare, finer=factor,
        transparent=transparent,
    ) as (window, drawing):  # fmt: skip
        drawn = pixels_of(window)
        if seen is not None:
            seen(drawing, factor)
        ends = _ends(drawing, size, factor)
    return _averaged(drawn, factor, transparent), ends


def _shapes_of_pane(
    pane: str,
    projection: Projection,
    illustration: Illustration | None,
    size: tuple[int, int],
    *,
    scene: Scene,
    framed: bool,
    hidden: str,
    style: Style,
    watch: Callable[[], None],
    **options: Any,
) -> tuple[list[Shape], tuple[float, float]]:
    """A pane's shapes, and where its picture begins and ends in them."""
    factor = _oversampling(size)
    with drawn_pane(
        pane, scene, projection, illustration, size, style=style, framed=framed, finer=factor,
        **options,
    ) as (window, drawing):  # fmt: skip
        grey = rgb(mixed(style.ink, style.background, _GREY))
        return shapes_of(window, factor, hidden, grey, watch), _ends(drawing, size, factor)


def _ends(drawing: Drawing, size: tuple[int, int], factor: int) -> tuple[float, float]:
    """Where a pane's picture begins and ends."""
    if isinstance(drawing, ImageDrawing):
        place = drawing.picture_rectangle_px
        return place.left / factor, (place.left + place.width) / factor
    return 0.0, float(size[0])


@contextmanager
def drawn_pane(
    pane: str,
    scene: Scene,
    projection: Projection,
    illustration: Illustration | None,
    size: tuple[int, int],
    *,
    style: Style,
    words: Mapping[str, str],
    framed: bool,
    view: View,
    quality: Quality,
    caption: str = "",
    middle: float = 0.5,
    bare: bool = False,
    finer: int = 1,
    transparent: bool = False,
) -> Iterator[tuple[Any, Drawing]]:
    """A pane that has been drawn off the screen, `finer` times as large: its window and drawing."""
    width, height = (finer * side for side in size)
    options: dict[str, Any] = {}
    if pane != "world":
        options["tolerance_px"] = quality.tolerance_px(DRAWING_TOLERANCE_PX)
    if pane == "image":
        options |= {
            "framed": framed, "quality": quality, "caption": caption, "middle": middle,
            "finer": finer,
        }  # fmt: skip
    with off_screen(width, height) as screen:
        window = screen.render_window
        drawing = _DRAWINGS[pane](screen, scene, words, style.enlarged(finer), **options)
        drawing.show_layers(view.layers | {AXES} if bare else view.layers)
        drawing.show_names(named_in(pane, scene, view.names))
        drawing.show_projection(projection, illustration)
        if illustration is not None:  # as in the window, while nobody points at anything
            drawing.show_highlight(frozenset(illustration.about))
        if isinstance(drawing, StageDrawing):
            drawing.show_stage(view.stage)
        drawing.show_probes(view.probes)  # which are framed, too
        drawing.reset_view()
        if pane in view.panes:
            drawing.show_view(view.panes[pane])
        if isinstance(drawing, WorldDrawing):
            drawing.show_step(view.step)
            drawing.show_fixed(seen_from(view, scene))
        if transparent:
            for renderer in window.GetRenderers():
                renderer.SetBackground(0.0, 0.0, 0.0)
                renderer.SetBackgroundAlpha(0.0)
        drawing.refine(whole=True)
        window.Render()
        if isinstance(drawing, ImageDrawing) and drawing.problem is not None:  # known from now on
            window.Render()
        yield window, drawing
        drawing.remove()


def _oversampling(size: tuple[int, int]) -> int:
    """How many times as large each side is drawn: 3, or less where that takes too much memory."""
    width, height = size
    for factor in (3, 2):
        fits = factor * max(size) <= _LARGEST_DRAWN_PX
        if fits and factor * width * factor * height <= _MOST_DRAWN_PX:
            return factor
    return 1


def _averaged(drawn: Pixels, factor: int, transparent: bool) -> Pixels:
    """Average blocks of pixels, (factor h, factor w, 4) to (h, w, 4), or 3 if opaque.

    On a transparent background OpenGL leaves colours multiplied by their alpha. They are averaged
    so, and divided afterwards; then no edge has a dark seam.
    """
    channels = 4 if transparent else 3
    height, width = drawn.shape[0] // factor, drawn.shape[1] // factor
    total = np.zeros((height, width, channels), dtype=np.uint16)
    for row in range(factor):
        for column in range(factor):
            total += drawn[row::factor, column::factor, :channels]
    count = factor * factor
    if not transparent:
        return ((total + count // 2) // count).astype(np.uint8)
    alpha = total[..., 3:].astype(np.uint32)
    colours = (total[..., :3] * np.uint32(255) + alpha // 2) // np.maximum(alpha, 1)
    pixels = np.empty(total.shape, dtype=np.uint8)
    pixels[..., :3] = np.minimum(colours, 255)
    pixels[..., 3:] = (alpha + count // 2) // count
    return pixels
