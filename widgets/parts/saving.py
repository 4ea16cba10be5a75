"""Ask for a file to save to, and confirm before overwriting one; encode pictures.

Qt's own dialog does not know that a name without an ending gets one, so it checks another file.
"""

import os

from PySide6.QtCore import QBuffer, QCoreApplication
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from widgets.parts.plain import message_box


def ask_where(parent: QWidget, title: str, proposed: str, kinds: str, ending: str) -> str:
    """Return the path of a file with this ending, or nothing if the user cancels."""
    path, _ = QFileDialog.getSaveFileName(parent, title, proposed, kinds)
    if not path or path.lower().endswith(ending):
        return path
    path += ending
    if os.path.exists(path):
        text = QCoreApplication.translate("Saving", "{0} already exists.")
        question = QCoreApplication.translate("Saving", "Overwrite it?")
        box = message_box(parent, text.format(os.path.basename(path)), question)
        buttons = QMessageBox.StandardButton
        box.setStandardButtons(buttons.Yes | buttons.Cancel)
        box.setDefaultButton(buttons.Cancel)
        if box.exec() != buttons.Yes:
            return ""
    return path


def png_of(picture: QImage | QPixmap) -> bytes:
    buffer = QBuffer()
    buffer.open(QBuffer.OpenModeFlag.WriteOnly)
    picture.save(buffer, "PNG")  # type: ignore[call-overload]
    return bytes(buffer.data().data())
