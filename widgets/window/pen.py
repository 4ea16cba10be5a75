"""A pen on the slide: what is drawn belongs to the step, and can be kept for the handout.

::

    mouse, key --Pen--> strokes of the step --keep--> the file beside the talk --> the handout
"""

import math
from collections.abc import Callable, Iterable
from functools import partial

from PySide6 import QtGui
from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, Qt, Signal
from PySide6.QtWidgets import QApplication, QFrame, QToolButton, QWidget

from app.drawings.style import LIGHT, Style
from app.lessons.strokes import COLOURS, Stroke
from widgets.parts.layouts import in_row, tool_button
from widgets.parts.wording import Wording

WORDS = Wording(__file__)
WIDTH_SHARE = 0.005  # width of a line, in heights of the slide
ERASER_SHARE = 0.02  # reach of the eraser, in heights of the slide
_KEYS = Qt.Key


def paint_strokes(
    painter: QtGui.QPainter, room: QRectF, strokes: Iterable[Stroke], style: Style = LIGHT
) -> None:
    """Draw strokes over a slide that fills a rectangle."""
    painter.save()
    painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
    for stroke in strokes:
        pen = QtGui.QPen(QtGui.QColor(getattr(style, stroke.colour)), WIDTH_SHARE * room.height())
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        painter.setPen(pen)
        places = [
            QPointF(room.left() + x * room.width(), room.top() + y * room.height())
            for x, y in stroke.points
        ]
        if len(places) == 1:
            painter.drawPoint(places[0])
        else:
            painter.drawPolyline(places)
    painter.restore()


