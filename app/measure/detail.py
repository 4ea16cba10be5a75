"""Trade 5, detail: ms per frame, loading time and memory against the silhouette's error.

The mesh is drawn whole and with ever fewer triangles, or a sphere where the scene has too few. Each
picture's outline of the covered area is found at `FINER` times the resolution.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.measure.results import ChartPoint, Trade
from app.measure.run import Watch, part_of, timed, unwatched
from app.measure.smoothing import SMOOTHINGS, pane, picture_size
from app.model.limits import vector
from app.model.projection import Projection
from app.model.refusal import QT_TRANSLATE_NOOP, Cancelled
from app.scenes.fewer_triangles import LEAST_TRIANGLES, SHARES, reduced
from app.scenes.scene import Scene

FINER = 3.0
"""Pixels of the outline's picture per shown pixel, along each side."""

_RINGS = 160  # of the sphere

TOO_FEW = "a sphere: the scene has too few triangles"
NOT_SEEN = QT_TRANSLATE_NOOP("Measure", "nothing of the scene is in the picture")

_BLOCK = 2048


def measure(
    scene: Scene, projection: Projection, seconds: float = 10.0, watch: Watch = unwatched
) -> Trade:
    """Measure trade 5.

    The cost is ms per frame, and bytes of positions and corners in 32 bits each. The error is the
    Hausdorff distance of the two outlines, the largest distance of a point of one from the other,
    in px of a pane-sized picture.

    A `Cancelled` that `watch` raises has the choices so far.
    """
    own = scene.triangles >= LEAST_TRIANGLES
    if not own:
        scene = sphere(projection)
    size = picture_size(projection)
    whole: NDArray[np.float64] | None = None
    runs: dict[str, Callable[[], Any]] = {}
    trade = Trade("detail", "ms", "px", (), 0)
    with ExitStack() as stack:
        for done, share in enumerate((1.0, *SHARES)):
            try:
                part_of(watch, 0.0, 0.5)(done / (1 + len(SHARES)))
            except Cancelled as cancelled:
                raise Cancelled(replace(trade, complete=False)) from cancelled
            name = f"{100.0 * share:g} %"
            began = time.perf_counter()
            fewer = reduced(scene, share)
            made = time.perf_counter() - began
            line = outline(fewer, projection, size)
            if whole is None:
                whole = line
            error = _apart(whole, line)
            assert fewer.surface is not None
            began = time.perf_counter()
            runs[name], _ = stack.enter_context(pane(fewer, projection, size))
            runs[name]()
            values = {
                "triangles": float(fewer.surface.n_cells),
                "reduce_ms": 1e3 * made,
                "first_frame_ms": 1e3 * (time.perf_counter() - began),
            }
            note = NOT_SEEN if error is None else "" if own else TOO_FEW
            use = {"detail": f"{share:g}"} if own else {}
            buffers = 12.0 * (fewer.surface.n_points + fewer.surface.n_cells)
            choice = ChartPoint(name, None, None, error, None, values, note, use, buffers)
            trade = replace(trade, choices=(*trade.choices, choice))
        return timed(trade, runs, seconds, 1e3, part_of(watch, 0.5, 1.0))


def sphere(projection: Projection) -> Scene:
    """Return a sphere of many triangles at the target, a third of the picture's height in size."""
    import pyvista as pv

    camera, (_, _, bottom, top) = projection.camera, projection.window
    radius = float(projection.lens.enlarged(np.array(camera.distance))) * (top - bottom) / 3.0
    mesh = pv.Sphere(radius=radius, theta_resolution=_RINGS, phi_resolution=_RINGS)
    mesh.cell_data["rgb"] = np.full((mesh.n_cells, 3), 200, dtype=np.uint8)
    ends = [vector(np.array(camera.target) + side * radius) for side in (-1.0, 1.0)]
    return Scene(
        name="sphere", origin=camera.target, surface=mesh, lines=None,
        lower=ends[0], upper=ends[1], start=projection,
    )  # fmt: skip


def outline(scene: Scene, projection: Projection, size: tuple[int, int]) -> NDArray[np.float64]:
    """Return the edge of the area that the scene's faces cover, (n, 2) in px of the picture."""
    finer = SMOOTHINGS[0]._replace(scale=FINER)
    bare = replace(scene, lines=None)
    with pane(bare, projection, size, finer, background=False) as (draw, read):
        draw()
        covered = read()[..., 3] > 127
    framed = np.pad(covered, 1, constant_values=False)
    inner = framed[1:-1, 1:-1]
    edge = inner & ~(framed[:-2, 1:-1] & framed[2:, 1:-1] & framed[1:-1, :-2] & framed[1:-1, 2:])
    rows, columns = np.nonzero(edge)
    return np.column_stack([columns, rows]) / FINER


def _apart(one: NDArray[np.float64], other: NDArray[np.float64]) -> float | None:
    """Return the Hausdorff distance of two sets of places; None if the first is empty."""
    if not len(one):
        return None
    if not len(other):
        return float(np.hypot(*np.ptp(one, axis=0)))
    return max(_farthest(one, other), _farthest(other, one))


def _farthest(one: NDArray[np.float64], other: NDArray[np.float64]) -> float:
    """Return the largest distance of a place of one set from the nearest of the other."""
    largest = 0.0
    for start in range(0, len(one), _BLOCK):
        block = one[start : start + _BLOCK]
        squares = (block[:, None, 0] - other[None, :, 0]) ** 2
        squares += (block[:, None, 1] - other[None, :, 1]) ** 2
        largest = max(largest, float(squares.min(axis=1).max()))
    return float(np.sqrt(largest))
