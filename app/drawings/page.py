"""A figure as one HTML file for phones: the pictures of its states under a slider, and words.

The file refers to no other and to no network. It holds the state in the middle as it stands, which
is what a reader without scripts sees and what is printed. For the others the script puts together
parts that are stored once: most elements of a state occur in its neighbours, too::

    parts    each on a line: an element, one outline of a path, or a sentence
    states   each on a line; its slots between semicolons; a slot is runs of parts, in base 36

Texts of documents are escaped before they become parts.
"""

import base64
import hashlib
import io
import re
from collections.abc import Iterable, Sequence
from dataclasses import asdict, replace
from html import escape, unescape
from itertools import groupby
from pathlib import Path
from string import Template
from typing import Any, NamedTuple

import numpy as np

from app.document.lengths import Size
from app.drawings.figure import PANE_PX, Figure
from app.drawings.style import DARK, LIGHT
from app.drawings.svg import OF_ALL, elements
from app.drawings.vectors import PixelShape, Shape
from app.languages import chosen, said
from app.lecture.typesetting import font_file
from app.model.refusal import REFUSALS, Refusal
from app.strangers import printable

LARGEST = 500_000  # most bytes of a page that opens at once where the network is slow
TEXT_PT = 6.0  # of letters in a pane of 640 pixels, which a phone shows as wide as itself
_SHARPER = 2.0  # of pixels, for the screens of phones

_SPAN = re.compile(r"<tspan([^>]*)>([^<]*)</tspan>")
_PART = re.compile(r'<path[^<>]* d="|M[^M"<]*|"/>|<[^<>]*>|[^<]+')
_CONTENT = Path(__file__).parent / "content"
_COLOURS = {f"{name}_{key}": colour for name, style in (("light", LIGHT), ("dark", DARK))
            for key, colour in asdict(style).items()}  # fmt: skip
STYLE = Template((_CONTENT / "page.css").read_text("utf-8")).substitute(_COLOURS)
_SCRIPT = (_CONTENT / "page.js").read_text("utf-8")


class PagePane(NamedTuple):
    """A pane's size in pixels, its shapes, and the sentence that describes them."""

    size: tuple[float, float]
    shapes: Sequence[Shape]
    description: str


class SliderPosition(NamedTuple):
    value: str  # with its name and unit
    panes: Sequence[PagePane]
    general: Sequence[str]  # sentences that a screen reader reads on demand
    announced: Sequence[str]  # sentences that it reads as soon as one of them changes


def page(title: str, states: Sequence[SliderPosition], column: bool = False) -> bytes:
    """Return the file of one state, or of several under a slider."""
    middle = len(states) // 2
    slots = [[_slot(*slot) for slot in _slots(state)] for state in states]
    aspects = [pane.size[0] / pane.size[1] for pane in states[0].panes]
    style = STYLE + "".join(
        f".p{number}{{flex-grow:{aspect:.3f};max-width:{85.0 * aspect:.3f}vh}}\n"
        for number, aspect in enumerate(aspects)
    )
    style += fonts("".join(slot) for state in slots for slot in state[:-3:2])
    *drawn, value, general, heard = ("".join(parts) for parts in slots[middle])
    figures = [
        f'<figure class="p{number}">'
        + picture(pane.size, drawn[2 * number], f' aria-labelledby="c{number}" data-slot')
        + f'<figcaption id="c{number}" data-slot>{drawn[2 * number + 1]}</figcaption></figure>'
        for number, pane in enumerate(states[middle].panes)
    ]
    several = len(states) > 1
    names = {state.value.partition(" =")[0] for state in states}
    name = names.pop() if len(names) == 1 else title
    body = [
        f"<h1>{escaped(title)}</h1>",
        f'<div class="panes{" column" if column else ""}">',
        *figures,
        "</div>",
    ]
    texts = [f"<p data-slot>{general}</p>", f'<p aria-live="polite" data-slot>{heard}</p>']
    if not several:
        return html(title, style, [*body, *texts])
    # Before the texts, so that it stays in sight at the foot of the window.
    slider = [
        '<form hidden autocomplete="off">',
        f'<output for="slider" aria-live="off" data-slot>{value}</output>',
        f'<input type="range" id="slider" aria-label="{escaped(name)}"'
        f' aria-valuetext="{value}" min="0" max="{len(states) - 1}" value="{middle}">',
        "</form>",
        f"<noscript><p>{value}. {said('The other states need scripts.')}</p></noscript>",
    ]
    return html(title, style, [*body, *slider, *texts, *_stored(slots)], _SCRIPT)


def sized(figure: Figure) -> Figure:
    """Return a figure of one pane in a size for a page, unless it has one."""
    if figure.size is not None:
        return figure
    document = figure.document
    is_wide = figure.panes == ("image",) and not (
        document.view.compare and not document.view.dividers
    )
    aspect = document.projection.aspect if is_wide else 1.0
    size = Size(PANE_PX * min(1.0, aspect), PANE_PX / max(1.0, aspect))
    return replace(figure, size=size, text_pt=figure.text_pt or TEXT_PT)


