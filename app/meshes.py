"""Meshes out of the user's files: OBJ, STL, PLY and glTF, in float64, or one sentence why not.

This room knows the formats and what can be wrong with a file. It gives points and polygons;
what they look like, and from where, is `app.scene`'s.

VTK reads OBJ, and keeps its float64 vertices. Its other readers (vtk 9.7) cannot be had without
loss: STL and PLY make every coordinate a float32, glTF the translation of every node, so that a
mesh at 1e7 moves by up to half a unit; and PLY and glTF read past the end of a file that is cut
off. These are tables of numbers, which numpy reads as fast.
"""

from __future__ import annotations

import base64
import json
import re
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO, TypeAlias
from urllib.parse import unquote

import numpy as np
import pyvista as pv
from numpy.typing import NDArray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    vtkDataArray,
    vtkLogger,
    vtkOutputWindow,
    vtkStringOutputWindow,
)
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkStaticPointLocator
from vtkmodules.vtkIOGeometry import vtkOBJReader

Floats: TypeAlias = NDArray[np.float64]
Ints: TypeAlias = NDArray[np.int64]
Colours: TypeAlias = NDArray[np.uint8]
Progress: TypeAlias = Callable[[float], bool]

PAINT_RGB = (184, 194, 208)
"""Colour of a surface that brings none."""

# What can be wrong with a file: whole sentences, so that they can be translated.
NO_FILE = "{0}: there is no such file; check its name and folder."
FOLDER = "{0}: this is a folder; choose a mesh file inside it."
NO_PERMISSION = "{0}: no permission to read it; change its permissions."
UNREADABLE = "{0}: cannot be read ({1})."
BAD_NAME = "{0}: not a possible file name; rename the file."
EMPTY = "{0}: the file is empty; save or download it again."
NO_VERTICES = (
    "{0}: the file holds no faces (and no vertices), so that there is no surface to draw; "
    "export the mesh with faces."
)
ONE_VERTEX = (
    "{0}: the file holds no faces (one vertex), so that there is no surface to draw; "
    "export the mesh with faces."
)
ONLY_VERTICES = (
    "{0}: the file holds no faces ({1} vertices), so that there is no surface to draw; "
    "export the mesh with faces."
)
SMALL_FACE = (
    "{0}: {1} face of {2} has fewer than three corners; "
    "the file is damaged or cut off, save or download it again."
)
SMALL_FACES = (
    "{0}: {1} faces of {2} have fewer than three corners; "
    "the file is damaged or cut off, save or download it again."
)
NO_SUCH_VERTEX = (
    "{0}: a face names a vertex that does not exist (there are {1}); "
    "the file is damaged or cut off, save or download it again."
)
VERTEX_NOT_FINITE = (
    "{0}: {1} vertex of {2} is not finite (nan or inf); repair the mesh and export it again."
)
VERTICES_NOT_FINITE = (
    "{0}: {1} vertices of {2} are not finite (nan or inf); repair the mesh and export it again."
)
NOT_OBJ = "{0}: it cannot be read as OBJ ({1}); export or download the file again."
NOT_STL = (
    "{0}: this is not an STL file, neither text (which begins with “solid”) nor binary; "
    "check what kind of file it is."
)
STL_CUT_OFF = (
    "{0}: the file is cut off after {1} of {2} triangles; export or download the file again."
)
STL_NUMBERS = (
    "{0}: a facet has not three vertices of three numbers; export or download the file again."
)
STL_FACET_CUT_OFF = (
    "{0}: the file is cut off in the middle of a facet; export or download the file again."
)
NOT_PLY = (
    "{0}: this is not a PLY file, which begins with “ply” and has a line “end_header”; "
    "check what kind of file it is."
)
PLY_HEADER = "{0}: its PLY header does not describe a mesh; export or download the file again."
PLY_NUMBERS = (
    "{0}: there is something between its numbers that is not a number; "
    "export or download the file again."
)
PLY_NO_XYZ = "{0}: its vertices have no x, y, z; export or download the file again."
PLY_NO_CORNERS = "{0}: its faces have no list vertex_indices; export or download the file again."
PLY_CUT_OFF = (
    "{0}: the file is cut off before the last of its {1} {2} rows; "
    "export or download the file again."
)
NOT_GLB = "{0}: this is not a GLB file, which begins with “glTF”; check what kind of file it is."
GLTF_COMPRESSED = "{0}: its mesh is compressed ({1}); export it without compression."
GLTF_PART = "{0}: its part {1} cannot be read ({2}); keep the files of a glTF mesh together."
GLTF_CUT_OFF = (
    "{0}: the file is cut off after {1} of {2} bytes of data; export or download the file again."
)
GLTF_DAMAGED_LINE = (
    "{0}: its JSON part, which describes the mesh, is damaged in line {1}; "
    "export or download the file again."
)
GLTF_DAMAGED = (
    "{0}: its JSON part, which describes the mesh, is damaged; export or download the file again."
)
GLTF_LACKS = "{0}: its glTF description lacks “{1}”; export or download the file again."
GLTF_VERSION = (
    "{0}: its glTF description is not valid (version {1}, not 2); "
    "export or download the file again."
)
GLTF_CIRCLE = (
    "{0}: its glTF description is not valid (a node is below itself); "
    "export or download the file again."
)
GLTF_SPARSE = (
    "{0}: its glTF description is not valid (sparse accessors are not read); "
    "export or download the file again."
)
GLTF_ACCESSOR = (
    "{0}: its glTF description is not valid (accessor {1} asks for more data than there are); "
    "export or download the file again."
)
NOT_GLTF = "{0}: its glTF description is not valid; export or download the file again."
SENTENCES = (
    NO_FILE, FOLDER, NO_PERMISSION, UNREADABLE, BAD_NAME, EMPTY, NO_VERTICES, ONE_VERTEX,
    ONLY_VERTICES, SMALL_FACE, SMALL_FACES, NO_SUCH_VERTEX, VERTEX_NOT_FINITE,
    VERTICES_NOT_FINITE, NOT_OBJ, NOT_STL, STL_CUT_OFF, STL_NUMBERS, STL_FACET_CUT_OFF, NOT_PLY,
    PLY_HEADER, PLY_NUMBERS, PLY_NO_XYZ, PLY_NO_CORNERS, PLY_CUT_OFF, NOT_GLB, GLTF_COMPRESSED,
    GLTF_PART, GLTF_CUT_OFF, GLTF_DAMAGED_LINE, GLTF_DAMAGED, GLTF_LACKS, GLTF_VERSION,
    GLTF_CIRCLE, GLTF_SPARSE, GLTF_ACCESSOR, NOT_GLTF,
)  # fmt: skip
"""Every sentence of a `SceneError` about a file, for translators."""


