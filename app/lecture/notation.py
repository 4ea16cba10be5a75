"""Every cell of every stage's matrix as number and as formula, in the letters of the lectures.

A formula is written as a Python expression in names of our own (``2*n/(r - l)``); it can be
evaluated (`letter_values`), and is written for a reader by `written` and `latex_formula`, which
put the letters of the chosen lecture in the place of the names. Lecture 002 also has signs of its
own: its plane coordinates are negative, its w is z, and its z runs from 1 at near to -1 at far.
Numbers are those of `Projection.stages`; signs are the only thing that is changed in them.
"""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Callable, Sequence
from functools import cache, lru_cache
from typing import Any, Literal, NamedTuple, TypeAlias

from app.lecture.dependence import FIELDS, State, reach, state_of
from app.lecture.highlight import Attention
from app.model.projection import (
    DEPTH_RANGES,
    Array,
    FreeMatrix,
    Oblique,
    Perspective,
    Projection,
    Rationals,
    Stage,
    focal_length_e,
    format_value,
    fov_x_from_fov_y,
)

Letters: TypeAlias = Literal["uvn", "000", "001", "002", "003"]
Numbers: TypeAlias = tuple[tuple[float, ...], ...]
Formulas: TypeAlias = tuple[tuple[str, ...], ...]

LETTERS: tuple[Letters, ...] = ("uvn", "000", "001", "002", "003")
"""The program's own (axes as in lecture 004, planes as in 003), and those of four lectures."""

ARROW = "\u20d7"
"""After the letter of a vector, as the lectures write it above: n is near, and n\u20d7 an axis."""

_OURS = {
    "fov": "fov", "aspect": "aspect", "alpha": "\u03b1", "beta": "β",
    "axis_u": f"u{ARROW}", "axis_v": f"v{ARROW}", "axis_n": f"n{ARROW}", "eye": f"e{ARROW}",
    "eye_x": "e_x", "eye_y": "e_y", "eye_z": "e_z", "theta_h": "θ_h", "theta_v": "θ_v",
}  # fmt: skip
_EYE_P = {"eye": f"P{ARROW}", "eye_x": "x_p", "eye_y": "y_p", "eye_z": "z_p"}
_SYMBOLS: dict[str, dict[str, str]] = {
    "uvn": _OURS,
    "000": {
        **_OURS,
        "l": "x_min", "r": "x_max", "b": "y_min", "t": "y_max", "n": "z_min", "f": "z_max",
    },
    "001": {
        **_OURS, **_EYE_P, "axis_n": f"w{ARROW}", "n_x": "w_x", "n_y": "w_y", "n_z": "w_z",
    },
    "002": {
        **_OURS, "l": "x_l", "r": "x_r", "b": "y_b", "t": "y_t", "n": "z_n", "f": "z_f",
    },
    "003": {**_OURS, **_EYE_P},  # e is its focal length
}  # fmt: skip


class Matrix(NamedTuple):
    """One matrix as it is shown.

    Attributes
    ----------
    name : str
        ``target_from_source``, or what a factor is called.
    values : 4 tuples of 4 float
        Each rounded once; no minus zero.
    formulas : 4 tuples of 4 str
        In the names of this room; see `written`.
    fields : 4 tuples of 4 tuples of str
        The fields of the document that change the cell when they are moved from where all are.
    factors : tuple of Matrix
        In the order of the product, if there is more than one.
    product : tuple of str
        Names of the stages that this one is the product of, in the order of the product.
    note : str
        As `Stage.note`.
    """

    name: str
    values: Numbers
    formulas: Formulas
    fields: tuple[tuple[tuple[str, ...], ...], ...]
    factors: tuple[Matrix, ...] = ()
    product: tuple[str, ...] = ()
    note: str = ""


