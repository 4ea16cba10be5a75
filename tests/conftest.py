"""Fixtures for all tests: a real X server, real widgets, a home of their own, nothing left over."""

import atexit
import contextlib
import functools
import gc
import importlib
import inspect
import itertools
import os
import re
import subprocess
import sys
from collections.abc import Callable, Generator, Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings
from pytestqt.qtbot import QtBot

from tests import PATIENCE_MS
from tests.__main__ import screens

MOST_WIDGETS = 600
"""Most widgets left after a test, about two docks: Python has not collected them yet."""

# Each of the processes that share the tests has a screen of its own.
_worker = os.environ.get("PYTEST_XDIST_WORKER", "")
_displays = os.environ.get("TEST_DISPLAYS", "").split()
if _worker and _displays:
    os.environ["DISPLAY"] = _displays[int(_worker.removeprefix("gw")) % len(_displays)]

os.environ["LANGUAGE"] = "en"  # whatever the machine speaks

# Every run has the same examples, so that a red test means a change. `--hypothesis-seed` and
# `--hypothesis-profile default` search further. No deadline, because other jobs slow the machine.
settings.register_profile("default", deadline=None)
settings.register_profile("same", settings.get_profile("default"), derandomize=True)
settings.load_profile("same")

for wait in ("Until", "Signal", "Signals", "Exposed", "Active", "Callback"):
    getattr(QtBot, f"wait{wait}").__kwdefaults__["timeout"] = PATIENCE_MS


_ended = [1]
"""The exit status, once it is known."""


def pytest_sessionfinish(exitstatus: int) -> None:
    _ended[0] = int(exitstatus)


def _end(stack: contextlib.ExitStack) -> None:
    """Close the servers, and leave at once: what Qt and VTK keep would notice it."""
    stack.close()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(_ended[0])


def pytest_configure(config: pytest.Config) -> None:
    """Bring a screen for each process, unless whoever started this one has brought it."""
    if not _displays:
        stack = contextlib.ExitStack()
        atexit.register(_end, stack)  # after Qt and VTK, which end the process without their server
        count = config.getoption("numprocesses", None) or 1
        environment = stack.enter_context(screens(count))
        os.environ.clear()
        os.environ.update(environment)


def pytest_collection(session: pytest.Session) -> None:
    """Let every second process import the tests backwards.

    In a fresh checkout pytest rewrites the assertions of each file: so each process does half.
    What is made meanwhile stays: Python need not search it for what is not used any more.
    """
    gc.disable()
    config = session.config
    if config.args_source == pytest.Config.ArgsSource.TESTPATHS and _worker[-1:] in (*"1357",):
        for path in sorted(Path(__file__).parent.rglob("test_*.py"), reverse=True):
            name = ".".join(path.relative_to(config.rootpath).with_suffix("").parts)
            with contextlib.suppress(Exception):  # pytest says so when it comes to the file
                importlib.import_module(name)


def pytest_collection_finish() -> None:
    gc.freeze()
    gc.enable()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    call: pytest.CallInfo[None],
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Show the output of a process that failed, such as the linker's message.

    Processes send each other the log as UTF-8, so that other bytes are escaped.
    """
    report = yield
    error = call.excinfo.value if call.excinfo is not None else None
    if isinstance(error, subprocess.CalledProcessError) and error.stderr:
        said = error.stderr
        text = said.decode(errors="replace") if isinstance(said, bytes) else said
        report.sections.append(("Said by the process that failed", text))
    report.sections = [
        (name, text.encode(errors="backslashreplace").decode()) for name, text in report.sections
    ]
    return report


@pytest.fixture(scope="session")
def homes(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    """Names of new folders; `mktemp` would look through all existing ones each time."""
    folder = tmp_path_factory.mktemp("homes")
    # Otherwise Mesa compiles its shaders in every home, and matplotlib looks for every font.
    kept = tmp_path_factory.getbasetemp()
    kept = kept.parent if _worker else kept  # the processes share it
    os.environ["MESA_SHADER_CACHE_DIR"] = os.environ["MPLCONFIGDIR"] = str(kept)
    from matplotlib import font_manager as fonts

    # A slow machine says that it reads all fonts; pyvista has read them before, for another folder.
    read = kept / f"fontlist-v{fonts.FontManager.__version__}.json"
    if not read.exists():
        fonts.json_dump(fonts.fontManager, read)
    return (folder / str(number) for number in itertools.count())


@pytest.fixture(autouse=True)
def own_home(homes: Iterator[Path], monkeypatch: pytest.MonkeyPatch) -> Path:
    """Keep the user's settings, log and autosaves untouched."""
    home = next(homes)
    home.mkdir()
    for name, folder in (
        ("HOME", home),
        ("XDG_CONFIG_HOME", home / "config"),
        ("XDG_DATA_HOME", home / "data"),
        ("XDG_CACHE_HOME", home / "cache"),
    ):
        monkeypatch.setenv(name, str(folder))
    return home


