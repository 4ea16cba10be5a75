"""The world pane's own camera, which looks at everything from outside and is not the model's.

Free, it frames the drawing until the user moves it; `OwnView.refit` follows when a gesture ends.
Fixed, it stands in the model's camera frame and moves with it:

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
from collections.abc import Iterable, Iterator, Sequence
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.drawings.actors import axes_of
from app.drawings.frame import AROUND_PX, SIX_WAYS
from app.drawings.pane_view import PaneCamera, PaneView
from app.drawings.pointing import FACES
from app.drawings.prop_group import PropGroup
from app.drawings.style import TITLE_EM
from app.model.limits import cos_sin_deg
from app.model.projection import Array, Camera
from app.picking.sight import Sight

_VIEW_ANGLE_DEG = 50.0
_MARGIN_EM = 1.3  # for the labels
_SMALL_MARGIN = 1.0 / 6.0  # of a small pane: both sides together take no more of it
_BEHIND_FAR = 1.4  # of far's distance: the depth that a view from the side shows
_LARGE, _LARGE_AREA = 0.6, 0.35  # of the pane's longer side, and of its area: the core
_NEARBY = 0.35  # of what is beside the core: counts when the free view chooses its direction
_VERY_LARGE = 0.7  # of the longer side: large, whatever its area
_SHARES = (1.0, 0.8, 0.65, 0.5, 0.35, 0.2, 0.1, 0.0)  # of what is beside the core, best first
_SHRUNK = 0.4  # of the pane: `refit` brings nearer what fills less of it
_NEAREST = 0.02  # of the distance to the focal point: nearer things are cut
_LINES_LIFT = 2e-3  # of the distance: a face must not eat its own edges
_STEEPEST_EYE = math.tan(math.radians(80.0))  # what a pane shows from the eye, at most
_HIGHEST = math.sin(math.radians(80.0))  # largest elevation of a view that was fixed

# Where the pane is looked from as it opens: how far behind the model's camera, and how high.
_TURNS_DEG, _RISES_DEG = (20.0, 35.0, 50.0), (15.0, 25.0, 35.0)
_GRID = 24  # of samples along each side of a square pane, by which it is chosen
_EYE_PART = 0.1  # of half the pane, round the eye

_AXES = {
    "side": ((2, -1.0), (1, 1.0), (0, -1.0)),
    "top": ((2, -1.0), (0, -1.0), (1, -1.0)),
    "axis": ((0, 1.0), (1, 1.0), (2, -1.0)),
    "eye": ((0, 1.0), (1, 1.0), (2, -1.0)),
}
"""Right, up and the direction of view: which of u, v, n, and with which sign."""


class Framed(NamedTuple):
    """What the pane shows, and how it is oriented; scene-local."""

    camera: Camera  # the model's
    eye: Array
    core: Array  # (m, 3): must be in view and large, as must the camera's body and axes
    beside: Array  # (k, 3): come into view as far as the core stays large
    corners: Array | None  # (8, 3), of the frustum
    objects: Array  # (8, 3), of the box round the objects
    has_eye: bool  # whether the lens' projectors meet
    below_em: float  # height of the text below a fixed view
    side: tuple[float, float] | None = None  # of `Scene.side`

    def shared(self, share: float) -> Array:
        """The points in view if what is beside the core has this share of its distance, (n, 3)."""
        middle = (self.core.min(axis=0) + self.core.max(axis=0)) / 2.0
        return np.vstack([self.core, middle + share * (self.beside - middle)])


class _Flat(NamedTuple):
    """Where a fixed view stands, from the model's eye in the pane's own axes."""

    right: float
    up: float
    back: float
    half_height: float  # that it sees; from the eye a slope


class OwnView(PaneCamera):
    """The place of the pane's own camera, and what it frames.

    `pane` is how it looks now; `look` notices a move from outside. `around` is how far the
    camera's drawn parts reach, 0 if they need not be in view; `fixed` is one of
    `app.document.view.FIXED`, or ``""``.
    """

    def __init__(self, canvas: PropGroup, origin: Array, middle: Array) -> None:
        super().__init__(canvas)
        self._origin, self._middle = origin, middle
        self._framed: Framed | None = None
        self._framed_first: Framed | None = None
        self.fixed = ""
        self.around = 1.0
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
        """Look from where the parts are seen best, or as the fixed view does."""
        self._framed = self._framed_first = framed
        self._was_shifted = False
        if not self.fixed:
            self._direction = _clearest([framed])
        self.place(framed)

    def refit(self, framed: Framed) -> bool:
        """Frame what has left the view or nearly vanished; return whether the camera has moved.

        It goes back to what `reset` framed as soon as that shows everything again. The direction of
        looking stays.
        """
        if self.fixed:
            return self._refit_fixed(framed)
        points, first = framed.core, self._framed_first
        assert first is not None
        if self._framed is not first and self._fits(points, self._stand(first)[0]):
            self._framed = first
        elif self._fits(points, self.pane.eye):
            return False
        else:
            self._framed = framed
        self.place(framed)
        return True

    def _refit_fixed(self, framed: Framed) -> bool:
        before = self._flat
        assert before is not None
        now = self._frame_flat(self._axes, framed)
        size = max(before.half_height, now.half_height)
        aside = max(abs(before.right - now.right), abs(before.up - now.up))
        is_seen = now.half_height + aside <= 1.02 * before.half_height
        if self._was_shifted or (is_seen and now.half_height >= _SHRUNK * size):
            return False
        self.place(framed)
        return True

    def _fits(self, points: Array, eye: Array) -> bool:
        """Whether points are in the view from `eye` in the present direction, and large enough."""
        pane = self.pane
        x, y, depth = pane.axes @ (points - eye).T
        if depth.min() <= 0.0:
            return False
        width_px, height_px = pane.size_px
        # From -1 to 1 in the pane.
        unit = np.where(depth > 0.0, pane.unit(depth), np.inf)
        across, up = 2.0 * x / (unit * width_px), 2.0 * y / (unit * height_px)
        largest = max(float(np.ptp(across)), float(np.ptp(up))) / 2.0
        inside = max(float(np.abs(across).max()), float(np.abs(up).max())) <= 1.0
        return inside and largest >= _SHRUNK

    def place(self, framed: Framed) -> None:
        """Look at the framed points in the present direction, from as near as the window allows."""
        if self.fixed:
            if not self._was_shifted:
                self._flat = None
            self.follow(framed)
            return
        assert self._framed is not None
        self._see_by_perspective()
        position, focus, _ = self._stand(self._framed)
        self._stand_at(position, focus)
        self._placed = self._now

    def _see_by_perspective(self) -> None:
        self._camera.SetParallelProjection(False)
        self._camera.SetViewAngle(_VIEW_ANGLE_DEG)

    def _room(self, below_em: float) -> tuple[float, float]:
        """The parts of the pane's width and height for what is framed, each 1/2 to 1."""
        wide, high = self.size_px
        margin = min(2.0 * _MARGIN_EM * self._em, _SMALL_MARGIN * min(wide, high))
        beside = (TITLE_EM + below_em) * self._em
        return (max(0.5, (wide - margin) / wide), max(0.5, (high - margin - beside) / high))

    def _slopes(self) -> tuple[tuple[float, float], float]:
        """How steeply the free view sees to the sides and up, and how far it stands lower."""
        half, size_px = math.tan(math.radians(_VIEW_ANGLE_DEG / 2.0)), self.size_px
        wide, high = self._room(0.0)
        lower = half * TITLE_EM * self._em / size_px[1]  # by half of what the pane's title takes
        return (half * wide * size_px[0] / size_px[1], half * high), lower

    def _stand(self, framed: Framed) -> tuple[Array, Array, Array]:
        """Return the camera's place, its focal point, (3,) each, and what is in view, (n, 3)."""
        out, size_px, eye = self._direction, self.size_px, framed.eye
        axes, half = _axes_from(out), math.tan(math.radians(_VIEW_ANGLE_DEG / 2.0))
        slopes, lower = self._slopes()
        for share in _SHARES:
            points = shown = framed.shared(share)
            position = _stand_back(axes, points, slopes, lower)
            for _ in range(2):  # camera's body and axes are as large as the pane makes them
                unit = 2.0 * half / size_px[1] * float((position - eye) @ out)
                around = max(0.0, self.around * AROUND_PX * min(size_px) * unit)
                body = eye + around * SIX_WAYS if around else np.empty((0, 3))
                shown = np.vstack([points, body])
                position = _stand_back(axes, shown, slopes, lower)
            x, y, away = axes @ (framed.core - position).T
            across, up = np.ptp(x / away) / (2.0 * half), np.ptp(y / away) / (2.0 * half)
            if _is_large(float(across) * size_px[1] / size_px[0], float(up)):
                break
        # Ahead of the pane's camera, even if the model's eye is behind it.
        middle = (float(self._middle @ out) + min(float(eye @ out), float(position @ out))) / 2.0
        return position, position + (middle - float(position @ out)) * out, shown

    def from_all_sides(self, moments: Sequence[Framed], turns_deg: Sequence[float]) -> list[Camera]:
        """Return free views that show all of several moments, in world coordinates.

        Several of them go round the middle of what they show, and keep all of it in view.
        """
        core = np.vstack([each.core for each in moments])
        beside = np.vstack([each.beside for each in moments])
        self._direction = _clearest(moments)
        framed = moments[0]._replace(core=core, beside=beside)
        if len(turns_deg) > 1:
            focus, positions = self._round(framed, turns_deg)
        else:
            position, focus, _ = self._stand(framed)
            positions = [position]
        target = tuple(self._origin + focus)
        return [Camera(tuple(self._origin + place), target) for place in positions]

    def _round(self, framed: Framed, turns_deg: Sequence[float]) -> tuple[Array, list[Array]]:
        """Return the middle of what is framed, and the places around it that show all of it."""
        points = framed.shared(1.0)
        focus = (points.min(axis=0) + points.max(axis=0)) / 2.0
        directions = [_turned(self._direction, turn_deg) for turn_deg in turns_deg]
        all_axes = [_axes_from(way) for way in directions]
        (across, up), lower = self._slopes()

        def needed() -> tuple[float, float, float]:
            x, y, toward = np.stack([axes @ (points - focus).T for axes in all_axes], axis=1)
            sides = np.abs(x) / across, y / (up - lower), -y / (up + lower)
            beside, above, below = (float((side - toward).max()) for side in sides)
            return beside, above, below

        body_px = self.around * AROUND_PX * min(self.size_px)
        unit = 2.0 * math.tan(math.radians(_VIEW_ANGLE_DEG / 2.0)) / self.size_px[1]
        if body_px:
            points = np.vstack([points, framed.eye + body_px * unit * max(needed()) * SIX_WAYS])
        for _ in range(4):  # as high as makes it nearest
            _, above, below = needed()
            focus[1] += 0.5 * up * (above - below)
        return focus, [focus + max(needed()) * way for way in directions]

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
        wide_px, high_px = self.size_px
        if self.fixed == "eye" and framed.has_eye:
            corners = framed.shared(1.0) if framed.corners is None else framed.corners
            x, y, depth = axes @ (corners - framed.eye).T
            wide, high = self._room(framed.below_em + TITLE_EM)  # as much below: it looks ahead
            with np.errstate(divide="ignore", invalid="ignore"):
                across, up = np.abs(x / depth).max(), np.abs(y / depth).max()
            slope = max(up / high, across / wide * high_px / wide_px)
            return _Flat(0.0, 0.0, 0.0, min(slope, _STEEPEST_EYE) if slope > 0.0 else 1.0)
        wide, high = self._room(framed.below_em)
        core = np.ptp(axes[:2] @ framed.core.T, axis=1)
        for share in _SHARES:
            offsets = axes @ (framed.shared(share) - framed.eye).T
            if self.fixed in ("side", "top") and framed.corners is not None:
                # Objects far behind the frustum would shrink it to a strip.
                far = float((axes[0] @ (framed.corners - framed.eye).T).max())
                deepest = max(_BEHIND_FAR * far, 1.1 * framed.camera.distance)
                offsets[0] = np.minimum(offsets[0], deepest)
            low, most = offsets[:2].min(axis=1), offsets[:2].max(axis=1)
            middle, half = (low + most) / 2.0, 0.0
            for _ in range(2):
                half = max((most[1] - low[1]) / (2.0 * high), 1e-12 * float(np.abs(offsets).max()))
                half = max(half, (most[0] - low[0]) / (2.0 * wide) * high_px / wide_px)
                half = half or 1.0  # of one point
                around = self.around * AROUND_PX * min(wide_px, high_px) * 2.0 * half / high_px
                if around:
                    low, most = np.minimum(low, -around), np.maximum(most, around)
                middle = (low + most) / 2.0
            # The rows of lengths belong to the core.
            across, up = core / (2.0 * half) * (high_px / wide_px, 1.0)
            if _is_large(float(across), float(up) + framed.below_em * self._em / high_px):
                break
        middle[1] -= (framed.below_em - TITLE_EM) * self._em / high_px * half
        deepest = float(np.linalg.norm(offsets, axis=0).max()) + around
        return _Flat(float(middle[0]), float(middle[1]), 2.0 * deepest, float(half))

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


