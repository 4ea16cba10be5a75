"""Find out whether the user has asked the system to reduce motion."""

import ctypes
import subprocess
import sys
from functools import cache

_CLIENT_AREA_ANIMATION = 0x1042  # of Windows' `SystemParametersInfo`
_ASK_GNOME = ("gsettings", "get", "org.gnome.desktop.interface", "enable-animations")
_ASK_MACOS = ("defaults", "read", "com.apple.universalaccess", "reduceMotion")
_PATIENCE_S = 1.0


@cache
def system_reduces_motion() -> bool:
    """Return the system's setting as it was at the first call; False if it has none."""
    if sys.platform == "win32":
        animates = ctypes.c_int(1)
        ctypes.windll.user32.SystemParametersInfoW(
            _CLIENT_AREA_ANIMATION, 0, ctypes.byref(animates), 0
        )
        return not animates.value
    if sys.platform == "darwin":
        return _output_of(_ASK_MACOS) == "1"
    return _output_of(_ASK_GNOME) == "false"


def _output_of(command: tuple[str, ...]) -> str:
    """Return what a command prints; empty if it is missing or fails."""
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=_PATIENCE_S, check=False
        )
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return done.stdout.strip()
