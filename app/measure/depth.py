"""Trade 3, depth buffer: bytes per pixel against the least distance it can resolve; its sweeps.

Nothing is rasterised: this module encodes surfaces at known distances as the formats define it.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from app.measure.results import BUFFERS, EVERY_BUFFER, OVER_DISTANCE, ChartPoint, Trade
from app.measure.run import Watch, unwatched
from app.measure.sweeps import SWEEPS, Answer
from app.model.depth import FORMATS, MAPPINGS, DepthBuffer
from app.model.limits import within
from app.model.projection import Array, Projection
from app.model.refusal import MEASURE, Cancelled, Refusal
from app.precision.levels import Prediction

PAIRS = 10_000  # number of pairs of neighbours at even distances from near to far (N. Reed, 2015).
FARTHEST = 1e4  # the pairs' largest distance for an infinite far, in units of near
_EDGES = 4  # edges of a surface's code and the next two: wide and narrow codes may alternate


def measure(projection: Projection, watch: Watch = unwatched) -> Trade:
    """Measure trade 3 for every format and mapping, at the target.

    The cost is bytes of memory per pixel. The error is the distance behind the target, in world
    units, from which on the buffer separates every surface from it. It is measured by encoding, and
    predicted by the buffer's formula.
    """
    lens = projection.lens
    distance = -float(projection.trace(projection.camera.target).view[2])
    names = [(format_, mapping) for format_ in FORMATS for mapping in MAPPINGS]
    choices: list[ChartPoint] = []
    for done, (format_, mapping) in enumerate(names):
        try:
            watch(done / len(names))
        except Cancelled:
            raise Cancelled(replace(_trade(choices), complete=False)) from None
        name = f"{format_}, {mapping}"
        memory = FORMATS[format_].bits / 8.0
        try:
            buffer = DepthBuffer(format_, mapping, lens)
        except Refusal as error:
            choices.append(ChartPoint(name, memory, memory, None, note=str(error)))
            continue
        values = _shares(buffer)
        use = {"depth_format": format_, "depth_mapping": mapping}
        if not lens.near < distance < lens.far:
            choices.append(
                ChartPoint(name, memory, memory, None, None, values, MEASURE["beyond"], use)
            )
            continue
        predicted = float(buffer.gap(distance))
        gap = smallest_gap(buffer, distance)
        choices.append(ChartPoint(name, memory, memory, gap, predicted, values, "", use))
    return _trade(choices)


def _trade(choices: Sequence[ChartPoint]) -> Trade:
    return Trade("depth", "B", "world units", tuple(choices), 1)


def gaps(
    parameter: str, projection: Projection, _points_world: Array, value: float
) -> Mapping[str, Answer]:
    """Return the gap of each of `BUFFERS` at one value of near or far, for `sweeps.sweep`.

    The surface is the target, or at 2 near or far / 2 if the target would lie outside. Over the
    distance, the value is that of the surface, and the gaps are those of `EVERY_BUFFER`.
    """
    lens = SWEEPS[parameter].set(projection, value)[0].lens
    distance, names = value, EVERY_BUFFER
    if parameter != OVER_DISTANCE:
        distance, names = -float(projection.trace(projection.camera.target).view[2]), tuple(BUFFERS)
        distance = distance if distance < lens.far else lens.far / 2.0
        distance = distance if distance > lens.near else 2.0 * lens.near
    answers: dict[str, Answer] = {}
    for name in names:
        form, _, mapping = name.partition(", ")
        try:
            buffer = DepthBuffer(form, mapping or "opengl", lens)
            within("distance", distance, lens.near, lens.far)
        except Refusal as error:
            answers[name] = None, None, str(error)
            continue
        gap, predicted = smallest_gap(buffer, distance), float(buffer.gap(distance))
        measured = Prediction(gap, gap) if math.isfinite(gap) else None
        answers[name] = (
            measured,
            Prediction(predicted, predicted),
            "" if measured else MEASURE["nothing-apart"],
        )
    return answers


def distances(projection: Projection) -> tuple[float, float]:
    """The ends of the sweep over the distance: near, and just before far, where nothing is told."""
    near, far = projection.lens.near, projection.lens.far
    far = min(far, FARTHEST * near) if near > 0.0 else far
    near = near if near > 0.0 else 1e-4 * far
    return (near, far / 1.01) if 0.0 < near < far / 1.01 else (0.1, 1.0)


def _shares(buffer: DepthBuffer) -> dict[str, float]:
    far = min(buffer.far, FARTHEST * buffer.near) if buffer.near > 0.0 else buffer.far
    places = np.linspace(buffer.near, far, PAIRS + 1)
    first, second = places[:-1], places[1:]
    return {
        "collapsed": buffer.collapsed_share(first, second),
        "collapsed_predicted": buffer.predicted_collapsed_share(first, second),
    }


def smallest_gap(buffer: DepthBuffer, distance: float) -> float:
    """Return the gap from which on the codes of all surfaces near a distance differ.

    It is the widest code from the one at `distance`, between near and far, to two codes behind it;
    infinite if the code at `distance` or the next one is that of the far plane.

    The worst surface is the first of its code, so this function walks from edge to edge of the
    codes. The formula for a surface at `distance` assumes that a code begins there. Codes in front
    are narrower; the codes behind reach the formula. The code at `distance` itself counts where
    the next ones are finer.
    """
    edges = [_edge(buffer, distance, buffer.near), _edge(buffer, distance, buffer.far)]
    while len(edges) < _EDGES and math.isfinite(edges[-1]):
        edges.append(_edge(buffer, edges[-1], buffer.far))
    if not all(map(math.isfinite, edges[:3])):
        return math.inf
    return float(np.diff([edge for edge in edges if math.isfinite(edge)]).max())


def _edge(buffer: DepthBuffer, start: float, end: float) -> float:
    """Return where the code of `start` ends towards `end`; near or infinity if it does not."""
    code = buffer.encode(start)
    toward = 1.0 if end > start else -1.0
    end = min(end, 1e300)
    if buffer.encode(end) == code:
        return end if toward < 0.0 else math.inf
    same, gap = start, max(1e-16 * start, 1e-300)
    while abs(gap) < abs(end - start) and buffer.encode(start + toward * gap) == code:
        same, gap = start + toward * gap, 2.0 * gap
    other = start + toward * min(gap, abs(end - start))
    while (middle := (same + other) / 2.0) not in (same, other):
        same, other = (middle, other) if buffer.encode(middle) == code else (same, middle)
    return other
