"""Read meshes from OBJ, STL, PLY and glTF files in float64, or refuse them in one sentence.

These readers use Python and numpy only, which cannot run past the end of an array.
`docs/meshes.md` has the measurements against a library: none of those tried meets the time limit
and keeps the coordinates for every format.
"""

from __future__ import annotations

import codecs
import re
import warnings
from array import array
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple, NoReturn, TypeAlias

import numpy as np
from numpy.typing import NDArray

from app.model.refusal import Cancelled, Refusal
from app.scenes.gltf import read_gltf
from app.scenes.mesh import (
    CUT_OFF,
    CUT_OFF_ROWS,
    CUT_OFF_TRIANGLES,
    DAMAGED,
    DAMAGED_LINE,
    LARGEST,
    NO_MEMORY,
    NOT_FINITE_LINE,
    NOT_OF_KIND,
    UNSUPPORTED,
    Colours,
    Floats,
    Ints,
    Mesh,
    MeshSource,
    Progress,
    full_scale,
    open_mesh,
    report,
    rgb_bytes,
)
from app.scenes.shapes import distinct_rows

_MARK = codecs.BOM_UTF8
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
                mesh = _READERS[path.suffix.lower()](MeshSource(path, file, progress, largest))
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


def _read_obj(source: MeshSource) -> Mesh:
    """Read vertices, their colours, faces, lines and points; normals and so on are ignored.

    Vertices alone are a cloud of points.
    """
    points, colours = [], []
    corners, counts, lines_of = (
        {kind: [np.empty(0, dtype=np.int64)] for kind in "vflp"} for _ in range(3)
    )
    vertices = elements = cornered = lines_before = 0
    for text in _obj_blocks(source.file):
        try:
            rows, named, lines_in = _obj_mesh(text)
        except ValueError:
            lines = text.splitlines(keepends=True)
            wrong = lines_before + _wrong_line(lines, lambda some: _obj_mesh(b"".join(some)))
            raise Refusal.saying(DAMAGED_LINE, source.path, wrong, "OBJ") from None
        for kind, (indices, sizes, before) in named.items():
            from_start = indices - 1
            if (indices < 0).any():  # counted back from the last vertex before the element
                back = np.repeat(vertices + before, sizes) + indices
                from_start = np.where(indices < 0, back, from_start)
            elements, cornered = elements + len(sizes), cornered + len(indices)
            corners[kind].append(from_start)
            counts[kind].append(sizes)
        for kind, numbers in lines_in.items():
            lines_of[kind].append(lines_before + numbers)
        vertices += len(rows)
        source.check_size(vertices, elements, cornered)
        points.append(rows[:, :3])
        colours.append(rows[:, 3:])
        lines_before += text.count(b"\n")
        source.report(min(0.4, 0.4 * source.file.tell() / source.size))
    line = {kind: np.concatenate(numbers) for kind, numbers in lines_of.items()}
    on_line, lengths = np.concatenate(corners["l"]), np.concatenate(counts["l"])
    lasts = np.cumsum(lengths) - 1
    goes_on = np.ones(len(on_line), dtype=bool)
    goes_on[lasts[lengths > 0]] = False
    starts = np.flatnonzero(goes_on)
    dots = np.concatenate([*corners["p"], on_line[lasts[lengths == 1]]])
    lines_of_p = np.repeat(line["p"], np.concatenate(counts["p"]))
    lines_of_dots = np.append(lines_of_p, line["l"][lengths == 1])
    mesh = Mesh(
        np.concatenate([np.empty((0, 3)), *points]),
        np.concatenate([[0], np.cumsum(np.concatenate(counts["f"]))]),
        np.concatenate(corners["f"]),
        lines=on_line[np.stack([starts, starts + 1], axis=1)],
        dots=dots if elements else np.arange(vertices),
        rows={
            "points": line["v"],
            "faces": line["f"],
            "lines": np.repeat(line["l"], lengths)[starts],
            "dots": lines_of_dots if elements else line["v"],
        },
    )
    mesh.drop_small_faces(source.path)
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
        if _MARK in text:  # of a file that was joined to another
            text = text.replace(_MARK, b"")
        if b"\r" in text:
            text = text.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
        if b"\\" in text:
            # A joined line keeps its number, and those after it keep theirs.
            text = re.sub(
                rb"^(?:[^\n]*\\\n)+[^\n]*",
                lambda m: m[0].replace(b"\\\n", b" ") + b"\n" * m[0].count(b"\\\n"),
                text,
                flags=re.MULTILINE,
            )
        if b"1.#" in text:  # what Microsoft's C library writes for nan and inf
            text = re.sub(rb"[-+]?1\.#(?:IND|INF|[QS]NAN)\d*", b"nan", text)
        if b"#" in text:
            text = re.sub(rb"#[^\n]*", b"", text)
        if text[:1] in b" \t" or b"\n " in text or b"\n\t" in text:
            text = re.sub(rb"^[ \t]+", b"", text, flags=re.MULTILINE)
        yield text
        if not block:
            return


