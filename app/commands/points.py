"""The points of the command ``project``, from a CSV file or from standard input."""

import csv
import io
import itertools
import math
import os
import re
import stat
import sys
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple, Self

from app import bootstrap
from app.commands.options import parse_number
from app.commands.terminal import CliError, print_error
from app.languages import said
from app.model.infinity import homogeneous
from app.model.limits import Row
from app.model.numerals import plain
from app.model.projection import LARGEST
from app.model.refusal import REFUSALS, Refusal, counted
from app.strangers import decode

LARGEST_INPUT = 2**30  # most bytes read as points


class Columns(NamedTuple):
    """The columns of a file after the coordinates: their names, and a row for each point."""

    names: list[str]
    rows: list[list[str]]

    def written(self, write: Callable[[list[str]], str]) -> Iterator[str]:
        """Return a text for each point; empty if there are no such columns."""
        return map(write, self.rows) if self.names else itertools.repeat("")


_POINTS = re.compile(r"(?=.*\d)[-+.\deE\s,;()\[\]]+")
"""Numbers and separators, which cannot be a file's name."""


def check_typed(arguments: Sequence[str]) -> None:
    """Refuse coordinates typed in place of a file (1,2,3 or 1 2 3), and say how to give them."""
    typed = [each for each in arguments if _POINTS.fullmatch(plain(each))]
    typed = [each for each in typed if not os.path.lexists(each)]
    if not typed:
        return
    parts = [part for part in re.split(r"[\s,;()\[\]]+", plain(" ".join(typed))) if part]
    point = ",".join(parts) if len(parts) in (3, 4) else "1,2,3"
    raise CliError("points", " ".join(typed), point, bootstrap.PROGRAM)


class Read(NamedTuple):
    points: list[Row]  # each point has w: 1, or 0 at infinity
    has_w: bool  # whether the file has a column for w
    columns: Columns


def read(source: str) -> Read:
    """Read points from a file or standard input, as spreadsheets and numpy write them.

    Commas, tabs, semicolons or blanks separate the columns; a line that begins with ``#`` is a
    comment. The first row, or a comment before it, may name the columns, in any order. Without
    names, x is the first number of the first row, and a number after z is w.
    """
    name, line = said("Standard input") if source == "-" else source, said("line")
    try:
        text, note = decode(_read_input(source))
    except ValueError as error:  # a NUL in the file's name
        raise CliError("{0!r} is not a name that a file can have.", name) from error
    except OSError as error:
        raise CliError("{0} cannot be read: {1}.", name, error.strerror or error) from error
    separator = _separator(text)
    rows = csv.reader(_lines(text, separator), delimiter=separator, skipinitialspace=True)
    layout: _Layout | None = None
    points: list[Row] = []
    kept: list[list[str]] = []
    has_w = False
    try:
        for row in rows:
            cells, where = [cell.strip() for cell in row], f"{name}, {line} {rows.line_num}"
            while cells and not cells[-1]:
                cells.pop()
            if not cells:
                continue
            if layout is None:
                layout = _Layout.of(cells, where)
                if layout.names:
                    continue
            coordinates, others = layout.split(cells, where)
            has_w |= len(coordinates) == 4
            points.append(_point(coordinates, where, separator))
            kept.append(others)
    except csv.Error as error:
        raise CliError("{0}, line {1}: is not CSV ({2}).", name, rows.line_num, error) from error
    if layout is None or not points:
        raise CliError("{0} has no points: it must have rows of x,y,z.", name)
    if note:
        print_error(f"{name} {note}.", 0)
    names = layout.names_of_others(max(map(len, kept)))
    for others in kept:
        others.extend([""] * (len(names) - len(others)))
    return Read(points, has_w, Columns(names, kept))


_DECLARED = re.compile(r"sep=(.)\s*")  # Excel's own first line
_DECIMAL_COMMAS = re.compile(r"([^\s,]+(,\d[^\s,]*)?\s+){2,}[^\s,]+(,\d[^\s,]*)?")  # and blanks


def _separator(text: str) -> str:
    """Return the separator of the columns, as the first line that is no comment shows it."""
    lines = (line.strip() for line in io.StringIO(text))
    first = next((line for line in lines if line and not line.startswith("#")), "")
    if declared := _DECLARED.fullmatch(first):
        return declared[1]
    if ";" in first:
        return ";"
    cells = first.split("\t")
    if len(cells) > 2 and not cells[0].endswith(","):
        return "\t"
    return "," if "," in first and not _DECIMAL_COMMAS.fullmatch(first) else " "


_IN_BRACKETS = re.compile(r"[(\[].*[)\]][,;]?")  # a row as numpy and this program print it


