"""A talk as a PDF of A4 pages: each step with its figure and the text for the class.

The teacher's version has the answers and the notes; the students' has lines to write on instead.
The matrices or the scene's numbers stand below the figure of a state that opens their panel. The
figures have the size with which the pages are filled best. No display is needed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from pathlib import Path
from textwrap import wrap

from PySide6.QtCore import QRectF
from PySide6.QtGui import QFont, QImage, QPainter

from app.document.document import Document
from app.lecture.equation import equation_of, latex_cell
from app.lecture.notation import matrices
from app.lessons.course import Course, scene_of
from app.lessons.lesson import Step
from app.lessons.strokes import picture_beside
from app.lessons.text import escaped
from widgets.controls.readout import full_sentence, value_text
from widgets.panels.matrix_panel import note_on
from widgets.parts.lesson_text import answer_of
from widgets.parts.messages import of_phenomena, read_text, stage_title
from widgets.parts.typeset import Typeset, matrix, typeset
from widgets.program import paper
from widgets.program.paper import (
    BETWEEN_PT,
    BETWEEN_STEPS_PT,
    NOTE_INDENT_PT,
    NOTE_PT,
    RULE_PT,
    TEXT_PT,
    TITLE_PT,
    Block,
    Page,
)

FIGURE_WIDTHS = (0.58, 0.54, 0.62, 0.5, 0.66, 0.46, 0.7)
"""Possible widths of a figure, as parts of the page's: the first ones look best."""
LINES_BESIDE, LINES_BELOW = 3, 2
"""Lines to write on: at least these beside a figure, and these below a question."""
COLUMN_OVER = 1.2
"""Largest height of the text beside a figure, relative to the figure."""
FORMULA_PX, FORMULA_PT = 18, 8.5
"""Letters of a matrix as it is laid out, with brackets of whole pixels, and as it is printed."""
BETWEEN_FORMULAS_PX = 40.0
NOTE_CHARACTERS = 36
"""Line length of a matrix's note, so that it is not wider than the matrix."""


def handout(course: Course, *, answers: bool = True) -> bytes:
    """Return a talk as the content of a PDF file; a `Refusal` if a state is impossible.

    With `answers` it is the teacher's, with the notes; without them the students'.
    """

    def lay_out(width: float, height: float) -> Iterator[paper.PaintPage]:
        for number, page in enumerate(paged(course, width, height, answers), 1):
            yield partial(paint, page, number, width, height)

    def paint(page: Page, number: int, width: float, height: float, painter: QPainter) -> None:
        paper.paint_page(painter, page, width, height, not answers)
        paper.foot(painter, course.lesson.title, str(number), width, height)

    return paper.pdf(course.lesson.title, lay_out)


