"""Use the window as a restless person does: random mouse, keys, menus, files and sizes.

``python3 -m tests.fuzz hands --minutes 20 --seed 1`` opens the window on a screen and in a home of
its own, with motion on. Each step draws what it does from the seed and its own number, so that
``--seed 1 --steps 500`` does the first 500 steps again, as far as Qt's timing permits. Mouse and
keys go through Qt's windows like real ones: to what lies on top, so to menus and dialogs first.

A finding is a warning or an error in the log (an exception, or of the program, Python, Qt or VTK),
a pane that outlives its window, a step that takes more than `LONGEST_S` of processor time, a crash,
or `LONGEST_SILENCE_S` without a step. Each is printed with its step and the last `SHOWN` steps; one
that comes back is only counted. The summary has memory, widgets, open files and the log's size.

The program runs as a copy, because a user may add steps and strokes to the lessons beside it.
"""

import argparse
import collections
import ctypes
import faulthandler
import gc
import logging
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import traceback
import weakref
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import matplotlib.font_manager  # noqa: F401  (it warns where it reads all fonts, once a machine)
import psutil
import shiboken6
from PySide6 import QtCore, QtGui, QtWidgets
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.bootstrap import ROOT
from app.document.codec import to_json
from app.document.document import Document
from app.drawings import image, stage, world  # noqa: F401  (VTK, whose import is no step)
from app.held_lock import die_with_parent
from app.lessons.contents import CONTENT as LESSONS
from app.scenes.scene import BUILT_IN, load
from tests.__main__ import at_home
from tests.fuzz.files import ENDINGS, NUMBERS, write_hostile
from tests.fuzz.hostile import a_folder
from tests.support.controls import NONSENSE
from tests.support.meshes import WRITERS, pyramid_file
from tests.support.opened import delete_what_is_due
from tests.support.tools import ToolParser
from tests.support.window import LEFT, NO_KEY, settle
from widgets.panes.canvas import CANVASES
from widgets.program import application, logs, opengl
from widgets.program.report import ExceptionWatch
from widgets.window.main_window import MainWindow
from widgets.window.settings import Settings, log_path, settings_path

IN_A_WINDOW = "--in-a-window"
SHOWN = 30
LONGEST_S = 2.0
LONGEST_SILENCE_S = 300.0
MEASURED_S = 60.0
PATIENCE = 12
"""Steps after which a menu or a dialog is left."""
NESTED_S = 0.3
"""Time after which a step that has not ended waits in a dialog of its own."""
DROPPED_MS = 300
"""A text that is being dragged is dropped within that time."""
SIZES = ((1366, 768), (1920, 1080), (900, 600), (1280, 720))
PAUSES_MS = (0, 0, 0, 0, 10, 10, 30, 30, 100, 400)
OFTEN = (
    *("PgDown", "PgDown", "Alt+Right", "Alt+Right", "PgUp", "Alt+Left", "F5", "F6", "F7", "Esc"),
    *("Return", "Tab", "Space", "Down", "Right", "Ctrl+Z", "Ctrl+Shift+Z", "V", "Shift+F6"),
)
KEYS = (
    *("Up", "Left", "Home", "End", "Backspace", "Del", "Shift+Tab", "Shift+PgDown", "Shift+Return"),
    *("Shift+Right", "Shift+Up", "+", "-", ".", "/", "B", "C", "D", "E", "K", "N", "P", "W", "X"),
    *("Ctrl++", "Ctrl+-", "Ctrl+A", "Ctrl+C", "Alt+I", "Alt+W", "Alt+S", "F2", "F10"),
    *map(str, range(10)),
)
"""Keys that are no shortcuts of an action: of ``widgets/window/keys.md``, and of every text."""
UNPRESSED = {"Ctrl+Q", "Find"}
"""The first closes the window too often, and QTest does not know the second."""
WORTH: tuple[tuple[Any, float], ...] = (
    (tuple(CANVASES.values()), 15.0),
    (QtWidgets.QPushButton, 8.0),
    ((QtWidgets.QMenu, QtWidgets.QMenuBar), 6.0),
    ((QtWidgets.QAbstractButton, QtWidgets.QTabBar), 3.0),
    ((QtWidgets.QAbstractSlider, QtWidgets.QLineEdit, QtWidgets.QComboBox), 2.0),
)
"""How often the mouse goes to a kind of widget; to all others once."""


