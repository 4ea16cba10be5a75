"""Find a control by its name, its letter, its old names, or the words of its tooltip.

Each typed word must begin a word of the control; a single letter must be a whole word. Names come
before tooltips: a plane's name means the plane, not everything that depends on it.
"""

import re
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QLineEdit, QWidget

from widgets.parts.plain import set_tip


class ControlTexts(NamedTuple):
    """The texts of a control: its names in the window's language and the model's, and its tip."""

    names: str
    tip: str


def find(text: str, parts: Mapping[QWidget, ControlTexts]) -> set[QWidget]:
    """Return the controls whose names have all words, or else whose names and tips have them."""
    asked = _words(text)
    if not asked:
        return set()
    named = {part for part, told in parts.items() if _has(told.names, asked)}
    return named or {part for part, told in parts.items() if _has(" ".join(told), asked)}


def _words(text: str) -> list[str]:
    return re.findall(r"[^\W_]+", text.casefold())


def _has(text: str, asked: Iterable[str]) -> bool:
    words = _words(text)
    return all(
        part in words or (len(part) > 1 and any(word.startswith(part) for word in words))
        for part in asked
    )


class SearchBox(QLineEdit):
    """The search box: Enter or ↓ goes to the first result, Esc clears it."""

    taken = Signal()  # the user wants to go to the first result

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setPlaceholderText(self.tr("Find a control"))
        self.setAccessibleName(self.tr("Find a control"))
        tip = self.tr("Shows the controls with this name, also folded ones; Enter goes to the"
                      " first, Esc shows all again (Ctrl+F)")  # fmt: skip
        set_tip(self, tip)
        self.setAccessibleDescription(tip)
        self.setClearButtonEnabled(True)

    def event(self, event: QEvent) -> bool:
        is_key = isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape
        if is_key and event.type() == QEvent.Type.ShortcutOverride and self.text():
            event.accept()  # not a shortcut of the window
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key, keys = event.key(), Qt.Key
        if key == keys.Key_Escape and self.text():
            self.clear()
        elif key in (keys.Key_Return, keys.Key_Enter, keys.Key_Down) and self.text():
            self.taken.emit()
        else:
            super().keyPressEvent(event)
