"""The words of the world pane, and the layout that all panes share.

`Labels` owns every label of the world pane. `lay_out` places them one after the other: inside the
pane, where they hide nothing important and do not seem to belong to something else.
"""

from __future__ import annotations

import math
import weakref
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from itertools import product
from types import MappingProxyType
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from app.drawings.actors import Canvas, ScreenCells
from app.drawings.label import HALO_EM, Label
from app.drawings.label_placement import INK, LEADER, Box, Candidate, Placer
from app.drawings.pane_view import PaneView, Spot
from app.drawings.silhouette import Mask
from app.drawings.style import TITLE_EM, rgb
from app.model.projection import Array

AXES = ("v", "n", "u")
"""The camera's axes, in the order in which they are written."""
_THINGS = ("eye", "target", "near", "far")

# Where the planes' labels can be, best first, as parts of the corners that `Named` has: corners,
# then middles of edges; of the near face, then of the far one.
_CORNERS = np.eye(4)
_EDGES = (_CORNERS + np.roll(_CORNERS, -1, axis=0)) / 2.0
_PLANES_FROM_CORNERS = np.kron(np.eye(2), np.vstack([_CORNERS, _EDGES]))[
    [0, 3, 1, 2, 4, 7, 6, 5, *(8 + i for i in (3, 2, 0, 1, 6, 7, 5, 4))]
]

# On which sides of their points labels can be, best first: right and up, in half labels.
_ON = ((0.0, 0.0), (0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0))
_BELOW = (
    (0.3, -1.0), (1.0, -1.0), (-1.0, -1.0), (0.0, 1.0), (1.0, 1.0), (-1.0, 1.0),
    (-1.0, 0.0), (1.0, 0.0), (-1.0, -0.5), (1.0, -0.5), (-1.0, 0.5), (1.0, 0.5),
)  # fmt: skip
_RIGHT_BELOW = ((1.0, -0.6), (-1.0, -0.6), (0.0, -1.0), (0.0, 1.0), (1.0, 1.0), (-1.0, 1.0))
_BELOW_PLANE = (
    (-1.0, -1.0), (0.0, -1.0), (1.0, -1.0), (-1.0, 0.0), (1.0, 0.0), (-1.0, 1.0), (0.0, 1.0),
    (1.0, 1.0),
)  # fmt: skip
_ABOVE_PLANE = tuple((x, -y) for x, y in (_BELOW_PLANE[1:3] + _BELOW_PLANE[:1] + _BELOW_PLANE[3:]))
_BELOW_HANDLE = tuple((x, -y) for x, y in _ABOVE_PLANE)
GAPS_EM = (0.5, 1.6, 3.0, 5.0, 8.0, 12.0)  # between a label and its point, best first
_HIDES = (0.001, 0.01, 0.05, 0.1)  # steps of the part of the subject that a label hides
_LEADER_FROM_EM = 1.2  # beyond this distance a leader joins a label to its point
_OTHER_PLANE_EM = 2.0  # distance of a plane's label from the other plane's corners
_STAYS_WITHIN_EM = 3.0  # up to this distance a label stays on its side while something moves

_NOWHERE: Mapping[Any, Any] = MappingProxyType({})

Side: TypeAlias = tuple[float, int, tuple[float, float]]
"""Where a label could be: how far in em, from which of its points, on which side of it."""


class Named(NamedTuple):
    """What the words name; scene-local."""

    eye: Array
    target: Array
    arrows: tuple[str, ...]  # those at the camera whose names are written
    tips: Array  # (len(arrows) k, 3): places of these names, all of them k times, best first
    body: Array  # (n, 3): extent of the camera's body
    corners: Array | None  # (8, 3), of the frustum as drawn, near first
    planes: tuple[float, float] | None  # distances of near and far to be written
    without: frozenset[str] = frozenset()  # of eye, target, near and far: those without a name


