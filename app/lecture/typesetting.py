"""Typeset mathematics: TeX as outlines, and the pieces of a formula that is written as text.

matplotlib's mathtext sets the letters in STIX; a word is set in DejaVu Sans. Qt's painter, Agg for
VTK, SVG and PDF draw the same outlines. A formula as text is ``y_p`` with a subscript, ``R^T`` with
a superscript, `ARROW` after the letter of a vector, and ``'`` for a prime. A word of several
letters is upright. What stands between dollar signs is TeX. mathtext takes a millisecond for a
formula, so a running number is set sign by sign: each sign is read only once.
"""

import importlib.util
import logging
import pathlib
import re
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.model.formula import ARROW
from app.model.formula_text import GREEK
from app.model.limits import Array

FONT = "stix"  # a font of mathtext that goes with any text
DEEPEST = 12  # most levels of braces in a formula: each needs many nested Python calls
ALONE = 1.3  # size of a label that is only a letter, relative to a word
AMONG_WORDS = 1.12  # size of a letter beside words: STIX looks smaller than DejaVu Sans
WIDEST = 400  # largest width of a formula, in em
_EM = 100.0
SET: "dict[str, Outline]" = {}
"""What has been set: formulas by their TeX, words behind a line feed. At most `MOST_SET`."""
MOST_SET = 400
_ONE_READER = threading.RLock()
"""matplotlib has one parser of formulas, and a lesson is checked beside the window's thread."""
_LOWERED = re.compile("[₀-₉]+")
_LEVEL = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_LEANS_EM = 0.1  # a letter leans over a space if its ink is so far beside its width
_BEFORE_FUNCTION = re.compile(r"(?<=[\w)}])(?<!\\cdot) *\\(?=(?:tan|cot|sin|cos|log)(?![a-z]))")
FUNCTIONS = frozenset(("tan", "sin", "cos", "log"))
_LEANING = re.compile(r"(?<![\\A-Za-z])f\s*(?=\\vec|\\,\s*\\)")  # over a thin space, or an arrow
_TOKEN = re.compile(
    r"\$(?P<tex>[^$]+)\$"
    r"|(?!.\u00a0[^\W\d_]{2})"  # in a language a word of one letter is tied to the next
    rf"(?P<letter>(?<![^\W_])[A-Za-z\u0391-\u03c9](?![^\W\d_]){ARROW}?|[^\W\d_]+(?=[_{ARROW}]))"
    r"(?P<sub>(?:_(?:\{[^}]*\}|[^\W_]+(?:\u2192[^\W_]+)?))?)"
    rf"(?P<arrow>{ARROW}?)(?P<prime>['\u2032]*)"
    r"|\^(?P<power>[-\u2212]?[^\W_]+)"
    r"|(?P<word>(?:[^\W\d_]\u00a0)?[^\W\d_]{2,})"
    r"|(?P<sign>.)",
    re.DOTALL,
)


@dataclass(frozen=True, eq=False)
class Outline:
    """The outlines of a formula or a word in em, from its place on the line, y upwards.

    `ascent` and `descent` are its extent above and below the line; `vertices` have shape (n, 2);
    `codes` are those of `matplotlib.path.Path`. `letters` has the names of the italic letters,
    ``y_p``, ``P'`` or ``u`` with its arrow, each with its range of the vertices, in their order.
    """

    width: float
    ascent: float
    descent: float
    vertices: Array
    codes: NDArray[Any]
    letters: tuple[tuple[str, int, int], ...] = ()

    @cached_property
    def box(self) -> tuple[float, float, float, float]:
        """Left, low, right and high of its ink."""
        (left, low), (right, high) = self.vertices.min(axis=0), self.vertices.max(axis=0)
        return float(left), float(low), float(right), float(high)


class LineLayout(NamedTuple):
    """Pieces that are set in one line, in words' em; `box` is where there is ink, y upwards."""

    pieces: tuple[tuple[str, bool, float, float], ...]  # each with its size and its left end
    box: tuple[float, float, float, float]  # left, low, right, high
    width: float


def mathtext(tex: str) -> str:
    """Return a formula as matplotlib reads it.

    A prime is a sign of its own: it is high enough. A minus after a comma is one, too. A function
    needs room before it, over which f does not lean.
    """
    tex = _LEANING.sub(r"f\\,", _BEFORE_FUNCTION.sub(r"\\,\\", tex))
    return "$" + re.sub(r"([,;][\s\\]*|\\approx\s+)-", r"\1{-}", tex.replace("'", "\u2032")) + "$"


