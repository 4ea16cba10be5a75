"""Translate the core's texts into the window's language: refusals, names, numbers.

The core does not depend on Qt: a `Refusal` has data (bound, field, value, limits) and templates
that are marked for translation. This module translates them. Two choices of the window, letters and
digits, apply to panes, panels and readouts; copied or typed numbers have all their digits. The
message bar is a strip across the window with one sentence, and buttons that act on it.
"""

import math
import re
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Generic, TypeAlias, TypeVar

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, Signal
from PySide6.QtGui import QAccessible, QAccessibleAnnouncementEvent, QKeyEvent
from PySide6.QtWidgets import QFrame, QPushButton

from app.languages import quoted, with_comma
from app.lecture.letters import Letters, in_letters
from app.model.limits import OTHER_SIDE, is_number
from app.model.parameter import Parameter
from app.model.parameters import TITLES
from app.model.refusal import REFUSALS, Refusal, format_value
from widgets.parts.labels import WarningLabel
from widgets.parts.layouts import in_row, push_button, tool_button

_T = TypeVar("_T")


class SharedChoice(QObject, Generic[_T]):
    """A choice, and a signal when it changes."""

    changed = Signal()

    def __init__(self, now: _T) -> None:
        super().__init__()
        self.now = now

    def set(self, now: _T) -> None:
        if now != self.now:
            self.now = now
            self.changed.emit()


lettering = SharedChoice[Letters]("own")  # the lecture whose letters are used
all_digits = SharedChoice(False)  # whether numbers are shown with all digits instead of four

FEW = 4  # significant digits of a displayed number


def breakable(text: str, longest: int = 40) -> str:
    """Insert zero-width spaces so that long words wrap instead of widening the window."""
    return re.sub(rf"(\S{{{longest}}})(?=\S)", "\\1\u200b", text)


def file_title(path: str) -> str:
    """Return a file's name without its folder, on one line: a name may hold line breaks."""
    return " ".join(Path(path).name.splitlines())


def field_name(field: str) -> str:
    """Return the translated name of a field; any other name is already translated."""
    name = field.rstrip("0123456789")  # the second scale of a chain is scale2
    number = f" {field[len(name) :]}" if name != field else ""
    return QCoreApplication.translate("Field", TITLES[name]) + number if name in TITLES else field


def plane_name(plane: str) -> str:
    """Return the translated name of a plane of the view volume; leave any other text unchanged."""
    return QCoreApplication.translate("Plane", plane)


def number_text(value: object) -> str:
    """Write a number with all its digits, as a person types it: ``0.1``, ``30``, ``∞``."""
    if value in (math.inf, -math.inf):  # isinf fails for a very large whole number
        return "∞" if value == math.inf else "-∞"
    return format_value(value)


def _value_text(value: object) -> str:
    if isinstance(value, str):
        return quoted(value if len(value) <= 40 else f"{value[:37]}...")
    return number_text(value) if is_number(value) else format_value(value)


def figure_text(value: float, digits: int = 6) -> str:
    """Write a number with so many significant digits: ``0.5``, ``1000``, ``−2.5·10⁻⁵``, ``∞``."""
    if math.isinf(value) or value == 0.0 or 1e-3 <= abs(value) < 10.0 ** max(5, digits):
        text = number_text(value) if math.isinf(value) else f"{value + 0.0:.{digits}g}"
        if "e" not in text:
            return with_comma(text.replace("-", "−"))
    mantissa, _, exponent = f"{value:.{digits - 1}e}".partition("e")
    factor = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    power = "10" + str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    text = power if factor in ("1", "-1") else f"{with_comma(factor.lstrip('-'))}·{power}"
    return f"−{text}" if value < 0.0 else text


def read_text(value: float, digits: int = FEW) -> str:
    """Write a number for display: with four digits, or with all of them."""
    return with_comma(number_text(value)) if all_digits.now else figure_text(value, digits)


def of_phenomena(text: str, letters: Letters | None = None) -> str:
    """Translate a text of the phenomena; names of symbols become the chosen letters."""
    return in_letters(QCoreApplication.translate("phenomena", text), letters or lettering.now)


def parameter_text(parameter: Parameter, text: str) -> str:
    return of_phenomena(text) if parameter.section == "settings" else translated(text, "Field")


class TranslatedWords(dict[str, str]):
    """The words of the drawings, and of the phenomena's marks, in the window's language."""

    def __missing__(self, word: str) -> str:
        return of_phenomena(word)

    def get(self, word: str, default: object = None) -> str:
        """Return the translated word; the default is never needed."""
        return self[word]


