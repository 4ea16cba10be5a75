"""Lens and focus: what a real camera's lens adds to the pinhole, computed and not simulated.

Lecture 001 names the focal distance (what is in focus) and the depth of field (how far before and
behind it things are acceptably sharp) among a camera's parameters. For a thin lens of focal length
f, opened to ``A = f/N`` and focused at the distance s, a point at distance D is drawn as a disc of
diameter ``b = A f |D - s| / (D (s - f))`` on the film; where b is the largest that still passes for
a point, the circle of confusion c, are the limits of sharpness (S. F. Ray, *Applied Photographic
Optics*, 3rd ed., 2002)::

    H = f^2/(N c) + f        near = s (H - f)/(H + s - 2 f)        far = s (H - f)/(H - s)

with the hyperfocal distance H: focused there or beyond, the far limit is infinity.

The focal length is the lens' own: that of a 36 x 24 mm camera with the same diagonal field of view.
The lens is in the eye, distances are measured along the view direction, and one world unit is 1 m.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from app.model.lenses.central import FULL_FRAME_DIAGONAL_MM
from app.model.projection import Array, Camera, Perspective, Projection
from app.model.refusal import QT_TRANSLATE_NOOP
from app.scenes.phenomena.diagram import Curve, Diagram
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Dot, Face, Line, Mark, Marks, Text, plate
from app.scenes.phenomena.picture import section, seen, seen_lines
from app.scenes.phenomena.readout import Phrase, Reading
from app.scenes.phenomena.settings import Setting, Settings, number
from app.scenes.shapes import (
    EDGE_RGB,
    SIDE_RGB,
    Coloured,
    box_faces,
    edges_of,
    flat,
    ground_grid,
    joined,
    written_number,
)

_MM = 1e-3  # in world units, which are metres

_PARALLEL = QT_TRANSLATE_NOOP(
    "phenomena", "a parallel lens has no focal length: choose a perspective lens to focus it"
)
_TOO_CLOSE = QT_TRANSLATE_NOOP(
    "phenomena",
    "the focal distance {0} m is not beyond the focal length {1} m: nothing so close has an image",
)
_TO_INFINITY = QT_TRANSLATE_NOOP(
    "phenomena", "∞: focused at the hyperfocal distance or beyond, all that is far away is sharp"
)

_BOUNDLESS = QT_TRANSLATE_NOOP(
    "phenomena", "the target is so close to the lens that its disc has no finite size"
)

_ELLIPSE = QT_TRANSLATE_NOOP(
    "phenomena",
    "the picture is stretched: the target's disc is drawn as an ellipse, so wide and so high",
)

SHARP_FROM = QT_TRANSLATE_NOOP("phenomena", "sharp from")
SHARP_TO = QT_TRANSLATE_NOOP("phenomena", "sharp to")
IN_FOCUS = QT_TRANSLATE_NOOP("phenomena", "in focus")
SHARP = QT_TRANSLATE_NOOP("phenomena", "sharp")


class Sharpness(NamedTuple):
    """The range of sharpness of a focused lens, in metres.

    Attributes
    ----------
    near, far : float
        Its limits; `far` is infinite from the hyperfocal distance on.
    hyperfocal : float
    """

    near: float
    far: float
    hyperfocal: float


def sharpness(f_mm: float, f_number: float, focus: float, confusion_mm: float) -> Sharpness:
    """The limits of sharpness, as at the top of this module.

    Parameters
    ----------
    f_mm : float
        Focal length.
    f_number : float
        N: the lens is opened to f/N.
    focus : float
        Distance focused at, in m; greater than the focal length.
    confusion_mm : float
        Largest diameter on the film that passes for a point.
    """
    f = f_mm * _MM
    reach = f * (f_mm / f_number / confusion_mm)  # H - f
    share = (focus - f) / reach  # both formulas divided by H - f: no digit of it is lost in a sum
    near = focus / (1.0 + share)
    far = focus / (1.0 - share) if share < 1.0 else math.inf
    return Sharpness(near, far, reach + f)


def blur_mm(f_mm: float, f_number: float, focus: float, distances: Array) -> Array:
    """Diameter on the film of the disc as which points at these distances (m) are drawn, in mm."""
    opening_mm = f_mm / f_number
    magnification = f_mm * _MM / (focus - f_mm * _MM)
    discs: Array = opening_mm * magnification * np.abs(1.0 - focus / distances)
    return discs


_POSTS = (2, 3, 4, 5, 6, 8, 10, 12, 15, 20)
_HALF, _HIGH = 0.15, 1.4  # of a post: half its width and depth, and its height
_MOST_VERTICES = 400  # of the user's mesh that are marked where they are sharp


def _post_places() -> list[tuple[float, float]]:
    """How far each post is to the right, and away from the eye."""
    places = []
    tangent = -0.4  # of the angle from the axis to the next post's left side
    for distance in _POSTS:
        places.append((tangent * distance + _HALF, float(distance)))
        tangent += 2.0 * _HALF / distance + 0.025
    return places


_POST_PLACES = np.array(_post_places())
_FRONTS = np.array(
    [
        [(x + side, y, _HALF - away) for side, y in (
            (-_HALF, 0.0), (_HALF, 0.0), (_HALF, _HIGH), (-_HALF, _HIGH))]
        for x, away in _POST_PLACES
    ]
)  # fmt: skip
"""The corners of the posts' faces with the numbers, (n, 4, 3), world coordinates."""


