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
from collections.abc import Iterator, Sequence
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from app.drawings.frame import BALL, BEFORE, PART_OF_PANE
from app.drawings.pane_view import PaneCamera, PaneView, axes_from, nearest_place
from app.drawings.prop_group import PropGroup
from app.drawings.style import TITLE_EM
from app.model.projection import Array, Camera
from app.scenes.phenomena.illustration import Shot

_HALF = math.tan(math.radians(25.0))  # slope of the free view
_MARGIN, _LABEL_EM = 0.04, 1.3  # on each side: of the pane, and for labels
_SMALL_MARGIN = 1.0 / 24.0  # of a small pane: labels get no more of it
_MOST_BESIDE = 0.5  # of the height: title, rows of lengths and margins together take no more
_LEAST_SLOPE = 0.1  # of the pane's: what the camera's drawn parts leave of it at least
_BEFORE = 0.05  # of the extent of what is framed: the camera stands so far before it
_NEAREST = 0.02  # of the distance to the focal point: nearer things are cut
_STEEPEST_EYE = math.tan(math.radians(80.0))  # what a pane shows from the eye, at most
_HIGHEST_DEG = 80.0  # largest elevation of a view that was fixed

_FROM_EYE = np.diag((1.0, 1.0, -1.0))  # right, up and the direction of view, in u, v, n
_SIDE = np.array([(0.0, 0.0, -1.0), (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0)])
_TOP = np.array([(0.0, 0.0, -1.0), (-1.0, 0.0, 0.0), (0.0, -1.0, 0.0)])
_AXES = {"side": _SIDE, "top": _TOP, "axis": _FROM_EYE, "eye": _FROM_EYE}


class Framed(NamedTuple):
    """What has to be inside the pane, and from where it is seen; scene-local."""

    camera: Camera  # the model's
    eye: Array
    points: Array  # (n, 3): must be inside the pane
    parts: Array  # (k, 3): the camera's drawn parts that must be inside; from the eye, in bodies
    corners: Array  # (n, 3): inside the view from the eye
    has_eye: bool  # whether the lens' projectors meet
    below_em: float  # height of the text below a fixed view
    below: tuple[float, float]  # the distances along the axis between which that text stands
    shot: Shot


class _Fixed(NamedTuple):
    offset: Array  # from the model's eye in the pane's own axes
    half_height: float  # that it sees; from the eye a slope


