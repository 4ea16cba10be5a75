"""Lengths and angles in the world pane's flat views, as in a sketch on the blackboard.

Lines of the screen, in one array of pixels that a step writes, and a text for each::

            . ' | f tan(fov/2)
        . ' )   |
    eye ----+---+---
     |-- d --|
     |--- -z ----|

A lens may lack some of them; a sentence at the bottom says so. Seen along the axis, the window can
stand over two lines of numbers, its own and the one from -1 to 1::

       l |-----+---------| r
      -1 |-----+---------| 1
"""

import math
import textwrap
from collections.abc import Hashable
from functools import partial

import numpy as np

from app.drawings.label_placement import Ground, Places, around, beyond, joined, on
from app.drawings.labels import LENGTH, ScreenLines, written_distance
from app.drawings.layer import Layer
from app.drawings.pane_view import Spot
from app.drawings.world_state import Half, WorldState, distances, half_of, has_interval, lengths
from app.model.projection import Array
from app.scenes.phenomena.words import digits_apart, figure

_SEGMENTS = 64  # capacity
_ARC = 12  # pieces of the angle's arc
_ARC_EM, _TICK_EM, _ROW_EM = 3.5, 0.35, 2.2
_ASIDE_EM = 1.2  # from the far plane to the line beside it
_ARC_PART = 0.3  # of the way to the far plane's edge: the arc is no larger
_ARC_BEFORE = 0.5  # of e, where it is named
_ACROSS_EM = 2.2  # under the window seen along the axis
_INTERVAL_EM, _BELOW_EM, _LINES_EM = 5.6, 1.2, 2.2  # the lines of numbers: their rows
_LINES = 4  # of the sentence
_KEY = "length"  # begins the keys of the letters on the pane's board

Way = tuple[float, float]


