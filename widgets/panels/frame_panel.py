"""The camera's frame, step by step: eye, look, up, n, u, v, and the view matrix made of them.

The formulas are filled with the model's own numbers; copied numbers have the digits that
`python -m app matrices` prints. A folded panel computes nothing.
"""

import re
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtGui import QEnterEvent, QHideEvent, QShowEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.lecture.camera_frame import (
    STEPS,
    UpAndView,
    most_turned_deg,
    nudged_up,
    turned_up,
    up_and_view,
    view_matrix,
)
from app.lecture.highlight import NOTHING, Highlight
from app.lecture.letters import base_of, frame_letters
from app.model.formula import ARROW
from app.model.formula_text import stacked_fraction
from app.model.parameter import read_sections
from app.model.parameters import tidy
from app.model.projection import Camera, Projection
from app.model.refusal import Refusal, format_value
from widgets.parts.labels import WarningLabel
from widgets.parts.layouts import FREE, LetteredWidget, in_column, in_row, push_button, scrolled
from widgets.parts.messages import all_digits, lettering, read_text, sentence, translated
from widgets.parts.number_rows import NumberRow
from widgets.parts.panel import PROJECTION, Changed, Panel, ShownData
from widgets.parts.plain import PlainLabel, set_tip
from widgets.parts.scales import Linear
from widgets.parts.typeset import TypesetLabel, in_line, matrix, resized
from widgets.parts.wording import Wording

WORDS = Wording(__file__)
STEP_MS = 2500  # time for reading each step while playing
NUDGE_DEG = 0.1
CLOSE_DEG = 1.0  # up counts as close to the view direction up to this angle
STEP_TEXTS = read_sections(Path(__file__).with_name("content") / "frame.md")
"""The sentence below the name of each step, in the order of `STEPS`; letters are in braces."""
_UP: Highlight = frozenset(("up",))
_ABOUT: tuple[Highlight, ...] = tuple(
    frozenset(names)
    for names in (("eye",), ("target",), ("up",), ("n",), ("u",), ("v",), ("u", "v", "n", "eye"))
)
_E, _N, _U, _V, _LOOK, _UP_VECTOR, _TARGET = (
    f"{name}{ARROW}" for name in ("e", "n", "u", "v", "look", "up", "target")
)


class _FrameStep(NamedTuple):
    """Name, formula and sentence of a step; the formula is for `widgets.parts.typeset`."""

    name: str
    formula: str
    sentence: str


