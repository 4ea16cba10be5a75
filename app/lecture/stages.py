"""The stage strip's matrices of the scene and its view volume, at and between the stages.

The strip has six stops (`STOPS`). It shows each in its own *display* space, which is right-handed
and as large as the NDC pane's cube::

    display_from_local = display_from_stage . stage_from_local

`stage_from_local` is the pipeline's own matrix. `display_from_stage` only scales and shifts it into
the pane, and mirrors z of NDC, which is left-handed. Between two stops

=============================  ================================================================
world -> view                  first P moves the eye to the origin, then R rotates about it, or
                               done from the left first R, then P in the axes that R has turned;
                               the middle of the shown points stays where it is
view -> ... -> image           ``(1 - t) A + t B`` of the two homogeneous matrices, each scaled
                               such that w is 1 at the middle of the visible part
=============================  ================================================================

Both are matrices, so straight lines stay straight. Where w is positive at two stops, a point moves
between them on a straight line. A point that is inside the pane at both stops therefore stays
inside. The determinant keeps its sign, because z is already mirrored and never passes through a
flat picture.

The strip shows the whole scene up to the view stop. In the first half of the next step the planes
of the view volume close from outside (`planes_display`); from then on they clip the scene. This
removes the points that the perspective step would send to infinity or behind the eye.

The canonical volumes, M_pp and M_z are those of lecture 001. All matrices except the frames come
from `Projection`.
"""

import math
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from app.model.chain import Chain
from app.model.pipeline import translation
from app.model.projection import Array, Lens, Projection, Vector

STOPS = ("world", "view", "canonical_perspective", "canonical_parallel", "ndc", "image")
"""The strip's stops in order; a position is an index or a number between two indices."""
WORLD, VIEW, CANONICAL_PERSPECTIVE, CANONICAL_PARALLEL, NDC, IMAGE = range(len(STOPS))

REACHED_BY = (  # the matrix that leads to each stop: the first of these that the lens has
    ("world_from_object",),
    ("view_from_world",),
    ("canonical_perspective_from_view", "canonical_parallel_from_view"),
    ("canonical_parallel_from_canonical_perspective",),
    ("depth_range_from_canonical_parallel", "clip_from_view"),
    ("image_from_ndc",),
)
RADIUS = 1.3  # radius of the ball around the framed points at the first two stops, in display space
CLOSED_AT = VIEW + 0.5  # position at which the planes of the view volume are closed

_OPEN = 1.5 * RADIUS  # a plane at this distance from the middle clips nothing
_FARTHEST = 1e6  # an offset that stands for infinity
_SHOWN_DEPTHS = 2.5  # a frustum is framed to this many times the depth of the scene
_FLAT = 0.1  # depth of the picture relative to NDC, invisible from the front


