"""The surroundings of the scene at a stage of the strip: view volume, axes and words.

The volume is one box under the stage's matrix: at NDC a cube, or half of one in the depth range
[0, 1]; elsewhere a pyramid, or the flat frame of the picture.
"""

import itertools
import math
from collections.abc import Iterable, Mapping

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings import actors
from app.drawings.camera import camera_body
from app.drawings.frame import BODY_BOX
from app.drawings.frustum import CUBE
from app.drawings.label import SceneLabel
from app.drawings.label_placement import Ground
from app.drawings.labels import NUMBER, PLANE, vector, want_plane
from app.drawings.layer import NO_POINTS, Layer, PaneState, Placing
from app.drawings.pointing import FACES, FAR_FACE, NEAR_FACE, outline
from app.drawings.prop_group import PropGroup
from app.drawings.stage_view import AXES_LENGTH, CANONICAL_AXES, OVERSHOOT, StageView
from app.drawings.style import rgb
from app.lecture import stages
from app.lecture.highlight import AXES, ENDS, SIDES
from app.model.parameters import FAR, NEAR
from app.model.projection import Array, Projection
from app.picking.sight import Sight
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.words import digits_apart, figure
from app.scenes.poly_mesh import PolyMesh
from app.scenes.scene import Scene

_NAMES = *ENDS, *AXES, *"xyz"  # of what is written beside the volume
_FARTHEST_MARK = 1e3  # where lines toward infinity end
_BOX_FROM_NDC = np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, -0.5, 0.5], [0, 0, 0, 1]])
_PALER = 0.6  # of the near plane's tint in the world, where it is smaller
_AT_CORNER = [((-1, -1, 1), end) for end in ((1, -1, 1), (-1, 1, 1), (-1, -1, 0))]
_SHORT = 0.28  # of an edge of the cube: its axes
BODY = 0.09  # the camera's: the unit of its size
_SMALL_HEAD = 0.5  # of an arrow's head: before the cube the pane shows less of the display space
_NUMBERS_FROM_EM = 8.0  # of the volume's width in the pane: in a smaller one there is no room


class StageState(PaneState):
    """What the layers of the stage pane share: the position on the strip, and the volume there.

    `stop` is the one whose axes and words are shown; `display_from_box` is where the volume is
    shown, (4, 4), 0 without one. `planes` are left, right, bottom, top, far, near of the volume,
    normals inwards.
    """

    pane = "ndc"

    def __init__(self, canvas: PropGroup, scene: Scene, words: Mapping[str, str]) -> None:
        super().__init__(canvas, scene, words)
        self.own = StageView(canvas, scene.start.camera, scene.cube_side)
        self.position = float(stages.NDC)
        self.stop, self.display_from_box = stages.NDC, np.zeros((4, 4))
        self.planes = [vtkPlane() for _ in range(6)]
        self.is_gliding = False  # whether `glide` will show and place everything, once a frame
        self._morph: stages.Morph | None = None

    def take(self, projection: Projection, illustration: Illustration | None) -> None:
        self.projection, self.illustration, self._morph = projection, illustration, None

    def has_volume(self, position: float) -> bool:
        """Whether there is a volume to show; up to the view it is the frustum, a layer."""
        hidden = position <= stages.VIEW and "frustum" in self.canvas.hidden
        return not hidden and self.morph.has_volume(position)

    @property
    def placed(self) -> tuple[float, object]:
        """The position, and the projection or depth range that the volume depends on there."""
        projection = self.projection
        return self.position, projection.depth if self.position == stages.NDC else projection

    @property
    def morph(self) -> stages.Morph:
        """Created on demand: most steps at the NDC stop do not need it."""
        if self._morph is None:
            corners, origin = self.scene.reach(self.projection.placement), self.scene.origin
            self._morph = stages.morph_of(self.projection, origin, corners, self.from_left)
        return self._morph

    def in_box(self, points: object) -> Array:
        """Where points of the volume's cube are shown, in display space."""
        box, points = self.display_from_box, np.asarray(points, dtype=np.float64)
        homogeneous = points @ box[:, :3].T + box[:, 3]
        return np.asarray(homogeneous[..., :3] / homogeneous[..., 3:])

    def volume_seen(self) -> Array:
        """The corners of the volume in the pane, (8, 2); NaN for what is at infinity."""
        with np.errstate(divide="ignore", invalid="ignore"):  # where far is at infinity
            corners = self.in_box(CUBE)
        return self.spots(np.where(np.isfinite(corners), corners, np.nan))

    @property
    def marked(self) -> Illustration | None:
        return self.illustration if self.position == stages.NDC else None

    @property
    def places_labels(self) -> bool:
        return not self.is_gliding and super().places_labels

    @property
    def display_from_ndc(self) -> Array:
        """From OpenGL's cube; 0 without a volume, so that nothing can be pointed at."""
        return np.asarray(self.display_from_box @ _BOX_FROM_NDC)

    @property
    def display_from_object(self) -> Array:
        origin, seen = self.scene.origin, self.seen_projection
        if self.position == stages.NDC:
            return self.display_from_ndc @ seen.clip_from_local(origin, "object")
        placed = seen.placement.local_from(origin, origin)
        return self.morph.display_from_local(self.position) @ placed

    def spots(self, points: Array) -> Array:
        rows = self.own.pane_from_display
        x, y = rows[:2, :3] @ points.T + rows[:2, 3:]
        return np.stack([x, self.size_px[1] - y], axis=-1)

    def placing(self) -> Placing:
        shown = self.morph.display_from_stage(stages.NDC)
        return Placing(np.diag(shown)[:3], shown[:3, 3], _FARTHEST_MARK)

    def copies_from_local(self, times: float) -> Array:
        return self.display_from_ndc @ self.seen_projection.clip_from_local(self.scene.origin)

    @property
    def sight(self) -> Sight:
        projection = self.seen_projection
        clip = projection.clip_from_eye
        limits = np.concatenate([clip[3] - clip[:3], clip[3] + clip[:3]])
        rows = self.own.pane_from_display @ self.display_from_ndc @ clip
        return Sight(np.array(projection.camera.eye), rows, limits)


