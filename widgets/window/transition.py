"""The way from one step to the next: cameras move, or the old picture fades.

::

    Lessons --begin--> remembers what is seen --start--> the window shows the end already
            --go(part)--> cameras and fade follow, 0 to 1
"""

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QEvent, QObject, QRect, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPixmap
from PySide6.QtWidgets import QWidget

from widgets.parts.layouts import paint_now
from widgets.parts.motion import system_reduces_motion
from widgets.window.look import Look
from widgets.window.settings import Settings


class _Old(QWidget):
    """The picture of the step before, while it fades."""

    def __init__(self, over: QWidget) -> None:
        super().__init__(over)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._picture, self._light = QPixmap(), 0.0
        self.hide()

    def begin(self, picture: QPixmap, place: QRect) -> None:
        self._picture, self._light = picture, 1.0
        self.setGeometry(place)
        self.show()
        self.raise_()

    def fade(self, light: float) -> None:
        self._light = light
        if light <= 0.0:
            self._picture = QPixmap()
            self.hide()
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.setOpacity(self._light)
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            painter.drawPixmap(self.rect(), self._picture)


class Transition(QObject):
    """Moves the panes' cameras between two steps, or fades the slide if the scene changes.

    `is_for_class` says whether a class looks on; otherwise nothing fades.
    """

    def __init__(
        self, look: Look, slide: QWidget, settings: Settings, is_for_class: Callable[[], bool]
    ) -> None:
        super().__init__(slide)
        self._look, self._slide, self._settings = look, slide, settings
        self._is_for_class = is_for_class
        self._poses: dict[str, Any] = {}
        self._picture: QPixmap | None = None
        self._old = _Old(slide)
        slide.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Let the old picture be as large as the slide: the strip below it comes and goes."""
        if event.type() == QEvent.Type.Resize:
            self._old.resize(self._slide.size())
        return False

    @property
    def is_wanted(self) -> bool:
        """Whether something may move: neither the system nor the user reduces motion."""
        chosen = self._settings.reduce_motion
        return not (system_reduces_motion() if chosen is None else chosen)

    def begin(self, *, cuts: bool) -> bool:
        """Remember what is seen; `cuts` if another scene comes, or another slide.

        Return whether the picture will fade.
        """
        self._poses, self._picture = self._look.poses(), None
        if cuts and self._is_for_class() and self._slide.isVisible():
            self._picture = self._slide.grab()
        return self._picture is not None

    def start(self, moves: bool) -> bool:
        """Begin the way to what is shown now; return whether there is one.

        `moves` says whether the model itself moves.
        """
        if self._picture is not None:
            self._old.begin(self._picture, self._slide.rect())
            self._picture = None
            return True
        now = self._look.poses()
        glides = {
            name: pose
            for name, pose in self._poses.items()
            if pose is not None and now[name] is not None and not pose.is_near(now[name])
        }
        if glides or moves:
            self._look.begin_glide(glides)
        return bool(glides) or moves

    def paint(self) -> None:
        """Paint the beginning now: what takes long is done before the way begins."""
        paint_now(self._slide.window())

    def go(self, part: float) -> None:
        if not self._old.isHidden():  # the slide itself may be hidden
            self._old.fade(1.0 - part)
        self._look.glide(part)
