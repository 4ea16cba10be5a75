"""A test on paper: the exercises of a variant with their pictures and room to write, and the key.

Every exercise is whole on one page. What is blank on a page becomes room to write. No display is
needed.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication, QLineF, QPointF, QRectF
from PySide6.QtGui import QColor, QPainter, QPen

from app.document.document import Document
from app.document.view import PANES
from app.drawings.style import LIGHT
from app.lessons.blocks.block import Asked, Here, Variant
from app.lessons.course import panes_of
from app.lessons.lines import refused
from app.lessons.practice import PlacedExercise
from app.lessons.text import escaped
from app.model.refusal import REFUSALS
from widgets.parts.lesson_text import answer_of
from widgets.parts.messages import FEW, figure_text
from widgets.parts.translator import off_screen_application
from widgets.parts.typeset import paint_brackets
from widgets.program import paper

FIGURE_WIDTHS = (0.5, 0.46, 0.42, 0.38)
"""Possible widths of a figure, as parts of the page's: the largest one that needs few pages."""
CLICKED, IN_KEY = 0.62, 0.4
"""Width of a figure in which the student marks a place, and of the same figure in the key."""
COLUMN = 0.3  # least width of a text beside a figure, as a part of the page's
SQUARE_PT = 72.0 / 25.4 * 5.0  # side of a square of the paper on which the student writes: 5 mm
ROOM_PT = 5.0 * SQUARE_PT  # least height of the room to write
CELL_PT = 56.0, 24.0  # width and height of a cell of a matrix that the student fills in
LINE_PT = 120.0  # length of the line for a number
BRACKET_PT = 4.0


class Numbered(NamedTuple):
    title: str
    placed: PlacedExercise
    variant: Variant

    @property
    def is_sketch(self) -> bool:
        """Whether its picture has other numbers, so that nothing can be measured in it."""
        return "scale" in self.placed.exercise.hides

    @property
    def drawn(self) -> Document:
        """The state of its picture."""
        return (self.placed if self.is_sketch else self.variant).here.document

    @property
    def panes(self) -> list[str]:
        """The panes to draw: that of the click, or those of the state that are not hidden."""
        if self.variant.question.pane:
            return [self.variant.question.pane]
        hides = self.placed.exercise.hides
        seen = [pane for pane in panes_of(self.drawn) if pane not in hides]
        return seen or [pane for pane in PANES if pane not in hides][:1]


def exam(name: str, seed: int, exercises: Sequence[Numbered], check: Callable[[], object]) -> bytes:
    """Return a test as the content of a PDF file; a `Refusal` if a state is impossible.

    `check` is called before each page; it may raise an exception.
    """
    off_screen_application()  # which translates
    title = QCoreApplication.translate("Exam", "Test: {0}").format(name)
    left = QCoreApplication.translate("Exam", "{0}, variant {1}").format(title, seed)

    def lay_out(width: float, height: float) -> Iterator[paper.PaintPage]:
        head = _head(title, seed, width)
        pages, gap = paged(exercises, head, width, height), paper.BETWEEN_STEPS_PT

        def paint(number: int, painter: QPainter) -> None:
            parts, y = pages[number - 1], 0.0
            room = height - sum(part.height + gap for part in parts) + gap
            if number == 1:
                head.draw(painter, 0.0, 0.0)
                y = head.height + gap
                room -= y
            for part in parts:
                high = part.height + room / len(parts)
                part.draw(painter, 0.0, y, QRectF(0.0, 0.0, width, high))
                y += high + gap
            paper.foot(painter, left, f"{number} / {len(pages)}", width, height)

        for number in range(1, len(pages) + 1):
            check()
            yield partial(paint, number)

    return paper.pdf(left, lay_out)


def key(
    name: str,
    variants: Sequence[tuple[int, Sequence[Numbered]]],
    note: str,
    check: Callable[[], object],
) -> bytes:
    """Return the answers of all variants, with their ways, as the content of a PDF file.

    `check` as for `exam`.
    """
    off_screen_application()
    title = QCoreApplication.translate("Exam", "Key: {0}").format(name)

    def lay_out(width: float, height: float) -> Iterator[paper.PaintPage]:
        blocks = [paper.text(title, width, 1.4 * paper.TITLE_PT, title=True)]
        if note:
            blocks.append(paper.text(note, width, paper.TEXT_PT))
        seeds = {id(block): variants[0][0] for block in blocks}
        for seed, exercises in variants:
            blocks[-1].after = paper.BETWEEN_STEPS_PT
            variant = QCoreApplication.translate("Exam", "Variant {0}").format(seed)
            added = [paper.text(variant, width, paper.TITLE_PT, title=True)]
            for number, each in enumerate(exercises, 1):
                added += _answer(number, each, width)
            seeds |= {id(block): seed for block in added}
            blocks += added
        pages = paper.placed(blocks, height)

        for number, page in enumerate(pages, 1):
            check()
            first, last = (seeds[id(page.pieces[place].block)] for place in (0, -1))
            shown = f"{first}" if first == last else f"{first}–{last}"
            left = QCoreApplication.translate("Exam", "{0}, variant {1}").format(title, shown)
            yield partial(paper.paint_page, page, left, f"{number} / {len(pages)}", width, height)

    return paper.pdf(title, lay_out)