@dataclass(frozen=True, eq=False)
class Morph:
    """The strip's matrices for one projection and one scene.

    - `origin`: world point that the scene's geometry is relative to; the eye is subtracted from it
      in float64.
    - `corners_world` (n, 3): corners of the bounding box of the drawing.
    - `from_left`: whether R comes before P.

    The *box* has x and y from -1 to 1 and z from 1 at near to 0 at far, the reversed depth range.
    There 1/w of the far face is near/far itself, which float32 can hold.
    """

    projection: Projection
    origin: Vector
    corners_world: Array
    from_left: bool = False
    _evens: dict[int, Array] = field(default_factory=dict, init=False)
    _boxes: dict[int, Array] = field(default_factory=dict, init=False)

    @property
    def _lens(self) -> Lens:
        return self.projection.lens

    # -- the pipeline's own

    def stage_from_local(self, stop: int) -> Array:
        """Return the pipeline's matrix up to a stop, for points relative to `origin`, (4, 4).

        Its results at the NDC and image stops are homogeneous coordinates before the divide.
        """
        if stop == WORLD:
            return np.eye(4)
        if stop >= NDC:
            clip = self.projection.clip_from_local(self.origin)
            return clip if stop == NDC else self.projection.image_from_ndc @ clip
        matrix: Array = self._view_from_local
        if stop >= CANONICAL_PERSPECTIVE:
            matrix = self._canonical[0] @ matrix
        if stop == CANONICAL_PARALLEL:
            matrix = self._canonical[1] @ matrix
        return matrix

    @cached_property
    def _view_from_local(self) -> Array:
        shift = translation(np.asarray(self.origin) - self.projection.camera.eye)
        return np.asarray(self.projection.view_rotation @ shift)

    @cached_property
    def _canonical(self) -> tuple[Array, Array]:
        """The matrix from view space to the lens' canonical volume, and M_pp."""
        first, m_pp, *_ = self.projection.lens_stages
        return first.matrix, m_pp.matrix

    # -- frames

    def display_from_stage(self, stop: int) -> Array:
        """Return the scale and shift of a stop into the pane, (4, 4), which mirrors NDC's z."""
        if stop <= VIEW:
            middle, scale = self._ball
            if stop == VIEW:
                middle = self._view_from_local[:3] @ [*middle, 1.0]
            return _scaled(scale) @ translation(-middle)
        if stop == CANONICAL_PERSPECTIVE:
            return translation(np.array([0.0, 0.0, 0.5])) @ _scaled(1.0 / self._reach)
        if stop == CANONICAL_PARALLEL:
            return translation(np.array([0.0, 0.0, 0.5]))
        z_near, z_far = self.projection.depth_range
        if stop == NDC:
            mirror = 1.0 if z_near > z_far else -1.0
            matrix = np.diag([1.0, 1.0, mirror, 1.0])
            matrix[2, 3] = -mirror * (z_near + z_far) / 2.0
            return matrix
        width, height = self.projection.image_size
        scale = 2.0 / max(width, height)
        # The viewport's depth is 0 at near and 1 at far, or the reverse.
        flat = _FLAT if z_near > z_far else -_FLAT
        matrix = np.diag([scale, -scale, flat, 1.0])
        matrix[:3, 3] = -scale * width / 2.0, scale * height / 2.0, -flat / 2.0
        return matrix

    @cached_property
    def _reach(self) -> float:
        """The shown depth of the canonical pyramid: 1, or the scene's depth for an infinite far."""
        if self._lens.far != math.inf:
            return 1.0
        depth = -float((self._local_corners @ self._view_from_local[2, :3]).min())
        depth -= float(self._view_from_local[2, 3])
        return max(2.0, depth / self._lens.near)

    @property
    def _local_corners(self) -> Array:
        return np.asarray(self.corners_world - np.asarray(self.origin))

    @cached_property
    def _ball(self) -> tuple[Array, float]:
        """Middle, relative to `origin`, and display scale of the first two stops."""
        lens = self._lens
        scene = self._local_corners
        eye = np.asarray(self.projection.camera.eye) - self.origin
        depth = max(float(np.abs(part - eye).max()) for part in scene)
        first, along = lens.edges(self._canonical_to_view)
        seen = []
        for corner, edge in zip(first, along, strict=True):
            limit = _SHOWN_DEPTHS * max(depth, float(np.abs(corner).max()))
            length = float(np.abs(edge).max())
            if length == math.inf:
                part = corner / np.abs(corner).max() * limit
            else:
                part = edge * min(1.0, limit / length)
            seen += [corner, corner + part]
        frustum = np.array(seen) @ self.projection.camera.frame + eye
        return _ball_of(np.vstack([scene, frustum, [eye]]))

    def _canonical_to_view(self, z: float) -> Array:
        """Return the view coordinates of the canonical volume's corners at a z, (4, 3)."""
        corners = np.array([(x, y) for y in (-1.0, 1.0) for x in (-1.0, 1.0)])
        stage = np.column_stack([corners, np.full(4, z), np.ones(4)])
        return np.asarray((stage @ self._view_from_canonical.T)[:, :3])

    @cached_property
    def _view_from_canonical(self) -> Array:
        """The inverse of the (triangular) first canonical stage."""
        (a, _, c, x), (_, b, d, y), (_, _, e, z), _ = self._canonical[0]
        inverse = np.diag([1.0 / a, 1.0 / b, 1.0 / e, 1.0])
        inverse[:2, 2] = -c / e / a, -d / e / b
        inverse[:3, 3] = (c * z / e - x) / a, (d * z / e - y) / b, -z / e
        return inverse

    @cached_property
    def _middle_depth(self) -> float:
        """Distance of the scene's middle, clamped to the view volume."""
        depth = -float(self._view_from_local[2] @ [*_middle_of(self._local_corners), 1.0])
        return min(max(depth, self._lens.near), self._lens.far)

    # -- what is shown at a position

    def stop_at(self, position: float) -> int:
        """Return the nearest stop, whose axes, letters and limits a position shows."""
        return int(position + 0.5)

    def axes_at(self, position: float) -> tuple[Array, Array]:
        """Return the eye (3,) and the camera's unit axes, rows of (3, 3), in display space."""
        camera, matrix = self.projection.camera, self.display_from_local(position)
        eye = matrix @ [*(np.array(camera.eye) - self.origin), 1.0]
        return _euclidean(eye), _units(matrix, camera.frame.T)

    def origin_at(self, position: float) -> Array:
        """Return where the stage's origin is shown up to the view stop, (3,).

        The scene moves in the stage's space, and display space has the same axes.
        """
        done = min(1.0, max(0.0, 2.0 * position - self.from_left))
        moved = done * np.array(self.projection.camera.eye)
        shown: Array = self.display_from_local(position) @ [*(moved - self.origin), 1.0]
        return shown[:3]

    def display_from_local(self, position: float) -> Array:
        """Return the scene's matrix at a position from 0 to 5, for points relative to `origin`.

        It is homogeneous: a common factor does not matter.
        """
        stop, part = _between(position)
        if part == 0.0:
            return self._display_stop(stop)
        if stop == WORLD:
            middle, _ = self._ball
            return np.asarray(self._turned(part) @ translation(-middle))
        return (1.0 - part) * self._even(stop) + part * self._even(stop + 1)

    def _display_stop(self, stop: int) -> Array:
        return np.asarray(self.display_from_stage(stop) @ self.stage_from_local(stop))

    def _even(self, stop: int) -> Array:
        """Return a stop's matrix with w = 1 at the middle of the visible part."""
        if stop not in self._evens:
            self._evens[stop] = self._display_stop(stop) * self._evening(stop)
        return self._evens[stop]

    def _evening(self, stop: int) -> float:
        if stop <= CANONICAL_PERSPECTIVE:
            return 1.0
        unit = 1.0 if stop >= NDC else float(self.projection.lens_stages[-1].exact[3][3])
        return float(unit / self._lens.w(self._middle_depth))

    def _turned(self, position: float) -> Array:
        """Return the turn towards the camera's axes, in its half of the way, with the scale."""
        matrix = np.eye(4)
        part = min(1.0, max(0.0, 2.0 * position - (not self.from_left)))
        matrix[:3, :3] = rotation_between(self.projection.camera.frame, part)
        return _scaled(self._ball[1]) @ matrix

    # -- the view volume at a position

    def display_from_box(self, position: float) -> Array:
        """Return the matrix of the view volume, from the box, at a position, (4, 4)."""
        stop, part = _between(position)
        if stop == WORLD:
            frame = np.eye(4)
            frame[:3, :3] = self.projection.camera.frame
            from_view = self._turned(part) @ frame.T
            middle = self._view_from_local[:3] @ [*self._ball[0], 1.0]
            return np.asarray(from_view @ translation(-middle) @ self._view_from_box)
        if part == 0.0:
            return self._box_stop(stop)
        return (1.0 - part) * self._box_at(stop) + part * self._box_at(stop + 1)

    def _box_at(self, stop: int) -> Array:
        """Return a stop's box matrix with the factor of `_even`."""
        if stop not in self._boxes:
            box, lens = self._box_stop(stop), self._lens
            if stop > CANONICAL_PERSPECTIVE:
                box = box * float(lens.w(lens.near) / lens.w(self._middle_depth))
            self._boxes[stop] = box
        return self._boxes[stop]

    @cached_property
    def _view_from_box(self) -> Array:
        return np.asarray(self._view_from_canonical @ self._lens.canonical_from_box)

    def _box_stop(self, stop: int) -> Array:
        if stop == VIEW:
            return np.asarray(self.display_from_stage(VIEW) @ self._view_from_box)
        if stop == CANONICAL_PERSPECTIVE:
            return np.asarray(self.display_from_stage(stop) @ self._lens.canonical_from_box)
        across, up, half = 1.0, 1.0, 0.5
        if stop == NDC:
            z_near, z_far = self.projection.depth_range
            half = abs(z_far - z_near) / 2.0
        elif stop == IMAGE:
            width, height = self.projection.image_size
            across, up, half = width / max(width, height), height / max(width, height), _FLAT / 2.0
        box = np.diag([across, up, 2.0 * half, 1.0])
        box[2, 3] = -half
        return box

    def planes_display(self, position: float) -> Array:
        """Return the six planes that clip the scene, in display space, (6, 4).

        The order is left, right, bottom, top, far, near. A row has the unit normal inwards and the
        offset; ``normal . point + offset >= 0`` inside. The planes are open up to the view stop and
        closed from `CLOSED_AT` on.
        """
        box_planes = np.array(
            [[1, 0, 0, 1], [-1, 0, 0, 1], [0, 1, 0, 1], [0, -1, 0, 1], [0, 0, 1, 0], [0, 0, -1, 1]],
            dtype=np.float64,
        )
        if position <= VIEW:
            opened = box_planes.copy()
            opened[4:] = (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, -1.0, 0.0)
            opened[:, 3] = _FARTHEST
            return opened
        box = self.display_from_box(position)
        planes = box_planes @ self._inverse(box / np.abs(box).max())  # or |det| underflows
        open_part = max(0.0, (CLOSED_AT - position) / (CLOSED_AT - VIEW))
        for i, plane in enumerate(planes):
            plane /= np.abs(plane).max()
            length = math.hypot(*plane[:3])
            if length * _FARTHEST <= abs(plane[3]):  # at infinity
                plane[:3] = (0.0, 0.0, 1.0 if i == 4 else -1.0) if i >= 4 else box_planes[i, :3]
                plane[3] = math.copysign(_FARTHEST, plane[3])
            else:
                plane /= length
            opened_to = max(_OPEN, float(plane[3]))
            plane[3] += open_part * (opened_to - plane[3])
        return planes

    def _inverse(self, box: Array) -> Array:
        return _positive_inverse(box)

    def has_volume(self, position: float) -> bool:
        """Whether there is a view volume to show, and to clip the scene, at a position."""
        return True


