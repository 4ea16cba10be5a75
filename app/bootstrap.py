"""Everything Frustum Lab needs, brought to a machine that has only Python.

``start`` is called first by both commands, ``python3 -m app`` and ``python3 -m tests``::

    packages in this Python? --yes--> system libraries there? --yes--> go on
            | no                              | no
            v                                 +--> root with apt-get: install; else: say how, exit 3
    .venv complete? --yes--> same command again, inside .venv
            | no
            v
    under a lock: make .venv, pip install, stamp it --> same command again, inside .venv

What stays in one place: the packages and their bounds are in ``pyproject.toml``, the tested exact
versions in ``constraints.txt``, the system libraries in ``SYSTEM`` below. This room imports the
standard library only, and nothing of ours: it runs before there is anything else. All it says goes
to standard error, because standard output belongs to the command that was asked for.
"""

from __future__ import annotations

import contextlib
import ctypes
import gc
import hashlib
import importlib
import importlib.util
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Literal, NoReturn

ROOT = Path(__file__).resolve().parent.parent
EXIT_NOT_SET_UP = 3

#: What a command asks of the machine: no graphics at all, pictures without a window, a window, or
#: a window on a virtual display of its own.
Need = Literal["numbers", "picture", "window", "tests"]
_PICTURE: tuple[Need, ...] = ("picture", "window", "tests")
_WINDOW: tuple[Need, ...] = ("window", "tests")

_STAMP = "frustum-lab.stamp"
_UNFINISHED = "setting up\n"
_UNOBTAINABLE = "No matching distribution|ResolutionImpossible"
_NO_ANSWER = r"Retrying \("
_HELD = r"OSError: \[WinError (5|32)\]"
_AGAIN = "FRUSTUM_LAB_STARTED_AGAIN"


class SetupError(Exception):
    """What is missing and the command that helps, in one sentence."""


# --- what must be there ---------------------------------------------------------------------------


@dataclass(frozen=True)
class System:
    """One thing of the operating system: a shared library or a program.

    Attributes
    ----------
    name : str
        The library's soname, as the dynamic loader knows it, or the name of a program.
    packages : str
        The packages of Debian and Ubuntu that bring it, separated by spaces.
    needs : tuple of Need
        The needs it belongs to.
    """

    name: str
    packages: str
    needs: tuple[Need, ...] = _WINDOW

    def is_here(self) -> bool:
        """Ask the loader itself: right on every distribution, whatever its package manager."""
        if ".so" not in self.name:
            return shutil.which(self.name) is not None
        try:
            ctypes.CDLL(self.name)
        except OSError:
            return False
        return True


#: Where the loader's libGL and libEGL lead (Mesa or a vendor's driver) is the machine's own choice,
#: so only the entrances are checked. The Mesa packages come with them where apt has to install.
SYSTEM = (
    System("libGL.so.1", "libgl1 libglx-mesa0 libgl1-mesa-dri", _PICTURE),
    System("libEGL.so.1", "libegl1 libegl-mesa0", _PICTURE),
    System("libX11.so.6", "libx11-6", _PICTURE),
    System("libX11-xcb.so.1", "libx11-xcb1"),
    System("libXcursor.so.1", "libxcursor1", _PICTURE),
    System("libxkbcommon.so.0", "libxkbcommon0"),
    System("libxkbcommon-x11.so.0", "libxkbcommon-x11-0"),
    System("libxcb-cursor.so.0", "libxcb-cursor0"),
    System("libxcb-glx.so.0", "libxcb-glx0"),
    System("libxcb-icccm.so.4", "libxcb-icccm4"),
    System("libxcb-image.so.0", "libxcb-image0"),
    System("libxcb-keysyms.so.1", "libxcb-keysyms1"),
    System("libxcb-randr.so.0", "libxcb-randr0"),
    System("libxcb-render-util.so.0", "libxcb-render-util0"),
    System("libxcb-shape.so.0", "libxcb-shape0"),
    System("libxcb-sync.so.1", "libxcb-sync1"),
    System("libxcb-util.so.1", "libxcb-util1"),
    System("libxcb-xfixes.so.0", "libxcb-xfixes0"),
    System("libxcb-xkb.so.1", "libxcb-xkb1"),
    System("libfontconfig.so.1", "libfontconfig1 fonts-dejavu-core"),
    System("libfreetype.so.6", "libfreetype6"),
    System("libglib-2.0.so.0", "libglib2.0-0"),
    System("libdbus-1.so.3", "libdbus-1-3"),
    System("Xvfb", "xvfb", ("tests",)),
)

