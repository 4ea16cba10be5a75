"""Dragging the model: what can be taken in each pane, and the picture in the image pane.

::

    hand.drag_started, dragged --> app.picking.handles --> edited, or setting_edited
                                         Refusal --> a line at the thing, which stops at the bound

A drag is a gesture, and so is a burst of wheel steps. A line lies beside the thing in the pane: the
window's message bar would move the panes away from the mouse.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache, partial
from typing import Any, NamedTuple

import numpy as np
from PySide6.QtCore import QObject, QPointF, Qt, QTimer, Signal
from PySide6.QtGui import QCursor, QPainter, QPen, QPixmap, QPolygonF

from app.drawings.drawing import Taken
from app.languages import listed
from app.lecture.highlight import WINDOW
from app.model.limits import OTHER_SIDE, vector
from app.model.parameter import Settings
from app.model.projection import Array, Projection, Vector
from app.model.refusal import REFUSALS, Refusal, six_digits
from app.picking import handles
from app.picking.handles import Change, Handle, Spot, changed, way
from app.picking.sight import Sight, heading
from app.scenes.phenomena.marks import Grip
from widgets.panes.canvas import ZOOM_PER_WHEEL_STEP
from widgets.panes.pane import Pane, named_on
from widgets.parts import messages
from widgets.parts.gestures import EscapeKey, Gestures
from widgets.parts.labels import BesideLabel
from widgets.parts.number_rows import QUIET_MS
from widgets.parts.panel import PROJECTION, Changed, ShownData
from widgets.parts.plain import set_tip

HOLD_WITHIN_PX = 12.0  # greatest distance from a probe's mark at which a drag takes hold of it
_APART_PX = 16
_LETTERS = {side: letter for letter, side in WINDOW.items()}
_HALVINGS = 6  # how often the way of a refused drag is halved, to stop it at the bound


class Manipulation(Gestures, QObject):
    """Turns drags on handles and on the picture, and the wheel there, into projections."""

    concerns = PROJECTION | {"scene", "illustration", "settings"}
    edited = Signal(object)  # the user made this `Projection`
    setting_edited = Signal(object)
    """The user gave settings of the scene these values, by name; the receiver may `refuse`."""

    def __init__(self, panes: Mapping[str, Pane], parent: QObject) -> None:
        super().__init__(parent)
        self._panes, self._pane, self._image = panes, panes["world"], panes["image"]
        """Where the pointer is, or was last; where the picture is dragged."""
        self._projection = Projection()
        self._grips: dict[str, Grip] = {}
        self._values: Settings = {}
        self._labels: dict[str, str] = {}
        self._drag: _Drag | None = None
        self._pointed: Handle | None = None
        self._refused: Refusal | None = None
        self._in_gesture = False
        self._escape = EscapeKey(self)
        self._escape.pressed.connect(self._put_back)
        self.line = BesideLabel(self._pane.canvas, "heldLine")
        """The value of what is dragged, or the present refusal, beside the thing."""
        self._quiet = QTimer(self, singleShot=True, interval=QUIET_MS)
        self._quiet.timeout.connect(self._finish)
        for name, pane in panes.items():
            pane.hand.hovered.connect(partial(self._hover, name))
            pane.hand.left.connect(self.leave)
            pane.hand.dragged.connect(self._move)
            pane.hand.drag_ended.connect(self.let_go)
            if pane is not self._image:
                pane.hand.drag_started.connect(partial(self.take_handle, name))
        self._image.hand.scrolled.connect(self._dolly)
        self._image.hand.pushed.connect(self._push)

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Keep the values with which the next drag begins."""
        if "scene" in changed:
            self.let_go()
        projection, drag = shown.projection, self._drag
        if projection.lens.kind != self._projection.lens.kind:
            self._drop()  # undone or reset while dragging: the fields are gone
        self._projection = projection
        if changed & {"illustration", "settings"}:
            self._values = shown.document.settings
            grips = () if shown.illustration is None else shown.illustration.grips
            self._grips = {grip.setting: grip for grip in grips}
            phenomenon = shown.scene.phenomenon
            settings = () if phenomenon is None else phenomenon.settings
            self._labels = {each.name: messages.of_phenomena(each.title) for each in settings}
            if drag is not None and drag.held is not None and drag.held.setting not in self._values:
                self._drop()  # another scene while dragging; a grip alone may come back
        if self._pointed is not None:
            if self.now(self._pointed):
                self._describe()
            else:
                self._point_out(self._pane, None)

    @property
    def reached(self) -> QPointF | None:
        """How far the model has allowed the drag to go; None if nothing is dragged."""
        return None if self._drag is None else QPointF(self._drag.reached)

    # -- what is under the mouse

    def _hover(self, name: str, pixel: QPointF) -> None:
        pane = self._panes[name]
        if self._drag is None and pane.drawing is not None:
            self._point_out(pane, pane.drawing.handles.at((pixel.x(), pixel.y())))

    def leave(self) -> None:
        """Highlight no handle: the mouse, or the handle's drawing, is gone."""
        if self._drag is None:
            self._point_out(self._pane, None)

    def _point_out(self, pane: Pane, taken: Taken | None) -> None:
        if pane is not self._pane and self._pointed is not None:
            self._point_out(self._pane, None)
        handle = None if taken is None else taken.handle
        drawing, self._pane = pane.drawing, pane
        is_new = drawing is not None and drawing.handles.held != handle
        if handle == self._pointed and not is_new:
            return
        self._pointed = handle
        if drawing is not None and is_new:
            drawing.hold(handle)
            pane.canvas.redraw()
        self.line.hide()
        if taken is None:
            pane.canvas.unsetCursor()
            set_tip(pane.canvas, pane.hand.tip)
        else:
            self._show_pointer(pane, taken)
            self._describe()

    def _show_pointer(self, pane: Pane, taken: Taken) -> None:
        """Turn the pointer along the way that a handle can go."""
        grip, drawing = self._grips.get(taken.handle.setting), pane.drawing
        along = way(self._projection, taken.handle, taken.point)
        if taken.handle.name == "grip":
            along = None if grip is None or grip.along is None else heading(grip.along, grip.point)
        if along is None or drawing is None:
            pane.canvas.setCursor(Qt.CursorShape.SizeAllCursor)
        else:
            right, down = drawing.sight.way_px(taken.point, along)
            pane.canvas.setCursor(_arrow_cursor(right, down, pane.devicePixelRatioF()))

    def _describe(self) -> None:
        """Say what a drag of a handle does, and the present value."""
        handle = self._pointed
        if handle is not None:
            set_tip(self._pane.canvas, f"{self._does(handle)[1]}: {self.now(handle)}")

    def now(self, handle: Handle) -> str:
        """Return a handle's field and value: ``Near = 4``; empty if the handle is gone."""
        if handle.name == "grip":
            grip = self._grips.get(handle.setting)
            return "" if grip is None else f"{self._labels[grip.setting]} = {_shown(_value(grip))}"
        projection = self._projection
        if handle.name == "object":
            drawing = self._pane.drawing
            is_gone = drawing is None or not drawing.handles.has_object
        else:
            is_gone = projection.lens.planes is None if handle.face else not projection.has_camera
        if is_gone:
            return ""
        values = handles.present(projection, self._does(handle)[0])
        return ", ".join(
            f"{messages.field_name(name)} = {_shown(value)}" for name, value in values.items()
        )

    def _show_line(self, pane: Pane, text: str) -> None:
        """Show a line beside the thing that is dragged, or in the middle of the picture."""
        canvas, drawing, drag = pane.canvas, pane.drawing, self._drag
        at = math.nan, math.nan
        if self._pointed is not None and drawing is not None:
            at = dict(drawing.handles.shown).get(self._pointed, at)
        if drag is not None and drag.taken is not None and not math.isfinite(sum(at)):
            at = drag.taken.spot[0] + drag.reached.x(), drag.taken.spot[1] + drag.reached.y()
        around = canvas.rect().center()
        if math.isfinite(sum(at)):
            around = (QPointF(*at) / canvas.pixel_ratio).toPoint()
        self.line.setParent(canvas)
        self.line.setText(text)
        self.line.put_beside(around, _APART_PX, above=True, off=named_on(canvas, pane)[0])
        self.line.show()

    def _say(self, pane: Pane, error: Refusal) -> None:
        """Say the bound in one line, without the reason that may follow it."""
        self._show_line(pane, ": ".join(messages.sentence(six_digits(error)).split(": ")[:2]))

    def _is_written(self, handle: Handle, pane: Pane) -> bool:
        """Whether names in a pane say all values that a handle of a plane moves."""
        keys = [_LETTERS.get(name, name) for name in self._does(handle)[0] if handle.face]
        drawing = pane.drawing if keys else None
        return drawing is not None and all(map(drawing.board.writes_value, keys))

    def _does(self, handle: Handle) -> tuple[tuple[str, ...], str]:
        if handle.name == "grip":
            grip = self._grips.get(handle.setting)
            if grip is not None and grip.along is not None:
                return (), self.tr("Drag along its way")
            return (), self.tr("Drag this point (Shift: up and down)")
        moved = handles.moved_by(self._projection, handle)
        return tuple(each.name for each in moved), messages.parameter_text(moved[0], moved[0].drag)

    # -- drags

    def take_handle(self, name: str, pixel: QPointF) -> bool:
        """Take hold of what lies where a drag starts; return whether there is anything."""
        pane = self._panes[name]
        drawing, start = pane.drawing, (pixel.x(), pixel.y())
        taken = None if drawing is None else drawing.handles.at(start)
        if taken is None or drawing is None:
            return False
        ((x_px, y_px),) = drawing.sight.seen([taken.point]).tolist()
        if not math.isfinite(x_px + y_px):  # by the label of what is behind the pane's camera
            return False
        self._point_out(pane, taken)
        handle, held = taken.handle, self._grips.get(taken.handle.setting)
        before = self._values.get(handle.setting)
        if held is not None and held.along is not None:  # the rail runs through the grabbed point
            base = vector(held.base + (taken.point - held.point))
            before = _value(held)
            held = replace(held, base=base, point=taken.point)
        drawn = drawing.handles.planes_drawn
        of_handle = _TakenAt(handle, taken.point, drawn, drawing.sight, (x_px, y_px))
        self._start(_Drag(pane, self._projection, of_handle, held, before))
        return True

    def take_picture(self, pixel: QPointF) -> None:
        """Take hold of what lies where a drag in the image pane starts, or of the picture."""
        drawing = self._image.drawing
        is_taken = self.take_handle("image", pixel)
        if not is_taken and drawing is not None and drawing.image_pixel(pixel.x(), pixel.y()):
            self._start(_Drag(self._image, self._projection))

    def _start(self, drag: "_Drag") -> None:
        self._finish()
        self._drag = drag
        drag.pane.hand.keep_view()
        if drag.taken is None:
            drag.pane.canvas.setCursor(Qt.CursorShape.ClosedHandCursor)
        self._escape.watch(drag.pane.window())
        self._begin()

    def _move(self, away: QPointF, shift: bool) -> None:
        """Drag as far as the model allows on the way to the mouse."""
        drag = self._drag
        if drag is None:
            return
        self.line.hide()
        error = self._refusal_of(drag, away, shift)
        if error is None or self._drag is None:
            drag.reached = away
            pointed = self._pointed if self._drag is not None else None
            # The keyboard's cursor has a label of its own.
            if pointed and drag.pane.hand.is_down and not self._is_written(pointed, drag.pane):
                self._show_line(drag.pane, self.now(pointed))
            return
        step = away - drag.reached
        for _ in range(_HALVINGS):
            step /= 2.0
            if self._refusal_of(drag, drag.reached + step, shift) is None:
                drag.reached += step
        self._say(drag.pane, error)

    def _refusal_of(self, drag: "_Drag", away: QPointF, shift: bool) -> Refusal | None:
        """Drag by so many pixels, or return why the model cannot."""
        right_px, down_px = away.x(), away.y()
        if drag.taken is not None:
            handle, grabbed, drawn, sight, (x, y) = drag.taken
            pixel = x + right_px, y + down_px
            if drag.held is not None:
                return self._drag_point(drag, drag.held, pixel, shift=shift)
            return self._attempt(
                partial(
                    handles.dragged, drag.start, handle, grabbed, drawn, sight, pixel, shift=shift
                )
            )
        if drag.pane.drawing is None:
            return None
        shift_px = drag.pane.drawing.image_shift(right_px, down_px)
        return self._attempt(partial(handles.panned, drag.start, shift_px))

    def _drag_point(self, drag: "_Drag", held: Grip, pixel: Spot, *, shift: bool) -> Refusal | None:
        assert drag.taken is not None
        before, sight = vector(held.point), drag.taken.sight
        value: Vector | float | None
        if held.along is not None:
            value = handles.slid_grip(held.base, held.along, drag.before, held.point, sight, pixel)
        else:
            point = handles.moved_point(before, sight, pixel, shift)
            moved = replace(held, point=np.array(point))
            value = drag.before if point == before else _value(moved)  # dragged back
        self._refused = None
        if value is not None:
            self.setting_edited.emit({held.setting: value})
        return self._refused

    def refuse(self, error: Refusal) -> None:
        """A setting cannot have the dragged value."""
        self._refused = error

    def let_go(self) -> None:
        """End a drag; movements until the button is released have no effect."""
        if not self._escape.is_watched:
            return
        self._escape.leave()
        self._drop()
        if self._pointed is None:
            self._image.canvas.unsetCursor()
        self._finish()

    def _drop(self) -> None:
        """Forget the drag, and tell the hand."""
        drag, self._drag = self._drag, None
        if drag is not None:
            drag.pane.hand.dropped.emit()

    def _put_back(self) -> None:
        """Cancel the drag, and restore the values before it."""
        drag = self._drag
        if drag is None:
            return
        self.line.hide()
        if drag.held is not None:
            self.setting_edited.emit({drag.held.setting: drag.before})
        else:
            self.edited.emit(changed(self._projection, handles.present(drag.start, drag.names)))
        self.gesture_abandoned.emit()  # what follows a value would come back but for its rounding
        self._drop()

    # -- the wheel, and keys for it

    def _dolly(self, steps: float) -> None:
        self._nudge(partial(handles.dollied, self._projection, ZOOM_PER_WHEEL_STEP**-steps))

    def _push(self, way: QPointF) -> None:
        drawing = self._image.drawing
        if drawing is not None:
            self._nudge(
                partial(handles.panned, self._projection, drawing.image_shift(way.x(), way.y()))
            )

    def _nudge(self, make: Callable[[], Change]) -> None:
        """Make one of many small changes, which together are one step to undo."""
        if self._drag is None:
            self._begin()
            self._quiet.start()
            self.line.hide()
            error = self._attempt(make)
            if error is not None:
                self._say(self._image, error)

    # -- edits

    def _begin(self) -> None:
        if not self._in_gesture:
            self._in_gesture = True
            self.gesture_started.emit()

    def _finish(self) -> None:
        self._quiet.stop()
        self.line.hide()
        if self._in_gesture:
            self._in_gesture = False
            self.gesture_finished.emit()

    def _attempt(self, make: Callable[[], Change]) -> Refusal | None:
        change: Change = {}
        try:
            change = make()
            if self._drag is not None:
                self._drag.names.update(change)
            projection = changed(self._projection, change)
        except Refusal as error:
            kept = handles.present(self._projection, change)
            moved = {name: value for name, value in change.items() if value != kept[name]}
            return _seen_from(moved, error)
        self.edited.emit(projection)
        return None


