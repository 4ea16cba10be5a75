"""Crossing the eye plane: the divide alone, lecture 004's cut, and homogeneous clipping.

A point with ``w < 0`` is behind the eye. The divide mirrors it through the principal point, and
draws a segment with one end behind as the wrong one of the two arcs into which its ends part the
projective line (lecture 004, "Opis problema"). The lecture cuts at ``z = -0.01`` before it divides;
clipping in homogeneous coordinates needs no such number, because the left and the right plane
together require ``w >= 0``.

No picture here is cut at near and far, which would take away more and correct nothing else.
"""

import itertools
import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.model.clipping import LARGEST_CLIP, clip_segments, cut_at_eye, naive_ndc
from app.model.parameter import Settings, point
from app.model.projection import Array, Camera, Projection
from app.model.refusal import Refusal
from app.scenes.phenomena.illustration import Illustration, OwnMesh, Phenomenon, Subject
from app.scenes.phenomena.marks import (
    Dot,
    Face,
    Grip,
    Mark,
    Marks,
    Polyline,
    Text,
    named,
    outline,
    plate,
    segment,
)
from app.scenes.phenomena.picture import SIDES, image_from_ndc, rectangle, section, world_from_view
from app.scenes.phenomena.words import Curve, Diagram, PhenomenonWords, Reading, broken
from app.scenes.shapes import letter_f_edges

WORDS = PhenomenonWords("eye-plane")

_THROUGH_EYE = 1e-14  # sine of the angle between the ends' rays below which they are one ray
_RADIUS = 0.93  # of the arc of the naive divide, inside the circle of radius 1
_STEPS = np.linspace(0.0, 1.0, 65)
_MARGIN = 0.02  # of the picture's size, round the frame
_MOST_EDGES = 300  # of a user's mesh
_IMAGE_AT = 0.5  # of the target's distance: the plane on which the world shows the image
_FARTHEST_IMAGE = 4.0  # of that plane's distance: farther images are not marked
_CROSSING = (3, 4)  # lecture 004's cases
_AT_FRAME, _ARROW = 1e-6, 0.06  # of the picture's longer side
_BEYOND = 0.4  # of its longer side: how far past the frame an image is drawn that runs on
_RULED = np.array([(-1, -0.5), (1, -0.5), (1, 0), (-1, 0), (-1, 0.5), (1, 0.5), (1, 1), (0.5, 1),
                   (0.5, -1), (0, -1), (0, 1), (-0.5, 1), (-0.5, -1)])  # fmt: skip
"""Lines of the eye plane in one go, or it would be taken for a pane of glass."""
_DASHES = 7  # of a piece that has no image


class EyePlanePictures(NamedTuple):
    """Three drawings of the same m segments, in pixels, cut to the frame.

    - `naive`, `cut`, `right` (m, 2, 2): by the divide alone, by lecture 004's cut, by homogeneous
      clipping; NaN where nothing is drawn.
    - `wrong_px` (m,): length that only the naive drawing has inside the frame: all that it draws of
      a segment with an end behind the eye, because its arc and the right one share only their ends.
    - `part` (m, 2): where the part begins and ends that the right drawing shows, from 0 to 1; NaN
      for nothing.
    """

    naive: Array
    cut: Array
    right: Array
    case: NDArray[np.intp]  # (m,): lecture 004's case, 1 to 4, of `app.model.clipping.EyeCut`
    wrong_px: Array
    missed_px: Array  # (m,): length that the right drawing has and the naive one lacks
    left_out_px: Array  # (m,): length that lecture 004's cut removes in front of the eye
    part: Array


