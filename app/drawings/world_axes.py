"""The frames of the object and of the world in the world pane: their axes, letters and origins.

An object that is moved shows its axes; a picture that names a frame shows that frame. The letters
x, y and z stand at one of the two.
"""

from itertools import compress

import numpy as np

from app.document.naming import FRAMES
from app.drawings.actors import SceneActors
from app.drawings.frame import ObjectAxes
from app.drawings.label_placement import Ground
from app.drawings.labels import EYE
from app.drawings.layer import Layer
from app.drawings.world_state import WorldState
from app.model.projection import Array


class WorldAxes(Layer):
    """The axes of object and world, made when they are first shown; scene-local.

    `drawn` is the object, which shows its axes while it is moved.
    """

    follows = ("local_from_object",)

    def __init__(self, state: WorldState, drawn: SceneActors) -> None:
        self._state, self._names, self._drawn = state, state.names, drawn
        self._object: ObjectAxes | None = None
        self._world: ObjectAxes | None = None
        self.is_wanted = False  # whether the object shows its axes although it is not moved

    def show(self) -> None:
        self.show_names()

    def show_names(self) -> None:
        """Show the axes that are wanted where they belong, and hide the others."""
        state = self._state
        if self._object is None and self.has_object:
            self._object = self._make()
        if self._object is not None:
            is_shown = self.has_object and self._frames != {"frame-w"}
            self._object.show(state.local_from_object, is_shown)
        if self._world is None and "frame-w" in self._frames:
            self._world = self._make()
        if self._world is not None:
            local_from_world = np.eye(4)
            local_from_world[:3, 3] = -state.origin
            self._world.show(local_from_world, "frame-w" in self._frames)

    def _make(self) -> ObjectAxes:
        state, emphasis = self._state, self._state.emphasis
        axes = ObjectAxes(state.canvas, state.scene.size)
        for name, shaft in axes.shafts.items():
            emphasis.line(shaft, name, of=(name, name[-1], *FRAMES))
            emphasis.label(state.board.label(name, state.words[name], axes.colours[name]), name)
        emphasis.show(self._names.pointed)
        return axes

    @property
    def has_object(self) -> bool:
        return self._drawn.is_moved or self.is_wanted or "frame-o" in self._frames

    @property
    def of_object(self) -> ObjectAxes | None:
        return self._object if self.has_object else None

    @property
    def _frames(self) -> frozenset[str]:
        return (self._names.wanted or frozenset()) & FRAMES.keys()

    @property
    def _lettered(self) -> ObjectAxes | None:
        """The axes that x, y and z name: the world's if its frame is named, else the object's."""
        return self._world if "frame-w" in self._frames else self.of_object

    def _origins(self) -> dict[str, Array]:
        """Where the letters of the named frames stand; axes with letters have none of their own."""
        origins = {"frame-e": self._state.standing.eye}
        for name, axes in (("frame-o", self._object), ("frame-w", self._world)):
            if axes is not None and not (axes is self._lettered and "x" in self._names):
                origins[name] = axes.origin
        return {name: origins[name] for name in FRAMES if name in self._frames & origins.keys()}

    def want(self, ground: Ground) -> None:
        state, (arrows, ends) = self._state, self._named
        if arrows:
            state.board.want_beyond(arrows, state.seen(ends.reshape(-1, 3)))
        for name, origin in self._origins().items():
            state.board.label(name).set_text(FRAMES[name])
            state.board.want_beside(name, state.seen(origin[None])[0], EYE, (-1.0, -1.0))

    def ink(self, ground: Ground) -> None:
        arrows, ends = self._named
        if arrows:
            ground.ink_arrows(self._state.own.pane.spots(ends))

    @property
    def _named(self) -> tuple[tuple[str, ...], Array]:
        """The axes that are named, and where each starts and ends, (n, 2, 3)."""
        axes, names = self._lettered, self._names
        if axes is None:
            return (), np.empty((0, 2, 3))
        is_named = [name in names or name.removeprefix("object_") in names for name in axes.shafts]
        ends = np.stack([np.tile(axes.origin, (3, 1)), axes.ends], axis=1)
        return tuple(compress(axes.shafts, is_named)), ends[is_named]

    def inside(self) -> dict[str, Array]:
        """The points of the named frames and axes."""
        wanted = self._names.wanted or frozenset()
        whole = {
            name: np.vstack([axes.origin, axes.ends])
            for name, axes in (
                ("frame-o", self._object),
                ("frame-w", self._world),
                *((name, self._lettered) for name in "xyz"),
            )
            if axes is not None and name in wanted
        }
        return whole | dict(zip(*self._named, strict=True))
