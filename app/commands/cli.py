"""The command line: what is asked for, checked and done.

Every wrong input ends in one sentence on standard error and exit status 2; a machine on which
nothing can be drawn in one sentence and status 3. Qt, VTK and pyvista are imported only by the
commands that draw, so that numbers come at once and on any machine.
"""

from __future__ import annotations

import csv
import io
import itertools
import json
import math
import os
import re
import stat
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app import bootstrap
from app.commands import doctor
from app.commands.arguments import (
    cannot_import,
    check_out,
    document_before,
    document_of,
    first_state,
    load_scene,
    with_values,
)
from app.commands.options import (
    CANNOT_DRAW,
    CliError,
    check_file,
    complain,
    outcome,
    parse_number,
    parser_of,
    write_out,
)
from app.document.codec import picture_json
from app.document.document import MESH_ENDINGS, is_mesh
from app.lecture.notation import latex_name, latex_number
from app.lecture.typed_matrix import properties
from app.lessons.lesson import is_lesson
from app.model.infinity import homogeneous
from app.model.limits import Row
from app.model.projection import (
    FINITE_NUMBER,
    LARGEST,
    LARGEST_IMAGE_PX,
    PLANES,
    WHOLE_PIXELS,
    Array,
    Projection,
    Space,
    Stage,
    Trace,
)
from app.model.refusal import Refusal, format_value
from app.precision.levels import (
    Precision,
    Prediction,
    precision_for_reading,
    predict,
    trace,
    trace_homogeneous,
)

LARGEST_INPUT = 2**30
"""Most bytes of points that are read."""


def main(argv: list[str] | None = None) -> int:
    """Run a command line.

    Parameters
    ----------
    argv : list of str, optional
        The arguments after the program's name; those of this process by default.

    Returns
    -------
    int
        The exit status: 0 done, 1 a window that was not shown whole, 2 bad input, 3 no usable
        display or OpenGL.
    """
    arguments = sys.argv[1:] if argv is None else argv
    return outcome(lambda: _run(arguments))


def _run(arguments: Sequence[str]) -> int:
    try:
        if arguments and arguments[0] in COMMANDS:
            return COMMANDS[arguments[0]](arguments[1:])
        if arguments:
            check_file(arguments[0])  # first: what follows a mistyped command is not the window's
        return _window(arguments)
    except Refusal as error:
        raise CliError(str(error)) from error


# --------------------------------------------------------------------------- the window


def _window(arguments: Sequence[str]) -> int:
    found, words = parser_of("").read(arguments)
    if found.screenshot is not None:
        _check_png("--screenshot", found.screenshot)
    for name, side in zip(("width", "height"), found.size or (), strict=False):
        if not 1 <= side <= LARGEST_IMAGE_PX:
            raise CliError(f"--size {name} = {side}: {WHOLE_PIXELS.format(LARGEST_IMAGE_PX)}.")
    file = words[0] if words else None
    lesson = file is not None and is_lesson(file)
    if lesson and found.set:
        raise CliError(f"--set {found.set[0]}: {file} is a lesson, whose steps set what is shown.")
    saved = first_state(file) if file and lesson else document_before(file, found.set)
    document = with_values(saved, found.set)
    from_file = is_mesh(document.scene) or document.mesh
    scene = load_scene(document.scene, document.mesh, file) if from_file else None
    try:
        with bootstrap.for_good():
            from widgets.program import application
            from widgets.program.opengl import DisplayError
            from widgets.window.settings import delete_settings
    except ImportError as error:
        raise cannot_import(error) from error
    if found.reset:
        try:
            write_out([f"{delete_settings()}\n"])
        except OSError as error:
            raise CliError(f"The settings cannot be deleted: {error}.") from error
    path = None if file is None else Path(os.path.abspath(file))
    screenshot = None if found.screenshot is None else Path(found.screenshot)
    is_bare = not words and not found.set
    options = application.Options(
        found.theme, found.size, screenshot, found.canvas, start_card=is_bare
    )
    try:
        if lesson:
            return application.run_window(document, saved, None, options, scene, lesson=path)
        return application.run_window(document, saved, path, options, scene)
    except DisplayError as error:
        raise CliError(str(error), CANNOT_DRAW) from error


def _check_png(name: str, out: str) -> None:
    if not out.lower().endswith(".png"):
        raise CliError(f"{name} = {out!r}: must end in .png.")
    check_out(name, out)


