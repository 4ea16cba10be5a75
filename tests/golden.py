"""``python3 -m tests.golden record FOLDER`` and ``compare FOLDER``: are all outputs as before?

Use it around a change that must not change behaviour. `record` keeps the command line's output for
300 random documents, a picture of every scene's panes, and the state of the window after each step
of a fixed script of user actions. `compare` repeats all that, reports the differences, and ends
with status 1 if there are any. It uses only what is stable: command lines, documents, pictures, and
what a user sees in the window. `compare` reads the cases from the recording, so that this file may
change in between. Only `command_line` and `Window.canvas` know the program's inside.

``--only PART`` does one part. ``--skip KIND``, which may be repeated, ignores a kind of difference
that is intended, such as ``"predicted error"`` or ``"matrices text"``; the report names the kinds.
``FOLDER/differences`` gets a picture of every difference between pictures.

This is no part of the suite. The command line runs in this process, because 300 documents as
processes would take an hour.
"""

from __future__ import annotations

import argparse
import collections
import contextlib
import gzip
import io
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

from app import bootstrap

PARTS = ("documents", "pictures", "window")
DOCUMENTS = 300
SEED = 17
SHOWN = 12
"""Differences of a kind that are shown in full."""
DOCUMENT: dict[str, Any] = {
    "format": "frustum-lab", "version": 1, "scene": "letter-f",
    "camera": {"eye": [6, 5, 9], "target": [0, 2.2, 0], "up": [0, 1, 0]},
    "lens": {"kind": "perspective", "fov_y_deg": 45, "near": 1, "far": 30},
    "depth": "opengl", "image": {"width": 1280, "height": 720},
}  # fmt: skip
"""What the window opens, and random documents differ from."""


def main() -> int:
    """Set up as the tests do, and run the parts in processes of their own."""
    parser = argparse.ArgumentParser(prog="python3 -m tests.golden", description=__doc__)
    parser.add_argument("act", choices=("record", "compare"))
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", choices=PARTS, action="append", help="may be repeated")
    parser.add_argument("--skip", action="append", default=[], metavar="KIND")
    parser.add_argument("--inside", choices=PARTS, help=argparse.SUPPRESS)
    options = parser.parse_args()
    folder = options.folder.resolve()
    if options.inside:
        return INSIDE[options.inside](options.act == "record", folder, options.skip)
    bootstrap.start("tests", extras=("test",))
    from tests.__main__ import screens

    if options.act == "record":
        folder.mkdir(parents=True, exist_ok=True)
    elif not folder.is_dir():
        parser.error(f"there is no recording {options.folder}")
    parts = options.only or PARTS
    # The window runs alone: if it is late, it draws differently.
    together = [[part for part in parts if part != "window"], [p for p in parts if p == "window"]]
    failed = False
    with screens(1) as environment, tempfile.TemporaryDirectory() as place:
        for names in together:
            runs, began = [], time.monotonic()
            for part in names:
                home = Path(place, part)
                home.mkdir()
                words = [options.act, str(folder), "--inside", part]
                words += [word for kind in options.skip for word in ("--skip", kind)]
                run = subprocess.Popen(
                    [sys.executable, "-m", "tests.golden", *words],
                    cwd=bootstrap.ROOT,
                    env=environment
                    | {name: str(home) for name in ("HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME")}
                    | {"OPENBLAS_NUM_THREADS": "1", "LC_ALL": "C.UTF-8"},
                )
                runs.append((part, run))
            for _, run in runs:
                failed |= run.wait() != 0
            if names:
                print(f"{', '.join(names)}: {time.monotonic() - began:.0f} s", flush=True)
    print("something differs" if failed else f"{options.act}: done, nothing amiss")
    return int(failed)


def command_line(words: Sequence[str]) -> int:
    """Run ``python3 -m app WORDS`` in this process."""
    from app.commands.cli import main as run

    return run(list(words))


def called(words: Sequence[str]) -> str:
    """What a command prints, on both streams, and its exit status."""
    out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", newline="")
    error = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(error):
        status = command_line(words)
    out.flush()
    printed = out.buffer.getvalue().decode()  # type: ignore[attr-defined]
    return printed if status == 0 else f"{printed}\nexit status {status}: {error.getvalue()}"


class Report:
    """Collects differences by kind, and prints the first of each kind."""

    def __init__(self, part: str, skip: Sequence[str]) -> None:
        self.part, self.skip = part, skip
        self.found: dict[str, list[str]] = collections.defaultdict(list)

    def add(self, kind: str, text: str) -> None:
        self.found[kind].append(text)

    def tell(self, compared: int) -> int:
        """Print all differences; 1 if any of them is not skipped."""
        for kind, texts in self.found.items():
            skipped = " (skipped)" if kind in self.skip else ""
            print(f"{self.part}: {kind}: {len(texts)} differ{skipped}")
            for text in [] if skipped else texts[:SHOWN]:
                print("  " + text.replace("\n", "\n  "))
            if not skipped and len(texts) > SHOWN:
                print(f"  ... and {len(texts) - SHOWN} more")
        wrong = sum(len(texts) for kind, texts in self.found.items() if kind not in self.skip)
        print(f"{self.part}: {wrong} differences in {compared} comparisons", flush=True)
        return int(wrong > 0)


