"""The place of the panes in the window: for a class a slide, over which a question may lie."""

import math
from collections.abc import Iterator
from functools import partial

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, Qt, QTimer, Signal
from PySide6.QtGui import QResizeEvent, QTransform
from PySide6.QtWidgets import QBoxLayout, QWidget

from app.document.view import PANES
from app.drawings.label_placement import Floats, Ground, overlap
from widgets.panels.kinds_panel import KindsPanel
from widgets.panes.pane import Pane, named_on
from widgets.panes.stage_strip import StageStrip
from widgets.parts.labels import Title
from widgets.parts.layouts import in_row
from widgets.window.equation import EquationSlide
from widgets.window.pen import Pen
from widgets.window.question import HiddenInk, QuestionOverlay
from widgets.window.slots import Slots

EQUATION_SHARE = 0.7  # width of an equation that has a picture beside it
FRAME_PX = 8.0  # from a picture's frame to what may lie beside it
FRAME_INK = 3.0  # how much more than other ink a side of the frame counts
BRACKET_INK = 1e3  # pixels of ink for which a bracket counts
EQUATION_HEIGHT = 0.45
"""Height of an equation that is too wide for that, above the picture that a step asks for."""


class Slide(QWidget):
    """Holds the panes, and lays the question over a part of them."""

    touched = Signal()  # a finger has touched the screen

    def __init__(self, slots: Slots) -> None:
        super().__init__()
        self.setAttribute(Qt.WidgetAttribute.WA_AcceptTouchEvents)
        self._slots = slots
        self.equation = EquationSlide()
        self.question = QuestionOverlay(self, self.named)
        self.pen = Pen(self)
        self.pen.hide()
        self._row = in_row(self.equation, slots, on=self, margins=(0, 0, 0, 0), gap=0)
        slots.rearranged.connect(self.arrange)
        self.equation.filled.connect(self.arrange)

    def arrange(self) -> None:
        """Give the equation its place beside the picture, or above it, or all of the slide."""
        slots, equation = self._slots, self.equation
        has_equation = slots.shows("equation")
        equation.set_is_slide(has_equation)
        equation.setVisible(has_equation)
        is_wide = has_equation and equation.needs_all(EQUATION_SHARE * self.width())
        has_panes = not is_wide or any(name in PANES for name in slots.given)
        slots.setVisible(has_panes and not slots.shows("kinds"))
        direction = QBoxLayout.Direction
        self._row.setDirection(direction.TopToBottom if is_wide else direction.LeftToRight)
        share = EQUATION_HEIGHT if is_wide else EQUATION_SHARE
        self._row.setStretch(0, round(100 * share) if has_equation else 0)
        self._row.setStretch(1, round(100 * (1.0 - share)) if has_equation else 1)

    def named(self) -> Iterator[tuple[list[QRectF], HiddenInk]]:
        """Yield names, points, cells and titles, which nothing should hide, and how boxes do it."""
        for pane in self.findChildren(Pane):  # also those that are compared
            drawing, (boxes, from_pixels) = pane.drawing, named_on(self, pane)
            if drawing is None or not pane.canvas.isVisible():
                continue
            to_pixels, _ = from_pixels.inverted()
            size = drawing.state.size_px if drawing.pane == "image" else (0, 0)
            yield boxes, partial(_hidden_ink, drawing.layers.ground(), to_pixels, size)
        titles: list[QWidget] = [each for each in self.findChildren(Title) if each.text()]
        titles += [node for each in self.findChildren(KindsPanel) for node in each.nodes.values()]
        beside = [each for each in (*titles, *self.findChildren(StageStrip)) if each.isVisible()]
        others = [QRectF(each.rect()).translated(each.mapTo(self, QPointF())) for each in beside]
        at = self.equation.mapTo(self, QPointF())
        has_equation = self.equation.isVisible()
        others += [cell.translated(at) for cell in self.equation.cells if has_equation]
        brackets = [each.translated(at) for each in self.equation.brackets if has_equation]
        ink = np.array([each.getCoords() for each in brackets]).reshape(-1, 4)
        yield others, lambda boxes: BRACKET_INK * overlap(boxes, ink).sum(axis=1, dtype=np.float64)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        QTimer.singleShot(0, self.question, self.question.settle)  # the panes have their sizes
        self.pen.resize(event.size())
        if self._slots.shows("equation"):
            self.arrange()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.TouchBegin:
            self.touched.emit()  # not accepted: the touch is a click of the pane, too
        return super().event(event)


def _hidden_ink(
    ground: Ground, to_pixels: QTransform, size_px: tuple[int, int], boxes: Floats
) -> Floats:
    """How much ink boxes hide in a pane, with the frame of a picture of this size."""
    scale = np.array([to_pixels.m11(), to_pixels.m22()])
    left, top, right, bottom = (boxes * np.tile(scale, 2) + [to_pixels.dx(), to_pixels.dy()] * 2).T
    seen = np.stack([left, bottom, right, top], axis=1)
    hidden = ground.inked_px(seen)
    for grown in (FRAME_PX, -FRAME_PX) if any(size_px) else ():
        inside = np.clip(seen, -grown, np.add(size_px, grown).tolist() * 2)
        hidden += math.copysign(FRAME_INK, grown) * (inside[:, 2:] - inside[:, :2]).prod(axis=1)
    return np.asarray(hidden / abs(scale.prod()))
