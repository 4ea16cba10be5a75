"""Far objects popping in, and lecture 001's two remedies: fog and level of detail.

Along an avenue with a tree every `SPACING` on both sides, a tree of each row passes the far plane
every ``SPACING / speed``. With density 1/SPACING a row, ``speed x density`` trees a second appear
out of nothing or, looking back, vanish into it. Fog hides that where it leaves little contrast at
the far plane: ``(end - far)/(end - start)`` for linear fog, ``exp(-density far)`` for exponential.
Level of detail draws far trees with fewer vertices, so that the far plane can be farther away at
the same cost.
"""

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from app.model.limits import vector
from app.model.parameter import ImpliedSettings, Settings, number
from app.model.projection import LARGEST, PLANES, Array, Projection
from app.model.refusal import REFUSALS, Refusal
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import DetailLevel, Fog, Marks, Polyline, Rendering, Text, outline
from app.scenes.phenomena.picture import SIDES, cut_in_picture
from app.scenes.phenomena.words import Curve, Diagram, PhenomenonWords, Reading
from app.scenes.shapes import Coloured, box_corners, brightness, ground_grid

WORDS = PhenomenonWords("far-plane-popping")

SPEED = WORDS.settings["position"].per_second
SPACING = 6.0
ROWS = (-4.0, 4.0)  # world x of the two rows of trees; they stand at z = 0, -SPACING, ...
TREES = 60  # in a row
HEIGHT = 5.0

_TRUNK_RGB, _CROWN_RGB = (150, 100, 60), (0, 158, 115)
# Of each level: sides of the trunk and of the crown, and radius and height of the crown's rings.
_SHAPES = (
    (8, 12, ((1.5, 1.2), (0.75, 2.6), (1.2, 2.6), (0.5, 3.8), (0.8, 3.8), (0.02, HEIGHT))),
    (4, 6, ((1.5, 1.2), (0.02, HEIGHT))),
    (0, 3, ((1.5, 1.2), (0.02, HEIGHT))),
)
_RADIUS = 1.5
_NAMED_AT = 1.25  # of its height: the name stands above the nearer trees, which are higher
_RIGHT = 400.0  # of the diagram, where far is farther


def _ring(radius: float, height: float, sides: int) -> Array:
    angle = 2.0 * np.pi * np.arange(sides) / sides
    return np.stack([radius * np.sin(angle), np.full(sides, height), radius * np.cos(angle)], 1)


def _between(lower: Array, upper: Array) -> Array:
    """Quads (sides, 4, 3) between two rings, counter-clockwise from outside."""
    return np.stack([lower, np.roll(lower, -1, axis=0), np.roll(upper, -1, axis=0), upper], axis=1)


def _rings(level: int) -> list[list[Array]]:
    """The rings of a tree at the origin: the crown's, and the trunk's if it has one."""
    trunk_sides, crown_sides, rings = _SHAPES[level]
    crown = [_ring(radius, height, crown_sides) for radius, height in rings]
    trunk = [_ring(0.25, 0.0, trunk_sides), _ring(0.2, 1.2, trunk_sides)]
    return [crown, trunk] if trunk_sides else [crown]


def _tree(level: int) -> Coloured:
    crown, *trunk = _rings(level)
    parts = [(_between(*each), _TRUNK_RGB) for each in trunk]
    parts += [(_between(low, high), _CROWN_RGB) for low, high in pairwise(crown)]
    colours = []
    for quads, rgb in parts:
        normals = np.cross(quads[:, 1] - quads[:, 0], quads[:, 3] - quads[:, 0])
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        lit = brightness(normals / np.where(lengths > 0.0, lengths, 1.0))
        colours.append((lit[:, None] * np.array(rgb)).astype(np.uint8))
    return np.concatenate([quads for quads, _ in parts]), np.concatenate(colours)


@cache
def places() -> Array:
    """Where the trees stand, (2 TREES, 3)."""
    return np.array([(x, 0.0, z) for x in ROWS for z in -SPACING * np.arange(TREES)])


@cache
def _levels() -> tuple[tuple[Coloured, Array], ...]:
    """For each level, the faces of all trees, and the place of each face's tree."""
    made = []
    for level in range(len(_SHAPES)):
        quads, rgb = _tree(level)
        all_quads = (places()[:, None, None] + quads).reshape(-1, 4, 3)
        objects = np.repeat(places(), len(quads), axis=0)
        made.append(((all_quads, np.tile(rgb, (len(places()), 1))), objects))
    return tuple(made)


