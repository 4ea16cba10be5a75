"""What a pasted matrix may mean: by rows or by columns, in the convention of another program."""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from app.lecture.typed_matrix import (
    MatrixProperty,
    Write,
    convention,
    few,
    readings,
    recognised_camera,
    rounded_view,
    with_matrix,
)
from app.model.lenses.answers import Intrinsics
from app.model.limits import Array, finite_matrix
from app.model.projection import Projection
from app.model.refusal import MATRIX, REFUSALS, Refusal


class Pasted(NamedTuple):
    """A projection that has a pasted matrix, and what the matrix means."""

    projection: Projection
    properties: list[MatrixProperty]


def pasted(
    projection: Projection, name: str, rows: Sequence[Sequence[float]], write: Write = few
) -> list[Pasted]:
    """Return what a matrix of `read_matrix` may mean as one of the `EDITABLE` matrices.

    There are several meanings only if each is a camera or a lens. If none is, the matrix is free.
    Raises a `Refusal` for a cell that the matrix cannot have, and for 9 or 12 numbers of no camera.
    """
    if name == "view_from_world":
        return _views(projection, rows, write)
    if len(rows) == 3 and len(rows[0]) == 3:
        (fx, skew, cx), (other, fy, cy), last = rows
        if skew == other == 0.0 and list(last) == [0.0, 0.0, 1.0]:
            return [Pasted(projection.with_intrinsics(Intrinsics(fx, fy, cx, cy)), [])]
    if len(rows) < 4 or len(rows[0]) < 4:
        raise Refusal(name, tuple(map(tuple, rows)), REFUSALS["no-camera"])
    cells, former = finite_matrix(name, rows), projection.lens.former
    possible = []
    for reading in readings(cells, projection.image_size, projection.depth, former):
        shown = replace(projection, lens=reading.lens, depth=reading.depth)
        if not projection.has_camera:
            cells_of_lens = shown.clip_from_view.tolist()
            shown = with_matrix(replace(projection, depth=reading.depth), name, cells_of_lens)
        said = convention(reading, projection, write)
        if reading.z < 0:
            said.append(MatrixProperty(MATRIX["is-turned"], ("3" if reading.y > 0 else "2, 3",)))
        elif reading.y < 0:
            said.append(MatrixProperty(MATRIX["is-upright"]))
        possible.append(Pasted(shown, said))
    return possible or [Pasted(with_matrix(projection, name, cells), [])]


def _views(projection: Projection, rows: Sequence[Sequence[float]], write: Write) -> list[Pasted]:
    given = np.array(rows)
    is_alike = given.shape[0] != given.shape[1] or np.array_equal(given, given.T)
    matrices = [_affine(each, projection) for each in ((given,) if is_alike else (given, given.T))]
    matrix, possible = matrices[0], []
    for turned in matrices:
        cells = finite_matrix("view_from_world", turned.tolist())
        if recognised_camera(cells, projection.camera) is None:
            continue
        shown = with_matrix(projection, "view_from_world", cells)
        ahead = (-shown.camera.frame[2] + 0.0).tolist()
        eye, along = (", ".join(write(part) for part in p) for p in (shown.camera.eye, ahead))
        said = [
            MatrixProperty(MATRIX["of-a-camera"], (eye, along)),
            *rounded_view(shown, cells, write),
        ]
        said = [MatrixProperty(MATRIX["for-rows"]), *said] if turned is not matrix else said
        possible.append(Pasted(shown, said))
    if possible:
        return possible
    is_for_rows = bool(matrix[3, :3].any()) and not matrix[:3, 3].any()
    cells = finite_matrix("view_from_world", (matrix.T if is_for_rows else matrix).tolist())
    shown = with_matrix(projection, "view_from_world", cells)
    return [Pasted(shown, [MatrixProperty(MATRIX["for-rows"])] if is_for_rows else [])]


def _affine(matrix: Array, projection: Projection) -> Array:
    """Complete 9 or 12 numbers to a view matrix, (4, 4); a rotation, (3, 3), keeps the eye."""
    if matrix.shape == (4, 3):
        matrix = matrix.T
    if matrix.shape == (3, 3):
        matrix = np.column_stack([matrix, -matrix @ projection.camera.eye])
    return matrix if len(matrix) == 4 else np.vstack([matrix, [0.0, 0.0, 0.0, 1.0]])
