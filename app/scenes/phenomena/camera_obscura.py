"""Camera obscura: a dark box with a hole, and the synthetic camera that takes its place.

The hole is the centre of projection; the film is at distance d behind it. What is h high and z in
front of the hole is ``h' = -d h / z`` high on the film: upside down, and left for right. The
synthetic camera (lecture 001) has the same centre and puts its film in front of it, at the same
distance: there the image is ``+d h / z`` high. In this scene that film is the near plane.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from app.model.projection import Array, Camera, Perspective, Projection
from app.model.refusal import QT_TRANSLATE_NOOP
from app.scenes.phenomena.diagram import Curve, Diagram
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Copy, Dot, Line, Mark, Marks, Text, named, plate
from app.scenes.phenomena.picture import section, seen, seen_lines, world_from_view
from app.scenes.phenomena.readout import Phrase, Reading, of_parallel
from app.scenes.phenomena.settings import Found, Setting, Settings, number
from app.scenes.phenomena.similar_triangles import onto_plane
from app.scenes.shapes import letter_f_on_grid

_PARALLEL = QT_TRANSLATE_NOOP(
    "phenomena",
    "a parallel lens has no hole that all light goes through: choose a perspective lens",
)
_BEHIND = QT_TRANSLATE_NOOP(
    "phenomena", "the arrow is behind the hole or beside it: no light comes from it into the box"
)
_FILM = QT_TRANSLATE_NOOP("phenomena", "film")
_IN_FRONT = QT_TRANSLATE_NOOP("phenomena", "synthetic film")
_HOLE_NAME = QT_TRANSLATE_NOOP("phenomena", "hole")
_SLAB = 4e-3  # of the film's distance: thickness of the picture on it
_BESIDE = 0.1  # of the subject's height, from its left side to the arrow


def heights(
    projection: Projection, distance: float, bottom: Array, top: Array
) -> tuple[float, float]:
    """How high an arrow's image is on the film behind the hole, and on the one in front.

    Parameters
    ----------
    projection : Projection
    distance : float
        Of either film from the hole, d.
    bottom, top : (3,) array
        World coordinates of the arrow's ends, which are in front of the hole.

    Returns
    -------
    behind, in_front : float
        Differences of ``-d y / w`` and of ``d y / w``; positive where the head is above the foot.
    """
    (_, y_bottom, z_bottom), (_, y_top, z_top) = projection.trace([bottom, top]).view.tolist()
    in_front = distance * y_top / -z_top - distance * y_bottom / -z_bottom
    return -in_front, in_front


def _arrow(projection: Projection, subject: Subject) -> Array:
    """Foot and head of an arrow beside the subject, as high as it, along v, (2, 3)."""
    lower, upper = np.array(subject.lower), np.array(subject.upper)
    height = float(upper[1] - lower[1])
    foot = np.array([lower[0] - _BESIDE * height, lower[1], (lower[2] + upper[2]) / 2.0])
    return np.array([foot, foot + height * projection.camera.frame[1]])


def _show(projection: Projection, _settings: Settings, subject: Subject) -> Illustration:
    if (parallel := of_parallel(projection, _PARALLEL)) is not None:
        return Illustration((), warning=parallel)
    camera, d = projection.camera, projection.lens.near
    hole, arrow = np.array(camera.eye), _arrow(projection, subject)
    trace = projection.trace(arrow)
    h = float(np.linalg.norm(arrow[1] - arrow[0]))
    z = -float(trace.view[0, 2]) + 0.0

    film, front = section(projection, -d), section(projection, d)
    wall = film + d * -camera.frame[2]  # the box' front, which has the hole in its middle
    world: list[Mark] = [plate(film, "v", 1.5, 0.2), plate(wall, "ink", 1.0, 0.16)]
    world += [Line(side, "ink", 1.0) for side in np.stack([wall, film], axis=1)]
    world += [Text(_FILM, film[1], "v"), Text(_IN_FRONT, front[3], "near")]
    world += [Dot(hole, "ink", 1.2), Text(_HOLE_NAME, hole)]
    behind = in_front = None
    diagrams: tuple[Diagram, ...] = ()
    image: list[Mark] = []
    slab = _SLAB * d
    if z > 0.0:
        behind, in_front = heights(projection, d, arrow[0], arrow[1])
        x, y = trace.view[:, 0] / z, trace.view[:, 1] / z
        on_film = world_from_view(projection, np.column_stack([-d * x, -d * y, [d, d]]))
        on_front = world_from_view(projection, np.column_stack([d * x, d * y, [-d, -d]]))
        world += [Line(np.array(ends), "accent", 1.0) for ends in zip(arrow, on_film, strict=True)]
        for name, each in (("h", arrow), ("−d·h/z", on_film), ("d·h/z", on_front)):
            world += [Line(each, "accent", 3.0), named(name, each[1])]
        diagrams = (_diagram(d, z, y * z),)
        slab *= z
        image += seen_lines(projection, trace.clip[None], ("accent",), 3.0)
        if seen(trace)[1]:
            image.append(Dot(trace.image[1], "accent", 1.3))
    why = Phrase(_BEHIND)
    readings = (
        Reading.or_why(
            QT_TRANSLATE_NOOP("phenomena", "on the film: h' = −d·h / z"), behind, why=why
        ),
        Reading.or_why(
            QT_TRANSLATE_NOOP("phenomena", "film in front: +d·h / z"), in_front, why=why
        ),
        Reading(QT_TRANSLATE_NOOP("phenomena", "the arrow's height h"), h),
        Reading(QT_TRANSLATE_NOOP("phenomena", "its distance z from the hole"), z),
    )
    return Illustration(
        readings,
        world=Marks.of(*world),
        image=Marks.of(*image),
        copies=(Copy(onto_plane(projection, -d, slab)),),
        diagrams=diagrams,
        measured=(("d", d), ("z", z)),
    )


def _diagram(d: float, z: float, y: Array) -> Diagram:
    """The box from the side: the arrow, both films, and the light through the hole."""
    foot, head = y.tolist()
    scale = d / z
    half = 1.3 * max(abs(foot), abs(head)) * scale
    rays = [[(z, end), (-d, -scale * end)] for end in (foot, head)]
    high = 1.1 * max(abs(foot), abs(head), half)
    box = np.array([(-d, -half), (0.0, -half), (0.0, half), (-d, half)])

    def arrow(at: float, size: float) -> Array:
        """Shaft and head of an arrow whose foot and head are these times the object's."""
        tip, length = size * head, size * (head - foot)
        back, wide = tip - 0.12 * length, 0.05 * abs(length)
        return np.array(
            [(at, size * foot), (at, tip), (at - wide, back), (at, tip), (at + wide, back)]
        )

    return Diagram(
        QT_TRANSLATE_NOOP("phenomena", "From the side"),
        (
            Curve(box, "ink", width=1.5, closed=True),
            *(Curve(np.array(ray), "accent", width=0.8) for ray in rays),
            Curve(np.array([(d, -half), (d, half)]), "near", width=1.5),
            Curve(arrow(z, 1.0), "accent", "h", width=2.5),
            Curve(arrow(-d, -scale), "accent", "−d·h / z", width=2.5),
            Curve(arrow(d, scale), "accent", "d·h / z", width=2.5),
            Curve(np.zeros((1, 2)), "ink", _HOLE_NAME, dots=True),
        ),
        *(-d - 0.1 * (z + d), z + 0.1 * (z + d), -high, high),
        equal=True,
    )


