"""One row of the controls: a name, an input for a value, and an error line.

A row holds the unfinished input of one value (a drag, a typed text, a refused text); it does not
depend on the model. Its signals report the user's own actions only:

    user -> row.edited(value) -> owner accepts silently, or calls row.show_error(sentence)
    owner -> row.setValue(value)     no signal follows

`gesture_started` and `gesture_finished` enclose edits that belong together: a drag, a burst of
keys or wheel steps, one typed value, one reset. `gesture_abandoned` precedes `gesture_finished` if
all these edits must be undone.
"""

from abc import abstractmethod
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from PySide6 import QtGui
from PySide6.QtCore import QEvent, Qt, Signal, SignalInstance
from PySide6.QtWidgets import QButtonGroup, QCheckBox, QComboBox, QGridLayout, QSizePolicy, QWidget

from app.lecture.highlight import NOTHING, Highlight
from app.model.parameter import read_content
from widgets.parts.gestures import Gestures
from widgets.parts.icons import Combo
from widgets.parts.labels import Balanced, RefusalLabel
from widgets.parts.layouts import in_row, tool_button
from widgets.parts.number_field import refusal
from widgets.parts.panel import TintedWidget
from widgets.parts.plain import set_tip, wrapped

ROW_GAP_PX = 4  # between the parts of a row
ONE_LINE_EM = 11  # largest width, in line heights, of a name and a choice that share a line
_BY_KEYS = {
    Qt.FocusReason.TabFocusReason,
    Qt.FocusReason.BacktabFocusReason,
    Qt.FocusReason.ShortcutFocusReason,
}
_BUTTONS = read_content(Path(__file__).with_name("content") / "buttons.qss")


