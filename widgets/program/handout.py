"""A talk as a PDF of A4 pages: each step with its figure and the text for the class.

The teacher's version has the answers and the notes; the students' has lines to write on instead.
The matrices or the scene's numbers stand below the figure of a state that opens their panel. The
figures have the size with which the pages are filled best. No display is needed.
"""

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from itertools import pairwise

from PySide6.QtCore import QRectF
from PySide6.QtGui import QImage, QPainter

from app.lessons.course import Course
from widgets.parts.typeset import Typeset, below, typeset, words, words_font
from widgets.program import paper
from widgets.program.handout_content import (
    Content,
    EquationTables,
    Heading,
    PanelNumbers,
    StepFigure,
    ToWrite,
    contents,
    planned,
)

FIGURE_WIDTHS = (0.58, 0.54, 0.62, 0.5, 0.66, 0.46, 0.7)
"""Possible widths of a figure, as parts of the page's: the first ones look best."""
LINES_BESIDE, LINES_BELOW = 3, 2
"""Lines to write on: at least these beside a figure, and these below a question."""
COLUMN_OVER = 1.2  # largest height of the text beside a figure, relative to the figure
FORMULA_PX, FORMULA_PT = 18, 8.5
"""Letters of a matrix as it is laid out, with brackets of whole pixels, and as it is printed."""
BETWEEN_FORMULAS_PX = 40.0


def handout(course: Course, *, answers: bool = True) -> bytes:
    """Return a talk as the content of a PDF file; a `Refusal` if a state is impossible.

    With `answers` it is the teacher's, with the notes; without them the students'.
    """

    def lay_out(width: float, height: float) -> Iterator[paper.PaintPage]:
        for number, page in enumerate(paged(course, width, height, answers), 1):
            left, right = course.lesson.title, str(number)
            yield partial(paper.paint_page, page, left, right, width, height, is_ruled=not answers)

    return paper.pdf(course.lesson.title, lay_out)


