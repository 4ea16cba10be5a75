"""The object's transform as a chain of tiles, its products, and its text.

A chain is written as its product, ``translate 3,0,0; rotate z 90``, so the rightmost tile acts on
the object first: ``world_from_object = T R``. The columns of the product are the object's axes in
the world and its origin (lecture 003).

- `Chain.exact` and `Chain.matrix` are the product of the tiles that are on.
- `Chain.after(k)` is the chain of the k rightmost tiles: its product is where the object stands
  after k moves, and its columns are the axes at that step. ``from_left`` reads the other way.
- `Chain.moved` and `Chain.with_tile` rearrange; `Chain.read` and `Chain.text` are the text form.
- Two chains do the same if their `exact` products are equal, whatever their tiles.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np

from app.arithmetic import double_double as dd
from app.arithmetic.double_double import DoubleDouble
from app.arithmetic.rationals import Rationals, diagonal, dot, eliminate, nearest, product
from app.model import limits
from app.model.formula import Letter
from app.model.limits import Array, Row, Vector
from app.model.numerals import numbers as numbers_in
from app.model.refusal import QT_TRANSLATE_NOOP, REFUSALS, Refusal, format_value
from app.model.refusal import nearest as nearest_word
from app.model.tables import PipelineStep, Table, evaluated, inverse, matrix, rounded

Order: TypeAlias = Literal["trs", "rts"]
ORDERS: tuple[Order, ...] = ("trs", "rts")
"""The factors of `FiveTiles` from left to right; the rightmost one is applied first."""
Space: TypeAlias = Literal["world", "object"]
SPACES: tuple[Space, ...] = ("world", "object")  # the space in which points are given

NOT_TRANSFORMED = QT_TRANSLATE_NOOP("Stage", "the scene's objects are given in world coordinates")
FLATTENED = QT_TRANSLATE_NOOP(
    "Stage", "a scale of 0 flattens the object: it has no inverse and no normals"
)

MOST_TILES = 8
LARGEST_SCALE = 1e30  # largest scale: its product with a coordinate up to `LARGEST` is finite
_LIMITS = (LARGEST_SCALE, LARGEST_SCALE, LARGEST_SCALE, LARGEST_SCALE * limits.LARGEST)
_SLACK = 1.0001  # a product of rotations may be larger than 1 by their last bit
_ROUNDINGS = 6.0  # most roundings in the double-double sum of a coordinate
_STEEP = 1e-12  # a view direction is vertical, and a camera level, to so much
FROM_OBJECT = "world_from_object"


class WorldPoints(NamedTuple):
    """Points in the world with twice the digits of float64."""

    world: Array  # the nearest float64, (n, 3)
    rest: Array | None  # the rounding error, (n, 3); None if there is none
    lost: Array  # bound on the error of their sum, added over the three coordinates, (n,)

    @classmethod
    def at(cls, world: Array) -> "WorldPoints":
        """Points given in world coordinates, (n, 3)."""
        return cls(world, None, np.zeros(len(world)))

    def part(self, which: slice) -> "WorldPoints":
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


class TileKind(NamedTuple):
    """What the tiles of one kind have in common."""

    factor: str  # the name of the factor
    field: str  # what its numbers are called in highlights, and as a parameter
    neutral: tuple[float, ...]  # the numbers of a tile that changes nothing
    table: Table  # in letters, in the order of the numbers
    letters: tuple[str, ...] = ()  # those of the numbers


def _kind(
    factor: str, field: str, neutral: Sequence[float], cells: dict[str, str], *letters: str
) -> TileKind:
    """The kind whose matrix is the identity but for some cells, by row and column: ``"xw"``."""
    rows = [[cells.get(i + j, str(int(i == j))) for j in "xyzw"] for i in "xyzw"]
    table = matrix("\n".join("  ".join(row) for row in rows))
    return TileKind(
        factor, field, tuple(neutral), table, letters or tuple(cells.values())[: len(neutral)]
    )


def _about(axis: str, along: str, across: str) -> TileKind:
    """The rotation about an axis that turns the next axis towards the one after it."""
    cos, sin = f"cos(turn_{axis})", f"sin(turn_{axis})"
    cells = {along * 2: cos, along + across: f"-{sin}", across + along: sin, across * 2: cos}
    return _kind(f"rotation_{axis}", "rotate_deg", (0.0,), cells, f"turn_{axis}")


KINDS: dict[str, TileKind] = {
    "translate": _kind(
        "translation", "translate", (0.0,) * 3, {f"{x}w": f"move_{x}" for x in "xyz"}
    ),
    "rotate x": _about(*"xyz"),
    "rotate y": _about(*"yzx"),
    "rotate z": _about(*"zxy"),
    "rotate": TileKind(
        "rotation", "rotate_deg", (0.0, 1.0, 0.0, 0.0),
        matrix(
            """
            x*x*d + c    x*y*d - z*s  x*z*d + y*s  0
            y*x*d + z*s  y*y*d + c    y*z*d - x*s  0
            z*x*d - y*s  z*y*d + x*s  z*z*d + c    0
            0            0            0            1
            """,
            x="about_x", y="about_y", z="about_z",
            c="cos(turn_a)", s="sin(turn_a)", d="1 - cos(turn_a)",
        ),
        ("about_x", "about_y", "about_z", "turn_a"),
    ),
    "scale": _kind("scale", "scale", (1.0,) * 3, {x * 2: f"size_{x}" for x in "xyz"}),
    **{
        f"shear {a}{b}": _kind(f"shear_{a}{b}", "shear", (0.0,), {a + b: f"shear_{a}{b}"})
        for a in "xyz" for b in "xyz" if a != b
    },
    **{f"mirror {x}": _kind(f"mirror_{x}", "mirror", (), {x * 2: "-1"}) for x in "xyz"},
    "matrix": _kind(
        "matrix", "matrix", [float(i % 5 == 0) for i in range(16)],
        {a + b: f"g_{i}{j}" for i, a in enumerate("xyz", 1) for j, b in enumerate("xyzw", 1)},
    ),
}  # fmt: skip
"""The kinds of tile, as their texts begin. ``rotate`` has an axis and an angle; ``shear xy`` adds a
multiple of y to x."""


@dataclass(frozen=True)
class Tile:
    """One move of an object.

    Raises a `Refusal` for another kind, another count of numbers, numbers that are not finite or
    too large, an axis of length 0, and a typed matrix that is singular or changes w.

    - `kind`: one of `KINDS`.
    - `numbers`: world units, degrees or factors; 16 cells of a matrix, row by row.
    - `is_off`: whether the product leaves it out.
    """

    kind: str
    numbers: tuple[float, ...] = ()
    is_off: bool = False

    def __post_init__(self) -> None:
        kind = KINDS.get(self.kind) if isinstance(self.kind, str) else None
        if kind is None:
            near = nearest_word(str(self.kind), KINDS)
            raise Refusal("chain", self.kind, REFUSALS["no-kind"], ", ".join(KINDS), near)
        field, numbers = kind.field, tuple(self.numbers)
        if len(numbers) != len(kind.neutral):
            raise Refusal(field, numbers, REFUSALS["so-many"], len(kind.neutral), self.kind)
        numbers = tuple(limits.finite(field, part) + 0.0 for part in numbers)
        limits.keep_checked(self, numbers=numbers)
        if field == "matrix":
            if numbers[12:] != (0.0, 0.0, 0.0, 1.0):
                raise Refusal(field, numbers[12:], REFUSALS["has-w"])
            linear = tuple(numbers[i : i + 3] for i in (0, 4, 8))
            if (rank := eliminate([[*map(Fraction, row)] for row in linear]).rank) < 3:
                raise Refusal(field, linear, REFUSALS["invertible"], rank)
        if self.kind == "rotate" and not any(numbers[:3]):
            raise Refusal(field, numbers[:3], REFUSALS["not-zero"])
        if field in ("scale", "shear", "matrix"):
            for place, part in enumerate(numbers):
                if field != "matrix" or place % 4 < 3:
                    limits.within(field, part, -LARGEST_SCALE, LARGEST_SCALE)

    @classmethod
    def read(cls, text: str) -> "Tile":
        """Read a tile as `text` writes it, or raise a `Refusal`."""
        words = text.replace("°", " ").split()
        is_off = words[:1] == ["off"]
        words = words[is_off:]
        kind = next((name for n in (2, 1) if (name := " ".join(words[:n])) in KINDS), "")
        if not kind:
            near = nearest_word(" ".join(words[:2]), KINDS)
            raise Refusal("chain", text, REFUSALS["no-kind"], ", ".join(KINDS), near)
        rest, count = " ".join(words[len(kind.split()) :]), len(KINDS[kind].neutral)
        values = numbers_in(rest.replace(",", ".") if count == 1 else rest)  # a decimal comma
        if values is None or len(values) != count:
            bound = (REFUSALS["so-many"], count, kind) if count else (REFUSALS["no-numbers"], kind)
            raise Refusal("chain", text, *bound)
        return cls(kind, tuple(values), is_off)

    @property
    def text(self) -> str:
        """The tile as it is typed: ``rotate 1,1,0 30``, ``off scale 2,1,1``."""
        parts = [format_value(part) for part in self.numbers]
        groups = {"rotate": (3, 1), "matrix": (4, 4, 4, 4)}.get(self.kind, (len(parts),))
        words = ["off"] * self.is_off + [self.kind]
        for size in groups:
            words += [",".join(parts[:size])] * bool(parts)
            parts = parts[size:]
        return " ".join(words)

    def partly(self, part: float) -> "Tile":
        """A part of the move: of an angle, a way, a factor. A mirror flattens half-way."""
        if self.kind.startswith("mirror"):
            return Tile("scale", tuple(1.0 - 2.0 * part * (x == self.kind[-1]) for x in "xyz"))
        begin = list(KINDS[self.kind].neutral)
        if self.kind == "rotate":
            begin[:3] = self.numbers[:3]
        try:
            return replace(self, numbers=tuple(begin)).towards(self.numbers, part)
        except Refusal:  # a typed matrix that is singular on the way
            return self

    def towards(self, numbers: Sequence[float], part: float) -> "Tile":
        """The tile with its numbers on the way to others."""
        mixed = ((1.0 - part) * a + part * b for a, b in zip(self.numbers, numbers, strict=True))
        return replace(self, numbers=tuple(mixed))


@lru_cache(maxsize=256)
def lettered_kinds(kinds: tuple[str, ...]) -> tuple[TileKind, ...]:
    """The kinds of the tiles of a chain, each in letters of its own.

    The leftmost tile has ``move_x``, the second translation ``move2_x``.
    """
    own, seen = [], dict[str, int]()
    for name in kinds:
        seen[name] = number = seen.get(name, 0) + 1
        kind = KINDS[name]
        if number > 1:
            names = {letter: _numbered(letter, number) for letter in kind.letters}
            terms = {letter: Letter(new) for letter, new in names.items()}
            table = tuple(tuple(cell.where(terms) for cell in row) for row in kind.table)
            kind = TileKind(
                f"{kind.factor}{number}", f"{kind.field}{number}", kind.neutral, table,
                tuple(names.values()),
            )  # fmt: skip
        own.append(kind)
    return tuple(own)


def _numbered(letter: str, number: int) -> str:
    stem, _, part = letter.partition("_")
    return f"{stem}{number}_{part}"


@dataclass(frozen=True)
class Chain:
    """How the object is moved from its own space into the world.

    Raises a `Refusal` for more than `MOST_TILES` tiles, and for a product that is too large.

    - `tiles`: the factors of the product, so the rightmost one acts first.
    """

    tiles: tuple[Tile, ...] = ()

    def __post_init__(self) -> None:
        tiles = tuple(self.tiles) if isinstance(self.tiles, Iterable) else (self.tiles,)
        if not all(isinstance(tile, Tile) for tile in tiles):
            raise Refusal("chain", self.tiles, REFUSALS["a-chain"])
        if len(tiles) > MOST_TILES:
            most, ninth = REFUSALS["chain-too-many"], tiles[MOST_TILES].text
            raise Refusal("chain", ninth, most, MOST_TILES, len(tiles))
        limits.keep_checked(self, tiles=tiles)
        if len(self.on) > 1:
            for row in self.exact[:3]:
                for part, limit in zip(row, _LIMITS, strict=True):
                    if abs(part) > _SLACK * limit:
                        raise Refusal("chain", self.text, REFUSALS["chain-too-large"], limit)

    @classmethod
    def read(cls, text: str) -> "Chain":
        """Read a chain as `text` writes it, tiles between semicolons, or raise a `Refusal`."""
        return cls(tuple(map(Tile.read, text.split(";"))) if text.strip() else ())

    @property
    def text(self) -> str:
        """The chain as it is typed: ``translate 3,0,0; rotate z 90``."""
        return "; ".join(tile.text for tile in self.tiles)

    # -- its tiles

    @cached_property
    def on(self) -> tuple[Tile, ...]:
        """The tiles that are not switched off."""
        return tuple(tile for tile in self.tiles if not tile.is_off)

    @property
    def kinds(self) -> tuple[str, ...]:
        """The kinds of the tiles that are on: what decides the formulas of the product."""
        return tuple(tile.kind for tile in self.on)

    def fields(self) -> tuple[str, ...]:
        """What the numbers of each tile are called in highlights; empty for a tile that is off."""
        names = iter(kind.field for kind in lettered_kinds(self.kinds))
        return tuple("" if tile.is_off else next(names) for tile in self.tiles)

    def after(self, moves: float, *, from_left: bool = False) -> "Chain":
        """The chain after so many moves of the tiles that are on, the last one in part.

        They are read from the right, in the world's axes; or done from the left, in the axes that
        the moves before have moved. Both end in the whole product.
        """
        tiles = self.on if from_left else self.on[::-1]
        made, part = tiles[: int(moves)], moves % 1.0
        if part:
            made = (*made, tiles[int(moves)].partly(part))
        return Chain(made if from_left else made[::-1])

    def place_of(self, *kinds: str) -> int | None:
        """The place of the leftmost tile of some kinds that is on; None if there is none."""
        places = (i for i, each in enumerate(self.tiles) if each.kind in kinds and not each.is_off)
        return next(places, None)

    def with_tile(self, place: int, *tiles: Tile, over: int = 0) -> "Chain":
        """The chain with tiles put in at a place, perhaps over some that stood there."""
        return Chain((*self.tiles[:place], *tiles, *self.tiles[place + over :]))

    def moved(self, place: int, to: int) -> "Chain":
        return self.with_tile(place, over=1).with_tile(to, self.tiles[place])

    @property
    def five(self) -> "FiveTiles | None":
        """The chain as five tiles, if it has these or none."""
        if not self.tiles:
            return FiveTiles()
        for order in ORDERS:
            if self.kinds == FIVE[order] and len(self.on) == len(self.tiles):
                parts = {tile.kind: tile.numbers for tile in self.tiles}
                turn: Any = tuple(parts[f"rotate {axis}"][0] for axis in "xyz")
                move: Any = parts["translate"]
                size: Any = parts["scale"]
                return FiveTiles(move, turn, size, order)
        return None

    def towards(self, other: "Chain", part: float) -> "Chain":
        """A chain between two; the other one, if their tiles are of different kinds."""
        mine, theirs = self.tiles or other._neutral, other.tiles or self._neutral
        if [tile.kind for tile in mine] != [tile.kind for tile in theirs]:
            return other
        return Chain(tuple(a.towards(b.numbers, part) for a, b in zip(mine, theirs, strict=True)))

    @property
    def _neutral(self) -> tuple[Tile, ...]:
        """The tiles with the numbers that change nothing."""
        return tuple(replace(each, numbers=KINDS[each.kind].neutral) for each in self.tiles)

    # -- its products

    @property
    def step(self) -> PipelineStep:
        """`world_from_object` as formulas; the identity has no factors."""
        if self.is_identity:
            return PipelineStep(FROM_OBJECT, note=NOT_TRANSFORMED)
        factors = tuple((kind.factor, kind.table) for kind in lettered_kinds(self.kinds))
        return PipelineStep(FROM_OBJECT, factors, FLATTENED if self.rank < 3 else "")

    @cached_property
    def letters(self) -> dict[str, Fraction]:
        """The values of the letters; sines and cosines have `double_double.BITS` bits."""
        known: dict[str, Fraction] = {}
        for kind, tile in zip(lettered_kinds(self.kinds), self.on, strict=True):
            values = [*map(Fraction, tile.numbers)]
            if tile.kind == "rotate":
                length = dd.root(dot(values[:3], values[:3]))
                values[:3] = [dd.cut(part / length) for part in values[:3]]
            known |= zip(kind.letters, values, strict=False)
            if tile.kind.startswith("rotate"):
                angle = kind.letters[-1]
                known[f"cos({angle})"], known[f"sin({angle})"] = dd.cos_sin_deg(values[-1])
        return known

    @cached_property
    def factors(self) -> tuple[Rationals, ...]:
        """The matrices of the tiles that are on, before they are rounded."""
        tables = [kind.table for kind in lettered_kinds(self.kinds)]
        return tuple(evaluated(table, self.letters) for table in tables)

    @cached_property
    def exact(self) -> Rationals:
        """`world_from_object` before it is rounded.

        All denominators are powers of 2, so whole numbers are multiplied, which takes a tenth.
        """
        numbers, bits = [[int(i == j) for j in range(4)] for i in range(4)], 0
        for factor in self.factors:
            unit = max(part.denominator for row in factor for part in row)
            whole = [[x.numerator * (unit // x.denominator) for x in row] for row in factor]
            numbers, bits = product(numbers, whole), bits + unit.bit_length() - 1
        return [[Fraction(part, 1 << bits) for part in row] for row in numbers]

    @cached_property
    def matrix(self) -> Array:
        """`world_from_object`, (4, 4), every number rounded once."""
        return rounded(self.exact)

    @cached_property
    def directions(self) -> Array:
        """Directions of the object's axes as columns (3, 3), also of a flattened axis."""
        linear = Chain(tuple(tile for tile in self.on if tile.kind != "scale")).matrix[:3, :3]
        return np.asarray(linear / np.linalg.norm(linear, axis=0))

    @cached_property
    def is_identity(self) -> bool:
        """Whether object coordinates are world coordinates."""
        return not self.on or self.exact == diagonal(1, 1, 1, 1)

    @cached_property
    def rank(self) -> int:
        """Rank of the linear part: 3, or less if a scale of 0 flattens the object."""
        if all(all(tile.numbers) for tile in self.on if tile.kind == "scale"):
            return 3
        return eliminate([row[:3] for row in self.exact[:3]]).rank

    def placed(self, points_object: Array, one: int = 1) -> WorldPoints:
        """Points (n, 3) of the object in the world, or directions, whose `one` is 0.

        Each coordinate is a sum of four double-double terms, so that the points of a distant object
        keep the digits in which they differ.
        """
        if self.is_identity:
            return WorldPoints.at(points_object)
        columns = points_object.T
        high, low, lost = [], [], np.zeros(len(points_object))
        for parts in self._double:
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
        kept, local = self._kept, self._kept.get((origin, target))
        if local is not None:
            return np.asarray(local)
        kept[origin] = kept.get(origin) or self.exactly(origin)
        local = self.matrix.copy()
        for row, (part, away) in enumerate(zip(kept[origin], target, strict=True)):
            local[row, 3] = float(part - Fraction(away))
        if origin == target:
            kept[origin, target] = local
        return limits.read_only(local)

    @cached_property
    def _kept(self) -> dict[tuple[Any, ...], Any]:
        """World places of origins and matrices between them, which a step asks for again."""
        return {}

    @cached_property
    def _double(self) -> list[list[DoubleDouble]]:
        return [
            [DoubleDouble(*map(np.asarray, dd.from_exact(part))) for part in row]
            for row in self.exact[:3]
        ]


