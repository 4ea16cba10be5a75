"""The command line: what is asked for, checked and done.

Every wrong input ends in one sentence on standard error and exit status 2; a machine on which
nothing can be drawn in one sentence and status 3. Qt, VTK and pyvista are imported only by the
commands that draw, so that numbers come at once and on any machine.
"""

from __future__ import annotations

import argparse
import csv
import difflib
import functools
import io
import json
import math
import os
import re
import signal
import sys
import threading
from collections.abc import Callable, Container, Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn

import numpy as np

from app import __version__, bootstrap
from app.doctor import check_off_screen, examine
from app.document import (
    MESH_ENDINGS,
    SETTABLE,
    Document,
    DocumentError,
    is_mesh,
    read,
    set_values,
    to_json,
    write_bytes_atomically,
)
from app.free_matrix import properties
from app.notation import latex_name, latex_number
from app.phenomena import PHENOMENA
from app.precision import RUNGS, Prediction, Rung, predict, rung_for_reading, trace
from app.projection import (
    BOTTOM_BEFORE_TOP,
    FINITE_NUMBER,
    LARGEST,
    LARGEST_IMAGE_PX,
    LEFT_BEFORE_RIGHT,
    LENSES,
    NEAR_BEFORE_FAR,
    NOT_THE_EYE,
    PLANES,
    WHOLE_PIXELS,
    Array,
    FreeMatrix,
    Perspective,
    Projection,
    ProjectionError,
    Stage,
    Trace,
    format_value,
)

if TYPE_CHECKING:
    from app.measure.results import Results
    from app.scene import Scene

BAD_INPUT = 2
CANNOT_DRAW = 3
INTERRUPTED = 130

THEMES = ("light", "dark")
LARGEST_INPUT = 2**30
"""Most bytes of points that are read."""


class CliError(Exception):
    """One sentence for standard error, and the exit status."""

    def __init__(self, sentence: str, status: int = BAD_INPUT) -> None:
        super().__init__(sentence)
        self.status = status


def main(argv: list[str] | None = None) -> int:
    """Run a command line.

    Parameters
    ----------
    argv : list of str, optional
        The arguments after the program's name; those of this process by default.

    Returns
    -------
    int
        The exit status: 0 done, 2 bad input, 3 no usable display or OpenGL.
    """
    arguments = sys.argv[1:] if argv is None else argv
    try:
        return _run(arguments)
    except CliError as error:
        return _complain(str(error), error.status)
    except (DocumentError, ProjectionError) as error:
        return _complain(str(error), BAD_INPUT)
    except SystemExit as done:  # argparse, after --help and --version
        return int(done.code or 0)
    except BrokenPipeError:  # “| head” has seen enough
        return 0
    except KeyboardInterrupt:
        return INTERRUPTED


def _complain(sentence: str, status: int) -> int:
    if sys.stderr is not None:
        print(" ".join(sentence.split()), file=sys.stderr)
    return status


def _print(texts: Iterable[str]) -> None:
    """Write to standard output, now: an error must come here, not when Python ends."""
    try:
        for text in texts:
            sys.stdout.write(text)
        sys.stdout.flush()
    except OSError as error:
        # What is still buffered must not fail once more at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if isinstance(error, BrokenPipeError):
            raise
        raise CliError(f"Standard output cannot be written: {error.strerror}.") from error


def _run(arguments: Sequence[str]) -> int:
    if arguments and arguments[0] in COMMANDS:
        return COMMANDS[arguments[0]](arguments[1:])
    if arguments:
        _check_file(arguments[0])  # first: what follows a mistyped command is none of the window's
    return _window(arguments)


# --------------------------------------------------------------------------- arguments


