"""Lengths and angles in the world pane's flat views, as in a sketch on the blackboard.

Lines of the screen, in one array of pixels that a step writes, and a text for each::

            . ' | f tan(fov/2)
        . ' )   |
    eye ----+---+---
      near |----|
           d
       far

A lens may lack some of them, and a pane may have no room; a sentence at the bottom says so.
"""

from __future__ import annotations

import math
import textwrap
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from app.drawings.actors import Canvas, ScreenCells
from app.drawings.labels import Layout, Leader, written_distance
from app.drawings.names import Names
from app.drawings.pane_view import Spot
from app.drawings.style import rgb
from app.model.projection import Array, Projection

_SEGMENTS = 64  # capacity
_AWAY_PX = -1e4
_ARC = 12  # pieces of the angle's arc
_ARC_EM, _TICK_EM, _ROW_EM = 3.5, 0.35, 1.7
_ARC_PART = 0.3  # of the way to the far plane's edge: the arc is no larger
_ACROSS_EM = 2.2  # under the window seen along the axis
_MOST_BELOW = 0.4  # of the pane's height, for the rows and the sentence
_SAME = 1e-9  # of a window's side: an axis this near to its middle halves it
_ON = ((0.0, 0.0),)
_BELOW = tuple((x, -1.0) for x in (0.0, 0.5, -0.5, 1.0, -1.0))
_ABOVE = ((-1.0, 1.0), (0.0, 1.0), (-1.0, 0.6), (-1.0, -0.6))
_CORNERS = tuple((x, y) for y in (1.0, -1.0) for x in (-1.0, 1.0, -0.5, 0.5))
_RIGHT = ((1.0, 0.0), (1.0, -0.3), (1.0, 0.3), (0.0, 1.0), (0.0, -1.0), *_CORNERS)
_LEFT = ((-1.0, 0.0), (-1.0, 0.6), (-1.0, -0.6), (1.0, 0.0), (0.0, 1.0), (0.0, -1.0), *_CORNERS)
_NAMES = (
    *("near", "d", "s", "w", "z", "far", "angle", "height", "width"),
    *("x", "x_p", "y", "y_p"),
)

Way = tuple[float, float]


class Measured(NamedTuple):
    """What is measured; scene-local."""

    view: str  # one of `app.document.view.FIXED`; empty for nothing
    projection: Projection
    eye: Array
    target: Array
    corners: Array | None  # (8, 3), of the frustum as drawn
    objects: Array  # (8, 3), of the box round the objects
    distances: tuple[
        tuple[str, float], ...
    ]  # more lengths from the eye along the axis; d is the target's unless it is here
    lengths: tuple[
        tuple[str, float, Array, Array], ...
    ] = ()  # across the axis: letter, value, two ends
    names: Names = Names(None)  # what is measured: the lengths that it has


class Half(NamedTuple):
    """Half a window, from the axis to its top or its right."""

    angle_deg: float | None  # at the eye; None without an eye, or off the axis
    at_far: float  # its length on the far plane; infinite if far is
    has_eye: bool = True


def half_of(projection: Projection, axis: int) -> Half | None:
    """Return the right (axis 0) or upper (axis 1) half of a window; None for a typed matrix.

    Lecture 001: half the height on the far plane is ``f tan(fov/2)``.
    """
    lens = projection.lens
    if lens.planes is None:
        return None
    near, far = lens.planes
    low, high = projection.window[2 * axis : 2 * axis + 2]
    if not lens.central:
        return Half(None, high, has_eye=False)
    aspect = Fraction(*projection.image_size)
    angles = lens.angles(aspect) if lens.symmetric else None
    if angles is not None:
        angle_deg: float | None = angles[axis] / 2.0
        slope = math.tan(math.radians(angles[axis] / 2.0))
    else:
        slope = high / near
        halved = abs(low + high) <= _SAME * (high - low)
        angle_deg = math.degrees(math.atan(slope)) if halved else None
    return Half(angle_deg, far * slope)


