"""What every lens is: a table of formulas, the numbers of its letters, and a window on space.

A lens is a frozen dataclass of its own file. It is `Central` or `Parallel`, which says how its
window grows with the distance, or it is none of them, a matrix that somebody typed; and perhaps
`app.model.lenses.window.Windowed`, given by the sides of its window.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, ClassVar, NamedTuple, TypeAlias, cast

from app.model.limits import (
    ABOVE,
    AT_LEAST,
    DISTINCT,
    NEAR_BEFORE_FAR,
    ONE_OF,
    SMALLEST,
    Array,
    Cells,
    Keep,
    finite,
    real,
)
from app.model.refusal import Refusal, format_value
from app.model.tables import Step, Table


@dataclass(frozen=True, eq=False)
class LensTable:
    """A lens as the lectures write it; made once, and known by its identity.

    Parameters
    ----------
    steps : tuple of Step
        From view space to clip space; none for a matrix that is one step.
    clip_from_view : Table
        All steps' product in closed form: what float64 evaluates, its operations in the order
        that keeps its digits.
    view_from_clip : Table, optional
        The inverse of it in closed form, where it has one.
    otherwise : mapping from str to LensTable, optional
        The table of the same lens after another choice of a field: ``far``, finite again.
    fields : mapping from str to (tuple of str), optional
        By letter, the fields of the document that it depends on, besides those that all have.
    written : mapping from str to (mapping from str to str), optional
        By lecture, the formulas that it writes in another form than ours.
    """

    steps: tuple[Step, ...]
    clip_from_view: Table
    view_from_clip: Table | None = None
    otherwise: Mapping[str, LensTable] = field(default_factory=dict)
    fields: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    written: Mapping[str, Mapping[str, str]] = field(default_factory=dict)


Window: TypeAlias = tuple[float, float, float, float]
"""Left, right, bottom, top, in world units."""


class Seen(NamedTuple):
    """What another lens shows, for one that shall show it too; see `Lens.showing`.

    Attributes
    ----------
    lens : Lens
    window : Window
        Of the image, on the lens' near plane.
    distance : float
        Of the target from the eye.
    """

    lens: Lens
    window: Window
    distance: float


@dataclass(frozen=True)
class Lens:
    """What a projection asks of a lens.

    Attributes
    ----------
    kind : str
        Its name in a document.
    central : bool
        Whether its projectors meet in the eye, so that w is the distance from the eye plane.
    parallel : bool
        Whether they are parallel, so that w is 1. A typed matrix is neither.

    Raises
    ------
    Refusal
        For what a lens is asked for and does not have: a typed matrix has no planes, no window.
    """

    kind: ClassVar[str]
    central: ClassVar[bool] = False
    parallel: ClassVar[bool] = False

    @property
    def near(self) -> float:
        """Distance of the near plane from the eye plane."""
        raise self._refusal()

    @property
    def far(self) -> float:
        """Distance of the far plane from the eye plane; may be infinite for a `Central` lens."""
        raise self._refusal()

    @property
    def table(self) -> LensTable:
        """The lens as the lectures write it."""
        raise self._refusal()

    def table_to(self, far: float) -> LensTable:
        """The table of the same lens with its far plane at another distance, perhaps infinite."""
        raise self._refusal()

    def exact_letters(self, aspect: Fraction) -> dict[str, Fraction]:
        """What the table's letters stand for, irrational ones to `double_double.BITS` bits.

        Parameters
        ----------
        aspect : Fraction
            The image's width over its height.
        """
        raise self._refusal()

    def letters(self, aspect: Fraction) -> dict[str, float]:
        """The same in float64; terms that lose digits, such as sums of sides, are known as such."""
        raise self._refusal()

    def exact_window(self, aspect: Fraction) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """Left, right, bottom, top of the picture on the near plane, as the image has it."""
        raise self._refusal()

    def window(self, aspect: Fraction) -> Window:
        """`exact_window`, each side rounded once."""
        left, right, bottom, top = map(float, self.exact_window(aspect))
        return left, right, bottom, top

    def check_image(self, aspect: Fraction) -> None:
        """Refuse an image for which the lens has no window.

        Raises
        ------
        Refusal
        """

    def fits(self, aspect: float) -> bool:
        """Whether the window that was typed has the image's proportions as it is."""
        return False

    def enlarged(self, distance: Any) -> Any:
        """How much larger than on the near plane the window is at a distance."""
        raise self._refusal()

    def window_at(self, window: Window, distance: float) -> Window:
        """What a window on the near plane is at a distance: its corners follow the projectors."""
        left, bottom = self.outwards(*window[0::2], distance)
        right, top = self.outwards(*window[1::2], distance)
        return left, right, bottom, top

    def outwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        """x and y, floats or arrays, where the projectors of the near plane's are at a distance."""
        raise self._refusal()

    def inwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        """x and y on the near plane, of the projectors through these at a distance."""
        raise self._refusal()

    def distance(self, gone: Array, left_over: Array) -> Array:
        """The distance of a depth in the buffer.

        Parameters
        ----------
        gone, left_over : (...) array
            0 and 1 at the near plane, 1 and 0 at the far one.
        """
        raise self._refusal()

    def cut(self, window: Window, near: float, far: float) -> Lens:
        """The lens with the same view volume between other planes.

        Parameters
        ----------
        window : Window
            Of the image, on the present near plane.
        near, far : float
        """
        if self.planes is None:
            raise self._refusal()
        near, far = check_planes(near, far, parallel=self.parallel)
        return self.but(near=near, far=far)

    def but(self, **fields: Any) -> Lens:
        """The same lens but for some fields."""
        return cast(Lens, replace(cast(Any, self), **fields))

    @classmethod
    def showing(cls, seen: Seen) -> Lens:
        """A lens of this kind that shows what another does, as alike as it can."""
        raise NotImplementedError

    @property
    def shear(self) -> tuple[float, float]:
        """``cot(alpha), cot(beta)``, by which projectors lean; 0 and 0 if they do not."""
        return 0.0, 0.0

    def stretch(self, window: Window) -> float:
        """By how much it enlarges the rounding of view coordinates; see `Projection.stretch`."""
        raise self._refusal()

    @property
    def planes(self) -> tuple[float, float] | None:
        """Near and far; None for a typed matrix, which need not have them."""
        return self.near, self.far

    @property
    def has_steps(self) -> bool:
        """Whether it goes through the canonical volumes; a typed matrix is one step."""
        return bool(self.table.steps)

    @property
    def former(self) -> Lens:
        """The lens that another kind is chosen from: itself, or what a typed matrix was."""
        return self

    def in_depth_range(self, old: tuple[float, float], new: tuple[float, float]) -> Lens:
        """The lens with the same view volume for another depth range, near's z and far's.

        Only a typed matrix changes: its cells are those of one range.
        """
        return self

    @property
    def own_view(self) -> Cells | None:
        """A view matrix in place of the camera's, if it brings one."""
        return None

    def _refusal(self) -> Refusal:
        from app.model.lenses import LENSES

        return Refusal("kind", self.kind, ONE_OF, ", ".join(LENSES))


