"""What is in the world: the built-in scenes, and meshes read from the user's files.

A `Scene` is finished geometry. Its faces carry one flat colour each, baked once in world space,
so that a face looks the same in the world, in NDC and in the image, and so that no pane needs a
light. Everything drawn is stored relative to `Scene.origin`, subtracted in float64, because a GPU
computes in float32: a mesh 1e7 away from the world's origin would be left with one digit.

The letter F of eight cubes standing on a grid in the xz plane is the scene of lecture 004
(Horvat); the cube and the receding row of posts prepare and follow it. After them come the
phenomena of `app.scenes.phenomena`, whose subject can be the user's own mesh.

This room knows no Qt and no screen. It reads files and places the first camera, nothing else.
"""

from __future__ import annotations

import difflib
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.model.projection import (
    Array,
    Camera,
    ObjectTransform,
    Perspective,
    Projection,
    Space,
    Vector,
)
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal
from app.scenes.finishing import Finished, following, vector
from app.scenes.mesh import (
    PAINT_RGB,
    Colours,
    Floats,
    Ints,
    Progress,
    open_mesh,
    report,
)
from app.scenes.mesh_files import ENDINGS as ENDINGS
from app.scenes.phenomena import PHENOMENA, Phenomenon
from app.scenes.phenomena.illustration import OwnMesh, Subject
from app.scenes.reading import read
from app.scenes.shapes import (
    EDGE_RGB,
    LETTER_F,
    OUTLINE_RGB,
    PLATE_RGB,
    SIDE_RGB,
    Coloured,
    box_corners,
    box_faces,
    brightness,
    distinct_rows,
    edges_of,
    flat,
    ground_grid,
    is_grid,
    joined,
    letter_f_on_grid,
    written_number,
)

if TYPE_CHECKING:
    import pyvista as pv
    from vtkmodules.vtkCommonCore import vtkDataArray
    from vtkmodules.vtkCommonDataModel import vtkCellArray

WRONG_ENDING = QT_TRANSLATE_NOOP(
    "Refusal", "{0}: a mesh file must end in {1} or {2}; convert it to one of these."
)
NOT_A_SCENE = QT_TRANSLATE_NOOP(
    "Refusal", "There is no scene “{0}”, only {1} or {2}; a mesh file needs its ending."
)
NEARLY_A_SCENE = QT_TRANSLATE_NOOP(
    "Refusal", "There is no scene “{0}”, only {1} or {2}; did you mean “{3}”?"
)
NO_OWN_MESH = QT_TRANSLATE_NOOP(
    "Refusal", "mesh = {1}: the scene “{0}” has a subject of its own, no mesh can take its place."
)
_TRIES = {
    "letter-f": (
        QT_TRANSLATE_NOOP("phenomena", "Drag the near plane towards the F."),
        QT_TRANSLATE_NOOP("phenomena", "What happens to the picture?"),
        QT_TRANSLATE_NOOP("phenomena", "What happens in the cube?"),
    ),
    "cube": (
        QT_TRANSLATE_NOOP("phenomena", "Go nearer: which edges grow?"),
        QT_TRANSLATE_NOOP("phenomena", "Which edges are parallel in the picture?"),
        QT_TRANSLATE_NOOP("phenomena", "Choose the orthographic lens: and now?"),
    ),
    "posts": (
        QT_TRANSLATE_NOOP("phenomena", "Where in the cube do the posts crowd?"),
        QT_TRANSLATE_NOOP("phenomena", "Make near larger: do they spread out?"),
        QT_TRANSLATE_NOOP("phenomena", "Move far in: which posts are gone?"),
    ),
}
_TRIES_OF_A_MESH = (
    QT_TRANSLATE_NOOP("phenomena", "Walk round it: drag the azimuth."),
    QT_TRANSLATE_NOOP("phenomena", "Close near and far round it."),
    QT_TRANSLATE_NOOP("phenomena", "What becomes of its shape in the cube?"),
)
SAMPLE = 100_000
"""Vertices of a larger mesh stand for all of them when speed is measured."""
_DEEPEST = 4.0  # times the bounds' longest side, that a mesh may reach which crosses them
RASTERISED = frozenset({"depth", "texture", "fog", "levels"})
"""What a scene can require of the image's `Rasteriser`."""
SUBJECT_SAMPLE = 2_000
"""Vertices of a larger subject stand for all of them in what a phenomenon reckons at each step."""
SUBJECT_EDGES, SUBJECT_TRIANGLES = 20_000, 1_000
"""Of a mesh of more, a phenomenon reckons with the longest."""
SIZES = 4
"""Kinds of cells that have boxes of their own: as large as all, half as large, and so on."""
MOST_IN_BOXES = 50_000
"""A mesh of more cells is in one box."""
SUBJECT_SURFACE = 3_000
"""Triangles of a larger mesh are brought together to so many, where its pixels are reckoned."""