class _NameLabel(Balanced):
    double_clicked = Signal()

    def mouseDoubleClickEvent(self, event: QtGui.QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.double_clicked.emit()


class Row(TintedWidget, QWidget, Gestures):
    """The name, the reset, the error line and the gestures that all rows share.

    Both texts are translated; `tip` is a sentence about the effect of the value in the lectures'
    terms.
    """

    edited = Signal(object)  # the user chose this value
    highlighted = Signal(bool)  # whether the mouse is over the row, or the keyboard's focus in it

    def __init__(self, name: str, tip: str) -> None:
        super().__init__()
        self.name, self.tip = name, tip
        self.error = ""  # the sentence shown below the row, or nothing
        self._attending: set[str] = set()  # by mouse and keyboard
        self._value: Any = None
        self._default: Any = None
        self._error: RefusalLabel | None = None
        self._refused = False
        how_to_reset = self.tr("Double-click the name to reset it.")
        self._tip = f"{tip} {how_to_reset}"
        self._tips: dict[QWidget, str] = {}
        self.name_label = _NameLabel(name)
        self._set_tip(self.name_label, self._tip)
        self.name_label.double_clicked.connect(self.reset)
        self._reset_action = QtGui.QAction(self.tr("Reset {0}").format(name), self)
        self._reset_action.triggered.connect(self.reset)
        self.addAction(self._reset_action)  # also by the menu key or the right mouse button
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(ROW_GAP_PX)
        self._grid.setVerticalSpacing(1)
        self._grid.setColumnStretch(0, 1)
        self._grid.addWidget(self.name_label, 0, 0)
        # Fixed would keep the row at its size hint, which ignores how often the error wraps.
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)

    def take_focus(self) -> None:
        """Give the focus to the field or the box of the row."""
        buddy = self.name_label.buddy()
        if buddy is not None:
            buddy.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def value(self) -> Any:
        return self._value

    def setValue(self, value: Any) -> None:
        """Show a value without a signal; keep a text that is being typed."""
        if value != self._value:
            self._value = value
            self.clear_error()
            self._show_value()

    def setDefault(self, value: Any) -> None:
        """Set the value that a reset goes back to."""
        self._default = value

    def reset(self) -> None:
        """Return to the default, as an edit by the user."""
        self.clear_error()
        if self._default is not None and self._default != self._value:
            self._make_edit(self._default)

    @property
    def at_rest(self) -> bool:
        """Whether the row shows its value, with nothing refused or unfinished."""
        return True

    @property
    def in_hand(self) -> bool:
        """Whether the user drags the row or types in it."""
        return False

    def show_error(self, sentence: str) -> None:
        """Refuse the last edit, and say why below the row."""
        self._refused = True
        self._show_refusal(refusal(sentence))

    def _show_refusal(self, text: str) -> None:
        if self._error is None:
            self._error = RefusalLabel()
            self._grid.addWidget(self._error, 2, 0, 1, self._grid.columnCount())
        self._error.show_text(text)
        self.error = text
        for part, tip in self._tips.items():
            part.setAccessibleDescription(text or tip)

    def clear_error(self) -> None:
        """Remove the error and the refused text."""
        if self.error:
            self._show_refusal("")
            self._show_value()

    def finish_gesture(self) -> None:
        """End the gesture in progress, if there is one."""

    def _attempt(self, value: Any) -> bool:
        """Offer a value to the owner; keep it unless the owner refuses it."""
        before, self._value = self._value, value
        self._refused = False
        self.edited.emit(value)
        if self._refused and self._value == value:
            self._value = before
        return not self._refused

    def _make_edit(self, value: Any) -> None:
        self.finish_gesture()
        self.gesture_started.emit()
        self._attempt(value)
        self.gesture_finished.emit()
        self._show_value()

    @abstractmethod
    def _show_value(self) -> None:
        """Write the value into the row's widgets."""

    def _set_tip(self, part: QWidget, tip: str) -> None:
        """Set a part's tooltip, and its description without markup for a screen reader."""
        set_tip(part, wrapped(tip))
        part.setAccessibleDescription(tip)
        self._tips[part] = tip

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and self.error:
            self.clear_error()
        else:
            super().keyPressEvent(event)

    # -- highlight

    def _attend(self, by: str, is_here: bool) -> None:
        before = bool(self._attending)
        (self._attending.add if is_here else self._attending.discard)(by)
        if bool(self._attending) != before:
            self.highlighted.emit(not before)

    def enterEvent(self, event: QtGui.QEnterEvent) -> None:
        super().enterEvent(event)
        self._attend("mouse", True)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._attend("mouse", False)

    def hideEvent(self, event: QtGui.QHideEvent) -> None:
        super().hideEvent(event)
        self._attend("mouse", False)
        self._attend("keyboard", False)

    def eventFilter(self, watched: Any, event: QEvent) -> bool:
        if isinstance(event, QtGui.QFocusEvent):  # a click's is covered by the mouse's own events
            self._attend("keyboard", event.gotFocus() and event.reason() in _BY_KEYS)
        # Of all other events the type is not asked: hundreds come with another scene.
        is_one = isinstance(event, QtGui.QFocusEvent | QtGui.QHelpEvent)
        if is_one and event.type() in (QEvent.Type.FocusIn, QEvent.Type.ToolTip):
            self._describe_part(watched)
        return False

    def _describe_part(self, part: QWidget) -> None:
        """Bring what a part says about the value up to date, now that somebody reads it."""


def report_highlight(row: Row, highlighted: SignalInstance, key: str, about: Highlight) -> None:
    """Emit a row's key and what it is about when the row is highlighted, and then `NOTHING`."""
    row.highlighted.connect(lambda is_here: highlighted.emit(key, about if is_here else NOTHING))


class Option(NamedTuple):
    """One option: its key, translated text and explanation."""

    key: str
    text: str
    tip: str = ""


