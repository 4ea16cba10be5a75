"""The words of the world pane: where there is room for them, and lines to what they name.

`Labels` owns every label of the pane. One `lay_out` finds a place for each, one after the other,
best first: where it is in the pane, hides nothing that must be seen, and does not seem to belong
to something else.
"""

from __future__ import annotations

import math
import weakref
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from itertools import product
from types import MappingProxyType
from typing import Any, NamedTuple, Protocol, TypeAlias

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from app.drawings.actors import Canvas, Label, actor_2d
from app.drawings.style import TITLE_EM, rgb
from app.model.projection import Array

AXES = ("v", "n", "u")
"""The camera's axes, in the order in which they are written."""

# Where the planes' labels can be, best first, as parts of the corners that `Named` has: corners,
# then middles of edges; of the near face, then of the far one.
_CORNERS = np.eye(4)
_EDGES = (_CORNERS + np.roll(_CORNERS, -1, axis=0)) / 2.0
_PLANES_FROM_CORNERS = np.kron(np.eye(2), np.vstack([_CORNERS, _EDGES]))[
    [0, 3, 1, 2, 4, 7, 6, 5, *(8 + i for i in (3, 2, 0, 1, 6, 7, 5, 4))]
]

# Where in the pane a plane is looked for, from -1 to 1; what is near the bottom left first.
_ACROSS = 9
_SAMPLES = np.array([(x, y) for y in range(-4, 5) for x in range(-4, 5)]) * (2.0 / _ACROSS)
_ONES = np.ones(len(_SAMPLES))
_YZX, _ZXY = [1, 2, 0], [2, 0, 1]

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
_HIDES = (0.001, 0.01, 0.05, 0.1)  # parts of the subject that a label may hide, rather than more
FREE, CROSSING, ON_SUBJECT = range(3)
"""What a place is like: it hides nothing; a leader runs under a label; part of the subject goes."""
_LEADER_FROM_EM = 1.2  # a label as far from its point is joined to it by a line
_OTHER_PLANE_EM = 2.0  # as far is each plane's label from the other one's corners
_STAYS_WITHIN_EM = 3.0  # a label as near to its point stays where it is while something moves

_NOWHERE: Mapping[str, tuple[float, float]] = MappingProxyType({})

Spot: TypeAlias = tuple[float, float, float]
"""Pixels from the pane's left and bottom, and depth: negative behind the pane's camera."""
_Candidate: TypeAlias = tuple[float, int, tuple[float, float]]
"""Where a label could be: how far in em, from which of its points, on which side of it."""


