"""Charts of measurements as data, which `widgets.parts.diagram_painter` draws.

A trade's chart shows cost against error with the choices as points. A line joins the choices that
no other choice beats in both; the others are faded, and libraries are circles beside it. A sweep's
chart has a curve for each way of computing, a cross where the way breaks, and a bar along the top
where it has no answer. Both axes are logarithmic, except for a few bytes. A point of error 0 or
infinity is at the edge, and its name says so.
"""

import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import groupby
from typing import Any

import numpy as np

from app.languages import translate, with_comma
from app.measure.results import (
    GAPS,
    ChartPoint,
    Measurements,
    Sweep,
    Trade,
    named,
    of_measure,
    plain,
)
from app.model import parameters
from app.model.refusal import MEASURE, SENTENCES
from app.scenes.phenomena.words import Curve, Diagram, Spot

ENDINGS = (".png", ".svg", ".pdf")  # the formats of `widgets.parts.chart_picture`
TITLES = SENTENCES["Measure/titles"]
_ACROSS = SENTENCES["Measure/across"]
_BYTES = SENTENCES["Measure/bytes"]
_FEW_BYTES = 100.0  # up to here the axis is linear
_UP = SENTENCES["Measure/up"]
_COLOURS = ("u", "n", "v", "accent", "near", "far", "ink", "frustum")
DASHES: tuple[tuple[float, ...], ...] = (  # which tell curves apart without their colours
    (), (6.0, 2.0), (2.0, 2.0), (9.0, 2.0, 2.0, 2.0), (4.0, 4.0), (9.0, 2.0, 2.0, 2.0, 2.0, 2.0),
    (12.0, 4.0), (1.0, 3.0),
)  # fmt: skip
_WIDEST = 1e6  # largest error in px that a sweep's chart shows; beyond it the picture is useless
_WIDE_DEG = 179.0  # a sweep to larger angles has a chart of its own for those above 90 degrees
_SAME = 0.005  # largest distance, in decades, of points that share one name
_HEIGHT = 0.07  # distance of the bars along the top, in parts of the chart


def title(part: Trade | Sweep) -> str:
    """Return the title of a trade or sweep, marked if it was cancelled."""
    name = part.name if isinstance(part, Trade) else part.parameter
    text = of_measure(TITLES[name])
    return text if part.complete else of_measure(MEASURE["cancelled-title"]).format(text)


def titled(part: Trade | Sweep) -> str:
    """Return the title and the remark: a busy machine, a mesh that is not the scene's."""
    notes = [*part.doubts] if isinstance(part, Trade) else []
    if isinstance(part, Trade) and part.name == "detail":
        notes += [choice.note for choice in part.choices[:1]]
    said = "; ".join(named(note) for note in notes if note)
    return ": ".join(filter(None, (title(part), said)))


def where(results: Measurements) -> str:
    """Name the date, the machine and the versions of results."""
    parts = {**results.machine, "cores": f"cores: {results.machine.get('cores', '?')}"}
    machine = ", ".join(filter(None, parts.values()))
    versions = ", ".join(f"{name} {version}" for name, version in results.versions.items())
    return f"{results.date} · {machine} · {versions}"


def machine(results: Measurements) -> str:
    """Name the machine and the date, which distinguish two results."""
    names = (results.machine.get(key, "") for key in ("system", "processor", "opengl"))
    return ", ".join(filter(None, (*names, results.date)))


def seen(results: Measurements) -> str:
    """Name the scene and the camera of results."""

    def tree(section: str) -> dict[str, Any]:
        part = results.document.get(section)
        return part if isinstance(part, dict) else {}

    def short(value: object) -> str:
        return f"{value:.6g}" if isinstance(value, float) else str(value)

    def vector(value: object) -> str:
        return f"({', '.join(map(short, value if isinstance(value, list) else []))})"

    camera, lens = tree("camera"), dict(tree("lens"))
    kind = [str(lens.pop("kind", ""))]
    for name, value in lens.items():
        unit = "°" if name.endswith("_deg") else ""
        field = translate(parameters.TITLES.get(name, name), "Field").lower()
        kind.append(f"{field} {with_comma(short(value))}{unit}")
    return of_measure(MEASURE["seen"]).format(
        os.path.basename(str(results.document.get("mesh") or results.document.get("scene", ""))),
        vector(camera.get("eye")), vector(camera.get("target")), ", ".join(kind),
    )  # fmt: skip


