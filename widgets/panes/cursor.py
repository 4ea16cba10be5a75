"""A cursor that the keyboard moves over a pane: another hand, which clicks and drags as the mouse.

::

    Page Down, Page Up         --> the next vertex that is seen in the pane, and hand.hovered
    Shift+Page Down, Page Up   --> the next thing to take hold of: a handle, in the image a probe
    Space                      --> hand.clicked
    Enter, arrows, Enter       --> hand.take_hold, hand.dragged, hand.drag_ended
    hand.dropped (Esc, or gone)--> hand.drag_ended

It stands on a thing, not on a pixel: it goes with it when the model changes or the pane is turned.
It costs nothing where it is not. It goes when the focus leaves the pane, and goes on from there.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeAlias, cast

from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, Qt
from PySide6.QtGui import (
    QAccessible,
    QAccessibleAnnouncementEvent,
    QFontInfo,
    QKeyEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QApplication, QWidget

from app.model.projection import Vector
from app.picking.handles import Handle
from widgets.panes.canvas import ARROWS
from widgets.panes.manipulation import Manipulation
from widgets.panes.pane import Pane
from widgets.parts.messages import read_text
from widgets.parts.panel import Changed, Shown
from widgets.parts.plain import Label
from widgets.parts.writing import all_digits

if TYPE_CHECKING:
    from app.scenes.scene import Scene

STEP_PX, LONG_STEP_PX = 1.0, 10.0
"""What an arrow drags by, without and with Shift."""
_RADIUS_EM = 1.1  # round a handle that is pointed out
_LINE_PX, _HELD_LINE_PX, _RIM_PX = 2.0, 4.0, 2.0
_GAP_PX = 2


@dataclass(frozen=True)
class Vertex:
    """A vertex of the scene's faces."""

    number: int


@dataclass(frozen=True)
class Followed:
    """A point that a probe follows."""

    number: int


Thing: TypeAlias = Handle | Vertex | Followed
"""What the cursor stands on."""


