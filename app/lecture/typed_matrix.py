"""Typed matrices: recognise lenses and cameras, and state the properties of other matrices.

A typed matrix is recognised up to a positive factor, which does not change the picture, and up to
the rounding of the lens' fields to float64. If several values of a field fit, the present value
comes first, then short decimals (`app.model.lenses.solving`). Properties such as the rank, the sign
of the determinant and where w vanishes are decided in rationals.
"""

import itertools
import math
import operator
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache, partial
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from app.arithmetic.rationals import Rationals, dot, eliminate, rationals
from app.lecture.rounded import moved_px, nearest_rotation, rounding_of
from app.model.lenses.lens import plane_letters
from app.model.lenses.solving import DIGITS, MEANT, same, shortest
from app.model.limits import DEPTH_RANGES, Cells, DepthRange, check_name, finite_matrix
from app.model.parameters import ALPHA, BETA, BOTTOM, FAR, FOV_Y, LEFT, NEAR, RIGHT, TOP
from app.model.projection import LENSES, Camera, FreeMatrix, Lens, Projection, Vector
from app.model.refusal import MATRIX, Refusal
from app.model.tables import evaluated

Write: TypeAlias = Callable[[float], str]  # writes a number in a sentence
EDITABLE = ("view_from_world", "clip_from_view")  # the matrices with editable cells

_RIGID = 2.0**-46
"""Tolerance of a rotation's rows for length 1 and right angles.

Rounding each cell once costs 2^-52; 64 times that allows for another program's float64 arithmetic.
It is far less than the error of six typed digits: a shear by 1e-7 is no rotation.
"""
_UNIT = Fraction(1, 2**52)


# --------------------------------------------------------------------------- editing


def shown(projection: Projection, name: str) -> Cells:
    """Return one of the `EDITABLE` matrices, every cell rounded once, as an edit begins."""
    stages = {
        "view_from_world": projection.stages[1],
        "clip_from_view": projection.direct_stages[0],
    }
    check_name("matrix", name, EDITABLE)
    return finite_matrix(name, (stages[name].matrix + 0.0).tolist())


def with_cell(projection: Projection, name: str, row: int, column: int, value: float) -> Projection:
    """Return the projection with another number in one cell; see `with_matrix`.

    A lens keeps all digits of every cell, because the others may not be rounded.
    """
    cells: list[Any] = [list(line) for line in shown(projection, name)]
    if cells[row][column] == value:
        return projection
    cells[row][column] = value
    return with_matrix(projection, name, cells, whole=False)


def with_matrix(
    projection: Projection, name: str, matrix: Sequence[Sequence[float]], *, whole: bool = True
) -> Projection:
    """Return the projection with another of the `EDITABLE` matrices (4, 4).

    The lens is of the present kind, or of the kind before a free matrix, if that kind has the
    matrix; else the simplest lens that has it, else a `FreeMatrix`. The same holds for the camera.
    If the cells of a `whole` matrix are rounded, the fields of the lens are the shortest decimals
    that give them. A free matrix of another convention keeps the lens that it describes. Raises a
    `Refusal` for a cell that is not finite or beyond `LARGEST`, or another name.
    """
    cells = finite_matrix(name, matrix)
    if cells == shown(projection, name):
        return projection
    lens, camera = projection.lens, projection.camera
    former = lens.former
    clip_from_view = shown(projection, "clip_from_view")
    view_from_world = lens.own_view
    if name == "view_from_world":
        recognised = recognised_camera(cells, camera)
        camera, view_from_world = (camera, cells) if recognised is None else (recognised, None)
    else:
        clip_from_view = cells
    if view_from_world is None:
        if lens is former and name == "view_from_world":
            return replace(projection, camera=camera)
        moved = replace(projection, camera=camera, lens=former)
        standard = recognised_lens(clip_from_view, moved, whole=whole)
        if standard is not None:
            return replace(moved, lens=standard)
        described = readings(clip_from_view, moved.image_size, moved.depth, former)
        former = described[0].lens if described else former
    lens = FreeMatrix(clip_from_view, view_from_world, former)
    return replace(projection, camera=camera, lens=lens)


# --------------------------------------------------------------------------- recognition: lenses