VERTICES = tuple(4 * (trunk + crown * (len(rings) - 1)) for trunk, crown, rings in _SHAPES)
"""Of one tree, at each level of detail."""


def _geometry() -> tuple[Coloured, Coloured]:
    length = SPACING * (TREES - 1)
    return _levels()[0][0], ground_grid((-8.0, -length), (8.0, 8.0), (4.0, 12.0), 0.0)


def _check(settings: Settings) -> None:
    for low, high in (("fog_start", "fog_end"), ("detail_1", "detail_2")):
        first, second = number(settings, low), number(settings, high)
        if second <= first:
            raise Refusal(f"settings.{high}", second, REFUSALS["above"], first)


def fog_of(settings: Settings) -> Fog | None:
    if settings["fog"] == "linear":
        return Fog(number(settings, "fog_start"), number(settings, "fog_end"))
    if settings["fog"] == "exponential":
        return Fog(density=number(settings, "fog_density"))
    return None


def trees_in_view(projection: Projection) -> NDArray[np.bool_]:
    """Which of the `places` (n,) have a tree in the view volume, judged by its bounds."""
    corners = box_corners((-_RADIUS, 0.0, -_RADIUS), (_RADIUS, HEIGHT, _RADIUS))
    outside = projection.trace(places()[:, None] + corners).outside
    beyond_one_plane = np.asarray(outside.all(axis=1))
    return np.asarray(~beyond_one_plane.any(axis=1))


def vertices_drawn(projection: Projection, seen: NDArray[np.bool_], until: Sequence[float]) -> int:
    """Vertices of the trees that are `seen`, each at its level.

    The next level begins at each of the two distances `until`; infinity for none.
    """
    w = -projection.trace(places()[seen]).view[:, 2]
    return int(np.array(VERTICES)[np.searchsorted(until, w, side="right")].sum())


def popped_per_second(
    projection: Projection, until: Sequence[float] = (math.inf, math.inf)
) -> tuple[float, float]:
    """Trees a second that come into the picture and that leave it through the far plane.

    The camera drives along -z at `SPEED`. If it looks ahead all of them come, if it looks back all
    of them go. A tree counts if a part of it is in the picture.
    """
    far, camera = projection.lens.far, projection.camera
    n = camera.frame[2]
    if far == math.inf or n[2] == 0.0:
        return 0.0, 0.0
    outline = _outline(int(np.searchsorted(until, far, side="right")))
    # For the camera a tree moves along z, and meets the far plane where w = n . (eye - p) = far.
    places = np.zeros((len(ROWS), *outline.shape[:2], 3))
    places[..., :2] = outline
    places[..., 0] += np.array(ROWS)[:, None, None]
    with np.errstate(over="ignore"):
        places[..., 2] = (float(n @ np.array(camera.eye)) - far - places @ n) / n[2]
    if not (np.abs(places) <= LARGEST).all():  # too far away for anything to pass it
        return 0.0, 0.0
    clip, z = projection.trace(places).clip, places[..., 2:]
    x_y, w = clip[..., :2], clip[..., 3:]
    along = z + SPACING * (TREES - 0.5), SPACING / 2.0 - z
    within = np.concatenate([w + x_y, w - x_y, *along], axis=-1)
    rows = sum(any(_is_within(part) for part in row) for row in within.tolist())
    rate = rows * SPEED / SPACING
    return (rate, 0.0) if n[2] > 0.0 else (0.0, rate)


@cache
def _outline(level: int) -> Array:
    """A tree seen along z, the direction of the drive: trapezoids (k, 4, 2) of x and y."""
    return np.array([
        [ring[at, :2] for ring, at in ((one, left), (one, right), (other, right), (other, left))]
        for stack in _rings(level) for one, other in pairwise(stack)
        for left, right in [(one[:, 0].argmin(), one[:, 0].argmax())]
    ])  # fmt: skip


def _is_within(polygon: list[list[float]]) -> bool:
    """Whether a convex polygon has a point whose numbers, a few for each corner, are all >= 0."""
    for which in range(len(polygon[0])):
        kept = []
        for here, there in zip(polygon, polygon[1:] + polygon[:1], strict=True):
            if here[which] >= 0.0:
                kept.append(here)
            if (here[which] < 0.0) != (there[which] < 0.0):
                share = here[which] / (here[which] - there[which])
                kept.append([a + share * (b - a) for a, b in zip(here, there, strict=True)])
        polygon = kept
        if not polygon:
            return False
    return True


