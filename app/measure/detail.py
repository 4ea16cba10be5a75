"""Trade 5, detail: ms per frame, loading time and memory against the silhouette's error.

The mesh is drawn whole and with ever fewer triangles, or a sphere where the scene has too few. The
outlines are exact: they follow from the projected triangles, not from pixels.
"""

import math
import time
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
from vtkmodules.vtkFiltersSources import vtkSphereSource

from app.measure.results import ChartPoint, Trade
from app.measure.run import Watch, part_of, timed, unwatched
from app.measure.smoothing import pane, picture_size
from app.model.clipping import clip_segments
from app.model.limits import vector
from app.model.projection import Array, Projection
from app.model.refusal import MEASURE, Cancelled
from app.scenes.fewer_triangles import LEAST_TRIANGLES, SHARES, can_be_reduced, reduced
from app.scenes.poly_mesh import PolyMesh
from app.scenes.scene import Scene
from app.scenes.shapes import distinct_rows

Pieces: TypeAlias = Array  # straight parts of an outline, (n, 2, 2): begin and end in px

_PIECE_PX = 0.5
_BESIDE_PX = 1e-3
_RINGS = 160  # of the sphere

TOO_FEW = "a sphere: the scene has too few triangles"


def measure(
    scene: Scene, projection: Projection, seconds: float = 10.0, watch: Watch = unwatched
) -> Trade:
    """Measure trade 5.

    The cost is ms per frame, and bytes of positions and corners in 32 bits each. The error is the
    Hausdorff distance of the two outlines, the largest distance of a point of one from the other,
    in px of a pane-sized picture.
    """
    own = scene.triangles >= LEAST_TRIANGLES and can_be_reduced(scene)
    if not own:
        scene = sphere(projection)
    size = picture_size(projection)
    whole: Pieces | None = None
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
            error = apart(whole, line)
            assert fewer.surface is not None
            began = time.perf_counter()
            runs[name], _ = stack.enter_context(pane(fewer, projection, size))
            runs[name]()
            values = {
                "triangles": float(fewer.surface.n_cells),
                "reduce_ms": 1e3 * made,
                "first_frame_ms": 1e3 * (time.perf_counter() - began),
            }
            note = MEASURE["not-seen"] if error is None else "" if own else TOO_FEW
            use = {"detail": f"{share:g}"} if own else {}
            buffers = 12.0 * (fewer.surface.n_points + fewer.surface.n_cells)
            choice = ChartPoint(name, None, None, error, None, values, note, use, buffers)
            trade = replace(trade, choices=(*trade.choices, choice))
        return timed(trade, runs, seconds, 1e3, part_of(watch, 0.5, 1.0))


def sphere(projection: Projection) -> Scene:
    """Return a sphere of many triangles at the target, a third of the picture's height in size."""
    camera, (_, _, bottom, top) = projection.camera, projection.window
    radius = float(projection.lens.enlarged(np.array(camera.distance))) * (top - bottom) / 3.0
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(_RINGS)
    source.SetPhiResolution(_RINGS)
    source.Update()
    mesh = PolyMesh.sharing(source.GetOutput())
    # Poles left and right.
    mesh.points = mesh.points[:, [2, 1, 0]] * np.array([1, 1, -1], np.float32)
    mesh.cell_data["rgb"] = np.full((mesh.n_cells, 3), 200, dtype=np.uint8)
    ends = [vector(np.array(camera.target) + side * radius) for side in (-1.0, 1.0)]
    return Scene(
        name="sphere", origin=camera.target, surface=mesh, lines=None,
        lower=ends[0], upper=ends[1], start=projection,
    )  # fmt: skip