class Findings(logging.Handler):
    """What is wrong, from the log and from others; each is printed when it comes first."""

    def __init__(self, seed: int, trail: Path) -> None:
        super().__init__(logging.WARNING)
        self.seed, self.step = seed, 0
        self.counts: collections.Counter[str] = collections.Counter()
        self._last: collections.deque[str] = collections.deque(maxlen=SHOWN)
        self.shown: Callable[[], str] = str
        """Tells what the window shows."""
        self._trail = trail.open("w", encoding="utf-8", errors="backslashreplace", buffering=1)

    def note(self, text: str) -> None:
        """Write down what is done next: after a crash, the file tells it."""
        self._last.append(f"{self.step} {text}")
        print(self._last[-1], file=self._trail)

    def emit(self, record: logging.LogRecord) -> None:
        text = f"{record.levelname} {record.name}: {record.getMessage()}"
        key = re.sub(r"[\d.]+|'.*'", "#", text)
        if record.exc_info:
            lines = traceback.format_exception(*record.exc_info)
            key = "".join(lines[-2:])
        else:
            lines = traceback.format_stack()
        own = [line for line in lines if "/tests/" not in line and "/logging/" not in line]
        self.add(f"{text}\n{''.join(own)}{self.shown()}", key)

    def slow(self, spent_s: float) -> None:
        act = self._last[-1].partition(" ")[2]
        self.add(f"{spent_s:.1f} s of processor time for the last step", f"slow: {act}")

    def add(self, text: str, key: str) -> None:
        self.counts[key] += 1
        if self.counts[key] == 1:
            lines = "\n    ".join(self._last)
            print(f"\nFINDING, seed {self.seed}, step {self.step}: {text}\n    {lines}", flush=True)