def _obj_mesh(text: bytes) -> tuple[Floats, dict[str, tuple[Ints, Ints, Ints]], dict[str, Ints]]:
    """Read a block of lines; raise `ValueError` if one of them cannot be read.

    Returns three numbers for each vertex (six if all have colours). For faces (f), lines (l) and
    points (p) it returns the vertex numbers of all corners, and for each element how many corners
    it has and how many vertices precede it. Last come the lines of all these, from 1.
    """
    letters = np.frombuffer(text, dtype=np.uint8)
    lengths = np.diff(np.flatnonzero(letters == ord("\n")) + 1, prepend=0)
    begins = np.cumsum(lengths) - lengths
    blank_after = np.isin(letters[np.minimum(begins + 1, len(letters) - 1)], (32, 9))
    is_a = {kind: blank_after & (letters[begins] == ord(kind)) for kind in "vflp"}
    places = {kind: np.flatnonzero(which) + 1 for kind, which in is_a.items()}
    is_vertex = is_a.pop("v")
    numbers, words = _obj_numbers(letters, lengths, is_vertex, np.float64)
    if (words < 3).any():
        raise ValueError
    width = 6 if (words >= 6).all() else 3
    rows = numbers[(np.cumsum(words) - words)[:, None] + np.arange(width)]
    before = np.cumsum(is_vertex)
    named = {
        kind: (*_obj_numbers(letters, lengths, which, np.int64), before[which])
        for kind, which in is_a.items()
        if which.any()
    }
    return rows, named, places


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


