"""The phenomena that the lectures name, each one a scene with a readout; numpy only.

`exhibit` says what a phenomenon is made of; each of the other modules holds one. `PHENOMENA` has
them in lecture order.
"""

from __future__ import annotations

from types import MappingProxyType

from app.phenomena import depth_buffer, interpolation, popping, similar_triangles
from app.phenomena.exhibit import Phenomenon

PHENOMENA = MappingProxyType(
    {
        phenomenon.name: phenomenon
        for phenomenon in (
            similar_triangles.PHENOMENON,
            depth_buffer.PHENOMENON,
            interpolation.PHENOMENON,
            popping.PHENOMENON,
        )
    }
)
"""Every phenomenon by its scene's name, in the order of the lectures."""

__all__ = ["PHENOMENA", "Phenomenon"]
