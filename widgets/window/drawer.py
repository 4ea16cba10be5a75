"""The panels under the panes: a row of names, folded until one of them is opened."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QHBoxLayout, QStackedWidget, QToolButton, QVBoxLayout, QWidget


class _Name(QToolButton):
    """Opens and folds a panel: by a click, Space or Enter."""

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.click()
        else:
            super().keyPressEvent(event)


class Panels(QWidget):
    """Widgets of which at most one is open.

    A panel that is not open is hidden; what it shows, it computes when it appears (`QWidget`'s
    showEvent).

    Attributes
    ----------
    opened : Signal()
        One was opened, or the last one folded.
    """

    opened = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._buttons: list[QToolButton] = []
        self._names = QHBoxLayout()
        self._names.setContentsMargins(0, 0, 0, 0)
        self._names.addStretch(1)
        self._stack = QStackedWidget()
        self._stack.hide()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 2, 0, 0)
        layout.setSpacing(2)
        layout.addLayout(self._names)
        layout.addWidget(self._stack, 1)

    def sizeHint(self) -> QSize:
        """As high as the open panel wants to be, not as the highest of them."""
        hint, panel, layout = super().sizeHint(), self.open_panel, self.layout()
        if panel is None or layout is None:
            return hint
        # From its parts: of what the panel has grown by just now, the layout's own hint knows not.
        around = self._names.sizeHint().height() + layout.spacing()
        around += layout.contentsMargins().top() + layout.contentsMargins().bottom()
        return QSize(hint.width(), around + panel.sizeHint().height())

    def add(self, name: str, panel: QWidget, tip: str) -> None:
        """Add a panel, folded, under a translated name.

        Parameters
        ----------
        name : str
        panel : QWidget
        tip : str
            What it shows, for its name's tooltip.
        """
        button = _Name()
        button.setText(name)
        button.setToolTip(tip)
        button.setCheckable(True)
        button.setAutoRaise(True)
        button.clicked.connect(partial(self._clicked, panel))
        self._names.insertWidget(len(self._buttons), button)
        self._buttons.append(button)
        self._stack.addWidget(panel)

    @property
    def open_panel(self) -> QWidget | None:
        """The panel that is open."""
        return None if self._stack.isHidden() else self._stack.currentWidget()

    def open(self, panel: QWidget | None) -> None:
        """Open one panel instead of another, or fold them all."""
        if panel is not None:
            self._stack.setCurrentWidget(panel)
        self._stack.setVisible(panel is not None)
        for index, button in enumerate(self._buttons):
            button.setChecked(panel is self._stack.widget(index))
        self.opened.emit()

    def _clicked(self, panel: QWidget) -> None:
        self.open(None if panel is self.open_panel else panel)
