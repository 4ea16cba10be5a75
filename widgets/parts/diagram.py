"""A diagram beside the panes: frame, ticks, and curves with their names beside them.

`DiagramView` draws an `app.scenes.phenomena.diagram.Diagram`, which is data, with Qt's painter at
the screen's resolution, and repaints only when the diagram changes. Colours are names of `Style`;
a curve's name is on a plate of its colour. Both are as in the panes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import (
    QEvent,
    QLineF,
    QPoint,
    QPointF,
    QRectF,
    QSize,
    Qt,
    Signal,
    SignalInstance,
)
from PySide6.QtGui import (
    QAction,
    QColor,
    QFont,
    QFontMetricsF,
    QHelpEvent,
    QImage,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QRegion,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.drawings.curve_names import GAP_PX, beside, beside_curve
from app.drawings.style import LIGHT, Style
from app.scenes.phenomena.diagram import Curve, Diagram, Spot
from widgets.parts.highlight import faded
from widgets.parts.messages import figure_text, of_phenomena
from widgets.parts.plain import show_tip
from widgets.parts.typeset import typeset

Floats = NDArray[np.float64]

TICK_PX = 4.0
_LINE = 0.75  # width relative to a line in a pane, which has no antialiasing
DOT_PX = 3.0
"""Radius of a dot at the ordinary line width."""
HIT_PX = 9.0
"""Largest distance of a click from its spot."""
PRINTED_PX, PRINTED_FINER = QSize(480, 360), 3
"""Size of a printed diagram in the window's pixels, and its pixels per such pixel."""
_LINES_ACROSS, _LINES_DOWN = 12.0, 8.0  # lines of names for which a small diagram has room
_LEAST_NAME = 0.7  # least size of names, relative to the ordinary size
_BREAK = np.full((1, 2), math.nan)  # separates lines
_FAR = 1e6
"""Largest distance in windows; a farther end only gives the direction, to keep precision."""

# --------------------------------------------------------------------------- ticks


def round_ticks(low: float, high: float, most: int) -> list[float]:
    """Return at most `most` (at least 2) multiples of 1, 2 or 5 times a power of ten.

    They are the nearest floats to the decimals: 0.3, never 0.30000000000000004.
    """
    reach = high - low
    if not (0.0 < reach < math.inf):
        return []
    exponent = math.floor(math.log10(reach / most))
    for digit, power in ((d, exponent + e) for e in (0, 1) for d in (1, 2, 5)):
        step = digit * 10.0**power
        first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
        if last - first < most:
            return [float(f"{count * digit}e{power}") for count in range(first, last + 1)]
    return []


