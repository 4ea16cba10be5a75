"""``python3 -m tests.portable``: try the suite as on Windows and macOS, as far as one can here.

All packages are imported as they are here. Then ``sys.platform`` is the other system's, and what
only POSIX has is gone. All tests are collected; those of `RUN`, or of the arguments, are run too.
pytest names what the others need of this system (`tests.conftest.LACKING`).
"""

import os
import subprocess
import sys
from collections.abc import Sequence

from app.bootstrap import ROOT
from tests.__main__ import at_home
from tests.support.tools import ToolParser

POSIX = (
    "O_NONBLOCK", "chown", "fchmod", "fork", "forkpty", "getegid", "geteuid", "getgid",
    "getloadavg", "getpgid", "getsid", "getuid", "killpg", "mkfifo", "nice", "openpty", "setsid",
    "setuid", "sysconf", "uname", "wait3",
)  # fmt: skip
"""What Windows lacks of ``os``."""
MODULES = "fcntl", "grp", "pty", "pwd", "resource", "termios"
RUN = (
    "tests/arithmetic", "tests/model", "tests/lecture", "tests/picking", "tests/document",
    "tests/scenes/test_mesh_files.py", "tests/scenes/test_gltf.py", "tests/lessons/test_lesson.py",
    "tests/lessons/test_record.py", "tests/house/test_decoding.py", "tests/commands/test_bundle.py",
    "tests/widgets/test_other_systems.py",
)  # fmt: skip
"""What meets the system first: files, texts, commands, and the model under all."""
PROBE = """
import os, sys, pytest
system, names, modules, arguments = eval(sys.argv[1])
class Elsewhere:
    def pytest_sessionstart(self):
        import asyncio, concurrent.futures, gc, multiprocessing, pathlib, platform, shutil
        import subprocess
        import hypothesis, matplotlib.pyplot, numpy, psutil, pyvistaqt, tempfile, vtkmodules.all
        import urllib.request
        import PySide6.QtOpenGLWidgets, PySide6.QtSvg, PySide6.QtTest, tests.__main__
        sys.platform = system
        for name in names if system == "win32" else ():
            if hasattr(os, name):
                delattr(os, name)
        sys.modules.update(dict.fromkeys(modules if system == "win32" else ()))
        gc.freeze()  # Python's collector ends in some of them
sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", *arguments], plugins=[Elsewhere()]))
"""


def main(words: Sequence[str]) -> int:
    _, arguments = ToolParser("portable", __doc__).parse_known_args(words)
    status = 0
    with at_home() as environment:
        for system in ("win32", "darwin"):
            for given in (["--collect-only", "-qq"], arguments or [*RUN, "-rs"]):
                words = repr((system, POSIX, MODULES, given))
                command = [sys.executable, "-c", PROBE, words]
                done = subprocess.run(command, cwd=ROOT, env=os.environ | environment, check=False)
                print(f"{system}: pytest ends with status {done.returncode}", flush=True)
                status |= done.returncode
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
