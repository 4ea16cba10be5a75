"""The numbers of the exercises of L1 to L8, from the lectures' formulas, for any variant.

Nothing of the program is used, and no formula of a lesson is copied: axes come from cross products,
turns from matrix exponentials, cells from the conditions that they must fulfil, images from rays.
"""

from collections.abc import Callable
from typing import Any

from mpmath import (
    acos,
    atan,
    cos,
    degrees,
    expm,
    lu_solve,
    matrix,
    mp,
    mpc,
    mpf,
    nstr,
    radians,
    sin,
    sqrt,
    tan,
)

from tests.lessons.by_hand import Vector, cross, unit

Of = Callable[..., Any]


def _set(**values: Any) -> str:
    """Write the values of ``--set``: numbers, or rows of them; ``__`` stands for a point."""
    rows = {
        name.replace("__", "."): value if isinstance(value, tuple) else (value,)
        for name, value in values.items()
    }
    return " ".join(
        f"{name}={','.join(each if isinstance(each, str) else nstr(each, 17) for each in row)}"
        for name, row in rows.items()
    )


def _keys(stem: str, block: str, of: dict[str, Of]) -> dict[tuple[str, str, str], Of]:
    return {(stem, block, name): each for name, each in of.items()}


# --------------------------------------------------------------------------- L1, lecture 004

_UP: Vector = (mpf(0), mpf(1), mpf(0))


def _v_y(**g: mpf) -> mpf:
    n = unit((g["N_x"], g["N_y"], g["N_z"]))
    return cross(n, unit(cross(_UP, n)))[1]


def _v_y_of_long_u(**g: mpf) -> mpf:
    n = unit((g["N_x"], g["N_y"], g["N_z"]))
    return cross(n, cross(_UP, n))[1]


def _row_3(order: str, forward: int = 1) -> Of:
    """Row 3 of R P, of P R, or of the inverse of R P."""

    def row(**g: mpf) -> tuple[mpf, ...]:
        long = (g["g"] * g["p"], g["p"] + 1, g["p"] * (g["p"] + 1))
        eye = [g[axis] + part for axis, part in zip("xyz", long, strict=True)]
        n = unit((forward * long[0], forward * long[1], forward * long[2]))
        u = unit(cross(_UP, n))
        turn, move = mp.eye(4), mp.eye(4)
        for place, axis in enumerate((u, cross(n, u), n)):
            turn[place, 0], turn[place, 1], turn[place, 2] = axis
            move[place, 3] = -eye[place]
        made = {"RP": turn * move, "PR": move * turn, "inverse": (turn * move) ** -1}[order]
        return tuple(made[2, column] for column in range(4))

    return row


def _camera_along(sign: int) -> Of:
    return lambda x, y, z: _set(
        camera__target=(mpf(0), mpf(2), mpf(0)),
        camera__eye=(2 * sign * x, 2 + 2 * sign * y, 2 * sign * z),
    )


# --------------------------------------------------------------------------- L2, lecture 003


def _turn(radians: mpf) -> tuple[mpf, ...]:
    """The matrix of a turn, row after row: the exponential of its angular velocity."""
    made = expm(matrix([[0, -radians], [radians, 0]]))
    return made[0, 0], made[0, 1], made[1, 0], made[1, 1]


def _turned(degrees: mpf) -> mpc:
    """The turned x axis as a complex number; its square is that of twice the angle."""
    return mpc(0, 1) ** (mpf(degrees) / 90)


def _moved_to(which: str) -> Of:
    def moved(**g: mpf) -> str:
        turned, place = _turned(g["φ"]), mpc(g["a"], g["b"])
        move = place - turned if which == "done" else place / turned - 1
        return _set(object__translate=(move.real, move.imag, mpf(0)))

    return moved


# --------------------------------------------------------------------------- L3 and L4


def _between_rays(half_width: mpf) -> mpf:
    """The angle between the rays to both sides of a picture at distance 1."""
    return degrees(acos((1 - half_width**2) / (1 + half_width**2)))


def _fov(tangent: mpf) -> str:
    return _set(lens__fov_y_deg=2 * degrees(atan(tangent)))


def _of_three(choose: Callable[[list[tuple[mpf, mpf]]], tuple[mpf, mpf]]) -> Of:
    """The chosen one of three points, by their (depth, side); the eye is at (0, 3, 8)."""

    def place(**g: mpf) -> tuple[mpf, ...]:
        points = [
            (g["depth"], g["x"]), (g["depth"] - g["c"], g["g"] * g["b"]), (g["e"], -2 * g["g"]),
        ]  # fmt: skip
        depth, side = choose(points)
        return side, mpf(3), 8 - depth

    return place


# --------------------------------------------------------------------------- L5, lecture 000


def _with_d(matrix_of: Callable[[Any], Any], sign: int = 1) -> Of:
    def product(x: mpf, y: mpf, z: mpf, d: mpf) -> tuple[mpf, ...]:
        made = mp.eye(4)
        made[3, 2], made[3, 3] = -1 / (sign * d), 0
        return tuple(matrix_of(made) * matrix([x, y, z, 1]))

    return product


