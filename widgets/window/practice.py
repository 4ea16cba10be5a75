"""Tests and the dialog of their topics, and reviews of what is due again, on the lesson's card."""

import random
from collections.abc import Mapping, Sequence
from datetime import date, timedelta
from functools import partial

from PySide6 import QtWidgets
from PySide6.QtCore import QCoreApplication, QDate, QLocale, QObject, Qt
from PySide6.QtGui import QIntValidator

from app import __version__
from app.document.files import write_bytes_atomically
from app.lessons import practice
from app.lessons.blocks.exercise import LARGEST_SEED
from app.lessons.practice import Sheet, Waiting, topics
from app.lessons.record import Attempt, Record, corrected, ideas_met, one_line, spaced, standings
from app.lessons.results import LONGEST_STUDENT, of_test, to_json
from app.model.refusal import Refusal, counted
from widgets.parts.layouts import FREE, in_column, in_row, push_button
from widgets.parts.messages import MessageBar, sentence
from widgets.parts.plain import PlainLabel, set_tip
from widgets.parts.saving import ask_where
from widgets.window.lesson_card import LessonCard
from widgets.window.overview import Overview
from widgets.window.settings import Settings

COLUMNS = 2


class SelfTestDialog(QtWidgets.QDialog):
    """Asks for topics (title and number of exercises by name) and for the number of a test."""

    def __init__(
        self,
        topics: Mapping[str, tuple[str, int]],
        number: int,
        parent: QtWidgets.QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Test yourself"))
        self._counts = {name: count for name, (_, count) in topics.items()}
        self._boxes = {
            name: QtWidgets.QCheckBox(f"{name} {title}".replace("&", "&&"))
            for name, (title, _) in topics.items()
        }
        holder = QtWidgets.QWidget()
        grid = QtWidgets.QGridLayout(holder)
        rows = -(-len(topics) // COLUMNS)
        for place, (name, box) in enumerate(self._boxes.items()):
            box.setEnabled(self._counts[name] > 0)
            box.toggled.connect(self._show_count)
            grid.addWidget(box, place % rows, place // rows)
        area = QtWidgets.QScrollArea(widgetResizable=True)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setWidget(holder)
        area.setMinimumWidth(holder.sizeHint().width() + 2 * area.frameWidth() + 20)
        self.number = QtWidgets.QLineEdit(str(number))
        self.number.setValidator(QIntValidator(1, LARGEST_SEED, self))
        self.number.setAccessibleName(self.tr("Test number"))
        set_tip(self.number, self.tr("The same topics and number give everyone the same test"))
        self.number.setMaximumWidth(5 * self.fontMetrics().height())
        self.number.textChanged.connect(self._show_count)
        self._count = PlainLabel()
        every = push_button(self.tr("&All topics"), act=lambda: self._choose(True))
        none = push_button(self.tr("&None"), act=lambda: self._choose(False))
        text = self.tr(
            "Up to {0} exercises. One try each, no hints, panels closed; give three significant"
            " digits. At the end you see all solutions."
        )
        how = PlainLabel(text.format(practice.MOST), wordWrap=True)
        buttons = QtWidgets.QDialogButtonBox(QtWidgets.QDialogButtonBox.StandardButton.Cancel)
        self.begin = buttons.addButton(
            self.tr("&Begin"), QtWidgets.QDialogButtonBox.ButtonRole.AcceptRole
        )
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        last = in_row(every, none, FREE, PlainLabel(self.tr("Test number")), self.number)
        in_column(how, (area, 1), last, in_row((self._count, 1), buttons), on=self)
        em = self.fontMetrics().height()
        wide, high = area.minimumWidth() + 30, holder.sizeHint().height() + 12 * em
        room = self.screen().availableSize() * 0.9
        self.resize(min(wide, room.width()), min(high, room.height()))
        self._show_count()

    @property
    def topics(self) -> list[str]:
        return [name for name, box in self._boxes.items() if box.isChecked()]

    def _choose(self, on: bool) -> None:
        for box in self._boxes.values():
            box.setChecked(on and box.isEnabled())

    def _show_count(self) -> None:
        count = min(practice.MOST, sum(self._counts[name] for name in self.topics))
        self._count.setText(counted(count, "exercise") if count else self.tr("Choose topics."))
        self.begin.setEnabled(count > 0 and self.number.hasAcceptableInput())


def review_text(waiting: Waiting) -> str:
    """Return the name of the action that practises what has come back, with a mnemonic."""
    count = len(waiting.due)
    if not count:
        return QCoreApplication.translate("Practice", "&Review")
    some = counted(count, "exercise")
    if count > practice.MOST:
        some = QCoreApplication.translate("Practice", "{0} of {1}").format(practice.MOST, some)
    text = QCoreApplication.translate("Practice", "&Review: {0}, about {1}")
    return text.format(some, counted(waiting.minutes, "minute"))


def next_review(waiting: Waiting) -> str:
    """Return the sentence that says when the next exercises come back; empty if none will."""
    day = waiting.following
    if day is None:
        return ""
    if day <= date.today() + timedelta(days=1):
        return QCoreApplication.translate("Practice", "The next review is tomorrow.")
    said = QLocale().toString(QDate(day.year, day.month, day.day))
    return QCoreApplication.translate("Practice", "The next review is on {0}.").format(said)


class Practice(QObject):
    def __init__(
        self,
        window: QtWidgets.QWidget,
        card: LessonCard,
        record: Record,
        settings: Settings,
        messages: MessageBar,
    ) -> None:
        super().__init__(window)
        self._window, self._card, self._record = window, card, record
        self._settings, self._messages = settings, messages
        card.test_left.connect(self._show_kept)
        card.result_wanted.connect(lambda marks: self.save(of_test(marks)))

    # -- tests

    @property
    def begun(self) -> str:
        """The name of the test that is not finished yet; empty if there is none."""
        return next(
            (name for name in self._settings.progress if practice.named_test(name) is not None), ""
        )

    def choose_test(self) -> None:
        counts = {
            name: (course.lesson.title, sum(1 for _ in practice.exercises_of(course)))
            for name, course in topics().items()
        }
        dialog = SelfTestDialog(counts, random.randint(1, LARGEST_SEED), self._window)
        if dialog.exec():
            self.begin_test(dialog.topics, int(dialog.number.text()))
        dialog.deleteLater()

    def begin_test(self, names: list[str], number: int) -> None:
        """Begin a test instead of one that was begun."""
        if self.begun:
            self._settings.keep_progress(self.begun, None)
        self._play_test(names, number)

    def go_on(self) -> None:
        test = practice.named_test(self.begun)
        if test is not None:
            self._play_test(*test)

    def _show_kept(self) -> None:
        go_on = self.tr("Go on with it"), self.go_on
        self._messages.show_message(self.tr("The test is kept."), go_on, warns=False)

    def _play_test(self, names: list[str], number: int) -> None:
        every = len(names) == len(topics()) > 1
        said = self.tr("all topics") if every else ", ".join(names)
        title = self.tr("Test {0}: {1}").format(number, said)
        items = practice.draw_test(names, number)
        if items:
            self._card.play(Sheet(practice.name_of_test(names, number), title, items, is_test=True))
        else:
            self._messages.show_message(self.tr("These topics have no exercises yet."), warns=False)

    @property
    def attempts(self) -> list[Attempt]:
        """All answers of this student."""
        return corrected(self._record.read(), practice.hints_of)

    # -- results

    def save(self, attempts: Sequence[Attempt]) -> None:
        """Ask for a file, and write answers to it for a teacher."""
        title = self.tr("Save the result")
        asked = self.tr("Your name, if your teacher is to read it in the file:")
        student, is_wanted = QtWidgets.QInputDialog.getText(self._window, title, asked)
        path = ""
        if is_wanted:
            kinds = self.tr("Results (*.json);;All files (*)")
            path = ask_where(self._window, title, self.tr("result") + ".json", kinds, ".json")
        if not path:
            return
        try:
            name = one_line("student", spaced(student).strip(), LONGEST_STUDENT)
            write_bytes_atomically(path, to_json(name, attempts, __version__).encode())
        except Refusal as error:
            self._messages.show_message(sentence(error))
        else:
            self._messages.show_message(self.tr("The result is in {0}.").format(path), warns=False)

    # -- what was practised

    def show_overview(self) -> None:
        attempts = self.attempts
        known, problem = standings(attempts), self._record.problem
        waiting = practice.find_waiting(attempts)
        said = "" if problem is None else sentence(problem)
        lessons = practice.practised(lesson for lesson, _ in known)
        self.overview = overview = Overview(
            lessons, known, ideas_met(attempts, known), review_text(waiting), said, self._window
        )
        set_tip(overview.review, next_review(waiting))
        overview.review.setEnabled(bool(waiting.due))
        overview.lesson_wanted.connect(lambda course: self._card.open(course.lesson.path))
        overview.exercise_wanted.connect(
            lambda placed: self._card.open(placed.course.lesson.path, placed.here.step.name)
        )
        overview.review_wanted.connect(self.review)
        overview.test_wanted.connect(self.choose_test)
        overview.export_wanted.connect(partial(self.save, attempts))
        overview.show()

    # -- what has come back

    @property
    def waiting(self) -> Waiting:
        return practice.find_waiting(self.attempts)

    def review(self) -> None:
        """Practise what has come back, with new numbers."""
        attempts = self.attempts
        if self._record.problem is not None:
            self._messages.show_message(sentence(self._record.problem))
        waiting = practice.find_waiting(attempts)
        items = practice.to_review(waiting.due, standings(attempts))
        if items:
            self._card.play(Sheet("", self.tr("Review"), items, is_test=False))
            return
        when = next_review(waiting) or self.tr("What you do not solve alone comes back in a day.")
        text = self.tr("Nothing has come back today.")
        self._messages.show_message(f"{text} {when}", warns=False)
