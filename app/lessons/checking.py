"""Everything in a lesson tried: its states, keys, samples, formulas; what is wrong, with its line.

A key is the right answer or a named wrong one. That it agrees with the lecture is for the tests,
which reckon it once more by themselves; here it is held against what the file itself says.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial
from pathlib import Path

from app.document.document import Document
from app.document.settings import set_values
from app.document.view import PANES
from app.lessons import marking
from app.lessons.course import Course, idea_named, ideas, word_of
from app.lessons.lesson import (
    Choice,
    Lesson,
    Question,
    Sample,
    Step,
    Task,
    Words,
    Wrong,
    formulas_in,
    on_line,
    read,
    refused,
)
from app.lessons.text import outline
from app.model.formula import Formula
from app.model.limits import ONE_OF
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal

MOST_STEPS = 7
"""Of a lesson."""
MOST_WORDS = 150
"""Of a step's text, and of a note: what is read while something is looked at."""

TOO_LONG = QT_TRANSLATE_NOOP("Refusal", "has {0} words in its step; at most {1} are read")
LONG_NOTE = QT_TRANSLATE_NOOP("Refusal", "has a note of {0} words; at most {1} can be looked up")
TOO_MANY = QT_TRANSLATE_NOOP("Refusal", "is step {0} of a lesson; it has at most {1}")
NO_IDEA = QT_TRANSLATE_NOOP(
    "Refusal",
    "names a wrong idea that the program does not know (the nearest is {0}), and has no “says:” of"
    " its own",
)
OTHER_NUMBER = QT_TRANSLATE_NOOP("Refusal", "says another number than its formula, which gives {0}")
ALSO_RIGHT = QT_TRANSLATE_NOOP("Refusal", "is wrong, but its formula gives the right value, {0}")
SAME_WRONG = QT_TRANSLATE_NOOP("Refusal", "cannot be told from the wrong value of line {0}, {1}")
NOT_SO = QT_TRANSLATE_NOOP("Refusal", "does not hold")
OTHER_VERDICT = QT_TRANSLATE_NOOP("Refusal", "gets “{0}” instead of “{1}”")
NOT_TEX = QT_TRANSLATE_NOOP("Refusal", "has a formula that cannot be written: {0}")
NOTHING_TO_DO = QT_TRANSLATE_NOOP("Refusal", "is done before anything was done")
A_NUMBER_OF = QT_TRANSLATE_NOOP("Refusal", "must be the number of a choice, from 1 to {0}")


@dataclass
class Report:
    """What was tried of lessons and talks, and what is wrong.

    Attributes
    ----------
    lessons, talks, checks : int
    wrong : list of Refusal
        Each with file and line.
    """

    lessons: int = 0
    talks: int = 0
    checks: int = 0
    wrong: list[Refusal] = field(default_factory=list)

    def __str__(self) -> str:
        return (
            f"{counted(self.lessons, 'lesson')}, {counted(self.talks, 'talk')}, "
            f"{counted(self.checks, 'check')}, {len(self.wrong)} wrong"
        )

    def read(self, path: Path) -> None:
        """Read a lesson from its file and try it: all that is wrong with it is added."""
        try:
            lesson = read(path, self.wrong.append)
        except Refusal as error:
            self.wrong.append(error)
        else:
            self.take(lesson)

    def take(self, lesson: Lesson) -> Course:
        """Try a lesson, and add what was found."""
        self.lessons += not lesson.is_talk
        self.talks += lesson.is_talk
        checker = _Checker(lesson)
        checker.run()
        self.checks += checker.checks
        self.wrong += checker.wrong
        return checker.course


def counted(count: int, word: str) -> str:
    """Some of a thing, as English has it."""
    return f"{count} {word}{'' if count == 1 else 's'}"