class _Parser(argparse.ArgumentParser):
    """An argument parser whose complaints are sentences, and name the nearest option."""

    def __init__(
        self, command: str, names: str, text: str, description: str, epilog: str = ""
    ) -> None:
        usage = " ".join(f"python3 -m app {command} [options] {names}".split())
        super().__init__(
            usage=usage,
            description=description,
            epilog=epilog,
            formatter_class=argparse.RawDescriptionHelpFormatter,
            allow_abbrev=False,
        )
        self._command = command
        self._names = names
        self.add_argument("words", nargs="*", metavar=names, help=text)

    def error(self, message: str) -> NoReturn:
        raise CliError(f"{message[0].upper()}{message[1:]}.")

    def read(
        self, arguments: Sequence[str], least: int, most: int
    ) -> tuple[argparse.Namespace, list[str]]:
        """Parse options and words in any order; refuse too few words and too many."""
        found, extra = self.parse_known_intermixed_args(arguments)
        for word in extra:
            option = word.partition("=")[0]
            names = [name for action in self._actions for name in action.option_strings]
            where = f"an option of {self._command}" if self._command else "an option of the window"
            raise CliError(f"{option} is not {where}; the nearest is {_nearest(option, names)}.")
        words: list[str] = found.words
        if not least <= len(words) <= most:
            command = self._command or "The window"
            takes = self._names or "no names"
            raise CliError(f"{command} takes {takes}, and {len(words)} names were given.")
        return found, words

    def add_set(self) -> None:
        """Take ``--set``."""
        self.add_argument(
            "--set",
            action="append",
            default=[],
            metavar="NAME=VALUE",
            help="change a value of the document, such as lens.far=inf; may be given repeatedly; "
            f"the names are {', '.join(SETTABLE)} and settings.NAME of the scene's own",
        )

    def add_choice(self, option: str, values: Sequence[str], text: str, default: str = "") -> None:
        """Take one of several values."""
        self.add_argument(
            option,
            type=lambda value: _one_of(option, value, values),
            metavar="|".join(values),
            default=default or None,
            help=text,
        )


def _nearest(word: str, known: Iterable[str]) -> str:
    def likeness(name: str) -> float:
        return difflib.SequenceMatcher(None, word.lower(), name).ratio()

    return max(known, key=likeness)


def _one_of(option: str, value: str, values: Sequence[str]) -> str:
    # CliError is none of the errors that argparse would put into words of its own.
    if value not in values:
        raise CliError(f"{option} = {value!r}: must be one of {', '.join(values)}.")
    return value


def _size(value: str) -> tuple[int, int]:
    match = re.fullmatch(r"([0-9]{1,9})[xX×]([0-9]{1,9})", value)
    if match is None:
        raise CliError(f"--size = {value!r}: must be WIDTHxHEIGHT in pixels, such as 1800x600.")
    width, height = int(match[1]), int(match[2])
    for name, side in (("width", width), ("height", height)):
        if not 1 <= side <= LARGEST_IMAGE_PX:
            bound = WHOLE_PIXELS.format(LARGEST_IMAGE_PX)
            raise CliError(f"--size {name} = {side}: {bound}.")
    return width, height


def _scale(value: str) -> float:
    try:
        return _number(value)
    except ValueError:
        raise CliError(f"--scale = {value!r}: {FINITE_NUMBER}.") from None


def _number(text: str) -> float:
    """A number in the C locale; not what only Python writes, such as 1_000."""
    if "_" in text:
        raise ValueError(text)
    return float(text)


# --------------------------------------------------------------------------- files


def _document(file: str | None, assignments: Sequence[str]) -> Document:
    """The document that a FILE is, holds, or opens with, after the values set by ``--set``.

    Without a FILE, ``scene=NAME`` opens that scene as the menu does: seen with its own camera.
    """
    texts = {key: text.strip() for key, _, text in map(_split, assignments)}
    if file is not None:
        document = _open(file)
        if texts.get("scene"):
            _start(texts["scene"])
    else:
        document = _opened(texts["scene"]) if "scene" in texts else Document()
    try:
        return set_values(document, assignments)
    except DocumentError as error:
        kind = texts.get("lens.kind", document.projection.lens.kind)
        raise _seen_from(texts, kind, error) from error


_OTHER_SIDE = {
    ("lens.near", NEAR_BEFORE_FAR): ("lens.far", "must be greater than near, which is {0}"),
    ("lens.left", LEFT_BEFORE_RIGHT): ("lens.right", "must be greater than left, which is {0}"),
    ("lens.bottom", BOTTOM_BEFORE_TOP): ("lens.top", "must be greater than bottom, which is {0}"),
}


