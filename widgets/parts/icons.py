"""The window's icons: one family, drawn in the text colour at every scale.

The shapes are those of Lucide (lucide.dev, ISC licence), on a grid of 24, as lines two units wide.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from PySide6.QtCore import QByteArray, QEvent, QObject, QRect, QRectF, QSize, Qt
from PySide6.QtGui import (
    QAction,
    QIcon,
    QIconEngine,
    QImage,
    QPainter,
    QPaintEvent,
    QPalette,
    QPixmap,
)
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QAbstractButton, QApplication, QComboBox, QStyle, QStyleOptionComboBox

from widgets.parts.plain import set_tip

_PATHS = {
    "back": "M15 18l-6-6 6-6",
    "check": "M20 6L9 17l-5-5",
    "copy": "M10 8h10a2 2 0 0 1 2 2v10a2 2 0 0 1-2 2H10a2 2 0 0 1-2-2V10a2 2 0 0 1 2-2z"
    "M4 16a2 2 0 0 1-2-2V4a2 2 0 0 1 2-2h10a2 2 0 0 1 2 2",
    "close": "M18 6L6 18M6 6l12 12",
    "choose": "M6 9l6 6 6-6",
    "compare": "M8 3H5a2 2 0 0 0-2 2v14a2 2 0 0 0 2 2h3M16 3h3a2 2 0 0 1 2 2v14a2 2 0 0 1-2 2h-3"
    "M12 20v2M12 14v2M12 8v2M12 2v2",
    "controls": "M21 4h-7M10 4H3M21 12h-9M8 12H3M21 20h-5M12 20H3M14 2v4M8 10v4M16 18v4",
    "enlarge": "M15 3h6v6M21 3l-7 7M3 21l7-7M9 21H3v-6",
    "export": "M21 15v4a2 2 0 0 1-2 2H5a2 2 0 0 1-2-2v-4M17 8l-5-5-5 5M12 3v12",
    "float": "M15 3h6v6M10 14L21 3M18 13v6a2 2 0 0 1-2 2H5a2 2 0 0 1-2-2V8a2 2 0 0 1 2-2h6",
    "help": "M22 12a10 10 0 1 1-20 0 10 10 0 0 1 20 0zM9.1 9a3 3 0 0 1 5.8 1c0 2-3 3-3 3M12 17h.01",
    "home": "M3 10a2 2 0 0 1 .7-1.5l7-6a2 2 0 0 1 2.6 0l7 6A2 2 0 0 1 21 10v9a2 2 0 0 1-2 2H5"
    "a2 2 0 0 1-2-2zM9 21v-8h6v8",
    "lesson": "M12 7v14M3 18a1 1 0 0 1-1-1V4a1 1 0 0 1 1-1h5a4 4 0 0 1 4 4 4 4 0 0 1 4-4h5"
    "a1 1 0 0 1 1 1v13a1 1 0 0 1-1 1h-6a3 3 0 0 0-3 3 3 3 0 0 0-3-3z",
    "open": "M6 14l1.5-2.9A2 2 0 0 1 9.2 10H20a2 2 0 0 1 1.9 2.5l-1.5 6a2 2 0 0 1-1.9 1.5H4"
    "a2 2 0 0 1-2-2V5a2 2 0 0 1 2-2h3.9a2 2 0 0 1 1.7.9l.8 1.2a2 2 0 0 0 1.7.9H18a2 2 0 0 1 2 2v2",
    "pause": "M6 4h4v16H6zM14 4h4v16h-4z",
    "pin": "M12 17v5M9 10.8a2 2 0 0 1-1.1 1.8l-1.8.9A2 2 0 0 0 5 15.2V16a1 1 0 0 0 1 1h12"
    "a1 1 0 0 0 1-1v-.8a2 2 0 0 0-1.1-1.7l-1.8-.9A2 2 0 0 1 15 10.8V7a1 1 0 0 1 1-1 2 2 0 0 0 0-4H8"
    "a2 2 0 0 0 0 4 1 1 0 0 1 1 1z",
    "play": "M6 3l14 9-14 9z",
    "present": "M2 3h20M21 3v11a2 2 0 0 1-2 2H5a2 2 0 0 1-2-2V3M7 21l5-5 5 5",
    "redo": "M15 14l5-5-5-5M20 9H9.5a5.5 5.5 0 0 0 0 11H13",
    "reset": "M3 12a9 9 0 1 0 9-9 9.8 9.8 0 0 0-6.7 2.7L3 8M3 3v5h5",
    "save": "M19 21H5a2 2 0 0 1-2-2V5a2 2 0 0 1 2-2h11l5 5v11a2 2 0 0 1-2 2zM17 21v-8H7v8M7 3v5h8",
    "search": "M19 11a8 8 0 1 1-16 0 8 8 0 0 1 16 0zM21 21l-4.3-4.3",
    "speed": "M12 14l4-4M3.3 19a10 10 0 1 1 17.4 0",
    "undo": "M9 14L4 9l5-5M4 9h10.5a5.5 5.5 0 0 1 0 11H11",
    "unfold": "M9 18l6-6-6-6",
    "up": "M6 15l6-6 6 6",
    "warning": "M21.7 18l-8-14a2 2 0 0 0-3.5 0l-8 14A2 2 0 0 0 4 21h16a2 2 0 0 0 1.7-3M12 9v4"
    "M12 17h.01",
}


def show_icon(shown: QAction | QAbstractButton, name: str) -> None:
    """Give an action or a button the icon of this name, such as ``"undo"``."""
    shown.setIcon(icon(name))
    if isinstance(shown, QAbstractButton):
        shown.setProperty("hasIconOfFamily", True)
        _fit(shown)


def icon(name: str) -> QIcon:
    """Return an icon for something other than an action or a button, such as a list item."""
    return QIcon(_PaintedIcon(name))


def paint_icon(painter: QPainter, rect: QRect, name: str, *, enabled: bool = True) -> None:
    """Draw an icon in the colour that it has on a button."""
    mode = QIcon.Mode.Normal if enabled else QIcon.Mode.Disabled
    _draw(painter, rect, name, *_colour(mode))


def fit(owner: QObject) -> None:
    """Give all icons on buttons inside the size of the letters."""
    for button in owner.findChildren(QAbstractButton):
        if button.property("hasIconOfFamily"):
            _fit(button)


def _fit(button: QAbstractButton) -> None:
    side = button.fontMetrics().height()
    button.setIconSize(QSize(side, side))


class _PaintedIcon(QIconEngine):
    """An icon that is drawn when it becomes visible, in the palette's current colours."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self._name = name

    def clone(self) -> QIconEngine:
        made = _PaintedIcon(self._name)
        _clones.append(made)
        return made

    def pixmap(self, size: QSize, mode: QIcon.Mode, _state: QIcon.State) -> QPixmap:
        if size.isEmpty():  # the button has no room, and no image to paint on
            return QPixmap()
        return QPixmap.fromImage(_image(self._name, size, *_colour(mode)))

    def paint(self, painter: QPainter, rect: QRect, mode: QIcon.Mode, _state: QIcon.State) -> None:
        _draw(painter, rect, self._name, *_colour(mode))