class Dimensions:
    def __init__(self, canvas: Canvas, words: Mapping[str, str]) -> None:
        self._canvas, self._words = canvas, words
        self._em = canvas.style.font_size
        self._lines, self._used = ScreenCells(_SEGMENTS, 2), 0
        self._lines.px[..., :2] = _AWAY_PX
        actor = self._lines.actor
        actor.GetProperty().SetColor(*rgb(canvas.style.ink))
        actor.GetProperty().SetLineWidth(canvas.style.line_width / 2.0)
        canvas.add(actor, layer="labels")
        # Before the texts, whose plates hide the ends.
        self._leaders = {name: Leader(canvas) for name in ("angle", "height")}
        self._texts = {name: canvas.label("") for name in _NAMES}
        self._sentence = canvas.label("", anchor=(-1, -1))
        self.hide()

    def hide(self) -> None:
        self._sentence.set_visible(False)
        self._begin()
        self._lines.changed()

    def _begin(self) -> None:
        for label in self._texts.values():
            label.set_visible(False)
        for leader in self._leaders.values():
            leader.set_visible(False)
        self._lines.px[: self._used, :, :2] = _AWAY_PX
        self._used, self._is_left_out = 0, False

    def below_em(self, size_px: tuple[int, int], measured: Measured) -> float:
        """Return how much room the lines and the sentence need below the drawing, in ems."""
        rows_em = self._rows_em(size_px, measured)
        return (rows_em or 0.0) + self._said_em(self._said(size_px, measured, rows_em))

    def _rows_em(self, size_px: tuple[int, int], measured: Measured) -> float | None:
        """The height of the lines below the drawing; None if they would leave it too little."""
        if measured.view == "axis":
            rows_em = _ACROSS_EM if "width" in measured.names else 0.0
        elif measured.view in ("side", "top"):
            count = len(self._ways(measured))
            rows_em = _ROW_EM * (count + 0.5) if count else 0.0
        else:
            return 0.0
        below_em = rows_em + self._said_em(self._said(size_px, measured, rows_em))
        return rows_em if below_em * self._em <= _MOST_BELOW * size_px[1] else None

    def place(
        self,
        layout: Layout,
        seen: Callable[[Array], Sequence[Spot]],
        size_px: tuple[int, int],
        measured: Measured,
    ) -> None:
        """Show the dimensions, before other labels take their places; draw nothing yet.

        `seen` converts scene-local points, (n, 3), to the pane.
        """
        before = layout.so_far
        self._place(layout, seen, size_px, measured, self._rows_em(size_px, measured))
        if self._is_left_out:
            layout.go_back(before)
            self._place(layout, seen, size_px, measured, None)
        self._lines.changed()

    def _place(
        self,
        layout: Layout,
        seen: Callable[[Array], Sequence[Spot]],
        size_px: tuple[int, int],
        measured: Measured,
        rows_em: float | None,
    ) -> None:
        """`place` with the rows or, for None, without."""
        self._begin()
        self._say(layout, size_px, self._said(size_px, measured, rows_em))
        if measured.view != "eye":
            points = np.vstack([measured.objects, measured.eye, measured.target])
            corners = measured.corners if measured.projection.lens.planes is not None else None
            drawn = points if corners is None else np.vstack([points, corners])
            all_spots = np.array(seen(drawn))[:, :2]
            spots = all_spots[len(measured.objects) :]
            for name, length, start, end in measured.lengths:
                if name in measured.names:
                    self._length(layout, name, length, *seen(np.array([start, end])))
            if measured.view == "axis":
                if corners is not None and rows_em is not None:
                    self._across(layout, spots, measured)
            else:
                if rows_em is not None:
                    # Below everything that is drawn in the pane.
                    least = self.below_em(size_px, measured) * self._em
                    top = max(float(all_spots[:, 1].min()), least)
                    self._along(layout, spots, measured, size_px, top)
                if corners is not None:
                    self._beside(layout, spots, measured)

    # -- what is drawn

    def _along(
        self, layout: Layout, spots: Array, measured: Measured, size_px: tuple[int, int], y: float
    ) -> None:
        """From the eye to near, target and far, one below the other, the shortest on top."""
        eye, target = spots[:2, 0].tolist()
        faces = {"near": spots[2:6, 0], "far": spots[6:10, 0]}
        top = y - 0.5 * _ROW_EM * self._em
        for name, distance in self._ways(measured):
            if name in faces:
                x = float(faces[name].mean())
            else:
                x = eye + (target - eye) * distance / measured.projection.camera.distance
                if not 0.0 <= x <= size_px[0]:
                    continue
            y -= _ROW_EM * self._em
            start, end = sorted((eye, x))
            text = f"{self._words.get(name, name)} = {written_distance(distance)}"
            self._write(layout, name, text, (start, y), (end, y))
            self._rule(layout, (start, y), (end, y))
        # Rows of their own, to the bottom: nothing else is written there, and no leader runs there.
        layout.keep_free_box([(0.0, 0.0, 1.0), (float(size_px[0]), top, 1.0)])

    def _ways(self, measured: Measured) -> list[tuple[str, float]]:
        projection, ways = measured.projection, dict[str, float]()
        if projection.has_camera:
            ways = {"d": projection.camera.distance, **dict(measured.distances)}
        if projection.lens.planes is not None and measured.corners is not None:
            ways["near"], ways["far"] = projection.lens.planes
        named = [way for way in ways.items() if way[0] in measured.names]
        return sorted(named, key=lambda way: abs(way[1]))

    def _length(self, layout: Layout, name: str, length: float, start: Spot, end: Spot) -> None:
        self._line(start[:2], end[:2])
        middle = (start[0] + end[0]) / 2.0, (start[1] + end[1]) / 2.0
        text = f"{name} = {written_distance(length)}"
        self._put(layout, name, text, middle, (*_LEFT, *_RIGHT))

    def _beside(self, layout: Layout, spots: Array, measured: Measured) -> None:
        """Half the angle at the eye, and half the window on the far plane."""
        axis, edge = (1, 8) if measured.view == "side" else (0, 7)  # of top, of right
        half = half_of(measured.projection, axis)
        if half is None or not half.has_eye:
            return

        def keep_off(face: Array) -> None:
            layout.keep_free_box([(x, y, 1.0) for x, y in face.tolist()])

        eye, far_edge = spots[0], spots[edge]
        reached = far_edge - eye
        keep_off(spots[6:10])
        if "height" in measured.names:
            x = float(far_edge[0]) - 1.2 * self._em
            start, end = float(eye[1]), float(far_edge[1])
            middle = x, (start + end) / 2.0
            self._put(layout, "height", self._half_text(axis, half), middle, _LEFT)
            self._rule(layout, (x, start), (x, end))
        keep_off(spots[2:6])
        if half.angle_deg is not None and "angle" in measured.names:
            # The angle is true on the screen: both axes have one scale.
            radius = min(_ARC_EM * self._em, _ARC_PART * float(np.hypot(*reached)))
            end = math.copysign(1.0, reached[1]) * math.radians(half.angle_deg)
            turns = np.linspace(0.0, end, _ARC + 1)
            arc = eye + radius * np.column_stack([np.cos(turns), np.sin(turns)])
            for start, stop in zip(arc[:-1].tolist(), arc[1:].tolist(), strict=True):
                self._line((start[0], start[1]), (stop[0], stop[1]))
            self._line((float(eye[0]), float(eye[1])), (float(far_edge[0]), float(eye[1])))
            text = f"{self._angle(axis)}/2 = {written_distance(half.angle_deg)}°"
            x, y = arc[_ARC // 2].tolist()
            self._put(layout, "angle", text, (x, y), _RIGHT)

    def _across(self, layout: Layout, spots: Array, measured: Measured) -> None:
        """Half the height and half the width of the window, seen along the axis."""
        upper, half_width = (half_of(measured.projection, axis) for axis in (1, 0))
        if upper is None or half_width is None:
            return
        # The projectors of a parallel lens need not be parallel to its axis.
        # Beside the face, not across it: the picture is there.
        eye, face = spots[0], spots[6:10] if upper.has_eye else spots[2:6]
        x, y = float(eye[0]), float(eye[1])
        right, top = face[2].tolist()
        if "height" in measured.names:
            aside = right + 0.7 * self._em
            self._put(layout, "height", self._half_text(1, upper), (aside, top), _ABOVE)
            self._rule(layout, (aside, y), (aside, top))
        if "width" not in measured.names:
            return
        below = float(face[0, 1]) - 1.2 * self._em
        start, end = sorted((x, right))
        text = self._half_text(0, half_width)
        self._write(layout, "width", text, (start, below), (end, below), _BELOW)
        self._rule(layout, (start, below), (end, below))

    def _half_text(self, axis: int, half: Half) -> str:
        size = written_distance(half.at_far)
        if half.angle_deg is None:
            return f"{self._words['half height' if axis else 'half width']} = {size}"
        far = self._words.get("{far_distance}", "f")
        return f"{far} tan({self._angle(axis)}/2) = {size}"

    def _angle(self, axis: int) -> str:
        return self._words.get("{fov}", "fov") if axis else self._words.get("{fov_x}", "fov_x")

    def _rule(self, layout: Layout, start: Way, end: Way) -> None:
        """A level or upright line with a tick at either end; no later text lies on it."""
        tick, is_level = _TICK_EM * self._em, start[1] == end[1]
        across, up = (0.0, tick) if is_level else (tick, 0.0)
        self._line(start, end)
        for x, y in (start, end):
            self._line((x - across, y - up), (x + across, y + up))
        corners = (start[0] - across, start[1] - up, 1.0), (end[0] + across, end[1] + up, 1.0)
        layout.keep_free_box(corners)

    def _write(
        self,
        layout: Layout,
        name: str,
        text: str,
        start: Way,
        end: Way,
        otherwise: Sequence[Way] = (),
    ) -> None:
        """Put a text on the middle of its level line, or beside a line that is too short."""
        room_px = end[0] - start[0]
        self._texts[name].set_text(text)
        if layout.half(self._texts[name])[0] * 2.0 + self._em <= room_px:
            middle = (start[0] + end[0]) / 2.0, start[1]
            if self._try(layout, name, text, middle, _ON, gaps=1):
                return
        if not self._try(layout, name, text, end, ((1.0, 0.0),)):
            self._put(layout, name, text, start, ((-1.0, 0.0), *otherwise))

    def _put(self, layout: Layout, name: str, text: str, place: Way, sides: Sequence[Way]) -> None:
        if not self._try(layout, name, text, place, sides) and layout.shows(*place):
            self._is_left_out = True  # and not because a hand has moved it out of the pane

    def _try(
        self, layout: Layout, name: str, text: str, place: Way, sides: Sequence[Way], gaps: int = 6
    ) -> bool:
        label = self._texts[name]
        label.set_text(text)
        leader = self._leaders.get(name)
        return layout.place(label, [(*place, 1.0)], sides, leader, gaps=gaps)

    def _line(self, start: Way, end: Way) -> None:
        if self._used < _SEGMENTS:
            self._lines.px[self._used, :, :2] = start, end
            self._used += 1

    # -- what a lens does not have, or a pane no room for

    def _say(self, layout: Layout, size_px: tuple[int, int], said: list[str]) -> None:
        self._sentence.set_visible(bool(said))
        if not said:
            return
        self._sentence.set_text("\n ".join(said))
        self._sentence.set_position(0.5 * self._em, 0.5 * self._em)
        top = self._said_em(said) * self._em
        layout.keep_free_box([(0.0, 0.0, 1.0), (float(size_px[0]), top, 1.0)])

    def _said_em(self, said: list[str]) -> float:
        return 0.5 + 1.5 * len(said) if said else 0.0

    def _said(
        self, size_px: tuple[int, int], measured: Measured, rows_em: float | None
    ) -> list[str]:
        """The lines of the sentence that says what is left out, and why."""
        names = (self._lacks(measured), "no room" if rows_em is None else "")
        sentence = " ".join(self._words[name] for name in names if name)
        across = max(12, int((size_px[0] / self._em - 2.0) / 0.58))
        return textwrap.wrap(sentence, across) if sentence else []

    def _lacks(self, measured: Measured) -> str:
        """The key in `app.drawings.WORDS` for what the lens lacks; empty for nothing."""
        if not any(name in measured.names for name in ("angle", "height", "width")):
            return ""
        half = half_of(measured.projection, 1 if measured.view == "side" else 0)
        if half is None:
            return "no planes"
        if not half.has_eye:
            return "no eye" if measured.view == "eye" else "no angle"
        has_angle = half.angle_deg is not None or measured.view not in ("side", "top")
        return "" if has_angle else "no half angle"
