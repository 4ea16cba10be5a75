"""The surface that a pane draws on: two kinds of canvas, and one hand for mouse and keys.

::

    redraw() --> QWidget.update, coalesced by Qt --> Qt's paint event --> one VTK render --> drawn

- `GlCanvas` contains an `Interactor`: VTK draws into a QOpenGLWidget.
- `RasterCanvas` is a plain widget: VTK draws off the screen, as for a figure, and the widget paints
  the pixels. With OpenGL in software that takes half the time: Qt composes no textures, and
  repaints a slider beside it without the canvases. It needs no OpenGL in Qt.

Both are empty until they are opened, which imports VTK. Nothing else renders. VTK's interactor
styles are not used: they render, rewrite the clipping range at every drag, and bind plain keys to
changes of the scene.
"""

import math
import time
from abc import abstractmethod
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, TypeAlias
from weakref import WeakSet

from PySide6 import QtGui
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, QRect, QRectF, Qt, QTimer, Signal
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QApplication, QGestureEvent, QPinchGesture, QWidget

from widgets.parts.layouts import FocusRing, in_column
from widgets.parts.plain import set_tip, show_tip_off
from widgets.parts.wording import Wording

if TYPE_CHECKING:
    from app.drawings.off_screen import OffScreen

WORDS = Wording(__file__)
ORBIT_DEG_PER_PX = 0.4
ZOOM_PER_WHEEL_STEP = 1.15
HIGHEST_DEG = 89.0
KEY_PX = 25.0  # movement of the mouse that an arrow key stands for: it turns by 10 degrees
ARROWS = {  # right and down
    Qt.Key.Key_Left: (-1.0, 0.0),
    Qt.Key.Key_Right: (1.0, 0.0),
    Qt.Key.Key_Up: (0.0, -1.0),
    Qt.Key.Key_Down: (0.0, 1.0),
}
_ZOOM_STEPS = {Qt.Key.Key_Plus: 1, Qt.Key.Key_Equal: 1, Qt.Key.Key_Minus: -1}
"""On many keyboards plus is on the key of =."""

REST_MS = 80  # so long after the last change of a picture, what waits for it is done

SCALES = {"half resolution": 0.5, "supersampling 2 x 2": 2.0}
"""Drawn pixels for one pixel of the screen, along each side, where it is not one."""
MULTISAMPLES = {"MSAA 2": 2, "MSAA 4": 4, "MSAA 8": 8}
"""Samples a pixel that OpenGL takes, where it takes more than one."""
SMOOTHINGS = ("none", "FXAA", *MULTISAMPLES, *SCALES)
"""The smoothings of a pane. Qt averages four pixels of a larger picture at the most."""


def smooth_window(window: Any, smoothing: str) -> None:
    """Set one of `SMOOTHINGS` in a window of VTK's, whatever the size of its picture."""
    for renderer in window.GetRenderers():
        renderer.SetUseFXAA(smoothing == "FXAA")
    window.SetMultiSamples(MULTISAMPLES.get(smoothing, 0))


def release_context() -> None:
    """Release Qt's OpenGL context before VTK draws off the screen, or VTK may use it as its own."""
    current = QtGui.QOpenGLContext.currentContext()
    if current is not None:
        current.doneCurrent()


