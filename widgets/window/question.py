"""A question that is put to a class, or its answer: it lies over the slide and moves nothing."""

import math
from collections.abc import Callable, Iterable
from itertools import product
from typing import TypeAlias

from PySide6.QtCore import QPoint, QPointF, QRect, QRectF, QSize
from PySide6.QtGui import QFont, QPainter, QPaintEvent, QPalette, QWheelEvent
from PySide6.QtWidgets import QFrame, QWidget

from app.lessons.text import spoken_text
from widgets.parts.layouts import paint_now
from widgets.parts.lesson_text import set_text
from widgets.parts.plain import TextDocument

SHARES = 1.0 / 3.0, 0.5
"""Largest heights of the question, in those of the slide: the second if the text needs it, or if
the first hides a name."""
WIDTHS = 0.3, 0.45, 0.6, 0.8, 1.0  # largest widths that are tried, in those of the slide
PLACES = (0.0, 1.0), (1.0, 1.0), (0.5, 1.0), (0.0, 0.0), (1.0, 0.0), (0.5, 0.0)
"""Where the question may lie, from left to right and from the top; of equal ones the first."""
LETTERS = (0.036, 0.033, 0.0305)  # sizes of letters, in heights of the screen, the best first
INK_SHARE = 0.002  # ink in shares of the slide that makes a place worse
EDGE_SHARE = 0.02  # free on each side, in heights of the screen

HiddenInk: TypeAlias = Callable[[QRectF], float]


class QuestionOverlay(QFrame):
    """Lies over a slide where it hides the least; what does not fit is reached by the wheel.

    `named` returns for each picture what it should not hide, in the slide's pixels, and how many
    pixels of ink a box would hide.
    """

    def __init__(
        self, slide: QWidget, named: Callable[[], Iterable[tuple[list[QRectF], HiddenInk]]]
    ) -> None:
        super().__init__(slide)
        self.setObjectName("question")
        self._slide, self._named = slide, named
        self._document = TextDocument(self)
        self._screen_px, self._moved_px = 0.0, 0
        self.hide()

    def show_text(self, text: str, screen_px: float) -> None:
        """Show a text in Markdown; an empty one hides the question."""
        self._screen_px, self._moved_px = screen_px, 0
        self.setAccessibleName(spoken_text(text))
        set_text(self._document, text, palette=self.palette())
        self.setVisible(bool(text))
        if text:
            paint_now(self._slide)  # names have their places once they are drawn
        self.place()
        self.raise_()

    def place(self) -> None:
        """Lie where the fewest names are hidden, in the largest letters that allow it.

        Of such places those are preferred that hide little ink.
        """
        if self.isHidden():
            return
        pictures, room = list(self._named()), self._slide.rect()
        named = [each.toAlignedRect() for boxes, _ in pictures for each in boxes]
        tried = []
        for letters, widest in product(range(len(LETTERS)), WIDTHS):
            size, whole = self._lay_out(letters, widest)
            level = sum(whole > share * room.height() for share in SHARES)
            free = room.width() - size.width(), room.height() - size.height()
            for order, (across, down) in enumerate(PLACES):
                place = QRect(QPoint(round(across * free[0]), round(down * free[1])), size)
                hidden = sum(map(place.intersects, named))
                inked = sum(ink(QRectF(place)) for _, ink in pictures)
                inked /= INK_SHARE * room.width() * room.height()
                area = size.width() * size.height()
                cost = (level == len(SHARES), hidden, round(inked), level, letters, area, order)
                tried.append((cost, place, widest))
        (_, _, _, _, letters, *_), place, widest = min(tried, key=lambda each: each[0])
        self._lay_out(letters, widest)
        self.setGeometry(place)
        self.update()

    def _lay_out(self, letters: int, widest: float) -> tuple[QSize, float]:
        """Lay the text out; return the question's size, and the height that all of it needs."""
        room, edge = self._slide.rect(), EDGE_SHARE * self._screen_px
        font = QFont(self.font())
        font.setPixelSize(max(8, round(LETTERS[letters] * self._screen_px)))
        self._document.setDefaultFont(font)
        self._document.setTextWidth(max(1.0, widest * room.width() - 4.0 * edge))
        width = math.ceil(min(self._document.idealWidth() + 1.0, self._document.textWidth()))
        self._document.setTextWidth(width)
        whole = self._document.size().height() + 2.0 * edge
        high = math.ceil(min(whole, SHARES[-1] * room.height()))
        return QSize(math.ceil(width + 4.0 * edge), high), whole

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
        line = 0 if self.y() else self.height() - 3  # towards the picture
        painter.fillRect(QRect(0, line, self.width(), 3), painter.pen().color())
        painter.setClipRect(room)
        place = room.topLeft() - QPointF(0.0, self._moved_px)
        self._document.paint(painter, place, self.palette())
        painter.end()
