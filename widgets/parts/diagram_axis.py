"""The axes of a diagram, and the parts of its curves inside its window; numbers only."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.scenes.phenomena.words import Curve

Floats = NDArray[np.float64]

_BREAK = np.full((1, 2), math.nan)  # separates lines
_FAR = 1e6  # largest distance in windows; a farther end only gives the direction, to keep precision

# --------------------------------------------------------------------------- ticks


def round_ticks(low: float, high: float, most: int) -> list[float]:
    """Return at most `most` (at least 2) multiples of 1, 2 or 5 times a power of ten.

    They are the nearest floats to the decimals: 0.3, never 0.30000000000000004.
    """
    reach = high - low
    if not (0.0 < reach < math.inf):
        return []
    exponent = math.floor(math.log10(reach / most))
    for digit, power in ((d, exponent + e) for e in (0, 1) for d in (1, 2, 5)):
        step = digit * 10.0**power
        first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
        if last - first < most:
            return [float(f"{count * digit}e{power}") for count in range(first, last + 1)]
    return []


def decade_ticks(low: float, high: float, most: int) -> list[float]:
    """Return powers of ten between two positive numbers, and 2 and 5 times them if they fit."""
    first, last = math.ceil(math.log10(low) - 1e-9), math.floor(math.log10(high) + 1e-9)
    between = [
        float(f"{digit}e{power}") for power in range(first - 1, last + 1) for digit in (1, 2, 5)
    ]
    between = [value for value in between if low <= value <= high]
    if 2 <= len(between) <= most:
        return between
    step = -(-(last - first + 1) // most)
    decades = [float(f"1e{power}") for power in range(first, last + 1) if power % step == 0]
    return decades if last > first else round_ticks(low, high, most)


@dataclass(frozen=True)
class DiagramAxis:
    low: float
    high: float
    log: bool
    ticks: Sequence[float] | None

    @property
    def usable(self) -> bool:
        """Whether the axis has a valid, non-empty range."""
        low, high = self.unit_ends
        return math.isfinite(high - low) and low != high

    @property
    def unit_ends(self) -> tuple[float, float]:
        if not self.log:
            return self.low, self.high
        low, high = (math.log10(end) if end > 0.0 else math.nan for end in (self.low, self.high))
        return low, high

    def unit(self, values: Floats) -> Floats:
        """Return the places of numbers between the ends, 0 to 1; NaN if there is none."""
        low, high = self.unit_ends
        with np.errstate(all="ignore"):
            along = np.log10(values) if self.log else values
            places: Floats = (along - low) / (high - low)
        places[~np.isfinite(places)] = np.nan
        return places

    def given(self) -> list[float]:
        """Return the diagram's own ticks within the ends."""
        low, high = sorted((self.low, self.high))
        return [float(tick) for tick in self.ticks or () if low <= tick <= high]

    def marks(self, most: int) -> list[float]:
        """Return at most `most` round numbers within the ends."""
        low, high = sorted((self.low, self.high))
        return (decade_ticks if self.log else round_ticks)(low, high, max(2, most))


# --------------------------------------------------------------------------- lines


def segments(points: Floats) -> tuple[Floats, NDArray[np.intp]]:
    """Return the parts of a polyline (n, 2) inside the unit square; NaN breaks the line.

    The results are the ends (m, 2, 2) of the parts, and the index of the point where each segment
    begins (m,). The method is Liang-Barsky for all segments at once. An end that is more than
    `_FAR` windows away is first moved along the segment towards the other end.
    """
    finite, within = np.asarray(np.isfinite(points).all(axis=1)), inside(points)
    which = np.flatnonzero(finite[:-1] & finite[1:])
    start, end = points[which], points[which + 1]
    if (within[which] & within[which + 1]).all():
        return np.stack([start, end], axis=1), which
    with np.errstate(all="ignore"):
        far = np.maximum(np.abs(end - start).max(axis=1), _FAR)[:, None]
        nearer_start = (np.abs(start).max(axis=1) <= np.abs(end).max(axis=1))[:, None]
        direction = (end - start) * (_FAR / far)
        start = np.where(nearer_start, start, end - direction)
        enter, leave = np.zeros(len(start)), np.ones(len(start))
        possible = np.ones(len(start), dtype=bool)
        for axis in (0, 1):
            for edge in (0.0, 1.0):
                # Inward is + at the lower edge and - at the upper edge.
                inward = direction[:, axis] * (1.0 - 2.0 * edge)
                outside = (edge - start[:, axis]) * (1.0 - 2.0 * edge)
                at = outside / inward
                enter = np.where(inward > 0.0, np.maximum(enter, at), enter)
                leave = np.where(inward < 0.0, np.minimum(leave, at), leave)
                possible &= (inward != 0.0) | (outside <= 0.0)
    kept = possible & (enter <= leave)
    start, direction = start[kept], direction[kept]
    parts = [start + enter[kept, None] * direction, start + leave[kept, None] * direction]
    return np.stack(parts, axis=1), which[kept]


def seen_parts(curves: Sequence[Curve], across: DiagramAxis, up: DiagramAxis) -> list[Floats]:
    """Return the visible part of each curve: segments (m, 2, 2) or dots (m, 2), in window units."""
    rows = [np.empty((0, 2))]
    for curve in curves:
        points = np.asarray(curve.points, dtype=np.float64).reshape(-1, 2)
        rows += [points, points[: curve.closed], _BREAK]
    counts = [len(curve.points) + (curve.closed and len(curve.points) > 0) + 1 for curve in curves]
    all_points = np.concatenate(rows)
    # All at once: a diagram has many curves of few points.
    points = np.stack([across.unit(all_points[:, 0]), up.unit(all_points[:, 1])], axis=1)
    parts, at = segments(points)
    ends = np.cumsum(counts)
    bounds = np.searchsorted(at, ends).tolist()
    seen = []
    for curve, end, count, first, last in zip(
        curves, ends.tolist(), counts, [0, *bounds], bounds, strict=False
    ):
        if curve.dots:
            dots = points[end - count : end]
            seen.append(dots[inside(dots)])
        else:
            seen.append(parts[first:last])
    return seen


def inside(points: Floats) -> NDArray[np.bool_]:
    return np.asarray(((points >= 0.0) & (points <= 1.0)).all(axis=1))  # not for NaN
