"""A pane is a list of layers, each of which shows one idea; `Layers` runs them.

How a change reaches the screen::

    PaneState             what the pane shows: projection, names, its own camera
        |
    layer.show()          each layer sets its matrices
    layer.settle()        sizes and places that depend on the pane's own camera
    layer.want(), ink()   wishes for names, and what they should not hide; one placing
        |
    one repaint by the caller
"""

import math
from abc import abstractmethod
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import cache
from operator import attrgetter, is_not
from typing import Any, ClassVar, NamedTuple
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from app.document.naming import named_in
from app.drawings.actors import Detail, SceneActors
from app.drawings.label import HALO_EM
from app.drawings.label_placement import Ground, room
from app.drawings.labels import Board
from app.drawings.moved_vertices import MovedVertices
from app.drawings.pane_view import Spot
from app.drawings.pointing import Emphasis, Names
from app.drawings.prop_group import PropGroup
from app.drawings.rasterising import textured
from app.drawings.style import TITLE_EM
from app.lecture.highlight import Highlight
from app.model.projection import Array, Chain, Projection
from app.picking.picking import Probe
from app.picking.sight import Sight
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.marks import Grip
from app.scenes.scene import Scene

_MOST_FACES = _MOST_POINTS = 10_000  # of larger meshes, vertices are sampled
_MOST_STEPS = 256  # across one triangle; larger ones are sampled more coarsely
_MOST_PLACES = 200_000  # in all; more would overlap


