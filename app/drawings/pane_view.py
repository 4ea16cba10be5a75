"""How a pane's own camera looks at the world: what is seen where."""

import math
from collections.abc import Iterable
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike
from vtkmodules.vtkRenderingCore import vtkCamera

from app.drawings.actors import axes_of
from app.drawings.prop_group import PropGroup
from app.lecture.stages import rotation_between
from app.model.limits import cos_sin_deg
from app.model.projection import Array
from app.picking.sight import Sight

# Where in the pane a plane is looked for, from -1 to 1; what is near the bottom left first.
_ACROSS = 9
_SAMPLES = np.array([(x, y) for y in range(-4, 5) for x in range(-4, 5)]) * (2.0 / _ACROSS)
_ONES = np.ones(len(_SAMPLES))
_LINES_LIFT = 2e-3  # of the distance: a face must not eat its own edges
_EDGE_ON = 1e-3  # sine of the angle between a face and a line of sight
_YZX, _ZXY = [1, 2, 0], [2, 0, 1]

Spot: TypeAlias = tuple[float, float, float]
"""Pixels from the pane's left and bottom, and depth: negative behind the pane's camera."""


class PaneView(NamedTuple):
    eye: Array  # scene-local
    axes: Array  # rows: right, up and the direction of view
    slope: float  # tangent of half the vertical angle of view; 0 if parallel
    size_px: tuple[int, int]
    flat: float = 0.0  # half the height that a parallel camera sees, world units

    def unit(self, depth: Any) -> Any:
        """The size of a pixel in the world at a depth, a float or an array."""
        return 2.0 * (self.slope * depth + self.flat) / self.size_px[1]

    def moved_forward(self, point: Array, to_depth: float) -> tuple[float, Array]:
        """Bring a point to a smaller depth without moving its pixel.

        Returns the scale by which its surroundings shrink, and the new point.
        """
        depth = float(self.axes[2] @ (point - self.eye))
        if depth <= to_depth:
            return 1.0, point
        if self.flat:
            return 1.0, point - (depth - to_depth) * self.axes[2]
        scale = to_depth / depth
        return scale, (1.0 - scale) * self.eye + scale * point

    def seen(self, points: Array) -> list[Spot]:
        """Return where scene-local points, (n, 3), are in the pane."""
        width_px, height_px = self.size_px
        x, y, depth = self.axes @ (points - self.eye).T
        in_view = (depth > 0.0) | (self.flat > 0.0)  # parallel rays come from anywhere
        px = 1.0 / np.where(in_view, self.unit(depth), np.inf)
        spots = zip(
            (width_px / 2.0 + px * x).tolist(),
            (height_px / 2.0 + px * y).tolist(),
            depth.tolist(),
            strict=True,
        )
        return list(spots)

    def spots(self, points: Array) -> Array:
        """Return where points, (..., 3), are in the pane: pixels, (..., 2), NaN behind."""
        # As a plain matrix of points, which numpy multiplies several times as fast.
        x, y, depth = self.axes @ (points.reshape(-1, 3) - self.eye).T
        in_view = (depth > 0.0) | (self.flat > 0.0)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            px = np.where(in_view, 1.0 / self.unit(depth), np.nan)
            spots: Array = np.stack([px * x, px * y], axis=-1) + np.array(self.size_px) / 2.0
        return spots.reshape(*points.shape[:-1], 2)

    def outside_px(self, points: Array) -> float:
        """How far the farthest of these points, (n, 3), lies outside the pane; inf if behind."""
        middle = np.array(self.size_px) / 2.0
        beyond = np.abs(self.spots(points) - middle) - middle
        return max(0.0, float(np.where(np.isnan(beyond), np.inf, beyond).max()))

    def covered(self, face: Array) -> list[Spot]:
        """Return the evenly spread places of the pane that show a parallelogram, (4, 3)."""
        middle = (face[0] + face[2]) / 2.0 - self.eye
        across, up = (face[1] - face[0]) / 2.0, (face[3] - face[0]) / 2.0
        width_px, height_px = self.size_px
        rays = np.column_stack([_SAMPLES * (self.slope * width_px / height_px, self.slope), _ONES])
        # Cramer's rule for depth * ray = middle + s across + t up.
        spanned = np.stack([middle, across, up]) @ self.axes.T
        if self.flat:
            return self._covered_flat(spanned)
        scale = float(np.abs(spanned).max()) or 1.0  # a volume from afar would be beyond float64
        spanned /= scale
        # Row i is the cross product of the other two; much faster than numpy's own of one pair.
        after, before = spanned[_YZX], spanned[_ZXY]
        adjugate = after[:, _YZX] * before[:, _ZXY] - after[:, _ZXY] * before[:, _YZX]
        volume = float(spanned[0] @ adjugate[0])
        facing, s, t = adjugate @ rays.T
        largest = np.abs(facing)
        on = (facing * volume > 0.0) & (np.abs(s) <= largest) & (np.abs(t) <= largest)
        px = (_SAMPLES[on] + 1.0) / 2.0 * self.size_px
        return list(map(tuple, np.column_stack([px, scale * volume / facing[on]]).tolist()))

    def _covered_flat(self, spanned: Array) -> list[Spot]:
        """`covered` for a parallel camera; the middle and both half sides in its own axes."""
        middle, across, up = spanned
        area = across[0] * up[1] - across[1] * up[0]
        if abs(area) <= 1e-12 * float(np.abs(spanned[1:]).max()) ** 2:
            return []  # seen edge on
        width_px, height_px = self.size_px
        x, y = (_SAMPLES * (self.flat * width_px / height_px, self.flat) - middle[:2]).T
        s, t = (x * up[1] - y * up[0]) / area, (across[0] * y - across[1] * x) / area
        depth = middle[2] + s * across[2] + t * up[2]
        on = (np.abs(s) <= 1.0) & (np.abs(t) <= 1.0) & (depth > 0.0)
        px = (_SAMPLES[on] + 1.0) / 2.0 * self.size_px
        return list(map(tuple, np.column_stack([px, depth[on]]).tolist()))

    def parts_covered(self, faces: Array, least: float) -> list[float]:
        """Return the parts of the pane that parallelograms (4 n, 3) cover, 0 if below `least`."""
        parts, seen = [], self.seen(faces)
        for first in range(0, len(faces), 4):
            x, y, depth = zip(*seen[first : first + 4], strict=True)
            sides = zip((x, y), self.size_px, strict=True)
            # One sample more than fits, at most, in either direction.
            most = math.prod((max(s) - min(s)) / side_px + 1.0 / _ACROSS for s, side_px in sides)
            part = 0.0
            if min(depth) <= 0.0 or most >= least:
                part = len(self.covered(faces[first : first + 4])) / len(_SAMPLES)
            parts.append(part if part >= least else 0.0)
        return parts

    def slope_of_depth(self, face: Array, nearest: float, farthest: float) -> tuple[float, float]:
        """How depth in NDC changes along x and y of NDC on a plane, of which a face is (4, 3)."""
        normal = self.axes @ np.cross(face[1] - face[0], face[3] - face[0])
        wide, high = self.size_px
        per_ndc = normal[:2] * (self.slope or self.flat) * (wide / high, 1.0)
        if self.flat:
            per_ndc *= 2.0 / (farthest - nearest) / normal[2]
        else:
            away = normal @ self.axes @ (face.mean(axis=0) - self.eye)
            per_ndc *= 2.0 / (1.0 / nearest - 1.0 / farthest) / away
        x, y = (-per_ndc).tolist()
        return x, y

    def sees_edge_on(self, face: Array) -> bool:
        """Whether a face, (4, 3), is seen as a line."""
        normal = np.cross(face[1] - face[0], face[3] - face[0])
        sight = self.axes[2] if self.flat else face.mean(axis=0) - self.eye
        lengths = float(np.linalg.norm(normal) * np.linalg.norm(sight))
        return not abs(float(normal @ sight)) > _EDGE_ON * lengths

    def way_from(self, place: Array) -> Array:
        """Return the way from a place to the camera, homogeneous, for a step of length 1."""
        if self.flat:
            return np.array([*-self.axes[2], 0.0])
        return np.array([*self.eye, 1.0]) / math.dist(self.eye, place)

    def lifted(self, times: float) -> Array:
        """Nearer to the camera by a part of the distance, for lines on faces, (4, 4)."""
        lift = np.eye(4)
        if self.flat:
            lift[:3, 3] = -times * _LINES_LIFT * 2.0 * self.flat * self.axes[2]
            return lift
        lift[:3, :3] *= 1.0 - times * _LINES_LIFT
        lift[:3, 3] = times * _LINES_LIFT * self.eye
        return lift

    def sight(self, origin: Array, nearest: float) -> Sight:
        """How it looks at the world, of which this is the scene's origin, from a depth on."""
        width_px, height_px = self.size_px
        right, up, toward = self.axes
        rows = np.zeros((4, 4))
        px = height_px / (2.0 * (self.flat or self.slope))
        if self.flat:
            rows[3, 3] = 1.0
            rows[2, :3] = toward
        else:
            rows[3, :3] = toward
            rows[2, 3] = -1.0
        rows[0] = width_px / 2.0 * rows[3]
        rows[1] = height_px / 2.0 * rows[3]
        rows[0, :3] += px * right
        rows[1, :3] -= px * up
        return Sight(self.eye + origin, rows, np.array([(*toward, -nearest)]))


