"""Cracks: two meshes that share a seam, and light through it once each is quantised in its own box.

A grid of ``2^bits - 1`` steps over a box moves a vertex by at most half a step along each axis. Two
meshes round the same vertex on two grids, of steps a and b, so its copies come to lie at most
``(a + b)/2`` apart along each axis, and in a plane parallel to the picture

    sqrt 2 (a + b)/2

apart. If X, Y, W are its clip coordinates, an offset moves its picture by exactly ``(dX - x dW)/(W
+ dW)``, which bounds the gap from everywhere. A common grid rounds both copies to the same place.
"""

import math
from functools import cache

import numpy as np

from app.arithmetic.formats import Grid
from app.model.parameter import Settings, number
from app.model.projection import Array, Projection
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Marks, Polyline, Text, Vertices
from app.scenes.phenomena.words import Curve, Diagram, PhenomenonWords, Reading
from app.scenes.shapes import SIDE_RGB, Coloured, flat, ground_grid, joined

WORDS = PhenomenonWords("cracks")

SIZES = 10.0, 3.0  # widths of the two boxes, from which their steps follow
_HIGH = 0.9
_Y = np.linspace(-_HIGH, _HIGH, 25)
SEAM: Array = np.column_stack([0.3 * np.sin(2.1 * _Y) + 0.11 * _Y, _Y, np.zeros(len(_Y))])
ROUNDED_UP = 1.0 + 2.0**-30
_LIGHT_RGB = (255, 214, 60)
_LIGHT = np.array([[(-1, -1, -0.02), (1, -1, -0.02), (1, 1, -0.02), (-1, 1, -0.02)]])
_LIGHT *= 1.0, _HIGH, 1.0


def meshes(sizes: tuple[float, float]) -> Array:
    """Return the outer and the seam's vertices of the left and the right mesh, (2, 2, n, 3)."""
    both = np.array(2 * [[SEAM, SEAM]])
    both[0, 0, :, 0] = SEAM[:, 0].max() - sizes[0]
    both[1, 0, :, 0] = SEAM[:, 0].min() + sizes[1]
    return both


def grids(both: Array, bits: int, common: bool) -> list[Grid]:
    """Return the grid of each mesh: over its own box, or over the box of both."""
    boxes = [np.array([each.min(axis=(0, 1)), each.max(axis=(0, 1))]) for each in both]
    if common:
        return 2 * [Grid.of_box([np.minimum(*boxes)[0], np.maximum(*boxes)[1]], bits)]
    return [Grid.of_box(box, bits) for box in boxes]


@cache
def _own() -> Array:
    """The vertices of both meshes and of the light; those of the seam are not the same ones."""
    both = meshes(SIZES)
    both[1, 1, :, 0] += 1e-4
    return np.concatenate([both.reshape(-1, 3), _LIGHT[0]])


def _geometry() -> tuple[Coloured, Coloured]:
    both = _own()[:-4].reshape(2, 2, -1, 3)
    quads = [np.stack([outer[:-1], seam[:-1], seam[1:], outer[1:]], axis=1) for outer, seam in both]
    colours = (flat(SIDE_RGB[row], len(SEAM) - 1) for row in (5, 3))
    faces = joined(*zip(quads, colours, strict=True), (_LIGHT, flat(_LIGHT_RGB, 1)))
    return faces, ground_grid((-10.0, -1.0), (3.0, 2.0), (1.0, 1.0), -_HIGH - 0.1)


def bound_px(projection: Projection, seam: Array, half: float) -> Array:
    """Bound the gaps (n,) in px between copies that are `half` off along x and y, together."""
    clip, rows = projection.trace(seam).clip, projection.clip_from_world[[0, 1, 3], :2]
    w = clip[:, 3] - half * np.abs(rows[2]).sum()
    place = clip[:, :2] / clip[:, 3:]
    off = np.abs(rows[:2] - place[..., None] * rows[2]).sum(axis=2) * half
    with np.errstate(divide="ignore", invalid="ignore"):
        px = np.hypot(*(off / w[:, None] * np.array(projection.image_size) / 2.0).T)
    return np.where(w > 0.0, ROUNDED_UP * px, math.inf)


def _show(projection: Projection, settings: Settings, _subject: Subject) -> Illustration:
    both = meshes((number(settings, "left"), number(settings, "right")))
    each = grids(both, int(str(settings["bits"])), settings["grid"] == "common")
    kept = np.array([grid.rounded(mesh) for grid, mesh in zip(each, both, strict=True)])
    places = np.concatenate([kept.reshape(-1, 3), _LIGHT[0]])
    world = Marks.of(
        *(Polyline(seam, "ink", 1.0, name="seam") for seam in kept[:, 1]),
        Text("seam", SEAM[-1], text=WORDS["seam"]),
        Text("left-mesh", kept[0, 0, -1], "n", text=WORDS["left"]),
        Text("right-mesh", kept[1, 0, -1], "v", text=WORDS["right"]),
    )
    traces, vertices = projection.trace(kept[:, 1]), Vertices(_own(), places, places)
    if not (projection.trace(SEAM).in_front.all() and traces.in_front.all()):
        return Illustration((), world, vertices=vertices, warning=WORDS.phrase("behind"))
    gaps = np.hypot(*(traces.image[0] - traces.image[1]).T)
    half = 0.0 if each[0] is each[1] else sum(grid.step for grid in each) / 2.0
    bounds = bound_px(projection, SEAM, half)
    most = float(bounds.max())
    moved = np.linalg.norm(kept[1, 1] - SEAM, axis=1)
    top = 1.15 * (most if 0.0 < most < math.inf else 1.0)
    curves = (
        Curve(np.column_stack([_Y, gaps]), "accent", WORDS["gap"], 2.0),
        Curve(np.column_stack([_Y, np.minimum(bounds, top)]), "muted", WORDS["bound"]),
    )
    return Illustration(
        (
            Reading.or_why(WORDS["predicted"], most, "px", WORDS.phrase("no-bound")),
            Reading(WORDS["measured"], float(gaps.max()), "px"),
            Reading(WORDS["bytes"], 3.0 * each[0].bits / 8.0),
            Reading(WORDS["steps"], tuple(grid.step for grid in each)),
            Reading(WORDS["moved"], float(moved.max())),
        ),
        world,
        diagrams=(Diagram(WORDS["diagram"], curves, -_HIGH, _HIGH, 0.0, top, "y", WORDS["px"]),),
        vertices=vertices,
    )


PHENOMENON = Phenomenon.of(WORDS, geometry=_geometry, show=_show)
