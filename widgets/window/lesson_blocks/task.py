"""A task in its frame: it ticks itself when it is done in the window."""

from __future__ import annotations

from app.document.document import Document
from app.document.view import View
from app.lessons.blocks.task import Task
from app.lessons.course import AtStep
from app.model.refusal import Refusal
from widgets.parts.layouts import TOP
from widgets.parts.lesson_text import LessonText
from widgets.window.lesson_blocks.view import BlockView, Sign, on_holder

DONE = "done"
"""What is kept of a task that is done."""


class Tries(BlockView):
    """Something to do in the window, in any way; it ticks itself when it is done."""

    def __init__(self, here: AtStep, task: Task) -> None:
        super().__init__(here, task)
        self.task = task
        self._sign = Sign("", self.tr("To do"))
        self._column.addWidget(on_holder((self._sign, TOP), (LessonText(task.text), 1), gap=4))
        self._column.addLayout(self._said)

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
            self._announce(self.tr("Done."), self.task.done)
            self._settle(DONE)

    def _tick(self) -> None:
        self._sign.show_icon("check", self.tr("Done"))
        self._say("", "", self.task.done or self.tr("Done."))
