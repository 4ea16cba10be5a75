"""VTK's meshes with numpy's arrays, by pyvista's names: to import pyvista takes as long as VTK."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

Cells = NDArray[Any] | Sequence[Sequence[int]]  # corners of each cell; of an array, each row is one


class PolyMesh(vtkPolyData):
    """Points with faces or lines; its arrays share their memory with numpy's.

    Without cells, each point is a dot.
    """

    @classmethod
    def of(
        cls, points: NDArray[Any], *, faces: Cells | None = None, lines: Cells | None = None
    ) -> "PolyMesh":
        made = cls()
        made.points = points
        if faces is not None:
            made.SetPolys(_cells(faces))
        if lines is not None:
            made.SetLines(_cells(lines))
        if faces is None and lines is None:
            made.SetVerts(_cells(np.arange(len(points))[:, None]))
        return made

    @classmethod
    def sharing(cls, mesh: vtkPolyData) -> "PolyMesh":
        """Return a mesh with the points, cells and arrays of another one."""
        made = cls()
        made.ShallowCopy(mesh)
        return made

    @property
    def points(self) -> NDArray[Any]:
        return _values(self.GetPoints().GetData())

    @points.setter
    def points(self, points: NDArray[Any]) -> None:
        self.SetPoints(vtk_points(points))

    @property
    def point_data(self) -> "_NamedArrays":
        return _NamedArrays(self.GetPointData())

    @property
    def cell_data(self) -> "_NamedArrays":
        return _NamedArrays(self.GetCellData())

    @property
    def n_points(self) -> int:
        return int(self.GetNumberOfPoints())

    @property
    def n_cells(self) -> int:
        return int(self.GetNumberOfCells())

    @property
    def bounds(self) -> tuple[float, ...]:
        """Least and largest x, y and z."""
        return tuple(self.GetBounds())

    @property
    def is_all_triangles(self) -> bool:
        faces = self.GetPolys()
        return faces.IsHomogeneous() == 3 and faces.GetNumberOfCells() == self.n_cells

    @property
    def regular_faces(self) -> NDArray[Any]:
        """The corners of faces that have equally many, a row for each."""
        faces = self.GetPolys()
        return _values(faces.GetConnectivityArray()).reshape(-1, faces.GetMaxCellSize() or 3)

    def triangulate(self) -> "PolyMesh":
        divided = vtkTriangleFilter()
        divided.SetInputData(self)
        divided.PassVertsOff()
        divided.PassLinesOff()
        divided.Update()
        return PolyMesh.sharing(divided.GetOutput())


class _NamedArrays:
    """The arrays of points or cells by their names."""

    def __init__(self, attributes: vtkDataSetAttributes) -> None:
        self._attributes = attributes

    def __contains__(self, name: str) -> bool:
        return bool(self._attributes.HasArray(name))

    def __getitem__(self, name: str) -> NDArray[Any]:
        return _values(self._attributes.GetArray(name))

    def __setitem__(self, name: str, values: NDArray[Any]) -> None:
        array = _shared(values)
        array.SetName(name)
        self._attributes.AddArray(array)


def vtk_points(points: NDArray[Any]) -> vtkPoints:
    """Return points that share the memory of an array."""
    made = vtkPoints()
    made.SetData(_shared(points))
    return made


def cells_from(offsets: NDArray[Any], corners: NDArray[Any]) -> vtkCellArray:
    made = vtkCellArray()
    made.SetData(_shared(offsets.astype(np.int64)), _shared(corners.astype(np.int64)))
    return made


def _cells(cells: Cells) -> vtkCellArray:
    if isinstance(cells, np.ndarray):
        count, size = cells.shape
        return cells_from(np.arange(0, count * size + 1, size), cells.ravel())
    return cells_from(np.cumsum([0, *map(len, cells)]), np.concatenate(cells))


def _shared(values: NDArray[Any]) -> Any:
    return numpy_to_vtk(np.ascontiguousarray(values))  # type: ignore[no-untyped-call]


def _values(array: Any) -> NDArray[Any]:
    return np.asarray(vtk_to_numpy(array))  # type: ignore[no-untyped-call]
