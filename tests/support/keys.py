"""The keys with Alt that a window has, and which of them mean two things at once."""

from collections.abc import Iterator

from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QAbstractButton, QDialogButtonBox, QLabel, QMenuBar, QTabBar, QWidget

GNOME = {"Cancel": "&Cancel", "Close": "&Close", "OK": "&OK", "Save": "&Save"}
"""What Qt writes on its own buttons on a desktop of GNOME; elsewhere they have no letter."""


def clashes(window: QWidget) -> dict[str, list[str]]:
    """Return the keys with which two or more things that are seen can be meant."""
    found: dict[str, list[str]] = {}
    for text, keys in _things(window):
        for key in keys:
            if not key.isEmpty():
                found.setdefault(key.toString(), []).append(text)
    return {key: texts for key, texts in found.items() if len(texts) > 1}


def _things(window: QWidget) -> Iterator[tuple[str, list[QKeySequence]]]:
    """Yield what in a window has keys, by its text."""
    for widget in (each for each in window.findChildren(QWidget) if each.window() is window):
        if not widget.isVisible() or not widget.isEnabled():
            continue
        if isinstance(widget, QAbstractButton):
            box = widget.parentWidget()
            is_qts = isinstance(box, QDialogButtonBox) and box.standardButton(widget)
            text = GNOME.get(widget.text(), "") if is_qts else ""
            yield widget.text(), [_letter(text) if text else widget.shortcut()]
        elif isinstance(widget, QLabel) and widget.buddy() is not None:
            yield widget.text(), [_letter(widget.text())]
        elif isinstance(widget, QMenuBar):
            seen = (each for each in widget.actions() if each.isVisible() and each.isEnabled())
            yield from ((each.text(), [_letter(each.text())]) for each in seen)
        elif isinstance(widget, QTabBar):
            names = map(widget.tabText, range(widget.count()))
            yield from ((name, [_letter(name)]) for name in names)
    for action in window.findChildren(QAction):
        if action.associatedObjects() and action.isEnabled() and action.isVisible():
            yield action.text(), action.shortcuts()


def _letter(text: str) -> QKeySequence:
    return QKeySequence.mnemonic(text)
