"""The handout of a talk as one HTML file, which students open on their phones.

It has what the A4 pages have: each step's figure, as shapes, its text, matrices and questions. It
needs no network and no scripts. A formula is its outlines, stored once, and words for a screen
reader.
"""

import base64
import re
from collections.abc import Iterator
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QImage

from app.drawings.describing import describe
from app.drawings.figure import Figure
from app.drawings.page import STYLE, drawing, drawn, escaped, fonts, html, picture, sized
from app.drawings.svg import outlined
from app.languages import said
from app.lecture.typesetting import outline
from app.lessons.course import Course, panes_of, scene_of
from app.lessons.text import DISPLAYED, FORMULA, html_of, in_line, readable, spoken_tex
from app.model.formula_text import CLOSE, OPEN, OVER
from widgets.parts.lesson_text import DISPLAYED_LARGER, LARGER
from widgets.parts.saving import png_of
from widgets.program import handout_content

_SLIDE_PX = 1280  # width of a picture of a slide
_UNITS = 10.0  # of the outlines, to an em
_STYLE = (Path(__file__).parent / "content" / "handout.css").read_text("utf-8")


def handout_page(course: Course, *, answers: bool = True) -> bytes:
    """Return a talk as the content of an HTML file; a `Refusal` if a state is impossible.

    With `answers` it is the teacher's, with the notes; without them the students'.
    """
    page, lesson = _PhonePage(), course.lesson
    body = [page.text(f"# {lesson.title}")]
    if answers and (minutes := handout_content.planned(lesson)):
        body.append(f"<p>{escaped(minutes)}</p>")
    for place in range(len(lesson.steps)):
        body.append("<section>")
        body += (page.element(each) for each in handout_content.contents(course, place, answers))
        body.append("</section>")
    style = STYLE + _STYLE + page.style() + fonts(page.drawings)
    return html(in_line(lesson.title), style, [*page.outlines(), *body])


class _PhonePage:
    """Makes the elements of a page, and keeps what they share."""

    def __init__(self) -> None:
        self._formulas: dict[str, int] = {}
        self._depths: set[int] = set()
        self.drawings: list[str] = []

    def element(self, content: handout_content.Content) -> str:
        if isinstance(content, handout_content.Heading):
            return self.text(f"## {content.text}")
        if isinstance(content, handout_content.StepFigure):
            note = f"<aside>{self.text(content.note)}</aside>" if content.note else ""
            return "\n".join([self._figure(content), *map(self.text, content.texts), note])
        if isinstance(content, handout_content.EquationTables):
            return _beside(map(self.text, content.tables))
        if isinstance(content, handout_content.PanelNumbers):
            return "\n".join(
                [*map(self.text, content.texts), _beside(map(_typeset, content.formulas))]
            )
        if isinstance(content, handout_content.ToWrite):
            room = f'placeholder="{said("answer-not-kept")}"'
            return f'<textarea rows="3" aria-label="{said("Your answer")}" {room}></textarea>'
        return self.text(content)

    def text(self, text: str) -> str:
        """Return Markdown as HTML, with its formulas."""
        marked, formulas = html_of(text)
        parts = re.split(f"([{FORMULA}{DISPLAYED}])", marked)
        for number, tex in enumerate(formulas):
            sign, after = parts[2 * number + 1 : 2 * number + 3]
            shown = self._formula(tex, DISPLAYED_LARGER if sign == DISPLAYED else 1.0)
            # No line ends between a formula and its punctuation.
            parts[2 * number + 1] = shown + ("" if after[:1].isspace() else "\u2060")
        return re.sub(r'style="text-align:(\w+)"', r'class="\1"', "".join(parts))

    def _formula(self, tex: str, larger: float) -> str:
        tex = readable(tex)
        try:
            shape = outline(tex)
        except ValueError:  # as it was typed
            return f"<code>{escaped(tex)}</code>"
        number = self._formulas.setdefault(tex, len(self._formulas))
        em = LARGER * larger
        high = shape.ascent + shape.descent
        depth = round(100.0 * em * shape.descent)
        self._depths.add(depth)
        box = (0.0, -_UNITS * shape.ascent, _UNITS * shape.width, _UNITS * high)
        return (
            f'<svg class="f d{depth}" role="img" aria-label="{escaped(spoken_tex(tex))}"'
            f' width="{em * shape.width:.2f}em" height="{em * high:.2f}em"'
            f' viewBox="{" ".join(f"{side:.2f}" for side in box)}"><use href="#f{number}"/></svg>'
        )

    def outlines(self) -> Iterator[str]:
        """Yield the outlines of all formulas, each once."""
        yield '<svg width="0" height="0" aria-hidden="true"><defs>'
        for tex, number in self._formulas.items():
            yield f'<g id="f{number}">{outlined(tex, 0.0, _UNITS)}</g>'
        yield "</defs></svg>"

    def style(self) -> str:
        return "\n".join(
            f".d{depth}{{vertical-align:{-depth / 100.0:g}em}}" for depth in sorted(self._depths)
        )

    def _figure(self, shown: handout_content.StepFigure) -> str:
        document = shown.document
        panes = panes_of(document)
        about = describe(document, scene_of(document), panes)
        if shown.slide is not None and (slide := _slide(shown.slide)):
            return f'<figure><img src="{slide}" alt="{escaped(about.text)}"></figure>'
        pictures = []
        for pane in panes:
            # What is true of the state may be the answer.
            said = about.panes[pane] if shown.has_question else about.of_pane(pane)
            figure = Figure(document, scene_of(document), (pane,), crop=True)
            size, shapes, _ = drawn(sized(figure), said)
            self.drawings.append(drawing(shapes, f"s{len(self.drawings)}t"))
            shape = picture(size, self.drawings[-1], f' aria-label="{escaped(said)}"')
            pictures.append(f"<figure>{shape}</figure>")
        return f'<div class="panes">{"".join(pictures)}</div>'


def _slide(path: Path) -> str:
    """Return the address of a picture that is part of the page; empty if it is none."""
    image = QImage(str(path))
    if image.isNull():
        return ""
    if image.width() > _SLIDE_PX:
        image = image.scaledToWidth(_SLIDE_PX, Qt.TransformationMode.SmoothTransformation)
    return f"data:image/png;base64,{base64.b64encode(png_of(image)).decode()}"


def _beside(parts: Iterator[str]) -> str:
    shown = "".join(f"<div>{part}</div>" for part in parts)
    return f'<div class="beside">{shown}</div>' if shown else ""


def _typeset(formula: str) -> str:
    """Return a formula of `widgets.parts.typeset` as HTML: lines, and matrices in brackets."""
    parts = []
    for line in formula.split("\n"):
        if line.startswith("["):
            rows = (row.split("&") for row in line[1:-1].split(";"))
            cells = ("".join(f"<td>{_indexed(cell)}</td>" for cell in row) for row in rows)
            parts.append(f"<table>{''.join(f'<tr>{row}</tr>' for row in cells)}</table>")
        else:
            parts.append(f"<div>{_indexed(line)}</div>")
    return "".join(parts)


def _indexed(text: str) -> str:
    """Return a text with its subscripts and superscripts."""
    text = escaped(text.translate({ord(OPEN): None, ord(OVER): "/", ord(CLOSE): None}))
    text = re.sub(r"_([^\W_]+(?:\u2192[^\W_]+)?)", r"<sub>\1</sub>", text)
    return re.sub(r"\^([-−]?[^\W_]+)", r"<sup>\1</sup>", text)
