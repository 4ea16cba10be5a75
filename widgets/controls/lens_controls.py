"""The rows of the lens: every number that can define it, the most used ones first.

Field of view, focal lengths and the window on the near plane are views of one value. So are the
angles and the receding of an oblique lens, and a perspective lens and its K.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from operator import attrgetter
from typing import Any, NamedTuple

from PySide6.QtCore import QObject

from app.lecture.kinds import leaning
from app.model.projection import (
    AT_LEAST,
    AT_MOST,
    LARGEST_SHEAR,
    LENSES,
    OBLIQUE_PRESETS,
    FreeMatrix,
    Projection,
    focal_length_35mm,
    focal_length_e,
    fov_x_from_fov_y,
    fov_y_from_focal_length_35mm,
    fov_y_from_focal_length_e,
    fov_y_from_window,
    oblique_angles,
    receding_of,
)
from app.model.refusal import Refusal
from widgets.parts.fields import Option
from widgets.parts.messages import translated
from widgets.parts.number_rows import NumberRow
from widgets.parts.scales import Linear, Log, Scale
from widgets.parts.section import Binding, Read, Rows, TypedMemory, Write, quiet, tidy

NEAR_RATIO = 40.0
"""Ratio of the ends of near's slider: a pixel of 240 changes near by at most 2 %."""
SIDES = ("left", "right", "bottom", "top")
_SAME_ANGLE_DEG = 1e-9  # rounding error of a preset's angle in a file


class Receding(NamedTuple):
    """Length and direction in which an oblique lens draws depth; see `oblique_angles`."""

    receding: float
    receding_deg: float