class _Sheet:
    """The blocks of a talk's steps, for figures of one width."""

    def __init__(self, course: Course, width: float, part: float, answers: bool) -> None:
        self._course, self._width, self._answers = course, width, answers
        self._figure_width = part * width

    def head(self) -> Iterator[Block]:
        lesson = self._course.lesson
        minutes = lesson.minutes or sum(
            step.note.minutes for step in lesson.steps if step.note is not None
        )
        yield paper.text(lesson.title, self._width, 1.4 * TITLE_PT, title=True)
        if minutes and self._answers:
            yield paper.text(f"{minutes:g} min", self._width, TEXT_PT)

    def steps(self) -> Iterator[Block]:
        for place, step in enumerate(self._course.lesson.steps):
            blocks = list(self._of(place, step))
            blocks[-1].after = BETWEEN_STEPS_PT
            yield from blocks

    def _of(self, place: int, step: Step) -> Iterator[Block]:
        """Yield a step's title, its figure with what stands beside it, and its questions."""
        course = self._course
        number = f"{place + 1}. " if len(course.lesson.steps) > 1 else ""
        yield paper.text(number + step.title, self._width, TITLE_PT, title=True)
        shown, here = course.shown(place).document, course.at(place)
        asked = [part for part in step.parts if part.reveals or part in step.asked]
        texts = [part.text for part in step.parts if part not in asked]
        note = self._note(step)
        slide = picture_beside(course.lesson.path, step.name)
        yield from self._with_figure(shown, texts, note, slide)
        if not any(part.is_tall and "\n|" in part.text for part in step.parts):
            yield from _equation(shown, self._width)
        before = course.shown(place - 1).document if place else None
        if "equation" not in shown.view.slide:  # else it has its matrices
            yield from _panel(shown, before, self._width)
        for part in asked:
            if not self._answers:
                yield paper.text(part.posed(), self._width, TEXT_PT)
                yield self._lines(LINES_BELOW * RULE_PT)
                continue
            yield paper.text(part.told(answer_of(part, here)), self._width, TEXT_PT)
            whys = [part.why] if part.why else []
            if part.show is not None:
                after = here.shown_by(part.show)
                yield from self._with_figure(after, whys, "")
                if "equation" not in after.view.slide:
                    yield from _panel(after, shown, self._width)
                elif after.view.equation != shown.view.equation:
                    yield from _equation(after, self._width)
            else:
                yield from (paper.text(why, self._width, TEXT_PT) for why in whys)

    def _note(self, step: Step) -> str:
        """The note for the teacher, with the planned minutes."""
        if step.note is None or not self._answers:
            return ""
        minutes = f"*{step.note.minutes:g} min.* " if step.note.minutes else ""
        return minutes + step.note.text

    def _with_figure(
        self, document: Document, texts: list[str], note: str, slide: Path | None = None
    ) -> Iterator[Block]:
        """Yield a figure and its texts: beside it if they are narrow and low enough.

        If `slide` is a file, the figure is that picture of a slide on which somebody has drawn.
        """
        figure = paper.figure(document, self._width, self._figure_width)
        drawn = QImage(str(slide)) if slide is not None and slide.is_file() else QImage()
        if not drawn.isNull():
            figure = paper.picture(drawn, self._width)
        left = figure.wide + NOTE_INDENT_PT
        room = self._width - left
        if figure.wide > 0.75 * self._width:  # there is no room beside it
            yield figure
            yield from self._below(texts, note)
            if not self._answers:
                yield self._lines(LINES_BELOW * RULE_PT)
            return
        beside, most = list[Block](), COLUMN_OVER * figure.height
        if not self._answers:
            most = figure.height - LINES_BESIDE * RULE_PT

        def fits(block: Block) -> bool:
            high = sum(each.height + BETWEEN_PT for each in beside) + block.height
            return high <= most and block.wide <= room + 0.5

        while texts and fits(block := paper.text(texts[0], room, TEXT_PT)):
            beside.append(block)
            texts = texts[1:]
        if note and fits(block := paper.text(note, room, NOTE_PT, left=NOTE_INDENT_PT)):
            beside.append(block)
            note = ""
        if not self._answers:
            used = sum(each.height + BETWEEN_PT for each in beside)
            beside.append(paper.ruled(room, figure.height - used))
        yield paper.beside(figure, beside, left)
        yield from self._below(texts, note)

    def _below(self, texts: Iterable[str], note: str) -> Iterator[Block]:
        yield from (paper.text(text, self._width, TEXT_PT) for text in texts)
        if note:
            yield paper.text(note, self._width, NOTE_PT, left=NOTE_INDENT_PT)

    def _lines(self, height: float) -> Block:
        return paper.ruled(self._width, height)


def _equation(document: Document, width: float) -> Iterator[Block]:
    """Yield the matrices of a slide that is an equation, beside each other."""
    view = document.view
    if "equation" not in view.slide:
        return
    equation = equation_of(document.projection, view.letters, view.equation, document.settings)
    blocks = []
    for term in equation.terms:
        cells = [[f"${latex_cell(cell, term.letters)}$" for cell in row]
                 for row in term.matrix.formulas]  # fmt: skip
        if equation.is_in_numbers:
            cells = [[read_text(value) for value in row] for row in term.matrix.values]
        is_result = bool(equation.factors) and term is equation.result
        names = [each.name for each in equation.factors] if is_result else [term.name]
        above = f"${' '.join(names)}$ =" if all(names) else "="
        lines = [above, "", "| | | | |", "|---|---|---|---|"]
        lines += [f"| {' | '.join(row)} |" for row in cells]
        blocks.append(paper.text("\n".join(lines), width, NOTE_PT))
    row: list[Block] = []
    for block in blocks:
        if row and sum(each.wide + BETWEEN_PT for each in row) + block.wide > width:
            yield paper.in_row(row)
            row = []
        row.append(block)
    yield paper.in_row(row)