#: Debian 13 and Ubuntu 24.04 renamed some packages when time became 64 bits wide.
_RENAMED = {"libglib2.0-0": "libglib2.0-0t64"}

#: Distributions whose import name is not simply their own name.
_IMPORT_NAME = {
    "pillow": "PIL",
    "vtk": "vtkmodules",
    "pyside6-essentials": "PySide6",
    "pytest-qt": "pytestqt",
    "pytest-xdist": "xdist",
}


@dataclass(frozen=True)
class Requirement:
    """One line of ``pyproject.toml``: a distribution and the half-open range it may be in."""

    text: str
    name: str
    bounds: tuple[tuple[str, tuple[int, ...]], ...]

    @property
    def import_name(self) -> str:
        """The module whose presence shows that the distribution is there."""
        return _IMPORT_NAME.get(self.name.lower(), self.name.lower().replace("-", "_"))

    def admits(self, version: str) -> bool:
        """Whether a version such as ``"6.11.3"`` lies within all bounds."""
        found = _release(version)
        return all(_HOLDS[operator](found, bound) for operator, bound in self.bounds)


def _release(version: str) -> tuple[int, ...]:
    """The numbers of a version, without the zeros at its end: 6.12 and 6.12.0 are equal."""
    match = re.match(r"\d+(\.\d+)*", version)
    numbers = [int(part) for part in match.group().split(".")] if match else []
    while numbers and numbers[-1] == 0:
        numbers.pop()
    return tuple(numbers)


_HOLDS = {
    ">=": lambda found, bound: found >= bound,
    "<": lambda found, bound: found < bound,
    "==": lambda found, bound: found == bound,
}
_REQUIREMENT = re.compile(
    r"""(?P<name>[\w.-]+) \s* (?P<bounds>[^;]*?) \s*
        (; \s* python_version \s* (?P<operator>>=|<|==) \s* ['"](?P<python>[\d.]+)['"] )? \s*""",
    re.VERBOSE,
)


def _requirement(text: str) -> Requirement | None:
    """Read one requirement; None where its marker is about another Python."""
    match = _REQUIREMENT.fullmatch(text)
    bounds = []
    for part in match["bounds"].split(",") if match and match["bounds"] else ():
        bound = re.fullmatch(r"\s*(>=|<|==)\s*([\d.]+)\s*", part)
        if bound is None:
            match = None
            break
        bounds.append((bound[1], _release(bound[2])))
    if match is None:
        raise SetupError(f"pyproject.toml has a requirement that the set-up cannot read: {text}")
    if match["operator"]:
        here = _release(f"{sys.version_info[0]}.{sys.version_info[1]}")
        if not _HOLDS[match["operator"]](here, _release(match["python"])):
            return None
    return Requirement(text, match["name"], tuple(bounds))


def requirements(root: Path, extras: Sequence[str] = ()) -> list[Requirement]:
    """What ``pyproject.toml`` asks for on this Python.

    Parameters
    ----------
    root : Path
        The folder of ``pyproject.toml``.
    extras : sequence of str
        Names of optional groups that are wanted too.
    """
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    texts = list(project["dependencies"])
    for extra in extras:
        texts += project["optional-dependencies"][extra]
    return [found for text in texts if (found := _requirement(text)) is not None]


def _are_importable(wanted: Iterable[Requirement]) -> bool:
    """Whether every package can be found, by looking only: importing VTK takes a second."""
    for requirement in wanted:
        spec = importlib.util.find_spec(requirement.import_name)
        # A folder left behind by an uninstalled package is found too, but leads to no file.
        if spec is None or spec.origin is None:
            return False
    return True


def unmet(wanted: Iterable[Requirement]) -> list[Requirement]:
    """The requirements that this interpreter does not meet, by version and by import name."""
    from importlib import metadata

    missing = []
    for requirement in wanted:
        try:
            version = metadata.version(requirement.name)
        except metadata.PackageNotFoundError:
            missing.append(requirement)
            continue
        if not requirement.admits(version) or not _are_importable([requirement]):
            missing.append(requirement)
    return missing