class Refusal(ValueError):
    """One sentence that names what was refused, what is wrong with it, and what to do.

    Parameters
    ----------
    template : str
        The sentence, with ``{0}``, ``{1}`` for its parts, so that it can be translated before
        they are filled in. One of the room's `SENTENCES`.
    *parts : object
        The parts themselves: names and numbers.
    """

    def __init__(self, template: str, *parts: object) -> None:
        super().__init__(template, *parts)
        self.template, self.parts = template, parts

    def __str__(self) -> str:
        return self.sentence()

    def sentence(self, translate: Callable[[str], str] = str) -> str:
        """The sentence.

        Parameters
        ----------
        translate : callable
            Turns one of `SENTENCES` into another language.
        """
        return translate(self.template).format(*self.parts)


class SceneError(Refusal):
    """A scene or a mesh file that cannot be shown."""


class SceneCancelled(Exception):
    """The progress callback of `load` answered False."""


@dataclass(eq=False)
class Mesh:
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


def read(path: Path, progress: Progress | None = None) -> Mesh:
    """Read a mesh file.

    Parameters
    ----------
    path : Path
        A file with one of `ENDINGS`.
    progress : callable, optional
        Called now and then with the fraction done, from 0 to 1, on the caller's thread; when it
        returns False, reading stops.

    Returns
    -------
    Mesh
        With at least one face, each of three corners or more, and no vertex that is in none.

    Raises
    ------
    SceneError
        For a file that cannot be read or holds no surface.
    SceneCancelled
        When `progress` returned False.
    """
    check_readable(path)
    report(progress, 0.0)
    mesh = _READERS[path.suffix.lower()](path, progress)
    _check_mesh(path, mesh)
    _drop_unused_points(mesh)
    return mesh


def report(progress: Progress | None, fraction: float) -> None:
    if progress is not None and not progress(fraction):
        raise SceneCancelled


