"""Oblique drawing: cavalier, cabinet and any other slant of the projectors.

Faces parallel to the image keep their shape, and edges along n are drawn at one angle and one
scale: ``-cot(alpha), -cot(beta)`` for a unit of depth (lecture 002, matrix H). At scale 0 the
drawing is the orthographic one, at 1 a cavalier, at 1/2 a cabinet drawing.
"""

import math
from dataclasses import replace
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from app.model.lenses.oblique import oblique_angles, receding_of
from app.model.parameter import CLOSE, ImpliedSettings, Settings, number
from app.model.parameters import ALPHA, BETA
from app.model.projection import Array, Camera, Oblique, Orthographic, Projection
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Dot, Mark, Marks, Polyline, Text, segment
from app.scenes.phenomena.picture import seen_lines, seen_texts, world_from_view
from app.scenes.phenomena.words import PhenomenonWords, Phrase, Reading, figure
from app.scenes.shapes import Coloured, box_corners, cubes, edges_of, ground_grid, joined

WORDS = PhenomenonWords("oblique-drawing")

_SQUARE = 1e-6  # by how much v may be drawn longer than u, relative to 1
_LEAST = 1e-9  # of the largest pixel, and of the edge along u: a shorter edge is one of rounding
_SCALES = {"cavalier": 1.0, "cabinet": 0.5}
_COLOURS = ("u", "v", "n")
_ARC = 0.1  # of the near distance: radius of the angles' arcs
_SCALE_NAMES = ("scale_u", "scale_v", "scale_n")  # the names of their texts

# Cells of a cube of two by two by two; the upper left one in front is missing.
_CELLS = [*product((-1.0, 0.0), (0.0, 1.0), (-1.0, 0.0))]
_CELLS.remove((-1.0, 1.0, 0.0))


def _geometry() -> tuple[Coloured, Coloured]:
    cube = cubes(_CELLS)
    grid = ground_grid((-4.0, -4.0), (4.0, 4.0), (1.0, 1.0), 0.0)
    return cube, joined(grid, edges_of(cube[0]))


class DrawnEdge(NamedTuple):
    """An edge along n as drawn, measured on the image beside equal edges along u and v.

    - `angle_deg`: its direction away from the viewer, from the right, anticlockwise; meaningless at
      scale 0.
    """

    scale: float  # its length in units of the edge along u
    up: float  # likewise for the edge along v: 1 unless the picture is stretched
    angle_deg: float


def measured(ends_px: Array) -> DrawnEdge | None:
    """Measure drawn edges: pixels (4, 2) of a corner and of their ends along -u, v and -n.

    None if a pixel is missing, or an edge along u or v is too short.
    """
    corner, left, top, back = ends_px.tolist()
    across, up = corner[0] - left[0], corner[1] - top[1]
    if not min(across, up) > _LEAST * float(np.abs(ends_px).max()):  # NaN, too
        return None
    x, y = (back[0] - corner[0]) / across, (corner[1] - back[1]) / across
    if not math.isfinite(math.hypot(x, y) + up / across):
        return None
    scale = math.hypot(x, y)
    turn_deg = math.degrees(math.atan2(y, x))
    return DrawnEdge(scale if scale > _LEAST else 0.0, up / across, turn_deg)


def oblique(projection: Projection, scale: float, angle_deg: float) -> Projection:
    """The same camera with an oblique lens; the picture of the plane through the target stays.

    `scale` and `angle_deg` as in `app.model.lenses.oblique.oblique_angles`.
    """
    straight = projection.with_lens("orthographic")
    lens: Any = straight.lens
    alpha_deg, beta_deg = oblique_angles(scale, angle_deg)
    left, right, bottom, top = straight.window
    box = (lens.near, lens.far, lens.keep)
    slanted = Oblique(left, right, bottom, top, *box, alpha_deg, beta_deg)
    # The near plane would stay where it is, but the plane through the target should.
    x, y = (cot * (projection.camera.distance - lens.near) for cot in slanted.shear)
    slanted = replace(slanted, left=left - x, right=right - x, bottom=bottom - y, top=top - y)
    return replace(projection, lens=slanted)


def _follow(projection: Projection, before: ImpliedSettings, after: Settings) -> Projection:
    wanted = _wanted(after)
    if None not in before.values() and wanted == _wanted(before):
        return projection
    return oblique(projection, *wanted)


def _implied(projection: Projection, settings: Settings) -> ImpliedSettings:
    lens = projection.lens
    if ALPHA not in lens.parameters:
        return dict.fromkeys(settings)
    wanted, direction = _wanted(settings)
    turned = math.radians(direction)
    slant = (-wanted * math.cos(turned), -wanted * math.sin(turned))
    if math.dist(lens.shear, slant) <= CLOSE * max(1.0, wanted):
        return settings
    # The lens was set directly, so the morph is complete.
    scale, angle_deg = receding_of(lens)
    near = (name for name, known in _SCALES.items() if math.isclose(scale, known, rel_tol=CLOSE))
    return {
        "drawing": next(near, "free"),
        "receding": scale,
        "angle_deg": angle_deg if scale > 0.0 else settings["angle_deg"],
        "morph": 1.0,
    }


def _wanted(settings: ImpliedSettings) -> tuple[float, float]:
    """The receding scale and angle of the settings."""
    scale = _SCALES.get(str(settings["drawing"]), number(settings, "receding"))
    return scale * number(settings, "morph"), number(settings, "angle_deg")


