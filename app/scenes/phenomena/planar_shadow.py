"""Planar shadow: the scene once more under the matrix that projects it from the light.

A light L and a plane ``p·x = 0`` (both homogeneous; L has w = 0 for the sun) cast the point x on
the plane along the line through L and x::

    x' = (p·L) x - (p·x) L        S = (p·L) I - L p^T

which is a perspective projection with its centre in the light (lecture 002, "Perspective
shadows"), and a parallel one for the sun. For a light above the plane ``w' = p·L - L_w (p·x)`` is
the height of the light above the point: above 0 for what lies below the light. What is as high as
the light has its shadow at infinity, and what is higher has ``w' < 0``: divided all the same, it
is drawn on the other side of the light as an anti-shadow. The GPU cuts it off before it divides,
because it clips what has w < 0; the matrix -S turns the sign round and lets it through. (Where the
camera's own w is below 0 too, the product of both is above: such points are beyond the far plane.)
"""

from __future__ import annotations

import math
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from app.model.limits import NOT_ZERO
from app.model.projection import Array, Camera, Perspective, Projection
from app.model.refusal import QT_TRANSLATE_NOOP, Refusal, format_value
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Copy, Dot, Grip, Line, Mark, Marks, Text, named, plate
from app.scenes.phenomena.picture import seen
from app.scenes.phenomena.readout import Phrase, Reading, figure
from app.scenes.phenomena.settings import Setting, Settings, number, point
from app.scenes.phenomena.words import Words
from app.scenes.shapes import letter_f_on_grid

WORDS = Words("planar-shadow")

ABOVE_THE_PLANE = QT_TRANSLATE_NOOP(
    "Refusal",
    "must lie above the plane y = {0}: on the plane or under it, it casts no shadow on it",
)
FROM_ABOVE = QT_TRANSLATE_NOOP(
    "Refusal",
    "must point upward, to the sun: parallel to the plane or from under it, its rays never meet it",
)


_PANES = ("world", "ndc", "image")
_TRUSTED = 1e30  # how far away a mark may be


def _light(settings: Settings) -> Array:
    """The light, homogeneous; of the sun, whose length has no meaning, with 1 as largest part."""
    light = np.array([*point(settings, "light"), 1.0])
    if settings["kind"] == "sun":
        light[3] = 0.0
        light /= np.abs(light).max()
    return light


def shadow_matrix(light: Array, height: float) -> Array:
    """The matrix S that casts world points on the plane y = height, (4, 4).

    Parameters
    ----------
    light : (4,) array
        Homogeneous world coordinates.
    height : float

    Returns
    -------
    (4, 4) array
        ``(p·L) I - L p^T`` with the plane p = (0, 1, 0, -height); w' > 0 for points below a light
        that is above the plane.
    """
    plane = np.array([0.0, 1.0, 0.0, -height])
    # The difference first where the light is a point: p·L itself.
    matrix: Array = (light[1] - height * light[3]) * np.eye(4) - np.outer(light, plane)
    return matrix


def on_ray(light: Array, height: float, place: Array) -> Array | None:
    """Where the ray from the light through a point meets y = height; no matrix is used.

    Returns
    -------
    (3,) array or None
        None where the ray does not come down to the plane, or does so too far away.
    """
    way = -light[:3] if light[3] == 0.0 else place - light[:3]
    if way[1] >= 0.0:
        return None
    with np.errstate(over="ignore"):
        met: Array = place + (height - place[1]) / way[1] * way
    return met if (np.abs(met) < _TRUSTED).all() else None


class Cast(NamedTuple):
    """The shadows of n points.

    Attributes
    ----------
    places : (n, 3) array
        NaN where w' is 0 or too small to divide by.
    w : (n,) array
        Their w' before the divide; at 0 and below there is no shadow.
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
            raise Refusal("settings.light", light, NOT_ZERO)
        if light[1] <= 0.0:
            raise Refusal("settings.light", light, FROM_ABOVE)
    elif light[1] <= height:
        raise Refusal("settings.light", light, ABOVE_THE_PLANE, format_value(height))


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    light, height = _light(settings), number(settings, "height")
    matrix = shadow_matrix(light, height)
    shadows = cast(matrix, subject.points)
    too_high = int(np.count_nonzero(shadows.w <= 0.0))
    scaled = matrix / np.abs(matrix).max()  # the same map, with numbers that float32 holds
    copies = [Copy(scaled, _PANES, "shadow")]
    if too_high and not settings["clip"]:
        copies.append(Copy(-scaled, _PANES, "u"))
    # The vertex followed: the highest of those with a shadow, and among these the farthest one.
    lit = np.flatnonzero(shadows.w > 0.0)
    chosen = None
    if len(lit):
        tops = subject.points[lit]
        chosen = lit[np.lexsort((tops[:, 0], tops[:, 1]))[-1]]
    world, image = _marks(projection, settings, subject, light, shadows, chosen)
    inside = light[3] == 1.0 and all(
        low <= part <= high
        for low, part, high in zip(subject.lower, light[:3], subject.upper, strict=True)
    )
    warning = WORDS.phrase("in-the-object") if inside else None
    if warning is None and chosen is None:
        warning = WORDS.phrase("no-shadow")
    return Illustration(
        _readings(
            matrix, _formula(settings, light), light, height, subject, shadows, chosen, too_high
        ),
        world=world,
        image=image,
        copies=tuple(copies),
        warning=warning,
        grips=(_grip(light, subject),),
    )


def _formula(settings: Settings, light: Array) -> Phrase:
    """What S is made of."""
    parts = [-number(settings, "height"), *light[:3].tolist()]
    if light[3] == 1.0:
        return Phrase(WORDS["of-lamp"], tuple(parts))
    largest = max(map(abs, point(settings, "light")))
    return WORDS.phrase("of-sun", *parts, largest)


def _readings(
    matrix: Array,
    formula: Phrase,
    light: Array,
    height: float,
    subject: Subject,
    shadows: Cast,
    chosen: int | None,
    too_high: int,
) -> tuple[Reading, ...]:
    place = shadow = met = None
    note = WORDS.phrase("no-shadow")
    if chosen is not None:
        place = subject.points[chosen]
        note = WORDS.phrase("far-away")
        met = on_ray(light, height, place)
        if met is not None and np.isfinite(shadows.places[chosen]).all():
            shadow = shadows.places[chosen]
    off = None if shadow is None or met is None else float(np.linalg.norm(shadow - met))
    return (
        Reading("S", tuple(float(part) + 0.0 for part in matrix.reshape(-1)), note=formula),
        Reading.or_why(WORDS["vertex"], _three(place), why=note),
        Reading.or_why(WORDS["shadow"], _three(shadow), why=note),
        Reading.or_why(WORDS["off"], off, why=note),
        Reading(
            WORDS["too-high"],
            float(too_high),
            note=Phrase(WORDS["of-all"], (str(len(subject.points)),)),
        ),
    )


def _three(place: Array | None) -> tuple[float, ...] | None:
    return None if place is None else tuple(float(part) for part in place)


def _reach(subject: Subject) -> tuple[Array, float]:
    """The object's middle, and how far from it the plane and the sun are drawn."""
    low, high = np.array(subject.lower), np.array(subject.upper)
    return (low + high) / 2.0, 1.5 * subject.size


