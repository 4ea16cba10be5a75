"""Matrices of other programs, rounded or not, are recognised by what they do."""

import itertools
import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
import pytest

from app.lecture.conventions import in_convention, world_planes
from app.lecture.rounded import moved_px
from app.lecture.typed_matrix import properties, readings, rounded_view, with_matrix
from app.model.projection import (
    Camera,
    FreeMatrix,
    Frustum,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.model.refusal import MATRIX, Refusal

FOV, ASPECT, NEAR, FAR = 60.0, 1.25, 0.1, 1000.0
SIZE = (1000, 800)
START = Projection(Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0)), image_size=SIZE)
COT = 1.0 / math.tan(math.radians(FOV) / 2.0)


def perspective(w: float, a: float, b: float, *, y: float = 1.0) -> Any:
    return np.array([[COT / ASPECT, 0, 0, 0], [0, y * COT, 0, 0], [0, 0, a, b], [0, 0, w, 0]])


def glm_perspective() -> Any:
    """glm::perspectiveRH_NO, three.js' makePerspective, gluPerspective."""
    return perspective(-1, -(FAR + NEAR) / (FAR - NEAR), -2 * FAR * NEAR / (FAR - NEAR))


def glm_perspective_lh() -> Any:
    """glm::perspectiveLH_NO."""
    return perspective(1, (FAR + NEAR) / (FAR - NEAR), -2 * FAR * NEAR / (FAR - NEAR))


def d3dx_lh() -> Any:
    """D3DXMatrixPerspectiveFovLH and XMMatrixPerspectiveFovLH, for row vectors."""
    return perspective(1, FAR / (FAR - NEAR), -NEAR * FAR / (FAR - NEAR)).T


def d3dx_rh() -> Any:
    """D3DXMatrixPerspectiveFovRH, for row vectors."""
    return perspective(-1, FAR / (NEAR - FAR), NEAR * FAR / (NEAR - FAR)).T


def glm_zero_to_one() -> Any:
    """glm::perspectiveRH_ZO."""
    return perspective(-1, FAR / (NEAR - FAR), -(FAR * NEAR) / (FAR - NEAR))


def vulkan() -> Any:
    """The same with ``proj[1][1] *= -1``, as Vulkan's tutorials write it."""
    return perspective(-1, FAR / (NEAR - FAR), -(FAR * NEAR) / (FAR - NEAR), y=-1)


def reversed_z() -> Any:
    """Near to 1 and far to 0, as Unreal, and Unity's GL.GetGPUProjectionMatrix."""
    return perspective(-1, NEAR / (FAR - NEAR), FAR * NEAR / (FAR - NEAR))


def pyrender_infinite() -> Any:
    """pyrender's PerspectiveCamera without zfar, and glm::infinitePerspective."""
    return perspective(-1, -1, -2 * NEAR)


def unity() -> Any:
    """Camera.projectionMatrix, and Matrix4x4.Perspective: OpenGL's on every platform."""
    return glm_perspective()


def opencv() -> Any:
    """A K with an axis beside the middle, as an OpenGL matrix of a camera with y down."""
    f, (w, h), (cx, cy) = COT * SIZE[1] / 2, SIZE, (520.0, 380.0)
    return np.array([
        [2 * f / w, 0, 2 * cx / w - 1, 0], [0, -2 * f / h, 1 - 2 * cy / h, 0],
        [0, 0, (FAR + NEAR) / (FAR - NEAR), -2 * FAR * NEAR / (FAR - NEAR)], [0, 0, 1, 0],
    ])  # fmt: skip


def blender_shift() -> Any:
    """calc_matrix_camera with shift_x = 0.1."""
    found = glm_perspective()
    found[0, 2] = 0.2
    return found


def vtk_parallel() -> Any:
    """vtkCamera's GetProjectionTransformMatrix of a parallel projection, and glOrtho."""
    return np.array([
        [1 / 5, 0, 0, 0], [0, 1 / 4, 0, 0],
        [0, 0, -2 / (FAR - NEAR), -(FAR + NEAR) / (FAR - NEAR)], [0, 0, 0, 1],
    ])  # fmt: skip


