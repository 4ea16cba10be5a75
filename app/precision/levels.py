"""Arithmetic precisions for projecting points, and bounds on their errors.

==========  =================================================================================
float32     as on a GPU: the concatenated matrix and the points rounded to 24 bits
float64     `Projection.trace`: eye first, closed form
exact       double-double with a running error bound, rounded once; rationals where the bound
            does not decide the rounding. Every number is within 0.5001 ulp of the true value
==========  =================================================================================

The error of a precision is bounded before anything is computed, from the roundings of its
operations (Higham, Accuracy and Stability of Numerical Algorithms, 3.1) and the sizes of the
rounded numbers. Every point has its own bound, in the time of projecting it once or twice. The
bound is some ten times the largest error found, and infinite where a rounding can bring w to 0.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from decimal import ROUND_CEILING, Context
from fractions import Fraction
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.arithmetic import double_double as dd
from app.arithmetic.double_double import DoubleDouble
from app.arithmetic.formats import Quotients
from app.model.chain import WorldPoints
from app.model.infinity import trace_at_infinity
from app.model.limits import check_name
from app.model.pipeline import empty_trace
from app.model.projection import Array, Projection, Space, Trace, Vector

Precision: TypeAlias = Literal["float32", "float64", "exact"]
PRECISIONS: tuple[Precision, ...] = ("float32", "float64", "exact")  # from cheapest to most exact

DRAWING_TOLERANCE_PX = 0.01  # default error up to which `float32` draws; above it, `float64` does
LEAST_TOLERANCE_PX, LARGEST_TOLERANCE_PX = 1e-4, 100.0  # limits of this setting
READING_TOLERANCE_PX = 1e-9  # error of float64 above which displayed numbers are computed exactly
READING_TOLERANCE_DEPTH = 1e-12

_UNIT_32, _UNIT_64 = 2.0**-24, 2.0**-53
_LARGEST_32, _LEAST_32 = 2.0**127, 2.0**-126  # the largest with room for a sum
_CHUNK = 8192
CERTAIN = 2.0**-16  # of an ulp: below this bound, computing with rationals is not worthwhile
_ROUNDED_UP = 1.0 + 2.0**-10  # for products of roundings, and for those of the bounds themselves


class Prediction(NamedTuple):
    """Bounds on a precision's largest errors: of x or y in pixels, and of the depth in [0, 1]."""

    px: float
    depth: float


def rounded_up(bound: float, digits: int) -> float:
    """Round a bound to so many digits, never below it."""
    return float(Context(digits, ROUND_CEILING).create_decimal(bound))


# --------------------------------------------------------------------------- bounds


def predict(
    projection: Projection,
    points: ArrayLike,
    origin: Vector = (0.0, 0.0, 0.0),
    space: Space = "world",
) -> dict[Precision, Prediction] | None:
    """Bound the largest error of every precision over points, from the roundings of its operations.

    All points (n, 3) in front of the eye plane count, whether they are in the view volume or not;
    None if no point has a picture. `origin`, in the same space, is the point from which the GPU's
    vertices are measured.
    """
    placed = projection.placed(points, space)
    given = np.reshape(points, (-1, 3))
    bounds = _Bounds(projection, origin, space)
    with np.errstate(all="ignore"):
        blocks = (slice(start, start + _CHUNK) for start in range(0, len(given), _CHUNK))
        every = (bounds.of(placed.part(block), given[block]) for block in blocks)
        known = [errors for errors in every if errors is not None]
    if not known:
        return None
    largest = np.max(known, axis=0)
    largest[np.isnan(largest)] = math.inf
    return {
        precision: Prediction(max(x_px, y_px), depth)
        for precision, (x_px, y_px, depth) in zip(PRECISIONS, largest.tolist(), strict=True)
    }