def matrices(
    projection: Projection, letters: Letters = "uvn", *, rows: bool = False, running: bool = False
) -> tuple[Matrix, ...]:
    """Every stage's matrix, in the order of `python -m app matrices`.

    Parameters
    ----------
    projection : Projection
    letters : Letters
        Whose letters, and with ``"002"`` whose signs.
    rows : bool
        Row vectors: every matrix is transposed, every product turned round.
    running : bool
        Also the products with the view matrix between `view_from_world` and `clip_from_world`,
        and `world_from_view`, whose columns are the camera's axes and the eye.

    Returns
    -------
    tuple of Matrix
    """
    *stages, last = projection.stages
    shown: list[tuple[Stage, tuple[str, ...]]] = []
    product: Rationals = []
    source = ""
    for stage in stages:
        shown.append((stage, ()))
        if stage.name == "view_from_world":
            product, source = stage.exact, stage.name
            if running and stage.factors:  # a view matrix of its own has no camera's axes
                shown.append((_inverse_view(projection), ()))
        elif product and running:
            target, _, _ = stage.name.partition("_from_")
            if target != "clip" and stage.factors:  # clip_from_world comes by itself
                product = _times(stage.exact, product)
                name = f"{target}_from_world"
                shown.append((Stage(name, product, (), ""), (stage.name, source)))
                source = name
    for stage in projection.direct_stages:
        shown.append((stage, tuple(name for name, _ in stage.factors)))
    shown.append((last, ()))
    kind, depth = _kind(projection), projection.depth
    tables = _Tables(
        _formulas(kind, depth, letters),
        # Numbers are the same in all letters; lecture 002's have signs of their own.
        _fields(kind, depth, "002" if letters == "002" else "uvn", state_of(projection)),
    )
    return tuple(_matrix(stage, names, projection, tables, letters, rows)
                 for stage, names in shown)  # fmt: skip


def letters_in(matrix: Matrix, row: int, column: int) -> Attention:
    """The things that a cell's formula speaks of, by the names of `app.lecture.highlight`.

    An axis of the camera's frame stands for what it is made of: eye, target and up are not named
    unless the eye itself is in the formula.
    """
    names = _names(matrix.formulas[row][column])
    axes = {
        name.removeprefix("axis_")[0]
        for name in names
        if name.startswith("axis_") or (len(name) == 3 and name[:2] in ("u_", "v_", "n_"))
    }
    eye = {"eye" for name in names if name.startswith("eye")}
    fields = set(matrix.fields[row][column]).union(*(FIELDS.get(name, ()) for name in names))
    lens = fields - {"eye", "target", "up"}
    return frozenset(axes | eye | {"fov" if name == "fov_y_deg" else name for name in lens})


def _kind(projection: Projection) -> tuple[str, bool]:
    """The lens' kind, and whether far is infinite or a free matrix has a view matrix too."""
    lens = projection.lens
    if isinstance(lens, FreeMatrix):
        return lens.kind, lens.view_from_world is not None
    return lens.kind, lens.far == math.inf


def _inverse_view(projection: Projection) -> Stage:
    """``world_from_view`` of the camera."""
    frame = projection.camera.exact_frame
    exact: Rationals = [
        [*(axis[i] for axis in frame), type(frame[0][0])(projection.camera.eye[i])]
        for i in range(3)
    ]
    zero, one = frame[0][0] * 0, frame[0][0] * 0 + 1
    return Stage("world_from_view", [*exact, [zero, zero, zero, one]], (), "")


def _times(left: Rationals, right: Rationals) -> Rationals:
    """An exact product; most of a lens' cells are zero, and not worth multiplying."""
    zero = right[0][0] * 0
    return [
        [sum((a * line[j] for a, line in zip(row, right, strict=True) if a), zero)
         for j in range(4)]
        for row in left
    ]  # fmt: skip


_Table: TypeAlias = dict[str, Formulas]
_FieldTable: TypeAlias = dict[str, tuple[tuple[tuple[str, ...], ...], ...]]


class _Tables(NamedTuple):
    """Of every matrix by stage name or ``stage/factor``: its formulas, and what moves its cells."""

    formulas: _Table
    fields: _FieldTable


def _matrix(
    stage: Stage,
    product: tuple[str, ...],
    projection: Projection,
    tables: _Tables,
    letters: Letters,
    rows: bool,
) -> Matrix:
    signs = _signs(projection, letters)
    inner = {} if "_from_" in "".join(name for name, _ in stage.factors) else dict(stage.factors)
    factors = []
    if len(inner) > 1:
        for label, array in inner.items():
            factors.append(_one(label, f"{stage.name}/{label}", array, signs,
                                projection, tables, rows, ()))  # fmt: skip
    whole = _one(stage.name, stage.name, stage.matrix, signs, projection, tables, rows,
                 tuple(factors))  # fmt: skip
    if rows:
        product = product[::-1]
    return whole._replace(product=product, note=stage.note)


