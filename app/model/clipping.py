"""Clipping before the divide: segments and convex polygons against the six planes, with w <= 0.

A point of clip space is inside where six sums are not negative (Blinn & Newell, *Clipping Using
Homogeneous Coordinates*, 1978)::

    left  w + x    right w - x    bottom  w + y    top  w - y
    near  s (z - z_near w)        far  s (z_far w - z)        s = sign(z_far - z_near)

so that for ``opengl`` near and far are ``w + z`` and ``w - z``, for ``direct3d`` ``z`` and
``w - z``, for ``reversed`` ``w - z`` and ``z``. A sum of two floats has the exact sign, so rounding
never decides what is inside. Nothing is divided by w: a point behind the eye is just beyond some
planes, and a point at infinity (a direction of world space) is an end like any other. ``left`` and
``right`` together require ``w >= 0``; only `planes` without such a pair can leave a piece behind
the eye.

For comparison, this module also has lecture 004's method, which cuts in view space a little before
the eye plane, and the divide without any cut.
"""

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.languages import said
from app.model.limits import check_name, within
from app.model.projection import DEPTH_RANGES, PLANES, Array
from app.model.refusal import REFUSALS, Refusal

LARGEST_CLIP = 1e307  # largest clip coordinate: sums and differences of four of them stay finite

NOT_CUT = -1  # in `ClippedSegments.planes`: the end is the segment's own

EYE_Z = -0.01
"""z of lecture 004's cut in view space: "a near negative number", not the eye plane's 0."""

# Coordinate and factor of each plane's equation, coordinate = factor * w.
_SIDES = {"left": (0, -1.0), "right": (0, 1.0), "bottom": (1, -1.0), "top": (1, 1.0)}

# Two parameters nearer than this are compared exactly: each is off by at most 4 roundings.
_TIE = 1e-15


class ClippedSegments(NamedTuple):
    """The visible parts of segments; ``...`` is the segments' shape."""

    visible: NDArray[np.bool_]
    """(...): whether any of it is inside; a segment that only touches counts, as one point."""
    t: Array
    """(..., 2): where the visible part begins and ends, from 0 to 1; linear in clip space, and in
    the world too if both ends have the same world w. NaN where nothing is visible."""
    points_clip: Array
    """(..., 2, 4): its ends; a cut end satisfies its plane's equation exactly. NaN where nothing is
    visible."""
    planes: NDArray[np.intp]
    """(..., 2): index in `PLANES` of the plane that cut each end, or `NOT_CUT`. For a segment that
    passes an edge of the volume outside (`outside` all false), the two planes that meet there."""
    outside: NDArray[np.bool_]  # (..., 6): whether the whole segment lies beyond each of `PLANES`


class ClippedPolygon(NamedTuple):
    """The visible part of a convex polygon, in the original order."""

    points_clip: Array  # its corners, (m, 4); m is 0 if no area is left
    edges: tuple[str | None, ...]
    """The plane that made the edge from each corner to the next; None for an original edge."""


class EyeCut(NamedTuple):
    """Segments after lecture 004's cut; ``...`` is their shape."""

    case: NDArray[np.intp]
    """(...), lecture 004's: 1 in front, 2 behind, 3 from behind to the front, 4 to behind."""
    points_view: Array  # (..., 2, 3): the drawn part; NaN in case 2


# --------------------------------------------------------------------------- checks


def _points(field: str, value: ArrayLike, size: int) -> Array:
    """Return finite points in rows of `size`."""
    try:
        given = np.asarray(value)
    except ValueError:  # rows of different lengths
        raise Refusal(field, value, REFUSALS["finite-number"]) from None
    if given.dtype.kind not in "iuf" or given.shape[-1:] != (size,):
        raise Refusal(field, value, REFUSALS["finite-number"])
    points = given.astype(np.float64)
    wrong = ~(np.abs(points) <= LARGEST_CLIP)
    if wrong.any():
        number = float(points[wrong][0])
        if not math.isfinite(number):
            raise Refusal(field, number, REFUSALS["finite-number"])
        within(field, number, -LARGEST_CLIP, LARGEST_CLIP)
    if size == 4:
        zero = ~points.any(axis=-1)
        if zero.any():
            raise Refusal(field, tuple(points[zero][0].tolist()), REFUSALS["not-zero"])
    return points


def _chosen(planes: Iterable[str], depth: str) -> NDArray[np.bool_]:
    """Check the names, and return which of `PLANES` are chosen."""
    check_name("depth", depth, DEPTH_RANGES)
    names = [planes] if isinstance(planes, str) else list(planes)
    for name in names:
        check_name("planes", name, PLANES)
    return np.array([plane in names for plane in PLANES])


def _refuse_opposite(field: str, starts: Array, ends: Array) -> None:
    """Refuse ends p and -k p: they are the same point of space, with no line between them.

    Scaled to their largest coordinate such ends round to opposite numbers.
    """
    opposite = (starts / np.abs(starts).max(axis=-1, keepdims=True)) == -(
        ends / np.abs(ends).max(axis=-1, keepdims=True)
    )
    wrong = opposite.all(axis=-1)
    if wrong.any():
        end = tuple(ends[wrong][0].tolist())
        other = said("the opposite of the segment's other end")
        raise Refusal(field, end, REFUSALS["distinct"], other)


