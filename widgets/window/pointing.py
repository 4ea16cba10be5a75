"""The crosshair in a picture, for a question that asks for a place."""

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from functools import partial

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, Qt
from PySide6.QtGui import QKeyEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from app.lessons.blocks.question import Value
from app.model.refusal import Refusal
from widgets.panes.canvas import ARROWS
from widgets.panes.cursor import LONG_STEP_PX, STEP_PX
from widgets.panes.pane import Pane
from widgets.window.lesson_blocks.marked import ClickView

ARM_PX, RING_PX = 14, 9  # half the crosshair's lines; the radius of the ring at the right place

NEAR_BY, NEWTON_STEPS = 1e-3, 5
"""A small step in a picture's coordinates, and how often it is used to find those of a click."""


class Cross(QWidget):
    """A crosshair, or a ring with a cross for the right place; visible on every picture."""

    def __init__(self, parent: QWidget, *, is_right: bool) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._is_right = is_right
        side = 2 * ARM_PX + 5
        self.resize(side, side)
        self.hide()

    def show_at(self, place: QPointF) -> None:
        self.move(place.toPoint() - QPoint(self.width() // 2, self.height() // 2))
        self.show()
        self.raise_()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter, palette = QPainter(self), self.palette()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        middle = QPointF(self.width() / 2.0, self.height() / 2.0)
        for brush, width in ((palette.base(), 5.0), (palette.text(), 2.0)):
            painter.setPen(QPen(brush.color(), width))
            if self._is_right:
                painter.drawEllipse(middle, RING_PX, RING_PX)
                painter.drawPoint(middle)
            else:
                for x, y in ((ARM_PX, 0), (0, ARM_PX)):
                    painter.drawLine(middle - QPointF(x, y), middle + QPointF(x, y))
        painter.end()


class Pointing(QObject):
    """Takes the clicks and the arrow keys of a pane for the question that is asked there."""

    def __init__(self, panes: Mapping[str, Pane], window: QWidget) -> None:
        super().__init__(window)
        self._panes = panes
        self._view: ClickView | None = None  # the question for which the crosshair is moved
        self._asked: Sequence[ClickView] = ()
        self._follows = False  # whether the crosshairs move with what the panes draw
        self._answered: ClickView | None = None
        self._at: QPointF | None = None  # the crosshair from the canvas' upper left, in Qt's pixels
        self._there: Value = ()  # the crosshair's place, with which it moves
        self._marks = {
            (name, is_right): Cross(pane.canvas, is_right=is_right)
            for name, pane in panes.items()
            for is_right in (False, True)
        }
        for name, pane in panes.items():
            pane.aimed.connect(partial(self._clicked, name))

    def aim(self, asked: Sequence[ClickView], answered: ClickView | None) -> None:
        """Take the places in pictures for these questions; mark the right place of another one."""
        for view in asked:
            if view not in self._asked:
                view.wanted.connect(partial(self._begin, view))
        before, self._follows = self._follows, bool(asked or answered)
        self._asked, self._answered = asked, answered
        if self._view not in asked:
            self._take_up(None)
        for name, pane in self._panes.items():
            pane.is_aimed_at = any(view.question.pane == name for view in asked)
            pane.canvas.removeEventFilter(self)
            if pane.is_aimed_at:
                pane.canvas.installEventFilter(self)
            if self._follows and not before:
                pane.canvas.drawn.connect(self._follow, Qt.ConnectionType.QueuedConnection)
            elif before and not self._follows:
                pane.canvas.drawn.disconnect(self._follow)
        self._follow()

    def _pane(self, view: ClickView) -> Pane | None:
        """Return the picture of a question if it shows the question's state, else None."""
        pane = self._panes[view.question.pane]
        is_shown = pane.shown is not None and pane.shown.document == view.played.here.document
        return pane if pane.drawing is not None and is_shown else None

    def _take_up(self, view: ClickView | None) -> None:
        """Move the crosshair for another question."""
        if view is not self._view:
            self._view, self._at = view, None

    def _clicked(self, name: str, place: QPointF) -> None:
        if self._view is None or self._view.question.pane != name:
            self._take_up(next(view for view in self._asked if view.question.pane == name))
        self._put(place / self._panes[name].canvas.pixel_ratio)
        if self._view is not None and self._view.first is not None:
            self._view.first.setFocus()

    def _begin(self, view: ClickView) -> None:
        """Give the keys to the picture, with the crosshair in its middle."""
        self._take_up(view)
        canvas = self._panes[view.question.pane].canvas
        canvas.setFocus()
        self._put(self._at or QPointF(canvas.rect().center()))

    def _put(self, place: QPointF) -> None:
        view = self._view
        if view is None:
            return
        pane = self._pane(view)
        if pane is None:
            view.show_other_state()
            return
        room = pane.canvas.rect()
        x = min(max(place.x(), 0.0), float(room.width()))
        y = min(max(place.y(), 0.0), float(room.height()))
        self._at, self._answered = QPointF(x, y), None
        self._there = self._place(pane, view, self._at)
        view.take(partial(self._away_px, view, self._at, self._there), self._there)
        self._follow()

    def _spot(self, view: ClickView, place: Value) -> QPointF | None:
        """Return where a place is seen, in the canvas' pixels; None if it is not."""
        pane = self._pane(view)
        if pane is None or pane.drawing is None:
            return None
        ((x, y),) = pane.drawing.spots_of(np.array([place])).tolist()
        return None if math.isnan(x) else QPointF(x, y) / pane.canvas.pixel_ratio

    def _place(self, pane: Pane, view: ClickView, at: QPointF) -> Value:
        """Return the place of a click near the right one, found by Newton's method.

        Empty if there is none: the way there leads where nothing is seen.
        """
        assert pane.drawing is not None
        place = np.array(view.question.answer(view.played.here))
        steps = np.vstack([np.zeros(len(place)), np.eye(len(place)) * NEAR_BY])
        for _ in range(NEWTON_STEPS):
            spots = pane.drawing.spots_of(place + steps) / pane.canvas.pixel_ratio
            if not np.isfinite(spots).all():
                return ()
            slopes = (spots[1:] - spots[0]).T / NEAR_BY
            place = place + np.linalg.pinv(slopes) @ ((at.x(), at.y()) - spots[0])
        return tuple(place.tolist())

    def _now(self, view: ClickView, at: QPointF, there: Value) -> QPointF:
        """Return where a click is by now: the picture may have another size."""
        return (self._spot(view, there) if there else None) or at

    def _away_px(self, view: ClickView, at: QPointF, there: Value, place: Value) -> float:
        """Return how far a click is from a place, in pixels of a screen with scale 1."""
        spot, at = self._spot(view, place), self._now(view, at, there)
        return math.inf if spot is None else math.hypot(spot.x() - at.x(), spot.y() - at.y())

    def _follow(self) -> None:
        """Show the crosshair of the question, and the right place of the answered one."""
        spots: dict[tuple[str, bool], QPointF | None] = {}
        asked, answered = self._view, self._answered
        if answered is not None:
            with suppress(Refusal):  # the lesson may have changed meanwhile
                place = answered.question.answer(answered.played.here)
                spots[answered.question.pane, True] = self._spot(answered, place)
        if asked is not None and self._at is not None and self._pane(asked) is not None:
            self._at = spots[asked.question.pane, False] = self._now(asked, self._at, self._there)
        for key, mark in self._marks.items():
            spot = spots.get(key)
            if spot is None:
                mark.hide()
            else:
                mark.show_at(spot)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        view = self._view
        if view is None or self._at is None or not isinstance(event, QKeyEvent):
            return False
        if watched is not self._panes[view.question.pane].canvas:
            return False
        modifiers = event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        is_shifted = modifiers == Qt.KeyboardModifier.ShiftModifier
        if event.type() != QEvent.Type.KeyPress or (modifiers and not is_shifted):
            return False
        key = Qt.Key(event.key())
        if key in ARROWS:
            step = LONG_STEP_PX if is_shifted else STEP_PX
            self._put(self._at + QPointF(*ARROWS[key]) * step)
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            view.check()
        elif key == Qt.Key.Key_Escape and view.first is not None:
            view.first.setFocus()
        else:
            return False
        return True
