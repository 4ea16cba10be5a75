"""A dialog that shows the progress of long work and can cancel it."""

import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor, wait
from contextlib import contextmanager
from typing import TypeAlias, TypeVar

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QProgressDialog, QWidget

from app.model.refusal import Cancelled
from widgets.parts.plain import PlainLabel

SHOWN_AFTER_MS = 100
_POLL_S = 0.02
_Done = TypeVar("_Done")
ReportProgress: TypeAlias = Callable[[float], bool]  # gets the part done; returns whether to go on


@contextmanager
def progress_dialog(window: QWidget, text: str, steps: int = 100) -> Iterator[QProgressDialog]:
    """Show progress while the work inside takes longer than `SHOWN_AFTER_MS`.

    The window accepts no input meanwhile. `text` describes the work in the window's language;
    `steps` is the dialog's final value.
    """
    cancel = QCoreApplication.translate("Progress", "Cancel")
    dialog = QProgressDialog("", cancel, 0, steps, window)
    dialog.setLabel(PlainLabel(text))
    dialog.setWindowModality(Qt.WindowModality.WindowModal)
    dialog.setMinimumDuration(SHOWN_AFTER_MS)
    try:
        yield dialog
    finally:
        dialog.close()
        dialog.deleteLater()


@contextmanager
def progress(window: QWidget, text: str) -> Iterator[ReportProgress]:
    """Show the progress of work that reports it itself; see `progress_dialog`."""
    with progress_dialog(window, text) as dialog:
        begun = asked = time.monotonic()

        def report(fraction: float) -> bool:
            nonlocal asked
            dialog.setValue(min(99, round(100 * fraction)))  # at 100 the dialog would close
            now = time.monotonic()
            if now - asked >= _POLL_S and not dialog.wasCanceled():
                asked = now  # Qt takes no events for a fraction that has not changed
                if now - begun >= SHOWN_AFTER_MS / 1e3:
                    dialog.show()
                    QCoreApplication.processEvents()
            return not dialog.wasCanceled()

        yield report


def apart(work: Callable[[ReportProgress], _Done], report: ReportProgress) -> _Done:
    """Do work without Qt and VTK in a thread, and raise `Cancelled` when `report` wants no more."""
    fraction, goes_on = 0.0, True

    def record(done: float) -> bool:
        nonlocal fraction
        fraction = done
        return goes_on

    thread = ThreadPoolExecutor(1, "apart")
    future = thread.submit(work, record)
    thread.shutdown(wait=False)
    while not future.done():
        wait([future], _POLL_S)
        if not report(fraction):
            goes_on = False
            raise Cancelled
    return future.result()
