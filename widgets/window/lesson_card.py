"""A lesson beside the pictures: one step at a time, its questions, and the buttons between steps.

::

    Lessons.opened, stepped -> StepPage makes the page of the step, as the Player holds it
    an answer is given -> the Player -> the Record of this student, Settings
    the window changes -> LessonCard.look_again -> the tasks see it, when the event loop is free
"""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QAccessible, QAccessibleAnnouncementEvent, QKeySequence, QShowEvent
from PySide6.QtWidgets import QApplication, QFrame, QHBoxLayout, QLineEdit, QPushButton, QWidget

from app.document.document import Document
from app.document.store import Store
from app.lessons.contents import CONTENT, contained
from app.lessons.course import Course, name_of
from app.lessons.lesson import Head, head_of
from app.lessons.player import Player, Progress
from app.lessons.practice import Sheet, marked
from app.lessons.record import Attempt, Record
from app.lessons.text import escaped
from app.model.refusal import Refusal
from widgets.parts import layouts
from widgets.parts.lesson_text import LessonText
from widgets.parts.messages import sentence
from widgets.parts.plain import PlainLabel
from widgets.window.lesson_blocks.view import BlockView
from widgets.window.lessons import Lessons
from widgets.window.overview import SelfTestMarks
from widgets.window.settings import Settings
from widgets.window.step_marks import StepMarks
from widgets.window.step_page import StepPage

AGAIN_KEY, BACK_KEY, NEXT_KEY = "F7", "Alt+Left", "Alt+Right"
LATE_MS = 1000  # delay before the current step is saved: writing the file takes as long as a frame
CALL_MS = 1500  # how long the handles of a task are shown as its step opens
WHILE_MOVING_MS = 50  # interval at which tasks are checked while the model moves
TOUR = CONTENT / "tour.md"  # the tour of the first two minutes


def heads(*, talks: bool) -> tuple[Head, ...]:
    """List the lessons that come with the program, or the talks; without the tour."""
    all_heads = (head_of(path) for path in contained() if path != TOUR)
    return tuple(head for head in all_heads if head.is_talk == talks)