def diagrams(
    part: Trade | Sweep,
    current: Mapping[str, str] | None = None,
    other: Trade | Sweep | None = None,
    other_name: str = "",
) -> tuple[Diagram, ...]:
    """Return the chart of a trade or sweep; two for fields of view on both sides of 90 degrees.

    The chart marks the choice of the settings in use: `current`, in the form of `ChartPoint.use`.
    `other` is the same measurement of the machine `other_name`, which is drawn thinner. Without a
    number there is no chart.
    """
    if isinstance(part, Trade):
        overlaid = other if isinstance(other, Trade) else None
        return _of_trade(part, current or {}, overlaid, other_name)
    return _of_sweep(part, other if isinstance(other, Sweep) else None, other_name)


def in_use(trade: Trade, current: Mapping[str, str]) -> ChartPoint | None:
    """Return the most specific choice whose settings are in use; None if there is none."""
    matching = [c for c in trade.choices if c.use and c.use.items() <= current.items()]
    return max(matching, key=lambda choice: len(choice.use), default=None)


def _ends(values: Iterable[float | None], pad: float) -> tuple[float, float] | None:
    """Return the ends of a logarithmic axis with a margin around the finite, positive values."""
    placed = [v for v in values if v is not None and 0.0 < v < math.inf]
    if not placed:
        return None
    low, high = min(placed), max(placed)
    room = max(0.25, pad * math.log10(high / low)) if high / low < math.inf else 10.0
    return max(low / 10.0**room, 1e-307), min(high * 10.0**room, 1e307)


def _placed(error: float, bottom: float, top: float) -> float:
    """Return where an error is drawn: 0 and infinity go just inside the edges."""
    edge = math.pow(top / bottom, 0.04)
    return min(max(error, bottom * edge), top / edge)


def _of_trade(
    trade: Trade, current: Mapping[str, str], other: Trade | None, other_name: str
) -> tuple[Diagram, ...]:
    shown = [trade, *([other] if other else [])]
    both = [c for each in shown for c in each.choices if c.error is not None]
    costs = [c.cost for c in both if c.cost is not None and 0.0 < c.cost < math.inf]
    if not costs or not any(c.cost in costs for c in trade.choices):
        return ()
    paid = trade.cost_unit == "B"
    memory = paid and max(costs) <= _FEW_BYTES
    across = (0.0, 1.15 * max(costs)) if memory else _ends(costs, 0.2) or (0.1, 10.0)
    up = _ends((c.error for c in both if c.cost in costs), 0.15) or (1e-16, 1.0)

    def point(choice: ChartPoint) -> tuple[float, float]:
        return choice.cost or 0.0, _placed(choice.error or 0.0, *up)

    def points(choices: Iterable[ChartPoint]) -> Any:
        return np.array([point(c) for c in choices if c.cost in costs]).reshape(-1, 2)

    curves = []
    if other is not None:
        curves.append(Curve(points(other.frontier), "v", width=0.6))
        dots = [c for c in other.choices if c.error is not None]
        curves.append(Curve(points(dots), "v", other_name, width=0.7, dots=True))
    frontier = trade.frontier
    curves.append(Curve(points(frontier), "n", width=1.3))
    placed = [c for c in trade.choices if c.cost in costs and c.error is not None]
    # The most important spots are named first.
    now = in_use(trade, current)
    placed.sort(key=lambda c: (c is not now, c not in frontier))
    spots: list[Spot] = []
    named: list[tuple[float, float]] = []
    for choice in placed:
        x, y = point(choice)
        here = [c for c in placed if _is_near(point(c), (x, y))]
        name = "" if any(_is_near(p, (x, y)) for p in named) else _common(here)
        named.append((x, y))
        spots.append(
            Spot(
                x, y, name, choice.name, _tip(trade, choice), "n",
                faded=trade.is_beaten(choice), marked=choice is now, hollow=choice.library,
            )
        )  # fmt: skip
    if any(spot.marked for spot in spots):
        named_now = of_measure(MEASURE["current"]).format(_common(placed[:1]))  # not its neighbours
        spots[0] = replace(spots[0], name=named_now, marked=True)
    return (
        Diagram(
            titled(trade),
            tuple(curves), *across, *up,
            of_measure((_BYTES if paid else _ACROSS)[trade.name]), of_measure(_UP[trade.name]),
            x_log=not memory, y_log=True, spots=tuple(spots),
        ),
    )  # fmt: skip


def _is_near(one: tuple[float, float], other: tuple[float, float]) -> bool:
    return all(abs(math.log10(a / b)) < _SAME for a, b in zip(one, other, strict=True))


def _common(choices: Sequence[ChartPoint]) -> str:
    """Return one name for choices at one place: ``fixed24, opengl / direct3d``."""
    names = [
        named(choice.name) + {0.0: " (0)", math.inf: " (∞)"}.get(choice.error or 0.0, "")
        for choice in choices
    ]
    heads, _, tails = zip(*(name.partition(", ") for name in names), strict=True)
    if len(set(heads)) == 1 and all(tails):
        return f"{heads[0]}, {' / '.join(tails)}"
    return " / ".join(names)