def pictures(projection: Projection, view: Array, clip: Array) -> EyePlanePictures:
    """Draw segments in the three ways; `view` (m, 2, 3) and `clip` (m, 2, 4) are their ends."""
    eye_cut = cut_at_eye(view[:, 0], view[:, 1])
    matrix = projection.clip_from_view
    flat = np.empty((3, *clip.shape))
    flat[0, ..., :3], flat[0, ..., 3] = naive_ndc(clip), 1.0
    is_whole = (eye_cut.case == 1)[:, None, None]
    flat[1] = np.where(is_whole, clip, eye_cut.points_view @ matrix[:, :3].T)
    flat[2] = clip
    flat[..., 2] = 1.0  # the depth does not matter, as long as it is not 0 at the eye
    nothing = ~(np.abs(flat) <= LARGEST_CLIP).all(axis=(2, 3))
    flat[nothing] = (2.0, 0.0, 1.0, 1.0)  # beyond the right plane
    clipped = clip_segments(flat[..., 0, :], flat[..., 1, :], planes=SIDES)
    with np.errstate(invalid="ignore", divide="ignore"):
        ndc = clipped.points_clip[..., :2] / clipped.points_clip[..., 3:]
    # A segment that points at the eye has no image there; one point of it is seen.
    size = np.maximum(np.abs(clip[..., [0, 1, 3]]).max(axis=-1), 5e-324)
    (xa, xb), (ya, yb), (wa, wb) = rays = clip.T[[0, 1, 3]] / size.T
    sine = np.maximum(np.abs(ya * wb - yb * wa), np.abs(xa * wb - xb * wa))
    for row in np.flatnonzero((sine <= _THROUGH_EYE) & clipped.visible[2]):
        x, y, w = rays[:, np.argmax(clip[row, :, 3]), row]
        ndc[1:, row] = (x / w, y / w) if w > 0.0 and max(abs(x), abs(y)) <= w else math.nan
    ndc[~np.isfinite(ndc).all(axis=(2, 3))] = np.nan
    drawn = image_from_ndc(projection, ndc)
    span = drawn[:, :, 1] - drawn[:, :, 0]
    lengths = np.nan_to_num(np.hypot(span[..., 0], span[..., 1]))
    in_front = (clip[..., 3] > 0.0).all(axis=1)
    naive, cut, right = drawn
    return EyePlanePictures(
        naive,
        cut,
        right,
        eye_cut.case,
        np.where(in_front, 0.0, lengths[0]),
        np.where(in_front, 0.0, lengths[2]),
        np.maximum(lengths[2] - lengths[1], 0.0),
        clipped.t[2],
    )


def mirrored_end(
    projection: Projection, view: Array
) -> tuple[tuple[float, float], tuple[float, float]] | None:
    """Where the divide draws a point behind the eye, and the frame's size minus its right place.

    Both in pixels, of a point ``(x, y, z)`` of view space with z > 0. The right place is that of
    ``(x, y, -z)``, the point as far in front of the eye. None where a pixel is beyond 1e307.

    With ``x_clip = s x - k w``, where ``k = (r + l)/(r - l)``, the two ends have
    ``x_ndc = -s x/z - k`` and ``s x/z - k``. Their sum is -2k, in pixels twice the principal
    point. So the mirrored end is the frame's size minus the right one if and only if k is 0 in x
    and in y: if the lens' axis goes through the middle of the picture.
    """
    x, y, z = view.tolist()
    matrix = projection.clip_from_view[[0, 1, 3], :3]
    ends = np.array([[x, y, z], [x, y, -z]]) @ matrix.T
    width, height = projection.image_size
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        across, up = (ends[:, :2] / ends[:, 2:]).T
        left, top = (across + 1.0) * (width / 2.0), (1.0 - up) * (height / 2.0)
    if not (np.abs([left, top]) <= LARGEST_CLIP).all():
        return None
    return (float(left[0]), float(top[0])), (float(width - left[1]), float(height - top[1]))


def principal_point(projection: Projection) -> tuple[float, float]:
    """The pixel where the lens' axis meets the picture."""
    k_x, k_y = -projection.clip_from_view[:2, 2]
    width, height = projection.image_size
    return float(width / 2.0 * (1.0 + k_x)), float(height / 2.0 * (1.0 - k_y))


