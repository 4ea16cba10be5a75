"""The orthographic lens: glOrtho, in lecture 001's steps; and the base of parallel lenses.

Their projectors are parallel: w is 1, and depth is linear in the distance.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, ClassVar, cast

import numpy as np

from app.arithmetic.rationals import Rationals
from app.model.lenses.answers import Axes, Window
from app.model.lenses.lens import EyeLens, Lens, LensTable, Seen, Windowed
from app.model.lenses.solving import ends
from app.model.limits import Array, Keep
from app.model.refusal import QT_TRANSLATE_NOOP
from app.model.tables import DEPTH_RANGE, NO_M_PP, PipelineStep, matrix


@dataclass(frozen=True)
class Parallel(EyeLens):
    """A lens whose projectors are parallel: objects look equally large at every distance."""

    parallel: ClassVar[bool] = True
    shape: ClassVar[str] = QT_TRANSLATE_NOOP("phenomena", "box")
    # View and near - w, cotangent 4, product, sum, and middle, extent, quotient; w is 1.
    roundings: ClassVar[tuple[float, float, float, float]] = (12.0, 12.0, 12.0, 0.0)

    def stretch(self, window: Window) -> float:
        left, right, bottom, top = window
        across, up = max(abs(left), abs(right)), max(abs(bottom), abs(top))
        half_width, half_height = (right - left) / 2.0, (top - bottom) / 2.0
        depth = max(abs(self.near), abs(self.far))
        shear_x, shear_y = (abs(cot) for cot in self.shear)
        extent = self.far - self.near
        distance = math.hypot(across + shear_x * extent, up + shear_y * extent, depth)
        return distance * max((1.0 + shear_x) / half_width, (1.0 + shear_y) / half_height)

    def cell_sizes(self, cells: Array) -> Array:
        sizes = np.abs(cells)
        sizes[:2, 3] += 2.0 * sizes[:2, 2] * abs(self.near)
        return sizes

    # -- points

    def pictured(
        self, axes: Axes, aspect: float, x: Array, y: Array, distance: Array
    ) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        cot_alpha, cot_beta = self.shear
        before = self.near - distance
        x_axis, y_axis = axes()
        ndc = x_axis.across(x + cot_alpha * before), y_axis.across(y + cot_beta * before)
        return ndc, ndc

    def depth_over_w(self, distance: Array, rest: Array, *, reverse: bool) -> tuple[Array, Array]:
        near, far = self.near, self.far
        # Between planes that nearly touch, the depth consists only of the rounding errors.
        from_plane = (far - distance) + rest if reverse else (distance - near) - rest
        depth = from_plane / (far - near)
        return depth, depth

    def nearer_by(self, distance: float, height: float, down_px: float, height_px: int) -> float:
        return distance - height * down_px / height_px

    # -- as another lens

    @classmethod
    def showing(cls, seen: Seen) -> Lens:
        """Keep the window in the plane of the target."""
        lens, distance = seen.lens, seen.distance
        far = max(4.0 * distance, 2.0 * lens.near) if lens.far == math.inf else lens.far
        window = lens.window_at(seen.window, distance)
        return cls.with_window_at(distance, window, lens.near, far, getattr(lens, "keep", "y"))

    @classmethod
    def with_window_at(
        cls, distance: float, window: Window, near: float, far: float, keep: Keep
    ) -> Lens:
        lens = cast(Any, cls)(*window, near, far, keep)
        left, right, bottom, top = window
        x, y = (cot * (distance - near) for cot in lens.shear)
        moved = {"left": left - x, "right": right - x, "bottom": bottom - y, "top": top - y}
        return cast(Lens, replace(lens, **moved))

    @classmethod
    def solutions_for(
        cls, cells: Rationals, near: float, far: float, in_hand: Lens
    ) -> Iterator[Lens]:
        leaning, cots = cls._leaning(cells, in_hand)
        if in_hand.kind == cls.kind:
            yield in_hand.replaced(near=near, far=far, **leaning)
        sides: list[float] = []
        for i, (row, cot) in enumerate(zip(cells[:2], cots, strict=True)):
            sides += ends(row[i], row[i] * cot * Fraction(near) - row[3], Fraction(1))
        yield cast(Any, cls)(*sides, near, far, **leaning)

    @classmethod
    def _leaning(
        cls, cells: Rationals, in_hand: Lens
    ) -> tuple[dict[str, float], Sequence[Fraction]]:
        """The fields of the projectors' slant, and the `shear` in rationals."""
        return {}, (Fraction(0), Fraction(0))

    def least_terms(self, row: Sequence[Fraction], number: int) -> tuple[Fraction, ...]:
        nothing, one = Fraction(0), Fraction(1)
        if number > 1:
            return nothing, nothing, one, one
        return nothing, nothing, abs(row[number]), max(one, abs(row[2] * Fraction(self.near)))


