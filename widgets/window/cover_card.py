"""What cards over the whole window share: how they close, and their keys."""

from PySide6.QtCore import QEvent, QObject, Qt, Signal, SignalInstance
from PySide6.QtGui import QCloseEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QFrame, QGridLayout, QHBoxLayout, QToolButton, QWidget

from widgets.parts.layouts import in_row, tool_button
from widgets.parts.plain import PlainLabel


class CoverCard(QWidget):
    """A card over the window until the user chooses something, presses Esc or clicks beside it.

    `card` is the visible part.
    """

    left = Signal()  # the card has closed; emitted before the signal of what was chosen

    def __init__(self, window: QWidget, name: str) -> None:
        super().__init__(window)
        self.setObjectName("cover")
        self.setAccessibleName(name)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._window = window
        self.card = QFrame()
        self.card.setObjectName("card")
        self.card.setAutoFillBackground(True)
        self.card.setFrameShape(QFrame.Shape.StyledPanel)
        around = QGridLayout(self)
        around.setContentsMargins(8, 8, 8, 8)
        around.addWidget(self.card, 0, 0, Qt.AlignmentFlag.AlignCenter)
        self.tiles: dict[str, QToolButton] = {}  # the buttons with a picture, by name
        window.installEventFilter(self)
        self._cover()

    def open(self) -> None:
        self.show()
        self.raise_()
        next(iter(self.tiles.values())).setFocus()

    def _head(self, text: str, tip: str, *before: QWidget) -> QHBoxLayout:
        leave = tool_button("", tip, self.close, icon="close", name=self.tr("Close"), flat=True)
        return in_row(*before, (PlainLabel(text, objectName="cardTitle"), 1), leave)

    def _leave_for(self, wanted: SignalInstance, *what: str) -> None:
        self.close()
        wanted.emit(*what)

    # -- over the window

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Press the button that has the focus also by Enter, which Qt leaves to dialogs."""
        focused = self.focusWidget()
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and isinstance(
            focused, QToolButton
        ):
            focused.showMenu() if focused.menu() else focused.click()
        else:
            super().keyPressEvent(event)

    def closeEvent(self, event: QCloseEvent) -> None:
        super().closeEvent(event)
        self.left.emit()
        self.deleteLater()

    def _cover(self) -> None:
        self.setGeometry(self._window.rect())

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self._cover()
        return super().eventFilter(watched, event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        event.accept()  # a click beside the card; its own widgets take clicks on it
        self.close()