def circle_angles(projection: Projection, clip: Array) -> tuple[float, float] | None:
    """A segment's image on its projective line, drawn as a circle with infinity at the top.

    Returns the angles of both ends (2, 4) in radians, anticlockwise from the bottom. The numbers
    between them are the segment's image; they include an odd multiple of pi if and only if the
    segment crosses the eye plane. None if the image is a single point, or lies at infinity.

    A point of the image line at s from the point nearest to the picture's middle, in half
    diagonals of the picture, stands at ``2 atan(s)``. With ``s = l/w`` and both linear along the
    segment, ``2 atan2(l, w)`` is continuous through w = 0.
    """
    width, height = projection.image_size
    ends = clip[:, [0, 1, 3]] * (width / 2.0, height / 2.0, math.hypot(width, height) / 2.0)
    ends /= np.maximum(np.abs(ends).max(axis=1, keepdims=True), 5e-324)
    (xa, ya, wa), (xb, yb, wb) = ends.tolist()
    normal_x, normal_y = ya * wb - yb * wa, xb * wa - xa * wb
    size = math.hypot(normal_x, normal_y)
    if size <= _THROUGH_EYE:
        return None
    along_x, along_y = normal_y / size, -normal_x / size
    if (along_x, along_y) < (0.0, 0.0):  # to the right, so that A and B stand as in the picture
        along_x, along_y = -along_x, -along_y
    start = math.atan2(along_x * xa + along_y * ya, wa)
    end = math.atan2(along_x * xb + along_y * yb, wb)
    if abs(end - start) > math.pi:  # the segment's own arc is the shorter one
        end += math.copysign(2.0 * math.pi, start - end)
    return 2.0 * start, 2.0 * end


def _picture(title: str, drawn: Array, colour: str, size: tuple[int, int]) -> Diagram:
    width, height = size
    return Diagram(
        title,
        (
            Curve(rectangle(width, height), "muted", closed=True),
            Curve(broken(drawn[1:]), "ink"),
            Curve(broken(drawn[:1]), colour, "AB" if np.isfinite(drawn[0]).all() else "", 2.5),
        ),
        *(-_MARGIN * width, (1.0 + _MARGIN) * width),
        *((1.0 + _MARGIN) * height, -_MARGIN * height),
        equal=True,
    )


def _arc(start: float, end: float, radius: float) -> Array:
    """Points of the circle from one angle to another, (n, 2)."""
    angles = start + (end - start) * _STEPS
    return radius * np.stack([np.sin(angles), -np.cos(angles)], axis=1)


def _circle(angles: tuple[float, float] | None, in_front: bool) -> Diagram:
    curves = [Curve(_arc(0.0, 2.0 * math.pi, 1.0), "muted", closed=True)]
    dots = [Curve(np.array([(0.0, 1.0)]), "ink", "∞", dots=True)]
    if angles is not None:
        # Back into the turn between two infinities, where s itself runs from A' to B'.
        from_a, to_b = (math.remainder(angle, 2.0 * math.pi) for angle in angles)
        curves.append(Curve(_arc(from_a, to_b, _RADIUS), "u", WORDS["arc"], 2.0))
        if in_front:  # nothing behind the eye has an image
            curves.append(Curve(_arc(*angles, 1.0), "accent", WORDS["image"], 2.5))
        for angle, name in zip(angles, ("A'", "B'"), strict=True):
            dots.append(Curve(_arc(angle, angle, 1.0)[:1], "ink", name, dots=True))
    return Diagram(WORDS["circle"], (*curves, *dots), -1.4, 1.4, -1.4, 1.4, equal=True)


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    a, b = np.array(point(settings, "start")), np.array(point(settings, "end"))
    mesh = subject.mesh
    if (parallel := WORDS.of_parallel(projection)) is not None:
        return Illustration((), warning=parallel)
    others = letter_f_edges()[0] if mesh is None else _edges_that_matter(projection.camera, mesh)
    trace = projection.trace(np.concatenate([[(a, b)], others]))
    drawn = pictures(projection, trace.view, trace.clip)
    angles = circle_angles(projection, trace.clip[0])
    depths = -trace.view[0, :, 2]
    warning = None
    if angles is None and (a != b).any():
        warning = WORDS.phrase("through" if depths.any() else "within")
    size, way = projection.image_size, str(settings["drawn"])
    return Illustration(
        _readings(projection, drawn, trace.view[0], mesh),
        world=Marks.of(
            _world_marks(
                projection, subject, np.stack([a, b]), depths, _kept(depths, drawn.part[0], way)
            ),
            _image_in_world(projection, trace.view[0], drawn, way),
        ),
        ndc=_ndc_marks(projection, trace.clip[0]),
        image=Marks.of(
            _image_marks(drawn) if way == "faces" else _edges_alone(drawn, way, size),
            _divided_ends(projection, trace.clip[0], way),
        ),
        diagrams=(
            _picture(WORDS["naive"], drawn.naive, "u", size),
            _picture(WORDS["cut"], drawn.cut, "accent", size),
            _picture(WORDS["clipped"], drawn.right, "accent", size),
            _circle(angles, bool((depths > 0.0).any())),
        ),
        warning=warning,
        grips=(Grip("start", a, name="A"), Grip("end", b, name="B")),
    )