class _Bounds:
    """Bounds the errors of every precision under one projection.

    The *numerators* are the dividends and the divisor: x, y of clip space, depth times w, and w.
    """

    def __init__(self, projection: Projection, origin: Vector, space: Space) -> None:
        self._projection, self._space = projection, space
        self._origin = np.reshape(origin, (3, 1))
        self._single = _single_sizes(projection, projection.local_to_eye(origin, space))
        lens, passage = projection.lens, projection.passage
        self._rows, axes = (part.copy() for part in passage.stated_in)
        self._axes = np.ascontiguousarray(axes[:3, :3])
        sizes = lens.cell_sizes(self._rows)
        self._rows[2], sizes[2] = passage.depth_terms
        roundings = np.array(lens.roundings)[:, None]
        cells = np.maximum(sizes, np.abs(self._rows))
        by_distance = np.column_stack([cells[:, :3].sum(axis=1), cells[:, 3]])
        # Rows: the error of float64 in each numerator, that of the product in `of`, and the least
        # certain w. Columns: the view, the depth's numerator, the distance from the eye, 1, and the
        # error of the points themselves.
        self._weights = np.zeros((8, 7))
        self._weights[:4, [0, 1, 2, 5]] = _UNIT_64 * roundings * sizes
        self._weights[2, 3] = _UNIT_64 * roundings[2, 0]
        self._weights[:4, 4] = passage.view_error * by_distance[:, 0]
        self._weights[:4, 5] += dd.UNDERFLOW
        self._weights[:4, 6] = by_distance[:, 0]
        self._weights[4:7, 4:6] = 2.0**-48 * by_distance[:3]
        self._weights[7, 4:6] = 2.0**-38 * by_distance[3]

    def of(self, world: WorldPoints, given: Array) -> Array | None:
        """The largest errors of x, y in pixels and of the depth, for each of `PRECISIONS`, (3, 3).

        None if no point has a picture. `given` are the points as the GPU has them, (n, 3).
        """
        columns = np.ascontiguousarray(given.T)
        offset = world.nearest_offset(self._projection.camera.eye)
        view = self._axes @ offset
        clip = self._rows[:, :3] @ view + self._rows[:, 3:]
        w = clip[3].copy()
        sizes = np.empty((7, len(given)))
        np.abs(view, out=sizes[:3])
        np.abs(clip, out=clip)
        sizes[3] = clip[2]
        np.abs(offset, out=offset).sum(axis=0, out=sizes[4])
        sizes[4] += 1e30 * dd.UNDERFLOW  # below, 2^-100 of it underflows
        sizes[5], sizes[6] = 1.0, world.lost
        weighed = self._weights @ sizes
        numerators = np.add(clip[:3], weighed[4:7], out=clip[:3])
        certain = clip[3] > np.maximum(weighed[7], 1e-290 * numerators.max())
        seen = certain & (w > 0.0)
        if not certain.all():
            traced = self._projection.trace(given[~certain], self._space)
            w[~certain], seen[~certain] = traced.clip[:, 3], traced.in_front
        if not seen.any():
            return None
        local = np.abs(columns - self._origin)
        if not seen.all():
            parts = numerators, w, weighed, local
            numerators, w, weighed, local = (part[..., seen] for part in parts)
        w *= 1.0 - 2.0**-10  # the product's error
        quotients = numerators * (1.0 / w)
        largest = quotients.max(axis=1)
        lost = _lost_single(self._single, local)
        single = _divided(self._projection, quotients, w, lost, _UNIT_32) + _LEAST_32
        if not largest.max() < 2.0**110:  # overflows float32 in pixels
            single = np.full(3, math.inf)
        double = _divided(self._projection, quotients, w, weighed[:4], _UNIT_64)
        width, height = self._projection.image_size
        rounded = (largest + np.array([1.0, 1.0, 0.0])) * [width / 2.0, height / 2.0, 1.0]
        exact = np.where(np.isfinite(double), 0.5001 * np.spacing(rounded), math.inf)
        return np.stack([single, double, exact])


def _with_depth(projection: Projection, clip: Array) -> Array:
    """Rows of clip space with the depth's numerator instead of z."""
    rows = clip.copy()
    rows[2] = projection.image_from_ndc[2, 2:] @ clip[2:]
    return rows


def _divided(projection: Projection, quotients: Array, w: Array, lost: Array, unit: float) -> Array:
    """The largest errors of x, y in pixels and of the depth, (3,); infinite if w may be 0."""
    off = _lost_dividing(quotients, w, lost, unit)
    return _on_the_screen(projection, off.max(axis=1, keepdims=True), unit)[:, 0]


