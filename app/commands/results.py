"""``lesson results``: the results of a class, marked again from what was typed."""

import argparse
import csv
import io
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from datetime import UTC, datetime
from pathlib import Path

from app.commands.arguments import check_out
from app.commands.terminal import BAD_INPUT, CliError, print_error, write_out
from app.document.files import write_bytes_atomically
from app.languages import said
from app.lessons.course import idea_named
from app.lessons.record import RIGHT, SHOWN, WRONG, Attempt
from app.lessons.results import Marker, RemarkedAnswer, StudentResults, read
from app.model.refusal import Refusal, counted
from app.strangers import printable

MOST_LISTED = 40  # most answers without an idea that are listed
LONGEST_RESPONSE = 70  # most characters of a lesson's response to an idea of its own
COLUMNS = (
    "file", "student", "time", "lesson", "exercise", "variant", "typed", "mark", "idea", "hints",
    "right", "note",
)  # fmt: skip
_FORMULA = ("=", "+", "-", "@", "\t", "\r")  # spreadsheets compute a cell that begins so


def results(options: argparse.Namespace, files: Sequence[str]) -> int:
    """Mark the results of a class; return `BAD_INPUT` if a file cannot be read."""
    if not files:
        raise CliError("lesson results needs a FILE.")
    if options.csv:
        check_out("--csv", options.csv, files)
    marker, seen = Marker(), Counter[tuple[str, Attempt]]()
    marks: list[tuple[str, StudentResults, list[RemarkedAnswer]]] = []
    names = [Path(file).name for file in files]
    for file, name in zip(files, names, strict=True):
        try:
            each = read(file)
        except Refusal as error:
            print_error(str(error), BAD_INPUT)
            continue
        fresh = [a for a in dict.fromkeys(each.attempts) if (each.student, a) not in seen]
        seen.update((each.student, attempt) for attempt in each.attempts)
        shown = file if names.count(name) > 1 else name
        marks.append((shown, each, list(map(marker.marked, fresh))))
    if options.csv:
        rows = (row for name, each, answers in marks for row in _rows(name, each, answers, marker))
        write_bytes_atomically(options.csv, _csv(rows))
    lines = [*_summary([answers for _, _, answers in marks])]
    if copies := seen.total() - len(seen):
        lines.insert(1, said("{0} left out: already in these files", counted(copies, "answer")))
    write_out(f"{printable(line)}\n" for line in lines)
    return BAD_INPUT if len(marks) < len(files) else 0


def _rows(
    file: str, student: StudentResults, answers: Iterable[RemarkedAnswer], marker: Marker
) -> Iterator[Sequence[object]]:
    for attempt, word, right, _ in answers:
        mark = word if word in (RIGHT, SHOWN, "") else WRONG
        notes = []
        if not word:
            notes.append("no such question here")
        elif mark != attempt.verdict:
            notes.append(f"the file says {attempt.verdict}")
        if marker.is_other(attempt.lesson, student.digests):
            notes.append("the student had another version of the lesson")
        time = datetime.fromtimestamp(attempt.when, UTC).isoformat(timespec="seconds")
        idea = "" if word in (RIGHT, SHOWN, WRONG) else word
        yield (
            file, student.student, time, attempt.lesson, attempt.exercise, attempt.seed,
            attempt.typed, mark, idea, attempt.hints, right, "; ".join(notes),
        )  # fmt: skip


def _csv(rows: Iterable[Sequence[object]]) -> bytes:
    """Write a table that no spreadsheet computes; with a mark by which it is read as UTF-8."""
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(COLUMNS)
    for row in rows:
        writer.writerow(f"'{cell}" if cell.startswith(_FORMULA) else cell for cell in map(str, row))
    return text.getvalue().encode("utf-8-sig")


def _idea(answer: RemarkedAnswer) -> tuple[str, str] | None:
    """Return what names a wrong idea: its lesson, if only that knows it, and its name."""
    if answer.word in (RIGHT, SHOWN, WRONG, ""):
        return None
    return answer.attempt.lesson if answer.says else "", answer.word


def _summary(students: Sequence[Sequence[RemarkedAnswer]]) -> Iterator[str]:
    """Yield the counts of a class, its wrong ideas, and what no idea explained."""
    answers = [each for student in students for each in student]
    words = Counter(each.word for each in answers)
    ideas = Counter(key for key in map(_idea, answers) if key is not None)
    wrong = words[WRONG] + ideas.total()
    files, total = counted(len(students), "file"), counted(len(answers), "answer")
    yield said("how-marked", files, total, words[RIGHT], wrong, words[SHOWN], words[""])
    given = [each for each in answers if each.word]
    changed = sum((each.word == RIGHT) != (each.attempt.verdict == RIGHT) for each in given)
    if changed:
        yield said("{0} not as in the files", counted(changed, "mark"))
    if ideas:
        yield said("Wrong ideas (answers, students):")
    for key in sorted(ideas, key=lambda each: (-ideas[each], each)):
        count = sum(any(_idea(each) == key for each in student) for student in students)
        lesson, idea = key
        known = idea_named(idea)
        title = f"  {known.title}" if known is not None else ""
        if lesson:
            says = next(each.says for each in answers if _idea(each) == key)
            idea, title = f"{lesson}: {idea}", f"  {says[:LONGEST_RESPONSE]}"
        yield f"{ideas[key]:>5} {count:>4}  {idea}{title}"
    unexplained = Counter(
        (a.lesson, a.exercise, a.seed, a.typed, right)
        for a, word, right, _ in answers
        if word == WRONG and a.typed
    )
    if unexplained:
        yield said("unexplained")
    for (lesson, exercise, seed, typed, right), count in unexplained.most_common(MOST_LISTED):
        yield f"{count:>5}  {lesson} {exercise} {seed}: {typed} ({right})"
    if len(unexplained) > MOST_LISTED:
        yield said("       … and {0} more; --csv has them all", len(unexplained) - MOST_LISTED)
