"""Check a whole lesson: its states, answer keys, samples and formulas; report faults by line.

The right answers are compared with the file's own formulas. The tests check that they agree with
the lecture, by computing them independently.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from app.document.view import PANES
from app.languages import said
from app.lecture.letters import Letters
from app.lecture.typesetting import outline
from app.lessons.blocks.block import Asked, Here, Trial, path_of
from app.lessons.course import Course, unnameable
from app.lessons.lesson import Lesson, Step, read
from app.lessons.lines import refused
from app.lessons.text import MATH, formulas_in
from app.model.refusal import REFUSALS, Refusal, counted
from app.scenes.mesh import Progress, report

MOST_STEPS, MOST_PRACTICE = 7, 4  # most steps of a lesson without an exercise, and most with one
MOST_WORDS = 150  # most words of a step's text or of a note: the reader also looks at the pictures


_MARK = re.compile(r"(`+|\\[$\[\]<])")
_AS_TYPED = (  # what a lesson shows as it is typed
    (REFUSALS["no-links"], re.compile(r"!?\[[^\[\]\n]*\]\([^()\n]*(?:\([^()\n]*)?\)"
                                      r"|<(?:https?:|mailto:)[^<>\n]*>|<(?:img|a)\s[^<>\n]*>")),
    (REFUSALS["no-html"], re.compile(r"</?[a-zA-Z][\w-]*(?:\s[^<>\n]*)?/?>|<!--")),
    (REFUSALS["not-filled"], re.compile(r"\{[=~][^{}\n]+\}")),
    (REFUSALS["idea-as-typed"], re.compile(r"\{[a-zA-Z][\w-]*\}")),
)  # fmt: skip


@dataclass
class CheckReport:
    """The numbers of checked lessons, talks and blocks, and the faults with file and line."""

    lessons: int = 0
    talks: int = 0
    checks: int = 0
    wrong: list[Refusal] = field(default_factory=list)
    warnings: list[Refusal] = field(default_factory=list)

    def __str__(self) -> str:
        warnings = f", {counted(len(self.warnings), 'warning')}" if self.warnings else ""
        lessons, talks = counted(self.lessons, "lesson"), counted(self.talks, "talk")
        wrong = said("{0} wrong", len(self.wrong))
        return f"{lessons}, {talks}, {counted(self.checks, 'check')}, {wrong}{warnings}"

    def read(
        self, path: Path, progress: Progress | None = None, letters: Letters | None = None
    ) -> Course | None:
        """Read a lesson from its file, check it, and add its faults; return its steps, if any."""
        try:
            return self.take(read(path, self.wrong.append, letters), progress)
        except Refusal as error:
            self.wrong.append(error)
            return None

    def take(self, lesson: Lesson, progress: Progress | None = None) -> Course:
        self.lessons += not lesson.is_talk
        self.talks += lesson.is_talk
        course, trial = Course(lesson), Trial(lesson.path)
        _check(course, trial, progress)
        self.checks += trial.checks
        self.wrong += trial.wrong.values()
        self.warnings += trial.warnings
        return course


def _check(course: Course, trial: Trial, progress: Progress | None) -> None:
    lesson = course.lesson
    is_lesson = not lesson.is_talk and any(step.asked for step in lesson.steps)
    if is_lesson:  # a collection of ideas may have more
        _count(lesson.steps, trial)
    for place, step in enumerate(lesson.steps):
        report(progress, place / len(lesson.steps))
        is_possible = False
        with trial.kept():
            course.shown(place)
            is_possible = True
        _check_texts(step, trial)
        if is_possible:  # nothing can be computed from an impossible state
            _check_view(course, place, trial)
            before = len(trial.wrong)
            for block in step.blocks:
                with trial.kept():
                    block.check(course.at(place), trial)
            for part in step.asked if len(trial.wrong) == before else ():
                with trial.kept():
                    _check_asked(part, step, course.at(place), trial)


def _count(steps: Sequence[Step], trial: Trial) -> None:
    limits = (
        (False, MOST_STEPS, REFUSALS["checking-too-many"]),
        (True, MOST_PRACTICE, REFUSALS["too-much-practice"]),
    )
    for varies, most, bound in limits:
        some = [step for step in steps if step.varies == varies]
        if len(some) > most:
            trial.add_fault(refused(some[most].line, bound, most + 1, most))


def _check_view(course: Course, place: int, trial: Trial) -> None:
    """Report a name of the step's own state that no pane can draw."""
    state = course.lesson.steps[place].state
    values = state.values if state is not None else ()
    line = next((at for at, text in values if path_of(text) == "view.names"), 0)
    for name in unnameable(course.shown(place).document, PANES) if line else ():
        trial.add_fault(refused(line, REFUSALS["not-named"], name))


