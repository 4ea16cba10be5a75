"""Measure all scenes by the rules of composition: ``python3 -m tests.composition [SCENE...]``.

Each pane is drawn as it opens in windows of three sizes, light and dark. A line for each fault,
then the sums; the exit status is 1 if there is a fault. `tests/drawings/test_composition.py`
takes a sample.
"""

if __name__ == "__main__":  # before anything is imported that it installs
    from app import bootstrap

    bootstrap.start("tests", extras=("test",))

import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import product

from app.commands.composed import PANE_EM_PX, faults_in
from app.document.document import Document
from app.drawings.composition import ComposedPicture, measured
from app.drawings.style import DARK, LIGHT
from app.model.refusal import counted
from app.scenes.scene import BUILT_IN, load
from tests.support.tools import ToolParser, one_of

WINDOWS = {
    "1366x768": {"large": (584, 680), "small": (480, 300)},
    "1920x1080": {"large": (1000, 830), "small": (640, 460)},
    "Present": {"large": (1480, 910), "small": (640, 460)},
}
"""The sizes of the panes in a window with its dock, as the window opens, and of one pane alone."""
STYLES = {"light": LIGHT, "dark": DARK}


def pictures(scene: str, window: str, style: str) -> Iterator[tuple[str, ComposedPicture]]:
    """Measure the panes of a scene as they open in a window."""
    found = load(scene)
    document = Document(scene, found.start)
    for pane in ("world", "ndc", "image"):
        size = WINDOWS[window]["large" if pane == found.leading else "small"]
        for each in measured(document, found, pane, size, PANE_EM_PX, STYLES[style]):
            yield pane, each


def main(words: Sequence[str]) -> int:
    parser = ToolParser("composition", __doc__)
    parser.add_argument("scene", nargs="*", type=one_of(BUILT_IN, "scene"))
    scenes = parser.parse_args(words).scene
    sums, count = Counter[str](), 0
    for scene, window, style in product(scenes or BUILT_IN, WINDOWS, STYLES):
        for pane, each in pictures(scene, window, style):
            count += 1
            faults = list(faults_in(each, None))
            sums.update({kind for kind, _ in faults})
            for _, text in faults:
                print(f"{scene}, {pane}, {window}, {style}: {text}")
    print(
        f"{counted(sums['overlap'], 'overlap')}, {sums['crowded']} crowded, {sums['empty']} empty,"
        f" {sums['hidden']} hidden, {sums['cut']} cut of {counted(count, 'picture')}"
    )
    return 1 if sums else 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
