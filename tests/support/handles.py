"""Drags of handles by their grips."""

from typing import Any

from app.model.projection import Projection
from app.picking import handles
from app.picking.handles import Change, Handle, place


def dragged(
    projection: Projection, handle: Handle, drawn: tuple[float, float], *end: Any, **keys: Any
) -> Change:
    """The change when the grip itself is dragged."""
    return handles.dragged(
        projection, handle, place(projection, handle, drawn), drawn, *end, **keys
    )