def _is_large(across: float, up: float) -> bool:
    """Whether a box of these parts of the pane's sides is as large as what is named should be."""
    longer = max(across, up)
    return longer >= _LARGE and (across * up >= _LARGE_AREA or longer >= _VERY_LARGE)


# --------------------------------------------------------------------------- the opening view


def _axes_from(out: Array) -> Array:
    """Right, up and toward what is looked at of a camera that stands in a direction, (3, 3)."""
    right = np.cross((0.0, 1.0, 0.0), out)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(out, right), -out])


def _turned(out: Array, turn_deg: float) -> Array:
    """A direction after a turn about the vertical, (3,)."""
    x, y, z = out
    cos, sin = cos_sin_deg(turn_deg)
    return np.array([cos * x + sin * z, y, cos * z - sin * x])


def _stand_back(
    axes: Array, points: Array, slopes: tuple[float, float], lower: float = 0.0
) -> Array:
    """Return where these points just fill a view of these slopes, lowered by one, (3,)."""
    right, up, toward = axes
    x, y, away = axes @ points.T
    centre, distance = [], -math.inf
    for across, slope, shift in ((x, slopes[0], 0.0), (y, slopes[1], lower)):
        low = float((-(slope + shift) * away - across).max())
        high = float((-(slope - shift) * away + across).max())
        centre.append((high - low) / 2.0)
        distance = max(distance, (high + low) / (2.0 * slope))
    position: Array = centre[0] * right + (centre[1] + lower * distance) * up - distance * toward
    return position


