"""What the class reads of a talk's step while it is presented: above the panes, never over them."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QPointF, QRectF, Qt
from PySide6.QtGui import (
    QAbstractTextDocumentLayout,
    QFont,
    QPainter,
    QPaintEvent,
    QPalette,
    QResizeEvent,
    QTextDocument,
)
from PySide6.QtWidgets import QFrame, QSizePolicy

from app.lessons.lesson import Question, Step, Task, Words
from app.lessons.text import plain_of
from widgets.parts.lesson_text import set_text

SHARE = 0.135
"""Of the screen's height, for the band: always the same, so that no pane moves at a step."""
TITLE_EM = 1.3
"""Of the window's letters, which are a share of the screen's height already."""
LARGEST, SMALLEST = 1.2, 0.6
"""Letters of a step that says little, and of one that says much, against the window's."""
SIDE_SHARE = 0.46
"""Of the band's width, for a question."""
CHOICES = "ABCDEFGHIJ"
_GAP_PX = 10


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
        self._title, self._words, self._asked = (QTextDocument(self) for _ in range(3))
        self._number, self.note = "", ""
        self._fit = LARGEST
        self.hide()

    def set_screen(self, height_px: float) -> None:
        """Take a share of a screen of that height."""
        self.setFixedHeight(round(SHARE * height_px))

    def show_step(self, step: Step, number: str, revealed: int) -> None:
        """Show a step, and so many of its predictions' answers."""
        line = self.palette().color(QPalette.ColorRole.Mid).name()
        set_text(self._title, step.title, title=True, line=line)
        words = [part.text for part in step.parts if isinstance(part, (Words, Task))]
        set_text(self._words, "\n\n".join(words), line=line)
        questions = [part for part in step.parts if isinstance(part, Question)]
        open_ones = [part for part in questions if part.predicts]
        asked = [
            _asked(part, part in open_ones[:revealed])
            for part in questions
            if part not in open_ones[revealed + 1 :]
        ]
        set_text(self._asked, "\n\n".join(asked[-1:]), line=line)
        self._number = number
        self.setAccessibleName(plain_of("\n\n".join([step.title, *words, *asked])))
        self._fit_all()

    def say(self, note: str) -> None:
        """Say something beside the number of the step; nothing says no more."""
        self.note = note
        self.update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_all()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.PaletteChange):
            self._fit_all()

    def _columns(self) -> tuple[QRectF, QRectF]:
        """Where the words stand, and where the question; in the whole width without one."""
        room = QRectF(self.rect()).adjusted(_GAP_PX, 2.0, -_GAP_PX, -2.0)
        if self._asked.isEmpty():
            return room, QRectF()
        left, right = QRectF(room), QRectF(room)
        left.setWidth((1.0 - SIDE_SHARE) * room.width() - _GAP_PX)
        right.setLeft(room.right() - SIDE_SHARE * room.width() + _GAP_PX)
        return left, right

    def _fit_all(self) -> None:
        """Find the largest letters in which all of it has room."""
        self._fit = LARGEST
        while not self._fits() and self._fit > SMALLEST:
            self._fit = max(SMALLEST, self._fit - 0.08)
        self.update()

    def _fits(self) -> bool:
        left, right = self._columns()
        em = self.fontInfo().pixelSize()
        free = self.fontMetrics().horizontalAdvance("000 / 000  ")
        for document, size, width in (
            (self._title, TITLE_EM, (left.width() - free) if right.isNull() else left.width()),
            (self._words, 1.0, left.width()),
            (self._asked, 1.0, right.width()),
        ):
            font = QFont(self.font())
            font.setPixelSize(max(8, round(self._fit * size * em)))
            document.setDefaultFont(font)
            document.setTextWidth(max(1.0, width))
        high = self._title.size().height() + self._words.size().height()
        return high <= left.height() and (
            right.isNull() or self._asked.size().height() + self._line_px <= right.height()
        )

    @property
    def _line_px(self) -> float:
        """Height of the line with the number of the step."""
        return float(self.fontMetrics().height())

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        painter = QPainter(self)
        left, right = self._columns()
        self._draw(painter, self._title, left.topLeft())
        self._draw(painter, self._words, left.topLeft() + QPointF(0.0, self._title.size().height()))
        if not right.isNull():
            self._draw(painter, self._asked, right.topLeft() + QPointF(0.0, self._line_px))
            painter.setPen(self.palette().color(QPalette.ColorRole.Mid))
            x = right.left() - 1.5 * _GAP_PX
            painter.drawLine(QPointF(x, right.top() + 2.0), QPointF(x, right.bottom() - 2.0))
        room = QRectF(self.rect()).adjusted(_GAP_PX, 2.0, -_GAP_PX, -2.0)
        painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
        text = f"{self.note}    {self._number}" if self.note else self._number
        painter.drawText(room, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignTop, text)
        painter.end()

    def _draw(self, painter: QPainter, document: QTextDocument, place: QPointF) -> None:
        painter.save()
        painter.translate(place)
        painter.setClipRect(QRectF(0.0, 0.0, document.textWidth(), self.height() - place.y()))
        context = QAbstractTextDocumentLayout.PaintContext()
        context.palette = self.palette()
        document.documentLayout().draw(painter, context)
        painter.restore()


def _asked(part: Question, is_revealed: bool) -> str:
    """A question with its choices; once it is answered, the right one and why."""
    lines: Sequence[str] = [
        f"**{letter}** {choice.text}" + (" **✓**" if is_revealed and choice.right else "")
        for letter, choice in zip(CHOICES, part.choices, strict=False)
        if choice.right or not is_revealed
    ]
    why = [part.why] if is_revealed and part.why else []
    return "\n\n".join(["  \n".join([part.text, *lines]), *why])
