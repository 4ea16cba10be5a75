"""A part of the dock: rows, optionally below a title or a folding heading."""

import itertools

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from widgets.parts.icons import show_icon
from widgets.parts.layouts import in_column, tool_button
from widgets.parts.plain import PlainLabel, set_tip

GAP_PX = 6  # between the rows
QUIET = "quietTitle"  # the name of quiet titles in the application's style sheet


class Rows(QWidget):
    """Rows, one below the other; `body` holds them."""

    is_open = True  # whether the rows below the heading are shown

    def __init__(self) -> None:
        super().__init__()
        self._order: list[QWidget] = []
        self._titles: list[PlainLabel] = []
        self.body = QWidget()
        self._rows = in_column(on=self.body, margins=(0, 0, 0, GAP_PX), gap=GAP_PX)
        self._column = in_column(self.body, on=self, margins=(0, 0, 0, 0), gap=2)

    def show_some(self, matches: set[QWidget] | None) -> None:
        """Show the part if it has one of the found rows; None always shows it."""
        here = (row for row in self._order if row.parent() is self.body)
        self.setVisible(matches is None or any(row in matches for row in here))

    # -- rows

    def add(self, widget: QWidget) -> None:
        self._order.append(widget)
        self._rows.addWidget(widget)

    def add_title(self, text: str) -> None:
        title = PlainLabel(text, objectName=QUIET)
        self._titles.append(title)
        self.add(title)

    def show_titles(self) -> None:
        """Show the quiet titles that have a shown row below them."""
        for title in self._titles:
            rows = self._order[self._order.index(title) + 1 :]
            below = itertools.takewhile(lambda row: row not in self._titles, rows)
            title.setVisible(any(not row.isHidden() for row in below))

    def return_borrowed(self) -> None:
        for place, widget in enumerate(self._order):
            if widget.parent() is not self.body:
                self._rows.insertWidget(place, widget)


class TitledRows(Rows):
    def __init__(self, title: str) -> None:
        super().__init__()
        self.title = PlainLabel(title, objectName=QUIET)
        self._column.insertWidget(0, self.title)


class Section(Rows):
    """Rows below a heading that folds them by a click, Space, Enter, ← or →."""

    toggled = Signal(bool)

    def __init__(self, title: str) -> None:
        super().__init__()
        self.heading = tool_button(
            title, act=self._turn, icon="unfold", name=title, flat=True, by_click=True
        )
        self.heading.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.heading.installEventFilter(self)
        self._column.setSpacing(0)
        self._column.insertWidget(0, self.heading)
        self._is_open = False
        self._matches: set[QWidget] | None = None
        self._why_closed = ""
        self.set_open(False)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Handle the heading's keys before the button moves the focus by arrows."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            key, keys = event.key(), Qt.Key
            if key in (keys.Key_Return, keys.Key_Enter):
                self._turn()
                return True
            if key in (keys.Key_Left, keys.Key_Right):
                if self.is_open != (key == keys.Key_Right):
                    self.set_open(key == keys.Key_Right)
                return True
        return super().eventFilter(watched, event)

    def close_for(self, why: str) -> None:
        """Keep the rows folded for a reason; without one, show them as they were before."""
        if why != self._why_closed:
            self._why_closed = why
            self.heading.setEnabled(not why)
            self._show()

    def _turn(self) -> None:
        self.set_open(not self.is_open)

    def set_open(self, is_open: bool) -> None:
        self._is_open = is_open
        self._show()

    def show_some(self, matches: set[QWidget] | None) -> None:
        """Unfold while the part has one of the found rows; None restores the state before."""
        super().show_some(matches)
        if matches is None or not self.isHidden():
            self._matches = matches
            self._show()

    def _show(self) -> None:
        is_shown = self._is_open or self._matches is not None
        self.is_open = is_open = is_shown and not self._why_closed
        self.body.setVisible(is_open)
        show_icon(self.heading, "choose" if is_open else "unfold")
        turn = self.tr("Fold") if is_open else self.tr("Unfold")
        set_tip(self.heading, self._why_closed or turn)
        self.heading.setAccessibleDescription(self.tr("unfolded") if is_open else self.tr("folded"))
        self.toggled.emit(is_open)
