"""View volumes: the pyramid of a perspective lens, the boxes of the parallel ones, the eye's cone.

Lecture 001 names three: the truncated cone is about what an eye sees, the truncated pyramid stands
in for it because pictures are rectangles, and the parallel volume is the view from very far away.
Volumes are those of solid geometry: a section at depth w is ``(w/n)^2`` of the one at the near
plane, or the same at every depth, however the axis leans (Cavalieri).
"""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from app.model.projection import Camera, Perspective, Projection
from app.model.refusal import QT_TRANSLATE_NOOP
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Dot, Face, Line, Mark, Marks, Text
from app.scenes.phenomena.picture import drawn_planes, image_from_ndc, seen_texts, world_from_view
from app.scenes.phenomena.readout import Phrase, Reading, of_parallel
from app.scenes.phenomena.settings import Found, Setting, Settings
from app.scenes.shapes import Coloured, box_faces, edges_of, flat, ground_grid, joined

_INFINITE = QT_TRANSLATE_NOOP("phenomena", "far is infinite, and so is the volume")
_OUT_OF_RANGE = QT_TRANSLATE_NOOP("phenomena", "too large or too small for a float64 number")
_NO_CONE = QT_TRANSLATE_NOOP(
    "phenomena", "a parallel lens has no eye for a cone to start in: its own volume is shown"
)
_CONE = QT_TRANSLATE_NOOP(
    "phenomena", "no lens makes a cone: what is drawn is all that lies in the pyramid round it"
)
_TRUNCATED_CONE = QT_TRANSLATE_NOOP("phenomena", "truncated cone")
_LENS = {
    "pyramid": "perspective", "cone": "perspective", "box": "orthographic", "oblique": "oblique",
}  # fmt: skip

POINTS = {
    "A": (0.0, 3.0, 0.0),
    "B": (3.0, 3.0, 4.0),
    "C": (7.0, 3.0, -4.0),
    "D": (-4.0, 3.0, 0.0),
    "E": (-2.0, 1.2, -4.0),
    "F": (0.0, 6.5, 4.0),
    "G": (-1.0, 3.5, 6.0),
    "H": (1.0, 3.5, -6.5),
}
"""The test points, world coordinates by their names."""
_PLACES = np.array(list(POINTS.values()))
_LETTERS = _PLACES + np.array([0.0, 0.45, 0.0])

_SIDES = 32  # of the polygon that stands for a circle
_TURN = np.linspace(0.0, 2.0 * math.pi, _SIDES + 1)
_CIRCLE = np.stack([np.cos(_TURN), np.sin(_TURN)], axis=1)


def _geometry() -> tuple[Coloured, Coloured]:
    hues = (
        (230, 159, 0), (86, 180, 233), (0, 158, 115), (240, 228, 66),
        (0, 114, 178), (213, 94, 0), (204, 121, 167), (150, 150, 150),
    )  # fmt: skip
    quads, rgb = [], []
    for place, hue in zip(_PLACES, hues, strict=True):
        quads.append(box_faces(place - 0.3, place + 0.3))
        rgb.append(flat(hue, 6))
    faces = np.concatenate(quads)
    posts = np.stack([_PLACES * (1.0, 0.0, 1.0), _PLACES - (0.0, 0.3, 0.0)], axis=1)
    lines = joined(
        ground_grid((-8.0, -8.0), (8.0, 8.0), (1.0, 1.0), 0.0),
        edges_of(faces),
        (posts, flat((72, 72, 78), len(posts))),
    )
    return (faces, np.concatenate(rgb)), lines


# --------------------------------------------------------------------------- the volumes


def cone_of(projection: Projection) -> tuple[float, float, float]:
    """The cone inscribed in a perspective lens' pyramid.

    Returns
    -------
    x, y, radius : float
        Middle and radius of its section at distance 1 from the eye: for a symmetric lens 0, 0 and
        the tangent of half the smaller field of view, which of a wide image is the vertical one.
    """
    left, right, bottom, top = projection.lens.slopes(Fraction(*projection.image_size))
    return (left + right) / 2.0, (bottom + top) / 2.0, min(right - left, top - bottom) / 2.0


