"""The formulas of the five lectures, each against what the program computes from it.

The lectures' slips are corrected where they stand: 000 variant Y's last line, 003's orthographic
matrix and its y proportion; 002's off-axis column has the wrong sign for its w' = z. 002's signed
planes are turned into ours.
"""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from app.model.lenses.perspective import (
    focal_length_e,
    fov_x_from_fov_y,
    fov_y_from_focal_length_e,
    fov_y_from_window,
)
from app.model.projection import (
    Array,
    Camera,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.model.tables import NO_M_PP
from tests.support.frustum import corners_world
from tests.support.lenses import SLANTED

QUICK = settings(max_examples=60)

ORIGIN = Camera((0.0, 0.0, 0.0), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0))
"""World coordinates are the lectures' camera coordinates."""
SIDES = (-0.3, 0.9, -0.7, 0.2)
OFF_AXIS = Frustum(*SIDES, 1.5, 30.0)
SYMMETRIC = Perspective(45.0, 1.0, 30.0)
POINTS = np.array([(1.0, -2.0, -7.0), (-2.5, 0.5, -12.0), (0.3, 0.1, -1.6), (-4.0, 6.0, -29.0)])


def stages(projection: Projection) -> dict[str, Array]:
    return {stage.name: stage.matrix for stage in projection.stages}


def homogeneous(points: Array) -> Array:
    return np.column_stack([points, np.ones(len(points))])


# --------------------------------------------------------------------------- 000


def test_l5_000_1_points_land_on_the_plane_at_distance_d() -> None:
    for lens in (SYMMETRIC, OFF_AXIS):
        projection = Projection(ORIGIN, lens)
        d = lens.near
        x, y, z = POINTS.T
        x_p, y_p = d * x / -z, d * y / -z
        left, right, bottom, top = projection.window
        ndc = projection.trace(POINTS).ndc
        found = (
            left + (right - left) * (ndc[:, 0] + 1) / 2,
            bottom + (top - bottom) * (ndc[:, 1] + 1) / 2,
        )
        np.testing.assert_allclose(found, [x_p, y_p], rtol=1e-13, atol=1e-14)


def test_l5_000_2_and_3_the_plane_s_matrices_are_the_same_up_to_a_factor() -> None:
    """The matrix with -1/d and the one with d on its diagonal; ours has w = -z as (3) has."""
    d = SYMMETRIC.near
    equation_2 = np.eye(4)
    equation_2[3] = 0.0, 0.0, -1.0 / d, 0.0
    equation_3 = np.diag([d, d, d, 0.0])
    equation_3[3, 2] = -1.0
    np.testing.assert_allclose(d * equation_2, equation_3, atol=1e-16)
    clip = Projection(ORIGIN, SYMMETRIC).clip_from_view
    np.testing.assert_array_equal(clip[3], equation_3[3])
    plane = homogeneous(POINTS) @ equation_3.T
    projected = plane[:, :3] / plane[:, 3:]
    np.testing.assert_allclose(projected[:, 2], -d)
    # A point and its picture on the plane have the same pixel.
    trace = Projection(ORIGIN, SYMMETRIC).trace
    np.testing.assert_allclose(trace(projected).image, trace(POINTS).image, rtol=1e-13)


@pytest.mark.parametrize("lens", [OFF_AXIS, Orthographic(*SIDES, 1.0, 30.0)])
def test_l6_000_5_to_8_the_window_goes_to_minus_1_and_1(lens: Frustum | Orthographic) -> None:
    x, y, z = POINTS.T
    (x_min, x_max, y_min, y_max), z_min = SIDES, lens.near
    if lens.parallel:  # (5) and (7)
        x_new = 2 / (x_max - x_min) * x + (x_min + x_max) / (x_min - x_max)
        y_new = 2 / (y_max - y_min) * y + (y_min + y_max) / (y_min - y_max)
    else:  # (6) and (8)
        x_new = 1 / -z * (2 * z_min / (x_max - x_min) * x + (x_min + x_max) / (x_max - x_min) * z)
        y_new = 1 / -z * (2 * z_min / (y_max - y_min) * y + (y_min + y_max) / (y_max - y_min) * z)
    ndc = Projection(ORIGIN, lens).trace(POINTS).ndc
    np.testing.assert_allclose(ndc[:, :2], np.column_stack([x_new, y_new]), rtol=1e-13, atol=1e-15)


