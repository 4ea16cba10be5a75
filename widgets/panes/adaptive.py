"""Keeps the panes at the document's quality, and at a target frame time while a control is dragged.

::

    the document changes --> step(dragging) --> every pane: smoothing, detail --> Qt paints
    FrameBudget <-- time from the change to the swap of the buffers <---------------+
    the drag ends ---------> step(False)    --> every pane at full quality
    a pane's own camera moves -> _turn(pane), and step(False) once the hand rests
"""

import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtWidgets import QApplication, QWidget

from app.drawings.frame_budget import FrameBudget, FrameQuality
from app.precision.quality import AUTOMATIC, Quality
from app.scenes.fewer_triangles import is_made, reduced, shares_for_dragging
from app.scenes.scene import Scene
from widgets.panes.canvas import MULTISAMPLES, REST_MS, SMOOTHINGS
from widgets.panes.pane import Pane
from widgets.parts.progress import progress_dialog

AT_FIRST = 200_000
"""Triangles of a software renderer's first frame, before its speed is known: a million would hold
the first step of a drag for half a second."""
_TURNING = 0.6  # of the target, while one pane alone follows the hand
MANY_TRIANGLES = 10_000  # making coarser versions of a scene with more triangles shows progress
BETWEEN_MS = 300  # between those of another scene, so that a hand waits for one at most
AT_REST = "FXAA"
"""The automatic smoothing. With OpenGL in software it takes five times as long as the rest."""


