"""How far a camera drifts that is turned by products of small turns.

The rows of a (3, 3) are the camera's axes u, v, n in its first frame. Each frame of a film
multiplies them by one turn of 1 degree about `AXIS`, whose cells are rounded to the format, as is
every operation. Every `BLOCK` frames they may be made orthonormal anew (Gram and Schmidt): n is
divided by its length, u loses its part along n and is divided by its own, and v is n x u.

A bound runs along. If ten frames lead from A to B, and R is the exact turn of ten, the bound grows
by the Frobenius norm of the residual B - R A. Exact turns change no norm, so the sum is at least
the distance between the axes and the true ones.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import cache, reduce
from itertools import islice
from threading import Lock
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from app.arithmetic import double_double as dd
from app.model.projection import Array, Projection

Cells: TypeAlias = NDArray[Any]  # matrices (3, 3, ...) in the numbers of a format

AXIS = Fraction(1, 3), Fraction(2, 3), Fraction(2, 3)  # the turns' axis, of length 1, along u, v, n
FRAMES, BLOCK = 360, 10  # frames of a round; frames from one residual or renormalising to the next
_MAGIC = {"float16": 0x59BA, "float32": 0x5F3759DF, "float64": 0x5FE6EB50C7B537A9}
"""(3/2) 2^m (bias - 0.0450466), for m bits of a fraction (M. Robertson, "A Brief History of
InvSqrt", 2012)."""
_SINES = 16.2
"""Error of axes from an angle, in units: 8 for a sine and a cosine that are off by 4 at most, and
8.15 for the cells that these multiply, the products and the sums, each rounded once."""
_PI = Fraction(math.pi) + Fraction(math.sin(math.pi))  # to 105 bits
_ROUNDED_UP = 1.0 + 1e-9
_turning = Lock()


def exact_turn(degrees: int, axis: Sequence[Fraction] = AXIS) -> dd.DoubleDouble:
    """The matrix (3, 3) of a turn about an axis of length 1."""
    (cos, sin), (x, y, z) = dd.cos_sin_deg(Fraction(degrees)), axis
    across = ((0, -z, y), (z, 0, -x), (-y, x, 0))
    cells = [(1 - cos) * axis[i // 3] * axis[i % 3] + sin * across[i // 3][i % 3] for i in range(9)]
    cells[::4] = [cell + cos for cell in cells[::4]]
    return dd.DoubleDouble(*np.array([dd.from_exact(cell) for cell in cells]).T.reshape(2, 3, 3))


def multiplier(turn: Cells, axes: Cells) -> Callable[[], None]:
    """Return a function that multiplies axes by a turn in place, and rounds every operation."""
    terms, turn = np.empty((3, *axes.shape), axes.dtype), turn[:, :, None]
    first, second, third = terms[:, 0], terms[:, 1], terms[:, 2]

    def run() -> None:
        np.multiply(turn, axes, terms)
        np.add(first, second, first)
        np.add(first, third, axes)

    return run


def orthonormal(axes: Cells, is_fast: bool) -> Cells:
    """Orthonormal axes, with a fast inverse square root if asked."""
    u, _, n = axes
    n = n * _inverse_length(n, is_fast)
    u = u - _dot(u, n) * n
    u = u * _inverse_length(u, is_fast)
    return np.stack([u, n[[1, 2, 0]] * u[[2, 0, 1]] - n[[2, 0, 1]] * u[[1, 2, 0]], n])


def _dot(one: Cells, other: Cells) -> Cells:
    terms = one * other  # numpy's sum would not round each term to half floats
    return np.asarray(terms[0] + terms[1] + terms[2])


def _inverse_length(vector: Cells, is_fast: bool) -> Cells:
    """Fast, the bits are halved and subtracted from a constant; one Newton step follows."""
    square, number = _dot(vector, vector), vector.dtype.type
    if not is_fast:
        return np.asarray(number(1.0) / np.sqrt(square))
    whole = np.dtype(f"i{vector.itemsize}")
    guess = (whole.type(_MAGIC[vector.dtype.name]) - (square.view(whole) >> 1)).view(vector.dtype)
    return np.asarray(guess * (number(1.5) - number(0.5) * square * guess * guess))


def turner(angles: Cells) -> Callable[[], Cells]:
    """Return a function that makes the axes for angles in radians, from two sines each."""
    half, quarter = exact_turn(180).hi, exact_turn(90).hi
    along, shape = (np.eye(3) + half) / 2.0, (3, 3, *[1] * angles.ndim)
    parts = np.eye(3) - along, (quarter - quarter.T) / 2.0, along
    rest, across, along = (part.reshape(shape).astype(angles.dtype) for part in parts)
    axes, term = np.empty((2, 3, 3, *angles.shape), angles.dtype)

    def run() -> Cells:
        np.multiply(np.cos(angles), rest, axes)
        np.multiply(np.sin(angles), across, term)
        np.add(axes, term, axes)
        return np.asarray(np.add(axes, along, axes))

    return run


def rounds_of(
    numbers: str, way: str, turns: Sequence[dd.DoubleDouble]
) -> Iterator[tuple[Array, Array]]:
    """Yield the errors (3, 3, ...) of axes after 1, 2, 3, ... rounds, and the bounds (...).

    `way` is ``"products"``, ``"renormalised"`` or ``"fast"``, `turns` are the exact ones of a frame
    and of a block, (3, 3, ...).
    """
    step, (hi, lo) = turns[0].hi, turns[1]
    first = np.zeros(step.shape) + np.eye(3).reshape(3, 3, *[1] * (step.ndim - 2))
    axes, bounds, zero = first.astype(numbers), np.zeros(step.shape[2:]), np.zeros(1)
    run = multiplier(step.astype(numbers), axes)
    kept = np.array([first] * (FRAMES // BLOCK + 1))
    while True:
        kept[0] = axes
        with np.errstate(all="ignore"):
            for block in range(1, len(kept)):
                for _ in range(BLOCK):
                    run()
                if way != "products":
                    axes[:] = orthonormal(axes, way == "fast")
                kept[block] = axes
            terms = [
                dd.multiply(
                    dd.DoubleDouble(hi[:, j, None], lo[:, j, None]),
                    dd.DoubleDouble(kept[:-1, None, j], zero),
                )
                for j in range(3)
            ]
            residual = dd.subtract(reduce(dd.add, terms), dd.DoubleDouble(kept[1:], zero)).hi
            grown = np.sqrt((residual**2).sum(axis=(1, 2))).sum(axis=0)
        bounds = bounds + _ROUNDED_UP * grown
        yield kept[-1] - first, bounds


@cache
def _begun(numbers: str, way: str) -> tuple[list[Any], Iterator[Any]]:
    """The rounds that have been asked for, and the next ones."""
    return [], rounds_of(numbers, way, (exact_turn(1), exact_turn(BLOCK)))


def drifted(numbers: str, way: str, rounds: int) -> tuple[Array, float]:
    """The error (3, 3) of the axes after whole rounds, and the bound of its norm.

    The way ``"sines"`` makes them at once, from sine and cosine of the whole angle. The numbers are
    NaN or infinite where they overflow.
    """
    if way != "sines":
        done, more = _begun(numbers, way)
        with _turning:  # a lesson is checked beside the window
            done += islice(more, max(0, rounds - len(done)))
        return done[rounds - 1][0], float(done[rounds - 1][1])
    number, unit = np.dtype(numbers).type, float(np.finfo(numbers).eps) / 2.0
    with np.errstate(all="ignore"):
        angle = np.asarray(number(FRAMES * rounds) * number(np.pi / 180.0))
        off = turner(angle)().astype(np.float64) - np.eye(3)
    if not np.isfinite(angle):
        return off, math.inf
    wrong = float(abs(Fraction(float(angle)) - 2 * rounds * _PI))
    return off, _SINES * unit + 1.4143 * wrong  # a radian turns the axes by the square root of 2


def errors_px(
    projection: Projection, points_world: Array, off: Array, bound: float | Array
) -> tuple[Array, Array]:
    """Errors (n, 2) in pixels of points (n, 3) in front of the eye, and bounds of their lengths.

    An error is NaN where the point has come behind the eye.
    With rows x, y and w of the lens, ``(x + dx)/(w + dw) - x/w = (dx - (x/w) dw)/(w + dw)``. The
    view coordinates q change by `off` q, which is at most `bound` times as long as q.
    """
    trace = projection.trace(points_world)
    rows, w = projection.clip_from_view[[0, 1, 3], :3], trace.clip[:, 3]
    per_px = rows[:2] - trace.ndc[:, :2, None] * rows[2]
    per_px *= np.reshape(np.array(projection.image_size) / (2.0, -2.0), (2, 1))
    change = trace.view @ off.T
    with np.errstate(all="ignore"):
        most = bound * np.linalg.norm(trace.view, axis=1)
        left = w + change @ rows[2]
        px = (per_px @ change[:, :, None])[:, :, 0] / np.where(left > 0.0, left, np.nan)[:, None]
        least = w - np.linalg.norm(rows[2]) * most
        (one, both), (_, other) = np.moveaxis(per_px @ per_px.swapaxes(1, 2), 0, -1)
        largest = (one + other) / 2.0 + np.hypot((one - other) / 2.0, both)  # eigenvalue
        bounds = np.sqrt(largest) * most / np.where(least > 0.0, least, 0.0)
    return px, _ROUNDED_UP * np.where(np.isnan(bounds), np.inf, bounds)