def test_l8_000_9_to_11_an_affine_z_bends_lines_and_ours_does_not() -> None:
    projection = Projection(ORIGIN, OFF_AXIS)
    near, far = OFF_AXIS.near, OFF_AXIS.far
    a, b = np.array((-0.2, -0.9, -2.0)), np.array((6.0, -9.0, -28.0))
    on_line = a + np.linspace(0.0, 1.0, 9)[:, None] * (b - a)
    ndc = projection.trace(on_line).ndc
    affine = ndc.copy()  # (9): A z + B with near -> -1 and far -> 1
    affine[:, 2] = -2.0 / (far - near) * on_line[:, 2] - (far + near) / (far - near)

    def bend(points: Array) -> float:
        along, aside = points[-1] - points[0], points - points[0]
        return float(np.linalg.norm(np.cross(along, aside), axis=1).max() / np.linalg.norm(along))

    assert bend(ndc) < 1e-14
    assert bend(affine) > 0.1
    # (11): in homogeneous coordinates it would be -A z^2 - B z, which no matrix can make.
    z_clip = affine[:, 2] * -on_line[:, 2]
    A, B = -2.0 / (far - near), -(far + near) / (far - near)
    np.testing.assert_allclose(z_clip, -A * on_line[:, 2] ** 2 - B * on_line[:, 2], rtol=1e-12)


def test_l8_000_a_and_b_of_12_from_their_two_equations() -> None:
    for lens in (SYMMETRIC, OFF_AXIS):
        z_min, z_max = lens.near, lens.far
        a, b = np.linalg.solve([[-1.0, 1.0 / z_min], [-1.0, 1.0 / z_max]], [-1.0, 1.0])
        assert a == pytest.approx((z_min + z_max) / (z_min - z_max), rel=1e-14)
        assert b == pytest.approx(2 * z_min * z_max / (z_min - z_max), rel=1e-14)
        found = Projection(ORIGIN, lens).clip_from_view
        np.testing.assert_allclose(found[2], [0.0, 0.0, a, b], rtol=1e-14)
        z = POINTS[:, 2]
        np.testing.assert_allclose(
            Projection(ORIGIN, lens).trace(POINTS).ndc[:, 2], 1 / -z * (a * z + b), rtol=1e-12
        )


@pytest.mark.parametrize("lens", [SYMMETRIC, Perspective(150.0, 0.5, 2.0), OFF_AXIS])
def test_l6_000_13_the_perspective_matrix(lens: Lens) -> None:
    projection = Projection(SLANTED, lens)
    (x_min, x_max, y_min, y_max), z_min, z_max = projection.window, lens.near, lens.far
    lecture = [
        [2 * z_min / (x_max - x_min), 0, (x_max + x_min) / (x_max - x_min), 0],
        [0, 2 * z_min / (y_max - y_min), (y_max + y_min) / (y_max - y_min), 0],
        [0, 0, (z_min + z_max) / (z_min - z_max), 2 * z_min * z_max / (z_min - z_max)],
        [0, 0, -1, 0],
    ]
    np.testing.assert_allclose(projection.clip_from_view, lecture, rtol=1e-14, atol=1e-16)


@given(
    st.tuples(*[st.floats(-50.0, 50.0)] * 2),
    st.tuples(*[st.floats(0.01, 50.0)] * 2),
    st.integers(1, 16384),
    st.integers(1, 16384),
    st.sampled_from([Frustum, Orthographic, Oblique]),
)
@example((-1.0, -9.0), (8.0, 12.0), 1280, 720, Frustum)  # off-centre: Y's slip shows only there
@QUICK
def test_l7_000_variants_x_and_y_keep_the_proportions(
    low: tuple[float, float],
    extent: tuple[float, float],
    w: int,
    h: int,
    lens: type[Frustum] | type[Orthographic] | type[Oblique],
) -> None:
    x_min, y_min = low
    x_max, y_max = x_min + extent[0], y_min + extent[1]
    sides = x_min, x_max, y_min, y_max

    k = (h / w * (x_max - x_min) - (y_max - y_min)) / 2
    expected = (x_min, x_max, y_min - k, y_max + k)
    projection = Projection(lens=lens(*sides, keep="x"), image_size=(w, h))
    np.testing.assert_allclose(projection.window, expected, rtol=1e-13, atol=1e-13)
    kept = projection.lens.exact_window(Fraction(w, h))
    assert (kept[1] - kept[0]) / (kept[3] - kept[2]) == Fraction(w, h)

    k = (w / h * (y_max - y_min) - (x_max - x_min)) / 2
    expected = (x_min - k, x_max + k, y_min, y_max)  # the lecture has y_max + k for x_max + k
    projection = Projection(lens=lens(*sides, keep="y"), image_size=(w, h))
    np.testing.assert_allclose(projection.window, expected, rtol=1e-13, atol=1e-13)

    assert Projection(lens=lens(*sides), image_size=(w, h)).window == sides


