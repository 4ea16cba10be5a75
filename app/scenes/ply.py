"""Read meshes, clouds and lines from PLY files: text, or binary of either byte order."""

import re
from array import array
from typing import Any, NamedTuple, NoReturn, TypeAlias

import numpy as np
from numpy.typing import NDArray

from app.model.refusal import REFUSALS, Refusal
from app.scenes.mesh import (
    Ints,
    Mesh,
    MeshSource,
    full_scale,
    joins_left_out,
    numbers_in,
    rgb_bytes,
    wrong_line,
)

_PLY_TYPES = {
    "char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
    "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4",
    "float": "f4", "double": "f8", "float32": "f4", "float64": "f8",
}  # fmt: skip
_CORNERS = "vertex_indices", "vertex_index", "indices", "vertices"
"""Names of the list of a face's corners, the first two by custom."""
_PLY_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}


_BEYOND = ""  # name of the element of all rows that the header does not count


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


def read_ply(source: MeshSource) -> Mesh:
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
            name = next((name for name in _CORNERS if name in lengths), None)
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
    if _BEYOND in lines_of and (np.diff(mesh.offsets) < 3).any():  # vertices were taken for faces
        raise Refusal.saying(REFUSALS["more-rows"], source.path, int(lines_of[_BEYOND][0]))
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
    return joins_left_out(np.stack([named[i], named[i + 1 + odd], named[i + 2 - odd]], axis=1))


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
        raise Refusal.saying(REFUSALS["not-of-kind"], source.path, "PLY")
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
            raise Refusal.saying(REFUSALS["unsupported"], source.path, f"element {each.name}")
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
    beyond, filled = filled[rows:], filled[:rows]  # what follows is no part of the mesh
    body = body[: line_ends[filled[-1]] if filled.size else 0]
    try:
        numbers = numbers_in(body, words=int(ends[filled[-1]]) if filled.size else 0)
    except ValueError:
        wrong = wrong_line(body.splitlines(), lambda lines: numbers_in(b"\n".join(lines)))
        raise Refusal.saying(REFUSALS["damaged-line"], source.path, before + wrong, "PLY") from None
    if len(filled) == 1 < rows:
        return numbers.tobytes(), {}
    marks, first = np.zeros(len(numbers) + 1, dtype=np.int8), 0
    lines_of = {_BEYOND: before + 1 + beyond} if beyond.size else {}
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
            raise Refusal.saying(REFUSALS["damaged-line"], source.path, line, element.name)
        if len(which) - len(short) < element.rows:
            _refuse_cut_off(source, element, len(which) - len(short))
        marks[at] -= 1
        lines_of[element.name] = before + 1 + which
    is_named = np.cumsum(marks[:-1], dtype=np.int8) > 0
    return (numbers if is_named.all() else numbers[is_named]).tobytes(), lines_of


def _refuse_cut_off(source: MeshSource, element: _Element, there: int) -> NoReturn:
    raise Refusal.saying(REFUSALS["cut-off-rows"], source.path, there, element.rows, element.name)


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
                elements[-1].properties.append(_PlyColumn(name.lower(), kinds[0], 1.0, kinds[1]))
            case ["property", kind, name]:
                in_file = np.dtype(_PLY_TYPES[kind])
                read = np.dtype(order + _PLY_TYPES[kind] if order else "f8")
                elements[-1].properties.append(_PlyColumn(name.lower(), read, full_scale(in_file)))
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
