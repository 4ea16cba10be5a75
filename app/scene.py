"""What is in the world: the built-in scenes, and meshes read from the user's files.

A `Scene` is finished geometry. Its faces carry one flat colour each, baked once in world space,
so that a face looks the same in the world, in NDC and in the image, and so that no pane needs a
light. Everything drawn is stored relative to `Scene.origin`, subtracted in float64, because a GPU
computes in float32: a mesh 1e7 away from the world's origin would be left with one digit.

The letter F of eight cubes standing on a grid in the xz plane is the scene of lecture 004
(Horvat); the cube and the receding row of posts prepare and follow it.

This room knows no Qt and no plotter. It reads files and places the first camera, nothing else.
"""

from __future__ import annotations

import base64
import difflib
import json
import math
import re
import warnings
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO, TypeAlias
from urllib.parse import unquote

import numpy as np
import pyvista as pv
from numpy.typing import ArrayLike, NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    vtkDataArray,
    vtkLogger,
    vtkOutputWindow,
    vtkStringOutputWindow,
)
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkStaticPointLocator
from vtkmodules.vtkFiltersCore import vtkFeatureEdges
from vtkmodules.vtkIOGeometry import vtkOBJReader

from app.projection import Camera, Perspective, Projection

Vector: TypeAlias = tuple[float, float, float]
Floats: TypeAlias = NDArray[np.float64]
Ints: TypeAlias = NDArray[np.int64]
Colours: TypeAlias = NDArray[np.uint8]
Progress: TypeAlias = Callable[[float], bool]

FACES_WITH_EDGES = 5_000
"""Meshes of more faces get no edge lines: they would be denser than the pixels."""


class SceneError(ValueError):
    """One sentence that names the scene or the file, what is wrong with it, and what to do."""


class SceneCancelled(Exception):
    """The progress callback of `load` answered False."""


@dataclass(frozen=True, eq=False)
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
    requires : frozenset of str
        What a drawing of this scene must provide (DESIGN section 6).
    """

    name: str
    origin: Vector
    surface: pv.PolyData | None
    lines: pv.PolyData | None
    lower: Vector
    upper: Vector
    start: Projection
    requires: frozenset[str]

    @property
    def size(self) -> float:
        """Diagonal of the objects' bounds in world units, greater than 0."""
        return math.dist(self.lower, self.upper)

    @property
    def centre(self) -> Vector:
        """World point in the middle of the objects' bounds."""
        return _centre(self.lower, self.upper)


def load(name_or_path: str, progress: Progress | None = None) -> Scene:
    """Open a built-in scene or a mesh file.

    Parameters
    ----------
    name_or_path : str
        One of `BUILT_IN`, or the path of a file with one of `ENDINGS`.
    progress : callable, optional
        Called now and then with the fraction done, from 0 to 1, on the caller's thread; when it
        returns False, loading stops.

    Returns
    -------
    Scene

    Raises
    ------
    SceneError
        For an unknown name, and for a file that cannot be read or holds nothing to draw.
    SceneCancelled
        When `progress` returned False.
    """
    build = _BUILDERS.get(name_or_path)
    if build is not None:
        return build()
    path = Path(name_or_path)
    if path.suffix.lower() in ENDINGS:
        return _scene_of_mesh(name_or_path, path, progress)
    is_file_name = path.name != name_or_path or path.suffix != ""
    if name_or_path and (is_file_name or _exists(path)):
        _check_readable(path)
        raise SceneError(
            f"{path}: a mesh file must end in {_listed(ENDINGS)}; convert it to one of these."
        )
    likely = difflib.get_close_matches(name_or_path.lower(), BUILT_IN, n=1, cutoff=0.5)
    hint = f"did you mean “{likely[0]}”?" if likely else "a mesh file needs its ending."
    raise SceneError(f"There is no scene “{name_or_path}”, only {_listed(BUILT_IN)}; {hint}")


