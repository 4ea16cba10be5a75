"""The results of measurements and their file format; needs only the standard library.

A `Trade` is one chart: choices, each with a cost and an error. A `Sweep` holds the errors of
several choices over a range of one parameter, or the smallest gaps for near and far.
`Measurements` hold everything that one run measured and everything needed to repeat it. The page
``docs/measurements.md`` shows the file.
"""

import csv
import io
import json
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field, fields, is_dataclass, replace
from functools import partial
from types import UnionType
from typing import Any, get_args, get_origin, get_type_hints

from app.languages import translate, with_comma
from app.model.parameters import ASPECT, DISTANCE, FAR, FOV_Y, NEAR, UP
from app.model.refusal import MEASURE, REFUSALS, SENTENCES, Refusal

of_measure = partial(translate, context="Measure")
"""Translate a text of this room."""

FORMAT = "frustum-lab-measurements"
VERSION = 2

_BUSY = 3.0  # a 95th percentile of more than this many least times comes from other programs
STEADY = 0.05  # least times that differ by a smaller part are equal: rounds repeat them no better
COLUMNS = SENTENCES["Measure/columns"]
SWEEP_NOTES = {  # what a sweep changes besides its parameter, because near must be less than far
    NEAR.formula: MEASURE["sweep-notes-near-formula"],
    FAR.formula: MEASURE["sweep-notes-far-formula"],
}
OVER_DISTANCE = "gap"  # sweep of the smallest gap over the distance of a surface, for all formats
SWEPT = (*(each.formula for each in (NEAR, FAR, FOV_Y, DISTANCE, UP, ASPECT)), OVER_DISTANCE)
"""The parameters that can be swept."""
GAPS = (NEAR.formula, FAR.formula, OVER_DISTANCE)
"""The sweeps of the smallest gap in depth, in world units; the others have errors in px."""
JUDGED = MEASURE["judged"].format(64)  # the definition of the errors of trade 1 and of the sweeps
_SWEPT_FIELDS = {each.formula: each.path for each in (NEAR, FAR, FOV_Y)}
_DRAWN = {"float32": {"rung": "float32"}, "float64, every stage": {"rung": "float64"}}
BUFFERS = {  # the depth buffers of the sweeps of near and far, as of `ChartPoint.use`
    "fixed16": {"depth_format": "fixed16", "depth_mapping": "opengl"},
    "fixed24": {"depth_format": "fixed24", "depth_mapping": "opengl"},
    "float32": {"depth_format": "float32", "depth_mapping": "opengl"},
    "float32, reversed": {"depth_format": "float32", "depth_mapping": "reversed"},
}
EVERY_BUFFER: tuple[str, ...] = (
    "fixed8", "fixed16", "fixed24", "fixed32", "float16", "float32", "float32, reversed",
    "fixed24, logarithmic",
)  # fmt: skip
"""The formats of the sweep over the distance, with their mapping if it is none of OpenGL."""
WORDS = (  # the translatable parts of the names of choices and columns
    *SENTENCES["Measure/words"].values(),
    MEASURE["busy"],
    MEASURE["unsteady"],
    *COLUMNS.values(),
    *SWEEP_NOTES.values(),
    MEASURE["judged"],
    MEASURE["gap"],
    MEASURE["gap-there"],
)


@dataclass(frozen=True)
class ChartPoint:
    """One point of a chart.

    - `cost`, `cost_p95`: least time and 95th percentile, in the trade's unit; None if they were not
      measured.
    - `error`: the largest error; None if there is no number. Then `note` gives the reason.
    - `predicted`: the error that the model predicts before the measurement.
    - `values`: further columns of the table.
    - `use`: the settings that the panes take when the user picks this choice:
      ``{"rung": "float32"}``.
    - `bytes`: memory of a point, an edge, a pixel or a mesh, which is the same on every machine.
    - `library`: another library's code: a reference mark that competes with no choice of this
      program.
    - `steady`: whether the least time was repeated before the time ran out; older files do not say
      it.
    """

    name: str
    cost: float | None
    cost_p95: float | None
    error: float | None
    predicted: float | None = None
    values: Mapping[str, float] = field(default_factory=dict, hash=False)
    note: str = ""
    use: Mapping[str, str] = field(default_factory=dict, hash=False)
    bytes: float | None = None
    library: bool = False
    steady: bool = True

    @property
    def doubt(self) -> str:
        """Why the timing is not trusted, such as other programs; empty if it is."""
        if self.cost_p95 is not None and self.cost_p95 > _BUSY * (self.cost or 0.0):
            return MEASURE["busy"]
        return "" if self.steady else MEASURE["unsteady"]


