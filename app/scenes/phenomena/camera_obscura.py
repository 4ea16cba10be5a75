"""Camera obscura: a dark box with a hole, and the synthetic camera that takes its place.

The hole is the centre of projection, and the film is at distance d behind it. An object of height
h, z in front of the hole, is ``h' = -d h / z`` high on the film: upside down, and left for right.
The synthetic camera (lecture 001) has the same centre and puts its film in front of it, at the same
distance, where the image is ``+d h / z`` high. In this scene that film is the near plane.
"""

import numpy as np

from app.model.parameter import ImpliedSettings, Settings, number
from app.model.projection import Array, Projection
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Copy, Dot, Mark, Marks, Polyline, Text, named, plate, segment
from app.scenes.phenomena.picture import grip_of_plane, section, seen, seen_lines, world_from_view
from app.scenes.phenomena.similar_triangles import SLAB, onto_plane
from app.scenes.phenomena.words import Curve, Diagram, PhenomenonWords, Reading

WORDS = PhenomenonWords("camera-obscura")

_BESIDE = 0.1  # of the subject's height, from its left side to the arrow


def _arrow(projection: Projection, subject: Subject) -> Array:
    """Foot and head of an arrow beside the subject, as high as it and along v, (2, 3)."""
    lower, upper = np.array(subject.lower), np.array(subject.upper)
    height = float(upper[1] - lower[1])
    foot = np.array([lower[0] - _BESIDE * height, lower[1], (lower[2] + upper[2]) / 2.0])
    return np.array([foot, foot + height * projection.camera.frame[1]])


def _show(projection: Projection, _settings: Settings, subject: Subject) -> Illustration:
    if (parallel := WORDS.of_parallel(projection)) is not None:
        return Illustration((), warning=parallel)
    camera, d = projection.camera, projection.lens.near
    hole, arrow = np.array(camera.eye), _arrow(projection, subject)
    trace = projection.trace(arrow)
    h = float(np.linalg.norm(arrow[1] - arrow[0]))
    z = -float(trace.view[0, 2]) + 0.0

    film, front = section(projection, -d), section(projection, d)
    wall = film + d * -camera.frame[2]  # the front of the box, with the hole in its middle
    world: list[Mark] = [plate(film, "v", 1.5, 0.2, (), "film"), plate(wall, "ink", 1.0, 0.16)]
    world += [Polyline(side, "ink", 1.0) for side in np.stack([wall, film], axis=1)]
    world += [Text("film", film[1], "v", text=WORDS["film"])]
    world += [Text("front", front[3], "near", text=WORDS["front"])]
    world += [Dot(hole, "ink", 1.2), Text("hole", hole, text=WORDS["hole"])]
    behind = in_front = None
    diagrams: tuple[Diagram, ...] = ()
    image: list[Mark] = []
    slab = SLAB * d
    if z > 0.0:
        behind, in_front = -d * h / z, d * h / z
        x, y = trace.view[:, 0] / z, trace.view[:, 1] / z
        on_film = world_from_view(projection, np.column_stack([-d * x, -d * y, [d, d]]))
        on_front = world_from_view(projection, np.column_stack([d * x, d * y, [-d, -d]]))
        world += [segment(*ends, "accent", 1.0) for ends in zip(arrow, on_film, strict=True)]
        world += [Polyline(each, "accent", 3.0) for each in (arrow, on_film, on_front)]
        world += [Dot(on_front[1], "accent", 1.3), named("h", arrow[1]), named("h'", on_film[1])]
        axis = world_from_view(projection, np.array([(0.0, 0.0, d), (0.0, 0.0, -z)]))
        for name, end, colour in zip("dz", axis, ("v", "muted"), strict=True):
            world += [segment(hole, end, colour, 1.0), Text(name, (hole + end) / 2.0, colour)]
        diagrams = (_diagram(d, z, y * z),)
        slab *= z
        image += seen_lines(projection, trace.clip[None], ("accent",), 3.0)
        if seen(trace)[1]:
            image.append(Dot(trace.image[1], "accent", 1.3))
    why = WORDS.phrase("behind")
    readings = (
        Reading.or_why(WORDS["on-film"], behind, why=why),
        Reading.or_why(WORDS["on-front"], in_front, why=why),
        Reading(WORDS["height"], h),
        Reading(WORDS["distance"], z),
    )
    return Illustration(
        readings,
        world=Marks.of(*world),
        image=Marks.of(*image),
        copies=(Copy(onto_plane(projection, -d, slab)),),
        diagrams=diagrams,
        grips=(grip_of_plane(projection, "distance", d, -d, "film", "v"),),
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
        """An arrow of so many times the object's size."""
        tip, length = size * head, size * (head - foot)
        back, wide = tip - 0.12 * length, 0.05 * abs(length)
        x = at + wide * np.array([0.0, 0.0, -1.0, 0.0, 1.0])
        return np.column_stack([x, [size * foot, tip, back, tip, back]])

    return Diagram(
        WORDS["side"],
        (
            Curve(box, "ink", width=1.5, closed=True),
            *(Curve(np.array(ray), "accent", width=0.8) for ray in rays),
            Curve(np.array([(d, -half), (d, half)]), "near", width=1.5),
            Curve(arrow(z, 1.0), "accent", "h", width=2.5),
            Curve(arrow(-d, -scale), "accent", "−d·h / z", width=2.5),
            Curve(arrow(d, scale), "accent", "d·h / z", width=2.5),
            Curve(np.zeros((1, 2)), "ink", WORDS["hole"], dots=True),
        ),
        *(-d - 0.1 * (z + d), z + 0.1 * (z + d), -high, high),
        equal=True,
    )


def _follow(projection: Projection, before: ImpliedSettings, after: Settings) -> Projection:
    d = number(after, "distance")
    if before["distance"] is not None and number(before, "distance") == d:
        return projection
    central = projection.with_eye()
    return central.between(d, central.lens.far)


PHENOMENON = Phenomenon.of(
    WORDS,
    show=_show,
    follow=_follow,
    implied=lambda at, _: {"distance": at.lens.near if at.lens.central else None},
)
