"""The title row that lies on a pane's picture: the title and a note at the left, buttons right."""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, QSize
from PySide6.QtWidgets import QToolButton, QWidget

from widgets.parts.labels import Title
from widgets.parts.layouts import in_row
from widgets.parts.plain import set_tip


class Header(QWidget):
    """The title and the note; `tools` is a widget of its own, with the buttons.

    Everything stays in one line.
    """

    def __init__(self, pane: QWidget, title: str, tools: Sequence[QToolButton]) -> None:
        super().__init__()
        self._pane = pane
        pane.installEventFilter(self)
        self.title, self.note = Title(title), Title("", "paneNote")
        self.tools = QWidget()
        self._beside_title: tuple[QWidget, QWidget] | None = None
        self._is_for_class = False
        self._title_bar = in_row(self.title, self.note, on=self, margins=(8, 2, 2, 2))
        self._tool_bar = in_row(*tools, on=self.tools, margins=(8, 2, 2, 2))
        tip = self.tr(
            "Double-click to enlarge this pane, again for the whole window, and again to go back"
        )
        set_tip(self, tip)

    def add(self, widget: QWidget, narrow: QWidget) -> None:
        """Put a widget beside the title, and `narrow` in its place where it does not fit."""
        self._title_bar.addWidget(widget)
        self._title_bar.addWidget(narrow)
        self._beside_title = widget, narrow

    def add_tool(self, button: QToolButton) -> None:
        self._tool_bar.insertWidget(0, button)
        self.fit()

    @property
    def room(self) -> tuple[int, int]:
        """The free part of the row, in pixels from the pane's left."""
        left = 0 if self.isHidden() else self.x() + self.width()
        return left, self._pane.width() if self.tools.isHidden() else self.tools.x()

    def set_presenting(self, on: bool, *, named: bool = True) -> None:
        """Hide the buttons from a class, and a title that it does not need to be `named` by."""
        self._is_for_class = on
        self.tools.setVisible(not on)
        self.setVisible(named or not on)
        self.fit()

    def show_title(self, title: str, note: str) -> None:
        """Name the content of the pane; its accessible name stays."""
        self.title.setText(title)
        self.note.setText(note)
        self.fit()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self._pane and event.type() in (QEvent.Type.Resize, QEvent.Type.FontChange):
            self.fit()
        return False

    def fit(self) -> None:
        """Share out the width, after a change of the pane's size or font."""
        tools = QSize(0, 0) if self.tools.isHidden() else self.tools.sizeHint()
        self.setMinimumHeight(tools.height())
        room = max(0, self._pane.width() - tools.width())
        bar = self._title_bar
        margins = bar.contentsMargins()
        taken = margins.left() + self.title.sizeHint().width() + bar.spacing() + margins.right()
        if self._beside_title is not None:
            wide, narrow = self._beside_title
            fits = taken + bar.spacing() + wide.sizeHint().width() <= room
            wide.setVisible(fits and not self._is_for_class)
            narrow.setVisible(not fits and not self._is_for_class)
            if not self._is_for_class:
                taken += bar.spacing() + (wide if fits else narrow).sizeHint().width()
        self.setMaximumWidth(room)
        self.note.setMaximumWidth(max(0, room - taken))
