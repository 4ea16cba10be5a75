"""A question that is put to a class, or its answer: it lies over the slide and moves nothing."""

import math
import re
from collections.abc import Callable, Iterable, Iterator
from itertools import product
from typing import Any, TypeAlias

import numpy as np
from PySide6.QtCore import QPoint, QPointF, QRect, QRectF, QSize
from PySide6.QtGui import QFont, QPainter, QPaintEvent, QPalette, QWheelEvent
from PySide6.QtWidgets import QFrame, QWidget

from app.drawings.label_placement import Floats, overlap
from app.lessons.text import spoken_text
from widgets.parts.layouts import paint_now
from widgets.parts.lesson_text import set_text
from widgets.parts.plain import TextDocument

SHARES = 1.0 / 3.0, 0.5
"""Largest heights of the question, in those of the slide: the second if the text needs it, or if
the first hides a name."""
WIDTHS = 0.175, 0.2, 0.25, 0.3, 0.45, 0.6, 0.8, 1.0  # largest ones tried, in the slide's
ALONG = sorted((part / 16.0 for part in range(17)), key=lambda at: abs(at - 0.5), reverse=True)
INNER = [at for at in ALONG[2:] if at * 8.0 % 1.0 == 0.0]
PLACES = [*((at, y) for y in (1.0, 0.0) for at in ALONG), *product((0.0, 1.0), ALONG)]
PLACES += product(INNER, INNER)  # inside a picture, rather than over a side of its frame
"""Where the question may lie, from left to right and from the top; of equal ones the first."""
LETTERS = (0.036, 0.033, 0.0305)  # sizes of letters, in heights of the screen, the best first
INK_SHARE = 0.0005  # ink in shares of the slide that makes a place worse
EDGE_SHARE = 0.02  # free on each side, in heights of the screen
CHOICE = re.compile(r"  \n(\*\*\w\*\*) ")  # how a choice begins
BESIDE = "\N{EM SPACE}\N{EM SPACE} \\1\N{NO-BREAK SPACE}"  # on the line of others

HiddenInk: TypeAlias = Callable[[Floats], Floats]


class QuestionOverlay(QFrame):
    """Lies over a slide where it hides the least; what does not fit is reached by the wheel.

    `named` returns for each picture what it should not hide, in the slide's pixels, and how many
    pixels of ink boxes, (n, 4), would hide.
    """

    def __init__(
        self, slide: QWidget, named: Callable[[], Iterable[tuple[list[QRectF], HiddenInk]]]
    ) -> None:
        super().__init__(slide)
        self.setObjectName("question")
        self._slide, self._named = slide, named
        self._document = TextDocument(self)
        self._texts, self._screen_px, self._moved_px = ("", ""), 0.0, 0
        self.hide()

    def show_text(self, text: str, screen_px: float) -> None:
        """Show a text in Markdown; an empty one hides the question."""
        self._screen_px, self._moved_px = screen_px, 0
        self._texts = text, CHOICE.sub(BESIDE, text)  # the second only if the first hides anything
        self.setAccessibleName(spoken_text(text) if text else "")  # none needs no Markdown
        self.setVisible(bool(text))
        self.settle()
        self.raise_()

    def settle(self) -> None:
        """Find a place once names have theirs, which they have when they are drawn."""
        if not self.isHidden():
            paint_now(self._slide)
        self.place()

    def place(self) -> None:
        """Lie where the fewest names and the least ink are hidden, in the largest letters."""
        if self.isHidden():
            return
        pictures, room = list(self._named()), self._slide.rect()
        named = np.array([each.getCoords() for boxes, _ in pictures for each in boxes])
        apart = EDGE_SHARE / 2.0 * self._screen_px * np.array([-1.0, -1.0, 1.0, 1.0])
        unit, best = INK_SHARE * room.width() * room.height(), tuple[Any, ...]()
        for text in self._texts:
            set_text(self._document, text, palette=self.palette())
            tried = list(self._candidates(room))
            boxes = np.array([QRectF(place).getCoords() for _, place, _ in tried])
            names = overlap(boxes + apart, named.reshape(-1, 4)).sum(axis=1)
            inked = np.ceil(sum((ink(boxes) for _, ink in pictures), np.zeros(len(boxes))) / unit)
            for i, (cost, place, widest) in enumerate(tried):
                whole = (cost[0] == len(SHARES), names[i], inked[i], *cost)
                if not best or whole < best[0]:
                    best = whole, place, widest, text
            if not any(best[0][:3]):
                break
        (*_, letters, _, _), place, widest, text = best
        set_text(self._document, text, palette=self.palette())
        self._lay_out(letters, widest)
        self.setGeometry(place)
        self.update()

    def _candidates(self, room: QRect) -> Iterator[tuple[tuple[int, ...], QRect, float]]:
        """Yield what a place costs if it hides nothing, the place, and the largest width."""
        for letters, widest in product(range(len(LETTERS)), WIDTHS):
            size, whole = self._lay_out(letters, widest)
            level = sum(whole > share * room.height() for share in SHARES)
            free, area = room.size() - size, size.width() * size.height()
            for order, (across, down) in enumerate(PLACES):
                corner = QPoint(round(across * free.width()), round(down * free.height()))
                yield (level, letters, area, order), QRect(corner, size), widest

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