@contextlib.contextmanager
def _stoppable() -> Iterator[None]:
    """Say how to go on after Ctrl-C, which elsewhere interrupts a look round only."""
    try:
        yield
    except KeyboardInterrupt:
        _say(f"the set-up was stopped; to go on: {_command_again()}")
        raise


# --- the operating system's part ------------------------------------------------------------------


def missing_system(need: Need) -> list[System]:
    """Which libraries and programs of the operating system a need still lacks.

    macOS and Windows bring everything; on Linux nothing can be taken for granted.
    """
    if not sys.platform.startswith("linux"):
        return []
    # An X server is there already where DISPLAY names one.
    own_display = not os.environ.get("DISPLAY")
    return [
        item
        for item in SYSTEM
        if need in item.needs and (item.name != "Xvfb" or own_display) and not item.is_here()
    ]


def advice(missing: Sequence[System]) -> str:
    """One sentence that says what is missing and, where it is known, the command that brings it."""
    names = [item.name for item in missing]
    if shutil.which("apt-get") is None:
        what = ", ".join(names)
        return f"this system lacks {what}; install what brings them, and start again"
    if len(names) > 3:  # the command names them all
        names[2:] = [f"and {len(names) - 2} more"]
    return f"this system lacks {', '.join(names)}; run: {_apt_command(_packages(missing))}"


def _packages(missing: Iterable[System]) -> list[str]:
    names = dict.fromkeys(name for item in missing for name in item.packages.split())
    return [_name_here(name) for name in names]


def _name_here(package: str) -> str:
    renamed = _RENAMED.get(package)
    if renamed is None or shutil.which("apt-cache") is None:
        return package
    found = subprocess.run(["apt-cache", "show", renamed], capture_output=True, check=False)
    return renamed if found.returncode == 0 else package


def _apt_command(packages: Sequence[str]) -> str:
    command = shlex.join(["apt-get", "install", "-y", "--no-install-recommends", *packages])
    return command if _is_root() else f"sudo {command}"


def _is_root() -> bool:
    return sys.platform != "win32" and os.geteuid() == 0


@_stoppable()
def _ensure_system(missing: Sequence[System]) -> None:
    """Install what is missing where that is ours to do, else say how."""
    if not missing:
        return
    if not _is_root() or shutil.which("apt-get") is None:
        raise SetupError(advice(missing))
    _say("updating the list of system packages")
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    # A repository that cannot be reached is no reason to stop: the one that matters may be there.
    subprocess.run(["apt-get", "update"], env=environment, capture_output=True, check=False)
    packages = _packages(missing)
    _say(f"installing system packages: {' '.join(packages)}")
    done = subprocess.run(
        ["apt-get", "install", "-y", "--no-install-recommends", *packages],
        env=environment,
        capture_output=True,
        text=True,
        errors="replace",
        check=False,
    )
    if done.returncode != 0:
        why = _last_line(done.stderr.splitlines(), "E:") or f"exit status {done.returncode}"
        raise SetupError(f"apt-get failed ({why}); try: {_apt_command(packages)}")
    importlib.invalidate_caches()
    left = [item for item in missing if not item.is_here()]
    if left:
        raise SetupError(advice(left))


class _EnsurePip(System):
    def is_here(self) -> bool:
        return importlib.util.find_spec("ensurepip") is not None


def _venv_module() -> list[System]:
    """Debian and Ubuntu deliver ensurepip, without which no environment can be made, apart."""
    item = _EnsurePip("ensurepip", f"python3.{sys.version_info[1]}-venv")
    return [] if item.is_here() else [item]


# --- the virtual environment ----------------------------------------------------------------------


