"""The main window: creates the components, and connects them to each other and to the store.

::

    controls, animation --edited--> Store --changed(document)--> ShownData, and what changed in it
    menus, tool bar ----------------^                            |
                      panes, controls, the open panel, status line: take(shown, changed)
"""

import logging
import os
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

from PySide6 import QtGui
from PySide6.QtCore import QByteArray, QEvent, QSize, Qt, QTimer, Signal
from PySide6.QtWidgets import QMainWindow, QSplitter, QWidget

from app.document.document import Document
from app.document.store import Origin, Store
from app.drawings.style import Style
from app.lessons.practice import Sheet
from app.lessons.record import Record
from app.model.refusal import Refusal
from app.scenes.scene import Scene
from widgets.panels.frame_panel import FramePanel
from widgets.panels.kinds_panel import KindsPanel
from widgets.panels.matrix_panel import MatrixPanel
from widgets.panels.measure_panel import MeasurePanel
from widgets.panels.probe_panel import ProbePanel
from widgets.panels.scene_panel import ScenePanel
from widgets.panes.canvas import CANVASES, SMOOTHINGS
from widgets.panes.counting import Counting
from widgets.panes.cursor import Cursor
from widgets.panes.drawings import DRAWINGS
from widgets.panes.manipulation import Manipulation
from widgets.panes.pane import Pane
from widgets.panes.stage_strip import StageStrip
from widgets.parts import palette
from widgets.parts.kept_style import KeptStyle
from widgets.parts.layouts import focus_next, in_column, in_row
from widgets.parts.messages import MessageBar, sentence
from widgets.parts.panel import EVERYTHING, Changed, Highlighter, Listener, Panel, ShownData
from widgets.parts.wording import Wording
from widgets.window.actions import Actions, take_typed
from widgets.window.arrangement import Arrangement, WorldLook
from widgets.window.comparing import Comparing
from widgets.window.control_strip import ControlStrip
from widgets.window.cover_card import CoverCard
from widgets.window.drawer import Drawer, Panels
from widgets.window.files import Files
from widgets.window.history import History
from widgets.window.laser import Laser
from widgets.window.lesson_card import LessonCard
from widgets.window.lessons import Lessons
from widgets.window.look import Look, dress
from widgets.window.pane_words import PaneWords
from widgets.window.pictures import Pictures
from widgets.window.pointing import Pointing
from widgets.window.practice import Practice, next_review, review_text
from widgets.window.present import Present, Screens
from widgets.window.probing import Probing
from widgets.window.quality import Cost, DrawnQuality
from widgets.window.recovery import Recovery
from widgets.window.scene_guide import SceneGuide
from widgets.window.settings import data_folder
from widgets.window.side import Side
from widgets.window.slide import Slide
from widgets.window.slots import Slots
from widgets.window.start_card import StartCard
from widgets.window.status_line import StatusLine
from widgets.window.talk_band import TalkBand
from widgets.window.talks import Talks
from widgets.window.transition import Transition
from widgets.window.wiring import wire

log = logging.getLogger(__name__)
WORDS = Wording(__file__)
AT_FIRST_PX = (1366, 768)
BODY_MARGINS, NO_MARGINS, BODY_GAP_PX = (4, 4, 4, 0), (0, 0, 0, 0), 2
RECORD = "record.jsonl"  # the file of the student's answers, in the data folder
FOLDS_BELOW_PX = 1200  # a narrower window has no room for the dock beside its panes; a key opens it
PICTURES_AND_DOCK = [1075, 285]
LONGEST_UNSEEN_MS = 100
"""Longest wait for a pane that shows nothing: it may be hidden, or its drawing has failed."""


class Work(NamedTuple):
    """What a window works on: a document with its file, or a lesson's step, and what led there."""

    document: Document
    saved: Document | None
    path: Path | None
    lesson: Path | None = None
    step: str = ""
    sheet: Sheet | None = None  # a test or a review instead of a lesson's file
    store: Store | None = None
    covered: Mapping[Origin, Path] = MappingProxyType({})  # copies of unsaved work


