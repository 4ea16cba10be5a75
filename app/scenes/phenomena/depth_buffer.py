"""The depth buffer: two surfaces close together, and the pixels that show the wrong one.

A depth buffer keeps one code for each pixel, so that two surfaces nearer to each other than a step
of the codes are stored as one. The one that is drawn last then wins, and stripes of the hidden
surface appear (z-fighting). A perspective lens with the standard range spends most codes just
behind the near plane: at w >> n the step is ``w^2/(n 2^bits)`` (lectures 000 and 001;
`app.model.depth`).

The hidden surface is the visible one moved away along n by the gap. The ramp is also moved to the
side, along itself and at a right angle to n, so that two surfaces are seen. On a plane with normal
m, in view space, that is a gap of ``gap / (1 - (m_x X + m_y Y)/m_z)`` along the projector ``(X, Y,
-1)``.
"""

import math

import numpy as np
from numpy.typing import NDArray

from app.model.clipping import clip_polygon
from app.model.depth import FORMATS, DepthBuffer
from app.model.parameter import Settings, number
from app.model.projection import Array, Projection
from app.model.refusal import Refusal
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Copy, Face, Marks, Rendering, Text
from app.scenes.phenomena.picture import SIDES, seen_texts
from app.scenes.phenomena.sampling import seen_distances
from app.scenes.phenomena.words import Curve, Diagram, PhenomenonWords, Phrase, Reading
from app.scenes.shapes import Coloured, flat, ground_grid

WORDS = PhenomenonWords("depth-buffer")

FINEST = 2.0**-17  # relative to the distance: anything finer drowns in the GPU's float32
_FINEST_PARALLEL = 2.0**-21  # the same for a parallel lens, whose depth is linear, of far - near

_FRONT_RGB, _BEHIND = (230, 159, 0), "#0072b2"
# A ramp that leads away, so that one picture has many distances.
_CORNERS = np.array([(-5.0, 0, 4), (5, 0, 4), (5, 6, -44), (-5, 6, -44)])
_ASIDE = 3.0  # how far the hidden ramp reaches out at the side, so that two surfaces are seen
# A Fibonacci lattice has as many rows and columns as places: stripes are rows or columns.
_SAMPLES, _STRIDE = 10946, 6765  # a share of them is right to about a per cent
_LATTICE = (np.arange(_SAMPLES)[:, None] * (1, _STRIDE) % _SAMPLES + 0.5) / _SAMPLES
_TICKS = 32  # of all codes, evenly spread
_MAPPINGS = {"standard": "opengl", "infinite": "opengl"}


def _geometry() -> tuple[Coloured, Coloured]:
    grid = ground_grid((-8.0, -48.0), (8.0, 8.0), (4.0, 4.0), -1.0)
    return (_CORNERS[None], flat(_FRONT_RGB, 1)), grid


def buffer_of(projection: Projection, settings: Settings) -> DepthBuffer | Phrase:
    """The depth buffer of the settings, or why there is none."""
    lens, chosen = projection.lens, str(settings["range"])
    try:
        if chosen == "infinite":
            lens = lens.replaced(far=math.inf)
        return DepthBuffer(str(settings["format"]), _MAPPINGS.get(chosen, chosen), lens)
    except Refusal:
        return WORDS.phrase("no-infinite" if chosen == "infinite" else "no-log")


def moved_behind(projection: Projection, gap: float, aside: float = 0.0) -> Array:
    """The 4x4 that moves world points away along n by the gap, and along the ramp to the side."""
    n = projection.camera.frame[2]
    matrix = np.eye(4)
    matrix[:3, 3] = -gap * n
    if aside:  # at a right angle to n, so that no depth of the plane changes
        along = np.cross(np.cross(_CORNERS[1] - _CORNERS[0], _CORNERS[3] - _CORNERS[0]), n)
        matrix[:3, 3] += aside * along / max(float(np.linalg.norm(along)), 1e-12)
    return matrix