NOT_MOVED = Chain()


def view_chain(frame: Array, eye: Vector) -> Chain:
    """The view matrix as the moves that placed a camera, undone: ``Rz Rx Ry T``.

    `frame` has the rows u, v, n. The camera was tilted about its own z, if at all, and about x,
    turned about y, and moved to its eye.
    """
    (u_x, u_y, u_z), (_, v_y, _), (n_x, n_y, n_z) = frame.tolist()
    is_level = math.hypot(n_x, n_z) > _STEEP
    turn = math.atan2(n_x, n_z) if is_level else math.atan2(-u_z, u_x)
    tilt, roll = math.atan2(-n_y, math.hypot(n_x, n_z)), math.atan2(u_y, v_y) if is_level else 0.0
    turns = {"rotate z": roll, "rotate x": tilt, "rotate y": turn}
    undone = [Tile(kind, (-math.degrees(angle),)) for kind, angle in turns.items()]
    x, y, z = eye
    return Chain((*undone[abs(roll) < _STEEP :], Tile("translate", (-x, -y, -z))))


_TURNS = tuple(f"rotate {axis}" for axis in "zyx")
FIVE: dict[str, tuple[str, ...]] = {
    "trs": ("translate", *_TURNS, "scale"),
    "rts": (*_TURNS, "translate", "scale"),
}


