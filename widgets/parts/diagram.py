"""A diagram beside the panes: it repaints only when it changes, and its points can be clicked.

`DiagramView` shows an `app.scenes.phenomena.words.Diagram`, which is data. Colours are names of
`Style`; a curve's name is on a plate of its colour. Both are as in the panes.
"""

import math

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, QSizeF, Qt, Signal
from PySide6.QtGui import QAction, QHelpEvent, QImage, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.drawings.style import LIGHT, Style
from app.scenes.phenomena.words import Diagram, Spot
from widgets.parts.diagram_axis import Floats
from widgets.parts.diagram_painter import DiagramPainter
from widgets.parts.messages import of_phenomena
from widgets.parts.plain import show_tip

HIT_PX = 9.0  # largest distance of a click from its spot
PRINTED_PX, PRINTED_FINER = QSize(480, 360), 3
"""Size of a printed diagram in the window's pixels, and its pixels per such pixel."""


class DiagramView(QWidget):
    spot_clicked = Signal(str)  # emits the key of a clicked `Spot`, or of a point of a `Curve`
    copy_wanted = Signal(QImage)
    export_wanted = Signal(QImage)  # emit the `picture` for the clipboard, or for a file

    def __init__(self) -> None:
        super().__init__()
        self._diagram: Diagram | None = None
        self.names: dict[str, Floats] = {}
        """Places of the curves' names (left, top, right, bottom), kept where possible."""
        self._style = LIGHT
        self._pressed = ""  # the key of the spot under the last press of the mouse
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(115, 90)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        for text, wanted in (
            (self.tr("Copy this diagram"), self.copy_wanted),
            (self.tr("Export this diagram…"), self.export_wanted),
        ):
            action = QAction(text, self)
            action.setEnabled(False)  # without a diagram
            action.triggered.connect(lambda _on=False, to=wanted: to.emit(self.picture()))
            self.addAction(action)

    def sizeHint(self) -> QSize:
        return QSize(260, 180)

    def show_diagram(self, diagram: Diagram | None) -> None:
        if diagram is self._diagram:
            return
        self._diagram = diagram
        self.setMouseTracking(
            diagram is not None and bool(diagram.spots or any(c.keys for c in diagram.curves))
        )
        policies = Qt.FocusPolicy
        self.setFocusPolicy(policies.NoFocus if diagram is None else policies.TabFocus)
        for action in self.actions():
            action.setEnabled(diagram is not None)
        title = "" if diagram is None else of_phenomena(diagram.title)
        if title != self.accessibleName():
            self.setAccessibleName(title)
        self.update()

    def set_style(self, style: Style) -> None:
        """Use other colours and widths; sizes are in device pixels, as for the panes."""
        self._style = style
        self.update()

    def picture(self) -> QImage:
        """Return the diagram for print: dark on white, and finer than the screen."""
        image = QImage(PRINTED_PX * PRINTED_FINER, QImage.Format.Format_RGB32)
        image.setDevicePixelRatio(PRINTED_FINER)
        image.fill(LIGHT.background)
        with QPainter(image) as painter:
            if self._diagram is not None:
                DiagramPainter(self._diagram, QSizeF(PRINTED_PX), self.font(), LIGHT).paint(painter)
        return image

    def _laid_out(self, diagram: Diagram) -> DiagramPainter:
        ratio = self.devicePixelRatioF()
        return DiagramPainter(
            diagram, QSizeF(self.size()), self.font(), self._style, ratio=ratio, names=self.names
        )

    @property
    def frame(self) -> QRectF:
        """The place of the diagram's window in the widget, in pixels."""
        return QRectF() if self._diagram is None else self._laid_out(self._diagram).frame

    def to_px(self, x: float, y: float) -> QPointF:
        """Return the place in the widget of a point of the diagram."""
        assert self._diagram is not None
        (place,) = self._laid_out(self._diagram).to_px(np.array([[x, y]])).tolist()
        return QPointF(*place)

    # -- spots

    def spot_at(self, place: QPointF, key_only: bool = False) -> Spot | None:
        """Return the nearest spot within `HIT_PX`; `key_only` ignores spots without a key."""
        if self._diagram is None:
            return None
        spots = [spot for spot in self._diagram.spots if spot.key or not key_only]
        places = np.array([(spot.x, spot.y) for spot in spots]).reshape(-1, 2)
        return next((spots[i] for i in self._hit(self._diagram, places, place)), None)

    def _hit(self, diagram: Diagram, points: Floats, place: QPointF) -> list[int]:
        """Return the index of the nearest of the diagram's points within `HIT_PX`, if any."""
        aways = self._laid_out(diagram).to_px(points) - (place.x(), place.y())
        distances = np.nan_to_num(np.hypot(*aways.T), nan=math.inf)
        return [int(distances.argmin())] if (distances < HIT_PX).any() else []

    def _key_at(self, place: QPointF) -> str:
        spot = self.spot_at(place, key_only=True)
        if spot is not None or self._diagram is None:
            return "" if spot is None else spot.key
        curves = [curve for curve in self._diagram.curves if curve.keys]
        keys = [key for curve in curves for key in curve.keys]
        points = [curve.points[: len(curve.keys)] for curve in curves]
        hit = self._hit(self._diagram, np.vstack([np.empty((0, 2)), *points]), place)
        return next((keys[i] for i in hit), "")

    def mousePressEvent(self, event: QMouseEvent) -> None:
        is_left = event.button() == Qt.MouseButton.LeftButton
        self._pressed = self._key_at(event.position()) if is_left else ""
        if not self._pressed:
            super().mousePressEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        pressed, self._pressed = self._pressed, ""
        if pressed and pressed == self._key_at(event.position()):
            self.spot_clicked.emit(pressed)
        else:
            super().mouseReleaseEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        shapes = Qt.CursorShape
        over = bool(self._key_at(event.position()))
        shape = shapes.PointingHandCursor if over else shapes.ArrowCursor
        if shape != self.cursor().shape():
            self.setCursor(shape)
        super().mouseMoveEvent(event)

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            spot = self.spot_at(QPointF(event.pos()))
            if spot is not None and spot.tip:
                show_tip(event.globalPos(), spot.tip, self)
                return True
            show_tip(event.globalPos(), "")
        return super().event(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._diagram is None:
            return
        with QPainter(self) as painter:
            self._laid_out(self._diagram).paint(painter)
            if self.hasFocus():
                painter.setPen(QPen(self.palette().highlight(), 2.0))
                painter.drawRect(self.rect().adjusted(1, 1, -1, -1))
