"""The figures of a list, a folder or a lesson, in one process, with a page that shows them.

A list is CSV from anyone: its size is limited, and no line writes outside the folder of the
figures. A line that cannot be drawn does not keep the others from it.
"""

import argparse
import contextlib
import csv
import html
import io
import os
import re
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple
from urllib.parse import quote

from app import languages
from app.commands import sweep
from app.commands.arguments import course_of, full_path
from app.commands.options import SETTABLE, Parser
from app.commands.terminal import BAD_INPUT, CANNOT_DRAW, CliError, print_error, write_out
from app.document.document import YES_OR_NO, is_mesh
from app.document.files import (
    LARGEST_PICTURE,
    blamed_on,
    content_of,
    extract,
    write_bytes_atomically,
)
from app.lessons.contents import file_of
from app.lessons.lesson import is_lesson
from app.model.refusal import REFUSALS, Refusal, nearest, shown_name
from app.strangers import decode, open_regular, printable

LARGEST_LIST = 2**20  # most bytes of a list: some ten thousand figures
INDEX = "index.html"
_NOT_OF_A_LINE = (
    "batch", "resume", "format", "sweep", "orbit", "stages", "transition", "frames", "fps", "loop",
    "help",
)  # fmt: skip

Draw = Callable[[argparse.Namespace, str, "str | None"], str]


class ListedFigure(NamedTuple):
    """A figure of a list: where the list asks for it, and its cells by column."""

    where: str
    cells: dict[str, str]
    sources: tuple[str, ...] = ()
    """The list, the document or the files of the lesson that it is made of."""
    wrong: str = ""


def run(options: argparse.Namespace, folder: str, others: Sequence[str], draw: Draw) -> int:
    """Draw the figures of a list into a folder; return 2 if one of them cannot be drawn."""
    if others:
        raise CliError("--batch: takes one name, the folder of the figures.")
    lines = list(_lines(options))
    _make(folder)
    own = languages.chosen()
    parser, entries, taken = Parser("export"), list[tuple[str, str, str]](), dict[str, str]()
    for number, line in enumerate(lines, 1):
        out, wrong, said, about = printable(line.cells.get("out", "")), "", "", ""
        languages.choose(own)
        try:
            if line.wrong:
                raise CliError(line.wrong)
            target = _target(folder, line.cells["out"], line.where, taken)
            asked, file = _asked(parser, options, line)
            languages.choose(asked.language or own)
            if options.resume and _is_new(target, *line.sources, file):
                said = languages.said(" is there already")
            elif warning := draw(asked, target, file):
                print_error(f"{line.where}: {warning}", 0)
            about = _about(target)
        except (CliError, Refusal) as error:
            if getattr(error, "status", 0) == CANNOT_DRAW:
                raise
            wrong = str(error)
            print_error(f"{line.where}: {wrong}", 0)
        entries.append((out, wrong, about))
        write_out([f"{number}/{len(lines)} {out}{languages.said(' failed') if wrong else said}\n"])
    languages.choose(own)
    page = os.path.join(folder, INDEX)
    write_bytes_atomically(page, _page(os.path.basename(full_path(options.batch)), entries))
    return BAD_INPUT if any(wrong for _, wrong, _ in entries) else 0


# --------------------------------------------------------------------------- reading


def _lines(options: argparse.Namespace) -> Iterator[ListedFigure]:
    source, ending = options.batch, options.format or "png"
    if os.path.isdir(source):
        with blamed_on(source, REFUSALS["files-unreadable"]):
            paths = [os.path.join(source, name) for name in sorted(os.listdir(source))]
        paths = list(filter(_is_drawn, paths))
        if not paths:
            raise CliError("--batch = {0!r}: has no documents (.json, .md) and no meshes.", source)
        for path in paths:
            stem = os.path.splitext(os.path.basename(path))[0]
            if is_lesson(path):
                yield from _of_steps(path, ListedFigure(path, {"file": path}, (path,)), ending)
            else:
                yield ListedFigure(path, {"out": f"{stem}.{ending}", "file": path}, (path,))
        return
    if is_lesson(lesson := file_of(source)):
        yield from _of_steps(lesson, ListedFigure(lesson, {"file": lesson}, (lesson,)), ending)
        return
    if options.format:
        raise CliError("--format: is for a folder or a lesson; in a list the endings decide.")
    for line in _of_list(source):
        if file := line.cells.get("file"):
            beside, named = os.path.join(os.path.dirname(source), file), file_of(file)
            file = beside if os.path.lexists(beside) or named == file else named
            line = line._replace(cells=line.cells | {"file": file})
        if file and is_lesson(file) and not line.cells.get("step") and not line.wrong:
            yield from _of_steps(file, line)
        else:
            yield line


