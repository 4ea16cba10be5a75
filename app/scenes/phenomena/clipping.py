"""Clipping: inside, outside, crossing; and a polygon cut by one plane after the other.

An object inside all six planes of the view volume is drawn, and an object beyond one of them is
not. Only an object that crosses must be cut (lectures 001, 004), here after Sutherland & Hodgman:
each plane takes the polygon that the plane before has left, keeps the part on its own side, and
adds a new corner where an edge crosses. `app.model.clipping` cuts in clip space; the pieces in the
world follow from the polygon's own corners, without an inverse matrix.
"""

import math
from collections.abc import Sequence
from itertools import chain
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.model.clipping import clip_polygon
from app.model.limits import PLANES
from app.model.parameter import Settings, number
from app.model.projection import DEPTH_RANGES, Array, Projection, Vector
from app.model.refusal import Refusal
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Face, Mark, Marks, Polyline, Text, named, outline, plate
from app.scenes.phenomena.picture import SIDES, drawn_planes, image_from_ndc, section
from app.scenes.phenomena.words import Curve, Diagram, PhenomenonWords, Reading
from app.scenes.shapes import Coloured, flat, ground_grid

WORDS = PhenomenonWords("clipping")

TRIANGLE = np.array([(2.25, 3.0, 5.75), (4.0, 11.0, -7.0), (-8.0, 2.0, -0.5)])
"""World corners A, B, C of the polygon that is cut: each of the six planes adds one corner."""

# The corners of each plane's face: 0 to 3 belong to the near section, or to the cube's near face,
# and 4 to 7 to the far one.
_FACES = ((0, 1, 2, 3), (4, 5, 6, 7), (3, 0, 4, 7), (1, 2, 6, 5), (0, 1, 5, 4), (2, 3, 7, 6))
_WINDOW = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
_COUNTS = ("before", "after", "inside", "outside", "crossing")
_PALE = 0.72  # opacity of the veil over what is outside

# The middle of each card, the two world axes that it is parallel to, and half its side.
_CARDS = (
    ((1.6, 3.2, 0.0), "xy", 0.9), ((3.4, 5.6, -2.5), "xy", 0.9), ((-1.8, 2.8, 1.5), "xy", 0.6),
    ((6.0, 3.6, -1.0), "xy", 0.9), ((1.6, 7.9, -3.0), "xy", 0.9), ((4.6, 0.0, -3.2), "xy", 0.9),
    ((3.0, 3.2, -5.0), "xz", 0.9), ((0.2, 3.4, 5.0), "xz", 0.6),
    ((5.6, 3.4, 3.5), "xy", 0.9), ((1.0, 5.0, -8.0), "xy", 0.9), ((-8.0, 3.0, -1.0), "xy", 0.9),
)  # fmt: skip
_HUES = ((230, 159, 0), (86, 180, 233), (0, 158, 115), (240, 228, 66), (0, 114, 178), (213, 94, 0))


def _card(middle: Vector, level: str, half: float) -> Array:
    """The corners of a card, (4, 3)."""
    corners = np.tile(middle, (4, 1))
    corners[:, ["xyz".index(axis) for axis in level]] += half * _WINDOW
    return corners


CARDS = np.array([_card(*each) for each in _CARDS])  # world corners of the faces, (11, 4, 3)


def _geometry() -> tuple[Coloured, Coloured]:
    rgb = np.concatenate([flat(_HUES[i % len(_HUES)], 1) for i in range(len(CARDS))])
    return (CARDS, rgb), ground_grid((-8.0, -10.0), (8.0, 8.0), (2.0, 2.0), 0.0)


class Cut(NamedTuple):
    """A polygon after one more plane, in clip coordinates.

    - `new` (k, 4): those of the corners that the plane has made: 2 where it crosses the polygon, or
      fewer where it goes through an old corner.
    """

    corners: Array  # (m, 4): what is left of it; m may be 0
    new: Array
    off: Array  # (j, 4): the part that the plane has cut off; j may be 0