# --------------------------------------------------------------------------- the six planes


def boundaries(points_clip: Array, depth: str) -> Array:
    """Return the six sums of the module's table, (..., 6): negative beyond the plane, 0 on it.

    Those of rationals are rationals.
    """
    x, y, z, w = np.moveaxis(points_clip, -1, 0)
    z_near, z_far = map(int, DEPTH_RANGES[depth])
    sign = 1 if z_far > z_near else -1
    near, far = sign * (z - z_near * w), sign * (z_far * w - z)
    return np.stack([near, far, w + x, w - x, w + y, w - y], axis=-1)


def _cut(
    inside: Array, outside: Array, b_inside: Array, b_outside: Array, plane: str, depth: str
) -> Array:
    """Return the points where segments cross a plane, (..., 4).

    They lie exactly on the plane, and the reversed segment gives the same points.
    """
    total = (b_inside - b_outside)[..., None]
    points = (b_inside[..., None] / total) * outside + (-b_outside[..., None] / total) * inside
    if plane in _SIDES:
        axis, factor = _SIDES[plane]
    else:
        axis, factor = 2, DEPTH_RANGES[depth][plane == "far"]
    points[..., axis] = factor * points[..., 3] + 0.0
    return np.asarray(points)


# --------------------------------------------------------------------------- segments


def clip_segments(
    starts_clip: ArrayLike,
    ends_clip: ArrayLike,
    depth: str = "opengl",
    planes: Iterable[str] = PLANES,
) -> ClippedSegments:
    """Cut segments to the view volume in homogeneous clip space (Liang & Barsky 1984).

    Raises a `Refusal` for another depth range or plane, a coordinate that is not finite or larger
    than `LARGEST_CLIP`, an end of four zeros, or ends that are negative multiples of each other.

    The ends, (..., 4), are those before the divide; any w, 0 for points at infinity of clip space.
    `planes` are names in `PLANES`.

    The crossings are compared by ``b_in/b_out``, which is precise at both ends of the segment; the
    one farthest from each end wins. If the two winners meet within `_TIE`, rational numbers decide
    whether anything is left between them.
    """
    chosen = _chosen(planes, depth)
    starts, ends = np.broadcast_arrays(
        _points("starts_clip", starts_clip, 4), _points("ends_clip", ends_clip, 4)
    )
    _refuse_opposite("ends_clip", starts, ends)
    shape = starts.shape[:-1]
    starts, ends = starts.reshape(-1, 4), ends.reshape(-1, 4)
    b_starts, b_ends = boundaries(starts, depth), boundaries(ends, depth)
    b_starts[:, ~chosen] = b_ends[:, ~chosen] = 1.0

    outside = (b_starts < 0.0) & (b_ends < 0.0)
    t = np.zeros((len(starts), 2))  # measured from either end until the last lines
    t_rest = np.ones((len(starts), 2))  # 1 - t, which has digits of its own
    cut_by = np.full((len(starts), 2), NOT_CUT)
    points = np.stack([starts, ends], axis=1)
    directions = ((starts, ends, b_starts, b_ends), (ends, starts, b_ends, b_starts))
    for side, (here, there, b_here, b_there) in enumerate(directions):
        crossing = (b_here < 0.0) & (b_there >= 0.0)
        (rows,) = np.nonzero(crossing.any(axis=1))
        b_out, b_in = b_here[rows], b_there[rows]
        with np.errstate(over="ignore"):
            ratio = np.where(crossing[rows], b_in, 0.0) / np.where(crossing[rows], -b_out, 1.0)
        # The least ratio is the farthest crossing; an overflowed one still before no crossing.
        ratio = np.where(crossing[rows], np.minimum(ratio, np.finfo(np.float64).max), np.inf)
        which = ratio.argmin(axis=1)
        b_out, b_in = (b[np.arange(len(rows)), which] for b in (b_out, b_in))
        t[rows, side] = b_out / (b_out - b_in)
        t_rest[rows, side] = b_in / (b_in - b_out)
        cut_by[rows, side] = which
        for index in np.unique(which):
            one = which == index
            row = rows[one]
            points[row, side] = _cut(
                there[row], here[row], b_in[one], b_out[one], PLANES[index], depth
            )
    slack = 1.0 - t.sum(axis=1)
    visible = ~outside.any(axis=1) & (slack >= 0.0)
    close = (np.abs(slack) <= _TIE) & (cut_by != NOT_CUT).all(axis=1) & ~outside.any(axis=1)
    for row in np.flatnonzero(close):
        visible[row] = _meets_exactly(starts[row], ends[row], depth, chosen)
    t = np.stack([t[:, 0], np.maximum(t_rest[:, 1], t[:, 0])], axis=1)
    t[~visible], points[~visible] = np.nan, np.nan
    cut_by[outside.any(axis=1)] = NOT_CUT
    return ClippedSegments(
        visible.reshape(shape),
        t.reshape(*shape, 2),
        points.reshape(*shape, 2, 4),
        cut_by.reshape(*shape, 2),
        outside.reshape(*shape, 6),
    )