def recognised_lens(cells: Cells, projection: Projection, *, whole: bool = False) -> Lens | None:
    """Return the lens whose ``clip_from_view`` this is, up to a positive factor, or None.

    A negative factor reverses w: everything would be behind the eye. `projection` gives the image,
    the depth range, and the present lens, whose kind and fields come first. The cells of a `whole`
    matrix may be rounded.
    """
    exact = rationals(cells)
    rounding = rounding_of(itertools.chain(*cells)) if whole else None
    for kind in sorted(LENSES, key=lambda kind: kind != projection.lens.kind):
        normalised = _normalised(kind, exact)
        if normalised is None:
            continue
        factor = next(a / b for a, b in zip(exact[3], normalised[3], strict=True) if b)
        units = rounding and [[Fraction(rounding.of(x)) / factor for x in row] for row in cells]
        has = partial(_has, exact=normalised, projection=projection, units=units)
        for lens in _candidates(kind, normalised, projection):
            if has(lens):
                return _shortened(lens, has, projection) if units else lens
    return None


def _shortened(lens: Lens, has: Callable[[Lens], bool], projection: Projection) -> Lens:
    """Return the lens with the fewest digits in each field that still has the rounded matrix."""
    aspect = Fraction(*projection.image_size)
    planes_first = ((NEAR, FAR), (NEAR,), (FAR,))
    for group in (*planes_first, (FOV_Y,), (LEFT, RIGHT), (BOTTOM, TOP), (ALPHA, BETA)):
        names = [each.name for each in group]
        for digits in range(1, DIGITS if names[0] in lens.__dataclass_fields__ else 0):
            short = {name: float(f"{getattr(lens, name):.{digits - 1}e}") for name in names}
            try:
                if group in planes_first:  # the window stays the same in degrees
                    planes = {NEAR.name: lens.near, FAR.name: lens.far, **short}
                    shortened = lens.cut(lens.window(aspect), **planes)
                else:
                    shortened = lens.replaced(**short)
            except Refusal:
                continue
            if has(shortened):
                lens = shortened
                break
    return lens


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
        yield from LENSES[kind].solutions_for(exact, near, far, projection.lens)
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


def _has(lens: Lens, exact: Rationals, projection: Projection, units: Rationals | None) -> bool:
    """Whether a lens has the matrix, cell by cell, up to the rounding of its fields or `units`."""
    try:
        own = replace(projection, lens=lens).exact_clip_from_view
    except Refusal:  # the image makes this window impossible
        return False
    for i, (mine, typed) in enumerate(zip(own, exact, strict=True)):
        sizes = lens.least_terms(typed, i)
        units_here = units[i] if units else itertools.repeat(Fraction(0))
        for a, b, size, unit in zip(mine, typed, sizes, units_here, strict=False):
            if not same(a, b, max(abs(b), size)) and abs(a - b) > unit:
                return False
    return True


# ----------------------------------------------------------------------- recognition: conventions


class MatrixReading(NamedTuple):
    """What a projection matrix of any convention does: our lens, and how its spaces differ."""

    lens: Lens  # it looks along -z of a view space with y up
    depth: DepthRange
    y: int
    z: int
    """The factors, 1 or -1, that turn its view space into ours: -1 means that y of the picture
    points down, and that it looks along +z."""
    is_transposed: bool  # whether the cells are read as columns

    @property
    def digits(self) -> int:
        """How many digits near and far need; a wrong depth range makes them long."""
        return sum(len(f"{n:.15e}".partition("e")[0].rstrip("0")) for n in self.lens.planes or ())


