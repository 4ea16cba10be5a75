"""The status line: numerical risks, the chosen quality, and the cost of a step.

It also computes the precision of the picture and its numbers, for the Precision panel. Predicting
errors takes some milliseconds: it waits until the input stops, and is skipped while neither the
line nor the panel is visible.
"""

import math
from collections.abc import Mapping

from PySide6.QtCore import QEvent, QObject, QSize, Qt, QTimer, Signal, SignalInstance
from PySide6.QtGui import QResizeEvent, QShowEvent
from PySide6.QtWidgets import QMenu, QSizePolicy, QStatusBar, QToolButton

from app.drawings.frame_budget import LARGEST_FRAME_MS
from app.drawings.scene_place import place_of, predictions
from app.languages import with_comma
from app.model.projection import Projection
from app.precision import levels
from app.precision.quality import AUTOMATIC, Quality
from app.precision.risks import risks
from app.scenes.scene import Scene
from widgets.parts.labels import WarningLabel
from widgets.parts.layouts import tool_button
from widgets.parts.messages import plane_name, translated
from widgets.parts.number_field import NumberDialog
from widgets.parts.panel import PROJECTION, Changed, ShownData
from widgets.parts.plain import set_tip
from widgets.parts.wording import Wording

WORDS = Wording(__file__)
RESTS_AFTER_MS = 150  # time without changes after which errors are predicted