@dataclass(frozen=True)
class Trade:
    """Choices that trade speed for accuracy.

    `rounds` is how often each choice was run; `complete` is False after a cancellation.
    """

    name: str
    cost_unit: str
    error_unit: str
    choices: tuple[ChartPoint, ...]
    rounds: int
    complete: bool = True

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of all further columns, in order."""
        return tuple(dict.fromkeys(name for choice in self.choices for name in choice.values))

    @property
    def paid(self) -> tuple[str, ...]:
        """The fields of `ChartPoint` that are costs here."""
        return ("cost",) if self.cost_unit == "B" else ("cost", "cost_p95", "bytes")

    def by_cost(self, cost: str) -> "Trade":
        """Return the trade with its bytes as its costs, if it has both and ``"bytes"`` is asked."""
        if cost != "bytes" or all(choice.bytes is None for choice in self.choices):
            return self
        paid = tuple(replace(c, cost=c.bytes, cost_p95=c.bytes, steady=True) for c in self.choices)
        return replace(self, cost_unit="B", choices=paid)

    @property
    def frontier(self) -> tuple[ChartPoint, ...]:
        """The program's choices that none of the others beats in cost and error, cheapest first.

        A choice is also beaten if a more exact one takes the same time, within `STEADY`.
        """
        placed = [c for c in self.choices if None not in (c.cost, c.error) and not c.library]
        placed.sort(key=lambda c: (c.cost, c.error))
        better: list[ChartPoint] = []
        for choice in placed:
            if not better or (choice.error or 0.0) < (better[-1].error or 0.0):
                better.append(choice)
        same = 1.0 if self.cost_unit == "B" else 1.0 + STEADY
        best: list[ChartPoint] = []
        for choice in reversed(better):
            if not best or (best[0].cost or 0.0) > same * (choice.cost or 0.0):
                best.insert(0, choice)
        return tuple(best)

    def is_beaten(self, choice: ChartPoint) -> bool:
        """Whether another of the program's choices is no worse in both; such a choice is grey."""
        measured = None not in (choice.cost, choice.error) and not choice.library
        return measured and choice not in self.frontier

    @property
    def doubts(self) -> tuple[str, ...]:
        """The different doubts of the choices' timings."""
        return tuple(dict.fromkeys(choice.doubt for choice in self.choices if choice.doubt))

    def as_cheap(self, choice: ChartPoint) -> list[ChartPoint]:
        """Return the program's other choices of the same cost, within `STEADY` for a time."""
        same = 1.0 if self.cost_unit == "B" else 1.0 + STEADY
        if choice.cost is None:
            return []
        ends = choice.cost / same, choice.cost * same
        others = (c for c in self.choices if c is not choice and not c.library)
        return [c for c in others if c.cost is not None and ends[0] <= c.cost <= ends[1]]


def without_numbers(name: str, error_unit: str, why: str, choice: str = "") -> Trade:
    """Return a trade of time of which nothing can be measured, with the reason."""
    return Trade(name, "ns", error_unit, (ChartPoint(choice, None, None, None, note=why),), 0)


@dataclass(frozen=True)
class ErrorCurve:
    """The errors of one choice in px and in depth, one for each value of the sweep.

    None, predictions and notes mean what they mean in `ChartPoint`.
    """

    errors: tuple[float | None, ...]
    errors_depth: tuple[float | None, ...]
    predicted: tuple[float | None, ...]
    predicted_depth: tuple[float | None, ...]
    notes: tuple[str, ...]


@dataclass(frozen=True)
class Sweep:
    """The errors over a range of one parameter; `complete` is False after a cancellation."""

    parameter: str
    unit: str
    values: tuple[float, ...]
    curves: Mapping[str, ErrorCurve] = field(hash=False)
    complete: bool = True

    def use(self, row: int, column: int, lens: object = None) -> dict[str, str]:
        """Return what draws the panes with a cell of the table, in the form of `ChartPoint.use`.

        A curve's column adds its depth buffer or precision. Empty if the panes cannot draw it. For
        a distance it is the scene of the depth buffer, with the planes of the measured `lens`.
        """
        name = list(self.curves)[column - 1] if 0 < column <= len(self.curves) else ""
        if self.parameter == OVER_DISTANCE and row < len(self.values):
            use = {"scene": "depth-buffer", DISTANCE.path: repr(self.values[row])}
            planes = lens if isinstance(lens, dict) else {}
            use |= {f"lens.{each}": str(planes[each]) for each in ("near", "far") if each in planes}
            form, _, mapping = name.partition(", ")
            if form:
                use |= {"settings.format": form, "settings.range": mapping or "standard"}
            return use
        field = _SWEPT_FIELDS.get(self.parameter, "")
        if not field or row >= len(self.values):
            return {}
        drawn = BUFFERS if self.parameter in GAPS else _DRAWN
        return {field: repr(self.values[row]), **drawn.get(name, {})}


