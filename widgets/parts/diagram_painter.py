"""Paint a diagram with Qt's painter: frame, ticks, and curves with their names beside them.

The window paints diagrams at the screen's resolution, a picture or a PDF at its own. matplotlib's
canvas takes 30 to 70 ms for one of our diagrams, too long to follow a drag; this takes 1 to 7 ms.
"""

import math
from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, QSizeF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPen, QPicture

from app.drawings.curve_names import GAP_PX, beside, beside_curve, stays
from app.drawings.style import LIGHT, Style
from app.scenes.phenomena.words import Curve, Diagram
from widgets.parts.diagram_axis import DiagramAxis, Floats, inside, seen_parts
from widgets.parts.messages import figure_text, of_phenomena
from widgets.parts.panel import faded
from widgets.parts.typeset import Typeset, resized, words

TICK_PX = 4.0
_LINE = 0.75  # width relative to a line in a pane, which has no antialiasing
DOT_PX = 3.0  # radius of a dot at the ordinary line width
SMALL = 0.85  # size of names and numbers, relative to the axes' labels
_LINES_ACROSS, _LINES_DOWN = 12.0, 8.0  # lines of names for which a small diagram has room
_LEAST_NAME = 0.7  # least size of names, relative to the ordinary size
_SAMPLE_EM = 1.8  # length of a piece of a curve in a key, in heights of a line
_TRIES = 4  # until a key has room
_CENTRED = Qt.AlignmentFlag.AlignHCenter