def _wrong_line(lines: list[bytes], read_lines: Callable[[list[bytes]], object]) -> int:
    """Return the number, from 1, of the first line that `read_lines` cannot read."""
    before = 0
    while len(lines) > 1:
        half = lines[: len(lines) // 2]
        try:
            read_lines(half)
        except ValueError:
            lines = half
        else:
            before, lines = before + len(half), lines[len(half) :]
    return before + 1


# --------------------------------------------------------------------------- STL

_STL_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def _read_stl(source: MeshSource) -> Mesh:
    """Read a binary file, even one that begins with “solid” as a text does, or a text.

    The length decides: no text can hold as many triangles as its letters at the place of the count
    would say. Some writers leave the count 0, or as large as possible.
    """
    head = source.file.read(4096)
    count, present = int.from_bytes(head[80:84], "little"), (source.size - 84) // 50
    if count in (0, 2**32 - 1):
        count = max(present, 0)
    if len(head) >= 84 and count <= present:
        corners = _stl_binary(source, count)
    elif b"\0" in head and len(head) >= 84 and count <= LARGEST[0]:
        raise Refusal.saying(CUT_OFF_TRIANGLES, source.path, present, count)
    elif re.match(rb"\s*(solid|facet\s)", head, re.IGNORECASE):
        corners = _stl_text(source)
    else:
        raise Refusal.saying(NOT_OF_KIND, source.path, "STL")
    source.report(0.3)
    points, merged = distinct_rows(corners)
    source.report(0.4)
    return Mesh(points, np.arange(0, len(corners) + 1, 3), merged)


def _stl_binary(source: MeshSource, count: int) -> Floats:
    """Return the triangles' corners (3 m, 3): float32 by definition of the format."""
    source.check_size(3 * count, count, 3 * count)
    source.file.seek(84)
    triangles = np.fromfile(source.file, dtype=_STL_TRIANGLE, count=count)
    return triangles["corners"].reshape(-1, 3).astype(np.float64)


def _stl_text(source: MeshSource) -> Floats:
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
            _refuse_stl_line(source)
            source.fail("vertex")
        if len(numbers) != 9 * len(loops) or any(b"vertex" in words for words in between):
            _refuse_stl_line(source)
            source.fail("facet")
        if not np.isfinite(numbers).all():
            _refuse_stl_line(source)
        triangles += len(loops)
        source.check_size(3 * triangles, triangles, 3 * triangles)
        blocks.append(numbers)
        source.report(min(0.3, 0.3 * source.file.tell() / source.size))
    if b"vertex" in _without_stl_names(rest):
        raise Refusal.saying(CUT_OFF, source.path)
    return np.concatenate(blocks).reshape(-1, 3)


def _refuse_stl_line(source: MeshSource) -> None:
    """Refuse the first vertex that is not three finite numbers, or loop that is no triangle."""
    source.file.seek(0)
    facet = corners = 0
    for number, line in enumerate(source.file, 1):
        words = line.lower().split()
        facet = number if words[:1] == [b"facet"] else facet
        if words[:1] == [b"endloop"] and corners != 3:
            raise Refusal.saying(DAMAGED_LINE, source.path, facet, "STL")
        corners = corners + 1 if words[:1] == [b"vertex"] else 0
        if corners:
            try:
                numbers = _numbers(b" ".join(words[1:]))
            except ValueError:
                numbers = np.empty(0)
            if len(numbers) != 3:
                raise Refusal.saying(DAMAGED_LINE, source.path, number, "STL")
            if not np.isfinite(numbers).all():
                raise Refusal.saying(NOT_FINITE_LINE, source.path, number, facet)


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


class _PlyColumn(NamedTuple):
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
    properties: list[_PlyColumn]


def _read_ply(source: MeshSource) -> Mesh:
    elements, body, lines_of = _ply_header_and_body(source)
    source.report(0.2)
    mesh = Mesh()
    at = 0
    vertex_rgb, strips = None, np.empty((0, 3), dtype=np.int64)
    kinds = {"vertex": "points", "face": "faces", "edge": "lines"}
    mesh.rows = {kinds[name]: lines for name, lines in lines_of.items() if name in kinds}
    for element in elements:
        try:
            columns, lengths, at = _ply_columns(element, body, at)
        except IndexError as error:
            _refuse_cut_off(source, element, sum(error.args))
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
        elif element.name in ("face", "tristrips"):
            name = next((n for n in ("vertex_indices", "vertex_index") if n in lengths), None)
            if name is None:
                source.fail(f"{element.name}: vertex_indices")
            if element.name == "tristrips":
                strips = _strips(columns[name].astype(np.int64), lengths[name])
                continue
            mesh.offsets = np.concatenate([[0], np.cumsum(lengths[name])])
            mesh.corners = columns[name].astype(np.int64)  # nan becomes an index out of range
            source.check_size(len(mesh.points), element.rows, len(mesh.corners))
            if rgb is not None:
                mesh.rgb, mesh.painted = rgb_bytes(rgb), True
        elif element.name == "edge" and scale.keys() >= {"vertex1", "vertex2"}:
            ends = [columns[end].astype(np.int64) for end in ("vertex1", "vertex2")]
            mesh.lines = np.stack(ends, axis=1)
        source.report(0.4)
    if len(strips):
        source.check_size(len(mesh.points), len(strips), strips.size)
        ends = mesh.offsets[-1] + np.arange(3, strips.size + 1, 3)
        mesh.offsets = np.concatenate([mesh.offsets, ends])
        mesh.corners = np.concatenate([mesh.corners, strips.ravel()])
        mesh.rgb = None
        mesh.rows.pop("faces", None)
    mesh.drop_small_faces(source.path)
    if len(mesh.offsets) == 1:  # a cloud of points
        is_alone = np.ones(len(mesh.points), dtype=bool)
        is_alone[mesh.lines[(mesh.lines >= 0) & (mesh.lines < len(is_alone))]] = False
        mesh.dots = np.flatnonzero(is_alone)
    source.check_size(len(mesh.points), len(mesh.dots), 0)
    if mesh.rgb is None and vertex_rgb is not None:
        mesh.paint(vertex_rgb)
    return mesh


def _strips(named: Ints, lengths: Ints) -> Ints:
    """Return the triangles (k, 3) of strips that -1 or the end of a row separates.

    Every other triangle of a strip runs the other way round.
    """
    is_stop = np.isin(named, (-1, 2**32 - 1))
    begins = np.zeros(len(named) + 1, dtype=bool)
    begins[np.cumsum(lengths) - lengths] = True
    begins[1:][is_stop] = True
    strip, at = np.cumsum(begins[:-1]), np.arange(len(named))
    first = np.maximum.accumulate(np.where(begins[:-1], at, 0))
    goes_on = ~is_stop
    goes_on[-2:] = False
    goes_on[:-2] &= ~is_stop[1:-1] & ~is_stop[2:] & (strip[:-2] == strip[2:])
    i = np.flatnonzero(goes_on)
    odd = (i - first[i]) % 2
    triangles = np.stack([named[i], named[i + 1 + odd], named[i + 2 - odd]], axis=1)
    # A repeated corner turns to the next strip.
    whole: Ints = triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)]
    return whole


