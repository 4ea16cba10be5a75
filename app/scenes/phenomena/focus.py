"""Lens and focus: what a real camera's lens adds to the pinhole.

Lecture 001 names the focal distance (what is in focus) and the depth of field (how far before and
behind it things are acceptably sharp) among a camera's parameters. A thin lens of focal length f,
opened to ``A = f/N`` and focused at the distance s, draws a point at distance D on the film as a
disc of diameter ``b = A f |D - s| / (D (s - f))``. The limits of sharpness are where b is the
circle of confusion c, the largest disc that still passes for a point (S. F. Ray, *Applied
Photographic Optics*, 3rd ed., 2002)::

    H = f^2/(N c) + f        near = s (H - f)/(H + s - 2 f)        far = s (H - f)/(H - s)

Focused at the hyperfocal distance H or beyond, the far limit is infinite.

The focal length is that of a 36 x 24 mm camera with the same diagonal field of view. The lens is in
the eye, distances are measured along the view direction, and one world unit is 1 m.
"""

import math
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.model.lenses.central import FULL_FRAME_DIAGONAL_MM
from app.model.parameter import Settings, number
from app.model.parameters import tidy
from app.model.projection import Array, Projection
from app.scenes import shapes
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Aperture, Dot, Mark, Marks, Rendering, Text, plate, segment
from app.scenes.phenomena.picture import grip_of_plane, section, seen, seen_lines
from app.scenes.phenomena.words import Curve, Diagram, PhenomenonWords, Phrase, Reading

WORDS = PhenomenonWords("focus")

_MM = 1e-3  # in world units, which are metres


class Sharpness(NamedTuple):
    """The limits of sharpness, what is between them, and the hyperfocal distance, in metres."""

    near: float
    far: float  # may be infinite
    depth: float
    hyperfocal: float


def sharpness(f_mm: float, f_number: float, focus: float, confusion_mm: float) -> Sharpness:
    """The limits of sharpness, as in the module's text.

    The distance `focus`, in m, must be greater than the focal length.
    """
    f = f_mm * _MM
    reach = f * (f_mm / f_number / confusion_mm)  # H - f
    share = (focus - f) / reach  # both formulas divided by H - f, so that no sum loses digits
    near = focus / (1.0 + share)
    far = focus / (1.0 - share) if share < 1.0 else math.inf
    return Sharpness(near, far, 2.0 * share * near * (far / focus), reach + f)


def blur_mm(f_mm: float, f_number: float, focus: float, distances: Array) -> Array:
    """Diameter on the film, in mm, of the discs for points at these distances, in m."""
    opening_mm = f_mm / f_number
    magnification = f_mm * _MM / (focus - f_mm * _MM)
    return np.asarray(opening_mm * magnification * np.abs(1.0 - focus / distances))


_POSTS = (2, 3, 4, 5, 6, 8, 10, 12, 15, 20)
_HALF, _HIGH = 0.15, 1.4  # of a post: half its width and depth, and its height
_MOST_VERTICES = 400  # of the user's mesh that are marked where they are sharp


def _post_places() -> list[tuple[float, float]]:
    """How far each post is to the right of the eye, and away from it."""
    places = []
    tangent = -0.4  # of the angle from the axis to the next post's left side
    for distance in _POSTS:
        places.append((tangent * distance + _HALF, float(distance)))
        tangent += 2.0 * _HALF / distance + 0.025
    return places


_POST_PLACES = np.array(_post_places())
_FRONT = np.array([(-_HALF, 0.0), (_HALF, 0.0), (_HALF, _HIGH), (-_HALF, _HIGH)])
_FRONTS = np.array([[(x + side, y, _HALF - z) for side, y in _FRONT] for x, z in _POST_PLACES])
"""World corners of the posts' faces with the numbers, (n, 4, 3)."""


def _geometry() -> tuple[shapes.Coloured, shapes.Coloured]:
    """Posts that bear their distances from the eye in m, side by side in the picture."""
    faces: list[shapes.Coloured] = []
    boxes = []
    for distance, (x, _) in zip(_POSTS, _POST_PLACES.tolist(), strict=True):
        lower, upper = (x - _HALF, 0.0, -distance - _HALF), (x + _HALF, _HIGH, _HALF - distance)
        box = shapes.box_faces(lower, upper)
        digits = shapes.written_number(distance, (x, 1.1, -distance + 0.155), 0.22)
        faces += [(box, shapes.SIDE_RGB), (digits, shapes.flat(shapes.EDGE_RGB, len(digits)))]
        boxes.append(box)
    ground = shapes.ground_grid((-4.0, -24.0), (8.0, 0.0), (1.0, 1.0), 0.0)
    return shapes.joined(*faces), shapes.joined(ground, shapes.edges_of(np.concatenate(boxes)))


