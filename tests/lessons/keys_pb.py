"""Right and wrong answers of the exercises of L9 to L16, as functions of their numbers.

Each is found by another way than the lesson's formula: by building and multiplying the matrices, by
the two points that fix a line, by going very far along it, by intersecting lines and rays.
"""

from collections.abc import Callable

from mpmath import cos, hypot, lu_solve, matrix, mpf, nstr, radians, sin, tan

from tests.lessons.by_hand import cross

FAR_AWAY = mpf(10) ** 30
"""Steps along a line after which 20 digits of its image no longer change."""
PIXELS_PER_UNIT = 160
"""Of the cube's picture in L11: 1280 pixels for 8 units, 720 for 4.5."""


def _digits(value: mpf) -> str:
    return str(nstr(value, 15))


# --------------------------------------------------------------------------- L9


def _m_pp(c: mpf) -> matrix:
    """001: the depths c and -1 of the pyramid come to 0 and -1 of the box; w = -z."""
    a, b = lu_solve(matrix([[c, 1], [-1, 1]]), matrix([0, -1]))
    return matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, a, b], [0, 0, -1, 0]])


def _m_z() -> matrix:
    """001: the depths 0 and -1 of the box come to -1 and 1."""
    a, b = lu_solve(matrix([[0, 1], [-1, 1]]), matrix([-1, 1]))
    return matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, a, b], [0, 0, 0, 1]])


def _cells(of: matrix, rows: tuple[int, ...], columns: tuple[int, ...]) -> tuple[mpf, ...]:
    return tuple(of[row, column] for row in rows for column in columns)


def _row_3(c: mpf) -> tuple[mpf, ...]:
    return _cells(_m_pp(c), (2,), (0, 1, 2, 3))


def _block(of: matrix) -> tuple[mpf, ...]:
    return _cells(of, (2, 3), (2, 3))


# --------------------------------------------------------------------------- L10, L14


def _onto(low: mpf, high: mpf, to_low: mpf, to_high: mpf) -> tuple[mpf, mpf]:
    """The factor and the summand that take low and high to two other values."""
    factor, summand = lu_solve(matrix([[low, 1], [high, 1]]), matrix([to_low, to_high]))
    return factor, summand


def _first_row(left: mpf, right: mpf, sign: int = 1) -> tuple[mpf, ...]:
    factor, summand = _onto(left, right, mpf(-1), mpf(1))
    return factor, mpf(0), mpf(0), sign * summand


def _height(b: mpf, t: mpf, y: mpf) -> mpf:
    """The share of the way from b to t, from -1 to 1."""
    return (y - b) / (t - b) - (t - y) / (t - b)


def _viewport(w: mpf, left: mpf, h: mpf, low: mpf, high: mpf) -> tuple[mpf, ...]:
    """x' from `left` to 1 comes to 0 to w, y' from `low` to `high` comes to h to 0."""
    across, up = _onto(left, mpf(1), mpf(0), w), _onto(low, high, h, mpf(0))
    return across[0], mpf(0), across[1], mpf(0), up[0], up[1]


def _pixel(x: mpf, y: mpf, width: int = 1280, height: int = 720) -> tuple[mpf, mpf]:
    """Go by shares from the left edge, and from the top one."""
    return width - width * (1 - x) / 2, height * (1 - y) / 2


def _clamped(x: mpf, y: mpf) -> tuple[mpf, mpf]:
    """TEACHING ndc-01: shares from 0 to 1; negative ones at the left and the lower edge."""
    return 1280 * (x if x > 0 else mpf(0)), 720 - 720 * (y if y > 0 else mpf(0))


# --------------------------------------------------------------------------- L11


def _slant(angle: mpf) -> mpf:
    """How far a projector goes along the picture for a unit of depth, by the angle between them."""
    return cos(radians(angle)) / sin(radians(angle))


def _h_row(
    alpha: mpf, n: mpf, slant: Callable[[mpf], mpf] = _slant, sign: int = 1
) -> tuple[mpf, ...]:
    """002: x' = x - (z_n - z) cot(alpha), of the origin and of the axes; z_n = -n."""

    def sheared(x: int, y: int, z: int) -> mpf:
        return x - (-sign * n - z) * slant(alpha)

    origin = sheared(0, 0, 0)
    return (*(sheared(*axis) - origin for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))), origin)


def _tan(angle: mpf) -> mpf:
    return tan(radians(angle))


def _corner(x: mpf, y: mpf, across: mpf, up: mpf) -> tuple[mpf, mpf]:
    """A corner of the back, one unit behind the front, moved along the picture."""
    return 640 + PIXELS_PER_UNIT * (x - across), 360 - PIXELS_PER_UNIT * (y - up)