_PLY_HEADER = re.compile(rb"ply\s.*?[\r\n]end_header[ \t]*(?:\r?\n|\Z)", re.DOTALL)
_PLY_OF_OLD_MAC = re.compile(rb"ply\s.*?[\r\n]end_header[ \t]*(?:\r|\Z)", re.DOTALL)
"""The lines of a file end with a carriage return alone if its first one does."""


def _ply_header_and_body(source: MeshSource) -> tuple[list[_Element], bytes, dict[str, Ints]]:
    """Return the elements up to the last one that is drawn, the body, and the lines of a text.

    A text body becomes a binary one in which every number is a float64.
    """
    data = source.file.read()
    start = re.match(rb"ply[ \t]*(\r\n?|\n)", data[:100])
    is_old, head = start is not None and start[1] == b"\r", data[:1_000_000]
    header = _PLY_OF_OLD_MAC.match(head) if is_old else _PLY_HEADER.match(head)
    if header is None:
        raise Refusal.saying(NOT_OF_KIND, source.path, "PLY")
    try:
        elements, is_text = _ply_elements(header[0].decode("latin-1"))
        rows_of = {element.name: element.rows for element in elements}
        vertices, faces, lines = rows_of["vertex"], rows_of.get("face", 0), rows_of.get("edge", 0)
    except (LookupError, TypeError, ValueError):
        source.fail("header")
    source.check_size(vertices, faces + lines, 3 * faces + 2 * lines)
    drawn = ("vertex", "face", "edge", "tristrips")
    for each in elements:  # faces by another name: the vertices alone are not what it shows
        is_list = any(column.counter is not None for column in each.properties)
        if is_list and each.rows and each.name not in drawn and not faces:
            raise Refusal.saying(UNSUPPORTED, source.path, f"element {each.name}")
    needed = 1 + max(place for place, name in enumerate(rows_of) if name in drawn)
    body = data[header.end() :]
    lines_of: dict[str, Ints] = {}
    if is_text:
        body, lines_of = _ply_text(source, body, len(header[0].splitlines()), elements)
    return elements[:needed], body, lines_of


def _ply_text(
    source: MeshSource, body: bytes, before: int, elements: list[_Element]
) -> tuple[bytes, dict[str, Ints]]:
    """Return the numbers that the header names, and the lines of each element below the header.

    Each row is a line, or all rows are on one. The header may name fewer numbers than a row has.
    """
    body = body.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    letters = np.frombuffer(body, dtype=np.uint8)
    visible = letters > 32
    word_begins = np.flatnonzero(visible & ~np.append(False, visible[:-1]))
    line_ends = np.append(np.flatnonzero(letters == ord("\n")), len(letters))
    ends = np.searchsorted(word_begins, line_ends)
    filled, rows = np.flatnonzero(np.diff(ends, prepend=0)), sum(e.rows for e in elements)
    is_open = len(filled) == rows and not body.endswith(b"\n")
    filled = filled[:rows]  # what follows is no part of the mesh
    body = body[: line_ends[filled[-1]] if filled.size else 0]
    try:
        numbers = _numbers(body, words=int(ends[filled[-1]]) if filled.size else 0)
    except ValueError:
        wrong = _wrong_line(body.splitlines(), lambda lines: _numbers(b"\n".join(lines)))
        raise Refusal.saying(DAMAGED_LINE, source.path, before + wrong, "PLY") from None
    if len(filled) == 1 < rows:
        return numbers.tobytes(), {}
    marks, lines_of, first = np.zeros(len(numbers) + 1, dtype=np.int8), {}, 0
    for element in elements:
        which = filled[first : first + element.rows]
        first += element.rows
        at, end = np.append(0, ends)[which], ends[which]
        marks[at] += 1
        for p in element.properties:
            if p.counter is not None and len(numbers):
                counted = numbers[np.minimum(at, len(numbers) - 1)]
                is_count = (counted >= 0) & (counted < len(numbers))  # not if it is nan
                at = at + np.where(is_count, counted, len(numbers)).astype(np.int64)
            at = at + 1
        short = np.flatnonzero(at > end)
        if short.size and not (is_open and first == rows and short[0] == element.rows - 1):
            line = before + 1 + int(which[short[0]])
            raise Refusal.saying(DAMAGED_LINE, source.path, line, element.name)
        if len(which) - len(short) < element.rows:
            _refuse_cut_off(source, element, len(which) - len(short))
        marks[at] -= 1
        lines_of[element.name] = before + 1 + which
    is_named = np.cumsum(marks[:-1], dtype=np.int8) > 0
    return (numbers if is_named.all() else numbers[is_named]).tobytes(), lines_of


