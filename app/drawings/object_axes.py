"""The object's own axes: the columns of `world_from_object`, drawn in place."""

from __future__ import annotations

import math

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings.actors import Canvas, Space, put_in_front
from app.drawings.frame import arrow
from app.lecture.highlight import OBJECT_AXES
from app.model.projection import Array

_PART_OF_SCENE = 0.6
_BEYOND_TIP = (1.12, 1.3, 1.6)


class ObjectAxes:
    """Three arrows, each along a column and `reach` times as long.

    `reach` is a round number, so that the arrows come out of the object. `shafts` and `colours` are
    mappings by `OBJECT_AXES`' names.
    """

    def __init__(self, canvas: Canvas, size: float) -> None:
        style = canvas.style
        self.reach = axes_reach(size)
        self._space = Space()
        self._local_from_object = np.eye(4)
        self.shafts: dict[str, vtkActor] = {}
        self._actors: list[vtkActor] = []
        colours = style.u, style.v, style.n
        self.colours = dict(zip(OBJECT_AXES, colours, strict=False))
        for tip, (name, colour) in zip(self.reach * np.eye(3), self.colours.items(), strict=True):
            shaft, head = arrow(tip, colour, 1.5 * style.line_width)
            self.shafts[name] = shaft
            for actor in (shaft, head):
                self._space.add(actor)
                put_in_front(actor)  # most of it is inside the object
                self._actors.append(actor)
        canvas.add(*self._actors)

    def show(self, local_from_object: Array, shown: bool) -> None:
        self._local_from_object = local_from_object
        self._space.set(local_from_object)
        for actor in self._actors:
            actor.SetVisibility(shown)

    @property
    def origin(self) -> Array:
        """The object's origin, scene-local, (3,)."""
        origin: Array = self._local_from_object[:3, 3]
        return origin

    @property
    def ways(self) -> Array:
        """The vectors from the origin to the tips, (3, 3), one axis a row."""
        ways: Array = self.reach * self._local_from_object[:3, :3].T
        return ways

    @property
    def names(self) -> Array:
        """Where the axes' letters can be, (k, 3, 3), best first."""
        return np.stack([self.origin + k * self.ways for k in _BEYOND_TIP])


def axes_reach(size: float) -> float:
    """Return the largest of 1, 2, 5, 10, ... below a part of a scene's size."""
    most = _PART_OF_SCENE * size
    unit = 10.0 ** math.floor(math.log10(most))
    return next(k * unit for k in (5.0, 2.0, 1.0) if k * unit <= most * (1.0 + 1e-12))
