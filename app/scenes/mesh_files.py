"""Meshes out of the user's files: OBJ, STL, PLY and glTF, in float64, or one sentence why not.

This room knows the formats and what can be wrong with a file. It gives points and polygons;
what they look like, and from where, is `app.scenes.scene`'s. A mesh file is a stranger's: what it
claims is checked against what is there, and what it would grow to against `LARGEST`, before memory
is taken. Python and numpy alone read it, which cannot run past the end of an array.

`docs/meshes.md` has the figures by which no library reads them: not one keeps the time and
the places of every format.
"""

from __future__ import annotations

import base64
import json
import math
import os
import re
import warnings
from array import array
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path, PurePath, PureWindowsPath
from typing import Any, BinaryIO, TypeAlias, TypeVar
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from app.model.refusal import QT_TRANSLATE_NOOP, Cancelled, Refusal
from app.strangers import LARGEST_FILE, open_regular

Floats: TypeAlias = NDArray[np.float64]
Ints: TypeAlias = NDArray[np.int64]
Colours: TypeAlias = NDArray[np.uint8]
_Real = TypeVar("_Real", bound=np.floating)
Progress: TypeAlias = Callable[[float], bool]

LARGEST = 20_000_000, 2 * 2**30
"""Most triangles of a mesh, and most bytes that they and their vertices may take."""
MOST_REPEATED = 25_000
"""Most triangles of a file with fewer bytes than triangles, which repeats its parts."""
MOST_CORNERS = 1000
"""Of a face: to divide it into triangles takes time with their square."""
PAINT_RGB = (184, 194, 208)
"""Colour of a surface that brings none."""

# What can be wrong with a file: whole sentences, so that they can be translated.
NO_FILE = QT_TRANSLATE_NOOP("Refusal", "{0}: there is no such file; check its name and folder.")
FOLDER = QT_TRANSLATE_NOOP("Refusal", "{0}: this is a folder; choose a mesh file inside it.")
NO_PERMISSION = QT_TRANSLATE_NOOP(
    "Refusal", "{0}: no permission to read it; change its permissions."
)
UNREADABLE = QT_TRANSLATE_NOOP("Refusal", "{0}: cannot be read ({1}).")
BAD_NAME = QT_TRANSLATE_NOOP("Refusal", "{0}: not a possible file name; rename the file.")
EMPTY = QT_TRANSLATE_NOOP("Refusal", "{0}: the file is empty; save or download it again.")
NO_VERTICES = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: the file holds no faces (and no vertices), so that there is no surface to draw; "
    "export the mesh with faces.",
)
ONE_VERTEX = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: the file holds no faces (one vertex), so that there is no surface to draw; "
    "export the mesh with faces.",
)
ONLY_VERTICES = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: the file holds no faces ({1} vertices), so that there is no surface to draw; "
    "export the mesh with faces.",
)
SMALL_FACE = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: {1} face of {2} has fewer than three corners; "
    "the file is damaged or cut off, save or download it again.",
)
SMALL_FACES = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: {1} faces of {2} have fewer than three corners; "
    "the file is damaged or cut off, save or download it again.",
)
LARGE_FACE = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: a face has {1} corners, and at most {2} are drawn; divide it into triangles.",
)
NO_SUCH_VERTEX = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: a face names a vertex that does not exist (there are {1}); "
    "the file is damaged or cut off, save or download it again.",
)
VERTEX_NOT_FINITE = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: {1} vertex of {2} is not finite (nan or inf); repair the mesh and export it again.",
)
VERTICES_NOT_FINITE = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: {1} vertices of {2} are not finite (nan or inf); repair the mesh and export it again.",
)
TOO_MUCH = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: it would grow to {1} triangles and {2} MiB, and at most {3} triangles and {4} MiB "
    "are shown; make it smaller.",
)
REPEATED = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: it repeats {1} bytes until they are {2} triangles, and at most {3} are shown of so few "
    "bytes; remove copies.",
)
NO_MEMORY = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: there is not enough memory to read it; make it smaller, or close other programs.",
)
FAILED = QT_TRANSLATE_NOOP(
    "Refusal", "{0}: it cannot be read ({1}); export or download the file again."
)
NOT_OBJ = QT_TRANSLATE_NOOP(
    "Refusal", "{0}: line {1} cannot be read as OBJ; export or download the file again."
)
NOT_STL = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: this is not an STL file, neither text (which begins with “solid”) nor binary; "
    "check what kind of file it is.",
)
STL_CUT_OFF = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: the file is cut off after {1} of {2} triangles; export or download the file again.",
)
STL_NUMBERS = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: a facet has not three vertices of three numbers; export or download the file again.",
)
STL_FACET_CUT_OFF = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: the file is cut off in the middle of a facet; export or download the file again.",
)
NOT_PLY = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: this is not a PLY file, which begins with “ply” and has a line “end_header”; "
    "check what kind of file it is.",
)
PLY_HEADER = QT_TRANSLATE_NOOP(
    "Refusal", "{0}: its PLY header does not describe a mesh; export or download the file again."
)
PLY_NUMBERS = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: there is something between its numbers that is not a number; "
    "export or download the file again.",
)
PLY_NO_XYZ = QT_TRANSLATE_NOOP(
    "Refusal", "{0}: its vertices have no x, y, z; export or download the file again."
)
PLY_NO_CORNERS = QT_TRANSLATE_NOOP(
    "Refusal", "{0}: its faces have no list vertex_indices; export or download the file again."
)
PLY_CUT_OFF = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: the file is cut off before the last of its {1} {2} rows; "
    "export or download the file again.",
)
NOT_GLB = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: this is not a GLB file, which begins with “glTF”; check what kind of file it is.",
)
GLTF_COMPRESSED = QT_TRANSLATE_NOOP(
    "Refusal", "{0}: its mesh is compressed ({1}); export it without compression."
)
GLTF_PART = QT_TRANSLATE_NOOP(
    "Refusal", "{0}: its part {1} cannot be read ({2}); keep the files of a glTF mesh together."
)
GLTF_OUTSIDE = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: its part {1} is not a file in the folder of the mesh, and nothing else is read; "
    "keep the files of a glTF mesh together.",
)
GLTF_CUT_OFF = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: the file is cut off after {1} of {2} bytes of data; export or download the file again.",
)
GLTF_DAMAGED_LINE = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: its JSON part, which describes the mesh, is damaged in line {1}; "
    "export or download the file again.",
)
GLTF_DAMAGED = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: its JSON part, which describes the mesh, is damaged; export or download the file again.",
)
GLTF_BRACKETS = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: its JSON part, which describes the mesh, has more than {1} lists and objects; "
    "export it in fewer parts.",
)
GLTF_LACKS = QT_TRANSLATE_NOOP(
    "Refusal", "{0}: its glTF description lacks “{1}”; export or download the file again."
)
GLTF_VERSION = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: its glTF description is not valid (version {1}, not 2); "
    "export or download the file again.",
)
GLTF_CIRCLE = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: its glTF description is not valid (a node is below itself); "
    "export or download the file again.",
)
GLTF_SPARSE = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: its glTF description is not valid (sparse accessors are not read); "
    "export or download the file again.",
)
GLTF_ACCESSOR = QT_TRANSLATE_NOOP(
    "Refusal",
    "{0}: its glTF description is not valid (accessor {1} asks for more data than there are); "
    "export or download the file again.",
)
NOT_GLTF = QT_TRANSLATE_NOOP(
    "Refusal", "{0}: its glTF description is not valid; export or download the file again."
)


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


