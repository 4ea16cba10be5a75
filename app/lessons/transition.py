"""Between two steps: the model moves from one state to the next, so that the change is seen."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any

from app.document.document import Document
from app.model.projection import Camera, Lens, ObjectTransform, Orbit, Projection, Vector
from app.model.refusal import Refusal
from app.scenes.phenomena.settings import Value


def can_move(start: Document, end: Document) -> bool:
    """Whether the model can move from one state to another: same scene, same kind of lens."""
    lenses = start.projection.lens, end.projection.lens
    return (
        (start.scene, start.mesh) == (end.scene, end.mesh)
        and start != end
        and lenses[0].kind == lenses[1].kind
        and all(document.projection.has_camera for document in (start, end))
    )


def between(start: Document, end: Document, part: float) -> Document | None:
    """Return a state between two for which `can_move` holds, or None if it is impossible.

    `part` goes from 0 to 1; words, switches and the view are those of the end.
    """
    one, other = start.projection, end.projection
    try:
        projection = Projection(
            _camera(one.camera, other.camera, part),
            _lens(one.lens, other.lens, part),
            other.image_size,
            other.depth,
            _placement(one.placement, other.placement, part),
        )
        settings = _settings(start.settings, end.settings, part)
        return replace(end, projection=projection, settings=settings)
    except Refusal:  # the straight way leads through what cannot be
        return None


def _number(one: float, other: float, part: float) -> float:
    """Interpolate a number; two positive ones in proportion."""
    if one == other or not (math.isfinite(one) and math.isfinite(other)):
        return other
    if one > 0.0 and other > 0.0:
        return math.exp((1.0 - part) * math.log(one) + part * math.log(other))
    return (1.0 - part) * one + part * other


def _vector(one: Vector, other: Vector, part: float) -> Vector:
    x, y, z = ((1.0 - part) * a + part * b for a, b in zip(one, other, strict=True))
    return x, y, z


def _camera(one: Camera, other: Camera, part: float) -> Camera:
    """Move the eye around its target, the shorter way."""
    a, b = one.orbit, other.orbit
    turn, roll = (
        math.remainder(after - before, 360.0)
        for before, after in ((a.azimuth_deg, b.azimuth_deg), (a.roll_deg, b.roll_deg))
    )
    return Camera.from_orbit(
        _vector(one.target, other.target, part),
        Orbit(
            a.azimuth_deg + part * turn,
            (1.0 - part) * a.elevation_deg + part * b.elevation_deg,
            _number(a.distance, b.distance, part),
            a.roll_deg + part * roll,
        ),
    )


def _lens(one: Lens, other: Lens, part: float) -> Lens:
    changed: dict[str, Any] = {}
    for field in fields(other):
        values = getattr(one, field.name), getattr(other, field.name)
        if all(isinstance(value, float) for value in values):
            changed[field.name] = _number(*values, part)
    return replace(other, **changed)


def _placement(one: ObjectTransform, other: ObjectTransform, part: float) -> ObjectTransform:
    return ObjectTransform(
        _vector(one.translate, other.translate, part),
        _vector(one.rotate_deg, other.rotate_deg, part),
        _vector(one.scale, other.scale, part),
        other.order,
    )


def _settings(
    one: Mapping[str, Value], other: Mapping[str, Value], part: float
) -> dict[str, Value]:
    found = dict(other)
    for name, value in other.items():
        before = one.get(name)
        if isinstance(value, tuple) and isinstance(before, tuple):
            found[name] = _vector(before, value, part)
        elif type(value) is float and type(before) is float:
            found[name] = _number(before, value, part)
    return found