def _one(
    label: str,
    key: str,
    array: Array,
    signs: Callable[[str, int, int], int],
    projection: Projection,
    tables: _Tables,
    rows: bool,
    factors: tuple[Matrix, ...],
) -> Matrix:
    values = tuple(
        tuple(signs(key, i, j) * value + 0.0 for j, value in enumerate(row))
        for i, row in enumerate(array.tolist())
    )
    formulas, fields = tables.formulas[key], tables.fields[key]
    if isinstance(projection.lens, FreeMatrix) and key in ("clip_from_view", "clip_from_world"):
        # Another depth range makes z of both rows; see `Projection.with_depth`.
        depths = tuple(
            (*names, "depth") if array[2, j] or array[3, j] else names
            for j, names in enumerate(fields[2])
        )
        fields = (*fields[:2], depths, fields[3])
    if rows:
        values, fields = tuple(zip(*values, strict=True)), tuple(zip(*fields, strict=True))
        formulas = tuple(tuple(_turned(cell) for cell in row)
                         for row in zip(*formulas, strict=True))  # fmt: skip
        factors = factors[::-1]
    return Matrix(label, values, formulas, fields, factors)


@cache
def _turned(formula: str) -> str:
    """A formula with p_ij for p_ji: in the transposed matrix a cell's place is turned too."""
    tree = ast.parse(formula, mode="eval")
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and re.fullmatch(r"[pm]_[1-4]{2}", node.id):
            node.id = f"{node.id[:2]}{node.id[3]}{node.id[2]}"
    return ast.unparse(tree)


@cache
def _spelled(formula: str, lens: Formulas) -> str:
    """A formula with the cells of P written out."""
    return re.sub(
        r"p_(.)(.)", lambda cell: f"({lens[int(cell[1]) - 1][int(cell[2]) - 1]})", formula
    )


@lru_cache(maxsize=64)
def _fields(kind: tuple[str, bool], depth: str, letters: Letters, state: State) -> _FieldTable:
    """What changes each cell when it is moved from a state: `Matrix.fields` by `_formulas`' keys.

    Where another depth range, or a far that is finite again, has another formula, that is moved
    as well.
    """
    lens, infinite = kind
    own = _formulas(kind, depth, letters)
    others = [
        ("depth", _formulas(kind, other, letters)) for other in DEPTH_RANGES if other != depth
    ]
    if infinite and lens != FreeMatrix.kind:
        others.insert(0, ("far", _formulas((lens, False), depth, letters)))

    def cell(key: str, i: int, j: int) -> tuple[str, ...]:
        formula = _spelled(own[key][i][j], own["clip_from_view"])
        mine = reach(formula, state)
        found = dict.fromkeys(mine.fields)
        for field, table in others:
            other = _spelled(table[key][i][j], table["clip_from_view"])
            if other != formula and not (mine.is_zero and reach(other, state).is_zero):
                found[field] = None
        return tuple(found)

    return {key: tuple(tuple(cell(key, i, j) for j in range(4)) for i in range(4)) for key in own}


def _names(formula: str) -> list[str]:
    nodes = ast.walk(ast.parse(formula, mode="eval"))
    return [node.id for node in nodes if isinstance(node, ast.Name)]


# --------------------------------------------------------------------------- lecture 002's signs


def _signs(projection: Projection, letters: Letters) -> Callable[[str, int, int], int]:
    """The sign that turns a cell of ours into one of the letters' lecture."""
    if letters != "002" or isinstance(projection.lens, FreeMatrix):
        return lambda key, i, j: 1
    turned = -1 if projection.depth == "opengl" else 1
    w = 1 if projection.lens.parallel else -1

    def sign(key: str, i: int, j: int) -> int:
        name = key.partition("/")[0]
        z_row = turned if i == 2 else 1
        if name in ("clip_from_view", "clip_from_world"):
            return w * z_row
        if name == "clip_from_depth_range":
            return w
        if name.startswith("depth_range_from"):
            if key.endswith("/translation"):  # S T = T' S: only the shift is turned
                return turned if (i, j) == (2, 3) else 1
            return z_row
        if name == "image_from_ndc":
            if key.endswith("/scale"):
                return z_row
            if key.endswith("/translation"):
                return turned if (i, j) == (2, 3) else 1
            return turned if j == 2 and i == 2 else 1
        return 1

    return sign


def cell_sign(projection: Projection, letters: Letters, name: str, row: int, column: int) -> int:
    """1, or -1 where the letters' lecture turns the sign of a stage's cell."""
    return _signs(projection, letters)(name, row, column)


def has_own_signs(projection: Projection, letters: Letters) -> bool:
    """Whether the letters' lecture turns signs of this projection's matrices."""
    lens = projection.lens
    if letters != "002" or isinstance(lens, FreeMatrix):
        return False
    return not (lens.parallel and projection.depth != "opengl")


