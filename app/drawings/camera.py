"""The model's camera in the world pane: its body, eye, target, line of sight and axes.

Eye, target and axes are shrunk towards the pane's own camera: they keep their pixels but stand
before everything that would hide them.
"""

from functools import partial
from itertools import compress

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings import actors, frame
from app.drawings.actors import Space, applied
from app.drawings.label_placement import Ground
from app.drawings.labels import DOT_EM, EYE, TARGET, vector
from app.drawings.layer import Layer
from app.drawings.pointing import FACES, FAR_FACE, NEAR_FACE
from app.drawings.style import Style
from app.drawings.world_state import WorldState
from app.lecture.camera_frame import STEPS
from app.lecture.highlight import AXES, SIDES
from app.model.projection import Array

_LINE_EM = 0.14  # the width of the lines round the body
_WITH_NAMES = 1.25  # of axes that lead: with their names beyond the tips

_WALLS = tuple(FACES[side] for side in SIDES)


class CameraDrawing(Layer):
    """The camera as an object in the world.

    - `solid`: the body, `body_size` large in world units, with the corners `box`, (8, 3).
    - `shafts`, `discs`: the axes' lines; the dots at eye and target.
    - `steps`: what the frame's construction adds; None before it is first shown.
    """

    follows = ("standing",)

    def __init__(self, state: WorldState) -> None:
        self._state, self._canvas = state, state.canvas
        style, add = state.style, partial(state.canvas.add, layer="camera")
        width = style.line_width
        self._body_space, self._sight_space, self._axes_space = Space(), Space(), Space()
        self._eye_space, self._target_space, self._rim_space = Space(), Space(), Space()

        self._sight = actors.line_actor([(0, 0, 0), (0, 0, -1)], [(0, 1)], style.muted, width)
        self._sight_space.add(self._sight)
        self.solid = body, wire = camera_body(style)
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
        for axis, tip in frame.TIPS.items():
            shaft, head = frame.arrow(np.array(tip), getattr(style, axis), 1.5 * width)
            self._axes_space.add(shaft, head)
            self.shafts[axis], self._heads[axis] = shaft, head
            add(shaft, head)
        self._target_parts = rim, target
        self.steps: frame.FrameSteps | None = None
        self._named: frozenset[str] = frozenset()
        self.axes_lead = False  # whether the axes are what the picture is about
        self._show_parts()
        self._followed: tuple[object, object] = None, None
        self._settled: tuple[float, float, int | None] | None = None
        self._make_emphasis()

    def _make_emphasis(self) -> None:
        emphasis = self._state.emphasis
        for name, line in self.shafts.items():
            emphasis.line(line, name, of=(name, "frame-e"))
        for solid in self.solid:
            emphasis.line(solid, of=("eye", "frame-e"))
        for name, disc in self.discs.items():
            emphasis.point(disc, name)
        for name in ("eye", "target", *AXES):
            self._name_arrow(name, name, getattr(self._state.style, name))

    def _name_arrow(self, key: str, name: str, colour: str) -> None:
        """Create the label of a point or an arrow, which is underlined with `name`."""
        word = self._state.words[key]
        text = word if key in self.discs else vector(word)
        self._state.emphasis.label(self._state.board.label(key, text, colour), name)

    def show(self) -> None:
        standing = self._state.standing
        self._sight_space.set(_scaled(standing.local_from_view, standing.camera.distance))

    def follow(self) -> None:
        """Scale the body to a twelfth of the pane, however near it is: it is a symbol."""
        pane, standing = self._state.own.pane, self._state.standing
        if pane is self._followed[0] and standing is self._followed[1]:
            return
        self._followed, self._settled, eye = (pane, standing), None, standing.eye
        most_px = frame.PART_OF_PANE * min(pane.size_px)
        self._eye_depth = float(pane.axes[2] @ (eye - pane.eye))
        depth = max(self._eye_depth, 1e-6 * standing.extent)
        growing = most_px * (pane.unit(1.0) - pane.unit(0.0))  # for parts nearer than the eye
        self.body_size = (
            most_px * float(pane.unit(depth)) / (frame.BALL + frame.BEFORE * float(growing))
        )
        local_from_body = _scaled(standing.local_from_view, self.body_size)
        self._body_space.set(local_from_body)
        self.box = applied(local_from_body, frame.BODY_BOX)

    def show_step(self) -> None:
        """Build the frame up to the state's step."""
        state = self._state
        if self.steps is None:
            self.steps = frame.FrameSteps(self._canvas)
            state.emphasis.line(self.steps.up, "up")
            state.emphasis.line(self.steps.look, "target")
            self._name_arrow("up", "up", state.style.accent)
            self._name_arrow("look", "target", state.style.target)
            state.emphasis.show(state.names.pointed)
        self.steps.show(state.step)
        self._show_parts()

    def show_names(self) -> None:
        """Show the axes and the target that are named."""
        names = self._state.names
        named = frozenset(name for name in (*AXES, "target") if name in names)
        wanted = names.wanted or frozenset()
        if "frame-e" in wanted:
            named |= set(AXES)
        self.axes_lead = "frame-e" in wanted or wanted.issuperset(AXES)
        if named != self._named:
            self._named = named
            self._show_parts()

    def _show_parts(self) -> None:
        step = self._state.step
        for axis, shaft in self.shafts.items():
            is_seen = axis in self._named if step is None else frame.is_built(axis, step)
            self._canvas.set_visible(is_seen, shaft, self._heads[axis])
        shows_target = "target" in self._named or frame.is_built("look", step)
        self._canvas.set_visible(shows_target, *self._target_parts, self._sight)

    @property
    def arrows(self) -> tuple[tuple[str, ...], Array]:
        """The names of the visible arrows, and the vectors from the eye to their tips."""
        directions = np.array(list(self._tips.values())).reshape(-1, 3)
        return tuple(self._tips), self.axes_size * directions @ self._state.standing.camera.frame

    @property
    def _tips(self) -> dict[str, tuple[float, float, float]]:
        if self._state.step is None:
            return {a: frame.TIPS[a] for a in AXES if a in self._named}
        return frame.arrow_tips(self._state.step, self._state.standing.camera)

    @property
    def axes_size(self) -> float:
        """The unit of the axes, world units."""
        return self.body_size * self._enlarged

    @property
    def _enlarged(self) -> float:
        return frame.LARGER if self._state.step is not None or self.axes_lead else 1.0

    @property
    def parts(self) -> Array:
        """The visible parts that have to be inside the pane, (k, 3): from the eye, in bodies.

        While the frame is built, the arrows of later steps have their room already.
        """
        tips, camera = self._tips, self._state.standing.camera
        if self._state.step is not None:
            tips = frame.arrow_tips(len(STEPS) - 1, camera)
        reach = self._enlarged * (_WITH_NAMES if self.axes_lead else 1.0)
        ends = reach * np.array(list(tips.values())).reshape(-1, 3)
        return np.asarray(np.concatenate([frame.BODY_BOX, ends]) @ camera.frame)

    def settle(self) -> None:
        """Move eye, target and axes before what would hide them."""
        state = self._state
        pane, standing, near = state.own.pane, state.standing, state.own.depths[0]
        eye, target = standing.eye, standing.target
        size = self.axes_size
        if self._settled == (now := (near, size, state.step)):
            return
        self._settled = now
        depths = 1.01 * near, 1.02 * near, 1.03 * near, max(near, self._eye_depth - 2.8 * size)
        *places, (k, at) = map(pane.moved_forward, (eye, target, target, eye), depths)
        pane_from_axes = _scaled(standing.local_from_view, k * size)
        pane_from_axes[:3, 3] = at
        spaces = self._eye_space, self._target_space, self._rim_space
        for space, place in zip(spaces, places, strict=True):
            space.place(*place)
        self._axes_space.set(pane_from_axes)
        if state.step is not None and self.steps is not None:
            self.steps.place(pane_from_axes, standing.camera)

    # -- names, ink, pointing and framing

    @property
    def named_arrows(self) -> tuple[tuple[str, ...], Array]:
        """The arrows that are named, and where each starts and ends, (n, 2, 3)."""
        if "camera" in self._canvas.hidden:
            return (), np.empty((0, 2, 3))
        eye, (arrows, offsets) = self._state.standing.eye, self.arrows
        ends = np.stack([np.tile(eye, (len(offsets), 1)), eye + offsets], axis=1)
        if self._state.step is None:  # a frame can be shown without the letters of its axes
            shown = [name in self._state.names for name in arrows]
            arrows, ends = tuple(compress(arrows, shown)), ends[np.array(shown, dtype=bool)]
        return arrows, ends

    def want(self, ground: Ground) -> None:
        state, board = self._state, self._state.board
        (arrows, ends), named = self.named_arrows, state.named_points("eye", "target")
        box, standing = self.box, state.standing
        points = box, [standing.eye, standing.target], ends.reshape(-1, 3)
        spots = state.own.pane.seen(np.concatenate(points))
        x, y, depth = np.array(spots[: len(box)]).T
        eye, target, *tips = spots[len(box) :]
        if depth.min() > 0.0:
            line = _LINE_EM * state.em
            ground.keep_box(x.min() - line, y.min() - line, x.max() + line, y.max() + line)
        for name, spot, rank in (("eye", eye, EYE), ("target", target, TARGET)):
            if name in named:
                if spot[2] > 0.0:
                    ground.keep([spot], DOT_EM * state.em)
                board.want_beside(name, spot, rank, (0.0, -1.0))
        board.want_beyond(arrows, tips)

    def ink(self, ground: Ground) -> None:
        ground.ink_arrows(self._state.own.pane.spots(self.named_arrows[1]))

    def reach(self) -> Array:
        standing, size = self._state.standing, self.axes_size
        around = standing.eye + frame.AROUND * size * frame.SIX_WAYS
        # The axes are moved before the body, see `settle`.
        axes = standing.eye - 5.4 * size * self._state.own.pane.axes[2]
        return np.vstack([around, standing.target, axes])

    def inside(self) -> dict[str, Array]:
        """The eye, with the camera's body, unless it is not drawn; a parallel lens has none."""
        state, at = self._state, self._state.standing
        if "camera" in state.hidden_now or state.own.fixed == "eye":
            return {}
        inside = {"target": at.target[None]} if state.names.wants("target") else {}
        if state.projection.lens.central or state.names.wants("eye") or self._tips:
            inside["eye"] = at.eye[None]
        return inside


def camera_body(style: Style) -> tuple[vtkActor, vtkActor]:
    """A box with a lens hood and a viewfinder, in view space, the eye in the hood's mouth."""
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
    solid = actors.face_actor(np.array(points), faces, style.muted)
    return solid, actors.line_actor(np.array(points), edges, style.eye, style.line_width)


def _scaled(local_from_view: Array, size: float) -> Array:
    matrix = local_from_view.copy()
    matrix[:3, :3] *= size
    return matrix