def decade_ticks(low: float, high: float, most: int) -> list[float]:
    """Return powers of ten between two positive numbers, or 1, 2, 5 times them if these are few."""
    first, last = math.ceil(math.log10(low) - 1e-9), math.floor(math.log10(high) + 1e-9)
    if last - first >= 1:
        step = -(-(last - first + 1) // most)
        return [float(f"1e{power}") for power in range(first, last + 1) if power % step == 0]
    between = [
        float(f"{digit}e{power}") for power in range(first - 1, last + 1) for digit in (1, 2, 5)
    ]
    between = [value for value in between if low <= value <= high]
    return between if 2 <= len(between) <= most else round_ticks(low, high, most)


@dataclass(frozen=True)
class _DiagramAxis:
    """One axis of a diagram: its numbers and their places."""

    low: float
    high: float
    log: bool
    ticks: Sequence[float] | None

    @property
    def usable(self) -> bool:
        """Whether the axis has a valid, non-empty range."""
        low, high = self.unit_ends
        return math.isfinite(high - low) and low != high

    @property
    def unit_ends(self) -> tuple[float, float]:
        if not self.log:
            return self.low, self.high
        ends = (self.low, self.high)
        low, high = (math.log10(end) if end > 0.0 else math.nan for end in ends)
        return low, high

    def unit(self, values: Floats) -> Floats:
        """Return the places of numbers between the ends, 0 to 1; NaN if there is none."""
        low, high = self.unit_ends
        with np.errstate(all="ignore"):
            along = np.log10(values) if self.log else values
            places: Floats = (along - low) / (high - low)
        places[~np.isfinite(places)] = np.nan
        return places

    def given(self) -> list[float]:
        """Return the diagram's own ticks within the ends."""
        low, high = sorted((self.low, self.high))
        return [float(tick) for tick in self.ticks or () if low <= tick <= high]

    def marks(self, most: int) -> list[float]:
        """Return at most `most` round numbers within the ends."""
        low, high = sorted((self.low, self.high))
        return (decade_ticks if self.log else round_ticks)(low, high, max(2, most))


# --------------------------------------------------------------------------- lines


def segments(points: Floats) -> tuple[Floats, NDArray[np.intp]]:
    """Return the parts of a polyline (n, 2) inside the unit square; NaN breaks the line.

    The results are the ends (m, 2, 2) of the parts, and the index of the point where each segment
    begins (m,). The method is Liang-Barsky for all segments at once. An end that is more than
    `_FAR` windows away is first moved along the segment towards the other end.
    """
    finite, within = np.asarray(np.isfinite(points).all(axis=1)), _inside(points)
    which = np.flatnonzero(finite[:-1] & finite[1:])
    start, end = points[which], points[which + 1]
    if (within[which] & within[which + 1]).all():
        return np.stack([start, end], axis=1), which
    with np.errstate(all="ignore"):
        far = np.maximum(np.abs(end - start).max(axis=1), _FAR)[:, None]
        nearer_start = (np.abs(start).max(axis=1) <= np.abs(end).max(axis=1))[:, None]
        direction = (end - start) * (_FAR / far)
        start = np.where(nearer_start, start, end - direction)
        enter, leave = np.zeros(len(start)), np.ones(len(start))
        possible = np.ones(len(start), dtype=bool)
        for axis in (0, 1):
            for edge in (0.0, 1.0):
                # Inward is + at the lower edge and - at the upper edge.
                inward = direction[:, axis] * (1.0 - 2.0 * edge)
                outside = (edge - start[:, axis]) * (1.0 - 2.0 * edge)
                at = outside / inward
                enter = np.where(inward > 0.0, np.maximum(enter, at), enter)
                leave = np.where(inward < 0.0, np.minimum(leave, at), leave)
                possible &= (inward != 0.0) | (outside <= 0.0)
    kept = possible & (enter <= leave)
    start, direction = start[kept], direction[kept]
    parts = [start + enter[kept, None] * direction, start + leave[kept, None] * direction]
    return np.stack(parts, axis=1), which[kept]


def seen_parts(curves: Sequence[Curve], across: _DiagramAxis, up: _DiagramAxis) -> list[Floats]:
    """Return the visible part of each curve: segments (m, 2, 2) or dots (m, 2), in window units."""
    rows = [np.empty((0, 2))]
    for curve in curves:
        points = np.asarray(curve.points, dtype=np.float64).reshape(-1, 2)
        rows += [points, points[: curve.closed], _BREAK]
    counts = [len(curve.points) + (curve.closed and len(curve.points) > 0) + 1 for curve in curves]
    all_points = np.concatenate(rows)
    # All at once: a diagram has many curves of few points.
    points = np.stack([across.unit(all_points[:, 0]), up.unit(all_points[:, 1])], axis=1)
    parts, at = segments(points)
    ends = np.cumsum(counts)
    bounds = np.searchsorted(at, ends).tolist()
    seen = []
    for curve, end, count, first, last in zip(
        curves, ends.tolist(), counts, [0, *bounds], bounds, strict=False
    ):
        if curve.dots:
            dots = points[end - count : end]
            seen.append(dots[_inside(dots)])
        else:
            seen.append(parts[first:last])
    return seen


# --------------------------------------------------------------------------- the widget


class DiagramView(QWidget):
    """Draws one diagram at the size of the widget."""

    spot_clicked = Signal(str)
    """Emits the key of a clicked `Spot`, or of a point of a `Curve`."""
    copy_wanted = Signal(QImage)
    export_wanted = Signal(QImage)
    """Emit the `picture` for the clipboard, or for a file."""

    def __init__(self) -> None:
        super().__init__()
        self._diagram: Diagram | None = None
        self.names: dict[str, Floats] = {}
        """Places of the curves' names (left, top, right, bottom), kept where possible."""
        self.spot_names: dict[str, QRectF] = {}
        """Places of the spots' names."""
        self._style = LIGHT
        self._pressed = ""
        """The key of the spot under the last press of the mouse."""
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMinimumSize(115, 90)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        for text, wanted in (
            (self.tr("Copy this diagram"), self.copy_wanted),
            (self.tr("Export this diagram…"), self.export_wanted),
        ):
            action = QAction(text, self)
            action.setEnabled(False)  # without a diagram
            action.triggered.connect(partial(self._want, wanted))
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

    def _want(self, wanted: SignalInstance, _checked: bool = False) -> None:
        wanted.emit(self.picture())

    def picture(self) -> QImage:
        """Return the diagram for print: dark on white, and finer than the screen."""
        drawn = DiagramView()
        drawn.resize(PRINTED_PX)
        drawn.set_style(LIGHT.enlarged(drawn.devicePixelRatioF()))
        drawn.show_diagram(self._diagram)
        image = QImage(PRINTED_PX * PRINTED_FINER, QImage.Format.Format_RGB32)
        image.setDevicePixelRatio(PRINTED_FINER)
        image.fill(LIGHT.background)
        drawn.render(image, QPoint(), QRegion(), QWidget.RenderFlag.DrawChildren)
        return image

    @property
    def frame(self) -> QRectF:
        """The place of the diagram's window in the widget, in pixels."""
        return QRectF() if self._diagram is None else self._layout(self._diagram)[0]

    def to_px(self, x: float, y: float) -> QPointF:
        """Return the place in the widget of a point of the diagram."""
        assert self._diagram is not None
        frame, (across, up) = self._layout(self._diagram)
        place = np.array([across.unit(np.array([x]))[0], up.unit(np.array([y]))[0]])
        return QPointF(*_places(frame, place).tolist())

    # -- spots

    def spot_at(self, place: QPointF, key_only: bool = False) -> Spot | None:
        """Return the nearest spot within `HIT_PX`; `key_only` ignores spots without a key."""
        if self._diagram is None:
            return None
        nearest, hit = HIT_PX, None
        places = self._spots_px(self._diagram).tolist()
        for spot, (x, y) in zip(self._diagram.spots, places, strict=True):
            distance = math.hypot(x - place.x(), y - place.y())
            if distance < nearest and (spot.key or not key_only):
                nearest, hit = distance, spot
        return hit

    def _spots_px(self, diagram: Diagram) -> Floats:
        """Return the places of the spots in the widget, (n, 2); laying out takes the time."""
        frame, (across, up) = self._layout(diagram)
        points = np.array([(spot.x, spot.y) for spot in diagram.spots]).reshape(-1, 2)
        units = np.column_stack([across.unit(points[:, 0]), up.unit(points[:, 1])])
        return _places(frame, units)

    def _key_at(self, place: QPointF) -> str:
        spot = self.spot_at(place, key_only=True)
        if spot is not None or self._diagram is None:
            return "" if spot is None else spot.key
        nearest, hit = HIT_PX, ""
        for curve in self._diagram.curves:
            for key, (x, y) in zip(curve.keys, curve.points, strict=False):
                away = self.to_px(x, y) - place
                distance = math.hypot(away.x(), away.y())
                if distance < nearest:  # never of a NaN
                    nearest, hit = distance, key
        return hit

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

    # -- layout

    @property
    def _small(self) -> QFont:
        font = QFont(self.font())
        font.setPointSizeF(0.85 * font.pointSizeF())
        return font

    @property
    def _bold(self) -> QFont:
        font = QFont(self.font())
        font.setBold(True)
        return font

    def _layout(self, diagram: Diagram) -> tuple[QRectF, tuple[_DiagramAxis, _DiagramAxis]]:
        """Return the frame, and the axes across and up."""
        ticks = (diagram.x_ticks, diagram.y_ticks)
        x_ticks, y_ticks = (None if t is None else list(map(float, t)) for t in ticks)
        across = _DiagramAxis(diagram.left, diagram.right, diagram.x_log, x_ticks)
        up = _DiagramAxis(diagram.bottom, diagram.top, diagram.y_log, y_ticks)
        small = QFontMetricsF(self._small)
        line, label = small.height(), QFontMetricsF(self.font()).height()
        top = label + GAP_PX if diagram.title else 0.0
        top += 0.0 if _is_picture(diagram) else line / 2.0
        bottom = GAP_PX if _is_picture(diagram) else line + TICK_PX + GAP_PX
        bottom += label if diagram.x_label else 0.0
        marks = self._marks(diagram, up, self.height() - top - bottom, False)
        texts = [figure_text(mark) for mark in marks]
        widest = max((small.horizontalAdvance(text) for text in texts), default=0.0)
        left = widest + TICK_PX + GAP_PX + (label if diagram.y_label else 0.0) + 1.0
        right = small.horizontalAdvance("0000") / 2.0
        frame = QRectF(self.rect()).adjusted(left, top, -right, -bottom)
        if diagram.equal and across.usable and up.usable and frame.isValid():
            frame = _in_proportion(frame, abs(across.high - across.low), abs(up.high - up.low))
        return frame, (across, up)

    def _marks(
        self, diagram: Diagram, axis: _DiagramAxis, length: float, is_across: bool
    ) -> list[float]:
        """Return the ticks whose numbers do not overlap; a picture has none."""
        if not axis.usable or length <= 0.0 or _is_picture(diagram):
            return []
        metrics = QFontMetricsF(self._small)
        each = metrics.horizontalAdvance("000000") if is_across else 1.6 * metrics.height()
        return axis.marks(max(2, min(9, int(length / each))))

    def _placed_marks(
        self, diagram: Diagram, axis: _DiagramAxis, length: float, is_across: bool
    ) -> list[tuple[float, float]]:
        """Return the ticks and their places along the axis, 0 to 1, in the order of the places."""
        marks = self._marks(diagram, axis, length, is_across)
        places = axis.unit(np.array(marks)).tolist()
        return sorted(zip(marks, places, strict=True), key=lambda pair: pair[1])

    # -- painting

    def paintEvent(self, event: QPaintEvent) -> None:
        diagram = self._diagram
        if diagram is None:
            return
        frame, (across, up) = self._layout(diagram)
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_title(painter, diagram, frame)
        if frame.isValid():
            painter.fillRect(frame, QColor(self._style.background))
            if across.usable and up.usable:
                self._paint_ticks(painter, diagram, frame, (across, up))
                painter.save()
                painter.setClipRect(frame.adjusted(-1.0, -1.0, 1.0, 1.0))
                seen = seen_parts(diagram.curves, across, up)
                for curve, parts in zip(diagram.curves, seen, strict=True):
                    self._paint_curve(painter, frame, curve, parts)
                along = [_along(frame, parts) for parts in seen]
                self._paint_names(painter, frame, diagram.curves, along)
                painter.restore()
                self._paint_spots(painter, frame, diagram, along)
            self._paint_frame(painter, frame)
        if self.hasFocus():
            painter.setPen(QPen(self.palette().highlight(), 2.0))
            painter.drawRect(self.rect().adjusted(1, 1, -1, -1))
        painter.end()

    def _colour(self, name: str) -> QColor:
        return QColor(name if name.startswith("#") else getattr(self._style, name))

    def _pen(self, colour: str, width: float = 1.0) -> QPen:
        pen = QPen(self._colour(colour))
        pen.setWidthF(_LINE * width * self._style.line_width / self.devicePixelRatioF())
        pen.setCapStyle(Qt.PenCapStyle.SquareCap)  # round caps take ten times as long
        return pen

    def _paint_frame(self, painter: QPainter, frame: QRectF) -> None:
        painter.setPen(self._pen("muted", 0.7))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(frame)

    def _paint_title(self, painter: QPainter, diagram: Diagram, frame: QRectF) -> None:
        painter.setPen(QColor(self._style.ink))
        painter.setFont(self._bold)
        metrics = QFontMetricsF(self._bold)
        title = metrics.elidedText(
            of_phenomena(diagram.title), Qt.TextElideMode.ElideRight, self.width()
        )
        line = QRectF(0.0, 0.0, self.width(), metrics.height())
        painter.drawText(line, Qt.AlignmentFlag.AlignHCenter, title)
        painter.setFont(self.font())
        height = QFontMetricsF(self.font()).height()
        if diagram.x_label:
            below = frame.bottom() + TICK_PX + GAP_PX + QFontMetricsF(self._small).height()
            line = QRectF(0.0, below, 2.0 * frame.center().x(), height)
            text = of_phenomena(diagram.x_label)
            painter.drawText(line, Qt.AlignmentFlag.AlignHCenter, text)
        if diagram.y_label:
            painter.save()
            painter.rotate(-90.0)
            # After the rotation, x goes up the widget from its top.
            line = QRectF(-2.0 * frame.center().y(), 0.0, 2.0 * frame.center().y(), height)
            text = of_phenomena(diagram.y_label)
            painter.drawText(line, Qt.AlignmentFlag.AlignHCenter, text)
            painter.restore()

    def _paint_ticks(
        self,
        painter: QPainter,
        diagram: Diagram,
        frame: QRectF,
        axes: tuple[_DiagramAxis, _DiagramAxis],
    ) -> None:
        across, up = axes
        painter.setPen(self._pen("muted", 0.5))
        for place in across.unit(np.array(across.given())).tolist():
            x = frame.left() + place * frame.width()
            painter.drawLine(QLineF(x, frame.bottom(), x, frame.top()))
        for place in up.unit(np.array(up.given())).tolist():
            y = frame.bottom() - place * frame.height()
            painter.drawLine(QLineF(frame.left(), y, frame.right(), y))
        painter.setFont(self._small)
        metrics = QFontMetricsF(self._small)
        free = -math.inf
        for mark, place in self._placed_marks(diagram, across, frame.width(), True):
            x = frame.left() + place * frame.width()
            painter.setPen(self._pen("muted", 0.5))
            painter.drawLine(QLineF(x, frame.bottom(), x, frame.bottom() + TICK_PX))
            text, width = figure_text(mark), metrics.horizontalAdvance(figure_text(mark))
            if x - width / 2.0 >= free:
                painter.setPen(QColor(self._style.ink))
                top = frame.bottom() + TICK_PX
                box = QRectF(x - width, top, 2.0 * width, metrics.height())
                painter.drawText(box, Qt.AlignmentFlag.AlignHCenter, text)
                free = x + width / 2.0 + 2.0 * GAP_PX
        free = math.inf
        for mark, place in self._placed_marks(diagram, up, frame.height(), False):
            y = frame.bottom() - place * frame.height()
            painter.setPen(self._pen("muted", 0.5))
            painter.drawLine(QLineF(frame.left() - TICK_PX, y, frame.left(), y))
            if y + metrics.height() / 2.0 <= free:
                painter.setPen(QColor(self._style.ink))
                top = y - metrics.height() / 2.0
                box = QRectF(0.0, top, frame.left() - TICK_PX - GAP_PX, metrics.height())
                painter.drawText(box, Qt.AlignmentFlag.AlignRight, figure_text(mark))
                free = top - 1.0

    def _paint_curve(self, painter: QPainter, frame: QRectF, curve: Curve, parts: Floats) -> None:
        if curve.dots:
            radius = self._radius(curve)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(self._colour(curve.colour))
            for x, y in _places(frame, parts).tolist():
                painter.drawEllipse(QPointF(x, y), radius, radius)
            return
        painter.setPen(self._pen(curve.colour, curve.width))
        ends_px = _places(frame, parts).reshape(-1, 4).tolist()
        painter.drawLines([QLineF(*ends) for ends in ends_px])

    def _radius(self, curve: Curve) -> float:
        """Return the radius of a curve's dots."""
        radius = DOT_PX * curve.width * self._style.line_width / LIGHT.line_width
        return radius / self.devicePixelRatioF()

    def _paint_names(
        self, painter: QPainter, frame: QRectF, curves: Sequence[Curve], along: Sequence[Floats]
    ) -> None:
        """Write each curve's name beside it, or in a list where there is no room for that."""
        font = self._small
        line = QFontMetricsF(font).height()
        room = min(frame.width() / (_LINES_ACROSS * line), frame.height() / (_LINES_DOWN * line))
        font.setPointSizeF(font.pointSizeF() * max(_LEAST_NAME, min(1.0, room)))
        metrics = QFontMetricsF(font)
        painter.setFont(font)
        # A name must not hide thin lines or whole dots.
        halves = [self._radius(curve) if curve.dots else 1.0 for curve in curves]
        covered = np.concatenate(
            [np.empty((0, 4))]
            + [np.hstack([at - half, at + half]) for at, half in zip(along, halves, strict=True)]
        )
        bounds, taken = _bounds(frame), np.empty((0, 4))
        # Dots first, because a line offers many places.
        named = sorted(zip(curves, along, halves, strict=True), key=lambda each: not each[0].dots)
        for curve, places, half in named:
            if not curve.label:
                continue
            text = of_phenomena(curve.label)
            size = _width(text, font) + 2.0 * GAP_PX, metrics.height()
            kept = self.names.get(curve.label)
            place = beside_curve(bounds, places, half, size, taken, covered, kept)
            self.names[curve.label] = place
            left, top, right, bottom = place.tolist()
            taken = np.vstack([taken, (left, top, right, bottom)])
            box = QRectF(left, top, right - left, bottom - top)
            # A sample of the curve would look like one more point of the diagram.
            if curve.colour == "ink":
                plate, ink = faded(self._style.background, 0.8), QColor(self._style.ink)
            else:
                plate = self._colour(curve.colour)
                ink = QColor(self._style.text_on(plate.name()))
            painter.fillRect(box, plate)
            painter.setPen(ink)
            _write(painter, box, text)

    def _paint_spots(
        self, painter: QPainter, frame: QRectF, diagram: Diagram, along: Sequence[Floats]
    ) -> None:
        """Draw the spots and their names, with a line to the names that are farther away."""
        spots = diagram.spots
        if not spots:
            return
        metrics = QFontMetricsF(self._small)
        painter.setFont(self._small)
        radius = DOT_PX * self._style.line_width / LIGHT.line_width / self.devicePixelRatioF()
        points = self._spots_px(diagram)
        shown = np.isfinite(points).all(axis=1)
        widths = [metrics.horizontalAdvance(spot.name) for spot in spots]
        sizes = np.array([(width + 2.0 if width else 0.0, metrics.height()) for width in widths])
        sizes[~shown, 0] = 0.0
        rings = np.array([1.5 * radius if spot.marked else 0.0 for spot in spots])
        gaps = radius + GAP_PX + rings
        named = [self.names[curve.label] for curve in diagram.curves if curve.label]
        taken = np.vstack([np.empty((0, 4)), *named])
        curves_px = np.concatenate([np.empty((0, 2)), *along])
        names = beside(np.nan_to_num(points), sizes, _bounds(frame), curves_px, gaps, taken)
        self.spot_names = {}
        for spot, place, box in zip(spots, points, names, strict=True):
            if box is None:
                continue
            left, top, right, bottom = box.tolist()
            self.spot_names[spot.name] = QRectF(left, top, right - left, bottom - top)
            nearest = np.clip(place, box[:2], box[2:])
            if math.hypot(*(nearest - place)) > 3.0 * (radius + GAP_PX):
                painter.setPen(self._pen("muted", 0.4))
                painter.drawLine(QLineF(*place.tolist(), *nearest.tolist()))
            painter.setPen(self._colour("muted" if spot.faded else "ink"))
            painter.drawText(
                self.spot_names[spot.name], Qt.AlignmentFlag.AlignCenter, of_phenomena(spot.name)
            )
        for spot, (x, y) in zip(reversed(spots), points[::-1].tolist(), strict=True):
            if not math.isfinite(x + y):
                continue
            if spot.broken:
                painter.setPen(self._pen(spot.colour, 1.3))
                painter.drawLine(QLineF(x - radius, y - radius, x + radius, y + radius))
                painter.drawLine(QLineF(x - radius, y + radius, x + radius, y - radius))
                continue
            size = 0.8 * radius if spot.faded else 1.2 * radius
            colour = "muted" if spot.faded else spot.colour
            painter.setPen(self._pen(colour, 1.0) if spot.hollow else Qt.PenStyle.NoPen)
            painter.setBrush(self._colour("background" if spot.hollow else colour))
            painter.drawEllipse(QPointF(x, y), size, size)
            if spot.marked:
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.setPen(self._pen("u", 1.3))
                painter.drawEllipse(QPointF(x, y), 2.2 * radius, 2.2 * radius)


def _width(text: str, font: QFont) -> float:
    if "_" in text:
        return typeset(text, font).width
    return QFontMetricsF(font).horizontalAdvance(text)


def _write(painter: QPainter, box: QRectF, text: str) -> None:
    """Write a text in the middle of a box, with ``x_p`` as letters with subscripts."""
    if "_" not in text:
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)
        return
    laid, middle = typeset(text, painter.font()), box.center()
    laid.paint(painter, middle.x() - laid.width / 2.0, middle.y() + laid.below_middle)


