"""Drags of handles by their grips."""

from __future__ import annotations

from app.model.projection import Projection
from app.picking import handles
from app.picking.handles import Change, Handle, Spot, place
from app.picking.sight import Sight


def dragged(
    projection: Projection,
    handle: Handle,
    drawn: tuple[float, float],
    sight: Sight,
    pixel: Spot,
    *,
    shift: bool = False,
) -> Change:
    """The change when the grip itself is dragged."""
    grabbed = place(projection, handle, drawn)
    return handles.dragged(projection, handle, grabbed, drawn, sight, pixel, shift=shift)