def _answer(number: int, exercise: Numbered, width: float) -> Iterator[paper.PageBlock]:
    """Yield the answer of an exercise and the way to it; a place is marked in its picture."""
    question, here = exercise.variant.question, exercise.variant.here
    answer = answer_of(question, here)
    parts = [f"**{number}.** {question.with_answer(answer, others=False)}"]
    place = question.marked_place(here)
    parts += question.reasons(here)
    texts = "\n\n".join(filter(None, (*parts, _mistaken(question, here))))
    if place is None:
        yield paper.text(texts, width, paper.TEXT_PT)
        return
    mark = paper.MarkedPlace(*place)
    figure = paper.figure(here.document, width, IN_KEY * width, exercise.panes, mark)
    left = figure.wide + paper.NOTE_INDENT_PT
    yield paper.beside(figure, [paper.text(texts, width - left, paper.TEXT_PT)], left)


def _mistaken(question: Asked, here: Here) -> str:
    """Return the wrong ideas with the answers that they lead to, a line each."""
    mistakes = question.mistakes(here, lambda number: figure_text(number, FEW))
    lines = [f"{escaped(idea)}: {answer}" for idea, answer in mistakes]
    if not lines:
        return ""
    return "  \n".join((QCoreApplication.translate("Exam", "Wrong ideas:"), *lines))


# --------------------------------------------------------------------------- a page of a test


def _head(title: str, seed: int, width: float) -> paper.PageBlock:
    """The title and lines for name and date."""
    variant = QCoreApplication.translate("Exam", "Variant {0}").format(seed)
    top = paper.text(title, width, paper.TITLE_PT, title=True)
    side = paper.text(variant, width, paper.TEXT_PT)
    name = paper.text(QCoreApplication.translate("Exam", "Name"), width, paper.TEXT_PT)
    date = paper.text(QCoreApplication.translate("Exam", "Date"), width, paper.TEXT_PT)
    below = top.height + paper.RULE_PT

    def paint(painter: QPainter, part: QRectF) -> None:
        top.draw(painter, 0.0, 0.0)
        side.draw(painter, width - side.wide, top.height - side.height)
        for block, begin, end in ((name, 0.0, 0.62), (date, 0.66, 1.0)):
            block.draw(painter, begin * width, below - block.height)
            _line(painter, begin * width + block.wide + paper.BETWEEN_PT, end * width, below)

    return paper.PageBlock(below, paint)


def paged(
    exercises: Sequence[Numbered], head: paper.PageBlock, width: float, height: float
) -> list[list[paper.PageBlock]]:
    """Place exercises on few pages that are about equally full, with figures as wide as fit."""
    layouts = []
    for share in FIGURE_WIDTHS:
        parts = [_part(n, each, width, share) for n, each in enumerate(exercises, 1)]
        first = head.height + paper.BETWEEN_STEPS_PT
        least = [part.height + first * (number == 0) for number, part in enumerate(parts)]
        longest = max(range(len(parts)), key=least.__getitem__)
        if least[longest] > height:
            raise refused(exercises[longest].variant.question.line, REFUSALS["exam-too-long"])
        count = len(_ends(least, height))
        low, high = least[longest], height
        for _ in range(20):  # the least height with which they need no more pages
            middle = (low + high) / 2.0
            low, high = (low, middle) if len(_ends(least, middle)) == count else (middle, high)
        ends = _ends(least, high)
        layouts.append([parts[a:b] for a, b in zip([0, *ends[:-1]], ends, strict=True)])
    return min(layouts, key=len)


def _ends(heights: Sequence[float], height: float) -> list[int]:
    """Return where pages end that are filled one after the other."""
    ends, used = list[int](), 0.0
    for place, each in enumerate(heights):
        if used and used + each > height:
            ends.append(place)
            used = 0.0
        used += each + paper.BETWEEN_STEPS_PT
    return [*ends, len(heights)]