class PaneView(NamedTuple):
    """The pane's own camera and size.

    Attributes
    ----------
    eye : (3,) array
        Scene-local.
    axes : (3, 3) array
        Rows: right, up and toward what it looks at.
    slope : float
        Tangent of half the vertical angle of view; 0 of a parallel camera.
    size_px : (int, int)
    flat : float
        Half the height that a parallel camera sees, world units; 0 of one with an eye.
    """

    eye: Array
    axes: Array
    slope: float
    size_px: tuple[int, int]
    flat: float = 0.0

    def unit(self, depth: Any) -> Any:
        """The world's size of a pixel at a depth, a float or an array."""
        return 2.0 * (self.slope * depth + self.flat) / self.size_px[1]

    def brought(self, point: Array, to_depth: float) -> tuple[float, Array]:
        """Where a point comes that is brought before others without leaving its pixel.

        Returns
        -------
        scale : float
            By which what is there must shrink to look as large.
        point : (3,) array
            The same one, if it is as near already.
        """
        depth = float(self.axes[2] @ (point - self.eye))
        if depth <= to_depth:
            return 1.0, point
        if self.flat:
            return 1.0, point - (depth - to_depth) * self.axes[2]
        scale = to_depth / depth
        return scale, (1.0 - scale) * self.eye + scale * point

    def seen(self, points: Array) -> list[Spot]:
        """Where scene-local points, (n, 3), are in the pane."""
        width_px, height_px = self.size_px
        x, y, depth = self.axes @ (points - self.eye).T
        in_view = (depth > 0.0) | (self.flat > 0.0)  # parallel rays come from anywhere
        px = 1.0 / np.where(in_view, self.unit(depth), np.inf)
        spots = zip(
            (width_px / 2.0 + px * x).tolist(),
            (height_px / 2.0 + px * y).tolist(),
            depth.tolist(),
            strict=True,
        )
        return list(spots)

    def covered(self, face: Array) -> list[Spot]:
        """At which of evenly spread places a parallelogram, (4, 3), is in front of the pane."""
        middle = (face[0] + face[2]) / 2.0 - self.eye
        across, up = (face[1] - face[0]) / 2.0, (face[3] - face[0]) / 2.0
        width_px, height_px = self.size_px
        rays = np.column_stack([_SAMPLES * (self.slope * width_px / height_px, self.slope), _ONES])
        # Cramer's rule for depth * ray = middle + s across + t up.
        spanned = np.stack([middle, across, up]) @ self.axes.T
        if self.flat:
            return self._covered_flat(spanned)
        scale = float(np.abs(spanned).max()) or 1.0  # a volume from afar would be beyond float64
        spanned /= scale
        # Row i is the cross product of the other two; much faster than numpy's own of one pair.
        after, before = spanned[_YZX], spanned[_ZXY]
        adjugate = after[:, _YZX] * before[:, _ZXY] - after[:, _ZXY] * before[:, _YZX]
        volume = float(spanned[0] @ adjugate[0])
        facing, s, t = adjugate @ rays.T
        largest = np.abs(facing)
        on = (facing * volume > 0.0) & (np.abs(s) <= largest) & (np.abs(t) <= largest)
        px = (_SAMPLES[on] + 1.0) / 2.0 * self.size_px
        return list(map(tuple, np.column_stack([px, scale * volume / facing[on]]).tolist()))

    def _covered_flat(self, spanned: Array) -> list[Spot]:
        """`covered` of a parallel camera, by the middle and both halves in its own axes."""
        middle, across, up = spanned
        area = across[0] * up[1] - across[1] * up[0]
        if abs(area) <= 1e-12 * float(np.abs(spanned[1:]).max()) ** 2:
            return []  # seen edge on
        width_px, height_px = self.size_px
        x, y = (_SAMPLES * (self.flat * width_px / height_px, self.flat) - middle[:2]).T
        s, t = (x * up[1] - y * up[0]) / area, (across[0] * y - across[1] * x) / area
        depth = middle[2] + s * across[2] + t * up[2]
        on = (np.abs(s) <= 1.0) & (np.abs(t) <= 1.0) & (depth > 0.0)
        px = (_SAMPLES[on] + 1.0) / 2.0 * self.size_px
        return list(map(tuple, np.column_stack([px, depth[on]]).tolist()))

    def parts_covered(self, faces: Array, least: float) -> list[float]:
        """How much of the pane parallelograms cover, 0..1 each; 0 where less than `least`.

        Parameters
        ----------
        faces : (4 n, 3) array
        least : float
            What matters to the caller: below it most faces are told at a glance.
        """
        parts, seen = [], self.seen(faces)
        for first in range(0, len(faces), 4):
            x, y, depth = zip(*seen[first : first + 4], strict=True)
            sides = zip((x, y), self.size_px, strict=True)
            # One sample more than fits, at most, in either direction.
            most = math.prod((max(s) - min(s)) / side_px + 1.0 / _ACROSS for s, side_px in sides)
            part = 0.0
            if min(depth) <= 0.0 or most >= least:
                part = len(self.covered(faces[first : first + 4])) / len(_SAMPLES)
            parts.append(part if part >= least else 0.0)
        return parts


class Named(NamedTuple):
    """What the words name, scene-local.

    Attributes
    ----------
    eye, target : (3,) array
    arrows : tuple of str
        The arrows at the camera whose names are written; `AXES`, if nothing else is taught.
    tips : (len(arrows) k, 3) array
        Where they can be, all of them k times, best first.
    body : (n, 3) array
        What the camera's body lies between; the planes' labels keep off it.
    corners : (8, 3) array or None
        Of the frustum as it is drawn: left-bottom, right-bottom, right-top, left-top of the near
        face, then of the far face; None if there is none.
    planes : (float, float) or None
        Distances of near and far, to be written; None if they have none.
    without : frozenset of str
        ``"eye"`` and ``"target"``, if they are not to be named.
    """

    eye: Array
    target: Array
    arrows: tuple[str, ...]
    tips: Array
    body: Array
    corners: Array | None
    planes: tuple[float, float] | None
    without: frozenset[str] = frozenset()


