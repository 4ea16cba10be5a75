"""Exercises of several lessons on one sheet: a test, or what has come back to be practised.

A `Sheet` is a course in memory: each of its steps is an exercise of another lesson, in the state of
its own variant. Whatever plays a lesson plays a sheet.
"""

import random
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from datetime import date
from functools import cached_property
from itertools import islice
from pathlib import Path
from typing import NamedTuple

from app import languages
from app.document.files import blamed_on
from app.lessons.blocks.block import Asked, Here, TextBlock, Variant
from app.lessons.blocks.exercise import LARGEST_SEED
from app.lessons.contents import CONTENT, contained, file_of
from app.lessons.course import AtStep, Course, ShownStep
from app.lessons.lesson import Lesson, Step, read
from app.lessons.record import RIGHT, WRONG, Attempt, Standing, due, minutes_each, standings
from app.model.refusal import REFUSALS, Refusal

MOST = 12  # most exercises of a test, and of what is reviewed at once
_DRAWS = 20  # how many seeds are tried until the numbers of an exercise suit


class PlacedExercise(NamedTuple):
    course: Course
    place: int
    exercise: Asked

    @property
    def here(self) -> AtStep:
        return self.course.at(self.place)

    @property
    def words(self) -> Sequence[TextBlock]:
        """Return what the step says before the exercise, whose letters it may define."""
        return [each for each in self.here.step.words if each.line < self.exercise.line]

    @property
    def key(self) -> tuple[str, str]:
        """Return its lesson and ``step/block``, as in the record."""
        return self.course.name, f"{self.here.step.name}/{self.exercise.name}"

    def with_numbers(self, seed: int) -> Variant:
        """Return the exercise for a seed; a `Refusal` if no numbers suit."""
        with blamed_on(self.course.lesson.path, REFUSALS["files-unreadable"]):
            return self.exercise.variant(self.here, seed)


class SheetItem(NamedTuple):
    placed: PlacedExercise
    variant: Variant


class Sheet(Course):
    """Exercises as the steps of one lesson, whose answers are kept under its name, if it has one.

    The answers of a test are marked at the end.
    """

    def __init__(self, name: str, title: str, items: Sequence[SheetItem], *, is_test: bool) -> None:
        steps = (
            Step(str(number), placed.course.lesson.title, 1, (*placed.words, placed.exercise))
            for number, (placed, _) in enumerate(items, 1)
        )
        super().__init__(Lesson(Path(title), title, tuple(steps)))
        self.name, self.file, self.items, self.is_test = name, None, tuple(items), is_test

    def at(self, place: int) -> AtStep:
        return self.items[place].placed.here

    @cached_property
    def managed(self) -> frozenset[str]:
        fields = frozenset({"panel"}) if self.is_test else frozenset()
        return fields.union(*(item.placed.course.managed for item in self.items))

    def shown(self, place: int) -> ShownStep:
        document = self.items[place].variant.here.document
        if self.is_test:
            document = replace(document, view=replace(document.view, panel=""))
        return ShownStep(document, {name: getattr(document.view, name) for name in self.managed})


# --------------------------------------------------------------------------- what there is


def exercises_of(course: Course) -> Iterator[PlacedExercise]:
    for place, step in enumerate(course.lesson.steps):
        for part in step.asked:
            if part.varies:
                yield PlacedExercise(course, place, part)


@languages.cached
def _contained(path: Path) -> Course:
    return Course(read(path))


@languages.cached
def topics() -> Mapping[str, Course]:
    """Return the lessons that come with the program by their topics, ``L1`` to ``L27``."""
    courses = [_contained(path) for path in contained() if path.stem.startswith("l")]
    return {course.lesson.topics[0]: course for course in courses if course.lesson.topics}


def practised(names: Iterable[str]) -> dict[str, Course]:
    """Return the lessons of all topics, and the user's own lessons of these names that exist."""
    courses = dict(topics())
    for name in sorted(set(names) - {course.name for course in courses.values()}):
        course = course_named(name)
        if course is not None and course.name == name and any(exercises_of(course)):
            courses[Path(name).stem] = course
    return courses


def existing(keys: Iterable[tuple[str, str]]) -> dict[tuple[str, str], PlacedExercise]:
    """Return the exercises of a record's keys that their lessons still have."""
    wanted = set(keys)
    courses = (course_named(name) for name in sorted({lesson for lesson, _ in wanted}))
    exercises = (each for course in courses if course is not None for each in exercises_of(course))
    return {each.key: each for each in exercises if each.key in wanted}


def hints_of(key: tuple[str, str]) -> int:
    """Return how many hints an exercise of the program has; 0 for a user's own lesson."""
    courses = (course for course in topics().values() if course.name == key[0])
    exercises = (each for course in courses for each in exercises_of(course) if each.key == key)
    return next((len(each.exercise.hints) for each in exercises), 0)


def course_named(name: str) -> Course | None:
    """Return a lesson by its name in the record; None if it cannot be read."""
    own = CONTENT / f"{name}.md"
    try:
        return _contained(own) if own in contained() else Course(read(file_of(name)))
    except Refusal:
        return None


