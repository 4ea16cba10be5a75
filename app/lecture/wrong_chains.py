"""Chains of factors, what they do to points, and the wrong ideas behind wrong ones.

A chain is its factors from left to right, so the rightmost acts first: tiles of the object,
matrices of the pipeline by their names, and divides. Two chains are the same if they do the same
to points; a wrong one is recognised by what it does, whatever its factors.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import NamedTuple, TypeAlias

import numpy as np

from app.lecture.equation import equation_of
from app.lecture.letters import Letters
from app.model.chain import KINDS, Chain, Tile
from app.model.limits import Array
from app.model.projection import Projection
from app.model.refusal import REFUSALS, Refusal
from app.model.tables import VIEWPORT

DIVIDE, DIVIDE_XYZ = "divide", "xyz/w"
"""Divides by w: of all four coordinates, and of three, after which w is left to divide again."""
SAME = 1e-3  # largest difference of equal points, of their largest coordinate: typed numbers
_POINTS = np.array(
    [(0.3, 0.7, -2.1), (1.1, -0.4, -3.2), (-0.8, 0.5, -4.7), (0.6, 1.3, -6.1), (-1.2, -0.9, -5.3)]
)
_COLUMNS = np.vstack([_POINTS.T, np.ones(len(_POINTS))])
_OF_OBJECT = (*{kind.split()[0]: None for kind in KINDS}, "world_from_object")
_OF_VIEW = ("view_from_world", "rotation", "translation")
_OF_LENS = ("clip_from", "canonical_perspective", "canonical_parallel")


class Factor(NamedTuple):
    """A factor: as it is typed, its kind of tile or its name, and its matrix unless it divides."""

    text: str
    kind: str
    matrix: Array | None

    def made(self, how: Callable[[Array], Array]) -> Factor:
        return self if self.matrix is None else self._replace(matrix=how(self.matrix))


Factors: TypeAlias = tuple[Factor, ...]
Change: TypeAlias = Callable[[Factors], Iterable[Factors]]


def factors_of(text: str, projection: Projection, letters: Letters) -> Factors:
    """Read ``M_z; M_pp; off translate 3,0,0``, without what is off; a `Refusal` names a part."""
    parts = (part.strip() for part in text.split(";"))
    return tuple(_read(part, projection, letters) for part in parts if part[:4] != "off ")


def _read(text: str, projection: Projection, letters: Letters) -> Factor:
    if text in (DIVIDE, DIVIDE_XYZ):
        return Factor(text, text, None)
    if text.startswith(_OF_OBJECT):
        return _of_tile(Tile.read(text))
    word, inverted, _ = text.partition("^-1")
    term = equation_of(projection, letters, word).terms[0].matrix
    matrix = np.array(term.values)
    return Factor(text, term.name + inverted, _inverse(matrix) if inverted else matrix)


def _of_tile(tile: Tile) -> Factor:
    return Factor(tile.text, tile.kind, Chain((tile,)).matrix)


def _inverse(matrix: Array) -> Array:
    return np.asarray(np.linalg.pinv(matrix))  # which a scale of 0 has, too


def _transposed(matrix: Array) -> Array:
    return np.asarray(matrix.T)


def effect(chain: Factors, points: Array = _COLUMNS) -> Array:
    """Return what a chain makes of points, (4, n) homogeneous columns."""
    with np.errstate(all="ignore"):
        for factor in reversed(chain):
            if factor.matrix is None:
                w = points[3:]
                points = points / w if factor.kind == DIVIDE else np.vstack([points[:3] / w, w])
            elif factor.kind == VIEWPORT.name:  # it scales and shifts numbers, and w is none
                seen = factor.matrix @ np.vstack([points[:3], np.ones_like(points[3:])])
                points = np.vstack([seen[:3], points[3:]])
            else:
                points = factor.matrix @ points
    return points


def same(one: Array, other: Array) -> bool:
    return bool(np.abs(one - other).max() <= SAME * max(1.0, np.abs(other).max()))


# --------------------------------------------------------------------------- wrong ideas


def _past(one: str | tuple[str, ...], other: str | tuple[str, ...]) -> Change:
    """Move a factor of one kind past one of the other, in either direction."""

    def change(chain: Factors) -> Iterator[Factors]:
        for place, factor in enumerate(chain):
            rest = chain[:place] + chain[place + 1 :]
            for to in range(len(chain)):
                passed = rest[min(place, to) : max(place, to)]
                for mine, its in ((one, other), (other, one)):
                    if factor.kind.startswith(mine) and any(p.kind.startswith(its) for p in passed):
                        yield (*rest[:to], factor, *rest[to:])

    return change


def _each(kind: str | tuple[str, ...], how: Callable[[Factor], Iterable[Factors]]) -> Change:
    """Replace each factor of a kind in turn."""

    def change(chain: Factors) -> Iterator[Factors]:
        for place, factor in enumerate(chain):
            if factor.kind.startswith(kind):
                for others in how(factor):
                    yield (*chain[:place], *others, *chain[place + 1 :])

    return change


def _retyped(kind: str, how: Callable[[tuple[float, ...]], Iterable[float]]) -> Change:
    """Type other numbers into each tile of a kind."""

    def others(factor: Factor) -> Iterator[Factors]:
        tile = Tile.read(factor.text)
        yield (_of_tile(replace(tile, numbers=tuple(how(tile.numbers)))),)

    return _each(kind, others)


def _whole(how: Callable[[Array], Array], *, keeps: bool = False) -> Change:
    """Change every matrix of a chain of matrices, and reverse them unless it keeps the order."""

    def change(chain: Factors) -> Iterator[Factors]:
        if all(factor.matrix is not None for factor in chain):
            made = tuple(factor.made(how) for factor in chain)
            yield made if keeps else made[::-1]

    return change


def _inverted(chain: Factors) -> Iterator[Factors]:
    """Invert the view: its matrix, or the product of its factors."""
    places = [at for at, factor in enumerate(chain) if factor.kind in _OF_VIEW]
    if places:
        first, end = places[0], places[-1] + 1
        view = tuple(factor.made(_inverse) for factor in chain[first:end])
        yield (*chain[:first], *view[::-1], *chain[end:])


def _other_axes(factor: Factor) -> Iterator[Factors]:
    tile = Tile.read(factor.text)
    return ((_of_tile(replace(tile, kind=f"rotate {x}")),) for x in "xyz" if x != tile.kind[-1])


MISTAKES: dict[str, Change] = {
    "model-view": _past(_OF_VIEW, _OF_OBJECT),
    "projection-first": _past(_OF_LENS, _OF_VIEW),
    "turn-moves": _past("translate", "rotate"),
    "scale-moves": _past("translate", "scale"),
    "mirror-moves": _past("translate", "mirror"),
    "scale-turned": _past("rotate", "scale"),
    "mirror-turned": _past("rotate", "mirror"),
    "shear-turned": _past("rotate", "shear"),
    "turns-swapped": _past("rotate", "rotate"),
    "view-order": _past("rotation", "translation"),
    "z-first": _past("depth_range_from", "canonical_parallel"),
    "box-first": _past("canonical_perspective", "canonical_parallel"),
    "viewport-first": _past(VIEWPORT.name, DIVIDE),
    "divide-twice": _each(DIVIDE, lambda factor: [(factor, Factor("", DIVIDE_XYZ, None))]),
    "no-divide": _each(DIVIDE, lambda factor: [()]),
    "turn-sign": _retyped("rotate", lambda numbers: (*numbers[:-1], -numbers[-1])),
    "move-sign": _retyped("translate", lambda numbers: (-part for part in numbers)),
    "scale-inverse": _retyped("scale", lambda numbers: (1.0 / (part or 1.0) for part in numbers)),
    "degrees": _retyped("rotate", lambda numbers: (*numbers[:-1], math.degrees(numbers[-1]))),
    "wrong-axis": _each(("rotate x", "rotate y", "rotate z"), _other_axes),
    "axes-columns": _each("rotation", lambda factor: [(factor.made(_transposed),)]),
    "row-move": _each("transl", lambda factor: [(factor.made(_transposed),)]),
    "left-out": _each("", lambda factor: [()]),
    "inverse": _inverted,
    "undone": _whole(_inverse),
    "inverse-kept": _whole(_inverse, keeps=True),
    "transposed": _whole(_transposed),
    "order": lambda chain: [chain[::-1]],
}
"""What students do to a right chain, by the names of wrong ideas; the first that fits counts."""


def mistake(right: Factors, given: Factors) -> str | None:
    """Return the wrong idea behind a chain, empty if none explains it; None if it is right."""
    wanted, done = effect(right), effect(given)
    if same(done, wanted):
        return None
    for name, change in MISTAKES.items():
        with np.errstate(all="ignore"):
            if any(same(effect(wrong), done) for wrong in change(right)):
                return name
    return ""


def difference(right: Factors, given: Factors) -> Refusal:
    """Say in one sentence what a wrong chain does that the right one does not."""
    (*place, w), (*wanted, depth) = effect(given)[:, 1], effect(right)[:, 1]
    if any(factor.matrix is None for factor in (*right, *given)):
        return Refusal.saying(
            REFUSALS["chain-ends"], written_numbers(place[:2]), written_numbers(wanted[:2])
        )
    if abs(w - depth) > SAME * max(1.0, abs(depth)):
        return Refusal.saying(REFUSALS["chain-w"], _short(w), _short(depth))
    mine, its = effect(given, np.eye(4)), effect(right, np.eye(4))
    size = SAME * max(1.0, float(np.abs(its).max()))
    away = math.dist(mine[:3, 3], its[:3, 3])
    if away <= size:
        axis = int(np.abs(mine - its)[:, :3].max(axis=0).argmax())
        ends = (written_numbers(each[:3, axis]) for each in (mine, its))
        return Refusal.saying(REFUSALS["chain-axis"], "xyz"[axis], *ends)
    far = [math.hypot(*each[:3, 3]) for each in (mine, its)]
    if abs(far[0] - far[1]) <= size:
        return Refusal.saying(REFUSALS["chain-swings"], _short(away))
    return Refusal.saying(
        REFUSALS["chain-origin"], *(written_numbers(each[:3, 3]) for each in (mine, its))
    )


def written_numbers(numbers: Iterable[float]) -> str:
    """Write numbers to four digits in brackets."""
    return f"({', '.join(map(_short, numbers))})"


def _short(number: float) -> str:
    return f"{number + 0.0 if abs(number) > 1e-9 else 0.0:.4g}"