def read(path: Path, progress: Progress | None = None, largest: tuple[int, int] = LARGEST) -> Mesh:
    """Read a mesh file.

    Parameters
    ----------
    path : Path
        A file with one of `ENDINGS`.
    progress : callable, optional
        Called now and then with the fraction done, from 0 to 1, on the caller's thread; when it
        returns False, reading stops.
    largest : tuple of 2 ints
        Most triangles of the mesh, and most bytes that they and their vertices may take.

    Returns
    -------
    Mesh
        With at least one face, each of three corners or more, and no vertex that is in none.

    Raises
    ------
    Refusal
        For a file that cannot be read or holds no surface.
    Cancelled
        When `progress` returned False.
    """
    with open_mesh(path) as file:
        report(progress, 0.0)
        try:
            with np.errstate(all="ignore"):  # `_check_mesh` says in words what is not finite
                mesh = _READERS[path.suffix.lower()](_Source(path, file, progress, largest))
            _check_mesh(path, mesh)
        except MemoryError:
            raise Refusal.saying(NO_MEMORY, path) from None
        except (Refusal, Cancelled):
            raise
        except Exception as error:  # whatever a reader did not foresee, of a file that anyone made
            raise Refusal.saying(FAILED, path, type(error).__name__) from error
    _drop_unused_points(mesh)
    return mesh


def report(progress: Progress | None, fraction: float) -> None:
    if progress is not None and not progress(fraction):
        raise Cancelled


def open_mesh(path: Path) -> BinaryIO:
    """Open a file that is not empty, or say why it cannot be read."""
    try:
        file = open_regular(path)
    except FileNotFoundError:
        raise Refusal.saying(NO_FILE, path) from None
    except IsADirectoryError:
        raise Refusal.saying(FOLDER, path) from None
    except PermissionError:
        raise Refusal.saying(NO_PERMISSION, path) from None
    except OSError as error:
        raise Refusal.saying(UNREADABLE, path, error.strerror) from None
    except ValueError:  # a zero byte, or a name that no file of this system can have
        raise Refusal.saying(BAD_NAME, repr(str(path))) from None
    if os.fstat(file.fileno()).st_size == 0:
        file.close()
        raise Refusal.saying(EMPTY, path)
    return file


@dataclass(frozen=True)
class _Source:
    """A file that is being read."""

    path: Path
    file: BinaryIO
    progress: Progress | None
    largest: tuple[int, int]

    @property
    def size(self) -> int:
        return os.fstat(self.file.fileno()).st_size

    def report(self, fraction: float) -> None:
        report(self.progress, fraction)

    def check_size(self, vertices: int, faces: int, corners: int) -> None:
        """Refuse what would grow too large, by its counts: before memory is taken."""
        triangles = max(faces, corners - 2 * faces)
        # What a mesh takes, and while its parts are joined once more.
        needed = 2 * (24 * vertices + 8 * corners) + (8 + 8) * faces
        if triangles > self.largest[0] or needed > self.largest[1]:
            sizes = triangles, needed >> 20, self.largest[0], self.largest[1] >> 20
            raise Refusal.saying(TOO_MUCH, self.path, *sizes)


