"""A talk as a PDF of A4 pages: each step with its figure and the text for the class.

The teacher's version has the answers and the notes; the students' has lines to write on instead.
The matrices or the scene's numbers stand below the figure of a state that opens their panel. The
figures have the size with which the pages are filled best. No display is needed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from textwrap import wrap
from typing import NamedTuple

from PySide6.QtCore import QBuffer, QCoreApplication, QMarginsF, QPointF, QRectF, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QGuiApplication,
    QImage,
    QPageLayout,
    QPageSize,
    QPainter,
    QPdfWriter,
    QPen,
)

from app.document.document import Document
from app.document.view import PANES
from app.drawings.figures import DPI as DPI_OF_FIGURES
from app.drawings.figures import render
from app.drawings.style import LIGHT
from app.lecture.equation import equation_of, latex_cell
from app.lecture.notation import matrices
from app.lessons.course import Course, scene_of
from app.lessons.lesson import Step
from app.lessons.strokes import picture_beside
from app.lessons.text import escaped
from widgets.controls.readout import full_sentence, value_text
from widgets.panels.matrix_panel import note_on
from widgets.parts.lesson_text import answer_of, set_text
from widgets.parts.messages import of_phenomena, read_text, stage_title
from widgets.parts.plain import TextDocument
from widgets.parts.typeset import Typeset, matrix, typeset
from widgets.window.pictures import image_of

MARGIN_MM = 18.0
TEXT_PT, TITLE_PT, NOTE_PT, FOOT_PT = 10.5, 15.0, 9.0, 8.0
BETWEEN_PT, BETWEEN_STEPS_PT = 6.0, 20.0
NOTE_INDENT_PT = 12.0
FIGURE_PX_PER_INCH, FIGURE_TEXT_PT = 220, 7.0
PANE_ASPECT = 1.6
"""Width to height of a figure of one pane; the image has its own."""
FIGURE_WIDTHS = (0.58, 0.54, 0.62, 0.5, 0.66, 0.46, 0.7)
"""Possible widths of a figure, as parts of the page's: the first ones look best."""
BLANK = 0.3
"""Largest share of a page that may stay blank below its last line."""
RULE_PT = 24.0
"""Distance between lines to write on."""
LINES_BESIDE, LINES_BELOW = 3, 2
"""Lines to write on: at least these beside a figure, and these below a question."""
COLUMN_OVER = 1.2
"""Largest height of the text beside a figure, relative to the figure."""
DPI = 1200
"""Qt places lines and letters on whole pixels of the page."""
FORMULA_PX, FORMULA_PT = 18, 8.5
"""Letters of a matrix as it is laid out, with brackets of whole pixels, and as it is printed."""
BETWEEN_FORMULAS_PX = 40.0
NOTE_CHARACTERS = 36
"""Line length of a matrix's note, so that it is not wider than the matrix."""


def handout(course: Course, *, answers: bool = True) -> bytes:
    """Return a talk as the content of a PDF file; a `Refusal` if a state is impossible.

    With `answers` it is the teacher's, with the notes; without them the students'.
    """
    application = QCoreApplication.instance() or QGuiApplication(["app", "-platform", "offscreen"])
    assert isinstance(application, QGuiApplication)
    buffer = QBuffer()
    buffer.open(QBuffer.OpenModeFlag.WriteOnly)
    writer = QPdfWriter(buffer)
    writer.setTitle(course.lesson.title)
    writer.setCreator("Frustum Lab")
    writer.setResolution(DPI)
    margins = QMarginsF(MARGIN_MM, MARGIN_MM, MARGIN_MM, MARGIN_MM)
    a4 = QPageSize(QPageSize.PageSizeId.A4)
    writer.setPageLayout(
        QPageLayout(a4, QPageLayout.Orientation.Portrait, margins, QPageLayout.Unit.Millimeter)
    )
    page = QRectF(writer.pageLayout().paintRect(QPageLayout.Unit.Point))
    width, height = page.width(), page.height() - 2.0 * FOOT_PT
    pages = paged(course, width, height, answers)
    painter = QPainter(writer)
    painter.setRenderHint(QPainter.RenderHint.LosslessImageRendering)
    painter.scale(DPI / 72.0, DPI / 72.0)
    try:
        for number, content in enumerate(pages, 1):
            if number > 1:
                writer.newPage()
            _paint_page(painter, content, width, height, not answers)
            _foot(painter, course.lesson.title, number, width, height)
    finally:
        painter.end()
    return bytes(buffer.data().data())