def _lost_dividing(quotients: Array, w: Array, lost: Array, unit: float) -> Array:
    """Bounds of the errors of the quotients, (3, n), with their own rounding.

    - `quotients` (3, n) or (3, 1): upper bounds of their sizes.
    - `w` (n,): lower bounds; the result is infinite where w may be 0.
    - `lost` (4, n): errors of the numerators before the divide.
    - `unit`: half the distance from 1 to the next larger number.
    """
    rest = w - lost[3]
    if not rest.min() > 0.0:
        rest = np.where(rest > 0.0, rest, 0.0)
        lost = np.maximum(lost, np.finfo(np.float64).tiny)  # or 0/0 would be no bound
    with np.errstate(divide="ignore", over="ignore"):
        inverse = 1.0 / rest
        off: Array = lost[:3] * inverse
        off += quotients * (lost[3] * inverse + 3.0 * unit)
    return off


def _on_the_screen(projection: Projection, off: Array, unit: float) -> Array:
    """Errors of x, y and depth after the divide, (3, n), in pixels and as depths in [0, 1].

    The sum with 1 and the product with half a side are two more roundings.
    """
    width, height = projection.image_size
    summed = np.array([[1.0], [1.0], [float(projection.depth == "opengl")]])
    sizes = np.array([[width / 2.0], [height / 2.0], [1.0]])
    return np.asarray(_ROUNDED_UP * sizes * (off + 2.0 * unit * summed) + dd.UNDERFLOW)


def _single_sizes(projection: Projection, local_to_eye: Array) -> Array:
    """Sizes of the cells of a GPU's matrix, (4, 4): rows x, y, depth and w, for `_lost_single`.

    They include the float64 errors of the cells: 2^-27 of the terms of their sums.
    """
    sizes = np.abs(projection.clip_from_eye @ local_to_eye)
    return _with_depth(projection, sizes + 2.0**-27 * cell_terms(projection, local_to_eye))


def cell_terms(projection: Projection, local_to_eye: Array) -> Array:
    """Sizes of the terms whose sums are the cells of a GPU's matrix, (4, 4)."""
    cells, axes = projection.passage.stated_in
    return np.asarray(projection.lens.cell_sizes(cells) @ np.abs(axes) @ np.abs(local_to_eye))


def _lost_single(sizes: Array, local: Array) -> Array:
    """Bounds of float32's errors of x, y, depth and w before the divide, (4, n).

    `sizes` are `_single_sizes`, and `local`, (3, n), the sizes of the coordinates from the origin.

    A clip coordinate is a sum of four products: 2 u from the rounded factors, 1 from the product
    and 3 from the sums, each of the sum of the products' sizes. A number below float32's least one
    may be lost completely; one beyond its largest is.
    """
    largest = local.max()
    least = _LEAST_32 / _UNIT_32 * (sizes.sum(axis=1)[:, None] + 3.0 * largest + 4.0)
    lost: Array = 6.0 * _UNIT_32 * sizes[:, :3] @ local
    lost += 6.0 * _UNIT_32 * (sizes[:, 3:] + least)
    if not max(largest, sizes.max(), lost.max() / (6.0 * _UNIT_32)) < _LARGEST_32:
        lost[:] = math.inf
    return lost


# --------------------------------------------------------------------------- choice


def drawing_bounds_px(
    projection: Projection, parts: Iterable[tuple[Array, Space]], origin: Vector = (0.0, 0.0, 0.0)
) -> list[float]:
    """Bound the `float32` errors, in pixels, in the visible part of each box, from its corners.

    This is `predict`'s bound for the largest coordinates and the least w; visible NDC coordinates
    are at most 1. It is fast enough for every step of a slider, and coarse: up to a hundred times
    the error.

    Each box (8, 3) must contain its objects completely: an edge may be as wrong as either of its
    ends. `origin`, in the same space, is the point from which the GPU's vertices are measured. The
    parts are boxes (n, 8, 3), each in its space.
    """
    clips, losses = [np.empty((0, 8, 4))], [np.empty((4, 0))]
    for boxes, space in parts:
        if len(boxes):
            local, to_eye = boxes - origin, projection.local_to_eye(origin, space)
            matrix, sizes = projection.clip_from_eye @ to_eye, _single_sizes(projection, to_eye)
            losses.append(_lost_single(sizes, np.abs(local).max(axis=1).T))
            clips.append(local @ matrix[:, :3].T + matrix[:, 3])
    clip, lost = np.concatenate(clips), np.concatenate(losses, axis=1)
    if not np.isfinite(lost).all() or not len(clip):
        return [math.inf] * len(clip)
    least_w, seen = np.ones(len(clip)), np.ones(len(clip), dtype=np.bool_)
    if (clip[..., 3] != 1.0).any():
        near = projection.passage.least_w
        least_w = np.maximum(near, _least_w_seen(clip, lost / _UNIT_32))
        seen = (least_w < math.inf) & (clip[..., 3].max(axis=1) >= near)
    off = _lost_dividing(np.ones((3, 1)), least_w, lost, _UNIT_32)
    errors = _on_the_screen(projection, off, _UNIT_32)[:2].max(axis=0)
    bounds: list[float] = np.where(seen, errors, 0.0).tolist()
    return bounds


