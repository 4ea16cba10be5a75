"""Keeps the panes at the document's quality, and at a target frame time while a control is dragged.

::

    the document changes --> step(dragging) --> every pane: smoothing, detail
                                                   |  Qt paints, and swaps buffers
    FrameBudget <-- time from the change to the swap -----+
    the hand rests -------> step(False)     --> every pane at full quality
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtWidgets import QApplication, QWidget

from app.drawings.frame_budget import FrameBudget, Level
from app.precision.quality import AUTOMATIC, Quality
from app.scenes.fewer_triangles import is_made, reduced, shares_for_dragging
from app.scenes.scene import Scene
from widgets.panes.pane import SMOOTHINGS, Pane, multisamples
from widgets.parts.progress import progress_dialog

AT_FIRST = 200_000
"""Triangles that a software renderer is given at first, before it is known how many it draws in
time: to find that out with a million would hold the first step of a drag for half a second."""
MANY_TRIANGLES = 10_000
"""To make coarser versions of a scene of more takes so long that progress is shown."""
AT_REST = "FXAA"
"""How a pane smooths by itself. Where OpenGL is software it takes five times as long as the rest of
drawing a pane."""


class Adaptive(QObject):
    """The quality of the window's panes.

    Parameters
    ----------
    panes : mapping of str to Pane
    software_rendering : bool
        Whether OpenGL runs without a GPU: antialiasing then waits until the hand rests.
    target_ms : float
        Longest frame while a control is dragged; 0 for any.
    window : QWidget
        Parent, also of the dialog that shows progress.
    """

    changed = Signal()
    """Whether a drag misses the target at the coarsest quality, or how many samples there are, is
    another answer now."""

    def __init__(
        self,
        panes: Mapping[str, Pane],
        *,
        software_rendering: bool,
        target_ms: float,
        window: QWidget,
    ) -> None:
        super().__init__(window)
        self._panes, self._window = panes, window
        self.software_rendering = software_rendering
        self._target_ms = target_ms
        self._scene: Scene | None = None
        self.quality = AUTOMATIC
        self._dragging = False
        self._began: float | None = None
        self._drawn_at = 0.0
        self._told: tuple[bool, int] = (False, 0)
        self._idle = QTimer(self, singleShot=True, interval=0)  # the scene is to be seen first
        self._idle.timeout.connect(self._prepare)
        self.budget = FrameBudget([Level(False, 1.0)], 0.0)
        for pane in panes.values():
            pane.canvas.drawn.connect(self._drawn)
            pane.canvas.shown.connect(self._swapped)

    def show(self, scene: Scene, quality: Quality) -> None:
        """Take over what is drawn; the panes are to be built anew for it."""
        if scene is not self._scene or quality != self.quality:
            if not is_made(scene, quality.detail):
                self._make(scene, (quality.detail,), can_be_cancelled=False)
            if scene is not self._scene:
                self._idle.start()
            self._scene, self.quality = scene, quality
            self._plan()

    def ahead(self, scene: Scene) -> None:
        """Make what dragging may need of a scene that may be shown next."""
        if self._target_ms > 0.0:
            for share in shares_for_dragging(scene):
                reduced(scene, share)

    def set_target(self, target_ms: float) -> None:
        """Set the longest frame that is wanted while a control is dragged; 0 for any."""
        self._target_ms = target_ms
        self._plan()
        self._idle.start()

    @property
    def drawn(self) -> Scene:
        """The scene with as many triangles as its document asks for."""
        assert self._scene is not None
        return self.whole(self._scene)

    def whole(self, scene: Scene) -> Scene:
        """A scene with as many triangles as are drawn at rest."""
        return reduced(scene, self.quality.detail)

    @property
    def late_ms(self) -> float:
        """What frames take at the coarsest quality, if that is more than wanted; else 0.

        At rest nothing is late: nobody waits for a frame then.
        """
        return self.budget.frame_ms if self._dragging and self.budget.is_late else 0.0

    @property
    def samples(self) -> int:
        """How many samples a pixel OpenGL gives, where it is fewer than were chosen; else 0."""
        wanted = multisamples(self.quality.smoothing)
        given = min(pane.samples for pane in self._panes.values()) if wanted else 0
        return given if given < wanted else 0

    def smoothing(self, smooth: bool) -> str:
        """How a pane smooths: as was chosen, or else well or not at all."""
        if self.quality.smoothing in SMOOTHINGS:
            return self.quality.smoothing
        return AT_REST if smooth else "none"

    def step(self, dragging: bool) -> None:
        """The document has changed, or the hand has come to rest: to be called before drawing."""
        self._end_frame(self._drawn_at)  # if the hand was quicker than the screen
        self._dragging = dragging
        if dragging:
            self._began = time.perf_counter()
            level = self.budget.level
            share, smoothing = level.share, self.smoothing(level.smooth)
        else:
            self._began = None
            share, smoothing = self.quality.detail, self.smoothing(True)
        whole = self._scene is None or share == self.quality.detail
        for pane in self._panes.values():
            pane.set_smoothing(smoothing)
            pane.set_detail(None if whole or self._scene is None else reduced(self._scene, share))
        if not dragging:  # of a drag its first frame tells
            self._tell()

    def _swapped(self) -> None:
        """A pane's picture has reached the screen; with it those of its window's other panes."""
        self._end_frame(time.perf_counter())
        self._tell()

    def _drawn(self) -> None:
        """A pane's picture was drawn: the last one before the next step ends the frame."""
        self._drawn_at = time.perf_counter()

    def _end_frame(self, at: float) -> None:
        """Take down how long the step took that was drawn last; what is not drawn has no end."""
        if self._began is not None and self._drawn_at > self._began:
            self.budget.frame(1e3 * (at - self._began))
            self._began = None

    def _tell(self) -> None:
        found = self.late_ms > 0.0, self.samples
        if found != self._told:
            self._told = found
            self.changed.emit()

    def _plan(self) -> None:
        """The levels that there are just now, from the finest on."""
        assert self._scene is not None
        share = self.quality.detail
        levels = [Level(False, share)]
        if not self.software_rendering and self.quality.smoothing not in SMOOTHINGS:
            levels.insert(0, Level(True, share))
        coarser = (s for s in shares_for_dragging(self._scene) if s < share)
        levels += [Level(False, s) for s in coarser if is_made(self._scene, s)]
        first = 0
        if self.software_rendering and self._target_ms > 0.0 and self._scene.faces:
            faces = self._scene.faces
            few = (i for i, level in enumerate(levels) if level.share * faces <= AT_FIRST)
            first = next(few, len(levels) - 1)
        self.budget = FrameBudget(levels, self._target_ms, first)

    def _prepare(self) -> None:
        """Make what dragging may need of the scene, before anybody drags."""
        scene = self._scene
        if scene is None or self._target_ms <= 0.0:
            return
        missing = [share for share in shares_for_dragging(scene) if not is_made(scene, share)]
        if missing:
            self._make(scene, missing)
            self._plan()

    def _make(
        self, scene: Scene, shares: Sequence[float], *, can_be_cancelled: bool = True
    ) -> None:
        text = self.tr("Making coarser versions of the scene")
        with progress_dialog(self._window, text, len(shares)) as dialog:
            if not can_be_cancelled:
                dialog.setCancelButton(None)
            if scene.faces > MANY_TRIANGLES:
                dialog.show()  # the first version alone may take longer
            for done, share in enumerate(shares):
                dialog.setValue(done)
                if dialog.isVisible():  # and takes what is meant for the window
                    QApplication.processEvents()
                if dialog.wasCanceled():
                    return
                reduced(scene, share)
