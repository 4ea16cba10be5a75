"""View volumes: the pyramid of a perspective lens, the boxes of the parallel ones, the eye's cone.

Lecture 001 names three: an eye sees about a truncated cone, the truncated pyramid replaces it
because pictures are rectangles, and the parallel volume is the view from very far away. The volumes
are those of solid geometry: a section at depth w is ``(w/n)^2`` times the one at the near plane, or
the same at every depth, however the axis leans (Cavalieri).
"""

import math
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from app.model.parameter import ImpliedSettings, Settings
from app.model.parameters import ALPHA, FAR, NEAR
from app.model.projection import Projection
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Dot, Face, Mark, Marks, Polyline, Text, segment
from app.scenes.phenomena.picture import drawn_planes, image_from_ndc, seen_texts, world_from_view
from app.scenes.phenomena.words import PhenomenonWords, Reading
from app.scenes.shapes import Coloured, box_faces, edges_of, flat, ground_grid, joined

WORDS = PhenomenonWords("view-volumes")

_LENS = {
    "pyramid": "perspective", "cone": "perspective", "box": "orthographic", "oblique": "oblique",
}  # fmt: skip

POINTS = {  # the world coordinates of the test points
    "A": (0.0, 3.0, 0.0),
    "B": (3.0, 3.0, 4.0),
    "C": (7.0, 3.0, -4.0),
    "D": (-4.0, 3.0, 0.0),
    "E": (-2.0, 1.2, -4.0),
}
_PLACES = np.array(list(POINTS.values()))
_LETTERS = _PLACES + np.array([0.0, 0.45, 0.0])
_LETTERS[-1] = _PLACES[-1] + (0.45, 0.0, 0.0)  # above it is an edge of the frustum

_SIDES = 32  # of the polygon that stands for a circle
_TURN = np.linspace(0.0, 2.0 * math.pi, _SIDES + 1)
_CIRCLE = np.stack([np.cos(_TURN), np.sin(_TURN)], axis=1)


def _geometry() -> tuple[Coloured, Coloured]:
    hues = ((230, 159, 0), (86, 180, 233), (0, 158, 115), (240, 228, 66), (0, 114, 178))
    faces = np.concatenate([box_faces(place - 0.3, place + 0.3) for place in _PLACES])
    posts = np.stack([_PLACES * (1.0, 0.0, 1.0), _PLACES - (0.0, 0.3, 0.0)], axis=1)
    lines = joined(
        ground_grid((-8.0, -8.0), (8.0, 8.0), (1.0, 1.0), 0.0),
        edges_of(faces),
        (posts, flat((72, 72, 78), len(posts))),
    )
    return (faces, np.concatenate([flat(hue, 6) for hue in hues])), lines


def cone_of(projection: Projection) -> tuple[float, float, float]:
    """x, y and radius, at distance 1 from the eye, of the cone inscribed in a lens' pyramid.

    For a symmetric lens 0, 0 and the tangent of half the smaller field of view, which is the
    vertical one of a wide image.
    """
    left, right, bottom, top = projection.lens.slopes(Fraction(*projection.image_size))
    return (left + right) / 2.0, (bottom + top) / 2.0, min(right - left, top - bottom) / 2.0


