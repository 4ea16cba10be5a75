"""What the lectures call quantities, points, axes and matrices, and a file of one's own letters.

Our own letters are the keys; `app.model.parameters` has that of each parameter. A file changes some
letters of a lecture::

    base = "004"        # the lecture; own without it
    [parameters]
    near = "N"
    [vectors]
    eye = "C"
    [matrices]
    view_from_world = "V"
"""

import re
from collections.abc import Mapping, Sequence
from functools import cache, lru_cache
from typing import NamedTuple, TypeAlias

from app.lecture.highlight import OBJECT_AXES
from app.model import formula_text
from app.model.chain import FROM_OBJECT, MOST_TILES
from app.model.formula import ARROW, parse
from app.model.limits import ONE_OF
from app.model.refusal import QT_TRANSLATE_NOOP, REFUSALS, Refusal, nearest

Letters: TypeAlias = str
"""One of `LETTERS`, or the text of a file of one's own letters."""

LETTERS: tuple[Letters, ...] = ("own", "000", "001", "002", "003", "004")
"""The program's own (axes as in lecture 004, planes as in 003), and those of five lectures."""
LONGEST_FILE = 10_000  # most characters of a file of letters
NOT_KNOWN = QT_TRANSLATE_NOOP("Refusal", "is not known; the nearest name is {0}")
ONCE = QT_TRANSLATE_NOOP("Refusal", "is the letter of {0} already; two things cannot share one")

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

PARAMETERS: dict[str, tuple[str, ...]] = {
    "left": ("l",), "right": ("r",), "bottom": ("b",), "top": ("t",),
    "near": ("n", "near_distance"), "far": ("f", "far_distance"), "fov": ("fov", "theta_v"),
    "fov_x": ("fov_x", "theta_h"), "aspect": ("aspect", "a"), "focal": ("e",),
    "alpha": ("alpha",), "beta": ("beta",), "width": ("W",), "height": ("H",),
}  # fmt: skip
"""What a file calls the parameters, and our own letters for them."""
_TILES = {
    "translate": "move", "rotate": "turn", "scale": "size", "about": "about", "shear": "shear",
}  # fmt: skip
_KNOWN: dict[str, Sequence[str]] = {
    "": ("base",),
    "parameters": (*PARAMETERS, *_TILES),
    "vectors": ("eye", "target", "up", "u", "v", "n"),
    "matrices": (
        FROM_OBJECT, "view_from_world", "canonical_perspective_from_view",
        "canonical_parallel_from_canonical_perspective", "depth_range_from_canonical_parallel",
        "clip_from_depth_range", "clip_from_view", "clip_from_world", "image_from_ndc",
        "world_from_view", "view_from_world/rotation", "view_from_world/translation",
    ),
}  # fmt: skip
"""The names that each section of a file may have; before the first section, the lecture."""
GREEK = "\u03b1β\u03b3δεθλμπρ\u03c3φω"  # noqa: RUF001 -- those of panes and figures
_LONGEST = 12
_A_LETTER = re.compile(r"(?:[A-Za-z]+|[" + GREEK + r"])[0-9]*(?:_[A-Za-z0-9]+)?")
_LINE = re.compile(
    r"""(?:\[\s*(?P<section>\w+)\s*\]|(["']?)(?P<name>[\w/]+)\2\s*=\s*(["'])(?P<letter>[^"']*)\4)?"""
    r"\s*(?:#.*)?"
)


class Lettering(NamedTuple):
    """The letters of a lecture, or of a file that is based on it."""

    base: Letters  # the lecture, whose quantities, signs and chain of matrices these are
    symbols: Mapping[str, str]
    matrices: Mapping[str, str]


@lru_cache(maxsize=16)
def lettering(letters: Letters) -> Lettering:
    """Return the letters of a lecture or a file; a `Refusal` names the line and the bound."""
    if letters in LETTERS:
        return Lettering(letters, _SYMBOLS[letters], MATRIX_NAMES.get(letters, {}))
    is_text = isinstance(letters, str) and not {"=", "\n"}.isdisjoint(letters)
    if not is_text or len(letters) > LONGEST_FILE:
        raise Refusal(
            "letters", letters, REFUSALS["some-letters"], ", ".join(LETTERS), LONGEST_FILE
        )
    given = _sections(letters)
    base = given[""].get("base", "own")
    symbols, matrices = dict(_SYMBOLS[base]), given["matrices"]
    for name, letter in given["parameters"].items():
        symbols |= _of_parameter(name, letter, base)
    for name, letter in given["vectors"].items():
        symbols |= _of_vector(name, letter)
    return Lettering(base, symbols, {**MATRIX_NAMES.get(base, {}), **matrices})


