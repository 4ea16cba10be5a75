"""Right and wrong answers of the exercises of L17 to L27, reckoned without the lessons' formulas.

Each is reckoned another way than the lesson's formula: by the lecture's matrix and its divide, by
cutting a ray with a plane, by bisecting for a limit, in 40 digits. The numbers are those of the
exercise's ``vary`` lines. A wrong answer is the rule of its idea (TEACHING, section 2).
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from mpmath import atan, cos, findroot, mp, mpf, radians, sin, sqrt, tan

from tests.lessons.by_hand import cross, unit

mp.dps = 50

Point = tuple[Any, ...]
_C = mpf("0.00003")
_F = mpf("0.05")


def _plus(p: Point, q: Point, times: Any = 1) -> Point:
    """``p + times q``."""
    return tuple(a + times * b for a, b in zip(p, q, strict=True))


def _depth_buffer(n: Any, f: Any, D: Any) -> tuple[Any, Any, Any]:
    """003: A z + B, that divided by w = -z, and 0 to 1, at z = -D."""
    a, b = -(f + n) / (f - n), -2 * f * n / (f - n)
    clip = a * -D + b
    return clip, clip / D, (clip / D + 1) / 2


def _gap(n: Any, f: Any, D: Any) -> Any:
    """How far behind D the stored number is larger by one step of 16 bits; 1/D changes evenly."""
    stored = _depth_buffer(n, f, D)[2] + 1 / mpf(65535)
    return 1 / (1 / n + stored * (1 / f - 1 / n)) - D


def _on_ground(light: Point, point: Point, height: Any = 0) -> Point:
    """002: where the ray from the lamp through a point meets y = height."""
    t = (light[1] - height) / (light[1] - point[1])
    return _plus(light, _plus(point, light, -1), t)


def _by_the_sun(light: Point, point: Point) -> Point:
    """The same if the lamp's place is taken for the sun's direction."""
    return _plus(point, light, -point[1] / light[1])


def _row(x: Any, y: Any, z: Any, w: Any, h: Any) -> Point:
    """The first row of (p.L) I - L p^T, from its action on the four unit points."""
    p, light = (0, 1, 0, -h), (x, y, z, w)
    dot = sum(a * b for a, b in zip(p, light, strict=True))
    return tuple((dot if j == 0 else 0) - light[0] * p[j] for j in range(4))


def _places(b: Any) -> Any:
    """How far apart 2^b places are over 8 units, the first and the last at its ends."""
    return mpf(8) / (len(range(2 ** int(b))) - 1)


def _apart(y: Any, D: Any, fov: int) -> Any:
    """How many of 240 pixels are between the images of 0 and y."""
    return 240 * (y / (D * tan(radians(mpf(fov) / 2)))) / 2


def _next_to(x: Any) -> Any:
    """How far it is from a number to the next float32."""
    return mpf(float(np.spacing(np.float32(x))))


def _turned(degrees: Any, fov: Any) -> Any:
    """How far the middle of 720 lines is drawn from itself after a turn."""
    across, depth = sin(radians(degrees)), cos(radians(degrees))
    return 360 * cos(radians(fov / 2)) / sin(radians(fov / 2)) * across / depth


def _metres(depth: Any) -> Any:
    """How much a picture of 40 degrees shows at a depth, from bottom to top."""
    return 2 * depth * sin(radians(20)) / cos(radians(20))


def _through_pixel(x: Any, y: Any, z: Any) -> Point:
    """The view-space point at a depth that 1280 x 720 pixels, 640 of them a tangent, show there."""
    return (x - 640) * z / 640, (360 - y) * z / 640, -z


def _pixel(p: Point) -> Point:
    return 640 + 640 * p[0] / -p[2], 360 - 640 * p[1] / -p[2]


def _seen_at(z_1: Any, z_2: Any, t: Any) -> tuple[Any, Any]:
    """Depth, and the part of the edge, that a ray meets at the share t of an edge's picture.

    The edge runs from (0, -z_1) to (z_2, -z_2), so that its picture, x/(-z), runs from 0 to 1.
    """
    part = t * z_1 / (t * z_1 + (1 - t) * z_2)  # from part z_2 = t (z_1 + part (z_2 - z_1))
    return z_1 + part * (z_2 - z_1), part


def _v(a: Any, b: Any, c: Any, normed: bool) -> Point:
    """004: v = n x u with u = V x n, made 1 long or not."""
    n = unit((a, b, c))
    across = cross((0, 1, 0), n)
    return cross(n, unit(across) if normed else across)


def _sharp(s: Any, N: Any, F: Any, far: bool) -> Any:
    """Where the disc b = (F/N) F |D - s|/(D (s - F)) of Ray is c, behind the focus or before it."""
    share = _C * N * (s - F) / (F * F)  # of |D - s| in D
    return s / (1 - share) if far else s / (1 + share)


def _obscura(pixel: Point, d: Any, turn: tuple[int, int]) -> Point:
    x, y = pixel
    return 640 + turn[0] * (x - 640) * d / 4, 360 + turn[1] * (y - 360) * d / 4


def _corner(x_1: Any, e: Any, s: Any, t: Any) -> Point:
    """The pixel of the corner (s, t, 0.5): eye ((x_1 - 640)/100, e, 9), target (0, 2.5, 0), 40°."""
    eye = (x_1 - 640) / 100, e, mpf(9)
    n = unit(_plus(eye, (0, mpf("2.5"), 0), -1))
    u = unit(cross((0, 1, 0), n))
    v = cross(n, u)
    way = _plus((s, t, mpf("0.5")), eye, -1)
    x, y, z = (sum(a * b for a, b in zip(axis, way, strict=True)) for axis in (u, v, n))
    half = 360 / tan(radians(20))
    return 640 + half * x / -z, 360 - half * y / -z


def _set(**values: Any) -> str:
    return " ".join(
        f"{name.replace('__', '.')}={','.join(mp.nstr(part, 17) for part in parts)}"
        for name, value in values.items()
        for parts in [value if isinstance(value, tuple) else (mpf(value),)]
    )


def _near_for(q: Any, D: Any, f: Any) -> Any:
    """The near plane with which q is stored at D, by bisection."""
    low, high = mpf(0), D
    for _ in range(120):
        middle = (low + high) / 2
        if _depth_buffer(middle, f, D)[2] > q:
            low = middle
        else:
            high = middle
    return low


def _ridden(q: Any, k: Any) -> str:
    """The distance at which (d + 0.56)/(d - 0.64) = q, relative to the preset's 3."""
    d = findroot(lambda at: (at + mpf("0.56")) / (at - mpf("0.64")) - q, 1 / (q - 1) + 1)
    return _set(settings__distance=d / 3)