def frame_camera(
    lower: Sequence[float],
    upper: Sequence[float],
    direction: Sequence[float] = (0.6, 0.45, 0.9),
) -> Projection:
    """Place a camera so that a box is wholly in view, with room around it.

    Parameters
    ----------
    lower, upper : sequence of 3 floats
        World bounds; the box may be flat but not a point.
    direction : sequence of 3 floats, optional
        From the box towards the eye, any length.

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
    toward_eye = _vector(np.asarray(direction, dtype=np.float64) / math.hypot(*direction))
    vertical = math.hypot(toward_eye[0], toward_eye[2]) < 1e-6
    up = (0.0, 0.0, -1.0) if vertical else (0.0, 1.0, 0.0)
    u, v, n = Camera(toward_eye, (0.0, 0.0, 0.0), up).frame

    lens = Perspective()
    aspect = Projection().aspect
    tan_y = math.tan(math.radians(lens.fov_y_deg / 2.0))
    margin = 0.8  # of the half picture that the box may fill
    corners = _corners(lower, upper) - np.asarray(target)
    radius = float(np.linalg.norm(corners / size, axis=1).max()) * size
    for_width = corners @ n + abs(corners @ u) / (margin * tan_y * aspect)
    for_height = corners @ n + abs(corners @ v) / (margin * tan_y)
    distance = max(float(for_width.max()), float(for_height.max()), 1.25 * radius)
    eye = _rounded(
        [t + distance * part for t, part in zip(target, toward_eye, strict=True)], decimals
    )
    camera = Camera(eye, target, up)
    near = _two_digits(camera.distance - 1.05 * radius, math.floor)
    far = _two_digits(camera.distance + 2.6 * radius, math.ceil)
    return Projection(camera, Perspective(lens.fov_y_deg, near, far))


def _centre(lower: Sequence[float], upper: Sequence[float]) -> Vector:
    x, y, z = (low + (high - low) / 2.0 for low, high in zip(lower, upper, strict=True))
    return x, y, z


def _corners(lower: Sequence[float], upper: Sequence[float]) -> Floats:
    """The eight corners of a box, (8, 3)."""
    return np.array(np.meshgrid(*zip(lower, upper, strict=True))).reshape(3, 8).T


def _rounded(point: Sequence[float], decimals: int) -> Vector:
    x, y, z = (round(part, decimals) + 0.0 for part in point)  # + 0.0: no minus zero
    return x, y, z


def _two_digits(value: float, rounding: Callable[[float], int]) -> float:
    exponent = math.floor(math.log10(value)) - 1
    return float(f"{rounding(value / 10.0**exponent)}e{exponent}")


def _listed(words: Sequence[str]) -> str:
    return f"{', '.join(words[:-1])} or {words[-1]}"


# --------------------------------------------------------------------------- colours

# Okabe-Ito, one hue for each axis, the lighter shade on the positive side. In a grey picture, or
# to any kind of colour vision, the two sides of an axis still differ in lightness.
_SIDE_RGB = np.array(
    [
        [230, 159, 0],  # +x orange
        [213, 94, 0],  # -x vermillion
        [128, 207, 185],  # +y bluish green, half white
        [0, 158, 115],  # -y bluish green
        [86, 180, 233],  # +z sky blue
        [0, 114, 178],  # -z blue
    ],
    dtype=np.uint8,
)
_EDGE_RGB = (38, 38, 42)
_GRID_RGB = (158, 158, 158)
_GRID_AXIS_RGB = (105, 105, 105)
_PLATE_RGB = (245, 242, 230)
_PAINT_RGB = (184, 194, 208)  # of a mesh that brings no colours

# Directions to the two lights, and their strengths. The ambient part keeps the darkest face
# visible on a dark background, the sum stays below 1 on a light one.
_AMBIENT = 0.42
_LIGHTS = (((0.25, 0.80, 0.55), 0.50), ((-0.62, -0.25, -0.74), 0.24))


def _lit(normals: Floats) -> Floats:
    """Brightness (m,) of faces with these unit normals (m, 3) under the two soft lights."""
    light = np.full(len(normals), _AMBIENT)
    for direction, strength in _LIGHTS:
        light += strength * np.clip(normals @ np.array(direction), 0.0, None)
    return light


# --------------------------------------------------------------------------- quads and lines

# Quads are (m, 4, 3), lines (m, 2, 3), both float64 and relative to the origin, with their
# colours (m, 3) uint8.
Coloured: TypeAlias = tuple[Floats, Colours]


def _colours(rgb: ArrayLike, count: int) -> Colours:
    return np.array(np.broadcast_to(np.asarray(rgb, dtype=np.uint8), (count, 3)))


def _joined(*parts: Coloured) -> Coloured:
    return np.concatenate([p for p, _ in parts]), np.concatenate([rgb for _, rgb in parts])


def _box(lower: Sequence[float], upper: Sequence[float]) -> Floats:
    """The faces +x, -x, +y, -y, +z, -z of a box, counter-clockwise from outside, (6, 4, 3)."""
    faces = []
    for axis in range(3):
        right, up = (axis + 1) % 3, (axis + 2) % 3
        for at, turn in ((upper[axis], 1), (lower[axis], -1)):
            face = np.empty((4, 3))
            face[:, axis] = at
            face[:, right] = [lower[right], upper[right], upper[right], lower[right]]
            face[:, up] = [lower[up], lower[up], upper[up], upper[up]]
            faces.append(face[::turn])
    return np.array(faces)


def _edges(quads: Floats) -> Coloured:
    """Every edge of the quads, once."""
    points, corners = np.unique(quads.reshape(-1, 3), axis=0, return_inverse=True)
    corners = corners.reshape(-1, 4)
    edges = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2)
    edges = np.unique(np.sort(edges, axis=1), axis=0)
    return points[edges], _colours(_EDGE_RGB, len(edges))


def _grid(
    lower: tuple[float, float],
    upper: tuple[float, float],
    spacing: tuple[float, float],
    height: float,
    origin: Vector = (0.0, 0.0, 0.0),
) -> Coloured:
    """Ground lines of world x and z, at multiples of the spacing, that enclose the rectangle.

    Parameters
    ----------
    lower, upper, spacing : tuple of 2 floats
        World x and z.
    height : float
        World y of the grid.
    origin : Vector
        World point that the lines are given relative to.

    Returns
    -------
    Coloured
        The lines on the world's x and z axes are darker, where they are inside.
    """
    steps = [
        np.arange(math.floor(low / step), math.ceil(high / step) + 1)
        for low, high, step in zip(lower, upper, spacing, strict=True)
    ]
    x, z = (
        count * step - at
        for count, step, at in zip(steps, spacing, (origin[0], origin[2]), strict=True)
    )
    y = height - origin[1]
    along_z = [[(at, y, z[0]), (at, y, z[-1])] for at in x]
    along_x = [[(x[0], y, at), (x[-1], y, at)] for at in z]
    on_axis = np.concatenate([steps[0] == 0, steps[1] == 0])
    rgb = np.where(on_axis[:, None], _GRID_AXIS_RGB, _GRID_RGB).astype(np.uint8)
    return np.array(along_z + along_x), rgb


def _cell_array(offsets: NDArray[Any], corners: NDArray[Any]) -> pv.CellArray:
    return pv.CellArray.from_arrays(offsets, corners, deep=True)


def _poly_data(points: NDArray[np.floating], cells: pv.CellArray, rgb: Colours) -> pv.PolyData:
    poly_data = pv.PolyData()
    poly_data.points = np.ascontiguousarray(points, dtype=np.float32)
    if cells.n_cells and cells.GetMaxCellSize() > 2:
        poly_data.SetPolys(cells)
    else:
        poly_data.SetLines(cells)
    poly_data.cell_data["rgb"] = rgb
    return poly_data


def _surface(quads: Coloured) -> pv.PolyData:
    points, corners = np.unique(quads[0].reshape(-1, 3), axis=0, return_inverse=True)
    offsets = np.arange(0, corners.size + 1, 4)
    return _poly_data(points, _cell_array(offsets, corners.ravel()), quads[1])


def _line_set(lines: Coloured) -> pv.PolyData:
    ends = np.arange(2 * len(lines[0]))
    cells = _cell_array(np.arange(0, ends.size + 1, 2), ends)
    return _poly_data(lines[0].reshape(-1, 3), cells, lines[1])


# --------------------------------------------------------------------------- built-in scenes


def _built_in(name: str, quads: Coloured, lines: Coloured, start: Projection) -> Scene:
    points = quads[0].reshape(-1, 3)
    return Scene(
        name=name,
        origin=(0.0, 0.0, 0.0),
        surface=_surface(quads),
        lines=_line_set(lines),
        lower=_vector(points.min(axis=0)),
        upper=_vector(points.max(axis=0)),
        start=start,
        requires=_REQUIRES,
    )


def _vector(values: ArrayLike) -> Vector:
    x, y, z = np.asarray(values, dtype=np.float64).tolist()
    return x, y, z


_REQUIRES = frozenset({"grid"})

# Column and row of each cube: a stem of five, two more at the top, one more in the middle.
_LETTER_F = ((0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (1, 4), (2, 4), (1, 2))


def _letter_f() -> Scene:
    """Eight unit cubes on the ground, the letter's three columns centred about x = 0."""
    quads, rgb = [], []
    for column, row in _LETTER_F:
        faces = _box((column - 1.5, row, -0.5), (column - 0.5, row + 1.0, 0.5))
        touching = [(column + 1, row), (column - 1, row), (column, row + 1), (column, row - 1)]
        for side, face in enumerate(faces):
            if side >= 4 or touching[side] not in _LETTER_F:
                quads.append(face)
                rgb.append(_SIDE_RGB[side])
    faces = np.array(quads)
    return _built_in(
        "letter-f",
        (faces, np.array(rgb)),
        _joined(_grid((-8.0, -8.0), (8.0, 8.0), (1.0, 1.0), 0.0), _edges(faces)),
        Projection(
            Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0), (0.0, 1.0, 0.0)),
            Perspective(fov_y_deg=45.0, near=1.0, far=30.0),
            (1280, 720),
        ),
    )


