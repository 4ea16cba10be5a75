"""The window: three panes, the controls, and the wires between them and the store.

::

    controls, animation --edited--> Store --changed(document)--> Shown, and what changed in it
    menus, tool bar ----------------^                            |
                      panes, controls, the open panel, status line: take(shown, changed)

What it does is done in the rooms beside this one; here they are made and joined.
"""

from __future__ import annotations

import logging
import os
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import QByteArray, QEvent, QSize, Qt, QTimer, Signal
from PySide6.QtGui import (
    QCloseEvent,
    QDragEnterEvent,
    QDropEvent,
    QKeyEvent,
    QPaintEvent,
    QResizeEvent,
)
from PySide6.QtWidgets import QMainWindow, QSplitter, QWidget

from app.document.document import Document
from app.document.store import Store
from app.model.projection import Camera
from app.scenes.scene import Scene
from widgets.controls.scene_card import SceneCard
from widgets.panels.frame_panel import FramePanel
from widgets.panels.kinds_panel import KindsPanel
from widgets.panels.matrix_panel import MatrixPanel
from widgets.panels.measure_panel import MeasurePanel
from widgets.panels.probe_panel import ProbePanel
from widgets.panels.scene_panel import ScenePanel
from widgets.panes.canvas import CANVASES
from widgets.panes.counting import Counting
from widgets.panes.cursor import Cursor
from widgets.panes.manipulation import Manipulation
from widgets.panes.pane import SMOOTHINGS, Pane
from widgets.panes.stage_strip import StageStrip
from widgets.parts import palette
from widgets.parts.focus import focus_next
from widgets.parts.gestures import Gestures
from widgets.parts.highlight import Highlighter
from widgets.parts.layouts import in_column, in_row
from widgets.parts.message_bar import MessageBar
from widgets.parts.panel import EVERYTHING, Changed, Panel, Shown, Told
from widgets.parts.writing import all_digits, lettering
from widgets.window.actions import Actions, take_typed
from widgets.window.arrangement import Arrangement
from widgets.window.comparing import Comparing
from widgets.window.drawer import Drawer, Panels
from widgets.window.files import Files
from widgets.window.help import Help
from widgets.window.history import History
from widgets.window.lesson_card import LessonCard, Side
from widgets.window.lessons import Lessons
from widgets.window.look import Look, dress
from widgets.window.pictures import Pictures
from widgets.window.present import Present, Screens
from widgets.window.probing import Probing
from widgets.window.quality import Cost, DrawnQuality
from widgets.window.recovery import Recovery
from widgets.window.scene_guide import SceneGuide
from widgets.window.settings import data_folder
from widgets.window.slots import Slots
from widgets.window.start_card import StartCard
from widgets.window.status_line import StatusLine
from widgets.window.talk_band import TalkBand
from widgets.window.talks import TalkActions, Talks
from widgets.window.world_look import WorldLook

log = logging.getLogger(__name__)


def _world(*args: Any) -> Any:
    from app.drawings.world import WorldDrawing

    return WorldDrawing(*args, live=True)


def _stage(*args: Any) -> Any:
    from app.drawings.stage import StageDrawing

    return StageDrawing(*args)


def _image(*args: Any) -> Any:
    from app.drawings.image import ImageDrawing

    return ImageDrawing(*args)


DRAWINGS: dict[str, Callable[..., Any]] = {"world": _world, "ndc": _stage, "image": _image}
"""Of each pane; VTK is imported by them."""
AT_FIRST_PX = (1366, 768)
FOLDS_BELOW_PX = 1200
"""A window that is narrower has no room for the dock beside its panes; a key opens it."""
PICTURES_AND_DOCK = [1075, 285]
LONGEST_UNSEEN_MS = 100
"""How long a pane is waited for that shows nothing: it may be hidden, or its drawing has failed."""