def check_readable(path: Path) -> None:
    """Open the file once ourselves: what VTK says of a file it cannot open names no cause."""
    try:
        str(path).encode()  # VTK takes names as UTF-8
        with path.open("rb") as file:
            empty = not file.read(1)
    except FileNotFoundError:
        raise SceneError(NO_FILE, path) from None
    except IsADirectoryError:
        raise SceneError(FOLDER, path) from None
    except PermissionError:
        raise SceneError(NO_PERMISSION, path) from None
    except OSError as error:
        raise SceneError(UNREADABLE, path, error.strerror) from None
    except ValueError:  # a zero byte, or a name that is not Unicode
        raise SceneError(BAD_NAME, repr(str(path))) from None
    if empty:
        raise SceneError(EMPTY, path)


def _check_mesh(path: Path, mesh: Mesh) -> None:
    faces = len(mesh.offsets) - 1
    vertices = len(mesh.points)
    if faces < 1:
        few = {0: NO_VERTICES, 1: ONE_VERTEX}
        raise SceneError(few.get(vertices, ONLY_VERTICES), path, vertices)
    too_small = int(np.count_nonzero(np.diff(mesh.offsets) < 3))
    if too_small:
        raise SceneError(SMALL_FACE if too_small == 1 else SMALL_FACES, path, too_small, faces)
    if mesh.corners.min() < 0 or mesh.corners.max() >= vertices:
        raise SceneError(NO_SUCH_VERTEX, path, vertices)
    not_finite = int(np.count_nonzero(~np.isfinite(mesh.points).all(axis=1)))
    if not_finite:
        template = VERTEX_NOT_FINITE if not_finite == 1 else VERTICES_NOT_FINITE
        raise SceneError(template, path, not_finite, vertices)


def _drop_unused_points(mesh: Mesh) -> None:
    """Vertices of no face are not drawn, and must not move the camera away from those that are."""
    used = np.zeros(len(mesh.points), dtype=bool)
    used[mesh.corners] = True
    if not used.all():
        mesh.corners = (np.cumsum(used) - 1)[mesh.corners]
        mesh.points = mesh.points[used]


def merge_points(points: Floats) -> tuple[Floats, Ints]:
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


def values_of(array: vtkDataArray) -> NDArray[Any]:
    return np.asarray(vtk_to_numpy(array))  # type: ignore[no-untyped-call]


def cells_of(cells: vtkCellArray) -> tuple[Ints, Ints]:
    """Offsets and corners of a VTK cell array."""
    cells.ConvertTo64BitStorage()
    offsets = values_of(cells.GetOffsetsArray())
    corners = values_of(cells.GetConnectivityArray())
    return offsets.astype(np.int64), corners.astype(np.int64)


def _bytes(colours: NDArray[np.floating]) -> Colours:
    rgb: Colours = np.clip(np.rint(np.nan_to_num(colours)), 0, 255).astype(np.uint8)
    return rgb


def _paint_with_vertex_colours(mesh: Mesh, colours: NDArray[np.floating]) -> None:
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


def _read_obj(path: Path, progress: Progress | None) -> Mesh:
    reader = vtkOBJReader()
    reader.SetFileName(str(path))
    with _vtk_messages() as window:
        reader.Update()
    message = re.search(r"ERROR: .*\n.*?\): (.+)", window.GetOutput())  # the first is the cause
    if message is not None:
        raise SceneError(NOT_OBJ, path, message[1].strip().rstrip("."))
    poly_data = reader.GetOutput()
    if poly_data.GetPoints() is None:
        points = np.empty((0, 3))
    else:
        points = values_of(poly_data.GetPoints().GetData()).astype(np.float64)
    mesh = Mesh(points, *cells_of(poly_data.GetPolys()))
    colours = poly_data.GetPointData().GetArray("RGB")
    if colours is not None:
        _paint_with_vertex_colours(mesh, values_of(colours).astype(np.float64))
    return mesh


_STL_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def _read_stl(path: Path, progress: Progress | None) -> Mesh:
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
            raise SceneError(NOT_STL, path)
        elif length < binary_length:
            there = (length - 84) // _STL_TRIANGLE.itemsize
            raise SceneError(STL_CUT_OFF, path, there, count)
        else:  # some programs append data of their own
            corners = _stl_binary(file, count)
    report(progress, 0.4)
    offsets = np.arange(0, len(corners) + 1, 3)
    if len(corners) == 0 or not np.isfinite(corners).all():
        return Mesh(corners, offsets, np.arange(len(corners)))
    points, merged = merge_points(corners)
    return Mesh(points, offsets, merged)


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
            raise SceneError(STL_NUMBERS, path)
        blocks.append(numbers)
        report(progress, 0.4 * file.tell() / length)
    if b"vertex" in _without_stl_names(rest):
        raise SceneError(STL_FACET_CUT_OFF, path)
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