class Labels:
    """Every label of the world pane.

    Parameters
    ----------
    canvas : Canvas
        Where they are added.
    words : Mapping[str, str]
        `app.drawings.WORDS` or a translation.
    """

    def __init__(self, canvas: Canvas, words: Mapping[str, str]) -> None:
        self._canvas, self._words = canvas, words
        style, label = canvas.style, partial(canvas.label, in_pixels=True)
        # The leaders before all labels, whose plates hide the ends.
        self._leaders = {
            name: Leader(canvas, getattr(style, name), style.line_width)
            for name in ("eye", "target", "near", "far", *AXES)
        }
        self._arrows = {a: label(words[a], plate=getattr(style, a), bold=True) for a in AXES}
        self._eye = label(words["eye"], plate=style.eye)
        self._target = label(words["target"], plate=style.target)
        self._near = label("", plate=style.near)
        self._far = label("", plate=style.far)
        self._kept: Mapping[Label, _Candidate] = {}
        self.named = {
            **self._arrows,
            "eye": self._eye, "target": self._target, "near": self._near, "far": self._far,
        }  # fmt: skip
        """Each label by the name of what it is about."""

    def add_arrow(self, name: str, colour: str) -> Label:
        """Make the label of one more arrow than `AXES`."""
        label = self._canvas.label(self._words[name], plate=colour, bold=True, in_pixels=True)
        self._arrows[name] = label
        return label

    def dim_planes(self, light: float) -> None:
        """Write near and far with this opacity."""
        for name, label in (("near", self._near), ("far", self._far)):
            label.property.SetOpacity(light)
            label.property.SetBackgroundOpacity(light)
            self._leaders[name].actor.GetProperty().SetOpacity(light)

    def lay_out(
        self,
        pane: PaneView,
        named: Named,
        *,
        afresh: bool,
        first: Callable[[Layout, Callable[[Array], Sequence[Spot]]], None] | None = None,
        subject: Subject | None = None,
        held_at: Mapping[str, tuple[float, float]] = _NOWHERE,
    ) -> bool:
        """Put each label where it hides no other one, at its first place if that is free.

        Parameters
        ----------
        pane : PaneView
        named : Named
        afresh : bool
            Whether the places depend on nothing but `pane` and `named`. If not, a label that is
            right next to one of its points stays on its side of it as long as it can: words that
            jump while a control is dragged draw the eye away from what moves.
        first : callable, optional
            Places other labels before these, given the layout and `PaneView.seen`.
        subject : Subject, optional
            What no label hides while there is a place beside it.
        held_at : mapping of str to (float, float), optional
            Where the handles of near and far are, from the pane's left and bottom. Where both
            planes are seen at one place, as from the eye, only that tells which label is whose.

        Returns
        -------
        bool
            Whether a label has changed sides.
        """
        words, leaders = self._words, self._leaders
        before = self._kept
        em = self._canvas.style.font_size
        layout = Layout(pane.size_px, em, {} if afresh else before, subject)
        layout.keep_title_free()
        texts = [words["near"], words["far"]]
        if named.planes is not None:
            texts = [f"{t} {written_distance(d)}" for t, d in zip(texts, named.planes, strict=True)]
        self._near.set_text(texts[0])
        self._far.set_text(texts[1])
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
                by_the_arrow = partial(
                    layout.place, label, words[name], spots[i:count:step], _ON, at_worst=FREE
                )
                if not by_the_arrow(gaps=gaps) and name in leaders:
                    crowded.append(partial(by_the_arrow, leader=leaders[name]))
            else:
                label.set_visible(False)
        at_target, at_eye = (
            [] if name in named.without else [spot]
            for name, spot in (("target", target), ("eye", eye))
        )
        layout.place(self._target, words["target"], at_target, _RIGHT_BELOW, leaders["target"])
        if named.arrows:
            layout.keep_free_box(spots[len(named.tips) : -16])
        layout.place(self._eye, words["eye"], at_eye, _BELOW, leaders["eye"])
        for i, (label, sides, leader) in enumerate(
            ((self._near, _BELOW_PLANE, leaders["near"]), (self._far, _ABOVE_PLANE, leaders["far"]))
        ):
            others = planes[1 - i][:4]
            if len(planes[i]) == 1:  # outwards from its handle
                sides = _ABOVE_PLANE if planes[i][0][1] >= planes[1 - i][0][1] else _BELOW_HANDLE
            if named.corners is None:
                layout.place(label, texts[i], [], sides, leader)  # nowhere
                continue
            beside = partial(layout.place, label, texts[i], planes[i], sides, leader,
                             apart_from=others)  # fmt: skip
            if not beside(at_worst=CROSSING):
                inside = pane.covered(corners[4 * i : 4 * i + 4])[:: 1 - 2 * i]
                on_it = partial(layout.place, label, texts[i], inside, _ON[:1], gaps=1,
                                apart_from=others)  # fmt: skip
                if not on_it(at_worst=FREE) and not beside():
                    on_it()
        for by_the_arrow in crowded:  # last: they take no other label's place
            by_the_arrow(gaps=3)
        self._kept = layout.settled
        return self._kept != before

    def _are_one(self, planes: tuple[Sequence[Spot], Sequence[Spot]]) -> bool:
        """Whether both planes' corners are seen at the same places."""
        least = _OTHER_PLANE_EM * self._canvas.style.font_size
        near, far = ([spot[:2] for spot in spots] for spots in planes)
        return all(min(math.dist(one, other) for other in far) < least for one in near)


