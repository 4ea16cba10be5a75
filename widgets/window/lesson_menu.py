"""The Lessons menu: the lessons and talks to open, and the steps of the open one."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QFileDialog, QMenu, QWidget

from app.lessons.course import name_of
from app.lessons.player import Progress
from widgets.window.lesson_card import AGAIN_KEY, BACK_KEY, NEXT_KEY, TOUR, LessonCard, heads
from widgets.window.practice import Practice, review_text
from widgets.window.settings import Settings


def fill(
    menu: QMenu, progress: Mapping[str, Progress], choose: Callable[[str], object], *, talks: bool
) -> None:
    """List the built-in lessons or talks with the user's progress; `choose` receives a path."""
    menu.clear()
    for head in heads(talks=talks):
        kept = progress.get(name_of(head.path), Progress())
        text = " ".join((*head.topics[:1], head.title)).replace("&", "&&")
        if kept.of and kept.done == kept.of:
            text += "\t" + QCoreApplication.translate("LessonMenu", "done")
        elif kept.done:
            text += f"\t{kept.done}/{kept.of}"
        action = menu.addAction(text)
        action.triggered.connect(lambda _on=False, path=head.path: choose(str(path)))


class LessonMenu(QMenu):
    """The menu of the menu bar; `make` creates an action of the window, as `Actions` does."""

    def __init__(self, title: str, window: QWidget, make: Callable[..., QAction]) -> None:
        super().__init__(title, window)
        self._window = window
        self.tour = make(self.tr("Two-minute &tour"))
        self.addAction(self.tour)
        self.lessons = self.addMenu(self.tr("&Lessons"))
        self.talks = self.addMenu(self.tr("T&alks"))
        self.addSeparator()
        self.test = make(
            self.tr("Test &yourself…"), None, None,
            self.tr("Exercises of topics that you choose, without help"),
        )  # fmt: skip
        self.test_again = make(self.tr("Go on with the t&est"))
        self.review = make(
            self.tr("&Review"), None, None,
            self.tr("What you did not solve alone comes back after 1, 3 and 7 days"),
        )  # fmt: skip
        self.overview = make(
            self.tr("O&verview…"), None, None,
            self.tr("Every topic with its exercises, as you solved them"),
        )  # fmt: skip
        self.addActions([self.test, self.test_again, self.review, self.overview])
        self.addSeparator()
        self.open = make(
            self.tr("&Open a lesson…"), None, None, self.tr("Open a lesson or a talk from its file")
        )
        self.addAction(self.open)
        self.addSeparator()
        self.again = make(
            self.tr("&Show the step again"), None, AGAIN_KEY,
            self.tr("Show the step as the lesson's file has it, without your changes"),
        )  # fmt: skip
        self.next = make(self.tr("&Next step"), None, NEXT_KEY)
        self.back = make(self.tr("&Previous step"), None, BACK_KEY)
        self.hint = make(self.tr("&Hint"))
        self.anew = make(self.tr("Begin the lesson a&gain"))
        self.check = make(
            self.tr("Chec&k the lesson"), None, None, self.tr("Try everything in the lesson's file")
        )
        self.leave = make(self.tr("&Close the lesson"))
        self.addActions([self.again, self.next, self.back, self.hint])
        self.addSeparator()
        self.addActions([self.anew, self.check, self.leave])

    def wire(self, card: LessonCard, settings: Settings, practice: Practice) -> None:
        """Connect the actions to the lesson's card and to what is practised on it."""
        self.aboutToShow.connect(partial(self._show_practice, practice))
        for menu, talks in ((self.lessons, False), (self.talks, True)):
            menu.aboutToShow.connect(
                lambda menu=menu, talks=talks: fill(menu, settings.progress, card.open, talks=talks)
            )
        for action, act in (
            (self.tour, partial(card.open, TOUR)),
            (self.open, partial(self._ask, card)),
            (self.test, practice.choose_test),
            (self.test_again, practice.go_on),
            (self.review, practice.review),
            (self.overview, practice.show_overview),
            (self.check, card.check),
            (self.leave, card.leave),
            *((action, button.click) for action, button in self._buttons(card)),
        ):
            action.triggered.connect(lambda _on=False, act=act: act())
        card.buttons_changed.connect(partial(self._show, card))
        self._show(card)

    def _show_practice(self, practice: Practice) -> None:
        """Name the exercises that have come back, and a test that waits."""
        self.review.setText(review_text(practice.waiting))
        self.test_again.setVisible(bool(practice.begun))

    def _show(self, card: LessonCard) -> None:
        """Enable the actions that are possible now."""
        for action, button in (*self._buttons(card), (self.check, card.anew)):
            action.setEnabled(card.is_on and button.isEnabled())
        self.leave.setEnabled(card.is_on)

    def _buttons(self, card: LessonCard) -> Sequence[tuple[QAction, QAbstractButton]]:
        """Return the actions that press a button of the card."""
        return (
            (self.again, card.again), (self.next, card.next), (self.back, card.back),
            (self.hint, card.hint), (self.anew, card.anew),
        )  # fmt: skip

    def _ask(self, card: LessonCard) -> None:
        title = self.tr("Open a lesson or a talk")
        kinds = self.tr("Lessons and talks (*.md);;All files (*)")
        path, _ = QFileDialog.getOpenFileName(self._window, title, "", kinds)
        if path:
            card.open(Path(path))
