"""The numbers of the lessons on L1 to L8 and of the talks 000 and 003, from the lectures' formulas.

Nothing of the program is used: each number is written out once more with the numbers of its state,
in mpmath. A key is a file's stem, its step and block, and ``right``, the name of a wrong idea (of
the list of wrong ideas in TEACHING, section 2), or a choice's number.
"""

from collections.abc import Callable

from mpmath import atan, cos, cot, degrees, mpf, radians, sin, tan

from tests.lessons.by_hand import Vector, cross, dot, unit

# --------------------------------------------------------------------------- L1, lecture 004

_EYE: Vector = (mpf(2), mpf(3), mpf(6))  # target at the origin
_UP: Vector = (mpf(0), mpf(1), mpf(0))
_N = unit(_EYE)  # N = eye - target, n = N/|N|
_U_LONG = cross(_UP, _N)  # U = V x n
_V = cross(_N, unit(_U_LONG))  # v = n x u, u = U/|U|


# --------------------------------------------------------------------------- L2, lecture 003


def _turned_then_moved(angle: int, move: int, x: int, y: int) -> tuple[mpf, mpf]:
    """T Rz (x, y): M_O->W of lecture 003, its columns the turned axes, its last one the origin."""
    c, s = cos(radians(angle)), sin(radians(angle))
    return c * x - s * y + move, s * x + c * y


def _moved_then_turned(angle: int, move: int, x: int, y: int) -> tuple[mpf, mpf]:
    """Rz T (x, y): TEACHING's rule `order`."""
    c, s = cos(radians(angle)), sin(radians(angle))
    return c * (x + move) - s * y, s * (x + move) + c * y


# --------------------------------------------------------------------------- L3, lecture 003


def _across(beta: int, a: mpf) -> mpf:
    """Lecture 003: tan(beta/2) = a/e and tan(alpha/2) = 1/e, a = h/w."""
    return degrees(2 * atan(tan(radians(beta) / 2) / a))


# --------------------------------------------------------------------------- L5, lecture 000


def _on_plane(d: int, y: int, z: int) -> mpf:
    """Lecture 000, (1): y_p = d y/(-z)."""
    return mpf(d) * y / -z


def _from_plane(d: int, y: int, z: int) -> mpf:
    """TEACHING's rule `from-plane`: d y/(-z - d)."""
    return mpf(d) * y / (-z - d)


# --------------------------------------------------------------------------- L6, lecture 003


def _shear(left: int, right: int) -> mpf:
    """Lecture 003: (r + l)/(r - l), row 1, column 3."""
    return mpf(right + left) / (right - left)


def _a(n: int, f: int) -> mpf:
    """Lecture 003: A = -(f + n)/(f - n); lecture 000, (12), the same."""
    return -mpf(f + n) / (f - n)


def _b(n: int, f: int) -> mpf:
    """Lecture 003: B = -2nf/(f - n)."""
    return -2 * mpf(n) * f / (f - n)


# --------------------------------------------------------------------------- L7, lecture 000


def _missing(kept: int, adjusted: int, share: mpf) -> mpf:
    """What the adjusted side lacks: (h/w)(x_max - x_min) - (y_max - y_min); of Y with w/h."""
    return share * kept - adjusted


# --------------------------------------------------------------------------- L8, lecture 000


def _depth(n: int, f: int, z: int) -> mpf:
    """Lecture 000, (12): z' = (A z + B)/(-z)."""
    return (_a(n, f) * z + _b(n, f)) / -z


def _even_depth(n: int, f: int, z: int) -> mpf:
    """TEACHING's rule `linear-z`: -1 + 2(-z - n)/(f - n)."""
    return -1 + 2 * mpf(-z - n) / (f - n)


L1, L2, L3 = "l01-camera-frame", "l02-columns", "l03-field-of-view"
L4, L5, L6 = "l04-view-volumes", "l05-similar-triangles", "l06-off-axis-frustum"
L7, L8 = "l07-proportions", "l08-depth-not-affine"
T0, T3 = "talk-000", "talk-003"

