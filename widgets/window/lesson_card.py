"""A lesson beside the pictures: one step at a time, its questions, and the buttons between steps.

::

    Lessons.opened, stepped -> LessonCard makes the page of the step
    a block is settled -> Settings keep the answer
    an answer is given -> the Record of this student
    the window changes -> LessonCard.look_again -> the tasks see it, when the event loop is free
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import cast

from PySide6.QtCore import QPoint, Qt, QTimer, Signal
from PySide6.QtGui import QAccessible, QAccessibleAnnouncementEvent, QKeySequence, QShowEvent
from PySide6.QtWidgets import (
    QApplication,
    QFrame,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QScrollArea,
    QToolButton,
    QWidget,
)

from app.document.document import Document
from app.document.store import Store
from app.document.view import View
from app.lessons.blocks.block import ReadBlock, of_kind
from app.lessons.blocks.exercise import Exercise
from app.lessons.course import CONTENT, Course, contained, name_of
from app.lessons.lesson import Head, Lesson, Step, head_of
from app.lessons.practice import Sheet, marked
from app.lessons.record import RIGHT, SHOWN, WRONG, Attempt, Record
from app.lessons.text import escaped, in_line
from app.model.refusal import Refusal
from widgets.parts.buttons import push_button, tool_button
from widgets.parts.focus import lay_out
from widgets.parts.layouts import FREE, TOP, in_column, in_row
from widgets.parts.lesson_text import LessonText
from widgets.parts.messages import sentence
from widgets.parts.plain import PlainLabel
from widgets.parts.roles import give_role
from widgets.window.hiding import IN_TEST
from widgets.window.lesson_blocks import view_of
from widgets.window.lesson_blocks.exercise import ExerciseView
from widgets.window.lesson_blocks.task import DONE, TaskView
from widgets.window.lesson_blocks.view import BlockView
from widgets.window.lessons import Lessons
from widgets.window.self_test_marks import SelfTestMarks
from widgets.window.settings import Progress, Settings

AGAIN_KEY, BACK_KEY, NEXT_KEY = "F7", "Alt+Left", "Alt+Right"
MOST_MARKS = 12
"""Most steps for which each has a mark."""
MOST_COUNTED = 8
"""Most marks beside which there is room for the number of the step."""
LATE_MS = 1000
"""Delay before the current step is saved: writing the file takes as long as a frame."""
CALL_MS = 1500
"""How long the handles of a task are shown as its step opens."""
WHILE_MOVING_MS = 50
"""Interval at which tasks are checked while the model moves."""
MARGIN_PX = 4
"""Space that is kept above and below what is scrolled to."""
TOUR = CONTENT / "tour.md"
"""The tour of the first two minutes."""


def heads(*, talks: bool) -> tuple[Head, ...]:
    """List the lessons that come with the program, or the talks; without the tour."""
    all_heads = (head_of(path) for path in contained() if path != TOUR)
    return tuple(head for head in all_heads if head.is_talk == talks)


class LessonCard(QFrame):
    """The card with the current step of the open lesson; hidden while no lesson is open."""

    toggled = Signal(bool)
    """The card appeared or disappeared."""
    begun_again = Signal(str, object)
    """The answers of the lesson with this title were deleted; the callable restores them."""
    hidden = Signal(object)
    """What must not be seen now, because it would show the answer of an exercise."""
    aimed = Signal(object, object)
    """The `BlockView`s whose questions are to be answered in a picture, and the one that has just
    been answered so, or None."""
    handles_called = Signal(object)
    """The names or settings of handles that an open task needs, for a short time; then none."""
    result_wanted = Signal(object)
    """The user wants a file with these marks of a test."""
    test_left = Signal()
    """A test was closed before its end; its answers are kept."""
    room_wanted = Signal(int)
    """How many pixels of height a response lacks; 0 once the step is left, or has new numbers."""
    buttons_changed = Signal()
    """The step has changed or a block was answered, so other buttons may be enabled."""

    def __init__(self, lessons: Lessons, store: Store, settings: Settings, record: Record) -> None:
        super().__init__()
        self.setObjectName("lesson")
        self.setAccessibleName(self.tr("Lesson"))
        self._lessons, self._store, self._settings = lessons, store, settings
        self._record = record
        self._progress = Progress()
        self._late = QTimer(self, singleShot=True, interval=LATE_MS)
        self._late.timeout.connect(self._keep)
        self._rest: list[ReadBlock] = []
        """The parts of the step that are not shown yet."""
        self._shown: tuple[Course, int] | None = None
        """The course and the step of the page."""
        self._aside: tuple[Document, View | None] | None = None
        """A state that the lesson shows to refute an idea: it is not the student's work."""
        self._hides: frozenset[str] = frozenset()
        self.is_on = False
        """Whether the card shows a lesson, or that one is finished."""
        self.blocks: list[BlockView] = []
        self._current: BlockView | None = None
        """The block that has the cursor, or had it last."""
        self._title = PlainLabel(wordWrap=True)
        self._title.setObjectName("paneTitle")
        forget = self.tr("Begin again: forget the answers of this lesson")
        self.anew = _tool("reset", forget, self.begin_again)
        close = _tool("close", self.tr("Close the lesson"), self.leave)
        self._marks = QWidget()
        self._marks.setObjectName("stepMarks")
        self._marks.setAccessibleName(self.tr("Steps"))
        give_role(self._marks, QAccessible.Role.PageTabList)
        self._numbers: list[QToolButton] = []
        self._heads: list[QWidget] = []
        """The words before the marks of steps with an exercise."""
        self._counted = PlainLabel()
        self._counted.setObjectName("paneNote")
        self._marks_row = in_row(FREE, self._counted, on=self._marks, margins=(0, 0, 0, 0), gap=2)
        self._area = QScrollArea(widgetResizable=True)
        self._area.setFrameShape(QFrame.Shape.NoFrame)
        self._area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._area.setAccessibleName(self.tr("Step"))
        self._notice = PlainLabel(wordWrap=True)
        self._notice.setObjectName("notice")
        self._notice.hide()
        head = in_row((self._title, 1), (self.anew, TOP), (close, TOP))
        parts = head, self._marks, (self._area, 1), self._notice, self._foot()
        in_column(*parts, on=self, margins=(9, 6, 6, 6), gap=5)
        self._responding: BlockView | None = None
        """The block whose response is not shown yet."""
        # Not `QTimer.singleShot`, which comes before Qt shows the widgets that are added meanwhile.
        self._response_timer = QTimer(self, singleShot=True, interval=0)
        self._response_timer.timeout.connect(self._reveal)
        self._looking = QTimer(self, singleShot=True)
        self._looking.timeout.connect(self._look)
        lessons.opened.connect(self._open)
        lessons.stepped.connect(self._step)
        lessons.mistakes_changed.connect(self._show_mistakes)
        cast(QApplication, QApplication.instance()).focusChanged.connect(self._follow)
        self._calling = QTimer(self, singleShot=True, interval=CALL_MS)
        self._calling.timeout.connect(partial(self.handles_called.emit, frozenset()))
        self.hide()

    def _foot(self) -> QHBoxLayout:
        back_key, again_key, next_key = (
            QKeySequence(key).toString(QKeySequence.SequenceFormat.NativeText)
            for key in (BACK_KEY, AGAIN_KEY, NEXT_KEY)
        )
        before = self.tr("Previous step ({0})").format(back_key)
        shown = self.tr("Show the step as the lesson's file has it, without your changes ({0})")
        hints = self.tr("Show the next hint (Alt+I)")
        following = self.tr("Next step ({0})").format(next_key)
        self.back = _push(self.tr("&Back"), before, self.go_back)
        self.again = _push(self.tr("Show again"), shown.format(again_key), self.show_again)
        self.again.setAccessibleName(self.tr("Show the step again"))
        self.hint = _push(self.tr("H&int"), hints, self.give_hint)
        self.next = _push(self.tr("&Next"), following, self.go_on)
        self.next.setObjectName("nextStep")
        return in_row(self.back, self.again, FREE, self.hint, self.next, gap=4)

    # -- what is open

    @property
    def _lesson(self) -> Lesson | None:
        return self._lessons.lesson

    @property
    def _sheet(self) -> Sheet | None:
        """The open lesson, if it is made of exercises of others."""
        course = self._lessons.course
        return course if isinstance(course, Sheet) else None

    @property
    def _is_test(self) -> bool:
        return self._sheet is not None and self._sheet.is_test

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
        self._clear()
        self._shown, is_test = None, self._is_test
        self._lessons.close()
        self.is_on = False
        self.toggled.emit(False)
        self.buttons_changed.emit()
        if is_test:
            self.test_left.emit()

    def begin_again(self) -> None:
        """Delete the answers of the lesson, and go to its first step; this can be undone."""
        lesson, before = self._lesson, self._progress
        if lesson is not None:
            self._progress = Progress()
            self._keep()
            self._shown = None
            self._lessons.go(0)
            if before.answers:
                self.begun_again.emit(lesson.title, partial(self._take_back, lesson.path, before))

    def _take_back(self, path: Path, progress: Progress) -> None:
        """Restore a lesson's answers, and open it at the step where they were deleted."""
        self._late.stop()
        self._settings.keep_progress(name_of(path), progress)
        self._shown = None  # otherwise the current answers would be saved instead
        self.open(path)

    def _open(self) -> None:
        lesson, course = self._lesson, self._lessons.course
        self.keep_now()
        if lesson is None or course is None:
            return
        self._progress = self._settings.progress.get(course.name, Progress())
        self._shown = None
        self._title.setText(lesson.title)
        self._make_marks(lesson)
        self._show_step_buttons(True)
        if not self.is_on:
            self.is_on = True
            self.toggled.emit(True)

    def _step(self) -> None:
        """Show the page of the step, unless it is shown already or the card is hidden."""
        course = self._lessons.course
        assert course is not None
        if self._shown != (course, self._lessons.place):
            self._shown = course, self._lessons.place
            self._progress = replace(self._progress, step=self._here.name)
            self._late.start()
            if self.isHidden():
                self._clear()
                self._show_marks()
            else:
                self._fill()
        self._aside = None
        self._notice.hide()
        self._call_handles()
        self._share_keys()
        self.look_again()

    def _call_handles(self) -> None:
        """Show for a moment the handles that solve an open task of the step."""
        tasks = [view.task for view in self.blocks if isinstance(view, TaskView) and view.is_open]
        self.handles_called.emit(frozenset().union(*(task.handles for task in tasks)))
        self._calling.start()

    def _fill(self) -> None:
        """Make the page of the step; it takes the focus unless the user types elsewhere."""
        takes = self._has_focus or not isinstance(QApplication.focusWidget(), QLineEdit)
        self._make_page()
        turn = next((block for block in self.blocks if block.is_open), None)
        if turn is None and self.blocks:
            turn = self.blocks[-1]  # its answer is seen beside its state
        if turn is not None:
            turn.open_up()
        if takes:
            self._take_focus()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        is_due = self._lesson is not None and self._shown is not None
        if is_due and self._area.widget() is None:
            self._fill()
            self.look_again()

    @property
    def _here(self) -> Step:
        step = self._lessons.step
        assert step is not None
        return step

    # -- the page

    def _make_marks(self, lesson: Lesson) -> None:
        row = self._marks_row
        for old in (*self._numbers, *self._heads):
            row.removeWidget(old)
            old.hide()
            old.deleteLater()
        self._numbers.clear()
        self._heads.clear()
        if len(lesson.steps) <= MOST_MARKS:
            before = False
            for place, step in enumerate(lesson.steps):
                practises = _practises(lesson, step)
                if practises and not before:
                    head = PlainLabel(self.tr("Practice"))
                    head.setObjectName("paneNote")
                    head.setContentsMargins(5, 0, 2, 0)
                    self._heads.append(head)
                    row.insertWidget(place + len(self._heads) - 1, head)
                before = practises
                act = partial(self.go_to, place)
                mark = tool_button(
                    str(place + 1), in_line(step.title), act, flat=True, checkable=True
                )
                mark.setProperty("practice", practises)
                give_role(mark, QAccessible.Role.PageTab)
                self._numbers.append(mark)
                row.insertWidget(place + len(self._heads), mark)
        self._counted.setVisible(len(self._numbers) <= MOST_COUNTED)

    def _show_marks(self) -> None:
        lesson = self._lesson
        assert lesson is not None
        place, count = self._lessons.place, len(lesson.steps)
        self._counted.setText(self.tr("Step {0} of {1}").format(place + 1, count))
        tick, done = "✓", self.tr("done")
        if self._is_test:  # which says later what is right
            tick, done = "•", self.tr("answered")
        for number, (mark, step) in enumerate(zip(self._numbers, lesson.steps, strict=False)):
            is_done = self._is_done(step)
            mark.setChecked(number == place)
            mark.setText(tick if is_done and number != place else str(number + 1))
            said = self.tr("Step {0}: {1}")
            if _practises(lesson, step):
                said = self.tr("Step {0}, practice: {1}")
            mark.setAccessibleName(said.format(number + 1, in_line(step.title)))
            mark.setAccessibleDescription(done if is_done else "")
        self.back.setEnabled(place > 0)
        self.next.setText(self.tr("&Next") if place + 1 < count else self.tr("Do&ne"))
        self._share_keys()
        self.buttons_changed.emit()

    def _hide(self) -> None:
        """Hide what would show the answer of an open exercise; take clicks for a question."""
        aims = [view for view in (block.aims for block in self.blocks) if view is not None]
        asked, answered = ([v for v in aims if v.is_open == is_open] for is_open in (True, False))
        self.aimed.emit(asked, answered[-1] if answered else None)
        hides = frozenset[str]().union(*(block.hides for block in self.blocks))
        if self.blocks and self._is_test:
            hides |= {IN_TEST}
        if hides != self._hides:
            self._hides = hides
            self.hidden.emit(hides)

    def _clear(self) -> None:
        self.blocks, self._current = [], None
        self.room_wanted.emit(0)
        self._hide()
        page = self._area.takeWidget()
        if page is not None:
            page.deleteLater()

    def _make_page(self) -> None:
        """Make the page: the step's title, then its text and blocks in order."""
        self._clear()
        page = QWidget()
        self._column = in_column(LessonText(self._here.title, title=True), gap=8)
        in_column(self._column, FREE, on=page, margins=(0, 0, 6, 4))
        self._rest = [*self._here.parts]
        self._unfold()
        self._area.setWidget(page)
        self._area.verticalScrollBar().setValue(0)
        self._hide()
        self._show_marks()

    def _unfold(self) -> None:
        """Show the parts up to an open prediction, because the rest would reveal the answer."""
        assert self._shown is not None
        here = self._shown[0].at(self._shown[1])
        while self._rest and self._uncommitted is None:
            part = self._rest.pop(0)
            if not part.needs_answer:
                self._column.addWidget(LessonText(part.text))
                continue
            view = view_of(here, part)
            if isinstance(view, ExerciseView) and self._sheet is not None:
                seed = self._sheet.items[self._shown[1]].seed
                view.pose(seed, is_test=self._sheet.is_test)
            answer = self._progress.answers.get(self._key(view.block.name), "")
            if answer:
                view.restore(answer)
            view.tried.connect(partial(self._log, view))
            view.settled.connect(partial(self._settled, view))
            view.show_wanted.connect(self._show_aside)
            view.posed.connect(self._pose)
            view.responded.connect(partial(self._await_response, view))
            self.blocks.append(view)
            self._column.addWidget(view)

    def _await_response(self, block: BlockView) -> None:
        """Remember which block responds; the rest of its response may follow."""
        self._responding = block
        self._response_timer.start()

    def _reveal(self) -> None:
        """Show a response: with its question if there is room, else all of it, or its beginning."""
        self._share_keys()
        block, self._responding = self._responding, None
        if block is None or block not in self.blocks or not block.response:
            return
        _settle_layout()
        missing = block.height() + 2 * MARGIN_PX - self._area.viewport().height()
        if missing > 0:
            self.room_wanted.emit(missing)
            _settle_layout()
        self._scroll_to(block)
        self._scroll_to(*block.response)

    def _scroll_to(self, *widgets: QWidget) -> None:
        """Scroll until widgets from the top one to the bottom one are seen, or as much as fits."""
        bar, port = self._area.verticalScrollBar(), self._area.viewport()
        begin, end = widgets[0].mapTo(port, QPoint()), widgets[-1].mapTo(port, QPoint())
        top, bottom = begin.y() - MARGIN_PX, end.y() + widgets[-1].height() + MARGIN_PX
        bar.setValue(bar.value() + min(max(0, bottom - port.height()), top))

    def _key(self, block: str) -> str:
        return f"{self._here.name}/{block}"

    @property
    def _uncommitted(self) -> BlockView | None:
        """Return the prediction that must be made before the step continues."""
        return next((block for block in self.blocks if block.holds), None)

    @property
    def _hinting(self) -> BlockView | None:
        """Return the block that gives the next hint: the one with the cursor, or a task."""
        hinting = [block for block in self.blocks if block.is_open and block.hints]
        current = self._current
        if current is not None and current.is_open:
            hinting = [block for block in hinting if block is current or block.first is None]
            hinting.sort(key=lambda block: block is not current)
        return next(iter(hinting), None)

    def _follow(self, _left: QWidget | None, focus: QWidget | None) -> None:
        """Remember in which block the cursor is, or was last."""
        for block in self.blocks:
            if focus is not None and block.isAncestorOf(focus):
                self._current = block
                self._share_keys()

    def _share_keys(self) -> None:
        """Enable the hint; give a key of several blocks to that with the cursor, or the first."""
        self.hint.setEnabled(self._hinting is not None)
        taken = set[QKeySequence]()
        for block in sorted(self.blocks, key=lambda block: block is not self._current):
            for button in block.findChildren(QPushButton):
                key = QKeySequence.mnemonic(button.text())
                button.setShortcut(QKeySequence() if key in taken else key)
                if button.isVisibleTo(self):
                    taken.add(key)

    def _is_done(self, step: Step) -> bool:
        """Whether all blocks of a step are answered; one without blocks is done once it is left."""
        names = [part.name for part in step.asked] or [""]
        return all(f"{step.name}/{name}" in self._progress.answers for name in names)

    def _settled(self, view: BlockView, answer: str) -> None:
        self._keep_answer(view.block.name, answer)
        self._notice.hide()
        had_focus = self._has_focus or view.aims is not None  # or in the picture
        self._unfold()
        self._hide()
        self._show_marks()
        if had_focus:
            self._take_focus()
        self.look_again()

    def _log(self, view: BlockView, typed: str, word: str) -> None:
        """Add an answer to the record of this student."""
        idea = "" if word in (RIGHT, WRONG, SHOWN) else word
        attempt = Attempt(
            int(time.time()), view.here.course.name,
            f"{view.here.step.name}/{view.block.name}", view.variant_seed, typed,
            WRONG if idea else word, idea, view.hints_read, self._is_test,
        )  # fmt: skip
        try:
            self._record.add(attempt)
        except Refusal as error:
            self._show_notice(sentence(error))

    def _keep_answer(self, block: str, answer: str) -> None:
        answers = {**self._progress.answers, self._key(block): answer}
        self._progress = replace(self._progress, answers=answers)
        self._keep()

    def keep_now(self) -> None:
        """Save the current step, before another lesson or none is shown."""
        if self._late.isActive():
            self._keep()

    def _keep(self) -> None:
        self._late.stop()
        course = self._lessons.course if self._shown is None else self._shown[0]
        assert course is not None
        steps = course.lesson.steps
        done = sum(self._is_done(step) for step in steps)
        self._progress = replace(self._progress, done=done, of=len(steps))
        if course.name:
            self._settings.keep_progress(course.name, self._progress)

    def _show_aside(self, document: Document) -> None:
        self._hide()  # before it is seen
        self._aside = document, None
        self._lessons.show(document)

    def _pose(self, document: Document) -> None:
        self._hide()  # before it is seen
        self.room_wanted.emit(0)
        self._lessons.pose(document)

    # -- navigation

    def go_to(self, place: int) -> None:
        """Go to a step, from 0; an open prediction prevents going forward."""
        held = self._uncommitted
        if held is not None and place > self._lessons.place:
            self._show_notice(self.tr("Make your prediction first: choose one, then Commit."))
            if held.first is not None:
                held.first.setFocus(Qt.FocusReason.OtherFocusReason)
                self._area.ensureWidgetVisible(held)
            self._show_marks()
            return
        if place > self._lessons.place and not self._here.asked:
            self._keep_answer("", DONE)
        if not self._lessons.go(place):
            self._show_marks()

    def go_on(self) -> None:
        """Go to the next step, or finish the lesson at the last one."""
        lesson = self._lesson
        if lesson is None:
            return
        if self._lessons.place + 1 < len(lesson.steps):
            self.go_to(self._lessons.place + 1)
        elif self._uncommitted is not None:
            self.go_to(len(lesson.steps))
        else:
            self._finish(lesson)

    def go_back(self) -> None:
        self._lessons.previous()

    def show_again(self) -> None:
        """Show the step as in its file, without the student's changes."""
        self._lessons.come_back()

    def give_hint(self) -> None:
        """Show the next hint of the question that has the cursor."""
        block = self._hinting
        if block is not None:
            block.give_hint()
            self._area.ensureWidgetVisible(block)
            self._share_keys()
            self.buttons_changed.emit()

    def check(self) -> None:
        """Say what is wrong in the lesson's file, or that nothing is."""
        if self._lesson is None or self._sheet is not None:
            return
        mistakes = self._lessons.mistakes()
        if mistakes is not None:
            self._show_notice(mistakes or self.tr("Nothing is wrong in this lesson's file."))

    def _show_mistakes(self, text: str) -> None:
        if text:
            self._show_notice(text)
        else:
            self._notice.hide()

    def _finish(self, lesson: Lesson) -> None:
        """Close the lesson; the card lists unfinished steps and names the next lesson."""
        course = self._lessons.course
        assert course is not None
        if not self._here.asked:
            self._keep_answer("", DONE)
        self._progress = replace(self._progress, step="")
        self._keep()
        said = self.tr("Done: “{0}”.").format(lesson.title)
        left = [place for place, step in enumerate(lesson.steps) if not self._is_done(step)]
        if left:
            rest = self.tr("Something is left to do in step {0}.")
            if len(left) > 1:
                rest = self.tr("Something is left to do in steps {0}.")
            said = f"{said} {rest.format(', '.join(str(place + 1) for place in left))}"
        following = _after(lesson.path)
        if self._is_test:
            self._finish_test(left)
            return
        self._clear()
        self._shown = None
        self._lessons.close()
        buttons: list[QPushButton] = []
        if following is not None:
            name = self.tr("Next lesson: {0}").format(following.title.replace("&", "&&"))
            buttons.append(_push(name, self.tr("Open it"), partial(self.open, following.path)))
        buttons.append(_push(self.tr("&Close"), self.tr("Close the lesson"), self.leave))
        if left:
            name = self.tr("Back to step {0}").format(left[0] + 1)
            act = partial(self._lessons.play, course, lesson.steps[left[0]].name)
            buttons.insert(-1, _push(name, self.tr("Go on there"), act))
        self._show_end(LessonText(escaped(said)), *buttons)

    def _finish_test(self, left: Sequence[int]) -> None:
        """Mark a test, once it is finished or the student wants it."""
        if not left:
            self._mark_test()
            return
        self._clear()
        said = self.tr("Not answered yet: {0}.").format(", ".join(str(at + 1) for at in left))
        back = self.tr("Back to exercise {0}").format(left[0] + 1)
        self._show_end(
            LessonText(said),
            _push(back, self.tr("Go on there"), partial(self._go_back_to, left[0])),
            _push(self.tr("&Mark the test now"), self.tr("End the test"), self._mark_test),
        )

    def _go_back_to(self, place: int) -> None:
        self._shown = None
        self._show_step_buttons(True)
        self._lessons.go(place)

    def _mark_test(self) -> None:
        """End the test: show its solutions beside the student's answers."""
        sheet = self._sheet
        assert sheet is not None
        self._late.stop()
        marks = marked(sheet, self._progress.answers)
        self._settings.keep_progress(sheet.name, None)
        self._clear()
        self._shown = None
        self._lessons.close()
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
        in_column(said, *buttons, *below, FREE, on=page)
        self._area.setWidget(page)
        self._show_step_buttons(False)
        buttons[0].setFocus(Qt.FocusReason.OtherFocusReason)
        self.buttons_changed.emit()

    def _show_step_buttons(self, on: bool) -> None:
        """Show or hide the buttons that only an open lesson needs."""
        shown: dict[QWidget, bool] = {self.hint: not self._is_test, self.anew: self._sheet is None}
        for part in (self._marks, self.back, self.again, self.hint, self.next, self.anew):
            part.setVisible(on and shown.get(part, True))
            part.setEnabled(on and shown.get(part, True))

    def _show_notice(self, text: str) -> None:
        self._notice.setText(text)
        self._notice.show()
        QAccessible.updateAccessibility(QAccessibleAnnouncementEvent(self, text))

    @property
    def _has_focus(self) -> bool:
        focus = QApplication.focusWidget()
        return focus is not None and self.isAncestorOf(focus)

    def _take_focus(self) -> None:
        """Give the focus to the first open block, else to the button Next."""
        first = next((b.first for b in self.blocks if b.is_open and b.first is not None), None)
        (first or self.next).setFocus(Qt.FocusReason.OtherFocusReason)

    # -- what is done in the window

    def look_again(self, *_changed: object) -> None:
        """Check the tasks after a change of the window, once all other components were notified."""
        if self._lesson is not None:
            self._looking.start(WHILE_MOVING_MS if self._lessons.is_moving else 0)

    def _look(self) -> None:
        if self._lesson is None:
            return
        if self._lessons.is_moving:
            self.look_again()
            return
        self.again.setEnabled(self._lessons.is_away)
        self.buttons_changed.emit()
        document, look = self._store.document, self._store.look()
        if self._aside is not None:
            aside, looked = self._aside
            if document == aside and looked in (None, look):
                self._aside = aside, look
                return
            self._aside = None
        for view in [*self.blocks]:
            view.look(document, look)


def _practises(lesson: Lesson, step: Step) -> bool:
    """Whether a step has an exercise, in a lesson that has other steps, too."""
    practice = [bool(of_kind(each.blocks, Exercise)) for each in lesson.steps]
    return practice[lesson.steps.index(step)] and not all(practice)


def _settle_layout() -> None:
    lay_out()
    lay_out()  # again, because a scroll bar that appears makes the text narrower


def _after(path: Path) -> Head | None:
    """Return the next lesson; after the tour, the first."""
    lessons = heads(talks=False)
    following = dict(zip((TOUR, *(head.path for head in lessons)), lessons, strict=False))
    return following.get(path)


def _tool(icon: str, name: str, act: object) -> QToolButton:
    return tool_button(tip=name, act=act, icon=icon, name=name, flat=True)


def _push(text: str, tip: str, act: object) -> QPushButton:
    button = push_button(text, tip, act)
    button.setAutoDefault(True)  # Enter presses it
    return button
