"""Project points as cheap hardware does: with stored formats, arithmetic, reciprocals and snapping.

The steps are those of a GPU: the vertex is stored, one matrix is applied term by term, x, y and z
are divided by w, and the viewport follows. Every operation is rounded to the format, and carries a
bound of its error along (running error analysis: Higham, Accuracy and Stability of Numerical
Algorithms, 3.3). The bound knows the points and how the formats round, but not the true result.
With w known within e_w, a quotient x/w is known within ``(e_x + |x/w| e_w) / (w - e_w)``.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from app.arithmetic.formats import FORMATS, QUANTISED, RECIPROCALS, SNAPS, Format, Grid, reciprocal
from app.arithmetic.rationals import nearest
from app.model.limits import read_only
from app.model.projection import ONE_OF, Array, Projection, Vector, checked_points
from app.model.refusal import Refusal

_UNIT_64 = 2.0**-53
_LEAST = 1e-300
"""More than what the bounds themselves lose near the smallest float64."""
_ROUNDED_UP = 1.0 + 2.0**-40
"""For the roundings of the bounds themselves, less than 200 of 2^-53."""


@dataclass(frozen=True)
class Hardware:
    """What the picture is computed with.

    Parameters
    ----------
    vertices : name in `FORMATS` or `QUANTISED`
        How the vertices are stored.
    numbers : name in `FORMATS`
        The format of every result of the arithmetic.
    snap : name in `SNAPS`
        The grid of the screen positions.
    reciprocal : name in `RECIPROCALS`
        How x, y and z are divided by w.

    Raises
    ------
    Refusal
        For an unknown name.
    """

    vertices: str = "float32"
    numbers: str = "float32"
    snap: str = "none"
    reciprocal: str = "exact"

    def __post_init__(self) -> None:
        for field, known in (
            ("vertices", (*FORMATS, *QUANTISED)),
            ("numbers", FORMATS),
            ("snap", SNAPS),
            ("reciprocal", RECIPROCALS),
        ):
            value = getattr(self, field)
            if not isinstance(value, str) or value not in known:
                raise Refusal(field, value, ONE_OF, ", ".join(known))

    @property
    def bytes_per_vertex(self) -> float:
        """Three coordinates without padding: 4.5 for 12 bits, which are stored in 6."""
        bits = QUANTISED.get(self.vertices) or FORMATS[self.vertices].bits
        return 3.0 * bits / 8.0


class CheapPicture(NamedTuple):
    """The picture of n points.

    Attributes
    ----------
    image : (n, 2) array
        Pixels, origin top-left; NaN for no number: behind the eye, or out of a format's range.
    depth : (n,) array
        In [0, 1] between near and far; NaN where `image` is.
    bounds : (n, 3) array
        Bounds of the errors of x and y in pixels and of the depth. Infinite where nothing is known:
        the rounded w may be 0, or there is no number.
    """

    image: Array
    depth: Array
    bounds: Array


def cheap(
    projection: Projection,
    points_world: ArrayLike,
    hardware: Hardware,
    origin: Vector = (0.0, 0.0, 0.0),
    box: ArrayLike | None = None,
) -> CheapPicture:
    """Project world points (n, 3); those before the near plane have numbers, too.

    Parameters
    ----------
    origin : Vector
        World point from which the vertices are measured before they are stored.
    box : (2, 3) array_like, optional
        Lower and upper corner of the mesh, over which vertices are quantised; by default those of
        the points. A point outside has no number.

    Raises
    ------
    Refusal
        For coordinates that are not finite numbers.

    Notes
    -----
    With float32, no snapping and an exact reciprocal, the numbers are bit for bit those of the
    precision ``float32`` of `app.precision.levels`.
    """
    points = checked_points(points_world)
    corners = _box_of(points) if box is None else checked_points(box)
    numbers = FORMATS[hardware.numbers]
    with np.errstate(all="ignore"):
        vertices = _stored(points, hardware, numbers, np.array(origin), corners - origin)
        cells, has_w = _cells(projection, origin)
        clip = _applied(_matrix(projection, origin, cells, numbers), vertices, numbers)
        w, ndc = _Known(*(part[3] for part in clip)), _Known(*(part[:3] for part in clip))
        if has_w:
            ndc = _divided(ndc, w, RECIPROCALS[hardware.reciprocal], numbers)
        found, bounds = _on_the_screen(projection, ndc, numbers)
        step = SNAPS[hardware.snap]
        if step:
            snapped = np.rint(found[:2] / step) * step
            bounds[:2] += np.where(snapped != found[:2], step / 2.0, 0.0)
            found[:2] = snapped
    bounds = bounds * _ROUNDED_UP + _LEAST
    none = ~(w.value > 0.0) | np.isnan(found).any(axis=0)
    found[:, none], bounds[:, none] = np.nan, np.inf
    bounds[np.isnan(bounds)] = np.inf
    return CheapPicture(found[:2].T, found[2], bounds.T)


def stored(
    points_world: ArrayLike,
    hardware: Hardware,
    origin: Vector = (0.0, 0.0, 0.0),
    box: ArrayLike | None = None,
) -> Array:
    """World points (n, 3) as their vertices are stored; NaN where a format has no number."""
    points = checked_points(points_world)
    corners = _box_of(points) if box is None else checked_points(box)
    with np.errstate(all="ignore"):
        kept = _stored(points, hardware, FORMATS["float64"], np.array(origin), corners - origin)
    return kept.value.T + origin


def _box_of(points: Array) -> Array:
    if not len(points):
        return np.zeros((2, 3))
    return np.stack([points.min(axis=0), points.max(axis=0)])


class _Known(NamedTuple):
    """Numbers of a format, and bounds of their errors."""

    value: Array
    error: Array


def _stored(
    points: Array, hardware: Hardware, numbers: Format, origin: Array, corners: Array
) -> _Known:
    """The coordinates (3, n) of the vertices, as the arithmetic gets them."""
    local = points - origin
    bits = QUANTISED.get(hardware.vertices)
    kept = FORMATS[hardware.vertices] if bits is None else Grid.over(corners, bits)
    stored = kept.rounded(local)
    error = _UNIT_64 * np.abs(local) + np.where(stored != local, kept.lost(local), 0.0)
    loaded = stored
    if hardware.vertices != numbers.name:
        loaded = numbers.rounded(stored)
        error += np.where(loaded != stored, numbers.lost(loaded), 0.0)
    return _Known(np.ascontiguousarray(loaded.T), error.T)


@lru_cache(maxsize=4)  # the formats that are compared under one projection
def _cells(projection: Projection, origin: Vector) -> tuple[Array, bool]:
    """The cells (4, 4) of the matrix to clip space, rounded once, and whether w is not always 1."""
    exact = [row.copy() for row in projection.exact_from_eye[1]]
    eye = projection.camera.eye
    offset = [Fraction(o) - Fraction(e) for o, e in zip(origin, eye, strict=True)]
    for row in exact:
        row[3] += sum((cell * o for cell, o in zip(row, offset, strict=False)), Fraction(0))
    cells = read_only([[nearest(cell) for cell in row] for row in exact])
    return cells, exact[3] != [0, 0, 0, 1]


def _matrix(projection: Projection, origin: Vector, cells: Array, numbers: Format) -> _Known:
    """The matrix in the format; the errors of its cells are known before any point is."""
    rounded = numbers.rounded(projection.clip_from_local(origin))
    return _Known(rounded, np.abs(cells - rounded) + _UNIT_64 * np.abs(cells))


def _applied(matrix: _Known, point: _Known, numbers: Format) -> _Known:
    """Clip coordinates (4, n): sums of products, added one after the other."""
    columns = matrix.value[:, :, None].swapaxes(0, 1)
    total = numbers.rounded(columns[0] * point.value[0])
    sizes = np.abs(total)  # of all that is rounded
    for axis in (1, 2):
        term = numbers.rounded(columns[axis] * point.value[axis])
        total = numbers.rounded(total + term)
        sizes += np.abs(term)
        sizes += np.abs(total)
    total = numbers.rounded(total + columns[3])
    sizes += np.abs(total)
    cells, lost = np.abs(matrix.value[:, :3]), matrix.error
    error = cells @ point.error + lost[:, :3] @ (np.abs(point.value) + point.error)
    # Near 0 and in fixed point, sums are exact, and so is a product with 0.
    products = np.count_nonzero(cells, axis=1)[:, None]
    error += lost[:, 3:] + numbers.unit * sizes + numbers.step / 2.0 * products + _LEAST
    return _Known(total, error)


def _divided(clip: _Known, w: _Known, steps: int | None, numbers: Format) -> _Known:
    """Clip x, y, z over w; the bound is infinite where w may be 0."""
    exactly = clip.value / w.value
    size = np.abs(exactly)
    least = w.value - w.error * _ROUNDED_UP
    error = (clip.error + size * w.error + _LEAST) / np.where(least > 0.0, least, 0.0)
    if steps is not None:
        inverse, relative = reciprocal(w.value, numbers, steps)
        exactly = clip.value * inverse
        error += size * relative
    quotient = numbers.rounded(exactly)
    return _Known(quotient, error + np.where(exactly == 0.0, 0.0, numbers.lost(quotient)))


def _on_the_screen(projection: Projection, ndc: _Known, numbers: Format) -> _Known:
    """x and y in pixels and the depth in [0, 1], (3, n)."""
    value, error = np.empty_like(ndc.value), ndc.error
    halves = np.array(projection.image_size)[:, None] / 2.0
    sides = numbers.rounded(halves)
    moved = numbers.rounded(1.0 + ndc.value[:2] * ((1.0,), (-1.0,)))
    value[:2] = numbers.rounded(moved * sides)
    off = error[:2] + numbers.unit * np.abs(moved)
    off = off * sides + (np.abs(moved) + off) * np.abs(sides - halves) + numbers.lost(value[:2])
    if projection.depth == "opengl":
        half = numbers.rounded(0.5 * ndc.value[2])
        value[2] = numbers.rounded(half + 0.5)
        deep = 0.5 * error[2:] + numbers.lost(half) + numbers.unit * np.abs(value[2:])
    else:
        value[2], deep = ndc.value[2], error[2:]
    return _Known(value, np.concatenate([off, deep]))
