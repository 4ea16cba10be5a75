"""How everything that is read is written: in whose letters, and with how many digits.

One choice each for panes, panels, readouts and what is copied. No number is rounded by it: what is
copied, and what is typed in, has all of its digits.
"""

from __future__ import annotations

from typing import Generic, TypeVar

from PySide6.QtCore import QObject, Signal

from app.lecture.notation import Letters

_T = TypeVar("_T")


class Writing(QObject, Generic[_T]):
    """A choice.

    Attributes
    ----------
    now : Letters or bool
    """

    changed = Signal()

    def __init__(self, now: _T) -> None:
        super().__init__()
        self.now = now

    def set(self, now: _T) -> None:
        """Write everything so from now on."""
        if now != self.now:
            self.now = now
            self.changed.emit()


lettering = Writing[Letters]("own")
"""Whose letters."""
all_digits = Writing(False)
"""Whether all digits are shown where numbers are read, not four."""
