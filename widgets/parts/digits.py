"""How many digits are shown where numbers are read: four, or all that there are.

No number is rounded by it: what is copied, and what is typed in, has all of its digits.
"""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from widgets.parts.messages import figure_text, number_text

FEW = 4
"""Significant digits of a number that is read."""


class Digits(QObject):
    """Whether all digits are shown, of all fields and readouts of the program.

    Attributes
    ----------
    all : bool
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.all = False


digits = Digits()


def set_all_digits(all_digits: bool) -> None:
    """Show all digits, or four."""
    if all_digits != digits.all:
        digits.all = all_digits
        digits.changed.emit()


def read_text(value: float) -> str:
    """A number that is read: four digits of it, or all of them."""
    return number_text(value) if digits.all else figure_text(value, FEW)
