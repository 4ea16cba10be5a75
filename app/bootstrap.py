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

``.venv`` is beside the code or, where nobody may write or Windows' paths would be too long, in the
user's data folder. One that another program made is never changed: it is used if it has everything.

The packages and their bounds are in ``pyproject.toml`` (`app.python_packages`), the tested exact
versions in ``constraints.txt``, the system libraries in `app.system_packages`. This module imports
the standard library only. It writes to standard error, because standard output belongs to the
command.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import platform
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import NoReturn

from app import modules
from app.held_lock import HeldLock, lock, log
from app.languages import said
from app.python_packages import Requirement, are_importable, pins, requirements, unmet
from app.system_packages import Need, SetupError, install, last_line, missing_system, venv_module

ROOT = Path(modules.ROOT)
#: The command that starts the program: an installed one has no checkout around it.
PROGRAM = f"{'py' if sys.platform == 'win32' else 'python3'} -m app"
if not os.path.exists(ROOT / "pyproject.toml"):
    PROGRAM = "frustum-lab"
EXIT_NOT_SET_UP = 3
#: Space for a fresh environment with the tests' packages, 1.15 GB, and pip's temporary files.
SPACE_GB = 1.5
#: Longest path beside which Windows, which takes 260 characters, has room for all of ``.venv``.
LONGEST_ROOT = 83
#: In the folder of the code, the wheels that ``bundle --wheels`` collected: no network is needed.
WHEELS = "wheels"

_UNFINISHED = "setting up\n"
_PIN = r"(?:No matching distribution found for|user requested \(constraint\)) ([\w.-]+)"
_NO_ANSWER = r"Retrying \("
_INSTALLING = "Installing collected packages: "
_AGAIN = "FRUSTUM_LAB_STARTED_AGAIN"
_AS_IT_IS = "as it is"


