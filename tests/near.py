"""``python3 -m tests.near``: the modules that one step of the near slider visits.

A step that visits many modules is hard to follow and slow. ``sys.setprofile`` counts the calls from
the key press to the last repaint, in the window with the letter F.
"""

import argparse
import collections
import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from types import FrameType
from typing import Any

from app import bootstrap
from tests.__main__ import at_home
from tests.support.tools import ToolParser


def main(words: Sequence[str]) -> int:
    """Set up as the tests do, and count inside a screen."""
    parser = ToolParser("near", __doc__)
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    if parser.parse_args(words).inside:
        _count()
        return 0
    with at_home() as environment:
        command = [sys.executable, "-m", "tests.near", "--inside"]
        return subprocess.run(command, env=environment, cwd=bootstrap.ROOT, check=False).returncode


def _count() -> None:
    from PySide6.QtCore import Qt
    from PySide6.QtTest import QTest
    from PySide6.QtWidgets import QSlider

    from tests.benchmark import application, open_window, settle

    window = open_window()
    app = application()
    (slider,) = (s for s in window.findChildren(QSlider) if s.accessibleName() == "Near, slider")
    slider.setFocus()
    for _ in range(3):  # what is only made once is made
        QTest.keyClick(slider, Qt.Key.Key_Right)
        settle(app)
    calls: collections.Counter[str] = collections.Counter()
    changes = [0]
    last = [""]
    root = str(bootstrap.ROOT) + os.sep

    def enter(frame: FrameType, event: str, _argument: Any) -> None:
        name = frame.f_code.co_filename
        if event != "call" or not name.startswith(root):
            return
        module = Path(name).relative_to(bootstrap.ROOT).as_posix()
        if not module.startswith(("app/", "widgets/")):
            return
        calls[module] += 1
        changes[0] += module != last[0]
        last[0] = module

    sys.setprofile(enter)
    try:
        QTest.keyClick(slider, Qt.Key.Key_Right)
        settle(app)
    finally:
        sys.setprofile(None)
    for module, count in calls.most_common():
        print(f"{count:6} {module}")
    print(f"{len(calls)} modules, {sum(calls.values())} calls, {changes[0]} changes of module")
    window.store.mark_saved()
    window.close()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
