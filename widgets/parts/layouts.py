"""Functions that make buttons, rows and columns of widgets, and the order in which Tab visits them.

Qt's Tab order is the order of creation: widgets that a panel creates later would come last, far
from the panel. The order here is that of the layouts, which the user sees.
"""

import re
import sys
from abc import abstractmethod
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, TypeAlias, TypeVar, cast

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtGui import QKeySequence, QPainter, QPaintEvent, QPen, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QBoxLayout,
    QDialog,
    QDialogButtonBox,
    QFrame,
    QHBoxLayout,
    QLayout,
    QPushButton,
    QScrollArea,
    QSplitter,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from widgets.parts.icons import show_icon
from widgets.parts.plain import set_tip

if TYPE_CHECKING:
    OfWidget = QWidget
else:
    OfWidget = object  # the class is a QWidget already

RING_PX = 2  # width of the frame, visible from the back row


class FittedWidget(OfWidget):
    """A widget that fits its content again after each change of its size."""

    @abstractmethod
    def _fit(self) -> None: ...

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()


class LetteredWidget(OfWidget):
    """A widget that fits its content again after each change of its font."""

    @abstractmethod
    def _fit(self) -> None: ...

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._fit()


def focus_next(window: QWidget, forwards: bool) -> bool:
    """Move the focus on or back, or from what goes to what is near; return False if it stays."""
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
    around = focus if focus and not (focus.isVisible() and focus.isEnabled()) else None
    while (around := around and around.parentWidget()) and not isinstance(around, QSplitter):
        near = [each for each in stops[at + 1 :] + stops[:at][::-1] if around.isAncestorOf(each)]
        if near:
            following = near[0]
            break
    if following is None or following is focus:
        return False
    following.setFocus(reasons.TabFocusReason if forwards else reasons.BacktabFocusReason)
    area: QWidget | None = following
    while area and (area := area.parentWidget()):
        if isinstance(area, QScrollArea):
            area.ensureWidgetVisible(following)
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


Part: TypeAlias = QWidget | QLayout | tuple[QWidget | QLayout, int | Qt.AlignmentFlag] | int | None
"""A part of a line: a widget or a layout, alone or with its stretch or alignment; a gap in pixels;
or `FREE`."""
FREE = None  # a stretch that takes the remaining room
TOP = Qt.AlignmentFlag.AlignTop  # alignment of a sign beside a text of several lines
_Line = TypeVar("_Line", bound=QBoxLayout)


def in_row(
    *parts: Part,
    on: QWidget | None = None,
    margins: tuple[int, int, int, int] | None = None,
    gap: int | None = None,
) -> QHBoxLayout:
    """Lay out parts side by side; the row fills the widget `on`.

    `margins` are left, above, right, below. They and the `gap` between parts are Qt's if not given.
    """
    return _filled(QHBoxLayout(), parts, on, margins, gap)


def in_column(
    *parts: Part,
    on: QWidget | None = None,
    margins: tuple[int, int, int, int] | None = None,
    gap: int | None = None,
) -> QVBoxLayout:
    """Lay out parts one below the other; see `in_row`."""
    return _filled(QVBoxLayout(), parts, on, margins, gap)


def _filled(
    line: _Line,
    parts: tuple[Part, ...],
    on: QWidget | None,
    margins: tuple[int, int, int, int] | None,
    gap: int | None,
) -> _Line:
    if margins is not None:
        line.setContentsMargins(*margins)
    if gap is not None:
        line.setSpacing(gap)
    for part in parts:
        if part is FREE:
            line.addStretch(1)
            continue
        if isinstance(part, int):
            line.addSpacing(part)
            continue
        added, how = part if isinstance(part, tuple) else (part, 0)
        stretch = 0 if isinstance(how, Qt.AlignmentFlag) else how
        if isinstance(added, QLayout):
            line.addLayout(added, stretch)
        else:
            line.addWidget(added, stretch)
        if isinstance(how, Qt.AlignmentFlag):
            line.setAlignment(added, how)
    if on is not None:
        # Last: if a filled line is added to a line on a widget, PySide wraps the items of the line,
        # and later takes whatever lies at the address of a deleted item for it.
        on.setLayout(line)
    return line


def discard(line: QLayout, widgets: Iterable[QWidget]) -> None:
    """Take widgets out of a line; they are hidden at once, and deleted later."""
    for widget in widgets:
        line.removeWidget(widget)
        widget.hide()
        widget.deleteLater()


def scrolled(inside: QWidget, name: str) -> QScrollArea:
    """Put a widget into a scroll area, named for screen readers."""
    area = QScrollArea(widgetResizable=True)
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setWidget(inside)
    area.setAccessibleName(name)
    area.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    FocusRing(area)
    return area


def paint_now(widget: QWidget) -> None:
    """Give everything its place, and paint it before the function returns."""
    for _ in range(2):  # the stage strip has other rows in another width
        QCoreApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest.value)
    widget.repaint()


_Button = TypeVar("_Button", bound=QAbstractButton)


def tool_button(
    text: str = "",
    tip: str = "",
    act: object = None,
    *,
    icon: str = "",
    name: str = "",
    flat: bool = False,
    checkable: bool = False,
    by_click: bool = False,
) -> QToolButton:
    """Make a tool button; `act` is a function or a signal.

    `icon` is a name in `widgets.parts.icons`, and `name` is for screen readers, if neither the text
    nor the tip of an icon alone says it. A `flat` button has a frame only under the mouse. With
    `by_click` a click gives it the keyboard's focus, as Tab does.
    """
    made = QToolButton(autoRaise=flat)
    if icon:
        show_icon(made, icon)
        if text:
            made.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
    if by_click:
        made.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    made.setCheckable(checkable)
    return _labelled(made, text, tip, act, name or (tip if icon and not text else ""))


def push_button(text: str, tip: str = "", act: object = None, *, name: str = "") -> QPushButton:
    """Make a push button; see `tool_button`."""
    return _labelled(QPushButton(), text, tip, act, name)


def dialog_buttons(dialog: QDialog, accept: QDialogButtonBox.StandardButton) -> QDialogButtonBox:
    buttons = QDialogButtonBox(accept | QDialogButtonBox.StandardButton.Cancel)
    buttons.accepted.connect(dialog.accept)
    buttons.rejected.connect(dialog.reject)
    return buttons


def key_of(text: str) -> QKeySequence:
    """Return the key that a button's text marks, as its tip promises; macOS has no mnemonics."""
    letter = re.search(r"(?<!&)&(\w)", text) if sys.platform == "darwin" else None
    return QKeySequence(f"Alt+{letter[1]}") if letter else QKeySequence.mnemonic(text)


def label_button(button: QAbstractButton, text: str, tip: str) -> None:
    """Give a button its text, with the key that the text promises, and its tooltip."""
    button.setText(text)
    button.setShortcut(key_of(text))
    set_tip(button, tip)


def _labelled(made: _Button, text: str, tip: str, act: object, name: str) -> _Button:
    label_button(made, text, tip)
    if name:
        made.setAccessibleName(name)
    if act is not None:
        made.clicked.connect(act)
    return made
