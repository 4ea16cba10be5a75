"""The base of all lenses: a table of formulas and the numbers that their letters stand for.

A lens is a frozen dataclass in a file of its own. It derives from `lenses.central.Central` or
`lenses.orthographic.Parallel`, and from `Windowed` if the sides of its window are given; a typed
matrix derives from `Lens` alone. No other package tests the kind of a lens: lenses differ only in
their numbers and methods here.
"""

import math
from abc import abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property, partial
from pathlib import Path
from typing import Any, ClassVar, NamedTuple, cast

from app.arithmetic.rationals import Rationals
from app.model.lenses.answers import Angles, Axes, ExactWindow, Intrinsics, Window
from app.model.lenses.geometry import Geometry
from app.model.limits import (
    SMALLEST,
    SMALLEST_WINDOW,
    Array,
    Cells,
    Keep,
    check_name,
    finite,
    keep_checked,
    real,
)
from app.model.parameter import Parameter, read_sections, section_of, stated
from app.model.refusal import REFUSALS, Refusal, format_value
from app.model.tables import PipelineStep, Table


@dataclass(frozen=True, eq=False)
class LensTable:
    """A lens as the lectures write it; made once, and compared by identity."""

    steps: tuple[PipelineStep, ...]  # from view space to clip space; empty for a typed matrix
    clip_from_view: Table
    """The product of all steps in closed form, in the order of operations that keeps the digits."""
    view_from_clip: Table | None = None  # its inverse in closed form
    otherwise: "Mapping[str, LensTable]" = field(default_factory=dict)
    """The table of the same lens after another choice of a field: ``far``, finite again."""
    fields: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """By letter, the fields of the document that only this lens has."""
    written: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    """By lecture, the formulas that this lecture writes in another form."""


_WORDS = read_sections(Path(__file__).parent.with_name("content") / "lenses.md")
_plane = partial(stated, section="lens", place="lens", unit="units", logarithmic=True)
NEAR = _plane("near", letter="n", formula="near", handle="near")
FAR = _plane("far", letter="f", formula="far", handle="far")


class Seen(NamedTuple):
    """What another lens shows: the window on its near plane, and the distance of the target."""

    lens: "Lens"
    window: Window
    distance: float