_NONE = np.empty((0, 4))


def cut_by(points_clip: Array, plane: str, depth: str = "opengl") -> Cut:
    """Cut a convex polygon (n, 4) by one of `PLANES`, and keep both parts.

    The polygon has no corner, or at least 3, in order. Raises a `Refusal` like
    `app.model.clipping.clip_polygon`.
    """
    if not len(points_clip):
        return Cut(_NONE, _NONE, _NONE)
    left, edges = clip_polygon(points_clip, depth, (plane,))
    if not len(left):
        return Cut(left, _NONE, points_clip)
    if plane not in edges:
        return Cut(left, _NONE, _NONE)
    leaves = edges.index(plane)  # the polygon goes out here, and comes in again at the next
    gap = left[[leaves, (leaves + 1) % len(left)]]
    is_new = ~_are_among(gap, points_clip)
    gone = ~_are_among(points_clip, left)
    first = next(i for i in range(len(gone)) if gone[i] and not gone[i - 1])
    outer = np.roll(points_clip, -first, axis=0)[: int(gone.sum())]
    return Cut(left, gap[is_new], np.concatenate([gap[:1], outer, gap[1:]]))


def steps(points_clip: Array, depth: str = "opengl") -> list[Cut]:
    """The polygon uncut, and after each of the six planes in the order of `PLANES`: 7 cuts."""
    cuts = [Cut(points_clip, _NONE, _NONE)]
    for plane in PLANES:
        cuts.append(cut_by(cuts[-1].corners, plane, depth))
    return cuts


def _are_among(points: Array, others: Array) -> NDArray[np.bool_]:
    """Which of some points (n, 4) are among the others, to the last bit."""
    return np.asarray((points[:, None] == others).all(axis=2).any(axis=1))


def classified(projection: Projection, faces: Array) -> tuple[list[int], list[int], list[int]]:
    """Which flat convex faces (n, k, 3) of the world are inside, outside, and crossing.

    Inside: no corner is beyond a plane. Outside: all corners are beyond one and the same plane, or
    the face passes an edge of the volume. Raises a `Refusal` like `clip_polygon`.
    """
    trace = projection.trace(faces)
    whole, outside, crossing = list[int](), list[int](), list[int]()
    for i, (clip, beyond) in enumerate(zip(trace.clip, trace.outside, strict=True)):
        if not beyond.any():
            whole.append(i)
        elif beyond.all(axis=0).any() or not len(clip_polygon(clip, projection.depth).points_clip):
            outside.append(i)
        else:
            crossing.append(i)
    return whole, outside, crossing


def _shares(corners_clip: Array, points_clip: Array) -> Array:
    """The shares of a polygon's first three corners in its cut corners, (n, 3).

    With the corners' clip coordinates as columns, ``C s = p``. A cut corner is a sum of ends with
    shares that add up to 1. A matrix takes sums to sums, so in the world it is ``sum s_i c_i``,
    too. The rows are scaled, because a lens makes coordinates of very different size.
    """
    rows = corners_clip[:3].T
    size = np.maximum(np.abs(rows).max(axis=1, keepdims=True), 5e-324)
    with np.errstate(over="ignore", invalid="ignore"):
        scaled = rows / size, points_clip.T / size
    if not all(np.isfinite(part).all() for part in scaled):
        return np.full((len(points_clip), 3), np.nan)
    return np.asarray(np.linalg.lstsq(*scaled, rcond=None)[0].T)


def _to_ndc(points_clip: Array) -> Array:
    """NDC of clip points (n, 4); NaN where w is not positive."""
    w = np.where(points_clip[:, 3:] > 0.0, points_clip[:, 3:], np.nan)
    with np.errstate(over="ignore", invalid="ignore"):
        ndc: Array = points_clip[:, :3] / w
    return ndc


def _colour(step: int) -> str:
    return PLANES[step - 1] if step < 3 else "v"


