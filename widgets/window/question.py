"""A question that is put to a class, or its answer: it lies over the slide and moves nothing."""

from __future__ import annotations

import math

from PySide6.QtCore import QRect, QRectF
from PySide6.QtGui import (
    QAbstractTextDocumentLayout,
    QFont,
    QPainter,
    QPaintEvent,
    QPalette,
    QWheelEvent,
)
from PySide6.QtWidgets import QFrame, QWidget

from app.lessons.text import plain_of
from widgets.parts.lesson_text import set_text
from widgets.parts.plain import TextDocument

SHARE, WIDTH_SHARE = 1.0 / 3.0, 0.6
"""Largest height and width of the question, in those of the slide."""
LETTERS = (0.036, 0.033, 0.0305)
"""Sizes of the letters, in heights of the screen: the largest that fit are taken."""
EDGE_SHARE = 0.02
"""Free on each side, in heights of the screen."""


class Question(QFrame):
    """Lies over the lower left of a slide; what does not fit is reached by the wheel."""

    def __init__(self, slide: QWidget) -> None:
        super().__init__(slide)
        self.setObjectName("question")
        self._slide = slide
        self._document = TextDocument(self)
        self._screen_px, self._moved_px = 0.0, 0
        self.hide()

    def show_text(self, text: str, screen_px: float) -> None:
        """Show a text in Markdown; an empty one hides the question."""
        self._screen_px, self._moved_px = screen_px, 0
        self.setAccessibleName(plain_of(text))
        set_text(self._document, text, palette=self.palette())
        self.setVisible(bool(text))
        if text:
            self.place()
            self.raise_()

    def place(self) -> None:
        """Lie at the lower left, as small as the text is in the largest letters that fit."""
        room, edge = self._slide.rect(), EDGE_SHARE * self._screen_px
        most_px = WIDTH_SHARE * room.width() - 4.0 * edge, SHARE * room.height() - 2.0 * edge
        for share in LETTERS:
            font = QFont(self.font())
            font.setPixelSize(max(8, round(share * self._screen_px)))
            self._document.setDefaultFont(font)
            self._document.setTextWidth(max(1.0, most_px[0]))
            if self._document.size().height() <= most_px[1]:
                break
        width = math.ceil(min(self._document.idealWidth() + 1.0, self._document.textWidth()))
        self._document.setTextWidth(width)
        wide = math.ceil(width + 4.0 * edge)
        high = math.ceil(min(self._document.size().height(), most_px[1]) + 2.0 * edge)
        self.setGeometry(QRect(0, room.height() - high, wide, high))
        self.update()

    @property
    def _room(self) -> QRectF:
        edge = EDGE_SHARE * self._screen_px
        return QRectF(self.rect()).adjusted(2.0 * edge, edge, -2.0 * edge, -edge)

    def wheelEvent(self, event: QWheelEvent) -> None:
        most = max(0, round(self._document.size().height() - self._room.height()))
        moved = self._moved_px - round(event.angleDelta().y() / 120.0 * self.fontMetrics().height())
        self._moved_px = max(0, min(most, moved))
        event.accept()
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        painter, room = QPainter(self), self._room
        painter.fillRect(self.rect(), self.palette().color(QPalette.ColorRole.Window))
        painter.setPen(self.palette().color(QPalette.ColorRole.Highlight))
        painter.fillRect(QRect(0, 0, self.width(), 3), painter.pen().color())
        painter.setClipRect(room)
        painter.translate(room.left(), room.top() - self._moved_px)
        context = QAbstractTextDocumentLayout.PaintContext()
        context.palette = self.palette()
        self._document.documentLayout().draw(painter, context)
        painter.end()
