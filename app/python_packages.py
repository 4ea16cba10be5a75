"""The packages that ``pyproject.toml`` asks for, and whether this Python has them.

It imports the standard library only, like `app.bootstrap`, which installs them.
"""

from __future__ import annotations

import contextlib
import gc
import importlib.util
import operator
import os
import re
import sys
import tomllib
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

#: Distributions whose import name differs from their own name.
_IMPORT_NAME = {
    "markdown-it-py": "markdown_it",
    "pillow": "PIL",
    "vtk": "vtkmodules",
    "pyside6-essentials": "PySide6",
    "pytest-qt": "pytestqt",
    "pytest-xdist": "xdist",
}
_HOLDS = {">=": operator.ge, "<": operator.lt, "==": operator.eq}
Bounds = tuple[tuple[str, tuple[int, ...]], ...]


@dataclass(frozen=True)
class Requirement:
    """One line of ``pyproject.toml``: a distribution and the half-open range of its version."""

    text: str
    name: str
    bounds: Bounds

    def admits(self, version: str) -> bool:
        """Whether a version such as ``"6.11.3"`` lies within all bounds."""
        return _within(_release(version), self.bounds)

    @property
    def import_name(self) -> str:
        name = self.name.lower()
        return _IMPORT_NAME.get(name, name.replace("-", "_"))

    def is_importable(self) -> bool:
        """Whether its module can be found, without importing it: importing VTK takes a second."""
        spec = importlib.util.find_spec(self.import_name)
        # The folder of an uninstalled package may also be found, but it has no file.
        return spec is not None and spec.origin is not None

    def is_met(self) -> bool:
        """Whether this interpreter has it, by version and by import name."""
        from importlib import metadata

        try:
            installed = metadata.distribution(self.name)
        except metadata.PackageNotFoundError:
            return False
        if not self.admits(installed.version) or not self.is_importable():
            return False
        # Another folder, which a .pth file puts first for example, may hide it.
        own = os.path.realpath(str(installed.locate_file(self.import_name))) + os.sep
        spec = importlib.util.find_spec(self.import_name)
        assert spec is not None and spec.origin is not None
        return not os.path.exists(own) or os.path.realpath(spec.origin).startswith(own)


def _release(version: str) -> tuple[int, ...]:
    """Return the numbers of a version, without trailing zeros: 6.12 and 6.12.0 are equal."""
    match = re.match(r"\d+(\.\d+)*", version)
    numbers = [int(part) for part in match[0].split(".")] if match else []
    while numbers and numbers[-1] == 0:
        numbers.pop()
    return tuple(numbers)


def _bounds(text: str) -> Bounds:
    """Return the bounds in ``numpy>=2.2,<2.5`` and in ``python_version < '3.12'``."""
    pairs = re.findall(r"(>=|<|==)\s*['\"]?([\d.]+)", text)
    return tuple((sign, _release(version)) for sign, version in pairs)


def _within(version: tuple[int, ...], bounds: Bounds) -> bool:
    return all(_HOLDS[sign](version, bound) for sign, bound in bounds)


def requirements(root: Path, extras: Sequence[str] = (), python: str = "") -> list[Requirement]:
    """Return the requirements in ``pyproject.toml`` with these optional groups.

    They are for this Python, or for another one such as ``"3.12"``.
    """
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    texts = list(project["dependencies"])
    for extra in extras:
        texts += project["optional-dependencies"][extra]
    return [
        Requirement(asked, re.split(r"[^\w.-]", asked)[0], _bounds(asked))
        for asked in _for(texts, python)
    ]


def pins(root: Path, python: str = "") -> list[str]:
    """Return the tested versions in ``constraints.txt``, for this Python or another one."""
    lines = (root / "constraints.txt").read_text(encoding="utf-8").splitlines()
    return _for((line for line in lines if not line.startswith("#")), python)


def _for(texts: Iterable[str], python: str) -> list[str]:
    """Return what has no marker or fits it, without markers."""
    version = _release(python or f"{sys.version_info[0]}.{sys.version_info[1]}")
    parts = (text.partition(";") for text in texts)
    return [asked.strip() for asked, _, marker in parts if _within(version, _bounds(marker))]


def unmet(wanted: Iterable[Requirement]) -> list[Requirement]:
    return [each for each in wanted if not each.is_met()]


def are_importable(wanted: Iterable[Requirement]) -> bool:
    return all(each.is_importable() for each in wanted)


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
