"""The place of the panes in the window: for a class a slide, over which a question may lie."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QWidget

from widgets.parts.layouts import in_row
from widgets.window.question import Question
from widgets.window.slots import Slots


class Slide(QWidget):
    """Holds the panes, and lays the question over their lower third."""

    touched = Signal()
    """A finger has touched the screen."""

    def __init__(self, slots: Slots) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_AcceptTouchEvents)
        self._slots = slots
        self.question = Question(self)
        in_row((slots, 1), on=self, margins=(0, 0, 0, 0), gap=0)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.question.place()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.TouchBegin:
            self.touched.emit()  # not accepted: the touch is a click of the pane, too
        return super().event(event)
