"""Open damaged and hostile meshes, documents, lessons and talks with ``python3 -m app``.

``python3 -m tests.fuzz hostile --count 5000 --seed 1`` makes 5000 files and opens them:
meshes and documents with ``matrices FILE``, lessons and talks with ``lesson check FILE``. A file
must open, or be refused in one sentence that begins with its name. Anything else is a finding: a
signal, a traceback, a second line, 10 s of work, 600 s of waiting, or 2 GiB.

`tests.fuzz.lessons` makes lessons, talks, results, records, strokes and lists as people write them,
with impossible numbers. Each is opened by its command, and then read, drawn, answered and summed up
in the same process, all within 1 s; a list takes 1 s for each of its figures.
``--only lesson,talk,results,record,strokes,list`` takes these.

``--window`` also opens each file in a real window, draws all three panes, and reads and answers
every step of a lesson. There a finding is an exception, a drawing that is taken back, more than
`LONGEST_STALL_S` of work without handling events, or opening a file that does not belong to the
lesson. A window that crashes is a finding, and the next file gets a new window.

The command is imported once. A fork of that process opens each file, so that its signal, status and
processor time (which other jobs do not lengthen) are its own. Every finding, and one file in
`CONFIRMED`, is opened by the whole command as well, which must say the same. Without fork the whole
command opens all files.
"""

import collections
import contextlib
import json
import os
import select
import signal
import subprocess
import sys
import tempfile
import time
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from app.commands import cli
from tests.fuzz import lessons
from tests.fuzz.files import ENDINGS, write_hostile
from tests.support.tools import ToolParser

CONFIRMED = 50
LONGEST_S = 10.0
LONGEST_OF_LESSON_S = 3.0  # a slow or busy machine needs more than one
LONGEST_WORK_S = 60
"""Processor time after which the system ends a process."""
LONGEST_WAIT_S = 600.0
LONGEST_STALL_S = 0.2
"""Processor time of the window's thread."""
LARGEST_BYTES = 2 * 2**30
ROOT = Path(__file__).parents[2]


# --------------------------------------------------------------------------- opening


class Outcome(NamedTuple):
    """What became of a file."""

    status: int  # below zero: the signal
    out: bytes
    err: bytes
    seconds: float
    largest: int  # bytes of the process, and of one that it started

    def finding(self, path: Path, kind: str) -> str:
        """What is wrong with it; empty if nothing is."""
        lines = self.err.decode(errors="replace").splitlines()
        if self.status < 0:
            return f"signal {-self.status}"
        if b"Traceback" in self.err or b"Error\n" in self.err:
            return "traceback"
        figures = max(1, path.read_bytes().count(b"\n")) if kind == "list" else 1
        if self.seconds > (LONGEST_OF_LESSON_S * figures if kind in lessons.DONE else LONGEST_S):
            return f"{self.seconds:.1f} s"
        if self.largest > LARGEST_BYTES:
            return f"{self.largest >> 20} MiB"
        if kind in lessons.DONE:
            said = [*lines, *self.out.decode(errors="replace").splitlines()]
            right = all(line.startswith(str(path)) for line in lines) and self.status in (0, 1, 2)
            right = right and all(line.isprintable() for line in said)
            return "" if right else f"status {self.status}, or not a sentence about the file"
        if path.suffix == ".md":
            said = self.out.decode(errors="replace").splitlines()
            wrong, sums = said[:-2], said[-2:]  # the last two lines sum up
            named = all(line.startswith((f"{path}: ", f"{path} ")) for line in wrong)
            printable = all(line.isprintable() for line in said)
            right = self.status == bool(wrong) and len(sums) == 2 and named and printable
            right = right and not lines
            return "" if right else f"status {self.status}, or not a sentence about the file"
        if self.status == 0:  # notes say what of a mesh is left out
            noted = all(line.isprintable() and line.startswith(f"{path}: ") for line in lines)
            noted = noted and len(lines) <= (0 if path.suffix == ".json" else 2)
            return "" if self.out and noted else "opened, but said something or nothing"
        if self.status != 2 or self.out or len(lines) != 1:
            return f"status {self.status}, {len(lines)} lines"
        named = (f"{path}: ", f"{path} ") if path.suffix == ".json" else f"{path}: "
        right = lines[0].isprintable() and lines[0].startswith(named)
        return "" if right else "not a sentence about the file"


