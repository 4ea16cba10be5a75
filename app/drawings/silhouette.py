"""Where a scene's faces are seen in a pane: what no label may hide.

In squares of a few pixels, summed from a corner, so that a label's box needs four look-ups,
whatever the mesh. Labels are placed at every step of a drag, while the silhouette only changes with
the pane's own camera.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.drawings.pane_view import PaneView
from app.model.projection import Array
from app.scenes.scene import Scene

_MOST_FACES = 3_000  # of larger meshes, vertices are sampled
_MOST_POINTS = 10_000
_SQUARE_EM = 1.0 / 3.0
_MOST_STEPS = 256  # across one triangle; larger ones are sampled more coarsely
_MOST_PLACES = 200_000  # in all; more would overlap


class Silhouette:
    """The faces of a scene; `em` is the height of the labels' font in pixels."""

    def __init__(self, scene: Scene, em: float) -> None:
        self._square_px = _SQUARE_EM * em
        surface, self._triangles = scene.surface, np.empty((0, 3, 3))
        if surface is None or not surface.n_cells:
            return
        if surface.n_cells <= _MOST_FACES:
            mesh = surface.triangulate()
            self._triangles = np.asarray(mesh.points, dtype=np.float64)[mesh.regular_faces]
        else:
            points = surface.points[:: -(-len(surface.points) // _MOST_POINTS)]
            self._triangles = np.repeat(points.astype(np.float64)[:, None], 3, axis=1)

    def seen(self, pane: PaneView, local_from_object: Array) -> Mask:
        """Return where they are in a pane now; faces that reach behind its camera are left out."""
        square, placed = self._square_px, local_from_object
        triangles = self._triangles @ placed[:3, :3].T + placed[:3, 3]
        shape = tuple(int(side_px / square) + 2 for side_px in pane.size_px)
        held = np.zeros(shape, dtype=np.bool_)
        if len(triangles):
            x, y, depth = np.moveaxis((triangles - pane.eye) @ pane.axes.T, -1, 0)
            with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
                spots = np.stack([x, y], axis=-1) / pane.unit(depth)[..., None]
            spots = (spots + np.array(pane.size_px) / 2.0) / square
            spots = spots[(depth > 0.0).all(axis=1)]
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
                at = np.floor(spread).astype(np.int64)
                at = at[((at >= 0) & (at < shape)).all(axis=1)]
                held[at[:, 0], at[:, 1]] = True
        return Mask(held, square)


class Mask:
    """A silhouette in one pane: squares, (columns, rows), from the left and from the bottom."""

    def __init__(self, held: NDArray[np.bool_], square_px: float) -> None:
        columns, rows = held.shape
        self._square_px, self._columns, self._rows = square_px, columns, rows
        counted = np.zeros((columns + 1, rows + 1), dtype=np.int64)
        counted[1:, 1:] = held.cumsum(axis=0).cumsum(axis=1)
        self._counted: Any = counted.tolist()

    def meets(self, left: float, bottom: float, right: float, top: float) -> bool:
        """Return whether a box, in pixels from the pane's left and bottom, contains any of it."""
        square, counted = self._square_px, self._counted
        # Faces reach a little farther than the samples of them.
        first = min(max(int(left / square - 0.5), 0), self._columns)
        last = min(max(int(right / square + 1.5), 0), self._columns)
        low = min(max(int(bottom / square - 0.5), 0), self._rows)
        high = min(max(int(top / square + 1.5), 0), self._rows)
        upper, lower = counted[last], counted[first]
        return bool(upper[high] - upper[low] - lower[high] + lower[low])


def _lattice(count: int) -> Array:
    """Weights of a triangle's corners at evenly spread places, (m, 3)."""
    one, two = np.meshgrid(np.arange(count + 1), np.arange(count + 1))
    kept = one + two <= count
    weights: Array = np.stack([one[kept], two[kept], count - one[kept] - two[kept]], axis=1) / count
    return weights
