"""A mesh read from a file, and the refusals of faulty files.

The readers of the formats (`app.scenes.mesh_files`, `app.scenes.gltf`) share this module. Mesh
files come from strangers: a reader compares every claim of a file with the bytes present, and with
`LARGEST`, before it allocates memory.
"""

import codecs
import os
import warnings
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO, NoReturn, TypeAlias, cast

import numpy as np
from numpy.typing import NDArray

from app.model.refusal import REFUSALS, Bound, Cancelled, Refusal
from app.strangers import encoding_of, open_regular

Floats: TypeAlias = NDArray[np.float64]
Ints: TypeAlias = NDArray[np.int64]
Colours: TypeAlias = NDArray[np.uint8]
Progress: TypeAlias = Callable[[float], bool]

LARGEST = 20_000_000, 2 * 2**30  # most triangles of a mesh, and bytes of its triangles and vertices
MOST_CORNERS = 100_000  # most corners of a face: its division into triangles takes some seconds
PAINT_RGB = (184, 194, 208)  # colour of a surface whose file has no colours


@dataclass(eq=False)
class Mesh:
    """Points of a file, and the polygons, lines and dots that it draws with them.

    - `points` (n, 3): world coordinates.
    - `offsets` (m + 1,): face i has the corners ``corners[offsets[i]:offsets[i + 1]]``.
    - `corners` (offsets[m],): indices into `points`.
    - `rgb` (m, 3): colour of each face, if the file has colours.
    - `painted`: whether `rgb` was scanned or painted, and is shown unchanged. A material's colour
      is shaded first: without shading it shows no shape.
    - `lines` (k, 2): ends of line segments: indices into `points`.
    - `dots` (d,): points that are drawn by themselves: indices into `points`.
    - `dot_rgb` (d, 3): colour of each dot, if the file has colours.
    - `rows` (n,), (m,), (k,) and (d,): for "points", "faces", "lines" and "dots" of a text: the
      line that each is on.
    - `notes`: templates and parts of sentences, like those of a refusal, that say what was left
      out.
    """

    points: Floats = field(default_factory=lambda: np.empty((0, 3)))
    offsets: Ints = field(default_factory=lambda: np.zeros(1, dtype=np.int64))
    corners: Ints = field(default_factory=lambda: np.empty(0, dtype=np.int64))
    rgb: Colours | None = None
    painted: bool = False
    lines: Ints = field(default_factory=lambda: np.empty((0, 2), dtype=np.int64))
    dots: Ints = field(default_factory=lambda: np.empty(0, dtype=np.int64))
    dot_rgb: Colours | None = None
    rows: dict[str, Ints] = field(default_factory=dict)
    notes: list[tuple[Any, ...]] = field(default_factory=list)

    def check(self, path: Path) -> None:
        """Refuse a mesh with nothing to draw, or with something that cannot be drawn."""
        vertices, sizes = len(self.points), np.diff(self.offsets)
        for size in (int(sizes.min()), int(sizes.max())) if len(sizes) else ():
            if not 3 <= size <= MOST_CORNERS:
                raise Refusal.saying(REFUSALS["face-size"], path, size, MOST_CORNERS)
        for kind, named in self._named.items():
            wrong = np.flatnonzero((named < 0) | (named >= vertices))
            if wrong.size and kind in self.rows:
                line = self._line_of(kind, int(wrong[0]))
                raise Refusal.saying(REFUSALS["no-such-vertex-line"], path, line, vertices)
            if wrong.size:
                raise Refusal.saying(REFUSALS["no-such-vertex"], path, vertices)
        is_lost = np.asarray(~np.isfinite(self.points).all(axis=1))
        if is_lost.any():
            self._drop_lost_points(path, is_lost)
        if not (len(sizes) or self.lines.size or self.dots.size):
            raise Refusal.saying(REFUSALS["no-faces"], path, vertices)

    @property
    def _named(self) -> dict[str, Ints]:
        return {"faces": self.corners, "lines": self.lines.ravel(), "dots": self.dots}

    def _line_of(self, kind: str, place: int) -> int:
        """Return the line of a text to which a place in `_named` belongs."""
        if kind == "faces":
            place = int(np.searchsorted(self.offsets, place, side="right")) - 1
        return int(self.rows[kind][place // (1 + (kind == "lines"))])

    def _drop_lost_points(self, path: Path, is_lost: NDArray[np.bool_]) -> None:
        """Drop dots that are not finite; refuse faces and lines with such vertices."""
        for kind in ("faces", "lines"):
            uses = np.flatnonzero(is_lost[self._named[kind]])
            if uses.size and kind in self.rows:
                line = int(self.rows["points"][self._named[kind][uses[0]]])
                raise Refusal.saying(
                    REFUSALS["not-finite-line"], path, line, self._line_of(kind, int(uses[0]))
                )
            if uses.size or is_lost.all():
                raise Refusal.saying(REFUSALS["not-finite"], path, int(is_lost.sum()), len(is_lost))
        is_kept = ~is_lost[self.dots]
        self.dots = self.dots[is_kept]
        self.dot_rgb = None if self.dot_rgb is None else self.dot_rgb[is_kept]
        self._note(REFUSALS["unused"], REFUSALS["unused-line"], "points", is_lost)

    def drop_small_faces(self, path: Path) -> None:
        """Drop the faces of fewer than three different corners."""
        sizes = np.diff(self.offsets)
        is_small = np.asarray(sizes < 3)
        which = np.flatnonzero(~is_small)
        if which.size:
            # What is left of a face without its first corner, and without one other corner.
            starts, kept = np.cumsum(sizes[which]) - sizes[which], np.repeat(~is_small, sizes)
            corners = self.corners[kept]
            one = np.repeat(corners[starts], sizes[which])
            others = np.where(corners == one, np.iinfo(np.int64).max, corners)
            other = np.repeat(np.minimum.reduceat(others, starts), sizes[which])
            is_third = (corners != one) & (corners != other)
            is_small[which] = ~np.logical_or.reduceat(is_third, starts)
        if not is_small.any():
            return
        self._note(REFUSALS["few-corners"], REFUSALS["few-corners-line"], "faces", is_small)
        if is_small.all() and not (self.lines.size or self.dots.size):
            template, *parts = self.notes[-1]
            raise Refusal.saying(template, path, *parts)
        self.corners = self.corners[np.repeat(~is_small, sizes)]
        self.offsets = np.concatenate([[0], np.cumsum(sizes[~is_small])])
        if self.rgb is not None:
            self.rgb = self.rgb[~is_small]
        if "faces" in self.rows:
            self.rows["faces"] = self.rows["faces"][~is_small]

    def _note(self, numbered: Bound, on_line: Bound, kind: str, which: NDArray[np.bool_]) -> None:
        """Note that some points or faces are left out, and which is the first."""
        first = int(which.argmax())
        template, place = numbered, first + 1
        if kind in self.rows:
            template, place = on_line, int(self.rows[kind][first])
        self.notes.append((template, int(which.sum()), len(which), place))

    def drop_unused_points(self) -> None:
        """Drop the vertices that are not drawn: they would move the first camera away."""
        used = np.zeros(len(self.points), dtype=bool)
        for named in (self.corners, self.lines, self.dots):
            used[named] = True
        if not used.all():
            number = np.cumsum(used) - 1
            self.corners, self.lines = number[self.corners], number[self.lines]
            self.dots = number[self.dots]
            self.points = self.points[used]

    def paint(self, colours: NDArray[np.floating]) -> None:
        """Colour dots, and faces with the mean of their corners' colours (n, 3), 0 to 255."""
        if self.dots.size and self.dots.min() >= 0 and self.dots.max() < len(colours):
            self.dot_rgb = rgb_bytes(colours[self.dots])
        sizes = np.diff(self.offsets)
        is_sound = len(sizes) and sizes.min() > 0 and self.corners.min() >= 0
        if not is_sound or self.corners.max() >= len(colours):
            return  # `check` will refuse this mesh
        sums = np.add.reduceat(colours.astype(np.float32)[self.corners], self.offsets[:-1], axis=0)
        self.rgb = rgb_bytes(sums / sizes.astype(np.float32)[:, None])
        self.painted = True


@dataclass(frozen=True)
class MeshSource:
    """A file that is being read; `largest` is as `LARGEST`."""

    path: Path
    file: BinaryIO
    progress: Progress | None
    largest: tuple[int, int]

    @property
    def size(self) -> int:
        """Size of the file in bytes."""
        return os.fstat(self.file.fileno()).st_size

    def report(self, fraction: float) -> None:
        report(self.progress, fraction)

    def check_size(self, vertices: int, faces: int, corners: int) -> None:
        """Refuse too many vertices, faces or corners before memory is allocated for them."""
        most, most_bytes = self.largest
        triangles = max(faces, corners - 2 * faces)
        # The factor 2: parts of a mesh are joined in a second copy.
        needed = 2 * (24 * vertices + 8 * corners) + (8 + 8) * faces
        if triangles > most or needed > most_bytes:
            limits = triangles, needed >> 20, most, most_bytes >> 20
            raise Refusal.saying(REFUSALS["too-much"], self.path, *limits)

    def fail(self, what: str) -> NoReturn:
        """Refuse the file because of an unsupported word of its format."""
        raise Refusal.saying(REFUSALS["damaged"], self.path, what)


def numbers_in(
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


def wrong_line(lines: list[bytes], read_lines: Callable[[list[bytes]], object]) -> int:
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


def joins_left_out(triangles: Ints) -> Ints:
    """Return the triangles (n, 3) of strips without those that only lead to the next strip."""
    return np.asarray(triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)])


def report(progress: Progress | None, fraction: float) -> None:
    """Report the progress; raise `Cancelled` if the work is no longer wanted."""
    if progress is not None and not progress(fraction):
        raise Cancelled


def open_mesh(path: Path) -> BinaryIO:
    """Open a file that is not empty, a text as UTF-8 without a mark; or raise a `Refusal`."""
    try:
        file = open_regular(path)
    except FileNotFoundError:
        raise Refusal.saying(REFUSALS["mesh-no-file"], path) from None
    except OSError as error:
        raise Refusal.saying(REFUSALS["unreadable"], path, error.strerror) from None
    except ValueError as error:  # a zero byte, or a name that no file of this system can have
        raise Refusal.saying(REFUSALS["unreadable"], repr(str(path)), error) from None
    if os.fstat(file.fileno()).st_size == 0:
        file.close()
        raise Refusal.saying(REFUSALS["mesh-empty"], path)
    head = file.read(4096)
    file.seek(0)
    encoding = encoding_of(head)
    if encoding == "utf-8" or (encoding == "utf-8-sig" and b"\0" in head):
        return file
    return cast(BinaryIO, codecs.EncodedFile(file, "utf-8", encoding, "replace"))


def rgb_bytes(colours: NDArray[np.floating]) -> Colours:
    """Round colours from 0 to 255 to bytes; NaN becomes 0."""
    return np.asarray(np.clip(np.rint(np.nan_to_num(colours)), 0, 255).astype(np.uint8))


def full_scale(kind: np.dtype[Any]) -> float:
    """The number that means full brightness in a colour channel of this type."""
    return 1.0 if kind.kind == "f" else float(np.iinfo(kind).max)