class FreeMorph(Morph):
    """The strip's matrices for a free matrix, which has no canonical volumes.

    The way from the view stop to NDC is one step. A matrix without inverse, or whose volume reaches
    infinity or lies behind the eye, has no view volume to clip the scene. For such a matrix the
    strip jumps from the view stop to NDC halfway.
    """

    def stage_from_local(self, stop: int) -> Array:
        return super().stage_from_local(VIEW if VIEW < stop < NDC else stop)

    @cached_property
    def _view_from_local(self) -> Array:
        view_from_eye = np.array(self.projection.exact_from_eye[0], dtype=np.float64)
        shift = translation(np.asarray(self.origin) - self.projection.camera.eye)
        return np.asarray(view_from_eye @ shift)

    @cached_property
    def _local_from_box(self) -> Array | None:
        if self.projection.frustum_sign <= 0:
            return None
        return self.projection.with_depth("reversed").world_from_clip_at(self.origin)

    @cached_property
    def _framed(self) -> Array:
        """The points framed at the first two stops: the scene, the eye and a part of the volume."""
        scene = self._local_corners
        eye = np.asarray(self.projection.camera.eye) - self.origin
        points = np.vstack([scene, [eye]])
        if self._local_from_box is None:
            return points
        size = _SHOWN_DEPTHS * max(float(np.abs(part - eye).max()) for part in scene)
        cube = np.array([(x, y, z, 1.0) for z in (0, 1) for y in (-1, 1) for x in (-1, 1)])
        corners = cube @ self._local_from_box.T
        away = corners[:, :3] / corners[:, 3:] - eye
        away *= np.minimum(1.0, size / np.maximum(np.abs(away).max(axis=1, keepdims=True), 1e-300))
        return np.vstack([points, eye + away])

    @cached_property
    def _ball(self) -> tuple[Array, float]:
        return _ball_of(self._framed)

    def display_from_stage(self, stop: int) -> Array:
        if stop != VIEW or self.projection.has_camera:  # the world rotates into it
            return super().display_from_stage(stop)
        framed = np.column_stack([self._framed, np.ones(len(self._framed))])
        seen = framed @ self._view_from_local.T
        seen = seen[seen[:, 3] > 0.0]
        middle, scale = _ball_of(seen[:, :3] / seen[:, 3:]) if len(seen) else (np.zeros(3), 1.0)
        return np.asarray(_scaled(scale) @ translation(-middle))

    def _evening(self, stop: int) -> float:
        stage = self.stage_from_local(stop if stop < NDC else NDC)
        w = float(stage[3] @ [*_middle_of(self._local_corners), 1.0])
        return 1.0 / w if w > 0.0 else 1.0

    def display_from_local(self, position: float) -> Array:
        position = self._jumped(position)
        if position == WORLD or position >= NDC or (position < VIEW and self.projection.has_camera):
            return super().display_from_local(position)
        if position < VIEW:
            return (1.0 - position) * self._even(WORLD) + position * self._even(VIEW)
        part = (position - VIEW) / (NDC - VIEW)
        return np.asarray((1.0 - part) * self._even(VIEW) + part * self._even(NDC))

    def display_from_box(self, position: float) -> Array:
        position = self._jumped(position)
        if position < NDC:
            assert self._local_from_box is not None
            return np.asarray(self.display_from_local(position) @ self._local_from_box)
        part = position - NDC
        z_near, z_far = self.projection.depth_range
        clip_from_box = np.diag([1.0, 1.0, z_near - z_far, 1.0])
        clip_from_box[2, 3] = z_far
        cube, picture = self.display_from_stage(NDC), self.display_from_stage(IMAGE)
        mixed = (1.0 - part) * cube + part * (picture @ self.projection.image_from_ndc)
        return np.asarray(mixed @ clip_from_box)

    def planes_display(self, position: float) -> Array:
        return super().planes_display(self._jumped(position))

    def has_volume(self, position: float) -> bool:
        return self._local_from_box is not None or self._jumped(position) >= NDC

    def stop_at(self, position: float) -> int:
        stop = super().stop_at(position)
        if VIEW < stop < NDC:
            stop = VIEW if position < (VIEW + NDC) / 2.0 else NDC
        return stop

    def axes_at(self, position: float) -> tuple[Array, Array]:
        if self.projection.has_camera or position < VIEW:
            return super().axes_at(position)
        # View space itself: its matrix need not be the camera's.
        return _euclidean(self.display_from_stage(VIEW)[:, 3]), np.eye(3)

    def _jumped(self, position: float) -> float:
        if self._local_from_box is None and VIEW < position < NDC:
            return float(VIEW if position < (VIEW + NDC) / 2.0 else NDC)
        return position

    def _inverse(self, box: Array) -> Array:
        # A mirrored volume is flat for a moment, and then has no inverse.
        flat = abs(float(np.linalg.det(box))) < 1e-290
        return np.asarray(np.linalg.inv(box + 1e-9 * np.eye(4) if flat else box), np.float64)


