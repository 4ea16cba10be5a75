"""The exercises as a student solved them: those of every topic, and those of a test with marks."""

from collections.abc import Mapping, Sequence
from functools import partial

from PySide6 import QtWidgets
from PySide6.QtCore import QSize, Qt, Signal, SignalInstance

from app.lessons.course import Course, idea_named
from app.lessons.practice import ExerciseMark, PlacedExercise, exercises_of
from app.lessons.record import ALONE, HELPED, RIGHT, SHOWN, Met, Standing
from app.lessons.text import in_line
from widgets.parts.labels import WarningLabel
from widgets.parts.layouts import FREE, TOP, in_column, in_row, push_button, tool_button
from widgets.parts.lesson_text import LessonText, answer_of
from widgets.parts.plain import PlainLabel
from widgets.window.lesson_blocks.view import Sign, on_holder

ICONS = {ALONE: "check", HELPED: "help", SHOWN: "lesson"}
"""The icon of how an exercise was solved; none for one that is not solved yet."""
LONGEST = 60  # most characters of an exercise in the name of its button


class Overview(QtWidgets.QDialog):
    """A window that lists what was practised, and leads there.

    `topics` are the lessons of the topics, and one's own by the names of their files. `known` is by
    lesson and ``step/block``, `ideas` by lesson and name. `problem` says why a part of the record
    could not be read.
    """

    lesson_wanted = Signal(object)  # a `Course`
    exercise_wanted = Signal(object)  # a `PlacedExercise`
    review_wanted = Signal()
    test_wanted = Signal()
    export_wanted = Signal()

    def __init__(
        self,
        topics: Mapping[str, Course],
        known: Mapping[tuple[str, str], Standing],
        ideas: Mapping[tuple[str, str], Met],
        review: str,
        problem: str,
        parent: QtWidgets.QWidget,
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Overview of what you practised"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._known, self._ideas = known, ideas
        self._words = {
            ALONE: self.tr("solved alone"), HELPED: self.tr("solved with help"),
            SHOWN: self.tr("answer shown"), "": self.tr("not yet"),
        }  # fmt: skip
        holder = QtWidgets.QWidget()
        grid = QtWidgets.QGridLayout(holder)
        grid.setColumnStretch(2, 1)
        grid.setVerticalSpacing(2)
        for row, (name, course) in enumerate(topics.items()):
            for column, widget in enumerate(self._row(name, course)):
                grid.addWidget(widget, row, column)
        grid.setRowStretch(len(topics), 1)
        area = QtWidgets.QScrollArea(widgetResizable=True)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setWidget(holder)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setMinimumWidth(holder.minimumSizeHint().width() + 30)
        warning = WarningLabel()
        warning.setText(problem)
        self.review = push_button(review, act=partial(self._go, self.review_wanted))
        test = push_button(self.tr("Test &yourself…"), act=partial(self._go, self.test_wanted))
        buttons = QtWidgets.QDialogButtonBox(QtWidgets.QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.close)
        export = push_button(
            self.tr("&Export…"), self.tr("Write all of it into a file for your teacher"),
            partial(self._go, self.export_wanted),
        )  # fmt: skip
        export.setEnabled(bool(known))
        last = in_row(self.review, test, export, FREE, buttons)
        in_column(self._legend(), warning, (area, 1), last, on=self)
        em = self.fontMetrics().height()
        wide = max(area.minimumWidth() + 30, 52 * em)
        self.resize(QSize(wide, 44 * em).boundedTo(parent.screen().availableSize() * 0.9))
        self.first.setFocus()

    @property
    def first(self) -> QtWidgets.QWidget:
        """Return the button that the keyboard begins at."""
        buttons = self.findChildren(QtWidgets.QToolButton)
        return self.review if self.review.isEnabled() or not buttons else buttons[0]

    def _legend(self) -> QtWidgets.QWidget:
        parts: list[QtWidgets.QWidget | None] = []
        for outcome, icon in ICONS.items():
            parts += [Sign(icon, self._words[outcome]), PlainLabel(self._words[outcome]), None]
        holder = QtWidgets.QWidget()
        in_row(
            *parts, PlainLabel(self.tr("only a number: not yet")), on=holder, margins=(4, 0, 4, 0)
        )
        return holder

    def _row(self, name: str, course: Course) -> Sequence[QtWidgets.QWidget]:
        """Return a topic's button, those of its exercises, and its wrong ideas."""
        title = f"{name}  {course.lesson.title}"
        act = partial(self._go, self.lesson_wanted, course)
        topic = tool_button(title, self.tr("Open the lesson"), act, flat=True, by_click=True)
        parts = [
            self._exercise(name, number, each)
            for number, each in enumerate(exercises_of(course), 1)
        ]
        row = on_holder(*parts, FREE, gap=2)
        return topic, row, PlainLabel(self._met(course), wordWrap=True)

    def _exercise(self, topic: str, number: int, placed: PlacedExercise) -> QtWidgets.QToolButton:
        standing = self._known.get(placed.key, Standing())
        outcome = self._words[standing.outcome]
        text = in_line(placed.exercise.text)
        text = text if len(text) <= LONGEST else f"{text[:LONGEST]}…"
        said = self.tr("{0}, exercise {1}: {2}. {3}").format(topic, number, outcome, text)
        act = partial(self._go, self.exercise_wanted, placed)
        icon = ICONS.get(standing.outcome, "")
        return tool_button(str(number), said, act, icon=icon, name=said, by_click=True)

    def _met(self, course: Course) -> str:
        """Say which wrong ideas were met in a lesson, and how it went on."""
        replies = (r for step in course.lesson.steps for asked in step.asked for r in asked.replies)
        titles = {reply.idea: reply.title for reply in replies if reply.title}
        said = []
        for (lesson, name), met in self._ideas.items():
            idea = idea_named(name)
            if lesson == course.name:
                title = titles.get(name) or (idea.title if idea else name.replace("-", " "))
                times = self.tr("once") if met.times == 1 else self.tr("%n times", "", met.times)
                text = self.tr("“{0}” {1}; then: {2}")
                said.append(text.format(title.rstrip("."), times, self._words[met.outcome]))
        return "\n".join(said)

    def _go(self, signal: SignalInstance, *what: object) -> None:
        self.close()
        signal.emit(*what)


class SelfTestMarks(QtWidgets.QWidget):
    """The marks of a test and its solutions; `title` says how many are right, and stands above."""

    def __init__(self, marks: Sequence[ExerciseMark]) -> None:
        super().__init__()
        right = sum(mark.word == RIGHT for mark in marks)
        said = self.tr("{0} of {1} right").format(right, len(marks))
        parts = [self._marked(number, mark) for number, mark in enumerate(marks, 1)]
        self.title = LessonText(said, title=True)
        in_column(*parts, on=self, margins=(0, 0, 0, 0), gap=10)
        self.setAccessibleName(said)

    def _marked(self, number: int, mark: ExerciseMark) -> QtWidgets.QWidget:
        question, here = mark.item.variant.question, mark.item.variant.here
        texts = [f"**{number}.** {question.text}", self._own(mark)]
        right = question.right_text(answer_of(question, here))
        if right:
            texts.append(self.tr("The right answer:") + f" {right}")
        texts += question.reasons(here)
        is_right = mark.word == RIGHT
        sign = Sign("check", self.tr("Right")) if is_right else Sign("close", self.tr("Wrong"))
        words = LessonText("\n\n".join(filter(None, texts)))
        return on_holder((sign, TOP), (words, 1), gap=4)

    def _own(self, mark: ExerciseMark) -> str:
        """Return the student's own answer, and the idea behind it."""
        if not mark.typed:
            return self.tr("You gave no answer.")
        own = mark.item.variant.question.own_answer(mark.typed)
        said = self.tr("Your answer:") + f" {own}"
        title = mark.item.variant.question.response_to(mark.item.variant.here, mark.word).title
        if title:
            behind = self.tr("The idea behind it: “{0}”.").format(title)
            said = f"{said}\n\n{behind}"
        return said
