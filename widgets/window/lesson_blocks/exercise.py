"""The view of an exercise: its seed, "Another one", and the view of the question it becomes."""

from collections.abc import Callable

from PySide6.QtGui import QIntValidator
from PySide6.QtWidgets import QLineEdit, QWidget

from app.document.document import Document
from app.lessons.blocks.block import Asked
from app.lessons.blocks.exercise import LARGEST_SEED, Exercise
from app.lessons.player import PlayedBlock
from app.model.refusal import Refusal
from widgets.parts.layouts import FREE, discard
from widgets.parts.plain import PlainLabel, set_tip
from widgets.window.lesson_blocks.view import BlockView, button, on_holder

ViewOf = Callable[[PlayedBlock, Asked], BlockView]


class ExerciseView(BlockView):
    """An exercise, around the view of its question with the numbers of a seed."""

    def __init__(self, played: PlayedBlock, exercise: Exercise, view_of: ViewOf) -> None:
        super().__init__(played, exercise)
        self._words.hide()  # each variant has its own
        self._view_of = view_of
        self.asked: BlockView | None = None
        """The view of the question with its numbers; None before the student begins."""
        self.seed = QLineEdit(str(played.seed or 1))
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
        title = PlainLabel(self.tr("Exercise"), objectName="paneTitle")
        row = on_holder(
            PlainLabel(self.tr("Variant")), self.seed, self._begin, self._another, gap=5
        )
        row.setHidden(played.is_test)
        self._insert(on_holder(title, FREE, row, gap=5))
        if played.variant is not None:
            self._show_variant()

    @property
    def first(self) -> QWidget | None:
        return self._begin if self.asked is None else self.asked.first

    @property
    def aims(self) -> BlockView | None:
        return None if self.asked is None else self.asked.aims

    @property
    def response(self) -> list[QWidget]:
        if self.asked is None:
            return super().response
        return self.asked.response or [self.asked]

    def restore(self) -> None:
        if self.asked is not None and self.played.is_test:
            self.asked.show_kept_answer()
        elif self.asked is not None:
            self.asked.restore()

    @property
    def typed(self) -> str:
        return "" if self.asked is None else self.asked.typed

    def show_draft(self) -> None:
        if self.asked is not None:
            self.asked.show_draft()

    def open_up(self) -> None:
        """Show the state of the numbers; draw them first if they are not drawn yet."""
        if self.played.is_test:  # its step is in this state, with the panels closed
            if self.played.is_open:
                self.responded.emit()
        elif self.asked is not None or self._draw():
            self.posed.emit(self.played.here.document)
            if self.played.is_open and self.first is not None:
                self.responded.emit()

    def begin(self) -> None:
        """Draw the numbers of the seed, and show their state."""
        if self._draw():
            self.posed.emit(self.played.here.document)
            if self.first is not None:
                self.first.setFocus()
            self.responded.emit()

    def go_on(self) -> None:
        """Draw the numbers of the next seed."""
        self.seed.setText(str(int(self.seed.text() or "0") % LARGEST_SEED + 1))
        self.begin()

    def _draw(self) -> bool:
        """Draw the numbers of the seed; say why if there are none."""
        self._remove_response()
        try:
            self.played.draw(max(1, int(self.seed.text() or "1")))
        except Refusal as error:
            self._refuse(error)
            return False
        self._show_variant()
        return True

    def _show_variant(self) -> None:
        asked = self._view_of(self.played, self.played.question)
        asked.settled.connect(self.settled)
        asked.show_wanted.connect(self.show_wanted)
        asked.responded.connect(self.responded)
        asked.set_within()
        if self.asked is not None:
            discard(self._column, [self.asked])
        self.asked = asked
        self._insert(asked)
        self._begin.hide()
        self._another.show()

    def give_hint(self) -> None:
        if self.asked is not None:
            self.asked.give_hint()

    def look(self, now: Document) -> None:
        if self.asked is not None:
            self.asked.look(now)