def volume(projection: Projection, cone: bool) -> float | None:
    """Volume of what lies between the near and the far plane, in cubic world units.

    Parameters
    ----------
    projection : Projection
    cone : bool
        Of the eye's cone, not of the whole pyramid; for perspective lenses.

    Returns
    -------
    float or None
        ``A (f^3 - n^3) / (3 n^2)`` for a pyramid whose near face is A, the same with a circle for
        a cone, ``A (f - n)`` for a box, oblique or not; None where float64 has no such number,
        infinity included.
    """
    lens = projection.lens
    if lens.far == math.inf:
        return None
    section = lens.section(Fraction(*projection.image_size))
    if cone:
        section = Fraction(math.pi) * Fraction(cone_of(projection)[2]) ** 2
    near, far = Fraction(lens.near), Fraction(lens.far)
    first, last = Fraction(lens.w(lens.near)), Fraction(lens.w(lens.far))  # the edges grow like w
    exact = section * (far - near) * (first * first + first * last + last * last) / 3
    # In rationals until here: the cube of a far plane may be beyond 1e308, its product not.
    if not Fraction(1e-300) < exact < Fraction(1e300):
        return None
    return float(exact)


def held(projection: Projection, cone: bool) -> NDArray[np.bool_]:
    """Which of `POINTS` the volume holds, (8,); those on its surface are inside."""
    trace = projection.trace(_PLACES)
    if not cone:
        return ~np.asarray(trace.outside.any(axis=1))
    x, y, radius = cone_of(projection)
    w = -trace.view[:, 2]
    across = np.hypot(trace.view[:, 0] - x * w, trace.view[:, 1] - y * w)
    return np.asarray(~trace.outside[:, :2].any(axis=1) & (across <= radius * w))


# --------------------------------------------------------------------------- what is shown


