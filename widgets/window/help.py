"""The Help menu: short texts in windows that do not block the main window."""

import re
import sys
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, QSize, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QMessageBox, QTextEdit, QWidget

from app import __version__
from widgets.parts.layouts import in_column
from widgets.parts.plain import Markup, TextDocument, message_box

PLAY_KEY, FULL_SCREEN_KEY = (
    ("Ctrl+Shift+Space", "Ctrl+Meta+F")  # Ctrl is ⌘ there, and the system uses ⌘Space and F11
    if sys.platform == "darwin"
    else ("Ctrl+Space", "F11")
)

KEYS = Path(__file__).with_name("keys.md")
"""The content of the table of keys; `tests/texts.py` makes a source for lupdate from it."""


def key_groups() -> dict[str, list[tuple[str, str]]]:
    """Read the table of keys: for each heading, what to press or do, and what that does."""
    groups: dict[str, list[tuple[str, str]]] = {}
    for line in KEYS.read_text(encoding="utf-8").splitlines():
        kind, _, text = line.partition(" ")
        if kind == "##":
            lines = groups[text] = []
        elif kind == "-":
            keys, _, effect = text.partition(": ")
            lines.append((keys, effect))
    return groups


def ways_to_press(shortcut: str | QKeySequence.StandardKey) -> list[QKeySequence]:
    """Return a shortcut and, on macOS, whose keyboards keep F4 for the system, ⌃4 for it."""
    made = [QKeySequence(shortcut)]
    if sys.platform == "darwin" and (key := re.search(r"\bF(\d)$", made[0].toString())):
        made.append(QKeySequence(f"{made[0].toString()[: key.start()]}Meta+{key[1]}"))
    return made


def _shown(text: str) -> str:
    """Translate a text of the table, and write its keys in this system's form."""

    def key(match: re.Match[str]) -> str:
        keys = ways_to_press(PLAY_KEY if match[1] == "Play" else match[1])
        return ", ".join(way.toString(QKeySequence.SequenceFormat.NativeText) for way in keys)

    return re.sub(r"\{([^{}]+)\}", key, QCoreApplication.translate("Help", text))


class Help(QObject):
    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window

    def show_keys(self) -> None:
        """Show a table of keys and mouse actions, which scrolls on a low screen."""
        rows = "".join(
            Markup.of("<tr><td colspan=2><h4>{}</h4></td></tr>", _shown(title))
            + "".join(
                Markup.of("<tr><td><b>{}</b></td><td>{}</td></tr>", _shown(keys), _shown(effect))
                for keys, effect in lines
            )
            for title, lines in key_groups().items()
        )
        page = QTextEdit(readOnly=True)
        page.setDocument(TextDocument(page))
        page.setHtml(f"<table cellpadding=3>{rows}</table>")
        dialog = QDialog(self._window)
        dialog.setWindowTitle(self.tr("Keys and mouse"))
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(dialog.close)
        in_column(page, buttons, on=dialog)
        em = page.fontMetrics().height()
        dialog.resize(
            QSize(42 * em, 48 * em).boundedTo(self._window.screen().availableSize() * 0.9)
        )
        dialog.show()

    def show_conventions(self) -> None:
        text = self.tr(
            "<p>Column vectors, <i>p' = M p</i>. World and view are right-handed with y up;"
            " the camera looks along −z of view space.</p>"
            "<p>Camera frame: <i>n</i> = (eye − target)/|·|, <i>u</i> = up × n/|·|,"
            " <i>v</i> = n × u.</p>"
            "<p>NDC is the OpenGL cube [−1, 1]³, near at −1 and far at +1; Direct3D has z in"
            " [0, 1], reversed in [1, 0]. It is drawn with z mirrored so that the near face is"
            " towards you.</p>"
            "<p>Image: origin top left, x right, y down, in pixels; the first pixel's centre"
            " is at 0.5.</p>"
        )
        self._show_box(self.tr("Conventions"), text)

    def show_about(self) -> None:
        text = self.tr(
            "<p><b>Frustum Lab {0}</b></p><p>How a camera turns a 3-D scene into a picture:"
            " the world, the NDC cube and the image, from one model.</p><p>MIT licence.</p>"
        )
        self._show_box(self.tr("About Frustum Lab"), text.format(__version__))

    def _show_box(self, title: str, text: str) -> None:
        box = message_box(self._window, Markup(text), icon=QMessageBox.Icon.NoIcon)
        box.setWindowTitle(title)
        box.setModal(False)
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        box.show()