class _HandoutSheet:
    """The blocks of a talk's steps, for figures of one width."""

    def __init__(self, course: Course, width: float, part: float, answers: bool) -> None:
        self._course, self._width, self._answers = course, width, answers
        self._figure_width = part * width

    def head(self) -> Iterator[paper.PageBlock]:
        yield paper.text(self._course.lesson.title, self._width, 1.4 * paper.TITLE_PT, title=True)
        if self._answers and (minutes := planned(self._course.lesson)):
            yield paper.text(minutes, self._width, paper.TEXT_PT)

    def steps(self) -> Iterator[paper.PageBlock]:
        for place in range(len(self._course.lesson.steps)):
            blocks = list(self._of(place))
            blocks[-1].after = paper.BETWEEN_STEPS_PT
            yield from blocks

    def _of(self, place: int) -> Iterator[paper.PageBlock]:
        """Yield a step's blocks; numbers, and what students are asked, are beside their figure."""
        printed = [(each, list(self._blocks(each)))
                 for each in contents(self._course, place, self._answers)]  # fmt: skip
        parts = [each for each in printed if each[1]]
        for (each, blocks), (after, _) in pairwise([*parts, ("", [])]):
            is_kept = isinstance(after, EquationTables | PanelNumbers) or (
                bool(after) and isinstance(after, StepFigure) == self._answers
            )
            is_table = isinstance(each, EquationTables | PanelNumbers)
            for block in blocks:
                block.kept |= is_kept or (is_table and block is not blocks[-1])
            yield from blocks

    def _blocks(self, content: Content) -> Iterator[paper.PageBlock]:
        if isinstance(content, StepFigure):
            yield from self._with_figure(content)
        elif isinstance(content, PanelNumbers):
            yield from (paper.text(text, self._width, paper.NOTE_PT) for text in content.texts)
            yield from _side_by_side(content.formulas, self._width)
        elif isinstance(content, EquationTables):
            yield from _beside(content.tables, self._width)
        elif isinstance(content, Heading):
            yield paper.text(content.text, self._width, paper.TITLE_PT, title=True)
        elif isinstance(content, ToWrite):
            yield paper.ruled(self._width, LINES_BELOW * paper.RULE_PT)
        else:
            yield paper.text(content, self._width, paper.TEXT_PT)

    def _with_figure(self, shown: StepFigure) -> Iterator[paper.PageBlock]:
        """Yield a figure and its texts: beside it if they are narrow and low enough."""
        texts, note = shown.texts, shown.note
        figure = paper.figure(shown.document, self._width, self._figure_width)
        drawn = QImage() if shown.slide is None else QImage(str(shown.slide))
        if not drawn.isNull():
            figure = paper.picture(drawn, self._width)
        left = figure.wide + paper.NOTE_INDENT_PT
        room = self._width - left
        if figure.wide > 0.75 * self._width:  # there is no room beside it
            yield figure
            yield from self._below(texts, note)
            if not self._answers:
                yield paper.ruled(self._width, LINES_BELOW * paper.RULE_PT)
            return
        beside, most = list[paper.PageBlock](), COLUMN_OVER * figure.height
        if not self._answers:
            most = figure.height - LINES_BESIDE * paper.RULE_PT

        def fits(block: paper.PageBlock) -> bool:
            high = sum(each.height + paper.BETWEEN_PT for each in beside) + block.height
            return high <= most and block.wide <= room + 0.5

        while texts and fits(block := paper.text(texts[0], room, paper.TEXT_PT)):
            beside.append(block)
            texts = texts[1:]
        if note and fits(block := paper.text(note, room, paper.NOTE_PT, left=paper.NOTE_INDENT_PT)):
            beside.append(block)
            note = ""
        if not self._answers:
            used = sum(each.height + paper.BETWEEN_PT for each in beside)
            beside.append(paper.ruled(room, figure.height - used))
        yield paper.beside(figure, beside, left)
        yield from self._below(texts, note)

    def _below(self, texts: Iterable[str], note: str) -> Iterator[paper.PageBlock]:
        yield from (paper.text(text, self._width, paper.TEXT_PT) for text in texts)
        if note:
            yield paper.text(note, self._width, paper.NOTE_PT, left=paper.NOTE_INDENT_PT)


def _beside(tables: Iterable[str], width: float) -> Iterator[paper.PageBlock]:
    row: list[paper.PageBlock] = []
    for block in (paper.text(table, width, paper.NOTE_PT) for table in tables):
        if row and sum(each.wide + paper.BETWEEN_PT for each in row) + block.wide > width:
            yield paper.in_row(row)
            row = []
        row.append(block)
    if row:
        yield paper.in_row(row)


def _side_by_side(formulas: Iterable[str], width: float) -> Iterator[paper.PageBlock]:
    font = words_font()
    font.setPixelSize(FORMULA_PX)
    scale = FORMULA_PT / FORMULA_PX
    rows: list[list[Typeset]] = []
    right = 0.0
    for formula in formulas:
        lines = (
            typeset(line, font) if line.startswith("[") else words(line, font)
            for line in formula.split("\n")
        )
        part = below([*lines], font)
        if not rows or (right + part.width) * scale > width:
            rows.append([])
            right = 0.0
        rows[-1].append(part.at(right, part.ascent))
        right += part.width + BETWEEN_FORMULAS_PX
    for row in rows:
        yield paper.PageBlock(scale * max(part.descent for part in row), partial(_paint_row, row))


def _paint_row(row: Sequence[Typeset], painter: QPainter, _part: QRectF) -> None:
    painter.scale(FORMULA_PT / FORMULA_PX, FORMULA_PT / FORMULA_PX)
    for formula in row:
        formula.paint(painter, 0.0, 0.0)


def paged(course: Course, width: float, height: float, answers: bool) -> list[paper.PaperPage]:
    """Place a talk on pages, with figures of the width that fills them best."""
    sheets = (_HandoutSheet(course, width, part, answers) for part in FIGURE_WIDTHS)
    return paper.best([paper.placed([*sheet.head(), *sheet.steps()], height) for sheet in sheets])
