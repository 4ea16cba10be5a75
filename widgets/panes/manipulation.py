"""Dragging the camera: its handles in the world pane, the picture in the image pane.

::

    hand.drag_started, dragged --> app.picking.handles --> edited, or setting_edited
                                         Refusal --> a sentence over the pane

A drag is a gesture, and so is a burst of wheel steps. A refusal lies over the pane: the window's
message bar would move the panes away from the mouse.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np
from PySide6.QtCore import QObject, QPointF, Qt, QTimer, Signal

from app.drawings.drawing import Drawing
from app.model.limits import OTHER_SIDE, vector
from app.model.projection import NOT_THE_EYE, Projection, Vector
from app.model.refusal import Refusal, six_digits
from app.picking.handles import (
    Change,
    Handle,
    Spot,
    changed,
    dollied,
    dragged,
    moved_by,
    moved_point,
    panned,
    place,
    present,
    slid_grip,
)
from app.picking.sight import Sight
from app.scenes.phenomena.marks import Grip
from app.scenes.phenomena.settings import Settings
from widgets.panes.canvas import ZOOM_PER_WHEEL_STEP
from widgets.panes.pane import Pane
from widgets.parts.escape import EscapeKey
from widgets.parts.gestures import Gestures
from widgets.parts.message_bar import MessageBar
from widgets.parts.messages import (
    field_name,
    of_phenomena,
    parameter_text,
    read_text,
    seen_from,
    sentence,
)
from widgets.parts.number_rows import QUIET_MS
from widgets.parts.panel import PROJECTION, Changed, ShownData
from widgets.parts.plain import PlainLabel, set_tip, wrapped

HOLD_WITHIN_PX = 12.0
"""Greatest distance from a handle at which it appears, and a drag takes hold of it."""


class Manipulation(Gestures, QObject):
    """Turns drags on handles and on the picture, and the wheel there, into projections."""

    concerns = PROJECTION | {"scene", "illustration", "settings"}
    edited = Signal(object)
    """The user made this `Projection`."""
    setting_edited = Signal(object)
    """The user gave settings of the scene these values, by name; the receiver may `refuse`."""

    def __init__(self, world: Pane, image: Pane, parent: QObject) -> None:
        super().__init__(parent)
        self._world, self._image = world, image
        self._projection = Projection()
        self._grips: dict[str, Grip] = {}
        self._values: Settings = {}
        self._labels: dict[str, str] = {}
        self._drag: _Drag | None = None
        self._in_gesture = False
        self._escape = EscapeKey(self)
        self._escape.pressed.connect(self._put_back)
        self._plain_tip = self.tr(
            "Drag a mark to move the eye, the target, a plane or a corner; drag elsewhere to turn, "
            "Shift-drag to move, wheel to zoom, double-click to reset (or Tab to here, and arrows, "
            "+ −, Home); click to follow a point"
        )
        self.message = MessageBar(world)
        """The present refusal."""
        self._line = PlainLabel(parent=world, wordWrap=True, margin=4)
        self._line.setObjectName("heldLine")
        self._line.setAutoFillBackground(True)
        self._line.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._line.hide()
        self._quiet = QTimer(self, singleShot=True, interval=QUIET_MS)
        self._quiet.timeout.connect(self._finish)
        set_tip(world.canvas, wrapped(self._plain_tip))
        hand = world.hand
        hand.hovered.connect(self._hover)
        hand.left.connect(self.leave)
        hand.drag_started.connect(self._take_handle)
        for pane in (world, image):
            pane.hand.dragged.connect(self._move)
            pane.hand.drag_ended.connect(self.let_go)
        image.hand.scrolled.connect(self._dolly)
        image.hand.pushed.connect(self._push)

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
            self._labels = {each.name: of_phenomena(each.title) for each in settings}
            if drag is not None and drag.held is not None and drag.held.setting not in self._grips:
                self._drop()  # another scene while dragging
        drawing = self._world.drawing
        if drawing is not None and drawing.handles.held is not None:
            if self.now(drawing.handles.held):
                self._describe_handle(drawing.handles.held)
            else:
                self._point_out(drawing, None)

    # -- what is under the mouse

    def _hover(self, pixel: QPointF) -> None:
        drawing = self._world.drawing
        if drawing is not None and self._drag is None:
            self._point_out(drawing, self._handle_at(drawing, pixel))

    def leave(self) -> None:
        """Highlight no handle: the mouse, or the handle's drawing, is gone."""
        drawing = self._world.drawing
        if drawing is not None and self._drag is None:
            self._point_out(drawing, None)

    def _handle_at(self, drawing: Drawing, pixel: QPointF) -> Handle | None:
        within_px = HOLD_WITHIN_PX * self._world.canvas.pixel_ratio
        return drawing.handle_at((pixel.x(), pixel.y()), within_px)

    def _point_out(self, drawing: Drawing, handle: Handle | None) -> None:
        said_of_another = handle is None and self.handle_text  # of an earlier drawing
        if handle == drawing.handles.held and not said_of_another:
            return
        drawing.hold(handle)
        self._world.canvas.redraw()
        canvas = self._world.canvas
        self._line.hide()
        if handle is None:
            canvas.unsetCursor()
            set_tip(canvas, wrapped(self._plain_tip))
            self._world.note.setText("")
            self._line.clear()
        else:
            canvas.setCursor(Qt.CursorShape.OpenHandCursor)
            self._describe_handle(handle)

    def _describe_handle(self, handle: Handle) -> None:
        """Show what a drag of a handle does, and the present value."""
        self._show_handle_text(f"{self._does(handle)[1]}: {self.now(handle)}")

    def now(self, handle: Handle) -> str:
        """Return a handle's field and value: ``Near = 4``; empty if the handle is gone."""
        if handle.name == "grip":
            grip = self._grips.get(handle.setting)
            return "" if grip is None else f"{self._labels[grip.setting]} = {_shown(_value(grip))}"
        projection = self._projection
        if handle.name == "object":
            drawing = self._world.drawing
            is_gone = drawing is None or not drawing.handles.has_object
        else:
            is_gone = not projection.has_camera
            if handle.face:
                is_gone = projection.lens.planes is None
        if is_gone:
            return ""
        values = present(projection, self._does(handle)[0])
        return ", ".join(f"{field_name(name)} = {_shown(value)}" for name, value in values.items())

    def _show_handle_text(self, text: str) -> None:
        """Show a text beside the pane's title, or in a line over the pane if that is too narrow.

        A text that needed the line keeps it, so that it does not jump while its numbers change.
        """
        set_tip(self._world.canvas, text)
        note, line, width = self._world.note, self._line, self._world.width()
        fits = note.fontMetrics().horizontalAdvance(text) <= note.width()
        in_line = self.message.isHidden() and (line.isVisible() or not fits)
        note.setText("" if in_line else text)
        line.setText(text if in_line else "")
        line.setVisible(in_line)
        if in_line:
            line.setGeometry(0, self._world.canvas.y(), width, line.heightForWidth(width))
            line.raise_()

    @property
    def handle_text(self) -> str:
        """The text about the handle under the mouse, or in the hand."""
        return self._line.text() or self._world.note.text()

    def _does(self, handle: Handle) -> tuple[tuple[str, ...], str]:
        if handle.name == "grip":
            grip = self._grips.get(handle.setting)
            if grip is not None and grip.along is not None:
                return (), self.tr("Drag the plane")
            return (), self.tr("Drag this point (Shift: up and down)")
        moved = moved_by(self._projection, handle)
        return tuple(each.name for each in moved), parameter_text(moved[0], moved[0].drag)

    # -- drags

    def _take_handle(self, pixel: QPointF) -> None:
        """Take hold of the handle at the start of a drag in the world pane."""
        drawing = self._world.drawing
        if drawing is None:
            return
        handle = self._handle_at(drawing, pixel)
        if handle is None:
            return
        self._point_out(drawing, handle)
        sight, drawn = drawing.sight, drawing.handles.planes_drawn
        held = self._grips.get(handle.setting)
        at = place(self._projection, handle, drawn) if held is None else held.point
        ((x_px, y_px),) = sight.seen([at]).tolist()
        taken, before = (handle, drawn, sight, (x_px, y_px)), self._values.get(handle.setting)
        self._start(_Drag(self._world, self._projection, taken, held, before))

    def take_picture(self, pixel: QPointF) -> None:
        """Take hold of the picture if a drag in the image pane starts on it."""
        drawing = self._image.drawing
        if drawing is not None and drawing.image_pixel(pixel.x(), pixel.y()):
            self._start(_Drag(self._image, self._projection))

    def _start(self, drag: _Drag) -> None:
        self._finish()
        self._drag = drag
        drag.pane.hand.keep_view()
        drag.pane.canvas.setCursor(Qt.CursorShape.ClosedHandCursor)
        self._escape.watch(drag.pane.window())
        self._begin()

    def _move(self, away: QPointF, shift: bool) -> None:
        drag = self._drag
        if drag is None:
            return
        right_px, down_px = away.x(), away.y()
        if drag.taken is not None:
            handle, drawn, sight, (x, y) = drag.taken
            pixel = x + right_px, y + down_px
            if drag.held is not None:
                self._drag_point(drag, drag.held, sight, pixel, shift=shift)
                return
            self._attempt(
                drag.pane, partial(dragged, drag.start, handle, drawn, sight, pixel, shift=shift)
            )
        elif drag.pane is self._image and drag.pane.drawing is not None:
            shift_px = drag.pane.drawing.image_shift(right_px, down_px)
            self._attempt(drag.pane, partial(panned, drag.start, shift_px))

    def _drag_point(
        self, drag: _Drag, held: Grip, sight: Sight, pixel: Spot, *, shift: bool
    ) -> None:
        before: Vector = tuple(held.point.tolist())
        self.message.hide()
        if held.along is not None:
            number = slid_grip(held.base, held.along, drag.before, sight, pixel)
            if number is not None:
                self.setting_edited.emit({held.setting: number})
            return
        point = moved_point(before, sight, pixel, shift)
        if point == before:  # dragged back
            self.setting_edited.emit({held.setting: drag.before})
        else:
            moved = replace(held, point=np.array(point))
            self.setting_edited.emit({held.setting: _value(moved)})

    def refuse(self, error: Refusal) -> None:
        """Say over the pane why a setting cannot have the dragged value."""
        self._refuse(self._world, error)

    def let_go(self) -> None:
        """End a drag; movements until the button is released have no effect."""
        if not self._escape.is_watched:
            return
        self._escape.leave()
        self._drop()
        self._image.canvas.unsetCursor()
        drawing = self._world.drawing
        if drawing is not None and drawing.handles.held is not None:
            self._world.canvas.setCursor(Qt.CursorShape.OpenHandCursor)
        self._finish()
        if drawing is not None and drawing.handles.held is not None:
            self._describe_handle(drawing.handles.held)  # instead of a refusal

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
        self.message.hide()
        if drag.held is not None:
            self.setting_edited.emit({drag.held.setting: drag.before})
        else:
            self.edited.emit(changed(self._projection, present(drag.start, drag.names)))
        self._drop()

    # -- the wheel, and keys for it

    def _dolly(self, steps: float) -> None:
        self._nudge(partial(dollied, self._projection, ZOOM_PER_WHEEL_STEP**-steps))

    def _push(self, way: QPointF) -> None:
        drawing = self._image.drawing
        if drawing is not None:
            self._nudge(partial(panned, self._projection, drawing.image_shift(way.x(), way.y())))

    def _nudge(self, make: Callable[[], Change]) -> None:
        """Make one of many small changes, which together are one step to undo."""
        if self._drag is None:
            self._begin()
            self._quiet.start()
            self._attempt(self._image, make)

    # -- edits

    def _begin(self) -> None:
        if not self._in_gesture:
            self._in_gesture = True
            self.gesture_started.emit()

    def _finish(self) -> None:
        self._quiet.stop()
        self.message.hide()
        if self._in_gesture:
            self._in_gesture = False
            self.gesture_finished.emit()

    def _attempt(self, pane: Pane, make: Callable[[], Change]) -> None:
        change: Change = {}
        try:
            change = make()
            if self._drag is not None:
                self._drag.names.update(change)
            projection = changed(self._projection, change)
        except Refusal as error:
            self._refuse(pane, _seen_from(change, error))
        else:
            self.message.hide()
            self.edited.emit(projection)

    def _refuse(self, pane: Pane, error: Refusal) -> None:
        bar, width = self.message, pane.width()
        self._line.hide()
        bar.setParent(pane)
        bar.show_message(sentence(six_digits(error)))
        layout = bar.layout()
        assert layout is not None
        bar.setGeometry(0, pane.canvas.y(), width, layout.totalHeightForWidth(width))
        bar.raise_()


@dataclass
class _Drag:
    """A drag, and the state at its start."""

    pane: Pane
    start: Projection
    taken: tuple[Handle, tuple[float, float], Sight, Spot] | None = None
    """Handle, drawn planes, the pane's sight and the handle's pixel; None for the picture."""
    held: Grip | None = None
    """The dragged setting at the start, and its value."""
    before: Any = None
    names: set[str] = field(default_factory=set)
    """The fields that the drag has changed."""


def _seen_from(change: Change, error: Refusal) -> Refusal:
    """Phrase a refusal for the field that was dragged."""
    side, _ = OTHER_SIDE.get(error.bound, ("", ""))
    value = change.get(side)
    if isinstance(value, float):
        return seen_from(side, "", value, error)
    if error.bound == NOT_THE_EYE and "eye" in change:
        return seen_from("eye", "", 0.0, error)
    return error


def _value(grip: Grip) -> Vector | float:
    """The setting that a grip stands for."""
    away = grip.point - grip.base
    if grip.along is not None:
        return float(away @ grip.along / np.dot(grip.along, grip.along))
    return vector(away)


def _shown(value: Any) -> str:
    if isinstance(value, tuple):
        return f"({', '.join(read_text(part) for part in value)})"
    return read_text(value)