# --------------------------------------------------------------------------- 001

PYRAMIDS: dict[str, Lens] = {
    "symmetric": SYMMETRIC,
    "wide": Perspective(120.0, 0.01, 5.0),
    "off-axis": OFF_AXIS,
    "kept": Frustum(*SIDES, 1.5, 30.0, "x"),
}


def test_l1_001_the_camera_frame() -> None:
    """w = -look, v = up without its w part, u = v x w; 004's u, v, n in another order."""
    look = np.subtract(SLANTED.target, SLANTED.eye)
    up = np.array(SLANTED.up)
    w = -look / np.linalg.norm(look)
    v = up - np.dot(up, w) * w
    v /= np.linalg.norm(v)
    np.testing.assert_allclose(SLANTED.frame, [np.cross(v, w), v, w], atol=1e-15)


def test_l4_001_points_of_the_far_face() -> None:
    """A, B and C: the far face's centre, and the middles of its right and upper edge."""
    lens = SYMMETRIC
    projection = Projection(SLANTED, lens, (1280, 720))
    u, v, w = SLANTED.frame
    position, f = np.array(SLANTED.eye), lens.far
    theta_v = math.radians(lens.fov_y_deg)
    theta_h = math.radians(fov_x_from_fov_y(lens.fov_y_deg, 1280 / 720))
    a = position - f * w
    b = a + f * math.tan(theta_h / 2) * u
    c = a + f * math.tan(theta_v / 2) * v
    corners = corners_world(projection)[4:, :3]
    np.testing.assert_allclose(corners.mean(axis=0), a, rtol=1e-13)
    np.testing.assert_allclose((corners[1] + corners[2]) / 2, b, rtol=1e-13)
    np.testing.assert_allclose((corners[2] + corners[3]) / 2, c, rtol=1e-13)
    # Which the canonical perspective volume has at (0, 0, -1), (1, 0, -1) and (0, 1, -1).
    found = stages(projection)
    matrix = found["canonical_perspective_from_view"] @ found["view_from_world"]
    expected = [(0, 0, 0), (0, 0, -1), (1, 0, -1), (0, 1, -1)]
    image = homogeneous(np.array([position, a, b, c])) @ matrix.T
    np.testing.assert_allclose(image, homogeneous(np.array(expected)), atol=1e-13)


def test_l9_001_m_persp() -> None:
    lens = SYMMETRIC
    projection = Projection(SLANTED, lens, (1280, 720))
    f, theta_v = lens.far, math.radians(lens.fov_y_deg)
    theta_h = math.radians(fov_x_from_fov_y(lens.fov_y_deg, 1280 / 720))
    scale = np.diag([1 / (f * math.tan(theta_h / 2)), 1 / (f * math.tan(theta_v / 2)), 1 / f, 1])
    rotation, translation = np.eye(4), np.eye(4)
    rotation[:3, :3] = SLANTED.frame
    translation[:3, 3] = np.negative(SLANTED.eye)
    found = stages(projection)
    product = found["canonical_perspective_from_view"] @ found["view_from_world"]
    np.testing.assert_allclose(product, scale @ rotation @ translation, rtol=1e-13, atol=1e-15)


