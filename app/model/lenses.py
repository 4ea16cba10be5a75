"""The lenses: what they are made of, and the numbers that they can be given by."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar, TypeAlias

from app.model.values import (
    ABOVE,
    AT_LEAST,
    AT_MOST,
    BOTTOM_BEFORE_TOP,
    DISTINCT,
    LARGEST_SHEAR,
    LEFT_BEFORE_RIGHT,
    NEAR_BEFORE_FAR,
    ONE_OF,
    SMALLEST,
    SMALLEST_CELL,
    SMALLEST_FIELD,
    SMALLEST_OPENING,
    SMALLEST_WINDOW,
    WIDER,
    Cells,
    Keep,
    ProjectionError,
    between,
    cos_sin_deg,
    finite,
    finite_matrix,
    format_value,
    keep_checked,
    real,
)

_FULL_FRAME_DIAGONAL_MM = math.hypot(36.0, 24.0)


def check_planes(near: Any, far: Any, *, parallel: bool) -> tuple[float, float]:
    """Near and far of a lens as floats, or a `ProjectionError`."""
    near = real("near", near)
    if near != math.inf or far == math.inf:  # a drag past the horizon asks for ∞ beyond far
        near = finite("near", near)
    if not parallel:
        if near <= 0.0:
            raise ProjectionError("near", near, ABOVE, 0)
        if near < SMALLEST:
            raise ProjectionError("near", near, AT_LEAST, SMALLEST)
    far = real("far", far)
    if parallel or far != math.inf:
        far = finite("far", far)
    if near >= far:
        raise ProjectionError("near", near, NEAR_BEFORE_FAR, format_value(far))
    if parallel and far - near < SMALLEST:  # where only their ratio counts, it may be less
        raise ProjectionError("near", near, DISTINCT, format_value(far))
    return near, far


@dataclass(frozen=True)
class Perspective:
    """The symmetric perspective lens (gluPerspective); the aspect is the image's.

    Parameters
    ----------
    fov_y_deg : float
        Vertical field of view in degrees, anywhere in the open interval (0, 180).
    near, far : float
        Distances of the clipping planes from the eye, ``0 < near < far``; far may be ``inf``.
    """

    kind: ClassVar[str] = "perspective"
    parallel: ClassVar[bool] = False

    fov_y_deg: float = 45.0
    near: float = 1.0
    far: float = 30.0

    def __post_init__(self) -> None:
        fov_y_deg = between("fov_y_deg", self.fov_y_deg, 0, 180)
        if fov_y_deg < SMALLEST_FIELD:
            raise ProjectionError("fov_y_deg", fov_y_deg, AT_LEAST, SMALLEST_FIELD)
        near, far = check_planes(self.near, self.far, parallel=False)
        keep_checked(self, fov_y_deg=fov_y_deg, near=near, far=far)

    @property
    def cot_half_fov_y(self) -> float:
        """``cot(fov_y/2)``, the picture's half-height in units of its distance, inverted.

        Above 90 degrees it is taken as the tangent of the complement: ``180 - fov`` is exact
        there, and the result stays within 2 ulp up to 180.
        """
        if self.fov_y_deg > 90.0:
            return math.tan(math.radians(180.0 - self.fov_y_deg) / 2.0)
        return 1.0 / math.tan(math.radians(self.fov_y_deg) / 2.0)

    def window(self, aspect: float | Fraction) -> tuple[float, float, float, float]:
        """Left, right, bottom, top of the picture on the near plane, in world units."""
        top = self.near / self.cot_half_fov_y
        right = float(aspect) * top
        return -right, right, -top, top


@dataclass(frozen=True)
class Windowed:
    """The six numbers that glFrustum and glOrtho share, and what follows from them."""

    left: float
    right: float
    bottom: float
    top: float
    near: float
    far: float
    keep: Keep

    parallel: ClassVar[bool]

    def __post_init__(self) -> None:
        names = ("left", "right", "bottom", "top")
        left, right, bottom, top = (finite(n, getattr(self, n)) for n in names)
        near, far = check_planes(self.near, self.far, parallel=self.parallel)
        keep_checked(self, left=left, right=right, bottom=bottom, top=top, near=near, far=far)
        for name, low, high, bound in (
            ("left", left, right, LEFT_BEFORE_RIGHT),
            ("bottom", bottom, top, BOTTOM_BEFORE_TOP),
        ):
            if low >= high:
                raise ProjectionError(name, low, bound, format_value(high))
        self.check_window(left, right, bottom, top)
        if self.keep not in ("stretch", "x", "y"):
            raise ProjectionError("keep", self.keep, ONE_OF, "stretch, x, y")

    @property
    def least_window(self) -> float:
        """The least width and height of the window, in world units."""
        return SMALLEST_WINDOW

    def check_window(self, left: float, right: float, bottom: float, top: float) -> None:
        """Refuse a window that is too small for this lens, as typed or after `keep`.

        Raises
        ------
        ProjectionError
            If a side is shorter than `least_window`.
        """
        for name, low, high in (("left", left, right), ("bottom", bottom, top)):
            if high - low < self.least_window:
                bound = DISTINCT if self.parallel else WIDER
                raise ProjectionError(name, low, bound, format_value(high))

    def exact_window(self, aspect: Fraction) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """`window` without rounding, (left, right, bottom, top)."""
        left, right, bottom, top = map(Fraction, (self.left, self.right, self.bottom, self.top))
        if self.keep == "x":
            k = ((right - left) / aspect - (top - bottom)) / 2
            bottom, top = bottom - k, top + k
        elif self.keep == "y":
            k = (aspect * (top - bottom) - (right - left)) / 2
            left, right = left - k, right + k
        return left, right, bottom, top

    def window(self, aspect: float | Fraction) -> tuple[float, float, float, float]:
        """Left, right, bottom, top of the picture after `keep`, in world units.

        Lecture 000, PerspektivnaProjekcijaX and Y, with the slip in Y's last line corrected.
        """
        if self.keep == "stretch":
            return self.left, self.right, self.bottom, self.top
        left, right, bottom, top = map(float, self.exact_window(Fraction(aspect)))
        return left, right, bottom, top


@dataclass(frozen=True)
class Frustum(Windowed):
    """The perspective lens with a window of its own (glFrustum), off the axis if you like.

    Parameters
    ----------
    left, right, bottom, top : float
        The picture's window on the near plane, ``left < right``, ``bottom < top``.
    near, far : float
        Distances of the clipping planes from the eye, ``0 < near < far``; far may be ``inf``.
    keep : {"stretch", "x", "y"}
        How the window follows the image's aspect: not at all, or by adjusting the y range
        (``"x"`` is kept, lecture 000's variant X) or the x range (``"y"``, variant Y).
    """

    kind: ClassVar[str] = "frustum"
    parallel: ClassVar[bool] = False

    left: float = -0.7
    right: float = 0.7
    bottom: float = -0.4
    top: float = 0.4
    near: float = 1.0
    far: float = 30.0
    keep: Keep = "stretch"

    @property
    def least_window(self) -> float:
        """The least width and height of the window, in world units; near divided by it is left
        room for."""
        return max(1e-290, SMALLEST_OPENING * self.near)

    def check_window(self, left: float, right: float, bottom: float, top: float) -> None:
        """Refuse also a window so far off or so large that the far plane's is infinite."""
        super().check_window(left, right, bottom, top)
        limit = self.near / SMALLEST_FIELD
        sides = {"left": left, "right": right, "bottom": bottom, "top": top}
        for name, side in sides.items():
            if abs(side) > limit:
                bound, signed = (AT_MOST, limit) if side > 0.0 else (AT_LEAST, -limit)
                raise ProjectionError(name, side, bound, format_value(signed))


@dataclass(frozen=True)
class Orthographic(Windowed):
    """The orthographic lens (glOrtho).

    Parameters
    ----------
    left, right, bottom, top : float
        The picture's window in view space, ``left < right``, ``bottom < top``.
    near, far : float
        Distances of the clipping planes from the eye plane, ``near < far``; near may be
        negative (behind the eye), far must be finite.
    keep : {"stretch", "x", "y"}
        As `Frustum`'s.
    """

    kind: ClassVar[str] = "orthographic"
    parallel: ClassVar[bool] = True

    left: float = -4.0
    right: float = 4.0
    bottom: float = -4.0
    top: float = 4.0
    near: float = 1.0
    far: float = 30.0
    keep: Keep = "stretch"


@dataclass(frozen=True)
class Oblique(Windowed):
    """The oblique parallel lens of lecture 002: the orthographic one after its matrix H.

    ``x' = x + (z + near) cot(alpha)`` and ``y' = y + (z + near) cot(beta)`` in view space: the
    projectors lean, and what lies on the near plane stays where it is.

    Parameters
    ----------
    left, right, bottom, top : float
        The picture's window on the near plane, ``left < right``, ``bottom < top``.
    near, far : float
        As `Orthographic`'s.
    alpha_deg, beta_deg : float
        Angles of the projectors with the x and the y axis, in the open interval (0, 180);
        90 and 90 is the orthographic lens. See `oblique_angles` for cavalier and cabinet.
    keep : {"stretch", "x", "y"}
        As `Frustum`'s.
    """

    kind: ClassVar[str] = "oblique"
    parallel: ClassVar[bool] = True

    left: float = -4.0
    right: float = 4.0
    bottom: float = -4.0
    top: float = 4.0
    near: float = 1.0
    far: float = 30.0
    alpha_deg: float = 109.47122063449069  # cabinet, receding at 45 degrees
    beta_deg: float = 109.47122063449069
    keep: Keep = "stretch"

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("alpha_deg", "beta_deg"):
            angle_deg = between(name, getattr(self, name), 0, 180)
            least = math.degrees(1.0 / LARGEST_SHEAR)
            if not least <= angle_deg <= 180.0 - least:
                bound, limit = (AT_LEAST, least) if angle_deg < 90.0 else (AT_MOST, 180.0 - least)
                raise ProjectionError(name, angle_deg, bound, format_value(limit))
            keep_checked(self, **{name: angle_deg})

    @property
    def least_window(self) -> float:
        """The least width and height of the window, in world units; the shear is left room for."""
        return SMALLEST_WINDOW * LARGEST_SHEAR

    @property
    def shear(self) -> tuple[float, float]:
        """``cot(alpha), cot(beta)``: the shift in x and y per unit of z."""
        return _cot_deg(self.alpha_deg), _cot_deg(self.beta_deg)


def _cot_deg(angle_deg: float) -> float:
    """The cotangent of an angle in degrees, exact at 90, within 2 ulp elsewhere."""
    cos, sin = cos_sin_deg(angle_deg)
    return cos / sin


def oblique_angles(receding: float, receding_deg: float) -> tuple[float, float]:
    """The angles of an `Oblique` lens under which receding edges are drawn like this.

    Parameters
    ----------
    receding : float
        Drawn length of an edge along the view direction per true length: 1 is a cavalier,
        1/2 a cabinet drawing.
    receding_deg : float
        Direction in the picture in which things recede, in degrees from the right, anticlockwise.

    Returns
    -------
    alpha_deg, beta_deg : float

    Raises
    ------
    ProjectionError
        For a length below 0 or above `LARGEST_SHEAR`, or a number that is not finite.

    Notes
    -----
    A unit into the picture moves a point by ``(-cot(alpha), -cot(beta))`` (lecture 002, H).
    """
    receding, receding_deg = finite("receding", receding), finite("receding_deg", receding_deg)
    for wrong, bound, limit in (
        (receding < 0.0, AT_LEAST, 0), (receding > LARGEST_SHEAR, AT_MOST, int(LARGEST_SHEAR)),
    ):  # fmt: skip
        if wrong:
            raise ProjectionError("receding", receding, bound, limit)
    cos, sin = cos_sin_deg(receding_deg)
    return (
        math.degrees(math.atan2(1.0, -receding * cos)),
        math.degrees(math.atan2(1.0, -receding * sin)),
    )


def receding_of(lens: Oblique) -> tuple[float, float]:
    """Drawn length per unit of depth, and its direction in degrees: of `oblique_angles`."""
    cot_alpha, cot_beta = lens.shear
    length = math.hypot(cot_alpha, cot_beta)
    return length, math.degrees(math.atan2(-cot_beta, -cot_alpha)) if length else 0.0


OBLIQUE_PRESETS: dict[str, tuple[float, float]] = {
    f"{name}-{label}": oblique_angles(receding, receding_deg)
    for name, receding in (("cavalier", 1.0), ("cabinet", 0.5))
    for label, receding_deg in (
        ("30", 30.0), ("45", 45.0), ("63.4", math.degrees(math.atan(2.0))),
    )
}  # fmt: skip
"""`Oblique` angles of the drawings of the textbooks, by name and receding angle."""

StandardLens: TypeAlias = Perspective | Frustum | Orthographic | Oblique


@dataclass(frozen=True)
class FreeMatrix:
    """A projection that is none of the lenses: cells that somebody typed.

    Parameters
    ----------
    clip_from_view : (4, 4) sequence of floats
        For the depth range in hand.
    view_from_world : (4, 4) sequence of floats, optional
        In place of the camera's own, where that was edited and no camera has it.
    former : Perspective, Frustum, Orthographic or Oblique
        The lens that it was made of, to which a choice of a lens goes back.

    Raises
    ------
    ProjectionError
        Naming the cell, as ``clip_from_view[0, 2]``, that is not finite, beyond `LARGEST`, or
        below `SMALLEST_CELL` in size and not 0.
    """

    kind: ClassVar[str] = "matrix"

    clip_from_view: Cells
    view_from_world: Cells | None = None
    former: StandardLens = Perspective()

    def __post_init__(self) -> None:
        keep_checked(
            self, clip_from_view=finite_matrix("clip_from_view", self.clip_from_view, SMALLEST_CELL)
        )
        if self.view_from_world is not None:
            view_from_world = finite_matrix("view_from_world", self.view_from_world, SMALLEST_CELL)
            keep_checked(self, view_from_world=view_from_world)


Lens: TypeAlias = StandardLens | FreeMatrix
LENSES: dict[str, type[Perspective] | type[Frustum] | type[Orthographic] | type[Oblique]] = {
    "perspective": Perspective,
    "frustum": Frustum,
    "orthographic": Orthographic,
    "oblique": Oblique,
}
"""The lenses that have fields; `FreeMatrix` is beside them."""
KINDS = (*LENSES, FreeMatrix.kind)
"""What a document's ``lens.kind`` can be."""


# --------------------------------------------------------------------------- field of view


def fov_x_from_fov_y(fov_y_deg: float, aspect: float) -> float:
    """Horizontal field of view of a symmetric lens, degrees.

    ``tan(fov_x/2) = aspect tan(fov_y/2)``; for the converse give ``1/aspect``.
    """
    complement_deg = (180.0 - fov_y_deg) / 2.0
    sin_half = math.sin(math.radians(fov_y_deg / 2.0))
    cos_half = math.sin(math.radians(complement_deg))
    return math.degrees(2.0 * math.atan2(aspect * sin_half, cos_half))


def fov_y_from_window(top: float, near: float) -> float:
    """Vertical field of view in degrees of a symmetric window whose top edge is at `top`.

    ``tan(fov_y/2) = top/near`` (lecture 003); the converse is `Perspective.window`.

    Raises
    ------
    ProjectionError
        If a number is not finite or not above 0.
    """
    top, near = finite("top", top), finite("near", near)
    for name, value in (("top", top), ("near", near)):
        if value <= 0.0:
            raise ProjectionError(name, value, ABOVE, 0)
    return math.degrees(2.0 * math.atan2(top, near))


def focal_length_e(fov_y_deg: float, aspect: float) -> float:
    """Lecture 003's focal length e: how far away a plane is seen from x = -1 to 1.

    ``e = 1/tan(fov_x/2)``; its window on the near plane is n/e wide to each side.
    """
    return Perspective(fov_y_deg).cot_half_fov_y / aspect


def fov_y_from_focal_length_e(e: float, aspect: float) -> float:
    """Vertical field of view in degrees, the converse of `focal_length_e`.

    Raises
    ------
    ProjectionError
        If e is not a finite number above 0.
    """
    e = finite("e", e)
    if e <= 0.0:
        raise ProjectionError("e", e, ABOVE, 0)
    return math.degrees(2.0 * math.atan2(1.0, e * aspect))


def focal_length_35mm(fov_y_deg: float, aspect: float) -> float:
    """Focal length in mm of the 36 x 24 mm camera with the same diagonal field of view.

    The diagonal is what the 35-mm equivalent compares (CIPA DCG-001), since images need not
    have the proportions of the film.
    """
    half_diagonal = math.hypot(aspect, 1.0)  # of a picture of half-height 1
    return _FULL_FRAME_DIAGONAL_MM / 2.0 * Perspective(fov_y_deg).cot_half_fov_y / half_diagonal


def fov_y_from_focal_length_35mm(focal_length_mm: float, aspect: float) -> float:
    """Vertical field of view in degrees, the converse of `focal_length_35mm`.

    Raises
    ------
    ProjectionError
        If the focal length is not a finite number above 0.
    """
    focal_length_mm = finite("focal_length_mm", focal_length_mm)
    if focal_length_mm <= 0.0:
        raise ProjectionError("focal_length_mm", focal_length_mm, ABOVE, 0)
    half_height = _FULL_FRAME_DIAGONAL_MM / 2.0 / math.hypot(aspect, 1.0)
    return math.degrees(2.0 * math.atan2(half_height, focal_length_mm))