class Boxes(NamedTuple):
    """Corners of boxes in world coordinates.

    Attributes
    ----------
    faces, lines : (n, 8, 3) array
        Round what there is of either; of n = 0 boxes round nothing.
    """

    faces: Array
    lines: Array

    @property
    def together(self) -> Array:
        """The faces', then the lines'."""
        return np.concatenate(self)


class _Later:
    """A mesh that is made when it is first drawn: VTK takes longer to import than a window to show.

    Attributes
    ----------
    points : (n, 3) float32 array
    bounds : (6,) float32 array
        Least and largest x, y and z.
    n_cells, corners : int
        How many polygons or lines, and of how many corners together.
    rgb : (n_cells, 3) array of uint8
    cells : (n_cells + 1,) and (corners,) arrays of int
        Where each one's corners begin, and the corners.
    """

    def __init__(
        self, points: Array, offsets: NDArray[Any], corners: NDArray[Any], rgb: Colours
    ) -> None:
        self.points = points = points.astype(np.float32)  # small numbers of few digits
        self.bounds = np.stack([self.points.min(axis=0), self.points.max(axis=0)], axis=1).ravel()
        self.n_cells, self.corners, self.rgb = len(rgb), corners.size, rgb
        self.cells = offsets, corners
        self.make = partial(_poly_data, points, offsets, corners, rgb)


class _Mesh:
    """A field of `Scene` that is given a mesh, or one to be made later."""

    def __set_name__(self, _owner: type, name: str) -> None:
        self._name = name

    def __get__(self, scene: Scene | None, _owner: type | None = None) -> pv.PolyData | None:
        if scene is None:
            raise AttributeError(self._name)  # it has no default
        held = scene.__dict__[self._name]
        if isinstance(held, _Later):
            held = scene.__dict__[self._name] = held.make()
        return cast("pv.PolyData | None", held)

    def __set__(self, scene: Scene, mesh: pv.PolyData | _Later | None) -> None:
        scene.__dict__[self._name] = mesh


