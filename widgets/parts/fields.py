"""One row of the controls: a name, a way to choose a value, and an error line.

A row keeps what the user is doing to one value (dragging, typing, a refused text); it does not
know the model. Its signals report the user's own actions only:

    user -> row.edited(value) -> owner accepts silently, or calls row.show_error(sentence)
    owner -> row.setValue(value)     no signal follows

`gesture_started` and `gesture_finished` enclose edits that belong together: a drag, a burst of
keys or wheel steps, one typed value, one reset. `gesture_abandoned` comes before
`gesture_finished` if all of them must be put back.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

from PySide6.QtCore import QEvent, QSignalBlocker, Qt, QTimer, Signal
from PySide6.QtGui import (
    QAction,
    QEnterEvent,
    QFocusEvent,
    QHideEvent,
    QKeyEvent,
    QMouseEvent,
    QPalette,
    QWheelEvent,
)
from PySide6.QtWidgets import (
    QBoxLayout,
    QButtonGroup,
    QCheckBox,
    QComboBox,
    QGridLayout,
    QSizePolicy,
    QSlider,
    QStyle,
    QStyleOptionSlider,
    QWidget,
)

from app.model.projection import FINITE_NUMBER
from app.model.refusal import Refusal
from widgets.parts.buttons import tool_button
from widgets.parts.combo import Combo
from widgets.parts.escape import HeldSlider
from widgets.parts.gestures import Gestures
from widgets.parts.highlight import Marked
from widgets.parts.icons import RefusalLabel
from widgets.parts.layouts import in_row
from widgets.parts.messages import (
    A_NUMBER,
    A_NUMBER_LIKE,
    A_NUMBER_OR_INFINITY,
    number_text,
    sentence,
)
from widgets.parts.note import Balanced
from widgets.parts.number_field import ShortField, refusal
from widgets.parts.number_text import short_text
from widgets.parts.plain import Label, Markup, set_tip, wrapped
from widgets.parts.scales import Scale, Stops
from widgets.parts.writing import all_digits

QUIET_MS = 500
"""Keys and wheel steps with less than this between them are one gesture."""
ROW_GAP_PX = 4
"""Between the parts of a row."""
LEAST_SLIDER_PX = 150
"""A shorter slider has more values than a hand can tell apart."""
FINE = 0.1
"""How far the slider follows the mouse with Shift, relative to a drag without."""
VECTOR_CHARACTERS = 6
"""Longest number, without its sign, that has room where three stand side by side."""
ONE_LINE_EM = 11
"""A name and a choice that are wider together, in heights of a line, take two lines."""
EXAMPLES = (0.5, 2e-3)
"""The numbers that `A_NUMBER` names."""
_NOTCH = 120
"""Eighths of a degree, in which Qt measures the wheel; a finer wheel turns by less."""
_BY_KEYS = {
    Qt.FocusReason.TabFocusReason,
    Qt.FocusReason.BacktabFocusReason,
    Qt.FocusReason.ShortcutFocusReason,
}
_BUTTONS = """
QToolButton {
    background: palette(button); color: palette(button-text);
    border: 1px solid palette(mid); border-radius: 3px; padding: 2px 1px;
}
QToolButton:checked {
    background: palette(highlight); color: palette(highlighted-text); font-weight: 600;
}
QToolButton:hover, QToolButton:focus { border-color: palette(text); }
"""
"""Fusion hardly shows which of two dark buttons is down."""


class _Name(Balanced):
    double_clicked = Signal()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.double_clicked.emit()


class _Slider(HeldSlider):
    """A slider that moves slowly with Shift.

    It leaves the wheel to the column unless it has the focus or Ctrl is held.
    """

    def __init__(self) -> None:
        super().__init__()
        self.stops = Stops(1, 1, 1, 1)
        self._mouse_x = self._at = 0.0
        self._turned = 0
        self.setMinimumWidth(LEAST_SLIDER_PX)
        self.actionTriggered.connect(self._acted)

    def _go_to(self, position: float, *, fine: bool) -> None:
        step = 1 if fine else self.stops.coarse
        self.setSliderPosition(round(position / step) * step)

    def _acted(self, action: int) -> None:
        """Let keys stop where a drag does; Qt sets the value after this."""
        if action != QSlider.SliderAction.SliderMove.value:
            self._go_to(self.sliderPosition(), fine=False)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        super().mousePressEvent(event)
        self._mouse_x, self._at = event.position().x(), float(self.sliderPosition())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self.is_abandoned or not self.isSliderDown():
            super().mouseMoveEvent(event)
            return
        option = QStyleOptionSlider()
        self.initStyleOption(option)
        handle = self.style().pixelMetric(QStyle.PixelMetric.PM_SliderLength, option, self)
        a_pixel = (self.maximum() - self.minimum()) / max(1, self.width() - handle)
        is_fine = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        moved, self._mouse_x = event.position().x() - self._mouse_x, event.position().x()
        if self.layoutDirection() == Qt.LayoutDirection.RightToLeft:
            moved = -moved
        self._at += moved * a_pixel * (FINE if is_fine else 1.0)
        self._go_to(self._at, fine=is_fine)

    def wheelEvent(self, event: QWheelEvent) -> None:
        if not (self.hasFocus() or event.modifiers() & Qt.KeyboardModifier.ControlModifier):
            event.ignore()
            return
        turned = event.angleDelta()
        self._turned += turned.y() or turned.x()  # some systems turn it with Shift
        notches = int(self._turned / _NOTCH)
        self._turned -= notches * _NOTCH
        if notches:
            is_fine = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            self._go_to(self.value() + notches * (1 if is_fine else self.stops.notch), fine=is_fine)
        event.accept()


class _Combo(Combo):
    """A combo box that leaves the wheel to the column until it has the focus."""

    def __init__(self) -> None:
        super().__init__()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        policy = QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        self.setSizeAdjustPolicy(policy)  # a long translation must not widen the column

    def wheelEvent(self, event: QWheelEvent) -> None:
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()


class Row(Marked, QWidget, Gestures):
    """The name, the reset, the error line and the gestures that all rows share.

    Parameters
    ----------
    name : str
        Translated name, shown and read aloud.
    tip : str
        Translated sentence about the effect of the value, in the lectures' terms.
    """

    edited = Signal(object)
    """The user chose this value."""
    highlighted = Signal(bool)
    """Whether the mouse is over the row, or the keyboard came into it."""

    def __init__(self, name: str, tip: str) -> None:
        super().__init__()
        self.name, self.tip = name, tip
        self.error = ""
        """The sentence shown below the row, or nothing."""
        self._attending: set[str] = set()  # of mouse and keyboard
        self._value: Any = None
        self._default: Any = None
        self._error: RefusalLabel | None = None
        self._refused = False
        how_to_reset = self.tr("Double-click the name to reset it.")
        self._tip = f"{tip} {how_to_reset}"
        self._told: dict[QWidget, str] = {}
        self.name_label = _Name(name)
        self._tell(self.name_label, self._tip)
        self.name_label.double_clicked.connect(self.reset)
        self._reset_action = QAction(self.tr("Reset {0}").format(name), self)
        self._reset_action.triggered.connect(self.reset)
        self.addAction(self._reset_action)  # also by the menu key or the right mouse button
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(ROW_GAP_PX)
        self._grid.setVerticalSpacing(1)
        self._grid.setColumnStretch(0, 1)
        self._grid.addWidget(self.name_label, 0, 0)
        # Fixed would hold the row at its size hint, which does not know how often the error wraps.
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)

    def take_focus(self) -> None:
        """Give the keyboard to the field or the box of the row."""
        buddy = self.name_label.buddy()
        if buddy is not None:
            buddy.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def value(self) -> Any:
        """Return the value shown."""
        return self._value

    def setValue(self, value: Any) -> None:
        """Show a value without a signal. A text that is being typed stays."""
        if value != self._value:
            self._value = value
            self.clear_error()
            self._show_value()

    def setDefault(self, value: Any) -> None:
        """Set the value that a reset goes back to."""
        self._default = value

    def reset(self) -> None:
        """Go back to the default, as an edit by the user."""
        self.clear_error()
        if self._default is not None and self._default != self._value:
            self._make_edit(self._default)

    @property
    def at_rest(self) -> bool:
        """Whether the row shows its value, and nothing refused or unfinished."""
        return True

    @property
    def in_hand(self) -> bool:
        """Whether the user drags the row or types in it."""
        return False

    def show_error(self, sentence: str) -> None:
        """Refuse what was just edited, and say why below the row."""
        self._refused = True
        self._show_refusal(refusal(sentence))

    def _show_refusal(self, text: str) -> None:
        if self._error is None:
            self._error = RefusalLabel()
            self._grid.addWidget(self._error, 2, 0, 1, self._grid.columnCount())
        self._error.say(text)
        self.error = text
        for part, tip in self._told.items():
            part.setAccessibleDescription(text or tip)

    def clear_error(self) -> None:
        """Remove the error and the refused text."""
        if self.error:
            self._show_refusal("")
            self._show_value()

    def finish_gesture(self) -> None:
        """End the gesture in progress, if there is one."""

    def _attempt(self, value: Any) -> bool:
        """Offer a value to the owner, and keep it if the owner does not refuse it."""
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

    def _tell(self, part: QWidget, tip: str) -> None:
        """Describe a part by its tooltip, and to a screen reader without the markup."""
        set_tip(part, wrapped(tip))
        part.setAccessibleDescription(tip)
        self._told[part] = tip

    def keyPressEvent(self, event: QKeyEvent) -> None:
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

    def enterEvent(self, event: QEnterEvent) -> None:
        super().enterEvent(event)
        self._attend("mouse", True)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._attend("mouse", False)

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._attend("mouse", False)
        self._attend("keyboard", False)

    def eventFilter(self, watched: Any, event: QEvent) -> bool:
        if isinstance(
            event, QFocusEvent
        ):  # a focus by a click is the mouse's, which attends itself
            self._attend("keyboard", event.gotFocus() and event.reason() in _BY_KEYS)
        return super().eventFilter(watched, event)


class _TypedRow(Row):
    """A row with number fields; each is typed, refused and taken back by itself."""

    def _add_fields(self, *fields: ShortField) -> None:
        self.fields = fields
        self.name_label.setBuddy(fields[0])
        for field in fields:
            field.editingFinished.connect(partial(self._typed, field))

    @abstractmethod
    def _read(self, field: ShortField) -> Any:
        """Return the row's value with the number that is typed in a field, or raise `Refusal`."""

    @property
    @abstractmethod
    def _numbers(self) -> tuple[float, ...]:
        """The number of each field."""

    def _show_value(self) -> None:
        for field, number in zip(self.fields, self._numbers, strict=True):
            field.show_number(number)

    def _why(self, error: Refusal) -> str:
        """Return the sentence about a text that is not a number."""
        return sentence(error)

    def _typed(self, field: ShortField) -> None:
        if not field.isModified():
            if not field.refused:
                field.take_back()
            return
        text = field.text()
        self.finish_gesture()
        try:
            value = self._read(field)
        except Refusal as error:
            self.clear_error()
            self.show_error(self._why(error))
            field.refuse(text)
            return
        self.clear_error()
        field.take_back()
        if value != self._value:
            self._make_edit(value)
        if self.error:
            field.refuse(text)
        else:
            self._show_value()

    def reset(self) -> None:
        self._take_back()
        super().reset()
        self._show_value()

    def _take_back(self) -> None:
        for field in self.fields:
            field.take_back()

    def clear_error(self) -> None:
        for field in self.fields:
            field.refused = False
        super().clear_error()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        typing = not all(field.at_rest for field in self.fields)
        if event.key() == Qt.Key.Key_Escape and (self.error or typing):
            self._take_back()
            self.clear_error()
            self._show_value()
        else:
            super().keyPressEvent(event)

    @property
    def at_rest(self) -> bool:
        return all(field.at_rest for field in self.fields)

    @property
    def in_hand(self) -> bool:
        return any(not field.at_rest and field.is_typed_in for field in self.fields)


