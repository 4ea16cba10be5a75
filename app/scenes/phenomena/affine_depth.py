"""Bent by an affine z: why z' = A z + B will not do for the depth after the divide.

The divide by ``w = -z`` makes x' and y' linear in 1/w, and a segment stays straight only if z' is
linear in 1/w, too. ``z' = A z + B`` (lecture 000, (9)) also takes near and far to the ends of the
cube, but it is linear in w: a segment becomes a bow. ``A + B/z`` (000, (12); 002) is linear in 1/w.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.model.clipping import NOT_CUT, clip_segments
from app.model.parameter import Settings, point
from app.model.projection import Array, Projection
from app.scenes.phenomena.illustration import Illustration, OwnMesh, Phenomenon, Subject
from app.scenes.phenomena.marks import Dot, Grip, Mark, Marks, Polyline, Text, named, segment
from app.scenes.phenomena.picture import image_from_ndc
from app.scenes.phenomena.words import PhenomenonWords, Phrase, Reading, figure
from app.scenes.shapes import letter_f_edges

WORDS = PhenomenonWords("affine-depth")

_STEPS = np.linspace(0.0, 1.0, 65)
_EDGE_STEPS = np.linspace(0.0, 1.0, 9)
_MOST_EDGES = 200  # of a user's mesh


class Inside(NamedTuple):
    """The parts of segments inside the view volume, k of them.

    `rows` (k,) tells which segments they are of, `cut` (k,) whether they are not whole. Their ends
    lie in the cube at `ndc` (k, 2, 3), under A + B/z, and at distances `w` (k, 2) from the eye
    plane.
    """

    rows: NDArray[np.intp]
    ndc: Array
    w: Array
    cut: NDArray[np.bool_]

    def of(self, chosen: NDArray[np.bool_]) -> "Inside":
        return Inside(self.rows[chosen], self.ndc[chosen], self.w[chosen], self.cut[chosen])


def inside(projection: Projection, segments_world: Array) -> Inside:
    """Cut segments (m, 2, 3) to the view volume."""
    lens = projection.lens
    clip = projection.trace(segments_world).clip
    rows = np.arange(len(clip))
    # The near plane first: what is left before it has w > 0, of any size.
    least, most = lens.w(lens.near), lens.w(lens.far)
    rows = rows[(clip[..., 3] >= least).any(axis=1)]
    clip = clip[rows]
    beyond = least - clip[..., 3]
    row, end = np.nonzero(beyond > 0.0)
    cut: NDArray[np.bool_] = np.asarray((beyond > 0.0).any(axis=1))
    here, there = beyond[row, end], beyond[row, 1 - end]
    share = (here / (here - there))[:, None]
    clip[row, end] = (1.0 - share) * clip[row, end] + share * clip[row, 1 - end]
    clip[row, end, 2:] = projection.depth_range[0] * least, least
    clipped = clip_segments(clip[:, 0], clip[:, 1], projection.depth)
    seen = clipped.visible & (clipped.points_clip[..., 3] > 0.0).all(axis=1)
    w = np.clip(clipped.points_clip[seen, :, 3], least, most)  # a cut end's may have lost digits
    ndc = np.clip(clipped.points_clip[seen, :, :3] / w[..., None], -1.0, 1.0)
    cut |= (clipped.planes != NOT_CUT).any(axis=1)
    return Inside(rows[seen], ndc, w, cut[seen])


def slope(projection: Projection) -> float:
    """How much z' grows with w under ``z' = A z + B``: -A of lecture 000, (9).

    Both planes' conditions give ``(z_far - z_near)/(f - n)``, 2/(f - n) in OpenGL's cube.
    """
    z_near, z_far = projection.depth_range
    return (z_far - z_near) / (projection.lens.far - projection.lens.near)


def affine_z(projection: Projection, w: Array) -> Array:
    """z' of points at these distances under ``z' = A z + B``."""
    return np.asarray(projection.depth_range[0] + slope(projection) * (w - projection.lens.near))


def bow(projection: Projection, part: Inside, steps: Array) -> Array:
    """The segments' images under the affine z, from end to end, (k, s, 3).

    The steps (s,) run along the straight image, 0 to 1. The far plane must be finite.
    """
    start, end = part.w[:, :1], part.w[:, 1:]
    points = part.ndc[:, :1] + steps[:, None] * (part.ndc[:, 1:] - part.ndc[:, :1])
    w = 1.0 / ((1.0 - steps) / start + steps / end)  # 1/w is linear along the image
    points[..., 2] = affine_z(projection, w)
    return points


class Deviation(NamedTuple):
    """The largest distance of each bow from its chord, (k,) each.

    `percent` of the chord's length, NaN for a chord without length; where it is, from 0 to 1 along
    the image; and how far that place is from the eye plane.
    """

    percent: Array
    step: Array
    w: Array


def deviation(projection: Projection, part: Inside) -> Deviation:
    """The largest deviation of each bow from its chord, in closed form.

    Between ends at w0 and w1 the bow differs from its chord in z' alone, by
    ``a (w - w0 - s (w1 - w0))`` with ``1/w = (1 - s)/w0 + s/w1`` and the slope a. Its derivative is
    0 where ``w^2 = w0 w1``: at the geometric mean, at ``s = sqrt(w1)/(sqrt(w0) + sqrt(w1))``, where
    the difference is ``-a (sqrt(w1) - sqrt(w0))^2``. Across the chord (x, y, z) that is a distance
    of ``|a| (sqrt(w1) - sqrt(w0))^2 hypot(x, y)/hypot(x, y, z)``.
    """
    root_start, root_end = np.sqrt(part.w).T
    chord = part.ndc[:, 1] - part.ndc[:, 0]
    across = np.hypot(chord[:, 0], chord[:, 1])
    a = abs(slope(projection))
    gap = part.w[:, 1] - part.w[:, 0]
    length = np.hypot(across, a * gap)
    # The difference of the roots is computed from that of the distances, which keeps its digits.
    sag = a * (gap / (root_start + root_end)) ** 2
    with np.errstate(invalid="ignore", divide="ignore"):
        distance = np.where(length > 0.0, sag * (across / length), 0.0)
        percent = 100.0 * distance / length
    return Deviation(percent, root_end / (root_start + root_end), root_start * root_end)


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    ends = np.array([point(settings, "start"), point(settings, "end")])
    letters = (named(*each, size=1.0) for each in zip("PQ", ends, strict=True))
    world = Marks.of(Polyline(ends, "accent", 2.0), *letters)
    grips = Grip("start", ends[0], name="P"), Grip("end", ends[1], name="Q")
    mesh = subject.mesh
    if projection.lens.far == math.inf:
        why = WORDS.phrase("infinite")
        return Illustration(_readings(None, None, why, mesh, why), world, warning=why, grips=grips)
    others = letter_f_edges()[0] if mesh is None else mesh.edges[:_MOST_EDGES]
    part = inside(projection, np.concatenate([ends[None], others]))
    own = part.rows == 0
    # Over the picture, where x' and y' are straight either way.
    pixels = image_from_ndc(projection, part.ndc[own])
    image = Marks(tuple(Polyline(pair, "accent", 2.0) for pair in pixels))
    note = WORDS.of_parallel(projection)
    if note is not None:
        lines = [Polyline(pair, "muted") for pair in part.ndc[~own]]
        lines += [Polyline(pair, "accent", 2.0) for pair in part.ndc[own]]
        readings, ndc = _readings((0.0, 0.0), 0.0, note, mesh), Marks.of(*lines)
        return Illustration(readings, world, ndc, image, warning=note, grips=grips)
    deviations = deviation(projection, part)
    percent = deviations.percent[~own]
    percent = percent[np.isfinite(percent)]
    worst = float(percent.max()) if len(percent) else None
    curves = bow(projection, part.of(~own), _EDGE_STEPS)
    bows: list[Mark] = [Polyline(each, "leader", 0.5) for each in curves]
    at = None
    if not own.any():
        note = WORDS.phrase("outside")
    elif not math.isfinite(deviations.percent[0]):
        note = WORDS.phrase("short")
    else:
        at = float(deviations.percent[0]), float(deviations.w[0])
    if own.any():
        bows.append(_own_bow(projection, part.of(own), deviations))
    cut = at is not None and bool(part.cut[0])
    return Illustration(
        _readings(at, worst, WORDS.phrase("cut") if cut else note, mesh, cut=cut),
        world,
        Marks.of(*bows),
        image,
        warning=note,
        grips=grips,
    )


def _own_bow(projection: Projection, part: Inside, deviations: Deviation) -> Marks:
    """The bow of PQ, its straight image, and the largest distance between bow and chord."""
    (curve,), (straight,) = bow(projection, part, _STEPS), part.ndc
    percent, step, w = (each[0] for each in deviations)
    on_chord = (1.0 - step) * curve[0] + step * curve[-1]
    on_bow = on_chord.copy()
    on_bow[2] = affine_z(projection, w)
    # The names stand outside of the bow, and beyond the end of the straight image.
    quarter = 3 * len(_STEPS) // 4
    beside = (1.0 - _STEPS[quarter]) * curve[0] + _STEPS[quarter] * curve[-1]
    text = []
    if math.isfinite(percent):
        text = [Text("deviation", on_bow, away_from=on_chord, text=f"{figure(percent, 4)} %")]
    return Marks.of(
        *text,
        Polyline(straight, "accent", 2.0),
        Polyline(curve[[0, -1]], "muted"),
        Polyline(curve, "u", 2.0),
        segment(on_chord, on_bow, "ink", 1.0),
        Dot(on_bow, "u", 1.2),
        Text("Az+B", curve[quarter], "u", away_from=beside, text="A z + B"),
        Text("A+B/z", straight.mean(axis=0), "accent", (), on_bow, "{divided_z}"),
        *(named(name, end) for name, end in zip("PQ", straight, strict=True)),
    )


def _readings(
    own: tuple[float, float] | None,
    worst: float | None,
    note: Phrase | None,
    mesh: OwnMesh | None,
    no_worst: Phrase | None = None,
    cut: bool = False,
) -> tuple[Reading, ...]:
    """Percent and distance of PQ, percent of the worst edge, and why there is none of either."""
    percent, w = own or (None, None)
    label, away, some = "worst-of-letter", "away", None
    if mesh is not None:
        label, away = "worst-of-mesh", "mesh-away"
        if mesh.edge_count > _MOST_EDGES:
            some = WORDS.phrase("some-edges", str(_MOST_EDGES), str(mesh.edge_count))
    where = note
    if percent == 0.0:
        w, where = None, WORDS.phrase("straight") if cut or note is None else note
    why = (no_worst or WORDS.phrase(away)) if worst is None else some
    return (
        Reading(WORDS["deviation"], percent, "%", note),
        Reading(WORDS["where-cut" if cut else "where"], w, note=where),
        Reading(WORDS[label], worst, "%", why),
    )


PHENOMENON = Phenomenon.of(WORDS, show=_show)