class _Checker:
    """Tries one lesson."""

    def __init__(self, lesson: Lesson) -> None:
        self.lesson, self.course = lesson, Course(lesson)
        self.checks = 0
        self.wrong: list[Refusal] = []

    def run(self) -> None:
        is_lesson = not self.lesson.is_talk and any(step.asked for step in self.lesson.steps)
        for place, step in enumerate(self.lesson.steps):
            if place == MOST_STEPS and is_lesson:  # a collection of ideas may have more
                self._complain(refused(step.line, TOO_MANY, place + 1, place))
            before = len(self.wrong)
            with self._kept():
                self.course.shown(place)
            self._texts(step)
            if len(self.wrong) > before:
                continue  # nothing can be reckoned over a state that there is not
            for part in step.asked:
                with self._kept():
                    if isinstance(part, Task):
                        self._task(place, part)
                    else:
                        self._question(place, part)
            for sample in step.samples:
                self.checks += 1
                with self._kept():
                    self._sample(place, step, sample)

    @contextmanager
    def _kept(self) -> Iterator[None]:
        """Note what is refused, and go on."""
        try:
            yield
        except Refusal as error:
            self._complain(error)

    def _complain(self, error: Refusal) -> None:
        error.file = str(self.lesson.path)
        if str(error) not in map(str, self.wrong):  # of all steps that go on from a wrong one
            self.wrong.append(error)

    # -- texts

    def _texts(self, step: Step) -> None:
        words = 0
        for line, text in _texts_of(step):
            for tex in formulas_in(text):
                problem = _problem_of_tex(tex)
                if problem:
                    above = text[: text.find(tex)].count("\n")
                    self._complain(refused(line + above, NOT_TEX, problem, value=tex))
        for part in step.parts:
            if isinstance(part, Words):
                words += len(part.text.split())
        if words > MOST_WORDS:
            self._complain(refused(step.line, TOO_LONG, words, MOST_WORDS))
        if step.note is not None:
            words = len(step.note.text.split())
            if words > MOST_WORDS:
                self._complain(refused(step.note.line, LONG_NOTE, words, MOST_WORDS))

    # -- what is asked

    def _task(self, place: int, task: Task) -> None:
        self.checks += 1
        if self.course.is_done(place, task, self.course.shown(place).document):
            self._complain(refused(task.line, NOTHING_TO_DO))

    def _question(self, place: int, question: Question) -> None:
        self.checks += 1
        if question.show is not None:
            self.course.shown_by(place, question.show)
        known = self.course.asked_over(place, question)
        for line, condition in question.checks:
            with self._kept(), on_line(line, "check"):
                if not condition.holds(known, partial(word_of, known.document)):
                    raise refused(line, NOT_SO, value=condition.text)
        said: tuple[Choice | Wrong, ...] = (*question.choices, *question.wrong)
        for each in said:
            with self._kept():
                self._said(place, each)
        right = next((choice for choice in question.choices if choice.right), None)
        key = right.formula if right is not None else question.value
        line = right.line if right is not None else question.value_line
        value = None
        if key is not None:
            with self._kept():
                value = self._value(place, question, key, line)
        if right is not None and value is not None:
            self._agrees(right, value)
        found: list[tuple[int, float]] = []
        for each in said:
            if each is right or each.formula is None:
                continue
            with self._kept():
                wrong = self._value(place, question, each.formula, each.line)
                if isinstance(each, Choice):
                    self._agrees(each, wrong)
                if value is not None and _alike(wrong, value):
                    self._complain(refused(each.line, ALSO_RIGHT, f"{value:.6g}"))
                for line, other in found:
                    if _alike(wrong, other):
                        self._complain(refused(each.line, SAME_WRONG, line, f"{other:.6g}"))
                found.append((each.line, wrong))

    def _value(self, place: int, question: Question, formula: Formula, line: int) -> float:
        return self.course.value(place, question, formula, line)

    def _said(self, place: int, said: Choice | Wrong) -> None:
        if said.idea and idea_named(said.idea) is None and not said.says:
            names = [step.name for step in ideas().lesson.steps]
            near = difflib.get_close_matches(said.idea, names, n=1, cutoff=0.0)[0]
            self._complain(refused(said.line, NO_IDEA, near, value=said.idea))
        if said.state is not None:
            self.course.shown_by(place, said.state)

    def _agrees(self, choice: Choice, value: float) -> None:
        """Hold the number that a choice says against its formula."""
        for text in _WRITTEN.findall(choice.text):
            number = marking.read(text)
            if abs(number.value - Fraction(value)) <= number.unit * Fraction("0.5001"):
                return
        self._complain(refused(choice.line, OTHER_NUMBER, f"{value:.6g}", value=choice.text))

    # -- samples

    def _sample(self, place: int, step: Step, sample: Sample) -> None:
        part = next(part for part in step.asked if part.name == sample.block)
        got = self._verdict(place, part, sample)
        if got != sample.verdict:
            self._complain(refused(sample.line, OTHER_VERDICT, got, sample.verdict))

    def _verdict(self, place: int, part: Question | Task, sample: Sample) -> str:
        if isinstance(part, Task):
            own = self.course.shown(place).document
            with on_line(sample.line):
                now = _tried(own, sample.text.split())
            return "done" if self.course.is_done(place, part, now) else "open"
        if part.choices:
            number = int(sample.text) if sample.text.isdecimal() else 0
            if not 1 <= number <= len(part.choices):
                count = len(part.choices)
                raise refused(sample.line, A_NUMBER_OF, count, value=sample.text)
            verdict = self.course.chosen(place, part, number - 1)
        else:
            try:
                verdict = self.course.mark(place, part, sample.text)
            except Refusal as error:
                if error.field != "answer":
                    raise
                return "no number"
        return "right" if verdict.right else verdict.idea or "wrong"


