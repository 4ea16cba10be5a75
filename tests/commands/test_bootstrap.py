"""The set-up, with real virtual environments and a real pip, but a package of a few bytes.

Each test has a checkout of its own in a temporary folder: the real ``app/bootstrap.py`` and
``app/__main__.py``, and a ``pyproject.toml`` that asks for "frustum-probe" instead of VTK and Qt.
"""

import ast
import contextlib
import gc
import io
import json
import os
import platform
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import tomllib
import zipfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest
from packaging.markers import Marker
from packaging.requirements import Requirement as Standard

from app import __version__, bootstrap, held_lock, python_packages, system_packages
from app.__main__ import need_of
from app.python_packages import requirements, unmet
from tests import PATIENCE_MS
from tests.__main__ import hides

PYTHON = getattr(sys, "_base_executable", sys.executable)  # outside every virtual environment
COMMAND_LINE = """
import json, sys
import frustum_probe

def main(arguments):
    print(json.dumps([sys.prefix, frustum_probe.VERSION, arguments]))
    return 0
"""
PROJECT = """
[project]
dependencies = ["frustum-probe{bounds}"]
[project.optional-dependencies]
test = ["frustum-extra>=1,<2"]
"""


def wheel(folder: Path, name: str, version: str) -> None:
    """Write a wheel of a package that knows its version and nothing else."""
    info = f"{name}-{version}.dist-info"
    files = {
        f"{name}/__init__.py": f"VERSION = {version!r}\n",
        f"{info}/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n",
        f"{info}/WHEEL": "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
    }
    record = "".join(f"{path},,\n" for path in [*files, f"{info}/RECORD"])
    folder.mkdir(exist_ok=True)
    with zipfile.ZipFile(folder / f"{name}-{version}-py3-none-any.whl", "w") as archive:
        for path, text in {**files, f"{info}/RECORD": record}.items():
            archive.writestr(path, text)