@dataclass(frozen=True, eq=False, kw_only=True)
class Scene:
    """Geometry to look at, ready to draw, and the camera it is first seen with.

    Attributes
    ----------
    name : str
        One of `BUILT_IN`, or the path of the mesh file as it was given.
    origin : tuple of 3 floats
        World point that all geometry below is relative to: ``world = origin + points``.
    surface : pyvista.PolyData or None
        Polygons (m faces) with ``cell_data["rgb"]``, (m, 3) uint8; float32 points.
    lines : pyvista.PolyData or None
        Edges of the objects and ground-grid lines, with ``cell_data["rgb"]`` like the surface.
    lower, upper : tuple of 3 floats
        World bounds of the objects, without the grid.
    start : Projection
        The camera and lens with which the scene opens.
    phenomenon : Phenomenon or None
        What it shows beyond the pipeline itself.
    own_mesh : bool
        Whether a mesh from a file is in the place of the phenomenon's subject.
    """

    name: str
    origin: Vector
    surface: _Mesh = _Mesh()
    lines: _Mesh = _Mesh()
    lower: Vector
    upper: Vector
    start: Projection
    phenomenon: Phenomenon | None = None
    own_mesh: bool = False

    @property
    def leading(self) -> str:
        """The pane that shows it best."""
        return "world" if self.phenomenon is None else self.phenomenon.leading

    @property
    def tries(self) -> tuple[str, ...]:
        """What to try with it: three short lines, translatable as the phenomena's texts are."""
        if self.phenomenon is not None:
            return self.phenomenon.tries
        return _TRIES.get(self.name, _TRIES_OF_A_MESH)

    @cached_property
    def requires(self) -> frozenset[str]:
        """What drawings build for this scene beyond faces, lines and marks."""
        return frozenset() if self.phenomenon is None else self.phenomenon.requires

    @cached_property
    def subject(self) -> Subject:
        """What a phenomenon reckons with: the faces' bounds and vertices, without the grid."""
        surface = self.__dict__["surface"]
        points = np.empty((0, 3)) if surface is None else surface.points
        step = max(1, -(-len(points) // SUBJECT_SAMPLE))
        sample = points[::step].astype(np.float64) + self.origin
        mesh = None
        if self.own_mesh and self.surface is not None:
            mesh = _own_mesh(self.surface, self.origin, "depth" in self.requires)
        return Subject(self.lower, self.upper, sample, mesh)

    @property
    def faces(self) -> int:
        """How many there are."""
        surface = self.__dict__["surface"]
        return 0 if surface is None else int(surface.n_cells)

    @property
    def triangles(self) -> int:
        """How many the faces are made of."""
        surface = self.__dict__["surface"]
        if surface is None:
            return 0
        is_made = not isinstance(surface, _Later)
        corners = surface.GetPolys().GetNumberOfConnectivityIds() if is_made else surface.corners
        return int(corners) - 2 * self.faces

    @cached_property
    def size(self) -> float:
        """Diagonal of the objects' bounds in world units, greater than 0."""
        return math.dist(self.lower, self.upper)

    @cached_property
    def centre(self) -> Vector:
        """World point in the middle of the objects' bounds."""
        return _centre(self.lower, self.upper)

    @cached_property
    def corners(self) -> Array:
        """World coordinates of the corners of a box round all that is drawn, (8, 3)."""
        bounds = [mesh.bounds for mesh in self._meshes]
        low, high = np.subtract((self.lower, self.upper), self.origin)  # where nothing is drawn
        if bounds:
            low = np.min([b[::2] for b in bounds], axis=0)
            high = np.max([b[1::2] for b in bounds], axis=0)
        return self._box(low, high)

    @cached_property
    def apart(self) -> tuple[Scene, Scene]:
        """The objects alone and the ground alone, as scenes from the same origin."""
        surface, lines = (self.__dict__[name] for name in ("surface", "lines"))
        kept: list[_Later | None] = [None, None]
        if lines is not None:
            rgb = np.asarray(lines.rgb if isinstance(lines, _Later) else lines.cell_data["rgb"])
            ends, grid = np.asarray(lines.points).reshape(-1, 2, 3), is_grid(rgb)
            for i, which in enumerate((~grid, grid)):
                kept[i] = _line_set((ends[which], rgb[which])) if which.any() else None
        objects, ground = kept
        return (
            replace(self, surface=surface, lines=objects),
            replace(self, surface=None, lines=ground),
        )

    def parts(self, placement: ObjectTransform) -> tuple[tuple[Scene, Space], ...]:
        """What is drawn under one matrix each, and what its coordinates are.

        All of it in the world while nothing is moved; else the objects, and the ground.
        """
        if placement.is_identity:
            return ((self, "world"),)
        objects, ground = self.apart
        return (objects, "object"), (ground, "world")

    def reach(self, placement: ObjectTransform) -> Array:
        """World coordinates of the corners of boxes round all that is drawn, (8 or 16, 3)."""
        if placement.is_identity:
            return self.corners
        objects, ground = self.apart
        placed = placement.placed(objects.corners).world
        if ground.__dict__["lines"] is None:
            return placed
        return np.concatenate([placed, ground.corners])

    @property
    def objects_box(self) -> Array:
        """Corners of the objects' bounds in the object's coordinates, (8, 3)."""
        return self._box(*(np.subtract(end, self.origin) for end in (self.lower, self.upper)))

    @cached_property
    def boxes(self) -> Boxes:
        """Boxes that together hold what is drawn, each thing in one of them whole.

        What is as large as the scene has one of its own, so has what is half as large, and so on:
        the lines of a ground are in a flat one, which the eye is above. What is smaller has one in
        each corner of the scene: the eye is outside of all of them between two bars of a letter.
        """
        boxes = []
        for name in ("surface", "lines"):
            mesh, ends = self.__dict__[name], np.empty((0, 2, 3))
            if mesh is not None:
                ends = np.array(mesh.bounds).reshape(1, 3, 2).swapaxes(1, 2)
                if isinstance(mesh, _Later):
                    offsets, corners = mesh.cells
                else:
                    offsets, corners = cells_of(
                        mesh.GetLines() if name == "lines" else mesh.GetPolys()
                    )
                if 1 < len(offsets) <= MOST_IN_BOXES:
                    ends = _by_size_and_place(np.asarray(mesh.points), offsets, corners)
            boxes.append(np.array([self._box(*pair) for pair in ends]).reshape(-1, 8, 3))
        return Boxes(*boxes)

    def _box(self, low: ArrayLike, high: ArrayLike) -> Array:
        """World coordinates of a box' corners, (8, 3), from two of them relative to the origin."""
        return box_corners(low, high) + self.origin

    @property
    def _meshes(self) -> list[Any]:
        """The faces and the lines that there are, made or to be made."""
        held = (self.__dict__[name] for name in ("surface", "lines"))
        return [mesh for mesh in held if mesh is not None]

    @property
    def has_vertices(self) -> bool:
        """Whether there is anything to draw: an empty ground has nothing."""
        return bool(self._meshes)

    @property
    def vertices(self) -> Array:
        """All vertices in world coordinates, (n, 3)."""
        points = np.concatenate([mesh.points for mesh in self._meshes])
        vertices: Array = points.astype(np.float64) + self.origin
        return vertices

    @cached_property
    def sample(self) -> Array:
        """Of `vertices` all, or `SAMPLE` of a larger mesh."""
        vertices = self.vertices
        return vertices[:: max(1, -(-len(vertices) // SAMPLE))].copy()


def load(name_or_path: str, progress: Progress | None = None, mesh: str = "") -> Scene:
    """Open a built-in scene or a mesh file.

    Parameters
    ----------
    name_or_path : str
        One of `BUILT_IN`, or the path of a file with one of `ENDINGS`.
    progress : callable, optional
        Called now and then with the fraction done, from 0 to 1, on the caller's thread; when it
        returns False, loading stops.
    mesh : str, optional
        Path of a mesh file that takes the place of a phenomenon's subject: scaled alike in all
        directions into its bounds, and standing where it stands.

    Raises
    ------
    Refusal
        For an unknown name, for a file that cannot be read or holds nothing to draw, and for a
        mesh with a scene whose subject it cannot be.
    Cancelled
        When `progress` returned False.
    """
    phenomenon = PHENOMENA.get(name_or_path)
    if mesh and not (phenomenon is not None and phenomenon.own_mesh):
        raise Refusal.saying(NO_OWN_MESH, name_or_path, mesh)
    if phenomenon is not None:
        return _scene_of_phenomenon(phenomenon, mesh, progress)
    build = _BUILDERS.get(name_or_path)
    if build is not None:
        return build()
    path = Path(name_or_path)
    if path.suffix.lower() in ENDINGS:
        return _scene_of_mesh(name_or_path, path, progress)
    is_file_name = path.name != name_or_path or path.suffix != ""
    if name_or_path and (is_file_name or _exists(path)):
        open_mesh(path).close()
        raise Refusal.saying(WRONG_ENDING, path, *_but_last(ENDINGS))
    likely = difflib.get_close_matches(name_or_path.lower(), BUILT_IN, n=1, cutoff=0.5)
    template = NEARLY_A_SCENE if likely else NOT_A_SCENE
    raise Refusal.saying(template, name_or_path, *_but_last(BUILT_IN), *likely)


FRAMED_FROM = (0.6, 0.45, 0.9)
"""From a box towards the eye of `frame_camera`, any length."""


def frame_camera(lower: Sequence[float], upper: Sequence[float]) -> Projection:
    """Place a camera so that a box is wholly in view, with room around it.

    Parameters
    ----------
    lower, upper : sequence of 3 floats
        World bounds; the box may be flat but not a point.

    Returns
    -------
    Projection
        Looks at the box's centre, near plane just in front of the box, far plane
        behind it, with room for the ground grid that `load` puts under a mesh.
    """
    size = math.dist(lower, upper)
    # Rounded to what a reader wants to see in a number field: a thousandth of the size.
    decimals = 3 - math.floor(math.log10(size))
    target = _rounded(_centre(lower, upper), decimals)
    toward_eye = vector(np.array(FRAMED_FROM) / math.hypot(*FRAMED_FROM))
    u, v, n = Camera(toward_eye, (0.0, 0.0, 0.0)).frame

    lens = Perspective()
    aspect = Projection().aspect
    tan_y = math.tan(math.radians(lens.fov_y_deg / 2.0))
    margin = 0.8  # of the half picture that the box may fill
    corners = box_corners(lower, upper) - target
    radius = float(np.linalg.norm(corners / size, axis=1).max()) * size
    for_width = corners @ n + abs(corners @ u) / (margin * tan_y * aspect)
    for_height = corners @ n + abs(corners @ v) / (margin * tan_y)
    distance = max(float(for_width.max()), float(for_height.max()), 1.25 * radius)
    eye = _rounded(
        [t + distance * part for t, part in zip(target, toward_eye, strict=True)], decimals
    )
    camera = Camera(eye, target)
    near = _two_digits(camera.distance - 1.05 * radius, math.floor)
    far = _two_digits(camera.distance + 2.6 * radius, math.ceil)
    return Projection(camera, Perspective(lens.fov_y_deg, near, far))


def _centre(lower: Sequence[float], upper: Sequence[float]) -> Vector:
    x, y, z = (low + (high - low) / 2.0 for low, high in zip(lower, upper, strict=True))
    return x, y, z


def _by_size_and_place(points: Floats, offsets: Ints, corners: Ints) -> Floats:
    """Lower and upper ends, (n, 2, 3), of boxes round cells of a size, the small ones by place."""
    used = points[corners]
    low, high = (ends.reduceat(used, offsets[:-1]) for ends in (np.minimum, np.maximum))
    least, most = low.min(axis=0), high.max(axis=0)
    sizes, extent = (high - low).max(axis=1), (most - least).max()
    halvings = np.sum([sizes <= extent / 2.0**n for n in range(1, SIZES)], axis=0)
    octants = (low + high > least + most) @ np.array([1, 2, 4])
    kinds = 8 * halvings + np.where(halvings > 1, octants, 0)
    order = np.argsort(kinds, kind="stable")
    starts = np.flatnonzero(np.diff(kinds[order], prepend=-1))
    lower, upper = np.minimum.reduceat(low[order], starts), np.maximum.reduceat(high[order], starts)
    return np.stack([lower, upper], axis=1)


def _rounded(point: Sequence[float], decimals: int) -> Vector:
    x, y, z = (round(part, decimals) + 0.0 for part in point)  # + 0.0: no minus zero
    return x, y, z


def _two_digits(value: float, rounding: Callable[[float], int]) -> float:
    exponent = math.floor(math.log10(value)) - 1
    return float(f"{rounding(value / 10.0**exponent)}e{exponent}")


def _but_last(words: Sequence[str]) -> tuple[str, str]:
    """All but the last, and the last: to say “a, b or c” in any language."""
    return ", ".join(words[:-1]), words[-1]


# --------------------------------------------------------------------------- poly data


def values_of(array: vtkDataArray) -> NDArray[Any]:
    from vtkmodules.util.numpy_support import vtk_to_numpy

    return np.asarray(vtk_to_numpy(array))  # type: ignore[no-untyped-call]


def cells_of(cells: vtkCellArray) -> tuple[Ints, Ints]:
    """Offsets and corners of a VTK cell array."""
    cells.ConvertTo64BitStorage()
    offsets = values_of(cells.GetOffsetsArray())
    corners = values_of(cells.GetConnectivityArray())
    return offsets.astype(np.int64), corners.astype(np.int64)


def _poly_data(
    points: NDArray[np.floating], offsets: NDArray[Any], corners: NDArray[Any], rgb: Colours
) -> pv.PolyData:
    """A mesh for VTK, its points with the digits that they are given with."""
    import pyvista as pv

    cells = pv.CellArray.from_arrays(offsets, corners, deep=True)
    poly_data = pv.PolyData()
    poly_data.points = np.ascontiguousarray(points)
    if cells.n_cells and cells.GetMaxCellSize() > 2:
        poly_data.SetPolys(cells)
    else:
        poly_data.SetLines(cells)
    poly_data.cell_data["rgb"] = rgb
    return poly_data


def _surface(quads: Coloured) -> _Later:
    points, corners = distinct_rows(quads[0].reshape(-1, 3))
    offsets = np.arange(0, corners.size + 1, 4)
    return _Later(points, offsets, corners, quads[1])


def _line_set(lines: Coloured) -> _Later:
    ends = np.arange(2 * len(lines[0]))
    return _Later(lines[0].reshape(-1, 3), np.arange(0, ends.size + 1, 2), ends, lines[1])


# --------------------------------------------------------------------------- built-in scenes


def _built_in(
    name: str,
    quads: Coloured,
    lines: Coloured,
    start: Projection,
    phenomenon: Phenomenon | None = None,
) -> Scene:
    points = quads[0].reshape(-1, 3)
    return Scene(
        name=name,
        origin=(0.0, 0.0, 0.0),
        surface=_surface(quads),
        lines=_line_set(lines),
        lower=vector(points.min(axis=0)),
        upper=vector(points.max(axis=0)),
        start=start,
        phenomenon=phenomenon,
    )


def _letter_f() -> Scene:
    """Eight unit cubes on the ground, the letter's three columns centred about x = 0."""
    return _built_in("letter-f", *letter_f_on_grid((-8.0, -8.0), (8.0, 8.0)), LETTER_F)


def _cube() -> Scene:
    """A unit cube standing on the ground, with the world's axes coming out of it."""
    faces = box_faces((-0.5, 0.0, -0.5), (0.5, 1.0, 0.5))
    axes = np.array([[(0.0, 0.0, 0.0), end] for end in np.diag([1.5, 2.0, 1.5]).tolist()])
    return _built_in(
        "cube",
        (faces, SIDE_RGB.copy()),
        joined(
            ground_grid((-3.0, -3.0), (3.0, 3.0), (0.5, 0.5), 0.0),
            edges_of(faces),
            (axes, SIDE_RGB[[1, 3, 5]]),  # the darker shades, to be seen on a light background
        ),
        Projection(
            Camera((2.4, 2.0, 3.2), (0.0, 0.5, 0.0)),
            Perspective(fov_y_deg=45.0, near=1.6, far=7.0),
        ),
    )


_POSTS = 20
_POST_SPACING = 6.0


def _posts() -> Scene:
    """Posts of equal height and spacing, numbered on geometry, so that every pane projects it."""
    lit = brightness(np.repeat(np.eye(3), 2, axis=0) * np.tile([[1.0], [-1.0]], (3, 1)))
    wood = (lit[:, None] * PAINT_RGB).astype(np.uint8)
    plate_rgb = (np.clip(lit + 0.25, 0.0, 1.0)[:, None] * PLATE_RGB).astype(np.uint8)
    plate_rgb[4] = PLATE_RGB  # the written side
    quads: list[Coloured] = []
    lines: list[Coloured] = []
    for number in range(1, _POSTS + 1):
        z = -_POST_SPACING * (number - 1)
        post = box_faces((-0.1, 0.0, z - 0.24), (0.1, 2.4, z - 0.04))
        plate = box_faces((-0.8, 1.5, z - 0.04), (0.8, 2.6, z + 0.04))
        digits = written_number(number, (0.0, 2.05, z + 0.06), height=0.8)
        quads += [(post, wood), (plate, plate_rgb), (digits, flat(EDGE_RGB, len(digits)))]
        outline = edges_of(plate)[0]  # grey: far away there is little else than outline
        lines.append((outline, flat(OUTLINE_RGB, len(outline))))
    ground = ground_grid((-10.0, -126.0), (10.0, 12.0), (2.0, 6.0), 0.0)
    return _built_in(
        "posts",
        joined(*quads),
        joined(ground, *lines),
        Projection(
            Camera((6.0, 5.0, 9.0), (1.0, 1.8, -8.0)),
            Perspective(fov_y_deg=45.0, near=9.0, far=130.0),
        ),
    )


_BUILDERS: dict[str, Callable[[], Scene]] = {
    "letter-f": _letter_f,
    "cube": _cube,
    "posts": _posts,
}
BUILT_IN = (*_BUILDERS, *PHENOMENA)
"""Names of the built-in scenes, phenomena last, each in the order of the lectures."""


# --------------------------------------------------------------------------- meshes from files


def _read_mesh(path: Path, progress: Progress | None) -> Finished:
    if path.suffix.lower() not in ENDINGS:
        open_mesh(path).close()
        raise Refusal.saying(WRONG_ENDING, path, *_but_last(ENDINGS))
    return read(path, progress)


def _drawn_edges(mesh: Finished) -> Coloured:
    return mesh.edges, flat(EDGE_RGB, len(mesh.edges))


def _scene_of_phenomenon(
    phenomenon: Phenomenon, mesh_path: str, progress: Progress | None
) -> Scene:
    """A phenomenon with its own subject, or with a mesh in its place."""
    faces, lines = phenomenon.geometry()
    scene = _built_in(phenomenon.name, faces, lines, phenomenon.start, phenomenon)
    if not mesh_path:
        return scene
    mesh = _read_mesh(Path(mesh_path), progress)
    lower, upper = mesh.bounds
    room, sides = np.subtract(scene.upper, scene.lower), np.subtract(upper, lower)
    held, place = np.array(_centre(lower, upper)), np.array(scene.centre)
    if phenomenon.own_mesh_crosses:
        held[::2], place[::2] = upper[::2], scene.upper[::2]
        place[0] += room[0] / 6.0
        room[2] = _DEEPEST * room.max()
    else:  # it stands where the subject stood
        held[1], place[1] = lower[1], scene.lower[1]
    extended = (sides > 0.0) & (room > 0.0)
    fallback = scene.size / math.dist(lower, upper)
    scale = float((room[extended] / sides[extended]).min()) if extended.any() else fallback
    for ends in (mesh.points, mesh.edges):
        ends -= held
        ends *= scale
        ends += place
    grid = is_grid(lines[1])
    scene = replace(
        scene,
        surface=_poly_data(mesh.points, mesh.offsets, mesh.corners, mesh.rgb),
        lines=_line_set(joined((lines[0][grid], lines[1][grid]), _drawn_edges(mesh))),
        lower=vector(mesh.points.min(axis=0)),
        upper=vector(mesh.points.max(axis=0)),
        own_mesh=True,
    )
    _ = scene.subject  # of a large mesh, which the first drawing would wait for
    report(progress, 1.0)
    return scene


def _own_mesh(surface: pv.PolyData, origin: Vector, pixels: bool) -> OwnMesh:
    """The longest edges of a surface, the triangles with the longest; for pixels all of them."""
    points = np.asarray(surface.points)
    offsets, corners = cells_of(surface.GetPolys())
    next_corners = corners[following(offsets)]
    # Most edges are there from either side, and with the copies of their ends that files make.
    places, merged = distinct_rows(points)
    starts, ends = merged[corners], merged[next_corners]
    apart = starts != ends
    keys = np.minimum(starts, ends)[apart] * len(places) + np.maximum(starts, ends)[apart]
    starts, ends = np.divmod(_distinct(keys), len(places))
    if not len(starts):  # all of them are points
        starts, ends = merged[corners[:1]], merged[corners[:1]]
    chosen = _largest(_lengths(places, starts, ends), SUBJECT_EDGES)
    edges = places[np.stack([starts[chosen], ends[chosen]], axis=1)].astype(np.float64)

    if surface.is_all_triangles:
        triangles = corners.reshape(-1, 3)
    else:
        triangles = np.asarray(surface.triangulate().regular_faces, dtype=np.int64)
    spans = _lengths(points, triangles, np.roll(triangles, -1, axis=1))
    longest = points[triangles[_largest(spans.max(axis=1), SUBJECT_TRIANGLES)]].astype(np.float64)
    if not len(longest):  # all of them are lines
        longest = edges[:1, [0, 0, 1]]
    whole = np.empty((0, 3, 3))
    if pixels:
        whole = _coarser(points, triangles) + origin
    return OwnMesh(
        edges + origin, len(starts), longest + origin, len(longest) < len(triangles), whole
    )


def _coarser(points: NDArray[np.floating], triangles: Ints) -> Floats:
    """Triangles (k, 3, 3), `SUBJECT_SURFACE` at most: vertices in a cell of a grid become one."""
    found: Floats = points[triangles].astype(np.float64)
    low, size = points.min(axis=0), float(np.ptp(points, axis=0).max())
    cells = 48
    while len(found) > SUBJECT_SURFACE:
        cell = np.floor((points - low) * (cells / size)).astype(np.int64)
        keys = (cell[:, 0] * (cells + 1) + cell[:, 1]) * (cells + 1) + cell[:, 2]
        _, where, count = np.unique(keys, return_inverse=True, return_counts=True)
        middles = [np.bincount(where, points[:, axis]) / count for axis in range(3)]
        corners = np.sort(where[triangles], axis=1)
        corners = corners[(corners[:, 0] < corners[:, 1]) & (corners[:, 1] < corners[:, 2])]
        a, b, c = corners.T
        rest, c = np.divmod(_distinct((a * len(count) + b) * len(count) + c), len(count))
        corners = np.stack([*np.divmod(rest, len(count)), c], axis=1)
        found = np.stack(middles, axis=1)[corners]
        cells = cells * 3 // 4
    return found


def _distinct(keys: Ints) -> Ints:
    """Each of the numbers once, sorted: numpy's own takes 4 s for 3 million, and this 0.02."""
    keys = np.sort(keys)
    return keys[np.append(True, keys[1:] != keys[:-1])] if len(keys) else keys


def _lengths(points: NDArray[np.floating], starts: Ints, ends: Ints) -> NDArray[np.floating]:
    squares = np.zeros(starts.shape, points.dtype)
    for axis in range(3):  # of millions, which takes half of the time of row by row
        column = points[:, axis].copy()
        along = column.take(ends) - column.take(starts)
        squares += along * along
    return np.sqrt(squares)


def _largest(values: NDArray[np.floating], count: int) -> Ints:
    """Which values are the largest, at most `count`, the largest first."""
    which: NDArray[np.intp] = np.arange(len(values))
    if count < len(values):
        which = np.argpartition(-values, count)[:count]
    found: Ints = which[np.argsort(-values[which], kind="stable")]
    return found


def _scene_of_mesh(name: str, path: Path, progress: Progress | None) -> Scene:
    mesh = _read_mesh(path, progress)
    lower, upper = mesh.bounds
    size = math.dist(lower, upper)
    # A round number near the middle, and 0 for a mesh that is at the origin anyway.
    origin = _rounded(_centre(lower, upper), -math.floor(math.log10(size)))
    for ends in (mesh.points, mesh.edges):
        ends -= np.array(origin)
    scene = Scene(
        name=name,
        origin=origin,
        surface=_poly_data(mesh.points, mesh.offsets, mesh.corners, mesh.rgb),
        lines=_line_set(joined(_ground(lower, upper, origin), _drawn_edges(mesh))),
        lower=lower,
        upper=upper,
        start=frame_camera(lower, upper),
    )
    report(progress, 1.0)
    return scene


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):  # no permission to look, or a name that no file can have
        return False


def _ground(lower: Vector, upper: Vector, origin: Vector) -> Coloured:
    """A grid under the mesh, at its lowest y, wider than the mesh, with 1-2-5 spacing."""
    size = math.dist(lower, upper)
    decade = 10.0 ** math.floor(math.log10(size / 8.0))
    spacing = max(step * decade for step in (1.0, 2.0, 5.0) if step * decade <= size / 8.0)
    rim = 0.5 * size
    return ground_grid(
        (lower[0] - rim, lower[2] - rim),
        (upper[0] + rim, upper[2] + rim),
        (spacing, spacing),
        lower[1],
        origin,
    )
