"""Gestures: edits that belong together and are undone in one step."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QApplication, QSlider, QWidget

if TYPE_CHECKING:
    Beside = QObject
else:
    Beside = object  # the class is a QObject already


class Gestures(Beside):
    """Reports when a gesture (a drag, a burst of keys, an animation) begins and ends."""

    gesture_started = Signal()
    gesture_finished = Signal()
    gesture_abandoned = Signal()  # Esc was pressed: undo this gesture's changes; it ends now

    def pass_on(self, source: "Gestures") -> None:
        """Forward another object's gestures too."""
        source.gesture_started.connect(self.gesture_started)
        source.gesture_finished.connect(self.gesture_finished)
        source.gesture_abandoned.connect(self.gesture_abandoned)


class EscapeKey(QObject):
    """Intercepts Esc between `watch` and `leave`: it restores a dragged value and ends the drag.

    The drag receives Esc before any shortcut, whichever widget has the focus. Moves of the mouse
    are ignored until the button is released.
    """

    pressed = Signal()

    _watched: QObject | None = None

    @property
    def is_watched(self) -> bool:
        """Whether a drag is in progress."""
        return self._watched is not None

    def watch(self, window: QWidget) -> None:
        """Start intercepting Esc, at the start of a drag in this window."""
        self.leave()
        self._watched = QApplication.focusWidget() or window
        self._watched.installEventFilter(self)

    def leave(self) -> None:
        """Stop intercepting Esc, at the end of the drag."""
        if self._watched is not None:
            self._watched.removeEventFilter(self)
            self._watched = None

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            if event.type() == QEvent.Type.ShortcutOverride:
                event.accept()
            elif event.type() == QEvent.Type.KeyPress:
                self.pressed.emit()
            return True
        return super().eventFilter(watched, event)


class HeldSlider(QSlider):
    """A horizontal slider that Esc frees from the mouse; its owner restores the value."""

    abandoned = Signal()

    def __init__(self) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self.is_abandoned = False  # whether mouse moves are ignored until the button is released
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._escape = EscapeKey(self)
        self._escape.pressed.connect(self._abandon)
        self.sliderPressed.connect(lambda: self._escape.watch(self))

    def _abandon(self) -> None:
        self.is_abandoned = True
        self.abandoned.emit()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if not self.is_abandoned:
            super().mouseMoveEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """End a drag: a dialog, a menu or another window takes the release of the button."""
        super().focusOutEvent(event)
        if event.reason() != Qt.FocusReason.OtherFocusReason:
            self._escape.leave()
            self.is_abandoned = False
            self.setSliderDown(False)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._escape.leave()
        self.is_abandoned = False
        super().mouseReleaseEvent(event)