# --------------------------------------------------------------------------- export


def _export(arguments: Sequence[str]) -> int:
    found, (out, *file) = parser_of("export").read(arguments)
    _check_png("OUT", out)
    shown = file[0] if file else None
    document = document_of(shown, found.set)
    scene = load_scene(document.scene, document.mesh, shown)
    try:
        with bootstrap.for_good():
            from app.drawings.figures import TEXT, render, write_png
            from app.drawings.off_screen import check_off_screen
            from app.drawings.style import DARK, LIGHT
    except ImportError as error:
        raise cannot_import(error) from error
    try:
        check_off_screen()
    except RuntimeError as error:
        raise CliError(str(error), CANNOT_DRAW) from error
    try:
        pixels = render(
            scene,
            document.projection,
            panes=found.panes.split(","),
            size=found.size,
            scale=found.scale,
            transparent=found.transparent,
            style=DARK if found.theme == "dark" else LIGHT,
            view=document.view,
            settings=document.settings,
            quality=document.quality,
            text_pt=found.text_size,
        )
        write_png(out, pixels, picture_json(document), found.scale)
    except Refusal as error:
        of_size = found.size and error.file is None and str(error).startswith(("width", "height"))
        text = str(error).replace("text size =", "--text-size =", int(error.bound == TEXT))
        raise CliError(f"{'--size ' if of_size else ''}{text}") from error
    if scene.phenomenon is not None:
        settings = scene.phenomenon.checked(document.settings)
        illustration = scene.phenomenon.illustration(document.projection, settings, scene.subject)
        if illustration.warning is not None:  # the picture is written, but shows less than it could
            complain(f"{document.scene}: {illustration.warning.sentence()}.", 0)
    return 0


# --------------------------------------------------------------------------- project


def _project(arguments: Sequence[str]) -> int:
    _check_typed_points(arguments)
    found, (*file, source) = parser_of("project").read(arguments)
    if not file and source.lower().endswith((".json", *MESH_ENDINGS)):
        raise CliError(f"POINTS is missing: {source} is what the camera is read from.")
    projection = document_of(file[0] if file else None, found.set).projection
    read = _read_points(source)
    points, has_w = np.array(read.points), read.has_w
    predictions = predict(projection, points[points[:, 3] != 0.0, :3], space=found.space)
    precision = found.rung or precision_for_reading(predictions)
    if has_w:
        traced = trace_homogeneous(projection, points, precision, found.space)
    else:
        traced = trace(projection, points[:, :3], precision, space=found.space)
    beyond = ~np.isfinite(np.column_stack([traced.view, traced.clip])).all(axis=1)
    if beyond.any():  # float32 ends at 3e38, a document and its points do not
        number = int(beyond.argmax()) + 1
        raise CliError(
            f"--rung = {precision!r}: point {number} leads to numbers that it cannot hold."
        )
    answer = _Answer(projection, traced, precision, predictions, found.space, read.columns)
    if found.format == "table":
        write_out([f"{_lens_line(projection)}\n\n"])
    write_out(_PROJECT_FORMATS[found.format](answer))
    return 0


def _lens_line(projection: Projection) -> str:
    """The lens as it is used, in the names that ``--set`` has for it."""
    lens = projection.lens
    parts = [f"lens {lens.kind}"]
    if lens.planes is not None:
        values = {field.name: getattr(lens, field.name) for field in fields(lens)}
        keep, near, far = (values.pop(name, None) for name in ("keep", "near", "far"))
        parts += [f"{name} {format_value(value)}" for name, value in values.items()]
        if keep is not None:
            typed, used = tuple(values.values())[:4], projection.window
            parts.append(f"keep {keep}")
            if used != typed:
                parts[-1] += f" (uses {', '.join(map(format_value, used))})"
        parts += [f"near {format_value(near)}", f"far {format_value(far)}"]
    width, height = projection.image_size
    return ", ".join([*parts, f"image {width}x{height}", f"depth {projection.depth}"])


class _Columns(NamedTuple):
    """The columns of the points' file after the coordinates: names, and a row for each point."""

    names: list[str]
    rows: list[list[str]]

    def written(self, write: Callable[[list[str]], str]) -> Iterator[str]:
        """What is written of each point; empty texts where there are no such columns."""
        return map(write, self.rows) if self.names else itertools.repeat("")


