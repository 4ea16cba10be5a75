"""The panes' drawing quality, its impossible parts, and the cost of a step.

::

    measure panel --use--> Store --take--> DrawnQuality --> sentences in the status line
    status line --tolerance, frame time--> DrawnQuality --> settings, panes
    panes --timed--> Cost --> the cost of a step in the status line
"""

import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QObject

from app.document.document import Document
from app.document.settings import set_values
from app.document.store import Store
from app.drawings.scene_place import place_of
from app.model.parameters import DISTANCE
from app.model.refusal import Refusal, counted
from app.precision.quality import AUTO, AUTOMATIC, Quality
from widgets.panes.canvas import SMOOTHINGS
from widgets.panes.pane import Pane
from widgets.parts.messages import sentence
from widgets.parts.panel import EVERYTHING, PROJECTION, Changed, ShownData
from widgets.window.look import Look
from widgets.window.settings import Settings
from widgets.window.status_line import StatusLine


def with_choice(document: Document, choice: Mapping[str, str]) -> Document:
    """Set a choice from a measurement, but not its scene, in the form of `ChartPoint.use`."""
    texts = [
        f"{key if '.' in key else f'quality.{key}'}={value}"
        for key, value in choice.items()
        if key not in ("scene", DISTANCE.path)
    ]
    document = set_values(document, texts)
    if DISTANCE.path in choice:
        away = DISTANCE.put(document.projection, float(choice[DISTANCE.path]))
        document = replace(document, projection=away)
    return document


class DrawnQuality(QObject):
    """Applies the user's choices between speed and accuracy, and reports them in the status line.

    `shown` returns the current snapshot, `begun` the document of a scene as it starts. `refuse`
    shows a sentence that says what is impossible.
    """

    concerns = EVERYTHING  # if all is automatic, a projection changes nothing that is reported

    def __init__(
        self,
        look: Look,
        image: Pane,
        status: StatusLine,
        settings: Settings,
        store: Store,
        shown: Callable[[], ShownData],
        begun: Callable[[str], Document],
        refuse: Callable[[str], object],
    ) -> None:
        super().__init__(look)
        self._look, self._image, self._status = look, image, status
        self._settings, self._store = settings, store
        self._shown, self._begun, self._refuse = shown, begun, refuse
        status.set_tolerance(settings.tolerance_px)
        status.frame_ms = settings.frame_ms
        status.tolerance_edited.connect(self._set_tolerance)
        status.frame_edited.connect(self._set_frame)
        status.quality.clicked.connect(self._automatic)
        look.adaptive.changed.connect(self._show_quality)

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Report the quality; the panes must have been notified first."""
        is_automatic = shown.document.quality == AUTOMATIC
        self.concerns = EVERYTHING - PROJECTION if is_automatic else EVERYTHING
        self._show_quality()

    def _show_quality(self) -> None:
        quality = self._shown().document.quality
        self._status.show_quality(quality, list(self._limitations(quality)))

    def _limitations(self, quality: Quality) -> Iterator[str]:
        """Say, without full stops, which part of the chosen quality is impossible."""
        adaptive = self._look.adaptive
        if quality.smoothing not in (AUTO, *SMOOTHINGS):
            text = self.tr("A pane cannot draw with {0}: it uses its default smoothing")
            yield text.format(quality.smoothing)
        if adaptive.samples:
            text = self.tr("This computer's OpenGL gives {0} per pixel instead of {1}")
            yield text.format(counted(adaptive.samples, "sample"), quality.smoothing)
        if quality.detail < 1.0 and adaptive.drawn is self._shown().scene:
            yield self.tr("The scene has too few triangles to leave any out")
        image = self._image.drawing
        if image is not None and quality.rung == "float64" != image.precision:
            yield self.tr("A textured surface can be drawn in float32 only")
        if image is not None and image.refused_depth is not None:
            reason = sentence(image.refused_depth).rstrip(".")
            yield self.tr("The image uses the ordinary depth buffer: {0}").format(reason)
        if adaptive.late_ms:
            text = self.tr(
                "A picture takes {0} ms to draw, so dragging stutters; a smaller window is smoother"
            )
            yield text.format(f"{adaptive.late_ms:.0f}")

    def _set_tolerance(self, tolerance_px: float) -> None:
        self._settings.tolerance_px = tolerance_px
        self._status.set_tolerance(tolerance_px)
        self._look.rebuild()

    def _set_frame(self, frame_ms: float) -> None:
        self._settings.frame_ms = frame_ms
        self._status.frame_ms = frame_ms
        self._look.adaptive.set_target(frame_ms)
        self._show_quality()

    def _automatic(self) -> None:
        self._store.set_document(replace(self._store.document, quality=AUTOMATIC))

    def use(self, choice: Mapping[str, str]) -> None:
        """Draw with a choice from a measurement, as one undo step.

        The keys of `choice` are fields of `Quality`, or "scene", paths in its document, and that of
        `DISTANCE`.
        """
        document = self._store.seen
        scene = choice.get("scene", document.scene)
        try:
            if scene != document.scene:
                document = self._begun(scene)
            document = with_choice(document, choice)
        except Refusal as error:
            self._refuse(sentence(error))
        else:
            self._store.set_document(document)

    def in_use(self) -> dict[str, str]:
        """Return the choices that the panes are drawn with, in the form of `ChartPoint.use`."""
        shown = self._shown()
        document, scene, projection = shown.document, shown.scene, shown.projection
        quality = document.quality
        precision = quality.rung
        if precision == AUTO:
            is_enough = max(place_of(scene, projection).bounds_px) <= self._settings.tolerance_px
            precision = "float32" if is_enough else "float64"
        automatic = self._look.adaptive.smoothing(True)
        return {
            "rung": precision,
            "depth_format": quality.depth_format or "fixed24",
            "depth_mapping": quality.depth_mapping or projection.depth,
            "smoothing": automatic if quality.smoothing == AUTO else quality.smoothing,
            "detail": f"{quality.detail:g}",
            "scene": document.scene,
            **{
                f"settings.{name}": f"{value:g}" if isinstance(value, float) else str(value)
                for name, value in document.settings.items()
            },
        }


class Cost(QObject):
    """Measures the cost of a step, and shows it in the status line."""

    concerns: Changed = frozenset()  # empty unless steps are measured

    def __init__(self, panes: Mapping[str, Pane], status: StatusLine) -> None:
        super().__init__(status)
        self._panes, self._status = panes.values(), status
        self.costs: dict[str, tuple[float, float]] = {}
        """Cost of the last step by pane: ms for the matrices and for the repaint."""
        self.model_ms = 0.0
        for pane in self._panes:
            pane.timed.connect(partial(self._pane_timed, pane.accessibleName()))

    def measure(self, on: bool) -> None:
        """Start or stop measuring every step."""
        self.concerns, self.costs = PROJECTION if on else frozenset(), {}
        self._status.cost.setVisible(on)
        for pane in self._panes:
            pane.canvas.set_timed(on)

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Time the model's matrices, which would otherwise count for the first pane."""
        began = time.perf_counter()
        _ = shown.projection.clip_from_world, shown.projection.image_from_ndc
        self.model_ms = 1e3 * (time.perf_counter() - began)

    def _pane_timed(self, name: str, matrices_ms: float, repaint_ms: float) -> None:
        self.costs[name] = matrices_ms, repaint_ms
        seen = [pane.accessibleName() for pane in self._panes if pane.isVisible()]
        costs = {name: self.costs[name] for name in seen if name in self.costs}
        self._status.show_cost(self.model_ms, costs)