def _read_ply(path: Path, progress: Progress | None) -> Mesh:
    elements, body = _ply_header_and_body(path)
    report(progress, 0.2)
    mesh = Mesh(np.empty((0, 3)), np.zeros(1, dtype=np.int64), np.empty(0, dtype=np.int64))
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
                raise SceneError(PLY_NO_XYZ, path) from None
            mesh.points = np.stack(xyz, axis=1).astype(np.float64)
            vertex_rgb = rgb
        elif element == "face":
            name = next((n for n in ("vertex_indices", "vertex_index") if n in lengths), None)
            if name is None:
                raise SceneError(PLY_NO_CORNERS, path)
            mesh.offsets = np.concatenate([[0], np.cumsum(lengths[name])])
            with np.errstate(invalid="ignore"):  # what is no index, is out of range too
                mesh.corners = columns[name].astype(np.int64)
            if len(rgb) == 3:
                mesh.rgb = _bytes(np.stack(rgb, axis=1))
                mesh.painted = True
        report(progress, 0.4)
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
        raise SceneError(NOT_PLY, path)
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
        raise SceneError(PLY_HEADER, path) from None
    needed = 1 + max(names.index(name) for name in ("vertex", "face") if name in names)
    body = data[header.end() :]
    if encoding == "ascii":
        numbers = _numbers(body)
        if numbers is None:
            raise SceneError(PLY_NUMBERS, path)
        body = numbers.tobytes()
    return elements[:needed], body


def _ply_columns(
    path: Path, element: str, rows: int, properties: list[_PlyProperty], body: bytes, at: int
) -> tuple[dict[str, NDArray[Any]], dict[str, Ints], int]:
    """Columns of one element, the lengths of its lists (whose items are joined), and its end."""
    lists = [p for p in properties if p.count is not None]
    cut_off = SceneError(PLY_CUT_OFF, path, rows, element)
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


def _read_gltf(path: Path, progress: Progress | None) -> Mesh:
    data = path.read_bytes()
    body = b""
    if path.suffix.lower() == ".glb":
        if data[:4] != b"glTF":
            raise SceneError(NOT_GLB, path)
        text_end = 20 + int.from_bytes(data[12:16], "little")
        data, body = data[20:text_end], data[text_end + 8 :]
    meshes = []
    try:
        content = _gltf_content(path, data)
        version = str(content["asset"]["version"])
        if not version.startswith("2."):
            raise SceneError(GLTF_VERSION, path, version.replace("\n", " "))
        packed = _GLTF_PACKED.intersection(content.get("extensionsRequired", ()))
        if packed:
            raise SceneError(GLTF_COMPRESSED, path, ", ".join(sorted(packed)))
        buffers = [_gltf_buffer(path, buffer, body) for buffer in content.get("buffers", ())]
        report(progress, 0.2)
        for node, world_from_node in _gltf_nodes(path, content):
            if "mesh" in node:
                for primitive in content["meshes"][node["mesh"]]["primitives"]:
                    meshes.append(
                        _gltf_primitive(path, content, buffers, primitive, world_from_node)
                    )
                    report(progress, 0.3)
    except SceneError:
        raise
    except (LookupError, AttributeError, TypeError, ValueError, RecursionError) as error:
        lacking = str(error.args[0]) if isinstance(error, KeyError) else ""
        if lacking.isidentifier():  # a name of the format's, not one made up by the file
            raise SceneError(GLTF_LACKS, path, lacking) from None
        raise SceneError(NOT_GLTF, path) from None
    first_point = np.cumsum([0] + [len(mesh.points) for mesh in meshes])
    corners = [m.corners + at for m, at in zip(meshes, first_point[:-1], strict=True)]
    joined = np.concatenate([np.empty(0, dtype=np.int64), *corners])
    return Mesh(
        np.concatenate([np.empty((0, 3))] + [mesh.points for mesh in meshes]),
        np.arange(0, len(joined) + 1, 3),
        joined,
        np.concatenate(
            [np.empty((0, 3), dtype=np.uint8)]
            + [mesh.rgb for mesh in meshes if mesh.rgb is not None]
        ),
        painted=all(mesh.painted for mesh in meshes),
    )