def direct3d_parallel() -> Any:
    """XMMatrixOrthographicLH(10, 8), for row vectors."""
    return np.array([
        [1 / 5, 0, 0, 0], [0, 1 / 4, 0, 0], [0, 0, 1 / (FAR - NEAR), -NEAR / (FAR - NEAR)],
        [0, 0, 0, 1],
    ]).T  # fmt: skip


def nvdiffrast() -> Any:
    """util.projection of its samples with y down: ``[0, n/-x, 0, 0]``."""
    return perspective(
        -1, -(FAR + NEAR) / (FAR - NEAR), -(2 * FAR * NEAR) / (FAR - NEAR), y=-1
    )  # fmt: skip


class Does(NamedTuple):
    depth: str
    y: int
    z: int
    is_transposed: bool
    lens: Any


SYMMETRIC = Perspective(FOV, NEAR, FAR)
LIBRARIES: dict[Callable[[], Any], Does] = {
    glm_perspective: Does("opengl", 1, 1, False, SYMMETRIC),
    glm_perspective_lh: Does("opengl", 1, -1, False, SYMMETRIC),
    d3dx_lh: Does("direct3d", 1, -1, True, SYMMETRIC),
    d3dx_rh: Does("direct3d", 1, 1, True, SYMMETRIC),
    glm_zero_to_one: Does("direct3d", 1, 1, False, SYMMETRIC),
    vulkan: Does("direct3d", -1, 1, False, SYMMETRIC),
    reversed_z: Does("reversed", 1, 1, False, SYMMETRIC),
    pyrender_infinite: Does("opengl", 1, 1, False, Perspective(FOV, NEAR, math.inf)),
    opencv: Does("opengl", -1, -1, False, None),
    blender_shift: Does("opengl", 1, 1, False, None),
    vtk_parallel: Does("opengl", 1, 1, False, Orthographic(-5, 5, -4, 4, NEAR, FAR)),
    direct3d_parallel: Does("direct3d", 1, -1, True, Orthographic(-5, 5, -4, 4, NEAR, FAR)),
    unity: Does("opengl", 1, 1, False, SYMMETRIC),
    nvdiffrast: Does("opengl", -1, 1, False, SYMMETRIC),
}
SIDES = {
    # With the axis right of the middle and above it, more is seen on the left and below.
    "opencv": (-1.3, 1.2, -1.05, 0.95),
    "blender_shift": (-1.0, 1.5, -1.0, 1.0),
}
"""Left, right, bottom and top of the lenses off the axis, where the field of view has 1."""
ROUNDINGS: dict[str, Callable[[float], float]] = {
    "float64": float,
    "float32": lambda number: float(np.float32(number)),
    "float32 printed": lambda number: float(str(np.float32(number))),
    "six digits": lambda number: float(f"{number:.6g}"),
    "ten digits": lambda number: float(f"{number:.10g}"),
    "thirteen digits": lambda number: float(f"{number:.13g}"),
}
EXACT_ASPECT = Fraction(*SIZE)
IN_HAND = Perspective()


@pytest.mark.parametrize("rounding", ROUNDINGS)
@pytest.mark.parametrize("library", LIBRARIES, ids=lambda library: library.__name__)
def test_a_library_is_recognised_by_what_its_matrix_does(
    library: Callable[[], Any], rounding: str
) -> None:
    rounded = ROUNDINGS[rounding]
    cells: Any = tuple(tuple(map(rounded, row)) for row in library().tolist())
    wanted = LIBRARIES[library]
    found = readings(cells, SIZE, "opengl", IN_HAND)
    right = [r for r in found if r[1:] == wanted[:4]]
    assert len(right) == 1 and len(found) <= 2, found
    lens: Any = right[0].lens
    if wanted.lens is not None:
        assert lens.kind == wanted.lens.kind
        assert (lens.near, lens.far) == (wanted.lens.near, wanted.lens.far)
        for a, b in zip(lens.window(EXACT_ASPECT), wanted.lens.window(EXACT_ASPECT), strict=True):
            assert a == pytest.approx(b, rel=1e-5)
        if rounding != "float64" and isinstance(lens, Perspective):
            assert lens.fov_y_deg == FOV
    else:
        assert isinstance(lens, Frustum) and (lens.near, lens.far) == (NEAR, FAR)
        sides = (lens.left, lens.right, lens.bottom, lens.top)
        assert np.array(sides) / NEAR * COT == pytest.approx(SIDES[library.__name__], abs=1e-4)


