"""The command ``project``: points through every stage, as a table, CSV or JSON."""

import csv
import io
import json
import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.commands import points
from app.commands.aligned import lengths, lens_line, plain, widths
from app.commands.arguments import document_of
from app.commands.options import Parser
from app.commands.terminal import CliError, write_out
from app.document.document import MESH_ENDINGS
from app.languages import said, sentences, translate
from app.model.projection import PLANES, Array, Projection, Space, Trace
from app.precision import levels
from app.precision.levels import Precision, Prediction, trace


def run(arguments: Sequence[str]) -> int:
    """Print points at every stage; return the exit status."""
    points.check_typed(arguments)
    options, (*file, source) = Parser("project").read(arguments)
    if not file and source.lower().endswith((".json", *MESH_ENDINGS)):
        raise CliError("POINTS is missing: {0} gives the camera only.", source)
    projection = document_of(file[0] if file else None, options.set).projection
    read = points.read(source)
    rows, has_w = np.array(read.points), read.has_w
    space: Space = options.space
    predictions = levels.predict(projection, rows[rows[:, 3] != 0.0, :3], space=space)
    precision = options.rung or levels.precision_for_reading(predictions)
    if has_w:
        traced = levels.trace_homogeneous(projection, rows, precision, space)
    else:
        traced = trace(projection, rows[:, :3], precision, space=space)
    answer = _ProjectedPoints(projection, traced, precision, predictions, space, read.columns)
    if options.format == "table":
        write_out([f"{lens_line(projection)}\n\n"])
    write_out(_PROJECT_FORMATS[options.format](answer))
    return 0


class _ProjectedPoints(NamedTuple):
    projection: Projection
    trace: Trace
    precision: Precision
    predictions: dict[Precision, Prediction] | None
    space: Space
    columns: points.Columns

    @property
    def stages(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """Return each stage and its columns; with w if the points have one."""
        return _HOMOGENEOUS if self.trace.world.shape[1] == 4 else _STAGES

    @property
    def lost(self) -> NDArray[np.bool_]:
        """Return which points have coordinates that the precision cannot hold, (n,)."""
        reached = np.column_stack([self.trace.view, self.trace.clip])
        return np.logical_not(np.isfinite(reached).all(axis=1))

    @property
    def why_lost(self) -> str:
        """Say why: only float32 overflows, and only a typed view matrix divides."""
        if self.precision == "float32":
            return sentences()["not-in-float32"]
        return sentences()["view-at-infinity"]

    @property
    def counts(self) -> tuple[int, int]:
        """The number of columns of a point, and of one without a picture (up to clip space)."""
        columns = [len(names) for _, names in self.stages]
        return sum(columns), sum(columns[:3])

    @property
    def in_world(self) -> int:
        """The number of columns of a point of which only the world coordinates are known."""
        return len(self.stages[0][1])


class _PointBlock(NamedTuple):
    """Some of the points, ready for output."""

    numbers: Array
    """(n, k): the columns of `_ProjectedPoints.stages`; NaN where there is no picture."""
    in_front: list[bool]
    lost: list[bool]
    outside_of: list[tuple[str, ...]]

    @property
    def outcomes(self) -> Iterator[tuple[int, tuple[bool, bool, tuple[str, ...]]]]:
        """Number the points; each is in front or not, lost or not, and outside of some planes."""
        return enumerate(zip(self.in_front, self.lost, self.outside_of, strict=True))

    @property
    def texts(self) -> list[str]:
        """Return all numbers row by row, each as the shortest text that gives the same number."""
        return list(map(repr, self.numbers.ravel().tolist()))


_STAGES: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("world", ("world_x", "world_y", "world_z")),
    ("view", ("view_x", "view_y", "view_z")),
    ("clip", ("clip_x", "clip_y", "clip_z", "clip_w")),
    ("ndc", ("ndc_x", "ndc_y", "ndc_z")),
    ("image", ("image_x_px", "image_y_px")),
    ("depth", ("depth",)),
)
_HOMOGENEOUS = tuple(  # the stages of points that may be at infinity
    (stage, (*names, f"{stage}_w") if stage in ("world", "view") else names)
    for stage, names in _STAGES
)
_BLOCK = 4096