class StatusLine(QStatusBar):
    """One line at the bottom of the window; its button `precision` is in the Precision panel."""

    concerns = PROJECTION | {"scene"}
    tolerance_edited = Signal(float)  # error in pixels up to which a GPU's own arithmetic may draw
    frame_edited = Signal(float)  # longest frame while a control is dragged, in ms; 0 for no limit

    def __init__(self) -> None:
        super().__init__()
        self._projection: Projection | None = None
        self._scene: Scene | None = None
        self.tolerance_px = levels.DRAWING_TOLERANCE_PX
        self._predictions: dict[levels.Precision, levels.Prediction] | None = None
        self._drawn: levels.Precision = "float32"
        self._quality = AUTOMATIC
        self.frame_ms = 0.0
        self._risks: list[str] = []
        self._notes: list[str] = []
        self.health = _Elided("health")
        self.health.setAccessibleName(WORDS.say("health"))
        self.precision = QToolButton(autoRaise=True)
        self._show_precisions(0.0)
        self.precision.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.precision.setMenu(QMenu(self.precision))
        set_tip(self.precision, WORDS.say("precision"))
        self.precision.menu().aboutToShow.connect(self._fill_menu)
        self.precision.installEventFilter(self)
        self.quality = tool_button("", WORDS.say("quality-tip"), flat=True)
        # Without a text it would be as high as an icon, and take height from the panes.
        self.quality.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
        self.quality.hide()
        self.addWidget(self.quality)
        self.addWidget(self.health, 1)
        self.cost = _Elided("cost")
        self.cost.setAccessibleName(WORDS.say("cost"))
        self.cost.hide()
        self.addWidget(self.cost, 8)  # leaves room for the sign of `health`, with its tooltip
        self._rest = QTimer(self, singleShot=True, interval=RESTS_AFTER_MS)
        self._rest.timeout.connect(self._predict)

    def take(self, shown: ShownData, changed: Changed) -> None:
        self._projection, self._scene = shown.projection, shown.scene
        self._wait_for_rest()

    def show_cost(self, model_ms: float, panes: Mapping[str, tuple[float, float]]) -> None:
        """Show the cost of the last step.

        `model_ms` is the time for the model's matrices; `panes` holds, by the panes' titles, the
        times in ms to set the drawing's matrices and to repaint it.
        """
        parts = [
            WORDS.say("pane", title, f"{matrices:.1f}", f"{repaint:.1f}")
            for title, (matrices, repaint) in panes.items()
        ]
        text = WORDS.say("ms", "  ".join([WORDS.say("model", f"{model_ms:.1f}"), *parts]))
        self.cost.show_text(with_comma(text), with_comma(f"{WORDS.say('ms-tip')}\n{text}"))

    def set_tolerance(self, tolerance_px: float) -> None:
        self.tolerance_px = tolerance_px
        self._wait_for_rest()

    def show_quality(self, quality: Quality, notes: list[str]) -> None:
        """Show the chosen part of the quality, and notes: sentences without their full stops."""
        if (quality, notes) == (self._quality, self._notes):
            return
        values = quality.chosen.values()
        chosen = [with_comma(f"{100.0 * v:g} %") if isinstance(v, float) else v for v in values]
        self.quality.setText(WORDS.say("quality", ", ".join(chosen)))
        self.quality.setVisible(bool(chosen))
        if quality.rung != self._quality.rung:
            self._wait_for_rest()
        self._quality, self._notes = quality, notes
        self._show_health()

    def _show_health(self) -> None:
        self.health.show_sentences([f"{text}." for text in (*self._risks, *self._notes)])

    def minimumSizeHint(self) -> QSize:
        """Allow any width: a long sentence is elided so that the window may be small."""
        return QSize(0, super().minimumSizeHint().height())

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._appear()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Show:
            self._appear()  # the button has appeared in its panel
        return super().eventFilter(watched, event)

    def _appear(self) -> None:
        QTimer.singleShot(0, self, self._predict)

    def _wait_for_rest(self) -> None:
        if self.isVisible() or self.precision.isVisible():
            self._rest.start()

    def _predict(self) -> None:
        if self._projection is None or self._scene is None:
            return
        projection, scene = self._projection, self._scene
        self._predictions = predictions(projection, scene)
        tolerance_px = self._quality.tolerance_px(self.tolerance_px)
        found_px = place_of(scene, projection).bounds_px
        drawing_px = max(found_px)
        self._drawn = "float32" if drawing_px <= tolerance_px else "float64"
        float32_px = max((px for px in found_px if px <= tolerance_px), default=0.0)
        self._show_precisions(float32_px)
        self._risks = [
            with_comma(translated(risk.template, "Health").format(*map(plane_name, risk.figures)))
            for risk in risks(
                projection, scene.lower, scene.upper, self._drawn, drawing_px, self._predictions
            )
        ]
        self._show_health()

    def _show_precisions(self, float32_px: float) -> None:
        """Show the precisions; `float32_px` bounds the error of what float32 draws."""
        drawn, predictions = self._drawn, self._predictions
        read = levels.precision_for_reading(predictions)
        text = WORDS.say("precisions", drawn, read)
        if predictions is not None:
            # Whatever computes the picture, a rasteriser gets float32 in the end.
            at_least_px = max(self._projection.image_size) * 2.0**-24 if self._projection else 0.0
            predicted_px = predictions[drawn].px if drawn != "float32" else 0.0
            drawn_text = _error_text(max(float32_px, predicted_px, at_least_px))
            text = WORDS.say("errors", drawn, drawn_text, read, _error_text(predictions[read].px))
        self.precision.setText(with_comma(text))

    def _fill_menu(self) -> None:
        menu = self.precision.menu()
        menu.clear()
        read = levels.precision_for_reading(self._predictions)
        for precision, (px, depth) in (self._predictions or {}).items():
            figures = (f"{levels.rounded_up(bound, 2):.2g}" for bound in (px, depth))
            line = with_comma(WORDS.say("bound", precision, *figures))
            if not math.isfinite(px + depth):
                line = WORDS.say("no-bound", precision)
            each_use = (WORDS.say("drawn"), self._drawn), (WORDS.say("read"), read)
            uses = [use for use, chosen in each_use if chosen == precision]
            menu.addAction(f"{line}  ({', '.join(uses)})" if uses else line).setEnabled(False)
        menu.addSeparator()
        limit = with_comma(f"{self.frame_ms:g}")
        text = WORDS.say("limit", limit) if self.frame_ms else WORDS.say("no-limit")
        frame = "frame", self.frame_ms, 0.0, LARGEST_FRAME_MS, "ms"
        menu.addAction(text).triggered.connect(lambda: self._ask(self.frame_edited, frame))
        text = with_comma(WORDS.say("px", f"{self.tolerance_px:g}"))
        span = levels.LEAST_TOLERANCE_PX, levels.LARGEST_TOLERANCE_PX
        tolerance = "tolerance", self.tolerance_px, *span, "px"
        menu.addAction(text).triggered.connect(lambda: self._ask(self.tolerance_edited, tolerance))

    def _ask(self, edited: SignalInstance, of: tuple[str, float, float, float, str]) -> None:
        """Ask for a number in a `NumberDialog`, by its key in the wording."""
        key, value, low, high, unit = of
        name, asked = WORDS[key]
        dialog = NumberDialog(name, asked, value, low, high, unit, self)
        if dialog.exec():
            edited.emit(dialog.number)


def _error_text(px: float) -> str:
    return f"{levels.rounded_up(px, 1):.1g}" if math.isfinite(px) else "∞"


class _Elided(WarningLabel):
    """Shows the worst sentence, elided if necessary; its tooltip has all of them."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setWordWrap(False)
        self.set_is_warning(name == "health")
        # A long sentence must not resize the panes.
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        self._sentence = ""

    def show_text(self, text: str, tip: str) -> None:
        """Show one line, and its full text as the tooltip."""
        self._sentence = text
        set_tip(self, tip)
        self.setAccessibleDescription(tip.replace("\n", " "))
        self._elide()

    def show_sentences(self, sentences: list[str]) -> None:
        """Show the first sentence, or nothing if there is none."""
        first = sentences[0] if sentences else ""
        if sentences[1:]:
            first = self.tr("{0} And {1} more.").format(first, len(sentences) - 1)
        self.show_text(first, "\n".join(sentences))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._elide()

    def _elide(self) -> None:
        text = self.fontMetrics().elidedText(
            self._sentence, Qt.TextElideMode.ElideRight, self.width() - 4 - max(0, self.indent())
        )
        if text != self.text():
            self.setText(text)
