"""Typed matrices: recognise lenses and cameras, and state the properties of other matrices.

A typed matrix is recognised up to a positive factor, which does not change the picture, and up to
the rounding of the lens' fields to float64. If several values of a field fit, the present value
comes first, then short decimals (`app.model.lenses.solving`). Properties such as the rank, the sign
of the determinant and where w vanishes are decided in rationals.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple

from app.arithmetic.rationals import Rationals, dot, eliminate, rationals
from app.model.lenses.lens import plane_letters
from app.model.lenses.solving import DIGITS, MEANT, same, shortest
from app.model.limits import Cells, finite_matrix
from app.model.projection import LENSES, ONE_OF, Camera, FreeMatrix, Lens, Projection, Vector
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from app.model.tables import evaluated

EDITABLE = ("view_from_world", "clip_from_view")
"""The matrices with editable cells."""

_RIGID = 2.0**-46
"""Tolerance of a rotation's rows for length 1 and right angles.

Rounding each cell once costs 2^-52; 64 times that allows for another program's float64 arithmetic.
It is far less than the error of six typed digits: a shear by 1e-7 is no rotation.
"""
_UNIT = Fraction(1, 2**52)


# --------------------------------------------------------------------------- editing


def shown(projection: Projection, name: str) -> Cells:
    """Return one of the `EDITABLE` matrices, every cell rounded once, as an edit begins.

    Raises
    ------
    Refusal
        For another name.
    """
    stages = {
        "view_from_world": projection.stages[1],
        "clip_from_view": projection.direct_stages[0],
    }
    if name not in stages:
        raise Refusal("matrix", name, ONE_OF, ", ".join(EDITABLE))
    return finite_matrix(name, (stages[name].matrix + 0.0).tolist())


def with_cell(projection: Projection, name: str, row: int, column: int, value: float) -> Projection:
    """Return the projection with another number in one cell; see `with_matrix`."""
    cells: list[Any] = [list(line) for line in shown(projection, name)]
    if cells[row][column] == value:
        return projection
    cells[row][column] = value
    return with_matrix(projection, name, cells)


def with_matrix(projection: Projection, name: str, matrix: Sequence[Sequence[float]]) -> Projection:
    """Return the projection with another of the `EDITABLE` matrices (4, 4).

    The lens is of the present kind, or of the kind before a free matrix, if that kind has the
    matrix; else the simplest lens that has it, else a `FreeMatrix`. The same holds for the camera.

    Raises
    ------
    Refusal
        For a cell that is not finite or beyond `LARGEST`, or another name.
    """
    cells = finite_matrix(name, matrix)
    if cells == shown(projection, name):
        return projection
    lens, camera = projection.lens, projection.camera
    former = lens.former
    clip_from_view = shown(projection, "clip_from_view")
    view_from_world = lens.own_view
    if name == "view_from_world":
        found = recognised_camera(cells, camera)
        camera, view_from_world = (camera, cells) if found is None else (found, None)
    else:
        clip_from_view = cells
    if view_from_world is None:
        if lens is former and name == "view_from_world":
            return replace(projection, camera=camera)
        moved = replace(projection, camera=camera, lens=former)
        standard = recognised_lens(clip_from_view, moved)
        if standard is not None:
            return replace(moved, lens=standard)
    return replace(
        projection, camera=camera, lens=FreeMatrix(clip_from_view, view_from_world, former)
    )


# --------------------------------------------------------------------------- recognition: lenses


def recognised_lens(cells: Cells, projection: Projection) -> Lens | None:
    """Return the lens whose ``clip_from_view`` this is, up to a positive factor, or None.

    A negative factor reverses w: everything would be behind the eye. `projection` gives the image,
    the depth range, and the present lens, whose kind and fields come first.
    """
    exact = rationals(cells)
    for kind in sorted(LENSES, key=lambda kind: kind != projection.lens.kind):
        normalised = _normalised(kind, exact)
        if normalised is None:
            continue
        for lens in _candidates(kind, normalised, projection):
            if _has(lens, normalised, projection):
                return lens
    return None


def _normalised(kind: str, exact: Rationals) -> Rationals | None:
    """Divide a matrix by a positive factor to get the last row of a lens' table, or return None."""
    row = evaluated(LENSES[kind]().table.clip_from_view[3:], {})[0]
    factors = {part / unit for part, unit in zip(exact[3], row, strict=True) if unit}
    factor = factors.pop()
    if factors or factor <= 0 or exact[3] != [factor * unit for unit in row]:
        return None
    return [[part / factor for part in line] for line in exact]


def _candidates(kind: str, exact: Rationals, projection: Projection) -> Iterator[Lens]:
    """Yield lenses of a kind that may have the matrix, those with the present fields first."""
    try:
        near, far = _planes(LENSES[kind](), exact, projection)
        yield from LENSES[kind].having(exact, near, far, projection.lens)
    except (Refusal, ZeroDivisionError, OverflowError):
        return


