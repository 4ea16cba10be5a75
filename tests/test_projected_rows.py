"""`Projection.image_rows`: the fast way says what the traced one and the 80-digit oracle say."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.bootstrap import ROOT
from app.projection import (
    DEPTH_RANGES,
    LARGEST,
    Array,
    Camera,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
    ProjectionError,
)
from tests.oracles import exact

SLANTED = Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0), (0.3, 1.0, -0.2))
LENSES: dict[str, Lens] = {
    "perspective": Perspective(45.0, 1.0, 30.0),
    "telephoto": Perspective(20.0, 1.0, 30.0),
    "infinite": Perspective(90.0, 0.1, math.inf),
    "near close to far": Perspective(45.0, 1.0, 1.0 + 1e-9),
    "compensated": Perspective(1e-4, 1.0, 30.0),
    "frustum": Frustum(-0.1, 0.9, -0.3, 0.5, 1.0, 30.0),
    "infinite frustum": Frustum(-0.1, 0.9, -0.3, 0.5, 1.0, math.inf, "x"),
    "orthographic": Orthographic(-4.0, 4.0, -3.0, 3.0, 1.0, 30.0),
    "behind the eye": Orthographic(-40.0, 60.0, -30.0, 30.0, -20.0, 50.0, "y"),
    "thin": Orthographic(-40.0, 60.0, -30.0, 30.0, 20.0, 20.5),
    "oblique": Oblique(-40.0, 60.0, -30.0, 30.0, -2.0, 20.0),
    "compensated oblique": Oblique(-4.0, 4.0, -4.0, 4.0, 1.0, 30.0),
}


def projections() -> list[Any]:
    return [
        pytest.param(Projection(SLANTED, lens, (1920, 1080), depth), id=f"{name}, {depth}")
        for name, lens in LENSES.items()
        for depth in DEPTH_RANGES
    ]


def seen(projection: Projection, count: int) -> Array:
    """World points, (count, 3), all over the picture and between the planes."""
    rng = np.random.default_rng(count)
    near, far = projection.lens.near, min(projection.lens.far, 1e3)
    left, right, bottom, top = projection.window
    distance = rng.uniform(near, far, count)
    x, y = rng.uniform(left, right, count), rng.uniform(bottom, top, count)
    if projection.lens.parallel:
        cot_alpha, cot_beta = projection.shear
        x, y = x + cot_alpha * (distance - near), y + cot_beta * (distance - near)
    else:
        x, y = x * (distance / near), y * (distance / near)
    return np.column_stack([x, y, -distance]) @ projection.camera.frame + projection.camera.eye


def rows_of(points: Array) -> Array:
    return np.ascontiguousarray(points.T)


def traced(projection: Projection, rows: Array) -> Array:
    trace = projection.trace(rows.T)
    return np.vstack([trace.image.T, trace.depth])


def assert_alike(projection: Projection, found: Array, expected: Array) -> None:
    """Within twice the bound of either, and NaN in the same places.

    A depth between two planes that nearly touch is as wrong as the distance is, by the gap.
    """
    near, far = projection.lens.near, projection.lens.far
    over_gap = 1.0 if far == math.inf else max(1.0, max(abs(near), far) / (far - near))
    np.testing.assert_array_equal(np.isnan(found), np.isnan(expected))
    np.testing.assert_allclose(found[:2], expected[:2], rtol=1e-14, atol=5e-12)
    np.testing.assert_allclose(found[2], expected[2], rtol=1e-13, atol=1e-15 * over_gap)


@pytest.mark.parametrize("projection", projections())
def test_they_are_what_a_trace_says(projection: Projection) -> None:
    rows = rows_of(seen(projection, 3000))
    found, expected = projection.image_rows(rows), traced(projection, rows)
    assert found.shape == (3, 3000) and found.flags.c_contiguous
    assert np.isfinite(found).all()
    assert_alike(projection, found, expected)
    if projection.is_compensated:
        np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize("offset", [0.0, 1e3, 1e6, 1e9])
@pytest.mark.parametrize("depth", DEPTH_RANGES)
@pytest.mark.parametrize(
    "lens",
    [
        Perspective(fov_y_deg, near, far)
        for fov_y_deg in (1.0, 15.0, 45.0, 90.0, 120.0, 179.0)
        for near, far in ((1.0, 10.0), (0.001, 1e6), (1.0, math.inf))
    ]
    + [LENSES["orthographic"], LENSES["behind the eye"]],
    ids=repr,
)
def test_they_are_within_the_bounds_of_the_80_digit_oracle(
    lens: Lens, depth: str, offset: float
) -> None:
    eye, target = ((offset + a, offset - b, 2.0 * c) for a, b, c in ((6, 5, 9), (0, 2.2, 0)))
    camera = Camera(eye, target, (0.3, 1.0, -0.2))
    projection = Projection(camera, lens, (1920, 1080), depth)
    points = seen(projection, 12)
    found = projection.image_rows(rows_of(points))
    answer = exact.Exact(projection)
    compared = 0
    for point, (x, y, value) in zip(points, found.T, strict=True):
        right = answer(point)
        if not all(abs(part) <= 1 for part in right.ndc[:2]):
            continue  # rounding has moved it out of the picture, at 1e9 from the origin
        compared += 1
        assert abs(float(right.image[0] - x)) <= 5e-12
        assert abs(float(right.image[1] - y)) <= 5e-12
        assert abs(float(right.depth - value)) <= 1e-15
        if depth == "reversed" and not lens.parallel:
            # What the depth says of the distance, d = n/(f - n) (f - w)/w turned round.
            near, far = exact.mp.mpf(lens.near), exact.mp.mpf(lens.far)
            slope = near if lens.far == math.inf else near * far / (far - near)
            relative = abs(value - right.depth) * right.w / slope
            assert float(relative) <= 4e-16
    assert compared or offset == 1e9


@pytest.mark.parametrize("depth", DEPTH_RANGES)
@pytest.mark.parametrize("apart", [1e-2, 1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize("lens", [Perspective(45.0), Orthographic()], ids=["perspective", "ortho"])
def test_depth_between_planes_that_nearly_touch(lens: Lens, apart: float, depth: str) -> None:
    lens = replace(lens, near=1.0, far=1.0 + apart)
    projection = Projection(Camera((0, 0, 5), (0, 0, 0)), lens, (1920, 1080), depth)
    points = np.array([(0.1, 0.2, 5.0 - w) for w in np.linspace(lens.near, lens.far, 9)])
    answer = exact.Exact(projection)
    for point, value in zip(points, projection.image_rows(rows_of(points))[2], strict=True):
        assert abs(float(answer(point).depth - value)) <= 2.3e-16


@pytest.mark.parametrize("name", ["perspective", "frustum", "oblique", "compensated"])
@pytest.mark.parametrize("count", [0, 1, 2, 15, 16, 17, 31, 32, 33, 100])
def test_any_number_of_points(name: str, count: int) -> None:
    projection = Projection(SLANTED, LENSES[name])
    rows = rows_of(seen(projection, count))
    out = np.full((3, count), 7.0)
    assert projection.image_rows(rows, out) is out
    assert_alike(projection, out, traced(projection, rows))


@pytest.mark.parametrize("depth", DEPTH_RANGES)
@pytest.mark.parametrize("name", ["perspective", "infinite", "near close to far", "compensated"])
def test_points_in_or_behind_the_eye_plane_have_no_picture(name: str, depth: str) -> None:
    camera = Camera((0, 0, 5), (0, 0, 0))
    projection = Projection(camera, LENSES[name], (1920, 1080), depth)
    # 5 is the eye plane.
    z = [0, 1, 2, 3, 0, 9, 1, 6, 5, 1, 2, 3, 0, 5.5, 1, 2, 5, 9, 8, 7, 4, 5, 4]
    rows = np.array([np.zeros(len(z)), np.full(len(z), 1e-7), z])
    found = projection.image_rows(rows)
    assert_alike(projection, found, traced(projection, rows))
    np.testing.assert_array_equal(np.isnan(found), [np.array(z) >= 5] * 3)


def test_a_picture_that_overflows_is_none() -> None:
    projection = Projection(Camera((0, 0, 0), (0, 0, -1)), Perspective(45.0, 1e-200, 30.0))
    rows = np.array([(1e100, 0.0), (0.0, 0.0), (-1e-250, -2.0)])
    found = projection.image_rows(rows)
    np.testing.assert_array_equal(np.isnan(found), [(True, False)] * 3)
    assert_alike(projection, found, traced(projection, rows))


@pytest.mark.parametrize("wrong", [math.nan, math.inf, -math.inf])
@pytest.mark.parametrize("row", [0, 1, 2])
@pytest.mark.parametrize("name", ["perspective", "orthographic", "oblique", "compensated"])
@pytest.mark.parametrize("camera", [SLANTED, Camera((0, 0, 5), (0, 0, 0))], ids=["slanted", "axis"])
def test_numbers_that_are_not_finite_are_refused(
    camera: Camera, name: str, row: int, wrong: float
) -> None:
    projection = Projection(camera, LENSES[name])
    rows = np.zeros((3, 20))
    rows[2, 5] = 8.0  # behind one of the cameras, and not the error
    rows[row, 13] = wrong
    with pytest.raises(ProjectionError, match=r"points = .*three finite numbers"):
        projection.image_rows(rows)


@pytest.mark.parametrize("name", ["perspective", "orthographic"])
def test_numbers_too_large_for_a_picture_are_refused(name: str) -> None:
    rows = np.full((3, 2), 1.7e308)
    rows[:, 0] = 0.0
    with pytest.raises(ProjectionError, match=r"points = .*1\.7e\+308"):
        Projection(SLANTED, LENSES[name]).image_rows(rows)
    assert np.isfinite(Projection(SLANTED, LENSES["orthographic"]).image_rows(rows / 1e209)).all()
    assert rows.max() > LARGEST


@pytest.mark.parametrize(
    "wrong",
    [
        np.zeros(3), np.zeros((2, 5)), np.zeros((4, 5)), np.zeros((5, 3)), np.zeros((1, 3, 5)),
        np.zeros((3, 2), dtype=complex), np.zeros((3, 2), dtype=bool), "abc",
        [[1.0, 2.0], [3.0], [4.0, 5.0]],
    ],
    ids=lambda wrong: str(getattr(wrong, "shape", wrong)),
)  # fmt: skip
def test_what_is_not_three_rows_is_refused(wrong: object) -> None:
    with pytest.raises(ProjectionError, match=r"points = .*three finite numbers"):
        Projection().image_rows(wrong)  # type: ignore[arg-type]


def test_other_layouts_and_numbers_are_taken_too() -> None:
    projection = Projection(SLANTED)
    whole = np.array([(1, -2, 0), (0, 1, 2), (2, 1, -1)])
    expected = projection.image_rows(whole.astype(np.float64))
    fixed = whole.astype(np.float64)
    fixed.setflags(write=False)
    for same in (
        *(whole, whole.tolist(), whole.astype(np.float32), whole.astype(">f8"), fixed),
        *(np.asfortranarray(fixed), whole.astype(np.longdouble)),
    ):
        np.testing.assert_array_equal(projection.image_rows(same), expected)


def test_where_it_cannot_write_is_refused() -> None:
    rows = np.zeros((3, 5))
    shared = np.zeros((4, 5))
    fixed = np.zeros((3, 5))
    fixed.setflags(write=False)
    wrong = (np.zeros((5, 3)), np.zeros((3, 4)), np.zeros((3, 5), np.float32), fixed)
    for out in (*wrong, rows, rows[:], rows[::-1]):
        with pytest.raises(ValueError, match=r"out must be a \(3, 5\) float64 array"):
            Projection().image_rows(rows, out)
    with pytest.raises(ValueError, match="apart from the points"):
        Projection().image_rows(shared[:3], shared[1:])
    strided = np.zeros((5, 6)).T[::2]
    np.testing.assert_array_equal(
        Projection().image_rows(rows, strided), Projection().image_rows(rows)
    )


def test_it_is_compiled_where_nothing_can_be_written() -> None:
    """A read-only installation and no folder of the user's own, or a full disk."""
    script = (
        "import tempfile\n"
        "def refuse(*_, **__): raise OSError(28, 'No space left on device')\n"
        "tempfile.TemporaryFile = refuse\n"
        "from app.projection import Projection\n"
        "from app.loops import project_rows\n"
        "print(type(project_rows._cache).__name__)\n"
        "print(Projection().image_rows([[0.0], [0.0], [0.0]]).shape)\n"
    )
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", script], cwd=ROOT, capture_output=True, text=True
    )
    assert (done.stderr, done.stdout.split("\n", 1)) == ("", ["NullCache", "(3, 1)\n"])


@pytest.mark.parametrize("ending", [".nbi", ".nbc"])
@pytest.mark.parametrize("left", [0.0, 0.5])
def test_it_is_compiled_where_what_was_kept_is_damaged(
    tmp_path: Path, ending: str, left: float
) -> None:
    script = "from app.projection import Projection; print(Projection().image_rows([[0]] * 3).T)"

    def printed() -> str:
        return subprocess.run(
            [sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, check=True,
            env={**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)},
        ).stdout  # fmt: skip

    first = printed()
    (kept,) = tmp_path.glob(f"*/*{ending}")
    kept.write_bytes(kept.read_bytes()[: int(left * kept.stat().st_size)])
    assert printed() == first


def test_a_depth_that_overflows_alone_is_refused() -> None:
    projection = Projection(Camera((0, 0, 5), (0, 0, 0)), Orthographic(near=1.0, far=1.001))
    with pytest.raises(ProjectionError, match=r"points = .*three finite numbers"):
        projection.image_rows([[0.0], [0.0], [-1.7e308]])