def _blocks(answer: _ProjectedPoints) -> Iterator[_PointBlock]:
    trace, lost = answer.trace, answer.lost
    named = [
        tuple(plane for i, plane in enumerate(PLANES) if code >> i & 1)
        for code in range(1 << len(PLANES))
    ]
    for start in range(0, len(trace.world), _BLOCK):
        part = Trace._make(column[start : start + _BLOCK] for column in trace)
        codes = part.outside @ (1 << np.arange(len(PLANES)))
        stages = part.world, part.view, part.clip, part.ndc, part.image, part.depth
        yield _PointBlock(
            np.column_stack(stages) + 0.0,
            part.in_front.tolist(),
            lost[start : start + _BLOCK].tolist(),
            [named[code] for code in codes.tolist()],
        )


def _project_json(answer: _ProjectedPoints) -> Iterator[str]:
    parts = [
        f'"{stage}": {"[%s]" if len(names) > 1 else "%s"}' % ", ".join(["%s"] * len(names))
        for stage, names in answer.stages
    ]
    seen = "{" + ", ".join(parts)
    unseen = "{" + ", ".join([*parts[:3], *(f'"{stage}": null' for stage, _ in _STAGES[3:])])
    nothing = ", ".join([parts[0], *(f'"{stage}": null' for stage, _ in _STAGES[1:])])
    nothing = f'{{{nothing}, "inside": null, "outside_of": null, "reason": "{answer.why_lost}"'
    count, before_ndc = answer.counts
    names = answer.columns.names
    others = answer.columns.written(
        lambda row: f', "columns": {json.dumps(dict(zip(names, row, strict=True)))}'
    )
    separator = '{"points": [\n'
    for block in _blocks(answer):
        texts, lines = block.texts, []
        for i, (in_front, lost, outside_of) in block.outcomes:
            first = count * i
            if lost:
                known = nothing % tuple(texts[first : first + answer.in_world])
                lines.append(f"{known}{next(others)}}}")
                continue
            form, size = (seen, count) if in_front else (unseen, before_ndc)
            line = form % tuple(texts[first : first + size])
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
    matrices = {stage.name: plain(stage.matrix) for stage in stages if stage.name in wanted}
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
    """Write infinity as in a document, because JSON has none."""
    return error if math.isfinite(error) else "inf"


def _project_csv(answer: _ProjectedPoints) -> Iterator[str]:
    columns = [name for _, names in answer.stages for name in names]
    others = answer.columns.written(lambda row: f",{_csv_row(row)}")
    names = f",{_csv_row(answer.columns.names)}" if answer.columns.names else ""
    reason = [answer.why_lost] if answer.lost.any() else []
    head = [*columns, "inside", "outside_of", *("reason" for _ in reason)]
    yield ",".join(head) + names + "\n"
    count, before_ndc = answer.counts
    none = [""] * (count - before_ndc)
    for block in _blocks(answer):
        texts, lines = block.texts, []
        for i, (in_front, lost, outside_of) in block.outcomes:
            cells = texts[count * i : count * (i + 1)]
            if not in_front:
                cells[before_ndc:] = none
            cells += ["true" if in_front and not outside_of else "false", " ".join(outside_of)]
            cells += ["" for _ in reason]
            if lost:
                cells[answer.in_world :] = [""] * (len(head) - answer.in_world - 1) + reason
            lines.append(",".join(cells) + next(others) + "\n")
        yield "".join(lines)


def _csv_row(cells: list[str]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="").writerow(cells)
    return text.getvalue()


