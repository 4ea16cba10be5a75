"""Shapes as an SVG file: text stays text, and nothing refers to another file."""

import base64
import io
import math
import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from xml.sax.saxutils import escape, quoteattr

from PIL import Image

from app.document.lengths import PX_PER
from app.drawings.label import FILLED, FILLED_AT, FILLED_EM, HALO_EM, HALO_OPACITY, UNDER_EM
from app.drawings.occlusion import Points
from app.drawings.style import hexadecimal
from app.drawings.vectors import Area, Disc, LineShape, PixelShape, Shape, TextShape
from app.lecture.typesetting import FUNCTIONS, is_set_in_words, outline
from app.model.formula_text import GREEK

WORDS_FONT = "DejaVu Sans, Verdana, sans-serif"
OF_ALL = 'role="img" fill="none" stroke-linecap="round" stroke-linejoin="round"'
"""The attributes that elements inherit, here and on a page."""
SIGNS_FONT = "STIXGeneral, STIX Two Text, Times New Roman, serif"
SEAM_PX = 0.4  # of an opaque face's own colour round it: no seam shows between neighbours
_SIGNS = f' font-family="{SIGNS_FONT}"'
_LOWER_EM, _LOWERED = 0.22, 0.7  # a subscript: how far below the line, and its size
TEX = re.compile(
    r"(?P<arrow>\\vec\{)?(?:\\mathrm\{(?P<word>\w+)\}|\\(?P<sign>[a-z]+) ?|(?P<letter>[^\W\d_]))"
    r"(?(arrow)\})(?:_(?:\{(?:\\mathrm\{(?P<sub>\w+)\}|(?P<low>\w))\}))?(?P<prime>['\u2032]*)"
)
_OF_GREEK = {name: letter for letter, name in GREEK.items()}


def svg(shapes: Sequence[Shape], size: tuple[float, float], title: str, text: str = "") -> bytes:
    """Return the file of a figure of a size in pixels; `text` describes it."""
    width, height = map(_n, size)
    wide, high = (_n(side / PX_PER["mm"]) for side in size)
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
        f' width="{wide}mm" height="{high}mm"'
        f' viewBox="0 0 {width} {height}" {OF_ALL}>',
        f"<title>{escape(title)}</title>",
        *([f"<desc>{escape(text)}</desc>"] if text else ()),
    ]
    return "\n".join([*lines, *elements(shapes), "</svg>", ""]).encode()


def elements(shapes: Sequence[Shape], name: str = "t") -> Iterator[str]:
    """Yield the elements of shapes; the ids of labels begin with `name`."""
    number = 0
    for _, group in groupby(shapes, key=kind_of):
        same = list(group)
        first = same[0]
        if isinstance(first, Area):
            yield _areas([each for each in same if isinstance(each, Area)])
        elif isinstance(first, LineShape):
            yield from _strokes([each for each in same if isinstance(each, LineShape)])
        else:
            for shape in same:
                if isinstance(shape, Disc):
                    x, y = shape.centre
                    yield (
                        f'<circle cx="{_n(x)}" cy="{_n(y)}" r="{_n(shape.radius)}"'
                        f' fill="{hexadecimal(shape.colour)}"{_faint("fill", shape.opacity)}/>'
                    )
                elif isinstance(shape, PixelShape):
                    yield _image(shape)
                elif isinstance(shape, TextShape):
                    number += 1
                    yield from _text(shape, f"{name}{number}")


def kind_of(shape: Shape) -> object:
    """Return the key that consecutive shapes of one element share."""
    if isinstance(shape, Area):
        return "area", shape.colour, shape.opacity, shape.opacity < 1.0 and id(shape)
    if isinstance(shape, LineShape):
        return "stroke", shape.colour, shape.opacity, shape.width, shape.dash
    return id(shape)


def _n(value: float) -> str:
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _faint(what: str, opacity: float) -> str:
    return f' {what}-opacity="{opacity:.3g}"' if opacity < 1.0 else ""


def _path(points: Sequence[tuple[float, float]]) -> str:
    """A path in tenths of a pixel, which are 8 micrometres on paper; empty for a point."""
    tenths = [place for place, _ in groupby((round(10.0 * x), round(10.0 * y)) for x, y in points)]
    if len(tenths) == 1:
        return ""
    x, y = tenths[0]
    data = f"M{_tenth(x)}{_tenth(y, ' ')}l"
    for number, (to_x, to_y) in enumerate(tenths[1:]):
        data += _tenth(to_x - x, " " if number else "") + _tenth(to_y - y, " ")
        x, y = to_x, to_y
    return data


def _tenth(tenths: int, space: str = "") -> str:
    """A number of tenths, after a space where a number before it would not end."""
    text = f"{tenths / 10.0:g}".replace("0.", ".", int(abs(tenths) < 10))
    return text if text.startswith("-") else space + text


def _areas(areas: Sequence[Area]) -> str:
    colour, opacity = hexadecimal(areas[0].colour), areas[0].opacity
    seam = f' stroke="{colour}" stroke-width="{SEAM_PX}"' if opacity >= 1.0 else ""
    data = "".join(f"{_path(turned(ring))}Z" for area in areas for ring in area.rings)
    return f'<path fill="{colour}"{_faint("fill", opacity)}{seam} d="{data}"/>'


def turned(ring: Points) -> Points:
    """A polygon with its corners in the one order: overlaps of two orders would be holes."""
    ends = zip(ring, [*ring[1:], ring[0]], strict=True)
    return ring if sum(x * t - y * s for (x, y), (s, t) in ends) < 0.0 else ring[::-1]


