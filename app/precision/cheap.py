"""Project points as cheap hardware does: with stored formats, arithmetic, reciprocals and snapping.

The steps are those of a GPU: the vertex is stored, one matrix is applied term by term, x, y and z
are divided by w, and the viewport follows. Every operation is rounded to the format, and carries a
bound of its error along (running error analysis: Higham, Accuracy and Stability of Numerical
Algorithms, 3.3). The bound knows the points and how the formats round, but not the true result.
With w known within e_w, a quotient x/w is known within ``(e_x + |x/w| e_w) / (w - e_w)``.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from app.arithmetic.formats import FORMATS, QUANTISED, RECIPROCALS, SNAPS, Format, Grid, reciprocal
from app.arithmetic.rationals import Rationals, nearest
from app.model.limits import check_name
from app.model.pipeline import checked_points
from app.model.projection import Array, Projection, Vector
from app.precision.levels import cell_terms

_UNIT_64 = 2.0**-53
CELLS = 2.0**-48
"""Bound of what float64 loses of a matrix's cells, in their terms: 32 roundings.

Other formats lose so much more that it does not show.
"""
_LEAST = 1e-300  # more than what the bounds themselves lose near the smallest float64
_ROUNDED_UP = 1.0 + 2.0**-40  # for the roundings of the bounds themselves, less than 200 of 2^-53


@dataclass(frozen=True)
class Hardware:
    """What the picture is computed with.

    Vertices are stored as one of `FORMATS` or `QUANTISED`, and `numbers` is the one of `FORMATS`
    that every result of the arithmetic has. `snap` is the grid of the screen positions, of `SNAPS`;
    `reciprocal`, of `RECIPROCALS`, is how x, y and z are divided by w.

    Raises a `Refusal` for an unknown name.
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
            check_name(field, getattr(self, field), known)

    @property
    def bytes_per_vertex(self) -> float:
        """Three coordinates without padding: 4.5 for 12 bits, which are stored in 6."""
        bits = QUANTISED.get(self.vertices) or FORMATS[self.vertices].bits
        return 3.0 * bits / 8.0


class CheapPicture(NamedTuple):
    """The picture of n points.

    - `image` (n, 2): pixels, origin top-left; NaN for no number: behind the eye, or out of a
      format's range.
    - `depth` (n,): in [0, 1] between near and far; NaN where `image` is.
    - `bounds` (n, 3): bounds of the errors of x and y in pixels and of the depth. Infinite where
      nothing is known: the rounded w may be 0, or there is no number.
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

    The vertices are measured from the world point `origin` before they are stored, and quantised
    over the mesh's box (2, 3), by default that of the points. A point outside has no number.

    Raises a `Refusal` for coordinates that are not finite numbers.

    With float32, no snapping and an exact reciprocal, the numbers are bit for bit those of the
    precision ``float32`` of `app.precision.levels`.
    """
    return cheap_formats(projection, points_world, hardware, (hardware.vertices,), origin, box)[0]


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
    numbers = FORMATS[hardware.numbers]
    with np.errstate(all="ignore"):
        each = [_loaded(points, name, numbers, origin, box) for name in vertices]
        point = BoundedNumbers(*(np.hstack(parts) for parts in zip(*each, strict=True)))
        matrix, has_w = _matrix(projection, origin, numbers)
        clip = applied(matrix, point, numbers)
        ndc, w = (BoundedNumbers(*(part[rows] for part in clip)) for rows in (slice(3), 3))
        if has_w:
            ndc = divided(ndc, w, RECIPROCALS[hardware.reciprocal], numbers)
        image, bounds = _on_the_screen(projection, ndc, numbers)
        step = SNAPS[hardware.snap]
        if step:
            snapped = np.rint(image[:2] / step) * step
            bounds[:2] += np.where(snapped != image[:2], step / 2.0, 0.0)
            image[:2] = snapped
        bounds = bounds * _ROUNDED_UP + _LEAST
    none = ~(w.value > 0.0) | np.isnan(image).any(axis=0)
    image[:, none], bounds[:, none] = np.nan, np.inf
    bounds[np.isnan(bounds)] = np.inf
    parts = (np.split(rows.T, len(vertices)) for rows in (image, bounds))
    return [CheapPicture(xyz[:, :2], xyz[:, 2], bound) for xyz, bound in zip(*parts, strict=True)]


