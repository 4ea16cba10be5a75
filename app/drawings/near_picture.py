"""The picture on the near plane: the scene once more in the world pane, under

    local_from_film . flatten . clip_from_local

where flatten squeezes all depths into a thin slab at the near face, on the viewer's side, so that
nearer objects stay in front.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPlane

from app.drawings import actors
from app.drawings.actors import Canvas
from app.drawings.camera import Standing
from app.drawings.frustum import FrustumDrawing, matrices_between, normalised
from app.drawings.pane_view import PaneView
from app.model.projection import Array, Projection
from app.scenes.scene import Scene

SLAB = 0.005
"""Thickness of the picture on the near plane, relative to near (parallel lens: the reach)."""

_MARGIN = 0.02  # of the scene's depth, kept free at both ends of the slab
_LINES_IN_FRONT = 0.01  # of the slab: a face must not eat its own edges
_LEAST_PX = 1.5


class NearPicture:
    def __init__(self, canvas: Canvas, scene: Scene) -> None:
        self._canvas = canvas
        self._planes = [vtkPlane() for _ in range(6)]
        self.actors = actors.SceneActors(scene, canvas.style, self._planes)
        self.faces = self.actors.surface
        self.space, self._lines_space, self._ground_space = self.actors.spaces
        canvas.add(*self.actors, layer="near-picture")

    def show(
        self,
        projection: Projection,
        standing: Standing,
        frustum: FrustumDrawing,
        pane: PaneView,
        local_from_object: Array,
    ) -> None:
        """Lay the scene onto the near plane of a frustum, as the pane's camera sees it."""
        lens, reach, depths = projection.lens, frustum.reach, standing.depths
        left_bottom, right_top = frustum.corners[0], frustum.corners[2]
        px = pane.unit(math.dist(pane.eye, left_bottom))
        seen = math.dist(left_bottom, right_top) > _LEAST_PX * px
        if reach is None:
            seen = seen and projection.frustum_sign > 0
        else:
            seen = (
                seen and reach.near_break is None and depths[1] > lens.near and depths[0] < lens.far
            )
        for actor in self.actors:
            self._canvas.set_visible(actor, seen)
        if not seen:
            return
        if reach is None:
            film = flatten_free(projection, standing.origin, pane.eye)
        else:
            away = pane.eye - standing.eye
            from_eye_side = float(away @ standing.camera.frame[2]) > -reach.near
            view = standing.view_from_local, standing.local_from_view
            film = flatten(projection, view, depths, reach.high, toward_eye=from_eye_side)
        self.space.set(film.surface @ local_from_object)
        self._lines_space.set(film.lines @ local_from_object)
        self._ground_space.set(film.lines)
        for plane, (*normal, offset) in zip(self._planes, film.planes.tolist(), strict=True):
            plane.SetNormal(normal)
            plane.SetOrigin([-offset * part for part in normal])


class Film(NamedTuple):
    """The picture on the near plane, as matrices local from local."""

    surface: Array  # from the scene to its picture
    lines: Array  # the same, a little in front
    planes: Array  # (6, 4): left, right, bottom, top, near, far; a x + b y + c z + d >= 0


def flatten(
    projection: Projection,
    view: tuple[Array, Array],
    depths: tuple[float, float],
    reach: float,
    *,
    toward_eye: bool,
) -> Film:
    """Squeeze the scene into a thin slab at the near face, every point along its ray to the eye.

    `view` are view from scene-local coordinates, (4, 4), and back. `depths` are the least and
    largest distance of anything in the scene from the eye plane, in front (+) or behind (-); the
    slab's thickness is spent on them. A parallel lens' slab is proportional to the length `reach`.
    `toward_eye` is the side of the near plane. Seen from its own side the nearest is on top: from
    behind, a picture is its mirror image, not the things' back sides.

    In homogeneous coordinates, with depth 1 at the near and 0 at the far end of the picture:
    ``flatten: z' = w +- slab z``; x, y and w stay, so that each point keeps its ray.
    """
    lens = projection.lens
    near, far = lens.near, lens.far
    free = max(_MARGIN * (depths[1] - depths[0]), 1e-6 * reach)  # flat scenes have no depth
    start = max(near, depths[0] - free)
    end = max(min(far, depths[1] + free), start + 1e-6 * reach)
    view_from_local, local_from_view = view
    clip_from_local = matrices_between(projection, start, end)[0] @ view_from_local
    film_end = math.inf if lens.far_may_be_infinite else near + reach
    film = matrices_between(projection, near, film_end)
    film_from_local, local_from_film = film[0] @ view_from_local, local_from_view @ film[1]
    side_planes = _side_planes(projection) @ view_from_local
    side = 1.0 if toward_eye else -1.0
    return _film(clip_from_local, film_from_local, local_from_film, side_planes, side)


def flatten_free(projection: Projection, origin: Array, pane_eye: Array) -> Film:
    """`flatten` under a free matrix: onto the cube's near face, on the viewer's side."""
    reversed_range = projection.with_depth("reversed")
    clip_from_local = reversed_range.clip_from_world_at(origin)
    local_from_clip = reversed_range.world_from_clip_at(origin)
    z, w = clip_from_local[2:] @ (*pane_eye, 1.0)
    side = 1.0 if w <= 0.0 or z > w else -1.0
    x, y, _, w = clip_from_local
    side_planes = np.array([w + x, w - x, w + y, w - y])
    return _film(clip_from_local, clip_from_local, local_from_clip, side_planes, side)


def _film(
    clip_from_local: Array,
    film_from_local: Array,
    local_from_film: Array,
    side_planes: Array,
    side: float,
) -> Film:
    """The slab on one side of the near face, 1 toward the eye, between four planes, (4, 4)."""
    squeeze = np.eye(4)
    squeeze[2] = 0.0, 0.0, side * SLAB, 1.0
    lifted = squeeze.copy()
    lifted[2, 3] += side * SLAB * _LINES_IN_FRONT
    z, w = film_from_local[2:]
    planes = np.vstack([side_planes, SLAB * w - side * (z - w), side * (z - w)])
    planes /= np.abs(planes).max(axis=1, keepdims=True)  # or the squares may overflow
    planes /= np.linalg.norm(planes[:, :3], axis=1, keepdims=True)
    return Film(
        normalised(local_from_film @ squeeze @ clip_from_local),
        normalised(local_from_film @ lifted @ clip_from_local),
        planes,
    )


def _side_planes(projection: Projection) -> Array:
    """Left, right, bottom and top of the view volume in view space, positive inside, (4, 4).

    Clip space has them as w + x and so on, which cancel for a window far off the axis.
    """
    left, right, bottom, top = projection.window
    planes = np.zeros((4, 4))
    for row, (axis, edge, sign) in enumerate(
        ((0, left, 1.0), (0, right, -1.0), (1, bottom, 1.0), (1, top, -1.0))
    ):
        starts, along = projection.lens.rays(np.full((1, 2), edge))
        planes[row, axis] = sign
        planes[row, 2:] = sign * along[0, axis], sign * (0.0 - starts[0, axis])
    return planes