# --------------------------------------------------------------------------- documents


def logarithmic(draw: random.Random, low: float, high: float) -> float:
    return float(f"{math.exp(draw.uniform(math.log(low), math.log(high))):.{draw.choice((2, 9))}g}")


def random_settings(draw: random.Random, scene: str) -> list[str]:
    """``--set`` for every setting of a scene."""
    from app.scenes.phenomena import PHENOMENA
    from tests.support.edits import a_setting

    words = []
    for setting in PHENOMENA[scene].settings if scene in PHENOMENA else ():
        value = a_setting(draw, setting)
        parts = value if isinstance(value, tuple) else (value,)
        text = ",".join(f"{p:.4g}" if isinstance(p, float) else str(p).lower() for p in parts)
        words += ["--set", f"{setting.path}={text}"]
    return words


def random_camera(draw: random.Random) -> dict[str, list[float]]:
    size = logarithmic(draw, 1e-6, 1e9) if draw.random() < 0.25 else 10.0
    eye = [round(draw.uniform(-1, 1), 3) * size for _ in range(3)]
    away = logarithmic(draw, 1e-3, 1e3) if draw.random() < 0.3 else size
    target = [part + round(draw.uniform(-1, 1), 3) * away for part in eye]
    if draw.random() < 0.15:  # along an axis
        target = [eye[0], eye[1], eye[2] - size]
    up = draw.choice(([0, 1, 0], [0, 1, 0], [0, 0, 1], [round(draw.gauss(0, 1), 3) for _ in "xyz"]))
    if draw.random() < 0.08:  # nearly along the view direction
        looks = [t - e for t, e in zip(target, eye, strict=True)]
        up = [part * 0.7 + draw.choice((1e-5, 1e-9)) * draw.gauss(0, size) for part in looks]
    return {"eye": eye, "target": target, "up": up}


def random_lens(draw: random.Random, kind: str) -> tuple[dict[str, Any], list[str]]:
    """A perspective lens, and the ``--set`` options that turn it into one of another kind."""
    near = logarithmic(draw, 1e-6, 1e4) if draw.random() < 0.3 else logarithmic(draw, 0.05, 5)
    ratio = logarithmic(draw, 1.0001, 1e9) if draw.random() < 0.3 else logarithmic(draw, 2, 1000)
    fov = draw.choice((draw.uniform(5, 120), 1e-4, 179.99, 90, logarithmic(draw, 1e-3, 179)))
    far = "inf" if kind in ("perspective", "frustum") and draw.random() < 0.2 else near * ratio
    values = [f"kind={kind}"]
    if kind == "matrix" and draw.random() < 0.7:
        cells = [round(draw.gauss(0, 1), 2) for _ in range(16)]
        if draw.random() < 0.5:  # a projection with one cell changed
            cells = [1.5, 0, 0.1, 0, 0, 2, 0, 0, 0, 0, -1.1, -2.1, 0, 0, -1, 0]
            cells[draw.randrange(16)] += draw.choice((0.5, -0.25, 1.0))
        if draw.random() < 0.1:
            cells[8:12] = cells[12:]  # singular
        values.append(f"clip_from_view={','.join(map(str, cells))}")
    elif kind not in ("perspective", "matrix"):
        values.append(f"keep={draw.choice(('stretch', 'x', 'y'))}")
        if draw.random() < 0.5:  # off the axis
            width = near if kind == "frustum" else logarithmic(draw, 0.01, 100)
            for low, high in (("left", "right"), ("bottom", "top")):
                start = round(draw.uniform(-2, 0.8), 3) * width
                values += [f"{low}={start!r}", f"{high}={start + width * draw.uniform(0.1, 3)!r}"]
    if kind == "oblique":
        for angle in ("alpha_deg", "beta_deg"):
            values.append(f"{angle}={draw.choice((45, 63.4, 90, draw.uniform(5, 175)))}")
    lens = {"kind": "perspective", "fov_y_deg": fov, "near": near, "far": far}
    return lens, [word for value in values for word in ("--set", f"lens.{value}")]


