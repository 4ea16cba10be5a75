"""The notation of formulas and numbers: which letters, and how many digits.

The two choices apply to panes, panels and readouts. They do not round the numbers themselves:
copied or typed numbers have all their digits.
"""

from typing import Generic, TypeVar

from PySide6.QtCore import QObject, Signal

from app.lecture.letters import Letters

_T = TypeVar("_T")


class SharedChoice(QObject, Generic[_T]):
    """A choice, and a signal when it changes."""

    changed = Signal()

    def __init__(self, now: _T) -> None:
        super().__init__()
        self.now = now

    def set(self, now: _T) -> None:
        if now != self.now:
            self.now = now
            self.changed.emit()


lettering = SharedChoice[Letters]("own")  # the lecture whose letters are used
all_digits = SharedChoice(False)  # whether numbers are shown with all digits instead of four
