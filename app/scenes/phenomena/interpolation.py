"""Perspective-correct interpolation: half-way on the screen is not half-way in the world.

On the screen 1/w is linear, and so is s/w for every s that is linear on a face (lectures 002 and
003): the rasteriser interpolates both and divides. Along an edge from depth w_a to w_b = k w_a, a
part sigma of the way on the screen is a part ``sigma / ((1 - sigma) k + sigma)`` of the edge.
Affine interpolation, of s itself, takes sigma instead, too much by at most

    e(k) = (sqrt k - 1)/(sqrt k + 1)    at sigma = sqrt k/(sqrt k + 1)

of the edge, where the derivative of the difference is 0. On the screen, the point that belongs
there is drawn at most the same part e(k) of the edge away from it.

Inside a triangle the error is never larger. With barycentric weights b on the screen and
q_i = 1/w_i the error of s is ``sum b q s / sum b q - sum b s``. Where its gradient is 0 inside the
triangle, its second derivative along a direction d is ``-2 (d.q) (d.q(s - s0)) / (b.q)^2``. That is
a product of two different linear forms in d, which takes both signs: a saddle, no maximum. So the
largest error, of s or of any direction of the texture, and by the same argument of the place on the
screen, is on an edge. All edges of the triangles are examined, also the diagonals.
"""

from functools import cache

import numpy as np

from app.model.parameter import Settings, number
from app.model.projection import Array, Projection
from app.scenes.phenomena.illustration import Illustration, Phenomenon, Subject
from app.scenes.phenomena.marks import Mark, Marks, Polyline, Rendering, Text, Texture, named
from app.scenes.phenomena.picture import seen, seen_lines
from app.scenes.phenomena.words import Curve, Diagram, PhenomenonWords, Phrase, Reading, Spot
from app.scenes.shapes import Coloured, flat, ground_grid

WORDS = PhenomenonWords("interpolation")

TEXELS = 256  # of the board's texture, each side

_CHECKS = 8
_CORNERS = np.array([(-5.0, 0, 5), (5, 0, 5), (5, 0, -5), (-5, 0, -5)])
_BOARD = _CORNERS[[[0, 1, 3], [1, 2, 3]]]  # the rasteriser draws the same diagonal
_RGB = (245, 242, 230)
_STEPS = np.linspace(0.0, 1.0, 33)  # along the edge that is plotted, on the screen
_MOST_PARTS = 1000  # sides of a mesh's triangles, after they are cut, that the readings examine


def _geometry() -> tuple[Coloured, Coloured]:
    return (_CORNERS[None], flat(_RGB, 1)), ground_grid((-8.0, -8.0), (8.0, 8.0), (2.0, 2.0), -1.5)


def edge_error(ratio: Array) -> Array:
    """e(k) of the module's text, for any k: the largest error in parts of an edge."""
    root = np.sqrt(ratio)
    return np.asarray(np.abs(root - 1.0) / (root + 1.0))


def largest_errors(
    projection: Projection, triangles: Array, texture_from_world: Array, parts: int
) -> tuple[float, float] | None:
    """The largest error of affine interpolation on triangles (t, 3, 3), in texels and in pixels.

    Each side of a triangle is cut into `parts`. None if the near plane cuts a triangle.
    """
    starts, steps = _edges_at_rim(parts)
    ends = np.stack([starts, starts + steps]) / parts  # (2, m, 3), of the triangle's corners
    trace = projection.trace(triangles)
    if trace.outside[..., 0].any():
        return None
    width, height = projection.image_size
    # Clip x, y, w are linear on a triangle; those of both ends of every edge, (2, t, m, 3).
    clip = ends[:, None] @ trace.clip[None, ..., [0, 1, 3]]
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        image = clip[..., :2] / clip[..., 2:] * (width / 2.0, height / 2.0)
        error = edge_error(clip[1, ..., 2] / clip[0, ..., 2])
        px = error * np.hypot(*np.moveaxis(image[1] - image[0], -1, 0))
    sides = steps @ (triangles @ texture_from_world[:, :3].T) / parts
    texels = TEXELS * (error * np.hypot(sides[..., 0], sides[..., 1]))
    if not (np.isfinite(px).all() and np.isfinite(texels).all()):
        return None
    return float(texels.max()), float(px.max())


@cache
def _edges_at_rim(parts: int) -> tuple[Array, Array]:
    """The small triangles' edges that can have the largest error, in each of three directions.

    Of the edges of one direction the nearest have the largest e. An edge's length on the screen is
    that of an affine function of its place, times a factor that depends on w alone. So it is convex
    along a line of constant w, and largest where that line meets the rim of the triangle of the
    edges' starts.

    Returns starts and steps (m, 3) as multiples of the three corners: the starts add up to `parts`,
    the steps to 0.
    """
    grid = np.array([(a, b) for a in range(parts) for b in range(parts - a)], dtype=np.float64)
    rest = parts - 1.0 - grid.sum(axis=1, keepdims=True)
    inner = np.concatenate([grid, rest], axis=1)
    rim = inner[(inner == 0.0).any(axis=1)]
    starts, steps = [], []
    for corner in range(3):
        start, step = np.zeros(3), np.zeros(3)
        start[corner] = 1.0
        step[corner], step[(corner + 1) % 3] = -1.0, 1.0
        starts.append(rim + start)
        steps.append(np.broadcast_to(step, rim.shape))
    return np.concatenate(starts), np.concatenate(steps)


