"""A column of widgets that the user puts in another order by their grips."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QScrollArea, QToolButton, QWidget

from widgets.parts.icons import show_icon
from widgets.parts.layouts import discard, in_column, lay_out
from widgets.parts.plain import set_tip


class MovableColumn(QWidget):
    """Parts, one below the other; each has a `MoveButton` somewhere."""

    moved = Signal(int, int)  # the user moved the part from one place to another

    def __init__(self, gap: int) -> None:
        super().__init__()
        self._column = in_column(on=self, margins=(0, 0, 0, 0), gap=gap)
        self.parts: list[QWidget] = []

    def show_parts(self, parts: Sequence[QWidget]) -> None:
        before, self.parts = self.parts, [*parts]
        for part in parts:
            self._column.addWidget(part)
            part.show()  # before the others go: one of them may take the focus
        discard(self._column, before)

    def move_part(self, part: QWidget, to: int) -> None:
        """Show a part at another place, scrolled into view, without a signal."""
        self.parts.remove(part)
        self.parts.insert(to, part)
        self._column.insertWidget(to, part)
        lay_out()
        around = self.parentWidget()
        while around is not None and not isinstance(around, QScrollArea):
            around = around.parentWidget()
        if around is not None:
            around.ensureWidgetVisible(part, 0, 100)  # the pointer at the edge goes on to the next


class MoveButton(QToolButton):
    """Moves the part that it belongs to: dragged, or by the arrow keys while it has the focus."""

    def __init__(self, name: str) -> None:
        super().__init__(autoRaise=True)
        tip = self.tr("Drag it to another place, or press the arrow keys up and down")
        self.setAccessibleName(f"{name}: {tip}")
        set_tip(self, tip)
        show_icon(self, "grip")
        self.setCursor(Qt.CursorShape.SizeVerCursor)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._begin = -1  # the place from which the part is dragged

    def _place(self) -> tuple[MovableColumn, QWidget, int]:
        part: QWidget = self
        while not isinstance(column := part.parentWidget(), MovableColumn):
            assert column is not None
            part = column
        return column, part, column.parts.index(part)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        by = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}.get(Qt.Key(event.key()), 0)
        if not by:
            super().keyPressEvent(event)
            return
        column, part, place = self._place()
        if 0 <= place + by < len(column.parts):
            column.move_part(part, place + by)
            column.moved.emit(place, place + by)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._begin = self._place()[2]
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        column, part, place = self._place()
        y = column.mapFromGlobal(event.globalPosition().toPoint()).y()
        others = (each for each in column.parts if each is not part)
        to = sum(each.geometry().center().y() < y for each in others)
        if self._begin >= 0 and to != place:
            column.move_part(part, to)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        column, _, place = self._place()
        begin, self._begin = self._begin, -1
        super().mouseReleaseEvent(event)
        if begin not in (-1, place):
            column.moved.emit(begin, place)
