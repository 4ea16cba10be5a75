"""Off-screen pictures of the panes, for papers and slides, without a window or a display.

The panes' own drawings draw a figure in a window of its own, which makes it independent of a
screen's size and scale.
"""

from __future__ import annotations

import io
import math
import os
import re
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, TypeVar

import numpy as np
from PIL import Image, PngImagePlugin

from app.document.codec import FORMAT
from app.document.document import Document
from app.document.files import write_bytes_atomically
from app.document.lengths import DPI, PX_PER, Size
from app.document.view import AS_EVER, PANES, View
from app.drawings import WORDS, DrawingWords
from app.drawings.compared_figures import compared_in, compared_pixels, compared_shapes
from app.drawings.describing import Description
from app.drawings.drawing import Drawing
from app.drawings.figure_size import checked_size, checked_text, own_size
from app.drawings.off_screen import Pixels
from app.drawings.one_pane import illustration_of, render_pane, shapes_of_pane
from app.drawings.pdf import pdf
from app.drawings.shades import printed
from app.drawings.side_by_side import panes_in
from app.drawings.style import LIGHT, Style, rgb
from app.drawings.svg import svg
from app.drawings.tikz import LARGEST, tikz
from app.drawings.vectors import TOO_MANY, Area, Shape, box_of, moved
from app.model.projection import Projection
from app.model.refusal import QT_TRANSLATE_NOOP, Cancelled, Refusal
from app.precision.quality import AUTOMATIC, Quality
from app.scenes.fewer_triangles import reduced
from app.scenes.scene import Scene
from app.strangers import printable

CROP_PX = 2.0 * PX_PER["mm"]
"""Margin of a figure that is cropped."""
_REPORT_EVERY_S, _SLOWING_S = 0.05, 5.0
_Part = TypeVar("_Part")
TOO_MANY_FOR = QT_TRANSLATE_NOOP(
    "Refusal",
    "has {0} faces, lines and points in a pane; the limit of a figure without pixels is {1}: "
    "write {2}",
)
A_LINK = QT_TRANSLATE_NOOP("Refusal", "{0}: is a link, where a picture of the figure would be.")
TOO_LARGE_FOR_TEX = QT_TRANSLATE_NOOP(
    "Refusal", "{0}: would have {1} MB; TeX's memory holds figures of {2} MB: write {3}."
)
NOT_FOUND_BY_TEX = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: TeX reads a picture beside it, whose name may have only letters from a to z, digits and "
    ". _ + = -.",
)


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
    drawn = _drawn(
        partial(render_pane, seen=seen), compared_pixels, _Watch(progress, len(panes)), scene,
        projection, panes, size, scale, transparent, style, words, view, settings, quality,
        text_pt, column,
    )  # fmt: skip
    parts = [part for part, _ in drawn]
    whole = parts[0] if len(parts) == 1 else np.concatenate(parts, axis=0 if column else 1)
    return _cropped(whole, style, round(CROP_PX * scale)) if crop else whole


def _drawn(
    draw: Callable[..., tuple[_Part, tuple[float, float]]],
    compare: Callable[..., _Part],
    watch: _Watch,
    scene: Scene,
    projection: Projection,
    panes: Sequence[str],
    size: Size | tuple[int, int] | None,
    scale: float,
    transparent: bool,
    style: Style,
    words: Mapping[str, str],
    view: View,
    settings: Mapping[str, Any] | None,
    quality: Quality,
    text_pt: float | None,
    column: bool,
) -> Iterator[tuple[_Part, tuple[int, int]]]:
    """Yield what each pane shows, drawn by `draw`, or by `compare` with it; and its left and top.

    The parameters are those of `render`.
    """
    size_px = checked_size(projection.image_size, panes, size, scale, column)
    em = checked_text(projection.image_size, panes, size, text_pt, column) * DPI / 72.0
    # Beside an image several worlds that are compared would be small.
    images = [None if p != "image" or view.compare else projection.aspect for p in panes]
    style = replace(style, margin=style.background, font_size=em).enlarged(scale)
    if words is WORDS:
        words = DrawingWords(view.letters)
    illustration = illustration_of(scene, projection, settings)
    scene = printed(reduced(scene, quality.detail), style)
    places = panes_in(size_px, images, column)
    for number, (pane, (left, top, *sides)) in enumerate(zip(panes, places, strict=True)):
        watch.begin(number)
        one = partial(
            draw, pane, scene=scene, transparent=transparent, style=style, words=words, view=view,
            quality=quality,
        )  # fmt: skip
        own_px, framed = (sides[0], sides[1]), len(panes) > 1
        if pane == view.compares_in and view.compare:
            document = Document(scene.name, projection, view=view, settings=settings or {})
            compared = compared_in(pane, document, scene, own_px, framed, style, words)
            yield compare(compared, one, style), (left, top)
        else:
            yield one(projection, illustration, own_px, framed=framed)[0], (left, top)