@pytest.mark.parametrize("lens", PYRAMIDS.values(), ids=PYRAMIDS)
def test_l9_001_m_pp_and_its_check_of_the_corner(lens: Lens) -> None:
    n, f = lens.near, lens.far
    c = -n / f
    m_pp = stages(Projection(SLANTED, lens))["canonical_parallel_from_canonical_perspective"]
    lecture = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1 / (1 + c), -c / (1 + c)], [0, 0, -1, 0]]
    np.testing.assert_allclose(m_pp, lecture, rtol=1e-13)
    times_extent = [[f - n, 0, 0, 0], [0, f - n, 0, 0], [0, 0, f, n], [0, 0, -(f - n), 0]]
    np.testing.assert_allclose((f - n) * m_pp, times_extent, rtol=1e-13)
    # The near face's upper right corner (-c, -c, c) goes to (1, 1, 0), and every other likewise.
    for x in (-1.0, 1.0):
        for y in (-1.0, 1.0):
            near, far = m_pp @ [-c * x, -c * y, c, 1.0], m_pp @ [x, y, -1.0, 1.0]
            np.testing.assert_allclose(near / near[3], [x, y, 0.0, 1.0], atol=1e-13)
            np.testing.assert_allclose(far / far[3], [x, y, -1.0, 1.0], atol=1e-13)


def test_l9_001_m_pp_of_an_infinite_pyramid_is_its_limit() -> None:
    """Scaled by near, which lies at z = -1; c would be 0, and the whole pyramid with it."""
    projection = Projection(SLANTED, Perspective(45.0, 2.0, math.inf))
    found = stages(projection)
    far_away = stages(Projection(SLANTED, Perspective(45.0, 2.0, 1e15)))
    to_parallel = "canonical_parallel_from_canonical_perspective"
    to_pyramid = "canonical_perspective_from_view"
    ours = found[to_parallel] @ found[to_pyramid]
    limit = far_away[to_parallel] @ far_away[to_pyramid]
    np.testing.assert_allclose(ours / ours[3, 2], limit / limit[3, 2], rtol=1e-13)
    assert (found[to_pyramid] @ [0.0, 0.0, -2.0, 1.0])[2] == -1.0


def test_l9_001_m_z() -> None:
    for lens in (*PYRAMIDS.values(), Orthographic(), Oblique()):
        m_z = stages(Projection(SLANTED, lens))["depth_range_from_canonical_parallel"]
        np.testing.assert_array_equal(
            m_z, [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -2, -1], [0, 0, 0, 1]]
        )
    # Direct3D: [0, -1] -> [0, 1]; reversed: [0, -1] -> [1, 0].
    for depth, ends in (("direct3d", (0.0, 1.0)), ("reversed", (1.0, 0.0))):
        m_z = stages(Projection(SLANTED, SYMMETRIC, depth=depth))[
            "depth_range_from_canonical_parallel"
        ]
        assert ((m_z @ [0, 0, 0, 1])[2], (m_z @ [0, 0, -1, 1])[2]) == ends


@pytest.mark.parametrize("depth", ["opengl", "direct3d", "reversed"])
@pytest.mark.parametrize("lens", PYRAMIDS.values(), ids=PYRAMIDS)
def test_l9_001_m_z_m_pp_m_persp_is_the_clip_matrix(lens: Lens, depth: str) -> None:
    projection = Projection(SLANTED, lens, depth=depth)
    found = stages(projection)
    m_z = found["depth_range_from_canonical_parallel"]
    m_pp = found["canonical_parallel_from_canonical_perspective"]
    m_persp = found["canonical_perspective_from_view"] @ found["view_from_world"]
    whole = m_z @ m_pp @ m_persp
    clip = projection.clip_from_world
    # Up to a factor: the lecture's w is the distance over far.
    np.testing.assert_allclose(lens.far * whole, clip, rtol=1e-12, atol=1e-12 * np.abs(clip).max())


def test_l10_001_a_parallel_volume_needs_no_m_pp() -> None:
    for lens in (Orthographic(*SIDES, 1.0, 30.0), Oblique(*SIDES, -2.0, 30.0)):
        projection = Projection(ORIGIN, lens)
        found = {stage.name: stage for stage in projection.stages}
        m_pp = found["canonical_parallel_from_canonical_perspective"]
        np.testing.assert_array_equal(m_pp.matrix, np.eye(4))
        assert m_pp.note == NO_M_PP
        corners = corners_world(projection)
        box = corners @ found["canonical_parallel_from_view"].matrix.T
        face = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
        np.testing.assert_allclose(
            box[:, :3], [(*xy, z) for z in (0, -1) for xy in face], atol=1e-13
        )


# --------------------------------------------------------------------------- 002

NEAR_AND_FAR = [(1.0, 30.0), (0.25, 4.0)]


