"""Where the keyboard is: in which order Tab goes through a window, and a frame to see it by.

Qt's own order is that in which widgets were made, so that what a panel makes later would come
last of all, far from the panel. This one is that of the layouts, which is what is seen.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import cast

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QApplication, QLayout, QScrollArea, QSplitter, QWidget

RING_PX = 2
"""As wide as it is seen from the back row."""


def focus_next(window: QWidget, forwards: bool) -> bool:
    """Give the focus to the widget after or before the one that has it; whether there is one."""
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
    """Whether Tab stops here; a scroll area is of use to the keyboard if it has to scroll."""
    if not (widget.isEnabled() and widget.focusPolicy() & Qt.FocusPolicy.TabFocus):
        return False
    if isinstance(widget, QScrollArea):
        bars = (widget.horizontalScrollBar(), widget.verticalScrollBar())
        return any(bar.maximum() > bar.minimum() for bar in bars)
    return True


def _in_order(widget: QWidget, focus: QWidget | None) -> Iterator[QWidget]:
    """What can be seen inside a widget, depth first, and what has the focus even if it cannot."""
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
    """Those of these widgets that it lays out, in its order.

    Not by `itemAt`: an item is no QObject, so that when it has gone PySide takes whatever comes to
    lie in its place for it.
    """
    placed: list[tuple[int, list[QWidget]]] = [
        (place, [widget]) for widget in widgets if (place := layout.indexOf(widget)) >= 0
    ]
    for inner in layout.children():
        if isinstance(inner, QLayout):
            placed.append((layout.indexOf(inner), _of_layout(inner, widgets)))
    return [widget for _, found in sorted(placed, key=lambda part: part[0]) for widget in found]


def lay_out() -> None:
    """Let all layouts take their new sizes now, before what has the focus is scrolled to."""
    for _ in range(4):  # row, section, column, scroll area: each tells only the one around it
        QApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)


class FocusRing(QWidget):
    """A frame round what Qt shows no focus of: it lies over the widget while that has the focus."""

    def __init__(self, ringed: QWidget) -> None:
        super().__init__(ringed)
        self._ringed = ringed
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()
        cast(QApplication, QApplication.instance()).focusChanged.connect(self._follow)

    def _follow(self, left: QWidget | None, entered: QWidget | None) -> None:
        if entered is self._ringed:
            self._ringed.installEventFilter(self)  # no longer: a pane is drawn at every step
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
