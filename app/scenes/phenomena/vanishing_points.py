"""Vanishing points: where the images of parallel edges meet, and when they do not.

Points ``(C + s D, 1)`` of an edge along D are ``(C/s + D, 1/s)``: as s grows, w goes to 0 and the
point to the direction ``(D, 0)``, a point at infinity (lecture 002, homogeneous coordinates). Its
image is the vanishing point of every edge along D; if D is parallel to the image, or the lens is
parallel, the image is at infinity too, and the edges stay parallel. How many of a box's three
directions have one names the perspective: 1-, 2- or 3-point (lecture 002).
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from app.model.projection import Array, Camera, Orbit, Perspective, Projection, Trace
from app.model.refusal import QT_TRANSLATE_NOOP
from app.scenes.phenomena.diagram import Curve, Diagram, broken
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Line, Mark, Marks, Text, named
from app.scenes.phenomena.picture import (
    SIDES,
    box_edges,
    cut_in_picture,
    image_from_clip,
    rectangle,
)
from app.scenes.phenomena.readout import Phrase, Reading, of_parallel
from app.scenes.phenomena.settings import CLOSE, Found, Setting, Settings, number
from app.scenes.shapes import (
    EDGE_RGB,
    SIDE_RGB,
    Coloured,
    box_faces,
    edges_of,
    flat,
    ground_grid,
    joined,
)

_AT_INFINITY = QT_TRANSLATE_NOOP(
    "phenomena",
    "V_{0} is at infinity: edges along {0} stay parallel, at {1}° from the right",
)
_END_ON = QT_TRANSLATE_NOOP("phenomena", "edges along {0} are seen end on, as points")
_PARALLEL = QT_TRANSLATE_NOOP(
    "phenomena", "with a parallel lens parallel edges stay parallel in the image"
)
_P_AT_INFINITY = QT_TRANSLATE_NOOP("phenomena", "P's image is at infinity")
_OUT_OF_RANGE = QT_TRANSLATE_NOOP("phenomena", "{0} is beyond what float64 can hold in pixels")

_KINDS = (
    QT_TRANSLATE_NOOP("phenomena", "parallel projection"),
    QT_TRANSLATE_NOOP("phenomena", "1-point perspective"),
    QT_TRANSLATE_NOOP("phenomena", "2-point perspective"),
    QT_TRANSLATE_NOOP("phenomena", "3-point perspective"),
)
_LABELS = (
    QT_TRANSLATE_NOOP("phenomena", "V_x of edges along x"),
    QT_TRANSLATE_NOOP("phenomena", "V_y of edges along y"),
    QT_TRANSLATE_NOOP("phenomena", "V_z of edges along z"),
)
_HORIZON = QT_TRANSLATE_NOOP("phenomena", "horizon")
_AXES, _COLOURS = ("x", "y", "z"), ("u", "v", "n")

_VIEWS = {"1": (0.0, 0.0), "2": (40.0, 0.0), "3": (44.0, 30.0)}  # azimuth, elevation, degrees
_FRAMES = {
    name: Camera.from_orbit((0.0, 0.0, 0.0), Orbit(*view, 1.0)).frame
    for name, view in _VIEWS.items()
}
_LONGEST = 30.0  # of the box's size: marks of the world pane do not run farther
_WIDEST = 6.0  # image sides beside the frame that the diagram shows, at most


class Vanishing(NamedTuple):
    """Where one direction's edges vanish.

    Attributes
    ----------
    sign : float
        1 or -1: which way along the axis is away from the viewer.
    clip : (4,) array
        The direction that way through the lens' matrix; w is exactly 0 if it is at infinity.
    pixel : (2,) array or None
        None at infinity, or beyond float64's pixels.
    """

    sign: float
    clip: Array
    pixel: Array | None


def across(camera: Camera, axis: int) -> bool:
    """Whether ``n . D`` is 0 for this axis of the world, but for rounding.

    ``n . D`` is a coordinate of eye - target over their distance. Both coordinates are decimal
    numbers that were rounded to float64 by up to half an ulp: a difference of no more than these
    halves together is made of rounding. The largest part of n never is 0, however near the target.
    """
    if abs(camera.frame[2, axis]) > 0.5:
        return False
    eye, target = camera.eye[axis], camera.target[axis]
    return abs(eye - target) <= (math.ulp(eye) + math.ulp(target)) / 2.0


def vanishing(projection: Projection) -> tuple[Vanishing, Vanishing, Vanishing]:
    """The vanishing points of the world's x, y and z direction."""
    lens_matrix = projection.clip_from_view
    found = []
    for axis in range(3):
        x, y, z = projection.camera.frame[:, axis].tolist()
        sign = -1.0 if z > 0.0 else 1.0
        if projection.lens.central and across(projection.camera, axis):
            sign, z = 1.0, 0.0
        with np.errstate(over="ignore", invalid="ignore"):
            clip = lens_matrix @ (sign * np.array([x, y, z, 0.0])) + 0.0
        pixel = _pixel(projection, clip) if clip[3] > 0.0 else None
        found.append(Vanishing(sign, clip, pixel))
    return found[0], found[1], found[2]


