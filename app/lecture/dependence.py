"""Which controls change a formula's value when one of them moves from its present value.

A factor that is 0 hides the other factors of a product. ``(r + l)/(r - l)`` of a window that is
symmetric about the axis depends on its sides, but not on the width that fits it to the image. This
module ignores sums that happen to cancel.
"""

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple, TypeAlias

from app.model import formula
from app.model.chain import MOST_TILES, lettered_kinds
from app.model.lenses.perspective import FOV_Y
from app.model.parameters import ASPECT, EYE, PARAMETERS, ROTATE, TARGET, TILES, TRANSLATE, UP
from app.model.projection import Projection

FIELDS = {  # fields of the document by the names in the formulas of `app.lecture.notation`
    **{each.letter: each.fields for each in PARAMETERS.values() if each.letter},
    **{
        f"{stem}{n}": (f"{each.name}{n}",)
        for each in TILES.values()
        for stem in (each.letter, *(["about"] if each is ROTATE else []))
        for n in ("", *range(2, MOST_TILES + 1))
    },
    "theta_v": FOV_Y.fields,
    "theta_h": (*FOV_Y.fields, *ASPECT.fields),
    "e": (*FOV_Y.fields, *ASPECT.fields),
    **dict.fromkeys(("a", "W", "H"), ASPECT.fields),
    **dict.fromkeys(("axis_u", "axis_v"), (EYE.name, TARGET.name, UP.name)),
    "axis_n": (EYE.name, TARGET.name),
}

_OF_TILES = {each.letter for each in TILES.values()}
_SIDES = {("r", "l"): "x", ("t", "b"): "y"}


class ProjectionState(NamedTuple):
    """The facts about a projection that decide which of its numbers matter; see `state_of`."""

    keep: str  # the lens' proportions; empty for a lens without a window
    zeros: frozenset[str]  # the names, and the sums and calls of names, that are 0
    fits: bool  # whether the lens' window already has the image's proportions
    letters: tuple[tuple[str, tuple[str, ...]], ...]
    """Letters that only this lens has, and the fields of the document that they depend on."""
    held: tuple[tuple[str, tuple[str, ...]], ...]
    """Components of u and v that are 0, and the only fields that can change them. If up lies along
    an axis of the world, u has no component along it for any camera position. If n lies along it,
    neither u nor v has one for any up."""


class Influence(NamedTuple):
    """The fields that move a formula, and whether it is 0 now."""

    fields: tuple[str, ...]
    is_zero: bool


_FieldsAndZero: TypeAlias = tuple[dict[str, None], bool]


def state_of(projection: Projection) -> ProjectionState:
    lens, camera = projection.lens, projection.camera
    values: dict[str, object] = {}
    for point in ("eye", "target"):
        parts = getattr(camera, point)
        values |= {f"{point}_{x}": part for x, part in zip("xyz", parts, strict=True)}
    values["eye"] = any(camera.eye)
    frame, shift = camera.exact_frame, camera.exact_origin
    for axis, row, part in zip("uvn", frame, shift, strict=True):
        values |= {f"{axis}_{x}": component for x, component in zip("xyz", row, strict=True)}
        values[f"dot(axis_{axis})"] = part
    values |= lens.letters(Fraction(*projection.image_size))
    values |= projection.placement.letters
    held: list[tuple[str, tuple[str, ...]]] = [(f"u_{x}", ("up",)) for x in _only_axis(camera.up)]
    held += [(f"{axis}_{x}", ("eye", "target")) for x in _only_axis(frame[2]) for axis in "uv"]
    return ProjectionState(
        getattr(lens, "keep", ""),
        frozenset(name for name, value in values.items() if not value),
        lens.fits(projection.aspect),
        (*lens.table.fields.items(), *_of_product(projection.placement.kinds)),
        tuple(held),
    )


@lru_cache(maxsize=64)
def _of_product(kinds: tuple[str, ...]) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Return the letters of the cells of the object's product, and all that its tiles have."""
    fields = tuple(kind.field for kind in lettered_kinds(kinds) if kind.letters)
    linear = tuple(field for field in fields if not field.startswith(TRANSLATE.name))
    return tuple(
        (f"o_{i}{j}", fields if j == 4 else linear) for i in range(1, 4) for j in range(1, 5)
    )


def _only_axis(vector: Sequence[float | Fraction]) -> str:
    """Return the letter of the world's axis along which a vector lies; empty for other vectors."""
    along = [letter for letter, part in zip("xyz", vector, strict=True) if part]
    return along[0] if len(along) == 1 else ""