def _check_mesh(path: Path, mesh: Mesh) -> None:
    faces = len(mesh.offsets) - 1
    vertices = len(mesh.points)
    if faces < 1:
        few = {0: NO_VERTICES, 1: ONE_VERTEX}
        raise Refusal.saying(few.get(vertices, ONLY_VERTICES), path, vertices)
    too_small = int(np.count_nonzero(np.diff(mesh.offsets) < 3))
    if too_small:
        raise Refusal.saying(SMALL_FACE if too_small == 1 else SMALL_FACES, path, too_small, faces)
    largest = int(np.diff(mesh.offsets).max())
    if largest > MOST_CORNERS:
        raise Refusal.saying(LARGE_FACE, path, largest, MOST_CORNERS)
    if mesh.corners.min() < 0 or mesh.corners.max() >= vertices:
        raise Refusal.saying(NO_SUCH_VERTEX, path, vertices)
    not_finite = int(np.count_nonzero(~np.isfinite(mesh.points).all(axis=1)))
    if not_finite:
        template = VERTEX_NOT_FINITE if not_finite == 1 else VERTICES_NOT_FINITE
        raise Refusal.saying(template, path, not_finite, vertices)


def _drop_unused_points(mesh: Mesh) -> None:
    """Vertices of no face are not drawn, and must not move the camera away from those that are."""
    used = np.zeros(len(mesh.points), dtype=bool)
    used[mesh.corners] = True
    if not used.all():
        mesh.corners = (np.cumsum(used) - 1)[mesh.corners]
        mesh.points = mesh.points[used]


def merge_points(points: NDArray[_Real]) -> tuple[NDArray[_Real], Ints]:
    """Points at exactly the same place become one: (distinct points, index of each in them).

    Sorted by a hash of their bits, and compared afterwards, which takes a fifth of the time of
    numpy's own sorting by rows.
    """
    bits = np.ascontiguousarray(points + 0.0, dtype=np.float64).view(np.uint64).reshape(-1, 3)
    keys = np.zeros(len(bits), dtype=np.uint64)
    for axis in range(3):
        keys = (keys ^ (keys >> np.uint64(32))) + bits[:, axis]
        keys *= np.uint64(0xD6E8FEB86659FD93)  # odd, so that no two numbers become one
    keys ^= keys >> np.uint64(32)
    order = np.argsort(keys, kind="stable")
    first = np.append(True, np.diff(keys[order]) != 0)[: len(order)]
    number = np.cumsum(first) - 1
    # In the order of the file, in which what is near is near in memory.
    kept = order[first]
    rank = np.empty(len(kept), dtype=np.int64)
    rank[np.argsort(kept)] = np.arange(len(kept))
    merged = np.empty(len(order), dtype=np.int64)
    merged[order] = rank[number]
    distinct = points[np.sort(kept)]
    if not (distinct[merged] == points).all():  # two places with one key
        distinct, merged = np.unique(points + 0.0, axis=0, return_inverse=True)
        merged = merged.ravel()
    return distinct, merged


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


BLOCK = 1 << 24
"""Bytes of a text that are looked at together: progress is shown, and cancel asked, after each."""


def _read_obj(source: _Source) -> Mesh:
    """Faces of any number of corners, whose vertices alone are read, in whatever order they come.

    The lines of a block are told apart by their first letters, all at once; what is neither a
    vertex nor a face (normals, textures, materials, groups, lines) is passed over.
    """
    points, colours, corners, counts = [], [], [], []
    vertices = faces = cornered = lines_before = 0
    for text in _obj_blocks(source.file):
        lines = _Lines(np.frombuffer(text, dtype=np.uint8))
        is_vertex, is_face = lines.begin_with(b"v"), lines.begin_with(b"f")
        rows, line = _obj_vertices(lines, is_vertex)
        indices, sizes, face_line = _obj_faces(lines, is_face)
        wrong = min((n for n in (line, face_line) if n is not None), default=None)
        if wrong is not None:
            raise Refusal.saying(NOT_OBJ, source.path, lines_before + wrong + 1)
        if (indices < 0).any():  # counted back from the vertices so far
            so_far = vertices + np.cumsum(is_vertex)[is_face]
            indices = np.where(indices < 0, np.repeat(so_far, sizes) + indices, indices - 1)
        else:
            indices -= 1
        vertices, faces, cornered = (
            vertices + len(rows),
            faces + len(sizes),
            cornered + len(indices),
        )
        source.check_size(vertices, faces, cornered)
        points.append(rows[:, :3])
        colours.append(rows[:, 3:6])
        corners.append(indices)
        counts.append(sizes)
        lines_before += len(is_vertex)
        source.report(min(0.4, 0.4 * source.file.tell() / source.size))
    rgb = [block for block in colours if len(block)]
    mesh = Mesh(
        np.concatenate([np.empty((0, 3)), *points]),
        np.cumsum(np.concatenate([[0], *counts]), dtype=np.int64),
        np.concatenate([np.empty(0, dtype=np.int64), *corners]),
    )
    if rgb and all(block.shape[1] == 3 for block in rgb):
        _paint_with_vertex_colours(mesh, 255.0 * np.concatenate(rgb))
    return mesh