def _pixel(projection: Projection, clip: Array) -> Array | None:
    """The pixel of a clip point whose w is not 0; None beyond what float64 can hold."""
    with np.errstate(over="ignore", invalid="ignore"):
        pixel = image_from_clip(projection, clip)
    return pixel if np.isfinite(pixel).all() else None


def drawn_angle_deg(projection: Projection, clip: Array) -> float | None:
    """Direction in the image of edges that vanish at infinity: 0 to 180 from the right.

    Returns
    -------
    float or None
        None for edges seen end on.
    """
    x, y = float(clip[0]) * projection.image_size[0], float(clip[1]) * projection.image_size[1]
    if x == 0.0 and y == 0.0:
        return None
    angle_deg = math.degrees(math.atan2(y, x)) % 180.0
    return 0.0 if angle_deg == 180.0 else angle_deg


def horizon(projection: Projection) -> tuple[float, float, float] | None:
    """The image of all horizontal directions, as a line.

    Returns
    -------
    a, b, c : float
        ``a x + b y = c`` for the line's pixels; None for a parallel lens, for a camera that looks
        straight up or down, and beyond float64's range.
    """
    if not projection.clip_from_view[3, :3].any():  # w is the same for all
        return None
    # Directions (X, Y, -1) of view space without a part along the world's y.
    a, b, c = projection.camera.frame[:, 1].tolist()
    if across(projection.camera, 0) and across(projection.camera, 2):
        return None
    m = projection.clip_from_view
    width, height = projection.image_size
    a, b = a / float(m[0, 0]), b / float(m[1, 1])
    c -= a * float(m[0, 2]) + b * float(m[1, 2])
    line = (2.0 * a / width, -2.0 * b / height, c + a - b)
    scale = max(abs(line[0]), abs(line[1]))
    if not (0.0 < scale < math.inf and math.isfinite(line[2] / scale)):
        return None
    return line[0] / scale, line[1] / scale, line[2] / scale


def line_in_rectangle(
    line: tuple[float, float, float], low: tuple[float, float], high: tuple[float, float]
) -> Array | None:
    """What a rectangle holds of the line ``a x + b y = c``, (2, 2), from left to right."""
    a, b, c = line
    if abs(a) > abs(b):  # the steeper way round
        turned = line_in_rectangle((b, a, c), low[::-1], high[::-1])
        return None if turned is None else np.ascontiguousarray(turned[:, ::-1])
    ends = np.array([(x, (c - a * x) / b) for x in (low[0], high[0])])
    (_, y_start), (_, y_end) = ends.tolist()
    t_low, t_high = 0.0, 1.0
    for start, end in ((y_start - low[1], y_end - low[1]), (high[1] - y_start, high[1] - y_end)):
        if start < 0.0 and end < 0.0:
            return None
        if start < 0.0:
            t_low = max(t_low, start / (start - end))
        elif end < 0.0:
            t_high = min(t_high, start / (start - end))
    if t_low > t_high:
        return None
    cut: Array = ends[0] + np.array([[t_low], [t_high]]) * (ends[1] - ends[0])
    return cut


# --------------------------------------------------------------------------- the running point


class Running(NamedTuple):
    """The point P = (1 - t) (C, 1) + t (s D, 0) that runs along an edge to infinity and beyond.

    Attributes
    ----------
    w : float
        Its homogeneous w in the world, 1 - t: 0 at infinity.
    world : (3,) array or None
        None at infinity.
    clip : (4,) array
    pixel : (2,) array or None
        Its image after the divide, the projective one: also where P is behind the eye. None at
        infinity.
    """

    w: float
    world: Array | None
    clip: Array
    pixel: Array | None


