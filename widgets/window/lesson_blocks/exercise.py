"""The view of an exercise: its seed, "Another one", and the view of the question it becomes."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtGui import QIntValidator
from PySide6.QtWidgets import QLineEdit, QWidget

from app.document.document import Document
from app.document.view import View
from app.lessons.blocks.block import Asked
from app.lessons.blocks.exercise import LARGEST_SEED, Exercise, Variant
from app.lessons.course import AtStep
from app.model.refusal import Refusal
from widgets.parts.layouts import FREE
from widgets.parts.plain import PlainLabel, set_tip
from widgets.window.lesson_blocks.view import BlockView, button, on_holder

ViewOf = Callable[[AtStep, Asked], BlockView]


class ExerciseView(BlockView):
    """An exercise; the answer of the student is kept with the seed that drew its numbers."""

    def __init__(self, here: AtStep, exercise: Exercise, view_of: ViewOf) -> None:
        super().__init__(here, exercise)
        self._words.hide()  # each variant has its own
        self.exercise, self._view_of = exercise, view_of
        self.variant: Variant | None = None
        self.asked: BlockView | None = None
        """The view of the question with its numbers; None before the student begins."""
        self.seed = QLineEdit("1")
        self.seed.setValidator(QIntValidator(1, LARGEST_SEED, self))
        self.seed.setAccessibleName(self.tr("Number of the variant"))
        set_tip(self.seed, self.tr("The same number gives the same exercise to everyone (Enter)"))
        self.seed.setMaximumWidth(4 * self.fontMetrics().height())
        self.seed.returnPressed.connect(self.begin)
        self._begin = button(
            self.tr("Be&gin"), self.tr("Draw the numbers, and show their state"), self.begin
        )
        self._another = button(
            self.tr("Another &one"), self.tr("The same exercise with new numbers"), self.go_on
        )
        self._another.hide()
        title = PlainLabel(self.tr("Exercise"))
        title.setObjectName("paneTitle")
        self._row = on_holder(
            PlainLabel(self.tr("Variant")), self.seed, self._begin, self._another, gap=5
        )
        self._insert(on_holder(title, FREE, self._row, gap=5))

    @property
    def first(self) -> QWidget | None:
        return self._begin if self.asked is None else self.asked.first

    @property
    def is_open(self) -> bool:
        return self.asked is None or self.asked.is_open

    @property
    def hides(self) -> frozenset[str]:
        is_asked = self.asked is not None and (self.is_test or self.asked.is_open)
        return self.exercise.hides if is_asked else frozenset()

    @property
    def aims(self) -> BlockView | None:
        return None if self.asked is None else self.asked.aims

    @property
    def variant_seed(self) -> int:
        return self.variant.seed if self.variant is not None else 0

    def restore(self, answer: str) -> None:
        seed, _, given = answer.partition(" ")
        if self.is_test and seed != self.seed.text():  # the lessons have changed since
            return
        self.seed.setText(seed)
        if self._draw() and self.asked is not None:
            if self.is_test:
                self.asked.show_kept_answer(given)
            else:
                self.asked.restore(given)
            self.answer = answer

    def pose(self, seed: int, *, is_test: bool) -> None:
        """Ask with the numbers of a seed, which the window shows already."""
        self.is_test = is_test
        self._row.setHidden(is_test)
        self.seed.setText(str(seed))
        self._draw()

    @property
    def response(self) -> list[QWidget]:
        if self.asked is None:
            return super().response
        return self.asked.response or [self.asked]

    def open_up(self) -> None:
        """Show the state of the numbers; draw them first if they are not drawn yet."""
        if self.is_test:  # its step is in this state, with the panels closed
            if self.is_open:
                self.responded.emit()
            return
        if self.asked is not None or self._draw():
            assert self.variant is not None
            self.posed.emit(self.variant.here.document)
            if self.is_open and self.first is not None:
                self.responded.emit()

    def begin(self) -> None:
        """Draw the numbers of the seed, and show their state."""
        if self._draw() and self.variant is not None and self.asked is not None:
            self.posed.emit(self.variant.here.document)
            if self.asked.first is not None:
                self.asked.first.setFocus()
            self.responded.emit()

    def go_on(self) -> None:
        """Draw the numbers of the next seed."""
        self.seed.setText(str(int(self.seed.text() or "0") % LARGEST_SEED + 1))
        self.begin()

    def _draw(self) -> bool:
        """Make the view of the variant; say why if there is none."""
        self._remove_response()
        try:
            self.variant = self.exercise.variant(self.here, max(1, int(self.seed.text() or "1")))
        except Refusal as error:
            self._refuse(error)
            return False
        asked = self._view_of(self.variant.here, self.variant.question)  # type: ignore[arg-type]
        asked.settled.connect(self._settled)
        asked.show_wanted.connect(self.show_wanted)
        asked.responded.connect(self.responded)
        asked.tried.connect(self.tried)
        asked.set_within()
        if self.asked is not None:
            self._column.removeWidget(self.asked)
            self.asked.hide()
            self.asked.deleteLater()
        if self.is_test:
            asked.begin_test()
        self.asked, self.answer = asked, ""
        self.hints, self.hints_read = asked.hints, 0
        self._insert(asked)
        self._begin.hide()
        self._another.show()
        return True

    def _settled(self, given: str) -> None:
        assert self.variant is not None
        self._settle(f"{self.variant.seed} {given}")

    def give_hint(self) -> None:
        if self.asked is not None:
            self.asked.give_hint()
            self.hints_read = self.asked.hints_read

    def look(self, document: Document, view: View) -> None:
        if self.asked is not None:
            self.asked.look(document, view)
