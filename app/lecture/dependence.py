"""Which controls change a formula's value when they are moved from where all of them stand.

A factor of a product that is 0 hides the others: ``(r + l)/(r - l)`` of a window that lies evenly
about the axis depends on where its sides are, and not on how wide it is made to fit the image.
What is 0 by chance of no number that a control has (a sum that cancels) is not looked for.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Sequence
from fractions import Fraction
from functools import cache, lru_cache
from typing import NamedTuple, TypeAlias

from app.model.projection import FreeMatrix, Oblique, Perspective, Projection

FIELDS = {
    "n": ("near",), "f": ("far",), "l": ("left",), "r": ("right",), "b": ("bottom",), "t": ("top",),
    "fov": ("fov_y_deg",), "theta_v": ("fov_y_deg",), "theta_h": ("fov_y_deg", "image"),
    "e": ("fov_y_deg", "image"), "aspect": ("image",), "a": ("image",), "W": ("image",),
    "H": ("image",), "alpha": ("alpha_deg",), "beta": ("beta_deg",),
    "axis_u": ("eye", "target", "up"), "axis_v": ("eye", "target", "up"),
    "axis_n": ("eye", "target"), "eye": ("eye",), "target": ("target",),
}  # fmt: skip
"""Of the document, by the names of `app.lecture.notation`'s formulas."""

_ROUNDING = 1e-12
"""What a window's proportions may differ from the image's, of themselves, by their rounding."""
_SIDES = {("r", "l"): "x", ("t", "b"): "y"}


class State(NamedTuple):
    """What of a projection decides which of its numbers matter; see `state_of`.

    Attributes
    ----------
    keep : str
        The lens' proportions; empty for a lens without a window.
    zeros : frozenset of str
        The names, and the sums and calls of names, that are 0.
    fits : bool
        Whether the lens' window has the image's proportions as it is: then nothing is fitted.
    held : tuple of (str, tuple of str)
        Components of u and v that are 0 and can only be moved by some of their fields: along an
        axis of the world u has none wherever the camera stands if up has only that, nor have u
        and v whatever up is if n has only that.
    """

    keep: str
    zeros: frozenset[str]
    fits: bool
    held: tuple[tuple[str, tuple[str, ...]], ...]


class Reach(NamedTuple):
    """The fields that move a formula, and whether it is 0 now."""

    fields: tuple[str, ...]
    is_zero: bool


_Found: TypeAlias = tuple[dict[str, None], bool]


def state_of(projection: Projection) -> State:
    """The state that a projection is in.

    Parameters
    ----------
    projection : Projection
    """
    lens, camera = projection.lens, projection.camera
    values: dict[str, object] = {}
    fits = False
    for point in ("eye", "target"):
        parts = getattr(camera, point)
        values |= {f"{point}_{x}": part for x, part in zip("xyz", parts, strict=True)}
    values["eye"] = any(camera.eye)
    frame, shift = camera.exact_frame, camera.exact_view((0.0, 0.0, 0.0))
    for axis, row, part in zip("uvn", frame, shift, strict=True):
        values |= {f"{axis}_{x}": component for x, component in zip("xyz", row, strict=True)}
        values[f"dot(axis_{axis})"] = part
    if isinstance(lens, FreeMatrix):
        for i, cells in enumerate(lens.clip_from_view, 1):
            values |= {f"p_{i}{j}": cell for j, cell in enumerate(cells, 1)}
    else:
        values |= {"n": lens.near, "f": lens.far}
        if not isinstance(lens, Perspective):
            values |= {"r + l": lens.right + lens.left, "t + b": lens.top + lens.bottom}
            fitted = projection.aspect * (lens.top - lens.bottom)
            fits = math.isclose(lens.right - lens.left, fitted, rel_tol=_ROUNDING)
        if isinstance(lens, Oblique):
            values |= dict(zip(("cot(alpha)", "cot(beta)"), lens.shear, strict=True))
    held: list[tuple[str, tuple[str, ...]]] = [(f"u_{x}", ("up",)) for x in _only_axis(camera.up)]
    held += [(f"{axis}_{x}", ("eye", "target")) for x in _only_axis(frame[2]) for axis in "uv"]
    return State(
        getattr(lens, "keep", ""),
        frozenset(name for name, value in values.items() if not value),
        fits,
        tuple(held),
    )