def random_case(number: int) -> dict[str, Any]:
    """A document and the words of its command line; a number always gives the same case."""
    from app.model.projection import DEPTH_RANGES, kinds
    from app.scenes.phenomena import PHENOMENA

    draw = random.Random(f"{SEED}-{number}")
    width, height = draw.choice(((1280, 720), (640, 480), (1, 1), (16384, 3), (101, 977)))
    depth = draw.choice(list(DEPTH_RANGES))
    names, text = list(PHENOMENA), ""
    if number % 4 == 3:
        scene = names[(number // 4) % len(names)]
        words = ["--set", f"scene={scene}", *random_settings(draw, scene)]
        if draw.random() < 0.6:
            words += ["--set", f"depth={depth}", "--set", f"image.width={width}"]
            words += ["--set", f"image.height={height}"]
        if draw.random() < 0.3:
            words += ["--set", f"lens.kind={draw.choice(kinds())}"]
    else:
        lens, changes = random_lens(draw, kinds()[number % len(kinds())])
        words = ["document.json", *changes]
        tree = DOCUMENT | {
            "scene": draw.choice(("letter-f", "cube", "posts")), "camera": random_camera(draw),
            "lens": lens, "depth": depth, "image": {"width": width, "height": height},
        }  # fmt: skip
        text = json.dumps(tree)
        if draw.random() < 0.15:
            words += ["--set", f"lens.near={logarithmic(draw, 0.01, 100)!r}"]
    return {"number": number, "words": words, "document": text}


def random_points(draw: random.Random, matrices: str) -> str:
    """Points in front of, at, beside and behind the eye, and far away, as CSV."""
    import numpy as np

    world = [[draw.uniform(-9, 9) for _ in range(3)] for _ in range(3)]
    world += [[0.0, 0.0, 0.0], [draw.choice((-1, 1)) * 1e12, 3.0, -1e9]]
    try:
        view = np.array(json.loads(matrices)["view_from_world"])
        unit = float(np.linalg.norm(view[:3, 3])) or 1.0
        seen = [(0, 0, 0), (0.3, 0.2, 0), (0.1, 0.2, 0.7), (0, 0, -1), (0.2, -0.1, -1),
                (0.05, 0.3, -1e-7), (3, 4, -5e6), (0.1, 0.1, -3)]  # fmt: skip
        ahead = np.array(seen, float) * unit - view[:3, 3]
        world += np.linalg.solve(view[:3, :3], ahead.T).T.tolist()
    except (ValueError, KeyError, np.linalg.LinAlgError):
        pass
    rows = [",".join(f"{part!r}" for part in point) for point in world if np.isfinite(point).all()]
    return "x,y,z\n" + "\n".join(rows) + "\n"


def outputs_of(case: dict[str, Any]) -> dict[str, str]:
    """What every command and format prints for a case, in a folder of its own."""
    Path("document.json").write_text(case["document"], encoding="utf-8")
    Path("points.csv").write_text(case["points"], encoding="utf-8")
    named = [word for word in case["words"][:1] if word.endswith(".json")]
    options = case["words"][len(named) :]
    found = {}
    for form in ("text", "json", "latex"):
        found[f"matrices {form}"] = called(["matrices", *named, *options, "--format", form])
    for form in ("table", "csv", "json"):
        for precision in ("", "float32", "float64", "exact"):
            words = ["project", *named, "points.csv", *options, "--format", form]
            words += ["--rung", precision] if precision else []
            found[f"project {form} {precision}".strip()] = called(words)
    return found


PREDICTED = re.compile(r'^(computed in .*|"rung": .*)$', re.MULTILINE)


def without_prediction(text: str) -> tuple[str, str]:
    """An output of `project` without the line that predicts its error, and that line."""
    match = PREDICTED.search(text)
    if match is None:
        return text, ""
    return text[: match.start()] + text[match.end() :], match[0]


def first_difference(before: str, now: str) -> str:
    """The first line that differs, before and now."""
    old, new = before.splitlines(), now.splitlines()
    line = next((i for i, (a, b) in enumerate(zip(old, new, strict=False)) if a != b), -1)
    if line < 0:
        line = min(len(old), len(new))
    texts = [rows[line] if line < len(rows) else "(ends)" for rows in (old, new)]
    shortest = min(map(len, texts))
    column = next((i for i in range(shortest) if texts[0][i] != texts[1][i]), shortest)
    begin = max(0, column - 60) if max(map(len, texts)) > 160 else 0
    texts = [text[begin : begin + 160] for text in texts]
    return f"line {line + 1}, column {column + 1}\n  before: {texts[0]}\n  now:    {texts[1]}"


def documents(record: bool, folder: Path, skip: Sequence[str]) -> int:
    """Record or compare what the command line prints of random documents."""
    kept = folder / "documents.jsonl.gz"
    report, compared, refused = Report("documents", skip), 0, 0
    with tempfile.TemporaryDirectory() as place, contextlib.chdir(place):
        if record:
            with gzip.open(kept, "wt", encoding="utf-8") as file:
                for number in range(DOCUMENTS):
                    case = random_case(number) | {"points": ""}
                    Path("document.json").write_text(case["document"], encoding="utf-8")
                    matrices = called(["matrices", *case["words"], "--format", "json"])
                    draw = random.Random(f"{SEED}-points-{number}")
                    case["points"] = random_points(draw, matrices)
                    case["outputs"] = outputs_of(case)
                    refused += "exit status" in matrices
                    file.write(json.dumps(case) + "\n")
            print(f"documents: {DOCUMENTS} recorded, {refused} of them refused in a sentence")
            return 0
        with gzip.open(kept, "rt", encoding="utf-8") as file:
            for line in file:
                case = json.loads(line)
                now = outputs_of(case)
                for kind, before in case["outputs"].items():
                    compared += 1
                    if before == now[kind]:
                        continue
                    shown = f"document {case['number']} ({' '.join(case['words'])}): "
                    old, old_error = without_prediction(before)
                    new, new_error = without_prediction(now[kind])
                    if old_error != new_error:
                        text = f"{kind}: {first_difference(old_error, new_error)}"
                        report.add("predicted error", shown + text)
                    if old != new:
                        report.add(kind, shown + first_difference(old, new))
    return report.tell(compared)


# --------------------------------------------------------------------------- pictures


def states(scene: str) -> list[list[str]]:
    """The options of a scene's three states: as it opens, and two others."""
    draw = random.Random(f"{SEED}-{scene}")
    one = random_settings(draw, scene)
    other = [*random_settings(draw, scene), "--set", "depth=reversed", "--theme", "dark"]
    if not one:
        one = ["--set", "lens.kind=oblique", "--set", "camera.eye=-7,3,6"]
        other = ["--set", "lens.fov_y_deg=80", "--set", "lens.far=inf", "--theme", "dark"]
        other += ["--set", "image.width=500", "--set", "image.height=700"]
    return [[], one, other]


def pictures(record: bool, folder: Path, skip: Sequence[str]) -> int:
    """Record or compare every scene's exported panes."""
    import numpy as np
    from PIL import Image

    from app.scenes.scene import BUILT_IN

    kept, differing = folder / "pictures", folder / "differences"
    listed = folder / "pictures.json"
    report, compared = Report("pictures", skip), 0
    if record:
        kept.mkdir(exist_ok=True)
        cases = {
            f"{scene}-{number}-{pane}": ["--panes", pane, "--size", "400x300",
                                         "--set", f"scene={scene}", *words]
            for scene in BUILT_IN
            for number, words in enumerate(states(scene))
            for pane in ("world", "ndc", "image")
        }  # fmt: skip
        said = {
            name: called(["export", str(kept / f"{name}.png"), *words])
            for name, words in cases.items()
        }
        missing = [f"{name}: {text}" for name, text in said.items() if "exit status" in text]
        print("\n".join([f"pictures: {len(cases)} recorded, {len(missing)} refused", *missing]))
        content = {name: {"words": words, "said": said[name]} for name, words in cases.items()}
        listed.write_text(json.dumps(content, indent=1), encoding="utf-8")
        return 0
    with tempfile.TemporaryDirectory() as place:
        for name, case in json.loads(listed.read_text(encoding="utf-8")).items():
            compared += 1
            pane = name.rpartition("-")[2]
            path = Path(place, f"{name}.png")
            text = called(["export", str(path), *case["words"]])
            if text != case["said"]:
                report.add("what export says", f"{name}: {first_difference(case['said'], text)}")
            if not path.exists():
                continue
            before, now = (
                np.asarray(Image.open(file).convert("RGB")).astype(int)
                for file in (kept / f"{name}.png", path)
            )
            if before.shape != now.shape:
                report.add(pane, f"{name}: was {before.shape}, is {now.shape}")
                continue
            away = np.abs(before - now).max(axis=2)
            if away.any():
                differing.mkdir(exist_ok=True)
                y, x = np.unravel_index(away.argmax(), away.shape)
                panes = [before, np.repeat(255 - away[..., None], 3, axis=2), now]
                side_by_side = np.concatenate(panes, axis=1).astype(np.uint8)
                Image.fromarray(side_by_side).save(differing / f"{name}.png")
                report.add(
                    pane,
                    f"{name}: {(away > 0).sum()} of {away.size} pixels differ, the most by"
                    f" {away.max()} of 255 at x {x}, y {y}: {differing / name}.png",
                )
    return report.tell(compared)


# --------------------------------------------------------------------------- the window


class Window:
    """The window as a user has it: widgets are found by the text on them."""

    def __init__(self, file: Path) -> None:
        from PySide6 import QtCore, QtGui, QtTest, QtWidgets

        self.core, self.gui, self.parts, self.test = QtCore, QtGui, QtWidgets, QtTest.QTest
        self.file = file
        self.window = next(
            widget
            for widget in QtWidgets.QApplication.topLevelWidgets()
            if isinstance(widget, QtWidgets.QMainWindow)
        )
        self.repaints: dict[str, int] = {}
        for name in ("World", "NDC cube", "Image"):
            self.repaints[name] = 0
            drawn = self.canvas(name).render_window
            drawn.AddObserver("EndEvent", lambda *_, name=name: self._drawn(name))

    def canvas(self, name: str) -> Any:
        """The widget that draws a pane: it has the pane's name and VTK's window."""
        until = time.monotonic() + 60.0
        while time.monotonic() < until:  # the window is seen before its panes are filled
            for widget in self.window.findChildren(self.parts.QWidget):
                if widget.accessibleName() == name and hasattr(widget, "render_window"):
                    return widget
            self.parts.QApplication.processEvents()
        raise AssertionError(name)

    def _drawn(self, name: str) -> None:
        self.repaints[name] += 1

    def named(self, widget: Any) -> set[str]:
        """All names that a user may give a widget."""
        names = {widget.accessibleName()}
        if isinstance(widget, (self.parts.QAbstractButton, self.parts.QLabel)):
            names.add(widget.text().replace("&", ""))
        return names

    def find(self, kind: str, name: str) -> Any:
        """The visible widget of a kind of Qt's with a name."""
        found = [
            widget
            for widget in self.window.findChildren(getattr(self.parts, kind))
            if name in self.named(widget) and widget.isVisible()
        ]
        if not found:
            raise LookupError(f"no {kind} named {name!r} is to be seen")
        widget = found[0]
        parent = widget.parentWidget()
        while parent is not None:  # it may have to be scrolled to
            if isinstance(parent, self.parts.QScrollArea):
                parent.ensureWidgetVisible(widget)
            parent = parent.parentWidget()
        self.wait(0)
        return widget

    def wait(self, ms: int) -> None:
        for _ in range(5):
            self.parts.QApplication.processEvents()
        if ms:
            self.test.qWait(ms)

    # -- what a hand does

    def drag(self, name: str, *steps_px: int) -> None:
        """Drag a slider's handle by so many pixels, step by step."""
        slider = self.find("QSlider", f"{name}, slider")
        option = self.parts.QStyleOptionSlider()
        slider.initStyleOption(option)
        style = self.parts.QStyle
        handle = slider.style().subControlRect(
            style.ComplexControl.CC_Slider, option, style.SubControl.SC_SliderHandle, slider
        )
        place = handle.center()
        left = self.core.Qt.MouseButton.LeftButton
        self.test.mousePress(slider, left, pos=place)
        self.wait(0)
        for step in steps_px:
            place = place + self.core.QPoint(step, 0)
            self.move(slider, place, held=True)
        self.test.mouseRelease(slider, left, pos=place)

    def move(self, widget: Any, place: Any, held: bool = False) -> None:
        """Move the mouse, at once, and with a button held if asked."""
        buttons = self.core.Qt.MouseButton
        event = self.gui.QMouseEvent(
            self.core.QEvent.Type.MouseMove,
            self.core.QPointF(place),
            self.core.QPointF(widget.mapToGlobal(place)),
            buttons.NoButton,
            buttons.LeftButton if held else buttons.NoButton,
            self.core.Qt.KeyboardModifier.NoModifier,
        )
        self.parts.QApplication.sendEvent(widget, event)
        self.wait(0)

    def type(self, name: str, text: str) -> None:
        """Type a number into a field, and Enter."""
        field = self.find("QLineEdit", name)
        field.setFocus()
        field.selectAll()
        self.test.keyClicks(field, text)
        self.test.keyClick(field, self.core.Qt.Key.Key_Return)

    def choose(self, name: str, text: str) -> None:
        """Choose from a list."""
        box = self.find("QComboBox", name)
        index = box.findText(text)
        if index < 0:
            raise LookupError(f"{name} offers no {text!r}")
        box.setCurrentIndex(index)
        box.activated.emit(index)

    def press(self, name: str) -> None:
        self.test.mouseClick(
            self.find("QAbstractButton", name), self.core.Qt.MouseButton.LeftButton
        )

    def act(self, text: str) -> None:
        """Choose an action of the menus."""
        actions = self.window.findChildren(self.gui.QAction)
        found = [action for action in actions if action.text().replace("&", "") == text]
        if not found:
            raise LookupError(f"there is no action {text!r}")
        found[0].trigger()

    def place(self, widget: Any, across: float, down: float) -> Any:
        return self.core.QPoint(round(across * widget.width()), round(down * widget.height()))

    def click(self, pane: str, across: float, down: float) -> None:
        canvas = self.canvas(pane)
        self.test.mouseClick(
            canvas, self.core.Qt.MouseButton.LeftButton, pos=self.place(canvas, across, down)
        )

    def swing(
        self, pane: str, x_px: int, y_px: int, start: tuple[float, float] = (0.03, 0.03)
    ) -> None:
        """Drag in a pane, from a place that is given in its width and height."""
        canvas, left = self.canvas(pane), self.core.Qt.MouseButton.LeftButton
        begin = self.place(canvas, *start)
        self.test.mousePress(canvas, left, pos=begin)
        for part in (0.5, 1.0):
            place = begin + self.core.QPoint(round(part * x_px), round(part * y_px))
            self.move(canvas, place, held=True)
        self.test.mouseRelease(canvas, left, pos=place)

    def hover(self, pane: str, across: float, down: float) -> None:
        canvas = self.canvas(pane)
        self.move(canvas, self.place(canvas, across, down))

    def point_at(self, name: str) -> None:
        """Move the mouse onto the row of a name, as Qt tells it."""
        row = self.find("QLabel", name).parentWidget()
        middle = self.core.QPointF(row.rect().center())
        everywhere = self.core.QPointF(row.mapToGlobal(row.rect().center()))
        self.parts.QApplication.sendEvent(row, self.gui.QEnterEvent(middle, middle, everywhere))

    def leave(self, name: str) -> None:
        row = self.find("QLabel", name).parentWidget()
        self.parts.QApplication.sendEvent(row, self.core.QEvent(self.core.QEvent.Type.Leave))

    def set_first(self) -> None:
        """Move the first slider of the scene's own settings, and step through its first list."""
        region = next(w for w in self._visible(self.window) if type(w).__name__ == "SceneCard")
        for slider in region.findChildren(self.parts.QSlider):
            if slider.isVisible() and slider.isEnabled():
                self.drag(slider.accessibleName().removesuffix(", slider"), 4, 3)
                break
        for box in region.findChildren(self.parts.QComboBox):
            if box.isVisible() and box.isEnabled():
                self.key("QComboBox", box.accessibleName(), "Down")
                break

    def key(self, kind: str, name: str, key: str) -> None:
        widget = self.find(kind, name)
        widget.setFocus()
        self.test.keyClick(widget, getattr(self.core.Qt.Key, f"Key_{key}"))

    def stage(self, value: int) -> None:
        """Move the strip's slider, as a screen reader does."""
        self.find("QSlider", "Stage").setValue(value)

    # -- what is seen

    def seen(self) -> dict[str, Any]:
        """The document, all text in the window, and the repaints since the last time."""
        status = self.window.status
        lines = sorted(self._texts(set(status.findChildren(self.parts.QWidget))))
        line = [text for w in self._visible(status) for text in self._said(w)]
        actions = {
            action.text().replace("&", "")
            for action in self.window.findChildren(self.gui.QAction)
            if action.isEnabled() and action.text() and not action.menu()
        }
        repaints = dict(self.repaints)
        title = self.window.windowTitle(), self.window.isWindowModified()
        self.act("Save")
        self.wait(0)
        found = {
            "document": self.file.read_text(encoding="utf-8"),
            "status line": line,
            "texts": lines,
            "actions": sorted(text.replace(str(self.file.parent), "HOME") for text in actions),
            "title": list(title),
            "repaints": repaints,
            "repaints of saving": {n: self.repaints[n] - repaints[n] for n in self.repaints},
        }
        self.repaints |= dict.fromkeys(self.repaints, 0)
        return found

    def _visible(self, inside: Any) -> list[Any]:
        return [w for w in inside.findChildren(self.parts.QWidget) if w.isVisible()]

    def _texts(self, but: set[Any]) -> Iterator[str]:
        for widget in self._visible(self.window):
            if widget not in but:
                yield from self._said(widget)

    def _said(self, widget: Any) -> Iterator[str]:
        """The text of a widget with its name, line by line."""
        parts, name = self.parts, widget.accessibleName()
        if isinstance(widget, parts.QAbstractItemView):
            model, root = widget.model(), self.core.QModelIndex()
            is_list = isinstance(widget, parts.QListView)
            columns = range(1 if is_list else model.columnCount(root))
            for row in range(model.rowCount(root)):
                cells = [str(model.index(row, column).data() or "") for column in columns]
                yield f"{name}: {' | '.join(cells)}"
        elif isinstance(widget, parts.QComboBox):
            yield f"{name}: {widget.currentText()}"
        elif isinstance(widget, parts.QAbstractSlider):
            if name:  # no scroll bars
                yield f"{name}: {widget.value()}"
        elif isinstance(widget, parts.QAbstractButton):
            text = widget.text().replace("&", "")
            if text or name:
                marks = " checked" * widget.isChecked() + " disabled" * (not widget.isEnabled())
                yield f"[{name or text}]{marks} {text}"
        elif isinstance(widget, (parts.QLabel, parts.QLineEdit)):
            if widget.text():
                yield f"{name}: {widget.text()}" if name else widget.text()
        elif name and widget.accessibleDescription():  # such as a matrix: the cell under the cursor
            yield f"{name}: {widget.accessibleDescription()}"

    def matrices(self) -> str:
        """All that the Matrices panel shows, as its own button copies it."""
        button = self.find("QToolButton", "Copy all matrices")
        button.menu().actions()[0].trigger()
        return str(self.parts.QApplication.clipboard().text())


def script(user: Window) -> Iterator[tuple[str, Callable[[], object]]]:
    """A quarter of an hour's work: each step's name and action, in order."""
    yield "opens", lambda: None
    yield "idle", lambda: user.wait(700)
    yield "drag fov", lambda: user.drag("Field of view", 3, 4, -2)
    yield "drag near", lambda: user.drag("Near", -5, -5)
    yield "drag far", lambda: user.drag("Far", -12, 4)
    yield "type fov", lambda: user.type("Field of view (degrees)", "60,5")
    yield "type near", lambda: user.type("Near (world units)", "0.25")
    yield "type near beyond far", lambda: user.type("Near (world units)", "1e9")
    yield "type near again", lambda: user.type("Near (world units)", "0.5")
    yield "type far inf", lambda: user.type("Far (world units)", "inf")
    yield "undo", lambda: user.act("Undo")
    yield "undo twice", lambda: (user.act("Undo"), user.act("Undo"))
    yield "redo", lambda: user.act("Redo")
    for section in ("Image and depth range", "More of the lens"):
        yield f"unfold {section}", lambda section=section: user.press(section)
    yield "direct3d", lambda: user.choose("NDC z", "Direct3D: 0 to 1")
    yield "reversed", lambda: user.choose("NDC z", "reversed: 1 to 0")
    yield "4:3", lambda: user.press("Aspect: 4:3")
    for panel in ("Matrices", "Camera frame", "Probe", "Explanation and diagrams", "Precision"):
        yield f"open {panel}", lambda panel=panel: user.press(panel)
    yield "fold Precision", lambda: user.press("Precision")
    yield "open Matrices again", lambda: user.press("Matrices")
    yield "drag fov with matrices", lambda: user.drag("Field of view", -6, 2)
    yield "formulas", lambda: user.choose("Cells", "Formulas")
    yield "row vectors", lambda: user.choose("Vectors", "Row vectors")
    for lens in (OFF_AXIS, "orthographic", "oblique", "perspective"):
        yield f"lens {lens}", lambda lens=lens: user.choose("Lens", lens)
    yield "lens frustum again", lambda: user.choose("Lens", OFF_AXIS)
    yield "type left", lambda: user.type("Left (world units)", "-0.2")
    yield "keep x", lambda: user.key("QComboBox", "Proportions", "Down")
    yield "drag right", lambda: user.drag("Right", 4)
    yield "undo the drag", lambda: user.act("Undo")
    yield "perspective again", lambda: user.choose("Lens", "perspective")
    yield "open the frame", lambda: user.press("Camera frame")
    yield "next step", lambda: user.press("The next step")
    yield "and next", lambda: user.press("The next step")
    yield "nudge up", lambda: user.find("QPushButton", "Nudge up by 0.1° to the side").click()
    yield "all steps", lambda: user.press("All steps at once")
    yield "open the probe", lambda: user.press("Probe")
    yield "pick in the image", lambda: user.click("Image", 0.5, 0.5)
    yield "pick in the world", lambda: user.click("World", 0.45, 0.55)
    yield "pin", lambda: user.find("QPushButton", "Pin").click()
    yield "pick in the cube", lambda: user.click("NDC cube", 0.5, 0.5)
    yield "type x", lambda: user.type("Probe, world x", "0.75")
    yield "drag fov with probes", lambda: user.drag("Field of view", 3)
    yield "azimuth", lambda: user.drag("Azimuth", 5)
    yield "distance", lambda: user.type("Distance (world units)", "14")
    yield "stage: view", lambda: user.stage(240)
    yield "stage: between", lambda: user.stage(400)
    yield "drag near between stages", lambda: user.drag("Near", 3)
    yield "stage: image", lambda: user.stage(1200)
    yield "stage: NDC", lambda: user.stage(960)
    yield "point at near", lambda: user.point_at("Near")
    yield "leave near", lambda: user.leave("Near")
    yield "hover in the world", lambda: user.hover("World", 0.5, 0.5)
    yield "hover in the cube", lambda: user.hover("NDC cube", 0.5, 0.5)
    yield "hover in the image", lambda: user.hover("Image", 0.5, 0.5)
    yield "turn the world", lambda: user.swing("World", 60, 20)
    yield "turn the cube", lambda: user.swing("NDC cube", -40, 15)
    yield "move in the image", lambda: user.swing("Image", 30, 10, (0.4, 0.4))
    yield "drag in the world", lambda: user.swing("World", 25, 5, (0.5, 0.5))
    yield "views back", lambda: user.act("Reset the panes' own views")
    yield "enlarge the image", lambda: user.act("Image in large")
    yield "drag fov in a hidden row", lambda: user.drag("Field of view", 5)
    yield "all panes", lambda: user.act("Back to all panes")
    yield "present", lambda: user.act("Present")
    yield "present no more", lambda: user.act("Present")
    yield "dark", lambda: user.act("Dark")
    yield "light", lambda: user.act("Light")
    for scene in ("Unit cube", "Row of posts"):
        yield scene, lambda scene=scene: user.choose("Scene", scene)
    box = user.find("QComboBox", "Scene")
    titles = [box.itemText(i) for i in range(box.count()) if box.itemText(i)]
    for scene in titles[3:]:
        yield scene, lambda scene=scene: user.choose("Scene", scene)
        yield f"{scene}: settings", user.set_first
        yield f"{scene}: near", lambda: user.drag("Near", 4)
    yield "reset", lambda: user.act("Reset all")
    yield "undo the reset", lambda: user.act("Undo")


OFF_AXIS = "frustum (off-axis)"
LAID_OUT = ("enlarge the image", "all panes", "present", "present no more")
"""Steps at which Qt lays out the window as often as it can: only whether a pane repaints counts."""
REST_MS = 450
"""Time after which no timer is pending: the window counts pixels after 250 ms."""


def run_window() -> list[dict[str, Any]]:
    """Open the window by the command line, and run the script in it."""
    steps: list[dict[str, Any]] = []
    file = Path(os.environ["HOME"]) / "golden.json"
    file.write_text(json.dumps(DOCUMENT), encoding="utf-8")

    def work(*_: object) -> int:
        user = Window(file)
        user.wait(REST_MS)
        for name, act in script(user):
            step: dict[str, Any] = {"action": name}
            try:
                act()
            except LookupError as error:
                step["failed"] = str(error)
            user.wait(REST_MS)
            steps.append(step | user.seen())
            if name in LAID_OUT:
                found = steps[-1]["repaints"]
                steps[-1]["repaints"] = {pane: count > 0 for pane, count in found.items()}
            if name.startswith(("open Matrices", "formulas", "row", "lens", "type left", "keep")):
                steps[-1]["matrices"] = user.matrices()
        user.window.close()
        user.wait(0)
        return 0

    from PySide6.QtWidgets import QApplication

    QApplication.exec = staticmethod(work)  # type: ignore[method-assign]
    status = command_line([str(file), "--size", "1366x768", "--theme", "light"])
    if status != 0 or not steps:
        raise SystemExit(f"window: exit status {status}")
    return steps


def window(record: bool, folder: Path, skip: Sequence[str]) -> int:
    """Record or compare a fixed script of a user's actions."""
    kept = folder / "window.json"
    steps = run_window()
    if record:
        kept.write_text(json.dumps(steps, indent=1, ensure_ascii=False), encoding="utf-8")
        print(f"window: {len(steps)} actions recorded")
        for step in steps:
            if "failed" in step:
                print(f"  {step['action']}: {step['failed']}")
        return 0
    report, compared = Report("window", skip), 0
    now = {step["action"]: step for step in steps}
    for before in json.loads(kept.read_text(encoding="utf-8")):
        action = before.pop("action")
        after = now.get(action)
        if after is None:
            report.add("actions", f"{action!r} is no longer done")
            continue
        for kind in {**before, **after}:
            if kind == "action":
                continue
            compared += 1
            old, new = before.get(kind), after.get(kind)
            if old != new:
                report.add(kind, f"after {action!r}: {told(old, new)}")
    return report.tell(compared)


def told(old: Any, new: Any) -> str:
    """What differs, in a line or a few."""
    if isinstance(old, str) and isinstance(new, str):
        return first_difference(old, new)
    if isinstance(old, dict) and isinstance(new, dict):
        names = [name for name in {**old, **new} if old.get(name) != new.get(name)]
        return "; ".join(f"{name}: {old.get(name)} before, {new.get(name)} now" for name in names)
    if isinstance(old, list) and isinstance(new, list):
        gone, come = ([str(x) for x in a if x not in b] for a, b in ((old, new), (new, old)))
        lines = [f"before: {x}" for x in gone[:4]] + [f"now:    {x}" for x in come[:4]]
        more = max(0, len(gone) - 4) + max(0, len(come) - 4)
        return "\n  ".join(["", *lines, *([f"... {more} more"] if more else [])]) or "another order"
    return f"{old!r} before, {new!r} now"


INSIDE: dict[str, Callable[[bool, Path, Sequence[str]], int]] = {
    "documents": documents,
    "pictures": pictures,
    "window": window,
}

if __name__ == "__main__":
    sys.exit(main())
