"""Run the requested trades and sweeps one after the other."""

import json
import os
import platform
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime

import numpy as np
import vtkmodules

from app import __version__
from app.document.codec import to_json
from app.document.document import Document
from app.measure import (
    arithmetic,
    cracks,
    depth,
    detail,
    drift,
    interpolation,
    jitter,
    smoothing,
    unprojection,
    vertex_depth,
)
from app.measure.results import GAPS, OVER_DISTANCE, Measurements, Sweep, Trade
from app.measure.run import Watch, part_of, unwatched
from app.measure.sweeps import errors, sweep, values_of
from app.model.projection import Projection
from app.model.refusal import Cancelled
from app.scenes.scene import Scene

TRADES: dict[str, Callable[[Scene, Projection, float, Watch], Trade]] = {
    "arithmetic": lambda scene, projection, *how: arithmetic.measure(
        projection, scene.sample, scene.origin, *how
    ),
    "interpolation": lambda scene, projection, *how: interpolation.measure(
        projection, scene.corners, *how
    ),
    "depth": lambda _scene, projection, _seconds, watch: depth.measure(projection, watch),
    "smoothing": smoothing.measure,
    "detail": detail.measure,
    "drift": lambda scene, projection, *how: drift.measure(projection, scene.sample, *how),
    "vertex-depth": lambda _, projection, *how: vertex_depth.measure(projection, *how),
    "cracks": lambda _scene, projection, _seconds, _watch: cracks.measure(projection),
    "jitter": lambda scene, projection, *how: jitter.measure(projection, scene.sample, *how),
    "unprojection": lambda scene, projection, *how: unprojection.measure(
        projection, scene.sample, *how
    ),
}
"""Every trade, in the order of measurement."""
NEED_OPENGL = ("smoothing", "detail")  # the trades that render pictures
SECONDS, QUICK_SECONDS = 30.0, 2.0  # timing budget of one trade
STEPS, QUICK_STEPS = 49, 13  # number of values of one sweep


def measure_all(
    document: Document,
    scene: Scene,
    trades: Sequence[str],
    sweeps: Mapping[str, tuple[float | None, float | None]],
    *,
    quick: bool = False,
    opengl: bool = True,
    watch: Watch = unwatched,
) -> Measurements:
    """Measure some of `TRADES` and of `app.measure.sweeps.SWEEPS` with the document's scene.

    A sweep has a range, with None for its usual end. `quick` means shorter timings and fewer
    values: half a minute in all. Without `opengl`, none of `NEED_OPENGL` may be among the trades.
    After a cancellation the results so far are marked as incomplete.
    """
    results = Measurements(
        datetime.now(UTC).isoformat(timespec="seconds"),
        machine(smoothing.renderer_name() if opengl else "none"),
        versions(),
        json.loads(to_json(document)),
    )
    projection = document.projection
    count = len(trades) + len(sweeps)
    parts = [part_of(watch, done / count, (done + 1) / count) for done in range(count)]
    try:
        for name, part in zip(trades, parts, strict=False):
            seconds = QUICK_SECONDS if quick else SECONDS
            trade = TRADES[name](scene, projection, seconds, part)
            results = replace(results, trades=(*results.trades, trade))
        for (parameter, ends), part in zip(sweeps.items(), parts[len(trades) :], strict=True):
            if parameter == OVER_DISTANCE:
                near, far = depth.distances(projection)
                ends = near if ends[0] is None else ends[0], far if ends[1] is None else ends[1]
            values = values_of(parameter, QUICK_STEPS if quick else STEPS, *ends)
            at = depth.gaps if parameter in GAPS else errors
            swept = sweep(parameter, projection, scene.sample, values, part, at)
            results = replace(results, sweeps=(*results.sweeps, swept))
    except Cancelled as cancelled:
        if isinstance(cancelled.partial, Trade):
            results = replace(results, trades=(*results.trades, cancelled.partial))
        elif isinstance(cancelled.partial, Sweep):
            results = replace(results, sweeps=(*results.sweeps, cancelled.partial))
        return replace(results, complete=False)
    return results


def machine(opengl: str) -> dict[str, str]:
    """Describe the computer that measures."""
    return {
        "system": f"{platform.system()} {platform.release().partition('-')[0]}",
        "processor": platform.processor() or platform.machine(),
        "cores": str(os.cpu_count() or 1),
        "opengl": opengl,
    }


def versions() -> dict[str, str]:
    return {
        "frustum-lab": __version__,
        "python": platform.python_version(),
        "numpy": np.__version__,
        "vtk": vtkmodules.__version__,
    }