class Subject(Protocol):
    """What a picture is of."""

    def meets(self, left: float, bottom: float, right: float, top: float) -> bool:
        """Whether anything of it is in a box, in pixels from the pane's left and bottom."""


class Layout:
    """Finds free places for labels in the pane, one after the other.

    In plain floats: a label that stays asks about one candidate, where numpy would do them all.

    Parameters
    ----------
    size_px : (int, int)
        Of the pane.
    em : float
        Height of the labels' font, pixels.
    kept : mapping of Label to _Candidate
        Where labels are to stay if they still can.
    subject : Subject, optional
        What no label hides while there is a place beside it.
    """

    def __init__(
        self,
        size_px: tuple[int, int],
        em: float,
        kept: Mapping[Label, _Candidate],
        subject: Subject | None = None,
    ) -> None:
        self._size_px, self.em, self._kept, self._subject = size_px, em, kept, subject
        self._taken: list[_Box] = []
        self._discs: list[_Box] = []
        self._bodies: list[_Box] = []
        self.settled: dict[Label, _Candidate] = {}
        """Which labels were put right next to their points, and where."""

    @property
    def so_far(self) -> tuple[int, int, dict[Label, _Candidate]]:
        """What is taken, for `go_back`."""
        return len(self._taken), len(self._bodies), self.settled.copy()

    def go_back(self, so_far: tuple[int, int, dict[Label, _Candidate]]) -> None:
        """Forget what was placed and kept free since then."""
        taken, bodies, self.settled = so_far
        del self._taken[taken:], self._bodies[bodies:]

    def shows(self, x: float, y: float) -> bool:
        """Whether a pixel is in the pane."""
        width_px, height_px = self._size_px
        return 0.0 <= x <= width_px and 0.0 <= y <= height_px

    def keep_title_free(self) -> None:
        """Let no label lie under the title of the pane, at its top."""
        width_px, height_px = self._size_px
        self._taken.append(_Box(0.0, height_px - TITLE_EM * self.em, width_px, height_px))

    def keep_free(self, points: Sequence[Spot]) -> None:
        """Let no label hide what is drawn at these points."""
        half = 0.4 * self.em
        self._discs += [_Box(x - half, y - half, x + half, y + half) for x, y, _ in points]
        self._taken += self._discs[-len(points) :]

    def keep_free_box(self, points: Sequence[Spot]) -> None:
        """Let no label hide what is drawn between these points."""
        x, y, depth = zip(*points, strict=True)
        if min(depth) > 0.0:
            self._bodies.append(_Box(min(x), min(y), max(x), max(y)))
            self._taken.append(self._bodies[-1])

    def place(
        self,
        label: Label,
        text: str,
        points: Sequence[Spot],
        sides: Sequence[tuple[float, float]],
        leader: Leader | None = None,
        *,
        gaps: int = len(GAPS_EM),
        apart_from: Sequence[Spot] = (),
        best: Sequence[int] = (),
        at_worst: int = ON_SUBJECT,
    ) -> bool:
        """Put a label as near as can be to one of these points, where it hides no other one.

        Parameters
        ----------
        label : Label
            Anchored at its centre, in pixels. Hidden if none of the points is in the pane, or
            there is no place where it hides no other label.
        text : str
            What is written on it.
        points : sequence of Spot
            Best first.
        sides : sequence of (float, float)
            Where the label's box is from the point, best first: -1 to the left of or below, 1 to
            the right of or above, 0 on it.
        leader : Leader, optional
            Joins the label to its point if they are far apart.
        gaps : int
            How many of `GAPS_EM` to try.
        apart_from : sequence of Spot
            What the label must not seem to belong to.
        best : sequence of int, optional
            As `least_hiding` gives it: another order of the places beside a single point.
        at_worst : int
            `FREE`, `CROSSING` or `ON_SUBJECT`: rather than put it on a worse place, hide it.

        Returns
        -------
        bool
            Whether there was a place for it.
        """
        half = self.half(text)
        usable = [
            i
            for i, (x, y, depth) in enumerate(points)
            # A leader must not point out of the pane.
            if depth > 0.0 and (leader is None or self.shows(x, y))
        ]
        others = [(x, y) for x, y, depth in apart_from if depth > 0.0]
        search = partial(self._search, points, half, others, leader is not None)
        kept, found = self._kept.get(label), None
        if kept is not None and leader is not None and kept[1] in usable:
            found = search([kept])
        if found is None or found[2] == ON_SUBJECT:
            places: Iterable[_Candidate] = product(GAPS_EM[:gaps], usable, sides)
            if best and usable:
                places = list(places)
                places = [places[i] for i in best]
            found = search(places)
        if found is None or found[2] > at_worst:
            label.set_visible(False)
            if leader is not None:
                leader.set_visible(False)
            return False
        candidate, box, place = found
        self._taken.append(box)
        if leader is not None and place != ON_SUBJECT and candidate[0] <= _STAYS_WITHIN_EM:
            self.settled[label] = candidate
        self._put(label, leader, points[candidate[1]][:2], box)
        return True

    def least_hiding(
        self,
        text: str,
        point: Spot,
        sides: Sequence[tuple[float, float]],
        gaps: int,
        subject: Array,
    ) -> list[int]:
        """The places beside a point, those first that hide nothing, or little, of something.

        Parameters
        ----------
        text, point, sides, gaps
            As for `place`.
        subject : (n, 2) array
            Pixels all over what is not to be hidden.

        Returns
        -------
        list of int
            For `place`.
        """
        if not len(subject):
            return []
        half = np.array(self.half(text))
        away = half + self.em * np.repeat(GAPS_EM[:gaps], len(sides))[:, None]
        centres = point[:2] + away * np.tile(sides, (gaps, 1))
        hidden = (np.abs(subject - centres[:, None]) < half).all(axis=2).mean(axis=1)
        order: list[int] = np.argsort(np.digitize(hidden, _HIDES), kind="stable").tolist()
        return order

    def half(self, text: str) -> tuple[float, float]:
        """Half the width and height of a label: as wide as DejaVu Sans, and a line high."""
        return self.em * (0.26 * (len(text) + 2) + 0.15), self.em * 0.72

    def _search(
        self,
        points: Sequence[Spot],
        half: tuple[float, float],
        others: Sequence[tuple[float, float]],
        has_leader: bool,
        candidates: Iterable[_Candidate],
    ) -> tuple[_Candidate, _Box, int] | None:
        """The first candidate that hides nothing, or else the best that hides no other label.

        One whose leader runs under another label, which hides nothing either, is better than one
        that hides something of the subject.

        Returns
        -------
        candidate : _Candidate
        box : _Box
            Where the label is then.
        place : int
            `FREE`, `CROSSING` or `ON_SUBJECT`.
        """
        em, (width_px, height_px), taken = self.em, self._size_px, self._taken
        hides = None if self._subject is None else self._subject.meets
        half_width, half_height = half
        least = _OTHER_PLANE_EM * em
        worse: dict[int, tuple[_Candidate, _Box]] = {}
        for candidate in candidates:
            gap, i, (to_right, to_top) = candidate
            x, y, _ = points[i]
            centre_x = x + to_right * (half_width + gap * em)
            centre_y = y + to_top * (half_height + gap * em)
            left, right = centre_x - half_width, centre_x + half_width
            bottom, top = centre_y - half_height, centre_y + half_height
            if left < 0.0 or bottom < 0.0 or right > width_px or top > height_px:
                continue
            for x, y in others:
                if not (left - x < least > x - right and bottom - y < least > y - top):
                    continue  # most are: nothing is called for them
                away_x, away_y = max(left - x, 0.0, x - right), max(bottom - y, 0.0, y - top)
                if math.hypot(away_x, away_y) < least:
                    break
            else:
                for t_left, t_bottom, t_right, t_top in taken:
                    if left < t_right and right > t_left and bottom < t_top and top > t_bottom:
                        break
                else:
                    box = _Box(left, bottom, right, top)
                    place = FREE
                    if hides is not None and hides(left, bottom, right, top):
                        place = ON_SUBJECT
                    elif has_leader and gap > _LEADER_FROM_EM and self._crosses(points[i], box):
                        place = CROSSING
                    if place == FREE:
                        return candidate, box, FREE
                    worse.setdefault(place, (candidate, box))
        for place in sorted(worse):
            return (*worse[place], place)
        return None

    def _crosses(self, anchor: Spot, box: _Box) -> bool:
        """Whether a line from a point to a label would seem to be another label's.

        It does not where it runs out of the body that the point itself is in: the eye's camera.
        """
        x, y, _ = anchor
        end_x, end_y = box.nearest((x, y))
        own = [body for body in self._bodies if body.left <= x <= body.right
               and body.bottom <= y <= body.top]  # fmt: skip
        for part in (0.4, 0.7):
            on_x, on_y = x + part * (end_x - x), y + part * (end_y - y)
            for taken in self._taken:
                left, bottom, right, top = taken
                if left < on_x < right and bottom < on_y < top and taken not in own:
                    return True
        return False

    def _put(
        self, label: Label, leader: Leader | None, anchor: tuple[float, float], box: _Box
    ) -> None:
        x, y = (box.left + box.right) / 2.0, (box.bottom + box.top) / 2.0
        label.set_position((x, y, 0.0))
        label.set_visible(True)
        if leader is not None:
            end = box.nearest(anchor)
            apart = math.dist(end, anchor) > _LEADER_FROM_EM * self.em
            leader.set_visible(apart)
            if apart:  # the plate is a little smaller than the box that is kept free for it
                plate = _Box(
                    *(c + 0.7 * (side - c) for c, side in zip((x, y, x, y), box, strict=True))
                )
                end = plate.nearest(end)
                leader.join(self._rim(anchor, end), end)

    def _rim(self, anchor: tuple[float, float], end: tuple[float, float]) -> tuple[float, float]:
        """Where a line from a point leaves what is drawn there, and must not be struck out."""
        (x, y), (end_x, end_y) = anchor, end
        length = max(abs(end_x - x), abs(end_y - y))
        for left, bottom, right, top in self._discs:
            if left <= x <= right and bottom <= y <= top and length > 0.0:
                part = min(1.0, 0.5 * (right - left) / length)
                return x + part * (end_x - x), y + part * (end_y - y)
        return anchor