def _geometry() -> tuple[Coloured, Coloured]:
    """Posts with their distances from the eye in m on them, beside each other in the picture."""
    faces: list[Coloured] = []
    boxes = []
    for distance, (x, _) in zip(_POSTS, _POST_PLACES.tolist(), strict=True):
        lower, upper = (x - _HALF, 0.0, -distance - _HALF), (x + _HALF, _HIGH, _HALF - distance)
        box = box_faces(lower, upper)
        digits = written_number(distance, (x, 1.1, -distance + 0.155), 0.22)
        faces += [(box, SIDE_RGB), (digits, flat(EDGE_RGB, len(digits)))]
        boxes.append(box)
    ground = ground_grid((-4.0, -24.0), (8.0, 0.0), (1.0, 1.0), 0.0)
    return joined(*faces), joined(ground, edges_of(np.concatenate(boxes)))


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    n, focus, c_mm = (number(settings, name) for name in ("aperture", "focus", "confusion"))
    angles = projection.lens.angles(Fraction(*projection.image_size))
    if angles is None:
        note = Phrase(_PARALLEL)
        readings = (*_readings(None, None, None, note), _target_reading(None, note))
        return Illustration(readings, warning=note)
    f_mm = angles.focal_mm
    if focus <= f_mm * _MM:
        note = Phrase(_TOO_CLOSE, (focus, f_mm * _MM))
        readings = (*_readings(f_mm, f_mm / n, None, note), _target_reading(None, note))
        return Illustration(readings, warning=note)
    sharp = sharpness(f_mm, n, focus, c_mm)
    with np.errstate(over="ignore"):
        target = np.array(projection.camera.distance)
        disc_mm = float(blur_mm(f_mm, n, focus, target))
    return Illustration(
        (
            *_readings(f_mm, f_mm / n, sharp, Phrase(_TO_INFINITY)),
            _drawn_disc(projection, disc_mm),
        ),
        world=_planes(projection, focus, sharp, subject),
        ndc=_planes_ndc(projection, focus, sharp),
        image=_sharp_in_picture(projection, f_mm, n, focus, sharp, subject),
        diagrams=(_diagram(f_mm, n, focus, c_mm, sharp),),
        measured=(("s", focus),) if projection.lens.near <= focus <= projection.lens.far else (),
    )


def _readings(
    f_mm: float | None, opening_mm: float | None, sharp: Sharpness | None, note: Phrase
) -> tuple[Reading, ...]:
    """The lens' readout; what there is not is None, and `note` says why."""
    near = far = depth = hyperfocal = None
    if sharp is not None:
        near, hyperfocal = sharp.near, sharp.hyperfocal
        if sharp.far < math.inf:
            far, depth = sharp.far, sharp.far - sharp.near
    lines = (
        (SHARP_FROM, near, "m"),
        (SHARP_TO, far, "m"),
        (QT_TRANSLATE_NOOP("phenomena", "depth of field"), depth, "m"),
        (QT_TRANSLATE_NOOP("phenomena", "hyperfocal distance H"), hyperfocal, "m"),
        (QT_TRANSLATE_NOOP("phenomena", "focal length f"), f_mm, "mm"),
        (QT_TRANSLATE_NOOP("phenomena", "opening f / N"), opening_mm, "mm"),
    )
    return tuple(Reading.or_why(*line, note) for line in lines)


def _drawn_disc(projection: Projection, disc_mm: float) -> Reading:
    """The target's disc in the picture: its diameter, or both of an ellipse."""
    across, up = (disc_mm * px for px in _px_per_mm(projection))
    stretched = across != up
    blur_px = (across, up) if stretched else (across,)
    if not np.isfinite(blur_px).all():
        return _target_reading(None, Phrase(_BOUNDLESS))
    return _target_reading(blur_px, Phrase(_ELLIPSE)) if stretched else _target_reading(blur_px[0])


