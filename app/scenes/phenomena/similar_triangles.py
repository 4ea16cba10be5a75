"""Similar triangles: a plane at distance d cuts the projectors, in front of the eye or behind it.

A point at depth ``w = -z`` in view space meets the plane ``z = -d`` at ``x_p = d x / w``,
``y_p = d y / w`` (lectures 000, 002, 004). If d is negative, the plane is behind the eye, as the
film of a camera obscura is behind its hole (lectures 001, 002): by the same formula both
coordinates change their signs.
"""

import math

import numpy as np

from app.model.parameter import Settings, number, point
from app.model.projection import Array, Projection
from app.model.refusal import REFUSALS, Refusal
from app.precision.levels import trace as traced
from app.scenes.phenomena import marks
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.picture import grip_of_plane, section, seen, world_from_view
from app.scenes.phenomena.words import PhenomenonWords, Reading

WORDS = PhenomenonWords("similar-triangles")


_MINUS_ONE_OVER_D = 4 * 3 + 2  # the cell that d is in: row 4, column 3
# What numbers and lines are highlighted with, by the names of `app.lecture.highlight`.
_OF_D, _OF_POINT, _OF_DEPTH = ("settings.distance",), ("settings.point",), ("-z",)
_OF_X_P, _OF_Y_P = ("x_p",), ("y_p",)
_OF_IMAGE = (*_OF_X_P, *_OF_Y_P)

SLAB = 4e-3  # of the plane's distance: thickness of the picture on it
_SQUARE = 0.025  # of the longest distance: side of a right angle's mark


def _check(settings: Settings) -> None:
    if number(settings, "distance") == 0.0:
        raise Refusal("settings.distance", 0.0, REFUSALS["not-the-eye-plane"])


def lecture_matrix(distance: float) -> Array:
    """The matrix with -1/d that projects points of view space, (4, 4).

    It takes (x, y, z, 1) to (x, y, z, -z/d), divided (-d x/z, -d y/z, -d) (lecture 000, (2); 004,
    "Matrica promatrane perspektivne projekcije").
    """
    matrix = np.eye(4)
    matrix[3, 2:] = -1.0 / distance, 0.0
    return matrix


