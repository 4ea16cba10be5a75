"""The world pane: the scene, the camera in it, and the camera's frustum.

`camera`, `frustum`, `near_picture` and `own_view`, the camera from which the pane looks, are
combined here with labels, marks and handles. No part computes a projection: the frustum is the NDC
cube's own edges and faces under ``world_from_clip``, and a slider step sets matrices alone.

Everything is scene-local, ``world - scene.origin`` subtracted in float64.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from itertools import compress, pairwise
from typing import Any

import numpy as np

from app.document.naming import FRAMES, named_in
from app.drawings import actors
from app.drawings.actors import PropGroup
from app.drawings.camera import CameraDrawing, CameraPose, view_matrices
from app.drawings.dimensions import Dimension, Dimensions
from app.drawings.drawing import Drawing, Rectangle, light_of_labels
from app.drawings.frame import DIMMED
from app.drawings.frustum import WIDEST, FrustumDrawing
from app.drawings.handles import APART_EM, HandleMarks
from app.drawings.label_placement import SQUARE_EM, Ground
from app.drawings.labels import DOT_EM, EYE, Board, Labels, Named, room
from app.drawings.marks import MarksDrawing, Placing
from app.drawings.moved_vertices import MovedVertices
from app.drawings.names import Names
from app.drawings.near_picture import NearPicture
from app.drawings.own_view import Framed, OwnView
from app.drawings.pane_view import Pose
from app.drawings.pointing import Emphasis, Segment, pointed_at, volume_edges
from app.drawings.probes import Probes
from app.drawings.rasterising import textured
from app.drawings.silhouette import Silhouette
from app.drawings.style import TITLE_EM, Style
from app.drawings.world_axes import WorldAxes
from app.lecture.highlight import AXES, CORNERS, OBJECT_AXES, SIDES, WINDOW, Highlight, made_of
from app.model.projection import Array, Camera, ObjectTransform, Projection
from app.picking.handles import Handle, nearest, shown
from app.picking.picking import Probe
from app.picking.sight import Sight
from app.scenes.phenomena.illustration import Illustration
from app.scenes.phenomena.marks import Length
from app.scenes.scene import Scene

_WHOLE, _NEARBY = 3.0, 1.1  # extents: the largest frustum framed whole; larger ones are cut to 1.1
_FARTHEST_MARK = 1e3  # of the extent: where lines toward infinity end
_EDGES = [pair for line in actors.CUBE_EDGES for pair in pairwise(line)]
_AXES_SIDE = 35.0, 25.0  # degrees behind the camera's side, and up: no axis is seen end on
_WINDOW_SIDE = 60.0, 20.0  # the near plane is seen broadside
# Sides of the window that cover each other in a flat view, all along it: named only if asked for.
_ONE_OVER_THE_OTHER = {"side": frozenset("lr"), "top": frozenset("bt")}
_ABOUT = 2.5  # of the size of marks on a large subject: so much of it is framed with them
_FRAMED_MARK = 5.0  # of the scene's size: farther marks are not framed


class WorldDrawing(Drawing):
    """The scene with the camera and its frustum in it.

    The own camera of `screen` looks at all this from outside. A `live` drawing has handles.
    """

    pane = "world"

    def __init__(
        self,
        screen: Any,
        scene: Scene,
        words: Mapping[str, str],
        style: Style,
        *,
        live: bool = False,
    ) -> None:
        self._scene, self._words = scene, words
        self._origin = np.array(scene.origin, dtype=np.float64)
        self._placement: ObjectTransform | None = None
        self._place(scene.start.placement)
        self._canvas = canvas = PropGroup(screen, style, self._lay_out)
        self._actors = drawn = actors.SceneActors(scene, style)
        self._faces_space, *self._line_spaces, self._ground_space = drawn.spaces
        canvas.add(*drawn)
        self._hidden = canvas.hidden
        if self.pane in scene.pale:
            actors.make_pale(drawn, style)
        self.picture = NearPicture(canvas, scene)
        shown = drawn.surface, self.picture.faces, drawn.dots, self.picture.actors.dots
        self._detail = actors.Detail(*shown)
        self._rasterisers = textured(
            scene,
            canvas,
            (drawn.surface, self._faces_space),
            (self.picture.faces, self.picture.space),
        )
        self._moved = [
            MovedVertices(scene, "stored", drawn.surface),
            MovedVertices(scene, "projected", self.picture.faces),
        ]
        self.camera = CameraDrawing(canvas)
        self.frustum = FrustumDrawing(canvas, scene.size)
        self._dimmable = [
            (actor.GetProperty(), actor.GetProperty().GetOpacity())
            for actor in (*self.frustum.dimmable, *self.picture.actors, *self.camera.solid)
        ]
        self._emphasis = emphasis = Emphasis(canvas)
        self.frustum.make_emphasis(emphasis)
        for name, line in self.camera.shafts.items():
            emphasis.line(line, name)
        for solid in self.camera.solid:
            emphasis.line(solid, of=("eye",))
        for name, mark in self.camera.discs.items():
            emphasis.point(mark, name)
        self.board = Board(canvas)
        self.labels = Labels(self.board, canvas, words)
        for name, label in self.labels.named.items():
            self._emphasis.label(label, name)
        self._dimensions: Dimensions | None = None
        self._probes = Probes(canvas, self.board)
        self.handles = HandleMarks(canvas) if live else None
        self.names = Names(named_in(self.pane, scene))
        self.axes = WorldAxes(canvas, scene, drawn, self.names, emphasis, self.labels)
        self._light = 1.0
        """How bright the frustum is."""
        self._marks: MarksDrawing | None = None
        self._marked = np.empty((0, 3))
        self._silhouette = Silhouette(scene, style.font_size)
        self._grips: dict[str, Array] = {}
        self._measured: tuple[tuple[str, float], ...] = ()
        self._lengths: tuple[Length, ...] = ()
        self._standing = self._stand(scene.start.camera)
        self.camera.show(self._standing)
        self.own = OwnView(canvas, self._origin, self._objects.mean(axis=0))
        self._goes_to: Framed | None = None
        """What is framed at the end of the way that the pane is on."""
        self._show_named()
        self._look_around()
        self.show_projection(scene.start)
        self.reset_view()

    def remove(self) -> None:
        self._canvas.remove()

    # -- fixed views and layers

    @property
    def fixed(self) -> str:
        return self.own.fixed

    def show_fixed(self, view: str) -> None:
        if view == self.own.fixed:
            return
        if view and self._dimensions is None:
            self._dimensions = Dimensions(self.board, self._canvas, self._words, self._scene.inks)
        elif self._dimensions is not None:
            self._dimensions.hide()
        self.own.fixed = view
        self.reset_view()

    def show_object_axes(self, wanted: bool) -> None:
        if wanted != self.axes.is_wanted:
            self.axes.is_wanted = wanted
            self.axes.show(self._local_from_object)
            self._follow_pane(afresh=True)

    def show_layers(self, hidden: frozenset[str]) -> None:
        self._hidden = hidden
        before = self.own.around
        self._look_around()
        self._switch_layers()
        # A camera that is shown again has to be in view; when it is hidden, nothing else moves.
        if self.own.around > before and not (self.own.was_moved or self.own.is_turned):
            self.own.place(self._framed())
            self.reset_clipping_range()
        else:
            self._follow_pane(afresh=True)

    def _switch_layers(self) -> None:
        # The pane looks through the camera, or it stands in front of the picture. From the eye the
        # flattened picture covers the scene, and its hidden edges would show through.
        hidden = self._hidden | self._left_out
        if self.own.sees_from_eye:
            hidden = hidden | {"camera", "near-picture"}
        elif self.own.fixed == "axis":
            hidden = hidden | {"camera"}
        has_arrows = not self.names.all and any(axis in self.names for axis in AXES)
        self._actors.show_grid("grid" not in hidden, pale=has_arrows)
        if ("grid" in hidden) != ("grid" in self._canvas.hidden):
            self.picture.actors.show_grid("grid" not in hidden)
        if hidden != self._canvas.hidden:
            self._canvas.show_layers(hidden)

    @property
    def _left_out(self) -> frozenset[str]:
        """The layers that the scene leaves out now: nothing of what is named."""
        names, left_out = self.names, self._scene.leaves_out
        if not left_out or names.all or self.camera.step is not None:
            return frozenset()
        if "near" in names or "far" in names:
            left_out -= {"frustum", "near-picture"}
        if any(name in names for name in ("eye", "target", *AXES)):
            left_out -= {"camera"}
        return left_out

    # -- pointing

    def show_highlight(self, highlighted: Highlight) -> bool:
        before, self.names.pointed = self.names.pointed, highlighted
        of_scene = self._marks is not None and self._marks.show_highlight(highlighted)
        is_new = self._emphasis.show(highlighted) or of_scene
        drawn = {"eye", "target", "near", "far", "fov", *SIDES}
        if self.camera.step is None:
            drawn |= set(AXES)
        wanted = drawn if self.names.wanted is None else self.names.wanted
        if of_scene or (before ^ highlighted) & drawn - wanted:
            self._show_named()
            self._follow_pane(afresh=False)
        return is_new

    def show_names(self, names: frozenset[str] | None) -> None:
        if names == self.names.wanted:
            return
        self.names.wanted = names
        self._show_named()
        self._look_around()
        if self.own.was_moved:
            self._follow_pane(afresh=True)
        else:
            self.reset_view()

    def _look_around(self) -> bool:
        """Tell the view how far the camera's drawn parts reach; return whether that has changed."""
        is_drawn = "eye" in self.names or self.camera.has_arrows
        around = self.camera.reach if is_drawn and "camera" not in self._hidden else 0.0
        is_new, self.own.around = around != self.own.around, around
        return is_new

    def _show_named(self) -> None:
        """Draw the camera's parts that are named, and the other things quietly."""
        names = self.names
        self._switch_layers()
        self.axes.show(self._local_from_object)
        self.camera.show_names(names)
        self.frustum.show_names(names)
        self._emphasis.show_names(names)
        if self._marks is not None:
            self._marks.show_names()

    def show_step(self, step: int | None) -> None:
        camera = self.camera
        if step == camera.step:
            return
        is_first = camera.steps is None
        camera.show_step(step)
        if is_first and camera.steps is not None:
            style = self._canvas.style
            for name, thing, shaft, colour in (
                ("up", "up", camera.steps.up, style.accent),
                ("look", "target", camera.steps.look, style.target),
            ):
                self._emphasis.line(shaft, thing)
                self._emphasis.label(self.labels.add_arrow(name, colour), thing)
            self._emphasis.show(self.names.pointed)
        self._light = 1.0 if step is None else DIMMED
        for line, opacity in self._dimmable:
            line.SetOpacity(opacity * self._light)
        self.labels.dim_planes(self._light)
        if not self._look_around():
            self._follow_pane(afresh=True)
            return
        if not (self.own.was_moved or self.own.fixed):
            self.own.place(self._framed())
        self.reset_clipping_range()

    def highlight_at(self, x_px: float, y_px: float) -> Highlight:
        highlight = self._emphasis.label_at(x_px, y_px)
        if not highlight and self._marks is not None:
            highlight = self._marks.label_at(x_px, y_px)
        if highlight:
            return highlight
        arrows, tips = self.camera.arrows
        at = self._standing
        points_local = [at.eye, at.target, at.eye + tips, self.frustum.corners]
        spots = self.own.pane.pointed(np.vstack(points_local))
        eye, target, *tip_spots = spots[:-8]
        corners = spots[-8:]
        points = [(frozenset((name,)), spot) for name, spot in zip(CORNERS, corners, strict=True)]
        points.append((frozenset(("eye",)), eye))
        if self.camera.shows_target or self.handles is not None:  # a hand takes hold of it there
            points.append((frozenset(("target",)), target))
        segments: list[Segment] = [
            (frozenset(("target" if name == "look" else name,)), eye, tip)
            for name, tip in zip(arrows, tip_spots, strict=True)
        ]
        axes = self.axes.of_object
        if axes is not None:
            origin, *ends = self.own.pane.pointed(np.vstack([axes.origin, axes.ends]))
            points.append((frozenset((OBJECT_AXES[3],)), origin))
            segments += [
                (frozenset((name,)), origin, end)
                for name, end in zip(axes.shafts, ends, strict=True)
            ]
        segments += volume_edges(corners)
        if self._projection.lens.central:
            segments += [(frozenset(("fov",)), eye, corner) for corner in corners[:4]]
        # A flat view looks along the faces: one of them would be all of the picture.
        faces = () if self.own.fixed else corners
        return pointed_at((x_px, y_px), self._canvas.style.font_size, points, segments, faces)

    # -- the model

    def show_detail(self, fewer: Scene | None) -> None:
        self._detail.show(fewer)
        if self._marks is not None:
            self._marks.show_detail(fewer)

    def show_projection(
        self, projection: Projection, illustration: Illustration | None = None
    ) -> None:
        self._projection = projection
        is_placed = self._place(projection.placement)
        if is_placed:
            for drawn in (self._actors, self.picture.actors):
                drawn.show_moved(not projection.placement.is_identity)
            self._faces_space.set(self._local_from_object)
            self._place_lines()
            self.axes.show(self._local_from_object)
        if is_placed or projection.camera is not self._standing.camera:
            self._standing = self._stand(projection.camera)
            self.camera.show(self._standing)
        is_first = self._marks is None and illustration is not None
        self._show_illustration(illustration)
        at = self._standing
        self.frustum.show(projection, at, _deepest(self._grips.values(), at, self._scene.size))
        if is_first and not self.own.was_moved:
            self.reset_view()
        elif self.own.fixed:
            self.own.follow(self._framed())
            self.reset_clipping_range(afresh=False)
        else:
            self._follow_pane(afresh=False)

    def _place(self, placement: ObjectTransform) -> bool:
        """Take over the objects' place; return whether it has changed."""
        if placement == self._placement:
            return False
        scene, origin = self._scene, self._origin
        self._placement = placement
        self._local_from_object = placement.local_from(scene.origin, scene.origin)
        self._objects = placement.placed(scene.objects_box).world - origin
        self._everything = np.concatenate([self._objects, scene.reach(placement) - origin])
        return True

    @property
    def has_object_axes(self) -> bool:
        return self.axes.has_object

    def _stand(self, camera: Camera) -> CameraPose:
        """What depends on the camera alone, and not on its lens."""
        eye, target = (np.array(point) - self._origin for point in (camera.eye, camera.target))
        depths = (eye - self._everything) @ camera.frame[2]
        return CameraPose(
            camera,
            self._origin,
            eye,
            target,
            *view_matrices(camera, self._origin),
            (float(depths.min()), float(depths.max())),
            float(((eye - self._objects) @ camera.frame[2]).max()),
            self._scene.size + math.dist(camera.eye, self._scene.centre),
        )

    def _place_labels(self, *, afresh: bool) -> bool:
        """Place the labels; return whether one has changed its place."""
        if "labels" in self._canvas.hidden or not self._canvas.labels_light:
            return False
        pane, at = self.own.pane, self._standing
        em = self._canvas.style.font_size
        ground = Ground(room(pane.size_px[0], pane.size_px[1] - TITLE_EM * em, em), em, self._ink)
        for handle, (x, y) in self.handles_shown:
            if self.names.all or handle == self.held:
                ground.keep([(x, pane.size_px[1] - y)], DOT_EM * em)
        arrows, ends = self._arrows
        names, lens = self.names, self._projection.lens
        measured, written = None, set[str]()
        if self.own.fixed and self._dimensions is not None:
            measured = self._in_fixed_view
            written = self._dimensions.written(measured)
        unnamed = {name for name in ("eye", "target", "near", "far") if name not in names}
        unnamed |= {a for a, side in WINDOW.items() if a not in names and side not in names}
        if names.all:
            unnamed |= _ONE_OVER_THE_OTHER.get(self.own.fixed, frozenset())
        has_window = self.frustum.seen and lens.planes is not None
        named = Named(
            at.eye, at.target, arrows, ends, self.camera.box, self._corners_seen, lens.planes,
            self._unseen | unnamed | written, self.frustum.corners[:4] if has_window else None,
            self._projection.window if has_window else (),
        )  # fmt: skip
        self._probes.want(ground)
        self.labels.want(ground, pane, named)
        for name, origin in self.axes.origins(at.eye).items():
            self.board.label(name).set_text(FRAMES[name])
            self.board.want_beside(name, pane.seen(origin[None])[0], EYE, (-1.0, -1.0))
        if measured is not None and self._dimensions is not None:
            self._dimensions.want(ground, pane.seen, pane.size_px, measured)
        if self._marks is not None:
            self._marks.want_texts(ground, pane.seen, written)
        return self.board.settle(ground, afresh=afresh)

    @property
    def _arrows(self) -> tuple[tuple[str, ...], Array]:
        """The arrows that are named, and where each starts and ends, (n, 2, 3)."""
        at, arrows, ends = self._standing, tuple[str, ...](), np.empty((0, 2, 3))
        if "camera" not in self._canvas.hidden:
            arrows, directions = self.camera.arrows
            ends = np.stack([np.tile(at.eye, (len(directions), 1)), at.eye + directions], axis=1)
        if self.camera.step is None:  # a frame can be shown without the letters of its axes
            shown = [name in self.names for name in arrows]
            arrows, ends = tuple(compress(arrows, shown)), ends[np.array(shown, dtype=bool)]
        named, of_axes = self.axes.named
        return arrows + named, np.concatenate([ends, of_axes])

    def _ink(self, ground: Ground) -> None:
        """Tell the ground what is drawn."""
        pane, placed = self.own.pane, self._local_from_object
        triangles = self._silhouette.triangles
        points = triangles.reshape(-1, 3) @ placed[:3, :3].T + placed[:3, 3]
        self._silhouette.ink(ground, pane.spots(points.reshape(triangles.shape)))
        corners = self._corners_seen
        if self.picture.is_seen and "near-picture" not in self._canvas.hidden:
            self._silhouette.ink(ground, pane.spots(self._on_near_plane))
        if corners is not None:
            edges = pane.spots(corners[_EDGES])
            # In a flat view a plane is one upright line: letters keep a square away from it.
            aside = SQUARE_EM * self.board.em if self.own.fixed in ("side", "top") else 0.0
            for shift in {-aside, 0.0, aside}:
                ground.ink_lines(edges + np.array([shift, 0.0]))
        _, ends = self._arrows
        ground.ink_lines(pane.spots(ends))
        if self.own.fixed and self._dimensions is not None:
            self._dimensions.ink(ground)
        if self._marks is not None:
            self._marks.ink(ground, pane.seen)

    @property
    def _on_near_plane(self) -> Array:
        """The triangles of the picture on the near plane, (n, 3, 3); NaN outside the window."""
        clip = self._projection.clip_from_local(self._scene.origin, "object")
        x, y, _, w = np.moveaxis(self._silhouette.triangles @ clip[:, :3].T + clip[:, 3], -1, 0)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            inside = (w > 0.0) & (np.maximum(np.abs(x), np.abs(y)) <= w)
            across, up = (np.where(inside, part / w, np.nan)[..., None] for part in (x, y))
        corner, right, _, top = self.frustum.corners[:4]
        way = (across + 1.0) / 2.0 * (right - corner) + (up + 1.0) / 2.0 * (top - corner)
        on_plane: Array = corner + way
        return on_plane

    @property
    def _corners_seen(self) -> Array | None:
        """The corners of the frustum, (8, 3); None without a frustum or its layer."""
        if not self.frustum.seen or "frustum" in self._canvas.hidden:
            return None
        return self.frustum.corners

    @property
    def _unseen(self) -> frozenset[str]:
        """The things without names and handles, because they are not drawn."""
        unseen = set[str]()
        if "frustum" in self._hidden or self.camera.step is not None:
            # They would cover the arrows of the construction.
            unseen |= {"near", "far", "corner", *WINDOW}
        if "camera" in self._hidden:
            unseen |= {"eye", "target"}
        elif "camera" in self._canvas.hidden:  # the pane looks through it, or from right behind it
            unseen |= {"eye"}
        return frozenset(unseen)

    @property
    def _in_fixed_view(self) -> Dimension:
        at, view = self._standing, self.own.fixed
        lengths = tuple(
            (each.name, each.value, each.start - self._origin, each.end - self._origin)
            for each in self._lengths
            if each.view == view
        )
        corners = self._corners_seen
        points = [probe.point for probe in self._probes.probes if probe.point is not None]
        across: Array = np.empty(0)
        if view == "axis" and points:
            trace = self._projection.trace(np.array(points))
            across = trace.ndc[trace.in_front, 0]
        return Dimension(
            view,
            self._projection,
            at.eye,
            at.target,
            corners,
            self._objects,
            self._measured,
            lengths,
            self.names,
            tuple(across.tolist()),
        )

    # -- the pane's own camera

    def reset_view(self) -> None:
        self.own.reset(self._framed())
        self.reset_clipping_range()

    def views(
        self,
        moments: Iterable[tuple[Projection, Illustration | None]],
        turns_deg: Sequence[float],
    ) -> list[Camera]:
        """Return free views of several moments, one for each turn; see `from_all_sides`."""
        self.show_fixed("")
        framed = []
        for moment in moments:
            self.show_projection(*moment)
            framed.append(self._framed())
        return self.own.from_all_sides(framed, turns_deg)

    def _framed(self) -> Framed:
        at, frustum = self._standing, self.frustum
        corners = frustum.corners if frustum.seen else None
        has_eye = self._projection.lens.central
        with_camera = np.concatenate([frustum.corners, [at.target]])
        if "frustum" in self._left_out:
            corners, with_camera = None, np.empty((0, 3))
        eye = at.eye
        if "camera" not in self._left_out:
            with_camera = np.vstack([with_camera, eye])
        elif not self.own.fixed:
            eye = self._objects.mean(axis=0)
        points = _points_to_frame(at, self._objects, with_camera, self._marked, self._scene.size)
        below_em = 0.0
        if self.own.fixed and self._dimensions is not None:
            below_em = self._dimensions.below_em(self.own.size_px, self._in_fixed_view)
        core, beside = self._named_points(points)
        return Framed(
            at.camera, eye, core, beside, corners, self._objects, has_eye, below_em,
            self._side,
        )  # fmt: skip

    @property
    def _side(self) -> tuple[float, float] | None:
        """From where the pane looks at first: the named axes and the window's sides are seen."""
        wanted = self.names.wanted
        if self.camera.axes_lead:
            return _AXES_SIDE
        if wanted is not None and wanted & WINDOW.keys() and self._scene.phenomenon is None:
            return _WINDOW_SIDE
        return self._scene.side

    def _named_points(self, points: Array) -> tuple[Array, Array]:
        """What has to be in view, with the named things, and what may leave it; (n, 3) each.

        The subject of a scene without larger marks of its own counts as named. Far is seldom whole
        in view: it would make the rest small.
        """
        wanted, at, corners = self.names.wanted, self._standing, self.frustum.corners
        if wanted is None:
            return points, np.empty((0, 3))
        marked = np.empty((0, 3)) if self._marks is None else self._marks.named_points
        followed = [probe.point for probe in self._probes.probes if probe.point is not None]
        marked = np.concatenate([marked, np.reshape(followed, (-1, 3)) - self._origin])
        named = [marked[np.linalg.norm(marked - at.eye, axis=1) <= _FARTHEST_MARK * at.extent]]
        named += self.axes.framed
        beside = [self._objects]
        has_planes = self.frustum.seen and self._projection.lens.planes is not None
        has_planes = has_planes and "frustum" not in self._hidden
        has_camera = "camera" not in self._hidden
        for name, thing, needs in (
            ("eye", at.eye[None], has_camera),
            ("target", at.target[None], has_camera),
            ("near", corners[:4], has_planes),
            ("height", corners[5:7], has_planes and self.own.fixed != ""),
            ("width", corners[5:7], has_planes and self.own.fixed == "axis"),
        ):
            if name in wanted and needs:
                named.append(thing)
        if has_planes:
            sides = zip(SIDES, range(4), strict=True)
            named += [corners[[i, (i + 1) % 4]] for side, i in sides if side[0] in wanted]
        if "far" in wanted and has_planes:
            (named if self.own.fixed else beside).append(corners[4:])
        figure: list[Array] = []
        if self.own.fixed in ("side", "top"):
            measured = {"d": at.camera.distance, **dict(self._measured)}
            figure = [
                (at.eye - measured[name] * at.camera.frame[2])[None]
                for name in measured.keys() & wanted
            ]
            figure += [
                np.array([length.start, length.end]) - self._origin
                for length in self._lengths
                if length.view == self.own.fixed and length.name in wanted
            ]
        core = np.concatenate(named + figure)
        objects = self._objects
        if self._scene.phenomenon is None or not len(core):
            core = np.concatenate([core, objects])
            return core, np.concatenate(beside)
        size, whole = (np.linalg.norm(np.ptp(points, axis=0)) for points in (core, objects))
        if size < whole and not figure:  # marks on a part of the subject: with what is about them
            middle = (core.min(axis=0) + core.max(axis=0)) / 2.0
            near = _ABOUT * size if size > 0.0 else np.inf
            core = np.concatenate([core, np.clip(objects, middle - near, middle + near)])
        return core, np.concatenate(beside)

    def refit(self) -> bool:
        """Frame the view again, and go back to what `reset_view` framed once that shows everything.

        The direction of looking stays. The labels are placed afresh: at rest the picture depends on
        nothing that was before. During a gesture the pane stands still, so that the model is seen
        moving.
        """
        if self.own.was_moved or not self.own.refit(self._framed()):
            return self._place_labels(afresh=True)
        self.reset_clipping_range()
        return True

    @property
    def view(self) -> Camera | None:
        return self.own.view

    @property
    def pose(self) -> Pose:
        return self.own.pose

    def begin_glide(self, start: Pose) -> None:
        self._goes_to = self._framed()
        self.own.begin_glide(start)

    def glide(self, part: float) -> None:
        if self.own.fixed:
            self.own.follow(self._framed())
        else:
            self.own.go_to_goal()
        if part < 1.0:
            self.own.glide(part)
        else:
            self.own.is_turned, self._goes_to = False, None
        self._canvas.fade_labels(light_of_labels(part))
        self.reset_clipping_range(afresh=part == 1.0)

    def show_view(self, view: Camera) -> None:
        self.own.show(view)
        self.reset_clipping_range()

    def _lay_out(self, _width_px: int, _height_px: int) -> None:
        """Fit a view that nobody has moved into a window of another size."""
        if not (self.own.was_moved or self.own.is_turned):
            self.own.place(self._goes_to or self._framed())
            self.own.keep_goal()
        self.reset_clipping_range()

    def reset_clipping_range(self, *, afresh: bool = True) -> None:
        self.own.look()
        self._switch_layers()
        if not self.own.fixed and self._dimensions is not None:
            self._dimensions.hide()
        self._place_lines()
        if self._marks is not None:
            self._marks.place_copies(self.own.lifted)
        self._follow_pane(afresh=afresh)

    def _place_lines(self) -> None:
        """Lift dots and lines before the faces."""
        lifted = self.own.lifted(1.0)
        for space in self._line_spaces:
            space.set(lifted @ self._local_from_object)
        self._ground_space.set(lifted)

    def _follow_pane(self, *, afresh: bool) -> None:
        """Update everything that depends on the model and on the pane's camera."""
        pane, frustum, at = self.own.pane, self.frustum, self._standing
        self.camera.follow(pane)
        self._place_handles()
        # From the eye the planes cover all of the picture, and one another.
        frustum.tint(pane, 0.0 if self.own.sees_from_eye else self._light)
        frustum.turn_breaks(pane)
        depths = self.camera.depths(pane)
        drawn = [self._everything, self.camera.around, frustum.corners, self._marked]
        near = self.own.fit_range(np.concatenate(drawn), *depths[1:])
        self.picture.show(self._projection, at, frustum, self.own, self._local_from_object)
        self.camera.move_forward(pane, depths, near)
        if self._probes.probes:
            self._place_probes()
        self._place_labels(afresh=afresh)

    # -- a phenomenon, probes, handles

    def show_probes(self, probes: Sequence[Probe]) -> None:
        self._probes.probes = probes
        self._place_probes()
        self._place_labels(afresh=False)

    def _show_illustration(self, illustration: Illustration | None) -> None:
        if self._marks is None:
            if illustration is None:
                return
            self._marks = MarksDrawing(
                self._canvas, self._scene, self._words, names=self.names, board=self.board
            )
        marks, limit = self._marks, min(_FARTHEST_MARK * self._standing.extent, WIDEST)
        shown = illustration or Illustration(())
        if shown.rendering is not None:
            for rasteriser in self._rasterisers:
                rasteriser.show(shown.rendering, self._projection)
        for moved in self._moved:
            moved.show(shown.vertices)
        self._measured, self._lengths = shown.measured, shown.lengths
        self._grips = {grip.setting: grip.point for grip in shown.grips}
        marks.show(shown.world, Placing(np.ones(3), -self._origin, limit))
        marks.show_copies([copy for copy in shown.copies if "world" in copy.panes])
        marks.place_copies(self.own.lifted)
        x, y, z, w = marks.copied(self._objects).T
        w = np.where(w > 0.0, w, np.nan)  # behind a plane that goes to infinity: not drawn
        with np.errstate(over="ignore"):
            copied = np.column_stack([x / w, y / w, z / w])
        copied = copied[(np.abs(copied) <= limit).all(axis=1)]
        self._marked = np.concatenate([marks.points, copied])

    @property
    def picture_rectangle_px(self) -> Rectangle:
        return Rectangle(0, 0, *self.own.size_px)

    @property
    def sight(self) -> Sight:
        return self.own.sight

    def _place_probes(self) -> None:
        drawn, sight = self.planes_drawn, self.sight
        marks = self._probes.in_world(self._projection, self._origin, drawn, sight)
        self._probes.show(marks, self.own.pane.size_px)

    @property
    def planes_drawn(self) -> tuple[float, float]:
        reach = self.frustum.reach
        return (0.0, 1.0) if reach is None else (reach.near, reach.far)

    @property
    def handles_shown(self) -> Sequence[tuple[Handle, tuple[float, float]]]:
        return () if self.handles is None else self.handles.shown

    @property
    def held(self) -> Handle | None:
        return None if self.handles is None else self.handles.held

    def hold(self, handle: Handle | None) -> None:
        if self.handles is not None:
            self.handles.held = handle
            is_named = handle is None or handle.name in self.names
            self.names.held = handle
            self._place_handles()
            if not is_named or handle is None:
                self._show_named()
                self._place_labels(afresh=False)

    def call_handles(self, names: frozenset[str]) -> None:
        if self.handles is not None:
            self.handles.called = names
            self._place_handles()

    def handle_at(self, pixel: tuple[float, float], within_px: float) -> Handle | None:
        handle = nearest(self.handles_shown, pixel, within_px)
        if handle is None and self.own.fixed in ("side", "top") and self.handles_shown:
            # Of a plane that is a line here, all of the line can be dragged, and its letter.
            names = made_of(self.highlight_at(*pixel))
            handle = next((each for each, _ in self.handles_shown if each.name in names), None)
        return handle

    def _place_handles(self) -> None:
        if self.handles is not None:
            axes = self.axes.of_object
            held, apart_px = self.handles.held, APART_EM * self._canvas.style.font_size
            size_px = self.own.pane.size_px
            none = "handles" in self._canvas.hidden
            self.handles.draws_all = self.names.all
            self.handles.show(
                [] if none else shown(
                    self._projection, self.planes_drawn, self.sight, size_px, apart_px, held,
                    self._grips, self._unseen, 0.0 if axes is None else axes.reach,
                ),
                size_px[1],
            )  # fmt: skip