class _Canvas(QWidget):
    """A widget that shows VTK's picture once it `is_open`, and is empty before.

    `render_window` and `renderer` exist once it is open.
    """

    painted = Signal(float)  # the ms of a repaint; only while `timed`
    drawn = Signal()  # VTK has drawn a picture; it may be `shown` later
    shown = Signal()  # the picture has reached the screen
    render_window: Any
    renderer: Any

    def __init__(self, parent: QWidget | None) -> None:
        super().__init__(parent)
        self.setMinimumSize(120, 120)
        self.grabGesture(Qt.GestureType.PinchGesture)
        self.timed = False
        self.is_open = False
        self.drawn_at = 0.0  # on the clock of `time.perf_counter`
        self._finer = 1.0
        self.smoothing = "none"

    @property
    def pixel_ratio(self) -> float:
        """VTK's pixels for one of Qt's, along each side."""
        return self.devicePixelRatioF() * self._finer

    @abstractmethod
    def open(self) -> None:
        """Make VTK's window."""

    def emit_drawn(self) -> None:
        self.drawn_at = time.perf_counter()
        self.drawn.emit()

    def set_timed(self, timed: bool) -> None:
        """Emit `painted` with every repaint, which then waits for its end."""
        self.timed = timed
        if timed and self.is_open:
            self.redraw()

    def smooth(self, smoothing: str) -> None:
        """Draw with one of `SMOOTHINGS`, from the next repaint on."""
        self.smoothing = smoothing
        smooth_window(self.render_window, smoothing)
        self._draw_finer(SCALES.get(smoothing, 1.0))

    @property
    def samples(self) -> int:
        """OpenGL's samples a pixel, perhaps fewer than the smoothing needs."""
        return int(self.render_window.GetMultiSamples())

    @abstractmethod
    def _draw_finer(self, times: float) -> None:
        """Draw this many pixels for one pixel of the screen, along each side."""

    @abstractmethod
    def redraw(self) -> None:
        """Ask Qt for one repaint, however often it is asked before the next paint."""

    @contextmanager
    def new_page(self) -> Iterator[None]:
        """Draw in an empty renderer from now on, unless that fails; the one before rests."""
        window, before = self.render_window, self.renderer
        renderers, layers = list(window.GetRenderers()), window.GetNumberOfLayers()
        camera = before.GetActiveCamera()
        if before.GetViewProps().GetNumberOfItems():
            from app.drawings.off_screen import new_renderer

            self.renderer = new_renderer(window)
        try:
            yield
        except Exception:
            self.renderer.RemoveAllViewProps()
            self.renderer.SetDraw(self.renderer is before)  # its drawing lays nothing out
            for added in [each for each in window.GetRenderers() if each not in renderers]:
                window.RemoveRenderer(added)
            window.SetNumberOfLayers(layers)
            self.renderer = before
            before.SetActiveCamera(camera)
            raise

    def paintEvent(self, _event: QtGui.QPaintEvent) -> None:
        with QtGui.QPainter(self) as painter:
            painter.fillRect(self.rect(), self.palette().base())


class GlCanvas(_Canvas):
    """VTK draws into a QOpenGLWidget; for machines with a graphics card."""

    def __init__(self, parent: QWidget | None) -> None:
        super().__init__(parent)
        # Qt makes a visible window again when it gets its first QOpenGLWidget.
        self._inside = QOpenGLWidget(self)
        self._inside.hide()

    def open(self) -> None:
        from widgets.panes.interactor import Interactor

        self._inside.deleteLater()
        self._inside = interactor = Interactor(self)
        self.render_window, self.renderer = interactor.render_window, interactor.renderer
        interactor.resize(self.size())
        interactor.lower()  # under the focus ring
        interactor.show()
        interactor.frameSwapped.connect(self.shown)
        self.is_open = True

    def _draw_finer(self, times: float) -> None:
        if times != self._finer:
            self._finer = times
            self._inside.resizeGL(self.width(), self.height())

    def redraw(self) -> None:
        self._inside.update()

    def resizeEvent(self, event: QtGui.QResizeEvent) -> None:
        super().resizeEvent(event)
        self._inside.resize(self.size())

    def closeEvent(self, event: QtGui.QCloseEvent) -> None:
        self._inside.close()
        super().closeEvent(event)


_OPEN: "WeakSet[RasterCanvas]" = WeakSet()
_GL_PACK_INVERT_MESA = 0x8758


def turns_rows_over(window: Any) -> bool:
    """Whether OpenGL can read the highest row first; Qt takes longer to turn them over."""
    return "Mesa" in window.GetState().GetVersion()