def _px_per_mm(projection: Projection) -> tuple[float, float]:
    """What of the picture is a millimetre of the film, across and up: one value if not stretched.

    The film is as long from corner to corner as 36 x 24 mm are, and shaped like the window.
    """
    left, right, bottom, top = projection.window
    window = right - left, top - bottom
    if math.isclose(window[0] / window[1], projection.aspect, rel_tol=1e-6):
        per_mm = math.hypot(*projection.image_size) / FULL_FRAME_DIAGONAL_MM
        return per_mm, per_mm
    film_mm = [side * (FULL_FRAME_DIAGONAL_MM / math.hypot(*window)) for side in window]
    width, height = projection.image_size
    return width / film_mm[0], height / film_mm[1]


def _target_reading(
    blur_px: float | tuple[float, ...] | None, note: Phrase | None = None
) -> Reading:
    return Reading(QT_TRANSLATE_NOOP("phenomena", "blur of the target"), blur_px, "px", note)


def _planes(projection: Projection, focus: float, sharp: Sharpness, subject: Subject) -> Marks:
    """Near limit, focus and far limit, each where it crosses the frustum."""
    near, far = projection.lens.near, projection.lens.far
    marks: list[Mark] = []
    for name, distance, colour, opacity in _crossing(projection, focus, sharp):
        corners = section(projection, distance)
        marks.append(plate(corners, colour, 1.0, opacity))
        marks.append(Text(name, corners[_NAMED_AT[name]], colour))
    # The frustum's edges, thick where what is between them is sharp.
    low, high = max(near, sharp.near), min(far, sharp.far, 4.0 * (focus + subject.size))
    if low < high:
        ends = zip(section(projection, low), section(projection, high), strict=True)
        marks += [Line(np.array(pair), "v", 2.0) for pair in ends]
    return Marks.of(*marks)


_NAMED_AT = {SHARP_FROM: 0, IN_FOCUS: 2, SHARP_TO: 3}
"""At which corner of its plane: the three lie close together, and each name points at its own."""


def _crossing(
    projection: Projection, focus: float, sharp: Sharpness
) -> list[tuple[str, float, str, float]]:
    """Name, distance, colour and opacity of near limit, focus and far limit in the frustum."""
    near, far = projection.lens.near, projection.lens.far
    planes = (
        (SHARP_FROM, sharp.near, "v", 0.12),
        (IN_FOCUS, focus, "accent", 0.3),
        (SHARP_TO, sharp.far, "v", 0.12),
    )
    return [plane for plane in planes if near <= plane[1] <= far and plane[1] < math.inf]


def _planes_ndc(projection: Projection, focus: float, sharp: Sharpness) -> Marks:
    """The same planes across the cube; words where they are larger, in the world."""
    marks = []
    for _, distance, colour, opacity in _crossing(projection, focus, sharp):
        corners = projection.trace(section(projection, distance)).ndc
        if np.isfinite(corners).all():  # if the eye is not so far out that no digit is left
            marks.append(plate(corners, colour, 2.0 if colour == "accent" else 1.0, opacity))
    return Marks.of(*marks)


def _sharp_in_picture(
    projection: Projection, f_mm: float, n: float, focus: float, sharp: Sharpness, subject: Subject
) -> Marks:
    """What is sharp outlined and named, and on each post the disc as which a point of it is drawn.

    Of the user's mesh the vertices that are sharp.
    """
    if subject.mesh is not None:
        step = -(-len(subject.points) // _MOST_VERTICES)
        trace = projection.trace(subject.points[::step])
        away = -trace.view[..., 2]
        drawn = seen(trace) & (sharp.near <= away) & (away <= sharp.far)
        return Marks.of(*(Dot(place, "v", 0.6) for place in trace.image[drawn]))
    trace = projection.trace(_FRONTS)
    away = -trace.view[..., 2]
    is_sharp = ((sharp.near <= away) & (away <= sharp.far)).all(axis=1)
    corners = trace.clip[is_sharp]
    sides = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2, 4)
    lines = seen_lines(projection, sides, ["v"] * len(sides), 2.0)
    tops = projection.trace(_FRONTS[:, 2:].mean(axis=1))  # a number's face, the middle of its top
    names = [Text(SHARP, top, "v") for top in tops.image[is_sharp & seen(tops)]][:1]
    with np.errstate(all="ignore"):
        discs_mm = blur_mm(f_mm, n, focus, -tops.view[:, 2])
    half = np.outer(discs_mm / 2.0, _px_per_mm(projection))
    rim = np.linspace(0.0, 2.0 * math.pi, 24, endpoint=False)
    circle = np.stack([np.cos(rim), np.sin(rim)], axis=1)
    shown = (
        seen(tops)
        & ~is_sharp
        & np.isfinite(half).all(axis=1)
        & (half < max(projection.image_size)).all(axis=1)
    )
    faces = [
        Face(place + size * circle, "accent", 0.9)
        for place, size in zip(tops.image[shown], half[shown], strict=True)
    ]
    return Marks.of(*lines, *faces, *names)


