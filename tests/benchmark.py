"""``python3 -m tests.benchmark``: what the window costs, as ratios and counts taken in one run.

Timing is never a test: these machines, and yours, are shared and noisy. Figures are ratios of two
things done in turn in the same process, or times beside the machine's `pace`. ``--json FILE`` keeps
the figures.
``--check`` says which claims of docs/measurements.md are not true in this run, and ``--write``
writes the run's figures into that page.
"""

import argparse
import collections
import contextlib
import gc
import itertools
import json
import math
import os
import re
import signal
import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from app import bootstrap, python_packages
from tests import claims
from tests.__main__ import SCREEN, at_home
from tests.support.tools import ToolParser

VERTICES = (100, 10_000, 1_000_000)
paces: list[float] = []
"""How quick the machine was before each window, and after the part: it changes by the minute."""


def main(words: Sequence[str]) -> int:
    """Set up as the tests do, and run inside a screen."""
    parser = ToolParser("benchmark", __doc__)
    parser.add_argument("--json", metavar="FILE", help="write the figures to a file as well")
    parser.add_argument("--only", choices=sorted(PARTS), help="run one part only")
    parser.add_argument("--quick", action="store_true", help="a tenth of the repetitions")
    parser.add_argument("--check", action="store_true", help="compare the page's claims with it")
    parser.add_argument("--write", action="store_true", help="write the figures into the page")
    parser.add_argument("--from", dest="kept", metavar="FILE", help="take the figures from --json")
    parser.add_argument("--inside", help=argparse.SUPPRESS)
    options = parser.parse_args(words)
    if options.inside:
        part_figures = PARTS[options.inside](0.1 if options.quick else 1.0)
        paces.append(pace())
        print(json.dumps([part_figures, round(p50(paces), 2)]))
        return 0
    figures = json.loads(Path(options.kept).read_text("utf-8")) if options.kept else {}
    screen = CARD_SCREEN if options.only == "card" else SCREEN
    parts = [options.only] if options.only else [part for part in PARTS if part != "card"]
    with at_home(screen=screen) if not options.kept else contextlib.nullcontext({}) as environment:
        for part in () if options.kept else parts:
            command = [sys.executable, "-m", "tests.benchmark", "--inside", part]
            command += ["--quick"] if options.quick else []
            run = subprocess.run(
                command, env=environment, cwd=bootstrap.ROOT, stdout=subprocess.PIPE, text=True,
                check=True,
            )  # fmt: skip
            figures[part], paced = json.loads(run.stdout.splitlines()[-1])
            figures.setdefault(claims.PACE, {})[part] = paced
            print(f"{part}: (pace {paced} ms)")
            for name, figure in figures[part].items():
                print(f"  {name:58} {figure}")
    if options.json:
        Path(options.json).write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")
    page = claims.PAGE.read_text(encoding="utf-8")
    faults = claims.untrue(page, figures) if options.check else []
    for fault in faults:
        print(f"no longer true: {fault}")
    if options.write:
        claims.PAGE.write_text(claims.written(page, figures), encoding="utf-8")
    return 1 if faults else 0


# --------------------------------------------------------------------------- the window


def application() -> Any:
    """The one QApplication of this process, with what it shows imported as the program does.

    As there, the labels that come with the program are set, and Python collects garbage only in
    pauses, by `rest`.
    """
    from PySide6.QtWidgets import QApplication

    from app.drawings import kept_labels
    from widgets.program.opengl import prepare

    if QApplication.instance() is None:
        prepare()
        made = QApplication([])
        with python_packages.for_good():
            import widgets.window.main_window  # noqa: F401
        kept_labels.load_shipped()
        gc.disable()
        return made
    return QApplication.instance()


def open_window(
    scene: str = "letter-f", size: tuple[int, int] = (1600, 700), canvas: str = "raster"
) -> Any:
    """A main window, shown and drawn."""
    app = application()
    paces.append(pace())
    from app.document.document import Document
    from app.scenes.scene import load
    from widgets.window.main_window import MainWindow
    from widgets.window.settings import Settings

    folder = Path(os.environ["HOME"])
    window = MainWindow(
        Document(scene, load(scene).start),
        settings=Settings(folder / "settings.ini"),
        software_rendering=True,
        canvas=canvas,
    )
    for pane in window.panes.values():
        pane.open()
    window.resize(*size)
    window.show()
    settle(app)
    return window


def settle(app: Any) -> None:
    """Let Qt do all that is asked of it."""
    for _ in range(5):
        app.processEvents()


def rest(seconds: float) -> None:
    """Let the window do what it does by itself."""
    gc.collect()
    until = time.perf_counter() + seconds
    while time.perf_counter() < until:
        application().processEvents()
        time.sleep(0.002)


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


