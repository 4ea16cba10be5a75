"""One row of the controls: a name, a way to choose a value, and what is wrong with it.

A row owns what the user is doing to one value (dragging, typing, a refused text) and knows no
model. It speaks only of the user's own actions:

    user -> row.edited(value) -> owner accepts (says nothing) or calls row.show_error(sentence)
    owner -> row.setValue(value)     never answered by a signal

`gesture_started` and `gesture_finished` enclose the edits that belong together: a drag, a burst
of keys or wheel steps, one typed value, one reset. `gesture_abandoned` comes before the latter
where all of it shall be put back.
"""

from __future__ import annotations

import math
import re
from abc import abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, partial
from typing import Any, NamedTuple

from PySide6.QtCore import (
    QCoreApplication,
    QEvent,
    QRectF,
    QSignalBlocker,
    QSize,
    Qt,
    QTimer,
    Signal,
)
from PySide6.QtGui import (
    QAction,
    QEnterEvent,
    QFocusEvent,
    QHideEvent,
    QInputMethodEvent,
    QKeyEvent,
    QKeySequence,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QWheelEvent,
)
from PySide6.QtWidgets import (
    QBoxLayout,
    QButtonGroup,
    QCheckBox,
    QComboBox,
    QGridLayout,
    QLineEdit,
    QSizePolicy,
    QSlider,
    QStyle,
    QStyleOptionSlider,
    QWidget,
)

from app.model.limits import DISTINCT
from app.model.projection import AT_LEAST, AT_MOST, FINITE_NUMBER, LARGEST
from app.model.refusal import Refusal
from widgets.parts.buttons import tool_button
from widgets.parts.combo import Combo
from widgets.parts.escape import HeldSlider
from widgets.parts.gestures import Gestures
from widgets.parts.highlight import paint_highlight
from widgets.parts.icons import RefusalLabel
from widgets.parts.layouts import in_row
from widgets.parts.messages import (
    A_NUMBER,
    A_NUMBER_LIKE,
    A_NUMBER_OR_INFINITY,
    FEW,
    number_text,
    sentence,
)
from widgets.parts.note import Balanced
from widgets.parts.plain import Label, Markup, set_tip, wrapped
from widgets.parts.writing import all_digits

QUIET_MS = 500
"""Keys and wheel steps with less than this between them are one gesture."""
FIELD_CHARACTERS = 8
"""Longest number, without its sign, that a field shows while it is not being edited."""
INSIDE_FIELD_PX = 2
"""What Qt leaves free on both sides of a field's text."""
ROW_GAP_PX = 4
"""Between the parts of a row."""
LEAST_SLIDER_PX = 150
"""Shorter than this, a slider has more values than a hand can tell apart."""
FINE = 0.1
"""With Shift the slider goes so far for each pixel of the mouse, against without."""
VECTOR_CHARACTERS = 6
"""Longest number, without its sign, that has room where three stand side by side."""
ALL_CHARACTERS = 18
"""Likewise where all digits are shown."""
ONE_LINE_EM = 11
"""Heights of a line: a name and what is chosen stand on one line if they are not wider."""


def refusal(sentence: str) -> str:
    """A sentence that says why something was refused, marked as that."""
    refused = QCoreApplication.translate("Row", "Not possible.")  # lupdate reads no f-strings
    return f"{refused} {sentence}"


# --------------------------------------------------------------------------- numbers as text

EXAMPLES = (0.5, 2e-3)
"""The numbers that `A_NUMBER` names."""
_NUMBER = re.compile(r"[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?", re.ASCII | re.IGNORECASE)
_MOST = 6
"""Digits of a number that is short."""
_INFINITY = re.compile(r"([+-]?)(∞|inf|infinity)", re.IGNORECASE)


