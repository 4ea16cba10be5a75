"""Read meshes from OBJ, STL, PLY and glTF files in float64, or refuse them in one sentence.

These readers use Python and numpy only, which cannot run past the end of an array.
`docs/meshes.md` has the measurements against a library: none of those tried meets the time limit
and keeps the coordinates for every format.
"""

from __future__ import annotations

import re
import warnings
from array import array
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from app.model.refusal import Cancelled, Refusal
from app.scenes.gltf import read_gltf
from app.scenes.mesh import (
    CUT_OFF,
    DAMAGED,
    DAMAGED_LINE,
    LARGEST,
    NO_MEMORY,
    NOT_OF_KIND,
    Colours,
    Floats,
    Ints,
    Mesh,
    Progress,
    Source,
    full_scale,
    open_mesh,
    report,
    rgb_bytes,
)
from app.scenes.shapes import distinct_rows

BLOCK = 1 << 24
"""Bytes of text in a block; progress is reported after each block."""


def read(path: Path, progress: Progress | None = None, largest: tuple[int, int] = LARGEST) -> Mesh:
    """Read a mesh file.

    Parameters
    ----------
    path : Path
        A file with one of `ENDINGS`.
    progress : callable, optional
        Called now and then with the fraction done, from 0 to 1, on the caller's thread. Reading
        stops when it returns False.
    largest : tuple of 2 ints
        Most triangles of the mesh, and most bytes of its triangles and vertices.

    Returns
    -------
    Mesh
        With a face, a line or a dot at least, and no vertex that is not drawn.

    Raises
    ------
    Refusal
        For a file that cannot be read or holds nothing to draw.
    Cancelled
        When `progress` returned False.
    """
    with open_mesh(path) as file:
        report(progress, 0.0)
        try:
            with np.errstate(all="ignore"):  # `check` refuses numbers that are not finite
                mesh = _READERS[path.suffix.lower()](Source(path, file, progress, largest))
            mesh.check(path)
        except MemoryError:
            raise Refusal.saying(NO_MEMORY, path) from None
        except (Refusal, Cancelled):
            raise
        except Exception as error:  # no reader can foresee everything in a stranger's file
            raise Refusal.saying(DAMAGED, path, type(error).__name__) from error
    mesh.drop_unused_points()
    return mesh


def _numbers(
    text: bytes, kind: type[np.generic] = np.float64, words: int | None = None
) -> NDArray[Any]:
    """Return the numbers of a text; raise `ValueError` if it has a word that is not a number."""
    if words is None:
        visible = np.frombuffer(text, dtype=np.uint8) > 32
        words = int(np.count_nonzero(visible[1:] & ~visible[:-1])) + int(visible[:1].sum())
    if not words:
        return np.empty(0, dtype=kind)
    with warnings.catch_warnings():  # numpy returns what it has read so far, with a warning
        warnings.simplefilter("error", DeprecationWarning)
        try:
            numbers = np.fromstring(text, dtype=kind, sep=" ")
        except DeprecationWarning as warning:
            raise ValueError from warning
    if len(numbers) != words:  # "1-2" is two numbers for numpy
        raise ValueError
    return numbers


# --------------------------------------------------------------------------- OBJ


