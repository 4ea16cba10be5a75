"""The record: every answer of a student on this machine, and the statistics over them.

::

    an answer -> Record.add: one line of JSON at the end of a file
    Record.read -> standings: each exercise as it was last solved, and when it is due again
                -> ideas_met: the wrong ideas behind the answers

The record says what happened. Where a student stands in a lesson, and what is shown there, is
`Progress`, which "Begin again" deletes; the record stays.
"""

import contextlib
import json
import os
import stat
import time
import unicodedata
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from datetime import date, timedelta
from pathlib import Path
from statistics import median
from typing import Any, NamedTuple

from app.document.files import blamed_on
from app.languages import said
from app.lessons.blocks.exercise import LARGEST_SEED
from app.model.refusal import REFUSALS, Refusal
from app.strangers import decode, open_regular

RIGHT, WRONG, SHOWN = "right", "wrong", "shown"  # the verdicts
ALONE, HELPED = "alone", "helped"
"""How an exercise was solved, besides `SHOWN`: at the first try without a hint, or otherwise."""
MINUTES_EACH = 2.0  # how long an exercise takes, until the record has `TIMED` of them
TIMED, PAUSE_S = 5, 600
"""Least number of timed exercises, and what is no work any more but a pause, in seconds."""
AGAIN_AFTER_DAYS = 1, 3, 7  # after how many days an exercise that was not solved alone comes back
LARGEST = 2 * 2**20  # size in bytes from which the file becomes the old one; about 10 000 answers
LONGEST_TYPED, LONGEST_NAME = 2000, 1000
LATEST = 2**34  # in seconds since 1970; a later time is a mistake


class Attempt(NamedTuple):
    """An answer to a question of a lesson."""

    when: int  # seconds since 1970
    lesson: str  # a lesson's own name, or the path of its file
    exercise: str  # ``step/block``
    seed: int  # the variant of an exercise; 0 for a question whose numbers never change
    typed: str  # the answer, as a sample in a ``test`` block
    verdict: str  # `RIGHT`, `WRONG` or `SHOWN`
    idea: str = ""  # name of the wrong idea behind it; empty if it has none
    hints: int = 0  # the number of hints that were read before
    is_test: bool | None = None
    """Whether it was given in a test, which has no hints; None if an older program wrote it."""

    @property
    def key(self) -> tuple[str, str]:
        """Return the question's lesson and ``step/block``."""
        return self.lesson, self.exercise


def now_s() -> int:
    """Return the seconds since 1970; for a clock that is far off the nearest time of an attempt."""
    return max(0, min(int(time.time()), LATEST))


def attempt_from(tree: object) -> Attempt:
    """Read an attempt from JSON, perhaps a stranger's; a `Refusal` names the faulty field."""
    if not isinstance(tree, dict):
        raise Refusal.in_document(REFUSALS["an-attempt"], field="attempt")
    values: dict[str, Any] = {}
    for name in Attempt._fields:
        if name in tree:
            values[name] = _checked(name, tree[name])
        elif name not in Attempt._field_defaults:
            raise Refusal.in_document(REFUSALS["an-attempt"], field=name)
    return Attempt(**values)


_LARGEST_OF = {"when": LATEST, "seed": LARGEST_SEED, "hints": 100}
_FARTHEST = 40  # how far a review's seed is at most from one that was seen; a test draws any seed


def _checked(name: str, value: object) -> object:
    if name == "is_test":
        if value is not None and not isinstance(value, bool):
            raise Refusal.in_document(REFUSALS["one-of"], "true, false", field=name, value=value)
        return value
    most = _LARGEST_OF.get(name)
    if most is not None:
        if type(value) is not int or not 0 <= value <= most:
            raise Refusal.in_document(REFUSALS["a-whole-number"], 0, most, field=name, value=value)
        return value
    value = one_line(name, value, LONGEST_TYPED if name == "typed" else LONGEST_NAME)
    if name == "verdict" and value not in (RIGHT, WRONG, SHOWN):
        raise Refusal.in_document(
            REFUSALS["one-of"], f"{RIGHT}, {WRONG}, {SHOWN}", field=name, value=value
        )
    return value


