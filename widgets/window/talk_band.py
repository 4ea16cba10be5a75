"""The band of text for the class during a talk: above the panes, never over them."""

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

from app.lessons.lesson import Lesson, Step
from app.lessons.text import plain_of
from widgets.parts.lesson_text import set_text
from widgets.parts.plain import TextDocument

SHARE, TALL_SHARE = 0.135, 0.18
"""Height of the band in screen heights. It is the same throughout a talk, so that no step moves a
pane; the second one is used if a step has a table, a displayed formula or many choices."""
LEAST_TEXT_SHARE, MOST_SHARE = 0.022, 1.0 / 3.0
"""Least text size and largest height of the band, in screen heights: the band grows up to this
height for a long step, and then the wheel scrolls it."""
TITLE_EM = 1.3
"""Size of the title relative to the text."""
SIZES = (1.2, 1.12, 1.06, 1.0, 0.92, 0.84, 0.76, 0.68, 0.6)
"""Text sizes relative to the window's: the largest that fits is used."""
SIDE_SHARE = 0.48
"""Share of the band's width for the second column."""
_GAP_PX, _EDGE_PX = 10, 2


class TalkBand(QFrame):
    """A step's title, text and questions, as large as they fit."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("talkBand")
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._title, self._words, self._asked = (TextDocument(self) for _ in range(3))
        self._number, self.note = "", ""
        self._ways: list[tuple[str, str]] = [("", "")]
        """The possible layouts: the text, and the second column."""
        self._screen_px = 0.0
        self._usual_px = 0
        """The band's height, unless a step is too long."""
        self._moved_px = 0
        """How far the wheel has scrolled the band."""
        self.hide()

    def set_talk(self, lesson: Lesson, screen_px: float) -> None:
        """Set the band's height for all steps of a talk from the height of the screen."""
        is_tall = any(part.is_tall for step in lesson.steps for part in step.parts)
        share = TALL_SHARE if is_tall else SHARE
        self._screen_px, self._usual_px = screen_px, round(share * screen_px)
        self.setFixedHeight(self._usual_px)

    def show_step(self, step: Step, number: str, asked: str = "") -> None:
        """Show a step, and beside its text the current question, or its answer."""
        self._number = number
        words = [part.text for part in step.parts if not part.reveals]
        self.setAccessibleName(plain_of("\n\n".join([step.title, *words, asked])))
        set_text(self._title, step.title, title=True, palette=self.palette())
        paragraphs = "\n\n".join(words).split("\n\n")
        if asked:
            self._ways = [("\n\n".join(paragraphs), asked)]
        else:  # below each other, or the last of them in the second column
            cuts = range(len(paragraphs), 0, -1)
            self._ways = [
                ("\n\n".join(paragraphs[:cut]), "\n\n".join(paragraphs[cut:])) for cut in cuts
            ]
        self._moved_px = 0
        self._fit_all()

    def say(self, note: str) -> None:
        """Show a message beside the number of the step; an empty one hides it."""
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
        """Return those of `SIZES` that are readable from the last row."""
        em = self.fontInfo().pixelSize()
        least = LEAST_TEXT_SHARE * self._screen_px
        return tuple(size for size in SIZES if round(size * em) >= least) or (least / em,)

    @property
    def _needed_px(self) -> int:
        """Return the height of the text in its current layout."""
        words = self._title.size().height() + self._words.size().height()
        beside = 0.0 if self._asked.isEmpty() else self._asked.size().height()
        return math.ceil(max(words, beside) + 2 * _EDGE_PX)

    @property
    def _room(self) -> QRectF:
        return QRectF(self.rect()).adjusted(_GAP_PX, _EDGE_PX, -_GAP_PX, -_EDGE_PX)

    def _columns(self) -> tuple[QRectF, QRectF]:
        """Return the areas of the text and of the second column, which may be empty."""
        room = self._room
        if self._asked.isEmpty():
            return room, QRectF()
        left, right = QRectF(room), QRectF(room)
        left.setWidth((1.0 - SIDE_SHARE) * room.width() - _GAP_PX)
        right.setLeft(room.right() - SIDE_SHARE * room.width() + _GAP_PX)
        return left, right

    def _fit_all(self) -> None:
        """Choose the layout that allows the largest text; if none fits, make the band higher."""
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
        """Lay out the text in the largest size that fits, else in the smallest; return the size."""
        set_text(self._words, words, palette=self.palette())
        set_text(self._asked, beside, palette=self.palette())
        sizes = self._sizes
        low, high = 0, len(sizes) - 1  # the last one if none fits
        while low < high:
            middle = (low + high) // 2
            low, high = (low, middle) if self._fits(sizes[middle]) else (middle + 1, high)
        self._fits(sizes[low])
        return sizes[low]

    def _fits(self, size: float) -> bool:
        """Lay out everything in a text size; return whether it fits."""
        left, right = self._columns()
        em = self.fontInfo().pixelSize()
        free = self.fontMetrics().horizontalAdvance(f"{self._number}  ")  # for the number
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
        if note:  # over the text that is there
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
