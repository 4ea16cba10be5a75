"""What a lesson asks, each in a frame of its own: a prediction, something to do, an answer.

::

    the user commits, or a task is seen done -> block.settled(answer) -> the card keeps it
    "Show it" -> block.show_wanted(document) -> the window

A block is made with the answer of before, if there is one, and then is as it was left.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QEvent, QObject, QRect, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QAccessibleAnnouncementEvent,
    QKeyEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import (
    QButtonGroup,
    QFrame,
    QLineEdit,
    QPushButton,
    QRadioButton,
    QSizePolicy,
    QWidget,
)

from app.document.document import Document
from app.document.view import View
from app.lessons.course import Course, Verdict, idea_named
from app.lessons.lesson import Question, Task
from app.lessons.text import escaped, plain_of
from app.model.refusal import Refusal
from widgets.parts.buttons import push_button
from widgets.parts.icons import paint_icon
from widgets.parts.layouts import FREE, TOP, Part, in_column, in_row
from widgets.parts.lesson_text import LessonText, answer_text
from widgets.parts.messages import sentence
from widgets.parts.plain import Label, set_tip

TRIES = 3
"""After so many the answer is offered."""
DONE, TOLD = "done", "told"
"""What is kept of a task, and of an answer that was given away."""


class Sign(QWidget):
    """An icon beside a text, or an empty box for what is still to be done."""

    def __init__(self, icon: str, said: str) -> None:
        super().__init__()
        self._icon = icon
        self.show_icon(icon, said)
        side = round(1.15 * self.fontMetrics().height())
        self.setFixedSize(side, side)

    def show_icon(self, icon: str, said: str) -> None:
        """Show another one; empty for the box."""
        self._icon = icon
        self.setAccessibleName(said)
        set_tip(self, said)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter, side = QPainter(self), self.fontMetrics().height()
        if self._icon:
            paint_icon(painter, QRect(0, 1, side, side), self._icon)
        else:
            painter.setPen(QPen(self.palette().color(self.foregroundRole()), 1.4))
            painter.drawRect(QRect(2, 3, side - 5, side - 5))
        painter.end()


class Asked(QFrame):
    """What is asked; what is said to it comes below.

    Parameters
    ----------
    course : Course
    place : int
        Of the step.
    part : Question or Task
    answer : str
        Of before; empty for none.
    """

    settled = Signal(str)
    """It is answered: so."""
    show_wanted = Signal(object)
    """A `Document` that shows something of it."""
    spoke = Signal()
    """Something was said to it."""

    def __init__(self, course: Course, place: int, part: Question | Task) -> None:
        super().__init__()
        self.setObjectName("asked")
        self.course, self.place, self.part = course, place, part
        self.answer = ""
        self.hints = list(part.hints)
        """Those that were not given yet."""
        self.setAccessibleName(plain_of(part.text))
        self._column = in_column(on=self, margins=(9, 7, 9, 8), gap=5)
        self.said: list[QWidget] = []
        """What is said to it, from above."""
        self._said = in_column(gap=4)

    @property
    def is_open(self) -> bool:
        """Whether there is something to do yet."""
        return not self.answer

    @property
    def first(self) -> QWidget | None:
        """What the keyboard begins with."""
        return None

    def give_hint(self) -> None:
        """Say the next hint."""
        if self.hints:
            count = len(self.part.hints) - len(self.hints) + 1
            many = len(self.part.hints) > 1
            head = self.tr("Hint {0}:").format(count) if many else self.tr("Hint:")
            text = f"*{head}* {self.hints.pop(0)}"
            self._column.insertWidget(self._column.indexOf(self._said), _row("help", "", text))
            self._announce(text)

    # -- what is said to it

    def _settle(self, answer: str) -> None:
        self.answer = answer
        self.settled.emit(answer)

    def _hush(self) -> None:
        """Take back what was said to the answer before."""
        for widget in self.said:
            self._said.removeWidget(widget)
            widget.hide()
            widget.deleteLater()
        self.said.clear()

    def _say(self, icon: str, sign: str, text: str) -> None:
        if text:
            self._add(_row(icon, sign, text))

    def _add(self, widget: QWidget) -> None:
        self.said.append(widget)
        self._said.addWidget(widget)

    def _offer(self, name: str, tip: str, act: Callable[[], object]) -> QPushButton:
        button = _button(name, tip, act)
        self._add(_on_holder(round(1.4 * self.fontMetrics().height()), button, FREE, gap=0))
        return button

    def _offer_state(self, document: Document | None, name: str, tip: str) -> None:
        if document is not None:
            self._offer(name, tip, partial(self.show_wanted.emit, document))

    def _refute(self, verdict: Verdict, head: str) -> None:
        """Name the wrong idea, say what is against it, and offer what shows it."""
        idea = idea_named(verdict.idea)
        if idea is not None:
            behind = self.tr("The idea behind it: “{0}”.").format(idea.title.rstrip("."))
            head = f"{head} {behind}".strip()
        self._say("close", self.tr("Not so"), head or self.tr("That is not it."))
        if verdict.says:
            self._say("", "", verdict.says)
        self._offer_state(
            verdict.state, self.tr("Sho&w it"), self.tr("Show a state in which it is seen (Alt+W)")
        )
        self._announce(f"{head} {verdict.says}")

    def _announce(self, *texts: str) -> None:
        self.spoke.emit()
        said = plain_of(" ".join(texts))
        QAccessible.updateAccessibility(QAccessibleAnnouncementEvent(self, said))


def _row(icon: str, sign: str, text: str) -> QWidget:
    """A text behind its sign; without one as far to the right."""
    said = LessonText(text)
    indent = round(1.15 * said.fontMetrics().height())
    return _on_holder((Sign(icon, sign), TOP) if icon else indent, (said, 1), gap=4)


def _on_holder(*parts: Part, gap: int) -> QWidget:
    """What stands side by side, as one widget."""
    holder = QWidget()
    in_row(*parts, on=holder, margins=(0, 0, 0, 0), gap=gap)
    return holder


def _button(name: str, tip: str, act: Callable[[], object]) -> QPushButton:
    button = push_button(name, tip, lambda _checked=False: act())
    button.setAutoDefault(True)  # Enter presses it
    button.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
    return button


# --------------------------------------------------------------------------- choices


class _Choice(QWidget):
    """A radio button whose text may hold formulas."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.button = QRadioButton()
        self.button.setAccessibleName(plain_of(text))
        self.button.installEventFilter(self)
        self._text = LessonText(text)
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.NoTextInteraction)
        self._text.viewport().installEventFilter(self)
        self._sign = Sign("", "")
        self._sign.hide()
        parts = (self.button, TOP), (self._text, 1), (self._sign, TOP)
        in_row(*parts, on=self, margins=(3, 2, 3, 2), gap=5)

    def mark(self, icon: str, said: str) -> None:
        """Say that it is the right one, or that it is not."""
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


