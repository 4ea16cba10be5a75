"""A talk as a PDF of A4 pages: each step with its figure, the text for the class, and the notes.

The matrices or the scene's numbers stand below the figure of a state that opens their panel. No
display is needed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from textwrap import wrap

from PySide6.QtCore import QBuffer, QCoreApplication, QMarginsF, QPointF, QRectF, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QGuiApplication,
    QPageLayout,
    QPageSize,
    QPainter,
    QPdfWriter,
)

from app.document.document import Document
from app.document.view import PANES
from app.drawings.figures import render
from app.drawings.style import LIGHT
from app.lecture.notation import matrices
from app.lessons.course import Course, scene_of
from app.lessons.lesson import Step
from app.lessons.text import escaped
from widgets.controls.readout import full_sentence, value_text
from widgets.panels.matrix_panel import note_on
from widgets.parts.lesson_text import answer_of, set_text
from widgets.parts.messages import of_phenomena, read_text, stage_title
from widgets.parts.plain import TextDocument
from widgets.parts.typeset import Typeset, matrix, typeset
from widgets.window.pictures import image_of

MARGIN_MM = 18.0
TEXT_PT, TITLE_PT, NOTE_PT, FOOT_PT = 10.5, 15.0, 9.5, 8.0
BETWEEN_PT, BETWEEN_STEPS_PT = 6.0, 20.0
NOTE_INDENT_PT = 12.0
FIGURE_PX = (1400, 500)
"""Width of a figure of two panes across the page, about 200 pixels per inch."""
DPI = 1200
"""Qt places lines and letters on whole pixels of the page."""
FORMULA_PX, FORMULA_PT = 18, 8.5
"""Letters of a matrix as it is laid out, with brackets of whole pixels, and as it is printed."""
BETWEEN_FORMULAS_PX = 40.0
NOTE_CHARACTERS = 36
"""Line length of a matrix's note, so that it is not wider than the matrix."""


def handout(course: Course) -> bytes:
    """Return a talk as the content of a PDF file; a `Refusal` if a state is impossible."""
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
    painter = QPainter(writer)
    painter.setRenderHint(QPainter.RenderHint.LosslessImageRendering)
    painter.scale(DPI / 72.0, DPI / 72.0)
    page = QRectF(writer.pageLayout().paintRect(QPageLayout.Unit.Point))
    pages = _Pages(painter, writer, page.width(), page.height(), course.lesson.title)
    try:
        pages.head(course)
        for place, step in enumerate(course.lesson.steps):
            pages.put(list(_blocks(course, place, step, page.width())))
        pages.foot()
    finally:
        painter.end()
    return bytes(buffer.data().data())


@dataclass
class _Block:
    """A part of a page over its width, in points; `kept` on the same page as the next one."""

    height: float
    paint: Callable[[QPainter, QRectF], object]
    """Paints the part of the block in a rectangle."""
    left: float = 0.0
    kept: bool = False


def _text(
    text: str, width: float, size: float, *, title: bool = False, left: float = 0.0
) -> _Block:
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
    return _Block(document.size().height(), document.drawContents, left, kept=title)


def _blocks(course: Course, place: int, step: Step, width: float) -> Iterator[_Block]:
    """Yield a step's title, figure, text, and its notes with the planned minutes."""
    count = len(course.lesson.steps)
    number = f"{place + 1}. " if count > 1 else ""
    yield _text(number + step.title, width, TITLE_PT, title=True)
    shown = course.shown(place).document
    yield _figure(shown, width)
    yield from _panel(shown, course.shown(place - 1).document if place else None, width)
    here = course.at(place)
    for part in step.parts:
        yield _text(part.told(answer_of(part, here)), width, TEXT_PT)
        if part.show is not None:
            after = here.shown_by(part.show)
            yield _figure(after, width)
            yield from _panel(after, shown, width)
        if part.why:
            yield _text(part.why, width, TEXT_PT)
    if step.note is not None:
        minutes = f"*{step.note.minutes:g} min.* " if step.note.minutes else ""
        if minutes or step.note.text:
            yield _text(minutes + step.note.text, width, NOTE_PT, left=NOTE_INDENT_PT)


