"""The sliders of the lens's rows, which reach as far as lens, scene and image require."""

import math
from collections.abc import Mapping

from PySide6.QtCore import QObject

from app.model.parameter import Parameter
from app.model.parameters import CX, CY, FAR, FX, FY, HALF_HEIGHT, HALF_WIDTH, NEAR, WINDOW_SIDES
from app.model.projection import LENSES, Projection
from widgets.controls.parameter_rows import Binding
from widgets.parts.number_rows import NumberRow
from widgets.parts.scales import Linear, Log, Scale

NEAR_RATIO = 40.0  # ratio of the ends of near's slider: a pixel of 240 changes near by at most 2 %


class LensSliders(QObject):
    """Fits the rows of the lenses, by their names, to the current lens."""

    def __init__(self, bindings: Mapping[str, Binding], parent: QObject) -> None:
        super().__init__(parent)
        self._bindings = bindings
        self._reach = 0.0
        self._scaled_for: dict[str, Scale] = {}
        self._scaled_to = 0, 0  # the image's size
        for side in WINDOW_SIDES:
            self._row(side).gesture_finished.connect(self._fit_window)

    def _row(self, parameter: Parameter) -> NumberRow:
        row = self._bindings[parameter.name].row
        assert isinstance(row, NumberRow)
        return row

    def fit(self, projection: Projection, size: float, defaults: Projection) -> None:
        """Set the sliders and the defaults of the rows of this lens; see `Controls.set_scene`."""
        self._projection, self._size = projection, size
        self._reach = 0.0
        kind = projection.lens.kind
        alike = defaults.with_lens(kind)
        if kind in LENSES:
            self._fit_planes(alike, size)
        for binding in self._bindings.values():
            if kind in binding.lenses:
                binding.row.setDefault(binding.parameter.value(alike))
        self.follow(projection)

    def _fit_planes(self, start: Projection, size: float) -> None:
        """Fit the sliders of near and far to the depth of the scene from its first camera.

        A pyramid's near covers only `NEAR_RATIO`: a pixel of the slider must not be a large step.
        """
        lens = start.lens
        back = start.camera.distance + size / 2.0
        if lens.even_extent:  # linear for a box, logarithmic for a pyramid
            reach = 1.5 * max(back, abs(lens.near), abs(lens.far))
            scales: tuple[Scale, Scale] = (Linear.about(0.0, reach), Linear.about(0.0, reach))
        else:
            least = min(max(back, 2.0 * lens.near) / NEAR_RATIO, lens.near / 2.0)
            least = float(f"{least:.2g}")
            far = back if math.isinf(lens.far) else lens.far
            farthest = max(20.0 * back, 4.0 * far)
            nearest = float(f"{min(back / 8.0, far / 2.0):.2g}")
            scales = (
                Log(least, NEAR_RATIO * least),
                Log(nearest, float(f"{farthest:.2g}"), infinite=True),
            )
        for plane, scale in zip((NEAR, FAR), scales, strict=True):
            self._row(plane).setScale(scale)

    def follow(self, projection: Projection) -> None:
        """Keep the sliders in proportion to a projection with the same kind of lens."""
        self._projection = projection
        self._fit_window()
        if projection.lens.planes is not None:
            near, far = projection.lens.planes
            rows = self._row(NEAR), self._row(FAR)
            rows[0].field.keep_between(None, far)
            rows[1].field.keep_between(near, None)
        if projection.lens.symmetric:
            near = 10.0 ** round(math.log10(projection.lens.near))
            scale = Log(1e-2 * near, 1e2 * near)
            self._set_scales({HALF_WIDTH: scale, HALF_HEIGHT: scale})
        if projection.lens.central and projection.image_size != self._scaled_to:
            self._scaled_to = width, height = projection.image_size
            focal = Log(1e-2 * max(width, height), 1e2 * max(width, height))
            centre_x = Linear.about((width - 1) / 2.0, 1.5 * width)
            centre_y = Linear.about((height - 1) / 2.0, 1.5 * height)
            self._set_scales({FX: focal, FY: focal, CX: centre_x, CY: centre_y})

    def _set_scales(self, scales: dict[Parameter, Scale]) -> None:
        for parameter, scale in scales.items():
            if self._scaled_for.get(parameter.name) != scale:
                self._scaled_for[parameter.name] = scale
                self._row(parameter).setScale(scale)

    def _fit_window(self) -> None:
        """Let the window's sliders reach twice as far as the window, or as the scene for a box.

        A slider does not change while it is dragged, or while the window fills a fair part of it.
        """
        lens = self._projection.lens
        if not lens.window_stays:
            return
        extent = max(abs(getattr(lens, side.name)) for side in WINDOW_SIDES)
        least = 2.0 * self._size if lens.even_extent else 0.0
        if extent <= self._reach and (self._reach <= least or extent >= 0.05 * self._reach):
            return
        if not all(self._row(side).at_rest for side in WINDOW_SIDES):
            return
        self._reach = max(2.0 * extent, least)
        for side in WINDOW_SIDES:
            self._row(side).setScale(Linear.about(0.0, self._reach))
