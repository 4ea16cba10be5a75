"""Vanishing points: where the images of parallel edges meet, and when they do not.

Points ``(C + s D, 1)`` of an edge along D are ``(C/s + D, 1/s)``: as s grows, w goes to 0 and the
point to the direction ``(D, 0)``, a point at infinity (lecture 002, homogeneous coordinates). Its
image is the vanishing point of every edge along D. If D is parallel to the image, or the lens is
parallel, the image is at infinity too, and the edges stay parallel. The number of a box's three
directions with a vanishing point names the perspective: 1-, 2- or 3-point (lecture 002).
"""

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from app.model.limits import vector
from app.model.parameter import CLOSE, ImpliedSettings, Settings, number
from app.model.projection import Array, Camera, Orbit, Perspective, Projection, Trace
from app.scenes.phenomena import picture
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Grip, Mark, Marks, Polyline, Text, named, plate, segment
from app.scenes.phenomena.words import Curve, Diagram, PhenomenonWords, Reading, broken
from app.scenes.shapes import SIDE_RGB, Coloured, box_faces, edges_of, ground_grid, joined

WORDS = PhenomenonWords("vanishing-points")

_AXES, _COLOURS = ("x", "y", "z"), ("u", "v", "n")
_VIEWS = {"1": (0.0, 0.0), "2": (40.0, 0.0), "3": (44.0, 30.0)}  # azimuth, elevation, degrees
_FRAMES = {
    name: Camera.from_orbit((0.0, 0.0, 0.0), Orbit(*view, 1.0)).frame
    for name, view in _VIEWS.items()
}
_LONGEST = 30.0  # times the box's size: the longest mark of the world pane
_WIDEST = 6.0  # times the image's size: the most that the diagram shows beside the frame


class Vanishing(NamedTuple):
    """Where the edges along one axis vanish.

    `sign`, 1 or -1, says which way along the axis is away from the viewer. `clip` (4,) is that
    direction; w is exactly 0 if the image is at infinity. `pixel` (2,) is None there, and beyond
    float64's pixels.
    """

    sign: float
    clip: Array
    pixel: Array | None

    @property
    def is_finite(self) -> bool:
        return bool(self.clip[3] > 0.0)

    @property
    def far_end(self) -> int:
        """Which end, 0 or 1, of an edge along the axis is away from the viewer."""
        return 1 if self.sign > 0.0 else 0


def across(camera: Camera, axis: int) -> bool:
    """Whether ``n . D`` is 0 for this axis of the world, but for rounding.

    ``n . D`` is a coordinate of eye - target over their distance. Both coordinates are decimal
    numbers, rounded to float64 by up to half an ulp: a difference of no more than these halves
    together comes from rounding. The largest part of n is never 0, however near the target is.
    """
    if abs(camera.frame[2, axis]) > 0.5:
        return False
    eye, target = camera.eye[axis], camera.target[axis]
    return abs(eye - target) <= (math.ulp(eye) + math.ulp(target)) / 2.0


def vanishing(projection: Projection) -> tuple[Vanishing, Vanishing, Vanishing]:
    """The vanishing points of the world's x, y and z direction."""
    lens_matrix = projection.clip_from_view
    points = []
    for axis in range(3):
        x, y, z = projection.camera.frame[:, axis].tolist()
        sign = -1.0 if z > 0.0 else 1.0
        if projection.lens.central and across(projection.camera, axis):
            sign, z = 1.0, 0.0
        with np.errstate(over="ignore", invalid="ignore"):
            clip = lens_matrix @ (sign * np.array([x, y, z, 0.0])) + 0.0
        pixel = _pixel(projection, clip) if clip[3] > 0.0 else None
        points.append(Vanishing(sign, clip, pixel))
    return points[0], points[1], points[2]


def _pixel(projection: Projection, clip: Array) -> Array | None:
    """The pixel of a clip point whose w is not 0; None beyond float64's range."""
    with np.errstate(over="ignore", invalid="ignore"):
        pixel = picture.image_from_clip(projection, clip)
    return pixel if np.isfinite(pixel).all() else None