def _gltf_content(path: Path, text: bytes) -> Any:
    try:
        return json.loads(text)
    except json.JSONDecodeError as error:
        if path.suffix.lower() == ".glb":  # nobody counts lines between bytes
            raise SceneError(GLTF_DAMAGED, path) from None
        raise SceneError(GLTF_DAMAGED_LINE, path, error.lineno) from None
    except (UnicodeDecodeError, RecursionError):
        raise SceneError(GLTF_DAMAGED, path) from None


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
            raise SceneError(GLTF_PART, path, part, error.strerror) from None
    if len(data) < buffer["byteLength"]:
        raise SceneError(GLTF_CUT_OFF, path, len(data), buffer["byteLength"])
    return data


def _gltf_nodes(path: Path, content: dict[str, Any]) -> Iterator[tuple[dict[str, Any], Floats]]:
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
            raise SceneError(GLTF_CIRCLE, path)
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
    path: Path,
    content: dict[str, Any],
    buffers: list[bytes],
    primitive: dict[str, Any],
    world_from_node: Floats,
) -> Mesh:
    """The triangles of a primitive; none where it is of points or lines."""
    attributes = primitive["attributes"]
    local = _gltf_values(path, content, buffers, attributes["POSITION"])
    with np.errstate(invalid="ignore", over="ignore"):  # `_check_mesh` says so in words
        points = local.astype(np.float64) @ world_from_node[:3, :3].T + world_from_node[:3, 3]
    if "indices" in primitive:
        indices = _gltf_values(path, content, buffers, primitive["indices"])
        order = indices.ravel().astype(np.int64)
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
    mesh = Mesh(points, np.arange(0, triangles.size + 1, 3), triangles.ravel())
    if "COLOR_0" in attributes:
        linear = _gltf_values(path, content, buffers, attributes["COLOR_0"])[:, :3]
        scale = _full_scale(linear.dtype)
        _paint_with_vertex_colours(mesh, _srgb(linear.astype(np.float64) / scale))
    if mesh.rgb is None:
        material = content["materials"][primitive["material"]] if "material" in primitive else {}
        factor = material.get("pbrMetallicRoughness", {}).get("baseColorFactor", (1, 1, 1))[:3]
        white = tuple(factor) == (1, 1, 1)  # what a mesh without colours, or with a texture, has
        rgb = PAINT_RGB if white else _bytes(_srgb(np.array(factor, dtype=np.float64)))
        mesh.rgb = np.tile(np.array(rgb, dtype=np.uint8), (len(triangles), 1))
    return mesh


def _gltf_values(
    path: Path, content: dict[str, Any], buffers: list[bytes], index: int
) -> NDArray[Any]:
    """The values of an accessor, one row for each element."""
    accessor = content["accessors"][index]
    if "sparse" in accessor or "bufferView" not in accessor:
        raise SceneError(GLTF_SPARSE, path)
    view = content["bufferViews"][accessor["bufferView"]]
    first = view.get("byteOffset", 0)
    data = memoryview(buffers[view["buffer"]])[first : first + view["byteLength"]]
    if accessor["componentType"] not in _GLTF_TYPES or accessor["type"] not in _GLTF_PARTS:
        raise SceneError(NOT_GLTF, path)
    kind = np.dtype(_GLTF_TYPES[accessor["componentType"]])
    parts, count = _GLTF_PARTS[accessor["type"]], accessor["count"]
    stride = view.get("byteStride", kind.itemsize * parts)
    start = accessor.get("byteOffset", 0)
    end = start + (count - 1) * stride + kind.itemsize * parts
    if count < 1 or start < 0 or stride < 1 or end > len(data):
        raise SceneError(GLTF_ACCESSOR, path, index)
    return np.ndarray((count, parts), kind, data, start, (stride, kind.itemsize))


def _srgb(linear: Floats) -> Floats:
    """Linear light from 0 to 1, which glTF stores, as sRGB from 0 to 255."""
    linear = np.clip(linear, 0.0, 1.0)
    return 255.0 * np.where(
        linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055
    )


_READERS: dict[str, Callable[[Path, Progress | None], Mesh]] = {
    ".obj": _read_obj,
    ".stl": _read_stl,
    ".ply": _read_ply,
    ".gltf": _read_gltf,
    ".glb": _read_gltf,
}
ENDINGS = tuple(_READERS)
"""Endings of the mesh files that `load` reads."""