@pytest.mark.parametrize("depth", ["direct3d", "opengl"])
def test_a_left_handed_matrix_keeps_its_field_of_view_near_and_far(depth: Any) -> None:
    cells: Any = [
        [1.3856406, 0, 0, 0],
        [0, 1.7320508, 0, 0],
        [0, 0, 1.0001, -0.10001],
        [0, 0, 1, 0],
    ]
    start = Projection(START.camera, image_size=(1280, 720), depth=depth)
    typed = with_matrix(start, "clip_from_view", cells)
    assert str(properties(typed, "clip_from_view")[0]) == (
        "left-handed: looks along +z, y up; z from 0 at near to 1 at far; fov 60°, near 0.1, far"
        " 1000"
    )
    back = typed.with_lens("perspective").lens
    assert (back.near, back.far) == (0.1, 1000.0)
    assert back.fov_y_deg == pytest.approx(60.0, abs=1e-4)


def test_a_row_vector_matrix_is_said_to_be_one() -> None:
    typed = with_matrix(START, "clip_from_view", d3dx_lh().tolist())
    first, second, *_ = map(str, properties(typed, "clip_from_view"))
    assert first == "rows and columns are exchanged: its transpose is meant"
    assert second.startswith("left-handed: looks along +z, y up; z from 0 at near to 1 at far; fov")


def test_six_digits_give_the_present_lens() -> None:
    lens = Perspective(47.5, 0.25, 80.0)
    cells = Projection(START.camera, lens).clip_from_view.tolist()
    printed = [[float(f"{cell:.6g}") for cell in row] for row in cells]
    assert with_matrix(Projection(START.camera), "clip_from_view", printed).lens == lens


# --------------------------------------------------------------------------- rounded views

VIEWS = {
    "float32": [[0.9553365, -0.29552022, 0, 0], [0.29552022, 0.9553365, 0, 0], [0, 0, 1, -3]],
    "six digits": [[0.955336, -0.29552, 0, 0], [0.29552, 0.955336, 0, 0], [0, 0, 1, -3]],
    "four digits": [[0.9553, -0.2955, 0, 0], [0.2955, 0.9553, 0, 0], [0, 0, 1, -3]],
    "three digits": [[0.955, -0.296, 0, 0], [0.296, 0.955, 0, 0], [0, 0, 1, -3]],
    "ten digits": [
        [0.9553364891, -0.2955202067, 0, 0], [0.2955202067, 0.9553364891, 0, 0], [0, 0, 1, -3],
    ],
}  # fmt: skip


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("float32", ["rows are orthonormal to 3e−08: rounded to float32",
                     "the nearest camera would move the picture by at most 2.8e−05 px"]),
        ("six digits", ["rows are orthonormal to 1e−06: rounded to 6 digits",
                        "the nearest camera would move the picture by at most 0.001 px"]),
        ("four digits", ["rows are orthonormal to 8e−05: rounded to 4 digits",
                         "the nearest camera would move the picture by at most 0.08 px"]),
        ("three digits", ["rows are orthonormal to 0.0004: rounded to 3 digits",
                          "the nearest camera would move the picture by at most 0.35 px"]),
        ("ten digits", ["rows are orthonormal to 3e−11: rounded to 10 digits",
                        "the nearest camera would move the picture by at most 2.6e−08 px"]),
    ],
)  # fmt: skip
def test_a_rounded_view_matrix_is_the_nearest_camera(name: str, said: list[str]) -> None:
    cells: Any = [*VIEWS[name], [0, 0, 0, 1]]
    found = with_matrix(START, "view_from_world", cells)
    assert found.lens == START.lens
    assert (found.camera.eye, found.camera.target) == ((0.0, 0.0, 3.0), (0.0, 0.0, -2.0))
    off = 0.04 if name == "three digits" else 2e-3
    assert found.camera.orbit.roll_deg == pytest.approx(math.degrees(0.3), abs=off)
    assert list(map(str, rounded_view(found, cells))) == [
        said[0], said[1].replace("camera would move", "camera is used; it moves")
    ]  # fmt: skip
    # The matrix alone, as after --set: nothing is replaced, and the same is said.
    lens = FreeMatrix(found.clip_from_view.tolist(), cells, START.lens)
    typed = Projection(START.camera, lens, SIZE)
    assert list(map(str, properties(typed, "view_from_world")))[:2] == said


