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
from app.commands.options import Parser, choices
from app.commands.terminal import CliError, write_out
from app.python_packages import pins, requirements

NEWEST_GLIBC = 40
"""Wheels for Linux name the oldest glibc that they work with, 2.5 to this one."""
OLDEST_MACOS = 14  # the oldest for which Qt and NumPy have their newest wheels
CODE = ("__main__.py", "pyproject.toml", "constraints.txt", "LICENSE", "README.md")
"""What belongs to the code beside its packages."""


def run(arguments: Sequence[str]) -> int:
    options, (out,) = Parser("bundle").read(arguments)
    if not os.path.exists(bootstrap.ROOT / "pyproject.toml"):
        raise CliError("bundle: this program has no folder of its code to make one of.")
    folder = Path(out).absolute() / "frustum-lab"
    if os.path.exists(folder):
        raise CliError("{0}: is there already; remove it, or choose another folder.", folder)
    if options.wheels:
        _collect(folder, options.platform or choices("bundle", "--platform"), options.python)
    else:
        _freeze(folder)
    kind = "zip" if sys.platform == "win32" else "gztar"
    archive = Path(shutil.make_archive(str(folder), kind, folder.parent, folder.name))
    size = sum(path.lstat().st_size for path in folder.rglob("*"))
    for path, octets in ((folder, size), (archive, archive.stat().st_size)):
        write_out([f"{path}: {octets / 1e6:.0f} MB\n"])
    return 0


def _freeze(folder: Path) -> None:
    if importlib.util.find_spec("PyInstaller") is None:
        command = bootstrap.pip_install(requirements(bootstrap.ROOT, ["bundle"])[-1].text)
        raise CliError("bundle needs PyInstaller, which is not installed; run: {0}", command)
    with tempfile.TemporaryDirectory() as work:
        words = ["--log-level", "WARN", "--distpath", str(folder.parent), "--workpath", work]
        spec = str(bootstrap.ROOT / "frustum-lab.spec")
        done = subprocess.run(modules.command("PyInstaller", *words, spec), check=False)
    if done.returncode:
        raise CliError("PyInstaller ended with status {0}.", done.returncode)


def _collect(folder: Path, platforms: Sequence[str], pythons: Sequence[str]) -> None:
    """Copy the code, and put the wheels beside it, where `app.bootstrap` looks for them."""
    for package in modules.PACKAGES:
        without = shutil.ignore_patterns("__pycache__")
        shutil.copytree(bootstrap.ROOT / package, folder / package, ignore=without)
    for name in CODE:
        shutil.copy(bootstrap.ROOT / name, folder)
    for python in pythons or [".".join(map(str, sys.version_info[:2]))]:
        wanted = [each.text for each in requirements(bootstrap.ROOT, python=python)]
        tested = folder / "tested.txt"
        tested.write_text("\n".join(pins(bootstrap.ROOT, python)), encoding="utf-8")
        for platform in platforms:
            write_out([f"{platform}, Python {python}\n"])
            words = ["download", "--quiet", "--dest", str(folder / bootstrap.WHEELS)]
            words += [*target_words(platform, python), "-c", str(tested), *wanted]
            if subprocess.run([sys.executable, "-m", "pip", *words], check=False).returncode:
                raise CliError("no-packages", platform, python)
        tested.unlink()


def target_words(platform: str, python: str) -> list[str]:
    """Return pip's options for wheels of another machine."""
    system, machine = platform.split("-")
    if system == "linux":
        machine = machine.replace("arm64", "aarch64")
        tags = [f"manylinux_2_{minor}_{machine}" for minor in range(5, NEWEST_GLIBC)]
        tags.append(f"manylinux2014_{machine}")
    else:
        tags = [f"macosx_{OLDEST_MACOS}_0_{machine}" if system == "macos" else "win_amd64"]
    words = ["--only-binary", ":all:", "--python-version", python]
    return words + [word for tag in tags for word in ("--platform", tag)]
