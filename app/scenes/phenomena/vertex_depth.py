"""Depth at the vertices: a logarithmic depth is right per pixel, and too far between vertices.

On the screen 1/w is linear along a face. A depth log w that only its vertices have is interpolated
there as if it were linear, too. A piece from the distance m to r m, at the share s of it on the
screen, is drawn at m r^s instead of at m / (1 - s + s/r), too far by the factor

    r^s (1 - s + s/r)    at most q exp(1/q - 1) with q = (1 - 1/r) / log r, at w = m/q,

where the derivative is 0. It is never below 1: an arithmetic mean over a geometric one, of 1/w.

The floor lies in y = 0, from near to far, in pieces of equal length. Depths are moved as vertices
are: along its projector, to where the standard depth is what its logarithm is. So the rasteriser
itself interpolates them. The world shows the floor as the depths say: a trough.
"""

import math
from functools import cache

import numpy as np

from app.model.parameter import Settings, number
from app.model.projection import Array, Projection
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Marks, Polyline, Text, Vertices, outline
from app.scenes.phenomena.words import Curve, Diagram, PhenomenonWords, Reading
from app.scenes.shapes import Coloured, box_corners, box_faces, flat, ground_grid, joined

WORDS = PhenomenonWords("vertex-depth")

MOST_PIECES = int(WORDS.settings["pieces"].high)
_STRIDE = 16  # of the floor's rows, for a strip of the trough: thin strips are slow to draw
_WIDTH = 12.0
_WALL = (-2.5, 0.0, -0.4), (2.5, 3.0, 0.0)
_FOUNDATION = (-2.5, -3.0, -0.4), (2.5, 0.0, 0.0)
_FLOOR_RGB, _WALL_RGB, _FOUNDATION_RGB = (150, 205, 185), (86, 180, 233), (213, 94, 0)
_BEYOND = 1e-3  # of the nearness at far: no depth lies much farther, and the far plane cuts it
_LEVEL = 1e-3  # of the view direction: one that is nearer to the vertical has no floor ahead


def largest_factor(ratio: float) -> tuple[float, float]:
    """Return the largest factor of the module's text, and q, for a ratio of at least 1."""
    span = math.log(ratio)
    q = -math.expm1(-span) / span if span else 1.0
    return q * math.exp(1.0 / q - 1.0), q


def borders(near: float, far: float, pieces: int) -> Array:
    """Return the distances where pieces of equal length begin and end."""
    return near + (far - near) * np.arange(pieces + 1) / pieces


def along(ends: Array, count: int) -> tuple[Array, Array]:
    """Return true and drawn distances at `count` places, evenly over the pieces on the screen."""
    place = np.linspace(0.0, len(ends) - 1.0, count)
    piece = np.minimum(place.astype(np.intp), len(ends) - 2)
    s, m, r = place - piece, ends[piece], ends[piece + 1] / ends[piece]
    return m / (1.0 - s + s / r), m * r**s


@cache
def _own() -> Array:
    """The vertices: of the floor's borders left and right, then of wall and foundation."""
    start = PHENOMENON.start
    floor = _floor(start, borders(start.lens.near, start.lens.far, MOST_PIECES))
    wall = box_corners(*_WALL)
    return np.concatenate([floor.reshape(-1, 3), box_corners(*_FOUNDATION), wall[wall[:, 1] > 0.0]])


def _geometry() -> tuple[Coloured, Coloured]:
    floor = _own()[: 2 * MOST_PIECES + 2].reshape(-1, 2, 3)
    quads = np.stack([floor[:-1, 0], floor[:-1, 1], floor[1:, 1], floor[1:, 0]], axis=1)
    faces = joined(
        (quads, flat(_FLOOR_RGB, len(quads))),
        (box_faces(*_WALL), flat(_WALL_RGB, 6)),
        (box_faces(*_FOUNDATION), flat(_FOUNDATION_RGB, 6)),
    )
    return faces, ground_grid((-4.0, -2.0), (4.0, 2.0), (1.0, 1.0), _FOUNDATION[0][1])


