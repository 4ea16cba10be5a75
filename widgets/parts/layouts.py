"""Functions that make rows and columns of widgets, and paint them at once."""

from collections.abc import Iterable
from typing import TypeAlias, TypeVar

from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtWidgets import (
    QBoxLayout,
    QFrame,
    QHBoxLayout,
    QLayout,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from widgets.parts.focus import FocusRing

Part: TypeAlias = QWidget | QLayout | tuple[QWidget | QLayout, int | Qt.AlignmentFlag] | int | None
"""A part of a line: a widget or a layout, alone or with its stretch or alignment; a gap in pixels;
or `FREE`."""
FREE = None  # a stretch that takes the remaining room
TOP = Qt.AlignmentFlag.AlignTop  # alignment of a sign beside a text of several lines
_Line = TypeVar("_Line", bound=QBoxLayout)


def in_row(
    *parts: Part,
    on: QWidget | None = None,
    margins: tuple[int, int, int, int] | None = None,
    gap: int | None = None,
) -> QHBoxLayout:
    """Lay out parts side by side; the row fills the widget `on`.

    `margins` are left, above, right, below. They and the `gap` between parts are Qt's if not given.
    """
    return _filled(QHBoxLayout(), parts, on, margins, gap)


def in_column(
    *parts: Part,
    on: QWidget | None = None,
    margins: tuple[int, int, int, int] | None = None,
    gap: int | None = None,
) -> QVBoxLayout:
    """Lay out parts one below the other; see `in_row`."""
    return _filled(QVBoxLayout(), parts, on, margins, gap)


def _filled(
    line: _Line,
    parts: tuple[Part, ...],
    on: QWidget | None,
    margins: tuple[int, int, int, int] | None,
    gap: int | None,
) -> _Line:
    if margins is not None:
        line.setContentsMargins(*margins)
    if gap is not None:
        line.setSpacing(gap)
    for part in parts:
        if part is FREE:
            line.addStretch(1)
            continue
        if isinstance(part, int):
            line.addSpacing(part)
            continue
        added, how = part if isinstance(part, tuple) else (part, 0)
        stretch = 0 if isinstance(how, Qt.AlignmentFlag) else how
        if isinstance(added, QLayout):
            line.addLayout(added, stretch)
        else:
            line.addWidget(added, stretch)
        if isinstance(how, Qt.AlignmentFlag):
            line.setAlignment(added, how)
    if on is not None:
        # Last: if a filled line is added to a line on a widget, PySide wraps the items of the line,
        # and later takes whatever lies at the address of a deleted item for it.
        on.setLayout(line)
    return line


def discard(line: QLayout, widgets: Iterable[QWidget]) -> None:
    """Take widgets out of a line; they are hidden at once, and deleted later."""
    for widget in widgets:
        line.removeWidget(widget)
        widget.hide()
        widget.deleteLater()


def scrolled(inside: QWidget, name: str) -> QScrollArea:
    """Put a widget into a scroll area, named for screen readers."""
    area = QScrollArea(widgetResizable=True)
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setWidget(inside)
    area.setAccessibleName(name)
    FocusRing(area)
    return area


def paint_now(widget: QWidget) -> None:
    """Give everything its place, and paint it before the function returns."""
    for _ in range(2):  # the stage strip has other rows in another width
        QCoreApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest.value)
    widget.repaint()
