"""A talk in front of a class: the keys that clickers send, what is read, and the speaker's window.

::

    PageDown, PageUp, digits Enter, F7 --Talks--> Lessons --stepped--> TalkBand, SpeakerWindow
    . or B, Esc ------------------------^ --> Present

The keys belong to a talk while it is presented, and to the speaker's window: elsewhere they have
other work.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from PySide6.QtCore import QEvent, QObject, QRect, Qt, QTimer
from PySide6.QtGui import QAction, QGuiApplication, QKeyEvent, QWindow
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QApplication,
    QCheckBox,
    QDialog,
    QDialogButtonBox,
    QLineEdit,
    QMainWindow,
    QPlainTextEdit,
    QTextEdit,
    QVBoxLayout,
    QWidget,
)

from app.document.document import Document
from app.document.store import Store
from app.lecture.notation import matrices
from app.lessons.course import Course, scene_of
from app.lessons.lesson import Lesson, Question, Step
from app.lessons.writing import add_step, begin_talk
from app.model.refusal import Refusal
from widgets.parts.lesson_text import answer_text, question_text, set_text
from widgets.parts.message_bar import MessageBar
from widgets.parts.messages import sentence
from widgets.parts.panel import Shown
from widgets.parts.plain import Label, TextDocument, set_tip
from widgets.parts.saving import ask_where
from widgets.window.lessons import TRANSITION_S, Lessons, named
from widgets.window.look import Look
from widgets.window.present import Present
from widgets.window.settings import Settings
from widgets.window.speaker import NOTES_STEP_PX, SpeakerWindow
from widgets.window.talk_band import TalkBand

TYPED_MS = 3000
"""How long digits wait for another one, or for Enter."""
MOST_DIGITS = 4
REST_MS = round(1000 * TRANSITION_S) + 150
"""So long after a step what comes next is made ready: nobody is kept waiting by it."""
AGAIN_KEY = Qt.Key.Key_F7
_KEYS = Qt.Key
_DIGITS = {Qt.Key(_KEYS.Key_0.value + digit): str(digit) for digit in range(10)}
_ENTER = (_KEYS.Key_Return, _KEYS.Key_Enter)
_LARGER = {_KEYS.Key_Plus: 1, _KEYS.Key_Equal: 1, _KEYS.Key_Minus: -1}
"""With Ctrl, of the speaker's notes."""
_IN_FIELDS = (_KEYS.Key_PageDown, _KEYS.Key_PageUp, AGAIN_KEY)
"""Those that are the talk's also while something is typed."""


