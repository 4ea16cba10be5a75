"""The scene as the model's camera sees it, in the cheapest arithmetic that is exact enough.

==========  ================================================================================
precision   how vertices get their clip coordinates
==========  ================================================================================
float32     on the GPU, by one concatenated matrix; a step of a slider sets that matrix
float64     here, eye first, by `Projection.trace`; the GPU is handed the results
==========  ================================================================================

Faces, dots and lines choose for themselves: each takes the cheaper one if its bound, over the
boxes that hold them, is below the tolerance.

In float64 the price is paid per vertex and step. A vertex handed over has three coordinates, x, y,
z of clip space. w is ``(z - b)/a`` with lecture 000's ``z = a w + b``, or 1 for a parallel lens, so
that a matrix restores it. Rounding these to float32 costs 2e-4 px of 1280 at most. For edges to be
as exact as their ends, everything outside a cone somewhat wider than the picture, before near or
beyond far is cut off beforehand: an edge that ends 1e5 pictures away would be drawn 1e5 times as
inexactly as one that ends here.

Under a free matrix w is no function of z. There the divide is done here too, which for faces of
one colour draws the same picture.

The world pane does without: its own camera is never at an extreme, and the picture on the near
plane is too small to see wherever float32 is not enough for it (of 1086 random extreme cameras,
one was off by more than half a pixel, at a field of view of 179.998 degrees).
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property, reduce
from typing import Any, NamedTuple
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings.actors import CUBE_CORNERS, Detail, SceneActors, lifted
from app.drawings.scene_place import place_of
from app.drawings.style import Style
from app.model.projection import Array, Chain, Projection, Space
from app.precision.levels import Precision
from app.scenes.scene import Scene

_GROUND = 3
_WIDE = 2.0  # of the picture: beyond, wide lines and points do not reach into it
MANY_CELLS, _CLUSTERS = 1_000, 256  # from this many cells on; into about this many clusters
_LEAST_W = 1e-30  # under a free matrix: nearer to w = 0, the divide overflows
_SHALLOW = 1.0 - 2.0**-22  # of the depth range: or the far plane takes what float32 rounds onto it


def least_tolerance(scene: Scene, tolerance_px: float) -> float:
    """Return a scene's tolerance: infinite if a texture or moved vertices need the GPU's own."""
    return math.inf if scene.requires & {"texture", "vertices"} else tolerance_px


_projected: "WeakKeyDictionary[Scene, _Projected]" = WeakKeyDictionary()


class ModelActors:
    """A scene's actors under a projection: their matrices and their vertices.

    The GPU's own float32 may draw up to an error of `tolerance_px`.
    """

    def __init__(
        self, scene: Scene, style: Style, tolerance_px: float, clip: Iterable[vtkPlane] = ()
    ) -> None:
        self._scene = scene
        self._tolerance_px = tolerance_px
        self.actors = SceneActors(scene, style, clip)
        self.surface = self.actors.surface
        self._detail = Detail(self.surface, self.actors.dots)
        self._made: tuple[_Made | None, ...] = ()
        self.show_detail(None)

    @property
    def precision(self) -> Precision:
        """The arithmetic of the last projection shown: float64 if anything was drawn with it."""
        return "float64" if any(made and made.is_projected for made in self._made) else "float32"

    def show_detail(self, fewer: Scene | None) -> None:
        self.show_local()
        self._detail.show(fewer)
        self._fewer = fewer
        self._made = tuple(None if actor is None else _Made(actor) for actor in self.actors.all)

    def show_grid(self, shown: bool) -> None:
        self.show_local()
        self.actors.show_grid(shown)
        self.show_detail(self._fewer)

    def _move(self, placement: Chain) -> None:
        if self.actors.is_moved == placement.is_identity:
            self.show_local()
            self.actors.show_moved(not placement.is_identity)
            self.show_detail(self._fewer)

    def show_projection(self, projection: Projection) -> list[Array]:
        """Choose the precision, and give the actors their vertices.

        `projection` has the depth range ``opengl``. Returns the matrices, (4, 4), of surface, dots,
        lines and ground: clip from vertex coordinates.
        """
        scene, placement = self._scene, projection.placement
        self._move(placement)
        _, clip_from_object, clip_from_world, bounds_px = place_of(scene, projection)
        bounds = *bounds_px, 0.0  # while nothing is moved there is no ground
        matrices = [*[clip_from_object] * _GROUND, clip_from_world]
        for which, (made, bound_px) in enumerate(zip(self._made, bounds, strict=False)):
            if made is not None and made.is_seen and bound_px > self._tolerance_px:
                matrices[which] = made.replace(self._part(which, made, projection))
            elif made is not None:
                made.restore()
        if self.precision == "float32":
            _projected.pop(scene, None)
        return matrices

    def show_picture(self, projection: Projection) -> None:
        """Show the picture of `show_projection`, with dots and lines lifted before the faces."""
        matrices = self.show_projection(projection)
        forward = {id(matrix): matrix for matrix in matrices[1:]}  # often one matrix for all
        forward = {key: lifted(each, projection, self._scene) for key, each in forward.items()}
        self.actors.place([matrices[0], *(forward[id(matrix)] for matrix in matrices[1:])])

    def show_placed(self, placement: Chain) -> Array:
        """Give the actors the scene's own vertices, and return the objects' matrix, (4, 4).

        It converts the objects' coordinates to world-local ones, which the ground has already.
        """
        self._move(placement)
        self.show_local()
        return placement.local_from(self._scene.origin, self._scene.origin)

    def show_local(self) -> None:
        """Give the actors the scene's own vertices, scene-local."""
        if self.precision != "float32":
            _projected.pop(self._scene, None)
        for made in self._made:
            if made is not None:
                made.restore()

    def _part(self, which: int, made: "_Made", projection: Projection) -> "_MeshVertices":
        """What a projection leaves of a mesh, computed once for all panes."""
        kept = _projected.get(self._scene)
        if kept is None or kept.fewer is not self._fewer or kept.projection != projection:
            kept = _projected[self._scene] = _Projected(self._fewer, projection)
        if which not in kept.parts:
            space: Space = "world" if which == _GROUND else "object"
            part = _projected_part(made, projection, np.array(self._scene.origin), space)
            kept.parts[which] = _MeshVertices(part, made, projection)
        return kept.parts[which]


