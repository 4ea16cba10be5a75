"""A figure, for papers and slides: drawn off the screen, without a window or a display.

The panes' own drawings draw it in a window of its own, which makes it independent of a screen's
size and scale. VTK is imported when a figure is drawn.
"""

from __future__ import annotations

import math
import os
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from operator import itemgetter
from typing import TYPE_CHECKING, Any

import numpy as np

from app.document.codec import picture_json
from app.document.document import Document
from app.document.files import path_of, write_bytes_atomically
from app.document.lengths import DPI, PX_PER, Size, whole_pixels
from app.document.view import PANES
from app.drawings import DrawingWords
from app.drawings.describing import Description, describe
from app.drawings.shades import printed
from app.drawings.side_by_side import line_px, panes_in
from app.drawings.style import PALETTES, Style, rgb
from app.model.limits import check_name
from app.model.projection import LARGEST_IMAGE_PX
from app.model.refusal import REFUSALS, Cancelled, Refusal, format_value
from app.scenes.fewer_triangles import reduced
from app.scenes.scene import Scene

if TYPE_CHECKING:
    from app.drawings.drawing import Drawing
    from app.drawings.equation_picture import EquationPicture
    from app.drawings.off_screen import Pixels
    from app.drawings.one_pane import PanePicture
    from app.drawings.vectors import Shape

ENDINGS = (".png", ".svg", ".pdf", ".tex")
HIDDEN = ("none", "dashed", "grey")  # what becomes of lines that faces hide
LARGEST_PX = LARGEST_IMAGE_PX  # largest side of a figure
PANE_PX = 640  # default side of a pane
SMALLEST_PANE_PX = 32  # smallest side of a pane with labels
USUAL_TEXT = 7.0 * DPI / 72.0 / PANE_PX
"""Of the shorter side of a pane: the height of an em where nobody asks for another. In three panes
of `PANE_PX`, across a page, that is 7 points, which can be read there and on a slide (13 pixels, as
in the window, would be 3); other figures look alike."""
CROP_PX = 2.0 * PX_PER["mm"]  # margin of a figure that is cropped
FITS = ("named", "frustum", "scene")
"""What a world pane frames: what is named, with the whole frustum too, or the objects alone."""
_HIGH = 0.7  # of its width: a pane in a column, three of which of 84 mm go into a page of a book
_GAP_EM = 2.0  # left empty between panes of a column whose height is free
_TRIES, _HELD, _NEAR_PX, _FITS = 9, 6, 0.5, 3  # until what is seen is as wide as asked for

_LEAST_TEXT_PX, _LARGEST_TEXT = 1.0, 0.25  # the latter relative to the shorter side
_REPORT_EVERY_S, _SLOWING_S = 0.05, 5.0

_SIDES = (
    (REFUSALS["width"], REFUSALS["scaled-width"], REFUSALS["length-wide"]),
    (REFUSALS["height"], REFUSALS["scaled-height"], REFUSALS["length-high"]),
)


