"""The object's translation, rotation and scale, and their matrix.

``world_from_object = T Rz Ry Rx S`` (lecture 003): its first columns are the object's axes in the
world, and the last one is the object's origin. The other order, R T S, moves the object first and
then rotates it about the world's origin.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, reduce
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np

from app.arithmetic import double_double as dd
from app.arithmetic.double_double import DoubleDouble
from app.arithmetic.rationals import Rationals, dot, nearest, product
from app.model.limits import ONE_OF, Array, Row, Vector, finite_vector, keep_checked, within
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from app.model.tables import PipelineStep, evaluated, inverse, matrix, rounded

Order: TypeAlias = Literal["trs", "rts"]
ORDERS: tuple[Order, ...] = ("trs", "rts")
"""The factors from left to right; the rightmost one is applied first."""
Space: TypeAlias = Literal["world", "object"]
SPACES: tuple[Space, ...] = ("world", "object")  # the space in which points are given

NOT_TRANSFORMED = QT_TRANSLATE_NOOP("Stage", "the scene's objects are given in world coordinates")
FLATTENED = QT_TRANSLATE_NOOP(
    "Stage", "a scale of 0 flattens the object: it has no inverse and no normals"
)

LARGEST_SCALE = 1e30  # largest scale: its product with a coordinate up to `LARGEST` is finite
_ROUNDINGS = 6.0  # most roundings in the double-double sum of a coordinate


class WorldPoints(NamedTuple):
    """Points in the world with twice the digits of float64."""

    world: Array  # the nearest float64, (n, 3)
    rest: Array | None  # the rounding error, (n, 3); None if there is none
    lost: Array  # bound on the error of their sum, added over the three coordinates, (n,)

    @classmethod
    def at(cls, world: Array) -> WorldPoints:
        """Points given in world coordinates, (n, 3)."""
        return cls(world, None, np.zeros(len(world)))

    def part(self, which: slice) -> WorldPoints:
        rest = None if self.rest is None else self.rest[which]
        return WorldPoints(self.world[which], rest, self.lost[which])

    def nearest_offset(self, origin: Sequence[float] | Array) -> Array:
        """`offset`, rounded to float64: less work."""
        if self.rest is not None:
            return self.offset(origin).hi
        return np.asarray(np.ascontiguousarray(self.world.T) - np.reshape(origin, (3, 1)))

    def offset(self, origin: Sequence[float] | Array) -> DoubleDouble:
        """The offset of the points from a world point, (3, n), without cancellation."""
        offset = dd.two_sum(np.ascontiguousarray(self.world.T), -np.reshape(origin, (3, 1)))
        return offset if self.rest is None else dd.two_sum(offset.hi, offset.lo + self.rest.T)


_TRANSLATION = matrix("""
    1  0  0  move_x
    0  1  0  move_y
    0  0  1  move_z
    0  0  0  1
""")
_SCALE = matrix("""
    size_x  0       0       0
    0       size_y  0       0
    0       0       size_z  0
    0       0       0       1
