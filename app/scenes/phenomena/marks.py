"""What a phenomenon draws into the panes: marks, and copies of the scene; plain data.

The module also says how the scene is rasterised. Effects on every vertex are matrices (`Copy`) or
the rasteriser's work (`Rendering`); marks are few.

A mark with a `name` belongs to the thing of that name: where the picture does not name it, the
mark is drawn more quietly. A line, face or dot without a name is always drawn as it is.

Colours are names of `app.drawings.style.Style`, such as ``"accent"``, or ``"#rrggbb"``. Points are
world coordinates in the world pane, NDC in the NDC pane and pixels in the image pane.
"""

import math
from dataclasses import dataclass, field, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from app.model.depth import DepthBuffer
from app.model.projection import Array, Camera, Frustum, Projection, Vector
from app.scenes.shapes import Coloured

_MOST_DASHES = 24


@dataclass(frozen=True, eq=False)
class Polyline:
    """A polyline (k, 2 or 3); `about` names what it is highlighted with, as in `Reading`."""

    points: Array
    colour: str = "ink"
    width: float = 1.0
    about: tuple[str, ...] = ()
    name: str = ""


@dataclass(frozen=True, eq=False)
class Face:
    """A flat convex polygon (k, 2 or 3), translucent, seen from both sides."""

    points: Array
    colour: str = "accent"
    opacity: float = 0.3
    name: str = ""


@dataclass(frozen=True, eq=False)
class Dot:
    """A round point (2 or 3,); `size` is relative to an ordinary dot."""

    point: Array
    colour: str = "accent"
    size: float = 1.0
    name: str = ""


@dataclass(frozen=True, eq=False)
class Text:
    """A few letters beside a point (2 or 3,).

    - `away_from` (2 or 3,): in the world and in NDC the letters are placed away from this point:
      the middle of a figure with an edge here, for example.
    - `is_title`: the letters stand below this point, which is in the middle of a picture's top.
    """

    name: str  # its plain name in ``view.names``: ``y_p``, ``film``
    point: Array
    colour: str = ""  # of its concept; empty for ink
    about: tuple[str, ...] = ()
    away_from: Array | None = None
    text: str = ""  # what is written, as of `app.drawings.label`; by default the name
    is_title: bool = False

    def __post_init__(self) -> None:
        if not self.text:
            object.__setattr__(self, "text", self.name)


@dataclass(frozen=True, eq=False)
class Marks:
    lines: tuple[Polyline, ...] = ()
    faces: tuple[Face, ...] = ()
    dots: tuple[Dot, ...] = ()
    texts: tuple[Text, ...] = ()

    @classmethod
    def of(cls, *marks: "Mark") -> "Marks":
        """Sort marks by kind; within a kind they keep their order."""
        by_kind: dict[type, list[Any]] = {Polyline: [], Face: [], Dot: [], Text: []}
        for mark in marks:
            if isinstance(mark, Marks):
                for kind, more in zip(by_kind, mark.kinds, strict=True):
                    by_kind[kind] += more
            else:
                by_kind[mark.__class__].append(mark)
        return cls(*map(tuple, by_kind.values()))

    @property
    def kinds(self) -> tuple[tuple[Any, ...], ...]:
        return self.lines, self.faces, self.dots, self.texts


Mark: TypeAlias = Marks | Polyline | Face | Dot | Text


def segment(
    start: ArrayLike, end: ArrayLike, colour: str, width: float, about: tuple[str, ...] = ()
) -> Polyline:
    return Polyline(np.array([start, end]), colour, width, about)


def named(
    name: str, point: Array, colour: str = "accent", size: float = 1.3, text: str = ""
) -> Marks:
    """A dot and its letter."""
    return Marks.of(Dot(point, colour, size, name), Text(name, point, colour, text=text))


def dash_dot(start: Array, end: Array, period: float, colour: str, width: float) -> list[Polyline]:
    """A line of an axis: a dash and a dot in each period, from the start on."""
    length = float(np.linalg.norm(end - start))
    count = min(math.ceil(length / period), _MOST_DASHES) if 0.0 < length < math.inf else 0
    lines = []
    for i in range(count):
        for low, high in ((i, i + 0.6), (i + 0.76, i + 0.84)):
            shares = np.minimum(np.array([low, high]) / count, 1.0)[:, None]
            lines.append(Polyline(start + shares * (end - start), colour, width))
    return lines


def right_angle(
    corner: Array, one: Array, other: Array, side: float, colour: str = "ink"
) -> Polyline:
    """The mark of a right angle at a corner, between the directions to two points."""
    toward, across = (
        side * (point - corner) / max(float(np.linalg.norm(point - corner)), 1e-300)
        for point in (one, other)
    )
    return Polyline(corner + np.array([toward, toward + across, across]), colour, 0.5)


def outline(corners: Array) -> Array:
    """The corners of a polygon (k, ...), closed with the first one."""
    return np.concatenate([corners, corners[:1]])


def plate(
    corners: Array,
    colour: str,
    width: float,
    opacity: float,
    about: tuple[str, ...] = (),
    name: str = "",
) -> Marks:
    """A flat convex polygon (k, 2 or 3): its face, and its outline in the same colour."""
    edge = Polyline(outline(corners), colour, width, about, name)
    return Marks.of(edge, Face(corners, colour, opacity, name))


