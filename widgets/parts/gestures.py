"""Gestures: edits that belong together and are undone in one step."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

if TYPE_CHECKING:
    Beside = QObject
else:
    Beside = object  # the class is a QObject already


class Gestures(Beside):
    """Reports when a gesture (a drag, a burst of keys, an animation) begins and ends."""

    gesture_started = Signal()
    gesture_finished = Signal()
    gesture_abandoned = Signal()
    """Esc was pressed: undo the changes of this gesture, which ends now."""

    def pass_on(self, source: Gestures) -> None:
        """Forward another object's gestures too."""
        source.gesture_started.connect(self.gesture_started)
        source.gesture_finished.connect(self.gesture_finished)
        source.gesture_abandoned.connect(self.gesture_abandoned)
