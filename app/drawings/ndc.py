"""The NDC pane: the scene after the perspective divide, inside the cube of what is seen.

==================  =========================================================================
what                under which 4x4
==================  =========================================================================
the scene           ``display_from_ndc * clip_from_world``, clipped by the cube's six planes
the cube, its axes  a scale along z, since the cube of a [0, 1] depth range is half as deep
==================  =========================================================================

NDC is left-handed (z grows away from the reader), so that this pane mirrors z for display only:
the near face looks at the reader, x runs right, and the cube's front is the picture. With the
reversed range, where z grows towards the reader, there is nothing to mirror. The cube is centred
where the pane's camera looks. That camera is a parallel one: all foreshortening that is to be
seen is the projection's own.

That is the pane at the NDC stop of its stage strip, and as it is exported. At any other position
(`NdcDrawing.show_stage`) the scene and the view volume, which is the cube's own edges and faces,
stand under the matrices of `app.lecture.stages` instead, and the words are those of the nearest
stop. A step of the strip sets these matrices and nothing else.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pyvista as pv
from numpy.typing import NDArray
from vtkmodules.vtkCommonDataModel import vtkPlane

from app.drawings.actors import (
    CUBE_CORNERS,
    Canvas,
    Space,
    face_actor,
    lift_lines,
    line_actor,
    put_behind,
    unlit_actor,
)
from app.drawings.labels import Layout
from app.drawings.marks import MarksDrawing, Placing
from app.drawings.pointing import Emphasis, Segment, Spot, pointed_at, volume_edges
from app.drawings.precision import ModelActors, least_tolerance
from app.drawings.probes import Mark, Probes
from app.drawings.rasterising import Rasteriser
from app.drawings.style import Style, rgb
from app.lecture.highlight import AXES, CORNERS, Attention
from app.lecture.stages import (
    CANONICAL_PARALLEL,
    CANONICAL_PERSPECTIVE,
    IMAGE,
    NDC,
    RADIUS,
    VIEW,
    WORLD,
    FreeMorph,
    Morph,
)
from app.model.projection import DEPTH_RANGES, Array, Camera, Projection
from app.picking.picking import Probe, Sight
from app.precision.levels import DRAWING_TOLERANCE_PX, Rung
from app.scenes.phenomena.illustration import Exhibit, Marks
from app.scenes.scene import Scene

VIEW_AZIMUTH_DEG, VIEW_ELEVATION_DEG = 27.0, 18.0
"""Where this pane's camera stands at first: to the right of the near face and above it."""

_DISTANCE = 10.0  # of the pane's camera; parallel, so that only its clipping range feels it
_REACH = 2.5  # everything drawn lies within this of the cube's centre, at any orbit
_OVERSHOOT = 0.28  # of the axes beyond the cube
_TINT = 0.16
_FARTHEST_MARK = 1e3  # where lines toward infinity end

_BEHIND_DEG, _WORLD_ELEVATION_DEG = 55.0, 25.0  # of the world stop, from the scene's own camera
_LOOKED_FROM_DEG = {
    VIEW: (60.0, 20.0),
    CANONICAL_PERSPECTIVE: (40.0, 18.0),
    CANONICAL_PARALLEL: (VIEW_AZIMUTH_DEG, VIEW_ELEVATION_DEG),
    NDC: (VIEW_AZIMUTH_DEG, VIEW_ELEVATION_DEG),
    IMAGE: (0.0, 0.0),
}
_FILLED = 0.9  # of the ball that holds the frustum: its corners alone touch the ball
_TRIAD = 0.35  # length of the axes at the world and view stops
_CANONICAL_TRIAD = 0.75  # of x and y in the canonical volumes, short of the sides' words
_BESIDE = np.array([-0.3, -0.42])  # right and up of a pyramid's small near face: its plate
_BESIDE_PYRAMID = np.array([-1.35, 0.2])
_BOX = CUBE_CORNERS * (1.0, 1.0, 0.5) + (0.0, 0.0, 0.5)  # `Morph`'s: z is 1 at near, 0 at far
_NEAR_FIRST = [4, 5, 6, 7, 0, 1, 2, 3]
_BOX_FROM_NDC = np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, -0.5, 0.5], [0, 0, 0, 1]])
_LEVEL = Camera((0.0, 0.0, 1.0), (0.0, 0.0, 0.0))  # whose frame is the identity
_BOX_FROM_CUBE = np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0.5, 0.5], [0, 0, 0, 1]])