def parse_number(name: str, text: str, unit: str = "", *, infinite: bool = False) -> float:
    """Read a number as typed: decimal point or comma, ``1/3``, ``inf``, perhaps with its unit.

    Parameters
    ----------
    name : str
        What the number is, for the refusal.
    text, unit : str
        The typed text, and the unit that may follow the number.
    infinite : bool
        Whether infinity is worth mentioning in the refusal. It is read in any case: whether it
        is allowed is the model's to say.

    Raises
    ------
    Refusal
        For any other text, and for digits that float64 can only keep as infinity or as 0.
    """
    typed = text.strip()
    bare = typed.removesuffix(unit).rstrip().replace("−", "-")
    infinity = _INFINITY.fullmatch(bare)
    if infinity:
        return -math.inf if infinity[1] == "-" else math.inf
    not_a_number = A_NUMBER_OR_INFINITY if infinite else A_NUMBER
    parts = []
    for part in bare.split("/"):
        match = _NUMBER.fullmatch(part.strip())
        if not match:
            raise Refusal(name, typed, not_a_number)
        number = float(match[0].replace(",", "."))
        if number == 0.0 and re.search("[1-9]", match[1]):
            raise Refusal(name, typed, DISTINCT, 0)
        parts.append(number)
    if len(parts) > 2 or parts[1:] == [0.0]:
        raise Refusal(name, typed, not_a_number)
    number = parts[0] / parts[1] if len(parts) == 2 else parts[0]
    if any(map(math.isinf, parts)) or math.isinf(number):
        bound, limit = (AT_LEAST, -LARGEST) if number < 0.0 else (AT_MOST, LARGEST)
        raise Refusal(name, typed, bound, limit)
    if number == 0.0 and parts[0] != 0.0:
        raise Refusal(name, typed, DISTINCT, 0)
    return number


def short_text(value: float, below: float | None = None, most: int = 6) -> str:
    """The number as it stands if it is short, otherwise rounded to about `most` digits.

    Of one that has more before the point these are all shown, as far as there is room: what is
    far from the origin differs in the last of them.

    What is shown is never cut off: a lost exponent would be another number. Nor is it rounded up
    to a bound `below` which the number stays: then its distance is shown, as ``180-3e-12``.
    """
    text = _short_text(value, most)
    if below is None or not value < below <= float(text):
        return text
    if most < _MOST:
        return short_text(value, below, most + 1)
    return f"{below:g}-{below - value:.0e}"


def _short_text(value: float, most: int) -> str:
    text = number_text(value)
    if 10.0**most <= abs(value) < 10.0**FIELD_CHARACTERS - 0.5:
        return f"{value:.0f}"
    if math.isinf(value) or (most == _MOST and len(text.lstrip("-")) <= FIELD_CHARACTERS):
        return text
    for kept in range(most, 0, -1):
        for text in (f"{value:.{kept}g}", f"{value:.{kept - 1}e}"):
            text = re.sub(r"e([+-])0*", r"e\1", text).replace("e+", "e")
            if len(text.lstrip("-")) <= FIELD_CHARACTERS:
                return text
    return text


# --------------------------------------------------------------------------- slider scales


class Stops(NamedTuple):
    """How many of a slider's positions an arrow key, a page and a notch of the wheel go on by.

    Without Shift a drag stops at whole multiples of `coarse`.
    """

    key: int
    page: int
    notch: int
    coarse: int


@dataclass(frozen=True)
class Linear:
    """A slider in even steps; its values are decimal to the eye.

    Parameters
    ----------
    low, high : float
        The ends, rounded to multiples of the step.
    step : float
        One arrow key; best 1, 2 or 5 times a power of ten.
    parts : int
        Positions of the slider in a step: with Shift the hand reaches them.
    """

    low: float
    high: float
    step: float
    parts: int = 10
    infinite = False

    @classmethod
    def about(cls, centre: float, reach: float) -> Linear:
        """From ``centre - reach`` to ``centre + reach`` in 200 to 500 nice steps."""
        rough = 2.0 * reach / 500.0
        power = 10.0 ** math.floor(math.log10(rough))
        step = next(m * power for m in (1.0, 2.0, 5.0, 10.0) if m * power >= rough)
        return cls(centre - reach, centre + reach, float(f"{step:.1g}"))

    @property
    def stops(self) -> Stops:
        """Where keys, the wheel and a drag stop."""
        return Stops(self.parts, 10 * self.parts, self.parts, self.parts)

    @cached_property
    def _step(self) -> Fraction:
        return Fraction(repr(self.step))

    @cached_property
    def _first(self) -> int:
        return round(Fraction(self.low) / self._step)

    @cached_property
    def last(self) -> int:
        """The slider's top position; the bottom is 0."""
        return (round(Fraction(self.high) / self._step) - self._first) * self.parts

    def value_at(self, position: int) -> float:
        """The value of a slider position."""
        return float((self._first + Fraction(position, self.parts)) * self._step)

    def position_of(self, value: float) -> int:
        """The nearest slider position; the ends for values beyond them."""
        if value <= self.low:
            return 0
        if value >= self.high:
            return self.last
        steps = value / self.step - self._first
        return min(max(round(steps * self.parts), 0), self.last)


