"""What every lens is: a table of formulas, the numbers of its letters, and how points pass it.

A lens is a frozen dataclass of its own file. It is `app.model.lenses.central.Central` or
`app.model.lenses.parallel.Parallel`, which says how its window grows with the distance, or it is
none of them, a matrix that somebody typed; and perhaps `app.model.lenses.window.Windowed`, given by
the sides of its window. Nobody outside asks which: what differs is a number or a method here.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, ClassVar, NamedTuple, cast

from app.arithmetic.double_double import DoubleDouble
from app.arithmetic.rationals import Rationals
from app.model.lenses.setup import Angles, ExactLens, HalfSpaces, Intrinsics, Setup, Trace, Window
from app.model.limits import (
    ABOVE,
    AT_LEAST,
    DISTINCT,
    NEAR_BEFORE_FAR,
    ONE_OF,
    SMALLEST,
    Array,
    Cells,
    Vector,
    finite,
    real,
)
from app.model.object_transform import Placed
from app.model.refusal import Refusal, format_value
from app.model.tables import TO_PYRAMID, Step, Table


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


class Control(NamedTuple):
    """How a field of a lens is set by hand.

    Attributes
    ----------
    tip : str
        In the lecture's terms, marked for translation.
    low, high, step : float
        Of the slider; more can be typed.
    unit : str
        ``"°"`` or ``"×"``.
    """

    tip: str
    low: float
    high: float
    step: float
    unit: str


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
    far_may_be_infinite : bool
    window_stays : bool
        Whether its window is given in numbers, which stay when near moves.
    symmetric : bool
        Whether its window is, about the axis: then a field of view is all of it.
    title, tip : str
        What it is called and what it is, marked for translation.
    controls : mapping from str to Control
        Of its fields beside near, far and a window's: how they are set by hand.
    shape : str
        What its view volume is, marked for translation.
    roundings : (float, float, float, float)
        Of x, y, depth and w before the divide, as `trace` computes them.

    Raises
    ------
    Refusal
        For what a lens is asked for and does not have: a typed matrix has no planes, no window.
    """

    kind: ClassVar[str]
    central: ClassVar[bool] = False
    parallel: ClassVar[bool] = False
    far_may_be_infinite: ClassVar[bool] = False
    window_stays: ClassVar[bool] = False
    symmetric: ClassVar[bool] = False
    title: ClassVar[str] = ""
    tip: ClassVar[str] = ""
    controls: ClassVar[Mapping[str, Control]] = {}
    shape: ClassVar[str] = ""
    roundings: ClassVar[tuple[float, float, float, float]]

    # -- its fields, its table and its window

    @property
    def near(self) -> float:
        """Distance of the near plane from the eye plane."""
        raise self._refusal()

    @property
    def far(self) -> float:
        """Distance of the far plane from the eye plane; may be infinite for a `Central` lens."""
        raise self._refusal()

    @property
    def planes(self) -> tuple[float, float] | None:
        """Near and far; None for a typed matrix, which need not have them."""
        return self.near, self.far

    def holds(self, distance: float) -> bool:
        """Whether what is at a distance from the eye plane lies between near and far."""
        return self.near <= distance <= self.far

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

    def along(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        """How x and y of a projector grow with the distance, at which they are these."""
        raise self._refusal()

    def rays(self, on_near: Array) -> tuple[Array, Array]:
        """x and y of view space where projectors begin, and per unit of distance.

        Parameters
        ----------
        on_near : (n, 2) array
            Where they pass the near plane.
        """
        raise self._refusal()

    @property
    def shear(self) -> tuple[float, float]:
        """``cot(alpha), cot(beta)``, by which projectors lean; 0 and 0 if they do not."""
        return 0.0, 0.0

    @property
    def fov_y_deg(self) -> float | None:
        """The vertical field of view that it is given by; None if by anything else."""
        return None

    def angles(self, aspect: Fraction) -> Angles | None:
        """How much it sees; None where that is no angle."""
        return None

    def intrinsics(self, image_size: tuple[int, int]) -> Intrinsics:
        """The perspective camera's K, in pixels of an image.

        Raises
        ------
        Refusal
            For a lens whose projectors do not meet.
        """
        raise Refusal("kind", self.kind, ONE_OF, "perspective, frustum")

    def slopes(self, aspect: Fraction) -> Window:
        """Left, right, bottom, top of the picture at distance 1 from the eye."""
        raise self._refusal()

    def section(self, aspect: Fraction) -> Fraction:
        """The area of the picture: at distance 1 from the eye, or anywhere if that is the same."""
        raise self._refusal()

    def volume(self, section: Fraction) -> Fraction:
        """What lies between near and far, with such a `section`; far is finite."""
        raise self._refusal()

    # -- other lenses

    def ridden(self, window: Window, factor: float) -> Lens:
        """The lens that shows the target as large from `factor` times the distance."""
        return self

    def cut(self, window: Window, near: float, far: float) -> Lens:
        """The lens with the same view volume between other planes.

        Parameters
        ----------
        window : Window
            Of the image, on the present near plane.
        near, far : float
        """
        raise self._refusal()

    def but(self, **fields: Any) -> Lens:
        """The same lens but for some fields."""
        return cast(Lens, replace(cast(Any, self), **fields))

    @classmethod
    def showing(cls, seen: Seen) -> Lens:
        """A lens of this kind that shows what another does, as alike as it can."""
        raise NotImplementedError

    @classmethod
    def having(cls, cells: Rationals, near: float, far: float, in_hand: Lens) -> Iterator[Lens]:
        """Lenses of this kind that may have a matrix, those with the fields in hand first.

        Parameters
        ----------
        cells : 4 lists of 4 Fraction
            With the last row of the kind's table.
        near, far : float
            Whose row makes z.
        in_hand : Lens
        """
        yield from ()

    def least_terms(self, row: Sequence[Fraction], number: int) -> tuple[Fraction, ...]:
        """The least sizes of the terms that a row's cells are sums of, for their rounding."""
        raise self._refusal()

    @classmethod
    def checked_planes(cls, near: Any, far: Any) -> tuple[float, float]:
        """Near and far as this lens can have them, as floats.

        Raises
        ------
        Refusal
        """
        raise NotImplementedError

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

    @property
    def has_steps(self) -> bool:
        """Whether it goes through the canonical volumes; a typed matrix is one step."""
        return bool(self.table.steps)

    @property
    def has_pyramid(self) -> bool:
        """Whether the first of them is the pyramid, so that M_pp is to come."""
        return bool(self.table.steps) and self.table.steps[0].name == TO_PYRAMID

    @property
    def canonical_unit(self) -> float:
        """w in front of the box of the canonical parallel volume, times this is w of clip space."""
        raise self._refusal()

    @property
    def canonical_from_box(self) -> Array:
        """The first canonical volume from a box with z = 1 at near and 0 at far, (4, 4)."""
        raise self._refusal()

    def edges(self, at: Callable[[float], Array]) -> tuple[Array, Array]:
        """The near corners of the view volume and the edges from there, (4, 3) each.

        Parameters
        ----------
        at : callable
            From a z of the first canonical volume to its four corners there, in view space.
        """
        raise self._refusal()

    # -- distances and depths

    def w(self, distance: Any) -> Any:
        """What x, y and z are divided by, at a distance from the eye plane."""
        raise self._refusal()

    def depth(self, distance: Array, *, reverse: bool) -> Array:
        """The depth of a distance, from 0 at the near plane to 1 at the far one, or reversed."""
        raise self._refusal()

    def distance(self, gone: Any, left_over: Any) -> Any:
        """The distance of a depth in the buffer, floats or arrays.

        Parameters
        ----------
        gone, left_over : (...) array
            0 and 1 at the near plane, 1 and 0 at the far one.
        """
        raise self._refusal()

    def gap(self, distance: Array, step: Array) -> Array:
        """By how much a distance grows with a step of its depth; infinite beyond the far plane."""
        raise self._refusal()

    @property
    def depth_slope(self) -> float:
        """a of the depth's ``constant - a/w``; 0 where it is even in the distance."""
        return 0.0

    @property
    def even_extent(self) -> float:
        """From near to far where depth is even in the distance; 0 where it is not."""
        return 0.0

    @property
    def eye_room(self) -> float:
        """How close to the eye it can draw: near, or infinite where no eye is come close to."""
        return math.inf

    # -- points

    def trace(self, setup: Setup, world: Array, rest: Array | None = None) -> Trace:
        """Points (..., 3) through every stage, with what their rounding to float64 cut off.

        See `Projection.trace`.
        """
        raise NotImplementedError

    def world_from_image(self, setup: Setup, points: Array) -> Array:
        """Pixels with a depth, (..., 3), back to the world; see `Projection.world_from_image`."""
        raise NotImplementedError

    def clipped(self, setup: Setup, x: Any, y: Any, z: Any) -> list[Any]:
        """View and clip coordinates, and what is negative beyond each of `PLANES`, 3 + 4 + 6.

        In whatever arithmetic a point's `coordinates` are.
        """
        raise NotImplementedError

    def coordinates(self, setup: Setup, points: Placed) -> tuple[Sequence[DoubleDouble], Array]:
        """What `clipped` starts from, of points (n, 3) with twice the digits, and its error."""
        raise NotImplementedError

    def exact_coordinates(
        self, setup: Setup, point: Sequence[float | Fraction]
    ) -> tuple[Fraction, ...]:
        """The same of one point without any error."""
        raise NotImplementedError

    def view_of(self, setup: Setup, offsets: Any) -> Any:
        """View coordinates of offsets from the eye, (n, 3), in these offsets' own precision."""
        raise NotImplementedError

    def beyond(self, setup: Setup, view: Any, clip: Any) -> tuple[Any, Any]:
        """Where points, (n, 3) and (n, 4), are before the near plane, and beyond the far one."""
        raise NotImplementedError

    def line(
        self, setup: Setup, pixel: tuple[float, float] | None, point: Vector | None, at: Array
    ) -> Array | None:
        """Points on the projector of a pixel, or of a point: (k, 3), world coordinates.

        `at` are distances from the eye plane; without one, shares of the way from near to far.
        None where there is no projector.
        """
        raise NotImplementedError

    def dragged(
        self, setup: Setup, trace: Trace, shift_px: tuple[float, float], *, along_ray: bool
    ) -> Array | None:
        """Where a point goes whose picture is dragged; see `app.picking.picking.dragged`."""
        raise NotImplementedError

    # -- its matrices, beyond the table's

    def stated_in(self, setup: Setup) -> tuple[Array, Array]:
        """Clip from the axes that the lens is stated in, and these from the eye, (4, 4) each."""
        raise NotImplementedError

    def clip_from_eye(self, setup: Setup) -> Array:
        """Clip from world axes with their origin in the eye, (4, 4)."""
        raise NotImplementedError

    def eye_from_clip(self, setup: Setup) -> tuple[Array, ...]:
        """The inverse of `clip_from_eye`, as factors in their order."""
        raise NotImplementedError

    def view_from_clip(self, setup: Setup, letters: Mapping[str, float]) -> Array:
        """The inverse of its matrix; see `Projection.view_from_clip`."""
        raise NotImplementedError

    def frustum_sign(self, setup: Setup) -> int:
        """The sign of w at the view volume's corners; see `Projection.frustum_sign`."""
        return 1

    def least_w(self, setup: Setup) -> float:
        """The least w of what is in the view volume, or less."""
        raise NotImplementedError

    def exact(self, letters: Mapping[str, Fraction]) -> ExactLens:
        """The numbers that it is made of, without their rounding."""
        raise self._refusal()

    def between(
        self, setup: Setup, rows: tuple[Array, Array], window: Window, near: float, far: float
    ) -> tuple[Array, Array]:
        """Its matrix and the inverse between other planes; see `Projection.matrices_between`."""
        raise self._refusal()

    # -- what its roundings cost

    def stretch(self, window: Window) -> float:
        """By how much it enlarges the rounding of view coordinates; see `Projection.stretch`."""
        raise self._refusal()

    def view_error(self, setup: Setup) -> float:
        """What `trace` lacks of view coordinates; see `Projection.view_error`."""
        raise NotImplementedError

    def cell_sizes(self, cells: Array) -> Array:
        """The sizes of the terms that the matrix' cells are summed from, (4, 4)."""
        sizes: Array = abs(cells)
        return sizes

    def depth_terms(self, setup: Setup) -> tuple[Array, Array]:
        """The depth times w from the axes it is stated in, (4,), and the sizes of its terms."""
        raise NotImplementedError

    # -- for what is drawn and pointed at

    def order(self, setup: Setup) -> tuple[Array, Array]:
        """What is in front of what, and what is between near and far.

        Returns
        -------
        order : (4,) array
            Of the axes it is stated in: a number that is smaller for what is in front, times w.
        limits : (k, 4) array
            Half-spaces of these axes: ``limit . (x, y, z, 1) >= 0`` inside.
        """
        raise NotImplementedError

    def half_spaces(self, least_w: float) -> HalfSpaces:
        """Of clip space in OpenGL's range: between near and far, and w at least positive."""
        raise NotImplementedError

    def w_of_z(self, a: float, b: float) -> tuple[float, float]:
        """w from z of clip space, of a lens with ``z_clip = a z_view + b``: per z, and constant.

        A constant alone for points that are divided already.
        """
        return 0.0, 1.0

    def nearer(
        self, a: float, b: float, share: float, length: float, least: float
    ) -> tuple[float, float]:
        """What z of clip space grows by when things come nearer, constant and per w.

        Parameters
        ----------
        a, b : float
            As of `w_of_z`.
        share, length : float
            Of their distance where the eye has one, in world units where it has none.
        least : float
            Of the depth range, where there is no eye.
        """
        raise NotImplementedError

    def side(self, edge: float, axis: int) -> tuple[float, float]:
        """The plane through an edge of the window and the projectors: ``x + a z + b = 0``."""
        raise self._refusal()

    def _refusal(self) -> Refusal:
        from app.model.lenses import LENSES

        return Refusal("kind", self.kind, ONE_OF, ", ".join(LENSES))


def plane_letters(near: float, far: float) -> dict[str, Fraction]:
    """n, f of a lens without rounding; no f where far is infinite."""
    planes = {"n": near, "f": far}
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