def _edges_that_matter(camera: Camera, mesh: OwnMesh) -> Array:
    """First the edges that cross the eye plane, then the longest: `_MOST_EDGES` at most."""
    if len(mesh.edges) <= _MOST_EDGES:
        return mesh.edges
    n = camera.frame[2]
    behind = mesh.edges.reshape(-1, 3) @ n >= np.array(camera.eye) @ n
    crossing = behind[::2] != behind[1::2]
    chosen = np.concatenate([np.flatnonzero(crossing), np.flatnonzero(~crossing)[:_MOST_EDGES]])
    return np.asarray(mesh.edges[chosen[:_MOST_EDGES]])


def _readings(
    projection: Projection, drawn: EyePlanePictures, view: Array, mesh: OwnMesh | None
) -> tuple[Reading, ...]:
    behind = [end for end in (1, 0) if view[end, 2] > 0.0]
    ends = mirrored_end(projection, view[behind[0]]) if behind else None
    absent = None if ends else WORDS.phrase("at-infinity" if behind else "none-behind")
    principal, middle = principal_point(projection), [side / 2.0 for side in projection.image_size]
    off_axis = None
    if any(abs(p - m) > 1e-6 * m for p, m in zip(principal, middle, strict=True)):
        off_axis = WORDS.phrase("off-axis", *principal)
    wrong, missed = drawn.wrong_px, drawn.missed_px
    readings = [
        Reading(WORDS["case"], WORDS[f"case-{drawn.case[0]}"]),
        Reading(WORDS["ab-wrong"], float(wrong[0]), "px"),
        Reading(WORDS["ab-missed"], float(missed[0]), "px"),
        Reading(WORDS["ab-left-out"], float(drawn.left_out_px[0]), "px"),
    ]
    some, subject = None, "letter" if mesh is None else "mesh"
    counted = len(drawn.case) - 1
    if mesh is not None and counted < mesh.edge_count:
        some = WORDS.phrase("some-edges", str(counted), str(mesh.edge_count))
        readings.append(Reading(WORDS["counted"], (float(counted), float(mesh.edge_count))))
    readings += [
        Reading(WORDS[f"{subject}-wrong"], float(wrong[1:].sum()), "px", some),
        Reading(WORDS[f"{subject}-missed"], float(missed[1:].sum()), "px", some),
        Reading(WORDS["mirrored"], ends and ends[0], "px", absent),
        Reading(WORDS["minus-right"], ends and ends[1], "px", absent or off_axis),
    ]
    return tuple(readings)


def _kept(depths: Array, part: Array, way: str) -> tuple[float, float]:
    """Where the part of AB begins and ends, from 0 to 1, that a way of drawing has an image of.

    The cut at z = -0.01 is drawn at the eye plane. Both are 1 where nothing is drawn.
    """
    start, end = depths.tolist()
    if way == "naive":
        return 0.0, 1.0
    if way == "clipped":
        low, high = np.nan_to_num(part, nan=1.0).tolist()
        return low, high
    crossing = start / (start - end) if (start > 0.0) != (end > 0.0) else 1.0
    return (0.0, crossing) if start > 0.0 else (crossing if end > 0.0 else 1.0, 1.0)