def _cube() -> Scene:
    """A unit cube standing on the ground, with the world's axes coming out of it."""
    faces = _box((-0.5, 0.0, -0.5), (0.5, 1.0, 0.5))
    axes = np.array([[(0.0, 0.0, 0.0), end] for end in np.diag([1.5, 2.0, 1.5]).tolist()])
    return _built_in(
        "cube",
        (faces, _SIDE_RGB.copy()),
        _joined(
            _grid((-3.0, -3.0), (3.0, 3.0), (0.5, 0.5), 0.0),
            _edges(faces),
            (axes, _SIDE_RGB[[1, 3, 5]]),  # the darker shades, to be seen on a light background
        ),
        Projection(
            Camera((2.4, 2.0, 3.2), (0.0, 0.5, 0.0), (0.0, 1.0, 0.0)),
            Perspective(fov_y_deg=45.0, near=1.0, far=10.0),
            (1280, 720),
        ),
    )


_POSTS = 20
_POST_SPACING = 6.0

# The seven segments of a digit one unit wide and two high, as (left, bottom, right, top), and
# the segments that each digit lights.
_SEGMENTS = np.array(
    [
        (0.0, 1.8, 1.0, 2.0),  # a: top
        (0.8, 1.1, 1.0, 1.8),  # b: upper right
        (0.8, 0.2, 1.0, 0.9),  # c: lower right
        (0.0, 0.0, 1.0, 0.2),  # d: bottom
        (0.0, 0.2, 0.2, 0.9),  # e: lower left
        (0.0, 1.1, 0.2, 1.8),  # f: upper left
        (0.0, 0.9, 1.0, 1.1),  # g: middle
    ]
)
_DIGITS = ("abcdef", "bc", "abged", "abgcd", "fgbc", "afgcd", "afgedc", "abc", "abcdefg", "abcdfg")


def _number(number: int, centre: Vector, height: float) -> Floats:
    """A number written with seven-segment quads that face +z, (m, 4, 3)."""
    scale = height / 2.0
    digits = str(number)
    width = 1.5 * len(digits) - 0.5
    quads = []
    for place, digit in enumerate(digits):
        for segment in _DIGITS[int(digit)]:
            left, bottom, right, top = _SEGMENTS["abcdefg".index(segment)]
            x = np.array([left, right, right, left]) + 1.5 * place - width / 2.0
            y = np.array([bottom, bottom, top, top]) - 1.0
            quads.append(np.stack([x * scale, y * scale, np.zeros(4)], axis=1) + centre)
    return np.array(quads)


def _posts() -> Scene:
    """Posts of equal height and spacing, numbered on geometry, so that every pane projects it."""
    lit = _lit(np.repeat(np.eye(3), 2, axis=0) * np.tile([[1.0], [-1.0]], (3, 1)))
    wood = (lit[:, None] * _PAINT_RGB).astype(np.uint8)
    plate_rgb = (np.clip(lit + 0.25, 0.0, 1.0)[:, None] * _PLATE_RGB).astype(np.uint8)
    plate_rgb[4] = _PLATE_RGB  # the written side
    quads: list[Coloured] = []
    lines: list[Coloured] = []
    for number in range(1, _POSTS + 1):
        z = -_POST_SPACING * (number - 1)
        post = _box((-0.1, 0.0, z - 0.24), (0.1, 2.4, z - 0.04))
        plate = _box((-0.8, 1.5, z - 0.04), (0.8, 2.6, z + 0.04))
        digits = _number(number, (0.0, 2.05, z + 0.06), height=0.8)
        quads += [(post, wood), (plate, plate_rgb), (digits, _colours(_EDGE_RGB, len(digits)))]
        outline = _edges(plate)[0]  # grey: far away there is little else than outline
        lines.append((outline, _colours(_GRID_AXIS_RGB, len(outline))))
    ground = _grid((-10.0, -126.0), (10.0, 12.0), (2.0, 6.0), 0.0)
    return _built_in(
        "posts",
        _joined(*quads),
        _joined(ground, *lines),
        Projection(
            Camera((6.0, 5.0, 9.0), (1.0, 1.8, -8.0), (0.0, 1.0, 0.0)),
            Perspective(fov_y_deg=45.0, near=1.0, far=150.0),
            (1280, 720),
        ),
    )


_BUILDERS: dict[str, Callable[[], Scene]] = {
    "letter-f": _letter_f,
    "cube": _cube,
    "posts": _posts,
}
BUILT_IN = tuple(_BUILDERS)
"""Names of the built-in scenes, in the order of the lectures."""


# --------------------------------------------------------------------------- meshes from files


@dataclass(eq=False)
class _Mesh:
    """What a file holds: float64 world points and polygons of any number of corners.

    Attributes
    ----------
    points : (n, 3) float64
        World coordinates.
    offsets : (m + 1,) int64
        Face i has the corners ``corners[offsets[i]:offsets[i + 1]]``.
    corners : (offsets[m],) int64
        Indices into `points`.
    rgb : (m, 3) uint8 or None
        Colour of each face, where the file has colours.
    painted : bool
        Whether `rgb` is what was seen at each place (scanned or painted vertex colours), to be
        shown as it is, and not the colour of a material, which shows no shape until it is lit.
    """

    points: Floats
    offsets: Ints
    corners: Ints
    rgb: Colours | None = None
    painted: bool = False