def pace() -> float:
    """How quick the machine is: ms of a small plain VTK picture and 1 000 000 turns of a loop.

    Mostly Python, as what a hand waits for: large pictures take 26 to 44 ms on one machine within a
    minute, where a loop takes 2.7 to 2.9, and two machines whose steps take as long differ by 1.5.
    """
    import pyvista as pv

    plotter = pv.Plotter(off_screen=True, window_size=[640, 360])
    plotter.render_window.SetMultiSamples(0)
    plotter.add_mesh(pv.Sphere(theta_resolution=100, phi_resolution=100))
    times = []
    for _ in range(15):
        began = time.perf_counter()
        plotter.camera.azimuth += 5.0
        plotter.render()
        plotter.screenshot(return_img=True)
        for turn in range(1_000_000):
            _ = turn + 1
        times.append(time.perf_counter() - began)
    plotter.close()
    return 1e3 * p50(times)


def ms(*seconds: float) -> list[float]:
    return [round(1e3 * each, 2) for each in seconds]


def p50(times: list[float]) -> float:
    return statistics.median(times)


def p95(times: list[float]) -> float:
    return statistics.quantiles(times, n=20)[-1]


def ratio(mine: list[float], other: list[float], digits: int = 3) -> list[float]:
    """The first over the second, at p50 and at p95."""
    return [round(p50(mine) / p50(other), digits), round(p95(mine) / p95(other), digits)]


def timed(act: Callable[[], object]) -> float:
    """Seconds of an act, with all that Qt does because of it."""
    began = time.perf_counter()
    act()
    application().processEvents()
    return time.perf_counter() - began


def in_turn(
    acts: dict[str, Callable[[], object]], turns: int, skipped: int = 3
) -> dict[str, list[float]]:
    """Seconds of each act, one after the other, turn after turn, without the first turns."""
    times: dict[str, list[float]] = {name: [] for name in acts}
    for turn in range(turns + skipped):
        for name, act in acts.items():
            seconds = timed(act)
            if turn >= skipped:
                times[name].append(seconds)
    return times


def repaint(window: Any) -> None:
    """Repaint the panes, and nothing else."""
    for pane in window.panes.values():
        pane.canvas.redraw()


