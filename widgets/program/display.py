"""Check for a screen before Qt does, because Qt ends the process without one."""

import ctypes
import os
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial

from app import bootstrap, system_packages
from app.languages import said
from widgets.parts.translator import find_plugins
from widgets.program.opengl import WITHOUT_OPENGL, DisplayError

X_RETRIES_S = (0.1, 0.4, 0.0)  # pauses after attempts to reach an X server, which may be restarting


@contextmanager
def display() -> Iterator[None]:
    """Make sure that Qt will find a screen inside the block; raise DisplayError otherwise.

    The connection to an X server is held until Qt has its own. A server without any client restarts
    (under xvfb-run, for example), and does not answer meanwhile.
    """
    leave = _reach_display() if sys.platform.startswith("linux") else None
    try:
        yield
    finally:
        if leave is not None:
            leave()


def _reach_display() -> Callable[[], object] | None:
    """Connect to Wayland or X; return the function that ends a held connection."""
    wanted = os.environ.get("QT_QPA_PLATFORM", "")
    names = [part.partition(":")[0] for part in wanted.split(";")] if wanted else []
    wayland = not names or any(name.startswith("wayland") for name in names)
    x11 = not names or "xcb" in names
    if not wayland and not x11:
        if names[0] in WITHOUT_OPENGL:
            return None  # this platform needs no screen or has its own
        known = ", ".join(("xcb", "wayland", *WITHOUT_OPENGL))
        raise DisplayError("QT_QPA_PLATFORM = {0}: must be one of {1}; unset it.", wanted, known)
    if wayland and _wayland_answers():
        return None
    display = os.environ.get("DISPLAY", "")
    if not x11 or not display:
        raise _unreachable(said("opens-none", "DISPLAY" if x11 else "WAYLAND_DISPLAY"))
    return _reach_x11(display)


def _unreachable(problem: str) -> DisplayError:
    missing = [] if shutil.which("xvfb-run") else [system_packages.System("xvfb-run", "xvfb xauth")]
    how = f" ({system_packages.advice(missing)})" if missing else ""
    return DisplayError("no-screen", problem, how)


def _wayland_answers() -> bool:
    if not os.environ.get("XDG_RUNTIME_DIR") or not (
        os.environ.get("WAYLAND_DISPLAY") or os.environ.get("XDG_SESSION_TYPE") == "wayland"
    ):
        return False
    try:
        client = ctypes.CDLL("libwayland-client.so.0")
    except OSError:
        return False
    client.wl_display_connect.restype = ctypes.c_void_p
    client.wl_display_disconnect.argtypes = [ctypes.c_void_p]
    connection = client.wl_display_connect(None)
    if connection:
        client.wl_display_disconnect(connection)
    return bool(connection)


def _reach_x11(display: str) -> Callable[[], object]:
    try:
        # Qt's own library for X, to find missing system libraries.
        ctypes.CDLL(os.path.join(find_plugins(), "platforms", "libqxcb.so"))
        xcb = ctypes.CDLL("libxcb.so.1")
    except OSError as error:
        raise DisplayError("missing-library", error, bootstrap.PROGRAM) from error
    xcb.xcb_connect.restype = ctypes.c_void_p
    xcb.xcb_connect.argtypes = [ctypes.c_char_p, ctypes.c_void_p]
    xcb.xcb_connection_has_error.argtypes = [ctypes.c_void_p]
    xcb.xcb_disconnect.argtypes = [ctypes.c_void_p]
    for pause_s in X_RETRIES_S:
        connection = xcb.xcb_connect(os.fsencode(display), None)
        if not xcb.xcb_connection_has_error(connection):
            return partial(xcb.xcb_disconnect, connection)
        xcb.xcb_disconnect(connection)
        time.sleep(pause_s)
    raise _unreachable(said("does-not-answer", display))