def _world_marks(
    projection: Projection, subject: Subject, ends: Array, depths: Array, kept: tuple[float, float]
) -> Marks:
    """The eye plane, and the segment: what is drawn of it, and dashed what has no image."""
    eye, (u, v, _) = np.array(projection.camera.eye), projection.camera.frame
    start, end = depths.tolist()
    share = start / (start - end) if (start > 0.0) != (end > 0.0) else 0.0
    crossing = (1.0 - share) * ends[0] + share * ends[1]
    aside = np.abs(np.stack([u, v]) @ (crossing - eye)).max() if share else 0.0
    reach = max(0.4 * subject.size, min(1.3 * float(aside), subject.size))
    corners = eye + reach * np.array([-u - v, u - v, u + v, v - u])
    marks: list[Mark] = [
        plate(corners, "v", 1.5, 0.18, (), "w=0"),
        Polyline(eye + reach * _RULED @ np.stack([u, v]), "v", 0.5, (), "w=0"),
        Dot(eye, "eye"),
        *(named(name, at, size=1.2) for name, at in zip("AB", ends, strict=True)),
        Text("w=0", corners[3], "v", away_from=eye, text="{eye_plane}"),
        *([Dot(crossing, "v", 1.6)] if share else []),
    ]
    low, high = kept
    for first, last in itertools.pairwise(sorted({0.0, low, share, high, 1.0})):
        one, other = ((1.0 - t) * ends[0] + t * ends[1] for t in (first, last))
        if low <= first and last <= high:
            depth = start + (first + last) / 2.0 * (end - start)
            marks.append(segment(one, other, "accent" if depth > 0.0 else "u", 2.5))
        else:
            dashes = one + np.linspace(0.0, 1.0, 2 * _DASHES)[:, None] * (other - one)
            marks += [Polyline(dash, "muted", 1.0) for dash in dashes.reshape(_DASHES, 2, 3)]
    return Marks.of(*marks)


def _image_in_world(
    projection: Projection, view: Array, drawn: EyePlanePictures, way: str
) -> Marks:
    """The image of AB on a plane before the eye, and the projectors of A and B to it."""
    eye, away = np.array(projection.camera.eye), _IMAGE_AT * projection.camera.distance
    plane = section(projection, away)
    marks: list[Mark] = [Polyline(outline(plane), "near", 1.0), Face(plane, "near", 0.1)]
    marks += [segment(eye, corner, "muted", 0.5) for corner in plane]
    is_cut = way in ("cut", "clipped")
    for name, end in zip(("A'", "B'"), view, strict=True):
        if is_cut and end[2] > 0.0:
            continue
        with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
            image = end * (away / -end[2])
        if not math.hypot(*image) <= _FARTHEST_IMAGE * away:
            continue
        at = world_from_view(projection, image)
        start = world_from_view(projection, end)
        marks += [segment(start, at if end[2] > 0.0 else eye, "muted", 0.75), named(name, at)]
    if not is_cut:
        marks += _laid(projection, plane, drawn.naive[0], "u", drawn.wrong_px[0] > 0.0)
    if way != "naive":
        pixels = drawn.right[0]
        if way == "cut" and drawn.case[0] in _CROSSING:
            pixels = _run_on(pixels, projection.image_size)
        marks += _laid(projection, plane, pixels, "accent", True)
    return Marks.of(*marks)


def _run_on(ends: Array, size: tuple[int, int]) -> Array:
    """A line of the picture (2, 2) with an end at the frame, drawn on past it."""
    span, longer = ends[::-1] - ends, max(size)
    at_frame = (np.minimum(abs(ends), abs(ends - size)) <= _AT_FRAME * longer).any(axis=1)
    further = np.where(at_frame, _BEYOND * longer / max(math.hypot(*span[0]), 1e-9), 0.0)
    return np.asarray(ends - further[:, None] * span)


def _laid(
    projection: Projection, plane: Array, pixels: Array, colour: str, wanted: bool
) -> list[Polyline]:
    """A line of the picture on a plane of the world, whose corners are those of the picture."""
    if not wanted or not np.isfinite(pixels).all():
        return []
    across, down = (pixels / projection.image_size).T[..., None]
    left_bottom, right_bottom, _, left_top = plane
    ends = left_top + across * (right_bottom - left_bottom) + down * (left_bottom - left_top)
    return [Polyline(ends, colour, 2.5)]


