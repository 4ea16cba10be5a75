"""Prepare a lesson's text: Markdown as HTML without links or scripts, TeX as outlines."""

from __future__ import annotations

import html
import logging
import re
import threading
from collections.abc import Callable, Iterator
from functools import cache, lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from app.model.formula import ARROW
from app.model.limits import Array

if TYPE_CHECKING:
    from markdown_it import MarkdownIt
    from markdown_it.rules_inline import StateInline

FORMULA, DISPLAYED = "\ue000", "\ue001"
"""Placeholders in the HTML: for a formula in a line, and for one on a line of its own."""
FONT = "stix"
"""A font of mathtext that goes with any text."""
DEEPEST = 12
"""Most levels of braces in a formula: each needs many nested Python calls."""
WIDEST = 400
"""Largest width of a formula, in em."""
_EM = 100.0
_ONE_READER = threading.RLock()
"""matplotlib has one parser of formulas, and a lesson is checked beside the window's thread."""
_SCRIPTS = re.compile(r"([_^]?\{|\}|\\frac)")
_BREAK = re.compile(r"(\\q?quad(?![a-zA-Z])|[{}])")
_ALONE = re.compile(rf"<p>((?:[{FORMULA}{DISPLAYED}]\s*)+)</p>")
_ROW = re.compile(rf"((?:{DISPLAYED}\s*)+[.,;:]?)")
_MINUS = re.compile(r"(?<![\w.)\]])-(?=\d)")
_NO_HEAD = re.compile(r"<thead>\s*<tr>(\s*<th[^>]*></th>)+\s*</tr>\s*</thead>\s*")


MATH = re.compile(r"(\$\$?)(?=\S)([^$\n]{1,400}?)(?<=\S)\1")


@cache
def markdown() -> MarkdownIt:
    """Return the Markdown parser, which treats links and HTML as plain text.

    A line ``---`` is always a rule, never the line under a title. Formulas between dollars are
    tokens ``math`` (``markup`` is ``$`` or ``$$``) whose content is not read as Markdown.
    """
    from markdown_it import MarkdownIt

    reader = MarkdownIt("commonmark", {"html": False}).enable("table")
    reader.disable(["lheading", "html_block", "html_inline", "image", "link", "autolink"])
    reader.disable("reference")
    reader.inline.ruler.before("escape", "math", _math)
    return reader


def _math(state: StateInline, silent: bool) -> bool:
    match = MATH.match(state.src, state.pos)
    if match is None:
        return False
    if not silent:
        token = state.push("math", "", 0)
        token.content, token.markup = match[2], match[1]
    state.pos = match.end()
    return True


def formulas_in(text: str) -> list[str]:
    tokens = markdown().parse(text)
    return [
        part.content for token in tokens for part in token.children or () if part.type == "math"
    ]


class Outline(NamedTuple):
    """A formula's outlines in em, from its place on the line, y upwards.

    `ascent` and `descent` are its extent above and below the line; `vertices` have shape (n, 2);
    `codes` are those of `matplotlib.path.Path`. `letters` has the names of the italic letters,
    ``y_p``, ``P'`` or ``u`` with its arrow, each with its range of the vertices, in their order.
    """

    width: float
    ascent: float
    descent: float
    vertices: Array
    codes: Array
    letters: tuple[tuple[str, int, int], ...] = ()


def mathtext(tex: str) -> str:
    """Return a formula as matplotlib reads it.

    A prime is a sign of its own: it is high enough. A minus after a comma is one, too.
    """
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
        return _read(tex)


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
    return Outline(
        width / _EM,
        (height - descent) / _EM,
        descent / _EM,
        np.reshape(np.asarray(vertices, dtype=np.float64), (-1, 2)) / _EM,
        np.asarray(codes),
        tuple(_letters(reader, font, text)),
    )


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


def html_of(text: str) -> tuple[str, tuple[str, ...]]:
    """Return a text as HTML, with placeholders for the formulas, and the TeX of the formulas.

    A formula between double dollars stands on its own line. A formula may be broken at a
    ``\\quad``: then it counts as several. A table without headings, such as a matrix, has no
    heading row.
    """
    formulas: list[str] = []

    def math(tokens: Any, place: int, _options: Any, _environment: Any) -> str:
        pieces = _pieces(tokens[place].content, tokens[place].markup == "$$")
        formulas.extend(pieces)
        return " ".join((DISPLAYED if tokens[place].markup == "$$" else FORMULA) for _ in pieces)

    reader = markdown()
    reader.add_render_rule("math", lambda _self, *given: math(*given))
    reader.add_render_rule("text", lambda _self, tokens, place, *_: _words(tokens[place].content))
    text = re.sub(f"[{FORMULA}{DISPLAYED}]", "\ufffd", text)
    whole = _parted(_NO_HEAD.sub("", str(reader.render(text))))
    return _ALONE.sub(r'<p align="center">\1</p>', whole.strip()), tuple(formulas)


def _words(text: str) -> str:
    """A text's words as HTML; a hyphen before a number is a minus."""
    return html.escape(_MINUS.sub("\N{MINUS SIGN}", text))


def _parted(whole: str) -> str:
    """Give the displayed formulas of each paragraph lines of their own."""
    parted, *paragraphs = whole.split("<p>")
    for paragraph in paragraphs:
        inside, end, behind = paragraph.partition("</p>")
        is_whole = DISPLAYED not in inside
        for part in [inside] if is_whole else filter(None, map(str.strip, _ROW.split(inside))):
            align = ' align="center"' * (DISPLAYED in part)
            parted += f"<p{align}>{part}{end}"
        parted += behind
    return parted


