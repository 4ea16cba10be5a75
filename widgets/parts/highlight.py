"""What the user attends to just now: one value for the whole window.

::

    row, cell, word or pane --mark(who, what)--> Highlighter --changed(what)--> all that show it

Whoever is hovered or has the keyboard's focus says what it is about, and says `NOTHING` when that
is over. The latest counts; when it is over, the one before does again.
"""

from __future__ import annotations

from collections.abc import Hashable

from PySide6.QtCore import QObject, QRectF, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from app.lecture.highlight import NOTHING, Highlight
from widgets.parts.plain import Label


class Highlighter(QObject):
    """Keeps what is highlighted."""

    changed = Signal(object)
    """Another `Highlight` than before."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._by_whom: dict[Hashable, Highlight] = {}
        self._now = NOTHING

    def mark(self, who: Hashable, what: Highlight) -> None:
        """Take over what somebody is about, or that this is over (`NOTHING`)."""
        self._by_whom.pop(who, None)
        if what:
            self._by_whom[who] = what
        now = next(reversed(self._by_whom.values()), NOTHING)
        if now != self._now:
            self._now = now
            self.changed.emit(now)


def faded(colour: QColor | str, opacity: float) -> QColor:
    """A colour that lets through what is under it."""
    found = QColor(colour)
    found.setAlphaF(opacity)
    return found


def paint_highlight(widget: QWidget, painter: QPainter, rect: QRectF) -> None:
    """Tint and frame a part of a widget that shows what is highlighted."""
    colour = widget.palette().highlight().color()
    painter.fillRect(rect, faded(colour, 0.2))
    painter.setPen(QPen(colour, 1.0))
    painter.drawRect(rect.adjusted(0.5, 0.5, -0.5, -0.5))


class MarkedLabel(Label):
    """Words that show when something else highlights what they are about."""

    is_marked = False

    def set_marked(self, marked: bool) -> None:
        """Tint the words, or no more."""
        if marked != self.is_marked:
            self.is_marked = marked
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        painter = QPainter(self)
        self.paint_mark(painter)
        painter.end()

    def paint_mark(self, painter: QPainter) -> None:
        """Tint the words if they are to be."""
        if self.is_marked:
            paint_highlight(self, painter, QRectF(self.rect()))
