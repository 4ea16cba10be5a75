"""The construction of the camera's frame: look, up, n, u, v and their right angles.

Created on first use. All but up is fixed in view space; up has a matrix of its own, a turn about
u. A step of the panel changes visibilities, a slider step sets the two matrices. The object's own
axes, the columns of `world_from_object`, are here as well.
"""

import math
from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings import actors
from app.drawings.actors import Space, put_in_front
from app.drawings.label_placement import HEAD, HEAD_RADIUS
from app.drawings.prop_group import PropGroup
from app.lecture.camera_frame import STEPS, up_and_view
from app.lecture.highlight import OBJECT_AXES
from app.model.projection import Array, Camera

TIPS = {"v": (0.0, 2.0, 0.0), "n": (0.0, 0.0, 2.6), "u": (2.0, 0.0, 0.0)}
"""Of the axes in view space, in sizes of the camera's body."""
LARGER = 3.2
"""How much larger they are while they are built step by step: a third of the pane, to be seen from
the back row."""
DIMMED = 0.22  # opacity of everything else meanwhile

PART_OF_PANE = 1.0 / 12.0  # share of the shorter side for the camera's body
SIX_WAYS = np.vstack([np.eye(3), -np.eye(3)])

# The corners of a box round the camera's body, in view space and sizes of the body.
BODY_BOX = actors.CUBE_CORNERS * (0.6, 0.58, 0.7) + (0.0, 0.16, 0.7)
# The diameter of a ball round it, and how far its nearest point can be before the eye.
BALL = 2.0 * float(np.linalg.norm((0.6, 0.58, 0.7)))
BEFORE = BALL / 2.0 + float(np.linalg.norm((0.0, 0.16, 0.7)))
AROUND = 3.1  # body and axes are within this distance of the eye

_RIGHT_ANGLES = {"u": ("up-u", "u-n"), "v": ("v-n", "v-u"), "view": ("u-n", "v-n", "v-u")}
"""The right angles that a step shows, between the arrows that it is about."""
_UP, _LOOK = 2.7, (0.0, 0.0, -2.6)
_PART_OF_SCENE = 0.6  # of its size: the object's axes are no longer
_SQUARE = 0.55  # side of a right angle's mark


class FrameSteps:
    def __init__(self, canvas: PropGroup) -> None:
        self._canvas, style = canvas, canvas.style
        self._space, self._up_space = Space(), Space()
        width = style.line_width
        up, look = np.array([0.0, _UP, 0.0]), np.array(_LOOK)
        self.up, up_head = arrow(up, style.accent, 1.5 * width)
        self.look, look_head = arrow(look, style.target, 1.5 * width)
        u, v, n = np.eye(3)
        self._squares = {
            "up-u": _right_angle(u, v, style.ink, width),  # v is up under up's own matrix
            "u-n": _right_angle(u, n, style.ink, width),
            "v-n": _right_angle(v, n, style.ink, width),
            "v-u": _right_angle(v, u, style.ink, width),
        }
        self._shown_from = {"look": [self.look, look_head], "up": [self.up, up_head]}
        self._up_space.add(self.up, up_head, self._squares["up-u"])
        self._space.add(self.look, look_head, *(self._squares[n] for n in _RIGHT_ANGLES["view"]))
        for made in (*self._shown_from.values(), self._squares.values()):
            canvas.add(*made, layer="camera")

    def show(self, step: int | None) -> None:
        """Show the arrows up to a step, 0 to ``len(STEPS) - 1``; nothing for None."""
        for name, made in self._shown_from.items():
            self._canvas.set_visible(is_built(name, step), *made)
        marked = () if step is None else _RIGHT_ANGLES.get(STEPS[step], ())
        for name, square in self._squares.items():
            self._canvas.set_visible(name in marked, square)

    def place(self, pane_from_body: Array, camera: Camera) -> None:
        """Stand at the camera; (4, 4), from view space in sizes of the camera's body."""
        self._space.set(pane_from_body)
        y, z = _up_direction(camera)
        turn = np.eye(4)
        turn[1:3, 1:3] = [[y, -z], [z, y]]
        self._up_space.set(pane_from_body @ turn)