class _Watch:
    """Reports the progress in a pane, whose duration is unknown, every twentieth of a second."""

    def __init__(self, progress: Callable[[float], bool] | None, panes: int) -> None:
        self._progress, self._panes = progress, panes

    def begin(self, number: int) -> None:
        self._number, self._begin = number, time.monotonic()
        self._report(0.0)

    def __call__(self) -> None:
        if time.monotonic() - self._reported_at > _REPORT_EVERY_S:
            self._report(1.0 - math.exp((self._begin - time.monotonic()) / _SLOWING_S))

    def _report(self, part: float) -> None:
        self._reported_at = time.monotonic()
        if self._progress is not None and not self._progress((self._number + part) / self._panes):
            raise Cancelled


def _cropped(whole: Pixels, style: Style, margin: int) -> Pixels:
    """The part of a picture that is not empty, and a margin of it."""
    empty = np.round(255.0 * np.array(rgb(style.background)))
    ink = whole[..., 3] > 0 if whole.shape[2] > 3 else (whole != empty).any(axis=2)
    sides = []
    for axis in (1, 0):
        inked = np.flatnonzero(ink.any(axis=axis))
        if not len(inked):
            return whole
        sides.append(slice(max(0, int(inked[0]) - margin), int(inked[-1]) + 1 + margin))
    return np.ascontiguousarray(whole[sides[0], sides[1]])


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
    watch = _Watch(progress, len(panes))
    drawn = _drawn(
        partial(shapes_of_pane, hidden=hidden, watch=watch), compared_shapes, watch, scene,
        projection, panes, size, 1.0, transparent, style, words, view, settings, quality, text_pt,
        column,
    )  # fmt: skip
    joined = [moved(shape, *place) for part, place in drawn for shape in part]
    width, height = Size(*(size or own_size(projection.image_size, panes, column))).px
    box = box_of(joined, style.background) if crop else None
    if box is not None:
        x, y = (max(0.0, side - CROP_PX) for side in box[:2])
        width, height = min(width, box[2] + CROP_PX) - x, min(height, box[3] + CROP_PX) - y
        joined = [moved(shape, -x, -y) for shape in joined]
    if not transparent:  # or a seam would show between panes on a page of another colour
        page = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
        joined.insert(0, Area([page], rgb(style.background), 1.0))
    return (width, height), joined


def write_shapes(
    path: str,
    scene: Scene,
    projection: Projection,
    about: Description | None = None,
    progress: Callable[[float], bool] | None = None,
    **options: Any,
) -> None:
    """Write a figure as SVG, PDF or TikZ, whole or not at all; `options` are those of `shapes`.

    `about` says what it shows to those who do not see it. TikZ reads PNG files beside it, if any.
    """
    tell = progress or (lambda _part: True)
    name, ending = os.path.splitext(os.path.basename(path))
    try:
        size, drawn = shapes(scene, projection, progress=lambda part: tell(part / 2.0), **options)
    except Refusal as error:
        if error.bound != TOO_MANY:
            raise
        png = f"{name}.png"
        raise Refusal.in_document(TOO_MANY_FOR, *error.limits, png, field=error.field) from error
    watch = _Watch(lambda part: tell(0.5 + part / 2.0), 1)
    watch.begin(0)
    said = (scene.title, "") if about is None else (about.title, about.text)
    if ending.lower() == ".tex":
        content, pictures = tikz(drawn, size, *said, name)
        if pictures and not re.fullmatch(r"[\w.+=-]+", name, re.ASCII):
            raise Refusal.saying(NOT_FOUND_BY_TEX, path)
        if len(content) > LARGEST:
            sizes = (f"{count / 1e6:.3g}" for count in (len(content), LARGEST))
            raise Refusal.saying(TOO_LARGE_FOR_TEX, path, *sizes, f"{name}.pdf")
        beside = {os.path.join(os.path.dirname(path), each): each for each in pictures}
        if any(map(os.path.islink, beside)):  # a stranger's list of figures chooses the name
            raise Refusal.saying(A_LINK, next(filter(os.path.islink, beside)))
        for place, each in beside.items():
            write_bytes_atomically(place, pictures[each])
    else:
        write = partial(pdf, watch=watch) if ending.lower() == ".pdf" else svg
        content = write(drawn, size, *said)
    write_bytes_atomically(path, content)


def write_png(
    path: str | os.PathLike[str],
    pixels: Pixels,
    document_json: str | None = None,
    scale: float = 1.0,
    about: Description | None = None,
) -> None:
    """Write a figure, whole or not at all.

    Dropped on the window, the file brings `document_json` back. `scale` sets its dots per inch.
    `about` says what it shows to those who do not see it.
    """
    write_bytes_atomically(path, png_bytes(pixels, document_json, scale, about))


def png_bytes(
    pixels: Pixels,
    document_json: str | None = None,
    scale: float = 1.0,
    about: Description | None = None,
) -> bytes:
    """Return the file that `write_png` writes, for a clipboard."""
    buffer = io.BytesIO()
    dpi = max(1.0, DPI * scale)
    info = PngImagePlugin.PngInfo()
    if document_json is not None:
        info.add_itxt(FORMAT, document_json)
    if about is not None:
        info.add_itxt("Title", printable(about.title))
        info.add_itxt("Description", printable(about.text))
    Image.fromarray(pixels).save(buffer, "PNG", dpi=(dpi, dpi), pnginfo=info)
    return buffer.getvalue()