def p_ort(x_l: float, x_r: float, y_b: float, y_t: float, z_n: float, z_f: float) -> Array:
    """002's P_ort, whose z_n > z_f are coordinates: ours are -near and -far, z reversed."""
    return np.array(
        [
            [2 / (x_r - x_l), 0, 0, -(x_r + x_l) / (x_r - x_l)],
            [0, 2 / (y_t - y_b), 0, -(y_t + y_b) / (y_t - y_b)],
            [0, 0, 2 / (z_n - z_f), -(z_n + z_f) / (z_n - z_f)],
            [0, 0, 0, 1],
        ]
    )


def p_persp(x_l: float, x_r: float, y_b: float, y_t: float, z_n: float, z_f: float) -> Array:
    """002's P_persp in front of the axis, without the third column's shear."""
    return np.array(
        [
            [2 * z_n / (x_r - x_l), 0, 0, 0],
            [0, 2 * z_n / (y_t - y_b), 0, 0],
            [0, 0, -(z_f + z_n) / (z_f - z_n), 2 * z_n * z_f / (z_f - z_n)],
            [0, 0, 1, 0],
        ]
    )


REVERSED_Z = np.diag([1.0, 1.0, -1.0, 1.0])


@pytest.mark.parametrize(("near", "far"), NEAR_AND_FAR)
def test_l10_002_p_ort(near: float, far: float) -> None:
    found = Projection(ORIGIN, Orthographic(*SIDES, near, far)).clip_from_view
    np.testing.assert_allclose(found, REVERSED_Z @ p_ort(*SIDES, -near, -far), rtol=1e-14)


@pytest.mark.parametrize(("near", "far"), NEAR_AND_FAR)
@pytest.mark.parametrize(("alpha_deg", "beta_deg"), [(110.0, 75.0), (45.0, 90.0), (90.0, 163.0)])
def test_l11_002_h_and_p_obl(near: float, far: float, alpha_deg: float, beta_deg: float) -> None:
    z_n = -near
    cot_alpha, cot_beta = 1 / np.tan(np.radians([alpha_deg, beta_deg]))
    h = np.array(
        [[1, 0, cot_alpha, -z_n * cot_alpha], [0, 1, cot_beta, -z_n * cot_beta], [0, 0, 1, 0],
         [0, 0, 0, 1]]
    )  # fmt: skip
    # x' = x - (z_n - z) cot(alpha)
    x, _, z = POINTS.T
    np.testing.assert_allclose((homogeneous(POINTS) @ h.T)[:, 0], x - (z_n - z) * cot_alpha)
    lens = Oblique(*SIDES, near, far, alpha_deg=alpha_deg, beta_deg=beta_deg)
    projection = Projection(ORIGIN, lens)
    lecture = REVERSED_Z @ p_ort(*SIDES, -near, -far) @ h
    np.testing.assert_allclose(projection.clip_from_view, lecture, rtol=1e-13, atol=1e-14)
    # And it is a stage's factor of that name.
    (stage,) = (s for s in projection.stages if s.name == "canonical_parallel_from_view")
    np.testing.assert_allclose(dict(stage.factors)["shear"], h, atol=1e-15)


@pytest.mark.parametrize(("near", "far"), NEAR_AND_FAR)
def test_l6_002_perspective_is_ours_times_minus_1_with_z_reversed(near: float, far: float) -> None:
    sides = (-0.8, 0.8, -0.3, 0.3)
    ours = Projection(ORIGIN, Frustum(*sides, near, far)).clip_from_view
    np.testing.assert_allclose(
        REVERSED_Z @ ours, -p_persp(*sides, -near, -far), rtol=1e-14, atol=1e-16
    )
    # Its A + B/z: z' = 1 at near and -1 at far, with B < 0 so that depth keeps its order.
    z_n, z_f = -near, -far
    A, B = -(z_f + z_n) / (z_f - z_n), 2 * z_n * z_f / (z_f - z_n)
    assert (A + B / z_n, A + B / z_f) == (pytest.approx(1.0), pytest.approx(-1.0))
    assert B < 0.0
    z = np.array([z_n, -2.0, -2.5, z_f])
    ndc = Projection(ORIGIN, Frustum(*sides, near, far)).trace(np.array([0 * z, 0 * z, z]).T).ndc
    np.testing.assert_allclose(-ndc[:, 2], A + B / z, atol=1e-14)


