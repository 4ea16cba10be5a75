"""The way of the eye in the world pane while the model's camera walks round the scene."""

from collections.abc import Sequence

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings.actors import line_actor
from app.drawings.layer import NO_POINTS, Layer
from app.drawings.world_state import WorldState
from app.model.projection import Array, Vector
from app.scenes.poly_mesh import vtk_points


class EyeWalk(Layer):
    """The line along which the eye walks, made at the first walk; all walks have as many points."""

    def __init__(self, state: WorldState) -> None:
        self._state = state
        self._line: vtkActor | None = None
        self._points = NO_POINTS

    def show_walk(self, eyes: Sequence[Vector]) -> None:
        """Draw a line through places of the eye, in the world; hide it for none."""
        state = self._state
        self._points = np.reshape(np.array(eyes, dtype=np.float64), (-1, 3)) - state.origin
        if self._line is None and len(eyes):
            ends = [range(len(eyes))]
            self._line = line_actor(self._points, ends, state.style.muted, state.style.line_width)
            state.canvas.add(self._line, layer="camera")
        if self._line is not None:
            state.canvas.set_visible(len(eyes) > 0, self._line)
            if len(eyes):
                mesh = self._line.GetMapper().GetInput()
                mesh.SetPoints(vtk_points(self._points.astype(np.float32)))

    def reach(self) -> Array:
        return self._points

    def inside(self) -> dict[str, Array]:
        return {"walk": self._points} if len(self._points) else {}
