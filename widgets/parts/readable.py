"""Show running numbers only as often as they can be read, and when the input stops.

::

    changed --no gesture------------------------------> show, at once
            --in a gesture, after a rest--------------> show, at once: before the panes are drawn
            --in a gesture, every READ_MS and STEPS---> show, likewise
            --in a gesture, sooner--------------------> show, when it rests or ends

Most steps of a drag then cost no more than without the numbers, on any machine, and the last value
is always shown.
"""

import time
from abc import abstractmethod
from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

from app.drawings.style import LIGHT, Style
from widgets.parts.panel import Panel
from widgets.parts.writing import all_digits

READ_MS = 100  # digits that change more often cannot be read
STEPS = 3  # if steps are slow, the numbers are shown once in so many steps


class Readable(QObject):
    """Decides when a widget shows changed values: never while it is hidden.

    The widget's showEvent must call `settle`, as that of a `ReadablePanel` does. `is_seen` says
    whether the values can be seen; by default, whether the widget is visible.
    """

    def __init__(
        self, widget: QWidget, show: Callable[[], None], is_seen: Callable[[], bool] | None = None
    ) -> None:
        super().__init__(widget)
        self._show, self._is_seen = show, is_seen or widget.isVisible
        self._gestures = 0
        self._pending = False
        self._shown_ms = float("-inf")
        self._steps = STEPS  # steps since values were shown
        self._rest = QTimer(self, singleShot=True, interval=READ_MS)
        self._rest.timeout.connect(self._rested)

    @property
    def in_gesture(self) -> bool:
        """Whether values are changing: a control is dragged, or something plays."""
        return self._gestures > 0

    def begin_gesture(self) -> None:
        """Begin a gesture; gestures may overlap."""
        if not self._gestures:
            self._steps = STEPS
        self._gestures += 1

    def end_gesture(self) -> None:
        """End a gesture; after the last one its values are shown."""
        self._gestures = max(self._gestures - 1, 0)
        if not self._gestures:
            self.settle()

    def changed(self) -> None:
        """Show changed values, now or as soon as they can be read."""
        self._pending = True
        self._steps += 1
        early = self.now_ms() - self._shown_ms < READ_MS or self._steps < STEPS
        if self._gestures and early:
            self._rest.start()  # restarted at each step: steps that follow show it
        else:
            self.settle()

    def settle(self) -> None:
        """Show changed values now, if there are any."""
        self._rest.stop()
        if self._pending and self._is_seen():
            self._pending = False
            self._steps, self._shown_ms = 0, self.now_ms()
            try:
                self._show()
            except BaseException:
                self._pending = True  # the next time the widget appears, it tries again
                raise

    def _rested(self) -> None:
        self.settle()
        self._steps = STEPS

    def now_ms(self) -> float:
        return 1e3 * time.monotonic()


class ReadablePanel(Panel):
    """A panel whose running numbers are shown only as often as they can be read."""

    def __init__(self) -> None:
        super().__init__()
        self._readable = Readable(self, self._fill)
        self._style = LIGHT
        all_digits.changed.connect(self._readable.changed)

    @abstractmethod
    def _fill(self) -> None:
        """Show all current values."""

    def set_style(self, style: Style) -> None:
        self._style = style
        self._readable.changed()

    def begin_gesture(self) -> None:
        self._readable.begin_gesture()

    def end_gesture(self) -> None:
        self._readable.end_gesture()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._readable.settle()