class FramePanel(LetteredWidget, Panel):
    concerns = PROJECTION
    step_changed = Signal(object)  # the step to draw; None while the panel is folded

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(WORDS.say("panel"))
        self.step = 0  # index into `app.lecture.camera_frame.STEPS`
        self._projection = Projection()
        self._highlight = NOTHING
        self._steps = self._make_steps()
        self._timer = QTimer(self, interval=STEP_MS)
        self._timer.timeout.connect(self._play_on)

        self.back = WORDS.push("back", lambda: self.go_to(self.step - 1))
        self.next = WORDS.push("next", lambda: self.go_to(self.step + 1))
        self.play = push_button("", act=self.toggle)
        self.all = WORDS.push("all", lambda: self.go_to(len(STEPS) - 1))
        self.title = PlainLabel(objectName="paneTitle")
        self.formula, self.numbers = TypesetLabel(), TypesetLabel()
        self.numbers.setAccessibleDescription(WORDS.say("numbers"))
        self.sentence = PlainLabel(wordWrap=True)
        self._make_up()
        self._lay_out()
        all_digits.changed.connect(self._refresh)
        lettering.changed.connect(self._write_anew)
        self._show_playing()
        self._show_step()

    def _write_anew(self) -> None:
        self._steps = self._make_steps()
        self._show_step()
        self._refresh()

    def _lettered(self, text: str) -> str:
        """Replace the letters under arrows with the lecture's; its points T₀ and T₁ have none."""
        letters = frame_letters(lettering.now)

        def letter(match: re.Match[str]) -> str:
            name = letters.get(match[1], match[1])
            return name if name[1:].isdigit() else f"{name}{ARROW}"

        return re.sub(f"(?<![a-z])([a-z]+){ARROW}", letter, text)

    # -- making

    def _of_length_1(self, unit: str, whole: str, vector: str) -> str:
        """Divide a vector by its length; lecture 004 names the undivided vector."""
        if base_of(lettering.now) == "004":
            return f"{whole} = {vector},   {unit} = {stacked_fraction(whole, f'|{whole}|')}"
        return f"{unit} = {stacked_fraction(vector, f'|{vector}|')}"

    def _make_steps(self) -> tuple[_FrameStep, ...]:
        letters = frame_letters(lettering.now)
        m, t = letters["M"], letters["T"]
        formulas = (
            _E,
            f"{_LOOK} = {_TARGET} − {_E}",
            _UP_VECTOR,
            self._of_length_1(_N, f"N{ARROW}", f"{_E} − {_TARGET}"),
            self._of_length_1(_U, f"U{ARROW}", f"{_UP_VECTOR} × {_N}"),
            f"{_V} = {_N} × {_U}",
            f"{m} = R {t},   R = ({_U}, {_V}, {_N})^T,   {m} ({_E} : 1) = (0 : 1)",
        )
        texts = (
            [translated(text, "FramePanel").format(**letters) for text in (name, *section.text)]
            for name, section in STEP_TEXTS.items()
        )
        return tuple(
            _FrameStep(name, formula, sentence)
            for (name, sentence), formula in zip(texts, formulas, strict=True)
        )

    def _make_up(self) -> None:
        self.figures = PlainLabel(wordWrap=True)
        name, tip, unit = WORDS["angle"]
        self.angle = NumberRow(name, tip, Linear(0.0, 180.0, 1.0), "°", unit)
        self.angle.setDefault(90.0)
        self.angle.edited.connect(lambda deg: self._offer(lambda camera: turned_up(camera, deg)))
        self.pass_on(self.angle)
        self.angle.highlighted.connect(
            lambda is_at: self.highlighted.emit(_UP if is_at else NOTHING)
        )
        text, tip = WORDS.say("nudge", read_text(NUDGE_DEG)), WORDS.say("error")
        self.nudge = push_button(text, tip, self._nudge, name=tip)
        self.warning = WarningLabel()

    def _fit(self) -> None:
        self.formula.setFont(resized(self.font(), 1.25))

    def _lay_out(self) -> None:
        buttons = (self.back, self.next, self.play, self.all)
        labels = (self.formula, self.numbers, self.sentence)
        for label in labels:
            label.installEventFilter(self)
        step, up = QWidget(), QWidget()
        in_column(*labels, FREE, on=step, margins=(2, 0, 2, 0), gap=4)
        of_up = (self.figures, self.angle, self.nudge, self.warning)
        in_column(*of_up, FREE, on=up, margins=(12, 0, 2, 0), gap=4)
        aside = scrolled(up, WORDS.say("aside"))
        aside.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        bar = in_row(*buttons, 12, self.title, FREE)
        body = in_row((scrolled(step, WORDS.say("step")), 3), (aside, 2))
        in_column(bar, (body, 1), on=self, margins=(4, 0, 4, 2), gap=4)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)

    # -- steps

    def go_to(self, step: int) -> None:
        """Show a step and all steps before it, and stop playing."""
        self.pause()
        self._set_step(step)

    def toggle(self) -> None:
        """Play from here, or from the first step if this is the last; or pause."""
        if self.playing:
            self.pause()
            return
        if self.step == len(STEPS) - 1:
            self._set_step(0)
        self._timer.start()
        self._show_playing()

    def pause(self) -> None:
        self._timer.stop()
        self._show_playing()

    @property
    def playing(self) -> bool:
        """Whether the steps follow each other automatically."""
        return self._timer.isActive()

    def _play_on(self) -> None:
        self._set_step(self.step + 1)
        if self.step == len(STEPS) - 1:
            self.pause()

    def _set_step(self, step: int) -> None:
        if step != self.step:
            self.step = step
            self._show_step()
            self._show_numbers()
            if self.isVisible():
                self.step_changed.emit(step)

    def _show_step(self) -> None:
        step = self._steps[self.step]
        self.title.setText(WORDS.say("place", self.step + 1, len(STEPS), step.name))
        self.sentence.setText(step.sentence)
        self._mark()
        self.back.setEnabled(self.step > 0)
        self.next.setEnabled(self.step < len(STEPS) - 1)
        self.all.setEnabled(self.step < len(STEPS) - 1)

    def _show_playing(self) -> None:
        keys = ("pause", "paused") if self.playing else ("play", "playing")
        text, tip = map(WORDS.say, keys)
        self.play.setText(text)
        self.play.setAccessibleName(text)
        set_tip(self.play, tip)

    # -- the model

    def take(self, shown: ShownData, changed: Changed) -> None:
        before, now = self._projection, shown.projection
        self._projection = now
        if (before.camera, before.has_camera) != (now.camera, now.has_camera):
            self._refresh()

    def _refresh(self) -> None:
        if self.isVisible():
            self._show_numbers()
            self._show_up(up_and_view(self._projection.camera))

    def _show_numbers(self) -> None:
        if self.isVisible():
            # Not before: at the start of the program the formulas' fonts would be read for it.
            self.formula.set_formula(self._lettered(self._steps[self.step].formula))
            step, camera = STEPS[self.step], self._projection.camera
            has_wholes = base_of(lettering.now) == "004"
            self.numbers.set_formula(self._lettered(_numbers(step, camera, read_text, has_wholes)))
            exact = self._lettered(_numbers(step, camera, format_value, has_wholes))
            self.numbers.set_exact(in_line(exact))

    def _show_up(self, up: UpAndView) -> None:
        self.angle.setValue(tidy(up.angle_deg))
        if not self.angle.in_hand:
            self.angle.clear_error()
        text = self.tr(
            "Angle of {3} and view direction: {0}°\n|{3} × {4}| = {1}\n"
            "An error in {3} is {2} times as large in u and v."
        )
        numbers = map(read_text, (up.angle_deg, up.length, up.magnified))
        letters = frame_letters(lettering.now)
        self.figures.setText(text.format(*numbers, letters["up"], letters["n"]))
        off_deg = min(up.angle_deg, 180.0 - up.angle_deg)
        text = ""
        if off_deg <= CLOSE_DEG:
            turned_deg = most_turned_deg(round(off_deg, 12), NUDGE_DEG)  # as 0.1 was typed
            text = WORDS.say("close", *map(read_text, (off_deg, NUDGE_DEG, turned_deg)))
        typed = not self._projection.has_camera
        if typed:
            text = WORDS.say("typed")
        for control in (self.angle, self.nudge):
            control.setEnabled(not typed)  # up's error would not turn anything
        self.warning.setText(text)

    def _nudge(self) -> None:
        self.angle.finish_gesture()
        self._offer(lambda camera: nudged_up(camera, NUDGE_DEG))

    def _offer(self, change: Callable[[Camera], Camera]) -> None:
        try:
            camera = change(self._projection.camera)
        except Refusal as error:
            self.angle.show_error(sentence(error))
        else:
            self.edited.emit(replace(self._projection, camera=camera))

    # -- highlight

    def show_highlight(self, highlighted: Highlight) -> None:
        self._highlight = highlighted
        self.angle.set_marked(bool(highlighted & _UP))
        self._mark()

    def _mark(self) -> None:
        self.formula.set_marked(bool(self._highlight & _ABOUT[self.step]))

    # -- events

    def eventFilter(self, watched: object, event: QEvent) -> bool:
        if isinstance(event, QEnterEvent):
            self.highlighted.emit(_ABOUT[self.step])
        elif event.type() == QEvent.Type.Leave:
            self.highlighted.emit(NOTHING)
        return False

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._fit()  # the first polish of a style sheet resets fonts that were set before
        self._refresh()
        self.step_changed.emit(self.step)

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self.pause()
        self.highlighted.emit(NOTHING)
        self.step_changed.emit(None)


