"""Right and wrong answers of the lessons on L9 to L16 and of talks 002 and 004, reckoned by hand.

Each number is the lecture's formula with the numbers of its step written out; nothing is asked of
the program.
"""

from collections.abc import Callable

from mpmath import atan, cot, degrees, mpf, radians, sqrt, tan


def _deg(value: str | int) -> mpf:
    return radians(mpf(value))


def _cot(value: str | int) -> mpf:
    return cot(_deg(value))


KEYS: dict[tuple[str, str, str], Callable[[], mpf]] = {
    # L9. 001: the near plane of the canonical pyramid is at c = -n/f; n = 1, f = 9.
    ("l09-pyramid-to-cube", "near/plane", "1"): lambda: mpf(-1),  # c-kept: -n
    ("l09-pyramid-to-cube", "near/plane", "2"): lambda: -mpf(1) / 9,
    # M_pp [2][3] = -c/(1 + c) = n/(f - n); n = 1/2, f = 9.
    ("l09-pyramid-to-cube", "cells/mpp", "right"): lambda: mpf("0.5") / mpf("8.5"),
    # TEACHING c-kept: c = -n, so -c/(1 + c) = n/(1 - n).
    ("l09-pyramid-to-cube", "cells/mpp", "c-kept"): lambda: mpf("0.5") / mpf("0.5"),
    # TEACHING near-far: f/(n - f).
    ("l09-pyramid-to-cube", "cells/mpp", "near-far"): lambda: mpf(9) / mpf("-8.5"),
    # 001: (M_z M_pp) [2][2] = -2 f/(f - n) - 1 * (-1) = A = -(f + n)/(f - n).
    ("l09-pyramid-to-cube", "cells/product", "right"): lambda: -mpf("9.5") / mpf("8.5"),
    # TEACHING order: (M_pp M_z) [2][2] = f/(f - n) * (-2).
    ("l09-pyramid-to-cube", "cells/product", "order"): lambda: mpf(9) / mpf("8.5") * -2,
    # TEACHING near-far: -(n + f)/(n - f).
    ("l09-pyramid-to-cube", "cells/product", "near-far"): lambda: -mpf("9.5") / mpf("-8.5"),
    # L10. 003: y' = (2y - t - b)/(t - b) has no depth: of equal y the quotient is 1.
    ("l10-parallel-lens", "twice/height", "1"): lambda: mpf(1),
    # TEACHING ortho-div: as in perspective, by the depths: n.(e - p) with n = (0.6, 0, 0.8),
    # e = (4.6, 1.3, 2.8), p = (0, 2.6, 0) and (0, 2.6, -6): 5 and 9.8.
    ("l10-parallel-lens", "twice/height", "2"): lambda: (
        (mpf("0.6") * mpf("4.6") + mpf("0.8") * mpf("2.8"))
        / (mpf("0.6") * mpf("4.6") + mpf("0.8") * mpf("8.8"))
    ),
    # 003: [0][3] = -(r + l)/(r - l); l = -1, r = 3.
    ("l10-parallel-lens", "cells/shift", "right"): lambda: -mpf(3 - 1) / (3 + 1),
    # TEACHING centre-sign, and transposed: [3][0].
    ("l10-parallel-lens", "cells/shift", "centre-sign"): lambda: mpf(3 - 1) / (3 + 1),
    ("l10-parallel-lens", "cells/shift", "transposed"): lambda: mpf(0),
    # 003: y' = 2y/(t - b) - (t + b)/(t - b); y = 1, t = 2, b = -2.
    ("l10-parallel-lens", "cells/height", "right"): lambda: mpf(2) * 1 / 4 - mpf(0) / 4,
    # TEACHING ortho-div: that over -z = 5.
    ("l10-parallel-lens", "cells/height", "ortho-div"): lambda: mpf(2) * 1 / 4 / 5,
    # L11. TEACHING cabinet: theta = 90 - 45 s against cot(theta) = s; s = 1/2; 1 for a cavalier.
    ("l11-oblique-drawing", "half/slant", "1"): lambda: mpf(90) - 45 * mpf("0.5"),
    ("l11-oblique-drawing", "half/slant", "2"): lambda: degrees(atan(2)),
    ("l11-oblique-drawing", "half/slant", "3"): lambda: degrees(atan(1)),
    # 002: H [0][3] = -z_n cot(alpha); z_n = -2, alpha = 60.
    ("l11-oblique-drawing", "cells/cell", "right"): lambda: 2 * _cot(60),
    # TEACHING tan-cot, signed.
    ("l11-oblique-drawing", "cells/cell", "tan-cot"): lambda: 2 * tan(_deg(60)),
    ("l11-oblique-drawing", "cells/cell", "signed"): lambda: -2 * _cot(60),
    # 002: x' - x = -(z_n - z) cot(alpha), z_n - z = 3.
    ("l11-oblique-drawing", "cells/shift", "right"): lambda: -3 / sqrt(mpf(3)),
    ("l11-oblique-drawing", "cells/shift", "tan-cot"): lambda: -3 * sqrt(mpf(3)),
    ("l11-oblique-drawing", "cells/shift", "signed"): lambda: 3 / sqrt(mpf(3)),
    # L12. 004: x_p = -d x/z, of the direction (1, 0, -2) itself, d = 1.
    ("l12-vanishing-points", "where/place", "right"): lambda: -mpf(1) * 1 / -2,
    # TEACHING inf-far: of p + 10 dir, p = (2, 0, -1); mirror: d x/z.
    ("l12-vanishing-points", "where/place", "inf-far"): lambda: -mpf(2 + 10) / (-1 - 20),
    ("l12-vanishing-points", "where/place", "mirror"): lambda: mpf(1) / -2,
    # L13. 002: x/w of (3, -1, 2, 4); TEACHING no-divide, mirror.
    ("l13-homogeneous", "compute/divide", "right"): lambda: mpf(3) / 4,
    ("l13-homogeneous", "compute/divide", "no-divide"): lambda: mpf(3),
    ("l13-homogeneous", "compute/divide", "mirror"): lambda: mpf(3) / -4,
    # 000, (3): lambda * (-1/d) = -1, so lambda = d = 4; TEACHING signed: 1/d for -1/d.
    ("l13-homogeneous", "compute/scaled", "right"): lambda: -1 / (-1 / mpf(4)),
    ("l13-homogeneous", "compute/scaled", "signed"): lambda: -1 / (1 / mpf(4)),
    # 002: y_win = h/2 (1 - y'), y' = cot(fov/2) d_y/(-d_z); h = 720, fov = 70, (0, 1, -2).
    ("l13-homogeneous", "infinity/row", "right"): lambda: 360 * (1 - cot(radians(35)) / 2),
    ("l13-homogeneous", "infinity/row", "y-up"): lambda: 360 * (1 + cot(radians(35)) / 2),
    # TEACHING inf-far: of p + 10 dir, p = (0, 0, -1).
    ("l13-homogeneous", "infinity/row", "inf-far"): lambda: 360 * (1 - cot(radians(35)) * 10 / 21),
    # L14. 002: y_win = h/2 (1 - y'), y' = 1, h = 720; TEACHING y-up; and the middle.
    ("l14-to-pixels", "top/top", "1"): lambda: mpf(720) / 2 * (1 - 1),
    ("l14-to-pixels", "top/top", "2"): lambda: mpf(720) / 2 * (1 + 1),
    ("l14-to-pixels", "top/top", "3"): lambda: mpf(720) / 2 * (1 - 0),
    # 002: image [1][1] = -h/2; TEACHING y-up, ndc-01: y_win = h (1 - y').
    ("l14-to-pixels", "formula/cell", "right"): lambda: mpf(-720) / 2,
    ("l14-to-pixels", "formula/cell", "y-up"): lambda: mpf(720) / 2,
    ("l14-to-pixels", "formula/cell", "ndc-01"): lambda: mpf(-720),
    # y' = cot(30) 1/5 of p (1, 1, -5).
    ("l14-to-pixels", "formula/row", "right"): lambda: 360 * (1 - sqrt(mpf(3)) / 5),
    ("l14-to-pixels", "formula/row", "y-up"): lambda: 360 * (1 + sqrt(mpf(3)) / 5),
    ("l14-to-pixels", "formula/row", "ndc-01"): lambda: 720 * (1 - sqrt(mpf(3)) / 5),
    # TEACHING pixel-corner: x' = 2 (i + 1/2)/w - 1 against 2 i/w - 1; i = 1, w = 4; ndc-01.
    ("l14-to-pixels", "four/centre", "right"): lambda: 2 * mpf("1.5") / 4 - 1,
    ("l14-to-pixels", "four/centre", "pixel-corner"): lambda: 2 * mpf(1) / 4 - 1,
    ("l14-to-pixels", "four/centre", "ndc-01"): lambda: mpf("1.5") / 4,
    # L15. TEACHING: t at x = w is (w1 - x1)/(w1 - x1 - w2 + x2); x 0 to 9, w 1 to 4.
    ("l15-clipping", "where/cut", "right"): lambda: mpf(1 - 0) / (1 - 0 - 4 + 9),
    # no-divide: where x itself is 1; affine-mid: where x/w, run evenly from 0 to 9/4, is 1.
    ("l15-clipping", "where/cut", "no-divide"): lambda: mpf(1) / 9,
    ("l15-clipping", "where/cut", "affine-mid"): lambda: 1 / (mpf(9) / 4),
    # TEACHING dist-depth: -z against |p|; C - eye = (7, 0, -12).
    ("l15-clipping", "where/far", "right"): lambda: mpf(12),
    ("l15-clipping", "where/far", "dist-depth"): lambda: sqrt(mpf(7) ** 2 + mpf(12) ** 2),
    # L16. 004: t = (z_last + 0.01)/(z_last - z_c); z from -2 to 2. At z = 0 instead: 1/2.
    ("l16-eye-plane", "at/t", "right"): lambda: (-2 + mpf("0.01")) / mpf(-4),
    ("l16-eye-plane", "at/t", "at-zero"): lambda: mpf(-2) / -4,
    # 004: x_p = -d x/z at z = -0.01, x = 1 + 2 t, d = 1.
    ("l16-eye-plane", "at/image", "right"): lambda: (1 + 2 * mpf("0.4975")) / mpf("0.01"),
    # TEACHING eye-naive: B' = -d x/z of B (3, 0, 2); mirror: d x/z.
    ("l16-eye-plane", "at/image", "eye-naive"): lambda: -mpf(3) / 2,
    ("l16-eye-plane", "at/image", "mirror"): lambda: -(1 + 2 * mpf("0.4975")) / mpf("0.01"),
    # Talk 002: as L10's and L11's first questions.
    ("talk-002", "drop-z/far", "1"): lambda: mpf(1),
    ("talk-002", "drop-z/far", "2"): lambda: 1 / mpf(2),
    ("talk-002", "p-obl/slant", "1"): lambda: mpf(90) - 45 * mpf("0.5"),
    ("talk-002", "p-obl/slant", "2"): lambda: degrees(atan(2)),
    # Talk 004: v = n x u; eye (0, 9, 3), target 0, V (0, 1, 0): v_y = 3/sqrt(90). TEACHING up-v.
    ("talk-004", "frame/up", "1"): lambda: mpf(1),
    ("talk-004", "frame/up", "2"): lambda: 3 / sqrt(mpf(9 * 9 + 3 * 3)),
    # 004: (R P)[2][3] = -n.T_0; T_0 = (5, 4.5, 8), N = (5, 2.3, 8). TEACHING order, inverse.
    ("talk-004", "product/last", "1"): lambda: (
        -(5 * mpf(5) + mpf("4.5") * mpf("2.3") + 8 * mpf(8)) / sqrt(25 + mpf("2.3") ** 2 + 64)
    ),
    ("talk-004", "product/last", "2"): lambda: mpf(-8),
    ("talk-004", "product/last", "3"): lambda: mpf(8),
}
"""By file, step and block, and the right answer, the idea or the choice's number."""
