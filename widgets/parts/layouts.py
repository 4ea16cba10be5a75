"""Functions that make buttons, and rows and columns of widgets, and paint them at once."""

import re
import sys
from collections.abc import Iterable
from typing import TypeAlias, TypeVar

from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QBoxLayout,
    QDialog,
    QDialogButtonBox,
    QFrame,
    QHBoxLayout,
    QLayout,
    QPushButton,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from widgets.parts.focus import FocusRing
from widgets.parts.icons import show_icon
from widgets.parts.plain import set_tip

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


_Button = TypeVar("_Button", bound=QAbstractButton)


def tool_button(
    text: str = "",
    tip: str = "",
    act: object = None,
    *,
    icon: str = "",
    name: str = "",
    flat: bool = False,
    checkable: bool = False,
    by_click: bool = False,
) -> QToolButton:
    """Make a tool button; `act` is a function or a signal.

    `icon` is a name in `widgets.parts.icons`, and `name` is for screen readers, if neither the text
    nor the tip of an icon alone says it. A `flat` button has a frame only under the mouse. With
    `by_click` a click gives it the keyboard's focus, as Tab does.
    """
    made = QToolButton(autoRaise=flat)
    if icon:
        show_icon(made, icon)
        if text:
            made.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
    if by_click:
        made.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    made.setCheckable(checkable)
    return _labelled(made, text, tip, act, name or (tip if icon and not text else ""))


def push_button(text: str, tip: str = "", act: object = None, *, name: str = "") -> QPushButton:
    """Make a push button; see `tool_button`."""
    return _labelled(QPushButton(), text, tip, act, name)


def dialog_buttons(dialog: QDialog, accept: QDialogButtonBox.StandardButton) -> QDialogButtonBox:
    """Make the buttons that accept a dialog and cancel it."""
    buttons = QDialogButtonBox(accept | QDialogButtonBox.StandardButton.Cancel)
    buttons.accepted.connect(dialog.accept)
    buttons.rejected.connect(dialog.reject)
    return buttons


def _labelled(made: _Button, text: str, tip: str, act: object, name: str) -> _Button:
    made.setText(text)
    if sys.platform == "darwin" and (letter := re.search(r"(?<!&)&(\w)", text)):
        made.setShortcut(f"Alt+{letter[1]}")  # as tips say; macOS has no mnemonics
    set_tip(made, tip)
    if name:
        made.setAccessibleName(name)
    if act is not None:
        made.clicked.connect(act)
    return made
