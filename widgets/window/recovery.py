"""Unsaved work after a crash: kept while the window lives, offered when the next one opens.

::

    an edit --> Autosave, a copy on disk --the program dies--> offer --> recovered or discarded
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QDateTime, QLocale, QObject

from app.document.document import Document
from app.model.refusal import Refusal
from widgets.parts.message_bar import MessageBar
from widgets.parts.messages import sentence
from widgets.window.autosave import Autosave
from widgets.window.files import Files


class Recovery(QObject):
    """Offers in the message bar what other windows left, and tells where no copy can be kept.

    Parameters
    ----------
    folder : Path
        The user's data folder.
    unsaved : callable
        Gives the document to keep, or None when all is saved.
    messages : MessageBar
    files : Files
        Opens what is recovered.
    parent : QObject
    """

    def __init__(
        self,
        folder: Path,
        unsaved: Callable[[], Document | None],
        messages: MessageBar,
        files: Files,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._messages, self._files = messages, files
        self.autosave = Autosave(folder, unsaved, self)
        self.autosave.failed.connect(self._tell_no_copy)

    def offer(self) -> None:
        """Say that work of a window that died can be had back, if some can."""
        orphans = self.autosave.orphans()
        if orphans:
            newest = orphans[0]
            self._messages.say(
                self.tr("Frustum Lab ended unexpectedly; work of {0} was not saved.").format(
                    QLocale().toString(
                        QDateTime.fromSecsSinceEpoch(int(newest.stat().st_mtime)),
                        QLocale.FormatType.ShortFormat,
                    )
                ),
                *self._ways_with(newest),
            )

    def _ways_with(self, path: Path) -> tuple[tuple[str, Callable[[], object]], ...]:
        """What can be done with a copy of unsaved work."""
        return (
            (self.tr("Recover it"), partial(self._recover, path)),
            (self.tr("Discard it"), partial(self._discard, path)),
        )

    def _recover(self, path: Path) -> None:
        try:
            document = self.autosave.recover(path)
        except Refusal as error:
            ways = self._ways_with(path) if path.exists() else ()  # or another window has it
            self._messages.say(sentence(error), *ways)
            return
        if self._files.open_recovered(document):
            if self.autosave.save_now():  # until then the old copy is the only one
                self._discard(path)
            else:
                self._messages.say(
                    self.tr("The recovered work cannot be kept in {0}: save it soon.").format(
                        path.parent
                    )
                )
        elif self._messages.text:  # a mesh that is not there, perhaps only not yet
            self._messages.say(self._messages.text, *self._ways_with(path))
        else:
            self.offer()

    def _discard(self, path: Path) -> None:
        try:
            self.autosave.discard(path)
        except OSError as error:
            self._messages.say(
                self.tr("{0} could not be removed: {1}.").format(path, error.strerror or error)
            )
            return
        self.offer()

    def _tell_no_copy(self, folder: str) -> None:
        self._messages.say(
            self.tr("No copy of unsaved work can be kept in {0}: save it soon.").format(folder)
        )
