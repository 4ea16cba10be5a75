"""The view of a question with choices."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QButtonGroup, QRadioButton, QWidget

from app.lessons.blocks.choices import Choices
from app.lessons.course import AtStep
from app.lessons.record import SHOWN
from app.lessons.text import spoken_text
from app.model.refusal import Refusal
from widgets.parts.layouts import TOP, in_row
from widgets.parts.lesson_text import LessonText
from widgets.window.lesson_blocks.view import REVEALED, BlockView, Sign, button, hand_in


class _ChoiceButton(QWidget):
    """A radio button whose text may hold formulas."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.button = QRadioButton()
        self.button.setAccessibleName(spoken_text(text))
        self.button.installEventFilter(self)
        self._text = LessonText(text)
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.NoTextInteraction)
        self._text.viewport().installEventFilter(self)
        self._sign = Sign("", "")
        self._sign.hide()
        parts = (self.button, TOP), (self._text, 1), (self._sign, TOP)
        in_row(*parts, on=self, margins=(3, 2, 3, 2), gap=5)

    def mark(self, icon: str, said: str) -> None:
        """Mark it as the right choice, or as the student's choice."""
        self._sign.show_icon(icon, said)
        self._sign.show()
        self.button.setAccessibleDescription(said)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if watched is self.button and kind in (QEvent.Type.FocusIn, QEvent.Type.FocusOut):
            self.update()
        elif kind == QEvent.Type.MouseButtonPress and watched is not self.button:
            if self.button.isEnabled():
                self.button.setFocus(Qt.FocusReason.MouseFocusReason)
                self.button.click()
            return True
        return super().eventFilter(watched, event)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.button.hasFocus():
            painter = QPainter(self)
            painter.setPen(QPen(self.palette().highlight().color(), 1))
            painter.drawRoundedRect(self.rect().adjusted(0, 0, -1, -1), 3, 3)
            painter.end()


_ARROWS: dict[int, int] = {
    Qt.Key.Key_Down: 1,
    Qt.Key.Key_Right: 1,
    Qt.Key.Key_Up: -1,
    Qt.Key.Key_Left: -1,
}


class ChoiceView(BlockView):
    """The choices of a question: a prediction is made once; an answer may be repeated."""

    def __init__(self, here: AtStep, question: Choices) -> None:
        super().__init__(here, question)
        self.question = question
        self._choices = [_ChoiceButton(choice.text) for choice in question.replies]
        self._group = QButtonGroup(self)
        for number, choice in enumerate(self._choices):
            self._group.addButton(choice.button, number)
            choice.button.installEventFilter(self)
            self._insert(choice)
        name, tip = self.tr("Chec&k"), self.tr("Enter")
        if not question.retries:
            name, tip = self.tr("&Commit"), self.tr("This is my prediction (Enter)")
        self._commit = button(name, tip, self.commit)
        self._commit.setEnabled(False)
        self._column.addWidget(self._commit)
        self._group.idToggled.connect(lambda *_: self._commit.setEnabled(self.is_open))

    @property
    def first(self) -> QWidget | None:
        return self._group.checkedButton() or self._choices[0].button

    def _show(self, answer: str) -> None:
        number = self._number(answer)
        if number is not None:
            self._choices[number].button.setChecked(True)

    def _number(self, answer: str) -> int | None:
        """Return the choice, from 0, that an answer names; a kept one may be anything."""
        names = [str(number) for number, _ in enumerate(self._choices, 1)]
        return names.index(answer) if answer in names else None

    def restore(self, answer: str) -> None:
        if answer == REVEALED and self.question.retries:
            self.answer = REVEALED
            self._show_right_answer()
            return
        number = self._number(answer)
        if number is not None:
            self._choices[number].button.setChecked(True)
            self.answer = answer
            self._show_verdict(number, shows=False)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            step = _ARROWS.get(event.key(), 0)
            if step:  # Qt would only move the focus if nothing is chosen
                buttons = self._group.buttons()
                at = next(at for at, button in enumerate(buttons) if button is watched)
                there = buttons[(at + step) % len(buttons)]
                there.setChecked(True)
                there.setFocus(Qt.FocusReason.OtherFocusReason)
                return True
        return super().eventFilter(watched, event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.is_open:
            self.commit()
        else:
            super().keyPressEvent(event)

    def begin_test(self) -> None:
        super().begin_test()
        hand_in(self._commit)

    def commit(self) -> None:
        """Submit the current choice as the answer."""
        number = self._group.checkedId()
        if number < 0:
            text = self.tr("Choose one first: with the arrow keys, or a click.")
            self._show_problem(text)
            self._speak(text)
            return
        if self.is_test:
            self._hand_in(str(number + 1))
            return
        settles = number == self.question.right or not self.question.retries
        if settles:
            self.answer = str(number + 1)
        self._show_verdict(number, shows=True)
        if settles:
            self._settle(self.answer)

    def give_hint(self) -> None:
        super().give_hint()
        if self.question.retries:
            self._offer_answer(self.reveal_answer)

    def reveal_answer(self) -> None:
        """Show the right choice, and why it is right."""
        self.answer = REVEALED
        self._show_right_answer()
        self.tried.emit("", SHOWN)
        self._settle(REVEALED)

    def _show_right_answer(self) -> None:
        text = self.question.replies[self.question.right].text
        self._remove_response()
        self._close()
        said = self.tr("The answer is {0}.").format(_quoted(text))
        said = f"{said} {self.question.why}".strip()
        solution = self.question.solution(self.here)
        self._add_text("help", "", said)
        self._add_text("", "", solution)
        self._speak(said, solution)

    def _close(self) -> None:
        for choice in self._choices:
            choice.button.setEnabled(False)
        self._commit.hide()
        self._choices[self.question.right].mark("check", self.tr("The model's answer"))

    def _show_verdict(self, number: int, *, shows: bool) -> None:
        question, right = self.question, self.question.right
        self._remove_response()
        try:
            verdict = question.chosen(self.here, number)
            show = question.show and self.here.shown_by(question.show)
        except Refusal as error:
            self._refuse(error)
            return
        if shows:
            self.tried.emit(str(number + 1), verdict.word)
        if not self.is_open:
            self._close()
        if verdict.right:
            self._praise(verdict)
            if self.here.given:  # the numbers of an exercise
                self._add_text("", "", question.solution(self.here))
            show = show or verdict.state
        elif question.retries:
            self._offer_answer(self.reveal_answer)
            self._refute(verdict)
        else:
            self._choices[number].mark("close", self.tr("Your choice"))
            said = self.tr("You said {0}; the model says {1}.").format(
                *(_quoted(question.replies[each].text) for each in (number, right))
            )
            self._refute(verdict, said)
            self._add_text("check", "", question.why)
        if show is not None and not question.retries:
            self._offer_state(
                show, self.tr("Show what happens"), self.tr("Show the model's answer once more")
            )
            if shows:
                self.show_wanted.emit(show)


def _quoted(text: str) -> str:
    """Quote a choice within a sentence, unless it is a number."""
    text = text.rstrip(".")
    return f"“{text}”" if " " in text else text
