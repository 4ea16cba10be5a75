"""Result files: answers of a student for the teacher, who marks them again from what was typed.

A file comes from a student, so only the typed answers are trusted: its size is limited, lessons
are found by their bare names only, and every mark is computed anew.
"""

import hashlib
import json
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from app.document.codec import Path as AnyPath
from app.document.files import blamed_on, content_of
from app.lessons import record
from app.lessons.blocks.block import Variant
from app.lessons.course import Course
from app.lessons.practice import ExerciseMark, course_named, hints_of, verdict_on
from app.lessons.record import RIGHT, SHOWN, WRONG, Attempt, attempt_from, corrected, one_line
from app.lessons.text import plain_of
from app.model.refusal import REFUSALS, Refusal
from app.strangers import decode, log_warning

FORMAT, VERSION = "frustum-lab-results", 1
LARGEST = 4 * 2**20  # largest file in bytes
MOST = 5000  # most answers of a file; the newest are exported
LONGEST_STUDENT = 100
_DIGITS = 16


class StudentResults(NamedTuple):
    student: str  # as typed by the student; empty if nothing was
    digests: Mapping[str, object]  # by a lesson's name: a digest of its file as the student had it
    attempts: Sequence[Attempt]


class RemarkedAnswer(NamedTuple):
    attempt: Attempt
    word: str
    """`RIGHT`, the name of a wrong idea, `WRONG` or `SHOWN`; empty if its lesson is not there."""
    right: str  # the right answer, as in a sample
    says: str = ""  # of a wrong idea that only its lesson names: what the lesson says to it


# --------------------------------------------------------------------------- the file


def to_json(student: str, attempts: Sequence[Attempt], program: str) -> str:
    """Write a file of results; lessons of one's own lose their folders."""
    attempts = attempts[-MOST:]
    names = {each.lesson: bare(each.lesson) for each in attempts}
    courses = {name: course_named(lesson) for lesson, name in names.items()}
    tree = {
        "format": FORMAT, "version": VERSION, "program": program, "student": student,
        "lessons": {name: digest(course) for name, course in courses.items() if course is not None},
        "answers": [each._replace(lesson=names[each.lesson])._asdict() for each in attempts],
    }  # fmt: skip
    return json.dumps(tree, ensure_ascii=False, indent=1)


def bare(lesson: str) -> str:
    """Return a lesson's name without folders, which may name the student."""
    return Path(lesson).name


def digest(course: Course) -> str:
    """Return a digest of a lesson's file; empty if it is no longer there."""
    try:
        return hashlib.sha256(course.lesson.path.read_bytes()).hexdigest()[:_DIGITS]
    except OSError:
        return ""


def read(path: AnyPath) -> StudentResults:
    """Read a file of results; a `Refusal` says what is wrong with it."""
    with blamed_on(path, REFUSALS["files-unreadable"]):
        content = content_of(path, LARGEST)
        try:
            text, note = decode(content)
            tree = json.loads(text)
        except (ValueError, RecursionError) as error:
            raise Refusal.in_document(REFUSALS["no-results"]) from error
        if not isinstance(tree, dict) or tree.get("format") != FORMAT:
            raise Refusal.in_document(REFUSALS["no-results"])
        log_warning(path, note)
        version, answers = tree.get("version"), tree.get("answers")
        if type(version) is not int or not isinstance(answers, list):
            raise Refusal.in_document(REFUSALS["no-results"])
        if version > VERSION:
            raise Refusal.in_document(REFUSALS["results-newer"], version, VERSION)
        if len(answers) > MOST:
            raise Refusal.in_document(REFUSALS["results-too-many"], MOST)
        lessons = tree.get("lessons")
        digests = lessons if isinstance(lessons, dict) else {}
        student = one_line("student", tree.get("student", ""), LONGEST_STUDENT)
        return StudentResults(student, digests, corrected(map(attempt_from, answers), hints_of))


def of_test(marks: Iterable[ExerciseMark]) -> list[Attempt]:
    """Return the answers of a test, the missing ones too."""
    attempts, now = [], record.now_s()
    for mark in marks:
        verdict = RIGHT if mark.word == RIGHT else WRONG
        idea = "" if mark.word in (RIGHT, WRONG) else mark.word
        key, seed = mark.item.placed.key, mark.item.variant.seed
        attempts.append(Attempt(now, *key, seed, mark.typed, verdict, idea, is_test=True))
    return attempts


# --------------------------------------------------------------------------- marks


class Marker:
    """Marks answers again; lessons and questions are read once."""

    def __init__(self) -> None:
        self._courses: dict[str, Course | None] = {}
        self._digests: dict[str, str] = {}
        self._posed: dict[tuple[str, str, int], Variant | None] = {}

    def marked(self, attempt: Attempt) -> RemarkedAnswer:
        key = attempt.lesson, attempt.exercise, attempt.seed
        if key not in self._posed:
            course = self._course(attempt.lesson)
            posed = None if course is None else _posed(course, attempt.exercise, attempt.seed)
            self._posed[key] = posed
        posed = self._posed[key]
        if posed is None:
            return RemarkedAnswer(attempt, "", "")
        question, here = posed.question, posed.here
        is_shown = attempt.verdict == SHOWN and not attempt.typed
        word = SHOWN if is_shown else verdict_on(question, here, attempt.typed)
        own = here.idea(word) is None
        says = plain_of(question.response_to(here, word).says) if own else ""
        return RemarkedAnswer(attempt, word, question.right_sample(here), says)

    def is_other(self, lesson: str, digests: Mapping[str, object]) -> bool:
        """Whether the student had another version of a lesson."""
        course, theirs = self._course(lesson), digests.get(lesson)
        if course is None or not theirs:
            return False
        if lesson not in self._digests:
            self._digests[lesson] = digest(course)
        return theirs != self._digests[lesson]

    def _course(self, lesson: str) -> Course | None:
        """Return a lesson by its bare name: one of the program, or one in the current folder."""
        if lesson not in self._courses:
            self._courses[lesson] = course_named(lesson) if bare(lesson) == lesson else None
        return self._courses[lesson]


def _posed(course: Course, exercise: str, seed: int) -> Variant | None:
    """Return a question with its numbers; None if there is no such question."""
    step, _, name = exercise.rpartition("/")
    for place, each in enumerate(course.lesson.steps):
        part = course.at(place).asked.get(name) if each.name == step else None
        if part is not None and (seed or not part.varies):
            with suppress(Refusal):
                return part.variant(course.at(place), seed)
            return None
    return None