def _planes(lens: Lens, exact: Rationals, projection: Projection) -> tuple[float, float]:
    """Return near and far for the row of z: the present ones if they fit, else solved ones."""
    (a, b), (c, d) = exact[2][2:], exact[3][2:]
    z_near, z_far = map(Fraction, projection.depth_range)

    def row(near: float, far: float) -> tuple[float, ...]:
        letters = {**plane_letters(*lens.checked_planes(near, far)), "z_n": z_near, "z_f": z_far}
        cells = lens.table_to(far).clip_from_view[2][2:]
        return tuple(float(cell.value(letters)) for cell in cells)

    wanted, sizes = (float(a), float(b)), (1.0, float(d))
    in_hand = projection.lens
    in_reach = in_hand.far != math.inf or lens.far_may_be_infinite
    if in_reach and row(in_hand.near, in_hand.far) == wanted:
        return in_hand.near, in_hand.far
    # At near, z of clip space is z_near w: a z + b = z_near (c z + d), for z of view space.
    solved = (b - z_near * d) / (a - z_near * c)
    if a == z_far * c and lens.far_may_be_infinite:
        return shortest(partial(row, far=math.inf), (solved,), wanted, sizes)[0], math.inf
    near, far = shortest(row, (solved, (b - z_far * d) / (a - z_far * c)), wanted, sizes)
    return near, far


def _has(lens: Lens, exact: Rationals, projection: Projection) -> bool:
    """Whether a lens has the matrix, cell by cell, up to the rounding of its fields."""
    try:
        own = replace(projection, lens=lens).direct_stages[0].exact
    except Refusal:  # the image makes this window impossible
        return False
    for i, (mine, typed) in enumerate(zip(own, exact, strict=True)):
        sizes = lens.least_terms(typed, i)
        for a, b, size in zip(mine, typed, sizes, strict=True):
            if not same(a, b, max(abs(b), size)):
                return False
    return True


# --------------------------------------------------------------------------- recognition: cameras


def recognised_camera(cells: Cells, in_hand: Camera) -> Camera | None:
    """Return the camera whose ``view_from_world`` this is, or None.

    It keeps the distance to the target of `in_hand`, and its up if that gives the same frame.
    """
    exact = rationals(cells)
    if exact[3] != [0, 0, 0, 1]:
        return None
    rows, shift = [row[:3] for row in exact[:3]], [row[3] for row in exact[:3]]
    if not _is_rigid(rows) or eliminate(rows).determinant < 0:
        return None
    solved = [-dot(column, shift) for column in zip(*rows, strict=True)]
    # Rounding rows and shift costs 3 2^-53 of the shift, rounding the eye as much.
    room = 2 * _UNIT * max(map(abs, shift))
    eye = _near(solved, in_hand.eye, room)
    distance = Fraction(in_hand.distance)
    ahead = [Fraction(e) - distance * n for e, n in zip(eye, rows[2], strict=True)]
    room += 2 * _UNIT * distance
    target = _near(ahead, in_hand.target, room)
    typed_up = tuple(map(float, rows[1]))
    for up in (in_hand.up, typed_up):
        try:
            camera = Camera(eye, target, up)  # type: ignore[arg-type]
        except Refusal:
            continue
        turned = max(
            abs(a - b)
            for axis, row in zip(camera.exact_frame, rows, strict=True)
            for a, b in zip(axis, row, strict=True)
        )
        if turned <= Fraction(_RIGID) + 16 * room / distance:
            return camera
    return None


def _is_rigid(rows: Rationals) -> bool:
    """Whether rows have length 1 and right angles, up to rounding."""
    pairs = itertools.combinations_with_replacement(range(len(rows)), 2)
    return all(abs(dot(rows[i], rows[j]) - (i == j)) <= Fraction(_RIGID) for i, j in pairs)


def _near(solved: Sequence[Fraction], in_hand: Vector, room: Fraction) -> Vector:
    """Return the present numbers if they are near the solved ones, else the shortest decimals.

    Each cell that was typed was rounded together with the earlier ones, so the user most likely
    meant a decimal with few digits.
    """
    x, y, z = (
        was if abs(Fraction(was) - number) <= 8 * room else _short(number, room)
        for number, was in zip(solved, in_hand, strict=True)
    )
    return x, y, z


def _short(number: Fraction, room: Fraction) -> float:
    if abs(number) <= 8 * room:
        return 0.0
    for digits in range(1, DIGITS):
        rounded = float(f"{float(number):.{digits - 1}e}")
        if abs(Fraction(rounded) - number) <= (8 if digits <= MEANT else 1) * room:
            return rounded
    return float(number)


# --------------------------------------------------------------------------- properties

