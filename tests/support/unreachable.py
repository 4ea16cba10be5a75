"""Files that the system refuses to look for, also for root."""

import errno
import os
from pathlib import Path
from typing import Any

import pytest

LONG = "x" * 300


def unreachable(folder: Path, ending: str, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Return paths with an ending: too long, through a file, a link to itself, in a closed folder.

    Root may enter every folder, so the system's answer to the last one is given here.
    """
    (folder / "file").write_text("in the way", encoding="utf-8")
    (folder / f"loop{ending}").symlink_to(f"loop{ending}")
    stat, closed = os.stat, str(folder / "closed")

    def refused(path: Any, *more: Any, **options: Any) -> os.stat_result:
        if str(path).startswith(closed):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), path)
        return stat(path, *more, **options)

    monkeypatch.setattr(os, "stat", refused)
    names = LONG, f"{LONG}/a", "file/a", "loop", "closed/a"
    return [str(folder / f"{name}{ending}") for name in names]
