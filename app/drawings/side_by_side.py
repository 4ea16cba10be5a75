"""Where pictures stand that are compared: beside or above each other."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate

from app.drawings.style import TITLE_EM

BARE_EM = 0.4
"""Round a picture without axes; above it there is its title, too."""
_LEAST_PX = 24.0


def cells(
    width_px: int, height_px: int, aspects: Sequence[float], em: float
) -> list[tuple[int, int, int, int]]:
    """Parts of a rectangle for pictures of one height: in a row or a column, as they are larger.

    Parameters
    ----------
    width_px, height_px : int
        Of the whole.
    aspects : sequence of float
        Width over height of each picture.
    em : float
        Height of letters in pixels, of which their frames and titles have some.

    Returns
    -------
    list of (left, top, width, height)
        In whole pixels; what is left over is at the right, or at the bottom.
    """
    count = len(aspects)
    across, down = 2.0 * BARE_EM * em, (2.0 * BARE_EM + TITLE_EM) * em
    in_row = min(height_px - down, (width_px - count * across) / sum(aspects))
    in_column = min(height_px / count - down, (width_px - across) / max(aspects))
    if in_row < in_column:
        high = height_px // count
        return [(0, place * high, width_px, high) for place in range(count)]
    wanted = [across + max(in_row, _LEAST_PX) * aspect for aspect in aspects]
    widths = [int(width_px * each / sum(wanted)) for each in wanted]
    lefts = accumulate(widths, initial=0)
    return [(left, 0, width, height_px) for left, width in zip(lefts, widths, strict=False)]