class Talks(QObject):
    """Presents the open talk.

    Parameters
    ----------
    window : QMainWindow
    lessons : Lessons
    present : Present
    store : Store
    messages : MessageBar
    settings : Settings
    band : TalkBand
    look : Look

    Attributes
    ----------
    speaker : SpeakerWindow or None
        While it is open.
    revealed : int
        How far the step's questions are: each of them is asked, and then answered.
    """

    def __init__(
        self,
        window: QMainWindow,
        lessons: Lessons,
        present: Present,
        store: Store,
        messages: MessageBar,
        settings: Settings,
        band: TalkBand,
        look: Look,
    ) -> None:
        super().__init__(window)
        self._window, self._lessons, self._present = window, lessons, present
        self._store, self._messages, self._settings = store, messages, settings
        self._band, self._look = band, look
        self.speaker: SpeakerWindow | None = None
        self.revealed = 0
        self._shown: tuple[Course, int] | None = None
        self._digits = ""
        self._listens = False
        self._typed = self._timer(TYPED_MS, self._forget_typed)
        self._rest = self._timer(REST_MS, self._begin_ahead)
        self._slice = self._timer(0, self._go_ahead)
        self._work: Iterator[None] = iter(())
        present.switched.connect(self._show)
        present.switched.connect(self._open_with_talk)
        present.moved.connect(self._move)
        lessons.opened.connect(self._show)
        lessons.stepped.connect(self._show)
        lessons.complained.connect(self._complain)
        lessons.refused.connect(self._refuse)
        self._complaint = ""
        """Of the open file, which the class need not read."""
        self._refusal = ""
        """Of a step that was to be shown."""
        application = QApplication.instance()
        assert isinstance(application, QGuiApplication)
        # When Qt has done what it does itself.
        application.screenRemoved.connect(self.bring_back, Qt.ConnectionType.QueuedConnection)

    def _timer(self, interval_ms: int, act: Callable[[], object]) -> QTimer:
        timer = QTimer(self)
        timer.setSingleShot(True)
        timer.setInterval(interval_ms)
        timer.timeout.connect(act)
        return timer

    # -- what is presented

    @property
    def is_on(self) -> bool:
        """Whether a talk is presented."""
        return self._present.is_on and self._is_talk

    @property
    def has_lesson(self) -> bool:
        """Whether a lesson or a talk is open."""
        return self._lessons.lesson is not None

    @property
    def _is_talk(self) -> bool:
        lesson = self._lessons.lesson
        return lesson is not None and lesson.is_talk

    @property
    def _questions(self) -> list[Question]:
        step = self._lessons.step
        asked = step.asked if step is not None else ()
        return [part for part in asked if isinstance(part, Question)]

    def _asked(self, course: Course, place: int) -> str:
        """What is asked just now, or answered; empty for nothing."""
        number, told = divmod(self.revealed, 2)
        if not self._questions:
            return ""
        question, answer = self._questions[number], ""
        if told:
            try:
                answer = answer_text(course, place, question)
            except Refusal as error:
                self._refuse(named(error, course.lesson.path))
        return question_text(question, answer, told=bool(told), others=False)

    def _show(self, _told: object = None) -> None:
        """Show the step to the class and to the speaker."""
        course, place = self._lessons.course, self._lessons.place
        if self._shown is None or course is not self._shown[0] or place != self._shown[1]:
            self.revealed = 0
        self._shown = None if course is None else (course, place)
        self._listen()
        self._band.setVisible(self.is_on)
        self._forget_refusal()
        self._forget_typed()
        if course is None:
            self._look.forget_ahead()
            self.close_speaker()
            return
        step, count = course.lesson.steps[place], len(course.lesson.steps)
        if self.is_on:
            self._band.set_talk(course.lesson, float(self._window.screen().size().height()))
            self._band.show_step(step, f"{place + 1} / {count}", self._asked(course, place))
        if self.speaker is not None:
            self.speaker.show_step(course, place)
        self._slice.stop()
        if self.is_on or self.speaker is not None:
            self._rest.start()
        else:
            self._look.forget_ahead()

    # -- going

    def next(self) -> None:
        """Answer what the step asks, or go on."""
        if self.reveal():
            return
        self._unblank()
        lesson = self._lessons.lesson
        if lesson is not None and self._lessons.place + 1 == len(lesson.steps):
            self._say(self.tr("This is the last step."))
        else:
            self._lessons.next()

    def previous(self) -> None:
        """Go back."""
        self._unblank()
        self._lessons.previous()

    def reveal(self) -> bool:
        """Answer what is asked, or ask the step's next question; False if all is answered."""
        questions = self._questions
        if self.revealed + 1 >= 2 * len(questions):
            return False
        self._unblank()
        self.revealed += 1
        self._show()
        number, told = divmod(self.revealed, 2)
        state = questions[number].show
        if told and state is not None:
            self._lessons.show_predicted(state)
        return True

    def jump(self, number: int) -> None:
        """Go to a step by its number, from 1."""
        lesson = self._lessons.lesson
        if lesson is None:
            return
        count = len(lesson.steps)
        if not 1 <= number <= count:
            text = self.tr("There is no step {0}: the talk has {1}.")
            self._say(text.format(number, count))
            return
        self._unblank()
        self._lessons.go(number - 1)

    def blank(self) -> None:
        """Let the class see nothing, or the panes again."""
        self._present.blank()

    def _unblank(self) -> None:
        if self._present.is_blank:
            self._present.blank()

    # -- keys

    def _listen(self) -> None:
        """Take the keys while there is somebody to take them for."""
        listens = self.is_on or self.speaker is not None
        application = QApplication.instance()
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
        """What a key does for the talk; None for what is none of the talk's."""
        if not self._is_of_ours(watched) or QApplication.activePopupWidget() is not None:
            return None
        key, held = Qt.Key(event.key()), event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        is_of_speaker = self._is_of_speaker(watched)
        if is_of_speaker and held & Qt.KeyboardModifier.ControlModifier and key in _LARGER:
            return partial(self._enlarge, _LARGER[key])
        if held:
            return None
        if self._is_typed_in() and key not in _IN_FIELDS:
            return None
        if key in _DIGITS:
            return partial(self._type, _DIGITS[key])
        if key in _ENTER and self._digits:
            return self._enter
        if key == _KEYS.Key_Escape and self._digits:
            return self._forget_typed
        if key == _KEYS.Key_Escape and is_of_speaker and self._present.is_on:
            return self._present.leave
        if key in (_KEYS.Key_Period, _KEYS.Key_B) and self._present.is_on:
            return self.blank
        acts: dict[Qt.Key, Callable[[], object]] = {
            _KEYS.Key_W: self._present.swap,
            _KEYS.Key_PageDown: self.next,
            _KEYS.Key_PageUp: self.previous,
            _KEYS.Key_V: self.reveal,
            AGAIN_KEY: self._lessons.come_back,
        }
        return acts.get(key)

    def _is_of_ours(self, watched: QObject) -> bool:
        modal = QApplication.activeModalWidget()
        if modal is not None:
            return False
        if self._is_of_speaker(watched):
            return True
        return self.is_on and self._top_of(watched) is self._window

    def _is_of_speaker(self, watched: QObject) -> bool:
        return self.speaker is not None and self._top_of(watched) is self.speaker

    def _top_of(self, watched: QObject) -> QWidget | None:
        """The window that something is, or is in; a pane afloat is the main window's."""
        if isinstance(watched, QWindow):
            tops = (self._window, self.speaker)
            return next(
                (top for top in tops if top is not None and top.windowHandle() is watched), None
            )
        if not isinstance(watched, QWidget):
            return None
        top = watched.window()
        is_afloat = top is not self.speaker and top.parentWidget() is self._window
        return self._window if is_afloat else top

    @staticmethod
    def _is_typed_in() -> bool:
        field = QApplication.focusWidget()
        if isinstance(field, (QTextEdit, QPlainTextEdit)):
            return not field.isReadOnly()
        return isinstance(field, (QLineEdit, QAbstractSpinBox))

    def _enlarge(self, steps: int) -> None:
        if self.speaker is not None:
            self.speaker.enlarge(steps * NOTES_STEP_PX)

    def _type(self, digit: str) -> None:
        self._digits = (self._digits + digit)[-MOST_DIGITS:]
        self._tell(self.tr("To step {0}…").format(self._digits))

    def _enter(self) -> None:
        number = int(self._digits)
        self._forget_typed()
        self.jump(number)

    def _forget_typed(self) -> None:
        self._typed.stop()
        self._digits = ""
        self._band.say("")
        if self.speaker is not None:
            self.speaker.say(self._refusal or self._complaint)

    def _say(self, text: str) -> None:
        """Say something for a moment."""
        self._digits = ""
        self._tell(text)

    def _complain(self, text: str) -> None:
        """Say what is wrong with the open file to the speaker; to a class only that it is old."""
        self._messages.take_back(self._complaint)
        if text:
            self._forget_refusal()
        self._complaint = text
        if text and self.is_on and not self._is_apart:
            self._say(self.tr("The file was changed, and cannot be read."))
        if self.speaker is not None:
            self.speaker.say(self._refusal or text)
        if text and not self.is_on:  # also if the speaker's window is behind this one
            self._messages.say(text)

    @property
    def _is_apart(self) -> bool:
        """Whether the speaker has a screen that the class does not see."""
        return self.speaker is not None and self.speaker.screen() is not self._window.screen()

    def _refuse(self, text: str) -> None:
        """Say why a step cannot be shown: to the speaker, if there is a window for that."""
        self._refusal = text
        self._forget_typed()
        if self.speaker is None:
            self._messages.say(text)

    def _forget_refusal(self) -> None:
        if self._refusal:
            self._messages.take_back(self._refusal)
            self._refusal = ""

    def _tell(self, text: str) -> None:
        self._band.say(text)
        if self.speaker is not None:
            self.speaker.say(text)
        self._typed.start()

    # -- the speaker's window

    def open_speaker(self) -> None:
        """Open the speaker's window, on another screen if there is one."""
        course = self._lessons.course
        if course is None:
            self._messages.say(self.tr("Open a talk first: its notes are what the speaker sees."))
            return
        if self.speaker is None:
            self.speaker = speaker = SpeakerWindow(self._settings, self._window)
            speaker.left.connect(self._forget_speaker)
            speaker.next_wanted.connect(self.next)
            speaker.previous_wanted.connect(self.previous)
            speaker.blank_wanted.connect(self.blank)
            speaker.jump_wanted.connect(self.jump)
            speaker.swap_wanted.connect(self._present.swap)
            self._place_speaker()
        if self.is_on:
            self.speaker.clock.begin()
        self.speaker.show()
        self.speaker.raise_()
        self._show()

    def close_speaker(self) -> None:
        """Close the speaker's window, if it is open."""
        if self.speaker is not None:
            self.speaker.close()

    def _place_speaker(self) -> None:
        """On the speaker's screen, if there are two."""
        assert self.speaker is not None
        both = self._present.screens.both
        if both is not None:
            self.speaker.setGeometry(both[1].availableGeometry())
            self.speaker.setScreen(both[1])
        else:
            room = self._window.screen().availableGeometry()
            self.speaker.resize(round(0.7 * room.width()), round(0.7 * room.height()))

    def _move(self) -> None:
        if self.speaker is not None:
            self._place_speaker()
        self._show()

    def _open_with_talk(self, on: bool) -> None:
        if not on and self._complaint:
            self._messages.say(self._complaint)
        if on and self.is_on:
            if self._settings.speaker_window and self.speaker is None:
                self.open_speaker()
                self._window.raise_()
                self._window.activateWindow()
            if self.speaker is not None:
                self.speaker.clock.begin()
                if self._present.screens.both is not None:
                    self._place_speaker()

    def _forget_speaker(self) -> None:
        if self.speaker is not None:
            self.speaker.deleteLater()
            self.speaker = None
        self._listen()

    def bring_back(self) -> None:
        """Let both windows be on a screen that is there, as one has gone."""
        screens = [each.geometry() for each in QGuiApplication.screens()]
        for window in (self._window, self.speaker):
            handle = window.windowHandle() if window is not None else None
            if window is None or handle is None or not screens:
                continue
            if not any(each.contains(window.geometry().center()) for each in screens):
                room = QGuiApplication.primaryScreen().availableGeometry()
                size = window.size().boundedTo(room.size())
                handle.setGeometry(
                    QGuiApplication.primaryScreen().geometry()
                    if window.isFullScreen()
                    else QRect(room.topLeft(), size)
                )
        if self.speaker is not None:
            self.speaker.raise_()

    # -- ahead

    def _begin_ahead(self) -> None:
        self._work = self._ahead()
        self._slice.start()

    def _go_ahead(self) -> None:
        """Do a piece of what is ahead, and the next when Qt has nothing else to do."""
        if self._lessons.is_moving:
            self._rest.start()
        elif next(self._work, self) is None:
            self._slice.start()

    def _ahead(self) -> Iterator[None]:
        """Make what the next steps show, a piece at a time; what is wrong is said when it comes."""
        course, place = self._lessons.course, self._lessons.place
        if course is None:
            return
        steps, scenes = course.lesson.steps, []
        for number in (place + 1, place - 1):
            if not 0 <= number < len(steps):
                continue
            for text in _texts_of(steps[number]):
                set_text(TextDocument(), text)
                yield
            try:
                document = course.shown(number).document
                scenes.append(Shown.of(document, scene_of(document)))
            except Refusal:
                continue
            yield
            if document.view.panel == "matrices":  # whose formulas are found once
                matrices(document.projection, document.view.letters)
                yield
        yield from self._look.ahead(scenes)
        if self.speaker is not None:
            self.speaker.draw_next()
            yield

    # -- writing

    def add_state(self) -> None:
        """Ask for a title, and put what is seen into the open file as a step more."""
        lesson, step = self._lessons.lesson, self._lessons.step
        if lesson is None or step is None or self._is_gone(lesson):
            return
        document = self._store.seen
        found = self._ask_title(self.tr("Add this state as a step"), "", document)
        if found is not None:
            self.write_step(*found)

    def _is_gone(self, lesson: Lesson) -> bool:
        """Say that there is no file any more to write a step into, if there is none."""
        if lesson.path.exists():
            return False
        text = self.tr(
            "{0} is not in its folder any more, and no step was added: put the file back, or"
            " choose “A new talk from here” in the Lessons menu."
        )
        self._messages.say(text.format(lesson.path.name))
        return True

    def write_step(self, title: str, panes: bool) -> bool:
        """Put what is seen into the open file as a step more; False if that cannot be."""
        lesson, step = self._lessons.lesson, self._lessons.step
        assert lesson is not None and step is not None
        if self._is_gone(lesson):
            return False
        try:
            added = add_step(lesson.path, step.name, title, self._store.seen, panes=panes)
        except Refusal as error:
            self._messages.say(sentence(error))
            return False
        self._messages.done()
        self._lessons.read_again(added.name)
        text = self.tr("Added as step {0} of {1}").format(added.place + 1, lesson.path.name)
        self._window.statusBar().showMessage(text, TYPED_MS)
        return True

    def begin_new(self) -> None:
        """Ask for a file, and begin a talk there with what is seen."""
        kinds = self.tr("Talks and lessons (*.md)")
        path = ask_where(self._window, self.tr("A new talk from here"), "talk.md", kinds, ".md")
        if not path:
            return
        found = self._ask_title(self.tr("A new talk from here"), Path(path).stem, self._store.seen)
        if found is not None:
            self.write_talk(Path(path), *found)

    def write_talk(self, path: Path, title: str, panes: bool) -> bool:
        """Begin a talk with what is seen, and open it; False if that cannot be."""
        try:
            begin_talk(path, title, self._store.seen, panes=panes)
        except Refusal as error:
            self._messages.say(sentence(error))
            return False
        return self._lessons.open(path)

    def _ask_title(self, name: str, title: str, document: Document) -> tuple[str, bool] | None:
        dialog = TitleDialog(name, title, bool(document.view.panes), self._window)
        if dialog.exec() != QDialog.DialogCode.Accepted:
            return None
        return dialog.field.text(), dialog.panes.isChecked()


