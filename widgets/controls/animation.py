"""The exercise of lecture 004: the camera walks round the scene while its height changes.

`camera_at` is the exercise as a pure function of time; `AnimationBar` plays it. The bar emits and
shows cameras like every other control.
"""

import math
from dataclasses import dataclass, replace
from functools import partial
from typing import Literal, TypeAlias

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from app.model.limits import within
from app.model.projection import LARGEST, Camera, Vector
from app.model.refusal import REFUSALS, Refusal
from widgets.parts.clock import Clock, Playing
from widgets.parts.fields import ChoiceRow, Option, Row
from widgets.parts.labels import WarningLabel
from widgets.parts.layouts import FREE, in_column, in_row, tool_button
from widgets.parts.messages import limits_text, sentence
from widgets.parts.number_rows import NumberRow
from widgets.parts.scales import Linear
from widgets.parts.wording import Wording

WORDS = Wording(__file__)
HeightMode: TypeAlias = Literal["fixed", "swing", "steps"]
LookMode: TypeAlias = Literal["target", "level"]

STEP_S = 2.0  # the lecture's pause between two heights in steps
STEPS_UP = 3  # steps from the lowest height to the highest
PERIOD_S = 2.0 * STEPS_UP * STEP_S  # time for one cycle up and down, smoothly or in steps
FASTEST_DEG_S = 3600
"""Ten turns a second: above a sixth of a turn per frame, the direction is no longer visible."""

_PLACES = 120  # of the eye, in one turn


@dataclass(frozen=True)
class Motion:
    """How the camera walks."""

    speed_deg_s: float = 20.0
    """Turn about the vertical through the target, degrees per second; positive is anticlockwise
    from above."""
    height: HeightMode = "fixed"
    """The eye keeps its y, swings between the limits, or takes the next of four heights every
    `STEP_S`."""
    look: LookMode = "target"  # toward the target, or horizontal: the target gets the eye's y
    lowest: float = 0.0
    highest: float = 10.0  # limits of the eye's y, world units; in either order
    clock_s: float = 0.0  # phase at which the walk begins: 0 is lowest, `PERIOD_S`/2 is highest

    @property
    def _middle(self) -> float:
        return self.lowest / 2.0 + self.highest / 2.0

    @property
    def _reach(self) -> float:
        return abs(self.highest / 2.0 - self.lowest / 2.0)

    def swing(self, clock_s: float) -> float:
        """Return the eye's y of the smooth walk, in world units."""
        turn = 2.0 * math.pi * math.remainder(clock_s, PERIOD_S) / PERIOD_S
        return self._middle - self._reach * math.cos(turn)

    def step(self, clock_s: float) -> float:
        """Return the eye's y of the walk in steps, in world units."""
        beat = math.floor(clock_s / STEP_S) % (2 * STEPS_UP)
        level = min(beat, 2 * STEPS_UP - beat)
        return self._middle + self._reach * (2.0 * level / STEPS_UP - 1.0)

    def clock_at(self, height: float, *, rising: bool = True) -> float:
        """Return the time at which the rising or falling walk is closest to a height."""
        down = (self._middle - height) / self._reach if self._reach > 0.0 else 0.0
        clock_s = math.acos(min(max(down, -1.0), 1.0)) / (2.0 * math.pi) * PERIOD_S
        return clock_s if rising else PERIOD_S - clock_s

    def at(self, height: float, *, rising: bool = True) -> "Motion":
        """Return the walk that begins where it is closest to a height."""
        return replace(self, clock_s=self.clock_at(height, rising=rising))

    @property
    def rising(self) -> bool:
        """Whether the smooth walk goes up at `clock_s`."""
        return math.remainder(self.clock_s, PERIOD_S) >= 0.0


def camera_at(start: Camera, elapsed_s: float, motion: Motion) -> Camera:
    """Return the camera some seconds after it stood at `start`.

    The walk goes round the target of `start` at a constant distance from the vertical. A `Refusal`
    if there is no such camera: one straight above its target cannot look level.
    """
    turn = math.radians(math.remainder(motion.speed_deg_s * elapsed_s, 360.0))
    cos, sin = math.cos(turn), math.sin(turn)

    def turned(vector: Vector) -> Vector:
        x, y, z = vector
        return cos * x + sin * z, y, cos * z - sin * x

    x, _, z = turned((start.eye[0] - start.target[0], 0.0, start.eye[2] - start.target[2]))
    eye_y = _height(start.eye[1], elapsed_s, motion)
    eye = (start.target[0] + x, eye_y, start.target[2] + z)
    target_y = eye_y if motion.look == "level" else start.target[1]
    return Camera(eye, (start.target[0], target_y, start.target[2]), turned(start.up))


