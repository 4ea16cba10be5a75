"""The tree of planar projections (lecture 002), and the kind of a given projection.

The kind is not stored. It follows from where the projectors meet and how the world's axes lie
relative to the image plane.
"""

import math
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from app.model.infinity import trace_at_infinity
from app.model.lenses.oblique import oblique_angles
from app.model.parameter import read_sections, section_of
from app.model.projection import Camera, Orbit, Projection, Vector

TOLERANCE = 1e-4
"""Tolerance of an axis' component across the image plane and of a receding edge.

It is a tenth of a pixel in 1000: a camera typed with two decimals of a degree is recognised.
"""
AXES: tuple[Vector, Vector, Vector] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class ProjectionKind(NamedTuple):
    """A node of the tree."""

    name: str
    parent: str  # empty for the root
    title: str
    condition: str  # its name, and its condition besides the parent's; marked for translation
    orbit: Orbit | None = None
    """The camera's place, with distance 1 for the present distance. None for any camera."""
    receding: float | None = None  # the scale of edges along the view in an oblique drawing


def _degrees(tangent: float) -> float:
    return math.degrees(math.atan(tangent))


_SECTIONS = read_sections(Path(__file__).with_name("content") / "kinds.md")


def _kind(
    name: str, parent: str, orbit: tuple[float, float] | None = None, receding: float | None = None
) -> ProjectionKind:
    title, section = section_of(name, _SECTIONS)
    place = None if orbit is None else Orbit(*orbit, 1.0)
    return ProjectionKind(name, parent, title, section.text[0], place, receding)


KINDS: dict[str, ProjectionKind] = {
    kind.name: kind
    for kind in (
        _kind("planar", ""),
        _kind("perspective", "planar"),
        _kind("1-point", "perspective", (0.0, 0.0)),
        _kind("2-point", "perspective", (40.0, 0.0)),
        _kind("3-point", "perspective", (44.0, 30.0)),
        _kind("parallel", "planar"),
        _kind("orthographic", "parallel"),
        _kind("axonometric", "orthographic"),
        _kind("isometric", "axonometric", (45.0, _degrees(math.sqrt(0.5)))),
        # From (1, 1, sqrt 7), as ISO 5456-3 draws it: z half as long as x and y.
        _kind("dimetric", "axonometric",
              (_degrees(1.0 / math.sqrt(7.0)), _degrees(1.0 / math.sqrt(8.0)))),
        _kind("trimetric", "axonometric", (30.0, 20.0)),
        _kind("multiview", "orthographic"),
        _kind("front", "multiview", (0.0, 0.0)),
        _kind("top", "multiview", (0.0, 90.0)),
        _kind("side", "multiview", (90.0, 0.0)),
        _kind("oblique", "parallel"),
        _kind("cavalier", "oblique", (0.0, 0.0), 1.0),
        _kind("cabinet", "oblique", (0.0, 0.0), 0.5),
    )
}  # fmt: skip
"""Every node, by name; parents first, children from left to right."""

RECEDING_DEG = 45.0  # the receding direction of the cavalier and the cabinet drawing


def path(kind: str) -> tuple[str, ...]:
    """Return a node and its ancestors, the root first."""
    parent = KINDS[kind].parent
    return (*path(parent), kind) if parent else (kind,)


def scale_factors(projection: Projection) -> Vector | None:
    """Return the drawn lengths of units along x, y and z, in world units of the image plane.

    The result is None for a lens whose picture shrinks with distance, and for a typed matrix, whose
    picture has no size in world units.
    """
    if not projection.lens.even_extent:  # only parallel projectors show lengths
        return None
    left, right, bottom, top = projection.window
    clips = (trace_at_infinity(projection, axis).clip.tolist() for axis in AXES)
    width, height = (right - left) / 2.0, (top - bottom) / 2.0
    x, y, z = (math.hypot(clip[0] * width, clip[1] * height) for clip in clips)
    return x, y, z


def kind_of(projection: Projection) -> str | None:
    """Return the lowest node whose condition holds; None for a typed matrix."""
    lens = projection.lens
    if lens.planes is None:
        return None
    away = projection.camera.frame[2].tolist()
    through = [abs(part) > TOLERANCE for part in away]
    if lens.central:
        return f"{sum(through)}-point"
    has_face = sum(through) == 1
    receding = math.hypot(*lens.shear)
    if receding > TOLERANCE:
        drawn = (k.name for k in KINDS.values() if k.receding and _same(receding, k.receding))
        return next(drawn, "oblique") if has_face else "oblique"
    if has_face:
        faces = {(0, True): "side", (1, True): "top", (2, True): "front"}
        axis = through.index(True)
        return faces.get((axis, away[axis] > 0.0), "multiview")
    x, y, z = map(abs, away)  # the sines of the axes' angles with the image plane
    equal = _same(x, y) + _same(y, z) + _same(x, z)
    return ("trimetric", "dimetric", "dimetric", "isometric")[equal]


def _same(a: float, b: float) -> bool:
    return abs(a - b) <= TOLERANCE


def with_kind(projection: Projection, kind: str) -> Projection:
    """Return a projection of one of `KINDS`: its lens, and the camera turned about the target.

    A projection that already is of this kind does not change. For a node without an orbit, the
    camera does not change if the node's condition holds from there; else it is that of the node's
    first child. Raises a `Refusal` if this camera or this lens is impossible.
    """
    now = kind_of(projection)
    if now is not None and kind in path(now):
        return projection
    node, camera, above = KINDS[kind], projection.camera, path(kind)
    if node.orbit is not None:
        orbit = node.orbit._replace(distance=camera.distance)
        projection = replace(projection, camera=Camera.from_orbit(camera.target, orbit))
    if "oblique" in above:
        projection = projection.with_lens("oblique")
        if node.receding is not None:
            projection = projection.with_angles(*oblique_angles(node.receding, RECEDING_DEG))
    elif "parallel" in above:
        projection = projection.with_lens("orthographic")
    else:
        projection = projection.with_eye()
    if kind in path(kind_of(projection) or kind):
        return projection
    return with_kind(projection, next(each.name for each in KINDS.values() if each.parent == kind))
