"""Hides what would show the answer of an exercise, until the answer is given."""

from collections.abc import Mapping

from PySide6.QtCore import QObject

from widgets.controls.scene_card import SceneCard
from widgets.panes.cursor import Cursor
from widgets.panes.pane import Pane
from widgets.parts.section import Section
from widgets.window.drawer import Panels

IN_TEST = "panels"
"""Hidden during a test: all panels."""


class Hiding(QObject):
    """Hides the numbers of panels, readout, cursors and of the lens, and pictures."""

    def __init__(
        self,
        panels: Panels,
        card: SceneCard,
        lens: Section,
        cursors: Mapping[str, Cursor],
        panes: Mapping[str, Pane],
    ) -> None:
        super().__init__(panels)
        self._panels, self._card, self._lens = panels, card, lens
        self._cursors, self._panes = cursors, panes

    def hide(self, hidden: frozenset[str]) -> None:
        """Hide what `HIDDEN` of the exercises lists, and show everything else again."""
        why = self.tr("Hidden until the exercise is answered")
        of_numbers = why if "numbers" in hidden else ""
        of_test = self.tr("Closed during a test") if IN_TEST in hidden else ""
        self._panels.close_for(of_test or of_numbers)
        self._card.readout.close_for(of_numbers)
        self._card.explanation.setEnabled(not of_numbers)
        self._lens.close_for(why if "lens" in hidden else "")
        for cursor in self._cursors.values():
            cursor.close_for(of_numbers)
        for name, pane in self._panes.items():
            pane.cover(why if name in hidden else "")
