"""The world pane's own camera, which looks at everything from outside and is not the model's.

While nobody has moved it, it frames what is drawn; `OwnView.refit` follows when a gesture ends.
"""

from __future__ import annotations

import math

import numpy as np

from app.drawings.actors import Canvas
from app.drawings.labels import PaneView
from app.model.projection import Array, Camera
from app.picking.picking import Sight

_VIEW_ANGLE_DEG = 50.0
_ELEVATION_DEG = 25.0  # and how far it stands behind the model's camera
_BEHIND_DEG = 55.0
_FILL = 0.86  # of the pane by what is framed; the rest is for the labels
_SHRUNK = 0.4  # of the pane: what fills less of it is brought nearer by `refit`
_NEAREST = 0.02  # of the distance to what is looked at: what is nearer is cut
_LINES_LIFT = 2e-3  # of the distance: a face must not eat its own edges


class OwnView:
    """Where the pane's own camera stands, and what it frames.

    Parameters
    ----------
    canvas : Canvas
    origin : (3,) array
        World; all else here is relative to it.
    middle : (3,) array
        Of the scene's objects.

    Attributes
    ----------
    pane : PaneView
        How it looks just now; a move from outside is seen by `look`.
    """

    def __init__(self, canvas: Canvas, origin: Array, middle: Array) -> None:
        self._camera = canvas.renderer.GetActiveCamera()
        self._window, self._origin, self._middle = canvas.window, origin, middle
        self._placed: tuple[float, ...] | None = None
        self._framed = self._framed_first = np.empty((0, 3))
        self.look()

    def look(self) -> None:
        """Take over where the camera stands."""
        camera = self._camera
        toward = np.array(camera.GetDirectionOfProjection())
        right = np.cross(toward, camera.GetViewUp())
        right /= np.linalg.norm(right)
        axes = np.stack([right, np.cross(right, toward), toward])
        slope = math.tan(math.radians(camera.GetViewAngle()) / 2.0)
        self.pane = PaneView(np.array(camera.GetPosition()), axes, slope, self._size_px)

    @property
    def _size_px(self) -> tuple[int, int]:
        width_px, height_px = self._window.GetSize()
        return max(1, width_px), max(1, height_px)

    @property
    def was_moved(self) -> bool:
        """Whether somebody has moved it since it was placed."""
        camera = self._camera
        return self._placed != (*camera.GetPosition(), *camera.GetFocalPoint())

    @property
    def view(self) -> Camera | None:
        """Where it was moved to, in world coordinates; None if it was not."""
        if not self.was_moved:
            return None
        camera, origin = self._camera, self._origin
        eye, target = camera.GetPosition(), camera.GetFocalPoint()
        return Camera(tuple(origin + eye), tuple(origin + target), camera.GetViewUp())

    def show(self, view: Camera) -> None:
        """Move it to a `view` of before."""
        camera = self._camera
        camera.SetPosition(*(view.eye - self._origin))
        camera.SetFocalPoint(*(view.target - self._origin))
        camera.SetViewUp(*view.up)

    def reset(self, frame: Array, eye: Array, points: Array) -> None:
        """Stand beside the model's camera, with these points in view.

        Parameters
        ----------
        frame : (3, 3) array
            The model's camera frame, rows u, v, n.
        eye : (3,) array
            The model's.
        points : (n, 3) array
        """
        behind = np.array([frame[2, 0], 0.0, frame[2, 2]])
        beside = np.cross(behind, (0.0, 1.0, 0.0))
        if np.linalg.norm(beside) < 0.2:  # it looks straight down or up: stand at its right
            beside = np.array([frame[0, 0], 0.0, frame[0, 2]])
            if np.linalg.norm(beside) < 0.2:
                beside = np.array([1.0, 0.0, 0.0])
        beside /= np.linalg.norm(beside)
        if beside @ (0.3, 0.0, 1.0) < 0.0:  # scenes show their fronts to +z
            beside = -beside
        turn, rise = math.radians(_BEHIND_DEG), math.radians(_ELEVATION_DEG)
        level = math.cos(turn) * beside + math.sin(turn) * behind
        level /= np.linalg.norm(level)
        self._direction = math.cos(rise) * level + np.array([0.0, math.sin(rise), 0.0])
        self._framed = self._framed_first = points
        self.place(eye)

    def refit(self, eye: Array, points: Array) -> bool:
        """Frame these points if they have left the view or nearly vanished.

        And go back to what `reset` framed as soon as that shows everything again. The direction
        of looking stays.

        Returns
        -------
        bool
            Whether it has moved.
        """
        first, now = self._framed_first, self._framed
        if now is not first and self._fits(points, self._stand(first, eye)[0]):
            points = first
        elif self._fits(points, self.pane.eye):
            return False
        self._framed = points
        self.place(eye)
        return True

    def _fits(self, points: Array, eye: Array) -> bool:
        """Whether points are in the view from `eye` in the direction of now, and large enough."""
        x, y, depth = self.pane.axes @ (points - eye).T
        if depth.min() <= 0.0:
            return False
        width_px, height_px = self.pane.size_px
        # From -1 to 1 in the pane.
        across = x / (depth * self.pane.slope * width_px / height_px)
        up = y / (depth * self.pane.slope)
        largest = max(float(np.ptp(across)), float(np.ptp(up))) / 2.0
        inside = max(float(np.abs(across).max()), float(np.abs(up).max())) <= 1.0
        return inside and largest >= _SHRUNK

    def place(self, eye: Array) -> None:
        """Stand in the direction of now from the framed points, as near as the window allows.

        Parameters
        ----------
        eye : (3,) array
            The model's.
        """
        camera = self._camera
        position, seen = self._stand(self._framed, eye)
        camera.SetParallelProjection(False)
        camera.SetViewAngle(_VIEW_ANGLE_DEG)
        camera.SetPosition(*position)
        camera.SetFocalPoint(*seen)
        camera.SetViewUp(0.0, 1.0, 0.0)
        self._placed = (*camera.GetPosition(), *camera.GetFocalPoint())

    def _stand(self, framed: Array, eye: Array) -> tuple[Array, Array]:
        """Where to stand for these points, and what to look at: (3,) each."""
        width_px, height_px = self._size_px
        out = self._direction
        right = np.cross((0.0, 1.0, 0.0), out)
        right /= np.linalg.norm(right)
        up = np.cross(out, right)
        x, y, z = np.stack([right, up, out]) @ framed.T
        half = math.tan(math.radians(_VIEW_ANGLE_DEG / 2.0)) * _FILL
        centre, distance = [], -math.inf
        for across, slope in ((x, half * width_px / height_px), (y, half)):
            low, high = float((slope * z - across).max()), float((slope * z + across).max())
            centre.append((high - low) / 2.0)
            distance = max(distance, (high + low) / (2.0 * slope))
        middle = float(self._middle @ out + eye @ out) / 2.0
        position: Array = centre[0] * right + centre[1] * up + distance * out
        return position, position + (middle - distance) * out

    def fit_range(self, points: Array, *depths: float) -> float:
        """Let the camera see all of these points; tell from which depth on it sees.

        Parameters
        ----------
        points : (n, 3) array
        *depths : float
            Depths of what else is to be seen.
        """
        camera = self._camera
        of_points = (points - self.pane.eye) @ self.pane.axes[2]
        closest: float = 0.95 * min(float(of_points.min()), *depths)
        nearest = max(closest, _NEAREST * float(camera.GetDistance()))
        farthest = max(1.02 * max(float(of_points.max()), *depths), 2.0 * nearest)
        camera.SetClippingRange(nearest, farthest)
        return nearest

    def lifted(self, times: float) -> Array:
        """Nearer to the camera by a part of the distance, for lines on faces, (4, 4)."""
        lift = np.eye(4)
        lift[:3, :3] *= 1.0 - times * _LINES_LIFT
        lift[:3, 3] = times * _LINES_LIFT * self.pane.eye
        return lift

    @property
    def sight(self) -> Sight:
        """How the pane looks at the world just now."""
        pane = self.pane
        width_px, height_px = pane.size_px
        px = height_px / (2.0 * pane.slope)
        right, up, toward = pane.axes
        rows = np.zeros((4, 4))
        rows[0, :3] = width_px / 2.0 * toward + px * right
        rows[1, :3] = height_px / 2.0 * toward - px * up
        rows[2, 3] = -1.0
        rows[3, :3] = toward
        nearest, _ = self._camera.GetClippingRange()
        return Sight(pane.eye + self._origin, rows, np.array([(*toward, -nearest)]))
