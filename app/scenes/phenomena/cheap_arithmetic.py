"""Cheap arithmetic: the drawing errors of vertices that have few bits.

`app.precision.cheap` projects every vertex as such hardware does, and states a bound of its error.
What the panes draw is that result: the world has the vertices as they are stored, NDC and the image
have the pixels that came out. A pixel's error moves a vertex within the plane of its depth, where
the window at that depth is as wide as the picture,

    dX = dx (r_w - l_w)/width,    dY = -dy (t_w - b_w)/height.

The depth stays exact: what a coarse one does to a picture is the scene of the depth buffer.
"""

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cache, lru_cache
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.model.parameter import Settings, number
from app.model.projection import Array, Projection, Trace, Vector
from app.precision.cheap import Hardware, cheap_formats, stored
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Marks, Polyline, Rendering, Text, Texture, Vertices
from app.scenes.phenomena.picture import seen
from app.scenes.phenomena.words import Curve, Diagram, PhenomenonWords, Reading, Spot
from app.scenes.shapes import Coloured, distinct_rows, flat, ground_grid, joined, letter_f

WORDS = PhenomenonWords("cheap-arithmetic")

PRESETS = {  # the hardware of each choice but ``"own"``
    "console": Hardware("16 bits", "fixed 16.16", "whole px", "table, 1 Newton step"),
    "bits8": Hardware("8 bits"),
    "bits12": Hardware("12 bits"),
    "bits16": Hardware("16 bits"),
    "half": Hardware("float16", "float16"),
    "far": Hardware(),
    "exact": Hardware("float64", "float64"),
}
_FORMATS = {
    "float64": "float64", "float32": "float32", "float16": "float16", "bfloat16": "bfloat16",
    "fixed": "fixed 16.16", "bits16": "16 bits", "bits12": "12 bits", "bits8": "8 bits",
}  # fmt: skip
_SNAPS = {"none": "none", "whole": "whole px", "quarter": "1/4 px", "sixteenth": "1/16 px"}
_RECIPROCALS = {
    "exact": "exact", "table": "table", "newton1": "table, 1 Newton step",
    "newton2": "table, 2 Newton steps",
}  # fmt: skip
_TABLES = {
    "vertices": _FORMATS, "numbers": _FORMATS, "snap": _SNAPS, "reciprocal": _RECIPROCALS,
}  # fmt: skip
_COMPARED = ("8 bits", "12 bits", "16 bits", "float16", "float32")  # in the diagram
_SHOWN_PX = 1e-5, 1e3  # there

# A letter along the axes, or 5 high, would have coordinates that any format has, or just misses.
_TURN, _SCALE = math.radians(27.0), 0.97
_FLOOR, _SQUARES = 4.0, 3
_CHECKS = 8
_FLOOR_RGB = (245, 242, 230)
_SHEAR = math.radians(45.0) - _TURN  # checks as large on the letter's front as on its side

_LONGEST = 0.12  # of the picture's height, and of the scene's size: what arrows are enlarged to
_HEAD = 0.3  # of an arrow
_LEAST_ARROW = 0.03  # of the longest: a shorter one would be a speck
_LEAST_SHOWN = 1e-9  # of the same: nothing shorter is enlarged


def _geometry() -> tuple[Coloured, Coloured]:
    letter, rgb = letter_f()
    cos, sin = math.cos(_TURN), math.sin(_TURN)
    turned = _SCALE * letter @ np.array([(cos, 0.0, -sin), (0.0, 1.0, 0.0), (sin, 0.0, cos)])
    ends = np.linspace(-_FLOOR, _FLOOR, _SQUARES + 1)
    floor = np.array(
        [
            [(x0, 0.0, z1), (x1, 0.0, z1), (x1, 0.0, z0), (x0, 0.0, z0)]
            for x0, x1 in pairwise(ends.tolist())
            for z0, z1 in pairwise(ends.tolist())
        ]
    )
    reach = _FLOOR + 1.0
    grid = ground_grid((-reach, -reach), (reach, reach), (2.0, 2.0), -0.5)
    return joined((turned, rgb), (floor, flat(_FLOOR_RGB, len(floor)))), grid


@cache
def _own() -> tuple[Array, NDArray[np.intp], Array]:
    """The vertices (n, 3), each face's four (m, 4), and the box (2, 3) that holds them."""
    (faces, _), _ = _geometry()
    points, corners = distinct_rows(faces.reshape(-1, 3))
    return points, corners.reshape(-1, 4), np.array([points.min(axis=0), points.max(axis=0)])