class RasterCanvas(_Canvas):
    """A widget that paints the pixels of VTK's off-screen picture."""

    def __init__(self, parent: QWidget | None) -> None:
        super().__init__(parent)
        # Qt flushes after it has painted the whole window.
        self.drawn.connect(self.shown, Qt.ConnectionType.QueuedConnection)
        self._screen: OffScreen | None = None
        self._is_stale = self._is_unread = True
        self._image = QtGui.QImage()

    def open(self) -> None:
        from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

        self._pixels = vtkUnsignedCharArray()
        from app.drawings.off_screen import take_screen

        self.is_open = True
        _OPEN.add(self)
        self._screen = screen = take_screen(*self._size_px)
        screen.quicken_fxaa()
        screen.render_window.SwapBuffersOff()
        self.render_window, self.renderer = screen.render_window, screen.renderer
        self.redraw()

    def draw_unseen(self) -> None:
        """Let VTK draw a picture that is not shown, so that its shaders are compiled."""
        self._is_stale |= self._is_unread
        self.render_window.Render()

    @property
    def _size_px(self) -> tuple[int, int]:
        ratio = self.pixel_ratio
        return max(1, round(self.width() * ratio)), max(1, round(self.height() * ratio))

    def _draw_finer(self, times: float) -> None:
        self._finer = times
        self.redraw()

    def redraw(self) -> None:
        self._is_stale = True
        self.update()

    def paintEvent(self, event: QtGui.QPaintEvent) -> None:
        if self._screen is None:
            super().paintEvent(event)
            return
        began = time.perf_counter()
        self._is_stale |= self._size_px != self.render_window.GetSize()
        if self._is_stale:
            # Reading waits for the software renderer's threads: other pictures are begun before.
            self._render()
            for other in () if self.timed else _OPEN:
                if other.is_due_with(self):
                    other._render()
        if self._is_unread:
            self._read()
            if self.timed:
                self.painted.emit(1e3 * (time.perf_counter() - began))
        with QtGui.QPainter(self) as painter:
            if self._finer != 1.0:
                painter.setRenderHint(QtGui.QPainter.RenderHint.SmoothPixmapTransform)
            place = QRectF(self.rect())
            if not turns_rows_over(self.render_window):
                painter.scale(1.0, -1.0)  # OpenGL's first row is the lowest
                place.moveTop(-self.height())
            painter.drawImage(place, self._image)
        self.emit_drawn()

    def is_due_with(self, other: QWidget) -> bool:
        """Whether it will be drawn in the same repaint of the window as another canvas."""
        is_seen = self._is_stale and self.window() is other.window()
        return is_seen and not self.visibleRegion().isEmpty()

    def _render(self) -> None:
        window, size = self.render_window, self._size_px
        if window.GetSize() != size:
            window.SetSize(*size)
        self._is_stale, self._is_unread = False, True
        window.Render()

    def _read(self) -> None:
        from vtkmodules.util.numpy_support import vtk_to_numpy

        window = self.render_window
        width, height = window.GetSize()
        self._is_unread = False
        state, is_mesa = window.GetState(), turns_rows_over(window)
        if is_mesa:
            window.MakeCurrent()
            state.vtkglPixelStorei(_GL_PACK_INVERT_MESA, 1)
        window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, self._pixels)
        if is_mesa:
            state.vtkglPixelStorei(_GL_PACK_INVERT_MESA, 0)
        data = vtk_to_numpy(self._pixels).data  # type: ignore[no-untyped-call]
        self._image = QtGui.QImage(data, width, height, QtGui.QImage.Format.Format_RGBX8888)

    def closeEvent(self, event: QtGui.QCloseEvent) -> None:
        _OPEN.discard(self)
        if self._screen is not None:
            self._image = QtGui.QImage()
            self._screen.give_back()
            self._screen = None
        super().closeEvent(event)