# --------------------------------------------------------------------------- formulas

_IDENTITY: Formulas = tuple(
    tuple("1" if i == j else "0" for j in range(4)) for i in range(4)
)  # fmt: skip


def _diagonal(*parts: str) -> Formulas:
    return tuple(tuple(part if i == j else "0" for j in range(4)) for i, part in enumerate(parts))


def _with(matrix: Formulas, **cells: str) -> Formulas:
    """A matrix with other cells, given as ``r0c2="..."``."""
    new = [list(row) for row in matrix]
    for place, formula in cells.items():
        new[int(place[1])][int(place[3])] = formula
    return tuple(map(tuple, new))


def _shift(x: str, y: str, z: str) -> Formulas:
    return _with(_IDENTITY, r0c3=x, r1c3=y, r2c3=z)


@cache
def _formulas(kind: tuple[str, bool], depth: str, letters: Letters) -> _Table:
    """The formula of every cell, by stage name or ``stage/factor``."""
    lens, infinite = kind
    signed = letters == "002" and lens != FreeMatrix.kind
    parallel = lens in ("orthographic", "oblique")
    z_near, z_far = (int(z) for z in DEPTH_RANGES[depth])
    if signed and depth == "opengl":
        z_near, z_far = 1, -1
    axes = tuple(tuple(f"{axis}_{part}" for part in "xyz") for axis in "uvn")
    table = {
        "world_from_object": _IDENTITY,
        "view_from_world": (
            *((*axis, f"-dot(axis_{axis[0][0]}, eye)") for axis in axes),
            ("0", "0", "0", "1"),
        ),
        "view_from_world/rotation": (*((*axis, "0") for axis in axes), ("0", "0", "0", "1")),
        "view_from_world/translation": _shift("-eye_x", "-eye_y", "-eye_z"),
        "world_from_view": (
            *((*(f"{axis}_{part}" for axis in "uvn"), f"eye_{part}") for part in "xyz"),
            ("0", "0", "0", "1"),
        ),
    }
    stage = "depth_range_from_canonical_parallel"
    scale, shift = str(z_near - z_far), str(z_near)
    table[stage] = _with(_IDENTITY, r2c2=scale, r2c3=shift)
    table[f"{stage}/translation"] = _shift("0", "0", shift)
    table[f"{stage}/scale"] = _diagonal("1", "1", scale, "1")
    _add_image(table, z_near, z_far)
    if lens == FreeMatrix.kind:
        _add_free(table, with_view=infinite)
        return table
    if parallel:
        _add_parallel(table, lens == "oblique", signed, (z_near, z_far))
    else:
        _add_perspective(table, lens, infinite, letters, (z_near, z_far))
    _add_products(table, parallel)
    return table


def _add_free(table: _Table, *, with_view: bool) -> None:
    """Cells that nothing makes: P's are p_ij, a view matrix's of its own m_ij."""
    cells = {
        letter: tuple(tuple(f"{letter}_{i}{j}" for j in range(1, 5)) for i in range(1, 5))
        for letter in "pm"
    }
    table["clip_from_view"] = cells["p"]
    if with_view:
        table["view_from_world"] = cells["m"]
    table["clip_from_world"] = _product(cells["p"], table["view_from_world"])


def _add_image(table: _Table, z_near: int, z_far: int) -> None:
    """The viewport: x from -1..1 to 0..w, y turned round to 0..h, z to a depth in 0..1."""
    halved = {z_near, z_far} == {-1, 1}
    # Depth is (z + 1)/2 of our ranges, and (z - 1)/-2 of one that is turned round.
    step, low = ("1/2", "1") if halved else ("1", "0")
    if halved and z_near > z_far:
        step, low = "-1/2", "-1"
    table["image_from_ndc/scale"] = _diagonal("W/2", "-H/2", step, "1")
    table["image_from_ndc/translation"] = _shift("1", "-1", low)
    table["image_from_ndc"] = _with(
        _diagonal("W/2", "-H/2", step, "1"),
        r0c3="W/2", r1c3="H/2", r2c3="1/2" if halved else "0",
    )  # fmt: skip