class TitleDialog(QDialog):
    """Asks what a step is called, on one line.

    Parameters
    ----------
    name, title : str
        Of the dialog, and of the step as it is proposed.
    turned : bool
        Whether a pane was turned: then it can be kept so.
    parent : QWidget
    """

    def __init__(self, name: str, title: str, turned: bool, parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(name)
        label = Label(self.tr("&Title of the step"))
        self.field = QLineEdit(title)
        self.field.setMinimumWidth(24 * self.fontMetrics().averageCharWidth())
        label.setBuddy(self.field)
        self.panes = QCheckBox(self.tr("With the &panes turned as they are"))
        set_tip(self.panes, self.tr("Then the state is a document beside the file"))
        self.panes.setVisible(turned)
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        for widget in (label, self.field, self.panes, buttons):
            layout.addWidget(widget)
        ok = buttons.button(QDialogButtonBox.StandardButton.Ok)
        ok.setEnabled(bool(title.strip()))
        self.field.textChanged.connect(lambda text: ok.setEnabled(bool(text.strip())))


def _texts_of(step: Step) -> Iterator[str]:
    """What of a step is set in formulas."""
    yield step.title
    yield from (part.text for part in step.parts)


class TalkActions(QObject):
    """The entries of the menu that are about talks."""

    def __init__(self, talks: Talks, window: QMainWindow, settings: Settings) -> None:
        super().__init__(window)
        self._talks = talks
        self.speaker = QAction(self.tr("Speaker's &window"), window)
        self.speaker.triggered.connect(talks.open_speaker)
        self.with_talk = QAction(self.tr("Open it when a talk is &presented"), window)
        self.with_talk.setCheckable(True)
        self.with_talk.setChecked(settings.speaker_window)
        self.with_talk.toggled.connect(partial(setattr, settings, "speaker_window"))
        self.add = QAction(self.tr("Add th&is state as a step…"), window)
        self.add.triggered.connect(talks.add_state)
        self.begin = QAction(self.tr("A new talk f&rom here…"), window)
        self.begin.triggered.connect(talks.begin_new)
        self.all = (self.speaker, self.with_talk, self.add, self.begin)
        self.show_lesson()

    def show_lesson(self) -> None:
        """Let be done what can be done with the lesson that is open, or with none."""
        for action in (self.speaker, self.add):
            action.setEnabled(self._talks.has_lesson)