def distances(projection: Projection, gap: float, subject: Subject) -> tuple[Array, Array]:
    """Distances of both surfaces from the eye plane, at places spread evenly over the picture.

    Both (k,), between near and far; empty if the picture does not show both. Rays through a lattice
    of places are cut with the plane of the ramp, rays through a grid with the triangles of a user's
    mesh.
    """
    near, far = projection.lens.near, projection.lens.far
    if subject.mesh is not None:
        return seen_distances(projection, subject.mesh.surface, gap)
    corners = projection.trace(_CORNERS)
    rays = _rays(projection, corners.clip)
    if rays is None:
        return np.empty(0), np.empty(0)
    first, inside_first = _cut(corners.view, *rays)
    moved = projection.camera.frame @ moved_behind(projection, gap, _ASIDE)[:3, 3]
    second, inside_second = _cut(corners.view + moved, *rays)
    low, high = np.minimum(first, second), np.maximum(first, second)
    seen = inside_first & inside_second & (low >= near) & (high <= far)
    return first[seen], second[seen]


def wrong_share(buffer: DepthBuffer, first: Array, second: Array) -> float:
    """The share of places where the second surface, drawn last, hides a first one in front of it.

    It wins where the codes are the same, because the depth test lets equal depths pass.
    """
    if not len(first):
        return math.nan
    same = buffer.encode(first) == buffer.encode(second)
    return float(np.mean(same & (second > first)))


def _rays(projection: Projection, corners_clip: Array) -> tuple[Array, Array] | None:
    """View-space rays ``start + w direction`` through a lattice over what the ramp covers."""
    largest = float(np.abs(corners_clip).max())
    if not 0.0 < largest < math.inf:
        return None
    # Near and far are compared later, with all their digits.
    polygon = clip_polygon(corners_clip / largest, projection.depth, SIDES).points_clip
    if not len(polygon) or not (polygon[:, 3] >= 0.0).all():
        return None
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        ndc = polygon[:, :2] / polygon[:, 3:]
    ndc = np.clip(np.where(np.isfinite(ndc), ndc, 0.0), -1.0, 1.0)
    x, y = ((ndc - ndc[0]) * projection.image_size / 2.0).T
    if abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) < 2.0:  # less than a pixel is covered
        return None
    places = _spread(ndc)
    left, right, bottom, top = projection.window
    window = (0.5 * (places + 1.0)) * (right - left, top - bottom) + (left, bottom)
    starts, directions = np.zeros((len(places), 3)), np.full((len(places), 3), -1.0)
    starts[:, :2], directions[:, :2] = projection.lens.rays(window)
    return starts, directions


def _spread(polygon: Array) -> Array:
    """Places spread evenly over a convex polygon, (`_SAMPLES`, 2)."""
    first, one, other = polygon[0], polygon[1:-1] - polygon[0], polygon[2:] - polygon[0]
    areas = np.abs(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])
    ends = np.cumsum(areas)
    u, v = ends[-1] * _LATTICE[:, 0], _LATTICE[:, 1:]
    which = np.minimum(np.searchsorted(ends, u, side="right"), len(areas) - 1)
    with np.errstate(divide="ignore", invalid="ignore"):
        part = np.sqrt(np.clip((u - ends[which]) / areas[which] + 1.0, 0.0, 1.0))[:, None]
    return np.asarray(first + np.nan_to_num(part) * ((1.0 - v) * one[which] + v * other[which]))