class Labels:
    def __init__(self, canvas: Canvas, words: Mapping[str, str]) -> None:
        self._canvas, self._words = canvas, words
        style, label = canvas.style, canvas.label
        # The leaders before all labels, whose plates hide the ends.
        self._leaders = {name: Leader(canvas) for name in (*_THINGS, *AXES)}
        self._arrows = {a: label(words[a], colour=getattr(style, a)) for a in AXES}
        self._kept: Mapping[Label, Side] = {}
        things = {name: label(words[name], colour=getattr(style, name)) for name in _THINGS}
        self.named = {**self._arrows, **things}
        """The labels by the names of their subjects."""

    def add_arrow(self, name: str, colour: str) -> Label:
        """Create the label of one more arrow than `AXES`."""
        label = self._canvas.label(self._words[name], colour=colour)
        self._arrows[name] = label
        return label

    def dim_planes(self, light: float) -> None:
        for name in ("near", "far"):
            label = self.named[name]
            label.set_opacity(light)
            self._leaders[name].actor.GetProperty().SetOpacity(light)

    def lay_out(
        self,
        pane: PaneView,
        named: Named,
        *,
        afresh: bool,
        first: Callable[[Layout, Callable[[Array], Sequence[Spot]]], None] | None = None,
        subject: Mask | None = None,
        held_at: Mapping[str, tuple[float, float]] = _NOWHERE,
    ) -> bool:
        """Place every label; return whether one has changed sides.

        If not `afresh`, a label next to its point stays on its side as long as possible: jumping
        words distract from what moves. `first` places other labels before these, given the layout
        and `PaneView.seen`. `held_at` has the handles of near and far, from the pane's left and
        bottom. Where both planes are seen at one place, as from the eye, only they tell which label
        is whose.
        """
        words, leaders = self._words, self._leaders
        before = self._kept
        em = self._canvas.style.font_size
        layout = Layout(pane.size_px, em, {} if afresh else before, subject)
        layout.keep_title_free()
        for name, distance in zip(("near", "far"), named.planes or (None, None), strict=True):
            written = "" if distance is None else f" {written_distance(distance)}"
            self.named[name].set_text(words[name] + written)
        points = [[named.eye], [named.target], named.tips, named.body]
        corners = np.tile(named.eye, (8, 1)) if named.corners is None else named.corners
        seen = pane.seen(np.concatenate([*points, _PLANES_FROM_CORNERS @ corners]))
        eye, target, *spots = seen
        planes: tuple[Sequence[Spot], Sequence[Spot]] = (spots[-16:-8], spots[-8:])
        if held_at.keys() >= {"near", "far"} and self._are_one(planes):
            planes = [(*held_at["near"], 1.0)], [(*held_at["far"], 1.0)]
        layout.keep_free([eye, target])
        if first is not None:
            first(layout, pane.seen)
        count, step = len(named.tips), len(named.arrows)
        crowded = []
        for name, label in self._arrows.items():
            if name in leaders:
                leaders[name].set_visible(False)
            if name in named.arrows:
                i = named.arrows.index(name)
                gaps = 1 if name in AXES else 3  # up can be anywhere, even on the view direction
                by_the_arrow = partial(layout.place, label, spots[i:count:step], _ON, at_worst=0.0)
                if not by_the_arrow(gaps=gaps) and name in leaders:
                    crowded.append(partial(by_the_arrow, leader=leaders[name]))
            else:
                label.set_visible(False)
        at_target, at_eye = (
            [] if name in named.without else [spot]
            for name, spot in (("target", target), ("eye", eye))
        )
        layout.place(self.named["target"], at_target, _RIGHT_BELOW, leaders["target"])
        if named.arrows:
            layout.keep_free_box(spots[len(named.tips) : -16])
        layout.place(self.named["eye"], at_eye, _BELOW, leaders["eye"])
        for i, (name, sides) in enumerate((("near", _BELOW_PLANE), ("far", _ABOVE_PLANE))):
            label, leader = self.named[name], leaders[name]
            others = planes[1 - i][:4]
            if len(planes[i]) == 1:  # outwards from its handle
                sides = _ABOVE_PLANE if planes[i][0][1] >= planes[1 - i][0][1] else _BELOW_HANDLE
            if named.corners is None or name in named.without:
                layout.place(label, [], sides, leader)  # nowhere
                continue
            beside = partial(layout.place, label, planes[i], sides, leader, apart_from=others)
            if not beside(at_worst=LEADER):
                inside = pane.covered(corners[4 * i : 4 * i + 4])[:: 1 - 2 * i]
                on_it = partial(layout.place, label, inside, _ON[:1], gaps=1, apart_from=others)
                if not on_it(at_worst=0.0) and not beside():
                    on_it()
        for by_the_arrow in crowded:  # last: they take no other label's place
            by_the_arrow(gaps=3)
        self._kept = layout.settled
        return self._kept != before

    def _are_one(self, planes: tuple[Sequence[Spot], Sequence[Spot]]) -> bool:
        least = _OTHER_PLANE_EM * self._canvas.style.font_size
        near, far = ([spot[:2] for spot in spots] for spots in planes)
        return all(min(math.dist(one, other) for other in far) < least for one in near)


