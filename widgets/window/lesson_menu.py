"""The Lessons menu: the lessons and talks to open, and the steps of the open one."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QFileDialog, QMenu, QWidget

from app.lessons.course import name_of
from app.lessons.player import Progress
from widgets.window.lesson_card import TOUR, LessonCard, heads
from widgets.window.practice import Practice, review_text
from widgets.window.settings import Settings
from widgets.window.talks import Talks


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
    """The menu of the menu bar; `make` and `submenu` make what its content file names."""

    def __init__(
        self, window: QWidget, make: Callable[..., QAction], submenu: Callable[[str], QMenu]
    ) -> None:
        super().__init__(window)
        self._window = window
        self.tour, self.open = make("tour"), make("open_lesson")
        self.lessons, self.talks = submenu("courses"), submenu("talks")
        self.test, self.test_again = make("test"), make("test_again")
        self.review, self.overview = make("review"), make("overview")
        self.again, self.next, self.back = make("again"), make("next"), make("back")
        self.hint, self.anew = make("hint"), make("anew")
        self.check, self.leave = make("check"), make("leave")
        self.speaker, self.with_talk = make("speaker"), make("with_talk", on=True)
        self.add_step, self.begin_talk = make("add_step"), make("begin_talk")

    def wire(self, card: LessonCard, settings: Settings, practice: Practice, talks: Talks) -> None:
        """Connect the actions to the lesson's card, to what is practised on it, and to a talk."""
        self.aboutToShow.connect(partial(self._show_practice, practice))
        for menu, are in ((self.lessons, False), (self.talks, True)):
            menu.aboutToShow.connect(
                lambda menu=menu, are=are: fill(menu, settings.progress, card.open, talks=are)
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
            (self.speaker, talks.open_speaker),
            (self.add_step, talks.writer.add_state),
            (self.begin_talk, talks.writer.begin_new),
            *((action, button.click) for action, button in self._buttons(card)),
        ):
            action.triggered.connect(lambda _on=False, act=act: act())
        self.with_talk.setChecked(settings.speaker_window)
        self.with_talk.toggled.connect(partial(setattr, settings, "speaker_window"))
        card.buttons_changed.connect(partial(self._show, card, talks))
        self._show(card, talks)

    def _show_practice(self, practice: Practice) -> None:
        """Name the exercises that have come back, and a test that waits."""
        self.review.setText(review_text(practice.waiting))
        self.test_again.setVisible(bool(practice.begun))

    def _show(self, card: LessonCard, talks: Talks) -> None:
        """Enable the actions that are possible now."""
        for action, button in (*self._buttons(card), (self.check, card.anew)):
            action.setEnabled(card.is_on and button.isEnabled())
        self.leave.setEnabled(card.is_on)
        for action in (self.speaker, self.add_step):
            action.setEnabled(talks.has_lesson)

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