@lru_cache(maxsize=16)
def readings(
    cells: Cells, image_size: tuple[int, int], depth: DepthRange, in_hand: Lens
) -> list[MatrixReading]:
    """Return the lenses that a projection matrix of some convention may describe, the best first.

    The signs of the entries tell the convention. The row of w is ``0 0 c 0``: the camera looks
    along -z if c < 0 and along +z if c > 0. The picture's y points up if the entry of y is
    positive. The depth range is the one in which near and far have few digits.
    """
    ranked: list[tuple[bool, MatrixReading]] = []
    ranges = sorted(DEPTH_RANGES, key=lambda name: name != depth)
    for is_transposed in (False, True):
        rows: Any = tuple(zip(*cells, strict=True)) if is_transposed else cells
        x, y, c, d = rows[0][0], rows[1][1], rows[3][2], rows[3][3]
        if any(rows[3][:2]) or x <= 0.0 or not y or (c != 0.0) == (d != 0.0) or d < 0.0:
            continue
        is_unit = max(abs(c), d) == 1.0
        y_sign = 1 if y > 0.0 else -1
        for z_sign in (1, -1) if d else (-1 if c > 0.0 else 1,):
            # With +z ahead, y down is the view's, or else it would be left-handed; with -z ahead
            # it is the picture's, whose whole row has the other sign.
            view, clip = ((1, y_sign, z_sign, 1), 1) if z_sign < 0 else ((1, 1, 1, 1), y_sign)
            rights = (rows[0], [clip * cell for cell in rows[1]], *rows[2:])
            ours: Any = tuple(tuple(map(operator.mul, row, view)) for row in rights)
            for each in ranges:
                range_: Any = each
                camera = Camera((0.0, 0.0, 1.0), (0.0, 0.0, 0.0))
                shown_by = Projection(camera, in_hand, image_size, range_)
                lens = recognised_lens(ours, shown_by, whole=True)
                if lens is not None and lens.near >= 0.0:
                    reading = MatrixReading(lens, range_, y_sign, z_sign, is_transposed)
                    ranked.append((is_unit, reading))
        if rows == tuple(zip(*rows, strict=True)):
            break
    units = any(is_unit for is_unit, _ in ranked)
    possible = [reading for is_unit, reading in ranked if is_unit == units]
    least = min((reading.digits for reading in possible), default=0)
    return [reading for reading in possible if reading.digits <= least + 2]


# --------------------------------------------------------------------------- recognition: cameras


def recognised_camera(cells: Cells, in_hand: Camera) -> Camera | None:
    """Return the camera whose ``view_from_world`` this is, or None.

    It keeps the distance to the target of `in_hand`, and its up if that gives the same frame. Of a
    rounded matrix it is the nearest camera.
    """
    exact = rationals(cells)
    if exact[3] != [0, 0, 0, 1]:
        return None
    rows, shift = [row[:3] for row in exact[:3]], [row[3] for row in exact[:3]]
    if eliminate(rows).determinant < 0:
        return None
    unit = _UNIT
    if not _is_rigid(rows):
        nearest = nearest_rotation(np.array(cells)[:3, :3])
        if nearest is None:
            return None
        rows, unit = rationals(nearest.rows.tolist()), Fraction(nearest.rounding.of_rotation) / 4
    solved = [-dot(column, shift) for column in zip(*rows, strict=True)]
    # Rounding rows and shift costs 3 2^-53 of the shift, rounding the eye as much.
    room = 2 * unit * max(map(abs, shift))
    eye = _near(solved, in_hand.eye, room)
    distance = Fraction(in_hand.distance)
    ahead = [Fraction(e) - distance * n for e, n in zip(eye, rows[2], strict=True)]
    room += 2 * unit * distance
    target = _near(ahead, in_hand.target, room)
    for up in (in_hand.up, tuple(map(float, rows[1]))):
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


CONVENTIONS = {
    (1, 1): MATRIX["looks-backward"],
    (1, -1): MATRIX["left-handed"],
    (-1, 1): MATRIX["picture-down"],
    (-1, -1): MATRIX["looks-forward"],
}
"""By the signs of a `MatrixReading`'s y and z."""


class MatrixProperty(NamedTuple):
    """One property of a matrix: a template and the figures in it."""

    template: str
    figures: tuple[str, ...] = ()

    def __str__(self) -> str:
        return self.template.format(*self.figures)


def few(value: float) -> str:
    return f"{value:.4g}".replace("-", "−")


def properties(projection: Projection, name: str, write: Write = few) -> list[MatrixProperty]:
    """Return the properties of one of the `EDITABLE` matrices of a `FreeMatrix`.

    The list is empty for other matrices. `write` formats a number.
    """
    lens = projection.lens
    if lens.has_steps:
        return []
    if name == "clip_from_view":
        return _of_clip(projection, projection.exact_clip_from_view, write)
    if name == "view_from_world" and lens.own_view is not None:
        return _of_view(projection, lens.own_view, write)
    return []


