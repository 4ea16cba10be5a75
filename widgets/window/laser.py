"""A laser pointer for a class: while L is held, a dot over the whole window follows the mouse."""

from PySide6.QtCore import QEvent, QObject, QPointF, QSize, Qt
from PySide6.QtGui import QColor, QCursor, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QApplication, QWidget

from widgets.window.talk_keys import is_typed_in

DOT_SHARE = 0.022  # diameter of the dot, in heights of the window
DOT, RIM = QColor("#e8112d"), QColor("white")


class Laser(QWidget):
    """The dot; while it is seen, the pictures do not notice the mouse, so nothing lights up."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def listen(self, on: bool) -> None:
        """Watch for the key while the window is presented."""
        self._switch(False)
        handle = self.window().windowHandle()
        (handle.installEventFilter if on else handle.removeEventFilter)(self)

    def _switch(self, on: bool) -> None:
        if on == self.isHidden():
            under = QApplication.widgetAt(QCursor.pos())
            if on and under is not None:
                QApplication.sendEvent(under, QEvent(QEvent.Type.Leave))  # it puts out its light
            self.setVisible(on)
            if on:
                self.resize(QSize(1, 1) * (DOT_SHARE * self.window().height()))
                self._go(QPointF(self.window().mapFromGlobal(QCursor.pos())))
                self.raise_()
                QApplication.setOverrideCursor(Qt.CursorShape.BlankCursor)
            else:
                QApplication.restoreOverrideCursor()

    def _go(self, place: QPointF) -> None:
        self.move((place - QPointF(self.rect().center())).toPoint())

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        is_pressed = kind == QEvent.Type.KeyPress
        if isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_L:
            if is_pressed and (event.modifiers() or is_typed_in()):
                return False
            if not event.isAutoRepeat():
                self._switch(is_pressed)
            return is_pressed
        if kind == QEvent.Type.FocusOut:
            self._switch(False)  # the key may be released elsewhere
        elif isinstance(event, QMouseEvent) and not self.isHidden():
            self._go(event.position())
            return not event.buttons() and kind == QEvent.Type.MouseMove
        return False

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter, rim = QPainter(self), self.width() / 8.0
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(RIM, rim))
        painter.setBrush(DOT)
        painter.drawEllipse(self.rect().toRectF().adjusted(rim, rim, -rim, -rim))
        painter.end()
