"""The pipeline at 80 digits with mpmath, straight from the definitions of the lectures.

The inputs are the float64 numbers of a `Projection`, taken as exact. Nothing is rearranged for
accuracy: with 80 digits there is no need to.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any, NamedTuple

import mpmath

from app.model.chain import Tile
from app.model.projection import Chain, FreeMatrix, Oblique, Perspective, Projection

mp = mpmath.mp.clone()
mp.dps = 80

Numbers = list[Any]


class Answer(NamedTuple):
    """One point at 80 digits: view, ndc (3), image (2), depth in [0, 1], clip w."""

    view: Numbers
    ndc: Numbers
    image: Numbers
    depth: Any
    w: Any


def vector(values: Sequence[float]) -> Numbers:
    """Float64 numbers, exactly; what has more digits already keeps them."""
    return [value if isinstance(value, mp.mpf) else mp.mpf(float(value)) for value in values]


def placed(placement: Chain, point: Sequence[float]) -> Numbers:
    """A point of the object in the world, moved by one tile after the other from the right."""
    here = vector(point)
    for tile in reversed(placement.tiles):
        if not tile.is_off:
            here = _moved(tile, here)
    return here


def _moved(tile: Tile, p: Numbers) -> Numbers:
    """A point after one move, by the move's definition and without its matrix."""
    kind, _, axes = tile.kind.partition(" ")
    numbers = vector(tile.numbers)
    if kind == "translate":
        return [a + b for a, b in zip(p, numbers, strict=True)]
    if kind == "scale":
        return [a * b for a, b in zip(p, numbers, strict=True)]
    if kind == "matrix":
        return [dot(numbers[row : row + 3], p) + numbers[row + 3] for row in (0, 4, 8)]
    if kind == "rotate":  # Rodrigues' formula
        *about, angle_deg = numbers if not axes else [*(mp.mpf(x == axes) for x in "xyz"), *numbers]
        length = mp.sqrt(dot(about, about))
        k, angle = [part / length for part in about], mp.radians(angle_deg)
        along = dot(k, p) * (1 - mp.cos(angle))
        return [
            a * mp.cos(angle) + b * mp.sin(angle) + c * along
            for a, b, c in zip(p, cross(k, p), k, strict=True)
        ]
    moved = list(p)
    i = "xyz".index(axes[0])
    moved[i] = -p[i] if kind == "mirror" else p[i] + numbers[0] * p["xyz".index(axes[1])]
    return moved


def minus(a: Numbers, b: Numbers) -> Numbers:
    return [p - q for p, q in zip(a, b, strict=True)]


def dot(a: Numbers, b: Numbers) -> Any:
    return mp.fsum(p * q for p, q in zip(a, b, strict=True))


def cross(a: Numbers, b: Numbers) -> Numbers:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a: Numbers) -> Numbers:
    length = mp.sqrt(dot(a, a))
    return [part / length for part in a]


def frame(eye: Sequence[float], target: Sequence[float], up: Sequence[float]) -> list[Numbers]:
    """Rows u, v, n as lecture 004 defines them."""
    n = unit(minus(vector(eye), vector(target)))
    u = unit(cross(vector(up), n))
    return [u, cross(n, u), n]


def cotangent_deg(angle_deg: float) -> Any:
    """The cotangent of an angle in degrees."""
    return mp.mpf(0) if angle_deg == 90 else mp.cot(mp.mpf(angle_deg) * mp.pi / 180)


class Exact:
    """A projection's answers at 80 digits; the frame is worked out once."""

    def __init__(self, projection: Projection) -> None:
        self.projection = projection
        camera = projection.camera
        self.frame = frame(camera.eye, camera.target, camera.up)
        width, height = projection.image_size
        self.width, self.height = mp.mpf(width), mp.mpf(height)
        self.z_near, self.z_far = {
            "opengl": (mp.mpf(-1), mp.mpf(1)),
            "direct3d": (mp.mpf(0), mp.mpf(1)),
            "reversed": (mp.mpf(1), mp.mpf(0)),
        }[projection.depth]

    def window(self) -> Numbers:
        """Left, right, bottom, top after `keep` (lecture 000, variants X and Y)."""
        lens = self.projection.lens
        if isinstance(lens, Perspective):
            top = mp.mpf(lens.near) * mp.tan(mp.mpf(lens.fov_y_deg) * mp.pi / 360)
            right = top * self.width / self.height
            return [-right, right, -top, top]
        if not lens.window_stays:  # a lens that this oracle does not know
            sides = lens.exact_window(Fraction(*self.projection.image_size))
            return [mp.mpf(side.numerator) / side.denominator for side in sides]
        left, right = mp.mpf(lens.left), mp.mpf(lens.right)
        bottom, top = mp.mpf(lens.bottom), mp.mpf(lens.top)
        if lens.keep == "x":  # about its centre until the aspect is the image's
            middle, half = (bottom + top) / 2, (right - left) * self.height / self.width / 2
            bottom, top = middle - half, middle + half
        elif lens.keep == "y":
            middle, half = (left + right) / 2, (top - bottom) * self.width / self.height / 2
            left, right = middle - half, middle + half
        return [left, right, bottom, top]

    def __call__(self, point: Sequence[float]) -> Answer:
        lens = self.projection.lens
        if isinstance(lens, FreeMatrix):
            return self._free(lens, point)
        offset = minus(vector(point), vector(self.projection.camera.eye))
        x, y, z = view = [dot(row, offset) for row in self.frame]
        near, far = mp.mpf(lens.near), mp.mpf(lens.far)
        left, right, bottom, top = self.window()
        if lens.parallel:
            w = mp.mpf(1)
            part = (-z - near) / (far - near)  # of the way from near to far
            if isinstance(lens, Oblique):  # lecture 002's H, whose z_n is -near
                x = x - (-near - z) * cotangent_deg(lens.alpha_deg)
                y = y - (-near - z) * cotangent_deg(lens.beta_deg)
        else:
            w = -z
            x, y = near * x / w, near * y / w  # lecture 000 (4)
            # 1/w runs evenly from 1/near to 1/far over the depth range.
            one_over_far = 0 if mp.isinf(far) else 1 / far
            part = (1 / near - 1 / w) / (1 / near - one_over_far)
        x_ndc = 2 * (x - left) / (right - left) - 1
        y_ndc = 2 * (y - bottom) / (top - bottom) - 1
        z_ndc = self.z_near + part * (self.z_far - self.z_near)
        return self._answer(view, [x_ndc, y_ndc, z_ndc], w)

    def _free(self, lens: FreeMatrix, point: Sequence[float]) -> Answer:
        """By the typed cells; where w is 0 the quotients are infinite."""
        if lens.view_from_world is None:
            offset = minus(vector(point), vector(self.projection.camera.eye))
            view = [*(dot(row, offset) for row in self.frame), mp.mpf(1)]
        else:
            view = [dot(vector(row), [*vector(point), 1]) for row in lens.view_from_world]
        *clip, w = (dot(vector(row), view) for row in lens.clip_from_view)
        ndc = [part / w if w else mp.inf for part in clip]
        return self._answer([part / view[3] if view[3] else mp.inf for part in view[:3]], ndc, w)

    def _answer(self, view: Numbers, ndc: Numbers, w: Any) -> Answer:
        x_ndc, y_ndc, z_ndc = ndc
        low, high = min(self.z_near, self.z_far), max(self.z_near, self.z_far)
        return Answer(
            view,
            ndc,
            [self.width / 2 * (x_ndc + 1), self.height / 2 * (1 - y_ndc)],
            (z_ndc - low) / (high - low),
            w,
        )
