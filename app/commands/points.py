"""The points of the command ``project``, from a CSV file or from standard input."""

from __future__ import annotations

import csv
import io
import itertools
import math
import os
import re
import stat
import sys
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from app import bootstrap
from app.commands.options import CliError, parse_number
from app.model.infinity import homogeneous
from app.model.limits import Row
from app.model.projection import FINITE_NUMBER, LARGEST
from app.model.refusal import Refusal, counted

LARGEST_INPUT = 2**30
"""Most bytes read as points."""


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
    typed = [word for word in arguments if _POINTS.fullmatch(word) and not os.path.lexists(word)]
    if not typed:
        return
    parts = [part for part in re.split(r"[\s,;()\[\]]+", " ".join(typed)) if part]
    point = ",".join(parts) if len(parts) in (3, 4) else "1,2,3"
    raise CliError(
        f"POINTS = {' '.join(typed)!r}: must be a CSV file, or - for standard input; for a point:"
        f" echo {point} | {bootstrap.PROGRAM} project -."
    )


class Read(NamedTuple):
    """The content of a file of points."""

    points: list[Row]
    """Each point has w: 1, or 0 at infinity."""
    has_w: bool
    """Whether the file has a column for w."""
    columns: Columns


def read(source: str) -> Read:
    """Read points from a CSV file or standard input, separated by commas or tabs.

    The first row may name the columns: x, y, z, perhaps w, then any others. Without names, a
    number in the fourth column is w.
    """
    name = "Standard input" if source == "-" else source
    try:
        # Some spreadsheets put a byte order mark before UTF-8.
        text = _read_input(source).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise CliError(f"{name} is not UTF-8 text.") from error
    except ValueError as error:  # a NUL in the file's name
        raise CliError(f"{name!r} is not a name that a file can have.") from error
    except OSError as error:
        raise CliError(f"{name} cannot be read: {error.strerror or error}.") from error
    points: list[Row] = []
    columns, head, is_first = Columns([], []), list[str](), True
    first_cell, *tabbed = text.lstrip().partition("\n")[0].strip().split("\t")
    separator = "\t" if len(tabbed) > 1 and "," not in first_cell else ","
    rows = csv.reader(io.StringIO(text, newline=""), delimiter=separator, skipinitialspace=True)
    has_w = False
    try:
        for row in rows:
            cells, where = [cell.strip() for cell in row], f"{name}, line {rows.line_num}"
            if not any(cells):
                continue
            if is_first and [cell.lower() for cell in cells[:3]] == ["x", "y", "z"]:
                head = cells if len(cells) > 3 else []
                has_w = [cell.lower() for cell in cells[3:4]] == ["w"]
                columns.names.extend(cells[3 + has_w :])
                if len(set(columns.names)) < len(columns.names):
                    raise CliError(f"{where}: has two columns of the same name.")
            else:
                others = _others(cells, head, has_w, where)
                has_w |= len(cells) - len(others) == 4
                points.append(_point(cells[: len(cells) - len(others)], where))
                columns.rows.append(others)
            is_first = False
    except csv.Error as error:
        raise CliError(f"{name}, line {rows.line_num}: is not CSV ({error}).") from error
    if not points:
        raise CliError(f"{name} has no points: it must have rows of x,y,z.")
    widest = max(map(len, columns.rows))
    columns.names.extend(f"column_{n + 4}" for n in range(len(columns.names), widest))
    for others in columns.rows:
        others.extend([""] * (len(columns.names) - len(others)))
    return Read(points, has_w, columns)


def _others(cells: list[str], head: list[str], has_w: bool, where: str) -> list[str]:
    """Return the cells of a row after its coordinates; without names, a number there is w."""
    if len(cells) > len(head) > 0:
        raise CliError(f"{where}: has {len(cells)} columns, but the first row names {len(head)}.")
    if head:
        return cells[3 + has_w :]
    while len(cells) > 3 and not cells[-1]:
        cells.pop()
    try:
        parse_number(cells[3])
    except (IndexError, ValueError):
        return cells[3:]
    if len(cells) > 4:
        raise CliError(
            f"{where}: has {len(cells)} columns, must have three: x,y,z, or w too;"
            " name other columns in a first row: x,y,z,name."
        )
    return []


def _read_input(source: str) -> bytes:
    if source == "-":
        if sys.stdin is None:
            raise OSError("it is closed")
        content: bytes = sys.stdin.buffer.read(LARGEST_INPUT + 1)
    else:
        mode = os.stat(source).st_mode
        if not (stat.S_ISREG(mode) or stat.S_ISFIFO(mode) or stat.S_ISDIR(mode)):
            raise OSError("it is a device, neither a file nor a pipe")
        with open(source, "rb") as file:
            content = file.read(LARGEST_INPUT + 1)
    if len(content) > LARGEST_INPUT:
        raise OSError(f"it is larger than {LARGEST_INPUT // 2**20} MiB")
    return content


def _point(cells: list[str], where: str) -> Row:
    if len(cells) < 3:
        found = counted(len(cells), "column")
        hint = ", with commas between them and decimal points" if ";" in "".join(cells) else ""
        raise CliError(f"{where}: has {found}, must have three: x,y,z, or w too{hint}.")
    values = []
    for name, cell in zip("xyzw", cells, strict=False):
        try:
            value = parse_number(cell)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise CliError(f"{where}: {name} = {cell!r}: {FINITE_NUMBER}.")
        if abs(value) > LARGEST:
            raise CliError(f"{where}: {name} = {cell}: must lie within ±{LARGEST}.")
        values.append(value)
    try:
        return homogeneous(*values[:3], *(values[3:] or (1.0,)))
    except Refusal as error:
        raise CliError(f"{where}: {error}") from error