def _read_obj(source: Source) -> Mesh:
    """Read vertices, their colours, faces, lines and points; normals and so on are ignored.

    Vertices alone are a cloud of points.
    """
    points, colours = [], []
    corners, counts = ({kind: [np.empty(0, dtype=np.int64)] for kind in "flp"} for _ in range(2))
    vertices = elements = cornered = lines_before = 0
    for text in _obj_blocks(source.file):
        try:
            rows, named = _obj_mesh(text)
        except ValueError:
            wrong = lines_before + _wrong_line(text.splitlines(keepends=True))
            raise Refusal.saying(DAMAGED_LINE, source.path, wrong, "OBJ") from None
        for kind, (indices, sizes, before) in named.items():
            from_start = indices - 1
            if (indices < 0).any():  # counted back from the last vertex before the element
                back = np.repeat(vertices + before, sizes) + indices
                from_start = np.where(indices < 0, back, from_start)
            elements, cornered = elements + len(sizes), cornered + len(indices)
            corners[kind].append(from_start)
            counts[kind].append(sizes)
        vertices += len(rows)
        source.check_size(vertices, elements, cornered)
        points.append(rows[:, :3])
        colours.append(rows[:, 3:])
        lines_before += text.count(b"\n")
        source.report(min(0.4, 0.4 * source.file.tell() / source.size))
    on_line, lengths = np.concatenate(corners["l"]), np.concatenate(counts["l"])
    lasts = np.cumsum(lengths) - 1
    goes_on = np.ones(len(on_line), dtype=bool)
    goes_on[lasts[lengths > 0]] = False
    starts = np.flatnonzero(goes_on)
    dots = np.concatenate([*corners["p"], on_line[lasts[lengths == 1]]])
    mesh = Mesh(
        np.concatenate([np.empty((0, 3)), *points]),
        np.concatenate([[0], np.cumsum(np.concatenate(counts["f"]))]),
        np.concatenate(corners["f"]),
        lines=on_line[np.stack([starts, starts + 1], axis=1)],
        dots=dots if elements else np.arange(vertices),
    )
    rgb = [block for block in colours if len(block)]
    if rgb and all(block.shape[1] == 3 for block in rgb):
        mesh.paint(255.0 * np.concatenate(rgb))
    return mesh


def _obj_blocks(file: BinaryIO) -> Iterator[bytes]:
    """Yield blocks of whole lines that end with a newline, without comments and leading blanks."""
    rest = b""
    while True:
        block = file.read(BLOCK)
        text = rest + block if block else rest + b"\n"
        end = text.rfind(b"\n") + 1
        while block and text.endswith((b"\\\n", b"\\\r\n"), 0, end):
            end = text.rfind(b"\n", 0, end - 1) + 1  # this line goes on in the next block
        text, rest = text[:end], text[end:]
        if b"\r" in text:
            text = text.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
        if b"\\" in text:
            text = text.replace(b"\\\n", b" ")
        if b"#" in text:
            text = re.sub(rb"#[^\n]*", b"", text)
        if text[:1] in b" \t" or b"\n " in text or b"\n\t" in text:
            text = re.sub(rb"^[ \t]+", b"", text, flags=re.MULTILINE)
        yield text
        if not block:
            return


def _obj_mesh(text: bytes) -> tuple[Floats, dict[str, tuple[Ints, Ints, Ints]]]:
    """Read a block of lines; raise `ValueError` if one of them cannot be read.

    Returns three numbers for each vertex (six if all have colours). For faces (f), lines (l) and
    points (p) it returns the vertex numbers of all corners, and for each element how many corners
    it has and how many vertices precede it.
    """
    letters = np.frombuffer(text, dtype=np.uint8)
    lengths = np.diff(np.flatnonzero(letters == ord("\n")) + 1, prepend=0)
    begins = np.cumsum(lengths) - lengths
    blank_after = np.isin(letters[np.minimum(begins + 1, len(letters) - 1)], (32, 9))
    is_a = {kind: blank_after & (letters[begins] == ord(kind)) for kind in "vflp"}
    is_vertex = is_a.pop("v")
    numbers, words = _obj_numbers(letters, lengths, is_vertex, np.float64)
    if (words < 3).any():
        raise ValueError
    width = 6 if (words >= 6).all() else 3
    rows = numbers[(np.cumsum(words) - words)[:, None] + np.arange(width)]
    before = np.cumsum(is_vertex)
    return rows, {
        kind: (*_obj_numbers(letters, lengths, which, np.int64), before[which])
        for kind, which in is_a.items()
        if which.any()
    }


def _obj_numbers(
    letters: Colours, lengths: Ints, which: NDArray[np.bool_], kind: type[np.generic]
) -> tuple[NDArray[Any], Ints]:
    """Return the numbers after the first letters of some lines, and how many each line has."""
    text, ends = letters[np.repeat(which, lengths)], np.cumsum(lengths[which])
    text[ends - lengths[which]] = ord(" ")
    visible = text > 32
    word_begins = np.flatnonzero(visible[1:] & ~visible[:-1])
    words = np.diff(np.searchsorted(word_begins, ends), prepend=0)
    slash = text == ord("/")
    if kind == np.int64 and slash.any():  # 1/2/3, 1//3, 1/2/ and 1// are vertex 1
        edges = np.flatnonzero(slash | ~visible)
        text[np.repeat(slash[edges], np.diff(edges, append=len(text)))] = ord(" ")
    return _numbers(text.tobytes(), kind, len(word_begins)), words


