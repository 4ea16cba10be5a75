"""What a phenomenon draws into the panes: marks, and copies of the scene; plain data.

And how the scene itself is rasterised. What follows every vertex is a matrix (`Copy`) or the
rasteriser's own work (`Rendering`); marks are few.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from app.model.depth import DepthBuffer
from app.model.projection import Array, Vector
from app.scenes.shapes import Coloured


@dataclass(frozen=True, eq=False)
class Line:
    """A polyline.

    Attributes
    ----------
    points : (k, 3) array, or (k, 2) in image pixels
    colour : str
    width : float
        In ordinary lines.
    about : tuple of str
        In the world: what it stands out with, as of `Reading`.
    """

    points: Array
    colour: str = "ink"
    width: float = 1.0
    about: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Face:
    """A flat convex polygon, translucent, seen from both sides; (k, 3), or (k, 2) in pixels."""

    points: Array
    colour: str = "accent"
    opacity: float = 0.3


@dataclass(frozen=True, eq=False)
class Dot:
    """A round point of `size` ordinary dots; `point` is (3,), or (2,) in pixels."""

    point: Array
    colour: str = "accent"
    size: float = 1.0


@dataclass(frozen=True, eq=False)
class Text:
    """A few letters beside a point.

    Attributes
    ----------
    text : str
    point : (3,) array, or (2,) in image pixels
    colour : str
        Of its plate, if it has one.
    about : tuple of str
        As of `Line`.
    away_from : array like `point`, optional
        In world and NDC, a point that they are rather not towards: the middle of what has an edge
        here, or what a curve bends away from.
    """

    text: str
    point: Array
    colour: str = ""
    about: tuple[str, ...] = ()
    away_from: Array | None = None


@dataclass(frozen=True, eq=False)
class Marks:
    """What is drawn over one pane.

    Colours are names of `app.drawings.style.Style` (``"near"``, ``"accent"``, ``"u"``, ...) or
    ``"#rrggbb"``. In the world pane points are world coordinates, in the NDC pane NDC, in the
    image pane pixels of the image.
    """

    lines: tuple[Line, ...] = ()
    faces: tuple[Face, ...] = ()
    dots: tuple[Dot, ...] = ()
    texts: tuple[Text, ...] = ()

    @classmethod
    def of(cls, *marks: Mark) -> Marks:
        """Marks of any kinds, sorted by their kinds; each kind in this order."""
        found: dict[type, list[Any]] = {Line: [], Face: [], Dot: [], Text: []}
        for mark in marks:
            if isinstance(mark, Marks):
                for kind, more in zip(found, mark.kinds, strict=True):
                    found[kind] += more
            else:
                found[mark.__class__].append(mark)
        return cls(*map(tuple, found.values()))

    @property
    def kinds(self) -> tuple[tuple[Any, ...], ...]:
        """All of them, kind by kind."""
        return self.lines, self.faces, self.dots, self.texts


Mark: TypeAlias = Marks | Line | Face | Dot | Text


def named(name: str, point: Array, colour: str = "accent", size: float = 1.3) -> Marks:
    """A dot with its letter beside it."""
    return Marks.of(Dot(point, colour, size), Text(name, point, colour))


def outline(corners: Array) -> Array:
    """A polygon's corners (k, ...), and the first of them once more."""
    return np.concatenate([corners, corners[:1]])


def plate(
    corners: Array, colour: str, width: float, opacity: float, about: tuple[str, ...] = ()
) -> Marks:
    """A flat convex polygon (k, 2 or 3), as a face with its outline in the same colour."""
    return Marks.of(Line(outline(corners), colour, width, about), Face(corners, colour, opacity))


@dataclass(frozen=True, eq=False)
class Grip:
    """Where a setting that is a point or a direction is taken hold of in the world pane.

    Attributes
    ----------
    setting : str
        Its name.
    point : (3,) array
        World coordinates.
    base : tuple of 3 floats
        The setting is ``point - base``: 0 for a point, where it is held from for a direction.
    """

    setting: str
    point: Array
    base: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True, eq=False)
class Length:
    """What one of the world's flat views measures across the axis, beside the distances along it.

    Attributes
    ----------
    view : str
        ``"side"`` or ``"top"``.
    name : str
        Its letter.
    value : float
        With its sign.
    start, end : (3,) array
        World coordinates, parallel to the screen there.
    """

    view: str
    name: str
    value: float
    start: Array
    end: Array


@dataclass(frozen=True, eq=False)
class Copy:
    """The scene's faces once more, under a further 4x4.

    Attributes
    ----------
    world_from_world : (4, 4) array
        Applied to the scene's world coordinates first; may be projective, and singular (a shadow).
    panes : tuple of {"world", "ndc", "image"}
    colour : str
        Of all faces; empty for their own.
    """

    world_from_world: Array
    panes: tuple[str, ...] = ("world",)
    colour: str = ""


@dataclass(frozen=True, eq=False)
class Texture:
    """A checkerboard laid over the scene's faces by a parallel projection of its own.

    Attributes
    ----------
    texture_from_world : (2, 4) array
        The texture's s and t of a world point; 0 to 1 across the board.
    checks : int
        Along each side.
    affine : bool
        Interpolate s and t linearly on the screen, without the divide that makes them right.
    subdivision : int
        Each face is drawn as the triangles of so many parts a side.
    coordinates : bool
        Show s as red and t as green instead of the checks.
    """

    texture_from_world: Array
    checks: int
    affine: bool = False
    subdivision: int = 1
    coordinates: bool = False


@dataclass(frozen=True)
class Fog:
    """What is far fades into the background.

    Attributes
    ----------
    start, end : float
        Distances from the eye plane between which it thickens, linearly.
    density : float
        If greater than 0, what is left falls as ``exp(-density w)`` instead.
    """

    start: float = 0.0
    end: float = math.inf
    density: float = 0.0

    def left(self, distance: float) -> float:
        """The part of a colour's contrast to the background that is left at a distance, 0..1."""
        if self.density > 0.0:
            return math.exp(-self.density * max(distance, 0.0))
        return min(max((self.end - distance) / (self.end - self.start), 0.0), 1.0)


@dataclass(frozen=True, eq=False)
class Level:
    """One level of detail of the scene's objects.

    Attributes
    ----------
    faces : Coloured
    objects : (m, 3) array
        The place, in world coordinates, of the object that each face is a part of.
    until : float
        Distance of that place from the eye plane from which the next level is drawn.
    """

    faces: Coloured
    objects: Array
    until: float


@dataclass(frozen=True, eq=False)
class Rendering:
    """How the scene is rasterised, where it is not the ordinary way.

    Attributes
    ----------
    buffer : DepthBuffer, optional
        The picture's depths are rounded to the codes of this one.
    texture : Texture, optional
    fog : Fog, optional
    levels : tuple of Level
        Drawn in place of the scene's faces: three of them, nearest first, or none. Their faces
        are those of the first time.
    """

    buffer: DepthBuffer | None = None
    texture: Texture | None = None
    fog: Fog | None = None
    levels: tuple[Level, ...] = ()
