"""Whose letters are written now: one choice for panes, panels, readouts and what is copied."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from app.lecture.notation import Letters


class Lettering(QObject):
    """The choice.

    Attributes
    ----------
    now : Letters
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.now: Letters = "own"


lettering = Lettering()


def set_letters(letters: Letters) -> None:
    """Write everything in a lecture's letters."""
    if letters != lettering.now:
        lettering.now = letters
        lettering.changed.emit()