def _seen_from(texts: Container[str], kind: str, error: DocumentError) -> DocumentError:
    """Turn a complaint so that it speaks of what was set.

    The model says "near must be less than far" whichever of the two was set.

    Parameters
    ----------
    texts : container of str
        The paths that were set.
    kind : str
        The lens, perhaps set as well.
    error : DocumentError
        What the document answered.
    """
    if error.field == "lens.far" and error.bound == FINITE_NUMBER and kind == Perspective.kind:
        return DocumentError(f"{FINITE_NUMBER} or inf", field=error.field, value=error.value)
    if error.field in texts:
        return error
    if error.bound == NOT_THE_EYE and "camera.eye" in texts:
        bound = "must differ from the target, or the camera looks nowhere"
        return DocumentError(bound, field="camera.eye", value=error.value)
    other, bound = _OTHER_SIDE.get((error.field, error.bound), ("", ""))
    if other in texts:
        (refused,) = error.limits
        return DocumentError(
            bound, format_value(error.value), field=other, value=float(str(refused))
        )
    return error


def _split(assignment: str) -> tuple[str, str, str]:
    key, equals, text = assignment.partition("=")
    return key.strip(), equals, text


def _opened(scene: str) -> Document:
    name = os.path.abspath(scene) if is_mesh(scene) else scene
    return Document(name, _start(name))


def _start(scene: str) -> Projection:
    """How a scene opens; only what is no phenomenon has to be loaded for that.

    Raises
    ------
    CliError
        If there is no such scene.
    """
    return PHENOMENA[scene].start if scene in PHENOMENA else _load(scene).start


def _open(file: str) -> Document:
    if is_mesh(file):
        return _opened(file)
    _check_file(file)
    return read(file)


def _check_file(word: str) -> None:
    """Take a word that is no file and looks like none for the command that it was to be."""
    if os.path.lexists(word) or not re.fullmatch(r"\w[\w-]*", word):
        return
    if word in COMMANDS:
        raise CliError(f"{word} is a command and must come first: python3 -m app {word} ...")
    near = difflib.get_close_matches(word.lower(), COMMANDS, 1)
    known = f"nearest command is {near[0]}" if near else f"commands are {', '.join(COMMANDS)}"
    raise CliError(f"{word!r} is neither a file nor a command; the {known}.")


@functools.cache
def _load(scene: str, mesh: str = "") -> Scene:
    """Load a scene once, with VTK's import failing like any other lack of a library."""
    try:
        from app.scene import SceneError, load
    except ImportError as error:
        raise _cannot_import(error) from error
    try:
        return load(scene, mesh=mesh)
    except SceneError as error:
        raise CliError(str(error)) from error


def _cannot_import(error: ImportError) -> CliError:
    missing = bootstrap.missing_system("window")
    if missing:
        return CliError(f"{bootstrap.advice(missing)}.", CANNOT_DRAW)
    return CliError(
        f"A library cannot be loaded ({error}); python3 -m app doctor says more.", CANNOT_DRAW
    )


# --------------------------------------------------------------------------- the window


def _window(arguments: Sequence[str]) -> int:
    lines = "\n".join(f"  {name:<10}{text}" for name, text in _SUMMARIES.items())
    parser = _Parser(
        "",
        "[FILE]",
        "a document, an exported PNG picture or a mesh (the letter F)",
        "How a camera turns a 3-D scene into a picture.",
        f"commands, each with its own --help:\n{lines}",
    )
    parser.add_set()
    parser.add_choice("--theme", THEMES, "colours for this once")
    parser.add_argument(
        "--reset", action="store_true", help="delete the settings, then open the window"
    )
    parser.add_argument(
        "--screenshot", metavar="OUT", help="save a picture of the window as PNG and quit"
    )
    parser.add_argument("--size", type=_size, metavar="WIDTHxHEIGHT", help="size of the window")
    parser.add_argument("--version", action="version", version=f"Frustum Lab {__version__}")
    found, words = parser.read(arguments, 0, 1)
    if found.screenshot is not None:
        _check_png("--screenshot", found.screenshot)
    file = words[0] if words else None
    document = _document(file, found.set)
    from_file = is_mesh(document.scene) or document.mesh
    scene = _load(document.scene, document.mesh) if from_file else None
    try:
        from widgets import application
        from widgets.opengl import OpenGLError
    except ImportError as error:
        raise _cannot_import(error) from error
    if found.reset:
        try:
            _print([f"{application.delete_settings()}\n"])
        except OSError as error:
            raise CliError(f"The settings cannot be deleted: {error}.") from error
    is_document = file is not None and not is_mesh(file) and not file.lower().endswith(".png")
    path = Path(os.path.abspath(file)) if file is not None and is_document else None
    screenshot = None if found.screenshot is None else Path(found.screenshot)
    options = application.Options(found.theme, found.size, screenshot)
    try:
        return application.run_window(document, path, options, scene)
    except (application.DisplayError, OpenGLError) as error:
        raise CliError(str(error), CANNOT_DRAW) from error
    except application.WindowError as error:
        raise CliError(str(error)) from error


