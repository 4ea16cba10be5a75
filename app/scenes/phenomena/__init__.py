"""The phenomena that the lectures name, each one a scene with a readout; numpy only.

`illustration` says what a phenomenon is made of: `marks` to draw, and `words`: its content file,
with the readout and the diagrams beside the panes. `picture` computes marks of the image pane. Each
other module holds one phenomenon.
"""

from types import MappingProxyType

from app.scenes.phenomena import (
    affine_depth,
    camera_obscura,
    cheap_arithmetic,
    clipping,
    cracks,
    depth_buffer,
    drift,
    eye_plane,
    field_of_view,
    focus,
    interpolation,
    jitter,
    oblique_drawing,
    off_axis_window,
    planar_shadow,
    popping,
    similar_triangles,
    two_eyes,
    unprojection,
    vanishing_points,
    vertex_depth,
    view_volumes,
)
from app.scenes.phenomena.illustration import Phenomenon

_ORDER = (
    similar_triangles,
    camera_obscura,
    field_of_view,
    view_volumes,
    off_axis_window,
    two_eyes,
    oblique_drawing,
    vanishing_points,
    eye_plane,
    clipping,
    affine_depth,
    depth_buffer,
    vertex_depth,
    interpolation,
    planar_shadow,
    popping,
    focus,
    cheap_arithmetic,
    drift,
    jitter,
    cracks,
    unprojection,
)
PHENOMENA = MappingProxyType({each.PHENOMENON.name: each.PHENOMENON for each in _ORDER})
"""Every phenomenon by its scene's name, in the order of the lectures."""

__all__ = ["PHENOMENA", "Phenomenon"]
