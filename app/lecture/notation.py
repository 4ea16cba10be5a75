"""Every cell of every stage's matrix as a number and as a formula in the letters of a lecture.

The formulas come from the lens' table (`app.model.lenses`), multiplied symbolically
(`app.lecture.algebra`). `written` and `latex_formula` write them with the symbols of the chosen
lecture. Some lectures use other quantities (`_QUANTITIES`). Lecture 002 also has its own signs: its
plane coordinates are negative, its w is z, and its z goes from 1 at near to -1 at far. The numbers
come from `Projection.stages`; only their signs may change.
"""

import itertools
import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cache, lru_cache, partial
from typing import NamedTuple, TypeAlias

from app.arithmetic.rationals import product
from app.lecture.algebra import SYMBOLS, Ratio, number, ratio
from app.lecture.algebra import Letters as Quantities
from app.lecture.dependence import FIELDS, ProjectionState, reach, state_of
from app.lecture.highlight import OBJECT_AXES, Highlight
from app.lecture.letters import FROM_SHEARED, SHEARED, Letters, base_of, lettering, written
from app.model.chain import FROM_OBJECT, Chain, lettered_kinds
from app.model.formula import ARROW, Difference, Formula, Pair, Quotient, Sum, parse
from app.model.lenses.lens import LensTable
from app.model.projection import DEPTH_RANGES, Array, Projection, Stage
from app.model.tables import VIEWPORT, PipelineStep, evaluated

Numbers: TypeAlias = tuple[tuple[float, ...], ...]
Formulas: TypeAlias = tuple[tuple[str, ...], ...]

_ONE_MATRIX = ("000", "002", "003")
"""The lectures with one matrix from view to clip space, possibly after a shear."""

_CALLED = {
    "translate": "T",
    "rotate": "R",
    "scale": "S",
    "shear": "H",
    "mirror": "M",
    "matrix": "G",
}
"""The letters of the object's tiles; neighbouring rotations are one."""
_LONGEST, _MOST_TERMS = 300, 48
"""Most characters of a cell of the object's product; a longer one has a letter."""

_QUANTITIES: dict[str, dict[str, Ratio]] = {  # the lectures' replacements of our quantities
    lecture: {ours: ratio(parse(its)) for ours, its in terms.items()}
    for lecture, terms in {
        "001": {"cot(fov/2)": "1/tan(theta_v/2)", "aspect": "tan(theta_h/2)/tan(theta_v/2)"},
        "002": {"n": "-n", "f": "-f"},
        "003": {"cot(fov/2)": "e/a", "aspect": "1/a"},
    }.items()
}


def clip_signs(projection: Projection, letters: Letters) -> tuple[int, ...]:
    """Return the factors that turn our x, y, z and w of clip space into those of a lecture."""
    sign = _signs(_written(projection), base_of(letters))
    return tuple(sign("clip_from_view", row, row if row < 3 else 2) for row in range(4))


def steps_of_a_point(
    projection: Projection, letters: Letters, *, directions: bool = False
) -> dict[str, str]:
    """Return a lecture's formulas for the steps of a point p, by the name of the target space.

    The keys are ``world``, ``view``, ``clip``, the ``w`` in it, the condition ``between`` for near
    and far, and the ``depth`` from z; ``_`` stands before a subscript. `directions` is for points
    with w = 0, from which the eye is not subtracted.
    """
    lens, base = _written(projection), base_of(letters)
    names, signs = _names(lens, letters), clip_signs(projection, letters)
    table = _formulas(lens, base)
    moves = (called(kind)[0] for kind in lens.kinds)
    moved = " ".join(letter for letter, _ in itertools.groupby(moves)) or "I"
    eye = written("eye", letters).replace(ARROW, "")
    factors = () if lens.has_own_view else ("rotation", "translation")
    view = names.get("view_from_world") or _chain(names, [f"view_from_world/{f}" for f in factors])
    if not view:
        view = "M" if lens.has_own_view else f"R (p \u2212 {'w ' if directions else ''}{eye})"
    steps = [step.name for step in reversed(_steps(lens.table, base))]
    chain = _chain(names, [name for name in steps if table[name] != _IDENTITY])
    clip = names.get("clip_from_view") or chain or "P"
    minus = "\u2212" if signs[3] > 0 else ""
    w = {"0 0 -1 0": f"{minus}z_view", "0 0 0 1": "1"}
    w_row = " ".join(cell.text for cell in lens.table.clip_from_view[3])
    near, far = (written(name, letters) for name in "nf")
    between = f"{near} \u2264 \u2212z_view \u2264 {far}"
    if base == "002":  # its planes are at negative z
        between = f"{far} \u2264 z_view \u2264 {near}"
    return {
        "world": f"{names.get(FROM_OBJECT) or moved} p",
        "view": view if view.endswith(")") else f"{view} p",
        "clip": f"{clip} p_view",
        "w": w.get(w_row, f"({clip} p_view)_4"),
        "between": between,
        "depth": "1 \u2212 z" if signs[2] * signs[3] < 0 else "z + 1",
    }