class MainWindow(QMainWindow):
    """One document in three linked panes.

    Parameters
    ----------
    document : Document
        What is shown first; its scene must be loadable.
    saved : Document, optional
        What is in its file, if that is another one.
    settings : Settings
        The user's own: theme, recent files, window geometry.
    software_rendering : bool
        Whether OpenGL runs without a GPU; antialiasing then waits while a control is dragged.
    path : Path, optional
        The file that was opened.
    scene : Scene, optional
        The document's scene, if it is loaded already.
    canvas : {"raster", "opengl"}
        How the panes draw.

    Raises
    ------
    Refusal
        If the document's scene cannot be loaded.
    """

    first_painted = Signal()
    """The window is on the screen, its panes still empty."""
    filled = Signal()
    """All panes show their pictures, or have tried to."""

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
        self._is_closed = False
        self.start_card: StartCard | None = None
        self._is_narrow = False
        self._folded: Panel | None = None
        """The panel that is open when no pane has the whole window, and nothing is presented."""
        self._before_presenting: tuple[bool, str, list[int]] | None = None
        """Whether the dock was there, which pane was whole, and how the width was shared out."""
        self.settings = settings
        settings.cannot_save = self._tell_unsaved
        dress(settings)  # before there are widgets, which would keep the font of before
        self.store = Store(document, self, saved=saved)
        self.messages = MessageBar()
        titles = {"world": self.tr("World"), "ndc": self.tr("NDC cube"), "image": self.tr("Image")}
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
        self.manipulation = Manipulation(self.panes["world"], self.panes["image"], self)
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
            self, self.messages, lambda: self.store.seen, self.files.scene, titles, self.look.words
        )
        self.help = Help(self)
        self.menus = Actions(
            self,
            files=self.files,
            pictures=self.pictures,
            help_=self.help,
            slots=self.slots,
            panes=self.panes,
            theme=settings.theme,
            all_digits=settings.all_digits,
        )
        self.present = Present(self, self.menus.tools, self.bottom, Screens(settings))
        self._make_rooms()
        self._wire()
        self._wire_lesson()
        self._wire_gestures()
        self._wire_highlight()
        self._tell(EVERYTHING)
        self.history.show()
        if path is not None:
            self.files.take_up(path)
        if not self.restoreGeometry(QByteArray(settings.geometry or b"")):  # which may be damaged
            self.resize(QSize(*AT_FIRST_PX).boundedTo(self.screen().availableSize()))
        QTimer.singleShot(0, self.recovery.offer)
        self._was_painted = False

    def open_panes(self) -> None:
        """Fill the panes, the largest first, each on the screen before the next is begun."""
        self._empty = sorted(self.panes.values(), key=lambda pane: pane.width())
        self._filling = QTimer(self, singleShot=True)
        self._filling.timeout.connect(self._open_next)
        self._open_next()

    def _open_next(self) -> None:
        if not self._empty:
            self._filling.timeout.disconnect()  # by a pane that is late it would end once more
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
        """Make all panels; what every panel may want of the window is wired in `_wire`."""
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
        panels: tuple[tuple[Panel, str, str], ...] = (
            (self.matrices, self.tr("Matrices"),
             self.tr("Every stage's matrix: numbers, formulas, factors and products")),
            (self.frame_panel, self.tr("Camera frame"),
             self.tr("The camera's axes, step by step: eye, target and up make the view matrix")),
            (self.kinds_panel, self.tr("Kinds of projection"),
             self.tr("The tree of planar projections: which one the picture is, and a click"
                     " makes it another")),
            (self.probe_panel, self.tr("Probe"), self.tr("Follow points through every stage")),
            (self.scene_panel, self.tr("Explanation and diagrams"),
             self.tr("What the scene shows, in which lectures, and its diagrams")),
            (self.measure_panel, self.tr("Precision"),
             self.tr("How exact picture and numbers are, and what speed costs, measured here")),
        )  # fmt: skip
        for panel, name, tip in panels:
            self.panels.add(name, panel, tip)

    def _lay_out(self) -> None:
        # From the outside inwards: Qt styles all that a widget holds whenever it gets a parent.
        body = QWidget()
        self.setCentralWidget(body)
        self.band, self.bottom = TalkBand(), QWidget()
        self.split = split = QSplitter(Qt.Orientation.Horizontal)
        parts = (self.messages, self.band, (split, 1), self.bottom)
        in_column(*parts, on=body, margins=(4, 4, 4, 0), gap=2)
        self.slots = Slots(self.panes, self.strip)
        self.drawer = Drawer(split, self.slots, self.panels)
        self.side = Side(split)
        self.controls = self.side.controls
        split.setStretchFactor(0, 1)
        split.setStretchFactor(1, 0)
        split.setSizes(PICTURES_AND_DOCK)
        in_row(self.panels.names, (self.status, 1), on=self.bottom, margins=(0, 0, 0, 2))

    def _make_rooms(self) -> None:
        """What joins several parts, and the order in which all that show something are told."""
        image, controls = self.panes["image"], self.controls
        self.guide = SceneGuide(
            self.scene_panel, self.panels, controls, self.manipulation, image, self.menus,
            self.store, self.files.choose_scene,
        )  # fmt: skip
        self.comparing = Comparing(
            image, self.look, self.store, self.slots, controls.card, self.menus, self.messages
        )
        self.arrangement = Arrangement(
            self.panes, self.slots, WorldLook(self.panes, self.menus), self.strip, self.panels,
            self.matrices, self.frame_panel, self.probe_panel, self.comparing.pictures,
        )  # fmt: skip
        self.store.look = lambda: self.arrangement.view
        self.cost = Cost(self.panes, self.status)
        self.quality = DrawnQuality(
            self.look, image, self.status, self.settings, self.store, lambda: self.shown,
            self.files.scene, self.messages.say,
        )  # fmt: skip
        players = (
            controls.animation.pause,
            controls.card.pause,
            *(cursor.let_go for cursor in self.cursors.values()),
        )
        self.history = History(
            self, self.store, self.menus, lambda: self.shown.scene.start, players
        )
        self.lessons = Lessons(
            self.store, self.files, self.messages, self.history.stand_still, self.strip.go_to,
            self._look_from,
        )  # fmt: skip
        self.lesson_card = LessonCard(self.lessons, self.store, self.settings)
        self.side.take_card(self.lesson_card)
        self.files.lesson_wanted.connect(self.lesson_card.open)
        self.talks = Talks(
            self,
            self.lessons,
            self.present,
            self.store,
            self.messages,
            self.settings,
            self.band,
            self.look,
        )
        self.talk_actions = TalkActions(self.talks, self, self.settings)
        self.menus.lesson_menu.addSeparator()
        self.menus.lesson_menu.addActions(self.talk_actions.all)
        self.lessons.opened.connect(self.talk_actions.show_lesson)
        self.recovery = Recovery(data_folder(), self.store, self.messages, self.files, self)
        self._told: tuple[Told, ...] = (
            *self.cursors.values(),
            self.manipulation,  # which lets go of what is held before it is gone
            self.probing,
            self.guide,  # which tells the controls what scene it is
            self.controls,
            self.slots,
            self.arrangement,  # which takes back what a scene has opened or forgotten by itself
            self.cost,
            self.look,
            self.comparing,  # of the image that has been told
            self.counting,
            self.strip,
            self.files,
            self.status,
            self.quality,  # of what was drawn just now
        )

    def _wire(self) -> None:
        store, controls, menus, strip, ndc = (
            self.store, self.controls, self.menus, self.strip, self.panes["ndc"]
        )  # fmt: skip
        store.changed.connect(self._show_document)
        store.view_changed.connect(self._show_view)
        controls.edited.connect(store.set_projection)
        controls.animation.playing_changed.connect(menus.show_playing)
        self.manipulation.edited.connect(store.set_projection)
        self.frame_panel.step_changed.connect(partial(self.panes["world"].ask, "step"))
        strip.moved.connect(partial(ndc.ask, "stage"))
        controls.object_unfolded.connect(partial(self.panes["world"].ask, "object_axes"))
        strip.named.connect(ndc.header.say)
        strip.moved.connect(self.matrices.show_stage)
        lettering.set("own")  # of another window before this one
        self.matrices.letters_changed.connect(lettering.set)
        self.matrices.letters_changed.connect(self.look.set_letters)
        strip.gesture_started.connect(partial(self.look.refine, "ndc", False))
        strip.gesture_finished.connect(partial(self.look.refine, "ndc", True))
        self.history.rested.connect(self.look.rest)
        self.history.rested.connect(self.comparing.pictures.refresh)
        self.look.built.connect(self.manipulation.leave)
        self.look.built.connect(controls.set_style)
        self.look.built.connect(self.comparing.pictures.set_style)
        all_digits.set(self.settings.all_digits)
        menus.all_digits_set.connect(self._set_all_digits)
        menus.find.triggered.connect(self._find_control)
        menus.play.triggered.connect(controls.animation.toggle)
        menus.theme_chosen.connect(self.look.set_theme)
        menus.present.triggered.connect(self.present.toggle)
        menus.blank.triggered.connect(self.present.blank)
        menus.pointer.toggled.connect(self.probing.set_pointing)
        self.present.switched.connect(self._show_presenting)
        self.present.moved.connect(partial(self.look.set_presenting, True))
        self.present.switched.connect(self.messages.put_off)
        self.slots.rearranged.connect(self._show_beside)
        menus.start_card.triggered.connect(self.show_start_card)
        menus.controls_shown.connect(self._show_beside)
        menus.cost_shown.connect(self.cost.measure)
        self.files.recent_changed.connect(menus.show_recent)
        menus.show_recent()
        self.pictures.told.connect(self._tell_shortly)
        for panel in self.panels.all:
            panel.edited.connect(store.set_projection)
            panel.told.connect(self._tell_shortly)
            panel.refused.connect(self.messages.say)
            panel.copy_wanted.connect(self.pictures.copy_diagram)
            panel.export_wanted.connect(self.pictures.export_diagram)
            self.look.built.connect(panel.set_style)
        self.panels.opened.connect(lambda: self.slots.set_low(self.panels.open_panel is not None))
        self.panels.chosen.connect(self.probing.begin)
        probe, measure, card = self.probe_panel, self.measure_panel, controls.card
        menus.remove_probe.triggered.connect(probe.remove)
        probe.changed.connect(lambda: menus.remove_probe.setEnabled(bool(probe.probes)))
        measure.went_on.connect(self.messages.take_back)
        measure.succeeded.connect(self.messages.done)
        measure.used.connect(self.manipulation.let_go)
        measure.used.connect(self.quality.use)
        measure.used.connect(lambda: self.panels.open(measure))  # the one that offered it stays
        self.counting.counted.connect(card.show_count)
        card.mesh_wanted.connect(self.files.mesh_dialog)
        card.mesh_removed.connect(partial(self.files.use_mesh, ""))

    def _wire_lesson(self) -> None:
        """Join the lesson's card to its keys, and to all that a task may ask for."""
        card, menus = self.lesson_card, self.menus
        menus.lesson_menu.wire(card, self.settings)
        card.begun_again.connect(self._offer_answers)
        card.toggled.connect(self._show_beside)
        card.toggled.connect(self.side.make_room)
        looked = (*menus.fixed.values(), *menus.layers.values())
        for signal in (
            self.store.changed,
            self.store.view_changed,
            self.strip.moved,
            self.slots.rearranged,
            self.panels.opened,
            self.probe_panel.changed,
            self.frame_panel.step_changed,
            self.matrices.letters_changed,
            self.comparing.pictures.changed,
            *(pane.hand.moved for pane in self.panes.values()),
            *(action.triggered for action in looked),
        ):
            signal.connect(card.look_again)
        self._show_beside()

    def _wire_gestures(self) -> None:
        """Let everyone know when values run: the store makes one step of them."""
        store, controls, panels = self.store, self.controls, self.panels.all
        sources: tuple[Gestures, ...] = (
            controls, controls.animation, self.manipulation, *panels
        )  # fmt: skip
        listeners: tuple[Store | SceneCard | Panel, ...] = (store, controls.card, *panels)
        for each in sources:
            for told in listeners:
                each.gesture_started.connect(told.begin_gesture)
                each.gesture_finished.connect(told.end_gesture)
            each.gesture_abandoned.connect(store.abandon_gesture)
        self.strip.gesture_started.connect(self.measure_panel.begin_gesture)
        self.strip.gesture_finished.connect(self.measure_panel.end_gesture)

    def _wire_highlight(self) -> None:
        """Let everyone point at things, and show what is pointed at."""
        self.highlighter = Highlighter(self)
        mark = self.highlighter.mark
        self.controls.highlighted.connect(mark)
        places: tuple[Pane | Panel, ...] = (
            *self.panes.values(), *self.panels.all
        )  # fmt: skip
        for number, place in enumerate(places):
            place.highlighted.connect(partial(mark, number))
            self.highlighter.changed.connect(place.show_highlight)
        self.highlighter.changed.connect(self.controls.show_highlight)

    def _offer_answers(self, title: str, take_back: Callable[[], object]) -> None:
        text = self.tr("What was answered in “{0}” is forgotten.").format(title)
        self.messages.say(text, (self.tr("Undo"), take_back))

    def _tell_unsaved(self, path: Path) -> None:
        text = self.tr(
            "Settings and progress cannot be written to {0}. They are kept until the program ends,"
            " and saving is tried again with the next change: free some space on the disk."
        )
        self.messages.say(text.format(path))

    def _set_all_digits(self, on: bool) -> None:
        self.settings.all_digits = on
        all_digits.set(on)

    def _look_from(self, cameras: Mapping[str, Camera]) -> None:
        """Look at the panes from there; at those that are not named as ever."""
        for name, pane in self.panes.items():
            pane.look_from(cameras.get(name))

    def _find_control(self) -> None:
        if self.controls.isHidden():
            self.menus.controls.trigger()
        self.controls.find_control()

    # -- showing the document

    def _snapshot(self, document: Document) -> Shown:
        return Shown.of(document, self.files.scene(document.scene, document.mesh))

    def _show_document(self, document: Document) -> None:
        before = self.shown
        try:
            self.shown = self._snapshot(document)
            self._tell(self.shown.changed_since(before))
        except Exception as error:
            if self.files.scene(document.scene, document.mesh) is before.scene:
                raise
            # A mesh whose drawing fails leaves nothing of itself in the window.
            log.exception("the scene %r cannot be drawn", document.mesh or document.scene)
            self.files.keep(before.document, before.scene)
            self.store.refuse()
            text = self.tr("{0} cannot be drawn, and what was shown before stays: {1}")
            name = os.path.basename(document.mesh or document.scene)
            self.messages.say(text.format(name, repr(error)))

    def _show_view(self, document: Document) -> None:
        self.shown = replace(self.shown, document=document)
        self.arrangement.show(document.view)
        self.comparing.pictures.refresh()

    def _tell(self, changed: Changed) -> None:
        """Tell everyone who is concerned what has changed."""
        self.panels.keep(self.shown)
        # Which tells them, after their arrangement; of another scene all at once.
        self.look.set_waiting(bool(changed & {"scene", "view"}))
        try:
            for told in self._told:
                if changed & told.concerns:
                    told.take(self.shown, changed)
        finally:
            self.look.set_waiting(False)
        self.panels.tell()
        self.recovery.autosave.schedule()

    # -- events

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            if event.type() == QEvent.Type.ShortcutOverride and self._on_top():
                event.accept()  # before Esc is the probes' shortcut
                return True
            if event.type() == QEvent.Type.KeyPress and (leave := self._on_top()):
                leave()
                return True
        if event.type() == QEvent.Type.DevicePixelRatioChange and self.panes["world"].drawing:
            self.look.rebuild()
        return super().event(event)

    def statusBar(self) -> StatusLine:
        """The line at the bottom: Qt would make a second one below it, and keep it."""
        return self.status

    def _tell_shortly(self, text: str) -> None:
        self.status.showMessage(text, 5000)

    def show_start_card(self) -> None:
        """Offer the scenes as pictures, lessons, talks and files."""
        if self.start_card is not None:
            return
        self.start_card = card = StartCard(
            self,
            self.menus.scene_titles,
            self.files.recent,
            self.settings.progress,
            at_every_start=self.settings.start_card,
            dark=palette.is_dark(self.settings.theme),
        )
        card.scene_chosen.connect(self.guide.choose)
        card.file_chosen.connect(self.files.open)
        card.open_wanted.connect(self.files.open_dialog)
        card.always_set.connect(partial(setattr, self.settings, "start_card"))
        card.left.connect(self._forget_start_card)
        card.open()

    def _forget_start_card(self) -> None:
        self.start_card = None

    def _on_top(self) -> Callable[[], object] | None:
        """What Esc leaves: start card, blank, presenting; or message, comparison, whole pane."""
        if self.start_card is not None:
            return self.start_card.close
        if self.present.is_on:
            return self.present.leave
        if self.messages.text and not self.messages.choices:  # an offer would be lost
            return self.messages.done
        if self.comparing.is_on:
            return self.comparing.end
        return partial(self.slots.bring, self.slots.whole) if self.slots.whole else None

    def _show_presenting(self, on: bool) -> None:
        if on:
            dock = self.menus.controls.isChecked()
            self._before_presenting = dock, self.slots.whole, self.split.sizes()
        self.menus.blank.setEnabled(on)
        self.menus.pointer.setEnabled(on)
        self.menus.pointer.setChecked(False)
        self.look.set_presenting(on)
        self.controls.set_presenting(on)
        for pane in self.panes.values():
            pane.header.set_presenting(on)
        self.menus.fit_icons()
        if not on and self._before_presenting is not None:
            whole = self._before_presenting[1]
            self.slots.arrange(self.slots.layout_name, self.slots.large, whole)
        self.slots.set_presenting(on)
        if on and self._is_narrow:  # where it is folded away: a class is to read what to try
            self.menus.controls.setChecked(True)
        if not on and self._before_presenting is not None:
            dock, _, shared = self._before_presenting
            self.menus.controls.setChecked(dock)
            QTimer.singleShot(0, self, partial(self.split.setSizes, shared))
        self._show_beside()

    def _show_beside(self) -> None:
        """Show what stands beside the panes, as far as it is for a class, or nothing is whole."""
        alone, presents = bool(self.slots.whole), self.present.is_on
        card = self.lesson_card.is_on and not alone and not self.talks.is_on
        # Below a lesson's card they take no width: a lesson never locks the controls.
        wanted = self.menus.controls.isChecked() or (card and self._is_narrow)
        self.side.show_parts(card=card, controls=wanted and not alone)
        self.bottom.setVisible(not alone and not presents)
        course = self.lessons.course if self.talks.is_on else None
        # A class reads no panel but that of the talk's step.
        asked = course is not None and course.shown(self.lessons.place).view.get("panel")
        folds = alone or (presents and not asked)
        if folds and self.panels.open_panel is not None:
            self._folded = self.panels.open_panel
            self.panels.open(None)
        elif not folds and self._folded is not None:
            self.panels.open(self._folded)
            self._folded = None

    def focusNextPrevChild(self, forwards: bool) -> bool:
        return focus_next(self, forwards)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self._was_painted:
            self._was_painted = True
            QTimer.singleShot(0, self, self.first_painted.emit)  # when all of it was painted

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().height() != event.oldSize().height():
            self.drawer.fit()
        is_narrow = event.size().width() < FOLDS_BELOW_PX
        if is_narrow != self._is_narrow and not self.present.is_on:
            self._is_narrow = is_narrow
            self.menus.controls.setChecked(not is_narrow)
            self._show_beside()

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        paths = [url.toLocalFile() for url in event.mimeData().urls() if url.isLocalFile()]
        if paths:
            event.acceptProposedAction()
            if len(paths) > 1:
                said = self.tr("One file is opened at a time: {0}")
                self._tell_shortly(said.format(os.path.basename(paths[0])))
            # After the drop is done: a question asked inside it would freeze the file manager.
            QTimer.singleShot(0, partial(self.files.open, paths[0]))

    def closeEvent(self, event: QCloseEvent) -> None:
        take_typed(self)
        self.recovery.autosave.save_now()  # whatever ends the program while the question stands
        if not self.files.may_discard():
            event.ignore()
            return
        self._is_closed = True
        geometry = self.present.geometry_before or self.saveGeometry()
        self.present.end()
        self.talks.close_speaker()
        self.history.stand_still()
        self.strip.pause()
        self.counting.stop()
        self.measure_panel.close_process()
        self.settings.cannot_save = lambda _path: None
        self.settings.geometry = bytes(geometry.data())
        self.lesson_card.keep_now()
        self.recovery.close()
        self.store.blockSignals(True)  # a wheel may still be turning, and end its gesture
        self.comparing.pictures.close_canvases()
        for pane in self.panes.values():
            pane.close_canvas()
            if pane.isWindow():
                pane.hide()
        super().closeEvent(event)
