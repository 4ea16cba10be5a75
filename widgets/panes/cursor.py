"""A cursor that the keyboard moves over a pane: it clicks and drags as the mouse does.

::

    Page Down, Page Up         --> the next visible vertex, and hand.hovered
    Shift+Page Down, Page Up   --> the next handle, in the image also a probe
    Space                      --> hand.clicked
    Enter, arrows, Enter       --> hand.take_hold, hand.dragged, hand.drag_ended
    hand.dropped (Esc, or gone)--> hand.drag_ended

The cursor stands on a thing, not on a pixel: it moves with the thing when the model changes or the
pane is turned. It disappears when the focus leaves the pane, and costs nothing while it is hidden.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias, cast

from PySide6 import QtGui
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, Qt
from PySide6.QtWidgets import QApplication, QWidget

from app.model.projection import Vector
from app.picking.handles import Handle
from app.scenes.scene import Scene
from widgets.panes.canvas import ARROWS
from widgets.panes.manipulation import Manipulation
from widgets.panes.pane import Pane
from widgets.parts.labels import BesideLabel
from widgets.parts.messages import all_digits, read_text
from widgets.parts.panel import Changed, ShownData

STEP_PX, LONG_STEP_PX = 1.0, 10.0  # pixels that an arrow key drags by, without and with Shift
_RADIUS_EM = 1.1
_LINE_PX, _HELD_LINE_PX, _RIM_PX = 2.0, 4.0, 2.0
_GAP_PX = 2


@dataclass(frozen=True)
class Vertex:
    number: int


@dataclass(frozen=True)
class Followed:
    """The point of a probe."""

    number: int


Thing: TypeAlias = Handle | Vertex | Followed  # the cursor's place


class Cursor(QObject):
    """The cursor of one pane: it takes hold of handles, in the image also of probes."""

    concerns = frozenset({"scene"})

    def __init__(self, name: str, pane: Pane, manipulation: Manipulation) -> None:
        super().__init__(pane)
        self._name, self._pane, self._manipulation = name, pane, manipulation
        self._scene: Scene | None = None
        self._thing: Thing | None = None
        self._notice = ""  # a sentence instead of the cursor's place, until the next key
        self._is_there = self._is_dragging = self._is_shifted = False
        self._away = QPointF()
        self._why_closed = ""
        self._ring = _Ring(pane.canvas)
        self._label = BesideLabel(pane.canvas, "cursorLabel")
        pane.hand.dropped.connect(self.let_go)
        all_digits.changed.connect(self._follow)
        cast(QApplication, QApplication.instance()).focusChanged.connect(self._focus_moved)

    @property
    def text(self) -> str:
        """The text beside the cursor; empty while the cursor is hidden."""
        return self._label.text() if self._is_there else ""

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Let go, and forget the place, which belongs to another scene."""
        self._leave()
        self._scene, self._thing = shown.scene, None

    def close_for(self, why: str) -> None:
        """Show a reason instead of numbers; without one, show the numbers again."""
        self._why_closed = why
        self._follow()

    # -- keys

    def _focus_moved(self, left: QWidget | None, entered: QWidget | None) -> None:
        """Filter the canvas' events only while it has the focus: every repaint is an event."""
        canvas = self._pane.canvas
        if entered is canvas:
            canvas.installEventFilter(self)
        elif left is canvas:
            canvas.removeEventFilter(self)
            self._leave()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kinds, kind = QEvent.Type, event.type()
        if isinstance(event, QtGui.QKeyEvent) and self._pane.drawing is not None:
            if kind == kinds.ShortcutOverride and event.key() == Qt.Key.Key_Escape:
                if self._is_there and not self._is_dragging:
                    event.accept()  # before it removes a probe
                    return True
            elif kind == kinds.KeyPress and not self._pane.hand.is_down:
                return self._press(event)
        elif kind == kinds.FocusOut:
            self._leave()
        elif kind in (kinds.MouseButtonPress, kinds.Wheel, kinds.Gesture):
            self.let_go()
        return False

    def _press(self, event: QtGui.QKeyEvent) -> bool:
        keys, modifier = Qt.Key, Qt.KeyboardModifier
        key, modifiers = event.key(), event.modifiers() & ~modifier.KeypadModifier
        is_shifted = modifiers == modifier.ShiftModifier
        if modifiers and not is_shifted:
            return False
        self._notice = ""
        once = (keys.Key_Space, keys.Key_Return, keys.Key_Enter)
        if self._is_there and event.isAutoRepeat() and key in once:
            return True
        if self._is_dragging:
            if key in ARROWS:
                self._drag(*ARROWS[keys(key)], LONG_STEP_PX if is_shifted else STEP_PX)
            elif key in (keys.Key_Return, keys.Key_Enter):
                self.let_go()
            # Esc ends the drag, Tab moves the focus; all other keys would move the view.
            return key not in (keys.Key_Escape, keys.Key_Tab, keys.Key_Backtab)
        if key in (keys.Key_PageDown, keys.Key_PageUp):
            self._go(key == keys.Key_PageDown, to_hold=is_shifted)
        elif not self._is_there:
            return False
        elif key == keys.Key_Space and not is_shifted:
            self._pick()
        elif key in (keys.Key_Return, keys.Key_Enter):
            self._take_hold(is_shifted)
        elif key == keys.Key_Escape:
            self._leave()
            self._thing = None
        else:
            return False
        return True

    def _go(self, forwards: bool, *, to_hold: bool) -> None:
        """Go to the next thing, or to the one before."""
        thing = self._next_to_hold(forwards) if to_hold else self._next_vertex(forwards)
        if thing is not None:
            self._thing = thing
        if not self._is_there:
            self._is_there = True
            # Queued: the cursor cannot move while the picture is painted.
            self._pane.canvas.drawn.connect(self._follow, Qt.ConnectionType.QueuedConnection)
        if thing is None:
            self._notice = self.tr("No other vertex is visible")
            if to_hold:
                self._notice = self.tr("There is nothing else to drag")
        self._hover()
        self._speak()

    def _hover(self) -> QPointF | None:
        """Point at the thing, and at no other one that lies over it; return where it is."""
        spot, drawing = self._spot(), self._pane.drawing
        if spot is not None and drawing is not None:
            drawing.hold(self._thing if isinstance(self._thing, Handle) else None)
            self._pane.hand.at = None
            self._pane.hand.hovered.emit(spot)
        return spot

    def _next_vertex(self, forwards: bool) -> Vertex | None:
        from app.drawings.probes import next_vertex

        drawing, now = self._pane.drawing, self._pane.shown
        assert self._scene is not None and drawing is not None and now is not None
        at = self._thing.number if isinstance(self._thing, Vertex) else None
        shown = (self._scene, now.projection, drawing.sight, drawing.picture_rectangle_px)
        number = next_vertex(*shown, self._pane.canvas.pixel_ratio, at, forwards=forwards)
        return None if number is None else Vertex(number)

    def _next_to_hold(self, forwards: bool) -> Thing | None:
        things: Sequence[Thing] = ()
        drawing = self._pane.drawing
        if drawing is not None:
            drawing.hold(None)  # the held handle would be where it was
            things = [handle for handle, _ in drawing.handles.shown]
        if self._name == "image":
            followed = [Followed(probe.number) for probe in self._pane.probes if probe.number]
            things = [*things, *(each for each in followed if self._seen(each) is not None)]
        step, here = (1, -1) if forwards else (-1, 0)
        if self._thing in things:
            here = things.index(self._thing)
        following = things[(here + step) % len(things)] if things else None
        return None if following == self._thing else following

    def _pick(self) -> None:
        spot = self._spot()
        if spot is not None:
            self._pane.hand.clicked.emit(spot)

    def _take_hold(self, is_shifted: bool) -> None:
        if self._spot() is None:
            return
        if self._name == "image" and isinstance(self._thing, Vertex):
            # The drag moves the probe that follows this vertex.
            place = self._place(self._thing)
            probes = [p.number for p in self._pane.probes if p.number and p.point == place]
            self._thing = Followed(probes[-1]) if probes else self._thing
        spot = self._hover()  # the mouse may have moved since
        assert spot is not None
        self._is_dragging = self._pane.hand.take_hold(spot)
        if not self._is_dragging:
            self._notice = self.tr("There is nothing to drag here")
        self._is_shifted, self._away = is_shifted, QPointF()
        self._speak()

    def _drag(self, right: float, down: float, step_px: float) -> None:
        self._away += QPointF(right, down) * (step_px * self._pane.canvas.pixel_ratio)
        self._pane.hand.dragged.emit(self._away, self._is_shifted)
        line, reached = self._manipulation.line, self._manipulation.reached
        if line.isVisible():  # a refusal, beside which the label would say the value
            self._notice = line.text()
            line.hide()
        self._away = self._away if reached is None else reached  # the way back begins at the bound
        self._speak()

    def let_go(self) -> None:
        """End a drag at its present place."""
        if self._is_dragging:
            self._is_dragging = False
            self._pane.hand.drag_ended.emit()
            self._speak()

    def _leave(self) -> None:
        """Hide the cursor; the next key goes on from its place."""
        if self._is_there:
            self.let_go()
            self._is_there = False
            self._pane.canvas.drawn.disconnect(self._follow)
            self._ring.hide()
            self._label.hide()
            self._pane.hand.left.emit()

    # -- where it is

    def _place(self, thing: Thing | None) -> Vector | None:
        """Return the world coordinates of a vertex or a probe's point; None for a handle."""
        shown = self._pane.shown
        if isinstance(thing, Vertex) and self._scene is not None and shown is not None:
            from app.drawings.probes import vertex_of

            return vertex_of(self._scene, shown.projection, thing.number)
        if isinstance(thing, Followed):
            return next((p.point for p in self._pane.probes if p.number == thing.number), None)
        return None

    def _seen(self, thing: Thing | None) -> tuple[float, float] | None:
        """Return a thing's place in the pane, in device pixels; None if it is not visible."""
        drawing, place = self._pane.drawing, self._place(thing)
        x, y = math.nan, math.nan
        if drawing is None:
            return None
        if isinstance(thing, Handle):
            x, y = dict(drawing.handles.shown).get(thing, (x, y))
        elif place is not None:
            ((x, y),) = drawing.sight.seen([place]).tolist()
        size, ratio = self._pane.canvas.size(), self._pane.canvas.pixel_ratio
        inside = 0.0 <= x < size.width() * ratio and 0.0 <= y < size.height() * ratio
        return (x, y) if inside else None  # NaN: behind the pane's camera

    def _spot(self) -> QPointF | None:
        seen = self._seen(self._thing)
        return None if seen is None else QPointF(*seen)

    def _words(self) -> str:
        """Name the thing, and its coordinates or its value."""
        if self._why_closed:
            return self._why_closed
        thing, place = self._thing, self._place(self._thing)
        if isinstance(thing, Handle):
            return self._manipulation.now(thing)
        if place is None:
            return ""
        numbers = ", ".join(map(read_text, place))
        if isinstance(thing, Followed):
            return self.tr("Point {0} ({1})").format(thing.number, numbers)
        return self.tr("Vertex ({0})").format(numbers)

    def _follow(self) -> None:
        """Move to the present place of the thing."""
        if not self._is_there:
            return
        spot, canvas = self._spot(), self._pane.canvas
        self._ring.setVisible(spot is not None)
        around = canvas.rect().bottomLeft()
        if spot is not None:
            around = (spot / canvas.pixel_ratio).toPoint()
            self._ring.show_at(around, held=self._is_dragging)
        text = self._notice or self._words()
        if text != self._label.text():
            self._label.setText(text)
        self._label.setVisible(bool(text))
        if text:
            self._label.put_beside(around, self._ring.radius + _GAP_PX if spot is not None else 0)

    def _speak(self) -> None:
        self._follow()
        if self.text:
            event = QtGui.QAccessibleAnnouncementEvent(self._pane.canvas, self.text)
            QtGui.QAccessible.updateAccessibility(event)