class WrittenMatrix(NamedTuple):
    name: str  # ``target_from_source``, or the name of a factor
    values: Numbers  # each rounded once; no minus zero
    formulas: Formulas  # in our own names; see `written`
    fields: tuple[tuple[tuple[str, ...], ...], ...]
    """The fields of the document that change the cell (`app.lecture.dependence`)."""
    factors: "tuple[WrittenMatrix, ...]" = ()  # in the product's order; empty if there is only one
    product: tuple[str, ...] = ()  # the stages whose product this matrix is, in that order
    note: str = ""  # as in `Stage`
    called: str = ""  # the lecture's name and chain: ``P_obl = P_ort H``; empty if it has none
    chain: tuple[str, ...] = ()  # `product` with the lecture's name of each stage that has one


def matrices(
    projection: Projection, letters: Letters = "own", *, rows: bool = False, running: bool = False
) -> tuple[WrittenMatrix, ...]:
    """Return every stage's matrix, in the order of `python -m app matrices`.

    In a lecture's letters they are the matrices of its own chain, without identities between. With
    `rows` they are for row vectors: every matrix transposed, every product reversed. With `running`
    the products with the view matrix follow, too, up to `clip_from_world`, and `world_from_view`,
    whose columns are the camera's axes and the eye.
    """
    lens, base = _written(projection), base_of(letters)
    steps, names = _steps(lens.table, base), _names(lens, letters)
    first, view, *between, last = projection.stages
    if steps is not lens.table.steps:  # a lecture's steps, without our factors
        staged = [projection.staged(step) for step in steps]
        between = [stage._replace(factors=stage.factors[:1]) for stage in staged]
    shown: list[tuple[Stage, tuple[str, ...]]] = [(first, ()), (view, ())]
    so_far, source = view.exact, view.name
    if running and view.factors:  # a typed view matrix has no camera axes
        shown.append((_inverse_view(projection), ()))
    for stage in between:
        shown.append((stage, ()))
        target, _, _ = stage.name.partition("_from_")
        if running and target != "clip" and stage.factors:  # clip_from_world follows below
            so_far = product(stage.exact, so_far)
            name = f"{target}_from_world"
            shown.append((Stage(name, so_far, (), ""), (stage.name, source)))
            source = name
    parts = tuple(stage.name for stage in reversed(between))
    to_clip, from_world = projection.direct_stages
    shown.append((to_clip, parts))
    shown.append((from_world, (*(parts or (to_clip.name,)), view.name)))
    shown.append((last, ()))
    tables = _Tables(
        _formulas(lens, base),
        # Numbers are the same in all letters; lecture 002's have signs of their own.
        _fields(
            lens,
            "002" if base == "002" else "own",
            state_of(projection),
            projection.placement.kinds,
        ),
    )
    whole = [_matrix(stage, parts, projection, tables, base, rows) for stage, parts in shown]
    return _chained(whole, names) if names or base != "own" else tuple(whole)


def _steps(table: LensTable, letters: Letters) -> tuple[PipelineStep, ...]:
    """Return a lecture's steps from view to clip space; none if it has one matrix for all."""
    if letters not in _ONE_MATRIX:
        return table.steps
    factors = [factor for step in reversed(table.steps) for factor in step.factors]
    if letters != "002" or not factors or factors[-1][0] != "shear":
        return ()
    return PipelineStep(SHEARED, (factors[-1],)), PipelineStep(FROM_SHEARED, tuple(factors[:-1]))