class Hands:
    """Acts step by step, also while a step waits in a dialog."""

    def __init__(self, folder: Path, options: argparse.Namespace) -> None:
        self.folder, self.options = folder, options
        self.findings = Findings(options.seed, folder / "trail")
        self.note, self.findings.shown = self.findings.note, self._shown
        self.files, self.rng = some_files(folder), random.Random()
        self.window: Any = None
        self.opened = self.depth = 0
        self.states: collections.Counter[str] = collections.Counter()
        self.measures: list[tuple[int, int]] = []
        self.began = self._measured = self._acted = time.monotonic()
        self._used, self.slowest = time.thread_time(), 0.0
        self._on_top, self._patience = None, 0
        for ask in ("getOpenFileName", "getSaveFileName"):  # Qt's own dialog could delete files
            setattr(QtWidgets.QFileDialog, ask, staticmethod(self._answer))

    def _answer(self, _parent: Any = None, _title: str = "", place: str = "", *_: Any) -> Any:
        """The file that the person chooses in a file dialog; none at times."""
        name = self.folder / f"{self.rng.choice('abc')}{Path(place).suffix}"
        path = name if name.suffix else self.rng.choice(self.files)
        return ("" if self.rng.random() < 0.25 else str(path)), ""

    def _shown(self) -> str:
        return "" if self.window is None else to_json(self.window.store.document)

    # -- the window

    def open(self) -> None:
        """Open a window, as the program does."""
        scene, found = self.rng.choice(list(BUILT_IN)), opengl.probe()
        self.note(f"opens a window on {scene}")
        self.window = MainWindow(
            Document(scene, load(scene).start), settings=Settings(settings_path()),
            software_rendering=found.software, canvas=opengl.canvas(found),
        )  # fmt: skip
        self.window.first_painted.connect(self.window.open_panes)
        if self.rng.random() < 0.3:
            self.window.filled.connect(self.window.show_start_card)
        self.opened += 1
        application.show_window(self.window)
        self.window.activateWindow()

    def forget(self) -> None:
        """Forget the closed window, and see that nothing holds its panes."""
        canvases = [weakref.ref(pane.canvas) for pane in self.window.panes.values()]
        self.window.deleteLater()
        self.window = self._on_top = None
        sys.last_exc = sys.last_value = sys.last_traceback = None  # they hold frames
        settle()
        delete_what_is_due()
        gc.collect()
        if left := sum(canvas() is not None for canvas in canvases):
            self.findings.add(f"{left} panes outlive their window", "panes outlive their window")

    # -- steps

    def beat(self) -> None:
        """Do the next step, unless one is under way and waits in no dialog."""
        if self.depth and not (self._top() and time.monotonic() - self._acted > NESTED_S):
            QTimer.singleShot(10, self.beat)
            return
        steps, minutes = self.options.steps, (time.monotonic() - self.began) / 60.0
        if self.findings.step >= steps if steps else minutes > self.options.minutes:
            QApplication.exit()  # not `quit`, which asks whether to save
            return
        QTimer.singleShot(self.rng.choice(PAUSES_MS), self.beat)  # first: the step may be long
        self._take_time()
        self.findings.step += 1
        self.rng.seed(f"{self.options.seed} {self.findings.step}")
        self.depth += 1
        try:
            self.step()
        finally:
            self.depth -= 1
            self._acted = time.monotonic()

    def _take_time(self) -> None:
        """See how long the last step took, with all that followed from it."""
        self._acted, used = time.monotonic(), time.thread_time()
        spent, self._used = used - self._used, used
        self.slowest = max(self.slowest, spent)
        if spent > LONGEST_S:
            self.findings.slow(spent)
        if self._acted - self._measured > MEASURED_S:
            self.measure()

    def measure(self) -> None:
        """Print how much the program holds."""
        self._measured, process = time.monotonic(), psutil.Process()
        held = [process.memory_full_info().uss]
        gc.collect()
        if trim := getattr(ctypes.CDLL(None), "malloc_trim", None):
            trim(0)  # what the C library keeps for later would hide what the program keeps
        held.append(process.memory_full_info().uss)
        files = process.num_fds() if hasattr(process, "num_fds") else len(process.open_files())
        log = sum(each.stat().st_size for each in log_path().parent.glob(f"{log_path().name}*"))
        self.measures.append((self.findings.step, held[1]))
        print(
            f"{(self._measured - self.began) / 60.0:.1f} min, step {self.findings.step}:"
            f" {held[0] >> 20} MiB, {held[1] >> 20} of them in use, {files} files, log {log} bytes,"
            f" {len(QApplication.allWidgets())} widgets, window {self.opened}",
            flush=True,
        )

    def _top(self) -> Any:
        """The menu or dialog that takes all mouse and keys."""
        return QApplication.activePopupWidget() or QApplication.activeModalWidget()

    def step(self) -> None:
        """Do one random thing."""
        top = self._top()
        self._patience = self._patience + 1 if top is not None and top is self._on_top else 0
        self._on_top = top
        if self._patience > PATIENCE:
            self.note(f"leaves {name_of(top)}")
            top.reject() if isinstance(top, QtWidgets.QDialog) else top.close()
        elif self.window is not None and self.window.isVisible():
            self._count_states(top)
            if top is None and QApplication.activeWindow() is None:
                self.window.activateWindow()
            acts = BY_HAND if top is not None else BY_HAND | WITH_THE_WINDOW
            self.rng.choices(list(acts), list(acts.values()))[0](self)
            settle()
        elif self.depth == 1:
            if self.window is not None:
                self.forget()
            self.open()

    def _count_states(self, top: Any) -> None:
        """Count what the window shows: whether the steps reach everything."""
        window = self.window
        lesson, talks = window.lessons.lesson, window.talks
        self.states.update({
            "Present": window.present.is_on, "a lesson": lesson is not None,
            "a talk in Present": talks.is_on, "a comparison": window.comparing.pictures.is_on,
            "a held picture in a lesson": window.comparing.pictures.is_on and lesson is not None,
            "motion": window.lessons.is_moving, "the pen": window.menus.pen.isChecked(),
            "the speaker's window": talks.speaker is not None, "a dialog or menu": top is not None,
            "a test or review": lesson is not None and not talks.has_lesson,
            "a pane's own window": any(pane.isWindow() for pane in window.panes.values()),
        })  # fmt: skip

    # -- what a hand does

    def _target(self) -> tuple[Any, QPoint, str]:
        """A place in one of Qt's windows that the mouse can reach, and what is there."""
        windows = [each for each in QApplication.topLevelWidgets() if each.isVisible()]
        likely = [8.0 if each is self.window else 1.0 for each in windows]
        window = self._top() or self.rng.choices(windows, likely)[0]
        inside = [each for each in window.findChildren(QtWidgets.QWidget) if each.isVisible()]
        inside = [window, *(each for each in inside if each.window() is window)]
        worth = [next((w for kinds, w in WORTH if isinstance(each, kinds)), 1.0) for each in inside]
        widget = self.rng.choices(inside, worth)[0]
        seen = widget.visibleRegion().boundingRect()
        if seen.isEmpty():
            widget, seen = window, window.rect()
        x = self.rng.randint(seen.left(), seen.right())
        y = self.rng.randint(seen.top(), seen.bottom())
        what = f"{name_of(widget)} at {x}, {y}" + f" of {name_of(window)}" * (widget is not window)
        return window.windowHandle(), widget.mapTo(window, QPoint(x, y)), what

    def _modifier(self) -> Any:
        keys = Qt.KeyboardModifier
        return self.rng.choice((NO_KEY, NO_KEY, NO_KEY, keys.ShiftModifier, keys.ControlModifier))

    def _button(self) -> Any:
        return self.rng.choice((LEFT, LEFT, LEFT, LEFT, Qt.MouseButton.RightButton))

    def _release(self, handle: Any, button: Any, place: QPoint) -> None:
        """Release the button, even if the press has closed the window."""
        if handle not in QtGui.QGuiApplication.allWindows():
            handle = self.window.windowHandle()
        QTest.mouseRelease(handle, button, NO_KEY, place)

    def _move(self, handle: Any, place: QPoint) -> bool:
        """Move the mouse; False if the window is gone, as a menu is while another one opens."""
        if shiboken6.isValid(handle):
            QTest.mouseMove(handle, place)
        return shiboken6.isValid(handle)

    def click(self) -> None:
        (handle, place, what), button, key = self._target(), self._button(), self._modifier()
        twice = self.rng.random() < 0.15 and QApplication.activePopupWidget() is None
        self.note(f"{'double-' * twice}clicks {button.name} {key.name} on {what}")
        if not self._move(handle, place):
            return
        if twice:
            QTest.mouseDClick(handle, button, key, place)
        else:
            QTest.mousePress(handle, button, key, place)
            self._release(handle, button, place)

    def hover(self) -> None:
        handle, place, what = self._target()
        self.note(f"moves the mouse to {what}")
        self._move(handle, place)

    def wheel(self) -> None:
        (handle, place, what), key = self._target(), self._modifier()
        turn = self.rng.choice((-360, -120, -15, 15, 120, 360))
        self.note(f"turns the wheel by {turn} {key.name} on {what}")
        if shiboken6.isValid(handle):  # finding a target may have closed its window
            QTest.wheelEvent(handle, place, QPoint(0, turn), stateKey=key)

    def drag(self, meanwhile: Callable[[], object] = lambda: None) -> None:
        """Drag, and do something else before the release."""
        (handle, place, what), button, key = self._target(), self._button(), self._modifier()
        moves = self.rng.randint(1, 8)
        self.note(f"drags {button.name} {key.name} {moves} times from {what}")
        if not self._move(handle, place):
            return
        QTest.mousePress(handle, button, key, place)
        for _ in range(moves):
            if handle in QtGui.QGuiApplication.allWindows():
                place += QPoint(self.rng.randint(-80, 80), self.rng.randint(-60, 60))
                place.setX(min(max(place.x(), 0), handle.width() - 1))
                place.setY(min(max(place.y(), 0), handle.height() - 1))
                QTest.mouseMove(handle, place)
        meanwhile()
        self._release(handle, button, place)

    def key(self) -> None:
        actions = self.window.findChildren(QtGui.QAction)
        shortcuts = {each.toString() for action in actions for each in action.shortcuts()}
        keys = self.rng.choice((OFTEN, OFTEN, KEYS, sorted(shortcuts - UNPRESSED)))
        key = self.rng.choice(keys)
        self.press(key)
        if key.isdigit():
            self.press("Return")

    def press(self, key: str) -> None:
        top, pressed = QApplication.activePopupWidget(), QtGui.QKeySequence(key)[0]
        handle = top.windowHandle() if top else QtGui.QGuiApplication.focusWindow()
        handle = handle or self.window.windowHandle()
        # Alt alone closes a menu, and QTest would send the rest to the window that is gone.
        held = NO_KEY if top else pressed.keyboardModifiers()
        self.note(f"presses {key} in {name_of(top or QApplication.focusWidget() or self.window)}")
        QTest.keyPress(handle, pressed.key(), held)
        if handle in QtGui.QGuiApplication.allWindows():
            QTest.keyRelease(handle, pressed.key(), held)

    def type(self) -> None:
        """Type or paste into a field, and mostly press Enter."""
        window = self._top() or QApplication.activeWindow() or self.window
        fields = [each for each in window.findChildren(QtWidgets.QLineEdit) if each.isVisible()]
        if not fields:
            return self.key()
        field = self.rng.choice(fields)
        number = f"{self.rng.uniform(-20.0, 200.0):.{self.rng.randrange(5)}f}"
        text = self.rng.choice((number, number, self.rng.choice([*NONSENSE, *NUMBERS])))
        text = text.encode(errors="replace").decode()  # half of a surrogate pair cannot be typed
        self.note(f"types {text[:60]!r} into {name_of(field)}")
        field.setFocus()
        field.selectAll()
        if text.isascii() and text.isprintable():
            QTest.keyClicks(field, text)
        else:
            QtGui.QGuiApplication.clipboard().setText(text)
            self.press("Ctrl+V")
        if self.rng.random() < 0.7:
            self.press("Return")

    # -- what a hand does with the whole window

    def choose(self) -> None:
        """Choose an action of the menus; not the one that stops all motion."""
        menus = self.window.menus
        for menu in (menus.lesson_menu, menus.lesson_menu.lessons, menus.lesson_menu.talks):
            menu.aboutToShow.emit()
        actions = [
            action
            for action in self.window.findChildren(QtGui.QAction)
            if action.text() and action.isEnabled() and action.isVisible() and not action.menu()
            and not is_hidden(action.parent())
        ]  # fmt: skip
        lesson = [action for action in menus.lesson_menu.actions() if action in actions]
        action = self.rng.choice(self.rng.choice((actions, actions, lesson)))
        if action is not menus.reduce_motion:
            self.note(f"chooses {action.text()!r}")
            action.trigger()

    def drop(self) -> None:
        """Drop a file on the window."""
        path = self.rng.choice(self.files)
        self.note(f"drops {path.name}")
        data, place, copy = QtCore.QMimeData(), QPoint(100, 100), Qt.DropAction.CopyAction
        data.setUrls([QtCore.QUrl.fromLocalFile(str(path))])
        for event in (
            QtGui.QDragEnterEvent(place, copy, data, LEFT, NO_KEY),
            QtGui.QDropEvent(QtCore.QPointF(place), copy, data, LEFT, NO_KEY),
        ):
            QApplication.sendEvent(self.window, event)

    def resize(self) -> None:
        size = self.rng.choice(SIZES)
        self.note(f"resizes the window to {size}")
        self.window.resize(*size)

    def leave(self) -> None:
        """Close the window, or do it in the middle of a drag."""
        self.note("closes the window, after what follows if it does")
        self.drag(self.window.close) if self.rng.random() < 0.5 else self.window.close()


