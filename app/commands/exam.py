"""``lesson print``: tests on paper, one file for each variant, and their key."""

import argparse
import os
import re
from collections.abc import Sequence
from pathlib import Path

from app.commands.arguments import check_drawing, check_out, importing, set_letters
from app.commands.terminal import CliError, interrupt, write_out
from app.document.files import write_bytes_atomically
from app.languages import said
from app.lessons.blocks.exercise import LARGEST_SEED
from app.lessons.contents import contained, file_of
from app.lessons.course import Course
from app.lessons.lesson import read
from app.lessons.practice import PlacedExercise, exercises_of

MOST_TESTS = 500  # more would fill a disk by mistake


def print_tests(options: argparse.Namespace) -> int:
    for option in ("topics", "seeds", "out"):
        if not getattr(options, option):
            raise CliError("lesson print needs --{0}.", option)
    topics, letters = _topics(options.topics), set_letters(options)
    seeds, digits = _seeds(options.seeds)
    posed, left_out = list[tuple[str, PlacedExercise]](), list[str]()
    for topic, path in topics.items():
        course = Course(read(path, letters=letters))
        exercises = list(exercises_of(course))
        on_paper = [each for each in exercises if each.exercise.is_on_paper]
        if not on_paper:
            raise CliError("--topics = {0!r}: has no exercise that can be solved on paper.", topic)
        posed += ((f"{topic}: {course.lesson.title}", each) for each in on_paper)
        left_out += (f"{topic}, {e.here.step.title}" for e in exercises if e not in on_paper)
    name = "-".join(topics)
    folder = _folder(options.out)
    files = [os.path.join(folder, f"test-{name}-{seed:0{digits}}.pdf") for seed in seeds]
    answers = os.path.join(folder, f"key-{name}.pdf")
    for out in (*files, *[answers] * options.key):
        check_out("--out", out)
    note = ""
    if left_out:
        note = said("Left out, because it is done in the window: {0}.", "; ".join(left_out))
        write_out([f"{note}\n"])
    with importing():
        from widgets.program.exam import Numbered, exam, key
    check_drawing()
    title = ", ".join(topics)
    variants: list[tuple[int, Sequence[Numbered]]] = []
    with interrupt() as cancelled:

        def check() -> None:  # raised in a method that Qt calls, it would be lost
            if cancelled.is_set():
                raise KeyboardInterrupt

        for number, (seed, out) in enumerate(zip(seeds, files, strict=True), 1):
            numbered = [Numbered(*each, each[1].with_numbers(seed)) for each in posed]
            _write(out, exam(title, seed, numbered, check), said("{0} of {1}", number, len(files)))
            variants.append((seed, numbered))
        if options.key:
            _write(answers, key(title, variants, note, check), said("key"))
    return 0


def _topics(text: str) -> dict[str, os.PathLike[str]]:
    """Return the lessons of a test by their topics, or by their files' names."""
    paths = dict[str, os.PathLike[str]]()
    for word in (word.strip() for word in text.split(",")):
        path = Path(file_of(word))
        if not os.path.isfile(path):
            stems = (re.match(r"l(\d+)-", each.stem) for each in contained())
            raise CliError("topics", word, max(int(stem[1]) for stem in stems if stem))
        name = word.upper() if re.fullmatch(r"[Ll]\d+", word) else path.stem
        if name in paths:
            raise CliError("--topics = {0!r}: names {1} twice.", text, name)
        paths[name] = path
    return paths


def _seeds(text: str) -> tuple[range, int]:
    """Return the seeds of ``1:30`` or ``7``, and the number of digits in names of files."""
    ends = re.fullmatch(r"([0-9]{1,9})(?::([0-9]{1,9}))?", text)
    first, last = (int(ends[1]), int(ends[2] or ends[1])) if ends is not None else (0, 0)
    if not 1 <= first <= last <= LARGEST_SEED:
        raise CliError("seeds", text, LARGEST_SEED)
    if last - first >= MOST_TESTS:
        raise CliError("too-many-tests", text, last - first + 1, MOST_TESTS)
    return range(first, last + 1), max(2, len(str(last)))


def _folder(out: str) -> str:
    """Return the folder for the tests, which is made if its own folder exists."""
    if not os.path.isdir(out):
        try:
            os.mkdir(out)
        except (OSError, ValueError) as error:
            why = error.strerror if isinstance(error, OSError) else error
            raise CliError("--out = {0!r}: cannot be made a folder: {1}.", out, why) from error
    return out


def _write(out: str, content: bytes, progress: str) -> None:
    done = said("overwritten") if os.path.exists(out) else said("written")
    write_bytes_atomically(out, content)
    write_out([f"{progress}: {out} {done}\n"])
