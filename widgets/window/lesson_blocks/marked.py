"""The frame of a question that is marked at each attempt; after some, its answer is offered."""

from __future__ import annotations

from abc import abstractmethod

from PySide6.QtWidgets import QPushButton

from app.lessons.blocks.question import Marked, Verdict
from app.lessons.course import AtStep
from app.lessons.record import SHOWN
from app.model.refusal import Refusal
from widgets.parts.lesson_text import answer_of
from widgets.parts.messages import sentence
from widgets.window.lesson_blocks.view import BlockView, hand_in

TRIES = 3
"""Number of attempts after which the answer is offered."""
TOLD = "told"
"""Stored as the answer if the program has shown it."""


class Attempts(BlockView):
    """A question whose answers are submitted with `_submit`."""

    _check: QPushButton

    def __init__(self, here: AtStep, question: Marked) -> None:
        super().__init__(here, question)
        self.question = question
        self._tries = 0

    @abstractmethod
    def _close(self) -> None:
        """Accept no further answer."""

    def _mark(self, typed: str) -> Verdict:
        return self.question.mark(self.here, typed)

    def _show_verdict(self, verdict: Verdict) -> None:
        """Show the verdict where the answer is, besides the sentences below."""

    def restore(self, answer: str) -> None:
        try:
            if answer == TOLD:
                self._tell()
                self.answer = TOLD
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
        self._hush()
        try:
            verdict = self._mark(typed)
        except Refusal as error:
            self._refuse(error)
            self._announce(sentence(error))
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
            self._say("help", self.tr("Too few digits"), text)
            self._announce(text)
            return
        self.tried.emit(given, verdict.word)
        self._tries += 1
        if verdict.idea or verdict.says:
            self._refute(verdict)
        else:
            text = self.tr("That is not it.")
            if verdict.remark is not None:
                text += " " + sentence(verdict.remark)
            if self.hints:
                text += " " + self.tr("The hint (Alt+I) says how to begin.")
            self._say("close", self.tr("Wrong"), text)
            self._announce(text)
        if self._tries >= TRIES:
            tip = self.tr("Show the right answer, and why it is right (Alt+A)")
            self._offer(self.tr("Show the &answer"), tip, self._give_away)

    def _praise_and_close(self, verdict: Verdict) -> None:
        self._show_verdict(verdict)
        self._close()
        self._praise(verdict)

    def _give_away(self) -> None:
        self._hush()
        try:
            self._tell()
        except Refusal as error:
            self._refuse(error)
        else:
            self.tried.emit("", SHOWN)
            self._settle(TOLD)

    def _tell(self) -> None:
        answer = answer_of(self.question, self.here)
        text = self.tr("The answer is {0}.").format(answer)
        if "\n" in answer:  # a table stands by itself
            text = self.tr("The answer is:") + f"\n\n{answer}\n\n"
        self._close()
        self._say("help", "", f"{text} {self.question.why}".strip())
        self._say("", "", self.question.solution(self.here))
        self._announce(text)
