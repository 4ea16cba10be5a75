"""The words of the world pane: where there is room for them, and lines to what they name.

`Labels` owns every label of the pane. One `lay_out` finds a place for each, one after the other,
best first: where it is in the pane, hides nothing that must be seen, and does not seem to belong
to something else.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import islice
from typing import Any, NamedTuple

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor2D, vtkPolyDataMapper2D

from app.drawings.actors import Canvas, Label
from app.drawings.style import rgb
from app.projection import Array

AXES = ("v", "n", "u")
"""The camera's axes, in the order in which they are written."""

# Where the planes' labels can be, best first: of a face's corners and then its edges' middles.
_NEAR_LABEL_AT = (0, 3, 1, 2, 4, 7, 6, 5)
_FAR_LABEL_AT = (3, 2, 0, 1, 6, 7, 5, 4)

# Where in the pane a plane is looked for, from -1 to 1; what is near the bottom left first.
_SAMPLES = np.array([(x, y) for y in range(-4, 5) for x in range(-4, 5)]) * (2.0 / 9.0)
_ONES = np.ones(len(_SAMPLES))
_YZX, _ZXY = [1, 2, 0], [2, 0, 1]

# On which sides of their points labels can be, best first: right and up, in half labels.
_ON = ((0.0, 0.0), (0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0))
_BELOW = ((0.3, -1.0), (1.0, -1.0), (-1.0, -1.0), (0.0, 1.0), (1.0, 1.0), (-1.0, 1.0))
_RIGHT_BELOW = ((1.0, -0.6), (-1.0, -0.6), (0.0, -1.0), (0.0, 1.0), (1.0, 1.0), (-1.0, 1.0))
_BELOW_PLANE = (
    (-1.0, -1.0), (0.0, -1.0), (1.0, -1.0), (-1.0, 0.0), (1.0, 0.0), (-1.0, 1.0), (0.0, 1.0),
    (1.0, 1.0),
)  # fmt: skip
_ABOVE_PLANE = tuple((x, -y) for x, y in (_BELOW_PLANE[1:3] + _BELOW_PLANE[:1] + _BELOW_PLANE[3:]))
_GAPS_EM = (0.5, 1.6, 3.0, 5.0, 8.0, 12.0)  # between a label and its point, best first
_LEADER_FROM_EM = 1.2  # a label as far from its point is joined to it by a line
_OTHER_PLANE_EM = 2.0  # as far is each plane's label from the other one's corners


class PaneView(NamedTuple):
    """The pane's own camera.

    Attributes
    ----------
    eye : (3,) array
        Scene-local.
    axes : (3, 3) array
        Rows: right, up and toward what it looks at.
    slope : float
        Tangent of half the vertical angle of view.
    """

    eye: Array
    axes: Array
    slope: float


class Named(NamedTuple):
    """What the words name, scene-local.

    Attributes
    ----------
    eye, target : (3,) array
    tips : (3 k, 3) array
        Where the letters of `AXES` can be, all three of them k times, best first.
    body : (n, 3) array
        What the camera's body lies between; the planes' labels keep off it.
    corners : (8, 3) array
        Of the frustum as it is drawn: left-bottom, right-bottom, right-top, left-top of the near
        face, then of the far face.
    near, far : float
        The planes' distances, to be written.
    """

    eye: Array
    target: Array
    tips: Array
    body: Array
    corners: Array
    near: float
    far: float


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
        style, label = canvas.style, canvas.label
        # The leaders before all labels, whose plates hide the ends.
        self._leaders = {
            name: _Leader(getattr(style, name), style.line_width)
            for name in ("eye", "target", "near", "far")
        }
        canvas.add(*(leader.actor for leader in self._leaders.values()))
        self._axes = [label(words[a], plate=getattr(style, a), bold=True) for a in AXES]
        self._eye = label(words["eye"], plate=style.eye)
        self._target = label(words["target"], plate=style.target)
        self._near = label("", plate=style.near)
        self._far = label("", plate=style.far)

    def lay_out(self, pane: PaneView, named: Named) -> tuple[float, float]:
        """Put each label where it hides no other one, at its first place if that is free.

        Parameters
        ----------
        pane : PaneView
        named : Named

        Returns
        -------
        near, far : float
            How much of the pane each plane covers, 0..1.
        """
        words, leaders, layout = self._words, self._leaders, _Layout(self._canvas, pane)
        near, far = (f"{words[name]} {_distance(getattr(named, name))}" for name in ("near", "far"))
        self._near.set_text(near)
        self._far.set_text(far)
        faces = named.corners[:4], named.corners[4:]
        (eye, target, *axes), body, *planes = layout.seen(
            np.vstack([named.eye, named.target, named.tips]),
            named.body,
            *(np.vstack([f, (f + np.roll(f, -1, axis=0)) / 2.0]) for f in faces),
        )
        layout.keep_free([eye, target])
        for i, (name, label) in enumerate(zip(AXES, self._axes, strict=True)):
            layout.place(label, words[name], axes[i::3], _ON, gaps=1)
        layout.place(
            self._target, words["target"], [target], _RIGHT_BELOW, leaders["target"], gaps=3
        )
        layout.place(self._eye, words["eye"], [eye], _BELOW, leaders["eye"], gaps=3)
        layout.keep_free_box(body)
        on_near, on_far = (layout.covered(face) for face in faces)
        near_seen = [planes[0][i] for i in _NEAR_LABEL_AT]
        far_seen = [planes[1][i] for i in _FAR_LABEL_AT]
        for label, text, seen, sides, leader, others, inside in (
            (self._near, near, near_seen, _BELOW_PLANE, leaders["near"], far_seen, on_near),
            (self._far, far, far_seen, _ABOVE_PLANE, leaders["far"], near_seen, on_far[::-1]),
        ):
            others = others[:4]
            if not layout.place(label, text, seen, sides, leader, apart_from=others):
                layout.place(label, text, inside, _ON[:1], gaps=1, apart_from=others)
        return len(on_near) / len(_SAMPLES), len(on_far) / len(_SAMPLES)


