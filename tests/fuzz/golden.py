"""``python3 -m tests.fuzz golden record FOLDER`` and ``compare FOLDER``: are all outputs as before?

Use it around a change that must not change behaviour. `record` keeps the command line's output for
300 random documents, a picture of every scene's panes, and the state of the window after each step
of a fixed script of user actions. `compare` repeats all that, reports the differences, and ends
with status 1 if there are any. It uses only what is stable: command lines, documents, pictures, and
what a user sees in the window. `compare` reads the cases from the recording, so that this file may
change in between. Only `command_line` and `tests.fuzz.window` know the program's inside.

``--only PART`` does one part. ``--skip KIND``, which may be repeated, ignores a kind of difference
that is intended, such as ``"predicted error"`` or ``"matrices text"``; the report names the kinds.
``FOLDER/differences`` gets a picture of every difference between pictures.

This is no part of the suite. The command line runs in this process, because 300 documents as
processes would take an hour.
"""

import argparse
import collections
import contextlib
import gzip
import io
import json
import random
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from app.commands.cli import main as run_command
from app.model.projection import kinds
from app.scenes.phenomena import PHENOMENA
from app.scenes.scene import BUILT_IN
from tests.__main__ import screens
from tests.fuzz.catalogue import PLAIN_SCENES, a_valid_tree, settings_in_words, some_points
from tests.support.tools import ToolParser

DOCUMENTS = 300
SEED = 17
SHOWN = 12
"""Differences of a kind that are shown in full."""


def main(words: Sequence[str]) -> int:
    """Run each part in a process; the window runs alone, because it draws differently if late."""
    parser = ToolParser("fuzz golden", __doc__)
    parser.add_argument("act", choices=("record", "compare"))
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", choices=PARTS, action="append", help="may be repeated")
    parser.add_argument("--skip", action="append", default=[], metavar="KIND")
    parser.add_argument("--inside", choices=PARTS, help=argparse.SUPPRESS)
    options = parser.parse_args(words)
    folder = options.folder.resolve()
    if options.inside:
        return PARTS[options.inside](options.act == "record", folder, options.skip)
    if options.act == "record":
        folder.mkdir(parents=True, exist_ok=True)
    elif not folder.is_dir():
        parser.error(f"there is no recording {options.folder}")
    failed = False
    with screens(1) as environment, tempfile.TemporaryDirectory() as place:
        for together in (("documents", "pictures"), ("window",)):
            began, runs = time.monotonic(), []
            for part in [part for part in together if part in (options.only or PARTS)]:
                home = Path(place, part)
                home.mkdir()
                inside = [*words, "--inside", part]
                own = dict.fromkeys(("HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"), str(home))
                run = subprocess.Popen(
                    [sys.executable, "-m", "tests.fuzz", "golden", *inside],
                    env=environment | own | {"LC_ALL": "C.UTF-8"},
                )
                runs.append(run)
            failed |= sum(run.wait() != 0 for run in runs) > 0
            if runs:
                print(f"{', '.join(together)}: {time.monotonic() - began:.0f} s", flush=True)
    print("something differs" if failed else f"{options.act}: done, nothing amiss")
    return int(failed)


def command_line(words: Sequence[str]) -> str:
    """What ``python3 -m app WORDS`` prints on both streams, and its exit status unless it is 0."""
    out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", newline="")
    error = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(error):
        status = run_command(list(words))
    out.flush()
    printed = out.buffer.getvalue().decode()  # type: ignore[attr-defined]
    return printed if status == 0 else f"{printed}\nexit status {status}: {error.getvalue()}"