def _add_parallel(table: _Table, oblique: bool, signed: bool, depth: tuple[int, int]) -> None:
    """P_ort H of lecture 002 and its steps."""
    depth_extent = "(n - f)" if signed else "(f - n)"
    near, plus, minus = ("-n", "+", "-") if signed else ("n", "-", "")
    scale_x, scale_y, scale_z = "2/(r - l)", "2/(t - b)", f"1/{depth_extent}"
    shift_x, shift_y, shift_z = "-(r + l)/(r - l)", "-(t + b)/(t - b)", "n/(f - n)"
    stage = "canonical_parallel_from_view"
    table[f"{stage}/scale"] = _diagonal(scale_x, scale_y, scale_z, "1")
    table[f"{stage}/translation"] = _shift("-(r + l)/2", "-(t + b)/2", near)
    x_z = y_z = "0"
    if oblique:
        table[f"{stage}/shear"] = _with(
            _IDENTITY, r0c2="cot(alpha)", r1c2="cot(beta)",
            r0c3=f"{minus}n*cot(alpha)", r1c3=f"{minus}n*cot(beta)",
        )  # fmt: skip
        x_z, y_z = "2*cot(alpha)/(r - l)", "2*cot(beta)/(t - b)"
        shift_x = f"-(r + l {plus} 2*n*cot(alpha))/(r - l)"
        shift_y = f"-(t + b {plus} 2*n*cot(beta))/(t - b)"
    whole = _with(
        _diagonal(scale_x, scale_y, scale_z, "1"),
        r0c2=x_z, r1c2=y_z, r0c3=shift_x, r1c3=shift_y, r2c3=shift_z,
    )  # fmt: skip
    table[stage] = whole
    table["canonical_parallel_from_canonical_perspective"] = _IDENTITY
    table["clip_from_depth_range"] = _IDENTITY
    z_scale, z_shift = {
        (-1, 1): (f"-2/{depth_extent}", "-(f + n)/(f - n)"),
        (1, -1): (f"2/{depth_extent}", "-(n + f)/(n - f)"),
        (0, 1): (f"-1/{depth_extent}", "-n/(f - n)"),
        (1, 0): (f"1/{depth_extent}", "f/(f - n)"),
    }[depth]
    table["clip_from_view"] = _with(whole, r2c2=z_scale, r2c3=z_shift)


def _add_perspective(
    table: _Table, lens: str, infinite: bool, letters: Letters, depth: tuple[int, int]
) -> None:
    """Lecture 000's (13) and the steps to it of lecture 001."""
    signed = letters == "002"
    minus = "-" if signed else ""
    reach = "n" if infinite else "f"
    x_z = y_z = "0"
    stage = "canonical_perspective_from_view"
    if lens == "frustum":
        scales = ("2*n/(r - l)", "2*n/(t - b)")
        parts = ("2/(r - l)", "2/(t - b)") if infinite else ("2*n/(f*(r - l))", "2*n/(f*(t - b))")
        table[f"{stage}/shear"] = _with(
            _IDENTITY, r0c2=f"{minus}(r + l)/(2*n)", r1c2=f"{minus}(t + b)/(2*n)"
        )
        x_z, y_z = f"{minus}(r + l)/(r - l)", f"{minus}(t + b)/(t - b)"
        skew = (f"{minus}(r + l)/({reach}*(r - l))", f"{minus}(t + b)/({reach}*(t - b))")
    else:
        scales, parts = {
            "001": (("1/tan(theta_h/2)", "1/tan(theta_v/2)"),
                    (f"1/({reach}*tan(theta_h/2))", f"1/({reach}*tan(theta_v/2))")),
            "003": (("e", "e/a"), (f"e/{reach}", f"e/(a*{reach})")),
        }.get(letters, (
            (f"{minus}cot(fov/2)/aspect", f"{minus}cot(fov/2)"),
            (f"{minus}cot(fov/2)/(aspect*{reach})", f"{minus}cot(fov/2)/{reach}"),
        ))  # fmt: skip
        skew = ("0", "0")
    scale = _diagonal(*parts, f"{minus}1/{reach}", "1")
    table[f"{stage}/scale"] = scale
    table[stage] = _with(scale, r0c2=skew[0], r1c2=skew[1])
    table["canonical_parallel_from_canonical_perspective"] = _with(
        _IDENTITY, r3c2="-1", r3c3="0",
        r2c2="1" if infinite else "f/(f - n)", r2c3="1" if infinite else "n/(f - n)",
    )  # fmt: skip
    table["clip_from_depth_range"] = _diagonal(reach, reach, reach, reach)
    table["canonical_parallel_from_view"] = _with(
        table[stage], r3c2=f"{'' if signed else '-'}1/{reach}", r3c3="0",
        r2c2=f"{minus}1/n" if infinite else f"1/({'n - f' if signed else 'f - n'})",
        r2c3="1" if infinite else "n/(f - n)",
    )  # fmt: skip
    a, b = {
        (-1, 1): ("-(f + n)/(f*(f - n))", "-2*n/(f - n)"),
        (1, -1): ("-(f + n)/(f*(f - n))", "2*n/(f - n)"),
        (0, 1): (f"{'' if signed else '-'}1/(f - n)", "-n/(f - n)"),
        (1, 0): (f"{minus}n/(f*(f - n))", "n/(f - n)"),
    }[depth]
    if infinite:
        a, b = {
            (-1, 1): ("-1/n", "-2"), (1, -1): ("-1/n", "2"),
            (0, 1): (f"{'' if signed else '-'}1/n", "-1"), (1, 0): ("0", "1"),
        }[depth]  # fmt: skip
    table["depth_range_from_view"] = _with(table["canonical_parallel_from_view"], r2c2=a, r2c3=b)
    a, b = {
        (-1, 1): ("-(f + n)/(f - n)", "-2*f*n/(f - n)"),
        (1, -1): ("-(f + n)/(f - n)", "2*n*f/(f - n)"),
        (0, 1): (f"{'' if signed else '-'}f/(f - n)", "-f*n/(f - n)"),
        (1, 0): (f"{minus}n/(f - n)", "f*n/(f - n)"),
    }[depth]
    if infinite:
        a, b = {
            (-1, 1): ("-1", "-2*n"), (1, -1): ("-1", "2*n"),
            (0, 1): ("1" if signed else "-1", "-n"), (1, 0): ("0", "n"),
        }[depth]  # fmt: skip
    table["clip_from_view"] = (
        (scales[0], "0", x_z, "0"),
        ("0", scales[1], y_z, "0"),
        ("0", "0", a, b),
        ("0", "0", "1" if signed else "-1", "0"),
    )