_WRITTEN = re.compile(r"[-−]?\d+(?:\.\d+)?(?:/\d+)?")


_PANES = "view.panes="


def _tried(document: Document, assignments: Sequence[str]) -> Document:
    """What a task's sample sets, and the panes that somebody has turned: ``view.panes=world``.

    From where they are looked at then, no task asks.
    """
    document = set_values(document, (each for each in assignments if not each.startswith(_PANES)))
    turned = dict(document.view.panes)
    for each in assignments:
        names = each.removeprefix(_PANES) if each.startswith(_PANES) else ""
        for name in filter(None, names.split(",")):
            if name not in PANES:
                raise Refusal("view.panes", name, ONE_OF, ", ".join(PANES))
            turned[name] = document.projection.camera
    return replace(document, view=replace(document.view, panes=turned))


def _alike(one: float, other: float) -> bool:
    """Whether three digits do not tell two values apart."""
    return marking.equals(marking.read(f"{one:.{marking.DIGITS}g}"), other)


def _texts_of(step: Step) -> Iterator[tuple[int, str]]:
    """Every text of a step that can have formulas, with its line."""
    yield step.line, step.title
    if step.note is not None:
        yield step.note.text_line, step.note.text
    for part in step.parts:
        yield part.line + (not isinstance(part, Words)), part.text  # below the block's name
        if not isinstance(part, Words):
            yield from part.said
        if isinstance(part, Question):
            yield from ((choice.line, choice.text) for choice in part.choices)


def _problem_of_tex(tex: str) -> str:
    """What of a formula cannot be drawn; empty if all of it can."""
    try:
        outline(tex)
    except ValueError as error:
        said = str(error).strip().splitlines()[-1]
        # Without a part of the program, a place of its own, and all that could have been there.
        said = re.sub(r"^\w+Exception: |\s*\(at char \d+\)|,? \(line:\d+, col:\d+\)", "", said)
        return re.sub(r"Expected \{.{80,}\}, found", "Expected something else, found", said)
    return ""