@pytest.fixture(autouse=True)
def nothing_left() -> Iterator[None]:
    """Delete what a test has closed: a style is applied to every widget that exists."""
    yield
    if "PySide6.QtWidgets" in sys.modules:
        from PySide6.QtWidgets import QApplication

        from tests.support.opened import delete_what_is_due

        delete_what_is_due()
        left = len(QApplication.allWidgets())
        assert left < MOST_WIDGETS, f"{left} widgets outlive their tests"


@pytest.fixture
def few_seeds(monkeypatch: pytest.MonkeyPatch) -> None:
    """Check enough variants to find a fault of every exercise; ``lesson check`` tries more."""
    from app.lessons.blocks import exercise

    monkeypatch.setattr(exercise, "SEEDS", exercise.LEAST_VARIANTS + 4)


@pytest.fixture(scope="session")
def qapp_cls() -> type:
    """The application class for pytest-qt, after what must precede the first window."""
    from PySide6.QtWidgets import QApplication

    from widgets.program.opengl import prepare

    prepare()
    return QApplication


@pytest.fixture(scope="session")
def display(qapp: Any) -> Any:
    """The application, on a platform that can draw: Qt's `offscreen` paints garbage with rc 0."""
    if sys.platform.startswith("linux"):
        assert qapp.platformName() == "xcb", os.environ.get("QT_QPA_PLATFORM")
    import widgets.window.main_window  # noqa: F401

    # Objects that stay are not searched again for survivors after every window.
    gc.collect()
    gc.freeze()
    return qapp


@pytest.fixture
def make_window(
    request: pytest.FixtureRequest, display: Any, own_home: Path, monkeypatch: pytest.MonkeyPatch
) -> Iterator[Callable[..., Any]]:
    """Open main windows; after the test all are closed and no interactor survives.

    Edges stay as they are while one drags, and labels do not fade, unless a test is marked as
    `smooth`: then windows are smaller. Panes stay empty for a test that is `undrawn`. Folded panels
    are prepared when a test says so, however slow the machine is.
    """
    from app.document.document import Document
    from app.scenes.scene import load
    from tests.support.opened import close, opened
    from widgets.panes import adaptive
    from widgets.window import drawer, main_window
    from widgets.window.settings import Settings

    monkeypatch.setattr(drawer, "IDLE_MS", 10 * PATIENCE_MS)
    is_smooth = request.node.get_closest_marker("smooth") is not None
    if is_smooth:  # quickly drawn
        monkeypatch.setattr(main_window, "AT_FIRST_PX", (main_window.FOLDS_BELOW_PX, 560))
    else:
        monkeypatch.setattr(adaptive, "AT_REST", "none")
    windows: list[Any] = []

    def make(document: Document | None = None, **options: Any) -> Any:
        options.setdefault("settings", Settings(own_home / "settings.ini"))
        options.setdefault("drawn", request.node.get_closest_marker("undrawn") is None)
        document = document or Document("letter-f", load("letter-f").start)
        windows.append(opened(document, **options))
        for pane in windows[-1].panes.values() if not is_smooth else ():
            pane.fades = lambda: False
        return windows[-1]

    def forget(window: Any) -> None:
        windows.remove(window)
        window.deleteLater()

    make.forget = forget  # type: ignore[attr-defined]
    yield make
    close(windows)


@pytest.fixture
def off_screen() -> Iterator[Callable[[int, int], Any]]:
    """Make windows on no screen, closed after the test."""
    from tests.support.drawings import off_screen_windows

    with off_screen_windows() as make:
        yield make


@pytest.fixture
def talk(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """A file with the module's `TALK`."""
    path = tmp_path / "talk.md"
    path.write_text(request.module.TALK, encoding="utf-8")
    return path


@pytest.fixture
def window(request: pytest.FixtureRequest, make_window: Callable[..., Any]) -> Iterator[Any]:
    """A window on the letter F as it opens, at rest."""
    from tests.support.window import settle

    window = make_window()
    settle()
    yield window
    request.node.funcargs.clear()  # pytest's hold on it, before survivors are sought


LACKING = {
    "win32": r"symlink_to|mkfifo|chmod\(|umask|/bin/sh|/dev/\w+|ge?te?uid|SIGKILL|rlimit|os\.fork",
    "darwin": r"/dev/full|/proc/\w+|rlimit",
}
"""What tests name that a system has not, or not as they need it."""


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Run first what takes longest alone; skip what this system cannot do, and say what that is."""
    items.sort(key=lambda item: item.path.name != "test_quality.py")
    lacking = LACKING.get(sys.platform)
    source_of = functools.cache(inspect.getsource)  # once for all cases of a test
    for item in items if lacking else ():
        text = source_of(item.function) if isinstance(item, pytest.Function) else ""
        if (named := re.search(lacking, text)) and "sys.platform" not in text:
            item.add_marker(pytest.mark.skip(reason=f"needs {named[0]}"))
