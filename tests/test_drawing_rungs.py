"""Pictures at the extremes, where float32 cannot draw them: pixel by pixel against 80 digits."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import pyvista as pv
from numpy.typing import NDArray

from app.drawings import WORDS, rungs
from app.drawings.image import ImageDrawing
from app.drawings.ndc import NdcDrawing
from app.drawings.style import LIGHT
from app.precision import DRAWING_TOLERANCE_PX
from app.projection import (
    DEPTH_RANGES,
    Camera,
    Frustum,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)
from app.scene import Scene, load
from tests.oracles.exact import frame, minus, mp, vector
from tests.oracles.exact import dot as exact_dot
from tests.test_drawings import OffScreen, drawn, off_screen, scene_of, to_bytes, without_lines

__all__ = ["off_screen"]

Mask = NDArray[np.bool_]
SIZE = (640, 360)
RED, GREEN = (200, 30, 30), (30, 200, 30)


def triangle_at(
    projection: Projection, corners: Sequence[tuple[float, float, float]], origin: Any
) -> NDArray[np.float32]:
    """Scene-local vertices that are seen at (x_ndc, y_ndc) from a distance, nearly: rounded."""
    left, right, bottom, top = projection.window
    camera, lens = projection.camera, projection.lens
    points = []
    for x_ndc, y_ndc, distance in corners:
        scale = 1.0 if lens.parallel else distance / lens.near
        x = scale * (left + (right - left) * (x_ndc + 1.0) / 2.0)
        y = scale * (bottom + (top - bottom) * (y_ndc + 1.0) / 2.0)
        x -= projection.shear[0] * (lens.near - distance)
        y -= projection.shear[1] * (lens.near - distance)
        offset = np.array([x, y, -distance]) @ camera.frame
        points.append((np.array(camera.eye) - origin) + offset)
    return np.array(points).astype(np.float32)


def expected(
    projection: Projection, points: Any, size: tuple[int, int], band_px: float
) -> tuple[Mask, Mask]:
    """Pixels that a convex polygon must light and must not light, at 80 digits.

    Those whose centres are nearer to its outline than the band are in neither.
    """
    camera, lens = projection.camera, projection.lens
    rows = frame(camera.eye, camera.target, camera.up)
    corners = []
    for point in points:
        offset = minus(vector(point), vector(camera.eye))
        x, y, z = (exact_dot(row, offset) for row in rows)
        corners.append([x, y, -z])
    limits = [(1, mp.mpf(lens.near))]
    if lens.far != math.inf:
        limits.append((-1, -mp.mpf(lens.far)))
    for sign, limit in limits:
        inside = [sign * corner[2] - limit for corner in corners]
        left = []
        for i, (corner, value) in enumerate(zip(corners, inside, strict=True)):
            before, value_before = corners[i - 1], inside[i - 1]
            if (value >= 0) != (value_before >= 0):
                t = value_before / (value_before - value)
                left.append([b + t * (c - b) for b, c in zip(before, corner, strict=True)])
            if value >= 0:
                left.append(corner)
        corners = left
    width, height = size
    columns, lines = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    if len(corners) < 3:
        nowhere = np.zeros(columns.shape, dtype=bool)
        return nowhere, ~nowhere
    window_left, right, bottom, top = map(mp.mpf, projection.window)
    image = []
    for x, y, distance in corners:
        if lens.parallel:
            x += mp.mpf(projection.shear[0]) * (mp.mpf(lens.near) - distance)
            y += mp.mpf(projection.shear[1]) * (mp.mpf(lens.near) - distance)
        else:
            x, y = (part * mp.mpf(lens.near) / distance for part in (x, y))
        image.append(
            (
                width * (x - window_left) / (right - window_left),
                height * (top - y) / (top - bottom),
            )
        )
    middle = [sum(part) / len(image) for part in zip(*image, strict=True)]
    nearest = np.full(columns.shape, np.inf)
    for i, (x, y) in enumerate(image):
        x_before, y_before = image[i - 1]
        a, b = y - y_before, x_before - x
        length = mp.sqrt(a * a + b * b)
        if length == 0:
            continue
        c = -(a * x + b * y)
        sign = 1 if a * middle[0] + b * middle[1] + c > 0 else -1
        a, b, c = (float(sign * part / length) for part in (a, b, c))
        nearest = np.minimum(nearest, a * columns + b * lines + c)
    return nearest > band_px, nearest < -band_px


def scene_at(points: Any, origin: Any, colours: Any = (RED,)) -> Scene:
    """One triangle for every three points."""
    faces = np.arange(len(points)).reshape(-1, 3).tolist()
    scene = scene_of(points, faces, colours, tuple(origin))
    assert scene.surface is not None
    assert (scene.surface.points.astype(np.float32) == scene.surface.points).all()
    return scene


FAR_AWAY = (1e7, -2e7, 3e7)
INSIDE = ((-0.7, -0.6), (0.8, -0.3), (0.1, 0.8))
ACROSS = ((-40.0, -31.0), (60.0, 40.3), (-0.8, 0.7))  # two corners 15 pictures away and more


def camera_from(eye: Any, direction: Any) -> Camera:
    eye = np.array(eye, dtype=float)
    return Camera(tuple(eye), tuple(eye + direction))


EXTREMES: dict[str, tuple[Projection, Any, tuple[float, float, float]]] = {
    "eye near a vertex": (
        Projection(camera_from((6, 5, 9), (-6, -3, -9)), Perspective(60, 1e-6, 100), SIZE),
        (0, 0, 0),
        (1e-5, 10.0, 4e-6),
    ),
    "eye near a vertex, far from the origin": (
        Projection(
            camera_from(np.add(FAR_AWAY, (6, 5, 9)), (-6, -3, -9)), Perspective(60, 1e-6, 100), SIZE
        ),
        FAR_AWAY,
        (1e-5, 10.0, 4e-6),
    ),
    "narrow": (
        Projection(Camera((6, 5, 9), (0, 2.2, 0)), Perspective(1e-4, 1, 30), SIZE),
        (3, -1, 2),
        (11.0, 12.0, 11.5),
    ),
    "wide": (
        Projection(Camera((0.3, 0.4, 9), (0, 0.2, 0)), Perspective(179.9, 1e-6, 30), SIZE),
        (0, 0, 0),
        (1e-5, 2e-5, 2e-5),
    ),
    "off axis": (
        Projection(
            Camera((6, 5, 9), (0, 2.2, 0)), Frustum(0.5, 0.500002, -0.3, -0.299999, 1, 30), SIZE
        ),
        (3, -1, 2),
        (11.0, 12.0, 11.5),
    ),
    "parallel, eye far away": (
        Projection(
            Camera((1e7, 2e7, 3e7), (0, 2.2, 0)), Orthographic(-4e-5, 4e-5, -3e-5, 3e-5, 1, 1e8), SIZE
        ),
        (3, -1, 2),
        (37416573.0, 37416574.0, 37416573.0),
    ),
    "oblique, small window": (
        Projection(
            Camera((6, 5, 9), (0, 2.2, 0)),
            Oblique(-4e-6, 4e-6, -4e-6, 4e-6, 1, 30, alpha_deg=50, beta_deg=70),
            SIZE,
        ),
        (3, -1, 2),
        (11.0, 12.0, 11.5),
    ),
}


@pytest.mark.parametrize("corners", [INSIDE, ACROSS], ids=["inside", "across"])
@pytest.mark.parametrize("name", EXTREMES)
def test_the_picture_is_right_where_float32_is_not(
    name: str, corners: Any, off_screen: Callable[[int, int], OffScreen]
) -> None:
    projection, origin, distances = EXTREMES[name]
    places = [(*corner, d) for corner, d in zip(corners, distances, strict=True)]
    points = triangle_at(projection, places, origin)
    scene = scene_at(points, origin)
    wrong = {}
    for tolerance_px in (math.inf, DRAWING_TOLERANCE_PX):
        screen = off_screen(*SIZE)
        drawing = ImageDrawing(screen.plotter, scene, WORDS, LIGHT, tolerance_px, framed=False)
        drawing.show_projection(projection)
        lit = drawn(screen.pixels(), RED)
        band_px = 1.0 if tolerance_px == math.inf else 0.02
        must, must_not = expected(
            projection, points.astype(float) + np.array(origin, dtype=float), SIZE, band_px
        )
        assert must.sum() > 2000 and must_not.sum() > 2000
        wrong[drawing.rung] = int((must & ~lit).sum() + (must_not & lit).sum())
    assert wrong["float64"] == 0
    assert wrong["float32"] > 20, "not an extreme"
