"""VTK's off-screen windows: with a display or without, through X, EGL or Mesa alone."""

import atexit
import functools
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (without it no window is one of OpenGL)
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import (
    vtkActor2D,
    vtkCamera,
    vtkPolyDataMapper2D,
    vtkRenderer,
    vtkRenderWindow,
)

from app.languages import said
from app.model.parameter import read_content

Pixels: TypeAlias = NDArray[np.uint8]

_SMALL_PX = 8, 8
_WINDOW_CHOICE, _EGL = "VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow"
_FXAA = read_content(Path(__file__).with_name("content") / "fxaa.glsl")


make_window: Callable[[], Any] | None = None
"""Makes windows that draw through Qt, on Windows where VTK itself has no OpenGL 3.2."""


@functools.cache
def check_off_screen() -> Any:
    """Raise RuntimeError, with what to do, if VTK cannot draw without a window.

    With too little OpenGL, VTK would end the process. An X server without a client may start anew,
    and refuses who comes meanwhile: the window that was tried is kept, and EGL needs no server.
    """
    if make_window is not None:
        return None
    # No warnings about the search through X, EGL and Mesa, if it leads to a picture.
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)
    window = _tried()
    if window is None and sys.platform == "linux" and _WINDOW_CHOICE not in os.environ:
        os.environ[_WINDOW_CHOICE] = _EGL
        window_that_draws.cache_clear()
        window = _tried()
    if window is None:
        raise RuntimeError(said("no-opengl"))
    return window


def _tried() -> Any:
    """Return a window if it can draw, or None."""
    window: Any = window_that_draws()()
    window.SetOffScreenRendering(1)
    # VTK's last resort, a missing library, reports support untested.
    can_draw = window.SupportsOpenGL() and "Not tested" not in window.GetOpenGLSupportMessage()
    return window if can_draw else None


class OffScreen:
    """A render window that is on no screen, and its one renderer.

    A `pyvista.Plotter` would have three more layers and take longer to import than to draw.
    """

    def __init__(self, width: int, height: int) -> None:
        self.render_window: Any = (make_window or window_that_draws())()
        self.render_window.SetOffScreenRendering(1)
        if hasattr(self.render_window, "SetConnectContextToNSView"):  # macOS: in any thread, then
            self.render_window.SetConnectContextToNSView(False)
        self.clear(width, height)
        self.render_window.SetAlphaBitPlanes(1)
        self.render_window.Initialize()  # an X window crashes without it when it is released
        self._is_quick = False

    def clear(self, width: int, height: int) -> None:
        """Return to the first state, in another size, but keep the compiled shaders."""
        window = self.render_window
        for event in ("StartEvent", "EndEvent"):  # a window of Qt's has observers of its own
            window.RemoveObservers(event)
        for renderer in list(window.GetRenderers()):
            window.RemoveRenderer(renderer)
        window.SetNumberOfLayers(1)
        window.SetMultiSamples(0)
        window.SwapBuffersOn()
        window.SetSize(width, height)
        self.renderer = new_renderer(window)

    def quicken_fxaa(self) -> None:
        """Draw FXAA by our own shader; for a screen without a drawing.

        A software renderer runs all of VTK's for every pixel, also where it returns early. Ours
        leaves a loop there, and draws the same in half the time.
        """
        if self._is_quick:
            return
        self._is_quick, window, size = True, self.render_window, self.render_window.GetSize()
        window.SetSize(*_SMALL_PX)
        nothing, mapper = vtkActor2D(), vtkPolyDataMapper2D()  # without a prop VTK smooths nothing
        mapper.SetInputData(vtkPolyData())
        nothing.SetMapper(mapper)
        self.renderer.AddViewProp(nothing)
        self.renderer.UseFXAAOn()
        window.Render()
        program = window.GetShaderCache().GetLastShaderBound()
        source = "" if program is None else program.GetFragmentShader().GetSource()
        head, main, _ = source.partition("void main()")
        if main and "EndpointSearchIterations" in head:
            program.GetFragmentShader().SetSource(head + _FXAA)
            program.ReleaseGraphicsResources(window)  # the next picture compiles it
        self.renderer.UseFXAAOff()
        self.renderer.RemoveViewProp(nothing)
        window.SetSize(*size)

    def close(self) -> None:
        self.render_window.Finalize()

    def give_back(self) -> None:
        """Keep the window for the next screen, or close it if enough are kept."""
        if len(kept) == _MOST_KEPT:
            self.close()
            return
        self.clear(*_SMALL_PX)
        self.render_window.Render()  # which gives the large picture's memory back
        self.render_window.ReleaseCurrent()
        kept.append(self)


def new_renderer(window: Any) -> Any:
    """Return another renderer of a window, with a camera of its own."""
    renderer = vtkRenderer()
    renderer.SetActiveCamera(vtkCamera())
    window.AddRenderer(renderer)
    return renderer


_MOST_KEPT = 3  # as many as a window has panes
kept: list[OffScreen] = []


def take_screen(width: int, height: int) -> OffScreen:
    """Return a screen that was given back, or a new one.

    To create a window and its shaders takes longer than to draw a picture.
    """
    if not kept:
        return OffScreen(width, height)
    screen = kept.pop()
    screen.clear(width, height)
    return screen


@contextmanager
def off_screen(width: int, height: int) -> Iterator[OffScreen]:
    """Draw off the screen; give the screen back afterwards, unless an exception occurs."""
    screen = take_screen(width, height)
    try:
        yield screen
    except BaseException:
        screen.close()
        raise
    screen.give_back()


@atexit.register
def close_kept() -> None:
    """Close the windows that are kept for the next screens."""
    while kept:
        kept.pop().close()


@functools.cache
def window_that_draws() -> type:
    """The class of VTK's windows that works here. VTK tries each that it may choose."""
    if sys.platform != "linux" or os.environ.get("DISPLAY") or _WINDOW_CHOICE in os.environ:
        return type(vtkRenderWindow())
    # Without a display, trying X would cause a warning.
    os.environ[_WINDOW_CHOICE] = _EGL
    try:
        return type(vtkRenderWindow())
    finally:
        del os.environ[_WINDOW_CHOICE]


def pixels_of(window: Any) -> Pixels:
    """Return the pixels of a render window, (height, width, 4), the first row at the top."""
    width, height = window.GetSize()
    buffer = vtkUnsignedCharArray()
    window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, buffer)
    pixels: Pixels = vtk_to_numpy(buffer).reshape(height, width, 4)[::-1]  # type: ignore[no-untyped-call]
    return pixels