class _Answer(NamedTuple):
    """What `project` prints."""

    projection: Projection
    trace: Trace
    precision: Precision
    predictions: dict[Precision, Prediction] | None
    space: Space
    columns: _Columns

    @property
    def stages(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """Each stage and its columns: with w where the points were given with one."""
        return _HOMOGENEOUS if self.trace.world.shape[1] == 4 else _STAGES

    @property
    def counts(self) -> tuple[int, int]:
        """Numbers of a point, and those of one that has no picture: up to clip space."""
        columns = [len(names) for _, names in self.stages]
        return sum(columns), sum(columns[:3])


_POINTS = re.compile(r"(?=.*\d)[-+.\deE\s,;()\[\]]+")
"""What is numbers and what stands between them, and so no file's name."""


def _check_typed_points(arguments: Sequence[str]) -> None:
    """Say how to give coordinates that were typed where a file belongs: 1,2,3, or 1 2 3."""
    typed = [word for word in arguments if _POINTS.fullmatch(word) and not os.path.lexists(word)]
    if not typed:
        return
    parts = [part for part in re.split(r"[\s,;()\[\]]+", " ".join(typed)) if part]
    point = ",".join(parts) if len(parts) in (3, 4) else "1,2,3"
    raise CliError(
        f"POINTS = {' '.join(typed)!r}: must be a CSV file, or - for standard input; for a point:"
        f" echo {point} | {bootstrap.PROGRAM} project -."
    )


class _Read(NamedTuple):
    """What a file of points holds.

    Attributes
    ----------
    points : list of Row
        With w: 1, or 0 at infinity.
    has_w : bool
        Whether the file says which.
    columns : _Columns
    """

    points: list[Row]
    has_w: bool
    columns: _Columns


def _read_points(source: str) -> _Read:
    """Read points from a CSV file or standard input, separated by commas or tabs.

    The first row may name the columns: x, y, z, perhaps w, then any others. Without names, a
    number in the fourth column is w.
    """
    name = "Standard input" if source == "-" else source
    try:
        # With the mark that some spreadsheets put before UTF-8, or without.
        text = _read_input(source).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise CliError(f"{name} is not UTF-8 text.") from error
    except ValueError as error:  # a NUL in the file's name
        raise CliError(f"{name!r} is not a name that a file can have.") from error
    except OSError as error:
        raise CliError(f"{name} cannot be read: {error.strerror or error}.") from error
    points: list[Row] = []
    columns, head, is_first = _Columns([], []), list[str](), True
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
                    raise CliError(f"{where}: has two columns of one name.")
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
    return _Read(points, has_w, columns)


def _others(cells: list[str], head: list[str], has_w: bool, where: str) -> list[str]:
    """The cells of a row after its coordinates; without names, a number there is w."""
    if len(cells) > len(head) > 0:
        raise CliError(f"{where}: has {len(cells)} columns, more than the {len(head)} named.")
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
            " others are named in a first row, as x,y,z,name."
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
    if len(cells) not in (3, 4):
        found = "1 column" if len(cells) == 1 else f"{len(cells)} columns"
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


class _Block(NamedTuple):
    """Some of the points, ready to be written.

    Attributes
    ----------
    numbers : (n, k) float64 array
        The columns of `_Answer.stages`; NaN where there is no picture, and no minus zero.
    in_front : list of bool
    outside_of : list of tuple of str
    """

    numbers: Array
    in_front: list[bool]
    outside_of: list[tuple[str, ...]]

    @property
    def texts(self) -> list[str]:
        """All numbers, row by row, each as the shortest text that reads back the same."""
        return list(map(repr, self.numbers.ravel().tolist()))


_STAGES: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("world", ("world_x", "world_y", "world_z")),
    ("view", ("view_x", "view_y", "view_z")),
    ("clip", ("clip_x", "clip_y", "clip_z", "clip_w")),
    ("ndc", ("ndc_x", "ndc_y", "ndc_z")),
    ("image", ("image_x_px", "image_y_px")),
    ("depth", ("depth",)),
)
_HOMOGENEOUS = tuple(
    (stage, (*names, f"{stage}_w") if stage in ("world", "view") else names)
    for stage, names in _STAGES
)
"""The same where points may be at infinity."""
_BLOCK = 4096