def _follow(projection: Projection, before: ImpliedSettings, after: Settings) -> Projection:
    step = number(after, "position") - number(before, "position")
    if step == 0.0:
        return projection
    camera, way = projection.camera, np.array([0.0, 0.0, step])
    eye, target = vector(camera.eye - way), vector(camera.target - way)
    return replace(projection, camera=replace(camera, eye=eye, target=target))


def _implied(projection: Projection, _settings: Settings) -> ImpliedSettings:
    return {"position": PHENOMENON.start.camera.eye[2] - projection.camera.eye[2]}


def _show(projection: Projection, settings: Settings, _subject: Subject) -> Illustration:
    far, fog, until = projection.lens.far, fog_of(settings), (math.inf, math.inf)
    if settings["detail"]:
        until = (number(settings, "detail_1"), number(settings, "detail_2"))
    levels = tuple(
        DetailLevel(faces, objects, end)
        for (faces, objects), end in zip(_levels(), (*until, math.inf), strict=True)
    )
    note = WORDS.phrase("far-at-infinity") if far == math.inf else None
    contrast = 1.0 if fog is None else fog.left(far)
    popped_in, popped_out = popped_per_second(projection, until)
    why = note if note is not None or popped_in + popped_out > 0.0 else WORDS.phrase("none-pops")
    seen = trees_in_view(projection)
    contrast_left = 100.0 * contrast if why is None else None
    world, image = _next_tree(projection)
    return Illustration(
        (
            Reading(WORDS["vertices"], float(vertices_drawn(projection, seen, until))),
            Reading(WORDS["without-detail"], float(VERTICES[0] * int(seen.sum()))),
            Reading(WORDS["pop-in"], popped_in, note=note),
            Reading(WORDS["pop-out"], popped_out, note=note),
            Reading(WORDS["contrast"], contrast_left, "%", why),
        ),
        world=world,
        image=image,
        diagrams=(_diagram(fog, far),),
        rendering=Rendering(fog=fog, levels=levels),
    )


def _next_tree(projection: Projection) -> tuple[Marks, Marks]:
    """The outline of the nearest tree behind the far plane, in the world and in the image."""
    middles = projection.trace(places() + np.array([0.0, HEIGHT / 2.0, 0.0]))
    waits = middles.outside[:, PLANES.index("far")] & (middles.outside.sum(axis=1) == 1)
    if not waits.any():
        return Marks(), Marks()
    w = np.where(waits, -middles.view[:, 2], math.inf)
    tree, across = places()[int(w.argmin())], _RADIUS * projection.camera.frame[0]
    up = np.array([0.0, 1.0, 0.0])
    outline_world = outline(np.array([tree + 1.2 * up - across, tree + 1.2 * up + across,
                                      tree + HEIGHT * up]))  # fmt: skip
    trace = projection.trace(outline_world)
    pieces = cut_in_picture(projection, trace.clip[:-1], trace.clip[1:], SIDES)
    lines = [Polyline(piece, "accent", 1.5) for piece in pieces if piece is not None]
    text = Text("next-tree", outline_world[2], "accent", text=WORDS["next-tree"])
    world = Marks.of(Polyline(outline_world, "accent", 2.0), text)
    top = projection.trace(tree + _NAMED_AT * HEIGHT * up).image
    in_frame = ((top >= 0.0) & (top <= projection.image_size)).all()
    return world, Marks.of(*lines, *([replace(text, point=top)] if in_frame else []))


def _diagram(fog: Fog | None, far: float) -> Diagram:
    """Contrast over distance, and where the far plane cuts it off."""
    right = 1.1 * (far if 0.0 < far < _RIGHT else _RIGHT)
    w = np.linspace(0.0, right, 120)
    left = np.array([1.0 if fog is None else fog.left(at) for at in w.tolist()])
    curves = [Curve(np.stack([w, 100.0 * left], axis=1), "accent", width=2.0)]
    if 0.0 < far <= right:
        curves.append(Curve(np.array([(far, 0.0), (far, 100.0)]), "far", WORDS["far"]))
    axes = (0.0, right, 0.0, 100.0)
    return Diagram(WORDS["diagram"], tuple(curves), *axes, x_label="w", y_label="%")


PHENOMENON = Phenomenon.of(
    WORDS, geometry=_geometry, show=_show, follow=_follow, implied=_implied, check=_check
)