@dataclass(frozen=True)
class Environment:
    """The ``.venv`` beside the code, trusted only as far as its stamp says.

    The stamp holds one line for each group of packages (the program's own, with the test extras)
    that was installed completely, naming the Python, the platform and the exact requirements it
    was installed for. While packages are being installed it says so instead, and an environment
    that still says so when nobody holds the lock was left half-made.
    """

    root: Path
    extras: tuple[str, ...] = ()

    @property
    def folder(self) -> Path:
        return self.root / ".venv"

    @property
    def python(self) -> Path:
        inside = "Scripts/python.exe" if sys.platform == "win32" else "bin/python"
        return self.folder / inside

    @property
    def stamp(self) -> Path:
        return self.folder / _STAMP

    def line(self, extras: Sequence[str] = ()) -> str:
        """The stamp's line for a complete installation of the program and these extras."""
        texts = [requirement.text for requirement in requirements(self.root, extras)]
        texts.append(self.constraints.read_text(encoding="utf-8"))
        digest = hashlib.sha256("\n".join(texts).encode()).hexdigest()
        return f"{sys.implementation.cache_tag} {sys.platform} {'+'.join(extras) or '-'} {digest}"

    @property
    def constraints(self) -> Path:
        return self.root / "constraints.txt"

    def read_stamp(self) -> str | None:
        try:
            return self.stamp.read_text(encoding="utf-8")
        except (FileNotFoundError, NotADirectoryError):
            return None

    def is_complete(self) -> bool:
        stamp = self.read_stamp()
        if stamp is None or not self.python.exists():
            return False
        return self.line(self.extras) in stamp.split("\n")

    def is_running(self) -> bool:
        """Whether the present interpreter is this environment's own."""
        return Path(sys.prefix).resolve() == self.folder.resolve()

    @_stoppable()
    def make(self) -> None:
        """Bring the environment to completion from whatever state it is in."""
        started = time.monotonic()
        with _lock(self.root / ".venv.lock") as held:
            if self.is_complete():  # another start has just finished it
                return
            in_place = self._can_be_kept()
            if not in_place:
                _say(f"first start: setting up {self.folder} (once; needs the network)")
                if self.folder.exists():
                    self._clear()
                self.folder.mkdir(parents=True)
            else:
                _say(f"bringing {self.folder} up to date")
            self.stamp.write_text(_UNFINISHED, encoding="utf-8")
            if not in_place:
                self._create(held)
            self._install(held)
            lines = [self.line()] + ([self.line(self.extras)] if self.extras else [])
            fresh = self.stamp.with_suffix(".new")
            fresh.write_text("\n".join(lines) + "\n", encoding="utf-8")
            fresh.replace(self.stamp)
        _say(f"set up in {time.monotonic() - started:.0f} s")

    def _clear(self) -> None:
        try:
            shutil.rmtree(self.folder)
        except OSError as error:
            raise SetupError(
                f"{self.folder} could not be removed ({error}); close what runs in it and run "
                f"again: {_command_again()}"
            ) from None

    def _can_be_kept(self) -> bool:
        """Whether what is there can be completed by pip; else it has to be made anew."""
        if not self.python.exists():
            return False
        stamp = self.read_stamp()
        if stamp is not None:
            # Neither unfinished, nor for another Python or platform (a folder two machines share).
            ours = f"{sys.implementation.cache_tag} {sys.platform} "
            return stamp.startswith(ours) and self._runs() is not None
        # Somebody made it by hand. It is theirs: complete it, or leave it alone.
        tag = self._runs()
        if tag is not None and tag != sys.implementation.cache_tag:
            raise SetupError(
                f"{self.folder} was made by hand for another Python; remove it and start again: "
                f"{_remove(self.folder)}"
            )
        return tag is not None

    def _runs(self) -> str | None:
        """Which Python the environment runs, or None where it does not run, or has no pip."""
        probe = "import sys, pip; print(sys.implementation.cache_tag)"
        try:
            done = subprocess.run(
                [self.python, "-I", "-c", probe], capture_output=True, text=True, check=False
            )
        except OSError:
            return None
        return done.stdout.strip() if done.returncode == 0 else None

    def _create(self, held: Held) -> None:
        output: list[str] = []
        status = held.run([sys.executable, "-I", "-m", "venv", str(self.folder)], output.append)
        if status != 0:
            why = _last_line(output) or f"exit status {status}"
            raise SetupError(
                f"Python could not make a virtual environment ({why}); try it with: "
                f"{command_line([sys.executable, '-m', 'venv', '--clear', str(self.folder)])}"
            )

    def _install(self, held: Held) -> None:
        """Install the tested versions, or where they do not exist for this machine, newer ones."""
        wanted = [requirement.text for requirement in requirements(self.root, self.extras)]
        # -I: a package on PYTHONPATH must not pass for an installed one. Wheels only: building VTK
        # or numpy from source is no fallback for a teaching program. Later ones of the user's own
        # PIP_... settings (index, proxy, certificate) still hold.
        pip = [str(self.python), "-I", "-m", "pip", "install", "--disable-pip-version-check"]
        pip += ["--no-input", "--progress-bar", "off", "--only-binary", ":all:"]
        status, output = self._pip(held, [*pip, "-c", str(self.constraints), *wanted])
        if status != 0 and _shows(output, _UNOBTAINABLE) and not _shows(output, _NO_ANSWER):
            _say("the tested versions do not exist for this machine: trying others")
            status, output = self._pip(held, [*pip, *wanted])
        if status != 0:
            why = _last_line(output, "ERROR:") or f"exit status {status}"
            to_do = "check the network"
            if _shows(output, _NO_ANSWER):
                why = "no package server could be reached"  # whatever pip concluded from that
            elif _shows(output, _HELD):
                to_do = "close all windows of Frustum Lab"
            raise SetupError(
                f"the Python packages could not be installed ({why}); "
                f"{to_do} and run again: {_command_again()}"
            )

    def _pip(self, held: Held, command: list[str]) -> tuple[int, list[str]]:
        output: list[str] = []
        said = ""

        def follow(line: str) -> None:
            nonlocal said
            output.append(line)
            text = _progress(line)
            if text is not None and text != said:
                _say(f"  {text}")
                said = text

        return held.run(command, follow), output