@dataclass(frozen=True)
class Log:
    """A slider in even ratios, so fine that a pixel decides; it passes through powers of ten.

    Its values are short: of three digits, the smaller ones with a fourth that is even or 5.

    Parameters
    ----------
    low, high : float
        The ends, above 0.
    infinite : bool
        Whether one more position at the top stands for infinity.
    """

    low: float
    high: float
    infinite: bool = False
    stops = Stops(40, 400, 10, 1)

    @property
    def _first(self) -> float:
        return math.log10(self.low) * PER_DECADE

    @cached_property
    def _last_finite(self) -> int:
        return math.ceil(math.log10(self.high) * PER_DECADE - self._first)

    @property
    def last(self) -> int:
        """The slider's top position; the bottom is 0."""
        return self._last_finite + self.infinite

    def value_at(self, position: int) -> float:
        """The value of a slider position."""
        if position > self._last_finite:
            return math.inf
        exact = 10.0 ** ((self._first + position) / PER_DECADE)
        mantissa, _, power = f"{exact:.9e}".partition("e")
        parts = next(parts for limit, parts in _PARTS if float(mantissa) < limit)
        short = float(f"{round(float(mantissa) * parts) / parts:.3f}e{power}")
        return min(max(short, self.low), self.high)

    def position_of(self, value: float) -> int:
        """The nearest slider position; the ends for values beyond them."""
        if value <= 0.0:
            return 0
        if math.isinf(value):
            return self.last
        position = round(math.log10(value) * PER_DECADE - self._first)
        return min(max(position, 0), self._last_finite)


PER_DECADE = 2000
"""Positions of a `Log` from 1 to 10."""
_PARTS = ((2.0, 500), (4.0, 200), (math.inf, 100))
"""A value that begins with less than the one is a multiple of 1 over the other."""


@dataclass(frozen=True)
class Doubling:
    """A slider over whole numbers in nearly even ratios: 1, 2, 3, 4, 6, 8, 12, 16, and so on.

    Parameters
    ----------
    low, high : float
        The ends, whole and above 0.
    """

    low: float
    high: float
    stops = Stops(1, 2, 1, 1)
    """A page doubles."""
    infinite = False

    @cached_property
    def _values(self) -> list[float]:
        powers = [2.0**n for n in range(math.ceil(math.log2(self.high)) + 1)]
        values = sorted({*powers, *(1.5 * power for power in powers[1:]), self.low, self.high})
        return [value for value in values if self.low <= value <= self.high]

    @property
    def last(self) -> int:
        """The slider's top position; the bottom is 0."""
        return len(self._values) - 1

    def value_at(self, position: int) -> float:
        """The value of a slider position."""
        return self._values[position]

    def position_of(self, value: float) -> int:
        """The nearest slider position; the ends for values beyond them."""
        if value >= self.high:
            return self.last
        return min(range(len(self._values)), key=lambda at: abs(self._values[at] - value))


Scale = Linear | Log | Doubling

# --------------------------------------------------------------------------- parts of a row


_NOTCH = 120
"""Eighths of a degree, in which Qt says how far a wheel turns; a finer one turns by less."""


class _Name(Balanced):
    double_clicked = Signal()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.double_clicked.emit()


