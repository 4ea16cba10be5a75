"""The world pane: the scene, the camera in it, and the camera's frustum.

The frustum is not computed here: it is the NDC cube's own edges and faces under
``world_from_clip``. So is the picture on the near plane, which is the scene once more under

    local_from_film . flatten . clip_from_local

where flatten squeezes all depths into a thin slab at the near face, on the side from which it is
looked at, so that what is in front stays in front. A slider step sets matrices and nothing else.

Everything is scene-local, ``world - scene.origin`` subtracted in float64. The cubes that are drawn
have the reversed depth range whatever the model's own is: there 1/w of the far face is 1/far
itself, where [-1, 1] makes it a difference of two numbers of the size of 1/near, of which float32
keeps nothing once far/near reaches 1e6. The frustum is the same.

Distances along the line of sight are drawn true to scale from `_Reach.low` to `_Reach.high`. What
lies beyond is drawn at the limit, behind a visible break, with its true distance written there::

    eye <------ near ============== / / - - far 1e+06
    0           1                   break   high
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache, partial
from typing import Any, NamedTuple

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings import actors
from app.drawings.actors import Canvas, Space
from app.drawings.frame import DIMMED, LARGER, TIPS, FrameSteps, arrow, arrow_tips, is_built
from app.drawings.handles import APART_EM, HandleMarks
from app.drawings.labels import AXES, Labels, Layout, Named, PaneView
from app.drawings.marks import MarksDrawing, Placing, spread_over
from app.drawings.pointing import Emphasis, Segment, Spot, pointed_at, volume_edges
from app.drawings.probes import Probes
from app.drawings.rasterising import Rasteriser
from app.drawings.style import Style
from app.lecture.highlight import CORNERS, Attention
from app.model.projection import (
    Array,
    Camera,
    Lens,
    Orthographic,
    Perspective,
    Projection,
)
from app.picking.handles import Handle, nearest, shown
from app.picking.picking import Probe, Sight
from app.scenes.phenomena.illustration import Exhibit, Marks, Rendering
from app.scenes.scene import Scene

SLAB = 0.005
"""Thickness of the picture on the near plane, relative to near (parallel lens: the reach)."""

_BEYOND = 1.3  # how far the frustum is drawn, of the depth of what is looked at
_BREAK = 0.8  # of the reach: where a break begins
_STROKES_AT = 0.38  # of a broken edge
_MARGIN = 0.02  # of the scene's depth, kept free at both ends of the slab
_LINES_IN_FRONT = 0.01  # of the slab: a face must not eat its own edges
_LINES_LIFT = 2e-3  # of the distance from the pane's camera, for the same reason
_VIEW_ANGLE_DEG = 50.0
_ELEVATION_DEG = 25.0  # of the pane's camera, and how far it stands behind the model's
_BEHIND_DEG = 55.0
_FILL = 0.86  # of the pane by what `reset_view` frames; the rest is for the labels
_SHRUNK = 0.4  # of the pane: what fills less of it is brought nearer by `refit`
_WHOLE, _NEARBY = 3.0, 1.1  # of the extent: a frustum that is framed whole; else only so far
_NEAREST = 0.02  # of the pane camera's focal distance: what is nearer is cut
_LEAST_PICTURE_PX = 1.5
_NEAR_TINT, _FAR_TINT = 0.3, 0.16  # opacities
_FADE_FROM, _FADED = 0.6, 0.15  # of the pane under a plane; of the tint when it is all of it
_STEEPEST = 1e16  # edge of a frustum, sideways per distance: a plane, and its square is finite
_WIDEST = 1e35  # edge of a box: larger than any scene, and a float32
_FARTHEST_MARK = 1e3  # of the extent: where lines toward infinity end
_FRAMED_MARK = 5.0  # of the scene's size: marks farther from it are not brought into view
_BODY = 0.065  # size of the camera's body, of the scene's size and distance

# The corners of a box round the camera's body, in view space and sizes of the body.
_BODY_BOX = actors.CUBE_CORNERS * (0.6, 0.58, 0.7) + (0.0, 0.16, 0.7)

# The cube of the reversed range: near face at z = 1, far face at z = 0.
_CUBE = actors.CUBE_CORNERS * (1.0, 1.0, -0.5) + (0.0, 0.0, 0.5)
_NEAR_FACE, _FAR_FACE = (0, 1, 2, 3), (4, 5, 6, 7)
_SIDES = tuple((i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4) for i in range(4))

_SIX_WAYS = np.vstack([np.eye(3), -np.eye(3)])

# The axes' letters stand beyond their tips, best first.
_BEYOND_TIP = (1.2, 1.5, 1.9)

# The eye is where the cube's z axis meets infinity: a pyramid with its apex at the origin and its
# base at z = 1 becomes the eye's pyramid to the near face when z and w change places.
_CUBE_FROM_PYRAMID = np.eye(4)[[0, 1, 3, 2]]


class _Reach(NamedTuple):
    """Which distances from the eye plane are drawn where they are; world units.

    Attributes
    ----------
    low, high : float
        The limits; low is negative: behind the eye, for a parallel lens.
    near, far : float
        Where the planes are drawn, ``low <= near < far <= high``.
    near_break, far_break : (float, float) or None
        From where to where the frustum's edges are broken, if the planes are not drawn where
        they are.
    """

    low: float
    high: float
    near: float
    far: float
    near_break: tuple[float, float] | None
    far_break: tuple[float, float] | None

    @property
    def body(self) -> tuple[float, float]:
        """The part of near..far whose edges are whole."""
        start, end = self.near, self.far
        if self.near_break is not None and self.near_break[0] >= start:
            start = self.near_break[1]
        if self.far_break is not None and self.far_break[1] <= end:
            end = self.far_break[0]
        return start, end


class WorldDrawing:
    """The scene with the camera and its frustum in it.

    Parameters
    ----------
    plotter : pyvista.BasePlotter
        Where to draw; its own camera looks at all this from outside and is not the model's.
    scene : Scene
    words : Mapping[str, str]
        `app.drawings.WORDS` or a translation.
    style : Style
    live : bool
        Whether somebody can take hold of what is drawn: then there are marks to do it by.
    """

    def __init__(
        self,
        plotter: Any,
        scene: Scene,
        words: Mapping[str, str],
        style: Style,
        *,
        live: bool = False,
    ) -> None:
        self._scene, self._style, self._words = scene, style, words
        self._origin = np.array(scene.origin, dtype=np.float64)
        self._objects = _box_corners(scene.lower, scene.upper) - self._origin
        meshes = [mesh for mesh in (scene.surface, scene.lines) if mesh is not None]
        bounds = [np.reshape(mesh.bounds, (3, 2)) for mesh in meshes]
        self._everything = np.concatenate(
            [self._objects, *(_box_corners(b[:, 0], b[:, 1]) for b in bounds)]
        )
        self._canvas = Canvas(plotter, style, self._lay_out)
        self._own_camera = plotter.renderer.GetActiveCamera()
        self._build_scene()
        self._build_camera()
        self._build_frustum()
        self._make_emphasis()
        self._labels = Labels(self._canvas, words)
        for name, label in self._labels.named.items():
            self._emphasis.label(label, name)
        self._probes = Probes(self._canvas, style)
        self._handles = HandleMarks(self._canvas, style) if live else None
        self._attended: Attention = frozenset()
        self._step: int | None = None
        self._steps: FrameSteps | None = None
        self._marks: MarksDrawing | None = None
        self._marked = self._subject = np.empty((0, 3))
        self._grips: dict[str, Array] = {}
        self._camera: Camera | None = None
        self._reach: _Reach | None = None
        self._placed: tuple[float, ...] | None = None
        self._framed = self._framed_first = self._objects
        self._look_from_pane()
        self.show_projection(scene.start)
        self.reset_view()

    # -- building, once per scene

    def _build_scene(self) -> None:
        scene, style = self._scene, self._style
        surface, lines = actors.scene_actors(scene, style)
        self._lines_space = Space()
        self._window_planes = [vtkPlane() for _ in range(6)]
        picture = actors.scene_actors(scene, style, self._window_planes)
        self._picture_space, self._picture_lines_space = Space(), Space()
        for space, actor in (
            (self._lines_space, lines),
            (self._picture_space, picture[0]),
            (self._picture_lines_space, picture[1]),
        ):
            if actor is not None:
                space.add(actor)
        self._picture = [actor for actor in picture if actor is not None]
        self._detail = actors.Detail(surface, picture[0])
        self._textured = (surface, Space()), (picture[0], self._picture_space)
        self._rasterisers: list[Rasteriser] = []
        self._canvas.add(*(a for a in (surface, lines) if a is not None), *self._picture)

    def _build_camera(self) -> None:
        style, add = self._style, self._canvas.add
        width = style.line_width
        self._camera_space, self._axes_space, self._sight_space = Space(), Space(), Space()
        self._eye_space, self._target_space, self._rim_space = Space(), Space(), Space()

        sight = actors.line_actor([(0, 0, 0), (0, 0, -1)], [(0, 1)], style.muted, width)
        self._sight_space.add(sight)
        points, faces, edges = _camera_body()
        body = actors.face_actor(points, faces, style.muted)
        wire = actors.line_actor(points, edges, style.eye, width)
        self._camera_space.add(body, wire)
        eye = actors.point_actor([(0, 0, 0)], style.eye, 5.0 * width)
        target = actors.point_actor([(0, 0, 0)], style.target, 6.0 * width)
        rim = actors.point_actor([(0, 0, 0)], style.ink, 8.0 * width)
        self._eye_space.add(eye)
        self._target_space.add(target)
        self._rim_space.add(rim)
        add(sight, body, wire, eye, rim, target)

        self._shafts: dict[str, vtkActor] = {}
        self._heads: dict[str, vtkActor] = {}
        self._sight = sight
        for axis, tip in TIPS.items():
            shaft, head = arrow(np.array(tip), getattr(style, axis), 2.0 * width)
            self._axes_space.add(shaft, head)
            self._shafts[axis], self._heads[axis] = shaft, head
            add(shaft, head)
        self._discs = {"eye": eye, "target": target}
        self._camera_actors = body, wire

    def _build_frustum(self) -> None:
        style = self._style
        width = style.line_width
        self._frustum_space, self._body_space, self._apex_space = Space(), Space(), Space()

        def outline(face: tuple[int, ...], colour: str) -> vtkActor:
            return actors.line_actor(_CUBE, [(*face, face[0])], colour, 2.0 * width)

        far_face = actors.face_actor(_CUBE, [_FAR_FACE], style.far, _FAR_TINT)
        sides = actors.face_actor(_CUBE, _SIDES, style.frustum, 0.05)
        near_face = actors.face_actor(_CUBE, [_NEAR_FACE], style.near, _NEAR_TINT)
        near_line, far_line = outline(_NEAR_FACE, style.near), outline(_FAR_FACE, style.far)
        self._frustum_space.add(far_face, sides, near_face, near_line, far_line)
        self._outlines = {"near": near_line, "far": far_line}
        self._volume = far_face, sides, near_face, near_line, far_line
        self._tints = (near_face, _NEAR_TINT), (far_face, _FAR_TINT)
        edges = [(i, i + 4) for i in range(4)]
        self._body = actors.line_actor(_CUBE, edges, style.frustum, 1.4 * width)
        self._body_space.add(self._body)
        apex = [(0.0, 0.0, 0.0), *_CUBE[:4]]
        self._apex = actors.line_actor(
            apex, [(0, i) for i in range(1, 5)], style.frustum, 0.8 * width
        )
        self._apex_space.add(self._apex)
        self._breaks: dict[str, list[tuple[Space, vtkActor]]] = {"near": [], "far": []}
        self._break_ends: dict[str, Array] = {}
        for broken_edges in self._breaks.values():
            for _ in range(4):
                edge = actors.line_actor(*_broken_edge(), style.frustum, 1.4 * width)
                broken_edges.append((Space(), edge))
                broken_edges[-1][0].add(edge)
        broken = [edge for edges in self._breaks.values() for _, edge in edges]
        self._dimmable = [
            (actor.GetProperty(), actor.GetProperty().GetOpacity())
            for actor in (
                near_line, far_line, self._body, self._apex, *broken, sides, *self._picture,
                *self._camera_actors,
            )
        ]  # fmt: skip
        self._canvas.add(
            near_line, far_line, self._body, self._apex, *broken,
            far_face, sides, near_face,
        )  # fmt: skip

    def _make_emphasis(self) -> None:
        self._emphasis = emphasis = Emphasis(self._canvas)
        emphasis.volume(self._frustum_space, _CUBE, 6.0 * self._style.line_width, self._style)
        for name, line in (*self._shafts.items(), *self._outlines.items()):
            emphasis.line(line, name)
        emphasis.line(self._apex, "fov")
        for name, mark in self._discs.items():
            emphasis.point(mark, name)

    def remove(self) -> None:
        """Take everything out of the plotter again."""
        self._canvas.remove()

    # -- pointing

    def show_attention(self, attended: Attention) -> bool:
        """Let what is attended to stand out, and nothing else; tell whether that is a change."""
        self._attended = attended
        return self._emphasis.show(attended)

    def show_step(self, step: int | None) -> None:
        """Build the camera's frame up to a step before a dimmed frustum; None for neither.

        Parameters
        ----------
        step : int or None
            Index into `app.lecture.camera_frame.STEPS`.
        """
        if step == self._step:
            return
        self._step = step
        if self._steps is None:
            self._make_steps()
        assert self._steps is not None
        self._steps.show(step)
        for axis, shaft in self._shafts.items():
            for actor in (shaft, self._heads[axis]):
                actor.SetVisibility(step is None or is_built(axis, step))
        self._sight.SetVisibility(step is None or is_built("look", step))
        for line, opacity in self._dimmable:
            line.SetOpacity(opacity * self._light)
        self._labels.dim_planes(self._light)
        self._follow_pane(afresh=True)

    @property
    def _light(self) -> float:
        """How much is seen of the frustum."""
        return 1.0 if self._step is None else DIMMED

    def _make_steps(self) -> None:
        style = self._style
        self._steps = FrameSteps(self._canvas, style)
        for name, thing, shaft, colour in (
            ("up", "up", self._steps.up, style.accent),
            ("look", "target", self._steps.look, style.target),
        ):
            self._emphasis.line(shaft, thing)
            self._emphasis.label(self._labels.add_arrow(name, colour), thing)
        self._emphasis.show(self._attended)

    @property
    def _arrows(self) -> tuple[tuple[str, ...], Array]:
        """The arrows that are drawn at the camera, and from the eye to their tips, world units."""
        camera = self._projection.camera
        tips = {a: TIPS[a] for a in AXES} if self._step is None else arrow_tips(self._step, camera)
        directions = np.array(list(tips.values())).reshape(-1, 3)
        return tuple(tips), self._axes_size * directions @ camera.frame

    @property
    def _axes_size(self) -> float:
        return self._body_size * (1.0 if self._step is None else LARGER)

    def attention_at(self, x_px: float, y_px: float) -> Attention:
        """What is at a pixel from the pane's top left."""
        found = self._emphasis.label_at(x_px, y_px)
        if found:
            return found
        arrows, tips = self._arrows
        points_local = [self._eye, self._target, self._eye + tips, self._corners]
        spots = self._spots(np.vstack(points_local))
        eye, target, *tip_spots = spots[:-8]
        corners = spots[-8:]
        points = [(frozenset((name,)), spot) for name, spot in zip(CORNERS, corners, strict=True)]
        points += [(frozenset(("eye",)), eye), (frozenset(("target",)), target)]
        segments: list[Segment] = [
            (frozenset(("target" if name == "look" else name,)), eye, tip)
            for name, tip in zip(arrows, tip_spots, strict=True)
        ]
        segments += volume_edges(corners)
        lens = self._projection.lens
        if lens.central:
            segments += [(frozenset(("fov",)), eye, corner) for corner in corners[:4]]
        return pointed_at((x_px, y_px), self._canvas.style.font_size, points, segments, corners)

    def _spots(self, points: Array) -> list[Spot]:
        height_px = self._pane.size_px[1]
        return [
            (x, height_px - y, -1.0 / depth) if depth > 0.0 else (math.nan, math.nan, math.nan)
            for x, y, depth in self._pane.seen(points)
        ]

    # -- the model

    def show_detail(self, fewer: Scene | None) -> None:
        """Take the faces of a scene with fewer triangles, or all for None; draw nothing yet."""
        self._detail.show(fewer)
        if self._marks is not None:
            self._marks.show_detail(fewer)

    def show_projection(self, projection: Projection, exhibit: Exhibit | None = None) -> None:
        """Take over the model's matrices, and what a phenomenon shows for it; draw nothing yet.

        Parameters
        ----------
        projection : Projection
        exhibit : Exhibit or None
            Nothing of another one stays.
        """
        self._projection = projection
        if projection.camera is not self._camera:
            self._show_camera(projection.camera)
        if projection.lens.planes is None:
            self._show_free_volume(projection)
        else:
            self._show_volume(projection.lens)
        is_first = self._marks is None and exhibit is not None
        self._show_exhibit(exhibit)
        if is_first and not self._was_moved():
            self.reset_view()
        else:
            self._follow_pane(afresh=False)

    def _show_camera(self, camera: Camera) -> None:
        """What depends on the camera alone, and not on its lens."""
        self._camera = camera
        self._view_from_local, self._local_from_view = _view(camera, self._origin)
        self._eye = np.array(camera.eye) - self._origin
        self._target = np.array(camera.target) - self._origin
        depths = (self._eye - self._everything) @ camera.frame[2]
        self._depths = float(depths.min()), float(depths.max())
        self._objects_depth = float(((self._eye - self._objects) @ camera.frame[2]).max())
        self._extent = self._scene.size + math.dist(camera.eye, self._scene.centre)
        self._body_size = _BODY * self._extent
        self._local_from_body = _scaled(self._local_from_view, self._body_size)
        self._camera_space.set(self._local_from_body)
        self._sight_space.set(_scaled(self._local_from_view, camera.distance))

    def _show_free_volume(self, projection: Projection) -> None:
        """The cube under the inverse of a free matrix, whole; nothing where it has none."""
        self._reach = None
        drawn = projection.frustum_sign != 0
        for actor in (*self._volume, self._body):
            actor.SetVisibility(drawn)
        self._apex.SetVisibility(False)
        for name, edges in self._breaks.items():
            self._break_ends.pop(name, None)
            for _, edge in edges:
                edge.SetVisibility(False)
        self._corners = np.tile(self._eye, (8, 1))
        if drawn:
            local_from_cube = projection.with_depth("reversed").world_from_clip_at(self._origin)
            frustum = _normalised(projection.frustum_sign * local_from_cube)
            self._corners = np.clip(_applied(frustum, _CUBE), -_WIDEST, _WIDEST)
            self._frustum_space.set(frustum)
            self._body_space.set(frustum)

    def _show_volume(self, lens: Lens) -> None:
        """A lens' frustum, broken where it is too deep to be drawn true to scale."""
        self._reach = reach = self._reach_of(lens)
        for actor in self._volume:
            actor.SetVisibility(True)
        view_from_cube = self._view_from_cube(reach.near, reach.far)
        frustum = _normalised(self._local_from_view @ view_from_cube)
        self._corners = _applied(frustum, _CUBE)
        self._frustum_space.set(frustum)
        start, end = reach.body
        self._body.SetVisibility(start < end)
        if start < end:
            self._body_space.set(frustum @ _cube_from_part(view_from_cube, start, end))
        for name, broken in (("near", reach.near_break), ("far", reach.far_break)):
            for _, edge in self._breaks[name]:
                edge.SetVisibility(broken is not None)
            self._break_ends.pop(name, None)
            if broken is not None:
                part = _cube_from_part(view_from_cube, *broken)
                self._break_ends[name] = _applied(frustum @ part, _CUBE)
        self._apex.SetVisibility(lens.central)
        if lens.central:
            base = frustum
            if reach.near_break is not None:
                base = _normalised(self._local_from_view @ self._view_from_cube(*reach.near_break))
            self._apex_space.set(base @ _CUBE_FROM_PYRAMID)

    def _reach_of(self, lens: Lens) -> _Reach:
        size, extent = self._scene.size, self._extent
        nearby_target = min(self._projection.camera.distance, 2.0 * extent)
        high = _BEYOND * max(self._objects_depth, nearby_target, 0.5 * size)
        near, far = lens.near, lens.far
        if lens.central:
            low = 0.0
            near = max(near, 1e-12 * high)  # nobody sees the difference; float32 does
        else:
            low = -0.5 * _BEYOND * extent
        near_break = far_break = None
        if near > _BREAK * high:
            near, near_break = _BREAK * high, (_BREAK**2 * high, _BREAK * high)
        elif near < low:
            near, near_break = low, (low, _BREAK * low)
        if far > high:
            far, far_break = high, (_BREAK * high, high)
        elif far < _BREAK * low:
            far, far_break = _BREAK * low, (_BREAK * low, _BREAK**2 * low)
        far = max(far, near + 1e-9 * (high - low))
        return _Reach(low, high, near, far, near_break, far_break)

    def _view_from_cube(self, near: float, far: float) -> Array:
        """`Projection.view_from_clip` for a part of the view volume, (4, 4)."""
        return _part(self._projection, near, far)[1]

    def _place_labels(self, *, afresh: bool) -> bool:
        """The labels, and whether one has changed sides; see `Labels.lay_out`."""
        lens = self._projection.lens
        arrows, directions = self._arrows
        tips = np.concatenate([self._eye + k * directions for k in _BEYOND_TIP])
        body = _applied(self._local_from_body, _BODY_BOX)
        planes = None if lens.planes is None else (lens.near, lens.far)
        seen = lens.planes is not None or self._projection.frustum_sign != 0
        corners = self._corners if seen else None
        named = Named(self._eye, self._target, arrows, tips, body, corners, planes)
        first = None
        if self._marks is not None or (self._handles is not None and seen):
            first = partial(self._place_first, afresh=afresh, corners=corners)
        return self._labels.lay_out(self._pane, named, afresh=afresh, first=first)

    def _place_first(
        self,
        layout: Layout,
        seen: Callable[[Array], Sequence[Spot]],
        *,
        afresh: bool,
        corners: Array | None,
    ) -> None:
        """What the labels keep off: the far corners' handles, and the texts of a scene."""
        if self._handles is not None and corners is not None:
            layout.keep_free(seen(corners[4:]))
        if self._marks is not None:
            self._place_texts(layout, seen, afresh=afresh)

    def _place_texts(
        self, layout: Layout, seen: Callable[[Array], Sequence[Spot]], *, afresh: bool
    ) -> None:
        assert self._marks is not None
        subject = None
        if afresh:
            spots = [spot[:2] for spot in seen(self._subject) if spot[2] > 0.0]
            subject = np.array(spots).reshape(-1, 2)
        self._marks.place_texts(layout, seen, subject)

    def _tint_planes(self) -> None:
        """The planes' tints, which fade where they would flood the pane."""
        parts = self._pane.parts_covered(self._corners, _FADE_FROM)
        for (tint, opacity), part in zip(self._tints, parts, strict=True):
            flood = (part - _FADE_FROM) / (1.0 - _FADE_FROM)
            tint.GetProperty().SetOpacity(
                self._light * opacity * (1.0 - (1.0 - _FADED) * max(0.0, flood))
            )

    def _place_picture(self) -> None:
        """The scene, flattened onto the near plane, and the planes of the picture's window."""
        reach, pane, lens = self._reach, self._pane, self._projection.lens
        left_bottom, right_top = self._corners[0], self._corners[2]
        px = math.dist(pane.eye, left_bottom) * 2.0 * pane.slope / pane.size_px[1]
        depths = self._depths
        seen = math.dist(left_bottom, right_top) > _LEAST_PICTURE_PX * px
        if lens.planes is None:
            seen = seen and self._projection.frustum_sign > 0
        else:
            assert reach is not None
            seen = (
                seen and reach.near_break is None and depths[1] > lens.near and depths[0] < lens.far
            )
        for actor in self._picture:
            actor.SetVisibility(seen)
        if not seen:
            return
        if reach is None:
            film = _flattened_free(self._projection, self._origin, pane.eye)
        else:
            away = pane.eye - self._eye
            from_eye_side = float(away @ self._projection.camera.frame[2]) > -reach.near
            view = self._view_from_local, self._local_from_view
            film = flatten(self._projection, view, depths, reach.high, toward_eye=from_eye_side)
        self._picture_space.set(film.surface)
        self._picture_lines_space.set(film.lines)
        for plane, (*normal, offset) in zip(self._window_planes, film.planes.tolist(), strict=True):
            plane.SetNormal(normal)
            plane.SetOrigin([-offset * part for part in normal])

    def _place_breaks(self) -> None:
        """Turn the strokes of each broken edge until they cross it in the plane of the screen."""
        pane, em = self._pane, self._canvas.style.font_size
        height_px = pane.size_px[1]
        for name, ends in self._break_ends.items():
            starts, along = ends[:4], ends[4:] - ends[:4]
            x, y, depth = pane.axes @ (starts + _STROKES_AT * along - pane.eye).T
            depth = np.maximum(np.abs(depth), 1e-9 * self._extent)
            unit = 2.0 * pane.slope * depth / height_px  # the world's size of a pixel there
            right, up, away = pane.axes @ along.T
            right, up = right - x * away / depth, up - y * away / depth
            length = np.hypot(right, up)
            turned = length > 1e-3 * unit
            right = np.where(turned, right / np.where(turned, length, 1.0), 1.0)
            up = np.where(turned, up / np.where(turned, length, 1.0), 0.0)
            size = unit * em * np.clip(length / (2.5 * em * unit), 0.65, 1.0)
            on = np.stack([right, up], axis=1) @ pane.axes[:2] * size[:, None]
            across = np.stack([-up, right], axis=1) @ pane.axes[:2] * size[:, None]
            matrices = np.zeros((4, 4, 4))
            matrices[:, :3] = np.stack([along, across, on, starts], axis=2)
            matrices[:, 3, 3] = 1.0
            for (space, _), matrix in zip(self._breaks[name], matrices, strict=True):
                space.set(matrix)

    # -- the pane's own camera

    def reset_view(self) -> None:
        """Put the pane's own camera beside the model's, with all that is drawn in view."""
        frame = self._projection.camera.frame
        behind = np.array([frame[2, 0], 0.0, frame[2, 2]])
        beside = np.cross(behind, (0.0, 1.0, 0.0))
        if np.linalg.norm(beside) < 0.2:  # it looks straight down or up: stand at its right
            beside = np.array([frame[0, 0], 0.0, frame[0, 2]])
            if np.linalg.norm(beside) < 0.2:
                beside = np.array([1.0, 0.0, 0.0])
        beside /= np.linalg.norm(beside)
        if beside @ (0.3, 0.0, 1.0) < 0.0:  # scenes show their fronts to +z
            beside = -beside
        turn, rise = math.radians(_BEHIND_DEG), math.radians(_ELEVATION_DEG)
        level = math.cos(turn) * beside + math.sin(turn) * behind
        level /= np.linalg.norm(level)
        self._direction = math.cos(rise) * level + np.array([0.0, math.sin(rise), 0.0])
        self._framed = self._framed_first = self._points_to_frame()
        width_px, height_px = self._canvas.window.GetSize()
        self._place_view(max(1, width_px), max(1, height_px))

    def refit(self) -> bool:
        """Fit a view that nobody has moved, if what it framed has left it or nearly vanished.

        And go back to what `reset_view` framed as soon as that shows everything again, as after
        an undo. The direction of looking stays. To be called when a gesture ends, never during
        one: while a control is dragged the pane stands still, so that the model is what is seen
        moving. The labels, which stay on their sides as long as they can, are placed afresh: at
        rest the picture depends on nothing that was before.

        Returns
        -------
        bool
            Whether anything was changed, and so has to be painted again.
        """
        if self._was_moved():
            return self._place_labels(afresh=True)
        framed = self._points_to_frame()
        width_px, height_px = (max(1, side) for side in self._canvas.window.GetSize())
        first, now = self._framed_first, self._framed
        if now is not first and self._fits(framed, self._stand(first, width_px, height_px)[0]):
            framed = first
        elif self._fits(framed, self._pane.eye):
            return self._place_labels(afresh=True)
        self._framed = framed
        self._place_view(width_px, height_px)
        return True

    def _fits(self, points: Array, eye: Array) -> bool:
        """Whether points are in the view from `eye` in the direction of now, and large enough."""
        x, y, depth = self._pane.axes @ (points - eye).T
        if depth.min() <= 0.0:
            return False
        width_px, height_px = self._pane.size_px
        # From -1 to 1 in the pane.
        across = x / (depth * self._pane.slope * width_px / height_px)
        up = y / (depth * self._pane.slope)
        largest = max(float(np.ptp(across)), float(np.ptp(up))) / 2.0
        inside = max(float(np.abs(across).max()), float(np.abs(up).max())) <= 1.0
        return inside and largest >= _SHRUNK

    def _was_moved(self) -> bool:
        camera = self._own_camera
        return self._placed != (*camera.GetPosition(), *camera.GetFocalPoint())

    @property
    def view(self) -> Camera | None:
        """Where the pane's own camera was moved to, in world coordinates; None if it was not."""
        if not self._was_moved():
            return None
        camera, origin = self._own_camera, self._origin
        eye, target = camera.GetPosition(), camera.GetFocalPoint()
        return Camera(tuple(origin + eye), tuple(origin + target), camera.GetViewUp())

    def show_view(self, view: Camera) -> None:
        """Move the pane's own camera to a `view` of before."""
        camera = self._own_camera
        camera.SetPosition(*(view.eye - self._origin))
        camera.SetFocalPoint(*(view.target - self._origin))
        camera.SetViewUp(*view.up)
        self.reset_clipping_range()

    def _points_to_frame(self) -> Array:
        """What `reset_view` brings into view: of a very wide frustum only the part nearby.

        The wider beyond `_WHOLE`, the less of it, steadily: where the frustum cannot be seen
        whole without losing the scene, the scene is what matters.
        """
        centre = (self._objects.mean(axis=0) + self._eye) / 2.0
        body = self._around_body()
        away = np.linalg.norm(self._marked - self._objects.mean(axis=0), axis=1)
        marked = self._marked[away <= _FRAMED_MARK * self._scene.size]
        points = np.concatenate([self._objects, body, self._corners, [self._target], marked])
        offsets = points - centre
        lengths = np.maximum(np.linalg.norm(offsets, axis=1, keepdims=True), 1e-300)
        whole, nearby = _WHOLE * self._extent, _NEARBY * self._extent
        shown = np.minimum(lengths, np.maximum(whole * (whole / lengths), nearby))
        framed: Array = centre + offsets * (shown / lengths)
        return framed

    def _place_view(self, width_px: int, height_px: int) -> None:
        """Stand in `_direction` from the framed points, as near as this window allows."""
        camera = self._own_camera
        position, seen = self._stand(self._framed, width_px, height_px)
        camera.SetParallelProjection(False)
        camera.SetViewAngle(_VIEW_ANGLE_DEG)
        camera.SetPosition(*position)
        camera.SetFocalPoint(*seen)
        camera.SetViewUp(0.0, 1.0, 0.0)
        self._placed = (*camera.GetPosition(), *camera.GetFocalPoint())
        self.reset_clipping_range()

    def _stand(self, framed: Array, width_px: int, height_px: int) -> tuple[Array, Array]:
        """Where to stand for these points, and what to look at: (3,) each."""
        out = self._direction
        right = np.cross((0.0, 1.0, 0.0), out)
        right /= np.linalg.norm(right)
        up = np.cross(out, right)
        x, y, z = np.stack([right, up, out]) @ framed.T
        half = math.tan(math.radians(_VIEW_ANGLE_DEG / 2.0)) * _FILL
        centre, distance = [], -math.inf
        for across, slope in ((x, half * width_px / height_px), (y, half)):
            low, high = float((slope * z - across).max()), float((slope * z + across).max())
            centre.append((high - low) / 2.0)
            distance = max(distance, (high + low) / (2.0 * slope))
        middle = float(self._objects.mean(axis=0) @ out + self._eye @ out) / 2.0
        position: Array = centre[0] * right + centre[1] * up + distance * out
        return position, position + (middle - distance) * out

    def _lay_out(self, width_px: int, height_px: int) -> None:
        """Fit a view that nobody has moved into a window of another size."""
        if self._was_moved():
            self.reset_clipping_range()
        else:
            self._place_view(width_px, height_px)

    def reset_clipping_range(self) -> None:
        """Follow the pane's own camera after it was moved."""
        self._look_from_pane()
        self._lines_space.set(self._lifted(1.0))
        if self._marks is not None:
            self._marks.place_copies(self._lifted)
        self._follow_pane(afresh=True)

    def _lifted(self, times: float) -> Array:
        """Nearer to the pane's camera by a part of the distance, for lines on faces, (4, 4)."""
        lift = np.eye(4)
        lift[:3, :3] *= 1.0 - times * _LINES_LIFT
        lift[:3, 3] = times * _LINES_LIFT * self._pane.eye
        return lift

    def _look_from_pane(self) -> None:
        camera = self._own_camera
        toward = np.array(camera.GetDirectionOfProjection())
        right = np.cross(toward, camera.GetViewUp())
        right /= np.linalg.norm(right)
        axes = np.stack([right, np.cross(right, toward), toward])
        slope = math.tan(math.radians(camera.GetViewAngle()) / 2.0)
        width_px, height_px = self._canvas.window.GetSize()
        size_px = max(1, width_px), max(1, height_px)
        self._pane = PaneView(np.array(camera.GetPosition()), axes, slope, size_px)

    def _follow_pane(self, *, afresh: bool) -> None:
        """All that depends on the model and on where the pane's camera stands."""
        self._place_labels(afresh=afresh)
        self._tint_planes()
        self._place_picture()
        self._place_breaks()
        self._fit_range()
        self._place_probes()

    def _fit_range(self) -> None:
        """The pane camera's near and far, and what is drawn just behind near."""
        camera, toward = self._own_camera, self._pane.axes[2]
        points = np.concatenate(
            [self._everything, self._around_body(), self._corners, self._marked]
        )
        depths = (points - self._pane.eye) @ toward
        eye_depth = float((self._eye - self._pane.eye) @ toward)
        target_depth = float((self._target - self._pane.eye) @ toward)
        axes_depth = eye_depth - 4.6 * self._axes_size  # brought before the body, see below
        nearest = 0.95 * min(float(depths.min()), target_depth, axes_depth)
        nearest = max(nearest, _NEAREST * camera.GetDistance())
        farthest = max(1.02 * max(float(depths.max()), target_depth), 2.0 * nearest)
        camera.SetClippingRange(nearest, farthest)
        # All that is shrunk towards the pane's camera stays on its pixel, but comes before what
        # would hide it.
        for space, point, depth, on_top in (
            (self._eye_space, self._eye, eye_depth, 1.01),
            (self._target_space, self._target, target_depth, 1.02),
            (self._rim_space, self._target, target_depth, 1.03),
        ):
            k = _shrinking(depth, on_top * nearest)
            space.place(k, (1.0 - k) * self._pane.eye + k * point)
        k = _shrinking(eye_depth, max(nearest, eye_depth - 2.0 * self._axes_size))
        pane_from_axes = _scaled(self._local_from_view, k * self._axes_size)
        pane_from_axes[:3, 3] = (1.0 - k) * self._pane.eye + k * self._eye
        self._axes_space.set(pane_from_axes)
        if self._step is not None and self._steps is not None:
            self._steps.place(pane_from_axes, self._projection.camera)
        self._place_handles()

    def _rasterise(self, rendering: Rendering | None) -> None:
        """Lay the texture over the faces, and over those in the picture on the near plane."""
        if rendering is None or "texture" not in self._scene.requires:
            return
        if not self._rasterisers:
            self._rasterisers = [
                Rasteriser(
                    self._scene,
                    self._style,
                    {"texture"},
                    self._canvas.add,
                    (actor, space),
                    picture=False,
                )
                for actor, space in self._textured
                if actor is not None
            ]
        for rasteriser in self._rasterisers:
            rasteriser.show(rendering, self._projection)

    def show_probes(self, probes: Sequence[Probe]) -> None:
        """Mark these probes, and no others."""
        self._probes.probes = probes
        self._place_probes()

    def _show_exhibit(self, exhibit: Exhibit | None) -> None:
        """What a phenomenon shows, but for its texts."""
        self._rasterise(None if exhibit is None else exhibit.rendering)
        if self._marks is None:
            if exhibit is None:
                return
            self._subject = spread_over(self._scene)
            self._marks = MarksDrawing(self._canvas, self._scene, self._style, self._words)
        marks, limit = self._marks, _FARTHEST_MARK * self._extent
        self._grips = {} if exhibit is None else {g.setting: g.point for g in exhibit.grips}
        copies = () if exhibit is None else exhibit.copies
        marks.show(
            Marks() if exhibit is None else exhibit.world,
            Placing(np.ones(3), -self._origin, limit),
        )
        marks.show_copies([copy for copy in copies if "world" in copy.panes])
        marks.place_copies(self._lifted)
        x, y, z, w = marks.copied(self._objects, self._everything).T
        w = np.where(w > 0.0, w, np.nan)  # behind a plane that goes to infinity: not drawn
        with np.errstate(over="ignore"):
            copied = np.column_stack([x / w, y / w, z / w])
        copied = copied[(np.abs(copied) <= limit).all(axis=1)]
        self._marked = np.concatenate([marks.points, copied])

    @property
    def sight(self) -> Sight:
        """How this pane looks at the world just now."""
        pane = self._pane
        width_px, height_px = pane.size_px
        px = height_px / (2.0 * pane.slope)
        right, up, toward = pane.axes
        rows = np.zeros((4, 4))
        rows[0, :3] = width_px / 2.0 * toward + px * right
        rows[1, :3] = height_px / 2.0 * toward - px * up
        rows[2, 3] = -1.0
        rows[3, :3] = toward
        nearest, _ = self._own_camera.GetClippingRange()
        return Sight(pane.eye + self._origin, rows, np.array([(*toward, -nearest)]))

    def _place_probes(self) -> None:
        if self._probes.probes:
            drawn, sight = self.planes_drawn, self.sight
            marks = self._probes.in_world(self._projection, self._origin, drawn, sight)
            self._probes.show(marks, self._pane.size_px)
        else:
            self._probes.show((), self._pane.size_px)

    @property
    def planes_drawn(self) -> tuple[float, float]:
        """Distances from the eye plane at which near and far are drawn, cut or not.

        A free matrix has none: its numbers here are nobody's.
        """
        return (0.0, 1.0) if self._reach is None else (self._reach.near, self._reach.far)

    @property
    def held(self) -> Handle | None:
        """The handle that is pointed out."""
        return None if self._handles is None else self._handles.held

    def hold(self, handle: Handle | None) -> None:
        """Point a handle out, and keep it whatever moves; draw nothing yet."""
        if self._handles is not None:
            self._handles.held = handle
            self._place_handles()

    def handle_at(self, pixel: tuple[float, float], within_px: float) -> Handle | None:
        """The handle that is seen at a pixel, from the pane's top left, if there is one."""
        return None if self._handles is None else nearest(self._handles.shown, pixel, within_px)

    def _place_handles(self) -> None:
        if self._handles is not None:
            held, apart_px = self._handles.held, APART_EM * self._style.font_size
            size_px = self._pane.size_px
            self._handles.show(
                shown(
                    self._projection, self.planes_drawn, self.sight, size_px, apart_px, held,
                    self._grips,
                ),
                size_px[1],
            )  # fmt: skip

    def _around_body(self) -> Array:
        return self._eye + 3.0 * self._body_size * _SIX_WAYS


