"""``python3 -m tests.fuzz TOOL``: what takes longer than the suite may.

| tool | does |
|---|---|
| `golden record FOLDER`, `golden compare FOLDER` | compares all outputs before and after a change |
| `hostile` | opens damaged files with the command line, and with ``--window`` in a window |
| `regexes` | measures every regular expression on long texts of its own characters |
| `documents` | looks for silent NaNs in random documents |
| `cheap` | compares the bounds of cheap arithmetic with its errors, in random documents |
| `bounds` | compares the bounds of the trades with their errors, in a million random cases each |
| `drift` | compares the bounds of turned cameras with their errors, about random axes |
| `jitter` | compares the bounds of jumps far from the origin with their errors |
| `variants` | draws the variants of all exercises, and types right and wrong answers |
| `hands` | uses the window as a restless person does, and looks for errors, leaks and long steps |

Each has ``--help``.
"""

import os
import sys
from importlib import import_module

from app import bootstrap
from tests.support.tools import ToolParser

TOOLS = (
    "golden", "hostile", "documents", "cheap", "bounds", "drift", "jitter", "variants", "hands",
    "regexes",
)  # fmt: skip


def main(words: list[str]) -> int:
    parser = ToolParser("fuzz", __doc__)
    parser.add_argument("tool", choices=TOOLS)
    tool = parser.parse_args(words[:1]).tool
    bootstrap.start("tests", extras=("test",))
    os.environ["OPENBLAS_NUM_THREADS"] = "1"  # before numpy: a fork takes no threads along
    return int(import_module(f"tests.fuzz.{tool}").main(words[1:]))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