@dataclass
class _Projected:
    """The last projection of a scene's parts, by their places in `SceneActors.all`."""

    fewer: Scene | None
    projection: Projection
    parts: "dict[int, _MeshVertices]" = field(default_factory=dict)


class _MeshVertices:
    """What is left of a mesh, for the GPU; never changed, so that panes can share it.

    `points` are x, y and z of clip space; `cells` is None if all are left; `rgb` holds the colours
    of the points and of the cells that are left, where there are any.
    """

    def __init__(self, part: "_MeshPart", made: "_Made", projection: Projection) -> None:
        per_z, constant = projection.passage.w_of_z  # a constant alone where w is divided out
        clip = part.clip
        if not per_z:
            w = clip[:, 3:]
            clip = clip / np.where(w > 0.0, w, 1.0)
        # The homogeneous factor is free: as a power of two, whatever there is fits into float32.
        unit = 2.0 ** -math.frexp(float(np.abs(clip).max(initial=0.0)))[1]
        self.points = vtkPoints()
        vertices = (clip[:, :3] * unit).astype(np.float32)
        self.points.SetData(numpy_to_vtk(vertices, deep=True))  # type: ignore[no-untyped-call]
        self.cells: vtkCellArray | None = None
        self.rgb: list[Any] = [None, None]
        if part.vertex is not None:
            self.cells = vtkCellArray()
            flat = numpy_to_vtk(part.cells.astype(np.int64).ravel(), deep=True)  # type: ignore[no-untyped-call]
            self.cells.SetData(part.cells.shape[1], flat)
            for i, (colours, chosen) in enumerate(
                zip(made.colours, (part.vertex, part.cell), strict=True)
            ):
                if colours is not None:
                    left = numpy_to_vtk(vtk_to_numpy(colours)[chosen], deep=True)  # type: ignore[no-untyped-call]
                    left.SetName("rgb")
                    self.rgb[i] = left
        self.clip_from_vertex = np.diag([1.0, 1.0, _SHALLOW, 0.0]) / unit
        self.clip_from_vertex[3, 2:] = per_z / unit, constant