def _names(lens: "_WrittenForm", letters: Letters) -> dict[str, str]:
    base, _, names = lettering(letters)
    kind = "persp" if lens.is_central else "ort"
    w = written(_formulas(lens, base).get("clip_from_depth_range", _IDENTITY)[3][3], letters)
    texts = {name: called.format(kind=kind, w=w) for name, called in names.items()}
    is_named = names.get("clip_from_view") == lettering(base).matrices.get("clip_from_view")
    if base == "002" and is_named and not lens.table.steps:
        texts["clip_from_view"] = "P"
    elif base == "002" and is_named and _steps(lens.table, base):
        texts["clip_from_view"] = "" if lens.is_central else "P_obl"
    return texts


def names_of(projection: Projection, letters: Letters) -> dict[str, str]:
    """Return a lecture's names of matrices, and of factors by ``stage/factor``."""
    return _names(_written(projection), letters)


def _chain(names: Mapping[str, str], parts: Sequence[str]) -> str:
    """Return a product in a lecture's names; empty if one of its parts has no name.

    A multiple of the identity is a number there: ``f M_z M_pp M_persp``.
    """
    called = [names.get(name) for name in parts]
    return "" if None in called else " ".join(filter(None, called)).replace(" I", "")


def _chained(whole: Sequence[WrittenMatrix], names: Mapping[str, str]) -> tuple[WrittenMatrix, ...]:
    """Name the matrices by a lecture and drop identities, except that of a named object matrix."""
    kept = {
        matrix.name
        for matrix in whole
        if matrix.formulas != _IDENTITY or (matrix.name == FROM_OBJECT and FROM_OBJECT in names)
    }
    whole_chain, shown = [], dict[str, str]()
    for matrix in whole:
        if matrix.name not in kept:
            continue
        factors = tuple(
            factor._replace(called=names.get(f"{matrix.name}/{factor.name}", ""))
            for factor in matrix.factors
        )
        parts = tuple(name for name in matrix.product if name in kept)
        of = parts or [f"{matrix.name}/{factor.name}" for factor in factors]
        called = [*filter(None, (names.get(matrix.name, ""), _chain(names, of)))]
        shown[matrix.name] = called[0] if called else matrix.name
        chain = tuple(_chain(shown, [name]) for name in parts)
        named = matrix._replace(factors=factors, called=" = ".join(called), chain=chain)
        whole_chain.append(named._replace(product=parts))
    return tuple(whole_chain)


def letters_in(matrix: WrittenMatrix, row: int, column: int) -> Highlight:
    """Return the things in a cell's formula, by the names of `app.lecture.highlight`.

    An axis of the camera's frame stands for eye, target and up too; the eye is named only if the
    formula contains it.
    """
    names = parse(matrix.formulas[row][column]).letters
    axes = {
        name.removeprefix("axis_")[0]
        for name in names
        if name.startswith("axis_") or (len(name) == 3 and name[:2] in ("u_", "v_", "n_"))
    }
    eye = {"eye" for name in names if name.startswith("eye")}
    fields = set(matrix.fields[row][column]).union(*(FIELDS.get(name, ()) for name in names))
    if matrix.name == FROM_OBJECT and any(cell != "0" for cell in matrix.formulas[3][:3]):
        row, column = column, row  # of row vectors
    if matrix.name == FROM_OBJECT and row < 3:
        axes.add(OBJECT_AXES[column])
    lens = fields - {"eye", "target", "up"}
    return frozenset(axes | eye | {"fov" if name == "fov_y_deg" else name for name in lens})


def _inverse_view(projection: Projection) -> Stage:
    """``world_from_view`` of the camera."""
    frame = projection.camera.exact_frame
    eye = map(Fraction, projection.camera.eye)
    exact = [[*parts, moved] for *parts, moved in zip(*frame, eye, strict=True)]
    return Stage("world_from_view", [*exact, list(map(Fraction, (0, 0, 0, 1)))], (), "")


_Table: TypeAlias = dict[str, Formulas]
_FieldTable: TypeAlias = dict[str, tuple[tuple[tuple[str, ...], ...], ...]]


class _Tables(NamedTuple):
    """The formulas and fields of every matrix, by stage name or ``stage/factor``."""

    formulas: _Table
    fields: _FieldTable


