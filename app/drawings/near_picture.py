"""The picture on the near plane: the scene once more in the world pane, under

    local_from_face . clip_from_local

where local_from_face lays all depths onto the near face. What is nearer is then moved a little
towards the pane's camera, so that it stays in front: along a line of sight no pixel moves.
"""

import math
from typing import NamedTuple

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPlane

from app.drawings import actors
from app.drawings.frustum import normalised
from app.drawings.label_placement import Ground
from app.drawings.layer import FacesLayer
from app.drawings.world_state import WorldState
from app.model.projection import Array, Projection

SLAB = 0.005
"""Thickness of the picture on the near plane, relative to near, with a parallel lens to the reach,
under a free matrix to the picture's diagonal."""

_MARGIN = 0.02  # of the scene's depth, kept free at both ends of the slab
_LINES_IN_FRONT = 0.01  # of the slab: a face must not eat its own edges
_LEAST_PX = 1.5
_AT_EYE = 1e-12  # of the scene's extent


class NearPicture(FacesLayer):
    """The scene on the near plane of a frustum; `is_seen` if its layer is visible."""

    _state: WorldState
    follows = ("local_from_object",)

    def __init__(self, state: WorldState) -> None:
        self._planes = [vtkPlane() for _ in range(6)]
        drawn = actors.SceneActors(state.scene, state.style, self._planes, in_plane=True)
        self._drawn = list(drawn)
        for actor in self._drawn:
            actors.flat(actor).is_drawing = True
        state.canvas.add(*self._drawn, layer="near-picture")
        state.canvas.set_visible(False, *self._drawn)
        super().__init__(state, drawn, "projected")
        self.space, *self._line_spaces, self._ground_space = drawn.spaces
        self.is_seen = False

    def show(self) -> None:
        self.actors.show_moved(not self._state.projection.placement.is_identity)
        super().show()

    def settle(self) -> None:
        """Lay the scene onto the near plane, as the pane's own camera sees it."""
        state, (corners, reach, _) = self._state, self._state.volume
        projection, standing, pane = state.projection, state.standing, state.own.pane
        lens, depths = projection.lens, standing.depths
        left_bottom, right_top = corners[0], corners[2]
        px = pane.unit(math.dist(pane.eye, left_bottom))
        across = math.dist(left_bottom, right_top)
        seen = across > _LEAST_PX * px and not pane.sees_edge_on(corners[:4])
        if reach is None:
            seen = seen and projection.frustum_sign > 0
        else:
            seen = (
                seen and reach.near_break is None and depths[1] > lens.near and depths[0] < lens.far
            )
        # From the eye itself the picture covers the scene exactly, and is left out.
        seen = seen and math.dist(pane.eye, standing.eye) > _AT_EYE * standing.extent
        if seen != self.is_seen:
            self.is_seen = bool(seen)
            state.canvas.set_visible(self.is_seen, *self._drawn)
        if not seen:
            return
        thick = across if reach is None else reach.high if lens.parallel else lens.near
        toward = SLAB * thick * pane.way_from(corners[:4].mean(axis=0))
        self.actors.show_slope(pane.slope_of_depth(corners[:4], *state.own.depths), pane.size_px)
        if reach is None:
            film = flatten_free(projection, state.origin, toward)
        else:
            view = standing.view_from_local
            film = flatten(projection, view, depths, corners[:4], reach.high, toward)
        self.space.set(film.surface @ state.local_from_object)
        lines = film.surface if self.actors.surface is None else film.lines  # which far would cut
        for space in self._line_spaces:
            space.set(lines @ state.local_from_object)
        self._ground_space.set(lines)
        for plane, (*normal, offset) in zip(self._planes, film.planes.tolist(), strict=True):
            plane.SetNormal(normal)
            plane.SetOrigin([-offset * part for part in normal])

    def ink(self, ground: Ground) -> None:
        state = self._state
        if self.is_seen and "near-picture" not in state.canvas.hidden:
            state.silhouette.ink(ground, state.own.pane.spots(self._on_near_plane))

    @property
    def _on_near_plane(self) -> Array:
        """The triangles of the picture, (n, 3, 3); NaN outside the window."""
        state = self._state
        clip = state.projection.clip_from_local(state.scene.origin, "object")
        x, y, _, w = np.moveaxis(state.silhouette.triangles @ clip[:, :3].T + clip[:, 3], -1, 0)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            inside = (w > 0.0) & (np.maximum(np.abs(x), np.abs(y)) <= w)
            across, up = (np.where(inside, part / w, np.nan)[..., None] for part in (x, y))
        corner, right, _, top = state.volume.corners[:4]
        way = (across + 1.0) / 2.0 * (right - corner) + (up + 1.0) / 2.0 * (top - corner)
        return np.asarray(corner + way)