def _wrong_line(lines: list[bytes]) -> int:
    """Return the number, from 1, of the first line that cannot be read."""
    before = 0
    while len(lines) > 1:
        half = lines[: len(lines) // 2]
        try:
            _obj_mesh(b"".join(half))
        except ValueError:
            lines = half
        else:
            before, lines = before + len(half), lines[len(half) :]
    return before + 1


# --------------------------------------------------------------------------- STL

_STL_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def _read_stl(source: Source) -> Mesh:
    head, length = source.file.read(4096), source.size
    count = int.from_bytes(head[80:84], "little")
    binary_length = 84 + _STL_TRIANGLE.itemsize * count
    # Many binary files begin with "solid" like text files: the length decides first.
    if len(head) >= 84 and length == binary_length:
        corners = _stl_binary(source, count)
    elif head.lstrip()[:5].lower() == b"solid":
        corners = _stl_text(source)
    elif len(head) < 84 or b"\0" not in head:
        raise Refusal.saying(NOT_OF_KIND, source.path, "STL")
    elif length < binary_length:
        raise Refusal.saying(CUT_OFF, source.path)
    else:  # some programs append data of their own
        corners = _stl_binary(source, count)
    source.report(0.3)
    points, merged = distinct_rows(corners)
    source.report(0.4)
    return Mesh(points, np.arange(0, len(corners) + 1, 3), merged)


def _stl_binary(source: Source, count: int) -> Floats:
    """Return the triangles' corners (3 m, 3): float32 by definition of the format."""
    source.check_size(3 * count, count, 3 * count)
    source.file.seek(84)
    triangles = np.fromfile(source.file, dtype=_STL_TRIANGLE, count=count)
    return triangles["corners"].reshape(-1, 3).astype(np.float64)


def _stl_text(source: Source) -> Floats:
    """Return the triangles' corners (3 m, 3) with all digits of the text."""
    source.file.seek(0)
    rest, blocks, triangles = b"", [np.empty(0)], 0
    while block := source.file.read(BLOCK):
        text = (rest + block).lower()
        end = text.rfind(b"endloop")
        if end < 0:
            rest = text
            continue
        end += len(b"endloop")
        text, rest = _without_stl_names(text[:end]), text[end:]
        # "... outer loop vertex x y z vertex x y z vertex x y z endloop ...": take the odd pieces.
        between, loops = (text.split(b"loop")[first::2] for first in (0, 1))
        try:
            numbers = _numbers(b" ".join(loops).replace(b"vertex", b"").replace(b"end", b""))
        except ValueError:
            source.fail("vertex")
        if len(numbers) != 9 * len(loops) or any(b"vertex" in words for words in between):
            source.fail("facet")
        triangles += len(loops)
        source.check_size(3 * triangles, triangles, 3 * triangles)
        blocks.append(numbers)
        source.report(min(0.3, 0.3 * source.file.tell() / source.size))
    if b"vertex" in _without_stl_names(rest):
        raise Refusal.saying(CUT_OFF, source.path)
    return np.concatenate(blocks).reshape(-1, 3)


def _without_stl_names(text: bytes) -> bytes:
    """Drop the names after “solid” and “endsolid”, which may contain any words."""
    return re.sub(rb"solid[^\n]*?(?=facet\s+normal|\n|\Z)", b"", text)


# --------------------------------------------------------------------------- PLY

_PLY_TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
    "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4",
    "float": "f4", "double": "f8", "float32": "f4", "float64": "f8",
}  # fmt: skip
_PLY_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}


class _Property(NamedTuple):
    """A column of an element: the type of its numbers in the body, and of the count before a list.

    `full_scale` is the value of full brightness, if the column is a colour channel.
    """

    name: str
    kind: np.dtype[Any]
    full_scale: float
    counter: np.dtype[Any] | None = None


