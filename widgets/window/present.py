"""Presenting (F5): the panes and the essential controls fill the screen.

With several screens, the class sees the secondary one and the speaker's notes are on the primary
one. `Screens` remembers for each pair of screens whether they are swapped.

Letters, lines and handles are a share of the screen's height, or of the width of an upright one, so
that the back row can read them on every projector.
"""

from PySide6.QtCore import QByteArray, QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QGuiApplication, QScreen, QWindowStateChangeEvent
from PySide6.QtWidgets import QApplication, QMainWindow, QToolBar, QWidget

from widgets.window.settings import Settings

TOP_EDGE_PX = 3  # the tool bar appears when the mouse is this close to the top of the screen


def readable_px(window: QWidget) -> float:
    """Return the height of a window's screen, or its width if it is upright: lines are shorter."""
    return float(min(window.screen().size().toTuple()))


class Screens:
    """Which screen the class sees, and which the speaker; the settings keep the swapped pairs."""

    def __init__(self, settings: Settings) -> None:
        self._settings = settings

    @property
    def both(self) -> tuple[QScreen, QScreen] | None:
        """The class's screen and the speaker's; None if there is only one screen."""
        primary = QGuiApplication.primaryScreen()
        others = [each for each in QGuiApplication.screens() if each is not primary]
        if not others:
            return None
        if self._pair in self._settings.swapped_screens:
            return primary, others[0]
        return others[0], primary

    def swap(self) -> bool:
        """Swap this pair of screens, now and in future; False if there is only one screen."""
        if self.both is None:
            return False
        kept, pair = self._settings.swapped_screens, self._pair
        others = [each for each in kept if each != pair]
        self._settings.swapped_screens = others if pair in kept else [*kept, pair]
        return True

    @property
    def _pair(self) -> str:
        names = (f"{each.name()} {each.model()}" for each in QGuiApplication.screens())
        return f"{QGuiApplication.primaryScreen().name()}: {', '.join(sorted(names))}"


class Present(QObject):
    """Shows one window as a class sees it, and back.

    The tool bar appears over the slide when the mouse is at the top of the screen; `below`, the
    bottom row, is hidden.
    """

    switched = Signal(bool)  # presenting began or ended: text and lines change their size
    moved = Signal()  # the class sees another screen, or its screen has another height
    blanked = Signal()  # the screen has become black, or is no longer
    one_screen = Signal()  # there is no other screen to swap with

    def __init__(
        self, window: QMainWindow, tools: QToolBar, below: QWidget, screens: Screens
    ) -> None:
        super().__init__(window)
        self.screens = screens
        self._window, self._tools, self._below = window, tools, below
        self._state = Qt.WindowState.WindowNoState
        self.is_on, self.screen_px = False, 0.0  # the height of the class's screen
        self.geometry_before = QByteArray()  # geometry of the ordinary window, while presenting
        self._blank, self._edge = QWidget(window), QWidget(window)
        """What covers the window in black until it is clicked, and the top edge of the window."""
        self._blank.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._blank.setStyleSheet("background: black")
        self._blank.setCursor(Qt.CursorShape.BlankCursor)
        for cover in (self._blank, self._edge):
            cover.hide()
            cover.installEventFilter(self)
        application = QApplication.instance()
        assert isinstance(application, QGuiApplication)
        application.screenAdded.connect(self._move, Qt.ConnectionType.QueuedConnection)

    def _fill(self) -> None:
        """Fill the class's screen, or the only one."""
        both = self.screens.both
        if both is not None and both[0] is not self._window.screen():
            self._window.setWindowState(Qt.WindowState.WindowNoState)  # full screen cannot move
            self._window.setGeometry(both[0].geometry())
            self._window.windowHandle().setScreen(both[0])
        self._window.setWindowState(self._state | Qt.WindowState.WindowFullScreen)
        self.screen_px = readable_px(self._window)

    def swap(self) -> None:
        if self.screens.swap():
            self._move()
        else:
            self.one_screen.emit()

    def _move(self) -> None:
        """Move to the class's screen after that has changed."""
        if self.is_on:
            self._window.removeEventFilter(self)  # on the way it is not full screen
            self._fill()
            self._window.installEventFilter(self)
            self._cover()
            self.moved.emit()

    def toggle(self) -> None:
        self.end() if self.is_on else self.begin()

    def begin(self) -> None:
        if self.is_on:
            return
        self.is_on = True
        self._state = self._window.windowState()
        self.geometry_before = self._window.saveGeometry()
        self._reveal(False)
        self._window.removeToolBar(self._tools)  # it comes over the slide, and moves nothing
        self._fill()
        self._cover()  # the window may fill the screen already
        for watched in (self._window, self._tools):
            watched.installEventFilter(self)
        self.switched.emit(True)

    def end(self) -> None:
        """Restore the ordinary window."""
        if not self.is_on:
            return
        self.is_on = False
        before, self.geometry_before = self.geometry_before, QByteArray()
        self._blank.hide()
        for watched in (self._window, self._tools):
            watched.removeEventFilter(self)
        self._window.setWindowState(self._state)
        if self.screens.both is not None:  # the window may come from another screen
            self._window.restoreGeometry(before)
        self.switched.emit(False)  # what is still hidden keeps its style
        self._window.addToolBar(self._tools)
        self._reveal(True)

    def blank(self) -> None:
        """While presenting, show the class a black screen, or the panes again."""
        if self.is_blank:
            self._blank.hide()
        elif self.is_on:
            self._blank.raise_()
            self._blank.show()

    @property
    def is_blank(self) -> bool:
        return self._blank.isVisible()

    def leave(self) -> None:
        """Leave the black screen; otherwise, stop presenting."""
        if self.is_blank:
            self._blank.hide()
        else:
            self.end()

    def show_tools(self, seen: bool) -> None:
        if self.is_on:
            self._tools.setVisible(seen)
            self._tools.raise_()
            self._edge.setVisible(not seen)
            self._edge.raise_()

    def _cover(self) -> None:
        self._blank.setGeometry(self._window.rect())
        self._edge.setGeometry(0, 0, self._window.width(), TOP_EDGE_PX)
        self._tools.setGeometry(0, 0, self._window.width(), self._tools.sizeHint().height())

    def _reveal(self, seen: bool) -> None:
        for widget in (self._window.menuBar(), self._tools, self._below):
            widget.setVisible(seen)
        self._edge.setVisible(not seen)
        self._edge.raise_()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if watched is self._blank:
            if kind in (QEvent.Type.Show, QEvent.Type.Hide):
                self.blanked.emit()
            if kind == QEvent.Type.MouseButtonPress:
                self._blank.hide()
                return True
        elif watched is self._edge:
            if kind == QEvent.Type.Enter:
                self.show_tools(True)
        elif watched is self._tools:
            if kind == QEvent.Type.Leave and QApplication.activePopupWidget() is None:
                self.show_tools(False)
        elif kind == QEvent.Type.Resize:
            self._cover()
            if readable_px(self._window) != self.screen_px:  # one was unplugged
                QTimer.singleShot(0, self, self._move)
        elif (
            isinstance(event, QWindowStateChangeEvent)
            and event.oldState() & Qt.WindowState.WindowFullScreen  # macOS takes a second for it
            and not self._window.isFullScreen()
        ):
            self.end()  # the window system has its own keys for that
        return super().eventFilter(watched, event)
