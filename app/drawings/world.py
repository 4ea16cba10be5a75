"""The world pane: the scene, the camera in it, and the camera's frustum.

Its layers are `SceneInWorld`, `CameraDrawing`, `WorldAxes`, `FrustumDrawing`, `NearPicture`,
`Dimensions`, `MarksDrawing`, `EyeWalk`, `WorldProbes` and `WorldHandles`; `own_view` is the camera
from which the pane looks. No part computes a projection: the frustum is the NDC cube's own edges
and faces under ``world_from_clip``, and a slider step sets matrices alone.
"""

import itertools
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings.actors import SceneActors, lift_lines, line_actor, make_pale
from app.drawings.camera import CameraDrawing
from app.drawings.dimensions import Dimensions
from app.drawings.drawing import Drawing, light_of_labels
from app.drawings.frame import DIMMED
from app.drawings.frustum import FrustumDrawing
from app.drawings.handles import WorldHandles
from app.drawings.label_placement import Ground
from app.drawings.layer import NO_POINTS, FacesLayer, Layer, Layers
from app.drawings.marks import MarksDrawing
from app.drawings.near_picture import NearPicture
from app.drawings.own_view import Framed, OwnView
from app.drawings.probes import WorldProbes
from app.drawings.prop_group import PropGroup
from app.drawings.style import Style
from app.drawings.world_axes import WorldAxes
from app.drawings.world_state import WorldState
from app.lecture.highlight import AXES, ENDS, WINDOW
from app.model.projection import Array, Camera, Chain, Projection, Vector
from app.picking.handles import Handle
from app.scenes.phenomena.illustration import Illustration, Shot
from app.scenes.poly_mesh import vtk_points
from app.scenes.scene import Scene

_WIDEST = 2.5  # extents: of a wider frustum, no more is framed
_AXES_SHOT = Shot(-55.0, 25.0, "camera")  # no axis is seen end on
_WINDOW_SHOT = Shot(-25.0, 20.0, "camera")  # the near plane is seen broadside
_ROUNDING_PX = 0.5


class SceneInWorld(FacesLayer):
    """The scene itself, whose dots and lines are lifted before its faces."""

    _state: WorldState
    follows = "local_from_object", "ghosts"

    def __init__(self, state: WorldState) -> None:
        drawn = SceneActors(state.scene, state.style)
        state.canvas.add(*drawn)
        if state.pane in state.scene.pale:
            make_pale(drawn, state.style)
        super().__init__(state, drawn, "stored")
        self._faces_space, *self._line_spaces, self._ground_space = drawn.spaces
        self._ghosts: list[SceneActors] = []
        self._beside: list[Array] = []  # corners of the ghosts' boxes
        self._part: tuple[Vector, Vector] | None = None  # of the ground, local; None for all of it

    def show(self) -> None:
        state = self._state
        self.actors.show_moved(not state.projection.placement.is_identity)
        self._faces_space.set(state.local_from_object)
        self.lift_lines()
        if state.ghosts or self._beside:
            self._show_ghosts(state.ghosts)
        super().show()

    def _show_ghosts(self, chains: Sequence[Chain]) -> None:
        state = self._state
        while len(self._ghosts) < len(chains):
            ghost = SceneActors(state.scene.apart[0], state.style)
            make_pale(ghost, state.style)
            for actor in ghost:
                lift_lines(actor, -1)  # behind the object's own faces
            state.canvas.add(*ghost)
            self._ghosts.append(ghost)
        corners = state.scene.objects_box
        self._beside = [chain.placed(corners).world - state.origin for chain in chains]
        for ghost, chain in itertools.zip_longest(self._ghosts, chains):
            for actor, space in ghost.placed:
                actor.SetVisibility(chain is not None)
                if chain is not None:
                    space.set(chain.local_from(state.scene.origin, state.scene.origin))

    def lift_lines(self) -> None:
        """Lift dots and lines towards the pane's own camera."""
        lifted = self._state.own.pane.lifted(1.0)
        for space in self._line_spaces:
            space.set(lifted @ self._state.local_from_object)
        self._ground_space.set(lifted)

    def end_ground(self) -> None:
        """End the ground on paper at its lines, not the pane's border, if half of it is left."""
        state, ground = self._state, self._state.scene.apart[1].lines
        if not state.style.on_paper or ground is None:
            return
        ends = np.asarray(ground.points, dtype=np.float64)
        x, z = np.unique(ends[:, 0]), np.unique(ends[:, 2])
        spots = state.own.pane.spots(np.stack(np.broadcast_arrays(x[:, None], ends[0, 1], z), -1))
        seen: Any = ((spots >= 0.0) & (spots <= state.size_px)).all(axis=-1)
        feet = np.clip(state.objects, ends.min(axis=0), ends.max(axis=0))
        (left, _, far), (right, _, near) = feet.min(axis=0), feet.max(axis=0)
        most, part = seen.sum() / 2.0, None
        for i, j in itertools.product(np.flatnonzero(x <= left), np.flatnonzero(x >= right)):
            both = np.flatnonzero(seen[i] & seen[j])
            cells = (j - i) * np.ptp(both) if len(both) else 0
            if cells > most and z[both[0]] <= far and z[both[-1]] >= near:
                most, part = cells, ((x[i], -np.inf, z[both[0]]), (x[j], np.inf, z[both[-1]]))
        if part != self._part:
            self._part = part
            self.actors.show_lines(state.scene if part is None else state.scene.with_ground(*part))

    def ink(self, ground: Ground) -> None:
        placed, triangles = self._state.local_from_object, self._state.silhouette.triangles
        points = triangles.reshape(-1, 3) @ placed[:3, :3].T + placed[:3, 3]
        spots = self._state.own.pane.spots(points.reshape(triangles.shape))
        self._state.silhouette.ink(ground, spots)

    def reach(self) -> Array:
        return np.concatenate([self._state.everything, *self._beside])

    def inside(self) -> dict[str, Array]:
        return {"subject": self._state.objects}