class Film(NamedTuple):
    """The picture on the near plane.

    Attributes
    ----------
    surface, lines : (4, 4) float64 array
        Local from local: from the scene to its picture; that of the lines lies a little in front.
    planes : (6, 4) float64 array
        Half-spaces ``a x + b y + c z + d >= 0`` of the pane's world, normals of length 1: left,
        right, bottom, top, near, far. What is outside one of them is not in the picture.
    """

    surface: Array
    lines: Array
    planes: Array


def flatten(
    projection: Projection,
    view: tuple[Array, Array],
    depths: tuple[float, float],
    reach: float,
    *,
    toward_eye: bool,
) -> Film:
    """Squeeze the scene into a thin slab at the near face, every point along its ray to the eye.

    Parameters
    ----------
    projection : Projection
    view : (4, 4) float64 arrays
        View from scene-local coordinates, and back.
    depths : (float, float)
        Least and largest distance of anything in the scene from the eye plane, in front (+) or
        behind (-), in world units. The slab's thickness is spent on them.
    reach : float
        A length in world units to which a parallel lens' slab is proportioned.
    toward_eye : bool
        On which side of the near plane the slab lies. On the eye's, the nearest is on top, as
        seen from there; on the other, the nearest is again on top as seen from *there*: a
        picture looked at from behind is its mirror image, not the things' back sides.

    Returns
    -------
    Film

    Notes
    -----
    In homogeneous coordinates, with depth 1 at the near and 0 at the far end of what is in the
    picture: ``flatten: z' = w +- slab z``; x, y and w stay, so that each point keeps its ray.
    """
    lens = projection.lens
    near, far = lens.near, lens.far
    free = max(_MARGIN * (depths[1] - depths[0]), 1e-6 * reach)  # flat scenes have no depth
    start = max(near, depths[0] - free)
    end = max(min(far, depths[1] + free), start + 1e-6 * reach)
    view_from_local, local_from_view = view
    clip_from_local = _part(projection, start, end)[0] @ view_from_local
    film = _part(projection, near, near + reach if lens.parallel else math.inf)
    film_from_local, local_from_film = film[0] @ view_from_local, local_from_view @ film[1]
    slab = SLAB if toward_eye else -SLAB

    squeeze = np.eye(4)
    squeeze[2] = 0.0, 0.0, slab, 1.0
    lifted = squeeze.copy()
    lifted[2, 3] += slab * _LINES_IN_FRONT
    z, w = film_from_local[2:]
    side = 1.0 if toward_eye else -1.0
    slab_planes = np.array([SLAB * w - side * (z - w), side * (z - w)])
    planes = np.vstack([_side_planes(projection) @ view_from_local, slab_planes])
    planes /= np.abs(planes).max(axis=1, keepdims=True)  # or the squares may overflow
    planes /= np.linalg.norm(planes[:, :3], axis=1, keepdims=True)
    return Film(
        _normalised(local_from_film @ squeeze @ clip_from_local),
        _normalised(local_from_film @ lifted @ clip_from_local),
        planes,
    )


