"""Right and wrong answers of the lessons L17 to L27 and of talk 001, reckoned by hand.

Each number is the lecture's formula with the numbers of its step written out, in 50 digits; nothing
is asked of the program. A wrong one is the rule of its idea (TEACHING, section 2).
"""

from collections.abc import Callable

from mpmath import atan, cot, degrees, mp, mpf, radians, sqrt, tan

mp.dps = 50

_Point = tuple[mpf, mpf, mpf]


def _point(x: str, y: str, z: str) -> _Point:
    return mpf(x), mpf(y), mpf(z)


def _minus(p: _Point, q: _Point) -> _Point:
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def _dot(p: _Point, q: _Point) -> mpf:
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def _in_view(p: _Point, eye: _Point, target: _Point) -> tuple[mpf, mpf]:
    """004: y = v (p - e) and z = n (p - e), with n = N/|N|, u = V x n/|V x n|, v = n x u; V up."""
    normal = _minus(eye, target)
    length = sqrt(_dot(normal, normal))
    nx, ny, nz = (part / length for part in normal)
    across = sqrt(nz * nz + nx * nx)  # V x n = (n_z, 0, -n_x)
    ux, uz = nz / across, -nx / across
    v = ny * uz, nz * ux - nx * uz, -ny * ux
    return _dot(v, _minus(p, eye)), _dot((nx, ny, nz), _minus(p, eye))


def _on_the_plane(d: int) -> mpf:
    """000: y_p = d y/(-z), of P = (1.5, 5, 0.5), with the eye and the target of its scene."""
    y, z = _in_view(
        _point("1.5", "5", "0.5"), _point("5.5", "3.6", "9.5"), _point("0.3", "2.4", "0")
    )
    return d * y / -z


def _sharp(s: str, n: str, c: str = "0.00003", f: str = "0.05") -> tuple[mpf, mpf]:
    """s/(1 + q) and s/(1 - q) with q = (s - F)/(H - F), H = F^2/(N c) + F."""
    focus, length = mpf(s), mpf(f)
    q = (focus - length) / (length**2 / (mpf(n) * mpf(c)))
    return focus / (1 + q), focus / (1 - q)