BY_HAND: dict[Callable[[Hands], object], float] = {
    Hands.click: 30.0, Hands.hover: 8.0, Hands.wheel: 6.0, Hands.drag: 12.0, Hands.key: 35.0,
    Hands.type: 6.0,
}  # fmt: skip
WITH_THE_WINDOW: dict[Callable[[Hands], object], float] = {
    Hands.choose: 10.0, Hands.drop: 3.0, Hands.resize: 1.0, Hands.leave: 0.3,
}  # fmt: skip


def is_hidden(place: Any) -> bool:
    """Whether an action belongs to a row that is not seen, as in a closed panel."""
    is_row = isinstance(place, QtWidgets.QWidget) and not isinstance(place, QtWidgets.QMenu)
    return is_row and not place.isVisible()


def name_of(widget: Any) -> str:
    """A widget's class, and the name that it has for a user."""
    text = widget.text() if isinstance(widget, QtWidgets.QAbstractButton) else ""
    return f"{type(widget).__name__} {(widget.accessibleName() or text)[:60]!r}"


def some_files(folder: Path) -> list[Path]:
    """Files to open: lessons and talks above all, meshes, and damaged files of all kinds."""
    place = a_folder(folder)
    own = [Path(shutil.copy(path, place)) for path in sorted(LESSONS.glob("*.md"))]
    talks = [path for path in own if path.name.startswith("talk")]
    meshes = [pyramid_file(place, kind) for kind in WRITERS]
    endings = 3 * [ending for ending in ENDINGS if ending.startswith(".")]
    damaged = [write_hostile(place, 1, *each)[0] for each in enumerate(endings)]
    return [*own, *4 * talks, *meshes, *damaged]


