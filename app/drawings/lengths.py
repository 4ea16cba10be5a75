"""What a flat view of the world measures, and with which letters."""

import math
from fractions import Fraction
from typing import NamedTuple

from app.drawings.layer import PaneState
from app.model.projection import Projection
from app.scenes.phenomena.marks import Length

_SAME = 1e-9  # of a window's side: an axis this near to its middle halves it


class Half(NamedTuple):
    """Half a window, from the axis to its top or its right."""

    angle_deg: float | None  # at the eye; None without an eye, or off the axis
    has_eye: bool = True


def half_of(projection: Projection, axis: int) -> Half | None:
    """Return the right (axis 0) or upper (axis 1) half of a window; None for a typed matrix."""
    lens = projection.lens
    if lens.planes is None:
        return None
    if not lens.central:
        return Half(None, has_eye=False)
    angles = lens.angles(Fraction(*projection.image_size)) if lens.symmetric else None
    if angles is not None:
        return Half(angles[axis] / 2.0)
    low, high = projection.window[2 * axis : 2 * axis + 2]
    is_halved = abs(low + high) <= _SAME * (high - low)
    return Half(math.degrees(math.atan(high / lens.near)) if is_halved else None)


def distances(state: PaneState, view: str) -> list[tuple[str, float]]:
    """The named distances along the axis that a flat view measures, short ones first."""
    projection, measured = state.projection, dict[str, float]()
    if view not in ("side", "top"):
        return []
    if projection.has_camera:
        shown = () if state.illustration is None else state.illustration.measured
        measured = {"d": projection.camera.distance, **dict(shown)}
        half = half_of(projection, 1 if view == "side" else 0)
        is_asked = state.names.wants("e") and not state.names.all
        if is_asked and half is not None and half.angle_deg is not None:
            measured["e"] = 1.0 / math.tan(math.radians(half.angle_deg))
    named = [each for each in measured.items() if each[0] in state.names]
    return sorted(named, key=lambda each: abs(each[1]))


def lengths(state: PaneState, view: str) -> list[Length]:
    """The lengths across the axis in the present view, named or not."""
    shown = () if state.illustration is None else state.illustration.lengths
    return [length for length in shown if length.view == view]


def has_interval(state: PaneState, view: str) -> bool:
    is_there = view == "axis" and state.projection.lens.planes is not None
    return is_there and state.names.wants("interval") and not state.names.all


def written(state: PaneState, view: str) -> frozenset[str]:
    """The names that lengths write, and nobody else has to."""
    if has_interval(state, view):
        return frozenset("lr")
    across = {length.name for length in lengths(state, view) if length.name in state.names}
    return frozenset(across | {name for name, _ in distances(state, view)})
