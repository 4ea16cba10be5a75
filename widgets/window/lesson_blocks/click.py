"""The view of a question that is answered by pointing at a place in a picture."""

from collections.abc import Callable

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from app.lessons.blocks.block import Verdict
from app.lessons.blocks.click import Click
from app.lessons.blocks.question import Value
from app.lessons.player import PlayedBlock
from widgets.parts.layouts import FREE
from widgets.window.lesson_blocks.marked import MarkedAnswerView
from widgets.window.lesson_blocks.view import BlockView, button, on_holder

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
            right = self.question.answer(self.played.here)
            self._submit(_written(right), _written(self._place))

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
