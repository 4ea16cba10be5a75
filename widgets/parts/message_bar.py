"""A strip across the window with one sentence, and buttons that act on it."""

from collections.abc import Callable
from functools import partial
from typing import TypeAlias

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QAccessible, QAccessibleAnnouncementEvent, QKeyEvent
from PySide6.QtWidgets import QFrame, QPushButton, QWidget

from widgets.parts.icons import WarningLabel
from widgets.parts.layouts import in_row, push_button, tool_button
from widgets.parts.messages import breakable

Choice: TypeAlias = tuple[str, Callable[[], object]]  # text of a button and its action


class MessageBar(QFrame):
    """Shows one sentence at a time without blocking the window; Esc in the bar dismisses it.

    An offer is a sentence with choices. Another sentence may replace it for a while; the offer
    returns until it is accepted or dismissed. An offer with a warning sign waits until a warning
    that is shown is dismissed.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
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
        if self.choices:
            return
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
