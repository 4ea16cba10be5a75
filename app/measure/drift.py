"""Trade: ns a frame of turning a camera against the drift of one round, in pixels.

A frame of products costs one (3, 3) product, and a tenth of what renormalises the axes; two sines
make the axes at once. Many cameras are timed together, so that the work counts and not the calls.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from app.measure.arithmetic import looked_at
from app.measure.reference import sample
from app.measure.results import ChartPoint, Trade, without_numbers
from app.measure.run import Watch, timed, unwatched
from app.model.projection import Array, Projection
from app.model.refusal import MEASURE
from app.precision import drift

_CAMERAS = 1024  # whose axes fit into a processor's cache
_WAYS = {
    "products": "products", "renormalised": "renormalised", "fast": "fast inverse root",
    "sines": "two sines",
}  # fmt: skip


def turning(numbers: str, way: str) -> Callable[[], Any]:
    """Return a function that turns many cameras for `BLOCK` frames."""
    if way == "sines":
        run: Callable[[], Any] = drift.turner(np.linspace(0.0, 6.0, _CAMERAS).astype(numbers))
    else:
        step, first = drift.exact_turn(1).hi.astype(numbers)[:, :, None], np.eye(3)[:, :, None]
        axes = np.array(np.broadcast_to(first, (3, 3, _CAMERAS)), dtype=numbers)
        run = drift.multiplier(step, axes)

    def turn() -> None:
        for _ in range(drift.BLOCK):
            run()
        if way in ("renormalised", "fast"):
            axes[:] = drift.orthonormal(axes, way == "fast")

    return turn


def measure(
    projection: Projection, points_world: Array, seconds: float = 10.0, watch: Watch = unwatched
) -> Trade:
    """Measure the drift of the scene's vertices (n, 3)."""
    points = looked_at(projection, points_world)
    if not len(points):
        return without_numbers("drift", "px", MEASURE["no-points"])
    choices, runs = [], {}
    for numbers in ("float16", "float32", "float64"):
        for way, said in _WAYS.items():
            name, note = (
                f"{numbers}, {said}",
                MEASURE["in-software"] if numbers == "float16" else "",
            )
            px, bounds = drift.errors_px(
                projection, sample(points)[0], *drift.drifted(numbers, way, 1)
            )
            error, predicted = float(np.linalg.norm(px, axis=1).max()), float(bounds.max())
            use = {"scene": "drift", "settings.rounds": "1", "settings.numbers": numbers}
            use["settings.way"] = way
            size = np.dtype(numbers).itemsize * (1.0 if way == "sines" else 9.0)
            choices.append(ChartPoint(name, None, None, error, predicted, {}, note, use, size))
            if not note:
                runs[name] = turning(numbers, way)
    trade = Trade("drift", "ns", "px", tuple(choices), 0)
    return timed(trade, runs, seconds, 1e9 / (drift.BLOCK * _CAMERAS), watch)