# --------------------------------------------------------------------------- L6 and L8


def _row_1(n: mpf, l: mpf, r: mpf) -> tuple[mpf, mpf]:  # noqa: E741
    """The a and c with (a x + c z)/(-z) = -1 at the left and 1 at the right of the near plane."""
    a, c = lu_solve(matrix([[l, -n], [r, -n]]), matrix([-n, n]))
    return a, c


def _row_of_depth(n: mpf, f: mpf) -> tuple[mpf, mpf]:
    """The A and B with (A z + B)/(-z) = -1 at z = -n and 1 at z = -f."""
    a, b = lu_solve(matrix([[-n, 1], [-f, 1]]), matrix([-n, f]))
    return a, b


def _on_screen(eye: mpf, D: mpf, w: mpf) -> mpf:
    """x in the screen plane of the ray from an eye at this x to a point at x = 1 and depth w."""
    return eye + (1 - eye) * (D / w)


def _window_moved(sign: int) -> Of:
    return lambda n, q: _set(lens__left=2 * sign * q - 2, lens__right=2 * sign * q + 2)


def _z_ndc(z_min: mpf, z_max: mpf, z: mpf) -> mpf:
    a, b = _row_of_depth(z_min, z_max)
    return (a * z + b) / -z


def _on_segment(depth_of: Callable[[mpf, mpf], mpf]) -> Of:
    """The point of PQ at a depth; P is on the near plane, Q on the far one, the eye at z = 6."""

    def place(z_min: mpf, z_max: mpf, y_P: mpf, y_Q: mpf) -> tuple[mpf, ...]:
        depth = depth_of(z_min, z_max)
        share = (depth - z_min) / (z_max - z_min)
        return mpf(0), (1 - share) * y_P + share * y_Q, 6 - depth

    return place


def _middle_depth(z_min: mpf, z_max: mpf) -> mpf:
    a, b = _row_of_depth(z_min, z_max)
    return b / a


# --------------------------------------------------------------------------- L7, lecture 000


def _x_2(times: int) -> Of:
    """The right end of a window that is widened about its middle by a multiple of what it lacks."""

    def right(**g: mpf) -> mpf:
        has = g["x_max"] - g["x_min"]
        lacks = (g["y_max"] - g["y_min"]) * g["w"] / g["h"] - has
        return (g["x_max"] + g["x_min"]) / 2 + (has + times * lacks) / 2

    return right


def _pixel(per_unit: Callable[..., mpf], up: int = -1) -> Of:
    def place(**g: mpf) -> tuple[mpf, mpf]:
        px = per_unit(**g)
        return g["w"] / 2 + g["x_p"] * px, g["h"] / 2 + up * g["y_p"] * px

    return place


def _by_x(**g: mpf) -> mpf:
    return g["w"] / (2 * g["x_max"])


def _by_y(**g: mpf) -> mpf:
    return g["h"] / (2 * g["y_max"])


def _window_of_x(times: int) -> Of:
    def window(**g: mpf) -> str:
        has = g["y_max"] - g["y_min"]
        lacks = (g["x_max"] - g["x_min"]) * 600 / g["w"] - has
        middle, half = (g["y_max"] + g["y_min"]) / 2, (has + times * lacks) / 2
        return _set(lens__bottom=middle - half, lens__top=middle + half)

    return window


def _window_of_y(**g: mpf) -> str:
    middle, half = (g["x_max"] + g["x_min"]) / 2, (g["y_max"] - g["y_min"]) * g["w"] / 1200
    return _set(lens__left=middle - half, lens__right=middle + half)