def _obj_blocks(file: BinaryIO) -> Iterator[bytes]:
    """The text in whole lines, each with its end, without comments and what ends it otherwise."""
    rest = b""
    while True:
        block = file.read(BLOCK)
        text = rest + block
        end = text.rfind(b"\n") + 1
        while block and text[max(0, end - 3) : end].rstrip(b"\r\n")[-1:] == b"\\":
            end = text.rfind(b"\n", 0, end - 1) + 1  # the line goes on in the next one
        text, rest = (text[:end], text[end:]) if block else (text + b"\n", b"")
        if b"\r" in text:
            text = text.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
        if b"\\\n" in text:
            text = text.replace(b"\\\n", b" ")
        if b"#" in text:
            text = re.sub(rb"#[^\n]*", b"", text)
        if text[:1] in b" \t" or b"\n " in text or b"\n\t" in text:
            text = re.sub(rb"^[ \t]+", b"", text, flags=re.MULTILINE)
        yield text
        if not block:
            return


class _Lines:
    """The lines of a text (n,) uint8 that ends with a line's end."""

    def __init__(self, text: NDArray[np.uint8]) -> None:
        self.text = text
        self.ends = np.flatnonzero(text == 10) + 1
        self.begins = np.concatenate([[0], self.ends[:-1]])[: len(self.ends)]

    def begin_with(self, word: bytes) -> NDArray[np.bool_]:
        """Which lines have this letter alone as their first word."""
        second = self.text[np.minimum(self.begins + 1, len(self.text) - 1)]
        which: NDArray[np.bool_] = self.text[self.begins] == word[0]
        which &= (second == 32) | (second == 9)
        return which

    def chosen(self, which: NDArray[np.bool_], mark: int) -> NDArray[np.uint8]:
        """Some lines, one after the other, a mark in the place of their first letters."""
        text = self.text.copy()
        begins, ends = self.begins[which], self.ends[which]
        text[begins] = mark
        if len(begins) and (begins[1:] == ends[:-1]).all():
            together: NDArray[np.uint8] = text[begins[0] : ends[-1]]
            return together
        step = np.zeros(len(text) + 1, dtype=np.int8)
        step[begins] += 1
        step[ends] -= 1
        apart: NDArray[np.uint8] = text[np.cumsum(step[:-1], dtype=np.int8).astype(bool)]
        return apart


def _obj_vertices(lines: _Lines, which: NDArray[np.bool_]) -> tuple[Floats, int | None]:
    """Three numbers or, with colours, six of each vertex; and the first line that has not three."""
    count = int(np.count_nonzero(which))
    if count == 0:
        return np.empty((0, 6)), None
    text = lines.chosen(which, ord("9")).tobytes()
    numbers = _numbers(text)
    if numbers is not None and len(numbers) % count == 0:
        table = numbers.reshape(count, -1)
        # A 9 leads every row, unless the lines are not of the same length.
        if table.shape[1] > 3 and (table[:, 0] == 9.0).all():
            return table[:, 1 : 7 if table.shape[1] > 6 else 4], None
    rows = []
    for line, row in zip(np.flatnonzero(which).tolist(), text.splitlines(), strict=True):
        values = _numbers(row)
        if values is None or len(values) < 4:
            return np.empty((0, 6)), line
        rows.append(values[1:4])
    return np.array(rows), None


def _obj_faces(lines: _Lines, which: NDArray[np.bool_]) -> tuple[Ints, Ints, int | None]:
    """First numbers of all corners, how many each face has; and the first line that is none."""
    text = lines.chosen(which, ord(" "))
    if len(text) == 0:
        return np.empty(0, dtype=np.int64), np.empty(0, dtype=np.int64), None
    blank = text <= 32
    begins_word = ~blank
    begins_word[1:] &= blank[:-1]
    ends = np.flatnonzero(text == 10)
    sizes = np.diff(np.searchsorted(np.flatnonzero(begins_word), ends), prepend=0)
    slash = text == ord("/")
    if slash.any():  # 1/2/3, 1//3, 1/2/ and 1// are corner 1
        edges = np.flatnonzero(slash | blank)
        text[edges[0] :][np.repeat(slash[edges], np.diff(edges, append=len(text)))] = 32
    indices = _numbers(text.tobytes(), np.int64)
    if indices is not None and len(indices) == sizes.sum():
        return indices, sizes, None
    rows = zip(np.flatnonzero(which).tolist(), text.tobytes().splitlines(), sizes, strict=True)
    for line, row, size in rows:
        values = _numbers(row, np.int64)
        if values is None or len(values) != size:
            return np.empty(0, dtype=np.int64), sizes, line
    raise AssertionError("the lines are sound one by one")


_STL_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def _read_stl(source: _Source) -> Mesh:
    head, length = source.file.read(4096), source.size
    count = int.from_bytes(head[80:84], "little")
    binary_length = 84 + _STL_TRIANGLE.itemsize * count
    # Many binary files begin with "solid" like the text ones: the length decides first.
    if len(head) >= 84 and length == binary_length:
        corners = _stl_binary(source, count)
    elif head.lstrip()[:5].lower() == b"solid":
        corners = _stl_text(source)
    elif len(head) < 84 or b"\0" not in head:
        raise Refusal.saying(NOT_STL, source.path)
    elif length < binary_length:
        there = (length - 84) // _STL_TRIANGLE.itemsize
        raise Refusal.saying(STL_CUT_OFF, source.path, there, count)
    else:  # some programs append data of their own
        corners = _stl_binary(source, count)
    source.report(0.3)
    points, merged = (
        merge_points(corners) if np.isfinite(corners).all() else (corners, np.arange(len(corners)))
    )
    source.report(0.4)
    return Mesh(points, np.arange(0, len(corners) + 1, 3), merged)