def _failure(what: str, why: str, folder: Path, output: str = "") -> SetupError:
    """Return a sentence of what failed, why, and what helps."""
    page = Path(__file__).parent / "content" / "set-up.md"  # by patterns of what was said
    remedies = re.findall("(?m)^- (.*?): (.*)", page.read_text(encoding="utf-8"))
    remedy = next(text for pattern, text in remedies if re.search(pattern, f"{output}\n{why}"))
    if remedy == remedies[0][1]:
        why = said("no package server could be reached")  # whatever pip's own conclusion
    bits = 64 if sys.maxsize > 2**32 else 32
    python = said("Python {0}, {1} bits, {2},", platform.python_version(), bits, platform.machine())
    names = {"again": _command_again(), "program": PROGRAM, "space": SPACE_GB}
    helps = said(remedy).format(folder=folder, python=python, **names)
    return SetupError(f"{what} ({why}); {helps}")


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
    """The ``.venv``, which is trusted only according to its stamp.

    The stamp has one line for each group of packages that was installed completely: the program's,
    and the program's with extras. A line names the Python, the platform and the exact
    requirements. From the moment when pip has downloaded everything until it has installed it, the
    stamp says that the environment is unfinished. An unfinished environment is made anew, and so is
    one of another Python.
    """

    def __init__(self, root: Path, extras: Sequence[str] = ()) -> None:
        self.root, self.extras = root, tuple(extras)
        self.folder = root / ".venv"
        if not os.path.lexists(self.folder) and not _has_room(root):
            self.folder = data_folder() / ".venv"
        windows = sys.platform == "win32"
        self.python = self.folder / ("Scripts/python.exe" if windows else "bin/python")
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
            raise SetupError("not-a-folder", self.folder, _command_again())
        started = time.monotonic()
        self.folder.parent.mkdir(parents=True, exist_ok=True)
        with _stoppable(), lock(self.folder.parent / ".venv.lock") as held:
            if self.is_complete():  # another start has just finished it
                return
            if (self.read_stamp() or "").startswith(_here()):  # machines may share a folder
                held.show(said("bringing {0} up to date", self.folder))
            else:
                if shutil.disk_usage(self.folder.parent).free < SPACE_GB * 1e9:
                    raise _failure(said("there is no room"), "No space left", self.folder)
                network = "" if os.path.exists(self.root / WHEELS) else said("; needs the network")
                held.show(said("first start: setting up {0} (once{1})", self.folder, network))
                self._make_anew(held)
            self._install(held)
            lines = dict.fromkeys(f"{self.line(extras)}\n" for extras in ((), self.extras))
            fresh = self.stamp.with_suffix(".new")
            fresh.write_text("".join(lines), encoding="utf-8")
            fresh.replace(self.stamp)
        log(said("set up in {0:.0f} s", time.monotonic() - started))

    def _make_anew(self, held: HeldLock) -> None:
        try:
            if os.path.exists(self.folder):
                shutil.rmtree(self.folder)
        except OSError as error:
            raise SetupError("not-removed", self.folder, error, _command_again()) from None
        self.folder.mkdir()
        self.mark_unfinished()
        output: list[str] = []
        command = [sys.executable, "-I", "-m", "venv", str(self.folder)]
        if status := held.run(command, output.append):
            why = last_line(output) or said("exit status {0}", status)
            what = said("{0} failed", command_line(command))
            raise _failure(what, why, self.folder, "\n".join(output))

    def mark_unfinished(self) -> None:
        self.stamp.write_text(_UNFINISHED, encoding="utf-8")

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
        """Install the tested versions and, of those that do not exist here, others."""
        wanted = [requirement.text for requirement in requirements(self.root, self.extras)]
        # -I: a package on PYTHONPATH must not pass for an installed one. Wheels only: building VTK
        # or numpy from source is no fallback for a teaching program. The user's own PIP_...
        # settings (index, proxy, certificate) still apply.
        pip = [str(self.python), "-I", "-m", "pip", "install", "--disable-pip-version-check"]
        pip += ["--no-input", "--progress-bar", "off", "--only-binary", ":all:"]
        if os.path.exists(wheels := self.root / WHEELS):
            pip += ["--no-index", "--find-links", str(wheels)]
        tested = pins(self.root)
        kept = self.folder / self.constraints.name
        while True:
            kept.write_text("\n".join(tested), encoding="utf-8")
            status, output = self._pip(held, [*pip, "-c", str(kept), *wanted])
            whole = "\n".join(output)
            names = {_plain(name) for name in re.findall(_PIN, whole)}
            others = [pin for pin in tested if _plain(re.split("[= ]", pin)[0]) not in names]
            if status == 0 or len(others) == len(tested) or re.search(_NO_ANSWER, whole):
                break
            lacking = ", ".join(sorted(names))
            held.show(said("no tested version of {0} here: trying others", lacking))
            tested = others
        if status != 0:
            why = last_line(output, "ERROR:") or said("exit status {0}", status)
            what = said("the Python packages could not be installed")
            raise _failure(what, why, self.folder, whole)

    def _pip(self, held: HeldLock, command: list[str]) -> tuple[int, list[str]]:
        output: list[str] = []
        printed: set[str] = set()  # pip names a package again after inspecting it

        def follow(line: str) -> None:
            output.append(line)
            if line.startswith(_INSTALLING):  # everything is downloaded: pip changes nothing before
                self.mark_unfinished()
                held.show(said("  installing packages: {0}", line.count(",") + 1))
            elif (text := _progress(line)) is not None and text not in printed:
                printed.add(text)
                held.show(f"  {text}")

        return held.run(command, follow), output


def _here() -> str:
    return f"{sys.implementation.cache_tag} {sys.platform} "


def _plain(name: str) -> str:
    return name.lower().replace("_", "-")


