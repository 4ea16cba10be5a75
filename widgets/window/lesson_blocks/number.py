"""The view of a question whose answer is a number."""

from PySide6.QtWidgets import QLineEdit, QSizePolicy, QWidget

from app.lessons.blocks.answer import Answer
from app.lessons.blocks.block import Verdict
from app.lessons.player import PlayedBlock
from app.lessons.text import spoken_text
from widgets.parts.layouts import FREE
from widgets.parts.plain import PlainLabel, set_tip
from widgets.window.lesson_blocks.marked import MarkedAnswerView
from widgets.window.lesson_blocks.view import on_holder


class NumberAnswerView(MarkedAnswerView):
    """A question with a typed number."""

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

    def _show(self, typed: str) -> None:
        self.field.setText(typed)

    def _show_verdict(self, verdict: Verdict) -> None:
        if not verdict.right:
            self.field.selectAll()

    def _close(self) -> None:
        self.field.setReadOnly(True)
        self._check.hide()
