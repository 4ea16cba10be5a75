"""Lenses whose projectors are parallel: w is 1, and depth is even in the distance."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, ClassVar, cast

import numpy as np

from app.arithmetic.rationals import Rationals
from app.model.lenses.closed_form import ClosedForm
from app.model.lenses.lens import Lens, LensTable, Seen
from app.model.lenses.setup import ExactLens, HalfSpaces, Setup, Window
from app.model.lenses.solving import ends
from app.model.limits import Array, Keep
from app.model.refusal import QT_TRANSLATE_NOOP


@dataclass(frozen=True)
class Parallel(ClosedForm):
    """A lens whose projectors are parallel: pictures are as large wherever things are."""

    parallel: ClassVar[bool] = True
    shape: ClassVar[str] = QT_TRANSLATE_NOOP("phenomena", "box")
    # View and near - w, cotangent 4, product, sum, and middle, extent, quotient; w is 1.
    roundings: ClassVar[tuple[float, float, float, float]] = (12.0, 12.0, 12.0, 0.0)

    def table_to(self, far: float) -> LensTable:
        return self.table

    def section(self, aspect: Fraction) -> Fraction:
        left, right, bottom, top = map(Fraction, self.window(aspect))
        return (right - left) * (top - bottom)

    def volume(self, section: Fraction) -> Fraction:
        return section * (Fraction(self.far) - Fraction(self.near))

    # -- the canonical volumes

    @property
    def canonical_unit(self) -> float:
        return 1.0

    @property
    def canonical_from_box(self) -> Array:
        return np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -1], [0, 0, 0, 1]])

    def edges(self, at: Callable[[float], Array]) -> tuple[Array, Array]:
        first = at(0.0)
        return first, at(-1.0) - first

    # -- distances and depths

    def w(self, distance: Any) -> Any:
        return 1.0

    def depth(self, distance: Array, *, reverse: bool) -> Array:
        from_plane = self.far - distance if reverse else distance - self.near
        return np.asarray(from_plane / (self.far - self.near))

    def distance(self, gone: Any, left_over: Any) -> Any:
        return self.near * left_over + self.far * gone

    def gap(self, distance: Array, step: Array) -> Array:
        return step * (self.far - self.near)

    @property
    def even_extent(self) -> float:
        return self.far - self.near

    # -- points

    def _pictured(
        self, setup: Setup, x: Array, y: Array, distance: Array
    ) -> tuple[tuple[Array, Array], Array, tuple[Array, Array]]:
        cot_alpha, cot_beta = self.shear
        before = self.near - distance
        x_axis, y_axis = setup.axes
        ndc = x_axis.across(x + cot_alpha * before), y_axis.across(y + cot_beta * before)
        return ndc, np.ones_like(distance), ndc

    def _depth_over_w(self, distance: Array, rest: Array, *, reverse: bool) -> tuple[Array, Array]:
        near, far = self.near, self.far
        # Between planes that nearly touch, all that the depth has left is what was cut off.
        from_plane = (far - distance) + rest if reverse else (distance - near) - rest
        depth = from_plane / (far - near)
        return depth, depth

    def _shift(self, x: Sequence[Fraction], y: Sequence[Fraction]) -> tuple[Fraction, Fraction]:
        return x[3], y[3]

    def _clipped(self, n: ExactLens, x: Any, y: Any, distance: Any, one: Any) -> tuple[Any, ...]:
        from_near = distance - n.near
        x_clip, y_clip = (
            (value - from_near * cot) * scale + shift
            for value, cot, scale, shift in zip((x, y), n.shear, n.scale, n.shift, strict=True)
        )
        return x_clip, y_clip, one

    def _depth_scale(self, near: Any, far: Any, *, reverse: bool) -> Any:
        return 1 / (far - near)

    def enlarged(self, distance: Any) -> Any:
        return 1.0

    def outwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        cot_alpha, cot_beta = self.shear
        return x + cot_alpha * (distance - self.near), y + cot_beta * (distance - self.near)

    def inwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        cot_alpha, cot_beta = self.shear
        return x - cot_alpha * (distance - self.near), y - cot_beta * (distance - self.near)

    def _nearer_by(self, distance: float, height: float, down_px: float, height_px: int) -> float:
        return distance - height * down_px / height_px

    def along(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        return self.shear

    def rays(self, on_near: Array) -> tuple[Array, Array]:
        shear = np.array(self.shear)
        return on_near - shear * self.near, np.broadcast_to(shear, on_near.shape)

    # -- as another lens

    @classmethod
    def showing(cls, seen: Seen) -> Lens:
        """With the same window in the plane of the target."""
        lens, distance = seen.lens, seen.distance
        far = max(4.0 * distance, 2.0 * lens.near) if lens.far == math.inf else lens.far
        window = lens.window_at(seen.window, distance)
        return cls.with_window_at(distance, window, lens.near, far, getattr(lens, "keep", "y"))

    @classmethod
    def having(cls, cells: Rationals, near: float, far: float, in_hand: Lens) -> Iterator[Lens]:
        leaning, cots = cls._leaning(cells, in_hand)
        if in_hand.kind == cls.kind:
            yield in_hand.but(near=near, far=far, **leaning)
        sides: list[float] = []
        for i, (row, cot) in enumerate(zip(cells[:2], cots, strict=True)):
            sides += ends(row[i], row[i] * cot * Fraction(near) - row[3], Fraction(1))
        yield cast(Any, cls)(*sides, near, far, **leaning)

    @classmethod
    def _leaning(
        cls, cells: Rationals, in_hand: Lens
    ) -> tuple[dict[str, float], Sequence[Fraction]]:
        """The fields by which projectors lean, and their `shear` in rationals."""
        return {}, (Fraction(0), Fraction(0))

    def least_terms(self, row: Sequence[Fraction], number: int) -> tuple[Fraction, ...]:
        nothing, one = Fraction(0), Fraction(1)
        if number > 1:
            return nothing, nothing, one, one
        return nothing, nothing, abs(row[number]), max(one, abs(row[2] * Fraction(self.near)))

    @classmethod
    def with_window_at(
        cls, distance: float, window: Window, near: float, far: float, keep: Keep
    ) -> Lens:
        """The lens with this window at a distance."""
        lens = cast(Any, cls)(*window, near, far, keep)
        left, right, bottom, top = window
        x, y = (cot * (distance - near) for cot in lens.shear)
        moved = {"left": left - x, "right": right - x, "bottom": bottom - y, "top": top - y}
        return cast(Lens, replace(lens, **moved))

    # -- its matrices

    def least_w(self, setup: Setup) -> float:
        return 1.0

    def between(
        self, setup: Setup, rows: tuple[Array, Array], window: Window, near: float, far: float
    ) -> tuple[Array, Array]:
        clip_from_view, view_from_clip = setup.clip_from_view.copy(), setup.view_from_clip.copy()
        clip_from_view[2] = rows[0]
        view_from_clip[2:] = rows[1]
        left, right, bottom, top = window
        for row, (low, high) in enumerate(((left, right), (bottom, top))):
            cot = self.shear[row]
            view_from_clip[row, 2] = -cot * (far - near)
            view_from_clip[row, 3] = (low + high) / 2.0 + cot * (far - self.near)
        return clip_from_view, view_from_clip

    # -- what its roundings cost

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

    def _depth_row(self, *, reverse: bool) -> tuple[float, float, float, float]:
        per_unit = 1.0 / (self.far - self.near)
        if not reverse:
            per_unit = -per_unit
        return 0.0, 0.0, per_unit, per_unit * (self.far if reverse else self.near)

    # -- for what is drawn and pointed at

    def half_spaces(self, least_w: float) -> HalfSpaces:
        return [((0.0, 0.0, 1.0, 0.0), 1.0), ((0.0, 0.0, -1.0, 0.0), 1.0)]

    def nearer(
        self, a: float, b: float, share: float, length: float, least: float
    ) -> tuple[float, float]:
        return a * length, 0.0

    def side(self, edge: float, axis: int) -> tuple[float, float]:
        cot = self.shear[axis]
        return cot, cot * self.near - edge
