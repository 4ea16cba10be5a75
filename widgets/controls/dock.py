"""The dock: a column that scrolls below a search box and keeps rows in place.

The search finds a control by its name, its letter, its old names, or the words of its tooltip. Each
typed word must begin a word of the control; a single letter must be a whole word. Names come before
tooltips: a plane's name means the plane, not everything that depends on it.
"""

import re
import unicodedata
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from PySide6.QtCore import QEvent, QObject, QSize, Qt, Signal
from PySide6.QtGui import QFontInfo, QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QFrame, QLineEdit, QScrollArea, QVBoxLayout, QWidget

from widgets.parts.layouts import FocusRing, in_column, lay_out
from widgets.parts.plain import set_tip
from widgets.parts.section import GAP_PX


class ControlTexts(NamedTuple):
    """The texts of a control: its names in the window's language and the model's, and its tip."""

    names: str
    tip: str


def find(text: str, parts: Mapping[QWidget, ControlTexts]) -> set[QWidget]:
    """Return the controls whose names have all words, or else whose names and tips have them."""
    asked = _words(text)
    if not asked:
        return set()
    named = {part for part, told in parts.items() if _has(told.names, asked)}
    return named or {part for part, told in parts.items() if _has(" ".join(told), asked)}


def _words(text: str) -> list[str]:
    """Return the words of a text without accents, which many do not type."""
    letters = unicodedata.normalize("NFD", text.casefold().replace("đ", "d"))
    return re.findall(r"[^\W_]+", re.sub("[\u0300-\u036f]", "", letters))


def _has(text: str, asked: Iterable[str]) -> bool:
    words = _words(text)
    return all(
        part in words or (len(part) > 1 and any(word.startswith(part) for word in words))
        for part in asked
    )


class SearchBox(QLineEdit):
    """The search box: Enter or ↓ goes to the first result, Esc clears it."""

    taken = Signal()  # the user wants to go to the first result

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setPlaceholderText(self.tr("Find a control"))
        self.setAccessibleName(self.tr("Find a control"))
        tip = self.tr("Shows the controls with this name, also folded ones; Enter goes to the"
                      " first, Esc shows all again (Ctrl+F)")  # fmt: skip
        set_tip(self, tip)
        self.setAccessibleDescription(tip)
        self.setClearButtonEnabled(True)

    def event(self, event: QEvent) -> bool:
        is_key = isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape
        if is_key and event.type() == QEvent.Type.ShortcutOverride and self.text():
            event.accept()  # not a shortcut of the window
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key, keys = event.key(), Qt.Key
        if key == keys.Key_Escape and self.text():
            self.clear()
        elif key in (keys.Key_Return, keys.Key_Enter, keys.Key_Down) and self.text():
            self.taken.emit()
        else:
            super().keyPressEvent(event)


WIDTH_PX, LEAST_PX = 285, 270  # default width of the dock, and its least width at the ordinary font
PRESENTED_EM = 17.6  # width of the dock for a class on any screen, in heights of its letters
LEFT_MARGIN_PX, RIGHT_MARGIN_PX = 8, 4


class Dock(QScrollArea):
    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._is_for_class = False
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click beside the rows leaves no ring
        FocusRing(self)
        self.search = SearchBox(self)
        self._column = QWidget()
        self.setWidget(self._column)  # while it is empty: later all of it would be styled again
        self._layout: QVBoxLayout = in_column(on=self._column, gap=2)

    def bring_into_view(self, *parts: QWidget) -> None:
        """Scroll so that the last widget is visible, and as much of the others as fits."""
        if all(part.isVisible() for part in parts):
            lay_out()
            for part in parts:
                self.ensureWidgetVisible(part, 0, 0)

    def _reserve_bar(self) -> None:
        """Reserve the scroll bar's space while it is hidden, so that rows stay in place."""
        shown = self.width() - self.viewport().width()
        free = max(0, self._bar_width() - shown)
        self._layout.setContentsMargins(LEFT_MARGIN_PX, 0, RIGHT_MARGIN_PX + free, 0)

    def _bar_width(self) -> int:
        return self.verticalScrollBar().sizeHint().width()

    def _make_room(self) -> None:
        search_px = 0 if self._is_for_class else self.search.sizeHint().height() + GAP_PX
        self.setViewportMargins(0, search_px, 0, 0)
        self._place_search()

    def _place_search(self) -> None:
        width = self.width() - LEFT_MARGIN_PX - RIGHT_MARGIN_PX - self._bar_width()
        self.search.setGeometry(LEFT_MARGIN_PX, 0, width, self.search.sizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._reserve_bar()  # first: the rows keep their width and wrap no text again
        super().resizeEvent(event)
        self._place_search()

    def minimumSizeHint(self) -> QSize:
        rows = self._column.minimumSizeHint().width() - self._layout.contentsMargins().right()
        em = QFontInfo(self.font()).pixelSize() if self._is_for_class else 0.0
        least = max(LEAST_PX, round(PRESENTED_EM * em))
        return QSize(max(least, rows + RIGHT_MARGIN_PX + self._bar_width()), 120)

    def sizeHint(self) -> QSize:
        return QSize(max(WIDTH_PX, self.minimumSizeHint().width()), 600)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()  # a scroll area ignores the least width of its widget
        return super().eventFilter(watched, event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange) and self.widget():
            self._make_room()