@dataclass
class Block:
    """A part of a page over its width, in points; `kept` on the same page as the next one."""

    height: float
    paint: Callable[[QPainter, QRectF], object]
    """Paints the part of the block in a rectangle."""
    left: float = 0.0
    kept: bool = False
    after: float = BETWEEN_PT
    wide: float = 0.0
    """How wide its content is."""


def _text(text: str, width: float, size: float, *, title: bool = False, left: float = 0.0) -> Block:
    document = TextDocument()
    font = QFont("DejaVu Sans")
    font.setStyleHint(QFont.StyleHint.SansSerif)
    screen = QGuiApplication.primaryScreen()  # a document is laid out in its pixels
    font.setPointSizeF(size * 72.0 / screen.logicalDotsPerInchY())
    font.setHintingPreference(QFont.HintingPreference.PreferNoHinting)
    document.setDefaultFont(font)
    document.setUseDesignMetrics(True)
    set_text(document, text, title=title)
    document.setTextWidth(width - left)
    wide = document.idealWidth() + left
    return Block(document.size().height(), document.drawContents, left, kept=title, wide=wide)


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
        yield _text(lesson.title, self._width, 1.4 * TITLE_PT, title=True)
        if minutes and self._answers:
            yield _text(f"{minutes:g} min", self._width, TEXT_PT)

    def steps(self) -> Iterator[Block]:
        for place, step in enumerate(self._course.lesson.steps):
            blocks = list(self._of(place, step))
            blocks[-1].after = BETWEEN_STEPS_PT
            yield from blocks

    def _of(self, place: int, step: Step) -> Iterator[Block]:
        """Yield a step's title, its figure with what stands beside it, and its questions."""
        course = self._course
        number = f"{place + 1}. " if len(course.lesson.steps) > 1 else ""
        yield _text(number + step.title, self._width, TITLE_PT, title=True)
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
                yield _text(part.posed(), self._width, TEXT_PT)
                yield self._lines(LINES_BELOW * RULE_PT)
                continue
            yield _text(part.told(answer_of(part, here)), self._width, TEXT_PT)
            whys = [part.why] if part.why else []
            if part.show is not None:
                after = here.shown_by(part.show)
                yield from self._with_figure(after, whys, "")
                if "equation" not in after.view.slide:
                    yield from _panel(after, shown, self._width)
                elif after.view.equation != shown.view.equation:
                    yield from _equation(after, self._width)
            else:
                yield from (_text(why, self._width, TEXT_PT) for why in whys)

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
        figure = _figure(document, self._width, self._figure_width)
        drawn = QImage(str(slide)) if slide is not None and slide.is_file() else QImage()
        if not drawn.isNull():
            figure = _picture(drawn, self._width)
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

        while texts and fits(block := _text(texts[0], room, TEXT_PT)):
            beside.append(block)
            texts = texts[1:]
        if note and fits(block := _text(note, room, NOTE_PT, left=NOTE_INDENT_PT)):
            beside.append(block)
            note = ""
        if not self._answers:
            used = sum(each.height + BETWEEN_PT for each in beside)
            beside.append(_ruled(room, figure.height - used))
        yield _beside(figure, beside, left)
        yield from self._below(texts, note)

    def _below(self, texts: Iterable[str], note: str) -> Iterator[Block]:
        yield from (_text(text, self._width, TEXT_PT) for text in texts)
        if note:
            yield _text(note, self._width, NOTE_PT, left=NOTE_INDENT_PT)

    def _lines(self, height: float) -> Block:
        return _ruled(self._width, height)