def _cut(corners: Array, starts: Array, directions: Array) -> tuple[Array, NDArray[np.bool_]]:
    """The w at which rays meet a parallelogram's plane, and whether that is inside."""
    origin, across, along = corners[0], corners[1] - corners[0], corners[3] - corners[0]
    normal = np.cross(across, along)
    with np.errstate(all="ignore"):
        w = ((origin - starts) @ normal) / (directions @ normal)
        place = starts + w[:, None] * directions - origin
        inside = np.isfinite(w)
        for side in (across, along):
            part = place @ (side / (side @ side))  # the sides are at right angles
            inside &= (part >= 0.0) & (part <= 1.0)
    return np.where(inside, w, -1.0), inside


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    gap = number(settings, "gap")
    matrix = moved_behind(projection, gap, _ASIDE if subject.mesh is None else 0.0)
    # The world has a depth buffer of its own, so that a face is enough there.
    copies = (Copy(matrix, panes=("image",), colour=_BEHIND),)
    marks = image = Marks()
    if subject.mesh is None:
        moved = _CORNERS + matrix[:3, 3]
        names = (
            Text("surface-1", _CORNERS[3], "near", text=WORDS["first"]),
            Text("surface-2", moved[2], "n", text=WORDS["second"]),
        )
        marks = Marks.of(Face(moved, _BEHIND, 1.0), *names)
        image = Marks.of(*seen_texts(projection.trace([name.point for name in names]), names))
    buffer = buffer_of(projection, settings)
    if isinstance(buffer, Phrase):
        return Illustration((), world=marks, image=image, copies=copies, warning=buffer)
    share, note = _share(buffer, gap, distances(projection, gap, subject), subject)
    w = projection.camera.distance
    known = buffer.near <= w <= buffer.far
    smallest = float(buffer.gap(w)) if known else math.nan
    why = WORDS.phrase("none-is-sure" if smallest == math.inf else "target-outside")
    too_few = WORDS.phrase("too-few") if note is None or share is not None else note
    return Illustration(
        (
            Reading(WORDS["wrong"], share, "%", note),
            Reading(WORDS["counted"], None, "%", too_few, counted=True),
            Reading.or_why(WORDS["smallest"], smallest, why=why),
            Reading(WORDS["distance"], w),
            Reading(WORDS["codes"], float(FORMATS[buffer.format].largest) + 1.0),
        ),
        world=marks,
        image=image,
        copies=copies,
        diagrams=(_diagram(buffer, w if known else None),),
        rendering=Rendering(buffer=buffer),
    )


def _share(
    buffer: DepthBuffer, gap: float, surfaces: tuple[Array, Array], subject: Subject
) -> tuple[float | None, Phrase | None]:
    """The percentage of wrong pixels, and why there is none or why the picture differs."""
    first, second = surfaces
    if not len(first):
        return None, WORDS.phrase("not-in-picture")
    w = min(max(float(first.mean()), buffer.near), buffer.far)  # a mean is rounded
    finest = FINEST * (w + math.dist(subject.lower, subject.upper))
    finest = max(finest, _FINEST_PARALLEL * buffer.lens.even_extent)
    is_finer = max(gap, float(buffer.gap(w))) < finest
    share = 100.0 * wrong_share(buffer, first, second)
    if 0.0 < share < 100.0:
        share = float(min(max(round(share), 1), 99))
    return share, WORDS.phrase("too-fine") if is_finer else None


def _diagram(buffer: DepthBuffer, target: float | None) -> Diagram:
    """Depth over distance, with a few of the codes as ticks on both axes."""
    near, far = buffer.near, buffer.far
    right = far if far != math.inf else max(1e3 * near, 2.0 * (target or near))
    in_ratios = buffer.lens.even_extent == 0.0
    w = np.clip((np.geomspace if in_ratios else np.linspace)(near, right, 160), near, right)
    curves = [Curve(np.stack([w, buffer.depth(w)], axis=1), "accent", width=2.0)]
    if target is not None and target <= right:
        curves.append(Curve(np.array([(target, float(buffer.depth(target)))]), "target", dots=True))
    last = FORMATS[buffer.format].largest
    codes = np.append(np.arange(_TICKS) * ((last + 1) // _TICKS), last)
    x_ticks = np.sort(buffer.decode(codes))
    x_ticks = x_ticks[x_ticks <= right]
    return Diagram(
        WORDS["diagram"],
        tuple(curves),
        *(near, right, 0.0, 1.0),
        x_label="w",
        y_label="d",
        x_log=in_ratios,
        x_ticks=x_ticks,
        y_ticks=buffer.depth(x_ticks),
    )


PHENOMENON = Phenomenon.of(WORDS, geometry=_geometry, show=_show)