def in_a_window(folder: Path, options: argparse.Namespace) -> int:
    """Act until the time is over, and print the summary; 1 if there are findings."""
    faulthandler.enable()
    qt = application.make_application()
    qt.setQuitOnLastWindowClosed(False)
    logs.start_log()
    logs.log_vtk()
    QtCore.qInstallMessageHandler(logs.log_qt)
    hands = Hands(folder, options)
    logging.getLogger().addHandler(hands.findings)
    watch = ExceptionWatch(log_path())
    watch.install()
    application.collect_when_idle()
    hands.open()
    QTimer.singleShot(0, hands.beat)  # in the loop, which `exit` ends
    drops = QTimer(interval=DROPPED_MS)  # QTest ends no drag of selected text
    drops.timeout.connect(QtGui.QDrag.cancel)
    drops.start()
    qt.exec()
    hands.measure()
    if hands.window is not None:
        hands.window.store.mark_saved()  # no question when it closes
        hands.window.close()
        hands.forget()
    watch.remove()
    print("With the last window closed:", end=" ")
    hands.measure()
    later = hands.measures[len(hands.measures) // 4 : -1]
    (first, before), (last, after) = later[0], later[-1]
    growth = 1000.0 * (after - before) / 2**20 / max(1, last - first)
    print(f"Memory grew by {growth:.1f} MiB in 1000 steps, after the first quarter of the time.")
    print("Steps in", ", ".join(f"{name}: {count}" for name, count in hands.states.most_common()))
    counts = hands.findings.counts
    print(*(f"{count:6} {key.strip()}" for key, count in counts.most_common()), sep="\n")
    print(
        f"seed {options.seed}: {hands.findings.step} steps in {hands.opened} windows,"
        f" {len(counts)} findings; {hands.slowest:.1f} s of processor time for the slowest step",
        flush=True,
    )
    return int(bool(counts))


def main(words: Sequence[str]) -> int:
    """Copy the program, and act in its window in a process of its own."""
    parser = ToolParser("fuzz hands", __doc__)
    parser.add_argument("--minutes", type=float, default=20.0)
    parser.add_argument("--steps", type=int, default=0, help="end after so many instead")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(IN_A_WINDOW, type=Path, help=argparse.SUPPRESS)
    options = parser.parse_args(words)
    if options.in_a_window:
        return in_a_window(options.in_a_window, options)
    with at_home() as environment, tempfile.TemporaryDirectory() as place:
        copy, trail = Path(place, "program"), Path(place, "trail")
        for name in ("app", "widgets", "tests"):
            shutil.copytree(ROOT / name, copy / name)
        shutil.copy(ROOT / "pyproject.toml", copy)
        command = [sys.executable, "-m", "tests.fuzz", "hands", *words, IN_A_WINDOW, place]
        process = subprocess.Popen(command, cwd=copy, env=environment, preexec_fn=die_with_parent)
        try:
            while (status := process.poll()) is None:
                time.sleep(1.0)
                if trail.exists() and time.time() - trail.stat().st_mtime > LONGEST_SILENCE_S:
                    process.send_signal(signal.SIGABRT)  # faulthandler tells where it hangs
        finally:
            process.kill()
            process.wait()
        if status < 0:
            print(f"FINDING, seed {options.seed}: the window ended with {status}")
            print(*trail.read_text(encoding="utf-8").splitlines()[-SHOWN:], sep="\n    ")
        return int(status != 0)
