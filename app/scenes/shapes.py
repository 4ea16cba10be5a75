"""Simple shapes in flat colours, from which the built-in scenes are built.

Faces are quads ``(m, 4, 3)`` and lines are segments ``(m, 2, 3)``, both float64, with a colour
``(m, 3)`` uint8 each: a `Coloured`.
"""

import math
from collections.abc import Sequence
from functools import cache
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.model.projection import Camera, Perspective, Projection, Vector

Floats: TypeAlias = NDArray[np.float64]
Colours: TypeAlias = NDArray[np.uint8]
Coloured: TypeAlias = tuple[Floats, Colours]

SIZES = 4  # size classes of cells with their own boxes: as large as the scene, half as large, ...

# --------------------------------------------------------------------------- colours

# Okabe-Ito, one hue for each axis, the lighter shade on the positive side. The two sides of an axis
# differ in lightness, also in a grey picture and for any colour vision.
SIDE_RGB = np.array(
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
EDGE_RGB = (72, 72, 78)  # dark on a face, and still visible on a dark background
GRID_RGB = (158, 158, 158)
GRID_AXIS_RGB = (105, 105, 105)
DRAWN_RGB = (86, 122, 168)  # lines and dots of a file: seen on a light and on a dark background
OUTLINE_RGB = (96, 96, 96)
PLATE_RGB = (245, 242, 230)

# Directions to the two lights, and their strengths. The ambient part keeps the darkest face
# visible on a dark background, the sum stays below 1 on a light one.
_AMBIENT = 0.42
_LIGHTS = (((0.25, 0.80, 0.55), 0.50), ((-0.62, -0.25, -0.74), 0.24))


def brightness(normals: Floats) -> Floats:
    """Return the brightness (m,) of faces with unit normals (m, 3) under two soft lights."""
    light = np.full(len(normals), _AMBIENT)
    for direction, strength in _LIGHTS:
        light += strength * np.clip(normals @ np.array(direction), 0.0, None)
    return light


# --------------------------------------------------------------------------- quads and lines


def flat(rgb: ArrayLike, count: int) -> Colours:
    return np.array(np.broadcast_to(np.asarray(rgb, dtype=np.uint8), (count, 3)))


def joined(*parts: Coloured) -> Coloured:
    return np.concatenate([p for p, _ in parts]), np.concatenate([rgb for _, rgb in parts])


def box_faces(lower: Sequence[float], upper: Sequence[float]) -> Floats:
    """Return the faces (6, 4, 3) +x, -x, +y, -y, +z, -z, counter-clockwise from outside."""
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


def box_corners(lower: ArrayLike, upper: ArrayLike) -> Floats:
    """Return the corners (8, 3) of a box: x changes first, then y, then z."""
    which = np.array([[i >> axis & 1 for axis in range(3)] for i in range(8)], dtype=bool)
    return np.where(which, upper, lower)


def distinct_rows(rows: NDArray[Any]) -> tuple[NDArray[Any], NDArray[np.intp]]:
    """Return the distinct rows, sorted, and the index of each given row in them.

    `numpy.unique` does the same, but is slower for many rows, and imports masked arrays, which
    costs a twentieth of the program's start.
    """
    order = np.lexsort(rows.T[::-1])
    by_size = rows[order]
    first = np.append(True, (by_size[1:] != by_size[:-1]).any(axis=1))[: len(rows)]
    places = np.empty(len(rows), dtype=np.intp)
    places[order] = np.cumsum(first) - 1
    return by_size[first], places


def boxes_by_size(points: Floats, offsets: NDArray[np.int64], corners: NDArray[np.int64]) -> Floats:
    """Return the ends (n, 2, 3) of boxes around cells of a size class, small cells by place."""
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


def edges_of(quads: Floats) -> Coloured:
    """Return every edge of the quads once."""
    points, corners = distinct_rows(quads.reshape(-1, 3))
    corners = corners.reshape(-1, 4)
    edges = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2)
    edges = distinct_rows(np.sort(edges, axis=1))[0]
    return points[edges], flat(EDGE_RGB, len(edges))


def is_grid(rgb: Colours) -> NDArray[np.bool_]:
    """Return which lines belong to a ground, by their colours, which no other line has."""
    one, other = (np.all(rgb == colour, axis=1) for colour in (GRID_RGB, GRID_AXIS_RGB))
    return np.asarray(one | other)


def ground_grid(
    lower: tuple[float, float],
    upper: tuple[float, float],
    spacing: tuple[float, float],
    height: float,
    origin: Vector = (0.0, 0.0, 0.0),
) -> Coloured:
    """Return ground lines at multiples of the spacing that enclose a rectangle.

    The lines on the world's x and z axes are darker.

    - `lower`, `upper`, `spacing`: world x and z.
    - `height`: world y of the grid.
    - `origin`: world point to which the lines are relative.
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
    rgb = np.where(on_axis[:, None], GRID_AXIS_RGB, GRID_RGB).astype(np.uint8)
    return np.array(along_z + along_x), rgb


def cubes(lowers: Sequence[Vector]) -> Coloured:
    """Return unit cubes by their lower corners, without touching faces."""
    quads, rgb = [], []
    for x, y, z in lowers:
        faces = box_faces((x, y, z), (x + 1.0, y + 1.0, z + 1.0))
        beside_x, beside_y = [(x + 1.0, y, z), (x - 1.0, y, z)], [(x, y + 1.0, z), (x, y - 1.0, z)]
        touching = [*beside_x, *beside_y, (x, y, z + 1.0), (x, y, z - 1.0)]
        for face, colour, beside in zip(faces, SIDE_RGB, touching, strict=True):
            if beside not in lowers:
                quads.append(face)
                rgb.append(colour)
    return np.array(quads), np.array(rgb)


# Column and row of each cube: a stem of five, two more at the top, one more in the middle.
_LETTER_F = ((0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (1, 4), (2, 4), (1, 2))


def letter_f() -> Coloured:
    """Return the letter F of lecture 004 (Horvat): eight unit cubes."""
    return cubes([(column - 1.5, float(row), -0.5) for column, row in _LETTER_F])


LETTER_F = Projection(Camera((5.0, 4.5, 8.0), (0.0, 2.2, 0.0)), Perspective(38.0, 5.0, 12.5))
"""The first projection of the letter F, and of the program."""


@cache
def letter_f_on_grid(
    low: tuple[float, float], high: tuple[float, float]
) -> tuple[Coloured, Coloured]:
    """Return the letter F, and its edges with a grid of unit squares between two corners."""
    return letter_f(), joined(ground_grid(low, high, (1.0, 1.0), 0.0), letter_f_edges())


@cache
def letter_f_edges() -> Coloured:
    """Return every edge of the letter F once."""
    return edges_of(letter_f()[0])


# The seven segments of a digit one unit wide and two high, as (left, bottom, right, top), and
# the segments of each digit.
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


def written_number(number: int, centre: Vector, height: float) -> Floats:
    """Write a number with seven-segment quads (m, 4, 3) that face +z."""
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