def _check_png(name: str, out: str) -> None:
    if not out.lower().endswith(".png"):
        raise CliError(f"{name} = {out!r}: must end in .png.")
    folder = os.path.dirname(out) or "."
    if not os.path.isdir(folder):
        raise CliError(f"{name} = {out!r}: there is no folder {folder}.")


# --------------------------------------------------------------------------- export


def _export(arguments: Sequence[str]) -> int:
    text = "the picture (.png), and a document, picture or mesh that it shows (the letter F)"
    parser = _Parser("export", "OUT [FILE]", text, _SUMMARIES["export"])
    parser.add_argument(
        "--panes",
        default="world,ndc,image",
        metavar="world,ndc,image",
        help="which panes, side by side (all)",
    )
    parser.add_argument(
        "--size",
        type=_size,
        metavar="WIDTHxHEIGHT",
        help="pixels at scale 1 (640x640 for each pane, or the image's own size for it alone)",
    )
    parser.add_argument(
        "--scale", type=_scale, default=1.0, metavar="FACTOR", help="the same figure, finer (1)"
    )
    parser.add_argument("--transparent", action="store_true", help="no background")
    parser.add_choice("--theme", THEMES, "colours (light)", "light")
    parser.add_set()
    found, (out, *file) = parser.read(arguments, 1, 2)
    _check_png("OUT", out)
    document = _document(file[0] if file else None, found.set)
    scene = _load(document.scene, document.mesh)
    try:
        check_off_screen()
    except RuntimeError as error:
        raise CliError(str(error), CANNOT_DRAW) from error
    try:
        from app.drawings.style import DARK, LIGHT
        from app.figures import FigureError, render, write_png
    except ImportError as error:
        raise _cannot_import(error) from error
    try:
        pixels = render(
            scene,
            document.projection,
            panes=found.panes.split(","),
            size=found.size,
            scale=found.scale,
            transparent=found.transparent,
            style=DARK if found.theme == "dark" else LIGHT,
            views=document.views,
            settings=document.settings,
            quality=document.quality,
        )
        # A mesh is named from the picture's folder, so that both can be moved together.
        write_png(out, pixels, to_json(document, os.path.dirname(os.path.realpath(out))))
    except FigureError as error:
        raise CliError(str(error)) from error
    return 0


# --------------------------------------------------------------------------- project


def _project(arguments: Sequence[str]) -> int:
    text = (
        "a document, picture or mesh whose camera is used (the letter F's), and the points: "
        "CSV with the columns x,y,z, or - for standard input"
    )
    parser = _Parser("project", "[FILE] POINTS", text, _SUMMARIES["project"])
    parser.add_choice("--format", tuple(_PROJECT_FORMATS), "form of the output (table)", "table")
    parser.add_choice("--rung", RUNGS, "arithmetic (float64, or exact where that is needed)")
    parser.add_set()
    found, (*file, source) = parser.read(arguments, 1, 2)
    if not file and source.lower().endswith((".json", *MESH_ENDINGS)):
        raise CliError(f"POINTS is missing: {source} is what the camera is read from.")
    projection = _document(file[0] if file else None, found.set).projection
    points = _read_points(source)
    predictions = predict(projection, points)
    rung = found.rung or rung_for_reading(predictions)
    traced = trace(projection, points, rung)
    beyond = ~np.isfinite(np.column_stack([traced.view, traced.clip])).all(axis=1)
    if beyond.any():  # float32 ends at 3e38, a document and its points do not
        number = int(beyond.argmax()) + 1
        raise CliError(f"--rung = {rung!r}: point {number} leads to numbers that it cannot hold.")
    answer = _Answer(projection, traced, rung, predictions)
    _print(_PROJECT_FORMATS[found.format](answer))
    return 0


class _Answer(NamedTuple):
    """What `project` prints."""

    projection: Projection
    trace: Trace
    rung: Rung
    predictions: dict[Rung, Prediction] | None


