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
from app.scenes.phenomena.illustration import Shot


def limits_of(points: Array, slopes: Array) -> Array:
    """Return what points, (3, n) in the view's axes, leave: low, left, high and right, (4, 2).

    The slopes are how steeply they may be seen: left, right, down and up. The second column is
    that of up. A view looks along its third axis. From `back` behind the origin, a place to the
    right sees a point within its slopes if it lies between ``x - right * (toward + back)`` and
    ``x + left * (toward + back)``; likewise up. So points leave the places from
    ``high - right * back`` to ``low + left * back``. For a parallel view `toward` is 0, and `back`
    is half of its height.
    """
    x, y, toward = points
    left, right, down, up = slopes
    return np.array([
        ((x + left * toward).min(), left, (x - right * toward).max(), right),
        ((y + down * toward).min(), down, (y - up * toward).max(), up),
    ]).T  # fmt: skip


def nearest_place(limits: Sequence[Array], least: float) -> tuple[float, float, float]:
    """Return the nearest place within all limits, at least so far back: right, up and back.

    Each lower and each higher limit meet at a distance; the largest of these is the answer.
    """
    low, less, high, more = np.stack(limits, axis=-1)
    meet = (high[:, :, None] - low[:, None]) / (more[:, :, None] + less[:, None])
    back = max(least, float(meet.max()))
    right, up = ((low + less * back).min(axis=1) + (high - more * back).max(axis=1)) / 2.0
    return float(right), float(up), back


_VIEW_ANGLE_DEG = 50.0
_HALF = math.tan(math.radians(_VIEW_ANGLE_DEG / 2.0))
_MARGIN, _LABEL_EM = 0.04, 1.3  # on each side: of the pane, and for labels
_SMALL_MARGIN = 1.0 / 24.0  # of a small pane: labels get no more of it
_MOST_BESIDE = 0.5  # of the height: title, rows of lengths and margins together take no more
_LEAST_SLOPE = 0.1  # of the pane's: what the camera's drawn parts leave of it at least
_BEFORE = 0.05  # of the extent of what is framed: the camera stands so far before it
_NEAREST = 0.02  # of the distance to the focal point: nearer things are cut
_STEEPEST_EYE = math.tan(math.radians(80.0))  # what a pane shows from the eye, at most
_HIGHEST_DEG = 80.0  # largest elevation of a view that was fixed

