"""Counts the pixels that a phenomenon predicts, in a picture off the screen.

Nothing is counted until `REST_MS` after the last change.
"""

import math
from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer, Signal

from app.model.projection import Projection
from app.scenes.phenomena.illustration import Illustration
from app.scenes.scene import Scene
from widgets.panes.canvas import release_context
from widgets.parts.panel import Changed, ShownData

REST_MS = 250
PIXELS = 130_000  # size of the picture: precise to 0.3 points of a share, within 100 ms in software
LONGEST_PX = 1000
MOST_FACES = 20_000  # a larger mesh would block the window: its share is only predicted


class Counting(QObject):
    """Counts the pixels of one illustration when it has not changed for a while.

    `busy` returns whether a control is held or something plays.
    """

    concerns = frozenset({"illustration"})
    counted = Signal(object, float)
    """The `Illustration`, and the share of its wrong pixels, 0..1; NaN if they are few."""

    def __init__(self, busy: Callable[[], bool], parent: QObject) -> None:
        super().__init__(parent)
        self._busy = busy
        self._shown: tuple[Scene, Projection, Illustration] | None = None
        self._timer = QTimer(self, singleShot=True, interval=REST_MS)
        self._timer.timeout.connect(self._rest)

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Count this illustration once nothing changes any more."""
        self.stop()
        if shown.illustration is not None and shown.illustration.rendering is not None:
            self._shown = shown.scene, shown.projection, shown.illustration
            self._timer.start()

    def stop(self) -> None:
        self._shown = None
        self._timer.stop()

    def _rest(self) -> None:
        if self._busy():
            self._timer.start()
        elif self._shown is not None:
            share = self._count(*self._shown)
            if share is not None:
                self.counted.emit(self._shown[2], share)

    def _count(
        self, scene: Scene, projection: Projection, illustration: Illustration
    ) -> float | None:
        rendering = illustration.rendering
        if not any(reading.counted for reading in illustration.readings) or rendering is None:
            return None
        if rendering.buffer is None or not (illustration.copies and 0 < scene.faces <= MOST_FACES):
            return None
        from app.drawings.off_screen import off_screen
        from app.drawings.rasterising import counted_wrong_share

        release_context()
        wide = math.sqrt(PIXELS * projection.aspect)
        width, height = (
            max(1, min(LONGEST_PX, round(side))) for side in (wide, wide / projection.aspect)
        )
        with off_screen(width, height) as screen:
            return counted_wrong_share(
                screen, scene, projection, rendering.buffer, illustration.copies[0].world_from_world
            )
