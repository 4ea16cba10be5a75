"""Set up everything that Frustum Lab needs, on a machine that has only Python.

``python3 -m app`` and ``python3 -m tests`` both call `start` first::

    packages in this Python? --yes--> system libraries there? --yes--> go on
            | no                              | no
            v                                 +--> root with apt-get: install; else: say how, exit 3
    .venv complete? --yes--> same command again, inside .venv
            | no
            v
    under a lock: make .venv, pip install, stamp it --> same command again, inside .venv
            | fails, and the former .venv still has all that is imported
            +-----------------------------------------> the same, and say what is not up to date

A .venv that another program made is never changed: it is used if it has everything.

The packages and their bounds are in ``pyproject.toml`` (`app.python_packages`), the tested exact
versions in ``constraints.txt``, the system libraries in `app.system_packages`. This module imports
the standard library only. It writes to standard error, because standard output belongs to the
command.
"""

from __future__ import annotations

import contextlib
import ctypes
import gc
import hashlib
import importlib.util
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import IO, NoReturn, Self

from app import modules
from app.python_packages import Requirement, are_importable, requirements, unmet
from app.system_packages import (
    APT_INSTALL,
    Need,
    System,
    advice,
    apt_command,
    is_root,
    missing_system,
    packages_of,
    venv_module,
)

ROOT = Path(modules.ROOT)
#: The command that starts the program: an installed one has no checkout around it.
PROGRAM = "python3 -m app" if os.path.exists(ROOT / "pyproject.toml") else "frustum-lab"
EXIT_NOT_SET_UP = 3
#: Space for a fresh environment with the tests' packages, 1.15 GB, and pip's temporary files.
SPACE_GB = 1.5
#: Interval at which a terminal's line of progress counts its seconds.
TICK_S = 0.5

_UNFINISHED = "setting up\n"
_UNOBTAINABLE = "No matching distribution|ResolutionImpossible"
_NO_ANSWER = r"Retrying \("
_HELD = r"OSError: \[WinError (5|32)\]"
_FULL = (
    r"\[Errno (28|122)\]|\[WinError 112\]|No space left on device|quota exceeded|"
    "No usable temporary directory"
)
_INSTALLING = "Installing collected packages: "
_AGAIN = "FRUSTUM_LAB_STARTED_AGAIN"
_AS_IT_IS = "as it is"


class SetupError(Exception):
    """One sentence that says what is missing and which command helps."""


# --- the operating system's part ------------------------------------------------------------------


def _ensure_system(missing: Sequence[System]) -> None:
    """Install what is missing with apt-get if running as root; otherwise say how."""
    if not is_root() or shutil.which("apt-get") is None:
        raise SetupError(advice(missing))
    packages = packages_of(missing)
    _log(f"installing system packages: {' '.join(packages)}")
    with _stoppable():
        # An unreachable repository is no reason to stop: the necessary one may be reachable.
        for command in (["apt-get", "update"], [*APT_INSTALL, *packages]):
            done = subprocess.run(
                command,
                env={**os.environ, "DEBIAN_FRONTEND": "noninteractive"},
                capture_output=True,
                text=True,
                errors="replace",
                check=False,
            )
    if done.returncode != 0:
        why = _last_line(done.stderr.splitlines(), "E:") or f"exit status {done.returncode}"
        raise SetupError(f"apt-get failed ({why}); try: {apt_command(packages)}")
    importlib.invalidate_caches()
    left = [item for item in missing if not item.is_here()]
    if left:
        raise SetupError(advice(left))


# --- the virtual environment ----------------------------------------------------------------------

#: Runs inside an environment: prints which packages are old, unless one cannot be imported.
_PROBE = """
import sys
sys.path.insert(0, sys.argv[1])
from app import bootstrap, python_packages
wanted = python_packages.requirements(bootstrap.ROOT, sys.argv[2:])
if python_packages.are_importable(wanted):
    print(", ".join(each.text for each in python_packages.unmet(wanted)))
"""