_AXES = {  # right, up and the direction of view: which of u, v, n, and with which sign
    "side": ((2, -1.0), (1, 1.0), (0, -1.0)),
    "top": ((2, -1.0), (0, -1.0), (1, -1.0)),
    "axis": ((0, 1.0), (1, 1.0), (2, -1.0)),
    "eye": ((0, 1.0), (1, 1.0), (2, -1.0)),
}


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
        self._heading_deg = 0.0  # the azimuth of the model's camera when the picture opened
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

    def _shot_axes(self, shot: Shot) -> Array:
        """Right, up and toward what is looked at, (3, 3)."""
        heading_deg = self._heading_deg if shot.about == "camera" else 0.0
        cos_a, sin_a = cos_sin_deg(shot.azimuth_deg + heading_deg)
        cos_e, sin_e = cos_sin_deg(shot.elevation_deg)
        right, out = (cos_a, 0.0, -sin_a), (sin_a * cos_e, sin_e, cos_a * cos_e)
        return np.array([right, np.cross(out, right), np.negative(out)])

    def _slopes(self, below_em: float, half_height: float) -> Array:
        """How steeply, or far, the pane sees left, right, down and up; less the room of labels."""
        sides = np.repeat(self.size_px, 2)
        label_px = min(_LABEL_EM * self._em, _SMALL_MARGIN * float(sides.min()))
        taken = _MARGIN * sides + label_px + np.array([0.0, 0.0, below_em, TITLE_EM]) * self._em
        taken[2:] *= min(1.0, _MOST_BESIDE * sides[3] / (taken[2] + taken[3]))
        return np.asarray(half_height * (sides - 2.0 * taken) / sides[3])

    def _limits(self, axes: Array, framed: Framed, *, flat: bool = False) -> list[Array]:
        """What limits the place of a view with these axes, for `nearest_place`.

        The camera's drawn parts have their size in pixels: they take it from the room of the eye.
        """
        half = 1.0 if flat else _HALF
        slopes = self._slopes(framed.below_em, half)
        if flat:  # then no depth makes anything smaller
            axes = axes * [[1.0], [1.0], [0.0]]
        limits = [limits_of(axes @ framed.points.T, slopes)]
        if len(framed.parts):
            grown = 2.0 * half * PART_OF_PANE * min(self.size_px) / self.size_px[1]
            body = grown / (BALL if flat else BALL + BEFORE * grown)
            right, up, away = body * (axes @ framed.parts.T)
            taken = np.stack([-right, right, -up, up])
            left = (slopes[:, None] * (1.0 + away) - taken).min(axis=1)
            least = np.maximum(left, _LEAST_SLOPE * half)
            limits.append(limits_of(axes @ framed.eye[:, None], least))
        return limits

    def _stand(self, axes: Array, moments: Sequence[Framed]) -> tuple[Array, Array]:
        """Return the camera's place and its focal point, (3,) each."""
        limits = [each for one in moments for each in self._limits(axes, one)]
        points = np.concatenate([each.points for each in moments])
        toward, extent = points @ axes[2], float(np.ptp(points, axis=0).max()) or 1.0
        right, up, back = nearest_place(limits, _BEFORE * extent - float(toward.min()))
        middle = (float(toward.min()) + float(toward.max())) / 2.0
        return np.array([right, up, -back]) @ axes, np.array([right, up, middle]) @ axes

    def from_all_sides(self, moments: Sequence[Framed], turns_deg: Sequence[float]) -> list[Camera]:
        """Return free views that show all of several moments, in world coordinates.

        Several of them go round the middle of what they show: it turns before one view that fits.
        """
        self._heading_deg = moments[0].camera.orbit.azimuth_deg
        points = np.concatenate([each.points for each in moments])
        about = (points.min(axis=0) + points.max(axis=0)) / 2.0
        axes, turns = self._shot_axes(moments[0].shot), [_turn(turn_deg) for turn_deg in turns_deg]
        mirror = np.eye(3) - 2.0 * np.outer(axes[0], axes[0])
        moves = [turn @ side for turn in turns for side in (np.eye(3), mirror)]
        turned = [
            one._replace(
                eye=(one.eye - about) @ move,
                points=(one.points - about) @ move,
                parts=one.parts @ move,
            )
            for move, one in product(moves if len(turns) > 1 else turns, moments)
        ]
        stand = place, focus = self._stand(axes, turned)
        if len(turns) > 1:  # with the mirror images it looks at the vertical, about which it turns
            ahead = float(place[::2] @ axes[2, ::2]) / float(axes[2, ::2] @ axes[2, ::2])
            focus[:] = 0.0, place[1] - ahead * axes[2, 1], 0.0
        about = about + self._origin
        places = [[tuple(about + turn @ point) for point in stand] for turn in turns]
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
        if self.fixed == "eye" and framed.has_eye:
            corners = framed.points if framed.corners is None else framed.corners
            x, y, depth = np.abs(axes @ (corners - framed.eye).T)
            wide, _, *room = self._slopes(max(framed.below_em, TITLE_EM), 1.0)
            with np.errstate(divide="ignore", invalid="ignore"):
                slope = float(max((x / depth).max() / wide, (y / depth).max() / min(room)))
            return _Flat(0.0, 0.0, 0.0, min(slope, _STEEPEST_EYE) if slope > 0.0 else 1.0)
        limits = self._limits(axes, framed, flat=True)
        farthest = float(np.linalg.norm(framed.points - framed.eye, axis=1).max())
        right, up, half = nearest_place(limits, 1e-12 * farthest or 1.0)
        x, y, _ = axes @ framed.eye
        return _Flat(right - x, up - y, 2.0 * (farthest + half), half)

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
            distance = camera.GetParallelScale() / _HALF
        # The free view keeps the world's vertical, and needs one.
        orbit = Camera(tuple(-now), (0.0, 0.0, 0.0), camera.GetViewUp()).orbit
        elevation_deg = max(-_HIGHEST_DEG, min(_HIGHEST_DEG, orbit.elevation_deg))
        now = self._shot_axes(Shot(orbit.azimuth_deg, elevation_deg))[2]
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

    @property
    def depths(self) -> tuple[float, float]:
        """The nearest and the farthest depth that the camera sees."""
        nearest, farthest = self._camera.GetClippingRange()
        return nearest, farthest


def _turn(turn_deg: float) -> Array:
    """The matrix (3, 3) of a turn about the vertical, from +z towards +x."""
    cos, sin = cos_sin_deg(turn_deg)
    return np.array([[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]])
