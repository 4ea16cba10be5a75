"""The view of a task: it is ticked when the task is done in the window."""

from PySide6.QtCore import QTimer

from app.document.document import Document
from app.lessons.blocks.task import Task
from app.lessons.player import PlayedBlock
from app.model.refusal import Refusal
from widgets.window.lesson_blocks.view import BlockView, Sign, button

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
            state = self.played.here.shown_by(self.task.right)
            self._offer_state(state, self.tr("Sho&w it"), tip)
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
