"""The frame of a question that is marked at each attempt, and the views of simple ones.

Its answer is offered after a wrong attempt or a hint.
"""

from abc import abstractmethod
from collections.abc import Callable

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import QLineEdit, QPushButton, QSizePolicy, QWidget

from app.document.document import Document
from app.lessons.blocks.answer import Answer
from app.lessons.blocks.block import Verdict
from app.lessons.blocks.click import Click
from app.lessons.blocks.question import MarkedQuestion, Value
from app.lessons.blocks.task import Task
from app.lessons.player import PlayedBlock
from app.lessons.text import spoken_text
from app.model.refusal import Refusal
from widgets.parts.layouts import FREE
from widgets.parts.lesson_text import answer_of
from widgets.parts.messages import sentence
from widgets.parts.plain import PlainLabel, set_tip
from widgets.window.lesson_blocks.view import BlockView, Sign, button, on_holder


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
        if verdict.idea or verdict.says or verdict.beside:
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
        return self._add_right_answer(text)


class NumberAnswerView(MarkedAnswerView):
    def __init__(self, played: PlayedBlock, question: Answer) -> None:
        super().__init__(played, question)
        self.field = QLineEdit()
        self.field.setAccessibleName(self.tr("Answer: {0}").format(spoken_text(question.text)))
        set_tip(
            self.field,
            self.tr("A number: 0.5, 1 1/2, √3/2, 2e-3 or 45°, to three significant digits (Enter)"),
        )
        self.field.setMaxLength(80)
        self.field.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self.field.setMaximumWidth(11 * self.fontMetrics().height())
        self.field.returnPressed.connect(self.check)
        self._check = self._answer_button(self.check)
        unit = [PlainLabel(question.unit)] if question.unit else []
        self._insert(on_holder((self.field, 1), *unit, self._check, FREE, gap=5))

    @property
    def first(self) -> QWidget | None:
        return self.field

    def check(self) -> None:
        """Say whether the typed number is right."""
        if self.played.is_open:
            self._submit(self.field.text())

    @property
    def typed(self) -> str:
        return self.field.text()

    def _show(self, typed: str) -> None:
        self.field.setText(typed)

    def _show_verdict(self, verdict: Verdict) -> None:
        if not verdict.right:
            self.field.selectAll()

    def _close(self) -> None:
        self.field.setReadOnly(True)
        self._check.hide()


REST_MS = 900  # how long nothing has changed when a wrong idea is named


class TaskView(BlockView):
    """A task that may be solved in any way; it is ticked when it is done."""

    def __init__(self, played: PlayedBlock, task: Task) -> None:
        sign = Sign("", "")
        super().__init__(played, task, sign)
        self.task, self._sign = task, sign
        self._resting = QTimer(self, singleShot=True, interval=REST_MS)
        self._resting.timeout.connect(self.rest)
        sign.show_icon("", self.tr("To do"))
        if played.is_test:
            tip = self.tr("The window as it is now is my answer")
            self._insert(button(self.tr("Hand it &in"), tip, self.hand_in))

    def hand_in(self) -> None:
        """Keep the window's current state as the answer of a test."""
        given = self.played.changes
        if given:
            self.played.hand_in(given)
            self._handed_in()
        else:
            self._show_problem(self.tr("Nothing is changed yet."))
            self._speak(self.tr("Nothing is changed yet."))

    def _restore(self, answer: str) -> None:
        self._tick()

    def _show_right_answer(self) -> list[str]:
        why = self.task.why or self.tr("You can see a state that fulfils the task.")
        self._add_text("help", "", why)
        if self.task.right is not None:
            tip = self.tr("Show a state that makes it visible (Alt+W)")
            self._offer_state(self.played.here.shown_by(self.task.right), self.tr("Sho&w it"), tip)
        return [why]

    def look(self, now: Document) -> None:
        played = self.played
        try:
            is_done = played.look(now)
        except Refusal as error:
            self._refuse(error)
            return
        if is_done:
            self._resting.stop()
            self._remove_response()
            self._tick()
            self._speak(self.tr("Done."), self.task.done, self.task.why)
            self._settled()
        elif played.is_open and now != played.here.document and not played.is_test:
            self._offer_answer()
            if self.task.replies:
                self._resting.start()

    def rest(self) -> None:
        """Name the wrong idea behind what was done, once the hand rests."""
        try:
            verdict = self.played.name_idea()
        except Refusal as error:
            self._refuse(error)
            return
        if verdict is not None:
            self._remove_response()
            self._refute(verdict)

    def _tick(self) -> None:
        self._sign.show_icon("check", self.tr("Done"))
        self._add_text("", "", self.task.done or self.tr("Done."))
        self._add_text("", "", self.task.why)


NOWHERE = "-"  # recorded for a place that has no coordinates


class ClickView(MarkedAnswerView):
    """A place in a picture; `Pointing` shows the crosshair there, and says where it is."""

    wanted = Signal()  # the user wants to move the crosshair
    question: Click

    def __init__(self, played: PlayedBlock, question: Click) -> None:
        super().__init__(played, question)
        self._away_px: Callable[[Value], float] | None = None
        self._place: Value = ()
        self._is_settled = False
        pictures = {
            "world": self.tr("world"), "ndc": self.tr("NDC cube"), "image": self.tr("image")
        }  # fmt: skip
        name = self.tr("Click in the picture: {0}").format(pictures[question.pane])
        tip = self.tr("Click there; or here, then move the crosshair with the arrow keys (Enter)")
        self._go = button(name, tip, self.wanted.emit)
        self._check = self._answer_button(self.check)
        self._check.setEnabled(False)
        self._insert(on_holder(self._go, self._check, FREE, gap=5))

    @property
    def first(self) -> QWidget | None:
        return self._check if self._check.isEnabled() else self._go

    @property
    def aims(self) -> BlockView | None:
        return self if self.played.is_open or self._is_settled else None

    def take(self, away_px: Callable[[Value], float], place: Value) -> None:
        """Take the place of the crosshair, and a function for its distance from others."""
        self._away_px, self._place = away_px, place
        self._check.setEnabled(self.played.is_open)

    def check(self) -> None:
        """Say whether the crosshair is at the right place."""
        if self.played.is_open and self._away_px is not None:
            # Kept as the right place: the crosshair's own depends on the window's size.
            self._submit(_written(self.question.answer(self.played.here)), _written(self._place))

    def show_other_state(self) -> None:
        """Say that the picture shows another state, in which the answer would be another one."""
        self._show_problem(self.tr("The picture shows something else now."))
        name, tip = self.tr("Show it a&gain"), self.tr("Show the state of the question")
        self._offer_state(self.played.here.document, name, tip)
        self._speak(self.tr("The picture shows something else now."))

    def _mark(self) -> Verdict:
        assert self._away_px is not None
        return self.question.verdict_at(self.played.here, self._away_px)

    def _settled(self) -> None:
        self._is_settled = True
        super()._settled()

    def _show(self, typed: str) -> None:
        """Show nothing: the picture may show another state by now."""

    def _close(self) -> None:
        self._go.hide()
        self._check.hide()


def _written(place: Value) -> str:
    return " ".join(f"{value:.6g}" for value in place) or NOWHERE
