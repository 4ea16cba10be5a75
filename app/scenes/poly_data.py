"""The meshes that a scene gives to VTK, which is imported when the first of them is drawn."""

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from app.model.limits import Array
from app.scenes.mesh import Colours
from app.scenes.shapes import Coloured, distinct_rows

if TYPE_CHECKING:
    from app.scenes.poly_mesh import PolyMesh


class LaterMesh:
    """A mesh that is made when it is first drawn: importing VTK takes longer than showing a window.

    - `points` (n, 3): float32.
    - `bounds` (6,): least and largest x, y and z.
    - `n_cells`, `corners`: number of polygons or lines, and of all their corners.
    - `rgb` (n_cells, 3): uint8.
    - `cells` (n_cells + 1,) and (corners,): where the corners of each cell begin, and the corners.
    """

    def __init__(
        self, points: Array, offsets: NDArray[Any], corners: NDArray[Any], rgb: Colours
    ) -> None:
        self.points = points = points.astype(np.float32)  # small numbers with few digits
        self.bounds = np.stack([self.points.min(axis=0), self.points.max(axis=0)], axis=1).ravel()
        self.n_cells, self.corners, self.rgb = len(rgb), corners.size, rgb
        self.cells = offsets, corners
        self.make = partial(poly_data, points, offsets, corners, rgb)


def poly_data(
    points: NDArray[np.floating], offsets: NDArray[Any], corners: NDArray[Any], rgb: Colours
) -> "PolyMesh":
    """Make a mesh for VTK that keeps the digits of the points."""
    from app.scenes.poly_mesh import PolyMesh, cells_from

    cells = cells_from(offsets, corners)
    made = PolyMesh()
    made.points = points
    if cells.GetNumberOfCells() and cells.GetMaxCellSize() > 2:
        made.SetPolys(cells)
    else:
        made.SetLines(cells)
    made.cell_data["rgb"] = rgb
    return made


def surface_of(quads: Coloured) -> LaterMesh:
    points, corners = distinct_rows(quads[0].reshape(-1, 3))
    offsets = np.arange(0, corners.size + 1, 4)
    return LaterMesh(points, offsets, corners, quads[1])


def line_set(lines: Coloured) -> LaterMesh:
    ends = np.arange(2 * len(lines[0]))
    return LaterMesh(lines[0].reshape(-1, 3), np.arange(0, ends.size + 1, 2), ends, lines[1])


def dot_set(points: NDArray[np.floating], rgb: Colours) -> "PolyMesh | None":
    """Make dots for VTK; None without any."""
    from app.scenes.poly_mesh import PolyMesh

    if not len(points):
        return None
    dots = PolyMesh.of(points)
    dots.point_data["rgb"] = rgb
    return dots