def _drawn(scale: mpf) -> str:
    return f"settings.drawing=free settings.receding={_digits(scale)}"


# --------------------------------------------------------------------------- L12, L13


def _along(start: tuple[mpf, ...], way: tuple[mpf, ...], steps: mpf) -> tuple[mpf, ...]:
    return tuple(p + steps * d for p, d in zip(start, way, strict=True))


def _meets(d: mpf, d_x: mpf, d_z: mpf, p_x: mpf, p_z: mpf, steps: mpf) -> mpf:
    """Where the ray to a point of the line meets the plane z = -d."""
    x, z = _along((p_x, p_z), (d_x, d_z), steps)
    return x * (-d / z)


def _seen(view: tuple[mpf, ...], fov: mpf) -> tuple[mpf, mpf]:
    """The pixel of a point of view space, of 1280 by 720: the rays' share of the half picture."""
    x, y, z = view
    half = -z * tan(radians(fov) / 2)
    return _pixel(x / (half * 16 / 9), y / half)


def _turned(point: tuple[int, int, int], w: int, psi: mpf, theta: mpf) -> tuple[mpf, ...]:
    """A point of the world (w = 1) or a direction (w = 0) in the camera's own axes."""
    azimuth, elevation = radians(psi), radians(theta)
    n = [cos(elevation) * sin(azimuth), sin(elevation), cos(elevation) * cos(azimuth)]
    u = cross([mpf(0), mpf(1), mpf(0)], n)
    u = [part / hypot(u[0], u[2]) for part in u]
    eye = [14 * n[0], 2 + 14 * n[1], 14 * n[2]]
    off = [p - w * e for p, e in zip(point, eye, strict=True)]
    return tuple(sum(a * b for a, b in zip(axis, off, strict=True)) for axis in (u, cross(n, u), n))


def _found(psi: mpf, theta: mpf, fov: mpf) -> tuple[mpf, mpf]:
    return _seen(_turned((0, 0, -1), 0, psi, theta), fov)


def _cube_seen(azimuth: mpf, elevation: mpf) -> str:
    a, e = radians(azimuth), radians(elevation)
    eye = 4 * cos(e) * sin(a), mpf("0.5") + 4 * sin(e), 4 * cos(e) * cos(a)
    return "camera.eye=" + ",".join(map(_digits, eye))


def _far_point(
    d_x: mpf, d_y: mpf, d_z: mpf, p_x: mpf, p_z: mpf, fov: mpf, steps: mpf
) -> tuple[mpf, mpf]:
    return _seen(_along((p_x, mpf(0), p_z), (d_x, d_y, d_z), steps), fov)


def _times(d: mpf, factor: mpf, corner: mpf) -> tuple[mpf, ...]:
    """Rows 3 and 4, columns 3 and 4 of 000's matrix, each with a factor."""
    return factor, mpf(0), corner * (-1 / d), mpf(0)


# --------------------------------------------------------------------------- L15, L16


def _crossing(x_1: mpf, w_1: mpf, x_2: mpf, w_2: mpf) -> mpf:
    """Intersect the edge with the line x = w: (x, w) = (m, m) at t."""
    t, _m = lu_solve(matrix([[x_2 - x_1, -1], [w_2 - w_1, -1]]), matrix([-x_1, -w_1]))
    return t


def _in_square(x: mpf, z: mpf) -> tuple[mpf, mpf]:
    """The pixel of (x, 0, z) in a square picture of 720 pixels with a field of view of 90°."""
    return 360 - 360 * x / z, mpf(360)


def _cut_at(z: mpf, x_1: mpf, z_1: mpf, x_2: mpf, z_2: mpf) -> mpf:
    """The x at which the line through two points has this z."""
    slope, at_zero = lu_solve(matrix([[z_1, 1], [z_2, 1]]), matrix([x_1, x_2]))
    return slope * z + at_zero


def _joined(n: mpf, x_1: mpf, z_1: mpf, x_2: mpf, z_2: mpf) -> tuple[mpf, mpf]:
    """TEACHING affine-mid: the same share of the way between the two images."""
    (one, row), (other, _) = _in_square(x_1, z_1), _in_square(x_2, z_2)
    share = (-n - z_1) / (z_2 - z_1)
    return (1 - share) * one + share * other, row


def _far(q: mpf, one: mpf, other: mpf) -> str:
    return f"lens.far={_digits((1 - q) * one + q * other)}"


def _leaves(edge: mpf, a_x: mpf, a_y: mpf, b_x: mpf, b_y: mpf) -> tuple[mpf, mpf]:
    """Meet the line through A' and B' with the line x' = edge, both as homogeneous triples."""
    line = cross([a_x, a_y, mpf(1)], [b_x, b_y, mpf(1)])
    x, y, w = cross(line, [mpf(1), mpf(0), -edge])
    return _pixel(x / w, y / w, 720, 720)