def standing_at(
    projection: Projection, position: float, *, from_left: bool = False
) -> tuple[Projection, tuple[Chain, ...]]:
    """Return the projection whose object has made only its first moves, and the stops beside it.

    The position is below 0: there are the moves before the world's stop, which has made them all.
    """
    chain, count = projection.placement, len(projection.placement.on)
    moves = max(count + position, 0.0)
    stops = sorted({math.ceil(moves) - 1, math.floor(moves) + 1} & {*range(count + 1)})
    beside = tuple(chain.after(stop, from_left=from_left) for stop in stops)
    return replace(projection, placement=chain.after(moves, from_left=from_left)), beside


def morph_of(projection: Projection, origin: Vector, corners: Array, from_left: bool) -> Morph:
    kind = Morph if projection.lens.has_steps else FreeMorph
    return kind(projection, origin, corners, from_left)


def _euclidean(point: Array) -> Array:
    """Divide a point (4,) by its w if that is positive; return (3,)."""
    return np.asarray(point[:3] / (point[3] if point[3] > 0.0 else 1.0))


def _units(matrix: Array, axes: Array) -> Array:
    """Transform the columns of (3, 3) by a matrix; return them as rows of length 1."""
    turned = matrix[:3, :3] @ axes
    return np.asarray((turned / np.linalg.norm(turned, axis=0)).T)


