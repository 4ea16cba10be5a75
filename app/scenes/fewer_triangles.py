"""Reduce the triangles of a scene so that it looks the same from far enough away.

Meshes up to `QUADRIC_TRIANGLES` lose the edges with the least error (Garland and Heckbert,
*Surface Simplification Using Quadric Error Metrics*, 1997). The vertices of larger ones are sorted
into boxes, and every box keeps one (Lindstrom, *Out-of-Core Simplification of Large Polygonal
Models*, 2000): this is coarser but takes a tenth of a second for a million vertices. VTK has both.
"""

import math
from dataclasses import replace
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from app.scenes.poly_data import dot_set
from app.scenes.scene import Scene
from app.scenes.shapes import distinct_rows

if TYPE_CHECKING:
    from app.scenes.poly_mesh import PolyMesh

SHARES = (0.5, 0.2, 0.1, 0.05, 0.01)  # shares of the triangles that are kept, from fine to coarse
LEAST_TRIANGLES = 1_000  # a smaller mesh is never reduced
_DRAGGED = (*SHARES, 0.005, 0.002, 0.001, 0.0005)
_LEAST_DRAGGED = 500  # triangles: with fewer a frame is hardly faster, and the shape is lost
QUADRIC_TRIANGLES, QUADRIC_VALENCE = 100_000, 500
"""Larger meshes, or more triangles at one vertex, use boxes: edges would take minutes."""

_MOST_BOXES = 400  # along the longest side; VTK ends the program if memory runs out
_WITHIN = 1.15  # of the requested share

_reduced: WeakKeyDictionary[Scene, dict[float, Scene]] = WeakKeyDictionary()


def can_be_reduced(scene: Scene) -> bool:
    """Whether the scene has enough triangles or dots to be reduced."""
    many = max(scene.triangles, scene.dot_count) >= LEAST_TRIANGLES
    return many and "vertices" not in scene.requires  # which are drawn elsewhere, each of them


def reduced(scene: Scene, share: float) -> Scene:
    """Return the scene with about this share (above 0, up to 1) of its triangles and dots.

    It is made once. Origin, bounds, lines and first camera do not change. A scene that cannot be
    reduced is returned as it is.
    """
    made = _reduced.setdefault(scene, {})
    if share not in made:
        if share >= 1.0 or not can_be_reduced(scene):
            return scene
        surface, dots = scene.surface, scene.dots
        if surface is not None and scene.triangles >= LEAST_TRIANGLES:
            surface = surface if surface.is_all_triangles else surface.triangulate()
            surface = _fewer(surface, share)
        if dots is not None and dots.n_points >= LEAST_TRIANGLES:
            kept = slice(None, None, round(1.0 / share))
            dots = dot_set(dots.points[kept], dots.point_data["rgb"][kept])
        made[share] = replace(scene, surface=surface, dots=dots)
    return made[share]


def shares_for_dragging(scene: Scene) -> tuple[float, ...]:
    """Return the shares for drawing while a control is dragged, from fine to coarse."""
    cells = scene.cells if can_be_reduced(scene) else 0
    return tuple(share for share in _DRAGGED if share * cells >= _LEAST_DRAGGED)


def is_made(scene: Scene, share: float) -> bool:
    """Whether `reduced` returns at once."""
    if share >= 1.0 or share in _reduced.get(scene, {}):
        return True
    return not can_be_reduced(scene)


def _fewer(surface: "PolyMesh", share: float) -> "PolyMesh":
    from vtkmodules.vtkFiltersCore import vtkQuadricDecimation

    from app.scenes.poly_mesh import PolyMesh

    at_one_vertex = int(np.bincount(np.asarray(surface.regular_faces, np.int64).ravel()).max())
    if surface.n_cells <= QUADRIC_TRIANGLES and at_one_vertex <= QUADRIC_VALENCE:
        decimation = vtkQuadricDecimation()
        decimation.SetInputData(surface)
        decimation.SetTargetReduction(1.0 - share)
        decimation.Update()
        fewer = _plain(PolyMesh.sharing(decimation.GetOutput()))
        if "rgb" in surface.cell_data:
            fewer.cell_data["rgb"] = surface.cell_data["rgb"][_nearest_cells(surface, fewer)]
        return fewer
    return _binned(surface, share)


def _binned(surface: "PolyMesh", share: float) -> "PolyMesh":
    """Vary the box size, corrected by the square of the result, until the share is reached."""
    from vtkmodules.vtkFiltersCore import vtkBinnedDecimation

    from app.scenes.poly_mesh import PolyMesh

    wanted = share * surface.n_cells
    lengths = np.array(surface.bounds[1::2]) - surface.bounds[::2]
    boxes = min(float(_MOST_BOXES), math.sqrt(wanted / 2.0))
    best = surface
    for _ in range(6):
        decimation = vtkBinnedDecimation()
        decimation.SetInputData(surface)
        decimation.AutoAdjustNumberOfDivisionsOff()
        sides = np.maximum(1, np.round(boxes * lengths / lengths.max())).astype(int)
        decimation.SetNumberOfDivisions(*sides.tolist())
        decimation.SetPointGenerationModeToBinAverages()
        decimation.ProduceCellDataOn()
        decimation.Update()
        mesh = PolyMesh.sharing(decimation.GetOutput())
        left = mesh.n_cells  # 0 if all triangles have collapsed
        if left and abs(math.log(left / wanted)) < abs(math.log(best.n_cells / wanted)):
            best = mesh
        ratio = wanted / max(1, mesh.n_cells)
        if 1.0 / _WITHIN < ratio < _WITHIN or (ratio > 1.0 and boxes >= _MOST_BOXES):
            break
        boxes = min(float(_MOST_BOXES), max(2.0, boxes * math.sqrt(ratio)))
    fewer = _plain(best)
    if "rgb" in best.cell_data:
        fewer.cell_data["rgb"] = np.array(best.cell_data["rgb"])
    return fewer


def _plain(mesh: "PolyMesh") -> "PolyMesh":
    """Keep points and triangles only."""
    from app.scenes.poly_mesh import PolyMesh

    return PolyMesh.of(mesh.points.astype(np.float32), faces=mesh.regular_faces)


def _nearest_cells(surface: "PolyMesh", fewer: "PolyMesh") -> NDArray[np.integer]:
    """Return for each triangle the original one with the nearest centre, whose colour it gets.

    A tree of the centres is used: VTK's cell locator compares all cells in one place.
    """
    from vtkmodules.vtkCommonDataModel import vtkKdTreePointLocator

    from app.scenes.poly_mesh import PolyMesh

    middles, number = distinct_rows(_centres(surface))
    first = np.empty(len(middles), dtype=np.int64)
    first[number[::-1]] = np.arange(len(number))[::-1]
    tree = vtkKdTreePointLocator()
    tree.SetDataSet(PolyMesh.of(middles))
    tree.BuildLocator()
    nearest = [tree.FindClosestPoint(middle) for middle in _centres(fewer).tolist()]
    return np.asarray(first[np.array(nearest, dtype=np.int64)])


def _centres(mesh: "PolyMesh") -> NDArray[Any]:
    """Return the centre of each triangle, (n, 3)."""
    from vtkmodules.vtkFiltersCore import vtkCellCenters

    from app.scenes.poly_mesh import PolyMesh

    centres = vtkCellCenters()
    centres.SetInputData(mesh)
    centres.Update()
    return PolyMesh.sharing(centres.GetOutput()).points
