"""The phenomena that the lectures name, each one a scene with a readout; numpy only.

`illustration` says what a phenomenon is made of: `marks` to draw, and `words`: its content file,
with the readout and the diagrams beside the panes. `picture` computes marks of the image pane. Each
other module holds one phenomenon.
"""

from collections.abc import Mapping
from importlib import import_module
from types import MappingProxyType

from app.scenes.phenomena.illustration import Phenomenon

_ORDER = (
    "similar_triangles", "camera_obscura", "field_of_view", "view_volumes", "off_axis_window",
    "two_eyes", "oblique_drawing", "vanishing_points", "eye_plane", "clipping", "affine_depth",
    "depth_buffer", "vertex_depth", "interpolation", "planar_shadow", "popping", "focus",
    "cheap_arithmetic", "drift", "jitter", "cracks", "unprojection",
)  # fmt: skip
_EVERY = (import_module(f"{__name__}.{name}").PHENOMENON for name in _ORDER)
PHENOMENA: Mapping[str, Phenomenon] = MappingProxyType({each.name: each for each in _EVERY})
"""Every phenomenon by its scene's name, in the order of the lectures."""

__all__ = ["PHENOMENA", "Phenomenon"]
