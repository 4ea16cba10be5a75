"""Trade 3, depth buffer: bytes a pixel against what can no longer be told apart.

Nothing is rasterised: a depth buffer's errors are in its codes, and the codes are made here as
the formats define them, of surfaces at known distances.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from app.depth import FORMATS, MAPPINGS, Codes, DepthBuffer
from app.measure.results import Choice, Trade
from app.measure.run import Cancelled, Watch, unwatched
from app.projection import Array, Projection, ProjectionError

PAIRS = 10_000
"""Neighbours among evenly spaced distances from near to far, as N. Reed compares them (2015)."""
FARTHEST = 1e4
"""In units of near: how far pairs reach where far is infinite."""
_PHASES = 256

BEYOND = "the target lies outside of near and far"


def measure(projection: Projection, watch: Watch = unwatched) -> Trade:
    """Measure trade 3: for every format and mapping, at the target.

    Parameters
    ----------
    projection : Projection
    watch : Watch

    Returns
    -------
    Trade
        Cost is bytes of memory a pixel, error the smallest distance behind the target, in world
        units, from which on every surface is told apart from it: found by asking the buffer, and
        predicted by its formula.

    Raises
    ------
    Cancelled
        By `watch`; with the choices done.
    """
    lens = projection.standard_lens
    distance = -float(projection.trace(projection.camera.target).view[2])
    names = [(format_, mapping) for format_ in FORMATS for mapping in MAPPINGS]
    choices: list[Choice] = []
    for done, (format_, mapping) in enumerate(names):
        try:
            watch(done / len(names))
        except Cancelled:
            raise Cancelled(replace(_trade(choices), complete=False)) from None
        name = f"{format_}, {mapping}"
        memory = FORMATS[format_].bits / 8.0
        try:
            buffer = DepthBuffer(format_, mapping, lens.near, lens.far, lens.parallel)
        except ProjectionError as error:
            choices.append(Choice(name, memory, memory, None, note=str(error)))
            continue
        values = _shares(buffer)
        use = {"depth_format": format_, "depth_mapping": mapping}
        if not lens.near < distance < lens.far:
            choices.append(Choice(name, memory, memory, None, None, values, BEYOND, use))
            continue
        predicted = float(buffer.gap(distance))
        found = smallest_gap(buffer, distance)
        choices.append(Choice(name, memory, memory, found, predicted, values, "", use))
    return _trade(choices)


def _trade(choices: Sequence[Choice]) -> Trade:
    return Trade("depth", "B", "world units", tuple(choices), 1)


def _shares(buffer: DepthBuffer) -> dict[str, float]:
    far = min(buffer.far, FARTHEST * buffer.near) if buffer.near > 0.0 else buffer.far
    places = np.linspace(buffer.near, far, PAIRS + 1)
    first, second = places[:-1], places[1:]
    return {
        "collapsed": buffer.collapsed_share(first, second),
        "collapsed_predicted": buffer.predicted_collapsed_share(first, second),
    }


def smallest_gap(buffer: DepthBuffer, distance: float) -> float:
    """From which gap on all surfaces about a distance are told apart, by asking for their codes.

    Parameters
    ----------
    buffer : DepthBuffer
    distance : float
        Between near and far.

    Returns
    -------
    float
        The largest, over surfaces within a code or two before `distance`, of the least gap that
        changes the code; infinite if that of some does not change before far.
    """
    predicted = float(buffer.gap(distance))
    nearest = buffer.near
    if math.isfinite(predicted):
        nearest = max(nearest, distance - 2.0 * predicted)
    starts = np.linspace(nearest, distance, _PHASES)
    codes = buffer.encode(starts)
    if (buffer.encode(np.full_like(starts, min(buffer.far, 1e300))) == codes).any():
        return math.inf
    same, other = np.zeros(_PHASES), _first_different(buffer, starts, codes)
    for _ in range(60):  # halving, for all of them at once
        middle = (same + other) / 2.0
        equal = buffer.encode(np.minimum(starts + middle, buffer.far)) == codes
        same, other = np.where(equal, middle, same), np.where(equal, other, middle)
    return float(other.max())


def _first_different(buffer: DepthBuffer, starts: Array, codes: Codes) -> Array:
    """Some gap of each surface that changes its code."""
    gap = np.maximum(1e-16 * starts, 1e-300)
    while True:
        equal = buffer.encode(np.minimum(starts + gap, min(buffer.far, 1e300))) == codes
        if not equal.any():
            return gap
        gap = np.where(equal, 2.0 * gap, gap)