class Adaptive(QObject):
    """The quality of the window's panes.

    With `software_rendering` antialiasing waits for the end of a drag. `target_ms` is the longest
    frame while a control is dragged; 0 for any.
    """

    changed = Signal()  # `late_ms` has become zero or not zero, or `samples` has changed

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
        self._emitted: tuple[bool, int] = (False, 0)
        self._idle = QTimer(self, singleShot=True)  # the scene appears first
        self._idle.timeout.connect(self._prepare)
        self.budget = self._of_turning = FrameBudget([FrameQuality(False, 1.0)], 0.0)
        self._measured = self.budget  # the budget that the present frame counts for
        self._turned = QTimer(self, singleShot=True, interval=REST_MS)
        self._turned.timeout.connect(self._end_turn)
        for pane in panes.values():
            pane.hand.moved.connect(partial(self._turn, pane))
            pane.canvas.shown.connect(self._swapped)

    def show(self, scene: Scene, quality: Quality) -> None:
        """Plan the levels for another scene or quality; the caller builds its panes."""
        if scene is not self._scene or quality != self.quality:
            if not is_made(scene, quality.detail):
                self._make(scene, (quality.detail,), can_be_cancelled=False)
            if scene is not self._scene:
                self._idle.start(0 if scene.faces > MANY_TRIANGLES else BETWEEN_MS)
            self._scene, self.quality = scene, quality
            self._plan()

    def reduce_ahead(self, scene: Scene) -> Iterator[None]:
        """Make the coarser versions of a scene that may be shown next, one by one."""
        for share in shares_for_dragging(scene) if self._target_ms > 0.0 else ():
            reduced(scene, share)
            yield

    def set_target(self, target_ms: float) -> None:
        """Set the longest frame while a control is dragged; 0 for any."""
        self._target_ms = target_ms
        self._plan()
        self._idle.start(0)

    @property
    def drawn(self) -> Scene:
        """The scene with as many triangles as its document wants."""
        assert self._scene is not None
        return self.whole(self._scene)

    def whole(self, scene: Scene) -> Scene:
        """Return a scene with as many triangles as are drawn at rest."""
        return reduced(scene, self.quality.detail)

    @property
    def late_ms(self) -> float:
        """The ms of a frame at the coarsest quality if that exceeds the target; 0 at rest."""
        return self.budget.frame_ms if self._dragging and self.budget.is_late else 0.0

    @property
    def samples(self) -> int:
        """OpenGL's samples a pixel if they are fewer than chosen, else 0."""
        wanted = MULTISAMPLES.get(self.quality.smoothing, 0)
        shown = (p.canvas for p in self._panes.values() if wanted and p.isVisible() and p.drawing)
        given = min((canvas.samples for canvas in shown), default=wanted)
        return given if given < wanted else 0

    def smoothing(self, smooth: bool) -> str:
        """Return the chosen smoothing, else the automatic one, or none."""
        if self.quality.smoothing in SMOOTHINGS:
            return self.quality.smoothing
        return AT_REST if smooth else "none"

    def step(self, dragging: bool) -> None:
        """Set the quality before a change is drawn, or at the end of a drag."""
        self._turned.stop()
        self._draw(dragging, self.budget, self._panes.values())

    def _turn(self, pane: Pane) -> None:
        """Draw a pane as in a drag while the user moves its own camera."""
        self._draw(True, self._of_turning, (pane,))
        self._turned.start()

    def _end_turn(self) -> None:
        if any(pane.hand.is_down for pane in self._panes.values()):
            self._turned.start()
        else:
            self.step(False)
            for pane in self._panes.values():
                pane.refit()

    def _draw(self, dragging: bool, budget: FrameBudget, panes: Iterable[Pane]) -> None:
        self._end_frame()  # if the drag is faster than the screen
        self._dragging, self._measured = dragging, budget
        self._began = time.perf_counter() if dragging else None
        level = budget.level if dragging else FrameQuality(True, self.quality.detail)
        fewer: Scene | None = None
        if self._scene is not None and level.share != self.quality.detail:
            fewer = reduced(self._scene, level.share)
        smoothing = self.smoothing(level.smooth)
        for pane in panes:
            pane.request("smoothing", smoothing)
            pane.request("detail", fewer)
        if not dragging:  # in a drag the first frame decides
            self._emit_changed()

    def _swapped(self) -> None:
        """A pane's picture has reached the screen, with those of the other panes of its window."""
        self._end_frame(time.perf_counter())
        self._emit_changed()

    def _end_frame(self, at: float | None = None) -> None:
        """Record the time of the last drawn step, until `at` or else the last picture."""
        if self._began is None:
            return
        drawn_at = max(pane.canvas.drawn_at for pane in self._panes.values())
        if drawn_at > self._began:
            self._measured.frame(1e3 * ((at or drawn_at) - self._began))
            self._began = None

    def _emit_changed(self) -> None:
        state = self.late_ms > 0.0, self.samples
        if state != self._emitted:
            self._emitted = state
            self.changed.emit()

    def _plan(self) -> None:
        """Plan the present levels, from the finest on."""
        assert self._scene is not None
        share = self.quality.detail
        levels = [FrameQuality(False, share)]
        if not self.software_rendering and self.quality.smoothing not in SMOOTHINGS:
            levels.insert(0, FrameQuality(True, share))
        coarser = (s for s in shares_for_dragging(self._scene) if s < share)
        levels += [FrameQuality(False, s) for s in coarser if is_made(self._scene, s)]
        first = 0
        if self.software_rendering and self._target_ms > 0.0 and self._scene.cells:
            cells = self._scene.cells
            few = (i for i, level in enumerate(levels) if level.share * cells <= AT_FIRST)
            first = next(few, len(levels) - 1)
        self.budget = FrameBudget(levels, self._target_ms, first)
        self._of_turning = FrameBudget(levels, _TURNING * self._target_ms, first)

    def _prepare(self) -> None:
        """Make the coarser versions of the scene before anybody drags."""
        scene = self._scene
        if scene is None or self._target_ms <= 0.0:
            return
        missing = [share for share in shares_for_dragging(scene) if not is_made(scene, share)]
        if missing and scene.faces <= MANY_TRIANGLES:
            if not self._dragging:
                reduced(scene, missing[0])
                self._plan()
            self._idle.start(BETWEEN_MS)
        elif missing:
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
                if dialog.isVisible():  # it takes the window's events
                    QApplication.processEvents()
                if dialog.wasCanceled():
                    return
                reduced(scene, share)
