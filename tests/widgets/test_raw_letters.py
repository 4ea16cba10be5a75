"""No text that a person reads has raw markup of letters: an underscore, a tag or TeX."""

import re
from collections.abc import Iterator
from dataclasses import replace

import pytest
from PySide6.QtCore import QObject
from PySide6.QtGui import QAction, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QApplication,
    QComboBox,
    QLabel,
    QListWidget,
    QWidget,
)

from app.document.view import PANELS
from app.lecture.letters import LETTERS
from app.lessons.contents import contained
from app.lessons.lesson import read
from app.lessons.text import in_line
from tests.support.window import settle, show_scene
from widgets.parts.labels import Balanced
from widgets.window.main_window import MainWindow

RAW = re.compile(r"[^\W_]_[\w{]|\\[a-z]|<su[bp]>|\$")
TAG = re.compile(r"<[^<>]*>")
TIP = Qt.ItemDataRole.ToolTipRole


def rich(text: str) -> str:
    return TAG.sub("", text) if Qt.mightBeRichText(text) else text


def texts(thing: QWidget | QAction) -> Iterator[str]:
    """What a widget or an action writes on the screen, as it is read."""
    yield rich(thing.toolTip())
    if isinstance(thing, Balanced):  # it paints its own subscripts: see test_plain_text
        return
    if isinstance(thing, QLabel):
        is_plain = thing.textFormat() == Qt.TextFormat.PlainText
        yield thing.text() if is_plain else TAG.sub("", thing.text())
    elif isinstance(thing, QAbstractButton | QAction):
        yield thing.text()
    elif isinstance(thing, QComboBox):
        for place in range(thing.count()):
            yield thing.itemText(place)
            yield rich(str(thing.itemData(place, TIP) or ""))
    elif isinstance(thing, QListWidget):
        yield from (thing.item(row).text() for row in range(thing.count()))
    elif isinstance(thing, QAbstractItemView) and thing.model() is not None:
        model = thing.model()
        for row in range(model.rowCount(thing.rootIndex())):
            yield rich(str(model.index(row, 0).data(TIP) or ""))


def raw() -> set[str]:
    settle()
    return {
        text
        for top in QApplication.topLevelWidgets()
        for thing in (top, *top.findChildren(QObject))
        if isinstance(thing, QWidget | QAction)
        for text in texts(thing)
        if RAW.search(text.replace("x86_64", ""))  # a processor's name
    }


@pytest.mark.undrawn
def test_no_text_of_the_window_has_raw_letters(window: MainWindow) -> None:
    """A parallel and a perspective lens, each panel, the letters of each lecture."""
    for scene in ("oblique-drawing", "vanishing-points"):
        document = show_scene(window, scene).store.document
        for letters in reversed(LETTERS):  # the last ones are those of the next window
            for panel in ("matrices", "probe"):
                view = replace(document.view, panel=panel, letters=letters)
                window.store.open(replace(document, view=view))
                assert not raw(), (scene, panel, letters)
    for panel in PANELS:
        window.store.set_view(panel=panel)
        assert not raw(), panel


def test_letters_in_lessons_are_formulas() -> None:
    found = [
        (path.name, line, text)
        for path in contained()
        for step in read(path).steps
        for line, text in ((step.line, step.title), *(t for b in step.blocks for t in b.texts()))
        if re.search(r"[^\W_]_\w", re.sub(r"(\$+).*?\1|`[^`]*`", "", text, flags=re.DOTALL))
    ]
    assert not found


def test_a_title_in_a_list_has_its_subscripts() -> None:
    assert in_line("The same for $x_p$ and $z_{min}$, *not* t") == "The same for xₚ and zₘᵢₙ, not t"
