"""VTK's pictures through Qt's OpenGL: in a QOpenGLWidget, and off the screen.

As in VTK's QVTKOpenGLNativeWidget, which has no Python: VTK draws into framebuffers of its own in
Qt's context, and the result is copied into the widget's framebuffer.
"""

import ctypes
import time
from contextlib import suppress
from typing import Any

from PySide6 import QtGui
from PySide6.QtCore import Qt
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import vtkGenericOpenGLRenderWindow

_WIDE_LINES = QtGui.QSurfaceFormat.FormatOption.DeprecatedFunctions
_COLOR_BUFFER, _DRAW_FRAMEBUFFER, _LINEAR = 0x4000, 0x8CA9, 0x2601
_DEPTH_TEST, _LESS_OR_EQUAL, _SCISSOR_TEST = 0x0B71, 0x0203, 0x0C11
_Loader = ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_char_p)

_MAKE_CURRENT, _IS_CURRENT = "WindowMakeCurrentEvent", "WindowIsCurrentEvent"


class _QtOpenGL:
    """A context of Qt's, in which a window of VTK's draws."""

    def __init__(self, window: Any, context: QtGui.QOpenGLContext, surface: QtGui.QSurface) -> None:
        self._context, self._surface = context, surface
        window.AddObserver(_MAKE_CURRENT, self.make_current)
        window.AddObserver(_IS_CURRENT, self._set_current)
        # On Windows without a driver, Qt's is not the system's, which VTK would ask.
        self._load = _Loader(context.getProcAddress)
        window.SetOpenGLSymbolLoader2(ctypes.cast(self._load, ctypes.c_void_p).value, 0)
        window.OpenGLInitContext()
        window.OpenGLInit()
        state = window.GetState()
        state.Reset()
        state.vtkglDepthFunc(_LESS_OR_EQUAL)  # Qt leaves another
        state.vtkglEnable(_DEPTH_TEST)
        has_wide_lines = context.format().testOption(_WIDE_LINES)
        window.SetForceMaximumHardwareLineWidth(0.0 if has_wide_lines else 1.0)
        window.SetReadyForRendering(True)
        window.SetOwnContext(0)

    def make_current(self, *_: object) -> None:
        """Not by a widget's `makeCurrent`, which would bind its framebuffer while VTK draws."""
        with suppress(RuntimeError):  # Qt may have ended before
            self._context.makeCurrent(self._surface)

    def _set_current(self, window: Any, _event: str) -> None:
        window.SetIsCurrent(QtGui.QOpenGLContext.currentContext() is self._context)


def window_off_screen() -> Any:
    """Return a window of VTK's that draws through Qt, for `app.drawings.off_screen`."""
    wanted = QtGui.QSurfaceFormat.defaultFormat()
    wanted.setOption(_WIDE_LINES)
    surface, context = QtGui.QOffscreenSurface(), QtGui.QOpenGLContext()
    surface.setFormat(wanted)
    surface.create()
    context.setFormat(wanted)
    context.create()
    context.makeCurrent(surface)
    window = vtkGenericOpenGLRenderWindow()
    window.SetFrameBlitModeToNoBlit()
    _QtOpenGL(window, context, surface)  # which its observers keep
    return window


class Interactor(QOpenGLWidget):
    """VTK draws into it; mouse and keys go to the canvas (a `GlCanvas`) behind it."""

    def __init__(self, canvas: Any) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        if QtGui.QGuiApplication.platformName() in ("xcb", "windows"):
            # VTK's own windows have it; without it a shader widens lines, to other pixels. (Not on
            # Wayland, where a widget with its own format stays black.)
            wanted = self.format()
            wanted.setOption(_WIDE_LINES)
            self.setFormat(wanted)
        self.setUpdateBehavior(QOpenGLWidget.UpdateBehavior.NoPartialUpdate)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self._resizing = False
        self._opengl: _QtOpenGL | None = None
        self.renderer: Any = vtkRenderer()
        self.renderer.SetActiveCamera(vtkCamera())
        self.render_window: Any = vtkGenericOpenGLRenderWindow()
        self.render_window.SetMultiSamples(0)
        self.render_window.SetReadyForRendering(False)
        self.render_window.SetFrameBlitModeToNoBlit()
        self.render_window.AddRenderer(self.renderer)

    def initializeGL(self) -> None:
        window = self.render_window
        context = self.context()
        context.aboutToBeDestroyed.connect(self._release)
        self._opengl = _QtOpenGL(window, context, context.surface())

    def _release(self) -> None:
        """Free what VTK has in the context, while it is there; nothing is drawn afterwards."""
        if self._opengl is None:
            return
        self._opengl.make_current()
        self.render_window.Finalize()
        self.render_window.SetReadyForRendering(False)
        for event in (_MAKE_CURRENT, _IS_CURRENT):
            self.render_window.RemoveObservers(event)
        self._opengl = None

    def closeEvent(self, event: QtGui.QCloseEvent) -> None:
        self._release()
        super().closeEvent(event)

    def resizeGL(self, w: int, h: int) -> None:
        ratio = self._canvas.pixel_ratio
        self.render_window.SetSize(*(max(1, round(side * ratio)) for side in (w, h)))

    def resizeEvent(self, event: QtGui.QResizeEvent) -> None:
        self._resizing = True
        try:
            super().resizeEvent(event)
        finally:
            self._resizing = False

    def paintGL(self) -> None:
        window = self.render_window
        if not window.GetReadyForRendering():
            return
        if self._resizing and window.GetNeverRendered():
            return  # Qt draws again when it shows the widget
        began = time.perf_counter()
        state = window.GetState()
        state.Reset()  # Qt has drawn since
        state.Push()
        state.vtkglDepthFunc(_LESS_OR_EQUAL)
        window.Render()
        self.makeCurrent()
        self._copy()
        state.Pop()
        self._canvas.emit_drawn()
        if self._canvas.timed:
            window.WaitForCompletion()  # drawing goes on after the call otherwise
            self._canvas.painted.emit(1e3 * (time.perf_counter() - began))

    def _copy(self) -> None:
        """Copy VTK's picture into the widget's framebuffer, as opaque."""
        ratio = self.devicePixelRatioF()
        width, height = (max(1, round(side * ratio)) for side in (self.width(), self.height()))
        functions = self.context().functions()
        functions.glBindFramebuffer(_DRAW_FRAMEBUFFER, self.defaultFramebufferObject())
        self.render_window.GetState().vtkglDisable(_SCISSOR_TEST)
        self.render_window.BlitDisplayFramebuffer(
            0, 0, 0, *self.render_window.GetSize(), 0, 0, width, height, _COLOR_BUFFER, _LINEAR
        )
        functions.glColorMask(False, False, False, True)
        functions.glClearColor(0.0, 0.0, 0.0, 1.0)
        functions.glClear(_COLOR_BUFFER)
        functions.glColorMask(True, True, True, True)
