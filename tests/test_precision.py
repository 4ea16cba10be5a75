"""The arithmetic rungs against an oracle of hundreds of digits, and their predicted errors."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from app import double_double as dd
from app import precision
from app.precision import (
    DRAWING_TOLERANCE_PX,
    LOOKED_AT,
    READING_TOLERANCE_DEPTH,
    READING_TOLERANCE_PX,
    RUNGS,
    Rung,
    drawing_bound_px,
    predict,
    rung_for_reading,
    trace,
)
from app.projection import (
    DEPTH_RANGES,
    LENSES,
    PLANES,
    Array,
    Camera,
    DepthRange,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
    ProjectionError,
    Trace,
    Vector,
)
from tests.oracles import exact

HD = (1920, 1080)
SLANTED = Camera((6.0, 5.0, 9.0), (0.0, 2.2, 0.0), (0.3, 1.0, -0.2))
# With coordinates up to 1e100 and windows down to 1e-205, what is left of a true zero must still
# be below the smallest float64.
DIGITS = 700
NOTHING = exact.mp.mpf(10) ** -330


# --------------------------------------------------------------------------- the truth


def truth(projection: Projection, points: Array, digits: int = DIGITS) -> list[list[Any]]:
    """View 3, clip 4, NDC 3, image 2, depth of each point; None where there is no picture."""
    with exact.mp.workdps(digits):
        oracle = exact.Exact(projection)
        rows = []
        for point in points.tolist():
            answer = oracle(point)
            clip = [value * answer.w for value in answer.ndc] + [answer.w]
            pixels = [*answer.ndc, *answer.image, answer.depth]
            rows.append([*answer.view, *clip, *(pixels if answer.w > 0 else [None] * 6)])
    return rows


def numbers(traced: Trace) -> Array:
    """The same numbers of a trace, (n, 13)."""
    return np.column_stack([traced.view, traced.clip, traced.ndc, traced.image, traced.depth])


def worst_ulp(projection: Projection, points: Array) -> float:
    """Largest error of the exact rung in units of the last place of the true value."""
    traced = trace(projection, points, "exact")
    worst = 0.0
    with exact.mp.workdps(DIGITS):
        for row, true_row in zip(numbers(traced), truth(projection, points), strict=True):
            for value, true in zip(row.tolist(), true_row, strict=True):
                if true is None:
                    assert math.isnan(value)
                elif abs(true) < NOTHING:
                    assert value == 0.0, (projection, value)
                else:
                    worst = max(worst, float(abs(value - true) / np.spacing(abs(float(true)))))
    return worst


def check_outside(projection: Projection, points: Array) -> None:
    """Hold `Trace.outside` against its definition at hundreds of digits."""
    lens = projection.lens
    outside = trace(projection, points, "exact").outside
    with exact.mp.workdps(DIGITS):
        for found, row in zip(outside, truth(projection, points), strict=True):
            x, y, w, distance = row[3], row[4], row[6], -row[2]
            beyond = (distance - lens.near, lens.far - distance, x + w, w - x, y + w, w - y)
            assert found.tolist() == [value < -NOTHING for value in beyond]


# --------------------------------------------------------------------------- cameras and points


def in_world(camera: Camera, points_view: Array) -> Array:
    return np.asarray(points_view) @ camera.frame + camera.eye


def points_in_view(projection: Projection, rng: np.random.Generator, count: int) -> Array:
    """Points spread over the view volume; where float64 has no such points, those beside them."""
    lens = projection.lens
    left, right, bottom, top = projection.window
    if lens.parallel:
        distance = rng.uniform(lens.near, lens.far, count)
    else:
        far = min(lens.far, 1e6 * lens.near)
        distance = lens.near * (far / lens.near) ** rng.random(count)
    spread = 1.0 if lens.parallel else distance / lens.near
    x = rng.uniform(left, right, count) * spread
    y = rng.uniform(bottom, top, count) * spread
    if lens.parallel:
        x += projection.shear[0] * (distance - lens.near)
        y += projection.shear[1] * (distance - lens.near)
    return in_world(projection.camera, np.column_stack([x, y, -distance]))


def seen(projection: Projection, points: Array) -> Array:
    return points[~trace(projection, points, "exact").outside.any(axis=1)]


def camera_at(rng: np.random.Generator, offset: float, up_angle: float = 1.0) -> Camera:
    """A camera of an everyday size, some way from the origin in a random direction."""
    centre = offset * rng.normal(size=3) / math.sqrt(3.0)
    eye = centre + rng.normal(size=3) * 5.0
    target = eye + rng.normal(size=3) * 4.0
    view = target - eye
    across = np.cross(view, rng.normal(size=3))
    up = view / np.linalg.norm(view) * math.cos(up_angle)
    up += across / np.linalg.norm(across) * math.sin(up_angle)
    return Camera(*(tuple(part.tolist()) for part in (eye, target, up)))


def figures(rng: np.random.Generator) -> Iterator[tuple[str, Projection]]:
    """Every row of the figures, for every lens that has it."""
    depths = list(DEPTH_RANGES)

    def with_depths(name: str, camera: Camera, lens: Lens, size: tuple[int, int] = HD) -> Any:
        for depth in depths:
            yield f"{name} {lens.kind} {depth}", Projection(camera, lens, size, depth)

    def lenses(near: float, far: float) -> list[Lens]:
        found: list[Lens] = [
            Perspective(45.0, near, far),
            Frustum(-0.3 * near, 0.9 * near, 0.1 * near, 0.7 * near, near, far, "x"),
        ]
        if far != math.inf:
            box = (-3.3, 5.1, -1.2, 4.4, near, far)
            found += [Orthographic(*box), Oblique(*box, alpha_deg=63.4, beta_deg=116.5)]
        return found

    for offset in (0.0, 1e3, 1e6, 1e9):
        for lens in lenses(0.1, 100.0):
            yield from with_depths(f"offset {offset:g}", camera_at(rng, offset), lens)
    for ratio in (1e1, 1e3, 1e6, 1e9, 1e12, math.inf):
        for lens in lenses(0.1, 0.1 * ratio):
            yield from with_depths(f"far/near {ratio:g}", camera_at(rng, 10.0), lens)
    for power in range(-12, 0, 3):
        for lens in lenses(1.0, 1.0 + 10.0**power):
            yield from with_depths(f"near ~ far {power}", camera_at(rng, 0.0), lens)
    for fov_y_deg in (1e-4, 1.0, 90.0, 179.0, 179.99):
        lens = Perspective(fov_y_deg, 0.1, 100.0)
        yield from with_depths(f"fov {fov_y_deg:g}", camera_at(rng, 10.0), lens)
    for power in range(-12, -2, 3):
        camera = camera_at(rng, 0.0, up_angle=10.0**power)
        for lens in lenses(0.1, 100.0):
            yield from with_depths(f"up {power}", camera, lens)
    for size in ((1, 16384), (16384, 1)):
        for lens in lenses(0.1, 100.0):
            yield from with_depths(f"aspect {size}", camera_at(rng, 10.0), lens, size)
    for narrow in (1e-6, 1e6):  # as glFrustum and glOrtho can have it
        lens = Frustum(-0.3 * narrow, 0.4 * narrow, -0.1, 0.3, 0.1, 100.0)
        yield from with_depths(f"window {narrow:g}", camera_at(rng, 10.0), lens)
        box = Orthographic(-3.0 * narrow, 4.0 * narrow, -1.0, 3.0, 0.1, 100.0)
        yield from with_depths(f"window {narrow:g}", camera_at(rng, 10.0), box)
    for angle_deg in (6e-5, 179.9999):
        lens = Oblique(-4.0, 4.0, -3.0, 3.0, alpha_deg=angle_deg, beta_deg=77.0)
        yield from with_depths(f"shear {angle_deg:g}", camera_at(rng, 10.0), lens)


def wild(rng: np.random.Generator) -> Projection:
    """A random document of any size that the model takes."""

    def power(low: float, high: float) -> float:
        return float(10.0 ** rng.uniform(low, high))

    while True:
        try:
            size = power(-90, 90)
            eye = rng.normal(size=3) * size * power(0, 9)
            target = eye + rng.normal(size=3) * size * power(-6, 2)
            camera = Camera(*(tuple(p.tolist()) for p in (eye, target, rng.normal(size=3))))
            near = size * power(-9, 2)
            far = near * (1.0 + power(-15, 15))
            half = power(-9, 9) * size
            window = (-half * power(-3, 0), half, -half, half * power(-3, 3))
            kind = rng.choice([*LENSES])
            if kind == "perspective":
                fov_y_deg = rng.choice([power(-9, 2), 180.0 - power(-9, 2)])
                lens: Lens = Perspective(fov_y_deg, near, rng.choice([far, math.inf]))
            elif kind == "frustum":
                lens = Frustum(*window, near, far, str(rng.choice(["stretch", "x", "y"])))
            elif kind == "orthographic":
                lens = Orthographic(*window, -near if rng.random() < 0.3 else near, far)
            else:
                angles = rng.uniform(1.0, 179.0, 2).tolist()
                lens = Oblique(*window, near, far, alpha_deg=angles[0], beta_deg=angles[1])
            size_px = (int(rng.integers(1, 16385)), int(rng.integers(1, 16385)))
            return Projection(camera, lens, size_px, str(rng.choice([*DEPTH_RANGES])))
        except ProjectionError:
            continue
