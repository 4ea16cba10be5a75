"""``python3 -m tests.wheels``: ask pip which tested versions have no wheel for a platform.

It takes minutes and a network. The README says what is missing.
"""

if __name__ == "__main__":  # before anything is imported that it installs
    from app import bootstrap

    bootstrap.start("tests", extras=("test",))

import re
import subprocess
import sys
import tempfile
from collections.abc import Sequence

from app import bootstrap
from app.commands.bundle import target_words
from app.commands.options import choices
from app.python_packages import pins
from tests.support.tools import ToolParser

PYTHONS = ("3.11", "3.12", "3.13", "3.14", "3.15")


def missing(platform: str, python: str) -> list[str]:
    """Return the tested versions that pip cannot have for a platform."""
    wanted, lacking = pins(bootstrap.ROOT, python), []
    with tempfile.TemporaryDirectory() as target:
        words = ["install", "--dry-run", "--quiet", "--no-deps", "--ignore-installed"]
        words.append("--ignore-requires-python")  # pip would ask it of this Python
        words += ["--target", target, *target_words(platform, python)]
        while wanted:
            command = [sys.executable, "-m", "pip", *words, *wanted]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode == 0:
                break
            named = re.search(r"No matching distribution found for (\S+)", done.stderr)
            if named is None or named[1] not in wanted:
                return [done.stderr.strip().splitlines()[-1]]
            lacking.append(named[1])
            wanted.remove(named[1])
    return lacking


def main(words: Sequence[str]) -> int:
    ToolParser("wheels", __doc__).parse_args(words)
    status = 0
    for python in PYTHONS:
        for platform in choices("bundle", "--platform"):
            lacking = missing(platform, python)
            status |= bool(lacking)
            print(f"Python {python}, {platform}: {', '.join(lacking) or 'all'}", flush=True)
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
