"""The frame of a block that requires an answer: text, response and hints.

::

    an answer counts, or a task is seen done -> view.settled(answer) -> the card keeps it
    "Show it" -> view.show_wanted(document) -> the window
    an exercise is drawn -> view.posed(document) -> the window, as the step's own state

`restore` shows a view with an earlier answer as the student left it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QCoreApplication, QRect, Signal
from PySide6.QtGui import QAccessible, QAccessibleAnnouncementEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QFrame, QLineEdit, QPushButton, QSizePolicy, QWidget

from app.document.document import Document
from app.document.view import View
from app.lessons.blocks.block import Asked
from app.lessons.blocks.question import Verdict
from app.lessons.course import AtStep
from app.lessons.practice import verdict_on
from app.lessons.text import escaped, spoken_text
from app.model.refusal import Refusal
from widgets.parts.buttons import push_button
from widgets.parts.icons import paint_icon
from widgets.parts.layouts import FREE, TOP, Part, in_column, in_row
from widgets.parts.lesson_text import LessonText
from widgets.parts.messages import sentence
from widgets.parts.plain import set_tip

REVEALED = "told"
"""Stored as the answer if the program has shown it."""
SIGN_EM = 1.15
"""Size of a sign, relative to the text height beside it."""


class Sign(QWidget):
    """An icon beside a text, or an empty box for something unfinished."""

    def __init__(self, icon: str, said: str) -> None:
        super().__init__()
        self.icon = ""
        self.show_icon(icon, said)
        side = round(SIGN_EM * self.fontMetrics().height())
        self.setFixedSize(side, side)

    def show_icon(self, icon: str, said: str) -> None:
        """Show another icon; empty for the box."""
        self.icon = icon
        self.setAccessibleName(said)
        set_tip(self, said)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter, side = QPainter(self), self.fontMetrics().height()
        if self.icon:
            paint_icon(painter, QRect(0, 1, side, side), self.icon)
        else:
            painter.setPen(QPen(self.palette().color(self.foregroundRole()), 1.4))
            painter.drawRect(QRect(2, 3, side - 5, side - 5))
        painter.end()


class BlockView(QFrame):
    """The frame of a block that requires an answer; the response appears below.

    A subclass adds its own widgets by `_insert`; `sign` is a widget beside the text.
    """

    settled = Signal(str)
    """The block is answered; emits the answer."""
    show_wanted = Signal(object)
    """The user wants to see this `Document`, which explains an answer."""
    posed = Signal(object)
    """The `Document` in which the question is asked, instead of the step's own."""
    tried = Signal(str, str)
    """An answer was given; emits it as in a sample, and the word of its verdict."""
    responded = Signal()
    """A response to the answer appeared."""

    def __init__(self, here: AtStep, block: Asked, *sign: QWidget) -> None:
        super().__init__()
        self.setObjectName("asked")
        self.here, self.block = here, block
        self.answer = ""
        self.is_test = False
        """Whether the answer is kept unmarked, for the end of a test."""
        self.hints = list(block.hints)
        """The hints not given yet."""
        self.hints_read = 0
        self.setAccessibleName(spoken_text(block.text))
        self._responses: list[QWidget] = []
        self._hint: QWidget | None = None
        """The newest hint, until another response comes."""
        self._feedback = in_column(gap=4)
        self._offered: QWidget | None = None
        """The button that shows the right answer, once it is offered."""
        self._words: QWidget = LessonText(block.text)
        if sign:
            self._words = on_holder(*((each, TOP) for each in sign), (self._words, 1), gap=4)
        self._column = in_column(self._words, self._feedback, on=self, margins=(9, 7, 9, 8), gap=5)

    def _insert(self, widget: QWidget) -> None:
        """Add a widget above the response."""
        self._column.insertWidget(self._column.indexOf(self._feedback), widget)

    def set_within(self) -> None:
        """Show the block as a part of another one, which has the frame."""
        self.setObjectName("")
        self._column.setContentsMargins(0, 0, 0, 0)

    @property
    def is_open(self) -> bool:
        """Whether the block is still unanswered."""
        return not self.answer

    @property
    def holds(self) -> bool:
        """Whether the step continues only after an answer."""
        return self.block.holds and self.is_open

    @property
    def hides(self) -> frozenset[str]:
        """Return what must not be seen now, because it would show the answer."""
        return self.block.hides if self.is_open else frozenset()

    @property
    def aims(self) -> BlockView | None:
        """Return the view of a question about a place that is asked, or has just been answered."""
        return None

    @property
    def first(self) -> QWidget | None:
        """Return the widget that gets the focus first."""
        return None

    @property
    def response(self) -> list[QWidget]:
        """Return the widgets of the newest response, from the top."""
        return self._responses if self._hint is None else [self._hint]

    @property
    def variant_seed(self) -> int:
        """Return the number of an exercise's variant; 0 for what is no exercise."""
        return 0

    def begin_test(self) -> None:
        """Give no hints, and keep the first answer for the end of a test."""
        self.is_test = True
        self.hints = []

    def show_kept_answer(self, answer: str) -> None:
        """Show an answer that is kept for the end of a test; it can no longer be changed."""
        self.answer = answer
        self._remove_response()
        self._show(answer)
        for field in self.findChildren(QLineEdit):
            field.setReadOnly(True)
        for each in self.findChildren(QAbstractButton):
            each.setEnabled(False)
            each.setVisible(not isinstance(each, QPushButton))
        # No tick: it may be wrong.
        self._add_text("save", self.tr("Kept"), self.tr("Your answer is kept until the end."))

    def _show(self, answer: str) -> None:
        """Show an answer that was given earlier."""

    def _hand_in(self, answer: str) -> None:
        """Keep an answer for the end of a test."""
        self.tried.emit(answer, verdict_on(self.block, self.here, answer))
        self.show_kept_answer(answer)
        self._speak(self.tr("Your answer is kept until the end."))
        self._settle(answer)

    def open_up(self) -> None:
        """Begin, as the block whose turn it is when its step opens."""

    def restore(self, answer: str) -> None:
        """Show the block as the student left it with an answer."""

    def look(self, document: Document, view: View) -> None:
        """Check how far the window's current state fulfils the block."""

    def give_hint(self) -> None:
        if self.hints:
            self.hints_read += 1
            many = len(self.block.hints) > 1
            head = self.tr("Hint {0}:").format(self.hints_read) if many else self.tr("Hint:")
            text = f"*{head}* {self.hints.pop(0)}"
            self._hint = _row("help", "", text)
            self._insert(self._hint)
            self._speak(text)

    # -- the response

    def _settle(self, answer: str) -> None:
        self.answer = answer
        if self._offered is not None:
            self._offered.hide()
        self.settled.emit(answer)

    def _remove_response(self) -> None:
        for widget in self._responses:
            self._feedback.removeWidget(widget)
            widget.hide()
            widget.deleteLater()
        self._responses.clear()
        self._hint = None

    def _add_text(self, icon: str, sign: str, text: str) -> None:
        if text:
            self._add(_row(icon, sign, text))

    def _show_problem(self, text: str) -> None:
        """Show only that something is missing or wrong."""
        self._remove_response()
        self._add_text("warning", "", text)

    def _refuse(self, error: Refusal) -> None:
        self._show_problem(escaped(sentence(error)))

    def _add(self, widget: QWidget) -> None:
        self._responses.append(widget)
        self._feedback.addWidget(widget)

    def _offer(self, name: str, tip: str, act: Callable[[], object]) -> None:
        self._add(self._indented(button(name, tip, act)))

    def _indented(self, widget: QWidget) -> QWidget:
        return on_holder(round(1.4 * self.fontMetrics().height()), widget, FREE, gap=0)

    def _offer_answer(self, act: Callable[[], object]) -> None:
        """Offer the right answer below every response, until it is known."""
        if self._offered is None and self.is_open:
            tip = self.tr("Show the right answer, and why it is right (Alt+A)")
            self._offered = self._indented(button(self.tr("Show the &answer"), tip, act))
            self._column.addWidget(self._offered)

    def _offer_state(self, document: Document | None, name: str, tip: str) -> None:
        if document is not None:
            self._offer(name, tip, partial(self.show_wanted.emit, document))

    def _praise(self, verdict: Verdict) -> None:
        self._add_text("check", self.tr("Right"), verdict.says or self.tr("Right."))
        self._speak(self.tr("Right."), verdict.says)

    def _refute(self, verdict: Verdict, head: str = "") -> None:
        """Name the wrong idea, refute it, and offer a state that shows why."""
        idea = self.here.idea(verdict.idea)
        if idea is not None:
            behind = self.tr("The idea behind it: “{0}”.").format(idea.title.rstrip("."))
            head = f"{head} {behind}".strip()
        self._add_text("close", self.tr("Wrong"), head or self.tr("That is not it."))
        self._add_text("", "", verdict.says)
        tip = self.tr("Show a state that makes it visible (Alt+W)")
        self._offer_state(verdict.state, self.tr("Sho&w it"), tip)
        tip = self.tr("Show the picture with your number beside that with the model's (Alt+M)")
        self._offer_state(verdict.beside, self.tr("Your idea beside the &model"), tip)
        self._speak(head, verdict.says)

    def _speak(self, *texts: str) -> None:
        self.responded.emit()
        said = spoken_text(" ".join(texts))
        QAccessible.updateAccessibility(QAccessibleAnnouncementEvent(self, said))


def _row(icon: str, sign: str, text: str) -> QWidget:
    """Put a text after its sign; without a sign, keep the same indent."""
    said = LessonText(text)
    indent = round(SIGN_EM * said.fontMetrics().height())
    return on_holder((Sign(icon, sign), TOP) if icon else indent, (said, 1), gap=4)


def on_holder(*parts: Part, gap: int) -> QWidget:
    holder = QWidget()
    in_row(*parts, on=holder, margins=(0, 0, 0, 0), gap=gap)
    return holder


def button(name: str, tip: str, act: Callable[[], object]) -> QPushButton:
    """Make a button that Enter presses and that is as wide as its text."""
    made = push_button(name, tip, lambda _checked=False: act())
    made.setAutoDefault(True)
    made.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
    return made


def hand_in(button: QPushButton) -> None:
    """Name a button for a test, in which an answer is given once."""
    button.setText(QCoreApplication.translate("BlockView", "Hand it &in"))
    tip = QCoreApplication.translate("BlockView", "This is my answer; there is one try (Enter)")
    set_tip(button, tip)