class MainWindow(QMainWindow):
    """One document in three linked panes.

    `saved` is the content of the document's file, if it differs; `path` is the file that was
    opened. Without a GPU (`software_rendering`) antialiasing waits while a control is dragged. A
    `Refusal` if the document's scene cannot be loaded.
    """

    first_painted = Signal()  # the window is on the screen, with empty panes
    filled = Signal()  # all panes have drawn their pictures, or failed to

    def __init__(
        self,
        document: Document,
        *,
        settings: Any,
        software_rendering: bool,
        saved: Document | None = None,
        path: Path | None = None,
        scene: Scene | None = None,
        canvas: str = "raster",
    ) -> None:
        super().__init__()
        self.setObjectName("mainWindow")
        self.setAcceptDrops(True)
        self._is_closed = self._was_painted = self._is_narrow = False
        self.cover: CoverCard | None = None  # the card over the window
        self._folded: Panel | None = None
        """The panel to reopen when no pane fills the window and nothing is presented."""
        self.work_left: Work | None = None  # for another window, in another language
        self._before_presenting: tuple[bool, str, list[int]] = True, "", []
        """Whether the dock was shown, the whole pane, and the splitter's sizes."""
        self.settings = settings
        settings.cannot_save = self._show_unsaved
        dress(settings)  # before the first widget is made, which would keep its font
        self.store = Store(document, self, saved=saved)
        self.messages = MessageBar()
        titles = {name: WORDS.say(name) for name in ("world", "ndc", "image")}
        make_canvas = CANVASES[canvas]
        self.panes = {
            name: Pane(title, DRAWINGS[name], orbits=name != "image", make_canvas=make_canvas)
            for name, title in titles.items()
        }
        self.look = Look(
            self.panes, settings, self.store, software_rendering=software_rendering, window=self
        )
        self.files = Files(self, self.store, self.messages, settings)
        if scene is not None:
            self.files.keep(document, scene)
        self.shown = self._snapshot(document)
        self.manipulation = Manipulation(self.panes, self)
        self.strip = StageStrip()
        self.panes["ndc"].add_below(self.strip)
        self.counting = Counting(lambda: self.store.in_gesture, self)
        self.panels, self.status = Panels(), StatusLine()
        self._lay_out()
        self._make_panels()
        self.probing = Probing(
            self.panes, self.probe_panel, self.manipulation, lambda: self.shown, self
        )
        self.cursors = {
            name: Cursor(name, pane, self.manipulation) for name, pane in self.panes.items()
        }
        self.pictures = Pictures(
            self, self.messages, lambda: self.store.seen, self.files.scene, titles,
            self.look.words, settings,
        )  # fmt: skip
        self.menus = Actions(
            self, files=self.files, pictures=self.pictures, slots=self.slots, panes=self.panes,
            theme=settings.theme, language=settings.language, all_digits=settings.all_digits,
        )  # fmt: skip
        self.present = Present(self, self.menus.tools, self.bottom, Screens(settings))
        self.look.kept = KeptStyle((self.side, self.bottom, self.panels, *self.panes.values()))
        self.laser = Laser(self)
        self._make_components()
        self.highlighter = Highlighter(self)
        wire(self)
        self.show_beside()
        self._notify(EVERYTHING)
        self.history.show()
        if path is not None:
            self.files.note_opened(path)
        if not self.restoreGeometry(QByteArray(settings.geometry or b"")):  # it may be damaged
            self.resize(QSize(*AT_FIRST_PX).boundedTo(self.screen().availableSize()))
        if settings.problem is not None:
            self.messages.show_message(f"{sentence(settings.problem)} {WORDS.say('defaults')}")
        self.panes["world"].canvas.setFocus()  # or Qt would give it to the button of an offer
        QTimer.singleShot(0, self, self.recovery.offer)

    def open_panes(self) -> None:
        """Fill the panes, the largest first; each appears before the next one is drawn."""
        self._empty = sorted(self.panes.values(), key=lambda pane: pane.width())
        self._filling = QTimer(self, singleShot=True)
        self._filling.timeout.connect(self._open_next)
        self._open_next()

    def _open_next(self) -> None:
        if not self._empty:
            self._filling.timeout.disconnect()  # a late pane would emit `filled` again
            self.filled.emit()
        elif not self._is_closed:
            pane = self._empty.pop()
            self._filling.start(LONGEST_UNSEEN_MS)
            pane.canvas.shown.connect(
                partial(self._filling.start, 0), Qt.ConnectionType.SingleShotConnection
            )
            pane.open()

    # -- making

    def _make_panels(self) -> None:
        self.matrices = MatrixPanel()
        self.frame_panel = FramePanel()
        self.kinds_panel = KindsPanel()
        self.probe_panel = ProbePanel()
        self.scene_panel = ScenePanel()
        self.measure_panel = MeasurePanel(
            lambda: self.store.document,
            lambda: self.quality.in_use(),
            SMOOTHINGS,
            self.status.precision,
        )
        panels: dict[str, Panel] = {
            "matrices": self.matrices, "frame": self.frame_panel, "kinds": self.kinds_panel,
            "probe": self.probe_panel, "scene": self.scene_panel, "measure": self.measure_panel,
        }  # fmt: skip
        for key, panel in panels.items():
            name, tip = WORDS[key]
            self.panels.add(name, panel, tip)

    def _lay_out(self) -> None:
        # From the outside inwards: Qt styles a widget's children again whenever it gets a parent.
        self.body = body = QWidget()
        self.setCentralWidget(body)
        self.band, self.bottom = TalkBand(), QWidget()
        self.split = split = QSplitter(Qt.Orientation.Horizontal)
        outer = self.messages, self.band, (split, 1)
        self._body = in_column(*outer, on=body, margins=BODY_MARGINS, gap=BODY_GAP_PX)
        self.slots = Slots(self.panes, self.strip)
        self.slide = Slide(self.slots)
        self.drawer = Drawer(split, self.slide, self.panels)
        self.slots.fill()
        self.side = Side(split)
        self.controls = self.side.controls
        self.control_strip = ControlStrip(self.controls, self.strip)
        self._body.addWidget(self.control_strip)
        self._body.addWidget(self.bottom)
        split.setStretchFactor(0, 1)
        split.setSizes(PICTURES_AND_DOCK)
        in_row(self.panels.names, (self.status, 1), on=self.bottom, margins=(0, 0, 0, 2))

    def _make_components(self) -> None:
        """Create the components that connect others, and define the notification order."""
        image, controls = self.panes["image"], self.controls
        self.guide = SceneGuide(
            self.scene_panel, self.panels, controls, self.manipulation, image, self.menus,
            self.store, self.files.choose_scene,
        )  # fmt: skip
        self.comparing = Comparing(
            self.panes, self.look, self.store, self.slots, controls.card, self.menus, self.messages
        )
        self.arrangement = Arrangement(
            self.panes, self.slots, WorldLook(self.panes, self.menus), self.strip, self.panels,
            self.matrices, self.frame_panel, self.probe_panel, self.comparing.pictures,
            self.control_strip,
        )  # fmt: skip
        self.store.look = lambda: self.arrangement.view
        self.cost = Cost(self.panes, self.status)
        self.quality = DrawnQuality(
            self.look, image, self.status, self.settings, self.store, lambda: self.shown,
            self.files.begun, self.messages.show_message,
        )  # fmt: skip
        dragged = [cursor.let_go for cursor in self.cursors.values()]
        players = controls.animation.pause, controls.card.pause, *dragged
        self.history = History(
            self, self.store, self.menus, lambda: self.shown.scene.start, players
        )
        self.transition = Transition(
            self.look, self.slide, self.settings, lambda: self.present.is_on
        )
        for pane in self.panes.values():
            pane.fades = partial(getattr, self.transition, "is_wanted")
        self.lessons = Lessons(
            self.store, self.files, self.messages, self.history.stand_still, self.strip.go_to,
            self.look.look_from, self.transition,
        )  # fmt: skip
        self.record = Record(data_folder() / RECORD)
        self.lesson_card = LessonCard(self.lessons, self.store, self.settings, self.record)
        self.side.take_card(self.lesson_card)
        self.practice = Practice(self, self.lesson_card, self.record, self.settings, self.messages)
        self.pane_words = PaneWords(self.panes, self.store, lambda: self.shown.scene, self)
        self.pointing = Pointing(self.panes, self)
        self.files.lesson_wanted.connect(self.lesson_card.open)
        self.talks = Talks(
            self, self.lessons, self.present, self.store, self.messages, self.settings, self.band,
            self.slide.question, self.slide.pen, self.look,
        )  # fmt: skip
        self.recovery = Recovery(data_folder(), self.store, self.messages, self.files, self)
        self._listeners: tuple[Listener, ...] = (
            *self.cursors.values(),
            self.manipulation,  # releases a held handle before its drawing is deleted
            self.probing,
            self.guide,  # tells the controls about the scene
            self.controls,
            self.slots,
            self.control_strip,
            self.slide.equation,
            self.band,
            self.arrangement,  # overrides what a new scene has opened or forgotten
            self.cost,
            self.look,
            self.comparing,  # after the image pane
            self.counting,
            self.strip,
            self.files,
            self.status,
            self.quality,  # after the panes
        )

    def offer_answers(self, title: str, take_back: Callable[[], object]) -> None:
        text, undo = WORDS.say("deleted", title), WORDS.say("undo")
        self.messages.show_message(text, (undo, take_back), warns=False)

    def _show_unsaved(self, why: Refusal) -> None:
        self.messages.show_message(WORDS.say("unsaved", sentence(why)))

    def find_control(self) -> None:
        if self.controls.isHidden():
            self.menus.controls.trigger()
        self.controls.find_control()

    def choose_language(self, language: str) -> None:
        """Close, for a window in another language that goes on with the same work."""
        if language == self.settings.language:
            return
        take_typed(self)
        self.present.leave()
        self.history.stand_still()
        self.settings.language = language
        origin, player = self.store.origin, self.lessons.player
        at = (player.course.file, player.step.name, player.sheet) if player else (None, "", None)
        given = self.store.seen, origin.saved, origin.path, *at, self.store, self.recovery.covered
        self.work_left = Work(*given)
        self.close()

    def go_on(self, work: Work) -> None:
        """Go on with what another window has left, or open a lesson."""
        if work.store is not None:
            self.store.take_steps(work.store)
            self.recovery.take_over(work.covered)
        is_open = work.lesson is not None and self.lesson_card.open(work.lesson, work.step)
        if work.sheet is not None:  # the exercises are drawn again, in the other language
            (self.practice.go_on if work.sheet.is_test else self.practice.review)()
        elif is_open and work.store is not None:
            self.lessons.show_left(work.document)

    # -- showing the document

    def _snapshot(self, document: Document) -> ShownData:
        return ShownData.of(document, self.files.scene(document.scene, document.mesh))

    def show_document(self, document: Document) -> None:
        before = self.shown
        try:
            self.shown = self._snapshot(document)
            self._notify(self.shown.changed_since(before))
        except Exception as error:
            if self.files.scene(document.scene, document.mesh) is before.scene:
                raise
            # If a mesh cannot be drawn, the previous scene stays everywhere in the window.
            log.exception("the scene %r cannot be drawn", document.mesh or document.scene)
            self.files.keep(before.document, before.scene)
            self.store.refuse()
            name = os.path.basename(document.mesh or document.scene)
            self.messages.show_message(WORDS.say("not-drawn", name, repr(error)))

    def show_view(self, document: Document) -> None:
        self.shown = replace(self.shown, document=document)
        self.slide.equation.take(self.shown, frozenset())
        self.band.take(self.shown, frozenset())
        self.arrangement.show(document.view)
        self.comparing.pictures.refresh()

    def _notify(self, changed: Changed) -> None:
        self.panels.keep(self.shown)
        waits = bool(changed & {"scene", "view"})
        if waits:  # the panes take over another document all at once, after they are arranged
            self.look.set_waiting(True)
        try:
            for listener in self._listeners:
                if changed & listener.concerns:
                    listener.take(self.shown, changed)
        finally:
            if waits:
                self.look.set_waiting(False)
        self.panels.notify()
        self.recovery.autosave.schedule()

    # -- events

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QtGui.QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            if event.type() == QEvent.Type.ShortcutOverride and self._on_top():
                event.accept()  # otherwise Esc is the probes' shortcut
                return True
            if event.type() == QEvent.Type.KeyPress and (leave := self._on_top()):
                leave()
                return True
        if event.type() == QEvent.Type.DevicePixelRatioChange and self.panes["world"].drawing:
            self.look.rebuild()
        return super().event(event)

    def keyPressEvent(self, event: QtGui.QKeyEvent) -> None:
        """Turn the lesson's page by keys for which what has the focus has no use."""
        menu, keys = self.menus.lesson_menu, Qt.Key
        turn = {keys.Key_PageDown: menu.next, keys.Key_PageUp: menu.back}.get(Qt.Key(event.key()))
        if turn is not None and not event.modifiers():
            turn.trigger()
        else:
            super().keyPressEvent(event)

    def statusBar(self) -> StatusLine:
        """Return our own status line; Qt's method would create a second one below it."""
        return self.status

    def show_message(self, text: str) -> None:
        self.status.showMessage(text, 5000)

    def show_start_card(self) -> None:
        settings, waiting = self.settings, self.practice.waiting
        card = StartCard(
            self, self.menus.scene_titles, self.files.recent, settings.progress,
            review=review_text(waiting) if waiting.due else "", next_review=next_review(waiting),
            at_every_start=settings.start_card, dark=palette.is_dark(settings.theme),
        )  # fmt: skip
        card.scene_chosen.connect(self.guide.choose)
        card.file_chosen.connect(self.files.open)
        card.open_wanted.connect(self.files.open_dialog)
        card.review_wanted.connect(self.practice.review)
        card.always_set.connect(partial(setattr, settings, "start_card"))
        card.trades_wanted.connect(self.show_trades)
        self._cover_with(card)

    def show_trades(self) -> None:
        from widgets.window.trades_card import TradesCard  # no start waits for it

        card = TradesCard(self, dark=palette.is_dark(self.settings.theme))
        card.trade_chosen.connect(self.measure_panel.show_trade)
        card.start_wanted.connect(self.show_start_card)
        self._cover_with(card)

    def _cover_with(self, card: CoverCard) -> None:
        if self.cover is not None:
            self.cover.close()
        self.cover = card
        card.left.connect(partial(setattr, self, "cover", None))
        card.open()

    def _on_top(self) -> Callable[[], object] | None:
        """Return the action of Esc: leave a card, Present, a message, a comparison, ..."""
        if self.cover is not None:
            return self.cover.close
        if self.present.is_on:
            return self.present.leave
        if self.messages.text and not self.messages.choices:  # otherwise an offer would be lost
            return self.messages.done
        if self.comparing.pictures.is_on:
            return self.comparing.end
        return partial(self.slots.make_large, self.slots.whole) if self.slots.whole else None

    def show_presenting(self, on: bool) -> None:
        if on:
            dock = self.menus.controls.isChecked()
            self._before_presenting = dock, self.slots.whole, self.split.sizes()
            self.menus.controls.setChecked(False)
            self.show_beside()  # what is hidden keeps its style
        self.look.set_waiting(True)  # only the panes of the slide take another size and style
        if on:
            self.slots.set_presenting(True)
        self.menus.find.setEnabled(not on)  # a class sees no search
        for action in (self.menus.blank, self.menus.pointer, self.menus.strip, self.menus.pen):
            action.setEnabled(on)
        self.menus.pointer.setChecked(False)
        self.slide.pen.switch(False)
        self.slide.pen.setVisible(on)
        self.fit_screen(on)
        self.controls.set_presenting(on)
        self.control_strip.set_presenting(on)
        self._body.setContentsMargins(*(NO_MARGINS if on else BODY_MARGINS))
        self._body.setSpacing(0 if on else BODY_GAP_PX)
        self.body.setAutoFillBackground(on)
        self.menus.fit_icons()
        dock, whole, shared = self._before_presenting
        if on:
            self.setFocus()  # no pane of the slide has a ring
        else:
            self.slots.arrange(self.slots.layout_name, self.slots.large, whole)
            self.slots.set_presenting(False)
            self.menus.controls.setChecked(dock)
            QTimer.singleShot(0, self, partial(self.split.setSizes, shared))
        self.show_beside()
        self.look.set_waiting(False)

    def fit_screen(self, on: bool = True) -> None:
        """Use sizes for the screen that the class sees, or the ordinary ones."""
        self.look.set_presenting(on)
        self.comparing.pictures.set_presenting(on, self.present.screen_px)
        self.slide.equation.set_screen(self.present.screen_px)

    def set_style(self, style: Style) -> None:
        """Give a slide the colour of its pictures' paper."""
        worn = QtGui.QPalette()
        if self.present.is_on:
            worn.setColor(QtGui.QPalette.ColorRole.Window, QtGui.QColor(style.background))
        self.body.setPalette(worn)

    def show_beside(self) -> None:
        """Show or hide the dock, the lesson's card, the bottom row, the open panel and titles."""
        alone, presents = bool(self.slots.whole), self.present.is_on
        card = self.lesson_card.is_on and not alone and not self.talks.is_on
        # Below a lesson's card the controls take no extra width, so a narrow window shows them.
        wanted = self.menus.controls.isChecked() or (card and self._is_narrow)
        self.side.show_parts(card=card, controls=wanted and not alone)
        self.bottom.setVisible(not alone and not presents)
        course = self.lessons.course if self.talks.is_on else None
        # While presenting, only the panel of the talk's step is open.
        asked = course is not None and course.shown(self.lessons.place).view.get("panel")
        is_slide = self.slots.shows("kinds")
        folds = alone or (presents and not asked and not is_slide)
        if folds and self.panels.open_panel is not None:
            self._folded = self.panels.open_panel
            self.panels.open(None)
        elif not folds and self._folded is not None:
            self.panels.open(self._folded)
            self._folded = None
        self.drawer.set_presenting(presents, alone=is_slide)
        for pane in self.panes.values():
            named = not presents or len(self.slots.slide) != 1
            pane.set_presenting(presents and not pane.isWindow(), named=named)

    def focusNextPrevChild(self, forwards: bool) -> bool:
        held, presents, whole = self.focusWidget(), self.present.is_on, self.slots.whole
        if held and not held.isVisible() and (presents or whole):  # no pane of a slide has a ring
            (self if presents else self.panes[whole].canvas).setFocus()
            return True
        return focus_next(self.cover or self, forwards)

    def paintEvent(self, event: QtGui.QPaintEvent) -> None:
        super().paintEvent(event)
        if not self._was_painted:
            self._was_painted = True
            QTimer.singleShot(0, self, self.first_painted.emit)  # when painting is complete

    def resizeEvent(self, event: QtGui.QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().height() != event.oldSize().height():
            self.drawer.fit()
        is_narrow = event.size().width() < FOLDS_BELOW_PX
        if is_narrow != self._is_narrow and not self.present.is_on:
            self._is_narrow = is_narrow
            self.menus.controls.setChecked(not is_narrow)
            self.show_beside()

    def dragEnterEvent(self, event: QtGui.QDragEnterEvent) -> None:
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QtGui.QDropEvent) -> None:
        paths = [url.toLocalFile() for url in event.mimeData().urls() if url.isLocalFile()]
        if paths:
            event.acceptProposedAction()
            if len(paths) > 1:
                self.show_message(WORDS.say("one-file", os.path.basename(paths[0])))
            # After the drop: a dialog inside it would freeze the file manager.
            QTimer.singleShot(0, self, partial(self.files.open, paths[0]))

    def closeEvent(self, event: QtGui.QCloseEvent) -> None:
        take_typed(self)
        self.recovery.autosave.save_now()  # in case the program ends while the question is open
        if self.work_left is None and not self.files.may_discard():
            event.ignore()
            return
        self._is_closed = True
        geometry = self.present.geometry_before or self.saveGeometry()
        self.present.blockSignals(True)  # nobody sees this window as an ordinary one again
        dress(self.settings)
        self.talks.close_speaker()
        self.history.stand_still()
        self.strip.pause()
        self.counting.stop()
        self.measure_panel.close_process()
        self.settings.cannot_save = lambda _why: None
        self.settings.geometry = bytes(geometry.data())
        self.lesson_card.keep_now()
        self.recovery.close()
        self.store.blockSignals(True)  # a turning wheel may still end its gesture
        self.comparing.pictures.close_canvases()
        for pane in self.panes.values():
            pane.close_canvas()
            if pane.isWindow():
                pane.hide()
        super().closeEvent(event)