@lru_cache(maxsize=1024)
def outline(tex: str) -> Outline:
    """Return a formula's outlines; a `ValueError` says why it cannot be drawn."""
    depth = 0
    for opened, closed in re.findall(r"(?<!\\)(?:(\{|\\left\b)|(\}|\\right\b))", tex):
        depth += bool(opened) - bool(closed)
        if depth > DEEPEST:
            raise ValueError(f"has more than {DEEPEST} levels of braces")
    with _ONE_READER:
        return _set_once(tex, lambda: _read(tex))


@contextmanager
def as_shipped() -> Iterator[None]:
    """Let matplotlib draw by its own settings: the current folder may have a matplotlibrc."""
    from matplotlib import rc_context, rcParams, rcParamsDefault

    with rc_context():
        # `dict`, because rcParams checks each value anew, and loads a backend that is asked for.
        dict.update(rcParams, {**rcParamsDefault, "backend": dict.get(rcParams, "backend")})
        yield


def _set_once(key: str, make: Callable[[], Outline]) -> Outline:
    made = SET[key] if key in SET else as_shipped()(make)()
    if len(SET) < MOST_SET:
        SET[key] = made
    return made


def _read(tex: str) -> Outline:
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextToPath

    logging.getLogger("matplotlib.mathtext").addFilter(_refuse)
    reader: Any = TextToPath()
    font: Any = FontProperties(size=_EM, math_fontfamily=FONT)
    text = mathtext(tex)
    width, height, descent = reader.get_text_width_height_descent(text, font, ismath=True)
    if not 0.0 <= width <= WIDEST * _EM:
        raise ValueError(f"is less than 0 or more than {WIDEST} letters wide")
    vertices, codes = reader.get_text_path(font, text, ismath=True)
    points = np.reshape(np.asarray(vertices, dtype=np.float64), (-1, 2)) / _EM
    ascent, descent = (height - descent) / _EM, descent / _EM
    letters = tuple(_letters(reader, font, text))
    return Outline(width / _EM, ascent, descent, points, np.asarray(codes), letters)


def _letters(reader: Any, font: Any, text: str) -> Iterator[tuple[str, int, int]]:
    """Yield the letters of a formula with their subscripts, as they follow in its outlines."""
    shapes, outlines, _ = reader.get_glyphs_mathtext(font, text)
    glyphs = reader.mathtext_parser.parse(text, reader.DPI, font).glyphs
    is_short = iter([len(part) < 2 for part in re.findall(r"\\vec\s*(?:\{([a-zA-Z]*)\})?", text)])
    name, arrow, begin, end, size, line = "", "", 0, 0, 0.0, 0.0
    for (face, points, code, *_, y), (shape, *_) in zip(glyphs, shapes, strict=True):
        sign, first = chr(code), end
        is_low = points < size and y < line and sign.isalnum()
        if name and is_low:
            name += sign if "_" in name else f"_{sign}"
        elif name and sign == "\u2032":
            name += "'"
        else:
            if name:
                yield name + arrow, begin, end
            is_italic = sign.isalpha() and face.postscript_name.endswith("Italic")
            if not (arrow and not name and is_italic):  # an accent comes before its letter
                begin = first
            arrow = arrow if is_italic and not name else ""
            if sign == ARROW and next(is_short, True):  # not over a word
                arrow = ARROW
            name = sign if is_italic else ""
            size, line = points, y
        end += len(outlines[shape][1])
    if name:
        yield name + arrow, begin, end


def _refuse(warning: logging.LogRecord) -> bool:
    """Refuse a character that mathtext would replace with only a warning."""
    if warning.levelno >= logging.WARNING:
        raise ValueError("has a character that the formulas' font lacks")
    return True


def pieces_of(text: str) -> list[tuple[str, bool]]:
    """Split a label into words and formulas, each with whether it is TeX."""
    pieces: list[tuple[str, bool]] = []
    text = _LOWERED.sub(lambda match: "_" + match[0].translate(_LEVEL), text)
    for token in _TOKEN.finditer(text):
        if token["tex"]:
            pieces.append((token["tex"], True))
        elif token["letter"]:
            tex = _tex(token["letter"] + token["arrow"], token["sub"])
            pieces.append((tex + token["prime"], True))
        elif token["power"]:
            pieces.append((rf"{{}}^{{{token['power']}}}", True))
        elif token["word"] in FUNCTIONS:
            pieces.append((rf"\{token['word']} ", True))
        elif token["word"] == "fov":  # as in fov_x
            pieces.append((_tex("fov", ""), True))
        else:
            pieces.append((token["word"] or token["sign"], False))
    return pieces