def _is_drawn(path: str) -> bool:
    """Whether a file of a folder is a document, a mesh or a lesson; a README is none."""
    if not is_lesson(path):
        return path.lower().endswith(".json") or is_mesh(path)
    with contextlib.suppress(OSError, Refusal), open_regular(path) as file:
        return decode(file.read(64))[0].startswith("---")
    return True


def _of_steps(lesson: str, line: ListedFigure, ending: str = "") -> Iterator[ListedFigure]:
    """Yield a line for each step of a lesson.

    Its figure is named by lesson and step if there is an ending, else by a number in the column
    out.
    """
    stem, out = os.path.splitext(os.path.basename(lesson))[0], line.cells.get("out", "")
    try:
        course = course_of(lesson)
        names = [step.name for step in course.lesson.steps]
        targets = sweep.names(out, len(names) + 1)[1:]
        if ending:
            targets = [f"{stem}-{place:02}-{name}.{ending}" for place, name in enumerate(names, 1)]
        elif not targets:
            raise CliError("name-a-step", os.path.basename(lesson), out)
    except (CliError, Refusal) as error:
        yield line._replace(cells=line.cells | {"out": out or stem}, wrong=str(error))
        return
    files = tuple(os.path.join(course.folder, name) for name in course.files)
    for place, out in enumerate(targets, 1):
        cells = line.cells | {"out": out, "step": str(place)}
        where = languages.said("{0}, step {1}", line.where, place)
        yield ListedFigure(where, cells, (*line.sources, *files))


def _of_list(source: str) -> Iterator[ListedFigure]:
    with blamed_on(source, REFUSALS["files-unreadable"]):
        content = content_of(source, LARGEST_LIST)
    text, note = decode(content)
    if note:
        print_error(f"{source} {note}.", 0)
    rows = csv.reader(io.StringIO(text, newline=""), skipinitialspace=True, strict=True)
    columns, begin, is_empty = list[str](), 1, True
    try:
        for row in rows:
            where = f"{source}, {languages.said('line')} {begin}"
            cells = [cell.strip() for cell in row]
            begin = rows.line_num + 1
            if not any(cells):
                continue
            if not columns:
                columns = _checked_columns(cells, where)
                continue
            is_empty = False
            wrong = ""
            if len(cells) > len(columns):
                wrong = languages.said("columns-more", len(cells), len(columns))
            yield ListedFigure(where, dict(zip(columns, cells, strict=False)), (source,), wrong)
    except csv.Error as error:
        raise CliError("{0}, line {1}: is not CSV ({2}).", source, begin, error) from error
    if is_empty:
        raise CliError("empty-list", source)


def _checked_columns(columns: list[str], where: str) -> list[str]:
    known = ["out", "file", *_options(Parser("export")), *SETTABLE]
    for number, column in enumerate(columns):
        shown = shown_name(column)
        if ";" in column:
            raise CliError("{0}: {1!r} is one column; they are separated by commas.", where, shown)
        if column not in known and not column.startswith("settings."):
            near = nearest(shown, known)
            raise CliError("{0}: {1!r} is not a column; the nearest is {2}.", where, shown, near)
        if column in columns[:number]:
            raise CliError("{0}: has two columns {1}.", where, shown)
    if "out" not in columns:
        raise CliError("{0}: has no column out, for the names of the figures.", where)
    return columns


def _options(parser: Parser) -> dict[str, argparse.Action]:
    """Return the options that a column may be, by its name."""
    every = {action.option_strings[-1][2:]: action for action in parser.options()}
    return {name: action for name, action in every.items() if name not in _NOT_OF_A_LINE}