def outline(scene: Scene, projection: Projection, size: tuple[int, int]) -> Pieces:
    """Return the edge of the area that the scene's faces cover, in pieces, in px of the picture.

    The area ends at edges whose triangles lie on one side of them in the picture, where no other
    triangle covers the other side. The sides are signs of determinants of clip coordinates (x, y,
    w), which hold even if a corner is behind the eye; such a triangle covers nothing here.
    """
    surface = scene.surface
    assert surface is not None
    mesh = surface.triangulate()
    points, places = distinct_rows(np.asarray(mesh.points))
    triangles = places[mesh.regular_faces]
    clip = projection.trace(points.astype(np.float64) + scene.origin).clip
    x, y, w = (clip[triangles, axis].T for axis in (0, 1, 3))
    turn = np.sign(
        x[0] * (y[1] * w[2] - y[2] * w[1])
        + x[1] * (y[2] * w[0] - y[0] * w[2])
        + x[2] * (y[0] * w[1] - y[1] * w[0])
    )
    corners = triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)
    sides = np.repeat(turn, 3) * np.where(corners[:, 0] < corners[:, 1], 1.0, -1.0)
    edges, which = distinct_rows(np.sort(corners, axis=1))
    least, most = np.full(len(edges), 1.0), np.full(len(edges), -1.0)
    np.minimum.at(least, which, sides)
    np.maximum.at(most, which, sides)
    bends = (least >= 0.0) | (most <= 0.0)
    cut = clip_segments(clip[edges[bends, 0]], clip[edges[bends, 1]], projection.depth)
    pieces, sides = _split(
        _placed(cut.points_clip[cut.visible], size),
        np.where(most[bends] > 0.0, 1.0, -1.0)[cut.visible],
    )
    along = pieces[:, 1] - pieces[:, 0]
    # A positive side is on the left in clip space, and on the left in the picture if y is up.
    away = np.stack([along[:, 1], -along[:, 0]], axis=1) * -sides[:, None]
    away /= np.linalg.norm(away, axis=1)[:, None]
    covering = _placed(clip[triangles[(w > 0.0).all(axis=0)]], size)
    beside = _flat(pieces.mean(axis=1) + _BESIDE_PX * away)
    if not len(covering) or not len(beside):
        return pieces
    covered = _locator(PolyMesh.of(_flat(covering), faces=_cells(len(covering), 3)))
    return pieces[[covered.FindCell(place) < 0 for place in beside]]


def _placed(clip: Array, size: tuple[int, int]) -> Array:
    """Convert clip coordinates (..., 4) to px of the picture, (..., 2)."""
    return np.asarray((clip[..., :2] / clip[..., 3:] * (0.5, -0.5) + 0.5) * size)


def _split(segments: Array, sides: Array) -> tuple[Pieces, Array]:
    """Split segments (n, 2, 2) into pieces of at most `_PIECE_PX`, each with its segment's side."""
    along = segments[:, 1] - segments[:, 0]
    lengths = np.linalg.norm(along, axis=1)
    counts = np.ceil(lengths / _PIECE_PX).astype(int)  # none of a point
    which = np.repeat(np.arange(len(segments)), counts)
    number = np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)
    parts = np.stack([number, number + 1], axis=1) / counts[which, None]
    return segments[which, :1] + parts[..., None] * along[which, None], sides[which]


def _flat(places: Array) -> Array:
    """Places (..., 2) as VTK's points (n, 3)."""
    return np.pad(places.reshape(-1, 2), ((0, 0), (0, 1)))


def _cells(count: int, corners: int) -> NDArray[np.int_]:
    """Cells each of which has the next corners."""
    return np.arange(count * corners).reshape(-1, corners)


def _locator(mesh: PolyMesh) -> Any:
    locator = vtkStaticCellLocator()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    return locator


def apart(one: Pieces, other: Pieces) -> float | None:
    """Return the Hausdorff distance of two outlines; None if the first is empty."""
    if not len(one):
        return None
    if not len(other):
        return float(np.hypot(*np.ptp(one, axis=(0, 1))))
    return max(_farthest(one, other), _farthest(other, one))


def _farthest(one: Pieces, other: Pieces) -> float:
    """Return the largest distance of a piece's begin in one outline from the other outline."""
    locator = _locator(PolyMesh.of(_flat(other), lines=_cells(len(other), 2)))
    nearest, farthest = [0.0, 0.0, 0.0], 0.0
    said: list[Any] = [mutable(0), mutable(0), mutable(0.0)]
    for begin in _flat(one[:, 0]):
        locator.FindClosestPoint(begin, nearest, *said)
        farthest = max(farthest, math.dist(begin, nearest))
    return farthest
