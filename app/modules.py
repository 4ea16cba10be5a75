"""Where Python looks for modules: its own come first, whatever surrounds the start.

The current folder and PYTHONPATH may hold a ``numpy`` or a ``random.py`` that is not Python's.
Hence this module imports only modules that no file can hide.
"""

from __future__ import annotations

import os
import sys

INSIDE = __name__.removesuffix("app.modules")
"""Where the packages lie: ``frustum_lab.`` once installed, nowhere in a checkout."""
PACKAGES = (f"{INSIDE}app", f"{INSIDE}widgets")
ROOT = os.path.realpath(__file__)
for _ in __name__.split("."):
    ROOT = os.path.dirname(ROOT)
SET_ASIDE = "FRUSTUM_LAB_SET_ASIDE"
"""Variable of the environment that names the variables that are not followed, for `doctor`."""
FROZEN = getattr(sys, "frozen", False)
"""Whether this is the program of ``bundle``, which has its own Python and modules inside."""


def prefer_own() -> bool:
    """Search the folders of PYTHONPATH last, and the folder of the start not at all.

    Return whether code from PYTHONPATH may already have run, so that a fresh start is better.
    """
    set_aside("MPLBACKEND")  # one that is unknown keeps matplotlib from being imported
    if FROZEN:
        return False
    if not sys.flags.safe_path:
        del sys.path[0]
    sys.path.insert(0, ROOT)
    for package in PACKAGES:
        __import__(package)  # which needs no path from now on
    del sys.path[0]
    own = os.path.dirname(os.__file__)
    first = sys.path.index(own) if own in sys.path else 0
    given = sys.path[:first]
    sys.path[:] = sys.path[first:] + given
    is_aside = set_aside("PYTHONPATH")
    if ROOT in map(os.path.realpath, given):  # another interpreter must find the program, too
        os.environ["PYTHONPATH"] = ROOT
    return is_aside and "sitecustomize" in sys.modules


def set_aside(name: str) -> bool:
    """Hide a variable from the programs that are started from now on; return whether it was set."""
    value = os.environ.pop(name, "")
    if value in ("", ROOT):
        return False
    before = os.environ.get(SET_ASIDE)
    os.environ[SET_ASIDE] = ", ".join(filter(None, (before, f"{name}={value}")))
    return True


def command(module: str, *arguments: str) -> list[str]:
    """Return the command that runs a module in a process of its own, with this one's modules.

    Our own have their names in a checkout: ``app.scenes.reading``.
    """
    if f"{INSIDE}{module.partition('.')[0]}" in PACKAGES:
        module = INSIDE + module
    if FROZEN:  # `app.__main__` takes it
        return [sys.executable, "-m", module, *arguments]
    code = (
        f"import sys; sys.path[:] = [{ROOT!r}]; import {', '.join(PACKAGES)}; "
        f"sys.path[:] = {sys.path!r}; "
        f"import runpy; runpy.run_module({module!r}, run_name='__main__', alter_sys=True)"
    )
    return [sys.executable, "-P", "-c", code, *arguments]
