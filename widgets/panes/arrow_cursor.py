"""The mouse pointer over a handle that can be dragged along one line."""

import math
from functools import lru_cache

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QCursor, QPainter, QPen, QPixmap, QPolygonF

_SIDE, _STEP_DEG = 32, 5
_HALF = (13.0, 0.0), (7.0, -5.5), (7.0, -1.4), (-7.0, -1.4), (-7.0, -5.5), (-13.0, 0.0)
_ARROW = [QPointF(*end) for end in (*_HALF, *((x, -y) for x, y in _HALF[::-1]))]


def arrow_cursor(right: float, down: float, ratio: float) -> QCursor:
    """A double arrow along a direction of the screen; upright for none."""
    is_seen = math.isfinite(right + down) and (right, down) != (0.0, 0.0)
    turn_deg = math.degrees(math.atan2(down, right)) if is_seen else 90.0
    return _turned(round(turn_deg / _STEP_DEG) * _STEP_DEG % 180, ratio)


@lru_cache(maxsize=64)
def _turned(turn_deg: int, ratio: float) -> QCursor:
    pixmap = QPixmap(round(_SIDE * ratio), round(_SIDE * ratio))
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.translate(_SIDE / 2.0, _SIDE / 2.0)
    painter.rotate(turn_deg)
    painter.setPen(QPen(Qt.GlobalColor.white, 1.5))
    painter.setBrush(Qt.GlobalColor.black)
    painter.drawPolygon(QPolygonF(_ARROW))
    painter.end()
    return QCursor(pixmap)
