"""Project points as cheap hardware does: with stored formats, arithmetic, reciprocals and snapping.

The steps are those of a GPU: the vertex is stored, one matrix is applied term by term, x, y and z
are divided by w, and the viewport follows. Every operation is rounded to the format, and carries a
bound of its error along (running error analysis: Higham, Accuracy and Stability of Numerical
Algorithms, 3.3). The bound knows the points and how the formats round, but not the true result.
With w known within e_w, a quotient x/w is known within ``(e_x + |x/w| e_w) / (w - e_w)``.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

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
_CELL_64 = 2.0**-44
"""Bound of the relative error of a float64 matrix's cell, of its terms: some 10 roundings."""
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
    stored_as = (hardware.vertices,)
    (picture,) = cheap_formats(projection, points_world, hardware, stored_as, origin, box)
    return picture


def cheap_formats(
    projection: Projection,
    points_world: ArrayLike,
    hardware: Hardware,
    vertices: Sequence[str],
    origin: Vector = (0.0, 0.0, 0.0),
    box: ArrayLike | None = None,
) -> list[CheapPicture]:
    """Return `cheap` with each of several formats of the vertices, hardly slower than one."""
    points = checked_points(points_world)
    corners = _box_of(points) if box is None else checked_points(box)
    numbers = FORMATS[hardware.numbers]
    with np.errstate(all="ignore"):
        each = [
            _stored(points, replace(hardware, vertices=name), numbers, np.array(origin), corners)
            for name in vertices
        ]
        stored = _Rounded(
            np.concatenate([part.value for part in each], axis=1),
            np.concatenate([part.error for part in each], axis=1),
            numbers,
        )
        matrix, has_w = _matrix(projection, origin, numbers)
        row = stored.part(0) * matrix.part(np.s_[:, 0, None])
        for axis in (1, 2):
            row = row + stored.part(axis) * matrix.part(np.s_[:, axis, None])
        clip = row + matrix.part(np.s_[:, 3, None])
        w = clip.part(np.s_[3:])
        ndc = clip.part(np.s_[:3])
        if has_w:
            ndc = _divided(ndc, w, RECIPROCALS[hardware.reciprocal])
        placed = _on_the_screen(projection, ndc)
        found, bounds = placed.value, placed.error * _ROUNDED_UP + _LEAST
        step = SNAPS[hardware.snap]
        if step:
            snapped = np.rint(found[:2] / step) * step
            bounds[:2] += np.where(snapped != found[:2], step / 2.0, 0.0)
            found[:2] = snapped
    none = ~(w.value[0] > 0.0) | np.isnan(found).any(axis=0)
    found[:, none], bounds[:, none] = np.nan, np.inf
    bounds[np.isnan(bounds)] = np.inf
    parts = (np.split(rows, len(vertices), axis=1) for rows in (found, bounds))
    return [CheapPicture(xy[:2].T, xy[2], bound.T) for xy, bound in zip(*parts, strict=True)]


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
        kept = _stored(points, hardware, FORMATS["float64"], np.array(origin), corners)
    return kept.value.T + origin


def _box_of(points: Array) -> Array:
    if not len(points):
        return np.zeros((2, 3))
    return np.stack([points.min(axis=0), points.max(axis=0)])


@dataclass(frozen=True)
class _Rounded:
    """Numbers of a format with bounds of their errors; all results are rounded to it."""

    value: Array
    error: Array
    numbers: Format

    def part(self, index: Any) -> _Rounded:
        return _Rounded(self.value[index], self.error[index], self.numbers)

    def __add__(self, other: _Rounded) -> _Rounded:
        total = self.numbers.rounded(self.value + other.value)
        # Near 0 and in fixed point, sums are exact.
        lost = self.numbers.unit * np.abs(total) + _LEAST
        return _Rounded(total, self.error + other.error + lost, self.numbers)

    def __mul__(self, other: _Rounded) -> _Rounded:
        product = self.value * other.value
        error = np.abs(self.value) * other.error + np.abs(other.value) * self.error
        error += self.error * other.error + _LEAST
        return self.made(product, error)

    def __neg__(self) -> _Rounded:
        return _Rounded(-self.value, self.error, self.numbers)

    def made(self, exactly: Array, error: Array) -> _Rounded:
        """Round results that have an error already; a 0 is exact."""
        rounded = self.numbers.rounded(exactly)
        lost = np.where(exactly == 0.0, 0.0, self.numbers.lost(rounded))
        return _Rounded(rounded, error + lost, self.numbers)