def volume(projection: Projection, cone: bool) -> float | None:
    """The volume between the near and the far plane, in cubic world units.

    ``A (f^3 - n^3) / (3 n^2)`` for a pyramid whose near face is A, the same with a circle for the
    eye's cone, ``A (f - n)`` for a box, oblique or not. None if float64 has no such number.
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
    # Rational until here, because the cube of a far plane may be beyond 1e308.
    return float(exact) if Fraction(1e-300) < exact < Fraction(1e300) else None


def held(projection: Projection, cone: bool) -> NDArray[np.bool_]:
    """Which of `POINTS` are in the volume or on its surface, (5,)."""
    trace = projection.trace(_PLACES)
    if not cone:
        return ~np.asarray(trace.outside.any(axis=1))
    x, y, radius = cone_of(projection)
    w = -trace.view[:, 2]
    across = np.hypot(trace.view[:, 0] - x * w, trace.view[:, 1] - y * w)
    return np.asarray(~trace.outside[:, :2].any(axis=1) & (across <= radius * w))


def _cone_marks(projection: Projection) -> tuple[Marks, Marks, Marks]:
    """The cone in the world, in NDC and in the image."""
    x, y, radius = cone_of(projection)
    sections = np.empty((2, _SIDES + 1, 3))
    for section, w in zip(sections, drawn_planes(projection), strict=True):
        section[:, :2] = (np.array([x, y]) + radius * _CIRCLE) * w
        section[:, 2] = -w
    near_circle, far_circle = world = world_from_view(projection, sections)
    spokes, edges = range(0, _SIDES, _SIDES // 8), range(0, _SIDES, 2)
    marks: list[Mark] = [Polyline(near_circle, NEAR.name, 1.5), Polyline(far_circle, FAR.name, 1.5)]
    marks += [Polyline(world[:, i], "accent", 1.0) for i in spokes]
    marks += [Face(world[[0, 0, 1, 1], [i, i + 2, i + 2, i]], "accent", 0.18) for i in edges]
    # In NDC it is a cylinder: its section fills the shorter side of the cube's.
    left, right, bottom, top = projection.lens.slopes(Fraction(*projection.image_size))
    ellipse = radius / np.array([(right - left) / 2.0, (top - bottom) / 2.0]) * _CIRCLE
    near, far = (np.column_stack([ellipse, [z] * len(ellipse)]) for z in projection.depth_range)
    in_ndc = [Polyline(near, NEAR.name, 1.5), Polyline(far, FAR.name, 1.5)]
    in_ndc += [segment(near[i], far[i], "accent", 1.0) for i in spokes]
    in_image = Polyline(image_from_ndc(projection, ellipse), "accent", 1.5)
    return Marks.of(*marks), Marks.of(*in_ndc), Marks.of(in_image)


def _show(projection: Projection, settings: Settings, _subject: Subject) -> Illustration:
    asked = settings["volume"] == "cone"
    no_cone = None if projection.lens.central else WORDS.phrase("no-cone")
    cone = asked and no_cone is None
    size = volume(projection, cone)
    note = None
    if size is None:
        note = WORDS.phrase("infinite" if projection.lens.far == math.inf else "out-of-range")
    inside = held(projection, cone)
    names = [name for name, here in zip(POINTS, inside, strict=True) if here]
    dots, texts = [], []
    for name, place, at, here in zip(POINTS, _PLACES, _LETTERS, inside, strict=True):
        dots.append(Dot(place, "accent", 1.4) if here else Dot(place, "muted", 0.7))
        texts.append(Text(name, at, "accent" if here else "muted"))
    world, ndc, image = _cone_marks(projection) if cone else (Marks(),) * 3
    kind = WORDS["truncated-cone"] if cone else projection.lens.shape
    return Illustration(
        (
            Reading(WORDS["kind"], kind, note=WORDS.phrase("cone") if cone else None),
            Reading(WORDS["size"], size, note=note),
            Reading(WORDS["count"], float(len(names))),
            Reading(WORDS["names"], ", ".join(names) or WORDS["none"]),
        ),
        world=Marks.of(world, *dots, *texts),
        ndc=ndc,
        image=Marks.of(image, *seen_texts(projection.trace(_LETTERS), texts)),
        warning=no_cone if asked else None,
    )


def _follow(projection: Projection, before: ImpliedSettings, after: Settings) -> Projection:
    if before["volume"] == after["volume"]:
        return projection
    kind = _LENS[str(after["volume"])]
    # An off-axis pyramid is one, too.
    return projection.with_eye() if kind == "perspective" else projection.with_lens(kind)


def _implied(projection: Projection, settings: Settings) -> ImpliedSettings:
    lens = projection.lens
    if lens.central:
        return {"volume": "cone" if settings["volume"] == "cone" else "pyramid"}
    return {"volume": "oblique" if ALPHA in lens.parameters else "box"}


PHENOMENON = Phenomenon.of(WORDS, geometry=_geometry, show=_show, follow=_follow, implied=_implied)