def _beside(figure: Block, others: Sequence[Block], left: float) -> Block:
    """A figure, and blocks below each other beside it."""
    right = sum(block.height for block in others) + BETWEEN_PT * max(0, len(others) - 1)

    def paint(painter: QPainter, part: QRectF) -> None:
        figure.paint(painter, part)
        painter.translate(left, 0.0)
        for block in others:
            _paint_block(painter, block, QRectF(0.0, 0.0, part.width() - left, block.height))
            painter.translate(0.0, block.height + BETWEEN_PT)

    return Block(max(figure.height, right), paint)


def _ruled(width: float, height: float) -> Block:
    """Lines to write on."""

    def paint(painter: QPainter, part: QRectF) -> None:
        painter.setPen(QPen(QColor(LIGHT.muted), 0.6))
        for number in range(1, int(height / RULE_PT + 0.5) + 1):
            y = number * height / max(1, int(height / RULE_PT + 0.5))
            if part.top() <= y <= part.bottom() + 0.5:
                painter.drawLine(QPointF(0.0, y), QPointF(width, y))

    return Block(height, paint)


def _picture(image: QImage, width: float) -> Block:
    """A picture across the page."""
    place = QRectF(0.0, 0.0, width, width * image.height() / image.width())

    def paint(painter: QPainter, _part: QRectF) -> None:
        painter.drawImage(place, image)
        painter.setPen(QPen(QColor(LIGHT.muted), 0.6))
        painter.drawRect(place)

    return Block(place.height(), paint, wide=width)


def _figure(document: Document, width: float, one_pane: float) -> Block:
    """The picture of a state: one pane, or the compared pictures across the page."""
    scene = scene_of(document)
    large = document.view.large or scene.leading
    panes = [pane for pane in document.view.slide if pane in PANES] or [large]
    is_image = panes == ["image"]
    count = len(document.view.compare) if is_image else 0
    aspect = document.projection.aspect if is_image else PANE_ASPECT
    wide, high = one_pane, one_pane / PANE_ASPECT
    if len(panes) > 1:
        wide, high = width, width / (len(panes) * PANE_ASPECT)
    elif count and not document.view.dividers:
        wide, high = width, width / (count * aspect) + 3.0 * FIGURE_TEXT_PT
    elif is_image:
        wide = min(one_pane, high * aspect)
        high = wide / aspect
    px_per_pt = FIGURE_PX_PER_INCH / 72.0

    @cache
    def drawn() -> QImage:
        return image_of(
            render(
                scene,
                document.projection,
                panes=panes,
                size=(round(wide * px_per_pt), round(high * px_per_pt)),
                style=LIGHT,
                view=document.view,
                settings=document.settings,
                quality=document.quality,
                text_pt=FIGURE_TEXT_PT * FIGURE_PX_PER_INCH / DPI_OF_FIGURES,
            )
        )

    def paint(painter: QPainter, _part: QRectF) -> None:
        place = QRectF(0.0, 0.0, wide, high)
        painter.drawImage(place, drawn())
        if is_image and not count:
            painter.setPen(QPen(QColor(LIGHT.muted), 0.6))
            painter.drawRect(place)

    return Block(high, paint, wide=wide)


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
        blocks.append(_text("\n".join(lines), width, NOTE_PT))
    row: list[Block] = []
    for block in blocks:
        if row and sum(each.wide + BETWEEN_PT for each in row) + block.wide > width:
            yield _in_row(row)
            row = []
        row.append(block)
    yield _in_row(row)


def _in_row(blocks: Sequence[Block]) -> Block:
    def paint(painter: QPainter, part: QRectF) -> None:
        for block in blocks:
            painter.save()
            block.paint(painter, part)
            painter.restore()
            painter.translate(block.wide + BETWEEN_PT, 0.0)

    return Block(max(block.height for block in blocks), paint)


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
        yield _text("\n".join(rows), width, NOTE_PT)
    for reason in dict.fromkeys(reasons):
        yield _text(escaped(reason), width, NOTE_PT)
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


