"""A dialog for one number, which it reads and refuses like the rows of the controls.

Qt's own dialog uses the system's locale, where a decimal point may separate thousands: 33.5 would
be read as 335.
"""

from PySide6.QtWidgets import QDialog, QDialogButtonBox, QWidget

from app.model.limits import within
from app.model.refusal import Refusal
from widgets.parts.buttons import dialog_buttons
from widgets.parts.icons import RefusalLabel
from widgets.parts.layouts import in_column
from widgets.parts.messages import sentence
from widgets.parts.number_field import NumberField, refusal
from widgets.parts.plain import PlainLabel


class NumberDialog(QDialog):
    """A dialog for a number from `low` to `high`; `name` is the title and the refusal's field."""

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
        self.number = value  # the first number, until the user accepts another one
        self._name, self._low, self._high = name, low, high
        self.setWindowTitle(name)
        asked = PlainLabel(question, wordWrap=True)
        self.field = NumberField(name, unit)
        self.field.show_number(value)
        self.field.setAccessibleName(f"{name} ({unit})")
        self.field.selectAll()
        asked.setBuddy(self.field)
        self.problem = RefusalLabel()
        self.buttons = dialog_buttons(self, QDialogButtonBox.StandardButton.Ok)
        in_column(asked, self.field, self.problem, self.buttons, on=self)

    def accept(self) -> None:
        """Accept the number and close, or refuse it and stay open."""
        try:
            self.number = within(self._name, self.field.read(), self._low, self._high)
        except Refusal as error:
            said = refusal(sentence(error))
            self.problem.show_text(said)
            self.adjustSize()  # otherwise the window keeps its height and cuts the texts
            self.field.setAccessibleDescription(said)
            self.field.setFocus()
            self.field.selectAll()
            return
        super().accept()