class LensControls(QObject):
    """Fills two parts of the dock with the rows of all lenses, and fits them to the current lens.

    Parameters
    ----------
    front, more : Rows
        For the usual rows of a lens, and for all others.
    """

    def __init__(self, front: Rows, more: Rows) -> None:
        super().__init__(front)
        self._front, self._more = front, more
        self._make_kind()
        self._make_field_of_view()
        self._make_leaning()
        self._make_window()
        self._make_planes()
        self._make_other_measures()
        self._make_camera_matrix()
        self._reach = 0.0
        self._scaled_for: dict[str, Any] = {}
        for key in SIDES:
            self._row(key).gesture_finished.connect(self._fit_window)

    # -- the rows

    def _make_kind(self) -> None:
        lenses = (*LENSES.values(), FreeMatrix)
        kinds = [
            Option(lens.kind, translated(lens.title, "Lens"), translated(lens.tip, "Lens"))
            for lens in lenses
        ]
        kind = self._front.add_choice(
            "kind", "lens",
            self.tr("Kind of projection. Objects at the target keep their size when it changes."),
            kinds, _field("kind"), lambda p, kind: p.with_lens(kind),
        )  # fmt: skip
        quiet(kind.name_label)

    def _make_field_of_view(self) -> None:
        symmetric = _kinds(lambda lens: lens.symmetric)
        fov_y = self._add_declared("fov_y_deg")
        fov_x = self._more.add_number(
            "fov_x_deg", "lens",
            self.tr("Angle between the left and the right of the frustum, as seen from the eye:"
                    " the vertical field of view and the aspect in one number."),
            Linear(1.0, 179.0, 0.5), "°", self.tr("degrees"), _fov_x, Projection.with_fov_x,
            lenses=symmetric,
        )  # fmt: skip
        for row in (fov_y, fov_x):
            row.field.below = 180.0
        self._more.add_number(
            "focal_length_mm", "lens",
            self.tr("Focal length of a 35 mm film camera (36 × 24 mm) with the same diagonal"
                    " field of view: below 35 is wide angle, above 70 telephoto."),
            Log(5.0, 500.0), self.tr("mm"), self.tr("millimetres"),
            *_by_fov(focal_length_35mm, fov_y_from_focal_length_35mm), lenses=symmetric,
        )  # fmt: skip

    def _make_leaning(self) -> None:
        oblique = _with("alpha_deg")
        drawings = {
            "cavalier": (self.tr("cavalier, {0}°"), self.tr("Depth is drawn at full length")),
            "cabinet": (self.tr("cabinet, {0}°"), self.tr("Depth is drawn at half its length")),
        }
        choices = []
        for key in OBLIQUE_PRESETS:
            drawing, _, angle = key.partition("-")
            text, tip = drawings[drawing]
            rising = self.tr("{0}, rising at {1}°.").format(tip, angle)
            choices.append(Option(key, text.format(angle), rising))
        self._front.add_choice(
            "preset", "lens",
            self.tr("The standard drawings of textbooks. The target stays in its place in the"
                    " picture."),
            choices, _preset, _with_preset, none=self.tr("free"), lenses=oblique,
        )  # fmt: skip
        degrees = self.tr("degrees")
        receding = TypedMemory(_angles, lambda p: Receding(*receding_of(p.lens)), _with_receding)
        self._front.add_number(
            "receding", "lens",
            self.tr("Drawn length of a line perpendicular to the picture, relative to its true"
                    " length: 1 is a cavalier, 0.5 a cabinet drawing, 0 orthographic. The target"
                    " stays in its place in the picture."),
            Linear(0.0, 2.0, 0.01), self.tr("×"), self.tr("times the true length"),
            *receding.access("receding"), lenses=oblique,
        )  # fmt: skip
        self._front.add_number(
            "receding_deg", "lens",
            self.tr("Direction in which depth is drawn, anticlockwise from the right. The target"
                    " stays in its place in the picture."),
            Linear(-180.0, 180.0, 1.0), "°", degrees,
            *receding.access("receding_deg"), lenses=oblique,
        )  # fmt: skip

    def _add_declared(self, field: str) -> NumberRow:
        """Add the row of a field whose control the lens declares itself."""
        control = next(lens.controls[field] for lens in LENSES.values() if field in lens.controls)
        units = {"°": self.tr("degrees"), "×": self.tr("times")}
        part = self._front if field == "fov_y_deg" else self._more
        return part.add_number(
            field, "lens", translated(control.tip, "Lens"),
            Linear(control.low, control.high, control.step), control.unit, units[control.unit],
            _field(field), _with_field(field), lenses=_with(field),
        )  # fmt: skip

    def _make_window(self) -> None:
        sides = {
            "left": self.tr("Left edge of the picture's window on the near plane: where the view"
                            " volume begins in x of view space."),
            "right": self.tr("Right edge of the picture's window on the near plane: where the view"
                             " volume ends in x of view space."),
            "bottom": self.tr("Bottom edge of the picture's window on the near plane: where the"
                              " view volume begins in y of view space."),
            "top": self.tr("Top edge of the picture's window on the near plane: where the view"
                           " volume ends in y of view space."),
        }  # fmt: skip
        windowed = _with("left")
        for side, tip in sides.items():
            self._front.add_length(side, tip, _field(side), _with_field(side), lenses=windowed)
        keeps = (
            Option("stretch", self.tr("stretch"),
                   self.tr("The window fills the image; circles may become ellipses.")),
            Option("x", self.tr("keep x, fit y"),
                   self.tr("The y range grows or shrinks about its centre (lecture 000,"
                           " variant X).")),
            Option("y", self.tr("keep y, fit x"),
                   self.tr("The x range grows or shrinks about its centre (lecture 000,"
                           " variant Y).")),
        )  # fmt: skip
        self._more.add_choice(
            "keep", "lens", self.tr("How the window follows the aspect of the image."),
            keeps, _field("keep"), _with_field("keep"), lenses=windowed,
        )  # fmt: skip

    def _make_planes(self) -> None:
        self._front.add_length(
            "near",
            self.tr("Distance from the eye to the near plane: nothing nearer is drawn. The closer"
                    " to 0, the coarser the depth buffer."),
            _field("near"), _with_field("near"), lenses=tuple(LENSES),
        )  # fmt: skip
        self._front.add_length(
            "far",
            self.tr("Distance from the eye to the far plane: nothing farther is drawn. A"
                    " perspective lens also takes inf (∞), at the slider's end."),
            _field("far"), _with_field("far"), lenses=tuple(LENSES),
        )  # fmt: skip

    def _make_other_measures(self) -> None:
        """Add the lectures' other measures of a field of view."""
        for field in dict.fromkeys(field for lens in LENSES.values() for field in lens.controls):
            if field not in self._front.bindings:
                self._add_declared(field)
        symmetric = _kinds(lambda lens: lens.symmetric)
        self._more.add_number(
            "e", "lens",
            self.tr("Lecture 003's focal length e = 1/tan(fov/2), with the horizontal fov: at this"
                    " distance the picture reaches from x = −1 to 1."),
            Log(1e-2, 1e2), self.tr("units"), self.tr("world units"),
            *_by_fov(focal_length_e, fov_y_from_focal_length_e), lenses=symmetric,
        )  # fmt: skip
        halves = {
            "window_right": self.tr("Half the width of the picture on the near plane: glFrustum's"
                                    " right, and −left. With near it sets the field of view."),
            "window_top": self.tr("Half the height of the picture on the near plane: glFrustum's"
                                  " top, and −bottom. With near it sets the field of view."),
        }  # fmt: skip
        for key, tip in halves.items():
            self._more.add_length(
                key, tip, partial(_half, key), partial(_with_half, key), lenses=symmetric
            )

    def _make_camera_matrix(self) -> None:
        tips = {
            "fx": self.tr("Focal length in pixel widths: K's first diagonal entry."),
            "fy": self.tr("Focal length in pixel heights: K's second diagonal entry. Equal to fx"
                          " if the pixels are square."),
            "cx": self.tr("Principal point, to the right from the centre of the first pixel. At "
            "the image's centre the lens is symmetric, elsewhere off-axis."),
            "cy": self.tr("Principal point, downwards from the centre of the first pixel. At "
            "the image's centre the lens is symmetric, elsewhere off-axis."),
        }  # fmt: skip
        typed = TypedMemory(
            lambda p: (p.lens, p.image_size), lambda p: p.intrinsics, Projection.with_intrinsics
        )
        self._more.add_title(self.tr("Calibrated camera (OpenCV K)"))
        for key, tip in tips.items():
            self._more.add_number(
                key, "lens", tip, Log(1.0, 10.0), self.tr("px"), self.tr("pixels"),
                *typed.access(key), lenses=_kinds(lambda lens: lens.central),
            )  # fmt: skip

    def _row(self, key: str) -> NumberRow:
        part = self._front if key in self._front.bindings else self._more
        row = part.bindings[key].row
        assert isinstance(row, NumberRow)
        return row

    # -- fitted to the current lens

    def fit(self, projection: Projection, size: float, defaults: Projection) -> None:
        """Set the sliders and the defaults of the rows of this kind of lens.

        Parameters
        ----------
        projection : Projection
        size : float
            Diagonal of the scene's bounds, world units.
        defaults : Projection
            The camera and lens with which the scene opens.
        """
        self._projection, self._size = projection, size
        self._reach = 0.0
        kind = projection.lens.kind
        alike = defaults.with_lens(kind)
        if kind in LENSES:
            self._fit_planes(alike, size)
        for key, binding in self._bindings:
            if not binding.lenses or kind in binding.lenses:
                source = defaults if key == "kind" else alike
                binding.row.setDefault(binding.read(source))
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
        for name, scale in zip(("near", "far"), scales, strict=True):
            self._row(name).setScale(scale)

    @property
    def _bindings(self) -> list[tuple[str, Binding]]:
        return [*self._front.bindings.items(), *self._more.bindings.items()]

    def follow(self, projection: Projection) -> None:
        """Keep the sliders in proportion to a projection with the same kind of lens."""
        self._projection = projection
        if projection.lens.planes is not None:
            near, far = projection.lens.planes
            self._row("near").field.keep_between(None, far)
            self._row("far").field.keep_between(near, None)
        self._fit_window()
        if projection.lens.symmetric:
            near = 10.0 ** round(math.log10(projection.lens.near))
            scale = Log(1e-2 * near, 1e2 * near)
            self._set_scales(dict.fromkeys(("window_right", "window_top"), scale))
        if projection.lens.central:
            width, height = projection.image_size
            focal = Log(1e-2 * max(width, height), 1e2 * max(width, height))
            self._set_scales(
                {
                    "fx": focal,
                    "fy": focal,
                    "cx": Linear.about((width - 1) / 2.0, 1.5 * width),
                    "cy": Linear.about((height - 1) / 2.0, 1.5 * height),
                }
            )

    def _set_scales(self, scales: dict[str, Scale]) -> None:
        for key, scale in scales.items():
            if self._scaled_for.get(key) != scale:
                self._scaled_for[key] = scale
                self._row(key).setScale(scale)

    def _fit_window(self) -> None:
        """Let the window's sliders reach twice as far as the window, or as the scene for a box.

        A slider does not change while it is dragged, or while the window fills a fair part of it.
        """
        lens = self._projection.lens
        if not lens.window_stays:
            return
        extent = max(abs(getattr(lens, side)) for side in SIDES)
        least = 2.0 * self._size if lens.even_extent else 0.0
        if extent <= self._reach and (self._reach <= least or extent >= 0.05 * self._reach):
            return
        if not all(self._row(side).at_rest for side in SIDES):
            return
        self._reach = max(2.0 * extent, least)
        for side in SIDES:
            self._row(side).setScale(Linear.about(0.0, self._reach))


