"""Round the window: what happens before it opens, when something goes wrong, and at the end."""

import gc
import json
import logging
import math
import os
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEventLoop, QStandardPaths, QTimer
from PySide6.QtWidgets import QLabel, QPushButton, QWidget

from app import python_packages
from app.bootstrap import ROOT
from app.commands.cli import main
from app.document.codec import to_json
from app.document.document import Document
from app.document.files import read, write
from app.document.store import Store
from app.lessons.player import Progress
from app.model.projection import Projection
from app.model.refusal import counted
from app.scenes.scene import load as load_scene
from tests import PATIENCE_S
from tests.support.carrier import carrier
from tests.support.commands import comma_locale, refused, refused_by_a_process, run
from tests.support.window import MakeWindow
from widgets.program import application, logs, opengl, report
from widgets.program import display as screen
from widgets.window.settings import Settings, data_folder, log_path, settings_path

__all__ = ["comma_locale"]

# The real program, in which `act(window)` is called once the window is shown.
DRIVER = """
import os, signal, sys
from PySide6.QtCore import QTimer
from widgets.window.main_window import MainWindow

def make_and_act(window, *arguments, make=MainWindow.__init__, **options):
    make(window, *arguments, **options)
    {when}

MainWindow.__init__ = make_and_act

def act(window):
{act}

from app.commands.cli import main
sys.exit(main(sys.argv[1:]))
"""


FILLED = "window.filled.connect(lambda: QTimer.singleShot(0, lambda: act(window)))"
PAINTED = "window.first_painted.connect(lambda: act(window))"


def driver(act: str, when: str = FILLED) -> list[str]:
    lines = "\n".join("    " + line for line in act.strip().splitlines())
    return [sys.executable, "-c", DRIVER.replace("{act}", lines).replace("{when}", when)]


def drive(act: str, *arguments: str | Path, when: str = FILLED) -> subprocess.CompletedProcess[str]:
    """Run the program, and do something in its window once that is filled, or only painted."""
    return subprocess.run(
        [*driver(act, when), *map(str, arguments)],
        cwd=ROOT, capture_output=True, text=True, check=False, timeout=PATIENCE_S,
    )  # fmt: skip


def picture(path: Path) -> np.ndarray:
    import pyvista as pv

    image = pv.read(path)
    width, height, _ = image.dimensions
    return np.asarray(image.point_data["PNGImage"]).reshape(height, width, -1)[::-1, :, :3]


# --------------------------------------------------------------------------- the display


@pytest.mark.parametrize(
    ("environment", "parts"),
    [
        ({"DISPLAY": None, "WAYLAND_DISPLAY": None, "QT_QPA_PLATFORM": None},
         ["There is no screen", "ssh with -X", "xvfb-run"]),
        ({"DISPLAY": ":9999", "WAYLAND_DISPLAY": None, "QT_QPA_PLATFORM": None},
         ["DISPLAY = :9999 does not answer"]),
        ({"DISPLAY": None, "WAYLAND_DISPLAY": "wayland-9", "XDG_RUNTIME_DIR": "/tmp",
          "QT_QPA_PLATFORM": "wayland"},
         ["WAYLAND_DISPLAY names none"]),
        ({"QT_QPA_PLATFORM": "nonsense"},
         ["QT_QPA_PLATFORM = nonsense: must be one of xcb, wayland"]),
        ({"MESA_GL_VERSION_OVERRIDE": "2.1"},
         ["OpenGL 2.1 is too old", "driver", "LIBGL_ALWAYS_SOFTWARE=1", "remote desktop"]),
    ],
)  # fmt: skip
def test_where_no_window_can_open_one_sentence_says_what_to_do(
    environment: dict[str, str | None], parts: list[str]
) -> None:
    done = run(**environment)
    assert (done.returncode, done.stdout) == (3, ""), done
    assert done.stderr.count("\n") == 1 and done.stderr.endswith(".\n"), done.stderr
    for part in parts:
        assert part in done.stderr


def test_a_missing_system_library_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> None:
        raise OSError("libxcb-cursor.so.0: cannot open shared object file")

    monkeypatch.setattr(screen.ctypes, "CDLL", missing)
    with (
        pytest.raises(opengl.DisplayError, match=r"libxcb-cursor\.so\.0.*doctor"),
        screen.display(),
    ):
        pytest.fail("a screen was promised")


class FakeXcb:
    """Stands in for libxcb: notes what is called, and refuses the first connections."""

    def __init__(self, refusals: int, calls: list[str]) -> None:
        self.refusals = refusals

        def note(name: str, answer: Callable[[], int]) -> Callable[..., int]:
            def called(*_arguments: object) -> int:
                calls.append(name)
                return answer()

            return called

        self.xcb_connect = note("connect", lambda: 1)
        self.xcb_connection_has_error = note("ask", self.refuse)
        self.xcb_disconnect = note("disconnect", lambda: 0)

    def refuse(self) -> int:
        self.refusals -= 1
        return int(self.refusals >= 0)