def _floor(projection: Projection, w: Array) -> Array:
    """Return the floor's left and right points at distances from the eye plane, (k, 2, 3)."""
    (x, height, z), n = projection.camera.eye, projection.camera.frame[2]
    level = math.hypot(n[0], n[2])
    ahead = np.array([-n[0], 0.0, -n[2]]) / level
    middle = np.array([x, 0.0, z]) + ((w - height * n[1]) / level)[:, None] * ahead
    side = _WIDTH / 2.0 * np.array([-ahead[2], 0.0, ahead[0]])
    return np.stack([middle - side, middle + side], axis=1)


def _standard(projection: Projection, w: Array) -> Array:
    """Return the distances whose standard depth is the logarithmic depth of distances w > 0."""
    near, far = projection.lens.near, projection.lens.far
    span = math.log(far / near)
    below = (math.log(far) - np.log(w)) / near + (np.log(w) - math.log(near)) / far
    return np.asarray(span / np.maximum(below, _BEYOND * span / far))


def _show(projection: Projection, settings: Settings, _subject: Subject) -> Illustration:
    lens, eye, n = projection.lens, np.array(projection.camera.eye), projection.camera.frame[2]
    why = WORDS.of_parallel(projection)
    if lens.far == math.inf or math.hypot(n[0], n[2]) < _LEVEL:
        why = why or WORDS.phrase("no-far" if lens.far == math.inf else "steep")
    if why is not None:
        return Illustration((), warning=why)
    pieces, is_right = int(number(settings, "pieces")), settings["depth"] == "pixel"
    ends, wall = borders(lens.near, lens.far, pieces), _own()[2 * MOST_PIECES + 2 :]
    rows = np.minimum(np.arange(MOST_PIECES + 1), pieces)  # the further strips have no length
    w_wall = -projection.trace(wall).view[:, 2]
    true, drawn = along(ends, MOST_PIECES + 1)
    drawn = true if is_right else drawn
    trough = eye + (_floor(projection, true) - eye) * (drawn / true)[:, None, None]
    places = np.concatenate([_floor(projection, ends)[rows].reshape(-1, 3), wall])
    if not is_right:
        w = np.concatenate([np.repeat(ends[rows], 2), w_wall])
        ahead = np.where(w > 0.0, w, 1.0)
        scale = np.where(w > 0.0, _standard(projection, ahead) / ahead, 1.0)
        places = eye + (places - eye) * scale[:, None]
    near, far = _floor(projection, ends[[0, -1]])
    sides = trough[::_STRIDE].swapaxes(0, 1)
    trough = trough[np.arange(len(trough)) // _STRIDE * _STRIDE]
    lowest = sides[:, np.argmin(sides[0, :, 1])]
    most, q = largest_factor(float(ends[1] / ends[0]))
    most, m = 1.0 if is_right else most, lens.near
    curves = (
        Curve(np.column_stack([true, true]), "muted", WORDS["per-pixel"]),
        Curve(np.column_stack([true, drawn]), "accent", WORDS["per-vertex"], 2.0),
    )
    return Illustration(
        (
            Reading(WORDS["most"], most, "×"),
            Reading(WORDS["true"], m / q),
            Reading(WORDS["drawn"], most * m / q),
        ),
        world=Marks.of(
            Polyline(outline(np.array([*near, *far[::-1]])), "muted", 1.0),
            *(Polyline(side, "accent", 1.5, name="drawn") for side in sides),
            Text("floor", far[1], text=WORDS["floor"]),
            Text("drawn", lowest[0], "accent", (), lowest[1], WORDS["buffer"]),
            Text("foundation", np.array(_FOUNDATION[0]), "u", text=WORDS["foundation"]),
        ),
        diagrams=(
            Diagram(
                WORDS["diagram"], curves, *(m, lens.far, m, lens.far),
                x_label=WORDS["true-w"], y_label=WORDS["drawn-w"], x_log=True, y_log=True,
            ),
        ),
        vertices=Vertices(_own(), np.concatenate([trough.reshape(-1, 3), wall]), places),
        warning=None if min(w_wall) > 0.0 else WORDS.phrase("behind"),
    )  # fmt: skip


PHENOMENON = Phenomenon.of(WORDS, geometry=_geometry, show=_show)
