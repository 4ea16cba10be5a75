"""From a pixel and its depth to the world at 80 digits: the ray through it, at its distance."""

from collections.abc import Sequence
from typing import Any

from app.model.projection import Projection
from tests.oracles.exact import Exact, cotangent_deg, mp, vector


def unprojected(projection: Projection, pixel: Sequence[float]) -> list[Any]:
    """The offset from the eye, x, y, z along the world's axes.

    1/w runs evenly over the depth range, or w with parallel projectors; nothing is inverted.
    """
    lens: Any = projection.lens
    exact = Exact(projection)
    left, right, bottom, top = exact.window()
    right_px, down_px, depth = vector(pixel)
    part = 1 - depth if projection.depth == "reversed" else depth
    near, far = mp.mpf(lens.near), mp.mpf(lens.far)
    x = left + (right - left) * right_px / exact.width
    y = top - (top - bottom) * down_px / exact.height
    if lens.parallel:
        w = near + part * (far - near)
        x += (w - near) * cotangent_deg(getattr(lens, "alpha_deg", 90))
        y += (w - near) * cotangent_deg(getattr(lens, "beta_deg", 90))
    else:
        w = 1 / ((1 - part) / near + (0 if mp.isinf(far) else part / far))
        x, y = x * w / near, y * w / near
    u, v, n = exact.frame
    return [x * a + y * b - w * c for a, b, c in zip(u, v, n, strict=True)]