@dataclass(frozen=True)
class Measurements:
    """All measurements of one run."""

    date: str  # ISO 8601 with a time zone
    machine: Mapping[str, str] = field(hash=False)
    versions: Mapping[str, str] = field(hash=False)
    document: Mapping[str, Any] = field(hash=False)  # scene and projection, as in their document
    trades: tuple[Trade, ...] = ()
    sweeps: tuple[Sweep, ...] = ()
    complete: bool = True  # false if the run was cancelled

    def by_cost(self, cost: str) -> "Measurements":
        """Return the results with every trade `by` this cost."""
        return replace(self, trades=tuple(trade.by_cost(cost) for trade in self.trades))


# --------------------------------------------------------------------------- text


_PLACES = {  # where the file has a field, if not under the field's own name
    "cost_unit": ("cost", "unit"),
    "error_unit": ("error", "unit"),
    "curves": ("choices",),
    "errors": ("error",),
    "errors_depth": ("error_depth",),
}


def _plain_tree(value: Any) -> Any:
    """Return a value in JSON's own types; NaN becomes None and infinity ``"inf"``."""
    if isinstance(value, float):
        return None if math.isnan(value) else "inf" if value == math.inf else value
    if isinstance(value, Mapping):
        return {key: _plain_tree(part) for key, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain_tree(part) for part in value]
    if not is_dataclass(value):
        return value
    tree: dict[str, Any] = {}
    for part in fields(value):
        *above, key = _PLACES.get(part.name, (part.name,))
        place = tree.setdefault(above[0], {}) if above else tree
        place[key] = _plain_tree(getattr(value, part.name))
    return tree | ({"columns": list(value.columns)} if isinstance(value, Trade) else {})


def to_json(results: Measurements) -> str:
    tree: dict[str, Any] = {"format": FORMAT, "version": VERSION, **_plain_tree(results)}
    return json.dumps(tree, allow_nan=False, indent=1) + "\n"


def from_json(text: str, file: str = "The file") -> Measurements:
    """Read what `to_json` wrote; messages name the `file`.

    Raises a `Refusal` if it is not a file of measurements, has another version, or is damaged.
    """
    try:
        tree = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise Refusal.saying(REFUSALS["not-results"], file) from error
    if not isinstance(tree, dict) or tree.get("format") != FORMAT:
        raise Refusal.saying(REFUSALS["not-results"], file)
    if tree.get("version") != VERSION:
        raise Refusal.saying(REFUSALS["newer-results"], file, tree.get("version"), VERSION)
    try:
        results: Measurements = _read(Measurements, tree, "")
    except (ValueError, OverflowError) as error:
        raise Refusal.saying(REFUSALS["results-damaged"], file, str(error)) from None
    return results


_JSON_TYPES: dict[Any, tuple[Any, str]] = {
    str: (str, "a text"),
    bool: (bool, "true or false"),
    int: ((int, float), "a number"),
    float: ((int, float), "a number"),
    tuple: (list, "a list"),
    Mapping: (dict, "an object"),
}


def _read(kind: Any, value: Any, path: str) -> Any:
    """Return a value of a type, which may be a dataclass; the `path` names it if it is damaged."""
    made, parts = get_origin(kind) or kind, get_args(kind)
    if kind is Any:
        return value
    if made is UnionType:
        return None if value is None else _read(parts[0], value, path)
    if kind is float and value == "inf":
        return math.inf
    of_json, name = _JSON_TYPES.get(made, (dict, "an object"))
    if not isinstance(value, of_json) or (isinstance(value, bool) and kind is not bool):
        raise ValueError(f"{path} must be {name}")
    if made is tuple:
        return tuple(_read(parts[0], part, f"{path}[{i}]") for i, part in enumerate(value))
    if made is Mapping:
        return {key: _read(parts[1], part, f"{path}.{key}") for key, part in value.items()}
    return _read_fields(kind, value, path) if is_dataclass(kind) else made(value)


def _read_fields(kind: Any, tree: dict[str, Any], path: str) -> Any:
    hints, values = get_type_hints(kind), {}
    for part in fields(kind):
        if part.name == "steady" and "steady" not in tree:
            continue
        value, place = tree, path
        for key in _PLACES.get(part.name, (part.name,)):
            value = _read(Mapping[str, Any], value, place)
            place = f"{place}.{key}".removeprefix(".")
            if key not in value:
                raise ValueError(f"{place} is missing")
            value = value[key]
        values[part.name] = _read(hints[part.name], value, place)
    if kind is Sweep:
        count = len(values["values"])
        for name, curve in values["curves"].items():
            if any(len(getattr(curve, part.name)) != count for part in fields(curve)):
                raise ValueError(f"{path}.choices.{name} must be as long as the sweep's values")
    return kind(**values)