def _read_points(source: str) -> list[tuple[float, float, float]]:
    """World points from a CSV file or standard input; a first row of names may come first."""
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
    points = []
    rows = csv.reader(io.StringIO(text, newline=""), skipinitialspace=True)
    first = True
    try:
        for row in rows:
            cells = [cell.strip() for cell in row]
            if not any(cells):
                continue
            if not (first and [cell.lower() for cell in cells] == ["x", "y", "z"]):
                points.append(_point(cells, f"{name}, line {rows.line_num}"))
            first = False
    except csv.Error as error:
        raise CliError(f"{name}, line {rows.line_num}: is not CSV ({error}).") from error
    if not points:
        raise CliError(f"{name} has no points: it must have rows of x,y,z.")
    return points


def _read_input(source: str) -> bytes:
    if source == "-":
        if sys.stdin is None:
            raise OSError("it is closed")
        content: bytes = sys.stdin.buffer.read(LARGEST_INPUT + 1)
    else:
        with open(source, "rb") as file:
            content = file.read(LARGEST_INPUT + 1)
    if len(content) > LARGEST_INPUT:
        raise OSError(f"it is larger than {LARGEST_INPUT // 2**20} MiB")
    return content


def _point(cells: list[str], where: str) -> tuple[float, float, float]:
    if len(cells) != 3:
        found = "1 column" if len(cells) == 1 else f"{len(cells)} columns"
        raise CliError(f"{where}: has {found}, must have three: x,y,z.")
    values = []
    for name, cell in zip("xyz", cells, strict=True):
        try:
            value = _number(cell)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise CliError(f"{where}: {name} = {cell!r}: {FINITE_NUMBER}.")
        if abs(value) > LARGEST:
            raise CliError(f"{where}: {name} = {cell}: must lie within ±{LARGEST}.")
        values.append(value)
    x, y, z = values
    return x, y, z


def _outside_of(outside: list[bool]) -> list[str]:
    return [plane for plane, is_outside in zip(PLANES, outside, strict=True) if is_outside]


def _points_of(trace: Trace) -> Iterator[dict[str, Any]]:
    """Each point as DESIGN section 8 writes it; `None` where there is no picture of it."""
    columns = (trace.world, trace.view, trace.clip, trace.ndc, trace.image, trace.depth)
    rows = zip(
        *(_plain(column) for column in columns),
        trace.in_front.tolist(),
        trace.outside.tolist(),
        strict=True,
    )
    for world, view, clip, ndc, image, depth, in_front, outside in rows:
        outside_of = _outside_of(outside)
        yield {
            "world": world,
            "view": view,
            "clip": clip,
            "ndc": ndc if in_front else None,
            "image": image if in_front else None,
            "depth": depth if in_front else None,
            "inside": in_front and not outside_of,
            "outside_of": outside_of,
        }


def _plain(array: Array) -> list[Any]:
    """Python floats, whose repr is the shortest text that reads back the same; no minus zero."""
    return (array + 0.0).tolist()  # type: ignore[no-any-return]


def _project_json(answer: _Answer) -> Iterator[str]:
    separator = '{"points": [\n'
    for point in _points_of(answer.trace):
        yield separator + json.dumps(point, allow_nan=False)
        separator = ",\n"
    names = ("view_from_world", "clip_from_view", "clip_from_world")
    stages = (*answer.projection.stages, *answer.projection.direct_stages)
    matrices = {stage.name: _plain(stage.matrix) for stage in stages if stage.name in names}
    yield f'\n],\n"matrices": {json.dumps(matrices, allow_nan=False)},\n'
    errors = {
        rung: {"px": _finite_or_text(error.px), "depth": _finite_or_text(error.depth)}
        for rung, error in (answer.predictions or {}).items()
    }
    chosen = {
        "rung": answer.rung,
        "predicted_error_px": errors[answer.rung]["px"] if errors else None,
        "predictions": errors,
    }
    yield json.dumps(chosen, allow_nan=False)[1:] + "\n"


def _finite_or_text(error: float) -> float | str:
    """JSON has no infinity; the document writes it so, too."""
    return error if math.isfinite(error) else "inf"


