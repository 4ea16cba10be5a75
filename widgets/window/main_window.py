"""The window: three panes, the controls, and the wires between them and the store.

::

    controls, animation --edited--> Store --changed(document)--> Shown, and what changed in it
    menus, tool bar ----------------^                            |
                      panes, controls, the open panel, status line
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import (
    QByteArray,
    QEvent,
    Qt,
    QTimer,
)
from PySide6.QtGui import (
    QCloseEvent,
    QDragEnterEvent,
    QDropEvent,
    QGuiApplication,
    QKeyEvent,
    QResizeEvent,
)
from PySide6.QtWidgets import (
    QApplication,
    QMainWindow,
    QSplitter,
    QVBoxLayout,
    QWidget,
)

from app.document.document import Document, set_values
from app.document.store import Store
from app.drawings import WORDS
from app.drawings.image import ImageDrawing
from app.drawings.ndc import NdcDrawing
from app.drawings.probes import sort_ahead
from app.drawings.world import WorldDrawing
from app.model.projection import Camera, Projection
from app.model.refusal import Refusal
from app.precision.levels import rung_for_drawing
from app.precision.quality import AUTO, AUTOMATIC
from app.scenes.phenomena import PHENOMENA
from app.scenes.phenomena.illustration import Value
from app.scenes.scene import BUILT_IN, Scene
from widgets.controls.animation import AnimationBar
from widgets.controls.controls import Controls
from widgets.panels.frame_panel import FramePanel
from widgets.panels.matrix_panel import MatrixPanel
from widgets.panels.measure_panel import MeasurePanel
from widgets.panels.probe_panel import ProbePanel
from widgets.panels.scene_panel import ScenePanel
from widgets.panes.adaptive import Adaptive
from widgets.panes.canvas import CANVASES
from widgets.panes.counting import Counting
from widgets.panes.manipulation import Manipulation
from widgets.panes.pane import SCALES, SMOOTHINGS, Pane
from widgets.panes.stage_strip import StageStrip
from widgets.parts import palette
from widgets.parts.focus import focus_next
from widgets.parts.highlight import Attended
from widgets.parts.message_bar import MessageBar
from widgets.parts.messages import Words, file_title, of_phenomena, sentence
from widgets.parts.panel import EVERYTHING, Changed, Panel, Shown
from widgets.window.actions import Actions, take_typed
from widgets.window.drawer import Column, Panels
from widgets.window.files import Files
from widgets.window.help import Help
from widgets.window.pane_row import PANE_WIDTHS, PaneRow
from widgets.window.pictures import Pictures
from widgets.window.probing import Probing
from widgets.window.recovery import Recovery
from widgets.window.settings import data_folder
from widgets.window.status_line import StatusLine

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
    canvas : {"raster", "opengl"}
        How the panes draw.

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
        canvas: str = "raster",
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
        self.shown = self._snapshot(document)
        self._told_about = ""
        """The scene whose panel was opened or folded by itself."""
        self._model_ms = 0.0
        self._costs: dict[str, tuple[float, float]] = {}
        """Of the last step, by the panes' titles: matrices and repaint, in ms."""
        self.recovery = Recovery(
            data_folder(),
            lambda: self._with_views(self.store.document) if self.store.modified else None,
            self.messages,
            self.files,
            self,
        )

        make_canvas = CANVASES[canvas]
        self.panes = {
            name: Pane(title, DRAWINGS[name], orbits=name != "image", make_canvas=make_canvas)
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
        self.counting = Counting(self._in_motion, self)
        self.panels = Panels()
        self._make_panels()
        self.probing = Probing(
            self.panes,
            self.probe_panel,
            self.manipulation,
            lambda: self.shown.scene,
            lambda: self.shown.projection,
            self,
        )
        self._lay_out()
        self.menus = Actions(
            self,
            files=self.files,
            pictures=self.pictures,
            help_=self.help,
            row=self.pane_row,
            panes=self.panes,
            titles=self._titles,
            scene_titles=self._scene_titles,
            theme=settings.theme,
            projector=settings.projector,
        )
        self._make_status_line()
        self._wire()
        self._show(EVERYTHING)
        self._history_changed()
        if path is not None:
            self.files.take_up(path)
        if settings.geometry:
            self.restoreGeometry(QByteArray(settings.geometry))
        else:
            self.resize(1366, 768)
        QTimer.singleShot(0, self.recovery.offer)

    # -- making

    def _make_panels(self) -> None:
        """Make all panels; what every panel may want of the window is wired in `_wire`."""
        self.matrices = MatrixPanel()
        self.frame_panel = FramePanel()
        self.probe_panel = ProbePanel()
        self.scene_panel = ScenePanel()
        self.measure_panel = MeasurePanel(lambda: self.store.document, self._in_use, SMOOTHINGS)
        tips: dict[Panel, tuple[str, str]] = {
            self.matrices: (
                self.tr("Matrices"),
                self.tr("Every stage's matrix: numbers, formulas, factors and products"),
            ),
            self.frame_panel: (
                self.tr("Camera frame"),
                self.tr("u, v, n, step by step: how eye, target and up make the view matrix"),
            ),
            self.probe_panel: (self.tr("Probe"), self.tr("Follow points through every stage")),
            self.scene_panel: (
                self.tr("About this scene"),
                self.tr("What the scene shows, its own settings and its numbers"),
            ),
            self.measure_panel: (
                self.tr("Measure"),
                self.tr("What speed costs in accuracy, measured here for this scene and camera"),
            ),
        }
        for panel, (name, tip) in tips.items():
            self.panels.add(name, panel, tip)

    def _lay_out(self) -> None:
        self.pane_row = PaneRow(self.panes, self._titles, self.strip)
        split = QSplitter(Qt.Orientation.Horizontal)
        split.addWidget(self.pane_row)
        split.addWidget(self.controls)
        split.setStretchFactor(0, 1)
        split.setStretchFactor(1, 0)
        split.setSizes([1040, 320])
        self.pane_row.setSizes(PANE_WIDTHS)
        self.column = Column(
            split, self.panels, lambda: self.settings.projector, lambda: self.store.in_gesture
        )
        body = QWidget()
        layout = QVBoxLayout(body)
        layout.setContentsMargins(4, 4, 4, 0)
        layout.addWidget(self.messages)
        layout.addWidget(self.column, 1)
        self.setCentralWidget(body)

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
        if quality.detail < 1.0 and self.adaptive.drawn is self.shown.scene:
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
        store, controls, menus = self.store, self.controls, self.menus
        menus.undo.triggered.connect(self.undo)
        menus.redo.triggered.connect(self.redo)
        menus.reset.triggered.connect(self.reset)
        menus.remove_probe.triggered.connect(self.probe_panel.remove)
        menus.play.triggered.connect(controls.animation.toggle)
        menus.scene_chosen.connect(self.choose_scene)
        menus.theme_chosen.connect(self.set_theme)
        menus.controls_shown.connect(controls.setVisible)
        menus.projector_set.connect(self.set_projector)
        menus.cost_shown.connect(self.set_cost_shown)
        store.changed.connect(self._show_document)
        store.history_changed.connect(self._history_changed)
        controls.edited.connect(store.set_projection)
        self.manipulation.edited.connect(store.set_projection)
        self.frame_panel.step_changed.connect(self.panes["world"].show_step)
        panels = self.panels.all
        sources: tuple[Controls | AnimationBar | Manipulation | Panel, ...] = (
            controls, controls.animation, self.manipulation, *panels
        )  # fmt: skip
        listeners: tuple[Store | Panel, ...] = (store, *panels)
        for source in sources:
            for told in listeners:
                source.gesture_started.connect(told.begin_gesture)
                source.gesture_finished.connect(told.end_gesture)
        controls.gesture_abandoned.connect(store.abandon_gesture)
        for panel in panels:
            panel.edited.connect(store.set_projection)
            panel.gesture_abandoned.connect(store.abandon_gesture)
            panel.outgrown.connect(self.column.outgrown)
            panel.told.connect(lambda text: self.statusBar().showMessage(text, 5000))
            panel.refused.connect(self.messages.say)
            panel.copy_wanted.connect(self.pictures.copy_diagram)
            panel.export_wanted.connect(self.pictures.export_diagram)
        self.strip.gesture_started.connect(self.measure_panel.begin_gesture)
        self.strip.gesture_finished.connect(self.measure_panel.end_gesture)
        self.measure_panel.went_on.connect(self.messages.take_back)
        self.measure_panel.succeeded.connect(self.messages.done)
        controls.animation.playing_changed.connect(self.menus.show_playing)
        self.strip.moved.connect(self._stage_moved)
        self.strip.gesture_started.connect(partial(self._refine_ndc, False))
        self.strip.gesture_finished.connect(partial(self._refine_ndc, True))
        self.files.path_changed.connect(self._name_window)
        self.files.recent_changed.connect(self._recent_changed)
        self.menus.show_recent()
        for name, pane in self.panes.items():
            pane.timed.connect(partial(self._pane_timed, name))
        self.probe_panel.changed.connect(self._show_probes)
        self.measure_panel.used.connect(self._use)
        attend = self.attention.attend
        controls.attended.connect(attend)
        places: tuple[Pane | Panel | StatusLine, ...] = (*self.panes.values(), *panels, self.status)
        for number, place in enumerate(places):
            place.attended.connect(partial(attend, number))
            self.attention.changed.connect(place.show_attention)
        self.attention.changed.connect(controls.show_attention)
        self.scene_panel.settings_edited.connect(self._set_settings)
        self.manipulation.setting_edited.connect(self._set_by_hand)
        rendered = self.panes["image"].canvas.shown
        rendered.connect(self._tell_problem)  # which only a rendering finds out
        self.counting.counted.connect(self.scene_panel.show_count)
        self.scene_panel.mesh_wanted.connect(self.files.mesh_dialog)
        self.scene_panel.mesh_removed.connect(partial(self.files.use_mesh, ""))
        QGuiApplication.styleHints().colorSchemeChanged.connect(self._scheme_changed)

    # -- showing the document

    def _snapshot(self, document: Document) -> Shown:
        scene, exhibit = self.files.scene(document.scene, document.mesh), None
        if scene.phenomenon is not None:  # computed once for panes and panel
            exhibit = scene.phenomenon.exhibit(
                document.projection, document.settings, scene.subject
            )
        return Shown(document, scene, exhibit)

    def _show_document(self, document: Document) -> None:
        before, self.shown = self.shown, self._snapshot(document)
        self._show(self.shown.changed_since(before))

    def _show(self, changed: Changed) -> None:
        """Tell everyone who is concerned what has changed."""
        shown = self.shown
        document, projection, scene = shown.document, shown.projection, shown.scene
        self.panels.keep(shown)
        if "scene" in changed:
            self.manipulation.let_go()
            self.probing.clear()
        built = bool(changed & {"scene", "views"}) or document.quality != self.adaptive.quality
        if built:
            self.adaptive.show(scene, document.quality)
        if changed & {"scene", "views"}:
            self.controls.set_scene(scene.size, scene.start)
            self._tell_about_scene(document, scene)
            self._build_drawings(document.views)
            self.menus.show_scene(document.scene)
            self._name_window()
            sort_ahead(scene)
        elif built:
            self._build_drawings(self._views_now())
        self.adaptive.step(self.store.in_gesture)
        if self.menus.show_cost.isChecked():
            self._time_model(projection)
        for pane in () if built else self.panes.values():
            pane.show_projection(projection, shown.exhibit)
        self.controls.show_projection(projection)
        self.manipulation.show_projection(projection)
        if changed & {"exhibit", "settings"}:
            self.manipulation.show_exhibit(shown.exhibit, document.settings)
        if "exhibit" in changed:
            self.counting.show(scene, projection, shown.exhibit)
        self.panels.tell()
        self.status.show_projection(projection, scene)
        self._show_quality()
        if "image_size" in changed:
            width, height = projection.image_size
            self.panes["image"].note.setText(f"{width} × {height}")
        if changed & {"lens", "image_size", "depth"}:
            self._name_stage(projection)
        self.recovery.autosave.schedule()

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
            pane.build(projection, self.shown.exhibit, views.get(name), *drawn, *how)
        self.manipulation.leave()

    def _in_use(self) -> dict[str, str]:
        """Which choices of the trades the panes are drawn with, as `Choice.use` has them."""
        document, scene = self.shown.document, self.shown.scene
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

    def choose_scene(self, name: str) -> None:
        """Change to another scene; it can be undone."""
        self.manipulation.let_go()  # what is held belongs to the scene before
        self.files.choose_scene(name)
        self.menus.show_scene(self.store.document.scene)

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

    def _show_probes(self) -> None:
        self.menus.remove_probe.setEnabled(bool(self.probe_panel.probes))
        for pane in self.panes.values():
            pane.show_probes(self.probe_panel.probes)

    # -- history, title, recent files

    def _history_changed(self) -> None:
        self.menus.show_history(can_undo=self.store.can_undo, can_redo=self.store.can_redo)
        if self.isWindowModified() != self.store.modified:  # it costs as much as a drawing
            self.setWindowModified(self.store.modified)
        if not self.store.in_gesture:
            self.adaptive.step(dragging=False)
            self.column.rest()
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
        self.menus.show_recent()

    # -- look

    def set_projector(self, on: bool) -> None:
        """Switch projector mode: larger text, thicker lines."""
        self.settings.projector = on
        self._dress()
        self._build_drawings(self._views_now())
        self.column.fit()

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
        if event.size().height() != event.oldSize().height():
            self.column.window_resized()

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
        take_typed(self)
        self.recovery.autosave.save_now()  # whatever ends the program while the question stands
        if not self.files.may_discard():
            event.ignore()
            return
        self.controls.animation.pause()
        self.strip.pause()
        self.scene_panel.pause()
        self.counting.stop()
        self.measure_panel.close_process()
        self.settings.geometry = bytes(self.saveGeometry().data())
        self.recovery.autosave.close()
        for pane in self.panes.values():
            pane.close_canvas()
            if pane.isWindow():
                pane.hide()
        super().closeEvent(event)