def _scene_of_mesh(name: str, path: Path, progress: Progress | None) -> Scene:
    _check_readable(path)
    _report(progress, 0.0)
    mesh = _READERS[path.suffix.lower()](path, progress)
    _check_mesh(path, mesh)
    _report(progress, 0.5)
    _drop_unused_points(mesh)
    lower, upper = _vector(mesh.points.min(axis=0)), _vector(mesh.points.max(axis=0))
    size = math.dist(lower, upper)
    if size == 0.0:
        raise SceneError(
            f"{path}: all vertices are at one point, so that there is nothing to see; "
            "check the export."
        )
    if not 1e-30 < size < 1e30:  # the GPU's float32 ends near 1e-38 and 1e38
        raise SceneError(
            f"{path}: the mesh is {size:.2g} units large, but must be between 1e-30 and 1e30; "
            "scale it."
        )
    # A round number near the middle, and 0 for a mesh that is at the origin anyway.
    origin = _rounded(_centre(lower, upper), -math.floor(math.log10(size)))
    mesh.points -= np.array(origin)
    _report(progress, 0.6)
    rgb = _face_colours(mesh, progress)

    lines = _ground(lower, upper, origin)
    if len(mesh.offsets) - 1 <= FACES_WITH_EDGES:
        edges = _feature_edges(mesh)
        lines = _joined(lines, (edges, _colours(_EDGE_RGB, len(edges))))
    scene = Scene(
        name=name,
        origin=origin,
        surface=_poly_data(mesh.points, _cell_array(mesh.offsets, mesh.corners), rgb),
        lines=_line_set(lines),
        lower=lower,
        upper=upper,
        start=frame_camera(lower, upper),
        requires=_REQUIRES,
    )
    _report(progress, 1.0)
    return scene


def _report(progress: Progress | None, fraction: float) -> None:
    if progress is not None and not progress(fraction):
        raise SceneCancelled


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):  # no permission to look, or a name that no file can have
        return False


def _check_readable(path: Path) -> None:
    """Open the file once ourselves: what VTK says of a file it cannot open names no cause."""
    try:
        str(path).encode()  # VTK takes names as UTF-8
        with path.open("rb") as file:
            empty = not file.read(1)
    except FileNotFoundError:
        raise SceneError(f"{path}: there is no such file; check its name and folder.") from None
    except IsADirectoryError:
        raise SceneError(f"{path}: this is a folder; choose a mesh file inside it.") from None
    except PermissionError:
        raise SceneError(f"{path}: no permission to read it; change its permissions.") from None
    except OSError as error:
        raise SceneError(f"{path}: cannot be read ({error.strerror}).") from None
    except ValueError:  # a zero byte, or a name that is not Unicode
        raise SceneError(f"{str(path)!r}: not a possible file name; rename the file.") from None
    if empty:
        raise SceneError(f"{path}: the file is empty; save or download it again.")


def _check_mesh(path: Path, mesh: _Mesh) -> None:
    faces = len(mesh.offsets) - 1
    vertices = len(mesh.points)
    if faces < 1:
        found = (
            "one vertex"
            if vertices == 1
            else f"{vertices} vertices"
            if vertices
            else "and no vertices"
        )
        raise SceneError(
            f"{path}: the file holds no faces ({found}), so that there is no surface to draw; "
            "export the mesh with faces."
        )
    too_small = int(np.count_nonzero(np.diff(mesh.offsets) < 3))
    if too_small:
        raise SceneError(
            f"{path}: {_counted(too_small, 'face')} of {faces} "
            f"{'has' if too_small == 1 else 'have'} fewer than three corners; "
            "the file is damaged or cut off, save or download it again."
        )
    if mesh.corners.min() < 0 or mesh.corners.max() >= vertices:
        raise SceneError(
            f"{path}: a face names a vertex that does not exist (there are {vertices}); "
            "the file is damaged or cut off, save or download it again."
        )
    not_finite = int(np.count_nonzero(~np.isfinite(mesh.points).all(axis=1)))
    if not_finite:
        raise SceneError(
            f"{path}: {_counted(not_finite, 'vertex', 'vertices')} of {vertices} "
            f"{'is' if not_finite == 1 else 'are'} not finite (nan or inf); "
            "repair the mesh and export it again."
        )


def _counted(count: int, one: str, many: str = "") -> str:
    return f"{count} {one if count == 1 else many or one + 's'}"


def _drop_unused_points(mesh: _Mesh) -> None:
    """Vertices of no face are not drawn, and must not move the camera away from those that are."""
    used = np.zeros(len(mesh.points), dtype=bool)
    used[mesh.corners] = True
    if not used.all():
        mesh.corners = (np.cumsum(used) - 1)[mesh.corners]
        mesh.points = mesh.points[used]


def _faces_by_size(mesh: _Mesh) -> Iterator[tuple[slice | Ints, Ints]]:
    """Which faces, and their corners (m, k), for every k that occurs, in blocks to work on."""
    block = 100_000
    counts = np.diff(mesh.offsets)
    for size in np.unique(counts).tolist():
        if (counts == size).all():
            corners = mesh.corners.reshape(-1, size)
            for first in range(0, len(corners), block):
                yield slice(first, first + block), corners[first : first + block]
        else:
            faces = np.flatnonzero(counts == size)
            for first in range(0, len(faces), block):
                some = faces[first : first + block]
                yield some, mesh.corners[mesh.offsets[some][:, None] + np.arange(size)]


def _face_colours(mesh: _Mesh, progress: Progress | None) -> Colours:
    faces = len(mesh.offsets) - 1
    if mesh.rgb is not None and mesh.painted and (mesh.rgb != mesh.rgb[0]).any():
        return mesh.rgb
    paint = np.asarray(_PAINT_RGB if mesh.rgb is None else mesh.rgb, dtype=np.float32)
    light = np.empty((faces, 1), dtype=np.float32)
    done = 0
    for which, corners in _faces_by_size(mesh):
        normals = _normals(mesh.points, corners)
        light[which, 0] = _lit(normals)
        done += len(corners)
        _report(progress, 0.6 + 0.3 * done / faces)
    return (paint * light).astype(np.uint8)