def _stored(
    points: Array, hardware: Hardware, numbers: Format, origin: Array, corners: Array
) -> _Rounded:
    """The coordinates (3, n) of the vertices, as the arithmetic gets them."""
    local, corners = points - origin, corners - origin
    bits = QUANTISED.get(hardware.vertices)
    kept = FORMATS[hardware.vertices] if bits is None else Grid.over(corners, bits)
    stored = kept.rounded(local)
    error = _UNIT_64 * np.abs(local) + np.where(stored != local, kept.lost(local), 0.0)
    loaded = numbers.rounded(stored)
    error += np.where(loaded != stored, numbers.lost(loaded), 0.0)
    return _Rounded(loaded.T, error.T, numbers)


@lru_cache(maxsize=4)  # the formats of one picture are compared at every step
def _matrix(projection: Projection, origin: Vector, numbers: Format) -> tuple[_Rounded, bool]:
    """The matrix to clip space in the format, with its errors, and whether w is not always 1."""
    given = projection.clip_from_local(origin)
    cells = numbers.rounded(given)
    if numbers.digits == 53 or projection.lens.own_view is not None:
        errors = _from_rationals(projection, origin, cells)
    else:
        # float64 keeps more of each cell than any other format sees: its terms are a row of
        # `clip_from_view` times a unit vector, or times the offset from the eye.
        terms = np.abs(projection.clip_from_view)
        length = np.abs(np.subtract(origin, projection.camera.eye)).sum()
        sizes = np.repeat(terms[:, :3].sum(axis=1, keepdims=True), 4, axis=1)
        sizes[:, 3] = sizes[:, 3] * length + terms[:, 3]
        errors = np.abs(given - cells) + _CELL_64 * sizes
        errors[~np.isfinite(cells)] = np.inf
    has_w = given[3].tolist() != [0.0, 0.0, 0.0, 1.0]
    return _Rounded(cells, read_only(errors * _ROUNDED_UP), numbers), has_w


def _from_rationals(projection: Projection, origin: Vector, cells: Array) -> Array:
    """The errors of the matrix's cells, against rationals."""
    exact = [row.copy() for row in projection.exact_from_eye[1]]
    eye = projection.camera.eye
    offset = [Fraction(o) - Fraction(e) for o, e in zip(origin, eye, strict=True)]
    for row in exact:
        row[3] += sum((cell * o for cell, o in zip(row, offset, strict=False)), Fraction(0))
    return np.array(
        [
            [
                abs(nearest(true - Fraction(cell))) if math.isfinite(cell) else math.inf
                for true, cell in zip(true_row, row, strict=True)
            ]
            for true_row, row in zip(exact, cells.tolist(), strict=True)
        ]
    )


def _divided(clip: _Rounded, w: _Rounded, steps: int | None) -> _Rounded:
    """Clip x, y, z over w; the bound is infinite where w may be 0."""
    quotient = clip.value / w.value
    size = np.abs(quotient)
    least = w.value - w.error * _ROUNDED_UP
    error = (clip.error + size * w.error + _LEAST) / np.where(least > 0.0, least, 0.0)
    if steps is not None:
        inverse, relative = reciprocal(w.value, clip.numbers, steps)
        quotient = clip.value * inverse
        error += size * relative
    return clip.made(quotient, error)


def _on_the_screen(projection: Projection, ndc: _Rounded) -> _Rounded:
    """x and y in pixels and the depth in [0, 1], (3, n)."""
    numbers = ndc.numbers
    x, y, z = (ndc.part(i) for i in range(3))

    def constant(value: float) -> _Rounded:
        cell = numbers.rounded(value)
        return _Rounded(cell, np.abs(cell - value), numbers)

    one, half = constant(1.0), constant(0.5)
    width, height = (constant(side / 2.0) for side in projection.image_size)
    depth = half * z + half if projection.depth == "opengl" else z
    rows = (x + one) * width, (one + -y) * height, depth
    return _Rounded(
        np.stack([row.value for row in rows]), np.stack([row.error for row in rows]), numbers
    )