@dataclass(frozen=True)
class FiveTiles:
    """The chain ``T Rz Ry Rx S`` or ``Rz Ry Rx T S`` by its numbers, as lessons set them.

    Documents before version 3 have only these. Raises a `Refusal` as `Tile` does.

    - `rotate_deg`: about the fixed axes x, then y, then z; right-handed.
    - `order`: "trs": scale, rotate, move; or "rts": scale, move, rotate about the world's origin.
    """

    translate: Vector = (0.0, 0.0, 0.0)
    rotate_deg: Vector = (0.0, 0.0, 0.0)
    scale: Vector = (1.0, 1.0, 1.0)
    order: Order = "trs"

    def __post_init__(self) -> None:
        for field in ("translate", "rotate_deg", "scale"):
            limits.keep_checked(self, **{field: limits.finite_vector(field, getattr(self, field))})
        limits.check_name("order", self.order, ORDERS)
        _ = self.chain  # which checks the sizes of the numbers

    @property
    def chain(self) -> Chain:
        turns = {f"rotate {x}": (part,) for x, part in zip("xyz", self.rotate_deg, strict=True)}
        parts = {"translate": self.translate, "scale": self.scale} | turns
        return Chain(tuple(Tile(kind, parts[kind]) for kind in FIVE[self.order]))
