"""The panels below the panes. Their names stay at the bottom of the window; the open panel is as
high as its content, and at most a third of the window.
"""

from functools import partial

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QPaintEvent
from PySide6.QtWidgets import (
    QAbstractScrollArea,
    QFrame,
    QScrollArea,
    QSizePolicy,
    QSplitter,
    QStackedWidget,
    QStyle,
    QStyleOptionToolButton,
    QStylePainter,
    QTableView,
    QToolButton,
    QWidget,
)

from widgets.parts.layouts import in_column, in_row
from widgets.parts.panel import Panel, ShownData
from widgets.parts.plain import set_tip

LEAST_EM = 4
_UNLIMITED_PX = 2**24 - 1  # Qt's own largest height
LARGEST_SHARE = 1 / 3  # largest share of the window's height for the open panel
STEADY_LINES = 4
"""An open panel whose content has fewer lines less keeps its height: panes must not jump."""
REST_MS = 100  # how long the content of the open panel must have kept its size
IDLE_MS = 1000  # how long nothing must have changed before folded panels are prepared


class _DrawerHead(QToolButton):
    """Opens and folds a panel by a click, Space or Enter; elided if it does not fit."""

    def minimumSizeHint(self) -> QSize:
        return QSize(LEAST_EM * self.fontMetrics().height(), super().minimumSizeHint().height())

    def paintEvent(self, event: QPaintEvent) -> None:
        if self.width() >= self.sizeHint().width():
            super().paintEvent(event)
            return
        option = QStyleOptionToolButton()
        self.initStyleOption(option)
        beside = self.sizeHint().width() - self.fontMetrics().horizontalAdvance(self.text())
        width = max(0, self.width() - beside)
        option.text = self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, width)
        QStylePainter(self).drawComplexControl(QStyle.ComplexControl.CC_ToolButton, option)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.click()
        else:
            super().keyPressEvent(event)