def _in_case(k: mpf, z_a: mpf, z_b: mpf) -> str:
    """Stand between the ends, or before both, and look the right way along z."""
    if k == 2:
        eye, forward = min(z_a, z_b) - 1, -1
    else:  # what is behind the camera, A or B, has the larger z if it looks along -z
        eye, forward = (z_a + z_b) / 2, -1 if (z_a > z_b) == (k == 3) else 1
    return f"camera.eye=0,2.4,{_digits(eye)} camera.target=0,2.4,{_digits(eye + 2 * forward)}"


Numbers = Callable[..., object]
_OF: dict[str, dict[str, dict[str, Numbers]]] = {
    "l09-pyramid-to-cube": {
        "practise-1/mpp": {
            "right": lambda n, f: _row_3(-n / f),
            "c-kept": lambda n, f: _row_3(-n),
            "near-far": lambda n, f: _row_3(-f / n),
        },
        "practise-2/product": {
            "right": lambda n, f: _block(_m_z() * _m_pp(-n / f)),
            "order": lambda n, f: _block(_m_pp(-n / f) * _m_z()),
            "near-far": lambda n, f: _block(_m_z() * _m_pp(-f / n)),
        },
        "practise-3/set-c": {
            "done": lambda q, f: f"lens.near={_digits(q * f)}",
            "c-kept": lambda q, f: f"lens.near={_digits(q)}",
        },
    },
    "l10-parallel-lens": {
        "practise-1/row": {
            "right": lambda **of: _first_row(of["l"], of["r"]),
            "centre-sign": lambda **of: _first_row(of["l"], of["r"], -1),
            "transposed": lambda **of: (_first_row(of["l"], of["r"])[0], *[mpf(0)] * 3),
        },
        "practise-2/height": {
            "right": lambda b, t, y, d: _height(b, t, y),
            "ortho-div": lambda b, t, y, d: _height(b, t, y) / d,
            "middle": lambda b, t, y, d: -_height(b, t, -y),
        },
        "practise-3/set-height": {
            "done": lambda y, d, q: f"lens.bottom={_digits(-y / q)} lens.top={_digits(y / q)}",
            "ortho-div": lambda y, d, q: (
                f"lens.bottom={_digits(-y / q / d)} lens.top={_digits(y / q / d)}"
            ),
        },
    },
    "l11-oblique-drawing": {
        "practise-1/row": {
            "right": _h_row,
            "tan-cot": lambda alpha, n: _h_row(alpha, n, _tan),
            "signed": lambda alpha, n: _h_row(alpha, n, _slant, -1),
        },
        "practise-2/corner": {
            "right": lambda alpha, beta, x, y: _corner(x, y, _slant(alpha), _slant(beta)),
            "tan-cot": lambda alpha, beta, x, y: _corner(x, y, _tan(alpha), _tan(beta)),
            "opposite": lambda alpha, beta, x, y: _corner(x, y, -_slant(alpha), -_slant(beta)),
            "y-up": lambda alpha, beta, x, y: _corner(x, y, _slant(alpha), -_slant(beta)),
        },
        "practise-3/set-angle": {
            "done": lambda theta, g: _drawn(_slant(theta)),
            "tan-cot": lambda theta, g: _drawn(_tan(theta)),
            "cabinet": lambda theta, g: _drawn((90 - theta) / 45),
        },
    },
    "l12-vanishing-points": {
        "practise-1/place": {
            "right": lambda **of: _meets(**of, steps=FAR_AWAY),
            "inf-far": lambda **of: _meets(**of, steps=mpf(10)),
            "start": lambda **of: _meets(**of, steps=mpf(0)),
            "mirror": lambda **of: -_meets(**of, steps=FAR_AWAY),
        },
        "practise-2/find": {
            "right": _found,
            "inf-far": lambda psi, theta, fov: _seen(_turned((0, 0, -8), 1, psi, theta), fov),
            "y-up": lambda **of: (_found(**of)[0], 720 - _found(**of)[1]),
            "other-side": lambda **of: (1280 - _found(**of)[0], _found(**of)[1]),
        },
        "practise-3/set-count": {
            "done": lambda k, r, a, e: _cube_seen(r + (30 if k == 2 else 0), mpf(0)),
            "vp-three": lambda k, r, a, e: _cube_seen(r + 30, mpf(20)),
        },
    },
    "l13-homogeneous": {
        "practise-1/divide": {
            "right": lambda x, y, w: x * (1 / w),
            "no-divide": lambda x, y, w: x,
            "mirror": lambda x, y, w: x * (-1 / w),
            # The lens: n = 3, f = 9 come to -w and w, so the third number is 2 w - 9.
            "by-z": lambda x, y, w: (
                x / ((lambda a, b: a * w + b)(*_onto(mpf(3), mpf(9), mpf(-3), mpf(9))))
            ),
        },
        "practise-2/scaled": {
            "right": lambda d: _times(d, -1 / (-1 / d), -1 / (-1 / d)),
            "signed": lambda d: _times(d, -1 / (1 / d), d),
            "one-cell": lambda d: _times(d, mpf(1), d),
            "turned": lambda d: _times(d, 1 / d, d),
        },
        "practise-3/far-point": {
            "right": lambda **of: _far_point(**of, steps=FAR_AWAY),
            "inf-far": lambda **of: _far_point(**of, steps=mpf(5)),
            "y-up": lambda d_y, **of: _far_point(d_y=-d_y, **of, steps=FAR_AWAY),
        },
    },
    "l14-to-pixels": {
        "practise-1/matrix": {
            "right": lambda w, h: _viewport(w, mpf(-1), h, mpf(-1), mpf(1)),
            "y-up": lambda w, h: _viewport(w, mpf(-1), h, mpf(1), mpf(-1)),
            "ndc-01": lambda w, h: _viewport(w, mpf(0), h, mpf(0), mpf(1)),
            "corner": lambda w, h: (w / 2, mpf(0), mpf(0), mpf(0), -h / 2, mpf(0)),
        },
        "practise-2/point": {
            "right": _pixel,
            "y-up": lambda x, y: _pixel(x, -y),
            "ndc-01": _clamped,
        },
        "practise-3/centre": {
            # The middle between both edges of the pixel.
            "right": lambda i, w: (_onto_ndc(i, w) + _onto_ndc(i + 1, w)) / 2,
            "pixel-corner": lambda i, w: _onto_ndc(i, w),
            "ndc-01": lambda i, w: (i / w + (i + 1) / w) / 2,
            "outermost": lambda i, w: _onto_ndc(i, w - 1),
        },
    },
    "l15-clipping": {
        "practise-1/cut": {
            "right": _crossing,
            # TEACHING no-divide, affine-mid: x = 1, along the edge and in NDC.
            "no-divide": lambda x_1, w_1, x_2, w_2: _crossing(x_1, mpf(1), x_2, mpf(1)),
            "affine-mid": lambda x_1, w_1, x_2, w_2: _crossing(
                x_1 / w_1, mpf(1), x_2 / w_2, mpf(1)
            ),
        },
        "practise-2/near-cut": {
            "right": lambda n, **of: _in_square(_cut_at(-n, **of), -n),
            "eye-naive": lambda n, x_1, z_1, x_2, z_2: _in_square(x_2, z_2),
            "affine-mid": _joined,
        },
        "practise-3/set-far": {
            "done": lambda x_1, z_1, x_2, z_2, q: _far(q, -z_1, -z_2),
            "dist-depth": lambda x_1, z_1, x_2, z_2, q: _far(q, hypot(x_1, z_1), hypot(x_2, z_2)),
        },
    },
    "l16-eye-plane": {
        "practise-1/image": {
            "right": lambda x_a, z_a, x_b, z_b: (
                _cut_at(mpf("-0.01"), x_a, z_a, x_b, z_b) / -mpf("-0.01")
            ),
            "eye-naive": lambda x_a, z_a, x_b, z_b: -x_b / z_b,
            "mirror": lambda x_a, z_a, x_b, z_b: (
                _cut_at(mpf("-0.01"), x_a, z_a, x_b, z_b) / mpf("-0.01")
            ),
        },
        "practise-2/leaves": {
            "right": lambda e, **of: _leaves(e, **of),
            "eye-naive": lambda e, a_x, a_y, b_x, b_y: _pixel(b_x, b_y, 720, 720),
            "beyond": lambda e, **of: _leaves(-e, **of),
        },
        "practise-3/set-case": {
            "done": lambda k, x_a, z_a, x_b, z_b: _in_case(k, z_a, z_b),
            "moved": lambda **of: "settings.start=1,2.4,9 settings.end=1,2.4,9",
        },
    },
}


def _onto_ndc(edge: mpf, w: mpf) -> mpf:
    """The x' of an edge between pixels, of w pixels."""
    factor, summand = _onto(mpf(0), w, mpf(-1), mpf(1))
    return factor * edge + summand


KEYS: dict[tuple[str, str, str], Numbers] = {
    (lesson, block, name): key
    for lesson, blocks in _OF.items()
    for block, keys in blocks.items()
    for name, key in keys.items()
}