def _stl_binary(source: _Source, count: int) -> Floats:
    """Corners (3 m, 3) of the triangles; float32 by definition of the format."""
    source.check_size(3 * count, count, 3 * count)
    source.file.seek(84)
    triangles = np.fromfile(source.file, dtype=_STL_TRIANGLE, count=count)
    return triangles["corners"].reshape(-1, 3).astype(np.float64)


def _stl_text(source: _Source) -> Floats:
    """Corners (3 m, 3) of the triangles, with all the digits of the text."""
    source.file.seek(0)
    rest = b""
    blocks = [np.empty(0)]
    triangles = 0
    while block := source.file.read(BLOCK):
        text = (rest + block).lower()
        end = text.rfind(b"endloop") + len(b"endloop")
        if end < len(b"endloop"):
            rest = text
            continue
        text, rest = text[:end], text[end:]
        text = _without_stl_names(text)
        # "... outer loop vertex x y z vertex x y z vertex x y z endloop ...": the odd pieces.
        between, loops = (text.split(b"loop")[first::2] for first in (0, 1))
        numbers = _numbers(b" ".join(loops).replace(b"vertex", b"").replace(b"end", b""))
        is_damaged = any(b"vertex" in words for words in between)
        if is_damaged or numbers is None or len(numbers) != 9 * len(loops):
            raise Refusal.saying(STL_NUMBERS, source.path)
        triangles += len(loops)
        source.check_size(3 * triangles, triangles, 3 * triangles)
        blocks.append(numbers)
        source.report(min(0.3, 0.3 * source.file.tell() / source.size))
    if b"vertex" in _without_stl_names(rest):
        raise Refusal.saying(STL_FACET_CUT_OFF, source.path)
    return np.concatenate(blocks).reshape(-1, 3)


def _without_stl_names(text: bytes) -> bytes:
    """Text STL without what follows “solid” and “endsolid”, where any word may occur."""
    if b"solid" not in text:
        return text
    return re.sub(rb"solid[^\n]*?(?=facet\s+normal|\n|\Z)", b"", text)


def _numbers(text: bytes, kind: type[np.generic] = np.float64) -> NDArray[Any] | None:
    """The numbers of a text, or None where something else is among them."""
    if not text.strip():
        return np.empty(0, dtype=kind)
    with warnings.catch_warnings():  # numpy says "unmatched data" and answers what it has
        warnings.simplefilter("error", DeprecationWarning)
        try:
            return np.fromstring(text, dtype=kind, sep=" ")
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


def _read_ply(source: _Source) -> Mesh:
    path = source.path
    elements, body = _ply_header_and_body(source)
    source.report(0.2)
    mesh = Mesh(np.empty((0, 3)), np.zeros(1, dtype=np.int64), np.empty(0, dtype=np.int64))
    at = 0
    vertex_rgb = []
    for element, rows, properties in elements:
        columns, lengths, at = _ply_columns(path, element, rows, properties, body, at)
        scale = {p.name: 255.0 / p.full_scale for p in properties if p.count is None}
        rgb = [
            columns[channel].astype(np.float32) * np.float32(scale[channel])
            for channel in ("red", "green", "blue")
            if channel in scale
        ]
        if element == "vertex":
            if not scale.keys() >= {"x", "y", "z"}:
                raise Refusal.saying(PLY_NO_XYZ, path)
            mesh.points = np.stack([columns[axis] for axis in "xyz"], axis=1).astype(np.float64)
            vertex_rgb = rgb
        elif element == "face":
            name = next((n for n in ("vertex_indices", "vertex_index") if n in lengths), None)
            if name is None:
                raise Refusal.saying(PLY_NO_CORNERS, path)
            mesh.offsets = np.concatenate([[0], np.cumsum(lengths[name])])
            mesh.corners = columns[name].astype(np.int64)  # what is no index, is out of range too
            source.check_size(len(mesh.points), rows, len(mesh.corners))
            if len(rgb) == 3:
                mesh.rgb = _bytes(np.stack(rgb, axis=1))
                mesh.painted = True
        source.report(0.4)
    if mesh.rgb is None and len(vertex_rgb) == 3:
        _paint_with_vertex_colours(mesh, np.stack(vertex_rgb, axis=1))
    return mesh


def _ply_header_and_body(
    source: _Source,
) -> tuple[list[tuple[str, int, list[_PlyProperty]]], bytes]:
    """The elements up to the faces, each with its number of rows and columns, and the numbers.

    A text body becomes what a binary one is, with every number a float64.
    """
    path, data = source.path, source.file.read()
    header = re.match(rb"ply\s.*?end_header[^\S\n]*\r?\n?", data[:1_000_000], re.DOTALL)
    if header is None:
        raise Refusal.saying(NOT_PLY, path)
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
        if "vertex" not in names or not encoding or len(set(names)) < len(names):
            raise ValueError
        for _, rows, properties in elements:
            if rows < 0 or (rows and not properties):
                raise ValueError
            if len({p.name for p in properties}) < len(properties):
                raise ValueError
    except (IndexError, KeyError, ValueError, UnboundLocalError):
        raise Refusal.saying(PLY_HEADER, path) from None
    needed = 1 + max(names.index(name) for name in ("vertex", "face") if name in names)
    rows_of = {name: rows for name, rows, _ in elements}
    source.check_size(rows_of["vertex"], rows_of.get("face", 0), 3 * rows_of.get("face", 0))
    body = data[header.end() :]
    if encoding == "ascii":
        numbers = _numbers(body)
        if numbers is None:
            raise Refusal.saying(PLY_NUMBERS, path)
        body = numbers.tobytes()
    return elements[:needed], body


