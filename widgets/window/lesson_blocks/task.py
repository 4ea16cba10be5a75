"""The view of a task: it is ticked when the task is done in the window."""

from __future__ import annotations

from dataclasses import replace

from app.document.document import Document
from app.document.view import View
from app.lessons.blocks.task import Task
from app.lessons.course import AtStep
from app.lessons.record import RIGHT
from app.lessons.writing import changes
from app.model.refusal import Refusal
from widgets.window.lesson_blocks.view import BlockView, Sign

DONE = "done"
"""Stored as the answer of a finished task."""


class Tries(BlockView):
    """A task that may be solved in any way; it is ticked when it is done."""

    def __init__(self, here: AtStep, task: Task) -> None:
        sign = Sign("", "")
        super().__init__(here, task, sign)
        self.task, self._sign = task, sign
        sign.show_icon("", self.tr("To do"))

    def restore(self, answer: str) -> None:
        self.answer = DONE
        self._tick()

    def look(self, document: Document, view: View) -> None:
        if not self.is_open:
            return
        try:
            is_done = self.task.is_done(self.here, document, view)
        except Refusal as error:
            self._refuse(error)
            return
        if is_done:
            self._hush()
            self._tick()
            self.tried.emit(changes(self.here.document, replace(document, view=view)), RIGHT)
            self._announce(self.tr("Done."), self.task.done)
            self._settle(DONE)

    def _tick(self) -> None:
        self._sign.show_icon("check", self.tr("Done"))
        self._say("", "", self.task.done or self.tr("Done."))
