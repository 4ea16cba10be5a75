"""A talk in front of a class: its text and questions, and the speaker's window.

::

    clicker, keyboard --TalkKeys--> Talks --> Lessons --stepped--> TalkBand, SpeakerWindow
                               '--> Present                  '--> Ahead
"""

from pathlib import Path

from PySide6.QtCore import QObject, QRect, Qt, QTimer
from PySide6.QtGui import QGuiApplication, QImage
from PySide6.QtWidgets import QApplication, QMainWindow

from app.document.files import blamed_on, write_bytes_atomically
from app.document.store import Store
from app.lessons.blocks.block import Here, ReadBlock
from app.lessons.player import Player
from app.lessons.strokes import Stroke, picture_beside, read_strokes, write_strokes
from app.model.refusal import REFUSALS, Refusal
from widgets.parts.lesson_text import answer_of
from widgets.parts.messages import MessageBar, sentence
from widgets.parts.saving import png_of
from widgets.window.lessons import Lessons, named
from widgets.window.look import Look
from widgets.window.pen import Pen
from widgets.window.present import Present
from widgets.window.question import QuestionOverlay
from widgets.window.settings import Settings
from widgets.window.speaker import SpeakerWindow, TalkClock
from widgets.window.talk_ahead import StepPreparation
from widgets.window.talk_band import TalkBand
from widgets.window.talk_keys import TalkKeys
from widgets.window.talk_writing import TalkWriter

SEEN_MS = 250  # how long a slide must stand still before the speaker's window shows it


