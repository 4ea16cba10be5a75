"""The places of pictures that are compared: beside and above each other."""

import math
from collections.abc import Sequence
from itertools import accumulate, pairwise

from app.drawings.style import TITLE_EM, Style

BARE_EM = 0.4  # margin of a picture without axes; its title is above it
_LEAST_PX = 24.0
_HARDLY = 0.15  # of the largest height: fewer rows are worth it
_BETWEEN_EM = 0.3
_FILLED = 0.7  # at least this part of an image's pane is filled, along each side
_LEAST_SHARE = 0.75  # of an equal share, for the panes beside an image


def line_px(style: Style) -> int:
    """The height of a line of words beside pictures."""
    return round(TITLE_EM * style.font_size)


def cells(
    width_px: int, height_px: int, aspects: Sequence[float], em: float
) -> list[tuple[int, int, int, int]]:
    """Return parts of a rectangle for pictures of one height, in as few rows as makes them large.

    `aspects` are the pictures' widths over heights; `em` is the height of letters in pixels, for
    frames and titles. The parts, (left, top, width, height), are whole pixels; a remainder is left
    at the right or the bottom. A last row of fewer pictures is centred.
    """
    across, down = 2.0 * BARE_EM * em, (2.0 * BARE_EM + TITLE_EM) * em

    def rows_of(count: int) -> list[Sequence[float]]:
        each = math.ceil(len(aspects) / count)
        return [aspects[start : start + each] for start in range(0, len(aspects), each)]

    def high(rows: Sequence[Sequence[float]]) -> float:
        widest = min((width_px - len(row) * across) / sum(row) for row in rows)
        return min(height_px / len(rows) - down, widest)

    possible = [rows_of(count) for count in range(1, len(aspects) + 1)]
    largest = max(map(high, possible))
    enough = largest - _HARDLY * abs(largest)
    rows = next(each for each in possible if high(each) >= enough)
    picture = max(high(rows), _LEAST_PX)
    wanted = [[across + picture * aspect for aspect in row] for row in rows]
    fullest = max(map(sum, wanted))
    rectangles, height = [], height_px // len(rows)
    for top, row in enumerate(wanted):
        # A picture that is alone in its row gets all of it, if no row is fuller.
        room = width_px / (sum(row) if len(rows) == len(aspects) else fullest)
        widths = [int(room * each) for each in row]
        lefts = accumulate(widths, initial=int((width_px - room * sum(row)) / 2.0))
        rectangles += [
            (left, top * height, width, height) for left, width in zip(lefts, widths, strict=False)
        ]
    return rectangles


def places_of(
    pane: str, width_px: int, height_px: int, aspects: Sequence[float], em: float
) -> list[tuple[int, int, int, int]]:
    """Return the places of compared pictures in a pane: images have a shape, worlds have none."""
    if pane == "image":
        return cells(width_px, height_px, aspects, em)
    return columns(width_px, height_px, len(aspects), em)


def columns(
    width_px: int, height_px: int, count: int, em: float
) -> list[tuple[int, int, int, int]]:
    """Return parts of a rectangle beside each other for pictures that fill any shape.

    The parts are as those of `cells`.
    """
    gap = max(1, round(_BETWEEN_EM * em))
    edges = [round(place * (width_px + gap) / count) for place in range(count + 1)]
    return [(left, 0, right - gap - left, height_px) for left, right in pairwise(edges)]


def panes_in(
    size_px: tuple[int, int], aspects: Sequence[float | None], column: bool = False
) -> list[tuple[int, int, int, int]]:
    """Return the rectangles of a figure's panes, in a row or in a column.

    `aspects` are those of images, and None for panes that fill any shape. The shares are equal, but
    that an image's pane is not so long that half of it would be empty, nor so short. The parts are
    as those of `cells`, without a remainder.
    """
    along, across = size_px[::-1] if column else size_px
    equal = along / len(aspects)
    images = [aspect for aspect in aspects if aspect is not None]
    others = len(aspects) - len(images)
    shares = [equal] * len(aspects)
    if images and others:
        most = (along - _LEAST_SHARE * equal * others) / len(images)
        wanted = [across / aspect if column else across * aspect for aspect in images]
        widths = iter([min(max(equal, _FILLED * full), full / _FILLED, most) for full in wanted])
        shares = [equal if aspect is None else next(widths) for aspect in aspects]
        kept = sum(s for s, aspect in zip(shares, aspects, strict=True) if aspect is not None)
        shares = [
            (along - kept) / others if aspect is None else share
            for share, aspect in zip(shares, aspects, strict=True)
        ]
    edges = [round(edge) for edge in accumulate(shares, initial=0.0)]
    if column:
        return [(0, top, across, low - top) for top, low in pairwise(edges)]
    return [(left, 0, right - left, across) for left, right in pairwise(edges)]