def _flattened_free(projection: Projection, origin: Array, pane_eye: Array) -> Film:
    """`flatten` under a free matrix: onto the cube's near face, on the side that is looked at."""
    reversed_range = projection.with_depth("reversed")
    clip_from_local = reversed_range.clip_from_world_at(origin)
    local_from_clip = reversed_range.world_from_clip_at(origin)
    z, w = clip_from_local[2:] @ (*pane_eye, 1.0)
    side = 1.0 if w <= 0.0 or z > w else -1.0
    squeeze = np.eye(4)
    squeeze[2] = 0.0, 0.0, side * SLAB, 1.0
    lifted = squeeze.copy()
    lifted[2, 3] += side * SLAB * _LINES_IN_FRONT
    x, y, z, w = clip_from_local
    planes = np.array([w + x, w - x, w + y, w - y, SLAB * w - side * (z - w), side * (z - w)])
    planes /= np.abs(planes).max(axis=1, keepdims=True)
    planes /= np.linalg.norm(planes[:, :3], axis=1, keepdims=True)
    return Film(
        _normalised(local_from_clip @ squeeze @ clip_from_local),
        _normalised(local_from_clip @ lifted @ clip_from_local),
        planes,
    )


# --------------------------------------------------------------------------- matrices


def _side_planes(projection: Projection) -> Array:
    """Left, right, bottom and top of the view volume in view space, positive inside, (4, 4).

    Clip space has them as w + x and so on, which cancel for a window far off the axis.
    """
    left, right, bottom, top = projection.window
    lens = projection.lens
    near = lens.near
    planes = np.zeros((4, 4))
    for row, (axis, edge, sign) in enumerate(
        ((0, left, 1.0), (0, right, -1.0), (1, bottom, 1.0), (1, top, -1.0))
    ):
        planes[row, axis] = sign
        if lens.parallel:
            cot = projection.shear[axis]
            planes[row, 2:] = sign * cot, sign * (cot * near - edge)
        else:
            planes[row, 2] = sign * (edge / near)
    return planes