def one_line(name: str, value: object, longest: int) -> str:
    """Return a text without control characters and halves of surrogate pairs, or refuse it."""
    if not isinstance(value, str) or len(value) > longest or value != spaced(value):
        raise Refusal.in_document(REFUSALS["a-text"], longest, field=name)
    return value


def spaced(text: str) -> str:
    """Return a text, perhaps pasted, with spaces for what `one_line` refuses."""
    return "".join(" " if unicodedata.category(each) in ("Cc", "Cs") else each for each in text)


# --------------------------------------------------------------------------- the file


class Record:
    """The file of all attempts; several windows may add to it at once.

    A full file replaces the old one beside it, so that both stay small.
    """

    def __init__(self, path: Path) -> None:
        self._path, self._old = path, path.with_name(f"old-{path.name}")
        self.problem: Refusal | None = None  # why a part of it could not be read the last time

    def add(self, attempt: Attempt) -> None:
        """Add a line; a `Refusal` if it cannot be written."""
        tree = {name: value for name, value in attempt._asdict().items() if value not in ("", 0)}
        tree |= {"when": attempt.when, "seed": attempt.seed, "is_test": attempt.is_test}
        tree["typed"] = attempt.typed[:LONGEST_TYPED]
        # Begins with a line break, because a killed program may have left half a line.
        line = f"\n{json.dumps(tree, ensure_ascii=False)}".encode("utf-8", "replace")
        with blamed_on(self._path, REFUSALS["unwritable"]):
            self._path.parent.mkdir(parents=True, exist_ok=True)
            flags = os.O_WRONLY | os.O_APPEND | os.O_CREAT | getattr(os, "O_NONBLOCK", 0)
            file = os.open(self._path, flags, 0o600)
            try:
                status = os.fstat(file)
                if not stat.S_ISREG(status.st_mode):
                    raise OSError(said("it is not a regular file"))
                left = line
                while left:  # at once if it fits, so that lines of two windows do not mix
                    left = left[os.write(file, left) :]
            finally:
                os.close(file)
            if status.st_size + len(line) > LARGEST:
                self._set_aside(status)

    def _set_aside(self, status: os.stat_result) -> None:
        """Make the file the old one, unless another window has just done so."""
        with contextlib.suppress(FileNotFoundError):
            if os.path.samestat(status, os.stat(self._path)):
                os.replace(self._path, self._old)

    def read(self) -> list[Attempt]:
        """Return all attempts in order; what cannot be read is left out, and `problem` says so."""
        self.problem, attempts = None, list[Attempt]()
        for path in (self._old, self._path):
            bad = 0
            try:
                for line in _lines(path):
                    attempt = _attempt(line)
                    bad += attempt is None
                    attempts += [] if attempt is None else [attempt]
                if bad:
                    raise Refusal.in_document(REFUSALS["record-damaged"], bad, file=str(path))
            except Refusal as error:
                self.problem = error
        return attempts


def _lines(path: Path) -> list[bytes]:
    """Return the last lines of a file, so many as a file of ours can have."""
    if not os.path.exists(path):
        return []
    with blamed_on(path, REFUSALS["files-unreadable"]), open_regular(path) as file:
        size = file.seek(0, os.SEEK_END)
        file.seek(max(0, size - 2 * LARGEST))
        lines = file.read(2 * LARGEST).split(b"\n")
    return [line for line in lines[size > 2 * LARGEST :] if line.strip()]


def _attempt(line: bytes) -> Attempt | None:
    try:
        return attempt_from(json.loads(decode(line)[0]))
    except (ValueError, RecursionError):  # a Refusal is a ValueError
        return None


# --------------------------------------------------------------------------- what follows