def _deepest(points: Iterable[Array], at: CameraPose, size: float) -> float:
    """The largest depth of a scene's grips, of those near the scene; 0 without any."""
    offsets = [np.array(point) - at.camera.eye for point in points]
    near = [offset for offset in offsets if math.hypot(*offset) <= _FRAMED_MARK * size]
    return max((-float(offset @ at.camera.frame[2]) for offset in near), default=0.0)


def _points_to_frame(
    at: CameraPose, objects: Array, with_camera: Array, marked: Array, size: float
) -> Array:
    """The points that `reset_view` brings into view; only the near part of a very wide frustum.

    The wider the frustum is beyond `_WHOLE`, the less of it is framed, steadily. Where it cannot be
    seen whole without losing the scene, the scene matters more.
    """
    middle = objects.mean(axis=0)
    centre = (middle + at.eye) / 2.0
    marked = marked[np.linalg.norm(marked - middle, axis=1) <= _FRAMED_MARK * size]
    points = np.concatenate([objects, with_camera, marked])
    offsets = points - centre
    lengths = np.maximum(np.linalg.norm(offsets, axis=1, keepdims=True), 1e-300)
    whole, nearby = _WHOLE * at.extent, _NEARBY * at.extent
    shown = np.minimum(lengths, np.maximum(whole * (whole / lengths), nearby))
    framed: Array = centre + offsets * (shown / lengths)
    return framed
