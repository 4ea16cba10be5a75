"""One pane that is drawn off the screen, as pixels or as shapes.

It is drawn several times as large as asked for and averaged: every driver does that alike, while
multisampling differs from driver to driver.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from app.document.document import Document
from app.document.naming import named_in, seen_from
from app.drawings import AXES
from app.drawings.drawing import Drawing
from app.drawings.film_labels import Wanted
from app.drawings.image import ImageDrawing
from app.drawings.label_placement import Ground, Wish
from app.drawings.labels import Standing
from app.drawings.off_screen import Pixels, off_screen, pixels_of
from app.drawings.picture_frame import PictureOptions
from app.drawings.stage import StageDrawing
from app.drawings.style import Style, mixed, rgb
from app.drawings.vectors import Shape, refuse_too_many, shapes_of
from app.drawings.world import WorldDrawing
from app.precision.levels import DRAWING_TOLERANCE_PX
from app.scenes.phenomena.illustration import Illustration
from app.scenes.scene import Scene

_DRAWINGS: dict[str, type[WorldDrawing] | type[StageDrawing] | type[ImageDrawing]] = {
    "world": WorldDrawing,
    "ndc": StageDrawing,
    "image": ImageDrawing,
}
_LARGEST_DRAWN_PX = 8192  # largest side before averaging; every driver can draw it
_MOST_DRAWN_PX = 40_000_000  # of one pane before averaging: about 0.5 GB with depth and copies
Ends: TypeAlias = tuple[float, float]
"""Where a picture begins and ends in its pane's width, in pixels."""
_GREY = 0.55  # of the background in the colour of hidden lines


@dataclass(frozen=True, eq=False)
class PanePicture:
    """What one pane of a figure shows, or one of the pictures that are compared in it.

    - `pane`: one of "world", "ndc", "image".
    - `scene`: the document's, as it is drawn: perhaps with fewer triangles, or in other colours.
    - `size`: in pixels.
    - `framed`: whether an image has its frame.
    - `caption`: the name of an image.
    - `middle`: where the caption is, as a part of the image's width.
    - `bare`: whether an image has no pixel axes.
    - `fit`: what a world frames, as in `Figure`.
    - `labels`: where they stand in a frame of a film.
    """

    pane: str
    document: Document
    scene: Scene
    illustration: Illustration | None
    size: tuple[int, int]
    style: Style
    words: Mapping[str, str]
    framed: bool = True
    transparent: bool = False
    caption: str = ""
    middle: float = 0.5
    bare: bool = False
    fit: str = "named"
    labels: Standing | None = None

    def wanted(self) -> Wanted:
        """Return what its labels want; nothing is drawn."""
        asked = []

        def direct(wishes: Sequence[Wish], ground: Ground) -> Standing:
            ground.hidden(np.empty((0, 4)))  # it counts the ink of a drawing that is there
            asked.append(Wanted([wish.choices(ground) for wish in wishes], ground))
            return {}

        def lay_out(drawing: Drawing) -> None:
            drawing.board.director = direct
            drawing.state.canvas.relayout()
            drawing.state.canvas.lay_out()

        with self.drawn(_oversampling(self.size), lay_out=lay_out):
            return asked[-1] if asked else Wanted([], Ground((0.0, 0.0, 0.0, 0.0), 1.0))

    def pixels(self, seen: Callable[[Drawing, int], object] | None = None) -> Pixels:
        """Draw it; `seen` gets the drawing, and how many of its pixels are one of the picture's."""
        return self.pixels_and_ends(seen)[0]

    def pixels_and_ends(
        self, seen: Callable[[Drawing, int], object] | None = None
    ) -> tuple[Pixels, Ends]:
        factor = _oversampling(self.size)
        with self.drawn(factor) as (window, drawing):
            pixels = pixels_of(window)
            if seen is not None:
                seen(drawing, factor)
            ends = _ends(drawing, factor)
        return _averaged(pixels, factor, self.transparent), ends

    def shapes(self, hidden: str, watch: Callable[[], None]) -> list[Shape]:
        """Return its shapes; `hidden` and `watch` are those of `shapes_of`."""
        return self.shapes_and_ends(hidden, watch)[0]

    def shapes_and_ends(self, hidden: str, watch: Callable[[], None]) -> tuple[list[Shape], Ends]:
        factor = _oversampling(self.size)
        with self.drawn(factor, refuse_too_many) as (window, drawing):
            grey = rgb(mixed(self.style.ink, self.style.background, _GREY))
            return shapes_of(window, factor, hidden, grey, watch), _ends(drawing, factor)

    @contextmanager
    def drawn(
        self,
        finer: int = 1,
        before: Callable[[Any], None] = lambda window: None,
        lay_out: Callable[[Drawing], object] | None = None,
    ) -> Iterator[tuple[Any, Drawing]]:
        """Draw it `finer` times as large, or only `lay_out` it; yield the window and the drawing.

        ``before(window)`` is called before it is drawn.
        """
        pane, scene, view = self.pane, self.scene, self.document.view
        quality, illustration = self.document.quality, self.illustration
        width, height = (finer * side for side in self.size)
        options: dict[str, Any] = {}
        if pane != "world":
            options["tolerance_px"] = quality.tolerance_px(DRAWING_TOLERANCE_PX)
        if pane == "image":
            options["options"] = PictureOptions(
                self.framed, self.caption, self.middle, finer, quality
            )
        with off_screen(width, height) as screen:
            window, style = screen.render_window, self.style.enlarged(finer)
            drawing = _DRAWINGS[pane](screen, scene, self.words, style, **options)
            drawing.show_layers(view.layers | {AXES} if self.bare else view.layers)
            drawing.show_names(named_in(pane, scene, view.names))
            drawing.show_moves(self.document.projection, illustration, view.stage)
            if illustration is not None:  # as in the window, while nobody points at anything
                drawing.show_highlight(frozenset(illustration.about))
            drawing.show_stage(max(view.stage, 0.0))
            drawing.show_probes(view.probes)  # which are framed, too
            drawing.fit = self.fit
            drawing.reset_view()
            if pane in view.panes:
                drawing.show_view(view.panes[pane])
            drawing.show_step(view.step)
            drawing.show_fixed(seen_from(view, scene))
            if self.transparent:
                for renderer in window.GetRenderers():
                    renderer.SetBackground(0.0, 0.0, 0.0)
                    renderer.SetBackgroundAlpha(0.0)
            before(window)
            if self.labels is not None:
                labels = self.labels
                drawing.board.director = lambda wishes, ground: labels
            if lay_out is not None:
                lay_out(drawing)
            else:
                drawing.refine(whole=True)
                window.Render()
                if drawing.problem is not None:
                    window.Render()  # it is known from now on
            yield window, drawing
            drawing.remove()


def _ends(drawing: Drawing, factor: int) -> Ends:
    place = drawing.picture_rectangle_px
    return place.left / factor, (place.left + place.width) / factor


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
