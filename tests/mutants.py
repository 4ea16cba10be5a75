"""``python3 -m tests.mutants check [ID...]``: does a test notice when the program is wrong?

``tests/mutants.json`` holds small mistakes, each a line of the source, old and new. The tool finds
the file by the old line, which is unique in `app` and `widgets`, so that files may move; it makes
the mistake in a copy of the tree, never in the tree, and runs the tests that are known to notice.
Of each it says *killed*, *survived*, *lost* (the line is not there any more, or twice: write it
anew), *no test* (those that are named are gone: `record`) or *too long*. The exit status is 1 if
one survives that was killed before, and for all but killed and known to survive.

``record [ID...]`` looks for the tests that notice: it runs the files of ``tests`` up to the first
failure and writes that test down as ``killed_by``, or ``survives`` with the commit. ``list`` prints
all, and what is not unique. No part of the suite.
"""

from __future__ import annotations

import compileall
import concurrent.futures
import contextlib
import json
import os
import py_compile
import queue
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from app import bootstrap
from tests.support.tools import ToolParser

LIST = Path(__file__).with_suffix(".json")
SOURCES = ("app", "widgets")
LONGEST_S = 600
"""A run that takes longer tells nothing: the program hangs, or the machine has other work."""


def main(words: Sequence[str]) -> int:
    """Set up as the tests do, and do what is asked in as many copies as there are jobs."""
    parser = ToolParser("mutants", __doc__)
    parser.add_argument("act", choices=("check", "record", "list"))
    parser.add_argument("ids", nargs="*", metavar="ID")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_intermixed_args(words)
    mutants = json.loads(LIST.read_text(encoding="utf-8"))
    by_id = {mutant["id"]: mutant for mutant in mutants}
    for name in options.ids:
        if name not in by_id:
            parser.error(f"there is no mutant {name}")
    chosen = [by_id[name] for name in options.ids] or mutants
    if options.act == "list":
        lost = [mutant for mutant in chosen if place_of(mutant) is None]
        for mutant in chosen:
            state = "lost" if mutant in lost else _state(mutant)
            print(f"{mutant['id']:<28} {state:<10} {mutant['meaning']}")
        print(f"{len(chosen)} mutants, {len(lost)} lost")
        return int(bool(lost))
    bootstrap.start("tests", extras=("test",))
    verdicts = {}
    with copies(options.jobs) as free, concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:

        def tried(mutant: dict[str, Any]) -> tuple[str, str]:
            copy = free.get()
            try:
                return copy.verdict(mutant, anew=options.act == "record")
            finally:
                free.put(copy)

        runs = {pool.submit(tried, mutant): mutant for mutant in chosen}
        for run in concurrent.futures.as_completed(runs):
            mutant, (verdict, by) = runs[run], run.result()
            verdicts[mutant["id"]] = verdict
            print(f"{mutant['id']:<28} {verdict:<10} {by or mutant['meaning']}", flush=True)
            if options.act == "record" and verdict in ("killed", "survived"):
                for field in ("killed_by", "survives", "since"):
                    mutant.pop(field, None)
                mutant |= {"killed_by": by} if verdict == "killed" else _survivor()
                write(mutants)
    counts = {name: list(verdicts.values()).count(name) for name in VERDICTS}
    print(", ".join(f"{count} {name}" for name, count in counts.items()))
    holes = [m["id"] for m in chosen if verdicts[m["id"]] == "survived" and not m.get("survives")]
    if options.act == "check" and holes:
        print(f"survive although they were killed before: {', '.join(holes)}")
    unknown = len(chosen) - counts["killed"] - counts["survived"]
    return int(options.act == "check" and bool(holes or unknown))


VERDICTS = ("killed", "survived", "lost", "no test", "too long")


def _state(mutant: dict[str, Any]) -> str:
    return "survives" if mutant.get("survives") else "killed" if mutant.get("killed_by") else "new"


