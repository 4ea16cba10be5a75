"""Numbers that run are shown as often as they can be read, and where the hand rests.

::

    changed --no gesture------------------------------> show, at once
            --in a gesture, after a rest--------------> show, at once: before the panes are drawn
            --in a gesture, every READ_MS and STEPS---> show, likewise
            --in a gesture, sooner--------------------> show, when it rests or ends

Most steps of a drag then cost no more than without what is read, however slow the machine is, and
it ends with the value it ends with.
"""

from __future__ import annotations

import time
from abc import abstractmethod
from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

from widgets.parts.panel import Panel
from widgets.parts.writing import all_digits

READ_MS = 100
"""Digits that change more often than this are not read."""
STEPS = 3
"""Of so many steps, one shows them, where steps are slow."""


class Readable(QObject):
    """When a widget shows what has changed: never while it is hidden.

    Parameters
    ----------
    widget : QWidget
        Who shows; its showEvent calls `settle`, as that of a `ReadablePanel` does.
    show : callable
        Shows the values as they are when it is called.
    """

    def __init__(self, widget: QWidget, show: Callable[[], None]) -> None:
        super().__init__(widget)
        self._widget, self._show = widget, show
        self._gestures = 0
        self._pending = False
        self._shown_ms = float("-inf")
        self._steps = STEPS
        """Since what changed was shown."""
        self._rest = QTimer(self, singleShot=True, interval=READ_MS)
        self._rest.timeout.connect(self._rested)

    @property
    def in_gesture(self) -> bool:
        """Whether values run: a control is dragged, or something plays."""
        return self._gestures > 0

    def begin_gesture(self) -> None:
        """From now on values run; gestures may overlap."""
        if not self._gestures:
            self._steps = STEPS
        self._gestures += 1

    def end_gesture(self) -> None:
        """End the gesture that `begin_gesture` began, with its last value."""
        self._gestures = max(self._gestures - 1, 0)
        if not self._gestures:
            self.settle()

    def changed(self) -> None:
        """Show what is to be seen now, at once or as soon as it can be read."""
        self._pending = True
        self._steps += 1
        early = self.now_ms() - self._shown_ms < READ_MS or self._steps < STEPS
        if self._gestures and early:
            self._rest.start()  # anew each time: while steps come, one of them shows it
        else:
            self.settle()

    def settle(self) -> None:
        """Show at once what has changed, if something has."""
        self._rest.stop()
        if self._pending and self._widget.isVisible():
            self._pending = False
            self._steps, self._shown_ms = 0, self.now_ms()
            try:
                self._show()
            except BaseException:
                self._pending = True  # what failed is shown on appearing again
                raise

    def _rested(self) -> None:
        self.settle()
        self._steps = STEPS

    def now_ms(self) -> float:
        """The clock, in ms."""
        return 1e3 * time.monotonic()


class ReadablePanel(Panel):
    """A panel whose numbers are shown as often as they can be read: `_fill` shows them."""

    def __init__(self) -> None:
        super().__init__()
        self._readable = Readable(self, self._fill)
        all_digits.changed.connect(self._readable.changed)

    @abstractmethod
    def _fill(self) -> None:
        """Show everything as it is now."""

    def begin_gesture(self) -> None:
        self._readable.begin_gesture()

    def end_gesture(self) -> None:
        self._readable.end_gesture()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._readable.settle()
