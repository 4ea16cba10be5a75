"""Read meshes from OBJ, STL, PLY and glTF files in float64, or refuse them in one sentence.

These readers use Python and numpy only, which cannot run past the end of an array.
`docs/meshes.md` has the measurements against a library: none of those tried meets the time limit
and keeps the coordinates for every format.
"""

import codecs
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from app.model.refusal import REFUSALS, Cancelled, Refusal
from app.scenes.gltf import read_gltf
from app.scenes.mesh import (
    LARGEST,
    Colours,
    Floats,
    Ints,
    Mesh,
    MeshSource,
    Progress,
    numbers_in,
    open_mesh,
    report,
    wrong_line,
)
from app.scenes.ply import read_ply
from app.scenes.shapes import distinct_rows

_MARK, _NO_BREAK = codecs.BOM_UTF8, "\xa0".encode()
BLOCK = 1 << 24  # bytes of text in a block; progress is reported after each block


def read(path: Path, progress: Progress | None = None, largest: tuple[int, int] = LARGEST) -> Mesh:
    """Read a mesh file with one of `ENDINGS`; `largest` is as `LARGEST`.

    The mesh has at least a face, a line or a dot, and no vertex that is not drawn. `progress` is
    called now and then with the fraction done, from 0 to 1, on the caller's thread. When it returns
    False, reading stops with a `Cancelled`.

    Raises a `Refusal` for a file that cannot be read or holds nothing to draw.
    """
    with open_mesh(path) as file:
        report(progress, 0.0)
        try:
            with np.errstate(all="ignore"):  # `check` refuses numbers that are not finite
                mesh = _READERS[path.suffix.lower()](MeshSource(path, file, progress, largest))
            mesh.check(path)
        except MemoryError:
            raise Refusal.saying(REFUSALS["no-memory"], path) from None
        except (Refusal, Cancelled):
            raise
        except Exception as error:  # no reader can foresee everything in a stranger's file
            raise Refusal.saying(REFUSALS["damaged"], path, type(error).__name__) from error
    mesh.drop_unused_points()
    return mesh


# --------------------------------------------------------------------------- OBJ


def _read_obj(source: MeshSource) -> Mesh:
    """Read vertices, their colours, faces, lines and points; normals and so on are ignored.

    Vertices alone are a cloud of points.
    """
    points, colours = [], []
    none = np.empty(0, dtype=np.int64)
    corners, counts, lines_of = ({kind: [none] for kind in "vflp"} for _ in range(3))
    vertices = elements = cornered = lines_before = 0
    for text in _obj_blocks(source.file):
        try:
            rows, named, lines_in = _obj_mesh(text)
        except ValueError:
            lines = text.splitlines(keepends=True)
            wrong = lines_before + wrong_line(lines, lambda some: _obj_mesh(b"".join(some)))
            raise Refusal.saying(REFUSALS["damaged-line"], source.path, wrong, "OBJ") from None
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
        elements += sum(map(text.count, (b"\ncurv", b"\nsurf", b"\nfo ")))  # without a cloud's dots
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
        text = text.replace(_MARK, b"")  # of a file that was joined to another
        text = text.replace(_NO_BREAK, b" ")
        text = text.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
        if b"1.#" in text:  # what Microsoft's C library writes for nan and inf
            text = re.sub(rb"[-+]?1\.#(?:IND|INF|[QS]NAN)\d*", b"nan", text)
        if b"#" in text:  # first: a folder at the end of one may end with a backslash
            text = re.sub(rb"#[^\n]*", b"", text)
        if b"\\" in text:
            # A joined line keeps its number, and those after it keep theirs.
            text = re.sub(
                rb"^(?:[^\n]*\\\n)+[^\n]*",
                lambda m: m[0].replace(b"\\\n", b" ") + b"\n" * m[0].count(b"\\\n"),
                text,
                flags=re.MULTILINE,
            )
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
    return numbers_in(text.tobytes(), kind, len(word_begins)), words


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
    turned = int.from_bytes(head[80:84], "big")
    if len(head) >= 84 and turned != count and 84 + 50 * turned == source.size > 84:
        raise Refusal.saying(REFUSALS["unsupported"], source.path, "big-endian")
    if len(head) >= 84 and count <= present:
        corners = _stl_binary(source, count)
    elif b"\0" in head and len(head) >= 84 and count <= LARGEST[0]:
        raise Refusal.saying(REFUSALS["cut-off-triangles"], source.path, present, count)
    elif re.match(rb"(?:\s*#[^\n]*\n)*\s*(solid|facet\s)", head, re.IGNORECASE):
        corners = _stl_text(source)
    else:
        raise Refusal.saying(REFUSALS["not-of-kind"], source.path, "STL")
    source.report(0.3)
    points, merged = distinct_rows(corners)
    source.report(0.4)
    mesh = Mesh(points, np.arange(0, len(corners) + 1, 3), merged)
    mesh.drop_small_faces(source.path)
    return mesh


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
            numbers = numbers_in(b" ".join(loops).replace(b"vertex", b"").replace(b"end", b""))
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
    if re.search(rb"vertex|\bfacet", _without_stl_names(rest)):
        raise Refusal.saying(REFUSALS["cut-off"], source.path)
    return np.concatenate(blocks).reshape(-1, 3)


def _refuse_stl_line(source: MeshSource) -> None:
    """Refuse the first vertex that is not three finite numbers, or loop that is no triangle."""
    source.file.seek(0)
    facet = corners = 0
    for number, line in enumerate(source.file, 1):
        words = line.lower().split()
        facet = number if words[:1] == [b"facet"] else facet
        if words[:1] == [b"endloop"] and corners != 3:
            raise Refusal.saying(REFUSALS["damaged-line"], source.path, facet, "STL")
        corners = corners + 1 if words[:1] == [b"vertex"] else 0
        if corners:
            try:
                numbers = numbers_in(b" ".join(words[1:]))
            except ValueError:
                numbers = np.empty(0)
            if len(numbers) != 3:
                raise Refusal.saying(REFUSALS["damaged-line"], source.path, number, "STL")
            if not np.isfinite(numbers).all():
                raise Refusal.saying(REFUSALS["not-finite-line"], source.path, number, facet)


def _without_stl_names(text: bytes) -> bytes:
    """Drop the names after “solid” and “endsolid”, which may contain any words."""
    return re.sub(rb"solid[^\n]*?(?=facet\s+normal\s+(?:[-+.\d]|nan|inf)|\n|\Z)", b"", text)


_READERS: dict[str, Callable[[MeshSource], Mesh]] = {
    ".obj": _read_obj,
    ".stl": _read_stl,
    ".ply": read_ply,
    ".gltf": read_gltf,
    ".glb": read_gltf,
}
ENDINGS = tuple(_READERS)  # endings of the mesh files that `load` reads