def data_folder() -> Path:
    """The folder for an environment that cannot be beside the code; a user may have no home."""
    places = {"win32": "AppData/Local", "darwin": "Library/Application Support"}
    place = os.environ.get("LOCALAPPDATA" if sys.platform == "win32" else "XDG_DATA_HOME", "")
    usual = Path("/", os.path.expanduser("~"), places.get(sys.platform, ".local/share"))
    return Path(place if os.path.isabs(place) else usual) / "frustum-lab"


def _has_room(root: Path) -> bool:
    """Whether an environment in this folder can be written, and read by Windows."""
    try:
        tempfile.TemporaryFile(dir=root).close()
    except OSError as error:
        return not isinstance(error, PermissionError) and error.errno != 30  # a read-only disk
    return sys.platform != "win32" or len(str(root)) <= LONGEST_ROOT


def _progress(line: str) -> str | None:
    """Return the progress message for a line of pip's output; None for most lines."""
    match = re.match(
        r"\s*(?:Downloading|Using cached|Processing) (?:\S*[/\\])?([^/\\\s]+)\.whl(.*)", line
    )
    if match and not match[2].startswith(".metadata"):
        name, version = match[1].split("-")[:2]
        return f"{name} {version}{match[2].rstrip()}"
    is_lost = re.search(_NO_ANSWER, line)
    return said("the package server does not answer; trying again") if is_lost else None


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
            with _stoppable():
                install(missing)


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
    if not isinstance(error, ModuleNotFoundError) or PROGRAM == "frustum-lab":
        return ""
    name = (error.name or "").partition(".")[0]
    of_package = next((each for each in requirements(ROOT) if each.import_name == name), None)
    if of_package is None:
        return ""
    environment = Environment(ROOT)
    how = pip_install("--force-reinstall", of_package.text)
    how = _remove(environment.folder) if environment.is_running() else how
    return said("package-damaged", of_package.name, error, how)


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
        remove = _remove(environment.folder)
        raise SetupError("lacks-installed", environment.folder, names, remove)
    if environment.is_running():
        if environment.is_complete():  # its stamp is complete, but a package has been lost since
            environment.mark_unfinished()
        # An environment cannot be replaced while it runs, so that is done from outside.
        outside = Path(getattr(sys, "_base_executable", sys.executable))
        if sys.platform == "win32":  # where this process would wait and keep its own file open
            command = command_line([str(outside), *sys.orig_argv[1:]])
            raise SetupError("a-part", environment.folder, names or said("a part"), command)
        again(outside)
    if environment.is_foreign():
        lost, remove = environment.lacks() or said("packages"), _remove(environment.folder)
        raise SetupError("foreign", environment.folder, lost, remove)
    if missing := [*venv_module(), *missing_system(need)]:
        with _stoppable():
            install(missing)
    how = "made"
    try:
        environment.make()
    except SetupError as error:
        lacking = environment.lacks()
        if lacking is None:
            raise
        log(f"{error}")
        log(said("not-met", lacking) if lacking else said("going on with the installed packages"))
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
        fail(str(_failure(said("the set-up failed"), str(error), ROOT)))
    except KeyboardInterrupt:  # whichever process was setting up has reported it
        raise SystemExit(130) from None


@contextlib.contextmanager
def _stoppable() -> Iterator[None]:
    """Say how to continue after Ctrl-C."""
    try:
        yield
    except KeyboardInterrupt:
        log(said("the set-up was stopped; to go on: {0}", _command_again()))
        raise


def fail(sentence: str) -> NoReturn:
    """End the set-up, and say what the user can do."""
    log(sentence)
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


def pip_install(*words: str) -> str:
    return command_line([sys.executable, "-m", "pip", "install", *words])


def _remove(folder: Path) -> str:
    command = ["rmdir", "/s"] if sys.platform == "win32" else ["rm", "-r"]
    return command_line([*command, str(folder)])


def _command_again() -> str:
    return command_line([Path(sys.executable).name, *sys.orig_argv[1:]])
