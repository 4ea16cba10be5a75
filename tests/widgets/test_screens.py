"""Two screens: the class has the external one, the notes stay with the speaker."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from matplotlib.font_manager import fontManager
from PySide6.QtGui import QFontDatabase

from app.bootstrap import ROOT
from tests import PATIENCE_S
from tests.__main__ import own_screen

# A program of its own, on a server of its own: Qt knows the screens of its first one only.
OPENED = """
import sys
from pathlib import Path
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from tests.support.monitors import Monitors
monitors = Monitors(sys.argv[1])
monitors.set("laptop", 0, 800, 600, real=True)
monitors.set("projector", 800, 1000, 700, real=False)
from widgets.program.opengl import prepare
from PySide6.QtWidgets import QApplication
prepare()
application = QApplication([])
from app.document.document import Document
from app.scenes.scene import load
from tests.support.opened import opened
from widgets.window.settings import Settings
settings = Settings(Path("two.ini"))
window = opened(Document("cube", load("cube").start), settings=settings, drawn=False)
window.setGeometry(10, 36, 780, 560)
QApplication.processEvents()
place = window.geometry()
window.files.open(Path(sys.argv[2]))
"""
ON_TWO_SCREENS = """
def say(what, presents, screen, speaker=""):
    def found():
        notes = window.talks.speaker
        has = notes.windowHandle().screen().name() if notes is not None and speaker else ""
        return window.present.is_on, window.windowHandle().screen().name(), has
    for _ in range(200):
        if found() == (presents, screen, speaker):
            break
        QTest.qWait(10)
    print(what, found() == (presents, screen, speaker) or found())

def press(key, widget=window):
    QTest.keyClick(widget, key)

say("before", False, "laptop")
window.menus.present.trigger()
say("F5", True, "projector", "laptop")
press(Qt.Key.Key_W)
say("W", True, "laptop", "projector")
press(Qt.Key.Key_Escape)
say("Esc", False, "laptop")
for _ in range(200):
    if window.geometry() == place:
        break
    QTest.qWait(10)
print("place", window.geometry() == place or (window.geometry(), place))
window.menus.present.trigger()
say("remembered", True, "laptop", "projector")
press(Qt.Key.Key_W, window.talks.speaker)
say("W in the notes", True, "projector", "laptop")
monitors.unplug("projector")
say("unplugged", True, "laptop", "laptop")
monitors.set("projector", 800, 1000, 700, real=False)
say("plugged in", True, "projector", "laptop")
window.menus.present.trigger()
say("end", False, "laptop")
monitors.unplug("projector")
window.menus.present.trigger()
say("one screen", True, "laptop", "laptop")
window.store.mark_saved()
window.close()
monitors.close()
"""
WHAT_A_CLASS_READS = """
window.lessons.go(2)
shares = []

def say(what, screen):
    def found():
        height, em = min(screen.size().toTuple()), window.slide.equation.em_in(1e9, 1e9)
        letters = QApplication.font().pointSizeF() / height
        return round(letters, 6), round(em / height, 6), window.height() == screen.size().height()
    for _ in range(200):
        if window.screen() is screen and found() in (shares or [found()]):
            break
        QTest.qWait(10)
    shares.append(found())
    print(what, window.screen() is screen and shares[-1] == shares[0] or shares)

laptop, projector = QApplication.screens()
window.slots.toggle_float("image")
window.panes["image"].setGeometry(900, 100, 300, 300)
window.menus.present.trigger()
say("F5", projector)
for swapped in (laptop, projector):
    QTest.keyClick(window, Qt.Key.Key_W)
    say("W", swapped)
monitors.unplug("projector")
say("unplugged", laptop)
for _ in range(200):
    if laptop.geometry().contains(window.panes["image"].geometry()):
        break
    QTest.qWait(10)
monitors.set("upright", 800, 800, 1000, real=False)
for _ in range(200):
    if len(QApplication.screens()) == 2:
        break
    QTest.qWait(10)
say("upright", QApplication.screens()[-1])
print("the floating pane", laptop.geometry().contains(window.panes["image"].geometry()))
window.store.mark_saved()
window.close()
monitors.close()
"""


@pytest.mark.skipif(sys.platform != "linux", reason="an X server of our own")
def test_a_persons_screen_and_fonts_are_not_used(display: Any) -> None:
    assert os.environ["DISPLAY"] in os.environ["TEST_DISPLAYS"].split()
    assert display.primaryScreen().size().toTuple() == (1920, 1080)
    fonts = {name.partition(" ")[0] for name in QFontDatabase.families()}
    # A fontconfig that reads its fonts again shows all of matplotlib's.
    ours = [each.name for each in fontManager.ttflist if "mpl-data" in each.fname]
    allowed = {name.partition(" ")[0] for name in ours}
    assert "DejaVu" in fonts
    assert fonts - {"Sans", "Serif", "Monospace"} <= allowed  # the three are no fonts


@pytest.mark.skipif(sys.platform != "linux", reason="an X server with RandR")
@pytest.mark.parametrize(("steps", "count"), [(ON_TWO_SCREENS, 11), (WHAT_A_CLASS_READS, 6)])
def test_the_class_has_the_external_screen_and_the_speaker_the_other(
    tmp_path: Path, steps: str, count: int
) -> None:
    talk = ROOT / "app" / "lessons" / "content" / "talk-000.md"
    with own_screen() as display:
        done = subprocess.run(
            [sys.executable, "-c", OPENED + steps, display, str(talk)],
            cwd=tmp_path, capture_output=True, text=True, check=False, timeout=PATIENCE_S,
            env={**os.environ, "DISPLAY": display, "PYTHONPATH": str(ROOT)},
        )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    lines = done.stdout.splitlines()
    assert len(lines) == count and all(line.endswith(" True") for line in lines), done.stdout