def _show(projection: Projection, _settings: Settings, subject: Subject) -> Illustration:
    lens, camera = projection.lens, projection.camera
    u, v, n = camera.frame
    # From the lower right corner in front an edge that recedes to the upper right is seen.
    corner = np.array([subject.upper[0], subject.lower[1], subject.upper[2]])
    length = max(high - low for low, high in zip(subject.lower, subject.upper, strict=True))
    ends = corner + length * np.array([np.zeros(3), -u, v, -n])
    segments = np.array([ends[[0, i]] for i in (1, 2, 3)])
    by_formula = receding_of(lens)
    if by_formula[0] > 0.0 and lens.shear[0] < 0.0:
        segments[1] += ends[3] - corner  # the outer one of these edges has room beside it
    edges = [Polyline(ends, colour, 2.0) for ends, colour in zip(segments, _COLOURS, strict=True)]
    corners = box_corners(subject.lower, subject.upper)
    named = np.array([segments[0, 1], *segments[1:].mean(axis=1)])  # there is room beside them
    trace = projection.trace(np.concatenate([ends, corners, named]))
    warning = WORDS.phrase("not-parallel") if lens.central else None
    drawn = measured(trace.image[:4]) if warning is None else None
    note = None
    if drawn is None:
        note = warning or WORDS.phrase("unmeasured")
    elif abs(drawn.up - 1.0) > _SQUARE:
        note = WORDS.phrase("stretched", drawn.up)

    labels: tuple[str, ...] = "{axis_u}", "{axis_v}", "{axis_n}"
    if drawn is not None:
        angle = f", {figure(drawn.angle_deg, 3)}°" if by_formula[0] != 0.0 else ""
        up = 1.0 if note is None else drawn.up
        scales = "1 ×", f"{up:.3g} ×", f"{drawn.scale:.3g} ×{angle}"
        labels = tuple(map("{}: {}".format, labels, scales))

    def texts(places: Array) -> list[Text]:
        each = zip(_SCALE_NAMES, places, _COLOURS, labels, strict=True)
        return [Text(name, at, colour, text=text) for name, at, colour, text in each]

    # Where u and v keep their lengths, a small world has room for the receding scale alone.
    world: list[Mark] = [*edges, *texts(segments.mean(axis=1))[2 if note is None else 0 :]]
    if warning is None:
        world = [_projectors(projection, corners, trace.view[4:12]), *world]
    lines = seen_lines(projection, projection.trace(segments).clip, _COLOURS, 2.0)
    return Illustration(
        _readings(projection, drawn, by_formula, note),
        world=Marks.of(*world),
        image=Marks.of(*lines, *seen_texts(trace, texts(named))),
        warning=warning,
    )


def _readings(
    projection: Projection,
    drawn: DrawnEdge | None,
    by_formula: tuple[float, float],
    note: Phrase | None,
) -> tuple[Reading, ...]:
    """Scale and angle as drawn, `note` about them, and those of the formula with its angles."""
    lens = projection.lens
    scale, angle_deg = by_formula
    end_on = WORDS.phrase("end-on") if scale == 0.0 else None
    drawn_deg = drawn.angle_deg if drawn is not None and end_on is None else None
    readings = [
        Reading(WORDS["scale"], drawn and drawn.scale, "×", note),
        Reading(WORDS["angle"], drawn_deg, "°", note if drawn is None else end_on or note),
    ]
    if ALPHA in lens.parameters:
        before = WORDS.phrase("before") if drawn is not None and note is not None else None
        readings += [
            Reading("√(cot²α + cot²β)", scale, "×", before),  # noqa: RUF001
            Reading("atan2(−cot β, −cot α)", None if end_on else angle_deg, "°", end_on),  # noqa: RUF001
            Reading("α, β", (ALPHA.value(projection), BETA.value(projection)), "°"),  # noqa: RUF001
        ]
    return tuple(readings)


def _projectors(projection: Projection, corners: Array, view: Array) -> Marks:
    """From the subject's corners (8, 3), in the world and in view space, to the near plane."""
    cot_alpha, cot_beta = projection.lens.shear
    near = projection.lens.near
    depth = view[:, 2] + near  # 0 on the near plane
    x, y = view[:, 0] + cot_alpha * depth, view[:, 1] + cot_beta * depth
    feet = world_from_view(projection, np.column_stack([x, y, np.full(len(view), -near)]))
    rays = (segment(*pair, "accent", 0.5) for pair in zip(corners, feet, strict=True))
    deep = int(np.argmax(view[:, 0] - view[:, 2]))  # at the right, and far behind the near plane
    letters: list[Mark] = [Text("x", corners[deep], "accent"), Text("x'", feet[deep], "accent")]
    u, v, n = projection.camera.frame
    for name, along, cot in (("alpha", u, cot_alpha), ("beta", v, cot_beta)):
        turns = np.linspace(0.0, math.atan2(1.0, cot), 17)[:, None]  # from the near plane
        arc = feet[deep] + _ARC * near * (np.cos(turns) * along - np.sin(turns) * n)
        text = Text(name, arc[8], "accent", (), feet[deep], f"{{{name}}}")
        letters += [Polyline(arc, "accent", 1.0, (), name), text]
    return Marks.of(*rays, *(Dot(foot, "accent", 0.7) for foot in feet), *letters)


PHENOMENON = Phenomenon.of(
    WORDS,
    start=oblique(
        Projection(
            Camera((0.0, 1.0, 8.0), (0.0, 1.0, 0.0)),
            Orthographic(-2.1 * 16 / 9, 2.1 * 16 / 9, -2.1, 2.1, 5.0, 9.5, "y"),
        ),
        1.0,
        45.0,
    ),
    geometry=_geometry,
    show=_show,
    follow=_follow,
    implied=_implied,
)
