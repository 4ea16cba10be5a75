"""Asks where something is to be saved, and never writes over a file that nobody was asked about.

Qt's own question does not know that a name without an ending gets one: it has looked for another
file.
"""

from __future__ import annotations

import os

from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from widgets.parts.plain import message_box


def ask_where(parent: QWidget, title: str, proposed: str, kinds: str, ending: str) -> str:
    """The path of a file with this ending; empty if there shall be none.

    Parameters
    ----------
    parent : QWidget
    title, proposed, kinds : str
        Of Qt's own question.
    ending : str
        What a name without it gets.
    """
    path, _ = QFileDialog.getSaveFileName(parent, title, proposed, kinds)
    if not path or path.lower().endswith(ending):
        return path
    path += ending
    if os.path.exists(path):
        text = QCoreApplication.translate("Saving", "{0} is there already.")
        question = QCoreApplication.translate("Saving", "Write over it?")
        box = message_box(parent, text.format(os.path.basename(path)), question)
        buttons = QMessageBox.StandardButton
        box.setStandardButtons(buttons.Yes | buttons.Cancel)
        box.setDefaultButton(buttons.Cancel)
        if box.exec() != buttons.Yes:
            return ""
    return path
