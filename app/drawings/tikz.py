r"""Shapes as a TikZ picture, which a LaTeX document reads by ``\input``: its text is TeX's.

Nothing in a label or a title is a command: what is no known formula is escaped.
"""

import io
import math
import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import count, groupby

from PIL import Image

from app.document.lengths import DPI
from app.drawings.label import HALO_EM, HALO_OPACITY
from app.drawings.occlusion import Colour, Points
from app.drawings.style import hexadecimal, rgb
from app.drawings.svg import SEAM_PX, TEX, chained, kind_of, turned
from app.drawings.vectors import Area, Disc, LineShape, PixelShape, Shape, TextShape
from app.lecture.typesetting import FUNCTIONS
from app.model.formula_text import GREEK
from app.strangers import printable

LARGEST = 1_500_000  # most bytes of a file: pdfTeX's memory, with little else, ends at 2.2 MB
_BP_PER_PX = 72.0 / DPI
_PT_PER_BP = 72.27 / 72.0
_FONT_PT = 10.0  # of the font that is scaled: TeX's own smaller ones are wider than a label's place
_HALO = (
    r"\def\gap{\rlap{\kern.03em.}\rlap{\kern.03em\raise.3em\hbox{.}}}"
    r"\def\halo#1{}\ifnum0\ifdefined\XeTeXversion1\fi\ifdefined\outputmode\the\outputmode\fi"
    r"\ifdefined\pdfoutput\the\pdfoutput\fi>0 "
    rf"\def\halo{{\csname pgfsys@invoke\endcsname{{1 Tr 1 j {2.0 * HALO_EM * _FONT_PT:g} w}}}}\fi"
)
"""In PDF the contours of letters, and of dots in a space; elsewhere nothing could draw them."""
_HELD = 0xE000  # the first private letter, which stands for a formula
_MOST_POINTS = 500  # of a path, which TeX holds in its memory
_COMMANDS = "|".join((
    *GREEK.values(), *FUNCTIONS, "vec", "mathrm", "mathbf", "frac", "sqrt", "cdot", "times", "pm",
    "infty", "approx", "neq", "leq", "geq", "to", "dfrac", "left", "right", "leftarrow", "text",
    "cot", "varphi", "circ",
))  # fmt: skip
_FORMULA = re.compile(
    rf"(?:\\(?:{_COMMANDS})(?![a-zA-Z])|\\,|[a-zA-Z0-9_ +\-*/=<>()\[\].,:;|{{}}'\u2032]|\^(?!\^))*"
)
_NO_GAP = r"\nulldelimiterspace0pt"  # no space beside fractions, as in other formats
_NO_SPACE = re.compile(r"(?<! ) *\\, *(?=\(|\\(?:tan|cot|sin|cos)\b)")  # TeX makes its own
_CYRILLIC = re.compile("[\u0400-\u052f]")
_PLAIN = "0123456789+=/()[],."
_IN_MATH = {
    **{sign: sign for sign in _PLAIN},
    **{sign: rf"\{name} " for sign, name in GREEK.items()},
    "\u2212": "-", "\u2032": "'", "²": "^2", "°": r"^\circ ", "×": r"\times ", "·": r"\cdot ",
    "∞": r"\infty ", "→": r"\to ", "←": r"\leftarrow ", "↔": r"\leftrightarrow ", "±": r"\pm ",
    "≈": r"\approx ", "≠": r"\neq ", "≤": r"\leq ", "≥": r"\geq ", "<": "<", ">": ">", "%": r"\%",
    "|": "|", "½": r"{}^1\!/_2 ",
}  # fmt: skip
_IN_WORDS = {
    **{sign: f"${tex.strip()}$" for sign, tex in _IN_MATH.items() if sign not in _PLAIN},
    **{sign: rf"\{sign}" for sign in "{}$&#_%"},
    **{sign: rf"\char{ord(sign)}{{}}" for sign in "\"'`"},  # some packages make them commands
    **{sign: f"{sign}{{}}" for sign in "-,"},  # or two of them would be one sign
    "\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}",
    "\u2013": r"\textendash{}", "\u2014": r"\textemdash{}", "…": r"\dots{}",
}  # fmt: skip
_SPACED = re.compile(r"(?<=[=+/<>×·→←↔±≈≠≤≥,\u2212]) | (?=[=+/<>×·→←↔±≈≠≤≥\u2212])")
"""A space that TeX makes itself in a formula."""


