"""Where a scene's faces are seen in a pane: labels hide as little of them as possible."""

from __future__ import annotations

import math

import numpy as np

from app.drawings.label_placement import SQUARE_EM, Ground
from app.model.projection import Array
from app.scenes.scene import Scene

_MOST_FACES = 3_000  # of larger meshes, vertices are sampled
_MOST_POINTS = 10_000
_MOST_STEPS = 256  # across one triangle; larger ones are sampled more coarsely
_MOST_PLACES = 200_000  # in all; more would overlap


class Silhouette:
    """The faces of a scene; `em` is the height of the labels' font in pixels.

    `triangles` (n, 3, 3) are in the coordinates of the scene's actors.
    """

    def __init__(self, scene: Scene, em: float) -> None:
        self._square_px = SQUARE_EM * em
        surface, self.triangles = scene.surface, np.empty((0, 3, 3))
        if surface is None or not surface.n_cells:
            return
        if surface.n_cells <= _MOST_FACES:
            mesh = surface.triangulate()
            self.triangles = np.asarray(mesh.points, dtype=np.float64)[mesh.regular_faces]
        else:
            points = surface.points[:: -(-len(surface.points) // _MOST_POINTS)]
            self.triangles = np.repeat(points.astype(np.float64)[:, None], 3, axis=1)

    def ink(self, ground: Ground, spots: Array) -> None:
        """Tell the ground where the triangles are: pixels, (n, 3, 2); NaN behind the camera."""
        shape, square = ground.shape, self._square_px
        held = np.zeros(shape, dtype=np.bool_)
        spots = spots[np.isfinite(spots).all(axis=(1, 2))] / square
        if len(spots):
            low, high = spots.min(axis=1), spots.max(axis=1)
            spots = spots[((high >= 0.0) & (low <= shape)).all(axis=1)]
            sides = np.ptp(spots, axis=1).max(axis=1)
            steps = 2 ** np.ceil(np.log2(np.clip(sides, 1.0, _MOST_STEPS))).astype(np.int64)
            places = int(((steps + 1) * (steps + 2) // 2).sum())
            coarser = math.ceil(math.log(max(places / _MOST_PLACES, 1.0), 4.0))
            steps = np.maximum(steps >> coarser, 1)
            for count in sorted(set(steps.tolist())):
                some = spots[steps == count]
                spread = np.tensordot(_lattice(count), some, axes=(1, 1)).reshape(-1, 2)
                at = np.floor(np.clip(spread, -1.0, max(shape))).astype(np.int64)
                at = at[((at >= 0) & (at < shape)).all(axis=1)]
                held[at[:, 0], at[:, 1]] = True
        ground.ink(held)


def _lattice(count: int) -> Array:
    """Weights of a triangle's corners at evenly spread places, (m, 3)."""
    one, two = np.meshgrid(np.arange(count + 1), np.arange(count + 1))
    kept = one + two <= count
    weights: Array = np.stack([one[kept], two[kept], count - one[kept] - two[kept]], axis=1) / count
    return weights
