"""The scenes: the built-in ones, the phenomena, and meshes from the user's files.

A `Scene` is finished geometry. Each face has one flat colour, computed once in world space. It
looks the same in the world, in NDC and in the image, and no pane needs a light. All geometry is
stored relative to `Scene.origin`, subtracted in float64, because a GPU computes in float32: a mesh
1e7 away from the world's origin would keep one digit.

The built-in scenes of `app.scenes.built_in` come first, then the phenomena of
`app.scenes.phenomena`, whose subject can be the user's own mesh.

This package knows neither Qt nor a screen. It only reads files and places the first camera.
"""

import difflib
import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.model.limits import vector
from app.model.projection import Array, Chain, Projection, Space, Vector
from app.model.refusal import REFUSALS, Refusal
from app.scenes import shapes
from app.scenes.built_in import BUILDERS, NAMES, SHOWN, WORDS, WORDS_OF_A_MESH
from app.scenes.finishing import Finished, check, dot_colours
from app.scenes.first_camera import centre_of, frame_camera, rounded
from app.scenes.mesh import Colours, Progress, open_mesh, report
from app.scenes.mesh_files import ENDINGS as ENDINGS
from app.scenes.own_mesh import cells_of, own_mesh
from app.scenes.phenomena import PHENOMENA, Phenomenon
from app.scenes.phenomena.illustration import Appearance, Illustration, Subject
from app.scenes.poly_data import LaterMesh, dot_set, line_set, poly_data, surface_of
from app.scenes.reading import read
from app.strangers import printable

if TYPE_CHECKING:
    from app.scenes.poly_mesh import PolyMesh

SAMPLE = 100_000  # number of vertices with which speed is measured for a larger mesh
_DEEPEST = 4.0  # of a mesh that crosses the bounds, in longest sides of the bounds
RASTERISED = frozenset({"depth", "texture", "fog", "levels"})
"""Features of the image's `Rasteriser` that a scene can require."""
SUBJECT_SAMPLE = 2_000
"""Number of vertices of a larger subject with which a phenomenon computes at each step."""
MOST_IN_BOXES = 50_000  # most cells of a mesh with several boxes; a larger one gets one box


class Boxes(NamedTuple):
    """Corners (n, 8, 3) of boxes around the faces, dots and lines, in world coordinates."""

    faces: Array
    dots: Array
    lines: Array

    @property
    def together(self) -> Array:
        """The boxes of the faces, then those of the dots, then those of the lines."""
        return np.concatenate(self)


class _MeshField:
    """A field of `Scene` for a mesh, possibly one that is made later."""

    def __set_name__(self, _owner: type, name: str) -> None:
        self._name = name

    def __get__(self, scene: "Scene | None", _owner: type | None = None) -> "PolyMesh | None":
        if scene is None:
            raise AttributeError(self._name)  # it has no default
        held = scene.__dict__[self._name]
        if isinstance(held, LaterMesh):
            held = scene.__dict__[self._name] = held.make()
        return cast("PolyMesh | None", held)

    def __set__(self, scene: "Scene", mesh: "PolyMesh | LaterMesh | None") -> None:
        scene.__dict__[self._name] = mesh