def _part(number: int, exercise: Numbered, width: float, share: float) -> paper.PageBlock:
    """An exercise of the least height: title, text and picture, room to write, and the answer."""
    question = exercise.variant.question
    title = paper.text(f"{number}. {exercise.title}", width, 1.1 * paper.TEXT_PT, title=True)
    figure = None
    if exercise.panes:
        figure = paper.figure(
            exercise.drawn, width, (CLICKED if question.pane else share) * width, exercise.panes
        )
        if exercise.is_sketch:
            said = QCoreApplication.translate("Exam", "A sketch, not to scale.")
            figure = paper.below(figure, paper.text(said, figure.wide, paper.FOOT_PT))
    told = [*(part.text for part in exercise.placed.words), question.posed()]
    if question.pane:
        told.append(
            QCoreApplication.translate("Exam", "Mark the place in the picture with a cross.")
        )
    asked = "\n\n".join(told)
    room = width - (figure.wide + paper.NOTE_INDENT_PT if figure is not None else 0.0)
    body = paper.text(asked, max(room, COLUMN * width), paper.TEXT_PT)
    is_beside = room >= COLUMN * width and body.wide <= room + 0.5
    if not is_beside:
        body = paper.text(asked, width, paper.TEXT_PT)
    top = title.height + paper.BETWEEN_PT
    picture_top = top if is_beside else top + body.height + paper.BETWEEN_PT
    high = figure.height if figure is not None else 0.0
    body_end = top + body.height + paper.BETWEEN_PT
    picture_end = max(body_end, picture_top + high + paper.BETWEEN_PT)
    answer = _place_of_answer(question)
    # Beside the picture, below the text, there may already be room enough.
    squares = picture_end - paper.BETWEEN_PT - body_end
    is_roomy = squares >= ROOM_PT and room >= COLUMN * width
    needs_room = question.is_worked and not is_roomy
    least = picture_end + (ROOM_PT + paper.BETWEEN_PT) * needs_room + answer.height

    def paint(painter: QPainter, place: QRectF) -> None:
        height = place.height()
        title.draw(painter, 0.0, 0.0)
        body.draw(painter, 0.0, top)
        if figure is not None:
            figure.draw(painter, width - figure.wide if is_beside else 0.0, picture_top)
        if is_roomy:
            left = 0.0 if is_beside else width - room
            _squares(painter, QRectF(left, body_end, room, squares))
        free = height - answer.height - picture_end - paper.BETWEEN_PT
        _squares(painter, QRectF(0.0, picture_end, width, free))
        answer.draw(painter, 0.0, height - answer.height)

    return paper.PageBlock(least, paint)


def _place_of_answer(question: Asked) -> paper.PageBlock:
    """The line for a number or a choice, or the cells of a matrix; nothing for a place."""
    rows, columns = question.shape
    if not rows:
        return paper.PageBlock(0.0, lambda *_: None)
    word = paper.text(QCoreApplication.translate("Exam", "Answer:"), 200.0, paper.TEXT_PT)
    unit = paper.text(question.unit, 200.0, paper.TEXT_PT)
    is_matrix = rows * columns > 1
    wide, high = CELL_PT if is_matrix else (LINE_PT, paper.RULE_PT)
    left = word.wide + paper.BETWEEN_PT + BRACKET_PT * is_matrix
    right, low = left + columns * wide, rows * high

    def paint(painter: QPainter, _part: QRectF) -> None:
        middle = low / 2.0 if is_matrix else low - word.height / 2.0
        word.draw(painter, 0.0, middle - word.height / 2.0)
        unit.draw(painter, right + 2.0 * BRACKET_PT, middle - unit.height / 2.0)
        if not is_matrix:
            _line(painter, left, right, low)
            return
        painter.setPen(QPen(QColor(LIGHT.muted), 0.6))
        for row in range(rows):
            for column in range(columns):
                cell = QRectF(left + column * wide, row * high, wide, high)
                painter.drawRect(cell.adjusted(2.0, 2.0, -2.0, -2.0))
        painter.setPen(QPen(QColor(LIGHT.ink), 1.0))
        box = QRectF(left - BRACKET_PT, 0.0, right - left + 2.0 * BRACKET_PT, low)
        paint_brackets(painter, box, BRACKET_PT)

    return paper.PageBlock(low, paint)


def _line(painter: QPainter, left: float, right: float, y: float) -> None:
    painter.setPen(QPen(QColor(LIGHT.muted), 0.6))
    painter.drawLine(QPointF(left, y), QPointF(right, y))


def _squares(painter: QPainter, place: QRectF) -> None:
    """Squares to write on, as many as are whole."""
    rows, columns = (int(side / SQUARE_PT) for side in (place.height(), place.width()))
    if rows < 2:
        return
    painter.setPen(QPen(QColor(LIGHT.muted).lighter(190), 0.3))
    left, top = place.left(), place.top()
    right, low = left + columns * SQUARE_PT, top + rows * SQUARE_PT
    lines = [QLineF(left, y, right, y) for y in (top + n * SQUARE_PT for n in range(rows + 1))]
    lines += (QLineF(x, top, x, low) for x in (left + n * SQUARE_PT for n in range(columns + 1)))
    painter.drawLines(lines)
