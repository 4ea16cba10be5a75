"""One set-up at a time: its lock, the programs that run under it, their one line of progress."""

from __future__ import annotations

import contextlib
import ctypes
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import IO

from app.languages import said
from app.strangers import without_waiting

#: Interval at which a terminal's line of progress counts its seconds.
TICK_S = 0.5


def log(text: str) -> None:
    if sys.stderr is not None:
        print(f"frustum-lab: {text}", file=sys.stderr, flush=True)


class HeldLock:
    """A held lock with its progress. Programs that run under it hold the lock too.

    If a set-up is killed, its pip may continue for a while (on Linux it is killed too). Because pip
    inherited the open lock file, the lock is free only when pip has ended. On a terminal the line
    of progress counts the seconds.
    """

    def __init__(self, file: IO[bytes]) -> None:
        self._file = file
        self._live = sys.stderr is not None and sys.stderr.isatty()
        self.over = threading.Event()
        self._text, self._since = "", 0.0

    def show(self, text: str) -> None:
        self._text, self._since = text, time.monotonic()
        if not self._live:
            log(text)

    def tick(self) -> None:
        """Keep a terminal's line of progress up to date until the end."""
        while self._live and not self.over.wait(TICK_S):
            room = max(0, shutil.get_terminal_size().columns - 1)
            seconds = f", {time.monotonic() - self._since:.0f} s"
            line = f"frustum-lab: {self._text}"[: max(0, room - len(seconds))] + seconds
            print(f"\r{line.ljust(room)}", end="", file=sys.stderr, flush=True)
        if self._live:
            print(file=sys.stderr, flush=True)

    def run(self, command: Sequence[str], follow: Callable[[str], object]) -> int:
        """Run a command, pass each line of its output to `follow`, and return its exit status."""
        unwanted = ("PIP_USER", "PIP_TARGET", "PIP_PREFIX", "PIP_ROOT", "PYTHONHOME")
        environment = {key: value for key, value in os.environ.items() if key not in unwanted}
        with subprocess.Popen(
            command, env=environment | {"PYTHONUNBUFFERED": "1"}, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
            pass_fds=() if sys.platform == "win32" else (self._file.fileno(),),
            preexec_fn=None if sys.platform == "win32" else die_with_parent,
        ) as process:  # fmt: skip
            assert process.stdout is not None
            try:
                for line in process.stdout:
                    follow(line.rstrip("\n"))
            except BaseException:
                process.kill()
                raise
        return process.returncode


def die_with_parent() -> None:
    """Make a child process end when its parent is killed; called before it runs another program."""
    if sys.platform.startswith("linux"):  # only Linux has this call
        pr_set_pdeathsig = 1
        ctypes.CDLL(None).prctl(pr_set_pdeathsig, signal.SIGTERM)


@contextlib.contextmanager
def lock(path: Path) -> Iterator[HeldLock]:
    """Hold a lock that the operating system releases if the process dies."""
    with open(path, "ab", opener=without_waiting) as file:
        if not _try_lock(file):
            log(said("another start is setting up Frustum Lab; waiting for it to finish"))
            while not _try_lock(file):
                time.sleep(0.2)
        held = HeldLock(file)
        ticking = threading.Thread(target=held.tick, daemon=True)
        ticking.start()
        try:
            yield held
        finally:
            held.over.set()
            ticking.join()


def _try_lock(file: IO[bytes]) -> bool:
    try:
        if sys.platform == "win32":
            import msvcrt

            file.seek(0)
            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return False
    return True