class Environment:
    """The ``.venv`` beside the code, which is trusted only according to its stamp.

    The stamp has one line for each group of packages that was installed completely: the program's,
    and the program's with extras. A line names the Python, the platform and the exact
    requirements. From the moment when pip has downloaded everything until it has installed it, the
    stamp says that the environment is unfinished. An unfinished environment is made anew, and so is
    one of another Python.
    """

    def __init__(self, root: Path, extras: Sequence[str] = ()) -> None:
        self.root, self.extras = root, tuple(extras)
        self.folder = root / ".venv"
        self.python = self.folder / (
            "Scripts/python.exe" if sys.platform == "win32" else "bin/python"
        )
        self.stamp = self.folder / "frustum-lab.stamp"
        self.constraints = root / "constraints.txt"

    def line(self, extras: Sequence[str] = ()) -> str:
        """The stamp's line for a complete installation of the program and these extras."""
        texts = [requirement.text for requirement in requirements(self.root, extras)]
        texts.append(self.constraints.read_text(encoding="utf-8"))
        digest = hashlib.sha256("\n".join(texts).encode()).hexdigest()
        return f"{_here()}{'+'.join(extras) or '-'} {digest}"

    def read_stamp(self) -> str | None:
        try:
            return self.stamp.read_text(encoding="utf-8", errors="replace")
        except OSError:
            return None

    def is_complete(self) -> bool:
        stamp = self.read_stamp()
        complete = stamp is not None and self.line(self.extras) in stamp.split("\n")
        return complete and os.path.exists(self.python)

    def is_running(self) -> bool:
        """Whether the current interpreter belongs to this environment."""
        return os.path.realpath(sys.prefix) == os.path.realpath(self.folder)

    def make(self) -> None:
        """Complete the environment, whatever state it is in."""
        if os.path.lexists(self.folder) and not os.path.isdir(self.folder):  # not ours to remove
            raise SetupError(
                f"{self.folder} is not a folder; rename or remove it, and run again: "
                f"{_command_again()}"
            )
        started = time.monotonic()
        with _stoppable(), _lock(self.root / ".venv.lock") as held:
            if self.is_complete():  # another start has just finished it
                return
            if self.can_be_kept():
                held.show(f"bringing {self.folder} up to date")
            else:
                if shutil.disk_usage(self.root).free < SPACE_GB * 1e9:
                    raise _no_space(self.root)
                held.show(f"first start: setting up {self.folder} (once; needs the network)")
                self._make_anew(held)
            self._install(held)
            lines = dict.fromkeys(f"{self.line(extras)}\n" for extras in ((), self.extras))
            fresh = self.stamp.with_suffix(".new")
            fresh.write_text("".join(lines), encoding="utf-8")
            fresh.replace(self.stamp)
        _log(f"set up in {time.monotonic() - started:.0f} s")

    def _make_anew(self, held: HeldLock) -> None:
        try:
            if os.path.exists(self.folder):
                shutil.rmtree(self.folder)
        except OSError as error:
            raise SetupError(
                f"{self.folder} could not be removed ({error}); close the programs that run in it "
                f"and run again: {_command_again()}"
            ) from None
        self.folder.mkdir(parents=True)
        self.mark_unfinished()
        output: list[str] = []
        status = held.run([sys.executable, "-I", "-m", "venv", str(self.folder)], output.append)
        if status != 0:
            raise self._failure(
                status, output, "",
                "Python could not make a virtual environment ({}); try it with: "
                + command_line([sys.executable, "-m", "venv", "--clear", str(self.folder)]),
            )  # fmt: skip

    def mark_unfinished(self) -> None:
        self.stamp.write_text(_UNFINISHED, encoding="utf-8")

    def can_be_kept(self) -> bool:
        """Whether pip can complete the environment; otherwise it has to be made anew."""
        return (self.read_stamp() or "").startswith(_here())  # machines may share a folder

    def is_foreign(self) -> bool:
        """Whether another program, such as ``uv venv``, made it."""
        return self.read_stamp() is None and os.path.exists(self.python)

    def serves(self) -> bool:
        return self.is_complete() or (self.is_foreign() and self.lacks() == "")

    def lacks(self) -> str | None:
        """Return what is out of date; None if something that is imported is missing."""
        command = [str(self.python), "-I", "-c", _PROBE, str(self.root), *self.extras]
        try:
            done = subprocess.run(command, capture_output=True, text=True, check=False)
        except OSError:
            return None
        return done.stdout.strip() if done.stdout else None

    def _install(self, held: HeldLock) -> None:
        """Install the tested versions or, if they are not available here, newer ones."""
        wanted = [requirement.text for requirement in requirements(self.root, self.extras)]
        # -I: a package on PYTHONPATH must not pass for an installed one. Wheels only: building VTK
        # or numpy from source is no fallback for a teaching program. The user's own PIP_...
        # settings (index, proxy, certificate) still apply.
        pip = [str(self.python), "-I", "-m", "pip", "install", "--disable-pip-version-check"]
        pip += ["--no-input", "--progress-bar", "off", "--only-binary", ":all:"]
        status, output = self._pip(held, [*pip, "-c", str(self.constraints), *wanted])
        if status != 0 and _shows(output, _UNOBTAINABLE) and not _shows(output, _NO_ANSWER):
            held.show("the tested versions cannot be installed on this machine: trying others")
            status, output = self._pip(held, [*pip, *wanted])
        if status != 0:
            to_do = f"check the network and run again: {_command_again()}"
            if _shows(output, _HELD) and not _shows(output, _NO_ANSWER):
                to_do = f"close all windows of Frustum Lab and run again: {_command_again()}"
            elif _shows(output, _UNOBTAINABLE) and not _shows(output, _NO_ANSWER):
                here = ".".join(map(str, sys.version_info[:2]))
                to_do = f"no version fits Python {here} on this machine; use another Python"
            what = "the Python packages could not be installed ({}); "
            raise self._failure(status, output, "ERROR:", what + to_do)

    def _failure(self, status: int, output: list[str], start: str, what: str) -> SetupError:
        """Return a sentence that says why a command failed, from its output."""
        if _shows(output, _FULL):
            return _no_space(self.folder)
        why = _last_line(output, start) or f"exit status {status}"
        if _shows(output, _NO_ANSWER):
            why = "no package server could be reached"  # whatever pip's own conclusion
        return SetupError(what.replace("{}", why, 1))

    def _pip(self, held: HeldLock, command: list[str]) -> tuple[int, list[str]]:
        output: list[str] = []
        told: set[str] = set()  # pip names a package again after inspecting it

        def follow(line: str) -> None:
            output.append(line)
            if line.startswith(_INSTALLING):  # everything is downloaded: pip changes nothing before
                self.mark_unfinished()
                held.show(f"  installing packages: {line.count(',') + 1}")
            elif (text := _progress(line)) is not None and text not in told:
                told.add(text)
                held.show(f"  {text}")

        return held.run(command, follow), output