def _ply_columns(
    path: Path, element: str, rows: int, properties: list[_PlyProperty], body: bytes, at: int
) -> tuple[dict[str, NDArray[Any]], dict[str, Ints], int]:
    """Columns of one element, the lengths of its lists (whose items are joined), and its end."""
    lists = [p for p in properties if p.count is not None]
    cut_off = Refusal.saying(PLY_CUT_OFF, path, rows, element)
    if rows == 0:
        empty = {p.name: np.empty(0, dtype=p.kind) for p in properties}
        return empty, {p.name: np.empty(0, dtype=np.int64) for p in lists}, at

    def row_at(start: int) -> tuple[list[int], int]:
        """Where each column's numbers begin in this row and how many they are; the row's end."""
        places = []
        for p in properties:
            length = 1
            if p.count is not None:
                if start + p.count.itemsize > len(body):
                    raise cut_off
                counted = np.frombuffer(body, p.count, 1, start)[0]
                if not 0 <= counted <= len(body):  # so that nan is none either
                    raise cut_off
                length = int(counted)
                start += p.count.itemsize
            places += [start, length]
            start += length * p.kind.itemsize
            if start > len(body):
                raise cut_off
        return places, start

    # As a rule all lists are as long as those of the first row, and the element is a table.
    places, _ = row_at(at)
    fields: list[tuple[Any, ...]] = []
    for p, length in zip(properties, places[1::2], strict=True):
        if p.count is not None:
            fields += [(f"length of {p.name}", p.count), (p.name, p.kind, (length,))]
        else:
            fields.append((p.name, p.kind))
    row = np.dtype(fields)
    end = at + rows * row.itemsize
    if end <= len(body):
        table = np.frombuffer(body, row, rows, at)
        counts = {p.name: table[f"length of {p.name}"] for p in lists}
        if all((count == count[0]).all() for count in counts.values()):
            columns = {p.name: table[p.name].ravel() for p in properties}
            return columns, {name: c.astype(np.int64) for name, c in counts.items()}, end
    least = sum((p.count or p.kind).itemsize for p in properties)
    if not lists or at + rows * least > len(body):
        raise cut_off

    # Otherwise only a walk from row to row finds where each begins.
    found = array("q")
    for _ in range(rows):
        places, at = row_at(at)
        found.extend(places)
    starts, lengths = np.moveaxis(np.array(found).reshape(rows, len(properties), 2), 2, 0)
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
_MOST_BRACKETS = 1_000_000
"""Most lists and objects of a JSON part: a hundred thousand nodes have half as many."""


def _read_gltf(source: _Source) -> Mesh:
    path, data, body = source.path, source.file.read(), b""
    if path.suffix.lower() == ".glb":
        if data[:4] != b"glTF":
            raise Refusal.saying(NOT_GLB, path)
        text_end = 20 + int.from_bytes(data[12:16], "little")
        data, body = data[20:text_end], data[text_end + 8 :]
    try:
        return _gltf_mesh(source, _gltf_content(path, data), body)
    except Refusal:
        raise
    except (LookupError, AttributeError, TypeError, ValueError, ArithmeticError) as error:
        lacking = str(error.args[0]) if isinstance(error, KeyError) else ""
        if lacking.isidentifier():  # a name of the format's, not one made up by the file
            raise Refusal.saying(GLTF_LACKS, path, lacking) from None
        raise Refusal.saying(NOT_GLTF, path) from None


def _gltf_content(path: Path, text: bytes) -> Any:
    if text.count(b"[") + text.count(b"{") > _MOST_BRACKETS:
        raise Refusal.saying(GLTF_BRACKETS, path, _MOST_BRACKETS)
    try:
        return json.loads(text)
    except json.JSONDecodeError as error:
        if path.suffix.lower() == ".glb":  # nobody counts lines between bytes
            raise Refusal.saying(GLTF_DAMAGED, path) from None
        raise Refusal.saying(GLTF_DAMAGED_LINE, path, error.lineno) from None
    except (UnicodeDecodeError, RecursionError):
        raise Refusal.saying(GLTF_DAMAGED, path) from None