def _blocks(trace: Trace) -> Iterator[_Block]:
    named = [
        tuple(plane for i, plane in enumerate(PLANES) if code >> i & 1)
        for code in range(1 << len(PLANES))
    ]
    for start in range(0, len(trace.world), _BLOCK):
        part = Trace._make(column[start : start + _BLOCK] for column in trace)
        codes = part.outside @ (1 << np.arange(len(PLANES)))
        stages = part.world, part.view, part.clip, part.ndc, part.image, part.depth
        yield _Block(
            np.column_stack(stages) + 0.0,
            part.in_front.tolist(),
            [named[code] for code in codes.tolist()],
        )


def _plain(array: Array) -> list[Any]:
    """Python floats, whose repr is the shortest text that reads back the same; no minus zero."""
    return (array + 0.0).tolist()  # type: ignore[no-any-return]


def _project_json(answer: _Answer) -> Iterator[str]:
    parts = [
        f'"{stage}": {"[%s]" if len(names) > 1 else "%s"}' % ", ".join(["%s"] * len(names))
        for stage, names in answer.stages
    ]
    seen = "{" + ", ".join(parts)
    unseen = "{" + ", ".join([*parts[:3], *(f'"{stage}": null' for stage, _ in _STAGES[3:])])
    count, before_ndc = answer.counts
    names = answer.columns.names
    others = answer.columns.written(
        lambda row: f', "columns": {json.dumps(dict(zip(names, row, strict=True)))}'
    )
    separator = '{"points": [\n'
    for block in _blocks(answer.trace):
        texts, lines = block.texts, []
        for i, (in_front, outside_of) in enumerate(
            zip(block.in_front, block.outside_of, strict=True)
        ):
            first = count * i
            if in_front:
                line = seen % tuple(texts[first : first + count])
            else:
                line = unseen % tuple(texts[first : first + before_ndc])
            inside = "true" if in_front and not outside_of else "false"
            outside = json.dumps(outside_of)
            more = next(others)
            lines.append(f'{line}, "inside": {inside}, "outside_of": {outside}{more}}}')
        yield separator + ",\n".join(lines)
        separator = ",\n"
    wanted: tuple[str, ...] = ("view_from_world", "clip_from_view", "clip_from_world")
    if answer.space == "object":
        wanted = ("world_from_object", *wanted)
    stages = (*answer.projection.stages, *answer.projection.direct_stages)
    matrices = {stage.name: _plain(stage.matrix) for stage in stages if stage.name in wanted}
    yield f'\n],\n"matrices": {json.dumps(matrices, allow_nan=False)},\n'
    errors = {
        precision: {"px": _finite_or_text(error.px), "depth": _finite_or_text(error.depth)}
        for precision, error in (answer.predictions or {}).items()
    }
    chosen = {
        "rung": answer.precision,
        "predicted_error_px": errors[answer.precision]["px"] if errors else None,
        "predictions": errors,
    }
    yield json.dumps(chosen, allow_nan=False)[1:] + "\n"


def _finite_or_text(error: float) -> float | str:
    """JSON has no infinity; the document writes it so, too."""
    return error if math.isfinite(error) else "inf"


def _project_csv(answer: _Answer) -> Iterator[str]:
    columns = [name for _, names in answer.stages for name in names]
    others = answer.columns.written(lambda row: f",{_csv_row(row)}")
    names = f",{_csv_row(answer.columns.names)}" if answer.columns.names else ""
    yield ",".join([*columns, "inside", "outside_of"]) + names + "\n"
    count, before_ndc = answer.counts
    none = [""] * (count - before_ndc)
    for block in _blocks(answer.trace):
        texts, lines = block.texts, []
        for i, (in_front, outside_of) in enumerate(
            zip(block.in_front, block.outside_of, strict=True)
        ):
            cells = texts[count * i : count * (i + 1)]
            if not in_front:
                cells[before_ndc:] = none
            cells += ["true" if in_front and not outside_of else "false", " ".join(outside_of)]
            lines.append(",".join(cells) + next(others) + "\n")
        yield "".join(lines)


def _csv_row(cells: list[str]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="").writerow(cells)
    return text.getvalue()


