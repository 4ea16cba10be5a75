"""Where the names of points and curves stand: beside them, free of each other; numpy only.

Greedy: one name after the other takes the free place that costs least. Of n names with the few
places that are tried for each this is n^2 comparisons of boxes at once.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_DIRECTIONS = np.array(
    [(1, 0), (1, -1), (1, 1), (-1, 0), (-1, -1), (-1, 1), (0, -1), (0, 1)], dtype=np.float64
)
"""From a point to its name, the better ones first."""
GAP_PX = 3.0
"""Between a curve and its name."""
_STEPS = 7
"""Heights of a name that it may be away from its point."""


def beside(
    points: Floats, sizes: Floats, frame: Floats, along: Floats, gaps: Floats, taken: Floats
) -> list[Floats | None]:
    """Places for the names of points.

    Parameters
    ----------
    points : (n, 2) array
        In pixels; the first ones choose first.
    sizes : (n, 2) array
        Widths and heights of the names; those of no width need no place.
    frame : (4,) array
        Left, low, right, high: where names may be.
    along : (m, 2) array
        Places along curves, which no name hides.
    gaps : (n,) array
        From each point to its name.
    taken : (k, 4) array
        Boxes like `frame` where other names stand already.

    Returns
    -------
    list of n (4,) arrays or None
        Boxes like `frame`; None where there is no free place: one that neither the name nor the
        line to it shares with another name, a dot or, but for the line, a curve.
    """
    reach = gaps[:, None] - 1.0
    dots = np.hstack([points - reach, points + reach])
    crossed = np.hstack([along - 1.0, along + 1.0])
    steps = np.repeat(np.arange(_STEPS), len(_DIRECTIONS))
    directions = np.tile(_DIRECTIONS, (_STEPS, 1))
    found: list[Floats | None] = []
    for point, size, gap in zip(points, sizes, gaps, strict=True):
        if size[0] <= 0.0:
            found.append(None)
            continue
        away = gap + size[1] * steps[:, None]
        centres = point + directions * (size / 2.0 + away)
        # To the side of a point a name need not be farther up too.
        centres[steps == 0, 1] -= (directions * gap)[steps == 0, 1]
        boxes = np.hstack([centres - size / 2.0, centres + size / 2.0])
        free = (boxes[:, :2] >= frame[:2]).all(axis=1) & (boxes[:, 2:] <= frame[2:]).all(axis=1)
        free &= ~_overlap(boxes, np.vstack([taken, dots])).any(axis=1)
        free &= ~_overlap(boxes, crossed).any(axis=1)
        cost = 4.0 * steps + 0.1 * np.tile(np.arange(len(_DIRECTIONS)), _STEPS)
        # The line from a point to its name runs through no other name, and no other dot.
        lines = _line(point, np.clip(point, boxes[:, :2], boxes[:, 2:]))
        others = dots[np.abs(points - point).max(axis=1) > 2.0 * gap]
        struck = _overlap(lines.reshape(-1, 4), np.vstack([taken, others]))
        free &= ~struck.reshape(*lines.shape[:2], -1).any(axis=(1, 2))
        if not free.any():
            found.append(None)
            continue
        chosen = int(np.argmin(np.where(free, cost, np.inf)))
        best: Floats = boxes[chosen]
        # Nor is a later name put on it, but on its point's end, where dots are alone anyway.
        taken = np.vstack([taken, best, *(lines[chosen][2:] if steps[chosen] else ())])
        found.append(best)
    return found


def beside_curve(
    frame: Floats,
    along: Floats,
    half: float,
    size: tuple[float, float],
    taken: Floats,
    lines: Floats,
    kept: Floats | None = None,
) -> Floats:
    """A place for a curve's name: beside the curve, free of other names and of curves.

    Parameters
    ----------
    frame : (4,) array
        Left, top, right, bottom: where names may be.
    along : (n, 2) array
        Places along the curve.
    half : float
        How far the curve reaches from there.
    size : (float, float)
        Of the name.
    taken : (m, 4) array
        Where names are already: left, top, right, bottom.
    lines : (k, 4) array
        Pieces of all curves, likewise.
    kept : (4,) array, optional
        Where the name stood before: good enough while it is free and beside its curve.

    Returns
    -------
    (4,) array
        Left, top, right, bottom. Where there is no free place, or nothing is seen of the curve,
        the next line of a list at the top left.
    """
    width, height = size
    ends = frame * (1.0, 1.0, -1.0, -1.0)
    if kept is not None and np.abs(kept[2:] - kept[:2] - size).max() < 1e-3:
        inside = (kept * (1.0, 1.0, -1.0, -1.0) >= ends).all()
        free = not _overlap(kept[None], np.vstack([taken, lines])).any()
        near = kept + height * np.array([-1.0, -1.0, 1.0, 1.0])
        if inside and free and _overlap(near[None], np.hstack([along, along])).any():
            return kept
    right, left = GAP_PX + half - 1.0, 1.0 - half - width  # a line touches its name, a dot does not
    sides = np.array([(right, -height), (left, -height), (right, 1.0), (left, 1.0)])
    corners = (along[::-1, None, :] + sides).reshape(-1, 2)  # from the right, where curves part
    boxes = np.hstack([corners, corners + size])
    boxes = boxes[(boxes * (1.0, 1.0, -1.0, -1.0) >= ends).all(axis=1)]
    boxes = boxes[~_overlap(boxes, taken).any(axis=1)]
    if len(boxes):
        crossed = _overlap(boxes, lines).sum(axis=1)
        best: Floats = boxes[np.argmin(100 * crossed + np.arange(len(boxes)))]
        return best
    left, top = frame[:2] + GAP_PX
    box = np.array([left, top, left + width, top + height])
    while _overlap(box[None], taken).any() and box[3] < frame[3]:
        box += (0.0, height, 0.0, height)
    return box


def _line(point: Floats, ends: Floats) -> Floats:
    """Small boxes along lines from a point, (n, 8, 4)."""
    parts = np.linspace(0.1, 0.9, 8)[:, None]
    places = point + parts * (ends - point)[:, None, :]
    return np.concatenate([places - 1.0, places + 1.0], axis=-1)


def _overlap(boxes: Floats, others: Floats) -> NDArray[np.bool_]:
    """Which boxes overlap which others, (m, n)."""
    left, low, right, high = boxes.T[:, :, None]
    other_left, other_low, other_right, other_high = others.T[:, None, :]
    across = (left < other_right) & (other_left < right)
    return np.asarray(across & (low < other_high) & (other_low < high))