def _directions(frame: Array, sides: Iterable[tuple[float, float]]) -> Iterator[Array]:
    """The directions to look from: turned from beside the model's camera, and raised."""
    behind = np.array([frame[2, 0], 0.0, frame[2, 2]])
    beside = np.cross(behind, (0.0, 1.0, 0.0))
    if np.linalg.norm(beside) < 0.2:  # it looks straight down or up: stand at its right
        beside = np.array([frame[0, 0], 0.0, frame[0, 2]])
        if np.linalg.norm(beside) < 0.2:
            beside = np.array([1.0, 0.0, 0.0])
    beside /= np.linalg.norm(beside)
    if beside @ (0.3, 0.0, 1.0) < 0.0:  # scenes show their fronts to +z
        beside = -beside
    for turn_deg, rise_deg in sides:
        turn, rise = math.radians(turn_deg), math.radians(rise_deg)
        level = math.cos(turn) * beside + math.sin(turn) * behind
        level /= np.linalg.norm(level)
        yield math.cos(rise) * level + np.array([0.0, math.sin(rise), 0.0])


def _clearest(moments: Sequence[Framed]) -> Array:
    """The direction that shows eye, near plane, objects and far plane best, (3,).

    It maximises the product of the parts of a square pane that each of the four takes alone, and
    that all of them take together. The result does not depend on the pane's proportions. Of several
    moments the worst decides.
    """
    best, direction = -math.inf, None
    for framed in moments:
        sides = product(_TURNS_DEG, _RISES_DEG) if framed.side is None else (framed.side,)
        for out in _directions(framed.camera.frame, sides):
            shown = min(_parts_shown(each, out) for each in moments)
            if shown > best:
                best, direction = shown, out
    assert direction is not None
    return direction


