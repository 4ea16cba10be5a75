"""The own camera of the stage pane: a parallel one, placed for each stop of the strip.

Any foreshortening in this pane is the projection's own.
"""

import math
from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from app.drawings.actors import CUBE_CORNERS, axes_of
from app.drawings.pane_view import PaneCamera, axes_from, nearest_place
from app.drawings.prop_group import PropGroup
from app.drawings.style import TITLE_EM
from app.lecture.stages import CANONICAL_PARALLEL, CANONICAL_PERSPECTIVE, IMAGE, NDC, VIEW
from app.model.projection import Array, Camera, Projection

AXES_LENGTH = 0.35  # of the axes at the stops of world and view
CANONICAL_AXES = np.array([[0.0, 0.0, 0.5], [0.75, 0.0, 0.5], [0.0, 0.75, 0.5], [0.0, 0.0, 0.85]])
"""Start and tips of the axes in the canonical volumes: x and y short of the sides' words."""
OVERSHOOT = 0.28  # of the axes beyond the cube, and beyond the picture

_DISTANCE = 10.0  # of the camera; for a parallel one it affects only the clipping range
_REACH = 2.5  # everything drawn lies within this of the cube's centre, at any orbit
_BEHIND_DEG, _WORLD_ELEVATION_DEG = 55.0, 25.0  # of the world stop, from the scene's own camera
_CUBE_DEG = 27.0, 18.0  # to the right of the near face and above it
_LOOKED_FROM_DEG = {
    VIEW: (60.0, 20.0),
    CANONICAL_PERSPECTIVE: (40.0, 18.0),
    CANONICAL_PARALLEL: _CUBE_DEG,
    NDC: _CUBE_DEG,
    IMAGE: (0.0, 0.0),
}
_MARGIN_EM = 2.1  # on each side, for the labels
_CUBE_MARGIN_EM = 2.0  # at NDC, where near and far have the corners of the pane
_MOST_MARGIN = np.array([0.5, 0.25])  # of a small pane's width and height: both sides together
_Places: TypeAlias = Callable[[float], Array]  # in display space, at a position of the strip