@dataclass(frozen=True)
class Lens(Geometry):
    """The interface that a projection needs of a lens.

    - `window_stays`: whether the window is given in numbers that do not change when near moves.
    - `symmetric`: whether the window is symmetric, so that a field of view describes all of it.
    - `title`, `tip`, `shape`: the name of the lens and its description, from the content file, and
      the shape of its view volume; marked for translation.
    - `tables`: the table for a finite far plane and, if it may be infinite, that for an infinite
      one.
    - `parameters`: those that only this lens has: its fields except near, far and the sides of a
      window.
    - `roundings`: number of roundings of x, y, depth and w before the divide, as `Projection.trace`
      computes them.

    Raises a `Refusal` if a typed matrix is asked for planes, a window, or what follows from them.
    """

    far_may_be_infinite: ClassVar[bool] = False
    window_stays: ClassVar[bool] = False
    symmetric: ClassVar[bool] = False
    title: ClassVar[str]
    tip: ClassVar[str]
    shape: ClassVar[str] = ""
    tables: ClassVar[tuple[LensTable, ...]]
    parameters: ClassVar[tuple[Parameter, ...]] = ()
    roundings: ClassVar[tuple[float, float, float, float]]

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        if "kind" in vars(cls) and "title" not in vars(cls):
            cls.title, words = section_of(cls.kind, _WORDS)
            cls.tip = words.text[0]

    # -- its table, its letters and its planes

    @cached_property
    def table(self) -> LensTable:
        """The lens as the lectures write it."""
        return self.table_to(self.planes[1] if self.planes else 0.0)

    @classmethod
    def table_to(cls, far: float) -> LensTable:
        """The table of the same lens for another far plane, which may be infinite."""
        return cls.tables[-1 if far == math.inf else 0]

    @abstractmethod
    def exact_letters(self, aspect: Fraction) -> dict[str, Fraction]:
        """What the letters of the table stand for, for an image with this width/height.

        Irrational numbers have `double_double.BITS` bits.
        """

    @abstractmethod
    def letters(self, aspect: Fraction) -> dict[str, float]:
        """The letters in float64; terms that would lose digits, such as ``r - l``, are keys too."""

    @cached_property
    def has_steps(self) -> bool:
        """Whether points pass the canonical volumes; a typed matrix is one step."""
        return bool(self.table.steps)

    @property
    def own_view(self) -> Cells | None:
        """A view matrix that replaces the camera's, if the lens has one."""
        return None

    @cached_property
    def planes(self) -> tuple[float, float] | None:
        """Near and far; None for a typed matrix, which need not have them."""
        return self.near, self.far

    def holds(self, distance: float) -> bool:
        """Whether a distance from the eye plane lies between near and far."""
        return self.planes is not None and self.near <= distance <= self.far

    @classmethod
    def checked_planes(cls, near: Any, far: Any) -> tuple[float, float]:
        """Near and far as floats, or a `Refusal` if this kind of lens cannot have them."""
        near = real(NEAR.name, near)
        if near != math.inf or far == math.inf:  # a drag past the horizon asks for ∞ beyond far
            near = finite(NEAR.name, near)
        if not cls.parallel:
            if near <= 0.0:
                raise Refusal(NEAR.name, near, REFUSALS["above"], 0)
            if near < SMALLEST:
                raise Refusal(NEAR.name, near, REFUSALS["at-least"], SMALLEST)
        far = real(FAR.name, far)
        if cls.parallel or far != math.inf:
            far = finite(FAR.name, far)
        if near >= far:
            raise Refusal(NEAR.name, near, REFUSALS["near-before-far"], format_value(far))
        if cls.parallel and far - near < SMALLEST:  # where only their ratio counts, it may be less
            raise Refusal(NEAR.name, near, REFUSALS["distinct"], format_value(far))
        return near, far

    # -- the image

    def check_image(self, aspect: Fraction) -> None:
        """Raise a `Refusal` for an image for which the lens has no window."""

    def fits(self, aspect: float) -> bool:
        """Whether the window that was typed already has the proportions of the image."""
        return False

    @property
    def fov_y_deg(self) -> float | None:
        """The vertical field of view, for a lens that is given by it."""
        return None

    def angles(self, aspect: Fraction) -> Angles | None:
        """Return the fields of view; None for a lens without an eye."""
        return None

    def intrinsics(self, image_size: tuple[int, int]) -> Intrinsics:
        """The perspective camera's K, or a `Refusal` if the projectors do not meet."""
        raise Refusal("lens.kind", self.kind, REFUSALS["one-of"], "perspective, frustum")

    def stretch(self, window: Window) -> float:
        """How much the lens enlarges rounding errors of view coordinates: `Projection.stretch`."""
        raise self._refusal()

    def cell_sizes(self, cells: Array) -> Array:
        """The sizes of the terms whose sums are the cells of the matrix, (4, 4)."""
        sizes: Array = abs(cells)
        return sizes

    # -- other lenses

    @property
    def former(self) -> "Lens":
        """The lens from which another kind is chosen; a typed matrix returns its previous lens."""
        return self

    def replaced(self, **fields: Any) -> "Lens":
        return cast(Lens, replace(cast(Any, self), **fields))

    def cut(self, window: Window, near: float, far: float) -> "Lens":
        """The same view volume between other planes; `window` is on the present near plane."""
        near, far = self.checked_planes(near, far)
        return self.replaced(near=near, far=far)

    def dollied(self, window: Window, factor: float) -> "Lens":
        """Return the lens that shows the target equally large from `factor` times the distance."""
        return self

    def in_depth_range(self, old: tuple[float, float], new: tuple[float, float]) -> "Lens":
        """Return the lens with the same view volume for another NDC z of near and far.

        Only a typed matrix changes: its cells are those of one depth range.
        """
        return self

    @classmethod
    @abstractmethod
    def showing(cls, seen: Seen) -> "Lens":
        """Return the lens of this kind whose picture is most similar to that of another lens."""

    @classmethod
    def solutions_for(
        cls, cells: Rationals, near: float, far: float, in_hand: "Lens"
    ) -> "Iterator[Lens]":
        """Yield lenses of this kind that may have a matrix, those with the present fields first.

        The last row of `cells` is that of the kind's table; the third row belongs to near and far.
        """
        yield from ()

    def least_terms(self, row: Sequence[Fraction], number: int) -> tuple[Fraction, ...]:
        """The least sizes of the terms whose sums are a row's cells, to judge their rounding."""
        raise self._refusal()


@dataclass(frozen=True)
class EyeLens(Lens):
    """The steps that differ between a `Central` and a `Parallel` lens when points are projected.

    `app.model.eye_first` performs all the others.
    """

    @abstractmethod
    def pictured(
        self, axes: Axes, aspect: float, x: Array, y: Array, distance: Array
    ) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        """x and y of clip space, and x and y of the cube."""

    @abstractmethod
    def depth_over_w(self, distance: Array, rest: Array, *, reverse: bool) -> tuple[Array, Array]:
        """The depth times w, and the depth; `rest` is the rounding error of z = -distance."""

    @abstractmethod
    def nearer_by(self, distance: float, height: float, down_px: float, height_px: int) -> float:
        """The distance of a point after the mouse has moved down in a picture of this height."""


