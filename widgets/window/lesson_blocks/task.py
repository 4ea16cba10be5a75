"""The view of a task: it is ticked when the task is done in the window."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QTimer

from app.document.document import Document
from app.document.view import View
from app.lessons.blocks.task import Task
from app.lessons.course import AtStep
from app.lessons.record import RIGHT, SHOWN
from app.lessons.writing import changes
from app.model.refusal import Refusal
from widgets.window.lesson_blocks.view import REVEALED, BlockView, Sign, button

REST_MS = 900
"""How long nothing has changed when a wrong idea is named."""
DONE = "done"
"""Stored as the answer of a finished task."""

_IN_CONDITIONS = {"panes": "turned", "probes": "_"}
"""The names that conditions have for fields of the view with other names."""


class TaskView(BlockView):
    """A task that may be solved in any way; it is ticked when it is done."""

    def __init__(self, here: AtStep, task: Task) -> None:
        sign = Sign("", "")
        super().__init__(here, task, sign)
        self.task, self._sign, self._now = task, sign, here.document
        self._refuted: set[int] = set()
        """The lines of the wrong ideas that were named: each is named once."""
        self._resting = QTimer(self, singleShot=True, interval=REST_MS)
        self._resting.timeout.connect(self.rest)
        sign.show_icon("", self.tr("To do"))

    def begin_test(self) -> None:
        super().begin_test()
        tip = self.tr("The window as it is now is my answer")
        self._insert(button(self.tr("Hand it &in"), tip, self.hand_in))

    @property
    def _given(self) -> str:
        """Return what was changed, as in a sample; of the view only what the task is about."""
        asked = " ".join(condition.text for _, condition in self.task.until)

        def matters(change: str) -> bool:
            section, _, name = change.partition("=")[0].partition(".")
            return section != "view" or _IN_CONDITIONS.get(name, name) in asked

        return " ".join(filter(matters, changes(self.here.document, self._now)))

    def hand_in(self) -> None:
        """Keep the window's current state as the answer of a test."""
        given = self._given
        if given:
            self._hand_in(given)
        else:
            self._show_problem(self.tr("Nothing is changed yet."))
            self._speak(self.tr("Nothing is changed yet."))

    def restore(self, answer: str) -> None:
        self.answer = answer
        if answer == REVEALED:
            self._show_right_answer()
        else:
            self._tick()

    def give_hint(self) -> None:
        super().give_hint()
        self._offer_answer(self.reveal_answer)

    def reveal_answer(self) -> None:
        """Show how the task is done."""
        self._remove_response()
        self._show_right_answer()
        self._speak(self._why)
        self.tried.emit("", SHOWN)
        self._settle(REVEALED)

    @property
    def _why(self) -> str:
        return self.task.why or self.tr("You can see a state that fulfils the task.")

    def _show_right_answer(self) -> None:
        self._add_text("help", "", self._why)
        if self.task.right is not None:
            tip = self.tr("Show a state that makes it visible (Alt+W)")
            self._offer_state(self.here.shown_by(self.task.right), self.tr("Sho&w it"), tip)

    def _offer_answer(self, act: Callable[[], object]) -> None:
        if self.task.why or self.task.right is not None:
            super()._offer_answer(act)

    def look(self, document: Document, view: View) -> None:
        self._now = replace(document, view=view)
        if not self.is_open or self.is_test:
            return
        try:
            is_done = self.task.is_done(self.here, document, view)
        except Refusal as error:
            self._refuse(error)
            return
        if is_done:
            self._resting.stop()
            self._remove_response()
            self._tick()
            self.tried.emit(self._given, RIGHT)
            self._speak(self.tr("Done."), self.task.done, self.task.why)
            self._settle(DONE)
        elif document != self.here.document:  # tried
            self._offer_answer(self.reveal_answer)
            if self.task.wrong:
                self._resting.start()

    def rest(self) -> None:
        """Name the wrong idea behind what was done, once the hand rests."""
        if not self.is_open:
            return
        try:
            wrong = self.task.mistaken(self.here, self._now, self._now.view)
            verdict = wrong.verdict(self.here) if wrong is not None else None
        except Refusal as error:
            self._refuse(error)
            return
        if wrong is not None and verdict is not None and wrong.line not in self._refuted:
            self._refuted.add(wrong.line)
            self._remove_response()
            self.tried.emit(self._given, verdict.word)
            self._refute(verdict)

    def _tick(self) -> None:
        self._sign.show_icon("check", self.tr("Done"))
        self._add_text("", "", self.task.done or self.tr("Done."))
        self._add_text("", "", self.task.why)