def _figure(document: Document, width: float) -> _Block:
    """Draw the world and the leading pane, or the world and the image."""
    scene = scene_of(document)
    leading = document.view.large or scene.leading
    pixels = render(
        scene,
        document.projection,
        panes=(PANES[0], leading if leading != PANES[0] else PANES[2]),
        size=FIGURE_PX,
        style=LIGHT,
        view=document.view,
        settings=document.settings,
        quality=document.quality,
    )
    image = image_of(pixels)
    place = QRectF(0.0, 0.0, width, width * image.height() / image.width())
    return _Block(place.height(), lambda painter, _part: painter.drawImage(place, image))


def _panel(document: Document, before: Document | None, width: float) -> Iterator[_Block]:
    """Yield the numbers of the open panel, unless they are the same as in the previous state."""
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


def _readout(document: Document, width: float) -> Iterator[_Block]:
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


def _side_by_side(formulas: Iterable[str], width: float) -> Iterator[_Block]:
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
        yield _Block(scale * max(part.descent for part in row), partial(_paint_row, row))


def _paint_row(row: Sequence[Typeset], painter: QPainter, _part: QRectF) -> None:
    painter.scale(FORMULA_PT / FORMULA_PX, FORMULA_PT / FORMULA_PX)
    for formula in row:
        formula.paint(painter, 0.0, 0.0)


class _Pages:
    """Places blocks below each other, and begins a new page for a block that does not fit."""

    def __init__(
        self, painter: QPainter, writer: QPdfWriter, width: float, height: float, title: str
    ) -> None:
        self._painter, self._writer, self._title = painter, writer, title
        self._width, self._height = width, height - 2.0 * FOOT_PT
        self._y, self._number = 0.0, 1

    def head(self, course: Course) -> None:
        minutes = course.lesson.minutes or sum(
            step.note.minutes for step in course.lesson.steps if step.note is not None
        )
        self._draw(_text(course.lesson.title, self._width, 1.4 * TITLE_PT, title=True))
        if minutes:
            self._draw(_text(f"{minutes:g} min", self._width, TEXT_PT))

    def put(self, blocks: list[_Block]) -> None:
        """Draw the blocks of a step, on a new page if they fit there but not here."""
        if self._y > 0.0:
            self._y += BETWEEN_STEPS_PT
        whole = sum(block.height + BETWEEN_PT for block in blocks)
        if self._y + whole > self._height and whole <= self._height and self._y > 0.0:
            self._turn()
        for number, block in enumerate(blocks):
            needed = block.height
            if block.kept and number + 1 < len(blocks):
                needed += BETWEEN_PT + blocks[number + 1].height
            if self._y > 0.0 and self._y + needed > self._height:
                self._turn()
            self._draw(block)

    def foot(self) -> None:
        painter = self._painter
        painter.save()
        font = QFont("DejaVu Sans")
        font.setPointSizeF(FOOT_PT * 72.0 / DPI)
        painter.setFont(font)
        painter.setPen(QColor(LIGHT.muted))
        place = QRectF(0.0, self._height + 0.7 * FOOT_PT, self._width, 1.3 * FOOT_PT)
        painter.drawText(place, Qt.AlignmentFlag.AlignLeft, self._title)
        painter.drawText(place, Qt.AlignmentFlag.AlignRight, str(self._number))
        painter.restore()

    def _turn(self) -> None:
        self.foot()
        self._writer.newPage()
        self._number += 1
        self._y = 0.0

    def _draw(self, block: _Block) -> None:
        """Draw a block, on several pages if it is too long for one."""
        done = 0.0
        while True:
            part = min(block.height - done, self._height - self._y)
            self._paint(block, done, part)
            self._y += part + BETWEEN_PT
            done += part
            if done >= block.height - 0.5:
                return
            self._turn()

    def _paint(self, block: _Block, begin: float, part: float) -> None:
        painter, left = self._painter, block.left
        painter.save()
        if left:
            line = QRectF(0.25 * left, self._y, 1.5, part)
            painter.fillRect(line, QColor(LIGHT.near))
        painter.translate(QPointF(left, self._y - begin))
        block.paint(painter, QRectF(0.0, begin, self._width - left, part))
        painter.restore()
