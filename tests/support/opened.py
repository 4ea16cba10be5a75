"""Windows for tests: opened with all panes drawn, and closed without a trace."""

import gc
import weakref
from typing import Any

from PySide6.QtCore import QEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QSpacerItem, QWidgetItem
from shiboken6.Shiboken import createdByPython, getAllValidWrappers

from app.document.document import Document
from tests import PATIENCE_MS
from tests.support.keys import clashes
from widgets.window.main_window import MainWindow


def opened(
    document: Document, *, shown: bool = True, drawn: bool = True, **options: Any
) -> MainWindow:
    """A window, with all panes drawn if it is shown; or with none, for what needs no pictures."""
    options.setdefault("software_rendering", True)
    window = MainWindow(document, **options)
    if drawn:
        for pane in window.panes.values():
            pane.open()
    if shown:
        window.show()
        assert QTest.qWaitForWindowExposed(window, PATIENCE_MS)
        views = [pane.canvas.render_window for pane in window.panes.values()] if drawn else []
        for _ in range(PATIENCE_MS):
            if not any(view.GetNeverRendered() for view in views):
                break
            QTest.qWait(1)
    return window


def close(windows: list[MainWindow]) -> None:
    """Close windows, the last first, and see that no interactor outlives them.

    Nor may PySide hold an item of a layout that Qt has made: what comes to lie in its place is
    taken for it. Nor may a key mean two things in the state that a test has led to.
    """
    ambiguous = [found for window in windows if (found := clashes(window))]
    items = [one for one in getAllValidWrappers() if isinstance(one, (QSpacerItem, QWidgetItem))]
    held = sum(not createdByPython(item) for item in items)
    del items
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
    assert not ambiguous, f"keys that mean two things: {ambiguous}"
    assert not held, f"PySide holds {held} items of layouts"
    assert not survivors, f"{len(survivors)} interactors outlive their windows"
    if not any(isinstance(widget, MainWindow) for widget in QApplication.topLevelWidgets()):
        gc.freeze()  # what has stayed until now is not searched after the next window


def delete_what_is_due() -> None:
    """What no nested loop does: deliver the events of `deleteLater`."""
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
