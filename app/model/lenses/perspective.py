"""The symmetric perspective lens, and the canonical pyramid that every perspective lens has.

The canonical volumes and M_pp are lecture 001's, the matrix is equation (13) of lecture 000.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from types import MappingProxyType
from typing import ClassVar

from app.arithmetic.double_double import cotangent_deg
from app.arithmetic.rationals import Rationals
from app.model.lenses.answers import Angles, Axes, ExactWindow, Intrinsics, Window
from app.model.lenses.central import FULL_FRAME_DIAGONAL_MM, Central
from app.model.lenses.lens import NEAR, LensTable, plane_letters
from app.model.lenses.solving import angle_deg
from app.model.limits import SMALLEST_FIELD, Array, Keep, between, keep_checked, positive
from app.model.parameter import Parameter, stated
from app.model.refusal import REFUSALS, Refusal
from app.model.tables import (
    DEPTH_RANGE,
    SCALED_BY_NEAR,
    TO_PYRAMID,
    PipelineStep,
    formulas_of,
    matrix,
    matrix_of,
    rows_of,
)

# --------------------------------------------------------------------------- the table

SCALE = rows_of("perspective scale")


def pyramid_tables(
    factors: Mapping[str, str],
    clip_from_view: str,
    view_from_clip: str,
    fields: Mapping[str, tuple[str, ...]] = MappingProxyType({}),
) -> tuple[LensTable, LensTable]:
    """The table of a perspective lens, and the one with its far plane at infinity.

    `factors` make up the step to the canonical pyramid; the closed forms contain the letters A, B,
    C and D.
    """

    def table(
        d: str,
        at: str = "",
        note: str = "",
        otherwise: Mapping[str, LensTable] = MappingProxyType({}),
    ) -> LensTable:
        to_pyramid = tuple((name, matrix(text, d=d)) for name, text in factors.items())
        to_box = (("M_pp", matrix_of(f"perspective M_pp{at}")),)
        to_clip = (("scale", matrix_of("perspective w", d=d)),)
        depth = formulas_of(f"perspective depth{at}")
        return LensTable(
            (
                PipelineStep(TO_PYRAMID, to_pyramid, note),
                PipelineStep("canonical_parallel_from_canonical_perspective", to_box, note),
                DEPTH_RANGE,
                PipelineStep("clip_from_depth_range", to_clip),
            ),
            matrix(clip_from_view, **depth),
            matrix(view_from_clip, **depth),
            otherwise,
            fields,
            written={"002": formulas_of("perspective in lecture 002")},
        )

    finite = table("f")
    limit = table("n", " at infinity", SCALED_BY_NEAR, {"far": finite})
    return finite, limit


TABLE, TABLE_AT_INFINITY = pyramid_tables(
    {"scale": SCALE}, rows_of("perspective clip_from_view"), rows_of("perspective view_from_clip")
)


# --------------------------------------------------------------------------- the lens

FOV_Y = stated(
    "fov_y_deg", section="lens", place="lens", unit="°", span=(1.0, 179.0), step=0.5,
    letter="fov", formula="fov", shows=("fov",), makes=("bottom", "top"), handle="corner",
)  # fmt: skip


@dataclass(frozen=True)
class Perspective(Central):
    """The symmetric perspective lens (gluPerspective); the aspect is the image's.

    ``0 < fov_y_deg < 180`` is the vertical field of view. ``0 < near < far`` are distances from
    the eye; far may be ``inf``.
    """

    kind: ClassVar[str] = "perspective"
    tables: ClassVar[tuple[LensTable, ...]] = (TABLE, TABLE_AT_INFINITY)
    symmetric: ClassVar[bool] = True
    parameters: ClassVar[tuple[Parameter, ...]] = (FOV_Y,)

    fov_y_deg: float = 45.0
    near: float = 1.0
    far: float = 30.0

    def __post_init__(self) -> None:
        fov_y_deg = between("fov_y_deg", self.fov_y_deg, 0, 180)
        if fov_y_deg < SMALLEST_FIELD:
            raise Refusal("fov_y_deg", fov_y_deg, REFUSALS["at-least"], SMALLEST_FIELD)
        near, far = self.checked_planes(self.near, self.far)
        keep_checked(self, fov_y_deg=fov_y_deg, near=near, far=far)

    @property
    def cot_half_fov_y(self) -> float:
        """``cot(fov_y/2)``, the distance of the picture in units of its half-height.

        Above 90 degrees it is the tangent of the complement: ``180 - fov`` is exact there, and the
        result stays within 2 ulp up to 180.
        """
        if self.fov_y_deg > 90.0:
            return math.tan(math.radians(180.0 - self.fov_y_deg) / 2.0)
        return 1.0 / math.tan(math.radians(self.fov_y_deg) / 2.0)

    def exact_window(self, aspect: Fraction) -> ExactWindow:
        """The sides before they are rounded; the tangent has `double_double.BITS` bits."""
        top = Fraction(self.near) / cotangent_deg(Fraction(self.fov_y_deg) / 2)
        right = aspect * top
        return -right, right, -top, top

    def window(self, aspect: Fraction) -> Window:
        """The sides in float64; the width follows from the rounded height, as where `keep` is y."""
        top = float(self.exact_window(aspect)[3])
        right = float(aspect * Fraction(top))
        return -right, right, -top, top

    @classmethod
    def with_window(cls, window: Window, near: float, far: float, keep: Keep) -> "Perspective":
        _, _, bottom, top = window
        return cls(fov_y_from_window((top - bottom) / 2.0, near), near, far)

    def angles(self, aspect: Fraction) -> Angles:
        fov_x_deg = fov_x_from_fov_y(self.fov_y_deg, float(aspect))
        return Angles(fov_x_deg, self.fov_y_deg, focal_length_35mm(self.fov_y_deg, float(aspect)))

    def slopes(self, aspect: Fraction) -> Window:
        up = 1.0 / self.cot_half_fov_y
        return -float(aspect) * up, float(aspect) * up, -up, up

    def section(self, aspect: Fraction) -> Fraction:
        return 4 * Fraction(float(aspect)) / Fraction(self.cot_half_fov_y) ** 2

    def dollied(self, window: Window, factor: float) -> "Perspective":
        fov_y_deg = math.degrees(2.0 * math.atan2(1.0, factor * self.cot_half_fov_y))
        return replace(self, fov_y_deg=fov_y_deg)

    def intrinsics(self, image_size: tuple[int, int]) -> Intrinsics:
        width, height = image_size  # square pixels, and the axis in the middle
        focal = height / 2.0 * self.cot_half_fov_y
        return Intrinsics(focal, focal, (width - 1) / 2.0, (height - 1) / 2.0)

    def pictured(
        self, axes: Axes, aspect: float, x: Array, y: Array, distance: Array
    ) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        w, scale_y = distance, self.cot_half_fov_y
        scale_x = scale_y / aspect
        return (scale_x * x, scale_y * y), (scale_x * (x / w), scale_y * (y / w))

    @classmethod
    def solved(cls, cells: Rationals, near: float, far: float) -> "Perspective":
        return cls(_fov_y_deg(cells[1][1]), near, far)

    def exact_letters(self, aspect: Fraction) -> dict[str, Fraction]:
        cot = cotangent_deg(Fraction(self.fov_y_deg) / 2)
        return {**plane_letters(self.near, self.far), "cot(fov/2)": cot, "aspect": aspect}

    def letters(self, aspect: Fraction) -> dict[str, float]:
        cot = self.cot_half_fov_y
        return {"n": self.near, "f": self.far, "cot(fov/2)": cot, "aspect": float(aspect)}


# --------------------------------------------------------------------------- field of view


def _fov_y_deg(cot: Fraction) -> float:
    """The field of view in degrees, from the cotangent of its half."""
    if cot <= 0:
        raise ZeroDivisionError
    return angle_deg(cot, 0.0, times=2)


def fov_x_from_fov_y(fov_y_deg: float, aspect: float) -> float:
    """Horizontal field of view of a symmetric lens: ``tan(fov_x/2) = aspect tan(fov_y/2)``.

    The inverse is this function with ``1/aspect``.
    """
    complement_deg = (180.0 - fov_y_deg) / 2.0
    sin_half = math.sin(math.radians(fov_y_deg / 2.0))
    cos_half = math.sin(math.radians(complement_deg))
    return math.degrees(2.0 * math.atan2(aspect * sin_half, cos_half))


def fov_y_from_window(top: float, near: float) -> float:
    """Vertical field of view of a symmetric window: ``tan(fov_y/2) = top/near`` (lecture 003).

    Raises a `Refusal` if a number is not finite or not above 0.
    """
    top, near = positive("top", top), positive(NEAR.name, near)
    return math.degrees(2.0 * math.atan2(top, near))


def focal_length_e(fov_y_deg: float, aspect: float) -> float:
    """Lecture 003's focal length ``e = 1/tan(fov_x/2)``: x from -1 to 1 is visible at distance e.

    On the near plane the window is n/e wide to each side.
    """
    return Perspective(fov_y_deg).cot_half_fov_y / aspect


def fov_y_from_focal_length_e(e: float, aspect: float) -> float:
    """The inverse of `focal_length_e`, or a `Refusal` if e is not a finite number above 0."""
    return math.degrees(2.0 * math.atan2(1.0, positive("e", e) * aspect))


def focal_length_35mm(fov_y_deg: float, aspect: float) -> float:
    """Focal length in mm of the 36 x 24 mm camera with the same diagonal field of view.

    The 35-mm equivalent compares diagonals (CIPA DCG-001), since images need not have the
    proportions of the film.
    """
    half_diagonal = math.hypot(aspect, 1.0)  # of a picture of half-height 1
    return FULL_FRAME_DIAGONAL_MM / 2.0 * Perspective(fov_y_deg).cot_half_fov_y / half_diagonal


def fov_y_from_focal_length_35mm(focal_length_mm: float, aspect: float) -> float:
    """The inverse of `focal_length_35mm`, or a `Refusal` for a length that is not above 0."""
    focal_length_mm = positive("focal_length_mm", focal_length_mm)
    half_height = FULL_FRAME_DIAGONAL_MM / 2.0 / math.hypot(aspect, 1.0)
    return math.degrees(2.0 * math.atan2(half_height, focal_length_mm))