def _gltf_mesh(source: _Source, content: dict[str, Any], body: bytes) -> Mesh:
    """All triangles of the scene, each mesh read once, however many nodes have it."""
    version = str(content["asset"]["version"])
    if not version.startswith("2."):
        raise Refusal.saying(GLTF_VERSION, source.path, version)
    packed = _GLTF_PACKED.intersection(content.get("extensionsRequired", ()))
    if packed:
        raise Refusal.saying(GLTF_COMPRESSED, source.path, ", ".join(sorted(packed)))
    nodes = _gltf_nodes(source.path, content)
    sizes = {index: _gltf_size(content, index) for index in {index for index, _ in nodes}}
    vertices, triangles = (sum(sizes[index][part] for index, _ in nodes) for part in (0, 1))
    source.check_size(vertices, triangles, 3 * triangles)
    buffers = _gltf_buffers(source, content.get("buffers", ()), body)
    held = sum(map(len, buffers))
    if triangles > max(held, MOST_REPEATED):
        raise Refusal.saying(REPEATED, source.path, held, triangles, MOST_REPEATED)
    source.report(0.2)
    meshes: dict[int, Mesh] = {}
    parts = []
    for index, world_from_node in nodes:
        if index not in meshes:
            primitives = _item(content, "meshes", index)["primitives"]
            local = [_gltf_primitive(source, content, buffers, p) for p in primitives]
            meshes[index] = _joined(local)
        mesh = meshes[index]
        triangles_of = mesh.corners.reshape(-1, 3)
        if np.linalg.det(world_from_node[:3, :3]) < 0.0:  # a mirror turns faces inside out
            triangles_of = triangles_of[:, ::-1]
        points = mesh.points @ world_from_node[:3, :3].T + world_from_node[:3, 3]
        parts.append(Mesh(points, mesh.offsets, triangles_of.ravel(), mesh.rgb, mesh.painted))
        source.report(0.3)
    return _joined(parts)


def _joined(parts: list[Mesh]) -> Mesh:
    """Meshes of triangles, with colours, as one."""
    first_point = np.cumsum([0] + [len(part.points) for part in parts])
    corners = np.concatenate(
        [np.empty(0, dtype=np.int64)]
        + [part.corners + at for part, at in zip(parts, first_point[:-1], strict=True)]
    )
    return Mesh(
        np.concatenate([np.empty((0, 3))] + [part.points for part in parts]),
        np.arange(0, len(corners) + 1, 3),
        corners,
        np.concatenate([np.empty((0, 3), dtype=np.uint8)]
                       + [part.rgb for part in parts if part.rgb is not None]),
        painted=all(part.painted for part in parts if len(part.corners)),
    )  # fmt: skip


def _item(content: dict[str, Any], kind: str, index: Any) -> Any:
    """One of the description's nodes, meshes and so on; Python would count back from the end."""
    if not isinstance(index, int) or index < 0:
        raise IndexError
    return content[kind][index]


def _gltf_buffers(source: _Source, buffers: Any, body: bytes) -> list[bytes]:
    """The bytes that the description speaks of: its own, or of files in the mesh's folder."""
    found, path, total = [], source.path, 0
    for buffer in buffers:
        address = buffer.get("uri")
        if address is None:
            data = body
        elif address.startswith("data:"):
            data = base64.b64decode(address.partition(",")[2])
        else:
            name = unquote(address)
            part = path.parent / name
            try:
                if not _is_beside(path, name):
                    raise Refusal.saying(GLTF_OUTSIDE, path, name)
                with open_regular(part) as file:
                    total += os.fstat(file.fileno()).st_size
                    if total > LARGEST_FILE:
                        raise Refusal.saying(NO_MEMORY, path)
                    data = file.read()
            except OSError as error:
                raise Refusal.saying(GLTF_PART, path, part, error.strerror) from None
        if len(data) < buffer["byteLength"]:
            raise Refusal.saying(GLTF_CUT_OFF, path, len(data), buffer["byteLength"])
        found.append(data)
    return found


def _is_beside(path: Path, name: str) -> bool:
    """Whether a name leads to a place in a file's own folder, or in one below it."""
    for kind in (PurePath, PureWindowsPath):  # also of a network, which looking would reach for
        pure = kind(name)
        if pure.drive or pure.root or ".." in pure.parts:
            return False
    folder = os.path.realpath(path.parent)
    return os.path.commonpath([folder, os.path.realpath(path.parent / name)]) == folder


def _gltf_nodes(path: Path, content: dict[str, Any]) -> list[tuple[int, Floats]]:
    """The scene's nodes that have a mesh: which one, and their world_from_node (4, 4)."""
    nodes = content.get("nodes", [])
    if content.get("scenes"):
        roots = _item(content, "scenes", content.get("scene", 0)).get("nodes", [])
    else:
        roots = set(range(len(nodes))).difference(*(node.get("children", ()) for node in nodes))
    waiting = [(root, np.eye(4)) for root in roots]
    found = []
    for index, world_from_parent in waiting:  # which grows meanwhile
        node = _item(content, "nodes", index)
        world_from_node = world_from_parent @ _gltf_transform(node)
        if "mesh" in node:
            found.append((node["mesh"], world_from_node))
        waiting += [(child, world_from_node) for child in node.get("children", ())]
        if len(waiting) > len(nodes):
            raise Refusal.saying(GLTF_CIRCLE, path)
    return found


def _gltf_transform(node: dict[str, Any]) -> Floats:
    """parent_from_node (4, 4)."""
    if "matrix" in node:  # written column by column
        return np.array(node["matrix"], dtype=np.float64).reshape(4, 4).T
    turn = np.array(node.get("rotation", (0.0, 0.0, 0.0, 1.0)), dtype=np.float64)
    length = np.linalg.norm(turn)
    if not 0.0 < length < math.inf:
        raise ValueError
    x, y, z, w = turn / length
    rotation = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    scale, translation = (
        np.array(node.get(name, (default,) * 3), dtype=np.float64).reshape(3)
        for name, default in (("scale", 1.0), ("translation", 0.0))
    )
    parent_from_node = np.eye(4)
    parent_from_node[:3, :3] = rotation * scale
    parent_from_node[:3, 3] = translation
    return parent_from_node


