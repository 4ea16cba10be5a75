"""Depth buffers: how a distance is stored, and which surfaces become indistinguishable.

============  =============================================================================
mapping       depth in [0, 1] of the distance w from the eye plane (near n, far f)
============  =============================================================================
opengl        ``f/(f - n) (w - n)/w``, by way of an NDC z in [-1, 1] and ``0.5 z + 0.5``
direct3d      ``f/(f - n) (w - n)/w``
reversed      ``n/(f - n) (f - w)/w``
logarithmic   ``log(w/n)/log(f/n)`` (Ulrich, *Logarithmic Depth Buffer*: Kemen's of 2009 without
              its constant C)
============  =============================================================================

with their limits for f = inf, and linear in w for a parallel lens. These are lecture 000's
A + B/w, factored so that nothing cancels: ``w - n`` keeps digits that the sum of two large numbers
loses. For the same reason distances are computed from the *nearness*, which is ``1 - depth`` or
the reversed depth itself.

A format rounds the depth once, to the nearest code. That is the best a buffer can do; a GPU rounds
to float32 on the way there.
"""

import math
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from app.languages import said
from app.model.limits import check_name, within
from app.model.projection import DEPTH_RANGES, Array, Lens, Perspective
from app.model.refusal import REFUSALS, Refusal

Codes: TypeAlias = NDArray[np.uint8] | NDArray[np.uint16] | NDArray[np.uint32]


class DepthFormat(NamedTuple):
    """How a depth in [0, 1] is stored."""

    bits: int  # size of one pixel
    largest: int  # the code of depth 1; codes start at 0
    code_type: DTypeLike  # unsigned type of the codes
    float_type: DTypeLike | None = None
    """The float type whose bit patterns are the codes; None for unsigned normalised integers."""
    digits: int = 0  # significant bits of the float, 0 for an integer


FORMATS: dict[str, DepthFormat] = {
    "fixed8": DepthFormat(8, 2**8 - 1, np.uint8),
    "fixed16": DepthFormat(16, 2**16 - 1, np.uint16),
    "fixed24": DepthFormat(24, 2**24 - 1, np.uint32),
    "fixed32": DepthFormat(32, 2**32 - 1, np.uint32),
    "float16": DepthFormat(16, 0x3C00, np.uint16, np.float16, 11),
    "float32": DepthFormat(32, 0x3F800000, np.uint32, np.float32, 24),
}

MAPPINGS = (*DEPTH_RANGES, "logarithmic")


