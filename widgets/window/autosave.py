"""A copy of unsaved work in the user's data folder, in case the program dies."""

import logging
import os
import re
import secrets
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from PySide6.QtCore import QLockFile, QObject, QTimer, Signal

from app.document.document import Document
from app.document.files import write
from app.model.refusal import Refusal

log = logging.getLogger(__name__)

_COPY = re.compile(r"autosave-.*\.(json|lock)")
DELAY_MS = 2000
"""Delay between an edit and its copy; during a long drag, the interval between copies."""


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

    failed = Signal(str)
    """No copy can be kept in this folder; emitted again only after a copy has succeeded."""

    def __init__(
        self, folder: Path, current: Callable[[], Document | None], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._folder, self._current, self._has_failed = folder, current, False
        self._path = folder / f"autosave-{os.getpid()}-{secrets.token_hex(4)}.json"
        self._lock = _lock(self._path)
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
                self._path.unlink(missing_ok=True)
            else:
                write(document, self._path)
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
        for path in {(self._folder / name).with_suffix(".json") for name in left} - {self._path}:
            lock = _lock(path)
            if lock.tryLock(0):
                lock.unlock()
                with suppress(OSError):  # a lock alone, or another window has just taken it
                    files.append((path.stat().st_mtime, path))
        return [path for _, path in sorted(files, reverse=True)]

    def leave(self) -> bool:
        """Keep unsaved work before another document is shown; False if there is no copy to keep."""
        self._timer.stop()
        return self.save_now() and os.path.exists(self._path)

    def release(self) -> None:
        """Leave the copy for the next window: its work was neither saved nor discarded."""
        self._timer.stop()
        self._lock.unlock()

    def close(self) -> None:
        """Remove the copy: the window was closed normally."""
        self._timer.stop()
        if self._lock.isLocked():
            try:
                self._path.unlink(missing_ok=True)
            except OSError as error:  # offering it later is better than not closing
                log.warning("autosave stays: %s", error)
            self._lock.unlock()
