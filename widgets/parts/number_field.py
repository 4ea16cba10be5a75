"""Fields for one number: `NumberField` with all its digits, `ShortField` in the rows.

`NumberDialog` reads and refuses like them. Qt's own dialog uses the system's locale, where a
decimal point may separate thousands: 33.5 would be read as 335.
"""

from PySide6.QtCore import QCoreApplication, QEvent, QSize, Qt
from PySide6.QtGui import QFocusEvent, QInputMethodEvent, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QLineEdit, QWidget

from app.languages import with_comma
from app.model.limits import within
from app.model.refusal import Refusal
from widgets.parts.labels import RefusalLabel
from widgets.parts.layouts import dialog_buttons, in_column
from widgets.parts.messages import FEW, all_digits, number_text, sentence
from widgets.parts.number_text import FIELD_CHARACTERS, parse_number, short_text
from widgets.parts.plain import PlainLabel

ALL_CHARACTERS = 18  # longest number, without its sign, that fits where all digits are shown
INSIDE_FIELD_PX = 2  # space that Qt leaves on both sides of a field's text
_LEAVE_TEXT = {
    Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Tab, Qt.Key.Key_Backtab, Qt.Key.Key_Escape,
    Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown,
    Qt.Key.Key_Shift, Qt.Key.Key_Control, Qt.Key.Key_Alt, Qt.Key.Key_AltGr, Qt.Key.Key_Meta,
}  # fmt: skip


def refusal(sentence: str) -> str:
    """Format the sentence of a refusal with a mark."""
    refused = QCoreApplication.translate("Row", "Not possible.")  # lupdate reads no f-strings
    return f"{refused} {sentence}"


def _may_edit(event: QEvent) -> bool:
    if isinstance(event, QKeyEvent):
        return event.type() == QEvent.Type.KeyPress and event.key() not in _LEAVE_TEXT
    if isinstance(event, QInputMethodEvent):
        return bool(event.commitString() or event.preeditString())
    kinds = QEvent.Type
    return event.type() in (kinds.MouseButtonPress, kinds.ContextMenu, kinds.Drop)


class NumberField(QLineEdit):
    """One number as text, with all its digits; its `unit` may follow it.

    A text that is being typed or was refused stays until it is read or discarded. The field passes
    Undo and Esc to the window when it does not need them.
    """

    def __init__(self, name: str, unit: str = "") -> None:
        super().__init__()
        self.name, self.unit = name, unit
        self.refused = False  # whether the text was refused
        self._number: float | None = None
        self.setAccessibleName(name)

    @property
    def at_rest(self) -> bool:
        """Whether the field shows its number, not a text that is being typed or was refused."""
        return not (self.refused or self.isModified())

    @property
    def is_typed_in(self) -> bool:
        """Whether keys go here, now or when the window becomes active again."""
        return self.window().focusWidget() is self

    def show_number(self, number: float | None) -> None:
        """Show a number, or none, when the field is at rest."""
        self._number = number
        self._write()

    def read(self, infinite: bool = False) -> float:
        """Return the number that is typed, or raise a `Refusal`; see `parse_number`."""
        return parse_number(self.name, self.text(), self.unit, infinite=infinite)

    def take_back(self) -> None:
        """Discard a typed or refused text, and show the number again."""
        self.setModified(False)
        self.refused = False
        self._write()

    def refuse(self, text: str) -> None:
        """Keep a refused text, so that the user can correct it."""
        self.refused = True
        place = self.cursorPosition()
        self._set_text(text)
        if self.hasFocus():
            self.setCursorPosition(place)

    def _text_of(self, number: float) -> str:
        return number_text(number)

    def _write(self) -> None:
        if self.at_rest:
            self._set_text("" if self._number is None else self._text_of(self._number))

    def _set_text(self, text: str) -> None:
        """Show a text from its start; a selection of the whole text stays."""
        all_selected = self.hasSelectedText() and self.selectedText() == self.text()
        self.setText(with_comma(text))
        self.setCursorPosition(0)
        if all_selected:
            self._select_to_start()

    def _select_to_start(self) -> None:
        """Select all with the cursor at the start, so that the start is visible."""
        self.setSelection(len(self.text()), -len(self.text()))

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride:
            if event.key() == Qt.Key.Key_Escape and not self.at_rest:
                event.accept()
                return True
            keys = QKeySequence.StandardKey
            if (event.matches(keys.Undo) and not self.isUndoAvailable()) or (
                event.matches(keys.Redo) and not self.isRedoAvailable()
            ):
                event.ignore()
                return False
        return super().event(event)


class ShortField(NumberField):
    """A narrow field that abbreviates its number until it has the focus."""

    def __init__(self, name: str, unit: str = "") -> None:
        super().__init__(name, unit)
        self.below: float | None = None
        self.above: float | None = None
        """Bounds that the number never reaches, even rounded for display; set by the owner."""
        self.characters = FIELD_CHARACTERS  # longest number without its sign; set by the owner
        self._whole = False
        all_digits.changed.connect(self._resize)

    def show_number(self, number: float | None) -> None:
        self._whole = self._whole and number == self._number
        super().show_number(number)

    def keep_between(self, above: float | None, below: float | None) -> None:
        """Set the bounds, which may change what is shown."""
        if (above, below) != (self.above, self.below):
            self.above, self.below = above, below
            shown = "" if self._number is None else with_comma(self._text_of(self._number))
            if self.text() != shown:
                self._write()

    def take_back(self) -> None:
        self._whole = False
        super().take_back()

    def _text_of(self, number: float) -> str:
        if self._whole or all_digits.now:
            return number_text(number)
        return short_text(number, self.below, FEW, self.above)

    def _resize(self) -> None:
        self._write()
        self.updateGeometry()

    def _show_whole(self, whole: bool) -> None:
        self._whole = whole
        self._write()

    def event(self, event: QEvent) -> bool:
        if not self._whole and _may_edit(event):
            self._show_whole(True)  # the user edits all digits, not the few that were shown
        return super().event(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        self._show_whole(True)  # first: Tab then selects the full number
        super().focusInEvent(event)
        if self.selectedText() == self.text():
            self._select_to_start()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self._show_whole(False)

    def sizeHint(self) -> QSize:
        return self.minimumSizeHint()

    def minimumSizeHint(self) -> QSize:
        hint, metrics = super().minimumSizeHint(), self.fontMetrics()
        characters = ALL_CHARACTERS if all_digits.now else self.characters
        widest = metrics.horizontalAdvance("-" + "0" * characters)
        frame = hint.width() - metrics.maxWidth()  # Qt's least width is one widest letter
        return QSize(widest + frame + 2 * INSIDE_FIELD_PX + 1, hint.height())  # 1: the cursor


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