def stepping(row: Any, there: int = 40) -> Callable[[], None]:
    """An act that moves a slider to and fro as a hand drags.

    It goes one way for a while, and not about the saved value, where every step would also enable
    or disable Undo and change the window's title.
    """
    turns = itertools.count()

    def step() -> None:
        row.slider.setValue(row.slider.value() + (1 if next(turns) // there % 2 else -1))

    return step


@contextlib.contextmanager
def dragging(window: Any) -> Iterator[None]:
    """As while a slider is dragged: antialiasing waits, in the steps and in the repaints."""
    window.store.begin_gesture()
    yield
    window.store.end_gesture()


def in_a_drag(window: Any, name: str, turns: int) -> dict[str, list[float]]:
    """Bare repaints, repaints with a slider, and its steps, in turn, in the middle of a drag."""
    row = window.controls.rows[name]
    with dragging(window):
        return in_turn(
            {
                "bare repaint": partial(repaint, window),
                "repaint with the slider": lambda: (repaint(window), row.slider.update()),
                "step": stepping(row),
            },
            turns,
        )


def compared(times: dict[str, list[float]], where: str) -> dict[str, Any]:
    """The figures of steps beside repaints."""
    figures: dict[str, Any] = {
        f"{where}: p50, p95 of step / {name}": ratio(times["step"], other)
        for name, other in times.items()
        if name != "step"
    }
    figures[f"{where}: bare, with slider, step (ms, medians)"] = ms(
        *(p50(times[name]) for name in ("bare repaint", "repaint with the slider", "step"))
    )
    return figures


def step_over_repaint(scale: float) -> dict[str, Any]:
    """A slider step against the bare repaint of the same three panes, in turn.

    And against that repaint with the slider itself repainted, which any step has to do: Qt then
    uploads the widgets' own picture as well, which costs a fixed time however little has changed.
    """
    figures: dict[str, Any] = {}
    for vertices in VERTICES:
        window = open_window(sphere(vertices))
        turns = max(8, round(scale * (200 if vertices < 1_000_000 else 40)))
        drawn = count_repaints(window)
        times = in_a_drag(window, "fov_y_deg", turns)
        assert set(drawn.values()) == {3 * (turns + 3)}, drawn
        figures |= compared(times, f"{vertices} vertices")
        close_window(window)
    return figures


WINDOWS = ((1366, 768), (1920, 1080))


def canvases(scale: float) -> dict[str, Any]:
    """The letter F in panes that paint pixels over panes of OpenGL widgets, in turn."""
    app = application()
    figures: dict[str, Any] = {}
    for size in WINDOWS:
        windows = {canvas: open_window(size=size, canvas=canvas) for canvas in ("raster", "opengl")}
        times: dict[tuple[str, str], list[float]] = {}
        for turn in range(max(10, round(100 * scale))):
            for canvas, window in windows.items():
                window.raise_()
                settle(app)
                row = window.controls.rows["fov_y_deg"]
                names = frozenset({"near"} if turn % 2 else ())
                acts: dict[str, Callable[[], object]] = {
                    "step": partial(row.slider.setValue, row.slider.value() + 1 - 2 * (turn // 40)),
                    "slider": row.slider.update,
                    "hover": partial(window.highlighter.mark, len(window.panes), names),
                    "typing": partial(row.field.setText, row.field.text()[:3] + "12"[turn % 2]),
                }
                with dragging(window):
                    for act, do in acts.items():
                        times.setdefault((act, canvas), []).append(timed(do))
        for act in dict.fromkeys(act for act, _ in times):
            raster, opengl = (p50(times[act, canvas][3:]) for canvas in windows)
            figures[f"{size[0]} x {size[1]}: {act}, pixels / OpenGL widgets; ms"] = [
                round(raster / opengl, 3), *ms(raster, opengl),
            ]  # fmt: skip
        for window in windows.values():
            close_window(window)
    return figures


CARD_SCREEN = (3840, 2160)


def card(scale: float) -> dict[str, Any]:
    """Both canvases at two sizes, for a machine with a graphics card; by ``--only card`` alone.

    The renderer is named: where it is llvmpipe, there is no card.
    """
    app = application()
    from widgets.program.opengl import probe

    figures: dict[str, Any] = {f"renderer: {probe().renderer}": 1}
    for scene in ("letter-f", sphere(1_000_000)):
        for size in (WINDOWS[1], CARD_SCREEN):
            times: dict[str, list[float]] = {}
            for canvas in ("raster", "opengl") * 2:
                window = open_window(scene, size, canvas)
                window.look.adaptive.set_target(0.0)
                settle(app)
                step = stepping(window.controls.rows["fov_y_deg"])
                with dragging(window):
                    turns = max(5, round((50 if scene == "letter-f" else 10) * scale))
                    times.setdefault(canvas, []).extend(in_turn({"step": step}, turns)["step"])
                close_window(window)
            what = f"{Path(scene).stem}, {size[0]} x {size[1]}: a step, pixels / OpenGL widgets"
            figures[f"{what}; p50s, p95s (ms)"] = [
                ratio(times["raster"], times["opengl"])[0],
                *ms(*map(p50, times.values()), *map(p95, times.values())),
            ]
    starts: dict[str, list[float]] = {"empty": [], "raster": [], "opengl": []}
    for turn in range(1 + max(2, round(4 * scale))):
        for name, taken in starts.items():
            is_empty = name == "empty"
            command = start_command(name) if is_empty else start_command("ours", name)
            seconds, _dock = until_seen(command, compiled())
            if turn:
                taken.append(seconds)
    empty = p50(starts.pop("empty"))
    for name, taken in starts.items():
        figures[f"exec to picture / empty window, {name}; ms"] = [
            round(p50(taken) / empty, 2), *ms(p50(taken)),
        ]  # fmt: skip
        figures[f"memory at rest, {name} (PSS, MB)"] = memory_at_rest(name)
    return figures


def in_ndc(points: Any, matrix: Any) -> Any:
    clip = points @ matrix[:, :3].T + matrix[:, 3]
    return clip[:, :3] / clip[:, 3:]


def peers(scale: float) -> dict[str, Any]:
    """A step of ours over the same three pictures by pyvista updated in place, and by matplotlib.

    Panes of one size, the whole mesh in each: as it is, in NDC and in the image. Theirs have no
    labels, frustum or handles.
    """
    import numpy as np
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection
    from PySide6.QtWidgets import QHBoxLayout, QWidget
    from pyvista import PolyData
    from pyvistaqt import QtInteractor

    app = application()
    figures: dict[str, Any] = {}
    for vertices in (100, 10_000, 100_000, 1_000_000):
        window = open_window(sphere(vertices), WINDOWS[1])
        window.look.adaptive.set_target(0.0)
        settle(app)
        mesh = window.shown.scene.surface
        points, triangles = np.asarray(mesh.points, dtype=float), mesh.regular_faces
        beside = QWidget()
        layout = QHBoxLayout(beside)
        shown, drawn = [], []
        for pane in window.panes.values():
            width, height = pane.canvas.width(), pane.canvas.height()
            canvas = QtInteractor(beside, auto_update=False, multi_samples=0)
            canvas.setFixedSize(width, height)
            layout.addWidget(canvas)
            shown.append((canvas, PolyData(mesh, deep=True)))
            canvas.add_mesh(shown[-1][1], scalars="rgb", rgb=True, lighting=False)
            if vertices <= 10_000:
                figure = Figure((width / 100.0, height / 100.0), dpi=100.0)
                faces = Poly3DCollection(points[triangles])
                figure.add_subplot(projection="3d").add_collection3d(faces)
                drawn.append((FigureCanvasAgg(figure), faces))
        beside.show()
        settle(app)

        def by_pyvista(shown: Any = shown, points: Any = points, window: Any = window) -> None:
            for canvas, copy in shown:
                if canvas is not shown[0][0]:
                    copy.points = in_ndc(points, window.shown.projection.clip_from_world)
                QWidget.update(canvas)

        def by_matplotlib(
            drawn: Any = drawn, points: Any = points[triangles], window: Any = window
        ) -> None:
            for canvas, faces in drawn:
                if canvas is not drawn[0][0]:
                    matrix = window.shown.projection.clip_from_world
                    faces.set_verts(in_ndc(points.reshape(-1, 3), matrix).reshape(points.shape))
                canvas.draw()

        acts = {"ours": stepping(window.controls.rows["fov_y_deg"], 20), "pyvista": by_pyvista}
        turns = max(3, round(scale * (38 if vertices < 1_000_000 else 8)))
        with dragging(window):
            times = in_turn(acts, turns, 2)
            if drawn:
                times |= in_turn({"matplotlib": by_matplotlib}, 4, 2)
        ours = p50(times.pop("ours"))
        for name, taken in times.items():
            figures[f"{vertices} vertices: a step of ours / {name}'s; ms"] = [
                round(ours / p50(taken), 3), *ms(ours, p50(taken)),
            ]  # fmt: skip
        for canvas, _ in shown:
            canvas.close()
        beside.deleteLater()
        close_window(window)
    return figures


def scene_steps(scale: float) -> dict[str, Any]:
    """A step of the camera over the bare repaint in each scene, its panel open, on full HD."""
    from app.scenes.scene import BUILT_IN

    figures: dict[str, Any] = {}
    for name in BUILT_IN:
        window = open_window(name, WINDOWS[1])
        times = in_a_drag(window, "azimuth_deg", max(8, round(100 * scale)))
        step = times["step"]
        figures[f"{name}: p50, p95 of step / bare repaint; p50, p95 of it (ms)"] = [
            *ratio(step, times["bare repaint"]), *ms(p50(step), p95(step)),
        ]  # fmt: skip
        close_window(window)
    return figures


def panel_steps(scale: float) -> dict[str, Any]:
    """A step with the matrices and three probes open, or the probes' numbers, and without.

    In turn in one process, the step itself, and the step over the bare repaint of the panes as
    high as they are then: an open panel leaves them less to draw.
    """
    names = {"": "no panel", "matrices": "matrices and three probes",
             "probe_panel": "the probes' numbers"}  # fmt: skip
    steps: dict[str, list[float]] = {panel: [] for panel in names}
    rounds: dict[str, list[float]] = {panel: [] for panel in names}
    for _ in range(3):
        for panel in names:
            window = open_window()
            for point in ((0.0, 0.0, 0.0), (1.0, 2.0, 0.5), (0.5, 4.0, 0.0)) if panel else ():
                window.probe_panel.follow(point=point)
                window.probe_panel.pin.click()
            window.panels.open(getattr(window, panel) if panel else None)
            settle(application())
            times = in_a_drag(window, "azimuth_deg", max(8, round(60 * scale)))
            steps[panel].append(p50(times["step"]))
            rounds[panel].append(steps[panel][-1] / p50(times["bare repaint"]))
            close_window(window)
    figures: dict[str, Any] = {
        f"{names[panel]}: step / bare repaint": round(p50(found), 3)
        for panel, found in rounds.items()
    }
    for panel in ("matrices", "probe_panel"):
        for what, found in (("step without", steps), ("the same over bare repaints", rounds)):
            figures[f"{names[panel]}: step / {what}"] = round(p50(found[panel]) / p50(found[""]), 3)
    return figures


def strip_step(scale: float) -> dict[str, Any]:
    """A step of the stage strip against the bare repaint of its pane at the same position.

    What is drawn differs from position to position, so that each is repainted where it stepped to:
    bare, and with the slider, which any step has to repaint.
    """
    figures: dict[str, Any] = {}
    for vertices in VERTICES:
        window = open_window(sphere(vertices))
        pane, slider = window.panes["ndc"], window.strip.slider
        window.strip.gesture_started.emit()  # antialiasing waits, as in a drag
        turns = max(12, round(scale * (240 if vertices < 1_000_000 else 60)))
        stride = slider.maximum() // turns
        slider.setValue(0)
        settle(application())
        acts: dict[str, Callable[[], object]] = {
            "step": lambda slider=slider, stride=stride: slider.setValue(slider.value() + stride),
            "bare repaint": pane.canvas.redraw,
            "repaint with the slider": lambda pane=pane, slider=slider: (
                pane.canvas.redraw(),
                slider.update(),
            ),
        }
        times = in_turn(acts, turns - 3)
        figures |= compared(times, f"{vertices} vertices")
        for name in ("bare repaint", "repaint with the slider"):
            ratios = [mine / its for mine, its in zip(times["step"], times[name], strict=True)]
            figures[f"{vertices} vertices: step / {name}, median of pairs"] = round(p50(ratios), 3)
        close_window(window)
    return figures


def adaptive(scale: float) -> dict[str, Any]:
    """Frames while the field of view is dragged, in four drags: from the step to what is shown.

    With the target frame time and without any, in the same window; the first drag, which has to
    find the quality, counts like the others.
    """
    figures: dict[str, Any] = {}
    for size, vertices in itertools.product(((1600, 700), (1920, 1080)), VERTICES):
        window = open_window(sphere(vertices), size)
        where = f"{size[0]} x {size[1]}, {vertices} vertices"
        step = stepping(window.controls.rows["fov_y_deg"])
        for target in (0.0, window.settings.frame_ms):
            window.look.adaptive.set_target(target)
            settle(application())
            frames: list[float] = []
            for _ in range(4):
                with dragging(window):
                    turns = max(15, round(scale * (60 if target else 15)))
                    frames += in_turn({"step": step}, turns, 0)["step"]
                    adapted = window.look.adaptive
                    found = [adapted.budget.level.share, bool(adapted.late_ms)]
                settle(application())
            name = f"target {target:g} ms" if target else "no target"
            figures[f"{where}, {name}: p50, p95, longest (ms)"] = ms(
                p50(frames), p95(frames), max(frames)
            )
            if target:
                figures[f"{where}: share of the triangles, said to be late"] = found
        close_window(window)
    return figures


def measuring(scale: float) -> dict[str, Any]:
    """Slider steps while a measurement runs in its process, over those with none, in turn.

    Dragged, which makes it wait; typed or with keys, one step by one, which does not; and dragged
    while the process starts, which cannot wait yet.
    """
    window = open_window(sphere(10_000))
    app = application()
    panel, step = window.measure_panel, stepping(window.controls.rows["fov_y_deg"])
    progress: list[float] = []
    panel.measuring.progressed.connect(progress.append)
    count = max(10, round(40 * scale))

    def steps(seconds: float = 0.0) -> list[float]:
        until, found = time.monotonic() + seconds, []
        while time.monotonic() < until or len(found) < (5 if seconds else count):
            found.append(timed(step))
        return found

    def dragged(seconds: float = 0.0) -> list[float]:
        window.controls.gesture_started.emit()
        found = steps(seconds)
        window.controls.gesture_finished.emit()
        settle(app)
        return found

    def wait(fraction: float) -> None:
        until = time.monotonic() + 60.0
        while not progress or progress[-1] < fraction:
            assert panel.measuring.running and time.monotonic() < until, (progress, panel.words)
            app.processEvents()
            time.sleep(0.01)

    dragged()  # finds the quality
    figures: dict[str, Any] = {}
    panel.how.setCurrentIndex(panel.how.findData(False))
    for name in ("arithmetic", "interpolation", "smoothing", "detail", "near"):
        taken: dict[str, list[float]] = collections.defaultdict(list)
        for _ in range(max(1, round(2 * scale))):
            taken["dragged alone"] += dragged()
            taken["typed alone"] += steps()
            progress.clear()
            panel.choose(name)
            panel.run()
            taken["dragged while it starts"] += dragged(2.0)  # it tells nothing while it waits
            wait(0.01)
            taken["dragged"] += dragged()
            wait(progress[-1] + 0.01)
            taken["typed"] += steps()
            assert panel.measuring.running, "steps beside nothing"
            panel.measuring.kill()
            settle(app)
        for kind in ("dragged", "typed", "dragged while it starts"):
            alone = taken[f"{kind.split()[0]} alone"]
            figures[f"{name}, {kind}: p50, p95 over a step without"] = ratio(taken[kind], alone, 2)
    close_window(window)
    return figures


def count_repaints(window: Any) -> dict[str, int]:
    """VTK renderings of each pane from now on."""
    counts = dict.fromkeys(window.panes, 0)
    for name, pane in window.panes.items():

        def count(_window: object, _event: str, name: str = name) -> None:
            counts[name] += 1

        pane.canvas.render_window.AddObserver("EndEvent", count)
    return counts


def first_frame(scale: float) -> dict[str, Any]:
    """From a start to the picture on the screen, against a window with three interactors.

    Seen from outside, as a user sees it: whole processes are started, and this one looks at the
    screen, where nothing else may move. Compiled once before: for users it is so from the second
    start on.
    """
    times: dict[str, list[tuple[float, float]]] = {name: [] for name in FIRST_FRAME}
    for turn in range(1 + max(3, round(10 * scale))):
        for name, seconds in times.items():
            taken = until_seen(start_command(name), compiled())
            if turn:
                seconds.append(taken)
    found: dict[str, Any] = {}
    empty = [whole for whole, _dock in times.pop("empty")]
    for name, taken in times.items():
        for what, ours in zip(("picture", "dock"), zip(*taken, strict=True), strict=True):
            ratios = [mine / its for its, mine in zip(empty, ours, strict=True)]
            key = f"exec to {what} / empty window with three interactors, {name}"
            found[f"{key} (median, lowest, highest)"] = [
                round(each, 2) for each in (p50(ratios), min(ratios), max(ratios))
            ]
    return found | {"empty window (ms, median)": ms(p50(empty))}


def compiled() -> dict[str, str]:
    """The environment of a program that keeps its compiled modules, as a user's does."""
    return {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}


def start_command(name: str, canvas: str | None = None) -> list[str]:
    """The command of one of `FIRST_FRAME`; without the start card it opens a document."""
    command = [sys.executable, *FIRST_FRAME[name]]
    if name in ("ours", "ours with OpenGL"):
        from app.document.document import Document
        from app.document.files import write
        from app.document.settings import set_values
        from app.scenes.scene import load

        path = Path(os.environ["HOME"]) / "own.json"
        document = Document("letter-f", load("letter-f").start)
        write(set_values(document, ["lens.near=3.9"]), path)
        command.append(str(path))
    return command + (["--canvas", canvas] if canvas else [])


WINDOW = (1366, 768)
OURS = ("-m", "app", "--size", f"{WINDOW[0]}x{WINDOW[1]}")
FIRST_FRAME = {
    "empty": (
        "-c",
        f"""
from PySide6.QtWidgets import QApplication, QMainWindow, QSplitter
from widgets.program.opengl import prepare
prepare()
app = QApplication([])
from pyvistaqt import QtInteractor
window = QMainWindow()
row = QSplitter()
window.setCentralWidget(row)
for _ in range(3):
    row.addWidget(QtInteractor(row, auto_update=False, multi_samples=0))
window.resize{WINDOW}
window.show()
app.exec()
""",
    ),
    "ours": OURS,
    "ours with OpenGL": (*OURS, "--canvas", "opengl"),
    "ours with the start card": OURS,
}  # fmt: skip
DOCK = slice(1090, 1340)
"""Columns of the screen where nothing but our dock is, without what scrolls it."""


def until_seen(command: list[str], environment: dict[str, str]) -> tuple[float, float]:
    """Seconds from starting a program until the screen, and `DOCK`, show what they go on showing.

    Some rows of the screen's pixels are looked at. They are there when 199 of 200 are as they are
    after 3 s without a change: a cursor may blink.
    """
    import numpy as np
    from PySide6.QtGui import QGuiApplication

    looking: Any = QGuiApplication.instance() or QGuiApplication([])
    screen = looking.primaryScreen()
    seen: list[tuple[float, Any]] = []

    def look() -> None:
        images = [
            screen.grabWindow(0, 0, y, WINDOW[0], 1).toImage() for y in range(16, WINDOW[1], 48)
        ]
        pixels = np.stack([np.frombuffer(image.constBits(), np.uint32) for image in images])
        if not seen or (pixels != seen[-1][1]).any():
            seen.append((time.perf_counter(), pixels))

    look()
    began = time.perf_counter()
    with subprocess.Popen(command, cwd=bootstrap.ROOT, env=environment) as program:
        try:
            while len(seen) < 2 or time.perf_counter() < seen[-1][0] + 3.0:
                assert program.poll() is None and time.perf_counter() < began + 120.0, command
                time.sleep(0.005)
                look()
        finally:
            # Ours closes its window, and keeps what it keeps for the next start.
            program.send_signal(signal.SIGINT if "app" in command else signal.SIGTERM)
    final = seen[-1][1]
    whole, dock = (
        next(at for at, pixels in seen[1:] if (pixels == final)[:, part].mean() > 0.995) - began
        for part in (slice(None), DOCK)
    )
    return whole, dock


def a_talk(steps: int) -> Path:
    """A talk of so many steps, over several scenes, two after the other in the same one."""
    scenes = ("letter-f", "posts", "view-volumes", "affine-depth", "cube")
    lines = ["---", "title: A long talk", "---"]
    for number in range(steps):
        scene, near = scenes[number // 2 % len(scenes)], 2.0 + 0.05 * (number % 7)
        lines += [
            *(["---"] if number else []),
            f"# Step {number} {{#s{number}}}",
            f"The window is $2 n \\tan(\\alpha/2)$ high, and $\\frac{{{number}}}{{7}}$.",
            "```state",
            f"scene={scene}",
            f"lens.near={near:g}",
            f"view.stage={('ndc', 'pyramid')[number % 2]}",
            "```",
            "```note",
            "minutes: 0.5",
            "What is said.",
            "```",
        ]
    path = Path(os.environ["HOME"]) / "long.md"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def talks(scale: float) -> dict[str, Any]:
    """A talk of 200 steps opened; the steps of the five talks, as they go on by Page Down.

    A step's own work is from the key to its first picture, less the bare repaint of the same panes
    just after it: what follows is the transition. Under load both grow; compare in one run.
    """
    from app.lessons.contents import contained

    window = open_window(size=(1366, 768))
    window.settings.speaker_window = False
    path = a_talk(200)
    opening = in_turn({"open": lambda: window.lessons.open(path)}, 5, 0)["open"]
    figures: dict[str, Any] = {"200 steps: opened (ms, median)": ms(p50(opening))}
    window.present.begin()
    for talk in contained():
        if not talk.stem.startswith("talk-"):
            continue
        assert window.lessons.open(talk)
        course, bare = window.lessons.course, []
        own: dict[str, list[float]] = {"same scene": [], "other scene": []}
        for place in range(1, max(2, round(scale * len(course.lesson.steps)))):
            rest(2.5)  # what is made ahead is made then
            before = window.store.document.scene
            took = timed(partial(window.lessons.go, place))
            rest(1.0)  # until the transition has ended
            bare.append(p50(in_turn({"bare": partial(repaint, window)}, 5, 0)["bare"]))
            same = window.store.document.scene == before
            own["same scene" if same else "other scene"].append(took - bare[-1])
        figures[f"{talk.stem}: bare repaint of the panes (ms, p50)"] = ms(p50(bare))
        for kind, times in own.items():
            if times:
                figures[f"{talk.stem}: own work, {kind} (ms: p50, max; steps)"] = [
                    *ms(p50(times), max(times)), len(times),
                ]  # fmt: skip
    window.present.end()
    window.lessons.close()
    close_window(window)
    return figures


class Felt(NamedTuple):
    """One act: the wall time and the processor time until the window has nothing left to paint."""

    wall: float
    processor: float


def until_idle() -> float:
    """Let Qt work until it has nothing to do; return when it last had."""
    app = application()
    end, quiet = time.perf_counter(), 0
    while quiet < 3:
        began = time.perf_counter()
        app.processEvents()
        app.sendPostedEvents()
        quiet = quiet + 1 if time.perf_counter() - began < 0.0008 else 0
        end = end if quiet else time.perf_counter()
    return end


def feel(act: Callable[[], object], pause: float = 1.2) -> Felt:
    rest(pause)
    began, processor = time.perf_counter(), time.process_time()
    act()
    return Felt(until_idle() - began, time.process_time() - processor)


def summed_up(acts: Sequence[Felt]) -> list[float]:
    """Median and largest wall time, and the median of the processor time, in ms."""
    walls = [each.wall for each in acts]
    return ms(p50(walls), max(walls), p50([each.processor for each in acts]))


FELT_SCENES = (
    "clipping", "far-plane-popping", "focus", "letter-f", "similar-triangles", "off-axis-window",
    "view-volumes", "letter-f",
)  # fmt: skip


def felt(scale: float) -> dict[str, Any]:
    """What a hand feels: ms from an act until the window has nothing left to paint.

    Under load only the processor time says anything.
    """
    figures: dict[str, Any] = {}
    what = "(ms: median, largest, processor)"
    window = open_window(size=WINDOW)
    rest(2.0)
    figures[f"Matrices opened, first time {what}"] = summed_up(
        [feel(partial(window.panels.open, window.matrices))]
    )
    window.panels.open(None)
    taken = [
        feel(partial(window.guide.choose, scene))
        for scene in FELT_SCENES * max(1, round(2 * scale))
    ]
    figures[f"another scene {what}"] = summed_up(taken)
    taken = [feel(window.menus.present.trigger) for _ in range(2 * max(2, round(5 * scale)))]
    figures[f"F5 and back, each {what}"] = summed_up(taken)
    close_window(window)
    figures |= felt_steps(what) | felt_turns(what) | felt_beside_a_hog(scale)
    return figures | {"memory at rest (PSS, MB)": [memory_at_rest()]}


def felt_steps(what: str) -> dict[str, Any]:
    """The first picture of each step of a lesson, and of a talk that is presented."""
    figures: dict[str, Any] = {}
    for name in ("l05-similar-triangles", "talk-003"):
        window = open_window(size=WINDOW)
        window.settings.speaker_window = False
        rest(1.0)
        assert window.lessons.open(bootstrap.ROOT / "app/lessons/content" / f"{name}.md")
        if name.startswith("talk"):
            window.present.begin()
        until_idle()
        taken: dict[str, list[Felt]] = {"same scene": [], "another scene": []}
        for place in range(1, len(window.lessons.course.lesson.steps)):
            rest(2.3)  # what is made ahead is made then
            before = window.store.document.scene
            began, processor = time.perf_counter(), time.process_time()
            window.lessons.go(place)
            application().processEvents()
            kind = "same scene" if window.store.document.scene == before else "another scene"
            taken[kind].append(Felt(time.perf_counter() - began, time.process_time() - processor))
        for kind, acts in taken.items():
            if acts:
                key = f"first picture of a step, {name}, {kind} {what}"
                figures[key] = summed_up(acts)
        window.present.end()
        window.lessons.close()
        close_window(window)
    return figures


def felt_turns(what: str) -> dict[str, Any]:
    """Moves that turn one's own view of the world."""
    from PySide6.QtCore import QPoint, Qt
    from PySide6.QtTest import QTest

    figures: dict[str, Any] = {}
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    for vertices in (100_000, 1_000_000):
        window = open_window(sphere(vertices), WINDOW)
        rest(3.0)
        canvas = window.panes["world"].canvas
        at = QPoint(canvas.width() // 6, canvas.height() // 5)
        QTest.mousePress(canvas, left, none, at)
        until_idle()
        taken = [
            feel(partial(QTest.mouseMove, canvas, at + QPoint(3 * move, move)), 0.0)
            for move in range(1, 13)
        ]
        QTest.mouseRelease(canvas, left, none, at)
        figures[f"own view turned, {vertices} vertices {what}"] = summed_up(taken[1:])
        close_window(window)
    return figures


def felt_beside_a_hog(scale: float) -> dict[str, Any]:
    """A slider step of the letter F, in turn alone and beside a program that takes one core."""
    window = open_window(size=WINDOWS[1])
    step, count = stepping(window.controls.rows["azimuth_deg"]), max(10, round(40 * scale))
    times: dict[str, list[float]] = {"alone": [], "beside a hog": []}
    rest(1.0)
    for _ in range(3):
        for where, taken in times.items():
            hog = [sys.executable, "-c", "while True: pass"] if "hog" in where else ["true"]
            with subprocess.Popen(hog) as running, dragging(window):
                taken += [timed(step) for _ in range(count + 3)][3:]
                running.kill()
            until_idle()
    close_window(window)
    return {
        f"a slider step at 1920 x 1080, {where} (ms: p50, p95)": ms(p50(taken), p95(taken))
        for where, taken in times.items()
    }


def memory_at_rest(canvas: str | None = None) -> float:
    """The program's share of memory, PSS, when it has not changed by 1 MB for 5 s."""
    command = start_command("ours", canvas)
    with subprocess.Popen(command, cwd=bootstrap.ROOT, env=compiled()) as program:
        seen: list[float] = []
        while len(seen) < 12 or max(seen[-6:]) - min(seen[-6:]) > 1.0:
            time.sleep(1.0)
            rollup = Path(f"/proc/{program.pid}/smaps_rollup").read_text(encoding="ascii")
            (kib,) = re.findall(r"^Pss: +(\d+) kB", rollup, re.MULTILINE)
            seen.append(round(int(kib) * 1024 / 1e6, 1))
        program.send_signal(signal.SIGINT)
    return seen[-1]


PARTS: dict[str, Callable[[float], dict[str, Any]]] = {
    "felt": felt,
    "step": step_over_repaint,
    "canvases": canvases,
    "card": card,
    "peers": peers,
    "scenes": scene_steps,
    "panels": panel_steps,
    "strip": strip_step,
    "talks": talks,
    "adaptive": adaptive,
    "measuring": measuring,
    "first-frame": first_frame,
}


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