# --------------------------------------------------------------------------- sheets

_TEST = re.compile(r"test((?: L\d+)+) (\d{1,4})")


def name_of_test(names: Iterable[str], number: int) -> str:
    """Return the name under which a test's answers are kept; it says all of the test."""
    return " ".join(("test", *names, str(number)))


def named_test(name: str) -> tuple[list[str], int] | None:
    """Return topics and number of a test from its name; None if it is no test's."""
    match = _TEST.fullmatch(name)
    return None if match is None else (match[1].split(), int(match[2]))


def draw_test(names: Collection[str], number: int) -> list[SheetItem]:
    """Draw the exercises of a test: `MOST` of some topics, about as many of each, mixed.

    The same topics and number give the same test to everyone.
    """
    chosen = [name for name in topics() if name in names]
    chance = random.Random(f"{' '.join(chosen)} {number}")
    pools = [list(exercises_of(topics()[name])) for name in chosen]
    for pool in pools:
        chance.shuffle(pool)
    chance.shuffle(pools)
    sheet: list[SheetItem] = []
    while any(pools) and len(sheet) < MOST:
        for pool in filter(None, pools):
            seeds = (chance.randint(1, LARGEST_SEED) for _ in range(_DRAWS))
            item = _first_suitable(pool.pop(), seeds)
            if item is not None and len(sheet) < MOST:
                sheet.append(item)
    chance.shuffle(sheet)
    return sheet


def _first_suitable(placed: PlacedExercise, seeds: Iterable[int]) -> SheetItem | None:
    """Return an exercise with the first seed for which it has numbers."""
    for seed in seeds:
        with suppress(Refusal):
            return SheetItem(placed, placed.with_numbers(seed))
    return None


class Waiting(NamedTuple):
    """What is to be practised again."""

    due: tuple[PlacedExercise, ...]  # exercises that have come back, the longest waiting ones first
    minutes: int  # how long a review of them will take, of `MOST` at once
    following: date | None  # when the next ones come back


def find_waiting(attempts: Sequence[Attempt], today: date | None = None) -> Waiting:
    """Return the exercises that still exist and are due for practice."""
    today = today or date.today()
    known = standings(attempts)
    there = existing(key for key, each in known.items() if each.due)
    come_back = due(known, today)
    later = (known[key].due or today for key in there.keys() - {*come_back})
    waiting = tuple(there[key] for key in come_back if key in there)
    minutes = round(min(MOST, len(waiting)) * minutes_each(attempts))
    return Waiting(waiting, max(1, minutes), min(later, default=None))


def to_review(
    come_back: Sequence[PlacedExercise], known: Mapping[tuple[str, str], Standing]
) -> list[SheetItem]:
    """Return exercises that have come back, each with numbers that the student has not seen.

    Their lessons are mixed: none comes twice in a row as long as there is another one.
    """
    items: dict[str, list[SheetItem]] = {}
    for placed in come_back:
        seen = known[placed.key].seeds
        if sum(map(len, items.values())) < MOST:
            # After the largest one comes 1 again.
            numbers = ((max(seen) + more) % LARGEST_SEED + 1 for more in range(LARGEST_SEED))
            item = _first_suitable(placed, islice((n for n in numbers if n not in seen), _DRAWS))
            items.setdefault(placed.course.name, []).extend([] if item is None else [item])
    mixed: list[SheetItem] = []
    while any(items.values()):
        last = mixed[-1].placed.course.name if mixed else ""
        name = max(items, key=lambda name: (bool(items[name]) and name != last, len(items[name])))
        mixed.append(items[name].pop(0))
    return mixed


class ExerciseMark(NamedTuple):
    item: SheetItem
    typed: str  # empty without an answer
    word: str  # `RIGHT`, the name of a wrong idea, or `WRONG`


def marked(sheet: Sheet, answers: Mapping[str, str]) -> list[ExerciseMark]:
    """Mark a test, whose answers are kept by ``step/block`` as the seed and what was typed."""
    marks = []
    for item, step in zip(sheet.items, sheet.lesson.steps, strict=True):
        kept = answers.get(f"{step.name}/{item.placed.exercise.name}", "")
        (seed, _, typed), of = kept.partition(" "), item.variant
        word = _verdict(of.question, of.here, typed) if seed == str(of.seed) else None
        if word is None:  # the lessons have changed since, or the file is damaged
            typed = ""
        marks.append(ExerciseMark(item, typed, word or WRONG))
    return marks


def verdict_on(question: Asked, here: Here, typed: str) -> str:
    """Mark an answer, as in a sample; return `RIGHT`, the name of its idea, or `WRONG`."""
    return _verdict(question, here, typed) or WRONG


def _verdict(question: Asked, here: Here, typed: str) -> str | None:
    """Mark an answer; return None for a text that cannot be an answer to this question."""
    try:
        word = question.verdict(here, typed, question.line)
    except Refusal:
        return None
    return {"done": RIGHT, "open": WRONG, "no number": WRONG}.get(word, word)
