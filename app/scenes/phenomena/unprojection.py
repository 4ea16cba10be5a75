"""Back from the picture: from a pixel and its depth to the point in the world, with few digits.

`app.precision.unprojecting` has the ways and the bounds of their errors. A matrix `(P V)^-1`
multiplies the eye's coordinates with 1/w, which comes out of a difference near 0. So the error
grows with w/near, and with the eye's distance from the world's origin. Where only the ray is
multiplied with the depth, the eye is added at the end, and is rounded once.

The origin moves away from the eye along (1, 1, 1), and nothing else: coordinates are measured from
there. The world shows each point where the arithmetic puts it, its error enlarged by a factor.
"""

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from app.model.limits import vector
from app.model.parameter import Settings, number, point
from app.model.projection import Projection, Vector
from app.model.refusal import REFUSALS, Refusal
from app.precision import unprojecting
from app.scenes.phenomena.cheap_arithmetic import enlargement, times_text
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Grip, Mark, Marks, Polyline, Text, named, segment
from app.scenes.phenomena.picture import seen
from app.scenes.phenomena.words import PhenomenonWords, Phrase, Reading, figure
from app.scenes.shapes import letter_f_edges

WORDS = PhenomenonWords("unprojection")

_ROOM = 0.2  # of the scene's size: what the errors are enlarged to
_MOST_EDGES = 200  # of a user's mesh


def origin_away(projection: Projection, distance: float) -> Vector:
    """The world point from which coordinates are measured, so far from the eye."""
    return vector(np.array(projection.camera.eye) + distance / math.sqrt(3.0))


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    place, mesh, eye = np.array(point(settings, "point")), subject.mesh, projection.camera.eye
    edges = letter_f_edges()[0] if mesh is None else mesh.edges[:_MOST_EDGES]
    trace = projection.trace(np.concatenate([place[None], edges.reshape(-1, 3)]))
    pixels = unprojecting.float32_pixels(trace.image, trace.depth)
    world: list[Mark] = [segment(eye, place, "muted", 0.75), named("P", place)]
    grips = (Grip("point", place, name="P"),)
    why = _refused(projection, pixels[0].tolist()) if trace.in_front[0] else WORDS.phrase("behind")
    if why is not None:
        return Illustration((), Marks.of(*world), warning=why, grips=grips)
    (rows,) = np.nonzero(seen(trace) & (pixels[:, 2] > 0.0) & (pixels[:, 2] < 1.0))
    rows = np.unique(np.append(0, rows))
    origin, form = origin_away(projection, number(settings, "origin")), str(settings["numbers"])
    try:
        back = unprojecting.followed(projection, pixels[rows], str(settings["way"]), form, origin)
        (exact,) = unprojecting.exact_points(projection, pixels[:1], origin)
        true = projection.world_from_image(pixels[rows])
    except Refusal:  # the lens is the reason
        why = WORDS.phrase("no-inverse")
        return Illustration((), Marks.of(*world), warning=why, grips=grips)
    off = np.full((len(pixels), 3), math.nan)
    off[rows] = (back.value.T - (np.array(eye) - origin)) - (true - eye)
    if np.isfinite(off[0]).all():  # as exactly as it is read
        pairs = zip(back.value[:, 0].tolist(), exact, strict=True)
        off[0] = [float(Fraction(value) - part) for value, part in pairs]
    lengths = np.linalg.norm(off, axis=1)
    longest = float(np.nanmax(lengths, initial=0.0))
    factor = enlargement(longest, _ROOM * subject.size)
    image: list[Mark] = [named("P", trace.image[0])]
    if factor is not None and np.isfinite(off[0]).all():
        drawn = trace.world + factor * off
        for pair in drawn[1:].reshape(-1, 2, 3):
            if np.isfinite(pair).all():
                world.append(Polyline(pair, "u", 1.0, (), "back"))
        times = f" ({times_text(factor)})" if factor > 1.0 else ""
        world += [
            segment(place, drawn[0], "u", 2.0),
            Text("error", (place + drawn[0]) / 2.0, "u", text=figure(lengths[0], 2) + times),
            named("back", drawn[0], "u", 1.3, WORDS["back"]),
        ]
        moved = projection.trace(drawn[0])
        if seen(moved):
            image.append(segment(trace.image[0], moved.image, "u", 1.5))
            image.append(named("back", moved.image, "u", 1.3, WORDS["back"]))
    away, error, why = math.dist(true[0], eye), float(lengths[0]), WORDS.phrase("no-bound")
    values = float(np.linalg.norm(back.error[:, 0])), error, 100.0 * error / (away or math.nan)
    there = (
        unprojecting.off_there(projection, place, trace.ndc[0], each, form, origin)
        for each in unprojecting.THERE
    )
    units = {"bound": "", "off": "", "share": "%", "one": "px", "two": "px"}
    readings = tuple(
        Reading.or_why(WORDS[name], value, unit, why)
        for (name, unit), value in zip(units.items(), (*values, *there), strict=True)
    )
    return Illustration(readings, Marks.of(*world), image=Marks.of(*image), grips=grips)


def _refused(projection: Projection, pixel: Sequence[float]) -> Phrase | None:
    """Why there is no point for a pixel and a depth."""
    try:
        unprojecting.check_pixel(projection, pixel)
    except Refusal as error:
        most = dict(zip("xy", projection.image_size, strict=True)).get(error.field, 1)
        key = "nowhere" if error.bound == REFUSALS["no-point"] else "outside"
        return WORDS.phrase(key, error.field, float(str(error.value)), float(most))
    return None


PHENOMENON = Phenomenon.of(WORDS, show=_show)
