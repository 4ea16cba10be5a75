"""A window under test: what is done to it, and what reaches its screen."""

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, Qt
from PySide6.QtGui import QImage, QMouseEvent, QRegion
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit, QSplitter, QWidget

from app.document.document import Document
from app.lecture.highlight import NOTHING, Highlight
from app.model.projection import Perspective, Projection
from app.scenes.scene import load
from tests import PATIENCE_MS
from widgets.panes.canvas import REST_MS
from widgets.parts.clock import Clock
from widgets.window.lessons import TRANSITION_S, Lessons
from widgets.window.main_window import MainWindow

MakeWindow = Callable[..., MainWindow]
LEFT = Qt.MouseButton.LeftButton
NO_KEY = Qt.KeyboardModifier.NoModifier


def settle() -> None:
    """Let Qt do all that is asked of it, until it has nothing more to do."""
    for _ in range(3):
        QApplication.processEvents()


def activate(window: QWidget) -> None:
    """Wait until the keyboard is the window's."""
    window.activateWindow()
    assert QTest.qWaitForWindowActive(window, PATIENCE_MS)
    for _ in range(PATIENCE_MS):  # Qt takes a dialog for active already while its parent is
        if QApplication.activeWindow() is window:
            return
        QTest.qWait(1)
    raise AssertionError(f"{window} does not become active")


def present(window: MainWindow, room: QRect | None = None) -> None:
    """Present, on the whole screen as a window manager would have it, or in less room."""
    window.present.begin()
    give_room(window, room or window.screen().geometry())


def give_room(window: MainWindow, geometry: QRect) -> None:
    """Resize the window as a window manager does, which leaves the window's state to Qt."""
    window.windowHandle().setGeometry(geometry)
    for _ in range(PATIENCE_MS):
        if window.geometry() == geometry:
            break
        QTest.qWait(1)
    settle()


def show_scene(window: MainWindow, name: str) -> MainWindow:
    """Open a built-in scene as it starts."""
    window.store.open(Document(name, load(name).start))
    settle()
    return window


def tick(lessons: Lessons, seconds: float) -> None:
    """Let time pass for the model that is on its way to a step."""
    if lessons.is_moving:
        lessons.findChild(Clock).ticked.emit(seconds)


def arrive(lessons: Lessons) -> None:
    """Let the model be where it is moving to."""
    tick(lessons, TRANSITION_S / 3.0)
    tick(lessons, 2.0 * TRANSITION_S)
    assert not lessons.is_moving


def go_to(lessons: Lessons, place: int) -> None:
    """Be at a step."""
    assert lessons.go(place)
    arrive(lessons)


class Highlighted:
    """What a window highlights: as it says when that changes.

    Attributes
    ----------
    now : Highlight
    """

    def __init__(self, window: MainWindow) -> None:
        self.now = NOTHING
        window.highlighter.changed.connect(self._keep)

    def _keep(self, what: Highlight) -> None:
        self.now = what


def seen(window: MainWindow, **changes: Any) -> Projection:
    """The model with something changed."""
    return replace(window.store.document.projection, **changes)


def rgb_of(image: QImage) -> np.ndarray:
    """A picture's pixels, (height, width, 3) of uint8."""
    image = image.convertToFormat(QImage.Format.Format_RGB888)
    array = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return array[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).copy()


def pixels(window: MainWindow, name: str = "world") -> np.ndarray:
    """What a pane shows."""
    return pixels_of(window.panes[name].canvas)


def pixels_of(canvas: Any) -> np.ndarray:
    """What a canvas shows."""
    return rgb_of(picture(canvas))


def picture(canvas: Any) -> QImage:
    """What a pane's canvas shows, in the screen's pixels, without what lies over it."""
    inside = canvas.findChild(QOpenGLWidget)
    if inside is not None:
        return inside.grabFramebuffer()
    ratio = canvas.devicePixelRatioF()
    image = QImage(canvas.size() * ratio, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    canvas.render(image, QPoint(), QRegion(), QWidget.RenderFlag(0))
    return image


@contextmanager
def counted_repaints(window: MainWindow) -> Iterator[dict[str, int]]:
    """Count VTK's renderings of each pane."""
    counts = dict.fromkeys(window.panes, 0)
    observers = []
    for name, pane in window.panes.items():
        render_window = pane.canvas.render_window

        def count(_window: object, _event: str, name: str = name) -> None:
            counts[name] += 1

        observers.append((render_window, render_window.AddObserver("EndEvent", count)))
    yield counts
    for render_window, tag in observers:
        render_window.RemoveObserver(tag)


def point_of(place: tuple[float, float]) -> QPoint:
    """The whole pixel that a place is in."""
    return QPoint(math.floor(place[0]), math.floor(place[1]))


def click(widget: Any, place: tuple[float, float] | None = None) -> None:
    """Click a widget, in its middle unless a place is given, and let it happen."""
    QTest.mouseClick(widget, LEFT, pos=QPoint() if place is None else point_of(place))
    settle()


def drag(splitter: QSplitter, place: int, by: QPoint) -> None:
    """Drag the handle between two widgets of a splitter."""
    handle = splitter.handle(place)
    at = handle.rect().center()
    QTest.mousePress(handle, LEFT, pos=at)
    QTest.mouseMove(handle, at + by)
    QTest.mouseRelease(handle, LEFT, pos=at + by)
    settle()


def edit(window: MainWindow) -> None:
    """Make an unsaved change."""
    window.store.set_projection(seen(window, lens=Perspective(60.0, 2.0, 20.0)))


def turn(window: MainWindow, name: str) -> None:
    """Turn a pane with the mouse, and go nearer; then let the hand rest."""
    pane = window.panes[name]
    canvas = pane.canvas
    QTest.mousePress(canvas, LEFT, pos=QPoint(100, 100))
    QTest.mouseMove(canvas, QPoint(180, 130))
    QTest.mouseRelease(canvas, LEFT, pos=QPoint(180, 130))
    QTest.keyClick(canvas, Qt.Key.Key_Plus)
    QTest.qWait(3 * REST_MS)
    assert pane.drawing is not None
    board = pane.drawing.board
    while board.is_restless:
        QTest.qWait(1)
    settle()


def move_mouse(widget: Any, to: QPoint | QPointF, button: Any = LEFT, key: Any = NO_KEY) -> None:
    """Move the mouse over a widget, a button held."""
    at = QPointF(to)
    kind, none = QEvent.Type.MouseMove, Qt.MouseButton.NoButton
    QApplication.sendEvent(widget, QMouseEvent(kind, at, widget.mapToGlobal(at), none, button, key))


def named(parent: QWidget, kind: type[Any], name: str) -> Any:
    """The one child of a kind that screen readers call so."""
    (found,) = (child for child in parent.findChildren(kind) if child.accessibleName() == name)
    return found


def enter(field: QLineEdit, text: str) -> None:
    """Type a text over what a field has, and enter it."""
    field.setFocus()
    field.selectAll()
    QTest.keyClick(field, Qt.Key.Key_Delete)
    QTest.keyClicks(field, text)
    QTest.keyClick(field, Qt.Key.Key_Return)