# --------------------------------------------------------------------------- pages


class Piece(NamedTuple):
    """What of a block is on a page, and where."""

    block: Block
    y: float
    begin: float
    height: float


class Page(NamedTuple):
    pieces: list[Piece]
    blank: float
    """Of its height, below the last piece."""


def paged(course: Course, width: float, height: float, answers: bool) -> list[Page]:
    """Place a talk on pages, with figures of the width that fills them best."""
    sheets = (_Sheet(course, width, part, answers) for part in FIGURE_WIDTHS)
    return _best([_placed(sheet, height) for sheet in sheets])


def _placed(sheet: _Sheet, height: float) -> list[Page]:
    """Place blocks below each other, and begin a new page for one that does not fit."""
    blocks = [*sheet.head(), *sheet.steps()]
    pages, pieces, y = list[Page](), list[Piece](), 0.0

    def turn() -> None:
        nonlocal pieces, y
        end = max((piece.y + piece.height for piece in pieces), default=0.0)
        pages.append(Page(pieces, 1.0 - end / height))
        pieces, y = [], 0.0

    for number, block in enumerate(blocks):
        needed, place = block.height, number
        while blocks[place].kept and place + 1 < len(blocks):
            needed += blocks[place].after + blocks[place + 1].height
            place += 1
        if y > 0.0 and y + needed > height:
            turn()
        done = 0.0
        while True:
            part = min(block.height - done, height - y)
            pieces.append(Piece(block, y, done, part))
            y, done = y + part, done + part
            if done >= block.height - 0.5:
                break
            turn()
        y += block.after
    turn()
    return pages


def _best(layouts: Sequence[list[Page]]) -> list[Page]:
    """The first of the layouts whose pages are full enough, or the one with the fullest pages."""

    def emptiest(pages: list[Page]) -> float:
        return max(page.blank for page in pages)

    full = (pages for pages in layouts if emptiest(pages) <= BLANK)
    return next(full, min(layouts, key=emptiest))


def _paint_page(painter: QPainter, page: Page, width: float, height: float, is_ruled: bool) -> None:
    """Paint a page; what is blank becomes space between its blocks, or lines to write on."""
    blank = page.blank * height
    gaps = sum(not piece.block.kept for piece in page.pieces[:-1])
    more = 0.0 if is_ruled else min(blank / max(1, gaps), BETWEEN_STEPS_PT)
    down = 0.0
    for piece in page.pieces:
        painter.save()
        painter.translate(0.0, piece.y + down - piece.begin)
        _paint_block(painter, piece.block, QRectF(0.0, piece.begin, width, piece.height))
        painter.restore()
        down += 0.0 if piece.block.kept else more
    if is_ruled and blank > 2.0 * RULE_PT:
        painter.save()
        painter.translate(0.0, height - blank + BETWEEN_PT)
        _ruled(width, blank - BETWEEN_PT).paint(painter, QRectF(0.0, 0.0, width, blank))
        painter.restore()


def _paint_block(painter: QPainter, block: Block, part: QRectF) -> None:
    painter.save()
    if block.left:
        line = QRectF(0.25 * block.left, part.top(), 1.5, part.height())
        painter.fillRect(line, QColor(LIGHT.near))
    painter.translate(block.left, 0.0)
    block.paint(painter, QRectF(0.0, part.top(), part.width() - block.left, part.height()))
    painter.restore()


def _foot(painter: QPainter, title: str, number: int, width: float, height: float) -> None:
    painter.save()
    font = QFont("DejaVu Sans")
    font.setPointSizeF(FOOT_PT * 72.0 / DPI)
    painter.setFont(font)
    painter.setPen(QColor(LIGHT.muted))
    place = QRectF(0.0, height + 0.7 * FOOT_PT, width, 1.3 * FOOT_PT)
    painter.drawText(place, Qt.AlignmentFlag.AlignLeft, title)
    painter.drawText(place, Qt.AlignmentFlag.AlignRight, str(number))
    painter.restore()
