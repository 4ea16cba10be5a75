"""Unsaved work: copied to disk while the window lives, offered by the next window if it dies.

::

    an edit --> Autosave, a copy on disk --the program dies--> offer --> recovered or discarded
    another document is opened --> its own Autosave --the window is closed--^
"""

import os
from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QFileInfo, QLocale, QObject

from app.document.files import read
from app.document.store import Origin, Store
from app.model.refusal import Refusal
from widgets.parts.message_bar import MessageBar
from widgets.parts.messages import sentence
from widgets.window.autosave import Autosave
from widgets.window.files import Files


class Recovery(QObject):
    """Keeps copies of the store's unsaved documents, and offers those that other windows left.

    A document that was replaced by opening another one keeps its copy. `folder` is the user's data
    folder.
    """

    def __init__(
        self, folder: Path, store: Store, messages: MessageBar, files: Files, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._folder, self._store = folder, store
        self._messages, self._files = messages, files
        self._copies: dict[Origin, Autosave] = {}
        store.leaving.connect(self._leave)

    @property
    def autosave(self) -> Autosave:
        """The copy of the current document."""
        origin, store = self._store.origin, self._store
        if origin not in self._copies:
            copy = Autosave(self._folder, lambda: store.seen if store.modified else None, self)
            copy.failed.connect(self._show_no_copy)
            self._copies[origin] = copy
        return self._copies[origin]

    def _leave(self) -> None:
        """Keep unsaved work when another document comes: undo or the next window restores it."""
        if not self.autosave.leave():
            self.autosave.close()
            self._copies.pop(self._store.origin).deleteLater()

    def close(self) -> None:
        """Close with the window: keep the copies of all documents except the current one."""
        self.autosave.close()
        for origin, copy in self._copies.items():
            if origin is not self._store.origin:
                copy.release()

    def offer(self) -> None:
        """Offer to recover the unsaved work of a window that died, if there is any."""
        orphans = self.autosave.orphans()
        if orphans:
            newest = orphans[0]
            time = QFileInfo(newest).lastModified()
            written = QLocale().toString(time, QLocale.FormatType.ShortFormat)
            text = self.tr("There is unsaved work from {0}.").format(written)
            self._messages.show_message(text, *self._choices(newest))

    def _choices(self, path: Path) -> tuple[tuple[str, Callable[[], object]], ...]:
        return (
            (self.tr("Recover it"), partial(self._recover, path)),
            (self.tr("Discard it"), partial(self._discard, path)),
        )

    def _recover(self, path: Path) -> None:
        try:
            document = read(path)
        except Refusal as error:
            is_left = os.path.exists(path)  # or another window has it
            choices = self._choices(path) if is_left else ()
            self._messages.show_message(sentence(error), *choices)
            return
        if self._files.open_recovered(document):
            if self.autosave.save_now():  # until then the old copy is the only one
                self._discard(path)
            else:
                text = self.tr("The recovered work cannot be kept in {0}: save it soon.")
                self._messages.show_message(text.format(path.parent))
        elif self._messages.text:  # its mesh is missing, perhaps only for now
            self._messages.show_message(self._messages.text, *self._choices(path))
        else:
            self.offer()

    def _discard(self, path: Path) -> None:
        try:
            path.unlink(missing_ok=True)
        except OSError as error:
            text = self.tr("{0} could not be removed: {1}.")
            self._messages.show_message(text.format(path, error.strerror or error))
            return
        self.offer()

    def _show_no_copy(self, folder: str) -> None:
        text = self.tr("No copy of unsaved work can be kept in {0}: save it soon.")
        self._messages.show_message(text.format(folder))