class _Slider(HeldSlider):
    """A slider that goes slowly with Shift.

    It leaves the wheel to the column until it has the focus, or Ctrl is held.
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
        """Let keys stop where a drag does; the value follows after this."""
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
    """One that leaves the wheel to the column until it has the focus."""

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


_LEAVE_TEXT = {
    Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Tab, Qt.Key.Key_Backtab, Qt.Key.Key_Escape,
    Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown,
    Qt.Key.Key_Shift, Qt.Key.Key_Control, Qt.Key.Key_Alt, Qt.Key.Key_AltGr, Qt.Key.Key_Meta,
}  # fmt: skip


def _may_edit(event: QEvent) -> bool:
    """Whether this event is a hand at the text of a field."""
    if isinstance(event, QKeyEvent):
        return event.type() == QEvent.Type.KeyPress and event.key() not in _LEAVE_TEXT
    if isinstance(event, QInputMethodEvent):
        return bool(event.commitString() or event.preeditString())
    kinds = QEvent.Type
    return event.type() in (kinds.MouseButtonPress, kinds.ContextMenu, kinds.Drop)


class NumberField(QLineEdit):
    """One number as text, with all its digits.

    What is typed or was refused stays until it is read or taken back. Undo and Esc are left to
    the window where the field has no use for them.

    Parameters
    ----------
    name : str
        What the number is, for a refusal and to be read aloud.
    unit : str
        What may follow the number.
    """

    def __init__(self, name: str, unit: str = "") -> None:
        super().__init__()
        self.name, self.unit = name, unit
        self.refused = False
        """Whether the text is one that was refused."""
        self._number: float | None = None
        self.setAccessibleName(name)

    @property
    def at_rest(self) -> bool:
        """Whether it shows its number, and no text that is being typed or was refused."""
        return not (self.refused or self.isModified())

    @property
    def is_typed_in(self) -> bool:
        """Whether keys go here, or will when the user comes back to the window."""
        return self.window().focusWidget() is self

    def show_number(self, number: float | None) -> None:
        """Show a number, or none; a text that is being typed or was refused stays."""
        self._number = number
        self._write()

    def read(self, infinite: bool = False) -> float:
        """The number that is typed, as `parse_number` reads it, or a `Refusal`."""
        return parse_number(self.name, self.text(), self.unit, infinite=infinite)

    def take_back(self) -> None:
        """Show the number again, and forget what was typed or refused."""
        self.setModified(False)
        self.refused = False
        self._write()

    def refuse(self, text: str) -> None:
        """Leave a refused text where it can be put right."""
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
        """Show a text from its start; what was selected as a whole stays so."""
        all_selected = self.hasSelectedText() and self.selectedText() == self.text()
        self.setText(text)
        self.setCursorPosition(0)
        if all_selected:
            self._select_to_start()

    def _select_to_start(self) -> None:
        """Select all with the cursor at the start, so that it is the start that is seen."""
        self.setSelection(len(self.text()), -len(self.text()))

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
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
    """Narrow, and its number short until somebody is at it."""

    def __init__(self, name: str, unit: str = "") -> None:
        super().__init__(name, unit)
        self.below: float | None = None
        """A bound that the number never reaches, and must not seem to; set by the owner."""
        self.characters = FIELD_CHARACTERS
        """Of a number that has room, without its sign; set by the owner."""
        self._whole = False
        all_digits.changed.connect(self._resize)

    def show_number(self, number: float | None) -> None:
        self._whole = self._whole and number == self._number
        super().show_number(number)

    def take_back(self) -> None:
        self._whole = False
        super().take_back()

    def _text_of(self, number: float) -> str:
        if self._whole or all_digits.now:
            return number_text(number)
        return short_text(number, self.below, FEW)

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
        self._show_whole(True)  # first: the full number is there when Tab selects it all
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


_BY_KEYS = {
    Qt.FocusReason.TabFocusReason,
    Qt.FocusReason.BacktabFocusReason,
    Qt.FocusReason.ShortcutFocusReason,
}
"""A focus that a click has brought is the mouse's, which attends by itself."""

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

# --------------------------------------------------------------------------- rows