class OwnView(PaneCamera):
    """The place of the pane's own camera.

    `pane` is how it looks now, and `depths` are the nearest and the farthest that it sees; `look`
    notices a move from outside. `fixed` is one of `app.document.view.FIXED`, or ``""``.
    """

    def __init__(self, canvas: PropGroup, origin: Array) -> None:
        super().__init__(canvas)
        self._origin = origin
        self.fixed = ""
        self._heading_deg = 0.0  # the azimuth of the model's camera when the picture opened
        self._was_shifted = False
        self._fixed_at: _Fixed | None = None
        self.placed_px = 0, 0  # the pane's size when it was placed
        self._rested = 0  # what was framed when it was placed, or at the last rest
        self._left: dict[int, tuple[_Fixed | None, tuple[float, ...]]] = {}
        """Where it stood, by what was framed, before an edit made it look from elsewhere."""
        self.depths: tuple[float, float] = self._camera.GetClippingRange()
        self.look()

    def look(self) -> None:
        """Take over the camera's place; a fixed view that was turned becomes the free one."""
        if self.fixed and self.was_moved:
            self._was_moved_while_fixed()
        eye, pose = np.array(self._camera.GetPosition()), self.pose
        flat = 0.0 if pose.slope else pose.half_height
        self.pane = PaneView(eye, pose.axes, pose.slope, self.size_px, flat)

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
        self._stand_freely(view.eye - self._origin, view.target - self._origin, view.up)

    # -- the free view

    def reset(self, framed: Framed) -> None:
        """Look from the shot, or as the fixed view does."""
        self._heading_deg, self._was_shifted = framed.camera.orbit.azimuth_deg, False
        self.place(framed)

    def place(self, framed: Framed) -> None:
        """Look from as near as the pane allows; a fixed view that was shifted stays."""
        self.placed_px, self._left, self._rested = self.size_px, {}, self._key(framed)
        if self.fixed:
            if not self._was_shifted:
                self._fixed_at = None
            self.follow(framed)
        else:
            self._stand_freely(*self._stand(self._shot_axes(framed.shot), [framed], [np.eye(3)]))
            self._placed = self._now

    def rest(self, framed: Framed, *, is_cut: bool) -> bool:
        """`place` it if something is cut; stand where it did if what led to that is undone.

        Returns whether the camera has moved.
        """
        before, here = self._now, self._key(framed)
        if here in self._left and not self._was_shifted:
            self._fixed_at, stood = self._left[here]
            if self.fixed:
                self.follow(framed)
            else:
                self._stand_freely(np.array(stood[:3]), np.array(stood[3:6]))
                self._placed = self._now
        elif is_cut:
            left = self._left | {self._rested: (self._fixed_at, before)}
            self.place(framed)
            self._left = left
        self._rested = here
        return self._now != before

    def _key(self, framed: Framed) -> int:
        return hash((self.fixed, *self.size_px, framed.points.tobytes()))

    def _stand_freely(self, *place: Any) -> None:
        self._look_through(_HALF)
        self._stand_at(*place)

    def _shot_axes(self, shot: Shot) -> Array:
        """Right, up and toward what is looked at, (3, 3)."""
        heading_deg = self._heading_deg if shot.about == "camera" else 0.0
        axes = axes_from(shot.azimuth_deg + heading_deg, shot.elevation_deg)
        return axes * [[1.0], [1.0], [-1.0]]

    def _slopes(self, below_em: float, half_height: float) -> Array:
        """How steeply, or far, the pane sees left, right, down and up; less the room of labels."""
        sides = np.repeat(self.size_px, 2)
        label_px = min(_LABEL_EM * self._em, _SMALL_MARGIN * float(sides.min()))
        taken = _MARGIN * sides + label_px + np.array([0.0, 0.0, below_em, TITLE_EM]) * self._em
        taken[2:] *= min(1.0, _MOST_BESIDE * sides[3] / (taken[2] + taken[3]))
        return np.asarray(half_height * (sides - 2.0 * taken) / sides[3])

    def _sights(self, axes: Array, framed: Framed) -> Iterator[tuple[Array, Array]]:
        """What a view with these axes has to see, for `nearest_place`; if flat, the third is 0.

        The camera's drawn parts have their size in pixels: they take it from the room of the eye.
        """
        is_flat = not axes[2].any()
        half = 1.0 if is_flat else _HALF
        slopes = self._slopes(framed.below_em, half)
        along = (framed.eye - framed.points) @ framed.camera.frame[2]
        is_above = (framed.below[0] <= along) & (along <= framed.below[1])
        for is_there, below_em in ((is_above, framed.below_em), (~is_above, 0.0)):
            if is_there.any():
                yield axes @ framed.points[is_there].T, self._slopes(below_em, half)
        if len(framed.parts):
            grown = 2.0 * half * PART_OF_PANE * min(self.size_px) / self.size_px[1]
            body = grown / (BALL if is_flat else BALL + BEFORE * grown)
            right, up, away = body * (axes @ framed.parts.T)
            taken = np.stack([-right, right, -up, up])
            left = (slopes[:, None] * (1.0 + away) - taken).min(axis=1)
            yield axes @ framed.eye[:, None], np.maximum(left, _LEAST_SLOPE * half)

    def _stand(self, axes: Array, moments: Sequence[Framed], moves: Sequence[Array]) -> list[Array]:
        """Return the camera's place and its focal point, (3,), before all moments in all moves."""
        turned = [axes @ move.T for move in moves]
        sights = [each for pair in product(turned, moments) for each in self._sights(*pair)]
        seen = np.concatenate([points for points, _ in sights], axis=1)
        extent, near, far = float(np.ptp(seen, axis=1).max()), seen[2].min(), seen[2].max()
        right, up, back = nearest_place(sights, _BEFORE * (extent or 1.0) - float(near))
        return [np.array([right, up, toward]) @ axes for toward in (-back, (near + far) / 2.0)]

    def from_all_sides(self, moments: Sequence[Framed], turns_deg: Sequence[float]) -> list[Camera]:
        """Return free views that show all of several moments, in world coordinates.

        Several of them go round the middle of what they show: it turns before one view that fits.
        """
        self._heading_deg = moments[0].camera.orbit.azimuth_deg
        points = np.concatenate([each.points for each in moments])
        about = (points.min(axis=0) + points.max(axis=0)) / 2.0
        moments = [one._replace(eye=one.eye - about, points=one.points - about) for one in moments]
        axes = self._shot_axes(moments[0].shot)
        turns = moves = [axes_from(turn_deg, 0.0).T for turn_deg in turns_deg]
        if len(turns) > 1:  # with the mirror images it looks at the vertical, about which it turns
            mirror = np.eye(3) - 2.0 * np.outer(axes[0], axes[0])
            moves = [turn @ side for turn in turns for side in (np.eye(3), mirror)]
        place, focus = self._stand(axes, moments, moves)
        if len(turns) > 1:
            ahead = float(place[::2] @ axes[2, ::2]) / float(axes[2, ::2] @ axes[2, ::2])
            focus = np.array([0.0, place[1] - ahead * axes[2, 1], 0.0])
        about = about + self._origin
        return [Camera(tuple(about + turn @ place), tuple(about + turn @ focus)) for turn in turns]

    # -- fixed views

    def follow(self, framed: Framed) -> None:
        axes = _AXES[self.fixed] @ framed.camera.frame
        if self._fixed_at is None:
            self._fixed_at = self._fix(axes, framed)
        offset, half_height = self._fixed_at
        position = framed.eye + offset @ axes
        away = max(-float(offset[2]), framed.camera.distance)
        from_eye = self.fixed == "eye" and framed.has_eye
        self._look_through(half_height if from_eye else 0.0, half_height)
        self._stand_at(position, position + away * axes[2], axes[1])
        self._placed = self._now

    @property
    def sees_from_eye(self) -> bool:
        """Whether the pane's camera stands in the model's."""
        return self.fixed == "eye" and not self._camera.GetParallelProjection()

    def _fix(self, axes: Array, framed: Framed) -> _Fixed:
        if self.fixed == "eye" and framed.has_eye:
            x, y, depth = np.abs(axes @ (framed.corners - framed.eye).T)
            wide, _, *room = self._slopes(max(framed.below_em, TITLE_EM), 1.0)
            with np.errstate(divide="ignore", invalid="ignore"):
                slope = float(max((x / depth).max() / wide, (y / depth).max() / min(room)))
            return _Fixed(np.zeros(3), min(slope, _STEEPEST_EYE) if slope > 0.0 else 1.0)
        farthest = float(np.linalg.norm(framed.points - framed.eye, axis=1).max())
        sights = self._sights(axes * [[1.0], [1.0], [0.0]], framed)
        right, up, half_height = nearest_place(sights, 1e-12 * farthest or 1.0)
        x, y, _ = axes @ framed.eye
        return _Fixed(np.array([right - x, up - y, -2.0 * (farthest + half_height)]), half_height)

    def _was_moved_while_fixed(self) -> None:
        """Keep the fixed view if it was shifted or enlarged; a turn makes it the free one."""
        before, now, stands = self.pane, self.pose, self._fixed_at
        assert stands is not None
        if not now.slope and float(now.axes[2] @ before.axes[2]) > 1.0 - 1e-12:
            shift = before.axes @ (np.array(self._camera.GetPosition()) - before.eye)
            self._fixed_at = _Fixed(stands.offset + shift * (1.0, 1.0, 0.0), now.half_height)
            self._placed, self._was_shifted = self._now, True
            return
        self.fixed = ""
        # As large as it was, seen from a place.
        distance = now.distance if now.slope else now.half_height / _HALF
        # The free view keeps the world's vertical, and needs one.
        orbit = Camera(tuple(-now.axes[2]), (0.0, 0.0, 0.0), self._camera.GetViewUp()).orbit
        elevation_deg = max(-_HIGHEST_DEG, min(_HIGHEST_DEG, orbit.elevation_deg))
        toward = self._shot_axes(Shot(orbit.azimuth_deg, elevation_deg))[2]
        self._stand_freely(now.focus - distance * toward, now.focus)
        self._placed = None

    # -- what depends on where it stands

    def fit_range(self, points: Array) -> None:
        """Let the camera see these points, (n, 3), as far as it can be precise."""
        seen = (points - self.pane.eye) @ self.pane.axes[2]
        nearest = max(0.95 * float(seen.min()), _NEAREST * float(self._camera.GetDistance()))
        self.depths = nearest, max(1.02 * float(seen.max()), 2.0 * nearest)
        self._camera.SetClippingRange(*self.depths)