def _of_clip(projection: Projection, matrix: Rationals, write: Write) -> list[MatrixProperty]:
    rank, determinant, _ = eliminate(matrix)
    if rank < 4:
        return [MatrixProperty(MATRIX["singular"], (str(rank),)), *_of_last_row(matrix[3], write)]
    lens: Any = projection.lens
    described = readings(lens.clip_from_view, projection.image_size, projection.depth, lens.former)
    stated: list[MatrixProperty] = []
    if described and described[0][1:] != (projection.depth, 1, 1, False):
        stated += convention(described[0], projection, write)
    z_near, z_far = projection.depth_range
    # Right-handed view space becomes left-handed if near maps to less than far.
    if (determinant > 0) == (z_near < z_far):
        stated.append(MatrixProperty(MATRIX["mirrored-clip"]))
    if projection.frustum_sign < 0 and any(matrix[3][:3]):
        stated.append(MatrixProperty(MATRIX["all-behind"]))
    # A view matrix without an inverse is a property of its own.
    if projection.frustum_sign == 0 and eliminate(projection.exact_from_eye[0]).rank == 4:
        stated.append(MatrixProperty(MATRIX["through-infinity"]))
    return stated + _of_last_row(matrix[3], write)


def rounded_view(projection: Projection, cells: Cells, write: Write = few) -> list[MatrixProperty]:
    """Say how a view matrix was rounded, and how far its nearest camera moves the picture.

    The list is empty if the matrix is exact, or belongs to no camera. The camera of `projection`
    may be that camera already.
    """
    nearest = nearest_rotation(np.array(cells)[:3, :3])
    if nearest is None or _is_rigid([row[:3] for row in rationals(cells)[:3]]):
        return []
    camera = recognised_camera(cells, projection.camera)
    if camera is None:
        return []
    rounding = nearest.rounding
    how = MATRIX["rounded-to-float32"] if rounding.is_float32 else MATRIX["rounded-to-digits"]
    stated = [MatrixProperty(how, (write(float(f"{nearest.apart:.1g}")), str(min(rounding[:2]))))]
    px = moved_px(np.array(cells), camera, replace(projection, lens=projection.lens.former))
    if math.isfinite(px):
        is_used = camera == projection.camera and projection.has_camera
        template = MATRIX["nearest-is-used"] if is_used else MATRIX["nearest"]
        stated.append(MatrixProperty(template, (write(float(f"{px:.2g}")),)))
    return stated


def convention(
    reading: MatrixReading, projection: Projection, write: Write = few
) -> list[MatrixProperty]:
    """Say what a projection matrix does: where it looks, its depth range, its lens."""
    lens, aspect = reading.lens, Fraction(*projection.image_size)
    left, right, bottom, top = lens.window(aspect)
    shows = f"[{write(left)}, {write(right)}] × [{write(bottom)}, {write(top)}]"
    if lens.central and math.isclose(left, -right) and math.isclose(bottom, -top):
        shows = f"fov {2.0 * math.degrees(math.atan2(top, lens.near)):.4g}°"
    z_near, z_far = (write(z) for z in DEPTH_RANGES[reading.depth])
    figures = (z_near, z_far, shows, write(lens.near), write(lens.far))
    stated = [MatrixProperty(CONVENTIONS[reading.y, reading.z], figures)]
    return [MatrixProperty(MATRIX["for-rows"]), *stated] if reading.is_transposed else stated


def _of_view(projection: Projection, cells: Cells, write: Write) -> list[MatrixProperty]:
    matrix = rationals(cells)
    rank = eliminate(matrix).rank
    rows = [row[:3] for row in matrix[:3]]
    turning = eliminate(rows).determinant
    stated = [MatrixProperty(MATRIX["singular"], (str(rank),))] if rank < 4 else []
    if turning < 0:
        stated.append(MatrixProperty(MATRIX["mirrored-view"], (write(float(turning)),)))
    if not _is_rigid(rows):
        stated += rounded_view(projection, cells, write) or [MatrixProperty(MATRIX["not-rigid"])]
    return stated + _of_last_row(matrix[3], write)


def _of_last_row(last: list[Fraction], write: Write) -> list[MatrixProperty]:
    """Return the properties of the last row, which determines w."""
    linear = [name for name, part in zip("xyz", last, strict=False) if part]
    if linear:
        zero = linear[0] if sum(map(bool, last)) == 1 else _sum(last, write)
        depends = MatrixProperty(MATRIX["not-affine"], (", ".join(linear),))
        return [depends, MatrixProperty(MATRIX["w-vanishes"], (zero,))]
    template = MATRIX["affine"] if last[3] > 0 else MATRIX["w-is-not-positive"]
    return [MatrixProperty(template, (write(float(last[3])),))]


def _sum(coefficients: Sequence[Fraction], write: Write) -> str:
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