def _sections(text: str) -> dict[str, dict[str, str]]:
    """Read a file of letters by its sections."""
    given: dict[str, dict[str, str]] = {section: {} for section in _KNOWN}
    section, places = "", dict[tuple[str, str], str]()
    for number, line in enumerate(text.splitlines(), 1):
        place, match = f"letters, line {number}", _LINE.fullmatch(line.strip())
        if match is None:
            raise Refusal(place, line.strip(), REFUSALS["a-line"])
        section, name = match["section"] or section, match["name"]
        if section not in _KNOWN:
            raise Refusal(place, section, NOT_KNOWN, nearest(section, _KNOWN))
        if name is None:
            continue
        if name not in _KNOWN[section]:
            raise Refusal(place, name, NOT_KNOWN, nearest(name, _KNOWN[section]))
        letter, places[section, name] = match["letter"], f"{place}: {name}"
        if not section and letter not in LETTERS:
            raise Refusal(f"{place}: {name}", letter, ONE_OF, ", ".join(LETTERS))
        if section and (len(letter) > _LONGEST or not _A_LETTER.fullmatch(letter)):
            raise Refusal(f"{place}: {name}", letter, REFUSALS["a-letter"], GREEK, _LONGEST)
        given[section][name] = letter
    base = given[""].get("base", "own")
    symbols = _SYMBOLS[base]
    of_lecture = {
        "parameters": {name: symbols.get(ours[0], ours[0]) for name, ours in PARAMETERS.items()
                       if base == "003" or name != "focal"},
        "vectors": {name: its for name, its in _frame(symbols).items() if name != "e"},
        "matrices": MATRIX_NAMES.get(base, {}),
    }  # fmt: skip
    for (section, name), place in places.items():
        held = of_lecture.get(section, {}) | given[section]
        for other in held:
            if other != name and held[other] == held[name]:
                raise Refusal(place, held[name], ONCE, other)
    return given


def base_of(letters: Letters) -> Letters:
    """Return the lecture of letters, which a file may have changed."""
    return lettering(letters).base


def _of_parameter(name: str, letter: str, base: Letters) -> dict[str, str]:
    if name in _TILES:  # t_x, and t_2x of the second one
        tile = re.compile(rf"{_TILES[name]}\d*_")
        return {
            ours: _component(letter, its.partition("_")[2])
            for ours, its in _OURS.items() if tile.match(ours)
        }  # fmt: skip
    minus = "\u2212" if base == "002" else ""  # its planes are at negative z
    return {ours: f"{minus * ours.endswith('_distance')}{letter}" for ours in PARAMETERS[name]}


def _of_vector(name: str, letter: str) -> dict[str, str]:
    arrow = letter if "_" in letter else f"{letter}{ARROW}"
    if name in ("target", "up"):
        return {name: arrow, f"{name}_point": letter}
    parts = {f"{name}_{x}": _component(letter, x) for x in "xyz"}
    return parts | (
        {"eye": arrow, "eye_point": letter} if name == "eye" else {f"axis_{name}": arrow}
    )


def _component(letter: str, axis: str) -> str:
    """Return the letter of a vector's component: ``C_x``, and ``P_0x`` of ``P_0``."""
    return f"{letter}{'' if '_' in letter else '_'}{axis}"


_FRAME = {
    "e": "eye", "n": "axis_n", "u": "axis_u", "v": "axis_v", "up": "up", "target": "target",
}  # fmt: skip


def frame_letters(letters: Letters) -> dict[str, str]:
    """Return a lecture's names of the vectors of the camera's frame, without arrows.

    The keys are our own letters ``e``, ``n``, ``u``, ``v``, ``up``, ``target``, and ``M`` for the
    view matrix and ``T`` for its translation.
    """
    _, symbols, names = lettering(letters)
    letter_of = _frame(symbols)
    letter_of["T"] = names.get("view_from_world/translation", "T")
    return {**letter_of, "M": names.get("view_from_world", "M")}


def _frame(symbols: Mapping[str, str]) -> dict[str, str]:
    points = {name: symbols.get(f"{name}_point", symbols.get(name)) for name in ("eye", "target")}
    symbols = {**symbols, **{name: symbol for name, symbol in points.items() if symbol}}
    return {ours: symbols.get(name, ours).replace(ARROW, "") for ours, name in _FRAME.items()}


def axis_letters(letters: Letters) -> dict[str, str]:
    """Return the labels at the camera in a lecture's letters: ``u``, ``v``, ``n``, ``up``, ``eye``.

    Lecture 003 also has letters for the object's axes. The dictionary omits the points and
    directions without a letter, which keep their names.
    """
    letter_of = frame_letters(letters)
    symbols = lettering(letters).symbols
    letter_of |= {name: symbols.get(f"{name}_point", name) for name in ("eye", "target")}
    letter_of = {
        name: letter_of[name]
        for name in ("u", "v", "n", "up", "eye", "target")
        if letter_of[name] != name or len(name) == 1
    }
    axes = {name: symbols.get(name, "") for name in OBJECT_AXES}
    return letter_of | {name: letter for name, letter in axes.items() if letter}


def in_letters(text: str, letters: Letters) -> str:
    """Replace the names in braces by a lecture's letters.

    ``{l}, {r}`` becomes ``x_min, x_max`` for lecture 000, and ``{axis_n}`` ``w`` for lecture 001.
    """

    symbols = lettering(letters).symbols

    def letter(match: re.Match[str]) -> str:
        return symbols.get(match[1], match[1]).replace(ARROW, "")

    return re.sub(r"\{([a-z]\w*)\}", letter, text)


@cache
def written(text: str, letters: Letters) -> str:
    """Write a formula in one line: ``2n/(r−l)``.

    ``_`` stands before a subscript, and `ARROW` after a vector's letter.
    """
    return formula_text.written(parse(text), lettering(letters).symbols)


@cache
def stacked(text: str, letters: Letters) -> str:
    """Write a formula with fractions as in `app.model.formula_text.stacked_fraction`."""
    return formula_text.stacked(parse(text), lettering(letters).symbols)


@cache
def latex_formula(text: str, letters: Letters) -> str:
    """Write a formula in LaTeX's math mode: ``\\frac{2 n}{r - l}``."""
    return formula_text.latex(parse(text), lettering(letters).symbols)