def _progress(line: str) -> str | None:
    """What a line of pip's output means to somebody who waits; None for most of them."""
    line = line.strip()
    match = re.match(r"(?:Downloading|Using cached|Processing) (?:\S*/)?([^/\s]+)\.whl(.*)", line)
    if match and not match[2].startswith(".metadata"):
        name, version = match[1].split("-")[:2]
        return f"{name} {version}{match[2]}"
    match = re.match(r"Installing collected packages: (.*)", line)
    if match:
        return f"installing {match[1].count(',') + 1} packages"
    if re.search(_NO_ANSWER, line):
        return "the package server does not answer; trying again"
    return None


def _shows(output: Iterable[str], pattern: str) -> bool:
    return any(re.search(pattern, line) for line in output)


def _last_line(lines: Iterable[str], start: str = "") -> str:
    found = [line.strip() for line in lines if line.strip().startswith(start)]
    return found[-1].removeprefix(start).strip().rstrip(".") if found else ""


# --- one set-up at a time -------------------------------------------------------------------------


class Held:
    """A held lock, which programs started under it hold too.

    When a set-up is killed its pip may live on for a while (not on Linux, where it goes too). As
    pip inherited the open lock file, the lock is free only when pip is gone, and the next start
    cannot get in its way.
    """

    def __init__(self, file: IO[bytes]) -> None:
        self._file = file

    def run(self, command: Sequence[str], follow: Callable[[str], object]) -> int:
        """Run a command, hand each line it says to `follow`, return its exit status."""
        unwanted = ("PIP_USER", "PIP_TARGET", "PIP_PREFIX", "PIP_ROOT", "PYTHONHOME")
        environment = {key: value for key, value in os.environ.items() if key not in unwanted}
        environment["PYTHONUNBUFFERED"] = "1"
        with subprocess.Popen(
            command,
            env=environment,
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
    """Let a child process, before it becomes another program, end when its parent is killed."""
    if sys.platform.startswith("linux"):  # nobody else knows how
        pr_set_pdeathsig = 1
        ctypes.CDLL(None).prctl(pr_set_pdeathsig, signal.SIGTERM)


@contextlib.contextmanager
def _lock(path: Path) -> Iterator[Held]:
    """Hold a lock that the operating system takes back from a process that dies."""
    with open(path, "ab") as file:
        if not _try_lock(file):
            _say("another start is setting up; waiting for it")
            while not _try_lock(file):
                time.sleep(0.2)
        yield Held(file)


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


def start(need: Need, extras: Sequence[str] = ()) -> None:
    """Return when everything is there; otherwise bring it, and start the same command again.

    Parameters
    ----------
    need : Need
        What the command asks of the operating system.
    extras : sequence of str
        Optional groups of ``pyproject.toml`` that are needed too.

    Raises
    ------
    SystemExit
        With status 3 after one sentence on standard error, when something is missing that only
        the user can bring.
    """
    try:
        _start(need, tuple(extras))
    except SetupError as error:
        fail(str(error))
    except OSError as error:
        fail(
            f"the set-up failed ({error}); put Frustum Lab into a folder that you may write to, "
            f"with 2 GB of space, and run again: {_command_again()}"
        )
    except KeyboardInterrupt:  # whoever was setting something up has said so
        raise SystemExit(130) from None


def _start(need: Need, extras: tuple[str, ...]) -> None:
    if not (ROOT / "pyproject.toml").exists():
        # Installed by pip, which has seen to the packages.
        _ensure_system(missing_system(need))
        return
    environment = Environment(ROOT, extras)
    wanted = requirements(ROOT, extras)
    inside = environment.is_running()
    if _is_met(wanted, environment):
        os.environ.pop(_AGAIN, None)
        _ensure_system(missing_system(need))
        return
    if not inside and environment.is_complete() and _AGAIN not in os.environ:
        _again(environment.python)
    if _AGAIN in os.environ:
        names = ", ".join(requirement.name for requirement in unmet(wanted))
        raise SetupError(
            f"{environment.folder} lacks {names} although pip installed them; remove it and start "
            f"again: {_remove(environment.folder)}"
        )
    if inside:
        if environment.is_complete():  # so it says, but it has lost something since
            environment.stamp.write_text(_UNFINISHED, encoding="utf-8")
        # An environment cannot be made anew while it runs: that is done from outside.
        outside = Path(getattr(sys, "_base_executable", sys.executable))
        if sys.platform == "win32":  # where this process would wait, and hold its own file
            names = ", ".join(requirement.name for requirement in unmet(wanted))
            raise SetupError(
                f"{environment.folder} lacks {names or 'a part'}; start again: "
                f"{command_line([str(outside), *sys.orig_argv[1:]])}"
            )
        _again(outside)
    _ensure_system([*_venv_module(), *missing_system(need)])
    environment.make()
    os.environ[_AGAIN] = "1"
    _again(environment.python)


def _is_met(wanted: Sequence[Requirement], environment: Environment) -> bool:
    """Whether this interpreter has the packages; quick to say no, and quick to say yes in .venv."""
    if not _are_importable(wanted):
        return False
    if environment.is_running() and (stamp := environment.read_stamp()) is not None:
        if stamp == _UNFINISHED:
            return False
        if environment.is_complete():
            return True
    return not unmet(wanted)


@contextlib.contextmanager
def for_good() -> Iterator[None]:
    """Import what stays until the end, which no collection of garbage need look through.

    While VTK and Qt are imported Python would do so some 500 times, a tenth of the time to the
    first frame; and later again in the middle of a drag, for as long as three frames.
    """
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        gc.enable()


def fail(sentence: str) -> NoReturn:
    """Give up on the set-up, saying what the user can do."""
    _say(sentence)
    raise SystemExit(EXIT_NOT_SET_UP)


def _again(python: Path) -> NoReturn:
    """Give this process's place to the same command under another interpreter."""
    command = [str(python), *sys.orig_argv[1:]]
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:  # as both are in pythonw
            stream.flush()
    if sys.platform == "win32":  # where exec returns to the shell before the program has ended
        with subprocess.Popen(command) as process:
            while process.poll() is None:
                with contextlib.suppress(KeyboardInterrupt):  # the program has it too, and decides
                    process.wait()
        raise SystemExit(process.returncode)
    os.execv(command[0], command)


def command_line(words: Sequence[str]) -> str:
    """A command as it is typed here; in Windows as cmd.exe takes it, where ' quotes nothing."""
    if sys.platform != "win32":
        return shlex.join(words)
    return " ".join(word if re.fullmatch(r"[\w\\:./=+-]+", word) else f'"{word}"' for word in words)


def _remove(folder: Path) -> str:
    command = ["rmdir", "/s"] if sys.platform == "win32" else ["rm", "-r"]
    return command_line([*command, str(folder)])


def _command_again() -> str:
    return command_line([Path(sys.executable).name, *sys.orig_argv[1:]])


def _say(text: str) -> None:
    if sys.stderr is not None:
        print(f"frustum-lab: {text}", file=sys.stderr, flush=True)
