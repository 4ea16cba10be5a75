"""VTK's windows that are on no screen: with a display or without, through X, EGL or Mesa alone."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pyvista as pv
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (without it no window is one of OpenGL)
from vtkmodules.vtkCommonCore import vtkLogger
from vtkmodules.vtkRenderingCore import vtkRenderWindow

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


@contextmanager
def off_screen(width: int, height: int) -> Iterator[Any]:
    """An off-screen plotter that is closed afterwards, whatever happens."""
    plotter = off_screen_plotter(width, height)
    try:
        plotter.render_window.SetAlphaBitPlanes(1)
        yield plotter
    finally:
        plotter.close()


def off_screen_plotter(width: int, height: int) -> Any:
    """A plotter that draws off the screen, with a display or without."""
    with _reachable_opengl():
        plotter: Any = pv.Plotter(off_screen=True, window_size=[width, height], border=False)
    plotter.render_window.SetMultiSamples(0)
    return plotter


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
