"""What the class reads of a talk's step while it is presented: above the panes, never over them."""

from __future__ import annotations

import math

from PySide6.QtCore import QEvent, QPointF, QRectF, Qt
from PySide6.QtGui import (
    QAbstractTextDocumentLayout,
    QFont,
    QPainter,
    QPaintEvent,
    QPalette,
    QResizeEvent,
    QTextDocument,
    QWheelEvent,
)
from PySide6.QtWidgets import QFrame, QSizePolicy

from app.lessons.lesson import Lesson, Question, Step, Task, Words
from app.lessons.text import plain_of
from widgets.parts.lesson_text import set_text
from widgets.parts.plain import TextDocument

SHARE, TALL_SHARE = 0.135, 0.18
"""Of the screen's height, for the band: the same all through a talk, so that no pane moves at a
step; the latter where a step has a table, formulas on lines of their own, or many choices."""
LEAST_TEXT_SHARE, MOST_SHARE = 0.022, 1.0 / 3.0
"""Of the screen's height: letters are never smaller; rather the band of a step that says much
grows, so far, and the wheel moves what it says."""
TITLE_EM = 1.3
"""Of the window's letters, which are a share of the screen's height already."""
SIZES = (1.2, 1.12, 1.06, 1.0, 0.92, 0.84, 0.76, 0.68, 0.6)
"""Letters of a step that says little, and of one that says much, against the window's."""
SIDE_SHARE = 0.48
"""Of the band's width, for what stands beside the words."""
MANY_CHOICES = 4
_GAP_PX, _EDGE_PX = 10, 2


