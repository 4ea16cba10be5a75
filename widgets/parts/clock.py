"""The clock of everything that plays: stage strip, animation, a scene's settings."""

from abc import abstractmethod
from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QElapsedTimer, QObject, Qt, QTimer, Signal
from PySide6.QtWidgets import QToolButton

from widgets.parts.gestures import Gestures
from widgets.parts.icons import show_icon
from widgets.parts.plain import set_tip

FRAME_MS = 16  # shortest time between two frames
LONGEST_FRAME_S = 0.25
"""Longest time reported for a frame: after a stall, motion continues instead of jumping."""


class Clock(QObject):
    """While it runs, calls `act` with the elapsed time once per frame.

    The wait for a frame begins when the previous frame's work is done, so slow frames do not pile
    up.
    """

    ticked = Signal(float)  # seconds since the last frame, `LONGEST_FRAME_S` at most

    def __init__(self, parent: QObject, act: Callable[[float], object]) -> None:
        super().__init__(parent)
        self.ticked.connect(act)
        self.running = False
        self._watch = QElapsedTimer()
        precise = Qt.TimerType.PreciseTimer
        self._timer = QTimer(self, singleShot=True, interval=FRAME_MS, timerType=precise)
        self._timer.timeout.connect(self._frame)

    def start(self) -> None:
        self.running = True
        self._watch.start()
        self._timer.start()

    def stop(self) -> None:
        self.running = False
        self._timer.stop()

    def _frame(self) -> None:
        seconds = self._watch.nsecsElapsed() * 1e-9  # whole milliseconds would lose 3 %
        self._watch.restart()
        self.ticked.emit(min(seconds, LONGEST_FRAME_S))
        if self.running:
            self._timer.start()


class Playing(Gestures):
    """Something that plays while its clock runs, which is one gesture."""

    _clock: Clock
    button: QToolButton

    def _name_button(self, name: str, tip: str, tip_playing: str) -> str:
        """Name the button after the effect of a click; return that word, which replaces ``{0}``."""
        word = QCoreApplication.translate("Playing", "Play")
        if self.playing:
            word = QCoreApplication.translate("Playing", "Pause")
        show_icon(self.button, "pause" if self.playing else "play")
        self.button.setAccessibleName(name.replace("{0}", word))
        set_tip(self.button, tip_playing if self.playing else tip)
        return word

    @property
    def playing(self) -> bool:
        return self._clock.running

    def toggle(self) -> None:
        if self.playing:
            self.pause()
        else:
            self.play()

    @abstractmethod
    def play(self) -> None:
        """Continue from here."""

    def pause(self) -> None:
        """Stop; playing again goes on from here."""
        if self.playing:
            self._set_playing(False)

    def _set_playing(self, on: bool) -> None:
        (self._clock.start if on else self._clock.stop)()
        self._show_state()
        (self.gesture_started if on else self.gesture_finished).emit()

    @abstractmethod
    def _show_state(self) -> None:
        """Show whether it plays."""
