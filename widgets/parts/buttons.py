"""Functions that make buttons."""

import re
import sys
from typing import TypeVar

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractButton, QDialog, QDialogButtonBox, QPushButton, QToolButton

from widgets.parts.icons import show_icon
from widgets.parts.plain import set_tip

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
    return _filled(made, text, tip, act, name or (tip if icon and not text else ""))


def push_button(text: str, tip: str = "", act: object = None, *, name: str = "") -> QPushButton:
    """Make a push button; see `tool_button`."""
    return _filled(QPushButton(), text, tip, act, name)


def dialog_buttons(dialog: QDialog, accept: QDialogButtonBox.StandardButton) -> QDialogButtonBox:
    """Make the buttons that accept a dialog and cancel it."""
    buttons = QDialogButtonBox(accept | QDialogButtonBox.StandardButton.Cancel)
    buttons.accepted.connect(dialog.accept)
    buttons.rejected.connect(dialog.reject)
    return buttons


def _filled(made: _Button, text: str, tip: str, act: object, name: str) -> _Button:
    made.setText(text)
    if sys.platform == "darwin" and (letter := re.search(r"(?<!&)&(\w)", text)):
        made.setShortcut(f"Alt+{letter[1]}")  # as tips say; macOS has no mnemonics
    set_tip(made, tip)
    if name:
        made.setAccessibleName(name)
    if act is not None:
        made.clicked.connect(act)
    return made
