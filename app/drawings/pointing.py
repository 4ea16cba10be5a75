"""Pointing in a pane: what is under a pixel, and how it is highlighted.

Everything for the highlight is created with its drawing. A highlight changes line widths, point
sizes and visibilities, never the number of actors, and costs a slider step nothing.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import chain, pairwise
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings.actors import CUBE_EDGES, Space, face_actor, line_actor, point_actor
from app.drawings.label import SceneLabel
from app.drawings.names import QUIET, QUIET_WIDTH, Names
from app.drawings.prop_group import PropGroup
from app.drawings.style import Style, rgb
from app.lecture.highlight import CORNERS, NOTHING, SIDES, Highlight
from app.model.parameters import FAR, NEAR
from app.model.projection import Array

NEAR_FACE, FAR_FACE = (0, 1, 2, 3), (4, 5, 6, 7)
FACES = {  # the corners of each plane's face, in the order of `highlight.CORNERS`
    NEAR.name: NEAR_FACE,
    FAR.name: FAR_FACE,
    **{side: (i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4) for i, side in enumerate(SIDES)},
}

_WIDER, _LARGER = 2.4, 1.7
_CORNER = 4.5  # widths of a line
_TINT = 0.22
_DASHES, _DASH = 16, 0.6  # of an edge of the far plane; share of a dash and its gap
_POINT_EM, _LINE_EM = 0.65, 0.45  # so near is on it

Spot: TypeAlias = tuple[float, float, float]
"""Pixels from the pane's left and top, and an order that is linear there: smaller in front."""
Segment: TypeAlias = tuple[Highlight, Spot, Spot]


class Emphasis:
    def __init__(self, canvas: PropGroup) -> None:
        self._canvas = canvas
        self._marks: list[_Highlightable] = []
        self._calls: list[tuple[Highlight, Callable[[bool], object]]] = []
        self._labels: list[tuple[str, SceneLabel]] = []
        self._shown = self._names = NOTHING

    def _call_for(self, names: Iterable[str], tell: Callable[[bool], object]) -> None:
        self._calls.append((frozenset(names), tell))
        self._names |= frozenset(names)

    def line(self, actor: vtkActor, *names: str, of: Sequence[str] = ()) -> None:
        """Draw these lines wider while one of the names is highlighted.

        They are drawn quietly while none of `of`, by default of the names, is named.
        """
        mark = _Highlightable(actor, self._canvas.style.background, frozenset(of or names))
        self._marks.append(mark)
        if names:
            self._call_for(names, mark.highlight)

    def show_names(self, names: Names) -> None:
        """Draw those lines quietly whose things are not named."""
        for mark in self._marks:
            mark.set_quiet(not any(name in names for name in mark.of))

    def point(self, actor: vtkActor, *names: str) -> None:
        """Draw these points larger."""
        point = actor.GetProperty()
        size = point.GetPointSize()
        self._call_for(names, lambda on: point.SetPointSize(size * (_LARGER if on else 1.0)))

    def hidden(self, actor: Any, *names: str) -> None:
        """Draw this only while one of the names is highlighted."""
        actor.SetVisibility(False)
        self._call_for(names, actor.SetVisibility)

    def label(self, label: SceneLabel, name: str) -> None:
        """Underline this label; it can be pointed at, too."""
        self._call_for((name,), label.set_underlined)
        self._labels.append((name, label))

    def volume(self, space: Space, corners: Array) -> list[Any]:
        """Create a view volume's faces, outlines and corners that only a highlight shows.

        `corners`, (8, 3), are in the order of `highlight.CORNERS` and under `space`. Returns the
        faces, which may have to be put behind the scene.
        """
        faces, style = [], self._canvas.style
        for name, face in FACES.items():
            colour = getattr(style, name, style.accent)
            tint = face_actor(corners, [face], colour, _TINT)
            around = line_actor(corners, [(*face, face[0])], colour, _WIDER * style.line_width)
            for actor in (around, tint):
                space.add(actor)
                self._canvas.add(actor)
                self.hidden(actor, name)
            faces.append(tint)
        for name, corner in zip(CORNERS, corners, strict=True):
            point = point_actor([corner], style.accent, _CORNER * style.line_width)
            space.add(point)
            self._canvas.add(point)
            self.hidden(point, name)
        return faces

    def show(self, highlighted: Highlight) -> bool:
        """Highlight these things, and nothing else; return whether anything has changed."""
        shown = highlighted & self._names
        if shown == self._shown:
            return False
        self._shown = shown
        for names, tell in self._calls:
            tell(bool(names & shown))
        return True

    def label_at(self, x_px: float, y_px: float) -> Highlight:
        """Return what the label at a pixel, counted from the pane's top left, is about."""
        height_px = self._canvas.window.GetSize()[1]
        for name, label in self._labels:
            if label.covers(x_px, height_px - y_px):
                return frozenset((name,))
        return NOTHING


