"""Prepare a lesson's text: Markdown as HTML without links or scripts, TeX as outlines."""

import html
import re
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING, Any

from app.languages import cached, translate, with_comma

if TYPE_CHECKING:
    from markdown_it import MarkdownIt
    from markdown_it.rules_inline import StateInline

FORMULA, DISPLAYED = "\ue000", "\ue001"
"""Placeholders in the HTML: for a formula in a line, and for one on a line of its own."""
_SCRIPTS = re.compile(r"([_^]?\{|\}|\\frac)")
_BREAK = re.compile(r"(\\q?quad(?![a-zA-Z])|[{}])")
_ALONE = re.compile(rf"<p>((?:[{FORMULA}{DISPLAYED}]\s*)+)</p>")
_ROW = re.compile(rf"((?:{DISPLAYED}\s*)+[.,;:]?)")
_MINUS = re.compile(r"(?<![\w.)\]])-(?=\d)")
_NO_HEAD = re.compile(r"<thead>\s*<tr>(\s*<th[^>]*></th>)+\s*</tr>\s*</thead>\s*")
MATH = re.compile(r"(\$\$?)(?=\S)([^$\n]{1,400}?)(?<=\S)\1")


@cache
def markdown() -> "MarkdownIt":
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


def _math(state: "StateInline", silent: bool) -> bool:
    match = MATH.match(state.src, state.pos)
    if match is None:
        return False
    if not silent:
        token = state.push("math", "", 0)
        token.content, token.markup = match[2], match[1]
    state.pos = match.end()
    return True


def formulas_in(text: str) -> list[str]:
    parts = (part for token in markdown().parse(text) for part in token.children or ())
    return [part.content for part in parts if part.type == "math"]


@cached
def html_of(text: str) -> tuple[str, tuple[str, ...]]:
    """Return a text as HTML, with placeholders for the formulas, and the TeX of the formulas.

    A formula between double dollars stands on its own line. A formula may be broken at a
    ``\\quad``: then it counts as several. A table without headings, such as a matrix, has no
    heading row.
    """
    formulas: list[str] = []

    def math(tokens: Any, place: int, _options: Any, _environment: Any) -> str:
        tex = with_comma(tokens[place].content, in_tex=True)
        pieces = _pieces(tex, tokens[place].markup == "$$")
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
    return html.escape(with_comma(_MINUS.sub("\N{MINUS SIGN}", text)))


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


@cached
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
SPOKEN = {*_WORDS.values(), *_SPOKEN.values(), "vector", "root of", "to the power"} - {""}
_SPOKEN_WORDS = re.compile(rf"\b({'|'.join(sorted(SPOKEN, key=len, reverse=True))})\b")
_OF_BRACES = (
    (r"\\d?frac\{([^{}]*)\}\{([^{}]*)\}", r" (\1) / (\2) "),
    (r"\^\{?\\circ\}?", " degrees "),
    (r"\\(?:math|text)[a-z]*\{([^{}]*)\}", r"\1"),
    (r"\\vec\s*(?:\{([^{}]*)\}|(\w))", r" vector \1\2 "),
    (r"\\sqrt\{([^{}]*)\}", r" root of (\1) "),
    (r"_(?:\{([^{}]*)\}|(\w))", r" \1\2 "),
    (r"\^(?:\{([^{}]*)\}|(\w))", r" to the power \1\2 "),
)


@cached
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
    tex = _SPOKEN_WORDS.sub(lambda match: translate(match[0], "Spoken"), with_comma(tex))
    return " ".join(tex.split()).replace(" ,", ",").replace("( ", "(").replace(" )", ")")


def plain_of(text: str, formula: Callable[[str], str] = str) -> str:
    """Return a text without markup; formulas are TeX, or what `formula` makes of it."""
    words = []
    for token in markdown().parse(text):
        for part in token.children or ():
            if part.type in ("softbreak", "hardbreak"):
                words.append(" ")
            else:
                is_text = part.type != "math"
                words.append(with_comma(part.content) if is_text else formula(part.content))
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


@cached
def in_line(text: str) -> str:
    """Return a text without markup for a list or a button, with signs for what has one."""
    text = _MINUS.sub("−", plain_of(text, lambda tex: with_comma(re.sub(r"\\[ ,;]", " ", tex))))
    text = re.sub(r"\\([a-z]+)", lambda match: _SIGNS.get(match[1], match[0]), text)
    return re.sub(r"_\{?(\w+)\}?", lambda match: match[1].translate(_LOWERED), text)


def escaped(text: str) -> str:
    """Escape a text so that Markdown finds no markup in it."""
    return re.sub(r"([\\`*_{}\[\]<>#$|])", r"\\\1", text)