_CSV_COLUMNS = (
    ("world", ("world_x", "world_y", "world_z")),
    ("view", ("view_x", "view_y", "view_z")),
    ("clip", ("clip_x", "clip_y", "clip_z", "clip_w")),
    ("ndc", ("ndc_x", "ndc_y", "ndc_z")),
    ("image", ("image_x_px", "image_y_px")),
    ("depth", ("depth",)),
)


def _project_csv(answer: _Answer) -> Iterator[str]:
    columns = [name for _, names in _CSV_COLUMNS for name in names]
    yield ",".join([*columns, "inside", "outside_of"]) + "\n"
    for point in _points_of(answer.trace):
        cells = []
        for stage, names in _CSV_COLUMNS:
            values = point[stage]
            if values is None:
                cells += [""] * len(names)
            else:
                cells += map(repr, values if isinstance(values, list) else [values])
        cells += ["true" if point["inside"] else "false", " ".join(point["outside_of"])]
        yield ",".join(cells) + "\n"


def _project_table(answer: _Answer) -> Iterator[str]:
    labels = (
        ("world", "world"), ("view", "view"), ("clip", "clip"), ("ndc", "NDC"),
        ("image", "image px"), ("depth", "depth"),
    )  # fmt: skip
    for number, point in enumerate(_points_of(answer.trace), start=1):
        rows = [["x", "y", "z", "w"]]
        for stage, _ in labels:
            values = point[stage]
            values = [] if values is None else values if isinstance(values, list) else [values]
            rows.append([format_value(value) for value in values])
        if number > 1:
            yield "\n"
        head, *lines = _aligned(rows)
        yield f"{f'point {number}':<10}  {head}\n"
        for (stage, label), line in zip(labels, lines, strict=True):
            none = "none: the point is not in front of the eye"
            yield f"{label:>10}  {none if point[stage] is None else line}\n"
        beyond = ", ".join(point["outside_of"])
        yield f"{'outside of' if beyond else 'inside':>10}  {beyond or 'the view volume'}\n"
    if answer.predictions is not None:
        errors = [f"{rung} {error.px:.1e} px" for rung, error in answer.predictions.items()]
        yield f"\ncomputed in {answer.rung}; largest errors: {', '.join(errors)}\n"


_PROJECT_FORMATS: dict[str, Callable[[_Answer], Iterator[str]]] = {
    "table": _project_table,
    "csv": _project_csv,
    "json": _project_json,
}


def _aligned(rows: Sequence[Sequence[str]]) -> list[str]:
    """Write the rows with the numbers of each column under each other at their points.

    A row may be short; its line is as long as its cells.
    """
    columns = max(map(len, rows))
    split = [[re.fullmatch(r"([^.e]*)(.*)", cell, re.DOTALL) for cell in row] for row in rows]
    parts = [[(m[1], m[2]) if m else ("", "") for m in row] for row in split]
    left = [max(len(row[i][0]) for row in parts if i < len(row)) for i in range(columns)]
    right = [max(len(row[i][1]) for row in parts if i < len(row)) for i in range(columns)]
    return [
        "  ".join(
            before.rjust(left[i]) + after.ljust(right[i]) for i, (before, after) in enumerate(row)
        ).rstrip()
        for row in parts
    ]


# --------------------------------------------------------------------------- matrices


def _matrices(arguments: Sequence[str]) -> int:
    text = "a document, picture or mesh whose camera is used (the letter F's)"
    parser = _Parser("matrices", "[FILE]", text, _SUMMARIES["matrices"])
    parser.add_choice("--format", tuple(_MATRIX_FORMATS), "form of the output (text)", "text")
    parser.add_set()
    found, words = parser.read(arguments, 0, 1)
    projection = _document(words[0] if words else None, found.set).projection
    _print([_MATRIX_FORMATS[found.format](projection)])
    return 0


def _all_stages(projection: Projection) -> list[Stage]:
    """Every stage, and the products of those before the divide where they end."""
    *stages, last = projection.stages
    return [*stages, *projection.direct_stages, last]


def _factors(stage: Stage) -> tuple[tuple[str, Array], ...]:
    """The factors that a reader has not seen as stages."""
    return tuple(factor for factor in stage.factors if "_from_" not in factor[0])


def _matrices_text(projection: Projection) -> str:
    blocks = []
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
    rows = [[format_value(value) for value in row] for row in _plain(matrix)]
    return "".join(f"  {line}\n" for line in _aligned(rows))


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


# --------------------------------------------------------------------------- doctor