def _matrix(
    stage: Stage,
    product: tuple[str, ...],
    projection: Projection,
    tables: _Tables,
    letters: Letters,
    rows: bool,
) -> WrittenMatrix:
    signs = _signs(_written(projection), letters)
    one = partial(_one, signs=signs, projection=projection, tables=tables, rows=rows)
    inner = {} if "_from_" in "".join(name for name, _ in stage.factors) else dict(stage.factors)
    turn = -1 if rows else 1
    parts = list(inner.items())[::turn] if len(inner) > 1 else ()
    factors = tuple(one(label, f"{stage.name}/{label}", array) for label, array in parts)
    whole, product = one(stage.name, stage.name, stage.matrix), product[::turn]
    return whole._replace(factors=factors, product=product, note=stage.note, chain=product)


def _one(
    label: str,
    key: str,
    array: Array,
    signs: Callable[[str, int, int], int],
    projection: Projection,
    tables: _Tables,
    rows: bool,
) -> WrittenMatrix:
    values = tuple(
        tuple(signs(key, i, j) * value + 0.0 for j, value in enumerate(row))
        for i, row in enumerate(array.tolist())
    )
    formulas, fields = tables.formulas[key], tables.fields[key]
    if not projection.lens.has_steps and key in ("clip_from_view", "clip_from_world"):
        # Another depth range combines both rows into z; see `Projection.with_depth`.
        depths = tuple(
            (*names, "depth") if array[2, j] or array[3, j] else names
            for j, names in enumerate(fields[2])
        )
        fields = (*fields[:2], depths, fields[3])
    if rows:
        values, fields = tuple(zip(*values, strict=True)), tuple(zip(*fields, strict=True))
        formulas = tuple(tuple(map(_turned, row)) for row in zip(*formulas, strict=True))
    return WrittenMatrix(label, values, formulas, fields)


@cache
def _turned(formula: str) -> str:
    """Exchange the indices of p_ij, m_ij, g_ij and o_ij, for the transposed matrix."""
    tree = parse(formula)
    cells = [name for name in tree.letters if re.fullmatch(r"[pmgo][2-8]?_[1-4]{2}", name)]
    return tree.where({name: parse(f"{name[:-2]}{name[-1]}{name[-2]}") for name in cells}).text


@cache
def _spelled(formula: str, lens: Formulas) -> str:
    """Replace the cells p_ij in a formula by their own formulas."""
    letters = itertools.chain(*_lettered("p"))
    cells = dict(zip(letters, map(parse, itertools.chain(*lens)), strict=True))
    return parse(formula).where(cells).text


@lru_cache(maxsize=64)
def _fields(
    lens: "_WrittenForm", letters: Letters, state: ProjectionState, kinds: tuple[str, ...]
) -> _FieldTable:
    """Return `WrittenMatrix.fields` by the keys of `_formulas`.

    A cell also depends on the depth range if another range gives it another formula, and likewise
    on an infinite far.
    """
    own = _formulas(lens, letters)
    # Tiles that change nothing can be edited.
    own = {**own, FROM_OBJECT: _of_object(kinds)[FROM_OBJECT]}
    others = [
        (field, _formulas(lens._replace(table=table), letters))
        for field, table in lens.table.otherwise.items()
    ]
    for other in DEPTH_RANGES.keys() - {lens.depth}:
        others.append(("depth", _formulas(lens._replace(depth=other), letters)))

    def cell(key: str, i: int, j: int) -> tuple[str, ...]:
        formula = _spelled(own[key][i][j], own["clip_from_view"])
        mine = reach(formula, state)
        fields = dict.fromkeys(mine.fields)
        for field, table in others if key != FROM_OBJECT else ():
            other = _spelled(table[key][i][j], table["clip_from_view"])
            if other != formula and not (mine.is_zero and reach(other, state).is_zero):
                fields[field] = None
        return tuple(fields)

    return {key: tuple(tuple(cell(key, i, j) for j in range(4)) for i in range(4)) for key in own}


# --------------------------------------------------------------------------- lecture 002's signs


