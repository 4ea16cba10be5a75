"""What differs on Windows and macOS, simulated here: nothing of it has run there."""

from __future__ import annotations

import re
import sys
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QFontDatabase, QFontInfo, QKeySequence, QWindowStateChangeEvent

from widgets.parts import plain, typeset
from widgets.parts.layouts import push_button
from widgets.program import application, opengl
from widgets.window.actions import ways_to_press

SOFTWARE = opengl.OpenGL("3.3 Mesa 20.0", "llvmpipe", software=True)
CARD = opengl.OpenGL("4.6", "a graphics card", software=False)


@pytest.mark.parametrize(
    ("found", "asked", "draws", "canvas"),
    [
        (SOFTWARE, None, False, "opengl"),  # Qt brings its own, and VTK alone gets OpenGL 1.1
        (SOFTWARE, "raster", False, "opengl"),
        (SOFTWARE, None, True, "raster"),
        (CARD, None, False, "opengl"),
        (None, None, True, "raster"),
    ],
)
def test_windows_without_a_driver_draws_where_it_can(
    found: opengl.OpenGL | None,
    asked: str | None,
    draws: bool,
    canvas: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def probe() -> opengl.OpenGL:
        if found is None:
            raise opengl.DisplayError("No OpenGL could be started.")
        return found

    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(opengl, "probe", probe)
    monkeypatch.setattr(application, "draws_off_screen", lambda: draws)
    assert application.find_graphics(application.Options(canvas=asked))[1] == canvas


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


def test_on_macos_keys_in_texts_are_written_as_there(monkeypatch: pytest.MonkeyPatch) -> None:
    class Keys:
        SequenceFormat = QKeySequence.SequenceFormat

        def __init__(self, text: str) -> None:
            self.text = text

        def toString(self, _form: object) -> str:
            return self.text.replace("Ctrl+", "⌘").replace("Shift+", "⇧").replace("Alt+", "⌥")

    texts = "Find it (Ctrl+F)", "press Ctrl+2.", "as Ctrl+Shift+S; Alt+Right", "a + b"
    assert [*map(plain.with_native_keys, texts)] == [*texts]
    monkeypatch.setattr(sys, "platform", "darwin")
    monkeypatch.setattr(plain, "QKeySequence", Keys)
    native = "Find it (⌘F)", "press ⌘2.", "as ⌘⇧S; ⌥Right", "a + b"
    assert [*map(plain.with_native_keys, texts)] == [*native]
    assert plain.tip_of(texts[0]) == native[0]


def test_on_macos_each_function_key_has_a_second_way(monkeypatch: pytest.MonkeyPatch) -> None:
    keys = ["F4", "F5", "Shift+F5", "F6", "F7", "Ctrl+F", "B"]
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
