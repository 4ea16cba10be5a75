"""From a pixel and its depth back to a point in the world, in formats with few digits.

Every way is a list of matrices. w divides the first three coordinates after the first of them::

    inverse     (P V)^-1
    inverses    P^-1, then V^-1
    ray         (P R)^-1, where R only turns: the pixel's ray over 1/w; then the eye is added

The cells are rounded once, from rationals. Every product and every sum, added term by term, is
rounded, and carries a bound of its error along, as in `app.precision.cheap`. Pixel and depth are
the same float32 numbers for every way, so what a depth buffer has rounded before is no part of it.
"""

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from typing import TypeAlias

import numpy as np

from app.arithmetic.formats import FORMATS
from app.arithmetic.rationals import Rationals, dot, nearest, product, rationals, shift
from app.model.limits import within
from app.model.projection import Array, Projection, Vector
from app.model.refusal import REFUSALS, Refusal
from app.model.tables import inverse
from app.precision.cheap import BoundedNumbers, applied, divided, off_rationals

WAYS = ("inverse", "inverses", "ray")
THERE = ("one", "two")  # the ways to the picture: by P V as one matrix, or by V and then by P

Steps: TypeAlias = list[tuple[Rationals, bool]]  # matrices, and whether w divides after each


def float32_pixels(image: Array, depth: Array) -> Array:
    """Pixels and depths (n, 3), as float32 holds them."""
    with np.errstate(all="ignore"):
        return np.column_stack([image, depth]).astype(np.float32).astype(np.float64)


def check_pixel(projection: Projection, pixel: Sequence[float]) -> None:
    """Raise a `Refusal` for a pixel outside the picture, and for a depth without a point."""
    for name, number, most in zip("xy", pixel, projection.image_size, strict=False):
        within(name, number, 0.0, float(most))
    depth = within("depth", pixel[2], 0.0, 1.0)
    if projection.lens.far == np.inf and depth == (projection.depth != "reversed"):
        raise Refusal("depth", depth, REFUSALS["no-point"])


def steps(projection: Projection, way: str, origin: Vector) -> Steps:
    """The matrices of one of `WAYS` or `THERE`; points are measured from the world's `origin`."""
    offset = [Fraction(e) - Fraction(o) for e, o in zip(projection.camera.eye, origin, strict=True)]
    view, clip = projection.exact_from_eye
    if way in THERE:
        to_eye = shift(*(-part for part in offset))
        if way == "one":
            return [(product(clip, to_eye), True)]
        return [(product(view, to_eye), False), (projection.exact_clip_from_view, True)]
    from_eye, from_clip = shift(*offset), _short(projection)
    if way == "inverse":
        return [(product(from_eye, from_clip), True)]
    if way == "ray":
        return [(from_clip, True), (from_eye, False)]
    back = product(from_eye, inverse("view_from_world", view))
    return [(product(view, from_clip), True), (back, False)]


@lru_cache(maxsize=4)
def _short(projection: Projection) -> Rationals:
    """`Projection.eye_from_clip` to 159 bits: its own rationals are so long that they are slow."""
    short = []
    for row in projection.eye_from_clip:
        high = [Fraction(nearest(cell)) for cell in row]
        for _ in range(2):
            rests = zip(row, high, strict=True)
            high = [part + Fraction(float(cell - part)) for cell, part in rests]
        short.append(high)
    return short


def ndc_from_pixels(projection: Projection) -> Rationals:
    """The inverse of the viewport: pixels and depths to NDC."""
    (width, height), low = projection.image_size, int(min(projection.depth_range))
    across, down = Fraction(2, width), Fraction(-2, height)
    return rationals([[across, 0, 0, -1], [0, down, 0, 1], [0, 0, 1 - low, low], [0, 0, 0, 1]])


@lru_cache(maxsize=16)  # a step of a setting changes few of them
def kept_matrices(
    projection: Projection, way: str, origin: Vector, form: str
) -> tuple[tuple[BoundedNumbers, bool], ...]:
    """The cells of `steps` in a format, with those from pixels before a way back."""
    kept = []
    before: Steps = [] if way in THERE else [(ndc_from_pixels(projection), False)]
    for exact, divides in [*before, *steps(projection, way, origin)]:
        cells = FORMATS[form].rounded([[nearest(cell) for cell in row] for row in exact])
        kept.append((BoundedNumbers(cells, off_rationals(exact, cells)), divides))
    return tuple(kept)


def followed(
    projection: Projection, points: Array, way: str, form: str, origin: Vector
) -> BoundedNumbers:
    """Points (n, 3) after one of the ways in a format, and bounds of the errors, (3, n) each.

    They are pixels and depths of float32, and become points measured from the world's `origin`; or
    the other way round, to NDC, for `THERE`. A bound is infinite where w may be 0.
    """
    numbers, point = FORMATS[form], BoundedNumbers(points.T, np.zeros_like(points.T))
    with np.errstate(all="ignore"):
        for matrix, divides in kept_matrices(projection, way, origin, form):
            four = applied(matrix, point, numbers)
            point, w = (BoundedNumbers(*(part[rows] for part in four)) for rows in (slice(3), 3))
            if divides:
                point = divided(point, w, None, numbers)
        error = np.where(np.isfinite(point.value), point.error * (1.0 + 2.0**-40), np.inf)
    return BoundedNumbers(point.value, np.where(np.isnan(error), np.inf, error))


def exact_points(
    projection: Projection, pixels: Array, origin: Vector
) -> list[tuple[Fraction, ...]]:
    """The points of pixels and depths (n, 3), measured from the world's `origin`, in rationals."""
    offset = [Fraction(e) - Fraction(o) for e, o in zip(projection.camera.eye, origin, strict=True)]
    to_ndc, points = ndc_from_pixels(projection), []
    for pixel in pixels.tolist():
        check_pixel(projection, pixel)
        ndc = [dot(row, [*map(Fraction, pixel), Fraction(1)]) for row in to_ndc]
        *xyz, w = (dot(row, ndc) for row in projection.eye_from_clip)
        points.append(tuple(part / w + moved for part, moved in zip(xyz, offset, strict=True)))
    return points


def off_there(
    projection: Projection, place: Array, true: Array, way: str, form: str, origin: Vector
) -> float:
    """How many pixels off its `true` NDC (3,) a world point (3,) is drawn by a way of `THERE`."""
    local = FORMATS[form].rounded(place - np.array(origin))
    ndc = followed(projection, local[None], way, form, origin).value[:2, 0]
    width, height = projection.image_size
    return float(np.hypot(*((ndc - true[:2]) * (width / 2.0, height / 2.0))))