def _project_table(answer: _ProjectedPoints) -> Iterator[str]:
    labels = said("world"), said("view"), said("clip"), "NDC", said("image px"), said("depth")
    wide = max(10, *map(len, labels))
    rows, line = len(labels) + 1, "%*s" * 4 + "\n"
    head, *below = f"%-{wide}s  {line}", *(f"{label:>{wide}}  {line}" for label in labels)
    seen, unseen, nothing = ("".join([head, *below[:count]]) for count in (len(labels), 3, 1))
    # The position of each number in a table of four columns with a header row.
    sizes = [len(names) for _, names in answer.stages]
    places = [4 * row + i for row, size in enumerate(sizes, 1) for i in range(size)]
    numbers, before_ndc = answer.counts
    number = 0
    names = answer.columns.names
    others = answer.columns.written(
        lambda row: "".join(
            f"{_printable(name):>{wide}}  {_printable(text)}\n"
            for name, text in zip(names, row, strict=True)
        )
    )
    for block in _blocks(answer):
        count, texts = len(block.numbers), block.texts
        whole = (block.numbers == np.rint(block.numbers)) & (np.abs(block.numbers) < 1e15)
        for i in np.flatnonzero(whole).tolist():
            texts[i] = texts[i].removesuffix(".0")
        counted = np.zeros((2, count, 4 * rows), dtype=int)
        counted[0, :, :4] = counted[1, :, :4] = 1
        counted[:, :, places] = np.reshape(lengths(texts), (2, count, numbers))
        counted[:, ~np.array(block.in_front), places[before_ndc] :] = 0
        counted[:, np.array(block.lost), places[answer.in_world] :] = 0
        cells = np.full((count, 4 * rows), "", dtype=object)
        cells[:, :4] = "x", "y", "z", "w"
        cells[:, places] = np.array(texts, dtype=object).reshape(count, numbers)
        filled: list[Any] = [None] * (2 * cells.size)
        filled[::2] = widths(*counted.reshape(2, count, rows, 4))
        filled[1::2] = cells.ravel().tolist()
        lines = []
        for i, (in_front, lost, outside_of) in block.outcomes:
            number += 1
            shown, known = (nothing, 1) if lost else (seen, rows - 1) if in_front else (unseen, 3)
            first = 8 * rows * i
            values = filled[first : first + 8 * (known + 1)]
            lines.append("\n" if number > 1 else "")
            lines.append(shown % (said("point {0}", number), *values))
            if known < len(labels):
                numbers_of = block.numbers[i, :before_ndc].tolist()
                why = answer.why_lost if lost else _why_no_picture(numbers_of)
                none = said("none: {0}", said(why))
                lines += [f"{label:>{wide}}  {none}\n" for label in labels[known:]]
            if lost:
                lines.append(next(others))
                continue
            where = said("outside of") if outside_of else said("inside")
            planes = ", ".join(translate(plane, "Plane") for plane in outside_of)
            lines.append(f"{where:>{wide}}  {planes or said('the view volume')}\n")
            lines.append(next(others))
        yield "".join(lines)
    if answer.predictions is not None:
        errors = [
            f"{name} {levels.rounded_up(error.px, 2):.1e} px" if math.isfinite(error.px)
            else said("{0} has no bound", name)
            for name, error in answer.predictions.items()
        ]  # fmt: skip
        bounds = said("computed in {0}; errors are below: {1}", answer.precision, ", ".join(errors))
        yield f"\n{bounds}\n"


def _printable(text: str) -> str:
    """Remove control characters, which a terminal would obey."""
    return "".join(letter if letter.isprintable() else "\ufffd" for letter in text)


def _why_no_picture(numbers: list[float]) -> str:
    """Say why a point has no picture, from its numbers up to clip space."""
    at_infinity, w = len(numbers) > 10 and numbers[3] == 0.0, numbers[-1]
    if w > 0.0:
        return sentences()["too-large-pixel"]
    if not at_infinity:
        return sentences()["not-in-front"]
    return sentences()["opposite" if w < 0.0 else "parallel"]


_PROJECT_FORMATS: dict[str, Callable[[_ProjectedPoints], Iterator[str]]] = {
    "table": _project_table,
    "csv": _project_csv,
    "json": _project_json,
}