TRANSLATION = """
    1  0  0  -(r + l)/2
    0  1  0  -(t + b)/2
    0  0  1  n
    0  0  0  1
"""
SCALE = """
    2/(r - l)  0          0          0
    0          2/(t - b)  0          0
    0          0          1/(f - n)  0
    0          0          0          1
"""
"""Scales to the box with x, y from -1 to 1 and z from 0 at near to -1 at far."""

W_IS_ONE = """
    1  0  0  0
    0  1  0  0
    0  0  1  0
    0  0  0  1
"""
"""The identity in place of the perspective lens's step that makes w the distance."""

CLIP_FROM_VIEW = """
    2/(r - l)  0          0  -(r + l)/(r - l)
    0          2/(t - b)  0  -(t + b)/(t - b)
    0          0          A  B
    0          0          0  1
"""
VIEW_FROM_CLIP = """
    (r - l)/2  0          0  (r + l)/2
    0          (t - b)/2  0  (t + b)/2
    0          0          C  D
    0          0          0  1
"""
DEPTH = {
    "A": "(z_n - z_f)/(f - n)",
    "B": "(z_n*f - z_f*n)/(f - n)",
    "C": "(f - n)/(z_n - z_f)",
    "D": "-(z_n*f - z_f*n)/(z_n - z_f)",
}
"""Of ``z_clip = A z_view + B``, which is z_n at near and z_f at far, and back: ``C z + D``."""

AS_002_WRITES = {
    "1/(f - n)": "-1/(n - f)",
    "-1/(f - n)": "1/(n - f)",
    "-2/(f - n)": "2/(n - f)",
    "(f + n)/(f - n)": "-(n + f)/(n - f)",
}
"""Lecture 002's forms of our formulas; its n and f are the negative z of the planes."""


def box_table(factors: Mapping[str, str], clip_from_view: str, view_from_clip: str) -> LensTable:
    """The table of a parallel lens; arguments as in `perspective.pyramid_tables`."""
    to_box = tuple((name, matrix(text)) for name, text in factors.items())
    return LensTable(
        (
            PipelineStep("canonical_parallel_from_view", to_box),
            PipelineStep("canonical_parallel_from_canonical_perspective", note=NO_M_PP),
            DEPTH_RANGE,
            PipelineStep("clip_from_depth_range", (("scale", matrix(W_IS_ONE)),)),
        ),
        matrix(clip_from_view, **DEPTH),
        matrix(view_from_clip, **DEPTH),
        written={"002": AS_002_WRITES},
    )


TABLE = box_table({"scale": SCALE, "translation": TRANSLATION}, CLIP_FROM_VIEW, VIEW_FROM_CLIP)


@dataclass(frozen=True)
class Orthographic(Parallel, Windowed):
    """The orthographic lens (glOrtho); near may be negative, behind the eye."""

    kind: ClassVar[str] = "orthographic"
    tables: ClassVar[tuple[LensTable, ...]] = (TABLE,)

    left: float = -4.0
    right: float = 4.0
    bottom: float = -4.0
    top: float = 4.0