class _TakenAt(NamedTuple):
    """What was taken, and how the pane looked at it then."""

    handle: Handle
    grabbed: Array
    drawn: tuple[float, float]
    sight: Sight
    spot: Spot


@dataclass
class _Drag:
    pane: Pane
    start: Projection
    taken: _TakenAt | None = None  # None for the picture
    held: Grip | None = None  # the dragged setting at the start, and its value
    before: Any = None
    names: set[str] = field(default_factory=set)  # the fields that the drag has changed
    reached: QPointF = field(default_factory=QPointF)  # the last movement that the model allowed


def _seen_from(change: Change, error: Refusal) -> Refusal:
    """Phrase a refusal for the field that was dragged."""
    side, _ = OTHER_SIDE.get(error.bound, ("", ""))
    value = change.get(side)
    if isinstance(value, float):
        return messages.seen_from(side, "", value, error)
    if error.bound == REFUSALS["not-the-eye"] and "eye" in change:
        return messages.seen_from("eye", "", 0.0, error)
    return error


def _value(grip: Grip) -> Vector | float:
    away = grip.point - grip.base
    if grip.along is not None:
        way = heading(grip.along, grip.point)
        return float(away @ way / (way @ way))
    return vector(away)


def _shown(value: Any) -> str:
    if isinstance(value, tuple):
        return f"({listed(map(messages.read_text, value))})"
    return messages.read_text(value)


