"""The strip below a slide: the few controls that a class sees being changed.

The rows are those of the dock, which lends them while the strip is shown.
"""

from collections.abc import Collection

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtWidgets import QFrame, QSizePolicy, QWidget

from app.document.view import MOST_ON_SLIDE, STRIP
from app.model.parameters import FOV_Y, NEAR
from widgets.controls.controls import Controls
from widgets.panes.stage_strip import StageStrip
from widgets.parts.fields import Row
from widgets.parts.layouts import FittedWidget, in_row
from widgets.parts.panel import Changed, ShownData

GAP_PX = 48
ROW_SHARE = 0.42  # width of a row, in widths of the strip
USUAL = (FOV_Y.path, NEAR.path)  # the controls of a scene that has none of its own


class ControlStrip(FittedWidget, QFrame):
    """The controls of a slide; hidden unless a step names them, or the speaker asks for them."""

    concerns = frozenset({"scene", "view"})
    grips_wanted = Signal(object)
    """The values that have grips at rest: those that the slide names; None for the scene's own."""

    def __init__(self, controls: Controls, stages: StageStrip) -> None:
        super().__init__()
        self.setObjectName("controlStrip")
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Maximum)
        self._controls, self._stages = controls, stages
        self._named: tuple[str, ...] = ()
        self._of_scene: Collection[str] = USUAL
        self._wanted: bool | None = None  # whether the speaker wants the strip; None: as the step
        self._is_for_class = self._is_old = False
        self.rows: list[Row] = []
        self._row = in_row(on=self, margins=(24, 2, 24, 4), gap=GAP_PX)
        self.hide()

    def take(self, shown: ShownData, changed: Changed) -> None:
        """Offer the first controls of another scene."""
        phenomenon = shown.scene.phenomenon
        self._of_scene = USUAL
        if phenomenon is not None:
            own = (*(each.path for each in phenomenon.settings), *phenomenon.controls)
            self._of_scene = (own or USUAL)[:MOST_ON_SLIDE]
        self._is_old = True
        if "view" not in changed:  # otherwise `show_controls` follows
            self._fill()

    def show_controls(self, paths: tuple[str, ...]) -> None:
        if paths != self._named:
            self._named, self._wanted = paths, None
            self._is_old = True
        if self._is_old:
            self._fill()

    def set_presenting(self, on: bool) -> None:
        self._is_for_class, self._wanted = on, None
        self._fill()

    def toggle(self) -> None:
        """Show the strip, or hide it; a step without controls gets those of its scene."""
        if self._is_for_class:
            self._wanted = self.isHidden()
            self._fill()

    def show_now(self) -> None:
        if self.isHidden():
            self.toggle()

    @property
    def paths(self) -> tuple[str, ...]:
        """The values whose controls are shown."""
        if not self._is_for_class:
            return ()
        asked = tuple(path for path in self._named if path != STRIP)
        wanted = bool(asked) if self._wanted is None else self._wanted
        return (asked or tuple(self._of_scene)) if wanted else ()

    def _fill(self) -> None:
        self._is_old = False
        self.grips_wanted.emit(self._named if self._is_for_class else None)
        self._stages.setVisible(not self._is_for_class or STRIP in self._named)
        self._controls.take_back()
        self.rows = self._controls.lend(self.paths) if self.paths else []
        for row in self.rows:
            self._row.addWidget(row, 1)
            # The layout would show it after the first picture, which would be drawn again.
            is_left_out = row.testAttribute(Qt.WidgetAttribute.WA_WState_ExplicitShowHide)
            row.setHidden(row.isHidden() and is_left_out)
            for part in (row, *row.findChildren(QWidget)):
                part.installEventFilter(self)
        self._fit()
        self.setVisible(bool(self.rows))

    def _fit(self) -> None:
        """Leave the sides free beside a single row."""
        wanted = ROW_SHARE * self.width() * max(1, len(self.rows))
        side = max(24, round((self.width() - wanted) / 2.0))
        self._row.setContentsMargins(side, 2, side, 4)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Show a class no tooltips."""
        if event.type() == QEvent.Type.ToolTip and self._is_for_class:
            return True
        return super().eventFilter(watched, event)