class CanvasHolder(QWidget):
    """Holds a canvas so that its edges are on whole pixels of the screen.

    At a fractional scale of the screen Qt otherwise leaves a black line at an edge, and stretches
    the picture by the rest of a pixel.
    """

    def __init__(self, canvas: QWidget) -> None:
        super().__init__()
        self._margins = in_column(canvas, on=self, margins=(0, 0, 0, 0))
        self._room: QRect | None = None
        self.beside: QtGui.QColor | None = None  # colour beside the canvas; None for the window's

    def paintEvent(self, event: QtGui.QPaintEvent) -> None:
        if self._room is not None and self.beside is not None:
            with QtGui.QPainter(self) as painter:
                painter.fillRect(event.rect(), self.beside)

    def resizeEvent(self, event: QtGui.QResizeEvent) -> None:
        super().resizeEvent(event)
        self.fit()

    def set_room(self, room: QRect | None) -> None:
        """Give the canvas a part of the surface, or None for all of it."""
        if room != self._room:
            self._room = room
            self.fit()

    def fit(self) -> None:
        """Move the edges inwards to the next whole pixels."""
        place, ratio = self.mapTo(self.window(), QPoint()), self.devicePixelRatioF()
        room = self._room or self.rect()
        left, top = place.x() + room.x(), place.y() + room.y()
        self._margins.setContentsMargins(
            room.x() + _to_whole(left, 1, ratio),
            room.y() + _to_whole(top, 1, ratio),
            self.width() - room.x() - room.width() + _to_whole(left + room.width(), -1, ratio),
            self.height() - room.y() - room.height() + _to_whole(top + room.height(), -1, ratio),
        )
        self._margins.invalidate()
        self._margins.activate()


def _to_whole(edge: int, inwards: int, ratio: float) -> int:
    """Return the steps from an edge to a whole pixel of the screen; 0 if there is none near."""
    for away in range(8):
        at = (edge + inwards * away) * ratio
        if abs(at - round(at)) < 1e-6:
            return away
    return 0


AnyCanvas: TypeAlias = GlCanvas | RasterCanvas
CANVASES: dict[str, type[AnyCanvas]] = {"opengl": GlCanvas, "raster": RasterCanvas}