def _tex(letter: str, sub: str) -> str:
    name = letter.removesuffix(ARROW)
    base = rf"\mathrm{{{name}}}" if len(name) > 1 else name
    base = rf"\{GREEK[name]} " if name in GREEK else base
    if name != letter:
        base = rf"\vec{{{base}}}"
    below = sub[1:].strip("{}")
    if len(below) > 1 and not below.isdigit():
        below = rf"\mathrm{{{below}}}"
    return f"{base}_{{{below}}}" if below else base


def _drawable(piece: str, is_tex: bool) -> tuple[str, bool]:
    try:
        if is_tex:
            outline(piece)
    except ValueError:
        return f"${piece}$", False
    return piece, is_tex


@lru_cache(maxsize=1024)
def line_of(
    text: str, plain: bool = False, one_size: bool = False, *, formula: float = 0.0
) -> LineLayout:
    """Set a text in one line. TeX that cannot be drawn is shown as it is typed.

    In a formula, all letters have the size `formula`. In a label (0.0), words have the size 1, and
    letters are larger, but in `one_size`.
    """
    pieces = [(text, False)] if plain else pieces_of(text)
    if formula:
        is_word = [not is_tex and len(piece) > 1 for piece, is_tex in pieces]
        as_tex = [(rf"\mathrm{{{piece}}}", True) for piece, _ in pieces]
        pieces = [t if word else p for p, t, word in zip(pieces, as_tex, is_word, strict=True)]
    pieces = [_drawable(*piece) for piece in pieces]
    has_words = any(len(piece) > 1 and not is_tex for piece, is_tex in pieces)
    larger = 1.0 if plain or one_size else formula or (AMONG_WORDS if has_words else ALONE)
    placed, boxes, x, over = [], [], 0.0, 0.0
    for i, (piece, is_tex) in enumerate(pieces):
        size = larger if formula or is_tex or len(piece) == 1 else 1.0
        drawn = piece_of(piece, is_tex)
        left, low, right, high = drawn.box if len(drawn.vertices) else (0.0,) * 4
        if piece == " ":
            x += over
        elif left < -_LEANS_EM and i and pieces[i - 1][0] == " ":
            x -= left * size
        over = (right - drawn.width) * size if right > drawn.width + _LEANS_EM else 0.0
        placed.append((piece, is_tex, size, x))
        if len(drawn.vertices):
            boxes.append((x + size * left, size * low, x + size * right, size * high))
        x += drawn.width * size
    lefts, lows, rights, highs = zip(*boxes or [(0.0, 0.0, 0.0, 0.0)], strict=True)
    return LineLayout(tuple(placed), (min(lefts), min(lows), max(rights), max(highs)), x)


def is_set_in_words(piece: str) -> bool:
    """Whether a piece that is no formula is set in the font of words."""
    return any(map(str.isalpha, piece)) or not _signs("STIXGeneral").issuperset(piece)


@lru_cache(maxsize=1024)
def piece_of(text: str, is_tex: bool) -> Outline:
    return outline(text) if is_tex else _set_once(f"\n{text}", lambda: _words(text))


def _words(text: str) -> Outline:
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextToPath

    reader: Any = TextToPath()
    name = "DejaVuSans" if is_set_in_words(text) else "STIXGeneral"
    text = "".join(sign if sign in _signs(name) else "\ufffd" for sign in text)
    font: Any = FontProperties(fname=font_file(name), size=_EM)
    width, height, descent = reader.get_text_width_height_descent(text, font, ismath=False)
    vertices, codes = reader.get_text_path(font, text, ismath=False)
    points = np.reshape(np.asarray(vertices, dtype=np.float64), (-1, 2)) / _EM
    ascent, descent = (height - descent) / _EM, descent / _EM
    return Outline(width / _EM, ascent, descent, points, np.asarray(codes, dtype=np.uint8))


@cache
def _signs(font: str) -> frozenset[str]:
    """The characters that a font can show."""
    from matplotlib.font_manager import get_font

    return frozenset(map(chr, get_font(font_file(font)).get_charmap()))


@cache
def font_file(name: str) -> str:
    """Return the path of a font that comes with matplotlib, a dependency of pyvista.

    VTK's built-in font has no Cyrillic, and a system font would make figures differ between
    machines.
    """
    spec = importlib.util.find_spec("matplotlib")
    if spec is None or not spec.submodule_search_locations:
        raise ImportError("matplotlib, which brings the labels' fonts, is not installed")
    folder = pathlib.Path(spec.submodule_search_locations[0]) / "mpl-data" / "fonts" / "ttf"
    return str(folder / f"{name}.ttf")
