"""The model's camera in the world pane: its body, eye, target, line of sight and axes.

Eye, target and axes are shrunk towards the pane's own camera: they keep their pixels but stand
before everything that would hide them.
"""

from __future__ import annotations

from functools import partial
from typing import NamedTuple

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings import actors
from app.drawings.actors import PropGroup, Space, applied
from app.drawings.frame import LARGER, TIPS, FrameSteps, arrow, arrow_tips, is_built
from app.drawings.names import Names
from app.drawings.pane_view import PaneView
from app.drawings.pointing import FACES, FAR_FACE, NEAR_FACE
from app.lecture.highlight import AXES, SIDES
from app.model.projection import Array, Camera

_PART_OF_PANE = 1.0 / 12.0  # share of the shorter side for the camera's body
SIX_WAYS = np.vstack([np.eye(3), -np.eye(3)])

# The corners of a box round the camera's body, in view space and sizes of the body.
_BODY_BOX = actors.CUBE_CORNERS * (0.6, 0.58, 0.7) + (0.0, 0.16, 0.7)
# The diameter of a ball round it, and how far its nearest point can be before the eye.
_BALL = 2.0 * float(np.linalg.norm((0.6, 0.58, 0.7)))
_BEFORE = _BALL / 2.0 + float(np.linalg.norm((0.0, 0.16, 0.7)))
_AROUND = 3.1  # body and axes are within this distance of the eye
AROUND_PX = _AROUND / _BALL * _PART_OF_PANE
"""How far body and axes reach from the eye, of the pane's shorter side."""

_BODY_REACH, _WITH_NAMES = 0.6, 1.25  # of that: without axes; with their names beyond the tips

_WALLS = tuple(FACES[side] for side in SIDES)


class CameraPose(NamedTuple):
    """How the model's camera stands in a scene; scene-local, world units."""

    camera: Camera
    origin: Array  # world point that scene-local coordinates are relative to
    eye: Array
    target: Array
    view_from_local: Array
    local_from_view: Array
    depths: tuple[float, float]  # least and largest distance of anything from the eye plane
    objects_depth: float  # the largest one of the scene's objects
    extent: float  # the scene's size plus its distance


class CameraDrawing:
    """The camera as an object in the world.

    Attributes
    ----------
    solid : tuple of vtkActor
        The body, `body_size` large in world units.
    shafts, discs : mapping from str to vtkActor
        The axes' lines; the dots at eye and target.
    steps : FrameSteps or None
        What the frame's construction adds; None before it is first shown.
    """

    def __init__(self, canvas: PropGroup) -> None:
        self._canvas = canvas
        style, add = canvas.style, partial(canvas.add, layer="camera")
        width = style.line_width
        self._body_space, self._sight_space, self._axes_space = Space(), Space(), Space()
        self._eye_space, self._target_space, self._rim_space = Space(), Space(), Space()

        self._sight = actors.line_actor([(0, 0, 0), (0, 0, -1)], [(0, 1)], style.muted, width)
        self._sight_space.add(self._sight)
        points, faces, edges = _camera_body()
        body = actors.face_actor(points, faces, style.muted)
        wire = actors.line_actor(points, edges, style.eye, width)
        self.solid = body, wire
        self._body_space.add(body, wire)
        eye = actors.point_actor([(0, 0, 0)], style.eye, 3.75 * width)
        target = actors.point_actor([(0, 0, 0)], style.target, 4.5 * width)
        rim = actors.point_actor([(0, 0, 0)], style.ink, 6.0 * width)
        self.discs = {"eye": eye, "target": target}
        self._eye_space.add(eye)
        self._target_space.add(target)
        self._rim_space.add(rim)
        add(self._sight, body, wire, eye, rim, target)

        self.shafts: dict[str, vtkActor] = {}
        self._heads: dict[str, vtkActor] = {}
        for axis, tip in TIPS.items():
            shaft, head = arrow(np.array(tip), getattr(style, axis), 1.5 * width)
            self._axes_space.add(shaft, head)
            self.shafts[axis], self._heads[axis] = shaft, head
            add(shaft, head)
        self._target_parts = rim, target
        self.steps: FrameSteps | None = None
        self.step: int | None = None
        self._named: frozenset[str] = frozenset()
        self.axes_lead = False
        """Whether the axes are what the picture is about."""
        self._show_parts()

    def show(self, standing: CameraPose) -> None:
        """Place the camera; `follow` then sets its size."""
        self._standing = standing
        self._sight_space.set(_scaled(standing.local_from_view, standing.camera.distance))

    def follow(self, pane: PaneView) -> None:
        """Scale the body to a twelfth of the pane, however near it is: it is a symbol."""
        eye = self._standing.eye
        most_px = _PART_OF_PANE * min(pane.size_px)
        depth = max(float(pane.axes[2] @ (eye - pane.eye)), 1e-6 * self._standing.extent)
        growing = most_px * (pane.unit(1.0) - pane.unit(0.0))  # for parts nearer than the eye
        self.body_size = most_px * float(pane.unit(depth)) / (_BALL + _BEFORE * float(growing))
        self._local_from_body = _scaled(self._standing.local_from_view, self.body_size)
        self._body_space.set(self._local_from_body)

    def show_step(self, step: int | None) -> None:
        """Build the frame up to a step of `app.lecture.camera_frame.STEPS`; None for all of it."""
        self.step = step
        if self.steps is None:
            self.steps = FrameSteps(self._canvas)
        self.steps.show(step)
        self._show_parts()

    def show_names(self, names: Names) -> None:
        """Show the axes and the target that are named."""
        named = frozenset(name for name in (*AXES, "target") if name in names)
        if names.wanted is not None and "frame-e" in names:
            named |= set(AXES)
        self.axes_lead = names.wanted is not None and names.wanted.issuperset(AXES)
        if named != self._named:
            self._named = named
            self._show_parts()

    def _show_parts(self) -> None:
        for axis, shaft in self.shafts.items():
            for actor in (shaft, self._heads[axis]):
                self._canvas.set_visible(actor, self._shows(axis))
        for actor in (*self._target_parts, self._sight):
            self._canvas.set_visible(actor, self.shows_target)

    def _shows(self, axis: str) -> bool:
        return axis in self._named if self.step is None else is_built(axis, self.step)

    @property
    def shows_target(self) -> bool:
        return "target" in self._named or is_built("look", self.step)

    @property
    def arrows(self) -> tuple[tuple[str, ...], Array]:
        """The names of the visible arrows, and the vectors from the eye to their tips."""
        directions = np.array(list(self._tips.values())).reshape(-1, 3)
        return tuple(self._tips), self.axes_size * directions @ self._standing.camera.frame

    @property
    def has_arrows(self) -> bool:
        return bool(self._tips)

    @property
    def _tips(self) -> dict[str, tuple[float, float, float]]:
        if self.step is None:
            return {a: TIPS[a] for a in AXES if a in self._named}
        return arrow_tips(self.step, self._standing.camera)

    @property
    def axes_size(self) -> float:
        """The unit of the axes, world units."""
        return self.body_size * self._enlarged

    @property
    def _enlarged(self) -> float:
        return LARGER if self.step is not None or self.axes_lead else 1.0

    @property
    def reach(self) -> float:
        """How far the visible parts reach from the eye, relative to axes that do not lead."""
        if self.axes_lead:
            return _WITH_NAMES * self._enlarged
        return self._enlarged if self._tips else _BODY_REACH

    @property
    def box(self) -> Array:
        return applied(self._local_from_body, _BODY_BOX)

    @property
    def around(self) -> Array:
        return self._standing.eye + _AROUND * self.axes_size * SIX_WAYS

    def depths(self, pane: PaneView) -> tuple[float, float, float]:
        """Return the distances of eye, target and axes from the pane's camera."""
        eye, target = self._standing.eye, self._standing.target
        toward = pane.axes[2]
        eye_depth, target_depth = (float((p - pane.eye) @ toward) for p in (eye, target))
        # The axes are brought before the body, see `come_before`.
        return eye_depth, target_depth, eye_depth - 5.4 * self.axes_size

    def move_forward(self, pane: PaneView, depths: tuple[float, float, float], near: float) -> None:
        """Bring eye, target and axes before what would hide them.

        `depths` are those of the method; `near` is the depth from which on the pane's camera sees.
        """
        standing = self._standing
        eye, target = standing.eye, standing.target
        for space, point, on_top in (
            (self._eye_space, eye, 1.01),
            (self._target_space, target, 1.02),
            (self._rim_space, target, 1.03),
        ):
            space.place(*pane.moved_forward(point, on_top * near))
        k, at = pane.moved_forward(eye, max(near, depths[0] - 2.8 * self.axes_size))
        pane_from_axes = _scaled(standing.local_from_view, k * self.axes_size)
        pane_from_axes[:3, 3] = at
        self._axes_space.set(pane_from_axes)
        if self.step is not None and self.steps is not None:
            self.steps.place(pane_from_axes, standing.camera)