class LessonCard(QFrame):
    """The card with the current step of the open lesson; hidden while no lesson is open."""

    toggled = Signal(bool)  # the card appeared or disappeared
    begun_again = Signal(str, object)
    """The answers of the lesson with this title were deleted; the callable restores them."""
    handles_called = Signal(object)
    """The names or settings of handles that an open task needs, for a short time; then none."""
    result_wanted = Signal(object)  # the user wants a file with these marks of a test
    test_left = Signal()  # a test was closed before its end; its answers are kept
    buttons_changed = Signal()  # the step changed or a block was answered: buttons may change

    def __init__(self, lessons: Lessons, store: Store, settings: Settings, record: Record) -> None:
        super().__init__()
        self.setObjectName("lesson")
        self.setAccessibleName(self.tr("Lesson"))
        self._lessons, self._store, self._settings = lessons, store, settings
        self._record = record
        self._late = QTimer(self, singleShot=True, interval=LATE_MS)
        self._late.timeout.connect(self._keep)
        self._player: Player | None = None
        """The lesson whose progress is kept: that of the page, or the one that was just opened."""
        self._shown: int | None = None  # the step of the page
        self._over: Course | None = None  # the talk whose last page is shown
        self.is_on = False  # whether the card shows a lesson, or that one is finished
        self._title = PlainLabel(wordWrap=True, objectName="paneTitle")
        forget = self.tr("Begin again: forget the answers of this lesson")
        self.anew = layouts.tool_button("", forget, self.begin_again, icon="reset", flat=True)
        tip = self.tr("Close the lesson")
        close = layouts.tool_button("", tip, self.leave, icon="close", flat=True)
        self._marks = StepMarks()
        self._marks.chosen.connect(self.go_to)
        self.page = StepPage()
        self.page.settled.connect(self._settled)
        self.page.show_wanted.connect(self._show_aside)
        self.page.posed.connect(lessons.pose)
        self._notice = PlainLabel(wordWrap=True, objectName="notice", visible=False)
        head = layouts.in_row((self._title, 1), (self.anew, layouts.TOP), (close, layouts.TOP))
        parts = head, self._marks, (self.page, 1), self._notice, self._foot()
        layouts.in_column(*parts, on=self, margins=(9, 6, 6, 6), gap=5)
        self.page.hinting_changed.connect(self.hint.setEnabled)
        self._looking = QTimer(self, singleShot=True)
        self._looking.timeout.connect(self._look)
        lessons.opened.connect(self._open)
        lessons.entered.connect(self._enter)
        lessons.mistakes_changed.connect(self._show_notice)
        self._calling = QTimer(self, singleShot=True, interval=CALL_MS)
        self._calling.timeout.connect(partial(self.handles_called.emit, frozenset()))
        self.hide()

    def _foot(self) -> QHBoxLayout:
        acts = self._lessons.previous, self._lessons.come_back, self.give_hint, self.go_on
        self.back, self.again, self.hint, self.next = (_push("", "", act) for act in acts)
        self.next.setObjectName("nextStep")
        self._name_buttons()
        return layouts.in_row(self.back, self.again, layouts.FREE, self.hint, self.next, gap=4)

    def _name_buttons(self) -> None:
        """Name the buttons in the language of the lesson."""
        back_key, again_key, next_key = (
            QKeySequence(keys).toString(QKeySequence.SequenceFormat.NativeText)
            for keys in (f"{BACK_KEY}, PgUp", AGAIN_KEY, f"{NEXT_KEY}, PgDown")
        )
        shown = self.tr("Show the step as the lesson's file has it, without your changes ({0})")
        for button, text, tip in (
            (self.back, self.tr("&Back"), self.tr("Previous step ({0})").format(back_key)),
            (self.again, self.tr("Show again"), shown.format(again_key)),
            (self.hint, self.tr("H&int"), self.tr("Show the next hint (Alt+I)")),
            (self.next, self.tr("&Next"), self.tr("Next step ({0})").format(next_key)),
        ):
            layouts.label_button(button, text, tip)
        self.again.setAccessibleName(self.tr("Show the step again"))

    # -- what is open

    def play(self, sheet: Sheet) -> bool:
        """Open a sheet of exercises at its last one."""
        kept = self._settings.progress.get(sheet.name, Progress())
        return self._lessons.play(sheet, kept.step)

    def open(self, path: str | Path, step: str = "") -> bool:
        """Open a lesson at a step, or where it was left; return False if it cannot be opened."""
        kept = self._settings.progress.get(name_of(Path(path)), Progress())
        return self._lessons.open(path, step or kept.step)

    def leave(self) -> None:
        """Close the lesson; it will reopen at this step."""
        self.keep_now()
        player = self._lessons.player
        if self._has_focus:
            self.window().setFocus()  # or Qt would give it to all of the dock
        self._close()
        self._over = None
        self.is_on = False
        self.toggled.emit(False)
        self.buttons_changed.emit()
        if player is not None and player.is_test:
            self.test_left.emit()

    def _close(self) -> None:
        """Close the lesson, without keeping its step."""
        self._late.stop()
        self.page.clear()
        self._player = self._shown = None
        self._lessons.close()

    def reopen(self) -> None:
        """Open the talk whose last page is shown, at its first step."""
        if self._over is not None and self._lessons.play(self._over):
            self._lessons.read_again()  # the file may have changed since

    def begin_again(self) -> None:
        """Delete the answers of the lesson, and go to its first step; this can be undone."""
        player = self._player
        if player is not None:
            before = player.forget()
            self._shown = None
            self._lessons.go(0)
            if before.answers:
                back = partial(self._take_back, player.lesson.path, before)
                self.begun_again.emit(player.lesson.title, back)

    def _take_back(self, path: Path, progress: Progress) -> None:
        """Restore a lesson's answers, and open it at the step where they were deleted."""
        self._late.stop()  # otherwise the current answers would be saved instead
        self._settings.keep_progress(name_of(path), progress)
        self.open(path)

    def _open(self) -> None:
        player = self._lessons.player
        self.keep_now()
        if player is None:
            return
        self._over = None
        name = player.course.name
        player.progress = self._settings.progress.get(name, Progress())
        player.log = self._log
        if name:
            player.keep = partial(self._settings.keep_progress, name)
        self._player, self._shown = player, None
        self._title.setText(player.lesson.title)
        self._name_buttons()
        self._marks.make(player)
        self._show_step_buttons(True)
        if not self.is_on:
            self.is_on = True
            self.toggled.emit(True)

    def _enter(self) -> None:
        """Show the page of the step, unless it is shown already or the card is hidden."""
        player = self._player
        assert player is not None
        if self._shown != player.place:
            self._shown = player.place
            is_over = player.lesson.is_talk and player.is_last  # then it begins anew
            player.progress = replace(player.progress, step="" if is_over else player.step.name)
            self._late.start()
            if self.isHidden():
                self.page.clear()
                self._show_marks()
            else:
                self._fill()
        player.show_aside(None)
        self._notice.hide()
        # For a moment, the handles that solve an open task of the step are shown.
        tasks = [view.played.block for view in self.page.blocks if view.played.is_open]
        self.handles_called.emit(frozenset().union(*(task.handles for task in tasks)))
        self._calling.start()
        self.page.share_keys()
        self.look_again()

    def _fill(self) -> None:
        """Make the page of the step; it takes the focus unless the user types elsewhere."""
        assert self._player is not None
        takes = self._has_focus or not isinstance(QApplication.focusWidget(), QLineEdit)
        self.page.make(self._player)
        self._show_marks()
        self.page.open_up()
        if takes:
            self._take_focus()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        # While another lesson opens, the card is shown before it has that lesson's player.
        is_current = self._player is self._lessons.player
        if is_current and self._shown is not None and self.page.widget() is None:
            self._fill()
            self.look_again()

    # -- answers

    def _show_marks(self) -> None:
        player = self._player
        assert player is not None
        self._marks.show_progress(player)
        self.back.setEnabled(player.place > 0)
        self.next.setText(self.tr("Do&ne") if player.is_last else self.tr("&Next"))
        self.page.share_keys()
        self.buttons_changed.emit()

    def _settled(self, view: BlockView) -> None:
        self._notice.hide()
        had_focus = self._has_focus or view.aims is not None  # or in the picture
        self.page.unfold()
        self.page.hide_answers()
        self._show_marks()
        if had_focus:
            self._take_focus()
        self.look_again()

    def _log(self, attempt: Attempt) -> None:
        """Add an answer to the record of this student."""
        try:
            self._record.add(attempt)
        except Refusal as error:
            # Later: an answer that settles its question hides the notice.
            QTimer.singleShot(0, self, partial(self._show_notice, sentence(error)))

    def keep_now(self) -> None:
        """Save the current step, before another lesson or none is shown."""
        if self._late.isActive():
            self._keep()

    def _keep(self) -> None:
        self._late.stop()
        if self._player is not None:
            self._player.save()

    def _show_aside(self, document: Document) -> None:
        if self._player is not None:
            self._player.show_aside(document)
        self._lessons.show(document)

    # -- navigation

    def go_to(self, place: int) -> None:
        """Go to a step, from 0; an open prediction prevents going forward."""
        player = self._player
        assert player is not None
        if place > player.place and player.held is not None:
            self._show_notice(self.tr("Make your prediction first: choose one, then Commit."))
            self.page.go_to_prediction()
            self._show_marks()
            return
        if place > player.place:
            player.leave_step()
        if not self._lessons.go(place):
            self._show_marks()

    def go_on(self) -> None:
        """Go to the next step, or finish the lesson at the last one."""
        player = self._player
        if player is None:
            return
        if player.held is not None or not player.is_last:
            self.go_to(player.place + 1)
        elif not (player.lesson.is_talk and self.isHidden()):  # a class sees no last page
            self._finish(player)

    def give_hint(self) -> None:
        """Show the next hint of the question that has the cursor."""
        view = self.page.hinting
        if view is not None:
            view.give_hint()
            self.page.ensureWidgetVisible(view)
            self.page.share_keys()
            self.buttons_changed.emit()

    def check(self) -> None:
        """Say what is wrong in the lesson's file, or that nothing is."""
        if self._player is not None and self._player.sheet is None:
            mistakes = self._lessons.mistakes()
            if mistakes is not None:
                self._show_notice(mistakes or self.tr("Nothing is wrong in this lesson's file."))

    # -- the end

    def _finish(self, player: Player) -> None:
        """Close the lesson; the card lists unfinished steps and names the next lesson."""
        player.finish()
        if player.is_test:
            self._finish_test(player)
            return
        lesson = player.lesson
        left = [0] if lesson.is_talk else player.left
        said = self.tr("Done: “{0}”.").format(lesson.title)
        if left and not lesson.is_talk:
            rest = self.tr("Something is left to do in step {0}.")
            if len(left) > 1:
                rest = self.tr("Something is left to do in steps {0}.")
            said = f"{said} {rest.format(', '.join(str(place + 1) for place in left))}"
        following = _after(lesson.path)
        self._close()
        self._over = player.course if lesson.is_talk else None
        buttons: list[QPushButton] = []
        if following is not None:
            name = self.tr("Next lesson: {0}").format(following.title.replace("&", "&&"))
            buttons.append(_push(name, self.tr("Open it"), partial(self.open, following.path)))
        buttons.append(_push(self.tr("&Close"), self.tr("Close the lesson"), self.leave))
        if left:
            name = self.tr("Back to step {0}").format(left[0] + 1)
            act = partial(self._lessons.play, player.course, lesson.steps[left[0]].name)
            buttons.insert(-1, _push(name, self.tr("Go on there"), act))
        self._show_end(LessonText(escaped(said)), *buttons)

    def _finish_test(self, player: Player) -> None:
        """Mark a test, once it is finished or the student wants it."""
        left = player.left
        if not left:
            self._mark_test(player)
            return
        self.page.clear()
        said = self.tr("Not answered yet: {0}.").format(", ".join(str(at + 1) for at in left))
        back = self.tr("Back to exercise {0}").format(left[0] + 1)
        mark = partial(self._mark_test, player)
        self._show_end(
            LessonText(said),
            _push(back, self.tr("Go on there"), partial(self._go_back_to, left[0])),
            _push(self.tr("&Mark the test now"), self.tr("End the test"), mark),
        )

    def _go_back_to(self, place: int) -> None:
        self._shown = None
        self._show_step_buttons(True)
        self._lessons.go(place)

    def _mark_test(self, player: Player) -> None:
        """End the test: show its solutions beside the student's answers."""
        assert player.sheet is not None
        marks = marked(player.sheet, player.progress.answers)
        self._settings.keep_progress(player.course.name, None)
        self._close()
        save = _push(
            self.tr("Save the &result…"), self.tr("Write a file for your teacher"),
            partial(self.result_wanted.emit, marks),
        )  # fmt: skip
        close = _push(self.tr("&Close"), self.tr("Close the test"), self.leave)
        summary = SelfTestMarks(marks)
        self._show_end(summary.title, save, close, below=[summary])

    def _show_end(
        self, said: QWidget, *buttons: QPushButton, below: Sequence[QWidget] = ()
    ) -> None:
        """Show a last page with its buttons, the first of which gets the focus."""
        page = QWidget()
        layouts.in_column(said, *buttons, *below, layouts.FREE, on=page)
        self.page.setWidget(page)
        self._show_step_buttons(False)
        buttons[0].setFocus(Qt.FocusReason.OtherFocusReason)
        self.page.verticalScrollBar().setValue(0)  # where its buttons are, wherever the focus was
        self.buttons_changed.emit()

    def _show_step_buttons(self, on: bool) -> None:
        """Show or hide the buttons that only an open lesson needs."""
        player = self._player
        shown: dict[QWidget, bool] = {}
        if player is not None:
            shown = {self.hint: not player.is_test, self.anew: player.sheet is None}
        for part in (self._marks, self.back, self.again, self.hint, self.next, self.anew):
            part.setVisible(on and shown.get(part, True))
            part.setEnabled(on and shown.get(part, True))

    def _show_notice(self, text: str) -> None:
        """Show a notice; an empty one hides it."""
        self._notice.setText(text)
        self._notice.setVisible(bool(text))
        if text:
            QAccessible.updateAccessibility(QAccessibleAnnouncementEvent(self, text))

    @property
    def _has_focus(self) -> bool:
        focus = QApplication.focusWidget()
        return focus is not None and self.isAncestorOf(focus)

    def _take_focus(self) -> None:
        """Give the focus to the first open block, else to the button Next."""
        (self.page.first or self.next).setFocus(Qt.FocusReason.OtherFocusReason)

    # -- what is done in the window

    def look_again(self, *_changed: object) -> None:
        """Check the tasks after a change of the window, once all other components were notified."""
        if self._lessons.player is not None:
            self._looking.start(WHILE_MOVING_MS if self._lessons.is_moving else 0)

    def _look(self) -> None:
        player = self._lessons.player
        if player is None:
            return
        if self._lessons.is_moving:
            self.look_again()
            return
        self.again.setEnabled(self._lessons.is_away)
        self.buttons_changed.emit()
        document, look = self._store.document, self._store.look()
        if player.is_own_work(document, look):
            self.page.look(replace(document, view=look))


def _after(path: Path) -> Head | None:
    """Return the next lesson; after the tour, the first."""
    lessons = heads(talks=False)
    following = dict(zip((TOUR, *(head.path for head in lessons)), lessons, strict=False))
    return following.get(path)


def _push(text: str, tip: str, act: object) -> QPushButton:
    button = layouts.push_button(text, tip, act)
    button.setAutoDefault(True)  # Enter presses it
    return button