def corrected(
    attempts: Iterable[Attempt], hints_of: Callable[[tuple[str, str]], int]
) -> list[Attempt]:
    """Return the attempts without the hints that older programs counted in tests: all of them.

    They did not say which answers belong to a test. It draws any seed, gives one try, and asks the
    program's own exercises; practice begins with seed 1 and goes on from a seed that was seen. So
    an answer is a test's if all hints count as read before the first try at such a seed. Of the
    student's own choice it could only be by typing a far number and reading every hint at once.
    `hints_of` returns how many hints the exercise of a key has, if tests ask it, else 0.
    """
    seen: dict[tuple[str, str], set[int]] = {}
    without_hints = []
    for attempt in attempts:
        seeds = seen.setdefault(attempt.key, {0})
        if (
            attempt.hints and attempt.is_test is None
            and not any(0 <= attempt.seed - seed <= _FARTHEST for seed in seeds)
            and attempt.hints == hints_of(attempt.key)
        ):  # fmt: skip
            attempt = attempt._replace(hints=0, is_test=True)
        seeds.add(attempt.seed)
        without_hints.append(attempt)
    return without_hints


class Standing(NamedTuple):
    """How a question was last solved."""

    outcome: str = ""  # `ALONE`, `HELPED` or `SHOWN`; empty if it is not solved yet
    due: date | None = None  # the day on which the exercise comes back, unless it never does
    seeds: frozenset[int] = frozenset()  # the variants that the student has seen


@dataclass
class _QuestionHistory:
    outcome: str = ""
    due: date | None = None
    passed: int = 0  # how often it was solved alone when it had come back
    tried: set[int] = field(default_factory=set)
    solved: set[int] = field(default_factory=set)

    def take(self, attempt: Attempt) -> None:
        if attempt.seed in self.solved:  # the answer is known
            return
        day, is_first = date.fromtimestamp(attempt.when), attempt.seed not in self.tried
        self.tried.add(attempt.seed)
        is_alone = attempt.verdict == RIGHT and is_first and not attempt.hints
        if attempt.verdict != WRONG:
            self.solved.add(attempt.seed)
            solved = ALONE if is_alone else HELPED
            self.outcome = solved if attempt.verdict == RIGHT else SHOWN
        elif is_first:
            self.outcome = ""
        if not is_alone:
            self.passed, self.due = 0, day + timedelta(AGAIN_AFTER_DAYS[0])
        elif self.due is not None and day >= self.due:
            self.passed += 1
            more = AGAIN_AFTER_DAYS[self.passed : self.passed + 1]
            self.due = day + timedelta(more[0]) if more else None


def standings(attempts: Iterable[Attempt]) -> dict[tuple[str, str], Standing]:
    """Return the standing of each question that was answered, by lesson and ``step/block``."""
    histories: dict[tuple[str, str], _QuestionHistory] = {}
    for attempt in attempts:
        histories.setdefault(attempt.key, _QuestionHistory()).take(attempt)
    return {
        key: Standing(way.outcome, None if 0 in way.tried else way.due, frozenset(way.tried))
        for key, way in histories.items()
    }


def due(
    known: Mapping[tuple[str, str], Standing], today: date | None = None
) -> list[tuple[str, str]]:
    """Return the exercises that have come back, the longest waiting ones first."""
    today = today or date.today()
    waiting = [(each.due, key) for key, each in known.items() if each.due and each.due <= today]
    return [key for _, key in sorted(waiting)]


def minutes_each(attempts: Iterable[Attempt]) -> float:
    """Return how long an exercise takes: the median of all, from one answer to the next."""
    spent = dict[tuple[tuple[str, str], int], int]()
    before: int | None = None
    for attempt in attempts:
        seconds = -1 if before is None else attempt.when - before
        if attempt.seed and 0 <= seconds <= PAUSE_S:
            variant = attempt.key, attempt.seed
            spent[variant] = spent.get(variant, 0) + seconds
        before = attempt.when
    return median(spent.values()) / 60.0 if len(spent) >= TIMED else MINUTES_EACH


class Met(NamedTuple):
    """A wrong idea: how often it was met, and how its last question was solved since."""

    times: int
    outcome: str


def ideas_met(
    attempts: Iterable[Attempt], known: Mapping[tuple[str, str], Standing]
) -> dict[tuple[str, str], Met]:
    """Return the wrong ideas behind a student's answers, by lesson and name of the idea."""
    times_met: dict[tuple[str, str], Met] = {}
    for attempt in attempts:
        if attempt.idea:
            key = attempt.lesson, attempt.idea
            before = times_met[key].times if key in times_met else 0
            times_met[key] = Met(before + 1, known[attempt.key].outcome)
    return times_met