def _here() -> str:
    return f"{sys.implementation.cache_tag} {sys.platform} "


def _progress(line: str) -> str | None:
    """Return the progress message for a line of pip's output; None for most lines."""
    match = re.match(
        r"\s*(?:Downloading|Using cached|Processing) (?:\S*/)?([^/\s]+)\.whl(.*)", line
    )
    if match and not match[2].startswith(".metadata"):
        name, version = match[1].split("-")[:2]
        return f"{name} {version}{match[2].rstrip()}"
    if re.search(_NO_ANSWER, line):
        return "the package server does not answer; trying again"
    return None


def _no_space(environment: Path) -> SetupError:
    """Say which folder is full: the environment's, or that of pip's temporary files."""
    import tempfile

    try:
        temporary = Path(tempfile.gettempdir())
    except FileNotFoundError:  # there, not even an empty file could be written
        temporary = Path(os.environ.get("TMPDIR", "/tmp"))
    folders = [folder for folder in (environment, temporary) if os.path.exists(folder)] or [ROOT]
    full = min(folders, key=lambda folder: shutil.disk_usage(folder).free)
    also = " or set TMPDIR to a folder that has it" if full == temporary else ""
    return SetupError(
        f"too little space is left in {full}; free {SPACE_GB} GB there{also}, and run again: "
        f"{_command_again()}"
    )


def _shows(output: Iterable[str], pattern: str) -> bool:
    return any(re.search(pattern, line) for line in output)


def _last_line(lines: Iterable[str], start: str = "") -> str:
    last = [line.strip() for line in lines if line.strip().startswith(start)]
    return last[-1].removeprefix(start).strip().rstrip(".") if last else ""


# --- one set-up at a time -------------------------------------------------------------------------


