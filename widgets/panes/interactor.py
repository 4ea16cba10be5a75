"""pyvistaqt's interactor, for a canvas with OpenGL."""

from __future__ import annotations

import importlib
import sys
import time
from types import ModuleType
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QResizeEvent, QSurfaceFormat

PYPLOT = "matplotlib.pyplot"


def _imported_without_pyplot(name: str) -> Any:
    """Import a module that imports pyplot without using it: pyplot takes as long as VTK.

    The module gets a stand-in, which imports pyplot when it is used.
    """
    if PYPLOT in sys.modules:
        return importlib.import_module(name)

    def given(wanted: str) -> Any:
        if wanted.startswith("__"):  # tools read these names of every module
            raise AttributeError(wanted)
        return getattr(importlib.import_module(PYPLOT), wanted)

    late = ModuleType(PYPLOT)
    late.__getattr__ = given  # type: ignore[method-assign]
    sys.modules[PYPLOT] = late
    try:
        return importlib.import_module(name)
    finally:
        del sys.modules[PYPLOT]


if TYPE_CHECKING:
    from pyvistaqt import QtInteractor
else:
    QtInteractor = _imported_without_pyplot("pyvistaqt").QtInteractor

_WIDE_LINES = QSurfaceFormat.FormatOption.DeprecatedFunctions


class Interactor(QtInteractor):
    """VTK draws into it; mouse and keys go to the canvas (a `GlCanvas`) behind it."""

    def __init__(self, canvas: Any) -> None:
        super().__init__(canvas, auto_update=False, multi_samples=0)
        self._canvas = canvas
        if QGuiApplication.platformName() in ("xcb", "windows"):
            # VTK's own windows have it; without it a shader widens lines, to other pixels. (Not on
            # Wayland, where a widget with its own format stays black.)
            wanted = self.format()
            wanted.setOption(_WIDE_LINES)
            self.setFormat(wanted)
        self.setAcceptDrops(False)  # the window takes drops; pyvistaqt would add the file here
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._resizing = False

    def initializeGL(self) -> None:
        super().initializeGL()  # type: ignore[no-untyped-call]
        if self.context().format().testOption(_WIDE_LINES):
            window: Any = self.render_window
            window.SetForceMaximumHardwareLineWidth(0.0)  # pyvistaqt's is 1

    def resizeGL(self, w: int, h: int) -> None:
        super().resizeGL(w, h)  # type: ignore[no-untyped-call]
        window: Any = self.render_window
        ratio = self._canvas.pixel_ratio
        if ratio != self.devicePixelRatioF():
            sides = (max(1, round(side * ratio)) for side in (w, h))
            window.GetInteractor().UpdateSize(*sides)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._resizing = True
        try:
            super().resizeEvent(event)
        finally:
            self._resizing = False

    def paintGL(self) -> None:
        window: Any = self.render_window
        if self._resizing and window.GetNeverRendered():
            return  # Qt draws again when it shows the widget
        began = time.perf_counter()
        super().paintGL()  # type: ignore[no-untyped-call]
        self._canvas.drawn.emit()
        if not self._canvas.timed:
            return
        window.WaitForCompletion()  # drawing goes on after the call otherwise
        self._canvas.painted.emit(1e3 * (time.perf_counter() - began))
