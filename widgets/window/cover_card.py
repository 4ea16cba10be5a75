"""What cards over the whole window share: how they close, their keys, and their pictures."""

from __future__ import annotations

import logging
import traceback
from abc import abstractmethod
from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QEvent, QObject, QSize, Qt, QTimer, Signal, SignalInstance
from PySide6.QtGui import QCloseEvent, QIcon, QKeyEvent, QMouseEvent, QPixmap
from PySide6.QtWidgets import QFrame, QGridLayout, QHBoxLayout, QToolButton, QWidget

from app.document.document import Document
from app.document.view import View
from app.drawings.figure import Figure
from app.scenes.scene import Scene
from widgets.parts.buttons import tool_button
from widgets.parts.layouts import in_row
from widgets.parts.plain import PlainLabel
from widgets.window.pictures import image_of

log = logging.getLogger(__name__)

DRAWN_FINER = 2.0
"""Factor by which a picture is drawn larger, so that its lines do not hide the scene."""
BARE = View(layers=frozenset({"labels"}))  # the view of a picture, without labels


class CoverCard(QWidget):
    """A card over the window until the user chooses something, presses Esc or clicks beside it.

    `card` is the visible part.
    """

    left = Signal()  # the card has closed; emitted before the signal of what was chosen

    def __init__(self, window: QWidget, name: str, *, dark: bool) -> None:
        super().__init__(window)
        self.setObjectName("cover")
        self.setAccessibleName(name)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._window, self._dark = window, dark
        self.card = QFrame()
        self.card.setObjectName("card")
        self.card.setAutoFillBackground(True)
        self.card.setFrameShape(QFrame.Shape.StyledPanel)
        around = QGridLayout(self)
        around.setContentsMargins(8, 8, 8, 8)
        around.addWidget(self.card, 0, 0, Qt.AlignmentFlag.AlignCenter)
        self.tiles: dict[str, QToolButton] = {}  # the buttons with a picture, by name
        self._undrawn: list[str] = []
        self._drawing = QTimer(self)
        self._drawing.timeout.connect(self._draw_next)
        window.installEventFilter(self)
        self._cover()

    def open(self) -> None:
        """Cover the window, and draw the pictures one by one."""
        self.show()
        self.raise_()
        next(iter(self.tiles.values())).setFocus()
        self._undrawn = list(self.tiles)
        self._drawing.start(0)

    def _head(self, text: str, tip: str, *before: QWidget) -> QHBoxLayout:
        title = PlainLabel(text, objectName="cardTitle")
        leave = tool_button("", tip, self.close, icon="close", name=self.tr("Close"), flat=True)
        return in_row(*before, (title, 1), leave)

    def _choose(self, tell: Callable[[str], object], what: str) -> None:
        self.close()
        tell(what)

    def _leave_for(self, wanted: SignalInstance) -> None:
        self.close()
        wanted.emit()

    # -- the pictures

    @abstractmethod
    def _picture(self, name: str) -> QPixmap:
        """Draw the picture of a tile."""

    def _show_picture(self, name: str, pixmap: QPixmap) -> None:
        self.tiles[name].setIcon(QIcon(pixmap))

    def _draw_next(self) -> None:
        if not self._undrawn:
            self._drawing.stop()
            return
        name = self._undrawn.pop(0)
        try:
            self._show_picture(name, self._picture(name))
        except Exception:  # what it stands for can still be chosen by its name
            log.warning("the picture of %s cannot be drawn\n%s", name, traceback.format_exc())

    def _drawn(
        self,
        document: Document,
        scene: Scene,
        size: tuple[int, int],
        finer: float = DRAWN_FINER,
        pane: str = "",
    ) -> QPixmap:
        """Draw a document in a pane, by default the leading one; below 1, `finer` shows pixels."""
        ratio = self.devicePixelRatioF()
        width, height = (round(side * finer) for side in size)
        figure = Figure(
            replace(document, view=BARE), scene, (pane or scene.leading,), (width, height),
            scale=ratio if finer > 1.0 else 1.0, palette="dark" if self._dark else "screen",
        )  # fmt: skip
        scaling = Qt.TransformationMode
        how = scaling.SmoothTransformation if finer > 1.0 else scaling.FastTransformation
        whole = Qt.AspectRatioMode.KeepAspectRatio
        drawn = image_of(figure.pixels()).scaled(QSize(*size) * ratio, whole, how)
        pixmap = QPixmap.fromImage(drawn)
        pixmap.setDevicePixelRatio(ratio)
        return pixmap

    # -- over the window

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Press the button that has the focus also by Enter, which Qt leaves to dialogs."""
        focused = self.focusWidget()
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and isinstance(
            focused, QToolButton
        ):
            focused.showMenu() if focused.menu() else focused.click()
        else:
            super().keyPressEvent(event)

    def closeEvent(self, event: QCloseEvent) -> None:
        super().closeEvent(event)
        self._drawing.stop()
        self.left.emit()
        self.deleteLater()

    def _cover(self) -> None:
        self.setGeometry(self._window.rect())

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self._cover()
        return super().eventFilter(watched, event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        event.accept()  # a click beside the card; its own widgets take clicks on it
        self.close()