def _signs(lens: "_WrittenForm", letters: Letters) -> Callable[[str, int, int], int]:
    """Return the function that gives the sign of a lecture's cell relative to ours."""
    if letters != "002" or not lens.table.steps:
        return lambda key, i, j: 1
    turned = -1 if lens.depth == "opengl" else 1
    w = -1 if lens.is_central else 1

    def sign(key: str, i: int, j: int) -> int:
        name = key.partition("/")[0]
        z_row = turned if i == 2 else 1
        if name in ("clip_from_view", "clip_from_world", FROM_SHEARED):
            return w * z_row
        if name == "clip_from_depth_range":
            return w
        if name == "image_from_ndc" or name.startswith("depth_range_from"):
            if key.endswith("/translation"):  # S T = T' S: only the shift changes sign
                return turned if (i, j) == (2, 3) else 1
            return z_row if key != "image_from_ndc" or j == 2 else 1
        return 1

    return sign


def cell_sign(projection: Projection, letters: Letters, name: str, row: int, column: int) -> int:
    """Return -1 where a lecture changes the sign of a stage's cell, else 1."""
    return _signs(_written(projection), base_of(letters))(name, row, column)


def has_own_signs(projection: Projection, letters: Letters) -> bool:
    """Whether a lecture changes signs of this projection's matrices."""
    sign = _signs(_written(projection), base_of(letters))
    names = ("clip_from_view", "depth_range_from_canonical_parallel")
    return any(sign(name, i, i) < 0 for name in names for i in range(4))


# --------------------------------------------------------------------------- formulas


class _WrittenForm(NamedTuple):
    """The properties that determine a projection's formulas."""

    table: LensTable
    has_own_view: bool
    depth: str
    kinds: tuple[str, ...]  # of the object's tiles; empty for the identity

    @property
    def is_central(self) -> bool:
        """Whether w is the distance."""
        return self.table.clip_from_view[3][2].text == "-1"


def _written(projection: Projection) -> _WrittenForm:
    placement = projection.placement
    kinds = () if placement.is_identity else placement.kinds
    return _WrittenForm(projection.lens.table, not projection.has_camera, projection.depth, kinds)


def called(kind: str) -> str:
    """Return the letter of a kind of tile, with its axis: ``T``, ``R_z``."""
    word, *axis = kind.split()
    return "_".join([_CALLED[word], *axis])


def object_product(chain: Chain, *, rows: bool = False) -> tuple[Formulas, tuple[str, ...]]:
    """Return the formulas of an object's product, and the letters of its tiles in order."""
    formulas = _of_object(chain.kinds)[FROM_OBJECT]
    names = tuple(map(called, chain.kinds))
    if not rows:
        return formulas, names
    turned = tuple(tuple(map(_turned, row)) for row in zip(*formulas, strict=True))
    return turned, names[::-1]


_IDENTITY: Formulas = tuple(tuple(str(int(i == j)) for j in range(4)) for i in range(4))
_LAST_ROW = ("0", "0", "0", "1")


def _lettered(letter: str) -> Formulas:
    """Return a matrix of single letters with indices: p_ij."""
    return tuple(tuple(f"{letter}_{i}{j}" for j in range(1, 5)) for i in range(1, 5))


_OF_OBJECT: Formulas = (*_lettered("o")[:3], _LAST_ROW)
"""The product of the object's tiles, if its formulas are too long for cells."""


def _view_formulas(has_own_view: bool) -> _Table:
    """Return lecture 004's view matrix, its factors and its inverse."""
    axes = tuple(tuple(f"{axis}_{part}" for part in "xyz") for axis in "uvn")
    shifted = (*((*axis, f"-dot(axis_{axis[0][0]}, eye)") for axis in axes), _LAST_ROW)
    moved = ((*_IDENTITY[i][:3], f"-eye_{part}") for i, part in enumerate("xyz"))
    back = ((*(f"{axis}_{part}" for axis in "uvn"), f"eye_{part}") for part in "xyz")
    return {
        "view_from_world": _lettered("m") if has_own_view else shifted,
        "view_from_world/rotation": (*((*axis, "0") for axis in axes), _LAST_ROW),
        "view_from_world/translation": (*moved, _LAST_ROW),
        "world_from_view": (*back, _LAST_ROW),
    }


