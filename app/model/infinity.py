"""Homogeneous coordinates: points at infinity, which are directions, through every stage.

``(x, y, z, w)`` is the point ``(x/w, y/w, z/w)``; with w = 0 it is a direction, a point at infinity
(lecture 002). Only the linear part of a matrix applies to a direction: the eye is not subtracted.
The divide by the lens's w turns it into the vanishing point of all lines in this direction.
Everything is computed in rationals and rounded once.
"""

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from app.arithmetic.rationals import dot, nearest, rationals
from app.model.clipping import boundaries
from app.model.limits import LARGEST, Array, Row, finite
from app.model.pipeline import named_point
from app.model.projection import Projection, Trace
from app.model.refusal import REFUSALS, Refusal


def homogeneous(x: object, y: object, z: object, w: object) -> Row:
    """The point ``(x/w, y/w, z/w, 1)``, each rounded once, or the direction ``(x, y, z, 0)``.

    Raises a `Refusal` for a number that is not finite or larger than `LARGEST`, also after the
    divide, and for four zeros.
    """
    given = [finite(name, value) for name, value in zip("xyzw", (x, y, z, w), strict=True)]
    *parts, weight = given
    if weight == 0.0:
        if not any(parts):
            raise Refusal("w", 0.0, REFUSALS["a-direction"])
        return parts[0], parts[1], parts[2], 0.0
    if weight == 1.0:
        return parts[0], parts[1], parts[2], 1.0
    with np.errstate(over="ignore"):
        divided = [float(np.float64(part) / weight) for part in parts]
    point = [finite(f"{name}/w", part) for name, part in zip("xyz", divided, strict=True)]
    return point[0], point[1], point[2], 1.0


def homogeneous_rows(rows: Array) -> Array:
    """Return `homogeneous` of every row, (..., 4), of numbers up to `LARGEST`."""
    parts, weights = rows[..., :3], rows[..., 3:]
    if (weights == 1.0).all():
        return rows
    with np.errstate(over="ignore", under="ignore"):
        divided = parts / np.where(weights == 0.0, 1.0, weights)
    wrong = (np.abs(divided) > LARGEST).any(axis=-1) | ~rows.any(axis=-1)
    for place in np.argwhere(wrong)[:1].tolist():
        try:
            homogeneous(*rows[tuple(place)].tolist())
        except Refusal as error:
            field = f"{named_point(place)}.{error.field}"
            raise Refusal(field, error.value, error.bound, *error.limits) from None
    return np.concatenate([divided, weights != 0.0], axis=-1)


def trace_at_infinity(projection: Projection, direction: Sequence[float | Fraction]) -> Trace:
    """Follow one direction of the world, a point at infinity, through every stage.

    The trace is of one point, without a first axis; `world` and `view` have four numbers, w last.
    NDC, image and depth are those of the vanishing point. They are NaN if w of clip space is 0 (the
    picture is at infinity, too) or negative (the lines come from behind the eye and vanish in the
    opposite direction). ``n . d`` is exactly 0 where it should be.
    """
    world = [Fraction(part) for part in direction] + [Fraction(0)]
    own_view = projection.lens.own_view
    if own_view is None:
        view = [*projection.camera.exact_along(world[:3]), Fraction(0)]
    else:
        view = [dot(row, world) for row in rationals(own_view)]
    clip = [dot(row, view) for row in projection.exact_clip_from_view]
    x, y, z, w = clip
    pictured = [math.nan] * 6
    if w > 0:
        viewport = projection.stages[-1].exact
        ndc = [x / w, y / w, z / w, Fraction(1)]
        pictured = [
            nearest(part) + 0.0 for part in [*ndc[:3], *(dot(row, ndc) for row in viewport[:3])]
        ]
    in_front = all(map(math.isfinite, pictured))
    numbers = np.array(pictured if in_front else [math.nan] * 6)
    world_4, view_4, clip_4 = (
        np.array([nearest(part) for part in each]) + 0.0 for each in (world, view, clip)
    )
    return Trace(
        *(world_4, view_4, clip_4),
        *(numbers[:3], numbers[3:5], numbers[5]),
        np.array(in_front),
        boundaries(np.array(clip), projection.depth) < 0,
    )
