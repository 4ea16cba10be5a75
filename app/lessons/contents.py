"""The lessons and talks that come with the program, and their names: standard library only."""

import os
from pathlib import Path

CONTENT = Path(__file__).with_name("content")  # the program's lessons, talks and wrong ideas


def contained() -> tuple[Path, ...]:
    """Return the files of the lessons and talks that come with the program, in order."""
    return tuple(sorted(path for path in CONTENT.glob("*.md") if path.name != "ideas.md"))


def file_of(name: str) -> str:
    """Return the file of a path, or of a lesson's or a talk's own name: ``talk-001.md``, ``L5``."""
    path = Path(name)
    if os.path.lexists(name) or path.parent != Path():
        return name
    stem = path.stem.lower()
    names = stem, f"talk-{stem}"
    for own in contained():
        number = own.stem.partition("-")[0].replace("l0", "l")
        if own.stem in names or number == stem:
            return str(own)
    return name
