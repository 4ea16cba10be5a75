"""Planar shadow: the scene once more under the matrix that projects it from the light.

A light L and a plane ``p·x = 0`` (both homogeneous; L has w = 0 for the sun) cast the point x on
the plane along the line through L and x::

    x' = (p·L) x - (p·x) L        S = (p·L) I - L p^T

It is a perspective projection with its centre in the light (lecture 002, "Perspective shadows"),
and a parallel one for the sun. For a light above the plane ``w' = p·L - L_w (p·x)`` is the height
of the light above the point. A point as high as the light has its shadow at infinity; a higher one
has ``w' < 0``, and the divide draws it on the other side of the light as an anti-shadow. The GPU
clips ``w < 0`` before it divides; the matrix -S reverses the sign and lets the anti-shadow through.
(Where the camera's own w is below 0 too, the product of both is positive: such points are beyond
the far plane.)
"""

import math
from typing import Any, NamedTuple

import numpy as np

from app.model.limits import vector
from app.model.parameter import Settings, number, point
from app.model.projection import Array, Projection
from app.model.refusal import REFUSALS, Refusal, format_value
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Copy, Grip, Mark, Marks, Text, named, plate, segment
from app.scenes.phenomena.picture import seen
from app.scenes.phenomena.words import PhenomenonWords, Phrase, Reading, figure

WORDS = PhenomenonWords("planar-shadow")


_PANES = ("world", "ndc", "image")
_TRUSTED = 1e30  # how far away a mark may be


def _light(settings: Settings) -> Array:
    """The light, homogeneous; the sun's direction is scaled so that its largest part is 1."""
    light = np.array([*point(settings, "light"), 1.0])
    if settings["kind"] == "sun":
        light[3] = 0.0
        light /= np.abs(light).max()
    return light


def shadow_matrix(light: Array, height: float) -> Array:
    """The matrix S that casts world points on the plane y = height, (4, 4).

    ``(p·L) I - L p^T`` with the plane p = (0, 1, 0, -height) and the homogeneous light (4,). w' > 0
    for points below a light above the plane.
    """
    plane = np.array([0.0, 1.0, 0.0, -height])
    # For a lamp, p·L is a difference that is rounded once.
    matrix = (light[1] - height * light[3]) * np.eye(4) - np.outer(light, plane)
    matrix[1, 1], matrix[3, 3] = -height * light[3], light[1]  # what is left of differences
    return np.asarray(matrix)


def on_ray(light: Array, height: float, place: Array) -> Array | None:
    """Where the ray from the light through a point meets y = height, without the matrix.

    None if the ray does not come down to the plane, or does so too far away.
    """
    way = -light[:3] if light[3] == 0.0 else place - light[:3]
    if way[1] >= 0.0:
        return None
    with np.errstate(over="ignore"):
        met: Array = place + (height - place[1]) / way[1] * way
    return met if (np.abs(met) < _TRUSTED).all() else None


class Cast(NamedTuple):
    """The shadows of n points: places (n, 3), and w' (n,) before the divide.

    A place is NaN where w' is 0 or too small to divide by. A point with w' <= 0 has no shadow.
    """

    places: Array
    w: Array


def cast(matrix: Array, points: Array) -> Cast:
    """Cast points (n, 3) with the matrix, and divide."""
    homogeneous = points @ matrix[:, :3].T + matrix[:, 3]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        places = homogeneous[:, :3] / homogeneous[:, 3:]
    places[~(np.abs(places) < _TRUSTED).all(axis=1)] = np.nan
    return Cast(places, homogeneous[:, 3])


def _check(settings: Settings) -> None:
    light, height = point(settings, "light"), number(settings, "height")
    if settings["kind"] == "sun":
        if not any(light):
            raise Refusal("settings.light", light, REFUSALS["not-zero"])
        if light[1] <= 0.0:
            raise Refusal("settings.light", light, REFUSALS["from-above"])
    elif light[1] <= height:
        raise Refusal("settings.light", light, REFUSALS["above-the-plane"], format_value(height))


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    light, height = _light(settings), number(settings, "height")
    matrix = shadow_matrix(light, height)
    shadows = cast(matrix, subject.points)
    too_high = int(np.count_nonzero(shadows.w <= 0.0))
    scaled = matrix / np.abs(matrix).max()  # the same map, in numbers that float32 holds
    copies = [Copy(scaled, _PANES, "shadow")]
    if too_high and not settings["clip"]:
        copies.append(Copy(-scaled, _PANES, "u"))
    # P is the highest vertex with a shadow, and among several the farthest along x.
    place = shadow = met = warning = None
    note = WORDS.phrase("no-shadow")
    lit = np.flatnonzero(shadows.w > 0.0)
    if len(lit):
        tops = subject.points[lit]
        chosen = lit[np.lexsort((tops[:, 0], tops[:, 1]))[-1]]
        place, note = subject.points[chosen], WORDS.phrase("far-away")
        met = on_ray(light, height, place)
        if np.isfinite(shadows.places[chosen]).all():
            shadow = shadows.places[chosen]
    inside = (np.array(subject.lower) <= light[:3]) & (light[:3] <= np.array(subject.upper))
    if light[3] == 1.0 and inside.all():
        warning = WORDS.phrase("in-the-object")
    elif place is None:
        warning = note
    pair = {"P": place, "P'": shadow}
    marked = [each for each in pair.values() if each is not None]
    names = [name for name, each in pair.items() if each is not None]
    trace = projection.trace(np.reshape(marked, (-1, 3)))
    measured = None if met is None else shadow
    off = None if measured is None else float(np.linalg.norm(measured - met))
    of_all = WORDS.phrase("of-all", str(len(subject.points)))
    world = _world_marks(settings, subject, light, marked)
    return Illustration(
        (
            Reading("S", tuple((matrix + 0.0).ravel().tolist()), note=_formula(settings, light)),
            *(
                Reading.or_why(WORDS[name], None if at is None else tuple(at.tolist()), why=note)
                for name, at in (("vertex", place), ("shadow", measured))
            ),
            Reading.or_why(WORDS["off"], off, why=note),
            Reading(WORDS["too-high"], float(too_high), note=of_all),
        ),
        world=world,
        image=Marks.of(
            *(
                named(name, at, size=1.2)
                for name, at, here in zip(names, trace.image, seen(trace), strict=True)
                if here
            )
        ),
        copies=tuple(copies),
        warning=warning,
        grips=(_grip(light, subject), _grip_of_ground(world)),
    )