class _Layout:
    """Finds free places for labels in the pane, one after the other."""

    def __init__(self, canvas: Canvas, pane: PaneView) -> None:
        width_px, height_px = canvas.window.GetSize()
        self._size_px = max(1, width_px), max(1, height_px)
        self._em = canvas.style.font_size
        self._pane = pane
        self._taken: list[tuple[float, float, float, float]] = []

    def seen(self, *groups: Array) -> list[list[tuple[float, float, float]]]:
        """Pixels from the left and from the bottom, and depth, of local points, groups (n, 3)."""
        width_px, height_px = self._size_px
        x, y, depth = self._pane.axes @ (np.concatenate(groups) - self._pane.eye).T
        in_front = np.where(depth > 0.0, depth, np.inf)
        px = height_px / (2.0 * self._pane.slope * in_front)
        seen = np.stack([width_px / 2.0 + px * x, height_px / 2.0 + px * y, depth], axis=1)
        found, rows = [], iter(map(tuple, seen.tolist()))
        for group in groups:
            found.append(list(islice(rows, len(group))))
        return found

    def covered(self, face: Array) -> list[tuple[float, float, float]]:
        """At which of `_SAMPLES` a parallelogram, (4, 3), is in front of the pane, as `seen`."""
        middle = (face[0] + face[2]) / 2.0 - self._pane.eye
        across, up = (face[1] - face[0]) / 2.0, (face[3] - face[0]) / 2.0
        width_px, height_px = self._size_px
        slope = self._pane.slope
        rays = np.column_stack([_SAMPLES * (slope * width_px / height_px, slope), _ONES])
        # Cramer's rule for depth * ray = middle + s across + t up.
        spanned = np.stack([middle, across, up]) @ self._pane.axes.T
        # Row i is the cross product of the other two; much faster than numpy's own of one pair.
        after, before = spanned[_YZX], spanned[_ZXY]
        adjugate = after[:, _YZX] * before[:, _ZXY] - after[:, _ZXY] * before[:, _YZX]
        volume = float(spanned[0] @ adjugate[0])
        facing, s, t = adjugate @ rays.T
        largest = np.abs(facing)
        on = (facing * volume > 0.0) & (np.abs(s) <= largest) & (np.abs(t) <= largest)
        px = (_SAMPLES[on] + 1.0) / 2.0 * self._size_px
        return list(map(tuple, np.column_stack([px, volume / facing[on]]).tolist()))

    def keep_free(self, points: Sequence[tuple[float, float, float]]) -> None:
        """Let no label hide what is drawn at these `seen` points."""
        half = 0.4 * self._em
        self._taken += [(x - half, y - half, x + half, y + half) for x, y, _ in points]

    def keep_free_box(self, points: Sequence[tuple[float, float, float]]) -> None:
        """Let no label hide what is drawn between these `seen` points."""
        x, y, depth = zip(*points, strict=True)
        if min(depth) > 0.0:
            self._taken.append((min(x), min(y), max(x), max(y)))

    def place(
        self,
        label: Label,
        text: str,
        points: Sequence[tuple[float, float, float]],
        sides: Sequence[tuple[float, float]],
        leader: _Leader | None = None,
        *,
        gaps: int = len(_GAPS_EM),
        apart_from: Sequence[tuple[float, float, float]] = (),
    ) -> bool:
        """Put a label as near as can be to one of these points, where it hides no other one.

        Parameters
        ----------
        label : Label
            Anchored at its centre. Hidden if none of the points is in the pane.
        text : str
            What is written on it.
        points : sequence of (float, float, float)
            As `seen`, best first.
        sides : sequence of (float, float)
            Where the label's box is from the point, best first: -1 to the left of or below, 1 to
            the right of or above, 0 on it.
        leader : _Leader, optional
            Joins the label to its point if they are far apart.
        gaps : int
            How many of `_GAPS_EM` to try.
        apart_from : sequence of (float, float, float)
            What the label must not seem to belong to, as `seen`.

        Returns
        -------
        bool
            Whether there was a place for it.
        """
        em = self._em
        half = em * np.array([0.26 * (len(text) + 2) + 0.15, 0.72])  # as DejaVu Sans is wide
        at = np.array([p for p in points if p[2] > 0.0], dtype=np.float64).reshape(-1, 3)
        if leader is not None:  # which must not point out of the pane
            at = at[((at[:, :2] >= 0.0) & (at[:, :2] <= self._size_px)).all(axis=1)]
        taken = np.array(self._taken).reshape(-1, 4)
        others = np.array([p[:2] for p in apart_from if p[2] > 0.0]).reshape(-1, 2)
        second_best: tuple[Array, Array] | None = None
        for gap in _GAPS_EM[:gaps] if len(at) else ():
            centres = (at[:, None, :2] + np.array(sides) * (half + gap * em)).reshape(-1, 2)
            anchors = np.repeat(at, len(sides), axis=0)
            low, high = centres - half, centres + half
            possible: Any = ((low >= 0.0) & (high <= self._size_px)).all(axis=1)
            if len(others):
                nearest = np.clip(others, low[:, None], high[:, None]) - others
                apart = np.hypot(nearest[..., 0], nearest[..., 1]).min(axis=1)
                possible &= apart >= _OTHER_PLANE_EM * em
            hidden = (low[:, None] < taken[:, 2:]) & (high[:, None] > taken[:, :2])
            free: Any = possible & ~np.logical_or.reduce(hidden.all(axis=2), axis=1)
            if leader is not None and gap > _LEADER_FROM_EM:  # it must not seem another's
                starts = anchors[:, :2]
                ends = np.clip(starts, low, high)
                on = (starts + np.array([[[0.4]], [[0.7]]]) * (ends - starts))[:, :, None]
                crossing = ((on > taken[:, :2]) & (on < taken[:, 2:])).all(axis=3)
                free &= ~np.logical_or.reduce(crossing, axis=(0, 2))
            best = int(free.argmax())
            if free[best]:
                self._taken.append((*low[best].tolist(), *high[best].tolist()))
                self._put(label, leader, anchors[best], centres[best], half)
                return True
            first = int(possible.argmax())
            if second_best is None and possible[first]:
                second_best = anchors[first], centres[first]
        if second_best is not None:
            self._put(label, leader, *second_best, half)
            return True
        label.set_visible(False)
        if leader is not None:
            leader.actor.SetVisibility(False)
        return False

    def _put(
        self, label: Label, leader: _Leader | None, anchor: Array, centre: Array, half: Array
    ) -> None:
        (width_px, height_px), depth = self._size_px, float(anchor[2])
        unit = 2.0 * self._pane.slope * depth / height_px
        across, up = (centre - (width_px / 2.0, height_px / 2.0)) * unit
        label.set_position(self._pane.eye + np.array([across, up, depth]) @ self._pane.axes)
        label.set_visible(True)
        if leader is not None:
            end = np.clip(anchor[:2], centre - half, centre + half)
            apart = math.dist(end, anchor[:2]) > _LEADER_FROM_EM * self._em
            leader.actor.SetVisibility(apart)
            if apart:  # the plate is a little smaller than the box that is kept free for it
                leader.join(anchor, np.clip(end, centre - 0.7 * half, centre + 0.7 * half))