class Layout:
    """Finds free places for the labels of a pane, one after the other.

    `em` is the height of the labels' font in pixels. Labels stay at their `kept` sides if possible,
    and do not hide the `subject` while there is a place beside it.
    """

    def __init__(
        self,
        size_px: tuple[int, int],
        em: float,
        kept: Mapping[Label, Side] = _NOWHERE,
        subject: Mask | None = None,
    ) -> None:
        self._size_px, self.em, self._kept = size_px, em, kept
        ink = None if subject is None else subject.meets
        self._placer = Placer(Box(0.0, 0.0, *map(float, size_px)), ink)
        self._discs: list[Box] = []
        self.settled: dict[Label, Side] = {}
        """The labels right next to their points, and on which side."""

    @property
    def so_far(self) -> tuple[int, int, dict[Label, Side]]:
        return len(self._placer.taken), len(self._placer.bodies), self.settled.copy()

    def go_back(self, so_far: tuple[int, int, dict[Label, Side]]) -> None:
        taken, bodies, self.settled = so_far
        del self._placer.taken[taken:], self._placer.bodies[bodies:]

    def shows(self, x: float, y: float) -> bool:
        width_px, height_px = self._size_px
        return 0.0 <= x <= width_px and 0.0 <= y <= height_px

    def keep_title_free(self) -> None:
        """Keep labels from the title, at the top of the pane."""
        width_px, height_px = self._size_px
        self._placer.taken.append(Box(0.0, height_px - TITLE_EM * self.em, width_px, height_px))

    def keep_free(self, points: Sequence[Spot]) -> None:
        """Keep labels from what is drawn at these points."""
        half = 0.4 * self.em
        discs = [Box(x - half, y - half, x + half, y + half) for x, y, _ in points]
        self._discs += discs
        self._placer.taken += discs

    def keep_free_box(self, points: Sequence[Spot]) -> None:
        """Keep labels from what is drawn between these points."""
        x, y, depth = zip(*points, strict=True)
        if min(depth) > 0.0:
            self._placer.bodies.append(Box(min(x), min(y), max(x), max(y)))
            self._placer.taken.append(self._placer.bodies[-1])

    def place(
        self,
        label: Label,
        points: Sequence[Spot],
        sides: Sequence[tuple[float, float]],
        leader: Leader | None = None,
        *,
        gaps: int = len(GAPS_EM),
        apart_from: Sequence[Spot] = (),
        best: Sequence[int] = (),
        at_worst: float = INK,
    ) -> bool:
        """Put a label as near as possible to one of these points; hide it if there is no place.

        Returns whether there was one.

        Parameters
        ----------
        label : Label
            Anchored at its centre, in pixels.
        points : sequence of Spot
            Best first; those outside the pane do not count.
        sides : sequence of (float, float)
            Where the label's box is from the point, best first: -1 to the left or below, 1 to the
            right or above, 0 on it.
        gaps : int
            How many of `GAPS_EM` to try.
        apart_from : sequence of Spot
            Points that the label must not seem to belong to.
        best : sequence of int, optional
            From `least_hiding`: another order of the places beside a single point.
        at_worst : float
            The largest cost that is accepted.
        """
        half_width, half_height = self.half(label)
        em, has_leader = self.em, leader is not None
        usable = [
            i
            for i, (x, y, depth) in enumerate(points)
            # A leader must not point out of the pane.
            if depth > 0.0 and (not has_leader or self.shows(x, y))
        ]

        def candidate(side: Side) -> Candidate:
            gap, i, (to_right, to_top) = side
            x, y, _ = points[i]
            middle_x = x + to_right * (half_width + gap * em)
            middle_y = y + to_top * (half_height + gap * em)
            left, right = middle_x - half_width, middle_x + half_width
            box = Box(left, middle_y - half_height, right, middle_y + half_height)
            anchor = (x, y) if has_leader and gap > _LEADER_FROM_EM else None
            return Candidate(box, anchor, key=side)

        others = [(x, y) for x, y, depth in apart_from if depth > 0.0]
        apart_px, search = _OTHER_PLANE_EM * em, self._placer.place
        kept, found = self._kept.get(label), None
        if kept is not None and has_leader and kept[1] in usable:
            found = search([candidate(kept)], others, apart_px, min(LEADER, at_worst))
        if found is None:
            ordered: Iterable[Side] = product(GAPS_EM[:gaps], usable, sides)
            if best and usable:
                places = list(ordered)
                ordered = [places[i] for i in best]
            found = search(map(candidate, ordered), others, apart_px, at_worst)
        label.set_visible(found is not None)
        if found is None:
            if leader is not None:
                leader.set_visible(False)
            return False
        side: Side = found.key
        if leader is not None:
            if found.cost < INK and side[0] <= _STAYS_WITHIN_EM:
                self.settled[label] = side
            self._join(leader, points[side[1]][:2], found.box)
        label.set_position(*found.box.middle)
        return True

    def least_hiding(
        self,
        label: Label,
        point: Spot,
        sides: Sequence[tuple[float, float]],
        gaps: int,
        subject: Array,
    ) -> list[int]:
        """Order the places beside a point by how much of a subject they hide, for `place`.

        `subject`, (n, 2), are pixels all over what should stay visible; the rest is as in `place`.
        """
        if not len(subject):
            return []
        half = np.array(self.half(label))
        away = half + self.em * np.repeat(GAPS_EM[:gaps], len(sides))[:, None]
        centres = point[:2] + away * np.tile(sides, (gaps, 1))
        hidden = (np.abs(subject - centres[:, None]) < half).all(axis=2).mean(axis=1)
        order: list[int] = np.argsort(np.digitize(hidden, _HIDES), kind="stable").tolist()
        return order

    def half(self, label: Label) -> tuple[float, float]:
        """Half the width and height of a label's letters with their halo."""
        width, height = label.size_px
        rim = HALO_EM * self.em
        return width / 2.0 + rim, height / 2.0 + rim

    def _join(self, leader: Leader, anchor: tuple[float, float], box: Box) -> None:
        """Draw the leader if the label is far away, up to its plate, which is a little smaller."""
        end = box.nearest(anchor)
        apart = math.dist(end, anchor) > _LEADER_FROM_EM * self.em
        leader.set_visible(apart)
        if apart:
            x, y = box.middle
            plate = Box(*(c + 0.7 * (side - c) for c, side in zip((x, y, x, y), box, strict=True)))
            end = plate.nearest(end)
            leader.join(self._rim(anchor, end), end)

    def _rim(self, anchor: tuple[float, float], end: tuple[float, float]) -> tuple[float, float]:
        """Where a leader leaves the disc at its anchor, which it must not strike out."""
        (x, y), (end_x, end_y) = anchor, end
        length = max(abs(end_x - x), abs(end_y - y))
        for left, low, right, high in self._discs:
            if left <= x <= right and low <= y <= high and length > 0.0:
                part = min(1.0, 0.5 * (right - left) / length)
                return x + part * (end_x - x), y + part * (end_y - y)
        return anchor


class Leader:
    """A thin grey line in the plane of the screen, from a label to its point; hidden at first."""

    def __init__(self, canvas: Canvas, renderer: Any = None) -> None:
        self._line, self._canvas = ScreenCells(1, 2), weakref.proxy(canvas)
        self.actor = self._line.actor
        self.actor.GetProperty().SetColor(*rgb(canvas.style.leader))
        self.actor.GetProperty().SetLineWidth(canvas.style.line_width / 2.0)
        canvas.add(self.actor, renderer=renderer, layer="labels")
        self.set_visible(False)

    def set_visible(self, visible: bool) -> None:
        self._canvas.set_visible(self.actor, visible)

    def join(self, start_px: tuple[float, float], end_px: tuple[float, float]) -> None:
        """Draw it between two pixels, counted from the left and from the bottom."""
        self._line.px[0, :, :2] = start_px, end_px
        self._line.changed()


def written_distance(value: float) -> str:
    """Write a distance as a label does: 1, 0.025, −10, 1e+06, the sign for infinity."""
    if math.isinf(value):
        return "\N{INFINITY}"
    text = f"{value:.0f}" if 1e4 <= abs(value) < 1e6 else f"{value:.4g}"
    return text.replace("-", "\N{MINUS SIGN}")