def drawn_angle_deg(projection: Projection, clip: Array) -> float | None:
    """Direction in the image of edges that vanish at infinity, 0 to 180 degrees from the right.

    None for edges seen end on.
    """
    x, y = float(clip[0]) * projection.image_size[0], float(clip[1]) * projection.image_size[1]
    if x == 0.0 and y == 0.0:
        return None
    angle_deg = math.degrees(math.atan2(y, x)) % 180.0
    return 0.0 if angle_deg == 180.0 else angle_deg


def horizon(projection: Projection) -> tuple[float, float, float] | None:
    """The image of all horizontal directions: a, b, c of the line of pixels ``a x + b y = c``.

    None for a parallel lens, for a camera that looks straight up or down, and beyond float64's
    range.
    """
    if not projection.clip_from_view[3, :3].any():  # w is the same for all
        return None
    if across(projection.camera, 0) and across(projection.camera, 2):
        return None
    # Directions (X, Y, -1) of view space without a part along the world's y.
    a, b, c = projection.camera.frame[:, 1].tolist()
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
    line: tuple[float, float, float] | None, low: tuple[float, float], high: tuple[float, float]
) -> Array | None:
    """The part of the line ``a x + b y = c`` inside a rectangle, from left to right, (2, 2)."""
    if line is None:
        return None
    a, b, c = line
    if abs(a) > abs(b):  # a steep line is solved for x
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
    return np.asarray(ends[0] + np.array([[t_low], [t_high]]) * (ends[1] - ends[0]))


class Running(NamedTuple):
    """The point P = (1 - t) (C, 1) + t (s D, 0) that runs along an edge to infinity and beyond.

    Its w in the world is 1 - t: 0 at infinity, where it has no world point (3,) and no pixel. A P
    behind the eye has the pixel of the divide.
    """

    w: float
    world: Array | None
    clip: Array
    pixel: Array | None


def running(
    projection: Projection, start: tuple[Array, Array], toward: tuple[Array, Array], t: float
) -> Running:
    """Return the position of P.

    `start` is C in the world (3,) and over s in clip space (4,), `toward` is s D, the way that P
    has made at t = 1/2, and D: at infinity P has the pixel of its vanishing point.
    """
    w = 1.0 - t
    world = None if w == 0.0 else start[0] + (t / w) * toward[0]
    at = w * start[1] + t * toward[1]
    return Running(w, world, at, _pixel(projection, at) if at[3] != 0.0 else None)


def _geometry() -> tuple[Coloured, Coloured]:
    block = box_faces((-1.2, 0.0, -1.0), (1.2, 2.4, 1.0))
    shades = (SIDE_RGB * 0.5 + 127.0).astype(np.uint8)
    corners = (1.2, 0.8, 1.0), (1.2, 1.6, 1.0), (-0.4, 2.4, 1.0), (0.4, 2.4, 1.0)
    floors = (edges_of(box_faces((-1.2, 0.0, -1.0), each)) for each in corners)
    grid = ground_grid((-5.0, -12.0), (5.0, 5.0), (1.0, 1.0), 0.0)
    return (block, shades), joined(grid, edges_of(block), *floors)


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    points = vanishing(projection)
    axis = _AXES.index(str(settings["edge"]))
    point = points[axis]
    edges = picture.box_edges(subject.lower, subject.upper)
    # P runs along the upper edge nearest to the viewer, from C, its nearer end.
    trace = projection.trace(edges)
    w = -trace.view[..., 2]
    heights = edges[axis, :, :, 1].sum(axis=1)
    row = int(np.where(heights == heights.max(), w[axis].sum(axis=1), np.inf).argmin())
    near_end = 1 - point.far_end
    start = edges[axis, row, near_end]
    toward = edges[axis, row, point.far_end] - start
    size = float(np.abs(toward).max())
    if size == 0.0:  # the edges of a flat mesh may have no length
        size = subject.size
        toward = size * point.sign * np.eye(3)[axis]
    from_corner = (start, trace.clip[axis, row, near_end] / size)
    there = running(projection, from_corner, (toward, point.clip), number(settings, "t"))
    return Illustration(
        _readings(projection, points, axis, there),
        world=_world_marks(projection, points, subject, start, there),
        image=_image_marks(projection, points, trace.clip, from_corner[1], there),
        diagrams=(_diagram(projection, points, trace),),
        grips=(_grip(start, toward, there.world),),
        warning=WORDS.of_parallel(projection),
    )