class Dimensions(Layer):
    """The lines and their letters, created when a flat view is first shown."""

    needs = "own.fixed"

    def __init__(self, state: WorldState) -> None:
        self._state = state
        self._board, self._words, self._em = state.board, state.words, state.em
        self._is_made = self._is_shown = False

    def _make(self) -> None:
        canvas, scene = self._state.canvas, self._state.scene
        for name, colour in scene.inks.items():
            self._board.label((_KEY, name), colour=getattr(canvas.style, colour))
        self._lines = ScreenLines(canvas, canvas.style.ink, _SEGMENTS)
        self._thin = ScreenLines(canvas, canvas.style.leader, _SEGMENTS)
        self._sentences = [canvas.label("", anchor=(-1, -1), plain=True) for _ in range(_LINES)]
        self._is_made = True

    def settle(self) -> None:
        """Hide everything in the free view."""
        if self._is_shown and not self._state.own.fixed:
            self._is_shown = False
            for label in self._sentences:
                label.set_visible(False)
            for lines in (self._lines, self._thin):
                lines.begin()
                lines.end()

    @property
    def below_em(self) -> float:
        """How much room the lines and the sentence need below the drawing, in ems."""
        if not self._state.own.fixed:
            return 0.0
        said = len(self._sentence_lines())
        return self._rows_em() + (0.5 + 1.5 * said if said else 0.0)

    @property
    def below(self) -> tuple[float, float]:
        """The distances along the axis between which that room is needed; a sentence needs all."""
        rows = [distance for _, distance in distances(self._state, self._state.own.fixed)]
        is_all = not rows or self._sentence_lines()
        return (-math.inf, math.inf) if is_all else (min(0.0, *rows), max(0.0, *rows))

    def _rows_em(self) -> float:
        state = self._state
        if state.own.fixed == "axis":
            across = _ACROSS_EM if "width" in state.names else 0.0
            return across + (_INTERVAL_EM if has_interval(state, state.own.fixed) else 0.0)
        count = len(distances(state, state.own.fixed))
        return _ROW_EM * (count + 0.5) if count else 0.0

    def want(self, ground: Ground) -> None:
        """Draw the lines, and ask for the places of their letters."""
        state = self._state
        if not state.own.fixed:
            return
        if not self._is_made:
            self._make()
        self._is_shown = True
        self._lines.begin()
        self._thin.begin()
        self._show_sentence(ground, self._sentence_lines())
        if state.own.fixed != "eye":
            at, corners = state.standing, state.corners_seen
            points = np.vstack([state.objects, at.eye, at.target])
            if state.projection.lens.planes is None:
                corners = None
            drawn = points if corners is None else np.vstack([points, corners])
            all_spots = state.spots(drawn)
            spots = all_spots[len(state.objects) :]
            lowest = float(spots[0, 1])
            for length in lengths(state, state.own.fixed):
                if length.name in state.names:
                    ends = state.seen(np.array([length.start, length.end]) - state.origin)
                    self._length(length.name, *ends)
                    lowest = min(lowest, ends[0][1], ends[1][1])
            if "e" in dict(distances(state, state.own.fixed)):
                lowest = min(lowest, float(spots[0, 1]) - abs(self._unit(spots)))
            if state.own.fixed == "axis":
                if corners is not None:
                    self._across(ground, spots, all_spots)
            else:
                self._along(ground, spots, lowest, all_spots)
                if corners is not None:
                    self._beside(spots)
        self._lines.end()
        self._thin.end()

    def ink(self, ground: Ground) -> None:
        if self._is_shown:
            for lines in (self._lines, self._thin):
                ground.ink_lines(lines.ends)

    def inside(self) -> dict[str, Array]:
        """The ends of the named lengths in a flat view."""
        state, at = self._state, self._state.standing
        if state.own.fixed not in ("side", "top"):
            return {}
        shown = () if state.illustration is None else state.illustration.measured
        measured = {"d": at.camera.distance, **dict(shown)}
        ends = {
            name: (at.eye - distance * at.camera.frame[2])[None]
            for name, distance in measured.items()
        }
        for each in lengths(state, state.own.fixed):
            ends[each.name] = np.array([each.start, each.end]) - state.origin
        return {name: points for name, points in ends.items() if state.names.wants(name)}

    # -- what is drawn

    def _along(self, ground: Ground, spots: Array, y: float, drawn: Array) -> None:
        """From the eye along the axis, one below the other, the shortest on top."""
        measured, size_px = distances(self._state, self._state.own.fixed), self._state.own.size_px
        if not measured:
            return
        (eye, height), (target, _) = spots[:2].tolist()
        unit = target - eye, self._state.projection.camera.distance
        ends = [eye + unit[0] * distance / unit[1] for _, distance in measured]
        # Below what is drawn above the rows, if there is so much room.
        above = (drawn[:, 0] > min(eye, *ends)) & (drawn[:, 0] < max(eye, *ends))
        y = min([y, *drawn[above, 1].tolist()])
        y = max(y, self.below_em * self._em)
        for (name, _), x in zip(measured, ends, strict=True):
            if not 0.0 <= x <= size_px[0]:
                continue
            y -= _ROW_EM * self._em
            left, right = self._rule(name, (eye, y), (x, y), name.replace("-", "−"))
            # A row of its own: nothing else is written there.
            low, high = y - _ROW_EM / 2.0 * self._em, y + _ROW_EM / 2.0 * self._em
            ground.keep_box(0.0, low, left, high)
            ground.keep_box(right, low, float(size_px[0]), high)
            for end in {eye, x}:
                self._thin.add((end, y), (end, height))
        ground.keep_box(0.0, 0.0, float(size_px[0]), y - 0.8 * self._em)

    def _unit(self, spots: Array) -> float:
        """A unit along the axis, in pixels."""
        return float(spots[1, 0] - spots[0, 0]) / self._state.projection.camera.distance

    def _length(self, name: str, start: Spot, end: Spot) -> None:
        self._lines.add(start[:2], end[:2])
        self._write(name, name)
        half = (start[0] + end[0]) / 2.0, (start[1] + end[1]) / 2.0
        self._board.want_beside((_KEY, name), (*half, 1.0), LENGTH, (1.0, 0.0))

    def _beside(self, spots: Array) -> None:
        """Half the angle at the eye, half the window on the far plane, and where that half is 1."""
        state = self._state
        axis, edge = (1, 8) if state.own.fixed == "side" else (0, 7)  # of top, of right
        half = half_of(state.projection, axis)
        if half is None or not half.has_eye:
            return
        eye, far_edge = spots[0], spots[edge]
        if "height" in state.names:
            x = float(far_edge[0]) - _ASIDE_EM * self._em
            self._rule(
                "height", (x, float(eye[1])), (x, float(far_edge[1])), self._half_text(axis, half),
                side=-1.0,
            )  # fmt: skip
        e, unit = dict(distances(state, state.own.fixed)).get("e"), self._unit(spots)
        if e is not None:
            x, y = float(eye[0]) + e * unit, float(eye[1])
            self._rule("one", (x, y), (x, y + math.copysign(unit, far_edge[1] - y)), "1")
        if half.angle_deg is not None and "angle" in state.names:
            # The angle is true on the screen: both axes have one scale.
            reached = far_edge - eye
            radius = min(_ARC_EM * self._em, _ARC_PART * float(np.hypot(*reached)))
            if e is not None:
                radius = min(radius, _ARC_BEFORE * e * abs(unit))
            end = math.copysign(1.0, reached[1]) * math.radians(half.angle_deg)
            turns = np.linspace(0.0, end, _ARC + 1)
            arc = eye + radius * np.column_stack([np.cos(turns), np.sin(turns)])
            for start, stop in zip(arc[:-1].tolist(), arc[1:].tolist(), strict=True):
                self._lines.add((start[0], start[1]), (stop[0], stop[1]))
            self._thin.add((float(eye[0]), float(eye[1])), (float(far_edge[0]), float(eye[1])))
            is_number = "degrees" in (state.names.wanted or ())
            number = f" = {figure(half.angle_deg, 4)}°" if is_number else ""
            self._write("angle", f"{self._angle(axis)}/2{number}")
            x, y = arc[_ARC // 2].tolist()
            way = x - float(eye[0]), y - float(eye[1])
            key, size = (_KEY, "angle"), self._board.label((_KEY, "angle")).size_px

            def places() -> Places:
                past = beyond((x, y), way, size, self._em)
                return joined(past, around((x, y), size, self._em))

            self._board.want(key, [(x, y)], places, LENGTH)

    def _across(self, ground: Ground, spots: Array, drawn: Array) -> None:
        """Half the height and half the width of the window, seen along the axis."""
        names = self._state.names
        upper, half_width = (half_of(self._state.projection, axis) for axis in (1, 0))
        if upper is None or half_width is None:
            return
        # The projectors of a parallel lens need not be parallel to its axis.
        # Beside the face, not across it: the picture is there.
        eye, face = spots[0], spots[6:10] if upper.has_eye else spots[2:6]
        x, y = float(eye[0]), float(eye[1])
        right, top = face[2].tolist()
        if "height" in names:
            aside = right + 0.7 * self._em
            self._rule("height", (aside, y), (aside, top), self._half_text(1, upper))
        if "width" in names:
            below = float(face[0, 1]) - 1.2 * self._em
            self._rule("width", (x, below), (right, below), self._half_text(0, half_width))
        if has_interval(self._state, self._state.own.fixed):
            self._interval(spots[2:6], float(drawn[:, 1].min()), ground)

    def _interval(self, window: Array, lowest: float, ground: Ground) -> None:
        """Two lines of numbers below what is drawn: from l to r, and from -1 to 1.

        The probes stand on both, with their x in the cube.
        """
        em, limits = self._em, ground.limits
        left, right = float(window[0, 0]), float(window[1, 0])
        foot = float(window[:2, 1].min())
        names_width = "width" in self._state.names
        below = max(lowest, min(foot, self.below_em * em))
        upper = below - _BELOW_EM * em - (_ACROSS_EM * em if names_width else 0.0)
        lower = upper - _LINES_EM * em
        low, high = self._state.projection.window[:2]
        for y in (upper, lower):
            self._lines.add((left, y), (right, y))
        for letter, value, x, one in (("l", low, left, -1.0), ("r", high, right, 1.0)):
            self._thin.add((x, foot), (x, lower))
            word = self._words.get(f"{{{letter}}}", letter)
            text = f"{word} = {written_distance(value, digits_apart(low, high))}"
            self._on_line(letter, text, (x, upper), limits, one)
            self._on_line((_KEY, one), written_distance(one), (x, lower), limits, one)
        for number, place in enumerate(self._probes_across()):
            if -1.0 <= place <= 1.0:
                x = left + (place + 1.0) / 2.0 * (right - left)
                self._thin.add((x, upper), (x, lower))
                text = written_distance(float(f"{place:.3g}"))
                self._on_line((_KEY, "probe", number), text, (x, lower), limits)

    def _probes_across(self) -> list[float]:
        """The x of the probes in the cube."""
        points = [probe.point for probe in self._state.probes if probe.point is not None]
        if not points:
            return []
        trace = self._state.projection.trace(np.array(points))
        across: list[float] = trace.ndc[trace.in_front, 0].tolist()
        return across

    def _on_line(
        self,
        key: Hashable,
        text: str,
        place: Way,
        limits: tuple[float, float, float, float],
        side: float = 0.0,
    ) -> None:
        """A tick on a line of numbers, and its number: outside the line, or below it."""
        (x, y), tick = place, _TICK_EM * self._em
        self._lines.add((x, y - tick), (x, y + tick))
        self._board.label(key).set_text(text)
        wide, high = self._board.label(key).size_px
        at = x + side * (wide / 2.0 + 0.5 * self._em), y
        if not side or not limits[0] + wide / 2.0 <= at[0] <= limits[2] - wide / 2.0:
            at = x, y - tick - 0.3 * self._em - high / 2.0
        self._board.want(key, [place], partial(on, at), LENGTH)

    def _half_text(self, axis: int, half: Half) -> str:
        if half.angle_deg is None:
            return self._words["half height" if axis else "half width"]
        far = self._words.get("{far_distance}", "f")
        return f"{far} tan({self._angle(axis)}/2)"

    def _angle(self, axis: int) -> str:
        return self._words.get("{fov}", "fov") if axis else self._words.get("{fov_x}", "fov_x")

    def _write(self, name: str, text: str) -> None:
        self._board.label((_KEY, name)).set_text(self._words.get(text, text))

    def _rule(self, name: str, start: Way, end: Way, text: str, side: float = 1.0) -> Way:
        """A level or upright line with a tick at either end, and its letters in a gap of it.

        Letters that are too long for the gap stand beside the line, at the right or, for a `side`
        of -1, at the left. Returns where they begin and end.
        """
        self._write(name, text)
        key, em = (_KEY, name), self._em
        (wide, high), ((x0, y0), (x1, y1)) = self._board.label(key).size_px, sorted((start, end))
        tick, is_level = _TICK_EM * em, y0 == y1
        across, up = (0.0, tick) if is_level else (tick, 0.0)
        for x, y in (start, end):
            self._lines.add((x - across, y - up), (x + across, y + up))
        middle = (x0 + x1) / 2.0, (y0 + y1) / 2.0
        length = x1 - x0 if is_level else y1 - y0
        half = (wide if is_level else high) / 2.0 + 0.35 * em
        if 2.0 * half + em < length and (is_level or wide < _ASIDE_EM * em):
            gap = (half, 0.0) if is_level else (0.0, half)
            for sign, (x, y) in ((-1.0, (x0, y0)), (1.0, (x1, y1))):
                self._lines.add((x, y), (middle[0] + sign * gap[0], middle[1] + sign * gap[1]))
            places = [middle]
        else:
            self._lines.add(start, end)
            away = wide / 2.0 + 0.5 * em
            beside = x0 - away if side < 0.0 else x1 + away
            above = x1 - wide / 2.0, y1 + 0.5 * em + high / 2.0
            parts = (0.5,) if is_level else (0.5, 0.75, 0.25)
            places = [(beside, y0 + part * (y1 - y0)) for part in parts]
            places += [(x0 - away, y0)] if is_level else [above]
        self._board.want(key, [middle], lambda: joined(*map(on, places)), LENGTH)
        x, _ = places[0]
        return x - wide / 2.0, x + wide / 2.0

    # -- what a lens does not have

    def _show_sentence(self, ground: Ground, said: list[str]) -> None:
        for number, label in enumerate(self._sentences):
            label.set_visible(number < len(said))
            if number < len(said):
                label.set_text(said[number])
                label.set_position(
                    0.5 * self._em, (0.5 + 1.5 * (len(said) - 1 - number)) * self._em
                )
        if said:
            ground.keep_box(0.0, 0.0, float(ground.limits[2]), (0.5 + 1.5 * len(said)) * self._em)

    def _sentence_lines(self) -> list[str]:
        """The lines of the sentence that says what the lens lacks."""
        name = self._lacks()
        across = max(12, int((self._state.own.size_px[0] / self._em - 2.0) / 0.58))
        return textwrap.wrap(self._words[name], across)[:_LINES] if name else []

    def _lacks(self) -> str:
        """The key in `app.drawings.WORDS` for what the lens lacks; empty for nothing."""
        state, view = self._state, self._state.own.fixed
        if not any(name in state.names for name in ("angle", "height", "width")):
            return ""
        half = half_of(state.projection, 1 if view == "side" else 0)
        if half is None:
            return "no planes"
        if not half.has_eye:
            return "no eye" if view == "eye" else "no angle"
        has_angle = half.angle_deg is not None or view not in ("side", "top")
        return "" if has_angle else "no half angle"