def _doctor(arguments: Sequence[str]) -> int:
    _Parser("doctor", "", argparse.SUPPRESS, _SUMMARIES["doctor"]).read(arguments, 0, 0)
    missing = []
    for finding in examine():
        _print([f"{finding.name:<20}{finding.text}\n"])
        if finding.remedy:
            missing.append(finding)
    if not missing:
        _print(["\nEverything needed is here.\n"])
        return 0
    lines = [f"  {finding.name}: {finding.remedy}\n" for finding in missing]
    _print(["\nThis is missing:\n", *lines])
    return CANNOT_DRAW


# --------------------------------------------------------------------------- measure


def _measure(arguments: Sequence[str]) -> int:
    try:
        from app import measure
        from app.measure import chart
        from app.measure.arithmetic import SWEEPS
        from app.measure.results import to_csv
        from app.measure.results import to_json as results_to_json
    except ImportError as error:
        raise _cannot_import(error) from error
    text = "a document, picture or mesh to measure (the letter F)"
    parser = _Parser("measure", "[FILE]", text, _SUMMARIES["measure"])
    parser.add_argument(
        "--trade", action="append", metavar="|".join(measure.TRADES),
        type=lambda value: _one_of("--trade", value, tuple(measure.TRADES)),
        help="measure this one; may be given repeatedly (all, if neither --trade nor --sweep is)",
    )  # fmt: skip
    parser.add_argument(
        "--sweep", action="append", metavar="NAME[=LOW:HIGH]", type=_sweep,
        help=f"the errors over a parameter's range; NAME is one of {', '.join(SWEEPS)}",
    )  # fmt: skip
    parser.add_argument("--scene", metavar="NAME", help="as --set scene=NAME")
    parser.add_argument("--quick", action="store_true", help="in half a minute, less exactly")
    parser.add_argument("--json", metavar="FILE", help="write all that was measured; - for here")
    parser.add_argument("--csv", metavar="FILE", help="write the tables, one after the other")
    parser.add_argument("--chart", metavar="FILE", help="draw it all: .png, or .pdf in vectors")
    parser.add_argument(
        "--attended", action="store_true",
        help="tell the fraction done, a line each, and obey pause, resume and cancel from"
        " standard input",
    )  # fmt: skip
    parser.add_set()
    found, words = parser.read(arguments, 0, 1)
    if found.attended and sys.platform != "win32":
        os.nice(10)  # whoever attends draws meanwhile, and comes first; alone it is as fast
    for option in ("json", "csv", "chart"):
        _check_folder(f"--{option}", getattr(found, option))
    if found.chart is not None and not found.chart.lower().endswith(chart.ENDINGS):
        raise CliError(f"--chart = {found.chart!r}: must end in {' or '.join(chart.ENDINGS)}.")
    settings = [*found.set, *([f"scene={found.scene}"] if found.scene else [])]
    document = _document(words[0] if words else None, settings)
    scene = _load(document.scene, document.mesh)
    if isinstance(document.projection.lens, FreeMatrix):
        raise CliError(
            "lens.kind = matrix: a free matrix has no near, no far and no angle to measure; it must"
            f" be one of {', '.join(LENSES)}."
        )
    everything = not (found.trade or found.sweep)
    trades = list(dict.fromkeys(found.trade or (measure.TRADES if everything else ())))
    swept = dict(found.sweep or ())
    if everything:
        swept = dict.fromkeys(SWEEPS, (None, None))
    opengl = True
    try:
        check_off_screen()
    except RuntimeError as error:
        opengl = False
        left_out = [name for name in trades if name in measure.NEED_OPENGL]
        if left_out:
            _complain(f"{error} Not measured: {', '.join(left_out)}.", 0)
        trades = [name for name in trades if name not in left_out]
        if not trades and not swept:
            return CANNOT_DRAW
    with _watched(found.attended) as watch:
        results = measure.measure_all(
            document, scene, trades, swept, quick=found.quick, opengl=opengl, watch=watch
        )
    json_text = results_to_json(results)
    if found.json == "-":
        _print([json_text])
    else:
        _print(_measured(results))
    if found.json not in (None, "-"):
        _write(found.json, json_text)
    if found.csv is not None:
        _write(found.csv, "\n".join([*map(to_csv, results.trades), *map(to_csv, results.sweeps)]))
    if found.chart is not None:
        write_bytes_atomically(found.chart, chart.picture(results, found.chart))
    return 0 if results.complete else INTERRUPTED


