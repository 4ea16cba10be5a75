"""The keys of a talk: those of clickers, digits for a step, the text size of the notes.

They control the talk in the main window while it is presented, and always in the speaker's window;
elsewhere they have other meanings.
"""

from collections.abc import Callable
from functools import partial

from PySide6 import QtWidgets
from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence, QWindow

from widgets.window.help import ways_to_press
from widgets.window.lesson_card import AGAIN_KEY
from widgets.window.lessons import Lessons
from widgets.window.present import Present
from widgets.window.speaker import NOTES_STEP_PX, SpeakerWindow

TYPED_MS = 3000  # time that digits wait for another one, or for Enter
MOST_DIGITS = 4
_KEYS = Qt.Key
_DIGITS = {Qt.Key(_KEYS.Key_0.value + digit): str(digit) for digit in range(10)}
_ENTER = (_KEYS.Key_Return, _KEYS.Key_Enter)
_LARGER = {_KEYS.Key_Plus: 1, _KEYS.Key_Equal: 1, _KEYS.Key_Minus: -1}
"""With Ctrl, they enlarge the speaker's notes."""
_IN_FIELDS = (_KEYS.Key_PageDown, _KEYS.Key_PageUp)
"""Keys of the talk even while the user types in a field."""


class TalkKeys(QObject):
    """Intercepts the keys of a talk before Qt sends them to a widget."""

    next = Signal()
    previous = Signal()
    reveal = Signal()
    jump = Signal(int)  # the number of a step, from 1
    typing = Signal(str)  # the digits typed so far; empty once they are discarded

    def __init__(
        self, window: QtWidgets.QMainWindow, lessons: Lessons, present: Present, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._window, self._present, self._again = window, present, lessons.come_back
        self.speaker: SpeakerWindow | None = None
        self._is_on = self._listens = False
        self._digits = ""
        self._typed = QTimer(self, singleShot=True, interval=TYPED_MS)
        self._typed.timeout.connect(self.forget)
        self._acts: dict[Qt.Key, Callable[[], object]] = {
            _KEYS.Key_W: present.swap,
            _KEYS.Key_F5: present.toggle,
            _KEYS.Key_PageDown: self.next.emit,
            _KEYS.Key_PageUp: self.previous.emit,
            _KEYS.Key_V: self.reveal.emit,
        }

    def listen(self, is_on: bool, speaker: SpeakerWindow | None) -> None:
        """Intercept the keys while a talk is presented or its speaker's window is open."""
        self._is_on, self.speaker = is_on, speaker
        listens = is_on or speaker is not None
        application = QtWidgets.QApplication.instance()
        assert application is not None
        if listens and not self._listens:
            application.installEventFilter(self)
        elif self._listens and not listens:
            application.removeEventFilter(self)
        self._listens = listens

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if kind != QEvent.Type.KeyPress and kind != QEvent.Type.ShortcutOverride:
            return False
        assert isinstance(event, QKeyEvent)
        act = self._act(watched, event)
        if act is None:
            return False
        event.accept()
        if kind == QEvent.Type.KeyPress:
            act()
        return True

    def _act(self, watched: QObject, event: QKeyEvent) -> Callable[[], object] | None:
        """Return the talk's action for a key; None if the key has no meaning for the talk here."""
        top = self._top_of(watched)
        is_of_speaker = self.speaker is not None and top is self.speaker
        is_ours = is_of_speaker or (self._is_on and top is self._window)
        if (
            not is_ours
            or QtWidgets.QApplication.activeModalWidget()
            or QtWidgets.QApplication.activePopupWidget()
        ):
            return None
        key, held = Qt.Key(event.key()), event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        larger = _LARGER.get(key, 0) if held & Qt.KeyboardModifier.ControlModifier else 0
        if larger and is_of_speaker and self.speaker is not None:
            return partial(self.speaker.enlarge, larger * NOTES_STEP_PX)
        if QKeySequence(event.keyCombination()) in ways_to_press(AGAIN_KEY):
            return self._again
        if key == _KEYS.Key_F5 and held == Qt.KeyboardModifier.ShiftModifier and is_of_speaker:
            return self._present_all
        if held or (is_typed_in() and key not in _IN_FIELDS):
            return None
        if key in _DIGITS:
            return partial(self._type, _DIGITS[key])
        if key in _ENTER and self._digits:
            return self._enter
        if key == _KEYS.Key_Escape and self._digits:
            return self.forget
        if key == _KEYS.Key_Escape and is_of_speaker and self._present.is_on:
            return self._present.leave
        if key in (_KEYS.Key_Period, _KEYS.Key_B) and self._present.is_on:
            return self._present.blank
        return self._acts.get(key)

    def _top_of(self, watched: QObject) -> QtWidgets.QWidget | None:
        """Return the window of an object; a floating pane belongs to the main window."""
        if isinstance(watched, QWindow):
            tops = (self._window, self.speaker)
            return next((top for top in tops if top and top.windowHandle() is watched), None)
        if not isinstance(watched, QtWidgets.QWidget):
            return None
        top = watched.window()
        is_afloat = top is not self.speaker and top.parentWidget() is self._window
        return self._window if is_afloat else top

    def _present_all(self) -> None:
        self.jump.emit(1)
        self._present.begin()

    def _type(self, digit: str) -> None:
        self._digits = (self._digits + digit)[-MOST_DIGITS:]
        self.typing.emit(self._digits)
        self._typed.start()

    def _enter(self) -> None:
        number = int(self._digits)
        self.forget()
        self.jump.emit(number)

    def forget(self) -> None:
        self._typed.stop()
        self._digits = ""
        self.typing.emit("")

    def forget_later(self) -> None:
        """Discard the digits, and clear the message after a while."""
        self._digits = ""
        self._typed.start()


def is_typed_in() -> bool:
    field = QtWidgets.QApplication.focusWidget()
    if isinstance(field, (QtWidgets.QTextEdit, QtWidgets.QPlainTextEdit)):
        return not field.isReadOnly()
    return isinstance(field, (QtWidgets.QLineEdit, QtWidgets.QAbstractSpinBox))