class NumberRow(_TypedRow):
    """A slider, a number field and a unit for one number.

    The slider offers round numbers. The field takes any number exactly as it is typed, also beyond
    the slider's ends.

    Parameters
    ----------
    name, tip : str
        See `Row`.
    unit : str
        Shown behind the field.
    unit_tip : str
        Explanation of the unit.
    """

    def __init__(
        self, name: str, tip: str, scale: Scale, unit: str = "", unit_tip: str = ""
    ) -> None:
        super().__init__(name, tip)
        self._value: float = scale.value_at(0)
        self.limits: Callable[[], str] = str
        """Returns the limits of the number, for a user who typed a word; set by the owner."""
        self.accepts: Callable[[float], bool] = lambda _number: True
        """Whether a number can be named as an example; set by the owner."""
        self._open = False
        self._unit_said = unit_tip or unit
        self.slider = _Slider()
        self.slider.setAccessibleName(self.tr("{0}, slider").format(name))
        self._tell(self.slider, self._tip)
        self.field = ShortField(name, unit)
        self._tell(self.field, self._tip)
        self.field.setAccessibleName(f"{name} ({self._unit_said})" if unit else name)
        self.unit_label = Label(unit)
        self.unit_label.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        if unit_tip:
            self._tell(self.unit_label, unit_tip)
        self._add_fields(self.field)
        self._grid.addWidget(self.field, 0, 2)
        self._grid.addWidget(self.unit_label, 0, 3)
        self._grid.addWidget(self.slider, 1, 0, 1, 4)
        self._fit_unit()
        self._quiet = QTimer(self, singleShot=True, interval=QUIET_MS)
        self._quiet.timeout.connect(self.finish_gesture)
        self.slider.valueChanged.connect(self._slid)
        self.slider.sliderPressed.connect(self._pressed)
        self.slider.sliderReleased.connect(self._released)
        self.slider.abandoned.connect(self._abandon)
        for widget in (self.slider, self.field):
            widget.installEventFilter(self)
        self.setScale(scale)

    # -- set by the owner

    def setValue(self, value: float) -> None:
        """Show a value without a signal.

        A slider in the user's hand and a text that is being typed stay until the user is done.
        """
        value = float(value)
        if value == self._value:
            return
        self._value = value
        if not self._open:
            self.clear_error()
            self._show_value()

    def setScale(self, scale: Scale) -> None:
        """Give the slider other ends and steps."""
        self.scale = scale
        self.slider.stops = scale.stops
        with QSignalBlocker(self.slider):
            self.slider.setRange(0, scale.last)
            self.slider.setSingleStep(scale.stops.key)
            self.slider.setPageStep(scale.stops.page)
        self._show_value()

    def put_beside(self, widget: QWidget) -> None:
        """Put a widget between the name and the field."""
        self._grid.addWidget(widget, 0, 1)

    # -- done by the user

    def _pressed(self) -> None:
        self._quiet.stop()
        self._begin()

    def _released(self) -> None:
        self.finish_gesture()
        self.clear_error()  # the slider is back at the accepted value

    def _abandon(self) -> None:
        self.gesture_abandoned.emit()
        self._released()

    def _begin(self) -> None:
        if not self._open:
            self._open = True
            self.gesture_started.emit()

    def finish_gesture(self) -> None:
        """End a drag or a burst of keys; the slider goes back to the accepted value."""
        if self._open:
            self._quiet.stop()
            self._open = False
            self._show_value()
            self.gesture_finished.emit()

    def _slid(self, position: int) -> None:
        value = self.scale.value_at(position)
        self._begin()
        if not self.slider.isSliderDown():
            self._quiet.start()
        self.clear_error()
        self.field.take_back()
        self.field.show_number(value)
        if value != self._value and not self._attempt(value):
            self._go_as_far_as_possible(position)

    def _go_as_far_as_possible(self, refused: int) -> None:
        """Take the last value before a refused position, however fast the hand came there.

        The refusal stays: the hand is at the refused value.
        """
        said = self.error
        held = self.scale.position_of(self._value)
        step = 1 if refused > held else -1
        trial = held + step  # first: a hand that stays beyond costs one trial at each move
        while abs(refused - held) > 1:
            if self._attempt(self.scale.value_at(trial)):
                held = trial
            else:
                refused = trial
            trial = (held + refused) // 2
        if not self.slider.isSliderDown():  # the next key starts from the accepted value
            with QSignalBlocker(self.slider):
                self.slider.setValue(held)
        self._show_refusal(said)

    def _read(self, _field: ShortField) -> float:
        return self.field.read(self.scale.infinite)

    def _why(self, error: Refusal) -> str:
        limits = self.limits() if error.bound in (A_NUMBER, A_NUMBER_OR_INFINITY) else ""
        if error.bound == A_NUMBER and not all(map(self.accepts, EXAMPLES)):
            error = Refusal(self.name, error.value, A_NUMBER_LIKE, short_text(self._value))
        said = sentence(error)
        return f"{said.removesuffix('.')}; {limits}." if limits else said

    def eventFilter(self, watched: Any, event: QEvent) -> bool:
        if watched is self.field and event.type() == QEvent.Type.ToolTip:
            exact = f"{self.name} = {number_text(self._value)} {self.field.unit}".rstrip()
            set_tip(self.field, Markup.of("<qt><b>{}</b><br>{}</qt>", exact, self._tip))
        elif watched is self.slider and event.type() == QEvent.Type.FocusIn:
            self._say_value()
        return super().eventFilter(watched, event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        actions = QSlider.SliderAction
        steps = {
            Qt.Key.Key_Up: actions.SliderSingleStepAdd,
            Qt.Key.Key_Down: actions.SliderSingleStepSub,
            Qt.Key.Key_PageUp: actions.SliderPageStepAdd,
            Qt.Key.Key_PageDown: actions.SliderPageStepSub,
        }
        if event.key() in steps:  # from the field, as in a spin box
            self._typed(self.field)
            self.slider.triggerAction(steps[Qt.Key(event.key())])
        else:
            super().keyPressEvent(event)

    # -- shown

    @property
    def at_rest(self) -> bool:
        return not self._open and super().at_rest

    @property
    def in_hand(self) -> bool:
        return self._open or super().in_hand

    @property
    def _numbers(self) -> tuple[float, ...]:
        return (self._value,)

    def _show_value(self) -> None:
        if not self._open:
            with QSignalBlocker(self.slider):
                self.slider.setValue(self.scale.position_of(self._value))
            super()._show_value()
            if self.slider.hasFocus():
                self._say_value()

    def _fit_unit(self) -> None:
        """Give the unit the room of the usual one, so that the fields form a column."""
        self.unit_label.setMinimumWidth(self.fontMetrics().horizontalAdvance(self.tr("units")))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._fit_unit()

    def _say_value(self) -> None:
        """Tell a screen reader the value: of the slider itself it reads the position only."""
        value = f"{short_text(self._value, self.field.below)} {self._unit_said}".rstrip()
        self.slider.setAccessibleDescription(self.error or f"{value}. {self._tip}")


class Choice(NamedTuple):
    """A thing to choose: its key, its translated text and explanation."""

    key: str
    text: str
    tip: str = ""


class ChoiceRow(Row):
    """One of a few named things: a combo box, or buttons side by side.

    Parameters
    ----------
    name, tip : str
        See `Row`.
    buttons : bool
        Buttons instead of a combo box: one click instead of two.
    none : str
        Text of a combo box while none of the choices is chosen.
    """

    def __init__(
        self,
        name: str,
        tip: str,
        choices: Sequence[Choice],
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

    def _make_combo(self, choices: Sequence[Choice], none: str) -> QComboBox:
        self._combo = combo = _Combo()
        combo.setPlaceholderText(none)
        for index, choice in enumerate(choices):
            combo.addItem(choice.text)
            combo.setItemData(index, wrapped(choice.tip), Qt.ItemDataRole.ToolTipRole)
        combo.setAccessibleName(self.name)
        self._tell(combo, self._tip)
        combo.activated.connect(self._chosen)  # by the user only
        longest = max((*(choice.text for choice in choices), none), key=len)
        metrics = self.fontMetrics()
        if metrics.horizontalAdvance(f"{self.name}  {longest}") > ONE_LINE_EM * metrics.height():
            self._grid.addWidget(combo, 1, 0, 1, 4)
        else:
            combo.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
            self._grid.addWidget(combo, 0, 1)
        return combo

    def _make_buttons(self, choices: Sequence[Choice]) -> list[QWidget]:
        made: list[QWidget] = []
        row = in_row(gap=2)
        self._grid.addLayout(row, 0, 1)
        for index, choice in enumerate(choices):
            name = f"{self.name}: {choice.text}"
            button = tool_button(choice.text, name=name, checkable=True, by_click=True)
            button.setStyleSheet(_BUTTONS)
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            self._tell(button, f"{choice.tip} {self._tip}".strip())
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


class VectorRow(_TypedRow):
    """Three number fields side by side for a point or a direction."""

    def __init__(self, name: str, tip: str) -> None:
        super().__init__(name, tip)
        self._value: tuple[float, ...] = (0.0, 0.0, 0.0)
        self._add_fields(*(ShortField(self.tr("{0} {1}").format(name, x)) for x in "xyz"))
        self._line = QBoxLayout(QBoxLayout.Direction.LeftToRight)
        self._line.setSpacing(6)
        self._grid.addLayout(self._line, 1, 0, 1, 4)
        for letter, field in zip("xyz", self.fields, strict=True):
            self._tell(field, f"{field.name}. {self._tip}")
            field.characters = VECTOR_CHARACTERS
            label = Label(letter)
            label.setForegroundRole(QPalette.ColorRole.PlaceholderText)
            one = in_row(gap=3)
            self._line.addLayout(one, 1)
            one.addWidget(label)
            one.addWidget(field, 1)
        all_digits.changed.connect(self._turn)
        self._turn()
        self._show_value()

    def _turn(self) -> None:
        """Put the fields below each other where all digits are shown."""
        ways = QBoxLayout.Direction
        self._line.setDirection(ways.TopToBottom if all_digits.now else ways.LeftToRight)

    def _read(self, field: ShortField) -> tuple[float, ...]:
        number = field.read()
        if math.isinf(number):
            raise Refusal(field.name, number, FINITE_NUMBER)
        place = self.fields.index(field)
        return (*self._value[:place], number, *self._value[place + 1 :])

    @property
    def _numbers(self) -> tuple[float, ...]:
        return self._value


class CheckRow(Row):
    """A switch: a check box behind its name."""

    def __init__(self, name: str, tip: str) -> None:
        super().__init__(name, tip)
        self._value = False
        self.box = QCheckBox()
        self.box.setAccessibleName(name)
        self._tell(self.box, self._tip)
        self.box.clicked.connect(self._make_edit)  # by the user only
        self.name_label.setBuddy(self.box)
        self._grid.addWidget(self.box, 0, 1, Qt.AlignmentFlag.AlignLeft)

    def _show_value(self) -> None:
        self.box.setChecked(self._value)


class RowHolder(Gestures):
    """A widget with rows, one of which at a time is in a gesture; it passes that gesture on."""

    rows: dict[str, Row]

    def _join(self, row: Row) -> None:
        """Pass the row's gestures on."""
        row.gesture_started.connect(partial(self._begin_with, row))
        row.gesture_finished.connect(self.gesture_finished)
        row.gesture_abandoned.connect(self.gesture_abandoned)

    def _begin_with(self, row: Row) -> None:
        for other in self.rows.values():
            if other is not row:
                other.finish_gesture()  # a burst of keys elsewhere that has not gone quiet yet
        self.gesture_started.emit()
