"""Trade 8, cracks: bytes a vertex against the gap of a seam, at the target, in px.

The seam of the scene `app.scenes.phenomena.cracks` faces the camera at the target's distance. Its
two meshes are as wide as in that scene, and quantised each in its own box, or in a common one.
"""

import numpy as np

from app.measure.results import ChartPoint, Trade
from app.model.projection import Array, Projection
from app.scenes.phenomena.cracks import ROUNDED_UP, SIZES, grids, meshes

BITS = (8, 12, 16)
GRIDS = {"own": "own boxes", "common": "common grid"}


def gap_px(both: Array, bits: int, common: bool, scale: Array) -> tuple[float, float, float]:
    """Return the largest gap, its bound, and how far a vertex moves, in px.

    `both` are as of `meshes`, and `scale` (2,) the px of a unit along x and y.
    """
    each = grids(both, bits, common)
    kept = [grid.rounded(mesh[1])[:, :2] * scale for grid, mesh in zip(each, both, strict=True)]
    moved = np.linalg.norm(kept - both[:, 1, :, :2] * scale, axis=2).max()
    half = 0.0 if common else (each[0].step + each[1].step) / 2.0
    bound = ROUNDED_UP * half * float(np.hypot(*scale))
    return float(np.hypot(*(kept[0] - kept[1]).T).max()), bound, float(moved)


def measure(projection: Projection) -> Trade:
    lens, distance = projection.lens, projection.camera.distance
    left, right, bottom, top = lens.window_at(projection.window, distance)
    scale = np.array(projection.image_size) / (right - left, top - bottom)
    choices = []
    for grid, name in GRIDS.items():
        for bits in BITS:
            gap, bound, moved = gap_px(meshes(SIZES), bits, grid == "common", scale)
            size = 3.0 * bits / 8.0
            choices.append(
                ChartPoint(
                    f"{bits} bits, {name}", size, size, gap, bound, {"moved_px": moved},
                    use={"scene": "cracks", "settings.bits": str(bits), "settings.grid": grid},
                    bytes=size,
                )
            )  # fmt: skip
    return Trade("cracks", "B", "px", tuple(choices), 1)
