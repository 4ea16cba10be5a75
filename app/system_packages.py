"""The libraries and programs of the operating system: what is missing, and what installs it.

This module imports the standard library only.
"""

from __future__ import annotations

import contextlib
import ctypes
import importlib.util
import os
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

from app.held_lock import log
from app.languages import said

#: What a command needs of the machine: no graphics, pictures without a window, a window, or a
#: window on a virtual display.
Need = Literal["numbers", "picture", "window", "tests"]
_PICTURE: tuple[Need, ...] = ("picture", "window", "tests")
_WINDOW: tuple[Need, ...] = ("window", "tests")


class SetupError(Exception):
    """One sentence that says what is missing and which command helps; filled in as by `said`."""

    def __init__(self, sentence: str, *values: object) -> None:
        super().__init__(said(sentence, *values))


@dataclass(frozen=True)
class System:
    """A shared library, by its soname, or a program of the operating system.

    `packages` are the packages of Debian and Ubuntu that contain it, separated by spaces.
    """

    name: str
    packages: str
    needs: tuple[Need, ...] = _WINDOW

    def is_here(self) -> bool:
        """Try to load it, which is reliable on every distribution."""
        if ".so" not in self.name:
            return shutil.which(self.name) is not None
        try:
            ctypes.CDLL(self.name)
        except OSError:
            return False
        return True


class _Fonts(System):
    """Qt draws text with the system's fonts; without a font it shows boxes instead of letters."""

    def is_here(self) -> bool:
        try:
            fontconfig = ctypes.CDLL("libfontconfig.so.1")
        except OSError:
            return False
        # FcFontSet begins with the number of its fonts. Qt reuses the list as it was read.
        of_system = fontconfig.FcConfigGetFonts
        of_system.restype = ctypes.POINTER(ctypes.c_int)
        with _in_a_folder():
            for _ in range(2):
                fonts = of_system(None, 0)
                if fonts and fonts[0] > 0:
                    return True
                fontconfig.FcInitReinitialize()  # fonts may just have been installed
        return False


@contextlib.contextmanager
def _in_a_folder() -> Iterator[None]:
    """Leave a deleted current folder, from which fontconfig cannot read its files."""
    if os.path.exists("."):
        yield
        return
    deleted = os.open(".", os.O_RDONLY)
    os.chdir("/")
    try:
        yield
    finally:
        os.fchdir(deleted)
        os.close(deleted)


class _EnsurePip(System):
    def is_here(self) -> bool:
        return importlib.util.find_spec("ensurepip") is not None


def _library(name: str, needs: tuple[Need, ...] = _WINDOW) -> System:
    """Return a library whose package is named after it: libxkbcommon-x11.so.0, with a second -0."""
    stem, _, version = name.lower().replace("_", "-").partition(".so.")
    return System(name, f"{stem}{'-' * stem[-1].isdigit()}{version}", needs)


_OF_WINDOWS = (
    "libX11-xcb.so.1 libxkbcommon.so.0 libxkbcommon-x11.so.0 libxcb-cursor.so.0 libxcb-glx.so.0 "
    "libxcb-icccm.so.4 libxcb-image.so.0 libxcb-keysyms.so.1 libxcb-randr.so.0 "
    "libxcb-render-util.so.0 libxcb-shape.so.0 libxcb-sync.so.1 libxcb-util.so.1 "
    "libxcb-xfixes.so.0 libxcb-xkb.so.1 libfontconfig.so.1 libfreetype.so.6 libdbus-1.so.3"
)
#: The libGL and libEGL of the loader lead to Mesa or to a vendor's driver, as the machine is
#: configured, so only these two are checked. If apt has to install them, the Mesa packages are
#: installed as well.
SYSTEM = (
    System("libGL.so.1", "libgl1 libglx-mesa0 libgl1-mesa-dri", _PICTURE),
    System("libEGL.so.1", "libegl1 libegl-mesa0", _PICTURE),
    _library("libX11.so.6", _PICTURE),
    _library("libXcursor.so.1", _PICTURE),
    *map(_library, _OF_WINDOWS.split()),
    _Fonts("a font", "fonts-dejavu-core"),
    System("libglib-2.0.so.0", "libglib2.0-0"),
    _library("libgssapi_krb5.so.2", ("tests",)),  # pyside6-lupdate, for translations, needs it
    System("Xvfb", "xvfb xauth", ("tests",)),
)


def missing_system(need: Need) -> list[System]:
    """Return the missing libraries and programs for a need; macOS and Windows have them all."""
    if not sys.platform.startswith("linux"):
        return []
    return [item for item in SYSTEM if need in item.needs and not item.is_here()]


def venv_module() -> list[System]:
    """A new environment needs ensurepip, which is a separate package on Debian and Ubuntu."""
    item = _EnsurePip("ensurepip", f"python3.{sys.version_info[1]}-venv")
    return [] if item.is_here() else [item]


def advice(missing: Sequence[System]) -> str:
    """Return a sentence that says what is missing and, if known, the command that installs it.

    The command installs what every need lacks, so that no second command is necessary.
    """
    names = [said(item.name) for item in missing]
    if shutil.which("apt-get") is None:
        return said("without-packages", ", ".join(names))
    if len(names) > 3:  # the command lists them all
        names[2:] = [said("and {0} more", len(names) - 2)]
    everything = packages_of([*missing, *(item for item in SYSTEM if not item.is_here())])
    return said("this system lacks {0}; run: {1}", ", ".join(names), apt_command(everything))


def packages_of(missing: Iterable[System]) -> list[str]:
    return list(dict.fromkeys(name for item in missing for name in item.packages.split()))


APT_INSTALL = ("apt-get", "install", "-y", "--no-install-recommends")


def apt_command(packages: Sequence[str]) -> str:
    # The package lists may be empty, and a list that cannot be updated is no reason to stop.
    command = f"apt-get update; {shlex.join([*APT_INSTALL, *packages])}"
    if is_root():
        return command
    # A minimal Debian has no sudo, and only a root login has /sbin on its path.
    become_root = ["sudo", "sh", "-c"] if shutil.which("sudo") else ["su", "-", "-c"]
    return shlex.join([*become_root, command])


def is_root() -> bool:
    return sys.platform != "win32" and os.geteuid() == 0


def install(missing: Sequence[System]) -> None:
    """Install what is missing with apt-get if running as root; otherwise say how."""
    if not is_root() or shutil.which("apt-get") is None:
        raise SetupError(advice(missing))
    packages = packages_of(missing)
    log(said("installing system packages: {0}", " ".join(packages)))
    # An unreachable repository is no reason to stop: the necessary one may be reachable.
    quiet = os.environ | {"DEBIAN_FRONTEND": "noninteractive"}
    for command in (["apt-get", "update"], [*APT_INSTALL, *packages]):
        done = subprocess.run(
            command, env=quiet, capture_output=True, text=True, errors="replace", check=False
        )
    if done.returncode != 0:
        why = last_line(done.stderr.splitlines(), "E:") or said("exit status {0}", done.returncode)
        raise SetupError("apt-failed", why, apt_command(packages))
    importlib.invalidate_caches()
    if left := [item for item in missing if not item.is_here()]:
        raise SetupError(advice(left))


def last_line(lines: Iterable[str], start: str = "") -> str:
    """Return the last line that begins so, without that."""
    last = [line.strip() for line in lines if line.strip().startswith(start)]
    return last[-1].removeprefix(start).strip().rstrip(".") if last else ""
