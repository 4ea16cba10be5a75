"""ruff and mypy, as tests like all others: one command, one verdict."""

from __future__ import annotations

import subprocess
import sys

from app.bootstrap import ROOT


def report(*command: str) -> str:
    """Run a tool on the whole program; what it complains about, empty when it is content."""
    done = subprocess.run(
        [sys.executable, "-m", *command], cwd=ROOT, capture_output=True, text=True, check=False
    )
    return "" if done.returncode == 0 else done.stdout + done.stderr


def test_ruff_is_content() -> None:
    assert report("ruff", "check", "--output-format", "concise", ".") == ""


def test_mypy_is_content_with_strict_types() -> None:
    assert report("mypy") == ""
