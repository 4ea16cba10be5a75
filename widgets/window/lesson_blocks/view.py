"""The frame of a block that requires an answer: text, response and hints.

::

    an answer -> PlayedBlock.submit, which marks and keeps it -> view.settled -> the page
    "Show it" -> view.show_wanted(document) -> the window
    an exercise is drawn -> view.posed(document) -> the window, as the step's own state

`restore` shows a block with an earlier answer as the student left it.
"""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QRect, QSize, Signal
from PySide6.QtGui import QAccessible, QAccessibleAnnouncementEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QFrame, QLineEdit, QPushButton, QSizePolicy, QWidget

from app.document.document import Document
from app.lessons.blocks.block import REVEALED, Asked, Verdict
from app.lessons.player import PlayedBlock
from app.lessons.text import escaped, spoken_text
from app.model.refusal import Refusal
from widgets.parts.icons import paint_icon
from widgets.parts.layouts import FREE, TOP, Part, discard, in_column, in_row, push_button
from widgets.parts.lesson_text import LessonText
from widgets.parts.messages import sentence
from widgets.parts.plain import set_tip

SIGN_EM = 1.15  # size of a sign, relative to the text height beside it


class Sign(QWidget):
    """An icon beside a text, or an empty box for something unfinished."""

    def __init__(self, icon: str, said: str) -> None:
        super().__init__()
        self.icon = ""
        self.show_icon(icon, said)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def sizeHint(self) -> QSize:
        side = round(SIGN_EM * self.fontMetrics().height())
        return QSize(side, side)

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

    settled = Signal()  # the block is answered
    show_wanted = Signal(object)  # the user wants to see this `Document`, which explains an answer
    posed = Signal(object)  # the `Document` in which the question is asked, not the step's own
    responded = Signal()  # a response to the answer appeared

    def __init__(self, played: PlayedBlock, question: Asked, *sign: QWidget) -> None:
        super().__init__()
        self.setObjectName("asked")
        self.played = played
        self.setAccessibleName(spoken_text(question.text))
        self._responses: list[QWidget] = []
        self._hint: QWidget | None = None  # the newest hint, until another response comes
        self._feedback = in_column(gap=4)
        self._offered: QWidget | None = None  # the button of the right answer, once it is offered
        self._words: QWidget = LessonText("" if question.varies else question.text)
        if sign:
            self._words = on_holder(*((each, TOP) for each in sign), (self._words, 1), gap=4)
        self._column = in_column(self._words, self._feedback, on=self, margins=(9, 7, 9, 8), gap=5)

    def _answer_button(
        self, act: Callable[[], object], name: str = "", tip: str = ""
    ) -> QPushButton:
        """Make the button that submits an answer; in a test there is one try."""
        if self.played.is_test:
            name = self.tr("Hand it &in")
            tip = self.tr("This is my answer; there is one try (Enter)")
        return button(name or self.tr("Chec&k"), tip or self.tr("Enter"), act)

    def _insert(self, widget: QWidget) -> None:
        """Add a widget above the response."""
        self._column.insertWidget(self._column.indexOf(self._feedback), widget)

    def set_within(self) -> None:
        """Show the block as a part of another one, which has the frame."""
        self.setObjectName("")
        self._column.setContentsMargins(0, 0, 0, 0)

    @property
    def aims(self) -> "BlockView | None":
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

    def show_kept_answer(self) -> None:
        """Show an answer that is kept for the end of a test; it can no longer be changed."""
        self._remove_response()
        self._show(self.played.answer)
        for field in self.findChildren(QLineEdit):
            field.setReadOnly(True)
        for each in self.findChildren(QAbstractButton):
            each.setEnabled(False)
            each.setVisible(not isinstance(each, QPushButton))
        # No tick: it may be wrong.
        self._add_text("save", self.tr("Kept"), self.tr("Your answer is kept until the end."))

    def _show(self, answer: str) -> None:
        """Show an answer that was given earlier."""

    @property
    def typed(self) -> str:
        """Return what is typed or chosen and perhaps not submitted yet."""
        return ""

    def show_draft(self) -> None:
        """Show what was typed before the step was left, and the newest hint."""
        if self.played.typed:
            self._show(self.played.typed)
        if self.played.hints_read:
            self._show_hint()
            self._offer_answer()

    def _handed_in(self) -> None:
        """Show that an answer is kept for the end of a test."""
        self.show_kept_answer()
        self._speak(self.tr("Your answer is kept until the end."))
        self._settled()

    def open_up(self) -> None:
        """Begin, as the block whose turn it is when its step opens."""

    def restore(self) -> None:
        """Show an answered block as the student left it."""
        if self.played.answer == REVEALED:
            self._show_right_answer()
        else:
            self._restore(self.played.answer)

    def _restore(self, answer: str) -> None:
        """Show an answer of the student, and the response to it."""

    def look(self, now: Document) -> None:
        """Check how far the window's current state fulfils the block."""

    def give_hint(self) -> None:
        if self.played.give_hint():
            self._speak(self._show_hint())
        self._offer_answer()

    def _show_hint(self) -> str:
        """Show the newest hint; return its text."""
        hints, read = self.played.question.hints, self.played.hints_read
        head = self.tr("Hint {0}:").format(read) if len(hints) > 1 else self.tr("Hint:")
        text = f"*{head}* {hints[read - 1]}"
        self._hint = _row("help", "", text)
        self._insert(self._hint)
        return text

    def reveal_answer(self) -> None:
        self._remove_response()
        try:
            said = self._show_right_answer()
        except Refusal as error:
            self._refuse(error)
            return
        self._speak(*said)
        self.played.reveal_answer()
        self._settled()

    def _show_right_answer(self) -> list[str]:
        """Show the right answer, and the way to it; return the texts.

        A view around another one leaves that to it.
        """
        return []

    # -- the response

    def _add_right_answer(self, answer: str) -> list[str]:
        """Show a sentence with the right answer, the reason and the solution; return the texts."""
        question = self.played.question
        texts = [f"{answer} {question.why}".strip(), question.solution(self.played.here)]
        for icon, text in zip(("help", ""), texts, strict=True):
            self._add_text(icon, "", text)
        return texts

    def _settled(self) -> None:
        if self._offered is not None:
            self._offered.hide()
        self.settled.emit()

    def _remove_response(self) -> None:
        discard(self._feedback, self._responses)
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

    def _indented(self, widget: QWidget) -> QWidget:
        return on_holder(round(1.4 * self.fontMetrics().height()), widget, FREE, gap=0)

    def _offer_answer(self) -> None:
        """Offer the right answer below every response, until it is known."""
        played = self.played
        if self._offered is None and played.is_open and played.question.can_be_revealed:
            tip = self.tr("Show the right answer, and why it is right (Alt+A)")
            answer = button(self.tr("Show the &answer"), tip, self.reveal_answer)
            self._offered = self._indented(answer)
            self._column.addWidget(self._offered)

    def _offer_state(self, document: Document | None, name: str, tip: str) -> None:
        if document is not None:
            show = partial(self.show_wanted.emit, document)
            self._add(self._indented(button(name, tip, show)))

    def _praise(self, verdict: Verdict) -> None:
        self._add_text("check", self.tr("Right"), verdict.says or self.tr("Right."))
        self._speak(self.tr("Right."), verdict.says)

    def _refute(self, verdict: Verdict, head: str = "", seen: Document | None = None) -> None:
        """Name the wrong idea, refute it, and offer a state that shows why.

        What the window shows already is not offered: `seen`, or else the step's state.
        """
        state, seen = verdict.state, seen or self.played.here.document
        if state is not None and (state, state.view) == (seen, seen.view):
            state = None
        if verdict.title:
            behind = self.tr("The idea behind it: “{0}”.").format(verdict.title)
            head = f"{head} {behind}".strip()
        self._add_text("close", self.tr("Wrong"), head or self.tr("That is not it."))
        says = f"{sentence(verdict.remark) if verdict.remark else ''} {verdict.says}".strip()
        self._add_text("", "", says)
        tip = self.tr("Show a state that makes it visible (Alt+W)")
        self._offer_state(state, self.tr("Sho&w it"), tip)
        tip = self.tr("Show the picture with your number beside that with the model's (Alt+M)")
        self._offer_state(verdict.beside, self.tr("Your idea beside the &model"), tip)
        self._speak(head, says)

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