@pytest.mark.parametrize(
    "rows",
    [
        np.eye(3) * 1.01, np.eye(3) * 1.001, np.eye(3) * 1.0001, np.diag([1.0, 1.00001, 1.0]),
        np.eye(3) + np.diag([0.01, 0.0], 1), np.eye(3) + np.diag([1e-7], 2),
        np.array(VIEWS["float32"])[:, :3] * 1.00001,
        np.array(VIEWS["ten digits"])[:, :3] * (1.0 + 1e-9), np.diag([1.0, 0.999, 1.0]),
        np.array(VIEWS["six digits"])[:, :3] + [[0, 0.0001, 0], [0, 0, 0], [0, 0, 0]],
    ],
)  # fmt: skip
def test_a_wrong_view_matrix_is_no_camera(rows: Any) -> None:
    cells = np.eye(4)
    cells[:3, :3] = rows
    typed = with_matrix(START, "view_from_world", cells.tolist())
    assert MATRIX["not-rigid"] in [each.template for each in properties(typed, "view_from_world")]


@pytest.mark.parametrize("places", [12, 10, 7, 6, 5, 4])
@pytest.mark.parametrize(
    "lens",
    [
        Perspective(60.0, 0.1, 100.0), Perspective(150.0, 1.0, 30.0),
        Frustum(-0.1, 0.9, -0.2, 0.3, 1.0, math.inf), Orthographic(-5, 1, -4, 4, -3, 30),
        Oblique(-5, 1, -4, 4, 1, 30, alpha_deg=50.0, beta_deg=70.0),
    ],
)  # fmt: skip
def test_the_picture_moves_less_than_is_said(lens: Any, places: int) -> None:
    random = np.random.default_rng(places)
    for _ in range(5):
        eye, target = np.round(5.0 * random.normal(size=(2, 3)), 2).tolist()
        exact = Projection(Camera(eye, target), lens, SIZE)
        cells = np.round(exact.stages[1].matrix, places)
        found = with_matrix(exact, "view_from_world", cells.tolist())
        assert found.lens == lens and found.camera.eye == exact.camera.eye
        most = moved_px(cells, found.camera, found)
        x, y, depth = random.uniform(0.0, 1.0, (3, 2000))
        x[:500], y[500:1000] = np.round(x[:500]), np.round(y[500:1000])
        depth *= 0.0 if lens.far == math.inf else random.integers(0, 2, 2000)
        points = found.world_from_image(np.column_stack([x * SIZE[0], y * SIZE[1], depth]))
        clip = np.column_stack([points, np.ones(2000)]) @ (found.clip_from_view @ cells).T
        moved = (clip[:, :2] / clip[:, 3:] - found.trace(points).ndc[:, :2]) * np.array(SIZE) / 2
        furthest = np.hypot(*moved.T).max()
        assert furthest <= most <= 30.0 * furthest


# --------------------------------------------------------------------------- ours in theirs


def clip_of(found: dict[str, Any], point: Any, *, rows: bool) -> Any:
    """Clip coordinates of a point of the other world."""
    matrix = found["clip_from_world"]
    return np.array([*point, 1.0]) @ (matrix if rows else matrix.T)


