"""Random floors and seams for `tests.fuzz bounds`: errors and bounds of 1000 places each."""

import random

import numpy as np

from app.measure.cracks import gap_px
from app.measure.vertex_depth import PIECES, per_pixel, per_vertex, predicted, too_far
from app.model.projection import Array, Camera, Perspective, Projection
from app.scenes.phenomena import cracks

PLACES = 1000


def vertex_depth(dice: random.Random) -> dict[str, tuple[Array, Array]]:
    """The largest error of a floor at random places, and its bound."""
    near = 10.0 ** dice.uniform(-3.0, 3.0)
    far = near * (1.0 + 10.0 ** dice.uniform(-6.0, 6.0))
    s = np.sort(np.random.default_rng(dice.randrange(2**32)).uniform(0.0, 1.0, PLACES))
    pieces = dice.choice(PIECES)
    runs = {"each pixel": (per_pixel(near, far, s), 0)}
    runs["each vertex"] = per_vertex(near, far, s, pieces), pieces
    return {
        name: (np.array([too_far(near, far, s, run())]), np.array([predicted(near, far, cut)]))
        for name, (run, cut) in runs.items()
    }


def seams(dice: random.Random) -> dict[str, tuple[Array, Array]]:
    """The gaps at random vertices, seen by any camera before them, and the trade's largest."""
    rng = np.random.default_rng(dice.randrange(2**32))
    both = cracks.meshes((10.0 ** dice.uniform(0.7, 4.0), 10.0 ** dice.uniform(0.7, 4.0)))
    bits = dice.choice((8, 12, 16))
    each = cracks.grids(both, bits, False)
    seam = np.column_stack([rng.uniform((-0.3, -0.9), (0.3, 0.9), (PLACES, 2)), np.zeros(PLACES)])
    eye = (dice.uniform(-9.0, 9.0), dice.uniform(-9.0, 9.0), 10.0 ** dice.uniform(0.0, 2.0))
    lens = Perspective(dice.uniform(20.0, 100.0), 1e-3, 1e4)
    projection = Projection(Camera(eye, (0.1, 0.2, 0.0)), lens, (1920, 1080))
    one, other = (projection.trace(grid.rounded(seam)) for grid in each)
    bound = cracks.bound_px(projection, seam, (each[0].step + each[1].step) / 2.0)
    kept = np.isfinite(bound) & one.in_front & other.in_front
    gap = np.hypot(*(one.image - other.image)[kept].T)
    scale = np.array([10.0 ** dice.uniform(0.0, 4.0), 10.0 ** dice.uniform(0.0, 4.0)])
    largest, predicted_px, _ = gap_px(both, bits, False, scale)
    return {
        "any camera": (gap, bound[kept]),
        "trade": (np.array([largest]), np.array([predicted_px])),
    }