@dataclass(frozen=True, eq=False, kw_only=True)
class Scene(Appearance):
    """Geometry that is ready to draw, and the first camera.

    - `name`: one of `BUILT_IN`, or the path of the mesh file as it was given.
    - `origin`: world point to which all geometry is relative: ``world = origin + points``.
    - `surface`: polygons (m faces) with ``cell_data["rgb"]``, (m, 3) uint8; float32 points.
    - `lines`: ground-grid lines, then edges of the objects and the lines of a file, with
      ``cell_data["rgb"]`` like the surface.
    - `dots`: points (n dots) of a file that are drawn by themselves, with ``point_data["rgb"]``.
    - `dot_widths`: diameter of a dot in widths of a line; None for one that suits their number.
    - `lower`, `upper`: world bounds of the objects, without the grid.
    - `start`: the camera and lens with which the scene opens.
    - `own_mesh`: whether a mesh from a file replaces the phenomenon's subject.
    - `notes`: what of a mesh's file was left out; they are shown, not raised.
    """

    name: str
    origin: Vector
    surface: _MeshField = _MeshField()
    lines: _MeshField = _MeshField()
    lower: Vector
    upper: Vector
    start: Projection
    phenomenon: Phenomenon | None = None
    own_mesh: bool = False
    dots: "PolyMesh | None" = None
    dot_widths: float | None = None
    notes: tuple[Refusal, ...] = ()
    names: tuple[str, ...] = NAMES

    @property
    def title(self) -> str:
        """Its title, translated like the phenomena's texts, or the name of the mesh's file."""
        if self.phenomenon is not None:
            return self.phenomenon.words.title
        if self.name in WORDS:
            return WORDS[self.name].title
        return printable(Path(self.name).name)

    @property
    def tries(self) -> tuple[str, ...]:
        """Three short suggestions, translated like the phenomena's texts."""
        if self.phenomenon is not None:
            return self.phenomenon.words.tries
        return WORDS.get(self.name, WORDS_OF_A_MESH).tries

    def illustration(
        self, projection: Projection, settings: Mapping[str, Any]
    ) -> Illustration | None:
        """What its phenomenon shows of a projection; None if it is no phenomenon."""
        if self.phenomenon is None:
            return None
        chosen = self.phenomenon.checked(settings)
        return self.phenomenon.illustration(projection, chosen, self.subject)

    def with_cloud(self, points: Array, rgb: Colours | None, widths: float | None) -> "Scene":
        """Return the scene with more dots, (n, 3) in its objects' coordinates.

        `rgb` (n, 3) are their colours, and `widths` is their diameter as `dot_widths`.
        """
        lower = np.minimum(self.lower, points.min(axis=0))
        upper = np.maximum(self.upper, points.max(axis=0))
        check("cloud", np.stack([lower, upper]))
        dots = points - self.origin
        colours = dot_colours(points) if rgb is None else rgb
        if self.dots is not None:
            dots = np.concatenate([self.dots.points, dots])
            colours = np.concatenate([self.dots.point_data["rgb"], colours])
        held = {name: self.__dict__[name] for name in ("surface", "lines")}
        return replace(
            self, **held, dots=dot_set(dots, colours), dot_widths=widths,
            lower=vector(lower), upper=vector(upper),
        )  # fmt: skip

    @cached_property
    def subject(self) -> Subject:
        """The bounds and vertices of the objects, without the grid, for a phenomenon."""
        surface = self.__dict__["surface"]
        points = surface.points if isinstance(surface, LaterMesh) else self.own_points
        step = max(1, -(-len(points) // SUBJECT_SAMPLE))
        sample = points[::step].astype(np.float64) + self.origin
        mesh = None
        if self.own_mesh and self.surface is not None:
            mesh = own_mesh(self.surface, self.origin, "depth" in self.requires)
        return Subject(self.lower, self.upper, sample, mesh)

    @cached_property
    def own_points(self) -> NDArray[Any]:
        """Vertices of faces, then dots, then ends of a file's lines, scene-local, (n, 3)."""
        parts = [np.asarray(each.points) for each in (self.surface, self.dots) if each is not None]
        if self.own_lines.any():
            assert self.lines is not None
            ends = np.asarray(self.lines.points).reshape(-1, 2, 3)[self.own_lines]
            parts.append(shapes.distinct_rows(ends.reshape(-1, 3))[0])
        if len(parts) == 1:
            return parts[0]
        return np.asarray(np.concatenate([np.empty((0, 3), dtype=np.float32), *parts]))

    @cached_property
    def own_lines(self) -> NDArray[np.bool_]:
        """Which of `lines` are a file's own."""
        return np.asarray((self._line_rgb == shapes.DRAWN_RGB).all(axis=1))

    @property
    def _line_rgb(self) -> Colours:
        """Colours of the lines, (n, 3); VTK is not needed."""
        lines = self.__dict__["lines"]
        if lines is None:
            return np.empty((0, 3), dtype=np.uint8)
        return np.asarray(lines.rgb if isinstance(lines, LaterMesh) else lines.cell_data["rgb"])

    @property
    def faces(self) -> int:
        surface = self.__dict__["surface"]
        return 0 if surface is None else int(surface.n_cells)

    @property
    def dot_count(self) -> int:
        return 0 if self.dots is None else int(self.dots.n_points)

    @property
    def cells(self) -> int:
        """The number of faces and dots, on which the time of a frame depends."""
        return self.faces + self.dot_count

    @property
    def triangles(self) -> int:
        """The number of triangles in the faces."""
        surface = self.__dict__["surface"]
        if surface is None:
            return 0
        is_made = not isinstance(surface, LaterMesh)
        corners = surface.GetPolys().GetNumberOfConnectivityIds() if is_made else surface.corners
        return int(corners) - 2 * self.faces

    @cached_property
    def size(self) -> float:
        """Diagonal of the objects' bounds in world units, above 0."""
        return math.dist(self.lower, self.upper)

    @cached_property
    def centre(self) -> Vector:
        """Centre of the objects' bounds in world coordinates."""
        return centre_of(self.lower, self.upper)

    @cached_property
    def corners(self) -> Array:
        """Corners (8, 3) of a box around everything drawn, in world coordinates."""
        bounds = [mesh.bounds for mesh in self._meshes]
        low, high = np.subtract((self.lower, self.upper), self.origin)  # where nothing is drawn
        if bounds:
            low = np.min([b[::2] for b in bounds], axis=0)
            high = np.max([b[1::2] for b in bounds], axis=0)
        return self._box(low, high)

    @cached_property
    def ground_lines(self) -> int:
        """How many of `lines` are a ground's; they are the first ones."""
        return int(shapes.is_grid(self._line_rgb).sum())

    @cached_property
    def apart(self) -> "tuple[Scene, Scene]":
        """The objects alone and the ground alone, as scenes with the same origin."""
        surface, lines = (self.__dict__[name] for name in ("surface", "lines"))
        kept: list[LaterMesh | None] = [None, None]
        if lines is not None:
            rgb = self._line_rgb
            ends, grid = np.asarray(lines.points).reshape(-1, 2, 3), shapes.is_grid(rgb)
            for i, which in enumerate((~grid, grid)):
                kept[i] = line_set((ends[which], rgb[which])) if which.any() else None
        objects, ground = kept
        return (
            replace(self, surface=surface, lines=objects),
            replace(self, surface=None, lines=ground, dots=None),
        )

    def with_ground(self, low: Vector, high: Vector) -> "Scene":
        """Return it with the part of the ground's lines that lies between two local points."""
        assert self.lines is not None
        ends, rgb = np.array(self.lines.points).reshape(-1, 2, 3), self._line_rgb
        part = np.where(shapes.is_grid(rgb)[:, None, None], np.clip(ends, low, high), ends)
        kept = ((part == ends) | (ends[:, :1] != ends[:, 1:])).all(axis=(1, 2))
        return replace(self, lines=line_set((part[kept], rgb[kept])))

    def parts(self, placement: Chain) -> "tuple[tuple[Scene, Space], ...]":
        """Return the parts that are drawn under one matrix each, with their spaces.

        The whole scene is one part unless the object is moved; then objects and ground are two.
        """
        if placement.is_identity:
            return ((self, "world"),)
        objects, ground = self.apart
        return (objects, "object"), (ground, "world")

    def reach(self, placement: Chain) -> Array:
        """Return corners (8 or 16, 3) of boxes around everything drawn, in world coordinates."""
        if placement.is_identity:
            return self.corners
        objects, ground = self.apart
        placed = placement.placed(objects.corners).world
        if ground.__dict__["lines"] is None:
            return placed
        return np.concatenate([placed, ground.corners])

    @property
    def objects_box(self) -> Array:
        """Corners (8, 3) of the objects' bounds in the object's coordinates."""
        return self._box(*(np.subtract(end, self.origin) for end in (self.lower, self.upper)))

    @cached_property
    def boxes(self) -> Boxes:
        """Boxes around everything drawn; each cell is in one box.

        Cells as large as the scene share a box, as do cells half as large, and so on: the lines of
        a ground are in a flat box below the eye. Small cells have a box in each corner of the
        scene, so that an eye between two bars of a letter is outside all boxes.
        """
        boxes = []
        for name in ("surface", "dots", "lines"):
            mesh, ends = self.__dict__[name], np.empty((0, 2, 3))
            if mesh is not None:
                ends = np.array(mesh.bounds).reshape(1, 3, 2).swapaxes(1, 2)
                if isinstance(mesh, LaterMesh):
                    offsets, corners = mesh.cells
                else:
                    kind = {"surface": "Polys", "dots": "Verts", "lines": "Lines"}[name]
                    offsets, corners = cells_of(getattr(mesh, f"Get{kind}")())
                if 1 < len(offsets) <= MOST_IN_BOXES:
                    ends = shapes.boxes_by_size(np.asarray(mesh.points), offsets, corners)
            boxes.append(np.array([self._box(*pair) for pair in ends]).reshape(-1, 8, 3))
        return Boxes(*boxes)

    def _box(self, low: ArrayLike, high: ArrayLike) -> Array:
        """Return the corners (8, 3) of a box in world coordinates from two relative ones."""
        return shapes.box_corners(low, high) + self.origin

    @property
    def _meshes(self) -> list[Any]:
        """The meshes of faces, dots and lines that exist, made or not."""
        held = (self.__dict__[name] for name in ("surface", "dots", "lines"))
        return [mesh for mesh in held if mesh is not None]

    @property
    def has_vertices(self) -> bool:
        """Whether there is anything to draw; an empty ground has nothing."""
        return bool(self._meshes)

    @property
    def vertices(self) -> Array:
        """All vertices in world coordinates, (n, 3)."""
        points = np.concatenate([mesh.points for mesh in self._meshes])
        return np.asarray(points.astype(np.float64) + self.origin)

    @cached_property
    def sample(self) -> Array:
        """The vertices, or `SAMPLE` of them."""
        vertices = self.vertices
        return vertices[:: max(1, -(-len(vertices) // SAMPLE))].copy()


def load(name_or_path: str, progress: Progress | None = None, mesh: str = "") -> Scene:
    """Open one of `BUILT_IN`, or a mesh file with one of `ENDINGS`.

    `progress` is called as in `app.scenes.mesh_files.read`. `mesh` is the path of a mesh file that
    replaces a phenomenon's subject. It is scaled uniformly into the subject's bounds, and stands
    where the subject stood.

    Raises a `Refusal` for an unknown name, for a file that cannot be read or has nothing to draw,
    and for a mesh with a scene that accepts none.
    """
    phenomenon = PHENOMENA.get(name_or_path)
    if mesh and not (phenomenon is not None and phenomenon.own_mesh):
        raise Refusal.saying(REFUSALS["no-own-mesh"], name_or_path, mesh)
    if phenomenon is not None:
        return _scene_of_phenomenon(phenomenon, mesh, progress)
    if name_or_path in BUILDERS:
        return _built_in(name_or_path, *BUILDERS[name_or_path](), **SHOWN.get(name_or_path, {}))
    path = Path(name_or_path)
    is_file_name = path.name != name_or_path or path.suffix != ""
    if name_or_path and (is_file_name or os.path.exists(path)):
        return _scene_of_mesh(name_or_path, path, progress)
    likely = difflib.get_close_matches(name_or_path.lower(), BUILT_IN, n=1, cutoff=0.5)
    template = REFUSALS["nearly-a-scene"] if likely else REFUSALS["not-a-scene"]
    raise Refusal.saying(template, name_or_path, *_but_last(BUILT_IN), *likely)


def _but_last(words: Sequence[str]) -> tuple[str, str]:
    """Split words for “a, b or c” in any language."""
    return ", ".join(words[:-1]), words[-1]


# --------------------------------------------------------------------------- built-in scenes


def _built_in(
    name: str, quads: shapes.Coloured, lines: shapes.Coloured, start: Projection, **shown: Any
) -> Scene:
    points = quads[0].reshape(-1, 3)
    return Scene(
        name=name,
        origin=(0.0, 0.0, 0.0),
        surface=surface_of(quads),
        lines=line_set(lines),
        lower=vector(points.min(axis=0)),
        upper=vector(points.max(axis=0)),
        start=start,
        **shown,
    )


BUILT_IN = (*BUILDERS, *PHENOMENA)
"""Names of the built-in scenes, phenomena last, each in the order of the lectures."""


# --------------------------------------------------------------------------- meshes from files


def _read_mesh(path: Path, progress: Progress | None) -> Finished:
    if path.suffix.lower() not in ENDINGS:
        open_mesh(path).close()
        raise Refusal.saying(REFUSALS["wrong-ending"], path, *_but_last(ENDINGS))
    return read(path, progress)


def _notes(path: str, mesh: Finished) -> tuple[Refusal, ...]:
    return tuple(Refusal.saying(template, path, *parts) for template, *parts in mesh.notes)


def _drawn_edges(mesh: Finished) -> shapes.Coloured:
    """Return the faces' edges, then the file's own lines."""
    lines = mesh.lines, shapes.flat(shapes.DRAWN_RGB, len(mesh.lines))
    return shapes.joined((mesh.edges, shapes.flat(shapes.EDGE_RGB, len(mesh.edges))), lines)


def _scene_of_phenomenon(
    phenomenon: Phenomenon, mesh_path: str, progress: Progress | None
) -> Scene:
    """Build a phenomenon with its own subject, or with a mesh in its place."""
    faces, lines = phenomenon.geometry()
    shown = {each.name: getattr(phenomenon, each.name) for each in fields(Appearance)}
    scene = _built_in(
        phenomenon.name, faces, lines, phenomenon.start, phenomenon=phenomenon, **shown
    )
    if not mesh_path:
        return scene
    mesh = _read_mesh(Path(mesh_path), progress)
    if not len(mesh.corners):
        raise Refusal.saying(REFUSALS["no-surface"], mesh_path, phenomenon.name)
    lower, upper = mesh.bounds
    room, sides = np.subtract(scene.upper, scene.lower), np.subtract(upper, lower)
    held, place = np.array(centre_of(lower, upper)), np.array(scene.centre)
    if phenomenon.own_mesh_crosses:
        held[::2], place[::2] = upper[::2], scene.upper[::2]
        place[0] += room[0] / 6.0
        room[2] = _DEEPEST * room.max()
    else:  # the mesh stands where the subject stood
        held[1], place[1] = lower[1], scene.lower[1]
    extended = (sides > 0.0) & (room > 0.0)
    fallback = scene.size / math.dist(lower, upper)
    scale = float((room[extended] / sides[extended]).min()) if extended.any() else fallback
    for ends in (mesh.points, mesh.edges, mesh.lines, mesh.dots):
        ends -= held
        ends *= scale
        ends += place
    grid = shapes.is_grid(lines[1])
    scene = replace(
        scene,
        surface=poly_data(mesh.points, mesh.offsets, mesh.corners, mesh.rgb),
        lines=line_set(shapes.joined((lines[0][grid], lines[1][grid]), _drawn_edges(mesh))),
        lower=vector(mesh.points.min(axis=0)),
        upper=vector(mesh.points.max(axis=0)),
        own_mesh=True,
        dots=dot_set(mesh.dots, mesh.dot_rgb),
        notes=_notes(mesh_path, mesh),
    )
    _ = scene.subject  # do it now: the first drawing would wait for it
    report(progress, 1.0)
    return scene


def _scene_of_mesh(name: str, path: Path, progress: Progress | None) -> Scene:
    scene = _finished_scene(name, _read_mesh(path, progress))
    report(progress, 1.0)
    return scene


def _finished_scene(name: str, mesh: Finished) -> Scene:
    check(name, np.array(mesh.bounds))
    lower, upper = mesh.bounds
    size = math.dist(lower, upper)
    # A round number near the middle, and 0 for a mesh that lies around the origin.
    origin = rounded(centre_of(lower, upper), -math.floor(math.log10(size)))
    for ends in (mesh.points, mesh.edges, mesh.lines, mesh.dots):
        ends -= np.array(origin)
    surface = None
    if len(mesh.corners):
        surface = poly_data(mesh.points, mesh.offsets, mesh.corners, mesh.rgb)
    return Scene(
        name=name,
        origin=origin,
        surface=surface,
        dots=dot_set(mesh.dots, mesh.dot_rgb),
        lines=line_set(shapes.joined(_ground(lower, upper, origin), _drawn_edges(mesh))),
        lower=lower,
        upper=upper,
        start=frame_camera(lower, upper),
        notes=_notes(name, mesh),
    )


def cloud_alone(points: Array, rgb: Colours | None, widths: float | None) -> Scene:
    """Return a scene of dots (n, 3) in world coordinates over a ground, and nothing else."""
    ends = np.stack([points.min(axis=0), points.max(axis=0)])
    if (ends[0] == ends[1]).all():  # one point has no size
        ends += ((-0.5,), (0.5,))
    none, ints = np.empty((0, 2, 3)), np.empty(0, dtype=np.int64)
    rgb_of_none = np.empty((0, 3), dtype=np.uint8)
    mesh = Finished(ends, ints, ints, rgb_of_none, none, none, none[:, 0], rgb_of_none, [])
    return _finished_scene("cloud", mesh).with_cloud(points, rgb, widths)


def _ground(lower: Vector, upper: Vector, origin: Vector) -> shapes.Coloured:
    """Return a grid at the lowest y of the mesh, wider than the mesh, with 1-2-5 spacing."""
    size = math.dist(lower, upper)
    decade = 10.0 ** math.floor(math.log10(size / 8.0))
    spacing = max(step * decade for step in (1.0, 2.0, 5.0) if step * decade <= size / 8.0)
    rim = 0.5 * size
    low, high = (lower[0] - rim, lower[2] - rim), (upper[0] + rim, upper[2] + rim)
    return shapes.ground_grid(low, high, (spacing, spacing), lower[1], origin)