def _grip(light: Array, subject: Subject) -> Grip:
    """The lamp where it is; the sun where its direction is drawn."""
    if light[3] == 1.0:
        return Grip("light", light[:3])
    middle, reach = _reach(subject)
    x, y, z = middle.tolist()
    return Grip("light", middle + reach * light[:3] / np.linalg.norm(light[:3]), (x, y, z))


def _marks(
    projection: Projection,
    settings: Settings,
    subject: Subject,
    light: Array,
    shadows: Cast,
    chosen: int | None,
) -> tuple[Marks, Marks]:
    """World and image: the plane, the light, and the rays through the object's highest corners."""
    height = number(settings, "height")
    middle, reach = _reach(subject)
    corners = np.array(
        [
            (middle[0] + x * reach, height, middle[2] + z * reach)
            for x, z in ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0))
        ]
    )
    sun = light[3] == 0.0
    way = light[:3] / np.linalg.norm(light[:3]) if sun else light[:3]

    def ray(place: Array, end: Array, *drawn: Any) -> Line:
        """From the light through a point to its end."""
        return Line(np.array([place + reach * way if sun else light[:3], end]), *drawn)

    y = Text(f"y = {figure(height, 4)}", corners[3])
    world: list[Mark] = [plate(corners, "muted", 1.0, 0.2), y]
    which = np.array([(x, 1, z) for x in (0, 1) for z in (0, 1)], dtype=bool)
    tops = np.where(which, subject.upper, subject.lower)
    ends = cast(shadow_matrix(light, height), tops)
    for top, end, w in zip(tops, ends.places, ends.w, strict=True):
        if w > 0.0:
            world.append(ray(top, end if np.isfinite(end).all() else top, "muted"))
        elif not settings["clip"] and np.isfinite(end).all():
            world.append(Line(np.array([top, end]), "u", 0.5))
    if sun:
        head = middle + reach * way
        tail = head - 0.3 * reach * way
        world.append(Line(np.array([head, tail]), "accent", 2.0))
        above_deg = math.degrees(math.asin(min(float(way[1]), 1.0)))
        world.append(Text(f"{figure(above_deg, 4)}°", (head + tail) / 2.0))
    else:
        head = light[:3]
        foot = np.array([head[0], height, head[2]])
        world.append(Line(np.array([head, foot]), "ink", 1.0))
        above = "L_y − h" if height else "L_y"
        world.append(Text(f"{above} = {figure(head[1] - height, 4)}", (head + foot) / 2.0))
    world.append(named(WORDS["sun"] if sun else WORDS["lamp"], head, size=1.6))
    image = Marks()
    if chosen is not None:
        place, shadow = subject.points[chosen], shadows.places[chosen]
        world.append(named("P", place, size=1.2))
        shown = [place]
        if np.isfinite(shadow).all():
            world += [ray(place, shadow, "accent", 1.5), named("P'", shadow, size=1.2)]
            shown.append(shadow)
        trace = projection.trace(np.array(shown))
        image = Marks.of(*(Dot(at, "accent", 1.2) for at in trace.image[seen(trace)]))
    return Marks.of(*world), image


PHENOMENON = Phenomenon(
    WORDS,
    lectures=("002",),
    start=Projection(
        Camera((6.0, 7.5, 12.0), (1.9, 1.7, -0.6)), Perspective(fov_y_deg=32.0, near=4.0, far=24.0)
    ),
    geometry=partial(letter_f_on_grid, (-8.0, -8.0), (8.0, 8.0)),
    show=_show,
    adjustable=(
        Setting("kind", "point"),
        Setting("light", (-4.0, 9.0, 3.0)),
        Setting("height", 0.0, -1e6, 0.0, span=(-4.0, 0.0)),
        Setting("clip", True),
    ),
    numbers=3,
    check=_check,
    own_mesh=True,
)