def running(
    projection: Projection, start: tuple[Array, Array], toward: tuple[Array, Array], t: float
) -> Running:
    """Where P is.

    Parameters
    ----------
    projection : Projection
    start : ((3,) array, (4,) array)
        C, in the world and in clip space.
    toward : ((3,) array, (4,) array)
        s D, the way that P has made at t = 1/2: in the world, and ``(s D, 0)`` in clip space.
    t : float
    """
    w = 1.0 - t
    world = None if w == 0.0 else start[0] + (t / w) * toward[0]
    at = w * start[1] + t * toward[1]
    return Running(w, world, at, _pixel(projection, at) if at[3] != 0.0 else None)


# --------------------------------------------------------------------------- what is shown


def _geometry() -> tuple[Coloured, Coloured]:
    block = box_faces((-1.2, 0.0, -1.0), (1.2, 2.4, 1.0))
    shades = (SIDE_RGB * 0.5 + 127.0).astype(np.uint8)
    floors = [edges_of(box_faces((-1.2, 0.0, -1.0), (1.2, y, 1.0)))[0] for y in (0.8, 1.6)]
    columns = [edges_of(box_faces((-1.2, 0.0, -1.0), (x, 2.4, 1.0)))[0] for x in (-0.4, 0.4)]
    further = np.concatenate([*floors, *columns])
    lines = joined(
        ground_grid((-5.0, -12.0), (5.0, 5.0), (1.0, 1.0), 0.0),
        edges_of(block),
        (further, flat(EDGE_RGB, len(further))),
    )
    return (block, shades), lines


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    points = vanishing(projection)
    axis = _AXES.index(str(settings["edge"]))
    point = points[axis]
    edges = box_edges(subject.lower, subject.upper)
    # The edge of P: of the upper ones the nearest to the viewer; C is its nearer end.
    trace = projection.trace(edges)
    w = -trace.view[..., 2]
    heights = edges[axis, :, :, 1].sum(axis=1)
    row = int(np.where(heights == heights.max(), w[axis].sum(axis=1), np.inf).argmin())
    near_end = 0 if point.sign > 0.0 else 1
    start = edges[axis, row, near_end]
    toward = edges[axis, row, 1 - near_end] - start
    size = float(np.abs(toward).max())
    # A flat box (a mesh of the user's) has edges without length; P runs along them all the same.
    if size == 0.0:
        size = subject.size
        toward = size * point.sign * np.eye(3)[axis]
    from_corner = (start, trace.clip[axis, row, near_end])
    there = running(projection, from_corner, (toward, size * point.clip), number(settings, "t"))

    finite = sum(p.clip[3] > 0.0 for p in points)
    readings = [Reading(QT_TRANSLATE_NOOP("phenomena", "kind of projection"), _KINDS[finite])]
    readings += [_pixel_reading(projection, number, p) for number, p in enumerate(points)]
    why_no_v = readings[1 + axis].note
    readings += _running_readings(point, there, why_no_v)
    return Illustration(
        tuple(readings),
        world=_world_marks(projection, points, subject, start, there),
        image=_image_marks(projection, points, trace.clip, from_corner[1], there),
        diagrams=_diagrams(projection, points, trace),
        warning=of_parallel(projection, _PARALLEL),
    )


def _pixel_reading(projection: Projection, axis: int, point: Vanishing) -> Reading:
    label, name = _LABELS[axis], _AXES[axis]
    if point.pixel is not None:
        x, y = point.pixel.tolist()
        return Reading(label, (x, y), "px")
    if point.clip[3] > 0.0:
        return Reading(label, None, "px", Phrase(_OUT_OF_RANGE, (f"V_{name}",)))
    angle_deg = drawn_angle_deg(projection, point.clip)
    if angle_deg is None:
        return Reading(label, None, "px", Phrase(_END_ON, (name,)))
    return Reading(label, None, "px", Phrase(_AT_INFINITY, (name, float(angle_deg))))