def _numbers(step: str, camera: Camera, write: Callable[[float], str], has_wholes: bool) -> str:
    """Return the numbers of a step, line by line, as of `widgets.parts.typeset`.

    If it `has_wholes`, the undivided vectors have lecture 004's names N and U.
    """

    def vector(parts: Iterable[float]) -> str:
        return f"({', '.join(write(part + 0.0) for part in parts)})"

    if step == STEPS[-1]:
        return matrix([write(value + 0.0) for value in row] for row in view_matrix(camera))
    u, v, n = camera.frame.tolist()
    backward = [e - t for e, t in zip(camera.eye, camera.target, strict=True)]
    up, distance = up_and_view(camera), write(camera.distance)
    whole_n, whole_u = f"{_E} − {_TARGET}", f"{_UP_VECTOR} × {_N}"
    if has_wholes:
        whole_n, whole_u = f"N{ARROW}", f"U{ARROW}"
    unit_look = stacked_fraction(_LOOK, f"|{_LOOK}|")
    lines = {
        "eye": {_E: vector(camera.eye)},
        "look": {
            _LOOK: vector(-part for part in backward),
            f"|{_LOOK}|": distance,
            unit_look: vector(-part for part in n),
        },
        "up": {_UP_VECTOR: vector(camera.up)},
        "n": {whole_n: vector(backward), f"|{whole_n}|": distance, _N: vector(n)},
        "u": {whole_u: vector(up.cross), f"|{whole_u}|": write(up.length), _U: vector(u)},
        "v": {_V: vector(v)},
    }
    return "\n".join(f"{name} = {value}" for name, value in lines[step].items())
