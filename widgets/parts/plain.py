"""Widgets for plain text: they show it literally and load nothing from it.

Qt interprets a text that looks like HTML and loads its pictures, but titles, units and names come
from files of strangers. These are the only labels, tooltips, message boxes, documents and texts to
read of this program; `tests/house/test_plain_text.py` checks it. Our own HTML is a `Markup`, which
escapes the texts that are filled in.
"""

import html
import re
import sys
from collections.abc import Iterable
from typing import Any

from PySide6 import QtGui
from PySide6.QtCore import QPoint, QPointF, QRectF, QSizeF, Qt, QUrl
from PySide6.QtWidgets import QLabel, QMessageBox, QTableWidgetItem, QTextEdit, QToolTip, QWidget


class Markup(str):
    """HTML of this program; every other text is plain."""

    __slots__ = ()

    @classmethod
    def of(cls, template: str, *parts: str) -> "Markup":
        """Fill the braces of an HTML template with plain texts."""
        return cls(template.format(*map(html.escape, parts)))


def wrapped(text: str) -> Markup:
    """Return a tooltip that wraps; Qt does not wrap plain ones."""
    return Markup.of("<qt>{}</qt>", text)


def subscripts(text: str) -> str:
    """Return a text with ``x_p`` as letters with subscripts; one without them as it is."""
    if "_" not in text:
        return text
    escaped = Markup.of("{}", text).replace("\n", "<br>")
    return Markup(re.sub(r"(?<=\w)_(\w+(?:→\w+)?)", r"<sub>\1</sub>", escaped))


def with_native_keys(text: str) -> str:
    """Write keys such as Ctrl+F as this system does: macOS has signs for them."""
    if sys.platform != "darwin":
        return text
    native = QtGui.QKeySequence.SequenceFormat.NativeText
    return re.sub(
        r"\b(?:(?:Ctrl|Alt|Shift|Meta)\+)+\w+",
        lambda match: QtGui.QKeySequence(match[0]).toString(native), text,
    )  # fmt: skip


def tip_of(text: str) -> str:
    """Return a text as Qt's tooltips, also those of models, must get it."""
    text = text if isinstance(text, Markup) else with_native_keys(text)
    if isinstance(text, Markup) or not QtGui.Qt.mightBeRichText(text):
        return text
    return wrapped(text)


def set_tip(target: QWidget | QtGui.QAction | QTableWidgetItem, text: str) -> None:
    target.setToolTip(tip_of(text))


def show_tip(place: QPoint, text: str, widget: QWidget | None = None) -> None:
    QToolTip.showText(place, tip_of(text), widget)


def show_tip_off(boxes: Iterable[QRectF], place: QPointF, widget: QWidget) -> None:
    """Show a widget's tooltip below a place in it, or where it hides less of these boxes."""
    metrics = QtGui.QFontMetrics(QToolTip.font())
    size = metrics.size(0, widget.toolTip()).toSizeF() + QSizeF(8.0, 8.0)

    def hidden(corner: QPointF) -> float:
        meets = [QRectF(place + corner, size).intersected(box) for box in boxes]
        return sum(each.width() * each.height() for each in meets)

    corners = [
        QPointF(x, y) for y in (16.0, -8.0 - size.height(), 40.0) for x in (2.0, -size.width())
    ]
    at = place + min(corners, key=hidden) - corners[0]  # Qt adds the first corner itself
    QToolTip.showText(widget.mapToGlobal(at.toPoint()), widget.toolTip(), widget)


class PlainLabel(QLabel):
    """A label that shows plain text unless it is a `Markup`."""

    def __init__(self, text: str = "", parent: QWidget | None = None, **properties: Any) -> None:
        super().__init__(parent, textFormat=Qt.TextFormat.PlainText, **properties)
        if text:
            self.setText(text)

    def setText(self, text: str) -> None:
        is_ours = isinstance(text, Markup)
        self.setTextFormat(Qt.TextFormat.RichText if is_ours else Qt.TextFormat.PlainText)
        super().setText(text)


class TextDocument(QtGui.QTextDocument):
    """A document that loads neither pictures nor styles."""

    def loadResource(self, kind: int, name: QUrl | str) -> Any:
        return None

    def paint(self, painter: QtGui.QPainter, place: QPointF, palette: QtGui.QPalette) -> None:
        context = QtGui.QAbstractTextDocumentLayout.PaintContext()
        context.palette = palette
        painter.save()
        painter.translate(place)
        self.documentLayout().draw(painter, context)
        painter.restore()


class ReadText(QTextEdit):
    """A text to read, some of which can be selected and copied, but not dragged away.

    Qt crashes if a text is deleted while a part of it is dragged, as when another step is shown.
    """

    def __init__(self) -> None:
        super().__init__(readOnly=True)
        self.setDocument(TextDocument(self))

    def mousePressEvent(self, event: QtGui.QMouseEvent) -> None:
        """Begin to select anew, also where something is selected."""
        is_left = event.button() == Qt.MouseButton.LeftButton
        if is_left and not event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
            self.setTextCursor(self.cursorForPosition(event.position().toPoint()))
        super().mousePressEvent(event)


def message_box(
    parent: QWidget, text: str, question: str = "", *, icon: QMessageBox.Icon | None = None
) -> QMessageBox:
    """Return a message box with a translated text and question; by default it is a warning."""
    box = QMessageBox(parent)
    is_ours = isinstance(text, Markup)
    box.setTextFormat(Qt.TextFormat.RichText if is_ours else Qt.TextFormat.PlainText)
    box.setIcon(QMessageBox.Icon.Warning if icon is None else icon)
    box.setText(text)
    box.setInformativeText(question)
    return box
