"""Presenting (F5): the panes and the controls that matter fill the screen, and nothing else.

Letters, lines and handles are a share of the screen's height, so that the back row can read them
on every projector.
"""

from __future__ import annotations

from PySide6.QtCore import QByteArray, QEvent, QObject, Qt, Signal
from PySide6.QtGui import QEnterEvent, QMouseEvent
from PySide6.QtWidgets import QApplication, QMainWindow, QToolBar, QWidget

TOP_EDGE_PX = 3
"""The mouse so near to the top of the screen calls the tool bar."""


class _Edge(QWidget):
    """The top edge of the window."""

    entered = Signal()

    def enterEvent(self, event: QEnterEvent) -> None:
        super().enterEvent(event)
        self.entered.emit()


class _Blank(QWidget):
    """Black over all, until it is clicked."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setStyleSheet("background: black")
        self.setCursor(Qt.CursorShape.BlankCursor)
        self.hide()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        event.accept()
        self.hide()


class Present(QObject):
    """Turns one window into what a class sees, and back.

    Parameters
    ----------
    window : QMainWindow
    tools : QToolBar
        Shown on demand: when the mouse is at the top of the screen.
    below : QWidget
        The bottom row, which a class has no use for.
    """

    switched = Signal(bool)
    """It began, or ended: text and lines get another size."""

    def __init__(self, window: QMainWindow, tools: QToolBar, below: QWidget) -> None:
        super().__init__(window)
        self._window, self._tools, self._below = window, tools, below
        self._state = Qt.WindowState.WindowNoState
        self.is_on = False
        self.geometry_before = QByteArray()
        """Of the ordinary window, while presenting: where it is to be found the next time."""
        self._blank, self._edge = _Blank(window), _Edge(window)
        self._edge.hide()
        self._edge.entered.connect(lambda: self.show_tools(True))

    def toggle(self) -> None:
        """Begin or end it."""
        self.end() if self.is_on else self.begin()

    def begin(self) -> None:
        """Fill the screen."""
        if self.is_on:
            return
        self.is_on = True
        self._state = self._window.windowState()
        self.geometry_before = self._window.saveGeometry()
        self._reveal(False)
        self._window.setWindowState(self._state | Qt.WindowState.WindowFullScreen)
        self._cover()  # it may fill the screen already
        for watched in (self._window, self._tools):
            watched.installEventFilter(self)
        self.switched.emit(True)

    def end(self) -> None:
        """Be the window of before."""
        if not self.is_on:
            return
        self.is_on = False
        self.geometry_before = QByteArray()
        self._blank.hide()
        for watched in (self._window, self._tools):
            watched.removeEventFilter(self)
        self._window.setWindowState(self._state)
        self._reveal(True)
        self.switched.emit(False)

    def blank(self) -> None:
        """Let the class see nothing, or the panes again: only while presenting."""
        if self.is_blank:
            self._blank.hide()
        elif self.is_on:
            self._blank.raise_()
            self._blank.show()

    @property
    def is_blank(self) -> bool:
        """Whether nothing is seen."""
        return self._blank.isVisible()

    def leave(self) -> None:
        """Leave what is on top of it, or it."""
        if self.is_blank:
            self._blank.hide()
        else:
            self.end()

    def show_tools(self, seen: bool) -> None:
        """Show the tool bar while presenting, or hide it."""
        if self.is_on:
            self._tools.setVisible(seen)
            self._edge.setVisible(not seen)
            self._edge.raise_()

    def _cover(self) -> None:
        self._blank.setGeometry(self._window.rect())
        self._edge.setGeometry(0, 0, self._window.width(), TOP_EDGE_PX)

    def _reveal(self, seen: bool) -> None:
        for widget in (self._window.menuBar(), self._tools, self._below):
            widget.setVisible(seen)
        self._edge.setVisible(not seen)
        self._edge.raise_()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if watched is self._tools:
            if kind == QEvent.Type.Leave and QApplication.activePopupWidget() is None:
                self.show_tools(False)
        elif kind == QEvent.Type.Resize:
            self._cover()
        elif kind == QEvent.Type.WindowStateChange and not self._window.isFullScreen():
            self.end()  # the system has its own keys for that
        return super().eventFilter(watched, event)
