"""Trade 2, interpolation: ns per pixel and triangles against the error in texels.

A texture coordinate t increases linearly along an edge in the world, from 0 to 1. On the screen,
1/w and t/w are linear instead (lectures 002, 003); their quotient is the correct t at every pixel.
The cheap way interpolates t itself linearly on the screen between the points that split the edge.
If the depths of the edge's ends have the ratio r, its largest error is

    (sqrt r - 1) / (sqrt r + 1)

of the edge, at ``s = sqrt r / (1 + sqrt r)`` on the screen. For each of k pieces, r is the ratio
of the piece, and the error is divided by k. A table of reciprocals in place of the division is off
by at most its relative error, because t is at most 1.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from app.arithmetic.formats import FORMATS, RECIPROCALS, reciprocal
from app.measure.results import ChartPoint, Trade, without_numbers
from app.measure.run import Watch, timed, unwatched
from app.model.clipping import clip_segments
from app.model.projection import Array, Projection
from app.model.refusal import MEASURE
from app.scenes.phenomena.interpolation import TEXELS, edge_error

SPLITS = (1, 2, 4, 8, 16, 32, 64)
SAMPLES_A_PIXEL = 16  # sampling density: the largest error may lie between the centres of pixels

AFFINE_BYTES, CORRECT_BYTES = 16.0, 20.0
"""Of a vertex on the screen in float32: x, y, depth and t; correct interpolation adds 1/w."""

_LINE_BYTES = 64  # of a processor's cache

_ROUNDINGS = 32.0 * 2.0**-53
"""Bound of what float64 and the reference lose, in parts of the edge, times its ratio of depths."""


class ClipEdge(NamedTuple):
    """An edge on the screen: its ends (4,) in clip space, both with w > 0, and its length."""

    start: Array
    end: Array
    length_px: float

    @property
    def ratio(self) -> float:
        """The ratio of the depths of its ends, at least 1."""
        near, far = sorted((float(self.start[3]), float(self.end[3])))
        return far / near


def steepest_edge(projection: Projection, corners_world: Array) -> ClipEdge | None:
    """Clip a box's edges to the view volume and return the one whose ends differ most in depth.

    Corner i of `corners_world` (8, 3) has the upper bound of axis a if bit a of i is set.
    """
    pairs = [(i, i | j) for i in range(8) for j in (1, 2, 4) if not i & j]
    starts, ends = projection.trace(corners_world).clip[pairs].swapaxes(0, 1)
    cut = clip_segments(starts, ends, projection.depth)
    half = np.array(projection.image_size) / 2.0
    best: ClipEdge | None = None
    for start, end in cut.points_clip[cut.visible]:
        length = float(np.hypot(*((end[:2] / end[3] - start[:2] / start[3]) * half)))
        edge = ClipEdge(start, end, length)
        if length >= 2.0 and (best is None or edge.ratio > best.ratio):
            best = edge
    return best


def aligned(count: int) -> Array:
    """Return an uninitialised float64 array (count,) at a multiple of 64 bytes.

    Elsewhere the same work takes up to twice as long, by chance.
    """
    room = np.empty(8 * count + _LINE_BYTES, dtype=np.uint8)
    start = -room.ctypes.data % _LINE_BYTES
    return room[start : start + 8 * count].view(np.float64)


def correct(edge: ClipEdge, s: Array) -> Callable[[], Array]:
    """Return a function that finds the perspective-correct texture coordinate at every pixel.

    Set up for screen places s (n,), from 0 to 1. A pixel costs two interpolations and a division.
    """
    one, other = 1.0 / float(edge.start[3]), 1.0 / float(edge.end[3])
    values, below = aligned(len(s)), aligned(len(s))

    def run() -> Array:
        np.multiply(s, other - one, out=below)
        np.add(below, one, out=below)
        np.multiply(s, other, out=values)
        return np.divide(values, below, out=values)

    return run


def tabled(edge: ClipEdge, s: Array, steps: int) -> tuple[Array, float]:
    """Return `correct` with reciprocals from a table, and the bound of the table's error.

    The reciprocals are improved by a number of Newton steps.
    """
    one, other = 1.0 / float(edge.start[3]), 1.0 / float(edge.end[3])
    inverse, relative = reciprocal(s * (other - one) + one, FORMATS["float64"], steps)
    values: Array = s * other * inverse
    return values, float(relative.max())


def affine(edge: ClipEdge, s: Array, splits: int) -> Callable[[], Array]:
    """Return a function that interpolates linearly on the screen between split points.

    s is as for `correct`, in rising order; `splits` pieces have equal lengths in the world. Every
    pixel knows the line of its piece, so it costs one interpolation however many there are.
    """
    t = np.arange(splits + 1) / splits
    one, other = float(edge.start[3]), float(edge.end[3])
    return pieced(t * other / (one + t * (other - one)), t, s)


def pieced(breaks: Array, at_breaks: Array, s: Array) -> Callable[[], Array]:
    """Return a function that interpolates values at breaks on the screen linearly, at s (n,)."""
    steps = np.diff(at_breaks) / np.diff(breaks)
    piece = np.searchsorted(breaks[1:-1], s)
    slopes, starts, values = aligned(len(s)), aligned(len(s)), aligned(len(s))
    slopes[:], starts[:] = steps[piece], (at_breaks[:-1] - steps * breaks[:-1])[piece]

    def run() -> Array:
        np.multiply(s, slopes, out=values)
        return np.add(values, starts, out=values)

    return run


def bound(edge: ClipEdge, splits: int) -> float:
    """Return the largest error of `affine`, in parts of the edge, by the formula above."""
    t = np.arange(splits + 1) / splits
    w = float(edge.start[3]) + t * float(edge.end[3] - edge.start[3])
    ratios = np.maximum(w[1:] / w[:-1], w[:-1] / w[1:])
    return float(edge_error(ratios).max()) / splits


def truth(edge: ClipEdge, s: Array) -> Array:
    """Return t of the edge's point at a screen place, by intersection with the pixel's ray.

    The point ``P + t (Q - P)`` of clip space has the screen coordinate x where
    ``(P_x + t (Q_x - P_x)) = x (P_w + t (Q_w - P_w))``, solved for t in extended precision.
    """
    p, q = edge.start.astype(np.longdouble), edge.end.astype(np.longdouble)
    axis = int(np.argmax(np.abs(q[:2] / q[3] - p[:2] / p[3])))
    low, high = p[axis] / p[3], q[axis] / q[3]
    x = low + s.astype(np.longdouble) * (high - low)
    t = (x * p[3] - p[axis]) / ((q[axis] - p[axis]) - x * (q[3] - p[3]))
    return np.asarray(t.astype(np.float64))


def measure(
    projection: Projection, corners_world: Array, seconds: float = 10.0, watch: Watch = unwatched
) -> Trade:
    """Measure trade 2 on an edge of the scene's bounding box, whose corners are (8, 3)."""
    edge = steepest_edge(projection, corners_world)
    if edge is None:
        return without_numbers("interpolation", "texels", MEASURE["nothing"], "perspective-correct")
    s = aligned(max(2, math.ceil(SAMPLES_A_PIXEL * edge.length_px)))
    s[:] = np.linspace(0.0, 1.0, len(s))
    right = truth(edge, s)
    runs = {"perspective-correct": correct(edge, s)}
    for splits in SPLITS:
        name = f"affine, {splits} pieces" if splits > 1 else "affine"
        runs[name] = affine(edge, s, splits)
    lost = _ROUNDINGS * edge.ratio
    note = MEASURE["parallel"] if edge.ratio == 1.0 else ""
    choices = []
    for (name, run), splits in zip(runs.items(), (0, *SPLITS), strict=True):
        error = TEXELS * float(np.abs(run() - right).max())
        predicted = TEXELS * (lost + (bound(edge, splits) if splits else 0.0))
        use = {
            "scene": "interpolation",
            "settings.interpolation": "affine" if splits else "correct",
            "settings.subdivision": str(splits or 1),
        }
        triangles = {"triangles": 2.0 * max(1, splits)}
        size = AFFINE_BYTES * (splits + 1.0) if splits else 2.0 * CORRECT_BYTES
        choices.append(ChartPoint(name, None, None, error, predicted, triangles, note, use, size))
    for name, steps in RECIPROCALS.items():
        if steps is not None:
            values, off = tabled(edge, s, steps)
            error = TEXELS * float(np.abs(values - right).max())
            choices.append(
                ChartPoint(
                    f"perspective-correct, reciprocal {name}", None, None, error,
                    TEXELS * (lost + off), {"triangles": 2.0}, MEASURE["in-software"],
                    bytes=2.0 * CORRECT_BYTES,
                )
            )  # fmt: skip
    trade = Trade("interpolation", "ns", "texels", tuple(choices), 0)
    # However many pieces there are, a pixel's work is the same: it is timed once.
    same = {name: "affine" for name in runs if name.startswith("affine")}
    once = {name: run for name, run in runs.items() if same.get(name, name) == name}
    return timed(trade, once, seconds, 1e9 / len(s), watch, same)