def _formula(settings: Settings, light: Array) -> Phrase:
    """The parts of S."""
    parts = [-number(settings, "height"), *light[:3].tolist()]
    if light[3] == 1.0:
        return WORDS.phrase("of-lamp", *parts)
    return WORDS.phrase("of-sun", *parts, max(map(abs, point(settings, "light"))))


_MOST = 2.5  # of the reach below, from the object's middle to the plane's sides


def _reach(subject: Subject) -> tuple[Array, float]:
    """The object's middle, and the distances from it at which plane and sun are drawn."""
    low, high = np.array(subject.lower), np.array(subject.upper)
    return (low + high) / 2.0, 1.5 * subject.size


def _grip(light: Array, subject: Subject) -> Grip:
    """The lamp where it is; the sun where its direction is drawn."""
    if light[3] == 1.0:
        return Grip("light", light[:3], name="light")
    middle, reach = _reach(subject)
    away = light[:3] / np.linalg.norm(light[:3])
    return Grip("light", middle + reach * away, vector(middle), name="light")


def _grip_of_ground(world: Marks) -> Grip:
    """The plane, with the grip in the middle of its front edge."""
    plane = world.faces[0].points
    x, y, z = plane[2:].mean(axis=0).tolist()
    up = (0.0, 1.0, 0.0)
    return Grip("height", np.array([x, y, z]), (x, 0.0, z), up, "ground", "muted", plane)


def _world_marks(settings: Settings, subject: Subject, light: Array, marked: list[Array]) -> Marks:
    """The plane, the light, and the rays through the object's highest corners.

    `marked` are P and its shadow, if there are any.
    """
    height = number(settings, "height")
    middle, reach = _reach(subject)
    sun = light[3] == 0.0
    way = light[:3] / np.linalg.norm(light[:3]) if sun else light[:3]

    def ray(place: Array, end: Array, *drawn: Any) -> Mark:
        """From the light through a point to its end."""
        return segment(place + reach * way if sun else light[:3], end, *drawn)

    which = np.array([(x, 1, z) for x in (0, 1) for z in (0, 1)], dtype=bool)
    tops = np.where(which, subject.upper, subject.lower)
    ends = cast(shadow_matrix(light, height), tops)
    # The plane is as large as object, shadow and lamp ask for.
    cast_to = ends.places[(ends.w > 0.0) & np.isfinite(ends.places).all(axis=1)]
    spots = np.vstack([cast_to, tops, *([] if sun else [light[:3]])])
    room = np.array([middle - _MOST * reach, middle + _MOST * reach])
    (left, _, back), (right, _, front) = np.clip([spots.min(axis=0), spots.max(axis=0)], *room)
    rim = 0.1 * subject.size
    corners = np.array([(x, height, z) for x, z in (
        (left - rim, back - rim), (right + rim, back - rim),
        (right + rim, front + rim), (left - rim, front + rim),
    )])  # fmt: skip
    y = Text("ground", corners[3], text=f"y\N{NO-BREAK SPACE}= {figure(height, 4)}")
    world: list[Mark] = [plate(corners, "muted", 1.0, 0.2, (), "ground"), y]
    for top, end, w in zip(tops, ends.places, ends.w, strict=True):
        if w > 0.0:
            world.append(ray(top, end if np.isfinite(end).all() else top, "muted", 1.0))
        elif not settings["clip"] and np.isfinite(end).all():
            world.append(segment(top, end, "u", 0.5))
    if sun:
        head = middle + reach * way
        tail = head - 0.3 * reach * way
        world.append(segment(head, tail, "accent", 2.0))
        name = "height"
        text = f"{figure(math.degrees(math.asin(min(float(way[1]), 1.0))), 4)}°"
    else:
        head = light[:3]
        tail = np.array([head[0], height, head[2]])
        world.append(segment(head, tail, "ink", 1.0))
        name = "L_y"
        above = "L_y − h" if height else "L_y"
        text = f"{above} = {figure(head[1] - height, 4)}"
    world.append(Text(name, (head + tail) / 2.0, text=text))
    world.append(named("light", head, size=1.6, text=WORDS["sun" if sun else "lamp"]))
    world += [named(name, at, size=1.2) for name, at in zip(("P", "P'"), marked, strict=False)]
    if len(marked) == 2:
        world.append(ray(*marked, "accent", 1.5))
    return Marks.of(*world)


# The lamp casts the shadow, whatever the eye sees; beside the eye it would be half as large.
PHENOMENON = Phenomenon.of(WORDS, show=_show, check=_check)
