"""Trade: ns a point of subtracting the eye, far from the origin, against a jump's error in px.

The eye moves 1 mm a frame, 50 km from the origin (`app.scenes.phenomena.jitter`).
What follows the subtraction is alike. From the origin or from the object, it is the same work.
"""

import numpy as np

from app.measure.arithmetic import MOST_POINTS, looked_at
from app.measure.reference import sample
from app.measure.results import ChartPoint, Trade, without_numbers
from app.measure.run import Watch, timed, unwatched
from app.model.projection import Array, Projection
from app.model.refusal import MEASURE
from app.scenes.phenomena.jitter import jump_errors, paths_of

_DISTANCE = 5e4
_WAYS = {
    "world": ("float32, world coordinates", 12.0), "relative": ("float32, object first", 12.0),
    "two": ("two floats", 24.0),
}  # fmt: skip


def measure(
    projection: Projection, points_world: Array, seconds: float = 10.0, watch: Watch = unwatched
) -> Trade:
    """Measure the jumps of the scene's vertices (n, 3)."""
    points = looked_at(projection, points_world)
    if not len(points):
        return without_numbers("jitter", "px", MEASURE["no-points"])
    choices = []
    for way, (name, size) in _WAYS.items():
        wrong, bounds = jump_errors(paths_of(projection, sample(points)[0], way, _DISTANCE))
        use = {"scene": "jitter", "settings.way": way, "settings.distance": f"{_DISTANCE:g}"}
        error, predicted = float(wrong.max()), float(bounds.max())
        choices.append(ChartPoint(name, None, None, error, predicted, {}, "", use, size))
    high = np.ascontiguousarray(points.T, dtype=np.float32)
    eye, near = high[:, :1].copy(), np.empty_like(high)
    low, rest = np.zeros((2, *high.shape), "f")

    def subtract() -> None:
        np.subtract(high, eye, near)

    def subtract_both() -> None:
        subtract()
        np.subtract(low, eye, rest)
        np.add(near, rest, near)

    (world, _), (relative, _), (two, _) = _WAYS.values()
    runs = {world: subtract, two: subtract_both}
    trade = Trade("jitter", "ns", "px", tuple(choices), 0)
    return timed(trade, runs, seconds, 1e9 / MOST_POINTS, watch, {relative: world})