def _normals(points: Floats, corners: Ints) -> Floats:
    """Unit normals (m, 3) of polygons (m, k), 0 where the area is 0.

    The area vectors of the triangles of a fan add up to that of the polygon, also of a concave
    one.
    """
    first = points[corners[:, 0]]
    area = np.zeros((3, len(corners)))
    before = (points[corners[:, 1]] - first).T
    for k in range(2, corners.shape[1]):
        after = (points[corners[:, k]] - first).T
        area[0] += before[1] * after[2] - before[2] * after[1]
        area[1] += before[2] * after[0] - before[0] * after[2]
        area[2] += before[0] * after[1] - before[1] * after[0]
        before = after
    length = np.sqrt((area**2).sum(axis=0))
    length[length == 0.0] = 1.0
    normals: Floats = (area / length).T
    return normals


def _merge_points(points: Floats) -> tuple[Floats, Ints]:
    """Points at exactly the same place become one: (distinct points, index of each in them)."""
    poly_data = pv.PolyData()
    poly_data.points = points
    locator = vtkStaticPointLocator()
    locator.SetDataSet(poly_data)
    locator.BuildLocator()
    merged_to = np.empty(len(points), dtype=np.int64)
    locator.MergePoints(0.0, merged_to)  # type: ignore[arg-type]  # an array is taken in place
    kept = merged_to == np.arange(len(points))
    return points[kept], (np.cumsum(kept) - 1)[merged_to]


def _feature_edges(mesh: _Mesh) -> Floats:
    """Sharp and free edges (m, 2, 3) of a small mesh.

    Files repeat a vertex for every face, or where its texture or normal changes; only when the
    copies are one point again do two faces know that they are neighbours.
    """
    points, merged = _merge_points(mesh.points)
    poly_data = pv.PolyData()
    poly_data.points = points
    poly_data.SetPolys(_cell_array(mesh.offsets, merged[mesh.corners]))
    edges = vtkFeatureEdges()
    edges.SetInputData(poly_data)
    edges.SetFeatureAngle(30.0)
    edges.ColoringOff()
    edges.Update()
    found = edges.GetOutput()
    if found.GetNumberOfLines() == 0:
        return np.empty((0, 2, 3))
    _, ends = _cells(found.GetLines())
    vertices: Floats = _values(found.GetPoints().GetData()).astype(np.float64)
    return vertices[ends.reshape(-1, 2)]


def _ground(lower: Vector, upper: Vector, origin: Vector) -> Coloured:
    """A grid under the mesh, at its lowest y, wider than the mesh, with 1-2-5 spacing."""
    size = math.dist(lower, upper)
    decade = 10.0 ** math.floor(math.log10(size / 8.0))
    spacing = max(step * decade for step in (1.0, 2.0, 5.0) if step * decade <= size / 8.0)
    rim = 0.5 * size
    return _grid(
        (lower[0] - rim, lower[2] - rim),
        (upper[0] + rim, upper[2] + rim),
        (spacing, spacing),
        lower[1],
        origin,
    )


# --------------------------------------------------------------------------- file formats
#
# VTK reads OBJ, and keeps its float64 vertices. Its other readers (vtk 9.7) cannot be had without
# loss: STL and PLY make every coordinate a float32, glTF the translation of every node, so that a
# mesh at 1e7 moves by up to half a unit; and PLY and glTF read past the end of a file that is cut
# off. These are tables of numbers, which numpy reads as fast.


@contextmanager
def _vtk_messages() -> Iterator[vtkStringOutputWindow]:
    """Collect what VTK would print on stderr, through its window and through its logger."""
    window = vtkStringOutputWindow()
    usual_window = vtkOutputWindow.GetInstance()
    usual_verbosity = vtkLogger.GetCurrentVerbosityCutoff()
    vtkOutputWindow.SetInstance(window)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        yield window
    finally:
        vtkLogger.SetStderrVerbosity(usual_verbosity)
        vtkOutputWindow.SetInstance(usual_window)


def _damaged(path: Path, problem: str) -> SceneError:
    return SceneError(f"{path}: {problem}; export or download the file again.")


def _values(array: vtkDataArray) -> NDArray[Any]:
    return np.asarray(vtk_to_numpy(array))  # type: ignore[no-untyped-call]


def _cells(cells: vtkCellArray) -> tuple[Ints, Ints]:
    """Offsets and corners of a VTK cell array."""
    cells.ConvertTo64BitStorage()
    offsets = _values(cells.GetOffsetsArray())
    corners = _values(cells.GetConnectivityArray())
    return offsets.astype(np.int64), corners.astype(np.int64)


def _bytes(colours: NDArray[np.floating]) -> Colours:
    rgb: Colours = np.clip(np.rint(np.nan_to_num(colours)), 0, 255).astype(np.uint8)
    return rgb


def _paint_with_vertex_colours(mesh: _Mesh, colours: NDArray[np.floating]) -> None:
    """Give each face the mean colour of its corners; colours (n, 3) from 0 to 255."""
    sound = len(mesh.offsets) > 1 and np.diff(mesh.offsets).min() > 0
    if not sound or mesh.corners.min() < 0 or mesh.corners.max() >= len(colours):
        return  # the check that follows says what is wrong with this mesh
    sums = np.add.reduceat(colours.astype(np.float32)[mesh.corners], mesh.offsets[:-1], axis=0)
    mean = sums / np.diff(mesh.offsets).astype(np.float32)[:, None]
    mesh.rgb = _bytes(mean)
    mesh.painted = True


def _full_scale(kind: np.dtype[Any]) -> float:
    """The number that means full brightness in a channel of this type."""
    return 1.0 if kind.kind == "f" else float(np.iinfo(kind).max)


def _read_obj(path: Path, progress: Progress | None) -> _Mesh:
    reader = vtkOBJReader()
    reader.SetFileName(str(path))
    with _vtk_messages() as window:
        reader.Update()
    message = re.search(r"ERROR: .*\n.*?\): (.+)", window.GetOutput())  # the first is the cause
    if message is not None:
        reason = message[1].strip().rstrip(".")
        raise _damaged(path, f"it cannot be read as OBJ ({reason})")
    poly_data = reader.GetOutput()
    if poly_data.GetPoints() is None:
        points = np.empty((0, 3))
    else:
        points = _values(poly_data.GetPoints().GetData()).astype(np.float64)
    mesh = _Mesh(points, *_cells(poly_data.GetPolys()))
    colours = poly_data.GetPointData().GetArray("RGB")
    if colours is not None:
        _paint_with_vertex_colours(mesh, _values(colours).astype(np.float64))
    return mesh