def _colour(mode: QIcon.Mode) -> tuple[str, float]:
    disabled = mode is QIcon.Mode.Disabled
    group = QPalette.ColorGroup.Disabled if disabled else QPalette.ColorGroup.Active
    colour = QApplication.palette().color(group, QPalette.ColorRole.ButtonText)
    return colour.name(), colour.alphaF()


@cache  # not a QPixmap, which must not outlive the application
def _image(name: str, size: QSize, colour: str, opacity: float) -> QImage:
    image = QImage(size, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.transparent)
    painter = QPainter(image)
    _draw(painter, image.rect(), name, colour, opacity)
    painter.end()
    return image


def _draw(painter: QPainter, rect: QRect, name: str, colour: str, opacity: float) -> None:
    svg = (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" fill="none"'
        f' stroke="{colour}" stroke-opacity="{opacity:.2f}" stroke-width="2"'
        f' stroke-linecap="round" stroke-linejoin="round"><path d="{_PATHS[name]}"/></svg>'
    )
    QSvgRenderer(QByteArray(svg.encode())).render(painter, QRectF(rect))


_clones: list[_PaintedIcon] = []
"""Qt owns these, but PySide would delete them if Python did not keep them."""


ARROW = 0.8  # width of the arrow relative to its room, which is as wide as a line is high
BESIDE = 0.3  # room between the text and the arrow, in heights of a line


class Combo(QComboBox):
    """A combo box that paints its own arrow; an option is a text and its value."""

    def __init__(
        self, name: str = "", tip: str = "", options: Iterable[tuple[str, object]] = ()
    ) -> None:
        super().__init__()
        self.setAccessibleName(name)
        set_tip(self, tip)
        for text, value in options:
            self.addItem(text, value)
        self._fit()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._fit()

    def sizeHint(self) -> QSize:
        return super().sizeHint() + self._more

    def minimumSizeHint(self) -> QSize:
        return super().minimumSizeHint() + self._more

    @property
    def _more(self) -> QSize:
        """Room between the text and the arrow, for which the style sheet leaves none."""
        return QSize(round(BESIDE * self.fontMetrics().height()), 0)

    def _fit(self) -> None:
        side = self.fontMetrics().height()
        self.setIconSize(QSize(side, side))

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        option = QStyleOptionComboBox()
        self.initStyleOption(option)
        room = self.style().subControlRect(
            QStyle.ComplexControl.CC_ComboBox, option, QStyle.SubControl.SC_ComboBoxArrow, self
        )
        side = round(ARROW * min(room.width(), room.height()))
        place = QRect(0, 0, side, side)
        place.moveCenter(room.center())
        painter = QPainter(self)
        paint_icon(painter, place, "choose", enabled=self.isEnabled())
        painter.end()
