"""Undo, redo and reset, and work that is postponed until the user's input stops."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from app.document.store import Store
from app.model.projection import Projection
from widgets.parts.fields import Row
from widgets.window.actions import Actions


class History(QObject):
    """The store's history for one window; its title shows whether there is unsaved work.

    `start` returns the projection that the current scene opens with. Each of `players` stops an
    animation, or a drag by the keyboard.
    """

    rested = Signal()  # no control is held and nothing plays: postponed work can run now

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
        """Go back one step; first stop every animation, which would continue from there."""
        self.stand_still()
        self._store.undo()

    def redo(self) -> None:
        self.stand_still()
        self._store.redo()

    def reset(self) -> None:
        """Reset projection and settings to those that the scene opens with, as one undo step."""
        self.stand_still()
        document = self._store.document
        self._store.set_document(replace(document, projection=self._start(), settings={}))
        rows: list[Row] = self._window.findChildren(Row)  # type: ignore[type-abstract]
        for row in rows:
            row.clear_error()  # a refused value was never in the document

    def stand_still(self) -> None:
        """Stop everything that moves by itself."""
        for pause in self._players:
            pause()

    def show(self) -> None:
        """Update Undo, Redo and the window's unsaved mark."""
        store, window = self._store, self._window
        self._menus.undo.setEnabled(store.can_undo)
        self._menus.redo.setEnabled(store.can_redo)
        if window.isWindowModified() != store.modified:  # setting it takes as long as a drawing
            window.setWindowModified(store.modified)
        if not store.in_gesture:
            self.rested.emit()