def _panel(document: Document, before: Document | None, width: float) -> Iterator[Block]:
    """Yield the numbers of the open panel, unless they are the same as in the state before."""
    view = document.view
    seen = None if before is None else (before, before.view.panel, before.view.letters)
    if seen == (document, view.panel, view.letters):
        return
    if view.panel == "matrices":
        yield from _side_by_side(_matrices(document), width)
    elif view.panel == "scene":
        yield from _readout(document, width)


def _matrices(document: Document) -> Iterator[str]:
    """Yield each matrix below its name, with its note."""
    for each in matrices(document.projection, document.view.letters):
        name = stage_title(each.name)
        lines = [f"{name} = {each.called}" if each.called else name]
        lines.append(matrix([read_text(value) for value in row] for row in each.values))
        note = note_on(each, document.projection, document.view.letters)
        for line in note.splitlines():
            lines += wrap(line, NOTE_CHARACTERS, break_on_hyphens=False)
        yield "\n".join(lines)


def _readout(document: Document, width: float) -> Iterator[Block]:
    """Yield the scene's numbers, except the one counted in the window's own picture."""
    scene = scene_of(document)
    if scene.phenomenon is None:
        return
    said = partial(of_phenomena, letters=document.view.letters)
    found = scene.phenomenon.illustration(document.projection, document.settings, scene.subject)
    rows, formulas, reasons = ["| | |", "|---|---:|"], list[str](), list[str]()
    for each in found.readings:
        if each.counted:
            continue
        label = said(each.label)
        value = (
            said(each.value) if isinstance(each.value, str) else value_text(each.value, read_text)
        )
        if value.startswith("["):
            formulas.append(f"{label}\n{value}")
            continue
        unit = said(each.unit) if each.unit and each.value is not None else ""
        cells = (escaped(text.replace("\n", " ")) for text in (label, f"{value} {unit}".strip()))
        rows.append(f"| {' | '.join(cells)} |")
        if each.note is not None:
            reasons.append(full_sentence(each.note.sentence(said, read_text)))
    if len(rows) > 2:
        yield paper.text("\n".join(rows), width, NOTE_PT)
    for reason in dict.fromkeys(reasons):
        yield paper.text(escaped(reason), width, NOTE_PT)
    yield from _side_by_side(formulas, width)


def _side_by_side(formulas: Iterable[str], width: float) -> Iterator[Block]:
    font = QFont("DejaVu Sans")
    font.setPixelSize(FORMULA_PX)
    scale = FORMULA_PT / FORMULA_PX
    rows: list[list[Typeset]] = []
    right = 0.0
    for formula in formulas:
        part = typeset(formula, font)
        if not rows or (right + part.width) * scale > width:
            rows.append([])
            right = 0.0
        rows[-1].append(part.at(right, part.ascent))
        right += part.width + BETWEEN_FORMULAS_PX
    for row in rows:
        yield Block(scale * max(part.descent for part in row), partial(_paint_row, row))


def _paint_row(row: Sequence[Typeset], painter: QPainter, _part: QRectF) -> None:
    painter.scale(FORMULA_PT / FORMULA_PX, FORMULA_PT / FORMULA_PX)
    for formula in row:
        formula.paint(painter, 0.0, 0.0)


def paged(course: Course, width: float, height: float, answers: bool) -> list[Page]:
    """Place a talk on pages, with figures of the width that fills them best."""
    sheets = (_Sheet(course, width, part, answers) for part in FIGURE_WIDTHS)
    return paper.best([paper.placed([*sheet.head(), *sheet.steps()], height) for sheet in sheets])