class NdcDrawing:
    """The scene inside the NDC cube.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
    scene : Scene
    words : mapping
        The words written here: ``near``, ``far``, ``x``, ``y``, ``z``.
    style : Style
    tolerance_px : float
        Error up to which the GPU's own float32 may draw.
    """

    def __init__(
        self,
        plotter: Any,
        scene: Scene,
        words: Mapping[str, str],
        style: Style,
        tolerance_px: float = DRAWING_TOLERANCE_PX,
    ) -> None:
        self._scene = scene
        self._canvas = Canvas(plotter, style, self._layout)
        self._camera = self._canvas.renderer.GetActiveCamera()
        self._view: tuple[float, ...] = ()
        self._depth = ""
        self._half_depth = 1.0
        self._space, self._box, self._z_axis = Space(), Space(), Space()
        self._volume = Space()
        self._projection = scene.start
        self._position = float(NDC)
        self._named: tuple[int, str] | None = None
        self._morph: Morph | None = None
        self._planes = self._cube_planes()
        tolerance_px = least_tolerance(scene, tolerance_px)
        self._model = ModelActors(scene, style, tolerance_px, self._planes)
        self._add_scene()
        self._add_cube(style)
        self._add_triad(style)
        self._words = words
        self._add_words(words, style)
        self._make_emphasis(style)
        self._probes = Probes(self._canvas, style)
        self._style = style
        self._marks: MarksDrawing | None = None
        self._rasteriser: Rasteriser | None = None
        self._exhibit: Exhibit | None = None
        self._set_depth("opengl")
        self.reset_view()

    @property
    def rung(self) -> Rung:
        """The arithmetic that the scene is drawn with."""
        return self._model.rung

    def show_projection(self, projection: Projection, exhibit: Exhibit | None = None) -> None:
        """Take the model's matrices, and what a phenomenon shows for it; draws nothing yet.

        Marks and copies are those of NDC: at any other stop of the strip there are none.
        """
        self._projection, self._exhibit, self._morph = projection, exhibit, None
        self._place_scene()
        self._rasterise()
        self._show_marks()

    def _place_scene(self) -> None:
        projection = self._projection
        if self._position != NDC:
            moved = self._current_view() != self._view
            self._depth = projection.depth
            self._show_moment()
            if not moved:  # the picture may have another shape
                self.reset_view()
            return
        if projection.depth != self._depth:
            self._set_depth(projection.depth)
        seen = self._seen
        self._space.set_projective(self._display_from_ndc @ self._model.show_projection(seen))
        self._place_probes()

    def show_detail(self, fewer: Scene | None) -> None:
        """Take a scene's fewer triangles, or all for None; then show a projection."""
        self._model.show_detail(fewer)
        if self._marks is not None:
            self._marks.show_detail(fewer)

    def show_stage(self, position: float) -> None:
        """Move to a position of the stage strip; draws nothing yet.

        Parameters
        ----------
        position : float
            0 to 5; whole at `morph.STOPS`. The NDC stop is what the pane shows at first.
        """
        if position == self._position:
            return
        moved = self._current_view() != self._view
        self._position = position
        if position == NDC:
            self._name_stop(NDC)
            for actor in self._volume_actors:
                actor.SetVisibility(True)
            self._set_depth(self._projection.depth)
            self._place_scene()
        else:
            self._show_moment()
        self._show_marks()
        if not moved:
            self.reset_view()

    def reset_view(self) -> None:
        """Look at the near face from the right and above, the whole cube in the pane.

        Between two stops of the strip, from between the places that suit them.
        """
        stop = min(int(self._position), IMAGE)
        part = self._position - stop
        framing = self._framing(stop)
        if part > 0.0:
            framing = (1.0 - part) * framing + part * self._framing(stop + 1)
        centre, scale = framing[:3], float(framing[3])
        _, _, toward = _axes_from(*framing[4:])
        camera = self._camera
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*centre)
        camera.SetPosition(*(centre + _DISTANCE * toward))
        camera.SetViewUp(0.0, 1.0, 0.0)
        camera.SetParallelScale(scale)
        self._view = self._current_view()
        self.reset_clipping_range()

    def _looked_from(self, stop: int) -> tuple[float, float]:
        """Azimuth and elevation of the pane's camera at a stop, degrees."""
        if stop != WORLD:
            return _LOOKED_FROM_DEG[stop]
        # From beside the scene's own camera, and by the shorter way to the next stop's place.
        after = _LOOKED_FROM_DEG[VIEW][0]
        azimuth = self._scene.start.camera.orbit.azimuth_deg + _BEHIND_DEG
        return after + math.remainder(azimuth - after, 360.0), _WORLD_ELEVATION_DEG

    def _framing(self, stop: int) -> Array:
        """Where a stop is seen from: centre x, y, z, parallel scale, azimuth, elevation."""
        width_px, height_px = (max(1, side) for side in self._canvas.window.GetSize())
        looked_from = self._looked_from(stop)
        right, up, _ = _axes_from(*looked_from)
        if stop <= VIEW:
            drawn = _FILLED * RADIUS * np.array([right, -right, up, -up])
        elif stop == IMAGE:
            sides = np.array([*self._projection.image_size, 0.0])
            across, down, _ = sides / sides.max()
            drawn = CUBE_CORNERS * (across, down, 0.0)
            drawn = np.vstack([drawn, [across + _OVERSHOOT, -down - _OVERSHOOT, 0.0]])
        else:
            ends = [(1.0 + _OVERSHOOT, -1.0, 1.0), (-1.0, 1.0 + _OVERSHOOT, 1.0)]
            ends += [(1.0, 1.0, sign * (1.0 + _OVERSHOOT)) for sign in (-1.0, 1.0)]
            drawn = np.vstack([CUBE_CORNERS, ends])
        margin_px = 2.6 * self._canvas.style.font_size
        centre = np.zeros(3)
        scale = 0.0
        for axis, side_px in ((right, width_px), (up, height_px)):
            low, high = (drawn @ axis).min(), (drawn @ axis).max()
            centre += (low + high) / 2.0 * axis
            room_px = max(side_px - 2.0 * margin_px, side_px / 2.0)
            scale = max(scale, (high - low) / 2.0 * height_px / room_px)
        return np.array([*centre, scale, *looked_from])

    def refit(self) -> bool:
        """Nothing leaves the cube: no other view is needed."""
        return False

    def reset_clipping_range(self) -> None:
        """Fit this pane's near and far to the cube; call it after its camera was moved."""
        camera = self._camera
        distance = -float(np.dot(camera.GetPosition(), camera.GetDirectionOfProjection()))
        near = distance - _REACH
        if not camera.GetParallelProjection():
            near = max(near, distance / 1000.0, 1e-3)
        camera.SetClippingRange(near, max(near, distance) + _REACH)
        self._place_probes()
        self._place_texts()

    def show_probes(self, probes: Sequence[Probe]) -> None:
        """Mark these probes, and no others."""
        self._probes.probes = probes
        self._place_probes()

    def _rasterise(self) -> None:
        """Lay the texture over the faces, at every stop of the strip."""
        rendering = None if self._exhibit is None else self._exhibit.rendering
        surface = self._model.surface
        if rendering is None or surface is None or "texture" not in self._scene.requires:
            return
        if self._rasteriser is None:
            self._rasteriser = Rasteriser(
                self._scene,
                self._style,
                {"texture"},
                self._canvas.add,
                (surface, self._space),
                picture=False,
            )
        self._rasteriser.show(rendering, self._seen)

    def _show_marks(self) -> None:
        if self._marks is None:
            if self._exhibit is None:
                return
            self._marks = MarksDrawing(
                self._canvas,
                self._scene,
                self._style,
                self._words,
                clip=self._planes,
                lifts_copies=True,
            )
        marks, exhibit = self._marks, self._exhibit
        if exhibit is None or self._position != NDC:
            marks.show(Marks(), Placing(np.ones(3), np.zeros(3), 1.0))
            marks.show_copies(())
            return
        z_near, z_far = self._projection.depth_range
        mirror = 1.0 if z_near > z_far else -1.0
        shift = np.array([0.0, 0.0, -mirror * (z_near + z_far) / 2.0])
        marks.show(exhibit.ndc, Placing(np.array([1.0, 1.0, mirror]), shift, _FARTHEST_MARK))
        copies = [copy for copy in exhibit.copies if "ndc" in copy.panes]
        marks.show_copies(copies)
        if copies:
            clip_from_local = self._seen.clip_from_world_at(self._scene.origin)
            display_from_local = self._display_from_ndc @ clip_from_local
            marks.place_copies(lambda _: display_from_local)
        self._place_texts()

    def _place_texts(self) -> None:
        if self._marks is None:
            return
        width_px, height_px = self._size_px
        rows = self._pane_from_display

        def seen(points: Array) -> list[Spot]:
            x, y = rows[:2, :3] @ points.T + rows[:2, 3:]
            return [(a, height_px - b, 1.0) for a, b in zip(x.tolist(), y.tolist(), strict=True)]

        layout = Layout((width_px, height_px), self._style.font_size, {})
        self._marks.place_texts(layout, seen)

    @property
    def _size_px(self) -> tuple[int, int]:
        width_px, height_px = self._canvas.window.GetSize()
        return max(1, width_px), max(1, height_px)

    @property
    def sight(self) -> Sight:
        """How this pane looks at the world just now, by way of the displayed cube."""
        projection = self._seen
        clip = projection.clip_from_eye
        limits = np.concatenate([clip[3] - clip[:3], clip[3] + clip[:3]])
        rows = self._pane_from_display @ self._display_from_ndc @ clip
        return Sight(np.array(projection.camera.eye), rows, limits)

    @property
    def _pane_from_display(self) -> Array:
        """From the displayed cube to pixels from the pane's top left, and depth, (4, 4)."""
        camera = self._camera
        width_px, height_px = self._size_px
        toward = np.array(camera.GetDirectionOfProjection())
        right = np.cross(toward, camera.GetViewUp())
        right /= np.linalg.norm(right)
        up = np.cross(right, toward)
        px = height_px / (2.0 * camera.GetParallelScale())
        position = np.array(camera.GetPosition())
        pane = np.zeros((4, 4))
        for row, axis, middle in ((0, px * right, width_px), (1, -px * up, height_px)):
            pane[row] = *axis, middle / 2.0 - axis @ position
        pane[2] = *toward, -toward @ position
        pane[3, 3] = 1.0
        return pane

    @property
    def _seen(self) -> Projection:
        """In OpenGL's range, whatever the model's: the displayed cube differs by its depth only."""
        return self._projection.with_depth("opengl")

    @property
    def _display_from_ndc(self) -> NDArray[np.float64]:
        """From OpenGL's cube, at the strip's position."""
        if self._morph is None:
            return np.diag([1.0, 1.0, -self._half_depth, 1.0])
        if isinstance(self._morph, FreeMorph):
            if not self._morph.has_volume(self._position):
                return np.zeros((4, 4))  # there nothing can be pointed at
            return _fitting(self._morph.display_from_box(self._position) @ _BOX_FROM_NDC)
        local_from_clip = self._seen.world_from_clip_at(self._scene.origin)
        return _fitting(self._morph.display_from_local(self._position) @ local_from_clip)

    def _place_probes(self) -> None:
        marks: Sequence[Mark] = ()
        if self._probes.probes and self._display_from_ndc.any():
            marks = self._probes.in_ndc(self._seen, self._display_from_ndc, self.sight)
        self._probes.show(marks, self._canvas.window.GetSize())

    @property
    def view(self) -> Camera | None:
        """Where the pane's own camera was moved to, in the displayed cube; None if it was not.

        The camera is a parallel one: the view's distance stands for its scale.
        """
        if self._current_view() == self._view:
            return None
        camera = self._camera
        target = np.array(camera.GetFocalPoint())
        toward = -np.array(camera.GetDirectionOfProjection())
        eye = target + camera.GetParallelScale() * toward
        return Camera(tuple(eye), tuple(target), camera.GetViewUp())

    def show_view(self, view: Camera) -> None:
        """Move the pane's own camera to a `view` of before."""
        camera = self._camera
        camera.SetFocalPoint(*view.target)
        camera.SetPosition(*(np.array(view.target) + _DISTANCE * view.frame[2]))
        camera.SetViewUp(*view.up)
        camera.SetParallelScale(view.distance)
        self.reset_clipping_range()

    def remove(self) -> None:
        """Take everything out of the plotter again."""
        self._canvas.remove()

    # -- made once

    def _cube_planes(self) -> list[vtkPlane]:
        """Left, right, bottom, top, far, near of the displayed cube, normals inwards."""
        return [vtkPlane() for _ in range(6)]  # placed by `_set_depth`

    def _add_scene(self) -> None:
        if self._model.lines is not None:
            lift_lines(self._model.lines)
        for actor in (self._model.surface, self._model.lines):
            if actor is not None:
                self._space.add(actor)
                self._canvas.add(actor)

    def _add_cube(self, style: Style) -> None:
        # The displayed near face is the one at z = +1.
        far, near = (0, 1, 2, 3), (4, 5, 6, 7)
        between = [(0, 4), (1, 5), (2, 6), (3, 7)]
        width = style.line_width
        edges = [
            line_actor(_BOX, between, style.frustum, width),
            line_actor(_BOX, [(*far, far[0])], style.far, 1.7 * width),
            line_actor(_BOX, [(*near, near[0])], style.near, 1.7 * width),
        ]
        middle = np.array([(axis * sign) for axis in np.eye(3) for sign in (-1.0, 1.0)])
        middle = middle * (1.0, 1.0, 0.5) + (0.0, 0.0, 0.5)
        cross = line_actor(middle, [(0, 1), (2, 3), (4, 5)], style.muted, 0.7 * width)
        faces = [
            face_actor(_BOX, [far], style.far, _TINT),
            face_actor(_BOX, [near], style.near, _TINT),
        ]
        self._outlines = {"far": edges[1], "near": edges[2]}
        self._cross = cross
        for actor in (*edges, cross, *faces):
            self._volume.add(actor)
            self._canvas.add(actor)
        self._volume_actors = (*edges, *faces)
        for edge in edges:
            lift_lines(edge, 2)
        for face in faces:
            put_behind(face)
        right, up, along = np.eye(3)
        self._arrows: list[Any] = []
        self._add_arrow(self._box, CUBE_CORNERS[4], right, style.u, width)
        self._add_arrow(self._box, CUBE_CORNERS[4], up, style.v, width)
        self._add_arrow(self._z_axis, CUBE_CORNERS[2], along, style.n, width)

    def _add_arrow(
        self,
        space: Space,
        start: NDArray[np.float64],
        direction: NDArray[np.float64],
        colour: str,
        width: float,
    ) -> None:
        """An axis along one of the cube's edges and on beyond its end at +1."""
        tip = start + (2.0 + _OVERSHOOT) * direction
        shaft = line_actor([start, tip], [(0, 1)], colour, 1.7 * width)
        head = unlit_actor(
            pv.Cone(center=tip, direction=direction, height=0.14, radius=0.045, resolution=24)
        )
        head.GetProperty().SetColor(*rgb(colour))
        lift_lines(shaft, 3)
        for actor in (shaft, head):
            space.add(actor)
            self._canvas.add(actor)
            self._arrows.append(actor)

    def _add_triad(self, style: Style) -> None:
        """The axes of the other stops: shafts of length 1 and their heads, along x."""
        self._triad: list[tuple[Space, Space, Any, Any]] = []
        for colour in (style.u, style.v, style.n):
            shaft = line_actor([(0, 0, 0), (1, 0, 0)], [(0, 1)], colour, 1.7 * style.line_width)
            head = unlit_actor(pv.Cone(direction=(1, 0, 0), height=0.14, radius=0.045))
            head.GetProperty().SetColor(*rgb(colour))
            lift_lines(shaft, 3)
            spaces = Space(), Space()
            for space, actor in zip(spaces, (shaft, head), strict=True):
                space.add(actor)
                actor.SetVisibility(False)
                self._canvas.add(actor)
            self._triad.append((*spaces, shaft, head))

    def _add_words(self, words: Mapping[str, str], style: Style) -> None:
        label = self._canvas.label
        self._near = label(words["near"], plate=style.near, offset_em=(0.7, 0.3), anchor=(-1, -1))
        self._far = label(words["far"], plate=style.far, offset_em=(0.7, 0.3), anchor=(-1, -1))
        below, left, right = (0.0, -0.4), (-0.5, 0.0), (0.5, -0.7)
        self._numbers = {
            "x": (
                label("−1", offset_em=below, anchor=(0, 1)),
                label("1", offset_em=below, anchor=(0, 1)),
            ),
            "y": (
                label("−1", offset_em=left, anchor=(1, 0)),
                label("1", offset_em=left, anchor=(1, 0)),
            ),
            "z": (
                label("", offset_em=right, anchor=(-1, 0), plate=style.background),
                label("", offset_em=right, anchor=(-1, 0), plate=style.background),
            ),
        }
        self._letters = {
            "x": label(words["x"], plate=style.u, offset_em=(0.6, 0.0), anchor=(-1, 0)),
            "y": label(words["y"], plate=style.v, offset_em=(0.0, 0.6), anchor=(0, -1)),
            "z": label(words["z"], plate=style.n, offset_em=(0.4, 0.6), anchor=(0, -1)),
        }

    def _make_emphasis(self, style: Style) -> None:
        self._emphasis = emphasis = Emphasis(self._canvas)
        for face in emphasis.volume(self._volume, _BOX[_NEAR_FIRST], 6.0 * style.line_width, style):
            put_behind(face)
        for name, line in self._outlines.items():
            emphasis.line(line, name)
        for i, axis in enumerate(AXES):
            emphasis.line(self._arrows[2 * i], axis)
            emphasis.line(self._triad[i][2], axis)
        for name, label in (
            ("near", self._near), ("far", self._far),
            *zip(AXES, self._letters.values(), strict=True),
        ):  # fmt: skip
            emphasis.label(label, name)
        self._attended: Attention = frozenset()

    def _set_volume(self, display_from_box: Array) -> None:
        self._display_from_box = display_from_box
        self._volume.set(display_from_box)

    # -- pointing

    def show_attention(self, attended: Attention) -> bool:
        """Let what is attended to stand out, and nothing else; tell whether that is a change."""
        self._attended = attended
        return self._show_attended()

    def _show_attended(self) -> bool:
        return self._emphasis.show(self._attended - self._strangers)

    @property
    def _strangers(self) -> frozenset[str]:
        """At the world's stop the axes are x, y and z of the world, not the camera's."""
        at_world = int(self._position + 0.5) == WORLD
        return frozenset(AXES) if at_world else frozenset()

    def attention_at(self, x_px: float, y_px: float) -> Attention:
        """What is at a pixel from the pane's top left."""
        found = self._emphasis.label_at(x_px, y_px)
        if not found:
            homogeneous = np.column_stack([_BOX[_NEAR_FIRST], np.ones(8)])
            pane = self._pane_from_display @ self._display_from_box
            corners = _spots(homogeneous @ pane.T)
            points = [(frozenset((name,)), at) for name, at in zip(CORNERS, corners, strict=True)]
            segments: list[Segment] = volume_edges(corners)
            if self._position == NDC:
                segments += self._axis_segments()
            found = pointed_at(
                (x_px, y_px), self._canvas.style.font_size, points, segments, corners
            )
        return found - self._strangers

    def _axis_segments(self) -> list[Segment]:
        """Where the cube's axes go beyond it; along the cube they are its edges."""
        half, end = self._half_depth, 1.0 + _OVERSHOOT
        toward_reader = half if self._depth == "reversed" else -half
        ends = {
            "u": ((1.0, -1.0, half, 1.0), (end, -1.0, half, 1.0)),
            "v": ((-1.0, 1.0, half, 1.0), (-1.0, end, half, 1.0)),
            "n": ((1.0, 1.0, toward_reader, 1.0), (1.0, 1.0, toward_reader * end, 1.0)),
        }
        segments: list[Segment] = []
        for axis, both in ends.items():
            start, tip = _spots(np.array(both) @ self._pane_from_display.T)
            segments.append((frozenset((axis,)), start, tip))
        return segments

    # -- changed when the depth range or the pane's size changes, never by a slider

    def _set_depth(self, depth: str) -> None:
        self._depth = depth
        z_near, z_far = DEPTH_RANGES[depth]
        half = abs(z_far - z_near) / 2.0
        toward_reader = 1.0 if z_near > z_far else -1.0
        self._half_depth = half
        self._box.set(np.diag([1.0, 1.0, half, 1.0]))
        volume = np.diag([1.0, 1.0, 2.0 * half, 1.0])
        volume[2, 3] = -half
        self._set_volume(volume)
        self._z_axis.set(np.diag([1.0, 1.0, toward_reader * half, 1.0]))
        for axis, (positive, negative) in enumerate(zip(*[iter(self._planes)] * 2, strict=True)):
            for plane, inward in ((positive, 1.0), (negative, -1.0)):
                normal = inward * np.eye(3)[axis]
                plane.SetNormal(*normal)
                plane.SetOrigin(*-normal)
        self._planes[4].SetOrigin(0.0, 0.0, -half)
        self._planes[5].SetOrigin(0.0, 0.0, half)
        self._near.set_position((-1.0, 1.0, half))
        self._far.set_position((-1.0, 1.0, -half))
        end = 1.0 + _OVERSHOOT
        self._letters["x"].set_position((end, -1.0, half))
        self._letters["y"].set_position((-1.0, end, half))
        self._letters["z"].set_position((1.0, 1.0, toward_reader * half * end))
        for x, number in zip((-1.0, 1.0), self._numbers["x"], strict=True):
            number.set_position((x, -1.0, half))
        for y, number in zip((-1.0, 1.0), self._numbers["y"], strict=True):
            number.set_position((-1.0, y, half))
        for z, side, number in zip((z_near, z_far), (half, -half), self._numbers["z"], strict=True):
            number.set_text(f"{z:.0f}".replace("-", "−"))
            number.set_position((1.0, 1.0, side))

    # -- the other stops of the strip

    def _show_moment(self) -> None:
        """Set the matrices, planes and words of a position that is not the NDC stop."""
        if self._morph is None:
            scene = self._scene
            kind = Morph if self._projection.lens.has_steps else FreeMorph
            self._morph = kind(self._projection, scene.origin, scene.corners)
        morph, position = self._morph, self._position
        self._model.show_local()
        self._space.set(_fitting(morph.display_from_local(position)))
        drawn = morph.has_volume(position)
        for actor in self._volume_actors:
            actor.SetVisibility(drawn)
        box = _fitting(morph.display_from_box(position)) if drawn else np.eye(4)
        self._set_volume(box)
        for plane, (*normal, offset) in zip(
            self._planes, morph.planes_display(position).tolist(), strict=True
        ):
            plane.SetNormal(*normal)
            plane.SetOrigin(*(-offset * part for part in normal))
        stop = int(position + 0.5)
        if not self._projection.lens.has_steps and VIEW < stop < NDC:
            stop = VIEW if position < (VIEW + NDC) / 2.0 else NDC
        self._name_stop(stop)
        for label in (self._near, self._far):
            label.set_visible(drawn and stop != IMAGE)
        self._place_axes(stop, morph, box)
        if drawn:
            self._place_words(stop, box)
        self._place_probes()

    def _name_stop(self, stop: int) -> None:
        """Show the axes, letters and numbers that a stop has."""
        if stop == NDC:
            for name in "xy":
                for number, text in zip(self._numbers[name], ("−1", "1"), strict=True):
                    number.set_text(text)
        if (stop, self._projection.lens.kind) == self._named:
            return
        self._named = stop, self._projection.lens.kind
        self._show_attended()
        self._cross.SetVisibility(stop in (CANONICAL_PARALLEL, NDC))
        for actor in self._arrows:
            actor.SetVisibility(stop == NDC)
        for i, (_, _, shaft, head) in enumerate(self._triad):
            for actor in (shaft, head):
                actor.SetVisibility(stop != NDC and not (stop == IMAGE and i == 2))
        self._near.set_text(self._words["near"])
        letters = "uvn" if stop == VIEW else "xyz"
        for letter, name in zip(self._letters.values(), letters, strict=True):
            letter.set_text(self._words[name])
        for label in (self._letters["z"], self._near, self._far):
            label.set_visible(stop != IMAGE)
        for name, numbers in self._numbers.items():
            for number in numbers:
                number.set_visible(stop >= CANONICAL_PERSPECTIVE and (stop != IMAGE or name != "z"))
        if stop == CANONICAL_PERSPECTIVE and self._projection.lens.has_pyramid:
            self._numbers["z"][0].set_visible(False)  # on the plate of near, which is small here

    def _place_axes(self, stop: int, morph: Morph, box: Array) -> None:
        """Put axes and letters where the nearest stop has them."""
        if stop == NDC:
            cube = box @ _BOX_FROM_CUBE
            toward_reader = 1.0 if self._projection.depth == "reversed" else -1.0
            z_axis = cube @ np.diag([1.0, 1.0, toward_reader, 1.0])
            self._box.set(cube)
            self._z_axis.set(z_axis)
            end = 1.0 + _OVERSHOOT
            for name, matrix, point in (
                ("x", cube, (end, -1.0, 1.0, 1.0)),
                ("y", cube, (-1.0, end, 1.0, 1.0)),
                ("z", z_axis, (1.0, 1.0, end, 1.0)),
            ):
                place = matrix @ point
                self._letters[name].set_position(place[:3] / place[3])
            return
        axes, lengths = np.eye(3), np.full(3, _TRIAD)
        if stop <= VIEW:
            matrix = morph.display_from_local(self._position)
            camera = self._projection.camera
            at = (0.0, 0.0, 0.0) if stop == WORLD else camera.eye
            seen = matrix @ [*(np.array(at) - self._scene.origin), 1.0]
            if stop == VIEW and not self._projection.lens.has_steps:
                # Of view space itself: its matrix need not be the camera's.
                seen, matrix = morph.display_from_stage(VIEW)[:, 3], np.eye(4)
                camera = _LEVEL
            start = seen[:3] / (seen[3] if seen[3] > 0.0 else 1.0)
            away = math.hypot(*start)
            if away > RADIUS:  # an origin that is far from the scene: at the border toward it
                start *= RADIUS / away
            axes = matrix[:3, :3] @ (axes if stop == WORLD else camera.frame.T)
            axes = (axes / np.linalg.norm(axes, axis=0)).T
        elif stop == IMAGE:
            start = (box @ (-1.0, 1.0, 1.0, 1.0))[:3] / (box @ (-1.0, 1.0, 1.0, 1.0))[3]
            corner = (box @ (1.0, -1.0, 1.0, 1.0))[:3] / (box @ (1.0, -1.0, 1.0, 1.0))[3]
            lengths = np.abs(corner - start) + _OVERSHOOT
            axes[1] = -axes[1]
        else:
            start = np.array([0.0, 0.0, 0.5])
            lengths[:2] = _CANONICAL_TRIAD
        for (shaft, head, *_), axis, length, letter in zip(
            self._triad, axes, lengths, self._letters.values(), strict=True
        ):
            tip = start + length * axis
            along = _along(axis)
            along[:3, 3] = tip
            head.set(along)
            along = along @ np.diag([length, 1.0, 1.0, 1.0])
            along[:3, 3] = start
            shaft.set(along)
            letter.set_position(tip)

    def _place_words(self, stop: int, box: Array) -> None:
        """Put near, far and the ends of the axes at the corners of the view volume."""
        limit = RADIUS if stop <= VIEW else 2.0
        near, far = (_edge(box, -1.0, 1.0, limit, z) for z in (1.0, 0.0))
        lens = self._projection.lens
        pyramid = lens.has_pyramid
        if stop <= CANONICAL_PERSPECTIVE and pyramid:
            aside = _BESIDE
            if stop > VIEW:
                lens = self._projection.lens
                # As far as the near face is small, and the pane has turned to where it looks so.
                part = 1.0 - abs(self._position - CANONICAL_PERSPECTIVE)
                aside = part * (1.0 - lens.near / lens.far / 2.0) * _BESIDE_PYRAMID
            near = near + aside @ np.array(_axes_from(*self._looked_from(stop))[:2])
        self._near.set_position(near)
        self._far.set_position(far)
        if stop <= VIEW:
            return
        (width, height) = self._projection.image_size
        x, y = ("−1", "1"), ("−1", "1")
        ends, z = (1.0, 1.0), ("0", "−1")
        if stop == CANONICAL_PERSPECTIVE and pyramid:
            # The sides are 1 where z is -1: at far, and at near if far is infinite.
            infinite = lens.far == math.inf
            ends = (1.0, 1.0) if infinite else (0.0, 0.0)
            z = ("", "−∞" if infinite else "−1")
            at = -1.0 if infinite else -lens.near / lens.far
            self._near.set_text(f"{self._words['near']} {_number(at)}")
        elif stop == NDC:
            z_near, z_far = self._projection.depth_range
            z = (_number(z_near), _number(z_far))
        elif stop == IMAGE:
            x, y = ("0", str(width)), (str(height), "0")
        for name, texts, corners in (
            ("x", x, ((-1.0, -1.0, ends[0]), (1.0, -1.0, ends[0]))),
            ("y", y, ((-1.0, -1.0, ends[1]), (-1.0, 1.0, ends[1]))),
            ("z", z, ((1.0, 1.0, 1.0), (1.0, 1.0, 0.0))),
        ):
            for number, text, (across, up, along) in zip(
                self._numbers[name], texts, corners, strict=True
            ):
                number.set_text(text)
                number.set_position(_edge(box, across, up, limit, along))

    def _layout(self, _width_px: int, _height_px: int) -> None:
        if self._current_view() == self._view:  # nobody has turned it since: keep it whole
            self.reset_view()

    def _current_view(self) -> tuple[float, ...]:
        camera = self._camera
        return (*camera.GetPosition(), *camera.GetFocalPoint(), camera.GetParallelScale())