# --------------------------------------------------------------------------- reading and writing


def _kinds(has: Callable[[Any], bool]) -> tuple[str, ...]:
    return tuple(kind for kind, lens in LENSES.items() if has(lens))


def _with(field: str) -> tuple[str, ...]:
    """Return the kinds of lens that have a field."""
    return _kinds(lambda lens: field in lens.__dataclass_fields__)


def _field(field: str) -> Read:
    return attrgetter(f"lens.{field}")


def _with_field(field: str) -> Write:
    def write(projection: Projection, value: Any) -> Projection:
        return replace(projection, lens=projection.lens.replaced(**{field: value}))

    return write


def _fov_y(projection: Projection) -> float:
    fov_y_deg = projection.lens.fov_y_deg
    assert fov_y_deg is not None  # only such lenses have the row
    return fov_y_deg


def _with_fov_y(projection: Projection, fov_y_deg: float) -> Projection:
    return replace(projection, lens=projection.lens.replaced(fov_y_deg=fov_y_deg))


def _by_fov(
    measure: Callable[[float, float], float], fov_y: Callable[[float, float], float]
) -> tuple[Read, Write]:
    """Return functions that read and write another measure of the field of view."""

    def read(projection: Projection) -> float:
        return tidy(measure(_fov_y(projection), projection.aspect))

    def write(projection: Projection, value: float) -> Projection:
        return _with_fov_y(projection, fov_y(value, projection.aspect))

    return read, write