_TEXTURE = np.array(
    [
        (1.0, math.cos(_SHEAR), 0.0, _FLOOR), (0.0, math.sin(_SHEAR), 1.0, _FLOOR),
    ]
) / (2.0 * _FLOOR)  # fmt: skip


def hardware_of(settings: Settings) -> Hardware:
    """The formats, the snapping and the reciprocal of the settings."""
    preset = str(settings["preset"])
    if preset in PRESETS:
        return PRESETS[preset]
    return Hardware(*(table[str(settings[name])] for name, table in _TABLES.items()))


class VertexErrors(NamedTuple):
    """The errors of vertices as a kind of hardware draws them; NaN where it finds no number.

    `px` (n, 2) are across and down, `bound_px` (n, 2) is never below them.
    """

    px: Array
    bound_px: Array


def drawn(
    projection: Projection,
    trace: Trace,
    hardware: Hardware,
    formats: Sequence[str],
    origin: Vector = (0.0, 0.0, 0.0),
) -> list[VertexErrors]:
    """The errors of the scene's vertices, traced exactly, with each of these formats for them."""
    points, _, box = _own()
    pictures = cheap_formats(projection, points, hardware, formats, origin, box)
    return [VertexErrors(each.image - trace.image, each.bounds[:, :2]) for each in pictures]


def moved(projection: Projection, trace: Trace, px: Array) -> Array:
    """The scene's vertices, moved in the world by errors (n, 2) in pixels, at the same depth."""
    u, v, _ = projection.camera.frame
    width, height = projection.image_size
    lens = projection.clip_from_view
    per_px = 2.0 / (width * lens[0, 0]), -2.0 / (height * lens[1, 1])
    with np.errstate(all="ignore"):
        across, down = (px * per_px * trace.clip[:, 3:]).T
        places = _own()[0] + across[:, None] * u + down[:, None] * v
    drawable = trace.in_front & np.isfinite(places).all(axis=1)
    return np.where(drawable[:, None], places, _own()[0])


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    points = _own()[0]
    hardware, is_far = hardware_of(settings), settings["preset"] == "far"
    origin = (-number(settings, "origin") if is_far else 0.0, 0.0, 0.0)
    trace = projection.trace(points)
    formats = tuple(dict.fromkeys((hardware.vertices, *_COMPARED)))
    results, here = drawn(projection, trace, hardware, formats, origin), seen(trace)
    result = results[0]
    kept, of_stored = _kept(hardware, origin, subject.size)
    image, factor = _errors_in_picture(projection, trace, result.px, here)
    return Illustration(
        _readings(result, here, hardware, factor),
        world=of_stored,
        image=image,
        diagrams=_diagram(results, here, hardware, formats),
        rendering=Rendering(texture=Texture(_TEXTURE, _CHECKS, settings["preset"] == "console")),
        vertices=Vertices(points, kept, moved(projection, trace, result.px)),
        warning=None if here.any() else WORDS.phrase("outside"),
    )


def _largest(vectors: Array) -> float | None:
    """The length of the longest of vectors (n, 2 or 3) without a NaN; None if all have one."""
    lengths = np.linalg.norm(vectors, axis=1)
    lengths = lengths[~np.isnan(lengths)]
    return float(lengths.max()) if len(lengths) else None


def _readings(
    result: VertexErrors, here: NDArray[np.bool_], hardware: Hardware, factor: float | None
) -> tuple[Reading, ...]:
    """The readout, of the vertices that are in the picture."""
    predicted, measured = _largest(result.bound_px[here]), _largest(result.px[here])
    lost = int(np.isnan(result.px[here]).any(axis=1).sum())
    note = WORDS.phrase("lost", str(lost)) if lost else None
    none = note or WORDS.phrase("outside")
    why = WORDS.phrase("no-bound") if predicted == math.inf else none
    return (
        Reading.or_why(WORDS["predicted"], predicted, "px", why),
        Reading(WORDS["measured"], measured, "px", note if measured is not None else none),
        Reading(WORDS["bytes"], hardware.bytes_per_vertex),
        Reading.or_why(WORDS["enlarged"], factor, "×", WORDS.phrase("no-arrows")),
    )


def enlargement(longest: float, room: float) -> float | None:
    """The largest of 1, 2, 5, 10, ... by which a length still fits; None if it is as good as 0."""
    if not _LEAST_SHOWN * room < longest < math.inf:
        return None
    power = 10.0 ** math.floor(math.log10(room / longest))
    return max(step * power for step in (1.0, 2.0, 5.0) if step * power * longest <= room)


def times_text(factor: float) -> str:
    """Write how many times larger something is drawn: ``20 000 ×``."""
    text = f"{factor:,.0f} ×" if factor >= 1.0 else f"{factor:g} ×"
    return text.replace(",", " ")