def _meets_exactly(start: Array, end: Array, depth: str, chosen: NDArray[np.bool_]) -> bool:
    """Whether one segment has a point inside, in rational numbers."""
    low, high = Fraction(0), Fraction(1)
    ends: Any = np.array([list(map(Fraction, point.tolist())) for point in (start, end)])
    for b_start, b_end, asked in zip(*boundaries(ends, depth), chosen, strict=True):
        if not asked or (b_start >= 0 and b_end >= 0):
            continue
        t = b_start / (b_start - b_end)  # ends that are both negative are excluded before
        low, high = (max(low, t), high) if b_start < 0 else (low, min(high, t))
    return low <= high


# --------------------------------------------------------------------------- polygons


def clip_polygon(
    points_clip: ArrayLike, depth: str = "opengl", planes: Iterable[str] = PLANES
) -> ClippedPolygon:
    """Cut a convex polygon to the view volume (Sutherland & Hodgman 1974), in clip space.

    `points_clip`, (n, 4), are its corners in order, before the divide. Arguments and refusals are
    those of `clip_segments`; fewer than 3 corners are refused, too. Two polygons that share an
    edge are cut at the same points of it.
    """
    chosen = _chosen(planes, depth)
    points = _points("points_clip", points_clip, 4)
    if points.ndim != 2 or len(points) < 3:
        raise Refusal("points_clip", len(np.atleast_2d(points)), REFUSALS["at-least"], 3)
    _refuse_opposite("points_clip", points, np.roll(points, -1, axis=0))
    edges: list[str | None] = [None] * len(points)
    for index in np.flatnonzero(chosen):
        plane = PLANES[index]
        boundary = boundaries(points, depth)[:, index]
        if (boundary >= 0.0).all():
            continue
        kept: list[Array] = []
        kept_edges: list[str | None] = []
        for i, edge in enumerate(edges):
            j = (i + 1) % len(edges)
            here, there = boundary[i], boundary[j]
            if here >= 0.0:
                kept.append(points[i])
                # If a corner lies on the plane, the polygon leaves there.
                kept_edges.append(plane if here == 0.0 and there < 0.0 else edge)
            if here > 0.0 > there:
                kept.append(_cut(points[i], points[j], here, there, plane, depth))
                kept_edges.append(plane)
            elif here < 0.0 < there:
                kept.append(_cut(points[j], points[i], there, here, plane, depth))
                kept_edges.append(edge)
        if len(kept) < 3:
            return ClippedPolygon(np.empty((0, 4)), ())
        points, edges = np.array(kept), kept_edges
    return ClippedPolygon(points, tuple(edges))


# --------------------------------------------------------------------------- lecture 004's method


def cut_at_eye(starts_view: ArrayLike, ends_view: ArrayLike) -> EyeCut:
    """Lecture 004's own clipping: in view space, against one plane in front of the eye.

    A point, (..., 3), is in front where ``z <= EYE_Z``. Cases 3 and 4 are cut at
    ``t = (z_start - EYE_Z)/(z_start - z_end)`` (lecture 004, "Presjek pravca i ravnine").
    """
    starts, ends = np.broadcast_arrays(
        _points("starts_view", starts_view, 3), _points("ends_view", ends_view, 3)
    )
    z_start, z_end = starts[..., 2], ends[..., 2]
    front_start, front_end = z_start <= EYE_Z, z_end <= EYE_Z
    case = np.select(
        [front_start & front_end, ~front_start & ~front_end, front_end], [1, 2, 3], default=4
    )
    crosses = case > 2
    span = np.where(crosses, z_start - z_end, 1.0)
    of_start, of_end = (EYE_Z - z_end) / span, (z_start - EYE_Z) / span
    crossing = of_start[..., None] * starts + of_end[..., None] * ends
    crossing[..., 2] = EYE_Z
    points = np.stack(
        [
            np.where((case == 3)[..., None], crossing, starts),
            np.where((case == 4)[..., None], crossing, ends),
        ],
        axis=-2,
    )
    points[case == 2] = np.nan
    return EyeCut(case.astype(np.intp), points)


def naive_ndc(points_clip: ArrayLike) -> Array:
    """Divide points (..., 4) by w without a check, as the lecture's first program does.

    A point behind the eye is mirrored through the picture's centre. A segment across the eye plane
    is then drawn as the wrong one of the projective line's two arcs (lecture 004: the one without
    the point at infinity). NaN where w is 0 or so small that the quotient overflows.
    """
    points = _points("points_clip", points_clip, 4)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        ndc = points[..., :3] / points[..., 3:]
    ndc[~np.isfinite(ndc).all(axis=-1)] = np.nan
    return np.asarray(ndc)