class _Focused(NamedTuple):
    """A focused lens: its settings, its focal length and its limits of sharpness."""

    n: float
    focus: float
    c_mm: float
    f_mm: float
    sharp: Sharpness

    def blur_mm(self, distances: Array) -> Array:
        return blur_mm(self.f_mm, self.n, self.focus, distances)

    @property
    def aperture(self) -> Aperture:
        """The opening, a little wider than f / N.

        The film of a focused lens is farther away than f, where the pinhole's is. The wider opening
        makes up for that: the discs in the picture are as large as `blur_mm` says.
        """
        f = self.f_mm * _MM
        return Aperture(0.5 * (f / self.n) * (self.focus / (self.focus - f)), self.focus)

    def is_sharp(self, distances: Array) -> NDArray[np.bool_]:
        return (self.sharp.near <= distances) & (distances <= self.sharp.far)


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    n, focus, c_mm = (number(settings, name) for name in ("aperture", "focus", "confusion"))
    angles = projection.lens.angles(Fraction(*projection.image_size))
    if angles is None:
        note = WORDS.phrase("parallel")
        return Illustration(_readings(None, None, None, note), warning=note)
    f_mm = angles.focal_mm
    if focus <= f_mm * _MM:
        note = WORDS.phrase("too-close", focus, f_mm * _MM)
        return Illustration(_readings(f_mm, f_mm / n, None, note), warning=note)
    sharp = sharpness(f_mm, n, focus, c_mm)
    lens = _Focused(n, focus, c_mm, f_mm, sharp)
    with np.errstate(over="ignore"):
        disc_mm = float(lens.blur_mm(np.array(tidy(projection.camera.distance))))
    to_infinity = WORDS.phrase("to-infinity")
    is_seen = projection.lens.near <= focus <= projection.lens.far
    return Illustration(
        _readings(f_mm, f_mm / n, sharp, to_infinity, _drawn_disc(projection, disc_mm)),
        world=_planes(projection, lens, subject),
        ndc=_planes_ndc(projection, lens),
        image=_sharp_in_picture(projection, lens, subject),
        diagrams=(_diagram(lens),),
        rendering=Rendering(aperture=lens.aperture),
        grips=(grip_of_plane(projection, "focus", focus, focus, "in-focus", "accent"),)[:is_seen],
        measured=(("s", focus),)[:is_seen],
    )


def _readings(
    f_mm: float | None,
    opening_mm: float | None,
    sharp: Sharpness | None,
    note: Phrase,
    disc: Reading | None = None,
) -> tuple[Reading, ...]:
    """The readout; `note` says why a value is None."""
    near = far = depth = hyperfocal = None
    if sharp is not None:
        near, far, depth, hyperfocal = sharp
    return (
        Reading.or_why(WORDS["sharp-from"], near, "m", note),
        Reading.or_why(WORDS["sharp-to"], far, "m", note),
        Reading.or_why(WORDS["depth-of-field"], depth, "m", note),
        Reading.or_why(WORDS["hyperfocal"], hyperfocal, "m", note),
        Reading.or_why(WORDS["focal"], f_mm, "mm", note),
        Reading.or_why(WORDS["opening"], opening_mm, "mm", note),
        disc or Reading(WORDS["blur"], None, "px", note),
    )


def _drawn_disc(projection: Projection, disc_mm: float) -> Reading:
    """The target's disc in the picture: its diameter, or width and height of an ellipse."""
    across, up = (disc_mm * px for px in _px_per_mm(projection))
    if not (math.isfinite(across) and math.isfinite(up)):
        return Reading(WORDS["blur"], None, "px", WORDS.phrase("boundless"))
    if across != up:
        return Reading(WORDS["blur"], (across, up), "px", WORDS.phrase("ellipse"))
    return Reading(WORDS["blur"], across, "px")


def _px_per_mm(projection: Projection) -> tuple[float, float]:
    """Pixels of the picture for a millimetre of the film, across and up: equal if not stretched.

    The film has the diagonal of 36 x 24 mm and the shape of the window.
    """
    left, right, bottom, top = projection.window
    window = right - left, top - bottom
    if math.isclose(window[0] / window[1], projection.aspect, rel_tol=1e-6):
        per_mm = math.hypot(*projection.image_size) / FULL_FRAME_DIAGONAL_MM
        return per_mm, per_mm
    film_mm = [side * (FULL_FRAME_DIAGONAL_MM / math.hypot(*window)) for side in window]
    width, height = projection.image_size
    return width / film_mm[0], height / film_mm[1]