def _least_w_seen(clip: Array, sizes: Array) -> Array:
    """Lower bounds of w in the visible parts of boxes, (n,); infinite if nothing is visible.

    A box is cut with each side plane of the view volume alone: beside the eye, the visible w is
    much larger than at the nearest corner. `clip`, (n, 8, 4), are the corners, and `sizes`, (4, n),
    the sizes of the terms of their sums.
    """
    x, y, _, w = np.moveaxis(clip, -1, 0)
    beyond = 1e-14 * (sizes[[0, 0, 1, 1]] + sizes[3])
    inside = np.stack([w + x, w - x, w + y, w - y]) + beyond[..., None]
    # All pairs of corners: the edges and diagonals, whose cuts are in the box too.
    a, b = inside[..., :, None], inside[..., None, :]
    here, there = w[..., :, None], w[..., None, :]
    with np.errstate(divide="ignore", invalid="ignore"):
        cut = here + a / (a - b) * (there - here)
    cut = np.where((a >= 0.0) & (b < 0.0), cut, np.where(a >= 0.0, here, np.inf))
    return np.asarray(cut.min(axis=(2, 3)).max(axis=0))


def precision_for_reading(predictions: Mapping[Precision, Prediction] | None) -> Precision:
    """Return the precision of displayed numbers: float64 if it is good enough, else exact."""
    if predictions is None:
        return "float64"
    px, depth = predictions["float64"]
    good = px <= READING_TOLERANCE_PX and depth <= READING_TOLERANCE_DEPTH
    return "float64" if good else "exact"


# --------------------------------------------------------------------------- the precisions


def trace(
    projection: Projection,
    points: ArrayLike,
    precision: Precision = "float64",
    origin: Vector = (0.0, 0.0, 0.0),
    space: Space = "world",
) -> Trace:
    """Follow points (..., 3) of a space through every stage with the arithmetic of a precision.

    `origin` is the point, in the same space, from which the GPU's vertices are measured: for
    `float32` only.

    Raises a `Refusal` for coordinates that are not finite numbers, or an unknown precision.
    """
    check_name("precision", precision, PRECISIONS)
    if precision == "float64":
        return projection.trace(points, space)
    placed = projection.placed(points, space)
    given = np.reshape(np.asarray(points, dtype=np.float64), (-1, 3))
    with np.errstate(all="ignore"):
        if precision == "float32":
            traced = _trace_float32(projection, placed, given, origin, space)
        else:
            traced = _trace_exact(projection, placed, given, space)
    shape = np.shape(points)[:-1]
    return Trace._make(part.reshape(shape + part.shape[1:]) for part in traced)


def trace_homogeneous(
    projection: Projection,
    points: ArrayLike,
    precision: Precision = "float64",
    space: Space = "world",
) -> Trace:
    """Follow points, w = 1, and directions, w = 0, through every stage; `points` are (n, 4).

    Directions are always exact. `world` and `view` of the result have four numbers each.
    """
    given = np.asarray(points, dtype=np.float64)
    whole = empty_trace(given.copy())
    finite = given[:, 3] != 0.0
    if finite.any():
        which: Any = slice(None) if finite.all() else finite
        traced = trace(projection, given[which, :3], precision, space=space)
        _fill(whole, which, traced, 1.0)
    if not projection.has_camera:  # a typed view matrix may give directions a w of their own
        for i in np.flatnonzero(~finite).tolist():
            direction = given[i, :3].tolist()
            if space == "object":
                direction = projection.placement.exactly(direction, 0)
            for column, part in zip(whole, trace_at_infinity(projection, direction), strict=True):
                column[i] = part
    elif not finite.all():
        directions = given[~finite, :3]
        placed = projection.placed(directions, space, 0)
        with np.errstate(all="ignore"):
            traced = _trace_exact(projection, placed, directions, space, 0)
        _fill(whole, ~finite, traced, 0.0)
    return whole


