"""The rows of the camera, the image, the depth range and the object."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from PySide6.QtCore import QObject

from app.model.projection import Camera, Orbit, Projection
from widgets.parts.fields import Option
from widgets.parts.messages import field_name
from widgets.parts.plain import PlainLabel
from widgets.parts.scales import Linear, Log, Scale
from widgets.parts.section import Of, Rows, TypedMemory

ASPECTS = {"1:1": (1, 1), "4:3": (4, 3), "16:9": (16, 9)}
_NOT_YET = Linear(-1.0, 1.0, 0.01)
"""Scale of a length until a scene defines it."""


class CameraControls(QObject):
    """Fills the parts of the dock that do not concern the lens."""

    def __init__(self, front: Rows, more: Rows, image: Rows, placement: Rows) -> None:
        super().__init__(front)
        self._lengths = self.tr("units"), self.tr("world units")
        self._make_camera(front, more)
        self._make_image(image)
        self.fixed = PlainLabel(
            self.tr(
                "The objects of this scene are fixed, because its numbers depend on them. You can"
                " move those of the letter F, the cube, the posts and any mesh."
            ),
            wordWrap=True,
        )
        placement.add(self.fixed)
        self._make_object(placement)

    def _make_camera(self, front: Rows, more: Rows) -> None:
        angle = "°", self.tr("degrees")
        round_deg, height_deg = Linear(-180.0, 180.0, 1.0), Linear(-90.0, 90.0, 1.0)
        orbit: tuple[tuple[Rows, str, Scale, tuple[str, str], str], ...] = (
            (front, "azimuth_deg", round_deg, angle,
             self.tr("Walks round the target: 0 is on its +z side, 90 on its +x side.")),
            (front, "elevation_deg", height_deg, angle,
             self.tr("Height above the target's horizon as an angle: 90 looks straight down.")),
            (front, "distance", Log(1.0, 10.0), self._lengths,
             self.tr("Distance from the target to the eye.")),
            (more, "roll_deg", round_deg, angle,
             self.tr("Turns the camera about its view direction; clockwise as the photographer"
                     " sees it.")),
        )  # fmt: skip
        typed = TypedMemory(lambda p: p.camera, lambda p: p.camera.orbit, _with_orbit)
        for part, name, scale, unit, tip in orbit:
            shown, said = unit
            part.add_number(name, "camera", tip, scale, shown, said, *typed.access(name))
        for vector, unit, tip in (
            ("eye", self._lengths, self.tr("The centre of projection, in world coordinates.")),
            ("target", self._lengths,
             self.tr("The point that the camera looks at, in world coordinates.")),
            ("up", ("", ""),
             self.tr("The direction that is vertical in the picture (the lectures'"
                     " view-up vector); its length does not matter.")),
        ):  # fmt: skip
            self._add_vector(more, "camera", vector, tip, _NOT_YET, unit)

    def _make_object(self, placement: Rows) -> None:
        for vector, scale, unit, tip in (
            ("translate", _NOT_YET, self._lengths,
             self.tr("Moves the object: the last column of world ← object.")),
            ("rotate_deg", Linear(-180.0, 180.0, 1.0), (self.tr("°"), self.tr("degrees")),
             self.tr("Turns the object about the fixed axes: first x, then y, then z.")),
            ("scale", Linear(-3.0, 3.0, 0.01), (self.tr("×"), self.tr("times")),
             self.tr("Stretches the object along its own axes: 0 flattens it, −1 mirrors it.")),
        ):  # fmt: skip
            self._add_vector(placement, "placement", vector, tip, scale, unit)
        choices = (
            Option("trs", self.tr("T R S"), self.tr("Scaled and turned where it is, then moved.")),
            Option("rts", self.tr("R T S"),
                   self.tr("Scaled and moved, then turned about the world's origin.")),
        )  # fmt: skip
        placement.add_choice(
            "order", "placement",
            self.tr("Which factor is applied first (the rightmost, for column vectors)."),
            choices, lambda p: p.placement.order,
            lambda p, order: replace(p, placement=replace(p.placement, order=order)),
            buttons=True,
        )  # fmt: skip

    def _add_vector(
        self, rows: Rows, part: Of, vector: str, tip: str, scale: Scale, unit: tuple[str, str]
    ) -> None:
        """Add a row for each component of a vector, with its unit and the unit's explanation."""
        for axis, letter in enumerate("xyz"):
            rows.add_number(
                f"{vector}_{letter}", part, tip, scale, *unit,
                partial(_read_component, part, vector, axis),
                partial(_write_component, part, vector, axis),
                name=self.tr("{0} {1}").format(field_name(vector), letter), field=vector,
            )  # fmt: skip

    def _make_image(self, image: Rows) -> None:
        sides: Mapping[str, str] = {
            "width": self.tr("Width of the picture in pixels."),
            "height": self.tr("Height of the picture in pixels."),
        }
        for axis, (name, tip) in enumerate(sides.items()):
            image.add_number(
                name, "image_size", tip, Linear(10.0, 4000.0, 10.0),
                self.tr("px"), self.tr("pixels"),
                partial(_side, axis), partial(_with_side, axis),
            )  # fmt: skip
        tip = self.tr("Width becomes {0}/{1} of the height, in whole pixels.")
        aspects = [Option(text, text, tip.format(*ratio)) for text, ratio in ASPECTS.items()]
        image.add_choice(
            "aspect", "image_size",
            self.tr("Width over height. The height stays, and with it the vertical field of view:"
                    " the picture gains or loses at its sides."),
            aspects, _aspect, _with_aspect, buttons=True, name=self.tr("Aspect"),
        )  # fmt: skip
        ranges = (
            Option("opengl", self.tr("OpenGL: −1 to 1"), self.tr("Near goes to −1, far to 1.")),
            Option("direct3d", self.tr("Direct3D: 0 to 1"), self.tr("Near goes to 0, far to 1.")),
            Option("reversed", self.tr("reversed: 1 to 0"),
                   self.tr("Near goes to 1, far to 0: floats are densest where depth needs them.")),
        )  # fmt: skip
        image.add_choice(
            "depth", "depth",
            self.tr("The z of the near and the far plane in the NDC cube."),
            ranges, lambda p: p.depth, lambda p, depth: p.with_depth(depth),
            name=self.tr("NDC z"),
        )  # fmt: skip


def _with_orbit(projection: Projection, orbit: Orbit) -> Projection:
    return replace(projection, camera=Camera.from_orbit(projection.camera.target, orbit))


def _read_component(part: Of, vector: str, axis: int, projection: Projection) -> float:
    return float(getattr(getattr(projection, part), vector)[axis])


def _write_component(
    part: Of, vector: str, axis: int, projection: Projection, value: float
) -> Projection:
    whole: Any = getattr(projection, part)
    components = list(getattr(whole, vector))
    components[axis] = value
    return replace(projection, **{part: replace(whole, **{vector: tuple(components)})})


def _side(axis: int, projection: Projection) -> int:
    return projection.image_size[axis]


def _with_side(axis: int, projection: Projection, side_px: float) -> Projection:
    size: list[Any] = list(projection.image_size)
    size[axis] = int(side_px) if float(side_px).is_integer() else side_px
    return replace(projection, image_size=tuple(size))


def _aspect(projection: Projection) -> str | None:
    width, height = projection.image_size
    for text, (across, down) in ASPECTS.items():
        if width == round(height * across / down):
            return text
    return None


def _with_aspect(projection: Projection, text: str) -> Projection:
    across, down = ASPECTS[text]
    height = projection.image_size[1]
    width = max(1, round(height * across / down))
    return replace(projection, image_size=(width, height))
