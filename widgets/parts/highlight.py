"""The highlight of what the user points at: one value for the whole window.

::

    row, cell, word or pane --mark(who, what)--> Highlighter --changed(what)--> all that show it

A widget under the mouse or with the focus marks its subject, and marks `NOTHING` afterwards. The
latest mark counts; when it is removed, the previous one counts again.
"""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QRectF, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from app.lecture.highlight import NOTHING, Highlight
from widgets.parts.plain import PlainLabel

if TYPE_CHECKING:
    OfWidget = QWidget
else:
    OfWidget = object  # the class is a QWidget already


class Highlighter(QObject):
    """Keeps the current highlight."""

    changed = Signal(object)  # the new `Highlight`

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._by_whom: dict[Hashable, Highlight] = {}
        self._now = NOTHING

    def mark(self, who: Hashable, what: Highlight) -> None:
        """Set or remove (`NOTHING`) the highlight of one source."""
        self._by_whom.pop(who, None)
        if what:
            self._by_whom[who] = what
        now = next(reversed(self._by_whom.values()), NOTHING)
        if now != self._now:
            self._now = now
            self.changed.emit(now)


def faded(colour: QColor | str, opacity: float) -> QColor:
    pale = QColor(colour)
    pale.setAlphaF(opacity)
    return pale


def paint_highlight(widget: QWidget, painter: QPainter, rect: QRectF) -> None:
    """Tint and frame a highlighted part of a widget."""
    colour = widget.palette().highlight().color()
    painter.fillRect(rect, faded(colour, 0.2))
    painter.setPen(QPen(colour, 1.0))
    painter.drawRect(rect.adjusted(0.5, 0.5, -0.5, -0.5))


class TintedWidget(OfWidget):
    """A widget that is tinted while its subject is highlighted elsewhere."""

    is_marked = False

    def set_marked(self, marked: bool) -> None:
        if marked != self.is_marked:
            self.is_marked = marked
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.is_marked:
            painter = QPainter(self)
            paint_highlight(self, painter, QRectF(self.rect()))
            painter.end()


class MarkedLabel(TintedWidget, PlainLabel):
    """Words that are tinted while their subject is highlighted elsewhere."""