def _follow(projection: Projection, before: Found, after: Settings) -> Projection:
    d = number(after, "distance")
    if before["distance"] is not None and number(before, "distance") == d:
        return projection
    central = projection.with_eye()
    return central.between(d, central.lens.far)


def _found(projection: Projection, _settings: Settings) -> Found:
    return {"distance": projection.lens.near if projection.lens.central else None}


PHENOMENON = Phenomenon(
    name="camera-obscura",
    title=QT_TRANSLATE_NOOP("phenomena", "Camera obscura"),
    explanation=QT_TRANSLATE_NOOP(
        "phenomena",
        "Light enters a dark box by a small hole and crosses there, so that the picture on the film"
        " behind it is upside down and left for right: h' = −d·h/z. The synthetic camera has its"
        " centre where the hole is, and its film as far in front of it: the image is as large, and"
        " upright. Only the sign of the numbers is another.",
    ),
    tries=(
        QT_TRANSLATE_NOOP("phenomena", "Double d: how large is h'?"),
        QT_TRANSLATE_NOOP("phenomena", "Double z: and now?"),
        QT_TRANSLATE_NOOP("phenomena", "Compare both films: what is turned over?"),
    ),
    lectures=("001", "002"),
    start=Projection(
        Camera((0.5, 2.5, 9.0), (0.5, 2.5, 0.0)), Perspective(fov_y_deg=38.0, near=4.0, far=10.5)
    ),
    geometry=partial(letter_f_on_grid, (-4.0, -3.0), (5.0, 5.0)),
    show=_show,
    settings=(
        Setting(
            "distance",
            QT_TRANSLATE_NOOP("phenomena", "Film distance d"),
            QT_TRANSLATE_NOOP(
                "phenomena",
                "From the hole to the film behind it, and to the synthetic one in front: near",
            ),
            4.0,
            low=1e-3,
            high=1e6,
            span=(1.0, 8.0),
        ),
    ),
    controls=("camera.distance", "lens.fov_y_deg"),
    replaces=("near",),
    numbers=4,
    follow=_follow,
    found=_found,
    own_mesh=True,
)
