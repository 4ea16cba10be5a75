"""The window: three panes, the controls, and the wires between them and the store.

::

    controls, animation --edited--> Store --changed(document)--> panes, controls, status line
    menus, tool bar ----------------^                           (each: show_projection)
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import (
    QByteArray,
    QDateTime,
    QEvent,
    QLocale,
    QPointF,
    Qt,
    QTimer,
)
from PySide6.QtGui import (
    QAction,
    QActionGroup,
    QCloseEvent,
    QDragEnterEvent,
    QDropEvent,
    QGuiApplication,
    QKeyEvent,
    QKeySequence,
    QResizeEvent,
)
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QLabel,
    QLineEdit,
    QMainWindow,
    QSplitter,
    QToolBar,
    QVBoxLayout,
    QWidget,
)

from app.document.document import Document, set_values
from app.document.store import Store
from app.drawings import WORDS
from app.drawings.image import ImageDrawing
from app.drawings.ndc import NdcDrawing
from app.drawings.probes import pick_in, sort_ahead
from app.drawings.world import WorldDrawing
from app.model.projection import Camera, Projection
from app.model.refusal import Refusal
from app.picking.picking import Probe, dragged
from app.precision.levels import rung_for_drawing
from app.precision.quality import AUTO, AUTOMATIC
from app.scenes.phenomena import PHENOMENA
from app.scenes.phenomena.illustration import Exhibit, Value
from app.scenes.scene import BUILT_IN, Scene
from widgets.controls.controls import Controls
from widgets.panels.frame_panel import FramePanel
from widgets.panels.matrix_panel import MatrixPanel
from widgets.panels.measure_panel import MeasurePanel
from widgets.panels.probe_panel import ProbePanel
from widgets.panels.scene_panel import ScenePanel
from widgets.panes.adaptive import Adaptive
from widgets.panes.counting import Counting
from widgets.panes.manipulation import HOLD_WITHIN_PX, Manipulation
from widgets.panes.pane import SCALES, SMOOTHINGS, Pane
from widgets.panes.stage_strip import StageStrip
from widgets.parts import palette
from widgets.parts.escape import EscapeKey
from widgets.parts.focus import focus_next
from widgets.parts.highlight import Attended
from widgets.parts.message_bar import MessageBar
from widgets.parts.messages import Words, file_title, of_phenomena, sentence
from widgets.window.autosave import Autosave
from widgets.window.drawer import Panels
from widgets.window.files import Files
from widgets.window.help import FULL_SCREEN_KEY, PLAY_KEY, Help
from widgets.window.pictures import Pictures
from widgets.window.settings import data_folder
from widgets.window.status_line import StatusLine

PANE_WIDTHS = [400, 305, 330]
"""Of the panes in a window of 1366 pixels; the splitter keeps their proportion."""
LEAST_PANE_PX = 190
"""So that Full HD at a screen scale of 2 holds the window, in projector mode too."""
DRAWINGS: dict[str, Callable[..., Any]] = {
    "world": partial(WorldDrawing, live=True),
    "ndc": NdcDrawing,
    "image": ImageDrawing,
}


class MainWindow(QMainWindow):
    """One document in three linked panes.

    Parameters
    ----------
    document : Document
        What is shown first; its scene must be loadable.
    saved : Document, optional
        What is in its file, if that is another one.
    settings : Settings
        The user's own: theme, projector mode, recent files, window geometry.
    software_rendering : bool
        Whether OpenGL runs without a GPU; antialiasing then waits while a control is dragged.
    path : Path, optional
        The file that was opened.
    scene : Scene, optional
        The document's scene, if it is loaded already.

    Raises
    ------
    Refusal
        If the document's scene cannot be loaded.
    """

    def __init__(
        self,
        document: Document,
        *,
        settings: Any,
        software_rendering: bool,
        saved: Document | None = None,
        path: Path | None = None,
        scene: Scene | None = None,
    ) -> None:
        super().__init__()
        self.setObjectName("mainWindow")
        self.setAcceptDrops(True)
        self.settings = settings
        self._dress()  # before there are widgets, which would keep the font of before
        self._titles = {
            "world": self.tr("World"),
            "ndc": self.tr("NDC cube"),
            "image": self.tr("Image"),
        }
        self._scene_titles = {
            "letter-f": self.tr("Letter F"),
            "cube": self.tr("Unit cube"),
            "posts": self.tr("Row of posts"),
        }
        self._scene_titles |= {p.name: of_phenomena(p.title) for p in PHENOMENA.values()}
        # The drawings' words in the window's language; the letters are the lectures'.
        self._words = Words(
            {
                **WORDS,
                "near": self.tr("near"),
                "far": self.tr("far"),
                "eye": self.tr("eye"),
                "target": self.tr("target"),
                "look": self.tr("look"),
                "up": self.tr("up"),
            }
        )
        self.store = Store(document, self, saved=saved)
        self.attention = Attended(self)
        self.messages = MessageBar()
        self.files = Files(
            self, self.store, self.messages, lambda: settings.recent, self._with_views
        )
        if scene is not None:
            self.files.keep(document, scene)
        self.pictures = Pictures(
            self,
            self.messages,
            lambda: self._with_views(self.store.document),
            self.files.scene,
            self._titles,
            self._words,
        )
        self.help = Help(self)
        self._scene: Scene | None = None
        self._exhibit: Exhibit | None = None
        self._views: dict[str, Camera] = {}
        self._told_about = ""
        """The scene whose panel was opened or folded by itself."""
        self._model_ms = 0.0
        self._costs: dict[str, tuple[float, float]] = {}
        """Of the last step, by the panes' titles: matrices and repaint, in ms."""
        self._held: Probe | None = None
        """The probe that is being dragged in the image, as it was before."""
        self._escape = EscapeKey(self)
        self._escape.pressed.connect(self._put_probe_back)
        self._before_click: tuple[tuple[Probe, ...], int] = ((), 0)
        self.autosave = Autosave(
            data_folder(),
            lambda: self._with_views(self.store.document) if self.store.modified else None,
            self,
        )
        self.autosave.failed.connect(self._tell_no_copy)

        self.panes = {
            name: Pane(title, DRAWINGS[name], orbits=name != "image")
            for name, title in self._titles.items()
        }
        self.adaptive = Adaptive(
            self.panes,
            software_rendering=software_rendering,
            target_ms=settings.frame_ms,
            window=self,
        )
        self.manipulation = Manipulation(self.panes["world"], self.panes["image"], self)
        self.strip = StageStrip()
        self.panes["ndc"].add_below(self.strip)
        self.controls = Controls()
        self.matrices = MatrixPanel()
        self.panels = Panels()
        self.panels.add(
            self.tr("Matrices"), self.matrices,
            self.tr("Every stage's matrix: numbers, formulas, factors and products"),
        )  # fmt: skip
        self.frame_panel = FramePanel()
        self.panels.add(
            self.tr("Camera frame"), self.frame_panel,
            self.tr("u, v, n, step by step: how eye, target and up make the view matrix"),
        )  # fmt: skip
        self.probe_panel = ProbePanel()
        self.panels.add(
            self.tr("Probe"), self.probe_panel, self.tr("Follow points through every stage")
        )
        self.scene_panel = ScenePanel()
        self.counting = Counting(self._in_motion, self)
        self.panels.add(
            self.tr("About this scene"), self.scene_panel,
            self.tr("What the scene shows, its own settings and its numbers"),
        )  # fmt: skip
        self.measure_panel = MeasurePanel(lambda: self.store.document, self._in_use, SMOOTHINGS)
        self.panels.add(
            self.tr("Measure"), self.measure_panel,
            self.tr("What speed costs in accuracy, measured here for this scene and camera"),
        )  # fmt: skip
        self._lay_out()
        self._make_actions()
        self._make_status_line()
        self._wire()
        self._show_document(document)
        self._history_changed()
        if path is not None:
            self.files.take_up(path)
        if settings.geometry:
            self.restoreGeometry(QByteArray(settings.geometry))
        else:
            self.resize(1366, 768)
        QTimer.singleShot(0, self._offer_recovery)

    # -- making

    def _lay_out(self) -> None:
        self._pane_row = QSplitter(Qt.Orientation.Horizontal)
        self._pane_row.setChildrenCollapsible(False)
        for pane in self.panes.values():
            pane.setMinimumWidth(LEAST_PANE_PX)
            self._pane_row.addWidget(pane)
        self._split = QSplitter(Qt.Orientation.Horizontal)
        self._split.addWidget(self._pane_row)
        self._split.addWidget(self.controls)
        self._split.setStretchFactor(0, 1)
        self._split.setStretchFactor(1, 0)
        self._split.setSizes([1040, 320])
        self._pane_row.setSizes(PANE_WIDTHS)
        # Panels open below, and take no more than they were given last.
        self._column = QSplitter(Qt.Orientation.Vertical)
        self._column.addWidget(self._split)
        self._column.addWidget(self.panels)
        self._column.setStretchFactor(0, 1)
        self._column.setStretchFactor(1, 0)
        self._column.setCollapsible(0, False)
        self._column.setCollapsible(1, False)
        self.panels.opened.connect(self._fit_panels)
        self._column.splitterMoved.connect(self._panels_dragged)
        self._panels_px: int | None = None
        """The height that the hand has given them, in a window as high as it was then."""
        self._chosen_in = 0
        self._grown_px = 0
        """Otherwise the highest that one of them wanted, in a window as it was then."""
        self._grown_in = (0, False)
        self._is_outgrown = False
        """Whether one of them needs more since a gesture began."""
        body = QWidget()
        layout = QVBoxLayout(body)
        layout.setContentsMargins(4, 4, 4, 0)
        layout.addWidget(self.messages)
        layout.addWidget(self._column, 1)
        self.setCentralWidget(body)

    def _fit_panels(self) -> None:
        """Give an open panel its height, and a folded row of names no more than it needs.

        It is one height for all of them, or the panes would jump from name to name: it only grows,
        unless the hand has chosen it.
        """
        height = sum(self._column.sizes())
        names = wanted = self.panels.minimumSizeHint().height()
        if self.panels.open_panel is None:
            self.panels.setMaximumHeight(names)
        else:
            self.panels.setMaximumHeight(16777215)  # QWIDGETSIZE_MAX: as much as there is
            now = (self.height(), self.settings.projector)
            if now[0] < self._chosen_in:
                self._panels_px = None  # of a smaller window it would leave the panes too little
            if self._panels_px is None:
                if now != self._grown_in:
                    self._grown_in, self._grown_px = now, 0
                self._grown_px = max(self._grown_px, names, self.panels.sizeHint().height())
            wanted = self._panels_px or self._grown_px
        self._column.setSizes([height - wanted, wanted])

    def _panel_outgrown(self) -> None:
        """Give a panel the height that it needs now, but move no pane under the hand."""
        self._is_outgrown = self.store.in_gesture
        if not self._is_outgrown:
            self._fit_panels()

    def _panels_dragged(self) -> None:
        if self.panels.open_panel is not None:
            self._panels_px, self._chosen_in = self._column.sizes()[1], self.height()

    def _action(
        self,
        text: str,
        act: Callable[[], object],
        shortcut: str | QKeySequence.StandardKey | None = None,
        tip: str = "",
    ) -> QAction:
        action = QAction(text, self)
        action.triggered.connect(lambda _checked=False: act())
        if shortcut is not None:
            action.setShortcut(QKeySequence(shortcut))
        plain = (tip or text).replace("&", "").rstrip("…")
        keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
        action.setToolTip(f"{plain} ({keys})" if keys else plain)
        return action

    def _toggle(
        self, text: str, act: Callable[[bool], object], on: bool, shortcut: str | None = None
    ) -> QAction:
        action = self._action(text, lambda: act(action.isChecked()), shortcut)
        action.setCheckable(True)
        action.setChecked(on)
        return action

    def _with_typed(self, act: Callable[[], object]) -> Callable[[], object]:
        """An act on the document with what is typed and not yet entered."""

        def acted() -> None:
            self._take_typed()
            act()

        return acted

    def _take_typed(self) -> None:
        """Enter what is typed, as leaving its field would."""
        field = self.focusWidget()
        if isinstance(field, QLineEdit) and field.isModified():
            field.clearFocus()
            if not self.isActiveWindow():  # whose field has no keyboard to lose
                field.editingFinished.emit()

    def _make_actions(self) -> None:
        keys = QKeySequence.StandardKey
        bar = self.menuBar()

        menu = bar.addMenu(self.tr("&File"))
        open_ = self._action(
            self.tr("&Open…"), self._with_typed(self.files.open_dialog), keys.Open,
            self.tr("Open a document, a mesh or an exported picture"),
        )  # fmt: skip
        self._save = self._action(self.tr("&Save"), self._with_typed(self.files.save), keys.Save)
        save_as = self._action(
            self.tr("Save &as…"), self._with_typed(self.files.save_as), "Ctrl+Shift+S"
        )
        copy = self._action(
            self.tr("&Copy picture"), self._with_typed(self.pictures.copy), "Ctrl+Shift+C",
            self.tr("Copy the three panes to the clipboard, with the document inside"),
        )  # fmt: skip
        export = self._action(
            self.tr("&Export picture…"), self._with_typed(self.pictures.export_dialog), "Ctrl+E",
            self.tr("Export panes as a PNG picture that carries the document"),
        )  # fmt: skip
        menu.addAction(open_)
        self._recent_menu = menu.addMenu(self.tr("Open &recent"))
        menu.addSeparator()
        menu.addActions([self._save, save_as])
        menu.addSeparator()
        menu.addActions([export, copy])
        menu.addSeparator()
        menu.addAction(self._action(self.tr("&Quit"), self.close, keys.Quit))

        menu = bar.addMenu(self.tr("&Edit"))
        self._undo = self._action(self.tr("&Undo"), self.undo, keys.Undo)
        self._redo = self._action(self.tr("&Redo"), self.redo, keys.Redo)
        reset = self._action(
            self.tr("Reset &all"), self.reset, "Ctrl+R",
            self.tr("Put camera, lens, image and settings back to how the scene opens"),
        )  # fmt: skip
        menu.addActions([self._undo, self._redo])
        menu.addSeparator()
        menu.addAction(reset)
        self._remove_probe = self._action(
            self.tr("Remove the &probe"), self.probe_panel.remove, "Esc",
            self.tr("Remove the chosen probe from the panes"),
        )  # fmt: skip
        self._remove_probe.setEnabled(False)
        menu.addSeparator()
        menu.addAction(self._remove_probe)

        menu = bar.addMenu(self.tr("&Scenes"))
        self._scene_group = QActionGroup(self)
        for name in BUILT_IN:
            if name == next(iter(PHENOMENA)):
                menu.addSeparator()
            action = self._action(self._scene_titles[name], partial(self._choose_scene, name))
            action.setCheckable(True)
            action.setData(name)
            self._scene_group.addAction(action)
            menu.addAction(action)
        menu.addSeparator()
        menu.addAction(self._action(self.tr("Open a &mesh…"), self.files.open_dialog))

        menu = bar.addMenu(self.tr("&View"))
        for number, (name, title) in enumerate(self._titles.items(), start=1):
            text = self.tr("Enlarge {0}").format(title)
            menu.addAction(self._action(text, partial(self.enlarge, name), f"F{number + 5}"))
        menu.addAction(self._action(self.tr("Show &all panes"), self.show_all_panes, "F9"))
        menu.addAction(
            self._action(self.tr("&Reset the panes' own views"), self.reset_views, "Ctrl+0")
        )
        menu.addSeparator()
        self._show_controls = self._toggle(
            self.tr("&Controls"), self.controls.setVisible, True, "F4"
        )
        self._projector = self._toggle(
            self.tr("&Projector mode"), self.set_projector, self.settings.projector, "Ctrl+P"
        )
        self._projector.setToolTip(
            self.tr("Larger text and thicker lines, for the back row (Ctrl+P)")
        )
        self._show_cost = self._toggle(self.tr("Show c&ost"), self.set_cost_shown, False)
        self._show_cost.setToolTip(
            self.tr("Measure what every step takes: the model, each pane's matrices and repaint")
        )
        menu.addActions([self._show_controls, self._show_cost, self._projector])
        themes = menu.addMenu(self.tr("&Theme"))
        self._theme_group = QActionGroup(self)
        for theme, text in (
            ("system", self.tr("As the system")),
            ("light", self.tr("Light")),
            ("dark", self.tr("Dark")),
        ):
            action = self._action(text, partial(self.set_theme, theme))
            action.setCheckable(True)
            action.setChecked(theme == self.settings.theme)
            self._theme_group.addAction(action)
            themes.addAction(action)
        menu.addAction(
            self._action(self.tr("&Full screen"), self._toggle_full_screen, FULL_SCREEN_KEY)
        )

        menu = bar.addMenu(self.tr("&Help"))
        help_ = self._action(self.tr("&Keys and mouse"), self.help.show_keys, keys.HelpContents)
        menu.addAction(help_)
        menu.addAction(self._action(self.tr("&Conventions"), self.help.show_conventions))
        menu.addAction(self._action(self.tr("&About Frustum Lab"), self.help.show_about))

        self._play = self._action(
            self.tr("Play"), self.controls.animation.toggle, PLAY_KEY,
            self.tr("Play or pause the camera's orbit"),
        )  # fmt: skip

        tools = QToolBar(self.tr("Tools"))
        tools.setObjectName("tools")
        tools.setMovable(False)
        self._scene_box = QComboBox()
        self._scene_box.setAccessibleName(self.tr("Scene"))
        self._scene_box.setToolTip(self.tr("The scene in front of the camera"))
        self._scene_box.activated.connect(
            lambda index: self._choose_scene(self._scene_box.itemData(index))
        )
        tools.addWidget(self._scene_box)
        label = QLabel(self.tr("Scene"), tools)  # on Linux a box is named by its label, seen or not
        label.setBuddy(self._scene_box)
        label.hide()
        tools.addSeparator()
        tools.addActions([open_, self._save])
        tools.addSeparator()
        tools.addActions([self._undo, self._redo, reset])
        tools.addSeparator()
        tools.addAction(self._play)
        tools.addSeparator()
        tools.addActions([copy, export])
        tools.addSeparator()
        tools.addAction(self._projector)
        tools.addSeparator()
        tools.addAction(help_)
        self.addToolBar(tools)
        for action, text in (
            (open_, self.tr("Open")),
            (self._save, self.tr("Save")),
            (reset, self.tr("Reset")),
            (copy, self.tr("Copy")),
            (export, self.tr("Export")),
            (self._projector, self.tr("Projector")),
            (help_, self.tr("Help")),
        ):
            action.setIconText(text)
        keyed = [a for a in self.findChildren(QAction) if not a.shortcut().isEmpty()]
        for pane in self.panes.values():
            pane.addActions(keyed)  # which it takes along into a window of its own

    def _make_status_line(self) -> None:
        self.status = StatusLine()
        self.status.set_tolerance(self.settings.tolerance_px)
        self.status.tolerance_edited.connect(self._set_tolerance)
        self.status.set_frame(self.settings.frame_ms)
        self.status.frame_edited.connect(self._set_frame)
        self.status.automatic_wanted.connect(self._automatic)
        self.adaptive.changed.connect(self._show_quality)
        self.setStatusBar(self.status)

    def _set_tolerance(self, tolerance_px: float) -> None:
        self.settings.tolerance_px = tolerance_px
        self.status.set_tolerance(tolerance_px)
        self._build_drawings(self._views_now())

    def _set_frame(self, frame_ms: float) -> None:
        self.settings.frame_ms = frame_ms
        self.status.set_frame(frame_ms)
        self.adaptive.set_target(frame_ms)
        self._show_quality()

    def _use(self, choice: Mapping[str, str]) -> None:
        """Draw with what a measurement has offered, as an edit that can be undone.

        Parameters
        ----------
        choice : mapping of str to str
            Fields of `app.precision.quality.Quality`, or a scene and paths in its document, and
            their values.
        """
        document, panel = self.store.document, self.panels.open_panel
        scene = choice.get("scene", document.scene)
        if scene != document.scene:
            document = Document(scene, self.files.scene(scene).start, document.extra)
        texts = [
            f"{key if '.' in key else f'quality.{key}'}={value}"
            for key, value in choice.items()
            if key != "scene"
        ]
        try:
            document = set_values(document, texts)
        except Refusal as error:
            self.messages.say(sentence(error))
            return
        self.manipulation.let_go()
        self.store.set_document(document)
        self.panels.open(panel)  # the one that offered it stays

    def _automatic(self) -> None:
        self.store.set_document(replace(self.store.document, quality=AUTOMATIC))

    def _show_quality(self) -> None:
        """What is not automatic, and what of it a pane cannot do."""
        self.measure_panel.show_current()
        quality, notes = self.store.document.quality, []
        if quality.smoothing not in (AUTO, *SMOOTHINGS):
            notes.append(
                self.tr("A pane cannot draw with {0}: it smooths as ever").format(quality.smoothing)
            )
        if self.adaptive.samples:
            notes.append(
                self.tr("This computer's OpenGL gives {0} samples a pixel instead of {1}").format(
                    self.adaptive.samples, quality.smoothing
                )
            )
        if quality.detail < 1.0 and self.adaptive.drawn is self._scene:
            notes.append(self.tr("The scene has too few triangles to leave any out"))
        image = self.panes["image"].drawing
        if isinstance(image, ImageDrawing) and quality.rung == "float64" != image.rung:
            notes.append(self.tr("What has a texture can be drawn in float32 only"))
        if isinstance(image, ImageDrawing) and image.refused_depth is not None:
            reason = sentence(image.refused_depth).rstrip(".")
            notes.append(self.tr("The image has its ordinary depth buffer: {0}").format(reason))
        if self.adaptive.late_ms:
            notes.append(
                self.tr("Even the coarsest picture takes {0} ms a frame, not {1}").format(
                    f"{self.adaptive.late_ms:.0f}", f"{self.settings.frame_ms:g}"
                )
            )
        self.status.show_quality(quality, notes)

    def _wire(self) -> None:
        store, controls = self.store, self.controls
        store.changed.connect(self._show_document)
        store.history_changed.connect(self._history_changed)
        controls.edited.connect(store.set_projection)
        self.manipulation.edited.connect(store.set_projection)
        self.matrices.edited.connect(store.set_projection)
        self.frame_panel.edited.connect(store.set_projection)
        self.frame_panel.step_changed.connect(self.panes["world"].show_step)
        dragged_in = (controls, controls.animation, self.manipulation, self.frame_panel)
        paced = (self.matrices, self.probe_panel, self.scene_panel)
        for source in (*dragged_in, self.scene_panel):
            for told in (store, *paced, self.measure_panel):
                source.gesture_started.connect(told.begin_gesture)
                source.gesture_finished.connect(told.end_gesture)
        for source in (controls, self.frame_panel, self.scene_panel):
            source.gesture_abandoned.connect(store.abandon_gesture)
        self.strip.gesture_started.connect(self.measure_panel.begin_gesture)
        self.strip.gesture_finished.connect(self.measure_panel.end_gesture)
        self.measure_panel.refused.connect(self.messages.say)
        self.measure_panel.went_on.connect(self.messages.take_back)
        self.measure_panel.succeeded.connect(self.messages.done)
        controls.animation.playing_changed.connect(self._playing_changed)
        self.strip.moved.connect(self._stage_moved)
        self.strip.gesture_started.connect(partial(self._refine_ndc, False))
        self.strip.gesture_finished.connect(partial(self._refine_ndc, True))
        self.files.path_changed.connect(self._name_window)
        self.files.recent_changed.connect(self._recent_changed)
        self._list_recent()
        for name, pane in self.panes.items():
            pane.enlarge_requested.connect(partial(self.enlarge, name))
            pane.float_requested.connect(partial(self.toggle_float, name))
            pane.clicked.connect(partial(self._follow, name))
            pane.double_clicked.connect(self._unfollow)
            pane.timed.connect(partial(self._pane_timed, name))
        canvas = self.panes["image"].canvas
        canvas.drag_started.connect(self._hold_probe)
        canvas.dragged.connect(self._drag_probe)
        canvas.drag_ended.connect(self._let_probe_go)
        self.probe_panel.changed.connect(self._show_probes)
        self.probe_panel.refused.connect(self.messages.say)
        self.measure_panel.used.connect(self._use)
        attend = self.attention.attend
        controls.attended.connect(attend)
        pointing: dict[str, Pane | MatrixPanel | FramePanel | ProbePanel | StatusLine] = {
            **self.panes,
            "matrices": self.matrices, "frame": self.frame_panel,
            "probes": self.probe_panel, "status": self.status,
        }  # fmt: skip
        for name, place in pointing.items():
            place.attended.connect(partial(attend, name))
            self.attention.changed.connect(place.show_attention)
        self.attention.changed.connect(controls.show_attention)
        self.matrices.outgrown.connect(self._panel_outgrown)
        self.scene_panel.outgrown.connect(self._panel_outgrown)
        self.matrices.told.connect(lambda text: self.statusBar().showMessage(text, 5000))
        self.scene_panel.edited.connect(self._set_settings)
        self.manipulation.setting_edited.connect(self._set_by_hand)
        canvas.frameSwapped.connect(self._tell_problem)  # only a rendering finds out
        self.counting.counted.connect(self.scene_panel.show_count)
        for panel in (self.scene_panel, self.measure_panel):
            panel.copy_wanted.connect(self.pictures.copy_diagram)
            panel.export_wanted.connect(self.pictures.export_diagram)
        self.scene_panel.mesh_wanted.connect(self.files.mesh_dialog)
        self.scene_panel.mesh_removed.connect(partial(self.files.use_mesh, ""))
        QGuiApplication.styleHints().colorSchemeChanged.connect(self._scheme_changed)

    # -- showing the document

    def _show_document(self, document: Document) -> None:
        scene = self.files.scene(document.scene, document.mesh)
        built, self._exhibit = False, None
        if scene.phenomenon is not None:  # computed once for panes and panel
            self._exhibit = scene.phenomenon.exhibit(
                document.projection, document.settings, scene.subject
            )
        # An edit shares its views with the document before; another document brings its own.
        if scene is not self._scene:
            self.manipulation.let_go()
            self._held = None
            self.probe_panel.clear()
        if scene is not self._scene or document.views is not self._views:
            self._scene, self._views = scene, document.views
            self.adaptive.show(scene, document.quality)
            self.controls.set_scene(scene.size, scene.start)
            self._tell_about_scene(document, scene)
            self._build_drawings(document.views)
            self._list_scenes()
            self._name_window()
            sort_ahead(scene)
            built = True
        elif document.quality != self.adaptive.quality:
            self.adaptive.show(scene, document.quality)
            self._build_drawings(self._views_now())
            built = True
        self.adaptive.step(self.store.in_gesture)
        if self._show_cost.isChecked():
            self._time_model(document.projection)
        for pane in () if built else self.panes.values():
            pane.show_projection(document.projection, self._exhibit)
        self.controls.show_projection(document.projection)
        self.manipulation.show_projection(document.projection)
        self.matrices.show_projection(document.projection)
        self.frame_panel.show_projection(document.projection)
        self.probe_panel.show_projection(document.projection)
        self.counting.show(scene, document.projection, self._exhibit)
        self.manipulation.show_exhibit(self._exhibit, document.settings)
        self.scene_panel.show_exhibit(self._exhibit, document.settings, document.projection)
        self._show_notes(document.projection, scene)
        self.autosave.schedule()

    def _tell_about_scene(self, document: Document, scene: Scene) -> None:
        """Show what a scene is about; a phenomenon opens its panel and points out its controls."""
        title = self._scene_titles.get(document.scene, file_title(document.scene))
        self.scene_panel.show_scene(title, scene.phenomenon, Path(document.mesh).name)
        if document.scene == self._told_about:
            return
        self._told_about = document.scene
        self.controls.bring_to_front(scene.phenomenon.controls if scene.phenomenon else ())
        if scene.phenomenon is not None:
            self.panels.open(self.scene_panel)
        elif self.panels.open_panel is self.scene_panel:
            self.panels.open(None)

    def _in_motion(self) -> bool:
        return self.store.in_gesture

    def _tell_problem(self) -> None:
        """Say, and draw again, where this computer's OpenGL refused a scene's own shader."""
        pane = self.panes["image"]
        if isinstance(pane.drawing, ImageDrawing):
            problem = pane.drawing.problem
            if self.scene_panel.show_problem(problem) and problem is not None:
                pane.request_repaint()

    def _set_settings(self, settings: Mapping[str, Value]) -> None:
        try:
            self.store.set_settings(settings)
        except Refusal as error:
            self.scene_panel.refuse(error)

    def _set_by_hand(self, settings: Mapping[str, Value]) -> None:
        try:
            self.store.set_settings(settings)
        except Refusal as error:
            self.manipulation.refuse(self.scene_panel.named(error))

    def _build_drawings(self, views: dict[str, Camera]) -> None:
        style = palette.drawing_style(
            dark=palette.is_dark(self.settings.theme),
            projector=self.settings.projector,
            device_pixel_ratio=self.devicePixelRatioF(),
        )
        projection, quality = self.store.document.projection, self.adaptive.quality
        self.matrices.set_style(style)
        self.scene_panel.set_style(style)
        self.measure_panel.set_style(style)
        for name, pane in self.panes.items():
            # The world pane is looked at by a camera of its own, which is never at an extreme.
            how: tuple[object, ...] = ()
            if name != "world":
                how = (quality.tolerance_px(self.settings.tolerance_px),)
            if name == "image":
                how += (quality,)
            drawn = (
                self.adaptive.drawn,
                self._words,
                style.enlarged(SCALES.get(quality.smoothing, 1)),
            )
            pane.build(projection, self._exhibit, views.get(name), *drawn, *how)
        self.manipulation.leave()

    def _in_use(self) -> dict[str, str]:
        """Which choices of the trades the panes are drawn with, as `Choice.use` has them."""
        document, scene = self.store.document, self._scene
        assert scene is not None
        projection, quality = document.projection, document.quality
        rung = quality.rung
        if rung == AUTO:
            tolerance_px = self.settings.tolerance_px
            rung = rung_for_drawing(projection, scene.corners, scene.origin, tolerance_px)
        settings = document.settings
        return {
            "rung": rung,
            "depth_format": quality.depth_format or "fixed24",
            "depth_mapping": quality.depth_mapping or projection.depth,
            "smoothing": "FXAA" if quality.smoothing == AUTO else quality.smoothing,
            "detail": f"{quality.detail:g}",
            "scene": document.scene,
            "settings.interpolation": str(settings.get("interpolation", "correct")),
            "settings.subdivision": f"{settings.get('subdivision', 1.0):g}",
        }

    def _views_now(self) -> dict[str, Camera]:
        """From where the panes are looked at, of those that somebody turned."""
        views = {name: pane.view for name, pane in self.panes.items()}
        return {name: view for name, view in views.items() if view is not None}

    def _with_views(self, document: Document) -> Document:
        others = {name: view for name, view in document.views.items() if name not in self.panes}
        return replace(document, views=others | self._views_now())

    def _refine_ndc(self, smooth: bool) -> None:
        self.panes["ndc"].set_smoothing(
            self.adaptive.smoothing(smooth or not self.adaptive.software_rendering)
        )

    def _stage_moved(self, position: float) -> None:
        self.panes["ndc"].show_stage(position)
        self._name_stage(self.store.document.projection)

    def _name_stage(self, projection: Projection) -> None:
        """Title, axes and limits of what the NDC pane shows."""
        self.strip.show_projection(projection)
        self.panes["ndc"].set_title(self.strip.title(projection))

    def _show_notes(self, projection: Projection, scene: Scene) -> None:
        self.status.show_projection(projection, scene)
        self._show_quality()
        width, height = projection.image_size
        self.panes["image"].note.setText(f"{width} × {height}")
        self._name_stage(projection)

    def _list_scenes(self) -> None:
        name = self.store.document.scene
        self._scene_box.clear()
        for built_in in BUILT_IN:
            if built_in == next(iter(PHENOMENA)):
                self._scene_box.insertSeparator(self._scene_box.count())
            self._scene_box.addItem(self._scene_titles[built_in], built_in)
        if name not in BUILT_IN:
            self._scene_box.addItem(file_title(name), name)
        self._scene_box.setCurrentIndex(self._scene_box.findData(name))
        for action in self._scene_group.actions():
            action.setChecked(action.data() == name)

    def _choose_scene(self, name: str) -> None:
        self.manipulation.let_go()  # what is held belongs to the scene before
        self.files.choose_scene(name)
        self._list_scenes()

    def reset(self) -> None:
        """Put projection and settings back to how the scene opens; it can be undone."""
        document = self.store.document
        start = self.files.scene(document.scene, document.mesh).start
        self._stand_still()
        self.store.set_document(replace(document, projection=start, settings={}))

    def undo(self) -> None:
        """Go back one step; what plays stands still, or it would go on from there at once."""
        self._stand_still()
        self.store.undo()

    def redo(self) -> None:
        """Take the last undone step up again."""
        self._stand_still()
        self.store.redo()

    def _stand_still(self) -> None:
        self.controls.animation.pause()
        self.scene_panel.pause()

    # -- probes

    def _follow(self, name: str, place: QPointF) -> None:
        """Follow what was clicked in a pane: a point, or a pixel's ray where there is none."""
        chosen = self.probe_panel.chosen
        self._before_click = self.probe_panel.probes, chosen.number if chosen else 0
        drawing = self.panes[name].drawing
        assert drawing is not None and self._scene is not None
        x_px, y_px = place.x(), place.y()
        pixel = None
        if isinstance(drawing, ImageDrawing):
            pixel = drawing.image_pixel(x_px, y_px)
            if pixel is None:  # beside the picture
                return
        pixel_ratio = self.panes[name].canvas.pixel_ratio
        hit = pick_in(self._scene, drawing.sight, (x_px, y_px), pixel_ratio)
        if hit is not None:
            self.probe_panel.follow(point=hit.point)
        elif pixel is not None:
            self.probe_panel.follow(pixel=pixel)

    def _unfollow(self) -> None:
        """Forget the click that was the first half of a double-click."""
        self.probe_panel.restore(*self._before_click)

    def _hold_probe(self, place: QPointF) -> None:
        """Take hold of the mark in the image that a drag starts on, or of the picture."""
        drawing = self.panes["image"].drawing
        if drawing is None:
            return
        nearest = HOLD_WITHIN_PX * self.panes["image"].canvas.pixel_ratio
        for probe in self.probe_panel.probes:
            if probe.point is None:
                continue
            ((x_px, y_px),) = drawing.sight.seen([list(probe.point)]).tolist()
            away = math.hypot(x_px - place.x(), y_px - place.y())
            if away <= nearest:  # never for NaN, which has no picture
                nearest, self._held = away, probe
        if self._held is not None:
            self.probe_panel.choose(self._held.number)
            self.probe_panel.begin_gesture()
            self._escape.watch(self)
        else:
            self.manipulation.take_picture(place)

    def _drag_probe(self, away: QPointF, along_ray: bool) -> None:
        drawing = self.panes["image"].drawing
        if self._held is None or self._held.point is None or not isinstance(drawing, ImageDrawing):
            return
        projection = self.store.document.projection
        shift_px = drawing.image_shift(away.x(), away.y())
        point = dragged(projection, self._held.point, shift_px, along_ray=along_ray)
        if point is not None:
            self.probe_panel.put(self._held.number, point)

    def _let_probe_go(self) -> None:
        if self._escape.is_watched:
            self._escape.leave()
            self._held = None
            self.probe_panel.end_gesture()

    def _put_probe_back(self) -> None:
        """Give up the drag; whatever the hand does until it lets go is none."""
        if self._held is not None and self._held.point is not None:
            self.probe_panel.put(self._held.number, self._held.point)
        self._held = None

    def _show_probes(self) -> None:
        self._remove_probe.setEnabled(bool(self.probe_panel.probes))
        for pane in self.panes.values():
            pane.show_probes(self.probe_panel.probes)

    # -- history, title, recent files

    def _history_changed(self) -> None:
        self._undo.setEnabled(self.store.can_undo)
        self._redo.setEnabled(self.store.can_redo)
        if self.isWindowModified() != self.store.modified:  # it costs as much as a drawing
            self.setWindowModified(self.store.modified)
        if not self.store.in_gesture:
            self.adaptive.step(dragging=False)
            if self._is_outgrown:
                self._panel_outgrown()
            for pane in self.panes.values():
                pane.refit()

    def _name_window(self) -> None:
        scene = self.store.document.scene
        if self.files.path:
            name = self.files.path.name
        else:
            name = self.tr("Untitled") if scene in BUILT_IN else Path(scene).name
        self.setWindowTitle(f"{name}[*] – Frustum Lab")

    def _recent_changed(self) -> None:
        self.settings.recent = self.files.recent
        self._list_recent()

    def _list_recent(self) -> None:
        self._recent_menu.clear()
        for path in self.files.recent:
            action = self._recent_menu.addAction(path.replace("&", "&&"))  # no key of the menu
            action.triggered.connect(lambda _checked=False, path=path: self.files.open(path))
        self._recent_menu.setEnabled(bool(self.files.recent))

    def _playing_changed(self, playing: bool) -> None:
        self._play.setText(self.tr("Pause") if playing else self.tr("Play"))

    def _offer_recovery(self) -> None:
        orphans = self.autosave.orphans()
        if orphans:
            newest = orphans[0]
            self.messages.say(
                self.tr("Frustum Lab ended unexpectedly; work of {0} was not saved.").format(
                    QLocale().toString(
                        QDateTime.fromSecsSinceEpoch(int(newest.stat().st_mtime)),
                        QLocale.FormatType.ShortFormat,
                    )
                ),
                *self._ways_with(newest),
            )

    def _ways_with(self, path: Path) -> tuple[tuple[str, Callable[[], object]], ...]:
        """What can be done with a copy of unsaved work."""
        return (
            (self.tr("Recover it"), partial(self._recover, path)),
            (self.tr("Discard it"), partial(self._discard, path)),
        )

    def _recover(self, path: Path) -> None:
        try:
            document = self.autosave.recover(path)
        except Refusal as error:
            ways = self._ways_with(path) if path.exists() else ()  # or another window has it
            self.messages.say(sentence(error), *ways)
            return
        if self.files.open_recovered(document):
            if self.autosave.save_now():  # until then the old copy is the only one
                self._discard(path)
            else:
                self.messages.say(
                    self.tr("The recovered work cannot be kept in {0}: save it soon.").format(
                        path.parent
                    )
                )
        elif self.messages.text:  # a mesh that is not there, perhaps only not yet
            self.messages.say(self.messages.text, *self._ways_with(path))
        else:
            self._offer_recovery()

    def _discard(self, path: Path) -> None:
        try:
            self.autosave.discard(path)
        except OSError as error:
            self.messages.say(
                self.tr("{0} could not be removed: {1}.").format(path, error.strerror or error)
            )
            return
        self._offer_recovery()

    def _tell_no_copy(self, folder: str) -> None:
        self.messages.say(
            self.tr("No copy of unsaved work can be kept in {0}: save it soon.").format(folder)
        )

    # -- panes

    def enlarge(self, name: str) -> None:
        """Give one docked pane the whole row, or go back to all."""
        docked = [pane for pane in self.panes.values() if not pane.isWindow()]
        chosen = self.panes[name]
        if chosen.isWindow():
            return
        alone = all(pane.isHidden() for pane in docked if pane is not chosen)
        for pane in docked:
            pane.setVisible(alone or pane is chosen)

    def show_all_panes(self) -> None:
        """Dock and show every pane."""
        for name, pane in self.panes.items():
            if pane.isWindow():
                self.toggle_float(name)
            pane.show()
        self._pane_row.setSizes(PANE_WIDTHS)

    def toggle_float(self, name: str) -> None:
        """Give a pane a window of its own, for a second screen, or dock it again."""
        pane, plays = self.panes[name], self.strip.playing
        if pane.isWindow():
            names = list(self.panes)
            before = names[: names.index(name)]
            place = sum(not self.panes[other].isWindow() for other in before)
            pane.move_to(None, lambda: self._pane_row.insertWidget(place, pane))
        else:
            size = pane.size()
            pane.setWindowTitle(f"{self._titles[name]} – Frustum Lab")
            pane.move_to(self, lambda: pane.resize(size))
            docked = [other for other in self.panes.values() if not other.isWindow()]
            if docked and all(other.isHidden() for other in docked):
                docked[0].show()
        if plays:  # on the way it was hidden, which stops it
            self.strip.play()

    def reset_views(self) -> None:
        """Put every pane's own camera back; the model is not touched."""
        for pane in self.panes.values():
            pane.reset_view()

    # -- look

    def set_projector(self, on: bool) -> None:
        """Switch projector mode: larger text, thicker lines."""
        self.settings.projector = on
        self._dress()
        self._build_drawings(self._views_now())
        self._fit_panels()

    def set_cost_shown(self, on: bool) -> None:
        """Measure every step, and show what it takes in the status line; or do not."""
        self._costs = {}
        self.status.cost.setVisible(on)
        for pane in self.panes.values():
            pane.set_timed(on)

    def _pane_timed(self, name: str, matrices_ms: float, repaint_ms: float) -> None:
        self._costs[self._titles[name]] = matrices_ms, repaint_ms
        seen = [title for pane, title in self._titles.items() if self.panes[pane].isVisible()]
        costs = {title: self._costs[title] for title in seen if title in self._costs}
        self.status.show_cost(self._model_ms, costs)

    def _time_model(self, projection: Projection) -> None:
        """Compute now what every pane shares, which the first of them would be charged for."""
        began = time.perf_counter()
        _ = projection.clip_from_world, projection.image_from_ndc
        self._model_ms = 1e3 * (time.perf_counter() - began)

    def set_theme(self, theme: str) -> None:
        """Switch to ``"light"``, ``"dark"`` or ``"system"``."""
        self.settings.theme = theme
        self._dress()
        self._build_drawings(self._views_now())

    def _scheme_changed(self) -> None:
        if self.settings.theme == "system":
            self.set_theme("system")

    def _dress(self) -> None:
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        palette.apply(
            application,
            dark=palette.is_dark(self.settings.theme),
            projector=self.settings.projector,
        )

    def _toggle_full_screen(self) -> None:
        self.setWindowState(self.windowState() ^ Qt.WindowState.WindowFullScreen)

    # -- events

    def event(self, event: QEvent) -> bool:
        is_escape = isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape
        if is_escape and self.messages.text and not self.messages.choices:  # an offer would be lost
            event.accept()  # before Esc is the probes' shortcut
            if event.type() == QEvent.Type.KeyPress:
                self.messages.done()
            return True
        if event.type() == QEvent.Type.DevicePixelRatioChange and self.panes["world"].drawing:
            self._build_drawings(self._views_now())
        return super().event(event)

    def focusNextPrevChild(self, forwards: bool) -> bool:
        return focus_next(self, forwards)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if self._panels_px is None and event.size().height() != event.oldSize().height():
            self._fit_panels()

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        paths = [url.toLocalFile() for url in event.mimeData().urls() if url.isLocalFile()]
        if paths:
            event.acceptProposedAction()
            # After the drop is done: a question asked inside it would freeze the file manager.
            QTimer.singleShot(0, partial(self.files.open, paths[0]))

    def closeEvent(self, event: QCloseEvent) -> None:
        self._take_typed()
        self.autosave.save_now()  # whatever ends the program while the question stands
        if not self.files.may_discard():
            event.ignore()
            return
        self.controls.animation.pause()
        self.strip.pause()
        self.scene_panel.pause()
        self.counting.stop()
        self.measure_panel.close_process()
        self.settings.geometry = bytes(self.saveGeometry().data())
        self.autosave.close()
        for pane in self.panes.values():
            pane.close_canvas()
            if pane.isWindow():
                pane.hide()
        super().closeEvent(event)