def _gltf_size(content: dict[str, Any], mesh: int) -> tuple[int, int]:
    """Most vertices, and triangles, of a mesh: by its counts, before anything is read."""
    vertices = triangles = 0
    for primitive in _item(content, "meshes", mesh)["primitives"]:
        position = _gltf_count(content, primitive["attributes"]["POSITION"])
        corners = _gltf_count(content, primitive["indices"]) if "indices" in primitive else position
        vertices += min(position, corners)
        mode = primitive.get("mode", 4)
        triangles += corners // 3 if mode == 4 else corners if mode in (5, 6) else 0
    return vertices, triangles


def _gltf_count(content: dict[str, Any], index: int) -> int:
    count = _item(content, "accessors", index)["count"]
    if not isinstance(count, int) or count < 1:
        raise ValueError
    return count


def _gltf_primitive(
    source: _Source, content: dict[str, Any], buffers: list[bytes], primitive: dict[str, Any]
) -> Mesh:
    """The triangles of a primitive; none where it is of points or lines."""
    attributes = primitive["attributes"]
    points = _gltf_values(source.path, content, buffers, attributes["POSITION"])
    colours = None
    if "COLOR_0" in attributes:
        linear = _gltf_values(source.path, content, buffers, attributes["COLOR_0"])[:, :3]
        if linear.shape != points.shape:
            raise ValueError
        colours = _srgb(linear.astype(np.float64) / _full_scale(linear.dtype))
    if "indices" in primitive:
        indices = _gltf_values(source.path, content, buffers, primitive["indices"])
        if indices.dtype.kind != "u" or indices.shape[1] != 1:
            raise ValueError
        order = indices.ravel().astype(np.int64)
        if len(order) < len(points) and order.max() < len(points):  # a few of many, as exporters do
            used, order = np.unique(order, return_inverse=True)
            points = points[used]
            colours = None if colours is None else colours[used]
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
    mesh = Mesh(points.astype(np.float64), np.arange(0, triangles.size + 1, 3), triangles.ravel())
    if mesh.points.shape[1] != 3:
        raise ValueError
    if len(triangles) and triangles.max() >= len(points):  # before one is taken for another mesh's
        raise Refusal.saying(NO_SUCH_VERTEX, source.path, len(points))
    if colours is not None:
        _paint_with_vertex_colours(mesh, colours)
    if mesh.rgb is None:
        rgb = np.array(_gltf_paint(content, primitive), dtype=np.uint8)
        mesh.rgb = np.tile(rgb, (len(triangles), 1))
    return mesh


def _gltf_paint(content: dict[str, Any], primitive: dict[str, Any]) -> Any:
    """The colour of a primitive's material."""
    if "material" not in primitive:
        return PAINT_RGB
    material = _item(content, "materials", primitive["material"])
    factor = np.array(
        material.get("pbrMetallicRoughness", {}).get("baseColorFactor", (1, 1, 1))[:3],
        dtype=np.float64,
    ).reshape(3)
    # White is what a mesh without colours, or with a texture, has.
    return PAINT_RGB if (factor == 1.0).all() else _bytes(_srgb(factor))


def _gltf_values(
    path: Path, content: dict[str, Any], buffers: list[bytes], index: int
) -> NDArray[Any]:
    """The values of an accessor, one row for each element."""
    accessor = _item(content, "accessors", index)
    if "sparse" in accessor or "bufferView" not in accessor:
        raise Refusal.saying(GLTF_SPARSE, path)
    view = _item(content, "bufferViews", accessor["bufferView"])
    first, buffer = view.get("byteOffset", 0), view["buffer"]
    if buffer not in range(len(buffers)) or first < 0:
        raise IndexError
    data = memoryview(buffers[buffer])[first : first + view["byteLength"]]
    if accessor["componentType"] not in _GLTF_TYPES or accessor["type"] not in _GLTF_PARTS:
        raise Refusal.saying(NOT_GLTF, path)
    kind = np.dtype(_GLTF_TYPES[accessor["componentType"]])
    parts, count = _GLTF_PARTS[accessor["type"]], _gltf_count(content, index)
    stride = view.get("byteStride", kind.itemsize * parts)
    start = accessor.get("byteOffset", 0)
    end = start + (count - 1) * stride + kind.itemsize * parts
    if start < 0 or stride < 1 or end > len(data):
        raise Refusal.saying(GLTF_ACCESSOR, path, index)
    return np.ndarray((count, parts), kind, data, start, (stride, kind.itemsize))


def _srgb(linear: Floats) -> Floats:
    """Linear light from 0 to 1, which glTF stores, as sRGB from 0 to 255."""
    linear = np.clip(linear, 0.0, 1.0)
    return 255.0 * np.where(
        linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055
    )


_READERS: dict[str, Callable[[_Source], Mesh]] = {
    ".obj": _read_obj,
    ".stl": _read_stl,
    ".ply": _read_ply,
    ".gltf": _read_gltf,
    ".glb": _read_gltf,
}
ENDINGS = tuple(_READERS)
"""Endings of the mesh files that `load` reads."""
