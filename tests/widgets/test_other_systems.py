"""What differs on Windows and macOS, simulated here: nothing of it has run there."""

import ctypes
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import PySide6
import pytest
from PIL import Image
from PySide6.QtCore import Qt
from PySide6.QtGui import QFontDatabase, QFontInfo, QKeySequence, QWindowStateChangeEvent

from app.bootstrap import ROOT
from tests.widgets import test_lesson_card as card
from widgets.parts import layouts, plain, typeset
from widgets.parts.layouts import push_button
from widgets.program import application, opengl
from widgets.window.help import ways_to_press

OFF_SCREEN = """
import sys
sys.path.insert(0, sys.argv[1])
from widgets.parts.translator import find_plugins, off_screen_application
print(off_screen_application().platformName(), find_plugins())
"""
SOFTWARE = opengl.OpenGL("3.3 Mesa 20.0", "llvmpipe", software=True)
CARD = opengl.OpenGL("4.6", "a graphics card", software=False)


@pytest.mark.parametrize(
    ("offered", "asked", "draws", "canvas", "is_through_qt"),
    [
        (SOFTWARE, None, False, "raster", True),  # Qt brings its own; VTK alone gets OpenGL 1.1
        (SOFTWARE, "opengl", False, "opengl", True),  # figures and comparisons are off the screen
        (SOFTWARE, None, True, "raster", False),
        (CARD, None, False, "opengl", False),
        (None, None, True, "raster", False),
    ],
)
def test_windows_without_a_driver_draws_where_it_can(
    offered: opengl.OpenGL | None,
    asked: str | None,
    draws: bool,
    canvas: str,
    is_through_qt: bool,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def probe() -> opengl.OpenGL:
        if offered is None:
            raise opengl.DisplayError("No OpenGL could be started.")
        return offered

    through: list[bool] = []
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(opengl, "probe", probe)
    monkeypatch.setattr(opengl, "draw_through_qt", lambda: through.append(True))
    monkeypatch.setattr(application, "draws_off_screen", lambda: draws)
    assert application.find_graphics(application.Options(canvas=asked))[1] == canvas
    assert bool(through) == is_through_qt


WITHOUT_A_DRIVER = """
import sys
from app.commands import arguments, cli
from app.drawings import off_screen
from widgets.program import application

class Windows:
    platform = "win32"
    def __getattr__(self, name):
        return getattr(sys, name)

def check():
    if off_screen.make_window is None:
        raise RuntimeError("There is OpenGL 1.1.")

off_screen.check_off_screen = check
off_screen.vtkRenderWindow = lambda: sys.exit("VTK ends the process")
arguments.sys = application.sys = Windows()
sys.exit(cli.main(sys.argv[1:]))
"""


@pytest.mark.parametrize(
    "words",
    ["export OUT --set scene=focus", "--screenshot OUT --canvas raster --set scene=depth-buffer"],
)
def test_what_is_drawn_through_qt_is_the_same(words: str, tmp_path: Path) -> None:
    """Also what a scene draws off the screen by itself: its blur, its count of wrong pixels."""
    pictures = []
    for script in (
        "import sys; from app.commands import cli; sys.exit(cli.main())",
        WITHOUT_A_DRIVER,
    ):
        out = tmp_path / f"{len(pictures)}.png"
        command = [sys.executable, "-c", script, *words.replace("OUT", str(out)).split()]
        subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
        with Image.open(out) as picture:
            pictures.append(np.asarray(picture.convert("RGB")))
    own, through_qt = (picture.astype(int) for picture in pictures)
    assert own.std() > 10
    assert np.abs(own - through_qt).max() <= 1  # each smooths by a shader of its own


def test_without_any_opengl_one_sentence_says_it(monkeypatch: pytest.MonkeyPatch) -> None:
    def probe() -> opengl.OpenGL:
        raise opengl.DisplayError("No OpenGL could be started.")

    monkeypatch.setattr(opengl, "probe", probe)
    monkeypatch.setattr(application, "draws_off_screen", lambda: False)
    with pytest.raises(opengl.DisplayError, match="No OpenGL"):
        application.find_graphics(application.Options())


def test_on_macos_a_button_has_the_shortcut_that_its_tip_promises(
    display: Any, qtbot: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "platform", "darwin")
    pressed: list[bool] = []
    button = push_button("H&int", "Show the next hint (Alt+I)", lambda: pressed.append(True))
    qtbot.addWidget(button)
    assert button.shortcut() == QKeySequence("Alt+I")
    assert push_button("Fish && chips").shortcut().isEmpty()


@pytest.fixture
def without_mnemonics(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Qt as it is on macOS."""
    monkeypatch.setattr(layouts, "sys", SimpleNamespace(platform="darwin"))
    (library,) = Path(PySide6.__file__).parent.glob("Qt/lib/libQt6Gui.so.*")
    switch = ctypes.CDLL(str(library))["_Z29qt_set_sequence_auto_mnemonicb"]
    switch(False)
    assert QKeySequence.mnemonic("H&int").isEmpty()
    yield
    switch(True)


@pytest.mark.undrawn
@pytest.mark.skipif(sys.platform != "linux", reason="the switch has another name elsewhere")
@pytest.mark.usefixtures("without_mnemonics")
def test_on_macos_a_step_shares_the_keys_that_its_tips_promise(window: Any, tmp_path: Path) -> None:
    """Its hints come by Alt+I."""
    card.test_the_keys_of_several_questions_are_those_of_the_one_with_the_cursor(window, tmp_path)


def test_on_macos_keys_in_texts_are_written_as_there(monkeypatch: pytest.MonkeyPatch) -> None:
    class Keys:
        SequenceFormat = QKeySequence.SequenceFormat

        def __init__(self, text: str) -> None:
            self.text = text

        def toString(self, _form: object) -> str:
            return self.text.replace("Ctrl+", "⌘").replace("Shift+", "⇧").replace("Alt+", "⌥")

    texts = "Find it (Ctrl+F)", "press Ctrl+2.", "as Ctrl+Shift+S; Alt+Right", "a + b"
    monkeypatch.setattr(sys, "platform", "linux")
    assert [*map(plain.with_native_keys, texts)] == [*texts]
    monkeypatch.setattr(sys, "platform", "darwin")
    monkeypatch.setattr(plain.QtGui, "QKeySequence", Keys)
    native = "Find it (⌘F)", "press ⌘2.", "as ⌘⇧S; ⌥Right", "a + b"
    assert [*map(plain.with_native_keys, texts)] == [*native]
    assert plain.tip_of(texts[0]) == native[0]


def test_on_macos_each_function_key_has_a_second_way(monkeypatch: pytest.MonkeyPatch) -> None:
    keys = ["F4", "F5", "Shift+F5", "F6", "F7", "Ctrl+F", "B"]
    monkeypatch.setattr(sys, "platform", "linux")
    assert [ways_to_press(key) for key in keys] == [[QKeySequence(key)] for key in keys]
    monkeypatch.setattr(sys, "platform", "darwin")
    ways = [[way.toString() for way in ways_to_press(key)] for key in keys]
    assert ways[:3] == [["F4", "Meta+4"], ["F5", "Meta+5"], ["Shift+F5", "Meta+Shift+5"]]
    assert ways[5:] == [["Ctrl+F"], ["B"]]


@pytest.mark.undrawn
def test_a_full_screen_that_comes_slowly_does_not_end_the_presentation(window: Any) -> None:
    """macOS animates it: the first change of state comes before the window fills the screen."""
    present = window.present
    present.begin()
    for former, goes_on in (
        (Qt.WindowState.WindowNoState, True),
        (Qt.WindowState.WindowFullScreen, False),
    ):
        window.setWindowState(Qt.WindowState.WindowNoState)
        window.installEventFilter(present)
        present.is_on = True
        present.eventFilter(window, QWindowStateChangeEvent(former))
        assert present.is_on == goes_on
    present.end()


def test_words_on_paper_have_the_font_that_comes_with_matplotlib(
    display: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    brought: list[str] = []
    add = QFontDatabase.addApplicationFont
    monkeypatch.setattr(
        QFontDatabase, "addApplicationFont", lambda path: brought.append(path) or add(path)
    )
    typeset.bring_font.cache_clear()
    assert QFontInfo(typeset.words_font()).family() == "DejaVu Sans"
    typeset.words_font()
    assert len(brought) == 1 and re.search(r"matplotlib.*DejaVuSans\.ttf$", brought[0])


@pytest.mark.skipif(sys.platform == "win32", reason="links to folders")
@pytest.mark.parametrize("name", ["Horvat, Ivan", "lab; 2", 'a "b" c', "a\\b", "plain"])
def test_qt_finds_its_plugins_in_a_folder_of_any_name(name: str, tmp_path: Path) -> None:
    """PySide's own text for Qt would end the path, and Qt end the program."""
    (tmp_path / name).mkdir()
    plugins = Path(PySide6.__path__[0], "Qt", "plugins")
    for package in ("PySide6", "shiboken6"):
        (tmp_path / name / package).symlink_to(plugins.parents[2] / package)
    command = [sys.executable, "-c", OFF_SCREEN, str(tmp_path / name)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.stdout.split(maxsplit=1) == ["offscreen", f"{plugins.resolve()}\n"], done.stderr
