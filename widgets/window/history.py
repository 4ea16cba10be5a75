"""Undo, redo and reset, and what waits for the hand to rest."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from app.document.store import Store
from app.model.projection import Projection
from widgets.parts.fields import Row
from widgets.window.actions import Actions


class History(QObject):
    """The store's history in one window.

    Parameters
    ----------
    window : QWidget
        Whose title shows whether there is something to save.
    store : Store
    menus : Actions
    start : callable
        How the scene of now opens.
    players : sequence of callables
        Each lets something stand still that plays, or that the keyboard drags.
    """

    rested = Signal()
    """No control is held and nothing plays: what was put off for that can be done."""

    def __init__(
        self,
        window: QWidget,
        store: Store,
        menus: Actions,
        start: Callable[[], Projection],
        players: Sequence[Callable[[], None]],
    ) -> None:
        super().__init__(window)
        self._window, self._store, self._menus = window, store, menus
        self._start, self._players = start, players
        menus.undo.triggered.connect(self.undo)
        menus.redo.triggered.connect(self.redo)
        menus.reset.triggered.connect(self.reset)
        store.history_changed.connect(self.show)

    def undo(self) -> None:
        """Go back one step; what moves stands still, or it would go on from there at once."""
        self.stand_still()
        self._store.undo()

    def redo(self) -> None:
        """Take the last undone step up again."""
        self.stand_still()
        self._store.redo()

    def reset(self) -> None:
        """Put projection and settings back to how the scene opens; it can be undone."""
        self.stand_still()
        document = self._store.document
        self._store.set_document(replace(document, projection=self._start(), settings={}))
        rows: list[Row] = self._window.findChildren(Row)  # type: ignore[type-abstract]
        for row in rows:
            row.clear_error()  # what was refused was never in the document

    def stand_still(self) -> None:
        """Let nothing move by itself."""
        for pause in self._players:
            pause()

    def show(self) -> None:
        """Show what can be undone, and whether there is something to save."""
        store, window = self._store, self._window
        self._menus.undo.setEnabled(store.can_undo)
        self._menus.redo.setEnabled(store.can_redo)
        if window.isWindowModified() != store.modified:  # it costs as much as a drawing
            window.setWindowModified(store.modified)
        if not store.in_gesture:
            self.rested.emit()