def _fill(whole: Trace, which: Any, traced: Trace, w: float) -> None:
    """Fill some points of a trace with those of another, whose w in world and view is missing."""
    for part, full in zip(traced, whole, strict=True):
        if part.shape[1:] == full.shape[1:]:
            full[which] = part
        else:
            full[which, :3], full[which, 3] = part, w


def _trace_float32(
    projection: Projection, placed: WorldPoints, given: Array, origin: Vector, space: Space
) -> Trace:
    single = np.float32
    passage, local_origin = projection.passage, np.reshape(origin, (3, 1))
    matrix = projection.clip_from_local(origin, space).astype(single)
    width, height = (single(side / 2.0) for side in projection.image_size)
    one, half = single(1.0), single(0.5)
    traced = empty_trace(placed.world)
    for start in range(0, len(given), _CHUNK):
        block = slice(start, start + _CHUNK)
        local = (np.ascontiguousarray(given[block].T) - local_origin).astype(single)
        offset = placed.part(block).nearest_offset(projection.camera.eye).astype(single)
        view = passage.view_of(offset)
        clip = matrix[:, :1] * local[0]
        for j in (1, 2):
            clip += matrix[:, j : j + 1] * local[j]
        clip += matrix[:, 3:]
        x, y, _, w = clip
        ndc = clip[:3] / w
        right, down = (ndc[0] + one) * width, (one - ndc[1]) * height
        depth = half * ndc[2] + half if projection.depth == "opengl" else ndc[2]
        seen = (w > 0.0) & np.isfinite(ndc).all(axis=0) & np.isfinite(right) & np.isfinite(down)
        outside = (*passage.beyond(view, clip), x < -w, x > w, y < -w, y > w)
        rows = (*view, *clip, *ndc, right, down, depth, seen, *outside)
        _keep(Trace._make(part[block] for part in traced), rows)
    return traced


def _keep(traced: Trace, rows: Sequence[Array]) -> None:
    """Store everything that follows from `world`, one row each; NaN where there is no picture."""
    columns = iter(rows)
    for part in traced[1:]:
        for column in part.reshape(len(part), math.prod(part.shape[1:])).T:
            column[:] = next(columns)
    if not traced.in_front.all():
        for array in (traced.ndc, traced.image, traced.depth):
            array[~traced.in_front] = np.nan


# --------------------------------------------------------------------------- exact


def _divide(projection: Projection, clip: list[Any]) -> list[Any]:
    """Return NDC, image and depth, 3 + 2 + 1, from clip coordinates with w > 0."""
    x, y, z, w = clip
    x_ndc, y_ndc, z_ndc = x / w, y / w, z / w
    depth = (z + w) / (w * 2) if projection.depth == "opengl" else z_ndc
    half_width, half_height = (Fraction(side, 2) for side in projection.image_size)
    return [x_ndc, y_ndc, z_ndc, (x_ndc + 1) * half_width, (-y_ndc + 1) * half_height, depth]