class _Made:
    """An actor, the mesh that it was made with, and its replacement by a projection.

    All cells of the mesh are of one kind: points, segments or triangles.
    """

    def __init__(self, actor: vtkActor) -> None:
        self._actor = actor
        self._mapper: Any = actor.GetMapper()
        self._mesh: vtkPolyData = self._mapper.GetInput()
        self._projected = vtkPolyData()
        self._kind = next(
            (kind for kind in ("Verts", "Polys") if _cells(self._mesh, kind).GetNumberOfCells()),
            "Lines",
        )

    @cached_property
    def clusters(self) -> "_Clusters":
        """Its cells by their places, once one of them has to be projected here."""
        return _Clusters.of(self.points.astype(np.float64), self.cells)

    @property
    def points(self) -> NDArray[np.float32]:
        """The mesh's vertices, scene-local, (n, 3)."""
        points: NDArray[np.float32] = vtk_to_numpy(self._mesh.GetPoints().GetData())  # type: ignore[no-untyped-call]
        return points

    @property
    def cells(self) -> NDArray[np.integer]:
        """Indices of each cell's vertices, (m, k) with k from 1 to 3."""
        cells = _cells(self._mesh, self._kind)
        count = cells.GetNumberOfCells()
        flat: NDArray[np.integer] = vtk_to_numpy(cells.GetConnectivityArray())  # type: ignore[no-untyped-call]
        return flat.reshape(count, -1) if count else flat.reshape(0, 1)

    @property
    def colours(self) -> tuple[Any, Any]:
        """Those of the mesh's points and of its cells, or None."""
        data = self._mesh.GetPointData(), self._mesh.GetCellData()
        points, cells = (each.GetArray("rgb") for each in data)
        return points, cells

    @property
    def is_seen(self) -> bool:
        return bool(self._actor.GetVisibility() and self._mesh.GetNumberOfCells())

    @property
    def is_projected(self) -> bool:
        return self._mapper.GetInput() is self._projected

    def restore(self) -> None:
        if self.is_projected:
            self._mapper.SetInputData(self._mesh)
            self._projected.Initialize()

    def replace(self, vertices: _MeshVertices) -> Array:
        """Show the mesh with other vertices, and return their matrix, (4, 4)."""
        made = self._projected
        made.ShallowCopy(self._mesh)
        made.SetPoints(vertices.points)
        if vertices.cells is not None:
            getattr(made, f"Set{self._kind}")(vertices.cells)
        for data, colours in zip((made.GetPointData(), made.GetCellData()), vertices.rgb,
                                 strict=True):  # fmt: skip
            if colours is not None:
                data.AddArray(colours)
        if not self.is_projected:
            self._mapper.SetInputData(made)
        return vertices.clip_from_vertex


def _cells(mesh: vtkPolyData, kind: str) -> vtkCellArray:
    cells: vtkCellArray = getattr(mesh, f"Get{kind}")()
    return cells


# --------------------------------------------------------------------------- cutting


class _MeshPart(NamedTuple):
    clip: Array  # (n, 4): vertices in clip space
    cells: NDArray[np.integer]  # (m, k)
    vertex: NDArray[np.integer] | None  # (n,): whose colour each has; None if all are left
    cell: NDArray[np.integer] | None  # (m,): of which cell each was part; likewise


class _Clusters(NamedTuple):
    """Cells of a mesh by their places, so that whole clusters can be skipped.

    `boxes`, (c, 8, 3), are the corners of boxes round the clusters, scene-local; `cluster`, (m,),
    is the cluster of each cell.
    """

    boxes: Array
    cluster: NDArray[np.integer]

    @classmethod
    def of(cls, points: Array, cells: NDArray[np.integer]) -> "_Clusters":
        """Cluster cells, (m, k), over points, (n, 3)."""
        first, *others = (points[corners] for corners in cells.T)
        low = reduce(np.minimum, others, first)
        high = reduce(np.maximum, others, first)
        start, extent = low.min(axis=0), high.max(axis=0) - low.min(axis=0)
        reach = np.maximum(extent, extent.max() / _CLUSTERS)
        steps = np.ceil(reach / np.cbrt(reach.prod() / _CLUSTERS)).astype(np.intp)
        place = ((low + high) / 2.0 - start) / reach * steps
        keys = np.ravel_multi_index(tuple(place.astype(np.intp).clip(0, steps - 1).T), steps)
        cluster = np.unique(keys, return_inverse=True)[1]
        order = np.argsort(cluster, kind="stable")
        starts = np.flatnonzero(np.diff(cluster[order], prepend=-1))
        ends = np.minimum.reduceat(low[order], starts), np.maximum.reduceat(high[order], starts)
        upper = (CUBE_CORNERS > 0.0)[None]
        return cls(np.where(upper, ends[1][:, None], ends[0][:, None]), cluster)


def _projected_part(made: _Made, projection: Projection, origin: Array, space: Space) -> _MeshPart:
    """What a projection leaves of a mesh; clusters beyond one plane are skipped."""
    planes, cells, points = _planes(projection), made.cells, made.points
    beyond = np.zeros(0, dtype=np.bool_)
    if len(cells) > MANY_CELLS:
        normals, offsets = planes
        rows = normals @ projection.clip_from_local(origin, space)
        rows[:, 3] += offsets
        boxes = made.clusters.boxes
        slack = 1e-9 * (np.abs(rows) @ (*np.abs(boxes).max(axis=(0, 1)), 1.0))  # for rounding
        beyond = ((boxes @ rows[:, :3].T + rows[:, 3]).max(axis=1) < -slack).any(axis=1)
    if not beyond.any():
        traced = projection.trace(points.astype(np.float64) + origin, space)
        return _cut(traced.clip, cells, planes)
    kept = np.flatnonzero(~beyond[made.clusters.cluster])
    used = np.zeros(len(points), dtype=np.bool_)
    used[cells[kept]] = True
    vertices = np.flatnonzero(used)
    at = np.cumsum(used) - 1
    traced = projection.trace(points[vertices].astype(np.float64) + origin, space)
    part = _cut(traced.clip, at[cells[kept]], planes)
    return part._replace(
        vertex=vertices if part.vertex is None else vertices[part.vertex],
        cell=kept if part.cell is None else kept[part.cell],
    )