def _running_readings(point: Vanishing, at: Running, why_no_v: Phrase | None) -> list[Reading]:
    pixel: tuple[float, ...] | None = None
    rest: float | None = None
    note = None
    if at.pixel is None:
        note = Phrase(_P_AT_INFINITY) if at.clip[3] == 0.0 else Phrase(_OUT_OF_RANGE, ("P",))
    else:
        pixel = tuple(at.pixel.tolist())
    if at.pixel is not None and point.pixel is not None:
        rest = math.dist(at.pixel, point.pixel)
    why_no_rest = note if point.pixel is not None else why_no_v
    to_v = QT_TRANSLATE_NOOP("phenomena", "from P to V")
    return [
        Reading(QT_TRANSLATE_NOOP("phenomena", "w of P = (1 − t)·C + t·(D : 0)"), at.w),
        Reading(QT_TRANSLATE_NOOP("phenomena", "image of P"), pixel, "px", note),
        Reading.or_why(to_v, rest, "px", why_no_rest),
    ]


def _image_marks(
    projection: Projection,
    points: tuple[Vanishing, ...],
    edges_clip: Array,
    start_clip: Array,
    there: Running,
) -> Marks:
    starts, ends, axes = [], [], []
    for axis, point in enumerate(points):
        if point.clip[3] > 0.0:  # from the edges' farther ends on
            starts += list(edges_clip[axis, :, 1 if point.sign > 0.0 else 0])
            ends += [point.clip] * 4
            axes += [axis] * 4
    pieces = cut_in_picture(
        projection, np.array([*starts, start_clip]), np.array([*ends, there.clip]), SIDES
    )
    marks: list[Mark] = [
        Line(piece, _COLOURS[axis], 1.0)
        for piece, axis in zip(pieces[:-1], axes, strict=True)
        if piece is not None
    ]
    # The line from C to P, as long as the projective line between them is the one in front.
    if pieces[-1] is not None:
        marks.append(Line(pieces[-1], "accent", 2.0))
    size = projection.image_size
    names = [(f"V_{axis}", point.pixel) for axis, point in zip(_AXES, points, strict=True)]
    for (name, pixel), colour in zip(
        [*names, ("P", there.pixel)], (*_COLOURS, "accent"), strict=True
    ):
        if pixel is not None and (pixel >= 0.0).all() and (pixel <= size).all():
            marks.append(named(name, pixel, colour, 1.4))
    line = horizon(projection)
    held = None if line is None else line_in_rectangle(line, (0.0, 0.0), size)
    if held is not None:
        marks += [Line(held, "ink", 1.0), Text(_HORIZON, held[0] + 0.25 * (held[1] - held[0]))]
    return Marks.of(*marks)


def _world_marks(
    projection: Projection,
    points: tuple[Vanishing, ...],
    subject: Subject,
    start: Array,
    there: Running,
) -> Marks:
    """Rays from the eye parallel to the box's edges, and where they meet the near plane."""
    eye = np.array(projection.camera.eye)
    longest = _LONGEST * subject.size
    marks: list[Mark] = []
    for axis, (point, colour) in enumerate(zip(points, _COLOURS, strict=True)):
        if point.clip[3] <= 0.0:
            continue
        direction = point.sign * np.eye(3)[axis]
        length = projection.lens.near / abs(float(projection.camera.frame[2, axis]))
        reach = min(length, longest)
        hit = eye + reach * direction
        marks.append(Line(np.array([eye, hit]), colour, 1.5))
        if length <= longest:
            marks.append(named(f"V_{_AXES[axis]}", hit, colour))
    if there.world is not None:
        offset = there.world - start
        far = float(np.abs(offset).max())
        end = there.world if far <= longest else start + offset * (longest / far)
        marks.append(Line(np.array([start, end]), "accent", 2.0))
        if far <= longest:
            marks.append(named("P", there.world))
    return Marks.of(*marks)


