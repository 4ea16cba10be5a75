"""Write the window's state as a step of a lesson's file, or as the first step of a new talk."""

import os
from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QCheckBox, QDialog, QDialogButtonBox, QLineEdit, QMainWindow, QWidget

from app.document.store import Store
from app.lessons.lesson import Lesson
from app.lessons.writing import add_step, begin_talk
from app.model.refusal import Refusal
from widgets.parts.layouts import dialog_buttons, in_column
from widgets.parts.messages import MessageBar, sentence
from widgets.parts.plain import PlainLabel, set_tip
from widgets.parts.saving import ask_where
from widgets.window.lessons import Lessons

MESSAGE_MS = 3000


class TalkWriter(QObject):
    def __init__(
        self, window: QMainWindow, lessons: Lessons, store: Store, messages: MessageBar
    ) -> None:
        super().__init__(window)
        self._window, self._lessons = window, lessons
        self._store, self._messages = store, messages

    def add_state(self) -> None:
        """Ask for a title, and write the current state into the open file as a new step."""
        lesson = self._lessons.lesson
        if lesson is not None and not self._is_gone(lesson):
            title = self._ask_title(self.tr("Add this state as a step"), "")
            if title is not None:
                self.write_step(*title)

    def _is_gone(self, lesson: Lesson) -> bool:
        """Say that the file is missing, if it is."""
        if os.path.exists(lesson.path):
            return False
        text = self.tr(
            "{0} is not in its folder any more, and no step was added: put the file back, or"
            " choose “A new talk from here” in the Lessons menu."
        )
        self._messages.show_message(text.format(lesson.path.name))
        return True

    def write_step(self, title: str, panes: bool) -> bool:
        """Write the current state into the open file as a new step; return False if that fails."""
        player = self._lessons.player
        assert player is not None
        path = player.lesson.path
        if self._is_gone(player.lesson):
            return False
        try:
            added = add_step(path, player.step.name, title, self._store.seen, panes=panes)
        except Refusal as error:
            self._messages.show_message(sentence(error))
            return False
        self._messages.done()
        self._lessons.read_again(added.name)
        text = self.tr("Added as step {0} of {1}").format(added.place + 1, path.name)
        self._window.statusBar().showMessage(text, MESSAGE_MS)
        return True

    def begin_new(self) -> None:
        """Ask for a file, and begin a talk there with the current state."""
        kinds, name = self.tr("Talks and lessons (*.md)"), self.tr("A new talk from here")
        path = ask_where(self._window, name, "talk.md", kinds, ".md")
        title = self._ask_title(name, Path(path).stem) if path else None
        if title is not None:
            self.write_talk(Path(path), *title)

    def write_talk(self, path: Path, title: str, panes: bool) -> bool:
        """Begin a talk with the current state, and open it; return False if that fails."""
        try:
            begin_talk(path, title, self._store.seen, panes=panes)
        except Refusal as error:
            self._messages.show_message(sentence(error))
            return False
        return self._lessons.open(path)

    def _ask_title(self, name: str, title: str) -> tuple[str, bool] | None:
        dialog = TitleDialog(name, title, bool(self._store.seen.view.panes), self._window)
        if dialog.exec() != QDialog.DialogCode.Accepted:
            return None
        return dialog.field.text(), dialog.panes.isChecked()


class TitleDialog(QDialog):
    """A dialog for the title of a step, and for keeping turned panes if there are any."""

    def __init__(self, name: str, title: str, turned: bool, parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle(name)
        label = PlainLabel(self.tr("&Title of the step"))
        self.field = QLineEdit(title)
        self.field.setMinimumWidth(24 * self.fontMetrics().averageCharWidth())
        label.setBuddy(self.field)
        self.panes = QCheckBox(self.tr("Keep the &panes turned as they are"))
        set_tip(self.panes, self.tr("The state is then a document beside the file"))
        self.panes.setVisible(turned)
        buttons = dialog_buttons(self, QDialogButtonBox.StandardButton.Ok)
        in_column(label, self.field, self.panes, buttons, on=self)
        ok = buttons.button(QDialogButtonBox.StandardButton.Ok)
        ok.setEnabled(bool(title.strip()))
        self.field.textChanged.connect(lambda text: ok.setEnabled(bool(text.strip())))
