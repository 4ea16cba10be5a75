"""``python3 -m tests``: set up, bring screens, run every check there is.

On Linux each processor has an X server of one known size, whatever screen a person works on. The
tests are shared out among as many processes: two windows on one screen would take each other's
keyboard. `tests.conftest` starts the servers, so that pytest may be called alone, too. Arguments go
to pytest: ``python3 -m tests tests/scenes/test_scene.py -k posts``. The exit status is pytest's
own, and so is the last line. ruff and mypy are tests like the others (``test_quality``).
"""

import os
import sys

if __name__ == "__main__":  # before anything is imported that a file beside this folder could hide
    if not __package__:  # started by the path of its folder
        sys.path[0] = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
        __import__("tests")
    from app import modules

    modules.prefer_own()

import contextlib
import importlib.util
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import FrameType

from app import bootstrap, held_lock, system_packages
from app.python_packages import requirements

MOST_SCREENS = 4
SCREEN = (1920, 1080)
_PERSONAL = ("DISPLAY", "WAYLAND_DISPLAY", "QT_", "LANG", "LC_", "TEST_DISPLAYS")
"""How the variables begin that say how a person sees the program, or what runs around this."""

_FONTS = """<fontconfig><dir>{}</dir><cachedir>{}</cachedir><selectfont>
<acceptfont><glob>*/DejaVu*</glob></acceptfont><rejectfont><glob>*</glob></rejectfont></selectfont>
<match target="pattern"><edit name="family" mode="append_last"><string>DejaVu Sans</string></edit>
<edit name="hintstyle"><const>hintslight</const></edit></match></fontconfig>
"""
"""Qt's fonts: those that come with matplotlib, and not what a person has installed."""


@contextlib.contextmanager
def screens(count: int, size: tuple[int, int] = SCREEN) -> Iterator[dict[str, str]]:
    """Yield the environment for Qt on X servers of our own, with fonts of our own, in English.

    ``TEST_DISPLAYS`` names the servers, for `tests.conftest`. Other systems have the one screen.
    """
    kept = {name: value for name, value in os.environ.items() if not name.startswith(_PERSONAL)}
    environment = kept | {"LANG": "C.UTF-8"}
    if not sys.platform.startswith("linux"):
        yield environment
        return
    environment["QT_QPA_PLATFORM"] = "xcb"
    with contextlib.ExitStack() as stack:
        displays = [stack.enter_context(own_screen(size)) for _ in range(count)]
        home = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        matplotlib = importlib.util.find_spec("matplotlib")
        assert matplotlib is not None and matplotlib.origin is not None
        fonts = Path(matplotlib.origin).with_name("mpl-data") / "fonts" / "ttf"
        (home / "fonts.conf").write_text(_FONTS.format(fonts, home), encoding="utf-8")
        environment["FONTCONFIG_FILE"] = str(home / "fonts.conf")
        environment["DISPLAY"] = displays[0]
        environment["TEST_DISPLAYS"] = " ".join(displays)
        yield environment


@contextlib.contextmanager
def at_home(
    extras: Sequence[str] = ("test",), screen: tuple[int, int] = SCREEN
) -> Iterator[dict[str, str]]:
    """Set up, and yield the environment for a screen and a home of a tool's own."""
    bootstrap.start("tests", extras=extras)
    with screens(1, screen) as environment, tempfile.TemporaryDirectory() as home:
        yield environment | dict.fromkeys(("HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"), home)


@contextlib.contextmanager
def own_screen(size: tuple[int, int] = SCREEN) -> Iterator[str]:
    """Yield the name of an X server of our own, with a screen of this size in pixels."""
    if shutil.which("Xvfb") is None:
        bootstrap.fail(system_packages.advice(system_packages.missing_system("tests")))
    reading, writing = os.pipe()
    # No -auth: without it the server lets in nobody but the user who started it.
    screen = f"{size[0]}x{size[1]}x24"
    command = f"Xvfb -displayfd {writing} -screen 0 {screen} +extension GLX -nolisten tcp"
    with tempfile.TemporaryFile() as said:
        server = subprocess.Popen(
            [*command.split(), "-noreset"],
            pass_fds=(writing,),
            stdout=said,
            stderr=said,
            preexec_fn=held_lock.die_with_parent,
        )
        try:
            os.close(writing)
            with os.fdopen(reading) as answer:
                number = answer.readline().strip()  # the server writes it when it is ready
            if not number:
                said.seek(0)
                why = " ".join(said.read().decode(errors="replace").split())
                bootstrap.fail(f"Xvfb did not start ({why})")
            yield f":{number}"
        finally:
            server.terminate()
            server.wait()


def _stop(_signal: int, _frame: FrameType | None) -> None:
    raise SystemExit(128 + signal.SIGTERM)


def hides(path: Path) -> bool:
    """Whether pytest, which looks in the checkout first, would take it for another module."""
    if path.suffix != ".py" and not (path / "__init__.py").exists():
        return False
    others = {each.import_name for each in requirements(bootstrap.ROOT, ("test",))}
    return path.stem in others | sys.stdlib_module_names


def main() -> int:
    """Run pytest in a process of its own, so that a crash in it is still tidied up after."""
    if hidden := sorted(path for path in bootstrap.ROOT.iterdir() if hides(path)):
        names = ", ".join(map(str, hidden))
        bootstrap.fail(f"{names}: hides a module that the tests need; rename it, and start again")
    bootstrap.start("tests", extras=("test",))
    signal.signal(signal.SIGTERM, _stop)
    # A job in the background has Ctrl-C ignored, and so would all that the tests start and stop.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    if {"-h", "--help"} & {*sys.argv}:
        print(__doc__, flush=True)
    command = [sys.executable, "-m", "pytest", *sys.argv[1:]]
    processes = min(os.cpu_count() or 1, MOST_SCREENS)
    if sys.platform.startswith("linux") and processes > 1:
        command += ["--numprocesses", str(processes), "--dist", "worksteal"]
    before = None if sys.platform == "win32" else held_lock.die_with_parent
    # Otherwise every process that a test starts compiles the program anew.
    environment = {**os.environ}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
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