def is_built(name: str, step: int | None) -> bool:
    return step is not None and STEPS.index(name) <= step


def arrow_tips(step: int, camera: Camera) -> dict[str, tuple[float, float, float]]:
    """Return the tips of a step's arrows in view space, in sizes of the camera's body."""
    y, z = _up_direction(camera)
    tips = {**TIPS, "up": (0.0, _UP * y, _UP * z), "look": _LOOK}
    return {name: tip for name, tip in tips.items() if is_built(name, step)}


def _up_direction(camera: Camera) -> tuple[float, float]:
    """The components of up along v and along n; it has none along u."""
    angle = math.radians(up_and_view(camera).angle_deg)
    return math.sin(angle), -math.cos(angle)


def arrow(tip: Array, colour: str, width: float) -> tuple[vtkActor, vtkActor]:
    """Return a line from the origin along an axis, and its pointed head."""
    neck, radius = (1.0 - HEAD) * tip, HEAD_RADIUS * float(np.linalg.norm(tip))
    along = tip / np.linalg.norm(tip)
    one, two = np.roll(along, 1), np.roll(along, 2)
    angles = np.arange(12) * (2.0 * math.pi / 12)
    ring = neck + radius * (np.outer(np.cos(angles), one) + np.outer(np.sin(angles), two))
    faces = [(0, 1 + i, 1 + (i + 1) % 12) for i in range(12)] + [tuple(range(12, 0, -1))]
    shaft = actors.line_actor(np.stack([0.0 * tip, neck]), [(0, 1)], colour, width)
    return shaft, actors.face_actor(np.vstack([tip, ring]), faces, colour)


def _right_angle(one: Array, other: Array, colour: str, width: float) -> Any:
    """A small square at the origin, between two axes."""
    points = _SQUARE * np.stack([one, one + other, other])
    return actors.line_actor(points, [(0, 1, 2)], colour, width)


class ObjectAxes:
    """Three arrows, each along a column and `reach` times as long.

    `reach` is a round number, so that the arrows come out of the object. `shafts` and `colours` are
    mappings by `OBJECT_AXES`' names.
    """

    def __init__(self, canvas: PropGroup, size: float) -> None:
        style = canvas.style
        self.reach = axes_reach(size)
        self._space = Space()
        self._local_from_object = np.eye(4)
        self.shafts: dict[str, vtkActor] = {}
        self._actors: list[vtkActor] = []
        self.colours = dict(zip(OBJECT_AXES, (style.u, style.v, style.n), strict=False))
        for tip, (name, colour) in zip(self.reach * np.eye(3), self.colours.items(), strict=True):
            shaft, head = arrow(tip, colour, 1.5 * style.line_width)
            self.shafts[name] = shaft
            for actor in (shaft, head):
                self._space.add(actor)
                put_in_front(actor)  # most of it is inside the object
                self._actors.append(actor)
        canvas.add(*self._actors)

    def show(self, local_from_object: Array, shown: bool) -> None:
        self._local_from_object = local_from_object
        self._space.set(local_from_object)
        for actor in self._actors:
            actor.SetVisibility(shown)

    @property
    def origin(self) -> Array:
        """The object's origin, scene-local, (3,)."""
        return np.asarray(self._local_from_object[:3, 3])

    @property
    def ends(self) -> Array:
        """The tips of the axes, scene-local, (3, 3), one axis a row."""
        return np.asarray(self.origin + self.reach * self._local_from_object[:3, :3].T)


def axes_reach(size: float) -> float:
    """Return the largest of 1, 2, 5, 10, ... below a part of a scene's size."""
    most = _PART_OF_SCENE * size
    unit = 10.0 ** math.floor(math.log10(most))
    return next(k * unit for k in (5.0, 2.0, 1.0) if k * unit <= most * (1.0 + 1e-12))
