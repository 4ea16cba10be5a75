"""Trade 7, logarithmic depth at the vertices: ns a pixel and bytes against how far off it is drawn.

The floor of the scene `app.scenes.phenomena.vertex_depth` runs from the lens's near to its far
plane. The exact way computes the logarithm for every pixel, from 1/w, which is linear on the
screen. The cheap way computes it where the floor is cut, and interpolates linearly between.
"""

import math
from collections.abc import Callable

import numpy as np

from app.measure.interpolation import AFFINE_BYTES, SAMPLES_A_PIXEL, aligned, pieced
from app.measure.results import ChartPoint, Trade, without_numbers
from app.measure.run import Watch, timed, unwatched
from app.model.depth import DepthBuffer
from app.model.projection import Array, Projection
from app.model.refusal import MEASURE, Refusal
from app.scenes.phenomena.vertex_depth import borders, largest_factor

PIECES = 1, 4, 16, 64, 256, 1024
_ROUNDINGS = 4.0 * 2.0**-53  # bound of float64's loss in parts of the distance, times far over near


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
    """Return a bound of `too_far`, for rounding alone if there are 0 pieces."""
    lost = _ROUNDINGS * (far / near + math.log(far / near))
    factor = largest_factor(1.0 + (far / near - 1.0) / pieces)[0] if pieces else 1.0
    return factor - 1.0 + lost * factor


def measure(projection: Projection, seconds: float = 10.0, watch: Watch = unwatched) -> Trade:
    lens, names = projection.lens, ["each pixel", "each vertex"]
    names += [f"each vertex, {pieces} pieces" for pieces in PIECES[1:]]
    try:
        DepthBuffer("float32", "logarithmic", lens)
    except Refusal as error:
        return without_numbers("vertex-depth", "w", str(error), names[0])
    near, far = lens.near, lens.far
    s = aligned(SAMPLES_A_PIXEL * projection.image_size[1])
    s[:] = np.linspace(0.0, 1.0, len(s))
    runs = [per_pixel(near, far, s), *(per_vertex(near, far, s, pieces) for pieces in PIECES)]
    choices = []
    for name, run, pieces in zip(names, runs, (0, *PIECES), strict=True):
        use = {"scene": "vertex-depth", "settings.depth": "vertex" if pieces else "pixel"}
        note, ends = "" if pieces else MEASURE["no-early-test"], max(1, pieces) + 1.0
        use |= {"settings.pieces": str(pieces)} if pieces else {}
        off, bound = too_far(near, far, s, run()), predicted(near, far, pieces)
        choices.append(ChartPoint(name, None, None, off, bound, {}, note, use, AFFINE_BYTES * ends))
    trade = Trade("vertex-depth", "ns", "w", tuple(choices), 0)
    # However many pieces there are, a pixel's work is the same: it is timed once.
    same = dict.fromkeys(names[1:], names[1])
    once = dict(zip(names[:2], runs, strict=False))
    return timed(trade, once, seconds, 1e9 / len(s), watch, same)