def drawn(figure: Figure, said: str) -> PagePane:
    """Draw a `sized` figure; of too many shapes it is a picture of pixels."""
    try:
        return PagePane(*figure.shapes(), said)
    except Refusal as error:
        if error.bound not in (REFUSALS["too-many"], REFUSALS["tangled"]):
            raise
    size_px = figure.full_size.px
    pixels = replace(figure, scale=_SHARPER).pixels()
    return PagePane(size_px, [PixelShape(pixels, (0.0, 0.0, *size_px))], said)


def picture(size: tuple[float, float], inner: str, attributes: str) -> str:
    """Return an SVG element that is part of a page."""
    width, height = (f"{side:g}" for side in size)
    return (
        f'<svg viewBox="0 0 {width} {height}" width="{width}" height="{height}" {OF_ALL}'
        f"{attributes}>{inner}</svg>"
    )


def drawing(shapes: Sequence[Shape], name: str) -> str:
    """Return the elements of shapes on one line; `name` begins the ids of their labels."""
    return "".join(elements(shapes, name)).replace("\n", " ")


def fonts(drawings: Iterable[str]) -> str:
    """Return the style of the labels' fonts, which have no other letters than the labels do."""
    signs: dict[str, set[str]] = {}
    for given, text in _SPAN.findall("".join(drawings)):
        name = "STIXGeneral" if "STIX" in given else "DejaVuSans"
        signs.setdefault(f"{name}{'Italic' * ('italic' in given)}", set()).update(unescape(text))
    return "".join(_font(name, "".join(sorted(signs[name]))) for name in sorted(signs))


def _font(name: str, signs: str) -> str:
    from fontTools import subset  # type: ignore[import-untyped]

    options, buffer = subset.Options(flavor="woff", hinting=False, layout_features=[]), io.BytesIO()
    options.drop_tables += ["FFTM"]  # a date of the font
    font: Any = subset.load_font(font_file(name), options)
    subsetter = subset.Subsetter(options)
    subsetter.populate(text=signs)
    subsetter.subset(font)
    subset.save_font(font, buffer, options)
    font.close()
    family = "STIXGeneral" if "STIX" in name else "DejaVu Sans"
    style = "italic" if "Italic" in name else "normal"
    data = base64.b64encode(buffer.getvalue()).decode()
    return (
        f"@font-face{{font-family:{family};font-style:{style};"
        f"src:url(data:font/woff;base64,{data})}}\n"
    )


def escaped(text: str) -> str:
    return escape(printable(text))


def html(title: str, style: str, body: Iterable[str], script: str = "") -> bytes:
    """Return an HTML file that runs nothing but its own script, and loads nothing."""
    policy = f"default-src 'none'; img-src data:; font-src data:; style-src {_hash(style)}"
    if script:
        policy += f"; script-src {_hash(script)}"
    lines = [
        "<!doctype html>",
        f'<html lang="{chosen()}">',
        '<meta charset="utf-8">',
        '<meta http-equiv="Content-Security-Policy"'
        f" content=\"{policy}; base-uri 'none'; form-action 'none'\">",
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f"<title>{escaped(title)}</title>",
        f"<style>{style}</style>",
        *body,
        *([f"<script>{script}</script>"] if script else ()),
        "</html>",
        "",
    ]
    return "\n".join(lines).encode()


def _hash(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"


def _slots(state: SliderPosition) -> Iterable[tuple[str, bool]]:
    """Yield the texts of a page that change, in its order, and whether each is drawn."""
    for number, pane in enumerate(state.panes):
        yield drawing(pane.shapes, f"p{number}t"), True
        yield escaped(pane.description), False
    yield escaped(state.value), False
    for sentences in (state.general, state.announced):
        yield "\n".join(map(escaped, sentences)), False


def _slot(text: str, is_drawn: bool) -> list[str]:
    if is_drawn:
        return _PART.findall(text)
    *lines, last = text.split("\n")
    return [*(f"{line} " for line in lines), last]


def _stored(slots: Sequence[Sequence[Sequence[str]]]) -> list[str]:
    """Return the elements with all parts, each once, and with the states that are made of them."""
    places: dict[str, int] = {}
    states = []
    for state in slots:
        runs = (_runs([places.setdefault(part, len(places)) for part in slot]) for slot in state)
        states.append(";".join(runs))
    return [
        '<script type="text/plain" id="parts">', *places, "</script>",
        '<script type="text/plain" id="states">', *states, "</script>",
    ]  # fmt: skip


def _runs(places: Sequence[int]) -> str:
    runs = (list(run) for _, run in groupby(enumerate(places), lambda each: each[1] - each[0]))
    ends = (dict.fromkeys((run[0][1], run[-1][1])) for run in runs)
    return ",".join("-".join(np.base_repr(end, 36).lower() for end in each) for each in ends)
