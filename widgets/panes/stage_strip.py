"""The stage strip under the NDC pane: from the world to the picture and back, by hand or played.

The strip knows positions and words, but no matrix.
"""

import math
import re
from functools import partial

from PySide6.QtCore import QEvent, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QHideEvent, QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QGridLayout, QSizePolicy, QSlider, QToolButton, QWidget

from app.languages import with_comma
from app.lecture.letters import in_letters
from app.lecture.notation import called
from app.lecture.stages import (
    CANONICAL_PARALLEL,
    CANONICAL_PERSPECTIVE,
    IMAGE,
    NDC,
    STOPS,
    VIEW,
    WORLD,
)
from app.lecture.titles import tile_title
from app.model.chain import MOST_TILES, Tile
from app.model.projection import Projection
from app.scenes.phenomena.words import digits_apart
from widgets.parts.clock import Clock, Playing
from widgets.parts.gestures import HeldSlider
from widgets.parts.layouts import FittedWidget, discard, in_column, in_row, tool_button
from widgets.parts.messages import lettering
from widgets.parts.panel import PROJECTION, Changed, ShownData
from widgets.parts.plain import set_tip
from widgets.parts.wording import Wording

WORDS = Wording(__file__)
STEPS = 240  # slider steps from one stop to the next
CATCH = 12  # a drag that comes as near to a stop is at the stop
GAP_PX = 3  # space on both sides of a name
STEP_S, REST_S = 2.0, 0.8  # seconds of playing from one stop to the next, and of the rest at each