def _fov_x(projection: Projection) -> float:
    fov_x_deg = fov_x_from_fov_y(_fov_y(projection), projection.aspect)
    tidy_deg = tidy(fov_x_deg)
    return tidy_deg if tidy_deg < 180.0 else fov_x_deg


def _half(key: str, projection: Projection) -> float:
    _, right, _, top = projection.window
    return tidy(right if key == "window_right" else top)


def _with_half(key: str, projection: Projection, half: float) -> Projection:
    top = half / projection.aspect if key == "window_right" else half
    try:
        fov_y_deg = fov_y_from_window(top, projection.lens.near)
    except Refusal as error:  # its field is top
        raise Refusal(key, half, error.bound, *error.limits) from None
    return _with_fov_y(projection, fov_y_deg)


def _angles(projection: Projection) -> tuple[float, float]:
    lens: Any = projection.lens
    return lens.alpha_deg, lens.beta_deg


def _with_receding(projection: Projection, receding: Receding) -> Projection:
    if abs(receding.receding) > LARGEST_SHEAR and math.isfinite(receding.receding):
        bound, limit = (
            (AT_MOST, LARGEST_SHEAR) if receding.receding > 0.0 else (AT_LEAST, -LARGEST_SHEAR)
        )
        raise Refusal("receding", receding.receding, bound, limit)
    return leaning(projection, *oblique_angles(*receding))


def _preset(projection: Projection) -> str | None:
    angles = _angles(projection)
    for key, preset in OBLIQUE_PRESETS.items():
        if max(abs(a - b) for a, b in zip(angles, preset, strict=True)) <= _SAME_ANGLE_DEG:
            return key
    return None


def _with_preset(projection: Projection, key: str) -> Projection:
    return leaning(projection, *OBLIQUE_PRESETS[key])