def _tip(trade: Trade, choice: ChartPoint) -> str:
    name = named(choice.name)
    cost, error = plain(choice.cost, 3), plain(choice.error, 3)
    said = f"{name}: {cost} {trade.cost_unit}, {error} {named(trade.error_unit)}"
    why = "" if choice.use else of_measure(MEASURE["measured-only"]).format(name)
    return "; ".join(filter(None, (said, named(choice.note), why)))


def _of_sweep(sweep: Sweep, other: Sweep | None, other_name: str) -> tuple[Diagram, ...]:
    shown = [sweep, *([other] if other else [])]
    errors = [e for each in shown for c in each.curves.values() for e in c.errors]
    gaps = sweep.parameter in GAPS
    widest = math.inf if gaps else _WIDEST
    within = [e if e is None else min(max(e, 1e-20), widest) for e in errors]
    up = _ends((e for e in within if e), 0.12) or (1e-16, 1.0)
    broken = [name for name, c in sweep.curves.items() if any(c.notes) or None in c.errors]
    up = up[0], up[1] * (up[1] / up[0]) ** (_HEIGHT * len(broken))
    values = [v for each in shown for v in each.values if 0.0 < v < math.inf]
    sides: list[tuple[Callable[[float], float], list[float], str]] = [
        (float, values, _ACROSS[sweep.parameter])
    ]
    if sweep.parameter == "fov" and max(values, default=0.0) > _WIDE_DEG:
        sides = [
            (float, [v for v in values if v <= 90.0], _ACROSS["fov"]),
            (lambda v: 180.0 - v, [v for v in values if 90.0 <= v < 180.0], MEASURE["from-180"]),
        ]
    charts = []
    for of_value, inside, label in sides:
        if len(set(inside)) < 2:
            continue
        across = of_value(min(inside)), of_value(max(inside))
        curves: list[Curve] = []
        spots: list[Spot] = []
        for each in reversed(shown):
            kept = [i for i, v in enumerate(each.values) if min(inside) <= v <= max(inside)]
            xs = [of_value(each.values[i]) for i in kept]
            width = 1.3 if each is sweep else 0.5
            if each is not sweep:
                curves.append(Curve(np.empty((0, 2)), "muted", other_name, width))
            for number, (name, curve) in enumerate(each.curves.items()):
                colour = _COLOURS[number % len(_COLOURS)]
                dash = DASHES[number % len(DASHES)]
                ys = [curve.errors[i] for i in kept]
                places = [math.nan if y is None else max(y, up[0] * 1.3) for y in ys]
                line = np.column_stack([xs, places])
                own = named(name) if each is sweep else ""
                keys = [f"{i},{number + 1}" for i in kept] if each is sweep else []
                chosen = keys if each.use(kept[0], number + 1) else []
                curves.append(Curve(line, colour, own, width, keys=tuple(chosen), dash=dash))
                if each is sweep and name in broken:
                    bar_y = up[1] / (up[1] / up[0]) ** (_HEIGHT * (broken.index(name) + 0.5))
                    notes = [curve.notes[i] for i in kept]
                    bars, crosses = _breaks(name, colour, xs, ys, notes, bar_y)
                    curves += bars
                    spots += crosses
        charts.append(
            Diagram(
                title(sweep), tuple(curves), *across, *up, of_measure(label),
                of_measure(_UP["depth"] if gaps else MEASURE["error-px"]),
                x_log=True, y_log=True, spots=tuple(spots),
            )
        )  # fmt: skip
    return tuple(charts)


def _breaks(
    name: str,
    colour: str,
    xs: Sequence[float],
    ys: Sequence[float | None],
    notes: Sequence[str],
    bar_y: float,
) -> tuple[list[Curve], list[Spot]]:
    """Return bars where a curve has no answer, and crosses where it has a note."""
    bars, crosses = [], []

    def kind(i: int) -> tuple[bool, bool]:
        return bool(notes[i]) or ys[i] is None, ys[i] is None

    for (noted, unanswered), run in groupby(range(len(xs)), kind):
        members = list(run)
        if not noted:
            continue
        at = members[-1] if members[0] == 0 else members[0]  # beside the valid part
        y = ys[at]
        if unanswered or y is None:
            ends = [(xs[members[0]], bar_y), (xs[members[-1]], bar_y)]
            bars.append(Curve(np.array(ends), colour, width=2.5))
        place = bar_y if y is None else min(y, bar_y)
        text = f"{name}: {notes[at]}"
        crosses.append(Spot(xs[at], place, text, "", text, colour, broken=True))
    return bars, crosses
