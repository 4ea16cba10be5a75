"""A dialog that shows the progress of long work and can cancel it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TypeAlias

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QProgressDialog, QWidget

from widgets.parts.plain import PlainLabel

SHOWN_AFTER_MS = 100
Tell: TypeAlias = Callable[[float], bool]
"""Receives the fraction done; returns whether to continue."""


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
def progress(window: QWidget, text: str) -> Iterator[Tell]:
    """Show the progress of work that reports it itself; see `progress_dialog`."""
    with progress_dialog(window, text) as dialog:

        def tell(fraction: float) -> bool:
            dialog.setValue(min(99, round(100 * fraction)))  # at 100 the dialog would close
            return not dialog.wasCanceled()

        yield tell