def _grip(start: Array, toward: Array, there: Array | None) -> Grip:
    """P on its way; at infinity it cannot be taken, but a drag goes through it."""
    place = np.full(3, np.nan) if there is None else there
    return Grip("t", place, vector(start), (*(toward - start).tolist(), -1.0), "P")


def _readings(
    projection: Projection, points: tuple[Vanishing, ...], axis: int, at: Running
) -> tuple[Reading, ...]:
    of_points = [_pixel_reading(projection, *each) for each in zip(_AXES, points, strict=True)]
    pixel: tuple[float, ...] | None = None
    rest: float | None = None
    note = None
    if at.pixel is not None:
        pixel = tuple(at.pixel.tolist())
    elif at.clip[3] == 0.0:
        note = WORDS.phrase("p-at-infinity")
    else:
        note = WORDS.phrase("out-of-range", "P")
    why = note
    if (goal := points[axis].pixel) is None:
        why = of_points[axis].note
    elif at.pixel is not None:
        rest = math.dist(at.pixel, goal)
    return (
        Reading(WORDS["kind"], WORDS[f"kind-{sum(each.is_finite for each in points)}"]),
        *of_points,
        Reading(WORDS["w"], at.w),
        Reading(WORDS["image"], pixel, "px", note),
        Reading.or_why(WORDS["to-v"], rest, "px", why),
    )


def _pixel_reading(projection: Projection, name: str, point: Vanishing) -> Reading:
    if point.pixel is not None:
        x, y = point.pixel.tolist()
        return Reading(WORDS[name], (x, y), "px")
    if point.is_finite:
        note = WORDS.phrase("out-of-range", f"V_{name}")
    elif (angle_deg := drawn_angle_deg(projection, point.clip)) is None:
        note = WORDS.phrase("end-on", name)
    else:
        note = WORDS.phrase("at-infinity", name, angle_deg)
    return Reading(WORDS[name], None, "px", note)


def _image_marks(
    projection: Projection,
    points: tuple[Vanishing, ...],
    edges_clip: Array,
    start_clip: Array,
    there: Running,
) -> Marks:
    starts, ends, colours = [], [], []
    for axis, point in enumerate(points):
        if point.is_finite:  # from the edges' farther ends on
            starts += list(edges_clip[axis, :, point.far_end])
            ends += [point.clip] * 4
            colours += [_COLOURS[axis]] * 4
    both = np.array([*starts, start_clip]), np.array([*ends, there.clip])
    *pieces, run = picture.cut_in_picture(projection, *both, picture.SIDES)
    drawn = zip(pieces, colours, strict=True)
    marks: list[Mark] = [Polyline(each, colour, 1.0) for each, colour in drawn if each is not None]
    # From C to P, as long as their part of the projective line is in front of the eye.
    if run is not None:
        marks.append(Polyline(run, "accent", 2.0))
    size = projection.image_size
    names = [f"V_{axis}" for axis in _AXES], [point.pixel for point in points], _COLOURS
    for name, pixel, colour in [*zip(*names, strict=True), ("P", there.pixel, "accent")]:
        if pixel is not None and (pixel >= 0.0).all() and (pixel <= size).all():
            marks.append(named(name, pixel, colour, 1.4))
    held = line_in_rectangle(horizon(projection), (0.0, 0.0), size)
    if held is not None:
        place = held[0] + 0.25 * (held[1] - held[0])
        marks += [Polyline(held, "ink", 1.0), Text("horizon", place, text=WORDS["horizon"])]
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
    # Of the frustum, whose walls would hide the rays, only the plane is drawn, with the horizon.
    plane = picture.section(projection, projection.lens.near)
    marks: list[Mark] = [plate(plane, "near", 1.5, 0.15, name="horizon")]
    for axis, (point, colour) in enumerate(zip(points, _COLOURS, strict=True)):
        if not point.is_finite:
            continue
        length = projection.lens.near / abs(float(projection.camera.frame[2, axis]))
        hit = eye + min(length, longest) * (point.sign * np.eye(3)[axis])
        marks.append(segment(eye, hit, colour, 1.5))
        if length <= longest:
            marks.append(named(f"V_{_AXES[axis]}", hit, colour))
    if there.world is not None:
        offset = there.world - start
        far = float(np.abs(offset).max())
        end = there.world if far <= longest else start + offset * (longest / far)
        marks.append(segment(start, end, "accent", 2.0))
        if far <= longest:
            marks.append(named("P", there.world))
    return Marks.of(*marks)