KEYS: dict[tuple[str, str, str], Callable[[], mpf]] = {
    # L17. 000: gap = D^2 (1/n - 1/f)/(2^b - 1); n = 0.1, f from 100 to 50: the part that is saved.
    # TEACHING linear-z: gap = (f - n)/(2^b - 1).
    ("l17-depth-buffer", "far/far", "1"): lambda: 100 * (1 - mpf("49.9") / mpf("99.9")),
    ("l17-depth-buffer", "far/far", "2"): lambda: (
        100 * (1 - (10 - mpf(1) / 50) / (10 - mpf(1) / 100))
    ),
    ("l17-depth-buffer", "far/far", "3"): lambda: 100 * (1 - mpf(50 * 50) / (100 * 100)),
    # 003: z' = (A z + B)/(-z), A = -(f + n)/(f - n), B = -2 f n/(f - n); depth (z' + 1)/2; z = -10,
    # n = 2, f = 50.
    ("l17-depth-buffer", "depth/stored", "right"): lambda: (
        ((-mpf(52) / 48 * -10 - mpf(200) / 48) / 10 + 1) / 2
    ),
    # TEACHING linear-z: (-z - n)/(f - n).
    ("l17-depth-buffer", "depth/stored", "linear-z"): lambda: mpf(10 - 2) / (50 - 2),
    # TEACHING ndc-01: z' itself.
    ("l17-depth-buffer", "depth/stored", "ndc-01"): lambda: (
        (-mpf(52) / 48 * -10 - mpf(200) / 48) / 10
    ),
    # TEACHING w-kept: A z + B for z'.
    ("l17-depth-buffer", "depth/stored", "w-kept"): lambda: (
        ((-mpf(52) / 48 * -10 - mpf(200) / 48) + 1) / 2
    ),
    # 000: of 1/D, from 1/n to 1/f, each code has the same part; D = 40, n = 2, f = 50, b = 16.
    ("l17-depth-buffer", "depth/gap", "right"): lambda: (
        1 / (mpf(1) / 40 - (mpf(1) / 2 - mpf(1) / 50) / 65535) - 40
    ),
    ("l17-depth-buffer", "depth/gap", "linear-z"): lambda: mpf(48) / 65535,
    # L18. 003: a_3/z_3 = (1 - t) a_1/z_1 + t a_2/z_2, 1/z_3 likewise; a 0 and 1, z_2 = 4 z_1.
    ("l18-interpolation", "halfway/half", "1"): lambda: mpf(1) / 2,  # affine-mid
    ("l18-interpolation", "halfway/half", "2"): lambda: (mpf(1) / 4 / 2) / ((1 + mpf(1) / 4) / 2),
    # Where a is 1/2: t/4 = (1 - t).
    ("l18-interpolation", "halfway/half", "3"): lambda: mpf(4) / 5,
    # The same with a 10 and 50, z 5 and 15, t = 1/4.
    ("l18-interpolation", "formula/attribute", "right"): lambda: (
        (mpf(3) / 4 * 10 / 5 + mpf(1) / 4 * 50 / 15) / (mpf(3) / 4 / 5 + mpf(1) / 4 / 15)
    ),
    # TEACHING affine-mid: the sum of t_i a_i.
    ("l18-interpolation", "formula/attribute", "affine-mid"): lambda: mpf(3 * 10 + 50) / 4,
    ("l18-interpolation", "formula/depth", "right"): lambda: 1 / (mpf(3) / 4 / 5 + mpf(1) / 4 / 15),
    ("l18-interpolation", "formula/depth", "affine-mid"): lambda: mpf(3 * 5 + 15) / 4,
    # L19. The ray from L through P: L + (P - L) L_y/(L_y - P_y); L = (-3, 10, 0), P = (1.5, 5, .5).
    # TEACHING sun-lamp: P - L P_y/L_y.
    ("l19-planar-shadow", "lamp/lamp", "1"): lambda: mpf("1.5") + mpf(3) * 5 / 10,
    ("l19-planar-shadow", "lamp/lamp", "2"): lambda: -3 + mpf("4.5") * 10 / (10 - 5),
    ("l19-planar-shadow", "lamp/lamp", "3"): lambda: mpf("1.5"),
    # L = (-6, 8, 2).
    ("l19-planar-shadow", "formula/place", "right"): lambda: -6 + mpf("7.5") * 8 / (8 - 5),
    ("l19-planar-shadow", "formula/place", "sun-lamp"): lambda: mpf("1.5") + mpf(6) * 5 / 8,
    # S[0][0] = p.L = L_y - h w, h = -2; of the sun w = 0.
    ("l19-planar-shadow", "formula/cell", "right"): lambda: mpf(8) - -2,
    ("l19-planar-shadow", "formula/cell", "sun-lamp"): lambda: mpf(8),
    # L20. D_2 = D_1 F_2/F_1; D_1 = 2, F 50 and 85.
    ("l20-zoom-or-walk", "formula/distance", "right"): lambda: mpf(2) * 85 / 50,
    # TEACHING angle-linear: sizes as the angle, here of film 36 wide.
    ("l20-zoom-or-walk", "formula/distance", "angle-linear"): lambda: (
        2 * atan(mpf(18) / 50) / atan(mpf(18) / 85)
    ),
    # TEACHING zoom-move: (D + g)/D; g = 1, D = 5 against the old 2.
    ("l20-zoom-or-walk", "formula/ratio", "right"): lambda: mpf(5 + 1) / 5,
    ("l20-zoom-or-walk", "formula/ratio", "zoom-move"): lambda: mpf(2 + 1) / 2,
    # L21. 000 (1): y_p = d y/(-z); d = -4. TEACHING mirror: d y/z.
    ("l21-camera-obscura", "behind/behind", "1"): lambda: -_on_the_plane(-4),
    ("l21-camera-obscura", "behind/behind", "2"): lambda: _on_the_plane(-4),
    # h' = -d h/z; d = 6, h = 5, z = 9. TEACHING from-plane: z from the film, 15.
    ("l21-camera-obscura", "formula/height", "right"): lambda: -mpf(6) * 5 / 9,
    ("l21-camera-obscura", "formula/height", "mirror"): lambda: mpf(6) * 5 / 9,
    ("l21-camera-obscura", "formula/height", "from-plane"): lambda: -mpf(6) * 5 / 15,
    # d/z = 1/3; from the film d/(z + d) = 1/3, so 3 d = z + d.
    ("l21-camera-obscura", "formula/film", "right"): lambda: mpf(9) / 3,
    ("l21-camera-obscura", "formula/film", "from-plane"): lambda: mpf(9) / (3 - 1),
    # L22. 004: N = (0, 8, 6), n = N/10, U = V x n = (n_z, 0, 0), v_y = (n x u)_y = n_z u_x.
    ("l22-walk-round-the-f", "formula/up", "right"): lambda: mpf(6) / 10 * 1,
    ("l22-walk-round-the-f", "formula/up", "up-v"): lambda: mpf(1),
    # TEACHING no-norm: U for u.
    ("l22-walk-round-the-f", "formula/up", "no-norm"): lambda: mpf(6) / 10 * (mpf(6) / 10),
    # 003: y' = cot(fov/2) y/D; fov 60, y = 2.5, y' = 1/2. full-angle: cot(fov); near-zooms: n = 2.
    ("l22-walk-round-the-f", "distance/depth", "right"): lambda: cot(radians(30)) * mpf("2.5") * 2,
    ("l22-walk-round-the-f", "distance/depth", "full-angle"): lambda: (
        cot(radians(60)) * mpf("2.5") * 2
    ),
    ("l22-walk-round-the-f", "distance/depth", "near-zooms"): lambda: (
        2 * cot(radians(30)) * mpf("2.5") * 2
    ),
    # L23. The eye is at (-11, 2.2, 2) and looks along -z; the point at (4, 2.2, -36).
    ("l23-popping", "side/tree", "1"): lambda: sqrt(mpf(15) ** 2 + mpf(38) ** 2),  # dist-depth
    ("l23-popping", "side/tree", "2"): lambda: mpf(2) - -36,
    ("l23-popping", "side/tree", "3"): lambda: mpf(40) / 2,
    # 44 ahead and 15 to the right; f = 34. dist-depth: where it is 34 away.
    ("l23-popping", "formula/drive", "right"): lambda: mpf(44) - 34,
    ("l23-popping", "formula/drive", "dist-depth"): lambda: 44 - sqrt(mpf(34) ** 2 - 15**2),
    # 001: linear fog from 15 to 66 leaves (end - w)/(end - start).
    ("l23-popping", "formula/fog", "right"): lambda: 100 * mpf(66 - 34) / (66 - 15),
    # L24. F = 0.05, N = 2.8, c = 0.03 mm, s = 5. TEACHING dof-sym: 2 s - s/(1 + q).
    ("l24-focus", "behind/far", "1"): lambda: 10 - _sharp("5", "2.8")[0],
    ("l24-focus", "behind/far", "2"): lambda: _sharp("5", "2.8")[1],
    ("l24-focus", "behind/far", "3"): lambda: mpf(5),
    # N = 4, s = 4.
    ("l24-focus", "formula/far", "right"): lambda: _sharp("4", "4")[1],
    ("l24-focus", "formula/far", "dof-sym"): lambda: 8 - _sharp("4", "4")[0],
    # TEACHING: s = 2 a b/(a + b), from 1/s between 1/a and 1/b; a = 3, b = 6.
    ("l24-focus", "formula/focus", "right"): lambda: 2 / (mpf(1) / 3 + mpf(1) / 6),
    ("l24-focus", "formula/focus", "dof-sym"): lambda: mpf(3 + 6) / 2,
    # L26 of this program. Half the picture, 360 px, is tan 20; angle-linear: 720/40 px a degree.
    ("l26-small-errors", "grow/pixels", "right"): lambda: (
        360 * tan(radians(mpf("0.5"))) / tan(radians(20))
    ),
    ("l26-small-errors", "grow/pixels", "angle-linear"): lambda: mpf(720) / 80,
    # 24 bits, of which the first counts 2^14: the last counts 2^(14 - 23), in mm.
    ("l26-small-errors", "step/gap", "right"): lambda: 1000 * mpf(2) ** (14 - 23),
    ("l26-small-errors", "step/gap", "seven-digits"): lambda: mpf(30_000_000) / 10**7,
    # L25 of this program. e = s/(2 (2^b - 1)) h/(2 D tan(fov/2)); s = 8, h = 240, fov 48, D = 0.01.
    ("l25-how-many-bits", "places/near", "3"): lambda: (
        mpf(8) / (2 * 65535) * 240 / (mpf("0.02") * tan(radians(24)))
    ),
    ("l25-how-many-bits", "rule/units", "right"): lambda: mpf(4) / 4095,
    ("l25-how-many-bits", "rule/units", "whole-step"): lambda: mpf(8) / 4095,
    # e is in proportion to 1/D. error-anywhere: it stays.
    ("l25-how-many-bits", "stand/twice", "right"): lambda: mpf("0.4") * 2,
    ("l25-how-many-bits", "stand/twice", "error-anywhere"): lambda: mpf("0.4"),
    # 24 bits, of which the first counts 2^19: the last counts 2^(19 - 23). seven-digits: 10^-7.
    ("l25-how-many-bits", "far/gap", "right"): lambda: mpf(2) ** (19 - 23),
    ("l25-how-many-bits", "far/gap", "seven-digits"): lambda: mpf(10) ** (6 - 7),
    ("l25-how-many-bits", "far/left", "right"): lambda: 100 * mpf(2) ** -5 / 10,
    ("l25-how-many-bits", "far/left", "seven-digits"): lambda: 100 * mpf(10) ** -7,
    # L27 of this program. Drawn at the mean logarithm, sqrt(n f); 1/w is the mean of 1/n and 1/f.
    ("l27-where-precision-goes", "rule/half", "right"): lambda: (
        sqrt(mpf(100)) * (mpf(1) + mpf(1) / 100) / 2
    ),
    ("l27-where-precision-goes", "rule/half", "half-world"): lambda: sqrt(mpf(100)) / mpf("50.5"),
    ("l27-where-precision-goes", "rule/half", "log-better"): lambda: mpf(1),
    # A step is the box over 2^b - 1, in per cent of that of 8 bits.
    ("l27-where-precision-goes", "seam/bits", "1"): lambda: mpf(800) / 12,
    ("l27-where-precision-goes", "seam/bits", "2"): lambda: (
        100 * (mpf(10) / 4095) / (mpf(10) / 255)
    ),
    ("l27-where-precision-goes", "gap/apart", "right"): lambda: mpf(5) / 255 + mpf("1.5") / 255,
    ("l27-where-precision-goes", "gap/apart", "one-grid"): lambda: mpf(5) / 255,
    ("l27-where-precision-goes", "gap/apart", "whole-steps"): lambda: mpf(10) / 255 + mpf(3) / 255,
    # Talk 001. h' = -d h/z; d = 4, h = 5, z = 18. from-plane: z from the film, 22.
    ("talk-001", "obscura/film", "1"): lambda: -mpf(4) * 5 / 22,
    ("talk-001", "obscura/film", "2"): lambda: -mpf(4) * 5 / 18,
    ("talk-001", "obscura/film", "3"): lambda: mpf(4) * 5 / 18,  # mirror
    # tan(theta_h/2) = 16/9 tan(theta_v/2), theta_v = 60; angle-linear: 16/9 of it.
    ("talk-001", "angles/wide", "1"): lambda: mpf(16) / 9 * 60,
    ("talk-001", "angles/wide", "2"): lambda: 2 * degrees(atan(mpf(16) / 9 * tan(radians(30)))),
    ("talk-001", "angles/wide", "3"): lambda: mpf(60),  # fov-xy
    # 001: near comes to c = -n/f; n = 1, f = 10. c-kept: -n.
    ("talk-001", "persp/near", "1"): lambda: mpf(-1),
    ("talk-001", "persp/near", "2"): lambda: -mpf(1) / 10,
    ("talk-001", "persp/near", "3"): lambda: mpf(0),
}
