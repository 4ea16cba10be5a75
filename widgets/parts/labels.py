"""Labels that mark, shorten or balance their text."""

from bisect import bisect_left
from collections.abc import Iterable
from itertools import product

from PySide6.QtCore import QPoint, QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QSizePolicy, QWidget

from widgets.parts.icons import paint_icon
from widgets.parts.layouts import FittedWidget, LetteredWidget
from widgets.parts.plain import PlainLabel, TextDocument, set_tip, subscripts

_ON_IT = 100.0  # px² of names that a label may hide rather than move by 1 px onto its own place
SIGN = 1.25  # width of a warning sign and the gap after it, in line heights
REFUSAL_SHEET = "QLabel { border: 0px; border-left: 3px solid #d55e00; padding: 1px 0 2px 5px; }"


class WarningLabel(LetteredWidget, PlainLabel):
    """Plain text after a warning sign; an empty text has no sign."""

    def __init__(self) -> None:
        super().__init__(wordWrap=True)
        self.is_warning = True  # whether the text is a warning
        self._fit()

    def set_is_warning(self, warns: bool) -> None:
        """Set whether the next text is a warning."""
        self.is_warning = warns
        self._fit()

    def _fit(self) -> None:
        self.setIndent(round(SIGN * self.fontMetrics().height()) if self.is_warning else 0)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.is_warning and self.text():
            side, room = self.fontMetrics().height(), self.contentsRect()
            with QPainter(self) as painter:
                paint_icon(painter, QRect(room.left(), room.top(), side, side), "warning")


class RefusalLabel(WarningLabel):
    """A line for a refusal; it is hidden while there is none.

    Its text has the ordinary colour; a bar, a sign and the words mark it.
    """

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("rowError")
        self.setStyleSheet(REFUSAL_SHEET)
        self.hide()

    def show_text(self, text: str) -> None:
        """Show this text; hide the line if it is empty."""
        if text != self.text():  # otherwise a hidden line would appear again
            self.setText(text)
            self.setVisible(bool(text))


class NoteLabel(FittedWidget, LetteredWidget, PlainLabel):
    """A line of text that is elided if there is no room; the tooltip has all of it."""

    def __init__(self) -> None:
        super().__init__(objectName="paneNote")
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._whole = ""

    def setText(self, text: str) -> None:
        if text != self._whole:  # seldom while something is dragged
            self._whole = text
            set_tip(self, text)
            self.setAccessibleDescription(text)
            self._fit()

    def text(self) -> str:
        return self._whole

    def sizeHint(self) -> QSize:
        """Request no width: the note takes the remaining space."""
        return QSize(0, super().sizeHint().height())

    def _fit(self) -> None:
        shown = self.fontMetrics().elidedText(
            self._whole, Qt.TextElideMode.ElideRight, self.width()
        )
        if shown != super().text():
            super().setText(shown)


class Title(NoteLabel):
    """A note that requests the width of its whole text."""

    def __init__(self, text: str, name: str = "paneTitle") -> None:
        super().__init__()
        self.setObjectName(name)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self.setText(text)

    def setText(self, text: str) -> None:
        super().setText(text)
        self.updateGeometry()  # even if no more of the longer text is visible

    def sizeHint(self) -> QSize:
        width = self.fontMetrics().horizontalAdvance(self.text())
        return QSize(width + 2, super().sizeHint().height())  # a letter may overhang

    def minimumSizeHint(self) -> QSize:
        return QSize(0, super().minimumSizeHint().height())

    def _fit(self) -> None:
        super()._fit()
        set_tip(self, "" if PlainLabel.text(self) == self.text() else self.text())


class Balanced(PlainLabel):
    """Plain text that wraps into lines of about equal length, without a lonely last word.

    Letters after an underscore are subscripts, but not in a `name`, such as that of a file.
    """

    def __init__(self, text: str = "", *, name: bool = False) -> None:
        super().__init__(text, wordWrap=True)
        self._is_name = name

    def paintEvent(self, event: QPaintEvent) -> None:
        # Qt reserves the height of the full width; the same number of lines fits a smaller width.
        inside, metrics = self.contentsRect(), self.fontMetrics()
        wrap = Qt.TextFlag.TextWordWrap | Qt.AlignmentFlag.AlignLeft

        def height(width: int, text: str) -> int:
            return metrics.boundingRect(QRect(0, 0, width, 1 << 20), wrap, text).height()

        parts = self.text().split("\n")
        heights = [height(inside.width(), part) for part in parts]
        top = inside.top() + max(0, inside.height() - sum(heights)) // 2
        with QPainter(self) as painter:
            painter.setPen(self.palette().color(self.foregroundRole()))
            for part, needed in zip(parts, heights, strict=True):
                width = inside.width()
                if needed >= 2 * metrics.height():  # of several lines
                    longest = max(map(metrics.horizontalAdvance, part.split()), default=0)
                    widths = range(min(longest + 2, width), width)
                    place = bisect_left(widths, True, key=lambda w: height(w, part) <= needed)
                    width = widths.start + place
                if "_" in part and not self._is_name:
                    self._paint_subscripts(painter, inside.left(), top, width, part)
                else:
                    painter.drawText(QRect(inside.left(), top, width, needed), wrap, part)
                top += needed

    def _paint_subscripts(
        self, painter: QPainter, left: int, top: int, width: int, text: str
    ) -> None:
        document = TextDocument()
        document.setDefaultFont(self.font())
        document.setDocumentMargin(0.0)
        document.setHtml(subscripts(text))
        document.setTextWidth(width)
        palette = QPalette(self.palette())
        palette.setColor(QPalette.ColorRole.Text, painter.pen().color())
        document.paint(painter, QPointF(left, top), palette)


class BesideLabel(PlainLabel):
    """A text beside a place in its parent, which lets the mouse through."""

    def __init__(self, parent: QWidget, name: str) -> None:
        super().__init__(
            parent=parent, objectName=name, wordWrap=True, margin=3, autoFillBackground=True,
            visible=False,
        )  # fmt: skip
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)

    def put_beside(
        self, around: QPoint, apart: int, *, above: bool = False, off: Iterable[QRectF] = ()
    ) -> None:
        """Lie beside a place, below or above it, inside the parent and off boxes if it can."""
        room = self.parentWidget() or self.window()
        frame = 2 * self.margin() + 2
        width = min(self.fontMetrics().horizontalAdvance(self.text()) + frame, room.width())
        height = self.heightForWidth(width)
        boxes, costs = list(off), dict[tuple[int, int], float]()
        for away, high, left in product((apart, 2 * apart), (above, not above), (False, True)):
            x = around.x() + (-away - width if left else away)
            y = around.y() + (-away - height if high else away)
            at_x = max(0, min(x, room.width() - width))
            at_y = max(0, min(y, room.height() - height))
            meets = [QRectF(at_x, at_y, width, height).intersected(box) for box in boxes]
            hidden = sum(each.width() * each.height() for each in meets)
            costs.setdefault((at_x, at_y), hidden + abs(x - at_x) + _ON_IT * abs(y - at_y))
        self.setGeometry(*min(costs, key=costs.__getitem__), width, height)
        self.raise_()
