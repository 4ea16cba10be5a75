"""Draws the scene on which a hand rests in an open list of scenes, before it is chosen."""

from collections.abc import Iterator

from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QApplication

from app.model.refusal import Refusal
from widgets.parts.panel import ShownData
from widgets.window.actions import Actions
from widgets.window.files import Files
from widgets.window.look import Look

REST_MS = 100  # on one entry of the list


class SceneAhead(QObject):
    """Draws in pieces between Qt's events, and stops when the list closes."""

    def __init__(self, menus: Actions, files: Files, look: Look) -> None:
        super().__init__(look)
        self._files, self._look = files, look
        self._work: Iterator[None] = iter(())
        self.rest = QTimer(self, singleShot=True)
        self.rest.timeout.connect(self._go_on)
        menus.scene_pointed_at.connect(self._begin)

    def _begin(self, name: str) -> None:
        self._work = self._pieces(name)
        self.rest.start(REST_MS)

    def _go_on(self) -> None:
        if QApplication.activePopupWidget() is not None and next(self._work, self) is None:
            self.rest.start(0)

    def _pieces(self, name: str) -> Iterator[None]:
        try:
            step = ShownData.of(self._files.begun(name), self._files.scene(name))
        except Refusal:  # it is reported when the scene is chosen
            return
        yield
        yield from self._look.draw_ahead([step])