def _spots(homogeneous: Array) -> list[Spot]:
    """Pixels and depth of points (n, 4) of the pane; NaN for what is at infinity or beyond."""
    w = homogeneous[:, 3:]
    spots = homogeneous[:, :3] / np.where(w > 0.0, w, np.nan)
    return list(map(tuple, spots.tolist()))


def _axes_from(azimuth_deg: float, elevation_deg: float) -> tuple[Array, Array, Array]:
    """Right, up and toward the reader of a camera at these angles."""
    azimuth, elevation = math.radians(azimuth_deg), math.radians(elevation_deg)
    right = np.array([math.cos(azimuth), 0.0, -math.sin(azimuth)])
    toward = np.array(
        [
            math.sin(azimuth) * math.cos(elevation),
            math.sin(elevation),
            math.cos(azimuth) * math.cos(elevation),
        ]
    )
    return right, _cross(toward, right), toward


def _cross(one: Array, other: Array) -> Array:
    """The cross product of two vectors, in a tenth of the time that numpy's own takes for one."""
    a, b, c = one.tolist()
    x, y, z = other.tolist()
    return np.array([b * z - c * y, c * x - a * z, a * y - b * x])


def _fitting(matrix: Array) -> Array:
    """A homogeneous matrix without a common factor that could keep it from float32."""
    fitting: Array = matrix * 2.0 ** -math.frexp(float(np.abs(matrix).max()))[1]
    return fitting


def _along(axis: Array) -> Array:
    """A rotation that takes x to a direction, (4, 4)."""
    other = np.eye(3)[int(np.abs(axis).argmin())]
    side = _cross(axis, other)
    side /= math.hypot(*side)
    matrix = np.eye(4)
    matrix[:3, :3] = np.column_stack([axis, side, _cross(axis, side)])
    return matrix


def _edge(box: Array, across: float, up: float, limit: float, z: float) -> Array:
    """Where the corner of the view volume is shown, or its edge leaves the ball that is framed."""
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
    shown: Array = start + along * (length / far[3] if inside else leaves)
    return shown


def _number(value: float) -> str:
    return f"{value:.3g}".replace("-", "−")