@dataclass(frozen=True)
class Central(Lens):
    """A lens whose projectors meet in the eye: pictures are larger the nearer things are."""

    central: ClassVar[bool] = True

    def table_to(self, far: float) -> LensTable:
        if far == math.inf:
            return self.but(far=far).table
        return self.table.otherwise.get("far", self.table)

    def enlarged(self, distance: Any) -> Any:
        return distance / self.near

    def outwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        k = self.enlarged(distance)
        return x * k, y * k

    def inwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        return x / distance * self.near, y / distance * self.near

    def distance(self, gone: Array, left_over: Array) -> Array:
        if self.far == math.inf:
            return self.near / left_over
        return self.near / (left_over + self.near / self.far * gone)

    @classmethod
    def showing(cls, seen: Seen) -> Lens:
        """With the same window on the near plane, or of a parallel lens the one at the target."""
        lens, distance = seen.lens, seen.distance
        near, far = lens.near, lens.far
        if near < SMALLEST:
            near = (min(distance, far) if far > 0.0 else distance) / 1000.0
        if far <= near:  # the volume is behind the eye; the target shall be in the new one
            far = 2.0 * distance
        window = seen.window
        if not lens.central:
            left, right, bottom, top = lens.window_at(window, distance)
            k = near / distance
            window = k * left, k * right, k * bottom, k * top
        return cls.with_window(window, near, far, getattr(lens, "keep", "y"))

    @classmethod
    def with_window(cls, window: Window, near: float, far: float, keep: Keep) -> Lens:
        """The lens with this window on its near plane, or as much of it as it can have."""
        raise NotImplementedError

    def stretch(self, window: Window) -> float:
        left, right, bottom, top = window
        across, up = max(abs(left), abs(right)), max(abs(bottom), abs(top))
        half_width, half_height = (right - left) / 2.0, (top - bottom) / 2.0
        slant = math.hypot(across, up, self.near) / self.near
        return slant * max((self.near + across) / half_width, (self.near + up) / half_height)