@lru_cache(maxsize=64)
def _of_object(kinds: tuple[str, ...]) -> _Table:
    """Return the formulas of the object's tiles and of their product."""
    table: _Table = {}
    whole = _ONES
    for kind in lettered_kinds(kinds):
        cells = evaluated(kind.table, Quantities(), SYMBOLS)
        table[f"{FROM_OBJECT}/{kind.factor}"] = _texts(cells)
        whole = whole and product(whole, cells)
        if any(len(cell.above) > _MOST_TERMS for row in whole for cell in row):
            whole = []
    pairs = zip(_texts(whole) if whole else _OF_OBJECT, _OF_OBJECT, strict=True)
    shorter = (map(lambda cell, o: cell if len(cell) <= _LONGEST else o, *pair) for pair in pairs)
    return table | {FROM_OBJECT: tuple(map(tuple, shorter))}


def _texts(cells: list[list[Ratio]]) -> Formulas:
    return tuple(tuple(cell.text for cell in row) for row in cells)


@lru_cache(maxsize=64)
def _formulas(lens: _WrittenForm, letters: Letters) -> _Table:
    """Return the formulas of every cell, by stage name or ``stage/factor``."""
    steps, depth = lens.table.steps, [int(z) for z in DEPTH_RANGES[lens.depth]]
    known = Quantities(_QUANTITIES.get(letters, {}) if steps else {})
    known |= dict(zip(("z_n", "z_f", "z_low"), map(number, (*depth, min(depth))), strict=True))
    signs, written = _signs(lens, letters), lens.table.written.get(letters, {})

    def formulas(key: str, cells: list[list[Ratio]]) -> Formulas:
        signed = (
            [(-cell if signs(key, i, j) < 0 else cell).text for j, cell in enumerate(row)]
            for i, row in enumerate(cells)
        )
        return tuple(tuple(written.get(cell, cell) for cell in row) for row in signed)

    view = _view_formulas(lens.has_own_view)
    table: _Table = {**_of_object(lens.kinds), **view}

    def step_by_step(steps: Sequence[PipelineStep]) -> None:
        from_view = _ONES
        for step in steps:
            whole = _ONES
            for label, factor in step.factors:
                cells = evaluated(factor, known, SYMBOLS)
                table[f"{step.name}/{label}"] = formulas(f"{step.name}/{label}", cells)
                whole = product(whole, cells)
            table[step.name] = formulas(step.name, whole)
            if step.name.endswith("from_ndc"):
                continue
            from_view = product(whole, from_view)
            target, _, _ = step.name.partition("_from_")
            running = formulas(f"{target}_from_view", from_view)
            table[f"{target}_from_view"] = running
            table[f"{target}_from_world"] = _product(running, view["view_from_world"])

    if (of_lecture := _steps(lens.table, letters)) is not steps:
        step_by_step(of_lecture)
    step_by_step((*steps, VIEWPORT))
    if steps:
        # The whole formula is too long for a cell, so p_ij are the cells of clip_from_view.
        lettered = tuple(
            tuple(cell if cell in ("0", "1", "-1") else p for cell, p in zip(*rows, strict=True))
            for rows in zip(table["clip_from_view"], _lettered("p"), strict=True)
        )
    else:
        table["clip_from_view"] = lettered = _lettered("p")
    table["clip_from_world"] = _product(lettered, view["view_from_world"])
    return table


_ONES = [[number(int(i == j)) for j in range(4)] for i in range(4)]


def _product(left: Formulas, right: Formulas) -> Formulas:
    return tuple(
        tuple(_sum([(a, b) for a, b in zip(row, column, strict=True) if "0" not in (a, b)])
              for column in zip(*right, strict=True))
        for row in left
    )  # fmt: skip


def _sum(terms: Sequence[tuple[str, str]]) -> str:
    """Write a sum of products, without factors 1."""
    text = ""
    for pair in terms:
        negative = False
        above, below = [], ""
        for part in pair:
            tree = parse(part)
            if isinstance(tree, Quotient):
                below += f"/{_in_brackets(tree.right)}"
                tree = tree.left
            part = _in_brackets(tree) if isinstance(tree, Sum | Difference) else tree.text
            if part.startswith("-"):  # move the sign in front of the product
                negative, part = not negative, part[1:]
            if part != "1":
                above.append(part)
        term = ("*".join(above) or "1") + below
        text = (f"{text} {'-' if negative else '+'} {term}" if text
                else f"{'-' if negative else ''}{term}")  # fmt: skip
    return text or "0"


def _in_brackets(tree: Formula) -> str:
    return f"({tree.text})" if isinstance(tree, Pair) else tree.text
