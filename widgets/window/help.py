"""The Help menu: short texts in windows that do not block the main window."""

import re
import sys
from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QSize, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QMessageBox, QWidget

from app import __version__
from app.model.parameter import read_sections
from widgets.parts.layouts import in_column
from widgets.parts.plain import Markup, ReadText, message_box

PLAY_KEY, FULL_SCREEN_KEY = (
    ("Ctrl+Shift+Space", "Ctrl+Meta+F")  # Ctrl is ⌘ there, and the system uses ⌘Space and F11
    if sys.platform == "darwin"
    else ("Ctrl+Space", "F11")
)

KEYS, ABOUT = (Path(__file__).with_name(name) for name in ("keys.md", "about.md"))
"""The table of keys and the other texts; `tests/texts.py` makes a source for lupdate from them."""
_tr = partial(QCoreApplication.translate, "Help")


def key_groups() -> dict[str, list[tuple[str, str]]]:
    """Read the table of keys: for each heading, what to press or do, and what that does."""
    groups = {heading: list(each.named.items()) for heading, each in read_sections(KEYS).items()}
    return {heading: lines for heading, lines in groups.items() if lines}


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

    return re.sub(r"\{([^{}]+)\}", key, _tr(text))


def show_keys(window: QWidget) -> None:
    """Show a table of keys and mouse actions, which scrolls on a low screen."""
    rows = "".join(
        Markup.of("<tr><td colspan=2><h4>{}</h4></td></tr>", _shown(title))
        + "".join(
            Markup.of("<tr><td><b>{}</b></td><td>{}</td></tr>", _shown(keys), _shown(effect))
            for keys, effect in lines
        )
        for title, lines in key_groups().items()
    )
    page = ReadText()
    page.setHtml(f"<table cellpadding=3>{rows}</table>")
    dialog = QDialog(window)
    dialog.setWindowTitle(QCoreApplication.translate("Help", "Keys and mouse"))
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
    buttons.rejected.connect(dialog.close)
    in_column(page, buttons, on=dialog)
    em = page.fontMetrics().height()
    dialog.resize(QSize(42 * em, 48 * em).boundedTo(window.screen().availableSize() * 0.9))
    dialog.show()


def show_about(window: QWidget, heading: str) -> None:
    """Show one of the other texts, by its heading."""
    lines = [_tr(line).format(__version__) for line in read_sections(ABOUT)[heading].text]
    text = Markup("".join(f"<p>{line}</p>" for line in lines))
    box = message_box(window, text, icon=QMessageBox.Icon.NoIcon)
    box.setWindowTitle(_tr(heading))
    box.setModal(False)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    box.show()