def _project_table(answer: _Answer) -> Iterator[str]:
    labels = ("world", "view", "clip", "NDC", "image px", "depth")
    rows, line = len(labels) + 1, "%*s" * 4 + "\n"
    seen = "%-10s  " + line + "".join(f"{label:>10}  {line}" for label in labels)
    unseen = "%-10s  " + line + "".join(f"{label:>10}  {line}" for label in labels[:3])
    # Where each number stands in a table of four columns, below its head.
    places = [
        4 * row + i for row, (_, names) in enumerate(answer.stages, 1) for i in range(len(names))
    ]
    numbers, before_ndc = answer.counts
    number = 0
    names = answer.columns.names
    others = answer.columns.written(
        lambda row: "".join(
            f"{_printable(name):>10}  {_printable(text)}\n"
            for name, text in zip(names, row, strict=True)
        )
    )
    for block in _blocks(answer.trace):
        count, texts = len(block.numbers), block.texts
        whole = (block.numbers == np.rint(block.numbers)) & (np.abs(block.numbers) < 1e15)
        for i in np.flatnonzero(whole).tolist():
            texts[i] = texts[i].removesuffix(".0")
        counted = np.zeros((2, count, 4 * rows), dtype=int)
        counted[0, :, :4] = counted[1, :, :4] = 1
        counted[:, :, places] = np.reshape(_lengths(texts), (2, count, numbers))
        counted[:, ~np.array(block.in_front), places[before_ndc] :] = 0
        cells = np.full((count, 4 * rows), "", dtype=object)
        cells[:, :4] = "x", "y", "z", "w"
        cells[:, places] = np.array(texts, dtype=object).reshape(count, numbers)
        filled: list[Any] = [None] * (2 * cells.size)
        filled[::2] = _widths(*counted.reshape(2, count, rows, 4))
        filled[1::2] = cells.ravel().tolist()
        lines = []
        for i, (in_front, outside_of) in enumerate(
            zip(block.in_front, block.outside_of, strict=True)
        ):
            number += 1
            shown = seen if in_front else unseen
            first = 8 * rows * i
            values = filled[first : first + 8 * (rows if in_front else 4)]
            lines.append("\n" if number > 1 else "")
            lines.append(shown % (f"point {number}", *values))
            if not in_front:
                why = _why_none(block.numbers[i, :before_ndc].tolist())
                lines += [f"{label:>10}  none: {why}\n" for label in labels[3:]]
            beyond = ", ".join(outside_of)
            lines.append(
                f"{'outside of' if beyond else 'inside':>10}  {beyond or 'the view volume'}\n"
            )
            lines.append(next(others))
        yield "".join(lines)
    if answer.predictions is not None:
        errors = [
            f"{precision} {error.px:.1e} px"
            if math.isfinite(error.px)
            else f"{precision} has no bound"
            for precision, error in answer.predictions.items()
        ]
        yield f"\ncomputed in {answer.precision}; errors are below: {', '.join(errors)}\n"


def _printable(text: str) -> str:
    """A text without what a terminal would obey."""
    return "".join(letter if letter.isprintable() else "\ufffd" for letter in text)


def _why_none(numbers: list[float]) -> str:
    """Why a point has no picture, by its numbers up to clip space."""
    at_infinity, w = len(numbers) > 10 and numbers[3] == 0.0, numbers[-1]
    if w > 0.0:
        return "the point is in front of the eye; its pixel is larger than float64 can hold"
    if not at_infinity:
        return "the point is not in front of the eye"
    if w < 0.0:
        return "the point at infinity is behind the eye; the opposite direction has a picture"
    return "the picture is at infinity too: w = 0, and lines of this direction stay parallel"


_PROJECT_FORMATS: dict[str, Callable[[_Answer], Iterator[str]]] = {
    "table": _project_table,
    "csv": _project_csv,
    "json": _project_json,
}


def _lengths(texts: Sequence[str]) -> tuple[NDArray[np.int_], NDArray[np.int_]]:
    """Characters of each text, and of them those before a number's point or exponent."""
    length = np.fromiter(map(len, texts), int, len(texts))
    point = np.fromiter(map(str.find, texts, itertools.repeat(".")), int, len(texts))
    for i in np.flatnonzero(point < 0).tolist():
        point[i] = len(texts[i].partition("e")[0])
    return length, point


def _widths(length: NDArray[np.int_], before: NDArray[np.int_]) -> list[int]:
    """To how many characters each text is filled from the left, so that they stand in columns.

    In each table the numbers of a column are under each other at their points.

    Parameters
    ----------
    length, before : (tables, rows, columns) array
        As `_lengths` counts them. A row may be short: its last lengths are 0, and get no room.
    """
    after = length - before
    left, right = before.max(axis=1), after.max(axis=1)
    point = np.cumsum(left + right + 2, axis=1) - right - 2
    widths = np.diff(point[:, None] + after, axis=2, prepend=0)
    widths[length == 0] = 0
    return widths.ravel().tolist()  # type: ignore[no-any-return]


