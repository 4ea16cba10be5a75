"""The panels under the panes: a row of names, folded until one of them is opened."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import cast

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QSplitter,
    QStackedWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from widgets.parts.panel import Panel, Shown


class _Name(QToolButton):
    """Opens and folds a panel: by a click, Space or Enter."""

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.click()
        else:
            super().keyPressEvent(event)


class Panels(QWidget):
    """Widgets of which at most one is open.

    A panel that is not open is hidden, and hears of nothing until it is opened.

    Attributes
    ----------
    opened : Signal()
        One was opened, or the last one folded.
    """

    opened = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._shown: Shown | None = None
        self._told: dict[Panel, Shown] = {}
        """What each panel shows."""
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

    def add(self, name: str, panel: Panel, tip: str) -> None:
        """Add a panel, folded, under a translated name.

        Parameters
        ----------
        name : str
        panel : Panel
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
    def all(self) -> tuple[Panel, ...]:
        """Every panel, in the order of their names."""
        return tuple(cast(Panel, self._stack.widget(i)) for i in range(self._stack.count()))

    @property
    def open_panel(self) -> Panel | None:
        """The panel that is open."""
        if self._stack.isHidden():
            return None
        return cast(Panel, self._stack.currentWidget())

    def keep(self, shown: Shown) -> None:
        """Note what is shown from now on; `tell` hands it to the open panel."""
        self._shown = shown

    def tell(self, panel: Panel | None = None) -> None:
        """Tell the open panel, or another one, what has changed since it was told last."""
        panel = panel or self.open_panel
        if panel is None or self._shown is None:
            return
        changed = self._shown.changed_since(self._told.get(panel))
        self._told[panel] = self._shown
        if changed & panel.concerns:
            panel.take(self._shown, changed)

    def open(self, panel: Panel | None) -> None:
        """Open one panel instead of another, or fold them all."""
        if panel is not None:
            self.tell(panel)
            self._stack.setCurrentWidget(panel)
        self._stack.setVisible(panel is not None)
        for index, button in enumerate(self._buttons):
            button.setChecked(panel is self._stack.widget(index))
        self.opened.emit()

    def _clicked(self, panel: Panel) -> None:
        self.open(None if panel is self.open_panel else panel)


class Column(QSplitter):
    """The panes' row above, the panels below, which take no more than they were given last.

    Parameters
    ----------
    above : QWidget
    panels : Panels
    is_projector : callable
        Whether text is large.
    in_gesture : callable
        Whether a control is dragged, or something plays.
    """

    def __init__(
        self,
        above: QWidget,
        panels: Panels,
        is_projector: Callable[[], bool],
        in_gesture: Callable[[], bool],
    ) -> None:
        super().__init__(Qt.Orientation.Vertical)
        self._panels, self._is_projector, self._in_gesture = panels, is_projector, in_gesture
        self._panels_px: int | None = None
        """The height that the hand has given them, in a window as high as it was then."""
        self._chosen_in = 0
        self._grown_px = 0
        """Otherwise the highest that one of them wanted, in a window as it was then."""
        self._grown_in = (0, False)
        self._is_outgrown = False
        """Whether one of them needs more since a gesture began."""
        self.addWidget(above)
        self.addWidget(panels)
        self.setStretchFactor(0, 1)
        self.setStretchFactor(1, 0)
        self.setCollapsible(0, False)
        self.setCollapsible(1, False)
        panels.opened.connect(self.fit)
        self.splitterMoved.connect(self._dragged)

    def fit(self) -> None:
        """Give an open panel its height, and a folded row of names no more than it needs.

        It is one height for all of them, or the panes would jump from name to name: it only grows,
        unless the hand has chosen it.
        """
        height = sum(self.sizes())
        names = wanted = self._panels.minimumSizeHint().height()
        if self._panels.open_panel is None:
            self._panels.setMaximumHeight(names)
        else:
            self._panels.setMaximumHeight(16777215)  # QWIDGETSIZE_MAX: as much as there is
            now = (self.window().height(), self._is_projector())
            if now[0] < self._chosen_in:
                self._panels_px = None  # of a smaller window it would leave the panes too little
            if self._panels_px is None:
                if now != self._grown_in:
                    self._grown_in, self._grown_px = now, 0
                self._grown_px = max(self._grown_px, names, self._panels.sizeHint().height())
            wanted = self._panels_px or self._grown_px
        self.setSizes([height - wanted, wanted])

    def outgrown(self) -> None:
        """Give a panel the height that it needs now, but move no pane under the hand."""
        self._is_outgrown = self._in_gesture()
        if not self._is_outgrown:
            self.fit()

    def _dragged(self) -> None:
        if self._panels.open_panel is not None:
            self._panels_px, self._chosen_in = self.sizes()[1], self.window().height()

    def rest(self) -> None:
        """Give the panels what they have come to need during a gesture that is over now."""
        if self._is_outgrown:
            self.outgrown()

    def window_resized(self) -> None:
        """Fit anew in a window of another height, unless the hand has chosen."""
        if self._panels_px is None:
            self.fit()
