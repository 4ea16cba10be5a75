"""A combo box whose arrow grows with the letters."""

from collections.abc import Iterable

from PySide6.QtCore import QEvent, QRect, QSize
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QComboBox, QStyle, QStyleOptionComboBox

from widgets.parts.icons import paint_icon
from widgets.parts.plain import set_tip

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