# -- the mouse pointer over a handle that can be dragged along one line

_SIDE, _STEP_DEG = 32, 5
_HALF = (13.0, 0.0), (7.0, -5.5), (7.0, -1.4), (-7.0, -1.4), (-7.0, -5.5), (-13.0, 0.0)
_ARROW = [QPointF(*end) for end in (*_HALF, *((x, -y) for x, y in _HALF[::-1]))]


def _arrow_cursor(right: float, down: float, ratio: float) -> QCursor:
    """A double arrow along a direction of the screen; upright for none."""
    is_seen = math.isfinite(right + down) and (right, down) != (0.0, 0.0)
    turn_deg = math.degrees(math.atan2(down, right)) if is_seen else 90.0
    return _turned(round(turn_deg / _STEP_DEG) * _STEP_DEG % 180, ratio)


@lru_cache(maxsize=64)
def _turned(turn_deg: int, ratio: float) -> QCursor:
    pixmap = QPixmap(round(_SIDE * ratio), round(_SIDE * ratio))
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(Qt.GlobalColor.transparent)
    with QPainter(pixmap) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.translate(_SIDE / 2.0, _SIDE / 2.0)
        painter.rotate(turn_deg)
        painter.setPen(QPen(Qt.GlobalColor.white, 1.5))
        painter.setBrush(Qt.GlobalColor.black)
        painter.drawPolygon(QPolygonF(_ARROW))
    return QCursor(pixmap)
