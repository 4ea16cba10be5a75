"""VTK's windows that are on no screen: with a display or without, through X, EGL or Mesa alone."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (without it no window is one of OpenGL)
from vtkmodules.vtkCommonCore import vtkLogger
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer, vtkRenderWindow

_WINDOW_CHOICE = "VTK_DEFAULT_OPENGL_WINDOW"


def check_off_screen() -> None:
    """Make sure that VTK can draw without a window: with less OpenGL it ends the process.

    Raises
    ------
    RuntimeError
        If it cannot: what to do, in one sentence.
    """
    # A search through X, EGL and Mesa that leads to a picture is nothing to warn of.
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)
    window: Any = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    # Its last resort, a library that is not there, says yes untested.
    if not window.SupportsOpenGL() or "Not tested" in window.GetOpenGLSupportMessage():
        raise RuntimeError(
            "There is no OpenGL 3.2 to draw with: update the graphics driver; on Linux install "
            "Mesa (libegl1 libegl-mesa0 libgl1-mesa-dri) or start with LIBGL_ALWAYS_SOFTWARE=1."
        )


class OffScreen:
    """A render window that is on no screen, and its one renderer: what a drawing is made in.

    It is VTK's own and no `pyvista.Plotter`, which has three layers more to draw and takes longer
    to import than all that is drawn here.

    Parameters
    ----------
    width, height : int
        Pixels.
    """

    def __init__(self, width: int, height: int) -> None:
        with _reachable_opengl():
            self.render_window: Any = vtkRenderWindow()
        self.render_window.SetOffScreenRendering(1)
        if sys.platform == "darwin":  # else there is a window after all, in the main thread only
            self.render_window.SetConnectContextToNSView(False)
        self.render_window.SetMultiSamples(0)
        self.render_window.SetSize(width, height)
        self.renderer: Any = vtkRenderer()
        self.renderer.SetActiveCamera(vtkCamera())
        self.render_window.AddRenderer(self.renderer)

    def close(self) -> None:
        """Give back what OpenGL holds for it."""
        self.render_window.Finalize()


@contextmanager
def off_screen(width: int, height: int) -> Iterator[OffScreen]:
    """Draw off the screen, and give everything back afterwards, whatever happens."""
    screen = OffScreen(width, height)
    try:
        screen.render_window.SetAlphaBitPlanes(1)
        yield screen
    finally:
        screen.close()


@contextmanager
def _reachable_opengl() -> Iterator[None]:
    """Make VTK's next window where there is no display, without a try that ends in a warning."""
    if sys.platform != "linux" or os.environ.get("DISPLAY") or _WINDOW_CHOICE in os.environ:
        yield
        return
    os.environ[_WINDOW_CHOICE] = "vtkEGLRenderWindow"
    try:
        yield
    finally:
        del os.environ[_WINDOW_CHOICE]