class HeldLock:
    """A held lock with its progress. Programs that run under it hold the lock too.

    If a set-up is killed, its pip may continue for a while (on Linux it is killed too). Because pip
    inherited the open lock file, the lock is free only when pip has ended. On a terminal the line
    of progress counts the seconds.
    """

    def __init__(self, file: IO[bytes]) -> None:
        self._file = file
        self._live = sys.stderr is not None and sys.stderr.isatty()
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._tick, daemon=True)
        self._text, self._since = "", 0.0

    def __enter__(self) -> Self:
        if self._live:
            self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._over.set()
        if self._live:
            self._thread.join()
            print(file=sys.stderr, flush=True)

    def show(self, text: str) -> None:
        self._text, self._since = text, time.monotonic()
        if not self._live:
            _log(text)

    def _tick(self) -> None:
        while not self._over.wait(TICK_S):
            room = max(0, shutil.get_terminal_size().columns - 1)
            seconds = f", {time.monotonic() - self._since:.0f} s"
            line = f"frustum-lab: {self._text}"[: max(0, room - len(seconds))] + seconds
            print(f"\r{line.ljust(room)}", end="", file=sys.stderr, flush=True)

    def run(self, command: Sequence[str], follow: Callable[[str], object]) -> int:
        """Run a command, pass each line of its output to `follow`, and return its exit status."""
        unwanted = ("PIP_USER", "PIP_TARGET", "PIP_PREFIX", "PIP_ROOT", "PYTHONHOME")
        environment = {key: value for key, value in os.environ.items() if key not in unwanted}
        with subprocess.Popen(
            command,
            env=environment | {"PYTHONUNBUFFERED": "1"},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            pass_fds=() if sys.platform == "win32" else (self._file.fileno(),),
            preexec_fn=None if sys.platform == "win32" else die_with_parent,
        ) as process:
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
def _lock(path: Path) -> Iterator[HeldLock]:
    """Hold a lock that the operating system releases if the process dies."""

    def without_waiting(name: str, flags: int) -> int:  # for the reader of a pipe
        return os.open(name, flags | getattr(os, "O_NONBLOCK", 0), 0o666)

    with open(path, "ab", opener=without_waiting) as file:
        if not _try_lock(file):
            _log("another start is setting up Frustum Lab; waiting for it to finish")
            while not _try_lock(file):
                time.sleep(0.2)
        with HeldLock(file) as held:
            yield held


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


# --- the start ------------------------------------------------------------------------------------


def start(
    need: Need, extras: Sequence[str] = (), before: Callable[[], object] = lambda: None
) -> None:
    """Return if everything is installed; otherwise install it, and start the same command again.

    `extras` are optional groups of ``pyproject.toml`` that are also needed; `before` is called
    before anything is installed. If only the user can install what is missing, the program ends
    with status 3 after one sentence on standard error.
    """
    with _in_one_sentence():
        if not _has_packages(tuple(extras)):
            before()
            _set_up(need, Environment(ROOT, tuple(extras)))
        if missing := missing_system(need):
            before()
            _ensure_system(missing)


def enter() -> bool:
    """Continue in a complete environment, if there is one, without installing anything.

    Returns whether this Python has all packages of the program, in any version.
    """
    with _in_one_sentence():
        return _has_packages() or are_importable(requirements(ROOT))


def _has_packages(extras: tuple[str, ...] = ()) -> bool:
    """Whether this interpreter has the packages; first enters .venv if its stamp is complete."""
    if not os.path.exists(ROOT / "pyproject.toml"):  # pip has installed it, with the packages
        return True
    environment, wanted = Environment(ROOT, extras), requirements(ROOT, extras)
    if os.environ.get(_AGAIN) == _AS_IT_IS and environment.is_running():
        # Keep this for child processes, which then need not try the network again.
        return are_importable(wanted)
    if _is_met(wanted, environment):
        os.environ.pop(_AGAIN, None)
        return True
    if _AGAIN not in os.environ and not environment.is_running() and environment.serves():
        again(environment.python)
    return False


def damage(error: ImportError) -> str:
    """Name the package that lacks a module, and what to do; empty if no package is to blame."""
    name = (error.name or "").partition(".")[0]
    of_package = next((each for each in requirements(ROOT) if each.import_name == name), None)
    if of_package is None or not isinstance(error, ModuleNotFoundError):
        return ""
    environment = Environment(ROOT)
    words = [sys.executable, "-m", "pip", "install", "--force-reinstall", of_package.text]
    how = _remove(environment.folder) if environment.is_running() else command_line(words)
    return f"the package {of_package.name} is damaged ({error}); replace it, and start again: {how}"


def _is_met(wanted: Sequence[Requirement], environment: Environment) -> bool:
    """Whether this interpreter has the packages; fast if it does not, and fast in .venv."""
    if not are_importable(wanted):
        return False
    stamp = environment.read_stamp() if environment.is_running() else None
    if stamp is not None and (environment.is_complete() or stamp.endswith(_UNFINISHED)):
        return environment.is_complete()
    return not unmet(wanted)