def translated(template: str, context: str = "Refusal") -> str:
    """Translate a sentence of the core; `context` is the one that it is marked with."""
    return QCoreApplication.translate(context, template)


def limits_text(low: float, high: float) -> str:
    """State the limits of a number; an infinite limit is omitted."""
    return "; ".join(
        translated(bound).format(number_text(limit))
        for bound, limit in ((REFUSALS["at-least"], low), (REFUSALS["at-most"], high))
        if math.isfinite(limit)
    )


def sentence(error: Exception) -> str:
    """Write a refusal in the window's language; other errors are not translated."""
    if isinstance(error, Refusal):
        return with_comma(error.sentence(translated, field_name, _value_text))
    return str(error)


def seen_from(field: str, name: str, value: float, error: Refusal) -> Refusal:
    """Reword an error of the core in terms of the edited field, whose row has this name.

    The core says "near must be less than far" whichever of the two was edited, and shows a whole
    vector for the one component that is not a number.
    """
    side, bound = OTHER_SIDE.get(error.bound, ("", error.bound))
    if field == side:
        return Refusal(field, value, bound, _value_text(error.value))
    if field == "eye" and error.bound == REFUSALS["not-the-eye"]:
        return Refusal("eye", error.value, REFUSALS["not-the-target"])
    if error.bound == REFUSALS["three-numbers"]:
        return Refusal(name, value, REFUSALS["finite-number"])
    return error


Choice: TypeAlias = tuple[str, Callable[[], object]]  # text of a button and its action


class MessageBar(QFrame):
    """Shows one sentence at a time without blocking the window; Esc in the bar dismisses it.

    An offer is a sentence with choices. Another sentence may replace it for a while; the offer
    returns until it is accepted or dismissed. An offer with a warning sign waits until a warning
    that is shown is dismissed.
    """

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("messageBar")
        self.setAccessibleName(self.tr("Message"))
        self._text = WarningLabel()
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._sentence, self._warns = "", False
        self.choices: tuple[QPushButton, ...] = ()  # the buttons of the message shown
        self._offer: tuple[str, tuple[Choice, ...], bool] | None = None
        self._waits = False
        tip = self.tr("Dismiss this message")
        self._close = tool_button("", tip, self._dismiss, icon="close", flat=True)
        self._line = in_row((self._text, 1), self._close, on=self, margins=(10, 4, 4, 4))
        self.hide()

    @property
    def text(self) -> str:
        """The sentence shown, or nothing."""
        return self._sentence if not self.isHidden() else ""

    def show_message(self, sentence: str, *choices: Choice, warns: bool = True) -> None:
        """Show a sentence with a button for each choice; a button closes the bar first.

        It has a warning sign, unless it only says what has happened as the user wanted.
        """
        is_news = sentence != self.text
        if choices:
            self._offer = sentence, choices, warns
            if is_news and warns and self.text and self._warns and not self.choices:
                return
        self._warns = warns
        for button in self.choices:
            button.deleteLater()
        self.choices = ()
        self._sentence = sentence
        self._text.set_is_warning(warns)
        self._text.setText(breakable(sentence))
        for label, act in choices:
            button = push_button(label, act=self._dismiss)
            button.clicked.connect(partial(act))
            self._line.insertWidget(self._line.count() - 1, button)
            self.choices += (button,)
        self.show()
        if is_news:  # a screen reader would not notice it, far from the focus
            QAccessible.updateAccessibility(QAccessibleAnnouncementEvent(self, sentence))

    def hide_message(self, sentence: str) -> None:
        """Hide a sentence if it is still shown."""
        if self.text == sentence:
            self.done()

    def done(self) -> None:
        """Hide a sentence that is no longer true; an offer stays."""
        if not self.choices:
            self.hide()
            self._offer_again()

    def put_off(self, waits: bool) -> None:
        """Hide an offer from a class, or show it again."""
        self._waits = waits
        if waits and self.choices:
            self.hide()
        elif self.isHidden():
            self._offer_again()

    def _offer_again(self) -> None:
        if self._offer is not None and not self._waits:
            sentence, choices, warns = self._offer
            self.show_message(sentence, *choices, warns=warns)

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            event.accept()  # before the window takes it for a shortcut
            if event.type() == QEvent.Type.KeyPress:
                self._dismiss()
            return True
        return super().event(event)

    def _dismiss(self) -> None:
        if self.choices:
            self._offer = None
            self.hide()
        else:
            self.done()