def _height(start_y: float, elapsed_s: float, motion: Motion) -> float:
    clock_s = motion.clock_s + elapsed_s
    if motion.height == "swing":
        # From a start beyond the limits there is no jump: the difference fades within seconds.
        excess = start_y - motion.swing(motion.clock_s)
        return motion.swing(clock_s) + excess * math.exp(-elapsed_s)
    if motion.height == "steps":
        same_beat = math.floor(clock_s / STEP_S) == math.floor(motion.clock_s / STEP_S)
        return start_y if same_beat else motion.step(clock_s)
    return start_y


class AnimationBar(QWidget, Playing):
    """Plays the walk from the current camera, one camera a frame.

    If something else moves the camera meanwhile (a slider, undo), the walk continues from there.
    """

    edited = Signal(object)  # the next `Camera`, once per frame
    walked = Signal(tuple)  # the eye's places for the next turn while it walks; none when it stops

    def __init__(self) -> None:
        super().__init__()
        self._motion = Motion()
        self._start: Camera | None = None
        self._elapsed_s = 0.0
        self._shown: Camera | None = None
        self._clock = Clock(self, self.advance)
        self._make_widgets()
        self._show_state()
        self._show_error("")

    def _make_widgets(self) -> None:
        self.button = tool_button(WORDS.say("play"), act=self.toggle, icon="play")
        self._error = WarningLabel()
        self.speed = _number("speed", Linear(-90.0, 90.0, 1.0))
        heights = (_number(key, Linear(-10.0, 10.0, 0.1)) for key in ("lowest", "highest"))
        self.lowest, self.highest = heights
        self.height_mode, self.look = map(_choice, ("height", "look"))
        self.rows: tuple[Row, ...] = (
            self.speed, self.height_mode, self.lowest, self.highest, self.look
        )  # fmt: skip
        line = in_row(self.button, FREE)
        in_column(line, self._error, *self.rows, on=self, margins=(0, 0, 0, 0), gap=3)
        for number, largest in (
            (self.speed, FASTEST_DEG_S), (self.lowest, LARGEST), (self.highest, LARGEST)
        ):  # fmt: skip
            number.limits = partial(limits_text, -largest, largest)
            number.edited.connect(partial(self._number_edited, number, largest))
        for choice in (self.height_mode, self.look):
            choice.edited.connect(self._settings_edited)
        self.speed.setValue(self._motion.speed_deg_s)
        for row in self.rows:
            row.setDefault(row.value())

    # -- set by the owner

    def set_scene(self, size: float, camera: Camera) -> None:
        """Pause, and fit the limits of the height to the diagonal and the camera of a scene."""
        self.pause()
        for row in self.rows:
            row.clear_error()
        middle = camera.target[1]
        scale = Linear.about(middle, 3.0 * size)
        # Beside a long row of objects a swing that high would look straight down.
        reach = min(size, camera.distance / 2.0)
        for row, height in ((self.lowest, middle - reach / 4.0), (self.highest, middle + reach)):
            row.setScale(scale)
            row.setValue(scale.value_at(scale.position_of(height)))
            row.setDefault(row.value())
        self._start = None
        self._settings_edited()

    def show_camera(self, camera: Camera) -> None:
        """Store the camera; if it differs from the last frame's, the walk continues from it."""
        if camera == self._shown:
            return
        self._show_error("")
        self._forget_refusals()
        before, self._shown = self._shown, camera
        if self._start is None or before is None:
            return
        aim_y = self._start.target[1]
        if camera.target[1] != before.target[1]:  # ignore the levelling by the walk itself
            aim_y = camera.target[1]
        rising, old_y = self._now.rising, before.eye[1]
        self._go_on_from(camera, aim_y)
        if camera.eye[1] != old_y:
            self._motion = self._motion.at(camera.eye[1], rising=rising)
        self.walked.emit(self._turn())

    # -- playing

    def play(self) -> None:
        """Start walking from the current camera."""
        if self.playing or self._shown is None or not self.isEnabled():
            return
        self._show_error("")
        if self._start is None:
            self._start, self._elapsed_s = self._shown, 0.0
            self._motion = self._motion.at(self._shown.eye[1])
        self._set_playing(True)

    def advance(self, seconds: float) -> None:
        """Advance by some seconds and emit the camera, unless paused."""
        if not self.playing or self._start is None:
            return
        self._elapsed_s += seconds
        try:
            camera = camera_at(self._start, self._elapsed_s, self._motion)
        except Refusal as error:
            self.pause()
            self._show_error(self._why(error))
            return
        if camera != self._shown:
            self._shown = camera
            self.edited.emit(camera)

    def _why(self, error: Refusal) -> str:
        """Say why the walk stopped, without the numbers of a camera that nobody chose."""
        if error.bound == REFUSALS["not-the-eye"] and self._motion.look == "level":
            if self._start is not None and self._start.eye[1] < self._start.target[1]:
                return WORDS.say("below")
            return WORDS.say("above")
        if error.bound == REFUSALS["not-the-eye"]:
            return WORDS.say("at-target")
        return WORDS.say("along-up") if error.bound == REFUSALS["not-parallel"] else sentence(error)

    # -- where the walk is

    @property
    def _now(self) -> Motion:
        return replace(self._motion, clock_s=self._motion.clock_s + self._elapsed_s)

    def _turn(self) -> tuple[Vector, ...]:
        """Return places of the eye for one turn from now on, the same number for each."""
        if not self.playing or self._start is None or not self._motion.speed_deg_s:
            return ()
        turn_s = 360.0 / abs(self._motion.speed_deg_s)
        times = (self._elapsed_s + turn_s * k / _PLACES for k in range(_PLACES + 1))
        try:
            return tuple(camera_at(self._start, at, self._motion).eye for at in times)
        except Refusal:
            return ()

    def _go_on_from(self, camera: Camera, aim_y: float) -> None:
        """Begin a new walk here; `aim_y` keeps the target's y while the camera looks level."""
        self._motion = self._now
        self._elapsed_s = 0.0
        x, _, z = camera.target
        try:
            self._start = replace(camera, target=(x, aim_y, z))
        except Refusal:  # the target would be at the eye, or straight above or below it
            self._start = camera

    def _number_edited(self, row: NumberRow, largest: float, value: float) -> None:
        try:
            within(row.name, value, -largest, largest)
        except Refusal as error:
            row.show_error(sentence(error))
        else:
            self._settings_edited()

    def _forget_refusals(self) -> None:
        """Remove the refusals: another value was accepted."""
        for row in self.rows:
            if row.error and not row.in_hand:
                row.clear_error()

    def _settings_edited(self) -> None:
        self._show_error("")
        self._forget_refusals()
        if self._start is not None and self._shown is not None:
            self._go_on_from(self._shown, self._start.target[1])
        speed, height, look = (row.value() for row in (self.speed, self.height_mode, self.look))
        low, high = self.lowest.value(), self.highest.value()
        limits_moved = (low, high) != (self._motion.lowest, self._motion.highest)
        limits_moved |= height != "fixed" and self._motion.height == "fixed"
        rising = self._motion.rising
        self._motion = replace(
            self._motion, speed_deg_s=speed, height=height, look=look, lowest=low, highest=high
        )
        if limits_moved and self._start is not None:
            self._motion = self._motion.at(self._start.eye[1], rising=rising)
        self._show_state()

    # -- shown

    def _show_state(self) -> None:
        self.button.setText(self._name_button("{0}", WORDS.say("walk"), WORDS.say("pause")))
        for row in (self.lowest, self.highest):
            row.setVisible(self.height_mode.value() != "fixed")
        self.walked.emit(self._turn())

    def _show_error(self, text: str) -> None:
        self._error.setText(f"{WORDS.say('stopped')} {text}" if text else "")
        self._error.setVisible(bool(text))


def _number(key: str, scale: Linear) -> NumberRow:
    name, tip, unit, said = WORDS[key]
    return NumberRow(name, tip, scale, unit, said)


def _choice(key: str) -> ChoiceRow:
    name, tip = WORDS[key]
    return ChoiceRow(name, tip, [Option(*each) for each in WORDS.choices(key)])
