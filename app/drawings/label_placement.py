"""The one placer of labels, for panes, diagrams and charts; numpy only.

The input is a frame, the boxes that are taken, and for each label its candidates, best first: where
its box could be, which anchor it names, and what the caller charges for it. The output is the
cheapest free candidate, whose box is taken from then on. Labels choose one after the other.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

GAP_PX = 3.0
"""Between a curve and its name."""
LEADER, INK = 1.0, 2.0
"""Costs of a leader that crosses something, and of a label on what should stay visible."""

_DIRECTIONS = np.array(
    [(1, 0), (1, -1), (1, 1), (-1, 0), (-1, -1), (-1, 1), (0, -1), (0, 1)], dtype=np.float64
)
"""From a point to its name, the better ones first."""
_STEPS = 7
"""How many of its heights a name may be away from its point."""


class Box(NamedTuple):
    """A rectangle in pixels; low and high count upwards in a pane, downwards in a diagram."""

    left: float
    low: float
    right: float
    high: float

    @property
    def middle(self) -> tuple[float, float]:
        return (self.left + self.right) / 2.0, (self.low + self.high) / 2.0

    def nearest(self, spot: tuple[float, float]) -> tuple[float, float]:
        x, y = spot
        return min(max(x, self.left), self.right), min(max(y, self.low), self.high)


class Candidate(NamedTuple):
    """A possible place of a label."""

    box: Box
    anchor: tuple[float, float] | None = None  # what a leader would join to the label
    cost: float = 0.0  # what the caller charges for this place
    key: Any = None  # for the caller; the placer ignores it


class Placer:
    """Places the labels of one picture, in plain floats: most labels stay where they were.

    `ink` returns whether a box, ``(left, low, right, high)``, hides something of the subject. A
    leader is checked for crossings at these parts of its length (`samples`), within `halo_px`.
    """

    def __init__(
        self,
        frame: Box,
        ink: Callable[[float, float, float, float], bool] | None = None,
        samples: Sequence[float] = (0.4, 0.7),
        halo_px: float = 0.0,
    ) -> None:
        self.frame, self._ink, self._samples, self._halo_px = frame, ink, samples, halo_px
        self.taken: list[Box] = []
        """What no label may overlap, and no leader cross."""
        self.bodies: list[Box] = []
        """Those of `taken` that the leader of a point inside them, or `own_px` away, may cross."""
        self.own_px = 0.0

    def place(
        self,
        candidates: Iterable[Candidate],
        apart_from: Sequence[tuple[float, float]] = (),
        apart_px: float = 0.0,
        at_worst: float = math.inf,
    ) -> Candidate | None:
        """Take the cheapest free candidate, and return it with its total cost.

        Candidates come in order of their own costs, so that most need not be looked at. The label
        keeps `apart_px` from the points `apart_from`, which it must not seem to belong to. A higher
        cost than `at_worst` is not accepted.
        """
        frame_left, frame_low, frame_right, frame_high = self.frame
        found: Candidate | None = None
        for candidate in candidates:
            left, low, right, high = box = candidate.box
            if left < frame_left or low < frame_low or right > frame_right or high > frame_high:
                continue
            for t_left, t_low, t_right, t_high in self.taken:
                if left < t_right and right > t_left and low < t_high and high > t_low:
                    break
            else:
                is_near = False
                for x, y in apart_from:  # most are far away: nothing is called for them
                    if left - x < apart_px > x - right and low - y < apart_px > y - high:
                        is_near |= math.dist(box.nearest((x, y)), (x, y)) < apart_px
                if is_near:
                    continue
                cost = candidate.cost
                if self._ink is not None and self._ink(left, low, right, high):
                    cost += INK
                elif candidate.anchor is not None and self._crosses(candidate.anchor, box):
                    cost += LEADER
                if cost == candidate.cost and (found is None or cost < found.cost):
                    found = candidate
                    break
                if found is None or cost < found.cost:
                    found = candidate._replace(cost=cost)
        if found is None or found.cost > at_worst:
            return None
        self.taken.append(found.box)
        return found

    def _crosses(self, anchor: tuple[float, float], box: Box) -> bool:
        """Whether a leader would seem to belong to something else that it runs under."""
        (x, y), (end_x, end_y), halo = anchor, box.nearest(anchor), self._halo_px
        near = Box(x - self.own_px, y - self.own_px, x + self.own_px, y + self.own_px)
        own = [b for b in self.bodies if b.left <= near.right and b.right >= near.left
               and b.low <= near.high and b.high >= near.low]  # fmt: skip
        for part in self._samples:
            on_x, on_y = x + part * (end_x - x), y + part * (end_y - y)
            for taken in self.taken:
                left, low, right, high = taken
                within = left - halo < on_x < right + halo and low - halo < on_y < high + halo
                if within and taken not in own:
                    return True
        return False


def beside(
    points: Floats, sizes: Floats, frame: Floats, along: Floats, gaps: Floats, taken: Floats
) -> list[Floats | None]:
    """Place the names of points; None where a name or its leader has no free place.

    Parameters
    ----------
    points, sizes : (n, 2) arrays
        In pixels; the first ones choose first. A name without width gets no place.
    frame, taken : (4,) and (k, 4) arrays
        Left, low, right, high: where names may be, and boxes of other names; so is the result.
    along : (m, 2) array
        Places along curves, which no name hides.
    gaps : (n,) array
        From each point to its name.
    """
    samples = np.linspace(0.1, 0.9, 8)
    placer = Placer(Box(*frame.tolist()), samples=samples.tolist(), halo_px=1.0)
    reach = gaps[:, None] - 1.0
    placer.bodies = _boxes(np.hstack([points - reach, points + reach]))
    placer.taken = [*_boxes(taken), *placer.bodies]
    crossed = np.hstack([along - 1.0, along + 1.0])
    steps = np.repeat(np.arange(_STEPS), len(_DIRECTIONS))
    directions = np.tile(_DIRECTIONS, (_STEPS, 1))
    found: list[Floats | None] = []
    for point, size, gap in zip(points, sizes, gaps, strict=True):
        centres = point + directions * (size / 2.0 + gap + size[1] * steps[:, None])
        # To the side of a point a name need not be farther up too.
        centres[steps == 0, 1] -= (directions * gap)[steps == 0, 1]
        boxes = np.hstack([centres - size / 2.0, centres + size / 2.0])
        usable = ~_overlap(boxes, crossed).any(axis=1)
        anchor = float(point[0]), float(point[1])
        placer.own_px = float(gap) + 1.0  # dots of one cluster do not block each other's leaders
        candidates = (
            Candidate(box, anchor, key=step)
            for box, step in zip(_boxes(boxes[usable]), steps[usable].tolist(), strict=True)
        )
        chosen = placer.place(candidates, at_worst=0.0) if size[0] > 0.0 else None
        found.append(None if chosen is None else np.array(chosen.box))
        if chosen is not None and chosen.key:  # later names keep off its leader, except at the dot
            ends = samples[2:, None] * (np.array(chosen.box.nearest(anchor)) - point) + point
            placer.taken += _boxes(np.hstack([ends - 1.0, ends + 1.0]))
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
    """Place a curve's name beside the curve, free of other names and of curves, if possible.

    Without a free place the name goes into a list at the top left.

    Parameters
    ----------
    frame : (4,) array
        Left, top, right, bottom: where names may be; so are all boxes.
    along : (n, 2) array
        Places along the curve, which is `half` pixels wide on either side.
    taken, lines : (m, 4) and (k, 4) arrays
        Boxes of other names, and of pieces of all curves.
    kept : (4,) array, optional
        The name's last place, which is kept while it is free and beside its curve.
    """
    width, height = size
    placer = Placer(Box(*frame.tolist()))
    placer.taken = _boxes(taken)
    if kept is not None and np.abs(kept[2:] - kept[:2] - size).max() < 1e-3:
        near = kept + height * np.array([-1.0, -1.0, 1.0, 1.0])
        if _overlap(near[None], np.hstack([along, along])).any() and (
            not _overlap(kept[None], lines).any()
            and placer.place([Candidate(Box(*kept.tolist()))]) is not None
        ):
            return kept
    right, left = GAP_PX + half - 1.0, 1.0 - half - width  # a line touches its name, a dot does not
    sides = np.array([(right, -height), (left, -height), (right, 1.0), (left, 1.0)])
    corners = (along[::-1, None, :] + sides).reshape(-1, 2)  # from the right, where curves part
    boxes = np.hstack([corners, corners + size])
    costs = _overlap(boxes, lines).sum(axis=1)
    order = np.argsort(costs, kind="stable")
    candidates = (Candidate(Box(*boxes[i].tolist()), cost=float(costs[i])) for i in order)
    chosen = placer.place(candidates)
    if chosen is not None:
        return np.array(chosen.box)
    left, top = frame[:2] + GAP_PX
    box = np.array([left, top, left + width, top + height])
    while _overlap(box[None], taken).any() and box[3] < frame[3]:
        box += (0.0, height, 0.0, height)
    return box


def _boxes(rows: Floats) -> list[Box]:
    return [Box(*row) for row in rows.tolist()]


def _overlap(boxes: Floats, others: Floats) -> NDArray[np.bool_]:
    left, low, right, high = boxes.T[:, :, None]
    other_left, other_low, other_right, other_high = others.T[:, None, :]
    across = (left < other_right) & (other_left < right)
    return np.asarray(across & (low < other_high) & (other_low < high))