class Film(NamedTuple):
    """How the scene becomes its picture on the near plane: matrices within scene-local space."""

    surface: Array  # from the scene to its picture
    lines: Array  # the same, a little in front
    planes: Array  # (6, 4): left, right, bottom, top, near, far; a x + b y + c z + d >= 0


def flatten(
    projection: Projection,
    view_from_local: Array,
    depths: tuple[float, float],
    corners: Array,
    reach: float,
    toward: Array,
) -> Film:
    """Lay the scene onto the near face, every point along its ray to the lens's eye.

    `depths` are the least and largest distance of anything in the scene from the eye plane, in
    front (+) or behind (-); the picture's thickness is spent on them. `corners`, (4, 3), are those
    of the near face, and `reach` is the length of a parallel lens' drawn volume. `toward` is how
    far the nearest things are moved to the viewer, homogeneous, (4,); see `PaneView.way_from`. From
    behind, a picture is its mirror image, not the things' back sides.

    In homogeneous coordinates, with depth 1 at the near and 0 at the far end of the picture, x, y
    and w say where on the face a point is, so that each point keeps its ray. Then
    ``p' = p + z toward``, which is on the line of sight through p.
    """
    lens = projection.lens
    near, far = lens.near, lens.far
    free = max(_MARGIN * (depths[1] - depths[0]), 1e-6 * reach)  # flat scenes have no depth
    start = max(near, depths[0] - free)
    end = max(min(far, depths[1] + free), start + 1e-6 * reach)
    clip_from_local = projection.matrices_between(start, end)[0] @ view_from_local
    local_from_face = np.zeros((4, 4))
    local_from_face[:3, 0] = (corners[1] - corners[0]) / 2.0
    local_from_face[:3, 1] = (corners[3] - corners[0]) / 2.0
    local_from_face[:, 3] = *corners.mean(axis=0), 1.0
    face = view_from_local[2] + (0.0, 0.0, 0.0, near)
    side_planes = _side_planes(projection) @ view_from_local
    return _film(clip_from_local, local_from_face, face, side_planes, toward)


def flatten_free(projection: Projection, origin: Array, toward: Array) -> Film:
    """`flatten` under a free matrix: onto the cube's near face."""
    reversed_range = projection.with_depth("reversed")
    clip_from_local = reversed_range.clip_from_local(origin)
    local_from_face = reversed_range.world_from_clip_at(origin) @ np.eye(4)[[0, 1, 3, 3]]
    x, y, z, w = clip_from_local
    side_planes = np.array([w + x, w - x, w + y, w - y])
    return _film(clip_from_local, local_from_face, z - w, side_planes, toward)


def _film(
    clip_from_local: Array, local_from_face: Array, face: Array, side_planes: Array, toward: Array
) -> Film:
    """The picture between four planes, (4, 4), which are right on the near face.

    The plane `face`, (4,), is 0 there, so that it measures how far a point was moved.
    """
    middle, (z, w) = local_from_face[:, 3], clip_from_local[2:]
    scale = float(middle[3])
    surface = local_from_face @ clip_from_local + scale * np.outer(toward, z)
    lines = surface + _LINES_IN_FRONT * scale * np.outer(toward, w)
    away = float(face @ toward)
    depth = face * float(w @ middle) / (scale * away)
    sides = side_planes - np.outer(side_planes @ toward / away, face)
    planes = np.vstack([sides, w - float(w @ toward) / away * face - depth, depth])
    for order in (np.inf, 2):  # the largest first, or the squares may overflow
        lengths = np.linalg.norm(planes[:, :3], order, axis=1, keepdims=True)
        planes /= np.where(lengths > 0.0, lengths, 1.0)  # rounding can leave nothing of a plane
    return Film(normalised(surface), normalised(lines), planes)


def _side_planes(projection: Projection) -> Array:
    """Left, right, bottom and top of the view volume in view space, positive inside, (4, 4).

    Clip space has them as w + x and so on, which cancel for a window far off the axis.
    """
    starts, along = projection.lens.rays(np.reshape(projection.window, (2, 2)).T)
    planes = np.zeros((4, 4))
    for row, (axis, end, sign) in enumerate(((0, 0, 1.0), (0, 1, -1.0), (1, 0, 1.0), (1, 1, -1.0))):
        planes[row, axis] = sign
        planes[row, 2:] = sign * along[end, axis], sign * (0.0 - starts[end, axis])
    return planes