def _view(camera: Camera, origin: Array) -> tuple[Array, Array]:
    """View from scene-local coordinates and back, both (4, 4); the eye is subtracted first."""
    eye = np.array(camera.eye) - origin
    view_from_local, local_from_view = np.identity(4), np.identity(4)
    view_from_local[:3, :3], view_from_local[:3, 3] = camera.frame, camera.frame @ -eye
    local_from_view[:3, :3], local_from_view[:3, 3] = camera.frame.T, eye
    return view_from_local, local_from_view


def _cube_from_part(view_from_cube: Array, near: float, far: float) -> Array:
    """From the cube of a part of a view volume to that of the whole, (4, 4).

    The distance from the eye plane is ``-(A z + B) / (C z + D)`` with the rows (A, B) and (C, D)
    of `view_from_cube` that make z and w; solved for z at both distances.
    """
    (a, b), (c, d) = view_from_cube[2:, 2:].tolist()
    at_near, at_far = (-(b + distance * d) / (a + distance * c) for distance in (near, far))
    matrix = np.identity(4)
    matrix[2, 2], matrix[2, 3] = at_near - at_far, at_far
    return matrix


def _part(projection: Projection, near: float, far: float) -> tuple[Array, Array]:
    """`clip_from_view` and its inverse for a part of the view volume, in the reversed range.

    As `projection.between` has them; but only what belongs to depth is exchanged, so that there
    is no window to overflow, or to vanish beside its shift, for a lens at the end of its range.

    Parameters
    ----------
    projection : Projection
    near, far : float
        Where the part begins and ends; distances from the eye plane in world units.

    Returns
    -------
    clip_from_view, view_from_clip : (4, 4) float64 arrays
    """
    clip_from_view, view_from_clip = projection.clip_from_view.copy(), np.zeros((4, 4))
    lens = projection.lens
    clip_from_view[2], depth_from_clip = _depth_rows(near, far, lens.parallel)
    if lens.parallel:
        left, right, bottom, top = projection.window
        for row, (low, high) in enumerate(((left, right), (bottom, top))):
            cot = projection.shear[row]
            view_from_clip[row, row] = (high - low) / 2.0
            view_from_clip[row, 2] = -cot * (far - near)
            view_from_clip[row, 3] = (low + high) / 2.0 + cot * (far - lens.near)
        view_from_clip[:2] = np.clip(view_from_clip[:2], -_WIDEST, _WIDEST)
        view_from_clip[2:] = depth_from_clip
    else:
        view_from_clip[:3] = np.clip(projection.view_from_clip[:3], -_STEEPEST, _STEEPEST)
        view_from_clip[3] = depth_from_clip[1]
    return clip_from_view, view_from_clip