@pytest.mark.parametrize("rows", [False, True], ids=["columns", "rows"])
@pytest.mark.parametrize("name", ["opengl", "direct3d", "vulkan", "unity"])
@pytest.mark.parametrize("lens", [SYMMETRIC, Orthographic(-5, 4, -4, 3, 0.1, 1000)])
def test_another_program_sees_the_same_picture(lens: Any, name: str, rows: bool) -> None:
    ours = Projection(Camera((3.0, 2.0, 4.0), (0.5, 0.25, -1.0), (0.1, 1.0, 0.2)), lens, SIZE)
    found = in_convention(ours, name, rows=rows)
    view, clip, whole = found.values()
    assert np.abs((view @ clip if rows else clip @ view) - whole).max() < 1e-12
    world_z = -1.0 if name in ("direct3d", "unity") else 1.0
    down = -1.0 if name == "vulkan" else 1.0
    points = np.array([(0.5, 0.25, -1.0), (-1.0, 0.5, 0.75), (0.0, 0.0, -8.0)])
    trace = ours.trace(points)
    for point, ndc, depth, seen in zip(points, trace.ndc, trace.depth, trace.view, strict=True):
        x, y, z, w = clip_of(found, point * (1.0, 1.0, world_z), rows=rows)
        assert (x / w, down * y / w) == pytest.approx(ndc[:2], abs=1e-12)
        low = 0.0 if name in ("direct3d", "vulkan") else -1.0
        assert z / w == pytest.approx(low + (1.0 - low) * depth, abs=1e-9)
        there = view.T if rows else view
        forward = -1.0 if name == "direct3d" else 1.0
        assert (there @ [*(point * (1, 1, world_z)), 1.0])[2] == pytest.approx(forward * seen[2])
    # What is printed for others is what is recognised of others.
    cells = tuple(tuple(row) for row in found["clip_from_view"].tolist())
    (best, *_) = readings(cells, SIZE, "opengl", lens)
    if lens is SYMMETRIC:
        assert best.lens == lens and best.is_transposed == rows


def test_opencv_projects_to_our_pixels() -> None:
    lens = Frustum(-0.1, 0.3, -0.2, 0.1, 0.2, 50.0)
    ours = Projection(Camera((3.0, 2.0, 4.0), (0.5, 0.25, -1.0)), lens, SIZE)
    pose, calibration, whole = in_convention(ours, "opencv", rows=False).values()
    assert (pose.shape, calibration.shape, whole.shape) == ((3, 4), (3, 3), (3, 4))
    points = np.array([(0.5, 0.25, -1.0), (-1.0, 0.5, 0.75)])
    homogeneous = np.column_stack([points, [1.0, 1.0]]) @ whole.T
    pixels = homogeneous[:, :2] / homogeneous[:, 2:]
    assert np.abs(pixels + 0.5 - ours.trace(points).image).max() < 1e-9
    assert (np.column_stack([points, [1.0, 1.0]]) @ pose.T)[:, 2].min() > 0.0
    with pytest.raises(Refusal, match="perspective, frustum"):
        in_convention(Projection(START.camera, Orthographic()), "opencv", rows=False)


@pytest.mark.parametrize("depth", ["opengl", "direct3d", "reversed"])
@pytest.mark.parametrize(
    "lens",
    [
        SYMMETRIC, Frustum(-0.1, 0.3, -0.2, 0.1, 0.2, 50.0), Orthographic(-5, 4, -4, 3, -2, 9),
        Oblique(-5, 4, -4, 3, 1, 9), Perspective(60.0, 0.1, math.inf),
    ],
)  # fmt: skip
def test_the_planes_pass_through_the_corners(lens: Any, depth: Any) -> None:
    ours = Projection(Camera((3.0, 2.0, 4.0), (0.5, 0.25, -1.0)), lens, SIZE, depth)
    planes = world_planes(ours)
    assert list(planes) == ["near", "far", "left", "right", "bottom", "top"]
    is_infinite = lens.far == math.inf
    assert (planes["far"] is None) == is_infinite
    for corner in itertools.product((0, 1), repeat=3):  # of x, y, depth
        x, y, away = corner
        z = (
            (1 - away if depth == "reversed" else away)
            if not is_infinite
            else float(depth == "reversed")
        )
        point = ours.world_from_image([x * SIZE[0], y * SIZE[1], z])
        on = {("left", "right")[x], ("top", "bottom")[y], ("near", "far")[away]}
        for name, plane in planes.items():
            if plane is None or (is_infinite and name == "near"):
                continue
            distance = float(np.dot(plane[:3], point)) + plane[3]
            assert np.linalg.norm(plane[:3]) == pytest.approx(1.0, abs=1e-14)
            assert (abs(distance) < 1e-9) if name in on else (distance > 1e-3), (name, corner)
