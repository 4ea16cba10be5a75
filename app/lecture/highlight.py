"""The names of things that can be highlighted in panes, controls, matrices, probes and figures.

The item under the pointer names its things; every view that shows one of them highlights it. A
matrix cell names every letter in it.

=============================  ====================================================
name                           thing
=============================  ====================================================
near far left right bottom top the six planes of the view volume
u v n                          the axes of the camera's frame (lecture 004)
eye target up                  the vectors that determine the frame
object_x ... object_origin     the object's axes and its origin, the columns of its matrix
fov                            the field of view, in any unit
clip_x ... clip_w              a coordinate of clip space: a row of the matrices to it
near_left_bottom ...           a corner of the view volume, by its three planes
image depth keep alpha_deg ... fields that only controls and cells show
settings.distance w y_p ...    a scene's settings and own letters
=============================  ====================================================
"""

from typing import TypeAlias

from app.model.parameters import BOTTOM, FAR, LEFT, NEAR, RIGHT, TOP

Highlight: TypeAlias = frozenset[str]  # the highlighted things; empty for none

NOTHING: Highlight = frozenset()
AXES = ("u", "v", "n")
ENDS = NEAR.name, FAR.name  # the planes across the view direction
OBJECT_AXES = ("object_x", "object_y", "object_z", "object_origin")
"""Columns of `world_from_object`."""
CORNERS = tuple(  # corners in the order of the drawings
    f"{depth}_{corner}"
    for depth in ENDS
    for corner in ("left_bottom", "right_bottom", "right_top", "left_top")
)
SIDES = (BOTTOM.name, RIGHT.name, TOP.name, LEFT.name)  # the sides between consecutive corners
WINDOW = {side.letter: side.name for side in (LEFT, RIGHT, BOTTOM, TOP)}
"""The letters of the near plane's sides, in the order of `Projection.window`."""


def made_of(highlighted: Highlight) -> Highlight:
    """Add the planes of each corner: controls exist only for planes."""
    planes = (name for corner in highlighted & set(CORNERS) for name in corner.split("_"))
    return highlighted.union(planes)


def corner_at(*sides: str) -> Highlight:
    """Return the corners where planes meet: two for left and top, one with near or far added."""
    return frozenset(name for name in CORNERS if set(sides) <= set(name.split("_")))
