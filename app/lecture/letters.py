"""What the lectures call quantities, points, axes and matrices, and a file of one's own letters.

The lectures' letters are on the page ``content/letters.md``. Our own are the keys;
`app.model.parameters` has that of each parameter. A file changes some letters of a lecture::

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
from pathlib import Path
from typing import NamedTuple, TypeAlias

from app.lecture.highlight import OBJECT_AXES
from app.model import formula_text
from app.model.chain import MOST_TILES
from app.model.formula import ARROW, parse
from app.model.parameter import read_sections
from app.model.refusal import REFUSALS, Refusal, nearest

Letters: TypeAlias = str
"""One of `LETTERS`, or the text of a file of one's own letters."""

LETTERS: tuple[Letters, ...] = ("own", "000", "001", "002", "003", "004")
"""The program's own (axes as in lecture 004, planes as in 003), and those of five lectures."""
LONGEST_FILE = 10_000  # most characters of a file of letters

SHEARED, FROM_SHEARED = "sheared_from_view", "clip_from_sheared"
"""Lecture 002's steps of an oblique or off-axis lens: H first."""

_PAGE = read_sections(Path(__file__).with_name("content") / "letters.md")
_TILES = {name: text.split() for name, text in _PAGE["tiles"].named.items()}
_OURS = _PAGE["own"].named | {
    f"{stem}{n}_{part}": f"{letter}_{n}{part}"
    for stem, letter, *parts in _TILES.values()
    for n in ("", *range(2, MOST_TILES + 1))
    for part in parts
}
_PARAMETERS = {name: text.split() for name, text in _PAGE["parameters"].named.items()}
"""What a file calls the parameters, and our own letters for them."""
_KNOWN: dict[str, Sequence[str]] = {
    "": ("base",),
    "parameters": (*_PARAMETERS, *_TILES),
    "vectors": ("eye", "target", "up", "u", "v", "n"),
    "matrices": _PAGE["matrices"].items,
}
"""The names that each section of a file may have; before the first section, the lecture."""
_LONGEST = 12
_GREEK = "".join(formula_text.GREEK)
_A_LETTER = re.compile(rf"(?:[A-Za-z]+|[{_GREEK}])[0-9]*(?:_[A-Za-z0-9]+)?")
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
        of_lecture, named = _PAGE[letters], _PAGE[f"{letters}, matrices"]
        return Lettering(letters, _OURS | of_lecture.named, named.named)
    is_text = isinstance(letters, str) and not {"=", "\n"}.isdisjoint(letters)
    if not is_text or len(letters) > LONGEST_FILE:
        raise Refusal(
            "letters", letters, REFUSALS["some-letters"], ", ".join(LETTERS), LONGEST_FILE
        )
    given = _sections(letters)
    base, symbols, matrices = lettering(given[""].get("base", "own"))
    symbols = {**symbols}
    for name, letter in given["parameters"].items():
        symbols |= _of_parameter(name, letter, base)
    for name, letter in given["vectors"].items():
        symbols |= _of_vector(name, letter)
    return Lettering(base, symbols, {**matrices, **given["matrices"]})


def _sections(text: str) -> dict[str, dict[str, str]]:
    given: dict[str, dict[str, str]] = {section: {} for section in _KNOWN}
    section, places = "", dict[tuple[str, str], str]()
    for number, line in enumerate(text.splitlines(), 1):
        place, match = f"letters, line {number}", _LINE.fullmatch(line.strip())
        if match is None:
            raise Refusal(place, line.strip(), REFUSALS["a-line"])
        section, name = match["section"] or section, match["name"]
        if section not in _KNOWN:
            raise Refusal(place, section, REFUSALS["not-known"], nearest(section, _KNOWN))
        if name is None:
            continue
        if name not in _KNOWN[section]:
            raise Refusal(place, name, REFUSALS["not-known"], nearest(name, _KNOWN[section]))
        if name in given[section]:
            raise Refusal(place, name, REFUSALS["twice"])
        letter, places[section, name] = match["letter"], f"{place}: {name}"
        if not section and letter not in LETTERS:
            raise Refusal(f"{place}: {name}", letter, REFUSALS["one-of"], ", ".join(LETTERS))
        if section and (len(letter) > _LONGEST or not _A_LETTER.fullmatch(letter)):
            raise Refusal(f"{place}: {name}", letter, REFUSALS["a-letter"], _GREEK, _LONGEST)
        given[section][name] = letter
    base, symbols, matrices = lettering(given[""].get("base", "own"))
    of_lecture = {
        "parameters": {name: symbols.get(ours[0], ours[0]) for name, ours in _PARAMETERS.items()
                       if base == "003" or name != "focal"},
        "vectors": {name: its for name, its in _frame(symbols).items() if name != "e"},
        "matrices": matrices,
    }  # fmt: skip
    for (section, name), place in places.items():
        held = {**of_lecture.get(section, {}), **given[section]}
        for other in held:
            if other != name and held[other] == held[name]:
                raise Refusal(place, held[name], REFUSALS["once"], other)
    return given


def base_of(letters: Letters) -> Letters:
    """Return the lecture of letters, which a file may have changed."""
    return lettering(letters).base


def _of_parameter(name: str, letter: str, base: Letters) -> dict[str, str]:
    if name in _TILES:  # t_x, and t_2x of the second one
        tile = re.compile(rf"{_TILES[name][0]}\d*_")
        return {
            ours: _component(letter, its.partition("_")[2])
            for ours, its in _OURS.items() if tile.match(ours)
        }  # fmt: skip
    minus = "\u2212" if base == "002" else ""  # its planes are at negative z
    return {ours: f"{minus * ours.endswith('_distance')}{letter}" for ours in _PARAMETERS[name]}


def _of_vector(name: str, letter: str) -> dict[str, str]:
    arrow = letter if "_" in letter else f"{letter}{ARROW}"
    if name in ("target", "up"):
        return {name: arrow, f"{name}_point": letter}
    return {f"{name}_{x}": _component(letter, x) for x in "xyz"} | (
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