class Pose(NamedTuple):
    """Where a pane's own camera stands; it can be blended with that of another state."""

    focus: Array
    axes: Array  # right, up and toward what is looked at, the rows of a (3, 3)
    half_height: float  # half of the height that is seen at the focus
    distance: float
    slope: float  # tangent of half the angle of view; 0 for a parallel camera

    def is_near(self, other: "Pose") -> bool:
        """Whether another pose shows the same, but for rounding."""
        numbers, others = (
            np.hstack([pose.focus, pose.axes.ravel(), *pose[2:]]) for pose in (self, other)
        )
        return bool(np.allclose(numbers, others, rtol=1e-6, atol=1e-9))

    def towards(self, other: "Pose", part: float) -> "Pose":
        """Return the pose at a part of the way to another one, 0 to 1."""
        axes = self.axes @ rotation_between(other.axes.T @ self.axes, part).T
        one, end = max(self.slope, _FLATTEST), max(other.slope, _FLATTEST)
        slope = one ** (1.0 - part) * end**part if self.slope or other.slope else 0.0
        half = self.half_height ** (1.0 - part) * other.half_height**part
        distance = self.distance ** (1.0 - part) * other.distance**part
        focus = (1.0 - part) * self.focus + part * other.focus
        return Pose(focus, axes, half, half / slope if slope else distance, slope)