""")
_TURNS = (
    (
        "rotation_z",
        matrix("""
            cos(turn_z)  -sin(turn_z)  0  0
            sin(turn_z)  cos(turn_z)   0  0
            0           0            1  0
            0           0            0  1
        """),
    ),
    (
        "rotation_y",
        matrix("""
            cos(turn_y)   0  sin(turn_y)  0
            0            1  0           0
            -sin(turn_y)  0  cos(turn_y)  0
            0            0  0           1
        """),
    ),
    (
        "rotation_x",
        matrix("""
            1  0           0            0
            0  cos(turn_x)  -sin(turn_x)  0
            0  sin(turn_x)  cos(turn_x)   0
            0  0           0            1
        """),
    ),
)
FROM_OBJECT = "world_from_object"
FACTORS = {  # the factors of `world_from_object`, by order
    "trs": (("translation", _TRANSLATION), *_TURNS, ("scale", _SCALE)),
    "rts": (*_TURNS, ("translation", _TRANSLATION), ("scale", _SCALE)),
}


@dataclass(frozen=True)
class ObjectTransform:
    """How the object is scaled, rotated and moved from its own space into the world.

    Raises a `Refusal` for a number that is not finite or larger than `LARGEST`, a scale beyond
    `LARGEST_SCALE`, or another order.

    - `translate`: world units.
    - `rotate_deg`: about the fixed axes x, then y, then z; right-handed.
    - `scale`: along the object's own axes; 0 flattens it, a negative number mirrors it.
    - `order`: "trs": scale, rotate, move; or "rts": scale, move, rotate about the world's origin.
    """

    translate: Vector = (0.0, 0.0, 0.0)
    rotate_deg: Vector = (0.0, 0.0, 0.0)
    scale: Vector = (1.0, 1.0, 1.0)
    order: Order = "trs"

    def __post_init__(self) -> None:
        for field in ("translate", "rotate_deg", "scale"):
            keep_checked(self, **{field: finite_vector(field, getattr(self, field))})
        for part in self.scale:
            within("scale", part, -LARGEST_SCALE, LARGEST_SCALE)
        if not isinstance(self.order, str) or self.order not in ORDERS:
            raise Refusal("order", self.order, ONE_OF, ", ".join(ORDERS))

    @property
    def step(self) -> PipelineStep:
        """`world_from_object` as formulas; the identity has no factors."""
        if self.is_identity:
            return PipelineStep(FROM_OBJECT, note=NOT_TRANSFORMED)
        return PipelineStep(FROM_OBJECT, FACTORS[self.order], FLATTENED if self.rank < 3 else "")

    @cached_property
    def letters(self) -> dict[str, Fraction]:
        """The values of the letters; sines and cosines have `double_double.BITS` bits."""
        known: dict[str, Fraction] = {}
        for letter, vector in (("move", self.translate), ("size", self.scale)):
            known |= {
                f"{letter}_{x}": Fraction(part) for x, part in zip("xyz", vector, strict=True)
            }
        for x, angle_deg in zip("xyz", self.rotate_deg, strict=True):
            known[f"turn_{x}"] = Fraction(angle_deg)
            cos, sin = dd.cos_sin_deg(Fraction(angle_deg))
            known |= {f"cos(turn_{x})": cos, f"sin(turn_{x})": sin}
        return known

    @cached_property
    def exact(self) -> Rationals:
        """`world_from_object` before it is rounded."""
        if self.is_identity:
            return [[Fraction(i == j) for j in range(4)] for i in range(4)]
        return reduce(product, [evaluated(table, self.letters) for _, table in self.step.factors])

    @cached_property
    def matrix(self) -> Array:
        """`world_from_object`, (4, 4), every number rounded once."""
        return rounded(self.exact)

    @cached_property
    def is_identity(self) -> bool:
        """Whether object coordinates are world coordinates."""
        return (
            not any(self.translate)
            and all(angle % 360.0 == 0.0 for angle in self.rotate_deg)
            and self.scale == (1.0, 1.0, 1.0)
        )

    @property
    def rank(self) -> int:
        """Rank of the linear part: 3, or less if a scale of 0 flattens the object."""
        return sum(part != 0.0 for part in self.scale)

    def placed(self, points_object: Array, one: int = 1) -> WorldPoints:
        """Points (n, 3) of the object in the world, or directions, whose `one` is 0.

        Each coordinate is a sum of four double-double terms, so that the points of a distant object
        keep the digits in which they differ.
        """
        if self.is_identity:
            return WorldPoints.at(points_object)
        columns = points_object.T
        high, low, lost = [], [], np.zeros(len(points_object))
        for row in self.exact[:3]:
            parts = [DoubleDouble(*map(np.asarray, dd.from_exact(part))) for part in row]
            total = DoubleDouble(*(one * part + np.zeros(len(points_object)) for part in parts[3]))
            sizes = np.abs(total.hi)
            for part, column in zip(parts, columns, strict=False):
                term = dd.multiply(part, DoubleDouble(column, np.zeros_like(column)))
                sizes = sizes + np.abs(term.hi)
                total = dd.add(total, term)
            high.append(total.hi)
            low.append(total.lo)
            lost += _ROUNDINGS * dd.RELATIVE_ERROR * sizes + dd.UNDERFLOW
        return WorldPoints(np.stack(high, axis=1), np.stack(low, axis=1), lost)

    def exactly(self, point_object: Sequence[Any], one: int = 1) -> tuple[Any, ...]:
        """A point of the object in the world, or a direction (`one` is 0), without rounding.

        Its coordinates are floats, or any exact numbers.
        """
        numbers = [Fraction(part) if isinstance(part, float) else part for part in point_object]
        return tuple(
            sum((a * b for a, b in zip(row, numbers, strict=False)), row[3] * one)
            for row in self.exact[:3]
        )

    def object_from_world(self, homogeneous: Sequence[float]) -> Row:
        """A point or a direction of the world in object coordinates, each rounded once.

        A number beyond float64 is infinite. Raises a `Refusal` for an object that a scale of 0 has
        flattened.
        """
        numbers = [*map(Fraction, homogeneous)]
        x, y, z, w = (nearest(dot(row, numbers)) for row in inverse(FROM_OBJECT, self.exact))
        return x, y, z, w

    def local_from(self, origin: Vector, target: Vector) -> Array:
        """From object coordinates relative to `origin` to world ones relative to `target`, (4, 4).

        Every number is rounded once, after the difference of the origins.
        """
        exact = [list(row) for row in self.exact]
        for row, part, away in zip(exact, self.exactly(origin), target, strict=False):
            row[3] = part - Fraction(away)
        return rounded(exact)


NOT_MOVED = ObjectTransform()