@lru_cache(maxsize=8192)
def reach(text: str, state: ProjectionState) -> Influence:
    """Return the fields that change a formula in the names of `app.lecture.notation`."""
    fields, is_zero = _of(formula.parse(text), state)
    return Influence(tuple(fields), is_zero)


def _of(node: formula.Formula, state: ProjectionState) -> _FieldsAndZero:
    if isinstance(node, formula.Number):
        return {}, node.number == 0
    if isinstance(node, formula.Letter):
        return _of_name(node.name, state)
    if isinstance(node, formula.Negative | formula.Power):
        return _of(node.parts[0], state)
    if isinstance(node, formula.Call):
        first = node.arguments[0]
        if node.name == "dot":
            assert isinstance(first, formula.Letter)
            return _of_dot(first.name, state)
        fields, _ = _of(first, state)
        return fields, node.text in state.zeros
    assert isinstance(node, formula.Pair)
    if isinstance(node.left, formula.Letter) and isinstance(node.right, formula.Letter):
        across = _SIDES.get((node.left.name, node.right.name))
        if across is not None:
            return _of_window(across, isinstance(node, formula.Sum), state)
    (left, left_is_zero), (right, right_is_zero) = _of(node.left, state), _of(node.right, state)
    if isinstance(node, formula.Quotient):
        cancelled = _only_nonzero_plane(node.left, state)
        if cancelled and cancelled == _only_nonzero_plane(node.right, state):
            return {field: None for field in left | right if field not in FIELDS[cancelled]}, False
        return (left if left_is_zero else left | right), left_is_zero
    if isinstance(node, formula.Sum | formula.Difference):
        return left | right, left_is_zero and right_is_zero
    if left_is_zero and right_is_zero:
        return {field: None for field in left if field in right}, True
    if left_is_zero or right_is_zero:
        return (left if left_is_zero else right), True
    return left | right, False


def _only_nonzero_plane(node: formula.Formula, state: ProjectionState) -> str:
    """Return the only plane of a sum that is not 0: f for ``f - n`` with n = 0."""
    if isinstance(node, formula.Negative):
        return _only_nonzero_plane(node.operand, state)
    if isinstance(node, formula.Sum | formula.Difference):
        for gone, other in ((node.left, node.right), (node.right, node.left)):
            if _of(gone, state)[1]:
                return _only_nonzero_plane(other, state)
    if (
        isinstance(node, formula.Letter)
        and node.name in ("n", "f")
        and node.name not in state.zeros
    ):
        return node.name
    return ""


def _of_name(name: str, state: ProjectionState) -> _FieldsAndZero:
    if name in dict(state.held):
        return dict.fromkeys(dict(state.held)[name]), True
    stem, _, part = name.partition("_")
    if part in ("x", "y", "z") or stem.rstrip("2345678") in _OF_TILES:
        stem = f"axis_{stem}" if stem in ("u", "v", "n") else stem
    else:
        stem = name
    fields = dict(state.letters).get(stem) or FIELDS.get(stem, ())
    return dict.fromkeys(fields), name in state.zeros


def _of_dot(axis: str, state: ProjectionState) -> _FieldsAndZero:
    """Return the reach of the eye's component along an axis.

    Along u and v the target has the same component. Only fields that change the products with both
    the eye and the target change it.
    """
    is_zero = f"dot({axis})" in state.zeros
    if axis == "axis_n":
        return dict.fromkeys(("eye",) if "eye" in state.zeros else ("eye", "target")), is_zero
    by_eye, by_target = (
        _of(formula.parse(" + ".join(f"{axis[-1]}_{x}*{point}_{x}" for x in "xyz")), state)[0]
        for point in ("eye", "target")
    )
    return {field: None for field in by_eye if field in by_target}, is_zero


def _of_window(across: str, is_sum: bool, state: ProjectionState) -> _FieldsAndZero:
    """Return the reach of ``r + l`` or ``r - l``, or the same of y: only extents are fitted."""
    pair = {"x": ("right", "left"), "y": ("top", "bottom")}
    if is_sum:
        return dict.fromkeys(pair[across]), ("r + l" if across == "x" else "t + b") in state.zeros
    kept = across if state.keep == "stretch" else state.keep
    fields = (*pair[kept], *(() if kept == across else ("image",)))
    return dict.fromkeys(fields if state.fits else (*fields, "keep")), False
