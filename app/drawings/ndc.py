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
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
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
from app.drawings.probes import Mark, Probes
from app.drawings.rungs import ModelActors
from app.drawings.style import Style, rgb
from app.picking import Probe, Sight
from app.precision import DRAWING_TOLERANCE_PX, Rung
from app.projection import DEPTH_RANGES, Camera, Projection
from app.scene import Scene

VIEW_AZIMUTH_DEG, VIEW_ELEVATION_DEG = 27.0, 18.0
"""Where this pane's camera stands at first: to the right of the near face and above it."""

_DISTANCE = 10.0  # of the pane's camera; parallel, so that only its clipping range feels it
_REACH = 2.5  # everything drawn lies within this of the cube's centre, at any orbit
_OVERSHOOT = 0.28  # of the axes beyond the cube
_TINT = 0.16


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
        self._canvas = Canvas(plotter, style, self._layout)
        self._camera = self._canvas.renderer.GetActiveCamera()
        self._view: tuple[float, ...] = ()
        self._depth = ""
        self._half_depth = 1.0
        self._space, self._box, self._z_axis = Space(), Space(), Space()
        self._planes = self._cube_planes()
        self._model = ModelActors(scene, style, tolerance_px, self._planes)
        self._add_scene()
        self._add_cube(style)
        self._add_words(words, style)
        self._probes = Probes(self._canvas, style)
        self._projection = scene.start
        self._set_depth("opengl")
        self.reset_view()

    @property
    def rung(self) -> Rung:
        """The arithmetic that the scene is drawn with."""
        return self._model.rung

    def show_projection(self, projection: Projection) -> None:
        """Take the model's matrices over; draws nothing yet."""
        if projection.depth != self._depth:
            self._set_depth(projection.depth)
        # In OpenGL's range, whatever the model's: the displayed cube differs by its depth only.
        seen = projection if projection.depth == "opengl" else replace(projection, depth="opengl")
        self._space.set_projective(self._display_from_ndc @ self._model.show_projection(seen))
        self._projection = seen
        self._place_probes()

    def reset_view(self) -> None:
        """Look at the near face from the right and above, the whole cube in the pane."""
        width_px, height_px = (max(1, side) for side in self._canvas.window.GetSize())
        azimuth, elevation = math.radians(VIEW_AZIMUTH_DEG), math.radians(VIEW_ELEVATION_DEG)
        right = np.array([math.cos(azimuth), 0.0, -math.sin(azimuth)])
        toward = np.array(
            [
                math.sin(azimuth) * math.cos(elevation),
                math.sin(elevation),
                math.cos(azimuth) * math.cos(elevation),
            ]
        )
        up = np.cross(toward, right)
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
        camera = self._camera
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*centre)
        camera.SetPosition(*(centre + _DISTANCE * toward))
        camera.SetViewUp(0.0, 1.0, 0.0)
        camera.SetParallelScale(scale)
        self._view = self._current_view()
        self.reset_clipping_range()

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

    def show_probes(self, probes: Sequence[Probe]) -> None:
        """Mark these probes, and no others."""
        self._probes.probes = probes
        self._place_probes()

    @property
    def sight(self) -> Sight:
        """How this pane looks at the world just now, by way of the displayed cube."""
        projection, camera = self._projection, self._camera
        width_px, height_px = (max(1, side) for side in self._canvas.window.GetSize())
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
        clip = projection.clip_from_view @ projection.view_rotation
        limits = np.concatenate([clip[3] - clip[:3], clip[3] + clip[:3]])
        return Sight(np.array(projection.camera.eye), pane @ self._display_from_ndc @ clip, limits)

    @property
    def _display_from_ndc(self) -> NDArray[np.float64]:
        """From OpenGL's cube."""
        return np.diag([1.0, 1.0, -self._half_depth, 1.0])

    def _place_probes(self) -> None:
        marks: Sequence[Mark] = ()
        if self._probes.probes:
            marks = self._probes.in_ndc(self._projection, self._display_from_ndc, self.sight)
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
        planes = []
        for axis in range(3):
            for inward in (1.0, -1.0):
                plane = vtkPlane()
                normal = [0.0, 0.0, 0.0]
                normal[axis] = inward
                plane.SetNormal(*normal)
                plane.SetOrigin(*(-part for part in normal))
                planes.append(plane)
        return planes

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
            line_actor(CUBE_CORNERS, between, style.frustum, width),
            line_actor(CUBE_CORNERS, [(*far, far[0])], style.far, 1.7 * width),
            line_actor(CUBE_CORNERS, [(*near, near[0])], style.near, 1.7 * width),
        ]
        middle = [(axis * sign) for axis in np.eye(3) for sign in (-1.0, 1.0)]
        cross = line_actor(middle, [(0, 1), (2, 3), (4, 5)], style.muted, 0.7 * width)
        faces = [
            face_actor(CUBE_CORNERS, [far], style.far, _TINT),
            face_actor(CUBE_CORNERS, [near], style.near, _TINT),
        ]
        for actor in (*edges, cross, *faces):
            self._box.add(actor)
            self._canvas.add(actor)
        for edge in edges:
            lift_lines(edge, 2)
        for face in faces:
            put_behind(face)
        right, up, along = np.eye(3)
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

    # -- changed when the depth range or the pane's size changes, never by a slider

    def _set_depth(self, depth: str) -> None:
        self._depth = depth
        z_near, z_far = DEPTH_RANGES[depth]
        half = abs(z_far - z_near) / 2.0
        toward_reader = 1.0 if z_near > z_far else -1.0
        self._half_depth = half
        self._box.set(np.diag([1.0, 1.0, half, 1.0]))
        self._z_axis.set(np.diag([1.0, 1.0, toward_reader * half, 1.0]))
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

    def _layout(self, _width_px: int, _height_px: int) -> None:
        if self._current_view() == self._view:  # nobody has turned it since: keep it whole
            self.reset_view()

    def _current_view(self) -> tuple[float, ...]:
        camera = self._camera
        return (*camera.GetPosition(), *camera.GetFocalPoint(), camera.GetParallelScale())