class Pen(QWidget):
    """Lies over the slide, and takes the mouse while it draws.

    `strokes` are by the names of the steps and of the pictures of their answers; so are `pictures`,
    the slides with the strokes that were drawn since the talk was opened. If it `erases`, the mouse
    removes the strokes that it touches.
    """

    kept = Signal()  # the speaker wants the strokes in the handout
    drawn = Signal()  # the strokes of the step have changed
    switched = Signal(bool)  # the pen was taken up, or put away

    def __init__(self, slide: QWidget) -> None:
        super().__init__(slide)
        self.setAccessibleName(WORDS.say("name"))
        self._slide = slide
        self.strokes: dict[str, list[Stroke]] = {}
        self.pictures: dict[str, QtGui.QImage] = {}
        self.is_on = self.erases = False
        self.colour = COLOURS[1]
        self._step = ""
        self._drawn: list[tuple[float, float]] = []  # the stroke that is being drawn
        self._style = LIGHT
        self._acts: dict[int, Callable[[], object]] = {
            _KEYS.Key_E: self.switch_eraser,
            _KEYS.Key_X: self.next_colour,
            _KEYS.Key_Delete: self.clear,
            _KEYS.Key_Backspace: self.undo,
            _KEYS.Key_K: self.kept.emit,
            _KEYS.Key_Escape: partial(self.switch, False),
        }
        self._bar = self._make_bar()
        self.switch(False)

    def _make_bar(self) -> QFrame:
        """Make the bar, of which only the dot of the colour is seen until the mouse is on it."""
        bar = QFrame(self)
        bar.setObjectName("card")
        self.dot = tool_button("●", WORDS.say("dot"))
        self.colours: dict[str, QToolButton] = {
            name: tool_button(
                "●", WORDS.say(name), partial(self.take, name), name=WORDS.say(name), checkable=True
            )
            for name in COLOURS
        }
        self.eraser = WORDS.tool("eraser", self.switch_eraser, checkable=True)
        acts = {"undo": self.undo, "clear": self.clear, "keep": self.kept.emit}
        others = (WORDS.tool(key, act) for key, act in acts.items())
        self._tools = (*self.colours.values(), self.eraser, *others)
        in_row(*self._tools, self.dot, on=bar, margins=(2, 2, 2, 2), gap=4)
        for button in bar.findChildren(QToolButton):
            button.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        bar.installEventFilter(self)
        self.dot.clicked.connect(partial(self._unfold, True))  # a finger has no place before
        return bar

    def _unfold(self, unfolded: bool) -> None:
        """Show all of the bar, or the dot alone."""
        for tool in self._tools:
            tool.setVisible(unfolded)
        self.dot.setVisible(not unfolded)
        self._show_bar()

    # -- the step

    def show_step(self, step: str) -> None:
        self._finish()
        self._step = step
        self.update()
        self.raise_()

    def begin_talk(self, strokes: dict[str, list[Stroke]]) -> None:
        """Forget all strokes but those that were kept of another talk."""
        self.strokes = strokes
        self.pictures.clear()
        self.update()

    @property
    def here(self) -> list[Stroke]:
        return self.strokes.get(self._step, [])

    # -- what the speaker does

    def switch(self, on: bool) -> None:
        """Take the pen up, or put it away; the strokes stay."""
        self._finish()
        changed, self.is_on = on != self.is_on, on
        self.erases = False
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents, not on)
        self.setCursor(Qt.CursorShape.CrossCursor)
        self._bar.setVisible(on)
        self._unfold(False)
        application = QApplication.instance()
        assert application is not None
        if changed:
            (application.installEventFilter if on else application.removeEventFilter)(self)
        if on:
            self.raise_()
            self.setFocus(Qt.FocusReason.OtherFocusReason)
        elif self.hasFocus():
            self.window().setFocus()
        if changed:
            self.switched.emit(on)

    def take(self, colour: str) -> None:
        self.colour, self.erases = colour, False
        self._show_bar()

    def next_colour(self) -> None:
        self.take(COLOURS[(COLOURS.index(self.colour) + 1) % len(COLOURS)])

    def switch_eraser(self) -> None:
        self.erases = not self.erases
        self._show_bar()

    def undo(self) -> None:
        self._finish()
        if self.here:
            self.here.pop()
            self._show_strokes()

    def clear(self) -> None:
        self._drawn = []
        self.strokes.pop(self._step, None)
        self._show_strokes()

    def _show_strokes(self) -> None:
        """Show the strokes of the step, and take a picture of the slide with them."""
        if self.here:
            self._bar.hide()
            self.pictures[self._step] = self._slide.grab().toImage()
            self._bar.setVisible(self.is_on)
        else:
            self.pictures.pop(self._step, None)
        self.update()
        self.drawn.emit()

    def _show_bar(self) -> None:
        for name, button in self.colours.items():
            button.setChecked(name == self.colour and not self.erases)
            button.setStyleSheet(f"color: {getattr(self._style, name)}")
        self.dot.setText("◯" if self.erases else "●")
        self.dot.setStyleSheet(f"color: {getattr(self._style, self.colour)}")
        self.eraser.setChecked(self.erases)
        layout = self._bar.layout()
        assert layout is not None
        layout.activate()  # with the buttons that are there now
        size = self._bar.sizeHint()
        room = self._slide.size() - size
        self._bar.setGeometry(room.width(), room.height(), size.width(), size.height())

    def set_style(self, style: Style) -> None:
        self._style = style
        self._show_bar()
        self.update()

    # -- events

    def _at(self, place: QPointF) -> tuple[float, float]:
        x, y = place.x() / max(1, self.width()), place.y() / max(1, self.height())
        return min(1.0, max(0.0, x)), min(1.0, max(0.0, y))

    def mousePressEvent(self, event: QtGui.QMouseEvent) -> None:
        event.accept()
        self._bar.hide()
        if event.button() == Qt.MouseButton.RightButton or self.erases:
            self._erase(event.position())
        else:
            self._drawn = [self._at(event.position())]
        self.update()

    def mouseMoveEvent(self, event: QtGui.QMouseEvent) -> None:
        event.accept()
        if self.erases or event.buttons() & Qt.MouseButton.RightButton:
            self._erase(event.position())
        elif self._drawn and (place := self._at(event.position())) != self._drawn[-1]:
            self._drawn.append(place)
        self.update()

    def mouseReleaseEvent(self, event: QtGui.QMouseEvent) -> None:
        event.accept()
        self._finish()
        self._bar.setVisible(self.is_on)

    def _finish(self) -> None:
        if self._drawn:
            self.strokes.setdefault(self._step, []).append(Stroke(self.colour, tuple(self._drawn)))
            self._drawn = []
            self._show_strokes()

    def _erase(self, place: QPointF) -> None:
        reach = ERASER_SHARE * self.height()

        def is_touched(stroke: Stroke) -> bool:
            return any(
                math.hypot(x * self.width() - place.x(), y * self.height() - place.y()) <= reach
                for x, y in stroke.points
            )

        left = [each for each in self.here if not is_touched(each)]
        if len(left) != len(self.here):
            self.strokes[self._step] = left
            self._show_strokes()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if watched is self._bar and kind in (QEvent.Type.Enter, QEvent.Type.Leave):
            self._unfold(kind == QEvent.Type.Enter)
        elif (
            isinstance(event, QtGui.QKeyEvent)
            and isinstance(watched, QWidget)
            and watched.window() is self.window()
            and event.matches(QtGui.QKeySequence.StandardKey.Undo)
        ):
            event.accept()  # it is the pen's, wherever the keyboard is
            if kind == QEvent.Type.KeyPress:
                self.undo()
            return True
        return super().eventFilter(watched, event)

    def event(self, event: QEvent) -> bool:
        is_asked = event.type() == QEvent.Type.ShortcutOverride
        if is_asked and isinstance(event, QtGui.QKeyEvent) and self._act(event) is not None:
            event.accept()  # otherwise it is a shortcut of the window
            return True
        return super().event(event)

    def _act(self, event: QtGui.QKeyEvent) -> Callable[[], object] | None:
        return None if event.modifiers() else self._acts.get(event.key())

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:
        act = self._act(event)
        if act is None:
            super().keyPressEvent(event)
        else:
            act()

    def resizeEvent(self, event: QtGui.QResizeEvent) -> None:
        super().resizeEvent(event)
        self._show_bar()

    def paintEvent(self, _event: QtGui.QPaintEvent) -> None:
        drawn = [Stroke(self.colour, tuple(self._drawn))] if self._drawn else []
        strokes = [*self.here, *drawn]
        if strokes:
            with QtGui.QPainter(self) as painter:
                paint_strokes(painter, QRectF(self.rect()), strokes, self._style)