def _focused(s: Any, b: Any) -> str:
    """A focus, and the aperture with which the disc of a point at b is c."""
    return _set(settings__focus=s, settings__aperture=_F * _F * (b - s) / (b * (s - _F)) / _C)


def _least(s: Any, e: Any, z: Any, a: Any, straight: bool) -> Point:
    """Of the F's four corners seen from above, the least deep one, or the one nearest to the eye.

    The eye is at (-e s, z); the camera looks along -n, n = (s sin a, cos a).
    """
    n = s * sin(radians(a)), cos(radians(a))

    def far(corner: Point) -> Any:
        way = corner[0] + e * s, corner[2] - z
        return sqrt(way[0] ** 2 + way[1] ** 2) if straight else -(n[0] * way[0] + n[1] * way[1])

    half = mpf(1) / 2
    return min(((x, mpf(5), y) for x in (-_P[0], _P[0]) for y in (-half, half)), key=far)


def _last_tree(x: Any, z: Any, far: Any, straight: bool) -> Point:
    """The last tree of a row, x beside the way, that is less deep or less distant than far."""

    def is_seen(number: int) -> bool:
        depth = z + 6 * number
        return bool((sqrt(depth**2 + x**2) if straight else depth) < far)

    return mpf(4), mpf(0), mpf(-6 * max(number for number in range(60) if is_seen(number)))


_17, _18, _19 = "l17-depth-buffer", "l18-interpolation", "l19-planar-shadow"
_20, _21, _22 = "l20-zoom-or-walk", "l21-camera-obscura", "l22-walk-round-the-f"
_23, _24 = "l23-popping", "l24-focus"
_25 = "l25-how-many-bits"
_26 = "l26-small-errors"
_27 = "l27-where-precision-goes"
_P: tuple[Any, ...] = mpf("1.5"), mpf(5), mpf("0.5")