def _add_products(table: _Table, parallel: bool) -> None:
    """The running products with the view matrix."""
    view = table["view_from_world"]
    if parallel:
        steps = {"canonical_parallel": "canonical_parallel_from_view",
                 "depth_range": "clip_from_view"}  # fmt: skip
    else:
        targets = ("canonical_perspective", "canonical_parallel", "depth_range")
        steps = {target: f"{target}_from_view" for target in targets}
    for target, step in steps.items():
        table[f"{target}_from_world"] = _product(table[step], view)
    # The whole formula is too long for a cell: P is clip_from_view, p_ij its cells.
    lens = tuple(
        tuple(cell if cell in ("0", "1", "-1") else f"p_{i}{j}" for j, cell in enumerate(row, 1))
        for i, row in enumerate(table["clip_from_view"], 1)
    )
    table["clip_from_world"] = _product(lens, view)


def _product(left: Formulas, right: Formulas) -> Formulas:
    return tuple(
        tuple(_sum([(a, b) for a, b in zip(row, column, strict=True) if "0" not in (a, b)])
              for column in zip(*right, strict=True))
        for row in left
    )  # fmt: skip


def _sum(terms: Sequence[tuple[str, str]]) -> str:
    """A sum of products without the factors 1."""
    text = ""
    for pair in terms:
        negative = False
        above, below = [], ""
        for part in pair:
            tree = ast.parse(part, mode="eval").body
            if isinstance(tree, ast.BinOp) and isinstance(tree.op, ast.Div):
                below += f"/{_in_brackets(tree.right, ast.BinOp)}"
                tree = tree.left
            part = _in_brackets(tree, ast.BinOp) if _is_sum(tree) else ast.unparse(tree)
            if part.startswith("-"):  # the sign of a product's first factor is the product's
                negative, part = not negative, part[1:]
            if part != "1":
                above.append(part)
        term = ("*".join(above) or "1") + below
        text = (f"{text} {'-' if negative else '+'} {term}" if text
                else f"{'-' if negative else ''}{term}")  # fmt: skip
    return text or "0"


def _is_sum(tree: ast.expr) -> bool:
    return isinstance(tree, ast.BinOp) and isinstance(tree.op, ast.Add | ast.Sub)


def _in_brackets(tree: ast.expr, kind: type[ast.expr]) -> str:
    text = ast.unparse(tree)
    return f"({text})" if isinstance(tree, kind) else text


