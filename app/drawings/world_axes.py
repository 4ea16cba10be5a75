"""The frames of the object and of the world in the world pane: their axes, letters and origins.

An object that is moved shows its axes; a picture that names a frame shows that frame. The letters
x, y and z stand at one of the two.
"""

from __future__ import annotations

from itertools import compress

import numpy as np

from app.document.naming import FRAMES
from app.drawings.actors import PropGroup, SceneActors
from app.drawings.frame import ObjectAxes
from app.drawings.labels import Labels
from app.drawings.names import Names
from app.drawings.pointing import Emphasis
from app.model.projection import Array
from app.scenes.scene import Scene


class WorldAxes:
    """The axes of object and world, made when they are first shown; scene-local.

    Parameters
    ----------
    drawn : SceneActors
        The object, which shows its axes while it is moved.
    """

    def __init__(
        self,
        canvas: PropGroup,
        scene: Scene,
        drawn: SceneActors,
        names: Names,
        emphasis: Emphasis,
        labels: Labels,
    ) -> None:
        self._canvas, self._scene, self._drawn, self._names = canvas, scene, drawn, names
        self._emphasis, self._labels = emphasis, labels
        self._object: ObjectAxes | None = None
        self._world: ObjectAxes | None = None
        self.is_wanted = False
        """Whether the object shows its axes although it is not moved."""

    def show(self, local_from_object: Array) -> None:
        """Show the axes that are wanted where they belong, and hide the others."""
        if self._object is None and self.has_object:
            self._object = self._make()
        if self._object is not None:
            is_shown = self.has_object and self._frames != {"frame-w"}
            self._object.show(local_from_object, is_shown)
        if self._world is None and "frame-w" in self._frames:
            self._world = self._make()
        if self._world is not None:
            local_from_world = np.eye(4)
            local_from_world[:3, 3] = -np.array(self._scene.origin, dtype=np.float64)
            self._world.show(local_from_world, "frame-w" in self._frames)

    def _make(self) -> ObjectAxes:
        axes = ObjectAxes(self._canvas, self._scene.size)
        for name, shaft in axes.shafts.items():
            self._emphasis.line(shaft, name, of=(name, name[-1], *FRAMES))
            self._emphasis.label(self._labels.add_arrow(name, axes.colours[name]), name)
        self._emphasis.show(self._names.pointed)
        return axes

    @property
    def has_object(self) -> bool:
        return self._drawn.is_moved or self.is_wanted or "frame-o" in self._frames

    @property
    def of_object(self) -> ObjectAxes | None:
        return self._object if self.has_object else None

    @property
    def _frames(self) -> frozenset[str]:
        """The frames that are named, of `FRAMES`."""
        return (self._names.wanted or frozenset()) & FRAMES.keys()

    @property
    def _lettered(self) -> ObjectAxes | None:
        """The axes that x, y and z name: the world's if its frame is named, else the object's."""
        return self._world if "frame-w" in self._frames else self.of_object

    def origins(self, eye: Array) -> dict[str, Array]:
        """Where the letters of the named frames stand; axes with letters have none of their own."""
        origins = {"frame-e": eye}
        for name, axes in (("frame-o", self._object), ("frame-w", self._world)):
            if axes is not None and not (axes is self._lettered and "x" in self._names):
                origins[name] = axes.origin
        return {name: origins[name] for name in FRAMES if name in self._frames & origins.keys()}

    @property
    def named(self) -> tuple[tuple[str, ...], Array]:
        """The axes that are named, and where each starts and ends, (n, 2, 3)."""
        axes, names = self._lettered, self._names
        if axes is None:
            return (), np.empty((0, 2, 3))
        is_named = [name in names or name.removeprefix("object_") in names for name in axes.shafts]
        start = np.tile(axes.origin, (3, 1))
        ends = np.stack([start, axes.ends], axis=1)
        return tuple(compress(axes.shafts, is_named)), ends[is_named]

    @property
    def framed(self) -> list[Array]:
        """The points of the named frames and axes, (n, 3) each."""
        wanted = self._names.wanted or frozenset()
        whole = [
            np.vstack([axes.origin, axes.ends])
            for axes, is_named in (
                (self._object, "frame-o" in wanted),
                (self._world, "frame-w" in wanted),
                (self._lettered, not wanted.isdisjoint("xyz")),
            )
            if axes is not None and is_named
        ]
        return [*whole, self.named[1].reshape(-1, 3)]
