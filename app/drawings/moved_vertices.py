"""Vertices that a phenomenon computes, drawn in place of the scene's own.

All drawings of a scene share its faces; what is moved is a copy, of a few vertices. A texture lies
on the vertices and moves with them: `PLACE` holds where each one was.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from vtkmodules.vtkRenderingCore import vtkActor

from app.model.projection import Array
from app.scenes.phenomena.marks import Vertices
from app.scenes.poly_mesh import PolyMesh
from app.scenes.scene import Scene

PLACE = "place"  # the point data with the scene's own vertices, scene-local


class MovedVertices:
    """The vertices of a scene's faces in one pane, if the scene requires ``"vertices"``.

    `way` says which vertices the pane shows: ``"stored"`` or ``"projected"`` (`Vertices`).
    """

    def __init__(self, scene: Scene, way: str, faces: vtkActor | None) -> None:
        self._origin, self._way = np.array(scene.origin), way
        self._faces = faces if "vertices" in scene.requires else None
        self._copy: PolyMesh | None = None
        self._points: NDArray[np.float32] = np.empty((0, 3), np.float32)
        self._rows: NDArray[np.intp] = np.empty(0, np.intp)
        self._own: Array | None = None
        self._drawn: Array | None = None
        self.show(None)

    def show(self, vertices: Vertices | None) -> None:
        """Draw these vertices, or the scene's own; call it after the faces have been chosen."""
        if self._faces is None:
            return
        mapper: Any = self._faces.GetMapper()
        if self._copy is None or mapper.GetInput() is not self._copy:
            self._copy_faces(mapper)
        assert self._copy is not None
        if vertices is None:
            self._points[:] = self._copy.point_data[PLACE]
            self._drawn = None
        else:
            places: Array = getattr(vertices, self._way)
            if places is self._drawn:
                return
            if vertices.own is not self._own:
                self._find(vertices.own)
            self._points[:] = (places - self._origin)[self._rows]
            self._drawn = places
        points = self._copy.GetPoints()
        points.GetData().Modified()
        points.Modified()
        self._copy.Modified()

    def _copy_faces(self, mapper: Any) -> None:
        """Give the pane a copy of the faces with points of its own."""
        self._copy = PolyMesh.sharing(mapper.GetInput())
        self._points = self._copy.points = self._copy.points.astype(np.float32)
        self._copy.point_data[PLACE] = self._points.copy()
        self._own = self._drawn = None
        mapper.SetInputData(self._copy)

    def _find(self, own: Array) -> None:
        """Find the row of `own`, (n, 3), that each point of the faces is in."""
        assert self._copy is not None
        self._own = own
        local = (own - self._origin).astype(np.float32).tolist()
        rows = {tuple(point): row for row, point in enumerate(local)}
        place = np.asarray(self._copy.point_data[PLACE]).tolist()
        self._rows = np.array([rows[tuple(point)] for point in place])
