"""The orthographic lens: glOrtho, in lecture 001's steps; and the base of parallel lenses.

Their projectors are parallel: w is 1, and depth is linear in the distance.
"""

import math
from collections.abc import Iterator, Sequence
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
from app.model.tables import DEPTH_RANGE, NO_M_PP, PipelineStep, formulas_of, matrix_of


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


def box_table(lens: str, *more: str) -> LensTable:
    """The table of a parallel lens from the page of matrices; `more` are its own factors."""
    factors = {"scale": "orthographic", "translation": "orthographic", **dict.fromkeys(more, lens)}
    to_box = tuple((name, matrix_of(f"{of} {name}")) for name, of in factors.items())
    depth = formulas_of("orthographic depth")
    return LensTable(
        (
            PipelineStep("canonical_parallel_from_view", to_box),
            PipelineStep("canonical_parallel_from_canonical_perspective", note=NO_M_PP),
            DEPTH_RANGE,
            PipelineStep("clip_from_depth_range", (("scale", matrix_of("orthographic w")),)),
        ),
        matrix_of(f"{lens} clip_from_view", **depth),
        matrix_of(f"{lens} view_from_clip", **depth),
        written={"002": formulas_of("orthographic in lecture 002")},
    )


TABLE = box_table("orthographic")


@dataclass(frozen=True)
class Orthographic(Parallel, Windowed):
    """The orthographic lens (glOrtho); near may be negative, behind the eye."""

    kind: ClassVar[str] = "orthographic"
    tables: ClassVar[tuple[LensTable, ...]] = (TABLE,)

    cut = Lens.cut  # the window is the same on every plane