def letter_values(projection: Projection, letters: Letters = "uvn") -> dict[str, Any]:
    """What the names in the formulas stand for: floats, vectors, ``cot``, ``tan`` and ``dot``.

    Of a free matrix its own cells. Angles are in radians; with ``"002"`` n and f are the planes'
    coordinates, which are negative.
    """
    lens, camera = projection.lens, projection.camera
    width, height = projection.image_size
    values: dict[str, Any] = {
        "W": width, "H": height, "aspect": projection.aspect, "a": height / width,
        "eye": camera.eye,
        "cot": lambda angle: math.tan(math.pi / 2.0 - angle), "tan": math.tan,
        "dot": lambda a, b: math.sumprod(a, b) if hasattr(math, "sumprod")
        else math.fsum(x * y for x, y in zip(a, b, strict=True)),
    }  # fmt: skip
    for axis, row in zip("uvn", camera.frame.tolist(), strict=True):
        values[f"axis_{axis}"] = row
        values |= {f"{axis}_{part}": value for part, value in zip("xyz", row, strict=True)}
    values |= {f"eye_{part}": value for part, value in zip("xyz", camera.eye, strict=True)}
    if isinstance(lens, FreeMatrix):
        for letter, cells in (("p", lens.clip_from_view), ("m", lens.view_from_world or ())):
            for i, row in enumerate(cells, 1):
                values |= {f"{letter}_{i}{j}": value for j, value in enumerate(row, 1)}
        return values
    left, right, bottom, top = projection.window
    sign = -1.0 if letters == "002" else 1.0
    values |= {
        "n": sign * lens.near, "f": sign * lens.far, "l": left, "r": right, "b": bottom, "t": top,
    }  # fmt: skip
    if isinstance(lens, Perspective):
        values["fov"] = values["theta_v"] = math.radians(lens.fov_y_deg)
        values["theta_h"] = math.radians(fov_x_from_fov_y(lens.fov_y_deg, projection.aspect))
        values["e"] = focal_length_e(lens.fov_y_deg, projection.aspect)
    if isinstance(lens, Oblique):
        values["alpha"], values["beta"] = math.radians(lens.alpha_deg), math.radians(lens.beta_deg)
    return values


# --------------------------------------------------------------------------- writing


@cache
def written(formula: str, letters: Letters) -> str:
    """A formula for a reader, in one line: ``2n/(r−l)``.

    ``_`` stands before a subscript, and `ARROW` after a vector's letter.
    """
    return _Plain(_SYMBOLS[letters]).write(ast.parse(formula, mode="eval").body)


@cache
def latex_formula(formula: str, letters: Letters) -> str:
    """A formula for LaTeX's mathematics: ``\\frac{2 n}{r - l}``."""
    return _Latex(_SYMBOLS[letters]).write(ast.parse(formula, mode="eval").body)


class _Plain:
    """Writes an expression; `_Latex` changes what looks different there."""

    def __init__(self, symbols: dict[str, str]) -> None:
        self._symbols = symbols

    def write(self, node: ast.expr, outer: int = 0) -> str:
        """Write a node inside one that binds as tightly as `outer`."""
        if isinstance(node, ast.Constant):
            return str(node.value)
        if isinstance(node, ast.Name):
            return self.symbol(self._symbols.get(node.id, node.id))
        if isinstance(node, ast.Call):
            assert isinstance(node.func, ast.Name)
            if node.func.id == "dot":
                text = self.dot(*(self.write(part) for part in node.args))
                return f"({text})" if outer > 2 else text
            return self.call(node.func.id, self.write(node.args[0]))
        if isinstance(node, ast.UnaryOp):
            text = f"{self.minus}{self.write(node.operand, 2)}"
            return f"({text})" if outer > 1 else text
        assert isinstance(node, ast.BinOp)
        if isinstance(node.op, ast.Div):
            return self.quotient(node, outer)
        if isinstance(node.op, ast.Mult):
            left, right = self.first(node.left), self.write(node.right, 3)
            text = f"{left}{'' if left[-1].isdigit() and '_' not in left else self.space}{right}"
            return f"({text})" if outer > 2 else text
        sign = self.plus if isinstance(node.op, ast.Add) else self.minus_between
        text = f"{self.write(node.left, 1)}{sign}{self.write(node.right, 2)}"
        return f"({text})" if outer > 1 else text

    minus, minus_between, plus, space = "−", " − ", " + ", "\u2009"

    def first(self, node: ast.expr) -> str:
        """The first factor, whose sign needs no brackets."""
        return self.write(node, 1 if isinstance(node, ast.UnaryOp) else 2)

    def symbol(self, name: str) -> str:
        return name

    def dot(self, a: str, b: str) -> str:
        return f"{a}·{b}"

    def call(self, name: str, inside: str) -> str:
        return f"{name}({inside})"

    def quotient(self, node: ast.BinOp, outer: int) -> str:
        text = f"{self.first(node.left)}/{self.write(node.right, 3)}"
        return f"({text})" if outer > 2 else text