class Row(QWidget, Gestures):
    """What number and choice rows share: name, reset, error line, gestures.

    Parameters
    ----------
    name : str
        Translated name, shown and read aloud.
    tip : str
        Translated sentence that says what the value does, in the lectures' terms.
    """

    edited = Signal(object)
    """The user chose this value."""
    highlighted = Signal(bool)
    """The mouse has come over the row or the keyboard into it, or neither is there any more."""

    def __init__(self, name: str, tip: str) -> None:
        super().__init__()
        self.name = name
        self._drawn_by: set[str] = set()  # what highlights the row: mouse, keyboard
        self.is_marked = False
        """Whether the row shows that it is about what is highlighted."""
        self.error = ""
        """The sentence shown below the row, or nothing."""
        self._value: Any = None
        self._default: Any = None
        self._error: RefusalLabel | None = None
        self._refused = False
        self.tip = tip
        how_to_reset = self.tr("Double-click the name to reset it.")
        self._tip = f"{tip} {how_to_reset}"
        self._told: dict[QWidget, str] = {}
        self.name_label = _Name(name)
        self._tell(self.name_label, self._tip)
        self.name_label.double_clicked.connect(self.reset)
        self._reset_action = QAction(self.tr("Reset {0}").format(name), self)
        self._reset_action.triggered.connect(self.reset)
        self.addAction(self._reset_action)  # by the menu key or the right mouse button as well
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(ROW_GAP_PX)
        self._grid.setVerticalSpacing(1)
        self._grid.setColumnStretch(0, 1)
        self._grid.addWidget(self.name_label, 0, 0)
        # Fixed would hold the row at its size hint, which knows not how often the error wraps.
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)

    def take_focus(self) -> None:
        """Give the keyboard to what the value is chosen by."""
        buddy = self.name_label.buddy()
        if buddy is not None:
            buddy.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def value(self) -> Any:
        """The value shown."""
        return self._value

    def setValue(self, value: Any) -> None:
        """Show a value; never answered by a signal. A text being typed stays as it is."""
        if value != self._value:
            self._value = value
            self.clear_error()
            self._show_value()

    def setDefault(self, value: Any) -> None:
        """Set what a reset goes back to."""
        self._default = value

    def reset(self) -> None:
        """Go back to the default, as the user's own edit."""
        self.clear_error()
        if self._default is not None and self._default != self._value:
            self._make_edit(self._default)

    @property
    def at_rest(self) -> bool:
        """Whether the row shows its value, and nothing that was refused or is being chosen."""
        return True

    @property
    def in_hand(self) -> bool:
        """Whether the user is at it: drags it, or types in it."""
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
        self._describe(text)

    def clear_error(self) -> None:
        """Take the error away, and the refused text with it."""
        if self._error is not None and self.error:
            self._error.say("")
            self.error = ""
            self._describe("")
            self._show_value()

    def finish_gesture(self) -> None:
        """End what the user is in the middle of, if anything."""

    def _attempt(self, value: Any) -> bool:
        """Offer a value to the owner; without an objection it is ours. Whether it is."""
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
        """Bring the row's widgets to the value."""

    def _tell(self, part: QWidget, tip: str) -> None:
        """Say what a part does: by its tooltip, and to a screen reader without the markup."""
        set_tip(part, wrapped(tip))
        part.setAccessibleDescription(tip)
        self._told[part] = tip

    def _describe(self, error: str) -> None:
        """Tell a screen reader what is wrong, if anything is."""
        for part, tip in self._told.items():
            part.setAccessibleDescription(error or tip)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and self.error:
            self.clear_error()
        else:
            super().keyPressEvent(event)

    # -- highlight

    def set_marked(self, marked: bool) -> None:
        """Tint the row, or no more."""
        if marked != self.is_marked:
            self.is_marked = marked
            self.update()

    def _draw(self, by: str, drawn: bool) -> None:
        before = bool(self._drawn_by)
        (self._drawn_by.add if drawn else self._drawn_by.discard)(by)
        if bool(self._drawn_by) != before:
            self.highlighted.emit(not before)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.is_marked:
            painter = QPainter(self)
            paint_highlight(self, painter, QRectF(self.rect()))
            painter.end()

    def enterEvent(self, event: QEnterEvent) -> None:
        super().enterEvent(event)
        self._draw("mouse", True)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._draw("mouse", False)

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._draw("mouse", False)
        self._draw("keyboard", False)

    def eventFilter(self, watched: Any, event: QEvent) -> bool:
        if isinstance(event, QFocusEvent):
            self._draw("keyboard", event.gotFocus() and event.reason() in _BY_KEYS)
        return super().eventFilter(watched, event)