_LEAST_PART = 1e-12  # of the focus' coordinates, for the distance to it
_FLATTEST = 0.01  # slope of a camera that is hardly different from a parallel one


def axes_from(azimuth_deg: float, elevation_deg: float) -> Array:
    """Right, up and toward the reader of a camera at these angles, the rows of a (3, 3).

    The azimuth is counted from +z towards +x.
    """
    (cos_a, sin_a), (cos_e, sin_e) = cos_sin_deg(azimuth_deg), cos_sin_deg(elevation_deg)
    return np.array([
        (cos_a, 0.0, -sin_a),
        (-sin_e * sin_a, cos_e, -sin_e * cos_a),
        (sin_a * cos_e, sin_e, cos_a * cos_e),
    ])  # fmt: skip


def nearest_place(sights: Iterable[tuple[Array, Array]], least: float) -> Array:
    """Return the nearest place that sees all points, at least so far back: right, up, back, (3,).

    Each of `sights` has points, (3, n) in the view's axes, and how steeply they may be seen: left,
    right, down and up. A view looks along its third axis. From `back` behind the origin, a place to
    the right sees a point within its slopes if it lies between ``x - right * (toward + back)`` and
    ``x + left * (toward + back)``; likewise up. Each lower and each higher limit meet at a
    distance, and the largest of these decides. For a parallel view, `toward` is 0 and `back` half
    of its height.
    """
    limits = [
        (
            ((x + left * toward).min(), left, (x - right * toward).max(), right),
            ((y + down * toward).min(), down, (y - up * toward).max(), up),
        )
        for (x, y, toward), (left, right, down, up) in sights
    ]
    low, less, high, more = np.array(limits).T
    meet = (high[:, :, None] - low[:, None]) / (more[:, :, None] + less[:, None])
    back = max(least, float(meet.max()))
    middle = ((low + less * back).min(axis=1) + (high - more * back).max(axis=1)) / 2.0
    return np.append(middle, back)