_GREEK = {"\u03b1": r"\alpha", "β": r"\beta", "θ": r"\theta"}


class _Latex(_Plain):
    minus, minus_between, plus, space = "-", " - ", " + ", r" \, "

    def symbol(self, name: str) -> str:
        if name.endswith(ARROW):
            return rf"\vec{{{name.removesuffix(ARROW)}}}"
        head, _, below = name.partition("_")
        head = _GREEK.get(head, head if len(head) == 1 else rf"\mathrm{{{head}}}")
        if not below:
            return head
        if len(below) > 1 and not below.isdigit():
            below = rf"\mathrm{{{below}}}"
        return f"{head}_{{{below}}}"

    def dot(self, a: str, b: str) -> str:
        return rf"{a} \cdot {b}"

    def call(self, name: str, inside: str) -> str:
        return rf"\{name}\left({inside}\right)"

    def quotient(self, node: ast.BinOp, outer: int) -> str:
        left, minus = node.left, ""
        if isinstance(left, ast.UnaryOp):
            left, minus = left.operand, self.minus
        text = rf"{minus}\frac{{{self.write(left)}}}{{{self.write(node.right)}}}"
        return rf"\left({text}\right)" if minus and outer > 1 else text


# --------------------------------------------------------------------------- copying


def cell_text(value: float) -> str:
    """A cell's number with every digit: what `python -m app matrices` prints."""
    return format_value(value)


def as_text(matrix: Matrix, letters: Letters = "uvn", *, formulas: bool = False) -> str:
    """The matrix as aligned columns under its name, of numbers or of formulas."""
    cells = (
        [[written(cell, letters) for cell in row] for row in matrix.formulas]
        if formulas
        else [[cell_text(value) for value in row] for row in matrix.values]
    )
    widths = [max(map(_places, column)) for column in zip(*cells, strict=True)]
    lines = (
        "  "
        + "  ".join(
            " " * (width - _places(cell)) + cell for cell, width in zip(row, widths, strict=True)
        )
        for row in cells
    )
    return "\n".join([_title(matrix), *lines]) + "\n"


def _places(text: str) -> int:
    """How many letters wide a text is: an arrow stands above one."""
    return len(text) - text.count(ARROW)


def as_numpy(matrix: Matrix) -> str:
    """The matrix as a statement of Python, with ``np`` for NumPy."""
    rows = ",\n".join(
        "    [" + ", ".join(repr(value) for value in row) + "]" for row in matrix.values
    )
    return f"{matrix.name} = np.array([\n{rows},\n])\n"


def as_latex(matrix: Matrix, letters: Letters, *, formulas: bool = False) -> str:
    """The matrix as a displayed equation with a pmatrix (amsmath), of numbers or of formulas."""
    cells = (
        [[latex_formula(cell, letters) for cell in row] for row in matrix.formulas]
        if formulas
        else [[latex_number(value) for value in row] for row in matrix.values]
    )
    body = " \\\\\n".join(" & ".join(row) for row in cells)
    equation = f"{latex_name(matrix.name)} = \\begin{{pmatrix}}\n{body}\n\\end{{pmatrix}}"
    return f"\\[\n{equation}\n\\]\n"


def _title(matrix: Matrix) -> str:
    names = matrix.product or tuple(factor.name for factor in matrix.factors)
    return f"{matrix.name} = {' '.join(names)}" if names else matrix.name


def latex_name(name: str) -> str:
    """``M`` with the spaces of a matrix as its index, or the name of a factor."""
    target, between, source = (part.replace("_", " ") for part in name.partition("_from_"))
    if not between:
        return rf"M_{{\text{{{target}}}}}"
    return rf"M_{{\text{{{target}}}\leftarrow\text{{{source}}}}}"


def latex_number(value: float) -> str:
    """A number with every digit, its exponent written as a power of ten."""
    mantissa, e, exponent = cell_text(value).partition("e")
    return rf"{mantissa} \cdot 10^{{{int(exponent)}}}" if e else mantissa
