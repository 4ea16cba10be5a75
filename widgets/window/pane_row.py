"""The panes side by side; each can have the whole row, or a window of its own."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QSplitter

from widgets.panes.pane import Pane
from widgets.panes.stage_strip import StageStrip

PANE_WIDTHS = [400, 305, 330]
"""Of the panes in a window of 1366 pixels; the splitter keeps their proportion."""
LEAST_PANE_PX = 190
"""So that Full HD at a screen scale of 2 holds the window, in projector mode too."""


class PaneRow(QSplitter):
    """The panes, docked or afloat.

    Parameters
    ----------
    panes : mapping of str to Pane
        From left to right.
    strip : StageStrip
        Below one of them; it plays on when its pane is moved.
    """

    def __init__(self, panes: Mapping[str, Pane], strip: StageStrip) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self._panes, self._strip = panes, strip
        self.setChildrenCollapsible(False)
        for name, pane in panes.items():
            pane.setMinimumWidth(LEAST_PANE_PX)
            self.addWidget(pane)
            pane.enlarge_requested.connect(partial(self.enlarge, name))
            pane.float_requested.connect(partial(self.toggle_float, name))

    def enlarge(self, name: str) -> None:
        """Give one docked pane the whole row, or go back to all."""
        docked = [pane for pane in self._panes.values() if not pane.isWindow()]
        chosen = self._panes[name]
        if chosen.isWindow():
            return
        alone = all(pane.isHidden() for pane in docked if pane is not chosen)
        for pane in docked:
            pane.setVisible(alone or pane is chosen)

    def show_all(self) -> None:
        """Dock and show every pane."""
        for name, pane in self._panes.items():
            if pane.isWindow():
                self.toggle_float(name)
            pane.show()
        self.setSizes(PANE_WIDTHS)

    def toggle_float(self, name: str) -> None:
        """Give a pane a window of its own, for a second screen, or dock it again."""
        pane, plays = self._panes[name], self._strip.playing
        if pane.isWindow():
            names = list(self._panes)
            before = names[: names.index(name)]
            place = sum(not self._panes[other].isWindow() for other in before)
            pane.move_to(None, lambda: self.insertWidget(place, pane))
        else:
            size = pane.size()
            pane.setWindowTitle(f"{pane.name} – Frustum Lab")
            pane.move_to(self.window(), lambda: pane.resize(size))
            docked = [other for other in self._panes.values() if not other.isWindow()]
            if docked and all(other.isHidden() for other in docked):
                docked[0].show()
        if plays:  # on the way it was hidden, which stops it
            self._strip.play()

    def reset_views(self) -> None:
        """Put every pane's own camera back; the model is not touched."""
        for pane in self._panes.values():
            pane.reset_view()
