"""The view of a question with choices."""

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QButtonGroup, QRadioButton, QWidget

from app.languages import of_lessons, quoted
from app.lessons.blocks.block import Verdict
from app.lessons.blocks.choices import Choices
from app.lessons.player import PlayedBlock
from app.lessons.text import spoken_text
from app.model.refusal import Refusal
from widgets.panes.canvas import ARROWS
from widgets.parts.layouts import TOP, in_row
from widgets.parts.lesson_text import LessonText
from widgets.window.lesson_blocks.view import BlockView, Sign


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
            with QPainter(self) as painter:
                painter.setPen(QPen(self.palette().highlight().color(), 1))
                painter.drawRoundedRect(self.rect().adjusted(0, 0, -1, -1), 3, 3)


class ChoiceView(BlockView):
    """The choices of a question: a prediction is made once; an answer may be repeated."""

    def __init__(self, played: PlayedBlock, question: Choices) -> None:
        super().__init__(played, question)
        self.question = question
        self._choices = [_ChoiceButton(choice.text) for choice in question.replies]
        self._group = QButtonGroup(self)
        for number, choice in enumerate(self._choices):
            self._group.addButton(choice.button, number)
            choice.button.installEventFilter(self)
            self._insert(choice)
        name, tip = "", ""
        if not question.retries:
            name, tip = self.tr("&Commit"), self.tr("This is my prediction (Enter)")
        self._commit = self._answer_button(self.commit, name, tip)
        self._commit.setEnabled(False)
        self._column.addWidget(self._commit)
        self._group.idToggled.connect(lambda *_: self._commit.setEnabled(played.is_open))

    @property
    def first(self) -> QWidget | None:
        return self._group.checkedButton() or self._choices[0].button

    def _show(self, answer: str) -> None:
        for number, choice in enumerate(self._choices, 1):  # a kept answer may be anything
            if answer == str(number):
                choice.button.setChecked(True)

    @property
    def typed(self) -> str:
        return str(self._group.checkedId() + 1 or "")

    def _restore(self, answer: str) -> None:
        self._show(answer)
        try:
            verdict = self.question.mark(self.played.here, answer)
            self._show_verdict(int(answer) - 1, verdict, shows=False)
        except Refusal as error:
            self._refuse(error)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        is_pressed = event.type() == QEvent.Type.KeyPress
        if is_pressed and isinstance(event, QKeyEvent) and event.key() in ARROWS:
            # Qt would only move the focus if nothing is chosen.
            step = int(sum(ARROWS[Qt.Key(event.key())]))
            buttons = self._group.buttons()
            at = next(at for at, button in enumerate(buttons) if button is watched)
            there = buttons[(at + step) % len(buttons)]
            there.setChecked(True)
            there.setFocus(Qt.FocusReason.OtherFocusReason)
            return True
        return super().eventFilter(watched, event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.played.is_open:
            self.commit()
        else:
            super().keyPressEvent(event)

    def commit(self) -> None:
        """Submit the current choice as the answer."""
        number = self._group.checkedId()
        if number < 0:
            text = self.tr("Choose one first: with the arrow keys, or a click.")
            self._show_problem(text)
            self._speak(text)
            return
        self._remove_response()
        try:
            verdict = self.played.submit(str(number + 1))
            if self.played.is_test:
                self._handed_in()
                return
            self._show_verdict(number, verdict, shows=True)
        except Refusal as error:
            self._refuse(error)
        if not self.played.is_open:
            self._settled()

    def _show_right_answer(self) -> list[str]:
        text = self.question.replies[self.question.right].text
        self._close()
        return self._add_right_answer(self.tr("The answer is {0}.").format(_quoted(text)))

    def _close(self) -> None:
        for choice in self._choices:
            choice.button.setEnabled(False)
        self._commit.hide()
        self._choices[self.question.right].mark("check", self.tr("The model's answer"))

    def _show_verdict(self, number: int, verdict: Verdict, *, shows: bool) -> None:
        """Respond to a choice; `shows` tells whether the window also shows what happens."""
        question, here, right = self.question, self.played.here, self.question.right
        show = question.show and here.shown_by(question.show)
        if not self.played.is_open:
            self._close()
        if verdict.right:
            self._praise(verdict)
            if here.given:  # the numbers of an exercise
                self._add_text("", "", question.solution(here))
            show = show or verdict.state
        elif question.retries:
            self._offer_answer()
            self._refute(verdict)
        else:
            self._choices[number].mark("close", self.tr("Your choice"))
            said = self.tr("You said {0}; the model says {1}.").format(
                *(_quoted(question.replies[each].text) for each in (number, right))
            )
            self._refute(verdict, said, show)
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
    return quoted(text, of_lessons()) if " " in text else text