def _arrows(starts: Array, steps: Array, across: Array) -> Array:
    """Shafts with heads (k, 5, 2 or 3), from points, steps and the directions across them."""
    tips, sides = starts + steps, _HEAD / 2.0 * across
    barbs = tips - _HEAD * steps
    return np.stack([starts, tips, barbs + sides, tips, barbs - sides], axis=1)


def _marked(arrows: Array, factor: float, name: str) -> Marks:
    """Arrows (k, 5, 2 or 3); the highest, in a picture to the right, has their enlargement."""
    if not len(arrows):
        return Marks()
    tips = arrows[:, 1]
    highest = tips[(tips @ ((0.5, -1.0) if arrows.shape[2] == 2 else (0.0, 1.0, 0.0))).argmax()]
    return Marks.of(
        *(Polyline(arrow, "accent", 1.5, (), name) for arrow in arrows),
        Text(name, highest, "accent", (), tips.mean(axis=0), times_text(factor)),
    )


def _errors_in_picture(
    projection: Projection, trace: Trace, px: Array, here: NDArray[np.bool_]
) -> tuple[Marks, float | None]:
    """An arrow for each error at a vertex that can be seen, and how much it is enlarged."""
    longest = _largest(px[here]) or 0.0
    factor = enlargement(longest, _LONGEST * projection.image_size[1])
    if factor is None:
        return Marks(), None
    rows = here & _on_front(trace) & (np.linalg.norm(px, axis=1) > _LEAST_ARROW * longest)
    steps = factor * px[rows]
    arrows = _arrows(trace.image[rows], steps, steps[:, ::-1] * (-1.0, 1.0))
    inside = ((arrows >= 0.0) & (arrows <= projection.image_size)).all(axis=(1, 2))
    return _marked(arrows[inside], factor, "error"), factor


def _on_front(trace: Trace) -> NDArray[np.bool_]:
    """Which vertices are on a face whose outside is seen."""
    faces = _own()[1]
    is_front = np.zeros(len(trace.image), dtype=np.bool_)
    x, y = np.moveaxis(trace.ndc[faces, :2], -1, 0)
    with np.errstate(all="ignore"):
        turn = (x[:, 2] - x[:, 0]) * (y[:, 3] - y[:, 1]) - (x[:, 3] - x[:, 1]) * (y[:, 2] - y[:, 0])
    is_front[faces[turn > 0.0]] = True
    return is_front


@lru_cache(maxsize=8)  # a step of the camera changes nothing of it
def _kept(hardware: Hardware, origin: Vector, size: float) -> tuple[Array, Marks]:
    """The vertices as they are stored, and an arrow for each that is stored at another place."""
    points, _, box = _own()
    kept = stored(points, hardware, origin, box)
    kept = np.where(np.isfinite(kept), kept, points)
    steps = kept - points
    factor = enlargement(_largest(steps) or 0.0, _LONGEST * size)
    if factor is None:
        return kept, Marks()
    rows = steps.any(axis=1)
    steps = factor * steps[rows]
    arrows = _arrows(points[rows], steps, np.cross(steps, (0.0, 1.0, 0.0)))
    return kept, _marked(arrows, factor, "stored")


def _diagram(
    results: Sequence[VertexErrors],
    here: NDArray[np.bool_],
    hardware: Hardware,
    formats: Sequence[str],
) -> tuple[Diagram, ...]:
    """The largest error with each format of the vertices, over its bytes; all else unchanged."""
    spots, bounds = [], []
    for name, result in zip(formats, results, strict=True):
        predicted, measured = _largest(result.bound_px[here]), _largest(result.px[here])
        size = replace(hardware, vertices=name).bytes_per_vertex
        if measured and _SHOWN_PX[0] <= measured <= _SHOWN_PX[1]:
            now = name == hardware.vertices
            spots.append(Spot(size, measured, name, colour="accent" if now else "ink", marked=now))
        if predicted and _SHOWN_PX[0] <= predicted <= _SHOWN_PX[1]:
            bounds.append((size, predicted))
    if not bounds:
        return ()
    return (
        Diagram(
            WORDS["diagram"],
            (Curve(np.array(bounds), "muted", WORDS["bound"], dots=True),),
            *(0.0, 1.15 * max(size for size, _ in bounds), *_SHOWN_PX),
            x_label=WORDS["bytes"],
            y_label=WORDS["y-label"],
            y_log=True,
            spots=tuple(spots),
        ),
    )


PHENOMENON = Phenomenon.of(WORDS, geometry=_geometry, show=_show)