def _check_texts(step: Step, trial: Trial) -> None:
    texts = [(step.line, step.title), *(text for block in step.blocks for text in block.texts())]
    for line, text in texts:
        _check_signs(line, text, trial)
        for tex, problem in _problems(text):
            above = text[: text.find(tex)].count("\n")
            trial.add_fault(refused(line + above, REFUSALS["not-tex"], problem, value=tex))
    words = sum(len(each.text.split()) for each in step.words)
    if words > MOST_WORDS:
        trial.add_fault(refused(step.line, REFUSALS["checking-too-long"], words, MOST_WORDS))
    if step.note is not None and (words := len(step.note.text.split())) > MOST_WORDS:
        trial.add_fault(refused(step.note.line, REFUSALS["long-note"], words, MOST_WORDS))


def _check_signs(line: int, text: str, trial: Trial) -> None:
    """Report a dollar without its partner, and what would be a link in other Markdown."""
    for number, words in enumerate(MATH.sub("", _bare(text)).split("\n"), line):
        if "$" in words:
            trial.add_fault(refused(number, REFUSALS["unclosed"], value=words.strip()[:60]))
        for bound, pattern in _AS_TYPED:
            if match := pattern.search(words):
                trial.add_fault(refused(number, bound, value=match[0][:60]))
                break


def _bare(text: str) -> str:
    """Return a text without its code and its escaped signs, but with all line breaks."""
    parts = _MARK.split(text)  # every second one is a mark
    ends, later = dict[int, int](), dict[str, int]()
    for place in range(len(parts) - 2, 0, -2):
        if parts[place] in later:
            ends[place] = later[parts[place]]
        if parts[place].startswith("`"):
            later[parts[place]] = place
    bare, place = list[str](), 0
    while place < len(parts):
        end = ends.get(place, place)
        is_kept = place % 2 == 0 or (end == place and parts[place].startswith("`"))
        code = "".join(parts[place : end + 1])
        bare.append(code if is_kept else "\n" * code.count("\n"))
        place = end + 1
    return "".join(bare)


def _check_asked(part: Asked, step: Step, here: Here, trial: Trial) -> None:
    """Report a solution that cannot be typeset, and an answer or a wrong idea without a sample."""
    variant = part.variant(here, 1)
    for tex, problem in _problems(variant.question.solution(variant.here)):
        trial.add_fault(
            refused(variant.question.answer_line, REFUSALS["not-tex"], problem, value=tex)
        )
    tried = {sample.verdict for sample in step.samples if sample.block == part.name}
    variant.question.check_tried(tried, trial)


def _problems(text: str) -> Iterator[tuple[str, str]]:
    """Yield the formulas of a text that cannot be drawn, and why."""
    for tex in formulas_in(text):
        try:
            outline(tex)
        except ValueError as error:
            why = str(error).strip().splitlines()[-1]
            # Drop the exception's name, its position, and its list of expected tokens.
            why = re.sub(r"^\w+Exception: | {0,2}\(at char \d+\)|,? \(line:\d+, col:\d+\)", "", why)
            why = re.sub(r"Expected \{.{80,}\}, found", "Expected something else, found", why)
            yield tex, why
