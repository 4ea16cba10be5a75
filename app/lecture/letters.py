"""What the lectures call quantities, points, axes and matrices.

Our own letters are the keys; `app.model.parameters` has that of each parameter.
"""

import re
from functools import cache
from typing import Literal, TypeAlias

from app.lecture.highlight import OBJECT_AXES
from app.model import formula_text
from app.model.chain import FROM_OBJECT, MOST_TILES
from app.model.formula import ARROW, parse

Letters: TypeAlias = Literal["own", "000", "001", "002", "003", "004"]

LETTERS: tuple[Letters, ...] = ("own", "000", "001", "002", "003", "004")
"""The program's own (axes as in lecture 004, planes as in 003), and those of five lectures."""

_OURS = {
    "fov": "fov", "aspect": "aspect", "alpha": "\u03b1", "beta": "β",
    "axis_u": f"u{ARROW}", "axis_v": f"v{ARROW}", "axis_n": f"n{ARROW}", "eye": f"e{ARROW}",
    **{
        f"{stem}{n}_{part}": f"{letter}_{n}{part}"
        for stem, letter, parts in (
            ("move", "t", "xyz"), ("turn", "φ", "xyza"), ("size", "s", "xyz"),
            ("about", "a", "xyz"), ("shear", "h", ("xy", "xz", "yx", "yz", "zx", "zy")),
        )
        for part in parts
        for n in ("", *range(2, MOST_TILES + 1))
    },
    "eye_x": "e_x", "eye_y": "e_y", "eye_z": "e_z", "theta_h": "θ_h", "theta_v": "θ_v",
    "near_distance": "n", "far_distance": "f", "divided_z": "\u2212A \u2212 B / z",
    "eye_plane": "w = 0", "pixel_x": "x", "pixel_y": "y", "near_in_cube": "\u22121",
}  # fmt: skip
_EYE_P = {"eye": f"P{ARROW}", "eye_x": "x_p", "eye_y": "y_p", "eye_z": "z_p"}
_SYMBOLS: dict[str, dict[str, str]] = {
    "own": _OURS,
    "000": {
        **_OURS,
        "l": "x_min", "r": "x_max", "b": "y_min", "t": "y_max", "n": "z_min", "f": "z_max",
        "near_distance": "z_min", "far_distance": "z_max",
        "fitted_l": "x_1", "fitted_r": "x_2", "fitted_b": "y_1", "fitted_t": "y_2",
    },
    "001": {
        **_OURS, **_EYE_P, "axis_n": f"w{ARROW}", "n_x": "w_x", "n_y": "w_y", "n_z": "w_z",
        "fov": "θ_v", "fov_x": "θ_h", "eye_point": "P",
    },
    "002": {
        **_OURS, "l": "x_l", "r": "x_r", "b": "y_b", "t": "y_t", "n": "z_n", "f": "z_f",
        "near_distance": "\u2212z_n", "far_distance": "\u2212z_f",
        "divided_z": "A + B / z", "near_in_cube": "1",
    },
    "003": {  # e is its focal length
        **_OURS, **_EYE_P, **{f"object_{x}": f"O_{x}" for x in "xyz"},
        "fov": "β", "fov_x": "\u03b1",
    },
    "004": {
        **_OURS, "eye": "T_0", "eye_x": "x_0", "eye_y": "y_0", "eye_z": "z_0", "up": f"V{ARROW}",
        "eye_point": "T\u2080", "target_point": "T\u2081",
        "eye_plane": "z = 0", "pixel_x": "u", "pixel_y": "v",
    },
}  # fmt: skip

SHEARED, FROM_SHEARED = "sheared_from_view", "clip_from_sheared"
"""Lecture 002's steps of an oblique or off-axis lens: H first."""

MATRIX_NAMES: dict[str, dict[str, str]] = {
    "001": {
        "canonical_perspective_from_view": "M_persp",
        "canonical_parallel_from_canonical_perspective": "M_pp",
        "depth_range_from_canonical_parallel": "M_z",
        "clip_from_depth_range": "{w} I",  # the lecture's own w is 1 at far
    },
    "000": {"clip_from_view": "P"},
    "002": {
        FROM_OBJECT: "M",
        "view_from_world": "V",
        SHEARED: "H",
        FROM_SHEARED: "P_{kind}",
        "clip_from_view": "P_{kind}",
    },
    "003": {
        FROM_OBJECT: "M_O\u2192W",
        "view_from_world": "M_W\u2192E",
        "clip_from_view": "M_projection",
    },
    "004": {"view_from_world/rotation": "R", "view_from_world/translation": "P"},
}
"""The lectures' names of matrices and factors; lecture 002 names projections by kind."""

_FRAME = {
    "e": "eye", "n": "axis_n", "u": "axis_u", "v": "axis_v", "up": "up", "target": "target",
}  # fmt: skip


def frame_letters(letters: Letters) -> dict[str, str]:
    """Return a lecture's names of the vectors of the camera's frame, without arrows.

    The keys are our own letters ``e``, ``n``, ``u``, ``v``, ``up``, ``target``, and ``M`` for the
    view matrix and ``T`` for its translation.
    """
    symbols = _SYMBOLS[letters]
    points = {name: symbols.get(f"{name}_point", symbols.get(name)) for name in ("eye", "target")}
    symbols = {**symbols, **{name: symbol for name, symbol in points.items() if symbol}}
    letter_of = {ours: symbols.get(name, ours).replace(ARROW, "") for ours, name in _FRAME.items()}
    names = MATRIX_NAMES.get(letters, {})
    letter_of["T"] = names.get("view_from_world/translation", "T")
    return {**letter_of, "M": names.get("view_from_world", "M")}


def axis_letters(letters: Letters) -> dict[str, str]:
    """Return the labels at the camera in a lecture's letters: ``u``, ``v``, ``n``, ``up``, ``eye``.

    Lecture 003 also has letters for the object's axes. The dictionary omits the points and
    directions without a letter, which keep their names.
    """
    letter_of = frame_letters(letters)
    letter_of |= {name: _SYMBOLS[letters].get(f"{name}_point", name) for name in ("eye", "target")}
    letter_of = {
        name: letter_of[name]
        for name in ("u", "v", "n", "up", "eye", "target")
        if letter_of[name] != name or len(name) == 1
    }
    axes = {name: _SYMBOLS[letters].get(name, "") for name in OBJECT_AXES}
    return letter_of | {name: letter for name, letter in axes.items() if letter}


def in_letters(text: str, letters: Letters) -> str:
    """Replace the names in braces by a lecture's letters.

    ``{l}, {r}`` becomes ``x_min, x_max`` for lecture 000, and ``{axis_n}`` ``w`` for lecture 001.
    """

    def letter(match: re.Match[str]) -> str:
        return _SYMBOLS[letters].get(match[1], match[1]).replace(ARROW, "")

    return re.sub(r"\{([a-z]\w*)\}", letter, text)


@cache
def written(text: str, letters: Letters) -> str:
    """Write a formula in one line: ``2n/(r−l)``.

    ``_`` stands before a subscript, and `ARROW` after a vector's letter.
    """
    return formula_text.written(parse(text), _SYMBOLS[letters])


@cache
def stacked(text: str, letters: Letters) -> str:
    """Write a formula with fractions as in `app.model.formula_text.stacked_fraction`."""
    return formula_text.stacked(parse(text), _SYMBOLS[letters])


@cache
def latex_formula(text: str, letters: Letters) -> str:
    """Write a formula in LaTeX's math mode: ``\\frac{2 n}{r - l}``."""
    return formula_text.latex(parse(text), _SYMBOLS[letters])
