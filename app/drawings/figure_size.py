"""Sizes of figures and of their letters, and what is wrong with a size that cannot be."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from app.document.lengths import DPI, PX_PER, Size, whole_pixels
from app.document.view import PANES
from app.model.projection import LARGEST_IMAGE_PX
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal, format_value

LARGEST_PX = LARGEST_IMAGE_PX
"""Largest side of a figure."""
PANE_PX = 640
"""Default side of a pane."""
SMALLEST_PANE_PX = 32
"""Smallest side of a pane with labels."""
USUAL_TEXT = 7.0 * DPI / 72.0 / PANE_PX
"""Of the shorter side of a pane: the height of an em where nobody asks for another. In three panes
of `PANE_PX`, across a page, that is 7 points, which can be read there and on a slide (13 pixels, as
in the window, would be 3); other figures look alike."""

_LEAST_TEXT_PX, _LARGEST_TEXT = 1.0, 0.25  # the latter relative to the shorter side

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
_SIDES = (WIDTH, SCALED_WIDTH, LENGTH_WIDE), (HEIGHT, SCALED_HEIGHT, LENGTH_HIGH)


def checked_text(
    image_size: tuple[int, int],
    panes: Sequence[str],
    size: Size | tuple[int, int] | None,
    text_pt: float | None = None,
    column: bool = False,
) -> float:
    """Return the height of an em in points, for `render`'s parameters; refuse an impossible one."""
    width, height = Size(*(size or own_size(image_size, panes, column))).px
    count = len(panes)
    shorter = min(width, height / count) if column else min(width / count, height)
    if text_pt is None:
        return max(_LEAST_TEXT_PX, USUAL_TEXT * shorter) * 72.0 / DPI
    least, most = (side * 72.0 / DPI for side in (_LEAST_TEXT_PX, _LARGEST_TEXT * shorter))
    if not least <= text_pt <= most:  # NaN fails too
        raise Refusal.saying(TEXT, format_value(text_pt), f"{least:.3g}", f"{most:.3g}")
    return text_pt


def own_size(
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
        if pane not in PANES:
            raise Refusal.saying(UNKNOWN_PANE, repr(pane), ", ".join(PANES))
    lone_image = tuple(panes) == ("image",)
    size = Size(*(size or own_size(image_size, panes, column)))
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
    return whole_pixels((size.px[0] * scale, size.px[1] * scale))