class EyeWalk(Layer):
    """The way of the eye while the model's camera walks round the scene, made at the first walk.

    All walks have as many points.
    """

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


class WorldDrawing(Drawing):
    """The scene with the camera and its frustum in it.

    The own camera of `screen` looks at all this from outside. A `live` drawing has handles.
    """

    pane = "world"
    state: WorldState
    own: OwnView

    def __init__(
        self,
        screen: Any,
        scene: Scene,
        words: Mapping[str, str],
        style: Style,
        *,
        live: bool = False,
    ) -> None:
        self._canvas = PropGroup(screen, style, self._lay_out)
        self.state = state = WorldState(self._canvas, scene, words)
        self.names, self.board, self.own = state.names, state.board, state.own
        self._scene = SceneInWorld(state)
        self.picture = NearPicture(state)
        self.camera = CameraDrawing(state)
        self.frustum = FrustumDrawing(state)
        self.axes = WorldAxes(state, self._scene.actors)
        self._lengths, self._marks = Dimensions(state), MarksDrawing(state)
        self._walk = EyeWalk(state)
        layers: list[Layer] = [
            WorldProbes(state), self._scene, self.camera, self.axes, self.frustum,
            self.picture, self._lengths, self._marks, self._walk,
        ]  # fmt: skip
        if live:
            self.handles = WorldHandles(state, self.axes, self.camera)
            layers.append(self.handles)
        self.layers = Layers(state, *layers)
        self._dimmable = [
            (actor.GetProperty(), actor.GetProperty().GetOpacity())
            for actor in (*self.frustum.dimmable, *self.picture.actors, *self.camera.solid)
        ]
        self._goes_to: Framed | None = None  # what is framed where the pane's present way ends
        with self.layers.placing_once():
            self._name()
            self.show_projection(scene.start)
            self.reset_view()

    # -- fixed views and layers

    @property
    def fixed(self) -> str:
        return self.own.fixed

    def show_fixed(self, view: str) -> None:
        if view != self.own.fixed:
            self.own.fixed = view
            self.reset_view()

    def show_object_axes(self, wanted: bool) -> None:
        if wanted != self.axes.is_wanted:
            self.axes.is_wanted = wanted
            self.axes.show_names()
            self._follow_pane(afresh=True)

    def show_walk(self, eyes: Sequence[Vector]) -> None:
        begins = len(eyes) > 0 and not self._walk.inside()
        self._walk.show_walk(eyes)
        if begins and not self.own.was_moved:
            self.own.place(self._framed())
        self.reset_clipping_range()

    def show_layers(self, hidden: frozenset[str]) -> None:
        self.state.hidden = hidden
        self._switch_layers()
        self._follow_pane(afresh=True)
        self.refit()  # what is shown again has to be inside

    def _switch_layers(self) -> None:
        names, hidden = self.names, self.state.hidden_now
        has_arrows = names.wanted is not None and any(axis in names for axis in AXES)
        self._scene.actors.show_grid("grid" not in hidden, pale=has_arrows)
        self.picture.actors.show_grid("grid" not in hidden)
        if hidden != self._canvas.hidden:
            self._canvas.show_layers(hidden)

    # -- pointing and names

    def show_names(self, names: frozenset[str] | None) -> None:
        if names == self.names.wanted:
            return
        self.names.wanted = names
        self._name()
        if self.own.was_moved:
            self._follow_pane(afresh=True)
        else:
            self.reset_view()

    def _name(self) -> None:
        """Draw what is named, and the other things quietly."""
        self._switch_layers()
        self.layers.show_names()

    def _show_named(self) -> None:
        self._name()
        self._follow_pane(afresh=False)

    def show_step(self, step: int | None) -> None:
        state = self.state
        if step == state.step:
            return
        is_other = (step is None) != (state.step is None)
        state.step, state.light = step, 1.0 if step is None else DIMMED
        self.camera.show_step()
        for line, opacity in self._dimmable:
            line.SetOpacity(opacity * state.light)
        for name in ENDS:
            self.board.label(name).set_opacity(state.light)
        if is_other and not (self.own.was_moved or self.own.fixed):  # its arrows are large
            self.own.place(self._framed())
        self.reset_clipping_range()

    # -- the model

    def show_projection(
        self, projection: Projection, illustration: Illustration | None = None
    ) -> None:
        is_first = illustration is not None and self._marks.is_empty
        self.state.take(projection, illustration)
        self.layers.show()
        if is_first and not self.own.was_moved:
            self.reset_view()
        elif self.own.fixed:
            self.own.follow(self._framed())
            self.reset_clipping_range(afresh=False)
        else:
            self._follow_pane(afresh=False)

    def hold(self, handle: Handle | None) -> None:
        is_named = handle is None or handle.name in self.names
        self.names.held = handle
        super().hold(handle)
        if not is_named or handle is None:
            self._name()
            self.layers.place_labels()

    # -- the pane's own camera

    def reset_view(self) -> None:
        self.own.reset(self._framed())
        self.reset_clipping_range()

    def views(
        self, moments: Iterable[tuple[Projection, Illustration | None]], turns_deg: Sequence[float]
    ) -> list[Camera]:
        """Return free views of several moments, one for each turn; see `from_all_sides`."""
        self.show_fixed("")
        framed = []
        for moment in moments:
            self.show_projection(*moment)
            framed.append(self._framed())
        return self.own.from_all_sides(framed, turns_deg)

    def _framed(self) -> Framed:
        state, at, volume = self.state, self.state.standing, self.state.volume
        inside, middle = self._inside(), state.objects.mean(axis=0)
        if self.fit == "frustum" and volume.exists:
            inside["frustum"] = volume.corners
        elif self.fit == "scene":
            inside = {"subject": state.objects}
        offsets = np.concatenate(list(inside.values())) - middle
        lengths = np.maximum(np.linalg.norm(offsets, axis=1, keepdims=True), 1e-100)
        points = middle + offsets * np.minimum(1.0, _WIDEST * at.extent / lengths)
        return Framed(
            at.camera, at.eye, points, self.camera.parts if "eye" in inside else NO_POINTS,
            volume.corners if volume.exists and "frustum" not in state.left_out else points,
            state.projection.lens.central, self._lengths.below_em, self._lengths.below, self._shot,
        )  # fmt: skip

    def _inside(self) -> dict[str, Array]:
        inside = self.layers.inside()
        if "subject" in self.state.left_out and len(inside) > 1:
            del inside["subject"]
        return inside

    @property
    def _shot(self) -> Shot:
        """From where the pane looks at first: the named axes and the window's sides are seen."""
        wanted, scene = self.names.wanted, self.state.scene
        if self.camera.axes_lead or self.state.step is not None:
            return _AXES_SHOT
        if wanted is not None and wanted & WINDOW.keys() and scene.phenomenon is None:
            return _WINDOW_SHOT
        width_px, height_px = self.state.size_px
        return scene.shot if scene.upright is None or width_px >= height_px else scene.upright

    def cut(self) -> dict[str, float]:
        inside, (arrows, ends) = self._inside(), self.camera.named_arrows
        if "eye" in inside:
            inside["eye"] = np.vstack([inside["eye"], self.camera.box])
            inside |= dict(zip(arrows, ends, strict=True))
        if self.own.sees_from_eye:  # the picture cuts it as the lens does
            inside.pop("subject", None)
        outside = {name: self.own.pane.outside_px(points) for name, points in inside.items()}
        return {name: px for name, px in outside.items() if px > _ROUNDING_PX}

    def refit(self) -> bool:
        if not self.own.was_moved and self.own.rest(self._framed(), is_cut=bool(self.cut())):
            self.reset_clipping_range()
            return True
        return self.layers.place_labels(at_rest=True)

    def begin_glide(self, start: Any) -> None:
        self._goes_to = self._framed()
        self.own.begin_glide(start)

    def glide(self, part: float) -> None:
        if self.own.fixed:
            self.own.follow(self._framed())
        else:
            self.own.go_to_goal()
        if part < 1.0:
            self.own.glide(part)
        else:
            self.own.is_turned, self._goes_to = False, None
        self._canvas.fade_labels(light_of_labels(part))
        self.reset_clipping_range(afresh=part == 1.0)

    def _lay_out(self, _width_px: int, _height_px: int) -> None:
        """Fit a view that nobody has moved into a window of another size, or round new names."""
        is_held = bool(self.handles.held) and self.own.placed_px == self.own.size_px
        if not (is_held or self.own.was_moved or self.own.is_turned):
            self.own.place(self._goes_to or self._framed())
            self.own.keep_goal()
        self.reset_clipping_range()

    def reset_clipping_range(self, *, afresh: bool = True) -> None:
        self.own.look()
        self._scene.end_ground()
        self._switch_layers()
        self._scene.lift_lines()
        self._follow_pane(afresh=afresh)

    def _follow_pane(self, *, afresh: bool) -> None:
        """Update everything that depends on the model and on the pane's camera."""
        self.camera.follow()  # its body has to be within reach
        self.own.fit_range(self.layers.reach())
        self.layers.settle()
        self.layers.place_labels(afresh=afresh)
