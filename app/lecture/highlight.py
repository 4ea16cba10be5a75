"""What can be pointed at: one vocabulary for panes, controls, matrices, probes and figures.

Whoever is pointed at says which things it is about, by these names; whoever shows one of them
makes it stand out. Several at once are several: a matrix cell is about every letter in it.

=============================  ====================================================
names                          what
=============================  ====================================================
near far left right bottom top the six planes of the view volume
u v n                          the axes of the camera's frame (lecture 004)
eye target up                  what the frame is made of
object_x ... object_origin     the object's axes and its origin, the columns of its matrix
fov                            the field of view, by whatever number it is given
clip_x ... clip_w              a coordinate of clip space: a row of the matrices to it
near_left_bottom ...           a corner of the view volume, by its three planes
image depth keep alpha_deg ... fields of the document that only controls and cells show
settings.distance w y_p ...    a scene's settings, and letters of its own
=============================  ====================================================
"""

from __future__ import annotations

from typing import TypeAlias

Highlight: TypeAlias = frozenset[str]
"""The things that are highlighted; empty for none."""

NOTHING: Highlight = frozenset()
AXES = ("u", "v", "n")
OBJECT_AXES = ("object_x", "object_y", "object_z", "object_origin")
"""The columns of `world_from_object`."""
CORNERS = tuple(
    f"{depth}_{corner}"
    for depth in ("near", "far")
    for corner in ("left_bottom", "right_bottom", "right_top", "left_top")
)
"""In the order of the drawings' own corners."""
SIDES = ("bottom", "right", "top", "left")
"""The sides between one of those corners and the next."""


def made_of(highlighted: Highlight) -> Highlight:
    """The same things, and of corners also the planes that meet there: they have the numbers."""
    planes = (name for corner in highlighted & set(CORNERS) for name in corner.split("_"))
    return highlighted.union(planes)


def corner_at(*sides: str) -> Highlight:
    """The corners where some planes meet: two for left and top, one with near or far as well."""
    return frozenset(name for name in CORNERS if set(sides) <= set(name.split("_")))