class _TypedRow(Row):
    """A row with number fields, each typed, refused and taken back by itself."""

    def _add_fields(self, *fields: ShortField) -> None:
        self.fields = fields
        self.name_label.setBuddy(fields[0])
        for field in fields:
            field.editingFinished.connect(partial(self._typed, field))

    @abstractmethod
    def _read(self, field: ShortField) -> Any:
        """The row's value with the number that is typed in one of its fields, or a `Refusal`."""

    @property
    @abstractmethod
    def _numbers(self) -> tuple[float, ...]:
        """The value, a number for each field."""

    def _show_value(self) -> None:
        for field, number in zip(self.fields, self._numbers, strict=True):
            field.show_number(number)

    def _why(self, error: Refusal) -> str:
        """What is said of a text that is no number."""
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
        """Go back to the default, as the user's own edit; texts being typed are forgotten."""
        self._take_back()
        super().reset()
        self._show_value()

    def _take_back(self) -> None:
        for field in self.fields:
            field.take_back()

    def clear_error(self) -> None:
        """Take the error away, and the refused text with it."""
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

    The slider offers round numbers; the field takes any number exactly as it is typed, also
    beyond the slider's ends. It shows the number whole when it is entered, short once it has been
    taken, and whole again as soon as it is touched.

    Parameters
    ----------
    name, tip : str
        As in `Row`.
    scale : Linear or Log
        What the slider's positions stand for.
    unit : str
        Shown behind the field.
    unit_tip : str
        What the unit is, if the letters do not say it.
    """

    def __init__(
        self, name: str, tip: str, scale: Scale, unit: str = "", unit_tip: str = ""
    ) -> None:
        super().__init__(name, tip)
        self.scale = scale
        """What the slider's positions stand for."""
        self._value: float = scale.value_at(0)
        self.limits: Callable[[], str] = str
        """Says what holds for any number here, for whoever typed none; set by the owner."""
        self.accepts: Callable[[float], bool] = lambda _number: True
        """Says whether a number could be an example here; set by the owner."""
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
        """Show a value; never answered by a signal.

        A slider in the user's hand and a text being typed stay as they are until the user is
        done; then they show this value.
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
        """Put something between the name and the field."""
        self._grid.addWidget(widget, 0, 1)

    # -- done by the user

    def _pressed(self) -> None:
        self._quiet.stop()
        self._begin()

    def _released(self) -> None:
        self.finish_gesture()
        self.clear_error()  # the hand rests on the value that holds

    def _abandon(self) -> None:
        self.gesture_abandoned.emit()
        self.finish_gesture()
        self.clear_error()

    def _begin(self) -> None:
        if not self._open:
            self._open = True
            self.gesture_started.emit()

    def finish_gesture(self) -> None:
        """End a drag or a burst of keys; the slider goes back to the value that holds."""
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

        What was said of the refused value stays: that is where the hand is.
        """
        said = self.error
        held = self.scale.position_of(self._value)
        step = 1 if refused > held else -1
        trial = held + step  # first: a hand that stays beyond costs one trial each time it moves
        while abs(refused - held) > 1:
            if self._attempt(self.scale.value_at(trial)):
                held = trial
            else:
                refused = trial
            trial = (held + refused) // 2
        if not self.slider.isSliderDown():  # the next key starts from the value that holds
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
            self._write_field_tip()
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
        """Give the unit the room of the usual one: the fields form a column."""
        self.unit_label.setMinimumWidth(self.fontMetrics().horizontalAdvance(self.tr("units")))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._fit_unit()

    def _say_value(self) -> None:
        """Tell a screen reader the value, for which it has only the slider's position, at rest."""
        value = f"{short_text(self._value, self.field.below)} {self._unit_said}".rstrip()
        self.slider.setAccessibleDescription(self.error or f"{value}. {self._tip}")

    def _write_field_tip(self) -> None:
        exact = f"{self.name} = {number_text(self._value)} {self.field.unit}".rstrip()
        set_tip(self.field, Markup.of("<qt><b>{}</b><br>{}</qt>", exact, self._tip))


class Choice(NamedTuple):
    """One of the things that can be chosen: its key, its translated text and explanation."""

    key: str
    text: str
    tip: str = ""


class ChoiceRow(Row):
    """One of a few named things: a combo box, or buttons side by side.

    Parameters
    ----------
    name, tip : str
        As in `Row`.
    choices : sequence of Choice
    buttons : bool
        Buttons instead of a combo box: one click instead of two.
    none : str
        What a combo box says while none of them is chosen.
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
        combo.activated.connect(self._chosen)  # the user's choice, never the program's
        longest = max((*(choice.text for choice in choices), none), key=len)
        metrics = self.fontMetrics()
        needed = metrics.horizontalAdvance(f"{self.name}  {longest}")
        if needed > ONE_LINE_EM * metrics.height():
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
    """Three number fields side by side for a point or a direction.

    Parameters
    ----------
    name, tip : str
        As in `Row`.
    """

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
        self.box.clicked.connect(self._make_edit)  # the user's choice, never the program's
        self.name_label.setBuddy(self.box)
        self._grid.addWidget(self.box, 0, 1, Qt.AlignmentFlag.AlignLeft)

    def _show_value(self) -> None:
        self.box.setChecked(self._value)


class RowHolder(Gestures):
    """Holds rows, of which one at a time is in a gesture: its own gestures."""

    rows: dict[str, Row]

    def _join(self, row: Row) -> None:
        """Tell of a row's gestures."""
        row.gesture_started.connect(partial(self._begin_with, row))
        row.gesture_finished.connect(self.gesture_finished)
        row.gesture_abandoned.connect(self.gesture_abandoned)

    def _begin_with(self, row: Row) -> None:
        for other in self.rows.values():
            if other is not row:
                other.finish_gesture()  # a burst of keys elsewhere that has not gone quiet yet
        self.gesture_started.emit()
