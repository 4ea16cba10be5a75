"""Unsaved work: copied to disk while the window lives, offered by the next window if it dies.

::

    an edit --> Autosave, a copy on disk --the program dies--> offer --> recovered or discarded
    another document is opened --> its own Autosave --the window is closed--^
"""

import logging
import os
import re
import secrets
from collections.abc import Callable, Mapping
from contextlib import suppress
from functools import partial
from pathlib import Path

from PySide6.QtCore import QFileInfo, QLocale, QLockFile, QObject, QTimer, Signal

from app.document.document import Document
from app.document.files import read, write
from app.document.store import Origin, Store
from app.model.refusal import Refusal
from widgets.parts.messages import MessageBar, sentence
from widgets.window.files import Files

log = logging.getLogger(__name__)

_COPY = re.compile(r"autosave-.*\.(json|lock)")
DELAY_MS = 2000  # delay between an edit and its copy; during a long drag, between copies


def _lock(path: Path) -> QLockFile:
    lock = QLockFile(str(path.with_suffix(".lock")))
    lock.setStaleLockTime(0)  # a window may stay open for days
    return lock


class Autosave(QObject):
    """Keeps one file for a document of this window, locked while the window lives.

    A file without a lock belongs to a window that died, or to an unsaved document that another one
    replaced. It is offered, never opened automatically. `current` returns the document to keep, or
    None when everything is saved.
    """

    failed = Signal(str)  # no copy can be kept in this folder; emitted again only after a success

    def __init__(
        self, folder: Path, current: Callable[[], Document | None], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._folder, self._current, self._has_failed = folder, current, False
        self.path = folder / f"autosave-{os.getpid()}-{secrets.token_hex(4)}.json"
        self._lock = _lock(self.path)
        self._timer = QTimer(self, singleShot=True, interval=DELAY_MS)
        self._timer.timeout.connect(self.save_now)
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            log.warning("autosave is off: %s", error)
        else:
            self._lock.tryLock(0)

    def schedule(self) -> None:
        """Save soon; a running timer is not restarted, so that a long animation is saved too."""
        if not self._timer.isActive():
            self._timer.start()

    def save_now(self) -> bool:
        """Write the copy, or remove it when nothing is unsaved; return False if that fails."""
        document = self._current()
        if not self._lock.isLocked():
            return self._fail() if document is not None else False
        try:
            if document is None:
                self.path.unlink(missing_ok=True)
            else:
                write(document, self.path)
        except (Refusal, OSError) as error:
            log.warning("autosave failed: %s", error)
            return self._fail()
        self._has_failed = False
        return True

    def _fail(self) -> bool:
        if not self._has_failed:
            self._has_failed = True
            self.failed.emit(str(self._folder))
        return False

    def orphans(self) -> list[Path]:
        """Return the copies left by windows that died, newest first, and remove their locks."""
        left, files = list[str](), list[tuple[float, Path]]()
        with suppress(OSError):
            left = [name for name in os.listdir(self._folder) if _COPY.fullmatch(name)]
        for path in {(self._folder / name).with_suffix(".json") for name in left} - {self.path}:
            lock = _lock(path)
            if lock.tryLock(0):
                lock.unlock()
                with suppress(OSError):  # a lock alone, or another window has just taken it
                    files.append((path.stat().st_mtime, path))
        return [path for _, path in sorted(files, reverse=True)]

    def leave(self) -> bool:
        """Keep unsaved work before another document is shown; False if there is no copy to keep."""
        self._timer.stop()
        return self.save_now() and os.path.exists(self.path)

    def release(self) -> None:
        """Leave the copy for the next window: its work was neither saved nor discarded."""
        self._timer.stop()
        self._lock.unlock()

    def close(self) -> None:
        """Remove the copy: the window was closed normally."""
        self._timer.stop()
        if self._lock.isLocked():
            try:
                self.path.unlink(missing_ok=True)
            except OSError as error:  # offering it later is better than not closing
                log.warning("autosave stays: %s", error)
            self._lock.unlock()


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
        return self._copies.get(self._store.origin) or self._copy_of(self._store.origin)

    def _copy_of(self, origin: Origin) -> Autosave:
        store = self._store
        copy = Autosave(self._folder, lambda: store.seen if store.modified else None, self)
        copy.failed.connect(self._show_no_copy)
        self._copies[origin] = copy
        return copy

    @property
    def covered(self) -> Mapping[Origin, Path]:
        """The copies of unsaved documents that others cover, in undo."""
        others = self._copies.items()
        return {origin: copy.path for origin, copy in others if origin is not self._store.origin}

    def take_over(self, covered: Mapping[Origin, Path]) -> None:
        """Keep the copies of a window that this one continues, so that they are not offered."""
        for origin, path in covered.items():
            with suppress(OSError):
                path.rename(self._copy_of(origin).path)

    def _leave(self) -> None:
        """Keep unsaved work when another document comes: undo or the next window restores it."""
        if not self.autosave.leave():
            self.autosave.close()
            self._copies.pop(self._store.origin).deleteLater()

    def close(self) -> None:
        """Close with the window: keep the copies of all documents except the current one."""
        self.autosave.close()
        for origin in self.covered:
            self._copies[origin].release()

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