@dataclass(frozen=True)
class Checkout:
    """A checkout, and the package files that its machine can reach."""

    root: Path
    wheels: Path

    def ask_for(self, bounds: str, exactly: str) -> None:
        (self.root / "pyproject.toml").write_text(PROJECT.format(bounds=bounds), encoding="utf-8")
        (self.root / "constraints.txt").write_text(f"frustum-probe=={exactly}\n", encoding="utf-8")

    @property
    def package(self) -> Path:
        (found,) = (self.root / ".venv").rglob("frustum_probe/__init__.py")
        return found.parent

    @property
    def python(self) -> str:
        """The interpreter of its environment."""
        return str(bootstrap.Environment(self.root).python)

    @property
    def stamp(self) -> Path:
        return self.root / ".venv" / "frustum-lab.stamp"

    def start(
        self, *arguments: str, python: str = PYTHON, **environment: str
    ) -> subprocess.Popen[str]:
        """Start Python in the checkout, on a machine without a network and with an empty home."""
        home, scratch = self.root.parent / "home", self.root.parent / "scratch"
        home.mkdir(exist_ok=True)
        scratch.mkdir(exist_ok=True)  # where a pip that is killed leaves its things
        kept = {key: value for key, value in os.environ.items() if not key.startswith("PIP_")}
        kept |= {"HOME": str(home), "TMPDIR": str(scratch)}
        kept |= {"PIP_CONFIG_FILE": os.devnull, "PIP_NO_CACHE_DIR": "1"}
        if "PIP_INDEX_URL" not in environment:
            kept |= {"PIP_NO_INDEX": "1", "PIP_FIND_LINKS": str(self.wheels)}
        return subprocess.Popen(
            [python, *arguments],
            cwd=self.root,
            env=kept | environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def run(self, *arguments: str, **environment: str) -> tuple[int, str, str]:
        with self.start(*arguments, **environment) as process:
            output, said = process.communicate()
        return process.returncode, output, said

    def assert_runs(self, version: str = "1.0", **environment: str) -> str:
        """Run ``python3 -m app``, check that it ran inside .venv, return what was said."""
        status, output, said = self.run("-m", "app", "matrices", **environment)
        assert (status, said[-500:] if status else "") == (0, "")
        assert json.loads(output) == [str(self.root / ".venv"), version, ["matrices"]]
        return said


@pytest.fixture
def fresh(tmp_path: Path) -> Checkout:
    """A checkout that was never started."""
    checkout = Checkout(tmp_path / "lab with a space", tmp_path / "wheels")
    for folder in ("commands/content", "content", "document", "lessons", "model/content"):
        (checkout.root / "app" / folder).mkdir(parents=True)
    (checkout.root / "widgets").mkdir()
    (checkout.root / "widgets" / "__init__.py").touch()
    shutil.copy(bootstrap.ROOT / "__main__.py", checkout.root)
    stdlib_only = (
        *(
            "commands/__init__.py",
            "commands/options.py",
            "commands/terminal.py",
            "commands/doctor.py",
            "commands/content/options.md",
        ),
        *("document/__init__.py", "document/lengths.py"),
        *("lessons/__init__.py", "lessons/contents.py"),
        *("model/__init__.py", "model/numerals.py", "model/refusal.py"),
        "model/content/sentences.md",
    )
    of_start = (
        "__init__.py",
        "__main__.py",
        "bootstrap.py",
        "content/sentences.md",
        "content/set-up.md",
        "held_lock.py",
        "languages.py",
        "modules.py",
        "python_packages.py",
        "strangers.py",
        "system_packages.py",
    )
    for name in (*of_start, *stdlib_only):
        shutil.copy(bootstrap.ROOT / "app" / name, checkout.root / "app" / name)
    (checkout.root / "app" / "commands" / "cli.py").write_text(COMMAND_LINE, encoding="utf-8")
    checkout.ask_for(">=1,<2", exactly="1.0")
    wheel(checkout.wheels, "frustum_probe", "1.0")
    wheel(checkout.wheels, "frustum_extra", "1.0")
    return checkout


@pytest.fixture(scope="module")
def first_starts(tmp_path_factory: pytest.TempPathFactory) -> tuple[Checkout, list[str]]:
    """A checkout that was first started twice at once, and the output of both starts."""
    checkout = fresh.__wrapped__(tmp_path_factory.mktemp("made"))
    command = ("-m", "app", "matrices")
    with checkout.start(*command) as one, checkout.start(*command) as two:
        ends = [process.communicate() for process in (one, two)]
    assert [process.returncode for process in (one, two)] == [0, 0], ends
    return checkout, [said for _, said in ends]


def copy(source: str, target: str) -> None:
    """Copy a file; link pip's thousand files, which nobody changes."""
    (os.link if "site-packages" in source else shutil.copy2)(source, target)


@pytest.fixture
def made(first_starts: tuple[Checkout, list[str]], tmp_path: Path) -> Checkout:
    """A checkout of the test's own that was started before."""
    original = first_starts[0].root
    shutil.copytree(original.parent, tmp_path, True, copy_function=copy, dirs_exist_ok=True)
    return Checkout(tmp_path / original.name, tmp_path / "wheels")


def pip_says(patch: pytest.MonkeyPatch, *lines: str, status: int = 1) -> None:
    """Let these lines be what every command of the set-up prints."""

    def run(_: object, _command: object, follow: Callable[[str], object]) -> int:
        for line in lines:
            follow(line)
        return status

    patch.setattr(bootstrap.HeldLock, "run", run)


def stopped_at_the_lock(made: Checkout) -> None:
    """Let a set-up go as far as its lock and no further: making an environment anew is slow."""
    (made.root / ".venv.lock").unlink()
    (made.root / ".venv.lock").mkdir()


def one_sentence(said: str) -> str:
    """The last line that was said, after checking that no traceback was among them."""
    assert "Traceback" not in said
    return said.splitlines()[-1]


def refused(checkout: Checkout, *arguments: str, status: int = 3, **environment: str) -> str:
    """The sentence with which a start ends, ``matrices`` if no arguments are given."""
    ended, output, said = checkout.run(*(arguments or ("-m", "app", "matrices")), **environment)
    assert (ended, output) == (status, "")
    return one_sentence(said)


Refusing = Callable[..., str]


@pytest.fixture
def start_refused(capsys: pytest.CaptureFixture[str]) -> Refusing:
    """Start here what must be refused; return the sentence."""

    def start(need: system_packages.Need, extras: Sequence[str] = ()) -> str:
        with pytest.raises(SystemExit) as end:
            bootstrap.start(need, extras)
        assert end.value.code == 3
        return one_sentence(capsys.readouterr().err)

    return start


def stopped_at_the_server(made: Checkout, by: signal.Signals) -> tuple[int, str, str]:
    """Stop a start while pip waits for the answer of a server."""
    with socket.create_server(("127.0.0.1", 0)) as silent:
        address = f"http://127.0.0.1:{silent.getsockname()[1]}/"
        with made.start("-m", "app", "matrices", PIP_INDEX_URL=address) as process:
            connection, _ = silent.accept()
            process.send_signal(by)
            connection.close()
            output, said = process.communicate()
    return process.returncode, output, said


# --- the virtual environment ----------------------------------------------------------------------


def test_help_version_and_doctor_need_no_set_up(fresh: Checkout) -> None:
    for command in ("", "export", "doctor"):
        status, output, said = fresh.run("-m", "app", *command.split(), "--help")
        assert (status, said) == (0, "")
        assert output.startswith(f"usage: python3 -m app {command}".rstrip())
    assert fresh.run("-m", "app", "--version") == (0, f"Frustum Lab {__version__}\n", "")
    said = refused(fresh, "-m", "app", "projct", "--help", status=2)
    assert "nearest command is project" in said
    status, output, said = fresh.run("-m", "app", "doctor")
    assert (status, said) == (3, "")
    assert re.search(r"^Environment +not set up yet$", output, re.MULTILINE)
    assert re.search(r"Environment: the first start sets it up.*: python\S* -m app$", output, re.M)
    assert re.search(r"^System libraries +(all here|missing: )", output, re.MULTILINE)
    assert not (fresh.root / ".venv").exists()


def test_the_doctor_uses_an_existing_environment(made: Checkout) -> None:
    """It stops early in this one, which has no Qt."""
    _, output, _ = made.run("-m", "app", "doctor")
    assert f"({made.python})" in output
    assert "frustum-probe       1.0 (needed: >=1,<2)" in output
    assert "not set up" not in output


def test_two_first_starts_at_once_make_one_environment(
    first_starts: tuple[Checkout, list[str]],
) -> None:
    checkout, said = first_starts
    assert sorted("set up in" in text for text in said) == [False, True]
    assert sorted("another start is setting up" in text for text in said) == [False, True]
    assert checkout.assert_runs() == ""


def test_a_first_start_says_what_it_does(first_starts: tuple[Checkout, list[str]]) -> None:
    (said,) = (text for text in first_starts[1] if "set up in" in text)
    assert "first start: setting up" in said
    assert "frustum_probe 1.0" in said
    assert all(line.startswith("frustum-lab: ") for line in said.splitlines())


def test_a_second_start_installs_nothing_and_needs_no_network(made: Checkout) -> None:
    shutil.rmtree(made.wheels)
    assert made.assert_runs() == ""
    project = made.root / "pyproject.toml"  # whose comments and tool settings are nothing new
    project.write_text(
        f"# A comment.\n{project.read_text(encoding='utf-8')}\n[tool.ruff]\nline-length = 99\n",
        encoding="utf-8",
    )
    assert made.assert_runs() == ""


def test_a_start_inside_the_environment_stays_there(made: Checkout) -> None:
    command = [made.python, "-m", "app", "matrices"]
    done = subprocess.run(command, cwd=made.root, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout)[0] == str(made.root / ".venv")
    assert done.stderr == ""


def write_foreign(folder: Path) -> None:
    """Write modules that must not be taken for the program's and Python's own."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("random", "email", "typing", "dataclasses", "tomllib"):
        (folder / f"{name}.py").write_text("raise RuntimeError('foreign')\n", encoding="utf-8")
    (folder / "frustum_probe.py").write_text("VERSION = 'foreign'\n", encoding="utf-8")


@pytest.mark.parametrize("inside", [False, True])
@pytest.mark.parametrize(
    ("folder", "variable", "text"),
    [
        ("lab", "PYTHONPATH", ":{0}"),
        ("lab", "PYTHONHOME", sys.base_prefix),
        ("lab with a space", "VIRTUAL_ENV", "{0}"),  # the checkout, which is the current folder
        ("lib/python3.{1}/site-packages", "PYTHONUSERBASE", "{2}"),
    ],
)
def test_a_start_finds_its_own_modules(
    made: Checkout, folder: str, variable: str, text: str, inside: bool
) -> None:
    """Case 31: another numpy on PYTHONPATH; also a ``random.py`` in the current folder."""
    minor, above = sys.version_info[1], made.root.parent
    foreign = above / folder.format("", minor)
    write_foreign(foreign)
    for name in ("sitecustomize", "usercustomize"):
        (foreign / f"{name}.py").write_text("import frustum_probe\n", encoding="utf-8")
    environment = {variable: text.format(foreign, minor, above)}
    if inside:
        environment["python"] = made.python
    assert made.assert_runs(**environment) == ""


@pytest.mark.parametrize("path", ["", "app", "app/__main__.py"])
def test_the_program_starts_by_the_path_of_its_folder(made: Checkout, path: str) -> None:
    """Case 42."""
    status, output, said = made.run(str(made.root / path), "matrices")
    assert (status, said) == (0, "")
    assert json.loads(output) == [str(made.root / ".venv"), "1.0", ["matrices"]]


def test_the_doctor_names_what_is_set_aside(made: Checkout) -> None:
    foreign = made.root / "foreign"
    write_foreign(foreign)
    given = {"PYTHONPATH": str(foreign), "PYTHONHOME": sys.base_prefix}
    _, output, said = made.run("-m", "app", "doctor", **given)
    aside = f"PYTHONPATH={foreign}, PYTHONHOME={sys.base_prefix}"
    assert f"Set aside           {aside}; Frustum Lab prefers its own packages\n" in output
    assert "frustum-probe       1.0 (needed: >=1,<2)\n" in output
    assert said == ""
    assert "Set aside" not in made.run("-m", "app", "doctor", PYTHONPATH=str(made.root))[1]


def test_a_hidden_package_does_not_pass_for_the_installed_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    wanted = next(each for each in requirements(bootstrap.ROOT) if each.name == "mpmath")
    monkeypatch.delitem(sys.modules, "mpmath", raising=False)
    assert wanted.is_met()
    (tmp_path / "mpmath").mkdir()
    (tmp_path / "mpmath" / "__init__.py").touch()
    monkeypatch.syspath_prepend(tmp_path)
    assert not wanted.is_met()


def test_a_process_of_its_own_finds_the_same_modules(made: Checkout) -> None:
    """Whatever lies in its folder; `reading` and `doctor` start theirs so."""
    write_foreign(made.root)
    probe = (
        "from app import modules; modules.prefer_own(); import subprocess; "
        "subprocess.run(modules.command('app', 'matrices'), check=True)"
    )
    status, output, said = made.run("-c", probe, python=made.python)
    assert (status, said) == (0, "")
    assert json.loads(output)[1:] == ["1.0", ["matrices"]]


def test_a_damaged_package_is_named(made: Checkout) -> None:
    (made.root / "app" / "commands" / "cli.py").write_text(
        "import frustum_probe.part\n", encoding="utf-8"
    )
    remove = f"rm -r '{made.root / '.venv'}'"
    words = "replace it, and start again"
    error = "No module named 'frustum_probe.part'"
    expected = f"frustum-lab: the package frustum-probe is damaged ({error}); {words}: {remove}"
    assert refused(made) == expected
    (made.root / "app" / "commands" / "cli.py").write_text("import app.part\n", encoding="utf-8")
    assert "No module named 'app.part'" in made.run("-m", "app", "matrices")[2]


def test_the_tests_name_a_file_that_hides_a_module(tmp_path: Path) -> None:
    for name in ("random.py", "numpy.py", "notes.py", "email.txt"):
        (tmp_path / name).touch()
    (tmp_path / "types").mkdir()
    assert [path.name for path in sorted(tmp_path.iterdir()) if hides(path)] == [
        "numpy.py",
        "random.py",
    ]


def test_a_start_needs_no_standard_output(made: Checkout) -> None:
    """pythonw has none, and neither have services."""
    closed = 'exec "$@" >&- 2>&-', "sh", PYTHON
    probe = "import pathlib, sys; import app.__main__ as a; a.main(); pathlib.Path('ran').touch()"
    done = subprocess.run(["/bin/sh", "-c", *closed, "-c", probe], cwd=made.root, check=False)
    assert done.returncode == 0
    assert (made.root / "ran").exists()


def test_options_of_the_interpreter_survive_the_change_of_interpreter(made: Checkout) -> None:
    probe = (
        "import app.bootstrap as b, sys; b.start('numbers'); print(sys.flags.utf8_mode, sys.argv)"
    )
    status, output, _ = made.run("-X", "utf8", "-c", probe, "--set", "a b")
    assert (status, output) == (0, "1 ['-c', '--set', 'a b']\n")


def test_a_set_up_killed_while_it_asks_the_server_has_touched_nothing(made: Checkout) -> None:
    made.ask_for(">=2,<3", exactly="2.1")
    stopped_at_the_server(made, signal.SIGKILL)
    made.ask_for(">=1,<2", exactly="1.0")
    assert made.assert_runs() == ""


def test_an_environment_is_not_trusted_once_pip_changes_it(
    made: Checkout, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen = []

    def pip(_: object, _command: object, follow: Callable[[str], object]) -> int:
        follow("Collecting frustum-extra")
        seen.append(made.stamp.read_text(encoding="utf-8"))
        follow("Installing collected packages: frustum-extra")
        seen.append(made.stamp.read_text(encoding="utf-8"))
        return 1

    program = made.stamp.read_text(encoding="utf-8")
    with monkeypatch.context() as patch, pytest.raises(bootstrap.SetupError):
        patch.setattr(bootstrap.HeldLock, "run", pip)
        bootstrap.Environment(made.root, ("test",)).make()
    assert seen == [program, "setting up\n"]
    (made.root / ".venv" / "half-made").touch()
    run: list[str] = []
    monkeypatch.setattr(
        bootstrap.HeldLock, "run", lambda _, command, _follow: run.append(command[3]) or 0
    )
    bootstrap.Environment(made.root).make()
    assert run == ["venv", "pip"] and not (made.root / ".venv" / "half-made").exists()


def test_a_set_up_that_is_stopped_says_how_to_go_on(made: Checkout) -> None:
    made.ask_for(">=2,<3", exactly="2.1")
    status, output, said = stopped_at_the_server(made, signal.SIGINT)
    assert (status, output) == (130, "")
    stopped = r"frustum-lab: the set-up was stopped; to go on: python\S* -m app matrices"
    assert re.fullmatch(stopped, one_sentence(said))


@pytest.mark.parametrize("room", ["commands/cli.py", "bootstrap.py"])
def test_a_start_that_is_stopped_before_anything_is_set_up_says_nothing(
    made: Checkout, room: str
) -> None:
    (made.root / "app" / room).write_text("raise KeyboardInterrupt\n", encoding="utf-8")
    assert made.run("-m", "app", "matrices") == (130, "", "")


def test_a_check_that_is_stopped_says_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def stop(_need: system_packages.Need) -> list[system_packages.System]:
        raise KeyboardInterrupt

    monkeypatch.setattr(bootstrap, "missing_system", stop)
    with pytest.raises(SystemExit) as end:
        bootstrap.start("window")
    assert (end.value.code, capsys.readouterr().err) == (130, "")


@pytest.mark.parametrize("lost", ["python", "package", "end of its set-up"])
def test_an_environment_that_lost_a_part_is_not_trusted(made: Checkout, lost: str) -> None:
    python = Path(made.python)
    if lost == "python":
        python.unlink()
        python.symlink_to("/nonexistent/python3")
    elif lost == "package":
        shutil.rmtree(made.package)  # its dist-info stays, so pip would call it installed
    else:
        made.stamp.write_text("setting up\n", encoding="utf-8")
    stopped_at_the_lock(made)
    assert "a folder that you may write to" in refused(made)
    if lost != "python":
        assert made.stamp.read_text(encoding="utf-8") == "setting up\n"
        inside = [python, "-m", "app", "matrices"]
        done = subprocess.run(inside, cwd=made.root, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stdout) == (3, "")


@pytest.fixture
def not_set_up(fresh: Checkout, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let this process run in a checkout that lacks its package."""
    monkeypatch.setattr(bootstrap, "ROOT", fresh.root)


@pytest.mark.usefixtures("not_set_up")
def test_windows_does_not_rebuild_a_running_environment(
    monkeypatch: pytest.MonkeyPatch, start_refused: Refusing
) -> None:
    """There a running program's file cannot be removed."""
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(bootstrap.Environment, "is_running", lambda _: True)
    monkeypatch.setattr(bootstrap.Environment, "is_complete", lambda _: False)
    said = start_refused("numbers")
    assert re.search(r"\.venv lacks frustum-probe; start again: .*python", said)


def test_an_environment_that_cannot_be_removed_is_in_use(
    made: Checkout, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(folder: Path) -> None:
        raise PermissionError(13, "Access is denied", str(folder / "numpy.pyd"))

    made.stamp.write_text("setting up\n", encoding="utf-8")
    monkeypatch.setattr(shutil, "rmtree", refuse)
    with pytest.raises(
        bootstrap.SetupError, match=r"removed .*close the programs that run in it and ru"
    ):
        bootstrap.Environment(made.root).make()


def test_a_package_that_is_in_use_is_not_the_networks_fault(
    made: Checkout, monkeypatch: pytest.MonkeyPatch
) -> None:
    why = "ERROR: Could not install packages due to an OSError: [WinError 5] Access is denied"
    pip_says(monkeypatch, why)
    made.ask_for(">=0,<2", exactly="1.0")
    with pytest.raises(bootstrap.SetupError, match=r"close all windows of Frustum Lab and run ag"):
        bootstrap.Environment(made.root).make()


@pytest.mark.usefixtures("not_set_up")
def test_ctrl_c_is_left_to_the_program_that_windows_waits_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    class Program(contextlib.nullcontext["Program"]):
        """A program that asks about unsaved work before it ends."""

        returncode: int | None = None

        def __init__(self, _command: object) -> None:
            super().__init__(self)
            self.waits = 0

        def poll(self) -> int | None:
            return self.returncode

        def wait(self) -> None:
            self.waits += 1
            if self.waits < 3:
                raise KeyboardInterrupt
            self.returncode = 7

    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr("subprocess.Popen", Program)
    monkeypatch.setattr(bootstrap.Environment, "is_complete", lambda _: True)
    with pytest.raises(SystemExit) as end:
        bootstrap.start("numbers")
    assert end.value.code == 7


def without_pip(made: Checkout) -> Path:
    """Turn the environment into one of uv's, without stamp and pip; return its packages."""
    (made.root / ".venv" / "frustum-lab.stamp").unlink()
    (packages,) = (made.root / ".venv").glob("*ib/**/site-packages")
    for name in packages.glob("pip*"):
        shutil.rmtree(name)
    return packages


def test_a_complete_environment_of_another_program_is_used(made: Checkout) -> None:
    packages = without_pip(made)
    before = sorted(packages.iterdir())
    said = made.assert_runs()
    assert said == "" and sorted(packages.iterdir()) == before
    assert not (made.root / ".venv" / "frustum-lab.stamp").exists()


def test_an_environment_of_another_program_that_lacks_something_is_left_alone(
    made: Checkout,
) -> None:
    packages = without_pip(made)
    made.ask_for(">=2,<3", exactly="2.0")
    before = sorted(packages.iterdir())
    said = refused(made)
    assert "was made by another program and lacks frustum-probe>=2,<3; complete it" in said
    assert said.endswith(f"rm -r '{made.root}/.venv'")
    assert sorted(packages.iterdir()) == before


def test_too_little_space_is_reported_before_any_download(
    fresh: Checkout, monkeypatch: pytest.MonkeyPatch
) -> None:
    usage = shutil.disk_usage(fresh.root)
    monkeypatch.setattr(shutil, "disk_usage", lambda _folder: usage._replace(free=300_000_000))
    with pytest.raises(bootstrap.SetupError, match=r"too little space is left: free 1\.5 GB"):
        bootstrap.Environment(fresh.root).make()
    assert not (fresh.root / ".venv").exists()
    readme = " ".join((bootstrap.ROOT / "README.md").read_text(encoding="utf-8").split())
    assert f"{bootstrap.SPACE_GB} GB of free disk" in readme


@pytest.fixture
def emptied(made: Checkout) -> Checkout:
    """A checkout with an environment that has nothing but pip, which takes seconds to make."""
    made.stamp.write_text(
        f"{sys.implementation.cache_tag} {sys.platform} - of that time\n", encoding="utf-8"
    )
    shutil.rmtree(made.package)
    for info in (made.root / ".venv").rglob("frustum_probe-*.dist-info"):
        shutil.rmtree(info)
    return made


def test_new_bounds_bring_new_packages(made: Checkout) -> None:
    wheel(made.wheels, "frustum_probe", "2.1")
    made.ask_for(">=2,<3", exactly="2.1")
    assert "bringing" in made.assert_runs("2.1")
    assert made.assert_runs("2.1") == ""


def test_test_extras_are_added_and_the_program_still_starts_at_once(made: Checkout) -> None:
    probe = "from app import bootstrap; bootstrap.start('numbers', ['test']); import frustum_extra"
    status, _, said = made.run("-c", probe)
    assert (status, "frustum_extra 1.0" in said) == (0, True)
    shutil.rmtree(made.wheels)
    assert made.run("-c", probe) == (0, "", "")
    assert made.assert_runs() == ""


def test_other_versions_are_installed_if_the_tested_ones_do_not_exist(made: Checkout) -> None:
    made.ask_for(">=1,<2", exactly="1.7")
    assert "trying others" in made.assert_runs("1.0")
    assert made.assert_runs("1.0") == ""


def test_only_the_tested_version_that_does_not_exist_is_dropped(
    fresh: Checkout, monkeypatch: pytest.MonkeyPatch
) -> None:
    """macOS 13 has no wheel of the newest Qt; all others are those that were tested."""
    tried: list[list[str]] = []

    def run(_: object, command: Sequence[str], follow: Callable[[str], object]) -> int:
        if "pip" not in command:
            return 0
        tried.append(Path(command[command.index("-c") + 1]).read_text(encoding="utf-8").split())
        if "frustum_extra==1.7" in tried[-1]:
            follow("ERROR: No matching distribution found for frustum-extra==1.7")
        elif "frustum-part==1.7" in tried[-1]:
            follow("    The user requested (constraint) frustum-part==1.7")
            follow("ERROR: ResolutionImpossible: for help visit a page")
        else:
            return 0
        return 1

    monkeypatch.setattr(bootstrap.HeldLock, "run", run)
    tested = "# Tested.\nfrustum_extra==1.7\nfrustum-part==1.7\nfrustum-probe==1.0\n"
    (fresh.root / "constraints.txt").write_text(tested, encoding="utf-8")
    bootstrap.Environment(fresh.root).make()
    assert tried == [
        ["frustum_extra==1.7", "frustum-part==1.7", "frustum-probe==1.0"],
        ["frustum-part==1.7", "frustum-probe==1.0"],
        ["frustum-probe==1.0"],
    ]


def test_wheels_beside_the_code_need_no_network(emptied: Checkout, offline: dict[str, str]) -> None:
    shutil.move(emptied.wheels, emptied.root / bootstrap.WHEELS)
    assert "bringing" in emptied.assert_runs(**offline)


# --- what cannot be helped ------------------------------------------------------------------------


@pytest.fixture
def offline() -> dict[str, str]:
    """The environment with which pip asks a server that does not answer."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        closed = f"http://127.0.0.1:{server.getsockname()[1]}/"
    return {"PIP_INDEX_URL": closed, "PIP_RETRIES": "1"}


def test_without_a_network_a_first_start_is_one_sentence(
    emptied: Checkout, offline: dict[str, str]
) -> None:
    status, output, said = emptied.run("-m", "app", "matrices", **offline)
    assert (status, output) == (3, "")
    assert re.search(
        "no package server could be reached.*run again: python.* -m app matrices$",
        one_sentence(said),
    )
    assert "trying others" not in said  # which would only take as long again


def test_without_a_network_a_working_environment_is_used_under_new_bounds(
    made: Checkout, offline: dict[str, str]
) -> None:
    stamp = made.stamp.read_text(encoding="utf-8")
    made.ask_for(">=2,<3", exactly="2.1")
    status, output, said = made.run("-m", "app", "matrices", **offline)
    assert (status, json.loads(output)[1]) == (0, "1.0")
    *_, why, what = said.splitlines()
    assert "no package server could be reached" in why
    assert what == (
        "frustum-lab: going on with the installed packages, which do not meet frustum-probe>=2,<3"
    )
    assert made.stamp.read_text(encoding="utf-8") == stamp
    # A program that it starts says nothing of it again, and asks no server.
    inside = made.python
    status, output, said = made.run(
        "-c",
        "import subprocess, sys; from app import bootstrap; bootstrap.start('numbers');"
        f"subprocess.run([{inside!r}, '-m', 'app', 'matrices'])",
        **offline,
    )
    assert (status, json.loads(output)[1], said.count("going on")) == (0, "1.0", 1)
    wheel(made.wheels, "frustum_probe", "2.1")
    assert "bringing" in made.assert_runs("2.1")


def test_without_a_network_changed_tested_versions_do_not_matter(
    made: Checkout, offline: dict[str, str]
) -> None:
    made.ask_for(">=1,<2", exactly="1.7")
    status, output, said = made.run("-m", "app", "matrices", **offline)
    assert (status, json.loads(output)[1]) == (0, "1.0")
    assert one_sentence(said) == "frustum-lab: going on with the installed packages"


def test_without_a_network_the_tests_are_refused_and_the_program_still_starts(
    made: Checkout, offline: dict[str, str]
) -> None:
    probe = "from app import bootstrap; bootstrap.start('numbers', ['test'])"
    assert "no package server could be reached" in refused(made, "-c", probe, **offline)
    shutil.rmtree(made.wheels)
    assert made.assert_runs() == ""


def test_a_package_without_a_version_for_this_python_is_named(emptied: Checkout) -> None:
    emptied.ask_for(">=2,<3", exactly="2.1")
    said = refused(emptied)
    assert "No matching distribution found for frustum-probe<3,>=2" in said
    here = f"Python {platform.python_version()}, 64 bits, {platform.machine()},"
    assert said.endswith(f"no version fits {here} on this machine; use another Python")


@pytest.mark.parametrize(
    ("words", "refusal"),
    [
        ("expot a.png", "nearest command is export"),
        ("export", "export takes OUT [FILE], and was given 0 names"),
        ("export a.png --sise=9x9", "the nearest is --size"),
        ("--sise=9x9", "the nearest is --size"),
    ],
)
def test_what_is_typed_is_checked_before_anything_is_set_up(
    words: str, refusal: str, fresh: Checkout
) -> None:
    assert refusal in refused(fresh, "-m", "app", *words.split(), status=2)
    assert not (fresh.root / ".venv").exists()


@pytest.mark.parametrize("step", ["venv", "pip", "writing"])
def test_a_full_disk_is_reported_with_its_folder(
    step: str, fresh: Checkout, monkeypatch: pytest.MonkeyPatch, start_refused: Refusing
) -> None:
    """The messages of pip and venv were copied from a disk of 20 MB."""
    monkeypatch.setattr(bootstrap, "ROOT", fresh.root)
    monkeypatch.setattr(bootstrap, "SPACE_GB", 0)  # at first it seemed to be enough
    monkeypatch.setattr(bootstrap, "missing_system", lambda _: [])
    monkeypatch.setattr(bootstrap, "venv_module", list)

    def run(_: object, command: Sequence[str], follow: Callable[[str], object]) -> int:
        if ("pip" in command) != (step == "pip"):
            return 0
        if step == "writing":
            raise OSError(28, "No space left on device")
        follow("ERROR: Could not install packages due to an OSError: [Errno 28] No space left on")
        return 1

    monkeypatch.setattr(bootstrap.HeldLock, "run", run)
    said = start_refused("numbers")
    assert "too little space is left: free 0 GB beside " in said
    assert str(fresh.root) in said and "TMPDIR" in said


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_a_terminal_has_one_line_that_counts_the_seconds(
    made: Checkout, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stderr", out := Terminal())
    monkeypatch.setattr(held_lock, "TICK_S", 0.01)

    def pip(_: object, _command: object, follow: Callable[[str], object]) -> int:
        follow("Installing collected packages: frustum-extra, frustum-more")
        for _ in range(PATIENCE_MS // 10):
            if out.getvalue().count("\rfrustum-lab:   installing packages: 2, 0 s") > 1:
                break
            threading.Event().wait(0.01)
        return 0

    monkeypatch.setattr(bootstrap.HeldLock, "run", pip)
    made.ask_for(">=0,<2", exactly="1.0")
    bootstrap.Environment(made.root).make()
    *progress, last = out.getvalue().split("\n")[:-1]
    assert len(progress) == 1 and progress[0].count("\r") > 1
    assert last.startswith("frustum-lab: set up in ")


def test_a_package_is_named_once_while_it_is_fetched(
    made: Checkout, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Pip names a package again if it has to inspect it."""
    out = io.StringIO()
    monkeypatch.setattr(sys, "stderr", out)
    wheels = [f"Downloading frustum_{name}-1.0-py3-none-any.whl (1 kB)" for name in "aba"]
    pip_says(monkeypatch, *wheels, status=0)
    made.ask_for(">=0,<2", exactly="1.0")
    bootstrap.Environment(made.root).make()
    assert out.getvalue().count("frustum_a 1.0 (1 kB)") == 1


def test_a_folder_that_cannot_be_written_to_is_one_sentence(fresh: Checkout) -> None:
    (fresh.root / ".venv.lock").mkdir()  # stands in for a read-only folder, which root can write to
    assert "a folder that you may write to" in refused(fresh)


@pytest.mark.parametrize("is_link", [False, True], ids=["file", "link-to-itself"])
def test_an_environment_that_is_no_folder_is_left_alone(fresh: Checkout, is_link: bool) -> None:
    environment = bootstrap.Environment(fresh.root)
    if is_link:
        environment.folder.symlink_to(environment.folder)
    else:  # some programs write there where theirs is
        environment.folder.write_text("elsewhere", encoding="utf-8")
    assert not environment.is_complete() and not environment.is_running()
    with pytest.raises(bootstrap.SetupError, match=r"\.venv is not a folder; rename or remove it"):
        environment.make()
    assert os.path.lexists(environment.folder)


def test_a_lock_that_is_a_pipe_hangs_no_start(fresh: Checkout) -> None:
    os.mkfifo(fresh.root / ".venv.lock")
    with pytest.raises(OSError, match=r"\.venv\.lock"):
        bootstrap.Environment(fresh.root).make()


def test_a_stamp_that_is_no_text_is_not_trusted(fresh: Checkout) -> None:
    environment = bootstrap.Environment(fresh.root)
    environment.folder.mkdir()
    environment.stamp.write_bytes(b"\xff")
    assert not environment.is_complete()


def test_a_python_that_is_too_old_is_refused(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    spec = spec_from_file_location("old", bootstrap.ROOT / "app" / "__init__.py")
    assert spec is not None and spec.loader is not None
    monkeypatch.setattr(sys, "version_info", (3, 9, 2))
    monkeypatch.setattr(sys, "version", "3.9.2 (default, Feb 28 2021)")
    with pytest.raises(SystemExit) as end:
        spec.loader.exec_module(module_from_spec(spec))
    assert end.value.code == 3
    assert "this is Python 3.9.2 (" in capsys.readouterr().err


@pytest.mark.parametrize("file", ["__main__.py", "app/__init__.py"])
def test_every_python_can_read_what_refuses_it(file: str) -> None:
    """RHEL 8 has 3.6 as python3, which knows no future annotations; python may be 2.7."""
    tree = ast.parse((bootstrap.ROOT / file).read_text(encoding="ascii"), feature_version=(3, 4))
    newer = ast.JoinedStr, ast.AnnAssign, ast.FunctionDef
    assert not any(isinstance(node, newer) for node in ast.walk(tree))
    imported = [node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    assert "__future__" not in imported


def test_inside_an_archive_the_program_is_one_sentence(tmp_path: Path) -> None:
    archive = tmp_path / "lab.zip"
    with zipfile.ZipFile(archive, "w") as packed:
        for path in (bootstrap.ROOT / "__main__.py", *(bootstrap.ROOT / "app").glob("*.py")):
            packed.write(path, path.relative_to(bootstrap.ROOT))
    command = [sys.executable, str(archive), "--version"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    said = f"frustum-lab: it cannot run inside an archive; unpack {archive}\n"
    assert (done.returncode, done.stderr) == (3, said)


def test_installed_by_pip_there_is_nothing_to_do(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(bootstrap, "ROOT", tmp_path)
    bootstrap.start("numbers")
    assert list(tmp_path.iterdir()) == []


# --- other systems ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("platform", "length", "is_beside"),
    [("win32", 83, True), ("win32", 84, False), ("linux", 200, True), ("darwin", 200, True)],
)
def test_the_environment_leaves_a_path_that_windows_finds_too_long(
    platform: str,
    length: int,
    is_beside: bool,
    tmp_path: Path,
    own_home: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(tempfile, "TemporaryFile", lambda dir: io.BytesIO())
    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setenv("LOCALAPPDATA", str(own_home / "local"))
    root = Path("/" + "r" * (length - 1))
    folder = bootstrap.Environment(root).folder
    assert folder == (root if is_beside else own_home / "local" / "frustum-lab") / ".venv"


@pytest.mark.parametrize(
    ("platform", "place"),
    [
        ("win32", "AppData/Local"),
        ("darwin", "Library/Application Support"),
        ("linux", ".local/share"),
    ],
)
def test_the_environment_of_a_folder_that_is_read_only_is_the_users(
    platform: str, place: str, own_home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(dir: Path) -> None:
        raise PermissionError(13, "Permission denied", str(dir))

    for name in ("LOCALAPPDATA", "XDG_DATA_HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(tempfile, "TemporaryFile", refuse)
    monkeypatch.setattr(sys, "platform", platform)
    folder = bootstrap.Environment(Path("/read-only")).folder
    assert folder == own_home / place / "frustum-lab" / ".venv"
    for name in ("LOCALAPPDATA", "XDG_DATA_HOME"):  # each start would have a folder of its own
        monkeypatch.setenv(name, "~/data")
    assert bootstrap.Environment(Path("/read-only")).folder == folder
    monkeypatch.setattr(os.path, "expanduser", lambda path: path)  # nobody knows this user
    assert bootstrap.Environment(Path("/read-only")).folder.is_absolute()


@pytest.mark.parametrize(
    ("said", "remedy"),
    [
        ("ERROR: No matching distribution found for vtk<9.8,>=9.7", "32 bits, ARM64, on this mach"),
        (
            "ERROR: [Errno 2] No such file: 'x' [WinError 206] The filename is too long",
            "too long: ",
        ),
        ("ERROR: [WinError 1260] This program is blocked by group policy", "rules forbid programs"),
        ("ERROR: [WinError 5] Access is denied", "close all windows"),
        ("ERROR: [Errno 13] Permission denied: '/opt'", "a folder that you may write to"),
        ("WARNING: Retrying (Retry(total=4)) after connection broken", "check the network"),
        ("ERROR: What nobody has seen yet", r"\(What nobody has seen yet\); .* doctor says more"),
    ],
)
def test_what_helps_depends_on_the_cause(
    said: str, remedy: str, made: Checkout, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("platform.machine", lambda: "ARM64")
    monkeypatch.setattr(sys, "maxsize", 2**31 - 1)
    pip_says(monkeypatch, said)
    made.ask_for(">=0,<2", exactly="1.0")
    with pytest.raises(bootstrap.SetupError, match=remedy) as error:
        bootstrap.Environment(made.root).make()
    assert ("network" in str(error.value)) == ("Retrying" in said)


def test_a_program_that_rules_forbid_is_not_the_networks_fault(
    fresh: Checkout, monkeypatch: pytest.MonkeyPatch, start_refused: Refusing
) -> None:
    def blocked(*_: object) -> int:
        raise OSError(1, "[WinError 1260] This program is blocked by group policy")

    monkeypatch.setattr(bootstrap, "ROOT", fresh.root)
    monkeypatch.setattr(bootstrap.HeldLock, "run", blocked)
    assert "this machine's rules forbid programs in" in start_refused("numbers")


# --- the operating system's part ------------------------------------------------------------------


@pytest.fixture
def programs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A PATH with nothing on it but what the test puts there, on Linux."""
    folder = tmp_path / "bin"
    folder.mkdir()
    monkeypatch.setenv("PATH", str(folder))
    monkeypatch.setattr(sys, "platform", "linux")
    return folder


def program(folder: Path, name: str, script: str = "") -> None:
    if os.name != "posix":
        pytest.skip("needs /bin/sh")
    (folder / name).write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
    (folder / name).chmod(0o755)


LIBRARY = system_packages.System("libfrustum-probe.so.7", "libfrustum-probe7")
TOOL = system_packages.System("frustum-tool", "frustum-tools frustum-tools-data")


@pytest.fixture
def lacking(monkeypatch: pytest.MonkeyPatch) -> None:
    """A machine that lacks a library and a program."""
    monkeypatch.setattr(system_packages, "SYSTEM", (LIBRARY, TOOL))


@pytest.mark.parametrize("root", ["sudo sh -c", "su - -c"])
@pytest.mark.usefixtures("lacking")
def test_an_ordinary_user_is_told_the_one_command(
    root: str, programs: Path, monkeypatch: pytest.MonkeyPatch, start_refused: Refusing
) -> None:
    program(programs, "apt-get", "exit 99")
    program(programs, root.partition(" ")[0])
    monkeypatch.setattr(os, "geteuid", lambda: 1000)
    assert start_refused("window", ["test"]) == (
        f"frustum-lab: this system lacks libfrustum-probe.so.7, frustum-tool; run: {root} 'apt-get "
        "update; apt-get install -y --no-install-recommends libfrustum-probe7 frustum-tools "
        "frustum-tools-data'"
    )


def test_one_command_brings_what_app_export_and_tests_lack(
    programs: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program(programs, "apt-get")
    for kind in {type(item) for item in system_packages.SYSTEM}:
        monkeypatch.setattr(kind, "is_here", lambda _: False)
    words = (
        system_packages.advice(system_packages.missing_system("picture")).replace("'", "").split()
    )
    named = {name for item in system_packages.SYSTEM for name in item.packages.split()}
    assert {"xauth", "xvfb", "libgssapi-krb5-2", "fonts-dejavu-core"} < named <= set(words)


def test_a_missing_font_is_reported(
    tmp_path: Path, programs: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A new process is needed, whose fontconfig has read nothing yet."""
    program(programs, "apt-get")
    empty = tmp_path / "fonts.conf"
    empty.write_text(f"<fontconfig><cachedir>{tmp_path}</cachedir></fontconfig>", encoding="utf-8")
    probe = "from app import system_packages as s; print(s.advice(s.missing_system('window')))"
    done = subprocess.run(
        [sys.executable, "-c", probe],
        cwd=bootstrap.ROOT,
        env={**os.environ, "FONTCONFIG_FILE": str(empty)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.startswith("this system lacks a font; run: ")
    assert "fonts-dejavu-core" in done.stdout


@pytest.mark.usefixtures("lacking")
def test_without_apt_the_missing_libraries_are_named(
    programs: Path, monkeypatch: pytest.MonkeyPatch, start_refused: Refusing
) -> None:
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    said = start_refused("window", ["test"])
    assert "lacks libfrustum-probe.so.7, frustum-tool; install" in said


def test_root_installs_what_is_missing_and_says_so(
    programs: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    log, tool = programs.parent / "log", programs / "frustum-tool"
    program(
        programs,
        "apt-get",
        f'echo "$*" >> {log}\n[ "$1" = install ] || exit 1\n'
        f"echo '#!/bin/sh' > {tool}; /bin/chmod 755 {tool}",
    )
    monkeypatch.setattr(system_packages, "SYSTEM", (TOOL,))
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    bootstrap.start("window", ["test"])
    assert log.read_text(encoding="utf-8").splitlines() == [
        "update",  # which failed, and was no reason to stop
        "install -y --no-install-recommends frustum-tools frustum-tools-data",
    ]
    said = "frustum-lab: installing system packages: frustum-tools frustum-tools-data\n"
    assert capsys.readouterr().err == said


@pytest.mark.parametrize("script", ["echo 'E: No space left' >&2; exit 100", ""])
@pytest.mark.usefixtures("lacking")
def test_an_installation_that_fails_or_brings_nothing_is_one_sentence(
    script: str, programs: Path, monkeypatch: pytest.MonkeyPatch, start_refused: Refusing
) -> None:
    program(programs, "apt-get", script)
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    said = start_refused("window", ["test"])
    assert ("No space left" in said) == bool(script)
    assert "apt-get install -y --no-install-recommends libfrustum-probe7" in said


def test_each_need_asks_for_no_more_than_it_uses(programs: Path) -> None:
    with pytest.MonkeyPatch.context() as patch:
        for kind in {type(item) for item in system_packages.SYSTEM}:
            patch.setattr(kind, "is_here", lambda _: False)
        numbers, picture, window, tests = (
            {item.name for item in system_packages.missing_system(need)}
            for need in ("numbers", "picture", "window", "tests")
        )
        patch.setattr(sys, "platform", "darwin")
        assert system_packages.missing_system("tests") == []
    assert numbers == set()
    assert picture < window < tests
    assert {"libGL.so.1", "libEGL.so.1"} <= picture
    assert tests - window == {"Xvfb", "libgssapi_krb5.so.2"}


def test_a_library_is_here_when_the_loader_finds_it() -> None:
    assert replace(LIBRARY, name="libc.so.6").is_here()
    assert not LIBRARY.is_here()


@pytest.mark.parametrize(
    ("need", "commands"),
    [
        ("window", ["", "letter.json", "--reset"]),
        ("numbers", ["project points.csv", "matrices"]),
        ("picture", ["export out.png letter.json"]),
    ],
)
def test_a_command_needs_no_more_than_it_uses(need: str, commands: list[str]) -> None:
    assert {need_of(command.split()) for command in commands} == {need}


@pytest.mark.parametrize(
    ("platform", "command"),
    [
        ("linux", r"'C:\My Lab\python.exe' -m pip install 'vtk>=9.7,<9.8' --set a=b"),
        ("win32", r""""C:\My Lab\python.exe" -m pip install "vtk>=9.7,<9.8" --set a=b"""),
    ],
)
def test_a_command_is_quoted_as_the_shell_there_takes_it(
    platform: str, command: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "platform", platform)
    words = [r"C:\My Lab\python.exe", "-m", "pip", "install", "vtk>=9.7,<9.8", "--set", "a=b"]
    assert bootstrap.command_line(words) == command


def test_permanent_imports_are_exempt_from_garbage_collection() -> None:
    class Imported:
        """Made while others are imported."""

    with pytest.raises(ImportError), python_packages.for_good():
        assert not gc.isenabled()
        imported = Imported()
        raise ImportError
    assert gc.isenabled()
    assert not any(found is imported for found in gc.get_objects())  # but for those frozen


# --- requirements ---------------------------------------------------------------------------------


VERSIONS = (
    "9 0.16.9 0.17 0.17.5 0.18 2.4.6 2.5.0 6.8 6.11.3 6.12.0 6.13 7.2.2 9.2.0 9.7.2 9.8.0"
    " 9.7.2.post1 10.0 2.4.10"
)


@pytest.mark.parametrize("extras", [(), ("test",)])
def test_requirements_are_read_as_the_standard_says(extras: tuple[str, ...]) -> None:
    for requirement in requirements(bootstrap.ROOT, extras):
        standard = Standard(requirement.text)
        assert requirement.name == standard.name
        assert standard.marker is None or standard.marker.evaluate()
        for version in VERSIONS.split():
            assert requirement.admits(version) == standard.specifier.contains(version)


@pytest.mark.parametrize("python", ["3.11", "3.14"])
def test_every_requirement_for_a_python_is_read_and_no_other(
    python: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    project = tomllib.loads((bootstrap.ROOT / "pyproject.toml").read_text(encoding="utf-8"))[
        "project"
    ]
    wanted = [
        text.partition(";")[0]
        for text in project["dependencies"]
        if ";" not in text or Marker(text.partition(";")[2]).evaluate({"python_version": python})
    ]
    monkeypatch.setattr(sys, "version_info", tuple(map(int, python.split("."))))
    assert [found.text for found in requirements(bootstrap.ROOT)] == wanted


def test_every_dependency_has_a_lower_and_an_upper_bound() -> None:
    for requirement in requirements(bootstrap.ROOT, ["test"]):
        assert [operator for operator, _ in requirement.bounds] == [">=", "<"]


def test_the_tested_versions_are_within_the_bounds() -> None:
    lines = (bootstrap.ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()
    pins = [Standard(line) for line in lines if not line.startswith("#")]
    tested = {
        pin.name.lower().replace("_", "-"): str(pin.specifier).removeprefix("==")
        for pin in pins
        if pin.marker is None or pin.marker.evaluate()
    }
    for requirement in requirements(bootstrap.ROOT, ["test"]):
        assert requirement.admits(tested[requirement.name.lower()])


@pytest.mark.parametrize(
    "name, crashed_or_was_wrong",
    [
        ("numpy", "2.2.1"),
        ("matplotlib", "3.11.0"),
        ("mapbox-earcut", "2.0.0"),
        ("PySide6-Essentials", "6.11.1"),
    ],
)
def test_a_version_with_which_tests_failed_is_outside(name: str, crashed_or_was_wrong: str) -> None:
    (requirement,) = (each for each in requirements(bootstrap.ROOT) if each.name == name)
    assert not requirement.admits(crashed_or_was_wrong)


def test_a_version_outside_the_bounds_does_not_pass_for_installed() -> None:
    (fits,) = (r for r in requirements(bootstrap.ROOT) if r.name == "numpy")
    too_new = replace(fits, bounds=((">=", (99,)),))
    assert unmet([fits, too_new]) == [too_new]


# --- the virtual screen ---------------------------------------------------------------------------


@pytest.mark.parametrize("end", ["pass", "raise SystemExit(0)"])
def test_the_tests_bring_a_screen_and_take_it_away(end: str, tmp_path: Path) -> None:
    """Whatever a person's is. A new process is needed because of ``preexec_fn``."""
    probe = (
        "import os\n"
        "from tests.__main__ import screens\n"
        "with screens(2) as environment:\n"
        "    print(*{'WAYLAND_DISPLAY', 'QT_SCALE_FACTOR', 'LC_ALL'} & environment.keys(),\n"
        "          environment['QT_QPA_PLATFORM'], environment['TEST_DISPLAYS'], flush=True)\n"
        "    assert environment['TEST_DISPLAYS'].startswith(environment['DISPLAY'])\n"
        "    assert os.path.exists(environment['FONTCONFIG_FILE'])\n"
        f"    {end}\n"
    )
    persons = {"DISPLAY": ":9999", "WAYLAND_DISPLAY": "wayland-9", "QT_SCALE_FACTOR": "2"}
    done = subprocess.run(
        [sys.executable, "-c", probe],
        cwd=bootstrap.ROOT,
        env=os.environ | persons | {"LC_ALL": "de_DE.UTF-8"},
        capture_output=True,
        text=True,
        check=True,
    )
    *left, platform, one, other = done.stdout.split()
    displays = one, other
    assert platform == "xcb" and one != other and left == []
    for display in displays:
        number = display.removeprefix(":")
        assert int(number) >= 0
        assert not Path(f"/tmp/.X11-unix/X{number}").exists()