def _diagram(projection: Projection, points: tuple[Vanishing, ...], edges: Trace) -> Diagram:
    """The frame, and as much around it as brings the vanishing points into view."""
    width, height = projection.image_size
    low, high = np.zeros(2), np.array([width, height], dtype=float)
    most = _WIDEST * high
    beyond = most + high
    shown = []
    for axis, point in enumerate(points):
        pixel = point.pixel
        if pixel is not None and (pixel >= -most).all() and (pixel <= beyond).all():
            shown.append((axis, pixel))
    for _, pixel in shown:
        low, high = np.minimum(low, pixel), np.maximum(high, pixel)
    margin = 0.06 * float((high - low).max())
    low, high = low - margin, high + margin
    curves = [Curve(picture.rectangle(width, height), "muted", width=1.5, closed=True)]
    image = edges.image
    # A box beside the eye or behind it has edges without a picture.
    if edges.in_front.all() and (np.abs(image) <= beyond).all():
        for axis, pixel in shown:
            ends = image[axis, :, points[axis].far_end]
            guides = np.stack([ends, np.broadcast_to(pixel, (4, 2))], axis=1)
            curves.append(Curve(broken(guides), _COLOURS[axis], width=0.7))
        curves.append(Curve(broken(image.reshape(12, 2, 2)), "ink", width=1.5))
    held = line_in_rectangle(horizon(projection), (low[0], low[1]), (high[0], high[1]))
    if held is not None:
        curves.append(Curve(held, "ink", WORDS["horizon"], 1.2))
    for axis, pixel in shown:
        curves.append(Curve(pixel[None], _COLOURS[axis], f"V_{_AXES[axis]}", dots=True))
    return Diagram(
        WORDS["diagram"],
        tuple(curves),
        *(float(low[0]), float(high[0]), float(high[1]), float(low[1])),
        x_label="x (px)",
        y_label="y (px)",
        equal=True,
    )


def _follow(projection: Projection, before: ImpliedSettings, after: Settings) -> Projection:
    view = _VIEWS.get(str(after["points"]))
    if before["points"] == after["points"] or view is None:
        return projection
    camera = projection.camera
    turned = Camera.from_orbit(camera.target, Orbit(*view, camera.distance))
    return replace(projection, camera=turned).with_eye()


def _implied(projection: Projection, settings: Settings) -> ImpliedSettings:
    frame = projection.camera.frame
    views = (name for name, one in _FRAMES.items() if np.abs(frame - one).max() <= CLOSE)
    return {"points": next(views, "free") if projection.lens.central else "free"}


PHENOMENON = Phenomenon.of(
    WORDS,
    start=Projection(
        Camera.from_orbit((0.0, 1.3, 0.0), Orbit(*_VIEWS["2"], 6.0)),
        # No ground is seen before the near plane, so that there is room for the marks on it.
        Perspective(70.0, 3.2, 11.0),
    ),
    geometry=_geometry,
    show=_show,
    follow=_follow,
    implied=_implied,
)