def _pieces(parts: Sequence[Array], step: int) -> Marks:
    """The polygon after a step, its new corners, and, pale, everything cut off until then."""
    now, new, *off = parts
    marks: list[Mark] = [plate(piece, "muted", 1.0, 0.12) for piece in off]
    if len(now):
        marks.append(plate(now, "accent", 2.5, 0.45))
    return Marks.of(*marks, _numbered(new, step))


def _numbered(new: Array, step: int) -> Marks:
    """The corners that a step has made: 1 and 2."""
    return Marks.of(*(named(name, at, _colour(step), 1.8) for name, at in zip("12", new)))  # noqa: B905


def _lettered(places: Array) -> Marks:
    """A, B and C where they are, also after a cut; none where the divide has no place for it."""
    return _finite(Marks.of(*map(Text, "ABC", places, ["accent"] * 3)))


def _cut_face(box: Array, step: int) -> Marks:
    """The plane of a step, as a face of a box (8, 3). Near and far are named elsewhere."""
    if not step:
        return Marks()
    face, colour = box[list(_FACES[step - 1])], _colour(step)
    with np.errstate(over="ignore", invalid="ignore"):
        plane = PLANES[step - 1]
        name = Text(plane, (face[2] + face[3]) / 2.0, colour, text=WORDS[plane])
    return Marks.of(plate(face, colour, 2.5, 0.2), *([] if step < 3 else [name]))


def _finite(*parts: Marks) -> Marks:
    """All marks but those whose numbers overflow."""
    return Marks.of(
        *(
            mark
            for mark in chain(*Marks.of(*parts).kinds)
            if np.isfinite(mark.points if isinstance(mark, Polyline | Face) else mark.point).all()
        )
    )


def _veil(projection: Projection, outside: Sequence[int], crossing: Sequence[int]) -> Marks:
    """A veil over the cards, or parts of them, that are outside."""
    pieces = [CARDS[i] for i in outside]
    for i in crossing:
        clip = projection.trace(CARDS[i]).clip
        off = [cut.off for cut in steps(clip, projection.depth)]
        pieces += [_shares(clip, piece) @ CARDS[i][:3] for piece in off if len(piece)]
    return Marks.of(
        *(Polyline(outline(piece), "muted", 1.0) for piece in pieces),
        *(Face(piece, "background", _PALE) for piece in pieces),
    )


def _image(projection: Projection, clip: Array, step: int, new: Array) -> Marks:
    """The part of the polygon after a step in front of the eye and in the frame, in pixels."""
    planes = {*PLANES[:step], *SIDES}
    left = _to_ndc(clip_polygon(clip, projection.depth, planes).points_clip)
    pixels = image_from_ndc(projection, left)
    if not len(pixels) or not np.isfinite(pixels).all():
        return Marks()
    corners = _to_ndc(new)
    inside = corners[(np.abs(corners[:, :2]) <= 1.0).all(axis=1)]
    numbered = _numbered(image_from_ndc(projection, inside), step)
    own = _to_ndc(clip)
    own[(np.abs(own[:, :2]) > 1.0).any(axis=1)] = np.nan  # beside the picture
    letters = _lettered(image_from_ndc(projection, own))
    return Marks.of(plate(pixels, "accent", 2.5, 0.35), numbered, letters)