@dataclass(frozen=True)
class Parallel(Lens):
    """A lens whose projectors are parallel: pictures are as large wherever things are."""

    parallel: ClassVar[bool] = True

    def table_to(self, far: float) -> LensTable:
        return self.table

    def enlarged(self, distance: Any) -> Any:
        return 1.0

    def outwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        cot_alpha, cot_beta = self.shear
        return x + cot_alpha * (distance - self.near), y + cot_beta * (distance - self.near)

    def inwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        cot_alpha, cot_beta = self.shear
        return x - cot_alpha * (distance - self.near), y - cot_beta * (distance - self.near)

    def distance(self, gone: Array, left_over: Array) -> Array:
        return self.near * left_over + self.far * gone

    @classmethod
    def showing(cls, seen: Seen) -> Lens:
        """With the same window in the plane of the target."""
        lens, distance = seen.lens, seen.distance
        far = max(4.0 * distance, 2.0 * lens.near) if lens.far == math.inf else lens.far
        window = lens.window_at(seen.window, distance)
        return cls.with_window_at(distance, window, lens.near, far, getattr(lens, "keep", "y"))

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

    def stretch(self, window: Window) -> float:
        left, right, bottom, top = window
        across, up = max(abs(left), abs(right)), max(abs(bottom), abs(top))
        half_width, half_height = (right - left) / 2.0, (top - bottom) / 2.0
        depth = max(abs(self.near), abs(self.far))
        shear_x, shear_y = (abs(cot) for cot in self.shear)
        extent = self.far - self.near
        distance = math.hypot(across + shear_x * extent, up + shear_y * extent, depth)
        return distance * max((1.0 + shear_x) / half_width, (1.0 + shear_y) / half_height)


def plane_letters(lens: Lens) -> dict[str, Fraction]:
    """n, f of a lens without rounding; no f where far is infinite."""
    planes = {"n": lens.near, "f": lens.far}
    return {letter: Fraction(plane) for letter, plane in planes.items() if plane != math.inf}


def check_planes(near: Any, far: Any, *, parallel: bool) -> tuple[float, float]:
    """Near and far of a lens as floats, or a `Refusal`."""
    near = real("near", near)
    if near != math.inf or far == math.inf:  # a drag past the horizon asks for ∞ beyond far
        near = finite("near", near)
    if not parallel:
        if near <= 0.0:
            raise Refusal("near", near, ABOVE, 0)
        if near < SMALLEST:
            raise Refusal("near", near, AT_LEAST, SMALLEST)
    far = real("far", far)
    if parallel or far != math.inf:
        far = finite("far", far)
    if near >= far:
        raise Refusal("near", near, NEAR_BEFORE_FAR, format_value(far))
    if parallel and far - near < SMALLEST:  # where only their ratio counts, it may be less
        raise Refusal("near", near, DISTINCT, format_value(far))
    return near, far
