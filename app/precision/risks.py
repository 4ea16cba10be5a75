"""The sentences of the health line: risks of the present numbers."""

import math
from collections.abc import Mapping
from itertools import product
from typing import NamedTuple

from app.model.depth import DepthBuffer
from app.model.projection import PLANES, Projection, Vector
from app.model.refusal import HEALTH, REFUSALS, Refusal, format_value
from app.precision.levels import Precision, Prediction, precision_for_reading, rounded_up

_GAP = 1e-3  # of the scene's size: surfaces closer together than this are drawn
_SEEN_PX = 0.5  # an error that changes another pixel
_LARGEST_VTK_FOV_DEG, _SMALLEST_VTK_FOV_DEG = 179.0, 1e-8
_VTK_DROPS_FROM = 1e6  # ratio of extent to near: the warning comes before the effect


class Risk(NamedTuple):
    """One sentence: a template and the figures in it."""

    template: str
    figures: tuple[str, ...] = ()

    def __str__(self) -> str:
        return f"{self.template.format(*self.figures)}."


def _why_no_frustum(projection: Projection) -> str:
    try:
        projection.world_from_clip_at(projection.camera.eye)
    except Refusal as error:
        return (
            HEALTH["no-inverse"]
            if error.bound == REFUSALS["invertible"]
            else HEALTH["large-inverse"]
        )
    return HEALTH["reaches-infinity"]


def risks(
    projection: Projection,
    lower: Vector,
    upper: Vector,
    drawn: Precision,
    drawing_px: float,
    predictions: Mapping[Precision, Prediction] | None,
) -> list[Risk]:
    """Return the risks of the present numbers, worst first.

    `lower` and `upper` bound the scene's objects, in object coordinates, and `drawn` is the
    precision of the panes. `drawing_px` is the largest of `levels.drawing_bounds_px`; the
    predictions are those of `levels.predict` for the scene's vertices.
    """
    present = []
    size = math.dist(lower, upper)
    corners = list(product(*zip(lower, upper, strict=True)))
    beyond = projection.trace(corners, "object").outside.all(axis=0)
    if beyond.any():
        present.append(Risk(HEALTH["no-picture"], (PLANES[beyond.argmax()],)))
    lens, distance = projection.lens, projection.camera.distance
    if lens.holds(distance):
        gap = float(DepthBuffer("fixed24", projection.depth, lens).gap(distance))
        if gap > _GAP * size:
            present.append(
                Risk(HEALTH["wide-gap"], (format_value(rounded_up(gap, 2)),))
                if gap < math.inf
                else Risk(HEALTH["no-gap"])
            )
    if drawn != "float32" and drawing_px >= _SEEN_PX:
        rough = Risk(HEALTH["rough-drawing"], (format_value(rounded_up(drawing_px, 2)),))
        present.append(rough if drawing_px < math.inf else Risk(HEALTH["no-float32"]))
    if predictions is not None and precision_for_reading(predictions) == "exact":
        present.append(Risk(HEALTH["few-digits"], tuple(map(_decimals, predictions["float64"]))))
    if lens.fov_y_deg is not None:
        if lens.fov_y_deg > _LARGEST_VTK_FOV_DEG:
            present.append(Risk(HEALTH["vtk-clamps"], (f"{_LARGEST_VTK_FOV_DEG:g}",)))
        elif lens.fov_y_deg < _SMALLEST_VTK_FOV_DEG:
            present.append(Risk(HEALTH["vtk-clamps"], (f"{_SMALLEST_VTK_FOV_DEG:g}",)))
    if not projection.frustum_sign:
        present.append(Risk(_why_no_frustum(projection)))
    if size / lens.eye_room >= _VTK_DROPS_FROM:
        present.append(Risk(HEALTH["vtk-drops"], (f"{size / lens.eye_room:.2g}",)))
    return present


def _decimals(error: float) -> str:
    return "0" if error == math.inf else str(max(0, math.floor(-math.log10(2.0 * error))))