_STL_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def _read_stl(path: Path, progress: Progress | None) -> _Mesh:
    with path.open("rb") as file:
        head = file.read(4096)
        length = file.seek(0, 2)
        count = int.from_bytes(head[80:84], "little")
        binary_length = 84 + _STL_TRIANGLE.itemsize * count
        # Many binary files begin with "solid" like the text ones: the length decides first.
        if len(head) >= 84 and length == binary_length:
            corners = _stl_binary(file, count)
        elif head.lstrip()[:5].lower() == b"solid":
            corners = _stl_text(path, file, length, progress)
        elif len(head) < 84 or b"\0" not in head:
            raise SceneError(
                f"{path}: this is not an STL file, neither text (which begins with “solid”) nor "
                "binary; check what kind of file it is."
            )
        elif length < binary_length:
            there = (length - 84) // _STL_TRIANGLE.itemsize
            raise _damaged(path, f"the file is cut off after {there} of {count} triangles")
        else:  # some programs append data of their own
            corners = _stl_binary(file, count)
    _report(progress, 0.4)
    offsets = np.arange(0, len(corners) + 1, 3)
    if len(corners) == 0 or not np.isfinite(corners).all():
        return _Mesh(corners, offsets, np.arange(len(corners)))
    points, merged = _merge_points(corners)
    return _Mesh(points, offsets, merged)


def _stl_binary(file: BinaryIO, count: int) -> Floats:
    """Corners (3 m, 3) of the triangles; float32 by definition of the format."""
    file.seek(84)
    triangles = np.fromfile(file, dtype=_STL_TRIANGLE, count=count)
    return triangles["corners"].reshape(-1, 3).astype(np.float64)


def _stl_text(path: Path, file: BinaryIO, length: int, progress: Progress | None) -> Floats:
    """Corners (3 m, 3) of the triangles, with all the digits of the text."""
    file.seek(0)
    rest = b""
    blocks = [np.empty(0)]
    while block := file.read(1 << 24):
        text = (rest + block).lower()
        end = text.rfind(b"endloop") + len(b"endloop")
        if end < len(b"endloop"):
            rest = text
            continue
        text, rest = text[:end], text[end:]
        text = _without_stl_names(text)
        # "... outer loop vertex x y z vertex x y z vertex x y z endloop ...": the odd pieces.
        loops = text.split(b"loop")[1::2]
        numbers = _numbers(b" ".join(loops).replace(b"vertex", b"").replace(b"end", b""))
        if numbers is None or len(numbers) != 9 * len(loops):
            raise _damaged(path, "a facet has not three vertices of three numbers")
        blocks.append(numbers)
        _report(progress, 0.4 * file.tell() / length)
    if b"vertex" in _without_stl_names(rest):
        raise _damaged(path, "the file is cut off in the middle of a facet")
    return np.concatenate(blocks).reshape(-1, 3)


def _without_stl_names(text: bytes) -> bytes:
    """Text STL without what follows “solid” and “endsolid”, where any word may occur."""
    if b"solid" not in text:
        return text
    return re.sub(rb"solid[^\n]*?(?=facet\s+normal|\n|\Z)", b"", text)


def _numbers(text: bytes) -> Floats | None:
    """The numbers of a text, or None where something else is among them."""
    if not text.strip():
        return np.empty(0)
    with warnings.catch_warnings():  # numpy says "unmatched data" and answers what it has
        warnings.simplefilter("error", DeprecationWarning)
        try:
            return np.fromstring(text, dtype=np.float64, sep=" ")
        except (DeprecationWarning, ValueError):
            return None


_PLY_TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
    "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4",
    "float": "f4", "double": "f8", "float32": "f4", "float64": "f8",
}  # fmt: skip


@dataclass(frozen=True)
class _PlyProperty:
    name: str
    kind: np.dtype[Any]  # as it lies in the body
    full_scale: float  # that means full brightness, where it is a colour channel
    count: np.dtype[Any] | None = None  # of the count in front of a list, None for one number


def _read_ply(path: Path, progress: Progress | None) -> _Mesh:
    elements, body = _ply_header_and_body(path)
    _report(progress, 0.2)
    mesh = _Mesh(np.empty((0, 3)), np.zeros(1, dtype=np.int64), np.empty(0, dtype=np.int64))
    at = 0
    for element, rows, properties in elements:
        columns, lengths, at = _ply_columns(path, element, rows, properties, body, at)
        scale = {p.name: 255.0 / p.full_scale for p in properties}
        rgb = [
            columns[channel].astype(np.float32) * scale[channel]
            for channel in ("red", "green", "blue")
            if channel in columns
        ]
        if element == "vertex":
            try:
                xyz = [columns[axis] for axis in "xyz"]
            except KeyError:
                raise _damaged(path, "its vertices have no x, y, z") from None
            mesh.points = np.stack(xyz, axis=1).astype(np.float64)
            vertex_rgb = rgb
        elif element == "face":
            name = next((n for n in ("vertex_indices", "vertex_index") if n in lengths), None)
            if name is None:
                raise _damaged(path, "its faces have no list vertex_indices")
            mesh.offsets = np.concatenate([[0], np.cumsum(lengths[name])])
            with np.errstate(invalid="ignore"):  # what is no index, is out of range too
                mesh.corners = columns[name].astype(np.int64)
            if len(rgb) == 3:
                mesh.rgb = _bytes(np.stack(rgb, axis=1))
                mesh.painted = True
        _report(progress, 0.4)
    if mesh.rgb is None and len(vertex_rgb) == 3:
        _paint_with_vertex_colours(mesh, np.stack(vertex_rgb, axis=1))
    return mesh


