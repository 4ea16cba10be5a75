"""From the world to marks of the image pane, in pixels, and back.

Lines are cut in clip space, before the divide by w, so that no mark is mirrored or runs to
infinity, whatever the camera does.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from app.model.clipping import LARGEST_CLIP, clip_segments
from app.model.limits import vector
from app.model.projection import PLANES, Array, Projection, Trace, Vector
from app.scenes.phenomena.marks import Grip, Polyline, Text
from app.scenes.shapes import box_corners

SIDES = ("left", "right", "bottom", "top")
"""The planes that cut a line which may be at any depth, such as the horizon."""


def box_edges(lower: Vector, upper: Vector) -> Array:
    """The four edges of a box along each of x, y, z, from lower to upper end, (3, 4, 2, 3)."""
    corners = box_corners(lower, upper).reshape(2, 2, 2, 3)  # by z, y and x
    return np.array([np.moveaxis(corners, 2 - axis, 2).reshape(4, 2, 3) for axis in range(3)])


def world_from_view(projection: Projection, points_view: ArrayLike) -> Array:
    """World coordinates of points (..., 3) of view space."""
    camera = projection.camera
    return np.asarray(np.asarray(camera.eye) + np.asarray(points_view) @ camera.frame)


def drawn_planes(projection: Projection) -> tuple[float, float]:
    """The distances of near and far; for an infinite far plane, one beyond the scene."""
    near, far = projection.lens.near, projection.lens.far
    return near, max(3.0 * projection.camera.distance, 4.0 * near) if far == math.inf else far


def section(projection: Projection, distance: float) -> Array:
    """World corners of the frustum's section at a distance from the eye, (4, 3)."""
    left, right, bottom, top = projection.lens.window_at(projection.window, distance)
    corners = [(left, bottom), (right, bottom), (right, top), (left, top)]
    return world_from_view(projection, [(x, y, -distance) for x, y in corners])


def grip_of_plane(
    projection: Projection, setting: str, value: float, at: float, name: str, colour: str
) -> Grip:
    """The grip of a plane at a distance from the eye, which is in proportion to a setting."""
    face, eye = section(projection, at), projection.camera.eye
    low = face[:2].mean(axis=0)  # it runs along the lower side of what the lens sees
    return Grip(setting, low, eye, vector((low - eye) / value), name, colour, face)


def rectangle(width: float, height: float) -> Array:
    """The corners of a picture of this size, in pixels, (4, 2)."""
    return np.array([(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)])


def image_from_ndc(projection: Projection, points_ndc: Array) -> Array:
    """Pixels (..., 2) of points (..., 2 or 3) of NDC."""
    width, height = projection.image_size
    x, y = points_ndc[..., 0], points_ndc[..., 1]
    return np.stack([(x + 1.0) * (width / 2.0), (1.0 - y) * (height / 2.0)], axis=-1)


def image_from_clip(projection: Projection, points_clip: Array) -> Array:
    """Pixels (..., 2) of clip points (..., 4) with w > 0."""
    return image_from_ndc(projection, points_clip[..., :2] / points_clip[..., 3:])


def cut_in_picture(
    projection: Projection, starts_clip: Array, ends_clip: Array, planes: Iterable[str] = PLANES
) -> list[Array | None]:
    """The visible parts of segments between clip points (k, 4), in pixels: (2, 2) each, or None.

    Ends may be points at infinity. `planes` must include left and right. None stands for a segment
    that is not seen, or that goes through the eye, so that its picture is a point.
    """
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        largest = [np.abs(ends).max(axis=1, keepdims=True) for ends in (starts_clip, ends_clip)]
        # The same quotients by which `clip_segments` refuses ends p and -k p.
        opposite = (starts_clip / largest[0] == -(ends_clip / largest[1])).all(axis=1)
    held = (np.maximum(*largest)[:, 0] <= LARGEST_CLIP) & ~opposite
    (rows,) = np.nonzero(held)
    pieces: list[Array | None] = [None] * len(starts_clip)
    if not len(rows):
        return pieces
    cut = clip_segments(starts_clip[rows], ends_clip[rows], projection.depth, planes)
    drawn = cut.visible & (cut.points_clip[..., 3] > 0.0).all(axis=1)
    pixels = image_from_clip(projection, cut.points_clip[drawn])
    for row, ends in zip(rows[drawn], pixels, strict=True):
        pieces[row] = ends
    return pieces


def seen_lines(
    projection: Projection, segments_clip: Array, colours: Iterable[str], width: float = 1.0
) -> tuple[Polyline, ...]:
    """Clip-space segments (k, 2, 4) as lines of the image, cut to the view volume."""
    pieces = cut_in_picture(projection, segments_clip[:, 0], segments_clip[:, 1])
    return tuple(
        Polyline(piece, colour, width)
        for piece, colour in zip(pieces, colours, strict=True)
        if piece is not None
    )


def seen(trace: Trace) -> NDArray[np.bool_]:
    """Which of traced points (..., 3) are in the view volume, (...) bool."""
    return np.asarray(trace.in_front & ~trace.outside.any(axis=-1))


def seen_texts(trace: Trace, texts: Sequence[Text]) -> tuple[Text, ...]:
    """The letters of the last traced points in the image, if their points are in the volume."""
    last = slice(len(trace.image) - len(texts), None)
    return tuple(
        replace(text, point=place)
        for text, place, here in zip(texts, trace.image[last], seen(trace)[last], strict=True)
        if here
    )