def chained(strokes: Iterable[LineShape]) -> list[Points]:
    """Return lines, those that follow each other as one."""
    chains: list[Points] = []
    for stroke in strokes:
        if chains and chains[-1][-1] == stroke.points[0]:
            chains[-1] += stroke.points[1:]
        else:
            chains.append([*stroke.points])
    return chains


def _strokes(strokes: Sequence[LineShape]) -> Iterator[str]:
    data, first = "".join(map(_path, chained(strokes))), strokes[0]
    dash = "" if first.dash is None else (
        f' stroke-linecap="butt" stroke-dasharray="{" ".join(map(_n, first.dash))}"'
    )  # fmt: skip
    if data:  # they are no points
        yield (
            f'<path stroke="{hexadecimal(first.colour)}"{_faint("stroke", first.opacity)}'
            f' stroke-width="{_n(first.width)}"{dash} d="{data}"/>'
        )


def _image(picture: PixelShape) -> str:
    buffer = io.BytesIO()
    Image.fromarray(picture.pixels).save(buffer, "PNG")
    left, top, width, height = map(_n, picture.place)
    data = base64.b64encode(buffer.getvalue()).decode()
    return (
        f'<image x="{left}" y="{top}" width="{width}" height="{height}"'
        f' xlink:href="data:image/png;base64,{data}"/>'
    )


# --------------------------------------------------------------------------- text


def _text(text: TextShape, name: str) -> Iterator[str]:
    """Yield a label's halo and its letters; what is no usual formula is drawn as its outline."""
    written, em = text.written, text.em
    (x, y), turn = text.place, -math.degrees(written.turn)
    place = f"translate({_n(x)} {_n(y)})" + (f" rotate({_n(turn)})" if turn else "")
    spans, outlines, end, spaces = list[str](), list[str](), 0.0, ""
    for (piece, is_tex, size, at), width in zip(written.pieces, written.widths, strict=True):
        end = at + width * size
        where = f'x="{_n(at * em)}" font-size="{_n(size * em)}"'
        # As wide as it was composed, also in another font.
        wide = f' textLength="{_n(width * size * em)}" lengthAdjust="spacingAndGlyphs"'
        if not is_tex:
            if piece in FILLED:
                high = _n(-FILLED_EM * size * em)
                spaces += "".join(f"M{_n((at + x * (end - at)) * em)} 0V{high}" for x in FILLED_AT)
            font = "" if is_set_in_words(piece) else _SIGNS
            spans.append(f"<tspan {where}{wide}{font}>{escape(piece)}</tspan>")
            continue
        match = TEX.fullmatch(piece)
        base = "" if match is None else match["letter"] or match["word"] or ""
        if match is not None and match["sign"]:
            base = _OF_GREEK.get(match["sign"], match["sign"] if match["sign"] in FUNCTIONS else "")
        if match is None or not base:
            outlines.append(outlined(piece, at * em, size * em))
            continue
        style = ' font-style="italic"' if len(base) == 1 else ""
        arrow = "\u20d7" if match["arrow"] else ""
        primes = match["prime"].replace("'", "\u2032")
        spans.append(
            f"<tspan {where}{'' if match['sub'] or match['low'] or primes else wide}"
            f"{_SIGNS}{style}>{escape(base + arrow)}</tspan>"
        )
        if match["sub"] or match["low"]:
            sub, down = match["sub"] or match["low"], _LOWER_EM * size * em
            slanted = "" if match["sub"] or sub.isdigit() else style
            spans.append(
                f'<tspan dy="{_n(down)}" font-size="{_n(_LOWERED * size * em)}"'
                f"{_SIGNS}{slanted}>{escape(sub)}</tspan>"
            )
            back = f' dy="{_n(-down)}"'
        else:
            back = ""
        if primes or back:
            spans.append(
                f'<tspan{back} font-size="{_n(size * em)}"{_SIGNS}>{primes or chr(0x200B)}</tspan>'
            )
    colour, faint = written.colour, _faint("fill", written.opacity)
    letters = f'{"".join(outlines)}<text xml:space="preserve" font-family="{WORDS_FONT}">'
    letters += "".join(spans) + "</text>"
    halo = 2.0 * HALO_EM * em
    between = spaces and f'<path transform="{place}" d="{spaces}"/>'
    yield (
        f'<g stroke={quoteattr(written.halo)} stroke-width="{_n(halo)}"'
        f' opacity="{HALO_OPACITY * written.opacity:.3g}"><use xlink:href="#{name}"/>{between}</g>'
    )
    yield f'<g id="{name}" transform="{place}" fill="{colour}"{faint}>{letters}</g>'
    if written.underlined:
        low = _n(UNDER_EM * em)
        yield (
            f'<path transform="{place}" stroke="{colour}" stroke-width="{_n(UNDER_EM * em / 2.0)}"'
            f' d="M0 {low}L{_n(end * em)} {low}"/>'
        )


def outlined(tex: str, x: float, em: float) -> str:
    """A formula as a path; words' em in pixels."""
    shape = outline(tex)
    letters = {1: "M", 2: "L", 3: "Q", 4: "C"}
    counts = {3: 2, 4: 3}
    data, place = "", 0
    while place < len(shape.codes):
        code = int(shape.codes[place])
        count = counts.get(code, 1)
        if code in letters:
            points = shape.vertices[place : place + count]
            data += letters[code] + " ".join(f"{_n(x + em * p)} {_n(-em * q)}" for p, q in points)
        else:
            data += "Z"
        place += count
    return f'<path d="{data}"/>'