class _Leader:
    """A thin line in the plane of the screen, from a label to what it names.

    Parameters
    ----------
    colour : str
        Of the label's plate.
    width : float
        Pixels.
    """

    def __init__(self, colour: str, width: float) -> None:
        self._points = vtkPoints()
        self._points.SetNumberOfPoints(2)
        cells = vtkCellArray()
        cells.InsertNextCell(2, (0, 1))
        line = vtkPolyData()
        line.SetPoints(self._points)
        line.SetLines(cells)
        mapper = vtkPolyDataMapper2D()
        mapper.SetInputData(line)
        self.actor = vtkActor2D()
        self.actor.SetMapper(mapper)
        self.actor.GetProperty().SetColor(*rgb(colour))
        self.actor.GetProperty().SetLineWidth(width)
        self.actor.SetVisibility(False)

    def join(self, start_px: Array, end_px: Array) -> None:
        """Draw it between two pixels, counted from the left and from the bottom."""
        for i, (x, y) in enumerate((start_px[:2], end_px[:2])):
            self._points.SetPoint(i, x, y, 0.0)
        self._points.Modified()


def _distance(value: float) -> str:
    """A distance as a label says it: 1, 0.025, 1e+06, the sign for infinity."""
    if math.isinf(value):
        return "\N{INFINITY}"
    return f"{value:.0f}" if 1e4 <= abs(value) < 1e6 else f"{value:.4g}"