@dataclass(frozen=True, eq=False)
class _Bounded:
    """A double-double array with a bound on its absolute error, usable like a number."""

    value: DoubleDouble
    error: Array

    def _made(self, value: DoubleDouble, error: Array) -> "_Bounded":
        return _Bounded(value, error + dd.RELATIVE_ERROR * np.abs(value.hi))

    def __neg__(self) -> "_Bounded":
        return _Bounded(DoubleDouble(-self.value.hi, -self.value.lo), self.error)

    def __add__(self, other: Any) -> "_Bounded":
        other = _bounded(other)
        return self._made(dd.add(self.value, other.value), self.error + other.error)

    def __sub__(self, other: Any) -> "_Bounded":
        return self + -_bounded(other)

    def __mul__(self, other: Any) -> "_Bounded":
        other = _bounded(other)
        mine, its = np.abs(self.value.hi) + self.error, np.abs(other.value.hi)
        return self._made(
            dd.multiply(self.value, other.value),
            mine * other.error
            + its * self.error
            + dd.UNDERFLOW * (mine * (its + other.error) != 0.0),
        )

    def __truediv__(self, other: Any) -> "_Bounded":
        other = _bounded(other)
        quotient = dd.divide(self.value, other.value)
        least = np.abs(other.value.hi) - other.error
        error = (self.error + np.abs(quotient.hi) * other.error) / least * (1.0 + 1e-9)
        error = error + dd.UNDERFLOW * (np.abs(self.value.hi) + self.error > 0.0)  # 0/w is 0
        return self._made(quotient, np.where(least > 0.0, error, math.inf))


def _bounded(number: Any) -> _Bounded:
    """Convert an exact scalar to an array without dimensions."""
    if isinstance(number, _Bounded):
        return number
    hi, lo = dd.from_exact(Fraction(number))
    error = abs(lo) * 2.0**-52
    return _Bounded(DoubleDouble(np.asarray(hi), np.asarray(lo)), np.asarray(error))


def _trace_exact(
    projection: Projection, placed: WorldPoints, given: Array, space: Space, one: int = 1
) -> Trace:
    numbers, _, outside = exact_numbers(projection, placed, given, space, one)
    traced = empty_trace(placed.world)
    seen = (numbers[6] > 0.0) & np.isfinite(numbers[7:]).all(axis=0)
    _keep(traced, (*(numbers + 0.0), seen, *outside))
    return traced


def exact_numbers(
    projection: Projection, placed: WorldPoints, given: Array, space: Space, one: int = 1
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Rows: view 3, clip 4, NDC 3, image 2, depth; rounding errors of the last 3; outside 6.

    `one` is w: 0 for directions.
    """
    passage, count = projection.passage, len(given)
    numbers, rests = np.empty((13, count)), np.empty((3, count))
    outside = np.empty((6, count), dtype=bool)
    for start in range(0, count, _CHUNK):
        block = slice(start, start + _CHUNK)
        parts, error = passage.coordinates(placed.part(block), one)
        x, y, z = (_Bounded(part, error) for part in parts)
        first = passage.clipped(x, y, z, one)
        doubtful = np.zeros(len(error), dtype=bool)
        w = first[6]
        in_front = ~(w.value.hi + w.error <= 0.0)  # else there is no picture to round
        for row, number in enumerate(first[:7] + _divide(projection, first[3:7])):
            numbers[row, block] = number.value.hi
            if row >= 10:
                rests[row - 10, block] = number.value.lo
            rounds = number.error <= CERTAIN * np.spacing(np.abs(number.value.hi))
            doubtful |= ~rounds if row < 7 else in_front & ~rounds
        for plane, number in enumerate(first[7:]):
            outside[plane, block] = number.value.hi < 0.0
            doubtful |= ~((number.error < np.abs(number.value.hi)) | (number.error == 0.0))
        which = start + np.flatnonzero(doubtful)
        if len(which):
            rationals = _rational_numbers(projection, given[which], space, one)
            numbers[:, which], rests[:, which], outside[:, which] = rationals
    return numbers, rests, outside


def _rational_numbers(
    projection: Projection, given: Array, space: Space, one: int
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Compute `exact_numbers` in rationals, each number rounded once."""
    passage, point = projection.passage, tuple(map(Quotients.of, given.T))
    if space == "object":
        point = projection.placement.exactly(point, one)
    x, y, z = passage.exact_coordinates(point, one)
    first = passage.clipped(x, y, z, one)
    exact = first[:7] + _divide(projection, first[3:7])
    numbers = np.array([number.floats() for number in exact])
    rests = np.full((3, len(given)), np.nan)
    for true, row, rest in zip(exact[10:], numbers[10:], rests, strict=True):
        known = np.isfinite(row)
        rest[known] = (true - Quotients.of(np.where(known, row, 0.0))).floats()[known]
    return numbers, rests, np.array([number.is_negative() for number in first[7:]])