@dataclass(frozen=True, repr=False)
class Figure:
    """What is drawn once: a document, and how. A figure that exists can be drawn.

    Raises a `Refusal` for an unknown pane, palette or kind of hidden lines, and for a size, a scale
    or letters that are not possible.

    - `scene`: the document's.
    - `panes`: of "world", "ndc", "image"; from left to right, as wide as `panes_in` says.
      The image alone is drawn without its frame. Or the "equation" of the view, alone.
    - `size`: by default `PANE_PX` squares, or the image's own size for the image alone.
    - `scale`: multiplies the size with all lines and letters: the same pixels, finer.
    - `column`: draw the panes below each other.
    - `text_pt`: height of an em in points, of which 72 are `DPI` pixels; by default `USUAL_TEXT`.
    - `palette`: one of `PALETTES`.
    - `hidden`: one of `HIDDEN`, for shapes.
    - `crop`: leave out what is empty around the content, but for a margin of `CROP_PX`.
    - `width`: of what is seen, in pixels at scale 1; it is cropped to that, and its height is free.
    - `fit`: one of `FITS`.
    - `transparent`: leave the background transparent.
    - `words`: the words in the drawings; by default those with the view's letters.
    - `note`: a line below the panes.
    - `labels`: where they stand in a frame of a film, a `Standing` for each picture.
    """

    document: Document
    scene: Scene
    panes: Sequence[str] = PANES
    size: Size | tuple[int, int] | None = None
    scale: float = 1.0
    column: bool = False
    text_pt: float | None = None
    palette: str = "screen"
    hidden: str = "none"
    crop: bool = False
    transparent: bool = False
    words: Mapping[str, str] | None = field(default=None, hash=False)
    width: float | None = None
    fit: str = "named"
    note: str = ""
    labels: Sequence[Any] = field(default=(), hash=False)

    def __post_init__(self) -> None:
        for name, known in (("palette", PALETTES), ("hidden", HIDDEN), ("fit", FITS)):
            check_name(name, getattr(self, name), known)
        if isinstance(self.panes, str) or not self.panes:
            raise Refusal.saying(REFUSALS["no-panes"], repr(self.panes), ", ".join(PANES))
        for pane in self.panes:
            if pane not in PANES and tuple(self.panes) != ("equation",):
                raise Refusal.saying(REFUSALS["unknown-pane"], repr(pane), ", ".join(PANES))
        object.__setattr__(self, "panes", tuple(self.panes))
        self._check_size()
        side = LARGEST_PX if self.panes == ("equation",) else self._side
        least, most = (side * 72.0 / DPI for side in (_LEAST_TEXT_PX, _LARGEST_TEXT * side))
        if self.text_pt is not None and not least <= self.text_pt <= most:  # NaN fails too
            raise Refusal.saying(
                REFUSALS["text"], format_value(self.text_pt), f"{least:.3g}", f"{most:.3g}"
            )

    def _check_size(self) -> None:
        if not 0.0 < self.scale <= LARGEST_PX:  # NaN fails too
            raise Refusal.saying(REFUSALS["scale"], f"{self.scale:g}", LARGEST_PX)
        size, divided = self.full_size, (not self.column, self.column)
        if isinstance(self.width, float):  # it was a length
            wide, high = (round(side / PX_PER["mm"], 6) for side in size.px)
            size = Size(wide, high, "mm")
        per_px = PX_PER[size.unit]
        for templates, side, is_divided in zip(_SIDES, size[:2], divided, strict=True):
            smallest = SMALLEST_PANE_PX * (len(self.panes) if is_divided else 1)
            if self._has_own_size:
                smallest = 1
            # Also for NaN; and an integer of 400 digits cannot be multiplied by the scale.
            if side <= sys.float_info.max and smallest <= side * per_px * self.scale <= LARGEST_PX:
                continue
            limits: tuple[object, object, object] = smallest, LARGEST_PX, f"{self.scale:g}"
            template = templates[0 if self.scale == 1.0 else 1]
            if size.unit != "px":
                template = templates[2]
                least, most = (bound / per_px / self.scale for bound in (smallest, LARGEST_PX))
                limits = f"{least:.3g}", f"{most:.4g}", size.unit
            raise Refusal.saying(template, format_value(side), *limits)

    @cached_property
    def full_size(self) -> Size:
        """Width and height at scale 1, before it is cropped."""
        asked = None if self.size is None else Size(*self.size)
        if self.panes == ("equation",):  # or a `Refusal`
            room = self.width or (0.0 if asked is None else asked.px[0])
            needed = self._equation((room, 0.0)).needed
            return asked or Size(needed[0] if self.width is None else self.width, needed[1])
        if asked is not None:
            return asked
        if self.panes == ("image",):
            wide, high = self.document.projection.image_size
            across = wide if self.width is None else self.width
            return Size(across, across * high / wide)
        count = len(self.panes)
        if not self.column:
            side = PANE_PX if self.width is None else self.width / count
            return Size(count * side, side)
        side = PANE_PX if self.width is None else self.width
        return Size(side, count * side * (1.0 if self.width is None else _HIGH))

    @property
    def _side(self) -> float:
        """The shorter side of a pane in pixels at scale 1, if all are equally wide."""
        (width, height), count = self.full_size.px, len(self.panes)
        return min(width, height / count) if self.column else min(width / count, height)

    @property
    def size_px(self) -> tuple[int, int]:
        """Width and height in pixels, before it is cropped."""
        return self._scaled(self.scale)

    def _scaled(self, scale: float) -> tuple[int, int]:
        width, height = self.full_size.px
        return whole_pixels((width * scale, height * scale))

    @property
    def em_pt(self) -> float:
        if self.text_pt is not None or self.panes == ("equation",):
            return self.text_pt or 7.0
        return max(_LEAST_TEXT_PX, USUAL_TEXT * self._side) * 72.0 / DPI

    @cached_property
    def description(self) -> Description:
        """What it shows, for those who do not see it."""
        return describe(self.document, self.scene, self.panes)

    # -- drawing

    def pixels(
        self,
        progress: Callable[[float], bool] | None = None,
        seen: Callable[[Drawing, int], object] | None = None,
    ) -> Pixels:
        """Draw it, and return (height, width, 3 or 4) uint8 pixels.

        The first row is the top one; colours are not multiplied by alpha. Raises `Cancelled` when
        `progress` returned False, and RuntimeError where there is no OpenGL.

        - `progress`: called now and then with the fraction done; drawing stops when it returns
          False.
        - `seen`: called with the drawing of each pane and how many of its pixels are one of the
          figure's.

        Beside live Qt panes, release Qt's current OpenGL context first (``doneCurrent``). Otherwise
        VTK may use Qt's context for its own.
        """
        if self.panes == ("equation",):
            from app.drawings.pdf import rastered

            size, shapes = self.shapes()
            return rastered(shapes, size, self.scale)[..., : 4 if self.transparent else 3]
        watch = _Watch(progress, len(self.panes))
        figure, whole = self._as_wide(watch, seen)
        if figure.scale != self.scale:
            figure = replace(figure, scale=self.scale, labels=())
            whole = figure._whole(watch, seen)
        for rows in self._slack(figure, whole):
            whole = np.delete(whole, slice(*rows), axis=0)
        return self._cropped(whole) if self._is_cropped else whole

    def boxed(self, other: Figure | None = None) -> Figure:
        """Return it in a box in which what is seen is as wide as asked for, or in a smaller other.

        Most frames of a film are no wider than the widest one: they are drawn once.
        """
        figure, watch = replace(self, size=None), _Watch(None, len(self.panes))
        if self.width is None or self._has_own_size:
            return figure
        if other is not None:
            tried = replace(figure._drawn_once, size=other.size, text_pt=other.text_pt)
            if tried._wide(tried._whole(watch)) - self.width <= _NEAR_PX:
                return other
        own = replace(figure._as_wide(watch)[0], scale=self.scale, labels=())
        return min(other or own, own, key=lambda each: each.full_size.px)

    @property
    def _drawn_once(self) -> Figure:
        """All formats have the same box: it is found at scale 1, where that has enough pixels."""
        return replace(self, scale=1.0 if self._side >= SMALLEST_PANE_PX else self.scale)

    def _wide(self, whole: Pixels) -> float:
        """How wide what is seen in a picture is, at scale 1."""
        return float(np.ptp(self._seen(whole)[0])) / self.scale

    @property
    def _is_cropped(self) -> bool:
        return self.crop or (self.width is not None and not self._has_own_size)

    @property
    def _has_own_size(self) -> bool:
        """Whether it fills its box: an equation, and an image that is compared with none."""
        return self.panes == ("equation",) or (
            self.panes == ("image",) and not self.document.view.compare
        )

    def _whole(self, watch: _Watch, seen: Callable[[Drawing, int], object] | None = None) -> Pixels:
        """Its pixels before it is cropped."""
        from app.drawings.compared_figures import titled

        parts = [part.pixels(seen) for part, _ in self._parts(self.scale, watch)]
        whole = parts[0] if len(parts) == 1 else np.concatenate(parts, axis=int(not self.column))
        if not self.note:
            return whole
        style = self._style(self.scale)
        ground = np.round(255.0 * np.array([*rgb(style.background), 0.0]))[: whole.shape[2]]
        line = np.full((line_px(style), *whole.shape[1:]), ground, dtype=np.uint8)
        return np.concatenate([whole, titled(line, self.note, style, centred=False)])

    def _as_wide(
        self, watch: _Watch, seen: Callable[[Drawing, int], object] | None = None
    ) -> tuple[Figure, Pixels]:
        """Draw it in a box in which what is seen is as wide as asked for; return both."""
        if self.size or self.width is None or self._has_own_size:
            return self, self._whole(watch, seen)
        figure = self._drawn_once
        tries: list[tuple[tuple[bool, float], Figure, Pixels]] = []

        def note(drawing: Drawing, finer: int) -> None:
            stands.append(drawing.board.standing)
            if seen is not None:
                seen(drawing, finer)

        while len(tries) <= _TRIES:
            stands: list[Any] = []
            drawn = figure._whole(watch, note)
            if len(tries) >= _TRIES - _HELD:  # labels that jump find no such box: they stay
                figure = replace(figure, labels=stands)
            wide = figure._wide(drawn) or self.width
            missing = self.width - wide
            tries.append(((missing < -_NEAR_PX, abs(missing)), figure, drawn))
            if abs(missing) <= _NEAR_PX:
                break
            (across, up), larger = figure.full_size.px, self.width / wide
            figure = replace(figure, size=Size(larger * across, larger * up), text_pt=self.em_pt)
        return min(tries, key=itemgetter(0))[1:]  # what is too wide would be cut

    def _slack(self, figure: Figure, whole: Pixels) -> list[tuple[int, int]]:
        """The rows, if any, that are too many between the panes of a column, from below."""
        is_fixed = self.size or self.width is None or not self.column
        parts = [] if is_fixed else [*figure._parts(figure.scale, _Watch(None, 1))]
        gap = round(_GAP_EM * figure._style(figure.scale).font_size)
        return [
            (self._seen(whole[:top])[1][1] + gap, top + self._seen(whole[top:])[1][0])
            for _, (_, top) in parts[:0:-1]
        ]

    def _seen(self, whole: Pixels) -> list[tuple[int, int]]:
        """Where a picture is not empty: from which column to which, and from which row."""
        empty = np.round(255.0 * np.array(rgb(PALETTES[self.palette].background)))
        ink = whole[..., 3] > 0 if self.transparent else (whole != empty).any(axis=2)
        places = [np.flatnonzero(ink.any(axis=axis)) for axis in (0, 1)]
        if not len(places[0]):
            return [(0, whole.shape[1]), (0, whole.shape[0])]
        return [(int(each[0]), int(each[-1]) + 1) for each in places]

    def _cropped(self, whole: Pixels) -> Pixels:
        """The part of a picture that is not empty, as wide as asked for, or with a margin."""
        (left, right), (top, low) = self._seen(whole)
        margin, high, wide = round(CROP_PX * self.scale), *whole.shape[:2]
        if self.width is None:
            left, right = max(0, left - margin), min(wide, right + margin)
            top, low = max(0, top - margin), min(high, low + margin)
        else:
            more = round(self.width * self.scale) - (right - left)
            left, right = left - more // 2, right + more - more // 2
        beside = [(0, 0), (max(0, -left), max(0, right - wide)), (0, 0)]
        part = np.pad(whole[top:low], beside, mode="edge")
        return np.ascontiguousarray(part[:, max(0, left) :][:, : right - left])

    def shapes(
        self, progress: Callable[[float], bool] | None = None
    ) -> tuple[tuple[float, float], list[Shape]]:
        """Return its size in pixels at scale 1 and its shapes, from the back to the front.

        The size is exactly the one asked for; what lies beyond is for the writer to cut off. A
        `Refusal` for too many shapes, else as for `pixels`.
        """
        from app.drawings.vectors import Area, box_of, moved, tinted

        watch, background = _Watch(progress, len(self.panes)), PALETTES[self.palette].background
        is_boxed = self.size or self.width is None or self._has_own_size
        figure, whole = (self, np.empty((0, 0, 4), np.uint8)) if is_boxed else self._as_wide(watch)
        shapes = [*tinted(figure._whole_shapes(watch), background)]
        for first, last in np.array(self._slack(figure, whole)) / figure.scale:
            for number, shape in enumerate(shapes):
                if first < last < (box_of([shape], "") or (0.0, 0.0))[1] + 1.5:
                    shapes[number] = moved(shape, 0.0, first - last)
        width, height = self.full_size.px
        box = box_of(shapes, background) if self._is_cropped else None
        if box is not None and self.width is not None:
            for _ in range(0 if self.size else _FITS):  # letters keep their size: again
                larger = self.width / (box[2] - box[0])
                shapes = [moved(shape, 0.0, 0.0, larger) for shape in shapes]
                box = box_of(shapes, background) or box
            width, height = self.width, box[3] - box[1]
            x = (box[0] + box[2] - width) / 2.0
            shapes = [moved(shape, -x, -box[1]) for shape in shapes]
        elif box is not None:
            x, y = (max(0.0, side - CROP_PX) for side in box[:2])
            width, height = min(width, box[2] + CROP_PX) - x, min(height, box[3] + CROP_PX) - y
            shapes = [moved(shape, -x, -y) for shape in shapes]
        if not self.transparent:  # or a seam would show between panes on a page of another colour
            page = [(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)]
            shapes.insert(0, Area([page], rgb(background), 1.0))
        return (width, height), shapes

    def _whole_shapes(self, watch: _Watch) -> Iterator[Shape]:
        """Its shapes before it is cropped."""
        from app.drawings.compared_figures import line_of_text
        from app.drawings.vectors import moved

        for part, place in self._parts(1.0, watch):
            yield from (moved(shape, *place) for shape in part.shapes(self.hidden, watch))
        if self.note:
            style = self._style(1.0)
            low = self.full_size.px[1] - line_px(style) / 2.0
            yield line_of_text(self.note, style.font_size / 2.0, low, style, -1)

    def _parts(self, scale: float, watch: _Watch) -> Iterator[tuple[Any, tuple[int, int]]]:
        """Yield what each pane shows, with its left and top."""
        from app.drawings.compared_figures import compared_in
        from app.drawings.off_screen import check_off_screen
        from app.drawings.one_pane import PanePicture

        if self.panes == ("equation",):
            yield self._equation(self.full_size.px), (0, 0)
            return
        check_off_screen()
        document, view = self.document, self.document.view
        # Beside an image several worlds that are compared would be small.
        aspect = None if view.compare else document.projection.aspect
        images = [aspect if pane == "image" else None for pane in self.panes]
        style = self._style(scale)
        words = DrawingWords(view.letters) if self.words is None else self.words
        illustration = self.scene.illustration(document.projection, document.settings)
        scene = printed(reduced(self.scene, document.quality.detail), style)
        width, height = self._scaled(scale)
        size = width, height - (line_px(style) if self.note else 0)
        places, labels = panes_in(size, images, self.column), iter(self.labels)
        for number, (pane, (left, top, *sides)) in enumerate(zip(self.panes, places, strict=True)):
            watch.begin(number)
            picture = PanePicture(
                pane, document, scene, illustration, (sides[0], sides[1]), style, words,
                framed=len(self.panes) > 1, transparent=self.transparent, fit=self.fit,
            )  # fmt: skip
            if pane == view.compares_in and view.compare:
                several = compared_in(picture, self.scene)
                pictures = [replace(p, labels=next(labels, None)) for p in several.pictures]
                yield replace(several, pictures=pictures), (left, top)
            else:
                yield replace(picture, labels=next(labels, None)), (left, top)

    def pictures(self) -> Iterator[PanePicture]:
        """Yield what it draws, one by one: of compared pictures each."""
        for part, _ in self._parts(self.scale, _Watch(None, 1)):
            yield from getattr(part, "pictures", (part,))

    def _style(self, scale: float) -> Style:
        style, em_px = PALETTES[self.palette], self.em_pt * DPI / 72.0
        one_size = bool(self.text_pt or self.width) or style.on_paper  # also in formulas
        style = replace(style, margin=style.background, font_size=em_px, one_size=one_size)
        return style.enlarged(scale)

    def _equation(self, size: tuple[float, float]) -> EquationPicture:
        from app.drawings.equation_picture import EquationPicture

        style = replace(PALETTES[self.palette], font_size=self.em_pt * DPI / 72.0)
        return EquationPicture(self.document, style, size)

    # -- files

    def array(self) -> Pixels:
        """Return its pixels, (height, width, 3) uint8; with a fourth channel if transparent."""
        return self.pixels()

    def png(self, progress: Callable[[float], bool] | None = None) -> bytes:
        """Return it as a PNG file, which contains the document."""
        from app.drawings.figure_files import png_bytes

        json, pixels = picture_json(self.document), self.pixels(progress)
        return png_bytes(pixels, json, self.scale, self.description)

    def svg(self) -> str:
        """Return it as SVG, without reference to another file; a `Refusal` for too many shapes."""
        from app.drawings.svg import svg

        size, shapes = self.shapes()
        return svg(shapes, size, self.description.title, self.description.text).decode()

    def _repr_svg_(self) -> str:
        """What a notebook shows."""
        return self.svg()

    def save(
        self, path: str | os.PathLike[str], progress: Callable[[float], bool] | None = None
    ) -> None:
        """Write a .svg, .pdf, .tex (TikZ) or .png file, whole or not at all.

        The PNG contains the document: dropped on the window, it brings its state back. TikZ reads
        PNG files beside it, if any. A `Refusal` for another ending, too many shapes, and a file
        that cannot be written.
        """
        from app.drawings.figure_files import write_shapes

        name = path_of("path", path)
        if not name.lower().endswith(ENDINGS):
            raise Refusal.saying(REFUSALS["an-ending"], name)
        if name.lower().endswith(".png"):
            write_bytes_atomically(name, self.png(progress))
            return
        tell = progress or (lambda _part: True)
        try:
            size, shapes = self.shapes(lambda part: tell(part / 2.0))
        except Refusal as error:
            if error.bound != REFUSALS["too-many"]:
                raise
            png = f"{os.path.splitext(os.path.basename(name))[0]}.png"
            bound, limits = REFUSALS["too-many-for"], (*error.limits, png)
            raise Refusal.in_document(bound, *limits, field=error.field) from error
        watch = _Watch(lambda part: tell(0.5 + part / 2.0), 1)
        watch.begin(0)
        write_shapes(name, shapes, size, self.description, watch)


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