@pytest.mark.parametrize(("near", "far"), NEAR_AND_FAR)
def test_l11_002_off_axis_perspective_is_h_and_then_the_symmetric_one(
    near: float, far: float
) -> None:
    """H moves the window's middle onto the axis: cot(alpha) is its x over near."""
    x_l, x_r, y_b, y_t = SIDES
    lens = Frustum(*SIDES, near, far)
    projection = Projection(ORIGIN, lens)
    h = np.eye(4)
    h[:2, 2] = (x_r + x_l) / 2 / near, (y_t + y_b) / 2 / near
    across, up = (x_r - x_l) / 2, (y_t - y_b) / 2
    centred = Projection(ORIGIN, Frustum(-across, across, -up, up, near, far)).clip_from_view
    np.testing.assert_allclose(projection.clip_from_view, centred @ h, rtol=1e-14)
    # The lecture has +(x_r + x_l)/(x_r - x_l) there, which with its w' = z would send the window's
    # middle to twice that and not to 0: a slip, and the rest is ours times -1 with z reversed.
    lecture = p_persp(*SIDES, -near, -far)
    lecture[:2, 2] = -(x_r + x_l) / (x_r - x_l), -(y_t + y_b) / (y_t - y_b)
    np.testing.assert_allclose(REVERSED_Z @ projection.clip_from_view, -lecture, rtol=1e-14)
    (stage,) = (s for s in projection.stages if s.name == "canonical_perspective_from_view")
    np.testing.assert_allclose(dict(stage.factors)["shear"], h, atol=1e-16)


def test_l13_002_a_direction_is_a_point_at_infinity() -> None:
    corners = corners_world(Projection(ORIGIN, Perspective(90.0, 1.0, math.inf), (100, 100)))
    np.testing.assert_array_equal(corners[4:, 3], 0.0)
    np.testing.assert_allclose(corners[6, :3] / -corners[6, 2], [1.0, 1.0, -1.0], rtol=1e-15)


@given(st.floats(-1, 1), st.floats(-1, 1), st.integers(1, 16384), st.integers(1, 16384))
@QUICK
def test_l14_002_viewport(x_norm: float, y_norm: float, width: int, height: int) -> None:
    matrix = Projection(image_size=(width, height)).image_from_ndc
    x_win, y_win = width / 2 * (x_norm + 1), height / 2 * (1 - y_norm)
    image = matrix @ [x_norm, y_norm, 0.0, 1.0]
    np.testing.assert_allclose(image[:2], [x_win, y_win], rtol=1e-15, atol=1e-11)


# --------------------------------------------------------------------------- 003


def test_l5_003_similar_triangles_to_ndc() -> None:
    (left, right, bottom, top), n = SIDES, OFF_AXIS.near
    x_eye, y_eye, z_eye = POINTS.T
    x_p, y_p = n * x_eye / -z_eye, n * y_eye / -z_eye
    x_ndc = 2 * (x_p - left) / (right - left) - 1
    y_ndc = 2 * (y_p - bottom) / (top - bottom) - 1
    # The proportions (r - l):2 = (x_p - l):(x_ndc + 1), and (t - b):2, which has (b - t):2 there.
    np.testing.assert_allclose((right - left) / 2, (x_p - left) / (x_ndc + 1), rtol=1e-12)
    np.testing.assert_allclose((top - bottom) / 2, (y_p - bottom) / (y_ndc + 1), rtol=1e-12)
    ndc = Projection(ORIGIN, OFF_AXIS).trace(POINTS).ndc
    np.testing.assert_allclose(ndc[:, :2], np.column_stack([x_ndc, y_ndc]), rtol=1e-13)


@pytest.mark.parametrize("lens", [SYMMETRIC, Perspective(150.0, 0.5, 2.0), OFF_AXIS])
def test_l6_003_perspective_matrix_with_its_a_and_b(lens: Lens) -> None:
    projection = Projection(SLANTED, lens)
    (left, right, bottom, top), n, f = projection.window, lens.near, lens.far
    # (A z + B)/(-z) = -1 at z = -n and 1 at z = -f
    a, b = np.linalg.solve([[-n, 1.0], [-f, 1.0]], [-n, f])
    assert a == pytest.approx(-(f + n) / (f - n), rel=1e-14)
    assert b == pytest.approx(-2 * f * n / (f - n), rel=1e-14)
    lecture = [
        [2 * n / (right - left), 0, (right + left) / (right - left), 0],
        [0, 2 * n / (top - bottom), (top + bottom) / (top - bottom), 0],
        [0, 0, a, b],
        [0, 0, -1, 0],
    ]
    np.testing.assert_allclose(projection.clip_from_view, lecture, rtol=1e-13, atol=1e-16)