class _Element(NamedTuple):
    name: str
    rows: int
    properties: list[_Property]


def _read_ply(source: Source) -> Mesh:
    elements, body = _ply_header_and_body(source)
    source.report(0.2)
    mesh = Mesh()
    at = 0
    vertex_rgb = None
    for element in elements:
        try:
            columns, lengths, at = _ply_columns(element, body, at)
        except IndexError:
            raise Refusal.saying(CUT_OFF, source.path) from None
        scale = {p.name: 255.0 / p.full_scale for p in element.properties if p.counter is None}
        rgb = None
        if scale.keys() >= {"red", "green", "blue"}:
            channels = ("red", "green", "blue")
            rgb = np.stack([columns[c].astype(np.float32) * np.float32(scale[c]) for c in channels],
                           axis=1)  # fmt: skip
        if element.name == "vertex":
            if not scale.keys() >= {"x", "y", "z"}:
                source.fail("vertex: x, y, z")
            mesh.points = np.stack([columns[axis] for axis in "xyz"], axis=1).astype(np.float64)
            vertex_rgb = rgb
        elif element.name == "face":
            name = next((n for n in ("vertex_indices", "vertex_index") if n in lengths), None)
            if name is None:
                source.fail("face: vertex_indices")
            mesh.offsets = np.concatenate([[0], np.cumsum(lengths[name])])
            mesh.corners = columns[name].astype(np.int64)  # nan becomes an index out of range
            source.check_size(len(mesh.points), element.rows, len(mesh.corners))
            if rgb is not None:
                mesh.rgb, mesh.painted = rgb_bytes(rgb), True
        elif element.name == "edge" and scale.keys() >= {"vertex1", "vertex2"}:
            ends = [columns[end].astype(np.int64) for end in ("vertex1", "vertex2")]
            mesh.lines = np.stack(ends, axis=1)
        source.report(0.4)
    if len(mesh.offsets) == 1:  # a cloud of points
        is_alone = np.ones(len(mesh.points), dtype=bool)
        is_alone[mesh.lines[(mesh.lines >= 0) & (mesh.lines < len(is_alone))]] = False
        mesh.dots = np.flatnonzero(is_alone)
    source.check_size(len(mesh.points), len(mesh.dots), 0)
    if mesh.rgb is None and vertex_rgb is not None:
        mesh.paint(vertex_rgb)
    return mesh


def _ply_header_and_body(source: Source) -> tuple[list[_Element], bytes]:
    """Return the elements up to the vertices, faces and edges, and the body.

    A text body becomes a binary one in which every number is a float64.
    """
    data = source.file.read()
    header = re.match(rb"ply\s.*?end_header[^\S\n]*\r?\n?", data[:1_000_000], re.DOTALL)
    if header is None:
        raise Refusal.saying(NOT_OF_KIND, source.path, "PLY")
    try:
        elements, is_text = _ply_elements(header[0].decode("latin-1"))
        rows_of = {element.name: element.rows for element in elements}
        vertices, faces, lines = rows_of["vertex"], rows_of.get("face", 0), rows_of.get("edge", 0)
    except (LookupError, TypeError, ValueError):
        source.fail("header")
    source.check_size(vertices, faces + lines, 3 * faces + 2 * lines)
    body = data[header.end() :]
    if is_text:
        try:
            body = _numbers(body).tobytes()
        except ValueError:
            source.fail("end_header ...")
    drawn = ("vertex", "face", "edge")
    needed = 1 + max(place for place, name in enumerate(rows_of) if name in drawn)
    return elements[:needed], body


