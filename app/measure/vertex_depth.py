"""Trade 7, logarithmic depth at the vertices: ns a pixel and bytes against how far off it is drawn.

The floor of the scene `app.scenes.phenomena.vertex_depth` runs from the lens's near to its far
plane. The exact way computes the logarithm for every pixel, from 1/w, which is linear on the
screen. The cheap way computes it where the floor is cut, and interpolates linearly between.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from app.measure.interpolation import AFFINE_BYTES, SAMPLES_A_PIXEL, aligned, pieced
from app.measure.results import ChartPoint, Trade
from app.measure.run import Watch, timed, unwatched
from app.model.depth import DepthBuffer
from app.model.projection import Array, Projection
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from app.scenes.phenomena.vertex_depth import borders, most_too_far

PIECES = (1, 4, 16, 64, 256, 1024)
NO_EARLY_TEST = QT_TRANSLATE_NOOP(
    "Measure", "this also switches off the early depth test, whose loss is not in this time"
)
_ROUNDINGS = 4.0 * 2.0**-53
"""Bound of what float64 loses, in parts of the distance, times far over near."""


def per_pixel(near: float, far: float, s: Array) -> Callable[[], Array]:
    """Return a function that computes the logarithmic depth at shares s (n,) of the screen."""
    values, scale = aligned(len(s)), -1.0 / math.log(far / near)

    def run() -> Array:
        np.multiply(s, near / far - 1.0, out=values)
        np.add(values, 1.0, out=values)
        np.log(values, out=values)
        return np.multiply(values, scale, out=values)

    return run


def per_vertex(near: float, far: float, s: Array, pieces: int) -> Callable[[], Array]:
    """Return a function that interpolates the logarithmic depth between the pieces' borders."""
    w = borders(near, far, pieces)
    return pieced((1.0 - near / w) / (1.0 - near / far), np.log(w / near) / math.log(far / near), s)


def too_far(near: float, far: float, s: Array, depth: Array) -> float:
    """Return the largest error of drawn depths, in parts of the true distance."""
    ratio, place = np.longdouble(far) / np.longdouble(near), s.astype(np.longdouble)
    true = -np.log(1.0 - place + place / ratio)
    return float(np.abs(np.expm1(depth * np.log(ratio) - true)).max())


def predicted(near: float, far: float, pieces: int) -> float:
    """Return a bound of `too_far`: by the formula of the scene, and for rounding."""
    lost = _ROUNDINGS * (far / near + math.log(far / near))
    if not pieces:  # every pixel is its own
        return lost
    ends = borders(near, far, pieces)
    return float(most_too_far((ends[1:] / ends[:-1]).max())) * (1.0 + lost) - 1.0 + lost


def measure(projection: Projection, seconds: float = 10.0, watch: Watch = unwatched) -> Trade:
    """Measure trade 7. A `Cancelled` that `watch` raises has the errors, and the times so far."""
    lens, height = projection.lens, projection.image_size[1]
    try:
        DepthBuffer("float32", "logarithmic", lens)
    except Refusal as error:
        nothing = ChartPoint("each pixel", None, None, None, note=str(error))
        return Trade("vertex-depth", "ns", "w", (nothing,), 0)
    near, far = lens.near, lens.far
    s = aligned(SAMPLES_A_PIXEL * height)
    s[:] = np.linspace(0.0, 1.0, len(s))
    runs = {"each pixel": per_pixel(near, far, s)}
    runs |= {_name(pieces): per_vertex(near, far, s, pieces) for pieces in PIECES}
    choices = []
    for (name, run), pieces in zip(runs.items(), (0, *PIECES), strict=True):
        use = {"scene": "vertex-depth", "settings.depth": "vertex" if pieces else "pixel"}
        if pieces:
            use["settings.pieces"] = str(pieces)
        choices.append(
            ChartPoint(
                name, None, None, too_far(near, far, s, run()), predicted(near, far, pieces),
                note="" if pieces else NO_EARLY_TEST, use=use,
                bytes=AFFINE_BYTES * (max(1, pieces) + 1.0),
            )
        )  # fmt: skip
    trade = Trade("vertex-depth", "ns", "w", tuple(choices), 0)
    # However many pieces there are, a pixel's work is the same: it is timed once.
    same = {_name(pieces): _name(1) for pieces in PIECES}
    once = {name: runs[name] for name in ("each pixel", _name(1))}
    return timed(trade, once, seconds, 1e9 / len(s), watch, same)


def _name(pieces: int) -> str:
    return f"each vertex, {pieces} pieces" if pieces > 1 else "each vertex"