class Hand(QObject):
    """Mouse and keys on a canvas: they move its own camera if it `orbits`, or emit signals.

    Places are in device pixels from the canvas' top left.
    """

    moved = Signal()  # the canvas' own camera was moved
    clicked = Signal(QPointF)  # pressed and released in one place: the middle of that pixel
    drag_started = Signal(QPointF)
    """The middle of the pixel where the left button was pressed; the mouse has left it."""
    dragged = Signal(QPointF, bool)  # the movement from there, and whether Shift is held
    drag_ended = Signal()
    hovered = Signal(QPointF)  # the mouse is here without a button: the middle of that pixel
    left = Signal()  # the mouse has left the canvas
    scrolled = Signal(float)  # steps of the wheel, or of a key for it, where they do not zoom
    pushed = Signal(QPointF)  # the movement that an arrow key stands for, where it does not turn
    dropped = Signal()  # the receiver has ended the drag; the rest of the movement has no effect

    def __init__(self, canvas: AnyCanvas, *, orbits: bool) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self._orbits = orbits
        self._last: QPointF | None = None
        self._pressed: QPointF | None = None  # where the left button went down, if perhaps a click
        self._dragged_from: QPointF | None = None
        self.at: QPointF | None = None  # where the mouse is still, as it was `hovered`
        self._holds = False
        self.has_tooltip = True  # whether the canvas has a tooltip
        self.may_turn: Callable[[], bool] = lambda: True
        """Whether a drag turns the camera; otherwise it only shifts it."""
        self.names: Callable[[], list[QRectF]] = list  # boxes that no tooltip shall hide
        # Without it Qt paints the window under the canvas, and uploads it, with every slider step.
        canvas.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        canvas.setMouseTracking(True)
        # By Tab only: a click leaves the focus in a field that is being typed.
        canvas.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        FocusRing(canvas)
        self.tip, keys = WORDS["turns" if orbits else "moves"]
        set_tip(canvas, self.tip)
        self._keys = f"{keys} {WORDS.say('cursor')}"
        self.describe("")
        kinds = QEvent.Type
        self._takes: dict[QEvent.Type, Any] = {
            kinds.MouseButtonPress: self._press,
            kinds.MouseButtonRelease: self._release,
            kinds.MouseButtonDblClick: self._double_click,
            kinds.MouseMove: self._move,
            kinds.Wheel: self._wheel,
            kinds.KeyPress: self._key,
            kinds.Leave: self._leave,
            kinds.Gesture: self._gesture,
            kinds.ToolTip: self._show_tip,
            kinds.WindowDeactivate: self._lose,
        }
        canvas.installEventFilter(self)
        self._rest = QTimer(self, singleShot=True, interval=REST_MS)
        # Another thing may lie under the mouse than before the picture changed.
        self._rest.timeout.connect(lambda: self.at is not None and self.hovered.emit(self.at))
        canvas.drawn.connect(lambda: self.at is not None and self._rest.start())

    def describe(self, about: str) -> None:
        """Describe what the pane shows to a screen reader, before the keys."""
        self._canvas.setAccessibleDescription(f"{about} {self._keys}".strip())

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        # Before the canvas is open there is no camera.
        take = self._takes.get(event.type()) if self._canvas.is_open else None
        return watched is self._canvas and take is not None and bool(take(event))

    def keep_view(self) -> None:
        """Keep the view during the drag that has just started: something is being dragged."""
        self._last = None
        self._holds = True

    @property
    def is_down(self) -> bool:
        """Whether a button of the mouse was pressed on the canvas, and is still down."""
        return self._pressed is not None or self._dragged_from is not None

    def take_hold(self, place: QPointF) -> bool:
        """Start a drag without the mouse; return whether there is something to drag."""
        self._holds = False
        self.drag_started.emit(place)
        if not self._holds:
            self.drag_ended.emit()
        return self._holds

    # Each returns whether the canvas does not get the event; an ignored event goes to the pane.

    def _key(self, event: QtGui.QKeyEvent) -> bool:
        modifiers, key = event.modifiers(), event.key()
        is_shifted = bool(modifiers & Qt.KeyboardModifier.ShiftModifier)
        plain = Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.KeypadModifier
        if self._dragged_from is not None or modifiers & ~plain:
            return False
        if key in ARROWS:
            way_px = (KEY_PX * part for part in ARROWS[Qt.Key(key)])
            if self._orbits:
                turns = not is_shifted and self.may_turn()
                (self._orbit if turns else self._pan)(*way_px)
                self.moved.emit()
            else:
                self.pushed.emit(QPointF(*way_px) * self._canvas.pixel_ratio)
        elif key in _ZOOM_STEPS:
            steps = _ZOOM_STEPS[Qt.Key(key)]
            if self._orbits:
                self._zoom(ZOOM_PER_WHEEL_STEP**steps)
            else:
                self.scrolled.emit(float(steps))
        else:
            return False
        event.accept()
        return True

    def _leave(self, _event: QEvent) -> bool:
        self.at = None
        self.left.emit()
        return False

    def _show_tip(self, event: QtGui.QHelpEvent) -> bool:
        if self.has_tooltip:
            show_tip_off(self.names(), event.pos().toPointF(), self._canvas)
        return True

    def _hover(self, position: QPointF) -> None:
        self.at = self._middle(position)
        self.hovered.emit(self.at)

    def _press(self, event: QtGui.QMouseEvent) -> bool:
        event.accept()
        self.at = None
        is_left = event.button() == Qt.MouseButton.LeftButton
        if is_left:
            self._lose(event)  # a menu may have taken the last release
        if self._dragged_from is None:  # another button does not belong to a drag
            self._last = event.position()
            self._pressed = event.position() if is_left else None
        return True

    def _release(self, event: QtGui.QMouseEvent) -> bool:
        event.accept()
        if event.buttons() == Qt.MouseButton.NoButton:
            self._last = None
        if event.button() != Qt.MouseButton.LeftButton:
            return True
        if self._dragged_from is not None:
            self._dragged_from = None
            self.drag_ended.emit()
            if self._canvas.rect().contains(event.position().toPoint()):
                self._hover(event.position())  # perhaps over another thing
        if self._pressed is not None:
            middle = self.at = self._middle(self._pressed)
            self._pressed = None
            self.clicked.emit(middle)
        return True

    def _lose(self, _event: QEvent) -> bool:
        """End a drag: a dialog or another window takes the release of the button."""
        is_dragged = self._dragged_from is not None
        self._last = self._pressed = self._dragged_from = None
        if is_dragged:
            self.drag_ended.emit()
        return False

    def _middle(self, position: QPointF) -> QPointF:
        """Return the middle of the pixel at a position, in device pixels."""
        return (position + QPointF(0.5, 0.5)) * self._canvas.pixel_ratio

    def _double_click(self, event: QtGui.QMouseEvent) -> bool:
        self._pressed = None
        event.ignore()  # the pane resets the view
        return True

    def _move(self, event: QtGui.QMouseEvent) -> bool:
        event.accept()
        if event.buttons() == Qt.MouseButton.NoButton:
            self._hover(event.position())
            return True
        ratio = self._canvas.pixel_ratio
        is_shifted = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if self._pressed is not None:
            moved = (event.position() - self._pressed).manhattanLength()
            if moved < QApplication.startDragDistance():
                return True
            self._dragged_from, self._pressed = self._pressed, None
            self.drag_started.emit(self._middle(self._dragged_from))
        if self._dragged_from is not None:
            self.dragged.emit((event.position() - self._dragged_from) * ratio, is_shifted)
        if self._last is None or not self._orbits:
            return True
        step = event.position() - self._last
        self._last = event.position()
        turning = Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton
        turns = event.buttons() in turning and not is_shifted and self.may_turn()
        (self._orbit if turns else self._pan)(step.x(), step.y())
        self.moved.emit()
        return True

    def _wheel(self, event: QtGui.QWheelEvent) -> bool:
        event.accept()
        steps = event.angleDelta().y() / 120.0
        if self._dragged_from is not None:  # the held thing would move away from the mouse
            return True
        if self._orbits:
            self._zoom(ZOOM_PER_WHEEL_STEP**steps)
        elif steps:
            self.scrolled.emit(steps)
        return True

    def _gesture(self, event: QGestureEvent) -> bool:
        pinch = event.gesture(Qt.GestureType.PinchGesture)
        if isinstance(pinch, QPinchGesture) and self._orbits:
            event.accept(pinch)
            self._zoom(pinch.scaleFactor())
        return True

    # -- the canvas' own camera

    @property
    def camera(self) -> Any:
        return self._canvas.renderer.GetActiveCamera()

    def _zoom(self, factor: float) -> None:
        """Move the camera nearer by `factor`."""
        camera = self.camera
        if camera.GetParallelProjection():
            camera.SetParallelScale(camera.GetParallelScale() / factor)
        else:
            camera.Dolly(factor)
        self.moved.emit()

    def _orbit(self, right_px: float, down_px: float) -> None:
        camera = self.camera
        camera.Azimuth(-ORBIT_DEG_PER_PX * right_px)
        # Turntable, not trackball: the world's vertical stays vertical, so the pole is a stop.
        up, forwards = camera.GetViewUp(), camera.GetDirectionOfProjection()
        sine = -sum(f * u for f, u in zip(forwards, up, strict=True)) / math.hypot(*up)
        elevation_deg = math.degrees(math.asin(max(-1.0, min(1.0, sine))))
        turned = elevation_deg + ORBIT_DEG_PER_PX * down_px
        camera.Elevation(max(-HIGHEST_DEG, min(HIGHEST_DEG, turned)) - elevation_deg)

    def _pan(self, right_px: float, down_px: float) -> None:
        camera = self.camera
        if camera.GetParallelProjection():
            half_height = camera.GetParallelScale()
        else:
            half_angle = math.radians(camera.GetViewAngle()) / 2.0
            half_height = camera.GetDistance() * math.tan(half_angle)
        unit = 2.0 * half_height / max(1, self._canvas.height())
        matrix = camera.GetViewTransformMatrix()
        shift = [
            unit * (down_px * matrix.GetElement(1, i) - right_px * matrix.GetElement(0, i))
            for i in range(3)
        ]
        for get, put in (
            (camera.GetPosition, camera.SetPosition),
            (camera.GetFocalPoint, camera.SetFocalPoint),
        ):
            put(*(p + s for p, s in zip(get(), shift, strict=True)))