class Chooses(Asked):
    """Choices: those of a prediction are committed once, those of an answer may be tried again."""

    def __init__(self, course: Course, place: int, part: Question, answer: str = "") -> None:
        super().__init__(course, place, part)
        self.question = part
        self._column.addWidget(LessonText(part.text))
        self._choices = [_Choice(choice.text) for choice in part.choices]
        self._group = QButtonGroup(self)
        for number, choice in enumerate(self._choices):
            self._group.addButton(choice.button, number)
            choice.button.installEventFilter(self)
            self._column.addWidget(choice)
        self._column.addLayout(self._said)
        name = self.tr("&Commit") if part.predicts else self.tr("Chec&k")
        tip = self.tr("This is my prediction (Enter)") if part.predicts else self.tr("Enter")
        self._commit = _button(name, tip, self.commit)
        self._commit.setEnabled(False)
        self._column.addWidget(self._commit)
        self._group.idToggled.connect(self._chosen)
        number = int(answer) - 1 if answer.isdecimal() else -1
        if 0 <= number < len(part.choices):
            self._choices[number].button.setChecked(True)
            self.answer = answer
            self._show_verdict(number, shows=False)

    @property
    def first(self) -> QWidget | None:
        return self._group.checkedButton() or self._choices[0].button

    @property
    def holds(self) -> bool:
        """Whether it is a prediction that must be made before the step goes on."""
        return self.question.predicts and self.is_open

    def _chosen(self, _number: int, _on: bool) -> None:
        self._commit.setEnabled(self.is_open)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            step = _ARROWS.get(event.key(), 0)
            if step:  # Qt would only move the focus while none is chosen
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

    def commit(self) -> None:
        """Take the choice that is made as the answer."""
        number = self._group.checkedId()
        if number < 0:
            self._hush()
            text = self.tr("Choose one first: with the arrow keys, or a click.")
            self._say("warning", "", text)
            self._announce(text)
            return
        right = self.question.choices[number].right
        settles = right or self.question.predicts
        if settles:
            self.answer = str(number + 1)
        self._show_verdict(number, shows=True)
        if settles:
            self.settled.emit(self.answer)

    def _show_verdict(self, number: int, *, shows: bool) -> None:
        question = self.question
        self._hush()
        try:
            verdict = self.course.chosen(self.place, question, number)
            show = question.show and self.course.shown_by(self.place, question.show)
        except Refusal as error:
            self._say("warning", "", sentence(error))
            return
        right = next(place for place, each in enumerate(question.choices) if each.right)
        if not self.is_open:
            for choice in self._choices:
                choice.button.setEnabled(False)
            self._commit.hide()
            self._choices[right].mark("check", self.tr("The model says so"))
        if verdict.right:
            self._say("check", self.tr("Right"), verdict.says or self.tr("Right."))
            self._announce(self.tr("Right."), verdict.says)
            if show is None:
                show = verdict.state
        elif question.predicts:
            self._choices[number].mark("close", self.tr("You said so"))
            said = self.tr("You said {0}; the model says {1}.").format(
                *(_quoted(question.choices[each].text) for each in (number, right))
            )
            self._refute(verdict, said)
            self._say("check", "", question.why)
        else:
            self._refute(verdict, "")
        if show is not None and question.predicts:
            self._offer_state(
                show, self.tr("Show what happens"), self.tr("Show the model's answer once more")
            )
            if shows:
                self.show_wanted.emit(show)