@dataclass(frozen=True, eq=False)
class Grip:
    """A handle for a setting: a point, a direction, or a number on a rail.

    The setting's value is ``point - base``; of a direction, `base` is where it starts. A number is
    t in ``point = base + t along``, or with a fourth part w in `along`, over ``1 + t w``. What has
    this `name` takes hold of it, too, and so do the edges of the polygon `face`, and all of a
    polygon that is a plane: more than two points.
    """

    setting: str
    point: Array
    base: Vector = (0.0, 0.0, 0.0)
    along: tuple[float, ...] | None = None
    name: str = ""
    colour: str = "accent"
    face: Array = field(default_factory=lambda: np.empty((0, 3)))


@dataclass(frozen=True, eq=False)
class Length:
    """A length across the axis that a flat view of the world measures: ``"side"`` or ``"top"``.

    `value` has a sign. `start` and `end` are world points, parallel to that view's screen.
    """

    view: str
    name: str
    value: float
    start: Array
    end: Array


@dataclass(frozen=True, eq=False)
class Copy:
    """The scene's faces drawn once more, after a further matrix on their world coordinates.

    The 4x4 matrix may be projective and singular, as for a shadow. `panes` are some of ``"world"``,
    ``"ndc"`` and ``"image"``; an empty `colour` keeps the faces' own.
    """

    world_from_world: Array
    panes: tuple[str, ...] = ("world",)
    colour: str = ""


@dataclass(frozen=True, eq=False)
class Vertices:
    """Other places for the faces' vertices of a scene that requires ``"vertices"``, in the world.

    `own` (n, 3) are the vertices of the scene's faces, each once; the same array every time. The
    world pane draws them at `stored`; NDC, the image and the picture on the near plane at
    `projected`.
    """

    own: Array
    stored: Array
    projected: Array


@dataclass(frozen=True, eq=False)
class Texture:
    """A checkerboard laid over the scene's faces by a parallel projection of its own.

    - `affine`: interpolate s and t linearly on the screen, without the divide that makes them
      right.
    """

    texture_from_world: Array  # (2, 4): gives s and t of a world point, 0 to 1 across the board
    checks: int  # along each side
    affine: bool = False
    subdivision: int = 1  # each side of a face is cut into so many parts
    coordinates: bool = False  # show s as red and t as green instead of the checks


@dataclass(frozen=True)
class Fog:
    """Colours fade into the background with the distance w from the eye plane.

    The fog thickens linearly from `start` to `end`, or, with a density above 0, leaves
    ``exp(-density w)``.
    """

    start: float = 0.0
    end: float = math.inf
    density: float = 0.0

    def left(self, distance: float) -> float:
        """The part, 0 to 1, of a colour's contrast to the background left at a distance."""
        if self.density > 0.0:
            return math.exp(-self.density * max(distance, 0.0))
        return min(max((self.end - distance) / (self.end - self.start), 0.0), 1.0)


@dataclass(frozen=True)
class Aperture:
    """The round opening of a lens, in world units, and the distance that it is focused at."""

    radius: float
    focus: float

    def seen_from(
        self, projection: Projection, right: float, up: float, shift: tuple[float, float] = (0, 0)
    ) -> Projection:
        """The projection from a point of the opening, at these parts of its radius.

        The focused plane is the common window: a point of it has the same pixel from everywhere.
        `shift` moves the picture right and up, in pixels.
        """
        camera, lens = projection.camera, projection.lens
        x, y = self.radius * right, self.radius * up
        way = x * camera.frame[0] + y * camera.frame[1]
        eye, target = ((np.array(point) + way).tolist() for point in (camera.eye, camera.target))
        low_x, high_x, low_y, high_y = projection.window
        width, height = projection.image_size
        x = x * lens.near / self.focus + shift[0] * (high_x - low_x) / width
        y = y * lens.near / self.focus + shift[1] * (high_y - low_y) / height
        window = low_x - x, high_x - x, low_y - y, high_y - y
        return replace(
            projection,
            camera=Camera(tuple(eye), tuple(target), camera.up),
            lens=Frustum(*window, lens.near, lens.far, "stretch"),
        )


@dataclass(frozen=True)
class Eyes:
    """The projections of two eyes, whose pictures the image pane shows together.

    The middle halves of both are ``"beside"`` each other, or ``"crossed"`` with the left eye's on
    the right. In ``"red-cyan"`` one picture takes its red light from the left eye's, and its green
    and blue light from the right eye's.
    """

    left: Projection
    right: Projection
    pictures: str

    @property
    def shares(self) -> tuple[float, float]:
        """How far the left and the right eye's picture move to the right, in image widths."""
        return {"beside": (-0.25, 0.25), "crossed": (0.25, -0.25)}.get(self.pictures, (0.0, 0.0))


@dataclass(frozen=True, eq=False)
class DetailLevel:
    """One level of detail of the scene's objects.

    `objects` (m, 3) holds, for each of the m faces, the world place of its object. Where that place
    is farther than `until` from the eye plane, the next level is drawn.
    """

    faces: Coloured
    objects: Array
    until: float


@dataclass(frozen=True, eq=False)
class Rendering:
    """How the image pane rasterises the scene, where that is not the ordinary way.

    The depths are rounded to the codes of `buffer`. The `levels`, nearest first, are none or three,
    and replace the scene's faces; their faces must never change. With an `aperture`, what is not in
    focus is blurred. With `eyes`, the picture is theirs.
    """

    buffer: DepthBuffer | None = None
    texture: Texture | None = None
    fog: Fog | None = None
    levels: tuple[DetailLevel, ...] = ()
    aperture: Aperture | None = None
    eyes: Eyes | None = None
