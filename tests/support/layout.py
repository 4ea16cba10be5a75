"""What the layout of a window says of its texts: which are cut, and which lie on each other."""

import itertools

from PySide6.QtCore import QRect, QSize, Qt
from PySide6.QtGui import QTextDocument
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractScrollArea,
    QCheckBox,
    QComboBox,
    QLabel,
    QLineEdit,
    QScrollBar,
    QToolButton,
    QWidget,
)

from widgets.parts.labels import NoteLabel, Title
from widgets.parts.typeset import TypesetLabel


def texts(window: QWidget) -> list[QWidget]:
    """The labels and buttons that are seen and have a text, but not those in menus."""
    found: list[QWidget] = []
    for kind in (QLabel, QAbstractButton):
        found += [w for w in window.findChildren(kind) if w.isVisible() and w.text()]
    return found


def needed(widget: QWidget) -> QSize:
    """The room of a widget's text: of what may be wrapped, in the width that it has."""
    if isinstance(widget, TypesetLabel) and widget.formula:
        return widget.minimumSizeHint()
    if isinstance(widget, QLabel):
        if widget.wordWrap():
            return QSize(0, widget.heightForWidth(widget.width()))
        document = QTextDocument()
        document.setDocumentMargin(0)
        document.setDefaultFont(widget.font())
        rich = widget.textFormat() == Qt.TextFormat.RichText or "<" in widget.text()
        (document.setHtml if rich else document.setPlainText)(widget.text())
        return QSize(int(document.idealWidth()), widget.fontMetrics().ascent())
    assert isinstance(widget, QAbstractButton)
    lines = widget.text().replace("&", "").split("\n")
    metrics = widget.fontMetrics()
    widest = max(map(metrics.horizontalAdvance, lines))
    size = QSize(widest, metrics.ascent() + metrics.lineSpacing() * (len(lines) - 1))
    if isinstance(widget, QToolButton):
        style = widget.toolButtonStyle()
        if style == Qt.ToolButtonStyle.ToolButtonIconOnly and not widget.icon().isNull():
            return QSize(0, 0)
        if style == Qt.ToolButtonStyle.ToolButtonTextBesideIcon:
            size += QSize(widget.iconSize().width(), 0)
    if isinstance(widget, QCheckBox):
        size += QSize(16, 0)
    return size


def place(widget: QWidget, window: QWidget) -> QRect:
    """Where it is in the window."""
    return QRect(widget.mapTo(window, widget.rect().topLeft()), widget.size())


def scrolled_by(widget: QWidget) -> QAbstractScrollArea | None:
    """What scrolls it, if something does: what lies outside can be brought into view there."""
    parent = widget.parentWidget()
    while parent is not None:
        if isinstance(parent, QAbstractScrollArea):
            return parent
        parent = parent.parentWidget()
    return None


def cut(window: QWidget) -> list[str]:
    """The texts that have less room than they need, or lie outside of what can be seen."""
    found = []
    for widget in texts(window):
        text = widget.text()  # type: ignore[attr-defined]
        if isinstance(widget, NoteLabel) and not isinstance(widget, Title):
            continue  # which says all of it in its tooltip
        need = needed(widget)
        if need.width() > widget.width() + 1 or need.height() > widget.height() + 1:
            found.append(f"{text!r} needs {need.toTuple()}, has {widget.size().toTuple()}")
        area = scrolled_by(widget)
        if area is None and not window.rect().contains(place(widget, window)):
            found.append(f"{text!r} is at {place(widget, window).getRect()}")
        elif area is not None:
            bar = area.horizontalScrollBar()
            sides = place(widget, area.viewport())
            outside = sides.left() < 0 or sides.right() > area.viewport().width()
            if outside and bar.maximum() == bar.minimum():
                found.append(f"{text!r} is beside what {area.accessibleName()!r} shows")
    for field in (field for field in window.findChildren(QLineEdit) if field.isVisible()):
        across = field.fontMetrics().horizontalAdvance(field.displayText())
        if field.text() and across > field.contentsRect().width() - 4:
            found.append(f"{field.accessibleName()} = {field.text()}")
    for box in (box for box in window.findChildren(QComboBox) if box.isVisible()):
        longest = max(map(box.itemText, range(box.count())), key=len, default="")
        if box.fontMetrics().horizontalAdvance(longest) > box.width() - 24:
            found.append(longest)
    return found


def overlapping(window: QWidget) -> list[str]:
    """The pairs of texts that lie on each other."""
    seen = [
        (widget, place(widget, window))
        for widget in texts(window)
        if scrolled_by(widget) is None or widget.visibleRegion().boundingRect() == widget.rect()
    ]
    return [
        f"{one.text()!r} on {other.text()!r}"  # type: ignore[attr-defined]
        for (one, a), (other, b) in itertools.combinations(seen, 2)
        if a.adjusted(1, 1, -1, -1).intersects(b.adjusted(1, 1, -1, -1))
        and not one.isAncestorOf(other)
        and not other.isAncestorOf(one)
        and not isinstance(one, QScrollBar)
    ]
