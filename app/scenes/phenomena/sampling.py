"""Distances of a surface at places spread over the picture: what its pixels would hold.

A rasteriser for a few thousand places, in numpy. For a triangle with clip coordinates
``p_i = (x, y, w)`` the place ``s = (x/w, y/w, 1)`` has the barycentric weights
``b_i ~ (p_j x p_k) . s``. They have one sign inside, also if a corner is behind the eye, and are
linear in the place (Olano and Greer, *Triangle Scan Conversion using 2D Homogeneous Coordinates*,
1997).
"""

import math
from functools import cache

import numpy as np
from numpy.typing import NDArray

from app.model.projection import Array, Projection

_SIDE = 64  # of the grid of places over what the surface covers
_FINEST = 160
_WANTED = 1600  # places that hit the surface; if there are fewer, the grid is made finer once
_LARGEST = 60_000  # pairs of place and triangle; if there are more, the grid is coarser


def seen_distances(projection: Projection, triangles: Array, gap: float) -> tuple[Array, Array]:
    """Distances from the eye plane of a surface (t, 3, 3) and of one moved away by the gap along n.

    Both (k,), of what is nearest between near and far at places spread evenly over the pixels that
    both cover.
    """
    camera = projection.camera
    view = camera.frame @ (triangles.reshape(-1, 3) - np.array(camera.eye)).T
    first = _Corners(projection, view)
    second = _Corners(projection, view - [[0.0], [0.0], [gap]])
    window = first.window()
    if window is None:
        return np.empty(0), np.empty(0)
    most = max(corners.tries(window) for corners in (first, second))
    finest = min(_FINEST, max(8, int(_SIDE * math.sqrt(_LARGEST / max(most, 1)))))
    side = start = min(_SIDE, finest)
    while True:
        near, far = (corners.distances(window, side) for corners in (first, second))
        both = np.isfinite(near) & np.isfinite(far)
        wanted = side * math.sqrt(_WANTED / max(int(both.sum()), 1))
        finer = min(finest, math.ceil(wanted))
        if side != start or finer <= side:
            return near[both], far[both]
        side = finer