def view_matrices(camera: Camera, origin: Array) -> tuple[Array, Array]:
    """View from scene-local coordinates and back, both (4, 4); the eye is subtracted first."""
    eye = np.array(camera.eye) - origin
    view_from_local, local_from_view = np.identity(4), np.identity(4)
    view_from_local[:3, :3], view_from_local[:3, 3] = camera.frame, camera.frame @ -eye
    local_from_view[:3, :3], local_from_view[:3, 3] = camera.frame.T, eye
    return view_from_local, local_from_view


def _camera_body() -> tuple[Array, list[tuple[int, ...]], list[tuple[int, ...]]]:
    """A box with a lens hood and a viewfinder, in view space, the eye in the hood's mouth.

    Returns the points (n, 3), the faces and the edges.
    """
    points: list[tuple[float, float, float]] = []
    faces: list[tuple[int, ...]] = []
    edges: list[tuple[int, ...]] = []
    sections = (
        ((0.4, 0.3, 0.0), (0.2, 0.15, 0.5)),  # hood: half width, half height, distance behind
        ((0.6, 0.42, 0.5), (0.6, 0.42, 1.4)),  # box
    )
    for front, back in sections:
        first = len(points)
        for half_width, half_height, z in (front, back):
            points += [
                (sx * half_width, sy * half_height, z)
                for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1))
            ]
        quads = [*_WALLS, FAR_FACE] if not faces else [NEAR_FACE, *_WALLS, FAR_FACE]
        faces += [tuple(first + i for i in quad) for quad in quads]
        edges += [tuple(first + i for i in line) for line in actors.CUBE_EDGES]
    first = len(points)
    for z in (0.65, 1.25):
        points += [(-0.3, 0.42, z), (0.3, 0.42, z), (0.0, 0.75, z)]
    prism = [(0, 1, 2), (3, 4, 5), (0, 2, 5, 3), (1, 2, 5, 4)]
    faces += [tuple(first + i for i in face) for face in prism]
    edges += [tuple(first + i for i in line) for line in ((0, 1, 2, 0), (3, 4, 5, 3), (2, 5))]
    return np.array(points), faces, edges


def _scaled(local_from_view: Array, size: float) -> Array:
    matrix = local_from_view.copy()
    matrix[:3, :3] *= size
    return matrix