def _only_axis(vector: Sequence[float | Fraction]) -> str:
    """The letter of the world's axis that a vector lies along; nothing for any other."""
    along = [letter for letter, part in zip("xyz", vector, strict=True) if part]
    return along[0] if len(along) == 1 else ""


@lru_cache(maxsize=8192)
def reach(formula: str, state: State) -> Reach:
    """What a formula depends on.

    Parameters
    ----------
    formula : str
        In the names of `app.lecture.notation`.
    state : State
    """
    fields, is_zero = _of(_tree(formula), state)
    return Reach(tuple(fields), is_zero)


@cache
def _tree(formula: str) -> ast.expr:
    return ast.parse(formula, mode="eval").body


def _of(node: ast.expr, state: State) -> _Found:
    if isinstance(node, ast.Constant):
        return {}, node.value == 0
    if isinstance(node, ast.Name):
        return _of_name(node.id, state)
    if isinstance(node, ast.UnaryOp):
        return _of(node.operand, state)
    if isinstance(node, ast.Call):
        assert isinstance(node.func, ast.Name)
        if node.func.id == "dot":
            assert isinstance(node.args[0], ast.Name)
            return _of_dot(node.args[0].id, state)
        found, _ = _of(node.args[0], state)
        return found, ast.unparse(node) in state.zeros
    assert isinstance(node, ast.BinOp)
    if isinstance(node.left, ast.Name) and isinstance(node.right, ast.Name):
        across = _SIDES.get((node.left.id, node.right.id))
        if across is not None:
            return _of_window(across, isinstance(node.op, ast.Add), state)
    (left, left_is_zero), (right, right_is_zero) = _of(node.left, state), _of(node.right, state)
    if isinstance(node.op, ast.Div):
        cancelled = _what_is_left(node.left, state)
        if cancelled and cancelled == _what_is_left(node.right, state):
            return {field: None for field in left | right if field not in FIELDS[cancelled]}, False
        return (left if left_is_zero else left | right), left_is_zero
    if not isinstance(node.op, ast.Mult):
        return left | right, left_is_zero and right_is_zero
    if left_is_zero and right_is_zero:
        return {field: None for field in left if field in right}, True
    if left_is_zero or right_is_zero:
        return (left if left_is_zero else right), True
    return left | right, False


def _what_is_left(node: ast.expr, state: State) -> str:
    """The plane that a sum of planes is, without those at 0: f is for ``f - n`` with n = 0."""
    if isinstance(node, ast.UnaryOp):
        return _what_is_left(node.operand, state)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
        for gone, other in ((node.left, node.right), (node.right, node.left)):
            if _of(gone, state)[1]:
                return _what_is_left(other, state)
    if isinstance(node, ast.Name) and node.id in ("n", "f") and node.id not in state.zeros:
        return node.id
    return ""


def _of_name(name: str, state: State) -> _Found:
    if name in dict(state.held):
        return dict.fromkeys(dict(state.held)[name]), True
    stem, _, part = name.partition("_")
    if part in ("x", "y", "z"):
        stem = f"axis_{stem}" if stem in ("u", "v", "n") else stem
    else:
        stem = name
    return dict.fromkeys(FIELDS.get(stem, ())), name in state.zeros


def _of_dot(axis: str, state: State) -> _Found:
    """The eye's component along an axis: along u and v the target has the same.

    So only what moves both sums of products, with the eye's parts and the target's, moves it.
    """
    is_zero = f"dot({axis})" in state.zeros
    if axis == "axis_n":
        return dict.fromkeys(("eye",) if "eye" in state.zeros else ("eye", "target")), is_zero
    by_eye, by_target = (
        _of(_tree(" + ".join(f"{axis[-1]}_{x}*{point}_{x}" for x in "xyz")), state)[0]
        for point in ("eye", "target")
    )
    return {field: None for field in by_eye if field in by_target}, is_zero


def _of_window(across: str, is_sum: bool, state: State) -> _Found:
    """Of ``r + l`` or ``r - l``, or the same of y: only the extents are fitted to the image."""
    pair = {"x": ("right", "left"), "y": ("top", "bottom")}
    if is_sum:
        return dict.fromkeys(pair[across]), ("r + l" if across == "x" else "t + b") in state.zeros
    kept = across if state.keep == "stretch" else state.keep
    fields = (*pair[kept], *(() if kept == across else ("image",)))
    return dict.fromkeys(fields if state.fits else (*fields, "keep")), False
