"""The phenomena that the lectures name, each one a scene with a readout; numpy only.

`illustration` says what a phenomenon is made of: `settings` that are chosen, a `readout` that is
read, `marks` that are drawn, a `diagram` beside them; `picture` how marks come into the image pane.
Each of the other modules holds one phenomenon. `PHENOMENA` has them in lecture order.
"""

from __future__ import annotations

from types import MappingProxyType

from app.scenes.phenomena import (
    affine_depth,
    camera_obscura,
    clipping,
    depth_buffer,
    eye_plane,
    field_of_view,
    focus,
    interpolation,
    oblique_drawing,
    off_axis_window,
    planar_shadow,
    popping,
    similar_triangles,
    vanishing_points,
    view_volumes,
)
from app.scenes.phenomena.illustration import Phenomenon

PHENOMENA = MappingProxyType(
    {
        phenomenon.name: phenomenon
        for phenomenon in (
            similar_triangles.PHENOMENON,
            camera_obscura.PHENOMENON,
            field_of_view.PHENOMENON,
            view_volumes.PHENOMENON,
            off_axis_window.PHENOMENON,
            oblique_drawing.PHENOMENON,
            vanishing_points.PHENOMENON,
            eye_plane.PHENOMENON,
            clipping.PHENOMENON,
            affine_depth.PHENOMENON,
            depth_buffer.PHENOMENON,
            interpolation.PHENOMENON,
            planar_shadow.PHENOMENON,
            popping.PHENOMENON,
            focus.PHENOMENON,
        )
    }
)
"""Every phenomenon by its scene's name, in the order of the lectures."""

__all__ = ["PHENOMENA", "Phenomenon"]