@lru_cache(maxsize=16)  # the parts of one step, which most sliders leave as they are
def _depth_rows(near: float, far: float, parallel: bool) -> tuple[Array, Array]:
    """Row z of `clip_from_view`, (4,), and rows z and w of its inverse, (2, 4), reversed range."""
    lens = Orthographic(near=near, far=far) if parallel else Perspective(near=near, far=far)
    part = Projection(lens=lens, depth="reversed")
    return part.clip_from_view[2], part.view_from_clip[2:]


def _shrinking(away: float, depth: float) -> float:
    """How much all is to be shrunk towards the pane's camera to bring what is away to a depth."""
    return depth / away if away > depth else 1.0


def _scaled(local_from_view: Array, size: float) -> Array:
    matrix = local_from_view.copy()
    matrix[:3, :3] *= size
    return matrix


def _normalised(matrix: Array) -> Array:
    """The same projective matrix with entries that float32 can hold."""
    result: Array = matrix / np.abs(matrix).max()
    return result


def _applied(matrix: Array, points: Array) -> Array:
    homogeneous = np.column_stack([points, np.ones(len(points))]) @ matrix.T
    result: Array = homogeneous[:, :3] / homogeneous[:, 3:]
    return result


# --------------------------------------------------------------------------- shapes


def _box_corners(lower: Any, upper: Any) -> Array:
    """The eight corners of a box, (8, 3)."""
    lower, upper = np.asarray(lower, dtype=np.float64), np.asarray(upper, dtype=np.float64)
    corners: Array = lower + (upper - lower) * ((actors.CUBE_CORNERS + 1.0) / 2.0)
    return corners


