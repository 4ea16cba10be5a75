"""The end of a test: every exercise with the student's answer beside the right one."""

from collections.abc import Sequence

from PySide6.QtWidgets import QWidget

from app.lessons.practice import ExerciseMark
from app.lessons.record import RIGHT
from widgets.parts.layouts import TOP, in_column
from widgets.parts.lesson_text import LessonText, answer_of
from widgets.window.lesson_blocks.view import Sign, on_holder


class SelfTestMarks(QWidget):
    """The marks of a test and its solutions; `title` says how many are right, and stands above."""

    def __init__(self, marks: Sequence[ExerciseMark]) -> None:
        super().__init__()
        right = sum(mark.word == RIGHT for mark in marks)
        said = self.tr("{0} of {1} right").format(right, len(marks))
        parts = [self._marked(number, mark) for number, mark in enumerate(marks, 1)]
        self.title = LessonText(said, title=True)
        in_column(*parts, on=self, margins=(0, 0, 0, 0), gap=10)
        self.setAccessibleName(said)

    def _marked(self, number: int, mark: ExerciseMark) -> QWidget:
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