class PaneCamera:
    """A pane's own camera, and whether the user has moved it."""

    def __init__(self, canvas: PropGroup) -> None:
        self._camera: vtkCamera = canvas.renderer.GetActiveCamera()
        self._window, self._em = canvas.window, canvas.style.font_size
        self._placed: tuple[float, ...] | None = None
        self._goal = vtkCamera()
        self.is_turned = False  # whether the way ends where the user has turned the camera

    @property
    def size_px(self) -> tuple[int, int]:
        width_px, height_px = self._window.GetSize()
        return max(1, width_px), max(1, height_px)

    @property
    def _now(self) -> tuple[float, ...]:
        camera = self._camera
        scale = camera.GetParallelScale() if camera.GetParallelProjection() else 0.0
        return (*camera.GetPosition(), *camera.GetFocalPoint(), scale)

    @property
    def was_moved(self) -> bool:
        return self._placed != self._now

    # -- on the way from one pose to another

    @property
    def pose(self) -> Pose:
        camera = self._camera
        distance = float(camera.GetDistance())
        slope, half = math.tan(math.radians(camera.GetViewAngle()) / 2.0), 0.0
        if camera.GetParallelProjection():
            slope, half = 0.0, float(camera.GetParallelScale())
        focus = np.array(camera.GetFocalPoint())
        return Pose(focus, axes_of(camera), half or slope * distance, distance, slope)

    def begin_glide(self, start: Pose) -> None:
        """Keep the present place as the goal of a way that begins at another pose.

        From a place so far away that rounding would put the eye on the focus, there is no way.
        """
        poses = (start, self.pose)
        farthest = max(float(np.abs(pose.focus).max()) for pose in poses)
        is_lost = min(pose.distance for pose in poses) < _LEAST_PART * farthest
        self._glide_from = self.pose if is_lost else start
        self.is_turned = self.was_moved
        self.keep_goal()

    def keep_goal(self) -> None:
        """Take the present place for the goal, after a window of another size has moved it."""
        self._goal.DeepCopy(self._camera)
        self._placed_at_goal = self._placed

    def go_to_goal(self) -> None:
        """Stand where the way ends."""
        self._camera.DeepCopy(self._goal)
        self._placed = self._placed_at_goal

    def glide(self, part: float) -> None:
        """Go to a part of the way from the start to where the camera stands now."""
        pose = self._glide_from.towards(self.pose, part)
        self._look_through(pose.slope, pose.half_height)
        self._stand_at(pose.focus - pose.distance * pose.axes[2], pose.focus, pose.axes[1])
        self._placed = self._now

    def _look_through(self, slope: float, half_height: float = 0.0) -> None:
        """See as steeply as `slope`; if that is 0, by parallel rays, half of this height."""
        self._camera.SetParallelProjection(not slope)
        if slope:
            self._camera.SetViewAngle(2.0 * math.degrees(math.atan(slope)))
        else:
            self._camera.SetParallelScale(half_height)

    def _stand_at(self, position: Array, focus: Array, up: ArrayLike = (0.0, 1.0, 0.0)) -> None:
        self._camera.SetPosition(*position)
        self._camera.SetFocalPoint(*focus)
        self._camera.SetViewUp(*np.asarray(up))
