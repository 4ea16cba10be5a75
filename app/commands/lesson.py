"""The command ``lesson``: check or list lessons and talks, print exercises, mark results."""

from collections.abc import Iterator, Sequence
from pathlib import Path

from app import bootstrap
from app.commands.arguments import set_letters
from app.commands.composed import Composed, measure, taken
from app.commands.exam import print_tests
from app.commands.options import Parser, one_of
from app.commands.results import results
from app.commands.terminal import CliError, write_out
from app.languages import said
from app.lecture.letters import Letters
from app.lessons.checking import CheckReport
from app.lessons.contents import contained, file_of
from app.lessons.course import ideas
from app.lessons.lesson import is_lesson, read
from app.lessons.names import page
from app.model.refusal import counted
from app.strangers import printable


def run(arguments: Sequence[str]) -> int:
    """Do what the first argument says; return 1 if something is wrong with a lesson."""
    options, (what, *names) = Parser("lesson").read(arguments)
    verbs = "check", "list", "names", "print", "results"
    if what not in verbs and is_lesson(file_of(what)):
        raise CliError("needs-verb", what, ", ".join(verbs), bootstrap.PROGRAM)
    one_of("lesson", what, verbs)
    if options.csv and what != "results":
        raise CliError("--csv: is an option of lesson results, not of lesson {0}.", what)
    if options.letters and what not in ("check", "print"):
        raise CliError("letters-of", what)
    if what == "print":
        if names:
            raise CliError("lesson print takes no FILE such as {0!r}: use --topics.", names[0])
        return print_tests(options)
    for option in ("topics", "seeds", "out", "key"):
        if getattr(options, option):
            raise CliError("--{0}: is an option of lesson print, not of lesson {1}.", option, what)
    if what == "results":
        return results(options, names)
    if what == "names":
        write_out([page()])
        return 0
    files = [*map(Path, names)] or list(contained())
    if what == "list":
        write_out(map(_line, files))
        return 0
    report, composed = CheckReport(), Composed()
    write_out(_checked(report, composed, files, set_letters(options), own=not names))
    return 1 if report.wrong or composed.wrong else 0


def _line(file: Path) -> str:
    course = read(file)
    steps = len(course.steps)
    kinds = said("lesson"), said("talk")
    kind = kinds[course.is_talk].ljust(max(map(len, kinds)) + 1)
    topics = course.lecture if course.is_talk else ", ".join(course.topics)
    return f"{kind}{topics:<8}{counted(steps, 'step'):>9}  {course.title}  ({file.name})\n"


def _checked(
    report: CheckReport,
    composed: Composed,
    files: Sequence[Path],
    letters: Letters | None,
    own: bool,
) -> Iterator[str]:
    """Yield a line for each mistake or warning, and the lines that sum them up."""
    if own:
        ideas_report = CheckReport()
        ideas_report.take(ideas().lesson)
        report.wrong += ideas_report.wrong
    for file in files:
        said, warned = len(report.wrong), len(report.warnings)
        course = report.read(file, letters=letters)
        faults = *report.wrong[said:], *report.warnings[warned:]
        yield from (f"{printable(str(error))}\n" for error in faults)
        if course is not None and len(report.wrong) == said:
            before = len(composed.wrong)
            report.wrong += taken(composed, course, measure(), ())
            wrong = *report.wrong[said:], *composed.wrong[before:]
            yield from (f"{printable(str(fault))}\n" for fault in wrong)
    yield f"{report}\n"
    yield f"{composed}\n"