def _ply_header_and_body(
    path: Path,
) -> tuple[list[tuple[str, int, list[_PlyProperty]]], bytes]:
    """The elements up to the faces, each with its number of rows and columns, and the numbers.

    A text body becomes what a binary one is, with every number a float64.
    """
    data = path.read_bytes()
    header = re.match(rb"ply\s.*?end_header[^\S\n]*\r?\n?", data[:1_000_000], re.DOTALL)
    if header is None:
        raise SceneError(
            f"{path}: this is not a PLY file, which begins with “ply” and has a line "
            "“end_header”; check what kind of file it is."
        )
    encoding = ""
    elements: list[tuple[str, int, list[_PlyProperty]]] = []
    try:
        for line in header[0].decode("latin-1").splitlines():
            words = line.split()
            if words[:1] == ["format"]:
                encoding = words[1]
                order = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}[
                    encoding
                ]
            elif words[:1] == ["element"]:
                elements.append((words[1], int(words[2]), []))
            elif words[:1] == ["property"]:
                *kinds, name = words[1:]
                stored = [np.dtype(_PLY_TYPES[kind]) for kind in kinds if kind != "list"]
                if len(stored) != (2 if kinds[0] == "list" else 1):
                    raise ValueError
                read = [np.dtype(order + k.str[1:]) if order else np.dtype("f8") for k in stored]
                column = _PlyProperty(name, read[-1], _full_scale(stored[-1]), *read[:-1])
                elements[-1][2].append(column)
        names = [element for element, _, _ in elements]
        if "vertex" not in names or not encoding or min(rows for _, rows, _ in elements) < 0:
            raise ValueError
    except (IndexError, KeyError, ValueError, UnboundLocalError):
        raise _damaged(path, "its PLY header does not describe a mesh") from None
    needed = 1 + max(names.index(name) for name in ("vertex", "face") if name in names)
    body = data[header.end() :]
    if encoding == "ascii":
        numbers = _numbers(body)
        if numbers is None:
            raise _damaged(path, "there is something between its numbers that is not a number")
        body = numbers.tobytes()
    return elements[:needed], body


def _ply_columns(
    path: Path, element: str, rows: int, properties: list[_PlyProperty], body: bytes, at: int
) -> tuple[dict[str, NDArray[Any]], dict[str, Ints], int]:
    """Columns of one element, the lengths of its lists (whose items are joined), and its end."""
    lists = [p for p in properties if p.count is not None]
    cut_off = _damaged(path, f"the file is cut off before the last of its {rows} {element} rows")
    if rows == 0:
        empty = {p.name: np.empty(0, dtype=p.kind) for p in properties}
        return empty, {p.name: np.empty(0, dtype=np.int64) for p in lists}, at

    def row_at(start: int) -> tuple[list[tuple[int, int]], int]:
        """Where each column's numbers begin in this row, how many they are, the row's end."""
        places = []
        for p in properties:
            length = 1
            if p.count is not None:
                if start + p.count.itemsize > len(body):
                    raise cut_off
                length = int(np.frombuffer(body, p.count, 1, start)[0])
                start += p.count.itemsize
            places.append((start, length))
            start += length * p.kind.itemsize
            if length < 0 or start > len(body):
                raise cut_off
        return places, start

    # As a rule all lists are as long as those of the first row, and the element is a table.
    places, _ = row_at(at)
    fields: list[tuple[Any, ...]] = []
    for p, (_, length) in zip(properties, places, strict=True):
        if p.count is not None:
            fields += [(f"length of {p.name}", p.count), (p.name, p.kind, (length,))]
        else:
            fields.append((p.name, p.kind))
    row = np.dtype(fields)
    end = at + rows * row.itemsize
    if end <= len(body):
        table = np.frombuffer(body, row, rows, at)
        counts = {p.name: table[f"length of {p.name}"].astype(np.int64) for p in lists}
        if all((count == count[0]).all() for count in counts.values()):
            return {p.name: table[p.name].ravel() for p in properties}, counts, end
    elif not lists:
        raise cut_off

    # Otherwise only a walk from row to row finds where each begins.
    found: list[list[tuple[int, int]]] = []
    for _ in range(rows):
        places, at = row_at(at)
        found.append(places)
    starts, lengths = np.moveaxis(np.array(found, dtype=np.int64), 2, 0)
    octets = np.frombuffer(body, dtype=np.uint8)
    columns = {}
    for i, p in enumerate(properties):
        offsets = np.cumsum(lengths[:, i]) - lengths[:, i]
        item = np.arange(lengths[:, i].sum()) - np.repeat(offsets, lengths[:, i])
        first = np.repeat(starts[:, i], lengths[:, i]) + item * p.kind.itemsize
        items = octets[first[:, None] + np.arange(p.kind.itemsize)]
        columns[p.name] = np.ascontiguousarray(items).view(p.kind).ravel()
    return columns, {p.name: lengths[:, properties.index(p)] for p in lists}, at


_GLTF_TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_GLTF_PARTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
_GLTF_PACKED = frozenset({"KHR_draco_mesh_compression", "EXT_meshopt_compression"})


def _read_gltf(path: Path, progress: Progress | None) -> _Mesh:
    data = path.read_bytes()
    body = b""
    if path.suffix.lower() == ".glb":
        if data[:4] != b"glTF":
            raise SceneError(
                f"{path}: this is not a GLB file, which begins with “glTF”; "
                "check what kind of file it is."
            )
        text_end = 20 + int.from_bytes(data[12:16], "little")
        data, body = data[20:text_end], data[text_end + 8 :]
    meshes = []
    try:
        content = json.loads(data)
        if not str(content["asset"]["version"]).startswith("2."):
            raise ValueError(f"version {content['asset']['version']}, not 2")
        packed = _GLTF_PACKED.intersection(content.get("extensionsRequired", ()))
        if packed:
            raise SceneError(
                f"{path}: its mesh is compressed ({', '.join(sorted(packed))}); "
                "export it without compression."
            )
        buffers = [_gltf_buffer(path, buffer, body) for buffer in content.get("buffers", ())]
        _report(progress, 0.2)
        for node, world_from_node in _gltf_nodes(content):
            if "mesh" in node:
                for primitive in content["meshes"][node["mesh"]]["primitives"]:
                    meshes.append(_gltf_primitive(content, buffers, primitive, world_from_node))
                    _report(progress, 0.3)
    except SceneError:
        raise
    except (LookupError, AttributeError, TypeError, ValueError, RecursionError) as error:
        reason = f"{type(error).__name__}: {error}".replace("\n", " ")
        raise _damaged(path, f"its glTF description is not valid ({reason})") from None
    first_point = np.cumsum([0] + [len(mesh.points) for mesh in meshes])
    corners = [m.corners + at for m, at in zip(meshes, first_point[:-1], strict=True)]
    joined = np.concatenate([np.empty(0, dtype=np.int64), *corners])
    return _Mesh(
        np.concatenate([np.empty((0, 3))] + [mesh.points for mesh in meshes]),
        np.arange(0, len(joined) + 1, 3),
        joined,
        np.concatenate(
            [np.empty((0, 3), dtype=np.uint8)]
            + [mesh.rgb for mesh in meshes if mesh.rgb is not None]
        ),
        painted=all(mesh.painted for mesh in meshes),
    )


