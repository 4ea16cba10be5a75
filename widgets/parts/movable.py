"""A column of widgets that the user puts in another order by their grips."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QToolButton, QWidget

from widgets.parts.layouts import discard, in_column, tool_button


class MovableColumn(QWidget):
    """Parts that are dragged by a grip, or moved by the arrow keys while it has the focus."""

    moved = Signal(int, int)  # the user moved the part from one place to another

    def __init__(self, gap: int) -> None:
        super().__init__()
        self._column = in_column(on=self, margins=(0, 0, 0, 0), gap=gap)
        self.parts: list[QWidget] = []
        self._owners: dict[QObject, QWidget] = {}
        self._from: int | None = None  # the place from which a part is dragged

    def show_parts(self, parts: Sequence[QWidget]) -> None:
        """Show other parts, from the top, in place of these."""
        discard(self._column, self.parts)
        self.parts, self._from = [*parts], None
        self._owners = {grip: part for grip, part in self._owners.items() if part in parts}
        for part in parts:
            self._column.addWidget(part)

    def grip_of(self, part: QWidget, name: str) -> QToolButton:
        """Make the grip of a part."""
        tip = self.tr("Drag it to another place, or press the arrow keys up and down")
        grip = tool_button(icon="grip", tip=tip, name=f"{name}: {tip}", flat=True)
        grip.setCursor(Qt.CursorShape.SizeVerCursor)
        grip.installEventFilter(self)
        self._owners[grip] = part
        return grip

    def eventFilter(self, grip: QObject, event: QEvent) -> bool:
        place = self.parts.index(part) if (part := self._owners[grip]) in self.parts else -1
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            by = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}.get(Qt.Key(event.key()), 0)
            if by and 0 <= place + by < len(self.parts):
                self._move(place, place + by)
                self.moved.emit(place, place + by)
            return bool(by)
        if isinstance(event, QMouseEvent) and event.buttons() & Qt.MouseButton.LeftButton:
            if event.type() == QEvent.Type.MouseMove and self._from is not None:
                y = self.mapFromGlobal(event.globalPosition().toPoint()).y()
                others = (each for each in self.parts if each is not part)
                self._move(place, sum(each.geometry().center().y() < y for each in others))
            else:
                self._from = place
        elif event.type() == QEvent.Type.MouseButtonRelease and self._from is not None:
            begin, self._from = self._from, None
            if begin != place:
                self.moved.emit(begin, place)
        return super().eventFilter(grip, event)

    def _move(self, place: int, to: int) -> None:
        if place != to:
            self.parts.insert(to, part := self.parts.pop(place))
            self._column.insertWidget(to, part)