def _show(projection: Projection, settings: Settings, _subject: Subject) -> Illustration:
    step = int(number(settings, "step"))
    clip = projection.trace(TRIANGLE).clip
    try:
        cuts = steps(clip, projection.depth)
        whole, outside, crossing = classified(projection, CARDS)
        veil = _veil(projection, outside, crossing)
        image = _image(projection, clip, step, cuts[step].new)
    except Refusal:  # the camera is the reason, and the illustration says so
        return Illustration((), warning=WORDS.phrase("too-large"))
    now, off = cuts[step], [cut.off for cut in cuts[1 : step + 1] if len(cut.off)]
    before, after = len(cuts[max(step - 1, 0)].corners), len(now.corners)
    parts = [now.corners, now.new, *off]
    shares = [_shares(clip, part) for part in parts]
    z_near, z_far = projection.depth_range
    cube = np.concatenate([np.column_stack([_WINDOW, [z] * 4]) for z in (z_near, z_far)])
    volume = np.concatenate([section(projection, w) for w in drawn_planes(projection)])
    in_world = [part @ TRIANGLE for part in shares]
    in_ndc = [_to_ndc(part) for part in parts]
    about = _about(step, projection.depth)
    counts = before, after, len(whole), len(outside), len(crossing)
    return Illustration(
        (
            Reading(WORDS["plane"], about[0] if about else WORDS["uncut"], about=about[:1]),
            Reading(WORDS["keeps"], _condition(about, step, projection.depth), about=about[1:]),
            *(
                Reading(WORDS[key], float(count))
                for key, count in zip(_COUNTS, counts, strict=True)
            ),
        ),
        world=_finite(veil, _cut_face(volume, step), _pieces(in_world, step), _lettered(TRIANGLE)),
        ndc=_finite(_cut_face(cube, step), _pieces(in_ndc, step), _lettered(_to_ndc(clip))),
        image=image,
        diagrams=(_diagram(shares[0], shares[1], step),),
        warning=WORDS.phrase("behind") if not step and not (clip[:, 3] > 0.0).all() else None,
        about=about,
    )


def _about(step: int, depth: str) -> tuple[str, ...]:
    """The plane of a step, and the rows of the clip matrix in its condition."""
    if not step:
        return ()
    end = {1: DEPTH_RANGES[depth][0], 2: DEPTH_RANGES[depth][1]}.get(step, 1.0)
    row = "zzxxyy"[step - 1]
    return (PLANES[step - 1], f"clip_{row}", *(("clip_w",) if end else ()))


def _condition(about: tuple[str, ...], step: int, depth: str) -> str:
    """The condition for a point that a step's plane keeps: ``w + x ≥ 0``."""
    if not about:
        return WORDS["all"]
    _, row, *w = about
    is_low = step % 2 == 1 if step > 2 else DEPTH_RANGES[depth][step - 1] < 0.0
    row = row.removeprefix("clip_")
    sign = "+" if is_low else "\u2212"
    return f"w {sign} {row} \u2265 0" if w else f"{row} \u2265 0"


def _flat() -> Array:
    """The triangle in its own plane, A to B along x, (3, 2)."""
    along, up = TRIANGLE[1] - TRIANGLE[0], TRIANGLE[2] - TRIANGLE[0]
    length = np.linalg.norm(along)
    x = up @ along / length
    return np.array([(0.0, 0.0), (length, 0.0), (x, -math.sqrt(up @ up - x * x))])


_FLAT = _flat()


def _diagram(now: Array, new: Array, step: int) -> Diagram:
    """The polygon in its own plane: uncut, after this step, and the new edge."""
    now, new = (part[np.isfinite(part).all(axis=1)] @ _FLAT for part in (now, new))
    curves = [Curve(_FLAT, "muted", width=1.0, closed=True)]
    if len(now):
        curves.append(Curve(now, "accent", width=2.5, closed=True))
    if len(new):
        curves.append(Curve(new, _colour(step), WORDS[PLANES[step - 1]], 2.5))
        curves.append(Curve(new, _colour(step), dots=True))
    curves += [Curve(_FLAT[i : i + 1], "ink", "ABC"[i], dots=True) for i in range(3)]
    (left, bottom), (right, top) = _FLAT.min(axis=0), _FLAT.max(axis=0)
    margin = 0.12 * (right - left)
    return Diagram(
        WORDS["flat"],
        tuple(curves),
        *(left - margin, right + margin, bottom - margin, top + margin),
        equal=True,
    )


PHENOMENON = Phenomenon.of(WORDS, geometry=_geometry, show=_show)