def _parts_shown(framed: Framed, out: Array) -> float:
    half = math.tan(math.radians(_VIEW_ANGLE_DEG / 2.0))
    eye = framed.eye[None]
    corners = np.tile(eye, (8, 1)) if framed.corners is None else framed.corners
    axes = _axes_from(out)
    position = _stand_back(axes, np.vstack([framed.shared(_NEARBY), eye]), (half, half))
    x, y, away = axes @ (np.vstack([eye, corners, framed.objects]) - position).T
    spots = np.stack([x, y], axis=1) / (half * away)[:, None]
    eye_spot, frustum, objects = spots[0], spots[1:9], spots[9:]
    near, far, *walls = _inside(frustum[_SIDES])
    thing = _inside(objects[_SIDES]).any(axis=0)
    whole = np.logical_or.reduce([near, far, thing, *walls])
    at_eye = (np.abs(_SPOTS - eye_spot) < _EYE_PART).all(axis=1)
    parts = (
        near & ~thing & ~at_eye,
        thing & ~near & ~at_eye,
        far & ~thing & ~near & ~at_eye,
        at_eye & ~near & ~far & ~thing,
        whole,
    )
    return math.prod(max(0.5, float(part.sum())) for part in parts)


_STEPS = (np.arange(_GRID) + 0.5) * (2.0 / _GRID) - 1.0
_SPOTS = np.stack(np.meshgrid(_STEPS, _STEPS), axis=-1).reshape(-1, 2)


_SIDES = [list(face) for face in FACES.values()]
"""Near and far first."""


def _inside(faces: Array) -> NDArray[np.bool_]:
    """Which of `_SPOTS` are in convex faces, (n, 4, 2): (n, `_GRID` ** 2)."""
    along = np.roll(faces, -1, axis=1) - faces
    # Left of each side: a linear form of the spot, the other way round for a face from behind.
    normals = np.stack([-along[..., 1], along[..., 0]], axis=-1)
    offsets = (normals * faces).sum(axis=-1, keepdims=True)
    turns = normals @ _SPOTS.T - offsets
    is_inside: NDArray[np.bool_] = np.logical_or(turns.min(axis=1) >= 0.0, turns.max(axis=1) <= 0.0)
    return is_inside