class StageBox(Layer):
    """The view volume at a position of the strip.

    - `placed`: the state's `placed` that is shown.
    - `axes` (3, 3, 3): start, end along the volume, and tip of each axis, in display space; NaN for
      a hidden axis.
    """

    def __init__(self, state: StageState) -> None:
        self._state, self._canvas, self._words = state, state.canvas, state.words
        self._names, self._board = state.names, state.board
        self.placed: tuple[float, object] | None = None
        self._space = actors.Space()
        self._at: dict[SceneLabel, Array] = {}
        self._written: set[SceneLabel] = set()  # the labels to show if there is room
        self._add_volume()
        self._add_axes()
        self._add_words()
        self._make_emphasis()

    def _add_volume(self) -> None:
        style = self._canvas.style
        width = style.line_width
        between = [(i + 4, i) for i in NEAR_FACE]
        ends = ENDS[::-1]
        edges = self._edges = actors.line_actor(CUBE, between, style.frustum, width)
        self._outlines = {
            name: outline(FACES[name], CUBE, style, dashed=name == FAR.name) for name in ends
        }
        middles = np.array([CUBE[list(FACES[side])].mean(axis=0) for side in (*SIDES, *ends)])
        self._cross = actors.line_actor(middles, [(3, 1), (0, 2), (4, 5)], style.muted, width / 2.0)
        near_tint, far_tint = style.tints
        faces = [
            actors.face_actor(CUBE, [FAR_FACE], style.far, far_tint),
            actors.face_actor(CUBE, [NEAR_FACE], style.near, _PALER * near_tint),
        ]
        lines = (edges, *self._outlines.values())
        for actor in (*lines, self._cross, *faces):
            self._space.add(actor)
            self._canvas.add(actor)
        for line in lines:
            actors.lift_lines(line, 2)
        for face in faces:
            actors.put_behind(face)
        self._volume = (*lines, *faces)

    def _add_axes(self) -> None:
        """Shafts of length 1 and their heads, along x; and the camera.

        Three are the camera's, or after the view the stage's own. The others are x, y and z of the
        space in which the camera moves until then.
        """
        style = self._canvas.style
        self._camera, self._body, self._camera_at = actors.Space(), camera_body(style), NO_POINTS
        self._camera.add(*self._body)
        self._canvas.add(*self._body, layer="camera")
        self._arrows: list[tuple[actors.Space, actors.Space, vtkActor, vtkActor]] = []
        cone = vtkConeSource(height=0.14, radius=0.045, resolution=24)
        cone.SetCenter(-0.07, 0.0, 0.0)
        cone.Update()
        for colour in 2 * (style.u, style.v, style.n):
            shaft = actors.line_actor(
                [(0, 0, 0), (1, 0, 0)], [(0, 1)], colour, 1.5 * style.line_width
            )
            head = actors.unlit_actor(PolyMesh.sharing(cone.GetOutput()))
            head.GetProperty().SetColor(*rgb(colour))
            actors.lift_lines(shaft, 3)
            spaces = actors.Space(), actors.Space()
            for space, actor in zip(spaces, (shaft, head), strict=True):
                space.add(actor)
                self._canvas.add(actor)
            self._arrows.append((*spaces, shaft, head))

    def _add_words(self) -> None:
        style, label = self._canvas.style, self._board.label
        self.near, self.far = (label(e, self._words[e], getattr(style, e)) for e in ENDS)
        self._numbers = {name: [label((name, i)) for i in range(2)] for name in "xyz"}
        self._letters = tuple(label(a, "", getattr(style, a)) for a in AXES)
        xyz = zip("xyz", AXES, strict=True)
        self._letters += tuple(label(a, self._words[a], getattr(style, b)) for a, b in xyz)
        self._keys = {
            **dict(zip((self.near, self.far, *self._letters), _NAMES, strict=True)),
            **{pair[i]: (name, i) for name, pair in self._numbers.items() for i in range(2)},
        }  # fmt: skip

    def _make_emphasis(self) -> None:
        emphasis = self._state.emphasis
        emphasis.volume(self._space, CUBE, behind=True)
        for name, line in self._outlines.items():
            emphasis.line(line, name)
        emphasis.line(self._edges, of=ENDS)
        for name, (_, _, shaft, _) in zip(AXES, self._arrows, strict=False):
            emphasis.line(shaft, name, of=(*"xyz", *AXES))  # visible only if it is named
        for label, name in zip((self.near, self.far, *self._letters[:3]), _NAMES, strict=False):
            emphasis.label(label, name)

    # -- at a position of the strip

    def show(self) -> None:
        """Move there, if it depends on what has changed."""
        state = self._state
        if state.placed == self.placed:
            return
        self.placed = state.placed
        morph, position = state.morph, state.position
        stop, drawn = morph.stop_at(position), state.has_volume(position)
        box = actors.fitting(morph.display_from_box(position)) if drawn else np.zeros((4, 4))
        has_depth = stop != stages.IMAGE
        state.stop, state.display_from_box = stop, box
        self._space.set(box)
        planes = morph.planes_display(position).tolist()
        for plane, (*normal, offset) in zip(state.planes, planes, strict=True):
            plane.SetNormal(*normal)
            plane.SetOrigin(*(-offset * part for part in normal))
        for actor in self._volume:
            actor.SetVisibility(drawn)
        is_cube = stop in (stages.CANONICAL_PARALLEL, stages.NDC)
        self._cross.SetVisibility(is_cube and "numbers" in self._names)
        for name, label in zip(ENDS, (self.near, self.far), strict=True):
            label.set_visible(drawn and has_depth and name in self._names)
        self._place_axes(morph, position, stop)
        for name, numbers in zip("xyz", self._numbers.values(), strict=True):
            for number in numbers:
                is_written = has_depth or name != "z"
                number.set_visible(
                    stop >= stages.CANONICAL_PERSPECTIVE and is_written and "numbers" in self._names
                )
        if drawn:
            self._place_words(morph, stop)
        labels = self.near, self.far, *self._letters, *itertools.chain(*self._numbers.values())
        self._written = {label for label in labels if label.is_visible and label.text}

    def _place_axes(self, morph: stages.Morph, position: float, stop: int) -> None:
        """Put axes and letters where the nearest stop has them."""
        self._camera_at = NO_POINTS
        if stop == stages.NDC:  # along the edges at a corner of near, z the way it grows
            starts, ends = np.moveaxis(self._state.in_box(_AT_CORNER), 1, 0)
            tips = starts + _SHORT * (ends - starts)
            z_near, z_far = self._limits(morph)
            if z_near > z_far:
                tips[2] = 2.0 * starts[2] - tips[2]
            inner = starts
        elif stop == stages.IMAGE:  # along the picture's, y down
            start, corner = self._state.in_box([(-1, 1, 1), (1, -1, 1)])
            axes = np.diag([1.0, -1.0, 1.0])
            inner = start + np.abs(corner - start)[:, None] * axes
            starts, tips = np.tile(start, (3, 1)), inner + OVERSHOOT * axes
        else:
            start, *canonical = CANONICAL_AXES
            tips = np.array(canonical)
            if stop <= stages.VIEW:
                start, axes = morph.axes_at(position)
                away = math.hypot(*start)
                if away > stages.RADIUS:  # far from the scene: at the border toward it
                    start *= stages.RADIUS / away
                tips = start + AXES_LENGTH * axes
                self._camera.set(_placed(start, BODY * axes.T))
                if morph.projection.has_camera:
                    self._camera_at = start + BODY * BODY_BOX @ axes
            starts = inner = np.tile(start, (3, 1))
        self._canvas.set_visible(len(self._camera_at) > 0, *self._body)
        moves = position < stages.VIEW and (morph.projection.has_camera or position == stages.WORLD)
        origin = np.tile(morph.origin_at(position) if moves else np.zeros(3), (3, 1))
        starts, inner = np.concatenate([starts, origin]), np.concatenate([inner, origin])
        tips = np.concatenate([tips, origin + AXES_LENGTH * np.eye(3)])
        self.axes = np.stack([starts, inner, tips], axis=1)
        letters = "uvnxyz" if stop <= stages.VIEW else "xyzxyz"
        for i, (shaft_space, head_space, *arrow) in enumerate(self._arrows):
            along = tips[i] - starts[i]
            length = math.hypot(*along)
            turn = _turn_to(along / max(length, 1e-9))
            head_space.set(_placed(tips[i], turn if stop > stages.VIEW else _SMALL_HEAD * turn))
            turn[:, 0] *= length
            shaft_space.set(_placed(starts[i], turn))
            letter = self._letters[i]
            self._at[letter] = tips[i]
            word = self._words[letters[i]]
            is_cameras = stop <= stages.VIEW and i < 3
            letter.set_text(vector(word) if is_cameras else word)
            # A single x, y or z may be a length in another pane.
            wanted = letters[i] if is_cameras else "xy" if stop == stages.IMAGE else "xyz"
            is_named = all(name in self._names for name in wanted)
            is_named |= _NAMES[2 + i] in self._names.pointed
            is_shown = is_named and (stop != stages.IMAGE or i < 2) and (i < 3 or moves)
            letter.set_visible(is_shown)
            for actor in arrow:
                actor.SetVisibility(is_shown)
            if not is_shown:
                self.axes[i] = np.nan

    def _limits(self, morph: stages.Morph) -> tuple[float, float]:
        """The cube's z at near and at far in the lecture's signs: 002 has 1 at near."""
        near, far = morph.projection.depth_range
        is_turned = self._words.get("{near_in_cube}") == "1" and near == -far
        return (far, near) if is_turned else (near, far)

    def _place_words(self, morph: stages.Morph, stop: int) -> None:
        """Put near, far and the ends of the axes at the corners of the view volume."""
        box, lens, words = self._state.display_from_box, morph.projection.lens, self._words
        limit = stages.RADIUS if stop <= stages.VIEW else 2.0
        near, far = (_edge(box, -1.0, 1.0, limit, z) for z in (1.0, 0.0))
        is_pyramid = lens.central
        self._at |= {self.near: near, self.far: far}
        near_text, far_text = (words[end] for end in ENDS)
        x, y, z = ("−1", "1"), ("−1", "1"), ("0", "−1")
        end = 1.0
        if stop == stages.CANONICAL_PERSPECTIVE and is_pyramid:
            # The sides are 1 where z is -1: at far, and at near if far is infinite.
            infinite = lens.far == math.inf
            end = 1.0 if infinite else 0.0
            z = ("", "−∞" if infinite else "−1")
            at = -1.0 if infinite else -lens.near / lens.far
            near_text = f"{near_text} {figure(at, digits_apart(at, -1.0, least=3))}"
            self._numbers["z"][0].set_visible(False)  # on the plate of near, which is small here
        elif stop == stages.NDC:
            z_near, z_far = map(_signed, self._limits(morph))
            near_text, far_text = f"{near_text} {z_near}", f"{far_text} {z_far}"
            z = ("", "")  # they stand beside near and far
        elif stop == stages.IMAGE:
            width, height = morph.projection.image_size
            x, y = ("0", str(width)), (str(height), "0")
        self.near.set_text(near_text)
        self.far.set_text(far_text)
        if stop <= stages.VIEW:
            return
        for name, texts, corners in (
            ("x", x, ((-1.0, -1.0, end), (1.0, -1.0, end))),
            ("y", y, ((-1.0, -1.0, end), (-1.0, 1.0, end))),
            ("z", z, ((1.0, 1.0, 1.0), (1.0, 1.0, 0.0))),
        ):
            for number, text, (across, up, along) in zip(
                self._numbers[name], texts, corners, strict=True
            ):
                number.set_text(text)
                self._at[number] = _edge(box, across, up, limit, along)

    def want(self, ground: Ground) -> None:
        """Ask for a place for every word; in a small pane the numbers give way to the names."""
        if not self._at:
            return
        board, seen = self._board, self._state.seen
        if len(self._camera_at):
            x, y, _ = np.array(seen(self._camera_at)).T
            ground.keep_box(x.min(), y.min(), x.max(), y.max())
        spots = dict(zip(self._at, seen(np.array(list(self._at.values()))), strict=True))
        corners = self._state.volume_seen()
        middle = np.nanmean(corners[:, :2], axis=0) if np.isfinite(corners).any() else np.zeros(2)
        body = [(x, y, 1.0) for x, y in corners.tolist()]
        for label, face in ((self.near, slice(4)), (self.far, slice(4, 8))):
            if label in self._written:
                key = self._keys[label]
                if np.isfinite(corners[face]).all():
                    want_plane(board, ground, key, body[face], body)
                else:
                    board.want_beside(key, spots[label], PLANE)
        starts = zip(self._letters, seen(self.axes[:, 0]), strict=True)
        arrows = [(letter, start) for letter, start in starts if letter in self._written]
        ends = [spot for letter, start in arrows for spot in (start, spots[letter])]
        board.want_beyond([self._keys[letter] for letter, _ in arrows], ends)
        finite = corners[np.isfinite(corners).all(axis=1), 0]
        across = np.ptp(finite) if len(finite) else 0.0
        for number in itertools.chain(*self._numbers.values()):
            if number in self._written and across >= _NUMBERS_FROM_EM * ground.em:
                x, y, _ = spots[number]
                way = x - float(middle[0]), y - float(middle[1])
                board.want_beside(self._keys[number], spots[number], NUMBER, way)

    def ink(self, ground: Ground) -> None:
        edges = [pair for line in actors.CUBE_EDGES for pair in itertools.pairwise(line)]
        ground.ink_lines(self._state.volume_seen()[edges])
        axes = self._state.spots(self.axes[:, ::2].reshape(-1, 3))
        ground.ink_arrows(axes.reshape(-1, 2, 2))