def _survivor() -> dict[str, Any]:
    command = ["git", "rev-parse", "--short", "HEAD"]
    said = subprocess.run(command, cwd=bootstrap.ROOT, capture_output=True, text=True)
    return {"survives": True, "since": said.stdout.strip()}


def write(mutants: list[dict[str, Any]]) -> None:
    text = json.dumps(mutants, indent=1, ensure_ascii=False) + "\n"
    LIST.write_text(text, encoding="utf-8")


def place_of(mutant: dict[str, Any], root: Path = bootstrap.ROOT) -> Path | None:
    """The only file that has the mutant's old line, once; None if there is none, or several."""
    found = [
        (path, text.count(mutant["old"]))
        for source in SOURCES
        for path in sorted((root / source).rglob("*.*"))
        if path.suffix in (".py", ".md")
        if mutant["old"] in (text := path.read_text(encoding="utf-8"))
    ]
    return found[0][0] if len(found) == 1 and found[0][1] == 1 else None


@contextlib.contextmanager
def copies(count: int) -> Iterator[queue.Queue[Copy]]:
    """Yield copies of the tree that are free to be mutated, each with a screen of its own."""
    from tests.__main__ import screens

    free: queue.Queue[Copy] = queue.Queue()
    with contextlib.ExitStack() as stack:
        for _ in range(count):
            folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
            environment = stack.enter_context(screens(1))
            free.put(Copy(folder / "tree", environment))
        yield free


class Copy:
    """A copy of the tree."""

    def __init__(self, folder: Path, environment: dict[str, str]) -> None:
        self.folder = folder
        self.environment = environment
        left_out = shutil.ignore_patterns(".git", ".venv", "__pycache__", ".*_cache", ".hypothesis")
        shutil.copytree(bootstrap.ROOT, folder, ignore=left_out)
        # By its hash: a mistake of the same length, made within a second, would not be seen.
        by_hash = py_compile.PycInvalidationMode.CHECKED_HASH
        for source in SOURCES:
            compileall.compile_dir(folder / source, quiet=1, invalidation_mode=by_hash)

    def verdict(self, mutant: dict[str, Any], *, anew: bool) -> tuple[str, str]:
        """What becomes of a mutant, and the test that notices."""
        path = place_of(mutant, self.folder)
        if path is None:
            return "lost", ""
        known = mutant.get("killed_by")
        tests = mutant["tests"] if anew or not known else [shlex.quote(known)]
        runs = [words for test in tests if (words := self._found(shlex.split(test)))]
        text = path.read_text(encoding="utf-8")
        path.write_text(text.replace(mutant["old"], mutant["new"]), encoding="utf-8")
        verdict, by = "no test", ""
        try:
            for words in runs:
                verdict, by = self._run(words)
                if verdict == "killed":
                    break
        finally:
            path.write_text(text, encoding="utf-8")
        return verdict, by

    def _found(self, words: list[str]) -> list[str]:
        """Words for pytest; the first is a file or a test, looked for: they move."""
        file, colons, name = words[0].partition("::")
        if (self.folder / file).exists():
            return words
        function = re.match(r"\w+", name.rpartition("::")[2])
        for path in (self.folder / "tests").rglob("test_*.py") if colons and function else ():
            if f"def {function[0]}(" in path.read_text(encoding="utf-8"):
                return [f"{path.relative_to(self.folder).as_posix()}::{name}", *words[1:]]
        return []

    def _run(self, words: list[str]) -> tuple[str, str]:
        command = [sys.executable, "-m", "pytest", "-x", "-q", "--tb=no", "-p", "no:cacheprovider"]
        try:
            run = subprocess.run(
                [*command, "-rfE", *words], cwd=self.folder, env=self.environment, text=True,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=LONGEST_S,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return "too long", ""
        failed = re.findall(r"^(?:FAILED|ERROR) (tests/.*?)(?: - .*)?$", run.stdout, re.MULTILINE)
        if run.returncode == 0:
            return "survived", ""
        return ("killed", failed[0]) if run.returncode in (1, 2) and failed else ("no test", "")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