@dataclass(frozen=True)
class DepthBuffer:
    """A depth buffer and the lens in front of it.

    Its methods take arrays of any shape and return the same shape. Distances are measured from the
    eye plane in world units. The lens clips them to near and far: any other distance raises a
    `Refusal`. So does an unknown name, a typed matrix, and a logarithmic mapping if far is infinite
    or if depth is linear in the distance.
    """

    format: str = "fixed24"
    mapping: str = "opengl"  # how a distance becomes a depth
    lens: Lens = Perspective()  # noqa: RUF009

    def __post_init__(self) -> None:
        check_name("format", self.format, FORMATS)
        check_name("mapping", self.mapping, MAPPINGS)
        far = self.far  # raises a refusal for a typed matrix
        if self.mapping == "logarithmic":
            if not self.lens.depth_slope:
                raise Refusal("mapping", self.mapping, REFUSALS["one-of"], ", ".join(DEPTH_RANGES))
            if far == math.inf:
                raise Refusal("far", far, REFUSALS["finite-number"])

    @property
    def near(self) -> float:
        """Distance of the near plane."""
        return self.lens.near

    @property
    def far(self) -> float:
        """Distance of the far plane; may be infinite."""
        return self.lens.far

    # -- from distance to code

    def depth(self, distance: ArrayLike) -> Array:
        """The depth in [0, 1] of a distance before it is stored, to 4 ulp."""
        return self._depth(self._distances(distance))

    def encode(self, distance: ArrayLike) -> Codes:
        """The code of a distance: ``round(depth (2^bits - 1))``, or the bits of the nearest float.

        Codes are ordered like depths: they decrease with the distance if the mapping is reversed.
        """
        kind = FORMATS[self.format]
        depth = self.depth(distance)
        if kind.float_type is None:
            return np.asarray(np.rint(depth * kind.largest)).astype(kind.code_type)
        if self.mapping == "opengl":  # NDC z is a float32 near -1, whatever was computed
            depth = 0.5 * np.asarray(2.0 * depth - 1.0).astype(np.float32).astype(np.float64) + 0.5
        return np.asarray(depth).astype(kind.float_type).view(kind.code_type)

    def decode(self, code: ArrayLike) -> Array:
        """The distance that a code stands for, to a few ulp; inf for an infinite far plane.

        Raises a `Refusal` for a number that is not a code in this format.
        """
        kind = FORMATS[self.format]
        codes = np.asarray(code)
        wrong = (
            np.ones(codes.shape, bool)
            if codes.dtype.kind not in "iu"
            else (codes < 0) | (codes > kind.largest)
        )
        if wrong.any():
            allowed = said("the whole numbers from 0 to {0}", kind.largest)
            raise Refusal("code", codes[wrong][0].tolist(), REFUSALS["one-of"], allowed)
        if kind.float_type is None:
            depth = codes / kind.largest
            rest = (kind.largest - codes.astype(np.int64)) / kind.largest
        else:
            depth = codes.astype(kind.code_type).view(kind.float_type).astype(np.float64)
            rest = 1.0 - depth
        near, far = self.near, self.far
        if self.mapping == "logarithmic":
            span = self._log_span
            distance = np.where(
                depth < 0.5, near * np.exp(depth * span), far * np.exp(-rest * span)
            )
        else:
            nearness, farness = (depth, rest) if self._is_reversed else (rest, depth)
            with np.errstate(divide="ignore"):
                distance = self.lens.distance(farness, nearness)
        # The ends come back with one rounding error, which must not lie beyond far.
        return np.asarray(np.clip(distance, near, far))

    # -- resolution

    def gap(self, distance: ArrayLike) -> Array:
        """How far behind a surface another one must be to be certain of a different code.

        Some pairs that are closer collapse. inf if even a surface on the far plane may collapse.
        Just below a power of two in the depth, where the steps of a float change, the gap is that
        of the larger step, up to twice too large.

        A step s of the depth is ``w x/(1 - x)`` with ``x = s w (1/n - 1/f)``: for 24 bits and
        far >> near this is slightly more than ``w^2/(n 2^24)``.
        """
        w = self._distances(distance)
        depth = self._depth(w)
        mean, uneven = self._cells(depth)
        toward = -1.0 if self._is_reversed else 1.0
        behind = np.add(*self._cells(np.clip(depth + toward * (mean + uneven), 0.0, 1.0)))
        step = np.maximum(mean + uneven, behind)
        if self.mapping == "logarithmic":
            gap = w * np.expm1(step * self._log_span)
        else:
            gap = self.lens.gap(w, step)
        with np.errstate(invalid="ignore"):  # inf - inf: nothing lies behind a surface at infinity
            return np.asarray(np.where(gap <= self.far - w, gap, np.inf))

    def collapsed_share(self, first: ArrayLike, second: ArrayLike) -> float:
        """Count the share of pairs of surfaces that get the same code; 0 for no pairs."""
        same = self.encode(first) == self.encode(second)
        return float(np.mean(same)) if same.size else 0.0

    def predicted_collapsed_share(self, first: ArrayLike, second: ArrayLike) -> float:
        """The expected share of pairs with the same code, averaged over positions between codes.

        If the depths are d apart and the codes a step s, the probability is ``1 - d/s``, and 0 for
        d > s.
        """
        one, other = self.depth(first), self.depth(second)
        apart = np.abs(one - other)
        mean, uneven = self._cells((one + other) / 2.0)
        share = np.maximum(mean + uneven - apart, 0.0) + np.maximum(mean - uneven - apart, 0.0)
        return float(np.mean(share / (2.0 * mean))) if share.size else 0.0

    # -- the closed forms

    @property
    def _is_reversed(self) -> bool:
        return self.mapping == "reversed"

    @property
    def _log_span(self) -> float:
        """``log(f/n)``, accurate also if near is close to far."""
        return math.log1p((self.far - self.near) / self.near)

    def _distances(self, value: ArrayLike) -> Array:
        try:
            given = np.asarray(value)
        except ValueError:  # rows of different lengths
            raise Refusal("distance", value, REFUSALS["finite-number"]) from None
        if given.dtype.kind not in "iuf":
            raise Refusal("distance", value, REFUSALS["finite-number"])
        distances = given.astype(np.float64)
        inside = (distances >= self.near) & (distances <= self.far)
        if not inside.all():
            wrong = float(distances[~inside][0])
            if math.isnan(wrong):
                raise Refusal("distance", wrong, REFUSALS["finite-number"])
            within("distance", wrong, self.near, self.far)
        return distances

    def _depth(self, w: Array) -> Array:
        """The depth according to the module's table."""
        near = self.near
        if self.mapping == "logarithmic":
            return np.asarray(np.minimum(np.log1p((w - near) / near) / self._log_span, 1.0))
        return self.lens.depth(w, reverse=self._is_reversed)

    def _cells(self, depth: Array) -> tuple[Any, Any]:
        """The mean width of the codes' cells at a depth, and the alternation of the widths.

        The [-1, 1] range rounds twice in a float format: to the steps of NDC and to those of the
        format. Where the steps of NDC are finer, half of them lie midway between two codes and are
        rounded to the even one, whose cell is wider by one step than its neighbours'. Where they
        are coarser, near depth 0, the format's finer steps are never used.
        """
        kind = FORMATS[self.format]
        if kind.float_type is None:
            return np.full_like(depth, 1.0 / kind.largest), np.zeros_like(depth)
        own = _ulp(depth, kind.digits, float(np.finfo(kind.float_type).smallest_subnormal))
        if self.mapping != "opengl":
            return own, np.zeros_like(depth)
        ndc = 0.5 * _ulp(np.abs(2.0 * depth - 1.0), 24, 2.0**-149)
        return np.maximum(own, ndc), np.where(ndc < own, ndc, 0.0)


def _ulp(value: Array, digits: int, smallest: float) -> Array:
    """Distance to the next smaller float with this many digits."""
    _, exponent = np.frexp(np.nextafter(value, 0.0))
    steps = np.ldexp(1.0, exponent - digits)
    return np.asarray(np.where(value > 0.0, np.maximum(steps, smallest), smallest))
