"""Cells on the screen, in pixels and depth: which parts of lines and points faces hide."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import TypeAlias

import numpy as np

from app.model.projection import Array

_OPAQUE = 0.995
SAME_DEPTH = 1e-9  # of NDC; a line that lies in a face is drawn
BORDER_PX = 1e-3
_LEAST_PX = 0.25  # of a part of a line between two borders of faces; less is not drawn

Colour: TypeAlias = tuple[float, float, float]  # red, green and blue, 0 to 1
Points: TypeAlias = list[tuple[float, float]]


@dataclass
class ScreenCell:
    """A polygon, polyline or point on the screen: (n, 3), pixels from left and bottom, depth."""

    points: Array
    colour: Colour
    opacity: float
    place: tuple[int, int]
    """The places of its actor and of itself there: what is drawn later covers what is as near."""
    width: float = 0.0
    is_thin: bool = False  # whether it is a line of a ground or of a drawing on a plane
    plane: tuple[float, float, float] = (0.0, 0.0, 0.0)
    low: tuple[float, float, float] = (0.0, 0.0, 0.0)
    high: tuple[float, float, float] = (0.0, 0.0, 0.0)
    flat: list[tuple[float, float]] = field(default_factory=list)
    is_tangled: bool = False  # one of too many crossing faces: only its visible parts are drawn

    @property
    def is_opaque(self) -> bool:
        return self.opacity >= _OPAQUE


def cut(points: Array, plane: Array, closed: bool) -> Array:
    """Return the part of a polygon or a polyline on the positive side of a plane; (n, 4)."""
    sides = points @ plane
    if (sides >= 0.0).all():
        return points
    ends, count = [], len(points)
    for i in range(count if closed else count - 1):
        j = (i + 1) % count
        if sides[i] >= 0.0:
            ends.append(points[i])
        if (sides[i] >= 0.0) != (sides[j] >= 0.0):
            ends.append(points[i] + sides[i] / (sides[i] - sides[j]) * (points[j] - points[i]))
    if not closed and sides[-1] >= 0.0:
        ends.append(points[-1])
    return np.array(ends) if ends else np.empty((0, points.shape[1]))


class Occlusion:
    """Decides which parts of lines and points are hidden, and which faces tint them."""

    def __init__(self, faces: Sequence[ScreenCell]) -> None:
        self._faces = faces
        self._low = np.array([face.low for face in faces]).reshape(-1, 3)
        self._high = np.array([face.high for face in faces]).reshape(-1, 3)

    def before(self, points: Array) -> list[ScreenCell]:
        """The faces whose boxes reach before a box."""
        low, high = points.min(axis=0), points.max(axis=0)
        meet = (self._low[:, :2] <= high[:2]).all(axis=1) & (self._high[:, :2] >= low[:2]).all(
            axis=1
        )
        meet &= self._low[:, 2] < high[2]
        return [self._faces[i] for i in np.flatnonzero(meet).tolist()]

    def hides(self, point: ScreenCell) -> bool:
        ends = np.concatenate([point.points[:1]] * 2)
        return any(face.is_opaque and _covered(face, *ends.tolist()) for face in self.before(ends))

    def seen(self, line: ScreenCell) -> Iterator[ScreenCell]:
        """Yield the parts of a polyline that are seen, in the colours in which they are seen."""
        for begin, end in zip(line.points[:-1], line.points[1:], strict=True):
            tints, hidden = list[tuple[float, float, ScreenCell]](), list[tuple[float, float]]()
            for face in sorted(self.before(np.stack([begin, end])), key=lambda each: each.place):
                part = _covered(face, begin.tolist(), end.tolist())
                if part is not None and face.is_opaque:
                    hidden.append(part)
                elif part is not None:
                    tints.append((*part, face))
            length = math.dist(begin[:2], end[:2]) or 1.0
            for first, last in _rest(hidden):
                marks = sorted(
                    {first, last, *(t for tint in tints for t in tint[:2] if first < t < last)}
                )
                for low, high in pairwise(marks):
                    if high - low < min(1.0, _LEAST_PX / length):
                        continue
                    colour = line.colour
                    for start, stop, face in tints:
                        if start <= low and high <= stop:
                            r, g, b = (
                                c + face.opacity * (f - c)
                                for c, f in zip(colour, face.colour, strict=True)
                            )
                            colour = (r, g, b)
                    ends = np.stack([begin + low * (end - begin), begin + high * (end - begin)])
                    yield replace(line, points=ends, colour=colour)

    def behind(self, line: ScreenCell) -> Iterator[ScreenCell]:
        """Yield the parts of a polyline that are hidden, as long as possible."""
        chain: list[Array] = []
        for begin, end in zip(line.points[:-1], line.points[1:], strict=True):
            parts = (
                _covered(face, begin.tolist(), end.tolist())
                for face in self.before(np.stack([begin, end]))
                if face.is_opaque
            )
            marks = [0.0, *(t for ends in _rest([p for p in parts if p]) for t in ends), 1.0]
            for low, high in zip(marks[::2], marks[1::2], strict=True):
                if (low > 0.0 or high <= low) and len(chain) > 1:
                    yield replace(line, points=np.stack(chain))
                    chain = []
                if high > low:
                    chain = chain or [begin + low * (end - begin)]
                    chain.append(end if high == 1.0 else begin + high * (end - begin))
        if len(chain) > 1:
            yield replace(line, points=np.stack(chain))


def _covered(
    face: ScreenCell, begin: Sequence[float], end: Sequence[float]
) -> tuple[float, float] | None:
    """Return the interval, from 0 to 1, in which a segment runs behind a face, or None."""
    first, last = 0.0, 1.0
    corners = face.flat
    limits = []
    for i, (x, y) in enumerate(corners):
        to_x, to_y = corners[(i + 1) % len(corners)]
        dx, dy = to_x - x, to_y - y
        border = BORDER_PX * (abs(dx) + abs(dy))
        limits.append(
            (
                dx * (begin[1] - y) - dy * (begin[0] - x) - border,
                dx * (end[1] - y) - dy * (end[0] - x) - border,
            )
        )
    a, b, c = face.plane
    limits.append(
        (
            begin[2] - a * begin[0] - b * begin[1] - c - SAME_DEPTH,
            end[2] - a * end[0] - b * end[1] - c - SAME_DEPTH,
        )
    )
    for here, there in limits:
        if here <= 0.0 and there <= 0.0:
            return None
        if here < 0.0:
            first = max(first, here / (here - there))
        elif there < 0.0:
            last = min(last, here / (here - there))
        if last < first:
            return None
    return first, last


def _rest(hidden: Sequence[tuple[float, float]]) -> Iterator[tuple[float, float]]:
    """Yield the gaps between intervals from 0 to 1."""
    at = 0.0
    for first, last in sorted(hidden):
        if first > at + 1e-9:
            yield at, first
        at = max(at, last)
    if at < 1.0 - 1e-9:
        yield at, 1.0
