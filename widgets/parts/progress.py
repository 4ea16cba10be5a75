"""A dialog that shows how far a long piece of work has come, and by which it can be cancelled."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TypeAlias

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtWidgets import QProgressDialog, QWidget

from widgets.parts.plain import Label

SHOWN_AFTER_MS = 100
Tell: TypeAlias = Callable[[float], bool]
"""Takes the fraction that is done; whether to go on."""


@contextmanager
def progress_dialog(window: QWidget, text: str, steps: int = 100) -> Iterator[QProgressDialog]:
    """Show progress while the work inside takes longer than `SHOWN_AFTER_MS`.

    Parameters
    ----------
    window : QWidget
        Which takes no input meanwhile.
    text : str
        Translated: what is done.
    steps : int
        What the dialog's value is when all is done.
    """
    cancel = QCoreApplication.translate("Progress", "Cancel")
    dialog = QProgressDialog("", cancel, 0, steps, window)
    dialog.setLabel(Label(text))
    dialog.setWindowModality(Qt.WindowModality.WindowModal)
    dialog.setMinimumDuration(SHOWN_AFTER_MS)
    try:
        yield dialog
    finally:
        dialog.close()
        dialog.deleteLater()


@contextmanager
def progress(window: QWidget, text: str) -> Iterator[Tell]:
    """Show progress of work that tells it itself; see `progress_dialog`."""
    with progress_dialog(window, text) as dialog:

        def tell(fraction: float) -> bool:
            dialog.setValue(min(99, round(100 * fraction)))  # at 100 it would go
            return not dialog.wasCanceled()

        yield tell