def tikz(
    shapes: Sequence[Shape], size: tuple[float, float], title: str, text: str = "", name: str = "g"
) -> tuple[bytes, dict[str, bytes]]:
    """Return the file of a figure of a size in pixels, and the PNG files that it reads, by name.

    `text` is a description, which becomes a comment; `name` is the file's own, without its ending.
    """
    writer = _TikzWriter(size, name)
    box, lines = f"(0,0) rectangle ({_n(size[0])},{_n(size[1])});", list[str]()
    for _, part in groupby(shapes, key=lambda shape: isinstance(shape, TextShape)):
        drawn = [*part]
        texts = [each for each in drawn if isinstance(each, TextShape)]
        cut = [writer.text(each, is_halo=True) for each in texts]
        if not texts:
            cut = [line for _, each in groupby(drawn, kind_of) for line in writer.lines([*each])]
        lines += [rf"\begin{{scope}}\clip {box}", *cut, r"\end{scope}"]
        # TeX's letters may be higher than those at the edge.
        lines += [writer.text(each, is_halo=False) for each in texts]
    head = [
        *(f"% {printable(said)}" for said in (title, text) if said),
        r"% LaTeX reads it by \input; the preamble needs \usepackage{tikz}. A unit is 1/72 inch.",
        *writer.needed(
            "".join(each.written.text for each in shapes if isinstance(each, TextShape))
        ),
        r"\begin{tikzpicture}[x=1bp,y=1bp,line cap=round,line join=round,",
        *(f"  {style}/.style={{{options}}}," for options, style in writer.styles.items()),
        "]",
        *(rf"\definecolor{{{name}}}{{HTML}}{{{code}}}" for code, name in writer.colours.items()),
        _HALO,
        rf"\useasboundingbox {box}",
    ]
    return "\n".join([*head, *lines, r"\end{tikzpicture}%", ""]).encode(), writer.files


class _TikzWriter:
    """The commands of shapes, and the colours, styles and files that they use."""

    def __init__(self, size: tuple[float, float], name: str) -> None:
        self._high, self._name = size[1], name
        self.colours: dict[str, str] = {}
        self.styles: dict[str, str] = {}
        self.files: dict[str, bytes] = {}

    def needed(self, letters: str) -> Iterator[str]:
        """Yield what a document needs besides, as comments."""
        if _CYRILLIC.search(letters):
            yield (
                r"% Its Cyrillic letters need \usepackage[T2A]{fontenc}; in XeLaTeX and LuaLaTeX"
                " a font that has them."
            )
        if not {"đ", "Đ"}.isdisjoint(letters):
            yield r"% Its letter đ needs \usepackage[T1]{fontenc}."
        if self.files:
            yield (
                rf"% It reads {', '.join(self.files)} from the document's folder;"
                r" \graphicspath{{FOLDER/}} names another."
            )

    def lines(self, shapes: Sequence[Shape]) -> Iterator[str]:
        """Yield the commands for shapes of one kind."""
        first = shapes[0]
        if isinstance(first, Area):
            colour = self._colour(first.colour)
            seam = f",draw={colour},line width={_n(SEAM_PX)}bp" if first.opacity >= 1.0 else ""
            rings = [turned(r) for each in shapes if isinstance(each, Area) for r in each.rings]
            options = f"fill={colour}{seam}{_faint('fill', first.opacity)}"
            yield from self._paths(options, rings, "--cycle")
        elif isinstance(first, LineShape):
            dash = "" if first.dash is None else (
                ",line cap=butt,dash pattern=on {}bp off {}bp".format(*map(_n, first.dash))
            )  # fmt: skip
            options = f"draw={self._colour(first.colour)},line width={_n(first.width)}bp{dash}"
            chains = chained(each for each in shapes if isinstance(each, LineShape))
            yield from self._paths(options + _faint("draw", first.opacity), chains)
        elif isinstance(first, Disc):
            options = f"fill={self._colour(first.colour)}{_faint('fill', first.opacity)}"
            yield rf"\path[{options}] {self._at(first.centre)} circle[radius={_n(first.radius)}];"
        elif isinstance(first, PixelShape):
            yield self._picture(first)

    def _paths(self, options: str, paths: Sequence[Points], end: str = "") -> Iterator[str]:
        part, count = "", 0
        for points in paths:
            if count and count + len(points) > _MOST_POINTS:
                yield rf"\path[{options}]{part};"
                part, count = "", 0
            part += f" {'--'.join(map(self._at, points))}{end}"
            count += len(points)
        yield rf"\path[{options}]{part};"

    def _at(self, point: tuple[float, float]) -> str:
        return f"({_n(point[0])},{_n(self._high - point[1])})"

    def _colour(self, colour: Colour) -> str:
        code = hexadecimal(colour)[1:].upper()
        return self.colours.setdefault(code, f"c{len(self.colours) + 1}")

    def _picture(self, picture: PixelShape) -> str:
        buffer = io.BytesIO()
        Image.fromarray(picture.pixels).save(buffer, "PNG")
        name = f"{self._name}-pixels{len(self.files) + 1}.png"
        self.files[name] = buffer.getvalue()
        left, top, wide, high = picture.place
        return (
            rf"\node[anchor=north west,inner sep=0bp] at {self._at((left, top))}"
            rf" {{\includegraphics[width={_n(wide)}bp,height={_n(high)}bp]{{{name}}}}};"
        )

    def text(self, text: TextShape, *, is_halo: bool) -> str:
        """A label's letters, or their contours."""
        written, em = text.written, text.em
        said = _tex((piece, is_tex) for piece, is_tex, _, _ in written.pieces)
        if written.underlined:
            said = rf"\underline{{{said}}}"
        ends = [at + w * s for (_, _, s, at), w in zip(written.pieces, written.widths, strict=True)]
        # TeX's letters have another width: the label's anchor stays where it is.
        along = (written.anchor + 1) / 2.0 * max(ends, default=0.0) * em
        (x, y), (cos, sin) = text.place, (math.cos(written.turn), math.sin(written.turn))
        colour = written.halo if is_halo else written.colour
        options = f"{self._style(text)},text={self._colour(rgb(colour))}"
        options += {-1: ",anchor=base west", 1: ",anchor=base east"}.get(written.anchor, "")
        options += f",rotate={math.degrees(written.turn):.2f}" if written.turn else ""
        at = self._at((x + cos * along, y - sin * along))
        if not is_halo:
            return rf"\node[{options}] at {at} {{{said}}};"
        faint = _faint("text", HALO_OPACITY * written.opacity)
        said = re.sub(r"(?<!\\)\$[^$]*\$| ", lambda part: _filled(part[0]), said)
        return rf"\node[{options}{faint}] at {at} {{\halo{{{said}}}}};"

    def _style(self, text: TextShape) -> str:
        """The name of a label's style; its letters and words have one size, as in one font."""
        written = text.written
        size = min((size for _, _, size, _ in written.pieces), default=1.0)
        scale = size * text.em * _BP_PER_PX * _PT_PER_BP / _FONT_PT
        options = (
            rf"anchor=base,font=\fontsize{{{_FONT_PT:g}}}{{{_FONT_PT:g}}}\selectfont{_NO_GAP},"
            f"scale={scale:.4f},inner sep=0bp{_faint('text', written.opacity)}"
        )
        return self.styles.setdefault(options, f"t{len(self.styles) + 1}")


