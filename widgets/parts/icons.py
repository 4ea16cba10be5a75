"""The window's icons: one family, drawn in the text colour at every scale.

The shapes in `content/icons.md` are those of Lucide (lucide.dev, ISC licence).
"""

from collections.abc import Iterable
from functools import cache
from pathlib import Path

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
    QWheelEvent,
)
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QAbstractButton, QApplication, QComboBox, QStyle, QStyleOptionComboBox

from app.model.parameter import read_sections
from widgets.parts.plain import set_tip

_PATHS = read_sections(Path(__file__).with_name("content") / "icons.md")["Paths"].named


def show_icon(shown: QAction | QAbstractButton, name: str) -> None:
    """Give an action or a button the icon of this name, such as ``"undo"``."""
    shown.setIcon(icon(name))
    if isinstance(shown, QAbstractButton):
        shown.setProperty("hasIconOfFamily", True)
        _fit(shown)


def icon(name: str, role: QPalette.ColorRole = QPalette.ColorRole.ButtonText) -> QIcon:
    """Return an icon for something other than an action or a button, such as a list item."""
    return QIcon(_PaintedIcon(name, role))


def paint_icon(painter: QPainter, rect: QRect, name: str, *, enabled: bool = True) -> None:
    """Draw an icon in the colour that it has on a button."""
    mode = QIcon.Mode.Normal if enabled else QIcon.Mode.Disabled
    _draw(painter, rect, name, *_colour(mode))


def fit(owner: QObject) -> None:
    """Give all icons on buttons inside the size of the letters."""
    for button in owner.findChildren(QAbstractButton):
        if button.property("hasIconOfFamily"):
            _fit(button)


def _fit(widget: "QAbstractButton | Combo") -> None:
    side = widget.fontMetrics().height()
    widget.setIconSize(QSize(side, side))


class _PaintedIcon(QIconEngine):
    """An icon that is drawn when it becomes visible, in the palette's current colours."""

    def __init__(self, name: str, role: QPalette.ColorRole) -> None:
        super().__init__()
        self._name, self._role = name, role

    def clone(self) -> QIconEngine:
        made = _PaintedIcon(self._name, self._role)
        _clones.append(made)
        return made

    def pixmap(self, size: QSize, mode: QIcon.Mode, _state: QIcon.State) -> QPixmap:
        if size.isEmpty():  # the button has no room, and no image to paint on
            return QPixmap()
        return QPixmap.fromImage(_image(self._name, size, *_colour(mode, self._role)))

    def paint(self, painter: QPainter, rect: QRect, mode: QIcon.Mode, _state: QIcon.State) -> None:
        _draw(painter, rect, self._name, *_colour(mode, self._role))


def _colour(
    mode: QIcon.Mode, role: QPalette.ColorRole = QPalette.ColorRole.ButtonText
) -> tuple[str, float]:
    disabled = mode is QIcon.Mode.Disabled
    group = QPalette.ColorGroup.Disabled if disabled else QPalette.ColorGroup.Active
    colour = QApplication.palette().color(group, role)
    return colour.name(), colour.alphaF()


@cache  # not a QPixmap, which must not outlive the application
def _image(name: str, size: QSize, colour: str, opacity: float) -> QImage:
    image = QImage(size, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.transparent)
    with QPainter(image) as painter:
        _draw(painter, image.rect(), name, colour, opacity)
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
    """A combo box that paints its own arrow; an option is a text and its value.

    It ignores the wheel, so that what is around it scrolls, until it has the focus.
    """

    def __init__(
        self, name: str = "", tip: str = "", options: Iterable[tuple[str, object]] = ()
    ) -> None:
        super().__init__()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccessibleName(name)
        set_tip(self, tip)
        for text, value in options:
            self.addItem(text, value)
        _fit(self)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            _fit(self)

    def wheelEvent(self, event: QWheelEvent) -> None:
        super().wheelEvent(event) if self.hasFocus() else event.ignore()

    def sizeHint(self) -> QSize:
        return super().sizeHint() + self._more

    def minimumSizeHint(self) -> QSize:
        return super().minimumSizeHint() + self._more

    @property
    def _more(self) -> QSize:
        """Room between the text and the arrow, for which the style sheet leaves none."""
        return QSize(round(BESIDE * self.fontMetrics().height()), 0)

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
        with QPainter(self) as painter:
            paint_icon(painter, place, "choose", enabled=self.isEnabled())