def _signed(z: float) -> str:
    """An end of the depth range: −1, 0 or +1."""
    return f"+{figure(z, 3)}" if z > 0.0 else figure(z, 3)


def _turn_to(axis: Array) -> Array:
    """A rotation that takes x to a direction, (3, 3): half a turn about the axis between them."""
    between = np.add(axis, (1.0, 0.0, 0.0))
    square = float(between @ between)
    if square < 1e-12:  # the other way round
        return np.diag([-1.0, 1.0, -1.0])
    return np.asarray(2.0 / square * np.outer(between, between) - np.eye(3))


def _placed(place: Array, turn: Array) -> Array:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn, place
    return matrix


def volume_ends(box: Array, ends: Iterable[str]) -> Array:
    """Where the corners of near and far are shown, or their edges leave the framed ball, (n, 3)."""
    depths = [float(end == NEAR.name) for end in ends]
    corners = itertools.product(depths, (-1.0, 1.0), (-1.0, 1.0))
    return np.array([_edge(box, x, y, stages.RADIUS, z) for z, x, y in corners])


def _edge(box: Array, across: float, up: float, limit: float, z: float) -> Array:
    """Where a corner of the view volume is shown, or where its edge leaves the framed ball."""
    near, far = (box @ (across, up, end, 1.0) for end in (1.0, 0.0))
    start: Array = near[:3] / near[3]
    if z == 1.0 or math.hypot(*start) >= limit:
        return start
    along = far[:3] - far[3] * start
    length = math.hypot(*along)
    if length == 0.0:
        return start
    along /= length
    # From inside the ball: the positive root of |start + s along| = limit.
    middle = float(start @ along)
    leaves = -middle + math.sqrt(middle**2 + limit**2 - float(start @ start))
    inside = far[3] * leaves >= length  # the corner itself is
    return np.asarray(start + along * (length / far[3] if inside else leaves))