def _ndc_marks(projection: Projection, clip: Array) -> Marks:
    """The part of the segment inside the cube."""
    if not (np.abs(clip) <= LARGEST_CLIP).all():
        return Marks()
    try:
        cut = clip_segments(clip[0], clip[1], projection.depth)
    except Refusal:  # it goes through the eye, from so far away that both ends round to one point
        return Marks()
    if not cut.visible:
        return Marks()
    with np.errstate(invalid="ignore", divide="ignore"):
        ndc = cut.points_clip[:, :3] / cut.points_clip[:, 3:]
    if not np.isfinite(ndc).all():  # it points at the eye, and ends there
        return Marks()
    return _ab(ndc)


def _image_marks(drawn: EyePlanePictures) -> Marks:
    """The naive and the right image of the segment, over the picture."""
    marks: list[Mark] = []
    right, wrong = drawn.right[0], drawn.naive[0]
    if drawn.wrong_px[0] > 0.0:
        marks.append(Polyline(wrong, "u", 1.0))
        marks.append(Text("wrong", wrong.mean(axis=0), "u", text=WORDS["wrong"]))
    if np.isfinite(right).all():
        marks.append(_ab(right))
        marks += [Dot(end, "accent", 1.2) for end in right]
    return Marks.of(*marks)


def _divided_ends(projection: Projection, clip: Array, way: str) -> Marks:
    """A' and B', where the divide draws both ends, if that is in the frame and not cut off."""
    with np.errstate(over="ignore", divide="ignore", invalid="ignore"):
        places = image_from_ndc(projection, naive_ndc(clip))
        inside = (places >= 0.0) & (places <= projection.image_size)
    drawn = inside.all(axis=1) & ((clip[:, 3] > 0.0) | (way in ("faces", "naive")))
    each = zip(("A'", "B'"), places, drawn, strict=True)
    return Marks.of(*(named(name, place, size=1.2) for name, place, here in each if here))


def _ab(ends: Array) -> Marks:
    """AB, with its name in the middle."""
    return Marks.of(Polyline(ends, "accent", 2.0), Text("AB", ends.mean(axis=0), "accent"))


def _edges_alone(drawn: EyePlanePictures, way: str, size: tuple[int, int]) -> Marks:
    """All edges drawn in one of the three ways, on an empty picture.

    An edge that crosses the eye plane is thick. The divide draws it wrongly. After the lecture's
    cut it runs on to a far pixel, which an arrow at the frame shows; after clipping it ends at the
    frame, in a dot.
    """
    lines = {"naive": drawn.naive, "cut": drawn.cut, "clipped": drawn.right}[way]
    colour = "u" if way == "naive" else "accent"
    marks: list[Mark] = [Face(rectangle(*size), "background", 1.0)]
    thick: list[Mark] = []
    for ends, case in zip(lines[1:], drawn.case[1:], strict=True):
        if not np.isfinite(ends).all():
            continue
        if case in _CROSSING:
            thick.append(_crossing_edge(ends, colour, way, size))
        else:
            marks.append(Polyline(ends, "ink", 0.75))
    marks += thick
    if np.isfinite(lines[0]).all():
        marks.append(Text("AB", lines[0].mean(axis=0), colour))
        marks.append(_crossing_edge(lines[0], colour, way, size))
    return Marks.of(*marks)


def _crossing_edge(ends: Array, colour: str, way: str, size: tuple[int, int]) -> Marks:
    """An edge that crosses the eye plane, and at the frame what its way of drawing makes of it."""
    marks: list[Mark] = [Polyline(ends, colour, 2.5)]
    for end, other in ((ends[0], ends[1]), (ends[1], ends[0])):
        at_frame = (np.minimum(abs(end), abs(end - size)) <= _AT_FRAME * max(size)).any()
        if not at_frame or way == "naive":
            continue
        if way == "clipped":
            marks.append(Dot(end, colour, 2.4))
            continue
        length = math.dist(end, other)
        if length > 0.0:
            along = (end - other) / length * min(_ARROW * max(size), length)
            aside = 0.4 * np.array([-along[1], along[0]])
            corners = np.array([end, end - along + aside, end - along - aside])
            marks.append(Face(np.clip(corners, 0.0, size), colour, 1.0))
    return Marks.of(*marks)


PHENOMENON = Phenomenon.of(WORDS, show=_show)
