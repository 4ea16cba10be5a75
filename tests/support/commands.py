"""The command line as a user types it: in a process of its own, or quicker in this one."""

import contextlib
import io
import os
import struct
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

from app.bootstrap import ROOT
from app.commands import cli
from app.commands.arguments import check_drawing
from app.document.document import Document
from app.document.files import write
from app.drawings import off_screen
from app.model.projection import Projection
from tests import PATIENCE_S


def run(
    *arguments: str | Path, text: str | bytes = b"", **environment: str | None
) -> subprocess.CompletedProcess[str]:
    """Run the program; an environment variable that is None is not set."""
    variables = {**os.environ, **environment}
    done = subprocess.run(
        [sys.executable, "-m", "app", *map(str, arguments)],
        cwd=ROOT,
        env={name: value for name, value in variables.items() if value is not None},
        input=text.encode() if isinstance(text, str) else text,
        capture_output=True,
        check=False,
        timeout=PATIENCE_S,
    )
    return subprocess.CompletedProcess(
        done.args, done.returncode, done.stdout.decode(), done.stderr.decode()
    )


def run_here(*arguments: str | Path, text: str | bytes = b"") -> subprocess.CompletedProcess[str]:
    """The same in this process, but for windows: a new one takes half a second to come to it."""
    typed, out, said = (io.TextIOWrapper(io.BytesIO(), encoding="utf-8") for _ in range(3))
    typed.buffer.write(text.encode() if isinstance(text, str) else text)
    typed.seek(0)
    with (
        pytest.MonkeyPatch.context() as patch,
        contextlib.redirect_stdout(out),
        contextlib.redirect_stderr(said),
    ):
        patch.chdir(ROOT)
        patch.setattr(sys, "stdin", typed)
        status = cli.main([str(argument) for argument in arguments])
    for stream in (out, said):
        stream.seek(0)
    return subprocess.CompletedProcess(arguments, status, out.read(), said.read())


def told_matrices(projection: Projection, form: str) -> str:
    """What the command ``matrices`` says of a projection, in one of its formats."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "document.json"
        write(Document("letter-f", projection), path)
        done = run_here("matrices", path, "--format", form)
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def one_sentence(done: subprocess.CompletedProcess[str], status: int) -> str:
    """What was refused, and nothing else, in one sentence that says why."""
    assert done.returncode == status, done
    assert done.stdout == ""
    assert done.stderr.endswith((".\n", "?\n")) and done.stderr.count("\n") == 1, done.stderr
    return done.stderr


def refused_by_a_process(*arguments: str | Path, status: int = 2) -> str:
    """Run what must be refused, and return the one sentence that says why."""
    return one_sentence(run(*arguments), status)


def refused(*arguments: str | Path, text: str | bytes = b"", status: int = 2) -> str:
    """The same in this process, on a bare machine: what is typed is checked before the machine."""
    with bare_machine():
        return one_sentence(run_here(*arguments, text=text), status)


@contextlib.contextmanager
def bare_machine() -> Iterator[None]:
    """Let this machine have no programs and no OpenGL."""

    def check_off_screen() -> None:
        raise RuntimeError("There is no OpenGL.")

    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PATH", "")
        patch.setattr(off_screen, "check_off_screen", check_off_screen)
        check_drawing.cache_clear()
        yield


@pytest.fixture(scope="session")
def comma_locale(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """The environment of a locale that writes 0,5: a file for glibc, as a bare machine has none."""
    folder = tmp_path_factory.mktemp("locale")
    (folder / "xx_XX").mkdir()
    # Where the signs begin, the digits of a group, the signs as numbers, and the character set.
    begin = struct.pack("=8I", 0x20031114, 6, 32, 34, 36, 40, 44, 48)
    signs = b",\0.\0" + b"\3\3\0\0" + struct.pack("=2I", *b",.") + b"ASCII\0"
    (folder / "xx_XX" / "LC_NUMERIC").write_bytes(begin + signs)
    return {"LOCPATH": str(folder), "LC_NUMERIC": "xx_XX", "PYTHONUTF8": "1"}
