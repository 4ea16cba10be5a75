"""Arithmetic rungs: how exactly points are projected, and what each rung's error will be.

==========  =================================================================================
float32     as a GPU does it: the concatenated matrix and the points rounded to 24 bits
float64     `Projection.trace`: eye first, closed form
exact       double-double with a running error bound, rounded once; where the bound cannot
            tell how to round, rationals. Within 0.5001 ulp of the true value, every number
==========  =================================================================================

A rung's error depends on how the camera, the lens and the very points cancel: textbook bounds of
it (Higham, Accuracy and Stability of Numerical Algorithms, 3.1) are up to a hundred times too
large. So the two cheap rungs are run on the points at risk and compared with the exact one, whose
own error is known to some digits; that is never too small and hardly too large.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from app import double_double as dd
from app.double_double import DoubleDouble
from app.projection import (
    ONE_OF,
    Array,
    ExactLens,
    Projection,
    ProjectionError,
    Trace,
    Vector,
    checked_points,
)

Rung: TypeAlias = Literal["float32", "float64", "exact"]
RUNGS: tuple[Rung, ...] = ("float32", "float64", "exact")
"""From the cheapest to the most exact."""

DRAWING_TOLERANCE_PX = 0.01
"""Error up to which `float32` may draw, unless another is set; else `float64` does."""
LEAST_TOLERANCE_PX, LARGEST_TOLERANCE_PX = 1e-4, 100.0
"""Between which it can be set: below, no drawing in pixels could hold it."""
READING_TOLERANCE_PX = 1e-9
"""Error of float64 from which numbers are read from the exact rung."""
READING_TOLERANCE_DEPTH = 1e-12

LOOKED_AT = 4096
"""As many points are compared with the exact rung; more than that are sampled."""

_UNIT_32 = 2.0**-24
_LARGEST_32, _LEAST_32 = 2.0**127, 2.0**-126  # the largest with room for a sum
_CHUNK = 8192
_CERTAIN = 2.0**-16  # of an ulp: a bound below it leaves no doubt worth a rational
_ROUNDED_UP = 1.0 + 2.0**-50  # for the roundings of the prediction itself
_UNDERFLOW = 1e-300  # what products near the smallest float64 may lose, and some


class Prediction(NamedTuple):
    """Bounds of the largest errors of a rung over some points.

    Attributes
    ----------
    px : float
        Of x or y in the image, in pixels; ``inf`` where the rung cannot tell.
    depth : float
        Of the depth in [0, 1].
    """

    px: float
    depth: float


class Reference(NamedTuple):
    """The true image and depth of points, to hold other arithmetics' answers against.

    Attributes
    ----------
    numbers : (n, 3) float64 array
        x and y in pixels and depth, by the exact rung; NaN where there is no picture.
    rests : (n, 3) float64 array
        What its rounding cut off.
    """

    numbers: Array
    rests: Array

    @classmethod
    def of(cls, projection: Projection, points_world: ArrayLike) -> Reference:
        """The truth about points (n, 3) in world coordinates."""
        world = checked_points(points_world).reshape(-1, 3)
        with np.errstate(all="ignore"):
            numbers, rests, _ = _exact_numbers(projection, world)
        numbers[~(numbers[:, 6] > 0.0)] = np.nan
        return cls(numbers[:, 10:], rests)

    def errors(self, answers: Array) -> Array:
        """How far answers are off, and what is not known of it.

        Parameters
        ----------
        answers : (n, 3) array
            x and y in pixels and depth.

        Returns
        -------
        (n, 3) array
            NaN where the answer is, or where there is no picture.
        """
        unknown = _CERTAIN * np.spacing(np.abs(self.numbers))
        errors: Array = np.abs((answers - self.numbers) - self.rests) + unknown
        return errors


# --------------------------------------------------------------------------- choice


def predict(
    projection: Projection, points_world: ArrayLike, origin: Vector = (0.0, 0.0, 0.0)
) -> dict[Rung, Prediction] | None:
    """Predict every rung's largest error over points.

    Parameters
    ----------
    projection : Projection
    points_world : (n, 3) array_like
        World coordinates; only those in front of the eye plane count, the others have no picture.
    origin : Vector
        World point from which the GPU's vertices are measured (a scene's origin).

    Returns
    -------
    dict from rung to Prediction, or None if no point has a picture

    Notes
    -----
    Of more than `LOOKED_AT` points, those nearest to the eye plane, where errors grow, and evenly
    chosen others are looked at, and twice their largest error is predicted.
    """
    world = checked_points(points_world).reshape(-1, 3)
    world = world[projection.trace(world).in_front]
    if not len(world):
        return None
    safety = 1.0
    if len(world) > LOOKED_AT:
        half = LOOKED_AT // 2
        nearest = np.argpartition(
            (world - projection.camera.eye) @ -projection.camera.frame[2], half
        )
        even = np.linspace(0, len(world) - 1, half).astype(int)
        world, safety = world[np.concatenate([nearest[:half], even])], 2.0
    reference = Reference.of(projection, world)
    predictions: dict[Rung, Prediction] = {}
    for rung in RUNGS:
        if rung == "exact":
            done = reference.numbers
        else:
            traced = trace(projection, world, rung, origin)
            done = np.column_stack([traced.image, traced.depth])
        errors = reference.errors(done)
        px, depth = (
            math.inf if np.isnan(values).any() else safety * _ROUNDED_UP * float(values.max())
            for values in (errors[:, :2], errors[:, 2])
        )
        predictions[rung] = Prediction(px, depth)
    return predictions


def drawing_bound_px(
    projection: Projection, corners_world: Array, origin: Vector = (0.0, 0.0, 0.0)
) -> float:
    """What `float32` can lose at most in what is seen of a box, from its corners alone.

    Quick enough for every step of a slider, and therefore coarse: up to a hundred times the error.

    Parameters
    ----------
    projection : Projection
    corners_world : (8, 3) array
        The box that holds all vertices.
    origin : Vector
        World point from which the GPU's vertices are measured.

    Returns
    -------
    float
        In pixels.

    Notes
    -----
    A clip coordinate is a sum of four products: 2 u from the rounded factors, 1 from the product
    and 3 from the sums, each of the sum of the products' sizes; where it is seen, no NDC
    coordinate is larger than 1, so that x and w count alike. What is below float32's least number
    may be lost whole.
    """
    clip_from_local = projection.clip_from_world_at(origin)
    matrix = np.abs(clip_from_local)
    local = corners_world - origin
    largest = np.abs(local).max(axis=0)
    sizes = matrix[:, :3] @ largest + matrix[:, 3]
    if not max(sizes.max(), matrix.max(), largest.max()) < _LARGEST_32:
        return math.inf
    sizes += _LEAST_32 / _UNIT_32 * (matrix.sum(axis=1) + largest.sum() + 4.0)
    x, y, _, w = sizes
    least_w = 1.0
    if not projection.lens.parallel:
        clip = local @ clip_from_local[:, :3].T + clip_from_local[:, 3]
        least_w = max(projection.lens.near, _least_w_seen(clip, sizes))
        if least_w == math.inf or clip[:, 3].max() < projection.lens.near:  # nothing of it is seen
            return 0.0
    half_width, half_height = (side / 2.0 for side in projection.image_size)
    lost = max(half_width * (x + w), half_height * (y + w)) / least_w
    return float(_UNIT_32 * (6.0 * lost + 8.0 * max(half_width, half_height)))


def _least_w_seen(clip: Array, sizes: Array) -> float:
    """The least w of what is in view of a box, or less; infinite if nothing is.

    The box is cut with each side plane of the view volume alone: where it lies beside the eye, w
    is much larger in view than at its nearest corner.

    Parameters
    ----------
    clip : (8, 4) array
        Its corners.
    sizes : (4,) array
        Of the terms that clip coordinates are sums of, for their rounding.
    """
    x, y, _, w = clip.T
    beyond = 1e-14 * (sizes[[0, 0, 1, 1]] + sizes[3])
    inside = np.stack([w + x, w - x, w + y, w - y]) + beyond[:, None]
    # All pairs of corners: the edges and diagonals, whose cuts are in the box too.
    a, b = inside[:, :, None], inside[:, None, :]
    with np.errstate(divide="ignore", invalid="ignore"):
        cut = w[:, None] + a / (a - b) * (w - w[:, None])
    cut = np.where((a >= 0.0) & (b < 0.0), cut, np.where(a >= 0.0, w[:, None], np.inf))
    return float(cut.min(axis=(1, 2)).max())


def rung_for_drawing(
    projection: Projection,
    corners_world: Array,
    origin: Vector = (0.0, 0.0, 0.0),
    tolerance_px: float = DRAWING_TOLERANCE_PX,
) -> Rung:
    """The cheaper of the two rungs that can be drawn, if what it can lose is below a tolerance."""
    bound_px = drawing_bound_px(projection, corners_world, origin)
    return "float32" if bound_px <= tolerance_px else "float64"


def rung_for_reading(predictions: Mapping[Rung, Prediction] | None) -> Rung:
    """The rung of numbers that somebody reads: float64 where it is good enough, else exact."""
    if predictions is None:
        return "float64"
    px, depth = predictions["float64"]
    good = px <= READING_TOLERANCE_PX and depth <= READING_TOLERANCE_DEPTH
    return "float64" if good else "exact"


# --------------------------------------------------------------------------- the rungs


def trace(
    projection: Projection,
    points_world: ArrayLike,
    rung: Rung = "float64",
    origin: Vector = (0.0, 0.0, 0.0),
) -> Trace:
    """Follow points through every stage with the arithmetic of a rung.

    Parameters
    ----------
    projection : Projection
    points_world : (..., 3) array_like
    rung : {"float32", "float64", "exact"}
    origin : Vector
        World point from which the GPU's vertices are measured; `float32` only.

    Returns
    -------
    Trace

    Raises
    ------
    ProjectionError
        For coordinates that are not finite numbers, or another rung.
    """
    if rung not in RUNGS:
        raise ProjectionError("rung", rung, ONE_OF, ", ".join(RUNGS))
    if rung == "float64":
        return projection.trace(points_world)
    world = checked_points(points_world)
    flat = world.reshape(-1, 3)
    with np.errstate(all="ignore"):
        if rung == "float32":
            parts = _trace_float32(projection, flat, origin)
        else:
            parts = _trace_exact(projection, flat)
    return Trace(world, *(part.reshape(world.shape[:-1] + part.shape[1:]) for part in parts))


def _trace_float32(projection: Projection, world: Array, origin: Vector) -> tuple[Any, ...]:
    single = np.float32
    matrix = projection.clip_from_world_at(origin).astype(single)
    view_matrix = projection.view_rotation.astype(single)
    local = (world - origin).astype(single)
    offset = (world - projection.camera.eye).astype(single)
    view = offset @ view_matrix[:3, :3].T

    def row(i: int) -> Any:
        total = matrix[i, 0] * local[:, 0]
        for j in (1, 2):
            total = total + matrix[i, j] * local[:, j]
        return total + matrix[i, 3]

    clip = np.stack([row(i) for i in range(4)], axis=1)
    ndc = clip[:, :3] / clip[:, 3:]
    width, height = (single(side / 2.0) for side in projection.image_size)
    one = single(1.0)
    image = np.stack([(ndc[:, 0] + one) * width, (one - ndc[:, 1]) * height], axis=1)
    depth = ndc[:, 2]
    if projection.depth == "opengl":
        depth = single(0.5) * depth + single(0.5)
    x, y, _, w = clip.T
    in_front = (w > 0.0) & np.isfinite(ndc).all(axis=1) & np.isfinite(image).all(axis=1)
    distance = -view[:, 2]
    near, far = single(projection.lens.near), single(projection.lens.far)
    outside = np.stack([distance < near, distance > far, x < -w, x > w, y < -w, y > w], axis=1)
    return _finish(view, clip, ndc, image, depth, in_front, outside)


def _finish(*parts: Any) -> tuple[Any, ...]:
    """View, clip, NDC, image, depth as float64, without a picture where there is none."""
    *numbers, in_front, outside = parts
    view, clip, ndc, image, depth = (np.array(part, dtype=np.float64) for part in numbers)
    for array in (ndc, image, depth):
        array[~in_front] = np.nan
    return view, clip, ndc, image, depth, in_front, outside


# --------------------------------------------------------------------------- exact


def _clip(projection: Projection, n: ExactLens, x: Any, y: Any, distance: Any) -> list[Any]:
    """View and clip coordinates, and what is negative beyond each of `PLANES`, 3 + 4 + 6.

    From the view coordinates, in whatever arithmetic they are.
    """
    reverse = projection.depth == "reversed"
    one = distance * 0 + 1
    from_near, to_far = distance - n.near, one if n.far is None else -distance + n.far
    if projection.lens.parallel:
        assert n.far is not None
        w = one
        x_clip, y_clip = (
            (value - from_near * cot) * scale + shift
            for value, cot, scale, shift in zip((x, y), n.shear, n.scale, n.shift, strict=True)
        )
        numerator = (to_far if reverse else from_near) * (1 / (n.far - n.near))
    else:
        w = distance
        x_clip, y_clip = (
            value * scale + w * shift
            for value, scale, shift in zip((x, y), n.scale, n.shift, strict=True)
        )
        if n.far is None:
            numerator = one * n.near if reverse else from_near
        else:
            planes = n.near if reverse else n.far
            numerator = (to_far if reverse else from_near) * (planes / (n.far - n.near))
    z_clip = numerator * 2 - w if projection.depth == "opengl" else numerator
    inside = from_near, to_far, x_clip + w, -x_clip + w, y_clip + w, -y_clip + w
    return [x, y, -distance, x_clip, y_clip, z_clip, w, *inside]


def _divide(projection: Projection, clip: list[Any]) -> list[Any]:
    """NDC, image and depth, 3 + 2 + 1, from clip coordinates that have a w."""
    x, y, z, w = clip
    x_ndc, y_ndc, z_ndc = x / w, y / w, z / w
    depth = z_ndc
    if projection.depth == "opengl":
        depth = (z + w) / (w * 2)
    half_width, half_height = (Fraction(side, 2) for side in projection.image_size)
    return [x_ndc, y_ndc, z_ndc, (x_ndc + 1) * half_width, (-y_ndc + 1) * half_height, depth]


@dataclass(frozen=True)
class _Bounded:
    """A double-double array with a bound of its absolute error, to be used like a number."""

    value: DoubleDouble
    error: Array

    def _made(self, value: DoubleDouble, error: Array) -> _Bounded:
        return _Bounded(value, error + dd.RELATIVE_ERROR * np.abs(value.hi))

    def __neg__(self) -> _Bounded:
        return _Bounded(DoubleDouble(-self.value.hi, -self.value.lo), self.error)

    def __add__(self, other: Any) -> _Bounded:
        other = _bounded(other)
        return self._made(dd.add(self.value, other.value), self.error + other.error)

    def __sub__(self, other: Any) -> _Bounded:
        return self + -_bounded(other)

    def __mul__(self, other: Any) -> _Bounded:
        other = _bounded(other)
        mine, its = np.abs(self.value.hi) + self.error, np.abs(other.value.hi)
        return self._made(
            dd.multiply(self.value, other.value),
            mine * other.error + its * self.error + _UNDERFLOW,
        )

    def __truediv__(self, other: Any) -> _Bounded:
        other = _bounded(other)
        quotient = dd.divide(self.value, other.value)
        least = np.abs(other.value.hi) - other.error
        error = (self.error + np.abs(quotient.hi) * other.error) / least * (1.0 + 1e-9)
        return self._made(quotient, np.where(least > 0.0, error, math.inf) + _UNDERFLOW)


def _bounded(number: Any) -> _Bounded:
    """An exact scalar as an array of no dimension."""
    if isinstance(number, _Bounded):
        return number
    hi, lo = dd.from_exact(Fraction(number))
    error = abs(lo) * 2.0**-52
    return _Bounded(DoubleDouble(np.asarray(hi), np.asarray(lo)), np.asarray(error))


def _trace_exact(projection: Projection, world: Array) -> tuple[Any, ...]:
    numbers, _, outside = _exact_numbers(projection, world)
    view, clip, ndc, image, depth = np.split(numbers, (3, 7, 10, 12), axis=1)
    in_front = (clip[:, 3] > 0.0) & np.isfinite(numbers[:, 7:]).all(axis=1)
    return _finish(view, clip, ndc, image, depth[:, 0], in_front, outside)


def _exact_numbers(projection: Projection, world: Array) -> tuple[Array, Array, Any]:
    """View 3, clip 4, NDC 3, image 2 and depth; what rounding cut off the last 3; outside 6."""
    n = projection.exact_lens
    numbers, rests = np.empty((len(world), 13)), np.empty((len(world), 3))
    outside = np.empty((len(world), 6), dtype=bool)
    for start in range(0, len(world), _CHUNK):
        block = slice(start, start + _CHUNK)
        points = world[block]
        size = np.abs(points - projection.camera.eye).sum(axis=1)
        x, y, z = (
            _Bounded(part, 3.0 * dd.RELATIVE_ERROR * size + _UNDERFLOW)
            for part in projection.view_double_double(points)
        )
        first = _clip(projection, n, x, y, -z)
        doubtful = np.zeros(len(points), dtype=bool)
        for column, number in enumerate(first[:7] + _divide(projection, first[3:7])):
            numbers[block, column] = number.value.hi
            if column >= 10:
                rests[block, column - 10] = number.value.lo
            doubtful |= ~(number.error <= _CERTAIN * np.spacing(np.abs(number.value.hi)))
        for plane, number in enumerate(first[7:]):
            outside[block, plane] = number.value.hi < 0.0
            doubtful |= ~(number.error < np.abs(number.value.hi))
        for i in start + np.flatnonzero(doubtful):
            numbers[i], rests[i], outside[i] = _trace_rational(projection, n, world[i].tolist())
    return numbers, rests, outside


def _trace_rational(
    projection: Projection, n: ExactLens, point: Sequence[float]
) -> tuple[list[float], list[float], list[bool]]:
    """One point of `_exact_numbers` in rationals, each number rounded once."""
    x, y, z = projection.camera.exact_view((point[0], point[1], point[2]))
    first = _clip(projection, n, x, y, -z)
    w = first[6]
    quotients = _divide(projection, first[3:7]) if w != 0 else [math.nan] * 6
    numbers = [_rounded(number) for number in (*first[:7], *quotients)]
    rests = [
        float(true - Fraction(number)) if math.isfinite(number) else math.nan
        for true, number in zip(quotients[3:], numbers[10:], strict=True)
    ]
    return numbers, rests, [number < 0 for number in first[7:]]


def _rounded(number: Any) -> float:
    """The nearest float64; infinite if it is beyond them all."""
    try:
        return float(number)
    except OverflowError:
        return math.copysign(math.inf, number)
