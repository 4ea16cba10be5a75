"""Chains of factors, what they do to points, and the wrong ideas behind wrong ones.

A chain is its factors from left to right, so the rightmost acts first: tiles of the object,
matrices of the pipeline by their names, and divides. Two chains are the same if they do the same
to points; a wrong one is recognised by what it does, whatever its factors.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from app.lecture.equation import equation_of
from app.lecture.letters import Letters
from app.model.chain import KINDS, Chain, Tile
from app.model.limits import Array
from app.model.projection import Projection
from app.model.refusal import REFUSALS, Bound, Refusal
from app.model.tables import VIEWPORT

DIVIDE, DIVIDE_XYZ = "divide", "xyz/w"
"""Divides by w: of all four coordinates, and of three, after which w is left to divide again."""
SAME = 1e-3  # largest difference of equal points, of their largest coordinate: typed numbers
_POINTS = np.array(
    [(0.3, 1.1, -0.8, 0.6), (0.7, -0.4, 0.5, 1.3), (-2.1, -3.2, -4.7, -6.1), (1.0, 1.0, 1.0, 1.0)]
)
_OF_OBJECT = (*{kind.split()[0]: None for kind in KINDS}, "world_from_object")
_OF_VIEW = ("view_from_world", "rotation", "translation")
OF_LENS = ("clip_from", "canonical_perspective", "canonical_parallel")
_AXES = tuple(kind for kind in KINDS if kind.startswith("rotate "))


class Factor(NamedTuple):
    """A factor: as it is typed, its kind of tile or its name, and its matrix unless it divides."""

    text: str
    kind: str
    matrix: Array | None


Factors: TypeAlias = tuple[Factor, ...]
Change: TypeAlias = Callable[[Factors], Iterable[Factors]]
Kinds: TypeAlias = str | tuple[str, ...]  # beginnings of the kinds of factors


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
    return Factor(text, term.name + inverted, np.linalg.pinv(matrix) if inverted else matrix)


def _of_tile(tile: Tile) -> Factor:
    return Factor(tile.text, tile.kind, Chain((tile,)).matrix)


def tiles_of(chain: Chain) -> Factors:
    return tuple(map(_of_tile, chain.on))


def effect(chain: Factors, points: Array = _POINTS) -> Array:
    """Return what a chain makes of points, (4, n) homogeneous columns."""
    with np.errstate(all="ignore"):
        for _, kind, matrix in reversed(chain):
            w = points[3:]
            if matrix is None:
                points = points / w if kind == DIVIDE else np.vstack([points[:3] / w, w])
            elif kind == VIEWPORT.name:  # it scales and shifts numbers, and w is none
                points = np.vstack([(matrix @ [*points[:3], np.ones(points.shape[1])])[:3], w])
            else:
                points = matrix @ points
    return points


def same(one: Array, other: Array) -> bool:
    return bool(np.abs(one - other).max() <= SAME * max(1.0, np.abs(other).max()))


# --------------------------------------------------------------------------- wrong ideas


def _past(one: Kinds, other: Kinds) -> Change:
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


def _each(kinds: Kinds, how: Callable[[Factor], Iterable[Factors]]) -> Change:
    return lambda chain: (
        (*chain[:place], *others, *chain[place + 1 :])
        for place, factor in enumerate(chain) if factor.kind.startswith(kinds)
        for others in how(factor)
    )  # fmt: skip


def _retyped(kinds: Kinds, how: Callable[[tuple[float, ...]], Iterable[float]]) -> Change:
    """Type other numbers into each tile of some kinds."""

    def others(factor: Factor) -> Iterator[Factors]:
        tile = Tile.read(factor.text)
        yield (_of_tile(replace(tile, numbers=tuple(how(tile.numbers)))),)

    return _each(kinds, others)


def _about_others(factor: Factor) -> Iterator[Factors]:
    tile = Tile.read(factor.text)
    return ((_of_tile(replace(tile, kind=kind)),) for kind in _AXES if kind != tile.kind)


def _made(chain: Factors, how: Callable[[Any], Any]) -> list[Factors]:
    """Change every matrix of a chain; there is no such chain with a divide."""
    matrices = [factor.matrix for factor in chain if factor.matrix is not None]
    whole = tuple(Factor("", "", how(matrix)) for matrix in matrices)
    return [whole] if len(whole) == len(chain) else []


def _single(kinds: Kinds, how: Callable[[Any], Any]) -> Change:
    return _each(kinds, lambda factor: _made((factor,), how))


MISTAKES: dict[str, Change] = {
    "model-view": _past(_OF_VIEW, _OF_OBJECT),
    "projection-first": _past(OF_LENS, _OF_VIEW),
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
    "wrong-axis": _each(_AXES, _about_others),
    "axes-columns": _single("rotation", np.transpose),
    "row-move": _single(("translate", "translation"), np.transpose),
    "left-out": _each("", lambda factor: [()]),
    "inverse": _single("view_from_world", np.linalg.pinv),
    "undone": lambda chain: _made(chain[::-1], np.linalg.pinv),
    "inverse-kept": lambda chain: _made(chain, np.linalg.pinv),
    "transposed": lambda chain: _made(chain[::-1], np.transpose),
    "order": lambda chain: [chain[::-1]],
}
"""What students do to a right chain, by the names of wrong ideas; the first that fits counts."""


def mistake(right: Factors, given: Factors) -> str | None:
    """Return the wrong idea behind a chain, empty if none explains it; None if it is right."""
    done = effect(given)
    if same(done, effect(right)):
        return None
    fits = (
        name
        for name, change in MISTAKES.items()
        if any(same(effect(wrong), done) for wrong in change(right))
    )
    return next(fits, "")


def difference(right: Factors, given: Factors) -> Refusal:
    """Say in one sentence what a wrong chain does that the right one does not."""
    place, wanted = (effect(chain)[:, 1] for chain in (given, right))
    if any(factor.matrix is None for factor in (*right, *given)):
        return _saying(REFUSALS["chain-ends"], place[:2], wanted[:2])
    if abs(place[3] - wanted[3]) > SAME * max(1.0, abs(wanted[3])):
        return _saying(REFUSALS["chain-w"], place[3], wanted[3])
    mine, its = (effect(chain, np.eye(4))[:3] for chain in (given, right))
    size = SAME * max(1.0, float(np.abs(its).max()))
    axis = int(np.abs(mine - its)[:, :3].max(axis=0).argmax())
    far, its_far, away = (math.hypot(*each[:, 3]) for each in (mine, its, mine - its))
    if np.abs(mine - its).max() <= size:
        return _saying(REFUSALS["chain-same"])
    if away <= size:
        return _saying(REFUSALS["chain-axis"], "xyz"[axis], mine[:, axis], its[:, axis])
    if abs(far - its_far) <= size:
        return _saying(REFUSALS["chain-swings"], away)
    return _saying(REFUSALS["chain-origin"], mine[:, 3], its[:, 3])


def _saying(said: Bound, *parts: Any) -> Refusal:
    written = (part if isinstance(part, str) else written_numbers(part) for part in parts)
    return Refusal.saying(said, *written)


def written_numbers(numbers: Any) -> str:
    """Write a number to four digits, or several in brackets."""
    if np.ndim(numbers):
        return f"({', '.join(map(written_numbers, numbers))})"
    return f"{numbers if abs(numbers) > 1e-9 else 0.0:.4g}"
