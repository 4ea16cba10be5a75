"""The command ``talk``: draw every step of a talk as a check, or print its handout."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from app import bootstrap
from app.commands.arguments import cannot_import, check_out
from app.commands.options import CANNOT_DRAW, CliError, parser_of, write_out
from app.document.document import Document
from app.document.files import write_bytes_atomically
from app.lessons.checking import Report, counted
from app.lessons.course import Course, scene_of
from app.lessons.lesson import Lesson, Step, read
from app.model.refusal import Refusal

SMALL_PX = 120
"""Size of the panes drawn for the check."""


def talk(arguments: Sequence[str]) -> int:
    """Draw every step of a talk, or print its handout; return 1 if something is wrong with it."""
    found, (name,) = parser_of("talk").read(arguments)
    if not found.check and found.handout is None:
        raise CliError(
            f"talk needs --check or --handout OUT.pdf; {bootstrap.PROGRAM} {name} opens the talk."
        )
    if found.handout is not None:
        if not found.handout.lower().endswith(".pdf"):
            raise CliError(f"--handout = {found.handout!r}: must end in .pdf.")
        check_out("--handout", found.handout)
    draw = _draw()
    status = 0
    if found.check:
        wrong, line = _tried(Path(name), draw)
        write_out([*(f"{error}\n" for error in wrong), f"{line}\n"])
        status = 1 if wrong else 0
    if found.handout is not None and not status:
        _print(read(name), found.handout)
    return status


def _draw() -> Callable[[Document], object]:
    try:
        with bootstrap.for_good():
            from app.drawings.figures import render
            from app.drawings.off_screen import check_off_screen
    except ImportError as error:
        raise cannot_import(error) from error
    try:
        check_off_screen()
    except RuntimeError as error:
        raise CliError(str(error), CANNOT_DRAW) from error

    def draw(document: Document) -> object:
        return render(
            scene_of(document),
            document.projection,
            size=(3 * SMALL_PX, SMALL_PX),
            view=document.view,
            settings=document.settings,
            quality=document.quality,
        )

    return draw


def _tried(path: Path, draw: Callable[[Document], object]) -> tuple[list[Refusal], str]:
    """Return the mistakes of a talk, and a summary line."""
    report, drawn = Report(), 0
    try:
        course = report.take(read(path))
    except Refusal as error:
        report.wrong.append(error)
    else:
        for place, step in enumerate(course.lesson.steps):
            try:
                for document in _shown(course, place, step):
                    draw(document)
                drawn += 1
            except Refusal as error:
                error = _placed(error, course.lesson, step)
                if str(error) not in map(str, report.wrong):  # the check may have found it too
                    report.wrong.append(error)
    return report.wrong, f"{path.name}: {counted(drawn, 'step')} drawn, {len(report.wrong)} wrong"


def _shown(course: Course, place: int, step: Step) -> list[Document]:
    """Return the step's state, then the states that its predictions show."""
    states = [part.show for part in step.parts if part.show is not None]
    here = course.at(place)
    return [here.document, *map(here.shown_by, states)]


def _placed(error: Refusal, lesson: Lesson, step: Step) -> Refusal:
    """Add file and line to a refusal that does not name them."""
    if not error.field.startswith("line "):
        line = step.state.line if step.state is not None else step.line
        error = Refusal.in_document(
            error.bound, *error.limits, field=f"line {line}, {error.field}", value=error.value
        )
    error.file = str(lesson.path)
    return error


def _print(lesson: Lesson, out: str) -> None:
    try:
        with bootstrap.for_good():
            from widgets.program.handout import handout
    except ImportError as error:
        raise cannot_import(error) from error
    write_bytes_atomically(out, handout(Course(lesson)))
