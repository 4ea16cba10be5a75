"""The column beside the pictures: the lesson's card above the controls."""

from typing import cast

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QFontInfo
from PySide6.QtWidgets import QApplication, QSplitter, QWidget

from widgets.controls.controls import Controls
from widgets.window.lesson_card import LessonCard

WIDTH_EM = 31.0  # width of the column while a lesson is open
SHARE = 0.63  # the card's share of the column's height


class Side(QSplitter):
    """The card above the controls, in a splitter.

    The card takes the controls' height when a response does not fit in its own. The controls get
    it back when the mouse or the focus comes to them, or another step or other numbers are shown.
    """

    def __init__(self, around: QSplitter) -> None:
        super().__init__(Qt.Orientation.Vertical)
        around.addWidget(self)
        self._around = around
        self.controls = Controls(self)
        self.controls.setMinimumHeight(2 * self.fontMetrics().height())  # its search remains
        cast(QApplication, QApplication.instance()).focusChanged.connect(self._follow)
        self._card: LessonCard | None = None
        self._before: list[int] = []  # widths of pictures and column without a lesson
        self._own: list[int] = []
        """Heights of card and controls while the card has some of the controls' height."""
        self.splitterMoved.connect(lambda *_: self._own.clear())
        self.setChildrenCollapsible(False)

    def take_card(self, card: LessonCard) -> None:
        self._card = card
        card.page.room_wanted.connect(self._lend)
        self.insertWidget(0, card)

    def _lend(self, height: int) -> None:
        """Give the card some of the controls' height; 0 gives all of it back."""
        if height and self.controls.isVisible() and not self._is_used(QApplication.focusWidget()):
            card, controls = self.sizes()
            self._own = self._own or [card, controls]
            self.controls.installEventFilter(self)
            self.setSizes([card + height, max(0, controls - height)])
        elif self._own:
            self.setSizes(self._own)
            self._own = []
            self.controls.removeEventFilter(self)

    def _follow(self, _left: QWidget | None, focus: QWidget | None) -> None:
        if self._own and self._is_used(focus):
            self._lend(0)

    def _is_used(self, focus: QWidget | None) -> bool:
        return focus is not None and self.controls.isAncestorOf(focus)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if self._own and event.type() == QEvent.Type.Enter:
            self._lend(0)
        return super().eventFilter(watched, event)

    def show_parts(self, *, card: bool, controls: bool) -> None:
        assert self._card is not None
        self._card.setVisible(card)
        self.controls.setVisible(controls)
        self.setVisible(card or controls)

    def make_room(self, on: bool) -> None:
        """Make the column wider while a lesson is open."""
        around = self._around
        if on:
            self._before = around.sizes()
            em = QFontInfo(self.font()).pixelSize()
            wide = max(self._before[-1], round(WIDTH_EM * em))
            around.setSizes([sum(self._before) - wide, wide])
            self.setSizes([round(SHARE * 1000), round((1.0 - SHARE) * 1000)])
        elif self._before and self._before[-1]:
            around.setSizes(self._before)
