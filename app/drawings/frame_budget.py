"""Chooses the quality that holds a target frame time while a control is dragged.

Levels are tried from the finest on. The time of an untried level is estimated from the others, as
a constant plus a part in proportion to what is drawn.
"""

from collections import deque
from collections.abc import Sequence
from typing import NamedTuple

FRAME_MS = 33.0  # default limit of a frame: thirty a second
LARGEST_FRAME_MS = 1000.0

_WINDOW = 40  # a level is judged by this many frames
_HIGH = 0.95  # the share of them that must be in time
_ENOUGH = 0.9  # of the target: with longer frames, one that is not like the others is late
_ROOM = 0.8  # of the target, for what is tried next
_FRAMES_TO_JUDGE = 10
_REMEMBERED = 300  # frames after which a level's time is no longer believed
_SMOOTH_COSTS = 2.0  # times as much as without, until it is known


class FrameQuality(NamedTuple):
    """One quality: with or without smoothing, and a share of the triangles, 0..1."""

    smooth: bool
    share: float

    @property
    def weight(self) -> float:
        return self.share * (_SMOOTH_COSTS if self.smooth else 1.0)


class FrameBudget:
    """Chooses a level frame by frame.

    `levels` run from the finest to the coarsest; `target_ms` is 0 for no limit; `first` is the
    level of the first frame. `is_late` if even the coarsest level exceeds the target.
    """

    def __init__(self, levels: Sequence[FrameQuality], target_ms: float, first: int = 0) -> None:
        self._levels = tuple(levels)
        self.target_ms = target_ms
        self._now, self.level = first, self._levels[first]
        self._count = 0
        self._recent: deque[float] = deque(maxlen=_WINDOW)
        self._known: dict[int, tuple[float, int]] = {}
        self._is_new = first > 0
        self.is_late = False

    @property
    def frame_ms(self) -> float:
        """The time that nearly all frames of this level stay below; 0 before the first one."""
        return self._high() if self._recent else 0.0

    def frame(self, ms: float) -> None:
        """Record how long a frame of the present level took, and choose the next one's level."""
        self._count += 1
        if self.target_ms <= 0.0:
            return
        if self._is_new:  # its triangles went to the graphics card first
            self._is_new = False
            return
        self._recent.append(ms)
        high = self._high()
        self._known[self._now] = high, self._count
        if high > _ENOUGH * self.target_ms:
            coarser = range(self._now + 1, len(self._levels))
            room = _ROOM * self.target_ms
            fitting = [i for i in coarser if self._expected(i) <= room]
            if coarser:
                self._go(fitting[0] if fitting else coarser[-1])
        elif (
            self._now > 0
            and len(self._recent) >= _FRAMES_TO_JUDGE
            and self._expected(self._now - 1) <= _ROOM * self.target_ms
        ):
            self._go(self._now - 1)
        is_coarsest, known = self._now == len(self._levels) - 1, len(self._recent)
        self.is_late = is_coarsest and known >= _FRAMES_TO_JUDGE and high > self.target_ms

    def _high(self) -> float:
        ordered = sorted(self._recent)
        return ordered[int(_HIGH * (len(ordered) - 1))]

    def _go(self, level: int) -> None:
        self._is_new = level not in self._known
        self._now, self.level = level, self._levels[level]
        self._recent.clear()

    def _expected(self, level: int) -> float:
        known = {i: ms for i, (ms, at) in self._known.items() if self._count - at < _REMEMBERED}
        if level in known:
            return known[level]
        weight, here = self._levels[level].weight, self._levels[self._now].weight
        ms = known[self._now]
        # The line through here and another known level; in proportion if there is none.
        others = [i for i in known if self._levels[i].weight != here]
        if not others:
            return ms * weight / here
        other = min(others, key=lambda i: abs(i - level))
        slope = (known[other] - ms) / (self._levels[other].weight - here)
        return ms + max(0.0, slope) * (weight - here)
