"""Projectors and depth: the formulas that a lens shares with all lenses of its family.

The projectors of a *central* lens meet in the eye: w is the distance from the eye plane, and
pictures shrink with it. Those of a *parallel* lens do not meet: w is 1. Each method states both
formulas, in the order of operations that keeps their digits. For a typed matrix, which has neither
a near nor a far plane, they all raise a `Refusal`.
"""

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any, ClassVar

import numpy as np

from app.model.lenses.answers import ExactWindow, Window
from app.model.limits import Array, Frozen
from app.model.refusal import REFUSALS, Refusal

LENSES: dict[str, Any] = {}  # lenses with fields, by kind; `app.model.lenses` fills in this table


class Geometry(Frozen):
    """What follows from near, far, the window, and whether the projectors meet."""

    kind: ClassVar[str]  # the name of the lens in a document
    central: ClassVar[bool] = False  # whether the projectors meet in the eye
    parallel: ClassVar[bool] = False  # whether they are parallel. A typed matrix is neither.

    @property
    def near(self) -> float:
        """Distance of the near plane from the eye plane."""
        raise self._refusal()

    @property
    def far(self) -> float:
        """Distance of the far plane from the eye plane; infinite only for a central lens."""
        raise self._refusal()

    @property
    def shear(self) -> tuple[float, float]:
        """``cot(alpha), cot(beta)`` of slanted parallel projectors; 0 for other lenses."""
        return 0.0, 0.0

    def exact_window(self, aspect: Fraction) -> ExactWindow:
        """Left, right, bottom, top on the near plane, for an image with this width/height."""
        raise self._refusal()

    def window(self, aspect: Fraction) -> Window:
        """`exact_window`, each side rounded once."""
        left, right, bottom, top = map(float, self.exact_window(aspect))
        return left, right, bottom, top

    @classmethod
    def _refusal(cls) -> Refusal:
        return Refusal("lens.kind", cls.kind, REFUSALS["one-of"], ", ".join(LENSES))

    # -- projectors

    def w(self, distance: Any) -> Any:
        """The divisor of x, y and z at a distance from the eye plane."""
        return distance if self.central else 1.0

    def enlarged(self, distance: Any) -> Any:
        """Size of the window at a distance, as a multiple of its size on the near plane."""
        return self.w(distance) / self.w(self.near)

    def outwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        """Follow projectors from x, y on the near plane to a distance."""
        if self.central:
            k = self.enlarged(distance)
            return x * k, y * k
        cot_alpha, cot_beta = self.shear
        return x + cot_alpha * (distance - self.near), y + cot_beta * (distance - self.near)

    def inwards(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        """Follow projectors from x, y at a distance back to the near plane."""
        if self.central:
            return x / distance * self.near, y / distance * self.near
        cot_alpha, cot_beta = self.shear
        return x - cot_alpha * (distance - self.near), y - cot_beta * (distance - self.near)

    def along(self, x: Any, y: Any, distance: Any) -> tuple[Any, Any]:
        """Change of x and y per unit of distance, along the projectors through these points."""
        return (x / distance, y / distance) if self.central else self.shear

    def rays(self, on_near: Array) -> tuple[Array, Array]:
        """x, y of projectors on the eye plane and their change per unit of distance, (n, 2) each.

        `on_near`, (n, 2), are the points where they meet the near plane.
        """
        if self.central:
            return np.zeros_like(on_near), on_near / self.near
        shear = np.array(self.shear)
        return on_near - shear * self.near, np.broadcast_to(shear, on_near.shape)

    def window_at(self, window: Window, distance: float) -> Window:
        """Move a window from the near plane to a distance, its corners along the projectors."""
        left, bottom = self.outwards(*window[0::2], distance)
        right, top = self.outwards(*window[1::2], distance)
        return left, right, bottom, top

    def slopes(self, aspect: Fraction) -> Window:
        """The window at distance 1 from the eye."""
        left, right, bottom, top = (side / self.near for side in self.window(aspect))
        return left, right, bottom, top

    def section(self, aspect: Fraction) -> Fraction:
        """Area of the picture where w is 1: for a parallel lens, everywhere."""
        left, right, bottom, top = map(Fraction, self.window(aspect))
        return (right - left) * (top - bottom) / Fraction(self.w(self.near)) ** 2

    # -- depth

    def depth(self, distance: Array, *, reverse: bool) -> Array:
        """The depth at a distance: 0 at near and 1 at far, or reversed."""
        near, far = self.near, self.far
        if far == math.inf:
            with np.errstate(invalid="ignore"):
                standard = np.where(distance == math.inf, 1.0, (distance - near) / distance)
            return np.asarray(near / distance if reverse else standard)
        from_plane = far - distance if reverse else distance - near
        if self.parallel:
            return np.asarray(from_plane / (far - near))
        scale = self.depth_scale(near, far, reverse=reverse)
        return np.asarray(np.minimum(scale * (from_plane / distance), 1.0))  # 1 + 1 ulp at the end

    def depth_scale(self, near: Any, far: Any, *, reverse: bool) -> Any:
        """Depth times w, per unit of distance from the plane whose depth is 0; far is finite."""
        return ((near if reverse else far) if self.central else 1) / (far - near)

    def distance(self, gone: Any, left_over: Any) -> Any:
        """The distance of a depth, given its shares of the way from near and to far."""
        if self.central:
            return self.near / (left_over + self.near / self.far * gone)
        return self.near * left_over + self.far * gone

    def gap(self, distance: Array, step: Array) -> Array:
        """Increase of the distance for a step of its depth; infinite beyond the far plane."""
        near, far = self.near, self.far
        if self.parallel:
            return step * (far - near)
        with np.errstate(invalid="ignore", divide="ignore"):
            x = distance / near * step * (1.0 if far == math.inf else (far - near) / far)
            return np.where(x < 1.0, distance * (x / (1.0 - x)), np.inf)

    @property
    def depth_slope(self) -> float:
        """The a in the depth ``constant - a/w``; 0 for a lens with linear depth."""
        if not self.central:
            return 0.0
        return (
            self.near
            if self.far == math.inf
            else self.near * self.depth_scale(self.near, self.far, reverse=False)
        )

    @property
    def even_extent(self) -> float:
        """``far - near`` of a lens whose depth is linear in the distance; 0 for the others."""
        return self.far - self.near if self.parallel else 0.0

    @property
    def eye_room(self) -> float:
        """Least drawn distance from the eye; infinite for a lens without an eye."""
        return self.near if self.central else math.inf

    # -- the canonical volumes

    @property
    def _ratio(self) -> float:
        """z of the near plane in the canonical pyramid, mirrored: near/far, or 1 for far = inf."""
        return 1.0 if self.far == math.inf else self.near / self.far

    @property
    def canonical_from_box(self) -> Array:
        """The first canonical volume from a box with z = 1 at near and 0 at far, (4, 4)."""
        if self.parallel:
            return np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -1], [0, 0, 0, 1]])
        # near/far M_pp^-1, without the difference of 1 and near/far.
        near, far, ratio = self.near, self.far, self._ratio
        matrix = np.diag([ratio, ratio, 0.0, 0.0])
        if far == math.inf:
            matrix[2:, 2:] = (0.0, -1.0), (1.0, 0.0)
        else:
            matrix[2:, 2:] = (0.0, -ratio), ((far - near) / far, ratio)
        return matrix

    def edges(self, at: Callable[[float], Array]) -> tuple[Array, Array]:
        """The near corners of the view volume and the edges from there to far, (4, 3) each.

        `at` takes a z of the first canonical volume to its four corners there, in view space.
        """
        if self.parallel:
            first = at(0.0)
            return first, at(-1.0) - first
        # The far corners, or the near ones of an infinite frustum, are rays times a length.
        near, far, rays = self.near, self.far, at(-1.0)
        along = rays * ((far - near) / far if far < math.inf else math.inf)
        along[np.isnan(along)] = 0.0  # 0 times infinity, on an axis
        return rays * self._ratio, along
