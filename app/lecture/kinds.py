"""The tree of planar projections (lecture 002), and the kind of a given projection.

The kind is not stored. It follows from where the projectors meet and how the world's axes lie
relative to the image plane.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, NamedTuple

from app.model.infinity import trace_at_infinity
from app.model.projection import Camera, Orbit, Projection, Vector, oblique_angles
from app.model.refusal import QT_TRANSLATE_NOOP

TOLERANCE = 1e-4
"""Tolerance of an axis' component across the image plane and of a receding edge.

It is a tenth of a pixel in 1000: a camera typed with two decimals of a degree is recognised.
"""
AXES: tuple[Vector, Vector, Vector] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class ProjectionKind(NamedTuple):
    """A node of the tree.

    Attributes
    ----------
    parent : str
        Empty for the root.
    title, condition : str
        Its name, and its condition in addition to the parent's; marked for translation.
    orbit : Orbit, optional
        The camera's place, with distance 1 for the present distance. None for any camera.
    receding : float, optional
        The scale of edges along the view in an oblique drawing.
    """

    name: str
    parent: str
    title: str
    condition: str
    orbit: Orbit | None = None
    receding: float | None = None


def _degrees(tangent: float) -> float:
    return math.degrees(math.atan(tangent))


KINDS: dict[str, ProjectionKind] = {
    kind.name: kind
    for kind in (
        ProjectionKind(
            "planar", "", QT_TRANSLATE_NOOP("Kind", "planar projections"),
            QT_TRANSLATE_NOOP("Kind", "projectors are straight lines, and meet a plane"),
        ),
        ProjectionKind(
            "perspective", "planar", QT_TRANSLATE_NOOP("Kind", "perspective"),
            QT_TRANSLATE_NOOP("Kind", "all projectors meet in the eye"),
        ),
        ProjectionKind(
            "1-point", "perspective", QT_TRANSLATE_NOOP("Kind", "1-point"),
            QT_TRANSLATE_NOOP(
                "Kind", "two axes are parallel to the image plane: one vanishing point"
            ),
            Orbit(0.0, 0.0, 1.0),
        ),
        ProjectionKind(
            "2-point", "perspective", QT_TRANSLATE_NOOP("Kind", "2-point"),
            QT_TRANSLATE_NOOP(
                "Kind", "one axis is parallel to the image plane: two vanishing points"
            ),
            Orbit(40.0, 0.0, 1.0),
        ),
        ProjectionKind(
            "3-point", "perspective", QT_TRANSLATE_NOOP("Kind", "3-point"),
            QT_TRANSLATE_NOOP(
                "Kind", "no axis is parallel to the image plane: three vanishing points"
            ),
            Orbit(44.0, 30.0, 1.0),
        ),
        ProjectionKind(
            "parallel", "planar", QT_TRANSLATE_NOOP("Kind", "parallel"),
            QT_TRANSLATE_NOOP("Kind", "all projectors are parallel"),
        ),
        ProjectionKind(
            "orthographic", "parallel", QT_TRANSLATE_NOOP("Kind", "orthographic"),
            QT_TRANSLATE_NOOP("Kind", "projectors are at right angles to the image plane"),
        ),
        ProjectionKind(
            "axonometric", "orthographic", QT_TRANSLATE_NOOP("Kind", "axonometric"),
            QT_TRANSLATE_NOOP("Kind", "no two axes are parallel to the image plane"),
        ),
        ProjectionKind(
            "isometric", "axonometric", QT_TRANSLATE_NOOP("Kind", "isometric"),
            QT_TRANSLATE_NOOP("Kind", "all three axes make equal angles with the image plane"),
            Orbit(45.0, _degrees(math.sqrt(0.5)), 1.0),
        ),
        ProjectionKind(  # from (1, 1, sqrt 7), as ISO 5456-3 draws it: z half as long as x and y
            "dimetric", "axonometric", QT_TRANSLATE_NOOP("Kind", "dimetric"),
            QT_TRANSLATE_NOOP("Kind", "two axes make equal angles with the image plane"),
            Orbit(_degrees(1.0 / math.sqrt(7.0)), _degrees(1.0 / math.sqrt(8.0)), 1.0),
        ),
        ProjectionKind(
            "trimetric", "axonometric", QT_TRANSLATE_NOOP("Kind", "trimetric"),
            QT_TRANSLATE_NOOP("Kind", "the axes make three different angles with the image plane"),
            Orbit(30.0, 20.0, 1.0),
        ),
        ProjectionKind(
            "multiview", "orthographic", QT_TRANSLATE_NOOP("Kind", "multiview"),
            QT_TRANSLATE_NOOP("Kind", "two axes are parallel to the image plane"),
        ),
        ProjectionKind(
            "front", "multiview", QT_TRANSLATE_NOOP("Kind", "front"),
            QT_TRANSLATE_NOOP("Kind", "x and y are parallel to the image plane, seen along −z"),
            Orbit(0.0, 0.0, 1.0),
        ),
        ProjectionKind(
            "top", "multiview", QT_TRANSLATE_NOOP("Kind", "top"),
            QT_TRANSLATE_NOOP("Kind", "x and z are parallel to the image plane, seen along −y"),
            Orbit(0.0, 90.0, 1.0),
        ),
        ProjectionKind(
            "side", "multiview", QT_TRANSLATE_NOOP("Kind", "side"),
            QT_TRANSLATE_NOOP("Kind", "y and z are parallel to the image plane, seen along −x"),
            Orbit(90.0, 0.0, 1.0),
        ),
        ProjectionKind(
            "oblique", "parallel", QT_TRANSLATE_NOOP("Kind", "oblique"),
            QT_TRANSLATE_NOOP("Kind", "projectors are oblique to the image plane"),
        ),
        ProjectionKind(
            "cavalier", "oblique", QT_TRANSLATE_NOOP("Kind", "cavalier"),
            QT_TRANSLATE_NOOP(
                "Kind",
                "two axes are parallel to the image plane, the third is drawn at full length",
            ),
            Orbit(0.0, 0.0, 1.0), 1.0,
        ),
        ProjectionKind(
            "cabinet", "oblique", QT_TRANSLATE_NOOP("Kind", "cabinet"),
            QT_TRANSLATE_NOOP(
                "Kind",
                "two axes are parallel to the image plane, the third is drawn at half its length",
            ),
            Orbit(0.0, 0.0, 1.0), 0.5,
        ),
    )
}  # fmt: skip
"""Every node, by name; parents first, children from left to right."""

RECEDING_DEG = 45.0
"""The receding direction of the cavalier and the cabinet drawing."""


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
    x, y, z = (
        math.hypot(clip[0] * (right - left) / 2.0, clip[1] * (top - bottom) / 2.0) for clip in clips
    )
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
        drawn = (
            k for k in KINDS.values() if k.receding is not None and _same(receding, k.receding)
        )
        kind = next(drawn, None)
        return kind.name if kind is not None and has_face else "oblique"
    if has_face:
        faces = {(0, True): "side", (1, True): "top", (2, True): "front"}
        axis = through.index(True)
        return faces.get((axis, away[axis] > 0.0), "multiview")
    x, y, z = map(abs, away)  # the sines of the axes' angles with the image plane
    return ("trimetric", "dimetric", "dimetric", "isometric")[
        _same(x, y) + _same(y, z) + _same(x, z)
    ]


def _same(a: float, b: float) -> bool:
    return abs(a - b) <= TOLERANCE


def with_kind(projection: Projection, kind: str) -> Projection:
    """Return a projection of one of `KINDS`: its lens, and the camera turned about the target.

    A projection that already is of this kind does not change. For a node without an orbit, the
    camera does not change if the node's condition holds from there; else it is that of the node's
    first child.

    Raises
    ------
    Refusal
        If this camera or this lens is impossible.
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
            projection = leaning(projection, *oblique_angles(node.receding, RECEDING_DEG))
    elif "parallel" in above:
        projection = projection.with_lens("orthographic")
    else:
        projection = projection.with_eye()
    if kind in path(kind_of(projection) or kind):
        return projection
    return with_kind(projection, next(each.name for each in KINDS.values() if each.parent == kind))


def leaning(projection: Projection, alpha_deg: float, beta_deg: float) -> Projection:
    """Change the angles of an oblique lens, and keep the target's place in the picture."""
    lens: Any = projection.lens
    leaning = replace(lens, alpha_deg=alpha_deg, beta_deg=beta_deg)
    away = projection.camera.distance - lens.near
    x, y = ((was - now) * away for was, now in zip(lens.shear, leaning.shear, strict=True))
    lens = replace(
        leaning,
        left=lens.left + x, right=lens.right + x, bottom=lens.bottom + y, top=lens.top + y,
    )  # fmt: skip
    return replace(projection, lens=lens)