KEYS: dict[tuple[str, str, str], Callable[[], mpf]] = {
    # 004: v = n x u; up-v takes V itself, no-norm n x U.
    (L1, "length/v-y", "right"): lambda: _V[1],
    (L1, "length/v-y", "up-v"): lambda: _UP[1],
    (L1, "length/v-y", "no-norm"): lambda: cross(_N, _U_LONG)[1],
    # 004: R P, last column -R eye. order: P R, -eye. inverse: the eye itself. look-n: -n for n.
    (L1, "column/cell", "right"): lambda: -dot(_N, _EYE),
    (L1, "column/cell", "order"): lambda: -_EYE[2],
    (L1, "column/cell", "inverse"): lambda: _EYE[2],
    (L1, "column/cell", "look-n"): lambda: dot(_N, _EYE),
    # 003: columns are the axes; y of T Rz (1, 0, 0), and of Rz T.
    (L2, "predict/land", "1"): lambda: _turned_then_moved(90, 3, 1, 0)[1],
    (L2, "predict/land", "2"): lambda: _moved_then_turned(90, 3, 1, 0)[1],
    # 003: x of T(4, 0, 0) Rz(30) (2, 1, 0). transposed: the turn by -30.
    (L2, "point/x", "right"): lambda: _turned_then_moved(30, 4, 2, 1)[0],
    (L2, "point/x", "order"): lambda: _moved_then_turned(30, 4, 2, 1)[0],
    (L2, "point/x", "transposed"): lambda: _turned_then_moved(-30, 4, 2, 1)[0],
    # 003: alpha of beta. angle-linear: beta times w/h. fov-xy: beta itself.
    (L3, "predict/wide", "1"): lambda: 60 * mpf(16) / 9,
    (L3, "predict/wide", "2"): lambda: _across(60, mpf(9) / 16),
    (L3, "predict/wide", "3"): lambda: mpf(60),
    (L3, "twice/alpha", "right"): lambda: _across(40, mpf(500) / 1000),
    (L3, "twice/alpha", "angle-linear"): lambda: 40 * mpf(1000) / 500,
    (L3, "twice/alpha", "fov-xy"): lambda: mpf(40),
    # 003: e = cot(alpha/2). full-angle: cot(alpha). degrees: the cotangent of 25 radians.
    (L3, "focal/e", "right"): lambda: cot(radians(50) / 2),
    (L3, "focal/e", "full-angle"): lambda: cot(radians(50)),
    (L3, "focal/e", "degrees"): lambda: cot(mpf(50) / 2),
    # 001: a parallel volume has no foreshortening, w = 1. ortho-div: depths 4 and 8 divide.
    (L4, "predict/size", "1"): lambda: (1 / mpf(8)) / (1 / mpf(4)),
    (L4, "predict/size", "2"): lambda: mpf(1) / 1,
    # 001: |AC| = D tan(theta_v/2). full-angle, degrees as above.
    (L4, "height/h", "right"): lambda: 10 * tan(radians(50) / 2),
    (L4, "height/h", "full-angle"): lambda: 10 * tan(radians(50)),
    (L4, "height/h", "degrees"): lambda: 10 * tan(mpf(50) / 2),
    # 000, (1): y_p at d = 2 over y_p at d = 1, of P at depth 5. from-plane: depths 3 and 4.
    (L5, "predict/grow", "1"): lambda: _from_plane(2, 2, -5) / _from_plane(1, 2, -5),
    (L5, "predict/grow", "2"): lambda: _on_plane(2, 2, -5) / _on_plane(1, 2, -5),
    (L5, "point/y-p", "right"): lambda: _on_plane(4, 3, -6),
    (L5, "point/y-p", "from-plane"): lambda: _from_plane(4, 3, -6),
    (L5, "point/y-p", "mirror"): lambda: -_on_plane(4, 3, -6),
    # 000, (2): row 4 is (0, 0, -1/d, 0). signed: d = -4. transposed: row 3, column 4.
    (L5, "cell/cell", "right"): lambda: -1 / mpf(4),
    (L5, "cell/cell", "signed"): lambda: -1 / mpf(-4),
    (L5, "cell/cell", "transposed"): lambda: mpf(0),
    # 003: x_ndc = 2(x_p - l)/(r - l) - 1 of the axis, x_p = 0. centre-sign: the sign of the cell.
    (L6, "predict/axis", "1"): lambda: 2 * (mpf(0) - (-1)) / (3 - (-1)) - 1,
    (L6, "predict/axis", "2"): lambda: 2 * (mpf(0) - (-2)) / (2 - (-2)) - 1,
    (L6, "predict/axis", "3"): lambda: _shear(-1, 3),
    (L6, "cell/shear", "right"): lambda: _shear(-1, 4),
    (L6, "cell/shear", "centre-sign"): lambda: -_shear(-1, 4),
    (L6, "cell/shear", "transposed"): lambda: mpf(0),
    # 003: B. signed: B of -n and -f. transposed: row 4, column 3.
    (L6, "depth/b", "right"): lambda: _b(2, 10),
    (L6, "depth/b", "signed"): lambda: _b(-2, -10),
    (L6, "depth/b", "transposed"): lambda: mpf(-1),
    # 000, variant X: y_2 = y_max + k. keep-other: y stays. k-whole: no half.
    (L7, "predict/top", "1"): lambda: mpf(1),
    (L7, "predict/top", "2"): lambda: 1 + _missing(4, 2, mpf(720) / 720) / 2,
    (L7, "predict/top", "3"): lambda: 1 + _missing(4, 2, mpf(720) / 720),
    (L7, "x/y2", "right"): lambda: 1 + _missing(6, 2, mpf(500) / 1000) / 2,
    (L7, "x/y2", "k-whole"): lambda: 1 + _missing(6, 2, mpf(500) / 1000),
    (L7, "x/y2", "keep-other"): lambda: mpf(1),
    # 000, variant Y: x_2 = x_max + k (the last line of the lecture has y_max).
    (L7, "y/x2", "right"): lambda: 3 + _missing(4, 4, mpf(1000) / 500) / 2,
    (L7, "y/x2", "k-whole"): lambda: 3 + _missing(4, 4, mpf(1000) / 500),
    (L7, "y/x2", "keep-other"): lambda: mpf(3),
    # 000, (12). w-kept: A z + B, undivided.
    (L8, "depth/z-ndc", "right"): lambda: _depth(2, 8, -4),
    (L8, "depth/z-ndc", "linear-z"): lambda: _even_depth(2, 8, -4),
    (L8, "depth/z-ndc", "w-kept"): lambda: _a(2, 8) * -4 + _b(2, 8),
    # 000, (12) solved for z' = 0: depth B/A. linear-z: halfway between near and far.
    (L8, "zero/d", "right"): lambda: _b(2, 8) / _a(2, 8),
    (L8, "zero/d", "linear-z"): lambda: mpf(2 + 8) / 2,
    # The talks ask what the lessons ask.
    (T0, "triangles/grow", "1"): lambda: _from_plane(2, 2, -5) / _from_plane(1, 2, -5),
    (T0, "triangles/grow", "2"): lambda: _on_plane(2, 2, -5) / _on_plane(1, 2, -5),
    (T0, "window/axis", "1"): lambda: 2 * (mpf(0) - (-1)) / (3 - (-1)) - 1,
    (T0, "window/axis", "2"): lambda: 2 * (mpf(0) - (-2)) / (2 - (-2)) - 1,
    (T0, "window/axis", "3"): lambda: _shear(-1, 3),
    (T3, "columns/land", "1"): lambda: _turned_then_moved(90, 3, 1, 0)[1],
    (T3, "columns/land", "2"): lambda: _moved_then_turned(90, 3, 1, 0)[1],
    (T3, "fov/wide", "1"): lambda: 60 * mpf(16) / 9,
    (T3, "fov/wide", "2"): lambda: _across(60, mpf(9) / 16),
    (T3, "fov/wide", "3"): lambda: mpf(60),
    # 003: z_ndc of depth 5 between 1 and 9. linear-z: evenly. w-kept: A z + B.
    (T3, "depth/half", "1"): lambda: _even_depth(1, 9, -5),
    (T3, "depth/half", "2"): lambda: _depth(1, 9, -5),
    (T3, "depth/half", "3"): lambda: _a(1, 9) * -5 + _b(1, 9),
}