class _StopsSlider(HeldSlider):
    """A slider whose arrow keys go from stop to stop."""

    grasped = Signal()  # the mouse is pressed, and has moved nothing yet

    def __init__(self) -> None:
        super().__init__()
        self.setTickInterval(STEPS)
        self.setTickPosition(QSlider.TickPosition.TicksBelow)
        self.setPageStep(STEPS // 8)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        keys = Qt.Key
        if event.key() in (keys.Key_Right, keys.Key_Up):
            self.setValue((self.value() // STEPS + 1) * STEPS)
        elif event.key() in (keys.Key_Left, keys.Key_Down):
            self.setValue((-(-self.value() // STEPS) - 1) * STEPS)
        else:
            super().keyPressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        super().wheelEvent(event) if self.hasFocus() else event.ignore()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.grasped.emit()
        super().mousePressEvent(event)


class StageStrip(FittedWidget, QWidget, Playing):
    """A slider through all stages, which starts at NDC, a name under each stop, and play."""

    concerns = PROJECTION - {"camera"}
    moved = Signal(float)  # the new position: whole at `stages.STOPS`, below 0 the object's moves
    turned = Signal(bool)  # whether moves are done from the left
    named = Signal(str, str)  # the stage there, and its axes and limits

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("stages")
        self._names = [WORDS[stop] for stop in STOPS]
        self._identity = WORDS["identity"]  # this stop for a parallel lens, whose box is before it
        self._projection = Projection()
        self._parallel = self._free = False
        self._emitted = ("", "")
        self._rest_s = 0.0
        self.position = self._before = float(NDC)  # 0 to 5, whole at `stages.STOPS`
        self._clock = Clock(self, self.advance)
        self.first = WORLD  # the first stop: below 0, one for each of the object's moves
        self._tiles: tuple[Tile, ...] = ()  # the moves in the order in which they are made

        self.button = tool_button(act=self.toggle, flat=True)
        self.slider = _StopsSlider()
        WORDS.name(self.slider, "slider")
        self.slider.valueChanged.connect(self._slid)
        self.slider.grasped.connect(self._grasped)
        self.slider.abandoned.connect(lambda: self._stand_at(self._before))
        self.slider.sliderPressed.connect(self._pressed)
        self.slider.sliderReleased.connect(self.gesture_finished)
        self._ends = in_row(self.slider)
        self._below = QGridLayout()
        self._below.setSpacing(0)
        self._below.setContentsMargins(0, 0, 0, 0)
        self._rows = 0  # rows of names: two where one row is too narrow
        self.stops: list[_Narrow] = []  # from the first one on
        self.direction = tool_button(act=self._turn, flat=True)
        self._columns = in_column(self._ends, self._below, gap=0)
        parts = self.button, self.direction, (self._columns, 1)
        in_row(*parts, on=self, margins=(4, 2, 4, 2), gap=2)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self.from_left = False
        self._make_stops()
        self._show_state()
        self._emitted = ("", "")  # nobody has heard it yet
        lettering.changed.connect(self._emit_title)

    # -- where it is

    @property
    def stop(self) -> int:
        """The nearest stop, whose axes and letters are shown."""
        return math.floor(self.position + 0.5)

    def go_to(self, position: float) -> None:
        """Go to a position, 0 to 5, as if the slider had been moved there."""
        self.pause()
        if position != self.position:
            self._stand_at(position)

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Name the stops, axes and limits of this projection."""
        self._projection = shown.projection
        lens, was_free = self._projection.lens, self._free
        self._free = lens.planes is None
        is_other = changed != {"lens"} or self._free != was_free
        tiles = self._projection.placement.on
        tiles = tiles if self.from_left else tiles[::-1]
        if lens.parallel != self._parallel or tiles != self._tiles:
            self._parallel, self._tiles, self.first = lens.parallel, tiles, WORLD - len(tiles)
            self._make_stops()
            is_other = True
            if self.position < self.first:
                self._stand_at(float(self.first))
        if is_other or self.stop == CANONICAL_PERSPECTIVE:  # which alone names near and far
            self._emit_title()

    def _turn(self) -> None:
        """Read the moves of object and camera from the other end."""
        self.from_left, self._tiles = not self.from_left, self._tiles[::-1]
        self._name_stops()
        self._emit_title()
        self.turned.emit(self.from_left)

    def _make_stops(self) -> None:
        """Make a name for each stop, as many as the object has moves."""
        count = IMAGE - self.first + 1
        if count != len(self.stops):
            discard(self._below, self.stops)
            self.stops = [_Narrow() for _ in range(count)]
            for stop, button in enumerate(self.stops, self.first):
                button.clicked.connect(partial(self.go_to, float(stop)))
            for half in range(2 * (MOST_TILES + len(STOPS))):
                self._below.setColumnStretch(half, int(half < 2 * count))
            with QSignalBlocker(self.slider):
                self.slider.setRange(self.first * STEPS, IMAGE * STEPS)
                self.slider.setValue(round(self.position * STEPS))
            self._rows = 0
            self._stagger(1)
            if self.isVisible():
                self._fit()
        self.direction.setVisible(bool(self._tiles))
        self._name_stops()
        self._show_stop()

    def _emit_title(self) -> None:
        """Emit stage, axes and limits if they have changed."""
        said = self._title(), self._words(self._projection)
        if said != self._emitted:
            self._emitted = said
            self.slider.setAccessibleDescription(f"{said[0]}: {said[1]}")
            self.named.emit(*said)

    def _name(self, stop: int) -> list[str]:
        if stop < WORLD and stop <= self.first:
            return WORDS["object"]
        if stop < WORLD:
            tile = self._tiles[stop - self.first - 1]
            title = with_comma(tile_title(tile.kind, tile.text[len(tile.kind) :]))
            return [called(tile.kind).replace("_", ""), WORDS.say("after", title)]
        if self._parallel and stop == CANONICAL_PERSPECTIVE:
            return [self._names[CANONICAL_PARALLEL][0], WORDS.say("no-pyramid")]
        if self._parallel and stop == CANONICAL_PARALLEL:
            return self._identity
        return self._names[stop]

    def _name_stops(self) -> None:
        self.direction.setText("→" if self.from_left else "←")
        tip = WORDS.say("left" if self.from_left else "right")
        set_tip(self.direction, tip)
        self.direction.setAccessibleName(tip)
        for stop, button in enumerate(self.stops, self.first):
            name, tip = self._name(stop)
            button.setText(name)
            set_tip(button, tip)

    def _title(self) -> str:
        parallel = WORDS.say("parallel")
        titles = {
            CANONICAL_PERSPECTIVE: parallel if self._parallel else WORDS.say("perspective"),
            CANONICAL_PARALLEL: parallel, NDC: WORDS.say("cube"),
        }  # fmt: skip
        if self._free and VIEW < self.position < NDC:
            return f"{self._names[VIEW][0]} → {self._names[NDC][0]}"
        if self.position == self.stop:
            return titles.get(self.stop, self._name(self.stop)[0])
        before = math.floor(self.position)
        if self._parallel and before == CANONICAL_PERSPECTIVE:  # where nothing moves
            return parallel
        if self._parallel and before == CANONICAL_PARALLEL:
            return f"{self._names[before][0]} → {self._names[NDC][0]}"
        return f"{self._name(before)[0]} → {self._name(before + 1)[0]}"

    def _words(self, projection: Projection) -> str:
        """Return axes and limits at this position, in few words."""
        stop, lens = self.stop, projection.lens
        if self.position < WORLD and stop < WORLD:
            text = self._name(stop)[1]
        elif stop == WORLD:
            text = WORDS.say("world")
        elif self._free and VIEW < stop < NDC:
            text = WORDS.say("no-volumes")
        elif stop == VIEW:
            text = WORDS.say("view" if self._free else "axes")
        elif stop == NDC:
            text = WORDS.say("ndc", *(f"{z:g}" for z in projection.depth_range))
        elif stop == IMAGE:
            text = WORDS.say("image", *projection.image_size)
        elif self._parallel and CANONICAL_PERSPECTIVE <= self.position <= CANONICAL_PARALLEL:
            text = WORDS.say("is-identity")
        elif self._parallel or stop == CANONICAL_PARALLEL:
            text = WORDS.say("box")
        elif lens.far == math.inf:
            text = WORDS.say("infinite")
        else:
            place = -lens.near / lens.far
            value = f"{place:.{digits_apart(place, -1.0, least=3)}g}"
            text = WORDS.say("pyramid").replace("{0}", value)
        return re.sub(r"(?<!\w)-", "−", in_letters(text, lettering.now))  # no hyphen of a word

    # -- playing

    def play(self) -> None:
        """Run from here to the picture with a rest at each stop; from the end, run all stages."""
        if not self.playing and not self.isHidden():
            self._set_playing(True)
            if self.position >= IMAGE:
                self._stand_at(float(self.first))
            self._rest_s = 0.0

    def advance(self, seconds: float) -> None:
        """Run for some seconds; while paused, do nothing."""
        while self.playing and seconds > 0.0:
            rest = min(self._rest_s, seconds)
            self._rest_s -= rest
            seconds -= rest
            if seconds <= 0.0:
                return
            stop = math.floor(self.position) + 1
            needed = (stop - self.position) * STEP_S
            if needed > seconds:
                self._stand_at(self.position + seconds / STEP_S)
                return
            seconds -= needed
            self._stand_at(float(stop))
            self._rest_s = REST_S
            if stop == IMAGE:
                self.pause()

    # -- kept together

    def _stand_at(self, position: float) -> None:
        """Go to any position, also between the slider's steps."""
        self.position = position
        with QSignalBlocker(self.slider):
            self.slider.setValue(round(position * STEPS))
        self._show_stop()
        self.moved.emit(position)

    def _slid(self, value: int) -> None:
        self.pause()
        stop = round(value / STEPS) * STEPS
        if self.slider.isSliderDown() and 0 < abs(value - stop) <= CATCH:
            self.slider.setValue(stop)  # calls this method again
            return
        if value != self.position * STEPS:
            self._stand_at(value / STEPS)

    def _grasped(self) -> None:
        self._before = self.position

    def _pressed(self) -> None:
        self.pause()
        self.gesture_started.emit()

    def _show_stop(self) -> None:
        for stop, button in enumerate(self.stops, self.first):
            button.setChecked(stop == self.position)
        self._emit_title()

    def _show_state(self) -> None:
        self._name_button(*map(WORDS.say, ("name", "play", "pause")))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange and self.layout() is not None:
            self._fit()

    def _fit(self) -> None:
        # The slider's ends are over the middles of the first and the last name.
        name_width = self._columns.geometry().width() // len(self.stops)
        style = self.slider.style()
        handle = style.pixelMetric(style.PixelMetric.PM_SliderLength, None, self.slider)
        margin = max(0, (name_width - handle) // 2)
        self._ends.setContentsMargins(margin, 0, margin, 0)
        self._fit_names(name_width)

    def _fit_names(self, width: int) -> None:
        """Write the names in one row or two, and smaller only where two rows are too narrow."""
        widths = [self.fontMetrics().horizontalAdvance(name) + 2 * GAP_PX for name in self._longest]
        self._stagger(1 if max(widths) <= width else 2)
        ends, inner = max(widths[0], widths[-1]), max(widths[1:-1])
        room = min(1.0, max(self._rows * width / inner, 1e-9))
        if self._rows == 2:
            room = min(room, 1.5 * width / ends)
        font = self.font()
        font.setPixelSize(max(8, int(room * self.fontInfo().pixelSize())))
        for button in self.stops:
            button.setFont(font)

    def _stagger(self, rows: int) -> None:
        """Put the names under their stops, every other name in a second row if there are two."""
        if rows == self._rows:
            return
        self._rows = rows
        halves = 2 * len(self.stops)
        for stop, button in enumerate(self.stops):
            first, beyond = max(0, 2 * stop - rows + 1), min(halves, 2 * stop + rows + 1)
            self._below.addWidget(button, stop % rows, first, 1, beyond - first)
        for button in self.stops:  # not after the first picture, which would be drawn again
            button.show()  # which may come back here

    @property
    def _longest(self) -> list[str]:
        """The longest name of each stop, whatever the lens."""
        names = [name for name, _ in self._names]
        names[CANONICAL_PARALLEL] = max(names[CANONICAL_PARALLEL], self._identity[0], key=len)
        return [self._name(stop)[0] for stop in range(self.first, WORLD)] + names

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self.pause()  # what nobody sees does not run


class _Narrow(QToolButton):
    """A name that may be narrower than its text."""

    def __init__(self) -> None:
        super().__init__(autoRaise=True)
        self.setCheckable(True)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # the slider's arrow keys reach all stops

    def minimumSizeHint(self) -> QSize:
        return QSize(0, super().minimumSizeHint().height())
