"""The command ``talk``: draw every step of a talk as a check, or write its handout."""

from collections.abc import Sequence
from pathlib import Path

from app import bootstrap
from app.commands.arguments import check_drawing, check_out, importing, set_letters
from app.commands.composed import SLIDE_PX, Composed, measure, place_in, taken
from app.commands.options import Parser, one_of
from app.commands.terminal import CliError, write_out
from app.document.files import blamed_on, write_bytes_atomically
from app.languages import said
from app.lecture.letters import Letters
from app.lessons.checking import CheckReport
from app.lessons.course import Course, name_of
from app.lessons.lesson import Lesson, read
from app.model.refusal import REFUSALS, Refusal, counted
from app.strangers import printable

READERS = ("teacher", "students")  # of a handout; the first ones unless others are asked for


def run(arguments: Sequence[str]) -> int:
    """Draw every step of a talk, or write its handout; return 1 if something is wrong with it."""
    options, (name,) = Parser("talk").read(arguments)
    if not options.check and options.handout is None:
        talk = bootstrap.command_line([name_of(Path(name))])
        raise CliError("needs-handout", bootstrap.PROGRAM, talk)
    if options.handout is not None:
        if not options.handout.lower().endswith((".pdf", ".html")):
            raise CliError("--handout = {0!r}: must end in .pdf or .html.", options.handout)
        check_out("--handout", options.handout, [name])
    readers = options.readers or READERS[0]
    one_of("--for", readers, READERS)
    if options.readers and options.handout is None:
        raise CliError("--for: needs --handout OUT.pdf.")
    status, letters = 0, set_letters(options)
    if options.check:
        wrong, sums = _faults_and_warnings(Path(name), letters)
        write_out(f"{printable(line)}\n" for line in (*wrong, *sums))
        status = 1 if wrong else 0
    if options.handout is not None and not status:
        _print(read(name, letters=letters), options.handout, answers=readers == READERS[0])
    return status


def _faults_and_warnings(path: Path, letters: Letters | None) -> tuple[list[str], list[str]]:
    report, composed, left = CheckReport(), Composed(), ""
    try:
        course = report.take(read(path, letters=letters))
    except Refusal as error:
        report.wrong.append(error)
    else:
        report.wrong += taken(composed, course, measure(), report.wrong)
        left = _take_texts(composed, course.lesson)
    steps, wrong = counted(composed.steps, "step"), len(report.wrong)
    drawn = said("{0}: {1} drawn, {2} wrong", path.name, steps, wrong)
    sums = [*map(str, report.warnings), drawn, str(composed), *filter(None, [left])]
    return [*map(str, report.wrong), *composed.wrong], sums


def _take_texts(composed: Composed, lesson: Lesson) -> str:
    """Add the steps whose text a class sees cut; name those that leave some to the speaker."""
    with importing():
        from widgets.window.talk_band import shortened
    left = []
    parts = zip(lesson.steps, shortened(lesson.steps, SLIDE_PX), strict=True)
    for number, (step, (is_cut, leaves)) in enumerate(parts, 1):
        if is_cut:
            composed.wrong.append(f"{place_in(lesson, step.line, number - 1)}: {said('cut-text')}")
        elif leaves:
            left.append(f"{number} ({step.name})")
    return said("left-to-speaker", ", ".join(left)) if left else ""


def _print(lesson: Lesson, out: str, answers: bool) -> None:
    check_drawing()
    with importing():
        from widgets.program.handout import handout
        from widgets.program.handout_page import handout_page
    write = handout_page if out.lower().endswith(".html") else handout
    with blamed_on(lesson.path, REFUSALS["files-unreadable"]):
        content = write(Course(lesson), answers=answers)
    write_bytes_atomically(out, content)