class Panels(QWidget):
    """Panels of which at most one is open; a folded panel is notified of changes when it opens."""

    opened = Signal()  # a panel was opened, or the last one folded
    chosen = Signal(object)  # the user has opened this `Panel` by its name

    def __init__(self) -> None:
        super().__init__()
        self._shown: ShownData | None = None
        self._last_shown: dict[Panel, ShownData] = {}  # the snapshot that each panel shows
        self._heads: dict[Panel, tuple[QToolButton, str]] = {}  # each panel's button and tooltip
        self._why_closed = ""
        self._empty: set[Panel] = set()  # the panels that have nothing to show
        self._wanted: Panel | None = None  # the panel that was to be opened while all were closed
        self.names = QWidget()  # the row of names, which the owner places where it is visible
        self.names.setObjectName("drawerNames")
        self._row = in_row(on=self.names, margins=(0, 0, 0, 0), gap=2)
        self.rest = QTimer(self, singleShot=True, interval=REST_MS)
        self.idle = QTimer(self, singleShot=True, interval=IDLE_MS)
        self._stack = QStackedWidget()
        in_column(self._stack, on=self, margins=(0, 2, 0, 0))
        self.hide()

    def add(self, name: str, panel: Panel, tip: str) -> None:
        """Add a folded panel under a translated name with a tooltip."""
        button = _DrawerHead(autoRaise=True)
        button.setText(name)
        set_tip(button, tip)
        button.setCheckable(True)
        button.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        button.clicked.connect(partial(self._clicked, panel))
        self._row.addWidget(button)
        self._heads[panel] = button, tip
        area = QScrollArea(widgetResizable=True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        self._stack.addWidget(area)
        area.setWidget(panel)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        panel.installEventFilter(self)

    @property
    def all(self) -> tuple[Panel, ...]:
        """All panels in the order of their names."""
        return tuple(self._heads)

    @property
    def open_panel(self) -> Panel | None:
        return None if self.isHidden() else self.all[self._stack.currentIndex()]

    def keep(self, shown: ShownData) -> None:
        """Keep the snapshot that `notify` passes to the open panel."""
        self._shown = shown
        self.idle.start()

    def notify(self, panel: Panel | None = None) -> None:
        """Notify the open panel, or `panel`, of the changes since its last notification."""
        if panel is None and not self.height():  # a class does not see the open panel
            return
        panel = panel or self.open_panel
        if panel is None or self._shown is None:
            return
        changed = self._shown.changed_since(self._last_shown.get(panel))
        self._last_shown[panel] = self._shown
        if changed & panel.concerns:
            panel.take(self._shown, changed)

    def open(self, panel: Panel | None) -> None:
        """Open one panel, or fold them all."""
        if self._why_closed:
            self._wanted, panel = panel, None
        if panel in self._empty:
            panel = None
        last, held = self.open_panel, self.names.isVisible() and self.window().focusWidget()
        if held and last and last is not panel and last.isAncestorOf(held):
            self._heads[panel or last][0].setFocus()  # Qt would give it to a control of the dock
        if panel is not None:
            self.notify(panel)
            self._stack.setCurrentIndex(self.all.index(panel))
        self.setVisible(panel is not None)
        for each, (button, _) in self._heads.items():
            button.setChecked(panel is each)
        self.opened.emit()

    def offer(self, panel: Panel, on: bool) -> None:
        """Show the name of a panel, or hide it because the panel has nothing to show."""
        (self._empty.discard if on else self._empty.add)(panel)
        self._heads[panel][0].setVisible(on)
        if not on and panel is self.open_panel:
            self.open(None)

    def close_for(self, why: str) -> None:
        """Keep all panels closed for a reason; without one, open the panel that was open before."""
        if why == self._why_closed:
            return
        wanted = self._wanted if self._why_closed else self.open_panel
        self._why_closed = why
        for button, tip in self._heads.values():
            button.setEnabled(not why)
            set_tip(button, why or tip)
        self.open(wanted)

    def wanted_px(self, most_px: int) -> int:
        """Return the height of the open panel's content, at most so much."""
        panel = self.open_panel
        if panel is None:
            return most_px
        seen = [each for each in panel.findChildren(QWidget) if each.isVisibleTo(panel)]
        areas = [each for each in seen if isinstance(each, QAbstractScrollArea)]
        policies = {each.sizePolicy().verticalPolicy() for each in seen if each not in areas}
        if QSizePolicy.Policy.Expanding in policies:  # a diagram uses all the height that it gets
            return most_px
        lacking = [_content_px(each) - each.height() for each in areas]
        wanted = panel.height() + max(lacking) if lacking else panel.sizeHint().height()
        return min(most_px, max(wanted, panel.minimumSizeHint().height()) + 2)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.LayoutRequest and watched is self.open_panel:
            self.rest.start()
        return super().eventFilter(watched, event)

    def _clicked(self, panel: Panel) -> None:
        is_open = panel is self.open_panel
        self.open(None if is_open else panel)
        if not is_open:
            self.chosen.emit(panel)


def _content_px(area: QAbstractScrollArea) -> int:
    """Return the height at which an area needs not scroll up or down."""
    bar = area.horizontalScrollBar()
    beside = 2 * area.frameWidth() + (bar.sizeHint().height() if bar.isVisibleTo(area) else 0)
    if isinstance(area, QTableView):
        return area.horizontalHeader().height() + area.verticalHeader().length() + beside
    inside = area.widget() if isinstance(area, QScrollArea) else None
    if inside is None:  # a list, or the head of a table
        return 0
    high = inside.heightForWidth(area.viewport().width())
    return beside + (high if high >= 0 else inside.sizeHint().height())


class Drawer(QSplitter):
    """The panes above, the open panel below."""

    def __init__(self, around: QSplitter, above: QWidget, panels: Panels) -> None:
        super().__init__(Qt.Orientation.Vertical)
        around.addWidget(self)
        self._panels = panels
        self._share = LARGEST_SHARE
        self._above, self._is_for_class, self._is_alone = above, False, False
        self._handle_px = self.handleWidth()
        self.addWidget(above)
        self.addWidget(panels)
        self.setStretchFactor(0, 1)
        self.setChildrenCollapsible(False)
        panels.opened.connect(self.fit)
        panels.rest.timeout.connect(self._fit_content)
        self.splitterMoved.connect(self._dragged)

    def set_presenting(self, on: bool, *, alone: bool = False) -> None:
        """Give the open panel no height in front of a class, or all of it if it is the slide."""
        self._is_for_class, self._is_alone = on, alone
        self.setHandleWidth(0 if on else self._handle_px)
        is_open = not self._panels.isHidden()  # Qt hides what moves
        place = self._above.layout() if alone else None  # a question may lie over it, and the pen
        if place is not None and self._panels.parent() is self:
            place.addWidget(self._panels)
            self._panels.lower()
        elif not alone and self._panels.parent() is not self:
            self.addWidget(self._panels)
        self._panels.setVisible(is_open)
        self.fit()
        self._panels.notify()

    def fit(self) -> None:
        """Give the open panel the height of its content, at most its share of the window."""
        window_px, height = self.window().height(), sum(self.sizes())
        if self._is_for_class:
            self._panels.setMaximumHeight(_UNLIMITED_PX if self._is_alone else 0)
            self.setSizes([height, 0])
            return
        self._panels.setMaximumHeight(int(LARGEST_SHARE * window_px))
        most = int(self._share * window_px)
        self.setSizes([height - most, most])
        QCoreApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest.value)
        wanted = self._panels.wanted_px(most)
        self.setSizes([height - wanted, wanted])

    def _fit_content(self) -> None:
        """Fit the panel again if its content has grown, or shrunk a lot."""
        now, most = self.sizes()[-1], int(self._share * self.window().height())
        kept = STEADY_LINES * self.fontMetrics().height()
        if not self._is_for_class and not 0 <= now - self._panels.wanted_px(most) < kept:
            self.fit()

    def _dragged(self) -> None:
        self._share = min(LARGEST_SHARE, self.sizes()[1] / self.window().height())