def onto_plane(projection: Projection, distance: float, slab: float = 0.0) -> Array:
    """The 4x4 that takes world points along their projectors onto the plane.

    In view space ``(x, y, z, 1) -> (d x, d y, d z, -z)``: rows ``d, d, d`` and ``0 0 -1 0``, the
    matrix with -1/d of the lectures times d. It lifts a point at depth w off the plane by
    ``slab / w``, towards the eye, so that the parts in front stay in front.
    """
    eye, frame = np.array(projection.camera.eye), projection.camera.frame
    view, back = np.eye(4), np.eye(4)
    view[:3, :3], view[:3, 3] = frame, -frame @ eye
    back[:3, :3], back[:3, 3] = frame.T, eye
    flat = np.diag([distance, distance, distance, 0.0])
    flat[2, 3], flat[3, 2] = slab, -1.0
    return np.asarray(back @ flat @ view)


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    distance = number(settings, "distance")
    place = np.array(point(settings, "point"))
    if (parallel := WORDS.of_parallel(projection)) is not None:
        return Illustration((), warning=parallel)
    eye = np.array(projection.camera.eye)

    def at(x: float, y: float, z: float) -> Array:
        return world_from_view(projection, (x, y, z))

    world: list[marks.Mark] = [marks.plate(section(projection, distance), "near", 1.5, 0.14, _OF_D)]
    depths = -projection.trace(subject.points).view[:, 2]
    nearest = float(depths[depths > 0.0].min(initial=math.inf))

    trace = projection.trace(place)
    x, y, z = traced(projection, place, "exact").view.tolist()  # 0 for a point on the axis
    w = -z + 0.0
    x_p, y_p = (distance * x / w, distance * y / w) if w > 0.0 else (None, None)
    lengths: tuple[marks.Length, ...] = ()
    if x_p is not None and y_p is not None:
        hit, foot, axis = at(x_p, y_p, -distance), at(0.0, 0.0, -distance), at(0.0, 0.0, z)
        # The two triangles: from the eye along the axis, across to the point, and back.
        reach = max(w, distance, w - distance)
        side = min(_SQUARE * reach, *(0.4 * math.hypot(*way) for way in ((x, y), (x_p, y_p))))
        world += [
            *marks.dash_dot(
                eye, at(0.0, 0.0, -1.25 * max(w, distance)), 0.1 * reach, "muted", 0.75
            ),
            marks.Face(np.array([eye, axis, place]), "accent", 0.16),
            marks.Face(np.array([eye, foot, hit]), "accent", 0.4),
            marks.segment(foot, eye, "muted", 0.5, _OF_D),
            marks.segment(eye, axis, "muted", 0.5, _OF_DEPTH),
            marks.right_angle(axis, eye, place, side),
            marks.right_angle(foot, eye, hit, side),
            marks.segment(axis, place, "accent", 2.5, _OF_POINT),
            marks.Polyline(_through(eye, place, hit, distance, w), "ink", 1.0),
            marks.segment(foot, hit, "accent", 2.5, _OF_IMAGE),
            marks.Dot(eye, "eye", 1.5),
            marks.named("P", place, size=1.6),
            marks.named("P'", hit, size=1.6),
        ]
        nearest = min(nearest, w)
        lengths = (
            marks.Length("side", "y", y, axis, at(0.0, y, z)),
            marks.Length("side", "y_p", y_p, foot, at(0.0, y_p, -distance)),
            marks.Length("top", "x", x, axis, at(x, 0.0, z)),
            marks.Length("top", "x_p", x_p, foot, at(x_p, 0.0, -distance)),
        )
    note = WORDS.phrase("behind") if x_p is None else None
    matrix = lecture_matrix(distance)
    with np.errstate(over="ignore"):
        product = tuple((matrix @ (x, y, z, 1.0) + 0.0).tolist())
    scale = None if x_p is None else distance / w
    cells = tuple(matrix.ravel().tolist())
    readings = (
        Reading(WORDS["matrix"], cells, about=_OF_D, cell=_MINUS_ONE_OVER_D),
        Reading(WORDS["product"], product, about=(*_OF_D, *_OF_DEPTH, *_OF_POINT)),
        Reading("x_p = d·x / −z", x_p, note=note, about=_OF_X_P),
        Reading("y_p = d·y / −z", y_p, note=note, about=_OF_Y_P),
        Reading(WORDS["scale"], scale, "×", note, about=(*_OF_D, *_OF_DEPTH)),
        Reading("−z", w, about=_OF_DEPTH),
        Reading(WORDS["image"], WORDS["upright" if distance > 0.0 else "upside-down"]),
    )
    slab = SLAB * abs(distance) * (nearest if nearest < math.inf else 1.0)
    here = bool(seen(trace))
    return Illustration(
        readings,
        world=marks.Marks.of(*world),
        ndc=marks.named("P", trace.ndc) if here else marks.Marks(),
        image=marks.named("P", trace.image) if here else marks.Marks(),
        copies=(marks.Copy(onto_plane(projection, distance, slab)),),
        grips=(
            marks.Grip("point", place, name="P"),
            grip_of_plane(projection, "distance", distance, distance, "d", "near"),
        ),
        lengths=lengths,
        measured=(("d", distance),) if x_p is None else (("d", distance), ("-z", w)),
    )


def _through(eye: Array, end: Array, hit: Array, distance: float, w: float) -> Array:
    """A projector through the point, the eye and the plane, from end to end, (2, 3)."""
    if distance < 0.0:
        return np.array([end, hit])
    return np.array([eye, hit if distance > w else end])


PHENOMENON = Phenomenon.of(WORDS, show=_show, check=_check)
