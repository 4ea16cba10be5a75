"""Gestures: edits that belong together and are undone in one step."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

if TYPE_CHECKING:
    Beside = QObject
else:
    Beside = object  # the class is a QObject already


class Gestures(Beside):
    """Reports when a gesture begins and ends: a drag, a burst of keys, something that plays."""

    gesture_started = Signal()
    gesture_finished = Signal()
    gesture_abandoned = Signal()
    """Esc: undo what this gesture has changed; it ends now."""

    def pass_on(self, source: Gestures) -> None:
        """Report another object's gestures too."""
        source.gesture_started.connect(self.gesture_started)
        source.gesture_finished.connect(self.gesture_finished)
        source.gesture_abandoned.connect(self.gesture_abandoned)
