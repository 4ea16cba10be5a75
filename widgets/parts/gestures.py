"""What of the hand's doing belongs together, and is one step to be undone."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

if TYPE_CHECKING:
    Beside = QObject
else:
    Beside = object  # what is a QObject already cannot be one twice


class Gestures(Beside):
    """Who tells when a gesture begins and ends: a drag, a burst of keys, something that plays."""

    gesture_started = Signal()
    gesture_finished = Signal()
    gesture_abandoned = Signal()
    """Esc: what the gesture, which ends now, has changed shall be put back."""

    def pass_on(self, source: Gestures) -> None:
        """Tell of another's gestures as of one's own."""
        source.gesture_started.connect(self.gesture_started)
        source.gesture_finished.connect(self.gesture_finished)
        source.gesture_abandoned.connect(self.gesture_abandoned)