def _lines(text: str, separator: str) -> Iterator[str]:
    """Yield each line for `csv.reader`; an empty one for a comment that does not name x, y, z."""
    for line in io.StringIO(text, newline=""):
        stripped = line.strip()
        if _DECLARED.fullmatch(stripped):
            line = "\n"
        elif stripped.startswith("#"):
            titles = stripped.lstrip("#").strip()
            cells = titles.lower().split(None if separator == " " else separator)
            line = titles + "\n" if {"x", "y", "z"} <= {cell.strip() for cell in cells} else "\n"
        elif _IN_BRACKETS.fullmatch(stripped):
            line = stripped.strip("()[],; ") + "\n"
        yield line.strip(" ") if separator != " " else line.strip(" \t").replace("\t", " ")


class _Layout(NamedTuple):
    """Where the coordinates stand in a row."""

    places: tuple[int, ...]  # the columns of x, y, z and perhaps w
    names: list[str]  # the names of all columns; empty if the first row holds a point

    @classmethod
    def of(cls, cells: list[str], where: str) -> Self:
        """Read the first row: the names of the columns, or a point."""
        lower = [cell.lower() for cell in cells]
        if {"x", "y", "z"} <= set(lower):
            if len(set(lower)) < len(lower):
                raise CliError("{0}: has two columns of the same name.", where)
            return cls(tuple(lower.index(axis) for axis in "xyzw" if axis in lower), cells)
        numbers = [place for place, cell in enumerate(cells) if _number(cell, ";") is not None]
        first = next((place for place in numbers if place + 3 <= len(cells)), 0)
        if not numbers and len(cells) > 2:
            raise CliError("{0}: must name columns x, y and z, or hold a point.", where)
        return cls((first, first + 1, first + 2), [])

    def split(self, cells: list[str], where: str) -> tuple[list[str], list[str]]:
        """Return the coordinates of a row, and its other cells."""
        width, places = len(self.names), self.places
        if len(cells) <= 3 and places == (0, 1, 2):
            return cells, []
        if len(cells) > width > len(places):
            raise CliError(f"{where}: {said('columns-more', len(cells), width)}")
        after = places[-1] + 1
        if not width and after < len(cells) and _number(cells[after], ";") is not None:
            if len(cells) > after + 1:
                raise CliError("columns-three", where, len(cells))
            places = (*places, after)
        cells = [*cells, *[""] * (max(places) + 1 - len(cells))]
        if len(places) == 4 and not cells[places[3]]:  # a point
            cells[places[3]] = "1"
        others = [cell for place, cell in enumerate(cells) if place not in places]
        return [cells[place] for place in places], others

    def names_of_others(self, count: int) -> list[str]:
        """Return names for the columns that are no coordinates; `count` of them at least."""
        names = dict(enumerate(self.names))
        places = (place for place in itertools.count() if place not in self.places)
        return [
            names.get(place) or f"column_{place + 1}"
            for place in itertools.islice(places, max(count, len(names) - len(self.places)))
        ]


def _read_input(source: str) -> bytes:
    if source == "-":
        if sys.stdin is None:
            raise OSError(said("it is closed"))
        content: bytes = sys.stdin.buffer.read(LARGEST_INPUT + 1)
    else:
        mode = os.stat(source).st_mode
        if not (stat.S_ISREG(mode) or stat.S_ISFIFO(mode) or stat.S_ISDIR(mode)):
            raise OSError(said("it is a device, neither a file nor a pipe"))
        with open(source, "rb") as file:
            content = file.read(LARGEST_INPUT + 1)
    if len(content) > LARGEST_INPUT:
        raise OSError(said("it is larger than {0} MiB", LARGEST_INPUT // 2**20))
    return content


def _number(cell: str, separator: str) -> float | None:
    """Return the number in a cell, perhaps with a decimal comma; None for another text."""
    if separator != ",":
        cell = cell.replace(",", ".")
    try:
        return parse_number(cell)
    except ValueError:
        return None


def _point(cells: list[str], where: str, separator: str) -> Row:
    if len(cells) < 3:
        columns = counted(len(cells), "column")
        raise CliError("{0}: has {1}, must have three: x,y,z, or w too.", where, columns)
    values = []
    for name, cell in zip("xyzw", cells, strict=False):
        value = _number(cell, separator)
        if value is None or not math.isfinite(value):
            raise CliError(f"{where}: {Refusal(name, cell, REFUSALS['finite-number'])}")
        if abs(value) > LARGEST:
            raise CliError("{0}: {1} = {2}: must lie within ±{3}.", where, name, cell, LARGEST)
        values.append(value)
    try:
        return homogeneous(*values[:3], *(values[3:] or (1.0,)))
    except Refusal as error:
        raise CliError(f"{where}: {error}") from error