def _quoted(text: str) -> str:
    """A choice inside a sentence: of more than a number one sees where it ends."""
    text = text.rstrip(".")
    return f"“{text}”" if " " in text else text


# --------------------------------------------------------------------------- numbers


class Types(Asked):
    """A number that is typed."""

    def __init__(self, course: Course, place: int, part: Question, answer: str = "") -> None:
        super().__init__(course, place, part)
        self.question = part
        self._tries = 0
        self._column.addWidget(LessonText(part.text))
        self.field = QLineEdit()
        self.field.setAccessibleName(self.tr("Answer: {0}").format(plain_of(part.text)))
        set_tip(
            self.field,
            self.tr("A number: 0.5, 0,5, 1/2, -3 or 2e-3, to three significant digits (Enter)"),
        )
        self.field.setMaxLength(80)
        self.field.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self.field.setMaximumWidth(11 * self.fontMetrics().height())
        self.field.returnPressed.connect(self.check)
        self._check = _button(self.tr("Chec&k"), self.tr("Enter"), self.check)
        unit = [Label(part.unit)] if part.unit else []
        self._column.addWidget(_on_holder((self.field, 1), *unit, self._check, FREE, gap=5))
        self._column.addLayout(self._said)
        if answer:
            self._restore(answer)

    @property
    def first(self) -> QWidget | None:
        return self.field

    def _restore(self, answer: str) -> None:
        try:
            if answer == TOLD:
                self.answer = TOLD
                self._tell()
            elif self._marked(answer).right:
                self.field.setText(answer)
                self.answer = answer
                self._say_right(self._marked(answer))
        except Refusal:  # the lesson is another one now
            self.answer = ""

    def _marked(self, typed: str) -> Verdict:
        return self.course.mark(self.place, self.question, typed)

    def check(self) -> None:
        """Say whether what is typed is right."""
        if not self.is_open:
            return
        typed = self.field.text()
        self._hush()
        try:
            verdict = self._marked(typed)
        except Refusal as error:
            self._say("warning", "", escaped(sentence(error)))
            self._announce(sentence(error))
            return
        if verdict.right:
            self.answer = typed
            self._say_right(verdict)
            self.settled.emit(typed)
            return
        self.field.selectAll()
        if verdict.too_short:
            text = self.tr("So far so good, but three significant digits are needed.")
            self._say("help", self.tr("Too few digits"), text)
            self._announce(text)
            return
        self._tries += 1
        if verdict.idea or verdict.says:
            self._refute(verdict, "")
        else:
            text = self.tr("That is not it.")
            if self.hints:
                text += " " + self.tr("Hint (Alt+I) says how to begin.")
            self._say("close", self.tr("Not so"), text)
            self._announce(text)
        if self._tries >= TRIES:
            tip = self.tr("Say what is right, and why (Alt+A)")
            self._offer(self.tr("Show the &answer"), tip, self._give_away)

    def _say_right(self, verdict: Verdict) -> None:
        self.field.setReadOnly(True)
        self._check.hide()
        self._say("check", self.tr("Right"), verdict.says or self.tr("Right."))
        self._announce(self.tr("Right."), verdict.says)

    def _give_away(self) -> None:
        self._hush()
        try:
            self._tell()
        except Refusal as error:
            self._say("warning", "", escaped(sentence(error)))
        else:
            self._settle(TOLD)

    def _tell(self) -> None:
        answer = answer_text(self.course, self.place, self.question)
        text = self.tr("The answer is {0}.").format(answer)
        self.field.setReadOnly(True)
        self._check.hide()
        self._say("help", "", f"{text} {self.question.why}".strip())
        self._announce(text)


# --------------------------------------------------------------------------- tasks


class Tries(Asked):
    """Something to do in the window, by any way; it ticks itself when it is done."""

    def __init__(self, course: Course, place: int, part: Task, answer: str = "") -> None:
        super().__init__(course, place, part)
        self.task = part
        self._sign = Sign("", self.tr("To do"))
        self._column.addWidget(_on_holder((self._sign, TOP), (LessonText(part.text), 1), gap=4))
        self._column.addLayout(self._said)
        if answer:
            self.answer = DONE
            self._tick()

    def look(self, document: Document, view: View) -> None:
        """See whether it is done in the window as it stands."""
        try:
            is_done = self.course.is_done(self.place, self.task, document, view)
        except Refusal as error:
            self._hush()
            self._say("warning", "", escaped(sentence(error)))
            return
        if is_done:
            self._hush()
            self._tick()
            self._announce(self.tr("Done."), self.task.done)
            self._settle(DONE)

    def _tick(self) -> None:
        self._sign.show_icon("check", self.tr("Done"))
        self._say("", "", self.task.done or self.tr("Done."))


def block_of(course: Course, place: int, part: Question | Task, answer: str) -> Asked:
    """What asks a part of a step."""
    if isinstance(part, Task):
        return Tries(course, place, part, answer)
    return (Chooses if part.choices else Types)(course, place, part, answer)
