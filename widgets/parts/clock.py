"""The one clock of everything that plays: stage strip, animation, a scene's settings."""

from __future__ import annotations

from abc import abstractmethod

from PySide6.QtCore import QElapsedTimer, QObject, Qt, QTimer, Signal

FRAME_MS = 16
"""Least time between two frames."""
LONGEST_FRAME_S = 0.25
"""A stalled window goes on from where it was instead of jumping."""


class Clock(QObject):
    """Says how much time has passed, once a frame, while it runs.

    The next frame is waited for after this one's work is done: frames that take long do not
    pile up.

    Attributes
    ----------
    ticked : Signal(float)
        Seconds since the last frame, `LONGEST_FRAME_S` at the most.
    """

    ticked = Signal(float)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.running = False
        self._watch = QElapsedTimer()
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.setInterval(FRAME_MS)
        self._timer.timeout.connect(self._frame)

    def start(self) -> None:
        """Count from now."""
        self.running = True
        self._watch.start()
        self._timer.start()

    def stop(self) -> None:
        """Stand still."""
        self.running = False
        self._timer.stop()

    def _frame(self) -> None:
        seconds = self._watch.nsecsElapsed() * 1e-9  # whole milliseconds would lose 3 %
        self._watch.restart()
        self.ticked.emit(min(seconds, LONGEST_FRAME_S))
        if self.running:
            self._timer.start()


class Playing:
    """Who plays while its clock runs: it says what `play` and `pause` do besides."""

    _clock: Clock

    @property
    def playing(self) -> bool:
        """Whether it moves by itself."""
        return self._clock.running

    def toggle(self) -> None:
        """Play, or pause."""
        if self.playing:
            self.pause()
        else:
            self.play()

    @abstractmethod
    def play(self) -> None:
        """Go on from here."""

    @abstractmethod
    def pause(self) -> None:
        """Stand still; playing again goes on from here."""