class Report:
    """Collects differences by kind, and prints the first of each kind."""

    def __init__(self, part: str, skip: Sequence[str]) -> None:
        self.part, self.skip = part, skip
        self.compared = 0
        self.differences: dict[str, list[str]] = collections.defaultdict(list)

    def compare(self, kind: str, name: str, before: Any, now: Any) -> None:
        """Count a comparison, and keep what differs."""
        self.compared += 1
        if before != now:
            self.differences[kind].append(f"{name}: {difference(before, now)}")

    def tell(self) -> int:
        """Print all differences; 1 if any of them is not skipped."""
        wrong = 0
        for kind, texts in self.differences.items():
            is_skipped = kind in self.skip
            print(f"{self.part}: {kind}: {len(texts)} differ{' (skipped)' * is_skipped}")
            if is_skipped:
                continue
            wrong += len(texts)
            for text in texts[:SHOWN]:
                print("  " + text.replace("\n", "\n  "))
            if len(texts) > SHOWN:
                print(f"  ... and {len(texts) - SHOWN} more")
        print(f"{self.part}: {wrong} differences in {self.compared} comparisons", flush=True)
        return int(wrong > 0)


def difference(old: Any, new: Any) -> str:
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


# --------------------------------------------------------------------------- documents


def random_case(number: int) -> dict[str, Any]:
    """A document, the words of its command line, and points: always the same for a number."""
    rng = random.Random(f"{SEED}-{number}")
    if number % 4 == 3:
        scene = list(PHENOMENA)[(number // 4) % len(PHENOMENA)]
        tree = {}
        words = ["--set", f"scene={scene}", *settings_in_words(rng, scene)]
    else:
        tree = a_valid_tree(rng) | {"scene": rng.choice(PLAIN_SCENES)}
        words = ["document.json"]
    if rng.random() < 0.3:
        words += ["--set", f"lens.kind={rng.choice(kinds())}"]
    if rng.random() < 0.15:
        words += ["--set", f"lens.near={rng.uniform(0.01, 100.0)!r}"]
    Path("document.json").write_text(document := json.dumps(tree), encoding="utf-8")
    try:
        matrices = json.loads(command_line(["matrices", *words, "--format", "json"]))
        view_from_world = np.array(matrices["view_from_world"])
    except ValueError:  # it is refused
        view_from_world = None
    rows = [",".join(map(repr, point)) for point in some_points(rng, view_from_world)]
    points = "x,y,z\n" + "\n".join(rows) + "\n"
    return {"number": number, "words": words, "document": document, "points": points}


def outputs_of(case: dict[str, Any]) -> dict[str, str]:
    """What every command and format prints for a case, in a folder of its own."""
    Path("document.json").write_text(case["document"], encoding="utf-8")
    Path("points.csv").write_text(case["points"], encoding="utf-8")
    named = [word for word in case["words"][:1] if word.endswith(".json")]
    options = case["words"][len(named) :]
    found = {}
    for form in ("text", "json", "latex"):
        found[f"matrices {form}"] = command_line(["matrices", *named, *options, "--format", form])
    for form in ("table", "csv", "json"):
        for precision in ("", "float32", "float64", "exact"):
            words = ["project", *named, "points.csv", *options, "--format", form]
            words += ["--rung", precision] if precision else []
            found[f"project {form} {precision}".strip()] = command_line(words)
    return found


PREDICTED = re.compile(r'^(computed in .*|"rung": .*)$', re.MULTILINE)
"""The line of `project` that predicts its error."""


def documents(record: bool, folder: Path, skip: Sequence[str]) -> int:
    """Record or compare what the command line prints of random documents."""
    kept = folder / "documents.jsonl.gz"
    report = Report("documents", skip)
    with tempfile.TemporaryDirectory() as place, contextlib.chdir(place):
        if record:
            with gzip.open(kept, "wt", encoding="utf-8") as file:
                for case in map(random_case, range(DOCUMENTS)):
                    file.write(json.dumps(case | {"outputs": outputs_of(case)}) + "\n")
            print(f"documents: {DOCUMENTS} recorded")
            return 0
        with gzip.open(kept, "rt", encoding="utf-8") as file:
            for case in map(json.loads, file):
                name = f"document {case['number']} ({' '.join(case['words'])})"
                now = outputs_of(case)
                for kind, before in case["outputs"].items():
                    old, new = (PREDICTED.search(text) for text in (before, now[kind]))
                    said = old[0] if old else "", new[0] if new else ""
                    report.compare("predicted error", f"{name}: {kind}", *said)
                    old, new = (PREDICTED.sub("", text, count=1) for text in (before, now[kind]))
                    report.compare(kind, name, old, new)
    return report.tell()


# --------------------------------------------------------------------------- pictures


def states(scene: str) -> list[list[str]]:
    """The options of a scene's three states: as it opens, and two others."""
    rng = random.Random(f"{SEED}-{scene}")
    one = settings_in_words(rng, scene) or [
        "--set",
        "lens.kind=oblique",
        "--set",
        "camera.eye=-7,3,6",
    ]
    other = [*settings_in_words(rng, scene), "--set", "depth=reversed", "--palette", "dark"]
    return [[], one, [*other, "--set", "image.width=500", "--set", "image.height=700"]]


def pictures(record: bool, folder: Path, skip: Sequence[str]) -> int:
    """Record or compare every scene's exported panes."""
    kept, listed = folder / "pictures", folder / "pictures.json"
    if record:
        kept.mkdir(exist_ok=True)
        cases = {}
        for scene in BUILT_IN:
            for number, state in enumerate(states(scene)):
                for pane in ("world", "ndc", "image"):
                    name = f"{scene}-{number}-{pane}"
                    words = [
                        "--panes",
                        pane,
                        "--size",
                        "400x300",
                        "--set",
                        f"scene={scene}",
                        *state,
                    ]
                    said = command_line(["export", str(kept / f"{name}.png"), *words])
                    cases[name] = {"words": words, "said": said}
        missing = [
            f"{name}: {case['said']}"
            for name, case in cases.items()
            if "exit status" in case["said"]
        ]
        print("\n".join([f"pictures: {len(cases)} recorded, {len(missing)} refused", *missing]))
        listed.write_text(json.dumps(cases, indent=1), encoding="utf-8")
        return 0
    report = Report("pictures", skip)
    with tempfile.TemporaryDirectory() as place:
        for name, case in json.loads(listed.read_text(encoding="utf-8")).items():
            path = Path(place, f"{name}.png")
            said = command_line(["export", str(path), *case["words"]])
            report.compare("what export says", name, case["said"], said)
            if path.exists():
                compared = compare_pictures(
                    kept / path.name, path, folder / "differences" / path.name
                )
                report.compare(name.rpartition("-")[2], name, "as before", compared)
    return report.tell()


def compare_pictures(before: Path, now: Path, shown: Path) -> str:
    """ "as before", or what differs between two pictures; `shown` gets them side by side then."""
    old, new = (np.asarray(Image.open(path).convert("RGB")).astype(int) for path in (before, now))
    if old.shape != new.shape:
        return f"was {old.shape}, is {new.shape}"
    away = np.abs(old - new).max(axis=2)
    if not away.any():
        return "as before"
    shown.parent.mkdir(exist_ok=True)
    y, x = np.unravel_index(away.argmax(), away.shape)
    side_by_side = np.concatenate([old, np.repeat(255 - away[..., None], 3, axis=2), new], axis=1)
    Image.fromarray(side_by_side.astype(np.uint8)).save(shown)
    return (
        f"{(away > 0).sum()} of {away.size} pixels differ, the most by {away.max()} of 255"
        f" at x {x}, y {y}: {shown}"
    )


# --------------------------------------------------------------------------- the window


def window(record: bool, folder: Path, skip: Sequence[str]) -> int:
    """Record or compare a fixed script of a user's actions."""
    from tests.fuzz.window import run_script

    kept = folder / "window.json"
    steps = run_script()
    if record:
        kept.write_text(json.dumps(steps, indent=1, ensure_ascii=False), encoding="utf-8")
        print(f"window: {len(steps)} actions recorded")
        for step in steps:
            if "failed" in step:
                print(f"  {step['action']}: {step['failed']}")
        return 0
    report = Report("window", skip)
    now = {step["action"]: step for step in steps}
    for before in json.loads(kept.read_text(encoding="utf-8")):
        action = before["action"]
        report.compare("actions", action, "is done", "is done" if action in now else "is missing")
        after = now.get(action, before)
        for kind in {**before, **after}:
            report.compare(kind, f"after {action!r}", before.get(kind), after.get(kind))
    return report.tell()


PARTS: dict[str, Callable[[bool, Path, Sequence[str]], int]] = {
    "documents": documents,
    "pictures": pictures,
    "window": window,
}