def stored(
    points_world: ArrayLike,
    hardware: Hardware,
    origin: Vector = (0.0, 0.0, 0.0),
    box: ArrayLike | None = None,
) -> Array:
    """World points (n, 3) as their vertices are stored; NaN where a format has no number."""
    points = checked_points(points_world)
    with np.errstate(all="ignore"):
        kept, _ = _loaded(points, hardware.vertices, FORMATS["float64"], origin, box)
    return kept.T + origin


class BoundedNumbers(NamedTuple):
    value: Array
    error: Array


def _loaded(
    points: Array, vertices: str, numbers: Format, origin: Vector, box: ArrayLike | None
) -> BoundedNumbers:
    """The coordinates (3, n) of stored vertices, as the arithmetic gets them."""
    local = points - origin
    kept: Format | Grid
    if vertices in FORMATS:
        kept = FORMATS[vertices]
    else:
        if box is None:
            box = (points.min(axis=0), points.max(axis=0)) if len(points) else (origin, origin)
        kept = Grid.of_box(checked_points(box) - origin, QUANTISED[vertices])
    stored = kept.rounded(local)
    loaded = stored if vertices == numbers.name else numbers.rounded(stored)
    # The points are known, so what storing loses is, too; float64 loses a little of both.
    error = _UNIT_64 * np.abs(local) + np.abs(loaded - local)
    return BoundedNumbers(np.ascontiguousarray(loaded.T), error.T)


def _matrix(projection: Projection, origin: Vector, numbers: Format) -> tuple[BoundedNumbers, bool]:
    """The matrix to clip space in the format, and whether w is not always 1.

    Its cells are known before any point is, and so are their roundings.
    """
    given = projection.clip_from_local(origin)
    cells = numbers.rounded(given)
    if numbers.digits == 53:
        eye = projection.camera.eye
        offset = [Fraction(o) - Fraction(e) for o, e in zip(origin, eye, strict=True)]
        exact = [
            [*row[:3], row[3] + sum(cell * o for cell, o in zip(row, offset, strict=False))]
            for row in projection.exact_from_eye[1]
        ]
        off = off_rationals(exact, given)
    else:
        off = CELLS * cell_terms(projection, projection.local_to_eye(origin))
    has_w = given[3].tolist() != [0.0, 0.0, 0.0, 1.0]
    return BoundedNumbers(cells, np.abs(cells - given) + off), has_w


def off_rationals(exact: Rationals, cells: Array) -> Array:
    """The errors of a matrix's cells, which its own results show; infinite where one is none."""
    off = [
        [
            abs(nearest(true - Fraction(cell))) if np.isfinite(cell) else np.inf
            for true, cell in both
        ]
        for both in (zip(*rows, strict=True) for rows in zip(exact, cells.tolist(), strict=True))
    ]
    return np.array(off)


def applied(matrix: BoundedNumbers, point: BoundedNumbers, numbers: Format) -> BoundedNumbers:
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
    return BoundedNumbers(total, error)


def divided(
    clip: BoundedNumbers, w: BoundedNumbers, steps: int | None, numbers: Format
) -> BoundedNumbers:
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
    return BoundedNumbers(quotient, error + np.where(exactly == 0.0, 0.0, numbers.lost(quotient)))


def _on_the_screen(projection: Projection, ndc: BoundedNumbers, numbers: Format) -> BoundedNumbers:
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
    return BoundedNumbers(value, np.concatenate([off, deep]))
