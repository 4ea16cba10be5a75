"""What the world pane shows and measures: the model's camera in the scene, and what is left out.

Everything is scene-local, ``world - scene.origin`` subtracted in float64.
"""

import math
from collections.abc import Mapping
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from app.drawings.layer import PaneState, Placing
from app.drawings.own_view import OwnView
from app.drawings.pane_view import Spot
from app.drawings.prop_group import PropGroup
from app.lecture.highlight import AXES, ENDS, SIDES, WINDOW, Highlight
from app.model.projection import Array, Camera, Chain, Projection
from app.picking.sight import Sight
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.marks import Length
from app.scenes.scene import Scene

_SAME = 1e-9  # of a window's side: an axis this near to its middle halves it


class Half(NamedTuple):
    """Half a window, from the axis to its top or its right."""

    angle_deg: float | None  # at the eye; None without an eye, or off the axis
    has_eye: bool = True


def half_of(projection: Projection, axis: int) -> Half | None:
    """Return the right (axis 0) or upper (axis 1) half of a window; None for a typed matrix."""
    lens = projection.lens
    if lens.planes is None:
        return None
    if not lens.central:
        return Half(None, has_eye=False)
    angles = lens.angles(Fraction(*projection.image_size)) if lens.symmetric else None
    if angles is not None:
        return Half(angles[axis] / 2.0)
    low, high = projection.window[2 * axis : 2 * axis + 2]
    is_halved = abs(low + high) <= _SAME * (high - low)
    return Half(math.degrees(math.atan(high / lens.near)) if is_halved else None)


def distances(state: PaneState, view: str) -> list[tuple[str, float]]:
    """The named distances along the axis that a flat view measures, short ones first."""
    projection, measured = state.projection, dict[str, float]()
    if view not in ("side", "top"):
        return []
    if projection.has_camera:
        shown = () if state.illustration is None else state.illustration.measured
        measured = {"d": projection.camera.distance, **dict(shown)}
        half = half_of(projection, 1 if view == "side" else 0)
        is_asked = state.names.wants("e") and state.names.wanted is not None
        if is_asked and half is not None and half.angle_deg is not None:
            measured["e"] = 1.0 / math.tan(math.radians(half.angle_deg))
    named = [each for each in measured.items() if each[0] in state.names]
    return sorted(named, key=lambda each: abs(each[1]))


def lengths(state: PaneState, view: str) -> list[Length]:
    """The lengths across the axis in the present view, named or not."""
    shown = () if state.illustration is None else state.illustration.lengths
    return [length for length in shown if length.view == view]


def has_interval(state: PaneState, view: str) -> bool:
    is_there = view == "axis" and state.projection.lens.planes is not None
    return is_there and state.names.wants("interval") and state.names.wanted is not None


def written(state: PaneState, view: str) -> frozenset[str]:
    """The names that lengths write, and nobody else has to."""
    if has_interval(state, view):
        return frozenset("lr")
    across = {length.name for length in lengths(state, view) if length.name in state.names}
    return frozenset(across | {name for name, _ in distances(state, view)})


_FARTHEST_MARK = 1e3  # of the extent: where lines toward infinity end
WIDEST = 1e35  # larger than any scene, and a float32


class CameraPose(NamedTuple):
    """How the model's camera stands in a scene; world units."""

    camera: Camera
    eye: Array
    target: Array
    view_from_local: Array
    local_from_view: Array
    depths: tuple[float, float]  # least and largest distance of anything from the eye plane
    objects_depth: float  # the largest one of the scene's objects
    extent: float  # the scene's size plus its distance


class DrawnDepths(NamedTuple):
    """The distances from the eye plane that are drawn to scale; world units."""

    low: float  # the limits; low is negative, behind the eye, for a parallel lens
    high: float
    near: float  # where the planes are drawn, low <= near < far <= high
    far: float
    near_break: tuple[float, float] | None  # where edges are broken, if a plane is not at its own
    far_break: tuple[float, float] | None  # distance
    body: tuple[float, float]  # between which the edges are whole


class DrawnVolume(NamedTuple):
    """The frustum as drawn.

    Its corners are (8, 3), near first; it has depths unless the matrix is a typed one, which may
    have no frustum at all.
    """

    corners: Array
    depths: DrawnDepths | None
    exists: bool