def _asked(
    parser: Parser, common: argparse.Namespace, line: ListedFigure
) -> tuple[argparse.Namespace, str | None]:
    """Return the options and the FILE of a line; those of the command line where it has none."""
    options, words, given = _options(parser), list[str](), dict[str, bool]()
    for column, cell in line.cells.items():
        if "\0" in cell:
            raise CliError("{0} = {1!r}: has a character NUL.", column, cell)
        if column in ("out", "file") or not cell:
            continue
        if column not in options:
            words.append(f"--set={column}={cell}")
        elif column == "set":
            words += [f"--set={each}" for each in cell.splitlines()]
        elif options[column].nargs != 0:
            words.append(f"--{column}={cell}")
            given[options[column].dest] = True
        elif cell in YES_OR_NO:
            given[options[column].dest] = False
            words += [f"--{column}"] * YES_OR_NO[cell]
        else:
            raise CliError("{0} = {1!r}: must be true or false.", column, cell)
    asked, _ = parser.read([*words, "--", "out"])
    for name, value in vars(common).items():
        if name == "set":
            asked.set = [*value, *asked.set]
        elif name not in given:
            setattr(asked, name, value)
    return asked, line.cells.get("file") or None


# --------------------------------------------------------------------------- writing


def _make(folder: str) -> None:
    with blamed_on(folder, REFUSALS["unwritable"]):
        try:
            os.makedirs(folder, exist_ok=True)
        except FileExistsError as error:
            raise CliError("OUT = {0!r}: must be a folder, for the figures.", folder) from error


def _target(folder: str, out: str, where: str, taken: dict[str, str]) -> str:
    """Return where a figure goes; refuse a name that leads out of the folder, or is taken."""
    if re.search(r"[/\\:\0]", out) or out.startswith(".") or not out.isprintable():
        raise CliError("out = {0!r}: must be a file name without a folder.", out)
    first = taken.setdefault(out.casefold(), where)
    if first != where:
        raise CliError("out = {0!r}: is written by {1}.", out, first)
    target = os.path.join(folder, out)
    if os.path.islink(target):
        raise CliError("out = {0!r}: is a link, which may lead out of {1}.", out, folder)
    return target


def _is_new(target: str, *sources: str | None) -> bool:
    try:
        written = os.stat(target).st_mtime_ns
        return all(os.stat(each).st_mtime_ns < written for each in sources if each)
    except OSError:
        return False


def _about(figure: str) -> str:
    """Return the description that a figure's file holds; empty without one."""
    try:
        content = content_of(figure, LARGEST_PICTURE)
        if figure.lower().endswith(".png"):
            return extract(content, "Description") or ""
    except Refusal:
        return ""
    _, _, rest = decode(content)[0].partition("<desc>")
    about, end, _ = rest.partition("</desc>")
    return html.unescape(about) if end else ""


def _page(title: str, entries: Sequence[tuple[str, str, str]]) -> bytes:
    """Return the page that shows the figures; every text in it is escaped."""
    figures = []
    for out, wrong, about in entries:
        name, link = html.escape(out), html.escape(quote(f"./{out}"))
        shown = f'<img src="{link}" alt="{html.escape(printable(about) or out)}">'
        if wrong:
            shown = f"<p>{html.escape(printable(wrong))}</p>"
        elif out.lower().endswith((".pdf", ".tex")):
            shown = "PDF" if out.lower().endswith(".pdf") else "TikZ"
        caption = name if wrong else f'<a href="{link}">{name}</a>'
        figures.append(f"<figure>{shown}<figcaption>{caption}</figcaption></figure>\n")
    return (
        f'<!doctype html>\n<html lang="{languages.chosen()}">\n<meta charset="utf-8">\n'
        f"<title>{html.escape(printable(title))}</title>\n"
        "<style>body{font-family:sans-serif}figure{display:inline-block;margin:1em;max-width:45em}"
        "img{max-width:100%}</style>\n"
        f"<h1>{html.escape(printable(title))}</h1>\n{''.join(figures)}</html>\n"
    ).encode()
