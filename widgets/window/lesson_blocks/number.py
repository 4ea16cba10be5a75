"""The view of a question whose answer is a number."""

from __future__ import annotations

from PySide6.QtWidgets import QLineEdit, QSizePolicy, QWidget

from app.lessons.blocks.answer import Answer
from app.lessons.blocks.question import Verdict
from app.lessons.course import AtStep
from app.lessons.text import plain_of
from app.model.refusal import Refusal
from widgets.parts.layouts import FREE
from widgets.parts.lesson_text import answer_of
from widgets.parts.messages import sentence
from widgets.parts.plain import Label, set_tip
from widgets.window.lesson_blocks.view import BlockView, button, on_holder

TRIES = 3
"""Number of attempts after which the answer is offered."""
TOLD = "told"
"""Stored as the answer if the program has shown it."""


class Types(BlockView):
    """A question with a typed number."""

    def __init__(self, here: AtStep, question: Answer) -> None:
        super().__init__(here, question)
        self.question = question
        self._tries = 0
        self.field = QLineEdit()
        self.field.setAccessibleName(self.tr("Answer: {0}").format(plain_of(question.text)))
        set_tip(
            self.field,
            self.tr("A number: 0.5, 1 1/2, √3/2, 2e-3 or 45°, to three significant digits (Enter)"),
        )
        self.field.setMaxLength(80)
        self.field.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self.field.setMaximumWidth(11 * self.fontMetrics().height())
        self.field.returnPressed.connect(self.check)
        self._check = button(self.tr("Chec&k"), self.tr("Enter"), self.check)
        unit = [Label(question.unit)] if question.unit else []
        self._insert(on_holder((self.field, 1), *unit, self._check, FREE, gap=5))

    @property
    def first(self) -> QWidget | None:
        return self.field

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
            self.field.setText(answer)
            self.answer = answer
            self._close(verdict)

    def check(self) -> None:
        """Say whether the typed number is right."""
        if not self.is_open:
            return
        typed = self.field.text()
        self._hush()
        try:
            verdict = self.question.mark(self.here, typed)
        except Refusal as error:
            self._refuse(error)
            self._announce(sentence(error))
            return
        if verdict.right:
            self._close(verdict)
            self._settle(typed)
            return
        self.field.selectAll()
        if verdict.too_short:
            text = self.tr("So far so good, but three significant digits are needed.")
            self._say("help", self.tr("Too few digits"), text)
            self._announce(text)
            return
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

    def _close(self, verdict: Verdict | None = None) -> None:
        """Accept no further answer, and praise this one."""
        self.field.setReadOnly(True)
        self._check.hide()
        if verdict is not None:
            self._praise(verdict)

    def _give_away(self) -> None:
        self._hush()
        try:
            self._tell()
        except Refusal as error:
            self._refuse(error)
        else:
            self._settle(TOLD)

    def _tell(self) -> None:
        text = self.tr("The answer is {0}.").format(answer_of(self.question, self.here))
        self._close()
        self._say("help", "", f"{text} {self.question.why}".strip())
        self._say("", "", self.question.solution(self.here))
        self._announce(text)
