"""``python3 -m app``, and the ``frustum-lab`` command: first the set-up, then the command line."""

from __future__ import annotations

import sys
from collections.abc import Sequence

TYPE_CHECKING = False
"""What `typing` has of that name, whose import Ctrl-C would find time to interrupt."""
if TYPE_CHECKING:
    from app import bootstrap

#: What each command asks of the machine; a command that is not named here opens the window.
NEEDS: dict[str, bootstrap.Need] = {
    "project": "numbers",
    "matrices": "numbers",
    "doctor": "numbers",  # it reports what is missing, so it must start without it
    "export": "picture",
    "measure": "picture",
}


def need_of(arguments: Sequence[str]) -> bootstrap.Need:
    """Return what the command line asks of the machine."""
    if {"-h", "--help", "--version"}.intersection(arguments):
        return "numbers"
    return next((NEEDS.get(word, "window") for word in arguments if word[:1] != "-"), "window")


def main() -> int:
    """Set up, run the command line, return its exit status."""
    try:  # from the first import on: Ctrl-C is no error
        from app import bootstrap

        bootstrap.start(need_of(sys.argv[1:]))
        from app.cli import main as run  # only now are its imports sure to be there
    except KeyboardInterrupt:
        return 130
    return run(sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
