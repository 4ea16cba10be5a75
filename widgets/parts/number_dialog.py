"""Asks for one number, which is read and refused as in the rows of the controls.

Qt's own question reads and shows it in the system's locale, where a decimal point may be taken for
a mark between thousands: 33.5 typed would be 335.
"""

from __future__ import annotations

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QWidget

from app.model.limits import within
from app.model.refusal import Refusal
from widgets.parts.icons import RefusalLabel
from widgets.parts.layouts import in_column
from widgets.parts.messages import sentence
from widgets.parts.number_field import NumberField, refusal
from widgets.parts.plain import Label


class NumberDialog(QDialog):
    """The question for one number.

    Parameters
    ----------
    name : str
        What the number is: the title, and for the refusal.
    question : str
    value, low, high : float
        The number to begin with, and the least and the largest that is taken.
    unit : str
        What may follow the number.
    """

    def __init__(
        self,
        name: str,
        question: str,
        value: float,
        low: float,
        high: float,
        unit: str,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.number = value
        """The number taken last: that in hand, until another one is accepted."""
        self._name, self._low, self._high = name, low, high
        self.setWindowTitle(name)
        asked = Label(question, wordWrap=True)
        self.field = NumberField(name, unit)
        self.field.show_number(value)
        self.field.setAccessibleName(f"{name} ({unit})")
        self.field.selectAll()
        asked.setBuddy(self.field)
        self.problem = RefusalLabel()
        self.buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        in_column(asked, self.field, self.problem, self.buttons, on=self)

    def accept(self) -> None:
        """Take the number and close; or say what is wrong with it, and stay."""
        try:
            self.number = within(self._name, self.field.read(), self._low, self._high)
        except Refusal as error:
            said = refusal(sentence(error))
            self.problem.say(said)
            self.adjustSize()  # or the window keeps its height, and the texts are cut
            self.field.setAccessibleDescription(said)
            self.field.setFocus()
            self.field.selectAll()
            return
        super().accept()