def to_csv(part: Trade | Sweep) -> str:
    """Return one trade or sweep as CSV: commas, decimal points, column names in the first row."""
    rows: list[list[object]] = []
    if isinstance(part, Trade):
        unit = part.cost_unit
        heads = {"cost": f"cost_{unit}", "cost_p95": f"cost_p95_{unit}", "bytes": "bytes"}
        head = ["choice", *(heads[name] for name in part.paid), f"error_{part.error_unit}"]
        rows.append([*head, "predicted", *part.columns, "note"])
        for c in part.choices:
            row: list[object] = [c.name, *(getattr(c, name) for name in part.paid)]
            row += [c.error, c.predicted, *(c.values.get(name) for name in part.columns)]
            rows.append([*row, _note(c)])
    else:
        rows.append([part.parameter, *part.curves])
        for i, value in enumerate(part.values):
            rows.append([value, *(curve.errors[i] for curve in part.curves.values())])
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    for row in rows:
        writer.writerow(["" if cell is None else cell for cell in row])
    return text.getvalue()


def _note(choice: ChartPoint) -> str:
    return ", ".join(filter(None, (choice.note, choice.doubt)))


CANCELLED = MEASURE["cancelled"]  # the note of a choice that was not timed


def named(name: str) -> str:
    """Translate the name of a choice or column, or a note, part by part: ``affine, 4 pieces``.

    A text without a part in `WORDS` is translated as a whole.
    """

    def part(text: str) -> str:
        numbers = re.findall(r"(?<![A-Za-z\d])\d+(?![\dA-Za-z.])", text)
        if numbers and text.replace(numbers[0], "{0}") in WORDS:
            return of_measure(text.replace(numbers[0], "{0}")).format(numbers[0])
        return of_measure(text) if text in WORDS else text

    parts = name.split(", ")
    if any(part(text) != text for text in parts):
        return with_comma(", ".join(map(part, parts)))
    return with_comma(of_measure(name)) if name else name


def plain(value: float | None, digits: int) -> str:
    """Format a number with some digits, without exponent below ten million; ``-`` for None."""
    if value is None:
        return "-"
    text = f"{value:.{digits}g}"
    return f"{value:.0f}" if "e+" in text and abs(value) < 1e7 else text


def table(part: Trade | Sweep, *, all_digits: bool = False) -> list[list[str]]:
    """Return one trade or sweep as text: a row of headings, then a row per choice or value.

    `all_digits` writes a sweep's values, which are exact, with every digit. ``-`` stands for a
    missing number; the row's last cell then gives the reason. The last heading defines the errors
    and names what a sweep changes besides its parameter.
    """
    if isinstance(part, Trade):
        columns = part.columns
        heads = {"cost": part.cost_unit, "cost_p95": "p95", "bytes": "bytes"}
        rows = [["", *(heads[name] for name in part.paid), part.error_unit, "predicted"]]
        judged = JUDGED if part.name == "arithmetic" else ""
        rows[0] += [*(COLUMNS.get(name, name) for name in columns), judged]
        for choice in part.choices:
            numbers = [getattr(choice, name) for name in part.paid]
            numbers += [choice.error, choice.predicted]
            numbers += [choice.values.get(name) for name in columns]
            cells = [plain(number, 3) for number in numbers]
            unmeasured = choice.cost is None and not part.complete
            rows.append([choice.name, *cells, _note(choice) or (CANCELLED if unmeasured else "")])
        return rows
    name = ", ".join(filter(None, (part.parameter, part.unit)))
    judged = MEASURE["gap"] if part.parameter in GAPS else JUDGED
    judged = MEASURE["gap-there"] if part.parameter == OVER_DISTANCE else judged
    notes = filter(None, (judged, SWEEP_NOTES.get(part.parameter)))
    rows = [[name, *part.curves, ", ".join(notes)]]
    for i, value in enumerate(part.values):
        said = [f"{name} {c.notes[i]}" for name, c in part.curves.items() if c.notes[i]]
        cells = [plain(curve.errors[i], 2) for curve in part.curves.values()]
        rows.append([repr(value) if all_digits else _swept(value), *cells, "; ".join(said)])
    return rows


def _swept(value: float) -> str:
    """Format a sweep's value; a field of view just below 180 degrees keeps more digits."""
    text = plain(value, 4)
    return f"{value:.15g}" if text == "180" else text
