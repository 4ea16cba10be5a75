"""Prepare a mesh for drawing: check it, colour it, find its edges, divide its large polygons.

All slow work on a large mesh is here, so that `app.scenes.reading` can do it in another process.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from app.model.limits import Vector
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from app.scenes.mesh import (
    PAINT_RGB,
    Colours,
    Floats,
    Ints,
    Mesh,
    Progress,
    report,
)
from app.scenes.shapes import DRAWN_RGB, brightness, distinct_rows, flat

ONE_POINT = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: all vertices are at one point, so there is nothing to see; check the export.",
)
ONE_LINE = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: all vertices are on one line, so there is nothing to see; check the export.",
)
WRONG_SIZE = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: the size of the mesh is {1} units, but must be between 1e-30 and 1e30; scale it.",
)
TOO_FAR = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: a vertex has the coordinate {1}, but it must be within ±{2}, 1e12 times the mesh's size;"
    " move the mesh to the origin.",
)
FARTHEST = 1e12
"""Largest distance from the origin, in sizes of the mesh: vertices there keep four digits."""
FACES_WITH_EDGES = 5_000
"""Most faces of a mesh with edge lines: beyond, the lines would be denser than the pixels."""
_BLOCK = 100_000
"""Faces between two reports of progress."""
_SHARP = math.cos(math.radians(30.0))
"""Edges whose faces turn by a larger angle are drawn."""


class Finished(NamedTuple):
    """A mesh that is ready to be drawn.

    Attributes
    ----------
    points : (n, 3) float64
        World coordinates.
    offsets, corners : (m + 1,) and (offsets[m],) int64
        As in `app.scenes.mesh.Mesh`, for faces of three or four corners.
    rgb : (m, 3) uint8
        Shaded colour of each face.
    edges : (k, 2, 3) float64
        Ends of the faces' edges to draw.
    lines : (l, 2, 3) float64
        Ends of the file's own lines.
    dots : (d, 3) float64
    dot_rgb : (d, 3) uint8
    """

    points: Floats
    offsets: Ints
    corners: Ints
    rgb: Colours
    edges: Floats
    lines: Floats
    dots: Floats
    dot_rgb: Colours

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        """Least and largest coordinates."""
        return vector(self.points.min(axis=0)), vector(self.points.max(axis=0))


def finished(path: Path, mesh: Mesh, progress: Progress | None) -> Finished:
    """Prepare the mesh of a file.

    Raises
    ------
    Refusal
        For a mesh of no size, too large, too far away, or of faces on one line.
    """
    report(progress, 0.5)
    faces = len(mesh.offsets) - 1
    _check(path, mesh.points, has_area=faces > 0 and not (mesh.lines.size or mesh.dots.size))
    report(progress, 0.6)
    rgb = _face_colours(mesh, progress) if faces else np.empty((0, 3), dtype=np.uint8)
    edges = _feature_edges(mesh) if 0 < faces <= FACES_WITH_EDGES else np.empty((0, 2, 3))
    dot_rgb = flat(DRAWN_RGB, len(mesh.dots)) if mesh.dot_rgb is None else mesh.dot_rgb
    lines, dots = mesh.points[mesh.lines], mesh.points[mesh.dots]
    return Finished(mesh.points, *_divided(mesh, rgb), edges, lines, dots, dot_rgb)


def vector(values: ArrayLike) -> Vector:
    x, y, z = np.asarray(values, dtype=np.float64).tolist()
    return x, y, z


def _check(path: Path, points: Floats, *, has_area: bool) -> None:
    lower, upper = points.min(axis=0), points.max(axis=0)
    size = math.dist(lower, upper)
    if size == 0.0:
        raise Refusal.saying(ONE_POINT, path)
    if not 1e-30 < size < 1e30:  # the GPU's float32 ends near 1e-38 and 1e38
        raise Refusal.saying(WRONG_SIZE, path, f"{size:.2g}")
    most = FARTHEST * size
    farthest = max((*lower, *upper), key=abs)
    if abs(farthest) > most:
        raise Refusal.saying(TOO_FAR, path, f"{farthest:.3g}", f"{most:.1g}")
    if has_area and _is_on_a_line((points - lower) / size):
        raise Refusal.saying(ONE_LINE, path)


def _is_on_a_line(points: Floats) -> bool:
    """Whether points (n, 3) of a mesh of size 1 are on a line as far as float64 can tell.

    Principal axes: the second spread is lost in the rounding of the first.
    """
    away = points - points.mean(axis=0)
    _, second, first = np.linalg.eigvalsh(away.T @ away)
    return bool(second <= 1e-15 * first)


def _face_colours(mesh: Mesh, progress: Progress | None) -> Colours:
    faces = len(mesh.offsets) - 1
    if mesh.rgb is not None and mesh.painted and (mesh.rgb != mesh.rgb[0]).any():
        return mesh.rgb
    paint = np.asarray(PAINT_RGB if mesh.rgb is None else mesh.rgb, dtype=np.float32)
    light = np.empty((faces, 1), dtype=np.float32)
    for first in range(0, faces, _BLOCK):
        which = slice(first, min(first + _BLOCK, faces))
        light[which, 0] = brightness(_normals(mesh, which))
        report(progress, 0.6 + 0.3 * which.stop / faces)
    return (paint * light).astype(np.uint8)


def _normals(mesh: Mesh, which: slice) -> Floats:
    """Return unit normals (m, 3) of some polygons, 0 where the area is 0.

    The area vectors of the triangles of a fan add up to that of the polygon, even a concave one.
    """
    offsets = mesh.offsets[which.start : which.stop + 1] - mesh.offsets[which.start]
    corners = mesh.corners[mesh.offsets[which.start] : mesh.offsets[which.stop]]
    counts = np.diff(offsets)
    if (counts == 3).all():  # the fan has one triangle
        a, b, c = (mesh.points[corners[i::3]] for i in range(3))
        before, after = (b - a).T, (c - a).T
        starts = np.arange(len(counts))
    else:
        away = mesh.points[corners] - np.repeat(mesh.points[corners[offsets[:-1]]], counts, axis=0)
        before, after = away.T, away[following(offsets)].T
        starts = offsets[:-1]
    area = np.empty((3, len(counts)))
    for x, y, z in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        area[x] = np.add.reduceat(before[y] * after[z] - before[z] * after[y], starts)
    length = np.sqrt((area**2).sum(axis=0))
    length[length == 0.0] = 1.0
    normals: Floats = (area / length).T
    return normals


def _feature_edges(mesh: Mesh) -> Floats:
    """Return the sharp and free edges (m, 2, 3), and those of more than two faces.

    Files repeat a vertex for every face, or where its texture or normal changes: copies are merged
    to find neighbours. VTK's filter takes time quadratic in the faces at one edge, and a few
    kilobytes of glTF can have thousands.
    """
    points, merged = distinct_rows(mesh.points)
    starts = merged[mesh.corners]
    ends = merged[mesh.corners[following(mesh.offsets)]]
    faces = len(mesh.offsets) - 1
    normals = _normals(mesh, slice(0, faces))
    apart = starts != ends
    face = np.repeat(np.arange(faces), np.diff(mesh.offsets))[apart]
    keys = (np.minimum(starts, ends) * len(points) + np.maximum(starts, ends))[apart]
    order = np.argsort(keys, kind="stable")
    found, first, count = np.unique(keys[order], return_index=True, return_counts=True)
    two = count == 2
    one_side, other_side = (normals[face[order[first[two] + i]]] for i in (0, 1))
    drawn = ~two
    drawn[two] = (one_side * other_side).sum(axis=1) <= _SHARP
    edges: Floats = points[np.stack(np.divmod(found[drawn], len(points)), axis=1)]
    return edges


def _divided(mesh: Mesh, rgb: Colours) -> tuple[Ints, Ints, Colours]:
    """Return offsets, corners and colours of the faces with polygons divided into triangles.

    VTK divides them, but omits polygons that cross or repeat themselves: these become fans.
    """
    counts = np.diff(mesh.offsets)
    large = np.flatnonzero(counts > 4)
    if not large.size:
        return mesh.offsets, mesh.corners, rgb
    import pyvista as pv

    ends = np.concatenate([[0], np.cumsum(counts[large])])
    places = np.arange(ends[-1]) + np.repeat(mesh.offsets[large] - ends[:-1], counts[large])
    part = pv.PolyData()
    part.points = mesh.points
    part.SetPolys(pv.CellArray.from_arrays(ends, mesh.corners[places], deep=True))
    part.cell_data["face"] = large
    part = part.triangulate()
    lost = np.setdiff1d(large, part.cell_data["face"])
    triangles = counts[lost] - 2
    fan = np.repeat(lost, triangles)
    step = np.arange(len(fan)) - np.repeat(np.cumsum(triangles) - triangles, triangles)
    first = mesh.offsets[fan]
    fans = mesh.corners[np.stack([first, first + step + 1, first + step + 2], axis=1)]
    kept = counts <= 4
    corners = [mesh.corners[np.repeat(kept, counts)], part.regular_faces.ravel(), fans.ravel()]
    face = np.concatenate([np.flatnonzero(kept), part.cell_data["face"], fan])
    sizes = np.where(kept, counts, 3)[face]
    return np.concatenate([[0], np.cumsum(sizes)]), np.concatenate(corners), rgb[face]


def following(offsets: Ints) -> Ints:
    """Return for every corner of the faces the place of the next corner of the same face."""
    following = np.arange(1, offsets[-1] + 1)
    following[offsets[1:] - 1] = offsets[:-1]
    return following
