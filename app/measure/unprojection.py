"""Trade, back from the picture: ns a point against the error, in parts of the distance.

Every way gets the same pixels and depths, and returns the numbers of `app.precision.unprojecting`
bit for bit. Sums of products are added term by term, without the cells that are 0. The
world's origin is `AWAY` from the eye, where the ways differ most; columns have nearer ones.
"""

from collections.abc import Callable
from fractions import Fraction

import numpy as np

from app.measure.arithmetic import looked_at
from app.measure.reference import sample
from app.measure.results import ChartPoint, Trade, without_numbers
from app.measure.run import Watch, timed, unwatched
from app.model.projection import Array, Projection, Vector
from app.model.refusal import MEASURE
from app.precision.unprojecting import WAYS, exact_points, float32_pixels, followed, kept_matrices
from app.scenes.phenomena.unprojection import origin_away

AWAY = 1e5
NEARER = {"error_1": 1.0, "error_1000": 1e3}  # the distances of the origin in further columns
_NAMES = "inverse of P V", "inverses of P and of V", "ray times depth"
NAMES = dict(zip(WAYS, _NAMES, strict=True))


def timed_way(
    projection: Projection, pixels: Array, way: str, form: str, origin: Vector
) -> Callable[[], Array]:
    """Return a function that unprojects pixels and depths (n, 3) to points (3, n), as hardware."""
    columns = np.vstack([pixels.T, np.ones(len(pixels))]).astype(form)
    spare, steps = np.empty_like(columns[0]), []
    add, multiply, divide = np.add, np.multiply, np.divide
    for (matrix, _), divides in kept_matrices(projection, way, origin, form):
        out, cells = np.empty_like(columns), matrix.astype(form)
        terms = [[(j, row[j]) for j in np.flatnonzero(row)] for row in cells]
        steps.append((out, list(zip(out, terms, strict=True)), divides))

    def run() -> Array:
        point = columns
        for out, rows, divides in steps:
            for row, ((first, cell), *more) in rows:
                multiply(point[first], cell, row)
                for j, cell in more:
                    add(row, cell if j == 3 else multiply(point[j], cell, spare), row)
            if divides:
                for row in out[:3]:
                    divide(row, out[3], row)
            point = out
        return point[:3]

    return run


def measure(
    projection: Projection, points_world: Array, seconds: float = 10.0, watch: Watch = unwatched
) -> Trade:
    """Measure the trade with the scene's vertices (n, 3), from their pixels and depths."""
    trace = projection.trace(looked_at(projection, points_world))
    pixels = float32_pixels(trace.image, trace.depth)
    pixels = pixels[(pixels[:, 2] > 0.0) & (pixels[:, 2] < 1.0)]
    if not len(pixels):
        return without_numbers("unprojection", "of the distance", MEASURE["no-points"])
    away = np.linalg.norm(projection.world_from_image(pixels) - projection.camera.eye, axis=1)
    distances = {"error": AWAY, **NEARER}
    origins = {name: origin_away(projection, each) for name, each in distances.items()}
    judged, where = sample(pixels)
    exact = {name: exact_points(projection, judged, origin) for name, origin in origins.items()}
    choices, runs = [], {}
    for form, size in (("float32", 12.0), ("float64", 24.0)):
        for way, called in NAMES.items():
            errors, predicted = {}, 0.0
            for name, origin in origins.items():
                value, bound = followed(projection, pixels, way, form, origin)
                pairs = zip(value.T[where].tolist(), exact[name], strict=True)
                off = [
                    [float(Fraction(a) - b) for a, b in zip(*pair, strict=True)] for pair in pairs
                ]
                errors[name] = float((np.linalg.norm(off, axis=1) / away[where]).max())
                if name == "error":
                    predicted = float((np.linalg.norm(bound, axis=0) / away).max())
            use = {
                "scene": "unprojection", "settings.way": way, "settings.numbers": form,
                "settings.origin": f"{AWAY:g}",
            }  # fmt: skip
            error = errors.pop("error")
            called = f"{form}, {called}"
            choices.append(ChartPoint(called, None, None, error, predicted, errors, "", use, size))
            runs[called] = timed_way(projection, pixels, way, form, origins["error"])
    trade = Trade("unprojection", "ns", "of the distance", tuple(choices), 0)
    with np.errstate(all="ignore"):
        return timed(trade, runs, seconds, 1e9 / len(pixels), watch)