def _ply_elements(header: str) -> tuple[list[_Element], bool]:
    """Return the elements of a header, and whether the body is text."""
    order: Any = None
    elements: list[_Element] = []
    for line in header.splitlines():
        match line.split():
            case ["format", encoding, *_]:
                order = _PLY_ORDERS[encoding]
            case ["element", name, rows, *_]:
                elements.append(_Element(name, int(rows), []))
            case ["property", "list", count, kind, name]:
                kinds = [np.dtype(order + _PLY_TYPES[k] if order else "f8") for k in (kind, count)]
                elements[-1].properties.append(_Property(name, kinds[0], 1.0, kinds[1]))
            case ["property", kind, name]:
                in_file = np.dtype(_PLY_TYPES[kind])
                read = np.dtype(order + _PLY_TYPES[kind] if order else "f8")
                elements[-1].properties.append(_Property(name, read, full_scale(in_file)))
            case ["property", *_]:
                raise ValueError
    names = [[e.name for e in elements], *([p.name for p in e.properties] for e in elements)]
    has_copies = any(len(set(each)) < len(each) for each in names)
    if order is None or has_copies or any(e.rows < 0 or not e.properties for e in elements):
        raise ValueError
    return elements, order == ""


_Columns: TypeAlias = tuple[dict[str, NDArray[Any]], dict[str, Ints], int]


def _ply_columns(element: _Element, body: bytes, at: int) -> _Columns:
    """Return the columns of an element, the lengths of its lists, and its end in the body.

    The lists of a column are joined. `IndexError` means that the body ends too early.
    """
    rows, properties = element.rows, element.properties
    lists = [p for p in properties if p.counter is not None]
    if rows == 0:
        empty = np.empty(0, dtype=np.int64)
        return {p.name: empty for p in properties}, {p.name: empty for p in lists}, at

    # In most files all lists are as long as those of the first row: the element is a table.
    fields: list[tuple[Any, ...]] = []
    for p, length in zip(properties, _ply_row(properties, body, at)[0][1::2], strict=True):
        if p.counter is not None:
            fields.append((f"length of {p.name}", p.counter))
        fields.append((p.name, p.kind, (length,)))
    row = np.dtype(fields)
    end = at + rows * row.itemsize
    if end <= len(body):
        table = np.frombuffer(body, row, rows, at)
        counts = {p.name: table[f"length of {p.name}"] for p in lists}
        if all((count == count[0]).all() for count in counts.values()):
            columns = {p.name: table[p.name].ravel() for p in properties}
            return columns, {name: c.astype(np.int64) for name, c in counts.items()}, end
    if at + rows * sum((p.counter or p.kind).itemsize for p in properties) > len(body):
        raise IndexError

    # Otherwise every row has to be looked at to find the next one.
    found = array("q")
    for _ in range(rows):
        places, at = _ply_row(properties, body, at)
        found.extend(places)
    starts, lengths = np.moveaxis(np.array(found).reshape(rows, len(properties), 2), 2, 0)
    octets = np.frombuffer(body, dtype=np.uint8)
    columns = {}
    for i, p in enumerate(properties):
        item = np.arange(lengths[:, i].sum())
        item -= np.repeat(np.cumsum(lengths[:, i]) - lengths[:, i], lengths[:, i])
        first = np.repeat(starts[:, i], lengths[:, i]) + item * p.kind.itemsize
        items = octets[first[:, None] + np.arange(p.kind.itemsize)]
        columns[p.name] = np.ascontiguousarray(items).view(p.kind).ravel()
    return columns, {p.name: lengths[:, properties.index(p)] for p in lists}, at


def _ply_row(properties: list[_Property], body: bytes, at: int) -> tuple[list[int], int]:
    """Return each column's start in a row and its count of numbers, and the row's end."""
    places = []
    for p in properties:
        length = 1
        if p.counter is not None:
            if at + p.counter.itemsize > len(body):
                raise IndexError
            counted = np.frombuffer(body, p.counter, 1, at)[0]
            if not 0 <= counted <= len(body):  # also if it is nan
                raise IndexError
            length = int(counted)
            at += p.counter.itemsize
        places += [at, length]
        at += length * p.kind.itemsize
        if at > len(body):
            raise IndexError
    return places, at


_READERS: dict[str, Callable[[Source], Mesh]] = {
    ".obj": _read_obj,
    ".stl": _read_stl,
    ".ply": _read_ply,
    ".gltf": read_gltf,
    ".glb": read_gltf,
}
ENDINGS = tuple(_READERS)
"""Endings of the mesh files that `load` reads."""
