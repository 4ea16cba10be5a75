"""Text in widgets: whatever it says is shown as it stands, and nothing in it is loaded.

Qt takes a text that looks like HTML for HTML, and loads the pictures in it. Titles, units and names
come from files of strangers. So these are the only labels, tooltips, message boxes and documents of
this program, which `tests/house/test_plain_text.py` checks. Our own HTML is a `Markup`, which
escapes all that it is filled with.
"""

from __future__ import annotations

import html
from typing import Any

from PySide6 import QtGui
from PySide6.QtCore import QPoint, Qt, QUrl
from PySide6.QtGui import QAction, QTextDocument
from PySide6.QtWidgets import QLabel, QMessageBox, QTableWidgetItem, QToolTip, QWidget


class Markup(str):
    """HTML of our own: everything else is plain text."""

    __slots__ = ()

    @classmethod
    def of(cls, template: str, *parts: str) -> Markup:
        """Fill the braces of a template, which is HTML, with plain texts."""
        return cls(template.format(*map(html.escape, parts)))


def wrapped(text: str) -> Markup:
    """A text as a tooltip of several lines: Qt never wraps a plain one."""
    return Markup.of("<qt>{}</qt>", text)


def tip_of(text: str) -> str:
    """A text as Qt's tooltips and their roles in models take it."""
    if isinstance(text, Markup) or not QtGui.Qt.mightBeRichText(text):
        return text
    return wrapped(text)


def set_tip(target: QWidget | QAction | QTableWidgetItem, text: str) -> None:
    """Give something a tooltip."""
    target.setToolTip(tip_of(text))


def show_tip(place: QPoint, text: str, widget: QWidget | None = None) -> None:
    """Show a tooltip at once, at a place on the screen."""
    QToolTip.showText(place, tip_of(text), widget)


class Label(QLabel):
    """A label, for plain text unless it is a `Markup`."""

    def __init__(self, text: str = "", parent: QWidget | None = None, **properties: Any) -> None:
        super().__init__(parent, **properties)
        self.setTextFormat(Qt.TextFormat.PlainText)
        if text:
            self.setText(text)

    def setText(self, text: str) -> None:
        is_ours = isinstance(text, Markup)
        self.setTextFormat(Qt.TextFormat.RichText if is_ours else Qt.TextFormat.PlainText)
        super().setText(text)


class TextDocument(QTextDocument):
    """A document that loads nothing: no picture, no style, from nowhere."""

    def loadResource(self, kind: int, name: QUrl | str) -> Any:
        return None


def message_box(
    parent: QWidget, text: str, question: str = "", *, icon: QMessageBox.Icon | None = None
) -> QMessageBox:
    """A box that says something, and asks what is to be done about it.

    Parameters
    ----------
    parent : QWidget
    text, question : str
        Translated.
    icon : QMessageBox.Icon, optional
        That of a warning if not given.
    """
    box = QMessageBox(parent)
    is_ours = isinstance(text, Markup)
    box.setTextFormat(Qt.TextFormat.RichText if is_ours else Qt.TextFormat.PlainText)
    box.setIcon(QMessageBox.Icon.Warning if icon is None else icon)
    box.setText(text)
    box.setInformativeText(question)
    return box