@given(st.floats(0.5, 179.0), st.integers(1, 16384), st.integers(1, 16384))
@example(53.13010235415598, 100, 100)  # e = 2
@QUICK
def test_l3_003_focal_length_e_and_its_frustum(fov_y_deg: float, width: int, height: int) -> None:
    """glFrustum's left and right are -n/e and n/e, bottom and top -a n/e and a n/e."""
    n, a = 0.75, height / width  # the lecture's a is height over width
    lens = Perspective(fov_y_deg, n, 30.0)
    projection = Projection(SLANTED, lens, (width, height))
    e = focal_length_e(fov_y_deg, width / height)
    assert e == pytest.approx(1 / math.tan(math.radians(fov_x_from_fov_y(fov_y_deg, 1 / a)) / 2))
    window = (-n / e, n / e, -a * n / e, a * n / e)
    np.testing.assert_allclose(projection.window, window, rtol=1e-13)
    frustum = Projection(SLANTED, Frustum(*window, n, 30.0), (width, height))
    np.testing.assert_allclose(frustum.clip_from_view, projection.clip_from_view, rtol=1e-12)
    # beta, the vertical field: tan(beta/2) = a/e; and back from e and from the window.
    assert math.degrees(2 * math.atan(a / e)) == pytest.approx(fov_y_deg, rel=1e-12)
    assert fov_y_from_focal_length_e(e, width / height) == pytest.approx(fov_y_deg, rel=1e-12)
    assert fov_y_from_window(window[3], n) == pytest.approx(fov_y_deg, rel=1e-12)


def test_l10_003_orthographic_matrix_without_its_slip() -> None:
    left, right, bottom, top, n, f = -1.0, 7.0, -9.0, 3.0, -2.0, 5.0
    projection = Projection(lens=Orthographic(left, right, bottom, top, n, f))
    lecture = [
        [2 / (right - left), 0, 0, -(right + left) / (right - left)],  # there 2n/(r - l)
        [0, 2 / (top - bottom), 0, -(top + bottom) / (top - bottom)],
        [0, 0, -2 / (f - n), -(f + n) / (f - n)],
        [0, 0, 0, 1],
    ]
    np.testing.assert_allclose(projection.clip_from_view, lecture, rtol=1e-15)


# --------------------------------------------------------------------------- 004


def test_l1_004_look_at_and_the_view_matrix() -> None:
    camera = SLANTED
    x0, y0, z0 = camera.eye
    n_vector = np.subtract(camera.eye, camera.target)
    n = n_vector / np.linalg.norm(n_vector)
    u_vector = np.cross(camera.up, n)
    u = u_vector / np.linalg.norm(u_vector)
    v = np.cross(n, u)
    rotation = [[*u, 0], [*v, 0], [*n, 0], [0, 0, 0, 1]]
    translation = [[1, 0, 0, -x0], [0, 1, 0, -y0], [0, 0, 1, -z0], [0, 0, 0, 1]]
    product = [
        [*u, -u[0] * x0 - u[1] * y0 - u[2] * z0],
        [*v, -v[0] * x0 - v[1] * y0 - v[2] * z0],
        [*n, -n[0] * x0 - n[1] * y0 - n[2] * z0],
        [0, 0, 0, 1],
    ]
    projection = Projection(camera)
    np.testing.assert_allclose(camera.frame, [u, v, n], atol=1e-15)
    np.testing.assert_allclose(projection.view_rotation, rotation, atol=1e-15)
    np.testing.assert_array_equal(projection.view_translation, translation)
    np.testing.assert_allclose(projection.view_from_world, product, atol=1e-14)


def test_l14_004_pixels_by_scale_and_shift() -> None:
    """u = s_x x_p + p_x with s_x pixels per unit of the plane at distance d, as 004 draws."""
    projection = Projection(ORIGIN, SYMMETRIC, (1280, 720))
    _, right, _, top = projection.window
    d, (x, y, z) = SYMMETRIC.near, POINTS.T
    x_pix = 640 / right * (-d / z * x) + 640
    y_pix = -360 / top * (-d / z * y) + 360
    found = projection.trace(POINTS).image
    np.testing.assert_allclose(found, np.column_stack([x_pix, y_pix]), rtol=1e-13)