def test_an_x_server_never_loses_its_only_client_before_qt_comes(
    display: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Without any client it starts anew, and Qt, refused in that moment, would end the process.
    calls: list[str] = []
    monkeypatch.setattr(screen.ctypes, "CDLL", lambda name: FakeXcb(0, calls))
    monkeypatch.setattr(application.opengl, "prepare", lambda: None)
    monkeypatch.setattr(application, "QApplication", lambda _: calls.append("Qt") or display)
    application.make_application()
    assert calls == ["connect", "ask", "Qt", "disconnect"]


def test_an_x_server_that_is_starting_anew_is_asked_again(monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[str] = []
    monkeypatch.setattr(screen.ctypes, "CDLL", lambda name: FakeXcb(1, calls))
    monkeypatch.setattr(screen, "X_RETRIES_S", (0.0, 0.0))
    with screen.display():
        assert calls == ["connect", "ask", "disconnect", "connect", "ask"]


# --------------------------------------------------------------------------- OpenGL


def test_probe_finds_what_vtk_draws_with(display: Any) -> None:
    import pyvista as pv

    found = opengl.probe()
    plotter = pv.Plotter(off_screen=True, window_size=(20, 20))
    plotter.show(auto_close=False)
    details = plotter.render_window.ReportCapabilities()
    plotter.close()
    assert f"OpenGL renderer string:  {found.renderer}\n" in details
    assert re.match(r"[3-9]\.\d", found.version)
    assert found.software == ("llvmpipe" in found.renderer)


def test_software_renderers_are_recognised() -> None:
    for renderer in (
        "llvmpipe (LLVM 15.0.6, 256 bits)",
        "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (LLVM 16.0.0)), SwiftShader)",
        "GDI Generic",
        "Apple Software Renderer",
    ):
        assert opengl.is_software(renderer)
    for renderer in ("AMD Radeon RX 580 (polaris10, LLVM 15.0.6, DRM 3.49, 6.1.0)", "Apple M2"):
        assert not opengl.is_software(renderer)


def test_every_window_gets_a_core_profile_without_multisampling(display: Any) -> None:
    from PySide6.QtCore import QCoreApplication, Qt
    from PySide6.QtGui import QSurfaceFormat

    chosen = QSurfaceFormat.defaultFormat()
    assert (chosen.majorVersion(), chosen.minorVersion(), chosen.samples()) == (3, 2, 0)
    assert chosen.profile() == QSurfaceFormat.OpenGLContextProfile.CoreProfile
    assert QCoreApplication.testAttribute(Qt.ApplicationAttribute.AA_ShareOpenGLContexts)


# --------------------------------------------------------------------------- settings


@pytest.fixture
def ini(tmp_path: Path) -> Path:
    return tmp_path / "settings.ini"


def test_settings_come_back_as_they_were(ini: Path) -> None:
    settings = Settings(ini)
    settings.theme = "dark"
    settings.start_card = False
    settings.language = "sr_RS"
    settings.geometry = bytes(range(256))
    recent = ['/tmp/a, "b"; ž=%41\\n.json', "C:\\d\\e.json", "@Variant(x)", "/tmp/\U0001f600"]
    settings.recent = recent
    again = Settings(ini)
    assert (again.theme, again.start_card, again.language) == ("dark", False, "sr_RS")
    assert again.geometry == bytes(range(256))
    assert again.recent == recent


def test_settings_have_defaults_and_make_no_file_for_them(ini: Path) -> None:
    settings = Settings(ini)
    found = (settings.theme, settings.start_card, settings.language, settings.geometry)
    assert found == ("system", True, "", None)
    assert settings.recent == []
    assert not ini.exists()


@pytest.mark.parametrize(
    "line",
    [
        "theme=pink",
        "theme=dark, light",
        "start_card=1",
        "language=../../evil",
        "geometry=abcd efgh",
        f"geometry={'A' * 20_000}",
        'recent="[1, 2]"',
        'recent="{}"',
        f'recent="{"[" * 9_000}"',
        'recent="[\\"\\"]"',
        'progress="{\\"L3\\": {\\"done\\": -1}}"',
        'progress="[1]"',
        'progress="{"',
        'progress="{\\"L3\\": 1}"',
        'progress="{\\"L3\\": {\\"step\\": 2}}"',
    ],
)
def test_a_bad_value_is_the_default_and_the_others_stay(
    ini: Path, line: str, caplog: pytest.LogCaptureFixture
) -> None:
    name = line.partition("=")[0]
    others = {"theme": "dark", "start_card": "false"}
    others.pop(name, None)
    lines = ["[General]", line, *(f"{key}={text}" for key, text in others.items())]
    ini.write_text("\n".join(lines) + "\n", encoding="utf-8")
    settings = Settings(ini)
    for _ in range(2):
        assert getattr(settings, name) == getattr(Settings(None), name)
    assert settings.theme == others.get("theme", "system")
    assert settings.start_card == (name == "start_card")
    assert len([said for said in caplog.messages if f"setting {name} = " in said]) == 1
    assert not Path(f"{ini}.bak").exists()


@pytest.mark.parametrize(
    "content",
    [
        b"\xff\xfe[\0G\0e\0n\0",
        b"[General\ntheme=dark\n",
        b"[General]\ntheme=da\0rk\n",
        b"[General]\ntheme=@Variant(\\0\\0\\0\\x7f\\0\\0\\0\\xePyObject)\n",
        b'[General]\ntheme="@ByteArray(dark)"\n',
    ],
)
def test_a_broken_settings_file_is_set_aside(
    ini: Path, content: bytes, caplog: pytest.LogCaptureFixture
) -> None:
    ini.write_bytes(content)
    settings = Settings(ini)
    assert settings.theme == "system"
    assert Path(f"{ini}.bak").read_bytes() == content
    assert f"was damaged, and is kept as {ini}.bak" in caplog.text
    settings.theme = "dark"
    assert Settings(ini).theme == "dark"


@pytest.mark.undrawn
def test_the_window_says_which_settings_it_could_not_use(
    ini: Path, tmp_path: Path, make_window: MakeWindow
) -> None:
    ini.write_bytes(b"[General\n")
    window = make_window(settings=Settings(ini), shown=False)
    said = f"{ini} was damaged, and is kept as {ini}.bak. The default settings are used."
    assert window.messages.text == said
    folder = tmp_path / "a folder"
    folder.mkdir()
    window = make_window(settings=Settings(folder), shown=False)
    assert window.messages.text.startswith(f"{folder} cannot be read: ")
    window = make_window(settings=Settings(ini), shown=False)
    assert not window.messages.text


@pytest.mark.undrawn
def test_that_settings_cannot_be_written_is_said_once_and_tried_again(
    tmp_path: Path, make_window: MakeWindow, caplog: pytest.LogCaptureFixture
) -> None:
    # A link to nowhere: not even root can create a folder in its place.
    (tmp_path / "link").symlink_to(tmp_path / "nowhere")
    path = tmp_path / "link" / "settings.ini"
    window = make_window(settings=Settings(path), shown=False)
    window.settings.theme = "dark"
    assert window.messages.text.startswith(f"{path} cannot be written: File exists. ")
    window.messages.done()
    window.settings.keep_progress("L3", Progress("two", {"two/a": "1"}, 1, 4))
    assert not window.messages.text  # once
    assert len([m for m in caplog.messages if "settings cannot be written" in m]) == 1
    assert (window.settings.theme, window.settings.progress["L3"].step) == ("dark", "two")
    (tmp_path / "nowhere").mkdir()
    window.settings.start_card = False
    again = Settings(path)
    assert (again.theme, again.start_card, again.progress["L3"].done) == ("dark", False, 1)
    assert not window.messages.text


def test_a_settings_folder_in_place_of_the_file_is_no_obstacle(ini: Path) -> None:
    ini.mkdir()
    settings = Settings(ini)
    settings.theme = "dark"
    assert settings.theme == "dark"
    assert ini.is_dir()


def test_an_override_is_not_saved_and_ends_when_the_value_is_set(ini: Path) -> None:
    settings = Settings(ini)
    settings.theme = "dark"
    settings.override("theme", "light")
    settings.start_card = False
    assert settings.theme == "light"
    assert Settings(ini).theme == "dark"
    settings.theme = "system"
    assert settings.theme == Settings(ini).theme == "system"


def test_two_windows_do_not_undo_each_others_settings(ini: Path) -> None:
    one, other = Settings(ini), Settings(ini)
    one.theme, one.recent = "dark", ["/one"]
    other.start_card = False
    other.recent = ["/other", *other.recent]
    assert one.recent == ["/other", "/one"]
    again = Settings(ini)
    assert (again.theme, again.start_card, again.recent) == ("dark", False, one.recent)


@pytest.mark.undrawn
def test_two_windows_do_not_lose_each_others_recent_files(
    ini: Path, tmp_path: Path, make_window: MakeWindow
) -> None:
    paths = [tmp_path / name for name in ("one.json", "other.json", "given.json")]
    for path in paths:
        write(Document("cube"), path)
    one, other = (make_window(settings=Settings(ini), shown=False) for _ in range(2))
    assert not ini.exists()  # a start has nothing to write
    assert one.files.open(paths[0])
    assert other.files.open(paths[1])
    make_window(Document("cube"), settings=Settings(ini), path=paths[2], shown=False)
    newest_first = [str(path) for path in reversed(paths)]
    assert Settings(ini).recent == newest_first
    make_window(settings=Settings(ini), shown=False)
    assert Settings(ini).recent == newest_first
    assert [action.text() for action in other.menus.recent.actions()] == newest_first[1:]


def test_the_program_starts_with_broken_settings_and_keeps_new_ones(own_home: Path) -> None:
    ini = settings_path()
    assert ini.is_relative_to(own_home)
    ini.parent.mkdir(parents=True)
    ini.write_bytes(b"\0broken")
    act = "print(window.settings.theme); window.look.set_theme('dark'); window.close()"
    done = drive(act, when=PAINTED)
    assert (done.returncode, done.stdout, done.stderr) == (0, "system\n", "")
    assert Path(f"{ini}.bak").read_bytes() == b"\0broken"
    assert "was damaged, and is kept as" in log_path().read_text(encoding="utf-8")
    assert Settings(ini).theme == "dark"


def test_reset_deletes_the_settings_and_says_so_even_where_no_window_opens() -> None:
    ini = settings_path()
    settings = Settings(ini)
    settings.theme = "dark"
    assert ini.exists()
    done = run("--reset", DISPLAY=None, WAYLAND_DISPLAY=None)
    assert done.stdout == f"Settings deleted: {ini}\n"
    assert done.returncode == 3
    assert not ini.exists()
    done = run("--reset", DISPLAY=None, WAYLAND_DISPLAY=None)
    assert done.stdout == f"There are no settings to delete: {ini}\n"


def test_letters_that_are_uncertain_are_named_in_the_window(tmp_path: Path) -> None:
    """It is `café` in Latin-1."""
    lesson, document, mesh = (tmp_path / name for name in ("old.md", "old.json", "caf\xe9.obj"))
    lesson.write_bytes("---\ntitle: Caf\xe9\n---\n# One {#one}\nText.\n".encode("latin-1"))
    document.write_bytes(to_json(Document(mesh.name), str(tmp_path)).encode("latin-1"))
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
    act = f"""
from pathlib import Path
from PySide6.QtWidgets import QApplication
for opened, path in (("lessons", {str(lesson)!r}), ("files", {str(document)!r})):
    getattr(window, opened).open(Path(path))
    QApplication.processEvents()
    print(window.messages.text)
    window.messages.done()
window.store.mark_saved()
window.close()
"""
    done = drive(act, when=PAINTED)
    for path in (lesson, document):
        assert f"{path} is not UTF-8 text, some letters may be wrong" in done.stdout, done.stderr


# --------------------------------------------------------------------------- log and exceptions


@pytest.fixture
def own_logging() -> Iterator[logging.Logger]:
    """Take away what `start_log` adds."""
    root = logging.getLogger()
    handlers, level = list(root.handlers), root.level
    yield root
    logging.captureWarnings(False)
    for handler in set(root.handlers) - set(handlers):
        root.removeHandler(handler)
        handler.close()
    root.setLevel(level)
    for name in logs.IN_DETAIL:
        logging.getLogger(name).setLevel(logging.NOTSET)


def test_the_log_is_in_the_users_data_folder(own_home: Path, own_logging: logging.Logger) -> None:
    assert logs.start_log() is not None
    own_logging.warning("hello \udcff")
    text = log_path().read_text(encoding="utf-8")
    assert log_path().is_relative_to(own_home)
    assert "WARNING root: hello \\udcff" in text


def test_the_log_has_of_other_packages_only_warnings(own_logging: logging.Logger) -> None:
    """A PDF figure would fill it with the names of glyphs."""
    logs.start_log()
    for name in ("fontTools.subset", "widgets.program.application", "vtk"):
        logging.getLogger(name).info("information")
        logging.getLogger(name).warning("warning")
    lines = log_path().read_text(encoding="utf-8").splitlines()
    kept = [line.split(" ", 2)[2] for line in lines]
    assert kept == [
        "WARNING fontTools.subset: warning",
        "INFO widgets.program.application: information",
        "WARNING widgets.program.application: warning",
        "INFO vtk: information",
        "WARNING vtk: warning",
    ]


def test_the_folders_of_xdg_hold_everywhere(
    own_home: Path, monkeypatch: pytest.MonkeyPatch, display: Any
) -> None:
    """Where Qt does not ask for them, the tests would change the user's own settings."""
    by_qt = settings_path(), data_folder(), log_path()
    monkeypatch.setattr(QStandardPaths, "writableLocation", lambda _: "/elsewhere")
    mine = settings_path(), data_folder(), log_path()
    assert mine == by_qt and all(path.is_relative_to(own_home) for path in mine)
    for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME"):
        monkeypatch.setenv(name, "relative")
    assert data_folder() == settings_path().parent == Path("/elsewhere")


def test_the_log_does_not_grow_for_ever(
    own_logging: logging.Logger, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(logs, "LARGEST_LOG", 10_000)
    logs.start_log()
    for number in range(2_000):
        logging.getLogger("app").info("line %d of many", number)
    files = sorted(log_path().parent.iterdir())
    assert len(files) == 3
    assert max(file.stat().st_size for file in files) <= 10_000
    assert "line 1999 of many" in log_path().read_text(encoding="utf-8")


def test_a_log_on_a_full_disk_ends_with_one_line(
    own_logging: logging.Logger, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(logs, "log_path", lambda: Path("/dev/full"))
    assert logs.start_log() is not None
    for _ in range(3):
        own_logging.warning("hello")
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and "the log ends: [Errno 28]" in said


def test_an_unwritable_log_is_left_out(
    own_home: Path, own_logging: logging.Logger, monkeypatch: pytest.MonkeyPatch
) -> None:
    (own_home / "file").write_text("in the way", encoding="utf-8")
    monkeypatch.setenv("XDG_DATA_HOME", str(own_home / "file"))
    assert logs.start_log() is None


@pytest.fixture
def watch(display: Any, monkeypatch: pytest.MonkeyPatch) -> Iterator[report.ExceptionWatch]:
    # monkeypatch puts pytest's own hooks back.
    monkeypatch.setattr(sys, "excepthook", sys.excepthook)
    monkeypatch.setattr(threading, "excepthook", threading.excepthook)
    watch = report.ExceptionWatch(Path("the.log"))
    watch.install()
    yield watch
    if watch.report is not None:
        watch.report.close()
        watch.report.deleteLater()


def fail(display: Any, error: Exception) -> None:
    """Raise in a slot, and let Qt go on."""
    from PySide6.QtCore import QTimer

    def slot() -> None:
        raise error

    QTimer.singleShot(0, slot)
    for _ in range(3):
        display.processEvents()


def said(report: QWidget) -> str:
    return "\n".join(label.text() for label in report.findChildren(QLabel))


def test_an_exception_in_a_slot_is_logged_and_reported(
    watch: report.ExceptionWatch, display: Any, caplog: pytest.LogCaptureFixture
) -> None:
    fail(display, ValueError("the moon\nis new"))
    report = watch.report
    assert report is not None and report.isVisible() and not report.isModal()
    assert "ValueError: the moon is new" in said(report)
    assert "the.log" in said(report)
    assert "Traceback" in caplog.text and "the moon" in caplog.text
    (copy,) = (each for each in report.findChildren(QPushButton) if each.text() == "Copy details")
    copy.click()
    text = display.clipboard().text()
    assert "Traceback" in text and "in slot" in text and "ValueError: the moon" in text
    assert "PySide6" in text
    assert report.isVisible()


@pytest.mark.parametrize("when", ["first shown", "opened"])
def test_what_fails_in_a_panel_while_it_is_shown_is_reported_and_the_window_stays(
    watch: report.ExceptionWatch, display: Any, qtbot: Any, when: str
) -> None:
    from PySide6.QtCore import Qt
    from PySide6.QtWidgets import QToolButton, QVBoxLayout

    from widgets.window.drawer import Panels

    class Broken(QWidget):
        def showEvent(self, event: Any) -> None:
            super().showEvent(event)
            raise ValueError("the panel broke")

    holder, panels, broken, whole = QWidget(), Panels(), Broken(), QLabel("all is well")
    qtbot.addWidget(holder)
    column = QVBoxLayout(holder)
    column.addWidget(panels)
    column.addWidget(panels.names)
    panels.add("Broken", broken, "")
    panels.add("Whole", whole, "")
    if when == "first shown":
        panels.open(broken)
    application.show_window(holder)
    first, second = panels.names.findChildren(QToolButton)
    if when == "opened":
        assert watch.report is None
        qtbot.mouseClick(first, Qt.MouseButton.LeftButton)
    display.processEvents()
    assert watch.report is not None and "the panel broke" in said(watch.report)
    assert panels.isVisible() and panels.open_panel is broken
    qtbot.mouseClick(second, Qt.MouseButton.LeftButton)
    assert panels.open_panel is whole and whole.isVisible()


def test_repeated_exceptions_do_not_pile_up_windows(
    watch: report.ExceptionWatch, display: Any
) -> None:
    before = len(display.topLevelWidgets())
    for number, follows in enumerate(("", "Another error followed", "2 more errors followed")):
        fail(display, ValueError(f"number {number} of the moon's phases"))
        assert watch.report is not None and "number 0" in said(watch.report)
        assert follows in said(watch.report) and ("followed" in said(watch.report)) is bool(follows)
        for label in watch.report.findChildren(QLabel):
            assert label.height() >= label.heightForWidth(label.width()), "cut off"
    assert len(display.topLevelWidgets()) == before + 1
    watch.report.close()
    fail(display, KeyError("another day"))
    assert "another day" in said(watch.report) and "followed" not in said(watch.report)
    assert len(display.topLevelWidgets()) == before + 1


def test_a_report_waits_until_presenting_ends(watch: report.ExceptionWatch, display: Any) -> None:
    watch.put_off(True)
    for text in ("a new moon", "a full moon"):
        fail(display, ValueError(text))
    assert watch.report is not None and not watch.report.isVisible()
    watch.put_off(False)
    assert watch.report.isVisible()
    assert "a new moon" in said(watch.report) and "Another error" in said(watch.report)
    watch.put_off(True)
    assert not watch.report.isVisible()
    watch.put_off(False)
    watch.report.close()
    for waits in (True, False):
        watch.put_off(waits)
        assert not watch.report.isVisible(), "it was read"


def test_an_exception_in_a_thread_is_reported_too(
    watch: report.ExceptionWatch, display: Any
) -> None:
    thread = threading.Thread(target=lambda: 1 // 0)
    thread.start()
    thread.join()
    display.processEvents()
    assert watch.report is not None
    assert "ZeroDivisionError" in said(watch.report)


def test_a_report_that_fails_is_only_logged(
    watch: report.ExceptionWatch,
    display: Any,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
) -> None:
    monkeypatch.setattr(report.ErrorReport, "show_error", lambda *_: 1 // 0)
    fail(display, ValueError("the moon"))
    assert [m for m in caplog.messages if "report" in m] == ["the report itself failed"]


def test_the_program_outlives_an_exception_and_logs_what_qt_and_vtk_say() -> None:
    done = drive(
        """
from PySide6.QtCore import qWarning
from vtkmodules.vtkIOGeometry import vtkSTLReader
def after():
    from PySide6.QtWidgets import QApplication
    reports = [w for w in QApplication.topLevelWidgets() if type(w).__name__ == "ErrorReport"]
    print([report.isVisible() for report in reports])
    window.present.end()
    print([report.isVisible() for report in reports])
    reports[0].close()
    window.close()
QTimer.singleShot(0, lambda: QTimer.singleShot(0, after))
window.present.begin()
qWarning("a word of Qt")
reader = vtkSTLReader()
reader.SetFileName("/no/such.stl")
reader.Update()
raise LookupError("lost")
"""
    )
    assert (done.returncode, done.stdout) == (0, "[False]\n[True]\n"), "not before a class"
    # The terminal gets the exception, which is a fault of ours, and nothing of the rest.
    assert done.stderr.count("Traceback") == 1 and "LookupError: lost" in done.stderr
    assert "Qt" not in done.stderr and "such.stl" not in done.stderr
    text = log_path().read_text(encoding="utf-8")
    assert "WARNING qt: a word of Qt" in text
    assert re.search(r"ERROR vtk: .*\n?.*/no/such.stl", text)
    assert "LookupError: lost" in text
    assert "OpenGL" in text.splitlines()[0]


BROKEN = """
from app.drawings.image import ImageDrawing
from app.drawings.stage import StageDrawing
from app.drawings.world import WorldDrawing

def broken(*arguments):
    raise LookupError("no drawing")

for drawing in (ImageDrawing, StageDrawing, WorldDrawing):
    drawing.show_projection = broken
"""


def test_drawings_that_fail_when_first_shown_are_told_of() -> None:
    """Three of them at once: PySide6 forgot such exceptions, and broke when it painted."""
    act = """
reports = [w for w in QApplication.topLevelWidgets() if type(w).__name__ == "ErrorReport"]
print(len(reports), reports[0].findChild(QLabel).text())
window.grab()
reports[0].close()
window.close()
"""
    program = driver(act)
    program[2] = "from PySide6.QtWidgets import QApplication, QLabel" + BROKEN + program[2]
    done = subprocess.run(program, cwd=ROOT, capture_output=True, text=True, timeout=PATIENCE_S)
    told = "An error in the program: LookupError: no drawing. Your work is still there."
    assert done.stdout == f"1 {told} 2 more errors followed it.\n", done.stderr
    assert done.returncode == 1
    assert done.stderr.count("Traceback") == 3
    assert log_path().read_text(encoding="utf-8").count("no drawing") >= 3


HAND = """
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
for pane in window.panes.values():
    canvas = pane.canvas
    at = QPointF(50, 50)
    wheel = QWheelEvent(at, canvas.mapToGlobal(at), QPoint(), QPoint(0, 120),
                        Qt.MouseButton.NoButton, none, Qt.ScrollPhase.NoScrollPhase, False)
    QApplication.sendEvent(canvas, wheel)
    QTest.mouseMove(canvas, QPoint(60, 60))
    QTest.mousePress(canvas, left, none, QPoint(60, 60))
    QTest.mouseMove(canvas, QPoint(95, 80))
    QTest.mouseRelease(canvas, left, none, QPoint(95, 80))
    QTest.mouseClick(canvas, left, none, QPoint(60, 60))
    QTest.mouseDClick(canvas, left, none, QPoint(60, 60))
    canvas.setFocus(Qt.FocusReason.TabFocusReason)
    for key in (Qt.Key.Key_Left, Qt.Key.Key_Plus, Qt.Key.Key_Home):
        QTest.keyClick(canvas, key)
"""


@pytest.mark.parametrize("canvas", ["opengl", "raster"])
def test_the_window_is_seen_with_its_dock_before_vtk_is_imported(canvas: str) -> None:
    """What a quick hand does in the dock counts, and in the empty panes it does no harm."""
    done = drive(
        """
late = [name for name in sys.modules if name.startswith(("vtk", "pyvista", "matplotlib"))]
print(late, window.controls.rows["near"].field.text(), window.isVisible())
seen = {}
for name, pane in window.panes.items():
    pane.canvas.shown.connect(lambda name=name: seen.setdefault(name))
"""
        + HAND
        + """
field = window.controls.rows["near"].field
field.setFocus()
field.selectAll()
QTest.keyClicks(field, "2.5\\r")
def then():
    shown = window.panes["world"].drawing is not None and "vtkmodules" in sys.modules
    print(shown, window.store.document.projection.lens.near, "matplotlib.pyplot" in sys.modules)
    print(*seen)
    window.store.mark_saved()
    window.close()
window.filled.connect(lambda: QTimer.singleShot(300, then))
""",
        "--canvas",
        canvas,
        when=PAINTED,
    )
    assert done.stdout == "[] 5 True\nTrue 2.5 False\nworld image ndc\n", done.stderr
    assert (done.returncode, done.stderr) == (0, "")


def test_llvmpipe_gets_two_threads_a_core(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("LP_NUM_THREADS", raising=False)
    opengl.prepare()
    assert os.environ["LP_NUM_THREADS"] == str(2 * (os.cpu_count() or 1))
    monkeypatch.setenv("LP_NUM_THREADS", "1")
    opengl.prepare()
    assert os.environ["LP_NUM_THREADS"] == "1", "a user's choice stays"


def test_it_is_said_that_qt_has_no_opengl(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("QT_XCB_GL_INTEGRATION", "none")
    done = drive("print(window.status.currentMessage(), flush=True)\nwindow.close()")
    assert done.stdout == "Qt has no OpenGL here: VTK draws the panes off the screen.\n"


def test_a_window_is_closed_before_its_panes_are_filled() -> None:
    done = drive("window.close()", "--canvas", "opengl", when=PAINTED)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_a_window_that_is_closed_while_it_is_shown_ends_the_program() -> None:
    closing = "window.show = lambda show=window.show: (show(), window.close())"
    done = drive("pass", when=closing)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_no_picture_is_taken_of_a_window_that_is_not_whole(tmp_path: Path) -> None:
    picture = tmp_path / "window.png"
    command = ["--screenshot", str(picture)]
    program = [sys.executable, "-c", BROKEN + driver("pass")[2], *command]
    done = subprocess.run(program, cwd=ROOT, capture_output=True, text=True, timeout=PATIENCE_S)
    assert done.returncode == 2
    assert done.stderr.endswith(f"{picture}: the window could not be shown whole.\n")
    assert not picture.exists()


# --------------------------------------------------------------------------- the window


def test_ctrl_c_closes_the_window_and_ends_well(own_home: Path) -> None:
    with subprocess.Popen(
        driver("print('ready', flush=True)"),
        cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    ) as process:  # fmt: skip
        assert process.stdout and process.stderr
        try:
            assert process.stdout.readline() == "ready\n"
            process.send_signal(signal.SIGINT)
            # Nothing else wakes the program: an idle window runs no Python.
            assert process.wait(timeout=PATIENCE_S) == 0
        finally:
            process.kill()
        assert process.stderr.read() == ""
    assert "geometry" in settings_path().read_text(encoding="utf-8")  # it was closed, not killed
    assert not list(own_home.rglob("autosave-*"))


def test_a_second_ctrl_c_ends_a_program_that_still_asks(own_home: Path) -> None:
    act = """
from dataclasses import replace
projection = window.store.document.projection
window.store.set_projection(replace(projection, image_size=(640, 480)))
ask = window.files.may_discard
def asking():
    QTimer.singleShot(0, lambda: print("asking", flush=True))
    return ask()
window.files.may_discard = asking
print("ready", flush=True)
"""
    with subprocess.Popen(
        driver(act), cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout
        try:
            for expected in ("ready\n", "asking\n"):
                assert process.stdout.readline() == expected
                assert process.poll() is None
                process.send_signal(signal.SIGINT)
            assert process.wait(timeout=PATIENCE_S) == -signal.SIGINT
        finally:
            process.kill()


def test_the_window_shows_and_keeps_what_the_command_line_says(tmp_path: Path) -> None:
    path = tmp_path / "my.json"
    write(Document("cube", Projection(image_size=(300, 200))), path)
    done = drive(
        """
from PySide6.QtWidgets import QApplication, QMessageBox
from widgets.window.settings import data_folder
store = window.store
print(store.document.scene, store.document.projection.image_size, window.status.currentMessage())
print(window.files.path, window.settings.theme, window.width(), window.height())
window.recovery.autosave.save_now()
print(window.isWindowModified(), len(list(data_folder().glob("autosave-*.json"))))
store.undo()
print(store.modified, store.document.projection.lens.far)
store.redo()
def answer():
    QApplication.activeModalWidget().button(QMessageBox.StandardButton.Save).click()
QTimer.singleShot(0, answer)
window.close()
""",
        path, "--set", "lens.far=inf", "--theme=dark", "--size", "1200x700",
    )  # fmt: skip
    assert done.stderr == ""
    assert done.stdout.splitlines() == [
        "cube (300, 200) ", f"{path} dark 1200 700", "True 1", "False 30.0",
    ]  # fmt: skip
    assert read(path).projection.lens.far == math.inf
    assert Settings(settings_path()).theme == "system", "--theme was for this once"


@pytest.mark.parametrize(
    ("arguments", "is_unsaved"),
    [
        (["my.json"], False),
        (["my.json", "--set", "lens.near=1"], False),
        (["my.json", "--set", "lens.far=inf"], True),
        (["my.json", "--set", "scene=posts"], True),
        (["my.obj"], False),
        ([], False),
        (["--set", "scene=focus"], False),
        (["--set", "scene=cube", "--set", "lens.far=inf"], True),
    ],
)
def test_what_the_command_line_changes_is_unsaved(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: list[str], is_unsaved: bool
) -> None:
    monkeypatch.chdir(tmp_path)
    write(Document("cube", Projection()), Path("my.json"))
    Path("my.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
    given: list[Any] = []
    monkeypatch.setattr(application, "run_window", lambda *found: given.extend(found) or 0)
    assert main(arguments) == 0
    document, saved = given[:2]
    assert Store(document, saved=saved).modified == is_unsaved


@pytest.mark.undrawn
def test_a_picture_is_no_place_to_save_in_whatever_its_name(
    make_window: MakeWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    write(Document("cube"), Path("notes"))
    Path("figure").write_bytes(carrier(to_json(Document("cube"))))
    given: list[Any] = []
    monkeypatch.setattr(application, "run_window", lambda *found: given.append(found[2]) or 0)
    assert main(["notes"]) == main(["figure"]) == 0
    window = make_window(shown=False, drawn=False)
    for path, place in zip(given, (tmp_path / "notes", None), strict=True):
        window.files.note_opened(path)
        assert window.files.path == place


def test_a_mesh_is_loaded_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    mesh = tmp_path / "once.obj"
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", encoding="utf-8")
    loaded: list[str] = []

    def load(name: str, **options: Any) -> Any:
        loaded.append(name)
        return load_scene(name, **options)

    monkeypatch.setattr("app.scenes.scene.load", load)
    monkeypatch.setattr(application, "run_window", lambda *_found: 0)
    assert main([str(mesh)]) == 0
    assert loaded == [str(mesh)]


def test_a_document_whose_mesh_is_gone_is_refused(tmp_path: Path) -> None:
    path, gone = tmp_path / "my.json", str(tmp_path / "gone.stl")
    write(Document(gone), path)
    assert refused_by_a_process(path).startswith(f"{path}: {gone}")


def test_numbers_in_files_keep_their_points_in_every_locale(comma_locale: dict[str, str]) -> None:
    code = (
        "import ctypes, locale\n"
        "from widgets.program.application import make_application\n"
        "application = make_application()\n"
        "libc = ctypes.CDLL(None)\n"
        "libc.strtod.restype = ctypes.c_double\n"
        "print(libc.strtod(b'0.5', None))\n"
        "locale.setlocale(locale.LC_NUMERIC, '')\n"
        "print(libc.strtod(b'0.5', None))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=ROOT, env={**os.environ, **comma_locale}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    # The second number shows that the locale does what is guarded against.
    assert done.stdout == "0.5\n0.0\n", done.stderr


def test_the_translator_gives_qt_the_texts_of_the_language(display: Any) -> None:
    from PySide6.QtCore import QCoreApplication, QLocale

    from widgets.parts.translator import Translator

    translator = Translator(display)
    display.installTranslator(translator)
    try:
        assert QCoreApplication.translate("Report", "Copy details") == "Copy details"
        application.choose_language("hr")
        assert QLocale().language() == QLocale.Language.Croatian
        assert QCoreApplication.translate("Actions", "&File") == "&Datoteka"
        assert counted(22, "exercise") == "22 vježbe"
        assert QCoreApplication.translate("Nowhere", "as it is") == "as it is"
    finally:
        application.choose_language("en")
        display.removeTranslator(translator)
    assert QLocale() == QLocale.system()


# --------------------------------------------------------------------------- the screenshot


def test_screenshot_is_a_picture_of_the_whole_window(tmp_path: Path) -> None:
    Settings(settings_path()).theme = "dark"
    out = tmp_path / "window.png"
    done = run("--screenshot", out, "--size", "1366x768")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    light = picture(out)
    assert light.shape == (768, 1366, 3)
    assert np.median(light) > 200  # whatever the user's settings are
    # The panes are the left three quarters. Grabbed too early, each is of one colour.
    for pane in np.array_split(light[100:700, :1020], 3, axis=1):
        colours, counts = np.unique(pane @ [1, 256, 65536], return_counts=True)
        assert len(colours) > 50
        assert counts.sum() - counts.max() > 2_000
    done = run("--screenshot", out, "--theme", "dark", "--set", "lens.near=0.5")
    assert done.returncode == 0
    assert np.median(picture(out)) < 80
    # The settings were left alone.
    settings = Settings(settings_path())
    assert (settings.theme, settings.geometry) == ("dark", None)


def test_screenshot_to_a_place_that_is_not_there_is_refused(tmp_path: Path) -> None:
    assert "there is no folder" in refused("--screenshot", tmp_path / "no" / "a.png")
    assert "must end in .png" in refused("--screenshot", tmp_path / "a.jpg")


def test_doctor_reads_the_probe_of_another_process(display: Any) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "widgets.program.opengl"],
        cwd=ROOT, capture_output=True, text=True, check=True,
    )  # fmt: skip
    answer = json.loads(done.stdout)
    found = opengl.probe()
    assert (answer["version"], answer["renderer"]) == (found.version, found.renderer)
    assert answer["platform"] == display.platformName()
    assert len(answer["screens"]) == len(display.screens())


@pytest.mark.skipif(os.name != "posix", reason="the tool needs Xvfb")
def test_the_tool_that_uses_the_window_starts_and_finds_nothing_at_once() -> None:
    """A sample: ``python3 -m tests.fuzz hands`` goes on for hours."""
    command = [sys.executable, "-m", "tests.fuzz", "hands", "--minutes", "0.01", "--seed", "1"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0 and " 0 findings" in done.stdout, done.stdout + done.stderr


class Kept:
    """Garbage that only a collection finds, such as a widget with a closure over itself."""

    def __init__(self, gone: list[threading.Thread]) -> None:
        self.own, self._gone = self, gone

    def __del__(self) -> None:
        self._gone.append(threading.current_thread())


@pytest.mark.usefixtures("display")
def test_no_other_thread_destroys_the_window_s_garbage() -> None:
    gone, made = list[threading.Thread](), list[list[int]]()
    undo = application.collect_when_idle()
    try:
        Kept(gone)
        thread = threading.Thread(target=lambda: made.extend([n] for n in range(200_000)))
        thread.start()
        thread.join()
        assert not gone
        for _ in range(3):
            made.extend([n] for n in range(10_000))
            loop = QEventLoop()
            QTimer.singleShot(20, loop.quit)
            loop.exec()
        with python_packages.for_good():
            pass
        assert not gc.isenabled()
    finally:
        undo()
    assert gone == [threading.main_thread()] and gc.isenabled()