def _refuse_cut_off(source: MeshSource, element: _Element, there: int) -> NoReturn:
    raise Refusal.saying(CUT_OFF_ROWS, source.path, there, element.rows, element.name)


def _ply_elements(header: str) -> tuple[list[_Element], bool]:
    """Return the elements of a header, and whether the body is text."""
    order: Any = None
    elements: list[_Element] = []
    for line in re.split(r"[\r\n]+", header):
        match line.split():
            case ["format", encoding, *_]:
                order = _PLY_ORDERS[encoding]
            case ["element", name, rows, *_]:
                elements.append(_Element(name, int(rows), []))
            case ["property", "list", count, kind, name]:
                kinds = [np.dtype(order + _PLY_TYPES[k] if order else "f8") for k in (kind, count)]
                elements[-1].properties.append(_PlyColumn(name, kinds[0], 1.0, kinds[1]))
            case ["property", kind, name]:
                in_file = np.dtype(_PLY_TYPES[kind])
                read = np.dtype(order + _PLY_TYPES[kind] if order else "f8")
                elements[-1].properties.append(_PlyColumn(name, read, full_scale(in_file)))
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
    if end <= len(body) or not lists:
        table = np.frombuffer(body, row, min(rows, (len(body) - at) // row.itemsize), at)
        if len(table) < rows:
            raise IndexError(len(table))
        counts = {p.name: table[f"length of {p.name}"] for p in lists}
        if all((count == count[0]).all() for count in counts.values()):
            columns = {p.name: table[p.name].ravel() for p in properties}
            return columns, {name: c.astype(np.int64) for name, c in counts.items()}, end

    # Otherwise every row has to be looked at to find the next one.
    spans = array("q")
    try:
        for _ in range(rows):
            places, at = _ply_row(properties, body, at)
            spans.extend(places)
    except IndexError:
        raise IndexError(len(spans) // (2 * len(properties))) from None
    starts, lengths = np.moveaxis(np.array(spans).reshape(rows, len(properties), 2), 2, 0)
    octets = np.frombuffer(body, dtype=np.uint8)
    columns = {}
    for i, p in enumerate(properties):
        item = np.arange(lengths[:, i].sum())
        item -= np.repeat(np.cumsum(lengths[:, i]) - lengths[:, i], lengths[:, i])
        first = np.repeat(starts[:, i], lengths[:, i]) + item * p.kind.itemsize
        items = octets[first[:, None] + np.arange(p.kind.itemsize)]
        columns[p.name] = np.ascontiguousarray(items).view(p.kind).ravel()
    return columns, {p.name: lengths[:, properties.index(p)] for p in lists}, at


def _ply_row(properties: list[_PlyColumn], body: bytes, at: int) -> tuple[list[int], int]:
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


_READERS: dict[str, Callable[[MeshSource], Mesh]] = {
    ".obj": _read_obj,
    ".stl": _read_stl,
    ".ply": _read_ply,
    ".gltf": read_gltf,
    ".glb": read_gltf,
}
ENDINGS = tuple(_READERS)
"""Endings of the mesh files that `load` reads."""