class Talks(QObject):
    """Presents the open talk; `speaker` is the speaker's window while it is open."""

    def __init__(
        self,
        window: QMainWindow,
        lessons: Lessons,
        present: Present,
        store: Store,
        messages: MessageBar,
        settings: Settings,
        band: TalkBand,
        question: QuestionOverlay,
        pen: Pen,
        look: Look,
    ) -> None:
        super().__init__(window)
        self._window, self._lessons, self._present = window, lessons, present
        self._messages, self._settings = messages, settings
        self._band, self._question, self._pen, self._look = band, question, pen, look
        self._drawn_on: Path | None = None  # the file of the talk that the strokes belong to
        self.writer = TalkWriter(window, lessons, store, messages)
        self._ahead = StepPreparation(lessons, look, band, self)
        self._keys = TalkKeys(window, lessons, present, self)
        self.speaker: SpeakerWindow | None = None
        self._clock = TalkClock()  # goes on if the window is closed and opened while presenting
        self._looks = False  # whether the slide is being painted for the speaker's window
        self._seen = QTimer(self, singleShot=True, interval=SEEN_MS)
        self._seen.timeout.connect(self._show_now)
        self._mistake = ""  # the mistake in the open file, which is not shown to the class
        self._refusal = ""  # why the requested step cannot be shown
        for signal, act in (
            (self._ahead.done, self._draw_next),
            (self._keys.next, self.next),
            (self._keys.previous, self.previous),
            (self._keys.reveal, self.reveal),
            (self._keys.jump, self.jump),
            (self._keys.typing, self._show_typed),
            (present.one_screen, lambda: self._show_message(self.tr("There is only one screen."))),
            (present.switched, self._show),
            (present.switched, self._open_with_talk),
            (present.moved, self._move),
            (present.blanked, self.see_later),
            (lessons.opened, self._take_strokes),
            (pen.kept, self.keep_strokes),
            (pen.drawn, self.see_later),
            (lessons.opened, self._show),
            (lessons.stepped, self._show),
            (lessons.arrived, self._pose),
            (lessons.mistakes_changed, self._show_mistake),
            (lessons.refused, self._refuse),
        ):
            signal.connect(act)
        application = QApplication.instance()
        assert isinstance(application, QGuiApplication)
        # Run after Qt has moved the windows itself.
        application.screenRemoved.connect(self.bring_back, Qt.ConnectionType.QueuedConnection)

    # -- presentation

    @property
    def is_on(self) -> bool:
        lesson = self._lessons.lesson
        return self._present.is_on and lesson is not None and lesson.is_talk

    @property
    def has_lesson(self) -> bool:
        """Whether the file of a lesson or a talk is open; a test shows no answers to a speaker."""
        course = self._lessons.course
        return course is not None and course.file is not None

    def _answer_of(self, question: ReadBlock, here: Here) -> str:
        try:
            return answer_of(question, here)
        except Refusal as error:
            lesson = self._lessons.lesson
            self._refuse(named(error, lesson.path) if lesson is not None else sentence(error))
            return ""

    def _show(self, _told: object = None) -> None:
        player = self._lessons.player
        self._keys.listen(self.is_on, self.speaker)
        self._band.setVisible(self.is_on)
        self._forget_refusal()
        self._keys.forget()
        if player is None:
            self._pen.show_step("")
            self._question.show_text("", 1.0)
            self._ahead.forget()
            self.close_speaker()
            return
        self._pen.show_step(player.picture)
        self._pose()
        if self.is_on:
            self._band.set_screen(self._present.screen_px)
            self._band.show_step(player.step, f"{player.place + 1} / {len(player.lesson.steps)}")
        if self.speaker is not None:
            self.speaker.show_step(player, self._band.laid.left_out if self.is_on else "")
        self.see_later()
        self._ahead.begin_later(draws=self.is_on or self.speaker is not None)

    def _pose(self) -> None:
        """Show the question or its answer, but over no picture that moves."""
        player, text = self._lessons.player, ""
        if player is not None and self.is_on and not self._lessons.is_moving:
            text = player.said(self._answer_of)
        self._question.show_text(text, self._present.screen_px)

    # -- the pen

    def _take_strokes(self) -> None:
        """Show the strokes that were kept of another talk."""
        lesson = self._lessons.lesson
        path = lesson.path if lesson is not None else None
        if path != self._drawn_on:
            self._drawn_on = path
            kept: dict[str, tuple[Stroke, ...]] = {}
            try:
                kept = read_strokes(path) if path is not None else {}
            except Refusal as error:
                self._messages.show_message(sentence(error))
            self._pen.begin_talk({step: list(strokes) for step, strokes in kept.items()})

    def _write_pictures(self, talk: Path) -> None:
        """Write the slides with strokes for the handout, and remove those without."""
        lesson = self._lessons.lesson
        steps = {step.name for step in lesson.steps} if lesson is not None else ()
        kept = {path.stem for path in picture_beside(talk, "").parent.glob("*.png")}
        for name in kept.union(self._pen.pictures):
            path = picture_beside(talk, name)
            with blamed_on(path, REFUSALS["unwritable"]):
                if name in self._pen.pictures:
                    path.parent.mkdir(exist_ok=True)
                    write_bytes_atomically(path, png_of(self._pen.pictures[name]))
                elif name.partition(".")[0] in steps and not self._pen.strokes.get(name):
                    path.unlink(missing_ok=True)

    def keep_strokes(self) -> None:
        """Write the strokes beside the talk, where the handout finds them."""
        if self._drawn_on is None:
            why = self.tr("Open a talk first: its handout shows the strokes.")
            self._messages.show_message(why)
            return
        try:
            path = write_strokes(self._drawn_on, self._pen.strokes)
            self._write_pictures(self._drawn_on)
        except Refusal as error:
            self._messages.show_message(sentence(error))
            return
        self._show_message(self.tr("Kept for the handout: {0}").format(path.name))

    # -- navigation

    def next(self) -> None:
        """Ask the next question, or answer it, or go to the next step."""
        if self.reveal():
            return
        self._unblank()
        player = self._lessons.player
        if player is not None and player.is_last:
            self._show_message(self.tr("This is the last step."))
        else:
            self._lessons.next()

    def previous(self) -> None:
        """Go the way of `next` back, to the previous step as it was left."""
        self._unblank()
        player = self._lessons.player
        if player is not None and player.revealed:
            before = player.revealed_state
            player.revealed -= 1
            self._show()
            if player.revealed_state is None and before is not None:
                self._lessons.come_back()
            elif player.revealed_state is not before:
                self._show_state(player)
        elif self._lessons.previous() and player is not None:
            player.reach_again()
            self._show()
            self._show_state(player)

    def reveal(self) -> bool:
        """Ask the next question, or answer it; return False if all are answered."""
        player = self._lessons.player
        before = player.revealed_state if player is not None else None
        if player is None or not player.reveal():
            return False
        self._unblank()
        self._show()
        if player.revealed_state is not before:
            self._show_state(player)
        return True

    def _show_state(self, player: Player) -> None:
        if player.revealed_state is not None:
            self._lessons.show_predicted(player.revealed_state)
            self._pose()

    def jump(self, number: int) -> None:
        """Go to a step by its number, from 1."""
        lesson = self._lessons.lesson
        if lesson is None:
            return
        count = len(lesson.steps)
        if 1 <= number <= count:
            self._unblank()
            self._lessons.go(number - 1)
        else:
            text = self.tr("There is no step {0}; the last is {1}.")
            self._show_message(text.format(number, count))

    def _unblank(self) -> None:
        if self._present.is_blank:
            self._present.blank()

    # -- messages

    def _show_typed(self, digits: str) -> None:
        """Show the typed number; without digits, show the other messages."""
        text = self.tr("To step {0}…").format(digits) if digits else ""
        self._band.show_message(text)
        if self.speaker is not None:
            self.speaker.message.setText(text or self._refusal or self._mistake)

    def _show_message(self, text: str) -> None:
        self._keys.forget_later()
        self._band.show_message(text)
        if self.speaker is not None:
            self.speaker.message.setText(text)

    def _show_mistake(self, text: str) -> None:
        """Show the speaker the mistake in the open file; tell the class only that it is old."""
        self._messages.hide_message(self._mistake)
        if text:
            self._forget_refusal()
        self._mistake = text
        speaker = self.speaker
        is_apart = speaker is not None and speaker.screen() is not self._window.screen()
        if text and self.is_on and not is_apart:
            self._show_message(self.tr("The file was changed, and cannot be read."))
        if speaker is not None:
            speaker.message.setText(self._refusal or text)
        is_talk = self._lessons.lesson is not None and self._lessons.lesson.is_talk
        if text and is_talk and not self.is_on:  # the speaker's window may be hidden behind it
            self._messages.show_message(text)

    def _refuse(self, text: str) -> None:
        """Say why a step cannot be shown, to the speaker alone if the speaker's window is open."""
        self._refusal = text
        self._keys.forget()
        if self.speaker is None:
            self._messages.show_message(text)

    def _forget_refusal(self) -> None:
        if self._refusal:
            self._messages.hide_message(self._refusal)
            self._refusal = ""

    # -- the speaker's window

    def open_speaker(self) -> None:
        """Open the speaker's window, on another screen if there is one."""
        if not self.has_lesson:
            why = self.tr("Open a talk first: the speaker's window shows its notes.")
            self._messages.show_message(why)
            return
        if self.speaker is None:
            self.speaker = speaker = SpeakerWindow(self._settings, self._window, self._clock)
            for signal, act in (
                (speaker.left, self._forget_speaker),
                (speaker.next.clicked, self.next),
                (speaker.back.clicked, self.previous),
                (speaker.blank.clicked, self._present.blank),
                (speaker.jump_wanted, self.jump),
                (speaker.swap.clicked, self._present.swap),
            ):
                signal.connect(act)
            for drawn in self._look.drawn:
                drawn.connect(self.see_later)
            self._place_speaker()
        if self.is_on:
            self.speaker.clock.begin()
        self.speaker.show()
        self.speaker.raise_()
        self._show()

    def see_later(self) -> None:
        """Show the speaker the slide once it has not changed for a while."""
        if self.speaker is not None and not self._looks:
            self._seen.start()

    def _show_now(self) -> None:
        window = self._window.centralWidget()
        if self.speaker is not None and window is not None:
            self._looks = True  # the panes paint themselves for it
            picture = window.grab().toImage() if self.is_on else QImage()
            if self._present.is_blank:
                picture.fill(Qt.GlobalColor.black)
            self._looks = False
            self.speaker.now.show_image(picture)

    def close_speaker(self) -> None:
        if self.speaker is not None:
            self.speaker.close()

    def _draw_next(self) -> None:
        if self.speaker is not None:
            self.speaker.draw_next()

    def _place_speaker(self) -> None:
        """Put the window on the speaker's screen, if there are two screens."""
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
        if self.speaker is None:
            self._clock = TalkClock()
        if on and self.is_on:
            if self._settings.speaker_window and self.speaker is None:
                self.open_speaker()
                self._window.raise_()
                self._window.activateWindow()
            if self.speaker is not None:
                self.speaker.clock.begin()
                if self._present.screens.both is not None:
                    self._place_speaker()
        if self._mistake:
            self._show_mistake(self._mistake)

    def _forget_speaker(self) -> None:
        if self.speaker is not None:
            self._clock = self.speaker.clock if self.is_on else TalkClock()
            self.speaker.deleteLater()
            self.speaker = None
            for drawn in self._look.drawn:
                drawn.disconnect(self.see_later)
        self._keys.listen(self.is_on, None)

    def bring_back(self) -> None:
        """Move all windows to an existing screen after one was removed."""
        screens = [each.geometry() for each in QGuiApplication.screens()]
        for window in QApplication.topLevelWidgets():
            handle = window.windowHandle()
            if handle is None or not screens:
                continue
            if not any(each.contains(window.geometry().center()) for each in screens):
                screen = QGuiApplication.primaryScreen()
                room = screen.availableGeometry()
                place = QRect(room.topLeft(), window.size().boundedTo(room.size()))
                handle.setGeometry(screen.geometry() if window.isFullScreen() else place)
        if self.speaker is not None:
            self.speaker.raise_()