class DiagramPainter:
    """Lays out a diagram in a size, and paints it there.

    `frame` is the place of the diagram's window. `names` are the places of the curves' names (left,
    top, right, bottom), kept where possible. On paper, in `one_size`, all letters have that of the
    font; names without a good place are in a key below the diagram, which is `keyed` pixels high:
    beside a piece of their curve, or the number of a spot.
    """

    def __init__(
        self,
        diagram: Diagram,
        size: QSizeF,
        font: QFont,
        style: Style,
        *,
        ratio: float = 1.0,
        names: dict[str, Floats] | None = None,
        has_grid: bool = False,
        one_size: bool = False,
    ) -> None:
        self._diagram, self._size, self._style = diagram, size, style
        self._ratio, self._has_grid = ratio, has_grid
        self.names: dict[str, Floats] = {} if names is None else names
        self._one_size = one_size
        self._font, self._small = font, font if one_size else resized(font, SMALL)
        self._is_picture = diagram.equal and not (diagram.x_label or diagram.y_label)
        ticks = (diagram.x_ticks, diagram.y_ticks)
        x_ticks, y_ticks = (None if t is None else list(map(float, t)) for t in ticks)
        self._across = DiagramAxis(diagram.left, diagram.right, diagram.x_log, x_ticks)
        self._up = DiagramAxis(diagram.bottom, diagram.top, diagram.y_log, y_ticks)
        self.keyed, self._key = 0.0, list[tuple[Curve | int, Typeset]]()
        self.frame = self._frame(QFontMetricsF(self._small), QFontMetricsF(font).height())
        for _ in range(_TRIES if one_size else 0):  # a longer key makes the diagram smaller
            blank = QPicture()
            with QPainter(blank) as painter:
                self.paint(painter)
            lines = 1 + max((line for line, _ in self._key_places()), default=-1)
            if (high := lines * QFontMetricsF(font).height()) <= self.keyed:
                break
            self.keyed = high + GAP_PX
            self.frame = self._frame(QFontMetricsF(self._small), QFontMetricsF(font).height())

    def _frame(self, small: QFontMetricsF, label: float) -> QRectF:
        diagram, line = self._diagram, small.height()
        top = label + GAP_PX if diagram.title else 0.0
        top += 0.0 if self._is_picture else line / 2.0
        bottom = self.keyed + GAP_PX if self._is_picture else self.keyed + line + TICK_PX + GAP_PX
        bottom += label if diagram.x_label else 0.0
        marks = self._marks(self._up, self._size.height() - top - bottom, 1.6 * line)
        widest = max((small.horizontalAdvance(text) for _, text in marks), default=0.0)
        left = widest + TICK_PX + GAP_PX + (label if diagram.y_label else 0.0) + 1.0
        left += GAP_PX if self._one_size else 0.0  # print has no hinting
        right = small.horizontalAdvance("0000") / 2.0
        frame = QRectF(QPointF(), self._size).adjusted(left, top, -right, -bottom)
        if diagram.equal and self._is_usable and frame.isValid():
            width, height = (abs(axis.high - axis.low) for axis in (self._across, self._up))
            scale = min(frame.width() / width, frame.height() / height)
            whole, frame = frame, QRectF(0.0, 0.0, width * scale, height * scale)
            frame.moveCenter(whole.center())
        return frame

    @property
    def _is_usable(self) -> bool:
        return self._across.usable and self._up.usable

    def _marks(self, axis: DiagramAxis, length: float, each: float) -> list[tuple[float, str]]:
        """Return places along an axis, 0 to 1, and numbers that do not overlap.

        A number takes `each` of the axis's length; a picture has none.
        """
        if not axis.usable or length <= 0.0 or self._is_picture:
            return []
        marks = axis.marks(max(2, min(9, int(length / each))))
        places = axis.unit(np.array(marks)).tolist()
        return sorted(zip(places, map(figure_text, marks), strict=True))

    def to_px(self, points: Floats) -> Floats:
        """Return the places of points of the diagram, (n, 2)."""
        return self._places(
            np.column_stack([self._across.unit(points[:, 0]), self._up.unit(points[:, 1])])
        )

    def _places(self, points: Floats) -> Floats:
        """Convert points of the unit square, (..., 2), to pixels."""
        frame = self.frame
        places: Floats = points * (frame.width(), -frame.height()) + (frame.left(), frame.bottom())
        return places

    @property
    def _bounds(self) -> Floats:
        """Where names may be; on paper they do not touch the frame."""
        frame, room = self.frame, GAP_PX if self._one_size else 0.0
        sides = frame.adjusted(room, room, -room, -room)
        return np.array([sides.left(), sides.top(), sides.right(), sides.bottom()])

    # -- painting

    def paint(self, painter: QPainter) -> None:
        self._key.clear()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_labels(painter)
        if not self.frame.isValid():
            return
        painter.fillRect(self.frame, QColor(self._style.background))
        if self._is_usable:
            self._paint_ticks(painter)
            painter.save()
            painter.setClipRect(self.frame.adjusted(-1.0, -1.0, 1.0, 1.0))
            curves = self._diagram.curves
            seen = seen_parts(curves, self._across, self._up)
            for curve, parts in zip(curves, seen, strict=True):
                self._paint_curve(painter, curve, parts)
            along = [self._along(parts) for parts in seen]
            self._paint_names(painter, curves, along)
            painter.restore()
            self._paint_spots(painter, along)
            self._paint_key(painter)
        painter.setPen(self._pen("muted", 0.7))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(self.frame)

    def _colour(self, name: str) -> QColor:
        return QColor(name if name.startswith("#") else getattr(self._style, name))

    def _pen(self, colour: str, width: float = 1.0) -> QPen:
        pen = QPen(self._colour(colour))
        pen.setWidthF(_LINE * width * self._style.line_width / self._ratio)
        pen.setCapStyle(Qt.PenCapStyle.SquareCap)  # round caps take ten times as long
        return pen

    @property
    def _radius(self) -> float:
        return DOT_PX * self._style.line_width / LIGHT.line_width / self._ratio

    def _paint_labels(self, painter: QPainter) -> None:
        diagram, middle = self._diagram, self.frame.center()
        painter.setPen(QColor(self._style.ink))
        bold = QFont(self._font)
        bold.setBold(True)
        painter.setFont(bold)
        metrics, width = QFontMetricsF(bold), self._size.width()
        title = metrics.elidedText(
            of_phenomena(diagram.title), Qt.TextElideMode.ElideRight, int(width)
        )
        painter.drawText(QRectF(0.0, 0.0, width, metrics.height()), _CENTRED, title)
        painter.setFont(self._font)
        height = QFontMetricsF(self._font).height()
        if diagram.x_label:
            below = self.frame.bottom() + TICK_PX + GAP_PX + QFontMetricsF(self._small).height()
            line = QRectF(0.0, below, 2.0 * middle.x(), height)
            painter.drawText(line, _CENTRED, of_phenomena(diagram.x_label))
        if diagram.y_label:
            painter.save()
            painter.rotate(-90.0)
            # After the rotation, x goes up from the top.
            line = QRectF(-2.0 * middle.y(), 0.0, 2.0 * middle.y(), height)
            painter.drawText(line, _CENTRED, of_phenomena(diagram.y_label))
            painter.restore()

    def _paint_ticks(self, painter: QPainter) -> None:
        frame, metrics = self.frame, QFontMetricsF(self._small)
        line = metrics.height()
        x_marks = self._marks(self._across, frame.width(), metrics.horizontalAdvance("000000"))
        y_marks = self._marks(self._up, frame.height(), 1.6 * line)
        painter.setPen(self._pen("muted", 0.5))
        x_ticks, y_ticks = (axis.unit(np.array(axis.given())) for axis in (self._across, self._up))
        self._paint_lines(painter, x_ticks.tolist(), y_ticks.tolist())
        if self._has_grid:
            painter.setPen(self._pen("margin", 0.5))
            self._paint_lines(painter, [at for at, _ in x_marks], [at for at, _ in y_marks])
        painter.setFont(self._small)
        free = -math.inf
        for place, text in x_marks:
            x, width = frame.left() + place * frame.width(), metrics.horizontalAdvance(text)
            painter.setPen(self._pen("muted", 0.5))
            painter.drawLine(QLineF(x, frame.bottom(), x, frame.bottom() + TICK_PX))
            if x - width / 2.0 >= free:
                painter.setPen(QColor(self._style.ink))
                box = QRectF(x - width, frame.bottom() + TICK_PX, 2.0 * width, line)
                painter.drawText(box, _CENTRED, text)
                free = x + width / 2.0 + 2.0 * GAP_PX
        free = math.inf
        for place, text in y_marks:
            y = frame.bottom() - place * frame.height()
            painter.setPen(self._pen("muted", 0.5))
            painter.drawLine(QLineF(frame.left() - TICK_PX, y, frame.left(), y))
            if y + line / 2.0 <= free:
                painter.setPen(QColor(self._style.ink))
                box = QRectF(0.0, y - line / 2.0, frame.left() - TICK_PX - GAP_PX, line)
                painter.drawText(box, Qt.AlignmentFlag.AlignRight, text)
                free = y - line / 2.0 - 1.0

    def _paint_lines(self, painter: QPainter, across: list[float], up: list[float]) -> None:
        """Paint lines over the whole frame at places along its axes, 0 to 1."""
        frame = self.frame
        for x in (frame.left() + place * frame.width() for place in across):
            painter.drawLine(QLineF(x, frame.bottom(), x, frame.top()))
        for y in (frame.bottom() - place * frame.height() for place in up):
            painter.drawLine(QLineF(frame.left(), y, frame.right(), y))

    def _key_places(self) -> list[tuple[int, float]]:
        """Return the line of each name of the key, and how far from the left its sample begins."""
        places, line, left = list[tuple[int, float]](), 0, 0.0
        sample = QFontMetricsF(self._font).height() * _SAMPLE_EM
        for _, text in self._key:
            if left > 0.0 and left + sample + text.width > self._size.width():
                line, left = line + 1, 0.0
            places.append((line, left))
            left += text.width + 1.5 * sample
        return places

    def _paint_key(self, painter: QPainter) -> None:
        high = QFontMetricsF(self._font).height()
        sample, top = high * _SAMPLE_EM, self._size.height() - self.keyed + GAP_PX
        for (what, text), (line, left) in zip(self._key, self._key_places(), strict=True):
            middle = top + (line + 0.5) * high
            if isinstance(what, int):
                painter.setPen(QColor(self._style.ink))
                box = QRectF(left, middle - high / 2.0, sample - GAP_PX, high)
                painter.drawText(box, Qt.AlignmentFlag.AlignRight, str(what))
            else:
                painter.setPen(self._curve_pen(what))
                painter.drawLine(QLineF(left, middle, left + sample - 2.0 * GAP_PX, middle))
            painter.setPen(QColor(self._style.ink))
            text.paint(painter, left + sample, middle + text.below_middle)

    def _curve_pen(self, curve: Curve) -> QPen:
        pen = self._pen(curve.colour, curve.width)
        if curve.dash:
            pen.setCapStyle(Qt.PenCapStyle.FlatCap)
            pen.setDashPattern(curve.dash)
        return pen

    def _paint_curve(self, painter: QPainter, curve: Curve, parts: Floats) -> None:
        if curve.dots:
            radius = curve.width * self._radius
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(self._colour(curve.colour))
            for x, y in self._places(parts).tolist():
                painter.drawEllipse(QPointF(x, y), radius, radius)
            return
        places = self._places(parts).reshape(-1, 2, 2)
        painter.setPen(self._curve_pen(curve))
        if not curve.dash:
            painter.drawLines([QLineF(*ends) for ends in places.reshape(-1, 4).tolist()])
            return
        ends = np.flatnonzero((places[1:, 0] != places[:-1, 1]).any(axis=1)) + 1
        for chain in np.split(places, ends):
            points = [*chain[:, 0].tolist(), *chain[-1:, 1].tolist()]
            painter.drawPolyline([QPointF(*point) for point in points])

    def _along(self, parts: Floats) -> Floats:
        """Return some dozens of places along the visible part of a curve, (n, 2) in pixels."""
        points = parts
        if parts.ndim == 3:
            steps = np.linspace(0.0, 1.0, max(2, 40 // max(1, len(parts))))[:, None, None]
            points = (parts[:, 0] + steps * (parts[:, 1] - parts[:, 0])).reshape(-1, 2)
            points = points[np.argsort(points[:, 0], kind="stable")]
            points = points[inside(points)]
        return self._places(points[:: max(1, len(points) // 40)])

    def _paint_names(
        self, painter: QPainter, curves: Sequence[Curve], along: Sequence[Floats]
    ) -> None:
        """Write each curve's name beside it, or in a list where there is no room for that."""
        frame, line = self.frame, QFontMetricsF(self._small).height()
        room = min(frame.width() / (_LINES_ACROSS * line), frame.height() / (_LINES_DOWN * line))
        font = self._small
        if not self._one_size:
            font = resized(font, max(_LEAST_NAME, min(1.0, room)))
        height = QFontMetricsF(font).height()
        painter.setFont(font)
        # A name must not hide thin lines or whole dots.
        halves = [curve.width * self._radius if curve.dots else 1.0 for curve in curves]
        covered = np.concatenate(
            [np.empty((0, 4))]
            + [np.hstack([at - half, at + half]) for at, half in zip(along, halves, strict=True)]
        )
        taken = np.empty((0, 4))
        # Dots first, because a line offers many places.
        order = sorted(range(len(curves)), key=lambda i: not curves[i].dots)
        for curve, places, half, i in ((curves[i], along[i], halves[i], i) for i in order):
            if not curve.label:
                continue
            foreign = np.concatenate([np.empty((0, 2)), *along[:i], *along[i + 1 :]])
            text = words(of_phenomena(curve.label), font)
            size, kept = (text.width + 2.0 * GAP_PX, height), self.names.pop(curve.label, None)
            hidden = np.vstack([covered, taken])
            place = None if self._one_size else kept
            if place is None or not stays(place, self._bounds, places, size, hidden):
                place = beside_curve(
                    self._bounds, places, half, size, taken, covered, foreign,
                    strict=self._one_size,
                )  # fmt: skip
            if place is None:
                self._key.append((curve, text))
                continue
            self.names[curve.label] = place
            taken = np.vstack([taken, place])
            left, top, right, bottom = place.tolist()
            box = QRectF(left, top, right - left, bottom - top)
            # A sample of the curve would look like one more point of the diagram.
            if curve.colour == "ink":
                plate, ink = faded(self._style.background, 0.8), QColor(self._style.ink)
            else:
                plate = self._colour(curve.colour)
                ink = QColor(self._style.text_on(plate.name()))
            painter.fillRect(box, plate)
            painter.setPen(ink)
            text.paint(painter, left + GAP_PX, box.center().y() + text.below_middle)

    def _paint_spots(self, painter: QPainter, along: Sequence[Floats]) -> None:
        """Draw the spots and their names, with a line to the names that are farther away."""
        spots = self._diagram.spots
        if not spots:
            return
        metrics, radius = QFontMetricsF(self._small), self._radius
        points = self.to_px(np.array([(spot.x, spot.y) for spot in spots]))
        painter.setFont(self._small)
        shown = np.isfinite(points).all(axis=1)
        widths = [metrics.horizontalAdvance(spot.name) for spot in spots]
        sizes = np.array([(width + 2.0 if width else 0.0, metrics.height()) for width in widths])
        sizes[~shown, 0] = 0.0
        gaps = radius + GAP_PX + np.array([1.5 * radius if spot.marked else 0.0 for spot in spots])
        labels = [curve.label for curve in self._diagram.curves]
        named = [self.names[label] for label in labels if label in self.names]
        taken = np.vstack([np.empty((0, 4)), *named])
        curves_px = np.concatenate([np.empty((0, 2)), *along])
        names = beside(np.nan_to_num(points), sizes, self._bounds, curves_px, gaps, taken)
        texts = [of_phenomena(spot.name) for spot in spots]
        lost = [i for i, box in enumerate(names) if box is None and sizes[i, 0] > 0.0]
        if self._one_size and lost:
            taken = np.vstack([taken, *(box for box in names if box is not None)])
            sizes[:, 0] = 0.0
            sizes[lost, 0] = metrics.horizontalAdvance(str(len(lost))) + 2.0
            again = beside(np.nan_to_num(points), sizes, self._bounds, curves_px, gaps, taken)
            shared = [i for i in lost if again[i] is not None] or lost[:1]
            apart = np.linalg.norm(points[lost][:, None] - points[shared], axis=2).argmin(axis=1)
            for number, i in enumerate(shared, 1):  # in a crowd several have one
                near = [j for j, k in zip(lost, apart.tolist(), strict=True) if shared[k] == i]
                near.sort(key=lambda j: float(points[j, 1]))
                text = " / ".join(texts[j] for j in near)
                self._key.append((number, words(text, self._small)))
                names[i] = again[i]
            for number, i in enumerate(shared, 1):
                texts[i] = str(number)
        for spot, text, place, box in zip(spots, texts, points, names, strict=True):
            if box is None:
                continue
            left, top, right, bottom = box.tolist()
            room = QRectF(left, top, right - left, bottom - top)
            nearest = np.clip(place, box[:2], box[2:])
            if math.hypot(*(nearest - place)) > 3.0 * (radius + GAP_PX):
                painter.setPen(self._pen("muted", 0.4))
                painter.drawLine(QLineF(*place.tolist(), *nearest.tolist()))
            painter.setPen(self._colour("muted" if spot.faded else "ink"))
            painter.drawText(room, Qt.AlignmentFlag.AlignCenter, text)
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