# --------------------------------------------------------------------------- matrices


def _matrices(arguments: Sequence[str]) -> int:
    found, words = parser_of("matrices").read(arguments)
    projection = document_of(words[0] if words else None, found.set).projection
    write_out([_MATRIX_FORMATS[found.format](projection)])
    return 0


def _all_stages(projection: Projection) -> list[Stage]:
    """Every stage, and the products of those before the divide where they end."""
    *stages, last = projection.stages
    return [*stages, *projection.direct_stages, last]


def _factors(stage: Stage) -> tuple[tuple[str, Array], ...]:
    """The factors that a reader has not seen as stages."""
    return tuple(factor for factor in stage.factors if "_from_" not in factor[0])


def _matrices_text(projection: Projection) -> str:
    blocks = [f"{_lens_line(projection)}\n"]
    for stage in _all_stages(projection):
        product = f" = {' '.join(name for name, _ in stage.factors)}" if stage.factors else ""
        notes = [stage.note] if stage.note else []
        notes += map(str, properties(projection, stage.name))
        note = "".join(f"  ({note})\n" for note in notes)
        blocks.append(f"{stage.name}{product}\n{note}{_text(stage.matrix)}")
        factors = _factors(stage)
        if len(factors) > 1:
            blocks += [f"  {name}\n{_text(values)}" for name, values in factors]
        if stage.name == "clip_from_world":
            blocks.append("ndc_from_clip: x, y and z divided by w\n")
    return "\n".join(blocks)


def _text(matrix: Array) -> str:
    texts = [format_value(value) for value in (matrix + 0.0).ravel().tolist()]
    length, before = (part.reshape(1, *matrix.shape) for part in _lengths(texts))
    cells = map(str.rjust, texts, _widths(length, before))
    return "".join(f"  {''.join(row)}\n" for row in zip(*[cells] * matrix.shape[1], strict=True))


def _matrices_json(projection: Projection) -> str:
    lines = [
        f"  {json.dumps(stage.name)}: {json.dumps(_plain(stage.matrix), allow_nan=False)}"
        for stage in _all_stages(projection)
    ]
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _matrices_latex(projection: Projection) -> str:
    blocks = ["% needs \\usepackage{amsmath}\n"]
    for stage in _all_stages(projection):
        factors = _factors(stage)
        shown = [values for _, values in factors] if len(factors) > 1 else []
        equal = " = ".join(
            "\n".join(map(_latex, group)) for group in (shown, [stage.matrix]) if group
        )
        notes = [stage.note] if stage.note else []
        notes += map(str, properties(projection, stage.name))
        note = "".join(f"% {note}\n" for note in notes)
        blocks.append(f"{note}\\[\n{latex_name(stage.name)} = {equal}\n\\]\n")
    return "\n".join(blocks)


def _latex(matrix: Array) -> str:
    rows = [" & ".join(map(latex_number, row)) for row in _plain(matrix)]
    return "\\begin{pmatrix}\n" + " \\\\\n".join(rows) + "\n\\end{pmatrix}"


_MATRIX_FORMATS: dict[str, Callable[[Projection], str]] = {
    "text": _matrices_text,
    "json": _matrices_json,
    "latex": _matrices_latex,
}


# --------------------------------------------------------------------------- measure


def _measure(arguments: Sequence[str]) -> int:
    try:
        with bootstrap.for_good():
            from app.commands import measure as command
    except ImportError as error:
        raise cannot_import(error) from error
    return command.run(arguments)


def _lesson(arguments: Sequence[str]) -> int:
    from app.commands import lessons

    return lessons.lesson(arguments)


def _talk(arguments: Sequence[str]) -> int:
    from app.commands import talk

    return talk.talk(arguments)


COMMANDS: dict[str, Callable[[Sequence[str]], int]] = {
    "export": _export,
    "project": _project,
    "matrices": _matrices,
    "measure": _measure,
    "lesson": _lesson,
    "talk": _talk,
    "doctor": doctor.command,
}
"""The words that the command line may begin with; each takes the arguments after it."""