def _cone_marks(projection: Projection) -> tuple[Marks, Marks, Marks]:
    """The cone in the world, in NDC and in the image."""
    x, y, radius = cone_of(projection)
    sections = np.empty((2, _SIDES + 1, 3))
    for section, w in zip(sections, drawn_planes(projection), strict=True):
        section[:, :2] = (np.array([x, y]) + radius * _CIRCLE) * w
        section[:, 2] = -w
    near_circle, far_circle = world = world_from_view(projection, sections)
    marks: list[Mark] = [Line(near_circle, "near", 1.5), Line(far_circle, "far", 1.5)]
    marks += [Line(world[:, i], "accent", 1.0) for i in range(0, _SIDES, _SIDES // 8)]
    marks += [
        Face(np.array([world[0, i], world[0, i + 2], world[1, i + 2], world[1, i]]), "accent", 0.18)
        for i in range(0, _SIDES, 2)
    ]
    # In NDC it is a cylinder: its section fills the shorter side of the cube's.
    left, right, bottom, top = projection.lens.slopes(Fraction(*projection.image_size))
    ellipse = radius / np.array([(right - left) / 2.0, (top - bottom) / 2.0]) * _CIRCLE
    near, far = (np.column_stack([ellipse, [z] * len(ellipse)]) for z in projection.depth_range)
    in_ndc = [Line(near, "near", 1.5), Line(far, "far", 1.5)]
    in_ndc += [
        Line(np.array([near[i], far[i]]), "accent", 1.0) for i in range(0, _SIDES, _SIDES // 8)
    ]
    in_image = Line(image_from_ndc(projection, ellipse), "accent", 1.5)
    return Marks.of(*marks), Marks.of(*in_ndc), Marks.of(in_image)


def _show(projection: Projection, settings: Settings, _subject: Subject) -> Illustration:
    asked = settings["volume"] == "cone"
    no_cone = of_parallel(projection, _NO_CONE)
    cone = asked and no_cone is None
    size = volume(projection, cone)
    note = None
    if size is None:
        note = Phrase(_INFINITE if projection.lens.far == math.inf else _OUT_OF_RANGE)
    inside = held(projection, cone)
    names = [name for name, here in zip(POINTS, inside, strict=True) if here]
    none = QT_TRANSLATE_NOOP("phenomena", "none")
    readings = (
        Reading(
            QT_TRANSLATE_NOOP("phenomena", "view volume"),
            _TRUNCATED_CONE if cone else projection.lens.shape,
            note=Phrase(_CONE) if cone else None,
        ),
        Reading(QT_TRANSLATE_NOOP("phenomena", "its volume, cubic units"), size, note=note),
        Reading(QT_TRANSLATE_NOOP("phenomena", "test points inside"), float(len(names))),
        Reading(QT_TRANSLATE_NOOP("phenomena", "these are"), ", ".join(names) or none),
    )
    texts = [
        Text(name, place, "accent") if here else Text(f"({name})", place)
        for name, place, here in zip(POINTS, _LETTERS, inside, strict=True)
    ]
    dots = [
        Dot(place, "accent" if here else "muted", 1.4 if here else 0.7)
        for place, here in zip(_PLACES, inside, strict=True)
    ]
    world, ndc, image = Marks(), Marks(), Marks()
    if cone:
        world, ndc, image = _cone_marks(projection)
    return Illustration(
        readings,
        world=Marks.of(world, *dots, *texts),
        ndc=ndc,
        image=Marks.of(image, *seen_texts(projection.trace(_LETTERS), texts)),
        warning=no_cone if asked else None,
    )


def _follow(projection: Projection, before: Found, after: Settings) -> Projection:
    if before["volume"] == after["volume"]:
        return projection
    kind = _LENS[str(after["volume"])]
    if kind == "perspective" and projection.lens.central:
        return projection  # an off-axis pyramid is one, too
    return projection.with_lens(kind)


def _found(projection: Projection, settings: Settings) -> Found:
    lens = projection.lens
    if lens.central:
        return {"volume": "cone" if settings["volume"] == "cone" else "pyramid"}
    return {"volume": "oblique" if lens.kind == _LENS["oblique"] else "box"}


PHENOMENON = Phenomenon(
    name="view-volumes",
    title=QT_TRANSLATE_NOOP("phenomena", "View volumes"),
    explanation=QT_TRANSLATE_NOOP(
        "phenomena",
        "Only what lies in the view volume is drawn. An eye sees a truncated cone; a perspective"
        " lens takes the pyramid round it, because a picture is a rectangle; a parallel lens has"
        " a box, straight or oblique, which is the view from very far away. A test point in"
        " brackets lies outside.",
    ),
    tries=(
        QT_TRANSLATE_NOOP("phenomena", "Move near and far past the points."),
        QT_TRANSLATE_NOOP("phenomena", "Which of A to E are inside now?"),
        QT_TRANSLATE_NOOP("phenomena", "Choose the box: which come, which go?"),
    ),
    lectures=("001",),
    start=Projection(
        Camera((0.0, 3.0, 8.0), (0.0, 3.0, 0.0)),
        Perspective(fov_y_deg=40.0, near=3.0, far=13.0),
    ),
    geometry=_geometry,
    show=_show,
    settings=(
        Setting(
            "volume",
            QT_TRANSLATE_NOOP("phenomena", "View volume"),
            QT_TRANSLATE_NOOP(
                "phenomena", "Changes the lens; the picture of the target's plane stays"
            ),
            "pyramid",
            choices=(
                ("pyramid", QT_TRANSLATE_NOOP("phenomena", "Pyramid (perspective)")),
                ("box", QT_TRANSLATE_NOOP("phenomena", "Box (orthographic)")),
                ("oblique", QT_TRANSLATE_NOOP("phenomena", "Oblique box (oblique)")),
                ("cone", QT_TRANSLATE_NOOP("phenomena", "Cone (the eye's own)")),
            ),
        ),
    ),
    controls=("lens.near", "lens.far"),
    numbers=4,
    follow=_follow,
    found=_found,
)