class _Ring(QWidget):
    """A ring with a rim of another colour, visible on bright and on dark pictures."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("cursorRing")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._is_held = False
        self.hide()

    @property
    def radius(self) -> int:
        """With the rim; the ring grows with the font."""
        line_px = _HELD_LINE_PX + 2.0 * _RIM_PX
        return round(_RADIUS_EM * QtGui.QFontInfo(self.font()).pixelSize() + line_px / 2.0) + 1

    def show_at(self, centre: QPoint, *, held: bool) -> None:
        """Surround a place, with a thicker line while something is held."""
        side = 2 * self.radius + 1
        self.setGeometry(centre.x() - self.radius, centre.y() - self.radius, side, side)
        if held != self._is_held:
            self._is_held = held
            self.update()
        self.raise_()

    def paintEvent(self, event: QtGui.QPaintEvent) -> None:
        line_px = _HELD_LINE_PX if self._is_held else _LINE_PX
        painter, palette = QtGui.QPainter(self), self.palette()
        painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
        middle = QPointF(self.width() / 2.0, self.height() / 2.0)
        radius = _RADIUS_EM * QtGui.QFontInfo(self.font()).pixelSize()
        rim_px = line_px + 2.0 * _RIM_PX
        for brush, width_px in ((palette.base(), rim_px), (palette.text(), line_px)):
            painter.setPen(QtGui.QPen(brush.color(), width_px))
            painter.drawEllipse(middle, radius, radius)
        painter.end()
