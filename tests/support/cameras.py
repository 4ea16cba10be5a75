"""Random cameras and lenses."""

import math
from collections.abc import Iterator

import numpy as np

from app.model.projection import (
    DEPTH_RANGES,
    LENSES,
    Camera,
    Frustum,
    Lens,
    Oblique,
    Orthographic,
    Perspective,
    Projection,
)


def random_projections(
    count: int, seed: int = 0, size: tuple[int, int] = (640, 480)
) -> Iterator[Projection]:
    """Cameras round the letter F, with every lens and depth range in turn."""
    random = np.random.default_rng(seed)
    for number in range(count):
        direction = random.normal(size=3)
        eye = random.uniform(2.0, 40.0) * direction / np.linalg.norm(direction)
        target, up = random.uniform((-1, 1, -1), (1, 3, 1)), random.normal(size=3)
        near = 10.0 ** random.uniform(-4.0, 0.0)
        far = near + 10.0 ** random.uniform(-2.0, 6.0)
        kind = list(LENSES)[number % 4]
        low, high = random.uniform(-8.0, -0.5, 2), random.uniform(0.5, 8.0, 2)
        keep = random.choice(["stretch", "x", "y"])
        lens: Lens
        if kind == "perspective":
            lens = Perspective(
                10.0 ** random.uniform(0.0, 2.2), near, math.inf if number % 5 == 0 else far
            )
        elif kind == "frustum":
            sides = 0.2 * near * np.array([low[0], high[0], low[1], high[1]])
            sides += 0.1 * near * (number % 3) * low[0]  # the axis may be outside the picture
            lens = Frustum(*sides, near, math.inf if number % 5 == 0 else far, keep)
        elif kind == "orthographic":
            lens = Orthographic(low[0], high[0], low[1], high[1], near - 1.0, far, keep)
        else:
            angles = random.uniform(25.0, 155.0, 2)
            lens = Oblique(low[0], high[0], low[1], high[1], near - 1.0, far, keep, *angles)
        camera = Camera(tuple(eye), tuple(target), tuple(up))
        depth = list(DEPTH_RANGES)[number % 3]
        yield Projection(camera, lens, size, depth)  # type: ignore[arg-type]
