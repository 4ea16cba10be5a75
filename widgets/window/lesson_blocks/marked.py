"""The frame of a question that is marked at each attempt.

Its answer is offered after a wrong attempt or a hint.
"""

from abc import abstractmethod

from PySide6.QtWidgets import QPushButton

from app.lessons.blocks.block import Verdict
from app.lessons.blocks.question import MarkedQuestion
from app.lessons.player import PlayedBlock
from app.model.refusal import Refusal
from widgets.parts.lesson_text import answer_of
from widgets.parts.messages import sentence
from widgets.window.lesson_blocks.view import BlockView


class MarkedAnswerView(BlockView):
    """A question whose answers are submitted with `_submit`."""

    _check: QPushButton

    def __init__(self, played: PlayedBlock, question: MarkedQuestion) -> None:
        super().__init__(played, question)
        self.question = question

    @abstractmethod
    def _close(self) -> None:
        """Accept no further answer."""

    def _mark(self) -> Verdict | None:
        """Return the verdict, if only the window can mark the answer."""
        return None

    def _show_verdict(self, verdict: Verdict) -> None:
        """Show the verdict where the answer is, besides the sentences below."""

    def _restore(self, answer: str) -> None:
        self._show(answer)
        self._praise_and_close(self.question.mark(self.played.here, answer))

    def _submit(self, typed: str, given: str = "") -> None:
        """Mark an answer, and say whether it is right; `given` is recorded in place of `typed`."""
        self._remove_response()
        try:
            verdict = self.played.submit(typed, self._mark(), given)
        except Refusal as error:
            self._refuse(error)
            self._speak(sentence(error))
            return
        if self.played.is_test:
            self._handed_in()
        elif verdict.right:
            self._praise_and_close(verdict)
            self._settled()
        else:
            self._show_verdict(verdict)
            self._respond(verdict)

    def _respond(self, verdict: Verdict) -> None:
        """Say what is wrong."""
        if verdict.too_short:
            text = self.tr("So far so good, but three significant digits are needed.")
            self._add_text("help", self.tr("Too few digits"), text)
            self._speak(text)
            return
        self._offer_answer()
        if verdict.idea or verdict.says:
            self._refute(verdict)
            return
        text = self.tr("That is not it.")
        if verdict.remark is not None:
            text += " " + sentence(verdict.remark)
        if self.played.hints:
            text += " " + self.tr("The hint (Alt+I) says how to begin.")
        self._add_text("close", self.tr("Wrong"), text)
        self._speak(text)

    def _praise_and_close(self, verdict: Verdict) -> None:
        here = self.played.here
        self._show_verdict(verdict)
        self._close()
        self._praise(verdict)
        if not verdict.says or here.given:  # an exercise's reason need not have its numbers
            self._add_text("", "", self.question.solution(here))

    def _show_right_answer(self) -> list[str]:
        answer = answer_of(self.question, self.played.here)
        text = self.tr("The answer is {0}.").format(answer)
        if "\n" in answer:  # a table stands by itself
            text = self.tr("The answer is:") + f"\n\n{answer}\n\n"
        self._close()
        return self._tell(text)