def _sweep(value: str) -> tuple[str, tuple[float | None, float | None]]:
    """``near`` or ``near=1e-3:10``."""
    from app.measure.arithmetic import SWEEPS

    name, equals, ends = value.partition("=")
    _one_of("--sweep", name, tuple(SWEEPS))
    if not equals:
        return name, (None, None)
    try:
        low, high = (_number(end) for end in ends.split(":"))
    except ValueError:
        raise CliError(f"--sweep {name} = {ends!r}: must be LOW:HIGH, such as 0.001:10.") from None
    whole = SWEEPS[name]
    if not whole.low <= low < high <= whole.high:
        raise CliError(
            f"--sweep {name} = {ends!r}: must rise, and lie between {whole.low:g} and"
            f" {whole.high:g}."
        )
    return name, (low, high)


def _check_folder(name: str, out: str | None) -> None:
    folder = os.path.dirname(out or "") or "."
    if out != "-" and not os.path.isdir(folder):
        raise CliError(f"{name} = {out!r}: there is no folder {folder}.")


def _write(path: str, text: str) -> None:
    write_bytes_atomically(path, text.encode())


@contextmanager
def _watched(attended: bool) -> Iterator[Callable[[float], None]]:
    """Tells how far the measurement is, and stops it when it is told to: Ctrl-C, or ``cancel``."""
    from app.measure.run import Cancelled

    cancelled, going = threading.Event(), threading.Event()
    going.set()
    told = -1.0

    def watch(fraction: float) -> None:
        nonlocal told
        going.wait()
        if cancelled.is_set():
            raise Cancelled
        if abs(fraction - told) >= 0.01 and sys.stderr is not None:
            told = fraction
            if attended:
                print(f"{fraction:.3f}", file=sys.stderr, flush=True)
            elif sys.stderr.isatty():
                print(f"\r{100.0 * fraction:3.0f} % ", end="", file=sys.stderr, flush=True)

    def obey() -> None:
        for line in sys.stdin:
            if line.strip() == "pause":
                going.clear()
            elif line.strip() == "resume":
                going.set()
            else:
                break
        cancelled.set()  # also when whoever attended has gone
        going.set()

    former = signal.signal(signal.SIGINT, lambda *_: cancelled.set())
    if attended:
        threading.Thread(target=obey, daemon=True).start()
    try:
        yield watch
    finally:
        signal.signal(signal.SIGINT, former)
        if not attended and sys.stderr is not None and sys.stderr.isatty():
            print("\r      \r", end="", file=sys.stderr, flush=True)


def _measured(results: Results) -> Iterator[str]:
    """Tables to read, with what each trade means."""
    from app.measure.meaning import meaning
    from app.measure.results import table

    for trade in results.trades:
        yield f"{trade.name}{'' if trade.complete else ' (cancelled)'}\n"
        yield from _lines_of(table(trade), str.ljust)
        yield f"{meaning(trade).sentence()}\n\n"
    for sweep in results.sweeps:
        yield f"{sweep.parameter}, largest error in px{'' if sweep.complete else ' (cancelled)'}\n"
        yield from _lines_of(table(sweep), str.rjust)
        yield "\n"


def _lines_of(rows: list[list[str]], align_names: Callable[[str, int], str]) -> Iterator[str]:
    """A table's lines; names as they are wanted, numbers to the right, notes at the end."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for name, *cells, note in rows:
        numbers = [cell.rjust(width) for cell, width in zip(cells, widths[1:-1], strict=True)]
        yield f"  {'  '.join([align_names(name, widths[0]), *numbers, note]).rstrip()}\n"


_SUMMARIES = {
    "export": "draw a figure into a PNG picture, without a window or display",
    "project": "follow points through every stage of the projection",
    "matrices": "print every stage's matrix",
    "measure": "measure what speed costs in accuracy, here, for a scene and a camera",
    "doctor": "say what this machine has, what is missing and how to get it",
}

COMMANDS: dict[str, Callable[[Sequence[str]], int]] = {
    "export": _export,
    "project": _project,
    "matrices": _matrices,
    "measure": _measure,
    "doctor": _doctor,
}
"""The words that the command line may begin with; each takes the arguments after it."""