def planar_texture(subject: Subject) -> Array:
    """The (2, 4) matrix for s and t along the two largest extents of the subject's bounds."""
    low = np.array(subject.lower)
    extent = np.array(subject.upper) - low
    matrix = np.zeros((2, 4))
    for row, axis in enumerate(sorted(np.argsort(-extent, kind="stable")[:2].tolist())):
        scale = 1.0 / (extent[axis] or float(extent.max()))
        matrix[row, axis], matrix[row, 3] = scale, -low[axis] * scale
    return matrix


def _show(projection: Projection, settings: Settings, subject: Subject) -> Illustration:
    parts, affine = int(number(settings, "subdivision")), settings["interpolation"] == "affine"
    coordinates = settings["pattern"] == "coordinates"
    texture = Texture(planar_texture(subject), _CHECKS, affine, parts, coordinates)
    rendering = Rendering(texture=texture)
    mesh = subject.mesh
    triangles, ends, said, cut = _BOARD, _CORNERS[[0, 3]], None, WORDS.phrase("cut")
    if mesh is not None:
        triangles, ends = mesh.triangles[: max(1, _MOST_PARTS // parts)], mesh.edges[0]
        said, cut = WORDS.phrase("laid"), WORDS.phrase("mesh-cut")
        if mesh.more_triangles or len(triangles) < len(mesh.triangles):
            said = WORDS.phrase("some", str(len(triangles)))
    errors = largest_errors(projection, triangles, texture.texture_from_world, parts)
    note = cut if errors is None else None
    trace = projection.trace(ends)
    if trace.outside[:, 0].any() or not np.isfinite(trace.image).all():
        return Illustration(_readings(errors, None, cut, said), rendering=rendering, warning=cut)
    nearer_first = np.argsort(trace.clip[:, 3], kind="stable")
    ends, w = ends[nearer_first], trace.clip[nearer_first, 3]
    part = 1.0 / (float(w[1] / w[0]) + 1.0)
    in_world = np.stack([ends.mean(axis=0), ends[0] + part * (ends[1] - ends[0])])
    middles = projection.trace(in_world)
    depths = zip(("z_1", "z_3", "z_2"), (ends[0], in_world[1], ends[1]), strict=True)
    world: list[Mark] = [Polyline(ends, "ink", 1.5), *(Text(*each) for each in depths)]
    image: list[Mark] = [*seen_lines(projection, trace.clip[None], ("ink",), 1.5)]
    in_image = (middles.image[0], trace.image.mean(axis=0))
    names = ("half-in-world", "target"), ("half-on-screen", "accent")
    each = zip(names, in_world, in_image, seen(middles), strict=True)
    for (name, colour), place, pixel, shown in each:
        world.append(named(name, place, colour, 1.4, WORDS[name]))
        if shown:
            image.append(named(name, pixel, colour, 1.4, WORDS[name]))
    parallel = WORDS.of_parallel(projection)
    return Illustration(
        _readings(errors, part, note, said),
        world=Marks.of(*world),
        image=Marks.of(*image),
        diagrams=_along_edge(projection, ends, w) if parallel is None else (),
        rendering=rendering,
        warning=note or parallel,
    )


def _along_edge(projection: Projection, ends: Array, w: Array) -> tuple[Diagram, ...]:
    """1/w and the depth z' = A + B/z along the marked edge, over the part t of it on the screen.

    Both are computed for the points of the edge that are seen at t, each from its own place in the
    world, and come out straight (lecture 003: 1/z3 = (1 - t)/z1 + t/z2; 000 and 002: A + B/z). The
    ends (2, 3) have the distances w (2,) from the eye plane.
    """
    near, far = (1.0 - _STEPS) / w[0], _STEPS / w[1]
    trace = projection.trace(ends[0] + (far / (near + far))[:, None] * (ends[1] - ends[0]))
    affine = 1.0 / ((1.0 - _STEPS) * w[0] + _STEPS * w[1])

    def diagram(
        title: str, y_label: str, y: Array, bounds: tuple[float, float], *more: Curve
    ) -> Diagram:
        return Diagram(
            WORDS[title],
            (Curve(np.column_stack([_STEPS, y]), "accent", "", 2.0), *more),
            *(0.0, 1.0, *bounds),
            x_label=WORDS["t"],
            y_label=y_label,
            spots=(Spot(0.5, float(y[len(_STEPS) // 2]), "t = ½", colour="accent"),),
        )

    linear = Curve(np.column_stack([_STEPS, affine]), "u", WORDS["linear"])
    low, high = sorted(projection.depth_range)
    one_over_w = 1.0 / trace.clip[:, 3]
    return (
        diagram("one-over-w", "1/w = −1/z", one_over_w, (0.0, 1.1 / float(w.min())), linear),
        diagram("depth", "z'", trace.ndc[:, 2], (low, high)),
    )


def _readings(
    errors: tuple[float, float] | None, part: float | None, note: Phrase | None, said: Phrase | None
) -> tuple[Reading, ...]:
    """The readout; `note` says why a value is missing, `said` what was examined."""
    texels, px = errors or (None, None)
    half_way = None if part is None else 100.0 * part
    return (
        Reading(WORDS["texels"], texels, note=note or said),
        Reading(WORDS["px"], px, "px", note),
        Reading.or_why(WORDS["half-way"], half_way, "%", note),
    )


PHENOMENON = Phenomenon.of(WORDS, geometry=_geometry, show=_show)