def _waited(started: float, pid: int, folder: Path) -> Outcome:
    while True:
        done, status, used = os.wait4(pid, os.WNOHANG)
        if done:
            break
        if time.perf_counter() - started > LONGEST_WAIT_S:
            os.kill(pid, signal.SIGKILL)
        time.sleep(0.002)
    unit = 1 if sys.platform == "darwin" else 1024
    out, err = ((folder / name).read_bytes() for name in ("out", "err"))
    return Outcome(
        os.waitstatus_to_exitcode(status), out, err, used.ru_utime + used.ru_stime,
        used.ru_maxrss * unit,
    )  # fmt: skip


def _arguments(path: Path, kind: str) -> list[str]:
    if kind in lessons.DONE:
        return lessons.command(path, kind)
    return [*(["lesson", "check"] if path.suffix == ".md" else ["matrices"]), str(path)]


def _forked(path: Path, kind: str, folder: Path) -> Outcome:
    started = time.perf_counter()
    pid = os.fork()
    if pid == 0:
        status = 70
        try:
            import resource  # where there is a fork

            resource.setrlimit(resource.RLIMIT_CPU, (LONGEST_WORK_S, LONGEST_WORK_S))
            for descriptor, name in ((1, "out"), (2, "err")):
                file = os.open(folder / name, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
                os.dup2(file, descriptor)
            words = _arguments(path, kind)
            status = cli.main(words) if words else 0
            sys.stdout.flush()
            if kind in lessons.DONE:
                lessons.DONE[kind](path)
        except BaseException:
            traceback.print_exc()
            sys.stderr.flush()
        finally:
            os._exit(status)
    return _waited(started, pid, folder)


def _commanded(path: Path, kind: str) -> Outcome:
    started = time.perf_counter()
    command = [sys.executable, "-m", "app", *_arguments(path, kind)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, check=False)
    return Outcome(done.returncode, done.stdout, done.stderr, time.perf_counter() - started, 0)


# --------------------------------------------------------------------------- in a window

IN_A_WINDOW = "--in-a-window"


class InWindow:
    """Opens files in a window of a process of its own, and tells what is wrong with each."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._process: subprocess.Popen[str] | None = None

    def finding(self, path: Path) -> str:
        """What is wrong with a file; empty if nothing is."""
        if self._process is None:
            command = [
                sys.executable,
                "-m",
                "tests.fuzz",
                "hostile",
                IN_A_WINDOW,
                str(self._folder),
            ]
            self._process = subprocess.Popen(
                command, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
            )
            self._answer()  # the window is there
        assert self._process.stdin is not None
        print(path, file=self._process.stdin, flush=True)
        return self._answer()

    def _answer(self) -> str:
        assert self._process is not None and self._process.stdout is not None
        ready, _, _ = select.select([self._process.stdout], [], [], LONGEST_WAIT_S)
        answer = self._process.stdout.readline() if ready else ""
        if answer:
            return str(json.loads(answer))
        self._process.kill()
        status, self._process = self._process.wait(), None
        return f"the window ended with {status}" if ready else "the window hangs"

    def close(self) -> None:
        """End the window."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()


def in_a_window(folder: Path) -> None:
    """Open the files that standard input names, and answer each with what is wrong with it."""
    import matplotlib
    from PySide6.QtCore import QTimer
    from PySide6.QtTest import QTest
    from PySide6.QtWidgets import QApplication

    from widgets.program.opengl import prepare

    prepare()
    application = QApplication([])
    from app.document.document import Document
    from app.scenes.scene import load
    from tests.support.opened import opened
    from widgets.window.settings import Settings

    settings = Settings(folder / "window.ini")
    window = opened(Document("cube", load("cube").start), settings=settings)
    problems: list[str] = []
    sys.excepthook = lambda _kind, error, _trace: problems.append(
        "".join(traceback.format_exception(error)[-3:])
    )
    places = (folder, ROOT, sys.prefix, sys.base_prefix, tempfile.gettempdir(), os.devnull)
    allowed = (*map(str, places), matplotlib.get_cachedir())
    opened_elsewhere: set[str] = set()

    def audit(event: str, arguments: tuple[Any, ...]) -> None:
        if event in ("socket.connect", "socket.getaddrinfo"):
            opened_elsewhere.add(event)
        elif event != "open" or isinstance(arguments[0], int):  # a pipe that is open
            return
        elif not os.fsdecode(arguments[0]).startswith(allowed):
            opened_elsewhere.add(os.fsdecode(arguments[0]))

    sys.addaudithook(audit)
    longest, last = [0.0], [time.thread_time()]

    def beat() -> None:
        now = time.thread_time()
        longest[0], last[0] = max(longest[0], now - last[0]), now

    pulse = QTimer(interval=5)
    pulse.timeout.connect(beat)

    def settled(act: Callable[..., object], *arguments: object) -> object:
        result = act(*arguments)
        for _ in range(4):
            QTest.qWait(1)
        return result

    print(json.dumps("ready"), flush=True)
    for line in sys.stdin:
        problems.clear()
        opened_elsewhere.clear()
        longest[0], last[0] = 0.0, time.thread_time()
        pulse.start()
        is_open = settled(window.files.open, line.rstrip("\n"))
        if is_open and window.lessons.course is not None:
            for place in range(len(window.lessons.course.lesson.steps)):
                settled(window.lesson_card.go_to, place)
                for block in window.lesson_card.page.blocks:
                    block.give_hint()
                settled(int)
            if window.lessons.course.lesson.is_talk:
                settled(window.talks.open_speaker)
                window.talks.close_speaker()
            settled(window.lesson_card.leave)
        pulse.stop()
        for pane in window.panes.values():
            if pane.drawing is None:
                problems.append(f"{pane.accessibleName()} shows nothing")
        if "cannot be drawn" in window.messages.text:
            problems.append(window.messages.text)
        if window.shown.document is not window.store.document:
            problems.append("the window shows another document than the store's")
        problems.extend(f"opens {name}" for name in sorted(opened_elsewhere))
        if longest[0] > LONGEST_STALL_S and not line.endswith(".md\n"):  # of many scenes
            problems.append(f"stalls for {longest[0]:.2f} s")
        print(json.dumps("; ".join(problems)), flush=True)
    application.quit()


def a_folder(outer: Path) -> Path:
    """A folder for the files, with what hostile addresses name inside and outside it."""
    folder = outer / "meshes"
    folder.mkdir()
    for path in (outer / "out.bin", folder / "m.bin"):
        path.write_bytes(bytes(4096))
    if hasattr(os, "mkfifo"):
        os.mkfifo(folder / "pipe.bin")
        (folder / "link.bin").symlink_to(outer / "out.bin")
    return folder


def main(words: Sequence[str]) -> int:
    """Open hostile files and tell what became of them; 1 if there are findings."""
    if IN_A_WINDOW in words[:1]:
        in_a_window(Path(words[1]))
        return 0
    parser = ToolParser("fuzz hostile", __doc__)
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--first", type=int, default=0, help="number of the first, to go on from")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--window", action="store_true", help="draw each in a window, too")
    parser.add_argument("--only", default="", help="kinds, such as .obj,.md,talk,results")
    parser.add_argument("--keep", type=Path, help="a folder for the files of findings")
    options = parser.parse_args(words)
    forks = hasattr(os, "fork")
    only = [kind for kind in options.only.split(",") if kind]
    for kind in set(only).difference(ENDINGS):
        parser.error(f"--only {kind}: must be of {', '.join(ENDINGS)}")
    lessons.prepare()
    findings, outcomes = 0, collections.Counter[str]()
    slowest, largest, confirmed = 0.0, 0, 0
    with contextlib.ExitStack() as stack:
        outer = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        folder = a_folder(outer)
        window = InWindow(folder) if options.window else None
        if window is not None:
            stack.callback(window.close)
        for number in range(options.first, options.first + options.count):
            ending = (only or ENDINGS)[number % len(only or ENDINGS)]
            path, kind = write_hostile(folder, options.seed, number, ending)
            outcome = _forked(path, ending, outer) if forks else _commanded(path, ending)
            what = outcome.finding(path, ending)
            if forks and ending not in lessons.DONE and (what or number % CONFIRMED == 0):
                again = _commanded(path, ending)
                confirmed += 1
                if again[:3] != outcome[:3]:
                    what = what or f"the whole command says something else: {again.err!r}"
            is_opened = window is not None and ending not in ("results", "record", "list")
            if is_opened and (shown := window.finding(path)):
                what = f"{what}; in the window: {shown}".removeprefix("; ")
            if what:
                findings += 1
                name = f"{options.seed} {number} {ending} {kind}"
                print(f"{name}: {what}: {outcome.err[-400:]!r}", flush=True)
                if options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    (options.keep / path.name).write_bytes(path.read_bytes())
            outcomes["opened" if outcome.status == 0 else "refused"] += not what
            slowest, largest = max(slowest, outcome.seconds), max(largest, outcome.largest)
            path.unlink()
    print(
        f"{options.count} files from {options.first} of seed {options.seed}: "
        f"{outcomes['opened']} opened, {outcomes['refused']} refused in one sentence, "
        f"{findings} findings; at most {slowest:.1f} s and {largest >> 20} MiB; "
        f"{confirmed if forks else options.count} by the whole command"
    )
    return 1 if findings else 0