class ChoiceRow(Row):
    """A row to choose one of a few options: a combo box, or `buttons` side by side.

    Buttons take one click instead of two. A combo box shows `none` while no option is chosen.
    """

    def __init__(
        self,
        name: str,
        tip: str,
        choices: Sequence[Option],
        *,
        buttons: bool = False,
        none: str = "",
    ) -> None:
        super().__init__(name, tip)
        self.keys = [choice.key for choice in choices]
        self._value: str | None = self.keys[0]
        self._combo: QComboBox | None = None
        self._group = QButtonGroup(self)
        if buttons:
            self.widgets: list[QWidget] = self._make_buttons(choices)
        else:
            self.widgets = [self._make_combo(choices, none)]
        self.name_label.setBuddy(self.widgets[0])
        for widget in self.widgets:
            widget.installEventFilter(self)
        self._show_value()

    def _make_combo(self, choices: Sequence[Option], none: str) -> QComboBox:
        self._combo = combo = Combo()
        policy = QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        combo.setSizeAdjustPolicy(policy)  # a long translation must not widen the column
        combo.setPlaceholderText(none)
        for index, choice in enumerate(choices):
            combo.addItem(choice.text)
            combo.setItemData(index, wrapped(choice.tip), Qt.ItemDataRole.ToolTipRole)
        combo.setAccessibleName(self.name)
        self._set_tip(combo, self._tip)
        combo.activated.connect(self._chosen)  # by the user only
        longest = max((*(choice.text for choice in choices), none), key=len)
        metrics = self.fontMetrics()
        if metrics.horizontalAdvance(f"{self.name}  {longest}") > ONE_LINE_EM * metrics.height():
            self._grid.addWidget(combo, 1, 0, 1, 4)
        else:
            combo.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
            self._grid.addWidget(combo, 0, 1)
        return combo

    def _make_buttons(self, choices: Sequence[Option]) -> list[QWidget]:
        made: list[QWidget] = []
        row = in_row(gap=2)
        self._grid.addLayout(row, 0, 1)
        for index, choice in enumerate(choices):
            name = f"{self.name}: {choice.text}"
            button = tool_button(choice.text, name=name, checkable=True, by_click=True)
            button.setStyleSheet(_BUTTONS)
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            self._set_tip(button, f"{choice.tip} {self._tip}".strip())
            self._group.addButton(button, index)
            row.addWidget(button)
            made.append(button)
        self._group.idClicked.connect(self._chosen)
        return made

    def _chosen(self, index: int) -> None:
        key = self.keys[index]
        self.clear_error()
        if key == self._value:
            self._show_value()
        else:
            self._make_edit(key)

    def _show_value(self) -> None:
        index = self.keys.index(self._value) if self._value in self.keys else -1
        if self._combo is not None:
            self._combo.setCurrentIndex(index)
            return
        self._group.setExclusive(False)  # an exclusive group cannot show that none is chosen
        for position, button in enumerate(self._group.buttons()):
            button.setChecked(position == index)
        self._group.setExclusive(True)


class CheckRow(Row):
    """A switch: a check box after its name."""

    def __init__(self, name: str, tip: str) -> None:
        super().__init__(name, tip)
        self._value = False
        self.box = QCheckBox()
        self.box.setAccessibleName(name)
        self._set_tip(self.box, self._tip)
        self.box.clicked.connect(self._make_edit)  # by the user only
        self.name_label.setBuddy(self.box)
        self._grid.addWidget(self.box, 0, 1, Qt.AlignmentFlag.AlignLeft)

    def _show_value(self) -> None:
        self.box.setChecked(self._value)


class RowHolder(Gestures):
    """A widget with rows, of which one at a time has a gesture; it forwards that gesture."""

    rows: dict[str, Row]

    def _join(self, row: Row) -> None:
        row.gesture_started.connect(partial(self._finish_others, row))
        self.pass_on(row)

    def _finish_others(self, row: Row) -> None:
        for other in self.rows.values():
            if other is not row:
                other.finish_gesture()  # a burst of keys in another row may not have ended yet