class TalkBand(QFrame):
    """A step's title, words and questions, as large as there is room for.

    Attributes
    ----------
    note : str
        What is said beside the number of the step for a moment.
    """

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("talkBand")
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._title, self._words, self._asked = (TextDocument(self) for _ in range(3))
        self._number, self.note = "", ""
        self._ways: list[tuple[str, str]] = [("", "")]
        """The words, and what stands beside them: as it may be shared out."""
        self._screen_px = 0.0
        self._usual_px = 0
        """Its height, unless a step says too much for it."""
        self._moved_px = 0
        """By the wheel."""
        self.hide()

    def set_talk(self, lesson: Lesson, screen_px: float) -> None:
        """Take a share of a screen of that height, for all of a talk."""
        share = TALL_SHARE if any(map(_is_tall, lesson.steps)) else SHARE
        self._screen_px, self._usual_px = screen_px, round(share * screen_px)
        self.setFixedHeight(self._usual_px)

    def show_step(self, step: Step, number: str, asked: str = "") -> None:
        """Show a step, and beside its words what is asked just now, or answered."""
        self._number = number
        words = [part.text for part in step.parts if isinstance(part, (Words, Task))]
        self.setAccessibleName(plain_of("\n\n".join([step.title, *words, asked])))
        self._set(self._title, step.title, title=True)
        paragraphs = "\n\n".join(words).split("\n\n")
        if asked:
            self._ways = [("\n\n".join(paragraphs), asked)]
        else:  # under each other, or the last of them beside the others
            cuts = range(len(paragraphs), 0, -1)
            self._ways = [
                ("\n\n".join(paragraphs[:cut]), "\n\n".join(paragraphs[cut:])) for cut in cuts
            ]
        self._moved_px = 0
        self._fit_all()

    def _set(self, document: QTextDocument, text: str, *, title: bool = False) -> None:
        line = self.palette().color(QPalette.ColorRole.Mid).name()
        set_text(document, text, title=title, line=line)

    def say(self, note: str) -> None:
        """Say something beside the number of the step; nothing says no more."""
        self.note = note
        self.update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self._fit_all()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.PaletteChange):
            self._fit_all()

    def wheelEvent(self, event: QWheelEvent) -> None:
        most = max(0, self._needed_px - self.height())
        moved = self._moved_px - round(event.angleDelta().y() / 120.0 * self.fontMetrics().height())
        self._moved_px = max(0, min(most, moved))
        self.update()

    @property
    def _sizes(self) -> tuple[float, ...]:
        """Those of `SIZES` that the last row can read."""
        em = self.fontInfo().pixelSize()
        least = LEAST_TEXT_SHARE * self._screen_px
        return tuple(size for size in SIZES if round(size * em) >= least) or (least / em,)

    @property
    def _needed_px(self) -> int:
        """The height in which all has room, as it is set."""
        words = self._title.size().height() + self._words.size().height()
        beside = 0.0 if self._asked.isEmpty() else self._asked.size().height()
        return math.ceil(max(words, beside) + 2 * _EDGE_PX)

    @property
    def _room(self) -> QRectF:
        """Without the edges."""
        return QRectF(self.rect()).adjusted(_GAP_PX, _EDGE_PX, -_GAP_PX, -_EDGE_PX)

    def _columns(self) -> tuple[QRectF, QRectF]:
        """Where the words stand, and where the question; in the whole width without one."""
        room = self._room
        if self._asked.isEmpty():
            return room, QRectF()
        left, right = QRectF(room), QRectF(room)
        left.setWidth((1.0 - SIDE_SHARE) * room.width() - _GAP_PX)
        right.setLeft(room.right() - SIDE_SHARE * room.width() + _GAP_PX)
        return left, right

    def _fit_all(self) -> None:
        """Find the way, and the largest letters, in which all of it has room; or make room."""
        self.setFixedHeight(self._usual_px or self.height())
        best, way = 0.0, self._ways[0]
        needed: dict[int, tuple[str, str]] = {}
        for each in self._ways:
            fit = self._share_out(*each)
            if not self._fits(fit):
                needed.setdefault(self._needed_px, each)
            elif fit > best:
                best, way = fit, each
            if best >= 1.0:
                break
        if best == 0.0:
            way = needed[min(needed)]
        self._share_out(*way)
        if best == 0.0:
            most = round(MOST_SHARE * self._screen_px)
            self.setFixedHeight(max(self.height(), min(most, self._needed_px)))
        self.update()

    def _share_out(self, words: str, beside: str) -> float:
        """Set it this way in the largest letters that have room, or in the smallest: these."""
        self._set(self._words, words)
        self._set(self._asked, beside)
        sizes = self._sizes
        low, high = 0, len(sizes) - 1  # the last is taken where nothing has room
        while low < high:
            middle = (low + high) // 2
            low, high = (low, middle) if self._fits(sizes[middle]) else (middle + 1, high)
        self._fits(sizes[low])
        return sizes[low]

    def _fits(self, size: float) -> bool:
        """Set everything in letters of a size, and tell whether it has room."""
        left, right = self._columns()
        em = self.fontInfo().pixelSize()
        free = self.fontMetrics().horizontalAdvance(f"{self._number}  ")  # which stands there
        for document, larger, width in (
            (self._title, TITLE_EM, left.width() - free * right.isNull()),
            (self._words, 1.0, left.width()),
            (self._asked, 1.0, right.width() - free),
        ):
            font = QFont(self.font())
            font.setPixelSize(max(8, round(size * larger * em)))
            document.setDefaultFont(font)
            document.setTextWidth(max(1.0, width))
        return self._needed_px <= self.height()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        painter = QPainter(self)
        left, right = (column.translated(0.0, -self._moved_px) for column in self._columns())
        self._draw(painter, self._title, left.topLeft())
        self._draw(painter, self._words, left.topLeft() + QPointF(0.0, self._title.size().height()))
        if not right.isNull():
            self._draw(painter, self._asked, right.topLeft())
            painter.setPen(self.palette().color(QPalette.ColorRole.Mid))
            x = right.left() - 1.5 * _GAP_PX
            painter.drawLine(QPointF(x, 4.0), QPointF(x, self.height() - 4.0))
        room = self._room
        painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
        right_of = Qt.AlignmentFlag.AlignRight
        painter.drawText(room, right_of | Qt.AlignmentFlag.AlignTop, self._number)
        note = self.note or ("▾" if self._moved_px + self.height() < self._needed_px else "")
        if note:  # over what stands there, for a moment
            below = right_of | Qt.AlignmentFlag.AlignBottom
            place = painter.boundingRect(room, below, note)
            painter.fillRect(place, self.palette().color(QPalette.ColorRole.Window))
            painter.drawText(room, below, note)
        painter.end()

    def _draw(self, painter: QPainter, document: QTextDocument, place: QPointF) -> None:
        painter.save()
        painter.translate(place)
        painter.setClipRect(QRectF(0.0, 0.0, document.textWidth(), self.height() - place.y()))
        context = QAbstractTextDocumentLayout.PaintContext()
        context.palette = self.palette()
        document.documentLayout().draw(painter, context)
        painter.restore()


def _is_tall(step: Step) -> bool:
    """Whether a step has what needs many lines."""
    return any(
        len(part.choices) >= MANY_CHOICES
        if isinstance(part, Question)
        else "$$" in part.text or "\n|" in part.text
        for part in step.parts
    )