class StageView(PaneCamera):
    """The place of the camera; `start` is the scene's own, from beside which the world is seen.

    `cube_side` is that of a `Scene`.
    """

    def __init__(
        self, canvas: PropGroup, start: Camera, cube_side: tuple[float, float] | None = None
    ) -> None:
        super().__init__(canvas)
        self._start, self._cube_side = start, cube_side
        self._stands = False
        self._pane: Array = np.zeros((4, 4))
        self._pane_of: object = None  # camera's state and pane's size of `pane_from_display`

    def _looked_from(self, stop: float) -> tuple[float, float]:
        if stop == NDC and self._cube_side is not None:
            return self._cube_side
        if stop > VIEW or (stop == VIEW and not self._stands):
            return _LOOKED_FROM_DEG[int(stop)]
        # From beside the scene's own camera, and by the shorter way to the next stop's place.
        after = _LOOKED_FROM_DEG[VIEW][0]
        azimuth = self._start.orbit.azimuth_deg + _BEHIND_DEG
        aside = math.remainder(azimuth - after, 360.0)
        return after + (0.75 * aside if self._stands else aside), _WORLD_ELEVATION_DEG

    def axes(self, stop: float) -> Array:
        return axes_from(*self._looked_from(stop))

    def reset(
        self,
        position: float,
        projection: Projection,
        framed: _Places,
        origin: _Places | None = None,
    ) -> None:
        """Show all of a stop from the best direction; between two stops, from a mixture.

        `framed` returns what has to be in view up to the stop of the view, (n, 3). If there is an
        `origin`, it stands still in the pane until then. The eye has come to it halfway.
        """
        self._stands = origin is not None
        step = 0.5 if position < VIEW else 1.0
        stop = min(position // step * step, IMAGE)
        part = (position - stop) / step
        framing = self._framing(stop, projection, framed)
        if part > 0.0:
            following = self._framing(stop + step, projection, framed)
            framing = (1.0 - part) * framing + part * following
            if origin is not None and position < VIEW:
                between = (1.0 - part) * origin(stop) + part * origin(stop + step)
                framing[:3] += origin(position) - between
        centre, scale = framing[:3], float(framing[3])
        toward = axes_from(*framing[4:])[2]
        camera = self._camera
        camera.ParallelProjectionOn()
        self._stand_at(centre + _DISTANCE * toward, centre)
        camera.SetParallelScale(scale)
        self._placed = self._now

    def _framing(self, stop: float, projection: Projection, framed: _Places) -> Array:
        """The view of a stop: centre x, y, z, parallel scale, azimuth, elevation."""
        width_px, height_px = self.size_px
        if stop <= VIEW:
            drawn = framed(stop)
        elif stop == IMAGE:
            sides = np.array([*projection.image_size, 0.0])
            across, down, _ = sides / sides.max()
            drawn = CUBE_CORNERS * (across, down, 0.0)
            drawn = np.vstack([drawn, [across + OVERSHOOT, -down - OVERSHOOT, 0.0]])
        elif stop == CANONICAL_PERSPECTIVE and projection.lens.central:
            drawn = np.vstack([CUBE_CORNERS * (1.0, 1.0, 0.0) - (0.0, 0.0, 0.5), CANONICAL_AXES])
        elif stop in (CANONICAL_PERSPECTIVE, CANONICAL_PARALLEL):
            drawn = np.vstack([CUBE_CORNERS * (1.0, 1.0, 0.5), CANONICAL_AXES])
        else:
            drawn = CUBE_CORNERS
        margins_px = 2.0 * (_CUBE_MARGIN_EM if stop == NDC else _MARGIN_EM) * self._em
        title_px = TITLE_EM * self._em
        sides_px = np.array([width_px, height_px - title_px])
        room_px = sides_px - np.minimum(margins_px, _MOST_MARGIN * sides_px)
        slopes = (np.repeat(room_px, 2) + np.array([0.0, 0.0, title_px, -title_px])) / height_px
        axes = self.axes(stop) * [[1.0], [1.0], [0.0]]
        place = nearest_place([(axes @ drawn.T, slopes)], 0.0)
        centre, scale = place @ axes, place[2]
        return np.array([*centre, scale, *self._looked_from(stop)])

    @property
    def view(self) -> Camera | None:
        """Where it was moved to, in display space; None if it was not.

        The view's distance stands for the scale.
        """
        if not self.was_moved:
            return None
        camera = self._camera
        target = np.array(camera.GetFocalPoint())
        toward = -np.array(camera.GetDirectionOfProjection())
        eye = target + camera.GetParallelScale() * toward
        return Camera(tuple(eye), tuple(target), camera.GetViewUp())

    def show(self, view: Camera) -> None:
        target = np.array(view.target)
        away = max(_DISTANCE, 1e-9 * float(np.abs(target).max()))  # or it would be the target
        self._stand_at(target + away * view.frame[2], target, view.up)
        self._camera.SetParallelScale(view.distance)

    def fit_range(self) -> None:
        camera = self._camera
        distance = -float(np.dot(camera.GetPosition(), camera.GetDirectionOfProjection()))
        near = distance - _REACH
        if not camera.GetParallelProjection():
            near = max(near, distance / 1000.0, 1e-3)
        camera.SetClippingRange(near, max(near, distance) + _REACH)

    @property
    def pane_from_display(self) -> Array:
        """From display space to pixels from the pane's top left, and depth, (4, 4)."""
        camera, (width_px, height_px) = self._camera, self.size_px
        of = camera.GetMTime(), width_px, height_px
        if of == self._pane_of:
            return self._pane
        right, up, toward = axes_of(camera)
        px = height_px / (2.0 * camera.GetParallelScale())
        position = np.array(camera.GetPosition())
        pane = np.zeros((4, 4))
        for row, axis, middle in ((0, px * right, width_px), (1, -px * up, height_px)):
            pane[row] = *axis, middle / 2.0 - axis @ position
        pane[2] = *toward, -toward @ position
        pane[3, 3] = 1.0
        self._pane_of, self._pane = of, pane
        return pane
