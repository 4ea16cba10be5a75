"""``python3 -m tests``: set up, find screens, run every check there is.

Where it starts the X servers itself, there is one for each processor, and the tests are shared
out among as many processes: two windows on one screen would take each other's keyboard.
Arguments go to pytest: ``python3 -m tests tests/scenes/test_scene.py -k posts``. The exit status is
pytest's own, and so is the last line. ruff and mypy are tests like the others (``test_quality``).
"""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from types import FrameType

from app import bootstrap

MOST_SCREENS = 4


@contextlib.contextmanager
def screens(count: int) -> Iterator[dict[str, str]]:
    """Yield the environment for Qt on real X servers: the one that is there, or some of our own.

    Parameters
    ----------
    count : int
        Of our own, if there is none. ``TEST_DISPLAYS`` names them, for `tests.conftest`.
    """
    environment = dict(os.environ)
    environment.pop("TEST_DISPLAYS", None)
    if not sys.platform.startswith("linux"):
        yield environment
        return
    environment["QT_QPA_PLATFORM"] = "xcb"
    if environment.get("DISPLAY"):
        yield environment
        return
    with contextlib.ExitStack() as stack:
        displays = [stack.enter_context(own_screen()) for _ in range(count)]
        environment["DISPLAY"] = displays[0]
        environment["TEST_DISPLAYS"] = " ".join(displays)
        yield environment


@contextlib.contextmanager
def at_home(extras: Sequence[str] = ("test",)) -> Iterator[dict[str, str]]:
    """Set up, and yield the environment for a screen and a home of a tool's own."""
    bootstrap.start("tests", extras=extras)
    with screens(1) as environment, tempfile.TemporaryDirectory() as home:
        yield environment | dict.fromkeys(("HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"), home)


@contextlib.contextmanager
def own_screen() -> Iterator[str]:
    """Yield the name of an X server of our own."""
    reading, writing = os.pipe()
    # No -auth: without it the server lets in nobody but the user who started it.
    command = f"Xvfb -displayfd {writing} -screen 0 1920x1080x24 +extension GLX -nolisten tcp"
    with tempfile.TemporaryFile() as said:
        server = subprocess.Popen(
            [*command.split(), "-noreset"],
            pass_fds=(writing,),
            stdout=said,
            stderr=said,
            preexec_fn=bootstrap.die_with_parent,
        )
        try:
            os.close(writing)
            with os.fdopen(reading) as answer:
                number = answer.readline().strip()  # the server writes it when it is ready
            if not number:
                said.seek(0)
                why = " ".join(said.read().decode(errors="replace").split())
                bootstrap.fail(f"Xvfb did not start ({why}); start an X server and set DISPLAY")
            yield f":{number}"
        finally:
            server.terminate()
            server.wait()


def _stop(_signal: int, _frame: FrameType | None) -> None:
    raise SystemExit(128 + signal.SIGTERM)


def main() -> int:
    """Run pytest in a process of its own, so that a crash in it is still tidied up after."""
    bootstrap.start("tests", extras=("test",))
    signal.signal(signal.SIGTERM, _stop)
    # A job in the background has Ctrl-C ignored, and so would all that the tests start and stop.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    with screens(min(os.cpu_count() or 1, MOST_SCREENS)) as environment:
        # Otherwise every process that a test starts compiles the program anew.
        environment.pop("PYTHONDONTWRITEBYTECODE", None)
        command = [sys.executable, "-m", "pytest", *sys.argv[1:]]
        processes = len(environment.get("TEST_DISPLAYS", "").split())
        if processes > 1:
            command += ["--numprocesses", str(processes), "--dist", "worksteal"]
        before = None if sys.platform == "win32" else bootstrap.die_with_parent
        with subprocess.Popen(
            command, cwd=bootstrap.ROOT, env=environment, preexec_fn=before
        ) as pytest:
            try:
                return pytest.wait()
            except KeyboardInterrupt:  # pytest has it too, and writes its summary
                return pytest.wait()
            except SystemExit:
                pytest.terminate()
                raise


if __name__ == "__main__":
    sys.exit(main())
