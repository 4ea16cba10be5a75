"""The command ``bundle``: a folder to carry to machines without a network or an administrator.

PyInstaller makes the program with its own Python, for machines like this one; ``frustum-lab.spec``
says of what. With ``--wheels`` pip collects the packages, for machines that have Python.
"""

import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from app import bootstrap, modules
from app.commands.options import parser_of
from app.commands.terminal import CliError, write_out
from app.python_packages import requirements


def run(arguments: Sequence[str]) -> int:
    """The command ``bundle``."""
    _options, (out,) = parser_of("bundle").read(arguments)
    if not os.path.exists(bootstrap.ROOT / "pyproject.toml"):
        raise CliError("bundle: this program has no folder of its code to make one of.")
    folder = Path(out).absolute()
    _freeze(folder)
    return 0


def _freeze(out: Path) -> None:
    """Make the program and its archive."""
    if importlib.util.find_spec("PyInstaller") is None:
        needed = requirements(bootstrap.ROOT, ["bundle"])[-1]
        command = bootstrap.command_line([sys.executable, "-m", "pip", "install", needed.text])
        raise CliError(f"bundle needs PyInstaller, which is not installed: {command}")
    spec = str(bootstrap.ROOT / "frustum-lab.spec")
    with tempfile.TemporaryDirectory() as work:
        words = ["--noconfirm", "--log-level", "WARN", "--distpath", str(out), "--workpath", work]
        done = subprocess.run(modules.command("PyInstaller", *words, spec), check=False)
    if done.returncode:
        raise CliError(f"PyInstaller ended with status {done.returncode}.")
    made = out / "frustum-lab"
    kind = "zip" if sys.platform == "win32" else "gztar"
    archive = Path(shutil.make_archive(str(made), kind, out, made.name))
    size = sum(path.lstat().st_size for path in made.rglob("*"))
    for path, octets in ((made, size), (archive, archive.stat().st_size)):
        write_out([f"{path}: {octets / 1e6:.0f} MB\n"])