def _planes(projection: Projection, lens: _Focused, subject: Subject) -> Marks:
    """Near limit, focus and far limit, each where it crosses the frustum."""
    near, far = projection.lens.near, projection.lens.far
    marks: list[Mark] = []
    for name, distance, colour, opacity in _crossing(projection, lens):
        corners = section(projection, distance)
        marks.append(plate(corners, colour, 1.0, opacity, (), name))
        marks.append(Text(name, corners[_NAMED_AT[name]], colour, text=WORDS[name]))
    # The frustum's edges are thick where everything between them is sharp.
    low = max(near, lens.sharp.near)
    high = min(far, lens.sharp.far, 4.0 * (lens.focus + subject.size))
    if low < high:
        ends = zip(section(projection, low), section(projection, high), strict=True)
        marks += [segment(*pair, "v", 2.0) for pair in ends]
    return Marks.of(*marks)


_NAMED_AT = {"sharp-from": 0, "in-focus": 1, "sharp-to": 2}
"""The corner of each plane with its name: the planes are close together, the corners are not."""


def _crossing(projection: Projection, lens: _Focused) -> list[tuple[str, float, str, float]]:
    """Name, distance, colour and opacity of near limit, focus and far limit in the frustum."""
    near, far = projection.lens.near, projection.lens.far
    planes = (
        ("sharp-from", lens.sharp.near, "v", 0.12),
        ("in-focus", lens.focus, "accent", 0.3),
        ("sharp-to", lens.sharp.far, "v", 0.12),
    )
    return [plane for plane in planes if near <= plane[1] <= far and plane[1] < math.inf]


def _planes_ndc(projection: Projection, lens: _Focused) -> Marks:
    """The same planes across the cube, without their names, for which the world has more room."""
    marks = []
    for _, distance, colour, opacity in _crossing(projection, lens):
        corners = projection.trace(section(projection, distance)).ndc
        if np.isfinite(corners).all():  # unless the eye is so far out that no digit is left
            marks.append(plate(corners, colour, 2.0 if colour == "accent" else 1.0, opacity))
    return Marks.of(*marks)


def _sharp_in_picture(projection: Projection, lens: _Focused, subject: Subject) -> Marks:
    """Outlines of the sharp posts; of the user's mesh, the sharp vertices."""
    if subject.mesh is not None:
        step = -(-len(subject.points) // _MOST_VERTICES)
        trace = projection.trace(subject.points[::step])
        drawn = seen(trace) & lens.is_sharp(-trace.view[..., 2])
        return Marks.of(*(Dot(place, "v", 0.6) for place in trace.image[drawn]))
    trace = projection.trace(_FRONTS)
    is_sharp = lens.is_sharp(-trace.view[..., 2]).all(axis=1)
    corners = trace.clip[is_sharp]
    sides = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2, 4)
    lines = seen_lines(projection, sides, ["v"] * len(sides), 2.0)
    tops = projection.trace(_FRONTS[:, 2:].mean(axis=1))  # the middle of each front's upper edge
    first = tops.image[is_sharp & seen(tops)][:1]
    return Marks.of(*lines, *(Text("sharp", top, "v", text=WORDS["sharp"]) for top in first))


def _diagram(lens: _Focused) -> Diagram:
    """Blur against distance, about the range of sharpness."""
    focus, c_mm, sharp = lens.focus, lens.c_mm, lens.sharp
    left = max(focus - 3.0 * (focus - sharp.near), 0.05 * focus)
    right = focus + 3.0 * (min(sharp.far, 4.0 * focus) - focus)
    if not left < focus < right:  # the range is narrower than float64's numbers are dense
        left, right = 0.5 * focus, 1.5 * focus
    distances = np.append(np.linspace(left, right, 128), focus)
    distances.sort()
    curve = np.stack([distances, lens.blur_mm(distances)], axis=1)
    top = 4.0 * c_mm
    limits = [part for part in (sharp.near, sharp.far) if left <= part <= right]
    curve[curve[:, 1] > 1e3 * top] = np.nan
    return Diagram(
        WORDS["diagram"],
        (
            Curve(np.array([(left, c_mm), (right, c_mm)]), "muted", WORDS["confusion"]),
            Curve(curve, "ink", WORDS["disc"], 2.0),
            *(Curve(np.array([(limit, 0.0), (limit, c_mm)]), "v", width=1.5) for limit in limits),
            Curve(np.array([(focus, 0.0)]), "accent", WORDS["in-focus"], dots=True),
        ),
        *(left, right, 0.0, top),
        x_label=WORDS["x-label"],
        y_label=WORDS["y-label"],
    )


PHENOMENON = Phenomenon.of(WORDS, geometry=_geometry, show=_show)