class _Box(NamedTuple):
    """A rectangle in the pane, pixels from its left and bottom."""

    left: float
    bottom: float
    right: float
    top: float

    def nearest(self, spot: tuple[float, float]) -> tuple[float, float]:
        """The point of the box that is nearest to a spot."""
        x, y = spot
        return min(max(x, self.left), self.right), min(max(y, self.bottom), self.top)


class Leader:
    """A thin line in the plane of the screen, from a label to what it names; hidden at first.

    Parameters
    ----------
    canvas : Canvas
        Where it is added.
    colour : str
        Of the label's plate.
    width : float
        Pixels.
    renderer : vtkRenderer, optional
        Where to draw; the pane's own if not given.
    """

    def __init__(self, canvas: Canvas, colour: str, width: float, renderer: Any = None) -> None:
        self._points = vtkPoints()
        self._points.SetNumberOfPoints(2)
        cells = vtkCellArray()
        cells.InsertNextCell(2, (0, 1))
        line = vtkPolyData()
        line.SetPoints(self._points)
        line.SetLines(cells)
        self.actor = actor_2d(line)
        self.set_colour(colour)
        self.actor.GetProperty().SetLineWidth(width)
        canvas.add(self.actor, renderer=renderer, layer="labels")
        self._canvas = weakref.proxy(canvas)
        self.set_visible(False)

    def set_visible(self, visible: bool) -> None:
        """Show or hide."""
        self._canvas.set_visible(self.actor, visible)

    def set_colour(self, colour: str) -> None:
        """Draw it in another colour."""
        self.actor.GetProperty().SetColor(*rgb(colour))

    def join(self, start_px: tuple[float, float], end_px: tuple[float, float]) -> None:
        """Draw it between two pixels, counted from the left and from the bottom."""
        for i, (x, y) in enumerate((start_px, end_px)):
            self._points.SetPoint(i, x, y, 0.0)
        self._points.Modified()


def written_distance(value: float) -> str:
    """A distance as a label says it: 1, 0.025, −10, 1e+06, the sign for infinity."""
    if math.isinf(value):
        return "\N{INFINITY}"
    text = f"{value:.0f}" if 1e4 <= abs(value) < 1e6 else f"{value:.4g}"
    return text.replace("-", "\N{MINUS SIGN}")
