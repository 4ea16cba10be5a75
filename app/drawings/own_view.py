"""The world pane's own camera, which looks at everything from outside and is not the model's.

Free, it looks from the scene's shot: a direction, and a fit. The fit has a closed form: the nearest
place from which everything that has to be inside is inside the pane, less the room for labels. So
it stands until the user moves it. Fixed, it stands in the model's camera frame and moves with it:

======  =========================  ===========  ==========================
name    projection                 right, up    looks along
======  =========================  ===========  ==========================
side    parallel                   -n, v        -u
top     parallel                   -n, -u       -v
axis    parallel                   u, v         -n
eye     perspective, from the eye  u, v         -n (a lens with an eye)
======  =========================  ===========  ==========================
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

import numpy as np

from app.drawings.actors import axes_of
from app.drawings.frame import BALL, BEFORE, PART_OF_PANE
from app.drawings.pane_view import PaneCamera, PaneView
from app.drawings.prop_group import PropGroup
from app.drawings.style import TITLE_EM
from app.model.limits import cos_sin_deg
from app.model.projection import Array, Camera
from app.picking.sight import Sight
from app.scenes.phenomena.illustration import Shot

_VIEW_ANGLE_DEG = 50.0
_HALF = math.tan(math.radians(_VIEW_ANGLE_DEG / 2.0))
_MARGIN, _LABEL_EM = 0.04, 1.3  # on each side: of the pane, and for labels
_SMALL_MARGIN = 1.0 / 12.0  # of a small pane: labels get no more of it
_MOST_BESIDE = 0.5  # of the height: title, rows of lengths and margins together take no more
_LEAST_SLOPE = 0.1  # of the pane's: what the camera's drawn parts leave of it at least
_BEFORE = 0.05  # of the extent of what is framed: the camera stands so far before it
_NEAREST = 0.02  # of the distance to the focal point: nearer things are cut
_LINES_LIFT = 2e-3  # of the distance: a face must not eat its own edges
_STEEPEST_EYE = math.tan(math.radians(80.0))  # what a pane shows from the eye, at most
_HIGHEST = math.sin(math.radians(80.0))  # largest elevation of a view that was fixed

_AXES = {
    "side": ((2, -1.0), (1, 1.0), (0, -1.0)),
    "top": ((2, -1.0), (0, -1.0), (1, -1.0)),
    "axis": ((0, 1.0), (1, 1.0), (2, -1.0)),
    "eye": ((0, 1.0), (1, 1.0), (2, -1.0)),
}
"""Right, up and the direction of view: which of u, v, n, and with which sign."""


class Framed(NamedTuple):
    """What the pane shows, and from where; scene-local."""

    camera: Camera  # the model's
    eye: Array
    points: Array  # (n, 3): must be inside the pane
    parts: Array  # (k, 3): the camera's drawn parts that must be inside; from the eye, in bodies
    corners: Array | None  # (8, 3), of the frustum
    has_eye: bool  # whether the lens' projectors meet
    below_em: float  # height of the text below a fixed view
    shot: Shot

    def moved(self, by: Array) -> Framed:
        return self._replace(eye=self.eye + by, points=self.points + by)


class _Flat(NamedTuple):
    """Where a fixed view stands, from the model's eye in the pane's own axes."""

    right: float
    up: float
    back: float
    half_height: float  # that it sees; from the eye a slope


class OwnView(PaneCamera):
    """The place of the pane's own camera.

    `pane` is how it looks now; `look` notices a move from outside. `fixed` is one of
    `app.document.view.FIXED`, or ``""``.
    """

    def __init__(self, canvas: PropGroup, origin: Array) -> None:
        super().__init__(canvas)
        self._origin = origin
        self.fixed = ""
        self._heading_deg = 0.0
        """The azimuth of the model's camera when the picture opened."""
        self._was_shifted = False
        self._flat: _Flat | None = None
        self._axes = np.eye(3)
        self._take()

    def look(self) -> None:
        """Take over the camera's place; a fixed view that was turned becomes the free one."""
        if self.fixed and self.was_moved:
            self._was_moved_while_fixed()
        self._take()

    def _take(self) -> None:
        camera = self._camera
        slope, flat = math.tan(math.radians(camera.GetViewAngle()) / 2.0), 0.0
        if camera.GetParallelProjection():
            slope, flat = 0.0, camera.GetParallelScale()
        eye = np.array(camera.GetPosition())
        self.pane = PaneView(eye, axes_of(camera), slope, self.size_px, flat)

    @property
    def view(self) -> Camera | None:
        """Where it was moved to, in world coordinates; None if it was not, or is fixed."""
        if self.fixed or not self.was_moved:
            return None
        camera, origin = self._camera, self._origin
        eye, target = camera.GetPosition(), camera.GetFocalPoint()
        return Camera(tuple(origin + eye), tuple(origin + target), camera.GetViewUp())

    def show(self, view: Camera) -> None:
        self.fixed = ""
        self._see_by_perspective()
        self._stand_at(view.eye - self._origin, view.target - self._origin, view.up)

    # -- the free view

    def reset(self, framed: Framed) -> None:
        """Look from the shot, or as the fixed view does."""
        self._heading_deg = framed.camera.orbit.azimuth_deg
        self._was_shifted = False
        self.place(framed)

    def place(self, framed: Framed) -> bool:
        """Look from as near as the pane allows; return whether the camera has moved.

        A fixed view that was shifted stays.
        """
        before = self._now
        if self.fixed:
            if not self._was_shifted:
                self._flat = None
            self.follow(framed)
        else:
            self._see_by_perspective()
            self._stand_at(*self._stand(self._shot_axes(framed.shot), [framed]))
            self._placed = self._now
        return self._now != before

    def _see_by_perspective(self) -> None:
        self._camera.SetParallelProjection(False)
        self._camera.SetViewAngle(_VIEW_ANGLE_DEG)

    def _shot_axes(self, shot: Shot, turn_deg: float = 0.0) -> Array:
        """Right, up and toward what is looked at, (3, 3)."""
        heading_deg = self._heading_deg if shot.about == "camera" else 0.0
        cos_a, sin_a = cos_sin_deg(shot.azimuth_deg + heading_deg + turn_deg)
        cos_e, sin_e = cos_sin_deg(shot.elevation_deg)
        right, out = (cos_a, 0.0, -sin_a), (sin_a * cos_e, sin_e, cos_a * cos_e)
        return np.array([right, np.cross(out, right), np.negative(out)])

    def _room(self, below_em: float) -> Array:
        """The parts of the pane's half sides for what is framed: left, right, down, up."""
        sides = np.repeat(self.size_px, 2)
        label_px = min(_LABEL_EM * self._em, _SMALL_MARGIN * float(sides.min()))
        taken = _MARGIN * sides + label_px + np.array([0.0, 0.0, below_em, TITLE_EM]) * self._em
        taken[2:] *= min(1.0, _MOST_BESIDE * sides[3] / (taken[2] + taken[3]))
        room: Array = 1.0 - 2.0 * taken / sides
        return room

    def _slopes(self, below_em: float, half_height: float) -> Array:
        """How steeply, or far, the pane sees to the left, right, down and up inside its room."""
        wide_px, high_px = self.size_px
        wide = half_height * wide_px / high_px
        slopes: Array = self._room(below_em) * (wide, wide, half_height, half_height)
        return slopes

    def _limits(
        self, axes: Array, framed: Framed, slopes: Array, half_height: float, *, flat: bool = False
    ) -> list[Array]:
        """What limits a view with these axes, for `_fit`.

        The camera's drawn parts have their size in pixels: they take it from the room of the eye.
        """
        x, y, toward = axes @ framed.points.T
        limits = [_limits(x, y, 0.0 * toward if flat else toward, slopes)]
        if len(framed.parts):
            grown = 2.0 * half_height * PART_OF_PANE * min(self.size_px) / self.size_px[1]
            body = grown / (BALL if flat else BALL + BEFORE * grown)
            right, up, away = body * (axes @ framed.parts.T)
            nearer = 1.0 if flat else 1.0 + away
            taken = np.stack([-right, right, -up, up])
            left = (slopes[:, None] * nearer - taken).min(axis=1)
            x, y, toward = axes @ framed.eye[:, None]
            least = _LEAST_SLOPE * half_height
            limits.append(_limits(x, y, 0.0 * toward if flat else toward, np.maximum(left, least)))
        return limits

    def _stand(self, axes: Array, moments: Sequence[Framed]) -> tuple[Array, Array]:
        """Return the camera's place and its focal point, (3,) each."""
        slopes = self._slopes(0.0, _HALF)
        limits = [each for one in moments for each in self._limits(axes, one, slopes, _HALF)]
        points = np.concatenate([each.points for each in moments])
        toward, extent = points @ axes[2], float(np.ptp(points, axis=0).max()) or 1.0
        right, up, back = _fit(limits, _BEFORE * extent - float(toward.min()))
        middle = (float(toward.min()) + float(toward.max())) / 2.0
        return np.array([right, up, -back]) @ axes, np.array([right, up, middle]) @ axes

    def from_all_sides(self, moments: Sequence[Framed], turns_deg: Sequence[float]) -> list[Camera]:
        """Return free views that show all of several moments, in world coordinates.

        Several of them go round the middle of what they show, and keep all of it in view.
        """
        self._heading_deg = moments[0].camera.orbit.azimuth_deg
        all_axes = [self._shot_axes(moments[0].shot, turn_deg) for turn_deg in turns_deg]
        if len(all_axes) == 1:
            stands = [self._stand(all_axes[0], moments)]
        else:
            points = np.concatenate([each.points for each in moments])
            focus = (points.min(axis=0) + points.max(axis=0)) / 2.0
            slopes = self._slopes(0.0, _HALF)
            limits = [
                each
                for axes, one in product(all_axes, moments)
                for each in self._limits(axes, one.moved(-focus), slopes, _HALF)
            ]
            low, less, high, more = np.stack(limits, axis=-1)
            away = float(np.maximum(high / more, -low / less).max())
            stands = [(focus - away * axes[2], focus) for axes in all_axes]
        places = [[tuple(self._origin + point) for point in stand] for stand in stands]
        return [Camera(place, focus) for place, focus in places]

    # -- fixed views

    def follow(self, framed: Framed) -> None:
        frame = framed.camera.frame
        right, up, toward = (sign * frame[which] for which, sign in _AXES[self.fixed])
        if self._flat is None:
            self._flat = self._frame_flat(np.stack([right, up, toward]), framed)
        flat, camera = self._flat, self._camera
        position = framed.eye + flat.right * right + flat.up * up - flat.back * toward
        away = max(flat.back, framed.camera.distance)
        camera.SetParallelProjection(self.fixed != "eye" or not framed.has_eye)
        if camera.GetParallelProjection():
            camera.SetParallelScale(flat.half_height)
        else:
            camera.SetViewAngle(2.0 * math.degrees(math.atan(flat.half_height)))
        self._stand_at(position, position + away * toward, up)
        self._axes = np.stack([right, up, toward])
        self._placed = self._now

    @property
    def sees_from_eye(self) -> bool:
        """Whether the pane's camera stands in the model's."""
        return self.fixed == "eye" and not self._camera.GetParallelProjection()

    def _frame_flat(self, axes: Array, framed: Framed) -> _Flat:
        about = framed.moved(-framed.eye)
        if self.fixed == "eye" and framed.has_eye:
            corners = about.points if framed.corners is None else framed.corners - framed.eye
            x, y, depth = np.abs(axes @ corners.T)
            wide, _, *room = self._slopes(max(framed.below_em, TITLE_EM), 1.0)
            with np.errstate(divide="ignore", invalid="ignore"):
                slope = float(max((x / depth).max() / wide, (y / depth).max() / min(room)))
            return _Flat(0.0, 0.0, 0.0, min(slope, _STEEPEST_EYE) if slope > 0.0 else 1.0)
        limits = self._limits(axes, about, self._slopes(framed.below_em, 1.0), 1.0, flat=True)
        farthest = float(np.linalg.norm(about.points, axis=1).max())
        right, up, half = _fit(limits, 1e-12 * farthest or 1.0)
        return _Flat(right, up, 2.0 * (farthest + half), half)

    def _was_moved_while_fixed(self) -> None:
        """Keep the fixed view if it was shifted or enlarged; a turn makes it the free one."""
        camera, (right, up, toward), flat = self._camera, self._axes, self._flat
        assert flat is not None
        now = np.array(camera.GetDirectionOfProjection())
        position = np.array(camera.GetPosition())
        if camera.GetParallelProjection() and float(now @ toward) > 1.0 - 1e-12:
            eye = np.array(self._placed[:3]) if self._placed else position
            shift = position - eye
            self._flat = flat._replace(
                right=flat.right + float(shift @ right),
                up=flat.up + float(shift @ up),
                half_height=camera.GetParallelScale(),
            )
            self._placed, self._was_shifted = self._now, True
            return
        self.fixed = ""
        distance, focus = camera.GetDistance(), np.array(camera.GetFocalPoint())
        if camera.GetParallelProjection():  # as large as it was, seen from a place
            distance = camera.GetParallelScale() / math.tan(math.radians(_VIEW_ANGLE_DEG) / 2.0)
        if abs(now[1]) > _HIGHEST:  # the free view keeps the world's vertical, and needs one
            level = math.copysign(1.0, -now[1]) * np.array([up[0], 0.0, up[2]])
            if not np.linalg.norm(level) > 1e-6:
                level = np.array([0.0, 0.0, -1.0])
            level *= math.sqrt(1.0 - _HIGHEST**2) / np.linalg.norm(level)
            now = level + np.array([0.0, math.copysign(_HIGHEST, now[1]), 0.0])
        self._see_by_perspective()
        self._stand_at(focus - distance * now, focus)
        self._placed = None

    # -- what depends on where it stands

    def fit_range(self, points: Array, *depths: float) -> float:
        """Let the camera see these points, (n, 3), and depths; return the nearest visible depth."""
        camera = self._camera
        of_points = (points - self.pane.eye) @ self.pane.axes[2]
        closest: float = 0.95 * min(float(of_points.min()), *depths)
        nearest = max(closest, _NEAREST * float(camera.GetDistance()))
        farthest = max(1.02 * max(float(of_points.max()), *depths), 2.0 * nearest)
        camera.SetClippingRange(nearest, farthest)
        return nearest

    def slope_of_depth(self, face: Array) -> tuple[float, float]:
        """How depth in NDC changes along x and y of NDC on a plane, of which a face is (4, 3)."""
        pane, (nearest, farthest) = self.pane, self._camera.GetClippingRange()
        normal = pane.axes @ np.cross(face[1] - face[0], face[3] - face[0])
        wide, high = pane.size_px
        per_ndc = normal[:2] * (pane.slope or pane.flat) * (wide / high, 1.0)
        if pane.flat:
            per_ndc *= 2.0 / (farthest - nearest) / normal[2]
        else:
            away = normal @ pane.axes @ (face.mean(axis=0) - pane.eye)
            per_ndc *= 2.0 / (1.0 / nearest - 1.0 / farthest) / away
        x, y = (-per_ndc).tolist()
        return x, y

    def lifted(self, times: float) -> Array:
        """Nearer to the camera by a part of the distance, for lines on faces, (4, 4)."""
        lift, pane = np.eye(4), self.pane
        if pane.flat:
            lift[:3, 3] = -times * _LINES_LIFT * 2.0 * pane.flat * pane.axes[2]
            return lift
        lift[:3, :3] *= 1.0 - times * _LINES_LIFT
        lift[:3, 3] = times * _LINES_LIFT * pane.eye
        return lift

    @property
    def sight(self) -> Sight:
        pane = self.pane
        width_px, height_px = pane.size_px
        right, up, toward = pane.axes
        rows = np.zeros((4, 4))
        px = height_px / (2.0 * (pane.flat or pane.slope))
        if pane.flat:
            rows[3, 3] = 1.0
            rows[2, :3] = toward
        else:
            rows[3, :3] = toward
            rows[2, 3] = -1.0
        rows[0] = width_px / 2.0 * rows[3]
        rows[1] = height_px / 2.0 * rows[3]
        rows[0, :3] += px * right
        rows[1, :3] -= px * up
        nearest, _ = self._camera.GetClippingRange()
        return Sight(pane.eye + self._origin, rows, np.array([(*toward, -nearest)]))


# --------------------------------------------------------------------------- the fit


def _limits(x: Array, y: Array, toward: Array, slopes: Array) -> Array:
    """How points limit the place of a camera that sees them within slopes, two rows of four.

    From `back` behind the origin, a place to the right sees a point if it is between
    ``x - right * (toward + back)`` and ``x + left * (toward + back)``. So the points leave the
    places from ``high - right * back`` to ``low + left * back``; likewise up.
    """
    left, right, down, above = slopes
    return np.array([
        ((x + left * toward).min(), left, (x - right * toward).max(), right),
        ((y + down * toward).min(), down, (y - above * toward).max(), above),
    ]).T  # fmt: skip


def _fit(limits: Sequence[Array], least: float) -> tuple[float, float, float]:
    """Return the nearest place within all limits, at least so far behind: right, up and back.

    Each lower and each higher limit meet at a distance; the largest of these is the answer.
    """
    low, less, high, more = np.stack(limits, axis=-1)
    meet = (high[:, :, None] - low[:, None]) / (more[:, :, None] + less[:, None])
    back = max(least, float(meet.max()))
    right, up = ((low + less * back).min(axis=1) + (high - more * back).max(axis=1)) / 2.0
    return float(right), float(up), back
