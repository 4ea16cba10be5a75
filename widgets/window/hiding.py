"""Hides what would show the answer of an exercise, until the answer is given."""

from collections.abc import Iterable, Mapping

from PySide6.QtCore import QCoreApplication

from widgets.controls.controls import Controls
from widgets.panes.cursor import Cursor
from widgets.panes.pane import Pane
from widgets.window.drawer import Panels

IN_TEST = "panels"  # hidden during a test: all panels


def hide(
    panels: Panels, controls: Controls, cursors: Iterable[Cursor], panes: Mapping[str, Pane],
    hidden: frozenset[str],
) -> None:  # fmt: skip
    """Hide what `HIDDEN` of the exercises lists, and show everything else again.

    It may be the numbers of panels, readout and cursors, those of the lens, and pictures.
    """
    why = QCoreApplication.translate("Hiding", "Hidden until the exercise is answered")
    of_numbers = why if "numbers" in hidden else ""
    of_test = QCoreApplication.translate("Hiding", "Closed during a test")
    panels.close_for(of_test if IN_TEST in hidden else of_numbers)
    controls.card.readout.close_for(of_numbers)
    controls.card.explanation.setEnabled(not of_numbers)
    controls.sections["more_lens"].close_for(why if "lens" in hidden else "")
    for cursor in cursors:
        cursor.close_for(of_numbers)
    for name, pane in panes.items():
        pane.cover(why if name in hidden else "")