def plane_letters(near: float, far: float) -> dict[str, Fraction]:
    """Exact n and f of a lens; no f if far is infinite."""
    planes = {"n": near, "f": far}
    return {letter: Fraction(plane) for letter, plane in planes.items() if plane != math.inf}


_ROUNDING = 1e-12  # relative difference of aspects that counts as rounding


@dataclass(frozen=True)
class Windowed(Lens):
    """The six numbers of glFrustum and glOrtho, and how the window follows the image.

    - `left`, `right`, `bottom`, `top`: the window on the near plane, ``left < right``,
      ``bottom < top``.
    - `near`, `far`: distances of the clipping planes from the eye plane, ``near < far``.
    - `keep`: how the window follows the image's aspect: not at all (``"stretch"``), or by adjusting
      the y range (``"x"`` is kept, lecture 000's variant X) or the x range (``"y"``, variant Y).
    """

    window_stays: ClassVar[bool] = True

    left: float = -4.0
    right: float = 4.0
    bottom: float = -4.0
    top: float = 4.0
    near: float = 1.0
    far: float = 30.0
    keep: Keep = "stretch"

    def __post_init__(self) -> None:
        names = ("left", "right", "bottom", "top")
        left, right, bottom, top = (finite(n, getattr(self, n)) for n in names)
        near, far = self.checked_planes(self.near, self.far)
        keep_checked(self, left=left, right=right, bottom=bottom, top=top, near=near, far=far)
        for name, low, high, bound in (
            ("left", left, right, REFUSALS["left-before-right"]),
            ("bottom", bottom, top, REFUSALS["bottom-before-top"]),
        ):
            if low >= high:
                raise Refusal(name, low, bound, format_value(high))
        self.check_window(left, right, bottom, top)
        check_name("keep", self.keep, ("stretch", "x", "y"))

    @property
    def least_window(self) -> float:
        """The least width and height of the window, in world units."""
        return SMALLEST_WINDOW

    def check_window(self, left: float, right: float, bottom: float, top: float) -> None:
        """Raise a `Refusal` if the window, as typed or after `keep`, is too small for the lens."""
        for name, low, high in (("left", left, right), ("bottom", bottom, top)):
            if high - low < self.least_window:
                bound = REFUSALS["distinct"] if self.parallel else REFUSALS["wider"]
                raise Refusal(name, low, bound, format_value(high))

    def exact_window(self, aspect: Fraction) -> ExactWindow:
        left, right, bottom, top = map(Fraction, (self.left, self.right, self.bottom, self.top))
        if self.keep == "x":
            k = ((right - left) / aspect - (top - bottom)) / 2
            bottom, top = bottom - k, top + k
        elif self.keep == "y":
            k = (aspect * (top - bottom) - (right - left)) / 2
            left, right = left - k, right + k
        return left, right, bottom, top

    def window(self, aspect: Fraction) -> Window:
        """The window after `keep`: lecture 000, PerspektivnaProjekcijaX and Y.

        The mistake in the last line of Y is corrected.
        """
        if self.keep == "stretch":
            return self.left, self.right, self.bottom, self.top
        return super().window(aspect)

    def check_image(self, aspect: Fraction) -> None:
        """Refuse an image for which `keep` would shrink a window far from the axis to nothing."""
        left, right, bottom, top = self.exact_window(aspect)
        window = self.window(aspect)
        for name, exact, low, high in (
            ("left", right - left, *window[:2]),
            ("bottom", top - bottom, *window[2:]),
        ):
            extent = float(exact)
            if abs(high - low - extent) > extent / 2.0:
                raise Refusal(name, low, REFUSALS["distinct"], format_value(high))
        self.check_window(*window)

    def fits(self, aspect: float) -> bool:
        fitted = aspect * (self.top - self.bottom)
        return math.isclose(self.right - self.left, fitted, rel_tol=_ROUNDING)

    def cut(self, window: Window, near: float, far: float) -> Lens:
        near, far = self.checked_planes(near, far)
        left, right, bottom, top = self.window_at(window, near)
        return self.replaced(
            left=left, right=right, bottom=bottom, top=top, near=near, far=far, keep="stretch"
        )

    def exact_letters(self, aspect: Fraction) -> dict[str, Fraction]:
        sides = zip("lrbt", self.exact_window(aspect), strict=True)
        return {**plane_letters(self.near, self.far), **dict(sides)}

    def letters(self, aspect: Fraction) -> dict[str, float]:
        left, right, bottom, top = self.exact_window(aspect)
        return {
            "n": self.near,
            "f": self.far,
            "r - l": float(right - left),
            "r + l": float(right + left),
            "t - b": float(top - bottom),
            "t + b": float(top + bottom),
        }
