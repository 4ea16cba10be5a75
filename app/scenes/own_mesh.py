"""The part of a user's mesh that a phenomenon computes with: its longest edges and triangles."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from app.model.limits import Vector
from app.scenes.mesh import Floats, Ints
from app.scenes.phenomena.illustration import OwnMesh
from app.scenes.polygons import following
from app.scenes.shapes import distinct_rows

if TYPE_CHECKING:
    from vtkmodules.vtkCommonCore import vtkDataArray
    from vtkmodules.vtkCommonDataModel import vtkCellArray

    from app.scenes.poly_mesh import PolyMesh

SUBJECT_EDGES, SUBJECT_TRIANGLES = 20_000, 1_000
"""Most edges and triangles that a phenomenon computes with: the longest ones of a larger mesh."""
SUBJECT_SURFACE = 3_000
"""Most triangles of a mesh whose pixels are computed; larger ones are reduced."""


def own_mesh(surface: "PolyMesh", origin: Vector, pixels: bool) -> OwnMesh:
    """Return the longest edges and the triangles with the longest sides; all for `pixels`."""
    points = np.asarray(surface.points)
    offsets, corners = cells_of(surface.GetPolys())
    next_corners = corners[following(offsets)]
    # Most edges belong to two faces, and files repeat vertices.
    places, merged = distinct_rows(points)
    starts, ends = merged[corners], merged[next_corners]
    apart = starts != ends
    keys = np.minimum(starts, ends)[apart] * len(places) + np.maximum(starts, ends)[apart]
    starts, ends = np.divmod(_distinct(keys), len(places))
    if not len(starts):  # every face is a point
        starts, ends = merged[corners[:1]], merged[corners[:1]]
    chosen = _largest(_lengths(places, starts, ends), SUBJECT_EDGES)
    edges = places[np.stack([starts[chosen], ends[chosen]], axis=1)].astype(np.float64)

    divided = surface if surface.is_all_triangles else surface.triangulate()
    triangles = np.asarray(divided.regular_faces, dtype=np.int64)
    spans = _lengths(points, triangles, np.roll(triangles, -1, axis=1))
    longest = points[triangles[_largest(spans.max(axis=1), SUBJECT_TRIANGLES)]].astype(np.float64)
    if not len(longest):  # every face is a line
        longest = edges[:1, [0, 0, 1]]
    whole = _coarser(points, triangles) + origin if pixels else np.empty((0, 3, 3))
    more = len(longest) < len(triangles)
    return OwnMesh(edges + origin, len(starts), longest + origin, more, whole)


def _coarser(points: NDArray[np.floating], triangles: Ints) -> Floats:
    """Return at most `SUBJECT_SURFACE` triangles (k, 3, 3): vertices in a grid cell become one."""
    coarser: Floats = points[triangles].astype(np.float64)
    low, size = points.min(axis=0), float(np.ptp(points, axis=0).max())
    cells = 48
    while len(coarser) > SUBJECT_SURFACE:
        cell = np.floor((points - low) * (cells / size)).astype(np.int64)
        keys = (cell[:, 0] * (cells + 1) + cell[:, 1]) * (cells + 1) + cell[:, 2]
        _, where, count = np.unique(keys, return_inverse=True, return_counts=True)
        middles = [np.bincount(where, points[:, axis]) / count for axis in range(3)]
        corners = np.sort(where[triangles], axis=1)
        corners = corners[(corners[:, 0] < corners[:, 1]) & (corners[:, 1] < corners[:, 2])]
        a, b, c = corners.T
        rest, c = np.divmod(_distinct((a * len(count) + b) * len(count) + c), len(count))
        corners = np.stack([*np.divmod(rest, len(count)), c], axis=1)
        coarser = np.stack(middles, axis=1)[corners]
        cells = cells * 3 // 4
    return coarser


def _distinct(keys: Ints) -> Ints:
    """Return the distinct numbers, sorted: `numpy.unique` takes 4 s for 3 million, this 0.02."""
    keys = np.sort(keys)
    return keys[np.append(True, keys[1:] != keys[:-1])] if len(keys) else keys


def _lengths(points: NDArray[np.floating], starts: Ints, ends: Ints) -> NDArray[np.floating]:
    squares = np.zeros(starts.shape, points.dtype)
    for axis in range(3):  # by columns: half the time for millions of rows
        column = points[:, axis].copy()
        along = column.take(ends) - column.take(starts)
        squares += along * along
    return np.sqrt(squares)


def _largest(values: NDArray[np.floating], count: int) -> Ints:
    """Return the indices of the `count` largest values, the largest first."""
    which: NDArray[np.intp] = np.arange(len(values))
    if count < len(values):
        which = np.argpartition(-values, count)[:count]
    return np.asarray(which[np.argsort(-values[which], kind="stable")])


def values_of(array: "vtkDataArray") -> NDArray[Any]:
    from vtkmodules.util.numpy_support import vtk_to_numpy

    return np.asarray(vtk_to_numpy(array))  # type: ignore[no-untyped-call]


def cells_of(cells: "vtkCellArray") -> tuple[Ints, Ints]:
    cells.ConvertTo64BitStorage()
    offsets, corners = cells.GetOffsetsArray(), cells.GetConnectivityArray()
    return values_of(offsets).astype(np.int64), values_of(corners).astype(np.int64)