class WorldState(PaneState):
    """What the layers of the world pane share.

    `local_from_object` is another array when the objects are placed elsewhere, and `standing`
    another pose when the camera or the objects move. `hidden` are the layers that the user hides;
    `step` is the step of the frame's construction, and `light` how bright the frustum is meanwhile.
    """

    pane = "world"

    def __init__(self, canvas: PropGroup, scene: Scene, words: Mapping[str, str]) -> None:
        super().__init__(canvas, scene, words)
        self.hidden: frozenset[str] = frozenset()
        self.step: int | None = None
        self.light = 1.0
        self._place(scene.start.placement)
        self.standing = self._stand(scene.start.camera)
        self.volume = DrawnVolume(np.tile(self.standing.eye, (8, 1)), None, exists=False)
        self.own = OwnView(canvas, self.origin)

    def take(self, projection: Projection, illustration: Illustration | None) -> None:
        """Show another value of the model."""
        self.projection, self.illustration = projection, illustration
        is_placed = projection.placement != self._placement
        if is_placed:
            self._place(projection.placement)
        if is_placed or projection.camera is not self.standing.camera:
            self.standing = self._stand(projection.camera)

    def _place(self, placement: Chain) -> None:
        scene, origin = self.scene, self.origin
        self._placement = placement
        self.local_from_object = placement.local_from(scene.origin, scene.origin)
        self.objects: Array = placement.placed(scene.objects_box).world - origin
        self.everything = np.concatenate([self.objects, scene.reach(placement) - origin])

    def _stand(self, camera: Camera) -> CameraPose:
        """What depends on the camera alone, and not on its lens."""
        eye, target = (np.array(point) - self.origin for point in (camera.eye, camera.target))
        depths = (eye - self.everything) @ camera.frame[2]
        return CameraPose(
            camera,
            eye,
            target,
            *view_matrices(camera, self.origin),
            (float(depths.min()), float(depths.max())),
            float(((eye - self.objects) @ camera.frame[2]).max()),
            self.scene.size + math.dist(camera.eye, self.scene.centre),
        )

    # -- what is seen and named

    def seen(self, points: Array) -> list[Spot]:
        return self.own.pane.seen(points)

    def spots(self, points: Array) -> Array:
        return self.own.pane.spots(points)

    def placing(self) -> Placing:
        limit = min(_FARTHEST_MARK * self.standing.extent, WIDEST)
        return Placing(np.ones(3), -self.origin, limit)

    def copies_from_local(self, times: float) -> Array:
        return self.own.pane.lifted(times)

    @property
    def sight(self) -> Sight:
        return self.own.pane.sight(self.origin, self.own.depths[0])

    @property
    def places_labels(self) -> bool:
        return "labels" not in self.canvas.hidden and bool(self.canvas.labels_light)

    @property
    def written(self) -> frozenset[str]:  # type: ignore[override]
        return written(self, self.own.fixed)

    @property
    def planes_drawn(self) -> tuple[float, float]:
        """Distances from the eye plane at which near and far are drawn; (0, 1) without planes."""
        depths = self.volume.depths
        return (0.0, 1.0) if depths is None else (depths.near, depths.far)

    @property
    def corners_seen(self) -> Array | None:
        """The corners of the frustum, (8, 3); None without a frustum or its layer."""
        is_seen = self.volume.exists and "frustum" not in self.canvas.hidden
        return self.volume.corners if is_seen else None

    def framed(self, points: Array) -> Array:
        away = np.linalg.norm(points - self.standing.eye, axis=1)
        return np.asarray(points[away <= _FARTHEST_MARK * self.standing.extent])

    def renames(self, changed: Highlight, of_scene: bool) -> bool:
        drawn = {"eye", "target", *ENDS, "fov", *SIDES}
        if self.step is None:
            drawn |= set(AXES)
        wanted = drawn if self.names.wanted is None else self.names.wanted
        return of_scene or bool(changed & drawn - wanted)

    @property
    def left_out(self) -> frozenset[str]:
        """The layers that the scene leaves out now: nothing of what is named."""
        names, left_out = self.names, self.scene.leaves_out
        if not left_out or names.wanted is None or self.step is not None:
            return frozenset()
        if any(name in names for name in ENDS):
            left_out -= {"frustum", "near-picture"}
        else:
            left_out -= {"subject"}
        if any(name in names for name in ("eye", "target", *AXES)):
            left_out -= {"camera"}
        return left_out

    @property
    def hidden_now(self) -> frozenset[str]:
        """The layers that are not drawn.

        The pane looks through the camera, or it stands in front of the picture. From the eye the
        flattened picture covers the scene, and its hidden edges would show through.
        """
        hidden = self.hidden | self.left_out
        if self.own.sees_from_eye:
            return hidden | {"camera", "near-picture"}
        return hidden | {"camera"} if self.own.fixed == "axis" else hidden

    @property
    def unseen(self) -> frozenset[str]:
        """The things without names and handles, because they are not drawn."""
        unseen = {"object"} if self.ghosts else set[str]()
        if "frustum" in self.hidden or self.step is not None:
            # They would cover the arrows of the construction.
            unseen |= {*ENDS, "corner", *SIDES, *WINDOW}
        if "camera" in self.hidden:
            unseen |= {"eye", "target"}
        elif "camera" in self.canvas.hidden:  # the pane looks through it, or from right behind it
            unseen |= {"eye"}
        return frozenset(unseen)

    def named_points(self, *points: str) -> set[str]:
        """Those of these things that have a name in the picture."""
        return {name for name in set(points) - self.unseen if name in self.names}


def view_matrices(camera: Camera, origin: Array) -> tuple[Array, Array]:
    """View from scene-local coordinates and back, both (4, 4); the eye is subtracted first."""
    eye = np.array(camera.eye) - origin
    view_from_local, local_from_view = np.identity(4), np.identity(4)
    view_from_local[:3, :3], view_from_local[:3, 3] = camera.frame, camera.frame @ -eye
    local_from_view[:3, :3], local_from_view[:3, 3] = camera.frame.T, eye
    return view_from_local, local_from_view