def _diagrams(
    projection: Projection, points: tuple[Vanishing, ...], edges: Trace
) -> tuple[Diagram, ...]:
    """The frame with as much around it as brings the vanishing points into view."""
    width, height = projection.image_size
    low, high = np.zeros(2), np.array([width, height], dtype=float)
    most = _WIDEST * np.array([width, height])
    shown = []
    for axis, point in enumerate(points):
        pixel = point.pixel
        if pixel is not None and (pixel >= -most).all() and (pixel <= high + most).all():
            shown.append((axis, pixel))
    for _, pixel in shown:
        low, high = np.minimum(low, pixel), np.maximum(high, pixel)
    margin = 0.06 * float((high - low).max())
    low, high = low - margin, high + margin
    curves = [Curve(rectangle(width, height), "muted", width=1.5, closed=True)]
    image = edges.image
    # A box beside the eye or behind it has edges without a picture.
    if edges.in_front.all() and (np.abs(image) <= most + high).all():
        for axis, pixel in shown:
            ends = image[axis, :, 1 if points[axis].sign > 0.0 else 0]
            guides = np.stack([ends, np.broadcast_to(pixel, (4, 2))], axis=1)
            curves.append(Curve(broken(guides), _COLOURS[axis], width=0.7))
        curves.append(Curve(broken(image.reshape(12, 2, 2)), "ink", width=1.5))
    line = horizon(projection)
    held = None
    if line is not None:
        held = line_in_rectangle(line, (low[0], low[1]), (high[0], high[1]))
    if held is not None:
        curves.append(Curve(held, "ink", _HORIZON, 1.2))
    for axis, pixel in shown:
        curves.append(Curve(pixel[None], _COLOURS[axis], f"V_{_AXES[axis]}", dots=True))
    return (
        Diagram(
            QT_TRANSLATE_NOOP("phenomena", "Vanishing points"),
            tuple(curves),
            *(float(low[0]), float(high[0]), float(high[1]), float(low[1])),
            x_label="x (px)",
            y_label="y (px)",
            equal=True,
        ),
    )


def _follow(projection: Projection, before: Found, after: Settings) -> Projection:
    view = _VIEWS.get(str(after["points"]))
    if before["points"] == after["points"] or view is None:
        return projection
    camera = projection.camera
    turned = Camera.from_orbit(camera.target, Orbit(*view, camera.distance))
    return replace(projection, camera=turned).with_eye()


def _found(projection: Projection, settings: Settings) -> Found:
    frame = projection.camera.frame
    views = (name for name, one in _FRAMES.items() if np.abs(frame - one).max() <= CLOSE)
    return {"points": next(views, "free") if projection.lens.central else "free"}


PHENOMENON = Phenomenon(
    name="vanishing-points",
    title=QT_TRANSLATE_NOOP("phenomena", "Vanishing points"),
    explanation=QT_TRANSLATE_NOOP(
        "phenomena",
        "Edges that are parallel in the world meet in the image, at the vanishing point of their"
        " direction: where the ray from the eye along it meets the picture. A direction parallel to"
        " the picture has none, so a box has one, two or three. As w of the point P goes to 0, P"
        " runs to infinity, and its image to the vanishing point.",
    ),
    tries=(
        QT_TRANSLATE_NOOP("phenomena", "Which edges meet, and where?"),
        QT_TRANSLATE_NOOP("phenomena", "Drag t to 1: where does P go?"),
        QT_TRANSLATE_NOOP("phenomena", "Turn the azimuth: when is V at infinity?"),
    ),
    lectures=("002", "003"),
    start=Projection(
        Camera.from_orbit((0.0, 1.3, 0.0), Orbit(*_VIEWS["2"], 6.0)),
        # As far from the eye as no ground is seen before it: room for the marks on the near plane.
        Perspective(fov_y_deg=70.0, near=3.2, far=11.0),
    ),
    geometry=_geometry,
    show=_show,
    settings=(
        Setting(
            "points",
            QT_TRANSLATE_NOOP("phenomena", "Perspective"),
            QT_TRANSLATE_NOOP("phenomena", "Turns the camera about its target"),
            "2",
            choices=(
                ("1", QT_TRANSLATE_NOOP("phenomena", "1-point")),
                ("2", QT_TRANSLATE_NOOP("phenomena", "2-point")),
                ("3", QT_TRANSLATE_NOOP("phenomena", "3-point")),
                ("free", QT_TRANSLATE_NOOP("phenomena", "Free: turn the camera yourself")),
            ),
        ),
        Setting(
            "edge",
            QT_TRANSLATE_NOOP("phenomena", "P runs along"),
            QT_TRANSLATE_NOOP("phenomena", "The direction D of the edge that P follows"),
            "z",
            choices=tuple((axis, axis) for axis in _AXES),
        ),
        Setting(
            "t",
            QT_TRANSLATE_NOOP("phenomena", "t, to infinity at 1"),
            QT_TRANSLATE_NOOP(
                "phenomena",
                "P = (1 − t)·C + t·(D : 0): at the corner C for 0, at infinity for 1, beyond it,"
                " coming back from the other side, above 1",
            ),
            0.6,
            low=0.0,
            high=2.0,
            per_second=0.15,
        ),
    ),
    controls=("camera.azimuth_deg",),
    numbers=4,
    leading="image",
    follow=_follow,
    found=_found,
    own_mesh=True,
)