class _Corners:
    """The triangles that are at least partly in front of the near plane.

    - `clip` (3, 3, t): x, y, w; of each corner; of each triangle.
    - `depth` (3, t): likewise.
    - `low`, `high` (2, t): bounds in NDC.
    """

    def __init__(self, projection: Projection, view: Array) -> None:
        lens = projection.lens
        self.near, self.far = lens.near, lens.far
        matrix = projection.clip_from_view[[0, 1, 3]]
        with np.errstate(all="ignore"):
            clip = matrix[:, :3] @ view + matrix[:, 3:]
            depth = -view[2]
        # Corner after corner: numpy is slow along an axis of three.
        clip = np.ascontiguousarray(clip.reshape(3, -1, 3).swapaxes(1, 2))
        depth = np.ascontiguousarray(depth.reshape(-1, 3).T)
        # Each triangle is scaled to the same size, because only ratios matter.
        size = np.abs(clip).reshape(9, -1).max(axis=0)
        held = (size > 0.0) & (size < np.inf)
        held &= (depth.max(axis=0) >= self.near) & (depth.min(axis=0) <= self.far)
        self.clip, self.depth = clip[..., held] / size[held], depth[:, held]
        self.low, self.high = self._bounds()
        seen = ((self.low <= 1.0) & (self.high >= -1.0)).all(axis=0)
        self.clip, self.depth = self.clip[..., seen], self.depth[:, seen]
        self.low, self.high = self.low[:, seen], self.high[:, seen]

    def _bounds(self) -> tuple[Array, Array]:
        """Bounds in NDC of the parts in front of the near plane, (2, t) each."""
        with np.errstate(all="ignore"):
            places = self.clip[:2] / self.clip[2]
        low, high = places.min(axis=1), places.max(axis=1)
        rows = np.flatnonzero(self.depth.min(axis=0) < self.near)
        if len(rows):
            clip, depth = self.clip[..., rows], self.depth[:, rows]
            after = [1, 2, 0]
            with np.errstate(all="ignore"):
                part = (self.near - depth) / (depth[after] - depth)
                cuts = clip + part * (clip[:, after] - clip)
                corners = np.concatenate([places[..., rows], cuts[:2] / cuts[2]], axis=1)
            crossing = (depth < self.near) != (depth[after] < self.near)
            here = np.concatenate([depth >= self.near, crossing])
            low[:, rows] = np.where(here, corners, np.inf).min(axis=1)
            high[:, rows] = np.where(here, corners, -np.inf).max(axis=1)
        return np.nan_to_num(low, nan=-np.inf), np.nan_to_num(high, nan=np.inf)

    def window(self) -> Array | None:
        """The part of the picture that they may cover: lower and upper corner in NDC, (2, 2)."""
        if not self.depth.size:
            return None
        return np.asarray(np.clip([self.low.min(axis=1), self.high.max(axis=1)], -1.0, 1.0))

    def _cells(self, window: Array, side: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """The first and the last cell of a grid that each triangle may cover, (2, t) each."""
        with np.errstate(all="ignore"):
            cells = side / (window[1] - window[0])
            ends = (np.stack([self.low, self.high]) - window[0, :, None]) * cells[:, None]
        first, last = np.clip(np.nan_to_num(ends), 0.0, side - 1.0).astype(np.int64)
        return first, last

    def tries(self, window: Array) -> int:
        """The number of pairs of place and triangle in the ordinary grid."""
        first, last = self._cells(window, _SIDE)
        return int((last - first + 1).prod(axis=0).sum())

    def distances(self, window: Array, side: int) -> Array:
        """The nearest distance at every place of a grid, (k,); inf where there is none."""
        nearest = np.full(side * side, np.inf)
        if not self.depth.size:
            return nearest
        first, last = self._cells(window, side)
        across, up = last - first + 1
        counts = across * up
        ends = np.cumsum(counts)
        which = np.repeat(np.arange(len(ends)), counts)
        cell = np.arange(ends[-1]) - (ends - counts)[which]
        row, column = np.divmod(cell, across[which])
        column += first[0][which]
        row += first[1][which]
        place = row * side + column
        x, y = (
            low + (number + within[place]) * ((high - low) / side)
            for low, high, number, within in zip(
                *window, (column, row), _within_cells(side), strict=True
            )
        )
        (xa, xb, xc), (ya, yb, yc), (wa, wb, wc) = self.clip
        weights = []
        for x1, y1, w1, x2, y2, w2 in (
            (xb, yb, wb, xc, yc, wc), (xc, yc, wc, xa, ya, wa), (xa, ya, wa, xb, yb, wb),
        ):  # fmt: skip
            along_x, along_y, rest = y1 * w2 - w1 * y2, w1 * x2 - x1 * w2, x1 * y2 - y1 * x2
            weights.append(along_x[which] * x + along_y[which] * y + rest[which])
        a, b, c = weights
        inside = ((a >= 0.0) & (b >= 0.0) & (c >= 0.0)) | ((a <= 0.0) & (b <= 0.0) & (c <= 0.0))
        (held,) = np.nonzero(inside)
        a, b, c, which, place = (part[held] for part in (a, b, c, which, place))
        with np.errstate(all="ignore"):
            near_a, near_b, near_c = self.depth[:, which]
            depth = (a * near_a + b * near_b + c * near_c) / (a + b + c)
        held = (depth >= self.near) & (depth <= self.far)
        np.minimum.at(nearest, place[held], depth[held])
        return nearest


@cache
def _within_cells(side: int) -> Array:
    """The random place in each cell of a grid, (2, side^2): stripes are rows, places are not."""
    return np.asarray(np.random.default_rng(side).random((2, side * side)))
