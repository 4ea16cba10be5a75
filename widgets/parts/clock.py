"""The one clock of everything that plays: stage strip, animation, a scene's settings."""

from __future__ import annotations

from abc import abstractmethod

from PySide6.QtCore import QCoreApplication, QElapsedTimer, QObject, Qt, QTimer, Signal
from PySide6.QtWidgets import QToolButton

from widgets.parts.icons import show_icon
from widgets.parts.plain import set_tip

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
        precise = Qt.TimerType.PreciseTimer
        self._timer = QTimer(self, singleShot=True, interval=FRAME_MS, timerType=precise)
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
    button: QToolButton
    """Plays and pauses."""

    def _name_button(self, name: str, tip: str, tip_playing: str) -> str:
        """Let the button say what a click would do, in the word that ``{0}`` of its name is for."""
        word = QCoreApplication.translate("Playing", "Play")
        if self.playing:
            word = QCoreApplication.translate("Playing", "Pause")
        show_icon(self.button, "pause" if self.playing else "play")
        self.button.setAccessibleName(name.replace("{0}", word))
        set_tip(self.button, tip_playing if self.playing else tip)
        return word

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