def _is_picture(diagram: Diagram) -> bool:
    """Whether the diagram is a picture, without numbers and with all the space."""
    return diagram.equal and not (diagram.x_label or diagram.y_label)


def _in_proportion(frame: QRectF, width: float, height: float) -> QRectF:
    """Return the largest centred rectangle of these proportions in a frame."""
    scale = min(frame.width() / width, frame.height() / height)
    inside = QRectF(0.0, 0.0, width * scale, height * scale)
    inside.moveCenter(frame.center())
    return inside


def _bounds(frame: QRectF) -> Floats:
    return np.array([frame.left(), frame.top(), frame.right(), frame.bottom()])


def _places(frame: QRectF, points: Floats) -> Floats:
    """Convert points of the unit square, (..., 2), to pixels."""
    places: Floats = points * (frame.width(), -frame.height()) + (frame.left(), frame.bottom())
    return places


def _inside(points: Floats) -> NDArray[np.bool_]:
    return np.asarray(((points >= 0.0) & (points <= 1.0)).all(axis=1))  # not for NaN


def _along(frame: QRectF, parts: Floats) -> Floats:
    """Return some dozens of places along the visible part of a curve, (n, 2) in pixels."""
    points = parts
    if parts.ndim == 3:
        steps = np.linspace(0.0, 1.0, max(2, 40 // max(1, len(parts))))[:, None, None]
        points = (parts[:, 0] + steps * (parts[:, 1] - parts[:, 0])).reshape(-1, 2)
        points = points[np.argsort(points[:, 0], kind="stable")]
        points = points[_inside(points)]
    return _places(frame, points[:: max(1, len(points) // 40)])
