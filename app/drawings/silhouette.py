"""The area that a scene's objects cover in a pane, which labels leave free where they can."""

import math
from functools import cache

import numpy as np

from app.drawings.label_placement import SQUARE_EM, Ground
from app.model.projection import Array
from app.scenes.scene import Scene

_MOST_FACES = 3_000  # of larger meshes, vertices are sampled
_MOST_POINTS = 10_000
_MOST_STEPS = 256  # across one triangle; larger ones are sampled more coarsely
_MOST_PLACES = 200_000  # in all; more would overlap


class Silhouette:
    """The objects of a scene; `em` is the height of the labels' font in pixels.

    `triangles` (n, 3, 3), or points (n, 1, 3) where they are too many or none, are in the
    coordinates of the scene's actors.
    """

    def __init__(self, scene: Scene, em: float) -> None:
        self._square_px = SQUARE_EM * em
        surface, self.triangles = scene.surface, np.empty((0, 3, 3))
        if surface is not None and surface.n_cells <= _MOST_FACES:
            mesh = surface.triangulate()
            self.triangles = np.asarray(mesh.points, dtype=np.float64)[mesh.regular_faces]
        else:
            points = scene.own_points
            points = points[:: max(1, -(-len(points) // _MOST_POINTS))]
            self.triangles = points.astype(np.float64)[:, None]

    def ink_under(self, ground: Ground, rows: Array) -> None:
        """`ink` under rows that give x w, y w and w in pixels, (3, 4)."""
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            x, y, w = np.moveaxis(self.triangles @ rows[:, :3].T + rows[:, 3], -1, 0)
            spots = np.stack([x, y], axis=-1) / np.where(w > 0.0, w, np.nan)[..., None]
        self.ink(ground, spots)

    def ink(self, ground: Ground, spots: Array) -> None:
        """Tell the ground where the triangles are: pixels, (n, 3 or 1, 2); NaN behind."""
        if spots.shape[1] == 1:
            ground.ink_points(spots[:, 0])
            return
        columns, rows = (side + 2 for side in ground.shape)  # with a rim that takes what is outside
        limit = np.array([[columns - 1.0], [rows - 1.0]])
        held = np.zeros(columns * rows, dtype=np.bool_)
        corners = np.ascontiguousarray(np.transpose(spots, (1, 2, 0))) / self._square_px + 1.0
        low, high = corners.min(axis=0), corners.max(axis=0)
        with np.errstate(invalid="ignore"):
            sides = (high - low).max(axis=0)
        seen = np.isfinite(sides) & (high >= 1.0).all(axis=0) & (low <= limit).all(axis=0)
        if seen.any():
            corners, sides = corners[:, :, seen], sides[seen]
            steps = 2 ** np.ceil(np.log2(np.clip(sides, 1.0, _MOST_STEPS))).astype(np.int64)
            places = int(((steps + 1) * (steps + 2) // 2).sum())
            coarser = math.ceil(math.log(max(places / _MOST_PLACES, 1.0), 4.0))
            steps = np.maximum(steps >> coarser, 1)
            for count in sorted(set(steps.tolist())):
                spread = _lattice(count) @ np.moveaxis(corners[:, :, steps == count], 1, 0)
                x, y = np.clip(spread, 0.0, limit[:, None]).astype(np.int64)
                held[x * rows + y] = True
        ground.ink(held.reshape(columns, rows)[1:-1, 1:-1])


@cache
def _lattice(count: int) -> Array:
    """Weights of a triangle's corners at evenly spread places, (m, 3)."""
    one, two = np.meshgrid(np.arange(count + 1), np.arange(count + 1))
    kept = one + two <= count
    weights: Array = np.stack([one[kept], two[kept], count - one[kept] - two[kept]], axis=1) / count
    return weights
