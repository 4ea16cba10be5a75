"""The keyboard's focus: the order in which Tab goes through a window, and a frame around it.

Qt's Tab order is the order of creation: widgets that a panel creates later would come last, far
from the panel. The order here is that of the layouts, which the user sees.
"""

from collections.abc import Iterator
from typing import cast

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QApplication, QLayout, QScrollArea, QSplitter, QWidget

RING_PX = 2  # width of the frame, visible from the back row


def focus_next(window: QWidget, forwards: bool) -> bool:
    """Move the focus to the next or previous widget; return False if there is no other one."""
    focus, reasons = QApplication.focusWidget(), Qt.FocusReason
    stops = [
        widget
        for widget in _in_order(window, focus)
        if widget is focus or (widget.isVisibleTo(window) and _is_stop(widget))
    ]
    if not forwards:
        stops.reverse()
    at = stops.index(focus) if focus in stops else -1
    following = next((widget for widget in stops[at + 1 :] + stops[: at + 1]), focus)
    if following is None or following is focus:
        return False
    following.setFocus(reasons.TabFocusReason if forwards else reasons.BacktabFocusReason)
    area = following.parentWidget()
    while area is not None:
        if isinstance(area, QScrollArea):
            area.ensureWidgetVisible(following)
        area = area.parentWidget()
    return True


def _is_stop(widget: QWidget) -> bool:
    """Whether Tab stops here; a scroll area is a stop only if it can scroll."""
    if not (widget.isEnabled() and widget.focusPolicy() & Qt.FocusPolicy.TabFocus):
        return False
    if isinstance(widget, QScrollArea):
        bars = (widget.horizontalScrollBar(), widget.verticalScrollBar())
        return any(bar.maximum() > bar.minimum() for bar in bars)
    return True


def _in_order(widget: QWidget, focus: QWidget | None) -> Iterator[QWidget]:
    """Yield the visible widgets inside a widget, depth first; also a hidden one with the focus."""
    layout = widget.layout()
    inside: list[QObject | None] = []
    if layout is not None:
        inside += _of_layout(layout, [w for w in widget.children() if isinstance(w, QWidget)])
    if isinstance(widget, QSplitter):
        inside = [widget.widget(place) for place in range(widget.count())]
    for child in dict.fromkeys([*inside, *widget.children()]):
        if not isinstance(child, QWidget) or child.isWindow():
            continue
        if not child.isHidden() or (focus and (child is focus or child.isAncestorOf(focus))):
            yield child
            yield from _in_order(child, focus)


def _of_layout(layout: QLayout, widgets: list[QWidget]) -> list[QWidget]:
    """Return those of these widgets that are in a layout, in its order.

    `itemAt` is not used: an item is not a QObject. Once it is deleted, PySide would take whatever
    lies at its address for it.
    """
    placed: list[tuple[int, list[QWidget]]] = [
        (place, [widget]) for widget in widgets if (place := layout.indexOf(widget)) >= 0
    ]
    for inner in layout.children():
        if isinstance(inner, QLayout):
            placed.append((layout.indexOf(inner), _of_layout(inner, widgets)))
    return [widget for _, ordered in sorted(placed, key=lambda part: part[0]) for widget in ordered]


def lay_out() -> None:
    """Apply all pending layouts now, before something is scrolled into view."""
    for _ in range(4):  # row, section, column, scroll area: each notifies only its parent
        QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)


class FocusRing(QWidget):
    """A frame over the focused widget if Qt draws none."""

    def __init__(self, ringed: QWidget) -> None:
        super().__init__(ringed)
        self._ringed = ringed
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()
        cast(QApplication, QApplication.instance()).focusChanged.connect(self._follow)

    def _follow(self, left: QWidget | None, entered: QWidget | None) -> None:
        if entered is self._ringed:
            self._ringed.installEventFilter(self)  # not earlier: a pane is drawn at every step
            self.setGeometry(self._ringed.rect())
            self.raise_()
            self.show()
        elif left is self._ringed:
            self._ringed.removeEventFilter(self)
            self.hide()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self.setGeometry(self._ringed.rect())
        return super().eventFilter(watched, event)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter, half = QPainter(self), RING_PX // 2
        painter.setPen(QPen(self.palette().highlight().color(), RING_PX))
        painter.drawRect(self.rect().adjusted(half, half, -half, -half))
        painter.end()