def _mean_of_nearness(q: Any, n: Any) -> Any:
    """The distance whose 1/w is half-way between near n and far n q^2."""
    return 1 / ((1 / n + 1 / (n * q**2)) / 2)


KEYS: dict[tuple[str, str, str], Callable[..., Any]] = {
    # L17. 003's A and B; 000's gap; TEACHING linear-z, ndc-01, w-kept.
    (_17, "practise-1/stored", "right"): lambda n, f, D: _depth_buffer(n, f, D)[2],
    (_17, "practise-1/stored", "ndc-01"): lambda n, f, D: _depth_buffer(n, f, D)[1],
    (_17, "practise-1/stored", "w-kept"): lambda n, f, D: (_depth_buffer(n, f, D)[0] + 1) / 2,
    (_17, "practise-1/stored", "linear-z"): lambda n, f, D: 1 - (f - D) / (f - n),
    (_17, "practise-2/gap", "right"): _gap,
    (_17, "practise-2/gap", "linear-z"): lambda n, f, D: (f - n) / mpf(65535),
    (_17, "practise-2/gap", "one-d"): lambda n, f, D: D * (1 / n - 1 / f) / 65535,
    (_17, "practise-3/set", "done"): lambda q, D, f: _set(lens__near=_near_for(q, D, f)),
    # L18. 003: a grows evenly along the edge itself, and the ray at t meets it at `_seen_at`.
    (_18, "practise-1/value", "right"): lambda z_1, t, a_1, a_2: (
        a_1 + _seen_at(z_1, z_1 + 10, t)[1] * (a_2 - a_1)
    ),
    (_18, "practise-1/value", "affine-mid"): lambda z_1, t, a_1, a_2: a_1 + t * (a_2 - a_1),
    (_18, "practise-1/value", "undivided"): lambda z_1, t, a_1, a_2: (
        (a_1 + _seen_at(z_1, z_1 + 10, t)[1] * (a_2 - a_1)) / _seen_at(z_1, z_1 + 10, t)[0]
    ),
    (_18, "practise-2/depth", "right"): lambda z_1, z_2, t, **_: _seen_at(z_1, z_2, t)[0],
    (_18, "practise-2/depth", "affine-mid"): lambda z_1, z_2, t, **_: z_1 + t * (z_2 - z_1),
    (_18, "practise-2/depth", "swapped-ends"): lambda z_1, z_2, t, **_: _seen_at(z_2, z_1, t)[0],
    (_18, "practise-3/middle", "right"): lambda z_1, z_2, x_1, x_2, y_1, y_2: _pixel(
        _plus(_through_pixel(x_1, y_1, z_1), _through_pixel(x_2, y_2, z_2))
    ),
    (_18, "practise-3/middle", "affine-mid"): lambda z_1, z_2, x_1, x_2, y_1, y_2: (
        (x_1 + x_2) / 2, (y_1 + y_2) / 2
    ),
    (_18, "practise-3/middle", "near-end"): lambda z_1, z_2, x_1, x_2, y_1, y_2: _pixel(
        _plus(_through_pixel(x_1, y_1, z_2), _through_pixel(x_2, y_2, z_1))
    ),
    # L19. 002: the ray from the lamp; TEACHING sun-lamp.
    (_19, "practise-1/shadow", "right"): lambda L_x, L_y: _on_ground((L_x, L_y, 1), _P)[0],
    (_19, "practise-1/shadow", "sun-lamp"): lambda L_x, L_y: _by_the_sun((L_x, L_y, 1), _P)[0],
    (_19, "practise-1/shadow", "from-p"): lambda L_x, L_y: (
        _P[0] + _on_ground((L_x, L_y, 1), _P)[0] - L_x
    ),
    (_19, "practise-2/row", "right"): lambda L_x, L_y, L_z, h: _row(L_x, L_y, L_z, 1, h),
    (_19, "practise-2/row", "sun-lamp"): lambda L_x, L_y, L_z, h: _row(L_x, L_y, L_z, 0, h),
    (_19, "practise-2/row", "plane-sign"): lambda L_x, L_y, L_z, h: _row(L_x, L_y, L_z, 1, -h),
    (_19, "practise-2/row", "transposed"): lambda L_x, L_y, L_z, h: (L_y - h, 0, 0, 0),
    (_19, "practise-3/place", "right"): lambda L_x, L_y, L_z, P_x, P_z: _on_ground(
        (L_x, L_y, L_z), (P_x, mpf(5), P_z)
    ),
    (_19, "practise-3/place", "sun-lamp"): lambda L_x, L_y, L_z, P_x, P_z: _by_the_sun(
        (L_x, L_y, L_z), (P_x, mpf(5), P_z)
    ),
    # L20. 001: on the film F/D; TEACHING angle-linear, zoom-move.
    (_20, "practise-1/distance", "right"): lambda F_1, F_2, D_1: F_2 / (F_1 / D_1),
    (_20, "practise-1/distance", "angle-linear"): lambda F_1, F_2, D_1: (
        D_1 * atan(18 / F_1) / atan(18 / F_2)
    ),
    (_20, "practise-1/distance", "turned-over"): lambda F_1, F_2, D_1: F_1 / (F_2 / D_1),
    (_20, "practise-2/ratio", "right"): lambda D_1, D_2: 1 + mpf("1.2") / D_2,
    (_20, "practise-2/ratio", "zoom-move"): lambda D_1, D_2: 1 + mpf("1.2") / D_1,
    (_20, "practise-2/ratio", "same-size"): lambda D_1, D_2: 1,
    (_20, "practise-3/ratio-set", "done"): _ridden,
    # L21. 001: h' = -d h/z, from the two ends of the arrow; TEACHING mirror, from-plane.
    (_21, "practise-1/height", "right"): lambda d, z, h: d * (-h / 2) / z - d * (h / 2) / z,
    (_21, "practise-1/height", "mirror"): lambda d, z, h: d * (h / 2) / z - d * (-h / 2) / z,
    (_21, "practise-1/height", "from-plane"): lambda d, z, h: -h * d / (d + z),
    (_21, "practise-2/corner", "right"): lambda d, **p: _obscura(_corner(**p), d, (-1, -1)),
    (_21, "practise-2/corner", "mirror"): lambda d, **p: _obscura(_corner(**p), d, (1, 1)),
    (_21, "practise-2/corner", "only-y"): lambda d, **p: _obscura(_corner(**p), d, (1, -1)),
    (_21, "practise-3/film", "done"): lambda m, z: _set(settings__distance=m * z),
    (_21, "practise-3/film", "mirror"): lambda m, z: _set(settings__distance=-m * z),
    (_21, "practise-3/film", "from-plane"): lambda m, z: _set(settings__distance=m * z / (1 + m)),
    # L22. 004: v = n x u; depth along n; TEACHING up-v, no-norm, dist-depth.
    (_22, "practise-1/v", "right"): lambda a, b, c: _v(a, b, c, True),
    (_22, "practise-1/v", "no-norm"): lambda a, b, c: _v(a, b, c, False),
    (_22, "practise-1/v", "up-v"): lambda a, b, c: (0, 1, 0),
    (_22, "practise-2/corner", "right"): lambda **p: _least(**p, straight=False),
    (_22, "practise-2/corner", "dist-depth"): lambda **p: _least(**p, straight=True),
    (_22, "practise-3/top", "done"): lambda q, f: _set(
        camera__eye=(mpf(0), mpf("2.5"), mpf("2.5") / (q * tan(radians(f / 2))))
    ),
    (_22, "practise-3/top", "near-zooms"): lambda q, f: _set(lens__near=2),
    # L23. 001: far is a plane; TEACHING dist-depth.
    (_23, "practise-1/drive", "right"): lambda f, D, x: D - f,
    (_23, "practise-1/drive", "dist-depth"): lambda f, D, x: findroot(
        lambda way: sqrt((D - way) ** 2 + x**2) - f, D - f
    ),
    (_23, "practise-1/drive", "dist-now"): lambda f, D, x: abs(D + 1j * x) - f,
    (_23, "practise-2/last", "right"): lambda m, k, x, z, r: (
        _last_tree(x, z, z + 6 * k + r, False)
    ),
    (_23, "practise-2/last", "dist-depth"): lambda m, k, x, z, r: (
        _last_tree(x, z, z + 6 * k + r, True)
    ),
    (_23, "practise-3/count", "done"): lambda k, x, d: _set(lens__far=d + 3 * k - 3),
    (_23, "practise-3/count", "a-pair-less"): lambda k, x, d: _set(lens__far=d + 3 * k - 9),
    # L24. Ray, as in the program's scene; TEACHING dof-sym.
    (_24, "practise-1/limit", "right"): lambda F, N, s, c: _sharp(s, N, F, True),
    (_24, "practise-1/limit", "near-limit"): lambda F, N, s, c: _sharp(s, N, F, False),
    (_24, "practise-1/limit", "dof-sym"): lambda F, N, s, c: s + (s - _sharp(s, N, F, False)),
    (_24, "practise-2/end", "right"): lambda N, s, F, c: (0, mpf("1.3"), -_sharp(s, N, F, True)),
    (_24, "practise-2/end", "dof-sym"): lambda N, s, F, c: (
        0, mpf("1.3"), _sharp(s, N, F, False) - 2 * s
    ),
    (_24, "practise-3/range", "done"): lambda a, b: _focused(2 / (1 / a + 1 / b), b),
    (_24, "practise-3/range", "dof-sym"): lambda a, b: _focused((a + b) / 2, b),
    # L26. The point that was in the middle, turned; 003's cot(fov/2) x/z onto 720 pixels.
    (_26, "practise-1/lean", "right"): lambda d, r, fov: _turned(r * d, fov),
    (_26, "practise-1/lean", "one-round"): lambda d, r, fov: _turned(d, fov),
    (_26, "practise-1/lean", "full-angle"): lambda d, r, fov: _turned(r * d, 2 * fov),
    # The gap of numpy's own float32, half-way between the powers; 1080 lines over 2 D tan 20.
    (_26, "practise-2/jump", "right"): lambda u, D: _next_to(u * 3 / 2) / _metres(D) * 1080,
    (_26, "practise-2/jump", "half-gap"): lambda u, D: _next_to(u * 3 / 4) / _metres(D) * 1080,
    (_26, "practise-2/jump", "one-bit-less"): lambda u, D: _next_to(u * 3) / _metres(D) * 1080,
    # L25. Two points half a place apart, each projected by 003's cot(fov/2) y/D onto 240 pixels.
    (_25, "practise-1/pixels", "right"): lambda b, D: _apart(_places(b) / 2, D, 48),
    (_25, "practise-1/pixels", "whole-step"): lambda b, D: _apart(_places(b), D, 48),
    (_25, "practise-1/pixels", "full-angle"): lambda b, D: _apart(_places(b) / 2, D, 96),
    # The numbers next to m u, of numpy's own float32.
    (_25, "practise-2/half-gap", "right"): lambda u, m: _next_to(m * u) / 2,
    (_25, "practise-2/half-gap", "whole-gap"): lambda u, m: _next_to(m * u),
    (_25, "practise-2/half-gap", "seven-digits"): lambda u, m: m * u / 10**7,
    (_25, "practise-2/half-gap", "one-bit-more"): lambda u, m: _next_to(m * u / 2) / 2,
    # From D the picture has as many pixels a unit as the error needs; from 2 D half of them.
    # L27. Drawn at the geometric mean of near and far, true at their harmonic mean.
    (_27, "practise-1/half", "right"): lambda q, n: sqrt(n * n * q**2) / _mean_of_nearness(q, n),
    (_27, "practise-1/half", "half-world"): lambda q, n: n * q / ((n + n * q**2) / 2),
    (_27, "practise-1/half", "only-drawn"): lambda q, n: sqrt(n * n * q**2) / n,
    # Copies half a step off each, on 255 steps of each box; 1080 lines over D units.
    (_27, "practise-2/gap", "right"): lambda a, b, D: (
        sqrt(2 * ((a / mpf(255) + b / mpf(255)) / 2) ** 2) / (D / 1080)
    ),
    (_27, "practise-2/gap", "one-grid"): lambda a, b, D: sqrt(2) * a / mpf(510) / (D / 1080),
    (_27, "practise-2/gap", "whole-steps"): lambda a, b, D: (
        sqrt(2) * (a + b) / mpf(255) / (D / 1080)
    ),
    (_27, "practise-2/gap", "one-axis"): lambda a, b, D: (a + b) / mpf(510) / (D / 1080),
    (_25, "practise-3/stand", "done"): lambda D, h: _set(camera__eye=(mpf(0), mpf("2.5"), D)),
    (_25, "practise-3/stand", "whole-step"): lambda D, h: (
        _set(camera__eye=(mpf(0), mpf("2.5"), 2 * D))
    ),
}  # fmt: skip