def _planes(projection: Projection) -> tuple[Array, Array]:
    """Half-spaces of clip space round the picture, with the exact depth range.

    What is inside has ``normal . (x, y, z, w) + offset >= 0`` for all (p, 4) normals and offsets.
    """
    sides = [(1.0, 0.0, 0.0, _WIDE), (-1.0, 0.0, 0.0, _WIDE)]
    sides += [(0.0, 1.0, 0.0, _WIDE), (0.0, -1.0, 0.0, _WIDE)]
    depth = projection.passage.half_spaces(_LEAST_W)
    normals = np.array([*(normal for normal, _ in depth), *sides])
    return normals, np.array([*(offset for _, offset in depth), 0.0, 0.0, 0.0, 0.0])


def _cut(clip: Array, cells: NDArray[np.integer], planes: tuple[Array, Array]) -> _MeshPart:
    normals, offsets = planes
    out = np.zeros(len(clip), dtype=np.uint8)
    for bit, (normal, offset) in enumerate(zip(normals, offsets, strict=True)):
        out |= (clip @ normal + offset < 0.0).astype(np.uint8) << np.uint8(bit)
    if not out.any():
        return _MeshPart(clip, cells, None, None)
    corners = out[cells]
    whole = ~corners.any(axis=1)
    crossing = np.flatnonzero(~whole & (np.bitwise_and.reduce(corners, axis=1) == 0))
    pieces, owner = clip[cells[crossing]], crossing.astype(cells.dtype)
    crossed = int(np.bitwise_or.reduce(corners[crossing], axis=None))
    for bit, (normal, offset) in enumerate(zip(normals, offsets, strict=True)):
        if crossed >> bit & 1:
            pieces, owner = _cut_at(pieces, owner, normal, offset)
    kept = np.flatnonzero(whole)
    count, size = cells.shape[1], len(clip)
    needed = np.where(out[:, None] == 0, clip, 0.0)  # what is outside may not fit into float32
    return _MeshPart(
        np.concatenate([needed, pieces.reshape(-1, 4)]),
        np.concatenate([cells[kept], size + np.arange(len(pieces) * count).reshape(-1, count)]),
        # A triangle's last corner carries its colour; its other corners' are never looked at.
        np.concatenate([np.arange(size), np.repeat(cells[owner, -1], count)]),
        np.concatenate([kept, owner]),
    )


def _cut_at(
    pieces: Array, owner: NDArray[np.integer], normal: Array, offset: float
) -> tuple[Array, NDArray[np.integer]]:
    values = pieces @ normal + offset
    inside = values >= 0.0
    if inside.all():
        return pieces, owner
    count = inside.sum(axis=1)
    corners = pieces.shape[1]
    left, owners = [pieces[count == corners]], [owner[count == corners]]
    for held in range(1, corners):
        which = np.flatnonzero(count == held)
        if not len(which):
            continue
        # The corner that is alone, or a segment's inside one, comes first.
        alone = np.argmax(inside[which] == (held == 1), axis=1)
        order = (alone[:, None] + np.arange(corners)) % corners
        p = list(pieces[which[:, None], order].swapaxes(0, 1))
        v = list(values[which[:, None], order].T)
        if held == 1:
            first = [_between(p[0], p[i], v[0], v[i]) for i in range(1, corners)]
            new = [[p[0], *first]]
        else:  # a triangle's quadrangle, cut in two
            one, two = (_between(p[i], p[0], v[i], v[0]) for i in (1, 2))
            new = [[one, p[1], p[2]], [one, p[2], two]]
        for piece in new:
            left.append(np.stack(piece, axis=1))
            owners.append(owner[which])
    return np.concatenate(left), np.concatenate(owners)


def _between(inside: Array, outside: Array, value_inside: Array, value_outside: Array) -> Array:
    """Where edges (m, 4) meet the plane, on which the values (m,) are 0.

    Always from the inside outwards, so that neighbours find the same point on a common edge.
    """
    part = value_inside / (value_inside - value_outside)
    return np.asarray(inside + part[:, None] * (outside - inside))
