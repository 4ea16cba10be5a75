"""The mouse pointer over a thing that can go to and fro along one way."""

from __future__ import annotations

import math
from functools import lru_cache

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QCursor, QPainter, QPainterPath, QPen, QPixmap

_SIDE = 32
_LONG, _HEAD, _WIDE, _SHAFT = 13.0, 7.0, 5.5, 1.4  # from the middle; half widths
_STEP_DEG = 5


def arrow_cursor(right: float, down: float, ratio: float) -> QCursor:
    """A double arrow along a direction of the screen; upright for none."""
    if not math.isfinite(right + down) or right == down == 0.0:
        right, down = 0.0, 1.0
    turn = round(math.degrees(math.atan2(down, right)) / _STEP_DEG) * _STEP_DEG
    return _turned(turn % 180, ratio)


@lru_cache(maxsize=64)
def _turned(turn_deg: int, ratio: float) -> QCursor:
    pixmap = QPixmap(round(_SIDE * ratio), round(_SIDE * ratio))
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(Qt.GlobalColor.transparent)
    half = [(_LONG, 0.0), (_HEAD, -_WIDE), (_HEAD, -_SHAFT)]
    half += [(-x, y) for x, y in reversed(half)]
    path = QPainterPath()
    path.addPolygon([QPointF(x, y) for x, y in half + [(x, -y) for x, y in reversed(half)]])
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.translate(_SIDE / 2.0, _SIDE / 2.0)
    painter.rotate(turn_deg)
    painter.setPen(QPen(Qt.GlobalColor.white, 2.5, j=Qt.PenJoinStyle.RoundJoin))
    painter.drawPath(path)
    painter.fillPath(path, Qt.GlobalColor.black)
    painter.end()
    return QCursor(pixmap)