KEYS: dict[tuple[str, str, str], Of] = {
    **_keys("l01-camera-frame", "practise-1/v-y", {
        "right": _v_y, "no-norm": _v_y_of_long_u, "up-v": lambda **_: _UP[1],
    }),
    **_keys("l01-camera-frame", "practise-2/row", {
        "right": _row_3("RP"), "order": _row_3("PR"), "inverse": _row_3("inverse"),
        "look-n": _row_3("RP", -1),
    }),
    **_keys("l01-camera-frame", "practise-3/turn", {
        "done": _camera_along(1), "look-n": _camera_along(-1),
    }),
    **_keys("l02-columns", "practise-1/cells", {
        "right": lambda φ: _turn(radians(φ)),
        "transposed": lambda φ: _turn(-radians(φ)),
        "degrees": lambda φ: _turn(φ),
    }),
    **_keys("l02-columns", "practise-2/x", {
        "right": lambda φ, m, x, y: (_turned(φ) * mpc(x, y)).real + m,
        "order": lambda φ, m, x, y: (_turned(φ) * mpc(x + m, y)).real,
        "transposed": lambda φ, m, x, y: (mpc(x, y) / _turned(φ)).real + m,
    }),
    **_keys("l02-columns", "practise-3/aim", {
        "done": _moved_to("done"), "order": _moved_to("order"),
    }),
    **_keys("l03-field-of-view", "practise-1/alpha", {
        "right": lambda beta, w, h: _between_rays(tan(radians(beta / 2)) * w / h),
        "angle-linear": lambda beta, w, h: beta * w / h,
        "fov-xy": lambda beta, **_: beta,
    }),
    **_keys("l03-field-of-view", "practise-2/e", {
        "right": lambda alpha: sqrt(1 / sin(radians(alpha / 2)) ** 2 - 1),
        "full-angle": lambda alpha: cos(radians(alpha)) / sin(radians(alpha)),
        "degrees": lambda alpha: cos(alpha / 2) / sin(alpha / 2),
        "fov-xy": lambda alpha: 16 * sqrt(1 / sin(radians(alpha / 2)) ** 2 - 1) / 9,
    }),
    **_keys("l03-field-of-view", "practise-3/wanted", {
        "done": lambda q, w: _fov(tan(radians(q / 2)) * 600 / w),
        "fov-xy": lambda q, **_: _set(lens__fov_y_deg=q),
        "angle-linear": lambda q, w: _set(lens__fov_y_deg=q * 600 / w),
    }),
    **_keys("l04-view-volumes", "practise-1/first", {
        "right": _of_three(max),
        "dist-depth": _of_three(lambda points: max(points, key=lambda p: p[0] ** 2 + p[1] ** 2)),
        "nearest": _of_three(min),
    }),
    **_keys("l04-view-volumes", "practise-2/h", {
        "right": lambda D, theta_v: D * (1 - cos(radians(theta_v))) / sin(radians(theta_v)),
        "full-angle": lambda D, theta_v: D * sin(radians(theta_v)) / cos(radians(theta_v)),
        "degrees": lambda D, theta_v: D * (1 - cos(theta_v)) / sin(theta_v),
    }),
    **_keys("l04-view-volumes", "practise-3/side", {
        "done": lambda D, q: _fov(q / D * 9 / 16),
        "full-angle": lambda D, q: _fov(tan(atan(q / D) / 2) * 9 / 16),
        "fov-xy": lambda D, q: _fov(q / D),
    }),
    **_keys("l05-similar-triangles", "practise-1/y-p", {
        "right": lambda d, y, z: y * (d / -z),
        "from-plane": lambda d, y, z: y * (d / (-z - d)),
        "mirror": lambda d, y, z: y * (-d / -z),
    }),
    **_keys("l05-similar-triangles", "practise-2/product", {
        "right": _with_d(lambda made: made),
        "signed": _with_d(lambda made: made, -1),
        "transposed": _with_d(lambda made: made.T),
    }),
    **_keys("l05-similar-triangles", "practise-3/plane", {
        "done": lambda y, z, q: _set(settings__distance=-z * (q / y)),
        "from-plane": lambda y, z, q: _set(settings__distance=-z * (q / (y + q))),
        "mirror": lambda y, z, q: _set(settings__distance=z * (q / y)),
    }),
    **_keys("l06-off-axis-frustum", "practise-1/row", {
        "right": lambda **g: (_row_1(**g)[0], mpf(0), _row_1(**g)[1], mpf(0)),
        "centre-sign": lambda **g: (_row_1(**g)[0], mpf(0), -_row_1(**g)[1], mpf(0)),
        "transposed": lambda **g: (_row_1(**g)[0], mpf(0), mpf(0), mpf(0)),
    }),
    **_keys("l06-off-axis-frustum", "practise-2/parallax", {
        "right": lambda s, D, w: _on_screen(s / 2, D, w) - _on_screen(-s / 2, D, w),
        "from-screen": lambda s, D, w: s * ((w - D) / D),
        "no-shift": lambda s, D, w: _on_screen(s / 2, D, w) - _on_screen(-s / 2, D, w) - s,
    }),
    **_keys("l06-off-axis-frustum", "practise-3/lean", {
        "done": _window_moved(1), "centre-sign": _window_moved(-1),
    }),
    **_keys("l07-proportions", "practise-1/x2", {
        "right": _x_2(1), "k-whole": _x_2(2), "keep-other": _x_2(0),
    }),
    **_keys("l07-proportions", "practise-2/place", {
        "right": _pixel(_by_x), "keep-other": _pixel(_by_y), "y-up": _pixel(_by_x, 1),
    }),
    **_keys("l07-proportions", "practise-3/hand", {
        "done": _window_of_x(1), "k-whole": _window_of_x(2), "keep-other": _window_of_y,
    }),
    **_keys("l08-depth-not-affine", "practise-1/z-ndc", {
        "right": _z_ndc,
        "linear-z": lambda z_min, z_max, z: (-2 * z - z_min - z_max) / (z_max - z_min),
        "w-kept": lambda z_min, z_max, z: -z * _z_ndc(z_min, z_max, z),
    }),
    **_keys("l08-depth-not-affine", "practise-2/middle", {
        "right": _on_segment(_middle_depth),
        "linear-z": _on_segment(lambda z_min, z_max: (z_min + z_max) / 2),
    }),
    **_keys("l08-depth-not-affine", "practise-3/place", {
        "done": lambda D, f: _set(lens__near=1 / (2 / D - 1 / f)),
        "linear-z": lambda D, **_: _set(lens__far=2 * D - 1),
    }),
}  # fmt: skip
