"""``python3 -m tests.benchmark``: what the window costs, as ratios and counts taken in one run.

Timing is never a test: these machines, and yours, are shared and noisy. Every figure that is a
time is a ratio of two things done in turn in the same process. ``--json FILE`` keeps the figures.
"""

from __future__ import annotations

import argparse
import gc
import json
import math
import os
import random
import statistics
import subprocess
import sys
import tempfile
import time
import weakref
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from app import bootstrap

VERTICES = (100, 10_000, 1_000_000)
PANES = ("world", "ndc", "image")


def main() -> int:
    """Set up as the tests do, and run inside a screen."""
    parser = argparse.ArgumentParser(prog="python3 -m tests.benchmark", description=__doc__)
    parser.add_argument("--json", metavar="FILE", help="write the figures to a file as well")
    parser.add_argument("--only", choices=sorted(PARTS), help="run one part only")
    parser.add_argument("--quick", action="store_true", help="a tenth of the repetitions")
    parser.add_argument("--inside", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.inside:
        print(json.dumps(PARTS[options.inside](0.1 if options.quick else 1.0)))
        return 0
    bootstrap.start("tests", extras=("test",))
    from tests.__main__ import screen

    figures: dict[str, Any] = {}
    with screen() as environment, tempfile.TemporaryDirectory() as home:
        environment |= {"HOME": home, "XDG_DATA_HOME": home, "XDG_CONFIG_HOME": home}
        for part in [options.only] if options.only else PARTS:
            command = [sys.executable, "-m", "tests.benchmark", "--inside", part]
            command += ["--quick"] if options.quick else []
            run = subprocess.run(
                command, env=environment, cwd=bootstrap.ROOT, stdout=subprocess.PIPE, text=True,
                check=True,
            )  # fmt: skip
            figures[part] = json.loads(run.stdout.splitlines()[-1])
            print(f"{part}:")
            for name, figure in figures[part].items():
                print(f"  {name:58} {figure}")
    if options.json:
        Path(options.json).write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")
    return 0


# --------------------------------------------------------------------------- the window


def application() -> Any:
    """The one QApplication of this process."""
    from PySide6.QtWidgets import QApplication

    from widgets.opengl import prepare

    if QApplication.instance() is None:
        prepare()
        return QApplication([])
    return QApplication.instance()


def open_window(scene: str = "letter-f") -> Any:
    """A main window, shown and drawn."""
    from app.document import Document
    from app.scene import load
    from widgets.application import Settings
    from widgets.main_window import MainWindow

    app = application()
    folder = Path(os.environ["HOME"])
    window = MainWindow(
        Document(scene, load(scene).start),
        settings=Settings(folder / "settings.ini"),
        software_rendering=True,
    )
    window.resize(1600, 700)
    window.show()
    settle(app)
    return window


def settle(app: Any) -> None:
    """Let Qt do all that is asked of it."""
    for _ in range(5):
        app.processEvents()


def close_window(window: Any) -> None:
    """Close as a user does, nothing unsaved."""
    window.store.mark_saved()
    window.close()
    window.deleteLater()
    app = application()
    app.sendPostedEvents(None, 52)  # QEvent.DeferredDelete
    settle(app)


def sphere(vertices: int) -> str:
    """A mesh file of about so many vertices."""
    import pyvista as pv

    across = max(5, round(math.sqrt(vertices)))
    path = Path(os.environ["HOME"]) / f"sphere-{vertices}.ply"
    pv.Sphere(theta_resolution=across, phi_resolution=across).save(path)
    return str(path)


def rounded(seconds: float) -> float:
    return round(1e3 * seconds, 2)


def step_over_repaint(scale: float) -> dict[str, Any]:
    """A slider step against the bare repaint of the same three panes, in turn.

    And against that repaint with the slider itself repainted, which any step has to do: Qt then
    uploads the widgets' own picture as well, which costs a fixed time however little has changed.
    """
    figures: dict[str, Any] = {}
    for vertices in VERTICES:
        window = open_window(sphere(vertices))
        app = application()
        # As while a slider is dragged: antialiasing waits, in the steps and in the repaints.
        window.store.begin_gesture()
        row = window.controls.rows["fov_y_deg"]
        start = row.value()
        turns = max(8, round(scale * (200 if vertices < 1_000_000 else 40)))
        bare, with_slider, step = [], [], []
        drawn = count_repaints(window)
        for turn in range(turns + 3):
            began = time.perf_counter()
            for pane in window.panes.values():
                pane.request_repaint()
            app.processEvents()
            middle = time.perf_counter()
            for pane in window.panes.values():
                pane.request_repaint()
            row.slider.update()
            app.processEvents()
            later = time.perf_counter()
            # To and fro as a hand drags: one way for a while, and not about the saved value, where
            # every step would also enable or disable Undo and change the window's title.
            row.slider.setValue(row.slider.value() + (1 if turn // 40 % 2 else -1))
            app.processEvents()
            ended = time.perf_counter()
            if turn >= 3:
                bare.append(middle - began)
                with_slider.append(later - middle)
                step.append(ended - later)
        assert row.value() != start
        assert set(drawn.values()) == {3 * (turns + 3)}, drawn
        window.store.end_gesture()
        for name, other in (("bare repaint", bare), ("repaint with the slider", with_slider)):
            figures[f"{vertices} vertices: p50, p95 of step / {name}"] = [
                round(statistics.median(step) / statistics.median(other), 3),
                round(percentile95(step) / percentile95(other), 3),
            ]
        figures[f"{vertices} vertices: bare, with slider, step (ms, medians)"] = [
            rounded(statistics.median(times)) for times in (bare, with_slider, step)
        ]
        close_window(window)
    return figures


def percentile95(values: list[float]) -> float:
    return statistics.quantiles(values, n=20)[-1]


def count_repaints(window: Any) -> dict[str, int]:
    """VTK renderings of each pane from now on."""
    counts = dict.fromkeys(window.panes, 0)
    for name, pane in window.panes.items():

        def count(_window: object, _event: str, name: str = name) -> None:
            counts[name] += 1

        pane.canvas.render_window.AddObserver("EndEvent", count)
    return counts


def repaints(scale: float) -> dict[str, Any]:
    """Repaints per change, of visible and hidden panes, and when idle."""
    from app.projection import Perspective

    window = open_window()
    app = application()
    counts = count_repaints(window)
    figures: dict[str, Any] = {}

    def change(fov_y_deg: float) -> None:
        old = window.store.document.projection
        window.store.set_projection(replace(old, lens=Perspective(fov_y_deg, 1.0, 30.0)))
        settle(app)

    for step in range(50):
        change(46.0 + step)
    figures["50 changes, repaints of the visible panes"] = list(counts.values())
    window.enlarge("world")
    settle(app)
    counts.update(dict.fromkeys(counts, 0))
    for step in range(50):
        change(100.0 + step)
    figures["50 changes, repaints with NDC and image hidden"] = list(counts.values())
    window.enlarge("world")
    settle(app)
    counts.update(dict.fromkeys(counts, 0))
    until = time.monotonic() + 5.0
    while time.monotonic() < until:
        app.processEvents()
        time.sleep(0.01)
    figures["5 s of idling, repaints"] = list(counts.values())
    close_window(window)
    return figures


def first_frame(scale: float) -> dict[str, Any]:
    """From process start to the first complete frame, against a window with three interactors."""
    times: dict[str, list[float]] = {"empty": [], "ours": []}
    for _ in range(max(3, round(10 * scale))):
        for which, seconds in times.items():
            began = time.perf_counter()
            subprocess.run(
                [sys.executable, "-c", FIRST_FRAME[which]], check=True, cwd=bootstrap.ROOT
            )
            seconds.append(time.perf_counter() - began)
    empty, ours = (statistics.median(seconds) for seconds in times.values())
    return {
        "first complete frame / empty window with three interactors": round(ours / empty, 3),
        "empty window, ours (ms, medians, whole processes)": [rounded(empty), rounded(ours)],
    }


FIRST_FRAME = {
    "empty": """
import os
from PySide6.QtWidgets import QApplication, QMainWindow, QSplitter
from widgets.opengl import prepare
prepare()
app = QApplication([])
from pyvistaqt import QtInteractor
window = QMainWindow()
row = QSplitter()
window.setCentralWidget(row)
panes = [QtInteractor(row, auto_update=False, multi_samples=0) for _ in range(3)]
for pane in panes:
    row.addWidget(pane)
window.resize(1366, 768)
window.show()
drawn = set()
for pane in panes:
    pane.render_window.AddObserver("EndEvent", lambda w, e, pane=pane: drawn.add(id(pane)))
while len(drawn) < 3:
    app.processEvents()
os._exit(0)
""",
    "ours": """
import os
from tests.benchmark import open_window, application, count_repaints
window = open_window()
app = application()
assert all(pane.drawing is not None for pane in window.panes.values())
os._exit(0)
""",
}


# --------------------------------------------------------------------------- memory


def resident() -> int:
    import psutil

    return int(psutil.Process().memory_info().rss)


def open_and_close(scale: float) -> dict[str, Any]:
    """Twenty windows opened and closed in one process."""
    references: list[weakref.ref[Any]] = []
    sizes = []
    for _ in range(20):
        window = open_window()
        references.extend(weakref.ref(pane.canvas) for pane in window.panes.values())
        close_window(window)
        del window
        gc.collect()
        sizes.append(resident())
    return {
        "20 open-and-close cycles, surviving interactors": sum(
            reference() is not None for reference in references
        ),
        "growth over the last 18 cycles (MB)": round((sizes[-1] - sizes[1]) / 1e6, 1),
    }


def random_changes(scale: float) -> dict[str, Any]:
    """Random slider changes, drawn; memory after the first fifth and at the end."""
    from app.projection import ProjectionError

    window = open_window()
    app = application()
    # One play of the animation, as far as the history is concerned.
    window.store.begin_gesture()
    rng = random.Random(1)
    rows = [row for row in window.controls.rows.values() if hasattr(row, "slider")]
    total = max(500, round(5000 * scale))
    start = 0
    for change in range(total):
        if change == total // 5:
            gc.collect()
            start = resident()
        slider = rng.choice([row for row in rows if row.isVisible()]).slider
        try:
            slider.setValue(rng.randint(slider.minimum(), slider.maximum()))
        except ProjectionError as error:
            raise AssertionError("a slider let an error through") from error
        app.processEvents()
        app.sendPostedEvents(None, 52)  # what the real event loop deletes as it goes
    gc.collect()
    growth = resident() - start
    window.store.end_gesture()
    close_window(window)
    return {
        f"{total} random slider changes, growth over the last {total - total // 5} (MB)": round(
            growth / 1e6, 1
        )
    }


def imports(scale: float) -> dict[str, Any]:
    """What importing the projection core brings along."""
    code = "import sys, app.projection; print(*sys.modules)"
    run = subprocess.run(
        [sys.executable, "-c", code], cwd=bootstrap.ROOT, capture_output=True, text=True, check=True
    )
    heavy = {name.split(".")[0] for name in run.stdout.split()} & {
        "PySide6", "vtk", "vtkmodules", "pyvista", "pyvistaqt", "matplotlib",
    }  # fmt: skip
    return {"app.projection imports of Qt, VTK and the like": sorted(heavy)}


PARTS: dict[str, Callable[[float], dict[str, Any]]] = {
    "step": step_over_repaint,
    "repaints": repaints,
    "first-frame": first_frame,
    "cycles": open_and_close,
    "changes": random_changes,
    "imports": imports,
}


if __name__ == "__main__":
    sys.exit(main())
