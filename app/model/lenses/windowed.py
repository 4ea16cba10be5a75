"""Lenses that are defined by a window: left, right, bottom and top on the near plane."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, ClassVar

from app.model.lenses.answers import ExactWindow, Window
from app.model.lenses.lens import Lens, plane_letters
from app.model.limits import (
    BOTTOM_BEFORE_TOP,
    DISTINCT,
    LEFT_BEFORE_RIGHT,
    ONE_OF,
    SMALLEST_WINDOW,
    WIDER,
    Keep,
    finite,
    keep_checked,
)
from app.model.refusal import Refusal, format_value

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

    left: float
    right: float
    bottom: float
    top: float
    near: float = 1.0
    far: float = 30.0
    keep: Keep = "stretch"

    def __post_init__(self) -> None:
        names = ("left", "right", "bottom", "top")
        left, right, bottom, top = (finite(n, getattr(self, n)) for n in names)
        near, far = self.checked_planes(self.near, self.far)
        keep_checked(self, left=left, right=right, bottom=bottom, top=top, near=near, far=far)
        for name, low, high, bound in (
            ("left", left, right, LEFT_BEFORE_RIGHT),
            ("bottom", bottom, top, BOTTOM_BEFORE_TOP),
        ):
            if low >= high:
                raise Refusal(name, low, bound, format_value(high))
        self.check_window(left, right, bottom, top)
        if self.keep not in ("stretch", "x", "y"):
            raise Refusal("keep", self.keep, ONE_OF, "stretch, x, y")

    @property
    def least_window(self) -> float:
        """The least width and height of the window, in world units."""
        return SMALLEST_WINDOW

    def check_window(self, left: float, right: float, bottom: float, top: float) -> None:
        """Raise a `Refusal` if the window, as typed or after `keep`, is too small for the lens."""
        for name, low, high in (("left", left, right), ("bottom", bottom, top)):
            if high - low < self.least_window:
                bound = DISTINCT if self.parallel else WIDER
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
                raise Refusal(name, low, DISTINCT, format_value(high))
        self.check_window(*window)

    def fits(self, aspect: float) -> bool:
        fitted = aspect * (self.top - self.bottom)
        return math.isclose(self.right - self.left, fitted, rel_tol=_ROUNDING)

    def sides(self, window: Window) -> dict[str, Any]:
        """The fields of a window that does not follow the image."""
        names = ("left", "right", "bottom", "top")
        return {**dict(zip(names, window, strict=True)), "keep": "stretch"}

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
