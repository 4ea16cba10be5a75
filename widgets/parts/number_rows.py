"""Rows with number fields: `NumberRow` with a slider, `VectorRow` with three fields."""

import math
from abc import abstractmethod
from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import QEvent, QSignalBlocker, Qt, QTimer
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPalette, QWheelEvent
from PySide6.QtWidgets import QBoxLayout, QSlider, QStyle, QStyleOptionSlider, QWidget

from app.model.refusal import REFUSALS, Refusal
from widgets.parts.fields import Row
from widgets.parts.gestures import HeldSlider
from widgets.parts.layouts import in_row
from widgets.parts.messages import all_digits, number_text, sentence
from widgets.parts.number_field import ShortField
from widgets.parts.number_text import short_text
from widgets.parts.plain import Markup, PlainLabel, set_tip
from widgets.parts.scales import Scale, Stops

QUIET_MS = 500  # keys and wheel steps at shorter intervals are one gesture
LEAST_SLIDER_PX = 150
"""Least width of a slider; a shorter one has more values than one can distinguish."""
FINE = 0.1  # speed of a drag with Shift, relative to one without
VECTOR_CHARACTERS = 6  # longest number, without its sign, that fits where three are side by side
EXAMPLES = (0.5, 2e-3)  # the numbers that `A_NUMBER` names
_NOTCH = 120  # a notch of the wheel in Qt's unit, eighths of a degree; a finer wheel turns by less


class _Slider(HeldSlider):
    """A slider that moves slowly with Shift.

    It ignores the wheel, so that the column scrolls, unless it has the focus or Ctrl is held.
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
        """Make keys stop at the same values as a drag; Qt sets the value after this."""
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


class _TypedRow(Row):
    """A row with number fields, each of which is typed, refused and discarded independently."""

    def _add_fields(self, *fields: ShortField) -> None:
        self.fields = fields
        self.name_label.setBuddy(fields[0])
        for field in fields:
            field.editingFinished.connect(partial(self._typed, field))

    @abstractmethod
    def _read(self, field: ShortField) -> Any:
        """Return the row's value with the number typed in a field, or raise `Refusal`."""

    def _show_value(self) -> None:
        numbers = self._value if isinstance(self._value, tuple) else (self._value,)
        for field, number in zip(self.fields, numbers, strict=True):
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
        if self.error:
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

    The slider offers round numbers. The field accepts any number exactly as typed, even beyond the
    slider's ends.
    """

    def __init__(
        self, name: str, tip: str, scale: Scale, unit: str = "", unit_tip: str = ""
    ) -> None:
        super().__init__(name, tip)
        self.scale, self._value = scale, float(scale.value_at(0))
        self.limits: Callable[[], str] = str
        """Returns the limits of the number, for a refused text; set by the owner."""
        self.accepts: Callable[[float], bool] = lambda _number: True
        """Returns whether a number is valid as an example; set by the owner."""
        self._open = False
        self._spoken_unit = unit_tip or unit
        self.slider = _Slider()
        self.slider.setAccessibleName(self.tr("{0}, slider").format(name))
        self._set_tip(self.slider, self._tip)
        self.field = ShortField(name, unit)
        self._set_tip(self.field, self._tip)
        self.field.setAccessibleName(f"{name} ({self._spoken_unit})" if unit else name)
        self.unit_label = PlainLabel(unit)
        self.unit_label.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        if unit_tip:
            self._set_tip(self.unit_label, unit_tip)
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
        self._fit_slider(scale)

    # -- set by the owner

    def setValue(self, value: float) -> None:
        """Show a value without a signal.

        A slider that is being dragged and a text that is being typed stay until the user finishes.
        """
        value = float(value)
        if value != self._value:
            self._value = value
            if not self._open:
                self.clear_error()
                self._show_value()

    def setScale(self, scale: Scale) -> None:
        if scale != self.scale:
            self._fit_slider(scale)

    def _fit_slider(self, scale: Scale) -> None:
        self.scale = scale
        self.slider.stops = scale.stops
        with QSignalBlocker(self.slider):
            self.slider.setRange(0, scale.last)
            self.slider.setSingleStep(scale.stops.key)
            self.slider.setPageStep(scale.stops.page)
        self._show_value()

    def put_beside(self, widget: QWidget) -> None:
        self._grid.addWidget(widget, 0, 1)

    # -- input by the user

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
        if not self.field.at_rest:
            self.field.take_back()
        self.field.show_number(value)
        if value != self._value and not self._attempt(value):
            self._go_as_far_as_possible(position)

    def _go_as_far_as_possible(self, refused: int) -> None:
        """Take the last valid value before a refused position, however fast the drag was.

        The refusal stays, because the slider is held at the refused position.
        """
        said = self.error
        held = self.scale.position_of(self._value)
        step = 1 if refused > held else -1
        trial = held + step  # first: while the mouse stays beyond, each move costs only one trial
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
        limits = (
            self.limits()
            if error.bound in (REFUSALS["messages-a-number"], REFUSALS["a-number-or-infinity"])
            else ""
        )
        if error.bound == REFUSALS["messages-a-number"] and not all(map(self.accepts, EXAMPLES)):
            error = Refusal(
                self.name, error.value, REFUSALS["a-number-like"], short_text(self._value)
            )
        said = sentence(error)
        return f"{said.removesuffix('.')}; {limits}." if limits else said

    def _describe_part(self, part: QWidget) -> None:
        if part is self.field:
            exact = f"{self.name} = {number_text(self._value)} {self.field.unit}".rstrip()
            set_tip(part, Markup.of("<qt><b>{}</b><br>{}</qt>", exact, self._tip))
        else:
            self._describe_value()

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

    def _show_value(self) -> None:
        if not self._open:
            with QSignalBlocker(self.slider):
                self.slider.setValue(self.scale.position_of(self._value))
            super()._show_value()
            if self.slider.hasFocus():
                self._describe_value()

    def _fit_unit(self) -> None:
        """Give the unit the width of the usual one, so that the fields form a column."""
        self.unit_label.setMinimumWidth(self.fontMetrics().horizontalAdvance(self.tr("units")))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._fit_unit()

    def _describe_value(self) -> None:
        """Give the value to screen readers, which would read only the slider's position."""
        shown = short_text(self._value, self.field.below, above=self.field.above)
        value = f"{shown} {self._spoken_unit}".rstrip()
        self.slider.setAccessibleDescription(self.error or f"{value}. {self._tip}")


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
            self._set_tip(field, f"{field.name}. {self._tip}")
            field.characters = VECTOR_CHARACTERS
            label = PlainLabel(letter)
            label.setForegroundRole(QPalette.ColorRole.PlaceholderText)
            one = in_row(gap=3)
            self._line.addLayout(one, 1)
            one.addWidget(label)
            one.addWidget(field, 1)
        all_digits.changed.connect(self._turn)
        self._turn()
        self._show_value()

    def _turn(self) -> None:
        """Put the fields below each other when all digits are shown."""
        direction = QBoxLayout.Direction
        self._line.setDirection(direction.TopToBottom if all_digits.now else direction.LeftToRight)

    def _read(self, field: ShortField) -> tuple[float, ...]:
        number = field.read()
        if math.isinf(number):
            raise Refusal(field.name, number, REFUSALS["finite-number"])
        place = self.fields.index(field)
        return (*self._value[:place], number, *self._value[place + 1 :])