def readable(tex: str) -> str:
    """Return a formula whose fractions have letters of full size, unless they are scripts."""
    parts, small = list[str](), [False]
    for part in _SCRIPTS.split(tex):
        if part.endswith("{"):
            small.append(small[-1] or len(part) > 1)
        elif part == "}" and len(small) > 1:
            small.pop()
        parts.append("\\dfrac" if part == "\\frac" and not small[-1] else part)
    return "".join(parts)


def _pieces(tex: str, is_displayed: bool) -> list[str]:
    """Split a formula at its wide spaces outside braces; fractions of a displayed one are large."""
    pieces, depth = [""], 0
    for part in _BREAK.split(tex):
        if part in ("\\quad", "\\qquad") and not depth:
            pieces.append("")
        else:
            if is_displayed and not depth:
                part = part.replace("\\frac", "\\dfrac")
            depth += (part == "{") - (part == "}")
            pieces[-1] += part
    return [piece.strip() for piece in pieces if piece.strip()]


def spoken_text(text: str) -> str:
    """Return a text without markup, with formulas in words, for a screen reader.

    ``A vector $\\vec{u}$`` is "A vector u": the text has said what it is.
    """
    return re.sub(r"\b(vector) vector\b", r"\1", plain_of(text, spoken_tex), flags=re.IGNORECASE)


_WORDS = {
    "cdot": "times", "times": "times", "to": "to", "pm": "plus or minus", "leq": "at most",
    "geq": "at least", "neq": "is not", "approx": "is about", "infty": "infinity", "varphi": "phi",
    "sum": "sum of", "quad": "", "qquad": "", "left": "", "right": "", ",": "", " ": "",
}  # fmt: skip
_SPOKEN = {"=": "equals", "+": "plus", "-": "minus", "/": "over", "'": "prime", "\u00b0": "degrees"}
_OF_BRACES = (
    (r"\\d?frac\{([^{}]*)\}\{([^{}]*)\}", r" (\1) / (\2) "),
    (r"\^\{?\\circ\}?", " degrees "),
    (r"\\(?:math|text)[a-z]*\{([^{}]*)\}", r"\1"),
    (r"\\vec\s*(?:\{([^{}]*)\}|(\w))", r" vector \1\2 "),
    (r"\\sqrt\{([^{}]*)\}", r" root of (\1) "),
    (r"_(?:\{([^{}]*)\}|(\w))", r" \1\2 "),
    (r"\^(?:\{([^{}]*)\}|(\w))", r" to the power \1\2 "),
)


@lru_cache(maxsize=1024)
def spoken_tex(tex: str) -> str:
    """Return a formula in words: ``M_{pp} M_{persp}`` is "M pp times M persp"."""
    before = ""
    while tex != before:
        before = tex
        for pattern, words in _OF_BRACES:
            tex = re.sub(pattern, words, tex)
    tex = re.sub(r"\\([a-zA-Z]+|.)", lambda match: f" {_WORDS.get(match[1], match[1])} ", tex)
    tex = re.sub(r"\((\s*\w+\s*)\)(?=\s*/)|(?<=/)\s*\((\s*\w+\s*)\)", r" \1\2 ", tex)
    tex = re.sub(r"\b([A-Z](?: [a-z0-9]+)?) (?=[A-Z]\b)", r"\1 times ", " ".join(tex.split()))
    tex = re.sub("[=+\\-/'\u00b0]", lambda match: f" {_SPOKEN[match[0]]} ", tex)
    return " ".join(tex.split()).replace(" ,", ",").replace("( ", "(").replace(" )", ")")


def plain_of(text: str, formula: Callable[[str], str] = str) -> str:
    """Return a text without markup; formulas are TeX, or what `formula` makes of it."""
    words = []
    for token in markdown().parse(text):
        for part in token.children or ():
            if part.type in ("softbreak", "hardbreak"):
                words.append(" ")
            else:
                words.append(formula(part.content) if part.type == "math" else part.content)
        if token.type in ("fence", "code_block"):
            words.append(token.content)
        if token.nesting < 0 and not token.hidden:
            words.append(" ")
    return " ".join("".join(words).split())


_LOWERED = str.maketrans("0123456789aehijklmnoprstuvx", "₀₁₂₃₄₅₆₇₈₉ₐₑₕᵢⱼₖₗₘₙₒₚᵣₛₜᵤᵥₓ")


_SIGNS = {
    "alpha": "\u03b1", "beta": "β", "theta": "θ", "lambda": "λ", "varphi": "φ", "psi": "ψ",
    "cdot": "·", "times": "×",
}  # fmt: skip


def in_line(text: str) -> str:
    """Return a text without markup for a list or a button, with signs for what has one."""
    text = _MINUS.sub("\N{MINUS SIGN}", plain_of(text))
    text = re.sub(r"\\([a-z]+)", lambda match: _SIGNS.get(match[1], match[0]), text)
    return re.sub(r"_\{?(\w+)\}?", lambda match: match[1].translate(_LOWERED), text)


def escaped(text: str) -> str:
    """Escape a text so that Markdown finds no markup in it."""
    return re.sub(r"([\\`*_{}\[\]<>#$|])", r"\\\1", text)
