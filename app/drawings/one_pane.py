"""One pane that is drawn off the screen, as pixels or as shapes.

It is drawn several times as large as asked for and averaged: every driver does that alike, while
multisampling differs from driver to driver.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import numpy as np

from app.document.naming import named_in, seen_from
from app.document.view import View
from app.drawings import AXES
from app.drawings.drawing import Drawing
from app.drawings.image import ImageDrawing
from app.drawings.off_screen import Pixels, off_screen, pixels_of
from app.drawings.stage import StageDrawing
from app.drawings.style import Style, mixed, rgb
from app.drawings.vectors import Shape, refuse_too_many, shapes_of
from app.drawings.world import WorldDrawing
from app.model.projection import Projection
from app.precision.levels import DRAWING_TOLERANCE_PX
from app.precision.quality import Quality
from app.scenes.phenomena.illustration import Illustration
from app.scenes.scene import Scene

_DRAWINGS: dict[str, type[WorldDrawing] | type[StageDrawing] | type[ImageDrawing]] = {
    "world": WorldDrawing,
    "ndc": StageDrawing,
    "image": ImageDrawing,
}
_LARGEST_DRAWN_PX = 8192  # largest side before averaging; every driver can draw it
_MOST_DRAWN_PX = 40_000_000  # of one pane before averaging: about 0.5 GB with depth and copies
_GREY = 0.55  # of the background in the colour of hidden lines


def illustration_of(
    scene: Scene, projection: Projection, settings: Mapping[str, Any] | None
) -> Illustration | None:
    if scene.phenomenon is None:
        return None
    chosen = scene.phenomenon.checked(settings or {})
    return scene.phenomenon.illustration(projection, chosen, scene.subject)


def render_pane(
    pane: str,
    projection: Projection,
    illustration: Illustration | None,
    size: tuple[int, int],
    *,
    scene: Scene,
    transparent: bool,
    seen: Callable[[Drawing, int], object] | None,
    **options: Any,
) -> tuple[Pixels, tuple[float, float]]:
    """A pane's pixels, and where its picture begins and ends in them."""
    factor = _oversampling(size)
    with drawn_pane(
        pane, scene, projection, illustration, size, finer=factor, transparent=transparent,
        **options,
    ) as (window, drawing):  # fmt: skip
        drawn = pixels_of(window)
        if seen is not None:
            seen(drawing, factor)
        ends = _ends(drawing, size, factor)
    return _averaged(drawn, factor, transparent), ends


def shapes_of_pane(
    pane: str,
    projection: Projection,
    illustration: Illustration | None,
    size: tuple[int, int],
    *,
    scene: Scene,
    hidden: str,
    style: Style,
    watch: Callable[[], None],
    **options: Any,
) -> tuple[list[Shape], tuple[float, float]]:
    """A pane's shapes, and where its picture begins and ends in them."""
    factor = _oversampling(size)
    with drawn_pane(
        pane, scene, projection, illustration, size, style=style, finer=factor,
        before=refuse_too_many, **options,
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
    before: Callable[[Any], None] = lambda window: None,
) -> Iterator[tuple[Any, Drawing]]:
    """A pane that has been drawn off the screen, `finer` times as large: its window and drawing.

    ``before(window)`` is called before it is drawn.
    """
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
        before(window)
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
