"""Windows for tests: opened, closed without a trace, and one that is lent to many tests.

A test that only wants the window as it opens, on the letter F and at rest, is lent one. After it
the window is put back by what a user would do, and all that can be seen of it is compared with how
it opened. Where anything differs it is closed, and the next test is lent another: so no test can
tell whether it is the first, and nothing needs to be known of what the one before did.
"""

from __future__ import annotations

import gc
import weakref
from collections.abc import Callable, Iterator
from types import FunctionType
from typing import Any, ClassVar

from PySide6.QtCore import QEvent, QObject, QPoint, QSize, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu, QStackedWidget, QWidget

from app.document.document import Document
from tests import PATIENCE_MS
from tests.support.window import pixels, settle
from widgets.window.main_window import MainWindow


def opened(document: Document, *, shown: bool = True, **options: Any) -> MainWindow:
    """A window, with all panes drawn if it is shown."""
    options.setdefault("software_rendering", True)
    window = MainWindow(document, **options)
    if shown:
        window.show()
        assert QTest.qWaitForWindowExposed(window, PATIENCE_MS)
        views = [pane.canvas.render_window for pane in window.panes.values()]
        for _ in range(PATIENCE_MS):
            if not any(view.GetNeverRendered() for view in views):
                break
            QTest.qWait(1)
    return window


def close(windows: list[MainWindow]) -> None:
    """Close windows, the last first, and see that no interactor outlives them."""
    canvases = [weakref.ref(pane.canvas) for window in windows for pane in window.panes.values()]
    while windows:
        windows[-1].setFocus()  # or what a test has left in a field is entered, and asked about
        windows[-1].store.mark_saved()
        windows[-1].close()
        windows.pop().deleteLater()
    QApplication.processEvents()
    delete_what_is_due()
    gc.collect()
    survivors = [ref for ref in canvases if ref() is not None]
    assert not survivors, f"{len(survivors)} interactors outlive their windows"


def delete_what_is_due() -> None:
    """What no nested loop does: deliver the events of `deleteLater`."""
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)


READ = (
    *("text", "value", "minimum", "maximum", "isChecked", "currentIndex", "placeholderText"),
    *("toolTip", "accessibleName", "accessibleDescription", "isEnabled", "isWindow"),
    *("cursorPosition", "selectedText", "count", "styleSheet"),
)
"""What can be seen of a widget, or heard."""
CHOSEN = ("isChecked", "currentIndex")


class Lent:
    """A window that is lent to one test after the other.

    Parameters
    ----------
    make : callable
        Opens one.
    """

    _as_opened: ClassVar[list[Any]] = []
    """What is seen of the first that was put back; they all open alike."""

    def __init__(self, make: Callable[[], MainWindow]) -> None:
        self._make = make
        self._windows: list[MainWindow] = []
        self._start: tuple[Document, float, QSize]
        self._is_good = True

    def lend(self) -> MainWindow:
        """The window as it opens, at rest."""
        if not self._is_good:
            self.put_away()
        if not self._windows:
            window = self._make()
            settle()
            self._windows.append(window)
            self._start = window.store.document, window.strip.position, window.size()
            if not self._as_opened:
                self._put_back()
                self._as_opened.extend(_seen(window))
        return self._windows[-1]

    def take_back(self) -> None:
        """Put the window back as it opened, or see to it that nobody is lent it any more."""
        self._is_good = self._is_as_it_opened()

    def put_away(self) -> None:
        """Close the window, if there is one."""
        self._is_good = True
        close(self._windows)

    def _is_as_it_opened(self) -> bool:
        window = self._windows[-1]
        if not window.isVisible() or QApplication.activeModalWidget() is not None:
            return False
        if _lasting(window) != self._as_opened[0]:
            return False
        try:
            self._put_back()
        except Exception:  # by what the test has put into the place of something
            return False
        return list(_seen(window)) == self._as_opened

    def _put_back(self) -> None:
        window, (document, stage, size) = self._windows[-1], self._start
        window.setFocus()
        window.resize(size)
        while window.store.in_gesture:
            window.store.end_gesture()
        window.controls.animation.pause()
        window.scene_panel.pause()
        window.strip.go_to(stage)
        window.frame_panel.go_to(0)
        window.probe_panel.clear()
        window.panels.open(None)
        window.pane_row.show_all()
        window.messages.hide()
        window.store.open(document)
        window.pane_row.reset_views()
        QTest.mouseMove(window.windowHandle(), QPoint(window.width() - 2, 2))
        for pane in window.panes.values():  # or it knows nothing of it: it was sent events
            QApplication.sendEvent(pane.canvas, QEvent(QEvent.Type.Leave))
        settle()
        delete_what_is_due()
        _let_time_pass(window)


def _lasting(window: MainWindow) -> tuple[str, ...]:
    """What is not put back: the file's name, the look, the settings."""
    font = QApplication.font().toString()
    return window.windowTitle(), font, repr(vars(window.settings))


def _let_time_pass(window: MainWindow) -> None:
    """What waits for the hand to rest happens now."""
    for timer in window.findChildren(QTimer):
        if timer.isActive() and timer.isSingleShot():
            interval = timer.interval()
            timer.start(0)
            settle()
            timer.setInterval(interval)
    settle()


def _seen(window: MainWindow) -> Iterator[Any]:
    """All that can be seen of a window, and which methods are not its own any more."""
    yield _lasting(window)
    yield window.isWindowModified(), window.store.can_undo, window.store.can_redo
    yield window.store.document
    # In no order: a pane that was in a window of its own comes last of its brothers.
    menus = window.menuBar().findChildren(QMenu)
    actions = [action for menu in menus for action in menu.actions()]
    yield sorted((a.text(), a.isEnabled(), a.isChecked(), a.isVisible()) for a in actions)
    widgets = (window, *window.findChildren(QWidget))
    yield sorted(map(_of_widget, widgets))
    drawings = [pane.drawing for pane in window.panes.values()]
    for owner in (*window.findChildren(QObject), *drawings):
        put = [name for name, value in vars(owner).items() if isinstance(value, FunctionType)]
        if any(hasattr(type(owner), name) for name in put):
            yield type(owner), put
    for name in window.panes:
        yield pixels(window, name).tobytes()


def _of_widget(widget: QWidget) -> str:
    seen = widget.isVisible()  # or its words are written when it is shown, as it was chosen to be
    read = (getattr(widget, name, None) for name in (READ if seen else CHOSEN))
    values = [value() if callable(value) else value for value in read]
    told = [value for value in values if isinstance(value, str | int | float)]
    if isinstance(widget, QStackedWidget):  # which of the folded was open is nobody's choice
        told = []
    return repr((type(widget), told, seen and widget.geometry().getRect()))
