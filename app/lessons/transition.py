"""Move the model from one step's state to the next, so that the change is visible."""

import math
from dataclasses import fields, replace
from typing import Any

from app.document.document import Document
from app.model.projection import Camera, Lens, Orbit
from app.model.refusal import Refusal


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

    `part` goes from 0 to 1; words, switches and the view are the end's.
    """
    one, other = start.projection, end.projection
    try:
        projection = replace(
            other,
            camera=camera_between(one.camera, other.camera, part),
            lens=_lens_between(one.lens, other.lens, part),
            placement=one.placement.towards(other.placement, part),
        )
        settings = dict(end.settings)
        for name, value in settings.items():
            settings[name] = _mixed(start.settings.get(name), value, part)
        return replace(end, projection=projection, settings=settings)
    except Refusal:  # the straight path leads through an impossible state
        return None


def _mixed(one: Any, other: Any, part: float) -> Any:
    """Interpolate numbers and vectors; take everything else from the end."""
    if isinstance(one, float) and isinstance(other, float):
        return _number(one, other, part)
    if isinstance(one, tuple) and all(isinstance(each, float) for each in one):
        return tuple((1.0 - part) * a + part * b for a, b in zip(one, other, strict=True))
    return other


def _number(one: float, other: float, part: float) -> float:
    """Interpolate a number, geometrically if both ends are positive."""
    if one == other or not (math.isfinite(one) and math.isfinite(other)):
        return other
    if one > 0.0 and other > 0.0:
        return math.exp((1.0 - part) * math.log(one) + part * math.log(other))
    return (1.0 - part) * one + part * other


def _lens_between(one: Lens, other: Lens, part: float) -> Lens:
    names = [field.name for field in fields(other)]
    mixed = {name: _mixed(getattr(one, name), getattr(other, name), part) for name in names}
    return replace(other, **mixed)


def camera_between(one: Camera, other: Camera, part: float) -> Camera:
    """Return a camera between two, whose eye moves around its target along the shorter arc."""
    a, b = one.orbit, other.orbit
    turn, roll = (
        math.remainder(after - before, 360.0)
        for before, after in ((a.azimuth_deg, b.azimuth_deg), (a.roll_deg, b.roll_deg))
    )
    return Camera.from_orbit(
        _mixed(one.target, other.target, part),
        Orbit(
            a.azimuth_deg + part * turn,
            (1.0 - part) * a.elevation_deg + part * b.elevation_deg,
            _number(a.distance, b.distance, part),
            a.roll_deg + part * roll,
        ),
    )
