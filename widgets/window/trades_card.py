"""Speed and accuracy: every trade of a renderer as a picture, with what it saves and costs."""

import logging
import traceback
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QSize, Qt, QTimer, Signal
from PySide6.QtGui import QCloseEvent, QPixmap
from PySide6.QtWidgets import QGridLayout, QToolButton, QWidget

from app.document.document import Document
from app.document.view import View
from app.drawings.figure import Figure
from app.measure import chart
from app.measure.meaning import ANY_SCENE, GIVEN_UP, bargain, boldest, shown_by
from app.measure.results import SWEPT, Measurements, of_measure
from app.measure.single import shipped
from app.scenes.scene import load
from widgets.parts.labels import NoteLabel
from widgets.parts.layouts import FREE, in_column, tool_button
from widgets.parts.plain import PlainLabel
from widgets.parts.wording import Wording
from widgets.window.cover_card import CoverCard
from widgets.window.pictures import image_of
from widgets.window.quality import with_choice

log = logging.getLogger(__name__)

WORDS = Wording(__file__)
DRAWN_FINER = 2.0  # factor by which a picture is drawn larger: its lines do not hide the scene
BARE = View(layers=frozenset({"labels"}))  # the view of a picture, without labels
COLUMNS = 5
ROUND_PX = 8  # the room around the content of a tile
BESIDE_PX = 80  # the part of the window's width that no tile takes
WIDEST_PX = 330
PIXELS_SHOWN = 1 / 3  # factor by which a picture is drawn smaller, so that its pixels are seen


class TradesCard(CoverCard):
    """The trades over the whole window, with the results that the program brings."""

    trade_chosen = Signal(str)
    start_wanted = Signal()

    def __init__(self, window: QWidget, *, dark: bool) -> None:
        super().__init__(window, WORDS.say("name"))
        self._dark = dark
        self._undrawn: list[str] = []
        self._drawing = QTimer(self)
        self._drawing.timeout.connect(self._draw_next)
        results = shipped()
        wide = min((window.width() - BESIDE_PX) // COLUMNS, WIDEST_PX)
        across = wide - 2 * ROUND_PX
        self._picture_px = (across, across * 9 // 16)
        self._pictures: dict[str, PlainLabel] = {}
        for name in chart.TITLES:
            if name not in SWEPT:
                self.tiles[name] = self._tile(name, results.get(name))
        grid = QGridLayout()
        grid.setSpacing(0)
        layouts = [tile.layout() for tile in self.tiles.values()]
        high = max(layout.heightForWidth(wide) for layout in layouts if layout is not None)
        for place, tile in enumerate(self.tiles.values()):
            tile.setFixedSize(wide, high)
            grid.addWidget(tile, place // COLUMNS, place % COLUMNS)
        name, tip = WORDS["back"]
        act = partial(self._leave_for, self.start_wanted)
        back = tool_button("", tip, act, icon="back", name=name, flat=True)
        title, tip = WORDS["head"]
        head = self._head(title, tip, back)
        note = NoteLabel()
        note.setText(WORDS.say("measured", chart.machine(next(iter(results.values())))))
        in_column(head, grid, note, on=self.card, margins=(12, 10, 12, 10), gap=6)

    def _tile(self, name: str, results: Measurements | None) -> QToolButton:
        title = of_measure(chart.TITLES[name])
        paid = WORDS.say("unmeasured")
        bold = boldest(results.trades[0]) if results is not None else None
        if results is not None and bold is not None:
            cost, choice = bold
            paid = bargain(results.trades[0].by_cost(cost), choice)
        tile = tool_button(
            act=partial(self._leave_for, self.trade_chosen, name), name=title, flat=True
        )
        given_up = of_measure(GIVEN_UP[name])
        tile.setAccessibleDescription(f"{given_up} {paid}")
        picture = self._pictures[name] = PlainLabel()
        picture.setFixedSize(*self._picture_px)
        words = (
            PlainLabel(title, objectName="paneTitle", wordWrap=True),
            PlainLabel(given_up, objectName="paneNote", wordWrap=True),
            PlainLabel(paid, wordWrap=True),
        )
        for label in (picture, *words):
            label.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        in_column(picture, *words, FREE, on=tile, margins=(ROUND_PX,) * 4, gap=2)
        return tile

    def open(self) -> None:
        """Cover the window, and draw the pictures one by one."""
        super().open()
        self._undrawn = list(self.tiles)
        self._drawing.start(0)

    def closeEvent(self, event: QCloseEvent) -> None:
        self._drawing.stop()
        super().closeEvent(event)

    def _draw_next(self) -> None:
        if not self._undrawn:
            self._drawing.stop()
            return
        name = self._undrawn.pop(0)
        try:
            self._pictures[name].setPixmap(self._picture(name))
        except Exception:  # what it stands for can still be chosen by its name
            log.warning("the picture of %s cannot be drawn\n%s", name, traceback.format_exc())

    def _picture(self, name: str) -> QPixmap:
        """Draw the picture of a tile; where smoothing is traded, its pixels are seen."""
        shown = shown_by(name)
        scene = load(shown.get("scene", ANY_SCENE))
        document = with_choice(Document(scene.name, scene.start), shown)
        is_smooth, ratio = "smoothing" not in shown, self.devicePixelRatioF()
        finer = DRAWN_FINER if is_smooth else PIXELS_SHOWN
        width, height = (round(side * finer) for side in self._picture_px)
        figure = Figure(
            replace(document, view=BARE), scene, (scene.leading if is_smooth else "image",),
            (width, height), scale=ratio if is_smooth else 1.0,
            palette="dark" if self._dark else "screen",
        )  # fmt: skip
        scaling, whole = Qt.TransformationMode, Qt.AspectRatioMode.KeepAspectRatio
        how = scaling.SmoothTransformation if is_smooth else scaling.FastTransformation
        drawn = image_of(figure.pixels()).scaled(QSize(*self._picture_px) * ratio, whole, how)
        drawn.setDevicePixelRatio(ratio)
        return QPixmap.fromImage(drawn)
