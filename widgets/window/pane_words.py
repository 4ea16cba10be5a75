"""Tells a screen reader in words what each pane shows, as soon as nothing changes any more."""

from collections.abc import Callable, Mapping

from PySide6.QtCore import QObject, QTimer
from PySide6.QtGui import QAccessible

from app.document.store import Store
from app.drawings.describing import describe
from app.scenes.scene import Scene
from widgets.panes.pane import Pane
from widgets.window.status_line import RESTS_AFTER_MS


class PaneWords(QObject):
    """Describes the panes, if anybody listens; while an exercise hides numbers, without them."""

    def __init__(
        self, panes: Mapping[str, Pane], store: Store, scene: Callable[[], Scene], parent: QObject
    ) -> None:
        super().__init__(parent)
        self._panes, self._store, self._scene = panes, store, scene
        self._hidden: frozenset[str] = frozenset()
        self._rest = QTimer(self, singleShot=True, interval=RESTS_AFTER_MS)
        self._rest.timeout.connect(self._describe_panes)

    def describe_later(self) -> None:
        """Describe the panes when nothing has changed for a while."""
        if QAccessible.isActive():
            self._rest.start()

    def hide(self, hidden: frozenset[str]) -> None:
        """Leave out what `HIDDEN` of the exercises lists: at once, or it would be heard."""
        self._hidden = hidden
        if QAccessible.isActive():
            self._describe_panes()

    def _describe_panes(self) -> None:
        about = describe(self._store.seen, self._scene())
        for name, pane in self._panes.items():
            said = about.panes[name] if self._hidden else about.of_pane(name)
            pane.hand.describe("" if name in self._hidden else said)
