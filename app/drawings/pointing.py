"""What a pane names, and how it highlights what is pointed at.

A highlight changes line widths, point sizes and visibilities, and costs a slider step nothing. What
it alone shows of a view volume is created at the first one.
"""

from collections.abc import Callable, Iterable, Sequence
from functools import partial
from typing import Any

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from app.drawings.actors import Space, face_actor, line_actor, point_actor, put_behind
from app.drawings.label import SceneLabel
from app.drawings.prop_group import PropGroup
from app.drawings.style import QUIET, QUIET_WIDTH, Style, rgb
from app.lecture.highlight import CORNERS, NOTHING, SIDES, Highlight
from app.model.parameters import FAR, NEAR
from app.model.projection import Array
from app.picking.handles import Handle

NEAR_FACE, FAR_FACE = (0, 1, 2, 3), (4, 5, 6, 7)
FACES = {  # the corners of each plane's face, in the order of `highlight.CORNERS`
    NEAR.name: NEAR_FACE,
    FAR.name: FAR_FACE,
    **{side: (i, (i + 1) % 4, (i + 1) % 4 + 4, i + 4) for i, side in enumerate(SIDES)},
}

_WIDER, _LARGER = 2.4, 1.7
_CORNER = 4.5  # widths of a line
_TINT = 0.22
# Of the far plane's edges. Vector formats round the ends of dashes, which fills short gaps.
_DASHES, _DASH = 10, 0.45  # dashes, and the share of one in it and its gap


class Names:
    """The ids that a drawing names; ``id in names`` asks for one.

    `wanted` is None for everything. What is `pointed` at or `held` is named in any case.
    """

    def __init__(self, wanted: frozenset[str] | None) -> None:
        self.wanted = wanted
        self.pointed: Highlight = NOTHING
        self.held: Handle | None = None

    def __contains__(self, name: object) -> bool:
        if self.wanted is None or name in self.wanted or name in self.pointed:
            return True
        return self.held is not None and name == self.held.name

    def wants(self, name: str) -> bool:
        """Whether a thing is named without being pointed at or held: the framing depends on it."""
        return self.wanted is None or name in self.wanted


class Emphasis:
    def __init__(self, canvas: PropGroup) -> None:
        self._canvas = canvas
        self._marks: list[_Highlightable] = []
        self._calls: list[tuple[Highlight, Callable[[bool], object]]] = []
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
        """Underline this label."""
        self._call_for((name,), label.set_underlined)

    def volume(self, space: Space, corners: Array, *, behind: bool = False) -> None:
        """Create a view volume's faces, outlines and corners when one is first highlighted.

        `corners`, (8, 3), are in the order of `highlight.CORNERS` and under `space`. The faces may
        be put `behind` the scene.
        """
        made, style = dict[str, list[vtkActor]](), self._canvas.style
        before = self._canvas.renderer.GetViewProps().GetLastProp()

        def make() -> None:
            for name, face in FACES.items():
                colour, ends = getattr(style, name, style.accent), [(*face, face[0])]
                around = line_actor(corners, ends, colour, _WIDER * style.line_width)
                made[name] = [around, face_actor(corners, [face], colour, _TINT)]
                if behind:
                    put_behind(made[name][1])
            for name, corner in zip(CORNERS, corners, strict=True):
                made[name] = [point_actor([corner], style.accent, _CORNER * style.line_width)]
            for actor in [actor for each in made.values() for actor in each][::-1]:
                actor.SetVisibility(False)
                space.add(actor)
                self._canvas.add(actor, after=before)

        def show(name: str, on: bool) -> None:
            if on and not made:
                make()
            for actor in made.get(name, ()):
                actor.SetVisibility(on)

        for name in (*FACES, *CORNERS):
            self._call_for((name,), partial(show, name))

    def show(self, highlighted: Highlight) -> bool:
        """Highlight these things, and nothing else; return whether anything has changed."""
        shown = highlighted & self._names
        if shown == self._shown:
            return False
        self._shown = shown
        for names, tell in self._calls:
            tell(bool(names & shown))
        return True


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