def _ball_of(points: Array) -> tuple[Array, float]:
    """Return the middle of points, and the scale at which they fill the framed ball."""
    middle = _middle_of(points)
    return middle, RADIUS / max(math.hypot(*point) for point in points - middle)


def _middle_of(points: Array) -> Array:
    return np.asarray(points.min(axis=0) / 2.0 + points.max(axis=0) / 2.0)


def rotation_between(frame: Array, part: float) -> Array:
    """Return a part of the rotation whose rows are an orthonormal right-handed frame, (3, 3).

    It turns about the same axis by `part` of the angle, which is at most 180 degrees (Shoemake
    1985, spherical linear interpolation from the identity).
    """
    if part == 1.0:
        return frame
    # Shepperd 1978: start from the largest of the four squares to avoid cancellation.
    diagonal = np.diag(frame)
    squares = np.array([frame.trace(), *diagonal])
    largest = int(squares.argmax())
    skew = (frame - frame.T)[[2, 0, 1], [1, 2, 0]]
    if largest == 0:
        quaternion = np.array([1.0 + squares[0], *skew])
    else:
        i = largest - 1
        quaternion = np.array([skew[i], *(frame[i] + frame[:, i])])
        quaternion[largest] = 1.0 + 2.0 * diagonal[i] - squares[0]
    if quaternion[0] < 0.0:
        quaternion = -quaternion
    length = math.hypot(*quaternion[1:])
    if length == 0.0:
        return np.eye(3)
    angle = part * 2.0 * math.atan2(length, quaternion[0])
    x, y, z = quaternion[1:] / length
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    versine = 2.0 * math.sin(angle / 2.0) ** 2
    return np.asarray(np.eye(3) + math.sin(angle) * cross + versine * (cross @ cross))


def _positive_inverse(matrix: Array) -> Array:
    """Return the inverse of ``[[a, 0, p, q], [0, b, s, u], [0, 0, 2x2]]`` times the 2x2's |det|.

    A positive factor changes no plane, and near/far can be too small for a division.
    """
    (a, _, p, q), (_, b, s, u), (_, _, zz, zw), (_, _, wz, ww) = matrix
    det = zz * ww - zw * wz
    sign = math.copysign(1.0, det)
    depth, w = sign * np.array([0, 0, ww, -zw]), sign * np.array([0, 0, -wz, zz])
    x = (np.array([abs(det), 0, 0, 0]) - p * depth - q * w) / a
    y = (np.array([0, abs(det), 0, 0]) - s * depth - u * w) / b
    return np.array([x, y, depth, w])


def _between(position: float) -> tuple[int, float]:
    """Return the stop at or before a position, and the part of the way to the next."""
    stop = min(int(position), IMAGE)
    return stop, position - stop


def _scaled(factor: float) -> Array:
    return np.diag([factor, factor, factor, 1.0])