def _n(px: float) -> str:
    """A length in 1/72 inch."""
    text = f"{_BP_PER_PX * px:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _faint(what: str, opacity: float) -> str:
    return f",{what} opacity={opacity:.3g}" if opacity < 1.0 else ""


def _filled(part: str) -> str:
    """A formula with a halo in its spaces and above decimal signs, or a space with one."""
    if part == " ":
        return r"\gap{} "
    return re.sub(r"(?<=\d)(\.|\{,\})(?=\d)", r"\\gap\1", part.replace(r"\ ", r"\gap\ "))


def _tex(pieces: Iterable[tuple[str, bool]]) -> str:
    """The pieces of a label as words and formulas; numbers beside a letter are in its formula."""
    text = ""
    for is_math, group in groupby(pieces, key=lambda piece: _is_math(*piece)):
        parts = [*group]
        formulas = [_grouped(piece) for piece, is_tex in parts if is_tex]
        if not is_math:
            text += "".join(_in_words(*part) for part in parts)
            continue
        numbers = count()
        line = "".join(chr(_HELD + next(numbers)) if is_tex else piece for piece, is_tex in parts)
        bare = line.strip(" ")
        if not re.search(rf"[{chr(_HELD)}-\uf8ff0-9=+<>%|\u00b0-\uffff]", bare):
            text += "".join(_IN_WORDS.get(sign, sign) for sign in line)
            continue
        before, after = line[: line.index(bare)], line[line.index(bare) + len(bare) :]
        signs = {chr(_HELD + number): tex for number, tex in enumerate(formulas)}
        signs |= {" ": r"\ ", **_IN_MATH}
        tex = "".join(signs[sign] for sign in _SPACED.sub("", bare))
        text += re.sub(r"(?<=\d),(?=\d)", "{,}", f"{before}${tex.strip()}${after}")
    return text


def _grouped(tex: str) -> str:
    tex = tex.strip().replace("\u2032", "'").replace(r"\dfrac", r"\displaystyle\frac")
    tex = _NO_SPACE.sub("", tex.replace(r"\text", r"\mathrm"))  # which need no package
    return tex if len(tex) == 1 else f"{{{tex}}}"


def _is_math(piece: str, is_tex: bool) -> bool:
    if is_tex:
        return _FORMULA.fullmatch(piece) is not None
    return all(sign in _IN_MATH or sign == " " for sign in piece)


def _in_words(piece: str, is_tex: bool) -> str:
    match = TEX.fullmatch(piece) if is_tex else None
    base = None if match is None else match["word"] or match["letter"]
    if match is not None and base:  # in another script, which formulas have not
        low = _in_words(match["sub"] or match["low"] or "", False)
        return rf"{_in_words(base, False)}\textsubscript{{{low}}}{match['prime']}"
    text = printable(f"${piece}$" if is_tex else piece)
    return "".join(_IN_WORDS.get(sign, sign) for sign in text)