def _diagram(f_mm: float, n: float, focus: float, c_mm: float, sharp: Sharpness) -> Diagram:
    """Blur against distance, about the range of sharpness."""
    left = max(focus - 3.0 * (focus - sharp.near), 0.05 * focus)
    right = focus + 3.0 * (min(sharp.far, 4.0 * focus) - focus)
    if not left < focus < right:  # so narrow a range that float64 has no number beside it
        left, right = 0.5 * focus, 1.5 * focus
    distances = np.append(np.linspace(left, right, 128), focus)
    distances.sort()
    curve = np.stack([distances, blur_mm(f_mm, n, focus, distances)], axis=1)
    top = 4.0 * c_mm
    limits = [part for part in (sharp.near, sharp.far) if left <= part <= right]
    curve[curve[:, 1] > 1e3 * top] = np.nan
    return Diagram(
        QT_TRANSLATE_NOOP("phenomena", "blur disc on the film"),
        (
            Curve(np.array([(left, c_mm), (right, c_mm)]), "muted",
                  QT_TRANSLATE_NOOP("phenomena", "circle of confusion")),
            Curve(curve, "ink", QT_TRANSLATE_NOOP("phenomena", "blur disc"), 2.0),
            *(Curve(np.array([(limit, 0.0), (limit, c_mm)]), "v", width=1.5) for limit in limits),
            Curve(np.array([(focus, 0.0)]), "accent", IN_FOCUS, dots=True),
        ),
        left=left, right=right, bottom=0.0, top=top,
        x_label=QT_TRANSLATE_NOOP("phenomena", "distance, m"),
        y_label=QT_TRANSLATE_NOOP("phenomena", "diameter, mm"),
    )  # fmt: skip


PHENOMENON = Phenomenon(
    name="focus",
    title=QT_TRANSLATE_NOOP("phenomena", "Lens and focus"),
    explanation=QT_TRANSLATE_NOOP(
        "phenomena",
        "The synthetic camera has a point for a lens, and all of its picture is sharp; of a real"
        " lens only what is at the focal distance is drawn as points, and the rest as discs."
        " Between the two limits the discs are no larger than the circle of confusion and pass for"
        " points. One world unit is 1 m. The picture itself is not blurred: what is sharp in it is"
        " outlined, and on top of every other post is the disc as which a point there is drawn.",
    ),
    tries=(
        QT_TRANSLATE_NOOP("phenomena", "Focus on the post at 10 m."),
        QT_TRANSLATE_NOOP("phenomena", "Make N small: how much stays sharp?"),
        QT_TRANSLATE_NOOP("phenomena", "From where on is all that is far sharp?"),
    ),
    lectures=("001",),
    start=Projection(
        Camera((0.0, 1.3, 0.0), (0.0, 1.0, -5.0)),
        Perspective(fov_y_deg=28.0, near=1.7, far=22.0),
    ),
    geometry=_geometry,
    show=_show,
    settings=(
        Setting(
            "focus",
            QT_TRANSLATE_NOOP("phenomena", "Focal distance s"),
            QT_TRANSLATE_NOOP("phenomena", "From the lens to what is in focus"),
            5.0,
            low=1e-6,
            high=1e6,
            span=(0.3, 30.0),
            unit="m",
            logarithmic=True,
        ),
        Setting(
            "aperture",
            QT_TRANSLATE_NOOP("phenomena", "Aperture N"),
            QT_TRANSLATE_NOOP(
                "phenomena",
                "The f-number: the lens is opened to f / N, and no lens opens wider than f / 0.5",
            ),
            2.8,
            low=0.5,
            high=1e6,
            span=(1.0, 64.0),
            logarithmic=True,
        ),
        Setting(
            "confusion",
            QT_TRANSLATE_NOOP("phenomena", "Circle of confusion c"),
            QT_TRANSLATE_NOOP(
                "phenomena", "Largest disc on 35-mm film that passes for a point: 0.03 mm is usual"
            ),
            0.03,
            low=1e-6,
            high=10.0,
            span=(0.005, 0.2),
            unit="mm",
            logarithmic=True,
        ),
    ),
    controls=("lens.fov_y_deg",),
    own_mesh=True,
)
