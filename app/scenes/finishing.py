"""Prepare a mesh for drawing: check it, colour it, find its edges, divide its large polygons.

All slow work on a large mesh is here, so that `app.scenes.reading` can do it in another process.
"""

import math
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from app.model.limits import Vector, vector
from app.model.refusal import REFUSALS, Refusal
from app.scenes.mesh import PAINT_RGB, Colours, Floats, Ints, Mesh, Progress, report
from app.scenes.polygons import are_convex, area_vectors, divided, following
from app.scenes.shapes import DRAWN_RGB, brightness, distinct_rows, flat

FARTHEST = 1e12  # largest distance from the origin, in sizes of the mesh: vertices keep four digits
DIVIDING = 0.9  # progress from which only faces are divided
FACES_WITH_EDGES = 5_000
"""Most faces of a mesh with edge lines, of up to 8 corners on average: more lines would be denser
than the pixels."""
FLAT_DOTS = 1_000  # most dots that have one colour
_BLOCK = 100_000  # faces that are computed at once, between two reports of progress
_SHARP = math.cos(math.radians(30.0))  # edges whose faces turn by a larger angle are drawn


class Finished(NamedTuple):
    """A mesh that is ready to be drawn.

    - `offsets`, `corners` (m + 1,) and (offsets[m],): as in `app.scenes.mesh.Mesh`, for faces of
      three or four corners.
    - `dots`, `dot_rgb` (d, 3): the file's own dots and their colours.
    """

    points: Floats  # (n, 3): world coordinates
    offsets: Ints
    corners: Ints
    rgb: Colours  # (m, 3): shaded colour of each face
    edges: Floats  # (k, 2, 3): ends of the faces' edges to draw
    lines: Floats  # (l, 2, 3): ends of the file's own lines
    dots: Floats
    dot_rgb: Colours
    notes: list[tuple[Any, ...]]  # as in `app.scenes.mesh.Mesh`

    @property
    def bounds(self) -> tuple[Vector, Vector]:
        """Least and largest coordinates."""
        return vector(self.points.min(axis=0)), vector(self.points.max(axis=0))