class Silhouette:
    """The area of a pane that objects cover, and labels leave free.

    `triangles` (n, 3, 3), or points (n, 1, 3) where they are too many or none, are in the
    coordinates of the scene's actors.
    """

    def __init__(self, scene: Scene) -> None:
        surface, self.triangles = scene.surface, np.empty((0, 3, 3))
        if surface is not None and surface.n_cells <= _MOST_FACES:
            mesh = surface.triangulate()
            self.triangles = np.asarray(mesh.points, dtype=np.float64)[mesh.regular_faces]
        else:
            points = scene.own_points
            points = points[:: max(1, -(-len(points) // _MOST_POINTS))]
            self.triangles = points.astype(np.float64)[:, None]

    def ink_under(self, ground: Ground, rows: Array, volume: Array | None = None) -> None:
        """`ink` under rows that give x w, y w and w in pixels, (3, 4)."""
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            x, y, w = np.moveaxis(self.triangles @ rows[:, :3].T + rows[:, 3], -1, 0)
            spots = np.stack([x, y], axis=-1) / np.where(w > 0.0, w, np.nan)[..., None]
        self.ink(ground, spots, volume)

    def ink(self, ground: Ground, spots: Array, volume: Array | None = None) -> None:
        """Tell the ground where the triangles are: pixels, (n, 3 or 1, 2); NaN behind.

        With the corners of a `volume`, (m, 2), only what its outline holds: the rest was cut away.
        """
        held = self._held(ground, spots)
        if volume is not None and np.isfinite(volume).all():
            between = volume - volume[:, None]
            across = np.stack([-between[..., 1], between[..., 0]], axis=-1)
            least = (across * volume[:, None]).sum(axis=-1)
            is_side = between.any(axis=-1) & (across @ volume.T >= least[..., None] - 1e-6).all(
                axis=-1
            )
            middles = (np.indices(ground.shape) + 0.5) * ground.square
            sides, first = across[is_side], least[is_side]
            held &= (np.tensordot(sides, middles, 1) >= first[:, None, None]).all(axis=0)
        ground.ink(held)

    def _held(self, ground: Ground, spots: Array) -> NDArray[np.bool_]:
        """The squares, (columns, rows), of triangles or points."""
        spots = spots if spots.shape[1] == 3 else np.repeat(spots, 3, axis=1)
        columns, rows = (side + 2 for side in ground.shape)  # with a rim that takes what is outside
        limit = np.array([[columns - 1.0], [rows - 1.0]])
        held = np.zeros(columns * rows, dtype=np.bool_)
        corners = np.ascontiguousarray(np.transpose(spots, (1, 2, 0))) / ground.square + 1.0
        low, high = corners.min(axis=0), corners.max(axis=0)
        with np.errstate(invalid="ignore"):
            sides = (high - low).max(axis=0)
        seen = np.isfinite(sides) & (high >= 1.0).all(axis=0) & (low <= limit).all(axis=0)
        if seen.any():
            corners, sides = corners[:, :, seen], sides[seen]
            steps = 2 ** np.ceil(np.log2(np.clip(sides, 1.0, _MOST_STEPS))).astype(np.int64)
            places = int(((steps + 1) * (steps + 2) // 2).sum())
            coarser = math.ceil(math.log(max(places / _MOST_PLACES, 1.0), 4.0))
            steps = np.maximum(steps >> coarser, 1)
            for count in sorted(set(steps.tolist())):
                spread = _lattice(count) @ np.moveaxis(corners[:, :, steps == count], 1, 0)
                x, y = np.clip(spread, 0.0, limit[:, None]).astype(np.int64)
                held[x * rows + y] = True
        return held.reshape(columns, rows)[1:-1, 1:-1]


@cache
def _lattice(count: int) -> Array:
    """Weights of a triangle's corners at evenly spread places, (m, 3)."""
    one, two = np.meshgrid(np.arange(count + 1), np.arange(count + 1))
    kept = one + two <= count
    weights: Array = np.stack([one[kept], two[kept], count - one[kept] - two[kept]], axis=1) / count
    return weights


NO_POINTS = np.empty((0, 3))
_silhouettes: WeakKeyDictionary[Scene, Silhouette] = WeakKeyDictionary()  # shared by all drawings


def together(named: Iterable[tuple[str, Array]]) -> dict[str, Array]:
    """Join the points, (n, 2) or (n, 3), of each name; a name without points is left out."""
    parts: dict[str, list[Array]] = {}
    for name, points in named:
        if len(points):
            parts.setdefault(name, []).append(points)
    return {name: np.concatenate(points) for name, points in parts.items()}


class Placing(NamedTuple):
    """From the coordinates of marks to those of the pane's actors: ``scale * point + shift``."""

    scale: Array
    shift: Array
    limit: float  # half the side of the box, about the actors' origin, that marks are cut to

    def placed(self, points: Array) -> Array:
        """Convert points (n, 3), or (n, 2) in a plane, to (n, 3)."""
        if points.shape[1] == 2:
            points = np.column_stack([points, np.zeros(len(points))])
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is dropped
            placed: Array = self.scale * points + self.shift
        return placed


class PaneState:
    """What the layers of one pane share: where they draw, and what the pane shows."""

    pane: ClassVar[str]  # one of `app.document.view.PANES`
    objects = NO_POINTS  # corners of the box round the objects, in the coordinates of the actors
    written: frozenset[str] = frozenset()  # the names that lengths write, and no other layer has to

    def __init__(
        self, canvas: PropGroup, scene: Scene, words: Mapping[str, str], renderer: Any = None
    ) -> None:
        self.canvas, self.scene, self.words, self.renderer = canvas, scene, words, renderer
        self.style, self.em = canvas.style, canvas.style.font_size
        self.origin = np.array(scene.origin, dtype=np.float64)
        self.names = Names(named_in(self.pane, scene))
        self.board = Board(canvas, renderer)
        self.emphasis = Emphasis(canvas)
        kept = _silhouettes.get(scene)
        self.silhouette = _silhouettes[scene] = kept or Silhouette(scene)
        self.projection = scene.start
        self.illustration: Illustration | None = None
        self.probes: Sequence[Probe] = ()
        self.ghosts: Sequence[Chain] = ()  # the moves of pale objects beside the object on its way
        self.from_left = False  # whether moves are done from the left

    @property
    def marked(self) -> Illustration | None:
        """The illustration, if its marks are shown."""
        return self.illustration

    @property
    def grips(self) -> dict[str, Grip]:
        """The scene's settings that can be dragged in this pane, by name."""
        if self.marked is None:
            return {}
        drawn = {dot.name for dot in getattr(self.marked, self.pane).dots}
        grips = [g for g in self.marked.grips if self.pane == "world" or g.name in drawn]
        return {grip.setting: grip for grip in grips}

    @property
    def corner_px(self) -> tuple[int, int]:
        """Where the renderer begins in the pane, from its top left."""
        return 0, 0

    @property
    def seen_projection(self) -> Projection:
        """The projection with OpenGL's depth range; the pane differs in depth only."""
        return self.projection.with_depth("opengl")

    @property
    def size_px(self) -> tuple[int, int]:
        width_px, height_px = self.canvas.window.GetSize()
        return max(1, width_px), max(1, height_px)

    @property
    def room(self) -> tuple[float, float, float, float]:
        """Where labels may be: left, low, right, high."""
        width_px, height_px = self.size_px
        return room(width_px, height_px - TITLE_EM * self.em, self.em)

    @property
    def places_labels(self) -> bool:
        return bool(self.canvas.labels_light)

    def wake(self) -> None:
        """Before a change: no labels rest, and no place for another size of the window stays."""
        self.board.rests = False
        if not self.canvas.is_laid_out:
            self.canvas.relayout()

    @property
    @abstractmethod
    def sight(self) -> Sight:
        """How the pane looks at the world now, for picking."""

    def renames(self, changed: Highlight, of_scene: bool) -> bool:
        """Whether other things are named while these are pointed at; `of_scene`, also of marks."""
        return bool(changed) and self.names.wanted is not None

    @abstractmethod
    def spots(self, points: Array) -> Array:
        """Where points of the pane's actors, (n, 3), are in it: pixels, (n, 2), NaN behind."""

    def seen(self, points: Array) -> list[Spot]:
        """The spots with their depths, which are 1 in a flat picture."""
        return [(x, y, 1.0) for x, y in self.spots(points).tolist()]

    def framed(self, points: Array) -> Array:
        """The points, (n, 3), that are not too far away to be framed."""
        return points

    @abstractmethod
    def placing(self) -> Placing:
        """From the coordinates of this pane's marks to those of its actors."""

    @abstractmethod
    def copies_from_local(self, times: float) -> Array:
        """The scene's own matrix in this pane, with lines so many times as far forward."""


class Layer:
    """One idea in a pane. A method without an override has nothing to do, and is not called.

    `needs` names the field of the state without which it has nothing to show: no method is called
    before that has a value for the first time. `follows` names the fields on which `show` depends:
    it is called when one of them is another object; without names, at every change.
    """

    needs: ClassVar[str] = ""
    follows: tuple[str, ...] = ()

    def show(self) -> None:
        """Set the matrices of what the state shows."""

    def show_names(self) -> None:
        """Show what is named, and the rest quietly."""

    def show_detail(self, fewer: Scene | None) -> None:
        """Use the faces of a scene with fewer triangles; None for all."""

    def show_highlight(self, highlighted: Highlight) -> bool:
        """Highlight what `Emphasis` does not know; return whether anything has changed."""
        return False

    def settle(self) -> None:
        """Follow the pane's own camera, its size, and the depths that it sees."""

    def want(self, ground: Ground) -> None:
        """Ask for the places of names, and keep labels off points."""

    def ink(self, ground: Ground) -> None:
        """Count as ink what is drawn."""

    def reach(self) -> Array:
        """The points that the pane's own camera has to reach, (n, 3)."""
        return NO_POINTS

    def inside(self) -> Mapping[str, Array]:
        """What has to be inside the pane, by its names: points (n, 3)."""
        return {}


class Layers:
    """Runs the layers of a pane in the order in which their names are placed."""

    def __init__(self, state: PaneState, *layers: Layer) -> None:
        self._state, self._layers = state, layers
        self._waiting = {layer: attrgetter(layer.needs) for layer in layers if layer.needs}
        self._kept: dict[str, list[Layer]] = {}
        self._followed: dict[Layer, list[object]] = {}  # what layers follow, as it was last
        self._asked: list[bool | None] | None = None
        """While all changes are awaited: whether labels are placed afresh, or None to `settle`."""

    @contextmanager
    def placing_once(self) -> Iterator[None]:
        """Settle once, and place the labels once, after several changes."""
        self._asked = asked = list[bool | None]()
        try:
            yield
        finally:
            self._asked = None
            if None in asked:
                self.settle()
            if any(each is not None for each in asked):
                self.place_labels(afresh=any(asked))

    def _those(self, verb: str) -> list[Layer]:
        """The layers that have something to do in a method of `Layer`; kept until one joins."""
        for layer in [each for each, value in self._waiting.items() if value(self._state)]:
            del self._waiting[layer]
            self._kept.clear()
        if verb not in self._kept:
            layers = (layer for layer in self._layers if layer not in self._waiting)
            idle = getattr(Layer, verb)
            self._kept[verb] = [each for each in layers if getattr(type(each), verb) is not idle]
        return self._kept[verb]

    def _changing(self, verb: str) -> list[Layer]:
        """`_those`, before they change."""
        self._state.wake()
        return self._those(verb)

    def show(self) -> None:
        self._state.board.rests = False
        for layer in [each for each in self._those("show") if self._has_changed(each)]:
            layer.show()

    def _has_changed(self, layer: Layer) -> bool:
        """Whether anything that a layer follows has changed since it was asked last."""
        before = self._followed.get(layer)
        self._followed[layer] = now = [getattr(self._state, name) for name in layer.follows]
        return not now or before is None or any(map(is_not, now, before))

    def show_names(self) -> None:
        for layer in self._changing("show_names"):
            layer.show_names()
        self._state.emphasis.show_names(self._state.names)

    def show_detail(self, fewer: Scene | None) -> None:
        for layer in self._changing("show_detail"):
            layer.show_detail(fewer)

    def show_highlight(self, highlighted: Highlight) -> bool:
        changes = [layer.show_highlight(highlighted) for layer in self._changing("show_highlight")]
        return any(changes)

    def settle(self) -> None:
        """Follow the pane's own camera, its size, and the depths that it sees."""
        if self._asked is not None:
            self._asked.append(None)
            return
        for layer in self._those("settle"):
            layer.settle()

    def place_labels(self, *, afresh: bool = False, at_rest: bool = False) -> bool:
        """Place the labels, unless a layout will; return whether one has changed its place."""
        state = self._state
        if at_rest and state.board.rests:
            return False
        if self._asked is not None:
            self._asked.append(afresh or at_rest)
            return False
        if not (state.canvas.is_laid_out and state.places_labels):
            state.wake()
            return False
        ground = self.ground()
        for layer in self._those("want"):
            layer.want(ground)
        return state.board.settle(ground, afresh=afresh, at_rest=at_rest)

    def ground(self) -> Ground:
        """Where there is ink now."""
        state = self._state
        halo = HALO_EM * state.em if state.canvas.style.on_paper else 0.0
        return Ground(state.room, state.em, self._ink, halo)

    def _ink(self, ground: Ground) -> None:
        for layer in self._those("ink"):
            layer.ink(ground)

    def reach(self) -> Array:
        return np.concatenate([layer.reach() for layer in self._those("reach")])

    def inside(self) -> dict[str, Array]:
        return together(pair for layer in self._those("inside") for pair in layer.inside().items())


class FacesLayer(Layer):
    """The scene once in a pane, with what a phenomenon changes about its faces.

    `shows` says which vertices the pane shows: ``"stored"`` or ``"projected"``.
    """

    def __init__(self, state: PaneState, drawn: SceneActors, shows: str) -> None:
        self._state, self.actors = state, drawn
        self._changes = bool(state.scene.requires)  # otherwise nothing about its faces ever changes
        if self._changes:
            self.follows = ()
        self._detail = Detail(drawn.surface, drawn.dots)
        faces = drawn.surface, drawn.spaces[0]
        self._rasterisers = textured(state.scene, state.canvas, faces)
        self._moved = MovedVertices(state.scene, shows, drawn.surface)

    def show(self) -> None:
        illustration = self._state.illustration
        if illustration is not None and illustration.rendering is not None:
            for rasteriser in self._rasterisers:
                rasteriser.show(illustration.rendering, self._state.projection)
        self._moved.show(None if illustration is None else illustration.vertices)

    def show_detail(self, fewer: Scene | None) -> None:
        self._detail.show(fewer)