class Cursor(QObject):
    """The cursor of one pane.

    Parameters
    ----------
    name : str
        Of the pane: the world has handles, the image probes to take hold of.
    pane : Pane
    manipulation : Manipulation
        Says what a handle moves.

    Attributes
    ----------
    text : str
        What it says of where it is; nothing while it is not there.
    """

    concerns = frozenset({"scene"})

    def __init__(self, name: str, pane: Pane, manipulation: Manipulation) -> None:
        super().__init__(pane)
        self._name, self._pane, self._manipulation = name, pane, manipulation
        self._scene: Scene | None = None
        self._thing: Thing | None = None
        self._notice = ""
        """What is said in place of where it is, until the next key."""
        self._is_there = self._is_dragging = self._is_shifted = False
        self._away = QPointF()
        self._ring = _Ring(pane.canvas)
        self._label = Label(parent=pane.canvas, wordWrap=True, margin=3)
        self._label.setObjectName("cursorLabel")
        self._label.setAutoFillBackground(True)
        self._label.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._label.hide()
        pane.hand.dropped.connect(self.let_go)
        all_digits.changed.connect(self._follow)
        cast(QApplication, QApplication.instance()).focusChanged.connect(self._focus_moved)

    @property
    def text(self) -> str:
        return self._label.text() if self._is_there else ""

    def take(self, shown: Shown, changed: Changed) -> None:
        """Let go and forget where it was: of another scene all things are others."""
        self._leave()
        self._scene, self._thing = shown.scene, None

    # -- keys

    def _focus_moved(self, left: QWidget | None, entered: QWidget | None) -> None:
        """Have the canvas' keys while it has the focus: it is drawn at every step."""
        canvas = self._pane.canvas
        if entered is canvas:
            canvas.installEventFilter(self)
        elif left is canvas:
            canvas.removeEventFilter(self)
            self._leave()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kinds, kind = QEvent.Type, event.type()
        if isinstance(event, QKeyEvent) and self._pane.drawing is not None:
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

    def _press(self, event: QKeyEvent) -> bool:
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
            # Esc is the drag's, Tab takes the focus on; whatever else moves the view, which stays.
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
        """Go to the next thing, or the one before."""
        thing = self._next_to_hold(forwards) if to_hold else self._next_vertex(forwards)
        if thing is not None:
            self._thing = thing
        if not self._is_there:
            self._is_there = True
            # After the picture, in which it cannot be moved.
            queued = Qt.ConnectionType.QueuedConnection
            self._pane.canvas.drawn.connect(self._follow, queued)
        if thing is None:
            self._notice = (
                self.tr("There is nothing else to take hold of")
                if to_hold
                else self.tr("No other vertex is seen")
            )
        spot = self._spot()
        if spot is not None:
            self._pane.hand.hovered.emit(spot)
        self._follow()
        self._announce()

    def _next_vertex(self, forwards: bool) -> Vertex | None:
        from app.drawings.probes import next_vertex

        drawing = self._pane.drawing
        assert self._scene is not None and drawing is not None
        at = self._thing.number if isinstance(self._thing, Vertex) else None
        number = next_vertex(
            self._scene,
            self._pane.projection,
            drawing.sight,
            drawing.picture_rectangle_px,
            self._pane.canvas.pixel_ratio,
            at,
            forwards=forwards,
        )
        return None if number is None else Vertex(number)

    def _next_to_hold(self, forwards: bool) -> Thing | None:
        things: Sequence[Thing] = ()
        drawing = self._pane.drawing
        if self._name == "world" and drawing is not None:
            drawing.hold(None)  # or it would be the first of them, wherever it belongs
            things = [handle for handle, _ in drawing.handles_shown]
        elif self._name == "image":
            followed = [Followed(probe.number) for probe in self._pane.probes if probe.number]
            things = [each for each in followed if self._seen(each) is not None]
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
        spot = self._spot()
        if spot is None:
            return
        if self._name == "image" and isinstance(self._thing, Vertex):
            # It goes with the probe that follows its vertex, which is what is dragged there.
            place = self._place(self._thing)
            probes = [p.number for p in self._pane.probes if p.number and p.point == place]
            self._thing = Followed(probes[-1]) if probes else self._thing
        self._pane.hand.hovered.emit(spot)  # the mouse may have pointed at something else since
        self._is_dragging = self._pane.hand.take_hold(spot)
        if not self._is_dragging:
            self._notice = self.tr("There is nothing to take hold of at this place")
        self._is_shifted, self._away = is_shifted, QPointF()
        self._follow()
        self._announce()

    def _drag(self, right: float, down: float, step_px: float) -> None:
        self._away += QPointF(right, down) * (step_px * self._pane.canvas.pixel_ratio)
        self._pane.hand.dragged.emit(self._away, self._is_shifted)
        self._follow()
        self._announce()

    def let_go(self) -> None:
        """End a drag where it is."""
        if self._is_dragging:
            self._is_dragging = False
            self._pane.hand.drag_ended.emit()
            self._follow()
            self._announce()

    def _leave(self) -> None:
        """Be seen no more; the next key goes on from here."""
        if self._is_there:
            self.let_go()
            self._is_there = False
            self._pane.canvas.drawn.disconnect(self._follow)
            self._ring.hide()
            self._label.hide()
            self._pane.hand.left.emit()

    # -- where it is

    def _place(self, thing: Thing | None) -> Vector | None:
        """Where a vertex or a probe's point is in the world; None for what is no point."""
        if isinstance(thing, Vertex) and self._scene is not None:
            from app.drawings.probes import vertex_of

            return vertex_of(self._scene, self._pane.projection, thing.number)
        if isinstance(thing, Followed):
            return next((p.point for p in self._pane.probes if p.number == thing.number), None)
        return None

    def _seen(self, thing: Thing | None) -> tuple[float, float] | None:
        """Where a thing is seen in the pane, in device pixels; None where it is not."""
        drawing, place = self._pane.drawing, self._place(thing)
        x, y = math.nan, math.nan
        if drawing is None:
            return None
        if isinstance(thing, Handle):
            x, y = dict(drawing.handles_shown).get(thing, (x, y))
        elif place is not None:
            ((x, y),) = drawing.sight.seen([place]).tolist()
        size, ratio = self._pane.canvas.size(), self._pane.canvas.pixel_ratio
        inside = 0.0 <= x < size.width() * ratio and 0.0 <= y < size.height() * ratio
        return (x, y) if inside else None  # nor NaN, behind the pane's camera

    def _spot(self) -> QPointF | None:
        """Where the cursor is, in device pixels."""
        seen = self._seen(self._thing)
        return None if seen is None else QPointF(*seen)

    def _words(self) -> str:
        """What it stands on, and where that is, or which value it has."""
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
        """Be where its thing is now."""
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
            self._put_label(around, self._ring.radius + _GAP_PX if spot is not None else 0)

    def _put_label(self, around: QPoint, apart: int) -> None:
        """Beside the ring, below it or above, and inside the pane."""
        label, canvas = self._label, self._pane.canvas
        frame = 2 * label.margin() + 2
        wanted = label.fontMetrics().horizontalAdvance(label.text()) + frame
        width = min(wanted, canvas.width())
        height = label.heightForWidth(width)
        x, y = around.x() + apart, around.y() + apart
        if x + width > canvas.width():
            x = max(0, min(around.x() - apart, canvas.width()) - width)
        if y + height > canvas.height():
            y = max(0, around.y() - apart - height)
        label.setGeometry(x, y, width, height)
        label.raise_()

    def _announce(self) -> None:
        if self.text:
            event = QAccessibleAnnouncementEvent(self._pane.canvas, self.text)
            QAccessible.updateAccessibility(event)


class _Ring(QWidget):
    """A ring with a rim that stands out from it, on bright and on dark pictures."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("cursorRing")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._is_held = False
        self.hide()

    @property
    def radius(self) -> int:
        """Of all of it; text grows for a class, and so does the ring."""
        line_px = _HELD_LINE_PX + 2.0 * _RIM_PX
        return round(_RADIUS_EM * QFontInfo(self.font()).pixelSize() + line_px / 2.0) + 1

    def show_at(self, centre: QPoint, *, held: bool) -> None:
        """Lie round a place; thicker while it holds something."""
        side = 2 * self.radius + 1
        self.setGeometry(centre.x() - self.radius, centre.y() - self.radius, side, side)
        if held != self._is_held:
            self._is_held = held
            self.update()
        self.raise_()

    def paintEvent(self, event: QPaintEvent) -> None:
        line_px = _HELD_LINE_PX if self._is_held else _LINE_PX
        painter, palette = QPainter(self), self.palette()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        middle = QPointF(self.width() / 2.0, self.height() / 2.0)
        radius = _RADIUS_EM * QFontInfo(self.font()).pixelSize()
        for brush, width_px in (
            (palette.base(), line_px + 2.0 * _RIM_PX),
            (palette.text(), line_px),
        ):
            painter.setPen(QPen(brush.color(), width_px))
            painter.drawEllipse(middle, radius, radius)
        painter.end()