def _gltf_buffer(path: Path, buffer: dict[str, Any], body: bytes) -> bytes:
    address = buffer.get("uri")
    if address is None:
        data = body
    elif address.startswith("data:"):
        data = base64.b64decode(address.partition(",")[2])
    else:
        part = path.parent / unquote(address)
        try:
            data = part.read_bytes()
        except OSError as error:
            raise SceneError(
                f"{path}: its part {part} cannot be read ({error.strerror}); "
                "keep the files of a glTF mesh together."
            ) from None
    if len(data) < buffer["byteLength"]:
        raise _damaged(
            path, f"the file is cut off after {len(data)} of {buffer['byteLength']} bytes of data"
        )
    return data


def _gltf_nodes(content: dict[str, Any]) -> Iterator[tuple[dict[str, Any], Floats]]:
    """The nodes of the scene, each with its world_from_node (4, 4)."""
    nodes = content.get("nodes", [])
    if content.get("scenes"):
        roots = content["scenes"][content.get("scene", 0)].get("nodes", [])
    else:
        roots = set(range(len(nodes))).difference(*(node.get("children", ()) for node in nodes))
    waiting = [(root, np.eye(4)) for root in roots]
    seen = 0
    while waiting:
        index, world_from_parent = waiting.pop(0)
        node = nodes[index]
        seen += 1
        if seen > len(nodes):
            raise ValueError("a node is below itself")
        if "matrix" in node:  # written column by column
            parent_from_node = np.array(node["matrix"], dtype=np.float64).reshape(4, 4).T
        else:
            x, y, z, w = node.get("rotation", (0.0, 0.0, 0.0, 1.0))
            rotation = np.array(
                [
                    [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
                ]
            )
            parent_from_node = np.eye(4)
            parent_from_node[:3, :3] = rotation * node.get("scale", (1.0, 1.0, 1.0))
            parent_from_node[:3, 3] = node.get("translation", (0.0, 0.0, 0.0))
        world_from_node = world_from_parent @ parent_from_node
        yield node, world_from_node
        waiting += [(child, world_from_node) for child in node.get("children", ())]


def _gltf_primitive(
    content: dict[str, Any],
    buffers: list[bytes],
    primitive: dict[str, Any],
    world_from_node: Floats,
) -> _Mesh:
    """The triangles of a primitive; none where it is of points or lines."""
    attributes = primitive["attributes"]
    local = _gltf_values(content, buffers, attributes["POSITION"])
    with np.errstate(invalid="ignore", over="ignore"):  # `_check_mesh` says so in words
        points = local.astype(np.float64) @ world_from_node[:3, :3].T + world_from_node[:3, 3]
    if "indices" in primitive:
        order = _gltf_values(content, buffers, primitive["indices"]).ravel().astype(np.int64)
    else:
        order = np.arange(len(points))
    mode = primitive.get("mode", 4)
    i = np.arange(max(len(order) - 2, 0))
    if mode == 4:
        triangles = order[: len(order) // 3 * 3].reshape(-1, 3)
    elif mode == 5:  # a strip: every other triangle runs the other way round
        triangles = np.stack([order[i], order[i + 1 + i % 2], order[i + 2 - i % 2]], axis=1)
    elif mode == 6:  # a fan about the first vertex
        triangles = np.stack([order[i * 0], order[i + 1], order[i + 2]], axis=1)
    else:
        triangles = np.empty((0, 3), dtype=np.int64)
    if np.linalg.det(world_from_node[:3, :3]) < 0.0:  # a mirror turns faces inside out
        triangles = triangles[:, ::-1]
    mesh = _Mesh(points, np.arange(0, triangles.size + 1, 3), triangles.ravel())
    if "COLOR_0" in attributes:
        linear = _gltf_values(content, buffers, attributes["COLOR_0"])[:, :3]
        scale = _full_scale(linear.dtype)
        _paint_with_vertex_colours(mesh, _srgb(linear.astype(np.float64) / scale))
    if mesh.rgb is None:
        material = content["materials"][primitive["material"]] if "material" in primitive else {}
        factor = material.get("pbrMetallicRoughness", {}).get("baseColorFactor", (1, 1, 1))[:3]
        white = tuple(factor) == (1, 1, 1)  # what a mesh without colours, or with a texture, has
        rgb = _PAINT_RGB if white else _bytes(_srgb(np.array(factor, dtype=np.float64)))
        mesh.rgb = _colours(rgb, len(triangles))
    return mesh


def _gltf_values(content: dict[str, Any], buffers: list[bytes], index: int) -> NDArray[Any]:
    """The values of an accessor, one row for each element."""
    accessor = content["accessors"][index]
    if "sparse" in accessor or "bufferView" not in accessor:
        raise ValueError("sparse accessors are not read")
    view = content["bufferViews"][accessor["bufferView"]]
    first = view.get("byteOffset", 0)
    data = memoryview(buffers[view["buffer"]])[first : first + view["byteLength"]]
    kind = np.dtype(_GLTF_TYPES[accessor["componentType"]])
    parts, count = _GLTF_PARTS[accessor["type"]], accessor["count"]
    stride = view.get("byteStride", kind.itemsize * parts)
    start = accessor.get("byteOffset", 0)
    end = start + (count - 1) * stride + kind.itemsize * parts
    if count < 1 or start < 0 or stride < 1 or end > len(data):
        raise ValueError(f"accessor {index} asks for more data than there are")
    return np.ndarray((count, parts), kind, data, start, (stride, kind.itemsize))


def _srgb(linear: Floats) -> Floats:
    """Linear light from 0 to 1, which glTF stores, as sRGB from 0 to 255."""
    linear = np.clip(linear, 0.0, 1.0)
    return 255.0 * np.where(
        linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055
    )


_READERS: dict[str, Callable[[Path, Progress | None], _Mesh]] = {
    ".obj": _read_obj,
    ".stl": _read_stl,
    ".ply": _read_ply,
    ".gltf": _read_gltf,
    ".glb": _read_gltf,
}
ENDINGS = tuple(_READERS)
"""Endings of the mesh files that `load` reads."""
