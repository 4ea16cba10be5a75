"""Roles that tell a screen reader what a widget is, where Qt's own role would mislead."""

from functools import cache

from PySide6.QtCore import QObject
from PySide6.QtGui import QAccessible, QAccessibleInterface
from PySide6.QtWidgets import QAbstractButton, QAccessibleWidget, QWidget

_ROLE, _MADE = "screenReaderRole", "screenReaderInterface"
"""Properties of a widget. Qt deletes an interface just before its widget; without a reference of
the widget, Python would delete it earlier."""


class _Tab(QAccessibleWidget):
    """A checkable button as one of several tabs."""

    def state(self) -> QAccessible.State:
        state, button = super().state(), self.object()
        assert isinstance(button, QAbstractButton)
        state.selectable, state.selected = 1, int(button.isChecked())
        return state

    def actionNames(self) -> list[str]:
        return [self.pressAction()]

    def doAction(self, _name: str) -> None:
        button = self.object()
        assert isinstance(button, QAbstractButton)
        button.click()


def give_role(widget: QWidget, role: QAccessible.Role) -> None:
    """Give a widget another role, before it is shown; a tab must be a button."""
    _install()
    widget.setProperty(_ROLE, role.value)


@cache
def _install() -> None:
    QAccessible.installFactory(_interface)


def _interface(_name: str, of: QObject) -> QAccessibleInterface | None:
    number = of.property(_ROLE)
    if number is None or not isinstance(of, QWidget):
        return None
    role = QAccessible.Role(number)
    made = (_Tab if role == QAccessible.Role.PageTab else QAccessibleWidget)(of, role)
    of.setProperty(_MADE, made)
    return made