class _Highlightable:
    """Lines or faces that are highlighted, or quiet, or neither."""

    def __init__(self, actor: vtkActor, paper: str, of: frozenset[str]) -> None:
        self._property, self.of = actor.GetProperty(), of
        self._width, self._colour = self._property.GetLineWidth(), self._property.GetColor()
        self._paper = rgb(paper)
        self._quiet = self._highlighted = False

    def highlight(self, highlighted: bool) -> None:
        self._highlighted = highlighted
        self._dress()

    def set_quiet(self, quiet: bool) -> None:
        if quiet != self._quiet:
            self._quiet = quiet
            self._dress()

    def _dress(self) -> None:
        quiet = self._quiet and not self._highlighted
        times = _WIDER if self._highlighted else QUIET_WIDTH if quiet else 1.0
        self._property.SetLineWidth(times * self._width)
        part = QUIET if quiet else 0.0
        pairs = zip(self._colour, self._paper, strict=True)
        self._property.SetColor(*((1.0 - part) * c + part * p for c, p in pairs))


def outline(face: Sequence[int], corners: Array, style: Style, dashed: bool) -> vtkActor:
    """Return the outline of a face of a view volume; on paper far is dashed, not only blue."""
    colour = style.far if dashed else style.near
    points, lines = corners, [(*face, face[0])]
    if dashed and style.on_paper:
        begins = corners[[*face]]
        ends = np.roll(begins, -1, axis=0)
        at = np.array([(i, i + _DASH) for i in range(_DASHES)]).ravel() / (_DASHES - 1 + _DASH)
        points = (begins[:, None] + at[:, None] * (ends - begins)[:, None]).reshape(-1, 3)
        lines = [(i, i + 1) for i in range(0, len(points), 2)]
    return line_actor(points, lines, colour, 1.5 * style.line_width)


def volume_edges(spots: Sequence[Spot]) -> list[Segment]:
    """Return a view volume's twelve edges from its eight corners, with the planes of each."""
    edges = []
    for line in CUBE_EDGES:
        for start, end in pairwise(line):
            planes = {NEAR.name if end < 4 else FAR.name}
            if start < 4 <= end:
                planes = {name for name in SIDES if start in FACES[name]}
            edges.append((frozenset(planes), spots[start], spots[end]))
    return edges


class Targets(NamedTuple):
    """What can be pointed at; NaN is ignored. Of faces, only those light up that can be taken."""

    points: Sequence[tuple[Highlight, Spot]] = ()
    segments: Sequence[Segment] = ()


def pointed_at(place: tuple[float, float], em: float, targets: Sequence[Targets]) -> Highlight:
    """Return what is at a pixel: the nearest point, else the nearest line.

    `place` counts from the pane's top left; `em`, the height of the labels' font in pixels, scales
    the hand's precision. Of equally near things the first counts.
    """
    best, pointed = _POINT_EM * em, NOTHING
    for names, spot in chain.from_iterable(each.points for each in targets):
        away = math.dist(spot[:2], place)
        if away < best:  # never for NaN
            best, pointed = away, names
    if pointed:
        return pointed
    best = _LINE_EM * em
    for names, start, end in chain.from_iterable(each.segments for each in targets):
        away = _from_segment(place, start, end)
        if away < best:
            best, pointed = away, names
    return pointed


def _from_segment(place: tuple[float, float], start: Spot, end: Spot) -> float:
    along_x, along_y = end[0] - start[0], end[1] - start[1]
    square = along_x * along_x + along_y * along_y
    part = 0.0
    if square > 0.0:
        to_x, to_y = place[0] - start[0], place[1] - start[1]
        part = min(1.0, max(0.0, (to_x * along_x + to_y * along_y) / square))
    return math.dist(place, (start[0] + part * along_x, start[1] + part * along_y))