def _set_up(need: Need, environment: Environment) -> NoReturn:
    """Complete the environment, and start the same command again inside it."""
    names = ", ".join(each.name for each in unmet(requirements(ROOT, environment.extras)))
    if _AGAIN in os.environ:
        raise SetupError(
            f"{environment.folder} lacks {names} although pip installed them; remove it and start "
            f"again: {_remove(environment.folder)}"
        )
    if environment.is_running():
        if environment.is_complete():  # its stamp is complete, but a package has been lost since
            environment.mark_unfinished()
        # An environment cannot be replaced while it runs, so that is done from outside.
        outside = Path(getattr(sys, "_base_executable", sys.executable))
        if sys.platform == "win32":  # where this process would wait and keep its own file open
            raise SetupError(
                f"{environment.folder} lacks {names or 'a part'}; start again: "
                f"{command_line([str(outside), *sys.orig_argv[1:]])}"
            )
        again(outside)
    if environment.is_foreign():
        raise SetupError(
            f"{environment.folder} was made by another program and lacks "
            f"{environment.lacks() or 'packages'}; complete it with that program, or remove it "
            f"and start again: {_remove(environment.folder)}"
        )
    if missing := [*venv_module(), *missing_system(need)]:
        _ensure_system(missing)
    how = "made"
    try:
        environment.make()
    except SetupError as error:
        lacking = environment.lacks()
        if lacking is None:
            raise
        _log(f"{error}")
        _log(f"going on with the installed packages{lacking and f', which do not meet {lacking}'}")
        how = _AS_IT_IS
    os.environ[_AGAIN] = how
    again(environment.python)


@contextlib.contextmanager
def _in_one_sentence() -> Iterator[None]:
    try:
        yield
    except SetupError as error:
        fail(str(error))
    except OSError as error:
        if _shows([str(error)], _FULL):
            fail(str(_no_space(ROOT)))
        fail(
            f"the set-up failed ({error}); put Frustum Lab into a folder that you may write to, "
            f"with {SPACE_GB} GB of space, and run again: {_command_again()}"
        )
    except KeyboardInterrupt:  # whichever process was setting up has reported it
        raise SystemExit(130) from None


@contextlib.contextmanager
def _stoppable() -> Iterator[None]:
    """Say how to continue after Ctrl-C."""
    try:
        yield
    except KeyboardInterrupt:
        _log(f"the set-up was stopped; to go on: {_command_again()}")
        raise


def fail(sentence: str) -> NoReturn:
    """End the set-up, and say what the user can do."""
    _log(sentence)
    raise SystemExit(EXIT_NOT_SET_UP)


def again(python: str | Path) -> NoReturn:
    """Replace this process by the same command, perhaps under another interpreter."""
    command = [str(python), *sys.orig_argv[1:]]
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:  # both are None in pythonw
            stream.flush()
    modules.set_aside("PYTHONHOME")  # it leads to another Python's modules
    if sys.platform == "win32":  # Windows' exec returns to the shell before the program has ended
        with subprocess.Popen(command) as process:
            while process.poll() is None:
                with contextlib.suppress(KeyboardInterrupt):  # the program receives it too
                    process.wait()
        raise SystemExit(process.returncode)
    os.execv(command[0], command)


def command_line(words: Sequence[str]) -> str:
    """Write a command for the shell; on Windows in cmd.exe's syntax, where ' does not quote."""
    if sys.platform != "win32":
        return shlex.join(words)
    return " ".join(word if re.fullmatch(r"[\w\\:./=+-]+", word) else f'"{word}"' for word in words)


def _remove(folder: Path) -> str:
    command = ["rmdir", "/s"] if sys.platform == "win32" else ["rm", "-r"]
    return command_line([*command, str(folder)])


def _command_again() -> str:
    return command_line([Path(sys.executable).name, *sys.orig_argv[1:]])


def _log(text: str) -> None:
    if sys.stderr is not None:
        print(f"frustum-lab: {text}", file=sys.stderr, flush=True)


@contextlib.contextmanager
def for_good() -> Iterator[None]:
    """Import permanent modules without garbage collection, and exempt them from later collection.

    Otherwise Python collects some 500 times while it imports VTK and Qt, which is a tenth of the
    time to the first frame, and later in the middle of a drag, for the duration of three frames.
    """
    is_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        if is_on:
            gc.enable()
