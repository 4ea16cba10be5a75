"""The frame of a question that is marked at each attempt.

Its answer is offered after a wrong attempt or a hint.
"""

from __future__ import annotations

from abc import abstractmethod

from PySide6.QtWidgets import QPushButton

from app.lessons.blocks.question import MarkedQuestion, Verdict
from app.lessons.course import AtStep
from app.lessons.record import SHOWN
from app.model.refusal import Refusal
from widgets.parts.lesson_text import answer_of
from widgets.parts.messages import sentence
from widgets.window.lesson_blocks.view import REVEALED, BlockView, hand_in


class MarkedAnswerView(BlockView):
    """A question whose answers are submitted with `_submit`."""

    _check: QPushButton

    def __init__(self, here: AtStep, question: MarkedQuestion) -> None:
        super().__init__(here, question)
        self.question = question

    @abstractmethod
    def _close(self) -> None:
        """Accept no further answer."""

    def _mark(self, typed: str) -> Verdict:
        return self.question.mark(self.here, typed)

    def _show_verdict(self, verdict: Verdict) -> None:
        """Show the verdict where the answer is, besides the sentences below."""

    def restore(self, answer: str) -> None:
        try:
            if answer == REVEALED:
                self._show_right_answer()
                self.answer = REVEALED
                return
            verdict = self.question.mark(self.here, answer)
        except Refusal:  # the lesson has changed meanwhile
            return
        if verdict.right:
            self._show(answer)
            self.answer = answer
            self._praise_and_close(verdict)

    def begin_test(self) -> None:
        super().begin_test()
        hand_in(self._check)

    def _submit(self, typed: str, given: str | None = None) -> None:
        """Mark an answer, and say whether it is right; `given` is recorded in place of `typed`."""
        given = typed if given is None else given
        self._remove_response()
        try:
            verdict = self._mark(typed)
        except Refusal as error:
            self._refuse(error)
            self._speak(sentence(error))
            return
        if self.is_test:
            self._hand_in(given)
            return
        if verdict.right:
            self.tried.emit(given, verdict.word)
            self._praise_and_close(verdict)
            self._settle(typed)
            return
        self._show_verdict(verdict)
        if verdict.too_short:
            text = self.tr("So far so good, but three significant digits are needed.")
            self._add_text("help", self.tr("Too few digits"), text)
            self._speak(text)
            return
        self.tried.emit(given, verdict.word)
        self._offer_answer(self.reveal_answer)
        if verdict.idea or verdict.says:
            self._refute(verdict)
        else:
            text = self.tr("That is not it.")
            if verdict.remark is not None:
                text += " " + sentence(verdict.remark)
            if self.hints:
                text += " " + self.tr("The hint (Alt+I) says how to begin.")
            self._add_text("close", self.tr("Wrong"), text)
            self._speak(text)

    def _praise_and_close(self, verdict: Verdict) -> None:
        self._show_verdict(verdict)
        self._close()
        self._praise(verdict)
        if not verdict.says or self.here.given:  # an exercise's reason need not have its numbers
            self._add_text("", "", self.question.solution(self.here))

    def give_hint(self) -> None:
        super().give_hint()
        self._offer_answer(self.reveal_answer)

    def reveal_answer(self) -> None:
        """Show the right answer, and the way to it."""
        self._remove_response()
        try:
            self._show_right_answer()
        except Refusal as error:
            self._refuse(error)
        else:
            self.tried.emit("", SHOWN)
            self._settle(REVEALED)

    def _show_right_answer(self) -> None:
        answer = answer_of(self.question, self.here)
        text = self.tr("The answer is {0}.").format(answer)
        if "\n" in answer:  # a table stands by itself
            text = self.tr("The answer is:") + f"\n\n{answer}\n\n"
        self._close()
        text = f"{text} {self.question.why}".strip()
        solution = self.question.solution(self.here)
        self._add_text("help", "", text)
        self._add_text("", "", solution)
        self._speak(text, solution)