def _camera_body() -> tuple[Array, list[tuple[int, ...]], list[tuple[int, ...]]]:
    """A box with a lens hood and a viewfinder, in view space: the eye in the hood's mouth.

    Returns
    -------
    points : (n, 3) array
    faces, edges : lists of tuples of int
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
        quads = [*_SIDES, _FAR_FACE] if not faces else [_NEAR_FACE, *_SIDES, _FAR_FACE]
        faces += [tuple(first + i for i in quad) for quad in quads]
        edges += [tuple(first + i for i in line) for line in actors.CUBE_EDGES]
    first = len(points)
    for z in (0.65, 1.25):
        points += [(-0.3, 0.42, z), (0.3, 0.42, z), (0.0, 0.75, z)]
    prism = [(0, 1, 2), (3, 4, 5), (0, 2, 5, 3), (1, 2, 5, 4)]
    faces += [tuple(first + i for i in face) for face in prism]
    edges += [tuple(first + i for i in line) for line in ((0, 1, 2, 0), (3, 4, 5, 3), (2, 5))]
    return np.array(points), faces, edges


def _broken_edge() -> tuple[Array, list[tuple[int, ...]]]:
    """An edge with two strokes across, and dashed from there: ``--- / / - - -``.

    Returns
    -------
    points : (n, 3) array
        How far along the edge, 0..1, and by how many em of the screen across and along it.
    lines : list of tuples of int
    """
    at, gap, half, slant = _STROKES_AT, 0.21, 0.5, 0.17
    strokes = [((at, -half, z - slant), (at, half, z + slant)) for z in (-gap, gap)]
    dashes = [((at, 0.0, gap), (0.56, 0.0, 0.0))]
    dashes += [((a, 0.0, 0.0), (b, 0.0, 0.0)) for a, b in ((0.68, 0.8), (0.9, 1.0))]
    pieces = [((0.0, 0.0, 0.0), (at, 0.0, -gap)), *strokes, *dashes]
    points = np.array([end for piece in pieces for end in piece])
    return points, [(i, i + 1) for i in range(0, len(points), 2)]
