"""How the commands write numbers: in full, and in columns aligned at their points."""

import itertools
from collections.abc import Sequence
from dataclasses import fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.model.parameters import FAR, KEEP, NEAR
from app.model.projection import Array, Projection
from app.model.refusal import format_value


def plain(array: Array) -> list[Any]:
    """Convert an array to Python floats, whose repr is the shortest exact text; no minus zero."""
    return (array + 0.0).tolist()  # type: ignore[no-any-return]


def lens_line(projection: Projection) -> str:
    """Describe the lens and image in use, with the names of ``--set``."""
    lens = projection.lens
    parts = [f"lens {lens.kind}"]
    if lens.planes is not None:
        values = {field.name: getattr(lens, field.name) for field in fields(lens)}
        keep, near, far = (values.pop(name, None) for name in (KEEP.name, NEAR.name, FAR.name))
        parts += [f"{name} {format_value(value)}" for name, value in values.items()]
        if keep is not None:
            typed, used = tuple(values.values())[:4], projection.window
            parts.append(f"keep {keep}")
            if used != typed:
                parts[-1] += f" (uses {', '.join(map(format_value, used))})"
        parts += [f"near {format_value(near)}", f"far {format_value(far)}"]
    width, height = projection.image_size
    return ", ".join([*parts, f"image {width}x{height}", f"depth {projection.depth}"])


def lengths(texts: Sequence[str]) -> tuple[NDArray[np.int_], NDArray[np.int_]]:
    """Return the length of each text, and of its part before the point or exponent."""
    length = np.fromiter(map(len, texts), int, len(texts))
    point = np.fromiter(map(str.find, texts, itertools.repeat(".")), int, len(texts))
    for i in np.flatnonzero(point < 0).tolist():
        point[i] = len(texts[i].partition("e")[0])
    return length, point


def widths(length: NDArray[np.int_], before: NDArray[np.int_]) -> list[int]:
    """Return the width to which each text is padded on the left to form columns.

    In each table the numbers of a column are aligned at their decimal points. `lengths` counts
    `length` and `before`, here (tables, rows, columns). Lengths 0, at the end of a short row, get
    no padding.
    """
    after = length - before
    left, right = before.max(axis=1), after.max(axis=1)
    point = np.cumsum(left + right + 2, axis=1) - right - 2
    filled = np.diff(point[:, None] + after, axis=2, prepend=0)
    filled[length == 0] = 0
    return filled.ravel().tolist()  # type: ignore[no-any-return]