def finished(path: Path, mesh: Mesh, progress: Progress | None) -> Finished:
    """Prepare the mesh of a file.

    Raises a `Refusal` for a mesh of no size, too large, too far away, or of faces on one line.
    """
    report(progress, 0.5)
    faces = len(mesh.offsets) - 1
    check(path, mesh.points, has_area=faces > 0 and not (mesh.lines.size or mesh.dots.size))
    report(progress, 0.6)
    rgb = _face_colours(mesh, progress) if faces else np.empty((0, 3), dtype=np.uint8)
    has_edges = 0 < max(faces, len(mesh.corners) // 8) <= FACES_WITH_EDGES
    edges = _feature_edges(mesh) if has_edges else np.empty((0, 2, 3))
    lines, dots = mesh.points[mesh.lines], mesh.points[mesh.dots]
    dot_rgb = dot_colours(dots) if mesh.dot_rgb is None else mesh.dot_rgb
    divided_faces = _divided(mesh, rgb, progress)
    return Finished(mesh.points, *divided_faces, edges, lines, dots, dot_rgb, mesh.notes)


def check(path: Path | str, points: Floats, *, has_area: bool = False) -> None:
    lower, upper = points.min(axis=0), points.max(axis=0)
    size = math.dist(lower, upper)
    if size == 0.0:
        raise Refusal.saying(REFUSALS["one-point"], path)
    if not 1e-30 < size < 1e30:  # the GPU's float32 ends near 1e-38 and 1e38
        raise Refusal.saying(REFUSALS["wrong-size"], path, f"{size:.2g}")
    most = FARTHEST * size
    farthest = max((*lower, *upper), key=abs)
    if abs(farthest) > most:
        raise Refusal.saying(REFUSALS["too-far"], path, f"{farthest:.3g}", f"{most:.1g}")
    if has_area and _is_on_a_line((points - lower) / size):
        raise Refusal.saying(REFUSALS["one-line"], path)


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
        report(progress, 0.6 + (DIVIDING - 0.6) * which.stop / faces)
    return (paint * light).astype(np.uint8)


def dot_colours(dots: Floats) -> Colours:
    """Return colours (d, 3) of dots; many are shaded like a ball, or they would be one blot."""
    if len(dots) <= FLAT_DOTS:
        return flat(DRAWN_RGB, len(dots))
    away = dots - dots.mean(axis=0)
    away /= np.maximum(np.linalg.norm(away, axis=1, keepdims=True), 1e-30)
    return np.asarray((brightness(away)[:, None] * np.multiply(1.5, DRAWN_RGB)).astype(np.uint8))


def _normals(mesh: Mesh, which: slice) -> Floats:
    """Return unit normals (m, 3) of some polygons, 0 where the area is 0."""
    offsets = mesh.offsets[which.start : which.stop + 1]
    corners = mesh.corners[offsets[0] : offsets[-1]]
    areas = area_vectors(mesh.points, offsets - offsets[0], corners)
    lengths = np.sqrt((areas**2).sum(axis=1))
    lengths[lengths == 0.0] = 1.0
    return np.asarray(areas / lengths[:, None])


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
    keys = np.minimum(starts, ends) * len(points) + np.maximum(starts, ends)
    order = np.argsort(keys, kind="stable")
    keys, face = keys[order], np.repeat(np.arange(faces), np.diff(mesh.offsets))[order]
    is_new = np.append(True, (np.diff(keys) != 0) | (np.diff(face) != 0))
    # An edge that one face runs there and back, such as the bridge to a hole, bounds nothing.
    bounds = np.add.reduceat(np.sign(ends - starts)[order], np.flatnonzero(is_new)) != 0
    keys, face = keys[is_new][bounds], face[is_new][bounds]
    distinct, first, count = np.unique(keys, return_index=True, return_counts=True)
    two = count == 2
    one_side, other_side = (normals[face[first[two] + i]] for i in (0, 1))
    drawn = ~two
    drawn[two] = (one_side * other_side).sum(axis=1) <= _SHARP
    return np.asarray(points[np.stack(np.divmod(distinct[drawn], len(points)), axis=1)])


def _divided(mesh: Mesh, rgb: Colours, progress: Progress | None) -> tuple[Ints, Ints, Colours]:
    """Return offsets, corners and colours of the faces with polygons divided into triangles.

    Convex faces of four corners stay whole: every way to divide them is right.
    """
    counts = np.diff(mesh.offsets)
    is_whole = counts == 3
    for which in _blocks(np.flatnonzero(counts == 4)):
        quads = mesh.corners[mesh.offsets[which][:, None] + np.arange(4)]
        is_whole[which] = are_convex(mesh.points[quads])
    large = np.flatnonzero(~is_whole)
    if not large.size:
        return mesh.offsets, mesh.corners, rgb
    corners, face = [mesh.corners[np.repeat(is_whole, counts)]], [np.flatnonzero(is_whole)]

    def report_polygon(before: int, polygon: int) -> None:
        report(progress, DIVIDING + (1.0 - DIVIDING) * (before + polygon) / len(large))

    for number, which in enumerate(_blocks(large)):
        ends = np.concatenate([[0], np.cumsum(counts[which])])
        places = np.arange(ends[-1]) + np.repeat(mesh.offsets[which] - ends[:-1], counts[which])
        reported = partial(report_polygon, number * _BLOCK)
        triangles, owners = divided(mesh.points, ends, mesh.corners[places], reported)
        corners.append(triangles.ravel())
        face.append(which[owners])
    faces = np.concatenate(face)
    sizes = np.where(is_whole, counts, 3)[faces]
    return np.concatenate([[0], np.cumsum(sizes)]), np.concatenate(corners), rgb[faces]


def _blocks(faces: Ints) -> list[Ints]:
    return [faces[first : first + _BLOCK] for first in range(0, len(faces), _BLOCK)]