AFFINE = QT_TRANSLATE_NOOP("Matrix", "affine: w is {0} everywhere")
NOT_AFFINE = QT_TRANSLATE_NOOP("Matrix", "not affine: w depends on {0}")
SINGULAR = QT_TRANSLATE_NOOP("Matrix", "singular (rank {0}): the frustum cannot be drawn")
MIRRORED_VIEW = QT_TRANSLATE_NOOP(
    "Matrix", "mirrored: it turns right-handed space into left-handed (determinant {0})"
)
MIRRORED_CLIP = QT_TRANSLATE_NOOP(
    "Matrix", "mirrored: as if left and right, top and bottom, or near and far were exchanged"
)
NOT_RIGID = QT_TRANSLATE_NOOP(
    "Matrix", "not rigid: it changes lengths or angles, so that no camera has it"
)
W_VANISHES = QT_TRANSLATE_NOOP(
    "Matrix", "w vanishes where {0} = 0: the divide sends these points to infinity"
)
W_IS_NOT_POSITIVE = QT_TRANSLATE_NOOP("Matrix", "w is {0} everywhere: there is no picture")
ALL_BEHIND = QT_TRANSLATE_NOOP(
    "Matrix", "w is negative all over the view volume: there is no picture"
)
THROUGH_INFINITY = QT_TRANSLATE_NOOP(
    "Matrix", "the view volume reaches infinity: the frustum cannot be drawn"
)


class Property(NamedTuple):
    """One property of a matrix: a template and the figures in it."""

    template: str
    figures: tuple[str, ...] = ()

    def __str__(self) -> str:
        return self.template.format(*self.figures)


def _few(value: float) -> str:
    return f"{value:.4g}".replace("-", "−")


def properties(
    projection: Projection, name: str, write: Callable[[float], str] = _few
) -> list[Property]:
    """Return the properties of one of the `EDITABLE` matrices of a `FreeMatrix`.

    The list is empty for other matrices. `write` formats a number.
    """
    lens = projection.lens
    if lens.has_steps:
        return []
    if name == "clip_from_view":
        return _of_clip(projection, projection.direct_stages[0].exact, write)
    if name == "view_from_world" and lens.own_view is not None:
        return _of_view(rationals(lens.own_view), write)
    return []


def _of_clip(
    projection: Projection, matrix: Rationals, write: Callable[[float], str]
) -> list[Property]:
    rank, determinant, _ = eliminate(matrix)
    if rank < 4:
        return [Property(SINGULAR, (str(rank),)), *_of_last_row(matrix[3], write)]
    found = []
    z_near, z_far = projection.depth_range
    # Right-handed view space becomes left-handed if near maps to less than far.
    if (determinant > 0) == (z_near < z_far):
        found.append(Property(MIRRORED_CLIP))
    if projection.frustum_sign < 0 and any(matrix[3][:3]):
        found.append(Property(ALL_BEHIND))
    if projection.frustum_sign == 0 and _is_regular_view(projection):
        found.append(Property(THROUGH_INFINITY))
    return found + _of_last_row(matrix[3], write)


def _is_regular_view(projection: Projection) -> bool:
    """Whether the view matrix has an inverse; if not, its own properties state that."""
    return eliminate(projection.exact_from_eye[0]).rank == 4


def _of_view(matrix: Rationals, write: Callable[[float], str]) -> list[Property]:
    rank = eliminate(matrix).rank
    rows = [row[:3] for row in matrix[:3]]
    turning = eliminate(rows).determinant
    found = [Property(SINGULAR, (str(rank),))] if rank < 4 else []
    if turning < 0:
        found.append(Property(MIRRORED_VIEW, (write(float(turning)),)))
    if not _is_rigid(rows):
        found.append(Property(NOT_RIGID))
    return found + _of_last_row(matrix[3], write)


def _of_last_row(last: list[Fraction], write: Callable[[float], str]) -> list[Property]:
    """Return the properties of the last row, which determines w."""
    linear = [name for name, part in zip("xyz", last, strict=False) if part]
    if linear:
        return [
            Property(NOT_AFFINE, (", ".join(linear),)),
            Property(W_VANISHES, (linear[0] if sum(map(bool, last)) == 1 else _sum(last, write),)),
        ]
    template = AFFINE if last[3] > 0 else W_IS_NOT_POSITIVE
    return [Property(template, (write(float(last[3])),))]


def _sum(coefficients: Sequence[Fraction], write: Callable[[float], str]) -> str:
    """``2 x - z + 1``."""
    text = ""
    for name, part in zip(("x", "y", "z", ""), coefficients, strict=True):
        if not part:
            continue
        size = "" if abs(part) == 1 and name else write(float(abs(part)))
        term = f"{size} {name}".strip()
        sign = "−" if part < 0 else "+"
        text = f"{text} {sign} {term}" if text else f"{'−' if part < 0 else ''}{term}"
    return text
